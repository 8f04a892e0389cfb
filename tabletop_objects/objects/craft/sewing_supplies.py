"""Objects of the ``craft`` theme: sewing supplies."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import smooth
from ...kit.parts import box_part, cylinder_part, hull_of, resting_ball
from ...kit.primitives import ball, drum, facing, lobe, plate, rod, straight
from ...kit.shapes import Pieces, Shape, category, put_down, shape
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    prism,
    torus,
    tube,
)
from ...kit.surfaces import Look, plain, tint_color
from ..living.textiles import _cloth


@category("patch", size=(0.0704, 0.0707, 0.00356), mass=0.006, material="fabric",
          aliases=("iron-on patch", "embroidered patch", "sew-on patch", "cloth patch",
          "scout badge", "cloth badge"), themes=("craft",), roles=("flat",),
          colors=("navy", "red"))  # fmt: skip
def patch(look: Look) -> Shape:
    """An embroidered patch with a picture and a stitched border."""
    color = look.color("navy", "red", "green", "mustard", "black", "teal")
    r = look.between(0.026, 0.042)
    back = drum(r, 0.002, sides=30)
    rim = torus(0.96 * r, 0.0018, 34, 6).move(z=0.002)
    tone = look.own_color("yellow", "white", "coral", "sky")
    n = look.pick([5, 6, 8])
    a = np.pi / 2 + np.pi * np.arange(2 * n) / n
    s = np.where(np.arange(2 * n) % 2, 0.3, 0.66) * r
    star = plate(np.column_stack([s * np.cos(a), s * np.sin(a)]), 0.0016, at=(0, 0, 0.0018))
    return put_down([(back, surfaces.fabric(look.rng, color)), (rim, plain(tint_color(tone, 0.8))),
                     (star, plain(tone))], back)  # fmt: skip


@category("ribbon", size=(0.09, 0.065, 0.019), mass=0.03, material="fabric", assembled=True,
          aliases=("roll of ribbon", "ribbon spool", "spool of ribbon", "satin ribbon",
          "gift ribbon", "ribbon roll", "lace", "reel of ribbon", "bias binding", "velcro strip",
          "lace trim", "pompom trim", "elastic roll", "roll of elastic"), themes=("craft",),
          colors=("red", "pink"), state="lying flat")  # fmt: skip
def ribbon(look: Look) -> Shape:
    """A reel of ribbon on its side, with the end of the ribbon hanging loose."""
    r, wide = look.between(0.026, 0.034), look.between(0.014, 0.024)
    color = look.color("red", "pink", "gold", "blue", "green", "purple", "white", "silver")
    sheen = surfaces.brushed_metal(look.rng, color)
    coil = cylinder(r, wide, 30, bevel=0.001)
    core = cylinder(0.45 * r, wide + 0.001, 22)
    path = [(0, -r + 0.001, wide / 2), (0.5 * r, -1.06 * r, wide / 2),
            (1.1 * r, -0.9 * r, wide / 2), (1.5 * r, -1.2 * r, wide / 2),
            (1.9 * r, -1.05 * r, wide / 2)]  # fmt: skip
    curve = smooth(path, 5)
    tail = loft(np.stack([np.array([[x, y - 0.0006, 0], [x, y + 0.0006, 0], [x, y + 0.0006, wide],
                                    [x, y - 0.0006, wide]]) for x, y, _ in curve]),
                np.array([(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]))  # fmt: skip
    return put_down(
        [(join([coil, tail]), sheen), (core, surfaces.plain((244, 240, 230)))], coil, tail
    )


@category("tassel", size=(0.144, 0.0269, 0.0196), mass=0.01, material="fabric",
          aliases=("curtain tassel", "macrame knot", "tassel charm", "silk tassel"),
          themes=("craft",), colors=("gold",))  # fmt: skip
def tassel(look: Look) -> Shape:
    """A tassel with a loop, a bound head and a skirt of threads, lying flat."""
    color = look.color("gold", "crimson", "navy", "cream", "green", "purple", "black")
    k = look.between(0.8, 1.25)
    loop = rod([(0.02, 0.002, 0.002), (0.045, 0.009, 0.002), (0.055, 0, 0.002),
                (0.045, -0.009, 0.002), (0.02, -0.002, 0.002)], 0.0016, 6)  # fmt: skip
    head = ball(0.022, 0.02, 0.018, (0.012, 0, 0.0085), 14)
    band = drum(0.0085, 0.006, (-0.004, 0, 0.0085), 0, sides=14)
    skirt = rod(
        [(0.0, 0, 0.0082), (-0.03, 0, 0.0082), (-0.072, 0, 0.0075)], [0.0075, 0.0105, 0.012], 14
    )
    strands = surfaces.stripes([color, tint_color(color, 0.75)], 12, upright=True)
    return put_down([(join([loop, head]), plain(color)), (skirt.scale(1, 1, 0.85), strands),
                     (band, plain(tint_color(color, 0.6)))], head, skirt.scale(1, 1, 0.85),
                    factor=k, foot=0.3)  # fmt: skip


TONES = ("red", "teal", "navy", "mustard", "sage", "pink", "gray", "cream", "white", "terracotta")


@category("fabric_square", size=(0.185, 0.185, 0.0036), mass=0.015, material="fabric",
          aliases=("fabric", "piece of fabric", "piece of cloth", "cloth square", "handkerchief",
          "bandana", "hankie", "pocket square", "folded fabric", "microfiber cloth",
          "cleaning cloth", "fabric swatch", "patchwork square", "granny square", "crochet square",
          "leather strip", "laptop sleeve", "challah cover"), themes=("craft",), roles=("flat",),
          colors=("red", "teal"), state="lying flat")  # fmt: skip
def fabric_square(look: Look) -> Shape:
    """A square of printed cloth lying flat with one corner turned over."""
    side = look.between(0.15, 0.22)
    color = look.color(*TONES)
    tile = _cloth(look, color)
    h = side / 2
    cut = 0.3 * side
    sheet = prism([(-h, -h), (h, -h), (h, h - cut), (h - cut, h), (-h, h)], 0, 0.0018)
    flap = prism([(h, h - cut), (h - cut, h), (h - cut, h - cut)], 0.0018, 0.0036)
    return shape([(sheet, tile), (flap, surfaces.plain(tint_color(color, 1.35)))],
                 [box_part(side, side, 0.0018)])  # fmt: skip


@category("felt_sheet", size=(0.25, 0.18, 0.0028), mass=0.02, material="fabric",
          aliases=("sheet of felt", "felt square", "craft felt", "piece of felt", "felt pad",
          "kneeling pad", "kneeler"), themes=("craft",), roles=("flat", "support"),
          colors=("red", "green"), state="lying flat")  # fmt: skip
def felt_sheet(look: Look) -> Shape:
    """A sheet of felt lying flat."""
    x, y = look.between(0.2, 0.3), look.between(0.15, 0.21)
    color = look.color("red", "green", "blue", "yellow", "orange", "purple", "pink", "black")
    tile = surfaces.scratches(look.rng, color, tint_color(color, 0.85), 160)
    return shape([(block(x, y, 0.0028, 0.002), tile)], [box_part(x, y, 0.0028)])


HUES = ("red", "blue", "green", "yellow", "purple", "white", "black", "pink", "brown", "teal")
STEEL = (200, 204, 210)


@category("button", size=(0.025, 0.025, 0.0028), mass=0.0015, material="plastic",
          aliases=("shirt button", "coat button", "sewing button", "round button", "wooden button",
          "brass button", "peephole", "sequin", "press fastener", "press stud", "snap fastener"),
          themes=("craft",), roles=("round", "flat"), colors=("red", "blue"),
          state="lying flat")  # fmt: skip
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
    return shape([(disc, look.surface(color, "plastic")),
                  (join(holes), surfaces.plain(tint_color(color, 0.25)))],
                 [cylinder_part(r, t)])  # fmt: skip


@category("thimble", size=(0.021, 0.021, 0.0247), mass=0.004, material="metal",
          aliases=("metal thimble", "sewing thimble"), themes=("craft",), roles=("round",),
          colors=("silver",))  # fmt: skip
def thimble(look: Look) -> Shape:
    """A dimpled thimble standing on its rim."""
    color = look.color("silver", "gold", "brass", "copper", "white", "bronze")
    dots = prints.mesh_holes(color, tint_color(color, 0.7), 10, 26)
    body = lathe([(0, 0), (0.0092, 0), (0.0092, 0.0015), (0.0086, 0.0025), (0.0072, 0.018),
                  (0.005, 0.0222), (0, 0.023)], 26)  # fmt: skip
    rim = torus(0.0092, 0.0008, 26, 6).move(z=0.0008)
    made = shape([(body, dots), (rim, surfaces.plain(color))], [hull_of(body)])
    return made.scale(look.between(0.9, 1.25))


@category("needle", size=(0.066, 0.027, 0.0013), mass=0.0005, material="metal", assembled=True,
          aliases=("sewing needle", "needle and thread", "embroidery needle", "darning needle",
          "potter's needle", "needle threader"), themes=("craft",), colors=("red",),
          state="lying")  # fmt: skip
def needle(look: Look) -> Shape:
    """A sewing needle with a short thread through its eye, lying flat."""
    color = look.color(*HUES)
    long = look.between(0.045, 0.07)
    shaft = straight((-long / 2, 0, 0.0006), (0.42 * long, 0, 0.0006), [0.0002, 0.0006], 6)
    eye = torus(0.0016, 0.0005, 12, 5).scale(2.2, 1, 1).move(0.42 * long + 0.0034, 0, 0.0006)
    e = 0.42 * long + 0.0034
    thread = rod([(e, 0, 0.0008), (e + 0.012, 0.01, 0.0006), (e + 0.002, 0.022, 0.0006),
                  (e - 0.02, 0.018, 0.0006), (e - 0.034, 0.024, 0.0006)], 0.0005, 5)  # fmt: skip
    return put_down([(join([shaft, eye]), surfaces.plain(STEEL)), (thread, surfaces.plain(color))],
                   join([shaft, eye]), thread)  # fmt: skip


@category("pin", size=(0.05, 0.0046, 0.0046), mass=0.0002, material="metal", assembled=True,
          aliases=("sewing pin", "straight pin", "dressmaker pin", "ball pin", "inoculating loop"),
          themes=("craft",), colors=("red", "white"), state="lying")  # fmt: skip
def pin(look: Look) -> Shape:
    """A dressmaker's pin with a coloured ball as its head."""
    color = look.color(*HUES)
    long = look.between(0.032, 0.05)
    shaft = straight((-long / 2, 0, 0.0007), (long / 2, 0, 0.0019), [0.0002, 0.0005], 6)
    head = ball(0.004, 0.004, 0.004, (long / 2, 0, 0.0018), 12)
    return put_down([(shaft, surfaces.plain(STEEL)), (head, surfaces.speckles(look.rng, color, 3))],
                   shaft, head, factor=look.between(0.9, 1.4), foot=0.5)  # fmt: skip


