"""Pictures of the detector's input and of its grasps."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np
from jaxtyping import Float, UInt8

from tabletopgen_env.detection.look import CELL, CELLS, HeightView
from tabletopgen_env.expert.planning.grasps import Grasp
from tabletopgen_env.expert.planning.runs import FINGER_HALF

_SCALE = 3  # pixels per cell
_COLUMNS = 12
_TALL = 75.0  # steps of height in full brightness
_OWN, _REST = (235, 150, 60), (90, 120, 160)
_FINGERS, _EMPTY = (60, 230, 90), (240, 60, 60)


def sheet(
    looks: Sequence[HeightView], grasps: Sequence[Grasp | None]
) -> UInt8[np.ndarray, "h w 3"]:
    """Return a contact sheet: objects orange, everything else blue, higher is brighter.

    The two bars are the descending fingers, the line is their closing motion; a red cross means
    that no grasp was detected.
    """
    tiles = [_tile(seen, grasp) for seen, grasp in zip(looks, grasps, strict=True)]
    blank = np.full_like(tiles[0], 255)
    tiles += [blank] * (-len(tiles) % _COLUMNS)
    rows = [np.hstack(tiles[k : k + _COLUMNS]) for k in range(0, len(tiles), _COLUMNS)]
    return np.vstack(rows)


def _tile(seen: HeightView, grasp: Grasp | None) -> UInt8[np.ndarray, "h w 3"]:
    own, rest = np.clip(seen.heights / _TALL, 0.0, 1.0)
    shade = [0.35 + 0.65 * part[..., None] for part in (own, rest)]
    drawn = np.full((CELLS, CELLS, 3), 25.0)
    drawn = np.where((rest > 0)[..., None], shade[1] * _REST, drawn)
    drawn = np.where((own > 0)[..., None], shade[0] * _OWN, drawn).astype(np.uint8)
    tile = np.kron(drawn, np.ones((_SCALE, _SCALE, 1), np.uint8))
    tile[0], tile[:, 0] = 255, 255
    if grasp is None:
        cv2.drawMarker(tile, (15, 15), _EMPTY, cv2.MARKER_TILTED_CROSS, 12, 2)
        return tile
    across = np.array([np.cos(grasp.angle), np.sin(grasp.angle)])
    aside = np.array([-across[1], across[0]])
    middle = grasp.point[:2] - seen.center
    for sign in (-1, 1):
        finger = middle + sign * across * grasp.opening / 2
        ends = (_pixel(finger + s * aside * FINGER_HALF) for s in (-1, 1))
        cv2.line(tile, next(ends), next(ends), _FINGERS, 2, cv2.LINE_AA)
        cv2.line(tile, _pixel(finger), _pixel(middle + sign * across * grasp.width / 2), _FINGERS)
    return tile


def _pixel(point: Float[np.ndarray, "2"]) -> tuple[int, int]:
    i, j = (point / CELL + CELLS / 2) * _SCALE
    return int(j), int(i)
