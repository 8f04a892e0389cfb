"""Needles, buttons, thimbles and other small things to sew and knit with."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, hull_of
from ...build.forms import lobe
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, put_down, rod, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

HUES = ("red", "blue", "green", "yellow", "purple", "white", "black", "pink", "brown", "teal")
STEEL = (200, 204, 210)


def button(look: Look) -> Shape:
    """A round button with a rim and two or four holes."""
    r = look.between(0.009, 0.016)
    color = look.color(*HUES, "wooden")
    t = 0.22 * r
    disc = lathe([(0, 0), (0.9 * r, 0), (r, 0.4 * t), (r, 0.8 * t), (0.92 * r, t), (0.74 * r, t),
                  (0.66 * r, 0.6 * t), (0, 0.6 * t)], 28)  # fmt: skip
    count = look.pick([2, 4])
    holes = [
        cylinder(0.13 * r, 0.0003, 12).move(0.26 * r * np.cos(a), 0.26 * r * np.sin(a), 0.58 * t)
        for a in 2 * np.pi * np.arange(count) / count + 0.4
    ]
    return shape(
        [
            (disc, look.surface(color, "plastic")),
            (join(holes), textures.plain(tint_color(color, 0.25))),
        ],
        [cylinder_part(r, t)],
    )


def thimble(look: Look) -> Shape:
    """A thimble standing on its rim, dimpled."""
    color = look.color("silver", "gold", "brass", "copper", "white", "bronze")
    dots = prints.mesh_holes(color, tint_color(color, 0.7), 10, 26)
    body = lathe([(0, 0), (0.0092, 0), (0.0092, 0.0015), (0.0086, 0.0025), (0.0072, 0.018),
                  (0.005, 0.0222), (0, 0.023)], 26)  # fmt: skip
    rim = torus(0.0092, 0.0008, 26, 6).move(z=0.0008)
    made = shape([(body, dots), (rim, textures.plain(color))], [hull_of(body)])
    return made.scale(look.between(0.9, 1.25))


def needle(look: Look) -> Shape:
    """A sewing needle lying, a short thread through its eye."""
    color = look.color(*HUES)
    long = look.between(0.045, 0.07)
    shaft = straight((-long / 2, 0, 0.0006), (0.42 * long, 0, 0.0006), [0.0002, 0.0006], 6)
    eye = torus(0.0016, 0.0005, 12, 5).scale(2.2, 1, 1).move(0.42 * long + 0.0034, 0, 0.0006)
    e = 0.42 * long + 0.0034
    thread = rod([(e, 0, 0.0008), (e + 0.012, 0.01, 0.0006), (e + 0.002, 0.022, 0.0006),
                  (e - 0.02, 0.018, 0.0006), (e - 0.034, 0.024, 0.0006)], 0.0005, 5)  # fmt: skip
    return put_down([(join([shaft, eye]), textures.plain(STEEL)), (thread, textures.plain(color))],
                   join([shaft, eye]), thread)  # fmt: skip


def pin(look: Look) -> Shape:
    """A dressmaker's pin with a coloured ball."""
    color = look.color(*HUES)
    long = look.between(0.032, 0.05)
    shaft = straight((-long / 2, 0, 0.0007), (long / 2, 0, 0.0019), [0.0002, 0.0005], 6)
    head = ball(0.004, 0.004, 0.004, (long / 2, 0, 0.0018), 12)
    return put_down([(shaft, textures.plain(STEEL)), (head, textures.speckles(look.rng, color, 3))],
                   shaft, head, factor=look.between(0.9, 1.4), foot=0.5)  # fmt: skip


def safety_pin(look: Look) -> Shape:
    """A closed safety pin lying: a bent wire, a coil, a cap."""
    color = look.color("silver", "gold", "brass", "black", "copper")
    path = smooth([(0.024, 0.004, 0.0008), (-0.014, 0.005, 0.0008), (-0.02, 0.004, 0.0008),
                   (-0.0225, 0.0, 0.001), (-0.02, -0.004, 0.0008), (-0.014, -0.005, 0.0008),
                   (0.024, -0.0035, 0.0008)], 3)  # fmt: skip
    wire = tube(path, 0.0007, 6)
    coil = torus(0.0022, 0.0007, 14, 6).move(-0.0205, 0, 0.0016)
    cap = block(0.011, 0.011, 0.003, 0.004, 0.001).move(0.025)
    metal = textures.brushed_metal(look.rng, color)
    return put_down([(join([wire, coil]), metal), (cap, textures.plain(tint_color(color, 1.1)))],
                   wire, cap, factor=look.between(0.85, 1.3))  # fmt: skip


