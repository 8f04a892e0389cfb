"""What callers pass to a vector environment, checked."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from gymnasium import spaces
from gymnasium.vector import AutoresetMode
from jaxtyping import Bool, Float

from generator.errors import InputError, require_known, require_seed

from ...actions import check_action
from .slots import name_slot


def check_actions(actions: Any, count: int, space: spaces.Box) -> Float[np.ndarray, "n a"]:
    """Return the actions of ``count`` slots as ``actions.check_action`` does each.

    Raises:
        InputError: a wrong number of them, or one is wrong; a note says of which slot.
    """
    if (given := _length(actions)) != count:
        raise InputError(f"{count} slots need as many actions, got {given}.")
    if isinstance(actions, np.ndarray) and actions.dtype.kind in "fiu":
        array = actions.astype(np.float64)
        if array.shape == (count, *space.shape) and np.isfinite(array).all():
            return np.minimum(np.maximum(array, space.low), space.high)
    checked = []
    for k, action in enumerate(actions):
        try:
            checked.append(check_action(action, space))
        except InputError as error:
            raise name_slot(error, k) from None
    return np.stack(checked)


def read_mode(mode: str | AutoresetMode) -> AutoresetMode:
    """Return what follows an episode's end, of a mode's value ("NextStep") or name ("NEXT_STEP").

    Raises:
        InputError: there is no such mode.
    """
    if isinstance(mode, str) and mode in AutoresetMode.__members__:
        return AutoresetMode[mode]
    if not isinstance(mode, AutoresetMode):
        require_known(mode, [m.value for m in AutoresetMode], "Unknown autoreset mode")
    return AutoresetMode(mode)


def read_seeds(seed: int | Sequence[int | None] | None, count: int) -> list[int | None]:
    """Return the seeds of all slots: of one seed, that and the next ones.

    Raises:
        InputError: it is no seed, or there are more or fewer than slots.
    """
    if seed is None:
        return [None] * count
    if isinstance(seed, int | np.integer):
        require_seed(seed)
        return [int(seed) + k for k in range(count)]
    if (given := _length(seed)) != count:
        raise InputError(f"{count} slots need one seed or {count}, got {given}.")
    return list(seed)


def read_mask(mask: Any, count: int) -> Bool[np.ndarray, "n"]:
    """Return which slots to reset; all, where ``mask`` is None.

    Raises:
        InputError: it is no array of as many bools as slots, or none of them is True.
    """
    if mask is None:
        return np.ones(count, bool)
    mask = np.asarray(mask)
    if mask.shape != (count,) or mask.dtype != bool or not mask.any():
        raise InputError(
            f"reset_mask must be an array of {count} bools, one of them True, got {mask.tolist()}."
        )
    return mask


def _length(given: Any) -> int | str:
    """Return how many were given, or, of what has no length, how it reads."""
    try:
        return len(given)
    except TypeError:
        return repr(given)
