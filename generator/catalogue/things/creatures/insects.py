"""Insects and other small animals of the garden, about as large as models of them are."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import drum, plate
from ...build.outlines import smooth
from ...build.recipes import ball, put_down, rod
from ...build.shape import Shape
from ...build.solids import Solid, join, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain

DARK = (44, 38, 36)


def _legs(reach: float, at: tuple[float, ...], z: float, thick: float = 0.0011) -> list[Solid]:
    """Return pairs of bent legs at the given places along x."""
    made = []
    for n, x in enumerate(at):
        lean = (0.35, 0.0, -0.35)[n % 3] * reach
        for s in (-1, 1):
            path = [(x, s * 0.1 * reach, z), (x + 0.6 * lean, s * 0.6 * reach, z + 0.12 * reach),
                    (x + lean, s * reach, 0.9 * thick)]  # fmt: skip
            made.append(rod(path, thick, 6, 3))
    return made


def _feelers(x: float, z: float, long: float) -> list[Solid]:
    return [
        rod(
            [
                (x, s * 0.002, z),
                (x + 0.5 * long, s * 0.3 * long, z + 0.5 * long),
                (x + long, s * 0.45 * long, z + 0.55 * long),
            ],
            0.0008,
            5,
            3,
        )
        for s in (-1, 1)
    ]


def ladybird(look: Look) -> Shape:
    """A ladybird: a spotted dome, a dark head and legs."""
    color = look.color("red", "orange", "yellow", "crimson")
    k = look.between(0.8, 1.25)
    shell = ball(0.034, 0.03, 0.03, (0, 0, 0.005), 22)
    head = ball(0.014, 0.018, 0.014, (0.016, 0, 0.006), 14)
    places = [(0.35, 0.7), (-0.25, 0.8), (-0.8, 0.5), (0.05, 1.15), (-0.55, 1.15)]
    spots = []
    for x, s in places:
        for side in (-1, 1):
            a, b = 0.55 * x, side * s * 0.62
            p = np.array([0.017 * np.sin(a * 1.6), 0.015 * np.sin(b) * np.cos(a), 0.0])
            p[2] = 0.005 + 0.015 * np.sqrt(max(1 - (p[0] / 0.017) ** 2 - (p[1] / 0.015) ** 2, 0.03))
            spots.append(
                ball(0.006, 0.006, 0.0045, (float(p[0]), float(p[1]), float(p[2]) - 0.0008), 8)
            )
    seam = tube(smooth([(0.013, 0, 0.0152), (0, 0, 0.0202), (-0.0165, 0, 0.0062)], 4), 0.0007, 5)
    eyes = [ball(0.004, 0.004, 0.004, (0.021, s * 0.006, 0.009), 8) for s in (-1, 1)]
    legs = _legs(0.021, (0.008, 0.0, -0.008), 0.004)
    return put_down(
        [(shell, textures.speckles(look.rng, color, 4)), (join([head, *spots, seam, *legs,
          *_feelers(0.02, 0.01, 0.01)]), plain(DARK)), (join(eyes), plain((244, 240, 232)))],
        shell, head, factor=k)  # fmt: skip


def beetle(look: Look) -> Shape:
    """A large beetle with ridged wing cases and a horn."""
    color = look.color("brown", "black", "green", "navy", "maroon", "teal")
    k = look.between(0.8, 1.2)
    back = ball(0.05, 0.034, 0.03, (-0.01, 0, 0.008), 20)
    neck = ball(0.022, 0.03, 0.022, (0.018, 0, 0.009), 16)
    head = ball(0.014, 0.016, 0.012, (0.03, 0, 0.008), 12)
    horn = rod([(0.034, 0, 0.01), (0.047, 0, 0.014), (0.052, 0, 0.025)], [0.0028, 0.0008], 8)
    lines = [
        tube(
            smooth(
                [
                    (0.008, s * 0.003, 0.0205),
                    (-0.01, s * 0.0045, 0.0232),
                    (-0.033, s * 0.003, 0.0125),
                ],
                4,
            ),
            0.0006,
            5,
        )
        for s in (-2, 0, 2)
    ]
    legs = _legs(0.034, (0.016, -0.002, -0.016), 0.006, 0.0016)
    gloss = textures.gradient(tint_color(color, 0.7), tint_color(color, 1.3), look.rng)
    return put_down([(join([back, neck]), gloss), (join([head, horn, *legs, *lines]), plain(
        tint_color(color, 0.4)))], back, neck, join([head, horn]), factor=k)  # fmt: skip


def bee(look: Look) -> Shape:
    """A bee with a striped, furry body and clear wings."""
    color = look.color("yellow", "amber", "mustard")
    k = look.between(0.85, 1.25)
    stripes = textures.stripes([color, DARK], 4, upright=False)
    tail = ball(0.021, 0.022, 0.032, (0, 0, 0), 18).turn(1, np.pi / 2).move(-0.014, 0, 0.011)
    chest = ball(0.02, 0.02, 0.019, (0.006, 0, 0.012), 14)
    head = ball(0.012, 0.016, 0.014, (0.018, 0, 0.011), 12)
    eyes = [ball(0.006, 0.005, 0.008, (0.02, s * 0.007, 0.012), 8) for s in (-1, 1)]
    rim = [(0, 0), (0.012, 0.007), (0.015, 0.026), (0.006, 0.034), (-0.004, 0.022)]
    wings = [plate(np.array(rim) * [1, s] if s > 0 else (np.array(rim) * [1, s])[::-1], 0.0009)
             .turn(0, s * 0.35).move(-0.004, s * 0.003, 0.0195) for s in (-1, 1)]  # fmt: skip
    legs = _legs(0.015, (0.01, 0.004, -0.004), 0.006, 0.001)
    return put_down(
        [
            (tail, stripes),
            (chest, textures.scratches(look.rng, tint_color(color, 0.85), (90, 66, 30), 90)),
            (join([head, *eyes, *legs, *_feelers(0.022, 0.015, 0.009)]), plain(DARK)),
            (join(wings), plain((226, 234, 238))),
        ],
        tail,
        chest,
        head,
        factor=k,
        foot=0.2,
    )


def butterfly(look: Look) -> Shape:
    """A butterfly with its wings half raised."""
    color = look.color("orange", "blue", "yellow", "pink", "purple", "turquoise", "white")
    k = look.between(0.8, 1.2)
    fore = np.array([(0.004, 0), (0.022, 0.008), (0.034, 0.032), (0.03, 0.052), (0.018, 0.05),
                     (0.002, 0.02)])  # fmt: skip
    hind = np.array([(0.003, 0), (0.002, 0.02), (-0.006, 0.04), (-0.022, 0.042), (-0.032, 0.024),
                     (-0.012, 0.004)])  # fmt: skip
    wings, marks, edges = [], [], []
    for s in (-1, 1):
        for rim, inner in ((fore, (0.024, 0.034)), (hind, (-0.016, 0.026))):
            way = rim if s > 0 else (rim * [1, -1])[::-1]
            mid = way.mean(0)
            for scale, thick, where in ((1.0, 0.0012, edges), (0.8, 0.0018, wings)):
                slab = plate(mid + (way - mid) * scale, thick, at=(0, 0, -thick / 2))
                where.append(slab.turn(0, s * 0.5).move(0, s * 0.002, 0.008))
            dot = drum(0.0045, 0.0026, (inner[0], s * inner[1], -0.0013), sides=10)
            marks.append(dot.turn(0, s * 0.5).move(0, s * 0.002, 0.008))
    body = ball(0.05, 0.007, 0.008, (-0.004, 0, 0.0065), 12)
    dark = plain(DARK if sum(color) > 250 else tint_color(color, 0.4))
    spot = look.own_color("white", "yellow", "cream", "coral")
    return put_down(
        [(join(edges), dark), (join(wings), textures.gradient(tint_color(color, 0.85),
          tint_color(color, 1.2), look.rng)), (join(marks), plain(spot)),
         (join([body, *_feelers(0.02, 0.008, 0.014)]), dark)],
        body, *edges, factor=k, foot=0.2)  # fmt: skip


def dragonfly(look: Look) -> Shape:
    """A dragonfly: a long jointed tail and four clear wings."""
    color = look.color("blue", "green", "red", "turquoise", "purple")
    k = look.between(0.8, 1.2)
    tail = rod([(-0.06, 0, 0.004), (-0.02, 0, 0.006), (0.01, 0, 0.007)], [0.0024, 0.0032], 10)
    chest = ball(0.024, 0.014, 0.014, (0.014, 0, 0.0068), 14)
    eyes = [ball(0.009, 0.008, 0.009, (0.028, s * 0.005, 0.0075), 10) for s in (-1, 1)]
    wings = []
    for x, lean in ((0.018, 0.12), (0.006, -0.12)):
        for s in (-1, 1):
            one = ball(0.016, 0.055, 0.0012, (0, s * 0.03, 0), 14)
            wings.append(one.turn(2, -s * lean).move(x, 0, 0.0135))
    legs = _legs(0.012, (0.02, 0.014, 0.008), 0.005, 0.0008)
    return put_down(
        [(join([tail, chest]), textures.stripes([color, tint_color(color, 0.6)], 6, upright=True)),
         (join([*eyes, *legs]), plain(DARK)), (join(wings), plain((216, 230, 234)))],
        chest, tail, join(wings), factor=k, foot=0.3)  # fmt: skip


def _ant(look: Look) -> Shape:
    """An ant: three body parts, six legs and jaws."""
    color = look.color("black", "brown", "maroon", "red")
    k = look.between(0.8, 1.2)
    tail = ball(0.022, 0.016, 0.015, (-0.017, 0, 0.009), 14)
    waist = ball(0.015, 0.009, 0.009, (0.001, 0, 0.008), 12)
    head = ball(0.014, 0.013, 0.011, (0.015, 0, 0.009), 12)
    legs = _legs(0.02, (0.006, 0.001, -0.004), 0.007, 0.0011)
    jaws = [rod([(0.02, s * 0.003, 0.007), (0.027, s * 0.003, 0.006)], 0.001, 6) for s in (-1, 1)]
    body = [tail, waist, head]
    return put_down([(join([*body, *legs, *jaws, *_feelers(0.018, 0.012, 0.01)]),
                      textures.gradient(tint_color(color, 0.7), tint_color(color, 1.2), look.rng))],
                    join(body), *legs[:2], *legs[-2:], factor=k)  # fmt: skip


def caterpillar(look: Look) -> Shape:
    """A caterpillar: a row of plump rings, a face and feelers."""
    color, other = look.color("green", "lime", "yellow", "teal"), look.own_color("yellow", "orange")
    k = look.between(0.85, 1.2)
    rings, feet = [], []
    for n in range(7):
        d = 0.022 - 0.0007 * abs(n - 3)
        y = 0.005 * np.sin(1.1 * n)
        rings.append(ball(d, d, d, (0.0145 * (n - 3.4), y, 0.0095 + 0.003 * (n % 2)), 14))
        feet += [ball(0.005, 0.005, 0.006, (0.0145 * (n - 3.4), y + s * 0.007, 0.002), 6)
                 for s in (-1, 1)]  # fmt: skip
    head = ball(0.023, 0.024, 0.024, (0.0145 * 3.7, 0, 0.015), 16)
    eyes = [ball(0.005, 0.005, 0.007, (0.0145 * 3.7 + 0.009, s * 0.006, 0.019), 8) for s in (-1, 1)]
    return put_down(
        [(join(rings[::2]), plain(color)), (join(rings[1::2]), plain(tint_color(color, 1.3))),
         (head, plain(other)), (join([*feet, *eyes, *_feelers(0.056, 0.024, 0.012)]), plain(DARK))],
        join(rings), head, factor=k, foot=0.25)  # fmt: skip


def worm(look: Look) -> Shape:
    """An earthworm lying in bends."""
    color = look.color("pink", "terracotta", "brown", "coral", spread=14)
    k, a = look.between(0.8, 1.25), look.between(0.7, 1.3)
    x = np.linspace(-0.045, 0.045, 44)
    path = np.column_stack([x, 0.011 * a * np.sin(x * 110), 0.0031 + 0 * x])
    t = np.linspace(0, 1, 44)
    radii = 0.0034 * np.clip(6 * np.minimum(t, 1 - t) + 0.2, 0, 1) * (1 + 0.05 * np.cos(44 * t * 3))
    saddle = tube(path[26:32], 0.0039, 10)
    rings = textures.stripes([color, tint_color(color, 0.85)], 22)
    half = [tube(path[i : i + 12], 0.0034, 8) for i in (0, 11, 22, 32)]
    return put_down([(tube(path, radii, 10), rings), (saddle, plain(tint_color(color, 0.75)))],
                    *half, factor=k, foot=0.4)  # fmt: skip


def snail(look: Look) -> Shape:
    """A snail: a coiled shell on a soft foot, two eye stalks."""
    color = look.color("tan", "brown", "amber", "cream", "olive")
    k = look.between(0.75, 1.2)
    foot = rod([(-0.034, 0, 0.003), (-0.01, 0, 0.005), (0.02, 0, 0.007), (0.032, 0, 0.012)],
               [0.003, 0.009, 0.009, 0.006], 12)  # fmt: skip
    t = np.linspace(0, 5 * np.pi, 70)
    r = 0.0025 + 0.0135 * (t / t[-1]) ** 1.2
    y = 0.011 * (1 - t / t[-1]) * look.pick([-1, 1])
    path = np.column_stack([r * np.cos(t + 0.4) - 0.006, y, 0.0245 + r * np.sin(t + 0.4)])
    shell = tube(path, 0.0018 + 0.0075 * (t / t[-1]), 10)
    stalks = [
        rod([(0.031, s * 0.003, 0.014), (0.037, s * 0.005, 0.024)], 0.0013, 6) for s in (-1, 1)
    ]
    tips = [ball(0.0045, 0.0045, 0.0045, (0.037, s * 0.005, 0.0245), 8) for s in (-1, 1)]
    coil = textures.stripes([color, tint_color(color, 0.65), tint_color(color, 1.2)], 8)
    return put_down(
        [
            (join([foot, *stalks]), textures.speckles(look.rng, (190, 170, 140), 8)),
            (shell, coil),
            (join(tips), plain(DARK)),
        ],
        foot,
        shell,
        factor=k,
        foot=0.2,
    )


CATEGORIES = (
    Category("ladybird", ladybird, (0.0484, 0.0445, 0.0215), 0.012,
             ("ladybug", "lady bird", "lady bug", "toy ladybird", "ladybird beetle"),
             ("toys",), (), ("red",)),
    Category("beetle", beetle, (0.0892, 0.0712, 0.0257), 0.015,
             ("toy beetle", "stag beetle", "bug", "plastic bug", "cockroach", "insect",
             "toy insect"),
             ("toys",), (), ("brown", "black")),
    Category("bee", bee, (0.0694, 0.0792, 0.0359), 0.01,
             ("bumblebee", "bumble bee", "honeybee", "honey bee", "wasp", "toy bee"),
             ("toys",), (), ("yellow",)),
    Category("butterfly", butterfly, (0.0614, 0.0889, 0.0287), 0.008,
             ("toy butterfly", "moth", "paper butterfly"), ("toys",), (), ("orange", "blue")),
    Category("dragonfly", dragonfly, (0.0951, 0.116, 0.0145), 0.008, ("toy dragonfly", "damselfly"),
             ("toys",), (), ("blue", "green")),
    Category("ant", _ant, (0.054, 0.0405, 0.0174), 0.01, ("toy ant", "plastic ant"), ("toys",),
             (), ("black",)),
    Category("caterpillar", caterpillar, (0.124, 0.029, 0.0307), 0.03,
             ("toy caterpillar", "wooden caterpillar"), ("toys",), (), ("green",)),
    Category("worm", worm, (0.0942, 0.0289, 0.00711), 0.006,
             ("lugworm", "soft plastic worm", "rubber worm", "maggot", "grub"),
             ("toys",), ("flat",), ("pink",)),
    Category("snail", snail, (0.0794, 0.0237, 0.0503), 0.03,
             ("toy snail", "garden snail", "ceramic snail", "snail figurine"),
             ("toys",), (), ("tan", "brown")),
)  # fmt: skip
"""The module's categories."""
