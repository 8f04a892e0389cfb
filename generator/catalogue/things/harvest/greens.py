"""Leafy and long vegetables: celery, cabbage, lettuce, leeks, asparagus, herbs in bunches."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.forms import blade
from ...build.outlines import smooth
from ...build.settled import limb, settle
from ...build.shape import Shape
from ...build.solids import Solid, cylinder, ellipsoid, join, outward, tube
from ...build.variants import vary
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

WHITE: RGB = (240, 238, 222)


def leafy(look: Look, color: RGB) -> textures.Tile:
    """Return a leaf's skin: veins paler than ``color``."""
    tile = textures.noise(look.rng, 96, 96, (5, 5), 3)[..., None] * 22
    veins = np.abs(np.sin(np.linspace(0, 22, 96)))[None, :, None] < 0.16
    image = np.where(veins, np.array(tint_color(color, 1.45)), np.array(color) + tile)
    return np.clip(image, 0, 255).astype(np.uint8)


def head(look: Look, r: float, layers: int, frill: float) -> Solid:
    """Return a head of leaves: cupped sheets around a ball."""
    made = [ellipsoid(1.7 * r, 1.7 * r, 1.6 * r, 18, 10).move(z=0.82 * r)]
    for k in range(layers):
        turn = 2.4 * k
        size = r * (0.82 + 0.3 * k / layers)
        high = 1.75 - 0.35 * k / layers

        def cup(p: np.ndarray, size: float = size, high: float = high) -> np.ndarray:
            u, v = p[:, 0], p[:, 2]  # across and up, both about -1 to 1
            t = np.clip(0.5 + 0.5 * v, 0, 1)
            out = size * (0.42 + 0.62 * np.sin(np.pi * (0.12 + 0.62 * t)))
            out = out + frill * size * t**3 * (0.5 + 0.5 * np.sin(9 * u))
            a = 1.05 * u * (0.55 + 0.45 * np.sin(np.pi * t))
            lift = high * size * 0.92 * t * (1 - 0.1 * u * u)
            thick = p[:, 1]
            return np.column_stack([(out + thick) * np.cos(a), (out + thick) * np.sin(a), lift])

        n, m = 10, 7
        sheet = ellipsoid(2, 0.012, 2, 2 * n, m)
        made.append(outward(sheet.bend(cup)).turn(2, turn))
    return join(made)


def lettuce(look: Look) -> Shape:
    """A head of lettuce with frilled leaves."""
    r = look.between(0.062, 0.075)
    color = look.color("lime", "green", "lime", "maroon")
    leaves = head(look, r, 9, 0.4)
    return settle([(leaves, leafy(look, tint_color(color, 1.05)))], 0.06)


def cabbage(look: Look) -> Shape:
    """A round cabbage, green, white or red, its outer leaves a little open."""
    r = look.between(0.068, 0.08)
    color = look.color("lime", "purple", "sage")
    return settle([(head(look, r, 7, 0.08), leafy(look, color))], 0.07)


def celery(look: Look) -> Shape:
    """A bunch of celery lying, leaves to the right."""
    long = look.between(0.24, 0.3)
    color = look.color("lime", "green", "sage")
    stalks, tops = [], []
    for k in range(7):
        a = 2 * np.pi * k / 6
        y, z = (0.017 * np.cos(a), 0.015 * np.sin(a)) if k < 6 else (0.0, 0.0)
        stalks.append(
            limb(
                [
                    (-0.5 * long, 0.7 * y, 0.7 * z),
                    (-0.2 * long, y, z),
                    (0.25 * long, 1.5 * y, 1.4 * z),
                ],
                [0.011, 0.0105, 0.006],
                9,
            )
        )
        for s in (-1, 0, 1):
            tip = (0.25 * long, 1.5 * y, 1.4 * z)
            tops.append(blade([tip, (0.34 * long, 2.2 * y + 0.012 * s, 1.6 * z + 0.004),
                               (0.46 * long, 2.6 * y + 0.028 * s, 1.4 * z)], 0.03, thick=0.3,
                              sides=5))  # fmt: skip
    ribs = textures.stripes([tint_color(color, 1.35), tint_color(color, 1.15)], 7, upright=True)
    return settle([(join(stalks), ribs), (join(tops), textures.speckles(look.rng,
                  tint_color(color, 0.72), 14))], 0.12, hulls=[[0], [1]])  # fmt: skip


