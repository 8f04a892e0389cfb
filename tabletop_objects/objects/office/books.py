"""Objects of the ``office`` theme: books."""

from __future__ import annotations

import numpy as np
from jaxtyping import Float

from ...kit import prints, surfaces
from ...kit.materials import dye, glaze_tile
from ...kit.parts import box_part, hull_part
from ...kit.primitives import at_box, side_view, spread
from ...kit.prints import Canvas
from ...kit.shapes import Pieces, Shape, category, from_pieces, shape, vary
from ...kit.solids import block, box, join, torus
from ...kit.surfaces import RGB, Look, Tile, tint_color


@category("memo_pad", size=(0.1, 0.145, 0.0088), mass=0.09, material="paper",
          aliases=("memo block", "reporter pad", "jotter pad"), themes=("office",), roles=("flat",),
          colors=("yellow",), state="lying flat")  # fmt: skip
@vary(0.08)
@from_pieces(spread=0.06)
def memo_pad(look: Look) -> Pieces:
    """A memo pad lying flat: a lined top sheet with three lines of writing and a coloured band."""
    pad = at_box(0.1, 0.145, 0.008)
    page = prints.canvas(96, 144, (252, 246, 214))
    for k in range(11):
        prints.fill(page, 0.06, 0.2 + 0.07 * k, 0.88, 0.006, (170, 190, 220))
    for k in range(3):
        prints.stroke(page, [(0.1 + 0.04 * n, 0.245 + 0.07 * k + 0.01 * (-1) ** n)
                             for n in range(12)], 0.008, (50, 60, 120))  # fmt: skip
    band = at_box(0.1, 0.02, 0.0088, (0, 0.063, 0))
    return [(pad, prints.pages(look.rng)), (band, dye(look, "crimson", "navy", "green")),
            (at_box(0.0998, 0.124, 0.0005, (0, -0.01, 0.0078)), page)]  # fmt: skip


INKS = ("red", "navy", "teal", "mustard", "crimson", "green", "blue", "charcoal", "purple")


@category("book", size=(0.15, 0.215, 0.028), mass=0.45, material="paper", aliases=("novel",
          "hardback", "hymnal", "songbook", "hymn book", "almanac", "manga", "guide", "guidebook",
          "manual", "bible commentary", "script", "screenplay", "audiobook", "leather-bound book",
          "illuminated manuscript", "dress pattern", "libretto", "dust jacket", "volume"),
          themes=("office", "living", "coffee"), roles=("support", "flat"), colors=("red", "navy",
          "teal", "mustard", "crimson", "green", "blue", "charcoal", "purple"), state="lying flat",
          common=True)  # fmt: skip
def book(look: Look) -> Shape:
    """A hardback lying flat with its title up and its spine on the left."""
    x, y = look.between(0.12, 0.175), look.between(0.185, 0.24)
    h, board = look.between(0.016, 0.042), look.pick([0.0008, 0.0028])
    color, accent = look.color(*INKS), look.own_color("cream", "gold", "coral", "sky", "white")
    title = look.pick(["ATLAS", "POEMS", "GARDEN", "MINDS", "THE SEA", "COOKING", "ORBIT", "EMMA",
                       "DESIGN", "1984"])  # fmt: skip
    front = prints.cover(look.rng, title, color, accent)
    cloth = surfaces.speckles(look.rng, color, 4, 32)
    top = box(x, y, board).move(z=h - board)
    back = box(x, y, board)
    spine = box(board, y, h).move(x=-(x - board) / 2)
    stack = box(x - 0.005, y - 0.007, h - 2 * board).move(x=-0.0015, z=board)
    return shape([(top, front), (back, cloth), (spine, cloth), (stack, prints.pages(look.rng))],
                 [box_part(x, y, h)])  # fmt: skip


@category("notebook", size=(0.145, 0.2, 0.014), mass=0.22, material="paper", aliases=("journal",
          "diary", "sketchbook", "notepad", "planner", "order pad", "legal pad", "score pad",
          "writing pad", "betting book", "workbook", "exercise book", "address book", "sketch pad",
          "graph paper pad", "flip chart pad", "steno pad", "drawing pad", "sketch book",
          "pad of paper", "paper pad", "jotter", "logbook", "bullet journal", "ledger"),
          themes=("office", "craft", "coffee"), roles=("support", "flat"),
          colors=("black", "teal", "coral"), state="lying flat", common=True)  # fmt: skip
def notebook(look: Look) -> Shape:
    """A closed notebook, ring-bound with a title or held shut by an elastic band."""
    x, y, h = look.between(0.13, 0.155), look.between(0.19, 0.215), look.between(0.012, 0.016)
    color = look.color("black", "teal", "coral", "mustard", "navy", "sage", "pink", "tan")
    band = look.own_color("red", "black", "gold", "cream")
    rings = look.chance(0.5)
    image = prints.canvas(128, 176, color)
    kind = int(look.rng.integers(4))
    if kind == 0:
        image = glaze_tile(look, color)
    elif kind == 1:
        image = prints.artwork(look.rng, 128, 176)
    image = surfaces.fit(image, 176, 128).copy()
    if rings:
        prints.fill(image, 0.25, 0.2, 0.5, 0.2, (246, 244, 236))
        prints.write(image, "NOTES", 0.5, 0.3, 0.08, (60, 60, 66))
    else:
        prints.fill(image, 0.86, 0, 0.05, 1, band)
    cover = block(x, y, 0.0016, 0.006).move(z=h - 0.0016)
    pieces = [(cover, image), (block(x, y, 0.0016, 0.006), surfaces.plain(color)),
              (box(x - 0.004, y - 0.004, h - 0.0032).move(z=0.0016),
               prints.pages(look.rng))]  # fmt: skip
    if rings:
        wire = torus(h / 2, 0.0011, 14, 5).turn(0, np.pi / 2)
        steel = surfaces.plain((150, 152, 158))
        count = 11
        pieces += [(wire.move(-x / 2 + 0.002, (k / (count - 1) - 0.5) * 0.88 * y, h / 2 + 0.0011),
                    steel) for k in range(count)]  # fmt: skip
    return shape(pieces, [box_part(x, y, h)])


