"""Amplifiers, tuners, players, batons and other gear of musicians."""

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
    plastic,
    shine,
    spindle,
    wood,
    words,
)
from ...build.recipes import Pieces, ball, rod, straight
from ...build.solids import join, tube
from ...surfaces import prints, screens, textures
from ...surfaces.look import Look


def _string(look: Look) -> Pieces:
    """A string coiled up in rings."""
    tile = metal(look, "silver", "bronze", "gold")
    a = np.linspace(0, 2 * np.pi * 6, 200)
    r = 0.05 + 0.0016 * np.sin(1.7 * a)
    coil = tube(
        np.column_stack([r * np.cos(a), r * np.sin(a), 0.0008 + 0.0006 * (a / a[-1]) * 5]),
        0.0007,
        4,
    )
    tail = tube([(0.05, 0, 0.003), (0.075, 0.012, 0.001), (0.09, 0.0, 0.0009)], 0.0007, 4)
    ball_end = disc(0.002, 0.0035, (0.0905, 0, 0), sides=10)
    return [(coil, tile), (join([tail, ball_end]), shine(look, "brass"))]


def _pedal(look: Look) -> Pieces:
    """An effects pedal: knobs, a light and a foot switch on a metal box."""
    color = look.color("orange", "green", "yellow", "blue", "silver", "purple")
    body = at_block(0.075, 0.125, 0.045, 0.006)
    name = prints.canvas(64, 32, color)
    prints.write(
        name, look.pick(["DRIVE", "DELAY", "FUZZ", "CHORUS"]), 0.5, 0.5, 0.5, (26, 26, 28), True
    )
    tag = at_box(0.06, 0.026, 0.0008, (0, 0.0, 0.0446))
    knobs = [disc(0.009, 0.014, (x, 0.042, 0.044)) for x in (-0.022, 0, 0.022)]
    marks = [at_box(0.0015, 0.008, 0.0008, (x, 0.045, 0.0577)) for x in (-0.022, 0, 0.022)]
    switch = [disc(0.011, 0.004, (0, -0.038, 0.045)), disc(0.006, 0.014, (0, -0.038, 0.045))]
    lamp = ball(0.006, 0.006, 0.006, (0, 0.022, 0.046), 10)
    jacks = [straight((s * 0.037, 0.01, 0.022), (s * 0.044, 0.01, 0.022), 0.006) for s in (-1, 1)]
    return [(body, look.surface(color, "metal")), (join(knobs), dye(look, "black", "cream")),
            (join(switch), shine(look)), (tag, name), (join(marks), textures.plain((240, 240,
             236))),
            (lamp, textures.plain((230, 40, 40))), (join(jacks), shine(look))]  # fmt: skip


def _amp(look: Look) -> Pieces:
    """A guitar amplifier: a cloth front, a row of knobs, a handle."""
    shell = plastic(look, "black", "cream", "brown", "charcoal", "red")
    body = at_block(0.26, 0.14, 0.24, 0.012)
    grille = textures.fabric(look.rng, look.own_color("charcoal", "gray", "tan", "black"),
                             look.own_color("gray", "charcoal"))  # fmt: skip
    front = at_box(0.235, 0.004, 0.165, (0, -0.071, 0.016))
    panel = at_box(0.235, 0.004, 0.036, (0, -0.071, 0.192))
    knobs = [
        disc(0.009, 0.012).turn(0, np.pi / 2).move(x, -0.072, 0.21)
        for x in np.linspace(-0.09, 0.06, 6)
    ]
    lamp = ball(0.009, 0.006, 0.009, (0.095, -0.074, 0.21), 10)
    name = at_box(0.06, 0.002, 0.018, (0, -0.073, 0.155))
    handle = rod(
        [(-0.06, 0, 0.238), (-0.05, 0, 0.262), (0.05, 0, 0.262), (0.06, 0, 0.238)], 0.006, 8
    )
    return [(body, shell), (handle, dye(look, "black")), (front, grille), (panel, shine(look,
             "gold", "silver")),
            (join(knobs), dye(look, "black", "cream")), (lamp, textures.plain((220, 40, 36))),
            (name, words("AMP", (24, 24, 26), (230, 230, 226), 0.6))]  # fmt: skip


def _baton(look: Look) -> Pieces:
    grip = spindle((-0.16, 0.004), (-0.155, 0.008), (-0.14, 0.009), (-0.12, 0.004), z=0.0085)
    stick = spindle((-0.122, 0.0022), (0.19, 0.0012), z=0.0085).turn(1, 0.022).move(z=0.0)
    rest = ball(0.02, 0.02, 0.017, (-0.145, 0, 0.0085), 12)
    return [(rest, wood(look, "brown", "wooden", "maroon")), (grip, dye(look, "brown", "wooden")),
            (stick, plastic(look, "white", "cream"))]  # fmt: skip