def _stalk(look: Look, long: float, r: float, count: int, fan: float) -> Shape:
    """Return leeks or spring onions: white shafts to the left, green leaves to the right."""
    color = look.color("green", "green", "sage")
    whites, leaves, roots = [], [], []
    for k in range(count):
        y, z = (k - (count - 1) / 2) * 2.05 * r, 0.0
        if count > 3 and k % 2:
            z = 1.2 * r
        whites.append(limb([(-0.5 * long, y, z), (-0.4 * long, y, z), (-0.2 * long, y, z),
                            (0.02 * long, y, z)], [0.8 * r, 1.15 * r, r, r], 12))  # fmt: skip
        for s in (-1, 0, 1):
            leaf = [(-0.02 * long, y, z), (0.2 * long, y + 0.4 * s * fan, z + 0.2 * r),
                    (0.5 * long, y + s * fan, z - 0.1 * r)]  # fmt: skip
            root = [(-0.5 * long, y, z), (-0.5 * long - 0.012, y + 0.4 * s * r, z),
                    (-0.5 * long - 0.02, y + s * r, z - 0.3 * r)]  # fmt: skip
            leaves.append(limb(leaf, [0.9 * r, 0.85 * r, 0.1 * r], 6, 0.35))
            roots.append(limb(root, [0.0012, 0.0008, 0.0005], 4))
    pale = textures.gradient(WHITE, tint_color(color, 1.4), look.rng)
    return settle([(join(whites), pale), (join(leaves), textures.stripes(
        [tint_color(color, 0.85), tint_color(color, 1.1)], 5, upright=True)),
        (join(roots), textures.plain((226, 216, 190)))], 0.12, hulls=[[0], [1]])  # fmt: skip


def leek(look: Look) -> Shape:
    """A leek lying, its leaves fanned out to the right."""
    return _stalk(look, look.between(0.27, 0.33), look.between(0.0145, 0.018), 1, 0.03)


def spring_onion(look: Look) -> Shape:
    """A few spring onions lying side by side."""
    return _stalk(look, look.between(0.22, 0.28), look.between(0.0048, 0.006), 4, 0.012)


def asparagus(look: Look) -> Shape:
    """A bundle of asparagus tied with a band, tips to the right."""
    long, r = look.between(0.18, 0.22), look.between(0.0048, 0.006)
    color = look.color("green", "green", "sage", "white")
    at = [(0, 0), *((2.05 * r * np.cos(a), 2.05 * r * np.sin(a))
                    for a in np.arange(6) * np.pi / 3)]  # fmt: skip
    spears, tips, scales = [], [], []
    for y, z in at:
        end = look.between(0.44, 0.5) * long
        spears.append(limb([(-0.5 * long, y, z), (0.1 * long, y, z), (end - 0.03, y, z)],
                           [r, r, 0.95 * r], 10))  # fmt: skip
        tips.append(limb([(end - 0.032, y, z), (end - 0.015, y, z), (end, y, z)],
                         [0.95 * r, 1.2 * r, 0.15 * r], 8))  # fmt: skip
        scales += [ellipsoid(0.01, 0.004, 0.003, 6, 4).move(u * long, y, z + 0.95 * r)
                   for u in (-0.2, 0.05, 0.2)]  # fmt: skip
    band = cylinder(3.12 * r, 0.016, 24).turn(1, np.pi / 2).move(-0.16 * long)
    tone = textures.plain(look.own_color("purple", "blue", "red", "tan"))
    return settle([(join(spears), textures.speckles(look.rng, color, 8)),
                   (join([*tips, *scales]), textures.speckles(look.rng, tint_color(
                       color, 0.68), 14)), (band, tone)], 0.1)  # fmt: skip


