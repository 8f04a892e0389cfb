"""How much each world of a batch may touch at once, and the memory that this takes."""

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

# What one world takes in which everything has got into everything else: shipped scenes whose
# objects were all put at one point had up to 500 contacts and 300 pairs.
_SPARE_CONTACTS, _SPARE_DEPTHS = 1024, 512
_EPA_FACES, _EPA_HORIZON = 5, 24  # of MuJoCo Warp's search for the depth of an overlap
_PER_ROW = 40  # bytes of the solver's work for a constraint row


@dataclass(frozen=True)
class BatchLimits:
    """What there is room for.

    Args:
        contacts: contacts, and pairs of geoms that come near, a world. All worlds share them, so
            this is what they have on average; a single one may have far more. Where all together
            have too many, all overflow: it is not known whose contacts are missing.
        depths: overlaps of convex geoms a world whose depth is searched for, shared likewise.
        rows: constraint rows of each world, four or six for a contact. A world that needs more
            overflows.

    Raises:
        InputError: a number is no integer, or less than 1; more depths than contacts.
    """

    contacts: int = 128
    depths: int = 32
    rows: int = 640

    def __post_init__(self) -> None:
        require(self, "contacts", "depths", "rows", minimum=1, integer=True)
        if self.depths > self.contacts:
            raise InputError(
                f"BatchLimits needs depths <= contacts, got {self.depths} and {self.contacts}."
            )

    @classmethod
    def of(cls, bank: SceneBank) -> BatchLimits:
        """Return limits that suit a bank.

        The shipped scenes of up to 6 objects, all of them dropped by 5 mm at once, have 72
        contacts and 12 depths on average and 593 rows at most; one of 9 objects has 1,042 rows.
        """
        return cls() if bank.slots <= 6 else cls(contacts=256, depths=64, rows=1100)

    def pools(self, worlds: int) -> tuple[int, int]:
        """Return how many contacts and depths all worlds share.

        Some are spare, so that the others do not lack what one world takes that has broken down.
        """
        return worlds * self.contacts + _SPARE_CONTACTS, worlds * self.depths + _SPARE_DEPTHS


def bytes_per_world(bank: SceneBank, limits: BatchLimits) -> int:
    """Return about how much memory each world of a batch takes, bytes.

    It is the state, the batched part of the model, and what a step works with.
    """
    model = bank.union.model
    rows = sum(bank.rows[field][0].nbytes for field in MODEL_FIELDS)
    padded = -(-model.nv // 16) * 16
    solver = 2 * 4 * padded**2 + _PER_ROW * limits.rows
    return _state_bytes(model, limits) + rows + solver + limits.depths * _depth_bytes(bank)


def check_memory(bank: SceneBank, limits: BatchLimits, worlds: int, device: torch.device) -> None:
    """Check that so many worlds fit into the memory of a device.

    Raises:
        InputError: they do not; the message says how many do.
    """
    each, free = bytes_per_world(bank, limits), free_bytes(device)
    if worlds * each > free:
        raise InputError(
            f"{worlds} worlds take about {worlds * each / 2**30:.1f} GiB, and {str(device)!r} has "
            f"{free / 2**30:.1f} GiB free: at most {free // each} fit. Ask for fewer, or lower "
            "BatchLimits."
        )


def _state_bytes(model: mujoco.MjModel, limits: BatchLimits) -> int:
    """Return what MuJoCo Warp's data grow by with each world."""
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
    """Return the size of all arrays of a dataclass and of those in it."""
    fields = (getattr(values, field.name) for field in dataclasses.fields(values))
    return sum(
        (field.capacity or 0) if isinstance(field, engine.warp.array)
        else _array_bytes(engine, field) if dataclasses.is_dataclass(field)
        else 0
        for field in fields
    )  # fmt: skip


def _depth_bytes(bank: SceneBank) -> int:
    """Return what the search for one depth works with: a polytope, and two faces that are clipped.

    After the arrays that ``mujoco_warp._src.collision_convex`` allocates.
    """
    model = bank.union.model
    steps = int(model.opt.ccd_iterations)
    vertices, faces = 10 + 2 * steps, 6 + _EPA_FACES * steps
    corners = max(16, int(model.mesh_polyvertnum.max()))
    degree = max(3, int(model.mesh_polymapnum.max()))
    polytope = vertices * (12 + 4) + faces * (4 + 12 + 4) + 4 * _EPA_HORIZON
    clipped = corners * (2 * 12 + 2 * 12 + 12 + 4 + 12 + 12)
    return polytope + clipped + degree * (4 + 4 + 3 * 12)