def _beater(look: Look) -> Pieces:
    """A thin metal rod with a rubber grip."""
    return [(spindle((-0.1, 0.003), (0.06, 0.003), z=0.0055), metal(look, "silver", "gray")),
            (spindle((0.02, 0.0045), (0.03, 0.0056), (0.095, 0.0056), (0.1, 0.0045), z=0.0055),
             dye(look, "red", "black", "blue"))]  # fmt: skip


def _theremin(look: Look) -> Pieces:
    tile = wood(look, "brown", "wooden", "black")
    body = at_block(0.22, 0.11, 0.06, 0.012)
    rodded = straight((0.095, 0, 0.055), (0.095, 0, 0.28), 0.0035, 8)
    path = [
        (-0.1, -0.03, 0.045),
        (-0.15, -0.03, 0.045),
        (-0.185, 0.0, 0.045),
        (-0.15, 0.03, 0.045),
        (-0.1, 0.03, 0.045),
    ]
    loop = rod(path, 0.0035, 8, 5)
    knobs = [
        disc(0.009, 0.012).turn(0, np.pi / 2).move(x, -0.056, 0.03)
        for x in (-0.06, -0.02, 0.02, 0.06)
    ]
    return [
        (body, tile),
        (rodded, shine(look)),
        (loop, shine(look)),
        (join(knobs), dye(look, "black")),
    ]


def _portable(look: Look) -> Pieces:
    """A personal cassette or disc player: a window, buttons, a cord to earphones."""
    shell = plastic(look, "blue", "silver", "yellow", "red", "charcoal")
    body = at_block(0.09, 0.118, 0.03, 0.008)
    image = prints.canvas(64, 48, (32, 34, 40))
    for x in (0.3, 0.7):
        prints.disc(image, x, 0.5, 0.2, (230, 228, 220))
        prints.disc(image, x, 0.5, 0.1, (40, 40, 44))
    prints.fill(image, 0.1, 0.82, 0.8, 0.08, (214, 120, 60))
    window = at_box(0.064, 0.05, 0.0008, (0, 0.006, 0.0297))
    keys = [
        at_block(0.014, 0.008, 0.004, 0.002, (-0.03 + 0.02 * k, -0.046, 0.0285)) for k in range(4)
    ]
    label = at_box(0.05, 0.012, 0.0008, (0, 0.045, 0.0297))
    return [(body, shell), (window, image), (join(keys), dye(look, "charcoal", "silver", "orange")),
            (label, words("STEREO", (36, 38, 44), (230, 230, 226), 0.6))]  # fmt: skip


def _ipod(look: Look) -> Pieces:
    shell = plastic(look, "white", "silver", "black", "pink", "blue", "green")
    body = at_block(0.052, 0.092, 0.009, 0.007)
    face = textures.fit(screens.apps(look.rng), 64, 64)
    wheel = disc(0.018, 0.0008, (0, -0.02, 0.0086))
    hub = disc(0.0065, 0.001, (0, -0.02, 0.0088))
    return [(body, shell), (at_box(0.042, 0.034, 0.0006, (0, 0.023, 0.0087)), face),
            (wheel, textures.plain((206, 208, 212))), (hub, shell)]  # fmt: skip


CATEGORIES = (
    Category("guitar_string", of(_string), (0.145, 0.103, 0.0046), 0.005, ("guitar strings",
             "set of strings", "violin string", "coil of string", "bass string"), ("living",),
             ("flat",), ("silver",), state="lying"),
    Category("guitar_pedal", of(_pedal), (0.088, 0.125, 0.059), 0.4, ("effects pedal",
             "effect pedal",
             "stompbox", "distortion pedal", "fuzz pedal", "loop pedal", "foot pedal"), ("living",),
             (), ("orange", "green")),
    Category("amplifier", of(_amp, bodies=2), (0.268, 0.159, 0.28), 4.0, ("guitar amplifier",
             "guitar amp", "amp", "practice amp", "bass amp", "combo amp"), ("living",), ("big",),
             ("black",)),
    Category("baton", of(_baton, 0.15), (0.35, 0.02, 0.017), 0.02, ("conductor baton",
             "conducting baton", "conductor stick"), ("living",), (), ("white",), state="lying"),
    Category("triangle_beater", of(_beater, 0.15), (0.2, 0.011, 0.011), 0.03, ("beater",
             "triangle striker", "striker", "beater of a triangle", "drumstick of a triangle",
             "triangle stick"), ("living",), (), ("silver",), state="lying"),
    Category("theremin", of(_theremin), (0.302, 0.124, 0.283), 1.5, (), ("living",), ("tall",
             "big"),
             ("brown",)),
    Category("walkman", of(_portable, bodies=1), (0.09, 0.118, 0.0325), 0.25, ("cassette walkman",
             "portable cassette player", "discman", "voice recorder"), ("living",),
             ("flat",), ("blue", "silver"), state="lying"),
    Category("mp3_player", of(_ipod, bodies=1), (0.052, 0.092, 0.0098), 0.06, ("ipod", "mp3",
             "music player", "media player", "ipod nano", "ipod classic"), ("living",), ("flat",),
             ("white", "silver"), state="lying"),
)  # fmt: skip
"""The module's categories."""
