"""Pieces of fruit: rings, segments, peels, cores."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of, hull_part, ring_parts
from ...build.forms import above
from ...build.outlines import arc
from ...build.settled import limb, settle
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, ellipsoid, join, lathe, loft, prism, sweep, tube
from ...build.variants import keep_still
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look


def _ring(
    r: tuple[float, float], core: float, thick: float, palette: tuple[str, ...], rim: float
) -> Callable[[Look], Shape]:
    """Return the shape function of a ring cut from a fruit."""

    def make(look: Look) -> Shape:
        size, color = look.between(*r), look.color(*palette)
        t = thick * look.between(0.85, 1.2)
        profile = [(core * size, 0), (size, 0), (size, t), (core * size, t)]
        body = lathe(profile, 30, v=[0, 0.3, 0.6, 0.95], loop=True)
        y, x = np.mgrid[0:64, 0:128]
        lines = 0.9 + 0.1 * np.sin(x * 2 * np.pi * 24 / 128)[..., None]
        tile = np.array(color) * lines * np.where((y < 34)[..., None], 1.0, rim)
        wall = ring_parts([(size, 0), (size, t)], [(core * size, t), (core * size, 0)], 12)
        return shape([(body, np.clip(tile, 0, 255).astype(np.uint8))], wall)

    return make


def lotus_root(look: Look) -> Shape:
    """A slice of lotus root: a disc with a ring of holes."""
    r, t = look.between(0.026, 0.036), look.between(0.007, 0.011)
    color = look.color("ivory", "cream", "beige")
    body = cylinder(r, t, 28, bevel=0.0008)
    image = np.full((128, 128, 3), np.array(color), np.uint8)
    rows, columns = np.mgrid[0:128, 0:128] / 127 * 2 - 1
    count = look.pick([7, 8, 9])
    holes = [(0.0, 0.0, 0.13), *[(0.58 * np.cos(a), 0.58 * np.sin(a), 0.19)
             for a in 2 * np.pi * np.arange(count) / count]]  # fmt: skip
    for x, y, hole in holes:
        image[np.hypot(columns - x, rows - y) < hole] = np.array((110, 78, 52), np.uint8)
    face = cylinder(0.96 * r, 0.0006, 28).move(z=t - 0.0003)
    return shape([(body, textures.plain(tint_color(color, 0.75))), (face, image)], [hull_of(body)])


def _wedge(
    d: tuple[float, float], span: float, flesh: RGB, palette: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """Return the shape function of a segment or slice of a round fruit, lying on its side."""

    def make(look: Look) -> Shape:
        r, color = look.between(*d) / 2, look.color(*palette)
        inner = textures.speckles(look.rng, flesh, 10)
        half = span * look.between(0.85, 1.15)
        t = np.linspace(-np.pi / 2, np.pi / 2, 13)
        rings = []
        for a in t:
            out = r * np.cos(a)
            rim = [(out * np.cos(b), out * np.sin(b)) for b in np.linspace(-half, half, 6)]
            rings.append([(x, r * np.sin(a) * 1.02, z) for x, z in ((0.0, 0.0), *rim)])
        points = np.array(rings)
        points[[0, -1]] = points[[0, -1]].mean(1, keepdims=True) + 1e-5 * (
            points[[0, -1]] - points[[0, -1]].mean(1, keepdims=True))  # fmt: skip
        flat = np.array(
            [(0.0, 0.0), *[(np.cos(b), np.sin(b)) for b in np.linspace(-half, half, 6)]]
        )
        body = loft(points, flat)
        body = body.turn(1, -half).move(x=-0.5 * r)
        low = float(body.bounds[0, 2])
        body = body.move(z=-low)
        skin_ = _crescent(r, half).turn(1, -half).move(x=-0.5 * r, z=-low)
        peel = textures.spots(look.rng, color, tint_color(color, 0.88), 0.1)
        return shape([(body, inner), (skin_, peel)], [hull_part(above(body.vertices))])

    return make


def _crescent(r: float, half: float) -> Solid:
    """Return the peel over a segment."""
    rings = []
    for a in np.linspace(-1.5, 1.5, 13):
        rim = [(r * k * np.cos(a) * np.cos(b), r * k * np.cos(a) * np.sin(b))
               for k, way in ((0.985, 1), (1.03, -1)) for b in np.linspace(-half, half,
                   6)[::-way]]  # fmt: skip
        rings.append([(x, 1.03 * r * np.sin(a), z) for x, z in rim])
    flat = np.array([(k * np.cos(b), k * np.sin(b))
                     for k, way in ((0.9, 1), (1.0, -1)) for b in np.linspace(-half, half,
                         6)[::-way]])  # fmt: skip
    return loft(np.array(rings), flat)


def banana_peel(look: Look) -> Shape:
    """A banana skin thrown down: four strips spread from the stalk, pale inside."""
    color = look.color("yellow", "gold", "yellow", "lime")
    k, strips, insides = look.between(0.85, 1.15), [], []
    for n in range(4):
        a = np.pi / 2 * n + look.between(-0.35, 0.35)
        long = look.between(0.1, 0.14)
        path = np.array([(0.004, 0, 0.036), (0.2 * long, 0, 0.034), (0.45 * long, 0, 0.016),
                         (0.7 * long, 0, 0.004), (long, 0.012, 0.003)])  # fmt: skip
        sizes = [0.008, 0.016, 0.021, 0.018, 0.004]
        strips.append(limb(path, sizes, 10, 0.16).turn(2, a))
        insides.append(
            limb(np.add(path, (0, 0, 0.0014)), [0.66 * s for s in sizes], 10, 0.17).turn(2, a)
        )
    stalk = limb(
        [(0, 0, 0.034), (0, 0.002, 0.05), (0.005, 0.004, 0.062)], [0.011, 0.006, 0.005], 10
    )
    peel = textures.spots(look.rng, color, (120, 90, 40), 0.03)
    made = [(join([*strips, stalk]), peel), (join(insides), textures.plain((250, 240, 206)))]
    return settle(made, 0.01).scale(k)


def apple_core(look: Look) -> Shape:
    """An eaten apple: red ends, a thin pale middle with pips, its stalk, lying."""
    color = look.color("red", "green", "crimson", "yellow", "lime")
    d, h = look.between(0.058, 0.07), look.between(0.062, 0.072)
    thin = look.between(0.16, 0.22)
    body = lathe([(0, 0), (0.2 * d, 0), (0.36 * d, 0.08 * h), (0.34 * d, 0.2 * h),
                  (thin * d, 0.36 * h), (thin * d, 0.6 * h), (0.34 * d, 0.8 * h),
                  (0.4 * d, 0.88 * h), (0.3 * d, 0.98 * h), (0, 0.94 * h)], 26)  # fmt: skip
    pale = textures.speckles(look.rng, (246, 232, 190), 10)
    peel = textures.speckles(look.rng, color, 10)
    tile = textures.stack((peel, 0.3), (pale, 0.4), (peel, 0.3))
    pips = [ellipsoid(0.005, 0.004, 0.008, 8, 5).move(thin * d * np.cos(a), thin * d * np.sin(a),
            0.48 * h) for a in (0.4, 2.6, 4.5)]  # fmt: skip
    stalk = tube([(0, 0, 0.9 * h), (0.004, 0, 1.2 * h)], 0.0014, 6)
    dark = textures.plain((74, 48, 34))
    made = [(body, tile), (join([*pips, stalk]), dark)]
    return settle([(s.turn(1, np.pi / 2), t) for s, t in made], 0.08)


def _peel_strip(palette: tuple[str, ...], sugar: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a curled strip of citrus peel."""

    def make(look: Look) -> Shape:
        color = look.color(*palette)
        turns, r = look.between(1.2, 1.9), look.between(0.014, 0.02)
        if sugar:
            a = np.linspace(-0.8, 0.8, 9)
            path = np.column_stack([0.05 * np.sin(a), 0.03 * np.cos(a), 0 * a])
            section = np.array([(-0.2, -0.35), (0.2, -0.35), (0.2, 0.35), (-0.2, 0.35)]) * 0.011
            body = sweep(path, section)
            tile = textures.spots(look.rng, color, (252, 248, 236), 0.3)
            return settle([(body, tile)], 0.05)
        a = np.linspace(0, 2 * np.pi * turns, 40)
        out = r * (1 + 0.35 * a / (2 * np.pi))
        path = np.column_stack([out * np.cos(a), out * np.sin(a), 0.004 + 0.011 * a / (2 * np.pi)])
        wide = np.interp(np.linspace(0, 1, 40), [0, 0.1, 0.9, 1], [0.2, 1, 1, 0.2])
        section = np.array([(-0.12, -0.5), (0.12, -0.5), (0.12, 0.5), (-0.12, 0.5)]) * 0.013
        body = sweep(path, section, wide)
        return settle(
            [(body, textures.spots(look.rng, color, tint_color(color, 0.88), 0.12))], 0.06
        )

    return make