@category("sticky_notes", size=(0.076, 0.076, 0.022), mass=0.06, material="paper",
          aliases=("sticky note", "post-it", "post it note", "note pad", "bookplate", "post it pad",
          "post-it pad", "sticky note pad", "page flag"), themes=("office",), roles=("flat",),
          colors=("yellow", "pink"), state="lying flat", common=True)  # fmt: skip
def sticky_notes(look: Look) -> Shape:
    """A square pad of sticky notes with the front edge of its top sheet lifted."""
    side, h = 0.076, look.between(0.012, 0.022)
    color = look.color("yellow", "pink", "lime", "sky", "orange", "lavender", "mint", spread=4)
    image = prints.canvas(96, 96, color)
    if look.chance(0.6):
        prints.lines(image, look.rng, (0.14, 0.2, 0.6, 0.5), 4, (70, 74, 110), 0.18)
    sheet = box(side, side, 0.0008).bend(
        lambda p: np.column_stack([p[:, :2], p[:, 2] + np.where(p[:, 1] < 0, 0.005, 0)])
    )
    return shape([(box(side, side, h), surfaces.stripes([color, tint_color(color, 0.88)], 8,
                                                        side=32)), (sheet.move(z=h), image)],
                 [box_part(side, side, h)])  # fmt: skip


PAGES = ("novel", "novel", "textbook", "picture", "recipe", "ruled", "music")
BOARD = 0.0025


@category("open_book", size=(0.31, 0.225, 0.026), mass=0.5, material="paper",
          aliases=("opened book", "open notebook", "opened notebook", "open novel", "open textbook",
          "open cookbook", "open journal", "open diary", "book lying open", "recipe book"),
          themes=("office", "living", "coffee"), roles=("flat", "support", "big"),
          colors=("navy", "red"), state="lying open", common=True)  # fmt: skip
def open_book(look: Look) -> Shape:
    """An open book lying flat: two arched blocks of printed or handwritten pages."""
    kind = look.pick(PAGES)
    w, y = look.between(0.125, 0.175), look.between(0.185, 0.245)
    thick, read = look.between(0.014, 0.034), look.between(0.25, 0.75)
    paper = look.own_color("white", "cream", "ivory", "beige", spread=5)
    color = look.color("red", "navy", "teal", "mustard", "green", "charcoal", "brown", "purple")
    cover = box(2 * w + 0.012, y + 0.01, BOARD)
    pieces = [(cover, surfaces.speckles(look.rng, color, 4, 32))]
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
        pieces.append((join(rings), surfaces.plain((150, 152, 158))))
    elif look.chance(0.45):
        way = np.array([(0.36 * y, 0.8), (-0.5 * y, 0.8), (-0.5 * y - 0.012, 0.3)])
        height = float(np.interp(0.012, *_arch(w, BOARD + 0.002 + (1 - read) * thick).T))
        rows = [[(x, v, share * height + 6e-4) for x in (0.009, 0.015)] for v, share in way]
        ribbon = look.own_color("red", "navy", "gold", "green")
        pieces.append((spread(np.array(rows[::-1]), 3e-4), surfaces.plain(ribbon)))
    return shape(pieces, parts)


def _arch(reach: float, edge: float) -> Float[np.ndarray, "k 2"]:
    """Return the (x, z) curve of a page from the spine at x = 0 to the point (reach, edge)."""
    t = np.array([0, 0.05, 0.12, 0.2, 0.3, 0.45, 0.65, 0.85, 1])
    rise = np.sin(np.pi / 2 * np.minimum(t / 0.3, 1))
    fall = np.maximum(t - 0.3, 0) ** 2 / 0.49
    arch = edge + 0.006
    low = 0.45 * arch
    return np.column_stack([reach * t, low + (arch - low) * rise - (arch - edge) * fall])


def _floor(row: Float[np.ndarray, "k 3"]) -> Float[np.ndarray, "2 3"]:
    """Return the end points of ``row``, an edge of a page, lowered onto the cover."""
    ends = row[[0, -1]].copy()
    ends[:, 2] = BOARD
    return ends


def _page(look: Look, kind: str, paper: RGB, side: int) -> Tile:
    """Return the texture of a left (-1) or right (1) page; it is darker towards the spine."""
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
        image[:] = surfaces.fit(prints.artwork(look.rng, 136, 192), 192, 136)
        return
    image[20:116, 12:124] = surfaces.fit(prints.artwork(look.rng, 112, 96), 96, 112)
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
