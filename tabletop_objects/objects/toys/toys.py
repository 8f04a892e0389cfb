"""Objects of the ``toys`` theme: various toys."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import PAINTS, dye, metal, plastic, shine, steel, wood
from ...kit.outlines import ellipse, rectangle, smooth
from ...kit.parts import box_part, cylinder_part, flat_foot, hull_of, resting_ball, ring_parts
from ...kit.primitives import (
    at_block,
    at_box,
    ball,
    disc,
    drum,
    hull_solid,
    lies,
    limb,
    press_flat,
    rod,
    standing,
    straight,
)
from ...kit.prints import word_plate
from ...kit.shapes import Pieces, Shape, at_rest, category, from_pieces, put_down, shape, vary
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...kit.surfaces import RGB, Look, Tile, plain, readable_on, tint_color
from ..sports.balls import football_skin, seam
from .vehicles import _paper, sheet

BLACK = surfaces.plain((34, 34, 37))
WHITE = surfaces.plain((244, 242, 238))


@category("fidget_cube", size=(0.0355, 0.037, 0.036), mass=0.04, material="plastic",
          aliases=("fidget toy", "stress cube", "fidget die"), themes=("toys",),
          colors=("black",))  # fmt: skip
@from_pieces()
def fidget_cube(look: Look) -> Pieces:
    """A cube with buttons, a switch, gears and a ball on its faces."""
    s = 0.033
    cube = at_block(s, s, s, 0.005)
    dots = [
        disc(0.004, 0.003, (x, y, s - 0.0005))
        for x, y in ((-0.009, -0.009), (0.009, -0.009), (0, 0), (-0.009, 0.009), (0.009, 0.009))
    ]
    front = [disc(0.009, 0.005).turn(0, np.pi / 2).move(0, -s / 2 + 0.0005, s / 2)]
    side = [at_block(0.005, 0.014, 0.007, 0.002, (s / 2, 0, s / 2 - 0.003))]
    return [(cube, plastic(look, "black", "white", "gray", "blue")),
            (join(dots), dye(look, "green", "red", "blue", "orange")),
            (front[0], dye(look, "black", "green", "gray")),
            (side[0], dye(look, "red", "green", "black"))]  # fmt: skip


@category("pop_it", size=(0.128, 0.128, 0.011), mass=0.06, material="plastic",
          aliases=("popit", "pop it toy", "pop-it", "bubble popper", "push pop toy"),
          themes=("toys",), roles=("flat",), colors=("red", "blue"))  # fmt: skip
@vary()
@from_pieces(bodies=(0, 2, 4, 6, 8, 10))
def pop_it(look: Look) -> Pieces:
    """A pop-it toy: a silicone mat with rows of bubbles in rainbow colours."""
    rows = ("red", "orange", "yellow", "green", "blue", "purple")
    base = [at_block(0.128, 0.0214, 0.005, 0.004, (0, 0.0535 - 0.0214 * k, 0)) for k in range(6)]
    pieces: Pieces = []
    asked = "color" in look.attributes
    for k, name in enumerate(rows):
        color = look.color(name) if asked else look.own_color(name)
        tile = surfaces.plain(color)
        pops = [ball(0.0165, 0.0165, 0.014, (-0.0525 + 0.021 * n, 0.0535 - 0.0214 * k, 0.004), 8)
                for n in range(6)]  # fmt: skip
        pieces += [(base[k], tile), (join(pops), surfaces.plain(tint_color(color, 1.12)))]
    return pieces


@category("magic_8_ball", size=(0.1, 0.1, 0.1), mass=0.35, material="plastic", hollow=True,
          aliases=("magic eight ball", "8 ball", "fortune ball"), themes=("toys",),
          roles=("round",), colors=("black",))  # fmt: skip
@vary()
@from_pieces(foot=0.06, bodies=1)
def magic_8_ball(look: Look) -> Pieces:
    """A black ball with an 8 in a white disc, standing on its flat window."""
    body = ball(0.1, 0.1, 0.1, (0, 0, 0.047), 32)
    badge = ball(0.046, 0.046, 0.012, (0, 0, 0.0926), 20).turn(0, -0.0)
    image = prints.canvas(64, 64, (246, 246, 244))
    prints.write(image, "8", 0.5, 0.5, 0.7, (20, 20, 22), True)
    top = disc(0.02, 0.0012, (0, 0, 0.0977))
    pieces = [(body, surfaces.speckles(look.rng, look.color("black", spread=4), 3)), (badge, WHITE),
              (top, image)]  # fmt: skip
    return [(s.move(z=-0.047).turn(0, 0.55).move(z=0.047), t) for s, t in pieces]


@category("etch_a_sketch", size=(0.24, 0.2, 0.041), mass=0.5, material="plastic",
          aliases=("drawing toy", "etch sketch", "magnetic drawing board", "sketch toy",
          "magna doodle"), themes=("toys",), roles=("flat", "big"),
          colors=("red", "blue"))  # fmt: skip
@from_pieces(bodies=2)
def etch_a_sketch(look: Look) -> Pieces:
    """A drawing toy: a red frame with two white knobs and a line on a grey screen."""
    frame = plastic(look, "red", "red", "pink", "blue")
    body = at_block(0.24, 0.2, 0.03, 0.02)
    image = prints.canvas(128, 92, (196, 198, 194))
    x, y, way = 0.3, 0.7, [(0.3, 0.7)]
    for k in range(16):
        if k % 2:
            x = float(np.clip(x + look.between(-0.25, 0.3), 0.1, 0.9))
        else:
            y = float(np.clip(y + look.between(-0.3, 0.25), 0.1, 0.9))
        way.append((x, y))
    prints.stroke(image, way, 0.016, (60, 60, 62))
    knobs = [disc(0.018, 0.012, (s * 0.092, -0.078, 0.029)) for s in (-1, 1)]
    name = at_box(0.1, 0.016, 0.0008, (0, -0.08, 0.0296))
    return [(body, frame), (join(knobs), WHITE), (at_box(0.19, 0.125, 0.0008, (0, 0.014, 0.0296)),
                                                  image),
            (name, word_plate("SKETCH", (214, 176, 70), (120, 30, 30), 0.6))]  # fmt: skip


@category("view_master", size=(0.128, 0.08, 0.12), mass=0.15, material="plastic",
          aliases=("viewmaster", "view finder toy"), themes=("toys",),
          colors=("red", "blue"))  # fmt: skip
@from_pieces(bodies=3)
def view_master(look: Look) -> Pieces:
    """A picture viewer with two eyepieces, a paper reel on top and a lever."""
    tile = plastic(look, "red", "red", "blue", "brown")
    body = at_block(0.12, 0.06, 0.085, 0.014)
    eyes = [disc(0.019, 0.02).turn(0, np.pi / 2).move(s * 0.032, -0.028, 0.045) for s in (-1, 1)]
    lens = [disc(0.013, 0.001).turn(0, np.pi / 2).move(s * 0.032, -0.0478, 0.045) for s in (-1, 1)]
    reel = disc(0.045, 0.0016).turn(0, np.pi / 2).move(0, 0.004, 0.075)
    holes = [at_box(0.008, 0.003, 0.007, (0.034 * np.cos(a), 0.003, 0.072 + 0.034 * np.sin(a)))
             for a in np.linspace(0.3, np.pi - 0.3, 6)]  # fmt: skip
    lever = at_block(0.012, 0.02, 0.03, 0.004, (0.066, 0, 0.045))
    return [(body, tile), (join(eyes), BLACK), (reel, WHITE), (lever, dye(look, "white", "black")),
            (join(lens), surfaces.plain((120, 150, 190))),
            (join(holes), surfaces.plain((80, 120, 190)))]  # fmt: skip


@category("jack_in_the_box", size=(0.112, 0.0992, 0.234), mass=0.4, material="plastic",
          aliases=("jack in box", "clown in a box", "jack in the box toy"), themes=("toys",),
          roles=("tall",), colors=("red", "blue"))  # fmt: skip
@from_pieces(bodies=6)
def jack_in_the_box(look: Look) -> Pieces:
    """An open painted box with a clown on a spring above it."""
    color = look.color("red", "blue", "yellow", "teal", "purple")
    side = surfaces.stripes([color, look.own_color("yellow", "white", "orange")], 3, upright=True)
    body = at_box(0.09, 0.09, 0.085)
    lid = at_box(0.09, 0.004, 0.09).turn(0, 0.35).move(0, 0.05, 0.084)
    t = np.linspace(0, 1, 90)
    a = 2 * np.pi * 6 * t
    spring = tube(
        np.column_stack([0.026 * np.cos(a), 0.026 * np.sin(a), 0.086 + 0.04 * t]), 0.0022, 6
    )
    frill = disc(0.036, 0.008, (0, 0, 0.122))
    head = ball(0.05, 0.05, 0.054, (0, 0, 0.152), 18)
    hat = disc(0.023, 0.05, (0, 0, 0.17), top=0.002)
    pom = ball(0.014, 0.014, 0.014, (0, 0, 0.221), 10)
    hair = [ball(0.026, 0.022, 0.026, (s * 0.026, 0.004, 0.158), 12) for s in (-1, 1)]
    eyes = [ball(0.007, 0.004, 0.009, (s * 0.01, -0.023, 0.158), 8) for s in (-1, 1)]
    nose = ball(0.013, 0.013, 0.013, (0, -0.027, 0.15), 12)
    crank = rod([(0.044, 0, 0.04), (0.06, 0, 0.04), (0.06, 0, 0.06)], 0.003, 8)
    return [(body, side), (lid, side), (spring, shine(look)), (frill, dye(look, "white", "yellow",
                                                                          "red")),
            (head, dye(look, "beige")), (hat, dye(look, "green", "purple", "blue")),
            (crank, shine(look)), (join(hair), dye(look, "orange", "red")),
            (join([nose, pom]), surfaces.plain((214, 40, 40))), (join(eyes), BLACK)]  # fmt: skip


@category("slinky", size=(0.133, 0.0632, 0.0769), mass=0.15, material="metal", assembled=True,
          aliases=("slinky toy", "spring toy", "rainbow spring"), themes=("toys",),
          colors=("silver",))  # fmt: skip
@from_pieces()
def slinky(look: Look) -> Pieces:
    """A coiled spring toy, bent over in an arch or standing in a stack."""
    color = look.color("silver", "silver", "red", "blue", "green", "purple")
    arch = look.chance(0.6)
    n = 32 if arch else 24
    pieces = []
    for k in range(n):
        t = (k + 0.5) / n
        ring = torus(0.03, 0.0016, 14, 4)
        if arch:
            a = np.pi * (1 - t)
            pieces.append(
                ring.turn(1, a + np.pi).move(0.055 * np.cos(a), 0, 0.004 + 0.06 * np.sin(a))
            )
        else:
            pieces.append(ring.move(0.0004 * np.sin(k), 0, 0.0014 + 0.0021 * k))
    low = min(float(p.bounds[0, 2]) for p in pieces)
    pieces = [p.move(z=-low) for p in pieces]
    third = n // 4
    groups = [pieces[k * third : (k + 1) * third if k < 3 else n] for k in range(4)]
    tone = look.surface(color, "metal")
    return [(join(g), tone) for g in groups]


PEZ_DISPENSER_BLACK = surfaces.plain((34, 34, 37))
TOY_KITCHEN_WHITE = surfaces.plain((244, 242, 238))


@category("pez_dispenser", size=(0.05, 0.034, 0.128), mass=0.03, material="plastic",
          themes=("toys",), roles=("tall",), colors=("red", "blue"))  # fmt: skip
@from_pieces(bodies=3)
def pez_dispenser(look: Look) -> Pieces:
    """A sweet dispenser: a coloured stem on a base and a round head with black ears and eyes."""
    color = look.color("red", "blue", "yellow", "green", "purple")
    stem = at_block(0.022, 0.013, 0.08, 0.003, (0, 0, 0.005))
    foot = at_block(0.03, 0.028, 0.006, 0.006)
    head = ball(0.032, 0.032, 0.034, (0, 0, 0.1), 18)
    ears = [ball(0.02, 0.008, 0.02, (s * 0.016, 0, 0.118), 12) for s in (-1, 1)]
    eyes = [ball(0.007, 0.004, 0.009, (s * 0.006, -0.0145, 0.104), 8) for s in (-1, 1)]
    nose = ball(0.008, 0.006, 0.006, (0, -0.016, 0.097), 8)
    return [(foot, surfaces.plain(color)), (stem, surfaces.plain(color)),
            (head, dye(look, "beige", "white", "yellow", "pink")),
            (join(ears), PEZ_DISPENSER_BLACK),
            (join([*eyes, nose]), PEZ_DISPENSER_BLACK)]  # fmt: skip


@category("toy_kitchen", size=(0.208, 0.112, 0.226), mass=0.6, material="plastic",
          aliases=("play kitchen", "mini kitchen", "dollhouse kitchen"), themes=("toys",),
          roles=("big",), colors=("pink", "white"))  # fmt: skip
@from_pieces(bodies=5)
def toy_kitchen(look: Look) -> Pieces:
    """A toy kitchen: an oven with a window, a hob, a sink and a back wall."""
    tile = plastic(look, "pink", "white", "red", "mint", "wooden")
    body = at_block(0.2, 0.1, 0.12, 0.005)
    top = at_block(0.208, 0.106, 0.008, 0.004, (0, 0, 0.12))
    back = at_box(0.2, 0.008, 0.1, (0, 0.047, 0.126))
    shelf = at_box(0.18, 0.03, 0.006, (0, 0.034, 0.185))
    plates = [
        disc(0.02, 0.002, (x, y, 0.1275))
        for x, y in ((-0.07, -0.02), (-0.025, -0.02), (-0.07, 0.024), (-0.025, 0.024))
    ]
    sink = at_block(0.06, 0.05, 0.002, 0.012, (0.055, -0.005, 0.1275))
    tap = rod([(0.055, 0.03, 0.126), (0.055, 0.03, 0.155), (0.055, 0.01, 0.155),
               (0.055, 0.005, 0.148)], 0.0035, 8)  # fmt: skip
    door = at_box(0.08, 0.004, 0.07, (-0.048, -0.051, 0.02))
    pane = at_box(0.055, 0.005, 0.035, (-0.048, -0.0515, 0.03))
    grip = straight((-0.08, -0.058, 0.08), (-0.015, -0.058, 0.08), 0.003, 8)
    knobs = [disc(0.006, 0.006).turn(0, np.pi / 2).move(-0.078 + 0.02 * k, -0.049, 0.106)
             for k in range(4)]  # fmt: skip
    door2 = at_box(0.07, 0.004, 0.09, (0.05, -0.051, 0.012))
    return [(body, tile), (top, TOY_KITCHEN_WHITE), (back, tile), (shelf, TOY_KITCHEN_WHITE),
            (join([door, door2]), TOY_KITCHEN_WHITE), (join(plates), PEZ_DISPENSER_BLACK),
            (sink, shine(look)), (tap, shine(look)), (pane, surfaces.plain((60, 66, 80))),
            (grip, shine(look)), (join(knobs), PEZ_DISPENSER_BLACK)]  # fmt: skip


@category("toy_phone", size=(0.142, 0.115, 0.127), mass=0.25, material="plastic",
          aliases=("toy telephone", "play phone", "chatter telephone"), themes=("toys",),
          colors=("white",))  # fmt: skip
@from_pieces(bodies=4)
def toy_phone(look: Look) -> Pieces:
    """A toddler's telephone with a face, a dial, wheels and a receiver on a cord."""
    body = hull_solid([(x, y, z) for x in (-0.05, 0.05) for y, z in ((-0.05, 0.012), (-0.05, 0.03),
                                                                     (0.04, 0.085), (0.055, 0.07),
                                                                     (0.055, 0.012))])  # fmt: skip
    wheels = [
        disc(0.018, 0.01).turn(0, np.pi / 2).turn(2, np.pi / 2).move(s * 0.052 + 0.005, y, 0.018)
        for s in (-1, 1)
        for y in (-0.035, 0.035)
    ]
    dial = disc(0.032, 0.004).turn(0, 0.55).move(0, -0.012, 0.054)
    holes = [disc(0.005, 0.001, (0.022 * np.cos(a), 0.022 * np.sin(a),
                                 0.0036)).turn(0, 0.55).move(0, -0.012, 0.054) for a in np.arange(9)
             * 0.6]  # fmt: skip
    grip = [rod([(-0.055, 0.045, 0.1), (-0.03, 0.045, 0.116), (0.03, 0.045, 0.116),
                 (0.055, 0.045, 0.1)], 0.01, 10), ball(0.032, 0.032, 0.024, (-0.055, 0.045, 0.095),
                                                       12),
            ball(0.032, 0.032, 0.024, (0.055, 0.045, 0.095), 12)]  # fmt: skip
    return [(body, plastic(look, "white", "yellow", "sky", "pink")),
            (join(wheels[:2]), dye(look, "red", "blue")),
            (join(wheels[2:]), dye(look, "red", "blue")), (join(grip), dye(look, "red", "orange")),
            (dial, dye(look, "yellow", "teal")),
            (join(holes), dye(look, "red", "navy"))]  # fmt: skip


