"""The appearance of a compiled world in the robot's base frame, for rendering."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float, Int, Shaped

from generator.physics.mjcf import FLOOR
from generator.physics.spec import new_data
from generator.scene import TABLE

from ....robot.mount import PEDESTAL
from ....world.composition import FRONT_CAMERA, PREFIX, SIDE_CAMERA, TOP_CAMERA, WRIST_CAMERA
from ....world.world import World

if TYPE_CHECKING:
    import mujoco

LOOKING = (FRONT_CAMERA, TOP_CAMERA, SIDE_CAMERA, WRIST_CAMERA)
"""Names of the cameras in the model; the last camera is on the hand."""

_DRAWN_GROUPS = (0, 1, 2)


@dataclass(frozen=True, eq=False)
class DrawnPose:
    """A position (metres) and a rotation matrix, relative to a parent frame."""

    position: Float[np.ndarray, "3"]
    rotation: Float[np.ndarray, "3 3"]

    def of(self, other: DrawnPose) -> DrawnPose:
        """Transform a pose from this frame to its parent frame."""
        at = self.position + self.rotation @ other.position
        return DrawnPose(at, self.rotation @ other.rotation)


@dataclass(frozen=True, eq=False)
class Skin:
    """A mesh with its material, as compiled by MuJoCo; skins with equal ``name`` are equal.

    ``arrays`` are MjSpec's mesh arrays (vertices, faces, normals, texture coordinates),
    ``material`` the numbers of its material, ``texture`` its picture, None for a uniform colour.
    """

    name: str
    arrays: Mapping[str, Shaped[np.ndarray, "_n"]]
    material: Mapping[str, Any]
    texture: Shaped[np.ndarray, "h w c"] | None


@dataclass(frozen=True, eq=False)
class DrawnPart:
    """A mesh with a material on a named body, or fixed in the base frame if the name is empty."""

    skin: Skin
    body: str
    pose: DrawnPose


@dataclass(frozen=True, eq=False)
class SceneLook:
    """The appearance of a scene.

    Attributes:
        table: the table; ``objects``: the objects in the scene's order, each on its own body.
        robot: the arm's parts on the arm's bodies.
        floor: pose of the floor's plane.
        columns: poses of the pedestal's cylinders, with their ``column_sizes`` and
            ``column_colors``.
        cameras: poses of ``LOOKING``, the last one on the body ``hand``; ``fovy`` in degrees.
        sun: position and direction of the light.
        haze: start and end distance of the haze, metres from the camera.
    """

    table: DrawnPart
    objects: tuple[DrawnPart, ...]
    robot: tuple[DrawnPart, ...]
    floor: DrawnPose
    columns: tuple[DrawnPose, ...]
    column_sizes: Float[np.ndarray, "k 3"]
    column_colors: Float[np.ndarray, "k 4"]
    cameras: tuple[DrawnPose, ...]
    hand: str
    fovy: Float[np.ndarray, "c"]
    sun: Float[np.ndarray, "2 3"]
    haze: Float[np.ndarray, "2"]

    @classmethod
    def of(cls, world: World) -> SceneLook:
        """Read a world's appearance, with the scene's initial poses; the world is not changed."""
        import mujoco

        model = world.model
        data = new_data(model)
        mujoco.mj_kinematics(model, data)
        mujoco.mj_comPos(model, data)
        mujoco.mj_camlight(model, data)

        def base(position: np.ndarray, rotation: np.ndarray) -> DrawnPose:
            return DrawnPose(
                world.to_base(position), world.base_rotation.T @ rotation.reshape(3, 3)
            )

        def stands(geom: int) -> DrawnPose:
            return base(data.geom_xpos[geom], data.geom_xmat[geom])

        columns = drawn_geoms(model, int(model.body(PEDESTAL).id))
        (table,) = drawn_geoms(model, int(model.body(TABLE).id))
        cameras = [int(model.camera(name).id) for name in LOOKING]
        hand = int(model.cam_bodyid[cameras[-1]])
        poses = [base(data.cam_xpos[c], data.cam_xmat[c]) for c in cameras[:-1]]
        poses.append(local_pose(model.cam_pos[cameras[-1]], model.cam_quat[cameras[-1]]))
        turn = world.base_rotation.T
        sight = model.vis.map
        sun = np.stack([world.to_base(data.light_xpos[0]), turn @ data.light_xdir[0]])
        return cls(
            DrawnPart(_skin(model, table), "", stands(table)),
            tuple(part for body in world.bodies for part in _parts(model, int(body))),
            tuple(part for body in arm_bodies(model) for part in _parts(model, body)),
            stands(int(model.geom(FLOOR).id)),
            tuple(stands(geom) for geom in columns),
            model.geom_size[columns],
            model.geom_rgba[columns],
            tuple(poses),
            model.body(hand).name,
            model.cam_fovy[cameras],
            sun,
            np.array([sight.fogstart, sight.fogend]) * model.stat.extent,
        )


def drawn_geoms(model: mujoco.MjModel, body: int) -> list[int]:
    """Return the geoms of a body that are visible in pictures."""
    first = int(model.body_geomadr[body])
    geoms = range(first, first + int(model.body_geomnum[body]))
    return [g for g in geoms if model.geom_group[g] in _DRAWN_GROUPS]


def arm_bodies(model: mujoco.MjModel) -> list[int]:
    """Return the bodies of the robot."""
    return [k for k in range(model.nbody) if model.body(k).name.startswith(PREFIX)]


def _parts(model: mujoco.MjModel, body: int) -> list[DrawnPart]:
    return [
        DrawnPart(
            _skin(model, g),
            model.body(body).name,
            local_pose(model.geom_pos[g], model.geom_quat[g]),
        )
        for g in drawn_geoms(model, body)
    ]


def local_pose(position: np.ndarray, quaternion: np.ndarray) -> DrawnPose:
    """Return the pose given by a position in metres and a unit wxyz quaternion."""
    import mujoco

    rotation = np.zeros(9)
    mujoco.mju_quat2Mat(rotation, quaternion)
    return DrawnPose(position.copy(), rotation.reshape(3, 3))


def _skin(model: mujoco.MjModel, geom: int) -> Skin:
    """Return the mesh and the material of a geom."""
    import mujoco

    mesh, mat = int(model.geom_dataid[geom]), int(model.geom_matid[geom])
    assert model.geom_type[geom] == mujoco.mjtGeom.mjGEOM_MESH and mesh >= 0 and mat >= 0
    faces = slice(model.mesh_faceadr[mesh], model.mesh_faceadr[mesh] + model.mesh_facenum[mesh])

    def rows(array: np.ndarray, first: Sequence[int], count: Sequence[int]) -> np.ndarray:
        return array[first[mesh] : first[mesh] + count[mesh]].ravel().copy()

    arrays: dict[str, Int[np.ndarray, "_n"] | Float[np.ndarray, "_n"]] = {
        "uservert": rows(model.mesh_vert, model.mesh_vertadr, model.mesh_vertnum),
        "userface": model.mesh_face[faces].ravel().copy(),
        "usernormal": rows(model.mesh_normal, model.mesh_normaladr, model.mesh_normalnum),
        "userfacenormal": model.mesh_facenormal[faces].ravel().copy(),
    }
    texture, role = None, int(mujoco.mjtTextureRole.mjTEXROLE_RGB)
    if model.mesh_texcoordadr[mesh] >= 0 and (tex := int(model.mat_texid[mat, role])) >= 0:
        first, count = model.mesh_texcoordadr, model.mesh_texcoordnum
        arrays["usertexcoord"] = rows(model.mesh_texcoord, first, count)
        arrays["userfacetexcoord"] = model.mesh_facetexcoord[faces].ravel().copy()
        shape = model.tex_height[tex], model.tex_width[tex], model.tex_nchannel[tex]
        start = int(model.tex_adr[tex])
        texture = model.tex_data[start : start + int(np.prod(shape))].reshape(shape).copy()
    names = ("specular", "shininess", "emission")
    material = {name: float(getattr(model, f"mat_{name}")[mat]) for name in names}
    material["rgba"] = model.mat_rgba[mat].tolist()
    digest = hashlib.sha256(repr(sorted(material.items())).encode())
    for array in (*arrays.values(), *(() if texture is None else (texture,))):
        digest.update(array.tobytes())
    return Skin(digest.hexdigest()[:16], arrays, material, texture)
