"""Bath, sick room and kitchen shelf: towel, hair dryer, sponge, first aid, pills, flask."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.forms import lobe, side_view, wrap
from ...build.outlines import arc
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look
from ..tools.tools import lying


def folded_towel(look: Look) -> Shape:
    """A towel folded into layers, or two of them on each other."""
    x, y = look.between(0.22, 0.32), look.between(0.16, 0.22)
    pieces, z = [], 0.0
    for _ in range(2 if look.chance(0.4) else 1):
        color = look.color("white", "teal", "pink", "beige", "navy", "sage", "gray")
        pile = textures.fabric(look.rng, color, None, 40)
        band = textures.plain(tint_color(color, look.pick([0.7, 1.4])))
        layers, h = int(look.rng.integers(2, 4)), look.between(0.016, 0.022)
        for k in range(layers):
            bow = arc((-y / 2 + h / 2, z + h / 2), h / 2, np.pi / 2, 1.5 * np.pi, 6)
            fold = side_view([*bow, (y / 2, z), (y / 2, z + h)], x * (1 - 0.008 * k))
            pieces.append((fold.turn(2, np.pi / 2), pile))
            z += 0.96 * h
        stripe = box(0.97 * x, 0.018, 0.0012).move(y=-0.28 * y, z=z + 0.035 * h)
        pieces.append((stripe, band))
    return shape(pieces, [box_part(x, y, z)])


def hair_dryer(look: Look) -> Shape:
    """A hair dryer lying on its side, its nozzle towards +x."""
    k = look.between(0.92, 1.1)
    color = look.color("black", "pink", "white", "red", "teal", "purple", "charcoal")
    shell = textures.speckles(look.rng, color, 4)
    r = 0.036 * k
    barrel = lathe(
        [(0, 0), (0.7 * r, 0), (r, 0.02 * k), (r, 0.075 * k), (0.76 * r, 0.14 * k),
         (0.72 * r, 0.16 * k), (0.66 * r, 0.16 * k), (0, 0.15 * k)],
        26,
    )  # fmt: skip
    nozzle = lathe([(0, 0.152 * k), (0.76 * r, 0.152 * k), (0.6 * r, 0.2 * k), (0.5 * r, 0.2 * k),
                    (0, 0.18 * k)], 24).scale(1, 1.25, 1)  # fmt: skip
    grille = lying(cylinder(0.72 * r, 0.003, 24), -0.082 * k, r)
    grip = tube([(-0.03 * k, 0, 0.8 * r), (-0.024 * k, -0.07 * k, 0.6 * r),
                 (-0.03 * k, -0.14 * k, 0.5 * r)], [0.5 * r, 0.46 * r, 0.48 * r], 14)  # fmt: skip
    switch = box(0.012, 0.026, 0.004).move(-0.026 * k, -0.075 * k, 1.05 * r)
    keel = box(0.08 * k, 0.9 * r, 0.5 * r).move(x=-0.025 * k)
    trim = textures.plain(look.own_color("silver", "black", "gold", "charcoal"))
    body = lying(barrel, -0.08 * k, r)
    tip = lying(nozzle, -0.08 * k, r)
    return shape(
        [(join([body, grip, keel]), shell), (tip, trim), (switch, trim),
         (grille, prints.mesh_holes((70, 72, 76), (16, 16, 18), 9, 9))],
        [hull_of(body, keel), hull_of(tip), hull_of(grip, keel)],
    )  # fmt: skip


def sponge(look: Look) -> Shape:
    """A kitchen sponge with its scouring side, up or down."""
    x, y = look.between(0.09, 0.11), look.between(0.06, 0.07)
    soft, pad = look.between(0.022, 0.028), look.between(0.007, 0.01)
    color = look.color("yellow", "pink", "sky", "orange", "lime", "yellow")
    foam = textures.spots(look.rng, color, tint_color(color, 0.72), 0.12)
    scour = look.own_color("green", "green", "navy", "charcoal", "red")
    rough = textures.scratches(look.rng, scour, tint_color(scour, 0.7), 260)
    lower = block(x, y, soft, 0.006, 0.003)
    upper = block(x, y, pad, 0.006, 0.001).move(z=soft - 0.0005)
    if look.chance(0.35):
        lower = block(x, y, pad, 0.006, 0.001)
        upper = block(x, y, soft, 0.006, 0.003).move(z=pad - 0.0005)
        foam, rough = rough, foam
    return shape([(lower, foam), (upper, rough)], [box_part(x, y, soft + pad - 0.0005)])


def first_aid_kit(look: Look) -> Shape:
    """A first-aid case with a cross on its front and lid."""
    x, y, h = look.between(0.2, 0.27), look.between(0.1, 0.15), look.between(0.13, 0.18)
    color = look.color("red", "white", "green", "red", "orange")
    ink = (250, 250, 248) if sum(color) < 520 else look.own_color("red", "green")
    shell = textures.speckles(look.rng, color, 3, 32)
    cross = prints.canvas(96, 96, color)
    prints.disc(cross, 0.5, 0.5, 0.47, ink)
    inner = color if sum(color) < 520 else (250, 250, 248)
    prints.fill(cross, 0.42, 0.2, 0.16, 0.6, inner)
    prints.fill(cross, 0.2, 0.42, 0.6, 0.16, inner)
    body = block(x, y, 0.62 * h, 0.02, 0.008)
    lid = block(x, y, 0.4 * h, 0.02, 0.008).move(z=0.6 * h)
    side = 0.62 * h
    front = box(side, 0.0014, side).move(y=-y / 2 - 0.0005, z=0.2 * h)
    top = box(0.6 * y, 0.6 * y, 0.001).move(z=h - 0.0004)
    bow = tube([(-0.04, 0, h - 0.002), (-0.036, 0, h + 0.024), (0.036, 0, h + 0.024),
                (0.04, 0, h - 0.002)], 0.0065, 10)  # fmt: skip
    clips = [box(0.022, 0.006, 0.03).move(s * 0.4 * x, -y / 2 - 0.001, 0.52 * h) for s in (-1, 1)]
    return shape(
        [(join([body, lid]), shell), (front, cross), (top, cross),
         (join([bow, *clips]), textures.plain((168, 170, 172)))],
        [box_part(x, y, h), box_part(0.08, 0.013, 0.03, (0, 0, h))],
    )  # fmt: skip


def pill_bottle(look: Look) -> Shape:
    """A bottle of pills with a white cap, some tablets lying by it."""
    r, h = look.between(0.019, 0.028), look.between(0.06, 0.085)
    color = look.color("orange", "amber", "white", "orange", "green")
    label = wrap(look, look.pick(["RX", "PILLS", "VITA C", "ZINC", "MEDS"]),
                 look.own_color("blue", "teal", "red", "green"), (248, 248, 246))  # fmt: skip
    skin = textures.speckles(look.rng, color, 4, 32)
    body = lathe([(0, 0), (0.95 * r, 0), (r, 0.003), (r, h), (0.8 * r, 1.06 * h),
                  (0, 1.06 * h)], 26, v=[0, 0, 0.03, 0.94, 0.99, 1])  # fmt: skip
    ribs = textures.stripes([(242, 242, 240), (214, 214, 212)], 24, upright=True)
    cap = cylinder(0.98 * r, 0.26 * h, 28, bevel=0.0015).move(z=1.04 * h)
    pieces = [
        (body, textures.stack((skin, 0.14), (label, 0.66), (skin, 0.2), side=160)),
        (cap, ribs),
    ]
    parts = [cylinder_part(r, h), cylinder_part(0.97 * r, 0.25 * h, (0, 0, 1.04 * h))]
    if look.chance(0.6):
        pill = look.own_color("white", "sky", "pink", "yellow", "red")
        for k in range(int(look.rng.integers(2, 5))):
            a = -np.pi / 2 + 0.5 * (k - 1.5) + look.between(-0.1, 0.1)
            tablet = ellipsoid(0.013, 0.0075, 0.0055, 12, 6).turn(2, look.between(0, 3))
            tablet = tablet.move(1.7 * r * np.cos(a), 1.7 * r * np.sin(a), 0.00275)
            pieces.append((tablet, textures.plain(pill)))
            parts.append(hull_of(tablet))
    return shape(pieces, parts)


def thermos(look: Look) -> Shape:
    """A vacuum flask with its cup for a lid."""
    r, h = look.between(0.034, 0.042), look.between(0.22, 0.29)
    color = look.color("green", "navy", "silver", "red", "black", "teal", "white")
    metal = textures.brushed_metal(look.rng, (178, 182, 188))
    coat = textures.brushed_metal(look.rng, color)
    if look.chance(0.35):
        coat = textures.stack((coat, 0.5), (textures.plain(readable_on(color)), 0.04), (coat, 0.4))
    foot = cylinder(r, 0.014, 30, bevel=0.002)
    body = lathe([(0, 0), (r, 0), (r, 0.6 * h), (0.84 * r, 0.68 * h), (0, 0.68 * h)], 30,
                 v=[0, 0, 0.9, 0.99, 1]).move(z=0.012)  # fmt: skip
    collar = cylinder(0.86 * r, 0.03 * h, 28).move(z=0.012 + 0.675 * h)
    cup = lathe(
        [(0, 0), (0.9 * r, 0), (0.84 * r, 0.2 * h), (0.78 * r, 0.215 * h), (0, 0.215 * h)], 28
    )
    cup = cup.move(z=0.012 + 0.7 * h)
    shiny = look.chance(0.5)
    pieces = [(body, coat), (join([foot, collar]), metal), (cup, metal if shiny else coat)]
    parts = [cylinder_part(r, 0.62 * h), hull_of(body), hull_of(cup)]
    if look.chance(0.5):
        z = 0.012 + 0.7 * h
        bow = tube([(0.85 * r, 0, z + 0.17 * h), (1.4 * r, 0, z + 0.15 * h),
                    (1.4 * r, 0, z + 0.06 * h),
                    (0.87 * r, 0, z + 0.03 * h)], 0.0045, 8)  # fmt: skip
        pieces.append((bow, textures.plain((50, 52, 56))))
        parts.append(hull_part(bow.vertices))
    return shape(pieces, parts)


def cake_stand(look: Look) -> Shape:
    """A footed stand for cake."""
    r, h = look.between(0.1, 0.15), look.between(0.08, 0.13)
    color = look.color("white", "pink", "mint", "sky", "cream", "wooden", "teal")
    glaze = look.surface(color, "ceramic")
    top = lathe([(0, 0), (0.9 * r, 0), (r, 0.006), (r, 0.014), (0.96 * r, 0.014), (0.94 * r, 0.008),
                 (0, 0.008)], 44).move(z=h - 0.014)  # fmt: skip
    post = lathe([(0, 0), (0.5 * r, 0), (0.48 * r, 0.006), (0.16 * r, 0.2 * h), (0.1 * r, 0.5 * h),
                  (0.18 * r, h - 0.012), (0, h - 0.012)], 28)  # fmt: skip
    scallops = lobe(torus(0.99 * r, 0.0035, 60, 6), 20, 0.05).move(z=h - 0.003)
    pieces = [(join([top, post]), glaze)]
    if look.chance(0.6):
        trim = look.own_color("gold", "white", "pink", "teal")
        pieces.append((scallops, textures.plain(trim)))
    parts = [
        hull_part(post.vertices[post.vertices[:, 2] < 0.25 * h]),
        cylinder_part(0.14 * r, h - 0.012),
        cylinder_part(0.98 * r, 0.008, (0, 0, h - 0.014)),
    ]
    return shape(pieces, parts)


CATEGORIES = (
    Category("folded_towel", folded_towel, (0.27, 0.19, 0.065), 0.4,
             ("towel", "hand towel", "bath towel", "towels",
             "pile of laundry", "folded sheet", "pillowcase", "pile of washing"),
             ("vanity", "kitchen"), ("support", "big"), ("white", "teal"), 0.8,
             "lying folded"),
    Category("hair_dryer", hair_dryer, (0.205, 0.185, 0.073), 0.5,
             ("hairdryer", "blow dryer", "blowdryer"), ("vanity",), (), ("black", "pink"),
             state="lying flat"),
    Category("sponge", sponge, (0.1, 0.065, 0.033), 0.008,
             ("kitchen sponge", "dish sponge",
             "scrubber", "scouring pad", "steel wool",
             "wire wool", "swiffer pad", "scourer", "scouring sponge", "make up sponge"),
             ("kitchen", "vanity"),
             ("flat",), ("yellow",), 0.8, "lying flat"),
    Category("first_aid_kit", first_aid_kit, (0.235, 0.13, 0.185), 0.9,
             ("first aid box", "first-aid kit", "first-aid box", "medical kit", "medicine box",
              "medkit", "puncture repair kit", "repair kit", "suture kit", "snake bite kit"),
              ("medical",), ("big",), ("red",
             "white")),
    Category("pill_bottle", pill_bottle, (0.055, 0.065, 0.094), 0.06,
             ("pill container", "vitamins",
             "medicine", "bottle of pills", "prescription bottle", "tablets",
             "bottle of ibuprofen", "box of aspirin", "medicine tub", "bottle of supplements"),
             ("medical", "vanity"), (), ("orange", "white")),
    Category("thermos", thermos, (0.08, 0.076, 0.245), 0.6,
             ("vacuum flask", "thermos flask", "thermos bottle", "insulated bottle",
              "thermos mug", "water filter", "dewar flask"), ("office", "coffee", "tea"), ("tall",
              "round"),
             ("green", "navy")),
    Category("cake_stand", cake_stand, (0.25, 0.25, 0.105), 0.9,
             ("cake plate", "pedestal plate", "cupcake stand", "dessert stand"), ("tea", "dining"),
             ("round", "support", "big"), ("white", "pink")),
)  # fmt: skip
"""The module's categories."""
