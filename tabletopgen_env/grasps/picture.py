"""Pictures of grasp labels; each grasp is a fork, coloured from red (failed) to green (held)."""

from __future__ import annotations

from collections.abc import Mapping
from itertools import product

import numpy as np
from jaxtyping import Float, UInt8

from generator.geometry import framing_camera, quaternion_matrix
from generator.render.raster import Item, place, render
from generator.render.sheet import grid
from generator.scene import Object, Scene, View

from ..expert.planning.grasps import TIP
from .labels import GraspLabels

_VIEW = View(azimuth=np.deg2rad(30.0), elevation=np.deg2rad(30.0), fov=np.deg2rad(25.0))
_SIDE, _COLUMNS = 420, 4
_PRONG, _STEM = 0.045, 0.03  # lengths, metres
_THICK = 0.0016  # thickness of a fork's bars, metres
_BAD, _GOOD = np.array([215.0, 45.0, 40.0]), np.array([40.0, 165.0, 70.0])
_CORNERS = np.array([*product((-0.5, 0.5), repeat=3)])
_FACES = np.array([
    [0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
    [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3],
])  # fmt: skip


def draw_labels(scene: Scene, labels: Mapping[str, GraspLabels]) -> UInt8[np.ndarray, "h w 3"]:
    """Return a contact sheet of the labelled objects of a scene with their grasps.

    The distance between a fork's prongs is the opening of the fingers; its stem is on the hand's
    side.
    """
    things = [thing for thing in scene.objects if thing.name in labels]
    tiles = [draw_object(thing, labels[thing.name]) for thing in things]
    captions = [_caption(thing.name, labels[thing.name]) for thing in things]
    if not tiles:
        return np.full((_SIDE, _SIDE, 3), 255, np.uint8)
    return grid(tiles, captions, _COLUMNS, _SIDE)


def draw_object(thing: Object, labels: GraspLabels) -> UInt8[np.ndarray, "s s 3"]:
    """Return a picture of one object in its own frame, with a fork-shaped symbol for each grasp."""
    items = [place(thing.model.mesh, thing.scale, np.zeros(3), np.array([1.0, 0.0, 0.0, 0.0]))]
    for k in range(len(labels)):
        color = (_BAD + labels.quality[k] * (_GOOD - _BAD)).round().astype(np.uint8)
        turn, at = quaternion_matrix(labels.quaternion[k]), labels.position[k]
        for bar in _bars(float(labels.opening[k])):
            vertices = bar @ turn.T + at
            uv = np.zeros((len(vertices), 2))
            items.append(Item(vertices, _FACES, uv, color[None, None], k + 1))
    points = np.concatenate([item.vertices for item in items])
    return render(items, framing_camera(points, _VIEW, _SIDE, _SIDE), supersample=2).image


def _bars(opening: float) -> list[Float[np.ndarray, "8 3"]]:
    """Return the corners of the four bars of a grasp's fork symbol, in metres (hand frame)."""
    half, back = opening / 2, TIP - _PRONG
    prongs = [_bar([0, y, back], [0, y, TIP]) for y in (-half, half)]
    bridge = _bar([0, -half - _THICK / 2, back], [0, half + _THICK / 2, back])
    return [*prongs, bridge, _bar([0, 0, back - _STEM], [0, 0, back])]


def _bar(start: list[float], end: list[float]) -> Float[np.ndarray, "8 3"]:
    """Return the corners of an axis-aligned bar from ``start`` to ``end``."""
    low, high = np.array(start, float), np.array(end, float)
    return (low + high) / 2 + _CORNERS * np.maximum(high - low, _THICK)


def _caption(name: str, labels: GraspLabels) -> str:
    if not len(labels):
        return f"{name}: no grasps"
    good = int((labels.quality >= 0.8).sum())
    return f"{name}: {good} of {len(labels)} hold in 80 % of trials"
