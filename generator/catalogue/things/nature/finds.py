"""What one brings home from a walk: stones, shells, cones, leaves, twigs."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import flat_foot, hull_part
from ...build.forms import above, lobe
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, put_down, rod
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, ellipsoid, join, lathe, loft, prism, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def pebble(look: Look) -> Shape:
    """A smooth pebble, some with a vein."""
    color = look.color("gray", "charcoal", "beige", "white", "brown", "tan", "terracotta")
    x, y, h = look.between(0.035, 0.06), look.between(0.03, 0.045), look.between(0.016, 0.028)
    bumps = look.rng.uniform(0, 6.28, 3)

    def warp(p: np.ndarray) -> np.ndarray:
        a = np.arctan2(p[:, 1], p[:, 0])
        f = 1 + 0.06 * np.sin(2 * a + bumps[0]) + 0.03 * np.sin(3 * a + bumps[1])
        return p * np.column_stack([f, f, np.ones(len(p))])

    body = ellipsoid(x, y, h, 20, 12).bend(warp).move(z=0.42 * h)
    skin = (textures.marble(look.rng, color, tint_color(color, 1.7)) if look.chance(0.35)
            else textures.spots(look.rng, color, tint_color(color, 0.75), 0.12))  # fmt: skip
    return shape([(body, skin)], [flat_foot(above(body.vertices), 0.03)])


def rock(look: Look) -> Shape:
    """A rough broken stone with edges."""
    color = look.color("gray", "charcoal", "brown", "tan", "terracotta", "beige")
    x, y, h = look.between(0.07, 0.11), look.between(0.06, 0.08), look.between(0.045, 0.07)
    rough = look.rng.uniform(0.78, 1.12, (6, 9))

    def chip(p: np.ndarray) -> np.ndarray:
        a = np.arctan2(p[:, 1] / y, p[:, 0] / x)
        row = np.clip(((p[:, 2] / h + 0.5) * 5).round().astype(int), 0, 5)
        column = ((a + np.pi) / (2 * np.pi) * 9).round().astype(int) % 9
        away = np.hypot(p[:, 0], p[:, 1]) > 1e-6
        f = np.where(away, rough[row, column], 1.0)
        return p * np.column_stack([f, f, np.ones(len(p))])

    body = ellipsoid(x, y, h, 9, 5).bend(chip).move(z=0.38 * h)
    skin = textures.spots(look.rng, color, tint_color(color, 0.7), 0.2)
    return shape([(body, skin)], [flat_foot(above(body.vertices), 0.03)])


def pine_cone(look: Look) -> Shape:
    """A pine cone standing on its broad end, its scales open."""
    color = look.color("brown", "tan", "bronze", "terracotta")
    tall, wide = look.between(0.06, 0.09), look.between(0.042, 0.055)
    scales: list[Solid] = []
    for k in range(58):
        t = k / 58
        r = wide / 2 * np.sin(np.pi * (0.28 + 0.68 * t)) ** 0.8
        size = 0.3 * wide * (1.05 - 0.6 * t)
        scale = ellipsoid(size, 0.8 * size, 0.25 * size, 6, 4).turn(1, -0.5 + 0.5 * t)
        scales.append(
            scale.move(x=r - 0.3 * size).turn(2, 2.4 * k).move(z=0.006 + (tall - 0.01) * t)
        )
    core = lathe([(0, 0), (0.36 * wide, 0), (0.4 * wide, 0.3 * tall), (0.05 * wide, 0.97 * tall),
                  (0, 0.97 * tall)], 12)  # fmt: skip
    return put_down(
        [
            (join(scales), textures.speckles(look.rng, color, 16)),
            (core, textures.plain(tint_color(color, 0.5))),
        ],
        join([core, *scales]),
    )


def leaf(look: Look) -> Shape:
    """A fallen leaf lying a little curled: oval, maple or oak."""
    color = look.color("orange", "red", "yellow", "green", "brown", "amber")
    kind = look.pick(["oval", "maple", "oak"])
    half = {
        "oval": smooth([(-0.04, 0), (-0.02, 0.02), (0.01, 0.024), (0.035, 0.012), (0.05, 0)], 3),
        "maple": np.array([(-0.03, 0), (-0.034, 0.014), (-0.026, 0.022), (-0.03, 0.042),
                           (-0.012, 0.03), (-0.006, 0.046), (0.006, 0.03), (0.02, 0.044),
                           (0.016, 0.022), (0.03, 0.024), (0.028, 0.012), (0.048, 0)]),
        "oak": smooth([(-0.04, 0), (-0.034, 0.008), (-0.026, 0.016), (-0.018, 0.009),
                       (-0.006, 0.022), (0.002, 0.011), (0.016, 0.024), (0.022, 0.012),
                       (0.036, 0.016), (0.048, 0)], 2),
    }[kind]  # fmt: skip
    outline = np.concatenate([half[::-1], half[1:-1] * [1, -1]])

    def curl(p: np.ndarray) -> np.ndarray:
        rise = 2.2 * p[:, 1] ** 2 + 0.9 * np.maximum(p[:, 0], 0) ** 2
        return np.column_stack([p[:, :2], p[:, 2] + rise])

    body = prism(outline, 0.0012, 0.0022).bend(curl)
    veins = [rod([(-0.03, 0, 0.0022), (0.0, 0, 0.0022), (0.043, 0, 0.0022 + 0.0016)], 0.0009, 5)]
    for x in (-0.016, 0.0, 0.014):
        for s in (-1, 1):
            end = (x + 0.014, s * 0.014, 0.0024 + 2.2 * 0.0002 + 0.9 * max(x + 0.014, 0) ** 2)
            veins.append(tube([(x, 0, 0.0022), end], 0.0006, 5))
    stalk = rod([(-0.028, 0, 0.0015), (-0.045, 0.002, 0.0014), (-0.06, 0.006, 0.0014)], 0.0011, 6)
    skin = textures.speckles(look.rng, color, 16)
    ribs = textures.plain(tint_color(color, 0.6))
    return put_down([(body, skin), (join([*veins, stalk]), ribs)], body, stalk,
                   factor=look.between(0.8, 1.3))  # fmt: skip


def twig(look: Look) -> Shape:
    """A forked twig lying on the table, bare or with a few leaves."""
    long = look.between(0.22, 0.32)
    color = look.color("brown", "tan", "gray", "bronze", "charcoal")
    bark = textures.scratches(look.rng, color, tint_color(color, 0.65), 60)
    h = long / 2
    main = rod([(-h, 0, 0.0045), (-0.3 * h, 0.006, 0.004), (0.3 * h, -0.004, 0.004),
                (h, 0.004, 0.003)], [0.0048, 0.004, 0.0034, 0.0014], 8)  # fmt: skip
    forks = [
        rod(
            [(x, 0, 0.004), (x + 0.2 * h, s * 0.014, 0.005), (x + 0.45 * h, s * 0.026, 0.003)],
            [0.0028, 0.002, 0.0009],
            6,
        )
        for x, s in ((-0.35 * h, 1), (0.1 * h, -1))
    ]
    pieces: Pieces = [(join([main, *forks]), bark)]
    if look.chance(0.5):
        leaves = [
            ellipsoid(0.028, 0.013, 0.0016, 8, 4).turn(2, s * 0.7).move(x * h, s * 0.016, 0.005)
            for x, s in ((0.3, 1), (0.6, -1), (0.8, 1), (0.02, 1.4), (0.45, -1.6))
        ]
        pieces.append((join(leaves), textures.plain(look.own_color("green", "olive", "sage"))))
    x = main.vertices[:, 0]
    return shape(pieces, [flat_foot(above(main.vertices[x < 0.05 * h]), 0.4),
                          flat_foot(above(main.vertices[x > -0.05 * h]), 0.4),
                          flat_foot(above(join(forks).vertices), 0.4)])  # fmt: skip


def feather(look: Look) -> Shape:
    """A feather lying flat on its quill."""
    color = look.color("white", "gray", "blue", "brown", "black", "red", "green")
    long = look.between(0.14, 0.2)
    half = np.array(
        smooth([(-0.22, 0.002), (-0.16, 0.07), (0.1, 0.1), (0.38, 0.075), (0.5, 0.0)], 4)
    )
    outline = np.concatenate([half[::-1], half[:-1] * [1, -0.8]]) * long

    def bow(p: np.ndarray) -> np.ndarray:
        return np.column_stack([p[:, :2], p[:, 2] + 0.6 * (p[:, 0] - 0.1 * long) ** 2 / long * 0.6])

    vane = prism(outline, 0.0008, 0.0018).bend(bow)
    quill = rod([(-0.5 * long, 0, 0.0035), (-0.2 * long, 0, 0.0026), (0.1 * long, 0, 0.0018),
                 (0.46 * long, 0, 0.0036)], [0.0012, 0.0012, 0.0009, 0.0004], 6)  # fmt: skip
    barbs = textures.stripes([color, tint_color(color, 0.86)], 22, upright=True, side=96)
    return put_down([(vane, barbs), (quill, textures.plain((240, 232, 214)))], vane, quill)


def seashell(look: Look) -> Shape:
    """A scallop shell lying with its ribs up, or a whelk's spiral."""
    color = look.color("white", "cream", "pink", "coral", "tan", "beige", "lavender")
    other = tint_color(color, 0.72)
    if look.chance(0.6):
        n, m = 25, 7
        a = np.linspace(-1.25, 1.25, n)
        rings = []
        for t in np.linspace(0.06, 1, m):
            rib = 1 + 0.05 * np.abs(np.cos(7 * a))
            r = 0.075 * t * (0.92 + 0.08 * np.cos(a * 1.3)) * rib
            z = 0.026 * np.sin(np.pi * (0.08 + 0.92 * t)) * (0.55 + 0.45 * np.cos(1.1 * a)) * rib
            top = np.column_stack([r * np.sin(a), r * np.cos(a) - 0.04, z + 0.002])
            low = top[::-1] * [0.97, 0.97, 0]
            rings.append(np.concatenate([top[::-1], low[::-1]]))
        section = np.concatenate([np.column_stack([np.sin(a[::-1]), np.ones(n)]),
                                  np.column_stack([np.sin(a), -np.ones(n)])])  # fmt: skip
        fan = loft(np.stack(rings), section)
        hinge = ball(0.03, 0.012, 0.01, (0, -0.036, 0.004), 10)
        tile = textures.stripes([color, other], 16, upright=True, side=128)
        return put_down([(fan, tile), (hinge, textures.plain(other))], fan, hinge,
                       factor=look.between(0.85, 1.2))  # fmt: skip
    t = np.linspace(0, 1, 60)
    a = 2 * np.pi * 3.2 * t
    r = 0.019 * (1 - t) ** 1.1 + 0.0005
    path = np.column_stack([-0.03 + 0.07 * t, r * np.cos(a), r * np.sin(a) + 0.02])
    coil = tube(path, 0.019 * (1 - t) + 0.002, 10)
    lip = ball(0.036, 0.03, 0.04, (-0.034, 0.008, 0.018), 14)
    mouth = ball(0.02, 0.014, 0.026, (-0.046, -0.003, 0.018), 10)
    tile = textures.stripes([color, other, color], 8, side=96)
    return put_down([(coil, tile), (lip, textures.speckles(look.rng, color, 6)),
                    (mouth, textures.plain((240, 190, 170)))], coil, lip,
                   factor=look.between(0.85, 1.2))  # fmt: skip


