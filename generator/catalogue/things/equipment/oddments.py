"""Props of several kinds: amphorae, churns, gnomes, potties, volcanoes, easels."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import BRASS_TONE, at_box, drum, plate, standing, steel, vessel
from ...build.recipes import ball, put_down, rod
from ...build.shape import Shape
from ...build.solids import block, join
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def amphora(look: Look) -> Shape:
    """An amphora on a small foot, with two handles and a painted band."""
    color = look.color("terracotta", "tan", "brown", "cream")
    k = look.between(0.85, 1.1)
    side = [
        (0.032, 0),
        (0.026, 0.01),
        (0.03, 0.03),
        (0.062, 0.09),
        (0.068, 0.125),
        (0.052, 0.165),
        (0.022, 0.185),
        (0.019, 0.215),
        (0.028, 0.226),
    ]
    pot = standing(*side, (0.022, 0.226), sides=28)
    mouth = drum(0.02, 0.0008, (0, 0, 0.2256))
    handles = [
        rod(
            [
                (s * 0.02, 0, 0.212),
                (s * 0.052, 0, 0.214),
                (s * 0.062, 0, 0.185),
                (s * 0.054, 0, 0.155),
            ],
            0.0058,
            8,
        )
        for s in (-1, 1)
    ]
    image = textures.speckles(look.rng, color, 8, 128).copy()
    ink = look.own_color("black", "brown", "navy")
    for v, h in ((0.02, 0.02), (0.4, 0.02), (0.56, 0.02), (0.72, 0.05)):
        prints.fill(image, 0, v, 1, h, ink)
    prints.stroke(image, [(n / 16, 0.49 + 0.035 * (-1) ** n) for n in range(17)], 0.02, ink)
    return put_down(
        [
            (pot, image),
            (mouth, plain((50, 36, 30))),
            (join(handles), plain(tint_color(color, 0.8))),
        ],
        pot,
        *handles,
        factor=k,
    )


def butter_churn(look: Look) -> Shape:
    """A butter churn: a staved tub with hoops and a plunger through its lid."""
    color = look.color("wooden", "tan", "brown")
    k = look.between(0.8, 1.05)
    tub = standing((0.07, 0), (0.056, 0.18), (0.054, 0.18), sides=20)
    hoops = [
        standing((r, 0), (r - 0.0012, 0.014), at=(0, 0, z), sides=20)
        for r, z in ((0.0705, 0.02), (0.0645, 0.09), (0.0595, 0.15))
    ]
    lid, stick = drum(0.058, 0.014, (0, 0, 0.178)), drum(0.008, 0.12, (0, 0, 0.19), sides=12)
    staves = textures.stripes(
        [color, tint_color(color, 0.82), tint_color(color, 1.12)], 6, upright=True
    )
    return put_down(
        [
            (tub, staves),
            (join(hoops), steel(look, (120, 110, 100))),
            (join([lid, stick]), textures.wood(look.rng, color)),
        ],
        tub,
        lid,
        stick,
        factor=k,
    )


def gnome(look: Look) -> Shape:
    """A garden gnome with a pointed hat and a white beard."""
    color = look.color("red", "blue", "green", "red")
    k = look.between(0.85, 1.15)
    coat = standing((0.038, 0.014), (0.042, 0.03), (0.036, 0.075), (0.024, 0.09), sides=22)
    feet = [ball(0.034, 0.05, 0.028, (s * 0.018, -0.012, 0.012), 12) for s in (-1, 1)]
    belt = standing((0.0415, 0), (0.041, 0.01), at=(0, 0, 0.045), sides=22)
    head = ball(0.05, 0.048, 0.046, (0, 0, 0.104), 16)
    nose = ball(0.016, 0.016, 0.015, (0, -0.026, 0.104), 10)
    beard = ball(0.05, 0.03, 0.06, (0, -0.018, 0.082), 14)
    hat = standing(
        (0.03, 0), (0.031, 0.006), (0.016, 0.045), (0.002, 0.085), at=(0, 0.002, 0.114), sides=20
    )
    arms = [
        rod(
            [(s * 0.028, 0, 0.083), (s * 0.045, -0.008, 0.06), (s * 0.03, -0.032, 0.055)], 0.0105, 8
        )
        for s in (-1, 1)
    ]
    eyes = [ball(0.005, 0.004, 0.006, (s * 0.01, -0.0225, 0.111), 6) for s in (-1, 1)]
    tone = look.own_color("blue", "green", "mustard", "brown", "teal")
    return put_down(
        [
            (join([coat, *arms]), plain(tone)),
            (join([*feet, belt, *eyes]), plain((50, 40, 36))),
            (join([head, nose]), plain((240, 196, 164))),
            (beard, plain((244, 242, 236))),
            (hat, textures.speckles(look.rng, color, 4)),
        ],
        join(feet),
        coat,
        head,
        hat,
        factor=k,
        foot=0.3,
    )


def potty(look: Look) -> Shape:
    """A child's potty with a raised back, open above."""
    color = look.color("blue", "pink", "green", "white", "yellow")
    k = look.between(0.75, 0.95)
    profile = [(0.1, 0), (0.098, 0.01), (0.09, 0.09), (0.12, 0.125), (0.125, 0.13)]
    back = (
        plate([(-0.07, 0), (0.07, 0), (0.05, 0.07), (0, 0.085), (-0.05, 0.07)], 0.012)
        .turn(0, np.pi / 2)
        .move(0, 0.118, 0.12)
    )
    return vessel(
        profile,
        0.02,
        0.02,
        plain(color),
        extra=[(back, plain(tint_color(color, 0.85)))],
        bodies=[back],
        factor=k,
    )


