"""Objects of the ``living`` theme: lamps."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.outlines import smooth
from ...kit.parts import cylinder_part, hull_above, hull_of, hull_part, ring_parts
from ...kit.primitives import ball, limb, straight
from ...kit.shapes import Pieces, Shape, category, settle, shape
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, torus, tube
from ...kit.surfaces import RGB, Look, tint_color
from .decorations import GAY


@category("string_lights", size=(0.288, 0.173, 0.0127), mass=0.08, material="plastic",
          assembled=True, aliases=("fairy lights", "string of lights", "christmas lights",
          "string of fairy lights", "tree lights", "light string", "string of christmas lights",
          "led string lights"), themes=("living",), colors=("green",),
          state="lying flat")  # fmt: skip
def string_lights(look: Look) -> Shape:
    """A string of small coloured lights on a green wire, lying in loops."""
    k = look.between(0.9, 1.1)
    color = look.color("green", "green", "black", "white")
    warm = look.chance(0.35)
    t = np.linspace(0, 1, 80)
    path = np.column_stack([0.3 * (t - 0.5) + 0.045 * np.sin(6 * np.pi * t), 0.06 * np.cos(
                            6 * np.pi * t), 0.0023 + 0 * t])  # fmt: skip
    wire = tube(path, 0.0022, 6)
    groups: dict[RGB, list[Solid]] = {}
    sockets = []
    for n in range(15):
        at = path[3 + n * 5]
        way = path[4 + n * 5] - at
        a = np.arctan2(way[1], way[0]) + np.pi / 2 * (-1) ** n
        out = np.array([np.cos(a), np.sin(a), 0])
        sockets.append(tube([at, at + 0.012 * out + [0, 0, 0.002]], 0.0045, 8))
        bulb = ellipsoid(0.021, 0.0125, 0.0125, 10, 7).turn(2, a).move(*(at + 0.021 * out + [0, 0,
                                                                         0.004]))  # fmt: skip
        tone: RGB = (255, 226, 150) if warm else GAY[n % 4]
        groups.setdefault(tone, []).append(bulb)
    dark = surfaces.plain(tint_color(color, 0.7))
    pieces = [(join([wire, *sockets]), dark)]
    pieces += [(join(bulbs), surfaces.plain(tone)) for tone, bulbs in groups.items()]
    thirds = [wire.vertices[(wire.vertices[:, 0] >= a) & (wire.vertices[:, 0] < b)]
              for a, b in ((-1, -0.06), (-0.06, 0.06), (0.06, 1))]  # fmt: skip
    return shape(pieces, [hull_part(np.maximum(p, [-9, -9, 0])) for p in thirds]
                 + [hull_above(join([b for g in groups.values() for b in g]))]
                 ).scale(k)  # fmt: skip


FLAME = surfaces.gradient((250, 160, 40), (255, 236, 140), np.random.default_rng(0), 2)


@category("lantern", size=(0.108, 0.108, 0.25), mass=0.6, material="metal", assembled=True,
          aliases=("candle lantern", "metal lantern", "garden lantern", "storm lantern",
          "lantern with a candle", "miner's lamp", "davy lamp", "paper lantern light",
          "hurricane lamp", "roman oil lamp"), themes=("living",), roles=("tall",),
          colors=("black", "white"))  # fmt: skip
def lantern(look: Look) -> Shape:
    """A square lantern: a roof on four posts over a candle, with a carrying ring."""
    color = look.color("black", "white", "copper", "red", "teal", "silver", "bronze", "green")
    w, h = look.between(0.08, 0.1), look.between(0.12, 0.16)
    base = block(w + 0.016, w + 0.016, 0.014, 0.004, 0.002)
    posts = [box(0.008, 0.008, h).move(sx * (w / 2 - 0.004), sy * (w / 2 - 0.004), 0.013)
             for sx in (-1, 1) for sy in (-1, 1)]  # fmt: skip
    bars = [box(w, 0.004, 0.005).move(0, s * (w / 2 - 0.004), 0.013 + 0.5 * h) for s in (-1, 1)]
    bars += [box(0.004, w, 0.005).move(s * (w / 2 - 0.004), 0, 0.013 + 0.5 * h) for s in (-1, 1)]
    plate = block(w + 0.016, w + 0.016, 0.008, 0.004).move(z=h + 0.012)
    roof = cylinder(0.72 * w, 0.045, 4, top=0.02).turn(2, np.pi / 4).move(z=h + 0.019)
    cap = cylinder(0.018, 0.012, 16).move(z=h + 0.062)
    ring = torus(0.022, 0.003, 22, 8).turn(0, np.pi / 2).move(z=h + 0.092)
    wax = cylinder(0.022, 0.055, 20).move(z=0.013)
    flame = ball(0.012, 0.012, 0.028, (0, 0, 0.086), 10)
    paint = look.surface(color, "metal")
    pieces: Pieces = [(join([base, *posts, *bars, plate, roof, cap, ring]), paint),
                      (wax, surfaces.plain((248, 240, 222))), (flame, FLAME)]  # fmt: skip
    return shape(pieces, [hull_of(base, *posts, plate), hull_of(roof), hull_of(cap, ring)])


GLASS: RGB = (218, 228, 230)


@category("lampshade", size=(0.244, 0.244, 0.152), mass=0.25, material="fabric", hollow=True,
          aliases=("lamp shade", "fabric lampshade", "shade of a lamp"), themes=("living",),
          roles=("round", "big"), colors=("cream",))  # fmt: skip
def lampshade(look: Look) -> Shape:
    """A cone-shaped fabric lampshade, open at the top and bottom."""
    k = look.between(0.9, 1.1)
    color = look.color("cream", "white", "tan", "red", "teal", "navy", "green")
    low, top, h = 0.12 * k, look.between(0.06, 0.1) * k, 0.15 * k
    t = 0.003
    body = lathe([(low, 0), (top, h), (top - t, h), (low - t, 0)], 44, loop=True)
    bands = [
        torus(r - 0.001, 0.0024, 40, 6).move(z=z) for r, z in ((low, 0.0024), (top, h - 0.001))
    ]
    ring = torus(0.02 * k, 0.002, 18, 6).move(z=h - 0.012)
    spokes = [straight((0.02 * k * np.cos(a), 0.02 * k * np.sin(a), h - 0.012),
                       ((top - 0.002) * np.cos(a), (top - 0.002) * np.sin(a), h - 0.004), 0.0016, 5)
              for a in (0.5, 2.6, 4.7)]  # fmt: skip
    return shape([(body, surfaces.fabric(look.rng, color)),
                  (join(bands), surfaces.plain(tint_color(color, 0.75))),
                  (join([ring, *spokes]), surfaces.plain((214, 216, 218)))],
                 ring_parts([(low, 0), (top, h)], [(top - t, h), (low - t, 0)], 14))  # fmt: skip


@category("oil_lamp", size=(0.107, 0.108, 0.271), mass=0.8, material="glass", assembled=True,
          aliases=("kerosene lamp", "paraffin lamp", "antique oil lamp", "hurricane oil lamp"),
          themes=("living",), roles=("tall",), colors=("brass",))  # fmt: skip
def oil_lamp(look: Look) -> Shape:
    """A burning oil lamp: a bulbous fount on a base, a burner with a key and a glass chimney."""
    k = look.between(0.92, 1.08)
    color = look.color("brass", "green", "blue", "red", "clear", "copper")
    fount = lathe(np.maximum(smooth([(0, 0), (0.05, 0), (0.048, 0.01), (0.024, 0.03), (0.022, 0.05),
                                     (0.052, 0.075), (0.05, 0.1), (0.022, 0.116), (0, 0.118)], 3),
                             0), 30)  # fmt: skip
    burner = lathe([(0, 0.112), (0.024, 0.112), (0.03, 0.126), (0.028, 0.145), (0.012, 0.148), (0,
                    0.148)], 26)  # fmt: skip
    key = [straight((0.026, 0, 0.13), (0.052, 0, 0.13), 0.0022), cylinder(0.009, 0.003, 16).turn(
           1, np.pi / 2).move(0.05, 0, 0.13)]  # fmt: skip
    chimney = lathe([(0.024, 0.146), (0.034, 0.175), (0.03, 0.2), (0.017, 0.235), (0.018, 0.275),
                     (0.0165, 0.275), (0.0155, 0.235), (0.0285, 0.199), (0.0325, 0.175), (0.0225,
                     0.146)], 28, loop=True)  # fmt: skip
    flame = lathe(np.maximum(smooth([(0, 0.147), (0.008, 0.153), (0.009, 0.165), (0.003, 0.182), (0,
                  0.19)], 3), 0), 14)  # fmt: skip
    brass = surfaces.brushed_metal(look.rng, (206, 166, 82))
    skin = (surfaces.brushed_metal(look.rng, color) if "color" in look.attributes
            else surfaces.gradient(tint_color(color, 0.8), tint_color(color, 1.2),
                                   look.rng))  # fmt: skip
    return shape(
        [
            (fount, skin),
            (join([burner, *key]), brass),
            (chimney, surfaces.plain(GLASS)),
            (flame, surfaces.plain((255, 206, 80))),
        ],
        [hull_of(fount), hull_of(burner), hull_of(*key), hull_of(chimney)],
    ).scale(k)


@category("lamp_base", size=(0.188, 0.147, 0.255), mass=1.0, material="ceramic", assembled=True,
          aliases=("base of a lamp", "table lamp base", "lamp stand", "lamp without a shade"),
          themes=("living",), roles=("tall",), colors=("white",))  # fmt: skip
def lamp_base(look: Look) -> Shape:
    """A table lamp without its shade: a turned or bulbous column with a socket."""
    k = look.between(0.92, 1.08)
    color = look.color("white", "teal", "wooden", "navy", "green", "gray")
    side = look.pick([[(0, 0), (0.06, 0), (0.06, 0.012), (0.03, 0.022), (0.062, 0.08),
                       (0.066, 0.12), (0.03, 0.19), (0.014, 0.21), (0, 0.212)],
                      [(0, 0), (0.068, 0), (0.066, 0.014), (0.02, 0.03), (0.03, 0.06), (0.018, 0.1),
                       (0.026, 0.15), (0.014, 0.2), (0, 0.204)]])  # fmt: skip
    body = lathe(np.maximum(smooth(side, 3), 0), 32)
    top = side[-1][1]
    socket = lathe([(0, top - 0.004), (0.013, top - 0.004), (0.016, top + 0.012),
                    (0.016, top + 0.045), (0.012, top + 0.045), (0, top + 0.025)], 24)  # fmt: skip
    cord = limb([(0.055, 0, 0.006), (0.09, 0.02, 0.003), (0.11, -0.02, 0.003)], [0.003] * 3, 6)
    brass = surfaces.brushed_metal(look.rng, (206, 166, 82))
    return shape([(body, look.surface(color, "ceramic")), (socket, brass),
                  (cord, surfaces.plain((44, 42, 42)))],
                 [hull_of(body), hull_of(socket), hull_above(cord)]).scale(k)  # fmt: skip


@category("spotlight", size=(0.0998, 0.121, 0.147), mass=0.5, material="metal", assembled=True,
          aliases=("spot light", "stage light", "floodlight", "work light"), themes=("living",),
          colors=("black",))  # fmt: skip
def spotlight(look: Look) -> Shape:
    """A small spotlight: a tilted round can in a yoke on a base."""
    k = look.between(0.92, 1.08)
    color = look.color("black", "black", "white", "silver")
    foot = cylinder(0.05, 0.01, 30, bevel=0.002)
    yoke = [limb([(0, s * 0.012, 0.008), (0, s * 0.05, 0.03), (0, s * 0.05, 0.085)], [0.005] * 3, 8)
            for s in (-1, 1)]  # fmt: skip
    can = lathe([(0, -0.05), (0.034, -0.048), (0.042, -0.02), (0.042, 0.05), (0.037, 0.05), (0.035,
                 0.02), (0, 0.02)], 28)  # fmt: skip
    lens = cylinder(0.036, 0.004, 26).move(z=0.03)

    def aim(solid: Solid) -> Solid:
        return solid.turn(0, 1.15).move(z=0.088)

    ribs = [torus(0.0425, 0.0016, 28, 5).move(z=z) for z in (-0.015, -0.005, 0.005)]
    return shape([(join([foot, *yoke]), surfaces.speckles(look.rng, tint_color(color, 0.85), 4)),
                  (aim(join([can, *ribs])), surfaces.speckles(look.rng, color, 4)),
                  (aim(lens), surfaces.plain((255, 240, 180)))],
                 [hull_of(foot), hull_of(*yoke), hull_of(aim(can))]).scale(k)  # fmt: skip


@category("wall_sconce", size=(0.1, 0.171, 0.135), mass=0.5, material="metal", assembled=True,
          aliases=("sconce", "wall lamp", "wall light"), themes=("living",), colors=("brass",),
          state="lying flat")  # fmt: skip
def wall_sconce(look: Look) -> Shape:
    """A wall light lying on its back plate: a curved arm, a cup and a shade."""
    k = look.between(0.92, 1.08)
    color = look.color("brass", "black", "silver", "copper")
    plate = block(0.075, 0.12, 0.012, 0.03, 0.003)
    arm = limb(
        [(0, -0.02, 0.01), (0, -0.05, 0.06), (0, -0.01, 0.09), (0, 0.02, 0.085)], [0.006] * 4, 8
    )
    cup = cylinder(0.014, 0.03, 20).turn(0, -np.pi / 2).move(0, 0.012, 0.085)
    shade = lathe([(0.024, 0), (0.05, 0.085), (0.047, 0.085), (0.021, 0)], 28, loop=True).turn(
        0, -np.pi / 2).move(0, 0.025, 0.085)  # fmt: skip
    glow = ball(0.036, 0.05, 0.036, (0, 0.06, 0.085), 14)
    return shape([(join([plate, arm, cup]), surfaces.brushed_metal(look.rng, color)),
                  (shade, surfaces.fabric(look.rng, look.own_color("cream", "white", "tan"))),
                  (glow, surfaces.plain((255, 236, 170)))],
                 [hull_of(plate), hull_of(arm, cup), hull_of(shade)]).scale(k)  # fmt: skip


STEEL: RGB = (188, 191, 196)


@category("fluorescent_tube", size=(0.38, 0.0206, 0.0173), mass=0.08, material="metal",
          assembled=True, aliases=("neon tube", "light tube", "tube light", "led tube",
          "strip light", "fluorescent light"), themes=("living",), roles=("big",),
          colors=("white",), state="lying flat")  # fmt: skip
def fluorescent_tube(look: Look) -> Shape:
    """A fluorescent tube lying flat: white glass and metal caps with two pins."""
    long, r = look.between(0.3, 0.4), look.between(0.0075, 0.012)
    color = look.color("white", "white", "ivory")
    glass = cylinder(r, long, 20).turn(1, np.pi / 2).move(x=-long / 2)
    cap = cylinder(1.04 * r, 0.02, 20, bevel=0.001).turn(1, np.pi / 2)
    pins = [straight((s * (long / 2 + 0.008), t * 0.35 * r, 0), (s * (long / 2 + 0.015), t * 0.35
                                                                 * r, 0), 0.0012, 6)
            for s in (-1, 1) for t in (-1, 1)]  # fmt: skip
    caps = [cap.move(x=-long / 2 - 0.01), cap.move(x=long / 2 - 0.01)]
    return settle([(glass, surfaces.speckles(look.rng, color, 3)),
                   (join([*caps, *pins]), surfaces.brushed_metal(look.rng, STEEL))],
                  0.16)  # fmt: skip


@category("led_strip", size=(0.118, 0.123, 0.0108), mass=0.1, material="plastic", assembled=True,
          aliases=("led strip light", "light strip", "led light strip", "led tape",
          "strip of leds"), themes=("living",), colors=("white",), state="lying flat")  # fmt: skip
def led_strip(look: Look) -> Shape:
    """A strip of small lights wound into a flat coil, with a plug at its end."""
    k = look.between(0.92, 1.08)
    color = look.color("white", "white", "black")
    t = np.linspace(0, 1, 90)
    turn, away = 2 * np.pi * 3.4 * t, 0.028 + 0.032 * t
    path = np.column_stack([away * np.cos(turn), away * np.sin(turn), 0.005 + 0 * t])
    ribbon = tube(path, 0.005, 6)
    tail = limb([tuple(path[-1]), (path[-1, 0] + 0.01, path[-1, 1] - 0.04, 0.004),
                 (path[-1, 0] + 0.03, path[-1, 1] - 0.08, 0.004)], [0.002] * 3, 5)  # fmt: skip
    plug = block(0.018, 0.01, 0.008, 0.002).turn(2, -1.1).move(path[-1, 0] + 0.033, path[-1, 1] -
                                                               0.085)  # fmt: skip
    tones = ((250, 80, 80), (90, 220, 120), (90, 150, 250), (255, 240, 190))
    dots: list[list[Solid]] = [[], [], [], []]
    for n in range(2, 88, 2):
        dots[n // 2 % 4].append(box(0.0045, 0.0045, 0.0014).move(*(path[n] + [0, 0, 0.0044])))
    pieces = [(ribbon, surfaces.plain(color)), (join([tail, plug]), surfaces.plain((40, 40, 44)))]
    pieces += [(join(d), surfaces.plain(c)) for d, c in zip(dots, tones, strict=True)]
    return shape(pieces, [hull_of(ribbon), hull_of(tail, plug)]).scale(k)


@category("bulb_holder", size=(0.14, 0.053, 0.051), mass=0.06, material="plastic", assembled=True,
          aliases=("lamp holder", "lamp socket", "bulb socket", "light socket", "light bulb holder",
          "light fitting"), themes=("living",), colors=("black",))  # fmt: skip
def bulb_holder(look: Look) -> Shape:
    """A lamp socket standing on its cap, with wires and a screw thread in its open end."""
    k = look.between(0.94, 1.06)
    color = look.color("black", "white", "brass", "brown")
    body = lathe([(0, 0), (0.019, 0), (0.021, 0.004), (0.021, 0.02), (0.0185, 0.024),
                  (0.0185, 0.05), (0.015, 0.05), (0.0145, 0.02), (0, 0.02)], 30)  # fmt: skip
    ring = lathe([(0.0185, 0.026), (0.026, 0.026), (0.026, 0.036), (0.0185, 0.036)], 28, loop=True)
    thread = [torus(0.0148, 0.0011, 24, 5).move(z=z) for z in (0.028, 0.034, 0.04, 0.046)]
    tip = cylinder(0.004, 0.003, 12).move(z=0.0195)
    cord = limb([(0.014, 0, 0.005), (0.045, 0.004, 0.003), (0.07, -0.012, 0.003),
                 (0.11, 0.006, 0.003)], [0.003] * 4, 7)  # fmt: skip
    return shape([(join([body, ring]), look.surface(color, "plastic")),
                  (join([*thread, tip]), surfaces.plain((206, 170, 90))),
                  (cord, surfaces.plain((232, 230, 224)))],
                 [hull_of(body, ring), hull_above(cord)]).scale(k)  # fmt: skip


@category("night_light", size=(0.105, 0.105, 0.105), mass=0.2, material="device",
          aliases=("nightlight", "glow lamp"), themes=("living", "vanity", "play"),
          roles=("round",), colors=("yellow", "cream"), common=True)  # fmt: skip
def night_light(look: Look) -> Shape:
    """A small glowing night light: a mushroom, or a globe on a ring."""
    glow = look.color("yellow", "amber", "cream", "pink", "sky", "mint", "lavender", "red")
    warm = surfaces.gradient(tint_color(glow, 1.55), tint_color(glow, 1.2), look.rng, 2)
    base_color = look.own_color("white", "wooden", "gray", "black", "brown")
    foot = look.surface(base_color, look.pick(["plastic", "wood"]))
    if look.chance(0.4):
        warm = surfaces.spots(look.rng, tint_color(glow, 1.3), (252, 248, 238), 0.12)
    r = look.between(0.046, 0.058)
    if look.chance(0.5):
        stem = lathe([(0, 0), (0.62 * r, 0), (0.45 * r, 1.1 * r), (0, 1.1 * r)], 24)
        t = np.linspace(0, np.pi / 2, 8)
        dome = np.column_stack([r * np.cos(t), r * (1.0 + 0.75 * np.sin(t))])
        dome[-1, 0] = 0
        cap = lathe([(0, r), *dome], 28)
        return shape([(stem, foot), (cap, warm)], [hull_of(stem), hull_of(cap)])
    ball = ellipsoid(2 * r, 2 * r, 2 * r, 28, 16).move(z=r + 0.012)
    base = cylinder(0.68 * r, 0.026, 28, bevel=0.003)
    return shape([(ball, warm), (base, foot)], [cylinder_part(0.68 * r, 0.026), hull_of(ball)])
