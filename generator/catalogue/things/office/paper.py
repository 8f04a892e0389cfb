"""Loose printed paper: an open book, loose photographs."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from ...build.category import Category
from ...build.collision import box_part, hull_part
from ...build.forms import side_view, spread
from ...build.shape import Shape, shape
from ...build.solids import box, join, torus
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.ink import Canvas
from ...surfaces.look import Look
from ...surfaces.textures import Tile

PAGES = ("novel", "novel", "textbook", "picture", "recipe", "ruled", "music")
BOARD = 0.0025


def open_book(look: Look) -> Shape:
    """A book lying open: two blocks of pages arched up from the spine, printed or written on."""
    kind = look.pick(PAGES)
    w, y = look.between(0.125, 0.175), look.between(0.185, 0.245)
    thick, read = look.between(0.014, 0.034), look.between(0.25, 0.75)
    paper = look.own_color("white", "cream", "ivory", "beige", spread=5)
    color = look.color("red", "navy", "teal", "mustard", "green", "charcoal", "brown", "purple")
    cover = box(2 * w + 0.012, y + 0.01, BOARD)
    pieces = [(cover, textures.speckles(look.rng, color, 4, 32))]
    parts = [box_part(2 * w + 0.012, y + 0.01, BOARD)]
    edge = prints.pages(look.rng, paper)
    for side, share in ((-1, read), (1, 1 - read)):
        top = _arch(side * w, BOARD + 0.002 + share * thick)
        outline = np.concatenate([[(0, BOARD), (side * w, BOARD)], top[::-1]])
        block = side_view(outline[::side], y)
        rows = [np.column_stack([top[:, 0], np.full(len(top), s * y / 2), top[:, 1]])
                for s in (-1, 1)]  # fmt: skip
        page = spread(np.stack(rows)[:, ::side], 3e-4)
        fore = box(6e-4, y, top[-1, 1] - BOARD).move(x=side * w, z=BOARD)
        pieces += [(block, edge), (fore, edge), (page, _page(look, kind, paper, side))]
        parts.append(hull_part(np.concatenate(rows + [_floor(r) for r in rows])))
    if kind == "ruled":
        wire = torus(0.0075, 0.0011, 14, 5).turn(0, np.pi / 2)
        rings = [wire.move(0, v * y, 0.0088) for v in np.linspace(-0.46, 0.46, 13)]
        pieces.append((join(rings), textures.plain((150, 152, 158))))
    elif look.chance(0.45):
        way = np.array([(0.36 * y, 0.8), (-0.5 * y, 0.8), (-0.5 * y - 0.012, 0.3)])
        height = float(np.interp(0.012, *_arch(w, BOARD + 0.002 + (1 - read) * thick).T))
        rows = [[(x, v, share * height + 6e-4) for x in (0.009, 0.015)] for v, share in way]
        ribbon = look.own_color("red", "navy", "gold", "green")
        pieces.append((spread(np.array(rows[::-1]), 3e-4), textures.plain(ribbon)))
    return shape(pieces, parts)


def _arch(reach: float, edge: float) -> Float[np.ndarray, "k 2"]:
    """Return a page from the spine (x = 0) to x = ``reach``: up, over, and down to ``edge``."""
    t = np.array([0, 0.05, 0.12, 0.2, 0.3, 0.45, 0.65, 0.85, 1])
    rise = np.sin(np.pi / 2 * np.minimum(t / 0.3, 1))
    fall = np.maximum(t - 0.3, 0) ** 2 / 0.49
    arch = edge + 0.006
    low = 0.45 * arch
    return np.column_stack([reach * t, low + (arch - low) * rise - (arch - edge) * fall])


def _floor(row: Float[np.ndarray, "k 3"]) -> Float[np.ndarray, "2 3"]:
    """Return the ends of a page's edge, lowered onto the cover."""
    ends = row[[0, -1]].copy()
    ends[:, 2] = BOARD
    return ends


