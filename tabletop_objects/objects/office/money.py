"""Objects of the ``office`` theme: money."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import dye, metal, shine
from ...kit.outlines import ellipse, lift, rectangle
from ...kit.parts import box_part, cylinder_part, hull_of
from ...kit.primitives import at_block, at_box, disc, hull_solid, standing, straight
from ...kit.shapes import Category, Drawing, Pieces, Shape, category, from_pieces, shape
from ...kit.solids import Solid, box, cylinder, join, loft, prism, torus
from ...kit.surfaces import RGB, Look, tint_color
from .papers import GRAY, INK, paper


def _face(look: Look, color: RGB) -> surfaces.Tile:
    """Return the texture of a coin's face: a head or a number within a rim."""
    image = prints.canvas(96, 96, color)
    dark, pale = tint_color(color, 0.62), tint_color(color, 1.3)
    prints.disc(image, 0.5, 0.5, 0.46, pale, 0.43)
    if look.chance(0.5):
        prints.disc(image, 0.5, 0.4, 0.17, dark)
        prints.polygon(image, [(0.24, 0.86), (0.34, 0.62), (0.66, 0.62), (0.76, 0.86)], dark)
        prints.disc(image, 0.45, 0.36, 0.05, pale)
    else:
        prints.write(image, look.pick(["1", "2", "5", "10", "50"]), 0.5, 0.47, 0.36, dark, True)
    for k in range(12):
        a = k * np.pi / 6
        prints.disc(image, 0.5 + 0.38 * np.cos(a), 0.5 + 0.38 * np.sin(a), 0.015, dark)
    return image


def _coin(r: float, h: float, sides: int, *colors: str) -> Drawing:
    def draw(look: Look) -> Pieces:
        color = look.color(*colors, spread=5)
        face = _face(look, color)
        edge = surfaces.stripes([tint_color(color, 0.75), tint_color(color, 1.1)], 32, upright=True)
        outline = ellipse(2 * r, 2 * r, sides)
        return [(prism(outline, 0, h, 0.0002), edge),
                (prism(0.94 * outline, h - 0.0002, h + 0.0002), face)]  # fmt: skip

    return draw


@category("bank_note", size=(0.15, 0.07, 0.0011), mass=0.001, material="paper",
          aliases=("single banknote", "five pound note", "ten euro note", "pound note", "euro note",
          "paper note", "single note", "five euro note", "ten pound note", "loose banknote",
          "banknote"), themes=("office",), roles=("flat",), colors=("green", "blue"),
          state="lying flat")  # fmt: skip
@from_pieces(spread=0.06)
def bank_note(look: Look) -> Pieces:
    """One slightly curved banknote."""
    color = look.color("green", "blue", "orange", "purple", "red", "gray")
    pale = tint_color(color, 1.72)
    image = prints.canvas(192, 92, pale)
    dark = tint_color(color, 0.7)
    prints.fill(image, 0.015, 0.03, 0.97, 0.94, dark)
    prints.fill(image, 0.025, 0.05, 0.95, 0.9, pale)
    prints.disc(image, 0.5, 0.5, 0.36, tint_color(color, 1.3))
    prints.disc(image, 0.5, 0.42, 0.16, dark)
    prints.polygon(image, [(0.38, 0.86), (0.44, 0.62), (0.56, 0.62), (0.62, 0.86)], dark)
    value = look.pick(["5", "10", "20", "50"])
    for x, y in ((0.1, 0.2), (0.9, 0.8)):
        prints.write(image, value, x, y, 0.26, dark, True)
    prints.lines(image, look.rng, (0.7, 0.2, 0.22, 0.3), 4, tint_color(color, 1.2))
    body = at_box(0.15, 0.07, 0.0011)
    return [(body, image)]


@category("gold_ingot", size=(0.115, 0.052, 0.032), mass=2.5, material="metal",
          aliases=("bullion bar",), themes=("office",), roles=("support",),
          colors=("gold",))  # fmt: skip
@from_pieces()
def gold_ingot(look: Look) -> Pieces:
    """A bar of bullion with slanted sides and a stamp on its top."""
    color = look.color("gold", "gold", "silver")
    rings = np.concatenate([lift(rectangle(0.115, 0.052), 0), lift(rectangle(0.1, 0.038), 0.032)])
    mark = prints.canvas(96, 32, tint_color(color, 0.92))
    prints.write(
        mark, look.pick(["999.9", "1 KG", "FINE GOLD"]), 0.5, 0.5, 0.5, tint_color(color, 0.5), True
    )
    return [
        (hull_solid(rings), look.surface(color, "metal")),
        (at_box(0.07, 0.02, 0.0006, (0, 0, 0.0317)), mark),
    ]