def volcano(look: Look) -> Shape:
    """A model volcano with lava running down its sides."""
    color = look.color("brown", "charcoal", "gray", "terracotta")
    k = look.between(0.85, 1.15)
    cone = standing(
        (0.11, 0), (0.1, 0.008), (0.062, 0.06), (0.032, 0.115), (0.022, 0.115), sides=26
    )
    pool = drum(0.026, 0.004, (0, 0, 0.113))
    streams = []
    for n in range(6):
        a = 1.05 * n + look.between(-0.2, 0.2)
        long = look.between(0.35, 0.9)
        path = [
            (0.024, 0, 0.117),
            (0.036, 0, 0.111),
            (0.036 + 0.034 * long, 0, 0.111 - 0.06 * long),
            (0.036 + 0.055 * long, 0, 0.111 - 0.088 * long),
        ]
        streams.append(rod(path, [0.007, 0.007, 0.006, 0.008], 8).turn(2, a))
    base = drum(0.125, 0.008, sides=32)
    return put_down(
        [
            (cone, textures.spots(look.rng, color, tint_color(color, 0.6), 0.25)),
            (base, plain((96, 140, 70))),
            (join([pool, *streams]), textures.gradient((200, 40, 24), (250, 160, 40), look.rng)),
        ],
        base,
        cone,
        factor=k,
    )


def table_easel(look: Look) -> Shape:
    """A small table easel standing, empty, with a ledge."""
    color = look.color("wooden", "tan", "brown", "white", "black")
    k = look.between(0.8, 1.05)
    legs = [rod([(s * 0.09, -0.05, 0.005), (s * 0.02, 0.02, 0.27)], 0.007, 6) for s in (-1, 1)]
    rear = rod([(0, 0.12, 0.005), (0, 0.018, 0.25)], 0.007, 6)
    ledge = [
        at_box(0.2, 0.034, 0.01, (0, -0.05, 0.06)),
        at_box(0.2, 0.006, 0.018, (0, -0.066, 0.06)),
    ]
    cross, top = (
        at_box(0.085, 0.012, 0.014, (0, -0.002, 0.17)),
        block(0.06, 0.014, 0.03, 0.004).move(0, 0.018, 0.255),
    )
    chain = rod([(0, 0.075, 0.11), (0, 0.03, 0.095), (0, -0.02, 0.1)], 0.0015, 6)
    return put_down(
        [
            (join([*legs, rear, *ledge, cross, top]), look.surface(color, "wood")),
            (chain, steel(look, BRASS_TONE)),
        ],
        *legs,
        rear,
        *ledge,
        top,
        factor=k,
    )


CATEGORIES = (
    Category("amphora", amphora, (0.13, 0.13, 0.217), 0.8, ("greek amphora", "roman amphora",
             "clay amphora", "kylix", "greek urn"), ("living",), ("tall",),
             ("terracotta",)),
    Category("butter_churn", butter_churn, (0.129, 0.129, 0.284), 0.9, ("churn", "milk churn"),
             ("kitchen",), ("tall",), ("wooden",)),
    Category("garden_gnome", gnome, (0.114, 0.0863, 0.205), 0.35, ("gnome", "garden dwarf",
             "dwarf", "gnome figurine"), ("living",), ("tall",), ("red",)),
    Category("potty", potty, (0.209, 0.209, 0.171), 0.3, ("baby potty", "child's potty",
             "chamber pot"), ("living",), ("container", "big"), ("blue", "pink")),
    Category("volcano", volcano, (0.241, 0.241, 0.119), 0.4, ("toy volcano",
             "model volcano", "volcano kit"), ("toys", "lab"), ("big",), ("brown",)),
    Category("easel", table_easel, (0.196, 0.191, 0.277), 0.4, ("table easel", "wooden easel",
             "mini easel", "display easel", "tabletop easel", "artist's easel"),
             ("craft",), ("tall",), ("wooden",)),
)  # fmt: skip
"""The module's categories."""
