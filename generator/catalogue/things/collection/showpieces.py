"""Flags, tiles, dry grass, dishes to show."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    PAINTS,
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    hull_solid,
    metal,
    of,
    plastic,
    plate,
    spindle,
    standing,
    wood,
)
from ...build.outlines import rectangle
from ...build.recipes import Pieces, ball, open_vessel, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, join, lathe, prism
from ...surfaces import glazes, prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows


def _tank(look: Look) -> Pieces:
    """A model tank: tracks, a hull, a turret with a gun."""
    tile = plastic(look, "olive", "sage", "tan", "gray")
    tracks = [at_block(0.15, 0.026, 0.036, 0.008).move(y=s * 0.036) for s in (-1, 1)]
    wheels = [
        disc(0.011, 0.003).turn(0, np.pi / 2).move(x, -0.0485 if s < 0 else 0.0515, 0.015)
        for s in (-1, 1)
        for x in np.linspace(-0.055, 0.055, 5)
    ]
    hull = hull_solid(
        [
            (x, y, z)
            for y in (-0.042, 0.042)
            for x, z in (
                (-0.075, 0.03),
                (-0.07, 0.05),
                (0.045, 0.05),
                (0.08, 0.034),
                (0.075, 0.02),
                (-0.07, 0.02),
            )
        ]
    )
    turret = hull_solid(
        [
            (x, y, z)
            for x, y, z in (
                (-0.045, -0.03, 0.05),
                (-0.045, 0.03, 0.05),
                (0.03, -0.024, 0.05),
                (0.03, 0.024, 0.05),
                (-0.04, -0.024, 0.074),
                (-0.04, 0.024, 0.074),
                (0.012, -0.018, 0.074),
                (0.012, 0.018, 0.074),
            )
        ]
    )
    barrel = straight((0.015, 0, 0.063), (0.12, 0, 0.066), 0.0045, 10)
    hatch = disc(0.012, 0.005, (-0.018, 0.005, 0.0735))
    return [
        (tracks[0], dye(look, "charcoal")),
        (tracks[1], dye(look, "charcoal")),
        (hull, tile),
        (turret, tile),
        (barrel, tile),
        (hatch, tile),
        (join(wheels), dye(look, "olive", "gray")),
    ]


def _casing(look: Look) -> Pieces:
    brass = metal(look, "brass", "gold", "copper")
    body = lathe(
        [
            (0, 0),
            (0.006, 0),
            (0.006, 0.002),
            (0.0052, 0.003),
            (0.0058, 0.004),
            (0.0056, 0.036),
            (0.0042, 0.042),
            (0.0042, 0.05),
            (0.0036, 0.05),
            (0.0036, 0.03),
            (0, 0.03),
        ],
        20,
    )
    return [(body, brass)]


def _flag() -> Drawing:
    def draw(look: Look) -> Pieces:
        """A small flag on a pole in a round foot."""
        tones = [
            look.color(*PAINTS, "white"),
            look.own_color("white", "yellow"),
            look.own_color(*PAINTS),
        ]
        cloth = textures.stripes(tones, 1, upright=look.chance(0.5))
        foot = disc(0.03, 0.012, sides=28)
        pole = straight((0, 0, 0.01), (0, 0, 0.24), 0.0022, 8)
        tip = ball(0.008, 0.008, 0.008, (0, 0, 0.242), 10)
        x = np.linspace(0.001, 0.12, 14)
        wave = 0.005 * np.sin(x * 90)
        front = np.column_stack([x, wave - 0.0006])
        rear = np.column_stack([x, wave + 0.0006])[::-1]
        banner = prism(np.concatenate([front, rear]), 0.155, 0.232)
        image = textures.fit(cloth, 64, 64)
        uv = np.column_stack(
            [(banner.vertices[:, 0] - x[0]) / np.ptp(x), (banner.vertices[:, 2] - 0.155) / 0.077]
        )
        banner = Solid(banner.vertices, banner.faces, np.clip(uv, 0, 1))
        return [
            (foot, dye(look, "black", "wooden", "gold")),
            (pole, dye(look, "gold", "silver", "wooden")),
            (banner, image),
            (tip, dye(look, "gold")),
        ]

    return draw


def _pirate(look: Look) -> Pieces:
    image = prints.canvas(96, 64, (26, 26, 28))
    prints.disc(image, 0.5, 0.4, 0.2, (244, 242, 236))
    prints.fill(image, 0.43, 0.5, 0.14, 0.16, (244, 242, 236))
    for s in (-1, 1):
        prints.disc(image, 0.5 + 0.055 * s, 0.4, 0.05, (26, 26, 28))
        prints.stroke(image, [(0.5 - 0.24 * s, 0.68), (0.5 + 0.24 * s, 0.9)], 0.06, (244, 242, 236))
    pole = spindle((-0.15, 0.004), (0.11, 0.004)).turn(2, np.pi / 2)
    return [
        (pole.move(x=-0.1), wood(look, "brown", "wooden")),
        (at_box(0.18, 0.12, 0.0014, (-0.006, 0.046, 0.0)), image),
    ]


def _tile(sides: int) -> Drawing:
    def draw(look: Look) -> Pieces:
        """A glazed tile with a pattern."""
        color = look.color("white", "blue", "teal", "terracotta", "cream", "green", "mustard")
        image = glazes.glaze_tile(look, color)
        image = textures.fit(image, 96, 96).copy()
        other = look.own_color("navy", "white", "mustard", "teal", "terracotta")
        for k in range(4):
            a = k * np.pi / 2
            prints.disc(image, 0.5 + 0.28 * np.cos(a), 0.5 + 0.28 * np.sin(a), 0.12, other)
        prints.disc(image, 0.5, 0.5, 0.14, tint_color(other, 1.3))
        if sides == 4:
            outline = rectangle(0.1, 0.1)
        else:
            a = np.arange(sides) * 2 * np.pi / sides + np.pi / 2
            outline = 0.056 * np.column_stack([np.cos(a), np.sin(a)])
        return [
            (plate(outline, 0.008), textures.plain(tint_color(color, 0.8))),
            (plate(0.985 * outline, 0.0006, 0.0077), image),
        ]

    return draw


def _pampas(look: Look) -> Pieces:
    """A vase with feathery grass."""
    color = look.color("cream", "beige", "pink", "tan")
    pot = standing((0.03, 0), (0.045, 0.03), (0.04, 0.08), (0.02, 0.115), (0.024, 0.13))
    stems, plumes = [], []
    for k in range(6):
        a = 1.05 * k
        tip = np.array([0.055 * np.cos(a), 0.055 * np.sin(a), 0.27 + 0.02 * (k % 3)])
        stems.append(rod([(0, 0, 0.12), (0.5 * tip[0], 0.5 * tip[1], 0.2), tuple(tip)], 0.0016, 5))
        plumes.append(
            rod(
                [
                    tuple(tip - [0.3 * tip[0], 0.3 * tip[1], 0.05]),
                    tuple(tip),
                    tuple(np.add(tip, (0.45 * tip[0], 0.45 * tip[1], 0.055))),
                ],
                [0.009, 0.016, 0.003],
                8,
            )
        )
    fluff = textures.scratches(look.rng, color, tint_color(color, 0.8), 200)
    return [
        (pot, glazes.glaze_tile(look, look.own_color("white", "gray", "terracotta", "charcoal"))),
        (join(plumes), fluff),
        (join(stems), dye(look, "tan")),
    ]


def _cradle_dish(look: Look) -> Shape:
    """A metal dish for wafers, shallow with a rim."""
    tile = metal(look, "gold", "gold", "silver")
    side = [(0.05, 0.0), (0.07, 0.006), (0.085, 0.012)]
    body, parts = open_vessel(side, 0.0025, 0.003)
    return shape([(body, tile)], parts).scale(look.between(0.9, 1.1))


_row = Rows("living", ("red", "blue")).of_shape


CATEGORIES = (
    _row("model_tank", of(_tank, bodies=6), (0.2, 0.1, 0.078), 0.3, ("toy tank", "army tank",
             "panzer", "battle tank", "military tank"), ("olive",)),
    _row("bullet_casing", of(_casing), (0.012, 0.012, 0.05), 0.008, ("bullet", "cartridge case",
             "shell casing", "bullet shell", "bullet cartridge", "rifle cartridge"), ("brass",)),
    _row("table_flag", of(_flag(), bodies=3), (0.15, 0.06, 0.246), 0.08, ("flag", "small flag",
             "desk flag", "mini flag", "national flag", "country flag", "flag on a stand",
             "toy flag"), ("red", "blue"), ("tall",)),
    _row("pirate_flag", of(_pirate, 0.1), (0.181, 0.25, 0.00769), 0.03, ("jolly roger",
             "skull and crossbones flag"), ("brown",), ("flat",)),
    _row("ceramic_tile", of(_tile(4)), (0.1, 0.1, 0.0083), 0.18, ("square tile",
             "bathroom tile", "floor tile", "glazed tile", "azulejo",
             "kitchen tile"), ("white", "blue"), ("flat", "support")),
    _row("hexagonal_tile", of(_tile(6)), (0.097, 0.112, 0.0083), 0.15, (), ("teal",), ("flat",
             "support")),
    _row("triangular_tile", of(_tile(3)), (0.097, 0.084, 0.0083), 0.09, ("triangle tile",),
             ("terracotta",), ("flat", "support")),
    _row("pampas_grass", of(_pampas, bodies=2), (0.167, 0.146, 0.37), 0.5, ("dried pampas grass",
             "vase of pampas grass", "dried grass bouquet", "pampas grass in a vase"),
             ("cream",), ("tall", "big")),
    _row("paten", _cradle_dish, (0.17, 0.17, 0.012), 0.2, ("communion plate", "gold plate",
             "golden plate", "golden dish", "offering plate"), ("gold",), ("container", "flat")),
)  # fmt: skip
"""The module's categories."""
