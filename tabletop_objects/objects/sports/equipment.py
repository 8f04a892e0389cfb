"""Objects of the ``sports`` theme: equipment."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import DARK, leather, steel
from ...kit.outlines import arc, ellipse, smooth
from ...kit.parts import box_part, cylinder_part, flat_foot, hull_of, ring_parts
from ...kit.primitives import (
    at_box,
    ball,
    drum,
    facing,
    lay_down,
    lies,
    pad,
    plate,
    rod,
    side_view,
    standing,
    straight,
)
from ...kit.shapes import Category, Shape, category, put_down, shape, vary
from ...kit.solids import Solid, block, box, cylinder, join, lathe, prism, torus, tube
from ...kit.surfaces import Look, plain, readable_on, tint_color


@category("dumbbell", size=(0.22, 0.085, 0.087), mass=3.0, material="metal",
          aliases=("hand weight", "weight", "barbell", "free weight"), themes=("sports",),
          colors=("black", "pink"), state="lying flat", common=True)  # fmt: skip
def dumbbell(look: Look) -> Shape:
    """A dumbbell with six-sided or round heads."""
    length, r = look.between(0.18, 0.26), look.between(0.038, 0.055)
    color = look.color("black", "charcoal", "pink", "teal", "purple", "blue", "red")
    head = look.between(0.055, 0.075)
    hexed = look.chance(0.6)
    end = cylinder(r, head, 6 if hexed else 28, bevel=0.006)
    low = float(lay_down(end).vertices[:, 2].min())
    heads = [lay_down(end, s, -low) for s in (-length / 2, length / 2 - head)]
    grip = lay_down(lathe([(0, 0), (0.013, 0), (0.0165, 0.5 * (length - head)),
                           (0.013, length - head), (0, length - head)], 16), -(length - head) / 2,
                    -low)  # fmt: skip
    face = prints.canvas(64, 64, color)
    weight = look.pick(["2", "3", "5", "8"])
    prints.write(face, weight, 0.5, 0.5, 0.5, readable_on(color), bold=True)
    disc = box(0.8 * r, 0.8 * r, 0.001)
    plates = [disc.turn(1, s * np.pi / 2).turn(0, np.pi / 2 * s)
              .move(s * length / 2, 0, -low) for s in (-1, 1)]  # fmt: skip
    steel = surfaces.grid((120, 122, 126), (186, 188, 192), 24, 24, 96)
    rubber = surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.15)
    return shape(
        [(join(heads), rubber), (grip, steel), (join(plates), face)],
        [*(hull_of(h) for h in heads), box_part(length - head, 0.024, 0.024, (0, 0, -low - 0.012))],
    )


BRIGHT = ("red", "blue", "yellow", "green", "orange", "purple", "pink", "teal")


@category("table_tennis_bat", size=(0.15, 0.243, 0.02), mass=0.17, material="wood", friction=0.6,
          aliases=("ping pong paddle", "table tennis paddle", "table tennis racket",
          "ping pong bat", "ping pong racket", "ping-pong paddle", "paddle"), themes=("sports",),
          roles=("flat",), colors=("red",), state="lying flat")  # fmt: skip
def table_tennis_bat(look: Look) -> Shape:
    """A table tennis bat lying with its rubber up."""
    k = look.between(0.95, 1.06)
    color = look.color("red", "black", "red", "blue", "green")
    blade = ellipse(0.15, 0.155, 36) * k
    wood = surfaces.wood(look.rng, (214, 176, 122), side=64)
    grip = block(0.03 * k, 0.1 * k, 0.02 * k, 0.008, 0.004).move(y=-0.115 * k)
    cut = blade[blade[:, 1] > -0.052 * k]
    start = int(np.argmax(np.linalg.norm(np.diff(cut, axis=0), axis=1))) + 1
    rubber = np.roll(cut, -start, 0)
    return shape(
        [(prism(blade, 0.005 * k, 0.0115 * k), wood), (grip, wood),
         (prism(rubber, 0.0115 * k, 0.0145 * k), surfaces.speckles(look.rng, color, 4, 32)),
         (prism(rubber, 0.002 * k, 0.005 * k), surfaces.plain((40, 38, 40))),
         (box(0.012 * k, 0.085 * k, 0.0008).move(y=-0.115 * k, z=0.0197 * k),
          surfaces.plain(look.own_color("red", "black", "navy")))],
        [hull_of(prism(rubber, 0.002 * k, 0.0145 * k)), hull_of(grip)])  # fmt: skip


@category("skipping_rope", size=(0.165, 0.185, 0.024), mass=0.12, material="plastic",
          assembled=True, friction=0.6,
          aliases=("jump rope", "jumping rope", "skip rope", "jumprope"), themes=("sports",),
          colors=("red",))  # fmt: skip
def skipping_rope(look: Look) -> Shape:
    """A skipping rope lying in loops with its two handles side by side."""
    k = look.between(0.94, 1.06)
    color = look.color(*BRIGHT)
    t = np.linspace(0, 1, 110)
    a = 2 * np.pi * 3 * t
    away = 0.055 + 0.008 * np.sin(2.3 * a)
    way = np.column_stack([1.25 * away * np.cos(a), away * np.sin(a),
                           0.0035 + 0.007 * np.abs(np.sin(1.5 * a + 0.4))]) * k  # fmt: skip
    way = np.concatenate([[(0.06 * k, -0.075 * k, 0.006)], way, [(0.06 * k, -0.105 * k, 0.006)]])
    rope = tube(way, 0.003 * k, 5)
    grips = [lathe(np.array([(0, 0), (0.008, 0), (0.0105, 0.02), (0.0095, 0.07), (0.012, 0.1),
                             (0, 0.102)]) * k, 14).turn(1, np.pi / 2)
             .move(-0.045 * k, y * k, 0.012 * k) for y in (-0.075, -0.105)]  # fmt: skip
    ends = [s.turn(2, np.pi).move(y=-2 * 0.09 * k) for s in grips]
    wood = look.surface(color, look.pick(["wood", "plastic"]))
    strands = surfaces.stripes([(240, 236, 226), tint_color(color, 1.3)], 16, side=128)
    return shape([(rope, strands), (join(ends), wood)],
                 [*(hull_of(s) for s in ends),
                  *ring_parts([(0.057 * k, 0.0006), (0.057 * k, 0.0095 * k)],
                              [(0.047 * k, 0.0095 * k), (0.047 * k, 0.0006)], 10,
                              stretch=(1.25, 1.0))])  # fmt: skip


RESISTANCE_BAND_BRIGHT = ("red", "blue", "green", "yellow", "orange", "purple", "black", "pink")


@category("foam_roller", size=(0.119, 0.119, 0.266), mass=0.3, material="rubber",
          aliases=("massage roller", "fitness roller", "exercise roller"), themes=("sports",),
          roles=("tall", "round"), colors=("black", "blue"))  # fmt: skip
def foam_roller(look: Look) -> Shape:
    """A ribbed foam roller, standing on its end."""
    color = look.color("black", "teal", "purple", "orange", "blue", "gray")
    k = look.between(0.8, 1.15)
    outer = [(0.058, 0), (0.06, 0.004)]
    for n in range(5):
        z = 0.02 + 0.05 * n
        outer += [(0.062, z), (0.062, z + 0.034), (0.057, z + 0.037), (0.057, z + 0.047)]
    outer += [(0.062, 0.27), (0.058, 0.276)]
    body = lathe([(0, 0), *outer, (0.042, 0.276), (0.042, 0.262), (0, 0.262)], 30)
    inner = drum(0.041, 0.0008, (0, 0, 0.2616))
    return put_down(
        [(body, surfaces.speckles(look.rng, color, 8)), (inner, plain(DARK))], body, factor=k
    )


@category("resistance_band", size=(0.185, 0.111, 0.0234), mass=0.04, material="rubber",
          aliases=("exercise band", "loop band", "workout band"), themes=("sports",),
          colors=("red", "blue"))  # fmt: skip
def resistance_band(look: Look) -> Shape:
    """A flat rubber exercise band, lying in an oval loop."""
    color = look.color(*RESISTANCE_BAND_BRIGHT)
    k = look.between(0.8, 1.2)
    a = np.linspace(0, 2 * np.pi, 41)[:-1]
    wave = look.between(0.0, 0.2)
    r = 1 + wave * np.cos(2 * a + 0.5) + 0.5 * wave * np.cos(3 * a)
    path = np.column_stack([0.09 * r * np.cos(a), 0.06 * r * np.sin(a), 0.0125 + 0 * a])
    ring = tube(path, 0.0024, 8, loop=True, squash=5.2)
    bits = [tube(np.roll(path, -5 * n, 0)[:7], 0.0024, 8, squash=5.2) for n in range(8)]
    return put_down([(ring, surfaces.speckles(look.rng, color, 4))], *bits, factor=k)


@category("juggling_club", size=(0.348, 0.0728, 0.0699), mass=0.2, material="plastic",
          aliases=("juggling pin", "indian club", "exercise club"), themes=("sports", "toys"),
          roles=("big",), colors=("red", "blue"))  # fmt: skip
def juggling_club(look: Look) -> Shape:
    """A juggling club with coloured rings, lying flat."""
    color = look.color("red", "blue", "yellow", "green", "pink", "orange", "white")
    k = look.between(0.75, 1.0)
    profile = [(0.011, 0), (0.016, 0.008), (0.012, 0.02), (0.011, 0.1), (0.02, 0.16), (0.042, 0.26),
               (0.043, 0.31), (0.03, 0.38), (0.018, 0.4)]  # fmt: skip
    bands = surfaces.stack((plain((240, 240, 236)), 0.3), (plain(color), 0.42),
                           (plain(tint_color(color, 0.6)), 0.06),
                           (plain((244, 240, 230)), 0.22))  # fmt: skip
    body = lies(standing(*profile, sides=22), -0.2, 0, 0.04)
    knob = ball(0.03, 0.03, 0.03, (-0.196, 0, 0.014), 12)
    body = body.bend(
        lambda p: np.column_stack(
            [p[:, :2], p[:, 2] - 0.024 * np.clip((0.06 - p[:, 0]) / 0.26, 0, 1)]
        )
    )
    return put_down([(body, bands), (knob, plain((60, 60, 64)))], body, knob, factor=k, foot=0.16)


@category("golf_club", size=(0.375, 0.0543, 0.0222), mass=0.25, material="metal", assembled=True,
          aliases=("golf putter", "putter", "golf iron", "golf driver", "mini golf club",
          "toy golf club"), themes=("sports",), roles=("big",), colors=("silver",))  # fmt: skip
def golf_club(look: Look) -> Shape:
    """A short golf club lying flat: a head, a shaft and a grip."""
    color = look.color("silver", "black", "gold", "charcoal")
    k = look.between(0.4, 0.5)
    shaft = straight((-0.32, 0, 0.012), (0.42, 0, 0.012), [0.006, 0.0075], 10)
    grip = straight((0.2, 0, 0.012), (0.43, 0, 0.012), [0.0105, 0.0125], 12)
    if look.chance(0.5):
        head = plate([(-0.36, -0.1), (-0.31, -0.1), (-0.305, 0.012), (-0.335, 0.014)], 0.03,
                     at=(0, 0, 0), bevel=0.004)  # fmt: skip
    else:
        head = ball(0.09, 0.12, 0.06, (-0.34, -0.045, 0.028), 18)
    neck = straight((-0.325, 0, 0.012), (-0.3, 0, 0.012), 0.0095, 10)
    return put_down([(shaft, steel(look)), (grip, surfaces.scratches(look.rng, (44, 44, 48),
                                                                     (90, 90, 94), 60)),
                     (join([head, neck]), look.surface(color, "metal"))], shaft, grip, head,
                    factor=k, foot=0.3)  # fmt: skip


@category("cricket_stumps", size=(0.108, 0.0542, 0.235), mass=0.2, material="wood", assembled=True,
          aliases=("cricket stump", "wicket", "cricket wicket", "cricket bail", "set of stumps"),
          themes=("sports",), roles=("tall",), colors=("wooden",))  # fmt: skip
def cricket_stumps(look: Look) -> Shape:
    """Three cricket stumps in a base, with two bails on top."""
    color = look.color("wooden", "tan", "yellow", "red", "blue")
    k = look.between(0.85, 1.15)
    base = block(0.1, 0.05, 0.014, 0.006, 0.003)
    stumps = [drum(0.006, 0.2, (x, 0, 0.012), sides=14) for x in (-0.034, 0, 0.034)]
    bails = [
        straight((x - 0.017, 0, 0.2135), (x + 0.017, 0, 0.2135), 0.003, 8) for x in (-0.018, 0.018)
    ]
    wood = look.surface(color, "wood")
    return put_down([(base, plain(look.own_color("black", "green", "charcoal"))),
                     (join([*stumps, *bails]), wood)], base, join(stumps), factor=k)  # fmt: skip


@category("arrow", size=(0.381, 0.0205, 0.0137), mass=0.03, material="wood", assembled=True,
          aliases=("archery arrow", "wooden arrow", "crossbow bolt"), themes=("sports",),
          roles=("big",), colors=("red", "yellow"))  # fmt: skip
def arrow(look: Look) -> Shape:
    """An arrow lying flat: a shaft, a point and three feathers."""
    color = look.color("red", "yellow", "green", "white", "blue", "orange")
    k = look.between(0.45, 0.62)
    shaft = straight((-0.32, 0, 0.009), (0.34, 0, 0.009), 0.0042, 10)
    tip = lies(standing((0.0055, 0), (0.0055, 0.02), (0.0008, 0.045), sides=12), 0.33, 0, 0.009)
    vane = [(-0.31, 0.003), (-0.23, 0.003), (-0.25, 0.016), (-0.315, 0.02)]
    vanes = [plate(np.array(vane) * [1, t] if t > 0 else (np.array(vane) * [1, t])[::-1],
                   0.0012).turn(0, t * lean).move(z=0.009) for t, lean in ((1, 0.3), (-1, 0.3),
                                                                           (1, 1.57))]  # fmt: skip
    nock = drum(0.005, 0.014, (-0.334, 0, 0.009), 0, sides=10)
    return put_down([(shaft, surfaces.wood(look.rng, (206, 168, 112))), (tip, steel(look)),
                     (join(vanes), plain(color)), (nock, plain(tint_color(color, 0.7)))],
                    straight((-0.33, 0, 0.0085), (0.37, 0, 0.0085), 0.0045, 8), join(vanes),
                    factor=k, foot=0.5)  # fmt: skip


@category("quiver", size=(0.115, 0.0854, 0.25), mass=0.3, material="leather", assembled=True,
          aliases=("arrow quiver", "quiver of arrows"), themes=("sports",), roles=("tall",),
          colors=("brown",))  # fmt: skip
def quiver(look: Look) -> Shape:
    """An upright leather quiver with a few arrows in it."""
    color = look.color("brown", "tan", "black", "maroon")
    k = look.between(0.85, 1.15)
    body = drum(0.032, 0.17, top=0.04)
    bands = [drum(0.0345 + 0.001 * n, 0.012, (0, 0, 0.012 + 0.138 * n), top=0.035 + 0.006 * n)
             for n in range(2)]  # fmt: skip
    hole = drum(0.036, 0.0008, (0, 0, 0.1698))
    strap = rod([(0.034, 0, 0.02), (0.06, 0, 0.06), (0.062, 0, 0.12), (0.04, 0, 0.155)], 0.005, 8)
    shafts, vanes = [], []
    for n in range(4):
        x, y = 0.016 * np.cos(1.7 * n), 0.016 * np.sin(1.7 * n)
        shafts.append(straight((x, y, 0.16), (1.5 * x, 1.5 * y, 0.24), 0.0028, 8))
        vanes += [at_box(0.022, 0.0015, 0.034, (1.4 * x, 1.4 * y, 0.2)).turn(2, 0.0),
                  at_box(0.0015, 0.022, 0.034, (1.4 * x, 1.4 * y, 0.2))]  # fmt: skip
    return put_down([(body, leather(look.rng, color)),
                     (join([*bands, strap]), leather(look.rng, tint_color(color, 0.6))),
                     (hole, plain(DARK)), (join(shafts), plain((206, 168, 112))),
                     (join(vanes), plain(look.own_color("red", "white", "yellow", "green")))], body,
                    strap, join(shafts), factor=k)  # fmt: skip


@category("foam_finger", size=(0.149, 0.279, 0.0237), mass=0.06, material="rubber",
          aliases=("foam hand", "fan finger", "giant foam finger"), themes=("sports",),
          roles=("flat", "big"), colors=("blue", "red"))  # fmt: skip
def foam_finger(look: Look) -> Shape:
    """A big foam hand with one finger up, lying flat."""
    color = look.color("blue", "red", "green", "yellow", "purple")
    k = look.between(0.8, 1.1)
    rim = [(-0.055, -0.12), (0.055, -0.12), (0.065, 0.0), (0.06, 0.05), (0.02, 0.06), (0.02, 0.15),
           (0.005, 0.17), (-0.014, 0.15), (-0.02, 0.04), (-0.05, 0.03), (-0.085, 0.045),
           (-0.09, 0.025), (-0.06, -0.02)]  # fmt: skip
    hand = plate(rim, 0.024)
    face = prints.canvas(128, 96, color)
    prints.write(face, look.pick(["No. 1", "GO!", "#1"]), 0.5, 0.5, 0.5, (250, 246, 230), bold=True)
    badge = at_box(0.09, 0.06, 0.001, (0, -0.06, 0.0236))
    lines = [at_box(0.003, 0.05, 0.001, (0.02 + 0.016 * n, 0.02, 0.0236)) for n in range(2)]
    return put_down([(hand, surfaces.speckles(look.rng, color, 4)), (badge, face),
                     (join(lines), plain(tint_color(color, 0.5)))], hand, factor=k)  # fmt: skip


def _boot(h: float) -> Solid:
    """Return a boot's upper on z = 0, extruded from its side view, with the toe towards +x."""
    rim = [(-0.055, 0), (0.085, 0), (0.1, 0.012), (0.095, 0.032), (0.045, 0.052), (0.018, 0.075),
           (0.01, h), (-0.052, h), (-0.058, 0.06)]  # fmt: skip
    return side_view(rim, 0.062)


