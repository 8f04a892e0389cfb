"""Fit a catalogue shape to one crop: variant, yaw and proportions by silhouette, then colours."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float, Int, UInt8
from scipy import optimize, spatial

from ...catalogue import Category, build
from ...geometry import rotation_z
from ...render.shading import sample_texture
from ...scene import Mesh, Model
from . import baking
from .framing import frame_to_mask, simplex
from .pixels import mask_iou
from .projection import Projection
from .unwrap import Atlas, unwrap

VARIANTS = 3
"""How many seeds of a category are tried."""

PROJECT = 0.85
"""Silhouette overlap from which pixels are projected; below, only colours are carried over."""

_STRETCH = float(np.log(1.5))  # how far proportions may leave the variant's own
_COLOR = 0.15  # weight of explained colours against silhouette overlap


@dataclass(frozen=True, eq=False)
class Likeness:
    """A catalogue model posed to look like a crop.

    ``extent`` (scaled axes), ``yaw`` and ``position`` (of the box's centre) are in the object
    frame; ``iou`` is the silhouettes' overlap, ``explained`` the share of the crop's colours that
    the model's coloured regions account for.
    """

    model: Model
    extent: Float[np.ndarray, "3"]
    yaw: float
    position: Float[np.ndarray, "3"]
    iou: float
    explained: float = 0.0

    @property
    def world(self) -> Float[np.ndarray, "n 3"]:
        """The mesh's vertices in the object frame."""
        return self.model.mesh.vertices * self.extent @ rotation_z(self.yaw).T + self.position

    @property
    def score(self) -> float:
        """How well the crop is explained."""
        return self.iou + _COLOR * self.explained


class _Search:
    """Silhouette search over yaw and proportions for one catalogue model."""

    def __init__(self, model: Model, mask: np.ndarray, small: Projection, round_: bool) -> None:
        self.model, self.mask, self.small, self.round = model, mask, small, round_
        self._points = model.mesh.vertices.astype(float)
        self._hull = self._points[spatial.ConvexHull(self._points).vertices]

    def pose(self, parameters: np.ndarray) -> Likeness:
        """Return the likeness at (yaw, log width stretch, log height stretch)."""
        yaw, wide, tall = parameters
        stretch = np.exp([0.0, 0.0 if self.round else wide, tall])
        shape = self.model.size * stretch
        turn = rotation_z(yaw).T
        scale, shift = frame_to_mask(self._hull * shape @ turn, self.small, self.mask)
        world = self._points * shape @ turn * scale + shift
        iou = mask_iou(self.small.silhouette(world, self.model.mesh.faces), self.mask)
        return Likeness(self.model, shape * scale, float(yaw), shift, iou)

    def loss(self, parameters: np.ndarray) -> float:
        """Return what the search minimises."""
        stretch = np.abs(parameters[1:])
        if stretch.max() > _STRETCH:
            return 2.0
        return 1 - self.pose(parameters).iou + 0.03 * float(stretch.sum())

    def refined(self, yaw: float, rigid: bool) -> Likeness:
        """Return the best likeness near ``yaw``; a ``rigid`` one keeps its proportions."""
        start = np.array([yaw, 0.0, 0.0])
        if rigid:
            return self.pose(start)
        found = optimize.minimize(
            self.loss, start, method="Nelder-Mead",
            options={"maxfev": 45, "initial_simplex": simplex(start, (0.12, 0.12, 0.12))},
        )  # fmt: skip
        return self.pose(found.x)


def fit_likeness(
    category: Category,
    seed: int,
    crop: UInt8[np.ndarray, "h w 4"],
    mask: Bool[np.ndarray, "a b"],
    small: Projection,
    occluded: bool,
) -> Likeness:
    """Return the variant and pose of a category that look most like the crop.

    ``mask`` is the crop's silhouette at the size of ``small``. Of an occluded object the
    completed outline is a guess, so proportions stay the catalogue's.
    """
    image = cv2.resize(
        baking.opaque_colors(crop)[0], (small.width, small.height), interpolation=cv2.INTER_AREA
    )
    round_ = "round" in category.roles
    yaws = np.zeros(1) if round_ else np.arange(24) * np.pi / 12
    best: list[Likeness] = []
    for variant in range(VARIANTS):
        search = _Search(build(category.key, seed + variant), mask, small, round_)
        coarse = [search.pose(np.array([yaw, 0.0, 0.0])) for yaw in yaws]
        kept = sorted(coarse, key=lambda c: -c.iou)[:5]
        judged = [_judge(c, image, small) for c in kept]
        leaders = sorted(judged, key=lambda c: -c.score)[:2]
        best += [_judge(search.refined(c.yaw, occluded), image, small) for c in leaders]
    return max(best, key=lambda c: c.score)


def _judge(candidate: Likeness, image: UInt8[np.ndarray, "h w 3"], small: Projection) -> Likeness:
    """Return the candidate with its share of explained colours."""
    atlas, surface, sight = _look(candidate, small, 96)
    seen = sight.sees(surface)
    if seen.sum() < 30:
        return candidate
    colors = baking.sample(image, small.project(surface.point))
    _, explained = baking.recolor(base_colors(candidate.model.mesh, atlas), seen, colors)
    c = candidate
    return Likeness(c.model, c.extent, c.yaw, c.position, c.iou, explained)


def _look(
    likeness: Likeness, projection: Projection, size: int
) -> tuple[Atlas, baking.Surface, baking.Sight]:
    mesh = likeness.model.mesh
    atlas = unwrap(mesh.vertices * likeness.extent, mesh.faces, size)
    surface = baking.surface_of(atlas, likeness.world)
    return atlas, surface, baking.Sight.of(likeness.world, mesh.faces, projection)


def base_colors(mesh: Mesh, atlas: Atlas) -> Float[np.ndarray, "t 3"]:
    """Return the colours that a mesh's own texture gives the texels of its new atlas."""
    corners: Int[np.ndarray, "t 3"] = mesh.faces[atlas.face]
    uv = (mesh.uv[corners] * atlas.weights[:, :, None]).sum(1)
    return sample_texture(mesh.texture, uv) * 255.0


def painted(
    likeness: Likeness, crop: UInt8[np.ndarray, "h w 4"], projection: Projection, size: int
) -> Mesh:
    """Return the likeness' canonical mesh with a texture made from the crop.

    Every region of the catalogue's texture takes the crop's colour for it; where the silhouettes
    agree well (``PROJECT``), what the camera sees is painted with the crop's own pixels.
    """
    mesh = likeness.model.mesh
    atlas, surface, sight = _look(likeness, projection, size)
    image, mask = baking.opaque_colors(crop)
    seen = sight.sees(surface)
    pixels = projection.project(surface.point)
    colors = baking.sample(image, pixels)
    inside = baking.sample(mask[..., None].astype(np.uint8), pixels)[:, 0] > 0.5
    texels, _ = baking.recolor(base_colors(mesh, atlas), seen & inside, colors)
    if likeness.iou >= PROJECT and mesh.opacity >= 1:
        texels[seen & inside] = colors[seen & inside]
    texture = baking.lay_out(atlas, texels)
    return baking.textured(atlas, mesh.vertices, texture, mesh.opacity)