@category("money_clip", size=(0.089, 0.064, 0.0104), mass=0.05, material="metal",
          aliases=("clip of money", "notes in a clip"), themes=("office",), roles=("flat",),
          colors=("silver",))  # fmt: skip
@from_pieces()
def money_clip(look: Look) -> Pieces:
    """Folded banknotes in a metal clip."""
    steel = metal(look, "silver", "gold")
    color = look.own_color("green", "blue", "orange")
    notes = at_block(0.078, 0.064, 0.009, 0.004)
    clip = [at_block(0.058, 0.022, 0.0016, 0.004, (0.014, 0, z)) for z in (0.0, 0.0088)]
    bend = straight((0.044, -0.011, 0.0052), (0.044, 0.011, 0.0052), 0.0052, 12)
    return [(notes, surfaces.stripes([tint_color(color, 1.6), tint_color(color, 1.3)], 8)),
            (clip[1], steel), (join([clip[0], bend]), steel)]  # fmt: skip


@category("money_bag", size=(0.164, 0.114, 0.112), mass=0.6, material="fabric",
          aliases=("sack of gold", "bag of money", "bag of gold", "sack of coins", "bag of coins",
          "sack of money", "swag bag"), themes=("office",), colors=("tan",))  # fmt: skip
@from_pieces(bodies=1)
def money_bag(look: Look) -> Pieces:
    """A sack tied at its neck, with visible coins or a symbol on its front."""
    color = look.color("tan", "brown", "beige")
    body = standing((0.04, 0), (0.055, 0.012), (0.058, 0.04), (0.045, 0.075), (0.018, 0.095),
                    (0.024, 0.112), (0.03, 0.118), sides=22)  # fmt: skip
    tie = torus(0.0185, 0.005, 22, 8).move(z=0.094)
    mark = prints.canvas(64, 64, color)
    prints.write(mark, "$", 0.5, 0.5, 0.8, (60, 44, 30), True)
    badge = disc(0.022, 0.003).turn(0, np.pi / 2 - 0.25).move(0, -0.054, 0.046)
    coins = [disc(0.012, 0.002, (x, y, z)) for x, y, z in ((0.065, -0.03, 0), (0.078, -0.012, 0),
                                                           (0.07, -0.022, 0.002),
                                                           (-0.07, -0.03, 0))]  # fmt: skip
    return [(body, surfaces.fabric(look.rng, color)), (tie, dye(look, "brown", "red")),
            (badge, mark), (join(coins), shine(look, "gold"))]  # fmt: skip


def _bar(palette: tuple[str, ...], metal: str, long: tuple[float, float]):
    """Return the shape function of a cast metal bar with slanted sides and a stamp on top."""

    def make(look: Look) -> Shape:
        x = look.between(*long)
        y, h = 0.42 * x * look.between(0.9, 1.1), 0.24 * x * look.between(0.9, 1.1)
        color = look.color(*palette)
        rings = [np.column_stack([rectangle(x * s, y - x * (1 - s), 0.02 * x), np.full(20, z)])
                 for s, z in ((1.0, 0.0), (1.0, 0.06 * h), (0.88, 0.94 * h),
                              (0.86, h))]  # fmt: skip
        body = loft(np.stack(rings), rectangle(x, y, 0.02 * x))
        image = surfaces.fit(surfaces.brushed_metal(look.rng, color), 96, 192).copy()
        ink = tint_color(color, 0.6)
        prints.write(image, "999.9", 0.5, 0.36, 0.24, ink, bold=True)
        prints.write(image, look.pick(["FINE GOLD", "1 KILO",
                                       "100 g"]) if metal == "gold" else "FINE SILVER",
                     0.5, 0.7, 0.16, ink, bold=True)  # fmt: skip
        face = box(0.8 * x, y - 0.2 * x, 0.0004).move(z=h - 0.0002)
        return shape([(body, look.surface(color, metal)), (face, image)], [hull_of(body)])

    return make


def _note(look: Look, color: RGB, value: str) -> surfaces.Tile:
    """Return the texture of a banknote's face, which shows ``value``."""
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


