"""Scores of a scene's likeness to its picture: silhouettes and colours per object."""

from __future__ import annotations

from dataclasses import asdict, dataclass, replace
from typing import Any

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8

from ..bundle import Segments
from ..errors import InputError
from ..geometry import Camera
from ..render.raster import Rendered
from ..render.sheet import render_scene
from ..scene import TABLE, Scene
from .camera import picture_camera

WORK_SIDE = 960
"""Length in pixels of the longer image side during comparison."""

_SAME_RATIO = 0.02


@dataclass(frozen=True)
class Score:
    """Comparison of one instance of the picture with its object in the scene.

    ``iou`` is the overlap (intersection over union) of the visible silhouettes.
    ``color_difference`` is the distance of their mean colours in CIE L*a*b* (CIE76; about 2 is just
    noticeable), or None if either shows no pixel. ``built`` is False for an instance that is not
    part of the scene, ``found`` for an object without an instance in the picture.
    """

    name: str
    label: str
    iou: float
    color_difference: float | None
    built: bool = True
    found: bool = True


@dataclass(frozen=True, eq=False)
class Comparison:
    """A scene and its picture; ``picture``, ``segments`` and ``rendered`` have the same size.

    ``scores`` has the objects' scores, ``table`` the table's. Ids in ``rendered``: 0 for the table,
    ``k`` for the object ``scene.objects[k - 1]``, -1 for the background.
    """

    scene: Scene
    picture: UInt8[np.ndarray, "h w 3"]
    segments: Segments
    camera: Camera
    rendered: Rendered
    table: Score
    scores: tuple[Score, ...]

    @property
    def mean_iou(self) -> float:
        """The mean IoU over the objects; missing objects and instances count as 0."""
        return float(np.mean([score.iou for score in self.scores])) if self.scores else 0.0

    @property
    def mean_color_difference(self) -> float | None:
        """The mean colour difference over the objects that are visible in both pictures."""
        known = [s.color_difference for s in self.scores if s.color_difference is not None]
        return float(np.mean(known)) if known else None

    def silhouette(self, name: str) -> Bool[np.ndarray, "h w"]:
        """Return the pixels that show an object or the table, or an empty mask if it is missing."""
        names = [TABLE, *(thing.name for thing in self.scene.objects)]
        shown = np.asarray(self.rendered.ids)
        return shown == names.index(name) if name in names else np.zeros(shown.shape, bool)

    def facts(self) -> dict[str, Any]:
        """Return the scores as JSON values."""
        difference = self.mean_color_difference
        return {
            "mean_iou": round(self.mean_iou, 4),
            "mean_color_difference": None if difference is None else round(difference, 2),
            "table": _fact(self.table),
            "objects": [_fact(score) for score in self.scores],
            "camera": {
                "position_m": [round(float(v), 4) for v in self.camera.position],
                "azimuth_deg": round(float(np.rad2deg(self.scene.view.azimuth)), 2),
                "elevation_deg": round(float(np.rad2deg(self.scene.view.elevation)), 2),
                "fov_deg": round(float(np.rad2deg(self.camera.fov)), 2),
            },
        }


def compare(scene: Scene, segments: Segments, picture: UInt8[np.ndarray, "h w 3"]) -> Comparison:
    """Render ``scene`` from the picture's camera and score its likeness to the picture.

    ``segments`` are the detections in the picture, whose resolution may differ.

    Raises:
        InputError: the picture has another aspect ratio than ``segments``.
    """
    height, width = segments.index.shape
    if abs(np.log(picture.shape[1] / picture.shape[0] * height / width)) > _SAME_RATIO:
        raise InputError(
            f"The picture is {picture.shape[1]}x{picture.shape[0]}, but the scene was made from a "
            f"picture of {width}x{height}. Pass the original picture, or omit the picture to use "
            "the one in the bundle."
        )
    whole = picture_camera(scene, segments)
    factor = min(1.0, WORK_SIDE / max(width, height))
    size = (max(1, round(width * factor)), max(1, round(height * factor)))
    camera = replace(whole, width=size[0], height=size[1])
    index = cv2.resize(np.asarray(segments.index), size, interpolation=cv2.INTER_NEAREST)
    small = cv2.resize(picture, size, interpolation=cv2.INTER_AREA)
    rendered = render_scene(scene, camera=camera, supersample=2)
    found = replace(segments, index=index.astype(np.uint8))
    labels = dict(zip(segments.names, segments.labels, strict=True))
    labels = {thing.name: thing.label for thing in scene.objects} | labels
    blank = Comparison(
        scene, small.astype(np.uint8), found, camera, rendered, Score(TABLE, TABLE, 0.0, None), ()
    )
    scores = {name: _score(blank, name, label) for name, label in labels.items()}
    table = scores.pop(TABLE, blank.table)
    return replace(blank, table=table, scores=tuple(scores.values()))


def _score(c: Comparison, name: str, label: str) -> Score:
    mask, shown = c.segments.mask(name), c.silhouette(name)
    union = int((mask | shown).sum())
    iou = int((mask & shown).sum()) / union if union else 0.0
    difference = None
    if mask.any() and shown.any():
        here, there = _mean_lab(c.picture, mask), _mean_lab(c.rendered.image, shown)
        difference = float(np.linalg.norm(here - there))
    built = name == TABLE or any(thing.name == name for thing in c.scene.objects)
    return Score(name, label, iou, difference, built, name in c.segments.names)


def _mean_lab(
    image: UInt8[np.ndarray, "h w 3"], mask: Bool[np.ndarray, "h w"]
) -> Float[np.ndarray, "3"]:
    pixels = image[mask].astype(np.float32)[None] / 255
    return cv2.cvtColor(pixels, cv2.COLOR_RGB2LAB)[0].mean(0)


def _fact(score: Score) -> dict[str, Any]:
    difference = None if score.color_difference is None else round(score.color_difference, 2)
    return asdict(replace(score, iou=round(score.iou, 4), color_difference=difference))