def starfish(look: Look) -> Shape:
    """A five-armed starfish lying flat."""
    color = look.color("orange", "coral", "red", "tan", "beige", "purple", "terracotta")
    n = 40
    a = 2 * np.pi * np.arange(n) / n
    r = 0.5 * (0.32 + 0.68 * np.abs(np.cos(2.5 * a)) ** 2.2)
    outline = np.column_stack([r * np.cos(a), r * np.sin(a)])
    levels = [(1.0, 0.0), (1.02, 0.05), (0.8, 0.11), (0.3, 0.17)]
    body = loft(
        np.stack([np.column_stack([outline * g, np.full(n, z)]) for g, z in levels]), outline
    )
    dots = [ball(0.045, 0.045, 0.03, (d * np.cos(w), d * np.sin(w), 0.16 - 0.2 * d), 6)
            for w in 2 * np.pi * np.arange(5) / 5 for d in (0.14, 0.24, 0.34)]  # fmt: skip
    skin = textures.spots(look.rng, color, tint_color(color, 1.4), 0.1)
    return put_down([(body, skin), (join(dots), textures.plain(tint_color(color, 1.5)))], body,
                   factor=look.between(0.09, 0.15))  # fmt: skip


def coral(look: Look) -> Shape:
    """A branching coral on a stone foot."""
    color = look.color("coral", "red", "white", "pink", "orange")
    branches: list[Solid] = [rod([(0, 0, 0.01), (0.004, 0, 0.05), (0, 0.004, 0.12)],
                                 [0.012, 0.009, 0.005], 8)]  # fmt: skip
    for k in range(9):
        a, z = 2.4 * k, 0.03 + 0.008 * k
        out = look.between(0.03, 0.045) * (1.1 - 0.05 * k)
        tip = np.array([out * np.cos(a), out * np.sin(a), z + 0.045])
        branches.append(rod([(0, 0, z), 0.6 * tip * [1, 1, 0] + [0, 0, z + 0.015], tip],
                            [0.0075, 0.006, 0.0045], 7, 3))  # fmt: skip
        branches.append(ball(0.011, 0.011, 0.011, tuple(tip), 8))
    foot = lobe(cylinder(0.036, 0.014, 16, top=0.02), 5, 0.15)
    skin = textures.spots(look.rng, color, tint_color(color, 1.4), 0.25)
    return put_down(
        [(join(branches), skin), (foot, textures.speckles(look.rng, (196, 188, 172), 12))],
        foot,
        join(branches),
        factor=look.between(0.85, 1.15),
    )


