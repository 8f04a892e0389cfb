"""What a batch is given, checked: actions, which worlds to reset, and how."""

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
        InputError: they have another shape, or some are not finite; the message names the worlds.
    """
    wanted = torch.as_tensor(actions, dtype=torch.float32, device=device)
    if tuple(wanted.shape) != shape:
        raise InputError(f"Actions must have shape {shape}, got {tuple(wanted.shape)}.")
    finite = torch.isfinite(wanted).all(1)
    if not finite.all():
        wrong = torch.nonzero(~finite)[:, 0].tolist()
        raise InputError(
            f"Actions must be finite; those of the worlds {wrong[:5]} are not"
            + (f", nor those of {len(wrong) - 5} more." if len(wrong) > 5 else ".")
        )
    return wanted.clamp(-1.0, 1.0)


def check_mask(mask: Any, worlds: int) -> Bool[Tensor, "n"]:
    """Return the option "reset_mask" as a tensor on the host; None is all worlds.

    Raises:
        InputError: it is not a bool for each world, or none is True.
    """
    if mask is None:
        return torch.ones(worlds, dtype=torch.bool)
    made = _on_host(mask)
    if made.shape != (worlds,) or made.dtype != torch.bool or not made.any():
        raise InputError(f"reset_mask must be {worlds} bools, one of them True, got {mask!r}.")
    return made


def check_numbers(
    name: str, numbers: Any, mask: Bool[Tensor, "n"], below: int
) -> Int[Tensor, "n"] | None:
    """Return a reset option with a whole number for each world as a tensor on the host.

    Args:
        name: of the option.
        numbers: its value; None stays None.
        mask: which worlds are reset; the numbers of the others are not looked at.
        below: what they have to be less than.

    Raises:
        InputError: it is not a whole number for each world, or one is out of its range.
    """
    if numbers is None:
        return None
    made = _on_host(numbers)
    whole = not (made.is_floating_point() or made.is_complex() or made.dtype == torch.bool)
    if not whole or made.shape != mask.shape or (mask & ((made < 0) | (made >= below))).any():
        raise InputError(
            f"{name} must be {len(mask)} whole numbers from 0 to {below - 1}, one a world, got "
            f"{numbers!r:.200}."
        )
    return made.long()


def _on_host(given: Any) -> Tensor:
    """Return what was given as a tensor on the host; a single 0.0 if it cannot be one."""
    try:
        return torch.as_tensor(given, device="cpu")
    except (TypeError, ValueError, RuntimeError, OverflowError):
        return torch.zeros(())
