"""Objects of the ``kitchen`` theme: root vegetables."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import skin
from ...kit.parts import flat_foot, hull_of
from ...kit.primitives import bent_rod, blade, limb, press_flat
from ...kit.shapes import Category, Shape, category, keep_still, settle, shape
from ...kit.solids import Solid, cylinder, ellipsoid, join, tube
from ...kit.surfaces import RGB, Look, tint_color
from .fruit import Globe, globe
from .nuts import Heap, heap
from .vegetables import Pod, halves, pod_of, root


@category("carrot", size=(0.2, 0.05, 0.03), mass=0.06, material="food", themes=("kitchen",),
          roles=("edible",), colors=("orange",), state="lying flat", common=True)  # fmt: skip
def carrot(look: Look) -> Shape:
    """A carrot with a tuft of green, lying flat."""
    length, r = look.between(0.14, 0.18), look.between(0.014, 0.017)
    color = look.color("orange", "orange", "coral")
    rings = surfaces.stripes([color, color, color, tint_color(color, 0.82)], 9)
    body = root(look, length, [0.12 * r, 0.4 * r, 0.6 * r, 0.78 * r, 0.92 * r, r, 0.9 * r, 0.5 * r])
    low = float(body.vertices[:, 2].min())
    green = surfaces.plain((84, 140, 60))
    tuft = [
        tube([(length / 2 - 0.004, 0, 0.9 * r), (length / 2 + 0.02, 0.01 * k, 0.9 * r + 0.004),
              (length / 2 + 0.045, 0.022 * k, 0.8 * r)], [0.0025, 0.002, 0.003], 6)
        for k in (-1, 0, 1)
    ]  # fmt: skip
    body = body.move(z=-low)
    return shape([(body, rings), (join(tuft), green)], [*halves(body, 3), hull_of(*tuft)])


@category("potato", size=(0.092, 0.062, 0.05), mass=0.17, material="food", aliases=("spud",),
          themes=("kitchen", "food"), roles=("edible",), colors=("tan",), state="lying flat",
          common=True)  # fmt: skip
def potato(look: Look) -> Shape:
    """A knobbly potato, lying flat."""
    x, y, z = look.between(0.08, 0.105), look.between(0.055, 0.068), look.between(0.05, 0.058)
    color = look.color("tan", "beige", "terracotta", "mustard", "maroon")
    phase = look.rng.uniform(0, 6.3, 3)

    def bumps(p: np.ndarray) -> np.ndarray:
        wave = 1 + 0.05 * np.sin(p @ np.array([70, 40, 30]) + phase[0])
        return p * (wave + 0.04 * np.sin(p @ np.array([-60, 90, 50]) + phase[1]))[:, None]

    body = press_flat(ellipsoid(x, y, z, 26, 16).bend(bumps), 0.44 * z)
    peel = surfaces.spots(look.rng, color, tint_color(color, 0.55), 0.04)
    return shape([(body, peel)], [flat_foot(body.vertices)])


@category("lotus_root", size=(0.0622, 0.0622, 0.00875), mass=0.02, material="food",
          aliases=("lotus root slice", "lotus root chip"), themes=("kitchen", "food"),
          roles=("edible", "flat"), colors=("ivory",), state="lying flat")  # fmt: skip
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
    return shape([(body, surfaces.plain(tint_color(color, 0.75))), (face, image)], [hull_of(body)])


GREEN: RGB = (92, 150, 62)


def _tuft(x: float, reach: float, wide: float, count: int, end: float) -> Solid:
    """Return leaves that fan out to the right from ``x``, with tips at height ``end``."""
    return join([
        blade([(x, 0, 0), (x + 0.45 * reach, wide * s, 0.06 * reach),
               (x + reach, 2.2 * wide * s, end)], 0.34 * reach / count + 0.016,
              thick=0.25, sides=5)
        for s in np.linspace(-1, 1, count)
    ])  # fmt: skip


def _radish_root(look: Look, long: float, r: float, peel: surfaces.Tile, leaf: float) -> Shape:
    """Return a root lying flat, with its thin tail on the left and leaves on the right."""
    body = limb([(-0.5 * long - 0.9 * r, 0, -0.2 * r), (-0.5 * long - 0.1 * r, 0, 0),
                 (-0.3 * long, 0, 0), (0.05 * long, 0, 0), (0.4 * long, 0, 0), (0.5 * long, 0, 0)],
                [0.03 * r, 0.14 * r, 0.78 * r, r, 0.72 * r, 0.2 * r], 20)  # fmt: skip
    top = _tuft(0.46 * long, leaf, 0.2 * leaf, 4, -0.8 * r)
    green = surfaces.leaf(look.rng, GREEN)
    return settle([(body, peel), (top, green)], 0.14, hulls=[[0], [1]])


@category("radish", size=(0.13, 0.0724, 0.0268), mass=0.02, material="food",
          themes=("kitchen", "food"), roles=("edible",), colors=("crimson",),
          state="lying flat")  # fmt: skip
def radish(look: Look) -> Shape:
    """A red radish with its leaves, lying flat."""
    d = look.between(0.027, 0.034)
    color = look.color("crimson", "red", "magenta", "white")
    peel = surfaces.stack((surfaces.plain((250, 244, 240)), 0.3), (surfaces.speckles(
        look.rng, color, 8), 0.7))  # fmt: skip
    return _radish_root(look, 1.15 * d, d / 2, peel, look.between(0.07, 0.09))


@category("beetroot", size=(0.185, 0.079, 0.0567), mass=0.16, material="food", aliases=("beet",),
          themes=("kitchen", "food"), roles=("edible",), colors=("maroon",),
          state="lying flat")  # fmt: skip
def beetroot(look: Look) -> Shape:
    """A beetroot with cut red stalks, lying flat."""
    d = look.between(0.062, 0.075)
    color = look.color("maroon", "maroon", "crimson")
    peel = skin(look, tint_color(color, 0.75), (84, 30, 46), 0.6)
    return _radish_root(look, 1.05 * d, d / 2, peel, look.between(0.08, 0.1))


@category("turnip", size=(0.174, 0.0721, 0.0599), mass=0.15, material="food",
          aliases=("rutabaga", "swede"), themes=("kitchen", "food"), roles=("edible",),
          colors=("purple",), state="lying flat")  # fmt: skip
def turnip(look: Look) -> Shape:
    """A turnip with a purple top, lying flat."""
    d = look.between(0.062, 0.078)
    color = look.color("purple", "violet", "magenta")
    peel = surfaces.gradient((246, 240, 226), color, look.rng)
    return _radish_root(look, 0.95 * d, d / 2, peel, look.between(0.07, 0.09))


@category("parsnip", size=(0.215, 0.0453, 0.0408), mass=0.12, material="food",
          themes=("kitchen", "food"), roles=("edible",), colors=("cream",),
          state="lying flat")  # fmt: skip
def parsnip(look: Look) -> Shape:
    """A pale parsnip lying flat with its tip on the left."""
    long, r = look.between(0.17, 0.22), look.between(0.02, 0.026)
    body = limb([(-0.5 * long, 0.003, -0.004), (-0.2 * long, 0, 0), (0.3 * long, 0, 0),
                 (0.46 * long, 0, 0), (0.5 * long, 0, 0)],
                [0.0016, 0.4 * r, 0.95 * r, 0.9 * r, 0.4 * r], 16)  # fmt: skip
    color = look.color("cream", "beige", "ivory")
    rings = surfaces.stripes([color, color, color, tint_color(color, 0.85)], 7)
    stub = cylinder(0.3 * r, 0.014, 12).turn(1, np.pi / 2).move(x=0.49 * long)
    return settle([(body, rings), (stub, surfaces.plain((150, 164, 90)))], 0.1)


@category("sweet_potato", size=(0.149, 0.0649, 0.055), mass=0.2, material="food",
          aliases=("yam", "batata"), themes=("kitchen", "food"), roles=("edible",),
          colors=("terracotta",), state="lying flat")  # fmt: skip
def sweet_potato(look: Look) -> Shape:
    """A sweet potato lying flat, pointed at both ends."""
    long, r = look.between(0.13, 0.16), look.between(0.028, 0.034)
    color = look.color("terracotta", "copper", "maroon", "purple")
    bend = look.between(0.004, 0.014)
    body = limb([(-0.5 * long, bend, 0), (-0.34 * long, 0.4 * bend, 0), (-0.05 * long, -bend, 0),
                 (0.25 * long, 0, 0), (0.5 * long, bend, 0)],
                [0.0025, 0.6 * r, r, 0.8 * r, 0.003], 18)  # fmt: skip
    peel = surfaces.spots(look.rng, color, tint_color(color, 0.66), 0.06)
    return settle([(body, peel)], 0.12)


@category("ginger", size=(0.12, 0.0878, 0.0269), mass=0.1, material="food", aliases=("ginger root",
          "piece of ginger", "root of ginger", "galangal", "galangal root", "root ginger",
          "jerusalem artichoke", "sunchoke"), themes=("kitchen", "food"), roles=("edible",),
          colors=("tan",), state="lying flat")  # fmt: skip
def ginger(look: Look) -> Shape:
    """A knobbly ginger root, lying flat."""
    k = look.between(0.9, 1.15)
    knobs = [bent_rod(0.09, 0.015, bend=0.008, blunt=5)]
    for x, y, a, size in ((-0.028, 0.02, 1.9, 0.042), (0.012, 0.022, 1.2, 0.05),
                          (0.03, -0.018, -0.9, 0.04), (-0.012, -0.02, -1.8, 0.036),
                          (0.05, 0.008, 0.4, 0.04)):  # fmt: skip
        knobs.append(bent_rod(size, 0.0115, blunt=4, sides=12).turn(2, a).move(x, y, 0.001))
    color = look.color("tan", "beige", "wooden")
    rings = surfaces.stripes([color, color, color, tint_color(color, 0.78)], 6)
    return settle([(join(knobs), rings)], 0.12).scale(k)


CATEGORIES = (
    Category("kohlrabi", globe(Globe((0.075, 0.09), 0.9, ("sage", "lime", "purple"), top="stalks")),
             size=(0.0965, 0.0848, 0.106), mass=0.3, material="food", assembled=True,
             themes=("kitchen", "food"), roles=("round", "edible"), colors=("sage",)),
    Category("celeriac", globe(Globe((0.1, 0.12), 0.9, ("tan", "beige", "wooden"), "warty",
             top="stalks", bumps=46)), size=(0.126, 0.12, 0.132), mass=0.6, material="food",
             aliases=("celery root",), themes=("kitchen", "food"), roles=("round", "edible", "big"),
             colors=("tan",)),
    Category("taro_root", globe(Globe((0.06, 0.075), 1.45, ("brown", "bronze", "copper"), "rings",
             top="none", lying=True)), size=(0.0839, 0.0804, 0.0576), mass=0.25, material="food",
             aliases=("taro", "eddoe"), themes=("kitchen", "food"), roles=("edible",),
             colors=("brown",)),
    Category("new_potato", globe(Globe((0.034, 0.045), 1.25, ("tan", "beige", "wooden"), "spots",
             top="none", lying=True)), size=(0.0467, 0.0424, 0.0344), mass=0.05, material="food",
             aliases=("baby potato", "jersey royal"), themes=("kitchen", "food"), roles=("edible",),
             colors=("tan",)),
    Category("chopped_carrot",
             heap(Heap((0.03, 0.042), 0.01, "disc", ("orange", "orange", "amber"))),
             size=(0.0857, 0.0842, 0.026), mass=0.06, material="food", aliases=("diced carrot",
             "sliced carrot", "heap of chopped carrot", "pile of chopped carrot",
             "mound of chopped carrot", "chopped carrot heap"), themes=("kitchen", "food"),
             roles=("edible",), colors=("orange",), state="heaped"),
    Category("daikon", keep_still(pod_of(Pod((0.24, 0.31), (0.006, 0.06, 0.1, 0.105, 0.1, 0.05),
             ("white", "ivory", "cream"), 0.02, "speckles", "leaves"))),
             size=(0.383, 0.114, 0.0479), mass=0.5, material="food", assembled=True,
             aliases=("mooli", "white radish", "daikon radish"), themes=("kitchen", "food"),
             roles=("edible",), colors=("white",), state="lying flat"),
    Category("horseradish", keep_still(pod_of(Pod((0.2, 0.26),
             (0.01, 0.05, 0.06, 0.075, 0.08, 0.07), ("tan", "beige", "wooden"), 0.06, "rings",
             "leaves"))), size=(0.299, 0.0729, 0.0303), mass=0.2, material="food",
             aliases=("horseradish root", "salsify"), themes=("kitchen", "food"), roles=("edible",),
             colors=("tan",), state="lying flat"),
    Category("cassava", keep_still(pod_of(Pod((0.2, 0.27), (0.02, 0.09, 0.13, 0.14, 0.12, 0.06),
             ("brown", "bronze", "copper"), 0.03, "rings"))), size=(0.235, 0.0655, 0.0548),
             mass=0.5, material="food", aliases=("yuca", "manioc", "cassava root"),
             themes=("kitchen", "food"), roles=("edible",), colors=("brown",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
