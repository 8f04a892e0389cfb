"""Single coins and notes, bars of gold, clips, safes, and what counts money."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    hull_solid,
    metal,
    of,
    plastic,
    shine,
    standing,
)
from ...build.outlines import ellipse, lift, rectangle
from ...build.recipes import Pieces, rod, straight
from ...build.solids import join, lathe, prism, torus
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look


def _face(look: Look, color: RGB) -> textures.Tile:
    """The face of a coin: a rim, a head or a number."""
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
        edge = textures.stripes([tint_color(color, 0.75), tint_color(color, 1.1)], 32, upright=True)
        outline = ellipse(2 * r, 2 * r, sides)
        return [
            (prism(outline, 0, h, 0.0002), edge),
            (prism(0.94 * outline, h - 0.0002, h + 0.0002), face),
        ]

    return draw


def _note(look: Look) -> Pieces:
    """One banknote, slightly curved."""
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


def _ingot(look: Look) -> Pieces:
    """A bar of bullion with slanting sides, a stamp on its top."""
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


def _clip(look: Look) -> Pieces:
    """Folded notes in a metal clip."""
    steel = metal(look, "silver", "gold")
    color = look.own_color("green", "blue", "orange")
    notes = at_block(0.078, 0.064, 0.009, 0.004)
    clip = [at_block(0.058, 0.022, 0.0016, 0.004, (0.014, 0, z)) for z in (0.0, 0.0088)]
    bend = straight((0.044, -0.011, 0.0052), (0.044, 0.011, 0.0052), 0.0052, 12)
    return [
        (notes, textures.stripes([tint_color(color, 1.6), tint_color(color, 1.3)], 8)),
        (clip[1], steel),
        (join([clip[0], bend]), steel),
    ]


def _safe(look: Look) -> Pieces:
    """A small safe: a thick door with a dial and a handle."""
    tile = metal(look, "charcoal", "gray", "black", "green")
    body = at_block(0.22, 0.18, 0.2, 0.008)
    door = at_block(0.17, 0.15, 0.012, 0.006).turn(0, np.pi / 2).move(0, -0.089, 0.102)
    dial = [
        disc(0.024, 0.014).turn(0, np.pi / 2).move(-0.035, -0.1, 0.115),
        disc(0.008, 0.022).turn(0, np.pi / 2).move(-0.035, -0.1, 0.115),
    ]
    bars = [
        straight(
            (0.035 - 0.028 * np.cos(a), -0.112, 0.115 - 0.028 * np.sin(a)),
            (0.035 + 0.028 * np.cos(a), -0.112, 0.115 + 0.028 * np.sin(a)),
            0.004,
            8,
        )
        for a in (0.4, 0.4 + np.pi / 3, 0.4 + 2 * np.pi / 3)
    ]
    hub = disc(0.009, 0.02).turn(0, np.pi / 2).move(0.035, -0.098, 0.115)
    hinges = [
        straight((0.088, -0.094, z), (0.088, -0.094, z + 0.03), 0.007, 10) for z in (0.03, 0.14)
    ]
    return [
        (body, tile),
        (door, dye(look, "gray", "charcoal")),
        (dial[0], dye(look, "black")),
        (dial[1], shine(look)),
        (join([*bars, hub]), shine(look)),
        (join(hinges), shine(look)),
    ]


def _counter(look: Look) -> Pieces:
    """A machine that counts notes: a hopper with notes, a screen, a tray."""
    shell = plastic(look, "gray", "white", "charcoal")
    body = at_block(0.24, 0.2, 0.15, 0.02)
    hopper = at_box(0.18, 0.07, 0.03, (0, 0.04, 0.148))
    notes = at_box(0.15, 0.03, 0.05, (0, 0.035, 0.15)).turn(0, 0.0)
    screen = at_box(0.07, 0.002, 0.03, (-0.05, -0.1, 0.1))
    image = prints.canvas(64, 28, (24, 60, 48))
    prints.write(image, str(int(look.rng.integers(100, 999))), 0.5, 0.5, 0.7, (110, 240, 150), True)
    keys = [
        at_box(0.014, 0.003, 0.01, (0.03 + 0.022 * k, -0.1, 0.1 + 0.016 * n))
        for k in range(3)
        for n in range(2)
    ]
    slot = at_box(0.17, 0.004, 0.05, (0, -0.099, 0.02))
    color = look.own_color("green", "blue", "orange")
    return [
        (body, shell),
        (hopper, dye(look, "charcoal")),
        (
            notes,
            textures.stripes([tint_color(color, 1.6), tint_color(color, 1.2)], 10, upright=True),
        ),
        (screen, image),
        (join(keys), dye(look, "charcoal", "blue")),
        (slot, textures.plain((36, 36, 40))),
    ]


def _sorter(look: Look) -> Pieces:
    """A coin sorter: a bowl on top, tubes with stacked coins in front."""
    shell = plastic(look, "black", "charcoal", "blue", "gray")
    body = at_block(0.2, 0.12, 0.12, 0.02, (0, 0.03, 0))
    shelf = at_block(0.2, 0.07, 0.014, 0.01, (0, -0.05, 0))
    dish = lathe(
        [(0, 0), (0.07, 0), (0.09, 0.03), (0.085, 0.03), (0.065, 0.008), (0, 0.008)], 30
    ).move(0, 0.03, 0.118)
    stacks = []
    for k in range(5):
        x = -0.076 + 0.038 * k
        stacks.append(
            (
                disc(0.013 + 0.0012 * (k % 3), 0.03 + 0.012 * ((3 * k) % 5), (x, -0.055, 0.013)),
                ("gold", "silver", "copper", "silver", "gold")[k],
            )
        )
    loose = [
        disc(0.012, 0.003, (0.03 * np.cos(a), 0.03 + 0.03 * np.sin(a), 0.127 + 0.001 * n))
        for n, a in enumerate((0, 1.3, 2.5, 3.8, 5.0))
    ]
    return [
        (body, shell),
        (shelf, shell),
        (dish, dye(look, "gray")),
        *(
            (s, textures.stripes([tint_color(look.own_color(c), 0.8), look.own_color(c)], 8))
            for s, c in stacks
        ),
        (join(loose), shine(look, "gold", "silver")),
    ]


def _sack(look: Look) -> Pieces:
    """A sack tied at its neck, coins showing or a mark on its front."""
    color = look.color("tan", "brown", "beige")
    body = standing(
        (0.04, 0),
        (0.055, 0.012),
        (0.058, 0.04),
        (0.045, 0.075),
        (0.018, 0.095),
        (0.024, 0.112),
        (0.03, 0.118),
        sides=22,
    )
    tie = torus(0.0185, 0.005, 22, 8).move(z=0.094)
    mark = prints.canvas(64, 64, color)
    prints.write(mark, "$", 0.5, 0.5, 0.8, (60, 44, 30), True)
    badge = disc(0.022, 0.003).turn(0, np.pi / 2 - 0.25).move(0, -0.054, 0.046)
    coins = [
        disc(0.012, 0.002, (x, y, z))
        for x, y, z in (
            (0.065, -0.03, 0),
            (0.078, -0.012, 0),
            (0.07, -0.022, 0.002),
            (-0.07, -0.03, 0),
        )
    ]
    return [
        (body, textures.fabric(look.rng, color)),
        (tie, dye(look, "brown", "red")),
        (badge, mark),
        (join(coins), shine(look, "gold")),
    ]


def _pouch(look: Look) -> Pieces:
    color = look.color("brown", "tan", "maroon", "black", "purple")
    body = standing(
        (0.03, 0),
        (0.042, 0.01),
        (0.043, 0.03),
        (0.03, 0.052),
        (0.012, 0.062),
        (0.022, 0.078),
        sides=20,
    )
    cord = torus(0.0128, 0.0035, 20, 6).move(z=0.062)
    tails = [
        rod(
            [(0.012, s * 0.008, 0.062), (0.03, s * 0.012, 0.05), (0.045, s * 0.016, 0.025)],
            0.002,
            6,
        )
        for s in (-1, 1)
    ]
    return [
        (body, look.surface(color, "speckled")),
        (cord, dye(look, "beige", "gold")),
        (join(tails), dye(look, "beige", "gold")),
    ]


CATEGORIES = (
    Category("coin", of(_coin(0.0125, 0.002, 36, "gold", "silver", "copper", "brass")), (0.025,
             0.025, 0.0022), 0.007,
             ("penny", "single coin", "euro coin", "gold coin", "silver coin", "nickel", "dime",
             "cent", "pence", "token coin", "pound coin", "sovereign", "loose coin",
             "copper coin", "ancient coin", "doubloon"),
             ("office",), ("flat", "round"), ("gold", "silver"), state="lying flat"),
    Category("silver_dollar", of(_coin(0.019, 0.0028, 40, "silver")), (0.038, 0.038, 0.003),
             0.026, ("quarter", "half dollar", "commemorative coin", "challenge coin",
             "large coin", "medallion", "silver medallion"),
             ("office",), ("flat", "round"), ("silver",), state="lying flat"),
    Category("fifty_pence_piece", of(_coin(0.0137, 0.0018, 7, "silver")), (0.0265, 0.027, 0.002),
             0.008, ("fifty pence", "pence piece", "50p coin", "seven sided coin"), ("office",),
             ("flat",), ("silver",), state="lying flat"),
    Category("bank_note", of(_note, spread=0.06), (0.15, 0.07, 0.0011), 0.001, ("single banknote",
             "five pound note", "ten euro note", "pound note", "euro note", "paper note",
             "single note", "five euro note", "ten pound note", "loose banknote",
             "banknote"),
             ("office",), ("flat",), ("green", "blue"), state="lying flat"),
    Category("gold_ingot", of(_ingot), (0.115, 0.052, 0.032), 2.5, ("bullion bar",), ("office",),
             ("support",), ("gold",)),
    Category("money_clip", of(_clip), (0.089, 0.064, 0.0104), 0.05, ("clip of money",
             "notes in a clip"), ("office",), ("flat",), ("silver",)),
    Category("safe", of(_safe), (0.223, 0.215, 0.203), 6.0, ("mini safe",
             "small safe", "security box"), ("office",), ("big", "support"), ("charcoal",)),
    Category("note_counter", of(_counter), (0.24, 0.205, 0.2), 4.0, ("banknote counter",
             "money counter", "bill counter", "cash counter"), ("office",), ("big",), ("gray",)),
    Category("coin_sorter", of(_sorter), (0.201, 0.206, 0.149), 1.2, ("coin counter",
             "coin sorting machine", "coin machine"), ("office",), ("big",), ("black",)),
    Category("money_bag", of(_sack, bodies=1), (0.164, 0.114, 0.112), 0.6, ("sack of gold",
             "bag of money", "bag of gold", "sack of coins", "bag of coins", "sack of money",
             "swag bag"), ("office",), (), ("tan",)),
    Category("drawstring_pouch", of(_pouch, bodies=1), (0.09, 0.086, 0.078), 0.08,
             ("leather pouch", "coin pouch", "drawstring bag", "velvet pouch", "jewelry pouch",
             "jewellery pouch", "bag of marbles pouch"), ("vanity",), (), ("brown",)),
)  # fmt: skip
"""The module's categories."""
