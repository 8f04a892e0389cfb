"""A compiled model of a robot at a table: ids by name, the start state and physics queries.

``World`` puts a robot beside a scene with ``MjSpec.attach`` (prefix "panda/"), compiles it and
keeps model and data.

Positions in observations are in the *base frame*: origin at the robot's base, x forward, z up. It
is the world frame transformed by the mount, so a policy sees every table relative to the robot.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Callable, Hashable, Mapping
from functools import cache, cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import numpy as np
from jaxtyping import Float, Int

from generator.bundle import digest
from generator.errors import SceneError, choices
from generator.geometry import rotation_z
from generator.physics.spec import compile_spec, new_data
from generator.scene import Scene, hold_supports

from ..affordance import (
    Opening,
    Plateau,
    collision_points,
    footprint,
    is_too_wide,
    opening,
    plateau,
    why_not_graspable,
    why_not_liftable,
)
from ..robot.hand import FINGER_JOINTS
from ..robot.mount import Mount
from ..robot.panda import ACTUATORS, ARM_JOINTS, HOME_CTRL, HOME_QPOS, Panda
from ..robot.tool import TCP_SITE
from .composition import MARKER, PREFIX, MarkerShape, compose, marker_kind
from .per_object import PerObject
from .state import WorldState, span

if TYPE_CHECKING:
    import mujoco


_CONTACT = 1e-4
"""Distance between the surfaces of resting objects that still counts as contact, in metres."""

_FIXED_REACH = 0.4
"""Maximum reach of the robot's fixed part from its base, in metres."""


T = TypeVar("T")


