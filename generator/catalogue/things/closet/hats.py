"""Hats and headwear of special kinds, wigs."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import drum, plate, standing
from ...build.outlines import smooth
from ...build.recipes import ball, put_down, rod
from ...build.shape import Shape
from ...build.solids import block, join, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def top_hat(look: Look) -> Shape:
    """A top hat with a silk band."""
    color = look.color("black", "gray", "navy", "maroon", "white")
    k = look.between(0.85, 1.1)
    brim = standing((0.085, 0.006), (0.125, 0.0), (0.13, 0.005), (0.09, 0.012), sides=32)
    brim = brim.scale(0.92, 1.05, 1)
    crown = standing((0.078, 0.004), (0.076, 0.06), (0.082, 0.13), (0.08, 0.136), sides=32).scale(
        0.95, 1.05, 1
    )
    band = standing((0.0795, 0.01), (0.0785, 0.036), sides=32).scale(0.955, 1.055, 1)
    return put_down(
        [
            (join([brim, crown]), textures.speckles(look.rng, color, 4)),
            (band, plain(look.own_color("maroon", "gray", "red", "white"))),
        ],
        brim,
        crown,
        factor=k,
    )


def bowler(look: Look) -> Shape:
    """A hat with a round crown and a rolled brim."""
    color = look.color("black", "brown", "gray", "charcoal")
    k = look.between(0.85, 1.1)
    crown = standing(
        (0.085, 0.006), (0.084, 0.05), (0.07, 0.085), (0.045, 0.105), (0.015, 0.112), sides=30
    )
    brim = standing(
        (0.08, 0.006), (0.11, 0.0), (0.122, 0.008), (0.115, 0.012), (0.085, 0.014), sides=30
    )
    rim = torus(0.119, 0.004, 32, 6).move(z=0.011)
    band = standing((0.0865, 0.012), (0.0858, 0.034), sides=30)
    felt = textures.speckles(look.rng, color, 5)
    whole = [one.scale(0.93, 1.07, 1) for one in (crown, brim, rim, band)]
    return put_down(
        [(join(whole[:2]), felt), (join(whole[2:]), plain(tint_color(color, 0.6)))],
        whole[0],
        whole[1],
        factor=k,
    )


def fez(look: Look) -> Shape:
    """A fez with a tassel."""
    color = look.color("crimson", "red", "maroon", "black")
    k = look.between(0.9, 1.1)
    body = standing((0.078, 0), (0.08, 0.004), (0.06, 0.115), (0.057, 0.118), sides=30)
    cord = tube(
        smooth(
            [(0, 0, 0.119), (0.04, -0.03, 0.122), (0.058, -0.042, 0.1), (0.062, -0.045, 0.075)], 5
        ),
        0.0022,
        6,
    )
    tuft = drum(0.009, 0.04, (0.065, -0.047, 0.035), top=0.005, sides=12)
    return put_down(
        [(body, textures.speckles(look.rng, color, 5)), (join([cord, tuft]), plain((36, 34, 36)))],
        body,
        tuft,
        factor=k,
    )


def mortarboard(look: Look) -> Shape:
    """A graduation cap: a flat square board on a skull cap, with a tassel."""
    color = look.color("black", "navy", "maroon", "green")
    k = look.between(0.85, 1.05)
    skull = standing((0.088, 0), (0.09, 0.02), (0.085, 0.06), sides=28)
    board = block(0.235, 0.235, 0.007, 0.004).turn(2, np.pi / 4).move(z=0.058)
    knob = ball(0.018, 0.018, 0.01, (0, 0, 0.066), 12)
    tone = look.own_color("gold", "gold", "white", "red")
    cord = rod(
        [(0, 0, 0.068), (0.06, -0.05, 0.068), (0.1, -0.084, 0.066), (0.106, -0.088, 0.04)],
        0.0022,
        6,
    )
    tuft = drum(0.009, 0.034, (0.106, -0.088, 0.01), top=0.005, sides=12)
    cloth = textures.speckles(look.rng, color, 4)
    return put_down(
        [(join([skull, board]), cloth), (join([knob, cord, tuft]), plain(tone))],
        skull,
        board,
        factor=k,
    )


def visor(look: Look) -> Shape:
    """A sun visor: a peak on a band, open above."""
    color = look.color("white", "red", "navy", "pink", "green", "yellow")
    k = look.between(0.9, 1.1)
    a = np.linspace(0, 2 * np.pi, 33)[:-1]
    path = np.column_stack([0.08 * np.cos(a), 0.09 * np.sin(a), 0.024 + 0 * a])
    band = tube(path, 0.0035, 8, squash=6, loop=True)
    b = np.linspace(-np.pi + 0.45, -0.45, 12)
    outer = np.column_stack([0.085 * np.cos(b), -0.02 + 0.135 * np.sin(b)])
    inner = np.column_stack([0.078 * np.cos(b), 0.088 * np.sin(b)])[::-1]
    peak = plate(np.concatenate([outer, inner]), 0.004, at=(0, 0, 0.003))
    peak = peak.bend(
        lambda p: np.column_stack(
            [p[:, :2], p[:, 2] + 0.022 * np.clip(1 - (p[:, 0] / 0.088) ** 2, 0, 1)]
        )
    )
    bits = [tube(np.roll(path, -4 * n, 0)[:6], 0.0035, 8, squash=6) for n in range(8)]
    return put_down(
        [(band, textures.fabric(look.rng, color)), (peak, plain(tint_color(color, 0.85)))],
        *bits,
        peak,
        factor=k,
    )


def wig(look: Look) -> Shape:
    """A wig standing: a cap of long wavy locks, parted."""
    color = look.color("brown", "black", "yellow", "orange", "pink", "gray", "red")
    k = look.between(0.85, 1.05)
    long = look.between(0.06, 0.12)
    cap = ball(0.15, 0.17, 0.14, (0, 0.005, long + 0.02), 22)
    cap = cap.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], long - 0.01)]))
    locks = []
    for n in range(17):
        a = -0.5 * np.pi + 0.5 + n * (2 * np.pi - 1.0) / 16
        x, y = float(np.cos(a)), float(np.sin(a))
        wave = 0.006 * (-1) ** n
        path = [
            (0.03 * x, 0.03 * y, long + 0.085),
            (0.066 * x, 0.075 * y, long + 0.055),
            (0.078 * x + wave, 0.088 * y, 0.6 * long),
            (0.08 * x - wave, 0.09 * y, 0.012),
        ]
        locks.append(rod(path, [0.006, 0.014, 0.015, 0.01], 7, 3))
    fringe = [
        rod(
            [
                (x, -0.02, long + 0.088),
                (1.2 * x, -0.07, long + 0.066),
                (1.25 * x, -0.083, long + 0.035),
            ],
            [0.008, 0.013, 0.005],
            7,
            3,
        )
        for x in (-0.045, -0.022, 0.0, 0.022, 0.045)
    ]
    hair = textures.stripes(
        [color, tint_color(color, 0.8), tint_color(color, 1.15)], 5, upright=True
    )
    return put_down([(join([cap, *locks, *fringe]), hair)], cap, join(locks), factor=k)


def flat_cap(look: Look) -> Shape:
    """A flat cap of checked cloth with a short peak."""
    color = look.color("gray", "brown", "tan", "charcoal", "olive", "navy")
    k = look.between(0.9, 1.1)
    body = ball(0.19, 0.21, 0.085, (0, 0.01, 0.028), 22)
    body = body.bend(
        lambda p: np.column_stack([p[:, :2], p[:, 2] - 0.12 * np.clip(-p[:, 1], 0, 0.1)])
    )
    peak = plate(
        [(-0.075, -0.06), (-0.06, -0.105), (0, -0.128), (0.06, -0.105), (0.075, -0.06)],
        0.006,
        at=(0, 0, 0.006),
    )
    band = standing((0.083, 0), (0.085, 0.02), sides=26).scale(0.95, 1.1, 1)
    knob = ball(0.014, 0.014, 0.008, (0, 0.012, 0.0705), 10)
    return put_down(
        [
            (join([body, knob]), textures.fabric(look.rng, color, tint_color(color, 1.35))),
            (join([peak, band]), plain(tint_color(color, 0.8))),
        ],
        body,
        band,
        peak,
        factor=k,
    )


def earmuffs(look: Look) -> Shape:
    """Fluffy earmuffs on a band, lying on their pads."""
    color = look.color("pink", "white", "gray", "brown", "red", "sky")
    k = look.between(0.85, 1.1)
    pads = [ball(0.038, 0.088, 0.085, (s * 0.075, 0, 0.041), 16) for s in (-1, 1)]
    a = np.linspace(0, np.pi, 15)
    band = tube(
        np.column_stack([0.077 * np.cos(a), 0 * a, 0.045 + 0.075 * np.sin(a)]), 0.007, 8, squash=0.5
    )
    fur = textures.scratches(look.rng, color, tint_color(color, 1.4), 140)
    return put_down(
        [(join(pads), fur), (band, plain(tint_color(color, 0.6)))], *pads, band, factor=k, foot=0.1
    )


CATEGORIES = (
    Category("top_hat", top_hat, (0.232, 0.264, 0.132), 0.15, ("topper", "magician's hat",
             "silk hat", "magician hat"),
             ("living",), ("big",), ("black",)),
    Category("bowler_hat", bowler, (0.224, 0.258, 0.11), 0.12, ("bowler", "derby hat", "derby"),
             ("living",), ("big",), ("black",)),
    Category("fez", fez, (0.159, 0.16, 0.125), 0.08, ("tarboosh", "fez hat"), ("living",),
             ("big",), ("crimson",)),
    Category("mortarboard", mortarboard, (0.322, 0.322, 0.0695), 0.15,
             ("graduation cap", "graduation hat", "academic cap", "square academic cap"),
             ("living",), ("big",), ("black",)),
    Category("sun_visor", visor, (0.173, 0.257, 0.0436), 0.06, ("tennis visor",
             "visor cap"), ("living",), ("big",), ("white",)),
    Category("wig", wig, (0.185, 0.186, 0.171), 0.2, ("toupee", "hairpiece", "clown wig",
             "fancy dress wig"),
             ("vanity",), ("big",), ("brown",)),
    Category("flat_cap", flat_cap, (0.192, 0.25, 0.0769), 0.1, ("tweed cap", "newsboy cap",
             "driving cap", "paperboy cap"),
             ("living",), ("big",), ("gray", "brown")),
    Category("earmuffs", earmuffs, (0.183, 0.0858, 0.124), 0.08, ("ear muffs", "pair of earmuffs",
             "ear warmer", "fluffy earmuffs"),
             ("living",), ("big",), ("pink", "white")),
)  # fmt: skip
"""The module's categories."""
