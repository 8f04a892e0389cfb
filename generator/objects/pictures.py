"""Pictures of single objects: portraits, four variants with dimensions, and four views."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from types import MappingProxyType

import numpy as np
from jaxtyping import Float, UInt8
from PIL import Image, ImageDraw, ImageFont

from tabletop_objects import Category

from ..geometry import Camera
from ..render.raster import place, render
from ..render.sheet import grid
from ..scene import Model, View
from .checks import build_variant, size_text

Picture = UInt8[np.ndarray, "h w 3"]

_FOV = np.deg2rad(22.0)
VIEW = View(azimuth=np.deg2rad(-20.0), elevation=np.deg2rad(35.0), fov=_FOV)
"""A view from the front, slightly from the left and above."""

SIDES: Mapping[str, View] = MappingProxyType(
    {
        name: View(np.deg2rad(azimuth), np.deg2rad(elevation), _FOV)
        for name, azimuth, elevation in (
            ("front", 0.0, 15.0), ("right", 90.0, 15.0), ("back", 180.0, 15.0), ("top", 0.0, 65.0),
        )
    }
)  # fmt: skip

LOOKS = 4
_DIAGONAL = 0.25  # metres
_UPRIGHT = np.array([1.0, 0.0, 0.0, 0.0])
_INK, _LINE = (40, 44, 52), (120, 126, 138)


def portrait(model: Model, view: View = VIEW, side: int = 160) -> Picture:
    """Draw a model on a white floor as a square picture."""
    return _render(model, _frame(model, view, side))


def draw_looks(category: Category, seed: int, side: int = 240) -> Picture:
    """Draw four variants of a category with their sizes, then the first with dimension lines."""
    models = [build_variant(category, seed + k) for k in range(LOOKS)]
    cells = [portrait(model, side=side) for model in models]
    captions = [f"seed {seed + k}: {size_text(m.size)}" for k, m in enumerate(models)]
    cells.append(measure(models[0], side))
    captions.append("everyday size")
    return grid(cells, captions, columns=LOOKS + 1, cell=side)


def draw_sides(model: Model, side: int = 280) -> Picture:
    """Draw a model from the front, the right, the back and above."""
    cells = [portrait(model, view, side) for view in SIDES.values()]
    return grid(cells, list(SIDES), columns=2, cell=side)


def measure(model: Model, side: int = 240) -> Picture:
    """Draw a model from the front, with its length and height in centimetres."""
    camera = _frame(model, View(0.0, np.deg2rad(4.0), _FOV), side, room=1.35)
    picture = Image.fromarray(_render(model, camera))
    pen, font = ImageDraw.Draw(picture), ImageFont.load_default(13)
    x, y, z = (_size(model) * [0.5, -0.5, 1.0]).tolist()
    corners = np.array([[-x, y, 0.0], [x, y, 0.0], [x, y, z]])
    (left, low), (right, _), (_, high) = camera.project(corners).tolist()
    below, beside = min(low + 14, side - 22), min(right + 14, side - 8)
    _rule(pen, (left, below), (right, below))
    _rule(pen, (beside, low), (beside, high))
    wide, tall = (f"{100 * length:.3g} cm" for length in model.size[[0, 2]])
    pen.text(((left + right) / 2, below + 5), wide, _INK, font, anchor="mt")
    pen.text((beside, high - 6), tall, _INK, font, anchor="rb")
    return np.asarray(picture, np.uint8)


def _rule(pen: ImageDraw.ImageDraw, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Draw a dimension line with ticks at both ends."""
    pen.line([start, end], _LINE, 1)
    dx, dy = (0, 4) if start[1] == end[1] else (4, 0)
    for x, y in (start, end):
        pen.line([(x - dx, y - dy), (x + dx, y + dy)], _LINE, 1)


def _frame(model: Model, view: View, side: int, room: float = 1.08) -> Camera:
    """Return a camera that shows a model's whole bounding box, with a margin around it."""
    distance = room * _DIAGONAL / 2 / np.sin(view.fov / 2)
    return Camera.looking_at(_middle(model), view, distance, side, side)


def _render(model: Model, camera: Camera) -> Picture:
    item = place(model.mesh, _size(model), _middle(model), _UPRIGHT)
    return render([item], camera, ground_shadow=0.35).image


def _size(model: Model) -> Float[np.ndarray, "3"]:
    """Return a model's extent in the pictures, scaled so that all models have the same diagonal.

    Shadow softness is in metres; without scaling, it would blur the shadows of small objects away.
    """
    return model.size * (_DIAGONAL / np.linalg.norm(model.size))


def _middle(model: Model) -> Float[np.ndarray, "3"]:
    return np.array([0.0, 0.0, _size(model)[2] / 2])


def lay_out(
    cells: Sequence[Picture], columns: int, color: int = 255
) -> UInt8[np.ndarray, "sheet_h sheet_w 3"]:
    """Tile pictures of equal size in rows without gaps; empty cells have a uniform ``color``."""
    height, width = cells[0].shape[:2]
    rows = -(-len(cells) // columns)
    sheet = np.full((rows * height, columns * width, 3), color, np.uint8)
    for k, cell in enumerate(cells):
        y, x = k // columns * height, k % columns * width
        sheet[y : y + height, x : x + width] = cell
    return sheet