@category("safety_pin", size=(0.057, 0.012, 0.0034), mass=0.001, material="metal", assembled=True,
          aliases=("safetypin", "diaper pin", "stitch holder", "french knitter"), themes=("craft",),
          colors=("silver",), state="lying flat")  # fmt: skip
def safety_pin(look: Look) -> Shape:
    """A closed safety pin with a bent wire, a coil and a cap, lying flat."""
    color = look.color("silver", "gold", "brass", "black", "copper")
    path = smooth([(0.024, 0.004, 0.0008), (-0.014, 0.005, 0.0008), (-0.02, 0.004, 0.0008),
                   (-0.0225, 0.0, 0.001), (-0.02, -0.004, 0.0008), (-0.014, -0.005, 0.0008),
                   (0.024, -0.0035, 0.0008)], 3)  # fmt: skip
    wire = tube(path, 0.0007, 6)
    coil = torus(0.0022, 0.0007, 14, 6).move(-0.0205, 0, 0.0016)
    cap = block(0.011, 0.011, 0.003, 0.004, 0.001).move(0.025)
    metal = surfaces.brushed_metal(look.rng, color)
    return put_down([(join([wire, coil]), metal), (cap, surfaces.plain(tint_color(color, 1.1)))],
                   wire, cap, factor=look.between(0.85, 1.3))  # fmt: skip


