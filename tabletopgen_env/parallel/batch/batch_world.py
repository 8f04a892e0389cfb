"""The batched ``World``: many worlds stepped together, with a different table in each."""

from __future__ import annotations

from collections.abc import Sequence

import torch
from jaxtyping import Bool, Float, Int
from torch import Tensor

from generator.errors import InputError, require_number

from ...robot.panda import HOME_CTRL
from .bank import SceneBank
from .engine import find_device, to_device
from .limits import BatchLimits, check_memory
from .simulator import Simulator
from .state import ARRAYS, FACTS, POSES, BatchState
from .union.contacts import TouchReader
from .union.slot_union import START_FIELDS

DIVERGED = 1e10
"""Positions and velocities beyond this value have diverged; the bound is MuJoCo's mjMAXVAL."""

SPOILING = ("NEFC", "NJMAX_NNZ", "BROADPHASE", "NARROWPHASE", "CCD")
"""MuJoCo Warp's names of the overflow bits after which contacts or constraints are missing. The
other bits report that a solver stopped early.
"""

Indices = Sequence[int] | Int[Tensor, "k"]


class BatchWorld:
    """Scenes of a bank, each with a robot, that are simulated together.

    It simulates as ``World`` does, with the same steps, servos and contacts, but in single
    precision and without putting objects to sleep. Initially world k holds scene k of the bank,
    modulo the number of scenes. On the CPU, equal calls give identical bytes; on a GPU the order of
    sums varies.

    Attributes:
        bank: the scenes.
        num_worlds: number of worlds.
        device: device of the worlds.
        limits: limits on contacts and constraints.
        state: the state of the worlds as tensors; see ``BatchState``.
        bad: which worlds overflowed or diverged in the last step. The state of such a world is
            meaningless until it is loaded again; other worlds are not affected.

    Args:
        bank: the scenes.
        num_worlds: number of worlds.
        device: "cuda", "cuda:<number>" or "cpu".
        limits: limits on contacts and constraints; None for ``BatchLimits.of(bank)``.

    Raises:
        InputError: the device does not exist, memory is insufficient (the message says how many
            worlds fit), the extra ``gpu`` is missing or does not match the version of MuJoCo, or
            ``num_worlds`` is below 1.
    """

    def __init__(
        self,
        bank: SceneBank,
        num_worlds: int,
        *,
        device: str | torch.device = "cuda",
        limits: BatchLimits | None = None,
    ) -> None:
        require_number("num_worlds", num_worlds, minimum=1, integer=True)
        self.num_worlds = num_worlds
        self.device = find_device(device)
        self.limits = limits or BatchLimits.of(bank)
        check_memory(bank, self.limits, num_worlds, self.device)
        union = bank.union
        self._simulator = simulator = Simulator(union.model, num_worlds, self.limits, self.device)
        self._arrays = {name: simulator.array(name) for name in ARRAYS}
        self._spoiling = simulator.overflow_bits(SPOILING)
        self._touching = TouchReader(union, num_worlds, self.device)
        self._home = torch.tensor(HOME_CTRL, device=self.device)
        self._commanded = self._home[:7].repeat(num_worlds, 1)
        self._counts = torch.zeros(2, dtype=torch.long, device=self.device)
        self.bad: Bool[Tensor, "w"] = torch.zeros_like(simulator.chosen)
        self.state = BatchState.of(self._arrays, union.addresses, num_worlds)
        self._take(bank)

    @property
    def overflows(self) -> int:
        """The number of times a world needed more contacts or constraint rows than available."""
        return int(self._counts[0])

    @property
    def divergences(self) -> int:
        """The number of times a world has diverged without an overflow."""
        return int(self._counts[1])

    def swap(self, bank: SceneBank) -> None:
        """Replace the bank with one of the same shape, without recompilation.

        Every world restarts, world k with scene k modulo the number of scenes. ``state`` stays
        valid.

        Raises:
            InputError: the bank has a different shape; create it with ``shape=``.
        """
        if bank.union.shape != self.bank.union.shape:
            raise InputError(
                "The new bank differs in shape from the current one. Create it with "
                "SceneBank(worlds, shape=old.union.shape)."
            )
        self._simulator.exchange(bank.union.model)
        self._take(bank)

    def load(
        self,
        worlds: Indices,
        scenes: Indices,
        *,
        qpos: Float[Tensor, "k nq"] | None = None,
        ctrl: Float[Tensor, "k 8"] | None = None,
    ) -> None:
        """Load scenes of the bank, at rest, into the given worlds. Other worlds do not change.

        Indices on a GPU are not checked, since that would force a synchronisation.

        Args:
            worlds: indices of the worlds, without duplicates.
            scenes: index of each world's scene.
            qpos: initial joint positions; None for the scenes' poses and the robot at home.
            ctrl: initial commands; None to hold the robot at home.

        Raises:
            InputError: an index is out of range, or ``worlds`` and ``scenes`` differ in length.
        """
        at = self._indices("worlds", worlds, self.num_worlds)
        of = self._indices("scenes", scenes, len(self.bank))
        if len(at) != len(of):
            raise InputError(
                f"load requires one scene per world, got {len(of)} scenes for {len(at)} worlds."
            )
        simulator, state = self._simulator, self.state
        for field, rows in simulator.fields.items():
            rows[at] = self._rows[field][of]
        simulator.reset(at)
        for field in START_FIELDS:
            self._arrays[field][at] = self._rows[field][of]
        if qpos is not None:
            state.qpos[at] = qpos
        state.ctrl[at] = self._home if ctrl is None else ctrl
        self._commanded[at] = state.ctrl[at, :7]
        state.touches[at], self.bad[at] = False, False
        state.scene[at] = of
        for name, rows in self._facts.items():
            getattr(state, name)[at] = rows[of]
        self._update_poses(at)

    def step(self, ctrl: Float[Tensor, "w 8"], substeps: int) -> Bool[Tensor, "w"]:
        """Step all worlds ``substeps`` times by ``TIMESTEP`` seconds; return which worlds failed.

        The arm's servo commands are interpolated from those of the last call to ``ctrl``, as in
        ``World.step``; the gripper's command changes at once.

        Raises:
            InputError: ``ctrl`` is not eight commands per world, or ``substeps`` is below 1.
        """
        require_number("substeps", substeps, minimum=1, integer=True)
        if tuple(ctrl.shape) != (self.num_worlds, 8):
            raise InputError(
                f"ctrl must have shape ({self.num_worlds}, 8), got {tuple(ctrl.shape)}."
            )
        wanted = ctrl.to(self.device, torch.float32)
        way = wanted[:, :7] - self._commanded
        self.state.ctrl.copy_(wanted)
        self._arrays["overflow"].zero_()
        for k in range(1, substeps):
            self.state.ctrl[:, :7] = self._commanded + way * (k / substeps)
            self._simulator.step()
        self.state.ctrl.copy_(wanted)
        self._simulator.step()
        self._commanded.copy_(wanted[:, :7])
        self._feel()
        self._judge()
        return self.bad

    # -------------------------------------------------------------------------------------- parts

    def _take(self, bank: SceneBank) -> None:
        """Load a bank's scenes into all worlds, in order, starting over after the last scene."""
        self.bank = bank
        shapes = {**self._arrays, **self._simulator.fields}
        self._rows = {
            name: to_device(rows, self.device).reshape(-1, *shapes[name].shape[1:])
            for name, rows in bank.rows.items()
        }
        self._facts = {name: to_device(getattr(bank, name), self.device) for name in FACTS}
        self.load(range(self.num_worlds), [k % len(bank) for k in range(self.num_worlds)])

    def _indices(self, name: str, given: Indices, count: int) -> Int[Tensor, "k"]:
        """Return indices on the device, after checking them if they come from the host."""
        at = torch.as_tensor(given, dtype=torch.long)
        if at.device.type == "cpu" and len(at) and not 0 <= at.min() <= at.max() < count:
            wrong = sorted({k for k in at.tolist() if not 0 <= k < count})
            raise InputError(f"{name} must be from 0 to {count - 1}, got {wrong[:5]}.")
        return at.to(self.device)

    def _update_poses(self, at: Int[Tensor, "k"]) -> None:
        """Update the poses of the given worlds from their joints, leaving the others unchanged."""
        before = {name: self._arrays[name].clone() for name in POSES}
        self._simulator.update_poses()
        for name, array in before.items():
            array[at] = self._arrays[name][at]
            self._arrays[name].copy_(array)

    def _feel(self) -> None:
        """Update the record of which objects the robot touches."""
        contacts = [self._arrays[name] for name in ("contact.geom", "contact.worldid", "nacon")]
        self.state.touches.copy_(self._touching.read(contacts[0], contacts[1], contacts[2]))

    def _judge(self) -> None:
        """Mark the worlds that overflowed or diverged in the last step."""
        overflowed = (self._arrays["overflow"] & self._spoiling) != 0
        sound = torch.ones_like(self.bad)
        for name in ("qpos", "qvel"):
            sound &= (self._arrays[name].abs() < DIVERGED).all(1)  # False for NaN
        torch.logical_or(overflowed, ~sound, out=self.bad)
        self._counts += torch.stack([overflowed.sum(), (self.bad & ~overflowed).sum()])
