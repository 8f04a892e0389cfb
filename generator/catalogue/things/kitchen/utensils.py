"""Hand tools of a kitchen, lying flat: turners, ladles, tongs, peelers, graters, openers."""

from __future__ import annotations

import itertools

import numpy as np

from ....scene import ConvexPart
from ...build.category import Category
from ...build.collision import box_part, hull_of, hull_part
from ...build.outlines import ellipse, rectangle, rounded_polygon, smooth
from ...build.shape import Shape, shape
from ...build.solids import (
    Solid,
    block,
    box,
    cylinder,
    join,
    lathe,
    loft,
    prism,
    sweep,
    torus,
    tube,
)
from ...surfaces import textures
from ...surfaces.look import Look

GRIPS = ("black", "red", "teal", "wooden", "white", "navy", "sage", "silver")


def bright_steel(look: Look) -> textures.Tile:
    """Return bright brushed steel."""
    return textures.brushed_metal(look.rng, (192, 195, 200))


def grip_bar(start: float, stop: float, wide: float, z: float) -> Solid:
    """Return a rounded handle along x from ``start`` to ``stop`` whose middle is at ``z``."""
    t = np.linspace(0, 1, 7)
    x = start + (stop - start) * t
    scale = wide * (0.72 + 0.28 * np.sin(np.pi * (0.15 + 0.85 * t)))
    scale[-1] *= 0.6
    path = np.column_stack([x, np.zeros(7), np.full(7, z)])
    return sweep(path, rectangle(1.0, 0.62, 0.26, 3), scale)


def _slices(solid: Solid, edges: list[float]) -> list[ConvexPart]:
    x = solid.vertices[:, 0]
    return [hull_part(solid.vertices[(x >= a - 1e-6) & (x <= b + 1e-6)])
            for a, b in itertools.pairwise(edges)]  # fmt: skip


def spatula(look: Look) -> Shape:
    """A spatula lying: a slotted steel turner, a silicone scraper, or a wooden one."""
    kind = look.pick(["turner", "turner", "scraper", "wooden"])
    color = look.color(*GRIPS)
    long = look.between(0.28, 0.33)
    head, tip = look.between(0.085, 0.1), -0.5 * long
    if kind == "wooden":
        wood = look.surface(look.color("wooden", "tan", "brown", "beige"), "wood")
        outline = rounded_polygon(
            np.array([(tip, -0.032), (tip + head, -0.026), (tip + head, 0.026), (tip, 0.032)]),
            0.008,
        )
        plate = prism(outline, 0, 0.006, 0.002)
        rod = sweep([(tip + head - 0.02, 0, 0.004), (0.0, 0, 0.006), (0.5 * long, 0, 0.006)],
                    rectangle(0.016, 0.008, 0.003, 2), [0.9, 0.9, 1.2])  # fmt: skip
        return shape([(plate, wood), (rod, wood)], [hull_of(plate), hull_of(rod)])
    skin = look.surface(color, "plastic")
    if kind == "scraper":
        plate = prism(rectangle(head, 0.056, 0.018, 4), 0, 0.009, 0.003).move(x=tip + head / 2)
        stem = sweep([(tip + head - 0.015, 0, 0.0045), (0.0, 0, 0.007)],
                     rectangle(0.014, 0.007, 0.003, 2))  # fmt: skip
        grip = grip_bar(-0.005, 0.5 * long, 0.024, 0.0082)
        other = look.surface(look.own_color("wooden", "white", "charcoal", "silver"), "wood")
        return shape([(plate, skin), (join([stem, grip]), other)],
                     [hull_of(plate), hull_of(stem, grip)])  # fmt: skip
    count, wide = look.pick([4, 5]), look.between(0.07, 0.085)
    bar, pitch = box(0.7 * head, 0.5 * wide / count, 0.002), wide - 0.5 * wide / count
    bars = [bar.move(tip + head / 2, (k / count - 0.5) * pitch) for k in range(count + 1)]
    ends = [box(0.17 * head, wide, 0.002).move(x=tip + u * head) for u in (0.085, 0.915)]
    steel = bright_steel(look) if look.chance(0.6) else textures.plain((44, 45, 49))
    neck = sweep(smooth([(tip + 0.95 * head, 0, 0.0025), (tip + head + 0.02, 0, 0.012),
                         (0.02, 0, 0.02)], 3), rectangle(0.013, 0.004, 0.0015, 2))  # fmt: skip
    grip = grip_bar(0.0, 0.5 * long, 0.024, 0.0)
    lean = np.arctan2(0.013, 0.5 * long)
    grip = grip.turn(1, lean).move(z=0.0215)
    return shape(
        [(join([*bars, *ends, neck]), steel), (grip, skin)],
        [box_part(head, wide, 0.002, (tip + head / 2, 0, 0)), hull_of(neck), hull_of(grip)],
    )