def knitting_needle(look: Look) -> Shape:
    """A knitting needle lying, with its knob."""
    color = look.color("wooden", "silver", "red", "blue", "green", "purple", "tan")
    long, r = look.between(0.2, 0.26), look.between(0.0026, 0.0036)
    shaft = straight((-long / 2 + 0.012, 0, r), (long / 2, 0, r), r, 10)
    tip = straight((-long / 2, 0, r), (-long / 2 + 0.0121, 0, r), [0.0006, r], 10)
    knob = cylinder(0.006, 0.007, 16, bevel=0.0015).turn(1, np.pi / 2).move(long / 2, 0, 0.0058)
    return put_down(
        [
            (join([shaft, tip]), look.surface(color, "wood" if color[0] > 190 else "metal")),
            (knob, textures.plain(look.own_color("black", "red", "navy", "brown"))),
        ],
        shaft,
        knob,
    )


def crochet_hook(look: Look) -> Shape:
    """A crochet hook lying, its hook to the left, a flat grip in the middle."""
    color = look.color("silver", "gold", "pink", "blue", "purple", "wooden", "teal")
    long = look.between(0.13, 0.16)
    h = long / 2
    shaft = straight((-0.86 * h, 0, 0.0038), (-0.1 * h, 0, 0.0038), [0.0018, 0.0024], 10)
    hook = rod([(-0.85 * h, 0, 0.0038), (-0.97 * h, 0, 0.0038), (-h, 0.0022, 0.0038),
                (-0.955 * h, 0.004, 0.0038)], [0.0018, 0.0017, 0.0014, 0.0007], 8)  # fmt: skip
    grip = rod([(-0.12 * h, 0, 0.004), (0.2 * h, 0, 0.004), (0.7 * h, 0, 0.004), (h, 0, 0.004)],
               [0.003, 0.0044, 0.0044, 0.003], 12)  # fmt: skip
    return put_down(
        [
            (join([shaft, hook]), textures.brushed_metal(look.rng, STEEL)),
            (grip, look.surface(color, "plastic")),
        ],
        join([shaft, hook]),
        grip,
        foot=0.4,
    )


def pin_cushion(look: Look) -> Shape:
    """A tomato-shaped pin cushion stuck with pins."""
    color = look.color("red", "red", "green", "blue", "pink", "purple", "mustard")
    d = look.between(0.06, 0.085)
    body = lobe(ellipsoid(d, d, 0.62 * d, 32, 12), 8, 0.08).move(z=0.28 * d)
    star = [ellipsoid(0.32 * d, 0.09 * d, 0.03 * d, 8, 4).move(x=0.14 * d).turn(1, 0.18)
            .turn(2, 2 * np.pi * k / 6).move(z=0.585 * d) for k in range(6)]  # fmt: skip
    shafts: list[Solid] = []
    heads: list[list[Solid]] = [[], [], []]
    for k in range(9):
        a, lean = 2.4 * k, 0.3 + 0.06 * k
        way = np.array([np.sin(lean) * np.cos(a), np.sin(lean) * np.sin(a), np.cos(lean)])
        foot = way * [0.46 * d, 0.46 * d, 0.26 * d] + [0, 0, 0.28 * d]
        tip = foot + 0.022 * way
        shafts.append(tube([tuple(foot), tuple(tip)], 0.0005, 5))
        heads[k % 3].append(ball(0.0045, 0.0045, 0.0045, tuple(tip), 8))
    pieces: Pieces = [
        (body, textures.fabric(look.rng, color)),
        (join(star), textures.plain((70, 120, 60))),
        (join(shafts), textures.plain(STEEL)),
    ]
    pieces += [(join(h), textures.plain(look.own_color(*HUES))) for h in heads]
    return put_down(pieces, body, join(shafts))


def bobbin(look: Look) -> Shape:
    """A bobbin wound with thread, standing on its flange."""
    color = look.color(*HUES)
    r, h = look.between(0.01, 0.013), look.between(0.011, 0.014)
    flanges = [cylinder(r, 0.0012, 24).move(z=z) for z in (0, h - 0.0012)]
    thread = cylinder(0.9 * r, h - 0.003, 24).move(z=0.0014)
    hub = cylinder(0.3 * r, 0.0004, 14).move(z=h - 0.0001)
    holes = [
        cylinder(0.09 * r, 0.0003, 8).move(0.6 * r * np.cos(a), 0.6 * r * np.sin(a), h - 0.0001)
        for a in 2 * np.pi * np.arange(6) / 6
    ]
    wound = textures.knitting(look.rng, color, 30)
    return shape(
        [
            (join(flanges), textures.brushed_metal(look.rng, STEEL)),
            (thread, wound),
            (join([hub, *holes]), textures.plain((60, 60, 64))),
        ],
        [cylinder_part(r, h)],
    )


