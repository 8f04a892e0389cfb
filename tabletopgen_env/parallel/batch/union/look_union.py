"""A single model that can render many scenes, with a row of varying fields for each scene.

The model is never simulated: poses of geoms, cameras and sun are written for each world from the
bodies of the simulated union.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, Int

from generator.physics.spec import compile_spec

from ....world.composition import MARKER_COLOR, MARKER_SIZE, marker_kind
from ....world.room import AMBIENT, FLOOR_HALF, HEADLIGHT, SUN, TILE, TILES
from .look import LOOKING, DrawnPart, DrawnPose, SceneLook, Skin, local_pose
from .slot_union import SlotUnion
from .template import slot_name

if TYPE_CHECKING:
    import mujoco

_FLOOR, _TABLE = "floor", "table"
_AWAY = np.array([0.0, 0.0, -1000.0])  # metres: position of absent geoms


@dataclass(frozen=True, eq=False)
class LookRows:
    """The fields of g geoms and c cameras that differ between n scenes, in the bodies' frames.

    ``data`` and ``material`` are indices of meshes and materials, -1 for none.
    """

    pos: Float[np.ndarray, "n g 3"]
    mat: Float[np.ndarray, "n g 3 3"]
    size: Float[np.ndarray, "n g 3"]
    data: Int[np.ndarray, "n g"]
    material: Int[np.ndarray, "n g"]
    camera_pos: Float[np.ndarray, "n c 3"]
    camera_mat: Float[np.ndarray, "n c 3 3"]
    fovy: Float[np.ndarray, "n c"]
    sun: Float[np.ndarray, "n 2 3"]
    haze: Float[np.ndarray, "n 2"]


class LookUnion:
    """The model that renders the pictures of a bank's scenes.

    Attributes:
        model: MuJoCo's model: floor, pedestal, marker, table, one mesh per slot, and the robot.
        bodies: the simulated union's body of each geom, 0 for static geoms.
        camera_bodies: the body of each camera of ``look.LOOKING``.
        marker: index of the marker geom.
        rows: the varying fields.

    Args:
        union: the simulated model.
        looks: the appearances of the scenes.
        slots: slot of each object of each scene.
    """

    def __init__(
        self, union: SlotUnion, looks: Sequence[SceneLook], slots: Sequence[Sequence[int]]
    ) -> None:
        first, room = looks[0], len(union.shape.slots)
        self._columns, self._slots = len(first.columns), room
        skins = {part.skin.name: part.skin for look in looks for part in _all_parts(look)}
        self.model = compile_spec(_spec(first, skins, room), "pictures")
        self.marker = 1 + self._columns

        def body(name: str) -> int:
            return int(union.model.body(name).id)

        self.bodies: Int[np.ndarray, "g"] = np.array([
            *[0] * (self.marker + 2), *(body(slot_name(k)) for k in range(room)),
            *(body(part.body) for part in first.robot),
        ])  # fmt: skip
        self.camera_bodies: Int[np.ndarray, "c"] = np.array(
            [0] * (len(LOOKING) - 1) + [body(first.hand)]
        )
        made = [self._row(look, own) for look, own in zip(looks, slots, strict=True)]
        self.rows = LookRows(*(np.stack(parts) for parts in zip(*made, strict=True)))

    def _row(self, look: SceneLook, slots: Sequence[int]) -> tuple[np.ndarray, ...]:
        """Return the fields of ``LookRows`` for a scene."""
        model = self.model
        count = model.ngeom
        pos, mat = np.tile(_AWAY, (count, 1)), np.tile(np.eye(3), (count, 1, 1))
        size, data = model.geom_size.copy(), np.full(count, -1)
        material = model.geom_matid.copy()

        def put(geom: int, pose: DrawnPose) -> None:
            pos[geom], mat[geom] = pose.position, pose.rotation

        def wear(geom: int, part: DrawnPart) -> None:
            mesh = int(model.mesh(part.skin.name).id)
            data[geom], material[geom] = mesh, int(model.mat(part.skin.name).id)
            frame = local_pose(model.mesh_pos[mesh], model.mesh_quat[mesh])  # as compiled
            put(geom, part.pose.of(frame))

        put(0, look.floor)
        for k, column in enumerate(look.columns):
            put(1 + k, column)
            size[1 + k] = look.column_sizes[k]
        table = self.marker + 1
        wear(table, look.table)
        for slot, part in zip(slots, look.objects, strict=True):
            wear(table + 1 + slot, part)
        for k, part in enumerate(look.robot):
            wear(table + 1 + self._slots + k, part)
        cameras = np.stack([c.position for c in look.cameras])
        turns = np.stack([c.rotation for c in look.cameras])
        return pos, mat, size, data, material, cameras, turns, look.fovy, look.sun, look.haze


def _all_parts(look: SceneLook) -> tuple[DrawnPart, ...]:
    return (look.table, *look.objects, *look.robot)


def _spec(look: SceneLook, skins: dict[str, Skin], slots: int) -> mujoco.MjSpec:
    """Return a specification with all geoms in the world body, in ``LookUnion.bodies`` order."""
    import mujoco

    spec, kinds = mujoco.MjSpec(), mujoco.mjtGeom
    head = spec.visual.headlight
    head.ambient, head.diffuse, head.specular = [AMBIENT] * 3, [HEADLIGHT] * 3, [0.0] * 3
    spec.stat.extent, spec.stat.center = 1.0, [0.0, 0.0, 0.0]
    for skin in skins.values():
        _add_skin(spec, skin)
    _add_floor(spec)
    world = spec.worldbody
    half = [FLOOR_HALF, FLOOR_HALF, 0.05]
    world.add_geom(type=kinds.mjGEOM_PLANE, size=half, material=_FLOOR, rgba=[1, 1, 1, 1])
    for size, color in zip(look.column_sizes, look.column_colors, strict=True):
        world.add_geom(type=kinds.mjGEOM_CYLINDER, size=size, rgba=color)
    world.add_geom(type=marker_kind("disc"), size=MARKER_SIZE, rgba=[*MARKER_COLOR, 1.0])
    worn = look.table.skin.name
    for _ in range(1 + slots + len(look.robot)):
        world.add_geom(type=kinds.mjGEOM_MESH, meshname=worn, material=worn)
    for name, fovy in zip(LOOKING, look.fovy, strict=True):
        world.add_camera(name=name, fovy=fovy)
    world.add_light(
        type=mujoco.mjtLightType.mjLIGHT_DIRECTIONAL, dir=[0, 0, -1], diffuse=[SUN] * 3,
        ambient=[0.0] * 3, specular=[0.12] * 3,
    )  # fmt: skip
    return spec


def _add_skin(spec: mujoco.MjSpec, skin: Skin) -> None:
    mesh = spec.add_mesh(name=skin.name, inertia=_shell())
    for name, array in skin.arrays.items():
        setattr(mesh, name, array)
    material = spec.add_material(name=skin.name, **skin.material)
    if skin.texture is not None:
        _add_texture(spec, skin.name, skin.texture)
        _paint(material, skin.name)


def _add_floor(spec: mujoco.MjSpec) -> None:
    import mujoco

    spec.add_texture(
        name=_FLOOR, type=mujoco.mjtTexture.mjTEXTURE_2D,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_CHECKER, rgb1=TILES[1], rgb2=TILES[0],
        width=64, height=64,
    )  # fmt: skip
    repeat = [1 / TILE] * 2
    _paint(
        spec.add_material(name=_FLOOR, texrepeat=repeat, texuniform=True, specular=0, shininess=0),
        _FLOOR,
    )


def _add_texture(spec: mujoco.MjSpec, name: str, texture: np.ndarray) -> None:
    import mujoco

    made = spec.add_texture(name=name, type=mujoco.mjtTexture.mjTEXTURE_2D)
    made.height, made.width, made.nchannel = texture.shape
    made.data = texture.tobytes()
    made.colorspace = mujoco.mjtColorSpace.mjCOLORSPACE_LINEAR


def _paint(material: mujoco.MjsMaterial, texture: str) -> None:
    import mujoco

    material.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = texture


def _shell() -> mujoco.mjtMeshInertia:
    """Return the inertia type of a shell, which is also valid for open surfaces."""
    import mujoco

    return mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
