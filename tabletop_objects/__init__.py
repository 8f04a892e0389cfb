"""Parametric tabletop objects: textured meshes with convex parts, mass and friction.

    import tabletop_objects as objects

    mug = objects.build("mug", seed=3)          # Model: mesh, parts, size, physics
    objects.search("screw driver")              # categories by name, best match first
    objects.categories(theme="kitchen")         # categories of a theme

``CATEGORIES`` maps keys to categories. ``index.json`` holds their properties, so a lookup does not
import drawing functions; ``build`` imports only the module that draws the object. The names below
are imported on first use.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .catalogue import build as build
    from .catalogue import categories as categories
    from .catalogue import find_category as find_category
    from .catalogue import find_source as find_source
    from .catalogue import get_category as get_category
    from .catalogue import search as search
    from .kit.shapes import Category as Category

    CATEGORIES: Mapping[str, Category]

__all__ = [
    "CATEGORIES",
    "Category",
    "build",
    "categories",
    "find_category",
    "find_source",
    "get_category",
    "search",
]


def __getattr__(name: str) -> object:
    """Import a public name on first use."""
    if name not in __all__:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    from . import catalogue

    value = catalogue.load_index() if name == "CATEGORIES" else getattr(catalogue, name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})
