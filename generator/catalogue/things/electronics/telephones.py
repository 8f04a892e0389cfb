"""Telephones, headsets and stands for phones."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import flat_foot, hull_of, hull_part
from ...build.forms import side_view
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    sweep,
    torus,
    tube,
)
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

DARK: RGB = (38, 39, 43)


def _handset(length: float, z: float) -> Solid:
    """Return a telephone's handset along x, its ear and mouth pieces downwards, at height ``z``."""
    t = np.linspace(-1, 1, 9)
    path = np.column_stack([0.42 * length * t, 0 * t, z + 0.012 - 0.012 * np.abs(t) ** 2.5])
    grip = sweep(path, rectangle(0.034, 0.022, 0.008, 3))
    ends = [lathe([(0, -0.012), (0.024, -0.012), (0.027, 0.0), (0.02, 0.016), (0, 0.018)], 22)
            .move(s * 0.42 * length, 0, z - 0.002) for s in (-1, 1)]  # fmt: skip
    return join([grip, *ends])


def telephone(look: Look) -> Shape:
    """A desk telephone: an old one with a dial, or one with keys and a display."""
    color = look.color("black", "red", "cream", "white", "green", "gray", "charcoal", "sky")
    skin = textures.speckles(look.rng, color, 3, 32)
    if look.chance(0.5):
        k = look.between(0.92, 1.08)
        outline = rectangle(1, 1, 0.16, 4)
        rings = [(0.21, 0.2, 0, 0), (0.21, 0.2, 0.02, 0), (0.17, 0.15, 0.06, 0.015),
                 (0.13, 0.075, 0.095, 0.035), (0.12, 0.065, 0.1, 0.035)]  # fmt: skip
        body = loft(np.stack([np.column_stack([outline * [a * k, b * k] + [0, d * k],
                                               np.full(len(outline), z * k)])
                              for a, b, z, d in rings]), outline)  # fmt: skip
        face = prints.canvas(128, 128, (236, 232, 222))
        prints.disc(
            face, 0.5, 0.5, 0.5, tint_color(color, 0.7) if sum(color) > 250 else (206, 208, 212)
        )
        for n in range(10):
            a = -0.9 + n * 0.56
            u, v = 0.5 + 0.34 * np.cos(a), 0.5 + 0.34 * np.sin(a)
            prints.disc(face, u, v, 0.075, (250, 248, 240))
            prints.write(face, str(n), u, v, 0.07, (40, 40, 44))
        prints.disc(face, 0.5, 0.5, 0.16, (250, 248, 240))
        dial = cylinder(0.044 * k, 0.012, 32, bevel=0.002).turn(0, 0.55)
        dial = dial.move(y=-0.039 * k, z=0.072 * k)
        forks = [
            block(0.03, 0.06 * k, 0.022, 0.008, 0.003).move(s * 0.05 * k, 0.035 * k, 0.095 * k)
            for s in (-1, 1)
        ]
        hand = _handset(0.22 * k, 0.125 * k).move(y=0.035 * k)
        return shape([(join([body, *forks]), skin), (dial, face), (hand, skin)],
                     [hull_part(body.vertices[body.vertices[:, 2] < 0.07 * k]),
                      hull_part(body.vertices[body.vertices[:, 2] > 0.05 * k]),
                      hull_of(*forks), hull_of(hand)])  # fmt: skip
    x, y = look.between(0.18, 0.21), look.between(0.19, 0.22)
    wedge = side_view(np.array([(-y / 2, 0), (y / 2, 0), (y / 2, 0.065), (-y / 2, 0.022)]), x)
    body = wedge.turn(2, np.pi / 2)
    lean = np.arctan2(0.043, y)
    face = prints.canvas(128, 144, tint_color(color, 0.94))
    prints.fill(face, 0.1, 0.06, 0.8, 0.22, (176, 196, 172))
    prints.write(face, look.pick(["10:24", "LINE 1", "09:41"]), 0.5, 0.17, 0.1, (40, 46, 40))
    tone = (230, 230, 228) if sum(color) < 330 else (70, 72, 78)
    for n in range(12):
        prints.fill(face, 0.12 + 0.2 * (n % 3), 0.36 + 0.14 * (n // 3), 0.16, 0.095, tone)
    for n in range(5):
        prints.fill(face, 0.78, 0.36 + 0.11 * n, 0.14, 0.06, [(200, 60, 50), tone][n > 0])
    panel = box(0.58 * x, 0.9 * y, 0.003).turn(0, lean).move(0.18 * x, 0, 0.0425)
    cradle = box(0.28 * x, 0.86 * y, 0.012).turn(0, lean).move(-0.31 * x, 0, 0.0425)
    hand = _handset(0.2, 0).turn(2, np.pi / 2).turn(0, lean).move(-0.31 * x, 0, 0.068)
    cord = tube(
        smooth(
            [
                (-0.31 * x, -0.46 * y, 0.05),
                (-0.55 * x, -0.4 * y, 0.02),
                (-0.58 * x, 0.0, 0.004),
                (-0.5 * x, 0.3 * y, 0.02),
            ],
            5,
        ),
        0.003,
        7,
    )
    return shape([(join([body, cradle]), skin), (panel, face), (hand, skin),
                  (cord, textures.plain(tint_color(color, 0.8)))],
                 [hull_of(body), hull_of(cradle), hull_of(hand)])  # fmt: skip


def phone_stand(look: Look) -> Shape:
    """A stand for a phone or tablet: a leaning plate with a lip; some hold a phone."""
    x, h = look.between(0.07, 0.09), look.between(0.09, 0.12)
    color = look.color("black", "silver", "wooden", "white", "gold", "gray", "teal")
    skin = look.surface(color, look.pick(["metal", "plastic", "wood"]))
    lean = look.between(0.35, 0.5)
    foot = block(x, 0.1, 0.006, 0.012, 0.002)
    plate = block(x, h, 0.006, 0.012, 0.002).turn(0, np.pi / 2 - lean)
    plate = plate.move(y=0.008, z=0.5 * h * np.cos(lean) + 0.012)
    lip = box(0.72 * x, 0.03, 0.005).turn(0, -lean).move(y=-0.025, z=0.016)
    stop = box(0.72 * x, 0.004, 0.014).turn(0, -lean).move(y=-0.038, z=0.012)
    neck = sweep(smooth([(0, 0.035, 0.004), (0, 0.03, 0.4 * h), (0, 0.018, 0.5 * h)], 3),
                 rectangle(0.5 * x, 0.008, 0.002, 2))  # fmt: skip
    pieces = [(join([foot, plate, lip, stop, neck]), skin)]
    parts = [hull_of(foot), hull_of(plate), hull_of(lip), hull_of(stop), hull_of(neck)]
    if look.chance(0.4):
        phone = block(0.072, 0.15, 0.008, 0.01, 0.002).turn(0, np.pi / 2 - lean)
        glass = block(0.068, 0.146, 0.0008, 0.008).turn(0, np.pi / 2 - lean)
        way = np.array([0, -np.cos(lean), np.sin(lean)])
        at = np.array([0, 0.008, 0.075 * np.cos(lean) + 0.022]) + 0.007 * way + [0, 0.012, 0]
        case = phone.move(*at)
        pieces += [(case, textures.plain(DARK)), (glass.move(*(at + 0.0077 * way)),
                                                  prints.apps(look.rng))]  # fmt: skip
        parts.append(hull_of(case))
    return shape(pieces, parts)


def headset(look: Look) -> Shape:
    """A headset with a microphone arm, lying upright on its ear cups."""
    k = look.between(0.94, 1.08)
    color = look.color("black", "white", "charcoal", "red", "pink", "navy", "green")
    skin = textures.speckles(look.rng, color, 4, 32)
    trim = textures.plain(look.own_color("red", "silver", "lime", "blue", "black"))
    a = np.linspace(0, np.pi, 21)
    band = sweep(np.column_stack([-0.085 * k * np.cos(a), 0 * a, 0.075 * k + 0.1 * k * np.sin(a)]),
                 rectangle(0.032 * k, 0.01, 0.004, 3))  # fmt: skip
    cups, pads = [], []
    for s in (-1, 1):
        cup = cylinder(0.045 * k, 0.026 * k, 28, bevel=0.006).turn(1, s * np.pi / 2)
        pad = torus(0.03 * k, 0.013 * k, 26, 8).turn(1, np.pi / 2)
        cups.append(cup.move(x=s * 0.075 * k, z=0.045 * k))
        pads.append(pad.move(x=s * 0.068 * k, z=0.045 * k))
    arm = tube(smooth([(-0.09 * k, -0.02 * k, 0.03 * k), (-0.086 * k, -0.06 * k, 0.018 * k),
                       (-0.05 * k, -0.09 * k, 0.015 * k)], 5), 0.0035, 7)  # fmt: skip
    mic = (
        ellipsoid(0.026, 0.014, 0.014, 14, 8).turn(2, -0.7).move(-0.042 * k, -0.096 * k, 0.015 * k)
    )
    rings = [torus(0.03 * k, 0.002, 26, 6).turn(1, np.pi / 2).move(x=s * 0.1015 * k, z=0.045 * k)
             for s in (-1, 1)]  # fmt: skip
    soft = textures.speckles(look.rng, DARK, 6)
    return shape(
        [(join([band, *cups]), skin), (join([*pads, mic, arm]), soft), (join(rings), trim)],
        [
            *(flat_foot(c.vertices, 0.1) for c in cups),
            *(
                hull_part(band.vertices[(band.vertices[:, 0] > lo) & (band.vertices[:, 0] < hi)])
                for lo, hi in ((-0.1, -0.03), (-0.04, 0.04), (0.03, 0.1))
            ),
            hull_of(arm, mic),
        ],
    )


CATEGORIES = (
    Category("telephone", telephone, (0.226, 0.207, 0.124), 0.9, ("desk phone", "landline phone",
             "rotary phone", "landline", "office phone", "desk telephone", "corded phone",
             "rotary telephone", "old telephone", "desktop phone"), ("office",), ("big",), ("black",
             "red")),
    Category("phone_stand", phone_stand, (0.08, 0.1, 0.13), 0.18, ("phone holder", "tablet stand",
             "smartphone stand", "cell phone stand", "display stand", "mobile phone stand",
             "tablet holder", "phone dock", "ipad stand"), ("office",), ("tall",), ("black",
             "silver")),
    Category("headset", headset, (0.212, 0.155, 0.196), 0.28, ("gaming headset",
             "headset with microphone", "call center headset", "pc headset"), ("gaming", "office"),
             (), ("black", "white")),
)  # fmt: skip
"""The module's categories."""
