"""Scene and robot as one MuJoCo specification: the arm on its pedestal, cameras, and the marker."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Literal

import numpy as np

from generator.geometry import Camera, framing_camera, rotation_z, yaw_quaternion
from generator.physics.mjcf import FRICTION_STIFFNESS
from generator.physics.spec import scene_spec
from generator.scene import Scene, View

from ..robot.mount import Mount, add_pedestal
from ..robot.panda import Panda
from ..robot.shells import arm_points
from .room import furnish

if TYPE_CHECKING:
    import mujoco

PREFIX = "panda/"
"""Prefix of the names of the robot's elements."""

FRONT_CAMERA = "front"
"""Name of the camera that views table and robot from across the table."""

WRIST_CAMERA = PREFIX + "wrist"
"""Name of the camera on the hand."""

TOP_CAMERA = "overhead"
"""Name of the camera that views the table from above; the scene already has a "top" camera."""

SIDE_CAMERA = "side"
"""Name of the camera that views table and robot from the robot's left."""

MARKER = "marker/goal"
"""Name of the body and the geom that mark a free goal spot; object names contain no slash."""

MarkerShape = Literal["disc", "ball"]
"""Shapes of the marker: a disc on a surface, or a ball in the air."""

MARKER_COLOR = (0.1, 0.85, 0.25)
"""Red, green, blue of the marker."""

MARKER_SIZE = (0.04, 0.0008, 0.0)
"""MuJoCo size of the disc marker for the default radius, in metres."""

_FRONT_ELEVATION, _FRONT_FOV = np.deg2rad(30.0), np.deg2rad(45.0)
_FRONT_MARGIN = 0.04  # margin of the front camera's picture on each side, relative to its size
_TOP_HEIGHT = 2.0  # height of the top camera above the table, well above the arm, metres
_TOP_MARGIN = 1.08  # extent of its picture, relative to the table

TIMESTEP = 0.002
"""Simulation step, in seconds."""


def compose(
    scene: Scene, robot: Panda, mount: Mount, base: mujoco.MjSpec | None = None
) -> mujoco.MjSpec:
    """Return the specification of ``scene`` with ``robot`` at ``mount``.

    The robot is added to ``base``, a specification of the scene; if it is None, one is built.
    """
    import mujoco

    spec = scene_spec(scene) if base is None else base
    spec.option.timestep = TIMESTEP
    spec.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    spec.option.impratio = FRICTION_STIFFNESS  # prevents slip of grasped objects
    spec.option.noslip_iterations = 0
    spec.option.enableflags |= mujoco.mjtEnableBit.mjENBL_SLEEP
    # Several contacts per pair: with a single one, flat objects rock on hulls and never sleep.
    spec.option.disableflags &= ~int(mujoco.mjtDisableBit.mjDSBL_MULTICCD)
    spec.visual.global_.offwidth = spec.visual.global_.offheight = 2048
    frame = spec.worldbody.add_frame(pos=mount.position, quat=yaw_quaternion(mount.yaw))
    arm = robot.spec()
    arm.assets = {**spec.assets, **arm.assets}  # MuJoCo warns about a child without assets
    spec.attach(arm, prefix=PREFIX, frame=frame)
    add_pedestal(spec, mount)
    front = front_camera(scene, mount, 4, 3)
    furnish(spec, scene, mount, front)
    _add_camera(spec, FRONT_CAMERA, front)
    _add_top_camera(spec, scene, mount)
    _add_camera(spec, SIDE_CAMERA, side_camera(scene, mount, 4, 3))
    marker = spec.worldbody.add_body(name=MARKER, mocap=True, pos=[0, 0, -1])
    marker.add_geom(
        name=MARKER,
        type=marker_kind("disc"),
        size=MARKER_SIZE,
        rgba=[*MARKER_COLOR, 0.0],
        contype=0,
        conaffinity=0,
        group=1,
    )
    return spec


def marker_kind(shape: MarkerShape) -> mujoco.mjtGeom:
    """Return MuJoCo's geom type for a marker."""
    import mujoco

    kinds = mujoco.mjtGeom
    return kinds.mjGEOM_SPHERE if shape == "ball" else kinds.mjGEOM_CYLINDER


def front_camera(scene: Scene, mount: Mount, width: int, height: int) -> Camera:
    """Return the camera that faces the robot and shows the tabletop and the arm in its home pose.

    Both are entirely visible in pictures at least as wide as high.
    """
    return _framing(scene, mount, np.pi / 2, width, height)


def side_camera(scene: Scene, mount: Mount, width: int, height: int) -> Camera:
    """Return the camera on the robot's left, with the same framing as ``front_camera``."""
    return _framing(scene, mount, np.pi, width, height)


def _framing(scene: Scene, mount: Mount, around: float, width: int, height: int) -> Camera:
    """Return a camera that frames the table and arm from bearing ``around`` in the base frame."""
    turn = rotation_z(mount.yaw)
    outline = np.asarray(scene.table.outline, float)
    top = np.column_stack([outline, np.full(len(outline), scene.table.height)])
    shown = np.concatenate([top, arm_points() @ turn.T + mount.position])
    view = View(mount.yaw + around, _FRONT_ELEVATION, _FRONT_FOV)
    camera = framing_camera(shown, view, 1, 1, _FRONT_MARGIN)
    return replace(camera, width=width, height=height)


def _add_camera(spec: mujoco.MjSpec, name: str, camera: Camera) -> None:
    right, down, _ = camera.rotation
    spec.worldbody.add_camera(
        name=name, pos=camera.position, xyaxes=[*right, *-down],
        fovy=float(np.rad2deg(camera.fov)),
    )  # fmt: skip


def _add_top_camera(spec: mujoco.MjSpec, scene: Scene, mount: Mount) -> None:
    """Add the camera above the table, with the robot's side at the bottom of a square picture."""
    axes = rotation_z(mount.yaw)
    outline = scene.table.outline @ axes[:2, :2]
    low, high = outline.min(0), outline.max(0)
    middle = axes[:2, :2] @ ((low + high) / 2)
    half = _TOP_MARGIN * float((high - low).max() / 2)
    spec.worldbody.add_camera(
        name=TOP_CAMERA,
        pos=[*middle, scene.table.height + _TOP_HEIGHT],
        xyaxes=[*-axes[:, 1], *axes[:, 0]],
        fovy=float(np.rad2deg(2 * np.arctan(half / _TOP_HEIGHT))),
    )
