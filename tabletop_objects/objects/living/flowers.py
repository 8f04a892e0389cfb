"""Objects of the ``living`` theme: flowers."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ...kit import prints, surfaces
from ...kit.outlines import ellipse, smooth
from ...kit.parts import above, box_part, hull_part, whole_hull
from ...kit.primitives import ball, blade, rod
from ...kit.shapes import Category, Pieces, Shape, category, keep_still, put_down, shape, vary
from ...kit.solids import Solid, box, cylinder, ellipsoid, join, lathe, prism, refine
from ...kit.surfaces import RGB, Look, tint_color

Rows = Sequence[tuple[int, float, float, float, float]]
"""Rings of petals: how many, their length and width, how steep, how high up."""


GOLD: RGB = (238, 188, 50)
GREEN: RGB = (84, 126, 64)


def layered_head(rows: Rows, heart: float = 0.0, eye: RGB | None = GOLD, fade: float = 0.1) -> Head:
    """Return the drawing function of a flower whose rings of petals darken towards the centre."""

    def head(look: Look, color: RGB) -> Pieces:
        made: Pieces = []
        for n, (count, long, wide, lift, z) in enumerate(rows):
            ring = [p.move(z=z) for p in corolla(count, long, wide, lift, 0.5 * n)]
            made.append((join(ring), surfaces.speckles(look.rng, tint_color(color, 1 - fade * n),
                                                       7)))  # fmt: skip
        if heart:
            top = max(z for *_, z in rows)
            tone = tint_color(color, 0.8) if eye is None else eye
            made.append((ball(2 * heart, 2 * heart, 1.3 * heart, (0, 0, top + 0.3 * heart), 12),
                         surfaces.spots(look.rng, tone, tint_color(tone, 0.6), 0.2)))  # fmt: skip
        return made

    return head


def open_head(count: int, long: float, wide: float, lift: float, heart: float, eye: RGB,
          ring: RGB | None = None, pistil: float = 0.0) -> Head:  # fmt: skip
    """Return the drawing function of a flower with broad petals and an optional ring or pistil."""

    def head(look: Look, color: RGB) -> Pieces:
        made: Pieces = [(join(corolla(count, long, wide, lift)),
                         surfaces.speckles(look.rng, color, 8))]  # fmt: skip
        if ring is not None:
            inner = [p.move(z=0.0012) for p in corolla(count, 0.55 * long, 0.6 * wide, lift)]
            made.append((join(inner), surfaces.plain(ring)))
        centre = [ball(2 * heart, 2 * heart, 1.4 * heart, (0, 0, 0.4 * heart + 0.002), 10)]
        if pistil:
            centre.append(rod([(0, 0, 0), (0, 0, pistil)], 0.0016, 6, 1))
            centre += [ball(0.004, 0.004, 0.004, (0.003 * np.cos(a), 0.003 * np.sin(a), pistil), 6)
                       for a in (0, 2.1, 4.2)]  # fmt: skip
        made.append((join(centre), surfaces.plain(eye)))
        return made

    return head


def cluster(count: int, radius: float, size: float, eye: RGB | None = None) -> Head:
    """Return the drawing function of a flower head: a dome of small, four-petalled florets."""

    def head(look: Look, color: RGB) -> Pieces:
        florets, dots = [], []
        for k in range(count):
            up = 1 - 1.25 * (k + 0.5) / count
            flat = np.sqrt(1 - up * up)
            a = 2.4 * k
            at = radius * np.array([flat * np.cos(a), flat * np.sin(a), 0.85 * up + 0.5])
            one = [ellipsoid(size, 0.5 * size, 0.3 * size, 6, 3).turn(2, t) for t in (0, np.pi / 2)]
            both = join(one).turn(1, float(np.arccos(np.clip(up, -1, 1)))).turn(2, a)
            florets.append(both.move(*at))
            if eye is not None:
                dots.append(ball(0.25 * size, 0.25 * size, 0.25 * size, tuple(1.04 * at), 5))
        tile = surfaces.spots(look.rng, color, tint_color(color, 1.3), 0.3)
        made: Pieces = [(join(florets), tile),
                        (ball(1.7 * radius, 1.7 * radius, 1.4 * radius, (0, 0, 0.5 * radius), 12),
                         surfaces.plain(tint_color(color, 0.7)))]  # fmt: skip
        if dots and eye is not None:
            made.append((join(dots), surfaces.plain(eye)))
        return made

    return head


def bell(r: float, long: float) -> Solid:
    """Return an open bell-shaped flower that faces +z."""
    return lathe([(0, 0), (0.55 * r, 0.12 * long), (0.7 * r, 0.6 * long), (1.15 * r, long),
                  (0.5 * r, 0.7 * long), (0, 0.5 * long)], 8)  # fmt: skip


def spike(count: int, long: float, wide: float, size: float, droop: float, *, one_side: bool = False
          ) -> Head:  # fmt: skip
    """Return the drawing function of a spike of bell-shaped flowers that ``droop`` tilts down."""

    def head(look: Look, color: RGB) -> Pieces:
        bells = []
        for k in range(count):
            t = (k + 0.5) / count
            s = size * (1.15 - 0.65 * t)
            a = 0.5 * np.sin(9.0 * k) if one_side else 2.4 * k
            one = bell(s, 1.7 * s).turn(1, droop).move(0.35 * wide * (1.1 - 0.6 * t), 0, 0)
            bells.append(one.turn(2, a).move(z=long * t))
        stalk = rod([(0, 0, -0.004), (0, 0, 0.98 * long)], [0.0026, 0.0014], 6, 2)
        tip = ball(0.7 * size, 0.7 * size, 1.6 * size, (0, 0, long), 8)
        return [(join(bells), surfaces.gradient(tint_color(color, 0.85), tint_color(color, 1.25),
                                                look.rng)),
                (join([stalk, tip]), surfaces.plain(GREEN))]  # fmt: skip

    return head


def daffodil(look: Look, color: RGB) -> Pieces:
    """Return a daffodil head with six petals and a frilled trumpet."""
    horn = lathe([(0, 0), (0.008, 0.002), (0.009, 0.014), (0.0145, 0.024), (0.012, 0.0235),
                  (0.007, 0.013), (0, 0.006)], 14)  # fmt: skip
    deep = look.pick([(238, 130, 30), (246, 170, 30)])
    return [(join([*corolla(3, 0.03, 0.019, 0.12), *corolla(3, 0.03, 0.019, 0.22, np.pi / 3)]),
             surfaces.speckles(look.rng, color, 6)), (horn, surfaces.plain(deep))]  # fmt: skip


def iris(look: Look, color: RGB) -> Pieces:
    """Return an iris head: three falling petals, three upright petals and yellow tongues."""
    fall, stand, tongue = [], [], []
    for k in range(3):
        a = 2 * np.pi * k / 3
        fall.append(blade([(0.002, 0, 0), (0.02, 0, 0.012), (0.038, 0, 0.004), (0.046, 0, -0.012)],
                          0.028, thick=0.16).turn(2, a))  # fmt: skip
        stand.append(blade([(0.004, 0, 0), (0.013, 0, 0.02), (0.009, 0, 0.044)], 0.026, thick=0.2)
                     .turn(2, a + np.pi / 3))  # fmt: skip
        tongue.append(rod([(0.008, 0, 0.009), (0.02, 0, 0.0155), (0.029, 0, 0.014)], 0.0026, 6, 2)
                      .turn(2, a))  # fmt: skip
    return [(join(fall), surfaces.speckles(look.rng, tint_color(color, 0.9), 8)),
            (join(stand), surfaces.speckles(look.rng, tint_color(color, 1.3), 8)),
            (join(tongue), surfaces.plain(GOLD))]  # fmt: skip


def cup(count: int, long: float, wide: float, lift: float) -> Head:
    """Return the drawing function of a cup-shaped flower with upright petals and gold stamens."""

    def head(look: Look, color: RGB) -> Pieces:
        ring = [p.move(z=0.001) for p in corolla(count, long, wide, lift)]
        outer = corolla(count, long, wide, lift - 0.12, np.pi / count)
        heart = rod([(0, 0, 0), (0, 0, 0.7 * long)], [0.0035, 0.002], 6, 1)
        return [(join([*ring, *outer]), surfaces.gradient(tint_color(color, 0.8), color, look.rng)),
                (heart, surfaces.plain((240, 160, 30)))]  # fmt: skip

    return head


def pansy(look: Look, color: RGB) -> Pieces:
    """Return a pansy head: five overlapping round petals, the lower ones with a dark face."""
    other = look.own_color("yellow", "white", "purple", "orange")
    up = [ellipsoid(0.026, 0.026, 0.003, 12, 4).move(s * 0.01, 0.013, 0) for s in (-1, 1)]
    side = [ellipsoid(0.024, 0.022, 0.003, 12, 4).move(s * 0.013, -0.004, 0.0015) for s in (-1, 1)]
    low = ellipsoid(0.028, 0.024, 0.003, 12, 4).move(0, -0.014, 0.003)
    face = [ellipsoid(0.012, 0.011, 0.002, 10, 4).move(x, y, 0.0042)
            for x, y in ((-0.008, -0.005), (0.008, -0.005), (0, -0.011))]  # fmt: skip
    return [(join(up), surfaces.speckles(look.rng, color, 8)),
            (join([*side, low]), surfaces.speckles(look.rng, other, 8)),
            (join(face), surfaces.plain((52, 22, 62))),
            (ball(0.005, 0.005, 0.004, (0, -0.003, 0.0055), 8), surfaces.plain(GOLD))]  # fmt: skip


def crane(look: Look, color: RGB) -> Pieces:
    """Return a bird-of-paradise flower: a green beak, orange petals and a blue, pointed petal."""
    beak = rod([(0, 0, -0.01), (0.02, 0, 0.012), (0.075, 0, 0.03)], [0.006, 0.0085, 0.001], 8)
    flames = [blade([(0.016, 0, 0.01), (0.03 - 0.014 * n, 0.004 * (-1) ** n, 0.045),
                     (0.045 - 0.028 * n, 0.008 * (-1) ** n, 0.085 - 0.004 * n)], 0.017, thick=0.25)
              for n in range(4)]  # fmt: skip
    arrow = blade([(0.018, 0, 0.012), (0.045, 0, 0.04), (0.066, 0, 0.066)], 0.01, thick=0.5)
    return [(beak, surfaces.gradient((96, 132, 80), (180, 70, 60), look.rng)),
            (join(flames), surfaces.speckles(look.rng, color, 8)),
            (arrow, surfaces.plain((44, 60, 170)))]  # fmt: skip


def protea(look: Look, color: RGB) -> Pieces:
    """Return a protea head: a cone of pale down in a bowl of pointed bracts."""
    bracts: list[Solid] = []
    for n, (count, long, out) in enumerate(((12, 0.05, 0.026), (10, 0.044, 0.02))):
        leaf = blade(
            [(0.008, 0, 0), (out, 0, 0.45 * long), (out * 0.95, 0, long)], 0.014, thick=0.2
        )
        bracts += [leaf.turn(2, 2 * np.pi * k / count + n * 0.25) for k in range(count)]
    down = lathe([(0, 0), (0.015, 0.006), (0.014, 0.026), (0.004, 0.042), (0, 0.043)], 12)
    base = cylinder(0.01, 0.012, 12, top=0.014).move(z=-0.008)
    return [(join(bracts), surfaces.gradient(tint_color(color, 0.75), tint_color(color, 1.3),
                                             look.rng)),
            (down, surfaces.scratches(look.rng, (240, 226, 214), (190, 150, 150), 80)),
            (base, surfaces.plain((120, 140, 90)))]  # fmt: skip


@category("lotus", size=(0.13, 0.131, 0.0446), mass=0.04, material="food", assembled=True,
          aliases=("lotus flower", "water lily", "waterlily", "lotus blossom", "water lily flower"),
          themes=("living",), roles=("round",), colors=("pink",))  # fmt: skip
def lotus(look: Look) -> Shape:
    """An open water lily on its round leaf."""
    k = look.between(0.9, 1.15)
    color = look.color("pink", "white", "pink", "lavender")
    leaf = cylinder(0.062, 0.004, 26)
    head = layered_head([(11, 0.05, 0.019, 0.22, 0), (9, 0.044, 0.018, 0.6, 0.002),
                    (7, 0.036, 0.015, 1.0, 0.004)], 0.009, fade=-0.05)(look, color)  # fmt: skip
    bloom = [(s.move(z=0.008), t) for s, t in head]
    pieces: Pieces = [(leaf, surfaces.leaf(look.rng, (70, 120, 66))), *bloom]
    return put_down(pieces, leaf, join([s for s, _ in bloom]), factor=k)


DARK = (34, 26, 40)
_PEONY = layered_head([(9, 0.03, 0.024, 0.3, 0), (8, 0.027, 0.022, 0.75, 0.002),
                  (7, 0.023, 0.02, 1.1, 0.004), (4, 0.017, 0.014, 1.35, 0.006)], 0.008, None,
                 0.06)  # fmt: skip
_DAHLIA = layered_head([(14, 0.034, 0.012, 0.08, 0), (12, 0.029, 0.011, 0.4, 0.002),
                   (10, 0.023, 0.01, 0.75, 0.004), (7, 0.016, 0.008, 1.1, 0.006)], 0.006, None,
                  0.09)  # fmt: skip
_MUM = layered_head([(18, 0.031, 0.007, 0.05, 0), (17, 0.028, 0.0065, 0.4, 0.002),
                (14, 0.023, 0.006, 0.75, 0.004), (9, 0.016, 0.006, 1.1, 0.005)], 0.006, None,
               0.05)  # fmt: skip
_GERBERA = layered_head([(20, 0.038, 0.0085, 0.08, 0), (15, 0.026, 0.007, 0.25, 0.002)], 0.0105,
                   (70, 44, 30), 0.12)  # fmt: skip
_MARIGOLD = layered_head([(14, 0.023, 0.014, 0.1, 0), (12, 0.02, 0.013, 0.5, 0.002),
                     (10, 0.016, 0.011, 0.9, 0.004), (6, 0.012, 0.009, 1.25, 0.005)], 0.006, None,
                    0.08)  # fmt: skip
_ZINNIA = layered_head([(15, 0.03, 0.012, 0.05, 0), (13, 0.025, 0.011, 0.3, 0.003),
                   (10, 0.019, 0.009, 0.6, 0.005)], 0.0085, GOLD, 0.08)  # fmt: skip
_CAMELLIA = layered_head([(7, 0.027, 0.024, 0.15, 0), (6, 0.023, 0.02, 0.5, 0.002),
                     (6, 0.018, 0.016, 0.85, 0.004), (4, 0.012, 0.011, 1.2, 0.005)], 0.004, GOLD,
                    0.04)  # fmt: skip
_MAGNOLIA = layered_head([(6, 0.048, 0.028, 0.45, 0), (5, 0.042, 0.026, 0.95, 0.001)], 0.007,
                    (150, 160, 70), -0.04)  # fmt: skip
_BLADE = (0.11, 0.011)
Head = Callable[[Look, RGB], Pieces]
"""Makes a blossom at the origin that opens along +z."""


def corolla(count: int, long: float, wide: float, lift: float, start: float = 0.0) -> list[Solid]:
    """Return ``count`` flat petals around the z axis, each raised by the angle ``lift``."""
    petal = ellipsoid(long, wide, 0.0035, 8, 4).move(x=0.5 * long).turn(1, -lift)
    return [petal.turn(2, start + 2 * np.pi * k / count) for k in range(count)]


def _rose(look: Look, color: RGB) -> Pieces:
    tile = surfaces.speckles(look.rng, color, 10)
    deep = surfaces.plain(tint_color(color, 0.75))
    cup = lathe([(0, -0.004), (0.012, 0), (0.017, 0.016), (0.013, 0.026), (0, 0.027)], 14)
    rings = [ellipsoid(0.026, 0.02, 0.004, 10, 5).turn(1, -1.25 + 0.25 * n)
             .move(0.012 + 0.003 * n, 0, 0.013).turn(2, 2.2 * k + n)
             for n in range(2) for k in range(3)]  # fmt: skip
    heart = [ball(0.013 - 0.004 * k, 0.011 - 0.003 * k, 0.008, (0.002 * k, 0, 0.026 + 0.001 * k), 8)
             for k in range(2)]  # fmt: skip
    sepals = [*corolla(5, 0.022, 0.008, -0.4)]
    return [(join([cup, *rings]), tile), (join(heart), deep),
            (join(sepals), surfaces.plain((74, 118, 60)))]  # fmt: skip


def _tulip(look: Look, color: RGB) -> Pieces:
    tile = surfaces.gradient(tint_color(color, 0.8), tint_color(color, 1.25), look.rng)
    cup = lathe([(0, -0.003), (0.011, 0.002), (0.016, 0.016), (0.011, 0.034), (0, 0.03)], 14)
    tips = [ellipsoid(0.02, 0.007, 0.046, 10, 6).turn(0, 0.12).move(0, 0.0105, 0.021)
            .turn(2, 2 * np.pi * k / 6) for k in range(6)]  # fmt: skip
    return [(join([cup, *tips]), tile)]


def _sunflower(look: Look, color: RGB) -> Pieces:
    petals = [*corolla(16, 0.046, 0.014, 0.1), *corolla(16, 0.042, 0.013, 0.35, 0.2)]
    seeds = surfaces.spots(look.rng, (74, 46, 26), (130, 90, 40), 0.2)
    back = cylinder(0.02, 0.005, 14).move(z=-0.006)
    return [(join(petals), surfaces.speckles(look.rng, color, 8)),
            (ball(0.044, 0.044, 0.016, (0, 0, 0.003), 14), seeds),
            (back, surfaces.plain((84, 128, 62)))]  # fmt: skip


def _lily(look: Look, color: RGB) -> Pieces:
    petals: list[Solid] = []
    for k in range(6):
        petal = blade([(0.002, 0, 0), (0.018, 0, 0.026), (0.042, 0, 0.036), (0.056, 0, 0.03)],
                      0.022, thick=0.18)  # fmt: skip
        petals.append(petal.turn(2, 2 * np.pi * k / 6))
    stamens = [rod([(0, 0, 0), (0.005, 0, 0.025), (0.013, 0, 0.044)], 0.0009, 5, 2)
               .turn(2, 1.05 * k + 0.5) for k in range(6)]  # fmt: skip
    return [(join(petals), surfaces.spots(look.rng, color, tint_color(color, 0.7), 0.05)),
            (join(stamens), surfaces.plain((196, 110, 40)))]  # fmt: skip


def _carnation(look: Look, color: RGB) -> Pieces:
    petals: list[Solid] = []
    for n, (lift, count) in enumerate(((0.15, 9), (0.55, 8), (1.0, 6))):
        petals += [p.move(z=0.004 * n) for p in corolla(count, 0.024 - 0.003 * n, 0.016, lift, n)]
    cup = cylinder(0.004, 0.022, 10, top=0.007).move(z=-0.021)
    return [(join(petals), surfaces.scratches(look.rng, color, tint_color(color, 0.75), 50)),
            (cup, surfaces.plain((110, 146, 100)))]  # fmt: skip


def _lavender(look: Look, color: RGB) -> Pieces:
    buds = [ball(0.009, 0.009, 0.008, (0.0055 * np.cos(2.1 * k), 0.0055 * np.sin(2.1 * k),
                 0.0038 * k - 0.01), 8) for k in range(22)]  # fmt: skip
    return [(join(buds), surfaces.spots(look.rng, color, tint_color(color, 1.35), 0.2))]


def _orchid(look: Look, color: RGB) -> Pieces:
    made: list[Solid] = []
    lips: list[Solid] = []
    for k in range(4):
        at = (0.006 * (k % 2) - 0.003, 0, -0.032 * k)
        bloom = [*corolla(3, 0.022, 0.015, 0.2, 0.5), *corolla(2, 0.027, 0.024, 0.2, np.pi / 2)]
        turned = [p.turn(1, 1.1).turn(2, np.pi * k + 0.5).move(*at) for p in bloom]
        made += turned
        lips.append(ball(0.011, 0.011, 0.009, (at[0] + (0.006 if k % 2 == 0 else -0.006), 0, at[2]),
                         8))  # fmt: skip
    return [(join(made), surfaces.speckles(look.rng, color, 8)),
            (join(lips), surfaces.plain((190, 40, 110)))]  # fmt: skip


def on_stem(
    head: Head, colors: tuple[str, ...], long: float, *, leaves: int = 2, nod: float = 0.5,
    leaf: tuple[float, float] = (0.06, 0.018), stem: RGB = (84, 126, 64),
) -> Callable[[Look], Shape]:  # fmt: skip
    """Return the shape function of a cut flower that lies with its blossom on the right.

    With the attribute "stands", the flower fits a vase: it is long and straight, with leaves only
    near its top.
    """

    def make(look: Look) -> Shape:
        if "stands" in look.attributes:
            return _straight(look, head, colors, long, min(nod, 0.4), leaf, stem)
        color = look.color(*colors)
        length = 0.88 * long * look.between(0.9, 1.1)
        blossom = [(s.scale(1.15, 1.15, 1.15), t) for s, t in head(look, color)]
        low = min(float(s.turn(1, -np.pi / 2 + nod).bounds[0, 2]) for s, _ in blossom)
        up = max(0.003, -low)
        bloom = [(s.turn(1, -np.pi / 2 + nod).move(0, 0, up), t) for s, t in blossom]
        path = [(0.006, 0, up - 0.003), (0.06, 0, max(0.5 * up, 0.0025)), (0.14, 0.002, 0.0026),
                (length, 0, 0.0026)]  # fmt: skip
        stalk = rod(path, 0.0024, 7)
        green = surfaces.plain(stem)
        pieces: Pieces = [*bloom, (stalk, green)]
        blades = [blade([(0, 0, 0.003), (0.5 * leaf[0], 0.004, 0.01), (leaf[0], 0.012, 0.004)],
                        leaf[1], thick=0.15).turn(2, (-1) ** k * 0.25 + np.pi)
                  .move(0.4 * length + 0.25 * length * k / max(leaves, 1), 0, 0)
                  for k in range(leaves)]  # fmt: skip
        if blades:
            pieces.append((join(blades), surfaces.plain(tint_color(stem, 0.85))))
        middle = float(np.mean([s.bounds.mean(0)[0] for s, _ in bloom]))
        pieces = [(s.move(-0.5 * length - middle).turn(2, np.pi), t) for s, t in pieces]
        crown = np.concatenate([s.vertices for s, _ in pieces[: len(bloom)]])
        x = stalk.vertices[:, 0]
        rest = stalk.move(-0.5 * length - middle).turn(2, np.pi).vertices
        crown = above(crown)
        crown[crown[:, 2] < 0.5 * crown[:, 2].max(), 2] = 0.0
        tail = above(rest[x > 0.08])
        tail[tail[:, 2] < 0.003, 2] = 0.0
        parts = [crown, above(rest[x < 0.1]), tail]
        return shape(pieces, [hull_part(p) for p in parts])

    return make


def _straight(
    look: Look, head: Head, colors: tuple[str, ...], long: float, nod: float,
    leaf: tuple[float, float], stem: RGB,
) -> Shape:  # fmt: skip
    """Return a cut flower with a straight, bare stem along x and its blossom on the right."""
    color, length = look.color(*colors), 1.25 * long * look.between(0.92, 1.08)
    bloom = [(s.scale(1.1, 1.1, 1.1).turn(1, np.pi / 2 - nod), t) for s, t in head(look, color)]
    back = min(float(s.bounds[0, 0]) for s, _ in bloom)
    bloom = [(s.move(0.5 * length - max(back, -0.012)), t) for s, t in bloom]
    stalk = rod([(-0.5 * length, 0, 0), (0, 0, 0), (0.5 * length, 0, 0)], 0.0022, 5)
    wide, deep = min(leaf[0], 0.045), min(leaf[1], 0.018)
    blades = [blade([(0, 0, 0), (0.5 * wide, 0, 0.006), (wide, 0, 0.003)], deep, thick=0.15)
              .turn(1, -0.4).turn(0, 2.4 * k).move((0.32 - 0.06 * k) * length)
              for k in range(2)]  # fmt: skip
    pieces: Pieces = [*bloom, (stalk, surfaces.plain(stem)),
                      (join(blades), surfaces.plain(tint_color(stem, 0.85)))]  # fmt: skip
    low = min(float(s.bounds[0, 2]) for s, _ in pieces)
    pieces = [(s.move(z=-low), t) for s, t in pieces]
    crown = np.concatenate([s.vertices for s, _ in pieces[: len(bloom)]])
    solids = [pieces[len(bloom)][0], *(s.move(z=-low) for s in blades)]
    return shape(pieces, [whole_hull(crown), *(whole_hull(s.vertices) for s in solids)])


def _daisy(look: Look, color: RGB) -> Pieces:
    petals = corolla(14, 0.024, 0.0095, 0.15)
    return [
        (join(petals), surfaces.speckles(look.rng, color, 5)),
        (ball(0.017, 0.017, 0.01, (0, 0, 0.003), 12), surfaces.plain((240, 190, 50))),
    ]


def _wheat(look: Look, color: RGB) -> Pieces:
    grains = [ball(0.006, 0.0055, 0.013, (0.0042 * np.cos(2.4 * k), 0.0042 * np.sin(2.4 * k),
                   0.0035 * k - 0.01), 8) for k in range(18)]  # fmt: skip
    awns = [rod([(0, 0, 0.004 * k), (0.012 * np.cos(2.4 * k), 0.012 * np.sin(2.4 * k),
                 0.04 + 0.005 * k)], 0.0005, 4, 1) for k in range(8)]  # fmt: skip
    return [(join([*grains, *awns]), surfaces.speckles(look.rng, color, 14))]


@category("petal", size=(0.0459, 0.0386, 0.00899), mass=0.001, material="food", assembled=True,
          aliases=("rose petal", "flower petal", "petal of a rose"), themes=("living",),
          colors=("red", "pink"), state="lying flat")  # fmt: skip
@keep_still
def petal(look: Look) -> Shape:
    """One fallen, slightly cupped petal."""
    k = look.between(0.85, 1.2)
    color = look.color("red", "pink", "white", "crimson", "yellow")
    ring = [(-0.022, 0), (-0.012, -0.012), (0.006, -0.018), (0.02, -0.011), (0.0195, 0),
            (0.02, 0.011), (0.006, 0.018), (-0.012, 0.012), (-0.022, 0)]  # fmt: skip
    flat = refine(refine(prism(smooth(ring, 3)[:-1], 0, 0.0011)))
    one = flat.bend(
        lambda p: p + np.column_stack([0 * p[:, :2], 14 * (p[:, 0] ** 2 + p[:, 1] ** 2)])
    )
    return put_down([(one, surfaces.speckles(look.rng, color, 9))], factor=k)


@category("blossom_branch", size=(0.269, 0.114, 0.0182), mass=0.02, material="food", assembled=True,
          aliases=("cherry blossom branch", "cherry blossom", "branch of cherry blossom", "blossom",
          "apple blossom", "blossom twig", "cherry blossom twig"), themes=("living",),
          colors=("pink",), state="lying flat")  # fmt: skip
def blossom_branch(look: Look) -> Shape:
    """A twig with pink blossoms."""
    k = look.between(0.9, 1.1)
    color = look.color("pink", "pink", "white", "coral")
    sticks = [rod([(-0.13, 0, 0.003), (-0.03, 0.012, 0.008), (0.06, -0.004, 0.006),
                   (0.14, 0.01, 0.003)], [0.0034, 0.003, 0.002, 0.0012], 7),
              rod([(-0.03, 0.012, 0.007), (0.02, 0.045, 0.006), (0.06, 0.055, 0.004)],
                  [0.002, 0.001], 6),
              rod([(0.02, 0.0, 0.007), (0.06, -0.035, 0.005)], [0.0018, 0.001], 6, 2)]  # fmt: skip
    blooms: list[Solid] = []
    hearts = []
    spots = [(-0.06, 0.014), (-0.02, 0.004), (0.01, 0.042), (0.045, 0.056), (0.03, -0.008),
             (0.06, -0.036), (0.085, 0.006), (0.12, 0.004), (0.065, 0.044),
             (0.1, 0.014)]  # fmt: skip
    for n, (x, y) in enumerate(spots):
        ring = corolla(5, 0.013, 0.012, 0.3, n)
        blooms += [p.turn(0, 0.3 * (-1) ** n).move(x, y, 0.011) for p in ring]
        hearts.append(ball(0.005, 0.005, 0.004, (x, y, 0.0135), 6))
    return put_down([(join(sticks), surfaces.speckles(look.rng, (96, 70, 54), 10)),
                     (join(blooms), surfaces.speckles(look.rng, color, 6)),
                     (join(hearts), surfaces.plain((214, 80, 100)))], factor=k)  # fmt: skip


@category("pressed_flower", size=(0.0869, 0.124, 0.0016), mass=0.006, material="paper",
          assembled=True, aliases=("flower pressing", "herbarium sheet"), themes=("living",),
          roles=("flat",), colors=("purple",), state="lying flat")  # fmt: skip
def pressed_flower(look: Look) -> Shape:
    """A card with a pressed flower, lying flat."""
    k = look.between(0.9, 1.1)
    color = look.color("purple", "pink", "yellow", "blue", "red")
    image = prints.canvas(112, 160, (246, 240, 224))
    prints.stroke(image, [(0.5, 0.9), (0.47, 0.65), (0.5, 0.36)], 0.02, (96, 120, 70))
    for s in (-1, 1):
        prints.polygon(image, [(0.48, 0.68), (0.48 + s * 0.2, 0.56), (0.48 + s * 0.24, 0.62),
                               (0.48 + s * 0.12, 0.7)], (112, 134, 80))  # fmt: skip
    for a in np.linspace(0, 2 * np.pi, 8)[:-1]:
        ring = ellipse(0.16, 0.26, 12) @ np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])
        away = 0.16 * np.array([np.sin(a), np.cos(a)])
        points = [(0.5 + 1.2 * (x + away[0]), 0.33 + 0.8 * (y + away[1])) for x, y in ring * 0.7]
        prints.polygon(image, points, tint_color(color, look.between(0.8, 1.1)))
    prints.disc(image, 0.5, 0.33, 0.04, (222, 176, 60))
    x, y = 0.09 * k, 0.128 * k
    face = box(0.99 * x, 0.99 * y, 0.0004).move(z=0.0012)
    card = box(x, y, 0.0014)
    return shape([(card, surfaces.plain((240, 232, 212))), (face, image)],
                 [box_part(x, y, 0.0014)])  # fmt: skip


CATEGORIES = (
    Category("daffodil", on_stem(daffodil, ("yellow", "yellow", "white", "cream"), 0.2, leaves=2,
             nod=0.9, leaf=_BLADE), size=(0.212, 0.0687, 0.0468), mass=0.015, material="food",
             assembled=True, aliases=("narcissus", "jonquil", "daffodil stem"), themes=("living",),
             colors=("yellow", "yellow"), state="lying flat"),
    Category("iris", on_stem(iris, ("purple", "indigo", "blue", "violet", "white"), 0.22, leaves=2,
             nod=0.3, leaf=_BLADE), size=(0.242, 0.0925, 0.0773), mass=0.02, material="food",
             assembled=True, aliases=("iris flower", "purple iris", "iris stem", "irises"),
             themes=("living",), colors=("purple", "indigo"), state="lying flat"),
    Category("peony", on_stem(_PEONY, ("pink", "pink", "white", "magenta", "coral"), 0.21, leaves=2,
             nod=0.75, leaf=(0.07, 0.026)), size=(0.216, 0.0649, 0.0478), mass=0.03,
             material="food", assembled=True,
             aliases=("peonies", "peony flower", "ranunculus", "pink peony"), themes=("living",),
             colors=("pink", "pink"), state="lying flat"),
    Category("chrysanthemum", on_stem(_MUM, ("yellow", "white", "pink", "amber", "maroon"), 0.21,
             leaves=2, nod=0.85, leaf=(0.06, 0.018)), size=(0.218, 0.0701, 0.0527), mass=0.02,
             material="food", assembled=True, aliases=("chrysanth", "pom pom flower", "mum flower"),
             themes=("living",), colors=("yellow", "white"), state="lying flat"),
    Category("dahlia", on_stem(_DAHLIA, ("crimson", "pink", "orange", "purple", "yellow"), 0.21,
             leaves=2, nod=0.85, leaf=(0.06, 0.026)), size=(0.215, 0.076, 0.0551), mass=0.025,
             material="food", assembled=True, aliases=("dahlia flower",), themes=("living",),
             colors=("crimson", "pink"), state="lying flat"),
    Category("gerbera", on_stem(_GERBERA, ("orange", "pink", "red", "yellow", "coral"), 0.22,
             leaves=0, nod=1.05, leaf=(0.06, 0.018)), size=(0.237, 0.0871, 0.0433), mass=0.018,
             material="food", assembled=True,
             aliases=("gerbera daisy", "gerber daisy", "gerbera flower"), themes=("living",),
             colors=("orange", "pink"), state="lying flat"),
    Category("marigold", on_stem(_MARIGOLD, ("orange", "orange", "gold", "yellow"), 0.15, leaves=2,
             nod=0.9, leaf=(0.05, 0.016)), size=(0.169, 0.0513, 0.0373), mass=0.012,
             material="food", assembled=True, aliases=("calendula", "marigold flower"),
             themes=("living",), colors=("orange", "orange"), state="lying flat"),
    Category("zinnia", on_stem(_ZINNIA, ("pink", "orange", "red", "magenta"), 0.19, leaves=2,
             nod=0.9, leaf=(0.06, 0.018)), size=(0.2, 0.0685, 0.046), mass=0.014, material="food",
             assembled=True, aliases=("zinnia flower",), themes=("living",),
             colors=("pink", "orange"), state="lying flat"),
    Category("camellia", on_stem(_CAMELLIA, ("pink", "red", "white", "crimson"), 0.14, leaves=3,
             nod=0.9, leaf=(0.06, 0.03)), size=(0.169, 0.0599, 0.0386), mass=0.015, material="food",
             assembled=True, aliases=("camellia flower",), themes=("living",),
             colors=("pink", "red"), state="lying flat"),
    Category("gardenia", vary()(on_stem(_CAMELLIA, ("white", "ivory"), 0.13, leaves=3, nod=0.9,
             leaf=(0.06, 0.03))), size=(0.167, 0.0599, 0.0386), mass=0.014, material="food",
             assembled=True, aliases=("gardenia flower", "jasmine"), themes=("living",),
             colors=("white", "ivory"), state="lying flat"),
    Category("magnolia", on_stem(_MAGNOLIA, ("white", "pink", "cream"), 0.19, leaves=2, nod=0.5,
             leaf=(0.07, 0.03)), size=(0.225, 0.0861, 0.0872), mass=0.02, material="food",
             assembled=True, aliases=("magnolia flower", "magnolia blossom"), themes=("living",),
             colors=("white", "pink"), state="lying flat"),
    Category("anemone", on_stem(open_head(8, 0.027, 0.02, 0.2, 0.008, DARK, (240, 236, 240)),
             ("purple", "red", "blue", "magenta"), 0.18, leaves=2, nod=1.1, leaf=(0.06, 0.018)),
             size=(0.2, 0.0609, 0.0278), mass=0.01, material="food", assembled=True,
             aliases=("anemone flower", "windflower", "cosmos"), themes=("living",),
             colors=("purple", "red"), state="lying flat"),
    Category("hibiscus", vary()(on_stem(open_head(5, 0.046, 0.038, 0.3, 0.006, (250, 210, 70),
             (150, 20, 50), 0.05), ("red", "pink", "orange", "coral"), 0.16, leaves=2, nod=1.0,
             leaf=(0.07, 0.036))), size=(0.191, 0.0961, 0.065), mass=0.015, material="food",
             assembled=True, aliases=("hibiscus flower", "mallow"), themes=("living",),
             colors=("red", "pink"), state="lying flat"),
    Category("petunia", vary()(on_stem(open_head(5, 0.03, 0.028, 0.25, 0.005, (250, 240, 180),
             (246, 240, 246)), ("purple", "magenta", "pink", "red"), 0.13, leaves=2, nod=1.1,
             leaf=(0.045, 0.024))), size=(0.172, 0.0636, 0.0298), mass=0.008, material="food",
             assembled=True, aliases=("petunia flower", "morning glory", "begonia"),
             themes=("living",), colors=("purple", "magenta"), state="lying flat"),
    Category("pansy", on_stem(pansy, ("purple", "purple", "maroon", "blue"), 0.12, leaves=2,
             nod=1.2, leaf=(0.04, 0.018)), size=(0.168, 0.0598, 0.0216), mass=0.006,
             material="food", assembled=True,
             aliases=("pansies", "violet flower", "pansy flower", "sweet violet"),
             themes=("living",), colors=("purple", "purple"), state="lying flat"),
    Category("hydrangea", on_stem(cluster(60, 0.036, 0.022), ("blue", "pink", "lavender", "white"),
             0.2, leaves=2, nod=0.3, leaf=(0.08, 0.045)), size=(0.23, 0.0893, 0.0887), mass=0.04,
             material="food", assembled=True,
             aliases=("hydrangea head", "hydrangea flower", "hydrangea stem", "lilac"),
             themes=("living",), colors=("blue", "pink"), state="lying flat"),
    Category("geranium", on_stem(cluster(30, 0.024, 0.02), ("red", "pink", "coral", "white"), 0.17,
             leaves=2, nod=0.35, leaf=(0.05, 0.045)), size=(0.195, 0.0611, 0.0604), mass=0.015,
             material="food", assembled=True, aliases=("geranium flower", "pelargonium", "verbena"),
             themes=("living",), colors=("red", "pink"), state="lying flat"),
    Category("hyacinth", vary()(on_stem(spike(26, 0.075, 0.032, 0.011, 1.2), ("blue", "pink",
             "purple", "white"), 0.13, leaves=2, nod=0.06, leaf=(0.12, 0.016))),
             size=(0.239, 0.0787, 0.0804), mass=0.03, material="food", assembled=True,
             aliases=("hyacinth flower", "grape hyacinth", "muscari"), themes=("living",),
             colors=("blue", "pink"), state="lying flat"),
    Category("gladiolus", on_stem(spike(12, 0.15, 0.03, 0.018, 0.9, one_side=True), ("red", "pink",
             "coral", "white", "purple"), 0.2, leaves=2, nod=0.05, leaf=(0.14, 0.016)),
             size=(0.359, 0.0842, 0.0642), mass=0.04, material="food", assembled=True,
             aliases=("gladioli", "gladiola", "sword lily", "gladioluses"), themes=("living",),
             colors=("red", "pink"), state="lying flat"),
    Category("hollyhock", vary()(on_stem(spike(12, 0.13, 0.028, 0.0175, 1.3), ("pink", "maroon",
             "white", "yellow"), 0.18, leaves=2, nod=0.06, leaf=(0.06, 0.045))),
             size=(0.33, 0.1, 0.105), mass=0.03, material="food", assembled=True,
             aliases=("delphinium", "larkspur", "lupin", "lupine"), themes=("living",),
             colors=("pink", "maroon"), state="lying flat"),
    Category("freesia", vary()(on_stem(spike(7, 0.06, 0.016, 0.013, 0.5, one_side=True),
             ("yellow", "white", "pink", "lavender"), 0.16, leaves=2, nod=0.25, leaf=_BLADE)),
             size=(0.227, 0.0599, 0.0449), mass=0.01, material="food", assembled=True,
             aliases=("freesia flower", "alstroemeria"), themes=("living",),
             colors=("yellow", "white"), state="lying flat"),
    Category("crocus", vary()(on_stem(cup(3, 0.04, 0.018, 1.3), ("purple", "lavender", "yellow",
             "white"), 0.09, leaves=2, nod=0.1, leaf=(0.07, 0.005))), size=(0.186, 0.0456, 0.0306),
             mass=0.006, material="food", assembled=True,
             aliases=("crocuses", "crocus flower", "saffron crocus"), themes=("living",),
             colors=("purple", "lavender"), state="lying flat"),
    Category("bird_of_paradise", vary()(on_stem(crane, ("orange", "orange", "amber"), 0.22,
             leaves=1, nod=0.1, leaf=(0.1, 0.04))), size=(0.29, 0.0482, 0.126), mass=0.03,
             material="food", assembled=True,
             aliases=("strelitzia", "bird of paradise flower", "heliconia"), themes=("living",),
             colors=("orange", "orange"), state="lying flat"),
    Category("protea", vary()(on_stem(protea, ("pink", "coral", "crimson"), 0.18, leaves=3,
             nod=0.2, leaf=(0.07, 0.018))), size=(0.225, 0.064, 0.0646), mass=0.05, material="food",
             assembled=True, aliases=("protea flower", "king protea", "banksia"),
             themes=("living",), colors=("pink", "coral"), state="lying flat"),
    Category("rose", on_stem(_rose, ("red", "pink", "white", "yellow", "crimson"), 0.23),
             size=(0.227, 0.0504, 0.0509), mass=0.02, material="food", assembled=True,
             aliases=("red rose", "cut rose", "single rose", "rose stem"), themes=("living",),
             colors=("red", "pink"), state="lying flat"),
    Category("tulip", on_stem(_tulip, ("red", "yellow", "pink", "purple", "orange", "white"), 0.22,
             leaf=(0.12, 0.02)), size=(0.222, 0.062, 0.0459), mass=0.02, material="food",
             assembled=True, aliases=("tulip flower", "tulip stem"), themes=("living",),
             colors=("red", "yellow"), state="lying flat"),
    Category("sunflower",
             on_stem(_sunflower, ("yellow", "gold", "amber"), 0.27, nod=0.9, leaf=(0.08, 0.04)),
             size=(0.268, 0.105, 0.0692), mass=0.06, material="food", assembled=True,
             aliases=("sun flower",), themes=("living",), colors=("yellow",), state="lying flat"),
    Category("lily", on_stem(_lily, ("white", "pink", "orange", "yellow"), 0.24, nod=0.4),
             size=(0.253, 0.112, 0.119), mass=0.02, material="food", assembled=True,
             aliases=("lily flower", "lilies", "amaryllis"), themes=("living",),
             colors=("white", "pink"), state="lying flat"),
    Category("carnation", on_stem(_carnation, ("pink", "red", "white", "crimson"), 0.22, nod=0.3,
             leaf=(0.07, 0.006), stem=(110, 146, 110)), size=(0.205, 0.0559, 0.0506), mass=0.012,
             material="food", assembled=True, aliases=("carnation flower",), themes=("living",),
             colors=("pink", "red"), state="lying flat"),
    Category("lavender", on_stem(_lavender, ("purple", "violet", "lavender", "indigo"), 0.19,
             nod=0.04, leaf=(0.04, 0.004), stem=(120, 140, 110)), size=(0.243, 0.032, 0.0229),
             mass=0.004, material="food", assembled=True, aliases=("lavender sprig",
             "sprig of lavender", "lavender stem", "lavender flower", "lavender bunch"),
             themes=("living",), colors=("purple",), state="lying flat"),
    Category("orchid",
             on_stem(_orchid, ("pink", "white", "purple", "magenta"), 0.22, leaves=0, nod=0.25),
             size=(0.205, 0.0587, 0.0615), mass=0.02, material="food", assembled=True,
             aliases=("orchid stem", "orchid flower"), themes=("living",), colors=("pink", "white"),
             state="lying flat"),
    Category("daisy", on_stem(_daisy, ("white", "white", "pink", "yellow"), 0.18, nod=0.8,
             leaf=(0.04, 0.012)), size=(0.169, 0.0532, 0.038), mass=0.006, material="food",
             assembled=True, aliases=("daisy flower", "marguerite", "chamomile", "daisies", "aster",
             "artificial flower", "fake flower", "plastic flower", "single flower", "cut flower",
             "wildflower"), themes=("living",), colors=("white",), state="lying flat"),
    Category("dried_flower", on_stem(_wheat, ("tan", "gold", "beige", "amber", "coral"), 0.2,
             leaves=1, nod=0.04, leaf=(0.06, 0.006), stem=(190, 160, 100)),
             size=(0.246, 0.0405, 0.0276), mass=0.004, material="food", assembled=True,
             aliases=("ear of wheat", "wheat", "dried grass", "wheat stalk", "wheat ear",
             "dried flower bundle", "raffia bundle"), themes=("living",), colors=("tan",),
             state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
