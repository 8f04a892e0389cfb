"""Little houses, theatres, signs, gardens in a tray, fountains."""

from __future__ import annotations

import numpy as np

from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    of,
    shine,
    standing,
    wood,
)
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, rod, standing_plate, straight
from ...build.solids import join, tube
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ..rows import Rows

BLACK = textures.plain((34, 34, 37))


def _theatre(look: Look) -> Pieces:
    """A toy theatre: a frame with red curtains, a painted backdrop, a floor."""
    frame = wood(look, "gold", "brown", "wooden")
    floor = at_box(0.22, 0.14, 0.012)
    posts = [at_box(0.022, 0.014, 0.16, (s * 0.099, -0.05, 0.012)) for s in (-1, 1)]
    arch = standing_plate(
        [(-0.11, 0.172), (0.11, 0.172), (0.11, 0.185), (0, 0.215), (-0.11, 0.185)], 0.014, -0.05
    )
    drop = at_box(0.2, 0.006, 0.17, (0, 0.06, 0.012))
    art = textures.fit(prints.landscape(look.rng), 96, 128)
    folds = [
        disc(0.009, 0.155, (s * (0.082 - 0.013 * k), -0.04, 0.012), sides=10)
        for s in (-1, 1)
        for k in range(3)
    ]
    swag = [ball(0.06, 0.014, 0.03, (x, -0.045, 0.165), 12) for x in (-0.055, 0, 0.055)]
    actors = [
        standing((0.012, 0.012), (0.006, 0.04), (0.009, 0.052), (0.004, 0.06), sides=12).move(
            x, 0.01
        )
        for x in (-0.03, 0.03)
    ]
    return [
        (floor, frame),
        (posts[0], frame),
        (posts[1], frame),
        (arch, frame),
        (drop, art),
        (join(folds), red := dye(look, "crimson", "red", "maroon")),
        (join(swag), red),
        (actors[0], dye(look, "blue", "green")),
        (actors[1], dye(look, "yellow", "pink")),
    ]


