"""Christmas things: trees, baubles, figures, houses of gingerbread."""

from __future__ import annotations

import numpy as np

from ...build.category import Category
from ...build.collision import hull_of, hull_part
from ...build.forms import side_view
from ...build.outlines import smooth
from ...build.recipes import Pieces, ball, pad, put_down, rod, standing_plate, straight
from ...build.shape import Shape, shape
from ...build.solids import Solid, box, cylinder, ellipsoid, join, lathe, prism, torus
from ...surfaces import textures
from ...surfaces.colors import tint_color
from ...surfaces.look import Look

GOLD = (222, 180, 80)


def star_outline(r: float, inner: float = 0.42, points: int = 5) -> np.ndarray:
    """Return a star's outline (counter-clockwise), one point upwards."""
    a = np.pi / 2 + np.pi * np.arange(2 * points) / points
    away = np.where(np.arange(2 * points) % 2 == 0, r, inner * r)
    return np.column_stack([away * np.cos(a), away * np.sin(a)])


def christmas_tree(look: Look) -> Shape:
    """A small Christmas tree in a pot with balls and a star."""
    color = look.color("green", "green", "teal", "white", "olive")
    h = look.between(0.2, 0.26)
    tiers: list[Solid] = []
    for k in range(4):
        r = 0.078 * (1 - 0.2 * k)
        z = 0.045 + 0.2 * (h - 0.05) * k
        n = 22
        ring = np.where(np.arange(n) % 2 == 0, 1.0, 0.84)
        cone = cylinder(r, 0.36 * h, n, top=0.006)
        a = np.arctan2(cone.vertices[:, 1], cone.vertices[:, 0])
        step = ((a / (2 * np.pi) * n).round().astype(int)) % n
        f = np.where(cone.vertices[:, 2] < 0.01, ring[step], 1.0)[:, None]
        tiers.append(cone.bend(lambda p, f=f: p * np.column_stack([f, f, np.ones(len(p))]))
                     .turn(2, 0.4 * k).move(z=z))  # fmt: skip
    balls: dict[int, list[Solid]] = {0: [], 1: [], 2: []}
    for k in range(16):
        t = (k + 0.5) / 16
        z = 0.06 + 0.72 * (h - 0.06) * t
        r = 0.074 * (1 - 0.83 * t)
        balls[k % 3].append(
            ball(0.014, 0.014, 0.014, (r * np.cos(2.4 * k), r * np.sin(2.4 * k), z), 8)
        )
    top = max(float(t.bounds[1, 2]) for t in tiers)
    star = standing_plate(star_outline(0.02), 0.006).move(z=top + 0.012)
    trunk = cylinder(0.011, 0.05, 12)
    pot = cylinder(0.03, 0.032, 20, top=0.037)
    fir = textures.scratches(look.rng, color, tint_color(color, 1.35), 120)
    hues = [look.own_color("red", "blue", "purple"), GOLD, (236, 236, 240)]
    pieces: Pieces = [
        (join(tiers), fir),
        (trunk, textures.plain((96, 68, 46))),
        (pot, textures.speckles(look.rng, look.own_color("red", "brown", "white"), 5)),
        (star, textures.plain((240, 196, 70))),
    ]
    pieces += [(join(balls[k]), textures.plain(hues[k])) for k in range(3)]
    return put_down(pieces, pot, tiers[0], join(tiers[1:]), star)


def bauble(look: Look) -> Shape:
    """A glass ball for a Christmas tree with its cap and loop."""
    d = look.between(0.055, 0.08)
    color = look.color("red", "gold", "silver", "green", "blue", "purple", "pink")
    kind = look.pick(["plain", "band", "dots"])
    tile = textures.gradient(tint_color(color, 0.75), tint_color(color, 1.25), look.rng, 3)
    if kind != "plain":
        pale = tint_color(color, 1.75)
        other = textures.plain(pale)
        tile = (
            textures.stack((tile, 0.42), (other, 0.05), (tile, 0.06), (other, 0.05), (tile, 0.42))
            if kind == "band"
            else textures.spots(look.rng, color, pale, 0.12)
        )
    lean = 0.5
    parts = [(ellipsoid(d, d, d, 26, 16), tile),
             (cylinder(0.009, 0.01, 16).move(z=0.49 * d), textures.plain((206, 172, 96))),
             (torus(0.006, 0.0012, 14, 6).turn(0, np.pi / 2).move(z=0.49 * d + 0.014),
              textures.plain((190, 160, 96)))]  # fmt: skip
    pieces = [(s.turn(1, lean).move(z=0.484 * d), t) for s, t in parts]
    return put_down(pieces, pieces[0][0], pieces[1][0])


