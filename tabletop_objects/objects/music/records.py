"""Objects of the ``music`` theme: recordings and music players."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import ellipse
from ...kit.parts import box_part, cylinder_part, hull_of, ring_parts
from ...kit.shapes import Category, Shape, category, shape
from ...kit.solids import Solid, block, box, cylinder, join, lathe, prism, tube
from ...kit.surfaces import RGB, Look, readable_on, tint_color

DARK: RGB = (30, 30, 33)


def _disc(
    radius: float, hole: float, thick: float, draw: Callable[[Look, RGB], surfaces.Tile],
    palette: tuple[str, ...],
) -> Callable[[Look], Shape]:  # fmt: skip
    """Return the shape function of a flat disc with a hole and a print."""

    def make(look: Look) -> Shape:
        k = look.between(0.99, 1.01)
        color = look.color(*palette)
        r = radius * k
        rim = lathe([(hole, 0), (r, 0), (r, thick), (hole, thick)], 44, loop=True)
        face = lathe([(hole, thick - 0.0002), (0.985 * r, thick - 0.0002),
                      (0.985 * r, thick + 0.0003), (hole, thick + 0.0003)], 44,
                     v=[0, 0, 1, 0], loop=True)  # fmt: skip
        flat = face.vertices[:, :2] / (2 * r) + 0.5
        face = Solid(face.vertices, face.faces, np.clip(flat, 0, 1))
        return shape([(rim, surfaces.plain(tint_color(color, 0.8))), (face, draw(look, color))],
                     ring_parts([(r, 0), (r, thick)], [(hole, thick), (hole, 0)], 10))  # fmt: skip

    return make


def grooves(look: Look, color: RGB) -> surfaces.Tile:
    """Return the texture of a record: grooves, a highlight and a label."""
    y, x = np.mgrid[0:192, 0:192] / 95.5 - 1
    away = np.hypot(x, y)
    shine = 26 * np.maximum(np.cos(2 * (np.arctan2(y, x) - 0.7)), 0) ** 6
    waves = 9 * np.sin(away * 170) + shine
    image = np.clip(np.array(color) + waves[..., None], 0, 255).astype(np.uint8)
    tone = look.own_color("red", "orange", "yellow", "teal", "cream", "blue")
    prints.disc(image, 0.5, 0.5, 0.17, tone)
    part = image[62:130, 62:130]
    prints.write(part, "SIDE A", 0.5, 0.3, 0.16, readable_on(tone))
    prints.lines(part, look.rng, (0.3, 0.66, 0.4, 0.16), 2, readable_on(tone))
    return image


def _rainbow(look: Look, color: RGB) -> surfaces.Tile:
    y, x = np.mgrid[0:128, 0:128] / 63.5 - 1
    turn = np.arctan2(y, x) * 2 + look.between(0, 6)
    tint = np.stack([np.cos(turn + s) for s in (0, 2.1, 4.2)], -1) * 34
    image = np.clip(np.array(color) + tint + 10, 0, 255).astype(np.uint8)
    prints.disc(image, 0.5, 0.5, 0.19, (226, 228, 232))
    prints.disc(image, 0.5, 0.5, 0.2, (120, 124, 130), 0.19)
    return image


@category("cassette", size=(0.1, 0.0635, 0.012), mass=0.05, material="plastic",
          aliases=("cassette tape", "audio cassette", "audio tape", "music cassette", "mixtape",
          "tape cassette", "vhs tape", "eight-track tape", "video cassette", "vhs"),
          themes=("music",), roles=("flat",), colors=("black",))  # fmt: skip
def cassette(look: Look) -> Shape:
    """An audio cassette lying with its label and two reels up."""
    k = look.between(0.98, 1.02)
    color = look.color("black", "charcoal", "white", "clear", "orange", "pink", "blue")
    x, y, h = 0.1 * k, 0.0635 * k, 0.012
    image = prints.canvas(200, 127, color)
    other = look.own_color("red", "yellow", "teal", "orange", "cream", "pink")
    prints.fill(image, 0.08, 0.08, 0.84, 0.66, (244, 240, 228))
    for n in range(3):
        prints.fill(image, 0.08, 0.42 + 0.1 * n, 0.84, 0.1, tint_color(other, 1 - 0.2 * n))
    prints.lines(image, look.rng, (0.16, 0.16, 0.68, 0.16), 2, (90, 90, 96))
    prints.fill(image, 0.24, 0.36, 0.52, 0.24, DARK)
    for u in (0.33, 0.67):
        prints.disc(image, u, 0.48, 0.1, (246, 246, 244))
        prints.disc(image, u, 0.48, 0.055, DARK)
    prints.fill(image, 0.44, 0.41, 0.12, 0.14, (110, 70, 46))
    edge = tint_color(color, 0.85)
    prints.polygon(image, [(0.2, 1), (0.24, 0.8), (0.76, 0.8), (0.8, 1)], edge)
    return shape([(block(x, y, h * 0.8, 0.002), surfaces.plain(edge)),
                  (box(0.6 * x, 0.2 * y, h).move(y=-0.4 * y), surfaces.plain(edge)),
                  (box(0.99 * x, 0.985 * y, 0.0004).move(z=h * 0.8 - 0.0001), image)],
                 [box_part(x, y, h * 0.8 + 0.0003), box_part(0.6 * x, 0.2 * y, h,
                     (0, -0.4 * y, 0))])  # fmt: skip


def _sleeve(x: float, y: float, h: float, spine: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a thin case or sleeve with a printed front, lying flat."""

    def make(look: Look) -> Shape:
        k = look.between(0.98, 1.02)
        color = look.color("red", "blue", "black", "orange", "teal", "purple", "yellow", "green")
        front = prints.cover(look.rng, look.pick(["MIX", "LIVE", "SONGS", "ECHO", "BLUE", "GOLD"]),
                             color, look.own_color("cream", "orange", "navy", "pink"))  # fmt: skip
        a, b = x * k, y * k
        edge = surfaces.plain((40, 40, 44) if spine else (236, 232, 224))
        pieces = [(box(a, b, h), edge), (box(0.97 * a, 0.99 * b, 0.0005).move(
            0.012 * a if spine else 0, 0, h - 0.0002), front)]  # fmt: skip
        if spine:
            pieces.append((box(0.07 * a, b, 0.0008).move(x=-0.46 * a, z=h - 0.0002),
                           surfaces.plain((56, 56, 60))))  # fmt: skip
        return shape(pieces, [box_part(a, b, h)])

    return make


