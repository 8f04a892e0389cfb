"""Objects of the ``workbench`` theme: tools."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import BRASS_TONE, DARK, metal, shine, steel, tool_steel
from ...kit.outlines import arc, ellipse, rectangle, smooth
from ...kit.parts import box_part, cylinder_part, flat_foot, frame_parts, hull_of, hull_part
from ...kit.primitives import (
    at_block,
    at_box,
    disc,
    drum,
    facing,
    lay_down,
    lies,
    plate,
    rod,
    side_view,
    standing,
    straight,
)
from ...kit.shapes import Category, Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, prism, sweep, torus, tube
from ...kit.surfaces import Look, plain, tint_color
from .car_parts import BLACK


@category("wheel_brace", size=(0.38, 0.38, 0.026), mass=1.2, material="metal", assembled=True,
          aliases=("lug wrench", "tyre iron", "tire iron", "wheel wrench"), themes=("workbench",),
          roles=("flat", "big"), colors=("silver",))  # fmt: skip
@from_pieces(foot=0.05)
def wheel_brace(look: Look) -> Pieces:
    """A wheel brace lying flat: four arms in the shape of a cross, with a socket at each end."""
    steel = metal(look, "silver", "gray", "charcoal")
    arms = [straight((0, 0, 0.012), (0.17 * np.cos(a), 0.17 * np.sin(a), 0.012), 0.007, 10)
            for a in np.arange(4) * np.pi / 2]  # fmt: skip
    ends = [straight((0.15 * np.cos(a), 0.15 * np.sin(a), 0.013),
                     (0.19 * np.cos(a), 0.19 * np.sin(a), 0.013), 0.013, 12) for a in np.arange(4)
            * np.pi / 2]  # fmt: skip
    return [(join([arms[0], arms[2]]), steel), (join([arms[1], arms[3]]), steel),
            *((e, shine(look)) for e in ends)]  # fmt: skip


@category("fire_extinguisher", size=(0.112, 0.086, 0.246), mass=1.2, material="metal",
          aliases=("extinguisher", "mini fire extinguisher"), themes=("workbench",),
          roles=("tall",), colors=("red",))  # fmt: skip
def fire_extinguisher(look: Look) -> Shape:
    """A small fire extinguisher with a lever and a hose, standing upright."""
    color = look.color("red", "red", "crimson", "orange")
    k = look.between(0.75, 0.95)
    body = standing((0.045, 0), (0.05, 0.004), (0.05, 0.2), (0.042, 0.225), (0.018, 0.24),
                    (0.015, 0.25), sides=28)  # fmt: skip
    label = lathe([(0.0495, 0.07), (0.0506, 0.072), (0.0506, 0.16), (0.0495, 0.162)], 28, loop=True)
    image = prints.canvas(224, 80, (244, 240, 226))
    prints.write(image, "FIRE", 0.5, 0.3, 0.34, (190, 30, 30), bold=True)
    prints.lines(image, look.rng, (0.38, 0.55, 0.24, 0.35), 4, (60, 60, 64), 0.5)
    valve = [drum(0.014, 0.02, (0, 0, 0.248)), at_box(0.07, 0.016, 0.006, (0.02, 0, 0.27)),
             at_box(0.07, 0.016, 0.005, (0.024, 0, 0.284))]  # fmt: skip
    gauge = drum(0.012, 0.006, (0, -0.018, 0.262), 1)
    hose = rod(
        [(-0.012, 0, 0.26), (-0.06, 0, 0.25), (-0.066, 0, 0.16), (-0.062, 0, 0.1)], 0.0065, 10
    )
    return put_down([(body, plain(color)), (label, image), (join([*valve[:1], gauge]), steel(look)),
                     (join([*valve[1:], hose]), plain(DARK))], body, join(valve), hose,
                    factor=k)  # fmt: skip


@category("metal_file", size=(0.268, 0.025, 0.0248), mass=0.22, material="metal",
          aliases=("steel file", "rasp", "hand file", "flat file", "wood file", "wood rasp",
          "foot file"), themes=("workbench",), colors=("wooden", "red"),
          state="lying flat")  # fmt: skip
def metal_file(look: Look) -> Shape:
    """A metal file lying flat: a hatched blade on the left and a wooden or plastic handle."""
    long, wide = look.between(0.22, 0.3), look.between(0.018, 0.026)
    color = look.color("wooden", "red", "blue", "orange", "black", "yellow", "green")
    cut = 0.08 * long
    blade = prism(np.array([(-0.5 * long, -0.36 * wide), (cut, -0.5 * wide),
                            (cut + 0.012, -0.1 * wide), (cut + 0.05, -0.1 * wide),
                            (cut + 0.05, 0.1 * wide), (cut + 0.012, 0.1 * wide), (cut, 0.5 * wide),
                            (-0.5 * long, 0.36 * wide)]), 0.006, 0.0105)  # fmt: skip
    hatch = prints.canvas(128, 64, (150, 154, 160))
    for n in range(-32, 64):
        prints.stroke(hatch, [(n / 48, 0), (n / 48 + 0.3, 1)], 0.02, (104, 108, 114))
    r = 0.0125
    grip = lathe([(0, 0), (0.008, 0), (0.0095, 0.008), (r, 0.03), (0.0105, 0.06), (r, 0.092),
                  (0.009, 0.105), (0, 0.107)], 18)  # fmt: skip
    grip = lay_down(grip, cut + 0.012, r)
    ferrule = lay_down(cylinder(0.0088, 0.012, 16), cut + 0.008, r)
    tip = box(0.006, 0.5 * wide, 0.0065).move(x=-0.5 * long + 0.01)
    return shape(
        [
            (blade, hatch),
            (tip, surfaces.plain((120, 124, 130))),
            (grip, look.surface(color, "wood")),
            (ferrule, surfaces.brushed_metal(look.rng, (200, 180, 120))),
        ],
        [
            hull_part(blade.vertices[blade.vertices[:, 0] < cut + 0.001]),
            hull_of(tip),
            flat_foot(grip.vertices, 0.1),
        ],
    )


@category("chisel", size=(0.25, 0.03, 0.03), mass=0.16, material="metal", aliases=("wood chisel",
          "carving chisel", "gouge", "cold chisel", "spokeshave", "quilling tool"),
          themes=("workbench",), colors=("wooden", "red"), state="lying flat")  # fmt: skip
def chisel(look: Look) -> Shape:
    """A wood chisel lying flat: a bevelled blade on the left and a striking handle."""
    wide, long = look.between(0.012, 0.03), look.between(0.21, 0.26)
    color = look.color("wooden", "red", "yellow", "blue", "black", "orange", "green")
    blade = prism(np.array([(-0.5 * long, -wide / 2), (-0.02, -wide / 2), (0.002, -0.005),
                            (0.002, 0.005), (-0.02, wide / 2), (-0.5 * long, wide / 2)]), 0.0,
                  0.0045)  # fmt: skip
    blade = blade.bend(lambda p: np.column_stack([p[:, :2], np.where(
        (p[:, 0] < -0.499 * long) & (p[:, 2] > 0.002), 0.0006, p[:, 2])]))  # fmt: skip
    neck = tube([(-0.005, 0, 0.0052), (0.03, 0, 0.0115)], 0.0045, 8)
    r = 0.0145
    grip = lathe([(0, 0), (0.0085, 0), (0.0105, 0.01), (r, 0.05), (0.0135, 0.085), (r, 0.1),
                  (0.0135, 0.112), (0, 0.113)], 20)  # fmt: skip
    grip = lay_down(grip, 0.022, r)
    cap = lay_down(cylinder(0.0148, 0.008, 18, bevel=0.001), 0.127, 0.0148)
    blade_ = blade.bend(lambda p: np.column_stack([p[:, :2], p[:, 2] + 0.0035
                                                   * np.clip((p[:, 0] + 0.5 * long) / (0.5 * long),
                                                             0, 1)]))  # fmt: skip
    return shape([(join([blade_, neck]), tool_steel(look)), (grip, look.surface(color, "wood")),
                  (cap, surfaces.plain((120, 122, 128)))], [hull_of(blade_), hull_of(neck),
                                                            flat_foot(join([grip, cap]).vertices,
                                                                      0.1)])  # fmt: skip


@category("paint_roller", size=(0.281, 0.202, 0.0447), mass=0.25, material="plastic",
          assembled=True, aliases=("roller brush", "paint roll", "mini roller", "brayer",
          "printing roller", "lino roller"), themes=("workbench", "craft"), roles=("big",),
          colors=("red", "blue"), state="lying flat")  # fmt: skip
def paint_roller(look: Look) -> Shape:
    """A paint roller lying flat: a fleece roll on the left, a bent wire, and a handle."""
    k = look.between(0.85, 1.05)
    color = look.color("red", "blue", "green", "black", "orange", "wooden", "yellow")
    dip = look.pick([(240, 236, 226), (240, 236, 226), (90, 140, 200), (220, 90, 80),
                     (240, 200, 80), (120, 170, 110)])  # fmt: skip
    r, wide = 0.024 * k, look.between(0.15, 0.2) * k
    fleece = cylinder(r, wide, 26, bevel=0.005).turn(0, -np.pi / 2).move(-0.11 * k, -wide / 2, r)
    caps = [cylinder(0.7 * r, 0.006, 20).turn(0, -np.pi / 2).move(-0.11 * k, y, r)
            for y in (-wide / 2 - 0.003, wide / 2 - 0.003)]  # fmt: skip
    wire = tube(smooth([(-0.11 * k, wide / 2 - 0.005, r), (-0.11 * k, wide / 2 + 0.022, r),
                        (-0.075 * k, wide / 2 + 0.026, r), (-0.055 * k, 0.3 * wide, 0.9 * r),
                        (-0.03 * k, 0.02, 0.8 * r), (0.02 * k, 0, 0.68 * r),
                        (0.06 * k, 0, 0.66 * r)], 4), 0.0034 * k, 8)  # fmt: skip
    grip = lathe([(0, 0), (0.009, 0), (0.013, 0.02), (0.0155, 0.06), (0.0125, 0.1), (0.0145, 0.125),
                  (0, 0.128)], 18)  # fmt: skip
    grip = lay_down(grip.scale(k, k, k), 0.04 * k, 0.0155 * k)
    return shape(
        [
            (fleece, surfaces.spots(look.rng, dip, tint_color(dip, 0.9), 0.4)),
            (join([*caps, wire]), surfaces.plain((176, 178, 184))),
            (grip, look.surface(color, "plastic")),
        ],
        [
            flat_foot(fleece.vertices, 0.08),
            hull_of(grip),
            hull_part(wire.vertices[wire.vertices[:, 0] > -0.06 * k]),
        ],
    )


@category("putty_knife", size=(0.198, 0.051, 0.016), mass=0.1, material="wood", assembled=True,
          aliases=("scraper", "filling knife", "paint scraper", "stripping knife", "wall scraper",
          "spackle knife", "drywall knife"), themes=("workbench",), colors=("wooden", "black"),
          state="lying flat")  # fmt: skip
def putty_knife(look: Look) -> Shape:
    """A putty knife lying flat: a broad steel blade and a riveted handle."""
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
    metal = tool_steel(look)
    return shape([(blade, metal), (grip, look.surface(color, "wood")), (join(rivets), metal)],
                 [hull_of(blade), hull_of(grip)])  # fmt: skip


def _cutters(beak: list[tuple[float, float]], long: float, thick: float) -> Callable[[Look], Shape]:
    """Cutters, snips or wire strippers lying flat: two crossed levers with grips on the left."""

    def make(look: Look) -> Shape:
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
        return shape([(join(heads), tool_steel(look)), (join(grips), rubber),
                      (pivot, surfaces.plain((120, 124, 130)))], parts)  # fmt: skip

    return make


@category("socket_wrench", size=(0.201, 0.0365, 0.03), mass=0.35, material="metal", assembled=True,
          aliases=("ratchet", "ratchet wrench", "socket spanner", "ratchet spanner"),
          themes=("workbench",), colors=("silver",), state="lying flat")  # fmt: skip
def socket_wrench(look: Look) -> Shape:
    """A ratchet with a socket on its head, lying flat."""
    k = look.between(0.88, 1.05)
    color = look.color("silver", "black", "red", "blue", "silver")
    metal = surfaces.brushed_metal(look.rng, (186, 189, 194))
    z = 0.015 * k
    head = cylinder(0.0185 * k, 0.02 * k, 28, bevel=0.003).move(x=0.08 * k, z=0.005 * k)
    dial = cylinder(0.011 * k, 0.004 * k, 20).move(x=0.08 * k, z=0.0245 * k)
    neck = lay_down(cylinder(0.0065 * k, 0.09 * k, 14), -0.015 * k, z)
    grip = lay_down(lathe(np.array([(0, 0), (0.012, 0.001), (0.0145, 0.01), (0.012, 0.05),
                                 (0.0145, 0.09), (0.008, 0.1), (0, 0.1)]) * k, 18), -0.11 * k,
                                     z)  # fmt: skip
    switch = box(0.016 * k, 0.005 * k, 0.003 * k).turn(2, 0.6).move(x=0.08 * k, z=0.028 * k)
    socket = cylinder(0.0125 * k, 0.006 * k, 22).move(x=0.08 * k)
    knurl = surfaces.stripes([tint_color(color, 0.8), tint_color(color, 1.15)], 14)
    return shape([(join([head, neck, socket]), metal),
                  (join([dial, switch]), surfaces.plain(SOCKET_WRENCH_DARK)), (grip, knurl)],
                 [hull_of(head, socket), hull_of(neck), flat_foot(grip.vertices, 0.1)])  # fmt: skip


@category("pipe_wrench", size=(0.266, 0.056, 0.024), mass=0.8, material="metal", assembled=True,
          aliases=("plumber wrench", "plumber's wrench", "stillson wrench", "monkey wrench"),
          themes=("workbench",), colors=("red",), state="lying flat")  # fmt: skip
def pipe_wrench(look: Look) -> Shape:
    """A pipe wrench lying flat: a toothed hook jaw above a fixed one, and a long handle."""
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
    nut = lay_down(cylinder(0.0125 * k, 0.014 * k, 16), 0.022 * k, 0.0125 * k).move(y=0.022 * k)
    return shape([(body, look.surface(color, "plastic")), (join([hook, *teeth]), tool_steel(look)),
                  (nut, surfaces.stripes([(90, 92, 96), (150, 152, 156)], 8))],
                 [hull_of(body), hull_of(hook)])  # fmt: skip


@category("hacksaw", size=(0.32, 0.118, 0.016), mass=0.5, material="metal", assembled=True,
          aliases=("hack saw", "metal saw"), themes=("workbench",), roles=("big",),
          colors=("red", "blue"), state="lying flat")  # fmt: skip
def hacksaw(look: Look) -> Shape:
    """A hacksaw lying on its side: a frame, a thin blade and a pistol grip."""
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
    return shape([(bow, tool_steel(look)), (blade, teeth), (grip, look.surface(color, "plastic"))],
                 [hull_of(grip), box_part(0.26 * k, 0.008 * k, 0.014 * k,
                                          (0.03 * k, 0.085 * k, 0.001 * k)),
                  box_part(0.008 * k, 0.085 * k, 0.014 * k, (0.17 * k, 0.042 * k, 0.001 * k)),
                  hull_of(blade)])  # fmt: skip


@category("hex_key", size=(0.105, 0.0562, 0.0089), mass=0.03, material="metal", assembled=True,
          aliases=("allen key", "allen wrench", "hex wrench", "hex keys", "allen keys",
          "hexagon key"), themes=("workbench",), roles=("flat",), colors=("charcoal",),
          state="lying flat")  # fmt: skip
def hex_key(look: Look) -> Shape:
    """A hex key lying flat: an L-shaped, six-sided metal bar, sometimes with a T-handle."""
    k = look.between(0.8, 1.3)
    color = look.color("charcoal", "black", "silver", "silver", "gray")
    r = 0.0032 * k
    path = np.concatenate([[(-0.06 * k, 0, r)], np.column_stack([arc((0.024 * k, 0.006 * k), 0.006
                                                                     * k, -np.pi / 2, 0, 5),
                                                                 np.full(6, r)]),
                           [(0.03 * k, 0.03 * k, r)]])  # fmt: skip
    rod = tube(path, r, 6)
    rod = rod.move(z=-float(rod.bounds[0, 2]))
    pieces = [(rod, look.surface(color, "metal"))]
    high = float(rod.bounds[1, 2])
    parts = [
        box_part(0.084 * k, 1.7 * r, high, (-0.018 * k, 0, 0)),
        box_part(1.7 * r, 0.03 * k, high, (0.03 * k, 0.015 * k, 0)),
    ]
    if look.chance(0.4):
        grip = block(0.022 * k, 0.075 * k, 3.6 * r, 0.008, 0.002).move(x=0.032 * k, y=0.005 * k)
        tone = look.own_color("red", "blue", "yellow", "orange", "green")
        pieces.append((grip, surfaces.speckles(look.rng, tone, 4, 32)))
        parts.append(hull_of(grip))
    return shape(pieces, parts)


SOCKET_WRENCH_DARK = (40, 40, 43)


@category("mallet", size=(0.28, 0.103, 0.068), mass=0.45, material="wood", assembled=True,
          aliases=("rubber mallet", "wooden mallet", "wood mallet", "croquet mallet"),
          themes=("workbench",), colors=("wooden", "black"), state="lying flat")  # fmt: skip
def mallet(look: Look) -> Shape:
    """A mallet lying flat: a thick wooden or rubber head on a round handle."""
    k = look.between(0.88, 1.06)
    color = look.color("wooden", "black", "wooden", "white", "red", "tan")
    head = look.surface(color, "wood" if look.chance(0.6) else "plastic")
    handle = surfaces.wood(look.rng, look.own_color("tan", "wooden", "brown"), side=64)
    r = 0.032 * k
    if look.chance(0.5):
        top = cylinder(r, 0.1 * k, 28, bevel=0.003).turn(0, np.pi / 2).move(0.115 * k, 0.05 * k, r)
    else:
        top = block(0.06 * k, 0.11 * k, 2 * r, 0.004, 0.003).move(x=0.115 * k)
    rod = lay_down(lathe(np.array([(0, 0), (0.012, 0), (0.0145, 0.02), (0.011, 0.1), (0.0115, 0.26),
                                (0, 0.26)]) * k, 18), -0.14 * k, r)  # fmt: skip
    lean = np.arctan2(r - 0.0145 * k, 0.235 * k)
    top, rod = (
        s.move(x=-0.115 * k, z=-r).turn(1, -lean).move(x=0.115 * k, z=r) for s in (top, rod)
    )
    low = min(float(s.bounds[0, 2]) for s in (top, rod))
    top, rod = top.move(z=-low), rod.move(z=-low)
    return shape([(top, head), (rod, handle)],
                 [flat_foot(top.vertices, 0.06), hull_of(rod)])  # fmt: skip


@category("axe", size=(0.31, 0.125, 0.024), mass=0.7, material="metal", assembled=True,
          aliases=("hatchet", "ax", "tomahawk", "small axe", "bronze axe head"),
          themes=("workbench",), colors=("wooden", "red"), state="lying flat")  # fmt: skip
def axe(look: Look) -> Shape:
    """A hatchet, lying on its side."""
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
    paint = surfaces.speckles(look.rng, look.own_color("charcoal", "red", "gray"), 5, 32)
    return shape([(grip, look.surface(color, "wood")), (head, paint), (edge, tool_steel(look))],
                 [hull_of(grip), hull_of(head)])  # fmt: skip


@category("crowbar", size=(0.32, 0.08, 0.0148), mass=0.7, material="metal", assembled=True,
          aliases=("pry bar", "crow bar", "prybar", "wrecking bar"), themes=("workbench",),
          colors=("red", "blue"), state="lying flat")  # fmt: skip
def crowbar(look: Look) -> Shape:
    """A crowbar lying on its side, with a hooked claw and a flattened end."""
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
    return shape([(bar, look.surface(color, "plastic")), (join(tips), tool_steel(look))], bits)


@category("hand_plane", size=(0.227, 0.056, 0.085), mass=1.2, material="metal", assembled=True,
          aliases=("wood plane", "block plane", "bench plane", "carpenter plane", "jack plane",
          "woodworking plane"), themes=("workbench",), colors=("wooden",))  # fmt: skip
def hand_plane(look: Look) -> Shape:
    """A woodworking plane with a sole, an iron, a front knob and a rear handle."""
    k = look.between(0.88, 1.05)
    color = look.color("wooden", "brown", "maroon", "wooden", "tan")
    wood = look.surface(color, "wood")
    metal = surfaces.brushed_metal(look.rng, look.own_color("charcoal", "gray", "blue", "black"))
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
    return shape([(join([sole, *cheeks]), metal), (frog, metal), (iron, tool_steel(look)),
                  (knob, wood), (tote, wood)],
                 [hull_of(sole), hull_of(frog), hull_of(knob), hull_of(tote),
                     hull_of(iron)])  # fmt: skip


def _rounded_ends(x: float, y: float) -> np.ndarray:
    return rectangle(x, y, 0.4 * y, 4)


@category("vise", size=(0.144, 0.203, 0.104), mass=2.2, material="metal", assembled=True,
          aliases=("vice", "bench vise", "bench vice", "table vise", "table vice"),
          themes=("workbench",), roles=("big",), colors=("blue", "red"))  # fmt: skip
def vise(look: Look) -> Shape:
    """A bench vise with a base, two jaws and a screw with a bar."""
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
    silver = tool_steel(look)
    return shape([(join([base, *lugs, body, *jaws, nose, bar]), paint),
                  (join([*plates, screw, tail, lever, *knobs]), silver)],
                 [hull_of(base), *(hull_of(s) for s in (body, *jaws, nose, bar, *lugs)),
                  hull_of(screw), hull_of(lever)])  # fmt: skip


@category("paint_tray", size=(0.27, 0.193, 0.048), mass=0.25, material="plastic", hollow=True,
          aliases=("paint roller tray", "roller tray", "painting tray"), themes=("workbench",),
          roles=("container", "big"), colors=("black",))  # fmt: skip
def paint_tray(look: Look) -> Shape:
    """An open, sloping paint tray with a film of paint in its well."""
    k = look.between(0.88, 1.05)
    x, y, h, wall = 0.28 * k, 0.2 * k, 0.05 * k, 0.004
    color = look.color("black", "charcoal", "white", "blue", "gray", "red")
    tile = look.surface(color, "plastic")
    walls = [box(x, wall, h).move(y=s * (y - wall) / 2) for s in (-1, 1)]
    walls += [box(wall, y, h).move(x=s * (x - wall) / 2) for s in (-1, 1)]
    ramp = side_view(np.array([(-0.02, 0), (0.5, 0), (0.5, 0.62 * h / x), (0.46, 0.62 * h / x)])
                     * x * [0.98, 1], y - wall)  # fmt: skip
    ribs = [box(0.0035, 0.86 * y, 0.003).turn(1, -0.24).move((0.06 + 0.06 * n) * x, 0,
                                                             (0.12 + 0.145 * n) * 0.62 * h * 0.98
                                                             + 0.001)
            for n in range(6)]  # fmt: skip
    paint = look.own_color("white", "sky", "mint", "yellow", "coral", "cream")
    pool = box(0.56 * x, y - 2 * wall, 0.004).move(x=-0.21 * x, z=0.0025)
    floor = box(x, y, 0.003)
    return shape([(join([floor, *walls, ramp, *ribs]), tile), (pool, surfaces.plain(paint))],
                 [*frame_parts(x, y, h, wall, 0.006), hull_of(ramp)])  # fmt: skip


@category("hand_saw", size=(0.415, 0.12, 0.024), mass=0.45, material="metal",
          aliases=("saw", "handsaw", "wood saw", "jeweller saw", "coping saw"),
          themes=("workbench",), roles=("flat",), colors=("wooden", "red"), state="lying flat",
          common=True)  # fmt: skip
def hand_saw(look: Look) -> Shape:
    """A hand saw lying flat, with a toothed blade and a closed grip."""
    length, tall = look.between(0.27, 0.34), look.between(0.085, 0.1)
    wood = look.surface(look.color("wooden", "red", "orange", "black", "yellow"), "plastic")
    n = 36
    x = np.linspace(-0.02, length, n)
    edge = np.column_stack([x, -0.5 * tall + 0.0045 * (np.arange(n) % 2)])
    outline = np.concatenate([edge, [(length, -0.12 * tall), (-0.02, 0.5 * tall)]])
    blade = prism(outline, 0.010, 0.0118)
    corners = [(-0.006, 0.5 * tall, 0), (-0.03, 0.62 * tall, 0), (-0.085, 0.42 * tall, 0),
               (-0.1, 0.1 * tall, 0), (-0.09, -0.42 * tall, 0), (-0.04, -0.62 * tall, 0),
               (-0.012, -0.45 * tall, 0), (-0.006, 0, 0), (-0.006, 0.45 * tall, 0)]  # fmt: skip
    grip = tube(smooth(corners, 3)[:-1], 0.0125, 10, squash=0.86, loop=True).move(z=0.011)
    cheek = block(0.03, 0.8 * tall, 0.021, 0.006, 0.004).move(x=0.004)
    bolts = [cylinder(0.005, 0.023, 12).move(0.006, s * 0.24 * tall) for s in (-1, 1)]
    keel = box(length - 0.06, 0.006, 0.01).move(x=length / 2, y=0.02 * tall)
    return shape(
        [(blade, tool_steel(look)), (join([grip, cheek]), wood),
         (join([*bolts, keel]), surfaces.brushed_metal(look.rng, (196, 170, 100)))],
        [hull_of(blade), hull_part(grip.vertices), box_part(length - 0.06, 0.006, 0.01,
         (length / 2, 0.02 * tall, 0))],
    )  # fmt: skip


@category("clamp", size=(0.115, 0.2, 0.023), mass=0.6, material="metal",
          aliases=("c-clamp", "c clamp", "g-clamp", "g clamp"), themes=("workbench",),
          roles=("flat",), colors=("red", "blue"), state="lying flat", common=True)  # fmt: skip
def clamp(look: Look) -> Shape:
    """A C-clamp lying flat, with a frame, a screw and a sliding handle."""
    x, y = look.between(0.08, 0.11), look.between(0.11, 0.16)
    frame_tile = surfaces.speckles(
        look.rng, look.color("red", "blue", "gray", "orange", "black"), 5
    )
    path = smooth([(x, 0.47 * y, 0), (0.45 * x, 0.5 * y, 0), (0, 0.36 * y, 0), (0, -0.36 * y, 0),
                   (0.45 * x, -0.5 * y, 0), (x, -0.47 * y, 0)], 4)  # fmt: skip
    frame = sweep(path, rectangle(0.016, 0.018, 0.003, 2)).move(z=0.0095)
    pad = cylinder(0.011, 0.012, 16).turn(0, np.pi / 2).move(x - 0.004, 0.45 * y, 0.011)
    nut = cylinder(0.0095, 0.03, 14).turn(0, np.pi / 2).move(x - 0.004, -0.4 * y, 0.0095)
    screw = cylinder(0.0055, 0.95 * y, 12).turn(0, -np.pi / 2).move(x - 0.004, -0.82 * y, 0.0095)
    disc = cylinder(0.012, 0.01, 18, bevel=0.002).turn(0, np.pi / 2)
    disc = disc.move(x - 0.004, 0.14 * y, 0.012)
    bar = lay_down(cylinder(0.0035, 0.07, 10), x - 0.039, 0.0095).move(y=-0.79 * y)
    metal = surfaces.stripes([(150, 152, 156), (110, 112, 116)], 24, side=96)
    corners = np.array([(dx, dy, z) for dx in (-0.007, 0.007) for dy in (-0.007, 0.007)
                        for z in (0.0006, 0.018)])  # fmt: skip
    arms = [hull_part((path[a : b + 1, None] + corners).reshape(-1, 3))
            for a, b in ((0, 8), (8, 12), (12, 20))]  # fmt: skip
    return shape(
        [(join([frame, nut]), frame_tile), (screw, metal),
         (join([pad, disc, bar]), tool_steel(look))],
        [*arms, box_part(0.012, 0.95 * y, 0.012, (x - 0.004, -0.34 * y, 0.0035)),
         box_part(0.07, 0.007, 0.012, (x - 0.004, -0.79 * y, 0.0005)),
         box_part(0.024, 0.01, 0.022, (x - 0.004, 0.135 * y, 0.0005))],
    )  # fmt: skip


GRIPS = ("red", "yellow", "blue", "orange", "green", "black", "teal", "gray", "lime", "violet")


@category("screwdriver", size=(0.2, 0.03, 0.03), mass=0.1, material="metal", aliases=("driver",
          "nut driver", "disgorger", "awl tool", "sim tray tool", "clay sculpting tool",
          "loop tool", "hook remover", "drill brace", "watchmaker screwdriver", "spring bar tool",
          "case opener"), themes=("workbench", "craft"), colors=("red", "yellow", "blue", "orange",
          "green", "black", "teal", "gray", "lime", "violet"), state="lying flat",
          common=True)  # fmt: skip
def screwdriver(look: Look) -> Shape:
    """A screwdriver lying flat, with a fluted grip, a shaft and a flat tip."""
    r, grip, shaft = look.between(0.013, 0.016), look.between(0.09, 0.105), look.between(0.09, 0.12)
    color = look.color(*GRIPS)
    flutes = surfaces.stripes([color, color, look.pick([tint_color(color, 0.6), (40, 40, 44)])], 6,
                              upright=True)  # fmt: skip
    if look.chance(0.3):
        flutes = surfaces.stack((surfaces.plain((40, 40, 44)), 1), (flutes, 3), (flutes, 1))
    handle = lathe(
        [(0, 0), (0.7 * r, 0), (r, 0.008), (r, 0.55 * grip), (0.72 * r, 0.75 * grip),
         (0.85 * r, 0.9 * grip), (0.55 * r, grip), (0, grip)],
        20,
    )  # fmt: skip
    start = -(grip + shaft) / 2
    rod = lay_down(cylinder(0.0035, shaft, 12), start + grip, r)
    tip = box(0.012, 0.008, 0.0018).move(start + grip + shaft - 0.006, 0, r - 0.0009)
    keel = box(0.6 * grip, 1.3 * r, 0.3 * r).move(x=start + 0.32 * grip)
    return shape(
        [(lay_down(handle, start, r), flutes), (rod, tool_steel(look)), (tip, tool_steel(look)),
         (keel, surfaces.plain(tint_color(color, 0.8)))],
        [box_part(0.62 * grip, 1.5 * r, 1.8 * r, (start + 0.33 * grip, 0, 0)),
         box_part(0.36 * grip, 1.3 * r, 1.4 * r, (start + 0.82 * grip, 0, 0.25 * r)),
         box_part(shaft, 0.007, 0.007, (start + grip + shaft / 2, 0, r - 0.0035))],
    )  # fmt: skip


@category("hammer", size=(0.295, 0.127, 0.027), mass=0.55, material="metal", aliases=("claw hammer",
          "ball-peen hammer", "sledgehammer", "lump hammer", "geologist hammer", "rock hammer",
          "jeweller hammer"), themes=("workbench",), colors=("wooden", "red"), state="lying flat",
          common=True)  # fmt: skip
def hammer(look: Look) -> Shape:
    """A claw hammer with a steel head and a handle, lying on its side."""
    paint = look.color(
        "wooden", "wooden", "tan", "red", "blue", "black", "yellow", "orange", "green"
    )
    wood = look.surface(paint, look.pick(["oak", "plastic"]))
    if look.chance(0.4):  # rubber grip
        rubber = surfaces.plain(look.own_color("black", "charcoal", "yellow", "blue"))
        wood = np.concatenate([surfaces.fit(rubber, 64, 26), surfaces.fit(wood, 64, 38)], 1)
    metal = surfaces.brushed_metal(look.rng, look.own_color("charcoal", "gray", "silver"))
    length = look.between(0.24, 0.33)
    handle = prism(
        [(-length / 2, -0.014), (-0.02, -0.011), (length / 2, -0.011), (length / 2, 0.011),
         (-0.02, 0.011), (-length / 2, 0.014)],
        0.002, 0.024, 0.004,
    )  # fmt: skip
    head = block(0.03, 0.075, 0.026, 0.004, 0.002).move(x=length / 2, y=-0.004)
    face = (
        cylinder(0.0135, 0.022, 18, bevel=0.002).turn(0, np.pi / 2).move(length / 2, -0.032, 0.0135)
    )
    claw = sweep(
        [(length / 2, 0.03, 0.013), (length / 2 - 0.006, 0.055, 0.013),
         (length / 2 - 0.02, 0.074, 0.013)],
        rectangle(0.022, 0.01, 0.002, 2), [1.0, 0.85, 0.45],
    )  # fmt: skip
    return shape(
        [(handle, wood), (head, metal), (face, metal), (claw, metal)],
        [box_part(length, 0.024, 0.024), box_part(0.03, 0.075, 0.026, (length / 2, -0.004, 0)),
         box_part(0.024, 0.022, 0.026, (length / 2, -0.043, 0)), hull_of(claw)],
    )  # fmt: skip


@category("wrench", size=(0.195, 0.036, 0.009), mass=0.21, material="metal",
          aliases=("spanner", "chain tool", "chain breaker", "spoke key"), themes=("workbench",),
          roles=("flat",), colors=("silver",), state="lying flat", common=True)  # fmt: skip
def wrench(look: Look) -> Shape:
    """A combination wrench lying flat, with a ring at one end and an open jaw at the other."""
    hue = look.color("silver", "gray", "charcoal", "bronze", "red", "blue", spread=10)
    metal, length = surfaces.brushed_metal(look.rng, hue), look.between(0.14, 0.22)
    if look.chance(0.4):
        metal = surfaces.spots(look.rng, hue, (128, 84, 56), look.between(0.03, 0.14))
    shaft = prism(
        [(-length / 2 + 0.02, -0.006), (length / 2 - 0.02, -0.007), (length / 2 - 0.02, 0.007),
         (-length / 2 + 0.02, 0.006)],
        0.001, 0.0065, 0.001,
    )  # fmt: skip
    ring = torus(0.0125, 0.0042, 24, 8).scale(1, 1, 1.1).move(-length / 2 + 0.012, 0, 0.0046)
    x = length / 2 - 0.004
    jaw = [
        prism([(x - 0.024, 0.0), (x - 0.012, s * 0.005), (x + 0.014, s * 0.007),
               (x + 0.01, s * 0.017), (x - 0.012, s * 0.018)][:: s], 0, 0.008)
        for s in (-1, 1)
    ]  # fmt: skip
    return shape(
        [(shaft, metal), (ring, metal), (join(jaw), metal)],
        [box_part(length - 0.04, 0.013, 0.0065),
         cylinder_part(0.0166, 0.0088, (-length / 2 + 0.012, 0, 0)), *[hull_of(j) for j in jaw]],
    )  # fmt: skip


@category("pliers", size=(0.166, 0.066, 0.0155), mass=0.2, material="metal", aliases=("plier",
          "pincers", "mole grips", "tongue-and-groove pliers", "rivet gun", "tile nipper",
          "eyelet pliers", "vise grips", "locking pliers", "mole grip", "hole punch pliers",
          "extraction forceps", "dental forceps"), themes=("workbench", "craft"), colors=("red",
          "yellow", "blue", "orange", "green", "black", "teal", "gray", "lime", "violet"),
          state="lying flat", common=True)  # fmt: skip
def pliers(look: Look) -> Shape:
    """Pliers with coloured grips, lying flat."""
    grip = surfaces.speckles(look.rng, look.color(*GRIPS), 5)
    metal = surfaces.brushed_metal(
        look.rng, look.pick([(120, 124, 130), (70, 72, 76), (176, 178, 182)])
    )
    reach, gape = look.between(0.045, 0.075), look.between(0.85, 1.15)
    handles = [
        tube([(0.0, s * 0.005, 0.007), (-0.035, s * 0.02 * gape, 0.007),
              (-0.1, s * 0.026 * gape, 0.007)],
             [0.0055, 0.007, 0.0065], 10)
        for s in (-1, 1)
    ]  # fmt: skip
    jaws = [
        prism([(0.0, 0.0), (reach, s * 0.0006), (reach, s * 0.005), (0.02, s * 0.011),
               (-0.004, s * 0.011)][::s], 0.001, 0.013)
        for s in (-1, 1)
    ]  # fmt: skip
    pivot = cylinder(0.009, 0.0155, 18, bevel=0.001).move(x=0.006)
    return shape(
        [(join(handles), grip), (join(jaws), metal), (pivot, tool_steel(look))],
        [*[hull_of(h) for h in handles], box_part(reach, 0.018, 0.013, (reach / 2, 0, 0.0005))],
    )


@category("utility_knife", size=(0.163, 0.026, 0.0175), mass=0.08, material="plastic",
          aliases=("box cutter", "craft knife", "cutter", "glass cutter", "stanley knife",
          "die cutter"), themes=("workbench", "craft"), roles=("flat",), colors=("yellow", "red"),
          state="lying flat", common=True)  # fmt: skip
def utility_knife(look: Look) -> Shape:
    """A box cutter lying flat with its blade out."""
    color = look.color("yellow", "red", "orange", "blue", "black", "lime", "teal", "silver")
    body = prism(
        [(-0.075, -0.011), (0.045, -0.013), (0.062, -0.006), (0.062, 0.006), (-0.07, 0.013)],
        0, 0.014, 0.003,
    )  # fmt: skip
    slider = block(0.018, 0.009, 0.004, 0.002).move(x=0.01, z=0.0135)
    blade = prism(
        [(0.058, -0.004), (0.088, -0.004), (0.078, 0.0045), (0.058, 0.0045)], 0.006, 0.008
    )
    return shape(
        [(body, surfaces.speckles(look.rng, color, 5)), (slider, surfaces.plain((44, 44, 48))),
         (blade, tool_steel(look))],
        [hull_of(body), hull_of(blade)],
    )  # fmt: skip


@category("whetstone", size=(0.192, 0.072, 0.0341), mass=0.7, material="stone", aliases=("oilstone",
          "sharpening stone", "honing stone", "grindstone", "whet stone", "water stone"),
          themes=("workbench", "kitchen"), roles=("flat",), colors=("gray",))  # fmt: skip
def whetstone(look: Look) -> Shape:
    """A sharpening stone with two grits on a wooden or rubber base."""
    color = look.color("gray", "terracotta", "white", "charcoal", "sage")
    k = look.between(0.85, 1.1)
    low = at_box(0.17, 0.06, 0.012, (0, 0, 0.012))
    top = at_box(0.17, 0.06, 0.012, (0, 0, 0.0235))
    foot = block(0.2, 0.075, 0.016, 0.006, 0.002)
    wood = surfaces.wood(look.rng, (200, 164, 112)) if look.chance(0.5) else plain((60, 62, 66))
    return put_down([(top, surfaces.spots(look.rng, color, tint_color(color, 0.85), 0.3)),
                     (low, surfaces.speckles(look.rng, tint_color(color, 0.6), 6)), (foot, wood)],
                    foot, join([low, top]), factor=k)  # fmt: skip


@category("awl", size=(0.162, 0.0344, 0.0331), mass=0.06, material="wood", aliases=("bradawl",
          "scratch awl", "scribe", "scriber", "seam ripper", "gimlet", "bodkin"),
          themes=("workbench",), colors=("wooden",))  # fmt: skip
def awl(look: Look) -> Shape:
    """An awl lying flat: a thin spike in a round handle."""
    color = look.color("wooden", "red", "brown", "black", "tan")
    k = look.between(0.85, 1.2)
    handle = lies(standing((0.006, 0), (0.0145, 0.012), (0.0165, 0.03), (0.011, 0.06),
                           (0.008, 0.07), sides=18), -0.07, 0, 0.0155)  # fmt: skip
    collar = drum(0.0078, 0.012, (-0.002, 0, 0.0155), 0, sides=14)
    spike = straight((0.008, 0, 0.0155), (0.085, 0, 0.0155), [0.0034, 0.0004], 10)
    spike = spike.bend(lambda p: np.column_stack([p[:, :2], p[:, 2] - 0.013
                                                  * np.clip((p[:, 0] - 0.008) / 0.077, 0,
                                                            1)]))  # fmt: skip
    return put_down([(handle, look.surface(color, "wood")), (collar, steel(look, BRASS_TONE)),
                     (spike, steel(look))], handle, spike, factor=k, foot=0.25)  # fmt: skip


@category("centre_punch", size=(0.122, 0.0138, 0.0132), mass=0.08, material="metal",
          aliases=("center punch", "nail punch", "nail set", "pin punch", "metal punch",
          "leather punch"), themes=("workbench",), colors=("silver",))  # fmt: skip
def centre_punch(look: Look) -> Shape:
    """A steel punch with a knurled middle, lying flat."""
    color = look.color("silver", "charcoal", "black", "bronze")
    k = look.between(0.85, 1.2)
    bar_ = lies(standing((0.004, 0), (0.0065, 0.004), (0.0065, 0.08), (0.0022, 0.115),
                         (0.0008, 0.12), sides=14), -0.06, 0, 0.0062)  # fmt: skip
    grip = drum(0.0068, 0.045, (-0.036, 0, 0.0062), 0, sides=16)
    knurl = surfaces.grid((70, 72, 76), (140, 144, 150), 14, 14, 64, 2)
    return put_down([(bar_, steel(look, color)), (grip, knurl)], bar_, grip, factor=k, foot=0.35)


@category("pocket_knife", size=(0.157, 0.0544, 0.0161), mass=0.09, material="metal",
          aliases=("swiss army knife", "penknife", "pen knife", "folding knife", "jackknife",
          "camping knife"), themes=("workbench",), colors=("red",))  # fmt: skip
def pocket_knife(look: Look) -> Shape:
    """A pocket knife lying flat with its blade and tools half open."""
    color = look.color("red", "red", "black", "wooden", "green", "blue")
    k = look.between(0.85, 1.15)
    scales = [plate(rectangle(0.09, 0.026, 0.0125, 6), 0.004, at=(0, 0, z), bevel=0.001)
              for z in (0.0, 0.012)]  # fmt: skip
    liner = plate(rectangle(0.087, 0.024, 0.0118, 6), 0.009, at=(0, 0, 0.0035))
    blade = plate([(0, -0.0065), (0.055, -0.006), (0.068, 0.002), (0.05, 0.0065), (0, 0.0065)],
                  0.002, at=(0, 0, 0.0035))  # fmt: skip
    blade = blade.turn(2, look.between(0.3, 0.9)).move(0.037, 0.004, 0)
    short = plate(
        [(0, -0.005), (0.03, -0.004), (0.036, 0.003), (0, 0.005)], 0.002, at=(0, 0, 0.0085)
    ).turn(2, np.pi - 0.7)
    short = short.move(-0.037, 0.004, 0)
    screw = rod([(-0.005, 0.01, 0.008), (-0.012, 0.03, 0.008), (-0.004, 0.034, 0.008),
                 (-0.012, 0.038, 0.008)], 0.0014, 6)  # fmt: skip
    cross = [
        at_box(0.012, 0.0035, 0.0008, (0.015, 0, 0.0156)),
        at_box(0.0035, 0.012, 0.0008, (0.015, 0, 0.0156)),
    ]
    ring = torus(0.005, 0.0009, 14, 5).move(-0.049, 0, 0.008)
    return put_down([(join(scales), look.surface(color, "plastic")),
                     (join([liner, blade, short, screw, ring]), steel(look)),
                     (join(cross), plain((236, 236, 240)))], join([*scales, liner]), blade, short,
                    factor=k)  # fmt: skip


@category("multitool", size=(0.191, 0.0737, 0.0155), mass=0.22, material="metal",
          aliases=("multi-tool", "multi tool", "bike multi-tool", "leatherman", "pocket tool"),
          themes=("workbench",), colors=("silver", "black"))  # fmt: skip
def multitool(look: Look) -> Shape:
    """An open multi-tool lying flat: plier jaws between two handles, and an unfolded blade."""
    color = look.color("silver", "black", "charcoal", "green")
    k = look.between(0.85, 1.15)
    handles = [plate(rectangle(0.1, 0.016, 0.006), 0.015, at=(-0.048, 0, 0),
                     bevel=0.002).turn(2, s * 0.24).move(0.0, s * -0.006, 0)
               for s in (-1, 1)]  # fmt: skip
    jaws = [plate([(0, 0), (0.005, s * 0.011), (0.03, s * 0.009), (0.058, s * 0.002), (0.058, 0)],
                  0.008, at=(0, s * 0.001, 0.0035)) for s in (-1, 1)]  # fmt: skip
    pivot = drum(0.006, 0.014, (0.004, 0, 0.001))
    blade = (plate([(0, -0.005), (0.05, -0.004), (0.06, 0.002), (0, 0.005)], 0.002,
                   at=(0, 0, 0.006)).turn(2, 2.2).move(-0.09, -0.03, 0))  # fmt: skip
    return put_down([(join(handles), look.surface(color, "metal")),
                     (join([*jaws, blade]), steel(look)), (pivot, plain((80, 82, 88)))], *handles,
                    join(jaws), blade, factor=k)  # fmt: skip


@category("tyre_lever", size=(0.131, 0.0186, 0.00932), mass=0.02, material="plastic",
          aliases=("tire lever", "bike lever"), themes=("workbench",), roles=("flat",),
          colors=("blue", "yellow"))  # fmt: skip
def tyre_lever(look: Look) -> Shape:
    """A tyre lever with a hooked tip, lying flat."""
    color = look.color("blue", "yellow", "red", "black", "orange", "green")
    k = look.between(0.85, 1.15)
    rim = [(-0.06, -0.009), (0.03, -0.007), (0.055, -0.005), (0.06, 0), (0.055, 0.005),
           (0.03, 0.007), (-0.06, 0.009), (-0.066, 0)]  # fmt: skip
    body, tip = plate(rim, 0.006, bevel=0.001), at_box(0.008, 0.01, 0.009, (0.055, 0, 0))
    rib = at_box(0.07, 0.004, 0.008, (-0.02, 0, 0))
    return put_down(
        [(join([body, tip]), plain(color)), (rib, plain(tint_color(color, 0.8)))], body, factor=k
    )


@category("car_jack", size=(0.28, 0.07, 0.174), mass=2.5, material="metal", assembled=True,
          aliases=("scissor jack", "bottle jack"), themes=("workbench",),
          colors=("red",))  # fmt: skip
@from_pieces()
def car_jack(look: Look) -> Pieces:
    """A half-raised scissor jack: a base, a diamond of arms and a screw with a crank."""
    tile = metal(look, "red", "black", "yellow", "charcoal")
    foot = at_block(0.12, 0.07, 0.008, 0.006)
    left, right, low, high = (-0.11, 0.085), (0.11, 0.085), (0.0, 0.012), (0.0, 0.16)
    arms = []
    for a, b in ((low, left), (low, right), (left, high), (right, high)):
        arms.append(straight((a[0], -0.018, a[1]), (b[0], -0.018, b[1]), 0.01, 4))
        arms.append(straight((a[0], 0.018, a[1]), (b[0], 0.018, b[1]), 0.01, 4))
    screw = straight((-0.13, 0, 0.085), (0.15, 0, 0.085), 0.0065, 10)
    nuts = [at_box(0.024, 0.05, 0.026, (x, 0, 0.072)) for x in (-0.11, 0.11)]
    saddle = at_block(0.06, 0.05, 0.012, 0.004, (0, 0, 0.162))
    return [(foot, tile), (join(arms), tile), (join(nuts), tile), (saddle, tile),
            (screw, shine(look))]  # fmt: skip


@category("foot_pump", size=(0.291, 0.185, 0.113), mass=1.5, material="metal", assembled=True,
          themes=("workbench",), colors=("red",))  # fmt: skip
@from_pieces()
def foot_pump(look: Look) -> Pieces:
    """A foot pump: a barrel between steel arms, a pedal, a gauge and a hose."""
    tile = metal(look, "red", "blue", "black", "yellow")
    base = [at_box(0.24, 0.012, 0.012, (0, s * 0.05, 0)) for s in (-1, 1)]
    cross = [at_box(0.016, 0.11, 0.012, (x, 0, 0)) for x in (-0.11, 0.11)]
    barrel = straight((-0.06, 0, 0.035), (0.075, 0, 0.075), 0.026, 18)
    arms = [straight((-0.11, s * 0.036, 0.012), (0.09, s * 0.036, 0.1), 0.006, 6) for s in (-1, 1)]
    pedal = at_block(0.05, 0.1, 0.012, 0.006, (0.09, 0, 0.096))
    dial = disc(0.02, 0.012, (-0.08, 0, 0.04))
    hose = rod([(-0.09, 0, 0.03), (-0.15, 0.03, 0.008), (-0.13, 0.1, 0.006), (-0.02, 0.115, 0.006),
                (0.08, 0.1, 0.006)], 0.0055, 8, 6)  # fmt: skip
    return [(join([*base]), tile), (join(cross), tile), (barrel, shine(look, "silver", "charcoal")),
            (join(arms), tile), (pedal, BLACK), (dial, surfaces.plain((240, 238, 232))),
            (hose, BLACK)]  # fmt: skip


CATEGORIES = (
    Category("wire_cutters", _cutters([(-0.006, 0.009), (0.004, -0.004), (0.038, -0.0005),
             (0.04, 0.003), (0.024, 0.013), (0.006, 0.014)], 0.105, 0.012),
             size=(0.143, 0.064, 0.0135), mass=0.18, material="metal", assembled=True,
             aliases=("wire cutter", "diagonal cutter", "side cutter", "diagonal pliers", "nippers",
             "side cutters", "snips", "bolt cutter", "tile cutter", "litter picker",
             "hot wire cutter"), themes=("workbench",), colors=("red", "blue"), state="lying flat"),
    Category("tin_snips", _cutters([(-0.006, 0.01), (0.004, -0.004), (0.075, -0.001),
             (0.078, 0.001), (0.06, 0.011), (0.02, 0.016)], 0.14, 0.014),
             size=(0.216, 0.064, 0.0155), mass=0.35, material="metal", assembled=True,
             aliases=("tin snip", "metal shears", "metal snips", "aviation snips"),
             themes=("workbench",), colors=("red",), state="lying flat"),
    Category("wire_stripper", _cutters([(-0.006, 0.009), (0.004, -0.004), (0.02, -0.001),
             (0.026, 0.004), (0.034, -0.001), (0.066, -0.0005), (0.068, 0.006), (0.03, 0.013),
             (0.006, 0.014)], 0.115, 0.01), size=(0.181, 0.064, 0.0115), mass=0.15,
             material="metal", assembled=True, aliases=("wire strippers", "crimping tool",
             "crimper", "cable stripper", "crimping pliers"), themes=("workbench",),
             colors=("red", "yellow"), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