@category("knitting_needle", size=(0.235, 0.012, 0.0118), mass=0.012, material="wood",
          aliases=("knitting needles", "pair of knitting needles", "knitting pin",
          "circular needle", "double-pointed needle", "point protector"), themes=("craft",),
          colors=("wooden", "silver"), state="lying")  # fmt: skip
def knitting_needle(look: Look) -> Shape:
    """A knitting needle with a knob at its end, lying flat."""
    color = look.color("wooden", "silver", "red", "blue", "green", "purple", "tan")
    long, r = look.between(0.2, 0.26), look.between(0.0026, 0.0036)
    shaft = straight((-long / 2 + 0.012, 0, r), (long / 2, 0, r), r, 10)
    tip = straight((-long / 2, 0, r), (-long / 2 + 0.0121, 0, r), [0.0006, r], 10)
    knob = cylinder(0.006, 0.007, 16, bevel=0.0015).turn(1, np.pi / 2).move(long / 2, 0, 0.0058)
    return put_down([(join([shaft, tip]), look.surface(color, "wood" if color[0] > 190
                                                       else "metal")),
                     (knob, surfaces.plain(look.own_color("black", "red", "navy", "brown")))],
                    shaft, knob)  # fmt: skip


@category("crochet_hook", size=(0.145, 0.0088, 0.0084), mass=0.01, material="metal",
          aliases=("crochet needle", "crocheting hook"), themes=("craft",),
          colors=("silver", "pink"), state="lying")  # fmt: skip
