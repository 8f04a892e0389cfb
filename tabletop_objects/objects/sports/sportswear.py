"""Objects of the ``sports`` theme: sportswear."""

from __future__ import annotations

import numpy as np

from ...kit import surfaces
from ...kit.materials import DARK, leather, steel
from ...kit.outlines import ellipse, smooth
from ...kit.parts import flat_foot, hull_of, ring_parts
from ...kit.primitives import at_box, drum, pad, plate, side_view, standing
from ...kit.shapes import Shape, category, put_down, shape
from ...kit.solids import block, ellipsoid, join, lathe, prism, torus, tube
from ...kit.surfaces import Look, plain, tint_color
from .equipment import _boot, _laces

BRIGHT = ("red", "blue", "green", "yellow", "orange", "purple", "black", "pink")


@category("goggles", size=(0.144, 0.114, 0.0369), mass=0.05, material="plastic", assembled=True,
          aliases=("swim goggles", "diving goggles", "ski goggles"), themes=("sports",),
          colors=("blue", "black"))  # fmt: skip
def goggles(look: Look) -> Shape:
    """Swimming goggles lying flat, with two lenses, a nose piece and a strap at the back."""
    color = look.color(*BRIGHT)
    k = look.between(0.9, 1.15)
    cups, lenses = [], []
    for s in (-1, 1):
        cups.append(
            torus(0.0225, 0.006, 24, 8)
            .scale(1.25, 0.9, 1.6)
            .turn(0, 0.85)
            .move(s * 0.035, -0.02, 0.018)
        )
        lenses.append(
            plate(ellipse(0.054, 0.038, 22), 0.004, at=(0, 0, 0.003))
            .turn(0, 0.85)
            .move(s * 0.035, -0.021, 0.018)
        )
    nose = at_box(0.02, 0.008, 0.006, (0, -0.024, 0.018))
    a = np.linspace(0.15, np.pi - 0.15, 18)
    path = np.column_stack([0.068 * np.cos(a), -0.01 + 0.075 * np.sin(a), 0.013 + 0 * a])
    path = np.concatenate([[(0.06, -0.022, 0.018)], path, [(-0.06, -0.022, 0.018)]])
    strap = [tube(path, 0.0025, 8), tube(path - np.array([0, 0, 0.006]), 0.0025, 8),
             tube(path - np.array([0, 0, 0.0105]), 0.0025, 8)]  # fmt: skip
    tint = look.pick([(150, 190, 210), (90, 100, 120), (220, 170, 90)])
    return put_down([(join([*cups, nose]), plain(color)),
                     (join(lenses), surfaces.gradient(tint, tint_color(tint, 1.5), look.rng)),
                     (join(strap), plain(tint_color(color, 0.7)))], *cups, join(strap),
                    factor=k)  # fmt: skip


@category("knee_pad", size=(0.184, 0.174, 0.0653), mass=0.15, material="fabric", aliases=("kneepad",
          "elbow pad", "shin pad", "shin guard", "shinpad", "arm guard", "protective pad",
          "wrist guard"), themes=("sports",), colors=("black",))  # fmt: skip
def knee_pad(look: Look) -> Shape:
    """A padded knee pad with a hard cap and two straps, lying flat."""
    color = look.color("black", "navy", "red", "charcoal", "pink")
    k = look.between(0.85, 1.15)
    body = pad(0.13, 0.18, 0.04, 0.05, soft=0.8)
    cap = standing(
        (0.045, 0), (0.044, 0.01), (0.034, 0.022), (0.014, 0.029), at=(0, 0, 0.036), sides=22
    ).scale(1, 1.25, 1)
    straps = [at_box(0.19, 0.03, 0.006, (0, s * 0.055, 0.012)) for s in (-1, 1)]
    cuts = [at_box(0.05, 0.006, 0.004, (0, y, 0.0635)) for y in (-0.012, 0.012)]
    return put_down([(body, surfaces.fabric(look.rng, color)), (cap, plain(tint_color(color, 0.7)
                                                                           if sum(color) > 250
                                                                           else (90, 92, 98))),
                     (join([*straps, *cuts]), plain(DARK))], body, cap, *straps,
                    factor=k)  # fmt: skip


@category("baseball_glove", size=(0.2, 0.225, 0.06), mass=0.4, material="leather", assembled=True,
          aliases=("baseball mitt", "mitt", "catcher mitt", "catcher's mitt"), themes=("sports",),
          roles=("big",), colors=("tan",))  # fmt: skip
