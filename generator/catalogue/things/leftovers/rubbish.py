"""Rubbish: wrappers, tubes, butts, peels, cores, crusts, bones."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import ring_parts
from ...build.outlines import rectangle
from ...build.recipes import ball, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.sketch import bar, cut, disc, lies, plain, steel, turned
from ...build.solids import Solid, box, join, lathe, loft, refine, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def _crease(look: Look, solid: Solid, high: float, waves: float = 60.0) -> Solid:
    """Return a thin solid with its surface thrown into irregular folds up to ``high``."""
    a, b, c = (look.between(0, 6.3) for _ in range(3))

    def warp(p: np.ndarray) -> np.ndarray:
        rise = np.sin(waves * p[:, 0] + a) + np.sin(waves * (0.6 * p[:, 1] - 0.8 * p[:, 0]) + b)
        rise = rise + 0.6 * np.sin(2 * waves * (p[:, 1] + 0.3 * p[:, 0]) + c)
        return np.column_stack([p[:, :2], p[:, 2] + high * (rise + 2.6) / 5.2])

    return solid.bend(warp)


def _sheet(x: float, y: float, thick: float, n: int = 3) -> Solid:
    made = box(x, y, thick)
    for _ in range(n):
        made = refine(made)
    return made


def wrapper(look: Look) -> Shape:
    """An empty sweet wrapper, creased, its ends crimped."""
    color = look.color("red", "gold", "blue", "purple", "green", "silver", "orange")
    k = look.between(0.8, 1.25)
    made = _crease(look, _sheet(0.12, 0.055, 0.0012), 0.012, 90)
    ends = [
        _crease(look, _sheet(0.014, 0.06, 0.001, 2).move(s * 0.065), 0.012, 90) for s in (-1, 1)
    ]
    image = prints.canvas(160, 80, color)
    prints.fill(
        image, 0, 0.36, 1, 0.3, tint_color(color, 1.6) if sum(color) < 500 else (150, 40, 40)
    )
    prints.write(image, look.pick(["CHOCO", "SWEET", "NUTTY", "MINT", "CRUNCH"]), 0.5, 0.51, 0.24,
                 tint_color(color, 0.5), bold=True)  # fmt: skip
    foil = textures.stripes([(206, 208, 212), (168, 170, 178)], 16, upright=True)
    return put_down([(made, image), (join(ends), foil)], join([made, *ends]), factor=k, foot=0.3)


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


def banana_peel(look: Look) -> Shape:
    """A banana skin, its four flaps spread from the stalk."""
    color = look.color("yellow", "mustard", "yellow", "lime")
    k = look.between(0.85, 1.15)
    plates = []
    for n in range(4):
        a = n * np.pi / 2 + look.between(-0.3, 0.3)
        long = look.between(0.085, 0.12)
        t = np.linspace(0, 1, 9)
        x = 0.004 + (long - 0.004) * t
        z = 0.003 + 0.042 * np.cos(np.clip(t * 2.2, 0, np.pi / 2)) ** 1.2
        w = 0.0065 + 0.013 * np.sin(np.pi * np.clip(t * 0.9 + 0.1, 0, 1)) ** 0.8
        left = np.column_stack([x, w, z])
        right = np.column_stack([x, -w, z])
        middle, down = (left + right) / 2, np.array([0, 0, 0.0022])
        rims = [right - down, middle - 1.3 * down, left - down, left, middle + 0.4 * down, right]
        rings = np.stack(rims, axis=1)
        plates.append(loft(rings, rings[0][:, 1:]).turn(2, a))
    stalk = rod([(0, 0, 0.04), (0.002, 0, 0.058), (0.006, 0, 0.068)], [0.008, 0.0045, 0.004], 8)
    image = textures.spots(look.rng, color, (110, 80, 40), 0.06)
    return put_down(
        [(join(plates), image), (stalk, plain((120, 100, 50)))], *plates, stalk, factor=k
    )


def apple_core(look: Look) -> Shape:
    """An eaten apple lying: a thin pale waist, skin left at both ends, a stalk."""
    color = look.color("red", "green", "yellow", "crimson")
    k = look.between(0.85, 1.15)
    core = lies(
        turned(
            [(0.011, -0.028), (0.009, -0.016), (0.0075, 0), (0.009, 0.016), (0.012, 0.028)], fine=16
        ),
        0,
        0,
        0.019,
    )
    ends = [
        lies(
            turned([(0.008, 0), (0.021, 0.005), (0.018, 0.012), (0.01, 0.013)], fine=18),
            x,
            0,
            0.019,
        )
        for x in (0.024,)
    ]
    ends.append(
        lies(
            turned([(0.009, 0), (0.017, 0.002), (0.02, 0.008), (0.007, 0.013)], fine=18),
            -0.036,
            0,
            0.019,
        )
    )
    stalk = rod([(0.033, 0, 0.019), (0.046, 0.002, 0.022)], 0.0013, 6)
    pips = [ball(0.006, 0.004, 0.003, (x, 0.0, 0.0268), 6) for x in (-0.004, 0.006)]
    flesh = textures.spots(look.rng, (242, 226, 176), (206, 170, 110), 0.12)
    return put_down(
        [
            (core, flesh),
            (join(ends), textures.speckles(look.rng, color, 10)),
            (join([stalk, *pips]), plain((84, 56, 36))),
        ],
        core,
        *ends,
        factor=k,
        foot=0.12,
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
    rind, crumb = cut(rim, 0.014), cut(0.86 * rim + [0, 0.001], 0.0155, (0, 0, -0.0006))
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
    tab = cut(rectangle(0.016, 0.015, 0.005), 0.0022, (-0.01, 0, 0))
    rivet = disc(0.003, 0.0014, (-0.009, 0, 0.002))
    return put_down([(join([ring, tab, rivet]), steel(look, color))], ring, tab, factor=k)


def six_pack_ring(look: Look) -> Shape:
    """Six joined rings of clear plastic, lying."""
    color = look.color("clear", "white", "gray", "sky")
    k = look.between(0.85, 1.1)
    rings = [torus(0.032, 0.0022, 26, 6).scale(1, 1, 0.7).move(x, y, 0.0016)
             for x in (-0.066, 0, 0.066) for y in (-0.033, 0.033)]  # fmt: skip
    links = [
        bar(0.012, 0.01, 0.002, (x, y, 0.0004)) for x in (-0.033, 0.033) for y in (-0.033, 0.033)
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
    head = cut([(0.055, -0.018), (0.098, 0), (0.055, 0.018), (0.062, 0)], 0.006)
    eye = disc(0.004, 0.001, (0.07, 0.004, 0.0055))
    tail = cut([(-0.068, 0), (-0.1, 0.022), (-0.092, 0), (-0.1, -0.022)], 0.004)
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
    made = cut(np.column_stack([1.2 * r * np.cos(a), r * np.sin(a)]), look.between(0.0025, 0.004))
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
        leaves.append(cut(rim, 0.002, (-0.06, 0, 0.0007 * n)).turn(2, a))
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