def crochet_hook(look: Look) -> Shape:
    """A crochet hook lying flat, with its hook on the left and a flat grip in the middle."""
    color = look.color("silver", "gold", "pink", "blue", "purple", "wooden", "teal")
    long = look.between(0.13, 0.16)
    h = long / 2
    shaft = straight((-0.86 * h, 0, 0.0038), (-0.1 * h, 0, 0.0038), [0.0018, 0.0024], 10)
    hook = rod([(-0.85 * h, 0, 0.0038), (-0.97 * h, 0, 0.0038), (-h, 0.0022, 0.0038),
                (-0.955 * h, 0.004, 0.0038)], [0.0018, 0.0017, 0.0014, 0.0007], 8)  # fmt: skip
    grip = rod([(-0.12 * h, 0, 0.004), (0.2 * h, 0, 0.004), (0.7 * h, 0, 0.004), (h, 0, 0.004)],
               [0.003, 0.0044, 0.0044, 0.003], 12)  # fmt: skip
    return put_down([(join([shaft, hook]), surfaces.brushed_metal(look.rng, STEEL)),
                     (grip, look.surface(color, "plastic"))], join([shaft, hook]), grip,
                    foot=0.4)  # fmt: skip


@category("pin_cushion", size=(0.075, 0.075, 0.065), mass=0.04, material="fabric",
          aliases=("pincushion", "needle cushion", "pin holder", "needle case"), themes=("craft",),
          roles=("round",), colors=("red",))  # fmt: skip
def pin_cushion(look: Look) -> Shape:
    """A tomato-shaped pin cushion with pins stuck in it."""
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
    pieces: Pieces = [(body, surfaces.fabric(look.rng, color)),
                      (join(star), surfaces.plain((70, 120, 60))),
                      (join(shafts), surfaces.plain(STEEL))]  # fmt: skip
    pieces += [(join(h), surfaces.plain(look.own_color(*HUES))) for h in heads]
    return put_down(pieces, body, join(shafts))


@category("bobbin", size=(0.023, 0.023, 0.0125), mass=0.006, material="metal",
          aliases=("sewing bobbin", "thread bobbin", "sewing machine bobbin", "yarn winder",
          "wool winder", "spindle whorl"), themes=("craft",), roles=("round",),
          colors=("red", "blue"))  # fmt: skip
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
    wound = surfaces.knitting(look.rng, color, 30)
    return shape([(join(flanges), surfaces.brushed_metal(look.rng, STEEL)), (thread, wound),
                  (join([hub, *holes]), surfaces.plain((60, 60, 64)))],
                 [cylinder_part(r, h)])  # fmt: skip


