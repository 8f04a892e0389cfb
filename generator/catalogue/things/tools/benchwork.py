"""Files, chisels, paint rollers, and a sewing machine."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import flat_foot, hull_of, hull_part
from ...build.forms import facing
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, prism, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .tools import lying, steel


def metal_file(look: Look) -> Shape:
    """A flat metal file lying, its hatched blade to the left, a wooden or plastic handle."""
    long, wide = look.between(0.22, 0.3), look.between(0.018, 0.026)
    color = look.color("wooden", "red", "blue", "orange", "black", "yellow", "green")
    cut = 0.08 * long
    blade = prism(
        np.array(
            [
                (-0.5 * long, -0.36 * wide),
                (cut, -0.5 * wide),
                (cut + 0.012, -0.1 * wide),
                (cut + 0.05, -0.1 * wide),
                (cut + 0.05, 0.1 * wide),
                (cut + 0.012, 0.1 * wide),
                (cut, 0.5 * wide),
                (-0.5 * long, 0.36 * wide),
            ]
        ),
        0.006,
        0.0105,
    )
    hatch = prints.canvas(128, 64, (150, 154, 160))
    for n in range(-32, 64):
        prints.stroke(hatch, [(n / 48, 0), (n / 48 + 0.3, 1)], 0.02, (104, 108, 114))
    r = 0.0125
    grip = lathe(
        [
            (0, 0),
            (0.008, 0),
            (0.0095, 0.008),
            (r, 0.03),
            (0.0105, 0.06),
            (r, 0.092),
            (0.009, 0.105),
            (0, 0.107),
        ],
        18,
    )
    grip = lying(grip, cut + 0.012, r)
    ferrule = lying(cylinder(0.0088, 0.012, 16), cut + 0.008, r)
    tip = box(0.006, 0.5 * wide, 0.0065).move(x=-0.5 * long + 0.01)
    return shape(
        [
            (blade, hatch),
            (tip, textures.plain((120, 124, 130))),
            (grip, look.surface(color, "wood")),
            (ferrule, textures.brushed_metal(look.rng, (200, 180, 120))),
        ],
        [
            hull_part(blade.vertices[blade.vertices[:, 0] < cut + 0.001]),
            hull_of(tip),
            flat_foot(grip.vertices, 0.1),
        ],
    )


def chisel(look: Look) -> Shape:
    """A wood chisel lying: a bevelled blade to the left, a striking handle."""
    wide, long = look.between(0.012, 0.03), look.between(0.21, 0.26)
    color = look.color("wooden", "red", "yellow", "blue", "black", "orange", "green")
    blade = prism(
        np.array(
            [
                (-0.5 * long, -wide / 2),
                (-0.02, -wide / 2),
                (0.002, -0.005),
                (0.002, 0.005),
                (-0.02, wide / 2),
                (-0.5 * long, wide / 2),
            ]
        ),
        0.0,
        0.0045,
    )
    blade = blade.bend(lambda p: np.column_stack([p[:, :2], np.where(
        (p[:, 0] < -0.499 * long) & (p[:, 2] > 0.002), 0.0006, p[:, 2])]))  # fmt: skip
    neck = tube([(-0.005, 0, 0.0052), (0.03, 0, 0.0115)], 0.0045, 8)
    r = 0.0145
    grip = lathe(
        [
            (0, 0),
            (0.0085, 0),
            (0.0105, 0.01),
            (r, 0.05),
            (0.0135, 0.085),
            (r, 0.1),
            (0.0135, 0.112),
            (0, 0.113),
        ],
        20,
    )
    grip = lying(grip, 0.022, r)
    cap = lying(cylinder(0.0148, 0.008, 18, bevel=0.001), 0.127, 0.0148)
    blade_ = blade.bend(
        lambda p: np.column_stack(
            [p[:, :2], p[:, 2] + 0.0035 * np.clip((p[:, 0] + 0.5 * long) / (0.5 * long), 0, 1)]
        )
    )
    return shape(
        [
            (join([blade_, neck]), steel(look)),
            (grip, look.surface(color, "wood")),
            (cap, textures.plain((120, 122, 128))),
        ],
        [hull_of(blade_), hull_of(neck), flat_foot(join([grip, cap]).vertices, 0.1)],
    )


def paint_roller(look: Look) -> Shape:
    """A paint roller lying: a fleece to the left, a bent wire, a handle to the right."""
    k = look.between(0.85, 1.05)
    color = look.color("red", "blue", "green", "black", "orange", "wooden", "yellow")
    dip = look.pick(
        [
            (240, 236, 226),
            (240, 236, 226),
            (90, 140, 200),
            (220, 90, 80),
            (240, 200, 80),
            (120, 170, 110),
        ]
    )
    r, wide = 0.024 * k, look.between(0.15, 0.2) * k
    fleece = cylinder(r, wide, 26, bevel=0.005).turn(0, -np.pi / 2).move(-0.11 * k, -wide / 2, r)
    caps = [
        cylinder(0.7 * r, 0.006, 20).turn(0, -np.pi / 2).move(-0.11 * k, y, r)
        for y in (-wide / 2 - 0.003, wide / 2 - 0.003)
    ]
    wire = tube(
        smooth(
            [
                (-0.11 * k, wide / 2 - 0.005, r),
                (-0.11 * k, wide / 2 + 0.022, r),
                (-0.075 * k, wide / 2 + 0.026, r),
                (-0.055 * k, 0.3 * wide, 0.9 * r),
                (-0.03 * k, 0.02, 0.8 * r),
                (0.02 * k, 0, 0.68 * r),
                (0.06 * k, 0, 0.66 * r),
            ],
            4,
        ),
        0.0034 * k,
        8,
    )
    grip = lathe(
        [
            (0, 0),
            (0.009, 0),
            (0.013, 0.02),
            (0.0155, 0.06),
            (0.0125, 0.1),
            (0.0145, 0.125),
            (0, 0.128),
        ],
        18,
    )
    grip = lying(grip.scale(k, k, k), 0.04 * k, 0.0155 * k)
    return shape(
        [
            (fleece, textures.spots(look.rng, dip, tint_color(dip, 0.9), 0.4)),
            (join([*caps, wire]), textures.plain((176, 178, 184))),
            (grip, look.surface(color, "plastic")),
        ],
        [
            flat_foot(fleece.vertices, 0.08),
            hull_of(grip),
            hull_part(wire.vertices[wire.vertices[:, 0] > -0.06 * k]),
        ],
    )


def sewing_machine(look: Look) -> Shape:
    """A sewing machine: a bed, an arm over it, a needle, a hand wheel to the right, a spool."""
    k = look.between(0.88, 1.0)
    color = look.color("white", "white", "black", "mint", "pink", "red", "cream", "sky")
    skin = textures.speckles(look.rng, color, 3, 32)
    trim = textures.speckles(
        look.rng, look.own_color("gray", "teal", "red", "navy", "charcoal", "violet"), 3, 32
    )
    bed = block(0.37 * k, 0.16 * k, 0.065 * k, 0.02, 0.005)
    post = block(0.095 * k, 0.12 * k, 0.2 * k, 0.02, 0.004).move(0.13 * k, 0.01 * k, 0.063 * k)
    arm = block(0.34 * k, 0.105 * k, 0.085 * k, 0.02, 0.01).move(0.0, 0.012 * k, 0.185 * k)
    head = block(0.075 * k, 0.1 * k, 0.13 * k, 0.018, 0.006).move(-0.13 * k, 0.012 * k, 0.135 * k)
    wheel = (
        cylinder(0.038 * k, 0.018 * k, 30, bevel=0.003)
        .turn(1, np.pi / 2)
        .move(0.175 * k, 0.012 * k, 0.225 * k)
    )
    metal = textures.brushed_metal(look.rng, (196, 199, 204))
    needle = [cylinder(0.0045 * k, 0.03 * k, 10).move(-0.13 * k, -0.005 * k, 0.108 * k),
              cylinder(0.0012 * k, 0.046 * k, 6).move(-0.13 * k, -0.005 * k, 0.064 * k),
              box(0.016 * k, 0.024 * k, 0.003 * k).move(-0.13 * k, -0.012 * k, 0.067 * k),
              box(0.003 * k, 0.004 * k, 0.05 * k).move(-0.12 * k, 0.0, 0.068 * k)]  # fmt: skip
    plate = box(0.08 * k, 0.07 * k, 0.0012).move(-0.13 * k, 0, 0.0648 * k)
    thread_color = look.own_color("red", "blue", "yellow", "green", "violet")
    spool = (
        lathe(
            [
                (0, 0),
                (0.012, 0),
                (0.012, 0.004),
                (0.0095, 0.005),
                (0.0095, 0.031),
                (0.012, 0.032),
                (0.012, 0.036),
                (0, 0.036),
            ],
            18,
        )
        .scale(k, k, k)
        .move(0.06 * k, 0.03 * k, 0.268 * k)
    )
    dial = [
        facing(cylinder(r * k, 0.01, 22, bevel=0.002)).move(x * k, -0.048 * k, z * k)
        for x, z, r in ((0.13, 0.17, 0.024), (0.13, 0.225, 0.016), (0.05, 0.225, 0.016))
    ]
    face = prints.canvas(64, 64, (246, 246, 242))
    for n in range(12):
        a = n * np.pi / 6
        prints.stroke(
            face,
            [
                (0.5 + 0.3 * np.cos(a), 0.5 + 0.3 * np.sin(a)),
                (0.5 + 0.44 * np.cos(a), 0.5 + 0.44 * np.sin(a)),
            ],
            0.03,
            (60, 60, 66),
        )
    prints.fill(face, 0.46, 0.2, 0.08, 0.4, (60, 60, 66))
    pieces = [
        (join([bed, post, arm, head]), skin),
        (wheel, trim),
        (join([*needle, plate]), metal),
        (spool, textures.stripes([thread_color, tint_color(thread_color, 0.85)], 12)),
        *((d, face) for d in dial),
    ]
    if look.chance(0.4):
        cloth = box(0.16 * k, 0.14 * k, 0.002).move(-0.15 * k, -0.03 * k, 0.0655 * k)
        pieces.append(
            (
                cloth,
                textures.fabric(
                    look.rng, look.own_color("sky", "red", "mustard", "sage"), (246, 244, 238), 24
                ),
            )
        )
    return shape(
        pieces,
        [hull_of(bed), hull_of(post), hull_of(arm), hull_of(head), hull_of(wheel), hull_of(spool)],
    )


CATEGORIES = (
    Category("metal_file", metal_file, (0.268, 0.025, 0.0248), 0.22, ("steel file", "rasp",
             "hand file", "flat file", "wood file", "wood rasp", "foot file"), ("workbench",), (),
             ("wooden",
             "red"), state="lying flat"),
    Category("chisel", chisel, (0.25, 0.03, 0.03), 0.16, ("wood chisel", "carving chisel",
             "gouge", "cold chisel", "spokeshave", "quilling tool"), ("workbench",), (),
             ("wooden", "red"), state="lying flat"),
    Category("paint_roller", paint_roller, (0.281, 0.202, 0.0447), 0.25, ("roller brush",
             "paint roll",
             "mini roller", "brayer", "printing roller", "lino roller"), ("workbench", "craft"),
             ("big",), ("red", "blue"), state="lying flat"),
    Category("sewing_machine", sewing_machine, (0.36, 0.155, 0.285), 6.0, ("toy sewing machine",
             "sewing-machine"), ("craft",), ("big", "tall"), ("white", "black")),
)  # fmt: skip
"""The module's categories."""
