"""A differentiable soft rasteriser: textured surface points splatted into tight crops.

Every point of the surface stands for a small area. Projected, that area is a known number of
pixels, so the splatted areas of a closed object add up to its number of surface layers: at least
one front and one back layer inside the silhouette, none outside. The soft silhouette is a smooth
step of that sum. Cost depends on the number of points, not on the mesh, and a batch of candidate
poses is one tensor. Gradients flow to yaw, tilt and distance through pixel positions, projected
areas and the tight crop itself; which points are hidden is decided without gradient.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass

import numpy as np
import torch
from jaxtyping import Bool, Float
from scipy.spatial import KDTree
from torch import Tensor
from torch.nn import functional

from ..errors import InputError
from ..geometry import hull_points
from ..scene import Mesh
from .crop import MARGIN
from .shading import sample_texture

_HIDDEN_WEIGHT = 0.01  # hidden points colour a pixel only where no visible point does
_FILTER = (1 / 16, 4 / 16, 6 / 16, 4 / 16, 1 / 16)  # binomial, sigma of one pixel


@dataclass(frozen=True, eq=False)
class Surface:
    """Sample points of a textured surface, in the object frame in metres.

    ``area`` (m^2) is what one point stands for; ``covered`` marks points just under another
    surface, such as a body under its label, too close for a depth buffer to tell; ``corners`` are
    the vertices of the convex hull, which bound the object in any view.
    """

    position: Float[Tensor, "n 3"]
    normal: Float[Tensor, "n 3"]
    color: Float[Tensor, "n 3"]
    area: float
    covered: Bool[Tensor, "n"]
    corners: Float[Tensor, "k 3"]


@dataclass(frozen=True, eq=False)
class SoftImages:
    """A batch of renders, each cropped tightly around its object.

    ``image`` is RGB in [0, 1] over a grey ground, ``silhouette`` in [0, 1].
    """

    image: Float[Tensor, "b 3 h w"]
    silhouette: Float[Tensor, "b h w"]


@contextmanager
def single_thread() -> Iterator[None]:
    """Run torch on one thread inside the block.

    Splats are too small to share: more threads make them slower, and on a busy machine many times
    slower. One thread also adds in one order, so results do not depend on the machine's cores.
    """
    threads = torch.get_num_threads()
    torch.set_num_threads(1)
    try:
        yield
    finally:
        torch.set_num_threads(threads)


def _covered(
    position: Float[np.ndarray, "n 3"], normal: Float[np.ndarray, "n 3"], spacing: float
) -> Bool[np.ndarray, "n"]:
    """Mark points that lie under another, parallel surface no farther off than ``spacing``.

    Each of the two points must see the other on the matching side of its own plane, which tells
    a cover from the neighbours on a hollow or bulging surface.
    """
    near = KDTree(position).query(position, k=min(12, len(position)))[1]
    apart = position[near] - position[:, None]
    above = (apart * normal[:, None]).sum(-1)
    above_by_theirs = (apart * normal[near]).sum(-1)
    parallel = (normal[near] * normal[:, None]).sum(-1) > 0.9
    least = 1e-3 * spacing
    cover = parallel & (above > least) & (above_by_theirs > least) & (above < spacing)
    return cover.any(1)


def sample_surface(
    mesh: Mesh,
    size: Float[np.ndarray, "3"],
    count: int,
    seed: int,
    dtype: torch.dtype = torch.float32,
) -> Surface:
    """Spread ``count`` points evenly over a canonical mesh scaled to ``size`` metres.

    Points are stratified over the faces by area, and low-discrepancy within a face.
    Colours are the texture under a soft light from straight above, which keeps top and side faces
    apart without assuming where the lamp is.

    Raises:
        InputError: the surface has no area.
    """
    vertices = np.asarray(mesh.vertices, np.float64) * np.asarray(size)
    a, b, c = (vertices[mesh.faces[:, k]] for k in range(3))
    cross = np.cross(b - a, c - a)
    areas = np.linalg.norm(cross, axis=1) / 2
    total = float(areas.sum())
    if total <= 0:
        raise InputError("The mesh has no surface area, so it cannot be rendered.")
    shift = np.random.default_rng(seed).random(3)
    index = np.arange(count)
    face = np.searchsorted(np.cumsum(areas) / total, (index + shift[0]) / count)
    face = np.minimum(face, len(areas) - 1)
    u, v = (index[:, None] * (0.7548776662466927, 0.5698402909980532) + shift[1:]).T % 1.0
    root = np.sqrt(u)
    weights = np.stack([1 - root, root * (1 - v), root * v], 1)[:, :, None]
    position = (np.stack([a, b, c], 1)[face] * weights).sum(1)
    normal = cross[face] / np.maximum(2 * areas[face, None], 1e-30)
    color = sample_texture(mesh.texture, (mesh.uv[mesh.faces[face]] * weights).sum(1))
    color = color * (0.75 + 0.25 * normal[:, 2:])
    covered = _covered(position, normal, float(np.sqrt(total / count)))

    def tensor(array: np.ndarray) -> Tensor:
        return torch.as_tensor(np.ascontiguousarray(array), dtype=dtype)

    return Surface(
        tensor(position),
        tensor(normal),
        tensor(color),
        total / count,
        torch.as_tensor(covered),
        tensor(hull_points(vertices)),
    )


def object_to_camera(
    yaw: Float[Tensor, "b"], tilt: Float[Tensor, "b"], world_to_camera: Float[Tensor, "3 3"]
) -> Float[Tensor, "b 3 3"]:
    """Return rotations from the object frame to camera axes (x right, y down, z forward).

    ``yaw`` turns the object about world +z; ``tilt`` raises the camera's elevation; radians.
    """
    one, zero = torch.ones_like(yaw), torch.zeros_like(yaw)
    cy, sy, ct, st = yaw.cos(), yaw.sin(), tilt.cos(), tilt.sin()
    turn = torch.stack([cy, -sy, zero, sy, cy, zero, zero, zero, one], -1).view(-1, 3, 3)
    lift = torch.stack([one, zero, zero, zero, ct, -st, zero, st, ct], -1).view(-1, 3, 3)
    return lift @ world_to_camera.to(yaw.dtype) @ turn


def bounds(
    surface: Surface, rotation: Float[Tensor, "b 3 3"], center: Float[Tensor, "b 3"]
) -> tuple[Float[Tensor, "b 2"], Float[Tensor, "b 2"]]:
    """Return the lowest and highest x/z, y/z of the object whose centre is at ``center``."""
    p = surface.corners @ rotation.mT + center[:, None]
    xy = p[..., :2] / p[..., 2:]
    return xy.amin(1), xy.amax(1)


def fit_center(
    surface: Surface,
    rotation: Float[Tensor, "b 3 3"],
    middle: Float[Tensor, "2"],
    span: Float[Tensor, "2"],
) -> Float[Tensor, "b 3"]:
    """Return where the object's centre lies if its projection is to fill a box of the image.

    ``middle`` and ``span`` are the box's centre and size in x/z, y/z. The centre agrees exactly;
    the size agrees in area, since the object keeps its proportions. A box too large for the
    object puts it no nearer than one and a half times its radius.
    """
    nearest = 1.5 * surface.corners.norm(dim=1).max()
    ray = torch.cat([middle, middle.new_ones(1)]).expand(len(rotation), 3)
    depth = (nearest / span.prod().sqrt()).expand(len(rotation), 1)
    for _ in range(3):
        depth = depth.maximum(nearest)
        low, high = bounds(surface, rotation, ray * depth)
        ray = torch.cat([ray[:, :2] + middle - (low + high) / 2, ray[:, 2:]], 1)
        depth = depth * ((high - low).prod(1, keepdim=True) / span.prod()).sqrt()
    return ray * depth.maximum(nearest)


def pixel_scale(
    span: Float[Tensor, "b 2"], resolution: int, keep_aspect: bool
) -> Float[Tensor, "b 2"]:
    """Return pixels per unit that fit ``span`` into a square crop of side ``resolution``."""
    inner = resolution * (1 - 2 * MARGIN)
    if keep_aspect:
        span = span.amax(-1, keepdim=True).expand_as(span)
    return inner / span.clamp_min(1e-9)


def render(
    surface: Surface,
    rotation: Float[Tensor, "b 3 3"],
    center: Float[Tensor, "b 3"],
    resolution: int,
    keep_aspect: bool = True,
) -> SoftImages:
    """Draw the object in ``b`` poses, each in its own tight square crop.

    Args:
        surface: sample points.
        rotation: object frame to camera axes, see ``object_to_camera``.
        center: the object's centre in camera axes, metres, in front of the camera.
        resolution: side of the crops in pixels.
        keep_aspect: fit the longer side and pad the other; False stretches both to the crop.
    """
    low, high = bounds(surface, rotation, center)
    scale = pixel_scale(high - low, resolution, keep_aspect)
    p = surface.position @ rotation.mT + center[:, None]
    normal = surface.normal @ rotation.mT
    depth = p[..., 2]
    pixel = (p[..., :2] / depth[..., None] - (low + high)[:, None] / 2) * scale[:, None]
    pixel = pixel + resolution / 2
    facing = (normal * p).sum(-1)  # negative towards the camera
    pixels = surface.area * facing.abs() / depth**3 * scale.prod(-1, keepdim=True)
    with torch.no_grad():
        seen = _visible(pixel, depth, scale, resolution) & (facing < 0) & ~surface.covered
        share = torch.where(seen, 1.0, _HIDDEN_WEIGHT)
    weight = pixels * share
    values = torch.cat(
        [pixels[..., None] / 2, weight[..., None], weight[..., None] * surface.color], -1
    )
    layers, total, colored = _splat(pixel, values, resolution).split([1, 1, 3], 1)
    silhouette = 1 - torch.exp2(-((2 * layers) ** 3))
    image = colored / (total + 1e-4)
    return SoftImages(silhouette * image + (1 - silhouette) * 0.5, silhouette[:, 0])


def _visible(
    pixel: Float[Tensor, "b n 2"],
    depth: Float[Tensor, "b n"],
    scale: Float[Tensor, "b 2"],
    resolution: int,
) -> Bool[Tensor, "b n"]:
    """Tell which points lie in front of a coarse depth buffer, widened by one cell."""
    b = len(depth)
    cells = max(resolution // 2, 1)
    cell = (pixel.detach() * (cells / resolution)).long().clamp(0, cells - 1)
    index = cell[..., 1] * cells + cell[..., 0]
    closest = torch.full((b, cells * cells), -torch.inf, dtype=depth.dtype)
    closest = closest.scatter_reduce(1, index, -depth.detach(), "amax").view(b, 1, cells, cells)
    nearest = -functional.max_pool2d(closest, 3, 1, 1).view(b, -1)
    side = (resolution / cells) * depth.mean(1, keepdim=True) / scale.amax(-1, keepdim=True)
    return depth <= nearest.gather(1, index) + 4 * side


def _splat(
    pixel: Float[Tensor, "b n 2"], values: Float[Tensor, "b n c"], resolution: int
) -> Float[Tensor, "b c h w"]:
    """Add every point's values to the four pixels around it, then filter with one pixel sigma."""
    b, _, c = values.shape
    corner = (pixel - 0.5).floor()
    fraction = pixel - 0.5 - corner
    x = corner.long().clamp(0, resolution - 2)
    first = (torch.arange(b)[:, None] * resolution + x[..., 1]) * resolution + x[..., 0]
    canvas = values.new_zeros(b * resolution * resolution, c)
    for dy in (0, 1):
        wy = fraction[..., 1] if dy else 1 - fraction[..., 1]
        for dx in (0, 1):
            share = wy * (fraction[..., 0] if dx else 1 - fraction[..., 0])
            index = (first + dy * resolution + dx).reshape(-1)
            canvas = canvas.index_add(0, index, (values * share[..., None]).reshape(-1, c))
    return smooth(canvas.view(b, resolution, resolution, c).permute(0, 3, 1, 2))


def smooth(images: Float[Tensor, "b c h w"]) -> Float[Tensor, "b c h w"]:
    """Filter images with the splat's own footprint, a binomial of one pixel sigma."""
    c = images.shape[1]
    taps = torch.tensor(_FILTER, dtype=images.dtype)
    rows = functional.pad(images, (2, 2, 2, 2))
    rows = functional.conv2d(rows, taps.view(1, 1, 5, 1).repeat(c, 1, 1, 1), groups=c)
    return functional.conv2d(rows, taps.view(1, 1, 1, 5).repeat(c, 1, 1, 1), groups=c)


def sobel_edges(silhouette: Float[Tensor, "b h w"]) -> Float[Tensor, "b h w"]:
    """Return the soft edge map of a soft silhouette: the length of its Sobel gradient, >= 0."""
    s = functional.pad(silhouette[:, None], (1, 1, 1, 1))
    across = torch.tensor([[-1.0, 0.0, 1.0], [-2.0, 0.0, 2.0], [-1.0, 0.0, 1.0]], dtype=s.dtype) / 8
    gradient = functional.conv2d(s, torch.stack([across, across.T])[:, None])
    tiny = 1e-3
    return (gradient.square().sum(1) + tiny**2).sqrt() - tiny