@category("embroidery_hoop", size=(0.168, 0.185, 0.01), mass=0.06, material="fabric",
          aliases=("embroidery", "hoop", "cross stitch", "embroidery frame"), themes=("craft",),
          roles=("flat",), colors=("white",), state="lying flat")  # fmt: skip
def embroidery_hoop(look: Look) -> Shape:
    """An embroidery hoop lying flat: cloth with stitched flowers, stretched in a wooden ring."""
    color = look.color("white", "cream", "sky", "beige", "mint", "pink")
    r = look.between(0.07, 0.09)
    ring = lathe(
        [(r - 0.004, 0), (r + 0.004, 0), (r + 0.004, 0.01), (r - 0.004, 0.01)], 36, loop=True
    )
    image = surfaces.fabric(look.rng, color, threads=40).copy()
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
    return shape([(ring, surfaces.wood(look.rng, (214, 172, 120))), (sheet, image),
                  (screw, surfaces.plain((206, 172, 96)))],
                 [cylinder_part(r + 0.004, 0.01)])  # fmt: skip


@category("zipper", size=(0.18, 0.0269, 0.0052), mass=0.012, material="fabric",
          aliases=("zip", "zip fastener"), themes=("craft",), roles=("flat",),
          colors=("black", "red"), state="lying flat")  # fmt: skip
def zipper(look: Look) -> Shape:
    """A zip lying flat, with two tapes, a row of teeth and a slider near its end."""
    color = look.color(*HUES)
    long = look.between(0.16, 0.2)
    tapes = [box(long, 0.0125, 0.0012).move(0, s * 0.0072) for s in (-1, 1)]
    teeth = [box(0.0018, 0.0042, 0.0024).move(x, (-1) ** n * 0.0008)
             for n, x in enumerate(np.arange(-0.47 * long, 0.47 * long, 0.0031))]  # fmt: skip
    slide = block(0.012, 0.009, 0.0045, 0.003, 0.001).move(0.32 * long)
    tag = torus(0.005, 0.0012, 14, 6).scale(1.6, 0.8, 1).move(0.32 * long + 0.014, 0, 0.0038)
    metal = surfaces.brushed_metal(look.rng, look.pick([STEEL, (206, 172, 96)]))
    return shape(
        [(join(tapes), surfaces.fabric(look.rng, color)), (join([*teeth, slide, tag]), metal)],
        [box_part(long, 0.0269, 0.0022), hull_of(slide, tag)],
    )


@category("bead", size=(0.019, 0.0154, 0.0145), mass=0.002, material="plastic",
          aliases=("wooden bead", "glass bead", "plastic bead", "craft bead", "pearl bead"),
          themes=("craft",), colors=("red", "blue"), state="lying")  # fmt: skip
def bead(look: Look) -> Shape:
    """A single round, faceted or long bead with a horizontal hole."""
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
    skin = surfaces.speckles(look.rng, color, 4) if look.chance(0.6) else surfaces.stripes(
        [color, tint_color(color, 1.6)], 4)  # fmt: skip
    return put_down([(body, skin), (join(holes), surfaces.plain((40, 36, 36)))], body)


@category("yarn_skein", size=(0.16, 0.075, 0.068), mass=0.1, material="fabric", aliases=("skein",
          "skein of yarn", "hank of yarn", "skein of wool", "knitting wool", "wool", "wool skein",
          "wool roving", "skein of thread"), themes=("craft",), colors=("red", "blue"),
          state="lying")  # fmt: skip
