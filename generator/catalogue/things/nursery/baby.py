"""What babies use: rattles, dummies, bottles, bibs."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part
from ...build.outlines import ellipse
from ...build.recipes import Pieces, ball, pad, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import block, cylinder, join, lathe, prism, torus
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look

SOFT = ("sky", "pink", "mint", "lavender", "yellow", "teal", "coral", "orange")


def rattle(look: Look) -> Shape:
    """A baby rattle lying: a ball with bands, a handle, a ring at its end."""
    color = look.color(*SOFT)
    other = textures.plain(look.own_color(*SOFT))
    head = ball(0.052, 0.052, 0.052, (-0.045, 0, 0.0245), 18)
    band = cylinder(0.0268, 0.012, 20).move(z=-0.006).turn(1, np.pi / 2).move(-0.045, 0, 0.0245)
    grip = straight((-0.024, 0, 0.02), (0.045, 0, 0.011), [0.008, 0.006], 10)
    ring = torus(0.02, 0.006, 22, 8).move(0.064, 0, 0.0058)
    pieces: Pieces = [(head, textures.speckles(look.rng, color, 4)), (band, other), (ring, other),
                      (grip, textures.plain((246, 244, 238)))]  # fmt: skip
    return put_down(pieces, head, grip, ring, factor=look.between(0.9, 1.12))


def pacifier(look: Look) -> Shape:
    """A dummy lying on its shield, its teat up, its ring at the side."""
    color = look.color(*SOFT)
    outline = ellipse(0.046, 0.036, 24) * (1 + 0.12 * np.abs(np.cos(np.linspace(0, 2 * np.pi, 24,
                                           endpoint=False))))[:, None]  # fmt: skip
    shield = prism(outline, 0, 0.005, 0.0).move(z=0.008)
    knob = cylinder(0.011, 0.009, 18)
    ring = torus(0.013, 0.0028, 20, 8).turn(0, np.pi / 2).turn(0, np.pi / 2 - 0.15)
    ring = ring.move(0, -0.016, 0.0045)
    teat = lathe([(0, 0), (0.006, 0), (0.005, 0.008), (0.009, 0.018), (0.008, 0.025), (0, 0.028)],
                 18).move(z=0.013)  # fmt: skip
    pieces: Pieces = [(shield, textures.speckles(look.rng, color, 4)),
                      (join([knob, ring]), textures.plain(tint_color(color, 1.4))),
                      (teat, textures.plain((232, 206, 160)))]  # fmt: skip
    return put_down(pieces, join([shield, knob]), ring, teat, factor=look.between(0.95, 1.15))


def baby_bottle(look: Look) -> Shape:
    """A baby's bottle of milk with a ring and a teat."""
    r, h = look.between(0.027, 0.032), look.between(0.1, 0.13)
    color = look.color(*SOFT)
    milk = lathe([(0, 0), (0.94 * r, 0), (r, 0.006), (r, 0.62 * h), (0, 0.62 * h)], 26)
    top = lathe([(0, 0.62 * h), (r, 0.62 * h), (r, 0.9 * h), (0.8 * r, h), (0, h)], 26)
    ring = cylinder(0.88 * r, 0.018, 26, bevel=0.002).move(z=h - 0.001)
    teat = lathe([(0, 0), (0.6 * r, 0), (0.5 * r, 0.01), (0.22 * r, 0.018), (0.2 * r, 0.028),
                  (0, 0.031)], 18).move(z=h + 0.016)  # fmt: skip
    marks = join([cylinder(1.006 * r, 0.0012, 26).move(z=z * h) for z in (0.2, 0.32, 0.44, 0.56)])
    pieces: Pieces = [
        (milk, textures.plain((250, 248, 240))),
        (top, textures.plain((222, 232, 238))),
        (ring, textures.speckles(look.rng, color, 3)),
        (marks, textures.plain(color)),
        (teat, textures.plain((232, 206, 160))),
    ]
    return put_down(pieces, join([milk, top]), ring, teat)


def bib(look: Look) -> Shape:
    """A baby's bib lying flat, a picture on it."""
    color = look.color("white", *SOFT)
    other = look.own_color("red", "blue", "teal", "orange", "purple")
    a = np.linspace(-1.15, np.pi + 1.15, 24)
    outer = np.column_stack([0.09 * np.cos(a), 0.1 * np.sin(a) * -1.0])
    inner = np.column_stack([0.045 * np.cos(a), 0.045 * np.sin(a) * -1.0 + 0.038])
    outline = np.concatenate([outer, inner[::-1]])
    image = prints.canvas(96, 96, color)
    prints.disc(image, 0.5, 0.75, 0.16, other)
    for s in (-1, 1):
        prints.disc(image, 0.5 + s * 0.13, 0.6, 0.07, other)
        prints.disc(image, 0.5 + s * 0.06, 0.73, 0.02, (30, 30, 32))
    prints.disc(image, 0.5, 0.8, 0.06, tint_color(other, 1.6))
    cloth = prism(outline[::-1], 0, 0.004)
    rim = rod(np.column_stack([outer, np.full(24, 0.003)])[::2], 0.003, 6, 2)
    factor = look.between(0.95, 1.2)
    made = shape([(cloth, image), (rim, textures.plain(other))],
                 [box_part(0.14, 0.09, 0.004, (0, -0.05, 0)), box_part(0.03, 0.08, 0.004,
                  (-0.06, 0.02, 0)), box_part(0.03, 0.08, 0.004, (0.06, 0.02, 0))])  # fmt: skip
    return made.scale(factor)


