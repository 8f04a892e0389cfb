"""Pots, tins and dishes for the oven and the stove: woks, casseroles, loaf tins, steamers."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, frame_parts, hull_of
from ...build.outlines import rectangle, smooth
from ...build.recipes import open_vessel
from ...build.settled import hull_above
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe, loft, sweep, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

ENAMEL = ("red", "orange", "blue", "teal", "cream", "black", "sage", "charcoal", "navy")


def _ears(x: float, z: float, wide: float, reach: float, thick: float) -> list[Solid]:
    return [tube(smooth([(s * (x - 0.003), -wide, z), (s * (x + reach), -0.7 * wide, z + 0.004),
                         (s * (x + reach), 0.7 * wide, z + 0.004), (s * (x - 0.003), wide, z)], 4),
                 thick, 8) for s in (-1, 1)]  # fmt: skip


def _ear_parts(x: float, z: float, wide: float, reach: float) -> list:
    return [box_part(reach, 1.6 * wide, 0.01, (s * (x + 0.5 * reach), 0, z - 0.004))
            for s in (-1, 1)]  # fmt: skip


def wok(look: Look) -> Shape:
    """A wok: a wide round-bottomed pan with a long handle to the right and an ear."""
    r, h = look.between(0.14, 0.165), look.between(0.075, 0.09)
    color = look.color("charcoal", "black", "charcoal", "silver", "red")
    skin = look.surface(color, "metal")
    t = np.linspace(0.5, 1.42, 6)
    side = [(r * np.sin(a) / np.sin(1.42), h * (np.cos(0.5) - np.cos(a)) / (
        np.cos(0.5) - np.cos(1.42))) for a in t]  # fmt: skip
    body, parts = open_vessel(side, 0.003, 0.004, 32)
    inner = textures.scratches(look.rng, tint_color(color, 0.85), tint_color(color, 1.15), 30)
    grip = sweep(smooth([(0.96 * r, 0, h - 0.012), (r + 0.05, 0, h + 0.01), (r + 0.13, 0,
                 h + 0.025)], 4), rectangle(0.02, 0.011, 0.005, 3))  # fmt: skip
    ear = tube(
        smooth(
            [
                (-0.97 * r, -0.03, h - 0.004),
                (-r - 0.028, -0.02, h + 0.008),
                (-r - 0.028, 0.02, h + 0.008),
                (-0.97 * r, 0.03, h - 0.004),
            ],
            4,
        ),
        0.005,
        8,
    )
    wood = look.surface(look.own_color("wooden", "brown", "black"), "wood")
    lug = box_part(0.028, 0.05, 0.01, (-r - 0.014, 0, h - 0.002))
    return shape([(body, textures.stack((skin, 50), (inner, 50))), (grip, wood), (ear, wood)],
                 [*parts, hull_of(grip), lug])  # fmt: skip


def casserole(look: Look) -> Shape:
    """A round or oval enamelled casserole with its lid on."""
    r, h = look.between(0.105, 0.125), look.between(0.095, 0.115)
    color = look.color(*ENAMEL)
    grad = textures.gradient(tint_color(color, 0.75), color, look.rng)
    skin = grad if not look.material else look.surface(color, "metal")
    long = look.pick([1.0, 1.0, 1.25])
    body = lathe([(0, 0), (0.82 * r, 0), (0.95 * r, 0.1 * h), (r, 0.35 * h), (r, h), (0, h)], 36)
    lid = lathe([(0, h), (1.02 * r, h), (1.02 * r, 1.06 * h), (0.88 * r, 1.16 * h),
                 (0.3 * r, 1.27 * h), (0, 1.28 * h)], 36)  # fmt: skip
    knob = lathe([(0, 0), (0.01, 0), (0.009, 0.008), (0.021, 0.014), (0.019, 0.024), (0, 0.026)],
                 22).move(z=1.27 * h)  # fmt: skip
    seam = torus(1.005 * r, 0.0022, 40, 6).move(z=h)
    ears = _ears(long * r, 0.78 * h, 0.034, 0.026, 0.0075)
    steel = textures.plain(look.own_color("silver", "gold", "black"))
    solids = [s.scale(long, 1, 1) for s in (body, lid, seam)]
    return shape([(solids[0], skin), (solids[1], skin), (join(ears), skin), (knob, steel),
                  (solids[2], textures.plain(tint_color(color, 0.5)))],
                 [hull_of(solids[0]), hull_of(solids[1]), hull_of(knob),
                  *(hull_of(e) for e in ears)])  # fmt: skip


def _tin(look: Look, x: float, y: float, h: float, palette: tuple[str, ...], *,
         flare: float = 0.9, material: str = "metal", ears: float = 0.0) -> Shape:  # fmt: skip
    """Return an open rectangular tin with sloping walls and a rolled rim."""
    color = look.color(*palette)
    skin = look.surface(color, material)
    w = 0.004 if material == "metal" else 0.006
    unit = rectangle(1, 1, 0.1, 4)
    flat = np.full(len(unit), 0.0)
    levels = [(flare, 0), (1.0, h - 0.003), (1 + 6 * w / x, h - 0.003), (1 + 6 * w / x, h),
              (1 - 2 * w / x, h), (flare - 2 * w / x, w)]  # fmt: skip
    rings = np.stack([np.column_stack([unit * [x * k, y * (k - 1) * x / y + y], flat + z])
                      for k, z in levels])  # fmt: skip
    profile = np.array([(k * x / 2, z) for k, z in levels])
    body = loft(rings, unit, profile=profile)
    pieces = [(body, skin)]
    lean = 0.5 * (1 - flare) * x
    parts = [box_part(flare * x, flare * y, w)]
    for s in (-1, 1):
        for axis, (a, b) in enumerate(((x, y), (y, x))):
            low, high = 0.5 * a - lean, 0.5 * a
            ends = 0.5 * b
            points = [
                (s * u, v, z)
                for u, z in ((low, 0), (high, h), (low - w, 0), (high - w, h))
                for v in (-(ends - lean * (1 - z / h)), ends - lean * (1 - z / h))
            ]
            array = np.array(points)
            parts.append(
                hull_above(
                    Solid(
                        array if axis == 0 else array[:, [1, 0, 2]],
                        np.zeros((0, 3), int),
                        np.zeros((8, 2)),
                    )
                )
            )
    if ears:
        grips = _ears(x / 2 + 3 * w, h - 0.004, 0.035, ears, 0.005)
        pieces.append((join(grips), skin))
        parts += _ear_parts(x / 2 + 3 * w, h - 0.003, 0.035, ears)
    return shape(pieces, parts)


def roasting_tin(look: Look) -> Shape:
    """A deep rectangular roasting pan with handles."""
    return _tin(look, look.between(0.3, 0.35), look.between(0.22, 0.25), look.between(0.055, 0.068),
                ("silver", "charcoal", "black", "gray"), ears=0.022, flare=0.93)  # fmt: skip


def loaf_tin(look: Look) -> Shape:
    """A long narrow tin for a loaf."""
    return _tin(look, look.between(0.23, 0.27), look.between(0.11, 0.125), look.between(0.06, 0.07),
                ("silver", "charcoal", "black", "copper", "red"))  # fmt: skip


def baking_dish(look: Look) -> Shape:
    """A rectangular ceramic dish for the oven with small handles."""
    return _tin(look, look.between(0.26, 0.31), look.between(0.18, 0.21), look.between(0.05, 0.06),
                ("white", "red", "blue", "cream", "teal", "terracotta"), material="ceramic",
                flare=0.92, ears=0.018)  # fmt: skip


def cake_tin(look: Look) -> Shape:
    """A round tin with straight walls and a clasp at its side."""
    r, h = look.between(0.1, 0.125), look.between(0.058, 0.07)
    color = look.color("charcoal", "silver", "black", "copper", "red", "pink")
    skin = look.surface(color, "metal")
    body, parts = open_vessel([(0.97 * r, 0), (0.985 * r, 0.5 * h), (r, h)], 0.0025, 0.003, 40)
    rims = [torus(k * r, 0.0025, 40, 6).move(z=z) for k, z in ((1.0, h - 0.0015), (0.985, 0.004))]
    clasp = [box(0.036, 0.006, 0.01).move(0, -r - 0.002, 0.72 * h),
             box(0.008, 0.008, 0.4 * h).move(0.012, -r - 0.003, 0.4 * h)]  # fmt: skip
    steel = textures.brushed_metal(look.rng, (198, 200, 205))
    return shape([(body, skin), (join(rims), skin), (join(clasp), steel)],
                 [*parts, hull_of(*clasp)])  # fmt: skip


def pie_dish(look: Look) -> Shape:
    """A shallow round dish with a fluted rim."""
    r, h = look.between(0.12, 0.14), look.between(0.034, 0.042)
    color = look.color("white", "red", "cream", "blue", "terracotta", "sage")
    skin = look.surface(color, "ceramic")
    side = [(0.76 * r, 0), (0.86 * r, 0.5 * h), (0.92 * r, h - 0.003), (r, h)]
    body, parts = open_vessel(side, 0.005, 0.006, 48)

    def flute(p: np.ndarray) -> np.ndarray:
        up = np.clip(p[:, 2] / h - 0.7, 0, 1) * 3.3
        wave = 1 + 0.022 * up * np.sin(24 * np.arctan2(p[:, 1], p[:, 0]))
        return p * np.column_stack([wave, wave, np.ones(len(p))])

    return shape([(body.bend(flute), skin)], parts)


def cooling_rack(look: Look) -> Shape:
    """A wire rack on four short feet."""
    x, y, h = look.between(0.34, 0.4), look.between(0.23, 0.27), look.between(0.022, 0.03)
    color = look.color("silver", "silver", "black", "copper")
    skin = look.surface(color, "metal")
    rods = [tube([(-x / 2, s * y / 2, h), (x / 2, s * y / 2, h)], 0.003, 6) for s in (-1, 1)]
    rods += [tube([(s * x / 2, -y / 2, h), (s * x / 2, y / 2, h)], 0.003, 6) for s in (-1, 1)]
    rods += [tube([(u * x, -y / 2, h), (u * x, y / 2, h)], 0.0018, 6)
             for u in np.linspace(-0.5, 0.5, 18)[1:-1]]  # fmt: skip
    rods += [tube([(-x / 2, u * y, h - 0.003), (x / 2, u * y, h - 0.003)], 0.0024, 6)
             for u in (-0.25, 0.25)]  # fmt: skip
    feet = [tube([(a * 0.46 * x, b * 0.46 * y, h), (a * 0.47 * x, b * 0.47 * y, 0)], 0.003, 6)
            for a in (-1, 1) for b in (-1, 1)]  # fmt: skip
    return shape([(join([*rods, *feet]), skin)],
                 [box_part(x, y, 0.005, (0, 0, h - 0.003)),
                  *(box_part(0.01, 0.01, h, (a * 0.465 * x, b * 0.465 * y, 0))
                    for a in (-1, 1) for b in (-1, 1))])  # fmt: skip


def bamboo_steamer(look: Look) -> Shape:
    """A bamboo steamer of one or two tiers with its woven lid."""
    r, tier = look.between(0.09, 0.11), look.between(0.045, 0.055)
    color = look.color("tan", "beige", "wooden")
    count = look.pick([1, 2, 2])
    side = textures.stripes([tint_color(color, 0.8), color, color, color, tint_color(color, 0.8)],
                            1)  # fmt: skip
    rings, bands = [], []
    for k in range(count):
        rings.append(cylinder(r, tier - 0.002, 40).move(z=k * tier))
        bands += [cylinder(1.025 * r, 0.009, 40).move(z=k * tier + z)
                  for z in (0.0, tier - 0.013)]  # fmt: skip
    z = count * tier
    top = lathe([(0, z - 0.002), (1.03 * r, z - 0.002), (1.03 * r, z + 0.018), (0.97 * r, z + 0.02),
                 (0.5 * r, z + 0.03), (0, z + 0.033)], 40)  # fmt: skip
    weave = textures.basketwork(look.rng, color, 16)
    dome = lathe([(0, z + 0.015), (0.94 * r, z + 0.0195), (0.5 * r, z + 0.032), (0, z + 0.035)], 40)
    knob = torus(0.012, 0.004, 18, 8).turn(0, np.pi / 2).move(z=z + 0.036)
    dark = textures.speckles(look.rng, tint_color(color, 0.78), 8)
    return shape(
        [(join(rings), side), (join(bands), dark), (top, dark), (dome, weave), (knob, dark)],
        [cylinder_part(1.025 * r, z), hull_of(top, dome), hull_of(knob)],
    )


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
    dark = textures.plain(tint_color(color, 0.6))
    return shape([(join([base, *walls]), skin), (join(ridges), dark), (grip, skin)],
                 [*frame_parts(x, x, h, 0.005, 0.0115)[:1],
                  *(hull_of(w) for w in walls), hull_of(grip)])  # fmt: skip


def tagine(look: Look) -> Shape:
    """A shallow clay dish under a tall cone."""
    r, h = look.between(0.12, 0.14), look.between(0.19, 0.23)
    color = look.color("terracotta", "red", "orange", "navy", "teal", "cream")
    skin = look.surface(color, "stoneware")
    dish = lathe([(0, 0), (0.72 * r, 0), (r, 0.045), (1.02 * r, 0.055), (0, 0.055)], 36)
    cone = lathe([(0, 0.05), (0.94 * r, 0.05), (0.92 * r, 0.07), (0.5 * r, 0.13),
                  (0.2 * r, 0.82 * h), (0.16 * r, 0.88 * h), (0.24 * r, 0.96 * h),
                  (0.2 * r, h), (0, h)], 36)  # fmt: skip
    band = textures.stack((skin, 3), (textures.stripes([color, tint_color(look.own_color(
        "white", "gold", "sky"), 1.0)], 12, upright=True), 1), (skin, 4), side=128)  # fmt: skip
    return shape([(dish, skin), (cone, band if look.chance(0.5) else skin)],
                 [hull_of(dish), hull_of(cone)])  # fmt: skip


_K = ("kitchen",)
CATEGORIES = (
    Category("wok", wok, (0.471, 0.303, 0.113), 1.3, ("stir fry pan", "wok pan", "karahi",
             "kadai"), _K, ("container",
             "big"), ("charcoal",)),
    Category("casserole", casserole, (0.324, 0.234, 0.154), 3.2, ("dutch oven", "casserole dish",
             "cast iron pot", "casserole pot", "cocotte", "stew pot", "crock", "enamel pot"), _K,
             ("big",), ("red", "orange")),
    Category("roasting_tin", roasting_tin, (0.41, 0.253, 0.0636), 1, ("roasting pan",
             "roasting tray", "roaster", "roasting dish"), _K, ("container", "big"), ("silver",)),
    Category("loaf_tin", loaf_tin, (0.268, 0.143, 0.0642), 0.4, ("loaf pan", "bread tin",
             "bread pan"), _K, ("container",), ("silver", "charcoal")),
    Category("baking_dish", baking_dish, (0.37, 0.234, 0.0607), 1.3, ("gratin dish", "oven dish",
             "lasagna dish", "ovenproof dish", "casserole pan", "lasagne dish"), _K, ("container",
             "big"), ("white", "red")),
    Category("cake_tin", cake_tin, (0.223, 0.228, 0.0633), 0.5, ("cake pan", "springform pan",
                 "springform", "cake mould", "round baking tin", "springform tin",
                 "springform cake tin"), _K, ("container", "round", "big"),
             ("charcoal",)),
    Category("pie_dish", pie_dish, (0.265, 0.265, 0.0382), 0.8, ("pie tin", "pie plate",
             "quiche dish", "flan dish", "tart tin", "tart pan", "pie pan"), _K, ("container",
             "round", "big"), ("white",)),
    Category("cooling_rack", cooling_rack, (0.372, 0.258, 0.028), 0.4, ("wire rack", "cake rack",
             "baking rack", "cake cooling rack"), _K, ("support", "flat", "big"), ("silver",)),
    Category("bamboo_steamer", bamboo_steamer, (0.203, 0.203, 0.147), 0.45, ("steamer",
                 "dim sum steamer", "steamer basket", "dumpling steamer", "bamboo basket",
                 "tortilla warmer"), _K,
             ("round", "big"), ("tan",)),
    Category("griddle", griddle, (0.414, 0.254, 0.0496), 2, ("grill pan", "griddle pan", "comal",
             "tawa"),
             _K, ("container", "big"), ("charcoal",)),
    Category("tagine", tagine, (0.269, 0.269, 0.205), 2.6, ("tajine", "tagine pot"), _K, ("big",
             "tall", "round"), ("terracotta",)),
)  # fmt: skip
"""The module's categories."""