def yarn_skein(look: Look) -> Shape:
    """A skein of yarn with a paper band around its middle, lying flat."""
    color = look.color(*HUES, "mustard", "sage", "gray")
    long, d = look.between(0.14, 0.18), look.between(0.06, 0.075)
    strands: list[Solid] = []
    for k in range(12):
        a = 2 * np.pi * k / 12
        y, z = 0.36 * d * np.cos(a), 0.34 * d * np.sin(a)
        path = [(-0.5 * long, 0.6 * y, 0.6 * z), (-0.3 * long, 1.15 * y, 1.15 * z),
                (0, 0.8 * y, 0.8 * z), (0.3 * long, 1.15 * y, 1.15 * z),
                (0.5 * long, 0.6 * y, 0.6 * z)]  # fmt: skip
        strands.append(rod(path, [0.006, 0.0105, 0.0105, 0.0105, 0.006], 7, 3))
    body = join([*strands, ellipsoid(long, 0.75 * d, 0.72 * d, 14, 8)]).move(z=0.46 * d)
    ribs = surfaces.knitting(look.rng, color, 20)
    band = cylinder(0.455 * d, 0.05, 26).move(z=-0.025).turn(1, np.pi / 2).move(z=0.46 * d)
    label = surfaces.stack((surfaces.plain((250, 248, 240)), 0.7), (surfaces.plain(
        tint_color(color, 0.7)), 0.3))  # fmt: skip
    return put_down([(body, ribs), (band, label)], body)


@category("sewing_machine", size=(0.36, 0.155, 0.285), mass=6.0, material="device",
          aliases=("toy sewing machine", "sewing-machine"), themes=("craft",),
          roles=("big", "tall"), colors=("white", "black"))  # fmt: skip
def sewing_machine(look: Look) -> Shape:
    """A sewing machine with a bed, an arm, a needle, a spool and a hand wheel on the right."""
    k = look.between(0.88, 1.0)
    color = look.color("white", "white", "black", "mint", "pink", "red", "cream", "sky")
    skin = surfaces.speckles(look.rng, color, 3, 32)
    trim = surfaces.speckles(
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
    metal = surfaces.brushed_metal(look.rng, (196, 199, 204))
    needle = [cylinder(0.0045 * k, 0.03 * k, 10).move(-0.13 * k, -0.005 * k, 0.108 * k),
              cylinder(0.0012 * k, 0.046 * k, 6).move(-0.13 * k, -0.005 * k, 0.064 * k),
              box(0.016 * k, 0.024 * k, 0.003 * k).move(-0.13 * k, -0.012 * k, 0.067 * k),
              box(0.003 * k, 0.004 * k, 0.05 * k).move(-0.12 * k, 0.0, 0.068 * k)]  # fmt: skip
    plate = box(0.08 * k, 0.07 * k, 0.0012).move(-0.13 * k, 0, 0.0648 * k)
    thread_color = look.own_color("red", "blue", "yellow", "green", "violet")
    spool = (lathe([(0, 0), (0.012, 0), (0.012, 0.004), (0.0095, 0.005), (0.0095, 0.031),
                    (0.012, 0.032), (0.012, 0.036), (0, 0.036)],
                   18).scale(k, k, k).move(0.06 * k, 0.03 * k, 0.268 * k))  # fmt: skip
    dial = [facing(cylinder(r * k, 0.01, 22, bevel=0.002)).move(x * k, -0.048 * k, z * k) for x, z,
            r in ((0.13, 0.17, 0.024), (0.13, 0.225, 0.016), (0.05, 0.225, 0.016))]  # fmt: skip
    face = prints.canvas(64, 64, (246, 246, 242))
    for n in range(12):
        a = n * np.pi / 6
        prints.stroke(face, [(0.5 + 0.3 * np.cos(a), 0.5 + 0.3 * np.sin(a)),
                             (0.5 + 0.44 * np.cos(a), 0.5 + 0.44 * np.sin(a))], 0.03,
                      (60, 60, 66))  # fmt: skip
    prints.fill(face, 0.46, 0.2, 0.08, 0.4, (60, 60, 66))
    pieces = [(join([bed, post, arm, head]), skin), (wheel, trim), (join([*needle, plate]), metal),
              (spool, surfaces.stripes([thread_color, tint_color(thread_color, 0.85)], 12)),
              *((d, face) for d in dial)]  # fmt: skip
    if look.chance(0.4):
        cloth = box(0.16 * k, 0.14 * k, 0.002).move(-0.15 * k, -0.03 * k, 0.0655 * k)
        pieces.append((cloth, surfaces.fabric(look.rng, look.own_color("sky", "red", "mustard",
                                                                       "sage"), (246, 244, 238),
                                              24)))  # fmt: skip
    return shape(pieces, [hull_of(bed), hull_of(post), hull_of(arm), hull_of(head), hull_of(wheel),
                          hull_of(spool)])  # fmt: skip


BRIGHT = ("red", "blue", "yellow", "green", "orange", "violet", "pink", "teal", "black")


@category("yarn_ball", size=(0.082, 0.082, 0.079), mass=0.06, material="fabric", friction=0.9,
          aliases=("ball of yarn", "yarn", "wool ball", "ball of wool", "string of beads",
          "garden twine"), themes=("craft",), roles=("round",), colors=("red", "teal", "pink"),
          common=True)  # fmt: skip
def yarn_ball(look: Look) -> Shape:
    """A ball of yarn with a few loose strands."""
    d = look.between(0.07, 0.09)
    color = look.color("red", "teal", "mustard", "pink", "violet", "cream", "blue")
    wool = surfaces.knitting(look.rng, color)
    ball = ellipsoid(d, d, 0.96 * d, 24, 14).bend(
        lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], -0.45 * d)])
    )
    pieces = [(ball.move(z=0.45 * d), wool)]
    for k in range(4):
        loop = torus(0.488 * d, 0.0028, 28, 6).turn(0, 0.6 + 0.55 * k).turn(2, 0.8 * k)
        pieces.append(
            (
                loop.move(z=0.455 * d + 0.0045),
                surfaces.plain(tint_color(color, 0.82 + 0.1 * (k % 3))),
            )
        )
    return shape(pieces, [resting_ball(d, d, 0.93 * d)])


