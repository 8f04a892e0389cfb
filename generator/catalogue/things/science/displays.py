"""The small screens of instruments."""

from __future__ import annotations

from ...surfaces import prints


def display(text: str) -> prints.Canvas:
    """Return a dark screen with one reading on it."""
    screen = prints.canvas(64, 28, (20, 40, 70))
    prints.write(screen, text, 0.5, 0.5, 0.55, (140, 230, 250), True)
    return screen
