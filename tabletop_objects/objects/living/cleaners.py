"""Objects of the ``living`` theme: cleaning supplies."""

from __future__ import annotations

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import DARK
from ...kit.parts import hull_of, open_vessel
from ...kit.primitives import at_box, ball, drum, pad, plate, rod, side_view, standing, straight
from ...kit.shapes import Shape, category, put_down, shape, vessel_shape
from ...kit.solids import Solid, block, box, join, prism, torus
from ...kit.surfaces import Look, plain, readable_on, tint_color


@category("potty", size=(0.209, 0.209, 0.171), mass=0.3, material="plastic", hollow=True,
          aliases=("baby potty", "child's potty", "chamber pot"), themes=("living",),
          roles=("container", "big"), colors=("blue", "pink"))  # fmt: skip
def potty(look: Look) -> Shape:
    """A child's potty with a raised back, open at the top."""
    color = look.color("blue", "pink", "green", "white", "yellow")
    k = look.between(0.75, 0.95)
    profile = [(0.1, 0), (0.098, 0.01), (0.09, 0.09), (0.12, 0.125), (0.125, 0.13)]
    back = (plate([(-0.07, 0), (0.07, 0), (0.05, 0.07), (0, 0.085), (-0.05, 0.07)],
                  0.012).turn(0, np.pi / 2).move(0, 0.118, 0.12))  # fmt: skip
    return vessel_shape(profile, 0.02, 0.02, plain(color),
                        extra=[(back, plain(tint_color(color, 0.85)))], bodies=[back],
                        factor=k)  # fmt: skip


@category("plunger", size=(0.0987, 0.0992, 0.274), mass=0.3, material="wood", assembled=True,
          aliases=("sink plunger", "toilet plunger", "drain plunger"), themes=("living",),
          roles=("tall",), colors=("red",))  # fmt: skip
def plunger(look: Look) -> Shape:
    """A plunger, standing on its rubber cup."""
    color = look.color("red", "black", "terracotta", "blue")
    k = look.between(0.7, 0.9)
    cup = standing((0.055, 0), (0.06, 0.006), (0.058, 0.03), (0.04, 0.062), (0.018, 0.075),
                   (0.016, 0.09), sides=28)  # fmt: skip
    rim = torus(0.058, 0.004, 30, 6).move(z=0.012)
    stick = drum(0.0105, 0.26, (0, 0, 0.07), top=0.0115, sides=16)
    end = ball(0.026, 0.026, 0.026, (0, 0, 0.33), 14)
    return put_down([(join([cup, rim]), surfaces.speckles(look.rng, color, 4)),
                     (join([stick, end]), surfaces.wood(look.rng, (222, 186, 132)))], cup, stick,
                    factor=k)  # fmt: skip


@category("squeegee", size=(0.224, 0.24, 0.0254), mass=0.12, material="plastic", assembled=True,
          aliases=("window squeegee", "shower squeegee", "window wiper"), themes=("living",),
          roles=("big",), colors=("blue",))  # fmt: skip
def squeegee(look: Look) -> Shape:
    """A squeegee lying flat: a rubber blade in a bar, and a handle."""
    color = look.color("blue", "green", "black", "silver", "yellow")
    k = look.between(0.8, 1.05)
    rail = at_box(0.022, 0.25, 0.014, (0.09, 0, 0.002))
    blade = at_box(0.02, 0.255, 0.004, (0.108, 0, 0.006))
    neck = plate([(0.0, -0.012), (0.085, -0.03), (0.085, 0.03), (0.0, 0.012)], 0.014)
    handle = rod(
        [(0.02, 0, 0.012), (-0.05, 0, 0.013), (-0.12, 0, 0.012)], [0.012, 0.014, 0.0115], 12
    )
    return put_down([(join([rail, neck]), plain(color)), (blade, plain((40, 40, 44))),
                     (handle, plain(tint_color(color, 0.75)))], join([rail, blade]), handle, neck,
                    factor=k, foot=0.15)  # fmt: skip


@category("lint_roller", size=(0.213, 0.0456, 0.0449), mass=0.1, material="plastic",
          aliases=("sticky roller", "lint remover", "clothes roller"), themes=("living",),
          colors=("pink", "blue"))  # fmt: skip
def lint_roller(look: Look) -> Shape:
    """A lint roller with a bent handle, lying flat."""
    color = look.color("pink", "blue", "white", "green", "black")
    k = look.between(0.85, 1.1)
    paper = drum(0.024, 0.1, (-0.02, 0, 0.0235), 0, sides=26)
    core = [drum(0.019, 0.004, (x, 0, 0.0235), 0, sides=22) for x in (-0.024, 0.08)]
    handle = rod([(-0.02, 0, 0.0235), (-0.05, 0, 0.024), (-0.1, 0, 0.014), (-0.14, 0, 0.012)],
                 [0.006, 0.01, 0.013, 0.0115], 12)  # fmt: skip
    lines = surfaces.stripes([(244, 244, 240), (226, 232, 236)], 10, upright=True)
    return put_down(
        [(paper, lines), (join([*core, handle]), plain(color))], paper, handle, factor=k, foot=0.2
    )