class World:
    """A compiled scene with a robot, and its state.

    Attributes:
        scene: the scene, without the supports that its report found not to hold.
        bundle: the bundle folder from which it was read; None if it was not read from one.
        mount: the pose of the robot's base in the world frame.
        model, data: the MuJoCo model and data.
        state: live views of the robot and the objects in ``data``.
        names: names of the scene's objects, in the order of every per-object array.
        bodies: their MuJoCo body ids.
        arm_qpos, arm_dof: addresses of the seven arm joints in qpos and qvel.
        finger_qpos: addresses of the two finger slides in qpos.
        actuators: ids of the seven servos and the gripper.
        robot_bodies: MuJoCo body ids of the robot's links, hand and fingers.
        tcp: id of the tool centre point's site.
        cached: values that callers cache for the original scene, by key; twins share it.
        openings: the hollow of each object by name, None without one.
        plateaus: the flat top of each object by name, None without one.
        absent: objects removed in this episode; see ``randomization``.
    """

    def __init__(
        self, scene: Scene, robot: Panda, mount: Mount | None = None, bundle: Path | None = None
    ) -> None:

        self.bundle = bundle
        self._source = scene
        self.scene = self._given = scene = hold_supports(scene)
        self._own_mount = mount or Mount.beside(scene)
        self.seat(self._own_mount)
        self.absent: frozenset[str] = frozenset()
        self.model = compile_spec(compose(scene, robot, self.mount), scene.name)
        self.data = new_data(self.model)
        self.names: tuple[str, ...] = tuple(o.name for o in scene.objects)
        self._rows = {name: k for k, name in enumerate(self.names)}
        model = self.model
        self.bodies: Int[np.ndarray, "k"] = np.array(
            [model.body(name).id for name in self.names], dtype=int
        )
        self._trees = model.body_treeid[self.bodies].tolist()
        first = model.body_jntadr[self.bodies]
        self._object_qpos = model.jnt_qposadr[first][:, None] + np.arange(7)
        self._object_dof = model.jnt_dofadr[first][:, None] + np.arange(6)
        arm = [model.joint(PREFIX + name) for name in ARM_JOINTS]
        fingers = [model.joint(PREFIX + name) for name in FINGER_JOINTS]
        self.arm_qpos = np.array([joint.qposadr[0] for joint in arm])
        self.arm_dof = np.array([joint.dofadr[0] for joint in arm])
        self.finger_qpos = np.array([joint.qposadr[0] for joint in fingers])
        self._finger_dof = np.array([joint.dofadr[0] for joint in fingers])
        self.actuators = np.array([model.actuator(PREFIX + name).id for name in ACTUATORS])
        self.tcp = int(model.site(PREFIX + TCP_SITE).id)
        self._marker_geom = int(model.geom(MARKER).id)
        self._marker_mocap = int(model.body(MARKER).mocapid[0])
        self._gripper_side = gripper_sides(model)
        self.robot_bodies: Int[np.ndarray, "r"] = np.flatnonzero(self._gripper_side)
        held = (self._gripper_side > 0) & (model.body_weldid == 0)
        self._fixed_geoms = np.flatnonzero(held[model.geom_bodyid] & (model.geom_contype > 0))
        self._points = [collision_points(o) for o in scene.objects]
        self.half_extent = np.array([o.scale / 2 for o in scene.objects]).reshape(-1, 3)
        self._base_reach = _FIXED_REACH + np.linalg.norm(self.half_extent, axis=1)
        self._start = self._start_qpos()
        self._commanded = np.array(HOME_CTRL[:7])
        self.state = self._view_state()
        self._known: dict[Hashable, Any] = {}  # for the current arrangement of the objects
        self._known_of_given = self._known
        self._touches: dict[str, tuple[bool, bool, bool]] = {}
        self.cached: dict[Hashable, Any] = {}
        self.openings: Mapping[str, Opening | None] = PerObject(scene, opening)
        self.plateaus: Mapping[str, Plateau | None] = PerObject(scene, plateau)

    def twin(self) -> World:
        """Return a world of the same scene with a separate model and shared caches."""
        other = copy.copy(self)
        other.model = copy.copy(self.model)
        other.data = new_data(other.model)
        other.state = other._view_state()
        other._touches = {}
        other.reset()
        return other

    # ------------------------------------------------------------------------------------ state

    def _view_state(self) -> WorldState:
        data, rows = self.data, span(self.bodies)
        return WorldState(
            joints=data.qpos[span(self.arm_qpos)],
            joint_velocities=data.qvel[span(self.arm_dof)],
            fingers=data.qpos[span(self.finger_qpos)],
            finger_velocities=data.qvel[span(self._finger_dof)],
            servos=data.ctrl[span(self.actuators[:7])],
            gripper=data.ctrl[span(self.actuators[7:])],
            tool=data.site_xpos[self.tcp],
            hand=data.site_xmat[self.tcp].reshape(3, 3),
            positions=data.xpos[rows],
            rotations=data.xmat[rows].reshape(-1, 3, 3),
            velocities=data.qvel[span(self._object_dof.ravel())].reshape(-1, 6),
        )

    def _start_qpos(self) -> Float[np.ndarray, "nq"]:
        qpos = self.model.qpos0.copy()
        for address, obj in zip(self._object_qpos, self.scene.objects, strict=True):
            qpos[address] = [*obj.pose.position, *obj.pose.quaternion]
        qpos[np.concatenate([self.arm_qpos, self.finger_qpos])] = HOME_QPOS
        return qpos

    def seat(self, mount: Mount) -> None:
        """Set the mount, which defines the base frame."""
        self.mount = mount
        self.base_rotation = rotation_z(mount.yaw)
        self.base_position = np.asarray(mount.position, float)

    def rearrange(self, scene: Scene) -> None:
        """Make ``reset`` start from the poses in ``scene``, which has the same objects."""
        self.scene = scene
        self._start = self._start_qpos()
        self._known = self._known_of_given if scene is self._given else {}

    def reset(self) -> None:
        """Place every object at its settled pose and the robot at home, all at rest."""
        import mujoco

        mujoco.mj_resetData(self.model, self.data)
        self.data.qpos[:] = self._start
        self.data.ctrl[self.actuators] = HOME_CTRL
        self._commanded = self.state.servos.copy()
        self._forward()

    def step(self, substeps: int) -> None:
        """Simulate ``substeps`` steps of ``TIMESTEP`` seconds.

        The arm's servo commands are interpolated linearly from those of the last call to those in
        ``data.ctrl``, as in a real controller: commands that jump at 20 Hz would shake loose a held
        object.
        """
        import mujoco

        model, data, servos, mj_step = self.model, self.data, self.state.servos, mujoco.mj_step
        wanted = servos.copy()
        way = (wanted - self._commanded) / substeps
        for command in self._commanded + way * _count(substeps):
            servos[:] = command
            mj_step(model, data)
        self._commanded = wanted
        self._touches.clear()

    def place_arm(self, joints: Float[np.ndarray, "7"]) -> None:
        """Place the arm at rest at joint angles (rad), and set the servos to hold them."""
        state = self.state
        state.joints[:] = joints
        state.joint_velocities[:] = 0
        state.servos[:] = joints
        self._commanded = state.servos.copy()
        self._forward()

    def teleport(
        self,
        name: str,
        position: Float[np.ndarray, "3"],
        quaternion: Float[np.ndarray, "4"] | None = None,
    ) -> None:
        """Place an object at rest at a world position and wxyz orientation (None keeps it)."""
        k = self.index(name)
        address = self._object_qpos[k]
        self.data.qpos[address[:3]] = position
        if quaternion is not None:
            self.data.qpos[address[3:]] = quaternion
        self.state.velocities[k] = 0
        self._forward()

    def _forward(self) -> None:
        """Compute all quantities derived from a newly written state."""
        import mujoco

        self._touches.clear()
        mujoco.mj_forward(self.model, self.data)

    # ---------------------------------------------------------------------------------- objects

    @cached_property
    def half_top(self) -> Float[np.ndarray, "2"]:
        """The half extents of the tabletop's outline in metres, with the larger one first."""
        half = np.ptp(self.scene.table.outline, axis=0) / 2
        return np.array([half.max(), half.min()])

    @cached_property
    def digest(self) -> str:
        """The digest of the original scene; see ``generator.bundle.digest``."""
        return digest(self._source)

    @cached_property
    def ungraspable(self) -> Mapping[str, str | None]:
        """The reason why each resting object cannot be grasped, or None if it can."""
        return {
            o.name: why_not_liftable(o)
            or why_not_graspable(o, self.openings[o.name] if is_too_wide(o) else None)
            for o in self.scene.objects
        }

    def remember(self, key: Hashable, find: Callable[[], T]) -> T:
        """Return the result of ``find``, cached by ``key`` for the state after ``reset``.

        It is computed again if the base is elsewhere, or an object is displaced or absent.
        """
        off = not np.array_equal(self.data.qpos, self._start)
        if off or self.absent or self.mount is not self._own_mount:
            return find()
        if key not in self._known:
            self._known[key] = find()
        return self._known[key]

    @property
    def footprints(self) -> Mapping[str, Float[np.ndarray, "_k 2"]]:
        """The convex outline of each resting object seen from above, in the world frame."""
        if "footprints" not in self._known:
            self._known["footprints"] = {o.name: footprint(o) for o in self.scene.objects}
        return self._known["footprints"]

    def index(self, name: str) -> int:
        """Return the row of the object ``name`` in per-object arrays.

        Raises:
            SceneError: the object does not exist.
        """
        row = self._rows.get(name)
        if row is None:
            raise SceneError(
                f"Scene {self.scene.name!r} has no object {name!r}." + choices(name, self.names)
            )
        return row

    def position(self, name: str) -> Float[np.ndarray, "3"]:
        """Return the centre of an object's bounding box in the world frame."""
        return self.state.positions[self.index(name)].copy()

    def rotation(self, name: str) -> Float[np.ndarray, "3 3"]:
        """Return an object's body-to-world rotation."""
        return self.state.rotations[self.index(name)].copy()

    def velocity(self, name: str) -> Float[np.ndarray, "6"]:
        """Return an object's linear velocity (world frame) and angular velocity (body frame)."""
        return self.state.velocities[self.index(name)].copy()

    def lowest(self, name: str) -> float:
        """Return the height of an object's lowest point in the world frame."""
        k = self.index(name)
        up = self.state.rotations[k, 2]
        return float(self.state.positions[k, 2] + (self._points[k] @ up).min())

    def off_table(self) -> tuple[str, ...]:
        """Return the objects that fell off the table: those whose centre is below its top."""
        low = self.state.positions[:, 2] < self.scene.table.height
        if not np.count_nonzero(low):
            return ()
        return tuple(self.names[k] for k in np.flatnonzero(low))

    def touches(self, name: str) -> tuple[bool, bool, bool]:
        """Return an object's contact flags for the left finger, right finger and any robot part.

        The result is cached until the next call that moves something. No moving part touches a
        sleeping object, because the arm never sleeps and wakes every object that it touches; only
        the fixed base can touch one.
        """
        found = self._touches.get(name)
        if found is None:
            found = self._touches[name] = self._contacts(self.index(name))
        return found

    def _contacts(self, row: int) -> tuple[bool, bool, bool]:
        """Return the result of ``touches`` for the object with index ``row``."""
        if self.data.tree_asleep[self._trees[row]] >= 0:
            return False, False, self._at_base(row)
        sides: set[int] = set()
        if self.data.ncon:
            pairs = self.model.geom_bodyid[self.data.contact.geom]
            others = pairs[:, ::-1][pairs == self.bodies[row]]
            sides = set(self._gripper_side[others].tolist())
        return 2 in sides, 3 in sides, bool(sides - {0})

    def _at_base(self, row: int) -> bool:
        """Return whether a sleeping object, which has no contacts, rests against a fixed part."""
        import mujoco

        model, data, body = self.model, self.data, self.bodies[row]
        away = data.xpos[body] - self.base_position
        if math.sqrt(away @ away) > self._base_reach[row]:
            return False
        geoms = model.body_geomadr[body] + np.arange(model.body_geomnum[body])
        own = geoms[model.geom_contype[geoms] > 0]
        return any(
            mujoco.mj_geomDistance(model, data, int(one), int(fixed), 1.0, None) <= _CONTACT
            for fixed in self._fixed_geoms
            for one in own
        )

    # -------------------------------------------------------------------------------- base frame

    @property
    def hand(self) -> Float[np.ndarray, "3 3"]:
        """The rotation of the hand, measured at the tool centre point's site, in the base frame."""
        return self.base_rotation.T @ self.state.hand

    def to_base(self, points: Float[np.ndarray, "*n 3"]) -> Float[np.ndarray, "*n 3"]:
        """Transform world points to the base frame."""
        return (points - self.base_position) @ self.base_rotation

    def to_world(self, points: Float[np.ndarray, "*n 3"]) -> Float[np.ndarray, "*n 3"]:
        """Transform points of the base frame to the world frame."""
        return points @ self.base_rotation.T + self.base_position

    def show_marker(
        self, position: Float[np.ndarray, "3"] | None, radius: float, shape: MarkerShape = "disc"
    ) -> None:
        """Show the goal marker at a world position, or hide it, without changing other state."""
        place = [0, 0, -1] if position is None else position
        self.model.geom_type[self._marker_geom] = marker_kind(shape)
        self.model.geom_size[self._marker_geom, 0] = radius
        self.model.geom_rgba[self._marker_geom, 3] = 0.0 if position is None else 0.8
        self.data.mocap_pos[self._marker_mocap] = place
        self.data.xpos[self.model.geom_bodyid[self._marker_geom]] = place
        self.data.geom_xpos[self._marker_geom] = place


@cache
def _count(steps: int) -> Float[np.ndarray, "steps 1"]:
    """Return the numbers from 1 to ``steps`` as a column."""
    column = np.arange(1.0, steps + 1.0)[:, None]
    column.setflags(write=False)
    return column


def gripper_sides(model: mujoco.MjModel) -> Int[np.ndarray, "nbody"]:
    """Return each body's label: 1 for the robot, 2 and 3 for its left and right fingers, else 0."""
    sides = np.zeros(model.nbody, int)
    for k in range(model.nbody):
        name = model.body(k).name
        if name.startswith(PREFIX):
            sides[k] = 2 if "left_finger" in name else 3 if "right_finger" in name else 1
    return sides
