"""Hand tools: mallets, axes, bars, planes, callipers, vises, glue guns, cutters."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, frame_parts, hull_of
from ...build.forms import facing, side_view
from ...build.outlines import arc, ellipse, rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import (
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    prism,
    sweep,
    tube,
)
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .tools import GRIPS, lying, steel

DARK = (40, 40, 43)


def mallet(look: Look) -> Shape:
    """A mallet lying: a fat wooden or rubber head on a round handle."""
    k = look.between(0.88, 1.06)
    color = look.color("wooden", "black", "wooden", "white", "red", "tan")
    head = look.surface(color, "wood" if look.chance(0.6) else "plastic")
    handle = textures.wood(look.rng, look.own_color("tan", "wooden", "brown"), side=64)
    r = 0.032 * k
    if look.chance(0.5):
        top = cylinder(r, 0.1 * k, 28, bevel=0.003).turn(0, np.pi / 2).move(0.115 * k, 0.05 * k, r)
    else:
        top = block(0.06 * k, 0.11 * k, 2 * r, 0.004, 0.003).move(x=0.115 * k)
    rod = lying(lathe(np.array([(0, 0), (0.012, 0), (0.0145, 0.02), (0.011, 0.1), (0.0115, 0.26),
                                (0, 0.26)]) * k, 18), -0.14 * k, r)  # fmt: skip
    lean = np.arctan2(r - 0.0145 * k, 0.235 * k)
    top, rod = (
        s.move(x=-0.115 * k, z=-r).turn(1, -lean).move(x=0.115 * k, z=r) for s in (top, rod)
    )
    low = min(float(s.bounds[0, 2]) for s in (top, rod))
    top, rod = top.move(z=-low), rod.move(z=-low)
    return shape([(top, head), (rod, handle)],
                 [flat_foot(top.vertices, 0.06), hull_of(rod)])  # fmt: skip


def axe(look: Look) -> Shape:
    """A hatchet lying on its side."""
    k = look.between(0.9, 1.06)
    color = look.color("wooden", "tan", "red", "wooden", "orange", "black")
    grip = tube(smooth(np.array([(-0.16, -0.012, 0.011), (-0.14, 0.0, 0.011), (-0.02, 0.006, 0.011),
                                 (0.13, 0.0, 0.011)]) * k, 5), 0.0155 * k, 12,
                                     squash=0.7)  # fmt: skip
    head = prism(np.array([(0.085, 0.03), (0.085, -0.02), (0.07, -0.05), (0.062, -0.09),
                           (0.15, -0.095), (0.135, -0.05), (0.13, -0.02), (0.13, 0.03)]) * k,
                 0.0, 0.024 * k)  # fmt: skip

    def sharpen(p: np.ndarray) -> np.ndarray:
        t = np.clip((-p[:, 1] / k - 0.02) / 0.075, 0, 1)
        return np.column_stack([p[:, :2], 0.012 * k + (p[:, 2] - 0.012 * k) * (1 - 0.92 * t)])

    head = head.bend(sharpen)
    edge = box(0.088 * k, 0.006 * k, 0.0034 * k).move(0.106 * k, -0.09 * k, 0.0103 * k)
    paint = textures.speckles(look.rng, look.own_color("charcoal", "red", "gray"), 5, 32)
    return shape([(grip, look.surface(color, "wood")), (head, paint), (edge, steel(look))],
                 [hull_of(grip), hull_of(head)])  # fmt: skip


def crowbar(look: Look) -> Shape:
    """A crowbar lying on its side: a hooked claw, a flattened end."""
    k = look.between(0.88, 1.05)
    color = look.color("red", "blue", "black", "yellow", "charcoal", "red")
    r = 0.0075 * k
    hook = arc((0.12, 0.028), 0.028, -np.pi / 2, np.pi * 0.72, 8)
    way = np.concatenate([[(-0.17, -0.012), (-0.145, -0.002), (-0.12, 0)], hook])
    path = np.column_stack([way, np.full(len(way), r / k)]) * k
    scale = np.ones(len(path))
    scale[:2], scale[-2:] = (0.9, 1.0), (1.0, 0.8)
    bar = sweep(path, ellipse(2 * r, 2 * r, 6, np.pi / 6), scale)
    tips = [box(0.03 * k, 0.02 * k, 0.004).turn(2, 0.5).move(-0.16 * k, -0.01 * k, r - 0.002),
            box(0.024 * k, 0.021 * k, 0.005).turn(2, np.pi * 0.72 + np.pi / 2)
            .move(*path[-1][:2], r - 0.0025)]  # fmt: skip
    cut = len(path) - 9
    bits = [hull_of(sweep(path[a:b], ellipse(2 * r, 2 * r, 6, np.pi / 6))) for a, b in
            ((0, cut + 1), (cut, cut + 4), (cut + 3, cut + 7), (cut + 6, len(path)))]  # fmt: skip
    return shape([(bar, look.surface(color, "plastic")), (join(tips), steel(look))], bits)


def hand_plane(look: Look) -> Shape:
    """A woodworking plane standing: sole, iron, front knob and rear handle."""
    k = look.between(0.88, 1.05)
    color = look.color("wooden", "brown", "maroon", "wooden", "tan")
    wood = look.surface(color, "wood")
    metal = textures.brushed_metal(look.rng, look.own_color("charcoal", "gray", "blue", "black"))
    sole = prism(_rounded_ends(0.235 * k, 0.058 * k), 0, 0.012 * k)
    cheeks = [side_view(np.array([(-0.07, 0.01), (0.06, 0.01), (0.03, 0.038), (-0.035, 0.038)]) * k,
                        0.0035 * k).move(y=s * 0.026 * k) for s in (-1, 1)]  # fmt: skip
    frog = side_view(np.array([(-0.055, 0.01), (0.018, 0.01), (-0.02, 0.055), (-0.028, 0.055)]) * k,
                     0.045 * k)  # fmt: skip
    iron = side_view(np.array([(0.014, 0.014), (0.018, 0.017), (-0.035, 0.083),
        (-0.039, 0.08)]) * k,
                     0.046 * k)  # fmt: skip
    knob = lathe(np.array([(0, 0.011), (0.014, 0.011), (0.01, 0.022), (0.0155, 0.04),
        (0.0145, 0.05),
                           (0, 0.056)]) * k, 22).move(x=0.085 * k)  # fmt: skip
    tote = tube(smooth([(-0.085, 0, 0.01), (-0.074, 0, 0.04), (-0.084, 0, 0.07),
        (-0.102, 0, 0.084)],
                       4) * k, 0.0115 * k, 10)  # fmt: skip
    return shape([(join([sole, *cheeks]), metal), (frog, metal), (iron, steel(look)),
                  (knob, wood), (tote, wood)],
                 [hull_of(sole), hull_of(frog), hull_of(knob), hull_of(tote),
                     hull_of(iron)])  # fmt: skip


def _rounded_ends(x: float, y: float) -> np.ndarray:
    return rectangle(x, y, 0.4 * y, 4)


def caliper(look: Look) -> Shape:
    """A vernier calliper lying: scale, fixed and sliding jaws."""
    k = look.between(0.9, 1.05)
    color = look.color("silver", "silver", "black", "charcoal")
    metal = look.surface(color, "metal")
    at = look.between(-0.05, -0.02) * k
    scale = np.repeat(prints.rule(15, (206, 208, 212), (40, 40, 44)), 2, axis=0)
    beam = box(0.22 * k, 0.015 * k, 0.0035).move(x=0.01 * k, z=0.0012)
    face = box(0.19 * k, 0.0145 * k, 0.0004).move(x=0.02 * k, z=0.0046)
    jaw = np.array([(0, 0.0075), (0, -0.045), (-0.006, -0.045), (-0.018, -0.0075), (-0.018, 0.0075),
                    (-0.008, 0.024), (0, 0.026)])[::-1] * k  # fmt: skip
    fixed = prism(np.add(jaw, (-0.082 * k, 0)), 0, 0.0045)
    moving = prism(np.add((jaw * [-1, 1])[::-1], (at - 0.02 * k, 0)), 0, 0.0055)
    slide = block(0.055 * k, 0.026 * k, 0.009, 0.003, 0.001).move(x=at + 0.02 * k)
    shown = prints.canvas(64, 28, (176, 190, 176))
    prints.write(shown, f"{look.between(10, 90):.2f}", 0.5, 0.5, 0.6, (24, 26, 24))
    display = box(0.038 * k, 0.015 * k, 0.0006).move(x=at + 0.02 * k, z=0.0088)
    wheel = cylinder(0.005 * k, 0.004, 14).move(at + 0.04 * k, -0.013 * k, 0.002)
    black = textures.plain(DARK)
    return shape([(join([beam, fixed, moving]), metal), (face, scale), (slide, black),
                  (display, shown), (wheel, steel(look))],
                 [hull_of(beam), hull_of(fixed), hull_of(moving), hull_of(slide)])  # fmt: skip


def drill_bit(look: Look) -> Shape:
    """A twist drill bit lying."""
    k = look.between(0.8, 1.3)
    color = look.color("silver", "gold", "charcoal", "black")
    r, long, n = 0.004 * k, 0.1 * k, 44
    t = np.linspace(0, 1, n)
    section = ellipse(2, 1.15, 12) * r
    rings = []
    for s in t:
        a = 0.0 if s > 0.68 else (0.68 - s) * 32
        c, w = np.cos(a), np.sin(a)
        size = np.clip(s / 0.07, 0.08, 1)
        body = section if s <= 0.68 else ellipse(2 * r, 2 * r, 12)
        ring = body @ np.array([[c, w], [-w, c]]) * size
        rings.append(np.column_stack([np.full(12, s * long), ring]))
    bit = loft(np.stack(rings), section, profile=np.column_stack([t * long, 0 * t]))
    bit = bit.move(x=-long / 2, z=-float(bit.bounds[0, 2]))
    return shape([(bit, look.surface(color, "metal"))], [flat_foot(bit.vertices, 0.14)])


def vise(look: Look) -> Shape:
    """A bench vise standing: base, two jaws, a screw with a bar."""
    k = look.between(0.8, 1.0)
    color = look.color("blue", "red", "green", "charcoal", "gray", "orange")
    paint = look.surface(color, "plastic")
    base = cylinder(0.055 * k, 0.018 * k, 30, top=0.045 * k)
    lugs = [block(0.05 * k, 0.035 * k, 0.012 * k, 0.01).move(x=s * 0.055 * k) for s in (-1, 1)]
    body = block(0.06 * k, 0.06 * k, 0.05 * k, 0.006, 0.003).move(y=0.012 * k, z=0.017 * k)
    bar = box(0.034 * k, 0.16 * k, 0.03 * k).move(y=-0.02 * k, z=0.03 * k)
    gap = look.between(0.004, 0.02) * k
    jaws = [block(0.085 * k, 0.026 * k, 0.056 * k, 0.004, 0.003).move(y=y, z=z) for y, z in
            ((0.016 * k, 0.06 * k), (-0.01 * k - gap, 0.06 * k))]  # fmt: skip
    nose = block(0.05 * k, 0.036 * k, 0.06 * k, 0.006, 0.003).move(y=-0.018 * k - gap, z=0.03 * k)
    plates = [box(0.08 * k, 0.003 * k, 0.02 * k).move(y=y, z=0.094 * k) for y in
              (0.0025 * k, 0.0035 * k - gap)]  # fmt: skip
    screw = facing(cylinder(0.009 * k, 0.05 * k, 16)).move(y=-0.085 * k, z=0.045 * k)
    screw = screw.move(y=-0.02 * k)
    lever = cylinder(0.0042 * k, 0.12 * k, 10).turn(1, np.pi / 2 - 0.35).move(
        -0.056 * k, -0.148 * k, 0.045 * k - 0.02 * k)  # fmt: skip
    knobs = [ellipsoid(0.014, 0.014, 0.014, 10, 8).scale(k, k, k).move(
        s * 0.056 * k, -0.148 * k, (0.045 + s * 0.0205) * k) for s in (-1, 1)]  # fmt: skip
    tail = facing(cylinder(0.009 * k, 0.06 * k, 14)).move(y=-0.06 * k, z=0.045 * k)
    silver = steel(look)
    return shape([(join([base, *lugs, body, *jaws, nose, bar]), paint),
                  (join([*plates, screw, tail, lever, *knobs]), silver)],
                 [hull_of(base), *(hull_of(s) for s in (body, *jaws, nose, bar, *lugs)),
                  hull_of(screw), hull_of(lever)])  # fmt: skip


def glue_gun(look: Look) -> Shape:
    """A hot glue gun lying on its side, a glue stick at its back."""
    k = look.between(0.88, 1.06)
    color = look.color("blue", "black", "yellow", "red", "teal", "orange", "green")
    h = 0.03 * k
    outline = np.array([(-0.075, 0.03), (-0.07, -0.005), (-0.066, -0.085), (-0.035, -0.09),
                        (-0.02, -0.012), (0.045, 0.0), (0.05, 0.036), (-0.03, 0.042)])  # fmt: skip
    body = prism(outline * k, 0, h)
    nose = lying(lathe(np.array([(0, 0), (0.012, 0), (0.011, 0.012), (0.0045, 0.03),
        (0.0028, 0.038),
                                 (0, 0.038)]) * k, 18), 0.048 * k,
                                     h / 2).move(y=0.018 * k)  # fmt: skip
    collar = lying(cylinder(0.0145 * k, 0.012 * k, 20), 0.042 * k, h / 2).move(y=0.018 * k)
    trigger = prism(np.array([(-0.022, -0.012), (-0.03, -0.05), (-0.018, -0.055), (-0.004, -0.012)])
                    * k, 0.3 * h, 0.7 * h)  # fmt: skip
    stick = lying(cylinder(0.0056 * k, 0.06 * k, 14), -0.13 * k, h / 2).move(y=0.016 * k)
    plate = prism(outline[1:5] * k * 0.8 + [-0.009 * k, -0.01 * k], h - 0.0005, h + 0.0012)
    return shape([(body, look.surface(color, "plastic")), (nose, textures.plain((206, 176, 100))),
                  (join([collar, trigger]), textures.plain(DARK)), (plate, textures.plain(
                      tint_color(color, 0.6))), (stick, textures.plain((236, 230, 206)))],
                 [hull_of(prism(outline[[0, 1, 4, 5, 6, 7]] * k, 0, h)),
                  hull_of(prism(outline[1:5] * k, 0, h)), hull_of(nose),
                      hull_of(stick)])  # fmt: skip


def sandpaper(look: Look) -> Shape:
    """Sheets of sandpaper lying, one corner turned up."""
    k = look.between(0.85, 1.1)
    x, y, h = 0.14 * k, 0.11 * k, look.between(0.0012, 0.003)
    color = look.color("brown", "tan", "orange", "charcoal", "terracotta", "maroon")
    grit = textures.spots(look.rng, color, tint_color(color, 0.6), 0.25)
    grit = np.clip(grit.astype(int) + look.rng.integers(-14, 14, grit.shape[:2])[..., None], 0, 255)
    sheet = box(x, y, h)
    curl = side_view(np.array([(0, 0), (0.02, 0.006), (0.021, 0.0072), (0, 0.0014)]) * k, 0.03 * k)
    curl = curl.turn(2, np.pi / 4).move(0.4 * x, 0.36 * y, h - 0.0004)
    back = prints.canvas(64, 64, (226, 214, 190))
    prints.write(back, look.pick(["P120", "P240", "P80", "P400"]), 0.5, 0.5, 0.24, (150, 110, 80))
    return shape([(sheet, grit.astype(np.uint8)), (curl, back)], [box_part(x, y, h)])


def paint_tray(look: Look) -> Shape:
    """A sloping tray for paint rollers, open, a film of paint in its well."""
    k = look.between(0.88, 1.05)
    x, y, h, wall = 0.28 * k, 0.2 * k, 0.05 * k, 0.004
    color = look.color("black", "charcoal", "white", "blue", "gray", "red")
    tile = look.surface(color, "plastic")
    walls = [box(x, wall, h).move(y=s * (y - wall) / 2) for s in (-1, 1)]
    walls += [box(wall, y, h).move(x=s * (x - wall) / 2) for s in (-1, 1)]
    ramp = side_view(np.array([(-0.02, 0), (0.5, 0), (0.5, 0.62 * h / x), (0.46, 0.62 * h / x)])
                     * x * [0.98, 1], y - wall)  # fmt: skip
    ribs = [
        box(0.0035, 0.86 * y, 0.003)
        .turn(1, -0.24)
        .move((0.06 + 0.06 * n) * x, 0, (0.12 + 0.145 * n) * 0.62 * h * 0.98 + 0.001)
        for n in range(6)
    ]
    paint = look.own_color("white", "sky", "mint", "yellow", "coral", "cream")
    pool = box(0.56 * x, y - 2 * wall, 0.004).move(x=-0.21 * x, z=0.0025)
    floor = box(x, y, 0.003)
    return shape([(join([floor, *walls, ramp, *ribs]), tile), (pool, textures.plain(paint))],
                 [*frame_parts(x, y, h, wall, 0.006), hull_of(ramp)])  # fmt: skip


def putty_knife(look: Look) -> Shape:
    """A putty knife lying: a broad steel blade, a riveted handle."""
    k = look.between(0.88, 1.08)
    wide = look.between(0.03, 0.075) * k
    color = look.color("wooden", "black", "red", "wooden", "blue", "yellow")
    blade = prism(np.array([(0.0, -0.011 * k), (0.085 * k, -wide / 2), (0.1 * k, -wide / 2),
                            (0.1 * k, wide / 2), (0.085 * k, wide / 2), (0.0, 0.011 * k)]),
                  0.0, 0.0016)  # fmt: skip
    blade = blade.bend(lambda p: np.column_stack([p[:, :2], p[:, 2] + 0.007 * np.clip(
        1 - p[:, 0] / (0.1 * k), 0, 1)]))  # fmt: skip
    grip = prism(rectangle(0.105 * k, 0.026 * k, 0.009 * k), 0, 0.016 * k, 0.003).move(x=-0.05 * k)
    rivets = [cylinder(0.0032 * k, 0.0012, 12).move((-0.025 - 0.035 * n) * k, 0, 0.0155 * k)
              for n in range(3)]  # fmt: skip
    metal = steel(look)
    return shape([(blade, metal), (grip, look.surface(color, "wood")), (join(rivets), metal)],
                 [hull_of(blade), hull_of(grip)])  # fmt: skip


def _cutters(beak: list[tuple[float, float]], long: float, thick: float) -> Callable[[Look], Shape]:
    """Two crossed levers lying, grips to the left: cutters, snips, strippers."""

    def made(look: Look) -> Shape:
        k = look.between(0.9, 1.08)
        color = look.color(*GRIPS)
        rubber = look.surface(color, "plastic")
        h = thick * k
        heads, grips, parts = [], [], []
        for s in (-1, 1):
            head = np.array(beak) * [1, s] * k
            head = head if s > 0 else head[::-1]
            heads.append(prism(head, 0.1 * h + 0.0 * s, 0.9 * h))
            way = smooth(np.array([(0, s * -0.004, 0), (-0.03, s * -0.013, 0), (-0.5 * long, s *
                         -0.026, 0), (-long, s * -0.021, 0)]) * k + [0, 0, h / 2], 4)  # fmt: skip
            grips.append(sweep(way, rectangle(0.011 * k, h, 0.003, 2)))
            parts += [hull_of(heads[-1]), hull_of(grips[-1])]
        pivot = cylinder(0.0065 * k, h + 0.0015, 18).move(x=0.002 * k)
        return shape([(join(heads), steel(look)), (join(grips), rubber),
                      (pivot, textures.plain((120, 124, 130)))], parts)  # fmt: skip

    return made


def staple_gun(look: Look) -> Shape:
    """A staple gun lying on its side."""
    k = look.between(0.9, 1.06)
    color = look.color("silver", "red", "yellow", "black", "blue", "gray")
    h = 0.026 * k
    outline = np.array([(-0.085, 0.005), (-0.08, -0.016), (0.07, -0.02), (0.088, -0.02),
                        (0.088, 0.045), (0.05, 0.062), (0.02, 0.05), (-0.03, 0.028)])  # fmt: skip
    hole = prism(np.array([(-0.06, 0.0), (0.02, -0.004), (0.03, 0.022), (-0.02, 0.018)]) * k,
                 -0.0004, h + 0.0006)  # fmt: skip
    lever = prism(np.array([(0.055, 0.058), (0.058, 0.07), (-0.085, 0.062), (-0.092, 0.052),
                            (-0.03, 0.05)]) * k, 0.15 * h, 0.85 * h)  # fmt: skip
    body = prism(outline * k, 0, h)
    return shape([(body, look.surface(color, "metal")), (hole, textures.plain(DARK)),
                  (lever, textures.plain(tint_color(color, 0.55)))],
                 [hull_of(body), hull_of(lever)])  # fmt: skip


def oil_can(look: Look) -> Shape:
    """An oil can standing: a flat cone with a long bent spout."""
    k = look.between(0.88, 1.08)
    color = look.color("red", "green", "blue", "copper", "silver", "yellow")
    body = lathe(np.array([(0, 0), (0.04, 0), (0.042, 0.003), (0.042, 0.04), (0.034, 0.05),
                           (0.01, 0.068), (0.009, 0.076), (0, 0.076)]) * k, 30)  # fmt: skip
    spout = smooth([(0, 0, 0.072), (0.005, 0, 0.1), (0.04, 0, 0.14), (0.075, 0, 0.165)], 5) * k
    nose = tube(spout, np.linspace(0.006, 0.0018, len(spout)) * k, 10)
    handle = tube(smooth([(-0.04, 0, 0.035), (-0.07, 0, 0.045), (-0.065, 0, 0.075),
                          (-0.012, 0, 0.072)], 4) * k, 0.0042 * k, 8)  # fmt: skip
    return shape([(body, look.surface(color, "metal")), (nose, steel(look)),
                  (handle, textures.plain(tint_color(color, 0.7)))],
                 [cylinder_part(0.042 * k, 0.042 * k), hull_of(body), hull_of(nose),
                  hull_of(handle)])  # fmt: skip


def socket_wrench(look: Look) -> Shape:
    """A ratchet lying, a socket on its head."""
    k = look.between(0.88, 1.05)
    color = look.color("silver", "black", "red", "blue", "silver")
    metal = textures.brushed_metal(look.rng, (186, 189, 194))
    z = 0.015 * k
    head = cylinder(0.0185 * k, 0.02 * k, 28, bevel=0.003).move(x=0.08 * k, z=0.005 * k)
    dial = cylinder(0.011 * k, 0.004 * k, 20).move(x=0.08 * k, z=0.0245 * k)
    neck = lying(cylinder(0.0065 * k, 0.09 * k, 14), -0.015 * k, z)
    grip = lying(lathe(np.array([(0, 0), (0.012, 0.001), (0.0145, 0.01), (0.012, 0.05),
                                 (0.0145, 0.09), (0.008, 0.1), (0, 0.1)]) * k, 18), -0.11 * k,
                                     z)  # fmt: skip
    switch = box(0.016 * k, 0.005 * k, 0.003 * k).turn(2, 0.6).move(x=0.08 * k, z=0.028 * k)
    socket = cylinder(0.0125 * k, 0.006 * k, 22).move(x=0.08 * k)
    knurl = textures.stripes([tint_color(color, 0.8), tint_color(color, 1.15)], 14)
    return shape([(join([head, neck, socket]), metal), (join([dial, switch]), textures.plain(DARK)),
                  (grip, knurl)],
                 [hull_of(head, socket), hull_of(neck), flat_foot(grip.vertices, 0.1)])  # fmt: skip


def pipe_wrench(look: Look) -> Shape:
    """A pipe wrench lying: a toothed hook jaw over a fixed one, a long handle."""
    k = look.between(0.88, 1.05)
    color = look.color("red", "red", "orange", "blue", "green")
    h = 0.02 * k
    body = prism(np.array([(-0.15, -0.011), (-0.05, -0.008), (0.02, -0.014), (0.075, -0.02),
                           (0.08, -0.004), (0.05, 0.004), (0.05, 0.016), (0.015, 0.018),
                           (-0.05, 0.009), (-0.15, 0.011)]) * k, 0, h)  # fmt: skip
    hook = prism(np.array([(0.02, 0.012), (0.046, 0.012), (0.092, 0.014), (0.104, -0.002),
                           (0.098, -0.022), (0.116, -0.02), (0.124, 0.006), (0.105, 0.032),
                           (0.02, 0.032)]) * k, 0.15 * h, 0.85 * h)  # fmt: skip
    teeth = [box(0.003 * k, 0.012 * k, 0.8 * h).turn(2, 0.1).move(x, -0.013 * k, 0.1 * h)
             for x in (0.0815 * k, 0.094 * k)]  # fmt: skip
    nut = lying(cylinder(0.0125 * k, 0.014 * k, 16), 0.022 * k, 0.0125 * k).move(y=0.022 * k)
    return shape([(body, look.surface(color, "plastic")), (join([hook, *teeth]), steel(look)),
                  (nut, textures.stripes([(90, 92, 96), (150, 152, 156)], 8))],
                 [hull_of(body), hull_of(hook)])  # fmt: skip


def hacksaw(look: Look) -> Shape:
    """A hacksaw lying on its side: bow, thin blade, pistol grip."""
    k = look.between(0.85, 1.0)
    color = look.color("red", "blue", "black", "yellow", "orange", "green")
    z = 0.008 * k
    way = np.array([(0.17, 0.0), (0.172, 0.07), (0.16, 0.085), (-0.09, 0.085), (-0.11, 0.07),
                    (-0.115, 0.0)])  # fmt: skip
    bow = sweep(np.column_stack([way, np.full(6, z / k)]) * k, rectangle(0.008 * k, 0.014 * k))
    blade = box(0.285 * k, 0.012 * k, 0.0012).move(0.028 * k, -0.004 * k, z)
    teeth = prints.canvas(128, 16, (150, 154, 160))
    for n in range(32):
        prints.polygon(
            teeth, [(n / 32, 1), (n / 32 + 0.03, 1), (n / 32 + 0.015, 0.6)], (70, 72, 76)
        )
    grip = prism(np.array([(-0.11, 0.075), (-0.115, -0.015), (-0.15, -0.035), (-0.17, -0.02),
                           (-0.16, 0.05), (-0.145, 0.082)])[::-1] * k, 0, 2 * z)  # fmt: skip
    return shape([(bow, steel(look)), (blade, teeth), (grip, look.surface(color, "plastic"))],
                 [hull_of(grip), box_part(0.26 * k, 0.008 * k, 0.014 * k,
                                          (0.03 * k, 0.085 * k, 0.001 * k)),
                  box_part(0.008 * k, 0.085 * k, 0.014 * k, (0.17 * k, 0.042 * k, 0.001 * k)),
                  hull_of(blade)])  # fmt: skip


CATEGORIES = (
    Category("mallet", mallet, (0.28, 0.103, 0.068), 0.45, ("rubber mallet", "wooden mallet",
             "wood mallet"), ("workbench",), (), ("wooden", "black"), None, "lying flat"),
    Category("axe", axe, (0.31, 0.125, 0.024), 0.7, ("hatchet", "ax", "tomahawk", "small axe"),
             ("workbench",), (), ("wooden", "red"), None, "lying flat"),
    Category("crowbar", crowbar, (0.32, 0.08, 0.0148), 0.7, ("pry bar", "crow bar", "prybar",
             "wrecking bar"), ("workbench",), (), ("red", "blue"), None, "lying flat"),
    Category("hand_plane", hand_plane, (0.227, 0.056, 0.085), 1.2, ("wood plane",
             "block plane", "bench plane", "carpenter plane", "jack plane",
             "woodworking plane"), ("workbench",), (), ("wooden",)),
    Category("caliper", caliper, (0.215, 0.069, 0.0094), 0.15, ("calliper", "vernier caliper",
             "digital caliper", "calipers", "callipers", "vernier calliper"), ("workbench",),
             ("flat",), ("silver",), None, "lying flat"),
    Category("drill_bit", drill_bit, (0.105, 0.0084, 0.0084), 0.03, ("twist drill",
             "drill bit piece"), ("workbench",), (), ("silver", "gold"), None, "lying flat"),
    Category("vise", vise, (0.144, 0.203, 0.104), 2.2, ("vice", "bench vise", "bench vice",
             "table vise", "table vice"), ("workbench",), ("big",), ("blue", "red")),
    Category("glue_gun", glue_gun, (0.209, 0.128, 0.03), 0.2, ("hot glue gun", "hot melt gun"),
             ("workbench", "craft"), (), ("blue", "black"), None, "lying flat"),
    Category("sandpaper", sandpaper, (0.137, 0.107, 0.008), 0.02, ("sand paper",
             "sandpaper sheet", "sheet of sandpaper", "emery paper", "abrasive paper",
             "glass paper"), ("workbench",), ("flat",), ("brown", "tan"), 0.7, "lying flat"),
    Category("paint_tray", paint_tray, (0.27, 0.193, 0.048), 0.25, ("paint roller tray",
             "roller tray", "painting tray"), ("workbench",), ("container", "big"), ("black",)),
    Category("putty_knife", putty_knife, (0.198, 0.051, 0.016), 0.1, ("scraper", "filling knife",
             "paint scraper", "stripping knife", "wall scraper", "spackle knife",
             "drywall knife"), ("workbench",), (), ("wooden", "black"), None, "lying flat"),
    Category("wire_cutters", _cutters([(-0.006, 0.009), (0.004, -0.004), (0.038, -0.0005),
             (0.04, 0.003), (0.024, 0.013), (0.006, 0.014)], 0.105, 0.012),
             (0.143, 0.064, 0.0135), 0.18, ("wire cutter", "diagonal cutter", "side cutter",
             "diagonal pliers", "nippers", "side cutters", "snips"), ("workbench",), (),
             ("red", "blue"), None, "lying flat"),
    Category("tin_snips", _cutters([(-0.006, 0.01), (0.004, -0.004), (0.075, -0.001),
        (0.078, 0.001),
             (0.06, 0.011), (0.02, 0.016)], 0.14, 0.014), (0.216, 0.064, 0.0155), 0.35,
             ("tin snip", "metal shears", "metal snips", "aviation snips"), ("workbench",), (),
                 ("red",),
             None, "lying flat"),
    Category("wire_stripper", _cutters([(-0.006, 0.009), (0.004, -0.004), (0.02, -0.001),
             (0.026, 0.004), (0.034, -0.001), (0.066, -0.0005), (0.068, 0.006), (0.03, 0.013),
             (0.006, 0.014)], 0.115, 0.01), (0.181, 0.064, 0.0115), 0.15, ("wire strippers",
             "crimping tool", "crimper", "cable stripper", "crimping pliers"), ("workbench",), (),
             ("red", "yellow"), None, "lying flat"),
    Category("staple_gun", staple_gun, (0.176, 0.088, 0.026), 0.6, ("tacker", "stapler gun"),
             ("workbench",), (), ("silver",), None, "lying flat"),
    Category("oil_can", oil_can, (0.142, 0.083, 0.164), 0.3, ("oiler", "oil dispenser can",
             "lubricant can"), ("workbench",), ("tall",), ("red", "copper")),
    Category("socket_wrench", socket_wrench, (0.201, 0.0365, 0.03), 0.35, ("ratchet",
             "ratchet wrench", "socket spanner", "ratchet spanner"), ("workbench",), (),
             ("silver",), None, "lying flat"),
    Category("pipe_wrench", pipe_wrench, (0.266, 0.056, 0.024), 0.8, ("plumber wrench",
             "plumber's wrench", "stillson wrench", "monkey wrench"), ("workbench",), (),
             ("red",), None, "lying flat"),
    Category("hacksaw", hacksaw, (0.32, 0.118, 0.016), 0.5, ("hack saw", "metal saw"),
        ("workbench",), ("big",), ("red", "blue"), None, "lying flat"),
)  # fmt: skip
"""The module's categories."""
