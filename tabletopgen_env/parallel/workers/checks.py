"""Validation of the arguments of a vector environment."""

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
    """Validate the actions of ``count`` slots, each as ``actions.check_action`` does.

    Raises:
        InputError: the number of actions is wrong, or an action is invalid; a note names the slot.
    """
    if (given := _length(actions)) != count:
        raise InputError(f"{count} slots require one action each, got {given}.")
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
    """Return the autoreset mode with the given value ("NextStep") or name ("NEXT_STEP").

    Raises:
        InputError: the mode does not exist.
    """
    if isinstance(mode, str) and mode in AutoresetMode.__members__:
        return AutoresetMode[mode]
    if not isinstance(mode, AutoresetMode):
        require_known(mode, [m.value for m in AutoresetMode], "Unknown autoreset mode")
    return AutoresetMode(mode)


def read_seeds(seed: int | Sequence[int | None] | None, count: int) -> list[int | None]:
    """Return the seed of each slot; a single seed is incremented by one from slot to slot.

    Raises:
        InputError: a seed is invalid, or their number differs from the number of slots.
    """
    if seed is None:
        return [None] * count
    if isinstance(seed, int | np.integer):
        require_seed(seed)
        return [int(seed) + k for k in range(count)]
    if (given := _length(seed)) != count:
        raise InputError(
            f"{count} slots require a single seed or a list of {count} seeds, got {given}."
        )
    return list(seed)


def read_mask(mask: Any, count: int) -> Bool[np.ndarray, "n"]:
    """Return the slots to reset as a mask; None selects all.

    Raises:
        InputError: the mask is not an array of one bool per slot, or no entry is True.
    """
    if mask is None:
        return np.ones(count, bool)
    mask = np.asarray(mask)
    if mask.shape != (count,) or mask.dtype != bool or not mask.any():
        raise InputError(
            f"reset_mask must be an array of {count} bools, at least one of them True, got "
            f"{mask.tolist()}."
        )
    return mask


def _length(given: Any) -> int | str:
    """Return the length of a value for messages, or its representation if it has no length."""
    try:
        return len(given)
    except TypeError:
        return repr(given)
