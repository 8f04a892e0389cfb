"""Exports loaded into physics engines by their loader scripts, with one interface."""

from __future__ import annotations

import importlib.util
import logging
import uuid
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType, ModuleType
from typing import Any, Protocol

import mujoco
import numpy as np
from jaxtyping import Float

GRAVITY = 9.81  # m/s²


class EngineScene(Protocol):
    """A scene in an engine; objects have the names of the export."""

    def positions(self) -> Mapping[str, Float[np.ndarray, "3"]]:
        """Return each object's centre of mass, metres."""
        ...

    def remove(self, name: str) -> None:
        """Move an object far away, where it has no contacts."""
        ...

    def tilt(self, angle: float) -> None:
        """Lean gravity towards +x by an angle, radians."""
        ...

    def step(self, seconds: float) -> None:
        """Simulate at least the given number of seconds."""
        ...

    def close(self) -> None:
        """Release the engine."""
        ...


def load_script(folder: Path, engine: str) -> ModuleType:
    """Return the loader script of an export as a separate module."""
    path = folder / f"load_{engine}.py"
    spec = importlib.util.spec_from_file_location(f"{path.stem}_{uuid.uuid4().hex}", path)
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def lean(angle: float) -> list[float]:
    """Return gravity leaning towards +x by an angle."""
    return [GRAVITY * float(np.sin(angle)), 0.0, -GRAVITY * float(np.cos(angle))]


def far(number: int) -> list[float]:
    """Return a unique position high in the air, free for seconds of a fall."""
    return [100.0 + 10 * number, 0.0, 1e4]


class MujocoSimulation:
    """The MJCF export in MuJoCo."""

    def __init__(self, folder: Path) -> None:
        self._model, self._data = load_script(folder, "mujoco").load()
        # Sleeping bodies do not wake when the table leans.
        self._model.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        # Each has one free joint.
        self._bodies = {self._model.body(int(b)).name: int(b) for b in self._model.jnt_bodyid}

    def positions(self) -> Mapping[str, Float[np.ndarray, "3"]]:
        """Return each object's centre of mass, metres."""
        return {name: self._data.xipos[b].copy() for name, b in self._bodies.items()}

    def remove(self, name: str) -> None:
        """Move an object far away, where it has no contacts."""
        start = self._model.jnt_qposadr[self._model.body_jntadr[self._bodies[name]]]
        self._data.qpos[start : start + 3] = far(self._bodies[name])
        mujoco.mj_forward(self._model, self._data)

    def tilt(self, angle: float) -> None:
        """Lean gravity towards +x by an angle, radians."""
        self._model.opt.gravity[:] = lean(angle)

    def step(self, seconds: float) -> None:
        """Simulate at least the given number of seconds."""
        until = self._data.time + seconds
        while self._data.time < until:
            mujoco.mj_step(self._model, self._data)

    def close(self) -> None:
        """Do nothing."""


class PybulletSimulation:
    """The URDF export in PyBullet."""

    def __init__(self, folder: Path) -> None:
        import pybullet

        self._bullet: Any = pybullet
        self._client = pybullet.connect(pybullet.DIRECT)
        bodies: dict[str, int] = load_script(folder, "pybullet").load(self._client)
        self._free = {
            name: body
            for name, body in bodies.items()
            if pybullet.getDynamicsInfo(body, -1, physicsClientId=self._client)[0]
        }
        settings = pybullet.getPhysicsEngineParameters(physicsClientId=self._client)
        self._seconds = float(settings["fixedTimeStep"])

    def positions(self) -> Mapping[str, Float[np.ndarray, "3"]]:
        """Return each object's centre of mass, metres."""
        pose = self._bullet.getBasePositionAndOrientation
        return {name: np.array(pose(b, self._client)[0]) for name, b in self._free.items()}

    def remove(self, name: str) -> None:
        """Move an object far away, where it has no contacts."""
        self._bullet.removeBody(self._free.pop(name), self._client)

    def tilt(self, angle: float) -> None:
        """Lean gravity towards +x by an angle, radians."""
        self._bullet.setGravity(*lean(angle), self._client)

    def step(self, seconds: float) -> None:
        """Simulate at least the given number of seconds."""
        for _ in range(int(np.ceil(seconds / self._seconds - 1e-9))):
            self._bullet.stepSimulation(self._client)

    def close(self) -> None:
        """Release the client."""
        self._bullet.disconnect(self._client)


class DrakeSimulation:
    """The URDF or the SDF export in Drake."""

    def __init__(self, folder: Path) -> None:
        from pydrake.multibody.plant import AddMultibodyPlant
        from pydrake.systems.analysis import Simulator
        from pydrake.systems.framework import DiagramBuilder

        logging.getLogger("drake").setLevel(logging.ERROR)  # hide texture and light messages
        script, builder = load_script(folder, "drake"), DiagramBuilder()
        self._plant: Any = AddMultibodyPlant(script.CONFIG, builder)[0]
        script.load(self._plant)
        self._plant.Finalize()
        self._simulator: Any = Simulator(builder.Build())
        self._context = self._plant.GetMyMutableContextFromRoot(
            self._simulator.get_mutable_context()
        )
        bodies = [self._plant.get_body(k) for k in sorted(self._plant.GetFloatingBaseBodies())]
        self._bodies = {self._plant.GetModelInstanceName(b.model_instance()): b for b in bodies}

    def positions(self) -> Mapping[str, Float[np.ndarray, "3"]]:
        """Return each object's centre of mass, metres."""
        return {
            name: self._plant.EvalBodyPoseInWorld(self._context, body).multiply(
                body.CalcCenterOfMassInBodyFrame(self._context)
            )
            for name, body in self._bodies.items()
        }

    def remove(self, name: str) -> None:
        """Move an object far away, where it has no contacts."""
        from pydrake.math import RigidTransform

        body = self._bodies[name]
        place: Any = far(int(body.index()))
        self._plant.SetFreeBodyPose(self._context, body, RigidTransform(place))

    def tilt(self, angle: float) -> None:
        """Lean gravity towards +x by an angle, radians."""
        self._plant.mutable_gravity_field().set_gravity_vector(np.array(lean(angle)))

    def step(self, seconds: float) -> None:
        """Simulate at least the given number of seconds."""
        self._simulator.AdvanceTo(self._simulator.get_context().get_time() + seconds)

    def close(self) -> None:
        """Do nothing."""


@dataclass(frozen=True)
class ComparedEngine:
    """An engine: its package, the format that it loads, and its simulation."""

    package: str
    to: str
    open: Callable[[Path], EngineScene]

    @property
    def installed(self) -> bool:
        """Whether the package is installed."""
        return importlib.util.find_spec(self.package) is not None


ENGINES: Mapping[str, ComparedEngine] = MappingProxyType(
    {
        "MuJoCo": ComparedEngine("mujoco", "mjcf", MujocoSimulation),
        "PyBullet": ComparedEngine("pybullet", "urdf", PybulletSimulation),
        "Drake (URDF)": ComparedEngine("pydrake", "urdf", DrakeSimulation),
        "Drake (SDF)": ComparedEngine("pydrake", "sdf", DrakeSimulation),
    }
)
"""Compared engines; MuJoCo is first, as the reference."""
