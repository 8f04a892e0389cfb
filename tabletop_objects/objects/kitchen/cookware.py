"""Objects of the ``kitchen`` theme: cookware."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import glaze_tile
from ...kit.outlines import rectangle, smooth
from ...kit.parts import box_part, cylinder_part, frame_parts, hull_of, open_vessel, ring_parts
from ...kit.primitives import limb
from ...kit.shapes import Category, Pieces, Shape, category, keep_still, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, sweep, torus, tube
from ...kit.surfaces import RGB, Look, tint_color
from .appliances import metal
from .bakeware import _ears
from .utensils import bright_steel, steel, with_handle


@category("lid", size=(0.214, 0.214, 0.0552), mass=0.45, material="metal", aliases=("pot lid",
          "pan lid", "saucepan lid", "glass lid", "lid of a pot", "pitcher lid", "yoghurt lid",
          "yogurt lid", "plastic lid"), themes=("kitchen",), roles=("round", "flat"),
          colors=("silver",), state="lying flat")  # fmt: skip
def lid(look: Look) -> Shape:
    """A steel or glass pot lid with a knob, lying right side up."""
    r, h = look.between(0.09, 0.125), look.between(0.02, 0.032)
    color = look.color("silver", "silver", "red", "black", "blue", "copper", "white", "sage")
    body = lathe([(0, 0), (0.95 * r, 0), (r, 0.004), (r, 0.009), (0.75 * r, 0.66 * h),
                  (0.35 * r, 0.94 * h), (0, h)], 36)  # fmt: skip
    rim = lathe([(0.955 * r, 0.0005), (1.01 * r, 0.002), (1.01 * r, 0.01), (0.955 * r, 0.011)], 36,
                loop=True)  # fmt: skip
    knob = lathe([(0, 0), (0.009, 0), (0.009, 0.014), (0.02, 0.019), (0.018, 0.028),
                  (0, 0.03)], 22).move(z=h - 0.001)  # fmt: skip
    glass = look.chance(0.4)
    skin = surfaces.plain((178, 194, 200)) if glass else look.surface(color, "metal")
    tone = look.surface(look.own_color("black", "charcoal", "brown", "silver"), "plastic")
    return shape([(body, skin), (rim, bright_steel(look) if glass else skin), (knob, tone)],
                 [hull_of(body), hull_of(knob)])  # fmt: skip


ENAMEL = ("red", "orange", "blue", "teal", "cream", "black", "sage", "charcoal", "navy")


@category("wok", size=(0.471, 0.303, 0.113), mass=1.3, material="metal", hollow=True,
          aliases=("stir fry pan", "wok pan", "karahi", "kadai"), themes=("kitchen",),
          roles=("container", "big"), colors=("charcoal",))  # fmt: skip
def wok(look: Look) -> Shape:
    """A wide, round-bottomed wok with a long handle on the right and a loop handle."""
    r, h = look.between(0.14, 0.165), look.between(0.075, 0.09)
    color = look.color("charcoal", "black", "charcoal", "silver", "red")
    skin = look.surface(color, "metal")
    t = np.linspace(0.5, 1.42, 6)
    side = [(r * np.sin(a) / np.sin(1.42), h * (np.cos(0.5) - np.cos(a)) / (
        np.cos(0.5) - np.cos(1.42))) for a in t]  # fmt: skip
    body, parts = open_vessel(side, 0.003, 0.004, 32)
    inner = surfaces.scratches(look.rng, tint_color(color, 0.85), tint_color(color, 1.15), 30)
    grip = sweep(smooth([(0.96 * r, 0, h - 0.012), (r + 0.05, 0, h + 0.01), (r + 0.13, 0,
                 h + 0.025)], 4), rectangle(0.02, 0.011, 0.005, 3))  # fmt: skip
    ear = tube(smooth([(-0.97 * r, -0.03, h - 0.004), (-r - 0.028, -0.02, h + 0.008),
                       (-r - 0.028, 0.02, h + 0.008), (-0.97 * r, 0.03, h - 0.004)], 4), 0.005,
               8)  # fmt: skip
    wood = look.surface(look.own_color("wooden", "brown", "black"), "wood")
    lug = box_part(0.028, 0.05, 0.01, (-r - 0.014, 0, h - 0.002))
    return shape([(body, surfaces.stack((skin, 50), (inner, 50))), (grip, wood), (ear, wood)],
                 [*parts, hull_of(grip), lug])  # fmt: skip


@category("casserole", size=(0.324, 0.234, 0.154), mass=3.2, material="metal", hollow=True,
          aliases=("dutch oven", "casserole dish", "cast iron pot", "casserole pot", "cocotte",
          "stew pot", "crock", "enamel pot"), themes=("kitchen",), roles=("big",),
          colors=("red", "orange"), opened="open_pot")  # fmt: skip
def casserole(look: Look) -> Shape:
    """A round or oval enamelled casserole with its lid on."""
    r, h = look.between(0.105, 0.125), look.between(0.095, 0.115)
    color = look.color(*ENAMEL)
    grad = surfaces.gradient(tint_color(color, 0.75), color, look.rng)
    skin = grad if not look.material else look.surface(color, "metal")
    long = look.pick([1.0, 1.0, 1.25])
    body = lathe([(0, 0), (0.82 * r, 0), (0.95 * r, 0.1 * h), (r, 0.35 * h), (r, h), (0, h)], 36)
    lid = lathe([(0, h), (1.02 * r, h), (1.02 * r, 1.06 * h), (0.88 * r, 1.16 * h),
                 (0.3 * r, 1.27 * h), (0, 1.28 * h)], 36)  # fmt: skip
    knob = lathe([(0, 0), (0.01, 0), (0.009, 0.008), (0.021, 0.014), (0.019, 0.024), (0, 0.026)],
                 22).move(z=1.27 * h)  # fmt: skip
    seam = torus(1.005 * r, 0.0022, 40, 6).move(z=h)
    ears = _ears(long * r, 0.78 * h, 0.034, 0.026, 0.0075)
    steel = surfaces.plain(look.own_color("silver", "gold", "black"))
    solids = [s.scale(long, 1, 1) for s in (body, lid, seam)]
    return shape([(solids[0], skin), (solids[1], skin), (join(ears), skin), (knob, steel),
                  (solids[2], surfaces.plain(tint_color(color, 0.5)))],
                 [hull_of(solids[0]), hull_of(solids[1]), hull_of(knob),
                  *(hull_of(e) for e in ears)])  # fmt: skip


@category("bamboo_steamer", size=(0.203, 0.203, 0.147), mass=0.45, material="wood", hollow=True,
          aliases=("steamer", "dim sum steamer", "steamer basket", "dumpling steamer",
          "bamboo basket", "tortilla warmer"), themes=("kitchen",), roles=("round", "big"),
          colors=("tan",), opened="open_steamer")  # fmt: skip
def bamboo_steamer(look: Look) -> Shape:
    """A bamboo steamer of one or two tiers with its woven lid."""
    r, tier = look.between(0.09, 0.11), look.between(0.045, 0.055)
    color = look.color("tan", "beige", "wooden")
    count = look.pick([1, 2, 2])
    side = surfaces.stripes([tint_color(color, 0.8), color, color, color, tint_color(color, 0.8)],
                            1)  # fmt: skip
    rings, bands = [], []
    for k in range(count):
        rings.append(cylinder(r, tier - 0.002, 40).move(z=k * tier))
        bands += [cylinder(1.025 * r, 0.009, 40).move(z=k * tier + z)
                  for z in (0.0, tier - 0.013)]  # fmt: skip
    z = count * tier
    top = lathe([(0, z - 0.002), (1.03 * r, z - 0.002), (1.03 * r, z + 0.018), (0.97 * r, z + 0.02),
                 (0.5 * r, z + 0.03), (0, z + 0.033)], 40)  # fmt: skip
    weave = surfaces.basketwork(look.rng, color, 16)
    dome = lathe([(0, z + 0.015), (0.94 * r, z + 0.0195), (0.5 * r, z + 0.032), (0, z + 0.035)], 40)
    knob = torus(0.012, 0.004, 18, 8).turn(0, np.pi / 2).move(z=z + 0.036)
    dark = surfaces.speckles(look.rng, tint_color(color, 0.78), 8)
    return shape(
        [(join(rings), side), (join(bands), dark), (top, dark), (dome, weave), (knob, dark)],
        [cylinder_part(1.025 * r, z), hull_of(top, dome), hull_of(knob)],
    )


@category("griddle", size=(0.414, 0.254, 0.0496), mass=2, material="metal", hollow=True,
          aliases=("grill pan", "griddle pan", "comal", "tawa"), themes=("kitchen",),
          roles=("container", "big"), colors=("charcoal",))  # fmt: skip
def griddle(look: Look) -> Shape:
    """A flat square grill pan with ridges and a handle."""
    x, h = look.between(0.24, 0.27), look.between(0.03, 0.04)
    color = look.color("charcoal", "black", "red", "navy")
    skin = look.surface(color, "metal")
    base = block(x, x, 0.008, 0.03)
    walls = [box(x - 0.03, 0.005, h).move(y=s * (x / 2 - 0.0025)) for s in (-1, 1)]
    walls += [box(0.005, x - 0.03, h).move(x=s * (x / 2 - 0.0025)) for s in (-1, 1)]
    ridges = [
        box(0.84 * x, 0.007, 0.004).move(y=u * x, z=0.0075) for u in np.linspace(-0.4, 0.4, 9)
    ]
    grip = sweep([(0.49 * x, 0, h - 0.008), (0.6 * x, 0, h), (0.5 * x + 0.16, 0, h + 0.008)],
                 rectangle(0.028, 0.014, 0.006, 3))  # fmt: skip
    dark = surfaces.plain(tint_color(color, 0.6))
    return shape([(join([base, *walls]), skin), (join(ridges), dark), (grip, skin)],
                 [*frame_parts(x, x, h, 0.005, 0.0115)[:1],
                  *(hull_of(w) for w in walls), hull_of(grip)])  # fmt: skip


@category("tagine", size=(0.269, 0.269, 0.205), mass=2.6, material="ceramic", hollow=True,
          aliases=("tajine", "tagine pot"), themes=("kitchen",), roles=("big", "tall", "round"),
          colors=("terracotta",))  # fmt: skip
def tagine(look: Look) -> Shape:
    """A tagine: a shallow clay dish under a tall cone."""
    r, h = look.between(0.12, 0.14), look.between(0.19, 0.23)
    color = look.color("terracotta", "red", "orange", "navy", "teal", "cream")
    skin = look.surface(color, "stoneware")
    dish = lathe([(0, 0), (0.72 * r, 0), (r, 0.045), (1.02 * r, 0.055), (0, 0.055)], 36)
    cone = lathe([(0, 0.05), (0.94 * r, 0.05), (0.92 * r, 0.07), (0.5 * r, 0.13),
                  (0.2 * r, 0.82 * h), (0.16 * r, 0.88 * h), (0.24 * r, 0.96 * h),
                  (0.2 * r, h), (0, h)], 36)  # fmt: skip
    band = surfaces.stack((skin, 3), (surfaces.stripes([color, tint_color(look.own_color(
        "white", "gold", "sky"), 1.0)], 12, upright=True), 1), (skin, 4), side=128)  # fmt: skip
    return shape([(dish, skin), (cone, band if look.chance(0.5) else skin)],
                 [hull_of(dish), hull_of(cone)])  # fmt: skip


@category("open_steamer", size=(0.2, 0.2, 0.054), mass=0.25, material="wood",
          aliases=("open bamboo steamer",), themes=("kitchen",),
          roles=("container", "round", "big"), colors=("tan",))  # fmt: skip
def open_steamer(look: Look) -> Shape:
    """One tier of a bamboo steamer, without its lid."""
    r, h = look.between(0.09, 0.11), look.between(0.05, 0.058)
    color = look.color("tan", "beige", "wooden")
    body, parts = open_vessel([(r, 0), (r, h)], 0.005, 0.008)
    weave = surfaces.basketwork(look.rng, color, 16)
    dark = surfaces.speckles(look.rng, tint_color(color, 0.78), 8)
    inside = surfaces.speckles(look.rng, color, 8)
    skin = surfaces.stack((dark, 0.08), (weave, 0.3), (dark, 0.08), (inside, 0.54), side=128)
    return shape([(body, skin)], parts)


@category("open_pot", size=(0.263, 0.218, 0.1125), mass=0.9, material="metal",
          aliases=("open pot", "pot without a lid"), themes=("kitchen",),
          roles=("container", "round", "big"), colors=("silver",))  # fmt: skip
def open_pot(look: Look) -> Shape:
    """A cooking pot without its lid."""
    r, h = look.between(0.1, 0.118), look.between(0.1, 0.125)
    color = look.color("silver", "silver", "red", "black", "blue", "copper", "cream")
    skin = look.surface(color, "metal")
    body, parts = open_vessel([(0.97 * r, 0), (r, 0.06 * h), (r, h)], 0.003, 0.006, 40)
    ears = [tube(smooth([(s * 0.99 * r, -0.03, 0.8 * h), (s * (r + 0.022), -0.02, 0.82 * h),
                         (s * (r + 0.022), 0.02, 0.82 * h), (s * 0.99 * r, 0.03, 0.8 * h)], 3),
                 0.0045, 8) for s in (-1, 1)]  # fmt: skip
    return shape([(body, skin), *((e, skin) for e in ears)], [*parts, *map(hull_of, ears)])


@category("pot", size=(0.265, 0.21, 0.13), mass=1.1, material="metal", hollow=True,
          aliases=("cooking pot", "saucepan", "stockpot", "billy can", "billycan"),
          themes=("kitchen",), roles=("big",), colors=("silver", "red"), opened="open_pot",
          common=True)  # fmt: skip
def pot(look: Look) -> Shape:
    """A tall, low or bulbous cooking pot with two handles, open or with a steel or glass lid."""
    r, h, wall = look.between(0.09, 0.118), look.between(0.085, 0.135), 0.003
    color = look.color(
        "silver", "silver", "red", "black", "blue", "copper", "cream", "teal", "orange", "sage"
    )
    kind, open_, metal = look.pick(["drum", "drum", "belly"]), look.chance(0.45), look.chance(0.5)
    skin = look.surface(color, "metal" if metal else "plastic")
    inside = look.pick([skin, surfaces.brushed_metal(look.rng, (176, 178, 182)),
                        surfaces.plain((236, 232, 222))])  # fmt: skip
    dark = surfaces.speckles(
        look.rng, look.own_color("charcoal", "black", "brown", "silver"), 3, 32
    )
    tile = surfaces.stack((skin, 50), (inside, 50), side=128)
    if not metal and look.chance(0.4):  # enamel with a printed band or dots
        tile = surfaces.stack((glaze_tile(look, color), 50), (inside, 50), side=192)
    foot, mid = (0.96, 1.0) if kind == "drum" else (0.74, 1.04)
    side = [(foot * r, 0), (mid * r, 0.3 * h), (r, 0.7 * h), (r, h)]
    if kind == "drum":
        side[1] = (r, 0.06 * h)
    inner = [(x - wall, max(z, 0.006)) for x, z in side[::-1]]
    body = lathe([(0, 0), *side, *inner, (0, 0.006)],
                 v=[0, 0.02, 0.16, 0.34, 0.49, 0.51, 0.66, 0.84, 0.98, 1])  # fmt: skip
    ears = [
        tube(smooth([(side * 0.99 * r, -0.03, 0.8 * h), (side * (r + 0.024), -0.022, 0.82 * h),
                     (side * (r + 0.024), 0.022, 0.82 * h), (side * 0.99 * r, 0.03, 0.8 * h)], 3),
             0.0055, 8)
        for side in (-1, 1)
    ]  # fmt: skip
    pieces = [(body, tile), *((ear, dark) for ear in ears)]
    ends = [box_part(0.026, 0.055, 0.011, (s * (r + 0.012), 0, 0.78 * h)) for s in (-1, 1)]
    if open_:
        walls = ring_parts(side, [(r - wall, h), (foot * r - wall, 0.006)])
        return shape(pieces, [*walls, cylinder_part(foot * r, 0.006), *ends])
    lid = lathe([(0, h), (r, h), (1.01 * r, h + 0.003), (0.7 * r, h + 0.014), (0, h + 0.019)])
    knob = lathe([(0, h + 0.016), (0.007, h + 0.017), (0.007, h + 0.03), (0.016, h + 0.034),
                  (0.013, h + 0.043), (0, h + 0.044)], 20)  # fmt: skip
    glass = look.chance(0.35)
    pieces += [(lid, surfaces.plain((166, 182, 188)) if glass else skin), (knob, dark)]
    if glass:
        band = lathe([(0.96 * r, h), (1.015 * r, h), (1.015 * r, h + 0.005), (0.96 * r, h + 0.005)],
                     32, loop=True)  # fmt: skip
        pieces.append((band, surfaces.plain((190, 192, 196))))
    trunk = hull_of(body)
    return shape(pieces, [trunk, *ends, hull_of(lid), hull_of(knob)])


@category("pan", size=(0.4, 0.225, 0.062), mass=0.9, material="metal", hollow=True,
          aliases=("frying pan", "skillet", "bed warmer", "copper pan"), themes=("kitchen",),
          roles=("container", "big"), colors=("charcoal",), common=True)  # fmt: skip
def pan(look: Look) -> Shape:
    """A frying pan, skillet, saute pan or wok with its handle on the right."""
    r, h, wall = look.between(0.098, 0.128), look.between(0.036, 0.05), 0.0035
    kind = look.pick(["fry", "fry", "saute", "wok"])
    low = r * {"fry": 0.8, "saute": 0.97, "wok": 0.5}[kind]
    color = look.color(
        "charcoal", "black", "red", "copper", "silver", "teal", "cream", "blue", "sage"
    )
    coat = look.pick(
        [(62, 64, 68), (44, 44, 47), (172, 174, 178), (196, 150, 110), (210, 206, 196)]
    )
    inside = surfaces.scratches(
        look.rng, coat, tint_color(coat, 1.12), int(look.rng.integers(2, 40))
    )
    body = lathe([(0, 0), (low, 0), (r, h), (r - wall, h), (low - wall, 0.006), (0, 0.006)],
                 v=[0, 0.25, 0.48, 0.52, 0.75, 1])  # fmt: skip
    skin = look.surface(color, look.pick(["plastic", "metal"]))
    tile = surfaces.stack((skin, 1), (inside, 1), side=128)
    long = look.between(0.15, 0.2)
    grip = sweep(
        smooth([(0.95 * r, 0, 0.75 * h), (r + 0.3 * long, 0, 1.1 * h), (r + long, 0, 1.25 * h)], 4),
        rectangle(look.between(0.018, 0.026), 0.012, 0.005, 2),
    )  # fmt: skip
    shaft = look.own_color("black", "brown", "charcoal", "silver", "tan")
    handle_tile = look.surface(shaft, look.pick(["plastic", "wood"]))
    walls = ring_parts([(low, 0), (r, h)], [(r - wall, h), (low - wall, 0.006)])
    pieces = [(body, tile), (grip, handle_tile)]
    if look.chance(0.2):  # a fried egg
        white = cylinder(0.045, 0.003, 18, bevel=0.001).scale(1, 0.85, 1)
        yolk = ellipsoid(0.03, 0.03, 0.014, 14, 8)
        pieces += [(white.move(-0.01, 0.008, 0.006), surfaces.plain((246, 244, 236))),
                   (yolk.move(-0.012, 0.01, 0.009), surfaces.plain((244, 180, 40)))]  # fmt: skip
    return shape(pieces, [*walls, cylinder_part(low, 0.006), hull_of(grip)])


Head = Callable[[Look, RGB, float], Pieces]
"""Makes the head that starts at x = 0 and reaches to the left, at height z."""


def _mesh_disc(r: float) -> Head:
    def make(look: Look, color: RGB, z: float) -> Pieces:
        mesh = cylinder(r, 0.0012, 36).move(-r, 0, z)
        rim = torus(r, 0.0028, 40, 6).move(-r, 0, z + 0.0006)
        return [(mesh, prints.mesh_holes((206, 208, 212), (120, 124, 130), 26, 26)),
                (rim, steel(look))]  # fmt: skip

    return make


@category("gaiwan", size=(0.115, 0.115, 0.0941), mass=0.22, material="ceramic",
          aliases=("lidded tea bowl", "chinese tea bowl", "lidded cup"), themes=("kitchen",),
          roles=("round",), colors=("white",))  # fmt: skip
def gaiwan(look: Look) -> Shape:
    """A gaiwan: a Chinese tea bowl with a lid and a saucer."""
    k, color = look.between(0.88, 1.1), look.color("white", "sky", "mint", "teal", "cream", "red")
    saucer = lathe(
        [(0, 0), (0.03, 0), (0.055, 0.012), (0.056, 0.015), (0.03, 0.005), (0, 0.005)], 32
    )
    bowl = lathe([(0, 0.005), (0.02, 0.005), (0.022, 0.012), (0.036, 0.034), (0.046, 0.06),
                  (0.048, 0.064), (0, 0.064)], 32)  # fmt: skip
    lid = lathe([(0, 0.062), (0.041, 0.062), (0.03, 0.076), (0.012, 0.08), (0.015, 0.09),
                 (0.013, 0.092), (0, 0.088)], 28)  # fmt: skip
    image = surfaces.fit(look.surface(color, "ceramic"), 96, 192).copy()
    ink = tint_color(look.own_color("blue", "navy", "red", "green"), 1.0)
    for n in range(5):
        x = 0.1 + 0.2 * n
        prints.stroke(image, [(x - 0.06, 0.6), (x, 0.42), (x + 0.05, 0.62)], 0.02, ink)
        prints.disc(image, x, 0.42, 0.06, ink)
    made = [(join([saucer, lid]), look.surface(color, "ceramic")), (bowl, image)]
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made, [hull_of(saucer.scale(k, k, k)), hull_of(made[1][0]), hull_of(lid.scale(k, k, k))]
    )


@category("fondue_set", size=(0.275, 0.248, 0.253), mass=1.4, material="metal", assembled=True,
          aliases=("fondue", "fondue pot", "cheese fondue", "chocolate fondue"),
          themes=("kitchen",), roles=("big",), colors=("red",))  # fmt: skip
def fondue_set(look: Look) -> Shape:
    """A fondue set: a pot of melted cheese on a stand over a burner, with long forks."""
    k, color = look.between(0.88, 1.06), look.color("red", "orange", "black", "silver", "blue")
    pot = lathe([(0, 0.085), (0.06, 0.085), (0.08, 0.1), (0.085, 0.16), (0.079, 0.16),
                 (0.076, 0.145), (0, 0.145)], 30)  # fmt: skip
    cheese = cylinder(0.077, 0.002, 28).move(z=0.146)
    ring = torus(0.07, 0.004, 30, 6).move(z=0.09)
    legs = [tube(smooth([(0.07 * np.cos(a), 0.07 * np.sin(a), 0.09),
                         (0.085 * np.cos(a), 0.085 * np.sin(a), 0.05),
                         (0.09 * np.cos(a), 0.09 * np.sin(a), 0)], 3), 0.005, 7)
            for a in np.arange(3) * 2.094 + 0.5]  # fmt: skip
    foot = torus(0.09, 0.004, 30, 6).move(z=0.004)
    lamp = lathe([(0, 0), (0.03, 0), (0.03, 0.03), (0.02, 0.04), (0, 0.04)], 18)
    grip = limb([(0.08, 0, 0.145), (0.12, 0, 0.15), (0.17, 0, 0.155)], [0.007, 0.009, 0.01], 8)
    forks = [tube([(0.03 * np.cos(a), 0.03 * np.sin(a), 0.146), (0.12 * np.cos(a), 0.12 * np.sin(a),
                                                                 0.24)], 0.0018, 6)
             for a in (1.2, 2.5, 4.2)]  # fmt: skip
    tips = [tube([(0.1 * np.cos(a), 0.1 * np.sin(a), 0.219), (0.14 * np.cos(a), 0.14 * np.sin(a),
                                                              0.261)], 0.0045, 7)
            for a in (1.2, 2.5, 4.2)]  # fmt: skip
    made = [(pot, look.surface(color, "plastic")), (cheese, surfaces.speckles(look.rng,
                                                                              (250, 214, 110), 8)),
            (join([ring, *legs, foot, lamp, *forks]), metal(look)),
            (join([grip, *tips]), surfaces.plain((50, 36, 30)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(*[s.scale(k, k, k) for s in (*legs, foot)]), hull_of(made[0][0]),
                        hull_of(grip.scale(k, k, k)), hull_of(*[s.scale(k, k, k)
                                                                for s in tips])])  # fmt: skip


CATEGORIES = (
    Category("splatter_guard", keep_still(with_handle(_mesh_disc(0.13), (0.1, 0.13), 0.02)),
             size=(0.396, 0.263, 0.0209), mass=0.2, material="metal", assembled=True,
             aliases=("splatter screen", "frying pan guard"), themes=("kitchen",),
             colors=("black", "red"), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
