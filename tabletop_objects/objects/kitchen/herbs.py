"""Objects of the ``kitchen`` theme: herbs."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import surfaces
from ...kit.outlines import smooth
from ...kit.primitives import blade, limb, straight
from ...kit.shapes import Category, Shape, category, keep_still, settle, vary
from ...kit.solids import Solid, ellipsoid, join, tube
from ...kit.surfaces import Look, tint_color
from ..living.leaves import bundle
from ..living.plants import in_pot
from .nuts import Heap, heap
from .vegetables import Pod, pod_of


def _single(
    long: tuple[float, float], wide: float, palette: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """Return the shape function of one pointed leaf on its stalk, lying flat."""

    def make(look: Look) -> Shape:
        size, color = look.between(*long), look.color(*palette)
        w = wide * size * look.between(0.85, 1.15)
        leaf = blade([(-0.5 * size, 0, 0), (-0.2 * size, 0.01 * size, 0.05 * size),
                      (0.2 * size, 0, 0.06 * size), (0.5 * size, 0, 0.01 * size)], w,
                      thick=0.06)  # fmt: skip
        stalk = limb([(-0.62 * size, 0, 0), (-0.4 * size, 0, 0.01 * size)], [0.0009, 0.0008], 6)
        tile = surfaces.leaf(look.rng, color).transpose(1, 0, 2)
        return settle([(leaf, tile), (stalk, surfaces.plain(tint_color(color, 0.8)))], 0.1)

    return make


def _bunch(look: Look, kind: str) -> Shape:
    """Return a bunch of herbs tied with a string; it lies flat with its stalks on the left."""
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
                leaves.append(leaf.turn(1, -0.25).turn(2, a).move(at[0] + 0.5 * d * np.cos(a), at[1]
                                                                  + 0.5 * d * np.sin(a), at[2]
                                                                  + 0.003))  # fmt: skip
    string = tube([(-0.13 * long, 0.012 * np.cos(a), 0.01 + 0.009 * np.sin(a))
                   for a in np.linspace(0, 2 * np.pi, 14)], 0.0016, 6)  # fmt: skip
    green = surfaces.speckles(look.rng, tint_color(color, 0.95), 16)
    return settle([(join(leaves), green), (join(stems), surfaces.plain((122, 150, 84))),
                   (string, surfaces.plain((214, 190, 140)))], 0.42)  # fmt: skip


@category("basil", size=(0.151, 0.125, 0.0142), mass=0.03, material="food",
          aliases=("bunch of basil", "basil leaf", "fresh basil"), themes=("kitchen", "food"),
          roles=("edible",), colors=("green",), state="lying flat")  # fmt: skip
@vary()
def basil(look: Look) -> Shape:
    """A bunch of basil with broad leaves."""
    return _bunch(look, "basil")


@category("mint", size=(0.15, 0.117, 0.0139), mass=0.03, material="food", aliases=("bunch of mint",
          "mint leaf", "fresh mint", "sage", "mint sprig", "sprig of mint"),
          themes=("kitchen", "food"), roles=("edible",), colors=("green",),
          state="lying flat")  # fmt: skip
def mint(look: Look) -> Shape:
    """A bunch of mint with pointed leaves."""
    return _bunch(look, "mint")


@category("parsley", size=(0.142, 0.0999, 0.0127), mass=0.03, material="food",
          aliases=("bunch of parsley", "coriander", "cilantro", "fresh herbs", "herb",
          "bunch of herbs", "dill", "bunch of coriander", "parsley bunch", "coriander bunch",
          "cilantro bunch", "dill frond", "sprig of dill", "chervil", "watercress",
          "watercress bunch", "samphire bunch", "samphire"), themes=("kitchen", "food"),
          roles=("edible",), colors=("green",), state="lying flat")  # fmt: skip
def parsley(look: Look) -> Shape:
    """A bunch of parsley with small, curly leaves."""
    return _bunch(look, "parsley")


@category("rosemary", size=(0.156, 0.11, 0.0137), mass=0.02, material="food",
          aliases=("sprig of rosemary", "rosemary sprig", "thyme", "bunch of rosemary",
          "sprig of thyme"), themes=("kitchen", "food"), roles=("edible",), colors=("sage",),
          state="lying flat")  # fmt: skip
def rosemary(look: Look) -> Shape:
    """A bunch of rosemary with needles along its stalks."""
    return _bunch(look, "rosemary")


@category("herb_pot", size=(0.14, 0.14, 0.16), mass=0.5, material="ceramic", assembled=True,
          aliases=("basil plant", "potted basil", "mint plant", "potted herb", "pot of basil",
          "pot of herbs", "pot of mint", "pot of chives", "pot of parsley", "pot of coriander",
          "pot of thyme", "pot of rosemary", "parsley plant", "chive plant"),
          themes=("kitchen", "living"), roles=("tall",), colors=("terracotta",))  # fmt: skip
def herb_pot(look: Look) -> Shape:
    """A pot with a bushy kitchen herb."""
    r, h = look.between(0.042, 0.055), look.between(0.065, 0.085)
    green = look.own_color("green", "lime", "sage", "olive", spread=14)
    leaves: list[Solid] = []
    for k in range(70):
        t = (k + 0.5) / 70
        away = 0.062 * np.sqrt(t) * look.between(0.8, 1.1)
        z = h + 0.03 + 0.055 * (1 - t) + look.between(-0.012, 0.012)
        leaf = ellipsoid(0.027, 0.017, 0.004, 6, 4).turn(1, look.between(-0.2, 0.7))
        leaves.append(leaf.turn(2, 2.4 * k).move(away * np.cos(2.4 * k), away * np.sin(2.4 * k), z))
    stems = [straight((0.012 * np.cos(k), 0.012 * np.sin(k), 0.86 * h),
                      (0.035 * np.cos(k), 0.035 * np.sin(k), h + 0.05), 0.0018, 5)
             for k in range(7)]  # fmt: skip
    tile = surfaces.speckles(look.rng, green, 12)
    return in_pot(
        look, [(join(leaves), tile), (join(stems), surfaces.plain(tint_color(green, 0.7)))], r, h
    )


CATEGORIES = (
    Category("chopped_parsley",
             heap(Heap((0.024, 0.034), 0.005, "chip", ("green", "green", "lime"))),
             size=(0.0662, 0.0663, 0.0178), mass=0.01, material="food", aliases=("chopped herb",
             "chopped coriander", "chopped cilantro", "chopped basil", "chopped chive",
             "chopped dill", "chopped mint", "dried oregano", "dried herb",
             "heap of chopped parsley", "pile of chopped parsley", "mound of chopped parsley",
             "chopped parsley heap"), themes=("kitchen", "food"), roles=("edible",),
             colors=("green",), state="heaped"),
    Category("herb_bundle", bundle(("olive", "sage", "green"), 1.0), size=(0.14, 0.0409, 0.0273),
             mass=0.03, material="food", assembled=True, aliases=("dried herb bundle",
             "bundle of herbs", "bouquet garni", "bundle of thyme", "bundle of dried herbs",
             "tied herbs"), themes=("kitchen", "food"), roles=("edible",), colors=("olive",),
             state="lying"),
    Category("bay_leaf", _single((0.06, 0.085), 0.36, ("olive", "green", "sage")),
             size=(0.0806, 0.0199, 0.00524), mass=0.0005, material="food",
             aliases=("dried bay leaf", "laurel leaf", "kaffir lime leaf", "curry leaf",
             "lime leaf"), themes=("kitchen", "food"), roles=("edible", "flat"), colors=("olive",),
             state="lying flat"),
    Category("sage_leaf", _single((0.05, 0.07), 0.42, ("sage", "gray", "sage")),
             size=(0.0611, 0.018, 0.00421), mass=0.0005, material="food",
             themes=("kitchen", "food"), roles=("edible", "flat"), colors=("sage",),
             state="lying flat"),
    Category("lemongrass", keep_still(pod_of(Pod((0.26, 0.33),
             (0.03, 0.034, 0.026, 0.018, 0.014, 0.01), ("lime", "sage", "lime"), 0.03,
             "white foot"))), size=(0.297, 0.0255, 0.0169), mass=0.03, material="food",
             assembled=True,
             aliases=("lemongrass stalk", "lemon grass", "stalk of lemongrass", "lemongrass stick"),
             themes=("kitchen", "food"), roles=("edible",), colors=("lime",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
