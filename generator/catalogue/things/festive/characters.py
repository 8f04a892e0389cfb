"""Christmas figures that stand: Santa, snowmen, nutcrackers."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.recipes import Pieces, ball, put_down, rod
from ...build.shape import Shape
from ...build.solids import Solid, box, cylinder, join, lathe, torus
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

DARK = textures.plain((34, 32, 34))
GOLD = (222, 180, 80)


def _trunk(color: RGB, look: Look) -> tuple[Solid, Pieces]:
    """Return a round figure's coat (hull) with trim, belt and buttons."""
    coat = lathe([(0, 0), (0.036, 0), (0.04, 0.014), (0.03, 0.056), (0.018, 0.078), (0, 0.082)], 22)
    trim = torus(0.037, 0.0055, 24, 8).move(z=0.0075)
    belt = torus(0.0372, 0.0045, 24, 6).scale(1, 1, 1.2).move(z=0.03)
    buckle = box(0.014, 0.004, 0.012).move(0, -0.0405, 0.024)
    return coat, [(coat, textures.speckles(look.rng, color, 5)), (trim, textures.plain((246, 244,
                   240))), (belt, DARK), (buckle, textures.plain(GOLD))]  # fmt: skip


def santa(look: Look) -> Shape:
    """A Santa Claus figure: red coat, white beard, pointed hat, a sack on his back."""
    color = look.color("red", "red", "crimson", "maroon")
    coat, pieces = _trunk(color, look)
    white = textures.spots(look.rng, (248, 246, 242), (228, 226, 222), 0.2)
    skin = textures.plain(look.pick([(240, 196, 168), (206, 150, 112), (130, 86, 60)]))
    head = ball(0.036, 0.035, 0.036, (0, -0.001, 0.09), 16)
    beard = join(
        [
            ball(0.034, 0.024, 0.038, (0, -0.012, 0.076), 14),
            *[ball(0.017, 0.01, 0.008, (s * 0.007, -0.0195, 0.0865), 8) for s in (-1, 1)],
        ]
    )
    nose = ball(0.009, 0.009, 0.008, (0, -0.02, 0.0915), 8)
    eyes = [ball(0.005, 0.003, 0.005, (s * 0.007, -0.0175, 0.097), 8) for s in (-1, 1)]
    brim = torus(0.0165, 0.0052, 20, 8).move(z=0.104)
    hat = rod([(0, 0, 0.102), (0.002, 0.002, 0.124), (0.016, 0.006, 0.138), (0.026, 0.006, 0.132)],
              [0.0165, 0.011, 0.006, 0.003], 12)  # fmt: skip
    bob = ball(0.012, 0.012, 0.012, (0.029, 0.006, 0.13), 8)
    arms = [rod([(s * 0.02, 0, 0.07), (s * 0.036, -0.008, 0.055), (s * 0.03, -0.026, 0.046)],
                [0.009, 0.008, 0.007], 8) for s in (-1, 1)]  # fmt: skip
    cuffs = [ball(0.017, 0.014, 0.017, (s * 0.03, -0.026, 0.046), 8) for s in (-1, 1)]
    sack = ball(0.05, 0.036, 0.06, (0.004, 0.036, 0.052), 14)
    red = textures.plain(color)
    pieces += [(head, skin), (beard, white), (nose, textures.plain((226, 130, 110))),
               (join(eyes), DARK), (join([brim, bob, *cuffs]), white), (join([hat, *arms]), red),
               (sack, textures.fabric(look.rng, (150, 108, 70)))]  # fmt: skip
    return put_down(pieces, coat, sack, join([head, brim, hat]), factor=look.between(0.9, 1.2))