def _laces(h: float) -> list[Solid]:
    return [
        at_box(0.004, 0.04, 0.004, (0.05 - 0.0085 * n, 0, 0.049 + 0.0078 * n)) for n in range(5)
    ]


@category("skateboard", size=(0.322, 0.0825, 0.0586), mass=0.4, material="plastic",
          aliases=("toy skateboard", "fingerboard", "mini skateboard", "longboard",
          "finger skateboard"), themes=("sports", "toys"), roles=("support",),
          colors=("red", "black"))  # fmt: skip
def skateboard(look: Look) -> Shape:
    """A skateboard with turned-up ends, standing on its wheels."""
    color = look.color("red", "black", "teal", "wooden", "orange", "purple")
    k = look.between(0.35, 0.5)
    x = np.array([-0.39, -0.3, -0.27, 0.27, 0.3, 0.39])
    z = np.array([0.13, 0.1, 0.092, 0.092, 0.1, 0.13])
    deck = side_view(
        np.concatenate([np.column_stack([x, z]), np.column_stack([x, z + 0.012])[::-1]]), 0.2
    )
    grip = at_box(0.54, 0.196, 0.002, (0, 0, 0.1035))
    wheels = [drum(0.028, 0.03, (sx * 0.2, sy * 0.085 - 0.015, 0.028), 1, sides=18, bevel=0.004)
              for sx in (-1, 1) for sy in (-1, 1)]  # fmt: skip
    trucks = [at_box(0.03, 0.14, 0.02, (s * 0.2, 0, 0.018)) for s in (-1, 1)]
    trucks += [at_box(0.07, 0.05, 0.055, (s * 0.2, 0, 0.038)) for s in (-1, 1)]
    return put_down(
        [(deck, look.surface(color, "wood")), (grip, plain((46, 46, 50))), (join(wheels), plain(
            look.own_color("white", "yellow", "lime", "coral"))), (join(trucks), steel(look))],
        deck, *(join(wheels[i : i + 2]) for i in (0, 2)), factor=k)  # fmt: skip


