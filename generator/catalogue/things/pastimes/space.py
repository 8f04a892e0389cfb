"""Space toys: astronauts, aliens, saucers, satellites, rovers, orreries."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import DARK, at_box, drum, standing, steel
from ...build.recipes import ball, put_down, rod, straight
from ...build.shape import Shape
from ...build.solids import Solid, block, join, lathe, torus
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def _figure(big: float) -> dict[str, list[Solid]]:
    """Return a standing figure: legs, trunk, arms, and a head ``big`` across."""
    legs = [drum(0.0125, 0.036, (s * 0.0145, 0, 0.006), top=0.014) for s in (-1, 1)]
    feet = [ball(0.026, 0.038, 0.02, (s * 0.0145, -0.005, 0.008), 12) for s in (-1, 1)]
    trunk = [block(0.054, 0.036, 0.045, 0.014, 0.006).move(z=0.036)]
    arms = [rod([(s * 0.024, 0, 0.072), (s * 0.04, -0.004, 0.056), (s * 0.038, -0.018, 0.044)],
                0.0095, 10) for s in (-1, 1)]  # fmt: skip
    hands = [ball(0.02, 0.02, 0.02, (s * 0.038, -0.02, 0.042), 10) for s in (-1, 1)]
    head = [ball(big, 0.92 * big, 0.94 * big, (0, 0, 0.076 + 0.4 * big), 18)]
    return {"legs": legs, "feet": feet, "trunk": trunk, "arms": arms, "hands": hands, "head": head}


def astronaut(look: Look) -> Shape:
    """An astronaut: a white suit with a pack, a round helmet and a gold visor."""
    color = look.color("white", "white", "orange", "sky", "silver")
    k = look.between(0.85, 1.2)
    f = _figure(0.052)
    visor = ball(0.04, 0.03, 0.03, (0, -0.0115, 0.097), 16)
    rim = torus(0.018, 0.003, 22, 6).scale(1.1, 0.85, 1).turn(0, np.pi / 2).move(0, -0.0185, 0.097)
    pack = block(0.046, 0.022, 0.046, 0.006, 0.004).move(0, 0.026, 0.04)
    panel = at_box(0.022, 0.004, 0.016, (0, -0.0175, 0.055))
    dots = [at_box(0.004, 0.005, 0.004, (0.006 * n, -0.018, 0.061)) for n in (-1, 0, 1)]
    badge = at_box(0.01, 0.004, 0.007, (0.016, -0.0172, 0.072))
    suit = textures.speckles(look.rng, color, 3)
    body = [*f["legs"], *f["trunk"], *f["arms"], *f["head"]]
    return put_down(
        [
            (join([*body, rim]), suit),
            (join([*f["feet"], *f["hands"], pack]), plain(tint_color(color, 0.72))),
            (visor, plain(look.pick([(210, 160, 60), (60, 70, 90), (120, 150, 180)]))),
            (panel, plain((90, 96, 106))),
            (join([*dots, badge]), plain((206, 60, 54))),
        ],
        join([*f["legs"], *f["feet"]]),
        f["trunk"][0],
        f["head"][0],
        pack,
        *f["arms"],
        factor=k,
        foot=0.2,
    )


def alien(look: Look) -> Shape:
    """A little alien: a big head with black eyes and feelers."""
    color = look.color("green", "lime", "teal", "purple", "gray")
    k = look.between(0.85, 1.2)
    f = _figure(0.062)
    head = f["head"][0].bend(
        lambda p: (
            p
            * np.column_stack(
                [1 + 5 * np.clip(p[:, 2] - 0.1, -0.02, 0.03), np.ones(len(p)), np.ones(len(p))]
            )
        )
    )
    eyes = [ball(0.018, 0.01, 0.026, (0, 0, 0), 12).turn(1, s * 0.4).move(s * 0.0135, -0.024, 0.101)
            for s in (-1, 1)]  # fmt: skip
    feelers = [rod([(s * 0.01, 0, 0.125), (s * 0.02, 0, 0.143)], 0.0016, 6) for s in (-1, 1)]
    tips = [ball(0.008, 0.008, 0.008, (s * 0.02, 0, 0.144), 8) for s in (-1, 1)]
    suit = look.own_color("silver", "purple", "navy", "red")
    skin = textures.speckles(look.rng, color, 6)
    return put_down(
        [
            (join([head, *f["hands"], *f["feet"], *feelers]), skin),
            (join([*f["legs"], *f["trunk"], *f["arms"]]), plain(suit)),
            (join(eyes), plain((22, 22, 26))),
            (join(tips), plain((244, 206, 62))),
        ],
        join([*f["legs"], *f["feet"]]),
        f["trunk"][0],
        head,
        *f["arms"],
        factor=k,
        foot=0.2,
    )


def ufo(look: Look) -> Shape:
    """A flying saucer on three legs, with a glass dome and lights."""
    color = look.color("silver", "gray", "green", "purple", "blue")
    k = look.between(0.8, 1.2)
    saucer = standing(
        (0.02, 0.02),
        (0.03, 0.022),
        (0.065, 0.034),
        (0.066, 0.038),
        (0.034, 0.05),
        (0.03, 0.052),
        sides=32,
    )
    dome = ball(0.056, 0.056, 0.056, (0, 0, 0.05), 20)
    lamps = [
        ball(0.008, 0.008, 0.008, (0.05 * np.cos(a), 0.05 * np.sin(a), 0.043), 8)
        for a in np.arange(10) * np.pi / 5
    ]
    legs, feet = [], []
    for a in np.arange(3) * 2 * np.pi / 3 + np.pi / 2:
        x, y = float(np.cos(a)), float(np.sin(a))
        legs.append(straight((0.03 * x, 0.03 * y, 0.025), (0.046 * x, 0.046 * y, 0.003), 0.003, 8))
        feet.append(drum(0.008, 0.004, (0.046 * x, 0.046 * y, 0)))
    pilot = ball(0.02, 0.02, 0.026, (0, 0, 0.062), 10)
    return put_down(
        [
            (saucer, steel(look, color)),
            (dome, plain((150, 206, 214))),
            (pilot, plain((110, 190, 80))),
            (join(lamps), plain(look.own_color("yellow", "red", "lime"))),
            (join([*legs, *feet]), steel(look)),
        ],
        saucer,
        dome,
        join(feet),
        factor=k,
    )


def satellite(look: Look) -> Shape:
    """A satellite on a stand: a foil-wrapped body, two wings of solar cells, a dish."""
    color = look.color("gold", "silver", "white", "copper")
    k = look.between(0.85, 1.15)
    base, post = drum(0.035, 0.008, bevel=0.002), drum(0.004, 0.05, (0, 0, 0.006))
    body = block(0.04, 0.036, 0.05, 0.003, 0.002).move(z=0.052)
    wings = [at_box(0.085, 0.003, 0.036, (s * 0.075, 0, 0.06)) for s in (-1, 1)]
    arms = [straight((s * 0.018, 0, 0.078), (s * 0.034, 0, 0.078), 0.003, 8) for s in (-1, 1)]
    dish = lathe(
        [(0, 0), (0.012, 0.002), (0.024, 0.009), (0.0225, 0.011), (0.011, 0.005), (0, 0.0035)], 22
    )
    dish = dish.turn(0, 0.6).move(0, -0.01, 0.104)
    horn = straight((0, -0.014, 0.107), (0, -0.024, 0.12), [0.0025, 0.0008], 6)
    cells = textures.grid((180, 190, 210), (36, 60, 120), 4, 8, 128, 3)
    foil = textures.scratches(look.rng, color, tint_color(color, 1.4), 90)
    return put_down(
        [
            (body, foil),
            (join(wings), cells),
            (join([base, post]), plain(DARK)),
            (join([*arms, dish, horn]), plain((236, 236, 240))),
        ],
        base,
        post,
        body,
        join(wings),
        dish,
        factor=k,
    )


def rover(look: Look) -> Shape:
    """A six-wheeled rover with a camera mast, panels and an arm."""
    color = look.color("white", "silver", "gold", "orange")
    k = look.between(0.85, 1.15)
    wheels = [
        drum(0.017, 0.014, (x, s * 0.05 - 0.007, 0.017), 1, sides=16)
        for x in (-0.052, 0, 0.052)
        for s in (-1, 1)
    ]
    rockers = [
        rod(
            [
                (-0.052, s * 0.041, 0.018),
                (-0.026, s * 0.04, 0.04),
                (0, s * 0.041, 0.02),
                (0.03, s * 0.04, 0.044),
                (0.052, s * 0.041, 0.018),
            ],
            0.003,
            6,
        )
        for s in (-1, 1)
    ]
    body = block(0.09, 0.066, 0.026, 0.004, 0.002).move(z=0.034)
    deck = at_box(0.11, 0.09, 0.003, (-0.01, 0, 0.06))
    mast = drum(0.004, 0.045, (0.042, 0.016, 0.06))
    head = [at_box(0.016, 0.03, 0.014, (0.042, 0.016, 0.104))]
    eyes = [drum(0.0045, 0.003, (0.049, 0.016 + y, 0.111), 0, sides=10) for y in (-0.008, 0.008)]
    arm = rod([(0.045, -0.02, 0.05), (0.08, -0.02, 0.062), (0.088, -0.02, 0.035)], 0.0032, 8)
    cells = textures.grid((170, 180, 200), (34, 48, 96), 6, 6, 96, 2)
    return put_down(
        [
            (join([body, *head]), textures.speckles(look.rng, color, 4)),
            (deck, cells),
            (join([*wheels, *eyes]), plain(DARK)),
            (join([*rockers, mast, arm]), steel(look)),
        ],
        body,
        deck,
        mast,
        join(wheels[:2]),
        join(wheels[4:]),
        head[0],
        arm,
        factor=k,
    )


def orrery(look: Look) -> Shape:
    """A model of the sun and its planets on arms round a post."""
    color = look.color("gold", "wooden", "black", "bronze")
    k = look.between(0.85, 1.1)
    base, post = drum(0.05, 0.014, bevel=0.004), drum(0.005, 0.075, (0, 0, 0.012))
    sun = ball(0.05, 0.05, 0.05, (0, 0, 0.1), 20)
    tones = [
        (150, 140, 130),
        (220, 180, 120),
        (60, 120, 190),
        (190, 80, 50),
        (210, 170, 130),
        (220, 196, 140),
        (90, 130, 190),
    ]
    arms, pieces = [], []
    for n, tone in enumerate(tones):
        a, r, z = 2.3 * n + 0.4, 0.045 + 0.0135 * n, 0.03 + 0.006 * n
        x, y = r * np.cos(a), r * np.sin(a)
        d = (0.01, 0.014, 0.015, 0.012, 0.026, 0.022, 0.018)[n]
        arms += [
            straight((0, 0, z), (x, y, z), 0.0014, 6),
            straight((x, y, z), (x, y, z + 0.03), 0.0012, 6),
        ]
        pieces.append((ball(d, d, d, (x, y, z + 0.03 + d / 2), 12), plain(tone)))
        if n == 5:
            pieces.append(
                (
                    torus(0.017, 0.0016, 22, 6).scale(1, 1, 0.5).move(x, y, z + 0.041),
                    plain((230, 214, 170)),
                )
            )
    metal = look.surface(color, "brass")
    return put_down(
        [
            (join([base, post, *arms]), metal),
            (sun, textures.gradient((240, 150, 40), (250, 220, 90), look.rng)),
            *pieces,
        ],
        base,
        post,
        sun,
        *(s for s, _ in pieces[2:]),
        factor=k,
    )


CATEGORIES = (
    Category("astronaut", astronaut, (0.102, 0.0683, 0.124), 0.06,
             ("astronaut figure", "toy astronaut", "spaceman", "cosmonaut", "astronaut figurine"),
             ("toys",), (), ("white",)),
    Category("alien", alien, (0.106, 0.0613, 0.157), 0.05, ("alien figure", "toy alien",
             "martian", "alien toy"), ("toys",), (), ("green",)),
    Category("ufo", ufo, (0.135, 0.135, 0.0797), 0.08,
             ("ufo toy", "flying saucer", "toy ufo", "spacecraft"), ("toys",), (), ("silver",)),
    Category("satellite", satellite, (0.23, 0.0685, 0.123), 0.15,
             ("satellite model", "model satellite", "toy satellite", "space probe",
             "space station"), ("toys",), (), ("gold", "silver")),
    Category("rover", rover, (0.158, 0.113, 0.117), 0.15,
             ("rover model", "mars rover", "moon rover", "lunar rover", "toy rover"), ("toys",),
             (), ("white",)),
    Category("orrery", orrery, (0.201, 0.206, 0.116), 0.4,
             ("solar system model", "model solar system", "planetarium",
             "model of the solar system"), ("toys",), ("big",), ("gold",)),
)  # fmt: skip
"""The module's categories."""
