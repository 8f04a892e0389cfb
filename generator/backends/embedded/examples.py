"""Matching of words to the objects in a picture, by means of rendered catalogue examples.

The built-in detector knows only a few of the catalogue's categories. For any other category, an
example is built, rendered from all sides at about the picture's elevation, and named by the
detector. An object to which the detector gives similar names may belong to that category.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np
import torch
from jaxtyping import Float

from tabletop_objects import build

from ...geometry import framing_camera, mask_box, yaw_quaternion
from ...language.names import find_kind
from ...render.raster import place, render
from ...scene import Model, View
from ...threads import single_thread
from .eye.closeups import Closeup, closeup
from .eye.judge import EyeDetection
from .eye.network import hints
from .eye.sight import name_closeups
from .eye.weights import load_weights
from .plane.measure import apparent_scale, usual_solid
from .plane.plane import TABLE_LENGTH, TablePlane

_SEED = 7_000_003  # seed of a category's example; no drawing of a text uses it
_TURNS = 4
_SIDE = 160  # picture size of an example in pixels
_FOV = float(np.deg2rad(20))
_GROUND = 225, 215, 205  # a light tabletop
_SHARE = 0.3  # fraction of a picture that the tabletop covers
_PROPORTION = 0.6  # ratio of width to length of a typical tabletop
_STEP = 10  # elevation step between examples in degrees
_LOWEST, _HIGHEST = 20, 80  # degrees
_CUT = 0.004  # an object closer to the frame than this fraction of the longer side counts as cut


def rate_words(
    things: Sequence[EyeDetection], wanted: Sequence[str], plane: TablePlane
) -> Float[np.ndarray, "n w"]:
    """Return how well each object matches each word, from 0 to 1.

    For a word outside the catalogue, this is the probability that the detector does not know the
    object.
    """
    names = np.stack([thing.names for thing in things]).astype(float)
    categories = load_weights().categories
    elevation = np.rad2deg(plane.view.elevation) / _STEP
    degrees = int(np.clip(round(float(elevation)) * _STEP, _LOWEST, _HIGHEST))
    rated = np.empty((len(things), len(wanted)))
    for column, word in enumerate(wanted):
        found = find_kind(word)
        if found is None:
            rated[:, column] = names[:, -1]
            continue
        # The squared Bhattacharyya coefficient, which is 1 for equal name distributions.
        same = np.sqrt(names) @ np.sqrt(_name_examples(found.key, degrees)).T
        rated[:, column] = np.square(same).max(1)
        if found.key in categories:
            own = names[:, categories.index(found.key)]
            rated[:, column] = np.maximum(rated[:, column], own)
    return rated


def compare_sizes(
    things: Sequence[EyeDetection], wanted: Sequence[str], plane: TablePlane
) -> Float[np.ndarray, "n w 2"]:
    """Return the ``apparent_scale`` of each object for each word, or NaN where it is unknown.

    It is unknown for words outside the catalogue, and for objects cut off by the frame.
    """
    found = [find_kind(word) for word in wanted]
    keys = sorted({category.key for category in found if category is not None})
    sizes = np.full((len(things), len(wanted), 2), np.nan)
    for row, thing in enumerate(things):
        known = scales_of(thing, keys, plane)
        for column, category in enumerate(found):
            if known and category is not None:
                sizes[row, column] = known[category.key]
    return sizes


def scales_of(
    thing: EyeDetection, keys: Sequence[str], plane: TablePlane
) -> dict[str, tuple[float, float]] | None:
    """Return an object's ``apparent_scale`` for each category, or None if the frame cuts it off."""
    box = mask_box(thing.whole)
    height, width = thing.whole.shape
    if min(box[0], box[1], width - box[2], height - box[3]) < _CUT * max(height, width):
        return None
    return {key: apparent_scale(box, usual_solid(key), plane) for key in keys}


@lru_cache(maxsize=1024)
def _name_examples(key: str, degrees: int) -> Float[np.ndarray, "e k"]:
    """Return the detector's name probabilities for renders of a category from all sides."""
    view = View(0.0, float(np.deg2rad(degrees)), _FOV)
    model = build(key, _SEED)
    looks = [_look(model, turn, view) for turn in range(_TURNS)]
    with single_thread(), torch.inference_mode():
        names = np.stack(name_closeups(load_weights(), looks)).astype(float)
    names.flags.writeable = False
    return names


def _look(model: Model, turn: int, view: View) -> Closeup:
    """Return the close-up of an example in one of its rotations, as if on a typical table."""
    yaw = 2 * np.pi * (turn + 0.25) / _TURNS
    item = place(model.mesh, model.size, np.zeros(3), yaw_quaternion(yaw), 1)
    camera = framing_camera(item.vertices, view, _SIDE, _SIDE, margin=0.1)
    seen = render([item], camera, supersample=1, shadows=False, background=_GROUND)
    mask = seen.ids == item.id
    low, high = mask_box(mask).reshape(2, 2)
    wide, tall = (float(side) for side in high - low)
    pixels = max(wide, tall) / float(np.max(model.size))  # a metre
    tabletop = TABLE_LENGTH**2 * _PROPORTION * float(np.sin(view.elevation)) * pixels**2
    return replace(
        closeup(seen.image, mask, tabletop),
        hints=hints((wide, tall), tabletop, tabletop / _SHARE),
    )
