"""Objects of the ``kitchen`` theme: paper goods."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import spread
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import box, cylinder, join, lathe
from ...kit.surfaces import Look, readable_on, tint_color
from ..school.stationery import thick_book


def _roll_box(look: Look, word: str, tile: surfaces.Tile, palette: tuple[str, ...]) -> Shape:
    """Return a long box of foil or film with a sheet pulled out over its front edge."""
    x, y, h = look.between(0.29, 0.32), look.between(0.046, 0.054), look.between(0.046, 0.054)
    color = look.color(*palette)
    face = prints.canvas(224, 40, color)
    prints.write(face, word, 0.5, 0.5, 0.6, readable_on(color), bold=True)
    prints.fill(face, 0, 0, 1, 0.1, tint_color(color, 1.5))
    body = box(x, y, h)
    front = box(x, 0.0008, h).move(y=-y / 2)
    top = box(x, y, 0.0008).move(z=h - 0.0002)
    teeth = box(x, 0.002, 0.006).move(y=-y / 2 - 0.001, z=0.55 * h)
    u, v = np.meshgrid(np.linspace(-0.46, 0.46, 8), np.linspace(0, 1, 7))
    fall = np.stack([u * x, -0.5 * y - 0.002 - 0.05 * v, 0.56 * h * (1 - v) ** 1.4 + 0.0006], -1)
    sheet = spread(fall[::-1], 0.0006)
    return shape([(body, surfaces.plain(tint_color(color, 0.9))), (front, face), (top, face),
                  (teeth, surfaces.plain((190, 194, 200))), (sheet, tile)],
                 [box_part(x, y, h)])  # fmt: skip


@category("foil_roll", size=(0.305, 0.103, 0.0509), mass=0.35, material="paper",
          aliases=("aluminium foil", "aluminum foil", "tin foil", "roll of foil", "foil",
          "roll of aluminium foil", "roll of aluminum foil", "aluminum foil roll",
          "aluminium foil roll", "baking paper", "parchment paper", "carrier bag roll"),
          themes=("kitchen",), colors=("blue",), state="lying flat")  # fmt: skip
def foil_roll(look: Look) -> Shape:
    """A box of aluminium foil with a sheet pulled out."""
    foil = surfaces.noise(look.rng, 96, 96, (12, 12), 2)[..., None] * 26
    tile = np.clip(np.array((206, 209, 214)) + foil, 0, 255).astype(np.uint8)
    return _roll_box(look, "FOIL", tile, ("blue", "red", "navy", "green"))


@category("cling_film", size=(0.305, 0.101, 0.0513), mass=0.3, material="paper",
          aliases=("plastic wrap", "cling wrap", "food wrap", "roll of cling film", "saran wrap",
          "clingfilm", "roll of plastic wrap"), themes=("kitchen",), colors=("green",),
          state="lying flat")  # fmt: skip
def cling_film(look: Look) -> Shape:
    """A box of cling film with a clear sheet pulled out."""
    return _roll_box(look, "CLING FILM", surfaces.plain((222, 236, 240)),
                     ("green", "yellow", "teal", "purple"))  # fmt: skip


@category("paper_towel_roll", size=(0.126, 0.136, 0.26), mass=0.3, material="paper", assembled=True,
          aliases=("paper towel", "kitchen roll", "roll of paper towels", "kitchen paper",
          "paper towel holder", "toilet paper", "roll of paper", "paper roll", "kitchen towel roll",
          "bin bag roll", "roll of bin bags", "newspaper roll"), themes=("kitchen",),
          roles=("tall", "round"), colors=("white",))  # fmt: skip
def paper_towel_roll(look: Look) -> Shape:
    """A roll of kitchen paper standing upright, alone or on a holder."""
    r, h = look.between(0.052, 0.064), look.between(0.22, 0.25)
    color = look.color("white", "white", "white", "cream")
    quilt = surfaces.grid(tint_color(color, 0.93), color, 14, 14, 128)
    roll = lathe([(0.3 * r, 0), (r, 0), (r, h), (0.3 * r, h)], 36, loop=True)
    core = lathe([(0.26 * r, 0), (0.31 * r, 0), (0.31 * r, h), (0.26 * r, h)], 24, loop=True)
    flap = box(0.0012, 0.05, h).move(r - 0.0006, -0.03, 0).turn(2, -0.4)
    brown = surfaces.plain((190, 156, 112))
    if look.chance(0.5):
        return shape([(join([roll, flap]), quilt), (core, brown)], [cylinder_part(r, h)])
    base = cylinder(1.25 * r, 0.014, 36, bevel=0.003)
    post = cylinder(0.1 * r, h + 0.045, 16).move(z=0.01)
    ball = cylinder(0.18 * r, 0.018, 18, bevel=0.004).move(z=h + 0.042)
    wood = look.surface(look.own_color("wooden", "black", "silver", "white"), "wood")
    return shape([(join([s.move(z=0.0135) for s in (roll, flap)]), quilt),
                  (core.move(z=0.0135), brown), (join([base, post, ball]), wood)],
                 [cylinder_part(1.25 * r, 0.014), cylinder_part(r, h, (0, 0, 0.0135)),
                  hull_of(ball)])  # fmt: skip


CATEGORIES = (
    Category("cookbook", thick_book(("COOKBOOK", "RECIPES", "BAKING"), (0.19, 0.24, 0.024)),
             size=(0.19, 0.24, 0.024), mass=0.8, material="paper",
             aliases=("cookery book", "cook book", "baking book"), themes=("kitchen",),
             roles=("support", "flat"), colors=("orange", "teal")),
)  # fmt: skip
"""Objects that share their drawing functions."""