def ladle(look: Look) -> Shape:
    """A soup ladle lying on its bowl's side of rest and the end of its handle."""
    r, long = look.between(0.036, 0.044), look.between(0.24, 0.29)
    color = look.color("silver", "silver", *GRIPS)
    steel = bright_steel(look) if look.chance(0.7) else look.surface(color, "plastic")
    t = np.linspace(0.06, np.pi / 2, 7)
    outer = [(r * np.sin(a), r * (1 - np.cos(a)) * 0.86) for a in t]
    inner = [(max(x - 0.002, 0.001), z + 0.002 * (1 - i / 6)) for i, (x, z) in enumerate(outer)]
    bowl = lathe([(0, 0), *outer, *inner[::-1], (0, 0.002)], 26)
    h = 0.86 * r
    stem = sweep(smooth([(0.97 * r, 0, h - 0.003), (r + 0.03, 0, h + 0.022),
                         (0.6 * long, 0, 0.5 * h + 0.016), (long, 0, 0.006)], 4),
                 rectangle(0.012, 0.004, 0.0015, 2))  # fmt: skip
    grip = sweep([(0.55 * long, 0, 0.5 * h + 0.0185), (long + 0.02, 0, 0.006)],
                 rectangle(0.02, 0.011, 0.004, 3))  # fmt: skip
    wedges = [hull_part(bowl.vertices[bowl.vertices[:, 2] < 0.55 * h])]
    around = np.arctan2(bowl.vertices[:, 1], bowl.vertices[:, 0])
    for k in range(10):
        low = -np.pi + k * 2 * np.pi / 10
        inside = (around >= low - 0.02) & (around <= low + 2 * np.pi / 10 + 0.02)
        high = bowl.vertices[:, 2] > 0.45 * h
        wedges.append(hull_part(bowl.vertices[inside & high]))
    skin = look.surface(color, "plastic")
    return shape([(bowl, steel), (stem, steel), (grip, skin)],
                 [*wedges, hull_part(stem.vertices[stem.vertices[:, 0] < r + 0.05]),
                  hull_of(grip)])  # fmt: skip


def tongs(look: Look) -> Shape:
    """Kitchen tongs lying open, their heads to the left."""
    long, gap = look.between(0.23, 0.3), look.between(0.03, 0.045)
    color = look.color(*GRIPS)
    steel, skin = bright_steel(look), look.surface(color, "plastic")
    arms, grips, parts = [], [], []
    for s in (-1, 1):
        path = [(0.5 * long, s * 0.006, 0.01), (0.1 * long, s * 0.75 * gap, 0.01),
                (-0.28 * long, s * gap, 0.01), (-0.5 * long, s * (gap - 0.006), 0.01)]  # fmt: skip
        arm = sweep(smooth(path, 3), rectangle(0.0026, 0.02, 0.0008, 1))
        hand = sweep([(0.3 * long, s * 0.43 * gap, 0.01), (0.08 * long, s * 0.76 * gap, 0.01)],
                     rectangle(0.009, 0.02, 0.003, 2))  # fmt: skip
        head = prism(ellipse(0.05, 0.02, 14), 0, 0.003).turn(0, np.pi / 2)
        head = head.turn(2, -s * 0.14).move(-0.5 * long + 0.012, s * (gap - 0.006), 0.01)
        arms += [arm, head]
        grips.append(hand)
        parts += [*_slices(arm, [-0.5 * long - 0.02, -0.2 * long, 0.52 * long]), hull_of(head)]
    ring = torus(0.009, 0.0016, 16, 6).move(x=0.5 * long + 0.009, z=0.01)
    hinge = cylinder(0.007, 0.02, 14).move(x=0.5 * long)
    return shape(
        [(join([*arms, ring, hinge]), steel), (join(grips), skin)], [*parts, hull_of(hinge)]
    )


def peeler(look: Look) -> Shape:
    """A vegetable peeler lying flat: a Y-peeler or a straight one."""
    color = look.color("black", "red", "green", "white", "orange", "teal", "silver", "yellow")
    skin, steel = look.surface(color, "plastic"), bright_steel(look)
    if look.chance(0.6):
        wide = look.between(0.058, 0.066)
        grip = sweep([(-0.005, 0, 0.006), (0.03, 0, 0.0065), (0.075, 0, 0.006)],
                     rectangle(0.02, 0.012, 0.005, 3), [0.7, 1.0, 0.85])  # fmt: skip
        fork = sweep(
            smooth(
                [
                    (-0.06, -wide / 2, 0.006),
                    (-0.03, -wide / 2, 0.006),
                    (-0.004, 0, 0.006),
                    (-0.03, wide / 2, 0.006),
                    (-0.06, wide / 2, 0.006),
                ],
                4,
            ),
            rectangle(0.01, 0.0115, 0.003, 2),
        )
        edge = [box(0.004, wide - 0.004, 0.0016).turn(1, 0.5).move(x=u, z=0.006)
                for u in (-0.058, -0.051)]  # fmt: skip
        x = fork.vertices[:, 0]
        y = fork.vertices[:, 1]
        arms = [hull_part(fork.vertices[(s * y > 0.35 * wide)]) for s in (-1, 1)]
        return shape([(join([grip, fork]), skin), (join(edge), steel)],
                     [hull_of(grip), *arms, hull_part(fork.vertices[x > -0.028]),
                      hull_of(*edge)])  # fmt: skip
    grip = grip_bar(-0.01, 0.09, 0.021, 0.0066)
    ring = np.array([(0.5, 0), (0, 0.4), (-0.5, 0), (0, -0.12)])
    long = look.between(0.075, 0.085)
    path = np.column_stack([-0.005 - long * np.linspace(0, 1, 6), np.zeros(6), np.full(6, 0.006)])
    blade = sweep(path, ring, 0.017 * np.array([0.5, 0.9, 1, 1, 0.9, 0.2]))
    return shape([(grip, skin), (blade, steel)], [hull_of(grip), hull_of(blade)])


