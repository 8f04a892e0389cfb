"""Text that may be foreign, on a terminal."""

from __future__ import annotations


def escaped(text: str) -> str:
    """Return a text that may be foreign as a terminal can show it: its lines, no controls."""
    return "".join(c if c.isprintable() or c == "\n" else repr(c)[1:-1] for c in text)
