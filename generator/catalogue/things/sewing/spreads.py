"""Cloths that lie spread out, with things on them."""

from __future__ import annotations

from ...build.category import Category
from ...build.collision import hull_of
from ...build.shape import Shape, shape
from ...build.solids import block
from ...surfaces.look import Look


def cloth(look: Look) -> Shape:
    """A plain cloth, folded once and spread out flat."""
    x, y, z = look.between(0.4, 0.5), look.between(0.3, 0.36), look.between(0.005, 0.006)
    color = look.color("white", "gray", "beige", "navy", "red", "sage", "cream", "black")
    sheet = block(x, y, z, 0.008, 0.001)
    return shape([(sheet, look.surface(color, "fabric"))], [hull_of(sheet)])


CATEGORIES = (
    Category("cloth", cloth, (0.45, 0.33, 0.0055), 0.5,
             ("linen cloth", "velvet cloth", "spread cloth", "cotton cloth", "white cloth"),
             ("dining", "living"), ("flat", "support", "big"), ("white", "gray", "red"),
             state="lying flat"),
)  # fmt: skip
