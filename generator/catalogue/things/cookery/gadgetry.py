"""Small kitchen tools: funnels, sieves, lids, openers, presses, mashers, timers, cutters."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, hull_of, ring_parts
from ...build.forms import lobe
from ...build.outlines import ellipse, smooth
from ...build.settled import hull_above, limb
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, prism, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

GRIPS = ("black", "red", "teal", "white", "navy", "sage", "gray")


def _steel(look: Look) -> textures.Tile:
    return textures.brushed_metal(look.rng, (192, 195, 200))


def sieve(look: Look) -> Shape:
    """A round mesh sieve with a long handle, resting bowl down."""
    r, h = look.between(0.07, 0.09), look.between(0.045, 0.058)
    color = look.color(*GRIPS, "silver")
    t = np.linspace(0.15, np.pi / 2, 6)
    outer = [(r * np.sin(a), h * (1 - np.cos(a))) for a in t]
    inner = [(max(x - 0.0016, 0.001), max(z, 0.0016)) for x, z in outer]
    inner[0] = (outer[0][0] - 0.0016, outer[0][1] + 0.0016)
    cup = lathe([(0, 0), *outer, *inner[::-1], (0, 0.0016)], 32)
    mesh = textures.grid((122, 126, 130), (206, 209, 213), 40, 64, 128)
    rim = torus(r, 0.0034, 36, 8).move(z=h)
    bar = tube([(r, 0, h), (r + 0.03, 0, h), (r + 0.07, 0, 0.86 * h)], 0.0035, 8)
    grip = limb([(r + 0.05, 0, 0.9 * h), (r + 0.09, 0, 0.72 * h), (r + 0.16, 0, 0.2 * h),
                 (r + 0.165, 0, 0.17 * h)], [0.006, 0.0095, 0.009, 0.005], 12)  # fmt: skip
    hook = tube(smooth([(-r, -0.014, h), (-r - 0.02, 0, h), (-r, 0.014, h)], 4), 0.002, 6)
    steel = _steel(look)
    walls = ring_parts([outer[0], outer[2], outer[4], outer[5]], [inner[5], inner[2]])
    low = cylinder_part(outer[2][0] * 0.9, outer[2][1])
    return shape(
        [(cup, mesh), (join([rim, bar, hook]), steel), (grip, look.surface(color))],
        [*walls, low, cylinder_part(outer[0][0], 0.004), hull_of(grip), hull_of(hook)],
    )


def lid(look: Look) -> Shape:
    """A pot's lid of steel or glass with its knob, lying right side up."""
    r, h = look.between(0.09, 0.125), look.between(0.02, 0.032)
    color = look.color("silver", "silver", "red", "black", "blue", "copper", "white", "sage")
    body = lathe([(0, 0), (0.95 * r, 0), (r, 0.004), (r, 0.009), (0.75 * r, 0.66 * h),
                  (0.35 * r, 0.94 * h), (0, h)], 36)  # fmt: skip
    rim = lathe([(0.955 * r, 0.0005), (1.01 * r, 0.002), (1.01 * r, 0.01), (0.955 * r, 0.011)], 36,
                loop=True)  # fmt: skip
    knob = lathe([(0, 0), (0.009, 0), (0.009, 0.014), (0.02, 0.019), (0.018, 0.028),
                  (0, 0.03)], 22).move(z=h - 0.001)  # fmt: skip
    glass = look.chance(0.4)
    skin = textures.plain((178, 194, 200)) if glass else look.surface(color, "metal")
    tone = look.surface(look.own_color("black", "charcoal", "brown", "silver"), "plastic")
    return shape([(body, skin), (rim, _steel(look) if glass else skin), (knob, tone)],
                 [hull_of(body), hull_of(knob)])  # fmt: skip


