"""Balls of one sport each, and game pieces: chips, dominoes, marbles, stacking cups."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import cylinder_part, flat_foot, hull_of, resting_ball
from ...build.outlines import ellipse
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, lathe, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look
from ..food.food import press_flat
from ..leisure.leisure import football_skin, seam


def _ball(d: float, cover: textures.Tile, seams: list[Solid], ink: RGB, *, fine: int = 28) -> Shape:
    """Return a ball of diameter ``d`` with raised or printed seams, resting on a small flat."""
    core = ellipsoid(d, d, d, fine, 18)
    pieces = [(press_flat(core, 0.488 * d), cover)]
    if seams:
        pieces.append((press_flat(join(seams), 0.488 * d), textures.plain(ink)))
    return shape(pieces, [resting_ball(d, d, 0.985 * d)])


def tennis_ball(look: Look) -> Shape:
    """A yellow-green felt ball with its white seam."""
    d, color = look.between(0.064, 0.068), look.color("lime", "lime", "yellow", "lime", spread=16)
    cover = textures.scratches(look.rng, color, tint_color(color, 1.3), int(look.between(120, 320)))
    turn = look.between(-1, 1)
    return _ball(d, cover, [seam(0.495 * d, 0.75).turn(0, turn).turn(2, 2 * turn)],
                 (240, 240, 236))  # fmt: skip


def baseball(look: Look) -> Shape:
    """A white leather ball with red stitches along its seam."""
    d, color = look.between(0.071, 0.076), look.color("white", "white", "cream", "ivory", spread=14)
    cover = textures.speckles(look.rng, color, 6)
    turn = look.between(-1, 1)
    line = seam(0.495 * d, 0.75)
    stitches = []
    path = line.vertices
    for k in range(0, len(path), max(len(path) // 46, 1)):
        at = path[k] * 0.5 * d / np.linalg.norm(path[k])
        stitches.append(ellipsoid(0.0045, 0.002, 0.0026, 6, 4).turn(2, k).move(*at))
    both = join([line, *stitches]).turn(0, turn).turn(2, 2 * turn)
    return _ball(d, cover, [both], look.own_color("red", "crimson", "red", spread=20))


def basketball(look: Look) -> Shape:
    """An orange pebbled ball with black seams, small as for a desk or of full size."""
    d = look.pick([look.between(0.1, 0.15), look.between(0.2, 0.24)])
    color = look.color("orange", "orange", "copper", "terracotta", spread=16)
    cover = textures.spots(look.rng, color, tint_color(color, 0.75), 0.2)
    circle = np.column_stack([0.496 * d * ellipse(2, 2, 40), np.zeros(40)])
    ring = tube(circle, 0.011 * d, 5, loop=True)
    bows = [ring.turn(0, np.pi / 2), ring.turn(1, np.pi / 2)]
    lines = join([ring, *bows, seam(0.496 * d, 0.6)])
    turn = look.between(-0.6, 0.6)
    return _ball(d, cover, [lines.turn(0, 0.5 + turn).turn(2, turn)], (40, 34, 32))


def soccer_ball(look: Look) -> Shape:
    """A football of dark pentagons among pale hexagons, small or of full size."""
    d = look.pick([look.between(0.09, 0.14), look.between(0.19, 0.22)])
    color = look.color("white", "white", "white", "white", "yellow", "sky", spread=14)
    ink = look.pick([(30, 32, 36), (30, 32, 36), (30, 60, 140), (180, 30, 40)])
    return _ball(d, football_skin(color, ink), [], (0, 0, 0), fine=32)


def golf_ball(look: Look) -> Shape:
    """A dimpled golf ball, white or coloured, a mark on it."""
    d = 0.0427
    color = look.color("white", "white", "white", "yellow", "orange", "pink", "lime", spread=12)
    image = prints.canvas(192, 96, color)
    v, u = np.mgrid[0:96, 0:192]
    rows = 9
    lat = np.floor(v / 96 * rows)
    around = np.round(22 * np.sin(np.pi * (lat + 0.5) / rows)).clip(3)
    x = (u / 192 * around + 0.5 * (lat % 2)) % 1 - 0.5
    y = (v / 96 * rows) % 1 - 0.5
    dots = np.hypot(x, y) < 0.3
    image[dots] = np.array(tint_color(color, 0.86)).astype(np.uint8)
    part = image[36:60, 80:112]
    word = look.pick(["1", "2", "3", "PRO", "GOLF", "4"])
    prints.write(
        part, word, 0.5, 0.5, 0.6, look.own_color("red", "blue", "black", "green"), bold=True
    )
    return _ball(d, image, [], (0, 0, 0))


def american_football(look: Look) -> Shape:
    """A pointed leather ball with white stripes and laces, lying."""
    k = look.pick([look.between(0.55, 0.7), look.between(0.9, 1.0)])
    color = look.color("brown", "brown", "bronze", "maroon", "terracotta")
    t = np.linspace(-1, 1, 19)
    wide = 0.086 * k * np.sqrt(np.clip(1 - np.abs(t) ** 1.7, 0, 1))
    body = lathe(np.column_stack([wide, 0.14 * k * t]), 26)
    leather = textures.spots(look.rng, color, tint_color(color, 0.75), 0.2)
    band = textures.plain((238, 236, 230))
    striped = look.chance(0.6)
    tile = textures.stack((leather, 17), (band if striped else leather, 5), (leather, 56),
                            (band if striped else leather, 5), (leather, 17), side=128)  # fmt: skip
    body = body.turn(1, np.pi / 2).move(z=0.086 * k)
    lace = [box(0.07 * k, 0.006 * k, 0.004).move(z=0.171 * k)]
    lace += [box(0.004 * k, 0.03 * k, 0.004).move(x=(n - 3) * 0.0105 * k, z=0.1715 * k)
             for n in range(7)]  # fmt: skip
    tilt = look.between(0.1, 0.5)
    core = body.move(z=-0.086 * k).turn(0, tilt).move(z=0.085 * k)
    laces = join(lace).move(z=-0.086 * k).turn(0, tilt).move(z=0.085 * k)
    return shape(
        [
            (core.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)])), tile),
            (laces, textures.plain((240, 238, 232))),
        ],
        [flat_foot(core.vertices, 0.06)],
    )


def poker_chips(look: Look) -> Shape:
    """Two to four stacks of poker chips of different colours."""
    r, t = look.between(0.0185, 0.0205), 0.0034
    color = look.color("red", "blue", "green", "black", "purple", "orange")
    others = [
        look.own_color("white", "red", "blue", "green", "black", "purple", "yellow")
        for _ in range(3)
    ]
    edge_count = 6
    pieces, parts = [], []
    places = [(0.0, 0.0), (2.12 * r, 0.3 * r), (0.95 * r, -1.95 * r), (-1.15 * r, -1.8 * r)]
    for n in range(int(look.rng.integers(2, 5))):
        tone = color if n == 0 else others[n - 1]
        mark: RGB = (244, 242, 236) if sum(tone) < 560 else (40, 44, 60)
        side = textures.stripes([mark, tone, tone, tone], edge_count, upright=True, side=96)
        high = int(look.rng.integers(3, 11))
        stack = np.concatenate(
            [
                np.concatenate(
                    [side, np.tile((np.array(tone) * 0.5).astype(np.uint8), (10, 96, 1))]
                )
                for _ in range(high)
            ]
        )
        stack = textures.fit(stack, min(24 * high, 192), 96)
        face = prints.canvas(96, 96, tone)
        for k in range(edge_count):
            a = 2 * np.pi * k / edge_count
            way = [(0.5 + s * np.cos(a), 0.5 + s * np.sin(a)) for s in (0.36, 0.52)]
            prints.stroke(face, way, 0.1, mark)
        prints.disc(face, 0.5, 0.5, 0.33, mark, 0.3)
        prints.write(
            face, look.pick(["5", "10", "25", "50", "100"]), 0.5, 0.5, 0.26, mark, bold=True
        )
        x, y = places[n]
        turn = look.between(0, 1)
        chip = cylinder(r, t * high, 36).turn(2, turn).move(x, y)
        top = cylinder(0.985 * r, 0.0004, 32).turn(2, turn).move(x, y, t * high - 0.0001)
        pieces += [(chip, stack), (top, face)]
        parts.append(cylinder_part(r, t * high, (x, y, 0)))
    return shape(pieces, parts)


def dominoes(look: Look) -> Shape:
    """Dominoes: a chain lying on the table, or a row of them standing."""
    x, y, h = 0.024, 0.048, 0.0085
    color = look.color("ivory", "white", "black", "ivory", "red", "wooden", "teal")
    ink: RGB = (34, 34, 38) if sum(color) > 380 else (246, 244, 238)
    skin = textures.speckles(look.rng, color, 4, 32)

    def face() -> textures.Tile:
        halves = []
        for n in look.rng.integers(1, 7, 2):
            half = prints.pips(int(n), color, ink)
            halves.append(textures.fit(half, 64, 64))
        image = np.concatenate(halves)
        prints.fill(image, 0.08, 0.492, 0.84, 0.016, ink)
        return image

    pieces, parts = [], []
    top = box(0.96 * x, 0.97 * y, 0.0004)
    if look.chance(0.5):
        at, turn = np.zeros(2), 0.0
        for n in range(int(look.rng.integers(4, 7))):
            one = block(x, y, h, 0.002, 0.001).turn(2, np.pi / 2 + turn).move(at[0], at[1])
            pieces += [(one, skin), (top.move(z=h - 0.0001).turn(2, np.pi / 2 + turn)
                                     .move(at[0], at[1]), face())]  # fmt: skip
            parts.append(hull_of(one))
            at = at + 1.02 * y * np.array([np.cos(turn), np.sin(turn)])
            if n == 2 and look.chance(0.6):
                at = at - 1.02 * y * np.array([np.cos(turn), np.sin(turn)]) + np.array(
                    [0.75 * y, 0.27 * y])  # fmt: skip
                turn = np.pi / 2
                at = at + np.array([0, -0.02 * y])
    else:
        count = int(look.rng.integers(4, 8))
        for n in range(count):
            u = (n - (count - 1) / 2) * 0.024
            one = block(x, y, h, 0.002, 0.001).turn(0, np.pi / 2).turn(2, -np.pi / 2)
            sign = top.move(z=h - 0.0001).turn(0, np.pi / 2).turn(2, -np.pi / 2)
            way = 0.004 * np.sin(1.2 * n)
            pieces += [(one.move(u, way, y / 2), skin), (sign.move(u, way, y / 2), face())]
            parts.append(hull_of(one.move(u, way, y / 2)))
    return shape(pieces, parts)


def marbles(look: Look) -> Shape:
    """A handful of glass marbles close together."""
    color = look.color("blue", "green", "red", "amber", "violet", "cyan", "orange")
    pieces, parts = [], []
    for n in range(int(look.rng.integers(4, 8))):
        d = look.between(0.015, 0.018)
        away, turn = 0.0115 * np.sqrt(3 * n) if n else 0.0, 2.4 * n
        tone = (
            color
            if n == 0
            else look.own_color("blue", "green", "red", "amber", "violet", "white", "teal")
        )
        swirl = textures.marble(look.rng, tone, tint_color(tone, 1.7), 64)
        ball = press_flat(ellipsoid(d, d, d, 18, 12), 0.485 * d)
        at = (away * np.cos(turn), away * np.sin(turn))
        pieces.append((ball.move(*at), swirl))
        part = resting_ball(d, d, 0.98 * d)
        parts.append(type(part)(part.vertices + np.array([*at, 0])))
    return shape(pieces, parts)


def stacking_cups(look: Look) -> Shape:
    """A tower of nesting cups, the largest below, upside down."""
    names = ["red", "orange", "yellow", "green", "blue", "purple", "pink"]
    start = int(look.rng.integers(len(names)))
    shades = look.color("red", "orange", "yellow", "green", "blue", "purple", "pink")
    count = int(look.rng.integers(4, 7))
    r, h = look.between(0.04, 0.046), look.between(0.032, 0.038)
    pieces, parts, z = [], [], 0.0
    for n in range(count):
        tone = shades if n == 0 else look.own_color(names[(start + n) % len(names)])
        k = 1 - 0.12 * n
        cup = lathe(
            [
                (0, 0),
                (r * k, 0),
                (1.03 * r * k, 0.001),
                (1.03 * r * k, 0.005),
                (r * k, 0.006),
                (0.82 * r * k, h * k),
                (0, h * k),
            ],
            28,
        )
        ring = torus(0.5 * r * k, 0.0012, 20, 5).move(z=h * k)
        pieces.append((join([cup, ring]).move(z=z), textures.speckles(look.rng, tone, 4, 32)))
        parts.append(hull_of(cup.move(z=z)))
        z += h * k
    return shape(pieces, parts)


def toy_airplane(look: Look) -> Shape:
    """A toy aeroplane: a stout body, broad wings, a propeller or jets under its wings."""
    k = look.between(0.9, 1.15)
    color = look.color("red", "yellow", "blue", "white", "orange", "green", "silver", "wooden")
    skin = look.surface(color, "plastic")
    other = textures.plain(look.own_color("blue", "red", "yellow", "white", "navy", "orange"))
    body = lathe(
        [(0, 0), (0.014, 0.004), (0.021, 0.03), (0.021, 0.08), (0.009, 0.15), (0, 0.155)], 22
    )
    body = body.scale(k, k, k).turn(1, np.pi / 2).move(-0.075 * k, 0, 0.04 * k)
    wing = block(0.042 * k, 0.19 * k, 0.006 * k, 0.018 * k, 0.002).move(-0.015 * k, 0, 0.032 * k)
    tail = block(0.022 * k, 0.07 * k, 0.004 * k, 0.01 * k, 0.001).move(0.066 * k, 0, 0.042 * k)
    fin = block(0.026 * k, 0.034 * k, 0.004 * k, 0.009 * k, 0.001).turn(0, np.pi / 2)
    fin = fin.move(0.066 * k, 0.002 * k, 0.058 * k)
    glass = ellipsoid(0.04 * k, 0.024 * k, 0.026 * k, 16, 10).move(-0.022 * k, 0, 0.058 * k)
    pieces = [(join([body]), skin), (join([wing, tail, fin]), other),
              (glass, textures.plain((40, 54, 70)))]  # fmt: skip
    parts = [hull_of(body), hull_of(wing), hull_of(tail), hull_of(fin), hull_of(glass)]
    dark = textures.plain((44, 46, 50))
    if look.chance(0.6):
        hub = lathe([(0, 0), (0.006, 0), (0, 0.012)], 14).scale(k, k, k)
        hub = hub.turn(1, -np.pi / 2).move(x=-0.074 * k, z=0.04 * k)
        blades = box(0.003 * k, 0.075 * k, 0.009 * k).move(x=-0.079 * k, z=0.0355 * k)
        pieces.append((join([hub, blades]), dark))
        parts.append(hull_of(hub))
    else:
        pods = [lathe([(0, 0), (0.008, 0), (0.0095, 0.012), (0.006, 0.034), (0, 0.034)], 16)
                .scale(k, k, k).turn(1, np.pi / 2).move(-0.04 * k, s * 0.05 * k, 0.025 * k)
                for s in (-1, 1)]  # fmt: skip
        pieces.append((join(pods), dark))
        parts += [hull_of(p) for p in pods]
    wheels, legs = [], []
    for x, y in ((-0.045, 0.022), (-0.045, -0.022), (0.06, 0.0)):
        r = 0.011 * k if x < 0 else 0.006 * k
        wheels.append(cylinder(r, 0.007 * k, 16, bevel=0.001).turn(0, np.pi / 2)
                      .move(x * k, y * k + 0.0035 * k, r))  # fmt: skip
        legs.append(tube([(x * k, y * k, r), (x * k, 0.6 * y * k, 0.035 * k)], 0.0024 * k, 6))
    pieces.append((join([*wheels, *legs]), dark))
    return shape(pieces, [*parts, *(hull_of(w) for w in wheels)])


CATEGORIES = (
    Category("tennis_ball", tennis_ball, (0.066, 0.066, 0.065), 0.058, ("racquetball", "padel ball",
             "squash ball"), ("sports",), ("round",), ("lime",)),
    Category("baseball", baseball, (0.074, 0.074, 0.073), 0.145, ("softball",), ("sports",),
             ("round",), ("white",)),
    Category("basketball", basketball, (0.152, 0.15, 0.149), 0.35, ("mini basketball",
             "basket ball"), ("sports",), ("round", "big"), ("orange",)),
    Category("soccer_ball", soccer_ball, (0.16, 0.16, 0.158), 0.28, ("football", "mini soccer ball",
             "soccerball", "foot ball"), ("sports",), ("round", "big"), ("white",)),
    Category("golf_ball", golf_ball, (0.0427, 0.0427, 0.0422), 0.046, ("golfball",), ("sports",),
             ("round",), ("white",)),
    Category("american_football", american_football, (0.197, 0.121, 0.124), 0.28, ("nfl football",
             "nfl ball"), ("sports",), ("big",), ("brown",), state="lying down"),
    Category("poker_chips", poker_chips, (0.0895, 0.0642, 0.0279), 0.2, ("casino chips",
             "stack of poker chips", "gambling chips", "betting chips", "stacks of poker chips",
             "gaming chips"), ("games",), ("flat",), ("red", "blue")),
    Category("dominoes", dominoes, (0.121, 0.0533, 0.0382), 0.08, ("domino tiles",
             "row of dominoes", "domino set", "mahjong tiles", "stack of dominoes",
             "pile of dominoes", "line of dominoes", "box of dominoes"), ("games", "toys"), (),
             ("ivory", "black")),
    Category("marbles", marbles, (0.075, 0.07, 0.017), 0.04, ("glass marbles", "handful of marbles",
             "glass marble", "toy marbles", "toy marble", "glass beads",
             "bead string"), ("games", "toys"), (),
             ("blue", "green")),
    Category("stacking_cups", stacking_cups, (0.088, 0.088, 0.14), 0.12, ("nesting cups",
             "stacking cup", "stack cups", "tower of cups", "toy cups"), ("toys",), ("round",
             "tall"), ("red", "blue")),
    Category("toy_airplane", toy_airplane, (0.169, 0.2, 0.0788), 0.13, ("airplane", "aeroplane",
             "plane", "model airplane", "toy plane", "model plane", "aircraft", "toy aeroplane",
             "toy jet", "jet", "toy aircraft", "airplane toy"), ("toys",), (), ("red", "yellow")),
)  # fmt: skip
"""The module's categories."""
