"""Objects of the ``dining`` theme: cards."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.parts import box_part, hull_of
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import box
from ...kit.surfaces import RGB, Look, readable_on, tint_color
from ..living.signs import sheet_of


def menu_page(look: Look, color: RGB, wide: int, tall: int) -> surfaces.Tile:
    """Return a menu page with a title, a line and nine dishes with their prices."""
    image = prints.canvas(wide, tall, color)
    ink = readable_on(color)
    prints.write(image, look.pick(["MENU", "MENU", "BISTRO", "CAFE"]), 0.5, 0.12, 0.1, ink,
                 bold=True)  # fmt: skip
    prints.fill(image, 0.3, 0.19, 0.4, 0.008, ink)
    for n in range(9):
        y = 0.27 + 0.075 * n
        prints.fill(image, 0.1, y, look.between(0.35, 0.55), 0.014, ink)
        prints.fill(image, 0.82, y, 0.09, 0.014, ink)
    return image


@category("menu", size=(0.157, 0.223, 0.0031), mass=0.06, material="paper",
          aliases=("restaurant menu", "cafe menu", "takeaway menu", "drinks menu", "wine list",
          "dessert menu"), themes=("dining",), roles=("flat",), colors=("cream", "maroon"),
          state="lying flat")  # fmt: skip
def menu(look: Look) -> Shape:
    """A restaurant menu: a half-open folded card standing upright, or a flat sheet."""
    k = look.between(0.92, 1.06)
    color = look.color("cream", "white", "maroon", "navy", "black", "green")
    image = menu_page(look, color, 140, 200)
    t = 0.0028
    card = box(0.155 * k, 0.22 * k, t)
    face = box(0.154 * k, 0.219 * k, 0.0005).move(z=t - 0.0002)
    return shape([(card, surfaces.plain(tint_color(color, 0.85))), (face, image)],
                 [box_part(0.155 * k, 0.22 * k, t)])  # fmt: skip


@category("place_card", size=(0.093, 0.046, 0.047), mass=0.003, material="paper", assembled=True,
          aliases=("place name card", "name tent", "table name card", "wedding place card",
          "place setting card", "reserved sign", "name place card"), themes=("dining",),
          colors=("white",))  # fmt: skip
def place_card(look: Look) -> Shape:
    """A small tent-shaped place card with a name on it."""
    k = look.between(0.92, 1.1)
    color = look.color("white", "cream", "ivory", "pink", "mint", "sky")
    image = prints.canvas(150, 84, color)
    gold = (190, 150, 70)
    prints.fill(image, 0.04, 0.08, 0.92, 0.03, gold)
    prints.fill(image, 0.04, 0.88, 0.92, 0.03, gold)
    prints.write(image, look.pick(["Anna", "James", "Emma", "Leo", "Sofia", "Oliver"]), 0.5, 0.5,
                 0.34, (60, 52, 60))  # fmt: skip
    x, h, t, lean = 0.09 * k, 0.05 * k, 0.0012, 0.45
    leaves = []
    for s in (-1, 1):
        leaf = box(x, t, h).move(z=-h).turn(0, s * lean).move(z=h * np.cos(lean))
        leaves.append(leaf.move(z=-float(leaf.bounds[0, 2])))
    front = leaves[0] if leaves[0].bounds[0, 1] < leaves[1].bounds[0, 1] else leaves[1]
    rear = leaves[1] if front is leaves[0] else leaves[0]
    return shape([(front, image), (rear, surfaces.plain(tint_color(color, 0.97)))],
                 [hull_of(front), hull_of(rear)])  # fmt: skip


CATEGORIES = (
    Category("menu_card", sheet_of(("MENU", "DINNER", "WEDDING MENU"), 0.1, 0.2, "menu"),
             size=(0.103, 0.205, 0.0018), mass=0.015, material="paper",
             aliases=("cocktail menu", "menu sheet"), themes=("dining",), roles=("flat",),
             colors=("cream",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
