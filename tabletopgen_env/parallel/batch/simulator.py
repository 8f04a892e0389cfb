"""MuJoCo Warp's model and data for many worlds, and the three compiled graphs that use them."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

import torch
from jaxtyping import Bool, Int
from torch import Tensor

from .engine import Engine
from .limits import BatchLimits
from .union.slot_union import MODEL_FIELDS

if TYPE_CHECKING:
    import mujoco


class Simulator:
    """A simulator of many worlds.

    Each program (a simulation step, a reset, the kinematics) is recorded once as a graph. Launching
    the graph costs next to nothing, while a step of MuJoCo Warp itself takes some hundred kernel
    launches. On a GPU it is a CUDA graph, on the CPU a list that Warp executes in C++.

    Arrays are torch tensors that share memory with Warp's; the first axis is the world.

    Args:
        model: MuJoCo's model.
        worlds: number of worlds.
        limits: limits on contacts and constraints.
        device: "cpu" or a CUDA device.

    Attributes:
        fields: the batched fields of the model, by ``MODEL_FIELDS``.
        chosen: mask of the worlds that ``reset`` resets.
    """

    def __init__(
        self, model: mujoco.MjModel, worlds: int, limits: BatchLimits, device: torch.device
    ) -> None:
        self._engine = engine = Engine.load()
        self._worlds = worlds
        self._torch_device = device
        self._device = engine.warp.device_from_torch(device)
        contacts, depths = limits.pools(worlds)
        with engine.warp.ScopedDevice(self._device):
            self._data = engine.physics.make_data(
                model, nworld=worlds, naconmax=contacts, naccdmax=depths, njmax=limits.rows
            )
        self.chosen: Bool[Tensor, "w"] = torch.zeros(worlds, dtype=torch.bool, device=device)
        self.exchange(model)

    def exchange(self, model: mujoco.MjModel) -> None:
        """Load a model of the same shape without recompiling; the caller must set all fields."""
        warp, physics = self._engine.warp, self._engine.physics
        # A field can mark a mesh as absent only if it has entries for more than one world.
        sizes = dict.fromkeys(MODEL_FIELDS, max(2, self._worlds))
        with warp.ScopedDevice(self._device):
            self._model = made = physics.put_model(model, batch_sizes=sizes)
            made.opt.warn_overflow = 0  # overflows are read from the data instead of printed
            made.opt.graph_conditional &= (
                self._device.is_cpu or warp.is_conditional_graph_supported()
            )
            arrays = {field: warp.to_torch(getattr(made, field)) for field in MODEL_FIELDS}
            self.fields = {field: array[: self._worlds] for field, array in arrays.items()}
            mask, data = warp.from_torch(self.chosen), self._data
            self._step = self._record(lambda: physics.step(made, data))
            self._reset = self._record(lambda: physics.reset_data(made, data, reset=mask))
            self._kinematics = self._record(lambda: physics.kinematics(made, data))
        warp.synchronize_device(self._device)

    def array(self, name: str) -> Tensor:
        """Return an array of the simulation data, such as "qpos" or "contact.geom"."""
        values: Any = self._data
        for part in name.split("."):
            values = getattr(values, part)
        return self._engine.warp.to_torch(values)

    def overflow_bits(self, names: Iterable[str]) -> int:
        """Return the bits that the named overflows set in the array "overflow"."""
        kinds = self._engine.physics.OverflowType
        return sum(int(kinds[name]) for name in names)

    def step(self) -> None:
        """Simulate one step."""
        self._launch(self._step)

    def reset(self, worlds: Int[Tensor, "k"]) -> None:
        """Reset the data of some worlds, including velocities, contacts, forces and warm starts."""
        self.chosen.zero_()
        self.chosen[worlds] = True
        self._launch(self._reset)

    def update_poses(self) -> None:
        """Update the poses of bodies, geoms and sites from the joints, in every world."""
        self._launch(self._kinematics)

    def _record(self, work: Callable[[], Any]) -> Any:
        """Run a function once to compile its kernels, then record it as a graph."""
        work()
        with self._engine.warp.ScopedCapture(device=self._device) as capture:
            work()
        return capture.graph

    def _launch(self, graph: Any) -> None:
        """Launch a graph after the work already queued by torch."""
        warp = self._engine.warp
        stream = None if self._device.is_cpu else warp.stream_from_torch(self._torch_device)
        warp.capture_launch(graph, stream=stream)
