"""Validation of a batch's arguments: actions and reset options."""

from __future__ import annotations

from typing import Any

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from generator.errors import InputError


def check_actions(
    actions: Any, shape: tuple[int, ...], device: torch.device
) -> Float[Tensor, "n a"]:
    """Return actions as a tensor on a device, clipped to [-1, 1].

    Raises:
        InputError: the shape is wrong, or some actions are not finite; the message names the
            worlds.
    """
    wanted = torch.as_tensor(actions, dtype=torch.float32, device=device)
    if tuple(wanted.shape) != shape:
        raise InputError(f"Actions must have shape {shape}, got {tuple(wanted.shape)}.")
    finite = torch.isfinite(wanted).all(1)
    if not finite.all():
        wrong = torch.nonzero(~finite)[:, 0].tolist()
        raise InputError(
            f"Actions must be finite, but those of the worlds {wrong[:5]} are not"
            + (f", nor those of {len(wrong) - 5} more." if len(wrong) > 5 else ".")
        )
    return wanted.clamp(-1.0, 1.0)


def check_mask(mask: Any, worlds: int) -> Bool[Tensor, "n"]:
    """Return the option "reset_mask" as a tensor on the host; None selects all worlds.

    Raises:
        InputError: the mask is not one bool per world, or no entry is True.
    """
    if mask is None:
        return torch.ones(worlds, dtype=torch.bool)
    made = _on_host(mask)
    if made.shape != (worlds,) or made.dtype != torch.bool or not made.any():
        raise InputError(
            f"reset_mask must be {worlds} bools, at least one of them True, got {mask!r}."
        )
    return made


def check_numbers(
    name: str, numbers: Any, mask: Bool[Tensor, "n"], below: int
) -> Int[Tensor, "n"] | None:
    """Return a reset option with one integer per world as a tensor on the host.

    Args:
        name: name of the option.
        numbers: value of the option; None stays None.
        mask: the worlds to reset; the numbers of the other worlds are ignored.
        below: exclusive upper bound of the numbers.

    Raises:
        InputError: the value is not one integer per world, or an integer is out of range.
    """
    if numbers is None:
        return None
    made = _on_host(numbers)
    whole = not (made.is_floating_point() or made.is_complex() or made.dtype == torch.bool)
    if not whole or made.shape != mask.shape or (mask & ((made < 0) | (made >= below))).any():
        raise InputError(
            f"{name} must be {len(mask)} integers from 0 to {below - 1}, one per world, got "
            f"{numbers!r:.200}."
        )
    return made.long()


def _on_host(given: Any) -> Tensor:
    """Return a value as a tensor on the host, or a single 0.0 if it cannot be converted."""
    try:
        return torch.as_tensor(given, device="cpu")
    except (TypeError, ValueError, RuntimeError, OverflowError):
        return torch.zeros(())
