"""A scene in MuJoCo, with its poses, contacts between objects, and time."""

from __future__ import annotations

import copy
from collections.abc import Hashable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, field
from functools import lru_cache
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Bool, Float, Int

from ..scene import Object, Pose, Scene
from .mjcf import FLOOR, written_poses
from .spec import compile_spec, new_data, scene_spec, unsimulatable

if TYPE_CHECKING:
    import mujoco

ON_TABLE = -1
"""Index that stands for the table in contacts between a scene's objects."""

ON_FLOOR = -2
"""Index that stands for the floor."""


States = Float[np.ndarray, "n 7"]
"""Position (metres) and quaternion of each object."""

Motion = Float[np.ndarray, "n 2"]
"""Displacement and rotation of each object, in metres and radians."""


@dataclass(frozen=True, eq=False)
class Contacts:
    """Pairs of touching bodies (object indices, ``ON_TABLE`` or ``ON_FLOOR``), lower index first.

    ``distance`` is negative for overlaps, metres. A pair may occur several times.
    """

    pairs: Int[np.ndarray, "n 2"]
    distance: Float[np.ndarray, "n"]

    def deepest(self) -> Mapping[tuple[int, int], float]:
        """Return each pair's maximum overlap in metres, which is 0 for pairs that only touch."""
        found: dict[tuple[int, int], float] = {}
        for (a, b), distance in zip(self.pairs.tolist(), self.distance.tolist(), strict=True):
            found[a, b] = max(found.get((a, b), 0.0), -distance)
        return found