def baseball_glove(look: Look) -> Shape:
    """A leather baseball glove lying palm up."""
    k = look.between(0.92, 1.08)
    color = look.color("tan", "brown", "black", "terracotta", "maroon")
    skin = surfaces.spots(look.rng, color, tint_color(color, 0.82), 0.12)
    dark = surfaces.plain(tint_color(color, 0.55))
    fingers = []
    for n, a in enumerate((0.42, 0.14, -0.14, -0.42)):
        t = np.linspace(0, 1, 7)
        long = (0.105, 0.118, 0.116, 0.1)[n]
        way = np.column_stack([0.02 * (1.5 - n) + long * t * np.sin(a),
                               0.01 + long * t * np.cos(a), 0.016 + 0.03 * t**2])  # fmt: skip
        radii = 0.0155 * np.array([1, 1.05, 1.08, 1.08, 1.05, 0.95, 0.55])
        fingers.append(tube(way * k, radii * k, 10))
    t = np.linspace(0, 1, 7)
    way = np.column_stack([-0.045 - 0.055 * t, -0.02 + 0.075 * t, 0.0188 + 0.03 * t**2])
    fingers.append(tube(way * k, 0.0165 * np.array([1.1, 1.1, 1.1, 1.1, 1.05, 0.95, 0.55]) * k, 10))
    a = np.linspace(-np.pi / 2, np.pi / 2, 9)
    palm = ellipsoid(0.125, 0.13, 0.05, 22, 10).move(0, -0.015, 0.022).scale(k, k, k)
    pocket = ellipsoid(0.08, 0.085, 0.012, 20, 8).move(-0.012, 0.0, 0.0435).scale(k, k, k)
    cuff = block(0.085 * k, 0.03 * k, 0.036 * k, 0.01, 0.004).move(y=-0.082 * k)
    web = prism(np.array([(-0.05, 0.02), (-0.015, 0.03), (-0.035, 0.1), (-0.085, 0.055)]) * k,
                0.03 * k, 0.034 * k)  # fmt: skip
    laces = [tube(np.array([(x0, y0, 0.036), (x1, y1, 0.037)]) * k, 0.0024 * k, 5) for
             x0, y0, x1, y1 in ((-0.055, 0.032, -0.022, 0.05), (-0.065, 0.045, -0.028, 0.07),
                                (-0.078, 0.055, -0.034, 0.09))]  # fmt: skip
    return shape([(join([*fingers, palm, cuff]), skin), (web, skin),
                  (pocket, surfaces.plain(tint_color(color, 0.78))), (join(laces), dark)],
                 [flat_foot(palm.vertices, 0.3), hull_of(cuff),
                     *(hull_of(f) for f in fingers)])  # fmt: skip


@category("boxing_glove", size=(0.13, 0.23, 0.106), mass=0.25, material="leather", assembled=True,
          aliases=("boxing mitt", "sparring glove"), themes=("sports",), roles=("big",),
          colors=("red",))  # fmt: skip
def boxing_glove(look: Look) -> Shape:
    """A boxing glove lying on its palm, with the thumb at the side and a laced cuff in front."""
    k = look.between(0.85, 1.0)
    color = look.color("red", "red", "blue", "black", "pink", "yellow")
    skin = surfaces.speckles(look.rng, color, 4, 48)
    fist = ellipsoid(0.12, 0.15, 0.115, 26, 14).move(0, 0.045, 0.056)
    hand = ellipsoid(0.11, 0.15, 0.09, 24, 12).move(0, -0.01, 0.047)
    thumb = tube(smooth([(0.045, -0.04, 0.04), (0.066, 0.0, 0.045), (0.06, 0.05, 0.045)], 4),
                 0.021, 12)  # fmt: skip
    knob = ellipsoid(0.043, 0.046, 0.043, 14, 8).move(0.059, 0.054, 0.045)
    cuff = lathe([(0, 0), (0.041, 0), (0.044, 0.004), (0.041, 0.07), (0, 0.07)], 26)
    cuff = cuff.turn(0, -np.pi / 2).scale(1, 1, 0.9).move(y=-0.13, z=0.044)
    band = lathe([(0, 0), (0.0465, 0), (0.0465, 0.022), (0, 0.022)], 26)
    band = band.turn(0, -np.pi / 2).scale(1, 1, 0.9).move(y=-0.118, z=0.044)
    red = [s.scale(k, k, k) for s in (fist, hand, thumb, knob)]
    pale = [s.scale(k, k, k) for s in (cuff, band)]
    hulls = [flat_foot(s.vertices, 0.12) for s in (red[0], red[1], pale[0])]
    return shape([(join(red), skin), (pale[0], skin),
                  (pale[1], surfaces.plain((240, 238, 232)))],
                 [*hulls, hull_of(red[2]), hull_of(red[3])])  # fmt: skip


@category("helmet", size=(0.165, 0.215, 0.124), mass=0.3, material="plastic", hollow=True,
          aliases=("bike helmet", "bicycle helmet", "cycling helmet", "skate helmet",
          "cycle helmet", "samurai helmet", "viking helmet", "knight's helmet"), themes=("sports",),
          roles=("big",), colors=("red",))  # fmt: skip