def _page(look: Look, kind: str, paper: RGB, side: int) -> Tile:
    """Return the page left (-1) or right (1) of the spine, darker towards it."""
    image = prints.canvas(136, 192, paper)
    {"novel": _novel, "textbook": _textbook, "picture": _picture, "recipe": _recipe,
     "ruled": _rule, "music": _music}[kind](image, look, side)  # fmt: skip
    if kind != "ruled":
        prints.fill(image, 0.48, 0.95, 0.05, 0.012, (110, 110, 112))
    away = np.linspace(0, 1, 136)[::side]
    shade = 1 - 0.38 * np.exp(-away / 0.07)
    return np.clip(image * shade[None, :, None], 0, 255).astype(np.uint8)


def _novel(image: Canvas, look: Look, side: int) -> None:
    ink: RGB = (92, 90, 90)
    top = 0.08
    if side > 0 and look.chance(0.5):
        prints.write(image, look.pick(["ONE", "VII", "CHAPTER", "SPRING"]), 0.5, 0.16, 0.07, ink)
        top = 0.28
    prints.lines(image, look.rng, (0.12, top, 0.76, 0.92 - top), round((0.92 - top) * 32), ink)


def _textbook(image: Canvas, look: Look, side: int) -> None:
    accent = look.own_color("blue", "teal", "orange", "crimson", "green")
    prints.fill(image, 0.1, 0.06, 0.6, 0.035, accent)
    for x in (0.1, 0.53):
        prints.lines(image, look.rng, (x, 0.14, 0.37, 0.36), 12, (96, 96, 100))
    prints.fill(image, 0.1, 0.54, 0.8, 0.24, tint_color(accent, 1.75))
    if side > 0:
        for k in range(5):
            tall = look.between(0.05, 0.2)
            prints.fill(image, 0.18 + 0.13 * k, 0.76 - tall, 0.08, tall, accent)
    else:
        xs = np.linspace(0.15, 0.85, 20)
        curve = 0.66 - 0.08 * np.sin(9 * xs + look.between(0, 6))
        prints.stroke(image, list(zip(xs, curve, strict=True)), 0.012, accent)
    prints.lines(image, look.rng, (0.1, 0.82, 0.8, 0.1), 3, (96, 96, 100))


def _picture(image: Canvas, look: Look, side: int) -> None:
    if side < 0:
        image[:] = textures.fit(prints.artwork(look.rng, 136, 192), 192, 136)
        return
    image[20:116, 12:124] = textures.fit(prints.artwork(look.rng, 112, 96), 96, 112)
    prints.lines(image, look.rng, (0.14, 0.66, 0.72, 0.22), 5, (70, 66, 66), 0.3)


def _recipe(image: Canvas, look: Look, side: int) -> None:
    accent = look.own_color("coral", "olive", "mustard", "teal", "crimson")
    if side < 0:
        prints.fill(image, 0, 0, 1, 0.55, tint_color(accent, 1.3))
        for radius, color in (
            (0.2, (246, 244, 238)),
            (0.15, accent),
            (0.1, tint_color(accent, 0.7)),
        ):
            prints.disc(image, 0.5, 0.28, radius, color)
        for _ in range(9):
            u, v = look.between(0.4, 0.6), look.between(0.2, 0.36)
            prints.disc(
                image, u, v, 0.022, look.pick([(226, 190, 90), (110, 150, 70), (200, 60, 50)])
            )
        prints.lines(image, look.rng, (0.12, 0.64, 0.76, 0.26), 7, (96, 94, 92))
        return
    prints.fill(image, 0.12, 0.07, 0.55, 0.045, accent)
    for k in range(7):
        prints.disc(image, 0.14, 0.186 + 0.043 * k, 0.009, accent)
        prints.fill(image, 0.2, 0.18 + 0.043 * k, look.between(0.25, 0.5), 0.012, (96, 94, 92))
    prints.lines(image, look.rng, (0.12, 0.52, 0.76, 0.38), 12, (96, 94, 92))


