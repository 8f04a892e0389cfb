"""Sports gear: balls, bats, pins, weights, whistles, stopwatches, medals."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, cylinder_part, flat_foot, hull_of, ring_parts
from ...build.outlines import arc, ellipse, smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look


def _bat(profile: list[tuple[float, float]], grip: float) -> Callable[[Look], Shape]:
    """A round bat lying along x with a wrapped grip."""

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
             (pieces[1], textures.stripes([(40, 38, 40), (62, 60, 62)], 12, side=96))],
            [flat_foot(pieces[0].vertices, 0.1)])  # fmt: skip

    return make


def baseball_glove(look: Look) -> Shape:
    """A leather baseball glove lying, palm up."""
    k = look.between(0.92, 1.08)
    color = look.color("tan", "brown", "black", "terracotta", "maroon")
    skin = textures.spots(look.rng, color, tint_color(color, 0.82), 0.12)
    dark = textures.plain(tint_color(color, 0.55))
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
                  (pocket, textures.plain(tint_color(color, 0.78))), (join(laces), dark)],
                 [flat_foot(palm.vertices, 0.3), hull_of(cuff),
                     *(hull_of(f) for f in fingers)])  # fmt: skip


def boxing_glove(look: Look) -> Shape:
    """A boxing glove lying on its palm, thumb at its side, laced cuff to the front."""
    k = look.between(0.85, 1.0)
    color = look.color("red", "red", "blue", "black", "pink", "yellow")
    skin = textures.speckles(look.rng, color, 4, 48)
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
                  (pale[1], textures.plain((240, 238, 232)))],
                 [*hulls, hull_of(red[2]), hull_of(red[3])])  # fmt: skip


def whistle(look: Look) -> Shape:
    """A referee's whistle lying on its side."""
    k = look.between(0.92, 1.15)
    color = look.color("silver", "black", "red", "orange", "yellow", "blue", "silver")
    curve = arc((0, 0), 0.012, 0.75, 2 * np.pi - np.pi / 2, 16)
    outline = np.concatenate([curve, [(0.034, -0.012), (0.034, -0.003), (0.012, 0.0)]])
    body = prism(outline * k, 0, 0.018 * k)
    slot = box(0.006 * k, 0.008 * k, 0.0184 * k).move(0.013 * k, -0.001 * k)
    ring = torus(0.0065 * k, 0.0011 * k, 20, 6).move(-0.0175 * k, 0.002 * k, 0.009 * k)
    dots = [cylinder(0.006 * k, 0.0004, 18).move(z=0.018 * k)]
    return shape([(body, look.surface(color, "metal")),
                  (join([slot, *dots]), textures.plain(tint_color(color, 0.4))),
                  (ring, textures.brushed_metal(look.rng, (190, 192, 196)))],
                 [hull_of(prism(curve * k, 0, 0.018 * k)),
                  box_part(0.034 * k, 0.0088 * k, 0.018 * k,
                      (0.017 * k, -0.0075 * k, 0))])  # fmt: skip


def stopwatch(look: Look) -> Shape:
    """A stopwatch lying, face up, crown to the back."""
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


def medal(look: Look) -> Shape:
    """A medal lying, its ribbon folded behind it."""
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
    strip = textures.stripes(tones, 1, upright=True)
    bands = [box(0.02 * k, 0.09 * k, 0.0022).turn(2, s * 0.24).move(-s * 0.011 * k, 0.068 * k,
             0.0001 + 0.0021 * (s > 0)) for s in (-1, 1)]  # fmt: skip
    disc = cylinder(r, 0.0045, 36, bevel=0.0006)
    ring = torus(0.005 * k, 0.0011, 18, 6).move(y=r + 0.002, z=0.0026)
    return shape([(disc, look.surface(color, "metal")), (ring, textures.plain(color)),
                  (prism(ellipse(1.9 * r, 1.9 * r, 36), 0.0042, 0.0049), image),
                  *[(b, strip) for b in bands]],
                 [cylinder_part(r, 0.0045), *[hull_of(b) for b in bands]])  # fmt: skip


