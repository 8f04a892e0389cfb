"""Small animals with fur or feathers: hamsters, chicks, budgies."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import blade
from ...build.recipes import Pieces, ball
from ...build.settled import limb, settle
from ...build.shape import Shape
from ...build.solids import Solid, cylinder, ellipsoid, join
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

DARK: RGB = (26, 24, 26)


def eyes(x: float, y: float, z: float, d: float) -> Solid:
    """Return two round eyes, ``y`` to either side."""
    return join([ball(d, d, d, (x, s * y, z), 8) for s in (-1, 1)])


def _fur(look: Look, color: RGB) -> textures.Tile:
    return textures.scratches(look.rng, color, tint_color(color, 0.84), 160)


def _rodent(
    long: float, ears: float, tail: float, palette: tuple[str, ...]
) -> Callable[[Look], Shape]:
    """Return the shape function of a plump furry rodent that looks to the left."""

    def make(look: Look) -> Shape:
        k, color = long * look.between(0.88, 1.12), look.color(*palette)
        body = ball(k, 0.62 * k, 0.56 * k, (0.06 * k, 0, 0.27 * k), 20)
        head = ball(0.46 * k, 0.42 * k, 0.4 * k, (-0.42 * k, 0, 0.3 * k), 18)
        snout = ball(0.2 * k, 0.2 * k, 0.16 * k, (-0.62 * k, 0, 0.26 * k), 12)
        ear = [
            ball(0.05 * k, ears * k, ears * k, (-0.36 * k, s * 0.15 * k, 0.49 * k), 10)
            for s in (-1, 1)
        ]
        feet = [ball(0.16 * k, 0.1 * k, 0.08 * k, (x * k, s * 0.18 * k, 0.03 * k), 10)
                for x in (-0.32, 0.3) for s in (-1, 1)]  # fmt: skip
        nose = ball(0.05 * k, 0.06 * k, 0.04 * k, (-0.72 * k, 0, 0.28 * k), 8)
        pink = [*ear, *feet, nose]
        if tail > 0.2:
            pink.append(limb([(0.52 * k, 0, 0.14 * k), (0.75 * k, 0.06 * k, 0.04 * k),
                              ((0.5 + tail) * k, -0.06 * k, 0.03 * k)],
                             [0.03 * k, 0.025 * k, 0.008 * k], 7))  # fmt: skip
        belly = ball(0.7 * k, 0.5 * k, 0.4 * k, (0, 0, 0.19 * k), 16)
        patch = (
            tint_color(color, 1.6)
            if look.chance(0.6)
            else look.own_color("white", "brown", "black")
        )
        return settle([(join([body, head]), _fur(look, color)), (join([snout, belly]),
            textures.plain(patch)),
                       (join(pink), textures.plain((232, 164, 160))),
                       (eyes(-0.54 * k, 0.14 * k, 0.39 * k, 0.065 * k), textures.plain(DARK))],
                      0.03, hulls=[[0, 1]])  # fmt: skip

    return make


def _bird(
    tall: float, palette: tuple[str, ...], *, tail: float, crest: bool, fluffy: bool
) -> Callable[[Look], Shape]:
    """Return the shape function of a small bird that stands and looks to the left."""

    def make(look: Look) -> Shape:
        k, color = tall * look.between(0.88, 1.12), look.color(*palette)
        legs = 0.14 * k if fluffy else 0.08 * k
        pieces: Pieces = []
        if fluffy:
            body = ball(0.62 * k, 0.56 * k, 0.54 * k, (0.06 * k, 0, legs + 0.25 * k), 18)
            head = ball(0.42 * k, 0.4 * k, 0.4 * k, (-0.13 * k, 0, legs + 0.62 * k), 16)
            bill, eye = (-0.36 * k, legs + 0.6 * k), (-0.24 * k, 0.14 * k, legs + 0.68 * k)
        else:
            body = (
                ellipsoid(0.4 * k, 0.4 * k, 0.78 * k, 18, 12)
                .turn(1, 0.3)
                .move(0.02 * k, 0, legs + 0.36 * k)
            )
            head = ball(0.34 * k, 0.32 * k, 0.32 * k, (-0.14 * k, 0, legs + 0.76 * k), 16)
            bill, eye = (-0.3 * k, legs + 0.72 * k), (-0.2 * k, 0.125 * k, legs + 0.8 * k)
        feathers = (
            _fur(look, color)
            if fluffy
            else textures.gradient(color, tint_color(color, 1.3), look.rng)
        )
        pieces.append((join([body, head]), feathers))
        wings = [ellipsoid(0.4 * k, 0.06 * k, 0.24 * k if fluffy else 0.3 * k, 12, 7).turn(1,
            0.5 if not fluffy else 0.2)
                 .move(0.1 * k, s * (0.27 if fluffy else 0.19) * k,
                       legs + (0.28 if fluffy else 0.38) * k)
                 for s in (-1, 1)]  # fmt: skip
        extra = list(wings)
        if tail:
            extra.append(blade([(0.12 * k, 0, legs + 0.14 * k), (0.2 * k, 0, 0.08 * k),
                                ((0.2 + tail) * k, 0, 0.02 * k)], 0.18 * k, thick=0.3))  # fmt: skip
        pieces.append(
            (join(extra), textures.stripes([tint_color(color, 0.72), tint_color(color, 1.1)], 6))
        )
        horn = (
            cylinder(0.06 * k, 0.14 * k, 8, top=0.004 * k)
            .turn(1, -np.pi / 2 - 0.3)
            .move(bill[0] + 0.03 * k, 0, bill[1])
        )
        feet = [limb([(0.04 * k, s * 0.1 * k, legs + 0.06 * k), (0.03 * k, s * 0.1 * k, 0.03 * k),
                      (-0.08 * k, s * 0.1 * k, 0.012 * k)], [0.02 * k] * 3, 6) for s in (-1,
                          1)]  # fmt: skip
        toes = [
            ball(0.2 * k, 0.12 * k, 0.03 * k, (-0.02 * k, s * 0.1 * k, 0.015 * k), 8)
            for s in (-1, 1)
        ]
        if crest:
            extra_comb = ball(0.16 * k, 0.05 * k, 0.12 * k, (-0.1 * k, 0, legs + 0.94 * k), 8)
            pieces.append((extra_comb, textures.plain((206, 40, 44) if not fluffy else color)))
        pieces += [(join([horn, *feet, *toes]), textures.plain((238, 150, 50))),
                   (eyes(*eye, 0.06 * k), textures.plain(DARK))]  # fmt: skip
        made = settle(pieces, 0.0, hulls=[[0]])
        low = cylinder(0.15 * k, 0.3 * k, 12).move(x=0.03 * k)
        return Shape(made.pieces, (*made.parts, hull_of(low)), made.opacity)

    return make


_P = ("living",)

CATEGORIES = (
    Category("hamster", _rodent(0.085, 0.13, 0.0, ("tan", "amber", "white", "gray", "brown")),
             (0.11, 0.0522, 0.0462), 0.12,
             ("gerbil", "toy hamster", "dormouse"), _P, (), ("tan",)),
    Category("guinea_pig", _rodent(0.19, 0.1, 0.0, ("brown", "black", "white", "tan")),
             (0.249, 0.118, 0.104), 0.8,
             ("cavy", "toy guinea pig"), _P, ("big",), ("brown",)),
    Category("chick", _bird(0.06, ("yellow", "yellow", "gold", "amber"), tail=0.0, crest=False,
                            fluffy=True), (0.05, 0.0363, 0.0587), 0.03,
             ("baby chick", "chick toy", "fluffy chick", "toy chick", "easter chick",
              "ceramic chick",
              "yellow chick", "chick figurine", "chick ornament", "marshmallow chick", "duckling"),
              _P, (), ("yellow",)),
    Category("budgie", _bird(0.15, ("green", "lime", "blue", "yellow", "sky", "white"), tail=0.3,
                             crest=False, fluffy=False), (0.136, 0.0658, 0.151), 0.04,
             ("budgerigar", "parakeet", "canary", "parrot", "cockatiel", "lovebird", "toy parrot"),
             _P, (), ("green",)),
    Category("hen", _bird(0.14, ("brown", "white", "copper", "black"), tail=0.12, crest=True,
                          fluffy=False), (0.0986, 0.0596, 0.148), 0.3,
             ("toy hen", "ceramic hen", "hen figurine", "rooster", "cockerel", "toy chicken",
              "hen ornament",
              "ceramic chicken", "ceramic rooster"), _P, (), ("brown",)),
)  # fmt: skip
"""The module's categories."""
