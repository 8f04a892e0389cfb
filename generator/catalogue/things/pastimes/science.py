"""Space and science toys: astronauts, saucers, rovers, tops on strings, mazes, windmills."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.forms import facing
from ...build.recipes import ball, put_down, rod, straight
from ...build.shape import Shape
from ...build.sketch import DARK, bar, cut, disc, plain, steel, turned
from ...build.solids import Solid, block, join, lathe, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def _figure(big: float) -> dict[str, list[Solid]]:
    """Return a standing figure: legs, trunk, arms, and a head ``big`` across."""
    legs = [disc(0.0125, 0.036, (s * 0.0145, 0, 0.006), top=0.014) for s in (-1, 1)]
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
    panel = bar(0.022, 0.004, 0.016, (0, -0.0175, 0.055))
    dots = [bar(0.004, 0.005, 0.004, (0.006 * n, -0.018, 0.061)) for n in (-1, 0, 1)]
    badge = bar(0.01, 0.004, 0.007, (0.016, -0.0172, 0.072))
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
    saucer = turned(
        [(0.02, 0.02), (0.03, 0.022), (0.065, 0.034), (0.066, 0.038), (0.034, 0.05), (0.03, 0.052)],
        fine=32,
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
        feet.append(disc(0.008, 0.004, (0.046 * x, 0.046 * y, 0)))
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
    base, post = disc(0.035, 0.008, bevel=0.002), disc(0.004, 0.05, (0, 0, 0.006))
    body = block(0.04, 0.036, 0.05, 0.003, 0.002).move(z=0.052)
    wings = [bar(0.085, 0.003, 0.036, (s * 0.075, 0, 0.06)) for s in (-1, 1)]
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
        disc(0.017, 0.014, (x, s * 0.05 - 0.007, 0.017), 1, fine=16)
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
    deck = bar(0.11, 0.09, 0.003, (-0.01, 0, 0.06))
    mast = disc(0.004, 0.045, (0.042, 0.016, 0.06))
    head = [bar(0.016, 0.03, 0.014, (0.042, 0.016, 0.104))]
    eyes = [disc(0.0045, 0.003, (0.049, 0.016 + y, 0.111), 0, fine=10) for y in (-0.008, 0.008)]
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
    base, post = disc(0.05, 0.014, bevel=0.004), disc(0.005, 0.075, (0, 0, 0.012))
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


def periscope(look: Look) -> Shape:
    """A toy periscope: a square tube with a mirror window at either end."""
    color = look.color("blue", "red", "gray", "green", "yellow")
    k = look.between(0.8, 1.1)
    trunk = block(0.05, 0.05, 0.23, 0.004)
    top, low = bar(0.052, 0.07, 0.052, (0, -0.01, 0.2)), bar(0.056, 0.08, 0.05, (0, 0.01, 0))
    window = bar(0.04, 0.002, 0.038, (0, -0.0455, 0.207))
    eye = bar(0.034, 0.002, 0.03, (0, 0.0505, 0.01))
    bands = [bar(0.053, 0.053, 0.006, (0, 0, z)) for z in (0.06, 0.19)]
    return put_down(
        [
            (trunk, textures.speckles(look.rng, color, 4)),
            (join([top, low, *bands]), plain(tint_color(color, 0.7))),
            (join([window, eye]), plain((186, 210, 220))),
        ],
        trunk,
        top,
        low,
        factor=k,
    )


def diabolo(look: Look) -> Shape:
    """A diabolo on its end: two cups joined at a narrow waist."""
    color = look.color("red", "blue", "yellow", "green", "orange")
    k = look.between(0.85, 1.15)
    side = [
        (0.05, 0.0),
        (0.052, 0.003),
        (0.045, 0.02),
        (0.022, 0.048),
        (0.009, 0.056),
        (0.009, 0.062),
    ]
    low = lathe([(0, 0.001), *side, (0, 0.062)], 28)
    rim = [
        (0.009, 0.062),
        (0.022, 0.07),
        (0.045, 0.098),
        (0.052, 0.115),
        (0.049, 0.116),
        (0.042, 0.1),
        (0.012, 0.075),
    ]
    high = lathe([(0, 0.062), *rim, (0, 0.075)], 28)
    axle = disc(0.006, 0.008, (0, 0, 0.0745))
    return put_down(
        [
            (low, plain(color)),
            (
                high,
                plain(color if look.chance(0.5) else look.own_color("white", "yellow", "black")),
            ),
            (axle, steel(look)),
        ],
        low,
        high,
        factor=k,
    )


def cup_and_ball(look: Look) -> Shape:
    """A wooden cup on a handle, standing, with its ball on a string beside it."""
    color = look.color("wooden", "red", "blue", "green")
    k = look.between(0.85, 1.15)
    stem = turned(
        [
            (0.026, 0),
            (0.026, 0.006),
            (0.009, 0.016),
            (0.008, 0.08),
            (0.012, 0.09),
            (0.026, 0.1),
            (0.034, 0.125),
            (0.03, 0.125),
            (0.022, 0.106),
        ],
        fine=24,
    )
    sphere = ball(0.034, 0.034, 0.034, (0.065, -0.01, 0.0165), 16)
    line = rod(
        [(0.012, 0, 0.085), (0.032, -0.004, 0.04), (0.045, -0.014, 0.03), (0.065, -0.01, 0.034)],
        0.0011,
        6,
    )
    return put_down(
        [
            (stem, textures.wood(look.rng, color)),
            (sphere, plain(look.own_color("red", "yellow", "navy"))),
            (line, plain((236, 230, 214))),
        ],
        stem,
        sphere,
        factor=k,
        foot=0.06,
    )


def marble_maze(look: Look) -> Shape:
    """A shallow box with low walls, holes and a steel ball."""
    color = look.color("wooden", "tan", "blue", "red")
    k = look.between(0.85, 1.15)
    floor, s = bar(0.2, 0.2, 0.008), 0.2
    rims = [bar(s, 0.01, 0.03, (0, t * 0.095, 0)) for t in (-1, 1)] + [
        bar(0.01, s, 0.03, (t * 0.095, 0, 0)) for t in (-1, 1)
    ]
    walls = []
    for x, y, u, v in ((-0.05, 0.05, 0.08, 0.006), (0.03, 0.06, 0.006, 0.06), (0.055, 0.01, 0.07,
    0.006), (-0.06, -0.01, 0.006,
                       0.07), (-0.02, -0.03, 0.07, 0.006), (0.04, -0.055, 0.006, 0.06), (-0.03,
                       -0.07, 0.06, 0.006)):  # fmt: skip
        walls.append(bar(u, v, 0.012, (x, y, 0.007)))
    holes = [
        disc(0.0085, 0.0006, (x, y, 0.0078), fine=14)
        for x, y in (
            (-0.07, 0.075),
            (0.0, 0.02),
            (0.07, 0.04),
            (0.07, -0.07),
            (-0.035, -0.05),
            (0.01, -0.06),
            (-0.08, 0.02),
        )
    ]
    marble = ball(0.014, 0.014, 0.014, (-0.03, 0.025, 0.0148), 12)
    wood = look.surface(color, "wood")
    return put_down(
        [
            (floor, textures.wood(look.rng, (226, 196, 150))),
            (join(rims), wood),
            (join(walls), plain(tint_color(color, 0.7))),
            (join(holes), plain((24, 22, 20))),
            (marble, steel(look)),
        ],
        floor,
        *rims,
        join(walls[:1]),
        factor=k,
    )


def wind_turbine(look: Look) -> Shape:
    """A white wind turbine on a green foot."""
    color = look.color("white", "silver", "sky")
    k = look.between(0.8, 1.15)
    base = disc(0.045, 0.01, bevel=0.003)
    mast = disc(0.0075, 0.17, (0, 0, 0.008), top=0.0045)
    pod = bar(0.014, 0.036, 0.014, (0, 0.002, 0.172))
    hub = ball(0.014, 0.018, 0.014, (0, -0.018, 0.179), 12)
    turn = look.between(0, 2)
    blades = []
    for n in range(3):
        rim = [(-0.003, 0.0), (0.006, 0.012), (0.008, 0.025), (0.001, 0.085), (-0.002, 0.085)]
        blades.append(
            facing(cut(rim, 0.003)).turn(1, turn + n * 2 * np.pi / 3).move(0, -0.019, 0.179)
        )
    return put_down(
        [
            (base, plain(look.own_color("green", "lime", "tan"))),
            (join([mast, pod, hub, *blades]), plain(color)),
        ],
        base,
        mast,
        pod,
        *blades,
        factor=k,
    )


def zoetrope(look: Look) -> Shape:
    """A slotted drum on a foot, with a strip of pictures inside."""
    color = look.color("black", "red", "navy", "wooden")
    k = look.between(0.85, 1.15)
    foot = turned([(0.045, 0), (0.045, 0.008), (0.012, 0.018), (0.009, 0.06)], fine=24)
    floor = disc(0.075, 0.006, (0, 0, 0.058), fine=32)
    band = lathe([(0.075, 0.058), (0.075, 0.1), (0.071, 0.1), (0.071, 0.058)], 32, loop=True)
    slats = [bar(0.004, 0.026, 0.05, (0.073, 0, 0.099)).turn(2, n * np.pi / 6) for n in range(12)]
    ring = torus(0.073, 0.003, 32, 6).move(z=0.149)
    strip = prints.canvas(256, 32, (246, 238, 214))
    for n in range(16):
        prints.disc(strip, (n + 0.5) / 16, 0.5 + 0.2 * np.sin(n * 0.8), 0.2, (60, 50, 46))
    inner = lathe([(0.0708, 0.064), (0.0708, 0.098), (0.07, 0.098), (0.07, 0.064)], 32, loop=True)
    return put_down(
        [(join([foot, floor, band, *slats, ring]), look.surface(color, "plastic")), (inner, strip)],
        foot,
        join([band, ring]),
        factor=k,
    )


def glider(look: Look) -> Shape:
    """A glider of thin balsa wood on its keel."""
    color = look.color("tan", "wooden", "cream")
    k = look.between(0.8, 1.15)
    body = facing(
        cut([(-0.12, 0.012), (0.11, 0.004), (0.125, 0.012), (0.11, 0.022), (-0.12, 0.018)], 0.005)
    ).move(y=0.0025)
    wing = cut(
        [(0.055, 0), (0.045, 0.13), (0.02, 0.13), (0.01, 0), (0.02, -0.13), (0.045, -0.13)][::-1],
        0.0025,
        (0, 0, 0.022),
    )
    tail = cut(
        [(-0.085, 0), (-0.092, 0.05), (-0.115, 0.05), (-0.12, 0), (-0.115, -0.05), (-0.092, -0.05)][
            ::-1
        ],
        0.002,
        (0, 0, 0.018),
    )
    fin = facing(
        cut([(-0.122, 0.018), (-0.085, 0.018), (-0.11, 0.055), (-0.122, 0.055)], 0.002)
    ).move(y=0.001)
    skid = bar(0.12, 0.03, 0.004, (0.02, 0, 0.0))
    marks = [disc(0.012, 0.0006, (0.032, s * 0.1, 0.0243)) for s in (-1, 1)]
    return put_down(
        [
            (join([body, wing, tail, fin]), textures.wood(look.rng, color)),
            (skid, plain(tint_color(color, 0.7))),
            (join(marks), plain(look.own_color("red", "blue", "green"))),
        ],
        skid,
        body,
        wing,
        tail,
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
    Category("periscope", periscope, (0.0544, 0.0952, 0.245), 0.2, ("toy periscope",), ("toys",),
             ("tall",), ("blue", "red")),
    Category("diabolo", diabolo, (0.105, 0.105, 0.117), 0.15, ("chinese yoyo",), ("toys",), (),
             ("red", "blue")),
    Category("cup_and_ball", cup_and_ball, (0.12, 0.0704, 0.129), 0.12,
             ("cup-and-ball", "cup-and-ball toy", "cup and ball toy", "bilboquet", "kendama",
             "ball and cup"), ("toys",), ("tall",),
             ("wooden",)),
    Category("marble_maze", marble_maze, (0.192, 0.192, 0.0288), 0.5,
             ("labyrinth", "ball maze", "labyrinth game", "wooden maze", "maze", "maze game"),
             ("toys", "games"), ("big",), ("wooden",)),
    Category("wind_turbine", wind_turbine, (0.14, 0.0876, 0.239), 0.12,
             ("wind turbine model", "model wind turbine", "toy wind turbine",
             "windmill"), ("toys",), ("tall",), ("white",)),
    Category("zoetrope", zoetrope, (0.151, 0.151, 0.15), 0.3, ("praxinoscope", "stroboscope",
             "phenakistoscope"), ("toys",), (), ("black",)),
    Category("glider", glider, (0.241, 0.254, 0.0537), 0.02,
             ("balsa glider", "toy glider", "balsa plane", "wooden glider", "balsa wood glider",
             "model glider"), ("toys",), ("big",), ("tan",)),
)  # fmt: skip
"""The module's categories."""
