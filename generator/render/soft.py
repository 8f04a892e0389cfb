"""A differentiable soft rasteriser: textured surface points, splatted into tight crops.

Each surface point represents a small area, whose projection covers a known number of pixels. The
splatted areas of a closed object therefore add up to the number of surface layers: at least one
front and one back layer inside the silhouette, none outside. The soft silhouette is a smooth step
function of that sum. The cost depends on the number of points, not on the mesh; a batch of
candidate poses is one tensor. Gradients flow to yaw, tilt and distance through pixel positions,
projected areas and the tight crop itself; visibility is computed without gradients.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields, replace

import numpy as np
import torch
from jaxtyping import Bool, Float, Int
from scipy.spatial import KDTree
from torch import Tensor
from torch.nn import functional

from ..errors import InputError
from ..geometry import hull_points
from ..scene import Mesh
from ..scene.triangles import scaled_normals
from .crop import MARGIN
from .shading import sample_texture

_HIDDEN_WEIGHT = 0.01  # hidden points colour a pixel only if it contains no visible point
_FILTER = (1 / 16, 4 / 16, 6 / 16, 4 / 16, 1 / 16)  # binomial filter with a sigma of one pixel


@dataclass(frozen=True, eq=False)
class SampledSurface:
    """Points sampled on the textured surfaces of ``s`` objects, in metres in each object's frame.

    ``area`` (m^2) is the area that one point represents. ``covered`` marks points that are just
    below another surface, such as a label, and too close to it for a depth buffer. ``corners`` are
    the vertices of the convex hull, which bound the object in any view.
    """

    position: Float[Tensor, "s n 3"]
    normal: Float[Tensor, "s n 3"]
    color: Float[Tensor, "s n 3"]
    area: Float[Tensor, "s"]
    covered: Bool[Tensor, "s n"]
    corners: Float[Tensor, "s k 3"]

    def thin(self, step: int, first: int = 0) -> SampledSurface:
        """Return every ``step``-th point, evenly spread and with a proportionally larger area."""
        count = self.position.shape[1]
        names = ("position", "normal", "color", "covered")
        kept = {name: getattr(self, name)[:, first::step] for name in names}
        return replace(self, **kept, area=self.area * (count / len(range(first, count, step))))

    def to(self, device: torch.device | str) -> SampledSurface:
        """Return a copy on the given device."""
        return SampledSurface(*(getattr(self, field.name).to(device) for field in fields(self)))


def stack(surfaces: Sequence[SampledSurface]) -> SampledSurface:
    """Stack surfaces with equal numbers of points into one."""
    most = max(s.corners.shape[1] for s in surfaces)
    rests = [s.corners[:, -1:].expand(-1, most - s.corners.shape[1], -1) for s in surfaces]
    padded = [
        replace(s, corners=torch.cat([s.corners, rest], 1))
        for s, rest in zip(surfaces, rests, strict=True)
    ]
    names = [field.name for field in fields(SampledSurface)]
    return SampledSurface(*(torch.cat([getattr(s, name) for s in padded]) for name in names))


@dataclass(frozen=True, eq=False)
class CropFit:
    """Offset of an object within a crop that is not tight because the mask is inaccurate.

    ``shift`` (x right, y down) is a fraction of the crop's side, ``zoom`` the logarithm of a
    factor.
    """

    shift: Float[Tensor, "b 2"]
    zoom: Float[Tensor, "b"]


@dataclass(frozen=True, eq=False)
class CropWindow:
    """The part of the image shown in a crop that is not tight around the object.

    ``middle`` is the part's centre in x/z, y/z; ``scale`` is in pixels per unit of these.
    """

    middle: Float[Tensor, "b 2"]
    scale: Float[Tensor, "b 1"]


@dataclass(frozen=True, eq=False)
class SoftImages:
    """A batch of renders, each cropped tightly around its object.

    ``image`` is RGB in [0, 1] over a grey background, ``silhouette`` is in [0, 1]. ``normal``, if
    requested, is the mean unit normal of the visible surface in camera axes, without gradients.
    """

    image: Float[Tensor, "b 3 h w"]
    silhouette: Float[Tensor, "b h w"]
    normal: Float[Tensor, "b 3 h w"] | None = None


def _find_covered(
    position: Float[np.ndarray, "n 3"], normal: Float[np.ndarray, "n 3"], spacing: float
) -> Bool[np.ndarray, "n"]:
    """Mark points that are at most ``spacing`` below another surface parallel to their own."""
    # Each of the two points must lie on the matching side of the other's plane, which distinguishes
    # a cover from neighbours on a concave or convex surface.
    near = KDTree(position).query(position, k=min(12, len(position)))[1]
    apart = position[near] - position[:, None]
    above = (apart * normal[:, None]).sum(-1)
    above_by_theirs = (apart * normal[near]).sum(-1)
    parallel = (normal[near] * normal[:, None]).sum(-1) > 0.9
    least = 1e-3 * spacing
    return (parallel & (above > least) & (above_by_theirs > least) & (above < spacing)).any(1)


def sample_surface(
    mesh: Mesh,
    size: Float[np.ndarray, "3"],
    count: int,
    seed: int,
    dtype: torch.dtype = torch.float32,
) -> SampledSurface:
    """Sample ``count`` evenly spread points on a canonical mesh scaled to ``size`` metres.

    Points are stratified over the faces by area, with a low-discrepancy sequence in each face.
    Colours are those of the texture under soft light from straight above, which distinguishes top
    faces from side faces.

    Raises:
        InputError: The surface area is zero.
    """
    vertices = np.asarray(mesh.vertices, np.float64) * np.asarray(size)
    corners = vertices[mesh.faces]
    cross = scaled_normals(corners)
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
    position = (corners[face] * weights).sum(1)
    normal = cross[face] / np.maximum(2 * areas[face, None], 1e-30)
    color = sample_texture(mesh.texture, (mesh.uv[mesh.faces[face]] * weights).sum(1))
    color = color * (0.75 + 0.25 * normal[:, 2:])
    covered = _find_covered(position, normal, float(np.sqrt(total / count)))

    def tensor(array: np.ndarray) -> Tensor:
        return torch.as_tensor(np.ascontiguousarray(array), dtype=dtype)

    return SampledSurface(
        tensor(position[None]),
        tensor(normal[None]),
        tensor(color[None]),
        torch.tensor([total / count], dtype=dtype),
        torch.as_tensor(covered)[None],
        tensor(hull_points(vertices)[None]),
    )


def object_to_camera(
    yaw: Float[Tensor, "b"], tilt: Float[Tensor, "b"], world_to_camera: Float[Tensor, "3 3"]
) -> Float[Tensor, "b 3 3"]:
    """Return rotations from the object frame to camera axes (x right, y down, z forward).

    ``yaw`` turns the object about world +z; ``tilt`` raises the camera's elevation. Both are in
    radians.
    """
    cy, sy, ct, st = (f()[:, None] for f in (yaw.cos, yaw.sin, tilt.cos, tilt.sin))
    x, y, z = (column.expand(len(yaw), 3) for column in world_to_camera.to(yaw.dtype).unbind(1))
    right, down, ahead = torch.stack([cy * x + sy * y, cy * y - sy * x, z], 2).unbind(1)
    return torch.stack([right, ct * down - st * ahead, st * down + ct * ahead], 1)


def rotate(
    points: Float[Tensor, "b n 3"], rotation: Float[Tensor, "b 3 3"]
) -> Float[Tensor, "b n 3"]:
    """Rotate points with a fixed order of summation, unlike a matrix product."""
    x, y, z = points.split(1, 2)
    columns = rotation[:, None].unbind(3)
    return x * columns[0] + y * columns[1] + z * columns[2]


def bounds(
    corners: Float[Tensor, "b k 3"], rotation: Float[Tensor, "b 3 3"], center: Float[Tensor, "b 3"]
) -> tuple[Float[Tensor, "b 2"], Float[Tensor, "b 2"]]:
    """Return the minimum and maximum image coordinates x/z and y/z of objects at ``center``."""
    p = rotate(corners, rotation) + center[:, None]
    xy = p[..., :2] / p[..., 2:]
    return xy.amin(1), xy.amax(1)


def fit_center(
    corners: Float[Tensor, "b k 3"],
    rotation: Float[Tensor, "b 3 3"],
    middle: Float[Tensor, "b 2"],
    span: Float[Tensor, "b 2"],
) -> Float[Tensor, "b 3"]:
    """Return the centre at which each object's projection fills a given box in the image.

    ``middle`` and ``span`` are the centres and sizes of the boxes in x/z, y/z. The centres match
    exactly; the sizes match in area, since objects keep their proportions. However large the box,
    the distance is at least one and a half times the object's radius.
    """
    nearest = 1.5 * corners.norm(dim=2).amax(1, keepdim=True)
    ray = torch.cat([middle, torch.ones_like(middle[:, :1])], 1)
    area = span.prod(1, keepdim=True)
    depth = nearest / area.sqrt()
    for _ in range(3):
        depth = depth.maximum(nearest)
        low, high = bounds(corners, rotation, ray * depth)
        ray = torch.cat([ray[:, :2] + middle - (low + high) / 2, ray[:, 2:]], 1)
        depth = depth * ((high - low).prod(1, keepdim=True) / area).sqrt()
    return ray * depth.maximum(nearest)


def pixel_scale(
    span: Float[Tensor, "b 2"], resolution: int, keep_aspect: bool
) -> Float[Tensor, "b 2"]:
    """Return the scale (pixels per unit) at which ``span`` fits a square of side ``resolution``."""
    if keep_aspect:
        span = span.amax(-1, keepdim=True).expand_as(span)
    return resolution * (1 - 2 * MARGIN) / span.clamp_min(1e-9)


def render(
    surface: SampledSurface,
    rotation: Float[Tensor, "b 3 3"],
    center: Float[Tensor, "b 3"],
    resolution: int,
    keep_aspect: bool = True,
    owner: Int[Tensor, "b"] | None = None,
    fit: CropFit | None = None,
    window: CropWindow | None = None,
    normals: bool = False,
) -> SoftImages:
    """Draw objects in ``b`` poses, each in its own square crop of side ``resolution``.

    ``surface`` holds sample points of the objects; ``owner`` is the index of each pose's object, or
    None if there is only one object. ``rotation`` maps object frames to camera axes (see
    ``object_to_camera``); ``center`` are the objects' centres in camera axes, metres, in front of
    the camera. With ``keep_aspect``, the longer side is fitted and the other one is padded;
    otherwise both are stretched. Crops are tight around the objects, or show ``window`` if it is
    given; ``fit`` shifts and zooms the objects within them. With ``normals``, the normals are
    returned too.
    """
    index = torch.zeros_like(rotation[:, 0, 0], dtype=torch.long) if owner is None else owner
    if window is None:
        low, high = bounds(surface.corners[index], rotation, center)
        middle, scale = (low + high) / 2, pixel_scale(high - low, resolution, keep_aspect)
    else:
        middle, scale = window.middle, window.scale.expand(-1, 2)
    p = rotate(surface.position[index], rotation) + center[:, None]
    normal = rotate(surface.normal[index], rotation)
    depth = p[..., 2]
    if fit is not None:
        scale = scale * fit.zoom.exp()[:, None]
    pixel = (p[..., :2] / depth[..., None] - middle[:, None]) * scale[:, None]
    pixel = pixel + resolution / 2
    if fit is not None:
        pixel = pixel + resolution * fit.shift[:, None]
    facing = (normal * p).sum(-1)  # negative towards the camera
    area = surface.area[index, None] * scale.prod(-1, keepdim=True)
    pixels = area * facing.abs() / depth**3
    with torch.no_grad():
        seen = _visible(pixel, depth, scale, resolution) & (facing < 0) & ~surface.covered[index]
        share = torch.where(seen, 1.0, _HIDDEN_WEIGHT)
    weight = pixels * share
    values = torch.cat(
        [pixels[..., None] / 2, weight[..., None], weight[..., None] * surface.color[index]], -1
    )
    layers, total, colored = _splat(pixel, values, resolution).split([1, 1, 3], 1)
    silhouette = 1 - torch.exp2(-((2 * layers) ** 3))
    image = colored / (total + 1e-4)
    facing_map = None
    if normals:
        with torch.no_grad():
            drawn = _splat(pixel.detach(), weight.detach()[..., None] * normal.detach(), resolution)
            facing_map = drawn / (total.detach() + 1e-4)
    return SoftImages(silhouette * image + (1 - silhouette) * 0.5, silhouette[:, 0], facing_map)


def _visible(
    pixel: Float[Tensor, "b n 2"],
    depth: Float[Tensor, "b n"],
    scale: Float[Tensor, "b 2"],
    resolution: int,
) -> Bool[Tensor, "b n"]:
    """Return which points are visible, according to a coarse depth buffer dilated by one cell."""
    b = len(depth)
    cells = max(resolution // 2, 1)
    cell = (pixel.detach() * (cells / resolution)).long().clamp(0, cells - 1)
    index = cell[..., 1] * cells + cell[..., 0]
    closest = torch.full_like(depth[:, :1], -torch.inf).repeat(1, cells * cells)
    closest = closest.scatter_reduce(1, index, -depth.detach(), "amax").view(b, 1, cells, cells)
    nearest = -functional.max_pool2d(closest, 3, 1, 1).view(b, -1)
    side = (resolution / cells) * depth.mean(1, keepdim=True) / scale.amax(-1, keepdim=True)
    return depth <= nearest.gather(1, index) + 4 * side


def _splat(
    pixel: Float[Tensor, "b n 2"], values: Float[Tensor, "b n c"], resolution: int
) -> Float[Tensor, "b c h w"]:
    """Add each point's values to its four nearest pixels, then blur with a sigma of one pixel."""
    b, _, c = values.shape
    corner = (pixel - 0.5).floor()
    fraction = pixel - 0.5 - corner
    x = corner.long().clamp(0, resolution - 2)
    rows = torch.arange(b, device=pixel.device)[:, None] * resolution
    first = (rows + x[..., 1]) * resolution + x[..., 0]
    canvas = values.new_zeros(b * resolution * resolution, c)
    for dy in (0, 1):
        wy = fraction[..., 1] if dy else 1 - fraction[..., 1]
        for dx in (0, 1):
            share = wy * (fraction[..., 0] if dx else 1 - fraction[..., 0])
            index = (first + dy * resolution + dx).reshape(-1)
            canvas = canvas.index_add(0, index, (values * share[..., None]).reshape(-1, c))
    return smooth(canvas.view(b, resolution, resolution, c).permute(0, 3, 1, 2))


