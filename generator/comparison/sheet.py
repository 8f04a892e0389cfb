"""A comparison sheet: picture, masks, rendered scene, overlay, view from above, and scores.

Each instance has the same colour everywhere on the sheet.
"""

from __future__ import annotations

import colorsys
from collections.abc import Mapping, Sequence

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8
from PIL import Image, ImageDraw, ImageFont

from ..geometry import framing_camera, mask_box
from ..render.raster import render
from ..render.sheet import TOP_DOWN, scene_items
from ..scene import TABLE
from .scores import Comparison, Score

PANEL = 640
"""Width of one panel in pixels."""

_INK, _PALE, _GAP, _LINE = (40, 44, 52), (120, 126, 136), 12, 26
_TALLEST = 1.0  # maximum ratio of a panel's height to its width

Color = tuple[int, int, int]
Picture = UInt8[np.ndarray, "_ _ 3"]


def comparison_sheet(comparison: Comparison) -> UInt8[np.ndarray, "h w 3"]:
    """Draw the sheet: two rows of three panels.

    The panels are the picture, the picture with outlined and named masks, the scene rendered from
    the picture's camera, a blend of both with outlined silhouettes, the scene from above, and the
    scores.
    """
    c = comparison
    names = [s.name for s in c.scores]
    colors = {TABLE: _PALE} | {name: _color(k) for k, name in enumerate(names)}
    masks = {name: c.segments.mask(name) for name in [TABLE, *names]}
    bodies = {name: c.silhouette(name) for name in [TABLE, *names]}
    blend = (c.picture.astype(np.uint16) + c.rendered.image) // 2
    feet = _feet({name: masks[name] for name in names})
    panels = [
        ("picture", c.picture),
        ("masks found", _label(_outline(c.picture, masks, colors), feet, colors)),
        ("scene, from the picture's camera", c.rendered.image),
        ("both, scene outlined", _outline(blend.astype(np.uint8), bodies, colors)),
        ("scene from above", _from_above(c, colors)),
    ]
    height = round(PANEL * min(_TALLEST, c.picture.shape[0] / c.picture.shape[1]))
    size = 3 * PANEL + 4 * _GAP, 2 * (height + _LINE) + 3 * _GAP + _LINE
    sheet = Image.new("RGB", size, "white")
    draw = ImageDraw.Draw(sheet)
    draw.text((_GAP, _GAP), _title(c), _INK, ImageFont.load_default(19))
    for k, (caption, image) in enumerate(panels):
        x, y = _corner(k, height)
        draw.text((x, y), caption, _PALE, ImageFont.load_default(16))
        fitted = _fit(image, PANEL, height)
        left, top = (PANEL - fitted.width) // 2, (height - fitted.height) // 2
        sheet.paste(fitted, (x + left, y + _LINE + top))
    _figures(draw, _corner(5, height), height, [c.table, *c.scores], colors)
    return np.asarray(sheet, np.uint8)


def _corner(panel: int, height: int) -> tuple[int, int]:
    row, column = divmod(panel, 3)
    return _GAP + column * (PANEL + _GAP), 2 * _GAP + _LINE + row * (height + _LINE + _GAP)


def _fit(image: Picture, width: int, height: int) -> Image.Image:
    picture = Image.fromarray(np.ascontiguousarray(image))
    factor = min(width / picture.width, height / picture.height)
    size = (max(1, round(picture.width * factor)), max(1, round(picture.height * factor)))
    return picture.resize(size, Image.Resampling.LANCZOS)


