"""What pets wear, chew and swim in."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of, ring_parts
from ...build.recipes import ball, leather, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, join, lathe, prism, torus, tube
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

STEEL = (196, 200, 206)


def dog_bone(look: Look) -> Shape:
    """A bone with two knobs at each end."""
    color = look.color("ivory", "white", "tan", "beige", "brown")
    k = look.between(0.85, 1.25)
    shaft = straight((-0.045, 0, 0.0125), (0.045, 0, 0.0125), 0.0105, 14)
    knobs = [ball(0.034, 0.034, 0.03, (sx * 0.05, sy * 0.0135, 0.0135), 14) for sx in (-1, 1)
             for sy in (-1, 1)]  # fmt: skip
    skin = textures.speckles(look.rng, color, 7)
    return put_down(
        [(join([shaft, *knobs]), skin)], shaft, join(knobs[:2]), join(knobs[2:]), factor=k
    )


def collar(look: Look) -> Shape:
    """A pet's collar lying in a ring: a strap, a buckle, a tag."""
    color = look.color("red", "blue", "brown", "black", "pink", "green", "teal")
    r, w = look.between(0.045, 0.062), 0.018
    strap = lathe(
        [(r - 0.0012, 0), (r + 0.0012, 0), (r + 0.0012, w), (r - 0.0012, w)], 40, loop=True
    )
    studs = [ball(0.006, 0.006, 0.006, ((r + 0.001) * np.cos(a), (r + 0.001) * np.sin(a), w / 2), 8)
             for a in 2 * np.pi * np.arange(14) / 14]  # fmt: skip
    buckle = box(0.02, 0.004, w + 0.006).move(0, r + 0.001, 0)
    ring = torus(0.005, 0.0011, 14, 6).move(0, -r - 0.006, 0.004)
    tag = cylinder(0.012, 0.0018, 22).move(0, -r - 0.02, 0.0005)
    metal = textures.plain((206, 172, 96) if look.chance(0.5) else STEEL)
    wall = ring_parts([(r + 0.0015, 0), (r + 0.0015, w)], [(r - 0.0015, w), (r - 0.0015, 0)], 12)
    return shape([(strap, leather(look.rng, color)), (join([*studs, buckle, ring, tag]), metal)],
                 [*wall, hull_of(tag)])  # fmt: skip


def leash(look: Look) -> Shape:
    """A dog's lead coiled on the table, its clip at one end, its loop at the other."""
    color = look.color("red", "blue", "black", "brown", "green", "orange", "pink")
    a = np.linspace(0, 2 * np.pi * 3, 80)
    r = 0.045 + 0.009 * a / (2 * np.pi)
    coil = tube(
        np.column_stack([r * np.cos(a), r * np.sin(a), np.full(80, 0.0035) + 0.0005 * a]), 0.0038, 7
    )
    end = np.array([r[-1], 0, 0.0035 + 0.0005 * a[-1]])
    clip = [
        straight(tuple(end), tuple(end + np.array([0.004, 0.02, -0.006])), 0.0042, 8),
        torus(0.0085, 0.002, 16, 6).scale(1, 1.5, 1).move(end[0] + 0.004, end[1] + 0.03, 0.0045),
    ]
    loop = rod(
        [
            (0.045, 0, 0.0036),
            (0.03, -0.03, 0.0036),
            (-0.01, -0.028, 0.0036),
            (-0.012, 0.006, 0.0036),
            (0.02, 0.012, 0.0036),
            (0.044, 0.002, 0.0036),
        ],
        0.0036,
        7,
    )
    return put_down([(join([coil, loop]), textures.fabric(look.rng, color)),
                    (join(clip), textures.plain((206, 208, 212)))], coil, join(clip),
                   factor=look.between(0.9, 1.15))  # fmt: skip


