"""Objects of the ``kitchen`` theme: breads."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import skin
from ...kit.parts import box_part, hull_of
from ...kit.primitives import at_box, bent_rod, plate
from ...kit.shapes import (
    Category,
    Pieces,
    Shape,
    category,
    from_pieces,
    put_down,
    settle,
    shape,
    vary,
)
from ...kit.solids import block, box, ellipsoid, join, prism
from ...kit.surfaces import Look, tint_color
from ..breakfast.breads import _crust
from .nuts import Heap, heap


@category("crouton", size=(0.0216, 0.0216, 0.0228), mass=0.002, material="food",
          aliases=("bread cube", "cube of bread", "bread crouton", "toasted bread cube"),
          themes=("kitchen",), roles=("edible",), colors=("cream",))  # fmt: skip
def crouton(look: Look) -> Shape:
    """A crouton: a cube of white bread with holes in it and crust on one side."""
    x = look.between(0.019, 0.024)
    color = look.color("cream", "beige", "amber")
    crumb = surfaces.spots(look.rng, tint_color(color, 1.25), tint_color(color, 0.85), 0.2)
    rind = block(0.98 * x, 0.98 * x, 0.0022, 0.001).move(z=x - 0.001)
    return shape([(block(x, x, x, 0.0015, 0.0008), crumb),
                  (rind, surfaces.speckles(look.rng, (170, 104, 50), 10))],
                 [box_part(x, x, x + 0.001)])  # fmt: skip


@category("matzo", size=(0.17, 0.17, 0.004), mass=0.03, material="food",
          aliases=("matzah", "matza", "sheet of matzo", "knackebrod"), themes=("kitchen",),
          roles=("flat", "edible"), colors=("cream",))  # fmt: skip
@from_pieces()
def matzo(look: Look) -> Pieces:
    """A thin, square sheet of matzo with rows of scorched dots."""
    color = look.color("cream", "beige")
    image = surfaces.spots(look.rng, color, (150, 104, 60), 0.06).copy()
    for k in range(1, 10):
        for n in range(14):
            prints.disc(image, (n + 0.5) / 14, k / 10, 0.008, (150, 110, 70))
    return [(at_box(0.17, 0.17, 0.004), image)]


@category("hot_dog_bun", size=(0.153, 0.0811, 0.0391), mass=0.05, material="food",
          aliases=("hotdog bun", "finger roll", "brioche hot dog bun", "sub roll", "hot dog roll"),
          themes=("kitchen", "dining"), roles=("edible",), state="lying flat")  # fmt: skip
@vary()
def hot_dog_bun(look: Look) -> Shape:
    """A long, soft hot dog bun, split along its top."""
    k = look.between(0.92, 1.08)
    halves = [bent_rod(0.155, 0.024, blunt=5, squash=0.95).move(y=s * 0.017) for s in (-1, 1)]
    base = bent_rod(0.15, 0.026, blunt=5, squash=0.5).move(z=-0.01)
    crumb = box(0.125, 0.012, 0.004).move(z=0.0085)
    return settle([(join([*halves, base]), skin(look, (222, 164, 88), (186, 120, 56), 0.8)),
                   (crumb, surfaces.plain((246, 228, 186)))], 0.12).scale(k)  # fmt: skip


@category("baguette", size=(0.418, 0.0629, 0.049), mass=0.25, material="food",
          aliases=("french bread", "french loaf", "stick of bread", "french stick"),
          themes=("kitchen", "dining"), roles=("edible", "big"), colors=("amber",),
          state="lying flat")  # fmt: skip
def baguette(look: Look) -> Shape:
    """A long, crusty loaf with slanted cuts."""
    long, r = look.between(0.4, 0.48), look.between(0.028, 0.034)
    bread = bent_rod(long, r, blunt=5, squash=0.8)
    cuts = [ellipsoid(0.075, 0.02, 0.012, 12, 6).turn(2, 0.45).move(x=u * long, z=0.76 * r)
            for u in (-0.34, -0.17, 0.0, 0.17, 0.34)]  # fmt: skip
    pale = surfaces.speckles(look.rng, (236, 204, 146), 8)
    return settle([(bread, _crust(look)), (join(cuts), pale)], 0.1)


@category("bread_loaf", size=(0.22, 0.107, 0.084), mass=0.45, material="food",
          aliases=("loaf of bread", "bread", "loaf", "rye sourdough", "colomba"),
          themes=("kitchen", "dining"), roles=("edible",), colors=("brown", "tan"),
          state="lying flat", common=True)  # fmt: skip
def bread_loaf(look: Look) -> Shape:
    """A loaf of bread with a scored crust."""
    x, y, h = look.between(0.2, 0.24), look.between(0.095, 0.11), look.between(0.075, 0.09)
    crust = look.color("brown", "tan", "copper")
    tile = surfaces.scratches(look.rng, tint_color(crust, 1.15), (236, 210, 168), 90)
    outline = [(-y / 2, 0.006), (-0.42 * y, 0), (0.42 * y, 0), (y / 2, 0.006), (0.52 * y, 0.45 * h),
               (0.4 * y, 0.82 * h), (0.15 * y, h), (-0.15 * y, h), (-0.4 * y, 0.82 * h),
               (-0.52 * y, 0.45 * h)]  # fmt: skip
    body = prism(outline, -x / 2, x / 2, 0.016).turn(0, np.pi / 2).turn(2, np.pi / 2)
    body = body.move(z=-float(body.vertices[:, 2].min()))
    cuts = [ellipsoid(0.055, 0.012, 0.006, 12, 6).turn(2, 0.5).move(k * 0.28 * x, 0, h - 0.001)
            for k in (-1, 0, 1)]  # fmt: skip
    pale = surfaces.speckles(look.rng, (238, 214, 172), 6)
    return shape([(body, tile), (join(cuts), pale)], [hull_of(body)])


@category("bread_crust", size=(0.0879, 0.0283, 0.0152), mass=0.015, material="food",
          aliases=("crust", "crust of bread", "bitten toast"), themes=("kitchen",),
          colors=("brown",))  # fmt: skip
def bread_crust(look: Look) -> Shape:
    """A crust of bread: the bitten end of a slice."""
    color = look.color("brown", "tan", "wooden")
    k = look.between(0.85, 1.2)
    a = np.linspace(0.1, np.pi - 0.1, 9)
    rim = np.concatenate([np.column_stack([0.045 * np.cos(a), 0.032 * np.sin(a)]),
                          [(-0.03, 0.006), (-0.018, 0.012), (-0.006, 0.004), (0.008, 0.013),
                           (0.022, 0.005)]])  # fmt: skip
    rind, crumb = plate(rim, 0.014), plate(0.86 * rim + [0, 0.001], 0.0155, at=(0, 0, -0.0006))
    return put_down([(rind, surfaces.speckles(look.rng, tint_color(color, 0.9), 10)),
                     (crumb.move(z=0.0006), surfaces.spots(look.rng, (238, 220, 180),
                                                           (210, 180, 130), 0.15))], rind,
                    factor=k)  # fmt: skip


CATEGORIES = (
    Category("breadcrumbs", heap(Heap((0.03, 0.042), 0.004, "cube", ("tan", "beige", "wooden"))),
             size=(0.0871, 0.0861, 0.0219), mass=0.03, material="food", aliases=("breadcrumb",
             "bread crumb", "crumb", "cookie crumb", "crouton crumb", "heap of breadcrumbs",
             "pile of breadcrumbs", "mound of breadcrumbs", "breadcrumbs heap"),
             themes=("kitchen", "food"), roles=("edible",), colors=("tan",), state="heaped"),
    Category("croutons", heap(Heap((0.03, 0.04), 0.012, "cube", ("wooden", "tan", "amber"))),
             size=(0.0855, 0.0836, 0.0304), mass=0.03, material="food", aliases=("pile of croutons",
             "heap of croutons", "heap of croutons", "pile of croutons", "mound of croutons",
             "croutons heap"), themes=("kitchen", "food"), roles=("edible",), colors=("wooden",),
             state="heaped"),
)  # fmt: skip
"""Objects that share their drawing functions."""