def star(look: Look) -> Shape:
    """A faceted five-pointed star that lies flat."""
    color = look.color("gold", "yellow", "silver", "red", "white", "wooden")
    r = look.between(0.05, 0.075)
    outline = star_outline(r, 0.45)
    low = prism(outline, 0, 0.008)
    faces = [prism([outline[k - 1] * 0.999, outline[k] * 0.999, (0.0, 0.0)], 0.007, 0.0081)
             for k in range(10)]  # fmt: skip

    def peak(p: np.ndarray) -> np.ndarray:
        rise = 0.014 * (1 - np.minimum(np.hypot(p[:, 0], p[:, 1]) / (0.45 * r), 1))
        return np.column_stack([p[:, :2], p[:, 2] + np.where(p[:, 2] > 0.0075, rise, 0)])

    lit = join([f.bend(peak) for f in faces[::2]])
    shade = join([f.bend(peak) for f in faces[1::2]])
    return put_down(
        [
            (low, look.surface(color, "metal")),
            (lit, textures.plain(tint_color(color, 1.2))),
            (shade, textures.plain(tint_color(color, 0.82))),
        ],
        low,
        join([lit, shade]),
    )


def stocking(look: Look) -> Shape:
    """A Christmas stocking lying flat, its toe to the left, with a white cuff."""
    color = look.color("red", "green", "red", "crimson", "navy")
    knit = textures.knitting(look.rng, color, 22)
    outline = smooth([(0.035, 0.09), (-0.035, 0.09), (-0.034, 0.0), (-0.05, -0.03), (-0.1, -0.045),
                      (-0.112, -0.07), (-0.095, -0.09), (-0.02, -0.09), (0.03, -0.07),
                      (0.036, -0.02), (0.035, 0.088)], 3)[:-1]  # fmt: skip
    body = prism(outline, 0, 0.018)
    inner = prism(outline * 0.93 - [0.002, 0.001], 0.0175, 0.022)
    cuff = pad(0.086, 0.04, 0.026, 0.008, soft=0.5).move(0, 0.095)
    toe = ball(0.05, 0.055, 0.028, (-0.092, -0.068, 0.0115), 14)
    heel = ball(0.04, 0.045, 0.026, (0.018, -0.068, 0.0118), 14)
    loop = rod(
        [(0.03, 0.11, 0.012), (0.036, 0.135, 0.008), (0.02, 0.14, 0.006), (0.024, 0.112, 0.01)],
        0.003,
        6,
    )
    pale = textures.spots(look.rng, (246, 244, 238), (226, 224, 220), 0.3)
    pieces: Pieces = [(join([body, inner]), knit), (join([cuff, toe, heel]), pale),
                      (loop, textures.plain(color))]  # fmt: skip
    leg = body.vertices[body.vertices[:, 1] > -0.05]
    foot = body.vertices[body.vertices[:, 1] < -0.02]
    made = put_down(pieces, body, cuff)
    parts = (hull_part(leg), hull_part(foot), hull_of(cuff))
    return Shape(made.pieces, parts).scale(look.between(0.85, 1.1))


def snow_globe(look: Look) -> Shape:
    """A snow globe: a pale globe of winter air with a small tree and house before it on a foot."""
    d = look.between(0.075, 0.095)
    color = look.color("wooden", "red", "black", "gold", "brown", "navy", "green")
    base = lathe([(0, 0), (0.46 * d, 0), (0.48 * d, 0.008), (0.4 * d, 0.02), (0.38 * d, 0.034),
                  (0, 0.034)], 28)  # fmt: skip
    ground = lathe([(0, 0.03), (0.33 * d, 0.03), (0.3 * d, 0.045), (0, 0.05)], 24)
    top = 0.045
    cones = [cylinder(0.016 - 0.004 * k, 0.022, 12, top=0.001).move(-0.01, 0, top + 0.01 * k)
             for k in range(3)]  # fmt: skip
    house = box(0.018, 0.016, 0.014).move(0.014, -0.004, top)
    roof = side_view([(0.002, top + 0.014), (0.026, top + 0.014), (0.014, top + 0.026)], 0.019)
    roof = roof.move(y=-0.004)
    flakes = [
        ball(
            0.0028,
            0.0028,
            0.0028,
            (
                0.33 * d * np.cos(2.4 * k) * np.sqrt((k + 1) / 26),
                0.33 * d * np.sin(2.4 * k) * np.sqrt((k + 1) / 26),
                top + 0.012 + 0.0016 * ((k * 7) % 26),
            ),
            6,
        )
        for k in range(26)
    ]
    hoops = [torus(0.44 * d, 0.0011, 34, 6).turn(0, np.pi / 2).turn(2, a).move(z=0.034 + 0.4 * d)
             for a in (0.0, np.pi / 2)]  # fmt: skip
    glass = ball(0.9 * d, 0.9 * d, 0.9 * d, (0, 0, 0.034 + 0.4 * d), 20)
    back = [lathe([(0, 0.03), (0.3 * d, 0.032), (0.0, 0.034)], 12)]
    pieces: Pieces = [
        (join([base, *back]), look.surface(color, "wood")),
        (join([ground, *flakes]), textures.plain((246, 248, 252))),
        (join(cones), textures.plain((52, 110, 66))),
        (house, textures.plain((226, 190, 150))),
        (roof, textures.plain((190, 50, 46))),
        (join(hoops), textures.plain((206, 224, 236))),
    ]
    return shape(pieces, [hull_of(base), hull_of(glass)])


