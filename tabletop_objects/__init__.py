"""Parametric tabletop objects: textured meshes with convex parts, mass and friction.

    import tabletop_objects as objects

    mug = objects.build("mug", seed=3)          # Model: mesh, parts, size, physics
    objects.search("screw driver")              # categories by name, best match first
    objects.categories(theme="kitchen")         # categories of a theme

``CATEGORIES`` maps keys to categories. ``index.json`` holds their facts, so a lookup imports no
drawing function; ``build`` imports the one module that draws the object.
"""

from __future__ import annotations

import hashlib
import json
from collections.abc import Mapping
from functools import cache
from importlib import import_module
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np

from .errors import InputError, choices
from .kit.shapes import Category, Shape, model_of
from .kit.surfaces import Look
from .values import Extent, Holder, Model

if TYPE_CHECKING:
    CATEGORIES: Mapping[str, Category]

__all__ = [
    "CATEGORIES",
    "Category",
    "build",
    "categories",
    "find_category",
    "find_source",
    "search",
]

INDEX = Path(__file__).with_name("index.json")
OBJECTS = f"{__name__}.objects"


def __getattr__(name: str) -> Mapping[str, Category]:
    """Load the index when ``CATEGORIES`` is first used."""
    if name == "CATEGORIES":
        return _load_index()
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")


@cache
def _load_index() -> Mapping[str, Category]:
    """Return every category by key, in the order of their ranks; drawing functions load later."""
    return MappingProxyType(
        {key: _read_row(key, dict(row)) for key, row in json.loads(INDEX.read_bytes()).items()}
    )


def _read_row(key: str, row: dict[str, object]) -> Category:
    module = f"{OBJECTS}.{row.pop('module')}"
    if holder := row.pop("holder", None):
        row["holder"] = Holder(holder[0], tuple(holder[1]))  # type: ignore[index]
    facts = {name: tuple(v) if isinstance(v, list) else v for name, v in row.items()}
    return Category(key, _Deferred(module, key), **facts)  # type: ignore[arg-type]


class _Deferred:
    """A drawing function that imports its module when it is first called."""

    def __init__(self, module: str, key: str) -> None:
        self.module, self.key = module, key

    def __call__(self, look: Look) -> Shape:
        return self.load().shape(look)

    def load(self) -> Category:
        """Return the category as its module declares it."""
        return declared(self.module)[self.key]


def declared(module: str) -> Mapping[str, Category]:
    """Return the categories that a module declares: decorated functions, then ``CATEGORIES``."""
    content = vars(import_module(module))
    drawn = [c for c in content.values() if isinstance(c, Category)]
    own = [c for c in drawn if c.shape.__module__ == module]  # the others are imported
    return {c.key: c for c in (*own, *content.get("CATEGORIES", ()))}


def find_category(word: str) -> Category:
    """Return the category with this key, noun or alias (singular, any case).

    Raises:
        InputError: no category has that name.
    """
    key = _names().get(word.lower().replace("_", " ").strip())
    if key is None:
        raise InputError(f"The catalogue has no {word!r}." + choices(word, _load_index()))
    return _load_index()[key]


def categories(theme: str | None = None, role: str | None = None) -> tuple[Category, ...]:
    """Return the categories of a theme ("kitchen") and with a role ("container"), by rank."""
    return tuple(
        c
        for c in _load_index().values()
        if (theme is None or theme in c.themes) and (role is None or role in c.roles)
    )


def search(text: str, limit: int = 10) -> tuple[Category, ...]:
    """Return the categories whose names match a text best, the best one first.

    A whole name comes before a name that contains the text's words, and that before one that is
    spelled similarly.
    """
    from rapidfuzz import fuzz, process

    word = text.lower().replace("_", " ").strip()
    names = _names()
    scores: dict[str, float] = {}
    for name, score, _ in process.extract(word, names.keys(), scorer=fuzz.WRatio, limit=6 * limit):
        whole = 200.0 if name == word else 50.0 if set(word.split()) <= set(name.split()) else 0.0
        key = names[name]
        scores[key] = max(scores.get(key, 0.0), score + whole)
    best = sorted((key for key in scores if scores[key] >= 70.0), key=lambda key: -scores[key])
    return tuple(_load_index()[key] for key in best[:limit])


@cache
def _names() -> Mapping[str, str]:
    """Return every known name and the key it means; keys win over aliases, lower ranks over all."""
    known = _load_index().values()
    names = {alias: c.key for c in reversed(tuple(known)) for alias in c.aliases}
    names |= {name: c.key for c in known for name in (c.key.replace("_", " "), c.noun)}
    return MappingProxyType(names)


def build(
    key: str,
    seed: int,
    *,
    attributes: Mapping[str, str] = MappingProxyType({}),
    size: Extent | None = None,
) -> Model:
    """Build one variant of a category as a canonical model.

    Args:
        key: a category's key, noun or alias.
        seed: chooses proportions, colours and prints; the same seed gives the same bytes.
        attributes: "color", "material" and "size" words that override the seed's choices, and
            "style": "cartoon" or "low-poly" instead of the plain look.
        size: the extent in metres, if fixed.

    Raises:
        InputError: no category has that name, or the style is unknown.
    """
    category = find_category(key)
    digest = hashlib.sha256(category.key.encode()).digest()
    rng = np.random.default_rng([int(seed) & 0xFFFFFFFF, int.from_bytes(digest[:4], "big")])
    return model_of(load_category(category), Look(rng, attributes), size)


def load_category(category: Category) -> Category:
    """Return a category of the index as its module declares it, with its drawing function."""
    return category.shape.load() if isinstance(category.shape, _Deferred) else category


def find_source(category: Category) -> tuple[Path, int]:
    """Return the file that declares a category of the index, and the line (from 1)."""
    draw = category.shape
    if not isinstance(draw, _Deferred):
        raise InputError(f"{category.key} is not from the index.")
    path = Path(__file__).parent.joinpath(*draw.module.split(".")[1:]).with_suffix(".py")
    marks = f'category("{category.key}",', f'Category("{category.key}",'
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        if any(mark in line for mark in marks):
            return path, number
    raise InputError(f"{path} does not declare {category.key}; rebuild the index.")
