"""Edits as data: an action, its text arguments and, for a move, a position or an angle."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np

from ..backends import Backends
from ..scene import EditKind
from . import actions
from .edited import Edited

WORDS: dict[EditKind, tuple[int, int]] = {
    "swap": (2, 2),
    "add": (1, 1),
    "remove": (1, 1),
    "move": (1, 2),
    "restyle": (1, 99),
}
"""Minimum and maximum number of words for each action."""


@dataclass(frozen=True)
class WordedEdit:
    """One edit of a scene.

    Attributes:
        action: the kind of edit.
        words: for swap, an object's name and its replacement; for add, a description of the object,
            which may include a position; for remove, a name; for move, a name and an optional
            position; for restyle, a style, then names.
        to: for move, x and y of the object's centre, in metres relative to the table's centre.
        turn: for move, the rotation in degrees, counter-clockwise seen from above.
        seed: the random seed; the same bundle, edit and seed give the same scene.
    """

    action: EditKind
    words: tuple[str, ...]
    to: tuple[float, float] | None = None
    turn: float | None = None
    seed: int = 0

    @property
    def is_complete(self) -> bool:
        """Whether the action has all the values it needs, and no others."""
        fewest, most = WORDS[self.action]
        fits = fewest <= len(self.words) <= most
        if self.action != "move":
            return fits and self.to is None and self.turn is None
        ways = (len(self.words) == 2) + (self.to is not None)
        return fits and (ways == 1 or (ways == 0 and self.turn is not None))

    def apply(self, bundle: str | Path, backends: Backends | None = None) -> Edited:
        """Return the edited scene; new objects come from ``backends``, or else from the catalogue.

        Raises:
            InputError: The scene has no such object, or the text does not name a known object.
            BackendError: A backend failed.
            SceneError: There is no room, an object loses its support, or the gate fails.
            BundleError: The bundle is damaged.
        """
        words, seed = self.words, self.seed
        if self.action == "swap":
            return actions.swap(bundle, words[0], words[1], seed, backends)
        if self.action == "add":
            return actions.add(bundle, words[0], seed, backends)
        if self.action == "remove":
            return actions.remove(bundle, words[0])
        if self.action == "move":
            where = words[1] if len(words) == 2 else self.to
            yaw = 0.0 if self.turn is None else float(np.deg2rad(self.turn))
            return actions.move(bundle, words[0], where, yaw, seed, backends)
        return actions.restyle(bundle, words[0], words[1:], seed, backends)
