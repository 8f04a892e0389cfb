"""Hand-made objects for the judges of the understanding benchmark."""

from collections.abc import Mapping

import numpy as np
from wording.seen import Seen, Thing

TOP = (1.0, 0.6)
"""Width and depth of the table, metres."""
FLOOR = 0.75
"""The height of its top."""


def thing(
    name: str,
    x: float = 0.0,
    y: float = 0.0,
    size: tuple[float, float, float] = (0.06, 0.06, 0.06),
    up: float = 0.0,
    label: str = "",
    stand_in: bool = False,
) -> Thing:
    """Return a box whose bottom is ``up`` metres above the table's top, centred at (x, y)."""
    signs = np.array([[i, j, k] for i in (-0.5, 0.5) for j in (-0.5, 0.5) for k in (0, 1)])
    points = signs * np.array(size) + np.array([x, y, FLOOR + up])
    return Thing(name, label or name.rsplit("_", 1)[0].replace("_", " "), points, stand_in)


def seen(*things: Thing, on: Mapping[str, str] | None = None) -> Seen:
    """Return a table of objects; ``on`` names the supports other than the table."""
    over = on or {}
    carriers = {t.name: frozenset({over.get(t.name, "table")}) for t in things}
    return Seen(things, TOP, carriers)