def grater(look: Look) -> Shape:
    """A four-sided box grater standing, with a handle on top."""
    x, y, h = look.between(0.095, 0.115), look.between(0.075, 0.085), look.between(0.19, 0.22)
    color = look.color("black", "red", "green", "teal", "orange", "silver", "white")
    face = textures.brushed_metal(look.rng, (196, 199, 204), 128).copy()
    face = textures.fit(face, 128, 128).copy()
    count = look.pick([7, 9])
    v, u = np.mgrid[0:128, 0:128] / 128
    cells = np.hypot(
        (u * count) % 1 - 0.5, ((v * count + 0.5 * (np.floor(u * count) % 2)) % 1) - 0.5
    )
    keep = (u > 0.1) & (u < 0.9) & (v > 0.12) & (v < 0.86)
    face[(cells < 0.36) & keep] = (236, 238, 242)
    face[(cells < 0.24) & keep] = (52, 54, 58)
    square = rectangle(1, 1)
    rings = np.stack([np.column_stack([square * [x * k, y * k], np.full(4, z)])
                      for k, z in ((1.0, 0.008), (0.78, h))])  # fmt: skip
    sides = []
    for k in range(4):
        a, b = rings[0][k], rings[0][(k + 1) % 4]
        c, d = rings[1][(k + 1) % 4], rings[1][k]
        inward = -0.002 * np.append((a + b)[:2] / np.linalg.norm((a + b)[:2]), 0)
        corners = np.array([a, b, c, d])
        quad = np.concatenate([corners, corners + inward])
        faces = np.array(
            [
                [0, 1, 2],
                [0, 2, 3],
                [5, 4, 7],
                [5, 7, 6],
                [0, 4, 5],
                [0, 5, 1],
                [1, 5, 6],
                [1, 6, 2],
                [2, 6, 7],
                [2, 7, 3],
                [3, 7, 4],
                [3, 4, 0],
            ]
        )
        uv = np.array([(0, 0), (1, 0), (1, 1), (0, 1)] * 2, float)
        sides.append(Solid(quad, faces, uv))
    body = join(sides)
    skin = look.surface(color, "plastic")
    lid = block(0.8 * x, 0.8 * y, 0.012, 0.012, 0.003).move(z=h - 0.004)
    foot = loft(np.stack([np.column_stack([rectangle(x * k, y * k), np.full(4, z)])
                          for k, z in ((1.03, 0), (1.02, 0.012))]), square)  # fmt: skip
    ear = tube(smooth([(-0.3 * x, 0, h), (-0.27 * x, 0, h + 0.035), (0.27 * x, 0, h + 0.035),
                       (0.3 * x, 0, h)], 4), 0.007, 8)  # fmt: skip
    return shape([(body, face), (join([lid, foot, ear]), skin)],
                 [hull_of(body, foot), hull_of(lid), hull_of(ear)])  # fmt: skip


CATEGORIES = (
    Category("spatula", spatula, (0.306, 0.0711, 0.0214), 0.09, ("turner", "fish slice",
             "egg flipper", "slotted spatula", "pancake turner", "rubber spatula",
             "wooden spatula", "slotted turner"), ("kitchen",), ("flat",), ("black",
             "red"), state="lying flat"),
    Category("ladle", ladle, (0.331, 0.082, 0.0593), 0.14, ("soup ladle", "serving ladle",
             "dipper"), ("kitchen", "dining"), (), ("silver", "black"), state="lying down"),
    Category("tongs", tongs, (0.29, 0.08, 0.02), 0.13, ("kitchen tongs", "cooking tongs",
             "pair of tongs", "serving tongs", "barbecue tongs", "sugar nips"), ("kitchen",),
             ("flat",), ("silver", "black"), state="lying flat"),
    Category("peeler", peeler, (0.149, 0.0548, 0.0125), 0.045, ("vegetable peeler",
             "potato peeler", "y peeler", "swivel peeler"), ("kitchen",), ("flat",), ("black",
             "red"), state="lying flat"),
    Category("grater", grater, (0.11, 0.085, 0.24), 0.25, ("cheese grater", "box grater",
             "vegetable grater", "shredder"), ("kitchen",), ("tall",), ("silver", "black")),
)  # fmt: skip
"""The module's categories."""
