"""Printed paper and money: magazines, newspapers, letters, banknotes, coins, price tags."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import spread
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, join, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, readable_on, tint_color
from ...surfaces.look import Look


def magazine(look: Look) -> Shape:
    """A magazine lying flat: a full-page picture, a large name, headlines beside it."""
    x, y, h = look.between(0.2, 0.22), look.between(0.265, 0.29), look.between(0.004, 0.009)
    color = look.color("red", "yellow", "white", "teal", "pink", "black", "sky", "orange")
    image = textures.fit(prints.artwork(look.rng, 160, 208), 208, 160).copy()
    name = look.pick(
        ["VOGA", "TIME", "STYLE", "FORBIA", "NATURE", "HOME", "TRAVEL", "FOOD", "MODE"]
    )
    if look.chance(0.4):
        prints.fill(image, 0, 0, 1, 0.2, color)
        prints.write(image, name, 0.5, 0.12, 0.15, readable_on(color), bold=True)
    else:
        prints.write(image, name, 0.5, 0.12, 0.16, color, bold=True)
    ink = color if sum(color) > 420 else (250, 250, 246)
    for k in range(3):
        left = look.chance(0.6)
        prints.lines(
            image, look.rng, (0.06 if left else 0.6, 0.32 + 0.18 * k, 0.32, 0.09), 2, ink, 0.55
        )
    prints.barcode(image, look.rng, 0.7, 0.88, 0.24)
    body = box(x, y, h - 0.0008)
    top = (
        box(x, y, 0.0012)
        .bend(
            lambda p: np.column_stack(
                [p[:, :2], p[:, 2] + 0.003 * np.clip(p[:, 0] / (0.5 * x), 0, 1) ** 2]
            )
        )
        .move(z=h - 0.001)
    )
    return shape(
        [(body, prints.pages(look.rng, (244, 242, 236))), (top, image)], [box_part(x, y, h)]
    )


def newspaper(look: Look) -> Shape:
    """A folded newspaper lying flat: its name, headlines, columns and a picture."""
    x, y, h = look.between(0.28, 0.32), look.between(0.2, 0.24), look.between(0.007, 0.013)
    color = look.color("white", "cream", "ivory", "beige", "gray", "pink", spread=10)
    paper: RGB = tint_color(color, 0.97)
    image = prints.canvas(256, 176, paper)
    ink = (46, 46, 50)
    prints.write(
        image,
        look.pick(["THE DAILY NEWS", "MORNING POST", "THE TIMES", "CITY HERALD"]),
        0.5,
        0.1,
        0.13,
        ink,
        True,
    )
    prints.fill(image, 0.03, 0.19, 0.94, 0.008, ink)
    headline = look.pick(["MARKETS RISE", "ROBOTS AT WORK", "RAIN AGAIN", "TEAM WINS CUP"])
    prints.write(image, headline, 0.5, 0.28, 0.1, ink, bold=True)
    columns = look.pick([4, 5])
    at = int(look.rng.integers(columns - 1))
    for k in range(columns):
        start = 0.62 if k in (at, at + 1) else 0.38
        prints.lines(
            image,
            look.rng,
            (0.04 + 0.93 * k / columns, start, 0.86 / columns, 0.96 - start),
            int(34 * (0.96 - start)),
            (120, 120, 124),
            0.45,
        )
    wide = int(1.9 * 0.93 / columns * 256)
    picture = prints.artwork(look.rng, wide, 40).astype(float)
    grey = np.repeat(picture.mean(-1, keepdims=True), 3, -1) if look.chance(0.6) else picture
    left = int((0.04 + 0.93 * at / columns) * 256)
    image[66:106, left : left + wide] = grey.astype(np.uint8)
    t = h / 3
    layers = [box(x - 0.004 * k, y, t).move(x=0.002 * k, z=k * t) for k in range(3)]
    top = box(x - 0.008, y, 0.0006).move(x=0.004, z=h)
    side = prints.pages(look.rng, paper)
    return shape([(join(layers), side), (top, image)], [box_part(x - 0.004, y, h)])


def letter(look: Look) -> Shape:
    """A handwritten or typed letter, folded in three and open again."""
    x, y = look.between(0.15, 0.21), look.between(0.21, 0.28)
    color = look.color("white", "white", "cream", "ivory", "pink", "sky", spread=10)
    image = prints.canvas(144, 192, color)
    ink = look.own_color("navy", "black", "charcoal", "indigo")
    if look.chance(0.6):
        for row in range(11):
            width = 0.3 if row == 0 else look.between(0.6, 0.8) if row < 9 else 0.35
            t = np.linspace(0, 1, int(30 * width) + 6)
            wave = (
                0.1 + 0.072 * row + 0.012 * np.sin(46 * t * width + row) * np.sin(17 * t + 2 * row)
            )
            prints.stroke(
                image, [(0.12 + width * u, v) for u, v in zip(t, wave, strict=True)], 0.006, ink
            )
    else:
        prints.fill(image, 0.1, 0.05, 0.24, 0.05, look.own_color("red", "teal", "navy", "green"))
        prints.lines(image, look.rng, (0.62, 0.06, 0.26, 0.06), 3, (120, 120, 126))
        prints.lines(image, look.rng, (0.12, 0.22, 0.76, 0.56), 15, (110, 110, 116))
        t = np.linspace(0, 1, 20)
        prints.stroke(
            image, [(0.14 + 0.24 * u, 0.87 + 0.02 * np.sin(30 * u)) for u in t], 0.008, ink
        )
    rows, columns = 19, 5
    u, v = np.meshgrid(np.linspace(-0.5, 0.5, columns), np.linspace(-0.5, 0.5, rows))
    crease = 0.035 * np.clip(np.abs(v) - 1 / 6, 0, 1)
    page = spread(np.stack([u * x, v * y, crease], -1), 0.0008)
    return shape(
        [(page, image)],
        [
            box_part(x, 0.36 * y, 0.0008),
            *(box_part(x, 0.3 * y, 0.006, (0, s * 0.34 * y, 0.0)) for s in (-1, 1)),
        ],
    )


def _note(look: Look, color: RGB, value: str) -> textures.Tile:
    """Return the face of a banknote."""
    image = prints.canvas(160, 72, tint_color(color, 1.45))
    for k in range(24):
        prints.stroke(image, [(k / 24, 0), (k / 24 + 0.12, 1)], 0.01, tint_color(color, 1.25))
    prints.fill(image, 0, 0, 1, 0.06, color)
    prints.fill(image, 0, 0.94, 1, 0.06, color)
    prints.fill(image, 0, 0, 0.03, 1, color)
    prints.fill(image, 0.97, 0, 0.03, 1, color)
    prints.disc(image, 0.5, 0.5, 0.38, tint_color(color, 0.8))
    prints.disc(image, 0.5, 0.5, 0.34, tint_color(color, 1.6))
    prints.disc(image, 0.5, 0.42, 0.13, tint_color(color, 0.7))
    prints.polygon(
        image, [(0.4, 0.8), (0.44, 0.6), (0.56, 0.6), (0.6, 0.8)], tint_color(color, 0.7)
    )
    for u, v in ((0.12, 0.24), (0.88, 0.76)):
        prints.write(image, value, u, v, 0.26, tint_color(color, 0.5), bold=True)
    prints.lines(image, look.rng, (0.7, 0.2, 0.22, 0.2), 3, tint_color(color, 0.8))
    return image


def banknotes(look: Look) -> Shape:
    """A few banknotes fanned out, or a bundle with a paper band."""
    x, y = look.between(0.14, 0.16), look.between(0.064, 0.074)
    color = look.color("green", "sage", "olive", "teal", "orange", "sky", "pink", "violet")
    value = look.pick(["5", "10", "20", "50", "100"])
    face = _note(look, color, value)
    if look.chance(0.5):
        h = look.between(0.009, 0.018)
        body = box(x, y, h)
        top = box(x, y, 0.0004).move(z=h - 0.0001)
        strip = box(0.032, y + 0.0014, h + 0.0012)
        band = textures.plain(look.own_color("white", "tan", "gold", "sky"))
        edge = prints.pages(look.rng, tint_color(color, 1.4))
        return shape([(body, edge), (top, face), (strip, band)], [box_part(x, y, h + 0.001)])
    pieces, notes = [], []
    count = int(look.rng.integers(2, 6))
    for k in range(count):
        turn = (k - (count - 1) / 2) * -0.16 + look.between(-0.03, 0.03)
        tile = (
            face
            if look.chance(0.6)
            else _note(look, look.own_color("green", "orange", "sky", "violet"), "20")
        )
        note = box(x, y, 0.0009).move(x=0.3 * x).turn(2, turn).move(x=-0.3 * x, z=0.0009 * k)
        notes.append(note)
        pieces.append((note, tile))
    return shape(pieces, [hull_of(n) for n in notes])


def coins(look: Look) -> Shape:
    """Coins: one or two small stacks and a few lying about."""
    color = look.color("gold", "silver", "copper", "bronze", "gold", "silver")
    tones = [color, look.own_color("silver", "gold", "copper")]
    pieces: list[tuple[Solid, textures.Tile]] = []
    parts = []

    def face(tone: RGB) -> textures.Tile:
        image = prints.canvas(64, 64, tone)
        prints.disc(image, 0.5, 0.5, 0.48, tint_color(tone, 0.75), 0.42)
        prints.write(
            image,
            look.pick(["1", "2", "5", "10", "50"]),
            0.5,
            0.5,
            0.4,
            tint_color(tone, 0.55),
            bold=True,
        )
        return image

    places = [(0.0, 0.0), (0.029, 0.004), (0.012, -0.027), (-0.02, -0.024), (0.042, -0.022)]
    for n in range(int(look.rng.integers(3, 6))):
        tone = tones[n % 2]
        r, t = look.between(0.0095, 0.0125), 0.0021
        high = int(look.rng.integers(3, 9)) if n < 2 else 1
        x, y = places[n]
        side = textures.stripes(
            [tint_color(tone, 0.6), tone, tone, tone], high, side=max(4 * high, 16)
        )
        coin = cylinder(r, t * high, 30).move(x, y)
        top = cylinder(0.97 * r, 0.0003, 28).move(x, y, t * high - 0.0001)
        pieces += [(coin, side), (top, face(tone))]
        parts.append(cylinder_part(r, t * high, (x, y, 0)))
    return shape(pieces, parts)


def price_tag(look: Look) -> Shape:
    """A price tag: a card with a hole and a string lying flat, or one on a small stand."""
    color = look.color("white", "yellow", "tan", "red", "orange", "lime", "sky")
    price = f"{int(look.rng.integers(1, 99))}.{look.pick(['99', '50', '00', '95'])}"
    ink = readable_on(color)
    if look.chance(0.5):
        x, y = look.between(0.06, 0.085), look.between(0.034, 0.045)
        cut = 0.25 * y
        outline = np.array(
            [
                (-x / 2 + cut, -y / 2),
                (x / 2, -y / 2),
                (x / 2, y / 2),
                (-x / 2 + cut, y / 2),
                (-x / 2, y / 2 - cut),
                (-x / 2, -y / 2 + cut),
            ]
        )
        card = prism(outline, 0, 0.0014)
        image = prints.canvas(128, 72, color)
        prints.disc(image, 0.12, 0.5, 0.12, tint_color(color, 0.6))
        prints.disc(image, 0.12, 0.5, 0.07, (60, 50, 44))
        prints.write(image[:, 26:], price, 0.52, 0.5, 0.4, ink, bold=True)
        face = prism(outline * 0.995, 0.0013, 0.0017)
        string = tube(
            smooth(
                [
                    (-x / 2 + 0.009, 0, 0.002),
                    (-x / 2 - 0.01, 0.006, 0.0014),
                    (-x / 2 - 0.035, 0.016, 0.0012),
                    (-x / 2 - 0.04, 0.0, 0.0012),
                    (-x / 2 - 0.012, -0.004, 0.0014),
                    (-x / 2 + 0.009, 0, 0.0024),
                ],
                4,
            ),
            0.0007,
            5,
        )
        return shape([(card, textures.plain(tint_color(color, 0.92))), (face, image),
                      (string, textures.plain((236, 230, 214)))], [hull_of(card)])  # fmt: skip
    x, h = look.between(0.07, 0.1), look.between(0.045, 0.06)
    image = prints.canvas(144, 80, color)
    prints.fill(image, 0, 0, 1, 0.2, tint_color(color, 0.75))
    prints.write(image, price, 0.5, 0.5, 0.4, ink, bold=True)
    foot = block(0.6 * x, 0.035, 0.006, 0.006, 0.001)
    lean = 0.2
    card = box(x, 0.002, h).turn(0, -lean).move(z=0.005)
    face = box(0.97 * x, 0.0006, 0.95 * h).turn(0, -lean).move(y=-0.0012, z=0.006)
    clip = box(0.3 * x, 0.012, 0.006).move(y=0.001, z=0.004)
    dark = textures.plain(look.own_color("black", "silver", "white", "wooden"))
    return shape(
        [
            (join([foot, clip]), dark),
            (card, textures.plain(tint_color(color, 0.92))),
            (face, image),
        ],
        [hull_of(foot), hull_of(card)],
    )


CATEGORIES = (
    Category("magazine", magazine, (0.21, 0.277, 0.01), 0.25, ("fashion magazine", "comic",
             "comic book", "catalog", "brochure", "magazines", "catalogue", "programme",
             "manga magazine", "teacher's planner", "crossword book", "colouring book",
             "coloring book", "activity book", "football programme", "match programme",
             "theatre programme"), ("living", "coffee"),
             ("flat", "support"), ("red", "white"), state="lying flat"),
    Category("newspaper", newspaper, (0.299, 0.222, 0.0108), 0.18, ("daily newspaper",
             "folded newspaper", "news paper", "tabloid", "daily paper"), ("living", "coffee"),
             ("flat", "support", "big"), ("white",), state="lying flat"),
    Category("letter", letter, (0.18, 0.245, 0.012), 0.006, ("handwritten letter", "love letter",
             "handwritten note", "typed letter", "letter to santa", "letter to father christmas"),
             ("office",), ("flat",), ("white", "cream"), state="lying flat"),
    Category("banknotes", banknotes, (0.153, 0.0826, 0.0108), 0.02, ("money", "bank notes",
                 "cash",  "dollar bills", "dollar bill", "stack of money",
                 "bundle of money", "bundle of banknotes", "dollars", "wad of cash",
                 "euro notes",  "stack of bills"),
             ("office", "living"), ("flat",), ("green",), state="lying flat"),
    Category("coins", coins, (0.0742, 0.0532, 0.0141), 0.06, ("coin stack", "stack of coins",
             "change", "sixpence", "shilling", "bag of chocolate coins", "chocolate coin",
             "souvenir coin", "souvenir", "roll of coins"),
             ("office", "living"), ("flat",), ("gold",
             "silver"),
             state="lying flat"),
    Category("price_tag", price_tag, (0.101, 0.0382, 0.0294), 0.008, ("price label", "price card",
             "price sign", "sale tag"), ("office",), ("flat",), ("white", "yellow")),
)  # fmt: skip
"""The module's categories."""
