"""What lies about on a workbench, besides hand tools."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of, hull_part
from ...build.outlines import rectangle
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, join, lathe, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look
from .tools import GRIPS, lying, steel


def tape_roll(look: Look) -> Shape:
    """A roll of adhesive tape lying flat."""
    r, h = look.between(0.038, 0.048), look.between(0.022, 0.034)
    color = look.color("beige", "gray", "blue", "green", "yellow", "black")
    wound = textures.stripes([color, tint_color(color, 0.93)], 20, upright=True)
    tape = lathe([(0.6 * r, 0), (r, 0), (r, h), (0.6 * r, h)], 32, loop=True)
    core = lathe(
        [(0.55 * r, 0.001), (0.61 * r, 0.001), (0.61 * r, h - 0.001), (0.55 * r, h - 0.001)],
        32, loop=True,
    )  # fmt: skip
    wedges = []
    for k in range(8):
        a, b = 2 * np.pi * k / 8, 2 * np.pi * (k + 1) / 8
        points = [
            (rad * np.cos(t), rad * np.sin(t), z)
            for t in (a, (a + b) / 2, b) for rad in (0.57 * r, 0.99 * r) for z in (0, h)
        ]  # fmt: skip
        wedges.append(hull_part(points))
    return shape([(tape, wound), (core, textures.cardboard(look.rng))], wedges)


def magnifying_glass(look: Look) -> Shape:
    """A magnifying glass lying flat."""
    r = look.between(0.036, 0.045)
    dark = textures.speckles(look.rng, look.color("black", "brown", "navy", "red"), 4)
    metal = textures.brushed_metal(look.rng, look.own_color("black", "gold", "silver"))
    rim = torus(r, 0.0045, 32, 8).move(z=0.0055)
    lens = cylinder(r - 0.002, 0.004, 28, bevel=0.001).move(z=0.0035)
    sky = textures.gradient((196, 214, 220), (228, 238, 240), look.rng)
    neck = lying(cylinder(0.0045, 0.018, 12), r + 0.002, 0.0065)
    grip = lying(cylinder(0.0065, 0.085, 16, top=0.0085, bevel=0.002), r + 0.016, 0.0085)
    keel = box(0.075, 0.008, 0.004).move(x=r + 0.06)
    return shape(
        [(rim, metal), (lens, sky), (neck, metal), (grip, dark), (keel, dark)],
        [cylinder_part(r + 0.0045, 0.01, (0, 0, 0.0005)),
         box_part(0.085, 0.013, 0.0165, (r + 0.0585, 0, 0)),
         box_part(0.02, 0.008, 0.009, (r + 0.01, 0, 0.002))],
    )  # fmt: skip


def flashlight(look: Look) -> Shape:
    """A flashlight lying: body, flared head, lens."""
    length, r = look.between(0.14, 0.17), look.between(0.014, 0.017)
    color = look.color("black", "red", "gray", "yellow", "blue")
    shell = textures.grid(tint_color(color, 0.7), color, 10, 14, 96, 1)
    body = lathe([(0, 0), (0.9 * r, 0), (r, 0.004), (r, 0.7 * length), (0, 0.7 * length)], 20)
    head = lathe(
        [(0, 0.66 * length), (r, 0.66 * length), (1.55 * r, 0.8 * length), (1.55 * r, length),
         (1.3 * r, length), (0.0, length - 0.004)],
        20,
    )  # fmt: skip
    lens = lying(cylinder(1.32 * r, 0.002, 20), length / 2 - 0.004, 1.55 * r)
    switch = block(0.02, 0.009, 0.005, 0.003).move(x=-0.02, z=2.5 * r)
    keel = box(0.6 * length, r, 0.7 * r).move(x=-0.15 * length)
    dark = textures.speckles(look.rng, tint_color(color, 0.75), 4)
    return shape(
        [(lying(body, -length / 2, 1.55 * r), shell), (lying(head, -length / 2, 1.55 * r), dark),
         (lens, textures.gradient((230, 226, 190), (252, 250, 236), look.rng)),
         (switch, textures.plain((200, 60, 50))), (keel, dark)],
        [box_part(0.68 * length, 1.5 * r, 2.2 * r, (-0.16 * length, 0, 0)),
         box_part(0.22 * length, 2.2 * r, 3.0 * r, (0.39 * length, 0, 0))],
    )  # fmt: skip


def toolbox(look: Look) -> Shape:
    """A closed toolbox with a handle on its lid."""
    x, y, h = look.between(0.3, 0.36), look.between(0.15, 0.18), look.between(0.11, 0.13)
    color = look.color("red", "blue", "black", "yellow", "orange")
    lower = textures.speckles(look.rng, color, 5)
    upper = textures.speckles(look.rng, tint_color(color, 0.7), 5)
    lid = prism(rectangle(0.96 * x, 0.92 * y, 0.02), h, h + 0.04, 0.012)
    bow = tube(
        [
            (-0.06, 0, h + 0.036),
            (-0.055, 0, h + 0.062),
            (0.055, 0, h + 0.062),
            (0.06, 0, h + 0.036),
        ],
        0.008,
        10,
    )
    clips = [box(0.025, 0.006, 0.03).move(s * 0.3 * x, -y / 2 - 0.002, h - 0.012) for s in (-1, 1)]
    return shape(
        [(block(x, y, h, 0.012, 0.003), lower), (lid, upper), (bow, textures.plain((40, 40, 44))),
         (join(clips), steel(look))],
        [box_part(x, y, h), box_part(0.94 * x, 0.88 * y, 0.04, (0, 0, h)),
         box_part(0.12, 0.016, 0.029, (0, 0, h + 0.04))],
    )  # fmt: skip


def paint_brush(look: Look) -> Shape:
    """A flat paint brush lying."""
    w = look.between(0.022, 0.045)
    wood = look.surface(look.color("wooden", "red", "black", "yellow"), "plastic")
    tip = look.own_color("tan", "brown", "black")
    hair = textures.stripes([tip, tint_color(tip, 0.7)], 14, upright=True)
    handle = prism(
        [(-0.12, -0.004), (-0.06, -0.008), (-0.01, -0.4 * w), (-0.01, 0.4 * w), (-0.06, 0.008),
         (-0.12, 0.004)],
        0.0, 0.01, 0.003,
    )  # fmt: skip
    ferrule = block(0.03, w, 0.011, 0.003, 0.001).move(x=0.0)
    bristle = prism(
        [(0.014, -w * 0.47), (0.06, -w * 0.42), (0.06, w * 0.42), (0.014, w * 0.47)], 0.0015, 0.009
    )
    return shape(
        [(handle, wood), (ferrule, steel(look)), (bristle, hair)],
        [hull_of(handle), box_part(0.03, w, 0.011), hull_of(bristle)],
    )


def screw_box(look: Look) -> Shape:
    """A flat plastic organiser with compartments of screws."""
    x, y, h = 0.16, 0.11, 0.03
    frame = textures.speckles(look.rng, look.color("blue", "red", "gray", "yellow"), 4)
    image = prints.canvas(160, 112, (190, 194, 198))
    for _ in range(170):
        i, j = look.rng.integers(0, 150), look.rng.integers(0, 104)
        tone = int(look.rng.integers(90, 230))
        image[j : j + 2, i : i + 9] = (tone, tone, tone - 10 if tone > 20 else tone)
    for k in range(1, 4):
        prints.fill(image, k / 4 - 0.01, 0, 0.02, 1, (70, 74, 80))
    prints.fill(image, 0, 0.49, 1, 0.025, (70, 74, 80))
    lid = box(0.95 * x, 0.92 * y, 0.001).move(z=h - 0.0005)
    latch = block(0.03, 0.006, 0.014, 0.002).move(y=-y / 2 - 0.002, z=0.01)
    return shape(
        [
            (block(x, y, h, 0.006, 0.002), frame),
            (lid, image),
            (latch, textures.plain((60, 62, 66))),
        ],
        [box_part(x, y, h)],
    )


def spray_can(look: Look) -> Shape:
    """A spray can of paint with its cap."""
    r, h = 0.0325, look.between(0.14, 0.17)
    color = look.color(*GRIPS, "violet", "white")
    print_ = prints.label(look.rng, look.pick(["SPRAY", "PAINT", "GLOSS"]), color, (240, 240, 238))
    body = lathe(
        [(0, 0), (r - 0.002, 0), (r, 0.002), (r, h), (0.72 * r, h + 0.016), (0, h + 0.016)],
        v=[0, 0, 0.01, 0.95, 0.99, 1],
    )
    cap = cylinder(0.78 * r, 0.036, 24, bevel=0.003).move(z=h + 0.008)
    return shape(
        [(body, print_), (cap, textures.speckles(look.rng, color, 3))],
        [cylinder_part(r, h), cylinder_part(0.78 * r, 0.044, (0, 0, h))],
    )


CATEGORIES = (
    Category(
        "tape_roll",
        tape_roll,
        (0.086, 0.086, 0.028),
        0.08,
        (
            "roll of tape",
            "tape",
            "duct tape",
            "masking tape",
            "sticky tape",
            "reel of tape",
            "toilet roll holder",
            "scotch tape roll",
            "washi tape",
            "double sided tape",
            "double-sided tape",
            "parafilm roll",
            "sellotape",
            "electrical tape",
            "insulating tape",
            "parcel tape",
            "packing tape",
        ),
        ("workbench", "craft", "office"),
        ("round", "flat"),
        ("beige", "gray"),
        state="lying flat",
    ),
    Category(
        "magnifying_glass",
        magnifying_glass,
        (0.18, 0.09, 0.017),
        0.12,
        ("magnifier", "loupe", "monocle", "bug viewer", "jeweller loupe", "loupe lens"),
        ("craft", "office"),
        ("flat",),
        ("black", "brown"),
        state="lying flat",
    ),
    Category(
        "flashlight",
        flashlight,
        (0.155, 0.048, 0.05),
        0.2,
        (
            "torch",
            "headlamp",
            "head torch",
        ),
        ("workbench",),
        (),
        ("black", "red"),
        state="lying flat",
    ),
    Category(
        "toolbox",
        toolbox,
        (0.33, 0.165, 0.19),
        1.6,
        ("tool box", "tool case", "tool chest"),
        ("workbench",),
        ("big",),
        ("red", "blue"),
    ),
    Category(
        "paint_brush",
        paint_brush,
        (0.18, 0.034, 0.011),
        0.04,
        (
            "paintbrush",
            "artist brush",
            "fan brush",
            "sponge brush",
            "mop brush",
            "foam brush",
            "watercolour brush",
            "stencil brush",
            "glue brush",
        ),
        ("craft", "workbench"),
        ("flat",),
        ("wooden", "red"),
        state="lying flat",
    ),
    Category(
        "screw_box",
        screw_box,
        (0.16, 0.115, 0.03),
        0.4,
        ("box of screws", "box of nails", "screw organizer"),
        ("workbench",),
        ("flat",),
        ("blue",),
    ),
    Category(
        "spray_can",
        spray_can,
        (0.065, 0.065, 0.19),
        0.35,
        (
            "spray paint",
            "aerosol can",
            "spray",
            "spray lubricant",
            "air freshener",
            "limescale remover",
            "stain remover",
            "drain cleaner",
            "wd-40",
            "wd 40",
            "can of wd 40",
            "de icer can",
            "de-icer can",
            "car wax spray",
        ),
        ("workbench", "craft"),
        ("round", "tall"),
        GRIPS,
    ),
)
