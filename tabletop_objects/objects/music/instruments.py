"""Objects of the ``music`` theme: instruments."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...kit import prints, surfaces
from ...kit.materials import steel
from ...kit.outlines import ellipse, rounded_polygon, smooth
from ...kit.parts import box_part, cylinder_part, flat_foot, hull_of, hull_part
from ...kit.primitives import at_box, drum, lay_down
from ...kit.shapes import Category, Shape, category, keep_still, put_down, shape
from ...kit.solids import block, box, cylinder, ellipsoid, join, lathe, prism, torus, tube
from ...kit.surfaces import Look, plain, tint_color

BRASS = ("gold", "gold", "brass", "silver")


@category("guitar", size=(0.555, 0.178, 0.0575), mass=0.7, material="wood", hollow=True,
          aliases=("acoustic guitar", "small guitar", "toy guitar", "mini guitar",
          "classical guitar"), themes=("music",), roles=("big",), colors=("wooden",),
          state="lying flat")  # fmt: skip
def guitar(look: Look) -> Shape:
    """A small guitar lying on its back with its neck on the right."""
    k = look.between(0.9, 1.05)
    color = look.color("wooden", "tan", "amber", "brown", "black", "red", "wooden", "sky")
    half = smooth([(-0.2, 0), (-0.195, 0.045), (-0.15, 0.088), (-0.1, 0.09), (-0.045, 0.062),
                   (-0.015, 0.058), (0.03, 0.072), (0.06, 0.062), (0.075, 0.03), (0.077, 0)],
                  4)  # fmt: skip
    outline = np.concatenate([half * [1, -1], half[::-1][1:-1]]) * k
    h = 0.045 * k
    face = prism(outline, h - 0.002, h)
    rim = prism(outline * 0.985, 0, h - 0.001)
    dark = surfaces.plain((44, 32, 28))
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
    wood = surfaces.wood(look.rng, color)
    silver = surfaces.plain((206, 208, 212))
    return shape([(face, wood), (rim, surfaces.wood(look.rng, tint_color(color, 0.6))),
                  (join([hole, bridge, board, ring]), dark), (neck, wood),
                  (head, surfaces.wood(look.rng, tint_color(color, 0.7))),
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
    """Return the shape function of a wind instrument along x, with holes or silver keys on top."""

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
        return shape([(body, look.surface(color, default)), (join(marks), surfaces.plain(tone))],
                     [flat_foot(rest, 0.1)])  # fmt: skip

    return make


@category("trumpet", size=(0.4, 0.114, 0.116), mass=0.9, material="metal", assembled=True,
          aliases=("cornet", "toy trumpet", "bugle", "flugelhorn"), themes=("music",),
          roles=("big",), colors=("gold",), state="lying flat")  # fmt: skip
@keep_still
def trumpet(look: Look) -> Shape:
    """A trumpet lying on its side: a bell, a loop of pipe, three valves and a mouthpiece."""
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
                  surfaces.brushed_metal(look.rng, (210, 210, 206)))],
                 [hull_of(bell), loop_hull, valve_hull, hull_of(mouth)])  # fmt: skip


@category("saxophone", size=(0.191, 0.291, 0.0657), mass=1.1, material="metal", assembled=True,
          aliases=("sax", "alto saxophone"), themes=("music",), roles=("big",), colors=("gold",),
          state="lying flat")  # fmt: skip
def saxophone(look: Look) -> Shape:
    """A small saxophone lying flat: a curved conical pipe, an upturned bell and keys."""
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
    return shape([(body, metal), (join(keys), surfaces.plain((226, 200, 130))),
                  (mouth, surfaces.plain((30, 30, 32))), (inside, surfaces.plain((70, 52, 24)))],
                 [*hulls, foot])  # fmt: skip


@category("harmonica", size=(0.102, 0.027, 0.02), mass=0.11, material="metal",
          aliases=("mouth organ", "mouth harp", "blues harp"), themes=("music",),
          colors=("silver",))  # fmt: skip
def harmonica(look: Look) -> Shape:
    """A harmonica lying flat: metal covers over a comb with holes."""
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
    return shape([(comb, surfaces.plain((150, 104, 62))), (front, face),
                  (join(covers), look.surface(color, "metal")),
                  (slot, surfaces.plain(tint_color(color, 0.5)))],
                 [box_part(0.95 * x, 0.94 * y, h), hull_of(comb)])  # fmt: skip


@category("sheet_music", size=(0.21, 0.285, 0.0027), mass=0.04, material="paper",
          aliases=("music sheet", "music score", "score", "sheet of music", "music book"),
          themes=("music",), roles=("flat", "support", "big"), colors=("white",))  # fmt: skip
def sheet_music(look: Look) -> Shape:
    """A few sheets of music, lying flat."""
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
    return shape([(body, surfaces.stripes([(248, 246, 240), (214, 212, 206)], 4)),
                  (box(x, y, 0.0005).move(z=h - 0.0003), image)], [box_part(x, y, h)])  # fmt: skip


@category("guitar_pick", size=(0.0277, 0.0271, 0.0014), mass=0.001, material="plastic",
          aliases=("plectrum", "guitar plectrum", "pick"), themes=("music",), roles=("flat",),
          colors=("red", "black"))  # fmt: skip
def guitar_pick(look: Look) -> Shape:
    """A plectrum, lying flat."""
    k = look.between(0.95, 1.15)
    color = look.color("red", "black", "amber", "white", "blue", "green", "purple")
    outline = rounded_polygon(np.array([(-0.016, 0.012), (0, -0.02), (0.016, 0.012)]) * k, 0.004, 5)
    body = prism(outline, 0, 0.0014)
    image = surfaces.fit(surfaces.marble(look.rng, color, tint_color(color, 1.3)), 64, 64).copy()
    return shape([(body, image)], [hull_of(body)])


BRIGHT = ("red", "blue", "yellow", "green", "orange", "purple", "teal", "pink")


def _drum(r0: float, h0: float, jingles: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a drum with its skin up, or of a tambourine with jingles."""

    def make(look: Look) -> Shape:
        k = look.between(0.9, 1.1)
        r, h = r0 * k, h0 * k
        color = look.color("red", "blue", "wooden", "green", "orange", "teal")
        body = cylinder(0.97 * r, h, 36)
        wood = surfaces.fit(look.surface(color, "wood"), 48, 192).copy()
        hoop_tone = look.own_color("silver", "wooden", "cream", "gold")
        extra = []
        if jingles:
            for n in range(6):
                prints.fill(wood, n / 6 + 0.03, 0.25, 0.1, 0.5, (40, 34, 30))
                a = 2 * np.pi * (n + 0.48) / 6 + np.pi / 2
                at = (0.95 * r * np.cos(a), 0.95 * r * np.sin(a))
                plate = cylinder(0.0105 * k, 0.0016, 14)
                extra += [plate.move(*at, z * h) for z in (0.4, 0.56)]
        else:
            for n in range(8):
                a, b = (n / 8, 0.1), (n / 8 + 0.0625, 0.9)
                prints.stroke(wood, [a, b, (n / 8 + 0.125, 0.1)], 0.05, (240, 236, 226))
        hoops = [torus(0.98 * r, 0.02 * r + 0.001, 36, 6).move(z=z) for z in
                 ((h - 0.003,) if jingles else (0.0035, h - 0.003))]  # fmt: skip
        skin = cylinder(0.955 * r, 0.0012, 36).move(z=h - 0.0008)
        drawn = [(body, wood), (join(hoops), surfaces.plain(hoop_tone)),
                 (skin, surfaces.speckles(look.rng, (240, 232, 214), 5, 64))]  # fmt: skip
        if extra:
            drawn.append((join(extra), surfaces.plain((222, 198, 120))))
        return shape(drawn, [cylinder_part(0.97 * r, h)])

    return make


