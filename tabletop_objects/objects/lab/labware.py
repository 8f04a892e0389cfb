"""Objects of the ``lab`` theme: labware."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, plastic
from ...kit.outlines import rectangle
from ...kit.parts import (
    box_part,
    cylinder_part,
    flat_foot,
    hull_of,
    hull_part,
    open_vessel,
    ring_parts,
)
from ...kit.primitives import at_block, at_box, disc, drum, lay_down, rod, spindle, standing
from ...kit.shapes import (
    Category,
    Drawing,
    Pieces,
    Shape,
    at_rest,
    category,
    from_pieces,
    keep_still,
    put_down,
    shape,
    vary,
)
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, open_box, prism, torus, tube
from ...kit.surfaces import RGB, Look, plain, tint_color
from ...values import ConvexPart, Holder
from ..kitchen.racks import _boards, centres, choose_slots, read_request


@category("rubber_stopper", size=(0.0331, 0.0333, 0.022), mass=0.012, material="rubber",
          aliases=("stopper", "lab stopper"), themes=("lab",), roles=("round",),
          colors=("terracotta",))  # fmt: skip
def rubber_stopper(look: Look) -> Shape:
    """A tapered rubber stopper, standing on its wider or its narrower end."""
    color = look.color("terracotta", "black", "gray", "red", "cream")
    r = look.between(0.012, 0.022)
    body = drum(r, 1.3 * r, top=0.76 * r, sides=26, bevel=0.03 * r)
    hole = drum(0.18 * r, 0.0005, (0, 0, 1.3 * r - 0.0002), sides=14)
    return put_down(
        [(body, surfaces.speckles(look.rng, color, 5)), (hole, plain((50, 40, 40)))], body
    )


LIQUIDS = ("blue", "teal", "amber", "pink", "green", "violet", "coral", "red")
GLASS: RGB = (206, 222, 226)


def marks(ground: RGB, count: int = 10) -> surfaces.Tile:
    """Return a texture of glass with a scale at the front."""
    image = prints.canvas(96, 128, ground)
    for n in range(count):
        prints.fill(image, 0.44, 0.12 + 0.76 * n / count, 0.12 if n % 2 else 0.07, 0.012,
                    (60, 84, 100))  # fmt: skip
    return image


@category("test_tube", size=(0.142, 0.0214, 0.0214), mass=0.03, material="glass",
          aliases=("glass tube", "single test tube", "sample tube", "centrifuge tube", "vial",
          "culture tube", "blood tube", "vacutainer", "falcon tube", "boiling tube",
          "specimen tube", "blood sample tube", "homeopathic tube", "fulgurite"), themes=("lab",),
          colors=("clear", "blue"), state="lying flat")  # fmt: skip
def test_tube(look: Look) -> Shape:
    """One stoppered test tube with liquid in it, lying flat."""
    k = look.between(0.9, 1.1)
    color = look.color(*LIQUIDS)
    r, long = 0.009 * k, 0.13 * k
    a = np.linspace(-np.pi / 2, 0, 6)
    bottom = [(r * np.cos(t), r + r * np.sin(t)) for t in a]
    body = lathe([(0, 0), *bottom[1:], (r, long - 0.003), (1.18 * r, long - 0.002),
        (1.18 * r, long),
                  (0, long)], 22, v=[0, *np.linspace(0.01, 0.07, 5), 0.96, 0.97, 0.99,
                      1])  # fmt: skip
    body = lay_down(body, -long / 2, 1.18 * r)
    share = look.between(0.4, 0.7)
    tile = surfaces.stack((surfaces.plain(color), share), (surfaces.plain(GLASS), 1 - share))
    cork = lay_down(cylinder(r, 0.018 * k, 16, top=1.2 * r), long / 2 - 0.006 * k, 1.18 * r)
    stop = surfaces.speckles(look.rng, look.own_color("tan", "black", "red", "white"), 6, 32)
    low = min(float(s.bounds[0, 2]) for s in (body, cork))
    body, cork = body.move(z=-low), cork.move(z=-low)
    return shape([(body, tile), (cork, stop)], [flat_foot(body.vertices, 0.1), hull_of(cork)],
                 opacity=0.8)  # fmt: skip


@category("tube_stand", size=(0.19, 0.06, 0.06), mass=0.15, material="wood", hollow=True,
          aliases=("empty test tube rack", "test tube holder", "test tube stand", "tube holder",
          "vial rack"), themes=("lab",), roles=("big",), colors=("wooden",),
          opened="empty_tube_rack")  # fmt: skip
def tube_stand(look: Look) -> Shape:
    """An empty rack for test tubes: a board with round holes above a base."""
    k = look.between(0.92, 1.08)
    color = look.color("wooden", "white", "blue", "wooden", "beige")
    wood = look.surface(color, "wood")
    count, pitch = 6, 0.03 * k
    x, y, top = pitch * count + 0.01, 0.06 * k, 0.06 * k
    hole, wall = 0.011 * k, 0.007
    base = box(x, y, wall)
    ends = [box(0.007, y, top).move(x=s * (x - 0.007) / 2) for s in (-1, 1)]
    rails = [box(x, (y - 2 * hole) / 2, wall).move(y=s * (y + 2 * hole) / 4, z=top - wall)
             for s in (-1, 1)]  # fmt: skip
    bars = [box(pitch - 2 * hole, 2 * hole, wall).move((n - count / 2) * pitch, 0, top - wall)
            for n in range(1, count)]  # fmt: skip
    return shape([(join([base, *ends, *rails, *bars]), wood)],
                 [hull_of(s) for s in (base, *ends, *rails, *bars)])  # fmt: skip


@category("graduated_cylinder", size=(0.0585, 0.0585, 0.172), mass=0.12, material="glass",
          hollow=True, aliases=("measuring cylinder", "glass cylinder", "mixing cylinder",
          "rain gauge tube", "tornado tube"), themes=("lab",), roles=("round", "tall"),
          colors=("clear",))  # fmt: skip
def graduated_cylinder(look: Look) -> Shape:
    """A graduated cylinder: a tall, open tube with a scale on a broad base."""
    k = look.between(0.85, 1.1)
    color = look.color("clear", "clear", "blue", "amber")
    side = [(0.03 * k, 0.0), (0.03 * k, 0.006), (0.0145 * k, 0.012), (0.0145 * k, 0.17 * k),
            (0.0165 * k, 0.176 * k)]  # fmt: skip
    body = lathe([(0, 0), *side, (0.0125 * k, 0.176 * k), (0.0125 * k, 0.014), (0, 0.014)], 28,
                 v=[0, 0.02, 0.04, 0.08, 0.92, 0.95, 0.96, 0.99, 1])  # fmt: skip
    liquid = look.own_color(*LIQUIDS)
    level = look.between(0.2, 0.6) * 0.16 * k
    fluid = cylinder(0.0121 * k, level, 20).move(z=0.0142)
    wall = ring_parts([(0.0145 * k, 0.012), (0.0145 * k, 0.176 * k)],
                      [(0.0125 * k, 0.176 * k), (0.0125 * k, 0.012)], 8)  # fmt: skip
    return shape([(body, marks(color, 16)), (fluid, surfaces.plain(liquid))],
                 [*wall, cylinder_part(0.0299 * k, 0.012)], opacity=0.66)  # fmt: skip


@category("funnel", size=(0.09, 0.09, 0.1), mass=0.04, material="plastic", hollow=True,
          aliases=("lab funnel", "plastic funnel", "glass funnel", "kitchen funnel",
          "funnel for oil", "oil funnel"), themes=("lab", "kitchen"), roles=("round",),
          colors=("white", "blue"))  # fmt: skip
def funnel(look: Look) -> Shape:
    """A funnel standing on its rim with its stem up."""
    k = look.between(0.85, 1.15)
    color = look.color("white", "blue", "red", "clear", "orange", "silver", "green")
    r, h = 0.045 * k, 0.05 * k
    body = lathe([(0.94 * r, 0), (r, 0), (r, 0.003), (0.0085 * k, h), (0.006 * k, h + 0.05 * k),
                  (0.0045 * k, h + 0.05 * k), (0.0068 * k, h)], 34, loop=True)  # fmt: skip
    dark = cylinder(0.0046 * k, 0.001, 16).move(z=h + 0.0488 * k)
    cone = ring_parts([(r, 0), (0.0085 * k, h)], [(0.0068 * k, h), (0.94 * r, 0)], 12)
    stem = cylinder_part(0.0062 * k, 0.05 * k, (0, 0, h))
    return shape([(body, look.surface(color, "plastic")), (dark, surfaces.plain((40, 40, 42)))],
                 [*cone, stem])  # fmt: skip


@category("wash_bottle", size=(0.099, 0.0715, 0.184), mass=0.3, material="plastic", assembled=True,
          aliases=("lab wash bottle", "distilled water bottle", "squirt bottle", "rinse bottle"),
          themes=("lab",), roles=("tall",), colors=("white",))  # fmt: skip
def wash_bottle(look: Look) -> Shape:
    """A wash bottle: a soft squeeze bottle with a long, bent spout."""
    k = look.between(0.9, 1.08)
    color = look.color("white", "white", "clear")
    cap_tone = look.own_color("red", "blue", "yellow", "green", "white", "orange")
    body = lathe(np.array([(0, 0), (0.034, 0), (0.036, 0.004), (0.036, 0.1), (0.03, 0.118),
                           (0.016, 0.126), (0.016, 0.134), (0, 0.134)]) * k, 30)  # fmt: skip
    image = prints.canvas(128, 96, color)
    front = image[:, 42:86]
    prints.fill(front, 0, 0.34, 1, 0.34, cap_tone)
    prints.write(front, look.pick(["WATER", "ETHANOL", "ACETONE"]), 0.5, 0.51, 0.16,
                 (250, 250, 248) if sum(cap_tone) < 500 else (30, 30, 30), bold=True)  # fmt: skip
    cap = cylinder(0.0185 * k, 0.02 * k, 22, bevel=0.001).move(z=0.13 * k)
    way = np.array([(0, 0, 0.148), (0.002, 0, 0.168), (0.016, 0, 0.182), (0.04, 0, 0.178),
                    (0.062, 0, 0.163)]) * k  # fmt: skip
    spout = tube(way, np.array([0.0045, 0.0042, 0.0038, 0.003, 0.0018]) * k, 10)
    return shape([(body, image), (cap, surfaces.speckles(look.rng, cap_tone, 4, 32)),
                  (spout, surfaces.plain((240, 240, 238)))],
                 [cylinder_part(0.036 * k, 0.104 * k), hull_of(body), hull_of(cap),
                  hull_of(spout)])  # fmt: skip


@category("dropper", size=(0.149, 0.0195, 0.0195), mass=0.01, material="glass", assembled=True,
          aliases=("pipette", "eye dropper", "glass dropper", "transfer pipette", "eyedropper",
          "dropping pipette"), themes=("lab",), colors=("red",), state="lying flat")  # fmt: skip
def dropper(look: Look) -> Shape:
    """A pipette with a rubber bulb, lying flat."""
    k = look.between(0.88, 1.1)
    color = look.color("red", "blue", "orange", "black", "white", "teal")
    stem = lathe(np.array([(0, 0), (0.0014, 0), (0.0018, 0.03), (0.0042, 0.04), (0.0042, 0.11),
                           (0, 0.11)]) * k, 16)  # fmt: skip
    bulb = lathe(np.array([(0, 0.104), (0.0052, 0.104), (0.0056, 0.112), (0.0095, 0.125),
                           (0.0098, 0.135), (0.006, 0.147), (0, 0.149)]) * k, 20)  # fmt: skip
    lean = np.arctan2(0.0084, 0.13)
    solids = [s.turn(1, np.pi / 2 - lean).move(x=-0.07 * k) for s in (stem, bulb)]
    low = min(float(s.bounds[0, 2]) for s in solids)
    stem, bulb = (s.move(z=-low) for s in solids)
    liquid = surfaces.stack((surfaces.plain(look.own_color(*LIQUIDS)), 0.45),
                            (surfaces.plain(GLASS), 0.55))  # fmt: skip
    return shape([(stem, liquid), (bulb, surfaces.speckles(look.rng, color, 4, 32))],
                 [hull_of(stem), flat_foot(bulb.vertices, 0.1)])  # fmt: skip


@category("micropipette", size=(0.236, 0.045, 0.033), mass=0.1, material="plastic", assembled=True,
          aliases=("lab pipette", "pipettor", "automatic pipette", "pipette gun"), themes=("lab",),
          colors=("white",), state="lying flat")  # fmt: skip
@keep_still
def micropipette(look: Look) -> Shape:
    """A micropipette lying flat: a plunger, a grip with a hook, a slender shaft and a tip."""
    k = look.between(0.92, 1.06)
    color = look.color("white", "gray", "white", "sky")
    accent = look.own_color("blue", "yellow", "red", "green", "orange", "purple")
    grip = lathe(np.array([(0, 0.1), (0.008, 0.1), (0.011, 0.115), (0.0135, 0.16), (0.015, 0.2),
                           (0.011, 0.208), (0, 0.21)]) * k, 20)  # fmt: skip
    shaft = lathe(np.array([(0, 0.03), (0.0035, 0.03), (0.005, 0.06), (0.007, 0.1),
        (0, 0.101)]) * k,
                  16)  # fmt: skip
    tip = lathe(
        np.array([(0, 0), (0.0006, 0), (0.0036, 0.034), (0.0044, 0.042), (0, 0.042)]) * k, 14
    )
    knob = lathe(np.array([(0, 0.208), (0.004, 0.208), (0.004, 0.222), (0.0075, 0.224),
                           (0.0075, 0.234), (0, 0.236)]) * k, 18)  # fmt: skip
    hook = box(0.006 * k, 0.03 * k, 0.01 * k).move(y=0.02 * k, z=0.194 * k)
    solids = [lay_down(s, -0.118 * k, 0.015 * k) for s in (grip, shaft, tip, knob, hook)]
    lean = np.arctan2(0.0145, 0.19) * 0.95
    solids = [s.move(x=-0.08 * k, z=-0.015 * k).turn(1, lean) for s in solids]
    low = min(float(s.bounds[0, 2]) for s in solids)
    grip, shaft, tip, knob, hook = (s.move(z=-low) for s in solids)
    return shape([(join([grip, hook, shaft]), look.surface(color, "plastic")),
        (knob, surfaces.plain(
                  accent)), (tip, surfaces.plain(tint_color(accent, 1.4)))],
                 [flat_foot(grip.vertices, 0.08), hull_of(shaft), hull_of(tip), hull_of(knob),
                  hull_of(hook)])  # fmt: skip


@category("glass_rod", size=(0.2, 0.0064, 0.0064), mass=0.02, material="glass",
          aliases=("stirring rod", "stir rod", "glass stirring rod", "glass stirrer",
          "stirring stick"), themes=("lab",), colors=("clear",), state="lying flat")  # fmt: skip
def glass_rod(look: Look) -> Shape:
    """A glass stirring rod, lying flat."""
    k = look.between(0.9, 1.1)
    r, long = 0.0032 * k, 0.2 * k
    side = [(0, 0), (0.7 * r, 0.0006), (r, 0.003), (r, long - 0.003), (0.7 * r, long - 0.0006),
            (0, long)]  # fmt: skip
    body = lay_down(lathe(side, 14), -long / 2, r)
    body = body.move(z=-body.bounds[0, 2])
    return shape([(body, surfaces.plain(look.color("clear", "sky", "clear")))],
                 [flat_foot(body.vertices, 0.1)], opacity=0.8)  # fmt: skip


@category("empty_beaker", size=(0.0827, 0.0827, 0.1025), mass=0.12, material="glass",
          aliases=("open beaker",), themes=("lab",), roles=("container", "round"),
          colors=("clear",))  # fmt: skip
@vary()
def empty_beaker(look: Look) -> Shape:
    """An empty glass beaker with a scale."""
    r, h = look.between(0.036, 0.042), look.between(0.095, 0.11)
    side = [(r, 0), (r, h - 0.003), (1.06 * r, h)]
    body, parts = open_vessel(side, 0.003, 0.005)
    return shape([(body, marks(GLASS))], parts, opacity=0.6)


@category("weighing_boat", size=(0.075, 0.06, 0.016), mass=0.008, material="plastic", hollow=True,
          aliases=("weigh boat", "weighing dish", "weighing tray"), themes=("lab",),
          roles=("container",), colors=("white",))  # fmt: skip
def weighing_boat(look: Look) -> Shape:
    """A small, open plastic tray with a little powder."""
    k = look.between(0.85, 1.15)
    x, y, h, wall = 0.075 * k, 0.06 * k, 0.016 * k, 0.0018
    color = look.color("white", "white", "blue", "black", "clear")
    pieces = open_box(x, y, h, wall, 0.002)
    parts: list[ConvexPart] = [hull_of(s) for s in pieces]
    powder = lathe([(0, 0), (0.014 * k, 0), (0.008 * k, 0.004), (0, 0.006)], 18).move(z=0.0018)
    tone = look.own_color("white", "yellow", "blue", "cream", "tan")
    return shape([(join(pieces), look.surface(color, "plastic")), (powder, surfaces.spots(
                  look.rng, tone, tint_color(tone, 0.8), 0.2, 64))], parts)  # fmt: skip


@category("crucible", size=(0.055, 0.055, 0.042), mass=0.05, material="ceramic", hollow=True,
          aliases=("porcelain crucible",), themes=("lab",), roles=("container", "round"),
          colors=("white",))  # fmt: skip
def crucible(look: Look) -> Shape:
    """A small, open porcelain crucible."""
    k = look.between(0.88, 1.12)
    color = look.color("white", "white", "cream", "gray", "charcoal")
    side = [(0.014 * k, 0), (0.021 * k, 0.014 * k), (0.026 * k, 0.036 * k), (0.0275 * k, 0.042 * k)]
    body, parts = open_vessel(side, 0.0028, 0.004)
    return shape([(body, look.surface(color, "ceramic"))], parts)


BEAKER_LIQUIDS = ("blue", "teal", "amber", "pink", "green", "violet", "coral")


def _glass(color: RGB) -> surfaces.Tile:
    return surfaces.plain(tint_color(color, 1.35))


def _graduation(ground: RGB, ink: RGB = (70, 90, 100)) -> surfaces.Tile:
    """Return a texture of glass with a measuring scale at the front."""
    image = prints.canvas(128, 128, ground)
    for k in range(9):
        prints.fill(image, 0.46, 0.2 + 0.075 * k, 0.09 if k % 2 else 0.05, 0.014, ink)
    prints.write(image, "250 ml", 0.5, 0.13, 0.09, ink)
    return image


@category("beaker", size=(0.08, 0.08, 0.1), mass=0.16, material="glass", hollow=True,
          aliases=("glass beaker",), themes=("lab",), roles=("round",), colors=("clear",),
          opened="empty_beaker", common=True)  # fmt: skip
def beaker(look: Look) -> Shape:
    """An open glass beaker with a scale and some liquid."""
    r, h, wall = look.between(0.034, 0.04), look.between(0.09, 0.105), 0.003
    level = look.between(0.3, 0.6) * h
    liquid = look.color(*BEAKER_LIQUIDS)
    body = lathe([(0, 0), (r - 0.004, 0), (r, 0.004), (r, h - 0.004), (r + 0.003, h), (r, h),
                  (r - wall, h - 0.004), (r - wall, 0.006), (0, 0.006)],
                 v=[0, 0, 0.03, 0.9, 0.94, 0.95, 0.96, 0.99, 1])  # fmt: skip
    fluid = cylinder(r - 1.2 * wall, level, 24).move(z=0.005)
    wedges = ring_parts([(r, 0), (r, h)], [(r - wall, h), (r - wall, 0.006)])
    return shape([(body, _graduation((206, 222, 226))), (fluid, surfaces.plain(liquid))],
                 [*wedges, cylinder_part(r - wall, 0.005 + level)], opacity=0.62)  # fmt: skip


@category("flask", size=(0.09, 0.09, 0.155), mass=0.22, material="glass", hollow=True,
          aliases=("conical flask", "erlenmeyer flask", "erlenmeyer", "schlenk flask"),
          themes=("lab",), roles=("round", "tall"), colors=("blue", "green", "amber"),
          common=True)  # fmt: skip
def flask(look: Look) -> Shape:
    """A conical (Erlenmeyer) flask with liquid and a stopper."""
    r, h = look.between(0.04, 0.047), look.between(0.125, 0.145)
    neck = 0.3 * r
    liquid = look.color(*BEAKER_LIQUIDS)
    low = 0.38 * h
    at_low = r + (neck - r) * 0.38 / 0.68
    body = lathe([(0, 0), (r - 0.005, 0), (r, 0.005), (at_low, low), (neck, 0.68 * h),
                  (neck, 0.95 * h), (neck + 0.003, 0.97 * h), (neck, h), (0, h)],
                 v=[0, 0, 0.03, 0.42, 0.7, 0.93, 0.95, 0.98, 1])  # fmt: skip
    tile = surfaces.stack((surfaces.plain(liquid), 42), (_graduation((208, 224, 228)), 58))
    cork = cylinder(neck * 0.9, 0.022, 16, top=neck * 1.1).move(z=h - 0.004)
    stopper = look.own_color("tan", "black", "terracotta")
    return shape([(body, tile), (cork, surfaces.speckles(look.rng, stopper, 8))],
                 [hull_of(body), cylinder_part(neck * 1.05, 0.016, (0, 0, h))])  # fmt: skip


@category("test_tube_rack", size=(0.18, 0.058, 0.113), mass=0.28, material="wood", hollow=True,
          aliases=("rack of test tubes", "tube rack"), themes=("lab",), colors=("white", "blue"),
          opened="empty_tube_rack", common=True)  # fmt: skip
def test_tube_rack(look: Look) -> Shape:
    """A test tube rack: two boards that hold a row of stoppered tubes."""
    count = int(look.rng.integers(5, 7))
    pitch, depth = 0.029, 0.058
    length = pitch * count + 0.018
    wood = look.surface(look.color("white", "beige", "blue", "wooden"), "plastic")
    pieces = [(block(length, depth, 0.01, 0.004), wood),
              (block(length, depth, 0.007, 0.004).move(z=0.05), wood),
              (box(0.008, depth, 0.05).move(x=-(length - 0.01) / 2), wood),
              (box(0.008, depth, 0.05).move(x=(length - 0.01) / 2), wood)]  # fmt: skip
    for k in range(count):
        liquid = look.own_color(*BEAKER_LIQUIDS)
        x = pitch * (k - (count - 1) / 2)
        glass = surfaces.stack((surfaces.plain(liquid), 5), (_glass((190, 205, 212)), 4))
        cap = surfaces.plain(look.own_color("red", "blue", "charcoal", "green"))
        pieces.append((cylinder(0.0095, 0.092, 12).move(x=x, z=0.008), glass))
        pieces.append((cylinder(0.0115, 0.018, 12, bevel=0.002).move(x=x, z=0.095), cap))
    top = box_part(pitch * count - 0.006, 0.022, 0.056, (0, 0, 0.057))
    return shape(pieces, [box_part(length, depth, 0.057), top])


@category("petri_dish", size=(0.097, 0.097, 0.017), mass=0.035, material="glass", hollow=True,
          aliases=("culture dish", "evaporating dish", "watch glass"), themes=("lab",),
          roles=("round", "flat"), colors=("clear",), common=True)  # fmt: skip
def petri_dish(look: Look) -> Shape:
    """A shallow, round Petri dish with a lid and cultures inside."""
    r, h = look.between(0.044, 0.05), 0.017
    agar = look.color("cream", "amber", "pink", "mint")
    image = prints.canvas(128, 128, tint_color(agar, 1.1))
    for _ in range(14):
        x, y = look.rng.uniform(0.2, 0.8, 2)
        prints.disc(image, float(x), float(y), look.between(0.01, 0.045), tint_color(agar, 0.6))
    dish = cylinder(r, h, 32, bevel=0.0015)
    rim = torus(r, 0.0018, 32, 6).move(z=h - 0.002)
    return shape([(dish, image), (rim, _glass((180, 196, 202)))], [cylinder_part(r + 0.0015, h)])


@category("reagent_bottle", size=(0.076, 0.076, 0.145), mass=0.42, material="glass",
          aliases=("lab bottle", "chemical bottle", "reagent"), themes=("lab",), roles=("round",),
          colors=("brown", "clear"), common=True)  # fmt: skip
def reagent_bottle(look: Look) -> Shape:
    """A round laboratory bottle with a screw cap and a printed label."""
    r, h = look.between(0.034, 0.042), look.between(0.13, 0.16)
    glass = look.color("brown", "clear", "amber", "teal")
    name = look.pick(["NaCl", "H2O", "EtOH", "CuSO4", "HCl", "KOH"])
    body = lathe([(0, 0), (r - 0.004, 0), (r, 0.004), (r, 0.64 * h), (0.9 * r, 0.72 * h),
                  (0.45 * r, 0.8 * h), (0.45 * r, 0.84 * h), (0, 0.84 * h)],
                 v=[0, 0, 0.03, 0.6, 0.7, 0.85, 0.95, 1])  # fmt: skip
    print_ = prints.label(look.rng, name, look.own_color("navy", "red", "black"), (244, 244, 240))
    tile = surfaces.stack((surfaces.plain(glass), 14), (print_, 36), (surfaces.plain(glass), 50))
    cap = cylinder(0.55 * r, 0.16 * h, 20, bevel=0.002).move(z=0.84 * h)
    lid = surfaces.stripes([(40, 90, 170), (30, 74, 150)], 12, upright=True)
    if look.chance(0.5):
        lid = surfaces.plain(look.own_color("red", "black", "orange"))
    return shape([(body, tile), (cap, lid)], [cylinder_part(r, 0.66 * h),
                                              hull_part(body.vertices[body.vertices[:, 2] > 0.6
                                                                      * h]),
                                              cylinder_part(0.55 * r, 0.16 * h,
                                                            (0, 0, 0.84 * h))])  # fmt: skip


@category("pipette_box", size=(0.12, 0.085, 0.068), mass=0.12, material="plastic",
          aliases=("tip box", "pipette tip box"), themes=("lab",), colors=("blue", "yellow"),
          common=True)  # fmt: skip
def pipette_box(look: Look) -> Shape:
    """A box of pipette tips: a coloured lid over a clear lower part."""
    x, y, h = look.between(0.115, 0.125), look.between(0.08, 0.09), look.between(0.06, 0.075)
    lid = surfaces.speckles(look.rng, look.color("blue", "yellow", "green", "red", "violet"), 4)
    base = surfaces.grid((150, 160, 166), (214, 220, 224), 8, 12)
    rim = prism(rectangle(x, y, 0.008), 0.6 * h, h, 0.003)
    return shape(
        [(block(x - 0.004, y - 0.004, 0.61 * h, 0.006), base), (rim, lid)],
        [box_part(x - 0.004, y - 0.004, 0.6 * h), box_part(x, y, 0.4 * h, (0, 0, 0.6 * h))],
    )


@category("mortar", size=(0.11, 0.11, 0.1), mass=0.5, material="ceramic",
          aliases=("mortar and pestle", "pestle", "molcajete", "guacamole bowl"),
          themes=("lab", "kitchen"), roles=("round",), colors=("white",), common=True)  # fmt: skip
def mortar(look: Look) -> Shape:
    """A porcelain mortar with its pestle leaning inside."""
    r, h, wall = look.between(0.05, 0.058), look.between(0.055, 0.065), 0.008
    glaze = look.surface(look.color("white", "cream", "gray", "green"), "ceramic")
    foot = 0.6 * r
    body = lathe([(0, 0), (foot, 0), (0.92 * r, 0.5 * h), (r, h), (r - wall, h), (0.8 * r, 0.5 * h),
                  (0.4 * r, 0.014), (0, 0.012)])  # fmt: skip
    pestle = cylinder(0.012, 0.11, 16, top=0.008, bevel=0.004)
    pestle = pestle.turn(1, np.deg2rad(38)).move(-0.004, 0, 0.02)
    knob = ellipsoid(0.03, 0.03, 0.03, 16, 10).move(x=-0.002, z=0.027)
    wedges = ring_parts([(foot, 0), (0.92 * r, 0.5 * h), (r, h)],
                        [(r - wall, h), (0.75 * r, 0.4 * h), (foot, 0.013)])  # fmt: skip
    return shape([(body, glaze), (pestle, glaze), (knob, glaze)],
                 [*wedges, cylinder_part(foot, 0.013), hull_of(pestle)])  # fmt: skip


@category("empty_tube_rack", size=(0.2124, 0.0594, 0.0639), mass=0.15, material="wood",
          aliases=("vial stand",), themes=("lab",), roles=("big",), colors=("wooden",),
          holder=Holder("end", (0.04, 0.04, 0.22)))  # fmt: skip
def empty_tube_rack(look: Look) -> Shape:
    """An empty rack for test tubes: a board with holes above a base."""
    count, (a, b, c) = read_request(look, 6, (0.0214, 0.0214, 0.142))
    color = look.color("wooden", "white", "blue", "wooden", "beige")
    wood = look.surface(color, "wood")
    hole, wall, cells = max(a, b) / 2 + 0.001, 0.007, max(count, 4)
    pitch, top = 2 * hole + 0.009, max(0.45 * c, 0.03)
    x, y = pitch * cells + 0.016, 2 * hole + 0.036
    rail = (y - 2 * hole) / 2
    boards = [(x, y, wall, 0.0, 0.0, 0.0)]
    boards += [(0.007, y, top, s * (x - 0.007) / 2, 0.0, 0.0) for s in (-1, 1)]
    boards += [(x, rail, wall, 0.0, s * (hole + rail / 2), top - wall) for s in (-1, 1)]
    bars = centres(cells + 1, pitch)
    boards += [(pitch - 2 * hole, 2 * hole, wall, u, 0.0, top - wall) for u in bars]
    solids, parts = _boards(boards)
    slots = choose_slots(centres(cells, pitch), count, wall)
    return shape([(join(solids), wood)], parts, slots=slots)


@category("cryobox", size=(0.13, 0.13, 0.052), mass=0.3, material="plastic",
          aliases=("cryo box", "vial box", "box of vials", "freezer box", "sample box"),
          themes=("lab",), colors=("white",))  # fmt: skip
@from_pieces(bodies=1)
def cryobox(look: Look) -> Pieces:
    """A freezer box with a grid of vials and its lid beside it."""
    shell = plastic(look, "white", "sky", "yellow", "red", "green")
    body = at_box(0.13, 0.13, 0.04)
    vials = [disc(0.0062, 0.012, ((i - 3.5) * 0.0152, (j - 3.5) * 0.0152, 0.0395), sides=7)
             for i in range(8) for j in range(8)]  # fmt: skip
    tones = ("red", "blue", "yellow", "green")
    pieces: Pieces = [(body, shell)]
    for k, tone in enumerate(tones):
        pieces.append((join(vials[k::4]), dye(look, tone)))
    return pieces


CONDENSER_GLASS = surfaces.plain((210, 228, 232))
WHITE = surfaces.plain((242, 242, 240))


@category("condenser", size=(0.336, 0.096, 0.0346), mass=0.2, material="glass",
          aliases=("liebig condenser", "glass condenser", "fractionating column",
          "distillation column", "cooling condenser"), themes=("lab",), roles=("big",),
          colors=("clear",))  # fmt: skip
@from_pieces(foot=0.08, bodies=3)
def condenser(look: Look) -> Pieces:
    """A glass condenser lying flat: a jacket around a tube, with two side pipes."""
    z = 0.02
    jacket = spindle((-0.1, 0.008), (-0.09, 0.018), (0.09, 0.018), (0.1, 0.008), z=z)
    inner = spindle((-0.16, 0.007), (0.16, 0.007), z=z)
    bell = spindle((-0.19, 0.012), (-0.165, 0.011), (-0.155, 0.007), z=z)
    pipes = [rod([(x, 0, z), (x, s * 0.03, z), (x, s * 0.05, z)], 0.005, 8) for x,
             s in ((-0.07, 1), (0.07, -1))]  # fmt: skip
    blue = tint_color(look.color("clear", "sky"), 1.1)
    return [(jacket, surfaces.stripes([blue, tint_color(blue, 1.4), blue], 3)),
            (inner, CONDENSER_GLASS), (bell, CONDENSER_GLASS), (join(pipes[:1]), CONDENSER_GLASS),
            (join(pipes[1:]), CONDENSER_GLASS)]  # fmt: skip


@category("desiccator", size=(0.18, 0.18, 0.182), mass=1.5, material="glass",
          aliases=("glass desiccator", "vacuum desiccator", "bell jar"), themes=("lab",),
          colors=("clear",))  # fmt: skip
@from_pieces(bodies=2)
def desiccator(look: Look) -> Pieces:
    """A desiccator: a heavy glass bowl with a domed lid and a knob."""
    low = standing(
        (0.05, 0), (0.052, 0.01), (0.075, 0.05), (0.08, 0.085), (0.09, 0.09), (0.09, 0.098)
    )
    lid = standing((0.09, 0.099), (0.09, 0.106), (0.075, 0.125), (0.04, 0.15), (0.012, 0.156),
                   (0.018, 0.172), (0.012, 0.182))  # fmt: skip
    beads = torus(0.06, 0.002, 40, 5).move(z=0.085)
    color = look.color("clear", "sky", "amber")
    return [(low, surfaces.gradient(tint_color(color, 0.85), tint_color(color, 1.2), look.rng)),
            (lid, surfaces.gradient(tint_color(color, 1.2), tint_color(color, 1.5), look.rng)),
            (beads, WHITE)]  # fmt: skip


@category("reagent_reservoir", size=(0.13, 0.044, 0.025), mass=0.03, material="plastic",
          hollow=True, aliases=("pipette trough", "reagent trough", "reservoir"), themes=("lab",),
          roles=("container",), colors=("white",))  # fmt: skip
@from_pieces()
def reagent_reservoir(look: Look) -> Pieces:
    """A long, shallow plastic trough, open at the top."""
    tile = plastic(look, "white", "clear")
    sides = [at_box(0.13, 0.004, 0.025, (0, s * 0.02, 0)) for s in (-1, 1)] + [
        at_box(0.004, 0.044, 0.025, (s * 0.063, 0, 0)) for s in (-1, 1)
    ]
    floor = at_box(0.13, 0.044, 0.004)
    return [(floor, tile), *((s, tile) for s in sides)]


@category("microscope_slide", size=(0.076, 0.026, 0.0012), mass=0.005, material="glass",
          aliases=("glass slide", "specimen slide", "haemocytometer", "counting chamber",
          "prepared slide"), themes=("lab",), roles=("flat",), colors=("pink",))  # fmt: skip
@vary(0.08)
@from_pieces()
def microscope_slide(look: Look) -> Pieces:
    """A glass slide with a white end on the left and stained spots in a pale field."""
    color = look.color("pink", "purple", "clear", "sky")
    image = prints.canvas(96, 32, (216, 230, 234))
    prints.fill(image, 0, 0, 0.2, 1, (244, 244, 242))
    prints.fill(image, 0.42, 0.1, 0.26, 0.8, (230, 238, 240))
    for _ in range(14):
        prints.disc(image, look.between(0.46, 0.64), look.between(0.3, 0.7),
                    look.between(0.05, 0.12),
                    tint_color(color, look.between(0.8, 1.3)))  # fmt: skip
    return [(at_box(0.076, 0.026, 0.0012), image)]


@category("cover_slip", size=(0.022, 0.022, 0.0008), mass=0.0003, material="glass",
          aliases=("coverslip", "cover glass", "cover slide"), themes=("lab",), roles=("flat",),
          colors=("clear",))  # fmt: skip
@vary(0.08)
@from_pieces()
def cover_slip(look: Look) -> Pieces:
    """A very thin square of clear glass."""
    return [(at_box(0.022, 0.022, 0.0008), surfaces.plain(tint_color(look.color("clear", spread=4),
                                                                     1.2)))]  # fmt: skip


@category("pipette_tip", size=(0.05, 0.0068, 0.0068), mass=0.0005, material="plastic",
          aliases=("micropipette tip",), themes=("lab",), colors=("yellow",))  # fmt: skip
@at_rest
@from_pieces(foot=0.3)
def pipette_tip(look: Look) -> Pieces:
    """A pipette tip lying flat, which tapers from a collar on the left to a point on the right."""
    return [(spindle((-0.025, 0.0034), (-0.018, 0.0034), (-0.012, 0.0029), (0.025, 0.0005),
                     z=0.0034), plastic(look, "yellow", "sky", "clear", "white"))]  # fmt: skip


def _vial(cap: str) -> Drawing:
    """Return the drawing function of a small tube with a snap lid or a screw cap, lying flat."""

    def draw(look: Look) -> Pieces:
        color = look.color("clear", "sky", "pink", "mint", "amber")
        z = 0.0058
        liquid = surfaces.stack(
            (surfaces.plain(tint_color(color, 1.0)), 1), (surfaces.plain((226, 236, 240)), 1)
        )
        if cap == "snap":
            body = spindle((-0.016, 0.0054), (0.0, 0.0052), (0.018, 0.0022), (0.02, 0.001), z=z)
            rim = spindle((-0.0175, 0.0066), (-0.0155, 0.0066), z=z)
            lid = disc(0.0062, 0.003).turn(1, np.pi / 2).turn(2, 0.9).move(-0.021, 0.009, 0.0062)
            return [(body, liquid), (rim, surfaces.plain((216, 228, 234))),
                    (lid, surfaces.plain((216, 228, 234)))]  # fmt: skip
        body = spindle((-0.02, 0.0056), (0.017, 0.0056), (0.02, 0.003), z=z)
        top = spindle((-0.032, 0.0062), (-0.019, 0.0062), z=0.0062)
        return [(body, liquid), (top, plastic(look, "red", "blue", "green", "yellow", "purple"))]

    return draw


def _wells(rows: int, columns: int) -> Drawing:
    """Return the drawing function of a plate with small wells, some of which hold liquid."""

    def draw(look: Look) -> Pieces:
        shell = plastic(look, "clear", "white", "black")
        body = at_block(0.127, 0.085, 0.012, 0.004)
        image = prints.canvas(192, 128, (226, 234, 236))
        hue = look.own_color("pink", "yellow", "sky", "purple", "mint", "orange")
        for i in range(rows):
            for j in range(columns):
                x, y = (j + 0.7) / (columns + 0.4), (i + 0.7) / (rows + 0.4)
                r = 0.38 / (rows + 0.4)
                prints.disc(image, x, y, r, (150, 164, 170))
                shade = (
                    tint_color(hue, look.between(0.7, 1.7)) if look.chance(0.7) else (236, 240, 242)
                )
                prints.disc(image, x, y, 0.82 * r, shade)
        return [(body, shell), (at_box(0.123, 0.081, 0.0006, (0, 0, 0.0117)), image)]

    return draw


@category("pcr_strip", size=(0.082, 0.02, 0.0195), mass=0.01, material="plastic",
          aliases=("tube strip", "strip of tubes", "8 tube strip"), themes=("lab",),
          colors=("clear",))  # fmt: skip
@from_pieces(bodies=2)
def pcr_strip(look: Look) -> Pieces:
    """A strip of eight small capped tubes, standing in a low coloured rack."""
    tile = surfaces.plain(tint_color(look.color("clear", "sky", "white"), 1.1))
    tubes = [spindle((-0.0075, 0.0028), (0.003, 0.0026), (0.0095, 0.001),
                     z=0).turn(1, np.pi / 2).move((k - 3.5) * 0.009, 0, 0.0095)
             for k in range(8)]  # fmt: skip
    caps = [disc(0.0033, 0.003, ((k - 3.5) * 0.009, 0, 0.0165)) for k in range(8)]
    bar = at_box(0.07, 0.005, 0.0015, (0, 0, 0.0165))
    rack = at_block(0.082, 0.02, 0.008, 0.003)
    return [(rack, dye(look, "blue", "orange", "green")), (bar, tile), (join(tubes), tile),
            (join(caps), tile)]  # fmt: skip


CATEGORIES = (
    Category("eppendorf_tube", from_pieces(foot=0.1)(_vial("snap")), size=(0.045, 0.022, 0.0125),
             mass=0.001, material="plastic",
             aliases=("microcentrifuge tube", "microtube", "pcr tube", "eppendorf"),
             themes=("lab",), colors=("clear",)),
    Category("cryovial", from_pieces(foot=0.1)(_vial("screw")), size=(0.052, 0.0124, 0.0124),
             mass=0.003, material="plastic",
             aliases=("cryo tube", "screw cap tube", "small vial", "cryogenic vial"),
             themes=("lab",), colors=("red",)),
    Category("well_plate", from_pieces(bodies=1)(_wells(8, 12)), size=(0.127, 0.085, 0.0123),
             mass=0.05, material="plastic", aliases=("96 well plate", "microplate",
             "microtiter plate", "microtitre plate", "assay plate", "elisa plate",
             "multi well plate"), themes=("lab",), roles=("flat",), colors=("clear",)),
    Category("six_well_plate", from_pieces(bodies=1)(_wells(2, 3)), size=(0.127, 0.085, 0.0123),
             mass=0.06, material="plastic",
             aliases=("6 well plate", "culture plate", "cell culture plate"), themes=("lab",),
             roles=("flat",), colors=("clear",)),
)  # fmt: skip
"""Objects that share their drawing functions."""