def helmet(look: Look) -> Shape:
    """A cycling helmet with dark vents, standing on its rim."""
    k = look.between(0.85, 0.98)
    color = look.color("red", "blue", "white", "black", "yellow", "teal", "orange")
    a = np.linspace(0.0, np.pi / 2, 10)
    outer = np.column_stack([0.1 * np.cos(a) ** 0.8, 0.02 + 0.115 * np.sin(a)])
    shell = lathe([(0, 0.118), (0.055, 0.1), (0.082, 0.05), (0.086, 0.0), (0.098, 0.0),
                   *map(tuple, outer[:-1]), (0, 0.135)], 34)  # fmt: skip
    shell = shell.scale(0.92 * k, 1.2 * k, k)
    vents = []
    for x in (-0.045, 0.0, 0.045):
        for y in (-0.06, 0.005, 0.065):
            vent = ellipsoid(0.02, 0.042, 0.012, 12, 6).turn(0, -0.55 * y / 0.068)
            away = min(np.hypot(x / 0.92, y / 1.2) / 0.1, 1) ** 1.25
            vents.append(vent.move(x, y, 0.02 + 0.115 * np.sqrt(1 - away**2)).scale(k, k, k))
    wall = ring_parts([(0.098 * k, 0), (0.094 * k, 0.07 * k)],
                      [(0.075 * k, 0.07 * k), (0.083 * k, 0)], 10, stretch=(0.92, 1.2))  # fmt: skip
    crown = hull_of(
        shell.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0.07 * k)]))
    )
    return shape([(shell, surfaces.speckles(look.rng, color, 4, 32)),
                  (join(vents), surfaces.plain((30, 30, 34)))], [*wall, crown])  # fmt: skip


@category("roller_skate", size=(0.181, 0.103, 0.21), mass=0.8, material="plastic",
          aliases=("rollerskate", "rollerblade", "inline skate", "quad skate"), themes=("sports",),
          roles=("big",), colors=("white", "pink"))  # fmt: skip
def roller_skate(look: Look) -> Shape:
    """A laced boot on four wheels with a stopper at its toe."""
    color = look.color("white", "pink", "black", "sky", "red", "mint")
    k = look.between(0.95, 1.25)
    boot = _boot(0.13).move(z=0.062)
    sole, heel = (at_box(0.155, 0.06, 0.008, (0.02, 0, 0.056)),
                  at_box(0.04, 0.056, 0.02, (-0.036, 0, 0.044)))  # fmt: skip
    plate = at_box(0.14, 0.04, 0.01, (0.015, 0, 0.04))
    wheels = [drum(0.024, 0.024, (x, s * 0.035 - 0.012, 0.024), 1, sides=18, bevel=0.004)
              for x in (-0.036, 0.062) for s in (-1, 1)]  # fmt: skip
    trucks = [at_box(0.02, 0.06, 0.03, (x, 0, 0.018)) for x in (-0.036, 0.062)]
    stop = drum(0.014, 0.03, (0.092, 0, 0.016), top=0.01)
    laces = [one.move(z=0.064) for one in _laces(0)]
    tone = look.own_color("pink", "red", "yellow", "turquoise", "orange")
    return put_down([(boot, leather(look.rng, color)),
                     (join([sole, heel]), plain(tint_color(color, 0.6))),
                     (join([plate, *trucks]), steel(look)), (join([*wheels, stop]), plain(tone)),
                     (join(laces), plain((250, 248, 244))), (at_box(0.046, 0.046, 0.0012,
                                                                    (-0.021, 0, 0.1915)),
                                                             plain(DARK))], boot,
                    join([plate, *wheels]), factor=k)  # fmt: skip


@category("ice_skate", size=(0.212, 0.0668, 0.196), mass=0.7, material="metal",
          aliases=("figure skate", "skate", "hockey skate"), themes=("sports",), roles=("big",),
          colors=("white",))  # fmt: skip
def ice_skate(look: Look) -> Shape:
    """A laced boot on a steel blade, standing upright on a broad support."""
    color = look.color("white", "black", "white", "navy")
    k = look.between(0.95, 1.25)
    boot = _boot(0.13).move(z=0.052)
    sole = at_box(0.155, 0.058, 0.008, (0.02, 0, 0.046))
    blade = side_view([(-0.075, 0.006), (-0.07, 0), (0.105, 0), (0.122, 0.014), (0.11, 0.018),
                       (-0.075, 0.016)], 0.006)  # fmt: skip
    posts = [at_box(0.03, 0.03, 0.034, (x, 0, 0.014)) for x in (-0.035, 0.065)]
    laces = [one.move(z=0.054) for one in _laces(0)]
    wide = at_box(0.16, 0.05, 0.004, (0.02, 0, 0))
    return put_down([(boot, leather(look.rng, color)), (sole, plain(tint_color(color, 0.55))),
                     (join([blade, *posts]), steel(look)), (join(laces), plain((200, 202, 210))),
                     (at_box(0.046, 0.046, 0.0012, (-0.021, 0, 0.1815)), plain((70, 72, 80)))],
                    boot, blade, wide, factor=k)  # fmt: skip
