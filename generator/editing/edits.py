"""Edits as people put them: an action, a few words, for a move maybe a place or an angle."""

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
"""The fewest and the most words that each action is given."""


@dataclass(frozen=True)
class WordedEdit:
    """One edit of a scene.

    Attributes:
        action: what is done.
        words: swap: a thing's name, and what takes its place; add: what is added, and where;
            remove: a name; move: a name, and maybe where to; restyle: a style, then names.
        to: with move, x and y of the thing's centre in metres from the table's.
        turn: with move, degrees it turns, counter-clockwise seen from above.
        seed: the same bundle, edit and seed give the same scene.
    """

    action: EditKind
    words: tuple[str, ...]
    to: tuple[float, float] | None = None
    turn: float | None = None
    seed: int = 0

    @property
    def is_complete(self) -> bool:
        """Whether the action has what it needs, and nothing that it does not take."""
        fewest, most = WORDS[self.action]
        fits = fewest <= len(self.words) <= most
        if self.action != "move":
            return fits and self.to is None and self.turn is None
        ways = (len(self.words) == 2) + (self.to is not None)
        return fits and (ways == 1 or (ways == 0 and self.turn is not None))

    def apply(self, bundle: str | Path, backends: Backends | None = None) -> Edited:
        """Return the edited scene; ``backends`` draw and model what is new, None: the catalogue.

        Raises:
            InputError: no such thing in the scene, or nothing to put there.
            BackendError: a backend could not answer.
            SceneError: no room, something is left without support, or the gate fails.
            BundleError: the bundle is damaged.
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