def gingerbread_house(look: Look) -> Shape:
    """A gingerbread house with icing, sweets, a door and a chimney."""
    color = look.color("bronze", "brown", "copper", "terracotta")
    k = look.between(0.9, 1.15)
    w, d, h = 0.1, 0.085, 0.06
    crust = textures.speckles(look.rng, color, 12)
    walls = side_view([(-w / 2, 0), (w / 2, 0), (w / 2, h), (0, h + 0.055), (-w / 2, h)], d)
    long = 0.088
    slabs = [box(long, d + 0.024, 0.009).move(x=s * (long / 2 - 0.004)).turn(1, s * 0.832)
             .move(0, 0, h + 0.057) for s in (-1, 1)]  # fmt: skip
    edge = [rod([(s * 0.064, y, h - 0.006), (s * 0.03, y, h + 0.03), (0, y, h + 0.066)], 0.0045, 6)
            for s in (-1, 1) for y in (-d / 2 - 0.012, d / 2 + 0.012)]  # fmt: skip
    ridge = straight((0, -d / 2 - 0.012, h + 0.066), (0, d / 2 + 0.012, h + 0.066), 0.006)
    base = box(w + 0.05, d + 0.05, 0.006)
    door = box(0.024, 0.003, 0.036).move(0, -d / 2, 0.006)
    panes = [box(0.018, 0.003, 0.018).move(s * 0.032, -d / 2, 0.024) for s in (-1, 1)]
    frames = [box(0.023, 0.002, 0.023).move(s * 0.032, -d / 2, 0.0215) for s in (-1, 1)]
    chimney = box(0.018, 0.018, 0.04).move(0.03, 0.015, h + 0.025)
    drops: list[list[Solid]] = [[], [], []]
    for n in range(18):
        s, row, col = (-1) ** n, (n // 2) % 3, (n // 6)
        x = 0.018 + 0.02 * row
        at = (s * x, (col - 1) * 0.032, h + 0.064 - 1.1 * x + 0.003)
        drops[n % 3].append(ball(0.012, 0.012, 0.009, at, 8))
    icing = textures.plain((250, 248, 244))
    tints = [textures.plain(look.own_color(c)) for c in ("red", "green", "yellow")]
    pieces: Pieces = [(join([walls, chimney]), crust), (join(slabs), textures.speckles(look.rng,
                      tint_color(color, 0.75), 10)), (join([*edge, ridge, base, *frames]), icing),
                      (door, textures.plain((110, 60, 40))),
                      (join(panes), textures.plain((250, 214, 110)))]  # fmt: skip
    pieces += [(join(d), t) for d, t in zip(drops, tints, strict=True)]
    return put_down(pieces, base, walls, *slabs, factor=k)


CATEGORIES = (
    Category("christmas_tree", christmas_tree, (0.155, 0.155, 0.275), 0.4, ("xmas tree",
             "mini christmas tree", "fir tree", "tabletop christmas tree", "small christmas tree"),
             ("living",), ("tall",), ("green",)),
    Category("bauble", bauble, (0.075, 0.068, 0.075), 0.03, ("christmas ornament",
             "christmas bauble", "christmas ball", "tree ornament", "christmas tree ornament",
             "glass bauble", "christmas decoration", "hanging ornament", "glass ornament"),
             ("living",), ("round",), ("red", "gold")),
    Category("star", star, (0.12, 0.113, 0.022), 0.06, ("gold star", "christmas star",
             "tree topper", "star ornament", "paper star"), ("living",), ("flat",),
             ("gold",), state="lying flat"),
    Category("stocking", stocking, (0.15, 0.22, 0.026), 0.08, ("christmas stocking",
             "xmas stocking", "holiday stocking"), ("living",), (), ("red",),
             state="lying flat"),
    Category("snow_globe", snow_globe, (0.083, 0.083, 0.105), 0.35, ("snowglobe", "snow dome",
             "christmas snow globe", "glass snow globe"), ("living",), ("round",), ("wooden",
             "red")),
    Category("gingerbread_house", gingerbread_house, (0.155, 0.14, 0.13), 0.5,
             ("ginger bread house", "candy house"), ("living",), (), ("brown",)),
)  # fmt: skip
"""The module's categories."""
