"""Detection of the objects that the robot touches, based on the contacts of all worlds."""

from __future__ import annotations

import torch
from jaxtyping import Bool, Int
from torch import Tensor

from .slot_union import SlotUnion

LEFT, RIGHT = 2, 3
"""Labels of the fingers; see ``world.gripper_sides``."""


class TouchReader:
    """A detector of the objects that the robot touches, based on the contacts.

    Args:
        union: the model whose geoms are in contact.
        worlds: number of worlds.
        device: device of the contacts.
    """

    def __init__(self, union: SlotUnion, worlds: int, device: torch.device) -> None:
        sides = union.sides[union.model.geom_bodyid]
        self._side = torch.as_tensor(sides, device=device)
        self._slot = torch.as_tensor(union.slot_of, device=device)
        self._shape = worlds, len(union.shape.slots), 3

    def read(
        self, geoms: Int[Tensor, "c 2"], worlds: Int[Tensor, "c"], count: Int[Tensor, "1"]
    ) -> Bool[Tensor, "w s 3"]:
        """Return each object's contact flags for the left finger, right finger and any robot part.

        ``geoms`` and ``worlds`` describe the contacts, of which the first ``count`` are valid.
        """
        spare = self._shape[0] * self._shape[1]  # collects all other contacts
        flags = torch.zeros(spare + 1, 3, dtype=torch.bool, device=geoms.device)
        real = torch.arange(len(geoms), device=geoms.device) < count
        for pair in (geoms, geoms.flip(1)):
            slot, side = self._slot[pair[:, 0]], self._side[pair[:, 1]]
            touching = real & (slot >= 0) & (side > 0)
            place = worlds * self._shape[1] + slot
            for column, match in enumerate((side == LEFT, side == RIGHT, touching)):
                flags[torch.where(touching & match, place, spare), column] = True
        return flags[:spare].reshape(self._shape)