@category("robot_vacuum", size=(0.283, 0.276, 0.0775), mass=2.2, material="device",
          aliases=("robot vacuum cleaner", "robotic vacuum", "roomba", "robot hoover"),
          themes=("living",), roles=("flat", "big"), colors=("black", "white"))  # fmt: skip
def robot_vacuum(look: Look) -> Shape:
    """A robot vacuum cleaner: a low disc with a bumper, a button and a turret."""
    color = look.color("black", "white", "charcoal", "gray")
    k = look.between(0.75, 0.95)
    foot, body = (drum(0.13, 0.012), standing((0.155, 0.0), (0.158, 0.008), (0.158, 0.055),
                                              (0.15, 0.066), at=(0, 0, 0.008),
                                              sides=36))  # fmt: skip
    band = torus(0.157, 0.005, 40, 6).scale(1, 1, 3).move(z=0.04)
    top = drum(0.12, 0.002, (0, 0, 0.0735), sides=36)
    turret = drum(0.036, 0.018, (0, 0.06, 0.073), sides=26, bevel=0.003)
    keys = [drum(0.012, 0.003, (0.0, -0.06, 0.0745)), drum(0.007, 0.003, (0.03, -0.06, 0.0745)),
            drum(0.007, 0.003, (-0.03, -0.06, 0.0745))]  # fmt: skip
    brush = [at_box(0.05, 0.004, 0.004, (0.025, 0, 0)).turn(2, 2.1 * n).move(0.12, -0.1, 0.003)
             for n in range(3)]  # fmt: skip
    shade = tint_color(color, 1.25 if sum(color) < 300 else 0.9)
    return put_down([(join([foot, body]), surfaces.speckles(look.rng, color, 3)),
                     (join([band, turret]), plain(DARK)), (top, plain(shade)),
                     (join(keys), plain((120, 190, 220))), (join(brush), plain((210, 90, 50)))],
                    foot, body, turret, factor=k)  # fmt: skip


@category("hand_vacuum", size=(0.318, 0.0839, 0.136), mass=0.9, material="device",
          aliases=("handheld vacuum", "hand-held vacuum", "vacuum cleaner",
          "handheld vacuum cleaner", "dustbuster", "hoover", "mini vacuum"), themes=("living",),
          roles=("big",), colors=("red", "gray"))  # fmt: skip
def hand_vacuum(look: Look) -> Shape:
    """A hand-held vacuum cleaner lying flat, with a clear nose, a body and a handle."""
    color = look.color("red", "gray", "blue", "white", "purple")
    k = look.between(0.75, 0.95)
    nose = side_view([(0.05, 0.0), (0.18, 0.0), (0.175, 0.025), (0.05, 0.095)], 0.085)
    body = block(0.13, 0.098, 0.098, 0.03, 0.012).move(-0.01, 0, 0.0)
    tail = rod([(-0.06, 0, 0.05), (-0.12, 0, 0.06), (-0.18, 0, 0.035)], [0.034, 0.026, 0.022], 12)
    handle = rod([(0.03, 0, 0.095), (0.0, 0, 0.14), (-0.08, 0, 0.14), (-0.13, 0, 0.075)], 0.013, 10)
    button = at_box(0.024, 0.014, 0.006, (-0.02, 0, 0.151))
    lip = at_box(0.008, 0.087, 0.026, (0.178, 0, 0))
    return put_down([(join([body, tail, handle]), plain(color)), (nose, plain((176, 184, 190))),
                     (join([button, lip]), plain(DARK))], nose, body, tail, handle,
                    factor=k)  # fmt: skip


@category("mop_head", size=(0.225, 0.249, 0.0311), mass=0.25, material="fabric",
          aliases=("mop", "string mop", "floor mop"), themes=("living",), roles=("big",),
          colors=("white",))  # fmt: skip
def mop_head(look: Look) -> Shape:
    """A mop head lying flat: strings spread out from a socket."""
    color = look.color("white", "cream", "sky", "gray")
    k = look.between(0.8, 1.05)
    cords = []
    for n in range(26):
        a = -1.1 + 2.2 * n / 25
        long, lift = look.between(0.13, 0.17), 0.006 + 0.006 * (n % 3)
        path = [(0, 0.2 * 0.03 * a, 0.022), (0.04 * np.cos(a), 0.05 * np.sin(a), 0.018 + lift
                                             * 0.5), (long * np.cos(a), long * np.sin(a),
                                                      0.0055)]  # fmt: skip
        cords.append(rod(path, [0.008, 0.0075, 0.0055], 6, 3))
    clamp = block(0.03, 0.06, 0.034, 0.008, 0.004)
    socket = drum(0.015, 0.07, (-0.085, 0, 0.017), 0, top=0.018, sides=18)
    yarn = surfaces.knitting(look.rng, color, 20)
    tone = look.own_color("blue", "red", "green", "yellow")
    return put_down([(join(cords), yarn), (join([clamp, socket]), plain(tone))], join(cords), clamp,
                    socket, factor=k, foot=0.15)  # fmt: skip


