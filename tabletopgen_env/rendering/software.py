"""Rendering without OpenGL: the model's visible geoms are drawn as triangles in software."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace
from functools import lru_cache
from typing import TYPE_CHECKING
from weakref import WeakKeyDictionary

import numpy as np
from jaxtyping import Float, Int, Shaped, UInt8

from generator.scene.triangles import scaled_normals

from ..world.composition import MARKER
from ..world.room import backdrop
from .kinds import Drawer, Kind
from .views import model_camera

if TYPE_CHECKING:
    import mujoco

    from generator.render.raster import Item
    from generator.render.shading import Light

    from ..world.world import World
    from .kinds import Profile

_ROUND = 24  # sides of a drawn cylinder
_KEPT = 64  # cached round shapes of different sizes
_FACING = 0.7  # average share of the headlight that reaches visible surfaces
_VISIBLE_GROUPS = 3  # geom groups 0, 1 and 2 are drawn, as MuJoCo does


@dataclass(frozen=True, eq=False)
class VisibleGeom:
    """A visible geom: a local triangle mesh, uv coordinates, and a texture tinted by ``tint``."""

    geom: int
    vertices: Float[np.ndarray, "n 3"]
    faces: Int[np.ndarray, "m 3"]
    uv: Float[np.ndarray, "n 2"]
    texture: UInt8[np.ndarray, "th tw 3"]
    tint: Float[np.ndarray, "3"]


class SoftwareDrawer(Drawer):
    """A renderer based on ``generator.render.raster``, without any graphics library."""

    def __init__(self, height: int, width: int, profile: Profile) -> None:
        self._size, self._full = (height, width), profile == "full"
        self._shapes: WeakKeyDictionary[World, list[VisibleGeom]] = WeakKeyDictionary()

    def draw(
        self, world: World, camera: str, kinds: Collection[Kind]
    ) -> dict[Kind, Shaped[np.ndarray, "h w *_c"]]:
        """Return the requested pictures, rendered together."""
        from generator.render.raster import render

        if world not in self._shapes:
            self._shapes[world] = visible_shapes(world.model)
        shapes = self._shapes[world] = [_paint(world.model, s) for s in self._shapes[world]]
        made = render(
            [item for shape in shapes if (item := _item(world, shape))],
            model_camera(world, camera, *self._size),
            light=_light(world.model),
            supersample=2 if self._full and "rgb" in kinds else 1,
            shadows=self._full,
            backdrop=backdrop(world.model),
        )
        drawn: dict[Kind, Shaped[np.ndarray, "h w *_c"]] = {
            "rgb": made.image, "depth": made.depth, "segmentation": made.ids,
        }  # fmt: skip
        return {kind: drawn[kind] for kind in kinds}

    def forget(self, world: World) -> None:
        """Free the triangles of ``world``."""
        self._shapes.pop(world, None)

    def close(self) -> None:
        """Free all triangles."""
        self._shapes.clear()


def _paint(model: mujoco.MjModel, shape: VisibleGeom) -> VisibleGeom:
    """Return a shape with its texture in the current colour of the geom."""
    tint = _color(model, shape.geom)[:3]
    if np.array_equal(tint, shape.tint):
        return shape
    return replace(shape, texture=_texture(model, shape.geom), tint=tint.copy())


def _light(model: mujoco.MjModel) -> Light:
    """Return a model's light: its first sun, and sky light from the ambient light and headlight."""
    from generator.render.shading import Light

    head, sun = model.vis.headlight, model.light_diffuse[0]
    sky = head.ambient + _FACING * head.diffuse
    tint = (sun + sky) / max(float((sun + sky).mean()), 1e-9)
    return Light(
        -model.light_dir[0], float(sun.mean()), float(sky.mean()), tint=tuple(tint.tolist())
    )


def _item(world: World, shape: VisibleGeom) -> Item | None:
    """Return the shape at its current world pose, or None if it is fully transparent."""
    from generator.render.raster import Item

    model, data, k = world.model, world.data, shape.geom
    rgba = _color(model, k)
    if rgba[3] <= 0.01:
        return None
    vertices, faces, uv = shape.vertices, shape.faces, shape.uv
    if model.geom(k).name == MARKER and (mesh := _triangles(model, k)):  # its shape changes
        vertices, faces, uv = mesh
    placed = vertices @ data.geom_xmat[k].reshape(3, 3).T + data.geom_xpos[k]
    return Item(placed, faces, uv, shape.texture, k, float(rgba[3]))


# ---------------------------------------------------------------------------------- tessellation


def visible_shapes(model: mujoco.MjModel) -> list[VisibleGeom]:
    """Return every geom of the visible groups, except the floor, as triangles."""
    shapes = []
    for k in range(model.ngeom):
        if model.geom_group[k] < _VISIBLE_GROUPS and (mesh := _triangles(model, k)):
            tint = _color(model, k)[:3].copy()
            shapes.append(VisibleGeom(k, *mesh, _texture(model, k), tint))
    return shapes