def smooth(images: Float[Tensor, "b c h w"]) -> Float[Tensor, "b c h w"]:
    """Filter images with the kernel of the splats, which is binomial with a one-pixel sigma."""
    c = images.shape[1]
    taps = images.new_tensor(_FILTER)
    rows = functional.pad(images, (2, 2, 2, 2))
    rows = functional.conv2d(rows, taps.view(1, 1, 5, 1).repeat(c, 1, 1, 1), groups=c)
    return functional.conv2d(rows, taps.view(1, 1, 1, 5).repeat(c, 1, 1, 1), groups=c)


def sobel(
    images: Float[Tensor, "b h w"],
) -> tuple[Float[Tensor, "b hi wi"], Float[Tensor, "b hi wi"]]:
    """Return the Sobel derivatives of an image, rightward and downward, without its border.

    They are computed as differences because single-channel convolutions have a slow backward pass.
    """
    across = images[:, :, 2:] - images[:, :, :-2]
    down = images[:, 2:] - images[:, :-2]
    x = (across[:, :-2] + 2 * across[:, 1:-1] + across[:, 2:]) / 8
    y = (down[:, :, :-2] + 2 * down[:, :, 1:-1] + down[:, :, 2:]) / 8
    return x, y


def sobel_edges(silhouette: Float[Tensor, "b h w"]) -> Float[Tensor, "b h w"]:
    """Return the edge map of a soft silhouette: the nonnegative magnitude of its Sobel gradient."""
    x, y = sobel(functional.pad(silhouette, (1, 1, 1, 1)))
    tiny = 1e-3
    return (x.square() + y.square() + tiny**2).sqrt() - tiny


def soft_iou(
    soft: Float[Tensor, "b h w"],
    mask: Float[Tensor, "*b h w"],
    weight: Float[Tensor, "*b h w"] | float = 1.0,
) -> Float[Tensor, "b"]:
    """Return the soft intersection over union of silhouettes and masks."""
    both = (weight * soft * mask).sum((-2, -1))
    either = (weight * (mask + soft - soft * mask)).sum((-2, -1))
    return both / (either + 1e-6)