def _dried_fruit(palette: tuple[str, ...], d: tuple[float, float]) -> Callable[[Look], Shape]:
    """Return the shape function of a dried half fruit: a dented wrinkled disc."""

    def make(look: Look) -> Shape:
        size, color, lumps = look.between(*d), look.color(*palette), look.between(0, 6)
        body = ellipsoid(size, size * look.between(0.8, 0.95), 0.34 * size, 24, 12)

        def wrinkle(p: np.ndarray) -> np.ndarray:
            r = np.hypot(p[:, 0], p[:, 1]) / size
            z = p[:, 2] - 0.1 * size * np.exp(-((r / 0.22) ** 2)) * (p[:, 2] > 0)
            wave = 1 + 0.05 * np.sin(5 * np.arctan2(p[:, 1], p[:, 0]) + lumps)
            return np.column_stack([p[:, 0] * wave, p[:, 1] * wave, z])

        tile = textures.spots(look.rng, color, tint_color(color, 0.78), 0.2)
        return settle([(body.bend(wrinkle), tile)], 0.14)

    return make


def pickle_spear(look: Look) -> Shape:
    """A quarter of a pickled cucumber cut lengthwise."""
    long, r = look.between(0.085, 0.11), look.between(0.015, 0.019)
    color = look.color("olive", "green", "sage")
    outline = np.array([(0.0, 0.0), *arc((0, 0), r, 0.0, np.pi / 2, 6)])
    body = prism(outline, 0, long).turn(1, np.pi / 2)
    body = body.turn(0, -np.pi / 4).move(-0.5 * long)
    low = float(body.bounds[0, 2])
    inner = textures.spots(look.rng, color, (206, 208, 130), 0.14)
    return settle([(body.move(z=-low), inner)], 0.12)


