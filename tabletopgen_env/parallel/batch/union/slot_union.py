"""A single model that fits many scenes: a robot and slots of free bodies.

MuJoCo Warp steps one model in many worlds. *Batched* fields can differ between worlds: the mesh of
a geom, sizes, offsets, masses. The body tree, geom types and contact dimensions are shared. Every
slot is therefore a free body with as many geoms of each kind as any scene needs there. In a world
that needs fewer

- absent meshes have ``geom_dataid`` -1, which excludes them from collisions;
- absent primitives are a micrometre in size and a kilometre away;
- absent bodies are parked 50 m away, without gravity, and never move.

The world frame is the robot's base frame: tables are placed relative to the robot, and readings
need no transform. Only this module and ``template`` know of absent geoms, so the scheme can be
replaced.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping

import numpy as np
from jaxtyping import Float, Int

from generator.errors import InputError
from generator.physics.mjcf import FLOOR
from generator.physics.spec import compile_spec, new_data

from ....robot.panda import HOME_QPOS, Panda
from ....world.world import gripper_sides
from .content import BODY_FIELDS, GEOM_FIELDS, BodyGeoms, ObjectContent, SceneContent, robot_numbers
from .shape import UnionShape
from .template import FIXED, FLOOR_HALF, TINY, Addresses, places, slot_name, union_spec

MODEL_FIELDS = (*GEOM_FIELDS, "geom_dataid", *BODY_FIELDS, "body_gravcomp", "dof_invweight0")
"""Fields of the model that differ between worlds."""

START_FIELDS = ("qpos", "geom_xpos", "geom_xmat")
"""Fields of the state that a scene sets: its initial state, and the poses of fixed geoms, which
MuJoCo Warp reads from the state and not from the model.
"""

Row = Mapping[str, np.ndarray]
"""One scene's ``MODEL_FIELDS`` and ``START_FIELDS``, in the shapes of MuJoCo's model and data."""

# metres: distance of absent geoms, and between those of successive bodies
_FAR, _FAR_APART = 1000.0, 10.0


class SlotUnion:
    """The union model for a given ``UnionShape``.

    Attributes:
        shape: the shape.
        model: MuJoCo's model, with every slot empty.
        addresses: addresses of joints, slots and the tool centre point.
        sides: label of each body: 1 for the robot, 2 for its left finger, 3 for its right finger, 0
            for all other bodies.
        slot_of: slot of each geom, -1 for geoms that do not belong to an object.

    Args:
        shape: number of geoms of each body.
        hulls: vertices of the convex meshes of all scenes by name, metres.
        robot: the robot.
    """

    def __init__(
        self, shape: UnionShape, hulls: Mapping[str, Float[np.ndarray, "_v 3"]], robot: Panda
    ) -> None:
        self.shape = shape
        self.model = model = compile_spec(union_spec(shape, hulls, robot), "union")
        names = [FIXED, *map(slot_name, range(len(shape.slots)))]
        self._bodies = [int(model.body(name).id) for name in names]
        rooms = zip(self._bodies, (shape.fixed, *shape.slots), strict=True)
        self._geoms = [places(model, body, room) for body, room in rooms]
        self._floor = int(model.geom(FLOOR).id)
        self._meshes = {name: int(model.mesh(name).id) for name in hulls}
        self._robot = robot_numbers(model)
        self.addresses = Addresses.of(model, self._bodies[1:])
        self.sides: Int[np.ndarray, "nbody"] = gripper_sides(model)
        self.slot_of: Int[np.ndarray, "ngeom"] = np.full(model.ngeom, -1)
        for slot in range(len(shape.slots)):
            self.slot_of[self._all_geoms(slot + 1)] = slot
        self._empty = self._empty_row()

    def row(self, content: SceneContent, slots: tuple[int, ...]) -> Row:
        """Build the row of field values for a scene, given ``slots`` from ``UnionShape.assign``.

        Raises:
            InputError: the scene was compiled with a different robot.
        """
        if not np.array_equal(content.robot, self._robot):
            raise InputError(
                f"The world of {content.name!r} has a different robot than the bank: compile the "
                "world with the bank's Panda, and do not modify the Panda's model."
            )
        row = {field: array.copy() for field, array in self._empty.items()}
        row["geom_xpos"][self._floor, 2] = content.floor - FLOOR_HALF[2]
        fixed = self._fill(row, 0, content.fixed)
        row["geom_xpos"][fixed], row["geom_xmat"][fixed] = content.fixed_pos, content.fixed_mat
        for thing, slot in zip(content.objects, slots, strict=True):
            self._put(row, slot, thing)
        return row

    def _all_geoms(self, place: int) -> list[int]:
        """Return the static geoms if ``place`` is 0, or else the geoms of slot ``place - 1``."""
        return [geom for geoms in self._geoms[place].values() for geom in geoms]

    def _empty_row(self) -> dict[str, np.ndarray]:
        """Build the row of an empty scene with only the robot and the floor."""
        import mujoco

        model = self.model
        data = new_data(model)
        mujoco.mj_kinematics(model, data)
        row = {field: np.array(getattr(model, field)) for field in MODEL_FIELDS}
        row["geom_xpos"] = data.geom_xpos.copy()
        row["geom_xmat"] = data.geom_xmat.reshape(-1, 3, 3).copy()
        row["qpos"] = model.qpos0.copy()
        row["qpos"][self.addresses.arm_qpos] = HOME_QPOS[:7]
        row["qpos"][self.addresses.finger_qpos] = HOME_QPOS[7:]
        for place in range(len(self._geoms)):
            absent = self._all_geoms(place)
            away = [0.0, 0.0, _FAR + _FAR_APART * place]
            row["geom_pos"][absent] = row["geom_xpos"][absent] = away
            row["geom_size"][absent] = row["geom_rbound"][absent, None] = TINY
            row["geom_aabb"][absent] = [0.0, 0.0, 0.0, TINY, TINY, TINY]
            row["geom_dataid"][absent] = -1
        return row

    def _fill(self, row: dict[str, np.ndarray], place: int, geoms: BodyGeoms) -> list[int]:
        """Write a body's geoms into the row; return their indices in the model."""
        left: dict[object, Iterator[int]] = {k: iter(g) for k, g in self._geoms[place].items()}
        used = [next(left[kind]) for kind in geoms.kinds]
        for field, values in geoms.fields.items():
            row[field][used] = values
        row["geom_dataid"][used] = [-1 if h is None else self._meshes[h] for h in geoms.hulls]
        return used

    def _put(self, row: dict[str, np.ndarray], slot: int, thing: ObjectContent) -> None:
        """Write an object into a slot of the row."""
        self._fill(row, slot + 1, thing.geoms)
        body, addresses = self._bodies[slot + 1], self.addresses
        for field, value in thing.inertia.items():
            row[field][body] = value
        row["body_gravcomp"][body] = 0.0
        row["dof_invweight0"][addresses.slot_dof][6 * slot : 6 * slot + 6] = thing.dof_invweight0
        row["qpos"][addresses.slot_qpos][7 * slot : 7 * slot + 7] = thing.pose