def sports_bottle(look: Look) -> Shape:
    """A sports bottle with a grip waist and a nozzle."""
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
    return shape([(body, image), (lid, textures.speckles(look.rng, cap, 4, 32))],
                 [cylinder_part(0.0355 * k, 0.155 * k), hull_of(lid)])  # fmt: skip


def helmet(look: Look) -> Shape:
    """A cycling helmet standing on its rim, with dark vents."""
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
    return shape([(shell, textures.speckles(look.rng, color, 4, 32)),
                  (join(vents), textures.plain((30, 30, 34)))], [*wall, crown])  # fmt: skip


def tennis_racket(look: Look) -> Shape:
    """A small tennis racket lying, strung."""
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
    black = textures.stripes([(40, 40, 42), (60, 60, 62)], 12)
    plate = prism(ellipse(0.164 * k, 0.21 * k, 24), 0.003 * k, 0.0155 * k).move(y=0.06 * k)
    return shape([(join([frame, *throat]), textures.speckles(look.rng, color, 4, 32)),
                  (join(wires), textures.plain((236, 236, 230))), (grip, black)],
                 [hull_of(plate), hull_of(*throat), hull_of(grip)])  # fmt: skip


CATEGORIES = (
    Category("baseball_bat", _bat([(0, 0), (0.012, 0), (0.012, 0.006), (0.007, 0.012),
             (0.007, 0.11), (0.011, 0.19), (0.016, 0.27), (0.016, 0.335), (0.012, 0.345),
             (0, 0.346)], 0.3), (0.345, 0.032, 0.032), 0.2, ("bat", "mini baseball bat",
             "rounders bat"), ("sports",), (), ("wooden",), None, "lying flat"),
    Category("baseball_glove", baseball_glove, (0.2, 0.225, 0.06), 0.4, ("baseball mitt", "mitt",
             "catcher mitt", "catcher's mitt"), ("sports",), ("big",), ("tan",)),
    Category("boxing_glove", boxing_glove, (0.13, 0.23, 0.106), 0.25, ("boxing mitt",
             "sparring glove",),
             ("sports",), ("big",), ("red",)),
    Category("whistle", whistle, (0.057, 0.026, 0.0184), 0.02, ("referee whistle",
             "sports whistle", "coach whistle", "whistle toy", "referee's whistle"), ("sports",),
             (), ("silver",)),
    Category("stopwatch", stopwatch, (0.055, 0.08, 0.0175), 0.08, ("stop watch", "timer",
             "chronometer", "handheld timer"), ("sports",), ("flat",),
             ("silver",)),
    Category("medal", medal, (0.062, 0.14, 0.005), 0.06, ("gold medal", "silver medal",
             "bronze medal", "sports medal", "winner medal", "toy medal"), ("sports",), ("flat",),
             ("gold",)),
    Category("sports_bottle", sports_bottle, (0.07, 0.07, 0.215), 0.5, ("sports water bottle",
             "gym bottle", "drinking bottle", "cycling bottle", "bike bottle", "shaker bottle",
             "protein shaker", "sport bottle", "sipper bottle"), ("sports",), ("round", "tall"),
             ("blue",)),
    Category("helmet", helmet, (0.165, 0.215, 0.124), 0.3, ("bike helmet", "bicycle helmet",
             "cycling helmet", "skate helmet", "cycle helmet", "samurai helmet", "viking helmet",
             "knight's helmet"), ("sports",), ("big",), ("red",)),
    Category("tennis_racket", tennis_racket, (0.177, 0.396, 0.02), 0.25, ("racket", "racquet",
             "tennis racquet", "badminton racket", "squash racket", "badminton racquet"),
             ("sports",), ("flat", "big"), ("red",), None, "lying flat"),
)  # fmt: skip
"""The module's categories."""
