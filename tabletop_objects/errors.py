"""Errors for invalid input, and the base class of all errors in the project."""

from __future__ import annotations

import unicodedata
from collections.abc import Collection, Iterable

_SIMILAR = 60.0  # minimum similarity of a misspelt name, out of 100


class TabletopError(Exception):
    """Base class of all errors that the project raises deliberately.

    The message is safe to print on a terminal: control characters in quoted text are escaped.
    """

    def __str__(self) -> str:
        return escape(super().__str__())


class InputError(TabletopError, ValueError):
    """Raised if an argument, such as a text, an image, a setting or an action, is invalid."""


def choices(wrong: str, available: Iterable[str]) -> str:
    """Return a suggestion and all valid names, to be appended to an error about an unknown name."""
    names = sorted(available)
    shown = ", ".join(names) if names else "nothing"
    return f"{suggestion(wrong, names)} Available: {shown}."


def suggestion(wrong: str, names: Collection[str]) -> str:
    """Return " Did you mean 'mug'?" with the most similar name, or "" if none is similar."""
    from rapidfuzz import fuzz, process

    latest = sorted(names, reverse=True)  # of equally similar names, the last is chosen
    near = process.extractOne(wrong, latest, scorer=fuzz.ratio, score_cutoff=_SIMILAR)
    return f" Did you mean {near[0]!r}?" if near else ""


def require_known(value: object, known: Collection[str], unknown: str) -> None:
    """Check that a value is one of ``known``; the error message begins with ``unknown``.

    Raises:
        InputError: the value is unknown: "Unknown task 'Lif'. Did you mean 'Lift'? Available: ...".
    """
    if not isinstance(value, str) or value not in known:
        raise InputError(f"{unknown} {value!r}." + choices(str(value), known))


def escape(text: str) -> str:
    """Return a text with its control characters escaped, so that a terminal can print it safely."""
    return "".join(c if _is_shown(c) else repr(c)[1:-1] for c in text)


def _is_shown(letter: str) -> bool:
    return letter.isprintable() or letter == "\n" or unicodedata.category(letter) == "Zs"
