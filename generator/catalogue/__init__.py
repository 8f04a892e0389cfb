"""Parametric everyday objects and tables, textured, watertight, with analytic collision shapes.

``CATEGORIES`` lists the categories, ``build`` makes one variant, ``build_table`` a table.
"""

from .build.category import Category
from .opening import cut_category, is_lit, open_category
from .registry import CATEGORIES, build, category
from .tables import build_table

__all__ = [
    "CATEGORIES",
    "Category",
    "build",
    "build_table",
    "category",
    "cut_category",
    "is_lit",
    "open_category",
]