def snowman(look: Look) -> Shape:
    """A snowman of two or three balls with hat, scarf and carrot."""
    color = look.color("white", "white", "ivory", "sky")
    snow = textures.speckles(look.rng, color, 4)
    tint = look.own_color("red", "blue", "green", "orange", "purple")
    low = ball(0.078, 0.076, 0.07, (0, 0, 0.032), 20)
    mid = ball(0.056, 0.055, 0.052, (0, 0, 0.083), 18)
    head = ball(0.044, 0.043, 0.042, (0, 0, 0.122), 16)
    brim, crown = cylinder(0.028, 0.003, 20).move(z=0.138), cylinder(0.018, 0.024, 20).move(z=0.139)
    band = cylinder(0.0184, 0.006, 20).move(z=0.1415)
    nose = cylinder(0.0045, 0.022, 8, top=0.0006).turn(0, np.pi / 2).move(0, -0.019, 0.12)
    coal = [ball(0.0055, 0.004, 0.0055, (s * 0.008, -0.0195, 0.128), 8) for s in (-1, 1)]
    coal += [ball(0.007, 0.005, 0.007, (0, -y, z), 8) for y, z in ((0.0275, 0.09), (0.0265, 0.075),
                                                                  (0.035, 0.05))]  # fmt: skip
    arms = [rod([(s * 0.024, 0, 0.086), (s * 0.046, -0.004, 0.098), (s * 0.062, -0.006, 0.112)],
                0.0022, 6) for s in (-1, 1)]  # fmt: skip
    scarf = torus(0.021, 0.0065, 22, 8).move(z=0.103)
    tail = box(0.013, 0.005, 0.034).turn(0, 0.2).move(0.012, -0.028, 0.07)
    knit = textures.stripes([tint, tint_color(tint, 1.6)], 6, upright=True)
    pieces: Pieces = [(join([low, mid, head]), snow), (join([brim, crown, *coal]), DARK),
                      (join([band, scarf, tail]), knit), (nose, textures.plain((236, 130, 40))),
                      (join(arms), textures.plain((96, 68, 46)))]  # fmt: skip
    return put_down(pieces, low, mid, join([head, brim, crown]), factor=look.between(0.85, 1.2))


def nutcracker(look: Look) -> Shape:
    """A nutcracker soldier: tall hat, white beard, red coat, on a round foot."""
    color = look.color("red", "blue", "green", "purple")
    coat = textures.speckles(look.rng, color, 4)
    skin = textures.plain((240, 200, 170))
    white, gold = textures.plain((246, 244, 240)), textures.plain(GOLD)
    foot = cylinder(0.03, 0.01, 24, bevel=0.002)
    legs = [cylinder(0.0095, 0.062, 14).move(s * 0.011, 0, 0.009) for s in (-1, 1)]
    boots = [cylinder(0.0108, 0.026, 14).move(s * 0.011, -0.001, 0.0095) for s in (-1, 1)]
    chest = cylinder(0.0235, 0.052, 20, top=0.026, bevel=0.002).scale(1, 0.8, 1).move(z=0.068)
    belt = cylinder(0.0252, 0.007, 20).scale(1, 0.8, 1).move(z=0.073)
    arms = [cylinder(0.008, 0.05, 12, bevel=0.002).move(s * 0.033, 0, 0.068) for s in (-1, 1)]
    pads = [ball(0.022, 0.024, 0.012, (s * 0.031, 0, 0.119), 10) for s in (-1, 1)]
    head = cylinder(0.0195, 0.036, 20, bevel=0.002).move(z=0.119)
    beard = box(0.022, 0.01, 0.026).move(0, -0.017, 0.105)
    hair = ball(0.044, 0.03, 0.034, (0, 0.01, 0.133), 14)
    hat = cylinder(0.02, 0.04, 20, top=0.023, bevel=0.002).move(z=0.154)
    peak = cylinder(0.0215, 0.004, 20).move(0, -0.004, 0.153)
    badge = ball(0.014, 0.006, 0.014, (0, -0.0205, 0.175), 10)
    buttons = [ball(0.006, 0.004, 0.006, (s * 0.008, -0.0205, z), 8) for s in (-1, 1)
               for z in (0.09, 0.102, 0.112)]  # fmt: skip
    eyes = [ball(0.006, 0.004, 0.007, (s * 0.008, -0.018, 0.142), 8) for s in (-1, 1)]
    mouth = box(0.02, 0.003, 0.009).move(0, -0.0185, 0.126)
    pieces: Pieces = [
        (join([foot, hat, *boots, peak]), textures.plain((40, 40, 48))),
        (join([chest, *arms]), coat),
        (join([*legs, beard, hair, mouth]), white),
        (join([belt, badge, *pads, *buttons]), gold),
        (head, skin),
        (join(eyes), DARK),
    ]
    return put_down(pieces, foot, join(legs), join([chest, *arms]), join([head, hat]),
                   factor=look.between(0.9, 1.25))  # fmt: skip


CATEGORIES = (
    Category("santa", santa, (0.082, 0.1, 0.148), 0.2, ("santa claus", "santa figure",
             "father christmas", "santa figurine", "saint nicholas", "santa claus figure",
             "christmas gnome", "father christmas ornament", "santa ornament", "chocolate santa"),
             ("living",), (), ("red",)),
    Category("snowman", snowman, (0.13, 0.08, 0.167), 0.15, ("snowman figure", "snow man",
             "snowman figurine", "snowman ornament"), ("living",), (), ("white",)),
    Category("nutcracker", nutcracker, (0.085, 0.062, 0.205), 0.25, ("nutcracker figure",
             "nutcracker soldier", "wooden nutcracker", "christmas nutcracker"), ("living",),
             ("tall",), ("red",)),
)  # fmt: skip
"""The module's categories."""
