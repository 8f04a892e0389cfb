"""Objects of the ``kitchen`` theme: trash."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import steel
from ...kit.outlines import rectangle, smooth
from ...kit.parts import hull_above, hull_of
from ...kit.primitives import at_box, ball, drum, limb, plate, straight
from ...kit.shapes import Category, Shape, category, keep_still, put_down, settle, shape
from ...kit.solids import cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...kit.surfaces import Look, plain, tint_color
from .fruit import peel_strip


@category("fish_skeleton", size=(0.244, 0.0711, 0.00743), mass=0.02, material="food",
          assembled=True, aliases=("fishbone", "skeleton of a fish", "fish head"),
          themes=("kitchen", "dining"), roles=("flat",), colors=("ivory",),
          state="lying flat")  # fmt: skip
def fish_skeleton(look: Look) -> Shape:
    """The bare bones of a fish, with its head and tail."""
    k = look.between(0.9, 1.1)
    color = look.color("ivory", "white", "cream")
    spine = limb([(-0.07, 0, 0.004), (0, 0, 0.004), (0.09, 0, 0.004)], [0.0032, 0.003, 0.0018], 6)
    ribs = [limb([(x, 0, 0.004), (x + 0.008, s * 0.5 * w, 0.005), (x + 0.016, s * w, 0.002)],
                 [0.0018, 0.0015, 0.0008], 5)
            for x, w in ((-0.06, 0.032), (-0.042, 0.036), (-0.024, 0.034), (-0.006, 0.03),
                         (0.012, 0.025), (0.03, 0.02), (0.048, 0.014), (0.064, 0.009))
            for s in (-1, 1)]  # fmt: skip
    head = prism(smooth(np.array([(-0.125, 0), (-0.1, -0.026), (-0.068, -0.03), (-0.072, 0),
                                  (-0.068, 0.03), (-0.1, 0.026), (-0.125, 0)]), 3)[:-1], 0, 0.007,
                 0.002)  # fmt: skip
    tail = prism(np.array([(0.086, -0.003), (0.125, -0.032), (0.112, 0), (0.125, 0.032), (0.086,
                           0.003)]), 0.001, 0.005)  # fmt: skip
    eye = cylinder(0.0055, 0.001, 12).move(-0.098, 0.006, 0.0066)
    return shape([(join([spine, *ribs, head, tail]), surfaces.speckles(look.rng, color, 6)),
                  (eye, surfaces.plain((40, 38, 40)))],
                 [hull_above(spine, *ribs), hull_of(head), hull_of(tail)]).scale(k)  # fmt: skip


@category("banana_peel", size=(0.233, 0.226, 0.062), mass=0.05, material="food", assembled=True,
          aliases=("banana skin", "peel of a banana"), themes=("kitchen", "food"),
          colors=("yellow",), state="lying spread")  # fmt: skip
def banana_peel(look: Look) -> Shape:
    """A discarded banana peel: four strips spread out from the stalk, pale inside."""
    color = look.color("yellow", "gold", "yellow", "lime")
    k, strips, insides = look.between(0.85, 1.15), [], []
    for n in range(4):
        a = np.pi / 2 * n + look.between(-0.35, 0.35)
        long = look.between(0.1, 0.14)
        path = np.array([(0.004, 0, 0.036), (0.2 * long, 0, 0.034), (0.45 * long, 0, 0.016),
                         (0.7 * long, 0, 0.004), (long, 0.012, 0.003)])  # fmt: skip
        sizes = [0.008, 0.016, 0.021, 0.018, 0.004]
        strips.append(limb(path, sizes, 10, 0.16).turn(2, a))
        insides.append(
            limb(np.add(path, (0, 0, 0.0014)), [0.66 * s for s in sizes], 10, 0.17).turn(2, a)
        )
    stalk = limb(
        [(0, 0, 0.034), (0, 0.002, 0.05), (0.005, 0.004, 0.062)], [0.011, 0.006, 0.005], 10
    )
    peel = surfaces.spots(look.rng, color, (120, 90, 40), 0.03)
    made = [(join([*strips, stalk]), peel), (join(insides), surfaces.plain((250, 240, 206)))]
    return settle(made, 0.01).scale(k)


@category("apple_core", size=(0.0809, 0.0521, 0.0476), mass=0.03, material="food",
          aliases=("core of an apple", "eaten apple", "half eaten apple", "bitten apple core"),
          themes=("kitchen", "food"), colors=("red",), state="lying")  # fmt: skip
def apple_core(look: Look) -> Shape:
    """An apple core lying flat: red ends, a thin pale middle with pips, and the stalk."""
    color = look.color("red", "green", "crimson", "yellow", "lime")
    d, h = look.between(0.058, 0.07), look.between(0.062, 0.072)
    thin = look.between(0.16, 0.22)
    body = lathe([(0, 0), (0.2 * d, 0), (0.36 * d, 0.08 * h), (0.34 * d, 0.2 * h),
                  (thin * d, 0.36 * h), (thin * d, 0.6 * h), (0.34 * d, 0.8 * h),
                  (0.4 * d, 0.88 * h), (0.3 * d, 0.98 * h), (0, 0.94 * h)], 26)  # fmt: skip
    pale = surfaces.speckles(look.rng, (246, 232, 190), 10)
    peel = surfaces.speckles(look.rng, color, 10)
    tile = surfaces.stack((peel, 0.3), (pale, 0.4), (peel, 0.3))
    pips = [ellipsoid(0.005, 0.004, 0.008, 8, 5).move(thin * d * np.cos(a), thin * d * np.sin(a),
            0.48 * h) for a in (0.4, 2.6, 4.5)]  # fmt: skip
    stalk = tube([(0, 0, 0.9 * h), (0.004, 0, 1.2 * h)], 0.0014, 6)
    dark = surfaces.plain((74, 48, 34))
    made = [(body, tile), (join([*pips, stalk]), dark)]
    return settle([(s.turn(1, np.pi / 2), t) for s, t in made], 0.08)


@category("foil_ball", size=(0.05, 0.0499, 0.0421), mass=0.01, material="metal",
          aliases=("ball of foil", "crumpled foil", "tin foil ball"), themes=("kitchen",),
          colors=("silver",))  # fmt: skip
def foil_ball(look: Look) -> Shape:
    """A ball of crumpled kitchen foil."""
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
        [(made, surfaces.scratches(look.rng, color, tint_color(color, 1.4), 140))], made
    )


@category("fruit_peel", size=(0.0583, 0.0661, 0.0213), mass=0.012, material="food",
          aliases=("potato peel", "apple peel", "peel", "potato peeling", "peeling", "melon rind",
          "rind", "vegetable peel"), themes=("kitchen",), colors=("orange", "yellow"))  # fmt: skip
def fruit_peel(look: Look) -> Shape:
    """A curl of fruit peel in a loose spiral."""
    color = look.color("orange", "yellow", "tan", "lime", "red")
    k = look.between(0.8, 1.2)
    t = np.linspace(0, 2.6 * np.pi, 44)
    r = 0.014 + 0.022 * t / t[-1]
    path = np.column_stack([r * np.cos(t), r * np.sin(t), 0.009 + 0.004 * np.sin(1.7 * t)])
    width = 0.0016 * np.clip(8 * np.minimum(t, t[-1] - t) / t[-1] + 0.3, 0.3, 1)
    curl = tube(path, width, 8, squash=5)
    bits = [tube(path[i : i + 9], 0.0015, 8, squash=4.6) for i in (0, 8, 16, 24, 35)]
    return put_down(
        [(curl, surfaces.spots(look.rng, color, tint_color(color, 0.8), 0.2))], *bits, factor=k
    )


@category("ring_pull", size=(0.0359, 0.0231, 0.00406), mass=0.001, material="metal",
          aliases=("can tab", "pull tab", "can pull", "soda tab"), themes=("kitchen",),
          roles=("flat",), colors=("silver",))  # fmt: skip
def ring_pull(look: Look) -> Shape:
    """The ring pull of a can."""
    color = look.color("silver", "gold", "red", "blue", "green")
    k = look.between(0.9, 1.3)
    ring = torus(0.0085, 0.0019, 22, 7).move(0.004, 0, 0.0018)
    tab = plate(rectangle(0.016, 0.015, 0.005), 0.0022, at=(-0.01, 0, 0))
    rivet = drum(0.003, 0.0014, (-0.009, 0, 0.002))
    return put_down([(join([ring, tab, rivet]), steel(look, color))], ring, tab, factor=k)


@category("six_pack_ring", size=(0.187, 0.125, 0.00249), mass=0.005, material="plastic",
          aliases=("six pack ring", "can rings", "plastic rings"), themes=("kitchen",),
          roles=("flat", "big"), colors=("clear",))  # fmt: skip
def six_pack_ring(look: Look) -> Shape:
    """Six joined rings of clear plastic, lying flat."""
    color = look.color("clear", "white", "gray", "sky")
    k = look.between(0.85, 1.1)
    rings = [torus(0.032, 0.0022, 26, 6).scale(1, 1, 0.7).move(x, y, 0.0016)
             for x in (-0.066, 0, 0.066) for y in (-0.033, 0.033)]  # fmt: skip
    links = [
        at_box(0.012, 0.01, 0.002, (x, y, 0.0004)) for x in (-0.033, 0.033) for y in (-0.033, 0.033)
    ]
    return put_down([(join([*rings, *links]), plain(color))], join(rings), factor=k)


@category("fish_bone", size=(0.195, 0.0567, 0.00641), mass=0.01, material="food",
          themes=("kitchen",), roles=("flat",), colors=("ivory",))  # fmt: skip
def fish_bone(look: Look) -> Shape:
    """Fish bones lying flat: a head, a spine, ribs and a tail."""
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
    return put_down([(join([spine, *ribs, head, tail]), surfaces.speckles(look.rng, color, 8)),
                     (eye, plain((60, 56, 52)))], join([spine, *ribs]), head, tail,
                    factor=k)  # fmt: skip


@category("corn_husk", size=(0.159, 0.11, 0.0175), mass=0.02, material="food",
          aliases=("husk", "husk of corn"), themes=("kitchen",), colors=("lime",))  # fmt: skip
def corn_husk(look: Look) -> Shape:
    """Leaves of a peeled corn husk, lying flat."""
    color = look.color("lime", "tan", "sage", "olive")
    k = look.between(0.85, 1.15)
    leaves = []
    for n in range(5):
        a = 0.34 * (n - 2)
        rim = [(0, -0.008), (0.05, -0.019), (0.11, -0.012), (0.15, 0), (0.11, 0.012), (0.05, 0.019),
               (0, 0.008)]  # fmt: skip
        leaves.append(plate(rim, 0.002, at=(-0.06, 0, 0.0007 * n)).turn(2, a))
    knot = ball(0.03, 0.026, 0.02, (-0.058, 0, 0.008), 12)
    lines = surfaces.stripes([color, tint_color(color, 0.85), tint_color(color, 1.15)], 6)
    return put_down(
        [(join(leaves), lines), (knot, plain(tint_color(color, 0.8)))], join(leaves), knot, factor=k
    )


CATEGORIES = (
    Category("orange_peel", keep_still(peel_strip(("orange", "orange", "amber"), False)),
             size=(0.0531, 0.0531, 0.0249), mass=0.015, material="food", assembled=True,
             aliases=("lemon peel", "citrus peel", "orange rind", "orange twist", "lemon twist",
             "strip of orange peel"), themes=("kitchen", "food"), roles=("edible",),
             colors=("orange", "yellow"), state="lying curled"),
)  # fmt: skip
"""Objects that share their drawing functions."""