FIDGET_SPINNER_BLACK = surfaces.plain((34, 34, 37))


@category("fidget_spinner", size=(0.078, 0.068, 0.0125), mass=0.05, material="plastic",
          aliases=("hand spinner",), themes=("toys",), roles=("flat",),
          colors=("red", "blue"))  # fmt: skip
@from_pieces(bodies=1)
def fidget_spinner(look: Look) -> Pieces:
    """A fidget spinner: three round lobes with rings around a hub."""
    tile = plastic(look, *PAINTS, "black", "silver")
    lobes = [disc(0.0165, 0.009, (0.026 * np.cos(a), 0.026 * np.sin(a), 0)) for a in np.pi / 2
             + np.arange(3) * 2.0944]  # fmt: skip
    core = disc(0.019, 0.009)
    webs = [at_block(0.03, 0.016, 0.009, 0.004, (0.013, 0, 0)).turn(2, a) for a in np.pi / 2
            + np.arange(3) * 2.0944]  # fmt: skip
    rings = [torus(0.0105, 0.0018, 22, 6).move(0.026 * np.cos(a), 0.026 * np.sin(a), 0.009)
             for a in np.pi / 2 + np.arange(3) * 2.0944]  # fmt: skip
    wells = [disc(0.009, 0.0006, (0.026 * np.cos(a), 0.026 * np.sin(a), 0.0088)) for a in np.pi / 2
             + np.arange(3) * 2.0944]  # fmt: skip
    hub = disc(0.0115, 0.004, (0, 0, 0.0085))
    return [(join([*lobes, core, *webs]), tile), (join(rings), shine(look)), (hub, shine(look)),
            (join(wells), FIDGET_SPINNER_BLACK)]  # fmt: skip


