"""Many catalogue objects, tables and textures in one MuJoCo model, for rendering with OpenGL."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, UInt8

from generator.errors import BackendError
from generator.render.shading import corner_normals
from generator.scene import Mesh

if TYPE_CHECKING:
    import mujoco

BACKDROP = 512
"""Side in pixels of the backdrop's texture, which every scene replaces."""


@dataclass(frozen=True, eq=False)
class Stock:
    """Meshes and loose textures compiled into one model.

    Mesh ``k`` has the texture ``k``; loose texture ``j`` has index ``len(frames) + j``; the
    replaceable backdrop is the last. ``frames[k]`` is (rotation, shift): MuJoCo stores mesh ``k``
    about its own centre and axes, and ``rotation @ stored + shift`` is the original mesh.
    """

    model: mujoco.MjModel
    frames: tuple[tuple[Float[np.ndarray, "3 3"], Float[np.ndarray, "3"]], ...]
    loose: int

    @property
    def backdrop(self) -> int:
        """Index of the replaceable texture."""
        return len(self.frames) + self.loose

    def texture(self, index: int) -> int:
        """Return the texture index of the loose texture ``index``."""
        return len(self.frames) + index


def stock(meshes: Sequence[Mesh], textures: Sequence[UInt8[np.ndarray, "h w 3"]]) -> Stock:
    """Compile meshes and textures.

    Raises:
        BackendError: MuJoCo rejects a mesh.
    """
    import mujoco

    spec = mujoco.MjSpec()
    for k, mesh in enumerate(meshes):
        _add_mesh(spec, k, mesh)
    pictures = [mesh.texture for mesh in meshes]
    pictures += [*textures, np.zeros((BACKDROP, BACKDROP, 3), np.uint8)]
    for k, picture in enumerate(pictures):
        _add_texture(spec, k, picture)
    try:
        model = spec.compile()
    except ValueError as error:
        raise BackendError(f"MuJoCo rejects the training meshes: {error}") from error
    frames = []
    for k in range(len(meshes)):
        rotation = np.empty(9)
        mujoco.mju_quat2Mat(rotation, model.mesh_quat[k])
        frames.append((rotation.reshape(3, 3), model.mesh_pos[k].copy()))
    return Stock(model, tuple(frames), len(textures))


def _add_mesh(spec: mujoco.MjSpec, k: int, mesh: Mesh) -> None:
    """Add a mesh with a vertex per face corner, so that each has its own normal."""
    import mujoco

    corner = mesh.faces.ravel()

    made = spec.add_mesh(name=f"m{k}")
    made.uservert = mesh.vertices[corner].ravel()
    made.userface = np.arange(len(corner), dtype=np.int32)
    made.usertexcoord = (mesh.uv[corner] * [1, -1] + [0, 1]).astype(np.float32).ravel()
    made.usernormal = corner_normals(mesh.vertices, mesh.faces).astype(np.float32).ravel()
    made.inertia = mujoco.mjtMeshInertia.mjMESH_INERTIA_SHELL
    spec.worldbody.add_geom(
        type=mujoco.mjtGeom.mjGEOM_MESH, meshname=f"m{k}", contype=0, conaffinity=0
    )


def _add_texture(spec: mujoco.MjSpec, k: int, picture: UInt8[np.ndarray, "h w 3"]) -> None:
    import mujoco

    made = spec.add_texture(
        name=f"t{k}",
        type=mujoco.mjtTexture.mjTEXTURE_2D,
        width=picture.shape[1],
        height=picture.shape[0],
        nchannel=3,
    )
    made.data = np.ascontiguousarray(picture).tobytes()
    material = spec.add_material(name=f"t{k}")
    material.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = f"t{k}"
