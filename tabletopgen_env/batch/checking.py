"""What a batch is given, checked: actions, and which worlds to reset."""

from __future__ import annotations

from typing import Any

import torch
from jaxtyping import Bool, Float
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
    made = torch.as_tensor(mask, device="cpu")
    if made.shape != (worlds,) or made.dtype != torch.bool or not made.any():
        raise InputError(f"reset_mask must be {worlds} bools, one of them True, got {mask!r}.")
    return made