HOBBY_HORSE_BLACK = surfaces.plain((34, 34, 37))


@category("gyroscope", size=(0.076, 0.076, 0.112), mass=0.12, material="metal", assembled=True,
          aliases=("gyro", "toy gyroscope"), themes=("toys",), colors=("silver",))  # fmt: skip
@from_pieces()
def gyroscope(look: Look) -> Pieces:
    """A gyroscope on its stand: a heavy disc in crossed rings."""
    brass, steel = metal(look, "silver", "brass", "gold"), shine(look, "silver", "brass")
    foot = standing(
        (0.026, 0), (0.022, 0.006), (0.006, 0.012), (0.005, 0.03), (0.009, 0.034), sides=20
    )
    z = 0.072
    rings = [torus(0.034, 0.0022, 34, 6).move(z=z),
             torus(0.036, 0.0022, 34, 6).turn(0, np.pi / 2).move(z=z)]  # fmt: skip
    wheel = lathe([(0.016, 0), (0.027, 0), (0.027, 0.01), (0.016, 0.01)], 30, loop=True).move(
        z=z - 0.005
    )
    web = disc(0.018, 0.003, (0, 0, z - 0.0015))
    axle = straight((0, 0, 0.034), (0, 0, 0.112), 0.0028, 10)
    return [(foot, steel), (rings[0], steel), (rings[1], steel), (join([wheel, web]), brass),
            (axle, steel)]  # fmt: skip


@category("jacks", size=(0.0898, 0.0763, 0.0232), mass=0.06, material="plastic", assembled=True,
          aliases=("jacks set", "set of jacks", "jacks game", "knucklebones", "jackstones"),
          themes=("toys",), colors=("red", "blue"))  # fmt: skip
@from_pieces()
def jacks(look: Look) -> Pieces:
    """Five six-pointed metal jacks and a rubber ball."""
    pieces: Pieces = [(ball(0.024, 0.024, 0.024, (0.0, 0.0, 0.0114), 18),
                       plastic(look, "red", "blue", "pink", "green"))]  # fmt: skip
    for k in range(5):
        a = 1.2566 * k + 0.4
        x, y, z = 0.038 * np.cos(a), 0.032 * np.sin(a), 0.0095
        arms = [straight(tuple(-0.009 * d), tuple(0.009 * d), 0.0014, 6) for d in np.eye(3)]
        tips = [ball(0.0042, 0.0042, 0.0042, tuple(s * 0.009 * d), 8) for d in np.eye(3)
                for s in (-1, 1)]  # fmt: skip
        one = join([*arms, *tips]).turn(0, 0.7).turn(1, 0.6)
        pieces.append((one.move(x, y, z - 0.0004), shine(look, "silver", "gold")))
    return pieces


@category("hobby_horse", size=(0.37, 0.18, 0.1), mass=0.4, material="fabric", assembled=True,
          aliases=("hobby horse head", "stick horse", "horse on a stick"), themes=("toys",),
          roles=("big",), colors=("brown",))  # fmt: skip
@at_rest
@from_pieces(foot=0.1)
def hobby_horse(look: Look) -> Pieces:
    """A stuffed horse's head on a short stick, lying flat."""
    coat = surfaces.fabric(look.rng, look.color("brown", "tan", "gray", "white"))
    neck = rod([(-0.06, 0, 0.05), (0.02, 0.0, 0.055), (0.08, 0.02, 0.055)], [0.05, 0.042, 0.04], 14)
    head = rod(
        [(0.08, 0.02, 0.055), (0.1, -0.04, 0.05), (0.1, -0.1, 0.045)], [0.045, 0.038, 0.028], 14
    )
    ears = [rod([(0.105, 0.045, 0.055 + s * 0.02), (0.14, 0.065, 0.06 + s * 0.026)], [0.014, 0.003],
                8) for s in (-1, 1)]  # fmt: skip
    mane = [
        ball(0.04, 0.03, 0.035, (-0.05 + 0.035 * k, 0.045 + 0.006 * k, 0.065), 10) for k in range(5)
    ]
    stick = straight((-0.22, 0, 0.04), (-0.05, 0, 0.05), 0.012, 12)
    eye = ball(0.014, 0.014, 0.008, (0.105, -0.01, 0.09), 10)
    return [(neck, coat), (head, coat), (stick, wood(look, "wooden")), (join(ears), coat),
            (join(mane), dye(look, "black", "brown", "cream")),
            (eye, HOBBY_HORSE_BLACK)]  # fmt: skip


