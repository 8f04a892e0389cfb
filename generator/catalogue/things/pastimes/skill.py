"""Toys of skill and wonder: tops on strings, mazes, windmills, gliders."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.forms import facing
from ...build.making import at_box, drum, plate, standing, steel
from ...build.recipes import ball, put_down, rod
from ...build.shape import Shape
from ...build.solids import block, join, lathe, torus
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def periscope(look: Look) -> Shape:
    """A toy periscope: a square tube with a mirror window at either end."""
    color = look.color("blue", "red", "gray", "green", "yellow")
    k = look.between(0.8, 1.1)
    trunk = block(0.05, 0.05, 0.23, 0.004)
    top, low = at_box(0.052, 0.07, 0.052, (0, -0.01, 0.2)), at_box(0.056, 0.08, 0.05, (0, 0.01, 0))
    window = at_box(0.04, 0.002, 0.038, (0, -0.0455, 0.207))
    eye = at_box(0.034, 0.002, 0.03, (0, 0.0505, 0.01))
    bands = [at_box(0.053, 0.053, 0.006, (0, 0, z)) for z in (0.06, 0.19)]
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
    axle = drum(0.006, 0.008, (0, 0, 0.0745))
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
    stem = standing(
        (0.026, 0),
        (0.026, 0.006),
        (0.009, 0.016),
        (0.008, 0.08),
        (0.012, 0.09),
        (0.026, 0.1),
        (0.034, 0.125),
        (0.03, 0.125),
        (0.022, 0.106),
        sides=24,
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
    floor, s = at_box(0.2, 0.2, 0.008), 0.2
    rims = [at_box(s, 0.01, 0.03, (0, t * 0.095, 0)) for t in (-1, 1)] + [
        at_box(0.01, s, 0.03, (t * 0.095, 0, 0)) for t in (-1, 1)
    ]
    walls = []
    for x, y, u, v in ((-0.05, 0.05, 0.08, 0.006), (0.03, 0.06, 0.006, 0.06), (0.055, 0.01, 0.07,
    0.006), (-0.06, -0.01, 0.006,
                       0.07), (-0.02, -0.03, 0.07, 0.006), (0.04, -0.055, 0.006, 0.06), (-0.03,
                       -0.07, 0.06, 0.006)):  # fmt: skip
        walls.append(at_box(u, v, 0.012, (x, y, 0.007)))
    holes = [
        drum(0.0085, 0.0006, (x, y, 0.0078), sides=14)
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
    base = drum(0.045, 0.01, bevel=0.003)
    mast = drum(0.0075, 0.17, (0, 0, 0.008), top=0.0045)
    pod = at_box(0.014, 0.036, 0.014, (0, 0.002, 0.172))
    hub = ball(0.014, 0.018, 0.014, (0, -0.018, 0.179), 12)
    turn = look.between(0, 2)
    blades = []
    for n in range(3):
        rim = [(-0.003, 0.0), (0.006, 0.012), (0.008, 0.025), (0.001, 0.085), (-0.002, 0.085)]
        blades.append(
            facing(plate(rim, 0.003)).turn(1, turn + n * 2 * np.pi / 3).move(0, -0.019, 0.179)
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
    foot = standing((0.045, 0), (0.045, 0.008), (0.012, 0.018), (0.009, 0.06), sides=24)
    floor = drum(0.075, 0.006, (0, 0, 0.058), sides=32)
    band = lathe([(0.075, 0.058), (0.075, 0.1), (0.071, 0.1), (0.071, 0.058)], 32, loop=True)
    slats = [
        at_box(0.004, 0.026, 0.05, (0.073, 0, 0.099)).turn(2, n * np.pi / 6) for n in range(12)
    ]
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
        plate([(-0.12, 0.012), (0.11, 0.004), (0.125, 0.012), (0.11, 0.022), (-0.12, 0.018)], 0.005)
    ).move(y=0.0025)
    wing = plate(
        [(0.055, 0), (0.045, 0.13), (0.02, 0.13), (0.01, 0), (0.02, -0.13), (0.045, -0.13)][::-1],
        0.0025,
        at=(0, 0, 0.022),
    )
    tail = plate(
        [(-0.085, 0), (-0.092, 0.05), (-0.115, 0.05), (-0.12, 0), (-0.115, -0.05), (-0.092, -0.05)][
            ::-1
        ],
        0.002,
        at=(0, 0, 0.018),
    )
    fin = facing(
        plate([(-0.122, 0.018), (-0.085, 0.018), (-0.11, 0.055), (-0.122, 0.055)], 0.002)
    ).move(y=0.001)
    skid = at_box(0.12, 0.03, 0.004, (0.02, 0, 0.0))
    marks = [drum(0.012, 0.0006, (0.032, s * 0.1, 0.0243)) for s in (-1, 1)]
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