@category("drumstick", size=(0.325, 0.0119, 0.0119), mass=0.04, material="wood", assembled=True,
          aliases=("drum stick",), themes=("music",), colors=("wooden",),
          state="lying flat")  # fmt: skip
def drumstick(look: Look) -> Shape:
    """One wooden drumstick, lying flat."""
    k = look.between(0.75, 0.9)
    color = look.color("wooden", "tan", "beige", "wooden", "black", "red")
    body = lathe(np.array([(0, 0), (0.0055, 0.001), (0.0072, 0.006), (0.0072, 0.28),
        (0.0035, 0.375),
                           (0.0052, 0.384), (0.005, 0.391), (0, 0.395)]) * k, 16)  # fmt: skip
    body = lay_down(body, -0.2 * k, 0.0072 * k)
    return shape([(body, look.surface(color, "wood"))], [flat_foot(body.vertices, 0.12)])


@category("maraca", size=(0.197, 0.067, 0.067), mass=0.09, material="wood", assembled=True,
          aliases=("rumba shaker", "maracas shaker", "maracas"), themes=("music",),
          colors=("red", "yellow"))  # fmt: skip
def maraca(look: Look) -> Shape:
    """A maraca lying flat: a painted gourd on a handle."""
    k = look.between(0.85, 1.02)
    color = look.color(*BRIGHT)
    image = prints.canvas(128, 96, color)
    other = look.own_color("yellow", "white", "cream", "black")
    for n in range(8):
        prints.polygon(image, [(n / 8, 0.62), (n / 8 + 0.0625, 0.4), (n / 8 + 0.125, 0.62)], other)
    for y in (0.28, 0.7):
        prints.fill(image, 0, y, 1, 0.05, other)
    a = np.linspace(-1.35, np.pi / 2, 14)
    curve = np.column_stack([0.036 * np.cos(a), 0.165 + 0.046 * np.sin(a)])
    curve[-1, 0] = 0
    head = lathe(np.concatenate([[(0, curve[0, 1])], curve]) * k, 26)
    grip = lathe(np.array([(0, 0), (0.009, 0), (0.0105, 0.01), (0.0085, 0.04), (0.0095, 0.12),
                           (0, 0.124)]) * k, 16)  # fmt: skip
    lean = np.arctan2(0.026, 0.165)
    laid = [s.turn(1, np.pi / 2 - 0.0).turn(1, 0.0) for s in (head, grip)]
    laid = [s.turn(1, -lean) for s in laid]
    low = min(float(s.bounds[0, 2]) for s in laid)
    head, grip = (s.move(x=-0.1 * k, z=-low) for s in laid)
    wood = surfaces.wood(look.rng, (196, 150, 100), side=64)
    return shape([(head, image), (grip, wood)],
                 [flat_foot(head.vertices, 0.08), hull_of(grip)])  # fmt: skip