def play_dough(look: Look) -> Shape:
    """A tub of play dough, its lid in the colour of the dough."""
    r, h = look.between(0.03, 0.036), look.between(0.055, 0.068)
    color = look.color("red", "blue", "yellow", "green", "pink", "orange", "purple")
    image = prints.canvas(192, 64, look.pick([(250, 236, 120), (246, 246, 244), (120, 200, 236)]))
    for k in range(8):
        prints.disc(image, k / 8 + 0.03, 0.2 + 0.6 * (k % 2), 0.12, look.own_color(*SOFT))
    prints.fill(image, 0.32, 0.24, 0.36, 0.52, color)
    prints.write(image[:, 62:130], look.pick(["DOUGH", "PLAY", "FUN"]), 0.5, 0.5, 0.4,
                 readable_on(color), bold=True)  # fmt: skip
    tub = lathe([(0, 0), (0.94 * r, 0), (0.96 * r, h), (0, h)], 28, v=[0, 0, 1, 1])
    lid = cylinder(r, 0.014, 28, bevel=0.002).move(z=h - 0.004)
    button = cylinder(0.8 * r, 0.0015, 26).move(z=h + 0.0095)
    return shape(
        [
            (tub, image),
            (lid, textures.speckles(look.rng, color, 3)),
            (button, textures.plain(tint_color(color, 1.2))),
        ],
        [cylinder_part(0.95 * r, h), cylinder_part(r, 0.014, (0, 0, h - 0.004))],
    )


def diaper(look: Look) -> Shape:
    """A folded nappy with tapes and a printed band."""
    color = look.color("white", "white", "mint", "sky", "pink", "yellow")
    cloth = textures.fabric(look.rng, color)
    pads = [pad(0.16, 0.1, 0.016, 0.03, soft=0.5).move(z=0.013 * n) for n in range(2)]
    band = block(0.15, 0.022, 0.0014, 0.004).move(0, 0.032, 0.0285)
    image = prints.canvas(128, 24, tint_color(color, 1.1))
    for k in range(7):
        prints.disc(image, (k + 0.5) / 7, 0.5, 0.3, look.own_color(*SOFT))
    tapes = [block(0.03, 0.02, 0.0016, 0.006).move(s * 0.066, 0.032, 0.0292) for s in (-1, 1)]
    pieces: Pieces = [(join(pads), cloth), (band, image), (join(tapes), textures.plain((240, 240,
                      236)))]  # fmt: skip
    return put_down(pieces, join(pads), factor=look.between(0.9, 1.15))


def baby_shoes(look: Look) -> Shape:
    """A pair of knitted baby shoes with bows, toes to the front."""
    color = look.color(*SOFT, "white")
    knit = textures.knitting(look.rng, color, 16)
    bow = textures.plain(look.own_color("white", "red", "navy", "gold"))
    shoes, bows, hulls = [], [], []
    for s in (-1, 1):
        foot = ball(0.05, 0.1, 0.05, (s * 0.032, 0, 0.02), 18)
        cuff = lathe([(0, 0.03), (0.022, 0.03), (0.026, 0.062), (0.02, 0.066), (0.017, 0.05),
                      (0, 0.05)], 18).move(s * 0.032, 0.022)  # fmt: skip
        shoes += [foot, cuff]
        hulls += [foot, cuff]
        loops = [ball(0.016, 0.006, 0.01, (s * 0.032 + t * 0.008, -0.012, 0.047), 8)
                 for t in (-1, 1)]  # fmt: skip
        bows += [*loops, ball(0.007, 0.007, 0.007, (s * 0.032, -0.014, 0.047), 8)]
    return put_down([(join(shoes), knit), (join(bows), bow)], *hulls, factor=look.between(0.9, 1.1))


