"""Chocolate fountains, floss machines and small fridges."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.forms import facing, lobe
from ...build.outlines import rectangle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from .electrics import turn_knob

STEEL: RGB = (190, 194, 200)


INK: RGB = (34, 36, 40)


def mini_fridge(look: Look) -> Shape:
    """A small table-top fridge: a rounded cabinet, a door with a handle, a badge."""
    k, color = (
        look.between(0.85, 1.05),
        look.color("white", "pink", "mint", "red", "black", "sky", "cream"),
    )
    x, y, h = 0.23 * k, 0.24 * k, 0.32 * k
    body, door = (
        block(x, y, h, 0.03 * k, 0.01).move(z=0.008),
        facing(prism(rectangle(x, h, 0.03 * k), 0, 0.03 * k, 0.0)).move(y=-y / 2, z=0.008 + h / 2),
    )
    grip = [box(0.012, 0.02, 0.1 * k).move(0.4 * x, -y / 2 - 0.045 * k, 0.45 * h)]
    feet = [
        cylinder(0.012, 0.01, 12).move(i * 0.38 * x, j * 0.38 * y, 0)
        for i in (-1, 1)
        for j in (-1, 1)
    ]
    badge = box(0.07 * k, 0.001, 0.014).move(-0.2 * x, -y / 2 - 0.0305 * k, 0.88 * h)
    gap = box(0.98 * x, 0.003, 0.97 * h).move(0, -y / 2 + 0.001, 0.015)
    hold = tube(
        [(-0.06 * k, 0, h), (-0.05 * k, 0, h + 0.02), (0.05 * k, 0, h + 0.02), (0.06 * k, 0, h)],
        0.007,
        8,
    )
    tile, pale = (
        look.surface(color, "plastic"),
        textures.speckles(look.rng, tint_color(color, 1.2), 2),
    )
    return shape([(body, tile), (door, pale), (gap, textures.plain((80, 84, 88))),
                  (join([*grip, badge, hold]), textures.brushed_metal(look.rng, STEEL)),
                  (join(feet), textures.plain(INK))], [hull_of(body, *feet), hull_of(door),
                                                       hull_of(hold)])  # fmt: skip


def chocolate_fountain(look: Look) -> Shape:
    """A chocolate fountain: three tiers of flowing chocolate above a steel bowl on a base."""
    k, color = look.between(0.88, 1.08), look.color("silver", "black", "red", "gold")
    base = lathe([(0, 0), (0.09, 0), (0.1, 0.012), (0.085, 0.07), (0, 0.07)], 30)
    bowl = lathe(
        [
            (0, 0.07),
            (0.06, 0.07),
            (0.115, 0.1),
            (0.118, 0.108),
            (0.108, 0.106),
            (0.06, 0.082),
            (0, 0.082),
        ],
        34,
    )
    pool = cylinder(0.1, 0.002, 30).move(z=0.098)
    tiers = []
    for z, r in ((0.16, 0.075), (0.22, 0.056), (0.275, 0.038)):
        skirt = lathe(
            [
                (0, z - 0.04),
                (0.92 * r, z - 0.045),
                (1.03 * r, z - 0.006),
                (r, z + 0.004),
                (0.3 * r, z + 0.016),
                (0, z + 0.016),
            ],
            30,
        )
        tiers.append(lobe(skirt, 14, 0.05))
    tower = cylinder(0.018, 0.21, 16).move(z=0.09)
    crown = lathe([(0, 0.29), (0.02, 0.29), (0.024, 0.31), (0.008, 0.325), (0, 0.326)], 18)
    choc = textures.stripes([(92, 54, 34), (112, 68, 44)], 16, upright=True, side=64)
    made = [(base,
             look.surface(color, "steel" if color[0] > 150 and color[2] > 120 else "plastic")),
             (bowl, textures.brushed_metal(look.rng, STEEL)),
            (join([pool, *tiers, tower, crown]), choc), (turn_knob(0.014, 0, -0.092, 0.036),
                                                         textures.plain((90, 94, 98)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(
        made,
        [hull_of(made[0][0]), hull_of(made[1][0]), *[hull_of(t.scale(k, k, k)) for t in tiers]],
    )


def candyfloss_machine(look: Look) -> Shape:
    """A candyfloss machine: a wide bowl on a base, a spinner, pink floss on a stick."""
    k, color = look.between(0.88, 1.05), look.color("red", "pink", "sky", "white")
    base = lathe([(0, 0), (0.1, 0), (0.095, 0.02), (0.08, 0.1), (0, 0.1)], 28)
    bowl = lathe(
        [
            (0, 0.1),
            (0.1, 0.1),
            (0.14, 0.15),
            (0.142, 0.17),
            (0.134, 0.17),
            (0.1, 0.112),
            (0, 0.112),
        ],
        36,
    )
    spin = lathe([(0, 0.11), (0.03, 0.11), (0.028, 0.14), (0.012, 0.146), (0, 0.146)], 20)
    floss = [
        ellipsoid(0.06, 0.056, 0.05, 10, 7).move(
            0.055 * np.cos(a), 0.055 * np.sin(a), 0.165 + 0.016 * (n % 3)
        )
        for n, a in enumerate(np.arange(8) * 0.8)
    ]
    made = [(base, look.surface(color, "plastic")),
            (bowl, textures.speckles(look.rng, tint_color(color, 1.4), 3)),
            (spin, textures.brushed_metal(look.rng, STEEL)),
            (join(floss), textures.scratches(look.rng, (244, 178, 206), (252, 212, 228), 200)),
            (turn_knob(0.014, 0, -0.086, 0.05), textures.plain((250, 250, 246)))]  # fmt: skip
    made = [(s.scale(k, k, k), t) for s, t in made]
    return shape(made, [hull_of(made[0][0]), hull_of(made[1][0]), hull_of(made[3][0])])


_K = ("kitchen",)


_B = ("big",)

CATEGORIES = (
    Category("mini_fridge", mini_fridge, (0.211, 0.271, 0.32), 2.5, ("small fridge", "desk fridge",
        "fridge", "tabletop fridge", "refrigerator", "drinks fridge", "minifridge",
             "toy fridge"), _K, _B, ("white",)),
    Category("chocolate_fountain", chocolate_fountain, (0.228, 0.229, 0.316), 1.5,
             ("chocolate fondue fountain", "fondue fountain"), _K, ("round", "tall"), ("silver",)),
    Category("candyfloss_machine", candyfloss_machine, (0.273, 0.273, 0.213), 1.4,
             ("candy floss machine", "cotton candy machine", "cotton candy maker",
              "candyfloss maker"), _K,
             ("big", "round"), ("red",)),
)  # fmt: skip
"""The module's categories."""
