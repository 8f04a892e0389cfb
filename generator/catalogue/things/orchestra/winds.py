"""Wind instruments: bent brass tubes, wooden pipes, bellows, whistles."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import (
    at_block,
    at_box,
    disc,
    dye,
    metal,
    of,
    shine,
    spindle,
    wood,
)
from ...build.outlines import arc, smooth
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import Solid, join, lathe, torus, tube
from ...build.variants import at_rest
from ...surfaces import textures
from ...surfaces.look import Look

BRASSY = ("gold", "gold", "brass", "silver")


def _bell(x: float, y: float, z: float, r: float, long: float) -> Solid:
    """A flared bell opening towards +x from ``x``."""
    outer = [(0.0065, 0), (0.009, 0.5 * long), (0.4 * r, 0.8 * long), (r, long)]
    inner = [(0.96 * r, long), (0.36 * r, 0.8 * long), (0.006, 0.4 * long)]
    return lathe([*outer, *inner], 24, loop=True).turn(1, np.pi / 2).move(x, y, z)


def _trombone(look: Look) -> Pieces:
    """A trombone lying: a long slide, a bow, a wide bell."""
    tile = metal(look, *BRASSY)
    z, r = 0.055, 0.0055
    slide = [straight((-0.1, y, z), (0.34, y, z), r) for y in (-0.075, -0.03)]
    end = tube([(*p, z) for p in arc((0.34, -0.0525), 0.0225, -np.pi / 2, np.pi / 2, 10)], r, 8)
    bow = tube([(*p, z) for p in arc((-0.16, 0.01), 0.04, np.pi / 2, 1.5 * np.pi, 14)], 0.0075, 8)
    upper = straight((-0.16, 0.05, z), (0.03, 0.05, z), 0.0075)
    lower = straight((-0.16, -0.03, z), (-0.1, -0.03, z), 0.0075)
    bell = _bell(0.02, 0.05, z, 0.055, 0.14)
    braces = [straight((x, -0.075, z), (x, -0.03, z), 0.003) for x in (-0.06, 0.0)]
    more = [straight((-0.06, -0.03, z), (-0.06, 0.05, z), 0.003)]
    cup = spindle((-0.13, 0.011), (-0.122, 0.009), (-0.11, 0.005), (-0.095, 0.005), z=z).move(
        y=-0.075
    )
    return [(bell, tile), (join(slide), tile), (end, tile), (bow, tile), (join([upper, lower]),
             tile),
            (join([*braces, *more]), tile), (cup, shine(look))]  # fmt: skip


def _horn(look: Look) -> Pieces:
    """A French horn lying: tubes coiled in a ring, a broad bell beside them."""
    tile = metal(look, *BRASSY)
    rings = [torus(r, 0.0065, 36, 8).move(0, 0, z) for r, z in ((0.085, 0.03), (0.072, 0.034),
                                                                (0.058, 0.03))]  # fmt: skip
    path = smooth([(-0.07, -0.05, 0.03), (0.0, -0.088, 0.034), (0.08, -0.07, 0.05),
                   (0.125, -0.03, 0.062)], 6)  # fmt: skip
    throat = tube(path, np.linspace(0.0075, 0.024, len(path)), 14)
    flare = lathe([(0.02, 0), (0.032, 0.035), (0.075, 0.06), (0.072, 0.06), (0.028, 0.034),
                   (0.016, 0.002)], 26, loop=True)  # fmt: skip
    flare = flare.turn(1, 1.25).turn(2, 0.65).move(0.108, -0.045, 0.062)
    keys = [disc(0.009, 0.04, (0.022 * k - 0.02, 0.02, 0.012)) for k in range(3)]
    levers = [at_box(0.01, 0.05, 0.003, (0.022 * k - 0.02, 0.045, 0.05)) for k in range(3)]
    pipe = rod(
        [(-0.08, 0.03, 0.034), (-0.1, 0.07, 0.036), (-0.085, 0.115, 0.036)], [0.006, 0.005, 0.004]
    )
    return [(join(rings), tile), (throat, tile), (flare, tile), (join(keys), tile),
            (join(levers), tile), (pipe, tile)]  # fmt: skip


def _tuba(look: Look) -> Pieces:
    """A tuba standing on its bell, tubes wound round."""
    tile = metal(look, *BRASSY)
    bell = lathe([(0.0, 0), (0.085, 0), (0.05, 0.03), (0.03, 0.08), (0.024, 0.2), (0, 0.2)], 28)
    loop = tube([(0.05 * np.cos(a) + 0.045, 0.0, 0.14 + 0.1 * np.sin(a))
                 for a in np.arange(36) * np.pi / 18], 0.014, 10, loop=True)  # fmt: skip
    small = tube([(0.03 * np.cos(a) + 0.045, 0.014, 0.14 + 0.07 * np.sin(a))
                  for a in np.arange(30) * np.pi / 15], 0.008, 8, loop=True)  # fmt: skip
    keys = [disc(0.009, 0.08, (0.03 + 0.022 * k, -0.018, 0.1)) for k in range(3)]
    cup = rod([(0.04, 0, 0.235), (0.02, -0.04, 0.26), (0.0, -0.07, 0.26)], [0.007, 0.006, 0.011])
    return [(bell, tile), (loop, tile), (small, tile), (join(keys), shine(look)), (cup, tile)]


def _cup(look: Look) -> Pieces:
    """A brass mouthpiece standing on its cup."""
    tile = metal(look, "silver", "silver", "gold")
    return [(lathe([(0, 0), (0.0125, 0), (0.0135, 0.004), (0.012, 0.014), (0.006, 0.022),
                    (0.0042, 0.03), (0.005, 0.08), (0, 0.08)], 24), tile)]  # fmt: skip


def _mute(look: Look) -> Pieces:
    tile = metal(look, "silver", "gold", "red", "black")
    cone = lathe([(0, 0), (0.06, 0), (0.06, 0.008), (0.05, 0.02), (0.02, 0.11), (0.02, 0.13),
                  (0, 0.13)], 28)  # fmt: skip
    corks = [at_block(0.006, 0.008, 0.03, 0.002, (0.024, 0, 0)).turn(1, -0.0).turn(2,
             a).move(z=0.09)
             for a in (0, 2.1, 4.2)]  # fmt: skip
    return [(cone, tile), (join(corks), dye(look, "tan"))]


def _bassoon(look: Look) -> Pieces:
    """A long double pipe with a thin bent crook, lying."""
    tile = wood(look, "maroon", "brown", "black")
    body = spindle((-0.27, 0.016), (-0.26, 0.02), (-0.1, 0.02), (-0.09, 0.014), (0.2, 0.0125),
                  (0.205, 0.017), (0.23, 0.017), z=0.02)  # fmt: skip
    second = spindle((-0.1, 0.011), (0.06, 0.01), z=0.02).move(y=0.025)
    crook = rod([(0.055, 0.025, 0.02), (0.09, 0.035, 0.025), (0.11, 0.06, 0.024), (0.1, 0.085,
             0.012)],
                [0.004, 0.0035, 0.003, 0.002], 8)  # fmt: skip
    keys = [disc(0.0075, 0.004, (x, y, 0.034)) for x, y in (
        (-0.2, 0), (-0.16, 0.004), (-0.12, 0), (-0.04, 0), (0.0, 0.003), (0.05, 0), (0.1, 0.002),
        (0.15, 0))]  # fmt: skip
    rods = [straight((-0.22, 0.014, 0.034), (-0.09, 0.014, 0.034), 0.002),
            straight((-0.06, 0.01, 0.031), (0.17, 0.01, 0.031), 0.002)]  # fmt: skip
    return [(body, tile), (second, tile), (crook, shine(look)), (join([*keys, *rods]), shine(look))]


def _pan(look: Look) -> Pieces:
    """Pan pipes lying: reeds from short to long, bound together."""
    tile = wood(look, "wooden", "tan", "beige")
    pipes = []
    for k in range(9):
        long = 0.16 - 0.011 * k
        pipes.append(straight((0.0155 * (k - 4), 0.07 - long, 0.0078), (0.0155 * (k - 4), 0.07,
             0.0078),
                              0.0078, 10))  # fmt: skip
    bands = [at_box(0.145, 0.012, 0.018, (0, y, 0)) for y in (0.045, 0.012)]
    holes = [straight((0.0155 * (k - 4), 0.0698, 0.0078), (0.0155 * (k - 4), 0.0706, 0.0078),
             0.006, 10)
             for k in range(9)]  # fmt: skip
    return [(join(pipes), tile), (bands[0], dye(look, "brown", "red")),
            (bands[1], dye(look, "brown", "red")), (join(holes), textures.plain((40, 30,
             24)))]  # fmt: skip


def _ocarina(look: Look) -> Pieces:
    color = look.color("blue", "teal", "terracotta", "brown", "green")
    tile = textures.gradient(tuple(0.75 * c for c in color), color, look.rng)  # type: ignore[arg-type]
    body = ball(0.11, 0.065, 0.045, (0, 0, 0.021), 22).bend(
        lambda p: p * np.column_stack([np.ones(len(p)), *(2 * [1 - 4 * p[:, 0]])]))  # fmt: skip
    mouth = at_block(0.028, 0.04, 0.016, 0.006, (-0.018, 0.045, 0.012))
    holes = [disc(0.0038, 0.002, (x, y, 0.0385 - abs(x) * 0.12)) for x, y in (
        (-0.03, -0.012), (-0.014, -0.016), (0.002, -0.013), (0.016, -0.009), (-0.03, 0.012),
        (-0.012, 0.013), (0.006, 0.008))]  # fmt: skip
    return [(body, tile), (mouth, tile), (join(holes), textures.plain((34, 26, 22)))]


CATEGORIES = (
    at_rest(Category("trombone", of(_trombone, 0.0), (0.561, 0.186, 0.107), 1.2, ("toy trombone",),
             ("living",),
             ("big",), ("gold",), state="lying flat")),
    at_rest(Category("french_horn", of(_horn, 0.0), (0.303, 0.216, 0.139), 1.5, ("horn instrument",
             "orchestral horn", "post horn"), ("living",), ("big",), ("gold",),
             state="lying flat")),
    Category("tuba", of(_tuba, 0.0), (0.205, 0.18, 0.287), 1.8, ("euphonium", "sousaphone",
             "baritone horn"), ("living",), ("tall", "big"), ("gold",)),
    Category("mouthpiece", of(_cup), (0.027, 0.027, 0.08), 0.08, ("trumpet mouthpiece",
             "tuba mouthpiece", "trombone mouthpiece", "brass mouthpiece"), ("living",), (),
             ("silver",)),
    Category("trumpet_mute", of(_mute), (0.12, 0.12, 0.13), 0.1, ("mute", "trombone mute",
             "straight mute"), ("living",), (), ("silver",)),
    Category("bassoon", of(_bassoon, 0.08), (0.496, 0.105, 0.0397), 1.0, ("contrabassoon",),
             ("living",), ("big",), ("maroon",), state="lying flat"),
    Category("pan_pipes", of(_pan, 0.08), (0.145, 0.17, 0.018), 0.12, ("panpipe", "pan flute",
             "panflute", "pan pipe", "syrinx"), ("living",), ("flat",), ("wooden",), state="lying"),
    Category("ocarina", of(_ocarina, 0.05, bodies=2), (0.106, 0.0957, 0.0443), 0.2,
             ("clay ocarina",),
             ("living",), (), ("blue",), state="lying"),
)  # fmt: skip
"""The module's categories."""