def doll(look: Look) -> Shape:
    """A doll in a dress, sitting with its legs to the front, or a rag doll with yarn hair."""
    color = look.color("red", "pink", "blue", "yellow", "lavender", "green", "teal")
    skin = textures.plain(
        look.pick([(244, 206, 178), (226, 176, 140), (150, 100, 70), (98, 66, 48)])
    )
    tone = look.pick([(70, 44, 30), (34, 28, 28), (206, 160, 80), (170, 80, 40)])
    hair = textures.scratches(look.rng, tone, tint_color(tone, 0.7), 70)
    dress = textures.fabric(look.rng, color, look.pick([None, (250, 248, 244)]), 20)
    gown = lathe([(0, 0), (0.05, 0), (0.047, 0.012), (0.03, 0.045), (0.021, 0.082), (0, 0.086)], 20)
    head = ball(0.052, 0.05, 0.054, (0, -0.001, 0.112), 18)
    cap = ball(0.058, 0.052, 0.05, (0, 0.006, 0.12), 18)
    locks = [ball(0.022, 0.022, 0.04, (s * 0.031, 0.002, 0.1), 10) for s in (-1, 1)]
    arms = [rod([(s * 0.018, 0, 0.076), (s * 0.037, -0.006, 0.056), (s * 0.044, -0.014, 0.036)],
                [0.009, 0.007, 0.006], 8) for s in (-1, 1)]  # fmt: skip
    hands = [ball(0.014, 0.014, 0.016, (s * 0.044, -0.015, 0.032), 8) for s in (-1, 1)]
    legs = [rod([(s * 0.017, -0.02, 0.011), (s * 0.018, -0.055, 0.01), (s * 0.019, -0.076, 0.01)],
                0.0095, 8) for s in (-1, 1)]  # fmt: skip
    shoes = [ball(0.02, 0.02, 0.026, (s * 0.019, -0.082, 0.011), 10) for s in (-1, 1)]
    eyes = [ball(0.007, 0.004, 0.008, (s * 0.01, -0.0248, 0.115), 8) for s in (-1, 1)]
    mouth = ball(0.012, 0.004, 0.004, (0, -0.0235, 0.102), 8)
    cheeks = [ball(0.009, 0.003, 0.007, (s * 0.016, -0.0212, 0.106), 8) for s in (-1, 1)]
    collar = torus(0.018, 0.005, 18, 6).move(z=0.086)
    pieces: Pieces = [(gown, dress), (join(arms), dress), (join([head, *hands, *legs]), skin),
                      (join([cap, *locks]), hair), (join(eyes), textures.plain((36, 44, 60))),
                      (join([mouth, *cheeks]), textures.plain((220, 96, 96))),
                      (collar, textures.plain((250, 248, 244))),
                      (join(shoes), textures.plain(tint_color(color, 0.55)))]  # fmt: skip
    return put_down(pieces, gown, join([*legs, *shoes]), join([head, cap]), *arms,
                   factor=look.between(1.0, 1.35))  # fmt: skip


CATEGORIES = (
    Category("rattle", rattle, (0.163, 0.053, 0.051), 0.05, ("baby rattle", "toy rattle",
             "rattle toy", "teether", "baby gym toy", "car seat toy"), ("toys",), (), ("sky",
             "pink"), state="lying flat"),
    Category("pacifier", pacifier, (0.054, 0.055, 0.043), 0.02, ("dummy", "baby pacifier",
             "soother", "baby dummy"), ("toys",), (), ("sky", "pink"), state="lying flat"),
    Category("baby_bottle", baby_bottle, (0.059, 0.059, 0.161), 0.25, ("feeding bottle",
             "nursing bottle", "baby milk bottle", "infant bottle", "bottle teat",
             "bottle warmer", "breast pump", "bottle steriliser", "nasal aspirator"), ("toys",),
             ("tall", "round"),
             ("sky", "pink")),
    Category("bib", bib, (0.2, 0.21, 0.007), 0.03, ("baby bib",), ("toys",), ("flat",),
             ("white", "sky"), state="lying flat"),
    Category("play_dough", play_dough, (0.066, 0.066, 0.072), 0.13, ("play dough tub", "play-doh",
             "playdough", "tub of play dough", "modelling clay", "modeling clay", "plasticine",
             "play doh", "magnetic putty", "polymer clay block", "block of modelling clay",
             "lump of clay", "putty tub", "clay", "tub of play-doh", "tub of play doh",
             "play doh tub", "pot of play-doh"), ("toys",),
             ("round",), ("red", "blue")),
    Category("diaper", diaper, (0.165, 0.103, 0.031), 0.04, ("nappy", "baby diaper",
             "folded diaper", "folded nappy",
             "bedpan pad"), ("toys",), ("flat",), ("white",),
             state="lying folded"),
    Category("baby_shoes", baby_shoes, (0.114, 0.1, 0.066), 0.06, ("baby shoe", "bootie",
             "baby bootie", "pair of baby shoes", "baby booties", "baby bootee", "bootee",
             "booties"), ("toys",), (), ("pink",
             "sky")),
    Category("doll", doll, (0.118, 0.15, 0.17), 0.16, ("toy doll", "rag doll", "baby doll",
             "cloth doll", "dolly", "fabric doll", "porcelain doll", "elf on the shelf",
             "scarecrow figure", "scarecrow", "barbie", "barbie doll", "squeaky doll"), ("toys",),
             (), ("pink",
             "blue"), state="sitting"),
)  # fmt: skip
"""The module's categories."""