def _color(index: int) -> Color:
    """Return the colour of an instance: maximally distinct hues in two brightnesses."""
    value = (0.95, 0.7)[index // 2 % 2]
    red, green, blue = colorsys.hsv_to_rgb(index * 0.61803 % 1.0, 0.95, value)
    return round(255 * red), round(255 * green), round(255 * blue)


def _outline(
    image: Picture, masks: Mapping[str, Bool[np.ndarray, "h w"]], colors: Mapping[str, Color]
) -> Picture:
    """Return ``image`` with the outlines of all masks drawn in their colours."""
    out = np.ascontiguousarray(image.copy())
    wide = max(2, round(image.shape[1] / 320))
    for name, mask in masks.items():
        flat = np.ascontiguousarray(mask.astype(np.uint8))
        curves, _ = cv2.findContours(flat, cv2.RETR_LIST, cv2.CHAIN_APPROX_NONE)
        cv2.drawContours(out, curves, -1, (255, 255, 255), wide + 2, cv2.LINE_AA)
        cv2.drawContours(out, curves, -1, colors[name], wide, cv2.LINE_AA)
    return out


def _feet(masks: Mapping[str, Bool[np.ndarray, "h w"]]) -> dict[str, Float[np.ndarray, "2"]]:
    """Return the pixel below the middle of each mask, where its name is drawn."""
    boxes = {name: mask_box(mask) for name, mask in masks.items() if mask.any()}
    return {name: np.array([(box[0] + box[2]) / 2, box[3]]) for name, box in boxes.items()}


def _label(
    image: Picture, places: Mapping[str, Float[np.ndarray, "2"]], colors: Mapping[str, Color]
) -> Picture:
    """Return ``image`` with names at pixel positions, moved apart where they would overlap."""
    picture = Image.fromarray(np.ascontiguousarray(image))
    draw = ImageDraw.Draw(picture)
    font = ImageFont.load_default(max(11, round(picture.width / 52)))
    taken: list[tuple[float, float, float, float]] = []
    for name in sorted(places, key=lambda n: float(places[n][1])):
        text = name.replace("_", " ")
        box = draw.textbbox((0, 0), text, font)
        wide, tall = box[2] + 6, box[3] + 4
        x = float(np.clip(places[name][0] - wide / 2, 0, max(picture.width - wide, 0)))
        y = float(np.clip(places[name][1] + 3, 0, max(picture.height - tall, 0)))
        while any(_meet((x, y, x + wide, y + tall), other) for other in taken):
            y += tall / 4
        taken.append((x, y, x + wide, y + tall))
        draw.rounded_rectangle(taken[-1], 4, (255, 255, 255), colors[name], 1)
        draw.text((x + 3, y + 1), text, _INK, font)
    return np.asarray(picture, np.uint8)


def _meet(a: Sequence[float], b: Sequence[float]) -> bool:
    return a[0] < b[2] and b[0] < a[2] and a[1] < b[3] and b[1] < a[3]


def _from_above(c: Comparison, colors: Mapping[str, Color]) -> Picture:
    h, w = c.picture.shape[:2]
    width, height = PANEL, round(PANEL * min(_TALLEST, h / w))
    items = scene_items(c.scene)
    points = np.concatenate([item.vertices for item in items])
    camera = framing_camera(points, TOP_DOWN, width, height)
    shown = render(items, camera)
    bodies = {thing.name: shown.ids == k for k, thing in enumerate(c.scene.objects, start=1)}
    return _label(shown.image, _feet(bodies), colors)


def _title(c: Comparison) -> str:
    report = c.scene.report
    gate = "not judged" if report is None else ("passed" if report.passed else "FAILED")
    difference = c.mean_color_difference
    color = "" if difference is None else f", mean colour difference {difference:.1f}"
    size = " x ".join(f"{100 * v:.0f}" for v in c.scene.table.scale)
    view = c.scene.view
    angles = f"elevation {np.rad2deg(view.elevation):.0f}°, azimuth {np.rad2deg(view.azimuth):.0f}°"
    return (
        f"{c.scene.name}: {len(c.scores)} objects, mean IoU {c.mean_iou:.2f}{color}, "
        f"table IoU {c.table.iou:.2f}, {size} cm, {angles}, gate {gate}"
    )


def _figures(
    draw: ImageDraw.ImageDraw,
    corner: tuple[int, int],
    height: int,
    scores: Sequence[Score],
    colors: Mapping[str, Color],
) -> None:
    """Write one line per instance: its colour, name, IoU and colour difference."""
    columns = 1 if len(scores) <= 16 else 2
    rows = -(-len(scores) // columns)
    line = min(26.0, height / (rows + 1))
    font = ImageFont.load_default(max(9.0, 0.66 * line))
    wide = PANEL / columns
    x, y = corner
    for column in range(columns):
        right = x + (column + 1) * wide - 14
        draw.text((right - 5.2 * line, y + 4), "IoU", _PALE, font, anchor="ra")
        draw.text((right, y + 4), "colour diff.", _PALE, font, anchor="ra")
    for k, score in enumerate(scores):
        column, row = divmod(k, rows)
        left, top = x + column * wide, y + _LINE + row * line
        right = left + wide - 14
        draw.rectangle((left, top + 3, left + line - 8, top + line - 5), colors[score.name])
        note = "  (no mask)" if not score.found else "" if score.built else "  (not built)"
        draw.text((left + line, top), score.name.replace("_", " ") + note, _INK, font)
        draw.text((right - 5.2 * line, top), f"{score.iou:.2f}", _INK, font, anchor="ra")
        difference = score.color_difference
        shown = "-" if difference is None else f"{difference:.1f}"
        draw.text((right, top), shown, _INK, font, anchor="ra")
