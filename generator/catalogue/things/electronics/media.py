"""What sound and pictures come from: records, tapes, discs, radios, players, projectors."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, ring_parts
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, lathe
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look

DARK: RGB = (30, 30, 33)


def _disc(
    radius: float, hole: float, thick: float, draw: Callable[[Look, RGB], textures.Tile],
    palette: tuple[str, ...],
) -> Callable[[Look], Shape]:  # fmt: skip
    """A disc with a hole lying flat, a print on it."""

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
        return shape([(rim, textures.plain(tint_color(color, 0.8))), (face, draw(look, color))],
                     ring_parts([(r, 0), (r, thick)], [(hole, thick), (hole, 0)], 10))  # fmt: skip

    return make


def grooves(look: Look, color: RGB) -> textures.Tile:
    """Return the top of a record: grooves, a shine, a label."""
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


def _rainbow(look: Look, color: RGB) -> textures.Tile:
    y, x = np.mgrid[0:128, 0:128] / 63.5 - 1
    turn = np.arctan2(y, x) * 2 + look.between(0, 6)
    tint = np.stack([np.cos(turn + s) for s in (0, 2.1, 4.2)], -1) * 34
    image = np.clip(np.array(color) + tint + 10, 0, 255).astype(np.uint8)
    prints.disc(image, 0.5, 0.5, 0.19, (226, 228, 232))
    prints.disc(image, 0.5, 0.5, 0.2, (120, 124, 130), 0.19)
    return image


def cassette(look: Look) -> Shape:
    """An audio cassette lying, its label and two reels up."""
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
    return shape([(block(x, y, h * 0.8, 0.002), textures.plain(edge)),
                  (box(0.6 * x, 0.2 * y, h).move(y=-0.4 * y), textures.plain(edge)),
                  (box(0.99 * x, 0.985 * y, 0.0004).move(z=h * 0.8 - 0.0001), image)],
                 [box_part(x, y, h * 0.8 + 0.0003), box_part(0.6 * x, 0.2 * y, h,
                     (0, -0.4 * y, 0))])  # fmt: skip


def floppy_disk(look: Look) -> Shape:
    """A 3.5 inch floppy disk lying."""
    k = look.between(0.98, 1.02)
    color = look.color("black", "blue", "navy", "red", "yellow", "gray", "green")
    x, y, h = 0.09 * k, 0.094 * k, 0.0035
    image = prints.canvas(128, 134, color)
    prints.fill(image, 0.12, 0.42, 0.76, 0.58, (246, 244, 238))
    prints.fill(image, 0.12, 0.42, 0.76, 0.08, look.own_color("red", "orange", "teal", "blue"))
    prints.lines(image, look.rng, (0.2, 0.56, 0.6, 0.36), 4, (150, 150, 160), 0.15)
    prints.fill(image, 0.24, 0, 0.54, 0.34, (186, 190, 196))
    prints.fill(image, 0.58, 0.04, 0.12, 0.26, tint_color(color, 0.6))
    return shape([(box(x, y, h), textures.plain(tint_color(color, 0.9))),
                  (box(0.99 * x, 0.99 * y, 0.0004).move(z=h - 0.0001), image)],
                 [box_part(x, y, h)])  # fmt: skip


def _sleeve(x: float, y: float, h: float, spine: bool) -> Callable[[Look], Shape]:
    """A flat case or sleeve with a printed front, lying."""

    def make(look: Look) -> Shape:
        k = look.between(0.98, 1.02)
        color = look.color("red", "blue", "black", "orange", "teal", "purple", "yellow", "green")
        front = prints.cover(look.rng, look.pick(["MIX", "LIVE", "SONGS", "ECHO", "BLUE", "GOLD"]),
                             color, look.own_color("cream", "orange", "navy", "pink"))  # fmt: skip
        a, b = x * k, y * k
        edge = textures.plain((40, 40, 44) if spine else (236, 232, 224))
        pieces = [(box(a, b, h), edge), (box(0.97 * a, 0.99 * b, 0.0005).move(
            0.012 * a if spine else 0, 0, h - 0.0002), front)]  # fmt: skip
        if spine:
            pieces.append((box(0.07 * a, b, 0.0008).move(x=-0.46 * a, z=h - 0.0002),
                           textures.plain((56, 56, 60))))  # fmt: skip
        return shape(pieces, [box_part(a, b, h)])

    return make


def game_cartridge(look: Look) -> Shape:
    """A game cartridge lying, its label up."""
    k = look.between(0.9, 1.15)
    color = look.color("gray", "charcoal", "black", "gold", "red", "blue")
    x, y, h = 0.062 * k, 0.068 * k, 0.0095 * k
    art = textures.fit(prints.artwork(look.rng, 96, 80), 80, 96).copy()
    tone = look.own_color("red", "navy", "yellow", "purple")
    prints.fill(art, 0, 0, 1, 0.3, tone)
    prints.write(art, look.pick(["RACER", "QUEST", "JUMP!", "SPACE", "NINJA"]), 0.5, 0.15, 0.2,
                 readable_on(tone), bold=True)  # fmt: skip
    grips = [box(0.6 * x, 0.0022, 0.0012).move(y=(0.45 - 0.045 * n) * y, z=h - 0.0004)
             for n in range(4)]  # fmt: skip
    return shape([(block(x, y, h, 0.003, 0.001), look.surface(color, "plastic")),
                  (box(0.78 * x, 0.6 * y, 0.0005).move(y=-0.08 * y, z=h - 0.0002), art),
                  (join(grips), textures.plain(tint_color(color, 0.7)))],
                 [box_part(x, y, h)])  # fmt: skip


def film_roll(look: Look) -> Shape:
    """A 35 mm film canister standing, a tongue of film beside it."""
    k = look.between(0.95, 1.1)
    color = look.color("yellow", "green", "red", "blue", "black", "orange")
    r, h = 0.0125 * k, 0.047 * k
    body = cylinder(r, 0.9 * h, 26).move(z=0.03 * h)
    image = prints.label(look.rng, look.pick(["FILM 400", "ISO 200", "35 mm"]), color,
                         (246, 244, 236), width=192)  # fmt: skip
    caps = [cylinder(1.06 * r, 0.05 * h, 26).move(z=z) for z in (0, 0.9 * h)]
    caps.append(cylinder(0.45 * r, 0.08 * h, 14).move(z=0.92 * h))
    tongue = box(0.03 * k, 0.001, 0.74 * h).move(r + 0.013 * k, 0.3 * r, 0.1 * h)
    strip = prints.canvas(64, 64, (96, 66, 44))
    for n in range(8):
        for v in (0.05, 0.87):
            prints.fill(strip, n / 8 + 0.03, v, 0.06, 0.08, (236, 230, 220))
    return shape([(body, image), (join(caps), textures.plain((36, 36, 38))), (tongue, strip)],
                 [cylinder_part(1.06 * r, 0.95 * h), hull_of(tongue)])  # fmt: skip


CATEGORIES = (
    Category("vinyl_record", _disc(0.15, 0.0037, 0.002, grooves, ("black", "black", "charcoal",
             "maroon", "blue")), (0.3, 0.3, 0.0023), 0.15, ("record", "vinyl", "lp",
             "gramophone record", "vinyl disc", "lp record", "vinyl lp", "single",
             "7-inch single"), ("music",),
             ("round", "flat", "big"), ("black",)),
    Category("cd", _disc(0.06, 0.0075, 0.0012, _rainbow, ("silver", "silver", "sky", "gold")),
             (0.12, 0.12, 0.0015), 0.016, ("compact disc", "dvd", "cd rom", "cd disc",
             "blu-ray", "dvd disc", "optical disc", "minidisc", "laserdisc", "zip disk",
             "blu ray disc"), ("music",), ("round", "flat"), ("silver",)),
    Category("cd_case", _sleeve(0.142, 0.125, 0.01, True), (0.142, 0.125, 0.0103), 0.1,
             ("jewel case", "cd box", "dvd case", "dvd box", "game case"),
             ("music",), ("flat", "support")),
    Category("record_sleeve", _sleeve(0.31, 0.31, 0.004, False), (0.31, 0.31, 0.0043), 0.2,
             ("album cover", "vinyl sleeve", "record cover", "record album", "vinyl album"),
             ("music",), ("flat", "support", "big")),
    Category("cassette", cassette, (0.1, 0.0635, 0.012), 0.05, ("cassette tape", "audio cassette",
             "audio tape", "music cassette", "mixtape", "tape cassette", "vhs tape",
             "eight-track tape", "video cassette", "vhs"), ("music",), ("flat",),
             ("black",)),
    vary(Category("floppy_disk", floppy_disk, (0.09, 0.094, 0.0037), 0.02, ("floppy", "diskette",
             "floppy disc"), ("office",), ("flat",), ("black", "blue"))),
    Category("game_cartridge", game_cartridge, (0.0635, 0.07, 0.0105), 0.05, ("cartridge",
             "video game cartridge", "game card", "video game"), ("living",), ("flat",),
             ("gray",)),
    Category("film_roll", film_roll, (0.0576, 0.0284, 0.0505), 0.03,
        ("roll of film", "film canister",
             "camera film", "photo film", "35mm film", "film", "microfilm reel", "negative strip",
             "film reel", "reel of film", "music roll"), ("living",), ("round",),
             ("yellow",)),
)  # fmt: skip
"""The module's categories."""