@category("broom_head", size=(0.208, 0.0432, 0.108), mass=0.3, material="wood",
          aliases=("brush head", "floor brush", "sweeping brush"), themes=("living",),
          roles=("big",), colors=("red", "blue"))  # fmt: skip
def broom_head(look: Look) -> Shape:
    """A broom head with a socket for a stick, standing on its bristles."""
    color = look.color("red", "blue", "wooden", "green", "black")
    k = look.between(0.7, 0.9)
    top = block(0.27, 0.055, 0.026, 0.02, 0.006).move(z=0.072)
    tufts = [drum(0.0105, 0.078, (x, y, 0), top=0.0075, sides=8)
             for x in np.linspace(-0.12, 0.12, 12) for y in (-0.016, 0.002, 0.018)]  # fmt: skip
    socket = drum(0.02, 0.045, (0, 0, 0.095), top=0.015, sides=18)
    hole = drum(0.0115, 0.001, (0, 0, 0.1396))
    tone = look.own_color("tan", "mustard", "gray", "black")
    return put_down([(join([top, socket]), look.surface(color, "plastic")),
                     (join(tufts), surfaces.scratches(look.rng, tone, tint_color(tone, 0.7), 90)),
                     (hole, plain(DARK))], top, join(tufts), socket, factor=k)  # fmt: skip


@category("hand_brush", size=(0.243, 0.0484, 0.0683), mass=0.12, material="wood",
          aliases=("dustpan brush", "banister brush", "bench brush", "crumb sweeper",
          "table brush"), themes=("living",), colors=("red", "wooden"))  # fmt: skip
def hand_brush(look: Look) -> Shape:
    """A hand brush, lying on its bristles."""
    color = look.color("red", "wooden", "blue", "green", "tan")
    k = look.between(0.8, 1.05)
    head = block(0.15, 0.05, 0.018, 0.014, 0.005).move(0.05, 0, 0.05)
    handle = rod(
        [(-0.02, 0, 0.058), (-0.07, 0, 0.056), (-0.13, 0, 0.052)], [0.014, 0.011, 0.0135], 12
    )
    tufts = [drum(0.0095, 0.055, (x, y, 0), top=0.007, sides=8)
             for x in np.linspace(-0.012, 0.112, 8) for y in (-0.016, 0, 0.016)]  # fmt: skip
    tone = look.own_color("black", "tan", "cream", "brown")
    return put_down([(join([head, handle]), look.surface(color, "wood")),
                     (join(tufts), surfaces.scratches(look.rng, tone, tint_color(tone, 0.7), 90))],
                    join(tufts), head, handle, factor=k)  # fmt: skip


@category("wet_wipes", size=(0.184, 0.0977, 0.0515), mass=0.3, material="plastic",
          aliases=("wet wipe packet", "pack of wet wipes", "baby wipes", "packet of wet wipes",
          "pack of baby wipes"), themes=("living",), colors=("sky",),
          state="lying flat")  # fmt: skip
def wet_wipes(look: Look) -> Shape:
    """A soft packet of wet wipes lying flat, with a flip lid on top."""
    k, color = look.between(0.9, 1.1), look.color("sky", "white", "mint", "pink", "lavender")
    body = pad(0.17 * k, 0.1 * k, 0.045 * k, 0.014 * k, soft=0.5)
    seams = [box(0.012 * k, 0.1 * k, 0.003).move(s * 0.088 * k, 0, 0.02 * k) for s in (-1, 1)]
    lid = block(0.085 * k, 0.055 * k, 0.008, 0.014 * k, 0.002).move(z=0.0445 * k)
    image = prints.canvas(180, 110, color)
    prints.fill(image, 0, 0.82, 1, 0.18, tint_color(color, 0.7))
    prints.write(image, look.pick(["WIPES", "BABY WIPES", "FRESH"]), 0.5, 0.9, 0.14,
                 readable_on(tint_color(color, 0.7)), bold=True)  # fmt: skip
    for n in range(5):
        prints.disc(image, 0.08 + 0.03 * (n % 2), 0.1 + 0.15 * n, 0.04, (250, 250, 250))
    face = box(0.15 * k, 0.084 * k, 0.0006).move(z=0.0448 * k)
    return shape([(join([body, *seams]), surfaces.speckles(look.rng, color, 3)), (face, image),
                  (lid, surfaces.plain(tint_color(color, 0.75)))],
                 [hull_of(body, lid)])  # fmt: skip


