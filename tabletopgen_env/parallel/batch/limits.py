"""Limits on the contacts in a batch's worlds, and the memory that the worlds need."""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import torch

from generator.errors import InputError, require

from .bank import SceneBank
from .engine import Engine, free_bytes
from .union.slot_union import MODEL_FIELDS

if TYPE_CHECKING:
    import mujoco

# What one world needs if all objects overlap: shipped scenes with all objects at one point had up
# to 500 contacts and 300 pairs.
_SPARE_CONTACTS, _SPARE_DEPTHS = 1024, 512
_EPA_FACES, _EPA_HORIZON = 5, 24  # limits of MuJoCo Warp's penetration depth search
_PER_ROW = 40  # bytes of solver memory per constraint row


@dataclass(frozen=True)
class BatchLimits:
    """Limits on contacts and constraints.

    Args:
        contacts: average number of contacts, and of nearby geom pairs, per world. All worlds share
            one pool, so a single world can have far more. If the pool overflows, all worlds are
            marked, since it is unknown whose contacts are missing.
        depths: average number per world of overlapping convex geoms whose depth is computed, also
            pooled.
        rows: maximum number of constraint rows of each world, four or six per contact. A world that
            needs more overflows.

    Raises:
        InputError: a number is not an integer or less than 1, or depths exceed contacts.
    """

    contacts: int = 128
    depths: int = 32
    rows: int = 640

    def __post_init__(self) -> None:
        require(self, "contacts", "depths", "rows", minimum=1, integer=True)
        if self.depths > self.contacts:
            raise InputError(
                f"BatchLimits.depths must be at most BatchLimits.contacts, got {self.depths} and "
                f"{self.contacts}."
            )

    @classmethod
    def of(cls, bank: SceneBank) -> BatchLimits:
        """Return limits that suit a bank.

        The shipped scenes of up to 6 objects, with all objects dropped from 5 mm at once, have 72
        contacts and 12 depths on average and at most 593 rows; a scene of 9 objects has 1,042 rows.
        """
        return cls() if bank.slots <= 6 else cls(contacts=256, depths=64, rows=1100)

    def pools(self, worlds: int) -> tuple[int, int]:
        """Return the numbers of contacts and penetration-depth searches reserved for all worlds.

        The pools include spare entries, so that one diverging world does not exhaust them.
        """
        return worlds * self.contacts + _SPARE_CONTACTS, worlds * self.depths + _SPARE_DEPTHS


def bytes_per_world(bank: SceneBank, limits: BatchLimits) -> int:
    """Estimate the memory that each world of a batch needs, in bytes.

    It includes the state, the batched part of the model, and the working memory of a step.
    """
    model = bank.union.model
    rows = sum(bank.rows[field][0].nbytes for field in MODEL_FIELDS)
    padded = -(-model.nv // 16) * 16
    solver = 2 * 4 * padded**2 + _PER_ROW * limits.rows
    return _state_bytes(model, limits) + rows + solver + limits.depths * _depth_bytes(bank)


def check_memory(bank: SceneBank, limits: BatchLimits, worlds: int, device: torch.device) -> None:
    """Check that the worlds fit into the memory of a device.

    Raises:
        InputError: they do not fit; the message says how many do.
    """
    each, free = bytes_per_world(bank, limits), free_bytes(device)
    if worlds * each > free:
        raise InputError(
            f"{worlds} worlds take about {worlds * each / 2**30:.1f} GiB, and {str(device)!r} "
            f"has {free / 2**30:.1f} GiB free: at most {free // each} fit. Use fewer worlds, "
            "or lower the values of BatchLimits."
        )


def _state_bytes(model: mujoco.MjModel, limits: BatchLimits) -> int:
    """Return the number of bytes by which each world enlarges MuJoCo Warp's data."""
    engine = Engine.load()
    with engine.warp.ScopedDevice("cpu"):
        one, two = (
            _array_bytes(
                engine,
                engine.physics.make_data(
                    model, nworld=worlds, nconmax=limits.contacts, njmax=limits.rows
                ),
            )
            for worlds in (1, 2)
        )
    return two - one


def _array_bytes(engine: Engine, values: Any) -> int:
    """Return the size of all arrays of a dataclass, including nested ones."""
    fields = (getattr(values, field.name) for field in dataclasses.fields(values))
    return sum(
        (field.capacity or 0) if isinstance(field, engine.warp.array)
        else _array_bytes(engine, field) if dataclasses.is_dataclass(field)
        else 0
        for field in fields
    )  # fmt: skip


def _depth_bytes(bank: SceneBank) -> int:
    """Return the memory in bytes of one penetration-depth search: a polytope and two clipped faces.

    The sizes are those of the arrays that ``mujoco_warp._src.collision_convex`` allocates.
    """
    model = bank.union.model
    steps = int(model.opt.ccd_iterations)
    vertices, faces = 10 + 2 * steps, 6 + _EPA_FACES * steps
    corners = max(16, int(model.mesh_polyvertnum.max()))
    degree = max(3, int(model.mesh_polymapnum.max()))
    polytope = vertices * (12 + 4) + faces * (4 + 12 + 4) + 4 * _EPA_HORIZON
    clipped = corners * (2 * 12 + 2 * 12 + 12 + 4 + 12 + 12)
    return polytope + clipped + degree * (4 + 4 + 3 * 12)
