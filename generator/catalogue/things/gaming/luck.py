"""Treasure, lucky charms and smoking things."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, hull_of
from ...build.outlines import arc, rectangle
from ...build.settled import limb, settle
from ...build.shape import Shape, shape
from ...build.solids import (
    block,
    box,
    cylinder,
    join,
    lathe,
    loft,
    prism,
    torus,
)
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def _bar(palette: tuple[str, ...], metal: str, long: tuple[float, float]):
    """Return the shape function of a cast bar, narrower above, its worth stamped on top."""

    def make(look: Look) -> Shape:
        x = look.between(*long)
        y, h = 0.42 * x * look.between(0.9, 1.1), 0.24 * x * look.between(0.9, 1.1)
        color = look.color(*palette)
        rings = [np.column_stack([rectangle(x * s, y - x * (1 - s), 0.02 * x), np.full(20, z)])
                 for s, z in ((1.0, 0.0), (1.0, 0.06 * h), (0.88, 0.94 * h),
                              (0.86, h))]  # fmt: skip
        body = loft(np.stack(rings), rectangle(x, y, 0.02 * x))
        image = textures.fit(textures.brushed_metal(look.rng, color), 96, 192).copy()
        ink = tint_color(color, 0.6)
        prints.write(image, "999.9", 0.5, 0.36, 0.24, ink, bold=True)
        prints.write(image, look.pick(["FINE GOLD", "1 KILO",
                                       "100 g"]) if metal == "gold" else "FINE SILVER",
                     0.5, 0.7, 0.16, ink, bold=True)  # fmt: skip
        face = box(0.8 * x, y - 0.2 * x, 0.0004).move(z=h - 0.0002)
        return shape([(body, look.surface(color, metal)), (face, image)], [hull_of(body)])

    return make


def horseshoe(look: Look) -> Shape:
    """A horseshoe lying flat, nail holes along its two arms."""
    k, color = look.between(0.85, 1.15), look.color("gray", "silver", "bronze", "black", "gold")
    a = np.linspace(-0.62, np.pi + 0.62, 19)
    middle = np.column_stack([0.046 * np.cos(a), 0.054 * np.sin(a)])
    outer, inner = middle * 1.2, middle * np.array([0.78, 0.8])
    body = prism(np.concatenate([outer, inner[::-1]]) * k, 0, 0.008 * k)
    holes = [box(0.0035 * k, 0.006 * k, 0.0006).move(s * 0.043 * k, y * k, 0.0078 * k)
             for s in (-1, 1) for y in (-0.01, 0.006, 0.022)]  # fmt: skip
    metal = look.surface(color, "iron" if look.chance(0.5) else "steel")
    parts = []
    for i in range(0, 18, 3):
        ring = np.concatenate([outer[i : i + 4], inner[i : i + 4][::-1]]) * k
        parts.append(hull_of(prism(ring, 0, 0.008 * k)))
    return shape([(body, metal), (join(holes), textures.plain((24, 24, 26)))], parts)


def rabbit_foot(look: Look) -> Shape:
    """A rabbit's foot on a key chain: a furry paw, a metal cap, a ring."""
    k, color = look.between(0.9, 1.15), look.color("white", "tan", "gray", "brown", "pink")
    paw = limb([(-0.034, 0, 0), (-0.026, 0, 0), (0, 0.003, 0), (0.022, 0, 0), (0.03, 0, 0)],
               [0.002, 0.0085, 0.0098, 0.0075, 0.006], 14)  # fmt: skip
    cap = lathe([(0, 0), (0.0076, 0), (0.0076, 0.007), (0.003, 0.012), (0, 0.012)], 16)
    cap = cap.turn(1, np.pi / 2).move(x=0.027)
    links = [torus(0.0035, 0.0008, 12, 5).move(x=0.041 + 0.0055 * n, z=-0.004) for n in range(4)]
    ring = torus(0.0115, 0.001, 22, 6).move(x=0.073, z=-0.006)
    fur = textures.scratches(look.rng, color, tint_color(color, 0.82), 200)
    gold = textures.brushed_metal(look.rng, (206, 172, 90))
    return settle([(paw, fur), (join([cap, *links, ring]), gold)], 0.12, hulls=[[0], [1]]).scale(k)


def cigar_cutter(look: Look) -> Shape:
    """A guillotine cigar cutter: a plate with a hole and a finger ring at each end."""
    k, color = look.between(0.9, 1.15), look.color("silver", "black", "gold")
    plate = prism(rectangle(0.05, 0.036, 0.012), 0, 0.005).scale(k, k, 1)
    rings = [torus(0.011 * k, 0.003, 22, 7).move(s * 0.034 * k, 0, 0.003) for s in (-1, 1)]
    hole = cylinder(0.0115 * k, 0.0005, 26).move(z=0.0048)
    blade = prism(arc((0, 0), 0.0115 * k, 0.3, 2.8, 10), 0.0052, 0.0056)
    metal = look.surface(color, "steel")
    return shape([(join([plate, *rings]), metal), (hole, textures.plain((20, 20, 22))),
                  (blade, textures.plain((226, 228, 232)))], [hull_of(plate),
                      *[hull_of(r) for r in rings]])  # fmt: skip


