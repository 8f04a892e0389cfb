"""Objects of the ``workbench`` theme: power tools."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, plastic, shine, tool_steel
from ...kit.outlines import ellipse, rectangle
from ...kit.parts import box_part, flat_foot, hull_of
from ...kit.primitives import (
    at_block,
    at_box,
    ball,
    disc,
    hull_solid,
    lay_down,
    plate,
    rod,
    side_view,
    spindle,
    standing,
    straight,
)
from ...kit.shapes import Category, Drawing, Pieces, Shape, at_rest, category, from_pieces, shape
from ...kit.solids import block, box, cylinder, join, lathe, loft, prism, torus, tube
from ...kit.surfaces import Look, readable_on, tint_color

BLACK = surfaces.plain((36, 36, 39))
BODIES = ("teal", "red", "green", "yellow", "blue", "orange")


@category("polisher", size=(0.3, 0.18, 0.093), mass=1.8, material="plastic",
          aliases=("car polisher", "buffing machine", "buffer machine", "floor polisher"),
          themes=("workbench",), roles=("big",), colors=("teal", "red"), state="lying")  # fmt: skip
@at_rest
@from_pieces(bodies=4)
def polisher(look: Look) -> Pieces:
    """An angle polisher, lying on its polishing pad."""
    tile = plastic(look, *BODIES)
    pad = standing((0.06, 0), (0.075, 0.012), (0.07, 0.026), (0.03, 0.032))
    head = at_block(0.06, 0.055, 0.06, 0.016, (0, 0, 0.03))
    body = spindle((0.02, 0.028), (0.05, 0.031), (0.17, 0.027), (0.22, 0.024), z=0.062)
    side = rod([(0, -0.02, 0.065), (0, -0.1, 0.075)], [0.012, 0.014], 10)
    return [(pad, dye(look, "white", "yellow", "cream")), (head, shine(look)), (body, tile),
            (side, BLACK), (spindle((0.09, 0.0305), (0.2, 0.027), z=0.062), BLACK)]  # fmt: skip


def _blade(teeth: int, r: float, hole: float, palette: tuple[str, ...], h: float) -> Drawing:
    """A toothed saw blade or a plain disc with a hole, lying flat."""

    def draw(look: Look) -> Pieces:
        color = look.color(*palette)
        if teeth:
            a = np.arange(3 * teeth) * 2 * np.pi / (3 * teeth)
            radii = np.tile([r, 0.9 * r, 0.93 * r], teeth)
            body = prism(np.column_stack([radii * np.cos(a), radii * np.sin(a)]), 0, h)
        else:
            body = lathe([(hole, 0), (r, 0), (r, h), (hole, h)], 44, loop=True)
        tile = (look.surface(color, "metal") if teeth else surfaces.spots(look.rng, color,
                                                                          tint_color(color, 0.7),
                                                                          0.3))  # fmt: skip
        pieces: Pieces = [(body, tile), (torus(1.6 * hole, 0.0008, 28, 5).move(z=h), shine(look))]
        if teeth:
            pieces.append((disc(hole, 0.0006, (0, 0, h - 0.0002)), BLACK))
            name = disc(0.55 * r, 0.0004, (0, 0, h - 0.0002))
            pieces.insert(1, (name, dye(look, "red", "yellow", "blue", "black")))
            pieces.append((disc(2.2 * hole, 0.0006, (0, 0, h - 0.0001)), shine(look)))
            pieces[-1], pieces[-2] = pieces[-2], pieces[-1]
        return pieces

    return draw


@category("jigsaw_blade", size=(0.092, 0.0093, 0.0013), mass=0.008, material="metal",
          aliases=("hacksaw blade", "reciprocating saw blade", "scroll saw blade", "spare blade"),
          themes=("workbench",), colors=("silver",), state="lying")  # fmt: skip
@from_pieces()
def jigsaw_blade(look: Look) -> Pieces:
    """A jigsaw blade lying flat, with teeth along its front edge and a shank on the left."""
    teeth = np.column_stack(
        [np.linspace(-0.03, 0.04, 29), np.where(np.arange(29) % 2, -0.0048, -0.0034)]
    )
    outline = [*teeth, (0.046, 0.002), (0.046, 0.0035), (-0.03, 0.0035), (-0.032, 0.0045),
               (-0.046, 0.0045), (-0.046, -0.003), (-0.032, -0.003)]  # fmt: skip
    return [
        (
            plate(outline, 0.0013),
            surfaces.brushed_metal(look.rng, look.color("silver", "gray", "gold")),
        )
    ]


@category("drill_chuck", size=(0.045, 0.045, 0.0525), mass=0.3, material="metal",
          aliases=("keyless chuck",), themes=("workbench",), colors=("charcoal",),
          state="lying")  # fmt: skip
@from_pieces(bodies=1)
def drill_chuck(look: Look) -> Pieces:
    """A drill chuck with its nose up: a ribbed sleeve and a tapered nose with a dark hole."""
    steel = shine(look, "silver", "charcoal")
    body = standing(
        (0.02, 0), (0.021, 0.004), (0.021, 0.03), (0.019, 0.034), (0.008, 0.052), sides=28
    )
    ribs = [at_box(0.0025, 0.003, 0.022, (0.021 * np.cos(a), 0.021 * np.sin(a), 0.005))
            for a in np.arange(16) * 0.3927]  # fmt: skip
    return [(body, dye(look, "charcoal", "black", "silver")), (join(ribs), steel),
            (disc(0.004, 0.001, (0, 0, 0.0515)), BLACK)]  # fmt: skip


@category("wood_lathe", size=(0.42, 0.11, 0.17), mass=8.0, material="device",
          aliases=("lathe", "mini lathe", "metal lathe"), themes=("workbench",), roles=("big",),
          colors=("green",), state="lying")  # fmt: skip
@from_pieces()
def wood_lathe(look: Look) -> Pieces:
    """A wood lathe: a bed, a headstock and a tailstock with a turned workpiece between them."""
    tile = plastic(look, "green", "blue", "gray", "red")
    bed = [at_box(0.42, 0.02, 0.03, (0, s * 0.025, 0.02)) for s in (-1, 1)]
    feet = [at_box(0.05, 0.11, 0.022, (x, 0, 0)) for x in (-0.17, 0.17)]
    head = at_block(0.09, 0.09, 0.12, 0.014, (-0.16, 0, 0.048))
    tail = at_block(0.06, 0.06, 0.085, 0.01, (0.15, 0, 0.048))
    wheel = spindle((0.2, 0.022), (0.212, 0.022), z=0.12)
    shaft = spindle((0.1, 0.009), (0.2, 0.009), z=0.12)
    work = spindle((-0.115, 0.022), (-0.08, 0.022), (-0.07, 0.014), (-0.05, 0.026), (-0.02, 0.012),
                   (0.02, 0.017), (0.05, 0.026), (0.07, 0.016), (0.1, 0.022), z=0.12)  # fmt: skip
    rest = [at_box(0.12, 0.008, 0.03, (-0.01, -0.045, 0.09)),
            at_box(0.016, 0.02, 0.05, (-0.01, -0.045, 0.045))]  # fmt: skip
    return [(bed[0], shine(look)), (bed[1], shine(look)), (join([feet[0]]), tile), (feet[1], tile),
            (head, tile), (tail, tile), (wheel, BLACK), (shaft, shine(look)),
            (work, dye(look, "wooden", "tan")), (join(rest), BLACK)]  # fmt: skip


@category("chainsaw", size=(0.527, 0.125, 0.139), mass=3.5, material="plastic", assembled=True,
          aliases=("chain saw", "toy chainsaw"), themes=("workbench",), roles=("big",),
          colors=("orange",), state="lying")  # fmt: skip
@from_pieces()
def chainsaw(look: Look) -> Pieces:
    """A small chainsaw lying flat: a body, two handles and a bar with its chain."""
    tile = plastic(look, "orange", "red", "green", "yellow")
    body = at_block(0.17, 0.1, 0.09, 0.02, (-0.06, 0, 0))
    bar = (prism(rectangle(0.27, 0.055, 0.027, 8), -0.002,
                 0.002).turn(0, np.pi / 2).move(0.15, 0.01, 0.045))  # fmt: skip
    chain = (prism(rectangle(0.285, 0.066, 0.032, 8), -0.0032,
                   0.0032).turn(0, np.pi / 2).move(0.15, 0.01, 0.045))  # fmt: skip
    front = rod([(0.01, -0.045, 0.05), (0.01, -0.05, 0.12), (0.01, 0.045, 0.125),
                 (0.01, 0.05, 0.05)], 0.009, 10)  # fmt: skip
    rear = rod(
        [(-0.13, 0, 0.07), (-0.2, 0, 0.075), (-0.225, 0, 0.03), (-0.14, 0, 0.012)], 0.012, 10
    )
    guard = at_box(0.006, 0.08, 0.05, (0.035, 0, 0.085))
    return [(body, tile), (chain, dye(look, "charcoal")), (bar.scale(1, 1.9, 1).move(y=-0.009),
                                                           shine(look)), (front, BLACK),
            (rear, tile), (guard, BLACK)]  # fmt: skip


@category("biscuit_jointer", size=(0.28, 0.12, 0.125), mass=2.5, material="plastic",
          aliases=("plate joiner", "biscuit joiner"), themes=("workbench",), roles=("big",),
          colors=("teal", "red"), state="lying")  # fmt: skip
@from_pieces()
def biscuit_jointer(look: Look) -> Pieces:
    """A biscuit jointer: a motor on the left, a metal head under a loop handle, and a fence."""
    tile = plastic(look, *BODIES)
    base = at_block(0.08, 0.12, 0.014, 0.006, (0.08, 0, 0))
    fence = at_box(0.012, 0.12, 0.075, (0.115, 0, 0.0))
    body = spindle((-0.16, 0.028), (-0.14, 0.032), (0.04, 0.032), z=0.036)
    head = at_block(0.09, 0.075, 0.07, 0.01, (0.06, 0, 0.012))
    grip = rod([(0.05, -0.05, 0.06), (0.05, -0.05, 0.115), (0.05, 0.05, 0.115), (0.05, 0.05, 0.06)],
               0.009, 10)  # fmt: skip
    return [(base, shine(look)), (fence, shine(look)), (body, tile),
            (head, shine(look, "charcoal", "gray")), (grip, BLACK)]  # fmt: skip


ORBITAL_SANDER_BLACK = surfaces.plain((36, 36, 39))


def _sander(kind: str) -> Drawing:
    """A sander with a motor above a round, square or pointed pad, or above a belt."""

    def draw(look: Look) -> Pieces:
        tile = plastic(look, *BODIES)
        if kind == "belt":
            body = at_block(0.2, 0.085, 0.07, 0.02, (0, 0, 0.022))
            belt = (prism(rectangle(0.24, 0.044, 0.021, 8), -0.04,
                          0.04).turn(0, np.pi / 2).move(z=0.022))  # fmt: skip
            grips = [rod([(0.02, 0, 0.09), (0.0, 0, 0.135), (-0.08, 0, 0.14), (-0.1, 0, 0.09)],
                         0.014, 10), ball(0.045, 0.045, 0.05, (0.085, 0, 0.105), 14)]  # fmt: skip
            return [(belt, dye(look, "brown", "maroon")), (body, tile),
                    (grips[0], ORBITAL_SANDER_BLACK), (grips[1], ORBITAL_SANDER_BLACK)]  # fmt: skip
        if kind == "mouse":
            outline = np.array(
                [(-0.06, -0.045), (0.0, -0.048), (0.075, 0.0), (0.0, 0.048), (-0.06, 0.045)]
            )
            pad, foam = plate(outline, 0.01, 0.003), plate(0.98 * outline, 0.0032)
            body = ball(0.15, 0.078, 0.075, (-0.01, 0, 0.045), 20)
            grip = ball(0.11, 0.06, 0.04, (-0.02, 0, 0.08), 16)
            vents = [at_box(0.003, 0.079, 0.016, (-0.05 + 0.008 * k, 0, 0.036)) for k in range(3)]
            return [(foam, dye(look, "brown")), (pad, ORBITAL_SANDER_BLACK), (body, tile),
                    (grip, ORBITAL_SANDER_BLACK), (join(vents), ORBITAL_SANDER_BLACK)]  # fmt: skip
        pad = (disc(0.062, 0.012, (0, 0, 0.003)) if kind == "orbital"
               else at_block(0.11, 0.1, 0.012, 0.006, (0, 0, 0.003)))  # fmt: skip
        paper = disc(0.061, 0.0035) if kind == "orbital" else at_block(0.108, 0.098, 0.0035, 0.006)
        motor = standing(
            (0.05, 0.015), (0.045, 0.03), (0.04, 0.06), (0.046, 0.075), (0.044, 0.11), (0.03, 0.128)
        )
        cap = ball(0.088, 0.084, 0.05, (0, 0, 0.115), 20)
        bag = ball(0.09, 0.05, 0.05, (0.085, 0, 0.045), 14)
        cord = rod([(-0.03, 0, 0.12), (-0.075, 0, 0.11), (-0.11, 0.02, 0.05), (-0.13, 0.03, 0.004)],
                   0.004, 8)  # fmt: skip
        return [(paper, dye(look, "brown", "maroon")), (pad, ORBITAL_SANDER_BLACK), (motor, tile),
                (cap, ORBITAL_SANDER_BLACK), (bag, dye(look, "charcoal", "gray")),
                (cord, ORBITAL_SANDER_BLACK)]  # fmt: skip

    return draw


@category("plunge_router", size=(0.22, 0.15, 0.19), mass=2.0, material="plastic",
          aliases=("router tool", "wood router", "router machine", "trim router"),
          themes=("workbench",), roles=("big",), colors=("teal", "red"), state="lying")  # fmt: skip
@from_pieces(bodies=8)
def plunge_router(look: Look) -> Pieces:
    """A plunge router: a motor on two posts above a round base, with a knob on each side."""
    tile = plastic(look, *BODIES)
    base = lathe([(0.02, 0), (0.075, 0), (0.075, 0.01), (0.02, 0.01)], 36, loop=True)
    posts = [straight((s * 0.05, 0, 0.008), (s * 0.05, 0, 0.13), 0.006, 10) for s in (-1, 1)]
    motor = standing((0.034, 0.05), (0.042, 0.07), (0.042, 0.16), (0.036, 0.185), (0.02, 0.19))
    yoke = at_block(0.14, 0.06, 0.035, 0.02, (0, 0, 0.085))
    knobs = [ball(0.042, 0.042, 0.05, (s * 0.088, 0, 0.105), 14) for s in (-1, 1)]
    bit = spindle((0, 0.004), (0.05, 0.004)).turn(1, -np.pi / 2).move(z=0.005)
    collet = disc(0.013, 0.02, (0, 0, 0.034))
    return [(base, ORBITAL_SANDER_BLACK), (posts[0], shine(look)), (posts[1], shine(look)),
            (motor, tile), (yoke, tile), (knobs[0], ORBITAL_SANDER_BLACK),
            (knobs[1], ORBITAL_SANDER_BLACK), (collet, shine(look)),
            (bit.move(z=0.002), shine(look))]  # fmt: skip


@category("electric_planer", size=(0.28, 0.085, 0.146), mass=2.0, material="plastic",
          aliases=("planer", "power planer", "power plane"), themes=("workbench",), roles=("big",),
          colors=("teal", "red"), state="lying")  # fmt: skip
@from_pieces()
def electric_planer(look: Look) -> Pieces:
    """A planer on its metal sole: a sloped body, a curved black handle and a knob on the right."""
    tile = plastic(look, *BODIES)
    sole = at_box(0.28, 0.085, 0.012)
    body = hull_solid([(x, y, z) for y in (-0.042, 0.042) for x,
                       z in ((-0.13, 0.012), (-0.12, 0.06), (0.05, 0.08), (0.12, 0.05),
                             (0.13, 0.012))])  # fmt: skip
    grip = rod([(-0.1, 0, 0.06), (-0.1, 0, 0.115), (-0.03, 0, 0.13), (0.03, 0, 0.08)], 0.016, 10)
    knob = ball(0.045, 0.045, 0.05, (0.1, 0, 0.08), 14)
    return [(sole, shine(look)), (body, tile), (grip, ORBITAL_SANDER_BLACK),
            (knob, ORBITAL_SANDER_BLACK)]  # fmt: skip


@category("rotary_tool", size=(0.27, 0.08, 0.053), mass=0.6, material="plastic", assembled=True,
          aliases=("dremel", "dremel tool", "engraver", "engraving tool", "engraving pen",
          "mini grinder", "die grinder", "dental handpiece"), themes=("workbench",), roles=("big",),
          colors=("gray",), state="lying")  # fmt: skip
@from_pieces(foot=0.06, bodies=4)
def rotary_tool(look: Look) -> Pieces:
    """A rotary tool lying flat: a slim body, a collar and a bit with a small wheel."""
    tile = plastic(look, "gray", "charcoal", *BODIES)
    z = 0.026
    body = spindle(
        (-0.095, 0.02), (-0.085, 0.026), (0.02, 0.025), (0.05, 0.018), (0.07, 0.0125), z=z
    )
    band = spindle((-0.03, 0.0268), (0.02, 0.0258), z=z)
    nose = spindle((0.07, 0.009), (0.088, 0.0075), z=z)
    bit = spindle((0.088, 0.0016), (0.11, 0.0016), z=z)
    wheel = spindle((0.106, 0.011), (0.109, 0.011), z=z)
    cord = rod(
        [(-0.09, 0, z), (-0.12, 0, 0.015), (-0.15, 0.02, 0.004), (-0.11, 0.05, 0.004)], 0.0036, 8, 5
    )
    return [(body, tile), (nose, shine(look)), (wheel, dye(look, "brown", "gray")),
            (cord, ORBITAL_SANDER_BLACK), (band, ORBITAL_SANDER_BLACK),
            (bit, shine(look))]  # fmt: skip


HEAT_GUN_BLACK = surfaces.plain((36, 36, 39))


def _gun(kind: str) -> Drawing:
    """A heat gun, nail gun, spray gun or soldering gun with a pistol grip, lying on its side."""

    def draw(look: Look) -> Pieces:
        tile = plastic(look, *BODIES) if kind != "spray" else shine(look)
        z = 0.03
        grip = plate(
            [(-0.055, -0.125), (-0.01, -0.13), (0.012, -0.015), (-0.045, -0.01)], 0.036, z - 0.018
        )
        trigger = at_block(0.012, 0.03, 0.018, 0.004, (0.018, -0.032, z - 0.009))
        pieces: Pieces = [(grip, HEAT_GUN_BLACK if kind != "spray" else tile),
                          (trigger, dye(look, "black", "red"))]  # fmt: skip
        if kind == "heat":
            pieces += [(spindle((-0.1, 0.026), (-0.09, 0.031), (0.05, 0.03), (0.07, 0.02), z=z),
                        tile), (spindle((0.07, 0.018), (0.12, 0.014), (0.122, 0.017), z=z),
                                shine(look)), (spindle((0.1215, 0.013), (0.1225, 0.013), z=z),
                                               HEAT_GUN_BLACK),
                       (rod([(-0.03, -0.12, z), (-0.03, -0.16, 0.02), (-0.07, -0.18, 0.004),
                             (-0.13, -0.16, 0.004)], 0.004, 8), HEAT_GUN_BLACK)]  # fmt: skip
        elif kind == "nail":
            pieces += [(spindle((-0.06, 0.024), (-0.05, 0.031), (0.07, 0.029), z=z), tile),
                       (at_block(0.03, 0.13, 0.03, 0.006, (0.085, -0.05, z - 0.015)),
                        shine(look, "gray", "charcoal")), (plate([(0.08, -0.11), (0.1, -0.115),
                                                                  (-0.01, -0.165), (-0.03, -0.15)],
                                                                 0.022, z - 0.011), HEAT_GUN_BLACK),
                       (at_block(0.07, 0.035, 0.05, 0.008, (-0.03, -0.145, z - 0.025)),
                        dye(look, "charcoal"))]  # fmt: skip
        elif kind == "spray":
            cup = (
                standing((0.03, 0), (0.034, 0.008), (0.034, 0.06), (0.018, 0.075))
                .turn(0, np.pi)
                .turn(0, -np.pi / 2)
                .move(0.03, 0.02, z)
            )
            pieces += [(spindle((-0.06, 0.009), (-0.05, 0.014), (0.05, 0.014), (0.06, 0.019),
                                (0.075, 0.017), (0.08, 0.01), z=z), tile),
                       (cup, dye(look, "gray", "red", "blue", "black")),
                       (spindle((-0.078, 0.006), (-0.058, 0.008), z=z), shine(look, "brass")),
                       (straight((-0.033, -0.125, z), (-0.035, -0.155, z), 0.008, 10),
                        shine(look, "brass"))]  # fmt: skip
        else:
            pieces += [(spindle((-0.075, 0.024), (-0.065, 0.032), (0.03, 0.032), (0.04, 0.022),
                                z=z), tile), (spindle((0.04, 0.016), (0.075, 0.007), z=z),
                                              HEAT_GUN_BLACK),
                       (spindle((0.075, 0.0035), (0.13, 0.0028), (0.135, 0.001), z=z),
                        shine(look, "copper", "silver"))]  # fmt: skip
        return pieces

    return draw


@category("oscillating_tool", size=(0.29, 0.063, 0.066), mass=1.2, material="plastic",
          aliases=("multi tool saw", "oscillating multi tool", "oscillating saw"),
          themes=("workbench",), roles=("big",), colors=("teal", "red"), state="lying")  # fmt: skip
@from_pieces(bodies=4)
def oscillating_tool(look: Look) -> Pieces:
    """An oscillating tool lying flat: a long body with a flat, angled blade below its head."""
    tile = plastic(look, *BODIES)
    z = 0.034
    body = spindle((-0.14, 0.026), (-0.12, 0.031), (0.03, 0.029), (0.07, 0.026), z=z)
    head = at_block(0.05, 0.05, 0.05, 0.014, (0.09, 0, 0.012))
    blade = plate([(0.09, -0.012), (0.15, -0.016), (0.15, 0.016), (0.09, 0.012)], 0.0018, 0.006)
    nut = disc(0.013, 0.012)
    nut = nut.move(0.09, 0, 0.003)
    band = spindle((-0.07, 0.0315), (0.0, 0.0305), z=z)
    return [(body, tile), (head, dye(look, "charcoal", "black")), (blade, shine(look)),
            (nut, HEAT_GUN_BLACK), (band, HEAT_GUN_BLACK)]  # fmt: skip


@category("drill_press", size=(0.16, 0.22, 0.355), mass=8.0, material="device",
          aliases=("pillar drill", "bench drill", "bench drill press", "milling machine"),
          themes=("workbench",), roles=("big",), colors=("teal", "red"), state="lying")  # fmt: skip
@from_pieces(bodies=7)
def drill_press(look: Look) -> Pieces:
    """A bench drill: a base, a column and a head with a chuck and a three-armed lever."""
    tile = plastic(look, "red", "blue", "green", "gray", "teal")
    base = at_block(0.16, 0.22, 0.016, 0.01)
    column = straight((0, 0.06, 0.014), (0, 0.06, 0.34), 0.014, 14)
    table = at_block(0.12, 0.12, 0.012, 0.008, (0, -0.02, 0.1))
    arm = at_box(0.04, 0.06, 0.016, (0, 0.05, 0.098))
    head = at_block(0.09, 0.19, 0.085, 0.02, (0, 0.0, 0.25))
    lid = at_block(0.085, 0.185, 0.02, 0.02, (0, 0.0, 0.335))
    chuck = standing((0.008, 0.18), (0.015, 0.195), (0.015, 0.225), (0.01, 0.25), sides=16).move(
        y=-0.035
    )
    bit = straight((0, -0.035, 0.135), (0, -0.035, 0.185), 0.003, 8)
    bars = [straight((0.048, 0.02, 0.275), (0.06, 0.02 + 0.07 * np.cos(a), 0.275 + 0.07
                                            * np.sin(a)), 0.004, 8)
            for a in (0.5, 2.6, 4.7)]  # fmt: skip
    ends = [ball(0.018, 0.018, 0.018, (0.06, 0.02 + 0.07 * np.cos(a), 0.275 + 0.07 * np.sin(a)), 10)
            for a in (0.5, 2.6, 4.7)]  # fmt: skip
    return [(base, dye(look, "gray", "charcoal")), (column, shine(look)),
            (join([table, arm]), dye(look, "gray", "charcoal")), (head, tile),
            (lid, HEAT_GUN_BLACK), (chuck, shine(look)), (bit, shine(look)),
            (join(bars), shine(look)), (join(ends), HEAT_GUN_BLACK)]  # fmt: skip


@category("air_compressor", size=(0.365, 0.144, 0.293), mass=6.0, material="device",
          aliases=("compressor", "vacuum pump"), themes=("workbench",), roles=("big",),
          colors=("red",), state="lying")  # fmt: skip
@from_pieces(bodies=6)
def air_compressor(look: Look) -> Pieces:
    """An air compressor: a tank on two feet with a motor, a finned pump, a gauge and a handle."""
    tile = plastic(look, "red", "blue", "black", "orange")
    tank = spindle((-0.15, 0.04), (-0.135, 0.065), (0.135, 0.065), (0.15, 0.04), z=0.09)
    feet = [at_box(0.03, 0.1, 0.03, (x, 0, 0)) for x in (-0.09, 0.09)]
    motor = spindle((-0.02, 0.038), (0.1, 0.038), z=0.195)
    pump = at_block(0.06, 0.07, 0.07, 0.008, (-0.07, 0, 0.15))
    fins = [at_box(0.066, 0.076, 0.003, (-0.07, 0, 0.165 + 0.012 * k)) for k in range(5)]
    dial = disc(0.018, 0.01).turn(0, np.pi / 2).move(0.02, -0.06, 0.15)
    face = disc(0.0155, 0.001).turn(0, np.pi / 2).move(0.02, -0.0698, 0.15)
    grip = rod([(-0.14, 0, 0.12), (-0.17, 0, 0.24), (-0.1, 0, 0.265), (0.1, 0, 0.265),
                (0.16, 0, 0.22), (0.14, 0, 0.12)], 0.007, 8)  # fmt: skip
    return [(tank, tile), (feet[0], HEAT_GUN_BLACK), (feet[1], HEAT_GUN_BLACK),
            (motor, dye(look, "charcoal", "gray")), (pump, shine(look)), (grip, HEAT_GUN_BLACK),
            (join(fins), shine(look)), (dial, shine(look, "brass")),
            (face, surfaces.plain((244, 242, 236)))]  # fmt: skip


@category("staple_gun", size=(0.176, 0.088, 0.026), mass=0.6, material="metal", assembled=True,
          aliases=("tacker", "stapler gun"), themes=("workbench",), colors=("silver",),
          state="lying flat")  # fmt: skip
def staple_gun(look: Look) -> Shape:
    """A staple gun, lying on its side."""
    k = look.between(0.9, 1.06)
    color = look.color("silver", "red", "yellow", "black", "blue", "gray")
    h = 0.026 * k
    outline = np.array([(-0.085, 0.005), (-0.08, -0.016), (0.07, -0.02), (0.088, -0.02),
                        (0.088, 0.045), (0.05, 0.062), (0.02, 0.05), (-0.03, 0.028)])  # fmt: skip
    hole = prism(np.array([(-0.06, 0.0), (0.02, -0.004), (0.03, 0.022), (-0.02, 0.018)]) * k,
                 -0.0004, h + 0.0006)  # fmt: skip
    lever = prism(np.array([(0.055, 0.058), (0.058, 0.07), (-0.085, 0.062), (-0.092, 0.052),
                            (-0.03, 0.05)]) * k, 0.15 * h, 0.85 * h)  # fmt: skip
    body = prism(outline * k, 0, h)
    return shape([(body, look.surface(color, "metal")), (hole, surfaces.plain(DARK)),
                  (lever, surfaces.plain(tint_color(color, 0.55)))],
                 [hull_of(body), hull_of(lever)])  # fmt: skip


DARK = (40, 40, 43)


@category("drill_bit", size=(0.105, 0.0084, 0.0084), mass=0.03, material="metal",
          aliases=("twist drill", "drill bit piece", "spade bit", "screwdriver bit", "auger bit",
          "sds bit", "router bit", "dental burr", "countersink bit", "masonry bit"),
          themes=("workbench",), colors=("silver", "gold"), state="lying flat")  # fmt: skip
def drill_bit(look: Look) -> Shape:
    """A twist drill bit, lying flat."""
    k = look.between(0.8, 1.3)
    color = look.color("silver", "gold", "charcoal", "black")
    r, long, n = 0.004 * k, 0.1 * k, 44
    t = np.linspace(0, 1, n)
    section = ellipse(2, 1.15, 12) * r
    rings = []
    for s in t:
        a = 0.0 if s > 0.68 else (0.68 - s) * 32
        c, w = np.cos(a), np.sin(a)
        size = np.clip(s / 0.07, 0.08, 1)
        body = section if s <= 0.68 else ellipse(2 * r, 2 * r, 12)
        ring = body @ np.array([[c, w], [-w, c]]) * size
        rings.append(np.column_stack([np.full(12, s * long), ring]))
    bit = loft(np.stack(rings), section, profile=np.column_stack([t * long, 0 * t]))
    bit = bit.move(x=-long / 2, z=-float(bit.bounds[0, 2]))
    return shape([(bit, look.surface(color, "metal"))], [flat_foot(bit.vertices, 0.14)])


@category("glue_gun", size=(0.209, 0.128, 0.03), mass=0.2, material="plastic", assembled=True,
          aliases=("hot glue gun", "hot melt gun", "caulking gun"), themes=("workbench", "craft"),
          colors=("blue", "black"), state="lying flat")  # fmt: skip
def glue_gun(look: Look) -> Shape:
    """A hot glue gun with a glue stick at its back, lying on its side."""
    k = look.between(0.88, 1.06)
    color = look.color("blue", "black", "yellow", "red", "teal", "orange", "green")
    h = 0.03 * k
    outline = np.array([(-0.075, 0.03), (-0.07, -0.005), (-0.066, -0.085), (-0.035, -0.09),
                        (-0.02, -0.012), (0.045, 0.0), (0.05, 0.036), (-0.03, 0.042)])  # fmt: skip
    body = prism(outline * k, 0, h)
    nose = lay_down(lathe(np.array([(0, 0), (0.012, 0), (0.011, 0.012), (0.0045, 0.03),
        (0.0028, 0.038),
                                 (0, 0.038)]) * k, 18), 0.048 * k,
                                     h / 2).move(y=0.018 * k)  # fmt: skip
    collar = lay_down(cylinder(0.0145 * k, 0.012 * k, 20), 0.042 * k, h / 2).move(y=0.018 * k)
    trigger = prism(np.array([(-0.022, -0.012), (-0.03, -0.05), (-0.018, -0.055), (-0.004, -0.012)])
                    * k, 0.3 * h, 0.7 * h)  # fmt: skip
    stick = lay_down(cylinder(0.0056 * k, 0.06 * k, 14), -0.13 * k, h / 2).move(y=0.016 * k)
    plate = prism(outline[1:5] * k * 0.8 + [-0.009 * k, -0.01 * k], h - 0.0005, h + 0.0012)
    return shape([(body, look.surface(color, "plastic")), (nose, surfaces.plain((206, 176, 100))),
                  (join([collar, trigger]), surfaces.plain(DARK)), (plate, surfaces.plain(
                      tint_color(color, 0.6))), (stick, surfaces.plain((236, 230, 206)))],
                 [hull_of(prism(outline[[0, 1, 4, 5, 6, 7]] * k, 0, h)),
                  hull_of(prism(outline[1:5] * k, 0, h)), hull_of(nose),
                      hull_of(stick)])  # fmt: skip


POWER_DRILL_DARK = (44, 46, 50)


@category("power_drill", size=(0.255, 0.07, 0.217), mass=1.2, material="device", aliases=("drill",
          "cordless drill", "electric drill", "hand drill", "drill driver", "hot air gun",
          "impact driver", "electric screwdriver", "hammer drill"), themes=("workbench",),
          roles=("tall",), colors=("yellow", "teal"), common=True)  # fmt: skip
def power_drill(look: Look) -> Shape:
    """A cordless drill standing on its battery with its chuck towards +x."""
    k = look.between(0.92, 1.1)
    color = look.color("yellow", "teal", "red", "blue", "green", "orange")
    shell, dark = (surfaces.speckles(look.rng, color, 4, 32),
                   surfaces.speckles(look.rng, POWER_DRILL_DARK, 4))  # fmt: skip
    axis, r = 0.185 * k, 0.032 * k
    print_ = prints.canvas(128, 64, color)
    prints.fill(print_, 0, 0.72, 1, 0.1, POWER_DRILL_DARK)
    name = look.pick(["18V", "20V", "12V"])
    prints.write(print_, name, 0.5, 0.3, 0.3, readable_on(color), bold=True)
    motor = lathe([(0, 0), (0.7 * r, 0), (0.97 * r, 0.012 * k), (r, 0.04 * k), (r, 0.1 * k),
                   (0.8 * r, 0.125 * k), (0, 0.125 * k)], 26)  # fmt: skip
    body = lay_down(motor, -0.085 * k, axis)
    vent = lay_down(cylinder(0.9 * r, 0.016 * k, 24, bevel=0.003), -0.092 * k, axis)
    collar = lay_down(cylinder(0.76 * r, 0.026 * k, 24, top=0.72 * r), 0.038 * k, axis)
    chuck = lay_down(cylinder(0.6 * r, 0.042 * k, 18, top=0.36 * r, bevel=0.002), 0.062 * k, axis)
    bit = lay_down(cylinder(0.003, 0.055 * k, 10, top=0.002), 0.102 * k, axis)
    grip = side_view([(-0.05 * k, 0.05 * k), (-0.008 * k, 0.05 * k), (0.012 * k, 0.165 * k),
                      (-0.04 * k, 0.165 * k)], 0.036 * k, 0.007)  # fmt: skip
    foot = side_view([(-0.062 * k, 0.034 * k), (0.03 * k, 0.034 * k), (0.012 * k, 0.062 * k),
                      (-0.056 * k, 0.062 * k)], 0.05 * k, 0.004)  # fmt: skip
    battery = block(0.11 * k, 0.07 * k, 0.038 * k, 0.012, 0.004).move(x=-0.012 * k)
    trigger = side_view([(0.002 * k, 0.12 * k), (0.02 * k, 0.116 * k), (0.026 * k, 0.15 * k),
                         (0.008 * k, 0.152 * k)], 0.016 * k, 0.002)  # fmt: skip
    plates = [box(0.07 * k, 0.001, 0.03 * k).move(-0.03 * k, s * (r + 0.0003), axis - 0.016 * k)
              for s in (-1, 1)]  # fmt: skip
    return shape(
        [(join([body, foot]), shell), (join([vent, grip, battery, collar]), dark),
         (chuck, surfaces.plain((70, 72, 78))), (bit, tool_steel(look)),
         (trigger, surfaces.plain(look.own_color("red", "black", "orange"))),
         (join(plates), print_)],
        [hull_of(battery), hull_of(foot, grip), hull_of(body, vent), hull_of(collar, chuck),
         box_part(0.055 * k, 0.005, 0.005, (0.13 * k, 0, axis - 0.0025))],
    )  # fmt: skip


@category("soldering_iron", size=(0.23, 0.08, 0.185), mass=0.45, material="device",
          aliases=("solder iron", "soldering station", "soldering stand", "wood burning pen"),
          themes=("workbench", "lab"), roles=("tall",), colors=("blue", "red"),
          common=True)  # fmt: skip
def soldering_iron(look: Look) -> Shape:
    """A soldering iron in a coil stand with a sponge."""
    x, y = look.between(0.15, 0.17), look.between(0.075, 0.085)
    color = look.color("blue", "red", "yellow", "orange", "green")
    base = block(x, y, 0.014, 0.008, 0.003)
    sponge = block(0.055, 0.05, 0.01, 0.005, 0.002).move(x=-0.28 * x, z=0.012)
    t = np.linspace(0, 2 * np.pi * 9, 91)
    coil = np.column_stack([0.012 * np.cos(t), 0.012 * np.sin(t), np.linspace(0.0, 0.07, 91)])
    tilt, place = 0.72, (0.1 * x, 0, 0.03)
    spring = tube(coil, 0.0014, 5).turn(1, tilt).move(*place)
    rod = cylinder(0.004, 0.1, 10, top=0.0045).move(z=-0.012).turn(1, tilt).move(*place)
    handle = lathe([(0, 0.082), (0.012, 0.082), (0.014, 0.09), (0.0085, 0.1), (0.0105, 0.125),
                    (0.0095, 0.2), (0.005, 0.21), (0, 0.21)], 18)  # fmt: skip
    handle = handle.turn(1, tilt).move(*place)
    post = side_view([(0.02 * x, 0.012), (0.3 * x, 0.012), (0.26 * x, 0.05), (0.1 * x, 0.045)],
                     0.012, 0.002)  # fmt: skip
    return shape(
        [(join([base, post]), surfaces.speckles(look.rng, look.own_color("charcoal", "gray"), 4)),
         (sponge, surfaces.spots(look.rng, (226, 200, 96), (180, 150, 60), 0.1)),
         (join([spring, rod]), tool_steel(look)), (handle, surfaces.speckles(look.rng, color, 4))],
        [box_part(x, y, 0.014), hull_of(post), hull_of(spring), hull_of(handle)],
    )  # fmt: skip


CATEGORIES = (
    Category("circular_saw_blade",
             from_pieces(bodies=1)(_blade(24, 0.085, 0.012, ("silver", "gray"), 0.002)),
             size=(0.171, 0.171, 0.00277), mass=0.25, material="metal",
             aliases=("saw blade", "round saw blade", "table saw blade"), themes=("workbench",),
             colors=("silver",), state="lying"),
    Category("grinding_disc",
             from_pieces(bodies=1)(_blade(0, 0.0575, 0.011, ("charcoal", "brown", "gray"), 0.006)),
             size=(0.111, 0.111, 0.00653), mass=0.15, material="stone", aliases=("grinding wheel",
             "cutting disc", "sanding disc", "abrasive disc", "angle grinder disc", "cutting wheel",
             "flap disc", "whetstone wheel"), themes=("workbench",), colors=("charcoal",),
             state="lying"),
    Category("orbital_sander", from_pieces(bodies=5)(_sander("orbital")),
             size=(0.251, 0.119, 0.134), mass=1.2, material="plastic",
             aliases=("sander", "electric sander", "palm sander", "random orbit sander"),
             themes=("workbench",), roles=("big",), colors=("teal", "red"), state="lying"),
    Category("sheet_sander", from_pieces(bodies=5)(_sander("sheet")), size=(0.265, 0.102, 0.142),
             mass=1.2, material="plastic", aliases=("finishing sander",), themes=("workbench",),
             roles=("big",), colors=("teal", "red"), state="lying"),
    Category("detail_sander", from_pieces(bodies=4)(_sander("mouse")), size=(0.161, 0.0965, 0.1),
             mass=0.8, material="plastic", aliases=("mouse sander", "corner sander"),
             themes=("workbench",), colors=("teal", "red"), state="lying"),
    Category("belt_sander", from_pieces()(_sander("belt")), size=(0.24, 0.085, 0.155), mass=2.5,
             material="plastic", aliases=("band sander",), themes=("workbench",), roles=("big",),
             colors=("teal", "red"), state="lying"),
    Category("heat_gun", at_rest(from_pieces(bodies=4)(_gun("heat"))), size=(0.26, 0.22, 0.062),
             mass=0.7, material="plastic", assembled=True, aliases=("paint stripper gun",),
             themes=("workbench",), roles=("big",), colors=("teal", "red"), state="lying"),
    Category("nail_gun", from_pieces()(_gun("nail")), size=(0.16, 0.19, 0.062), mass=1.8,
             material="plastic", assembled=True,
             aliases=("brad nailer", "nailer", "finish nailer", "pneumatic nailer"),
             themes=("workbench",), roles=("big",), colors=("teal", "red"), state="lying"),
    Category("spray_gun", at_rest(from_pieces()(_gun("spray"))), size=(0.155, 0.173, 0.0629),
             mass=0.6, material="plastic", assembled=True,
             aliases=("paint sprayer", "paint spray gun", "airbrush gun"), themes=("workbench",),
             colors=("silver",), state="lying"),
    Category("soldering_gun", at_rest(from_pieces()(_gun("solder"))), size=(0.21, 0.16, 0.064),
             mass=0.7, material="plastic", assembled=True, aliases=("solder gun",),
             themes=("workbench",), roles=("big",), colors=("teal", "red"), state="lying"),
)  # fmt: skip
"""Objects that share their drawing functions."""