@category("banknotes", size=(0.153, 0.0826, 0.0108), mass=0.02, material="paper", assembled=True,
          aliases=("money", "bank notes", "cash", "dollar bills", "dollar bill", "stack of money",
          "bundle of money", "bundle of banknotes", "dollars", "wad of cash", "euro notes",
          "stack of bills"), themes=("office", "living"), roles=("flat",), colors=("green",),
          state="lying flat")  # fmt: skip
def banknotes(look: Look) -> Shape:
    """A few fanned banknotes, or a bundle with a paper band."""
    x, y = look.between(0.14, 0.16), look.between(0.064, 0.074)
    color = look.color("green", "sage", "olive", "teal", "orange", "sky", "pink", "violet")
    value = look.pick(["5", "10", "20", "50", "100"])
    face = _note(look, color, value)
    if look.chance(0.5):
        h = look.between(0.009, 0.018)
        body = box(x, y, h)
        top = box(x, y, 0.0004).move(z=h - 0.0001)
        strip = box(0.032, y + 0.0014, h + 0.0012)
        band = surfaces.plain(look.own_color("white", "tan", "gold", "sky"))
        edge = prints.pages(look.rng, tint_color(color, 1.4))
        return shape([(body, edge), (top, face), (strip, band)], [box_part(x, y, h + 0.001)])
    pieces, notes = [], []
    count = int(look.rng.integers(2, 6))
    for k in range(count):
        turn = (k - (count - 1) / 2) * -0.16 + look.between(-0.03, 0.03)
        tile = (face if look.chance(0.6) else _note(look, look.own_color("green", "orange", "sky",
                                                                         "violet"),
                                                    "20"))  # fmt: skip
        note = box(x, y, 0.0009).move(x=0.3 * x).turn(2, turn).move(x=-0.3 * x, z=0.0009 * k)
        notes.append(note)
        pieces.append((note, tile))
    return shape(pieces, [hull_of(n) for n in notes])


@category("coins", size=(0.0742, 0.0532, 0.0141), mass=0.06, material="metal", assembled=True,
          aliases=("coin stack", "stack of coins", "change", "sixpence", "shilling",
          "bag of chocolate coins", "chocolate coin", "souvenir coin", "souvenir", "roll of coins"),
          themes=("office", "living"), roles=("flat",), colors=("gold", "silver"),
          state="lying flat", noun="pile of coins")  # fmt: skip
def coins(look: Look) -> Shape:
    """One or two small stacks of coins with a few coins beside them."""
    color = look.color("gold", "silver", "copper", "bronze", "gold", "silver")
    tones = [color, look.own_color("silver", "gold", "copper")]
    pieces: list[tuple[Solid, surfaces.Tile]] = []
    parts = []

    def face(tone: RGB) -> surfaces.Tile:
        image = prints.canvas(64, 64, tone)
        prints.disc(image, 0.5, 0.5, 0.48, tint_color(tone, 0.75), 0.42)
        prints.write(image, look.pick(["1", "2", "5", "10", "50"]), 0.5, 0.5, 0.4,
                     tint_color(tone, 0.55), bold=True)  # fmt: skip
        return image

    places = [(0.0, 0.0), (0.029, 0.004), (0.012, -0.027), (-0.02, -0.024), (0.042, -0.022)]
    for n in range(int(look.rng.integers(3, 6))):
        tone = tones[n % 2]
        r, t = look.between(0.0095, 0.0125), 0.0021
        high = int(look.rng.integers(3, 9)) if n < 2 else 1
        x, y = places[n]
        side = surfaces.stripes(
            [tint_color(tone, 0.6), tone, tone, tone], high, side=max(4 * high, 16)
        )
        coin = cylinder(r, t * high, 30).move(x, y)
        top = cylinder(0.97 * r, 0.0003, 28).move(x, y, t * high - 0.0001)
        pieces += [(coin, side), (top, face(tone))]
        parts.append(cylinder_part(r, t * high, (x, y, 0)))
    return shape(pieces, parts)