@category("xylophone", size=(0.247, 0.143, 0.055), mass=0.5, material="metal", assembled=True,
          aliases=("glockenspiel", "toy xylophone", "metallophone"), themes=("music",),
          roles=("big",))  # fmt: skip
def xylophone(look: Look) -> Shape:
    """A toy xylophone: rainbow-coloured bars on two rails with a mallet on top."""
    k = look.between(0.9, 1.08)
    wood = look.surface(look.color("wooden", "tan", "white"), "wood")
    tones = ((206, 48, 50), (238, 132, 38), (244, 206, 62), (110, 180, 70), (60, 150, 160),
             (48, 98, 180), (110, 74, 160), (220, 100, 150))  # fmt: skip
    pieces, parts = [], []
    for s in (-1, 1):
        rail = box(0.25 * k, 0.014 * k, 0.028 * k).turn(2, -s * 0.11).move(y=s * 0.038 * k)
        pieces.append((rail, wood))
    for n, tone in enumerate(tones):
        bar = block(0.025 * k, (0.145 - 0.0095 * n) * k, 0.007 * k, 0.003, 0.001)
        bar = bar.move(x=(-0.109 + 0.031 * n) * k, z=0.028 * k)
        pieces.append((bar, surfaces.brushed_metal(look.rng, tone)))
        pins = [cylinder(0.0032 * k, 0.0025, 8).move((-0.109 + 0.031 * n) * k, s *
                (0.057 - 0.004 * n) * k, 0.0345 * k) for s in (-1, 1)]  # fmt: skip
        pieces.append((join(pins), surfaces.plain((230, 230, 228))))
    stick = tube([(-0.09 * k, 0.012 * k, 0.0405 * k), (0.06 * k, -0.02 * k, 0.0405 * k)],
                 0.0032 * k, 8)  # fmt: skip
    ball = ellipsoid(0.02, 0.02, 0.02, 14, 8).scale(k, k, k).move(0.065 * k, -0.021 * k, 0.045 * k)
    pieces += [(stick, wood), (ball, surfaces.plain((196, 42, 40)))]
    parts = [hull_of(*[p[0] for p in pieces[2::2] if p[0].bounds[1, 2] < 0.0352 * k][:8]),
             hull_of(*[p[0] for p in pieces[:2]])]  # fmt: skip
    return shape(pieces, parts)


