"""Random tables without a text: a distribution over themes, object counts, tables and styles."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import get_args

import numpy as np

from ..errors import InputError, choices
from ..scene import OutlineKind, ScenePlan

Needs = tuple[tuple[str, ...], ...]
"""The objects that a table needs; each entry lists alternatives, one of which is present."""

_MAX_OBJECTS = 24  # maximum number of objects on a table
PLAIN = "plain"
"""The style without any stylisation."""


@dataclass(frozen=True)
class SceneDistribution:
    """A distribution over tables; each property is drawn uniformly and independently of the others.

    A value listed twice is drawn twice as often. The distribution itself has no random state:
    ``plan`` draws from the generator that it is given; equal generators give the same plan.

    Attributes:
        themes: kinds of table, from ``themes_known()``; () means all of them.
        objects: minimum and maximum number of objects, both in [1, 24]; a plan has fewer if its
            theme has fewer.
        tables: shapes of the tabletop ("rectangle", "square", "round", "oval", "triangle",
            "slatted"); () means those that are usual for the theme.
        styles: one or more of "plain", "cartoon" and "low-poly".
        needs: objects on every table in addition to those of its theme. Each entry lists
            alternatives, one of which is present. All are equally likely, except that those of the
            table's theme are preferred. An alternative is a name in the catalogue, optionally
            preceded by a size: "tray", "small cucumber". These objects count towards ``objects``;
            at least one other object is present.

    Raises:
        InputError: A name is unknown, or the range of objects is invalid.
    """

    themes: tuple[str, ...] = ()
    objects: tuple[int, int] = (4, 8)
    tables: tuple[OutlineKind, ...] = ()
    styles: tuple[str, ...] = (PLAIN,)
    needs: Needs = ()

    def __post_init__(self) -> None:
        from tabletop_objects.kit.styles import STYLES

        self._check("themes", themes_known())
        self._check("tables", get_args(OutlineKind))
        self._check("styles", (PLAIN, *STYLES))
        if not self.styles:
            raise InputError("A SceneDistribution needs a style, for example styles=('plain',).")
        whole = isinstance(self.objects, tuple | list) and len(self.objects) == 2
        if not whole or not all(isinstance(n, int) for n in self.objects):
            raise InputError(
                "SceneDistribution.objects must be the minimum and maximum number of objects, got "
                f"{self.objects}."
            )
        low, high = self.objects
        if not 1 <= low <= high <= _MAX_OBJECTS:
            raise InputError(
                f"SceneDistribution.objects must be from 1 to {_MAX_OBJECTS}, minimum first, got "
                f"({low}, {high})."
            )
        object.__setattr__(self, "objects", (low, high))
        self._check_needs()

    def _check_needs(self) -> None:
        """Convert ``needs`` to tuples, and check that all objects in them exist."""
        from .theme_content import read_need

        given = self.needs
        whole = isinstance(given, tuple | list) and all(isinstance(n, tuple | list) for n in given)
        if not whole or not all(given):
            raise InputError(
                "SceneDistribution.needs must list the possible objects of each need, for example "
                f"(('tray', 'basket'), ('egg', 'die')), got {given!r}."
            )
        for phrase in (phrase for phrases in given for phrase in phrases):
            if not isinstance(phrase, str) or read_need(phrase) is None:
                raise InputError(
                    f"SceneDistribution.needs: unknown object {phrase!r}."
                    + choices(str(phrase), categories_known())
                )
        object.__setattr__(self, "needs", tuple(tuple(phrases) for phrases in given))

    def _check(self, name: str, known: Iterable[str]) -> None:
        """Convert a field of names to a tuple, and check that all names are known."""
        given = getattr(self, name)
        if isinstance(given, str):
            raise InputError(f"SceneDistribution.{name} must be a tuple, got the string {given!r}.")
        known = tuple(known)
        for word in given:
            if word not in known:
                raise InputError(
                    f"SceneDistribution.{name}: unknown value {word!r}." + choices(str(word), known)
                )
        object.__setattr__(self, name, tuple(given))

    def plan(self, rng: np.random.Generator) -> ScenePlan:
        """Draw the plan of one table from ``rng``."""
        from .theme_content import furnish

        themes = self.themes or themes_known()
        theme = themes[int(rng.integers(len(themes)))]
        count = int(rng.integers(self.objects[0], self.objects[1] + 1))
        outline = self.tables[int(rng.integers(len(self.tables)))] if self.tables else None
        style = self.styles[int(rng.integers(len(self.styles)))]
        table, objects = furnish(theme, count, rng, outline, self.needs)
        article = "an" if table.outline == "oval" else "a"
        drawn = "" if style == PLAIN else f", {style} style"
        words = f"{article} {table.outline} {theme} table with {len(objects)} objects{drawn}"
        return ScenePlan(words, table, tuple(objects), style)


def themes_known() -> tuple[str, ...]:
    """Return the names of all themes."""
    from .themes import THEMES

    return tuple(THEMES)


def categories_known() -> tuple[str, ...]:
    """Return the keys of all categories that planned objects may have."""
    from tabletop_objects import CATEGORIES

    return tuple(CATEGORIES)
