"""Clips, punches, pins and stamps."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, frame_parts, hull_of
from ...build.forms import side_view
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, open_box, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

RAINBOW = ("red", "orange", "yellow", "green", "teal", "blue", "purple", "pink", "brown", "black")


def paper_clips(look: Look) -> Shape:
    """A few paper clips lying about."""
    color = look.color("silver", "silver", "red", "blue", "gold", "green", "pink")
    mixed = look.chance(0.4)
    pieces, parts = [], []
    k = look.between(0.9, 1.15)
    path = [(-0.4, -0.5), (0.9, -0.5), (1.25, -0.2), (1.25, 0.2), (0.9, 0.5), (-1.0, 0.5),
            (-1.3, 0.2), (-1.3, -0.05), (-1.0, -0.3), (0.7, -0.3), (0.95, 0), (0.7, 0.27),
            (-0.6, 0.27)]  # fmt: skip
    for n in range(int(look.rng.integers(4, 7))):
        points = np.column_stack([np.array(path) * [0.0125 * k, 0.0075 * k],
                                  0.0006 + 0.0014 * (np.arange(13) > 6)])  # fmt: skip
        away, turn = 0.021 * k * np.sqrt(n), 2.4 * n + look.between(-0.4, 0.4)
        wire = tube(points, 0.0006, 5).turn(2, look.between(0, 6.28))
        wire = wire.move(away * np.cos(turn), away * np.sin(turn), 0.0002 * n)
        wire = wire.move(z=-float(wire.bounds[0, 2]))
        tone = look.own_color(*RAINBOW[:8]) if mixed else color
        pieces.append((wire, textures.plain(tone)))
        parts.append(hull_of(wire))
    return shape(pieces, parts)


def binder_clip(look: Look) -> Shape:
    """A binder clip: a folded black or coloured spring with two wire arms."""
    k = look.between(0.8, 1.25)
    color = look.color("black", "black", "red", "blue", "green", "pink", "yellow", "gold")
    x, y, h = 0.032 * k, 0.02 * k, 0.016 * k
    wedge = side_view(np.array([(-y / 2, 0), (y / 2, 0), (0.14 * y, h), (-0.14 * y, h)]), x)
    body = wedge.turn(2, np.pi / 2)
    lips = [cylinder(0.0016 * k, x, 8).turn(1, np.pi / 2).move(-x / 2, s * 0.12 * y, h)
            for s in (-1, 1)]  # fmt: skip
    steel = textures.plain((186, 188, 194))
    path = np.array([(-0.3, 0), (-0.14, 0.6), (-0.3, 1.0), (-0.18, 1.25), (0.18, 1.25), (0.3, 1.0),
                     (0.14, 0.6), (0.3, 0)]) * 0.8 * x  # fmt: skip
    wire = tube(np.column_stack([path[:, 0], np.zeros(8), path[:, 1]]), 0.0009 * k, 6)
    folded = look.pick([0.25, 0.25, 2.05])
    loops = [wire.turn(0, -0.25).move(y=0.12 * y, z=h),
             wire.turn(0, folded).move(y=-0.12 * y, z=h)]  # fmt: skip
    skin = textures.speckles(look.rng, color, 3, 32)
    return shape([(join([body, *lips]), skin), (join(loops), steel)],
                 [hull_of(body, *lips), *(hull_of(loop) for loop in loops)])  # fmt: skip


def hole_punch(look: Look) -> Shape:
    """A two-hole punch: a base with a ruler, two punches under a broad lever."""
    k = look.between(0.92, 1.12)
    color = look.color("black", "red", "blue", "silver", "gray", "teal", "green")
    skin, dark = look.surface(color, "metal"), textures.speckles(look.rng, (48, 49, 53), 4)
    base = block(0.13 * k, 0.085 * k, 0.012 * k, 0.012, 0.002)
    stand = [box(0.018 * k, 0.035 * k, 0.035 * k).move(s * 0.04 * k, 0.018 * k, 0.011 * k)
             for s in (-1, 1)]  # fmt: skip
    pins = [cylinder(0.004 * k, 0.03 * k, 12).move(s * 0.04 * k, -0.002 * k, 0.014 * k)
            for s in (-1, 1)]  # fmt: skip
    lever = block(0.125 * k, 0.1 * k, 0.014 * k, 0.016, 0.004).turn(0, -0.32)
    lever = lever.move(y=-0.012 * k, z=0.044 * k)
    guide = box(0.1 * k, 0.008 * k, 0.002).move(x=0.055 * k, y=-0.025 * k, z=0.011 * k)
    steel = textures.brushed_metal(look.rng, (192, 195, 200))
    return shape([(join([base]), dark), (join([*stand, *pins, guide]), steel), (lever, skin)],
                 [hull_of(base), hull_of(*stand), hull_of(lever)])  # fmt: skip


def stamp(look: Look) -> Shape:
    """A rubber stamp: a turned wooden grip, or a self-inking one."""
    color = look.color("wooden", "brown", "black", "red", "tan", "blue")
    if look.chance(0.65):
        h = look.between(0.07, 0.09)
        x, y = (look.between(0.036, 0.05), look.between(0.022, 0.03))
        wood = look.surface(color, "wood")
        foot = block(x, y, 0.012, 0.003, 0.001).move(z=0.004)
        rubber = block(0.94 * x, 0.92 * y, 0.0045, 0.002)
        grip = lathe([(0, 0.014), (0.011, 0.014), (0.0065, 0.03), (0.0055, 0.042), (0.012, 0.9 * h),
                      (0.0125, 0.95 * h), (0.008, h), (0, h)], 22)  # fmt: skip
        red = textures.plain(look.own_color("crimson", "red", "navy"))
        return shape([(join([foot, grip]), wood), (rubber, red)],
                     [hull_of(foot), hull_of(rubber), hull_of(grip)])  # fmt: skip
    x, y, h = 0.05, 0.032, look.between(0.075, 0.09)
    frame = join([box(0.008, y, 0.03).move(x=s * (x / 2 - 0.004)) for s in (-1, 1)])
    rail = [box(x, 0.006, 0.004).move(y=s * (y / 2 - 0.003)) for s in (-1, 1)]
    cap = block(x + 0.004, y + 0.002, h - 0.028, 0.01, 0.004).move(z=0.028)
    face = prints.canvas(64, 48, (246, 246, 242))
    prints.fill(face, 0.06, 0.1, 0.88, 0.8, (196, 42, 40))
    prints.fill(face, 0.1, 0.16, 0.8, 0.68, (246, 246, 242))
    prints.write(
        face, look.pick(["PAID", "COPY", "OK", "SENT"]), 0.5, 0.5, 0.4, (196, 42, 40), True
    )
    window = box(0.8 * x, 0.0006, 0.4 * h).move(y=-y / 2 - 0.001, z=0.42 * h)
    return shape([(join([frame, *rail]), textures.plain((50, 51, 55))),
                  (cap, look.surface(color)), (window, face)],
                 [box_part(x, y, 0.03), hull_of(cap)])  # fmt: skip


def ink_pad(look: Look) -> Shape:
    """An ink pad with its lid open behind it."""
    x, y, h = look.between(0.085, 0.11), look.between(0.058, 0.075), 0.014
    color = look.color("black", "navy", "red", "silver", "green", "purple")
    ink = look.own_color("navy", "black", "red", "blue", "purple", "green")
    tray = join(open_box(x, y, h, 0.004, 0.003))
    pad = block(x - 0.009, y - 0.009, h - 0.004, 0.002).move(z=0.0025)
    lid = block(x, y, 0.01, 0.003, 0.001).turn(0, -1.85).move(y=y / 2 + 0.45 * y * 0.28, z=0.0)
    lid = lid.move(y=0.2 * y, z=-float(lid.bounds[0, 2]) + 0.002)
    sign = textures.plain(tint_color(color, 0.8))
    felt = textures.fabric(look.rng, tint_color(ink, 0.8))
    skin = look.surface(color, "metal")
    return shape([(tray, skin), (pad, felt), (lid, sign)],
                 [*frame_parts(x, y, h, 0.004, h - 0.003), hull_of(lid)])  # fmt: skip


def thumbtacks(look: Look) -> Shape:
    """A small heap of push pins."""
    color = look.color(*RAINBOW[:8])
    mixed = look.chance(0.7)
    pin = lathe([(0, 0), (0.005, 0), (0.005, 0.0015), (0.0028, 0.003), (0.0032, 0.009),
                 (0.0046, 0.0105), (0.0046, 0.012), (0, 0.012)], 12)  # fmt: skip
    needle = cylinder(0.0006, 0.0105, 6, top=0.0001).move(z=0.012)
    lean = np.pi / 2 + np.arctan2(0.0045, 0.0225)
    pieces, parts = [], []
    for n in range(int(look.rng.integers(5, 9))):
        away, turn = 0.016 * np.sqrt(n), 2.4 * n + look.between(-0.4, 0.4)
        spin = look.between(0, 6.28)
        both = [s.turn(1, lean).turn(2, spin) for s in (pin, needle)]
        low = min(float(s.bounds[0, 2]) for s in both)
        both = [s.move(away * np.cos(turn), away * np.sin(turn), -low) for s in both]
        tone = look.own_color(*RAINBOW[:8]) if mixed else color
        pieces += [(both[0], textures.plain(tone)), (both[1], textures.plain((190, 192, 198)))]
        parts.append(hull_of(*both))
    return shape(pieces, parts)


CATEGORIES = (
    Category("paper_clips", paper_clips, (0.0768, 0.0844, 0.00257), 0.004,
        ("box of paper clips",), ("office",), ("flat",),
             ("silver",), state="lying flat"),
    Category("binder_clip", binder_clip, (0.0323, 0.0335, 0.0483), 0.015, ("bulldog clip",
             "foldback clip", "fold back clip", "document clip"), ("office",), (), ("black",)),
    Category("hole_punch", hole_punch, (0.17, 0.1, 0.0716), 0.3, ("hole puncher", "paper punch",
             "puncher", "hole-punch", "paper puncher", "corner rounder", "embossing tool",
             "leather hole punch"), ("office",), (), ("black", "red")),
    Category("stamp", stamp, (0.045, 0.028, 0.08), 0.05, ("rubber stamp", "seal",
             "self inking stamp", "wooden stamp", "seal stamp", "ink stamp", "seal matrix",
             "date stamp", "signet seal"), ("office",),
             ("tall",), ("wooden", "black")),
    Category("ink_pad", ink_pad, (0.0984, 0.105, 0.0668), 0.09, ("inkpad", "stamp pad",
             "stamp ink pad", "ink"), ("office",), (), ("black", "navy"), state="lying open"),
    Category("thumbtacks", thumbtacks, (0.0752, 0.074, 0.0118), 0.004, (
             "brad fastener", "box of thumbtacks", "box of drawing pins"), ("office",),
             ("flat",), ("red", "blue"), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