@category("record_player", size=(0.385, 0.317, 0.1), mass=4.0, material="device",
          aliases=("turntable", "vinyl player", "vinyl turntable"), themes=("music",),
          roles=("big",), colors=("wooden", "black"))  # fmt: skip
def record_player(look: Look) -> Shape:
    """A turntable: a plinth, a platter with a record, a tone arm and knobs."""
    k = look.between(0.9, 1.02)
    x, y, h = 0.4 * k, 0.33 * k, 0.06 * k
    color = look.color("wooden", "black", "brown", "white", "red", "teal")
    body = block(x, y, h, 0.012, 0.003).move(z=0.012)
    feet = [cylinder(0.018, 0.013, 14).move(s * 0.42 * x, t * 0.4 * y) for s in (-1, 1)
            for t in (-1, 1)]  # fmt: skip
    top = h + 0.012
    r = 0.142 * k
    at = (-0.055 * k, 0.0)
    platter = cylinder(r, 0.012, 44).move(*at, top - 0.001)
    tile = grooves(look, (26, 26, 28))
    record = prism(ellipse(1.94 * r, 1.94 * r, 44), 0, 0.002).move(*at, top + 0.0108)
    base = cylinder(0.022 * k, 0.03 * k, 20).move(0.15 * k, 0.11 * k, top - 0.001)
    arm = tube([(0.15 * k, 0.13 * k, top + 0.03 * k), (0.15 * k, -0.01 * k, top + 0.03 * k),
                (0.125 * k, -0.055 * k, top + 0.022 * k), (0.06 * k, -0.085 * k, top + 0.017)],
               0.0032 * k, 8)  # fmt: skip
    head = box(0.016 * k, 0.028 * k, 0.008).turn(2, -1.1).move(0.055 * k, -0.087 * k, top + 0.013)
    knobs = [cylinder(0.011 * k, 0.012, 18).move(0.15 * k + s * 0.018 * k, -0.135 * k, top - 0.001)
             for s in (-1, 1)]  # fmt: skip
    pin = cylinder(0.003, 0.01, 10).move(*at, top + 0.011)
    silver = surfaces.brushed_metal(look.rng, (196, 198, 202))
    return shape([(body, look.surface(color, "wood")), (join(feet), surfaces.plain(DARK)),
                  (platter, silver), (record, tile), (join([base, arm, *knobs, pin]), silver),
                  (head, surfaces.plain(DARK))],
                 [box_part(x, y, top), cylinder_part(r, 0.0128, (*at, top)), hull_of(base),
                  *(hull_of(s) for s in knobs)])  # fmt: skip


