"""Fit of a catalogue shape to a crop: its variant, yaw, proportions and profile.

The yaw of several variants is searched by silhouette. The best poses are also scored by how well
their coloured regions explain the crop's colours, and the best few are refined in yaw and
proportions. An upright object may finally be narrowed or widened along its height (``Profile``).
``paint`` paints the result.
"""

from __future__ import annotations

import dataclasses
from dataclasses import dataclass
from functools import lru_cache

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8

from tabletop_objects import Category, build
from tabletop_objects.values import parts_to_unit_box, to_unit_box

from ....geometry import hull_points, rotation_z
from ....meshes import texture_bake
from ....meshes.pixels import mask_iou
from ....meshes.projection import Projection
from ....scene import ConvexPart, Mesh, Model
from .frames import descend, frame_to_mask
from .paint import explained_colors

VARIANTS, FEW = 6, 3
"""Numbers of seeds tried per category: normally, and in quick mode."""

_STRETCH = float(np.log(1.6))  # maximum log deviation of proportions from the variant's own
_COLOR = 0.2  # weight of explained colours relative to silhouette overlap
_YAWS = 24
_STANDS_OUT = 0.12  # maximum loss of overlap, relative to the variant's best yaw, of a scored yaw
_FINALISTS = 3
_BENT = 0.3  # maximum bend of a profile
_WORTH = 0.01  # minimum gain of overlap from bending a profile
_STANDING = 0.7  # minimum ratio of height to width of an object with a profile


@dataclass(frozen=True)
class Profile:
    """A change of width along the height: ``taper`` widens the top, and ``belly`` the middle."""

    taper: float = 0.0
    belly: float = 0.0

    def bend(self, points: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 3"]:
        """Return points of the unit box with x and y scaled according to their height."""
        z = 2 * points[:, 2:]
        factor = np.exp(self.taper * z + self.belly * (0.5 - z * z))
        return np.concatenate([points[:, :2] * factor, points[:, 2:]], 1)

    def apply(self, model: Model) -> Model:
        """Return a canonical model with its width changed along its height."""
        mesh = model.mesh
        bent = Mesh(self.bend(mesh.vertices), mesh.faces, mesh.uv, mesh.texture, mesh.opacity)
        unit, center, extent = to_unit_box(bent)
        hulls = tuple(ConvexPart(self.bend(p.vertices)) for p in model.parts)
        parts = parts_to_unit_box(hulls, center, extent)
        return dataclasses.replace(model, mesh=unit, parts=parts, size=model.size * extent)


@dataclass(frozen=True, eq=False)
class Likeness:
    """A catalogue model posed to resemble a crop.

    ``extent`` (scaled axes), ``yaw`` and ``position`` (of the box's centre) are in the object
    frame. ``iou`` is the overlap of the silhouettes, ``explained`` the fraction of the crop's
    colours that the model's coloured regions explain.
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
        """The overall score of the match with the crop."""
        return self.iou + _COLOR * self.explained


class _Search:
    """Silhouette search over yaw and proportions for one catalogue model."""

    def __init__(self, model: Model, mask: np.ndarray, small: Projection, round_: bool) -> None:
        self.model, self.mask, self.small, self.round = model, mask, small, round_
        self._points = model.mesh.vertices.astype(float)
        self._hull = hull_points(self._points)

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

    def standing_out(self) -> list[Likeness]:
        """Return the poses whose overlap is a local maximum over yaw."""
        if self.round:
            return [self.pose(np.zeros(3))]
        poses = [self.pose(np.array([k * 2 * np.pi / _YAWS, 0.0, 0.0])) for k in range(_YAWS)]
        iou = np.array([p.iou for p in poses])
        peak = (iou >= np.roll(iou, 1)) & (iou >= np.roll(iou, -1))
        kept = np.flatnonzero(peak & (iou > iou.max() - _STANDS_OUT))
        return [poses[k] for k in kept[np.argsort(-iou[kept], kind="stable")][:6]]

    def loss(self, parameters: np.ndarray) -> float:
        """Return the loss: one minus the silhouette overlap, plus a penalty for stretching."""
        stretch = np.abs(parameters[1:])
        if stretch.max() > _STRETCH:
            return 2.0
        return 1 - self.pose(parameters).iou + 0.03 * float(stretch.sum())

    def refine(self, yaw: float, rigid: bool) -> Likeness:
        """Return the best likeness near ``yaw``; with ``rigid``, proportions are fixed."""
        if rigid:
            near = yaw + np.deg2rad([-5.0, 0.0, 5.0])
            return max((self.pose(np.array([y, 0.0, 0.0])) for y in near), key=lambda c: c.iou)
        return self.pose(descend(self.loss, np.array([yaw, 0.0, 0.0]), (0.12, 0.12, 0.12), 45))


@lru_cache(maxsize=64)
def _build_variant(key: str, seed: int) -> Model:
    """Return a cached catalogue model; pictures often show several objects of a kind."""
    return build(key, seed)


def fit_likeness(
    category: Category,
    seed: int,
    crop: UInt8[np.ndarray, "h w 4"],
    mask: Bool[np.ndarray, "a b"],
    small: Projection,
    occluded: bool,
    variants: int = VARIANTS,
) -> Likeness:
    """Return the variant of a category that most resembles the crop, in its best pose.

    ``mask`` is the crop's silhouette at the resolution of ``small``. The completed outline of an
    occluded object is a guess, so its proportions are the catalogue's.
    """
    size = small.width, small.height
    image = cv2.resize(texture_bake.opaque_colors(crop)[0], size, interpolation=cv2.INTER_AREA)

    def judge(found: Likeness) -> Likeness:
        explained = explained_colors(found.model.mesh, found.world, image, mask, small)
        return dataclasses.replace(found, explained=explained)

    round_ = "round" in category.roles
    drafts: list[tuple[float, _Search, float]] = []
    for variant in range(variants):
        search = _Search(_build_variant(category.key, seed + variant), mask, small, round_)
        drafts += [(judge(pose).score, search, pose.yaw) for pose in search.standing_out()]
    drafts.sort(key=lambda d: -d[0])
    refined = [search.refine(yaw, occluded) for _, search, yaw in drafts[:_FINALISTS]]
    best = max(map(judge, refined), key=lambda c: c.score)
    return best if occluded else _with_profile(best, mask, small, round_)


def _with_profile(found: Likeness, mask: np.ndarray, small: Projection, round_: bool) -> Likeness:
    """Return the likeness, tapered or bulged by a ``Profile`` if that fits the outline better."""
    if found.extent[2] < _STANDING * found.extent[:2].min() or found.iou > 0.975:
        return found
    plain = dataclasses.replace(found.model, size=found.extent)

    def bend(profile: np.ndarray) -> Likeness:
        model = Profile(*profile).apply(plain) if np.abs(profile).max() > 1e-6 else plain
        return _Search(model, mask, small, round_).pose(np.array([found.yaw, 0.0, 0.0]))

    def loss(profile: np.ndarray) -> float:
        if np.abs(profile).max() > _BENT:
            return 2.0
        return 1 - bend(profile).iou + 0.02 * float(np.abs(profile).sum())

    better = bend(descend(loss, np.zeros(2), (0.1, 0.1), 24))
    if better.iou < found.iou + _WORTH:
        return found
    return dataclasses.replace(better, explained=found.explained)