def _triangles(model: mujoco.MjModel, k: int) -> tuple[np.ndarray, np.ndarray, np.ndarray] | None:
    """Return the vertices (n, 3), faces (m, 3) and uv (n, 2) of geom ``k`` in its local frame."""
    import mujoco

    kind, size = mujoco.mjtGeom(model.geom_type[k]), model.geom_size[k]
    if kind == mujoco.mjtGeom.mjGEOM_MESH:
        return _mesh(model, int(model.geom_dataid[k]))
    if kind == mujoco.mjtGeom.mjGEOM_BOX:
        vertices, faces = _hull(np.array(np.meshgrid(*[[-1, 1]] * 3)).reshape(3, -1).T * size)
    elif kind in (mujoco.mjtGeom.mjGEOM_CYLINDER, mujoco.mjtGeom.mjGEOM_CAPSULE):
        half = size[1] + (size[0] if kind == mujoco.mjtGeom.mjGEOM_CAPSULE else 0.0)
        vertices, faces = _cylinder(float(size[0]), float(half))
    elif kind in (mujoco.mjtGeom.mjGEOM_SPHERE, mujoco.mjtGeom.mjGEOM_ELLIPSOID):
        radii = size if kind == mujoco.mjtGeom.mjGEOM_ELLIPSOID else np.full(3, size[0])
        vertices, faces = _ellipsoid(*radii.tolist())
    else:
        return None
    return vertices, faces, np.zeros((len(vertices), 2))


@lru_cache(_KEPT)
def _cylinder(radius: float, half: float) -> tuple[np.ndarray, np.ndarray]:
    """Return an upright cylinder, cached because every picture shows the goal marker."""
    turn = np.linspace(0, 2 * np.pi, _ROUND, endpoint=False)
    ring = np.column_stack([np.cos(turn), np.sin(turn)])
    low, high = (np.column_stack([ring, np.full(_ROUND, z)]) for z in (-1.0, 1.0))
    return _hull(np.concatenate([low, high]) * [radius, radius, half])


@lru_cache(_KEPT)
def _ellipsoid(*radii: float) -> tuple[np.ndarray, np.ndarray]:
    """Return an ellipsoid, cached because every picture may show a spherical goal marker."""
    k = np.arange(200) + 0.5
    polar, turn = np.arccos(1 - k / 100), np.pi * (1 + 5**0.5) * k
    ball = [np.cos(turn) * np.sin(polar), np.sin(turn) * np.sin(polar), np.cos(polar)]
    return _hull(np.column_stack(ball) * radii)


def _hull(points: Float[np.ndarray, "n 3"]) -> tuple[np.ndarray, np.ndarray]:
    """Return the convex hull's vertices and outward faces."""
    from scipy.spatial import ConvexHull

    hull = ConvexHull(points)
    inward = (scaled_normals(points[hull.simplices]) * hull.equations[:, :3]).sum(1) < 0
    faces = np.where(inward[:, None], hull.simplices[:, ::-1], hull.simplices)
    return points, faces


def _mesh(model: mujoco.MjModel, mesh: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Return a mesh with one vertex per face corner, which supports uv seams."""
    at, count = model.mesh_faceadr[mesh], model.mesh_facenum[mesh]
    corners = model.mesh_face[at : at + count].ravel()
    vertices = model.mesh_vert[model.mesh_vertadr[mesh] + corners].astype(np.float64)
    uv = np.zeros((len(corners), 2))
    if model.mesh_texcoordadr[mesh] >= 0:
        which = model.mesh_facetexcoord[at : at + count].ravel()
        uv = model.mesh_texcoord[model.mesh_texcoordadr[mesh] + which].astype(np.float64)
        uv[:, 1] = 1 - uv[:, 1]  # MuJoCo counts rows from the top
    return vertices, np.arange(len(corners)).reshape(-1, 3), uv


def _color(model: mujoco.MjModel, k: int) -> Float[np.ndarray, "4"]:
    """Return the RGBA colour of geom ``k``, from its material if it has one."""
    material = model.geom_matid[k]
    return model.mat_rgba[material] if material >= 0 else model.geom_rgba[k]


def _texture(model: mujoco.MjModel, k: int) -> UInt8[np.ndarray, "th tw 3"]:
    """Return geom ``k``'s 2D texture times its colour, or a pixel of that colour if it has none."""
    import mujoco

    tint, material = _color(model, k)[:3], model.geom_matid[k]
    role = mujoco.mjtTextureRole.mjTEXROLE_RGB
    texture = model.mat_texid[material, role] if material >= 0 else -1
    if texture < 0 or model.tex_type[texture] != mujoco.mjtTexture.mjTEXTURE_2D:
        return np.round(np.clip(tint, 0, 1) * 255).astype(np.uint8)[None, None]
    height, width = model.tex_height[texture], model.tex_width[texture]
    channels, at = model.tex_nchannel[texture], model.tex_adr[texture]
    data = model.tex_data[at : at + height * width * channels]
    pixels = data.reshape(height, width, channels)[..., :3]
    if channels < 3:
        pixels = np.repeat(pixels[..., :1], 3, axis=2)
    return np.round(pixels * np.clip(tint, 0, 1)).astype(np.uint8)
