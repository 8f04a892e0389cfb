"""Painting of posed catalogue shapes from crops, and scoring of their colours."""

from __future__ import annotations

import numpy as np
from jaxtyping import Bool, Float, Int, UInt8
from scipy.spatial import KDTree

from ....geometry import rotation_z
from ....meshes import texture_bake
from ....meshes.projection import Projection
from ....meshes.shading import estimate_shading
from ....meshes.unwrap import Atlas, unwrap
from ....render.scanlines import rasterise
from ....render.shading import sample_texture
from ....scene import Mesh
from ....scene.triangles import face_normals

PROJECT = 0.72
"""Minimum overlap of the silhouettes at which the picture's pixels are projected onto the model;
below this overlap, only colours are transferred."""

_ALIKE = 30.0  # maximum grey level difference between mirrored points of a texture
_TWIN = 0.03  # maximum distance of a mirrored point from the surface, relative to the object's size
_NOISE = 10.0  # typical grey level noise of a plain surface


def explained_colors(
    mesh: Mesh,
    world: Float[np.ndarray, "n 3"],
    image: UInt8[np.ndarray, "h w 3"],
    mask: Bool[np.ndarray, "h w"],
    small: Projection,
) -> float:
    """Return the fraction of the picture's colours that a posed mesh's coloured regions explain.

    Each region may take its colour from the picture; shading is removed first.
    """
    corners = small.corners(world, mesh.faces)
    owner, weights, _ = rasterise(corners, small.width, small.height)
    hit = np.flatnonzero((owner >= 0) & mask.ravel())
    if len(hit) < 30:
        return 0.0
    face = owner[hit]
    uv = (mesh.uv[mesh.faces[face]] * weights[hit][:, :, None]).sum(1)
    base = sample_texture(mesh.texture, uv) * 255.0
    normal = face_normals(world, mesh.faces)[face]
    colors = image.reshape(-1, 3)[hit].astype(float)
    every = np.ones(len(hit), bool)
    plain = estimate_shading(colors, normal, every).remove(colors, normal)
    painted, _ = texture_bake.recolor(base, every, plain)
    rest = ((plain - painted) ** 2).sum()
    total = ((plain - plain.mean(0)) ** 2).sum() + 3 * _NOISE**2 * len(hit)
    return float(np.clip(1 - rest / total, 0, 1))


def base_colors(mesh: Mesh, atlas: Atlas) -> Float[np.ndarray, "t 3"]:
    """Return the colours of a mesh's own texture at the texels of its new atlas."""
    corners: Int[np.ndarray, "t 3"] = mesh.faces[atlas.face]
    uv = (mesh.uv[corners] * atlas.weights[:, :, None]).sum(1)
    return sample_texture(mesh.texture, uv) * 255.0


def paint(
    mesh: Mesh,
    extent: Float[np.ndarray, "3"],
    yaw: float,
    position: Float[np.ndarray, "3"],
    crop: UInt8[np.ndarray, "h w 4"],
    projection: Projection,
    size: int,
    project: bool,
) -> Mesh:
    """Return a canonical catalogue mesh, posed as given, with a texture made from the crop.

    Each region of the catalogue's texture takes its colour from the crop. With ``project``, visible
    texels are painted with the crop's own pixels, and so are their mirror images, where the
    catalogue's texture is symmetric. Shading is removed from all of them.
    """
    turn = rotation_z(yaw)
    world = mesh.vertices * extent @ turn.T + position
    atlas = unwrap(mesh.vertices * extent, mesh.faces, size)
    surface = texture_bake.surface_of(atlas, world)
    sight = texture_bake.CropView.of(world, mesh.faces, projection)
    image, mask = texture_bake.opaque_colors(crop)
    pixels = projection.project(surface.point)
    inside = texture_bake.sample(mask[..., None].astype(np.uint8), pixels)[:, 0] > 0.5
    seen = sight.sees(surface) & inside
    shot = texture_bake.sample(image, pixels)
    shading = estimate_shading(shot, surface.normal, seen)
    colors = shading.remove(shot, surface.normal)
    base = base_colors(mesh, atlas)
    texels, _ = texture_bake.recolor(base, seen, colors)
    if project and mesh.opacity >= 1:
        texels[seen] = colors[seen]
        planes = [np.array([*turn[:, k], turn[:, k] @ position]) for k in (0, 1)]
        _mirror(texels, surface, base, seen, planes, sight.size)
    texture = texture_bake.lay_out(atlas, texels)
    return texture_bake.apply_texture(atlas, mesh.vertices, texture, mesh.opacity)


def _mirror(
    texels: Float[np.ndarray, "t 3"],
    surface: texture_bake.SurfacePoints,
    base: Float[np.ndarray, "t 3"],
    seen: Bool[np.ndarray, "t"],
    planes: list[Float[np.ndarray, "4"]],
    size: float,
) -> None:
    """Give hidden texels the colours of their visible mirror images, in place.

    The counterpart is closest to the mirrored point, has the mirrored normal, and the same base
    colour.
    """
    known = np.flatnonzero(seen)
    if len(known) < 100:
        return
    reach = _TWIN * size
    tree = KDTree(np.hstack([surface.point[known], 0.1 * size * surface.normal[known]]))
    for turn in ([planes[0]], [planes[1]], planes):
        hidden = np.flatnonzero(~seen)
        moved = surface.at(hidden)
        for plane in turn:
            moved = moved.mirror(plane)
        place = np.hstack([moved.point, 0.1 * size * moved.normal])
        near, twin = tree.query(place, k=1, distance_upper_bound=reach)
        met = np.flatnonzero(np.isfinite(near))
        hidden, twin = hidden[met], known[np.asarray(twin)[met]]
        alike = np.abs(base[twin] - base[hidden]).max(1) < _ALIKE
        texels[hidden[alike]] = texels[twin[alike]]
        seen = seen.copy()
        seen[hidden[alike]] = True
