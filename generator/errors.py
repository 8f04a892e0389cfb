"""The errors this project raises on purpose: one base class and its five children.

Each message says what was wrong, what exists instead, and what to do.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable


class TabletopError(Exception):
    """Base of every error the project raises on purpose; catch this to catch them all."""


class InputError(TabletopError, ValueError):
    """What the caller passed in cannot be used: a text, an image, a setting, an action."""


class BackendError(TabletopError, RuntimeError):
    """A backend is unknown, not installed, or failed to answer a stage's question."""


class BundleError(TabletopError, RuntimeError):
    """A bundle on disk is damaged, unsafe, from another schema, or cannot be found."""


class StorageError(TabletopError, OSError):
    """The disk refused: unwritable folder, full disk, lock not obtained."""


class SceneError(TabletopError, RuntimeError):
    """A scene cannot be built, fails its physical gate, or offers nothing to do."""


def choices(wrong: str, available: Iterable[str]) -> str:
    """Return the tail of a message about an unknown name: the near match and what exists."""
    names = sorted(available)
    near = difflib.get_close_matches(wrong, names, n=1)
    hint = f" Did you mean {near[0]!r}?" if near else ""
    listed = ", ".join(names) if names else "nothing"
    return f"{hint} Available: {listed}."