_K = ("kitchen", "food")


_E, _F = ("edible",), ("edible", "flat")

CATEGORIES = (
    Category("pineapple_ring", _ring((0.036, 0.044), 0.32, 0.011, ("yellow", "gold", "amber"),
                                     0.92),
             (0.077, 0.0774, 0.0105), 0.04, ("ring of pineapple", "pineapple slice",
                                             "slice of pineapple"), _K,
             _F, ("yellow",), state="lying flat"),
    Category("apple_ring", _ring((0.028, 0.036), 0.28, 0.006, ("cream", "ivory", "beige"), 0.8),
             (0.0658, 0.0661, 0.00615), 0.01, ("dried apple ring", "dried apple"), _K, _F,
             ("cream",),
             state="lying flat"),
    Category("lotus_root", lotus_root, (0.0622, 0.0622, 0.00875), 0.02,
             ("lotus root slice", "lotus root chip"), _K,
             _F, ("ivory",), state="lying flat"),
    Category("orange_segment", _wedge((0.055, 0.07), 0.34, (248, 166, 60), ("orange", "amber")),
             (0.0322, 0.0642, 0.0197), 0.015, ("segment of orange", "satsuma segment",
                                               "tangerine segment",
             "orange wedge", "grapefruit segment"), _K, _E, ("orange",), state="lying on its side"),
    Category("apple_slice", _wedge((0.068, 0.078), 0.3, (250, 240, 208), ("red", "green",
             "crimson", "lime")), (0.0365, 0.0729, 0.0199), 0.02, ("slice of apple", "apple wedge",
                 "cut apple",
             "pear slice"), _K, _E, ("red",), state="lying on its side"),
    Category("melon_wedge", _wedge((0.14, 0.16), 0.36, (246, 180, 110), ("sage", "tan", "yellow")),
             (0.0783, 0.156, 0.0513), 0.2, ("wedge of melon", "slice of melon", "cantaloupe slice",
             "honeydew slice"), _K, _E, ("sage",), state="lying on its side"),
    Category("banana_peel", banana_peel, (0.233, 0.226, 0.062), 0.05, ("banana skin",
        "peel of a banana"), _K,
             (), ("yellow",), state="lying spread"),
    Category("apple_core", apple_core, (0.0809, 0.0521, 0.0476), 0.03, ("core of an apple",
        "eaten apple",
             "half eaten apple", "bitten apple core"), _K, (), ("red",), state="lying"),
    Category("orange_peel", keep_still(_peel_strip(("orange", "orange", "amber"), False)),
             (0.0531, 0.0531, 0.0249), 0.015,
             ("lemon peel", "citrus peel", "orange rind", "orange twist", "lemon twist",
              "strip of orange peel"), _K, _E, ("orange", "yellow"), state="lying curled"),
    Category("candied_peel", _peel_strip(("orange", "yellow", "amber"), True),
             (0.0737, 0.0133, 0.00732), 0.006,
             ("candied orange peel", "candied orange", "candied lemon peel", "orangette"), _K, _E,
             ("orange",), state="lying flat"),
    Category("dried_apricot", _dried_fruit(("orange", "amber", "terracotta", "copper"), (0.03,
             0.04)),
             (0.0358, 0.0321, 0.00883), 0.008, ("dried peach", "dried mango", "dried pear",
                                                "dried fig", "dried prune"), _K,
             _E, ("orange",),
             state="lying flat"),
    Category("pickle_spear", keep_still(pickle_spear), (0.101, 0.0242, 0.015), 0.025,
             ("dill pickle spear",
             "pickle wedge", "cucumber stick", "cucumber spear"), _K, _E, ("olive",),
             state="lying"),
)  # fmt: skip
"""The module's categories."""