def can_opener(look: Look) -> Shape:
    """A can opener lying: two handles to the right, a cutting wheel and a turning key."""
    long = look.between(0.17, 0.2)
    color = look.color(*GRIPS)
    steel, skin = _steel(look), look.surface(color, "plastic")
    arms = [limb([(-0.38 * long, s * 0.004, 0.006), (-0.1 * long, s * 0.01, 0.006),
                  (0.46 * long, s * 0.021, 0.0075), (0.5 * long, s * 0.021, 0.0075)],
                 [0.006, 0.0065, 0.0085, 0.005], 10, 0.9) for s in (-1, 1)]  # fmt: skip
    plate = block(0.06, 0.03, 0.004, 0.01).move(-0.4 * long, 0, 0.006)
    wheel = cylinder(0.011, 0.003, 24).move(-0.46 * long, 0.004, 0.0095)
    cog = lobe(cylinder(0.0075, 0.004, 36), 12, 0.2).move(-0.43 * long, -0.007, 0.0095)
    stem = cylinder(0.004, 0.012, 12).move(-0.38 * long, 0, 0.009)
    key = block(0.013, 0.05, 0.005, 0.006, 0.001).turn(2, 0.35).move(-0.38 * long, 0, 0.019)
    return shape(
        [(join(arms), skin), (join([plate, wheel, cog, stem]), steel), (key, skin)],
        [hull_above(a) for a in arms] + [hull_of(plate, wheel), hull_of(stem, key)],
    )


def garlic_press(look: Look) -> Shape:
    """A garlic press lying, its handles a little open to the right."""
    long = look.between(0.155, 0.18)
    color = look.color("silver", "silver", "red", "black", "teal")
    skin = look.surface(color, "metal")
    cup = block(0.045, 0.03, 0.03, 0.008, 0.002).move(-0.38 * long)
    holes = [cylinder(0.0016, 0.0008, 8).move(-0.38 * long + 0.0075 * i, 0.006 * j, 0.0297)
             for i in range(-2, 3) for j in range(-1, 2)]  # fmt: skip
    low = limb([(-0.3 * long, 0, 0.011), (0.1 * long, 0, 0.009), (0.46 * long, 0, 0.0085),
                (0.5 * long, 0, 0.0085)], [0.0085, 0.008, 0.008, 0.004], 10)  # fmt: skip
    high = limb([(-0.42 * long, 0, 0.03), (-0.2 * long, 0, 0.036), (0.2 * long, 0, 0.042),
                 (0.5 * long, 0, 0.052)], [0.006, 0.0085, 0.008, 0.006], 10)  # fmt: skip
    head = block(0.03, 0.022, 0.012, 0.005, 0.002).move(-0.36 * long, 0, 0.026)
    return shape([(join([cup, low, high, head]), skin),
                  (join(holes), textures.plain((60, 60, 62)))],
                 [hull_of(cup), hull_above(low), hull_of(high)])  # fmt: skip


def potato_masher(look: Look) -> Shape:
    """A potato masher standing on its zigzag or pierced plate."""
    h = look.between(0.23, 0.27)
    color = look.color(*GRIPS, "wooden")
    steel = _steel(look)
    r = look.between(0.04, 0.046)
    if look.chance(0.5):
        foot = [prism(ellipse(2 * r, 2 * r, 32), 0, 0.003)]
        holes = [box(0.008, 0.008, 0.0006).move(0.017 * i, 0.017 * j, 0.0028)
                 for i in range(-2, 3) for j in range(-2, 3) if i * i + j * j < 6]  # fmt: skip
    else:
        y = np.array([-1, 1, 1, -1] * 3)[:11] * 0.8
        x = np.repeat(np.linspace(-1, 1, 6), 2)[:11]
        path = np.column_stack([x * r, y * r, np.full(11, 0.003)])
        foot, holes = [tube(path, 0.003, 8)], []
    arms = [tube(smooth([(s * 0.85 * r, 0, 0.003), (s * 0.75 * r, 0, 0.3 * h),
                         (s * 0.1 * r, 0, 0.5 * h), (0, 0, 0.58 * h)], 4), 0.0034, 8)
            for s in (-1, 1)]  # fmt: skip
    grip = lathe([(0, 0), (0.009, 0), (0.013, 0.14 * h), (0.011, 0.3 * h), (0.013, 0.4 * h),
                  (0.006, 0.45 * h), (0, 0.45 * h)], 18).move(z=0.55 * h)  # fmt: skip
    pieces = [(join([*foot, *arms]), steel), (grip, look.surface(color, "plastic"))]
    if holes:
        pieces.append((join(holes), textures.plain((70, 72, 76))))
    return shape(pieces, [hull_above(*foot), hull_of(*arms), hull_of(grip)])