def cauliflower(look: Look) -> Shape:
    """A white head of cauliflower in green leaves."""
    r = look.between(0.06, 0.072)
    color = look.color("ivory", "cream", "white", "purple")
    curds = [ellipsoid(1.5 * r, 1.5 * r, 1.1 * r, 16, 10).move(z=0.9 * r)]
    for ring, (count, away, z) in enumerate([(1, 0, 1.42), (6, 0.42, 1.28), (11, 0.72, 0.98)]):
        for k in range(count):
            a = 2 * np.pi * (k + 0.5 * ring) / count
            d = 0.5 * r * look.between(0.9, 1.1)
            curds.append(ellipsoid(d, d, 0.8 * d, 10, 6).move(
                away * r * np.cos(a), away * r * np.sin(a), z * r))  # fmt: skip
    leaves = [blade([(0.3 * r * np.cos(a), 0.3 * r * np.sin(a), 0.12 * r),
                     (0.95 * r * np.cos(a), 0.95 * r * np.sin(a), 0.5 * r),
                     (1.08 * r * np.cos(a), 1.08 * r * np.sin(a), 1.25 * r)], 0.8 * r, thick=0.14)
              for a in np.arange(7) * 0.9]  # fmt: skip
    stub = cylinder(0.35 * r, 0.5 * r, 16)
    bud = textures.spots(look.rng, color, tint_color(color, 0.86), 0.25)
    green = textures.leaf(look.rng, (116, 164, 84))
    return settle([(join(curds), bud), (join(leaves), green), (stub, textures.plain(WHITE))],
                  0.02, hulls=[[0, 2], [1, 2]])  # fmt: skip


def artichoke(look: Look) -> Shape:
    """An artichoke standing, its scales overlapping."""
    r = look.between(0.042, 0.052)
    color = look.color("sage", "green", "olive")
    scales = []
    for ring, (count, z, away, size, lean) in enumerate(
        [(8, 0.15, 0.72, 0.9, 0.25), (8, 0.55, 0.74, 0.9, 0.0), (7, 0.95, 0.6, 0.85, -0.25),
         (5, 1.3, 0.36, 0.7, -0.5)]
    ):  # fmt: skip
        for k in range(count):
            a = 2 * np.pi * (k + 0.5 * (ring % 2)) / count
            leaf = ellipsoid(0.75 * size * r, 0.16 * r, size * r, 10, 6).turn(0, lean)
            leaf = leaf.move(y=-away * r, z=z * r + 0.45 * r)
            scales.append(leaf.turn(2, a))
    core = ellipsoid(1.5 * r, 1.5 * r, 1.9 * r, 18, 10).move(z=0.95 * r)
    stub = cylinder(0.26 * r, 0.4 * r, 12)
    skin_ = textures.gradient(tint_color(color, 1.1), tint_color(color, 0.82), look.rng, 8)
    return settle([(join([core, *scales]), skin_), (stub, textures.plain((150, 164, 110)))],
                  0.06)  # fmt: skip


def _bunch(look: Look, kind: str) -> Shape:
    """Return a bunch of herbs lying, stalks to the left, tied with a string."""
    long = look.between(0.13, 0.17)
    color = look.color(*{"rosemary": ("sage", "olive"), "parsley": ("green",),
                         "basil": ("green",), "mint": ("green", "lime")}[kind])  # fmt: skip
    stems, leaves = [], []
    count, count_at = 6, 5 if kind == "rosemary" else 3
    for k in range(count):
        spread = (k - (count - 1) / 2) / count
        z = 0.012 + 0.006 * (k % 2)
        tip = np.array([0.42 * long, 0.62 * long * spread, z])
        path = np.array([(-0.5 * long, -0.12 * long * spread, 0.008), (-0.12 * long, 0, 0.01), tip])
        stems.append(limb(path, [0.0016, 0.0015, 0.0008], 5))
        line = smooth(path, 6)[7:]
        for n in range(count_at):
            at = line[int(len(line) * (n + 0.7) / count_at) - 1]
            for s in (-1, 1):
                w = {"basil": 0.026, "mint": 0.018, "parsley": 0.02, "rosemary": 0.0035}[kind]
                d = {"basil": 0.036, "mint": 0.03, "parsley": 0.02, "rosemary": 0.018}[kind]
                a = 3 * spread * 0.4 + s * 0.85
                if kind == "parsley":
                    leaves += [ellipsoid(0.016, 0.009, 0.004, 5, 3).turn(2, a + b).move(
                        at[0] + 0.012 * np.cos(a + b), at[1] + 0.012 * np.sin(a + b),
                        at[2] + 0.002 + 0.002 * b) for b in (-0.5, 0, 0.5)]  # fmt: skip
                    continue
                leaf = ellipsoid(d, w, 0.005 if kind != "rosemary" else 0.0028, 6, 3)
                leaves.append(
                    leaf.turn(1, -0.25)
                    .turn(2, a)
                    .move(at[0] + 0.5 * d * np.cos(a), at[1] + 0.5 * d * np.sin(a), at[2] + 0.003)
                )
    string = tube([(-0.13 * long, 0.012 * np.cos(a), 0.01 + 0.009 * np.sin(a))
                   for a in np.linspace(0, 2 * np.pi, 14)], 0.0016, 6)  # fmt: skip
    green = textures.speckles(look.rng, tint_color(color, 0.95), 16)
    return settle([(join(leaves), green), (join(stems), textures.plain((122, 150, 84))),
                   (string, textures.plain((214, 190, 140)))], 0.42)  # fmt: skip