@category("triangle", size=(0.14, 0.135, 0.018), mass=0.16, material="metal", assembled=True,
          aliases=("musical triangle", "triangle instrument", "steel triangle"), themes=("music",),
          roles=("flat",), colors=("silver",))  # fmt: skip
def triangle(look: Look) -> Shape:
    """A steel triangle lying flat with its beater across it."""
    k = look.between(0.85, 1.1)
    r = 0.0045 * k
    corners = rounded_polygon(np.array([(-0.075, -0.055), (0.075, -0.055), (0.0, 0.075)]), 0.012, 4)
    way = np.roll(corners, -4, 0) * k
    way = np.column_stack([way, np.full(len(way), r)])
    way[-1] = way[-2] + 0.82 * (way[-1] - way[-2])
    bar = tube(way[:-2], r, 8)
    beater = tube(np.array([(-0.06, 0.055, 0.012), (0.05, -0.075, 0.012)]) * k, 0.003 * k, 8)
    knob = (
        ellipsoid(0.012, 0.012, 0.012, 10, 8).scale(k, k, k).move(0.05 * k, -0.075 * k, 0.012 * k)
    )
    metal = look.surface(look.color("silver", "silver", "gold", "charcoal"), "metal")
    steel = surfaces.brushed_metal(look.rng, (190, 192, 196))
    sides = [hull_of(tube(way[[a, b]], r, 8)) for a, b in ((0, 6), (5, 11), (10, len(way) - 3))]
    return shape([(bar, metal), (join([beater, knob]), steel)], [*sides, hull_of(beater)])


@category("hand_bell", size=(0.074, 0.074, 0.128), mass=0.22, material="metal", hollow=True,
          aliases=("handbell", "school bell", "dinner bell", "brass bell", "bell favour",
          "tibetan bell", "altar bell", "sanctus bell"), themes=("music",), roles=("round",),
          colors=("brass", "gold"))  # fmt: skip
def hand_bell(look: Look) -> Shape:
    """A bell with a handle, standing on its rim."""
    k = look.between(0.85, 1.1)
    metal = look.surface(look.color("brass", "gold", "silver", "copper", "bronze"), "metal")
    bell = lathe(np.array([(0, 0.03), (0.026, 0.025), (0.034, 0.0), (0.038, 0.0), (0.031, 0.014),
                           (0.026, 0.034), (0.023, 0.05), (0.012, 0.058), (0, 0.06)]) * k,
                               32)  # fmt: skip
    grip = lathe(np.array([(0, 0.058), (0.006, 0.058), (0.0095, 0.075), (0.008, 0.1),
                           (0.0115, 0.118), (0.009, 0.128), (0, 0.131)]) * k, 20)  # fmt: skip
    wood = look.own_color("brown", "black", "wooden", "maroon")
    return shape([(bell, metal), (grip, surfaces.wood(look.rng, wood, side=64))],
                 [hull_of(bell), hull_of(grip)])  # fmt: skip


@category("cymbal", size=(0.195, 0.195, 0.0273), mass=0.35, material="metal",
          aliases=("crash cymbal",), themes=("music",), roles=("round", "flat"),
          colors=("gold",))  # fmt: skip
def cymbal(look: Look) -> Shape:
    """A brass cymbal lying with its dome up."""
    k = look.between(0.85, 1.1)
    metal = look.surface(look.color("gold", "brass", "gold", "bronze"), "metal")
    body = lathe(np.array([(0, 0.018), (0.022, 0.014), (0.03, 0.005), (0.098, 0.0), (0.1, 0.0008),
                           (0.03, 0.0085), (0.024, 0.016), (0.012, 0.0215), (0, 0.023)]) * k,
                               40)  # fmt: skip
    grooves = [torus(r * k, 0.0006, 40, 4).move(z=(0.0085 - 0.0077 * (r - 0.03) / 0.07) * k)
               for r in (0.05, 0.065, 0.08)]  # fmt: skip
    knob = cylinder(0.004 * k, 0.006 * k, 12).move(z=0.022 * k)
    return shape([(body, metal), (join([*grooves, knob]), surfaces.plain((150, 116, 60)))],
                 [hull_of(body)])  # fmt: skip