def _sign(texts: tuple[str, ...], palette: tuple[str, ...], kind: str) -> Drawing:
    """A sign with a word: of wood on a foot, of tin lying, of letters on felt, of light."""

    def draw(look: Look) -> Pieces:
        text = look.pick(texts)
        if kind == "tin":
            color = look.color(*palette)
            image = prints.canvas(176, 120, color)
            ink = (
                tint_color(look.own_color("cream", "white"), 1.2)
                if sum(color) < 560
                else (60, 40, 34)
            )
            prints.fill(image, 0.03, 0.045, 0.94, 0.91, ink)
            prints.fill(image, 0.045, 0.065, 0.91, 0.87, color)
            prints.write(image, text, 0.5, 0.4, 0.3, ink, True)
            prints.fill(image, 0.2, 0.62, 0.6, 0.02, ink)
            prints.write(
                image,
                look.pick(["SINCE 1928", "BEST QUALITY", "OPEN DAILY"]),
                0.5,
                0.77,
                0.1,
                ink,
                True,
            )
            return [
                (at_block(0.3, 0.2, 0.003, 0.01), shine(look)),
                (at_block(0.298, 0.198, 0.0006, 0.01, (0, 0, 0.0028)), image),
            ]
        if kind == "board":
            image = prints.canvas(128, 128, look.color(*palette))
            for k in range(16):
                prints.fill(image, 0, k / 16, 1, 0.012, (20, 20, 22))
            for k, line in enumerate(text.split()):
                prints.write(image, line, 0.5, 0.28 + 0.2 * k, 0.13, (246, 246, 242), True)
            frame = wood(look, "wooden", "tan")
            body = at_box(0.25, 0.018, 0.25)
            face = at_box(0.226, 0.002, 0.226, (0, -0.009, 0.012))
            strut = [at_box(0.03, 0.07, 0.012, (s * 0.08, 0.02, 0)) for s in (-1, 1)]
            return [(body, frame), (strut[0], frame), (strut[1], frame), (face, image)]
        if kind == "neon":
            glow = textures.plain(tint_color(look.color(*palette), 1.35))
            base = at_box(0.2, 0.06, 0.014)
            back = at_box(0.2, 0.006, 0.12, (0, 0.012, 0.014))
            heart = look.chance(0.5)
            if heart:
                t = np.linspace(0, 2 * np.pi, 40)[:-1]
                path = np.column_stack(
                    [
                        0.0026 * 16 * np.sin(t) ** 3,
                        0 * t - 0.002,
                        0.072
                        + 0.0026
                        * (13 * np.cos(t) - 5 * np.cos(2 * t) - 2 * np.cos(3 * t) - np.cos(4 * t)),
                    ]
                )
                glows = [tube(path, 0.0045, 8, loop=True)]
            else:
                zig = [(-0.02, 0.12), (-0.045, 0.072), (-0.005, 0.072), (-0.03, 0.025)]
                glows = [
                    tube([(x + 0.025, -0.002, z + 0.004) for x, z in smooth(zig, 1)], 0.0045, 8)
                ]
                glows += [
                    tube([(x, -0.002, z) for x, z in ((-0.085, 0.03), (-0.085, 0.12))], 0.0035, 8),
                    tube([(x, -0.002, z) for x, z in ((0.085, 0.03), (0.085, 0.12))], 0.0035, 8),
                ]
            return [(base, BLACK), (back, BLACK), *((g, glow) for g in glows)]
        tile = wood(look, *palette)
        post = [at_box(0.1, 0.05, 0.014), at_box(0.014, 0.014, 0.12, (0, 0.004, 0.012))]
        board = at_box(0.19, 0.012, 0.075, (0, -0.008, 0.09))
        ground = look.own_color("cream", "wooden", "white", "teal")
        image = prints.canvas(160, 64, ground)
        prints.write(image, text, 0.5, 0.5, 0.42, (60, 40, 28), True)
        return [
            (post[0], tile),
            (post[1], tile),
            (board, tile),
            (at_box(0.176, 0.002, 0.062, (0, -0.0145, 0.0965)), image),
        ]

    return draw


def _zen(look: Look) -> Pieces:
    """A tray of raked sand with three stones and a little rake."""
    tile = wood(look, "brown", "black", "wooden")
    sides = [at_box(0.24, 0.012, 0.03, (0, s * 0.084, 0)) for s in (-1, 1)] + [
        at_box(0.012, 0.156, 0.03, (s * 0.114, 0, 0)) for s in (-1, 1)
    ]
    image = np.zeros((96, 128, 3))
    y, x = np.mgrid[0:96, 0:128].astype(float)
    wave = np.sin(np.minimum(np.hypot(x - 84, y - 40), 34) * 0.9 + 0.0 * y)
    far = np.hypot(x - 84, y - 40) > 32
    wave = np.where(far, np.sin(0.9 * y + 0.6 * np.sin(0.05 * x)), wave)
    image[:] = (230, 216, 186)
    image = np.clip(image + 15 * wave[..., None], 0, 255).astype(np.uint8)
    sand = at_box(0.217, 0.157, 0.02)
    stones = [
        ball(a, b, c, (px, py, 0.021), 12)
        for a, b, c, px, py in (
            (0.036, 0.03, 0.03, 0.035, 0.012),
            (0.022, 0.02, 0.018, 0.058, -0.006),
            (0.018, 0.022, 0.014, 0.026, -0.014),
        )
    ]
    rake = [
        straight((-0.09, -0.05, 0.024), (-0.02, -0.02, 0.03), 0.0025, 8),
        straight((-0.025, -0.004, 0.026), (-0.013, -0.034, 0.026), 0.0025, 8),
    ]
    return [
        *((s, tile) for s in sides),
        (sand, image),
        *(
            (s, textures.speckles(look.rng, c, 8))
            for s, c in zip(stones, ((70, 70, 74), (120, 116, 110), (96, 92, 90)), strict=True)
        ),
        (join(rake), dye(look, "wooden", "tan")),
    ]