class Simulation:
    """A compiled scene and its state; initially, the objects are at the scene's poses.

    Sleeping is disabled, so that no object is assumed to be at rest. ``fixed`` objects do not
    belong to the scene. They keep their poses and support others like the table; in contacts they
    appear as ``ON_TABLE``.
    """

    def __init__(self, scene: Scene, fixed: Sequence[Object] = ()) -> None:
        import mujoco

        self.scene = scene
        self.model = _compile_at(scene, fixed)
        self.model.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
        self.data = new_data(self.model)
        mujoco.mj_setConst(self.model, self.data)
        bodies = [self.model.body(o.name).id for o in scene.objects]
        owner = np.full(self.model.nbody, ON_TABLE)
        owner[bodies] = np.arange(len(bodies))
        self._owner = owner[self.model.geom_bodyid]
        self._owner[self.model.geom(FLOOR).id] = ON_FLOOR
        self._undamped = self.model.dof_damping.copy()
        self.place(o.pose for o in scene.objects)

    @property
    def time(self) -> float:
        """Simulated time in seconds since :meth:`place` was called."""
        return float(self.data.time)

    @property
    def states(self) -> States:
        """The objects' current positions and quaternions, in the scene's order, as a copy."""
        found = self.data.qpos.reshape(-1, 7).copy()
        found[:, 3:] /= np.linalg.norm(found[:, 3:], axis=1, keepdims=True)
        return found

    @property
    def poses(self) -> tuple[Pose, ...]:
        """The objects' current poses, in the scene's order."""
        return tuple(
            Pose(q[:3], q[3:] / np.linalg.norm(q[3:])) for q in self.data.qpos.reshape(-1, 7)
        )

    @property
    def positions(self) -> Float[np.ndarray, "n 3"]:
        """Centres of the objects' bounding boxes in metres, as a writable view."""
        return self.data.qpos.reshape(-1, 7)[:, :3]

    @property
    def centers_of_mass(self) -> Float[np.ndarray, "n 3"]:
        """World positions of the objects' centres of mass at the last step or contact detection."""
        return self.data.xipos[self.model.nbody - len(self.scene.objects) :]

    @property
    def diverged(self) -> tuple[int, ...]:
        """Objects whose motion has diverged since :meth:`place`, in the scene's order.

        MuJoCo resets the simulation in this case, so later measurements are meaningless.
        """
        import mujoco

        kinds = mujoco.mjtWarning
        lengths = {kinds.mjWARN_BADQPOS: 7, kinds.mjWARN_BADQVEL: 6, kinds.mjWARN_BADQACC: 6}
        raised = [(self.data.warning[int(kind)], length) for kind, length in lengths.items()]
        return tuple(sorted({w.lastinfo // length for w, length in raised if w.number}))

    def place(self, poses: Iterable[Pose]) -> None:
        """Put the objects at ``poses``, at rest, and set the time to 0."""
        import mujoco

        mujoco.mj_resetData(self.model, self.data)
        rows = [np.concatenate([p.position, p.quaternion]) for p in poses]
        self.data.qpos[:] = np.concatenate(rows) if rows else []

    def contacts(self, margin: float = 0.0) -> Contacts:
        """Return the contacts and all pairs at most ``margin`` metres apart, with signed distances.

        Only objects count: the table's contact with the floor is omitted.

        Raises:
            SceneError: there are more contacts than fit in MuJoCo's memory.
        """
        import mujoco

        model, data = self.model, self.data
        flags = model.opt.disableflags
        model.opt.disableflags = flags | int(mujoco.mjtDisableBit.mjDSBL_MULTICCD)
        model.geom_margin[:] = model.body_margin[:] = margin / 2
        with self._as_scene_error():
            mujoco.mj_kinematics(model, data)
            mujoco.mj_comPos(model, data)
            mujoco.mj_collision(model, data)
        model.opt.disableflags = flags
        model.geom_margin[:] = model.body_margin[:] = 0.0
        pairs = np.sort(self._owner[data.contact.geom].reshape(-1, 2), axis=1)
        return Contacts(pairs, np.array(data.contact.dist, float))

    def run(self, seconds: float, damping: float = 0.0) -> None:
        """Simulate for ``seconds``; ``damping`` is the rate (1/s) at which free motion decays.

        Raises:
            SceneError: the objects have more contacts than fit in MuJoCo's memory.
        """
        import mujoco

        mass, turning = self.model.body_mass, self.model.body_inertia.min(1)
        inertia = np.stack([mass] * 3 + [turning] * 3, axis=1)
        start = self.model.nbody - len(self.scene.objects)
        self.model.dof_damping[:] = self._undamped + damping * inertia[start:].ravel()
        with self._as_scene_error():
            mujoco.mj_step(self.model, self.data, round(seconds / self.model.opt.timestep))
        self.model.dof_damping[:] = self._undamped

    @contextmanager
    def conditions(self, lean: float, toward: float, timestep: float) -> Iterator[None]:
        """Temporarily tilt gravity by ``lean`` towards ``toward`` (radians) and set a time step."""
        option = self.model.opt
        before = option.gravity.copy(), option.timestep
        across = np.array([np.cos(toward), np.sin(toward)]) * np.sin(lean)
        option.gravity[:] = np.linalg.norm(before[0]) * np.append(across, -np.cos(lean))
        option.timestep = timestep
        try:
            yield
        finally:
            option.gravity[:], option.timestep = before

    @contextmanager
    def _as_scene_error(self) -> Iterator[None]:
        """Convert MuJoCo's fatal errors to scene errors."""
        import mujoco

        try:
            yield
        except mujoco.FatalError as error:
            raise unsimulatable(self.scene.name, str(error)) from error

    def speeds(self) -> Float[np.ndarray, "n 2"]:
        """Return each object's linear (m/s) and angular (rad/s) speed."""
        return np.linalg.norm(self.data.qvel.reshape(-1, 2, 3), axis=2)


def _compile_at(scene: Scene, fixed: Sequence[Object]) -> mujoco.MjModel:
    """Return a copy of a scene's compiled physics, which ``mj_setConst`` must complete.

    A scene is simulated several times while it settles, each time with other poses. Shapes and
    masses are compiled once for all of these. Once the values that depend on the poses are updated,
    the model is identical, bit for bit, to one compiled at these poses, except for ``stat.center``
    and ``stat.extent``, which affect only rendering.

    Raises:
        SceneError: MuJoCo rejects a body: a flat hull, or an impossible inertia.
    """
    model = copy.copy(_compile(_Bodies.of(scene, fixed)))
    if scene.objects:
        poses = written_poses(scene.objects)
        moving = slice(model.nbody - len(poses), model.nbody)
        model.body_pos[moving], model.body_quat[moving] = poses[:, :3], poses[:, 3:]
        for start in (model.qpos0, model.qpos_spring, model.key_qpos[0]):
            start[:] = poses.ravel()
    return model


@dataclass(frozen=True)
class _Bodies:
    """The data that determine a compiled scene, except the poses of objects that can move."""

    identity: Hashable
    scene: Scene = field(compare=False)
    fixed: Sequence[Object] = field(compare=False)

    @classmethod
    def of(cls, scene: Scene, fixed: Sequence[Object]) -> _Bodies:
        table = scene.table
        shapes = tuple(
            (o.name, o.parts, o.mass, o.friction,
             *(numbers.tobytes() for numbers in (o.scale, o.com, o.inertia)))
            for o in (*fixed, *scene.objects)
        )  # fmt: skip
        places = written_poses(fixed).tobytes()
        identity = scene.name, table.parts, table.height, table.friction, shapes, places
        return cls(identity, scene, fixed)


@lru_cache(maxsize=8)
def _compile(bodies: _Bodies) -> mujoco.MjModel:
    spec = scene_spec(bodies.scene, visuals=False, fixed=bodies.fixed)
    return compile_spec(spec, bodies.scene.name)


def find_supported(contacts: Contacts, count: int) -> Bool[np.ndarray, "n"]:
    """Return which objects the table or the floor supports through a chain of contacts."""
    held = {ON_TABLE, ON_FLOOR}
    links = {(a, b) for a, b in contacts.pairs.tolist()}
    while True:
        more = {x for a, b in links if (a in held) != (b in held) for x in (a, b)} - held
        if not more:
            return np.array([i in held for i in range(count)], bool)
        held |= more


def measure_motion(before: States, after: States) -> Motion:
    """Return each object's displacement (metres) and rotation (radians)."""
    shift = np.linalg.norm(after[:, :3] - before[:, :3], axis=1)
    dots = np.abs((before[:, 3:] * after[:, 3:]).sum(1))
    return np.stack([shift, 2 * np.arccos(np.clip(dots, 0.0, 1.0))], axis=1)


def turn_angles(before: Iterable[Pose], after: Iterable[Pose]) -> Float[np.ndarray, "n"]:
    """Return the angle in radians between two orientations of each object."""
    dots = [abs(float(a.quaternion @ b.quaternion)) for a, b in zip(before, after, strict=True)]
    return 2 * np.arccos(np.clip(dots, 0.0, 1.0))


def shift_distances(before: Iterable[Pose], after: Iterable[Pose]) -> Float[np.ndarray, "n"]:
    """Return the distance in metres between two positions of each object."""
    pairs = zip(before, after, strict=True)
    return np.array([np.linalg.norm(b.position - a.position) for a, b in pairs], float)