@category("pinata", size=(0.262, 0.066, 0.274), mass=0.3, material="paper", hollow=True,
          aliases=("donkey pinata", "party pinata"), themes=("toys",), roles=("tall", "big"),
          colors=("pink",))  # fmt: skip
def pinata(look: Look) -> Shape:
    """A piñata: a paper donkey with fringed stripes in bright colours."""
    k, color = look.between(0.85, 1.05), look.color("pink", "yellow", "turquoise", "orange")
    bodies = [prism(rectangle(0.16, 0.07, 0.02), 0, 0.08).move(0, 0, 0.075),
              prism(rectangle(0.05, 0.05, 0.014), 0, 0.08).turn(1, -0.35).move(-0.07, 0, 0.13),
              prism(rectangle(0.085, 0.045, 0.014), 0, 0.045).turn(1, 0.25).move(-0.12, 0,
                  0.2)]  # fmt: skip
    bodies += [prism(rectangle(0.034, 0.028, 0.006), 0, 0.085).move(x, y, 0)
               for x in (-0.055, 0.055) for y in (-0.02, 0.02)]  # fmt: skip
    ears = [prism(rectangle(0.012, 0.018, 0.004), 0,
                  0.05).turn(0, -0.2 * s).move(-0.09, 0.014 * s, 0.24)
            for s in (-1, 1)]  # fmt: skip
    tail = limb([(0.08, 0, 0.14), (0.1, 0, 0.12), (0.105, 0, 0.08)], [0.006, 0.008, 0.012], 8)
    hues = [color, (250, 206, 60), (72, 184, 184), (236, 84, 140), (90, 170, 80), (238, 132, 38)]
    fringe = surfaces.stripes(hues, 1, side=96)
    noisy = surfaces.noise(look.rng, 96, 96, (8, 30), 2)[..., None] * 26
    tile = np.clip(fringe + noisy, 0, 255).astype(np.uint8)
    made = [(join(bodies), tile), (join([*ears, tail]), surfaces.plain(color)),
            (join([ellipsoid(0.01, 0.006, 0.012, 8, 6).move(-0.135, s * 0.024, 0.22)
                   for s in (-1, 1)]), surfaces.plain((24, 24, 28)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made,
        [
            hull_of(*[b.scale(k, k, k) for b in bodies[:1]]),
            hull_of(*[b.scale(k, k, k) for b in bodies[1:3]]),
            *[hull_of(b.scale(k, k, k)) for b in bodies[3:]],
        ],
    )


@category("die", size=(0.021, 0.021, 0.021), mass=0.012, material="plastic",
          aliases=("dice", "gaming die"), themes=("toys", "games"), colors=("white", "red"),
          common=True)  # fmt: skip
def die(look: Look) -> Shape:
    """One large die; its visible faces show different numbers."""
    side = look.between(0.018, 0.024)
    ground = look.color("white", "red", "blue", "black", "green")
    ink: RGB = (30, 30, 32) if sum(ground) > 420 else (244, 244, 240)
    cube = box(side, side, side)
    pieces = []
    for k, count in enumerate((1, 6, 2, 5, 3, 4)):
        face = Solid(cube.vertices[4 * k : 4 * k + 4], np.array([[0, 1, 2], [0, 2, 3]]),
                     cube.uv[4 * k : 4 * k + 4])  # fmt: skip
        pieces.append((face, prints.pips(count, ground, ink)))
    return shape(pieces, [box_part(side, side, side)])


@category("ball", size=(0.09, 0.09, 0.088), mass=0.09, material="rubber", hollow=True, friction=0.8,
          aliases=("toy ball", "rubber ball", "bouncy ball", "sphero ball", "eight ball",
          "bath toy ball", "bowls jack", "petanque jack", "boilie"),
          themes=("toys", "sports", "pets"), roles=("round",), colors=("red", "blue"),
          common=True)  # fmt: skip
def ball_(look: Look) -> Shape:
    """A tennis ball, baseball, play ball, basketball or football."""
    kind = int(look.rng.integers(5))
    seams: list[Solid] = []
    ink = (240, 240, 236)
    if kind == 0:
        d, color = look.between(0.064, 0.068), look.color("lime", "lime", "yellow")
        cover = surfaces.scratches(look.rng, color, tint_color(color, 1.3), 220)
        seams = [seam(0.495 * d, 0.75)]
    elif kind == 1:
        d, color = look.between(0.072, 0.076), look.color("white", "cream", "ivory")
        cover, ink = surfaces.speckles(look.rng, color, 6), (190, 40, 44)
        seams = [seam(0.495 * d, 0.75)]
    elif kind == 2:
        d, color = look.between(0.09, 0.14), look.color("orange", "copper", "terracotta")
        cover, ink = surfaces.spots(look.rng, color, tint_color(color, 0.7), 0.2), (40, 34, 32)
        circle = np.column_stack([0.496 * d * ellipse(2, 2, 40), np.zeros(40)])
        ring = tube(circle, 0.014 * d, 5, loop=True)
        seams = [ring, ring.turn(0, np.pi / 2), ring.turn(1, np.pi / 2), seam(0.496 * d, 0.6)]
    elif kind == 3:
        d, color = look.between(0.08, 0.14), look.color("white", "white", "yellow", "sky")
        cover = football_skin(color)
    else:
        d, color = look.between(0.06, 0.12), look.color("red", "blue", "green", "purple", "pink")
        other = look.own_color("white", "yellow", "cyan", "orange")
        cover = surfaces.stripes([color, other], int(look.pick([2, 3, 5])), upright=True)
    core = ellipsoid(d, d, d, 26, 16)
    pieces: list[tuple[Solid, Tile]] = [(press_flat(core, 0.488 * d), cover)]
    if seams:
        pieces.append((press_flat(join(seams), 0.488 * d), surfaces.plain(ink)))
    return shape(pieces, [resting_ball(d, d, 0.985 * d)])


BRIGHT = ("red", "blue", "yellow", "green", "orange", "purple", "pink", "teal")


@category("spinning_top", size=(0.0472, 0.0584, 0.0487), mass=0.03, material="wood", assembled=True,
          aliases=("top spinner", "toy top", "whipping top", "humming top", "tippe top",
          "anti-gravity spinner", "thaumatrope", "wooden spinning disc", "rattleback"),
          themes=("toys",), colors=("red",))  # fmt: skip
def spinning_top(look: Look) -> Shape:
    """A spinning top at rest, tilted onto its point and rim."""
    k = look.between(0.9, 1.15)
    color = look.color(*BRIGHT)
    bands = [color, look.own_color("cream", "white", "yellow"), tint_color(color, 0.6)]
    body = lathe(
        np.array([(0, 0), (0.002, 0.001), (0.008, 0.01), (0.026, 0.022), (0.028, 0.027),
                  (0.024, 0.031), (0.006, 0.036), (0.0035, 0.04), (0.003, 0.058), (0, 0.06)]) * k,
        30)  # fmt: skip
    lean = np.arctan2(0.022, 0.026)
    body = body.turn(1, lean)
    body = body.move(z=-float(body.bounds[0, 2]))
    return shape([(body, surfaces.stripes(bands, 2))], [flat_foot(body.vertices, 0.1)])


@category("yo_yo", size=(0.093, 0.057, 0.0405), mass=0.055, material="plastic", assembled=True,
          aliases=("yoyo", "yo-yo"), themes=("toys",), colors=("red", "blue"))  # fmt: skip
def yo_yo(look: Look) -> Shape:
    """A yo-yo lying on one half, with the string beside it."""
    k = look.between(0.92, 1.08)
    color = look.color(*BRIGHT)
    half = np.array([(0, 0), (0.018, 0), (0.026, 0.003), (0.0285, 0.009), (0.027, 0.015),
                     (0.008, 0.018)])  # fmt: skip
    upper = half[::-1] * [1, -1] + [0, 0.04]
    body = lathe(np.concatenate([half, upper]) * k, 32)
    badge = cylinder(0.014 * k, 0.0006, 24).move(z=0.0398 * k)
    a = np.linspace(0, 2.6 * np.pi, 40)
    way = np.column_stack([0.009 * np.cos(a[:12]), 0.009 * np.sin(a[:12]), 0.02 + 0 * a[:12]])
    tail = smooth([(0.009, 0.01, 0.02), (0.03, 0.02, 0.012), (0.04, 0.005, 0.0012),
                   (0.05, -0.015, 0.0012), (0.065, 0.0, 0.0012)], 5)  # fmt: skip
    string = [tube(p * k, 0.0009, 5) for p in (way, tail)]
    return shape(
        [(body, look.surface(color, look.pick(["plastic", "wood"]))),
         (badge, surfaces.plain(look.own_color("white", "yellow", "black", "red"))),
         (join(string), surfaces.plain((238, 234, 224)))],
        [cylinder_part(0.0265 * k, 0.0395 * k)])  # fmt: skip


@category("kite", size=(0.15, 0.34, 0.003), mass=0.03, material="plastic", assembled=True,
          friction=0.6, aliases=("diamond kite", "toy kite"), themes=("toys",),
          roles=("flat", "big"), colors=("red", "yellow"), state="lying flat")  # fmt: skip
def kite(look: Look) -> Shape:
    """A small diamond-shaped kite lying flat, with bows on its tail."""
    k = look.between(0.9, 1.1)
    color = look.color(*BRIGHT)
    others = [look.own_color(*BRIGHT) for _ in range(3)]
    image = prints.canvas(128, 128, color)
    prints.polygon(image, [(0.5, 0), (1, 0.36), (0.5, 0.36)], others[0])
    prints.polygon(image, [(0, 0.36), (0.5, 0.36), (0.5, 1)], others[0])
    prints.polygon(image, [(0.5, 0.36), (1, 0.36), (0.5, 1)], others[1])
    prints.fill(image, 0.485, 0, 0.03, 1, (110, 80, 50))
    prints.fill(image, 0, 0.35, 1, 0.02, (110, 80, 50))
    sail = prism(np.array([(0, -0.11), (0.075, 0.035), (0, 0.11), (-0.075, 0.035)]) * k, 0, 0.003)
    t = np.linspace(0, 1, 22)
    way = np.column_stack([0.025 * np.sin(9 * t) * t, -0.108 - 0.12 * t, 0.0012 + 0
                           * t]) * [k, k, 1]  # fmt: skip
    pieces = [(sail, image), (tube(way, 0.0012, 5), surfaces.plain((240, 236, 226)))]
    for n in (7, 12, 17, 21):
        bow = np.array([(-0.011, -0.006), (0, -0.001), (0.011, -0.006), (0.011, 0.006), (0, 0.001),
                        (-0.011, 0.006)]) * k  # fmt: skip
        pieces.append((prism(bow, 0, 0.0028).move(*way[n][:2]), surfaces.plain(others[n % 3])))
    return shape(pieces, [hull_of(sail), box_part(0.03 * k, 0.13 * k, 0.0026, (0, -0.17 * k, 0))])


@category("frisbee", size=(0.235, 0.235, 0.0256), mass=0.12, material="plastic",
          aliases=("flying disc", "disc golf disc", "flying disk", "discus", "newton disc"),
          themes=("toys",), roles=("round", "flat", "big"), colors=("red", "blue"))  # fmt: skip
def frisbee(look: Look) -> Shape:
    """A flying disc lying with its rim down."""
    r, h = look.between(0.1, 0.135), look.between(0.022, 0.028)
    color = look.color(*BRIGHT, "white")
    body = lathe([(0, 0.7 * h), (0.9 * r, 0.7 * h), (0.97 * r, 0), (r, 0.002), (r, 0.45 * h),
                  (0.93 * r, 0.9 * h), (0.7 * r, h), (0, h)], 40)  # fmt: skip
    rings = [torus(f * r, 0.0009, 40, 5).move(z=h - 0.0004) for f in (0.5, 0.56, 0.62)]
    badge = cylinder(0.3 * r, 0.0012, 28).move(z=h - 0.0005)
    return shape(
        [(body, surfaces.speckles(look.rng, color, 3, 32)),
         (join(rings), surfaces.plain(tint_color(color, 0.8))),
         (badge, surfaces.plain(look.own_color("white", "black", "yellow")))],
        [*ring_parts([(0.99 * r, 0), (0.99 * r, 0.4 * h)], [(0.92 * r, 0.7 * h), (0.955 * r, 0)],
                     12), cylinder_part(0.93 * r, 0.3 * h, (0, 0, 0.7 * h))])  # fmt: skip


@category("bubbles_tub", size=(0.042, 0.042, 0.11), mass=0.09, material="plastic",
          aliases=("bubble bottle", "soap bubbles", "bubble wand", "bubble tub", "bubble solution",
          "bubble tube"), themes=("toys",), roles=("round", "tall"),
          colors=("blue", "pink"))  # fmt: skip
def bubbles_tub(look: Look) -> Shape:
    """A tub of soap bubbles with a coloured cap."""
    k = look.between(0.92, 1.1)
    color = look.color(*BRIGHT)
    body = lathe(np.array([(0, 0), (0.02, 0), (0.021, 0.002), (0.021, 0.078), (0.017, 0.084),
                           (0.017, 0.088), (0, 0.088)]) * k, 28, v=[0, 0, 0.02, 0.9, 0.95, 0.99,
                                                                    1])  # fmt: skip
    image = prints.canvas(192, 96, tint_color(color, 1.3))
    for _ in range(26):
        x, y, r = look.between(0, 1), look.between(0.1, 0.9), look.between(0.03, 0.11)
        prints.disc(image, x, y, r, (252, 252, 252), 0.8 * r)
    prints.write(image[:, 68:124], "BUBBLES", 0.5, 0.5, 0.3, tint_color(color, 0.5), bold=True)
    cap = cylinder(0.0195 * k, 0.022 * k, 24, bevel=0.001).move(z=0.088 * k)
    return shape([(body, image), (cap, surfaces.speckles(look.rng, color, 4, 32))],
                 [cylinder_part(0.021 * k, 0.08 * k), hull_of(cap)])  # fmt: skip


@category("boomerang", size=(0.265, 0.104, 0.007), mass=0.08, material="wood", assembled=True,
          aliases=("toy boomerang",), themes=("toys",), roles=("flat",), colors=("wooden",),
          state="lying flat")  # fmt: skip
def boomerang(look: Look) -> Shape:
    """A boomerang, lying flat."""
    k = look.between(0.92, 1.1)
    color = look.color("wooden", "red", "yellow", "wooden", "blue", "green")
    outer = smooth([(-0.13, -0.02), (-0.12, 0.005), (-0.03, 0.078), (0.03, 0.078), (0.12, 0.005),
                    (0.13, -0.02)], 5)  # fmt: skip
    inner = smooth([(0.105, -0.026), (0.02, 0.035), (-0.02, 0.035), (-0.105, -0.026)], 5)
    outline = np.concatenate([outer, inner])[::-1] * k
    body = prism(outline, 0, 0.007)
    image = surfaces.fit(look.surface(color, "wood"), 96, 96).copy()
    for x in (0.12, 0.2, 0.8, 0.88):
        prints.fill(image, x - 0.015, 0, 0.03, 1, look.own_color("white", "black", "red"))
    cuts = [(-0.14, -0.05), (-0.05, 0.05), (0.05, 0.14)]
    points = [outline[(outline[:, 0] >= a * k) & (outline[:, 0] <= b * k)] for a, b in cuts]
    parts = [hull_of(join([box(0.0002, 0.0002, 0.007).move(*(p * 0.99)) for p in side]))
             for side in points]  # fmt: skip
    return shape([(body, image)], parts)


SOFT = ("sky", "pink", "mint", "lavender", "yellow", "teal", "coral", "orange")


@category("play_dough", size=(0.066, 0.066, 0.072), mass=0.13, material="plastic",
          aliases=("play dough tub", "play-doh", "playdough", "tub of play dough", "modelling clay",
          "modeling clay", "plasticine", "play doh", "magnetic putty", "polymer clay block",
          "block of modelling clay", "lump of clay", "putty tub", "clay", "tub of play-doh",
          "tub of play doh", "play doh tub", "pot of play-doh"), themes=("toys",), roles=("round",),
          colors=("red", "blue"))  # fmt: skip
def play_dough(look: Look) -> Shape:
    """A tub of play dough with a lid in the colour of the dough."""
    r, h = look.between(0.03, 0.036), look.between(0.055, 0.068)
    color = look.color("red", "blue", "yellow", "green", "pink", "orange", "purple")
    image = prints.canvas(192, 64, look.pick([(250, 236, 120), (246, 246, 244), (120, 200, 236)]))
    for k in range(8):
        prints.disc(image, k / 8 + 0.03, 0.2 + 0.6 * (k % 2), 0.12, look.own_color(*SOFT))
    prints.fill(image, 0.32, 0.24, 0.36, 0.52, color)
    prints.write(image[:, 62:130], look.pick(["DOUGH", "PLAY", "FUN"]), 0.5, 0.5, 0.4,
                 readable_on(color), bold=True)  # fmt: skip
    tub = lathe([(0, 0), (0.94 * r, 0), (0.96 * r, h), (0, h)], 28, v=[0, 0, 1, 1])
    lid = cylinder(r, 0.014, 28, bevel=0.002).move(z=h - 0.004)
    button = cylinder(0.8 * r, 0.0015, 26).move(z=h + 0.0095)
    return shape(
        [
            (tub, image),
            (lid, surfaces.speckles(look.rng, color, 3)),
            (button, surfaces.plain(tint_color(color, 1.2))),
        ],
        [cylinder_part(0.95 * r, h), cylinder_part(r, 0.014, (0, 0, h - 0.004))],
    )


@category("toy_spade", size=(0.225, 0.065, 0.02), mass=0.06, material="plastic",
          aliases=("sand spade", "spade", "beach spade", "sand shovel", "toy shovel",
          "plastic shovel", "beach shovel"), themes=("toys",), colors=("red", "blue"),
          state="lying flat")  # fmt: skip
def toy_spade(look: Look) -> Shape:
    """A child's sand spade lying flat with its blade on the left."""
    color = look.color("red", "blue", "yellow", "green", "orange", "pink")
    outline = [(-0.125, 0), (-0.115, -0.024), (-0.04, -0.032), (-0.034, 0), (-0.04, 0.032),
               (-0.115, 0.024)]  # fmt: skip
    blade = prism(outline, 0, 0.004).turn(1, 0.06).move(z=0.0)
    blade = blade.move(z=-float(blade.bounds[0, 2]))
    shaft = rod([(-0.07, 0, 0.007), (-0.02, 0, 0.012), (0.04, 0, 0.0075), (0.09, 0, 0.0075)],
                0.0075, 10)  # fmt: skip
    grip = straight((0.092, -0.028, 0.0075), (0.092, 0.028, 0.0075), 0.0075, 10)
    paint = surfaces.speckles(look.rng, color, 4)
    pieces: Pieces = [(join([blade, shaft, grip]), paint)]
    return put_down(pieces, blade, shaft, grip, factor=look.between(0.85, 1.12))


@category("beach_ball", size=(0.19, 0.19, 0.19), mass=0.09, material="plastic", hollow=True,
          aliases=("inflatable ball", "inflatable beach ball", "water wings", "inflatable armband"),
          themes=("toys",), roles=("round", "big"), colors=("red", "blue"))  # fmt: skip
def beach_ball(look: Look) -> Shape:
    """An inflated beach ball with coloured sectors and white caps."""
    d = look.between(0.16, 0.22)
    first = look.color("red", "blue", "green", "pink", "orange", "yellow")
    panels = [first, (248, 247, 242), look.own_color("yellow", "sky"), (248, 247, 242),
              look.own_color("blue", "green", "orange"), (248, 247, 242)]  # fmt: skip
    tile = surfaces.stripes(panels, 1, upright=True, side=96).copy()
    tile[:7] = tile[-7:] = (248, 247, 242)
    tilt = look.between(0.3, 0.7)
    body = ellipsoid(d, d, d, 30, 18).turn(0, tilt).turn(2, look.between(0, 6)).move(z=0.49 * d)
    return shape([(body, tile)], [flat_foot(body.vertices, 0.03)])


@category("bike_horn", size=(0.181, 0.0786, 0.0786), mass=0.15, material="metal",
          aliases=("bicycle horn", "bulb horn", "clown horn", "squeeze horn"), themes=("toys",),
          colors=("gold",))  # fmt: skip
def bike_horn(look: Look) -> Shape:
    """A horn with a rubber bulb, lying flat."""
    color = look.color("gold", "silver", "red", "blue")
    k = look.between(0.85, 1.15)
    flare = [(0.007, 0.0), (0.008, 0.05), (0.014, 0.085), (0.027, 0.108), (0.04, 0.115)]
    inner = [(r - 0.002, z + 0.0004) for r, z in flare]
    bell = lies(lathe([(0, 0), *flare, *inner[::-1], (0, 0.002)], 24), -0.01, 0, 0.04)
    bulb = ball(0.07, 0.05, 0.05, (-0.045, 0, 0.0275), 18)
    neck = rod([(-0.02, 0, 0.03), (0.0, 0, 0.04)], 0.0085, 10)
    bracket = at_box(0.016, 0.02, 0.036, (0.01, 0, 0))
    return put_down([(join([bell, neck]), steel(look, color)), (bulb, plain((34, 34, 36))),
                     (bracket, steel(look))], bell, bulb, bracket, factor=k, foot=0.1)  # fmt: skip


@category("pinwheel", size=(0.111, 0.258, 0.0248), mass=0.015, material="paper", assembled=True,
          aliases=("paper pinwheel", "paper windmill", "toy windmill", "windmill toy", "whirligig"),
          themes=("toys", "craft"), colors=("red", "blue"))  # fmt: skip
def pinwheel(look: Look) -> Shape:
    """A paper windmill on a stick, lying flat."""
    color = look.color("red", "blue", "yellow", "green", "pink")
    other = look.own_color("yellow", "white", "teal", "orange", "coral")
    k = look.between(0.8, 1.2)
    stick = straight((0, -0.2, 0.0028), (0, 0.0, 0.0028), 0.003, 8)
    vanes: list[list[Solid]] = [[], []]
    for n in range(4):
        leaf = sheet(
            (0, 0, 0.008), (0.055, 0.002, 0.008), (0.05, 0.036, 0.024), (0.01, 0.012, 0.014)
        )
        vanes[n % 2].append(leaf.turn(2, n * np.pi / 2))
    hub = drum(0.008, 0.008, (0, 0, 0.008), bevel=0.002)
    foot = drum(0.05, 0.002, sides=4).move(0, 0, 0)
    return put_down([(stick, surfaces.wood(look.rng, (214, 180, 130))),
                     (join(vanes[0]), _paper(look, color)), (join(vanes[1]), _paper(look, other)),
                     (hub, plain(tint_color(other, 0.7))),
                     (foot.turn(2, 0.78), plain(tint_color(color, 0.8)))], foot, stick, hub,
                    factor=k, foot=0.3)  # fmt: skip


@category("periscope", size=(0.0544, 0.0952, 0.245), mass=0.2, material="plastic",
          aliases=("toy periscope",), themes=("toys",), roles=("tall",),
          colors=("blue", "red"))  # fmt: skip
def periscope(look: Look) -> Shape:
    """A toy periscope: a square tube with a mirror window at each end."""
    color = look.color("blue", "red", "gray", "green", "yellow")
    k = look.between(0.8, 1.1)
    trunk = block(0.05, 0.05, 0.23, 0.004)
    top, low = at_box(0.052, 0.07, 0.052, (0, -0.01, 0.2)), at_box(0.056, 0.08, 0.05, (0, 0.01, 0))
    window = at_box(0.04, 0.002, 0.038, (0, -0.0455, 0.207))
    eye = at_box(0.034, 0.002, 0.03, (0, 0.0505, 0.01))
    bands = [at_box(0.053, 0.053, 0.006, (0, 0, z)) for z in (0.06, 0.19)]
    return put_down(
        [
            (trunk, surfaces.speckles(look.rng, color, 4)),
            (join([top, low, *bands]), plain(tint_color(color, 0.7))),
            (join([window, eye]), plain((186, 210, 220))),
        ],
        trunk,
        top,
        low,
        factor=k,
    )


@category("diabolo", size=(0.105, 0.105, 0.117), mass=0.15, material="plastic",
          aliases=("chinese yoyo",), themes=("toys",), colors=("red", "blue"))  # fmt: skip
def diabolo(look: Look) -> Shape:
    """A diabolo standing on its end: two cups joined at a narrow waist."""
    color = look.color("red", "blue", "yellow", "green", "orange")
    k = look.between(0.85, 1.15)
    side = [(0.05, 0.0), (0.052, 0.003), (0.045, 0.02), (0.022, 0.048), (0.009, 0.056),
            (0.009, 0.062)]  # fmt: skip
    low = lathe([(0, 0.001), *side, (0, 0.062)], 28)
    rim = [(0.009, 0.062), (0.022, 0.07), (0.045, 0.098), (0.052, 0.115), (0.049, 0.116),
           (0.042, 0.1), (0.012, 0.075)]  # fmt: skip
    high = lathe([(0, 0.062), *rim, (0, 0.075)], 28)
    axle = drum(0.006, 0.008, (0, 0, 0.0745))
    return put_down([(low, plain(color)), (high, plain(color if look.chance(0.5)
                                                       else look.own_color("white", "yellow",
                                                                           "black"))),
                     (axle, steel(look))], low, high, factor=k)  # fmt: skip


@category("cup_and_ball", size=(0.12, 0.0704, 0.129), mass=0.12, material="wood", assembled=True,
          aliases=("cup-and-ball", "cup-and-ball toy", "cup and ball toy", "bilboquet", "kendama",
          "ball and cup"), themes=("toys",), roles=("tall",), colors=("wooden",))  # fmt: skip
def cup_and_ball(look: Look) -> Shape:
    """A wooden cup standing on its handle, with a ball on a string beside it."""
    color = look.color("wooden", "red", "blue", "green")
    k = look.between(0.85, 1.15)
    stem = standing((0.026, 0), (0.026, 0.006), (0.009, 0.016), (0.008, 0.08), (0.012, 0.09),
                    (0.026, 0.1), (0.034, 0.125), (0.03, 0.125), (0.022, 0.106),
                    sides=24)  # fmt: skip
    sphere = ball(0.034, 0.034, 0.034, (0.065, -0.01, 0.0165), 16)
    line = rod([(0.012, 0, 0.085), (0.032, -0.004, 0.04), (0.045, -0.014, 0.03),
                (0.065, -0.01, 0.034)], 0.0011, 6)  # fmt: skip
    return put_down(
        [
            (stem, surfaces.wood(look.rng, color)),
            (sphere, plain(look.own_color("red", "yellow", "navy"))),
            (line, plain((236, 230, 214))),
        ],
        stem,
        sphere,
        factor=k,
        foot=0.06,
    )


@category("zoetrope", size=(0.151, 0.151, 0.15), mass=0.3, material="plastic",
          aliases=("praxinoscope", "stroboscope", "phenakistoscope"), themes=("toys",),
          colors=("black",))  # fmt: skip
def zoetrope(look: Look) -> Shape:
    """A zoetrope: a slotted drum on a base, with a strip of pictures inside."""
    color = look.color("black", "red", "navy", "wooden")
    k = look.between(0.85, 1.15)
    foot = standing((0.045, 0), (0.045, 0.008), (0.012, 0.018), (0.009, 0.06), sides=24)
    floor = drum(0.075, 0.006, (0, 0, 0.058), sides=32)
    band = lathe([(0.075, 0.058), (0.075, 0.1), (0.071, 0.1), (0.071, 0.058)], 32, loop=True)
    slats = [
        at_box(0.004, 0.026, 0.05, (0.073, 0, 0.099)).turn(2, n * np.pi / 6) for n in range(12)
    ]
    ring = torus(0.073, 0.003, 32, 6).move(z=0.149)
    strip = prints.canvas(256, 32, (246, 238, 214))
    for n in range(16):
        prints.disc(strip, (n + 0.5) / 16, 0.5 + 0.2 * np.sin(n * 0.8), 0.2, (60, 50, 46))
    inner = lathe([(0.0708, 0.064), (0.0708, 0.098), (0.07, 0.098), (0.07, 0.064)], 32, loop=True)
    return put_down([(join([foot, floor, band, *slats, ring]), look.surface(color, "plastic")),
                     (inner, strip)], foot, join([band, ring]), factor=k)  # fmt: skip


@category("teddy_bear", size=(0.13, 0.12, 0.155), mass=0.11, material="fabric", friction=0.8,
          aliases=("teddy", "stuffed animal", "plush toy", "bear", "plush", "cuddly toy",
          "comforter", "soft toy", "counting bear", "amigurumi", "plush cat", "soft toy cat",
          "stuffed cat", "plush rabbit", "plush dog", "beanie baby", "plushie", "stuffed toy"),
          themes=("toys",), colors=("brown", "cream"), state="sitting", common=True)  # fmt: skip
def teddy_bear(look: Look) -> Shape:
    """A small, seated teddy bear."""
    color = look.color("brown", "tan", "cream", "gray", "terracotta")
    fur = surfaces.knitting(look.rng, color)
    pale, dark = surfaces.plain(tint_color(color, 1.35)), surfaces.plain((34, 28, 26))
    ball = ellipsoid
    pieces: list[tuple[Solid, surfaces.Tile]] = [
        (ball(0.085, 0.075, 0.09, 20, 12).move(z=0.044), fur),
        (ball(0.075, 0.066, 0.066, 20, 12).move(y=-0.004, z=0.112), fur),
        (ball(0.034, 0.026, 0.026, 14, 8).move(y=-0.035, z=0.104), pale),
        (ball(0.012, 0.009, 0.009, 10, 6).move(y=-0.049, z=0.109), dark),
        (ball(0.05, 0.02, 0.055, 14, 8).move(y=-0.03, z=0.045), pale),
    ]
    for s in (-1, 1):
        pieces += [
            (ball(0.027, 0.014, 0.027, 12, 8).move(s * 0.03, 0.002, 0.142), fur),
            (ball(0.008, 0.006, 0.008, 8, 6).move(s * 0.014, -0.035, 0.122), dark),
            (ball(0.034, 0.07, 0.034, 14, 8).move(s * 0.034, -0.042, 0.017), fur),
            (ball(0.026, 0.006, 0.026, 12, 6).move(s * 0.034, -0.075, 0.017), pale),
            (ball(0.028, 0.03, 0.06, 12, 8).turn(1, s * -0.5).move(s * 0.05, -0.01, 0.058), fur),
        ]
    seat = cylinder(0.034, 0.05, 16, top=0.04)
    return shape([*pieces, (seat, fur)], [cylinder_part(0.036, 0.085),
                                          box_part(0.1, 0.06, 0.03, (0, -0.047, 0.0)),
                                          box_part(0.06, 0.055, 0.055, (0, -0.006, 0.085)),
                                          box_part(0.115, 0.024, 0.035,
                                                   (0, -0.01, 0.042))])  # fmt: skip


@category("rubber_duck", size=(0.1, 0.066, 0.088), mass=0.05, material="rubber", hollow=True,
          aliases=("duck", "toy duck", "bath duck", "bath toy", "rubber bath duck", "squeaky toy"),
          themes=("toys", "vanity"), colors=("yellow",), common=True)  # fmt: skip
def rubber_duck(look: Look) -> Shape:
    """A rubber duck facing the viewer's left."""
    color = look.color("yellow", "yellow", "pink", "sky", "mint")
    skin, beak = surfaces.speckles(look.rng, color, 3), surfaces.plain((236, 120, 40))
    dark = surfaces.plain((24, 24, 26))
    body = ellipsoid(0.085, 0.065, 0.058, 22, 12).bend(
        lambda p: np.column_stack(
            [p[:, :2], np.maximum(p[:, 2] + 6 * np.clip(p[:, 0] - 0.01, 0, 1) ** 2, -0.022)]
        )
    )
    head = ellipsoid(0.046, 0.044, 0.044, 18, 10).move(x=-0.022, z=0.066)
    bill = ellipsoid(0.026, 0.026, 0.009, 12, 6).move(x=-0.05, z=0.062)
    eyes = [ellipsoid(0.008, 0.006, 0.009, 8, 6).move(-0.036, s * 0.0165, 0.073) for s in (-1, 1)]
    wings = [ellipsoid(0.045, 0.014, 0.026, 12, 8).move(0.01, s * 0.028, 0.026) for s in (-1, 1)]
    return shape([(body.move(z=0.022), skin), (head, skin), (bill, beak), (join(eyes), dark),
                  (join(wings), surfaces.plain(tint_color(color, 0.9)))],
                 [hull_of(body.move(z=0.022)), hull_of(head), hull_of(bill)])  # fmt: skip


@category("stacking_cups", size=(0.088, 0.088, 0.14), mass=0.12, material="plastic", hollow=True,
          aliases=("nesting cups", "stacking cup", "stack cups", "tower of cups", "toy cups"),
          themes=("toys",), roles=("round", "tall"), colors=("red", "blue"))  # fmt: skip
def stacking_cups(look: Look) -> Shape:
    """A tower of upside-down nesting cups with the largest at the bottom."""
    names = ["red", "orange", "yellow", "green", "blue", "purple", "pink"]
    start = int(look.rng.integers(len(names)))
    shades = look.color("red", "orange", "yellow", "green", "blue", "purple", "pink")
    count = int(look.rng.integers(4, 7))
    r, h = look.between(0.04, 0.046), look.between(0.032, 0.038)
    pieces, parts, z = [], [], 0.0
    for n in range(count):
        tone = shades if n == 0 else look.own_color(names[(start + n) % len(names)])
        k = 1 - 0.12 * n
        cup = lathe([(0, 0), (r * k, 0), (1.03 * r * k, 0.001), (1.03 * r * k, 0.005),
                     (r * k, 0.006), (0.82 * r * k, h * k), (0, h * k)], 28)  # fmt: skip
        ring = torus(0.5 * r * k, 0.0012, 20, 5).move(z=h * k)
        pieces.append((join([cup, ring]).move(z=z), surfaces.speckles(look.rng, tone, 4, 32)))
        parts.append(hull_of(cup.move(z=z)))
        z += h * k
    return shape(pieces, parts)


@category("shape_sorter", size=(0.15, 0.15, 0.138), mass=0.6, material="wood",
          aliases=("shape sorting box", "shape box", "sorting box", "shape sorting cube",
          "sorting cube", "shape sorter toy", "activity cube"), themes=("toys",), roles=("big",),
          colors=("wooden",))  # fmt: skip
def shape_sorter(look: Look) -> Shape:
    """A toddler's box with holes of different shapes in its lid and sides."""
    side = look.between(0.135, 0.16)
    color = look.color("wooden", "yellow", "blue", "wooden", "red", "teal")
    dark = tint_color(color, 0.3)
    lid = surfaces.fit(look.surface(color, "wood"), 128, 128).copy()
    prints.disc(lid, 0.28, 0.28, 0.13, dark)
    prints.fill(lid, 0.6, 0.16, 0.25, 0.25, dark)
    prints.polygon(lid, [(0.28, 0.56), (0.44, 0.84), (0.12, 0.84)], dark)
    turns = np.arange(10) * np.pi / 5
    ray = np.where(np.arange(10) % 2, 0.07, 0.17)
    prints.polygon(lid, [(0.72 + r * np.sin(a), 0.7 - r * np.cos(a)) for r,
                         a in zip(ray, turns, strict=True)], dark)  # fmt: skip
    body = box(side, side, 0.86 * side)
    top = block(1.02 * side, 1.02 * side, 0.01, 0.004).move(z=0.86 * side)
    paint = surfaces.speckles(look.rng, look.own_color("red", "blue", "green", "orange"), 4, 32)
    return shape([(body, np.roll(lid, 64, 1)), (top, paint),
                  (box(0.98 * side, 0.98 * side, 0.0005).move(z=0.86 * side + 0.0098), lid)],
                 [box_part(side, side, 0.86 * side), hull_of(top)])  # fmt: skip


@category("marble_run", size=(0.26, 0.08, 0.18), mass=0.5, material="plastic", assembled=True,
          aliases=("marble track", "ball run", "marble toy"), themes=("toys",), roles=("big",),
          colors=("wooden",))  # fmt: skip
@from_pieces()
def marble_run(look: Look) -> Pieces:
    """A marble run: three sloping tracks on posts, with marbles on the tracks."""
    tile = wood(look, "wooden", "beige")
    base = at_box(0.26, 0.08, 0.01)
    posts = [at_box(0.012, 0.06, 0.17, (s * 0.12, 0, 0.01)) for s in (-1, 1)]
    pieces: Pieces = [(base, tile), *((p, tile) for p in posts)]
    tones = ("red", "blue", "green")
    for k in range(3):
        slope = 0.13 * (1 if k % 2 else -1)
        bed = [at_box(0.2, 0.026, 0.005), at_box(0.2, 0.004, 0.014, (0, -0.013, 0)),
               at_box(0.2, 0.004, 0.014, (0, 0.013, 0))]  # fmt: skip
        x = 0.012 * (-1 if k % 2 else 1)
        for b in bed[:1]:
            pieces.append((b.turn(1, slope).move(x, 0, 0.042 + 0.048 * k), dye(look, tones[k])))
        pieces.append((join(bed[1:]).turn(1, slope).move(x, 0, 0.042 + 0.048 * k), pieces[-1][1]))
        pieces.append((ball(0.016, 0.016, 0.016, (0.04 * (-1) ** k, 0, 0.058 + 0.048 * k - 0.04
                                                  * (-1) ** k * -slope * 0.0), 12),
                       dye(look, "sky", "amber", "green")))  # fmt: skip
    return pieces