TONES = ("red", "blue", "green", "yellow", "teal", "pink", "gray", "orange")
STEEL = (196, 200, 206)


@category("bucket", size=(0.18, 0.19, 0.145), mass=0.3, material="plastic", hollow=True,
          aliases=("pail", "small bucket", "plastic bucket", "metal bucket", "sand bucket",
          "toy bucket", "beach bucket", "cleaning bucket", "coal scuttle", "scuttle", "spittoon",
          "bait bucket", "ice pail"), themes=("living",), roles=("container", "round"),
          colors=("red", "blue"))  # fmt: skip
def bucket(look: Look) -> Shape:
    """A bucket with its handle hanging down at the back."""
    r, h = look.between(0.075, 0.095), look.between(0.13, 0.16)
    color = look.color(*TONES, "silver")
    body, parts = open_vessel([(0.72 * r, 0), (0.86 * r, 0.5 * h), (r, h)], 0.0035, 0.004)
    rim = torus(r, 0.0042, 32, 8).move(z=h - 0.003)
    lugs = [ball(0.014, 0.02, 0.02, (s * 0.97 * r, 0, h - 0.016), 10) for s in (-1, 1)]
    bail = rod([(-r, 0, h - 0.014), (-0.8 * r, 0.9 * r, h - 0.045), (0, 1.13 * r, h - 0.06),
                (0.8 * r, 0.9 * r, h - 0.045), (r, 0, h - 0.014)], 0.0026, 7)  # fmt: skip
    return shape([(body, look.surface(color, "plastic")),
                  (join([rim, *lugs]), surfaces.plain(tint_color(color, 0.8))),
                  (bail, surfaces.plain((206, 208, 212)))], parts)  # fmt: skip


@category("duster", size=(0.3, 0.09, 0.08), mass=0.08, material="fabric", assembled=True,
          aliases=("feather duster", "dust brush", "bundle of dusters", "lint brush"),
          themes=("living",), colors=("pink", "blue"), state="lying")  # fmt: skip
def duster(look: Look) -> Shape:
    """A feather duster, lying flat."""
    color = look.color("pink", "blue", "purple", "yellow", "green", "gray", "orange")
    grip = straight((0.02, 0, 0.012), (0.17, 0, 0.009), [0.008, 0.0085], 10)
    puffs: list[Solid] = [ball(0.15, 0.075, 0.07, (-0.05, 0, 0.034), 16)]
    for k in range(24):
        t = k / 23
        a = 2.4 * k
        r = 0.036 * np.sin(np.pi * (0.15 + 0.75 * t))
        puffs.append(ball(0.045, 0.022, 0.02, (0.02 - 0.145 * t, r * np.cos(a), 0.034 + 0.95 * r
                                               * np.sin(a)), 8))  # fmt: skip
    fluff = surfaces.scratches(look.rng, color, tint_color(color, 0.75), 140)
    return put_down([(join(puffs), fluff), (grip, surfaces.plain(look.own_color("white", "black",
                    "wooden")))], join(puffs), grip, factor=look.between(0.9, 1.15))  # fmt: skip


@category("clothes_peg", size=(0.075, 0.0195, 0.0093), mass=0.008, material="wood",
          aliases=("clothespin", "clothes pin", "washing peg", "laundry peg", "clothes clip",
          "spring clip", "wonder clip", "curtain clip", "nose clip", "mosquito net clip",
          "pram clip", "waders clip"), themes=("living",), colors=("wooden",),
          state="lying")  # fmt: skip
def clothes_peg(look: Look) -> Shape:
    """A clothes peg lying on its side: two legs and a spring."""
    color = look.color("wooden", "wooden", *TONES)
    half = [(-0.036, 0.0006), (0.014, 0.0006), (0.038, 0.006), (0.038, 0.0095), (0.004, 0.0065),
            (-0.036, 0.0055)]  # fmt: skip
    legs = [prism(half, 0, 0.009), prism([(x, -y) for x, y in half][::-1], 0, 0.009)]
    spring = [torus(0.004, 0.0011, 14, 6).move(0.006, 0, z) for z in (0.0022, 0.0045, 0.0068)]
    arms = [straight((0.008, s * 0.004, 0.0045), (-0.008, s * 0.0065, 0.0045), 0.001, 6)
            for s in (-1, 1)]  # fmt: skip
    return put_down([(join(legs), look.surface(color, "wood" if color[0] > 180 and color[2] < 120
                    else "plastic")), (join([*spring, *arms]), surfaces.plain(STEEL))], join(legs),
                   factor=look.between(0.85, 1.2))  # fmt: skip