def _keys(octaves: int, panel: bool) -> Callable[[Look], Shape]:
    """Return the shape function of a piano keyboard, optionally with buttons behind it."""

    def make(look: Look) -> Shape:
        k = look.between(0.94, 1.06)
        whites = 7 * octaves + 1
        x, y, h = (0.019 * whites + 0.02) * k, (0.17 if panel else 0.11) * k, 0.03 * k
        color = look.color("black", "charcoal", "red", "white", "black", "sky", "pink")
        image = prints.canvas(256, 96, (246, 245, 240))
        for n in range(whites):
            prints.fill(image, n / whites - 0.002, 0, 0.005, 1, (120, 120, 120))
        for n in range(whites - 1):
            if n % 7 not in (2, 6):
                prints.fill(image, (n + 0.72) / whites, 0, 0.56 / whites, 0.6, (28, 28, 30))
        deep = 0.092 * k
        body = block(x, y, h, 0.008, 0.002)
        field = box(x - 0.02 * k, deep, 0.003).move(y=-(y - deep) / 2 + 0.006 * k, z=h - 0.001)
        blacks = [box(0.0105 * k, 0.6 * deep, 0.006 * k).move(
            x=((n + 1) / whites - 0.5) * (x - 0.02 * k), y=-(y - deep) / 2 + 0.006 * k + 0.2 * deep,
            z=h + 0.0015) for n in range(whites - 1) if n % 7 not in (2, 6)]  # fmt: skip
        pieces = [(body, look.surface(color, "plastic")), (field, image),
                  (join(blacks), surfaces.plain((28, 28, 30)))]  # fmt: skip
        if panel:
            board = prints.canvas(192, 40, tint_color(color, 0.8))
            prints.fill(board, 0.4, 0.15, 0.2, 0.5, (150, 200, 190))
            for n in range(8):
                u = 0.12 + 0.03 * n if n < 7 else 0.36
                prints.disc(board, u, 0.3, 0.1, (210, 80, 70) if n % 3 == 0 else (200, 200, 200))
                prints.disc(board, 1 - u, 0.3 if n % 2 else 0.65, 0.11, (190, 190, 194))
            pieces.append((box(0.97 * x, 0.05 * k, 0.0015).move(y=y / 2 - 0.03 * k, z=h - 0.0005),
                           board))  # fmt: skip
        return shape(pieces, [box_part(x, y, h + 0.002)])

    return make


@category("drum_pad", size=(0.19, 0.2, 0.041), mass=0.7, material="device", aliases=("midi pad",
          "midi controller", "pad controller", "drum machine", "beat pad", "launchpad",
          "groovebox"), themes=("music",), colors=("black",))  # fmt: skip