def mandoline(look: Look) -> Shape:
    """A mandoline slicer: a sloping board on a foot, a slanted blade across it."""
    x, y = look.between(0.28, 0.34), look.between(0.1, 0.12)
    color = look.color("white", "black", "red", "green", "sage", "silver")
    skin = look.surface(color, "plastic")
    board = block(x, y, 0.01, 0.02, 0.002)
    rails = [box(0.82 * x, 0.008, 0.014).move(0, s * 0.44 * y, 0.004) for s in (-1, 1)]
    blade = prism(np.array([(-0.02, -0.4 * y), (0.0, -0.4 * y), (0.03, 0.4 * y), (0.01, 0.4 * y)]),
                  0.0095, 0.012)  # fmt: skip
    guard = block(0.075, 0.8 * y, 0.014, 0.02, 0.004).move(0.24 * x, 0, 0.0105)
    knob = cylinder(0.018, 0.02, 20, top=0.022, bevel=0.004).move(0.24 * x, 0, 0.024)
    dark = textures.plain(tint_color(color, 0.55) if sum(color) > 200 else (110, 112, 116))
    lean = 0.3
    up = [
        (s.turn(1, lean).move(z=0.5 * x * np.sin(lean)), t)
        for s, t in (
            (join([board, *rails]), skin),
            (blade, _steel(look)),
            (join([guard, knob]), dark),
        )
    ]
    legs = [box(0.012, 0.012, 0.28 * x).turn(1, -0.25).move(-0.3 * x, s * 0.42 * y, 0)
            for s in (-1, 1)]  # fmt: skip
    bar = box(0.02, y, 0.006).move(-0.31 * x)
    up.append((join([*legs, bar]), skin))
    return shape(up, [hull_above(up[0][0]), hull_of(up[2][0]), hull_above(*legs, bar)])


_K = ("kitchen",)
CATEGORIES = (
    Category("sieve", sieve, (0.35, 0.164, 0.0563), 0.18, ("strainer", "mesh strainer",
             "flour sifter", "sifter", "fine mesh sieve", "mesh sieve"), _K, ("container", "big"),
             ("silver", "black")),
    Category("lid", lid, (0.214, 0.214, 0.0552), 0.45, ("pot lid", "pan lid", "saucepan lid",
             "glass lid", "lid of a pot", "pitcher lid", "yoghurt lid", "yogurt lid",
             "plastic lid"), _K, ("round", "flat"), ("silver",),
             state="lying flat"),
    Category("can_opener", can_opener, (0.2, 0.0595, 0.024), 0.16, ("tin opener",), _K, (),
             ("black", "red"), state="lying flat"),
    Category("garlic_press", garlic_press, (0.177, 0.03, 0.0576), 0.2, ("garlic crusher",), _K, (),
             ("silver",), state="lying flat"),
    Category("potato_masher", potato_masher, (0.0862, 0.0761, 0.243), 0.18, ("masher",), _K,
             ("tall",), ("black", "silver")),
    Category("mandoline", mandoline, (0.29, 0.109, 0.0985), 0.5, ("mandolin slicer",
                 "vegetable slicer", "mandoline slicer"), _K, ("big",), ("white",
             "black")),
)  # fmt: skip
"""The module's categories."""