@category("thread_spool", size=(0.032, 0.032, 0.05), mass=0.03, material="wood",
          aliases=("spool of thread", "spool", "thread", "sewing thread", "crab line",
          "cotton reel", "wool cone", "reel of cotton", "fishing line", "spool of fishing line"),
          themes=("craft",), roles=("round",),
          colors=("red", "blue", "yellow", "green", "orange", "violet", "pink", "teal", "black"),
          common=True)  # fmt: skip
def thread_spool(look: Look) -> Shape:
    """A wooden spool of thread, standing upright."""
    r, h = look.between(0.014, 0.018), look.between(0.045, 0.055)
    thread = surfaces.stripes([c := look.color(*BRIGHT, "pink", "teal"), tint_color(c, 0.8)], 14)
    wood = surfaces.wood(look.rng, (214, 176, 124))
    end = cylinder(r, 0.006, 20, bevel=0.0015)
    return shape([(end, wood), (end.move(z=h - 0.006), wood),
                  (cylinder(0.86 * r, h - 0.01, 20).move(z=0.005), thread)],
                 [cylinder_part(r, h)])  # fmt: skip


@category("button_tin", size=(0.08, 0.08, 0.036), mass=0.12, material="metal",
          aliases=("tin of buttons", "beads", "button box", "tin", "sewing tin"), themes=("craft",),
          roles=("round",), colors=("silver", "gold"), common=True)  # fmt: skip
def button_tin(look: Look) -> Shape:
    """An open round tin of buttons or beads."""
    r, h = look.between(0.036, 0.044), look.between(0.028, 0.036)
    metal = surfaces.brushed_metal(look.rng, look.color("silver", "gold", "teal", "copper"))
    body = cylinder(r, h, 28, bevel=0.002)
    well = cylinder(0.88 * r, 0.001, 28).move(z=h - 0.0004)
    pieces = [(body, metal), (well, surfaces.plain((74, 70, 68)))]
    for k in range(11):
        a, away = 2.4 * k, 0.72 * r * np.sqrt((k + 0.3) / 11)
        bead = cylinder(0.0055, 0.003, 10, bevel=0.001)
        spot = bead.move(away * np.cos(a), away * np.sin(a), h)
        pieces.append((spot, surfaces.plain(look.own_color(*BRIGHT, "pink", "white"))))
    rod = tube([(r + 0.001, 0, h - 0.006), (r + 0.001, 0, 0.004)], 0.0012, 6)
    return shape([*pieces, (rod, metal)], [cylinder_part(r, h + 0.0015)])
