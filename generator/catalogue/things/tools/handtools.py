"""Hand tools: mallets, axes, bars, planes, callipers, vises, glue guns, cutters."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, flat_foot, frame_parts, hull_of
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
from ...build.variants import vary
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .tools import lying, steel

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
            .move(path[-1][0], path[-1][1], r - 0.0025)]  # fmt: skip
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


CATEGORIES = (
    Category("mallet", mallet, (0.28, 0.103, 0.068), 0.45, ("rubber mallet", "wooden mallet",
             "wood mallet", "croquet mallet"), ("workbench",), (), ("wooden", "black"), None,
             "lying flat"),
    Category("axe", axe, (0.31, 0.125, 0.024), 0.7, ("hatchet", "ax", "tomahawk", "small axe",
             "bronze axe head"),
             ("workbench",), (), ("wooden", "red"), None, "lying flat"),
    Category("crowbar", crowbar, (0.32, 0.08, 0.0148), 0.7, ("pry bar", "crow bar", "prybar",
             "wrecking bar"), ("workbench",), (), ("red", "blue"), None, "lying flat"),
    Category("hand_plane", hand_plane, (0.227, 0.056, 0.085), 1.2, ("wood plane",
             "block plane", "bench plane", "carpenter plane", "jack plane",
             "woodworking plane"), ("workbench",), (), ("wooden",)),
    vary(Category("caliper", caliper, (0.215, 0.069, 0.0094), 0.15, ("calliper", "vernier caliper",
             "digital caliper", "calipers", "callipers", "vernier calliper", "sewing gauge"),
             ("workbench",),
             ("flat",), ("silver",), None, "lying flat")),
    Category("drill_bit", drill_bit, (0.105, 0.0084, 0.0084), 0.03, ("twist drill",
             "drill bit piece", "spade bit", "screwdriver bit", "auger bit", "sds bit",
             "router bit", "dental burr", "countersink bit", "masonry bit"),
             ("workbench",), (),
             ("silver", "gold"), None, "lying flat"),
    Category("vise", vise, (0.144, 0.203, 0.104), 2.2, ("vice", "bench vise", "bench vice",
             "table vise", "table vice"), ("workbench",), ("big",), ("blue", "red")),
    Category("glue_gun", glue_gun, (0.209, 0.128, 0.03), 0.2, ("hot glue gun", "hot melt gun",
             "caulking gun"),
             ("workbench", "craft"), (), ("blue", "black"), None, "lying flat"),
    Category("sandpaper", sandpaper, (0.137, 0.107, 0.008), 0.02, ("sand paper",
             "sandpaper sheet", "sheet of sandpaper", "emery paper", "abrasive paper",
             "glass paper"), ("workbench",), ("flat",), ("brown", "tan"), 0.7, "lying flat"),
    Category("paint_tray", paint_tray, (0.27, 0.193, 0.048), 0.25, ("paint roller tray",
             "roller tray", "painting tray"), ("workbench",), ("container", "big"), ("black",)),
)  # fmt: skip
"""The module's categories."""
