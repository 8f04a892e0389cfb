"""Small animals with scales, shells, fins or many legs."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.forms import blade
from ...build.recipes import ball
from ...build.settled import limb, settle
from ...build.shape import Shape
from ...build.solids import ellipsoid, join, lathe
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from .critters import eyes

DARK: RGB = (26, 24, 26)


def _shelled_animal(flippers: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a tortoise, or a turtle with flippers, looking to the left."""

    def make(look: Look) -> Shape:
        k, color = look.between(0.85, 1.2), look.color("olive", "green", "brown", "tan", "bronze")
        shell = ellipsoid(0.1, 0.082, 0.07 if not flippers else 0.05, 22, 14).move(z=0.018)
        y, x = np.mgrid[0:96, 0:144]
        cell = np.maximum(np.abs(np.sin(np.pi * x / 24)), 0) * np.abs(
            np.sin(np.pi * (y + 12 * ((x // 24) % 2)) / 24)
        )
        plates = np.where((cell < 0.22)[..., None], np.array(tint_color(color, 0.5)),
                          np.array(color) * (0.75 + 0.5 * cell[..., None]))  # fmt: skip
        skin: RGB = tint_color(look.own_color("olive", "sage", "tan"), 0.95)
        head = [limb([(-0.04, 0, 0.02), (-0.055, 0, 0.026), (-0.062, 0, 0.032)],
                     [0.011, 0.009, 0.009], 10),
                ball(0.026, 0.02, 0.019, (-0.067, 0, 0.034), 12)]  # fmt: skip
        feet = []
        for s in (-1, 1):
            for front in (-1, 1):
                if flippers:
                    reach = 0.075 if front < 0 else 0.055
                    feet.append(blade([(front * 0.028, s * 0.03, 0.013),
                                       (front * 0.034, s * 0.5 * (reach + 0.03), 0.012),
                                       (front * (0.02 if front < 0 else 0.05), s * reach, 0.006)],
                                      0.026, thick=0.3))  # fmt: skip
                else:
                    feet.append(limb([(front * 0.03, s * 0.028, 0.018),
                                      (front * 0.035, s * 0.036, 0.008),
                                      (front * 0.038, s * 0.038, 0.002)], [0.011, 0.01, 0.011],
                                      9))  # fmt: skip
        tail = limb([(0.044, 0, 0.014), (0.06, 0, 0.008)], [0.006, 0.001], 7)
        return settle([(shell, np.clip(plates, 0, 255).astype(np.uint8)),
                       (join([*head, *feet, tail]), textures.spots(look.rng, skin,
                           tint_color(skin, 0.75), 0.12)),
                       (eyes(-0.073, 0.0075, 0.038, 0.0045), textures.plain(DARK))],
                      0.03, hulls=[[0], [1]]).scale(k)  # fmt: skip

    return make


def _lizard(
    long: float, palette: tuple[str, ...], *, spotted: bool, fat: float
) -> Callable[[Look], Shape]:
    """Return the shape function of a lizard lying, its tail in a curve to the right."""

    def make(look: Look) -> Shape:
        k, color = long * look.between(0.88, 1.12), look.color(*palette)
        s = look.pick([-1, 1])
        spine = np.array([(-0.5, 0, 0.05), (-0.42, 0, 0.05), (-0.33, 0, 0.04), (-0.24, 0, 0.045),
                          (-0.1, 0.01 * s, 0.045),
                          (0.04, 0, 0.04), (0.18, 0.05 * s, 0.025), (0.34, 0.1 * s, 0.015),
                          (0.5, 0.0, 0.01)]) * k  # fmt: skip
        body = limb(
            spine,
            [k * r * fat for r in (0.008, 0.045, 0.03, 0.042, 0.048, 0.036, 0.028, 0.016, 0.002)],
            12,
            0.8,
        )
        legs = []
        for x in (-0.2, 0.03):
            for t in (-1, 1):
                legs.append(limb([(x * k, t * 0.03 * k, 0.04 * k), ((x - 0.02) * k, t * 0.1 * k,
                    0.045 * k),
                                  ((x - 0.05) * k, t * 0.13 * k, 0.008 * k)],
                                  [0.016 * k, 0.013 * k, 0.01 * k], 7))  # fmt: skip
                legs += [limb([((x - 0.05) * k, t * 0.13 * k, 0.006 * k),
                               ((x - 0.05 - 0.04 * np.cos(a)) * k,
                                t * (0.13 + 0.035 * np.sin(a)) * k, 0.005 * k)],
                              [0.006 * k, 0.006 * k], 5) for a in (-0.7, 0.1, 0.9)]  # fmt: skip
        hide = (textures.spots(look.rng, color, tint_color(color, 0.45), 0.16) if spotted else
                textures.stripes([color, color, tint_color(color, 0.75)], 8))  # fmt: skip
        return settle([(body, hide), (join(legs), textures.plain(tint_color(color, 0.9))),
                       (eyes(-0.43 * k, 0.03 * k * fat, 0.075 * k, 0.018 * k),
                        textures.plain(DARK))],
                      0.06, hulls=[[0], [1]])  # fmt: skip

    return make


def tarantula(look: Look) -> Shape:
    """A hairy spider: two round body halves, eight bent legs."""
    k, color = look.between(0.8, 1.2), look.color("brown", "black", "bronze", "maroon")
    back = ball(0.042, 0.034, 0.03, (0.03, 0, 0.02), 14)
    front = ball(0.028, 0.026, 0.018, (-0.004, 0, 0.018), 12)
    legs, bands = [], []
    for s in (-1, 1):
        for n, a in enumerate((-0.95, -0.35, 0.3, 0.9)):
            x, y = np.sin(a), np.cos(a)
            reach = 0.07 if n in (0, 3) else 0.062
            legs.append(limb([(0.01 * x - 0.004, s * 0.01, 0.018), (0.4 * reach * x,
                s * 0.45 * reach * y, 0.036),
                              (0.75 * reach * x, s * 0.8 * reach * y, 0.02),
                              (reach * x, s * reach * y, 0.002)],
                             [0.0042, 0.004, 0.0034, 0.002], 6))  # fmt: skip
            bands.append(
                ball(0.009, 0.009, 0.009, (0.4 * reach * x, s * 0.45 * reach * y, 0.036), 8)
            )
    fangs = [
        limb([(-0.016, s * 0.005, 0.016), (-0.024, s * 0.005, 0.006)], [0.004, 0.002], 6)
        for s in (-1, 1)
    ]
    hair = textures.scratches(look.rng, color, tint_color(color, 1.35), 220)
    return settle([(join([back, front, *legs, *fangs]), hair), (join(bands),
        textures.plain(tint_color(color, 1.4))),
                   (eyes(-0.015, 0.003, 0.025, 0.003), textures.plain(DARK))], 0.04,
                   hulls=[[0]]).scale(k)  # fmt: skip


def stick_insect(look: Look) -> Shape:
    """A stick insect: a twig-thin body on six long thin legs."""
    k, color = look.between(0.85, 1.2), look.color("brown", "green", "tan", "olive")
    body = limb(
        [(-0.06, 0, 0.02), (-0.03, 0, 0.021), (0.02, 0, 0.021), (0.06, 0, 0.018)],
        [0.0022, 0.0026, 0.003, 0.0012],
        8,
    )
    legs = [limb([(x, 0, 0.02), (x + 0.4 * dx, s * 0.025, 0.03), (x + dx, s * 0.05, 0.001)],
                 [0.0014, 0.0012, 0.001], 5)
            for x, dx in ((-0.035, -0.04), (-0.01, 0.01), (0.012, 0.045)) for s in (-1,
                1)]  # fmt: skip
    horns = [
        limb([(-0.06, 0, 0.021), (-0.1, s * 0.012, 0.028)], [0.0007, 0.0004], 4) for s in (-1, 1)
    ]
    bark = textures.stripes([color, color, tint_color(color, 0.75)], 9)
    return settle(
        [(join([body, *legs]), bark), (join(horns), textures.plain(color))], 0.02, hulls=[[0]]
    ).scale(k)


def goldfish(look: Look) -> Shape:
    """A goldfish lying on its side: round body, flowing tail and fins."""
    k, color = (
        look.between(0.85, 1.2),
        look.color("orange", "orange", "gold", "coral", "red", "white"),
    )
    body = lathe(
        [
            (0, 0),
            (0.008, 0.004),
            (0.016, 0.02),
            (0.0155, 0.034),
            (0.008, 0.05),
            (0.004, 0.056),
            (0, 0.057),
        ],
        18,
    )
    body = body.turn(1, np.pi / 2).scale(1, 1.15, 0.75).move(-0.03, 0, 0.012)
    fins = [
        blade(
            [(0.022, 0, 0.012), (0.04, s * 0.014, 0.008), (0.062, s * 0.026, 0.002)],
            0.024,
            thick=0.12,
        )
        for s in (-1, 0.15, 1)
    ]
    fins += [blade([(-0.006, 0.014, 0.012), (0.006, 0.026, 0.01), (0.02, 0.026, 0.008)], 0.02,
                   thick=0.14),
             blade([(0.0, -0.014, 0.012), (0.01, -0.024, 0.009), (0.018, -0.026, 0.006)], 0.014,
                   thick=0.14),
             blade([(-0.008, -0.004, 0.023), (0.004, -0.008, 0.024), (0.012, -0.012, 0.021)],
                   0.012, thick=0.2)]  # fmt: skip
    y, x = np.mgrid[0:64, 0:96]
    scale = 0.82 + 0.22 * np.abs(np.sin(np.pi * (x / 8 + 0.5 * ((y // 8) % 2)))) * np.abs(
        np.sin(np.pi * y / 8)
    )
    scales = np.clip(np.array(color) * scale[..., None], 0, 255).astype(np.uint8)
    eye = [ball(0.0065, 0.0065, 0.004, (-0.021, 0.006, 0.019), 8)]
    white = [ball(0.009, 0.009, 0.003, (-0.021, 0.006, 0.0185), 10)]
    return settle([(body, scales), (join(fins), textures.stripes([color, tint_color(color, 1.35)],
        6)),
                   (join(white), textures.plain((248, 244, 226))), (join(eye),
                       textures.plain(DARK))],
                  0.08, hulls=[[0], [1]]).scale(k)  # fmt: skip


_P = ("living",)

CATEGORIES = (
    Category("tortoise", _shelled_animal(False), (0.137, 0.0948, 0.0662), 0.3,
             ("toy tortoise", "tortoise figurine", "terrapin"), _P, (), ("olive",)),
    Category("turtle", _shelled_animal(True), (0.152, 0.163, 0.053), 0.3, ("sea turtle",
             "toy turtle",
        "turtle figurine"), _P, (), ("green",)),
    Category("gecko", _lizard(0.17, ("yellow", "amber", "tan", "lime"), spotted=True, fat=1.15),
             (0.174, 0.0561, 0.0151), 0.05,
             ("leopard gecko", "salamander", "newt"), _P, (), ("yellow",), state="lying"),
    Category("lizard", _lizard(0.24, ("green", "brown", "olive", "teal"), spotted=False, fat=0.9),
             (0.235, 0.0757, 0.0187), 0.08,
             ("toy lizard", "bearded dragon", "chameleon", "iguana", "rubber lizard"), _P, (),
             ("green",), state="lying"),
    Category("tarantula", tarantula, (0.113, 0.12, 0.0376), 0.05, ("pet spider",), _P, (), ("brown",
             )),
    Category("stick_insect", stick_insect, (0.166, 0.106, 0.0317), 0.005,
             ("walking stick insect", "praying mantis"), _P, (), ("brown",)),
    Category("goldfish", goldfish, (0.0872, 0.0598, 0.0214), 0.04, ("gold fish", "koi",
                 "toy goldfish"), _P, (), ("orange",),
             state="lying on its side"),
)  # fmt: skip
"""The module's categories."""