@category("boombox", size=(0.333, 0.106, 0.223), mass=2.2, material="device",
          aliases=("ghetto blaster", "cassette player", "tape recorder", "stereo", "tape player",
          "cassette recorder", "cd player"), themes=("music",), roles=("big",),
          colors=("silver",))  # fmt: skip
def boombox(look: Look) -> Shape:
    """A boombox with two round speakers, a tape deck and a handle."""
    k = look.between(0.85, 1.0)
    x, y, h = 0.36 * k, 0.11 * k, 0.19 * k
    color = look.color("silver", "black", "red", "gray", "blue", "pink")
    image = prints.canvas(240, 128, color)
    for u in (0.2, 0.8):
        prints.disc(image, u, 0.58, 0.36, (26, 26, 28))
        prints.disc(image, u, 0.58, 0.32, (70, 70, 74))
        prints.disc(image, u, 0.58, 0.29, (40, 40, 44))
        prints.disc(image, u, 0.58, 0.12, (96, 96, 100))
    prints.fill(image, 0.38, 0.42, 0.24, 0.42, (40, 40, 44))
    prints.fill(image, 0.41, 0.5, 0.18, 0.22, (150, 170, 170))
    for u in (0.45, 0.55):
        prints.disc(image, u, 0.61, 0.05, (236, 236, 232))
    prints.fill(image, 0.05, 0.06, 0.9, 0.1, (30, 30, 32))
    prints.fill(image, 0.3, 0.08, 0.4, 0.06, (240, 220, 150))
    for n in range(6):
        prints.fill(image, 0.38 + 0.041 * n, 0.3, 0.034, 0.07, (200, 202, 206))
    front = box(0.98 * x, 0.0012, 0.97 * h).move(y=-y / 2 - 0.0002, z=0.012 * h)
    bow = tube(np.array([(-0.42 * x, 0, 0.97 * h), (-0.41 * x, 0, 1.25 * h),
        (0.41 * x, 0, 1.25 * h),
                         (0.42 * x, 0, 0.97 * h)]), 0.006 * k, 8)  # fmt: skip
    return shape([(block(x, y, h, 0.01, 0.004), look.surface(color, "plastic")), (front, image),
                  (bow, surfaces.plain((40, 40, 44)))], [box_part(x, y, h),
                      hull_of(bow)])  # fmt: skip


CATEGORIES = (
    Category("vinyl_record",
             _disc(0.15, 0.0037, 0.002, grooves, ("black", "black", "charcoal", "maroon", "blue")),
             size=(0.3, 0.3, 0.0023), mass=0.15, material="plastic", aliases=("record", "vinyl",
             "lp", "gramophone record", "vinyl disc", "lp record", "vinyl lp", "single",
             "7-inch single"), themes=("music",), roles=("round", "flat", "big"),
             colors=("black",)),
    Category("cd", _disc(0.06, 0.0075, 0.0012, _rainbow, ("silver", "silver", "sky", "gold")),
             size=(0.12, 0.12, 0.0015), mass=0.016, material="plastic", aliases=("compact disc",
             "dvd", "cd rom", "cd disc", "blu-ray", "dvd disc", "optical disc", "minidisc",
             "laserdisc", "zip disk", "blu ray disc"), themes=("music",), roles=("round", "flat"),
             colors=("silver",)),
    Category("cd_case", _sleeve(0.142, 0.125, 0.01, True), size=(0.142, 0.125, 0.0103), mass=0.1,
             material="plastic",
             aliases=("jewel case", "cd box", "dvd case", "dvd box", "game case"),
             themes=("music",), roles=("flat", "support")),
    Category("record_sleeve", _sleeve(0.31, 0.31, 0.004, False), size=(0.31, 0.31, 0.0043),
             mass=0.2, material="paper",
             aliases=("album cover", "vinyl sleeve", "record cover", "record album", "vinyl album"),
             themes=("music",), roles=("flat", "support", "big")),
)  # fmt: skip
"""Objects that share their drawing functions."""
