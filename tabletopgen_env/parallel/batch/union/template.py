"""The specification of a union model, and the addresses in the compiled model."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from generator.physics.mjcf import FLOOR, FRICTION_STIFFNESS

from ....robot.hand import FINGER_JOINTS
from ....robot.panda import ARM_JOINTS, Panda
from ....robot.tool import TCP_SITE
from ....world.composition import MARKER, PREFIX, TIMESTEP
from .content import GeomKind
from .shape import Room, UnionShape

if TYPE_CHECKING:
    import mujoco

FIXED = "fixed"
"""Name of the body with the geoms of table and pedestal."""

FLOOR_HALF = (20.0, 20.0, 0.1)
"""Half extents in metres of the floor. The floor is a box, since an absent geom a kilometre below a
plane would be in contact with it.
"""

PARKED, PARKED_APART = 50.0, 3.0
"""Position of absent bodies, and their spacing, in metres."""

TINY = 1e-6
"""Size of absent geoms, in metres."""

_FILLER = "filler"
_TETRAHEDRON = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float32) / 100
# Metres. At MuJoCo's default of 1e-6, which single precision does not resolve at table height, the
# depth of a cylinder in a box comes out as decimetres in 35 of a million cases, and the cylinder is
# ejected; at 1e-5 this happens in none of 600,000, with equally accurate depths.
_CCD_TOLERANCE = 1e-5
# A body whose inertia is aligned with its frame compiles to a diagonal block of the mass matrix,
# with no room for bodies with other inertias. This inertia fits both.
_SKEW = {
    "mass": 1.0,
    "ipos": [0.01, 0.02, 0.03],
    "fullinertia": [0.03, 0.025, 0.02, 1e-3, 2e-3, 3e-3],
}


@dataclass(frozen=True)
class Addresses:
    """Addresses of joints, bodies and a site in the model's arrays, in the order of the slots.

    ``arm_qpos`` and ``arm_dof`` are the seven joints, ``finger_qpos`` the two slides,
    ``slot_bodies`` one body per slot, ``slot_qpos`` 7 entries per slot (position and quaternion),
    ``slot_dof`` 6 (linear velocity in the base frame, angular in the body's); ``tcp`` is the site
    of the tool centre point.
    """

    arm_qpos: slice
    arm_dof: slice
    finger_qpos: slice
    slot_bodies: slice
    slot_qpos: slice
    slot_dof: slice
    tcp: int

    @classmethod
    def of(cls, model: mujoco.MjModel, slots: Sequence[int]) -> Addresses:
        """Return the addresses in a model; ``slots`` are the ids of the bodies of objects."""
        arm = [model.joint(PREFIX + name) for name in ARM_JOINTS]
        fingers = [model.joint(PREFIX + name) for name in FINGER_JOINTS]
        joints = model.body_jntadr[slots]
        return cls(
            _span([int(joint.qposadr[0]) for joint in arm]),
            _span([int(joint.dofadr[0]) for joint in arm]),
            _span([int(joint.qposadr[0]) for joint in fingers]),
            _span(slots),
            _span(model.jnt_qposadr[joints].tolist(), 7),
            _span(model.jnt_dofadr[joints].tolist(), 6),
            int(model.site(PREFIX + TCP_SITE).id),
        )


def slot_name(slot: int) -> str:
    """Return the name of a slot's body."""
    return f"slot{slot}"


def union_spec(
    shape: UnionShape, hulls: Mapping[str, Float[np.ndarray, "_v 3"]], robot: Panda
) -> mujoco.MjSpec:
    """Build the specification of a model of the given ``shape``, in the base frame.

    It simulates as ``World`` does, but without sleeping, and has no visual-only geoms.
    """
    import mujoco

    arm = _undress(robot.spec())
    spec = mujoco.MjSpec()
    spec.compiler.degree = False
    option = spec.option
    option.timestep, option.impratio = TIMESTEP, FRICTION_STIFFNESS
    option.integrator = arm.option.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    option.ccd_tolerance = _CCD_TOLERANCE
    option.cone = mujoco.mjtCone.mjCONE_ELLIPTIC
    for name, vertices in {_FILLER: _TETRAHEDRON, **hulls}.items():
        convex = mujoco.mjtMeshInertia.mjMESH_INERTIA_CONVEX
        spec.add_mesh(name=name, uservert=vertices.ravel(), inertia=convex)
    box = mujoco.mjtGeom.mjGEOM_BOX
    spec.worldbody.add_geom(name=FLOOR, type=box, size=FLOOR_HALF, condim=4, solref=[0.01, 1])
    _add_room(spec.worldbody.add_body(name=FIXED), shape.fixed)
    spec.attach(arm, prefix=PREFIX, frame=spec.worldbody.add_frame())
    for slot, room in enumerate(shape.slots):
        place = [PARKED, PARKED_APART * slot, 0]
        body = spec.worldbody.add_body(
            name=slot_name(slot), pos=place, gravcomp=1, explicitinertial=True, **_SKEW
        )
        body.add_freejoint()
        _add_room(body, room)
    spec.worldbody.add_body(name=MARKER, mocap=True, pos=[0, 0, -1])
    return spec


def places(model: mujoco.MjModel, body: int, room: Room) -> dict[GeomKind, list[int]]:
    """Return the indices of the geoms of each kind in a body of ``union_spec``."""
    first, found = int(model.body_geomadr[body]), {}
    for kind, count in room.items():
        found[kind] = list(range(first, first + count))
        first += count
    return found


def _undress(arm: mujoco.MjSpec) -> mujoco.MjSpec:
    """Remove a robot's non-colliding geoms."""
    for geom in arm.geoms:
        if not (geom.contype or geom.conaffinity):
            arm.delete(geom)
    used = {geom.meshname for geom in arm.geoms}
    for mesh in arm.meshes:
        if mesh.name not in used:
            arm.delete(mesh)
    return arm


def _add_room(body: mujoco.MjsBody, room: Room) -> None:
    """Add the geoms that are counted in ``room`` to a body, in the order of ``places``."""
    import mujoco

    for (kind, condim), count in room.items():
        mesh = kind == mujoco.mjtGeom.mjGEOM_MESH
        form: dict[str, Any] = {"meshname": _FILLER} if mesh else {"size": [TINY] * 3}
        for _ in range(count):
            body.add_geom(type=mujoco.mjtGeom(kind), condim=condim, mass=0, group=3, **form)


def _span(starts: Sequence[int], size: int = 1) -> slice:
    """Return the slice that covers adjacent blocks of ``size`` entries beginning at ``starts``."""
    first = starts[0] if starts else 0
    assert list(starts) == [first + size * k for k in range(len(starts))], starts
    return slice(first, first + size * len(starts))
