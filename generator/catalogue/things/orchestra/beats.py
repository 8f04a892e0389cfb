"""Drums, gongs, bells and shakers, and the small things players use."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import (
    Drawing,
    at_block,
    at_box,
    disc,
    dye,
    metal,
    of,
    plastic,
    shine,
    standing,
    wood,
)
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

HIDE = textures.plain((232, 216, 184))


def _shell(profile: list[tuple[float, float]], *palette: str) -> Drawing:
    """A standing drum: a turned body, a skin, hoops and ropes."""

    def draw(look: Look) -> Pieces:
        tile = wood(look, *palette)
        r, top = profile[-1]
        body = standing(*profile)
        head = disc(0.97 * r, 0.002, (0, 0, top))
        hoops = [torus(r * 1.01, 0.004, 32, 6).move(z=top - d) for d in (0.004, 0.02)]
        low = profile[len(profile) // 2]
        cords = []
        for k in range(16):
            a, b = k * np.pi / 8, (k + 0.5) * np.pi / 8
            cords += [
                straight(
                    (1.01 * r * np.cos(c), 1.01 * r * np.sin(c), top - 0.02),
                    ((low[0] + 0.001) * np.cos(b), (low[0] + 0.001) * np.sin(b), low[1]),
                    0.0014,
                    4,
                )
                for c in (a, b)
            ]
        return [(body, tile), (join(hoops), dye(look, "black", "red", "brown")), (head, HIDE),
                (join(cords), textures.plain((226, 214, 186)))]  # fmt: skip

    return draw


def _bongo(look: Look) -> Pieces:
    tile = wood(look, "brown", "wooden", "red", "maroon")
    pieces: Pieces = []
    rims, heads = [], []
    for x, r in ((-0.072, 0.062), (0.068, 0.072)):
        pieces.append((disc(0.86 * r, 0.12, (x, 0, 0), top=r), tile))
        heads.append(disc(0.95 * r, 0.002, (x, 0, 0.12)))
        rims += [torus(r, 0.005, 32, 6).move(x, 0, z) for z in (0.116, 0.09)]
        rims += [straight((x + r * np.cos(a), r * np.sin(a), 0.115),
                          (x + 0.95 * r * np.cos(a), 0.95 * r * np.sin(a), 0.04), 0.003, 6)
                 for a in np.arange(5) * 1.257]  # fmt: skip
    bar = at_box(0.06, 0.04, 0.04, (0, 0, 0.05))
    return [*pieces, (bar, tile), (join(rims), shine(look)), (join(heads), HIDE)]


def _cowbell(look: Look) -> Pieces:
    tile = metal(look, "black", "silver", "copper", "brass")
    body = at_box(0.06, 0.035, 0.11).bend(
        lambda p: p * np.column_stack([1.25 - 4.5 * p[:, 2], 1.25 - 4.5 * p[:, 2],
             np.ones(len(p))]))  # fmt: skip
    loop = torus(0.014, 0.003, 20, 6).turn(0, np.pi / 2).move(z=0.118)
    return [(body, tile), (loop, tile)]


def _castanet(look: Look) -> Pieces:
    tile = wood(look, "black", "brown", "maroon", "wooden")
    shells = [ball(0.062, 0.07, 0.026, (0, 0, 0.01), 20),
              ball(0.062, 0.07, 0.02, (0, 0, 0), 20).turn(0, 0.22).move(z=0.028)]  # fmt: skip
    cord = rod(
        [(-0.012, 0.036, 0.016), (0, 0.05, 0.012), (0.014, 0.036, 0.02), (0.03, 0.055, 0.003)],
        0.0018,
        6,
    )
    return [(shells[0], tile), (shells[1], tile), (cord, dye(look, "red"))]


def _gong(look: Look) -> Pieces:
    """A bronze gong hung in a wooden frame, its beater against it."""
    bronze = metal(look, "bronze", "brass", "gold")
    tile = wood(look, "brown", "black", "maroon")
    feet = [at_block(0.02, 0.09, 0.014, 0.004, (s * 0.1, 0, 0)) for s in (-1, 1)]
    posts = [at_box(0.014, 0.014, 0.2, (s * 0.1, 0, 0.012)) for s in (-1, 1)]
    beam = at_box(0.25, 0.016, 0.014, (0, 0, 0.208))
    low = at_box(0.19, 0.012, 0.012, (0, 0, 0.016))
    plate = standing(
        (0.07, 0), (0.075, 0.004), (0.078, 0.012), (0.02, 0.014), (0.018, 0.02), sides=36
    )
    plate = plate.turn(0, np.pi / 2).move(0, 0.006, 0.12)
    cords = [straight((s * 0.03, 0, 0.185), (s * 0.03, 0, 0.21), 0.0018, 6) for s in (-1, 1)]
    return [*((s, tile) for s in (*feet, *posts, beam, low)), (plate, bronze),
            (join(cords), dye(look, "red", "cream"))]  # fmt: skip


def _kalimba(look: Look) -> Pieces:
    """A thumb piano: a wooden box with metal tongues over a hole."""
    tile = wood(look, "wooden", "brown", "tan", "maroon")
    body = at_block(0.13, 0.175, 0.034, 0.02)
    hole = disc(0.014, 0.001, (0, -0.03, 0.0336))
    tines = []
    for k in range(17):
        x = 0.0066 * (k - 8)
        long = 0.095 - 0.0048 * abs(k - 8)
        tines.append(at_box(0.0048, long, 0.0014, (x, 0.07 - long / 2, 0.04)))
    bars = [
        straight((-0.06, y, z), (0.06, y, z), 0.0035, 8)
        for y, z in ((0.052, 0.0375), (0.04, 0.0425), (0.03, 0.0375))
    ]
    return [(body, tile), (join(tines), shine(look)), (join(bars), shine(look, "gold", "silver")),
            (hole, textures.plain((30, 24, 20)))]  # fmt: skip


def _capo(look: Look) -> Pieces:
    tile = metal(look, "black", "silver", "gold", "red")
    bar = at_block(0.07, 0.012, 0.008, 0.003, (0.01, 0.02, 0.004))
    under = at_block(0.055, 0.012, 0.007, 0.003, (0.012, -0.012, 0.004))
    arm = rod(
        [(-0.02, 0.02, 0.008), (-0.035, 0.0, 0.008), (-0.03, -0.03, 0.008), (0.01, -0.05, 0.008)],
        0.0055,
        8,
    )
    arm2 = rod([(-0.02, -0.012, 0.008), (-0.028, 0.012, 0.008), (-0.06, 0.03, 0.008)], 0.0055, 8)
    pad = at_block(0.06, 0.006, 0.0085, 0.002, (0.012, 0.012, 0.004))
    return [(s, tile) for s in (bar, under, arm, arm2)] + [(pad, dye(look, "black", "gray"))]


def _rosin(look: Look) -> Pieces:
    cloth = dye(look, "navy", "maroon", "green")
    pad = at_block(0.06, 0.06, 0.01, 0.012)
    cake = disc(0.024, 0.014, (0, 0, 0.009))
    color = look.color("amber", "brown", "orange")
    return [
        (pad, cloth),
        (cake, textures.gradient(color, tint_color(color, 1.3), look.rng)),
    ]  # type: ignore[arg-type]


def _tuner(look: Look) -> Pieces:
    """A clip-on tuner: a round screen on a joint over a padded clip."""
    tile = plastic(look, "black", "charcoal", "red", "blue")
    jaw = [
        at_block(0.05, 0.02, 0.006, 0.003),
        at_block(0.046, 0.02, 0.006, 0.003, (0.002, 0, 0.012)),
    ]
    hinge = disc(0.006, 0.02, (-0.018, 0, 0), sides=16)
    neck = straight((-0.012, 0, 0.018), (-0.008, 0, 0.03), 0.005)
    body = at_block(0.042, 0.028, 0.009, 0.01).turn(0, 0.9).move(-0.006, 0.006, 0.036)
    image = prints.canvas(64, 44, (20, 26, 34))
    for k in range(7):
        prints.fill(
            image, 0.12 + 0.115 * k, 0.15, 0.04, 0.2, (70, 210, 110) if k == 3 else (220, 120, 60)
        )
    prints.write(image, look.pick(["A", "E", "G", "D"]), 0.5, 0.66, 0.42, (90, 230, 130), True)
    face = at_box(0.036, 0.022, 0.001, (0, 0, 0.0087)).turn(0, 0.9).move(-0.006, 0.006, 0.036)
    return [*((j, tile) for j in jaw), (hinge, tile), (neck, tile), (body, tile), (face, image)]


CATEGORIES = (
    Category("djembe", of(_shell([(0.05, 0), (0.036, 0.06), (0.034, 0.1), (0.075, 0.17), (0.08,
             0.24)],
             "brown", "wooden", "maroon"), bodies=2), (0.17, 0.17, 0.242), 1.2, ("goblet drum",
             "darbuka", "african drum", "doumbek"), ("living",), ("tall", "big"), ("brown",)),
    Category("tabla", of(_shell([(0.05, 0), (0.08, 0.03), (0.085, 0.07), (0.078, 0.13)], "brown",
             "copper", "silver"), bodies=2), (0.17, 0.17, 0.132), 1.0, ("indian drum",),
             ("living",),
             ("support",), ("brown",)),
    Category("conga", of(_shell([(0.05, 0), (0.065, 0.08), (0.074, 0.17), (0.066, 0.28)], "red",
             "wooden", "brown"), bodies=2), (0.148, 0.148, 0.282), 1.5, ("conga drum",
             "timpani", "bass drum", "tall drum"), ("living",), ("tall",), ("red",)),
    Category("bongos", of(_bongo, bodies=3), (0.275, 0.155, 0.122), 1.2, ("bongo", "bongo drum",
             "pair of bongos", "set of bongos"), ("living",), ("big",), ("brown",)),
    Category("cowbell", of(_cowbell), (0.075, 0.044, 0.135), 0.3, ("cow bell", "agogo bell"),
             ("living",), (), ("black",)),
    Category("castanets", of(_castanet, 0.04, bodies=2), (0.0621, 0.0908, 0.0402), 0.05,
             ("castanet",
             "pair of castanets"), ("living",), (), ("black",), state="lying"),
    Category("gong", of(_gong), (0.25, 0.09, 0.222), 0.9, ("table gong", "desk gong", "tam tam",
             "dinner gong"), ("living",), ("tall",), ("bronze",)),
    Category("kalimba", of(_kalimba, bodies=1), (0.13, 0.175, 0.047), 0.35, ("thumb piano",
             "mbira"), ("living",), ("flat",), ("wooden",)),
    Category("capo", of(_capo), (0.107, 0.0892, 0.0109), 0.04, ("guitar capo",), ("living",),
             ("flat",), ("black",), state="lying"),
    Category("rosin", of(_rosin), (0.06, 0.06, 0.023), 0.03, ("violin rosin", "block of rosin",
             "rosin cake", "colophony"), ("living",), (), ("amber",)),
    Category("guitar_tuner", of(_tuner), (0.0501, 0.0227, 0.0496), 0.03, ("clip on tuner", "tuner",
             "chromatic tuner", "instrument tuner"), ("living",), (), ("black",)),
)  # fmt: skip
"""The module's categories."""