def _rule(image: Canvas, look: Look, side: int) -> None:
    ink = look.own_color("navy", "black", "blue")
    full = int(look.rng.integers(4, 15)) if side > 0 else 15
    for k in range(15):
        v = 0.12 + 0.055 * k
        prints.fill(image, 0, v, 1, 0.004, (168, 192, 218))
        if k < full:
            xs = np.arange(0.14, look.between(0.55, 0.9), 0.022)
            hand = v - 0.012 + look.rng.uniform(-0.013, 0.008, len(xs))
            prints.stroke(image, list(zip(xs, hand, strict=True)), 0.004, ink)
    prints.fill(image, 0.1, 0, 0.008, 1, (224, 130, 130))


def _music(image: Canvas, look: Look, side: int) -> None:
    ink: RGB = (50, 48, 50)
    prints.fill(image, 0.3, 0.05, 0.4, 0.02, ink)
    for k in range(6):
        top = 0.12 + 0.14 * k
        for line in range(5):
            prints.fill(image, 0.08, top + 0.016 * line, 0.84, 0.003, ink)
        for u in np.arange(0.14, 0.9, 0.068):
            v = top + look.between(0, 0.07)
            prints.disc(image, u, v, 0.011, ink)
            prints.fill(image, u + 0.008, v - 0.045, 0.006, 0.045, ink)


def photo_print(look: Look) -> Shape:
    """Loose photographs, slightly curled: one or a few, glossy with a margin or instant."""
    instant = look.chance(0.4)
    x, y = (0.088, 0.107) if instant else look.pick([(0.15, 0.1), (0.1, 0.15), (0.13, 0.13)])
    frame = look.color("white", "white", "white", "cream", "black")
    count, curl = int(look.pick([1, 1, 2, 3])), look.between(0.002, 0.005)
    tone = look.pick(["color", "color", "color", "grey", "sepia"])
    pieces, parts = [], []
    u, v = np.meshgrid(np.linspace(-1, 1, 7), np.linspace(-1, 1, 5))
    for k in range(count):
        lift = 4e-4 * k + curl * (1 - 0.2 * k) * u**2
        grid = np.stack([u * x / 2, v * y / 2, lift], -1)
        turn, at = 0.55 * (k - (count - 1) / 2) + look.between(-0.12, 0.12), 0.016 * k
        leaf = spread(grid, 4e-4).turn(2, turn).move(at, 0.5 * at)
        pieces.append((leaf, _photo(look, x, y, frame, instant, tone)))
        parts.append(hull_part(leaf.vertices))
    return shape(pieces, parts)


def _photo(look: Look, x: float, y: float, frame: RGB, instant: bool, tone: str) -> Tile:
    """Return the face of a photograph: a picture in its margin."""
    width, height = round(1300 * x), round(1300 * y)
    image = prints.canvas(width, height, frame)
    margin = round(0.055 * width) if instant else look.pick([0, round(0.05 * min(width, height))])
    tall = height - (round(0.24 * height) if instant else 2 * margin)
    wide = width - 2 * margin
    maker = prints.landscape if look.chance(0.6) else prints.artwork
    picture = textures.fit(maker(look.rng, wide, tall), tall, wide).astype(float)
    if tone != "color":
        grey = picture.mean(-1, keepdims=True)
        picture = grey * (np.array((1.06, 0.94, 0.76)) if tone == "sepia" else np.ones(3))
    image[margin : margin + tall, margin : margin + wide] = np.clip(picture, 0, 255)
    return image


CATEGORIES = (
    Category("open_book", open_book, (0.31, 0.225, 0.026), 0.5,
             ("opened book", "open notebook", "opened notebook", "open novel", "open textbook",
              "open cookbook", "open journal", "open diary", "book lying open", "recipe book"),
             ("office", "living", "coffee"), ("flat", "support", "big"), ("navy", "red"),
             state="lying open"),
    Category("photo_print", photo_print, (0.135, 0.125, 0.0045), 0.006,
             ("polaroid", "polaroid photo", "snapshot", "instant photo", "printed photo",
              "printed photograph", "loose photo", "old photo", "old photograph", "daguerreotype",
             "tintype", "silhouette portrait", "miniature portrait", "carte de visite", "slide",
             "slide transparency"),
             ("living", "office", "craft"), ("flat",), ("white",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