def driftwood(look: Look) -> Shape:
    """A bleached piece of driftwood, bent and forked."""
    color = look.color("gray", "tan", "beige", "silver", "cream")
    long = look.between(0.2, 0.3)
    h = long / 2
    bark = textures.wood(look.rng, color, grain=1.6)
    main = rod([(-h, 0.01, 0.014), (-0.4 * h, -0.008, 0.018), (0.3 * h, 0.008, 0.017),
                (h, -0.012, 0.012)], [0.008, 0.017, 0.015, 0.006], 10)  # fmt: skip
    fork = rod([(0.0, 0, 0.02), (0.35 * h, 0.03, 0.032), (0.62 * h, 0.05, 0.03)],
               [0.011, 0.008, 0.004], 8)  # fmt: skip
    stub = rod([(-0.4 * h, -0.005, 0.02), (-0.55 * h, -0.02, 0.03), (-0.6 * h, -0.03, 0.036)],
               [0.01, 0.007, 0.005], 8)  # fmt: skip
    x = main.vertices[:, 0]
    return shape(
        [(join([main, fork, stub]), bark)],
        [
            hull_part(above(main.vertices[x < 0.02])),
            hull_part(above(main.vertices[x > -0.02])),
            hull_part(fork.vertices),
        ],
    )