def toy_mouse(look: Look) -> Shape:
    """A cat's toy mouse of cloth, its tail a cord."""
    color = look.color("gray", "white", "pink", "blue", "brown", "red")
    k = look.between(0.9, 1.3)
    body = ball(0.07, 0.036, 0.034, (0, 0, 0.0155), 18)
    head = lathe([(0, 0), (0.0155, 0), (0.012, 0.014), (0.003, 0.026), (0, 0.027)], 14)
    head = head.turn(1, -np.pi / 2).move(-0.022, 0, 0.0155)
    ears = [ball(0.005, 0.02, 0.02, (-0.018, s * 0.012, 0.032), 10) for s in (-1, 1)]
    eyes = [ball(0.004, 0.004, 0.004, (-0.036, s * 0.0075, 0.021), 8) for s in (-1, 1)]
    nose = ball(0.006, 0.006, 0.006, (-0.0495, 0, 0.0155), 8)
    tail = rod(
        [(0.034, 0, 0.014), (0.055, 0.006, 0.006), (0.08, -0.006, 0.002), (0.1, 0.004, 0.002)],
        0.0015,
        6,
    )
    fur = textures.scratches(look.rng, color, tint_color(color, 0.8), 90)
    return put_down(
        [
            (join([body, head]), fur),
            (join([*ears, tail, nose]), textures.plain((236, 160, 170))),
            (join(eyes), textures.plain((30, 30, 32))),
        ],
        body,
        head,
        tail,
        factor=k,
    )


def fish_bowl(look: Look) -> Shape:
    """A fish bowl: water between two glass rings over gravel, goldfish and a weed."""
    color = look.color("sky", "blue", "teal", "cyan", "turquoise")
    r = look.between(0.07, 0.09)
    water = lathe([(0, 0), (0.55 * r, 0), (0.9 * r, 0.4 * r), (r, 0.85 * r), (0.9 * r, 1.3 * r),
                   (0, 1.3 * r)], 30)  # fmt: skip
    neck = lathe(
        [
            (0.86 * r, 1.28 * r),
            (0.9 * r, 1.28 * r),
            (0.72 * r, 1.55 * r),
            (0.8 * r, 1.66 * r),
            (0.75 * r, 1.67 * r),
            (0.67 * r, 1.55 * r),
        ],
        30,
        loop=True,
    )
    sides: list[Solid] = []
    tails: list[Solid] = []
    for a, z in ((-1.9, 0.85), (-0.7, 1.0), (1.4, 0.7)):
        fish = ball(0.034, 0.012, 0.02, (0, 0, 0), 12)
        tail = prism([(0.012, 0), (0.026, -0.011), (0.026, 0.011)], -0.003, 0.003).turn(
            0, np.pi / 2
        )
        for solid, group in ((fish, sides), (tail, tails)):
            group.append(
                solid.turn(2, a + np.pi / 2).move(0.98 * r * np.cos(a), 0.98 * r * np.sin(a), z * r)
            )
    top = [ball(0.036, 0.018, 0.006, (0.2 * r, -0.25 * r, 1.3 * r), 12)]
    gravel = lathe([(0, 0.0), (0.56 * r, 0.0), (0.72 * r, 0.16 * r), (0, 0.17 * r)], 28)
    gravel = gravel.scale(1.02, 1.02, 1)
    pale = tint_color(color, 1.45)
    return put_down([(water, textures.gradient(tint_color(color, 1.1), pale, look.rng)),
                    (neck, textures.plain((226, 238, 244))),
                    (join([*sides, *tails, *top]), textures.plain((240, 130, 40))),
                    (gravel, textures.spots(look.rng, (226, 206, 170), (150, 120, 90), 0.3))],
                   water, neck)  # fmt: skip


CATEGORIES = (
    Category("dog_bone", dog_bone, (0.14, 0.064, 0.03), 0.06, ("bone", "chew bone", "dog treat",
                 "dog biscuit", "chew toy", "rawhide chew", "dog chew", "rawhide", "treat"),
             ("living",), (), ("ivory",), state="lying"),
    Category("dog_collar", collar, (0.113, 0.145, 0.024), 0.05, ("collar", "cat collar",
                 "pet collar", "dog harness", "harness", "cat harness"),
             ("living",), (), ("red", "blue"), state="lying"),
    Category("leash", leash, (0.15, 0.16, 0.018), 0.12, ("dog leash", "dog lead", "pet leash"),
             ("living",), (), ("red", "blue"), state="lying coiled"),
    Category("cat_toy", toy_mouse, (0.168, 0.0472, 0.046), 0.02, ("toy mouse", "cat toy mouse",
             "pet toy", "cloth mouse", "pet mouse"), ("living", "toys"), (), ("gray",)),
    Category("fish_bowl", fish_bowl, (0.165, 0.165, 0.135), 2.0, ("fishbowl", "goldfish bowl"),
             ("living",), ("round",),
             ("sky",)),
)  # fmt: skip
"""The module's categories."""