def embroidery_hoop(look: Look) -> Shape:
    """An embroidery hoop lying: cloth stretched in a wooden ring, flowers stitched on it."""
    color = look.color("white", "cream", "sky", "beige", "mint", "pink")
    r = look.between(0.07, 0.09)
    ring = lathe(
        [(r - 0.004, 0), (r + 0.004, 0), (r + 0.004, 0.01), (r - 0.004, 0.01)], 36, loop=True
    )
    image = textures.fabric(look.rng, color, threads=40).copy()
    for k in range(5):
        a = 2 * np.pi * k / 5 + 0.3
        x, y = 0.5 + 0.22 * np.cos(a), 0.5 + 0.22 * np.sin(a)
        prints.stroke(image, [(0.5, 0.55), (x, y)], 0.014, (84, 130, 74))
        hue = look.own_color("red", "pink", "blue", "yellow", "purple")
        for b in 2 * np.pi * np.arange(6) / 6:
            prints.disc(image, x + 0.055 * np.cos(b), y + 0.055 * np.sin(b), 0.032, hue)
        prints.disc(image, x, y, 0.03, (246, 206, 80))
    sheet = cylinder(r - 0.003, 0.0015, 36).move(z=0.007)
    screw = join([box(0.012, 0.014, 0.009).move(0, r + 0.009), cylinder(0.0025, 0.026, 10).move(
        z=-0.013).turn(1, np.pi / 2).move(0, r + 0.012, 0.005)])  # fmt: skip
    return shape(
        [
            (ring, textures.wood(look.rng, (214, 172, 120))),
            (sheet, image),
            (screw, textures.plain((206, 172, 96))),
        ],
        [cylinder_part(r + 0.004, 0.01)],
    )


def zipper(look: Look) -> Shape:
    """A zip lying: two tapes, a row of teeth, the slider near its end."""
    color = look.color(*HUES)
    long = look.between(0.16, 0.2)
    tapes = [box(long, 0.0125, 0.0012).move(0, s * 0.0072) for s in (-1, 1)]
    teeth = [box(0.0018, 0.0042, 0.0024).move(x, (-1) ** n * 0.0008)
             for n, x in enumerate(np.arange(-0.47 * long, 0.47 * long, 0.0031))]  # fmt: skip
    slide = block(0.012, 0.009, 0.0045, 0.003, 0.001).move(0.32 * long)
    tag = torus(0.005, 0.0012, 14, 6).scale(1.6, 0.8, 1).move(0.32 * long + 0.014, 0, 0.0038)
    metal = textures.brushed_metal(look.rng, look.pick([STEEL, (206, 172, 96)]))
    return shape(
        [(join(tapes), textures.fabric(look.rng, color)), (join([*teeth, slide, tag]), metal)],
        [box_part(long, 0.0269, 0.0022), hull_of(slide, tag)],
    )


def bead(look: Look) -> Shape:
    """A single bead lying with its hole level: round, faceted or long."""
    color = look.color(*HUES, "gold", "orange")
    d = look.between(0.01, 0.018)
    kind = look.pick(["round", "faceted", "long"])
    sides = 8 if kind == "faceted" else 20
    body = ellipsoid(d, d, d * (1.5 if kind == "long" else 0.95), sides, 5 if sides == 8 else 12)
    body = body.turn(2, np.pi / 8).turn(1, np.pi / 2).move(z=0.44 * d)
    reach = d * (0.76 if kind == "long" else 0.485)
    holes = [
        cylinder(0.12 * d, 0.0006, 10)
        .turn(1, np.pi / 2)
        .move(s * 0.985 * reach - 0.0003, 0, 0.44 * d)
        for s in (-1, 1)
    ]
    skin = textures.speckles(look.rng, color, 4) if look.chance(0.6) else textures.stripes(
        [color, tint_color(color, 1.6)], 4)  # fmt: skip
    return put_down([(body, skin), (join(holes), textures.plain((40, 36, 36)))], body)


def pompom(look: Look) -> Shape:
    """A fluffy pompom."""
    color = look.color(*HUES, "orange")
    d = look.between(0.025, 0.05)
    tufts = [ball(0.4 * d, 0.4 * d, 0.4 * d, tuple(0.34 * d * np.array([
        np.sqrt(1 - z * z) * np.cos(2.4 * k), np.sqrt(1 - z * z) * np.sin(2.4 * k), z])), 8)
        for k, z in enumerate(np.linspace(-0.95, 0.95, 34))]  # fmt: skip
    body = join([*tufts, ball(0.86 * d, 0.86 * d, 0.86 * d, (0, 0, 0), 10)]).move(z=0.47 * d)
    wool = textures.scratches(look.rng, color, tint_color(color, 0.75), 120)
    return put_down([(body, wool)], body)