@category("bowling_pin", size=(0.064, 0.064, 0.205), mass=0.25, material="plastic", hollow=True,
          aliases=("skittle", "tenpin", "mini bowling pin"), themes=("sports",),
          roles=("round", "tall"), colors=("white",))  # fmt: skip
def bowling_pin(look: Look) -> Shape:
    """A small bowling pin with red stripes around its neck."""
    k = look.between(0.45, 0.62)
    color = look.color("white", "white", "cream", "wooden", "yellow")
    profile = np.array([(0, 0), (0.028, 0), (0.034, 0.02), (0.052, 0.08), (0.06, 0.115),
                        (0.055, 0.16), (0.038, 0.21), (0.024, 0.255), (0.0225, 0.28),
                        (0.027, 0.31), (0.032, 0.34), (0.029, 0.365), (0.016, 0.379),
                        (0, 0.381)])  # fmt: skip
    curve = smooth(profile[1:-1], 3)
    points = np.concatenate([[(0, 0)], curve, [(0, 0.381)]]) * k
    image = surfaces.fit(look.surface(color, "plastic"), 128, 32).copy()
    band = look.own_color("red", "red", "blue")
    heights = points[:, 1] / points[-1, 1]
    for z in (0.66, 0.725):
        prints.fill(image, 0, 1 - z - 0.035, 1, 0.035, band)
    body = lathe(points, 28, v=list(heights))
    return shape([(body, image)], [cylinder_part(0.028 * k, 0.03 * k), hull_of(body)])


