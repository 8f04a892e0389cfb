"""Pictures of a scene, and contact sheets with captions and boxes."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from jaxtyping import Float, UInt8
from PIL import Image, ImageDraw, ImageFont

from ..geometry import Camera, framing_camera
from ..scene import Scene, View
from .raster import Item, Rendered, place, render

_INK = (40, 44, 52)
BOX_COLORS = ((214, 69, 65), (31, 119, 180), (44, 140, 60), (148, 90, 180), (220, 130, 20))
"""Colours of named boxes, used in rotation."""


def grid(
    images: Sequence[UInt8[np.ndarray, "_h _w _c"]],
    captions: Sequence[str] = (),
    columns: int = 4,
    cell: int = 256,
) -> UInt8[np.ndarray, "gh gw 3"]:
    """Arrange pictures (RGB or RGBA, of any size) in a grid of square cells on white.

    Each picture is resized to fit its cell of ``cell`` pixels, keeping its aspect ratio. If there
    are captions, each picture has one line of text below it.
    """
    columns = max(1, min(columns, len(images)))
    rows = -(-len(images) // columns)
    line = 22 if captions else 0
    sheet = Image.new("RGB", (columns * cell, rows * (cell + line)), "white")
    draw, font = ImageDraw.Draw(sheet), ImageFont.load_default(14)
    for index, image in enumerate(images):
        x, y = index % columns * cell, index // columns * (cell + line)
        picture = Image.fromarray(np.ascontiguousarray(image)).convert("RGBA")
        factor = (cell - 8) / max(picture.size)
        size = [max(1, round(side * factor)) for side in picture.size]
        picture = picture.resize((size[0], size[1]), Image.Resampling.LANCZOS)
        sheet.paste(picture, (x + (cell - size[0]) // 2, y + (cell - size[1]) // 2), picture)
        if index < len(captions):
            draw.text((x + cell / 2, y + cell + 4), captions[index], _INK, font, anchor="mt")
    return np.asarray(sheet, np.uint8)


def draw_boxes(
    image: UInt8[np.ndarray, "h w 3"], boxes: Mapping[str, Float[np.ndarray, "4"]]
) -> UInt8[np.ndarray, "h w 3"]:
    """Return a copy of ``image`` with named pixel boxes (x0, y0, x1, y1) drawn on it."""
    picture = Image.fromarray(np.ascontiguousarray(image)).convert("RGB")
    draw, font = ImageDraw.Draw(picture), ImageFont.load_default(max(12, picture.width // 70))
    for index, (name, box) in enumerate(boxes.items()):
        color = BOX_COLORS[index % len(BOX_COLORS)]
        x0, y0, x1, y1 = (float(v) for v in box)
        draw.rectangle((x0, y0, max(x0, x1 - 1), max(y0, y1 - 1)), outline=color, width=2)
        draw.text((x0 + 3, y0 - 2), name, color, font, anchor="ls")
    return np.asarray(picture, np.uint8)


_UPRIGHT = np.array([1.0, 0.0, 0.0, 0.0])

TOP_DOWN = View(azimuth=0.0, elevation=np.pi / 2, fov=np.deg2rad(20.0))
"""A view from straight above, with hardly any perspective."""


def scene_items(scene: Scene) -> list[Item]:
    """Return the table (id 0) and the objects (ids 1 to n, in order) at their settled poses."""
    table = scene.table
    middle = np.array([0.0, 0.0, table.height / 2])
    items = [place(table.model.mesh, table.scale, middle, _UPRIGHT, 0)]
    for index, thing in enumerate(scene.objects, start=1):
        pose = thing.pose
        items.append(place(thing.model.mesh, thing.scale, pose.position, pose.quaternion, index))
    return items


def render_scene(
    scene: Scene,
    view: View | None = None,
    width: int = 960,
    height: int = 720,
    *,
    camera: Camera | None = None,
    supersample: int = 2,
) -> Rendered:
    """Draw a whole scene on white; ``view`` defaults to the scene's own view, framed to fit.

    In the ids, 0 is the table, ``k`` is the object ``scene.objects[k - 1]``, and -1 is an empty
    pixel.
    """
    items = scene_items(scene)
    if camera is None:
        points = np.concatenate([item.vertices for item in items])
        camera = framing_camera(points, view or scene.view, width, height)
    return render(items, camera, supersample=supersample, ground_shadow=0.1)
