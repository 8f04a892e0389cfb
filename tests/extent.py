"""The extent of a test run: a representative part of what repeats, or everything.

``make test-all`` sets TABLETOPGEN_EXHAUSTIVE and runs everything; ``make test`` runs the part.
"""

import os
from collections.abc import Iterable
from typing import TypeVar

T = TypeVar("T")

EXHAUSTIVE = bool(os.environ.get("TABLETOPGEN_EXHAUSTIVE"))


def part_of(everything: Iterable[T], *part: T) -> list[T]:
    """Return everything in an exhaustive run, else ``part``, which must be contained in it."""
    found = list(everything)
    missing = [one for one in part if one not in found]
    assert part and not missing, f"{missing} must be among {found}"
    return found if EXHAUSTIVE else list(part)


def count(full: int, part: int) -> int:
    """Return the number of repetitions: ``full`` in an exhaustive run, else ``part``."""
    return full if EXHAUSTIVE else part