def drum_pad(look: Look) -> Shape:
    """A pad controller with sixteen lit rubber pads and knobs."""
    k = look.between(0.92, 1.08)
    color = look.color("black", "charcoal", "white", "black", "gray")
    x, y, h = 0.19 * k, 0.2 * k, 0.03 * k
    pieces = [(block(x, y, h, 0.008, 0.002), look.surface(color, "plastic"))]
    lights = [look.own_color("red", "orange", "cyan", "lime", "magenta") for _ in range(3)]
    for n in range(16):
        pad = block(0.036 * k, 0.036 * k, 0.005, 0.003, 0.001)
        tone = lights[int(look.rng.integers(3))] if look.chance(0.45) else (120, 122, 126)
        at = ((n % 4 - 1.5) * 0.042 * k, (n // 4 - 1.5) * 0.042 * k - 0.014 * k, h - 0.001)
        pieces.append((pad.move(*at), surfaces.plain(tone)))
    knobs = [cylinder(0.007 * k, 0.012 * k, 14, top=0.006 * k).move((n - 1.5) * 0.042 * k,
             0.082 * k, h - 0.001) for n in range(4)]  # fmt: skip
    pieces.append((join(knobs), surfaces.plain((60, 60, 64) if sum(color) > 300 else
                                               (190, 190, 194))))  # fmt: skip
    return shape(pieces, [box_part(x, y, h + 0.003), *[hull_of(s) for s in knobs]])


@category("audio_interface", size=(0.178, 0.113, 0.0446), mass=0.6, material="device",
          aliases=("sound card", "audio mixer box", "sound interface", "usb audio interface"),
          themes=("music",), colors=("red", "black"))  # fmt: skip
def audio_interface(look: Look) -> Shape:
    """An audio interface: a flat box with sockets and knobs on its front."""
    color = look.color("red", "black", "silver", "charcoal")
    k = look.between(0.85, 1.1)
    body = block(0.18, 0.1, 0.045, 0.006, 0.003)
    front = at_box(0.172, 0.002, 0.037, (0, -0.0505, 0.004))
    jacks = [drum(0.0105, 0.004, (x, -0.0545, 0.022), 1) for x in (-0.066, -0.008)]
    knobs = [drum(0.009, 0.013, (x, -0.0635, 0.024), 1) for x in (-0.038, 0.02)]
    big = drum(0.014, 0.014, (0.056, -0.0645, 0.022), 1)
    rings = [torus(0.0105, 0.0012, 18, 5).turn(0, np.pi / 2).move(x, -0.0515, 0.024)
             for x in (-0.038, 0.02)]  # fmt: skip
    return put_down([(body, look.surface(color, "metal")), (front, plain((34, 34, 38))),
                     (join(jacks), plain((120, 122, 128))), (join([*knobs, big]), steel(look)),
                     (join(rings), plain((90, 210, 110)))], body, join([*knobs, big]),
                    factor=k)  # fmt: skip


CATEGORIES = (
    Category("flute", _pipe([(0, 0), (0.0095, 0), (0.0095, 0.16), (0.0105, 0.162), (0.0105, 0.175),
             (0.0095, 0.177), (0.0095, 0.44), (0, 0.44)], ("silver", "silver", "gold"), "metal",
             keys=True, bore=0.0095), size=(0.44, 0.021, 0.021), mass=0.35, material="metal",
             aliases=("transverse flute", "piccolo", "fife"), themes=("music",), colors=("silver",),
             state="lying flat"),
    Category("recorder", _pipe([(0, 0), (0.007, 0), (0.0105, 0.03), (0.0145, 0.05), (0.0145, 0.06),
             (0.011, 0.07), (0.0095, 0.24), (0.0145, 0.25), (0.0145, 0.262), (0.01, 0.27),
             (0.0125, 0.31), (0, 0.312)], ("cream", "wooden", "brown", "tan", "green"), "wood",
             keys=False, bore=0.0115), size=(0.312, 0.029, 0.029), mass=0.15, material="wood",
             aliases=("wooden flute", "recorder flute"), themes=("music",),
             colors=("wooden", "cream"), state="lying flat"),
    Category("clarinet", keep_still(_pipe([(0, 0), (0.004, 0), (0.009, 0.05), (0.013, 0.055),
             (0.013, 0.11), (0.0105, 0.113), (0.0105, 0.42), (0.014, 0.47), (0.0285, 0.51),
             (0.0285, 0.514), (0, 0.51)], ("black", "black", "charcoal", "brown"), "plastic",
             keys=True, bore=0.011)), size=(0.514, 0.057, 0.057), mass=0.6, material="wood",
             aliases=("clarinet toy", "oboe", "chanter", "cor anglais"), themes=("music",),
             colors=("black",), state="lying flat"),
    Category("drum", _drum(0.1, 0.12, False), size=(0.2, 0.2, 0.12), mass=0.7, material="wood",
             hollow=True, aliases=("toy drum", "snare drum", "hand drum", "small drum",
             "toy drum ornament", "drum ornament"), themes=("music",), roles=("round", "big"),
             colors=("red",)),
    Category("tambourine", _drum(0.1, 0.045, True), size=(0.2, 0.2, 0.045), mass=0.3,
             material="wood", hollow=True, aliases=("tambourin", "timbrel"), themes=("music",),
             roles=("round", "flat", "big"), colors=("wooden",)),
    Category("synthesizer", _keys(3, True), size=(0.438, 0.17, 0.036), mass=1.6, material="device",
             aliases=("piano keyboard", "keyboard piano", "electric piano", "synth",
             "electronic keyboard", "midi keyboard", "music keyboard", "synthesiser",
             "musical keyboard", "electric keyboard"), themes=("music",), roles=("big",),
             colors=("black",)),
    Category("toy_piano", _keys(2, False), size=(0.305, 0.11, 0.036), mass=0.8, material="wood",
             aliases=("piano", "mini piano", "keyboard toy", "piano toy"), themes=("music",),
             roles=("big",), colors=("red", "black")),
)  # fmt: skip
"""Objects that share their drawing functions."""