def cigarette_packet(look: Look) -> Shape:
    """A packet of cigarettes with a flip top, closed or open with filters showing."""
    color = look.color("red", "blue", "gold", "green", "white", "navy")
    x, y, h = 0.055, look.between(0.021, 0.024), look.between(0.084, 0.09)
    image = prints.canvas(96, 150, (248, 246, 242) if sum(color) < 600 else (40, 60, 120))
    prints.polygon(image, [(0, 0), (1, 0), (1, 0.3), (0.5, 0.5), (0, 0.3)], color)
    prints.write(image, look.pick(["LUCKY", "ROYAL", "GOLD", "WEST", "PRIME"]), 0.5, 0.64, 0.12,
                 tint_color(color, 0.8), bold=True)  # fmt: skip
    prints.fill(image, 0.06, 0.8, 0.88, 0.14, (30, 30, 32))
    skin = textures.plain(
        (float(image[100, 4, 0]), float(image[100, 4, 1]), float(image[100, 4, 2]))
    )
    panel = box(x, 0.0005, h)
    if look.chance(0.5):
        pieces = [(box(x, y, h), skin), (panel.move(y=-y / 2), image), (panel.move(y=y / 2), image)]
        return shape(pieces, [box_part(x, y, h)])
    low = 0.8 * h
    lid = box(x, y, 0.2 * h).turn(0, -1.1).move(y=0.9 * y, z=low + 0.004)
    tips = [cylinder(0.0037, 0.01, 8).move((i - 3) * 0.0074, (j - 0.5) * 0.0085 - 0.001, low)
            for i in range(7) for j in range(2)]  # fmt: skip
    front = box(x, 0.0005, low)
    return shape([(box(x, y, low), skin), (front.move(y=-y / 2), image[30:]),
                  (lid, textures.plain(color)),
                  (join(tips), textures.plain((216, 150, 84)))],
                 [box_part(x, y, low), hull_of(lid), hull_of(*tips)])  # fmt: skip


def cigarette_case(look: Look) -> Shape:
    """A flat metal case with rounded corners and an engraved band, lying."""
    k, color = look.between(0.92, 1.08), look.color("silver", "gold", "black", "bronze")
    body = block(0.1 * k, 0.08 * k, 0.016, 0.01, 0.003)
    image = textures.fit(textures.brushed_metal(look.rng, color), 128, 160).copy()
    for n in range(12):
        prints.fill(image, 0, n / 12, 1, 0.012, tint_color(color, 0.75))
    prints.polygon(
        image, [(0.5, 0.3), (0.64, 0.5), (0.5, 0.7), (0.36, 0.5)], tint_color(color, 1.3)
    )
    face = box(0.084 * k, 0.064 * k, 0.0004).move(z=0.0158)
    clasp = box(0.016, 0.004, 0.006).move(y=-0.04 * k, z=0.005)
    metal = look.surface(color, "silver")
    return shape([(body, metal), (face, image), (clasp, metal)], [hull_of(body)])


CATEGORIES = (
    Category("gold_bar", _bar(("gold",), "gold", (0.1, 0.13)), (0.112, 0.0468, 0.0269), 4.0,
             ("ingot",
             "bar of gold", "bullion", "gold bullion"), ("office",), (), ("gold",)),
    Category("silver_bar", _bar(("silver",), "silver", (0.1, 0.13)), (0.114, 0.0483, 0.0282), 2.2,
             ("silver ingot", "bar of silver", "platinum bar"), ("office",), (), ("silver",)),
    Category("horseshoe", horseshoe, (0.112, 0.104, 0.00854), 0.3, ("lucky horseshoe", "horse shoe",
             "iron horseshoe", "horseshoe charm", "lucky charm"), ("living",), ("flat",), ("gray",),
             state="lying flat"),
    Category("rabbit_foot", rabbit_foot, (0.12, 0.0254, 0.017), 0.015, ("rabbit's foot",
        "lucky rabbit foot",
             "rabbits foot keychain"), ("living",), (), ("white",), state="lying"),
    Category("cigar_cutter", cigar_cutter, (0.099, 0.0373, 0.00592), 0.06, ("guillotine cutter",),
             ("living",),
             ("flat",), ("silver",), state="lying flat"),
    Category("cigarette_packet", cigarette_packet, (0.055, 0.0315, 0.0882), 0.025,
             ("pack of cigarettes",
             "packet of cigarettes", "cigarette pack", "cigarette box", "box of cigarettes",
             "cigarettes"), ("living",), (), ("red",)),
    Category("cigarette_case", cigarette_case, (0.0995, 0.0816, 0.0162), 0.12,
             ("cigar case", "metal card case",
             "card case"), ("living",), ("flat",), ("silver",), state="lying flat"),
)  # fmt: skip
"""The module's categories."""