@category("golf_tee", size=(0.0125, 0.0125, 0.0555), mass=0.002, material="metal",
          themes=("sports",), roles=("round",), colors=("white",))  # fmt: skip
def golf_tee(look: Look) -> Shape:
    """A golf tee standing on its cup with its point up."""
    k = look.between(0.9, 1.15)
    color = look.color("white", "red", "wooden", "yellow", "blue", "orange")
    body = lathe(np.array([(0, 0), (0.006, 0), (0.0062, 0.002), (0.0035, 0.009), (0.0023, 0.014),
                           (0.0021, 0.046), (0.0003, 0.054), (0, 0.0542)]) * k, 16)  # fmt: skip
    return shape([(body, look.surface(color, look.pick(["wood", "plastic"])))],
                 [cylinder_part(0.006 * k, 0.002 * k), hull_of(body)])  # fmt: skip


@category("kettlebell", size=(0.122, 0.122, 0.18), mass=2.5, material="metal", assembled=True,
          aliases=("kettle bell",), themes=("sports",), colors=("black",))  # fmt: skip
def kettlebell(look: Look) -> Shape:
    """A kettlebell: a flattened ball under a thick handle."""
    k = look.between(0.85, 1.05)
    color = look.color("black", "charcoal", "red", "blue", "green", "purple", "yellow")
    ball = lathe(np.array([(0, 0), (0.042, 0), (0.058, 0.018), (0.064, 0.05), (0.056, 0.084),
                           (0.035, 0.104), (0, 0.112)]) * k, 30)  # fmt: skip
    way = smooth([(-0.036, 0, 0.09), (-0.05, 0, 0.13), (-0.042, 0, 0.165), (0, 0, 0.176),
                  (0.042, 0, 0.165), (0.05, 0, 0.13), (0.036, 0, 0.09)], 4) * k  # fmt: skip
    handle = tube(way, 0.013 * k, 12)
    badge = prism(ellipse(0.05 * k, 0.05 * k, 24), 0, 0.002)
    weight = look.pick(["2", "4", "6"])
    image = prints.canvas(64, 64, (240, 240, 236))
    prints.write(image, weight + " kg", 0.5, 0.5, 0.28, (30, 30, 32), bold=True)
    badge = facing(badge).turn(0, -0.12).move(y=-0.0615 * k, z=0.052 * k)
    n = len(way)
    spans = [hull_of(tube(way[a:b], 0.0125 * k, 8)) for a, b in
             ((0, n // 3 + 1), (n // 3, 2 * n // 3 + 1), (2 * n // 3, n))]  # fmt: skip
    return shape([(join([ball, handle]), surfaces.speckles(look.rng, color, 5, 48)),
                  (badge, image)], [hull_of(ball), *spans])  # fmt: skip


@category("weight_plate", size=(0.16, 0.16, 0.022), mass=1.3, material="metal",
          aliases=("barbell plate", "weight disc", "weight disk", "barbell disc", "dumbbell plate"),
          themes=("sports",), roles=("round", "flat"), colors=("black",))  # fmt: skip
def weight_plate(look: Look) -> Shape:
    """A small weight plate with a hole, lying flat."""
    k = look.between(0.9, 1.1)
    color = look.color("black", "gray", "red", "blue", "charcoal", "green")
    r, h, hole = 0.08 * k, 0.022 * k, 0.0145 * k
    profile = [(hole, 0), (0.9 * r, 0), (r, 0.003), (r, h - 0.003), (0.95 * r, h), (0.8 * r, h),
               (0.76 * r, 0.7 * h), (0.45 * r, 0.7 * h), (0.4 * r, h), (hole, h)]  # fmt: skip
    image = prints.canvas(128, 64, color)
    body = lathe(profile, 40, loop=True)
    sign = prints.canvas(48, 24, color)
    prints.write(sign, look.pick(["1 KG", "2 KG", "1.25", "2.5"]), 0.5, 0.5, 0.6,
                 readable_on(color), bold=True)  # fmt: skip
    plate = box(0.042 * k, 0.021 * k, 0.0006).move(y=-0.6 * r, z=0.7 * h)
    return shape([(body, look.surface(color, "metal") if look.chance(0.4) else image),
                  (plate, sign)],
                 ring_parts([(r, 0), (r, h)], [(hole, h), (hole, 0)], 10))  # fmt: skip


@category("yoga_block", size=(0.21, 0.135, 0.072), mass=0.2, material="rubber",
          aliases=("yoga brick", "pilates block"), themes=("sports",), roles=("support", "big"),
          colors=("purple",))  # fmt: skip
def yoga_block(look: Look) -> Shape:
    """A foam or cork block for yoga."""
    k = look.between(0.9, 1.02)
    color = look.color("purple", "teal", "pink", "gray", "tan", "blue", "mint")
    cork = surfaces.spots(look.rng, color, tint_color(color, 0.75), 0.08)
    body = block(0.22 * k, 0.14 * k, 0.075 * k, 0.012, 0.006)
    return shape([(body, cork)], [hull_of(body)])


def _bat(profile: list[tuple[float, float]], grip: float) -> Callable[[Look], Shape]:
    """Return the shape function of a round bat with a wrapped grip, lying along x."""

    def make(look: Look) -> Shape:
        k = look.between(0.92, 1.06)
        color = look.color("wooden", "tan", "black", "red", "wooden", "blue")
        points = np.array(profile) * k
        body = lathe(points, 22).turn(1, np.pi / 2)
        long = points[-1, 1]
        wrap = cylinder(1.12 * float(points[2, 0]), grip * long, 16).turn(1, np.pi / 2)
        top = max(p[0] for p in profile) * k
        lean = np.arctan2(top - float(points[1, 0]), 0.75 * long)
        pieces = [body, wrap.move(x=0.03 * long)]
        pieces = [s.move(x=-long / 2).turn(1, -lean) for s in pieces]
        low = min(float(s.bounds[0, 2]) for s in pieces)
        pieces = [s.move(z=-low) for s in pieces]
        skin = look.surface(color, "wood")
        return shape(
            [(pieces[0], skin),
             (pieces[1], surfaces.stripes([(40, 38, 40), (62, 60, 62)], 12, side=96))],
            [flat_foot(pieces[0].vertices, 0.1)])  # fmt: skip

    return make


@category("whistle", size=(0.057, 0.026, 0.0184), mass=0.02, material="metal", assembled=True,
          aliases=("referee whistle", "sports whistle", "coach whistle", "whistle toy",
          "referee's whistle"), themes=("sports",), colors=("silver",))  # fmt: skip
def whistle(look: Look) -> Shape:
    """A referee's whistle, lying on its side."""
    k = look.between(0.92, 1.15)
    color = look.color("silver", "black", "red", "orange", "yellow", "blue", "silver")
    curve = arc((0, 0), 0.012, 0.75, 2 * np.pi - np.pi / 2, 16)
    outline = np.concatenate([curve, [(0.034, -0.012), (0.034, -0.003), (0.012, 0.0)]])
    body = prism(outline * k, 0, 0.018 * k)
    slot = box(0.006 * k, 0.008 * k, 0.0184 * k).move(0.013 * k, -0.001 * k)
    ring = torus(0.0065 * k, 0.0011 * k, 20, 6).move(-0.0175 * k, 0.002 * k, 0.009 * k)
    dots = [cylinder(0.006 * k, 0.0004, 18).move(z=0.018 * k)]
    return shape([(body, look.surface(color, "metal")),
                  (join([slot, *dots]), surfaces.plain(tint_color(color, 0.4))),
                  (ring, surfaces.brushed_metal(look.rng, (190, 192, 196)))],
                 [hull_of(prism(curve * k, 0, 0.018 * k)),
                  box_part(0.034 * k, 0.0088 * k, 0.018 * k,
                      (0.017 * k, -0.0075 * k, 0))])  # fmt: skip


@category("stopwatch", size=(0.055, 0.08, 0.0175), mass=0.08, material="metal", assembled=True,
          aliases=("stop watch", "timer", "chronometer", "handheld timer"), themes=("sports",),
          roles=("flat",), colors=("silver",))  # fmt: skip
def stopwatch(look: Look) -> Shape:
    """A stopwatch lying face up with its crown at the back."""
    k = look.between(0.92, 1.1)
    color = look.color("silver", "black", "yellow", "gold", "blue")
    r, h = 0.0275 * k, 0.016 * k
    face = prints.clock_face(look.rng, (248, 246, 240), (30, 30, 34))
    body = cylinder(r, h, 36, bevel=0.002)
    rim = torus(0.93 * r, 0.0014 * k, 36, 6).move(z=h)
    crown = [cylinder(0.0055 * k, 0.012 * k, 16).turn(0, -np.pi / 2).move(y=r - 0.002, z=h / 2)]
    crown += [cylinder(0.0035 * k, 0.008 * k, 12).turn(0, -np.pi / 2).turn(2, s * 0.7)
              .move(-s * 0.63 * r, 0.75 * r, h / 2) for s in (-1, 1)]  # fmt: skip
    ring = torus(0.01 * k, 0.0014 * k, 22, 6).move(y=r + 0.015 * k, z=h / 2)
    metal = look.surface(color, "metal")
    return shape([(body, metal), (join([rim, *crown, ring]), metal),
                  (prism(ellipse(1.78 * r, 1.78 * r, 36), h, h + 0.0006), face)],
                 [cylinder_part(r, h), hull_of(crown[0])])  # fmt: skip


@category("medal", size=(0.062, 0.14, 0.005), mass=0.06, material="metal", assembled=True,
          aliases=("gold medal", "silver medal", "bronze medal", "sports medal", "winner medal",
          "toy medal"), themes=("sports",), roles=("flat",), colors=("gold",))  # fmt: skip
def medal(look: Look) -> Shape:
    """A medal with its ribbon folded behind it, lying flat."""
    k = look.between(0.92, 1.1)
    color = look.color("gold", "gold", "silver", "bronze")
    r = 0.026 * k
    image = prints.canvas(96, 96, color)
    prints.disc(image, 0.5, 0.5, 0.44, tint_color(color, 0.78), 0.39)
    turns = np.arange(10) * np.pi / 5
    ray = np.where(np.arange(10) % 2, 0.12, 0.28)
    star = [(0.5 + q * np.sin(a), 0.5 - q * np.cos(a)) for q, a in zip(ray, turns, strict=True)]
    if look.chance(0.5):
        prints.polygon(image, star, tint_color(color, 0.72))
    else:
        prints.write(image, "1", 0.5, 0.5, 0.5, tint_color(color, 0.6), bold=True)
    tones = look.pick([((190, 40, 44), (246, 244, 240), (44, 80, 160)), ((44, 80, 160),) * 2,
                       ((196, 42, 40), (244, 206, 62)), ((66, 142, 76),
                           (246, 244, 240))])  # fmt: skip
    strip = surfaces.stripes(tones, 1, upright=True)
    bands = [box(0.02 * k, 0.09 * k, 0.0022).turn(2, s * 0.24).move(-s * 0.011 * k, 0.068 * k,
             0.0001 + 0.0021 * (s > 0)) for s in (-1, 1)]  # fmt: skip
    disc = cylinder(r, 0.0045, 36, bevel=0.0006)
    ring = torus(0.005 * k, 0.0011, 18, 6).move(y=r + 0.002, z=0.0026)
    return shape([(disc, look.surface(color, "metal")), (ring, surfaces.plain(color)),
                  (prism(ellipse(1.9 * r, 1.9 * r, 36), 0.0042, 0.0049), image),
                  *[(b, strip) for b in bands]],
                 [cylinder_part(r, 0.0045), *[hull_of(b) for b in bands]])  # fmt: skip


@category("sports_bottle", size=(0.07, 0.07, 0.215), mass=0.5, material="plastic",
          aliases=("sports water bottle", "gym bottle", "drinking bottle", "cycling bottle",
          "bike bottle", "shaker bottle", "protein shaker", "sport bottle", "sipper bottle"),
          themes=("sports",), roles=("round", "tall"), colors=("blue",))  # fmt: skip
def sports_bottle(look: Look) -> Shape:
    """A sports bottle with a narrow grip and a nozzle."""
    k = look.between(0.92, 1.06)
    color = look.color("blue", "red", "green", "white", "black", "orange", "yellow", "pink")
    cap = look.own_color("black", "white", "gray", "red")
    body = lathe(np.array([(0, 0), (0.031, 0), (0.0355, 0.006), (0.0355, 0.07), (0.031, 0.09),
                           (0.031, 0.11), (0.0355, 0.128), (0.0345, 0.152), (0.029, 0.158),
                           (0, 0.158)]) * k, 30)  # fmt: skip
    lid = lathe(np.array([(0.0, 0.156), (0.0315, 0.156), (0.0315, 0.172), (0.012, 0.186),
                          (0.0105, 0.19), (0.0105, 0.2), (0.007, 0.2), (0.007, 0.206),
                          (0.0085, 0.208), (0.0085, 0.217), (0, 0.217)]) * k, 26)  # fmt: skip
    image = prints.canvas(128, 96, color)
    mark = tint_color(color, 1.6) if sum(color) < 480 else tint_color(color, 0.55)
    for n in range(3):
        prints.polygon(image[:, 38:90], [(0.1 + 0.25 * n, 0.62), (0.25 + 0.25 * n, 0.62),
                                         (0.4 + 0.25 * n, 0.32), (0.25 + 0.25 * n, 0.32)],
                                        mark)  # fmt: skip
    return shape([(body, image), (lid, surfaces.speckles(look.rng, cap, 4, 32))],
                 [cylinder_part(0.0355 * k, 0.155 * k), hull_of(lid)])  # fmt: skip


@category("tennis_racket", size=(0.177, 0.396, 0.02), mass=0.25, material="plastic", assembled=True,
          aliases=("racket", "racquet", "tennis racquet", "badminton racket", "squash racket",
          "badminton racquet"), themes=("sports",), roles=("flat", "big"), colors=("red",),
          state="lying flat")  # fmt: skip
def tennis_racket(look: Look) -> Shape:
    """A small, strung tennis racket, lying flat."""
    k = look.between(0.92, 1.08)
    color = look.color("red", "blue", "black", "yellow", "green", "orange", "white")
    a = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    hoop = np.column_stack([0.082 * np.cos(a), 0.06 + 0.105 * np.sin(a), 0.009 + 0 * a]) * k
    frame = tube(hoop, 0.0065 * k, 8, loop=True)
    throat = [tube(smooth(np.array([(s * 0.05, -0.022, 0.009), (s * 0.025, -0.07, 0.009),
                                    (s * 0.006, -0.11, 0.009)]) * k, 4), 0.006 * k, 8)
              for s in (-1, 1)]  # fmt: skip
    grip = block(0.024 * k, 0.12 * k, 0.02 * k, 0.006, 0.004).move(y=-0.165 * k)
    wires = []
    for x in np.linspace(-0.066, 0.066, 10):
        y = 0.104 * np.sqrt(1 - (x / 0.081) ** 2)
        wires.append(box(0.0012, 2 * y * k, 0.0014).move(x * k, 0.06 * k, 0.0085 * k))
    for y in np.linspace(-0.085, 0.085, 12):
        x = 0.081 * np.sqrt(1 - (y / 0.104) ** 2)
        wires.append(box(2 * x * k, 0.0012, 0.0014).move(0, (0.06 + y) * k, 0.0088 * k))
    black = surfaces.stripes([(40, 40, 42), (60, 60, 62)], 12)
    plate = prism(ellipse(0.164 * k, 0.21 * k, 24), 0.003 * k, 0.0155 * k).move(y=0.06 * k)
    return shape([(join([frame, *throat]), surfaces.speckles(look.rng, color, 4, 32)),
                  (join(wires), surfaces.plain((236, 236, 230))), (grip, black)],
                 [hull_of(plate), hull_of(*throat), hull_of(grip)])  # fmt: skip


@category("hockey_puck", size=(0.076, 0.076, 0.0254), mass=0.16, material="rubber",
          aliases=("puck", "ice hockey puck"), themes=("sports",), roles=("round", "flat"),
          colors=("black",))  # fmt: skip
@vary()
def hockey_puck(look: Look) -> Shape:
    """A hard rubber puck."""
    k = look.between(0.96, 1.04)
    color = look.color("black", "black", "charcoal", "blue", "orange")
    body = cylinder(0.038 * k, 0.0254 * k, 36, bevel=0.001)
    return shape([(body, surfaces.spots(look.rng, color, tint_color(color, 1.25), 0.08))],
                 [cylinder_part(0.038 * k, 0.0254 * k)])  # fmt: skip


@category("snorkel", size=(0.402, 0.111, 0.0297), mass=0.15, material="plastic",
          aliases=("snorkel tube", "diving snorkel"), themes=("sports",), roles=("big",),
          colors=("blue",))  # fmt: skip
def snorkel(look: Look) -> Shape:
    """A snorkel lying flat: a bent tube with a mouthpiece and a bright end."""
    color = look.color("blue", "black", "yellow", "green", "orange")
    k = look.between(0.85, 1.1)
    pipe = rod([(0.2, 0, 0.012), (0.0, 0.0, 0.012), (-0.12, 0, 0.012), (-0.17, 0.03, 0.012),
                (-0.15, 0.075, 0.012)], 0.0115, 14, 6)  # fmt: skip
    end = drum(0.0135, 0.03, (0.19, 0, 0.0135), 0, sides=16)
    mouth = pad(0.05, 0.026, 0.016, 0.008).move(-0.148, 0.082, 0.006)
    clip = torus(0.0125, 0.004, 18, 6).turn(1, np.pi / 2).move(0.02, 0, 0.0135)
    return put_down([(pipe, plain(color)), (end, plain((240, 120, 40))),
                     (join([mouth, clip]), plain(DARK))],
                    straight((0.2, 0, 0.012), (-0.12, 0, 0.012), 0.0115, 12), mouth, pipe, factor=k,
                    foot=0.3)  # fmt: skip


CATEGORIES = (
    Category("baseball_bat", _bat([(0, 0), (0.012, 0), (0.012, 0.006), (0.007, 0.012),
             (0.007, 0.11), (0.011, 0.19), (0.016, 0.27), (0.016, 0.335), (0.012, 0.345),
             (0, 0.346)], 0.3), size=(0.345, 0.032, 0.032), mass=0.2, material="wood",
             aliases=("bat", "mini baseball bat", "rounders bat"), themes=("sports",),
             colors=("wooden",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