def _cheque(look: Look, image: prints.Canvas, accent: RGB) -> None:
    prints.write(image, "BANK", 0.16, 0.18, 0.15, accent, True)
    prints.fill(image, 0.08, 0.46, 0.6, 0.012, INK)
    prints.stroke(
        image, [(0.1 + 0.03 * k, 0.4 - 0.05 * (k % 2)) for k in range(14)], 0.02, (40, 60, 150)
    )
    prints.fill(image, 0.74, 0.34, 0.2, 0.18, (250, 250, 248))
    prints.write(image, "250.00", 0.84, 0.43, 0.12, INK)
    prints.fill(image, 0.08, 0.66, 0.5, 0.012, INK)
    prints.fill(image, 0.66, 0.76, 0.28, 0.012, INK)
    prints.stroke(
        image, [(0.68 + 0.025 * k, 0.72 - 0.06 * (k % 2)) for k in range(9)], 0.02, (40, 60, 150)
    )
    prints.fill(image, 0.08, 0.88, 0.6, 0.05, GRAY)


def _booklet(title: tuple[str, ...], *colors: str) -> Drawing:
    """Return the drawing function of a small booklet of slips between covers."""

    def draw(look: Look) -> Pieces:
        color = look.color(*colors)
        cover = prints.canvas(144, 72, color)
        ink = (250, 250, 246) if sum(color) < 420 else (34, 40, 60)
        prints.write(cover, look.pick(title), 0.5, 0.4, 0.2, ink, True)
        prints.fill(cover, 0.25, 0.66, 0.5, 0.03, ink)  # type: ignore[arg-type]
        return [(at_box(0.16, 0.075, 0.001), surfaces.plain(color)), (at_box(0.156, 0.073, 0.006,
                                                                             (0, 0, 0.001)),
                                                                      prints.pages(look.rng)),
                (at_box(0.16, 0.075, 0.001, (0, 0, 0.007)), cover), (at_box(0.02, 0.0755, 0.0084,
                                                                            (-0.0705, 0, 0)),
                                                                     dye(look, "charcoal", "navy",
                                                                         "maroon"))]  # fmt: skip

    return draw


CATEGORIES = (
    Category("coin", from_pieces()(_coin(0.0125, 0.002, 36, "gold", "silver", "copper", "brass")),
             size=(0.025, 0.025, 0.0022), mass=0.007, material="metal", aliases=("penny",
             "single coin", "euro coin", "gold coin", "silver coin", "nickel", "dime", "cent",
             "pence", "token coin", "pound coin", "sovereign", "loose coin", "copper coin",
             "ancient coin", "doubloon"), themes=("office",), roles=("flat", "round"),
             colors=("gold", "silver"), state="lying flat"),
    Category("silver_dollar", from_pieces()(_coin(0.019, 0.0028, 40, "silver")),
             size=(0.038, 0.038, 0.003), mass=0.026, material="metal", aliases=("quarter",
             "half dollar", "commemorative coin", "challenge coin", "large coin", "medallion",
             "silver medallion"), themes=("office",), roles=("flat", "round"), colors=("silver",),
             state="lying flat"),
    Category("fifty_pence_piece", from_pieces()(_coin(0.0137, 0.0018, 7, "silver")),
             size=(0.0265, 0.027, 0.002), mass=0.008, material="metal",
             aliases=("fifty pence", "pence piece", "50p coin", "seven sided coin"),
             themes=("office",), roles=("flat",), colors=("silver",), state="lying flat"),
    Category("gold_bar", _bar(("gold",), "gold", (0.1, 0.13)), size=(0.112, 0.0468, 0.0269),
             mass=4.0, material="metal",
             aliases=("ingot", "bar of gold", "bullion", "gold bullion"), themes=("office",),
             colors=("gold",)),
    Category("silver_bar", _bar(("silver",), "silver", (0.1, 0.13)), size=(0.114, 0.0483, 0.0282),
             mass=2.2, material="metal", aliases=("silver ingot", "bar of silver", "platinum bar"),
             themes=("office",), colors=("silver",)),
    Category("cheque", from_pieces(spread=0.06)(paper(0.17, 0.078, _cheque, "sky", "mint", "cream",
             "lavender")), size=(0.17, 0.078, 0.0011), mass=0.002, material="paper",
             aliases=("bank cheque", "paper cheque", "bank check", "paycheck", "money order"),
             themes=("office",), roles=("flat",), colors=("mint",), state="lying flat"),
    Category("chequebook",
             from_pieces(spread=0.06)(_booklet(("CHEQUES", "BANK"), "navy", "maroon", "green")),
             size=(0.16, 0.0755, 0.0084), mass=0.05, material="paper", aliases=("cheque book",
             "checkbook", "passbook", "savings book", "cheque book cover", "bank book",
             "ration book", "ticket book", "receipt book"), themes=("office",), roles=("flat",),
             colors=("navy",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
