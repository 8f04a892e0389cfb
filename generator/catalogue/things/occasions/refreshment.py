"""Picnics: hampers, ice packs, wipes."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of
from ...build.outlines import rectangle, smooth
from ...build.recipes import pad
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, loft, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import readable_on, tint_color
from ...surfaces.look import Look


def picnic_hamper(look: Look) -> Shape:
    """A picnic hamper: a wicker box with a lid, leather straps and a handle."""
    k, color = look.between(0.88, 1.04), look.color("tan", "wooden", "brown", "bronze")
    x, y, h = 0.34 * k, 0.22 * k, 0.17 * k
    outline = rectangle(x, y, 0.02 * k)
    rings = [
        np.column_stack([outline * s, np.full(len(outline), z)]) for s, z in ((0.92, 0), (1.0, h))
    ]
    body = loft(np.stack(rings), outline)
    lid = block(1.02 * x, 1.02 * y, 0.035 * k, 0.022 * k, 0.008).move(z=h)
    weave = textures.basketwork(look.rng, color, 18)
    straps = [
        box(0.022 * k, 0.003, 0.75 * h).move(s * 0.28 * x, -0.51 * y, 0.32 * h) for s in (-1, 1)
    ] + [box(0.022 * k, 1.03 * y, 0.003).move(s * 0.28 * x, 0, h + 0.0335 * k) for s in (-1, 1)]
    straps += [box(0.022 * k, 0.003, 0.035 * k).move(s * 0.28 * x, -0.514 * y, h) for s in (-1, 1)]
    buckles = [
        box(0.028 * k, 0.006, 0.016 * k).move(s * 0.28 * x, -0.515 * y, 0.62 * h) for s in (-1, 1)
    ]
    grip = tube(
        smooth(
            [
                (-0.06 * k, -0.51 * y, h + 0.018 * k),
                (-0.05 * k, -0.51 * y - 0.03, h + 0.018 * k),
                (0.05 * k, -0.51 * y - 0.03, h + 0.018 * k),
                (0.06 * k, -0.51 * y, h + 0.018 * k),
            ],
            4,
        ),
        0.007 * k,
        8,
    )
    leather = textures.speckles(look.rng, (112, 66, 40), 9)
    pieces = [
        (join([body, lid]), weave),
        (join([*straps, grip]), leather),
        (join(buckles), textures.brushed_metal(look.rng, (206, 172, 96))),
    ]
    if look.chance(0.4):
        cloth = (
            prism(rectangle(0.5 * x, 0.04, 0.004), 0, 0.05 * k)
            .turn(0, np.pi / 2)
            .move(0, -0.51 * y, h - 0.01)
        )
        pieces.append((cloth, textures.fabric(look.rng, (236, 232, 226), (196, 42, 40))))
    return shape(pieces, [hull_of(body), hull_of(lid), hull_of(grip)])


def ice_pack(look: Look) -> Shape:
    """An ice pack: a flat ribbed plastic block of blue gel with a cap."""
    k, color = look.between(0.9, 1.12), look.color("blue", "sky", "cyan", "white", "teal")
    body = pad(0.16 * k, 0.09 * k, 0.026 * k, 0.014 * k, soft=0.3)
    ribs = [
        box(0.012 * k, 0.064 * k, 0.002).move(i * 0.024 * k, 0, 0.0252 * k) for i in range(-2, 3)
    ]
    cap = cylinder(0.009 * k, 0.012, 16).turn(1, np.pi / 2).move(0.079 * k, 0.025 * k, 0.013 * k)
    label = prints.canvas(120, 40, (250, 250, 250))
    prints.write(
        label,
        look.pick(["ICE", "COOL", "FREEZE"]),
        0.5,
        0.5,
        0.6,
        color if sum(color) < 600 else (50, 90, 170),
        bold=True,
    )
    plate = box(0.06 * k, 0.02 * k, 0.0006).move(0, 0, 0.0271 * k)
    return shape(
        [
            (body, look.surface(color, "plastic")),
            (join(ribs), textures.plain(tint_color(color, 0.85))),
            (cap, textures.plain((246, 246, 246))),
            (plate, label),
        ],
        [hull_of(body)],
    )


def wipe_packet(look: Look) -> Shape:
    """A soft packet of wet wipes lying, a flip lid on top."""
    k, color = look.between(0.9, 1.1), look.color("sky", "white", "mint", "pink", "lavender")
    body = pad(0.17 * k, 0.1 * k, 0.045 * k, 0.014 * k, soft=0.5)
    seams = [box(0.012 * k, 0.1 * k, 0.003).move(s * 0.088 * k, 0, 0.02 * k) for s in (-1, 1)]
    lid = block(0.085 * k, 0.055 * k, 0.008, 0.014 * k, 0.002).move(z=0.0445 * k)
    image = prints.canvas(180, 110, color)
    prints.fill(image, 0, 0.82, 1, 0.18, tint_color(color, 0.7))
    prints.write(
        image,
        look.pick(["WIPES", "BABY WIPES", "FRESH"]),
        0.5,
        0.9,
        0.14,
        readable_on(tint_color(color, 0.7)),
        bold=True,
    )
    for n in range(5):
        prints.disc(image, 0.08 + 0.03 * (n % 2), 0.1 + 0.15 * n, 0.04, (250, 250, 250))
    face = box(0.15 * k, 0.084 * k, 0.0006).move(z=0.0448 * k)
    return shape(
        [
            (join([body, *seams]), textures.speckles(look.rng, color, 3)),
            (face, image),
            (lid, textures.plain(tint_color(color, 0.75))),
        ],
        [hull_of(body, lid)],
    )


_B, _P = ("bar",), ("living",)

CATEGORIES = (
    Category("picnic_hamper", picnic_hamper, (0.332, 0.26, 0.198), 1.8,
             ("picnic basket", "wicker hamper"), _P, ("big", "support"), ("tan",)),
    Category("ice_pack", ice_pack, (0.172, 0.0903, 0.0278), 0.35, ("freezer block", "cool pack",
        "freezer pack", "ice block", "gel pack", "cooling pack"), _P, ("flat",), ("blue",),
        state="lying flat"),
    Category("wet_wipes", wipe_packet, (0.184, 0.0977, 0.0515), 0.3, ("wet wipe packet",
        "pack of wet wipes", "baby wipes", "packet of wet wipes",
        "pack of baby wipes"), _P, (), ("sky",),
             state="lying flat"),
)  # fmt: skip
"""The module's categories."""