def basil(look: Look) -> Shape:
    """A bunch of basil: broad leaves."""
    return _bunch(look, "basil")


def mint(look: Look) -> Shape:
    """A bunch of mint: pointed leaves."""
    return _bunch(look, "mint")


def parsley(look: Look) -> Shape:
    """A bunch of parsley: small curly leaves."""
    return _bunch(look, "parsley")


def rosemary(look: Look) -> Shape:
    """A bunch of rosemary: needles along the stalks."""
    return _bunch(look, "rosemary")


_K = ("kitchen", "food")
CATEGORIES = (
    Category("lettuce", lettuce, (0.173, 0.173, 0.104), 0.35, ("head of lettuce",
                 "lettuce head", "salad head", "kale", "iceberg lettuce"), _K,
             ("edible", "round"), ("lime",)),
    Category("cabbage", cabbage, (0.161, 0.165, 0.108), 0.9, ("head of cabbage", "cabbage head"),
             _K, ("edible", "round"), ("sage", "purple")),
    Category("celery", celery, (0.239, 0.145, 0.046), 0.35, ("celery stalk", "bunch of celery",
             "celery stick", "stick of celery", "rhubarb", "fennel"), _K, ("edible",), ("lime",),
             state="lying flat"),
    Category("leek", leek, (0.326, 0.0632, 0.0331), 0.2, (), _K, ("edible",), ("green",),
             state="lying flat"),
    Category("spring_onion", spring_onion, (0.269, 0.058, 0.0165), 0.06, ("scallion",
                 "green onion", "chive", "bunch of spring onions", "bunch of chives",
                 "chive bunch"), _K, ("edible",), ("green",),
             state="lying flat"),
    Category("asparagus", asparagus, (0.2, 0.035, 0.0299), 0.2, ("bunch of asparagus",
             "bundle of asparagus", "asparagus spear", "asparagus bundle"), _K, ("edible",),
             ("green",), state="lying flat"),
    Category("cauliflower", cauliflower, (0.139, 0.14, 0.104), 0.6, ("head of cauliflower",
             "cauliflower head"), _K, ("edible", "round"), ("ivory",)),
    Category("artichoke", artichoke, (0.0805, 0.0805, 0.091), 0.25, ("globe artichoke",), _K,
             ("edible", "round"), ("sage",)),
    vary(Category("basil", basil, (0.151, 0.125, 0.0142), 0.03, ("bunch of basil", "basil leaf",
             "fresh basil"), _K, ("edible",), ("green",), state="lying flat")),
    Category("mint", mint, (0.15, 0.117, 0.0139), 0.03, ("bunch of mint", "mint leaf",
                 "fresh mint", "sage", "mint sprig", "sprig of mint"), _K, ("edible",), ("green",),
             state="lying flat"),
    Category("parsley", parsley, (0.142, 0.0999, 0.0127), 0.03, ("bunch of parsley",
                 "coriander", "cilantro", "fresh herbs", "herb", "bunch of herbs", "dill",
                 "bunch of coriander", "parsley bunch", "coriander bunch", "cilantro bunch",
                 "dill frond", "sprig of dill", "chervil", "watercress", "watercress bunch",
                 "samphire bunch", "samphire"), _K,
             ("edible",), ("green",), state="lying flat"),
    Category("rosemary", rosemary, (0.156, 0.11, 0.0137), 0.02, ("sprig of rosemary",
             "rosemary sprig", "thyme", "bunch of rosemary", "sprig of thyme"), _K, ("edible",),
             ("sage",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