def yarn_skein(look: Look) -> Shape:
    """A skein of yarn lying, a paper band round its middle."""
    color = look.color(*HUES, "mustard", "sage", "gray")
    long, d = look.between(0.14, 0.18), look.between(0.06, 0.075)
    strands: list[Solid] = []
    for k in range(12):
        a = 2 * np.pi * k / 12
        y, z = 0.36 * d * np.cos(a), 0.34 * d * np.sin(a)
        path = [
            (-0.5 * long, 0.6 * y, 0.6 * z),
            (-0.3 * long, 1.15 * y, 1.15 * z),
            (0, 0.8 * y, 0.8 * z),
            (0.3 * long, 1.15 * y, 1.15 * z),
            (0.5 * long, 0.6 * y, 0.6 * z),
        ]
        strands.append(rod(path, [0.006, 0.0105, 0.0105, 0.0105, 0.006], 7, 3))
    body = join([*strands, ellipsoid(long, 0.75 * d, 0.72 * d, 14, 8)]).move(z=0.46 * d)
    ribs = textures.knitting(look.rng, color, 20)
    band = cylinder(0.455 * d, 0.05, 26).move(z=-0.025).turn(1, np.pi / 2).move(z=0.46 * d)
    label = textures.stack((textures.plain((250, 248, 240)), 0.7), (textures.plain(
        tint_color(color, 0.7)), 0.3))  # fmt: skip
    return put_down([(body, ribs), (band, label)], body)


CATEGORIES = (
    Category("button", button, (0.025, 0.025, 0.0028), 0.0015, ("shirt button", "coat button",
             "sewing button", "round button", "wooden button", "brass button", "peephole", "sequin",
             "press fastener", "press stud", "snap fastener"), ("craft",), ("round", "flat"),
             ("red", "blue"), state="lying flat"),
    Category("thimble", thimble, (0.021, 0.021, 0.0247), 0.004, ("metal thimble", "sewing thimble"),
             ("craft",), ("round",), ("silver",)),
    Category("needle", needle, (0.066, 0.027, 0.0013), 0.0005, ("sewing needle",
             "needle and thread", "embroidery needle", "darning needle", "potter's needle",
             "needle threader"), ("craft",), (), ("red",), state="lying"),
    Category("pin", pin, (0.05, 0.0046, 0.0046), 0.0002, ("sewing pin", "straight pin",
             "dressmaker pin", "ball pin", "inoculating loop"), ("craft",), (), ("red", "white"),
             state="lying"),
    Category("safety_pin", safety_pin, (0.057, 0.012, 0.0034), 0.001, ("safetypin", "diaper pin",
             "stitch holder", "french knitter"), ("craft",), (), ("silver",), state="lying flat"),
    Category("knitting_needle", knitting_needle, (0.235, 0.012, 0.0118), 0.012, ("knitting needles",
             "pair of knitting needles", "knitting pin", "circular needle", "double-pointed needle",
             "point protector"), ("craft",), (), ("wooden", "silver"), state="lying"),
    Category("crochet_hook", crochet_hook, (0.145, 0.0088, 0.0084), 0.01, ("crochet needle",
             "crocheting hook"), ("craft",), (), ("silver", "pink"), state="lying"),
    Category("pin_cushion", pin_cushion, (0.075, 0.075, 0.065), 0.04, ("pincushion",
             "needle cushion", "pin holder", "needle case"), ("craft",), ("round",), ("red",)),
    Category("bobbin", bobbin, (0.023, 0.023, 0.0125), 0.006, ("sewing bobbin", "thread bobbin",
             "sewing machine bobbin", "yarn winder", "wool winder", "spindle whorl"), ("craft",),
             ("round",), ("red", "blue")),
    Category("embroidery_hoop", embroidery_hoop, (0.168, 0.185, 0.01), 0.06, ("embroidery", "hoop",
             "cross stitch", "embroidery frame"), ("craft",), ("flat",), ("white",),
             state="lying flat"),
    Category("zipper", zipper, (0.18, 0.0269, 0.0052), 0.012, ("zip", "zip fastener"), ("craft",),
             ("flat",), ("black", "red"), state="lying flat"),
    Category("bead", bead, (0.019, 0.0154, 0.0145), 0.002, ("wooden bead", "glass bead",
             "plastic bead", "craft bead", "pearl bead"), ("craft",), (), ("red", "blue"),
             state="lying"),
    Category("pompom", pompom, (0.037, 0.037, 0.036), 0.003, ("pom pom", "pom-pom", "craft pompom",
             "fluffy ball", "pompom maker"), ("craft",), ("round",), ("red", "pink")),
    Category("yarn_skein", yarn_skein, (0.16, 0.075, 0.068), 0.1, ("skein", "skein of yarn",
             "hank of yarn", "skein of wool", "knitting wool", "wool", "wool skein", "wool roving",
             "skein of thread"), ("craft",), (), ("red", "blue"), state="lying"),
)  # fmt: skip
"""The module's categories."""
