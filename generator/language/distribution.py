"""Tables drawn without a text: a distribution over themes, numbers of things, tables and styles."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from typing import get_args

import numpy as np

from ..errors import InputError, choices
from ..scene import OutlineKind, ScenePlan

Needs = tuple[tuple[str, ...], ...]
"""What a table has to hold: for each entry one of the things that it lists."""

_MOST = 24  # objects of a drawn table
PLAIN = "plain"
"""The style in which things are drawn as they are."""


@dataclass(frozen=True)
class SceneDistribution:
    """What tables are like: each is drawn uniformly and independently of the others.

    What is listed twice is drawn twice as often. Nothing here is random by itself: ``plan`` draws
    with the generator it is given, and the same generator gives the same plan.

    Attributes:
        themes: kinds of table, of ``themes_known()``; () for all of them.
        objects: the least and the most objects, both in [1, 24]; a plan has fewer where the theme
            has no more.
        tables: shapes of the top ("rectangle", "square", "round", "oval", "triangle", "slatted");
            () for those usual for the theme.
        styles: "plain", "cartoon" and "low-poly".
        needs: what each table holds besides, its theme's own things aside: for each entry one
            thing of those it lists, all equally likely, those of the table's theme before others.
            A thing is a name of the catalogue, perhaps after its size: "tray", "small cucumber".
            They count among the ``objects``; at least one other thing is there.

    Raises:
        InputError: an unknown name, or no range of objects.
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
                f"SceneDistribution.objects is the least and the most objects, got {self.objects}."
            )
        low, high = self.objects
        if not 1 <= low <= high <= _MOST:
            raise InputError(
                f"SceneDistribution.objects must be from 1 to {_MOST}, the least first, got "
                f"({low}, {high})."
            )
        object.__setattr__(self, "objects", (low, high))
        self._check_needs()

    def _check_needs(self) -> None:
        """Make tuples of the needs, all of things that there are."""
        from .theme_content import read_need

        given = self.needs
        whole = isinstance(given, tuple | list) and all(isinstance(n, tuple | list) for n in given)
        if not whole or not all(given):
            raise InputError(
                "SceneDistribution.needs lists for each need the things that fill it, for example "
                f"(('tray', 'basket'), ('egg', 'die')), got {given!r}."
            )
        for phrase in (phrase for phrases in given for phrase in phrases):
            if not isinstance(phrase, str) or read_need(phrase) is None:
                raise InputError(
                    f"SceneDistribution.needs: there is no {phrase!r}."
                    + choices(str(phrase), categories_known())
                )
        object.__setattr__(self, "needs", tuple(tuple(phrases) for phrases in given))

    def _check(self, name: str, known: Iterable[str]) -> None:
        """Make a tuple of a field of names, all of them known."""
        given = getattr(self, name)
        if isinstance(given, str):
            raise InputError(f"SceneDistribution.{name} is a tuple, got the text {given!r}.")
        known = tuple(known)
        for word in given:
            if word not in known:
                raise InputError(
                    f"SceneDistribution.{name}: there is no {word!r}." + choices(str(word), known)
                )
        object.__setattr__(self, name, tuple(given))

    def plan(self, rng: np.random.Generator) -> ScenePlan:
        """Draw the plan of one table with ``rng``."""
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
    """Return the name of every theme."""
    from .themes import THEMES

    return tuple(THEMES)


def categories_known() -> tuple[str, ...]:
    """Return the key of every category that a planned object may have."""
    from tabletop_objects import CATEGORIES

    return tuple(CATEGORIES)
