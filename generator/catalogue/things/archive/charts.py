"""More papers by kind: plans, lists, films, posters, bound reports."""

from __future__ import annotations

import numpy as np

from ...build.making import at_block, at_box, dye
from ...build.recipes import Pieces
from ...build.solids import join
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import RGB
from ...surfaces.look import Look
from ..rows import Rows
from .papers import GRAY, INK, paper


def _stars(look: Look, image: prints.Canvas, accent: RGB) -> None:
    image[:] = (20, 28, 66)
    pale: RGB = (226, 232, 246)
    for r in (0.46, 0.32, 0.17):
        prints.disc(image, 0.5, 0.5, r, (90, 110, 170), r - 0.008)
    for _ in range(70):
        prints.disc(
            image,
            look.between(0.08, 0.92),
            look.between(0.08, 0.92),
            look.between(0.004, 0.011),
            pale,
        )
    for _ in range(5):
        x, y = look.between(0.2, 0.7), look.between(0.2, 0.7)
        way = [(x + 0.06 * k, y + look.between(-0.07, 0.07)) for k in range(4)]
        prints.stroke(image, way, 0.006, (150, 170, 220))
        for p in way:
            prints.disc(image, *p, 0.014, (250, 244, 214))


def _telegram(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.fill(image, 0, 0.05, 1, 0.16, (206, 176, 92))
    prints.write(image, "TELEGRAM", 0.5, 0.13, 0.12, (40, 34, 26), True)
    for k in range(4):
        prints.fill(image, 0.08, 0.32 + 0.14 * k, 0.84, 0.09, (250, 248, 238))
        prints.lines(image, look.rng, (0.1, 0.345 + 0.14 * k, 0.8, 0.04), 1, INK, 0.8)


def _ransom(look: Look, image: prints.Canvas, accent: RGB) -> None:
    for row, text in enumerate(("PAY", "THE", "MONEY", "NOW")):
        for k, letter in enumerate(text):
            x, y = 0.16 + 0.16 * k, 0.2 + 0.2 * row
            ground = look.own_color("yellow", "red", "sky", "white", "black", "pink")
            prints.fill(image, x - 0.06, y - 0.06, 0.13, 0.13, ground)
            prints.write(
                image,
                letter,
                x,
                y,
                0.09,
                (20, 20, 24) if sum(ground) > 300 else (250, 250, 246),
                True,
            )


def _list(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.write(image, look.pick(["LIST", "TO BUY", "TO DO"]), 0.5, 0.09, 0.08, accent, True)
    for k in range(8):
        y = 0.21 + 0.092 * k
        prints.fill(image, 0.1, y - 0.012, 0.06, 0.03, INK)
        prints.fill(image, 0.115, y - 0.006, 0.03, 0.018, (250, 250, 246))
        way = [
            (0.22 + 0.04 * n, y + 0.012 * (-1) ** n) for n in range(int(look.rng.integers(6, 15)))
        ]
        prints.stroke(image, way, 0.007, (50, 60, 130))


def _film(look: Look, image: prints.Canvas, accent: RGB) -> None:
    image[:] = (26, 32, 40)
    bone: RGB = (186, 204, 214)
    top = look.between(0.12, 0.2)
    prints.stroke(image, [(0.5, 0.06), (0.5, 0.95)], 0.05, bone)
    for k in range(8):
        y = top + 0.085 * k
        for s in (-1, 1):
            prints.stroke(
                image,
                [(0.5, y), (0.5 + s * 0.26, y - 0.02), (0.5 + s * 0.36, y + 0.07)],
                0.018,
                bone,
            )
    prints.fill(image, 0.04, 0.03, 0.16, 0.03, (226, 230, 234))


def _chart(look: Look, image: prints.Canvas, accent: RGB) -> None:
    for k, (text, tall) in enumerate(
        (
            ("E", 0.16),
            ("F P", 0.11),
            ("T O Z", 0.085),
            ("L P E D", 0.065),
            ("P E C F D", 0.05),
            ("E D F C Z P", 0.04),
        )
    ):
        prints.write(
            image, text, 0.5, 0.13 + (0, 0.2, 0.36, 0.49, 0.6, 0.69)[k], tall, (20, 20, 22), True
        )
    prints.fill(image, 0.2, 0.9, 0.6, 0.015, (206, 40, 40))


def _swatch(look: Look, image: prints.Canvas, accent: RGB) -> None:
    names = (
        "red",
        "orange",
        "yellow",
        "lime",
        "green",
        "teal",
        "sky",
        "blue",
        "purple",
        "pink",
        "brown",
        "gray",
    )
    for k, name in enumerate(names):
        prints.fill(
            image, 0.06 + 0.225 * (k % 4), 0.08 + 0.29 * (k // 4), 0.2, 0.22, look.own_color(name)
        )
        prints.fill(image, 0.08 + 0.225 * (k % 4), 0.32 + 0.29 * (k // 4), 0.12, 0.015, GRAY)


def _poster(look: Look, image: prints.Canvas, accent: RGB) -> None:
    h, w = image.shape[:2]
    image[: int(0.78 * h)] = textures.fit(
        prints.artwork(look.rng, w, int(0.78 * h)), int(0.78 * h), w
    )
    prints.write(
        image, look.pick(["CONCERT", "CINEMA", "TRAVEL", "SUMMER"]), 0.5, 0.87, 0.09, accent, True
    )
    prints.fill(image, 0.2, 0.94, 0.6, 0.012, GRAY)


def _report(look: Look) -> Pieces:
    """A bound report lying: a comb along its edge, a clear print on its cover."""
    color = look.color("white", "sky", "navy", "cream", "gray")
    cover = prints.canvas(128, 176, color)
    ink = (250, 250, 246) if sum(color) < 380 else (34, 40, 60)
    accent = look.own_color("crimson", "blue", "teal", "orange")
    prints.fill(cover, 0, 0.58, 1, 0.03, accent)
    prints.write(
        cover, look.pick(["REPORT", "ANNUAL REPORT", "STUDY"]), 0.54, 0.34, 0.075, ink, True
    )
    prints.fill(cover, 0.3, 0.44, 0.5, 0.015, ink)  # type: ignore[arg-type]
    for k in range(5):
        tall = 0.05 + 0.04 * k
        prints.fill(cover, 0.3 + 0.09 * k, 0.92 - tall, 0.06, tall, accent)
    pages = at_box(0.205, 0.292, 0.011, (0, 0, 0.0008))
    boards = [at_box(0.21, 0.297, 0.0009, (0, 0, z)) for z in (0, 0.0117)]
    rings = [
        at_block(0.016, 0.005, 0.0136, 0.002, (-0.105, y, 0))
        for y in np.linspace(-0.135, 0.135, 19)
    ]
    return [(boards[0], textures.plain(color)), (pages, prints.pages(look.rng, (244, 242, 236))),
             (boards[1], cover),
            (join(rings), dye(look, "black", "white", "navy"))]  # fmt: skip


def _memo(look: Look) -> Pieces:
    pad = at_box(0.1, 0.145, 0.008)
    page = prints.canvas(96, 144, (252, 246, 214))
    for k in range(11):
        prints.fill(page, 0.06, 0.2 + 0.07 * k, 0.88, 0.006, (170, 190, 220))
    for k in range(3):
        prints.stroke(
            page,
            [(0.1 + 0.04 * n, 0.245 + 0.07 * k + 0.01 * (-1) ** n) for n in range(12)],
            0.008,
            (50, 60, 120),
        )
    band = at_box(0.1, 0.02, 0.0088, (0, 0.063, 0))
    return [
        (pad, prints.pages(look.rng)),
        (band, dye(look, "crimson", "navy", "green")),
        (at_box(0.0998, 0.124, 0.0005, (0, -0.01, 0.0078)), page),
    ]


_row = Rows("office", ("white",), "lying flat", spread=0.06, roles=("flat",)).of_drawing


CATEGORIES = (
    vary(_row("star_chart", paper(0.28, 0.28, _stars, "navy"), (0.28, 0.28, 0.0011), 0.008,
             ("star map", "sky map", "constellation chart", "constellation map"), ("navy",)), 0.08),
    vary(_row("telegram", paper(0.2, 0.13, _telegram, "beige", "cream"), (0.2, 0.13, 0.0011),
             0.003,
             ("telegraph message",), ("beige",)), 0.08),
    _row("ransom_note", paper(0.17, 0.2, _ransom, "white", "cream"), (0.17, 0.2, 0.0011), 0.004,
             ("collage note",)),
    _row("shopping_list", paper(0.1, 0.16, _list, "white", "yellow", "cream"), (0.1, 0.16,
             0.0011), 0.002, ("to do list", "grocery list", "todo list", "packing list",
             "handwritten list", "wish list")),
    _row("xray_film", paper(0.24, 0.3, _film, "charcoal"), (0.24, 0.3, 0.0011), 0.01,
             ("x ray film", "x ray", "xray", "x ray image", "x-ray film", "x-ray"), ("charcoal",)),
    vary(_row("eye_chart", paper(0.2, 0.29, _chart, "white"), (0.2, 0.29, 0.0011), 0.006,
             ("eye test chart", "snellen chart", "vision chart")), 0.08),
    vary(_row("colour_chart", paper(0.21, 0.16, _swatch, "white"), (0.21, 0.16, 0.0011), 0.006,
             ("color chart", "paint chart", "colour card", "color swatch", "colour swatch",
             "paint swatch", "colour sample card", "periodic table")), 0.08),
    _row("poster", paper(0.3, 0.42, _poster, "white", "cream"), (0.3, 0.42, 0.0011), 0.02,
             ("art print", "film poster", "movie poster", "concert poster", "unframed print")),
    _row("report", _report, (0.218, 0.297, 0.0136), 0.35, ("bound report", "annual report",
             "school report", "book report", "thesis", "dissertation",
             "first aid manual", "user manual", "instruction manual", "handbook",
             "instruction booklet", "report binder")),
    vary(_row("memo_pad", _memo, (0.1, 0.145, 0.0088), 0.09, ("memo block", "reporter pad",
             "jotter pad"), ("yellow",)), 0.08),
)  # fmt: skip
"""The module's categories."""
