"""Wind and percussion instruments, keys and guitars, and what lies around them."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import box_part, flat_foot, hull_of, hull_part
from ...build.forms import lay_down
from ...build.outlines import ellipse, rounded_polygon, smooth
from ...build.shape import Shape, shape
from ...build.solids import block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...build.variants import keep_still
from ...surfaces import prints, textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

BRASS = ("gold", "gold", "brass", "silver")


def guitar(look: Look) -> Shape:
    """A small guitar lying on its back, its neck to the right."""
    k = look.between(0.9, 1.05)
    color = look.color("wooden", "tan", "amber", "brown", "black", "red", "wooden", "sky")
    half = smooth([(-0.2, 0), (-0.195, 0.045), (-0.15, 0.088), (-0.1, 0.09), (-0.045, 0.062),
                   (-0.015, 0.058), (0.03, 0.072), (0.06, 0.062), (0.075, 0.03), (0.077, 0)],
                  4)  # fmt: skip
    outline = np.concatenate([half * [1, -1], half[::-1][1:-1]]) * k
    h = 0.045 * k
    face = prism(outline, h - 0.002, h)
    rim = prism(outline * 0.985, 0, h - 0.001)
    dark = textures.plain((44, 32, 28))
    hole = prism(ellipse(0.052, 0.052, 28) * k, h - 0.001, h + 0.0006).move(x=-0.03 * k)
    ring = torus(0.029 * k, 0.0012, 28, 5).move(-0.03 * k, 0, h)
    bridge = block(0.014 * k, 0.066 * k, 0.008 * k, 0.002).move(x=-0.125 * k, z=h)
    neck = box(0.24 * k, 0.03 * k, 0.016 * k).move(0.185 * k, 0, h - 0.009 * k)
    board = box(0.26 * k, 0.028 * k, 0.003 * k).move(0.175 * k, 0, h + 0.006 * k)
    head = prism(np.array([(0.3, -0.016), (0.37, -0.024), (0.37, 0.024), (0.3, 0.016)]) * k,
                 h - 0.006 * k, h + 0.006 * k)  # fmt: skip
    pegs = [ellipsoid(0.009, 0.012, 0.007, 8, 6).scale(k, k, k)
            .move((0.318 + 0.018 * n) * k, s * (0.027 + 0.002 * n) * k, h)
            for n in range(3) for s in (-1, 1)]  # fmt: skip
    frets = [box(0.0014, 0.028 * k, 0.001).move((0.3 - 0.25 * (1 - 0.9**n)) * k, 0, h + 0.0088 * k)
             for n in range(1, 9)]  # fmt: skip
    strings = [tube([(-0.12 * k, y * k, h + 0.008 * k), (0.3 * k, 0.8 * y * k, h + 0.0105 * k)],
                    0.0006, 4) for y in np.linspace(-0.013, 0.013, 6)]  # fmt: skip
    cuts = [(-0.21, -0.1), (-0.1, -0.03), (-0.03, 0.08)]
    slabs = []
    for a, b in cuts:
        inside = outline[(outline[:, 0] >= a * k - 0.004) & (outline[:, 0] <= b * k + 0.004)]
        slabs.append(hull_part(np.concatenate([np.column_stack([inside * 0.985, np.full(
            len(inside), z)]) for z in (0, h)])))  # fmt: skip
    wood = textures.wood(look.rng, color)
    silver = textures.plain((206, 208, 212))
    return shape([(face, wood), (rim, textures.wood(look.rng, tint_color(color, 0.6))),
                  (join([hole, bridge, board, ring]), dark), (neck, wood),
                  (head, textures.wood(look.rng, tint_color(color, 0.7))),
                  (join([*pegs, *frets, *strings]), silver)],
                 [*slabs, hull_of(neck), hull_of(head), hull_of(bridge)])  # fmt: skip


def _pipe(
    profile: list[tuple[float, float]],
    palette: tuple[str, ...],
    default: str,
    *,
    keys: bool,
    bore: float,
) -> Callable[[Look], Shape]:
    """A wind instrument lying along x: a turned pipe with holes or silver keys on top."""

    def make(look: Look) -> Shape:
        k = look.between(0.94, 1.06)
        color = look.color(*palette)
        points = np.array(profile) * k
        long, r = float(points[-1, 1]), float(points[:, 0].max())
        body = lay_down(lathe(points, 20), -long / 2, r)
        marks = []
        for n in range(7):
            x = (-0.12 + 0.085 * n) * long
            if keys:
                marks.append(cylinder(0.62 * bore * k, 0.0025, 14).move(x, 0, r + 0.9 * bore * k))
                marks.append(box(0.012 * k, 0.0016, 0.0016).move(x, 0.6 * bore * k,
                                                                 r + 0.75 * bore * k))  # fmt: skip
            else:
                marks.append(cylinder(0.36 * bore * k, 0.0016, 12).move(x, 0, r + 0.9 * bore * k))
        if keys:
            rod = tube([(-0.15 * long, 0.7 * bore * k, r + 0.75 * bore * k),
                        (0.42 * long, 0.7 * bore * k, r + 0.75 * bore * k)], 0.0014, 6)  # fmt: skip
            marks.append(rod)
        else:
            marks.append(box(0.012 * k, bore * k, 0.003).move(-0.36 * long, 0, r + 0.84 * bore * k))
        tone = (204, 206, 212) if keys else tint_color(color, 0.3)
        rest = body.vertices
        return shape([(body, look.surface(color, default)), (join(marks), textures.plain(tone))],
                     [flat_foot(rest, 0.1)])  # fmt: skip

    return make


def trumpet(look: Look) -> Shape:
    """A trumpet lying on its side: bell, loop of pipe, three valves, mouthpiece."""
    k = look.between(0.72, 0.85)
    metal = look.surface(look.color(*BRASS), "metal")
    z = 0.026
    bell = lathe(np.array([(0, 0), (0.0065, 0), (0.007, 0.1), (0.009, 0.17), (0.014, 0.21),
                           (0.026, 0.24), (0.056, 0.262), (0.058, 0.263), (0.05, 0.258),
                           (0, 0.24)]) * k, 28)  # fmt: skip
    bell = lay_down(bell, -0.04 * k, 0).move(y=0.04 * k, z=0.058 * k)
    pipe = 0.006 * k
    up = 0.058
    loop = smooth([(-0.04, 0.04, up), (-0.14, 0.04, up), (-0.17, 0.02, up), (-0.17, -0.02, up),
                   (-0.14, -0.036, up), (0.08, -0.036, up), (0.11, -0.02, up), (0.11, 0.0, up),
                   (0.08, 0.014, up), (-0.2, 0.014, up), (-0.235, 0.014, up)], 4)  # fmt: skip
    loop = tube(loop * k, pipe, 10)
    mouth = lay_down(lathe(np.array([(0, 0), (0.011, 0), (0.012, 0.004), (0.006, 0.02), (0.0045,
        0.05),
                                 (0, 0.05)]) * k, 18), -0.27 * k,
                                     up * k).move(y=0.014 * k)  # fmt: skip
    valves = []
    for n in (-1, 0, 1):
        x = (0.0 + 0.026 * n) * k
        can = cylinder(0.0115 * k, 0.09 * k, 18, bevel=0.002).turn(0, np.pi / 2)
        valves.append(can.move(x, 0.05 * k, up * k))
        cap = cylinder(0.007 * k, 0.02 * k, 14).turn(0, -np.pi / 2).move(x, 0.05 * k, up * k)
        valves.append(cap)
    pieces = [bell, loop, mouth, *valves]
    low = min(float(s.bounds[0, 2]) for s in pieces)
    lean = np.arctan2((up - 0.012) * k + 0 * z, 0.22 * k) * 0.75
    pieces = [s.move(z=-low).move(x=-0.22 * k).turn(1, -lean).move(x=0.22 * k) for s in pieces]
    low = min(float(s.bounds[0, 2]) for s in pieces)
    bell, loop, mouth, *valves = (s.move(z=-low) for s in pieces)
    valve_hull = hull_of(*valves)
    loop_hull = hull_of(loop)
    return shape([(join([bell, loop, *valves[::2]]), metal), (join([mouth, *valves[1::2]]),
                  textures.brushed_metal(look.rng, (210, 210, 206)))],
                 [hull_of(bell), loop_hull, valve_hull, hull_of(mouth)])  # fmt: skip


def saxophone(look: Look) -> Shape:
    """A small saxophone lying: a curved conical pipe, an upturned bell, keys."""
    k = look.between(0.6, 0.72)
    metal = look.surface(look.color("gold", "gold", "brass", "silver", "black"), "metal")
    z = 0.0
    way = smooth([(-0.07, 0.24, z), (-0.045, 0.262, z), (-0.015, 0.25, z), (-0.005, 0.21, z),
                  (0.0, 0.1, z), (0.0, -0.04, z), (0.006, -0.12, z), (0.04, -0.155, z),
                  (0.08, -0.13, z), (0.1, -0.07, z), (0.115, 0.0, z), (0.125, 0.03, z)],
                      4)  # fmt: skip
    t = np.linspace(0, 1, len(way))
    radii = 0.006 + 0.026 * t**1.4 + 0.028 * np.clip((t - 0.86) / 0.14, 0, 1) ** 2
    way[:, 2] = radii
    body = tube(way * k, radii * k, 16)
    mouth = tube(np.array([(-0.105, 0.222, 0.01), (-0.065, 0.244, 0.01)]) * k,
        np.array([0.005, 0.01]) * k,
                 10)  # fmt: skip
    keys = []
    for n in range(8):
        y = 0.16 - 0.034 * n
        keys.append(cylinder((0.009 + 0.0009 * n) * k, 0.005 * k, 14)
                    .move(0.002 * k, y * k, 2 * float(np.interp(-y, -way[12:26, 1],
                        radii[12:26])) * k - 0.001))  # fmt: skip
    keys.append(tube(np.array([(0.014, 0.17, 0.024), (0.02, -0.1, 0.036)]) * k, 0.003 * k, 6))
    inside = prism(ellipse(0.08, 0.08, 24) * k, -0.002, 0.0015).turn(0, -np.pi / 2 + 0.0)
    inside = inside.turn(2, -0.32).move(0.1255 * k, 0.0315 * k, 0.06 * k)
    low = float(body.bounds[0, 2])
    body, mouth, inside, *keys = (s.move(z=-low) for s in (body, mouth, inside, *keys))
    n = len(way)
    spans = [(0, 9), (8, 18), (17, 25), (24, 33), (32, n)]
    moved = way * k - [0, 0, low]
    hulls = [hull_of(tube(moved[a : b + 1], radii[a : b + 1] * k, 16)) for a, b in spans
             if b > a]  # fmt: skip
    foot = hull_of(tube(moved[20:33], radii[20:33] * k, 16))
    return shape([(body, metal), (join(keys), textures.plain((226, 200, 130))),
                  (mouth, textures.plain((30, 30, 32))), (inside, textures.plain((70, 52, 24)))],
                 [*hulls, foot])  # fmt: skip


def harmonica(look: Look) -> Shape:
    """A harmonica lying: metal covers over a comb with holes."""
    k = look.between(0.92, 1.08)
    color = look.color("silver", "silver", "black", "red", "blue", "gold")
    x, y, h = 0.102 * k, 0.027 * k, 0.02 * k
    comb = block(x, y, 0.36 * h, 0.004).move(z=0.32 * h)
    face = prints.canvas(128, 16, (206, 174, 120))
    for n in range(10):
        prints.fill(face, 0.05 + 0.092 * n, 0.15, 0.058, 0.7, (36, 30, 26))
    front = box(0.96 * x, 0.0008, 0.34 * h).move(y=-y / 2, z=0.33 * h)
    covers = [block(0.95 * x, 0.94 * y, 0.34 * h, 0.005, 0.0022).move(z=z) for z in (0, 0.66 * h)]
    slot = box(0.7 * x, 0.0016, 0.0006).move(y=0.2 * y, z=h - 0.0003)
    return shape([(comb, textures.plain((150, 104, 62))), (front, face),
                  (join(covers), look.surface(color, "metal")),
                  (slot, textures.plain(tint_color(color, 0.5)))],
                 [box_part(0.95 * x, 0.94 * y, h), hull_of(comb)])  # fmt: skip


def sheet_music(look: Look) -> Shape:
    """A few sheets of music lying."""
    x, y, h = 0.21, look.between(0.27, 0.3), look.between(0.001, 0.004)
    image = prints.canvas(160, 216, look.color("white", "cream", "ivory"))
    ink = (40, 40, 44)
    prints.lines(image, look.rng, (0.3, 0.05, 0.4, 0.04), 1, ink, 0.9)
    for n in range(7):
        y0 = 0.14 + 0.12 * n
        for m in range(5):
            prints.fill(image, 0.08, y0 + 0.013 * m, 0.84, 0.003, (90, 90, 94))
        for m in range(11):
            u, v = 0.15 + 0.07 * m, y0 + look.between(0, 0.05)
            prints.disc(image, u, v, 0.011, ink)
            prints.fill(image, u + 0.01, v - 0.045, 0.006, 0.045, ink)
        prints.fill(image, 0.09, y0, 0.012, 0.055, ink)
    body = box(x, y, h)
    return shape([(body, textures.stripes([(248, 246, 240), (214, 212, 206)], 4)),
                  (box(x, y, 0.0005).move(z=h - 0.0003), image)], [box_part(x, y, h)])  # fmt: skip


def guitar_pick(look: Look) -> Shape:
    """A plectrum lying flat."""
    k = look.between(0.95, 1.15)
    color = look.color("red", "black", "amber", "white", "blue", "green", "purple")
    outline = rounded_polygon(np.array([(-0.016, 0.012), (0, -0.02), (0.016, 0.012)]) * k, 0.004, 5)
    body = prism(outline, 0, 0.0014)
    image = textures.fit(textures.marble(look.rng, color, tint_color(color, 1.3)), 64, 64).copy()
    return shape([(body, image)], [hull_of(body)])


CATEGORIES = (
    Category("guitar", guitar, (0.555, 0.178, 0.0575), 0.7, ("acoustic guitar", "small guitar",
             "toy guitar", "mini guitar", "classical guitar"), ("music",), ("big",),
             ("wooden",), None, "lying flat"),
    Category("flute", _pipe([(0, 0), (0.0095, 0), (0.0095, 0.16), (0.0105, 0.162),
             (0.0105, 0.175), (0.0095, 0.177), (0.0095, 0.44), (0, 0.44)], ("silver", "silver",
             "gold"), "metal", keys=True, bore=0.0095), (0.44, 0.021, 0.021), 0.35,
             ("transverse flute",
             "piccolo", "fife",), ("music",), (), ("silver",), None, "lying flat"),
    Category("recorder", _pipe([(0, 0), (0.007, 0), (0.0105, 0.03), (0.0145, 0.05),
             (0.0145, 0.06), (0.011, 0.07), (0.0095, 0.24), (0.0145, 0.25), (0.0145, 0.262),
             (0.01, 0.27), (0.0125, 0.31), (0, 0.312)], ("cream", "wooden", "brown", "tan",
             "green"), "wood", keys=False, bore=0.0115), (0.312, 0.029, 0.029), 0.15,
             ("wooden flute", "recorder flute"), ("music",), (),
             ("wooden", "cream"), None, "lying flat"),
    Category("clarinet", keep_still(_pipe([(0, 0), (0.004, 0), (0.009, 0.05), (0.013, 0.055),
             (0.013, 0.11), (0.0105, 0.113), (0.0105, 0.42), (0.014, 0.47), (0.0285, 0.51),
             (0.0285, 0.514), (0, 0.51)], ("black", "black", "charcoal", "brown"), "plastic",
             keys=True, bore=0.011)), (0.514, 0.057, 0.057), 0.6, ("clarinet toy", "oboe",
             "chanter",
             "cor anglais"), ("music",), (),
             ("black",), None, "lying flat"),
    Category("trumpet", keep_still(trumpet), (0.4, 0.114, 0.116), 0.9, ("cornet", "toy trumpet",
             "bugle", "flugelhorn"),
             ("music",), ("big",), ("gold",), None, "lying flat"),
    Category("saxophone", saxophone, (0.191, 0.291, 0.0657), 1.1, ("sax", "alto saxophone"),
        ("music",), ("big",), ("gold",), None, "lying flat"),
    Category("harmonica", harmonica, (0.102, 0.027, 0.02), 0.11, ("mouth organ", "mouth harp",
             "blues harp"), ("music",), (), ("silver",)),
    Category("sheet_music", sheet_music, (0.21, 0.285, 0.0027), 0.04, ("music sheet",
             "music score", "score", "sheet of music", "music book"), ("music",),
             ("flat", "support", "big"), ("white",)),
    Category("guitar_pick", guitar_pick, (0.0277, 0.0271, 0.0014), 0.001, ("plectrum",
             "guitar plectrum", "pick"), ("music",), ("flat",), ("red", "black")),
)  # fmt: skip
"""The module's categories."""
