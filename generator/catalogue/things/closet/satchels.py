"""Bags of special kinds, buckles, gauntlets, patches."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.making import BRASS_TONE, at_box, drum, plate, steel
from ...build.outlines import rectangle
from ...build.recipes import ball, leather, put_down, rod
from ...build.shape import Shape
from ...build.solids import block, join, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from ...surfaces.textures import plain


def satchel(look: Look) -> Shape:
    """A school satchel standing: a flap with two buckled straps, a handle."""
    color = look.color("brown", "tan", "maroon", "navy", "black", "mustard")
    k = look.between(0.7, 0.9)
    body = block(0.3, 0.1, 0.21, 0.015, 0.008)
    flap = at_box(0.29, 0.012, 0.12, (0, -0.053, 0.085))
    top = block(0.296, 0.112, 0.02, 0.012, 0.006).move(0, -0.003, 0.196)
    straps = [at_box(0.026, 0.006, 0.17, (s * 0.085, -0.06, 0.035)) for s in (-1, 1)]
    straps += [at_box(0.026, 0.1, 0.006, (s * 0.085, -0.006, 0.214)) for s in (-1, 1)]
    buckles = [at_box(0.038, 0.008, 0.03, (s * 0.085, -0.063, 0.06)) for s in (-1, 1)]
    handle = rod(
        [(-0.05, 0, 0.215), (-0.04, 0, 0.245), (0.04, 0, 0.245), (0.05, 0, 0.215)], 0.007, 8
    )
    hide = leather(look.rng, color)
    return put_down(
        [
            (join([body, flap, top]), hide),
            (join([*straps, handle]), leather(look.rng, tint_color(color, 0.6))),
            (join(buckles), steel(look, BRASS_TONE)),
        ],
        body,
        flap,
        top,
        handle,
        factor=k,
    )


def waist_bag(look: Look) -> Shape:
    """A bag for the waist lying: a zipped pouch and its belt round behind."""
    color = look.color("black", "pink", "teal", "red", "navy", "orange")
    k = look.between(0.85, 1.1)
    pouch = block(0.2, 0.075, 0.1, 0.034, 0.016)
    front = block(0.14, 0.02, 0.055, 0.009, 0.006).move(0, -0.04, 0.012)
    zips = [
        at_box(0.15, 0.006, 0.006, (0, -0.03, 0.092)),
        at_box(0.11, 0.003, 0.005, (0, -0.0505, 0.055)),
    ]
    tags = [
        at_box(0.005, 0.004, 0.018, (0.06, -0.034, 0.078)),
        at_box(0.005, 0.003, 0.014, (0.045, -0.052, 0.044)),
    ]
    a = np.linspace(0.0, np.pi, 22)
    path = np.column_stack([0.115 * np.cos(a), 0.02 + 0.13 * np.sin(a), 0.05 + 0 * a])
    belt = tube(path, 0.003, 8, squash=5.5)
    clip = at_box(0.045, 0.012, 0.038, (0.0, 0.15, 0.031))
    foot = [tube(path[i : i + 8], 0.003, 8, squash=5.5) for i in (0, 7, 14)]
    return put_down(
        [
            (join([pouch, front]), textures.fabric(look.rng, color)),
            (join([*zips, *tags]), steel(look)),
            (join([belt, clip]), plain(tint_color(color, 0.6))),
        ],
        pouch,
        front,
        *foot,
        factor=k,
    )


def tote(look: Look) -> Shape:
    """A canvas tote bag standing open, with two handles and a print."""
    color = look.color("cream", "white", "black", "navy", "mustard", "sage")
    k = look.between(0.75, 0.95)
    body = block(0.26, 0.09, 0.25, 0.02)
    mouth = at_box(0.235, 0.07, 0.001, (0, 0, 0.2496))
    rims = [at_box(0.24, 0.004, 0.02, (0, s * 0.0445, 0.238)) for s in (-1, 1)]
    handles = [
        rod(
            [
                (-0.06, s * 0.042, 0.24),
                (-0.05, s * 0.04, 0.31),
                (0, s * 0.036, 0.335),
                (0.05, s * 0.04, 0.31),
                (0.06, s * 0.042, 0.24),
            ],
            0.006,
            8,
        )
        for s in (-1, 1)
    ]
    tone = look.own_color("coral", "teal", "navy", "mustard", "green", "black")
    print_ = [drum(0.05, 0.0012, (0, -0.046, 0.125), 1, sides=28)]
    inner = drum(0.036, 0.0014, (0, -0.0465, 0.125), 1, sides=28)
    cloth = textures.fabric(look.rng, color)
    return put_down(
        [
            (join([body, *rims, *handles]), cloth),
            (mouth, plain(tint_color(color, 0.4))),
            (join(print_), plain(tone)),
            (inner, plain(tint_color(tone, 1.5))),
        ],
        body,
        *handles,
        factor=k,
    )


def buckle(look: Look) -> Shape:
    """A belt buckle lying: a frame, a bar and a prong."""
    color = look.color("silver", "gold", "bronze", "copper")
    k = look.between(0.8, 1.2)
    a = rectangle(0.06, 0.05, look.pick([0.004, 0.012, 0.02]), 5)
    path = np.column_stack([a, np.full(len(a), 0.0032)])
    frame = tube(path, 0.0034, 8, loop=True)
    rail = at_box(0.004, 0.046, 0.004, (-0.008, 0, 0.001))
    prong = rod([(-0.008, 0, 0.006), (0.01, 0, 0.0085), (0.031, 0, 0.0078)], 0.0019, 8)
    return put_down([(join([frame, rail, prong]), steel(look, color))], frame, factor=k)


def gauntlet(look: Look) -> Shape:
    """A plated gauntlet lying, its cuff flared."""
    color = look.color("silver", "gray", "bronze", "charcoal")
    k = look.between(0.85, 1.1)
    cuff = [
        drum(0.036 + 0.006 * n, 0.04, (-0.045 - 0.036 * n, 0, 0.05), 0, top=0.034 + 0.004 * n)
        for n in range(2)
    ]
    cuff = [one.scale(1, 1.1, 0.75) for one in cuff]
    hand = [ball(0.075, 0.085, 0.05, (0.02, 0, 0.03), 16)]
    plates = [
        at_box(0.02, 0.082 - 0.004 * n, 0.008, (0.0 + 0.018 * n, 0, 0.048 - 0.002 * n))
        for n in range(3)
    ]
    fingers, joints = [], []
    for n in range(4):
        y = 0.03 - 0.02 * n
        fingers.append(
            rod(
                [(0.045, y, 0.03), (0.085, y, 0.022), (0.11 - 0.006 * abs(n - 1), y, 0.011)],
                0.0105,
                8,
            )
        )
        joints += [
            torus(0.0105, 0.002, 12, 5).turn(1, 1.2).move(x, y, z)
            for x, z in ((0.06, 0.027), (0.082, 0.022))
        ]
    thumb = rod([(0.0, 0.036, 0.026), (0.03, 0.06, 0.02), (0.06, 0.062, 0.012)], 0.0115, 8)
    metal = steel(look, color)
    return put_down(
        [
            (join([*cuff, *hand, *fingers, thumb]), metal),
            (join([*plates, *joints]), steel(look, tint_color(color, 0.75))),
        ],
        *cuff,
        *hand,
        join(fingers),
        thumb,
        factor=k,
        foot=0.3,
    )


def patch(look: Look) -> Shape:
    """An embroidered patch with a picture and a stitched rim."""
    color = look.color("navy", "red", "green", "mustard", "black", "teal")
    r = look.between(0.026, 0.042)
    back = drum(r, 0.002, sides=30)
    rim = torus(0.96 * r, 0.0018, 34, 6).move(z=0.002)
    tone = look.own_color("yellow", "white", "coral", "sky")
    n = look.pick([5, 6, 8])
    a = np.pi / 2 + np.pi * np.arange(2 * n) / n
    s = np.where(np.arange(2 * n) % 2, 0.3, 0.66) * r
    star = plate(np.column_stack([s * np.cos(a), s * np.sin(a)]), 0.0016, at=(0, 0, 0.0018))
    return put_down(
        [
            (back, textures.fabric(look.rng, color)),
            (rim, plain(tint_color(tone, 0.8))),
            (star, plain(tone)),
        ],
        back,
    )


CATEGORIES = (
    Category("satchel", satchel, (0.239, 0.0955, 0.204), 0.8, ("school satchel",
             "leather satchel", "messenger bag",
             "briefcase bag"), ("living", "office"), ("big",), ("brown",)),
    Category("waist_bag", waist_bag, (0.226, 0.201, 0.0959), 0.2, ("fanny pack", "bum bag",
             "hip pack", "belt bag", "waist pack"),
             ("living",), ("big",), ("black",)),
    Category("tote_bag", tote, (0.214, 0.0791, 0.281), 0.2, ("tote", "canvas bag", "canvas tote",
             "cloth bag",
             "shopper"), ("living",), ("big",), ("cream",)),
    Category("buckle", buckle, (0.0611, 0.052, 0.00956), 0.05, ("belt buckle", "brass buckle",
             "metal buckle"), ("living",), ("flat",),
             ("silver",)),
    Category("gauntlet", gauntlet, (0.189, 0.116, 0.0658), 0.6, ("armored glove",
             "knight's glove", "armoured glove", "steel glove"),
             ("living",), ("big",), ("silver",)),
    Category("patch", patch, (0.0704, 0.0707, 0.00356), 0.006, ("iron-on patch",
             "embroidered patch", "sew-on patch", "cloth patch",
             "scout badge", "cloth badge"), ("craft",), ("flat",), ("navy", "red")),
)  # fmt: skip
"""The module's categories."""
