"""Rubbish: wrappers, tubes, butts, peels, cores, crusts, bones."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import ring_parts
from ...build.making import at_box, drum, plate, steel
from ...build.outlines import rectangle
from ...build.recipes import ball, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import join, lathe, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def foil_ball(look: Look) -> Shape:
    """A ball of kitchen foil."""
    color = look.color("silver", "silver", "gold", "copper")
    d = look.between(0.04, 0.065)
    knots = look.rng.normal(size=(30, 3))
    knots /= np.linalg.norm(knots, axis=1, keepdims=True)

    def warp(p: np.ndarray) -> np.ndarray:
        unit = p / np.maximum(np.linalg.norm(p, axis=1, keepdims=True), 1e-9)
        near = np.sort(unit @ knots.T, axis=1)[:, -2:]
        return p * (1 - 0.16 * np.clip((near[:, 1] - near[:, 0]) / 0.13, 0, 1))[:, None]

    made = ball(d, d, 0.9 * d, (0, 0, 0), 28).bend(warp)
    made = made.move(z=-float(made.bounds[0, 2]) - 0.06 * d)
    return put_down(
        [(made, textures.scratches(look.rng, color, tint_color(color, 1.4), 140))], made
    )


def cardboard_tube(look: Look) -> Shape:
    """An empty cardboard tube standing, its spiral seam showing."""
    color = look.color("tan", "brown", "beige", "wooden")
    long = look.pick([0.1, 0.1, 0.23]) * look.between(0.92, 1.08)
    r = look.between(0.02, 0.024)
    wall = lathe([(r, 0), (r, long), (r - 0.0016, long), (r - 0.0016, 0)], 28, loop=True)
    y, x = np.mgrid[0:96, 0:96] / 96
    seam = (np.abs((x + 2 * y) % 1 - 0.5) < 0.03)[..., None]
    image = np.where(seam, np.array(color) * 0.75, np.array(color) + 6 * np.sin(60 * x)[..., None])
    parts = ring_parts([(r, 0), (r, long)], [(r - 0.0016, long), (r - 0.0016, 0)])
    return shape([(wall, np.clip(image, 0, 255).astype(np.uint8))], parts)


def cigarette_butt(look: Look) -> Shape:
    """A stubbed-out cigarette end, bent."""
    k = look.between(0.85, 1.2)
    color = look.color("orange", "tan", "white")
    z = 0.0038
    tip = straight((0.0, 0, z), (0.018, 0.001, z), 0.004, 12)
    paper = rod(
        [(-0.012, 0.0035, z), (-0.006, 0.0005, z), (0.0, 0, z)], [0.0034, 0.0039, 0.0039], 12
    )
    ash = ball(0.008, 0.007, 0.006, (-0.0125, 0.004, 0.0032), 8)
    filt = textures.spots(look.rng, color, tint_color(color, 1.4), 0.15)
    return put_down(
        [(tip, filt), (paper, plain((240, 236, 228))), (ash, plain((84, 78, 74)))],
        tip,
        paper,
        factor=k,
        foot=0.3,
    )


def fruit_peel(look: Look) -> Shape:
    """A curl of peel lying in a loose spiral."""
    color = look.color("orange", "yellow", "tan", "lime", "red")
    k = look.between(0.8, 1.2)
    t = np.linspace(0, 2.6 * np.pi, 44)
    r = 0.014 + 0.022 * t / t[-1]
    path = np.column_stack([r * np.cos(t), r * np.sin(t), 0.009 + 0.004 * np.sin(1.7 * t)])
    width = 0.0016 * np.clip(8 * np.minimum(t, t[-1] - t) / t[-1] + 0.3, 0.3, 1)
    curl = tube(path, width, 8, squash=5)
    bits = [tube(path[i : i + 9], 0.0015, 8, squash=4.6) for i in (0, 8, 16, 24, 35)]
    return put_down(
        [(curl, textures.spots(look.rng, color, tint_color(color, 0.8), 0.2))], *bits, factor=k
    )


def crust(look: Look) -> Shape:
    """A bitten end of a slice of bread."""
    color = look.color("brown", "tan", "wooden")
    k = look.between(0.85, 1.2)
    a = np.linspace(0.1, np.pi - 0.1, 9)
    rim = np.concatenate(
        [
            np.column_stack([0.045 * np.cos(a), 0.032 * np.sin(a)]),
            [(-0.03, 0.006), (-0.018, 0.012), (-0.006, 0.004), (0.008, 0.013), (0.022, 0.005)],
        ]
    )
    rind, crumb = plate(rim, 0.014), plate(0.86 * rim + [0, 0.001], 0.0155, at=(0, 0, -0.0006))
    return put_down(
        [
            (rind, textures.speckles(look.rng, tint_color(color, 0.9), 10)),
            (
                crumb.move(z=0.0006),
                textures.spots(look.rng, (238, 220, 180), (210, 180, 130), 0.15),
            ),
        ],
        rind,
        factor=k,
    )


def ring_pull(look: Look) -> Shape:
    """The tab of a can."""
    color = look.color("silver", "gold", "red", "blue", "green")
    k = look.between(0.9, 1.3)
    ring = torus(0.0085, 0.0019, 22, 7).move(0.004, 0, 0.0018)
    tab = plate(rectangle(0.016, 0.015, 0.005), 0.0022, at=(-0.01, 0, 0))
    rivet = drum(0.003, 0.0014, (-0.009, 0, 0.002))
    return put_down([(join([ring, tab, rivet]), steel(look, color))], ring, tab, factor=k)


def six_pack_ring(look: Look) -> Shape:
    """Six joined rings of clear plastic, lying."""
    color = look.color("clear", "white", "gray", "sky")
    k = look.between(0.85, 1.1)
    rings = [torus(0.032, 0.0022, 26, 6).scale(1, 1, 0.7).move(x, y, 0.0016)
             for x in (-0.066, 0, 0.066) for y in (-0.033, 0.033)]  # fmt: skip
    links = [
        at_box(0.012, 0.01, 0.002, (x, y, 0.0004)) for x in (-0.033, 0.033) for y in (-0.033, 0.033)
    ]
    return put_down([(join([*rings, *links]), plain(color))], join(rings), factor=k)


def fish_bone(look: Look) -> Shape:
    """The bones of a fish: head, spine, ribs and tail, lying."""
    color = look.color("ivory", "cream", "white", "gray")
    k = look.between(0.8, 1.15)
    spine = straight((-0.075, 0, 0.003), (0.06, 0, 0.003), [0.0016, 0.0026], 8)
    ribs = []
    for n in range(9):
        x, long = -0.055 + 0.0125 * n, 0.014 + 0.0018 * n
        ribs += [
            straight((x, 0, 0.0028), (x - 0.008, s * long, 0.0014), 0.0013, 6) for s in (-1, 1)
        ]
    head = plate([(0.055, -0.018), (0.098, 0), (0.055, 0.018), (0.062, 0)], 0.006)
    eye = drum(0.004, 0.001, (0.07, 0.004, 0.0055))
    tail = plate([(-0.068, 0), (-0.1, 0.022), (-0.092, 0), (-0.1, -0.022)], 0.004)
    return put_down(
        [
            (join([spine, *ribs, head, tail]), textures.speckles(look.rng, color, 8)),
            (eye, plain((60, 56, 52))),
        ],
        join([spine, *ribs]),
        head,
        tail,
        factor=k,
    )


def scrap(look: Look) -> Shape:
    """A torn piece of card or metal, lying."""
    color = look.color("tan", "gray", "silver", "brown")
    n = 11
    a = 2 * np.pi * (np.arange(n) + 0.3 * look.rng.uniform(-1, 1, n)) / n
    r = look.between(0.035, 0.05) * look.rng.uniform(0.78, 1.15, n)
    made = plate(np.column_stack([1.2 * r * np.cos(a), r * np.sin(a)]), look.between(0.0025, 0.004))
    flat = "silver" if min(color) > 120 and max(color) - min(color) < 20 else "card"
    tile = steel(look, color) if flat == "silver" else textures.cardboard(look.rng, color)
    return put_down([(made, tile)], made)


def corn_husk(look: Look) -> Shape:
    """Leaves of a corn husk, peeled back and lying."""
    color = look.color("lime", "tan", "sage", "olive")
    k = look.between(0.85, 1.15)
    leaves = []
    for n in range(5):
        a = 0.34 * (n - 2)
        rim = [
            (0, -0.008),
            (0.05, -0.019),
            (0.11, -0.012),
            (0.15, 0),
            (0.11, 0.012),
            (0.05, 0.019),
            (0, 0.008),
        ]
        leaves.append(plate(rim, 0.002, at=(-0.06, 0, 0.0007 * n)).turn(2, a))
    knot = ball(0.03, 0.026, 0.02, (-0.058, 0, 0.008), 12)
    lines = textures.stripes([color, tint_color(color, 0.85), tint_color(color, 1.15)], 6)
    return put_down(
        [(join(leaves), lines), (knot, plain(tint_color(color, 0.8)))], join(leaves), knot, factor=k
    )


CATEGORIES = (
    Category("foil_ball", foil_ball, (0.05, 0.0499, 0.0421), 0.01,
             ("ball of foil", "crumpled foil", "tin foil ball"), ("kitchen",), (), ("silver",)),
    Category("cardboard_tube", cardboard_tube, (0.0446, 0.0446, 0.165), 0.01,
             ("toilet roll tube", "paper towel tube", "empty toilet roll", "kitchen roll tube",
              "cardboard roll", "paper tube", "empty roll", "film poster tube", "poster tube"),
             ("craft",), ("tall",), ("tan",)),
    Category("cigarette_butt", cigarette_butt, (0.0347, 0.0114, 0.00784), 0.001,
             ("cigarette end", "cigarette stub", "fag end"), ("living",), (), ("orange",)),
    Category("fruit_peel", fruit_peel, (0.0583, 0.0661, 0.0213), 0.012,
             ("potato peel", "apple peel", "peel", "potato peeling",
             "peeling",
              "melon rind", "rind", "vegetable peel"), ("kitchen",), (), ("orange", "yellow")),
    Category("bread_crust", crust, (0.0879, 0.0283, 0.0152), 0.015, ("crust", "crust of bread",
             "bitten toast"),
             ("kitchen",), (), ("brown",)),
    Category("ring_pull", ring_pull, (0.0359, 0.0231, 0.00406), 0.001, ("can tab", "pull tab",
             "can pull", "soda tab"),
             ("kitchen",), ("flat",), ("silver",)),
    Category("six_pack_ring", six_pack_ring, (0.187, 0.125, 0.00249), 0.005, ("six pack ring",
             "can rings", "plastic rings"),
             ("kitchen",), ("flat", "big"), ("clear",)),
    Category("fish_bone", fish_bone, (0.195, 0.0567, 0.00641), 0.01, (), ("kitchen",), ("flat",),
             ("ivory",)),
    Category("scrap", scrap, (0.0983, 0.0813, 0.00334), 0.01,
             ("cardboard scrap", "metal scrap", "scrap of card", "scrap metal",
             "scrap of cardboard",
              "piece of cardboard", "torn card"), ("workbench",), ("flat",), ("tan", "gray")),
    Category("corn_husk", corn_husk, (0.159, 0.11, 0.0175), 0.02, ("husk", "husk of corn"),
             ("kitchen",), (), ("lime",)),
)  # fmt: skip
"""The module's categories."""
