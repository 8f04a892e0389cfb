"""Objects of the ``kitchen`` theme: meats."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import skin
from ...kit.outlines import smooth
from ...kit.parts import box_part, hull_of
from ...kit.primitives import bent_rod, limb, straight
from ...kit.shapes import Shape, category, settle, shape, vary
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    prism,
    torus,
    tube,
)
from ...kit.surfaces import Look, tint_color


@category("burger_patty", size=(0.1, 0.1, 0.0188), mass=0.11, material="food", aliases=("patty",
          "hamburger patty", "meat patty", "beef patty", "veggie patty", "sausage patty",
          "salisbury steak"), themes=("kitchen", "dining"), roles=("edible", "flat", "round"),
          colors=("brown",), state="lying flat")  # fmt: skip
def burger_patty(look: Look) -> Shape:
    """A grilled burger patty with dark grill lines."""
    r, h = look.between(0.046, 0.054), look.between(0.016, 0.02)
    body = lathe([(0, 0), (0.9 * r, 0), (r, 0.35 * h), (r, 0.7 * h), (0.9 * r, h), (0, h)], 28)
    color = tint_color(look.color("brown", "brown", "bronze"), 0.95)
    bars = [box(2 * np.sqrt(r * r - y * y) * 0.86, 0.004, 0.001).move(y=y, z=h - 0.0005)
            for y in (-0.026, -0.013, 0, 0.013, 0.026)]  # fmt: skip
    return shape([(body, surfaces.spots(look.rng, color, tint_color(color, 0.6), 0.3)),
                  (join(bars), surfaces.plain(tint_color(color, 0.4)))],
                 [hull_of(body)])  # fmt: skip


@category("roast_beef", size=(0.258, 0.0995, 0.0765), mass=1.0, material="food",
          aliases=("roast beef joint", "beef joint", "roast joint", "joint of beef", "brisket",
          "pot roast", "roast pork", "roast lamb", "sunday roast", "gammon joint"),
          themes=("kitchen", "dining"), roles=("edible", "big"), colors=("brown",),
          state="lying flat")  # fmt: skip
def roast_beef(look: Look) -> Shape:
    """A roast joint, pink inside and tied with string, with one slice cut off."""
    long, r = look.between(0.15, 0.19), look.between(0.045, 0.055)
    body = bent_rod(long, r, blunt=8, squash=0.85)
    loops = [torus(1.0 * r, 0.0014, 26, 6).turn(1, np.pi / 2).scale(1, 1, 0.86).move(x=u * long)
             for u in (-0.28, -0.08, 0.12)]  # fmt: skip
    face = cylinder(0.88 * r, 0.003, 26).turn(1, np.pi / 2).scale(1, 1, 0.85).move(x=0.478 * long)
    cut = block(0.014, 1.7 * r, 0.009, 0.006, 0.002).scale(6.0, 1, 1).move(x=0.78 * long,
                                                                         z=-0.85 * r)  # fmt: skip
    dark = skin(look, tint_color(look.color("brown", "bronze"), 0.8), (70, 38, 22), 1.0)
    rare = surfaces.spots(look.rng, (206, 120, 104), (176, 86, 72), 0.2)
    return settle([(body, dark), (join([face, cut]), rare),
                   (join(loops), surfaces.plain((232, 218, 186)))], 0.1,
                  hulls=[[0], [1]])  # fmt: skip


@category("meatloaf", size=(0.189, 0.092, 0.0688), mass=0.8, material="food",
          aliases=("meat loaf", "nut roast", "pate", "terrine"), themes=("kitchen", "dining"),
          roles=("edible",), colors=("red",))  # fmt: skip
def meatloaf(look: Look) -> Shape:
    """A brown meatloaf with a red glaze and a cut end."""
    x, y, h = look.between(0.17, 0.2), look.between(0.085, 0.1), look.between(0.06, 0.07)
    body = block(x, y, h, 0.02, 0.012)
    glaze = block(0.9 * x, 0.72 * y, 0.01, 0.018, 0.004).move(z=h - 0.006)
    tone = look.color("red", "crimson", "brown")
    meat = surfaces.spots(look.rng, (132, 84, 52), (92, 54, 34), 0.3)
    return shape([(body, meat), (glaze, surfaces.speckles(look.rng, tint_color(tone, 0.75), 8))],
                 [box_part(x, y, h + 0.004)])  # fmt: skip


@category("lamb_chop", size=(0.152, 0.0753, 0.018), mass=0.12, material="food",
          aliases=("pork chop", "cutlet", "lamb cutlet", "chop", "veal chop"),
          themes=("kitchen", "dining"), roles=("edible", "flat"), colors=("brown",),
          state="lying flat")  # fmt: skip
@vary()
def lamb_chop(look: Look) -> Shape:
    """A grilled lamb chop with a rim of fat and a protruding bone."""
    k = look.between(0.9, 1.1)
    ring = smooth(np.array([(-0.042, 0.0), (-0.03, -0.03), (0.005, -0.035), (0.034, -0.02),
                            (0.03, 0.014), (0.0, 0.03), (-0.03, 0.024), (-0.042, 0.0)]),
                  4)[:-1]  # fmt: skip
    fat = prism(ring * 1.1, 0, 0.017, 0.004)
    meat = prism(ring * 0.96, 0.001, 0.0185, 0.003)
    bone = limb([(0.02, -0.004, 0.009), (0.048, 0.012, 0.009), (0.076, 0.022, 0.008)],
                [0.007, 0.0055, 0.007], 8)  # fmt: skip
    color = look.color("brown", "bronze", "brown")
    tile = surfaces.spots(look.rng, tint_color(color, 0.85), tint_color(color, 0.5), 0.22)
    return settle([(fat, surfaces.speckles(look.rng, (238, 210, 170), 8)), (meat, tile),
                   (bone, surfaces.plain((236, 226, 206)))], 0.02,
                  hulls=[[0, 1], [2]]).scale(k)  # fmt: skip


@category("chicken_breast", size=(0.148, 0.0791, 0.0298), mass=0.17, material="food",
          aliases=("chicken fillet", "breast of chicken", "turkey breast", "duck breast",
          "grilled chicken"), themes=("kitchen", "dining"), roles=("edible",), colors=("beige",),
          state="lying flat")  # fmt: skip
def chicken_breast(look: Look) -> Shape:
    """A chicken breast fillet, raw or grilled."""
    k = look.between(0.9, 1.1)
    ring = smooth(np.array([(-0.075, 0.0), (-0.04, -0.035), (0.02, -0.042), (0.065, -0.014),
                            (0.07, 0.012), (0.02, 0.036), (-0.04, 0.026), (-0.075, 0.0)]),
                  5)[:-1]  # fmt: skip
    body = dome(ring, 0.03)
    color = look.color("beige", "amber", "tan")
    pieces = [(body, skin(look, tint_color(color, 1.1), tint_color(color, 0.85), 0.7))]
    if look.chance(0.6):
        bars = [ellipsoid(0.055, 0.004, 0.003, 8, 4).turn(2, 0.9).move(x, -0.003, 0.0285)
                for x in (-0.02, 0.0, 0.02)]  # fmt: skip
        pieces.append((join(bars), surfaces.plain((110, 66, 36))))
    return shape(pieces, [hull_of(body)]).scale(k)


@category("kofta", size=(0.275, 0.0286, 0.0251), mass=0.1, material="food", assembled=True,
          aliases=("kofta kebab", "seekh kebab", "kofte", "kafta", "adana kebab"),
          themes=("kitchen", "dining"), roles=("edible",), colors=("brown",),
          state="lying flat")  # fmt: skip
@vary()
def kofta(look: Look) -> Shape:
    """A kofta: minced meat pressed around a flat skewer."""
    k = look.between(0.92, 1.08)
    a = np.linspace(-1, 1, 24)
    radii = 0.0135 * np.sqrt(np.maximum(1 - np.abs(a) ** 8, 0.06)) * (1 + 0.08 * np.sin(14 * a))
    meat = tube(np.column_stack([0.075 * a, 0 * a, 0 * a]), radii, 12)
    stick = straight((-0.15, 0, 0), (0.13, 0, 0), 0.0018, 6)
    brown = surfaces.spots(look.rng, tint_color(look.color("brown", "bronze"), 0.9), (70, 40, 24),
                           0.3)  # fmt: skip
    return settle([(meat, brown), (stick, surfaces.brushed_metal(look.rng, (190, 192, 196)))], 0.12,
                  hulls=[[0, 1]]).scale(k)  # fmt: skip


def dome(ring: np.ndarray, h: float) -> Solid:
    """Return a dome of height ``h`` over the outline ``ring``."""
    levels = [(1.0, 0), (0.97, 0.25 * h), (0.85, 0.6 * h), (0.55, 0.92 * h), (0.15, h)]
    return loft(np.stack([np.column_stack([ring * f, np.full(len(ring), z)]) for f, z in levels]),
                ring)  # fmt: skip


@category("salami", size=(0.206, 0.0871, 0.0542), mass=0.25, material="food",
          aliases=("pepperoni", "salami sausage", "cured sausage", "cold cuts", "dry sausage"),
          themes=("kitchen",), roles=("edible",), colors=("maroon",),
          state="lying flat")  # fmt: skip
def salami(look: Look) -> Shape:
    """A salami cut at its left end, with a few slices beside it."""
    long, r = look.between(0.12, 0.16), look.between(0.024, 0.03)
    body = lathe([(0, 0), (r, 0), (r, 0.86 * long), (0.7 * r, 0.96 * long), (0.15 * r, long),
                  (0, long)], 26)  # fmt: skip
    color = look.color("maroon", "crimson", "brown")
    face = surfaces.spots(look.rng, tint_color(color, 1.05), (240, 220, 206), 0.22)
    casing = surfaces.spots(look.rng, tint_color(color, 0.75), (214, 196, 186), 0.14)
    cut = cylinder(0.93 * r, 0.002, 26).move(z=-0.001)
    laid = [(s.turn(1, np.pi / 2).move(-0.3 * long, 0, r), t)
            for s, t in ((body, casing), (cut, face))]  # fmt: skip
    flat = [cylinder(r, 0.003, 26).move(-0.3 * long - (0.25 + 0.55 * n) * r, -(1.2 - 0.3 * n) * r,
            0.003 * n) for n in range(3)]  # fmt: skip
    return shape([*((s, t) for s, t in laid), *((s, face) for s in flat)],
                 [hull_of(laid[0][0]), *(hull_of(s) for s in flat)])  # fmt: skip


@category("tofu", size=(0.0924, 0.0712, 0.0411), mass=0.3, material="food",
          aliases=("block of tofu", "tofu block", "feta", "paneer", "halloumi", "bean curd"),
          themes=("kitchen",), roles=("edible",), colors=("ivory",))  # fmt: skip
def tofu(look: Look) -> Shape:
    """A white block of tofu with bevelled corners and a faint grid."""
    x, y, h = look.between(0.085, 0.1), look.between(0.065, 0.078), look.between(0.035, 0.045)
    color = look.color("ivory", "cream", "white", "ivory")
    tile = surfaces.spots(look.rng, color, tint_color(color, 0.93), 0.15)
    cut = [box(0.0014, y * 0.99, 0.001).move(x=(n - 1) * x / 3.2, z=h - 0.0006) for n in range(3)]
    cut += [box(x * 0.99, 0.0014, 0.001).move(y=(n - 0.5) * y / 2.4, z=h - 0.0006)
            for n in range(2)]  # fmt: skip
    return shape([(block(x, y, h, 0.004, 0.002), tile),
                  (join(cut), surfaces.plain(tint_color(color, 0.82)))],
                 [box_part(x, y, h)])  # fmt: skip