def _fountain(look: Look) -> Pieces:
    """A tabletop fountain: bowls at steps, water running down, pebbles."""
    stone = look.surface(look.color("gray", "charcoal", "terracotta", "beige"), "stoneware")
    base = standing((0.07, 0), (0.09, 0.012), (0.092, 0.04), (0.084, 0.04), (0.08, 0.026), sides=30)
    water = [disc(0.081, 0.004, (0, 0, 0.028))]
    pieces: Pieces = [(base, stone)]
    tops = []
    for k, (x, y, z, r) in enumerate(
        ((0.025, 0.02, 0.075, 0.04), (-0.025, 0.01, 0.115, 0.034), (0.008, 0.025, 0.155, 0.028))
    ):
        stem = disc(0.014, z - 0.026, (x, y, 0.026), top=0.01)
        dish = standing(
            (0.3 * r, 0), (0.9 * r, 0.012), (r, 0.024), (0.9 * r, 0.024), (0.84 * r, 0.016)
        ).move(x, y, z)
        pieces += [(stem, stone), (dish, stone)]
        tops.append(disc(0.84 * r, 0.004, (x, y, z + 0.017)))
        drop = z - (0.04 if k else 0.045)
        tops.append(
            rod(
                [(x, y - 0.95 * r, z + 0.02), (x, y - 1.1 * r, z + 0.008), (x, y - 1.12 * r, drop)],
                0.004,
                8,
            )
        )
    rocks = [
        ball(0.022, 0.018, 0.014, (0.06 * np.cos(a), 0.06 * np.sin(a), 0.034), 8)
        for a in np.arange(7) * 0.9
    ]
    return [
        *pieces,
        (join([*water, *tops]), textures.plain((150, 204, 226))),
        (join(rocks), dye(look, "beige", "white", "gray")),
    ]


_row = Rows("living", ("red", "blue")).of_shape


CATEGORIES = (
    _row("toy_theatre", of(_theatre), (0.22, 0.14, 0.215), 0.5, ("toy theater", "puppet theatre",
             "puppet theater", "model theatre", "puppet stage"), ("gold",), ("big",)),
    _row("wooden_sign", of(_sign(("HOME", "WELCOME", "CAFE", "GARDEN"), ("wooden", "brown"),
             "wood")), (0.19, 0.05, 0.165), 0.2, (
             "desk sign", "name plate", "nameplate"), ("wooden",)),
    _row("tin_sign", of(_sign(("GARAGE", "COFFEE", "DINER", "ROUTE 7"), ("red", "navy", "green",
             "cream", "yellow"), "tin")), (0.3, 0.2, 0.0034), 0.3, ("enamel sign", "metal sign",
             "number plate", "license plate", "licence plate", "street sign", "road sign",
             "vintage sign"), ("red", "navy"), ("flat", "big")),
    _row("letterboard", of(_sign(("HELLO SUNNY DAY", "GOOD VIBES ONLY", "COFFEE FIRST PLEASE"),
             ("black", "charcoal"), "board")), (0.243, 0.0679, 0.243), 0.6, ("letter board",
             "message board", "felt board", "lightbox sign", "cinema lightbox"), ("black",),
             ("big", "tall")),
    _row("neon_sign", of(_sign(("",), ("pink", "cyan", "purple", "yellow", "red"), "neon")), (0.2,
             0.06, 0.136), 0.4, ("neon light", "led sign", "neon lamp"), ("pink",),
             ("big",)),
    vary(_row("zen_garden", of(_zen, bodies=5), (0.245, 0.184, 0.0368), 0.8, ("sand garden",
             "mini zen garden", "desktop zen garden", "japanese garden"), ("brown",), ("flat",
             "big"))),
    _row("tabletop_fountain", of(_fountain, bodies=7), (0.184, 0.184, 0.18), 1.5,
             ("water fountain", "fountain", "table fountain", "indoor fountain", "desk fountain"),
             ("gray",), ("big",)),
)  # fmt: skip
"""The module's categories."""
