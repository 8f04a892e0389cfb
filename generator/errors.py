"""Exceptions that this project raises deliberately; they share one base class.

Each message states the problem, the valid values and a fix. ``choices`` and ``require_known`` help
with names, ``require`` with numeric settings.
"""

from __future__ import annotations

import math
import numbers
from typing import Literal

from tabletop_objects.errors import InputError as InputError
from tabletop_objects.errors import TabletopError as TabletopError
from tabletop_objects.errors import choices as choices
from tabletop_objects.errors import escape as escape
from tabletop_objects.errors import require_known as require_known


class BackendError(TabletopError, RuntimeError):
    """A backend is unknown or not installed, or it failed to answer a request."""


class UnusableError(BackendError):
    """A backend returned an unusable answer; another attempt may succeed."""


class BudgetError(BackendError):
    """A call was not sent because it might exceed the budget."""


class DryRunError(BackendError):
    """A dry run sends no calls; the message lists the calls that it would have sent."""


class StoppedError(BackendError):
    """A call was not sent, or not retried, because the session was stopped."""


class BundleError(TabletopError, RuntimeError):
    """A bundle on disk is damaged, unsafe, missing, or has an unsupported schema."""


class MissingError(BundleError):
    """The bundle does not exist, or another process removed it."""


class StorageError(TabletopError, OSError):
    """A file operation failed: the folder is not writable, the disk is full, or a lock is held."""


class SceneError(TabletopError, RuntimeError):
    """A scene cannot be built, fails its physical gate, or allows no valid task."""


class PlaceError(SceneError):
    """An object cannot stand at the requested position on the table.

    Attributes:
        reason: whether another object is in the way, or the position is off the table.
        free: the nearest free position (x, y) on the table, metres, world frame; None if there is
            none.
    """

    def __init__(
        self,
        message: str,
        reason: Literal["occupied", "off the table"] = "occupied",
        free: tuple[float, float] | None = None,
    ) -> None:
        super().__init__(message)
        self.reason: Literal["occupied", "off the table"] = reason
        self.free = free


MAX_SEED = 2**63 - 1
"""The largest seed that every random number generator in use accepts."""

EXIT_CODES: tuple[tuple[type[TabletopError], int], ...] = (
    (InputError, 2),
    (BackendError, 3),
    (BundleError, 4),
    (StorageError, 5),
    (SceneError, 6),
)
"""Exit codes of the commands by error class."""


def exit_code(error: TabletopError) -> int:
    """Return the exit code of a command that failed with ``error``."""
    return next(code for kind, code in EXIT_CODES if isinstance(error, kind))


def require(
    settings: object,
    *names: str,
    minimum: float | None = None,
    above: float | None = None,
    maximum: float | None = None,
    integer: bool = False,
    allow_inf: bool = False,
) -> None:
    """Check that the fields ``names`` of a settings object are numbers within a range.

    ``above`` is an exclusive lower bound. ``integer`` requires whole numbers. ``allow_inf`` accepts
    infinity.

    Raises:
        InputError: a value is not a number or is out of range.
    """
    for name in names:
        require_number(
            f"{type(settings).__name__}.{name}", getattr(settings, name),
            minimum=minimum, above=above, maximum=maximum, integer=integer, allow_inf=allow_inf,
        )  # fmt: skip


def require_number(
    what: str,
    value: object,
    *,
    minimum: float | None = None,
    above: float | None = None,
    maximum: float | None = None,
    integer: bool = False,
    allow_inf: bool = False,
) -> None:
    """Check one number as ``require`` does.

    ``what`` names the value at the start of the message, such as "--workers".

    Raises:
        InputError: the value is not a number or is out of range.
    """
    kind = numbers.Integral if integer else numbers.Real
    low, high = f" >= {minimum:g}" if minimum is not None else "", ""
    low = f" > {above:g}" if above is not None else low
    if maximum is not None:
        high = f" and <= {maximum:g}" if low else f" <= {maximum:g}"
    number = isinstance(value, kind) and not isinstance(value, bool)
    size = _as_float(value) if number else math.nan
    good = allow_inf or math.isfinite(size)
    good = good and size >= (-math.inf if minimum is None else minimum)
    good = good and size > above if above is not None else good
    if not (good and size <= (math.inf if maximum is None else maximum)):
        raise InputError(
            f"{what} must be a {'whole ' if integer else ''}number{low}{high}, got {value!r}."
        )


def require_seed(seed: object, maximum: int = MAX_SEED) -> None:
    """Check a seed; all commands and functions share this rule.

    Raises:
        InputError: the seed is not a whole number from 0 to ``maximum``, the largest seed that the
            caller's random number generator accepts.
    """
    whole = isinstance(seed, numbers.Integral) and not isinstance(seed, bool)
    if not (whole and 0 <= seed <= maximum):  # type: ignore[operator]
        raise InputError(f"A seed must be a whole number from 0 to {maximum}, got {seed!r:.40}.")


def _as_float(value: object) -> float:
    """Return a number as a float, or infinity if it is too large."""
    try:
        return float(value)  # type: ignore[arg-type]
    except OverflowError:
        return math.inf