CATEGORIES = (
    Category("pebble", pebble, (0.047, 0.037, 0.02), 0.05, ("stone", "small stone",
             "smooth stone", "river stone", "zen stone", "flat stone"), ("living",), (), ("gray",
             "beige")),
    Category("rock", rock, (0.088, 0.068, 0.05), 0.4, ("big stone", "boulder", "rough stone",
             "piece of rock"), ("living",), (), ("gray",)),
    Category("pine_cone", pine_cone, (0.053, 0.053, 0.078), 0.03, ("pinecone", "fir cone",
             "conifer cone", "pinecone ornament", "pine cone ornament"), ("living",), (),
             ("brown",)),
    Category("leaf", leaf, (0.103, 0.0641, 0.005), 0.002, ("autumn leaf", "maple leaf", "oak leaf",
             "fallen leaf", "dry leaf", "fall leaf", "green leaf"), ("living",), (), ("orange",
             "red"), state="lying flat"),
    Category("twig", twig, (0.27, 0.055, 0.01), 0.015, ("branch", "small branch",
             "olive branch", "eucalyptus branch", "sprig"), ("living",), (),
             ("brown",), state="lying flat"),
    Category("feather", feather, (0.17, 0.031, 0.012), 0.001, ("bird feather", "quill",
             "plume"), ("living",), (), ("white", "gray"), state="lying flat"),
    Category("seashell", seashell, (0.125, 0.08, 0.035), 0.03, ("shell", "sea shell", "conch",
             "clam shell", "scallop shell", "sea snail shell", "whelk", "winkle", "periwinkle"),
             ("living",), (), ("cream", "pink"), state="lying"),
    Category("starfish", starfish, (0.11, 0.115, 0.021), 0.04, ("sea star", "dried starfish"),
             ("living",), (), ("orange",), state="lying flat"),
    Category("coral", coral, (0.085, 0.085, 0.135), 0.2, ("piece of coral", "coral branch",
             "red coral"), ("living",), ("tall",), ("coral",)),
    Category("driftwood", driftwood, (0.25, 0.085, 0.04), 0.12, ("piece of driftwood",
             "drift wood", "log", "wooden offcut", "wood offcut"), ("living",), (), ("gray",),
             state="lying"),
)  # fmt: skip
"""The module's categories."""
