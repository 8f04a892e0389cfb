"""Objects of the ``living`` theme: leaves."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import surfaces
from ...kit.outlines import smooth
from ...kit.parts import above, flat_foot, hull_part
from ...kit.primitives import ball, blade, limb, rod
from ...kit.shapes import Pieces, Shape, category, keep_still, put_down, settle, shape
from ...kit.solids import Solid, ellipsoid, join, lathe, prism, torus, tube
from ...kit.surfaces import Look, streaks, tint_color


@category("holly", size=(0.129, 0.133, 0.0116), mass=0.01, material="food", assembled=True,
          aliases=("holly sprig", "sprig of holly", "holly leaf", "holly branch"),
          themes=("living",), colors=("green",), state="lying flat")  # fmt: skip
@keep_still
def holly(look: Look) -> Shape:
    """A sprig of holly with prickly leaves and red berries."""
    k = look.between(0.9, 1.15)
    side = [(0, 0.0), (0.1, 0.14), (0.22, 0.1), (0.36, 0.22), (0.5, 0.12), (0.64, 0.2), (0.8, 0.08)]
    edge = [*[(x, -y) for x, y in side], (1.0, 0.0), *side[:0:-1]]
    leaf = prism(np.array(edge) * 0.062, 0, 0.0022)
    spiny = [leaf.turn(1, -0.12).turn(2, a).move(0.006 * np.cos(a), 0.006 * np.sin(a), 0.001)
             for a in (0.35, 2.75, -1.6, -2.9)]  # fmt: skip
    stick = rod([(0, 0, 0.002), (0.004, 0.03, 0.003), (0.0, 0.065, 0.0022)], 0.0021, 6)
    red = [ball(0.0115, 0.0115, 0.0115, (x, y, 0.006), 10)
           for x, y in ((0.004, -0.001), (-0.008, 0.004), (-0.002, -0.011))]  # fmt: skip
    green = surfaces.leaf(look.rng, look.color("green", "teal", "green"))
    return put_down([(join(spiny), tint(green)), (stick, surfaces.plain((104, 82, 56))),
                     (join(red), surfaces.plain((204, 30, 36)))], factor=k)  # fmt: skip


def tint(tile: surfaces.Tile) -> surfaces.Tile:
    """Return a darker copy of the texture ``tile``."""
    return (tile * 0.72).astype(np.uint8)


@category("fern_frond", size=(0.287, 0.131, 0.00411), mass=0.008, material="food", assembled=True,
          aliases=("frond", "fern leaf", "palm frond", "palm leaf"), themes=("living",),
          colors=("green",), state="lying flat")  # fmt: skip
def fern_frond(look: Look) -> Shape:
    """A fern or palm frond lying flat, with leaflets on both sides of a rib."""
    k = look.between(0.85, 1.15)
    color = look.color("green", "green", "lime", "olive")
    long = 0.26
    leaflets = []
    for n in range(20):
        t = (n + 1) / 21
        reach = 0.06 * np.sin(np.pi * (0.12 + 0.88 * t)) ** 0.8 + 0.006
        for s in (-1, 1):
            x = long * (t - 0.5)
            leaflets.append(blade([(x, 0, 0.002), (x + 0.3 * reach, s * 0.55 * reach, 0.004),
                                   (x + 0.45 * reach, s * reach, 0.0018)], 0.0125, thick=0.12,
                                  sides=4))  # fmt: skip
    rib = rod([(-0.58 * long, 0, 0.002), (0, 0, 0.0026), (0.53 * long, 0, 0.002)], 0.0018, 6)
    body = join([*leaflets, rib])
    return put_down([(body, surfaces.speckles(look.rng, color, 10))], factor=k)


@category("mistletoe", size=(0.147, 0.119, 0.0124), mass=0.01, material="food", assembled=True,
          aliases=("sprig of mistletoe", "mistletoe sprig"), themes=("living",), colors=("green",),
          state="lying flat")  # fmt: skip
def mistletoe(look: Look) -> Shape:
    """A sprig of mistletoe with paired leaves and white berries, tied with a ribbon."""
    k = look.between(0.9, 1.1)
    color = look.color("olive", "green", "lime")
    leaves, stems, berries = [], [], []
    for n, a in enumerate((-0.7, 0.0, 0.7)):
        way = np.array([np.sin(a), -np.cos(a)])
        tip = 0.05 * way
        stems.append(rod([(0, 0.03, 0.003), (0, 0, 0.004), (*tip, 0.004)], 0.0016, 6))
        for s in (-1, 1):
            end = tip + 0.045 * np.array([np.sin(a + 0.5 * s), -np.cos(a + 0.5 * s)])
            leaves.append(blade([(*tip, 0.004), (*(0.5 * (tip + end)), 0.007), (*end, 0.002)],
                                0.016, thick=0.2))  # fmt: skip
        berries += [ball(0.009, 0.009, 0.009, (tip[0] + 0.005 * s, tip[1] + 0.003 * n, 0.008), 8)
                    for s in (-1, 1)]  # fmt: skip
    knot = ball(0.016, 0.01, 0.01, (0, 0.012, 0.005), 10)
    body = join([*leaves, *stems])
    return put_down([(body, surfaces.plain(color)),
                     (join(berries), surfaces.plain((246, 246, 238))),
                     (knot, surfaces.plain((196, 36, 40)))], body, factor=k, foot=0.3)  # fmt: skip


def bundle(palette: tuple[str, ...], fluff: float) -> Callable[[Look], Shape]:
    """Return the shape function of a tied bundle of herbs, lying flat."""

    def make(look: Look) -> Shape:
        long, color = look.between(0.12, 0.16), look.color(*palette)
        r = look.between(0.014, 0.018)
        stalks, leaves = [], []
        for k in range(9):
            a = 2.4 * k
            y, z = 0.7 * r * np.sin(a), 0.7 * r * np.cos(a) + r
            path = [(-0.5 * long, 1.2 * y, z), (-0.12 * long, 0.5 * y, r + 0.5 * (z - r)),
                    (0.46 * long, 1.5 * y, r + 0.9 * (z - r))]  # fmt: skip
            stalks.append(limb(path, [0.0014, 0.0016, 0.001], 5))
            for n in range(6):
                x = long * (-0.02 + 0.09 * n)
                leaves.append(ellipsoid(0.026, 0.011 * fluff, 0.008, 6, 4).turn(1,
                    0.25 * np.cos(a + n))
                              .turn(2, 0.4 * np.sin(a + 2 * n))
                              .move(x, y * (1 + 0.08 * n),
                                    r + (z - r) * (1 + 0.03 * n)))  # fmt: skip
        ties = [torus(0.7 * r, 0.0016, 14, 5).turn(1, np.pi / 2).move(x, 0, r)
                for x in (-0.16 * long, -0.13 * long, -0.1 * long)]  # fmt: skip
        dry = surfaces.speckles(look.rng, color, 18)
        return settle([(join(leaves), dry), (join(stalks), surfaces.plain(tint_color(color, 0.75))),
                       (join(ties), surfaces.plain((222, 200, 150)))], 0.16)  # fmt: skip

    return make


@category("four_leaf_clover", size=(0.0404, 0.0596, 0.00203), mass=0.0005, material="food",
          assembled=True, aliases=("clover", "shamrock", "clover leaf", "lucky clover"),
          themes=("living",), roles=("flat",), colors=("green",), state="lying flat")  # fmt: skip
def four_leaf_clover(look: Look) -> Shape:
    """A four-leaf clover lying flat: heart-shaped leaflets on a stalk."""
    k = look.between(0.85, 1.2)
    color = look.color("green", "green", "lime")
    parts = []
    for n in range(4):
        for s in (-1, 1):
            leaf = ellipsoid(0.017, 0.011, 0.0016, 10, 5).turn(2, 0.42 * s)
            parts.append(leaf.move(0.0105, 0.003 * s, 0.0014).turn(2, np.pi / 2 * n + 0.5))
    stalk = limb([(0, 0, 0.001), (0.012, -0.014, 0.001), (0.014, -0.036, 0.001)],
                 [0.001, 0.0009, 0.0008], 6)  # fmt: skip
    veins = surfaces.spots(look.rng, color, tint_color(color, 1.4), 0.12)
    return settle(
        [(join(parts), veins), (stalk, surfaces.plain(tint_color(color, 0.8)))], 0.1
    ).scale(k)


@category("pampas_stem", size=(0.505, 0.0674, 0.0377), mass=0.015, material="food", assembled=True,
          aliases=("pampas grass stem", "pampas", "stem of pampas grass", "pampas plume"),
          themes=("living",), colors=("cream",), state="lying")  # fmt: skip
def pampas_stem(look: Look) -> Shape:
    """A stem of pampas grass lying flat: a long, fluffy plume on a dry stalk."""
    long = look.between(0.42, 0.5)
    color = look.color("cream", "beige", "tan", "pink", "ivory")
    stalk = limb([(-0.5 * long, 0, 0.004), (0, 0, 0.007), (0.44 * long, 0.01, 0.009)],
                 [0.0022, 0.002, 0.001], 6)  # fmt: skip
    wisps = []
    for k in range(56):
        x = long * (-0.02 + 0.46 * (k % 28) / 28)
        a = 2.4 * k
        out = 0.024 * np.sin(np.pi * (0.12 + 0.8 * (k % 28) / 28)) * look.between(0.7, 1.2)
        wisps.append(limb([(x, 0, 0.009), (x + 0.03, out * np.cos(a),
                                           0.009 + 0.7 * out * np.sin(a)),
                           (x + 0.075, 1.3 * out * np.cos(a), 0.007 + 0.8 * out * np.sin(a))],
                          [0.0012, 0.004, 0.0006], 4))  # fmt: skip
    fluff = surfaces.scratches(look.rng, color, tint_color(color, 0.85), 120)
    return settle([(join(wisps), fluff), (stalk, surfaces.plain((196, 174, 120)))], 0.18,
                  hulls=[[0], [1]])  # fmt: skip


@category("acorn", size=(0.0397, 0.0215, 0.0187), mass=0.005, material="food", assembled=True,
          themes=("living",), colors=("copper",), state="lying flat")  # fmt: skip
def acorn(look: Look) -> Shape:
    """An acorn in its scaly cup, lying flat."""
    r = look.between(0.0085, 0.0105)
    color = look.color("copper", "tan", "bronze")
    nut = lathe([(0, 0), (0.9 * r, 0), (r, 0.6 * r), (0.9 * r, 1.7 * r), (0.5 * r, 2.3 * r),
                 (0.12 * r, 2.5 * r), (0, 2.7 * r)], 22)  # fmt: skip
    cup = lathe([(0, -0.8 * r), (0.6 * r, -0.65 * r), (1.12 * r, -0.1 * r), (1.14 * r, 0.4 * r),
                 (0.95 * r, 0.45 * r), (0, 0.4 * r)], 24)  # fmt: skip
    stalk = tube([(0, 0, -0.7 * r), (0.1 * r, 0, -1.5 * r)], 0.13 * r, 7)
    rough = surfaces.spots(look.rng, (132, 96, 60), (92, 66, 40), 0.35)
    laid = [(s.turn(1, np.pi / 2), t) for s,
            t in ((nut, streaks(look.rng, color, tint_color(color, 0.7), 12)),
                  (join([cup, stalk]), rough))]  # fmt: skip
    return settle(laid, 0.13)


@category("pine_cone", size=(0.053, 0.053, 0.078), mass=0.03, material="wood", assembled=True,
          aliases=("pinecone", "fir cone", "conifer cone", "pinecone ornament",
          "pine cone ornament"), themes=("living",), colors=("brown",))  # fmt: skip
def pine_cone(look: Look) -> Shape:
    """A pine cone with open scales, standing on its broad end."""
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
    return put_down([(join(scales), surfaces.speckles(look.rng, color, 16)),
                     (core, surfaces.plain(tint_color(color, 0.5)))],
                    join([core, *scales]))  # fmt: skip


@category("leaf", size=(0.103, 0.0641, 0.005), mass=0.002, material="paper", assembled=True,
          aliases=("autumn leaf", "maple leaf", "oak leaf", "fallen leaf", "dry leaf", "fall leaf",
          "green leaf"), themes=("living",), colors=("orange", "red"),
          state="lying flat")  # fmt: skip
def leaf(look: Look) -> Shape:
    """A slightly curled, fallen oval, maple or oak leaf."""
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
    skin = surfaces.speckles(look.rng, color, 16)
    ribs = surfaces.plain(tint_color(color, 0.6))
    return put_down([(body, skin), (join([*veins, stalk]), ribs)], body, stalk,
                   factor=look.between(0.8, 1.3))  # fmt: skip


@category("twig", size=(0.27, 0.055, 0.01), mass=0.015, material="wood", assembled=True,
          aliases=("branch", "small branch", "olive branch", "eucalyptus branch", "sprig"),
          themes=("living",), colors=("brown",), state="lying flat")  # fmt: skip
def twig(look: Look) -> Shape:
    """A forked twig lying flat, bare or with a few leaves."""
    long = look.between(0.22, 0.32)
    color = look.color("brown", "tan", "gray", "bronze", "charcoal")
    bark = surfaces.scratches(look.rng, color, tint_color(color, 0.65), 60)
    h = long / 2
    main = rod([(-h, 0, 0.0045), (-0.3 * h, 0.006, 0.004), (0.3 * h, -0.004, 0.004),
                (h, 0.004, 0.003)], [0.0048, 0.004, 0.0034, 0.0014], 8)  # fmt: skip
    forks = [rod([(x, 0, 0.004), (x + 0.2 * h, s * 0.014, 0.005), (x + 0.45 * h, s * 0.026, 0.003)],
                 [0.0028, 0.002, 0.0009], 6) for x,
             s in ((-0.35 * h, 1), (0.1 * h, -1))]  # fmt: skip
    pieces: Pieces = [(join([main, *forks]), bark)]
    if look.chance(0.5):
        leaves = [
            ellipsoid(0.028, 0.013, 0.0016, 8, 4).turn(2, s * 0.7).move(x * h, s * 0.016, 0.005)
            for x, s in ((0.3, 1), (0.6, -1), (0.8, 1), (0.02, 1.4), (0.45, -1.6))
        ]
        pieces.append((join(leaves), surfaces.plain(look.own_color("green", "olive", "sage"))))
    x = main.vertices[:, 0]
    return shape(pieces, [flat_foot(above(main.vertices[x < 0.05 * h]), 0.4),
                          flat_foot(above(main.vertices[x > -0.05 * h]), 0.4),
                          flat_foot(above(join(forks).vertices), 0.4)])  # fmt: skip


@category("driftwood", size=(0.25, 0.085, 0.04), mass=0.12, material="wood",
          aliases=("piece of driftwood", "drift wood", "log", "wooden offcut", "wood offcut"),
          themes=("living",), colors=("gray",), state="lying")  # fmt: skip
def driftwood(look: Look) -> Shape:
    """A bleached piece of driftwood, bent and forked."""
    color = look.color("gray", "tan", "beige", "silver", "cream")
    long = look.between(0.2, 0.3)
    h = long / 2
    bark = surfaces.wood(look.rng, color, grain=1.6)
    main = rod([(-h, 0.01, 0.014), (-0.4 * h, -0.008, 0.018), (0.3 * h, 0.008, 0.017),
                (h, -0.012, 0.012)], [0.008, 0.017, 0.015, 0.006], 10)  # fmt: skip
    fork = rod([(0.0, 0, 0.02), (0.35 * h, 0.03, 0.032), (0.62 * h, 0.05, 0.03)],
               [0.011, 0.008, 0.004], 8)  # fmt: skip
    stub = rod([(-0.4 * h, -0.005, 0.02), (-0.55 * h, -0.02, 0.03), (-0.6 * h, -0.03, 0.036)],
               [0.01, 0.007, 0.005], 8)  # fmt: skip
    x = main.vertices[:, 0]
    return shape([(join([main, fork, stub]), bark)], [hull_part(above(main.vertices[x < 0.02])),
                                                      hull_part(above(main.vertices[x > -0.02])),
                                                      hull_part(fork.vertices)])  # fmt: skip
