"""Functions that look up object categories and return their properties as JSON values."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import Any

import tabletop_objects
from tabletop_objects import Category, categories, find_category, search
from tabletop_objects.catalogue import find_declaration, find_source, load_category

from ..errors import InputError, require_known

_ROOT = Path(tabletop_objects.__file__).parents[1]
_SUGGESTIONS = 5


def select(theme: str | None = None, role: str | None = None) -> tuple[Category, ...]:
    """Return the categories with the given theme and role, sorted by key.

    Raises:
        InputError: No category has that theme or role.
    """
    if theme is not None:
        require_known(theme, themes(), "Unknown theme")
    if role is not None:
        require_known(role, roles(), "Unknown role")
    return tuple(sorted(categories(theme, role), key=lambda category: category.key))


def themes() -> tuple[str, ...]:
    """Return the themes in alphabetical order; each category is stored under its first theme."""
    return tuple(sorted({theme for category in categories() for theme in category.themes}))


def roles() -> tuple[str, ...]:
    """Return the roles in alphabetical order."""
    return tuple(sorted({role for category in categories() for role in category.roles}))


def find_matches(word: str, limit: int) -> tuple[Category, ...]:
    """Return the categories whose names best match a word, best match first.

    Raises:
        InputError: No category matches.
    """
    if not word.strip():
        raise InputError("The search word is empty; `tabletopgen objects list` prints all objects.")
    matches = search(word, limit)
    if not matches:
        raise InputError(f"No object matches {word!r:.80}." + _suggestions(word))
    return matches


def require_category(word: str) -> Category:
    """Return the category that has the given key, noun or alias.

    Raises:
        InputError: No category has that name.
    """
    category = find_category(word)
    if category is None:
        raise InputError(f"Unknown object {word!r:.80}." + _suggestions(word))
    return category


def require_declaration(word: str) -> Category:
    """Return a category with its drawing function, even if it is not in the index yet.

    Raises:
        InputError: No module declares a category with that name.
    """
    known = find_category(word)
    if known is not None and known.key == word:
        return load_category(known)
    declared = find_declaration(word)
    return load_category(require_category(word)) if declared is None else declared


def _suggestions(word: str) -> str:
    from rapidfuzz import fuzz, process

    names = [name for c in categories() for name in (c.noun, *c.aliases)]
    ranked = process.extract(word.lower(), names, scorer=fuzz.ratio, limit=_SUGGESTIONS)
    found = ", ".join(f"{name!r}" for name, _, _ in ranked)
    return f" The nearest names are {found}. `tabletopgen objects list` prints all objects."


def facts_of(category: Category) -> dict[str, Any]:
    """Return all facts about a category as JSON values."""
    path, line = find_source(category)
    return {
        "key": category.key,
        "noun": category.noun,
        "themes": list(category.themes),
        "roles": list(category.roles),
        "size_m": list(category.size),
        "mass_kg": category.mass,
        "material": category.material,
        "friction": category.sliding_friction,
        "hollow": category.hollow,
        "aliases": list(category.aliases),
        "colors": list(category.colors),
        "state": category.state,
        "opened": category.opened or None,
        "common": category.common,
        "source": source_text(path, line),
    }


def source_text(path: Path, line: int) -> str:
    """Format a source location, for example as "tabletop_objects/objects/office/cups.py:136"."""
    return f"{path.relative_to(_ROOT).as_posix()}:{line}"


def brief_facts(found: Sequence[Category]) -> list[dict[str, Any]]:
    """Return the facts shown in a list of categories, as JSON values."""
    return [
        {
            "key": c.key,
            "noun": c.noun,
            "themes": list(c.themes),
            "roles": list(c.roles),
            "size_m": list(c.size),
            "mass_kg": c.mass,
            "aliases": list(c.aliases),
        }
        for c in found
    ]
