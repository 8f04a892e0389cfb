"""The objects and geoms of a compiled world in the robot's base frame, to be copied to a bank.

Numbers are copied from the model that the environment compiles for the scene alone, so that mesh
offsets, bounds and inverse weights are identical floats in both.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from generator.geometry import turned_quaternion
from generator.physics.mjcf import FLOOR
from generator.physics.spec import new_data, scene_spec
from generator.scene import TABLE, Scene

from ....robot.mount import PEDESTAL
from ....world.world import World, gripper_sides
from .look import SceneLook

if TYPE_CHECKING:
    import mujoco

GeomKind = tuple[int, int]
"""Type (``mjtGeom``) and contact dimension of a geom; batched fields cannot change the type or the
dimension."""

GEOM_FIELDS = (
    "geom_size", "geom_aabb", "geom_rbound", "geom_pos", "geom_quat", "geom_friction",
    "geom_solref", "geom_solimp", "geom_solmix",
)  # fmt: skip
"""Fields of a model that a scene sets for each of its geoms."""

BODY_FIELDS = (
    "body_mass", "body_inertia", "body_ipos", "body_iquat", "body_invweight0", "body_subtreemass",
)  # fmt: skip
"""Fields of a model that a scene sets for each of its objects."""


@dataclass(frozen=True, eq=False)
class BodyGeoms:
    """The collision geoms of a body.

    ``kinds`` and ``hulls`` (mesh names, None for primitives) have one entry per geom, and each
    array of ``fields``, by ``GEOM_FIELDS``, has one row per geom.
    """

    kinds: tuple[GeomKind, ...]
    hulls: tuple[str | None, ...]
    fields: Mapping[str, Float[np.ndarray, "k ..."]]

    @cached_property
    def need(self) -> Counter[GeomKind]:
        """The number of geoms of each kind."""
        return Counter(self.kinds)


@dataclass(frozen=True, eq=False)
class ObjectContent:
    """The geoms, inertia (keyed by the names in ``BODY_FIELDS``) and initial pose of an object.

    ``pose`` holds position and quaternion in the base frame, ``half_extent`` the half extents of
    its box (metres), ``dof_invweight0`` MuJoCo's inverse weights of its six degrees of freedom.
    """

    name: str
    geoms: BodyGeoms
    inertia: Mapping[str, Any]
    dof_invweight0: Float[np.ndarray, "6"]
    pose: Float[np.ndarray, "7"]
    half_extent: Float[np.ndarray, "3"]


@dataclass(frozen=True, eq=False)
class SceneContent:
    """The objects, the fixed geoms and the table of a scene.

    ``fixed`` lists the geoms of the table and the pedestal, with positions ``fixed_pos`` and
    rotations ``fixed_mat``. ``table`` is the height of the top above the base and the half extents
    of its outline, the longer first; ``floor`` is the height of the floor and ``yaw`` the yaw of
    the base in the world, all in metres and radians. ``hulls`` holds the vertices of the convex
    meshes by name, ``robot`` the ``robot_numbers``, and ``look`` the appearance of the scene, or
    None without pictures.
    """

    name: str
    objects: tuple[ObjectContent, ...]
    fixed: BodyGeoms
    fixed_pos: Float[np.ndarray, "k 3"]
    fixed_mat: Float[np.ndarray, "k 3 3"]
    table: Float[np.ndarray, "3"]
    floor: float
    yaw: float
    hulls: Mapping[str, Float[np.ndarray, "_v 3"]]
    robot: Float[np.ndarray, "_r"]
    look: SceneLook | None = None

    @classmethod
    def of(cls, world: World, looks: bool = False) -> SceneContent:
        """Read a world's content, with the scene's initial poses; the world is not changed."""
        import mujoco

        model, scene = world.model, world.scene
        data = new_data(model)
        mujoco.mj_kinematics(model, data)
        fixed = [g for name in (TABLE, PEDESTAL) for g in _colliding(model, model.body(name).id)]
        at, turn = data.geom_xpos[fixed], data.geom_xmat[fixed].reshape(-1, 3, 3)
        floor = data.geom_xpos[model.geom(FLOOR).id]
        return cls(
            scene.name,
            tuple(_object(world, k) for k in range(len(world.names))),
            _geoms(model, fixed),
            world.to_base(at),
            world.base_rotation.T @ turn,
            np.array([scene.table.height - world.base_position[2], *world.half_top]),
            float(world.to_base(floor)[2]),
            world.mount.yaw,
            _hulls(scene),
            robot_numbers(model),
            SceneLook.of(world) if looks else None,
        )


def robot_numbers(model: mujoco.MjModel) -> Float[np.ndarray, "_r"]:
    """Return a robot model's inertias, geom sizes, friction and gains, for comparing robots."""
    bodies = np.flatnonzero(gripper_sides(model))
    geoms = np.isin(model.geom_bodyid, bodies) & (model.geom_contype > 0)
    numbers = [getattr(model, field)[bodies] for field in ("body_mass", "body_inertia")]
    numbers += [getattr(model, field)[geoms] for field in ("geom_size", "geom_friction")]
    gains = [model.actuator_gainprm, model.actuator_biasprm]
    return np.concatenate([array.ravel() for array in numbers + gains])


def _object(world: World, row: int) -> ObjectContent:
    """Read the object with index ``row`` in a world."""
    model, body = world.model, int(world.bodies[row])
    thing, dof = world.scene.objects[row], model.body_dofadr[body]
    quaternion = turned_quaternion(thing.pose.quaternion, -world.mount.yaw)
    return ObjectContent(
        thing.name,
        _geoms(model, _colliding(model, body)),
        {field: getattr(model, field)[body].copy() for field in BODY_FIELDS},
        model.dof_invweight0[dof : dof + 6].copy(),
        np.concatenate([world.to_base(thing.pose.position), quaternion]),
        world.half_extent[row],
    )


def _geoms(model: mujoco.MjModel, geoms: list[int]) -> BodyGeoms:
    kinds = zip(model.geom_type[geoms].tolist(), model.geom_condim[geoms].tolist(), strict=True)
    meshes = model.geom_dataid[geoms].tolist()
    return BodyGeoms(
        tuple(kinds),
        tuple(model.mesh(mesh).name if mesh >= 0 else None for mesh in meshes),
        {field: getattr(model, field)[geoms] for field in GEOM_FIELDS},
    )


def _colliding(model: mujoco.MjModel, body: int) -> list[int]:
    """Return the collision geoms of a body."""
    first = model.body_geomadr[body]
    geoms = range(first, first + model.body_geomnum[body])
    return [g for g in geoms if model.geom_contype[g]]


def _hulls(scene: Scene) -> dict[str, Float[np.ndarray, "_v 3"]]:
    meshes = scene_spec(scene, visuals=False).meshes
    return {mesh.name: np.asarray(mesh.uservert, np.float32).reshape(-1, 3) for mesh in meshes}
