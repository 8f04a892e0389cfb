"""Single cut flowers, twigs and feathers: long thin things that stand in a vase."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from ...build.category import Category
from ...build.collision import hull_part, whole_hull
from ...build.forms import above, blade
from ...build.recipes import Pieces, ball, rod
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, ellipsoid, join, lathe
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

Head = Callable[[Look, RGB], Pieces]
"""Makes a blossom at the origin that opens along +z."""


def corolla(count: int, long: float, wide: float, lift: float, start: float = 0.0) -> list[Solid]:
    """Return flat petals around z, raised by the angle ``lift``."""
    petal = ellipsoid(long, wide, 0.0035, 8, 4).move(x=0.5 * long).turn(1, -lift)
    return [petal.turn(2, start + 2 * np.pi * k / count) for k in range(count)]


def _rose(look: Look, color: RGB) -> Pieces:
    tile = textures.speckles(look.rng, color, 10)
    deep = textures.plain(tint_color(color, 0.75))
    cup = lathe([(0, -0.004), (0.012, 0), (0.017, 0.016), (0.013, 0.026), (0, 0.027)], 14)
    rings = [ellipsoid(0.026, 0.02, 0.004, 10, 5).turn(1, -1.25 + 0.25 * n)
             .move(0.012 + 0.003 * n, 0, 0.013).turn(2, 2.2 * k + n)
             for n in range(2) for k in range(3)]  # fmt: skip
    heart = [ball(0.013 - 0.004 * k, 0.011 - 0.003 * k, 0.008, (0.002 * k, 0, 0.026 + 0.001 * k), 8)
             for k in range(2)]  # fmt: skip
    sepals = [*corolla(5, 0.022, 0.008, -0.4)]
    return [(join([cup, *rings]), tile), (join(heart), deep),
            (join(sepals), textures.plain((74, 118, 60)))]  # fmt: skip


def _tulip(look: Look, color: RGB) -> Pieces:
    tile = textures.gradient(tint_color(color, 0.8), tint_color(color, 1.25), look.rng)
    cup = lathe([(0, -0.003), (0.011, 0.002), (0.016, 0.016), (0.011, 0.034), (0, 0.03)], 14)
    tips = [ellipsoid(0.02, 0.007, 0.046, 10, 6).turn(0, 0.12).move(0, 0.0105, 0.021)
            .turn(2, 2 * np.pi * k / 6) for k in range(6)]  # fmt: skip
    return [(join([cup, *tips]), tile)]


def _daisy(look: Look, color: RGB) -> Pieces:
    petals = corolla(14, 0.024, 0.0095, 0.15)
    return [
        (join(petals), textures.speckles(look.rng, color, 5)),
        (ball(0.017, 0.017, 0.01, (0, 0, 0.003), 12), textures.plain((240, 190, 50))),
    ]


def _sunflower(look: Look, color: RGB) -> Pieces:
    petals = [*corolla(16, 0.046, 0.014, 0.1), *corolla(16, 0.042, 0.013, 0.35, 0.2)]
    seeds = textures.spots(look.rng, (74, 46, 26), (130, 90, 40), 0.2)
    back = cylinder(0.02, 0.005, 14).move(z=-0.006)
    return [(join(petals), textures.speckles(look.rng, color, 8)),
            (ball(0.044, 0.044, 0.016, (0, 0, 0.003), 14), seeds),
            (back, textures.plain((84, 128, 62)))]  # fmt: skip


def _lily(look: Look, color: RGB) -> Pieces:
    petals: list[Solid] = []
    for k in range(6):
        petal = blade([(0.002, 0, 0), (0.018, 0, 0.026), (0.042, 0, 0.036), (0.056, 0, 0.03)],
                      0.022, thick=0.18)  # fmt: skip
        petals.append(petal.turn(2, 2 * np.pi * k / 6))
    stamens = [rod([(0, 0, 0), (0.005, 0, 0.025), (0.013, 0, 0.044)], 0.0009, 5, 2)
               .turn(2, 1.05 * k + 0.5) for k in range(6)]  # fmt: skip
    return [(join(petals), textures.spots(look.rng, color, tint_color(color, 0.7), 0.05)),
            (join(stamens), textures.plain((196, 110, 40)))]  # fmt: skip


def _carnation(look: Look, color: RGB) -> Pieces:
    petals: list[Solid] = []
    for n, (lift, count) in enumerate(((0.15, 9), (0.55, 8), (1.0, 6))):
        petals += [p.move(z=0.004 * n) for p in corolla(count, 0.024 - 0.003 * n, 0.016, lift, n)]
    cup = cylinder(0.004, 0.022, 10, top=0.007).move(z=-0.021)
    return [(join(petals), textures.scratches(look.rng, color, tint_color(color, 0.75), 50)),
            (cup, textures.plain((110, 146, 100)))]  # fmt: skip


def _lavender(look: Look, color: RGB) -> Pieces:
    buds = [ball(0.009, 0.009, 0.008, (0.0055 * np.cos(2.1 * k), 0.0055 * np.sin(2.1 * k),
                 0.0038 * k - 0.01), 8) for k in range(22)]  # fmt: skip
    return [(join(buds), textures.spots(look.rng, color, tint_color(color, 1.35), 0.2))]


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
    return [(join(made), textures.speckles(look.rng, color, 8)),
            (join(lips), textures.plain((190, 40, 110)))]  # fmt: skip


def _wheat(look: Look, color: RGB) -> Pieces:
    grains = [ball(0.006, 0.0055, 0.013, (0.0042 * np.cos(2.4 * k), 0.0042 * np.sin(2.4 * k),
                   0.0035 * k - 0.01), 8) for k in range(18)]  # fmt: skip
    awns = [rod([(0, 0, 0.004 * k), (0.012 * np.cos(2.4 * k), 0.012 * np.sin(2.4 * k),
                 0.04 + 0.005 * k)], 0.0005, 4, 1) for k in range(8)]  # fmt: skip
    return [(join([*grains, *awns]), textures.speckles(look.rng, color, 14))]


def on_stem(
    head: Head, colors: tuple[str, ...], long: float, *, leaves: int = 2, nod: float = 0.5,
    leaf: tuple[float, float] = (0.06, 0.018), stem: RGB = (84, 126, 64),
) -> Callable[[Look], Shape]:  # fmt: skip
    """Return the shape of a cut flower that lies on the table, its blossom to the right.

    With the attribute "stands" it is one for a vase: long and straight, with leaves only high up.
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
        green = textures.plain(stem)
        pieces: Pieces = [*bloom, (stalk, green)]
        blades = [blade([(0, 0, 0.003), (0.5 * leaf[0], 0.004, 0.01), (leaf[0], 0.012, 0.004)],
                        leaf[1], thick=0.15).turn(2, (-1) ** k * 0.25 + np.pi)
                  .move(0.4 * length + 0.25 * length * k / max(leaves, 1), 0, 0)
                  for k in range(leaves)]  # fmt: skip
        if blades:
            pieces.append((join(blades), textures.plain(tint_color(stem, 0.85))))
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
    """Return a cut flower with a straight bare stem along x, its blossom to the right."""
    color, length = look.color(*colors), 1.25 * long * look.between(0.92, 1.08)
    bloom = [(s.scale(1.1, 1.1, 1.1).turn(1, np.pi / 2 - nod), t) for s, t in head(look, color)]
    back = min(float(s.bounds[0, 0]) for s, _ in bloom)
    bloom = [(s.move(0.5 * length - max(back, -0.012)), t) for s, t in bloom]
    stalk = rod([(-0.5 * length, 0, 0), (0, 0, 0), (0.5 * length, 0, 0)], 0.0022, 5)
    wide, deep = min(leaf[0], 0.045), min(leaf[1], 0.018)
    blades = [blade([(0, 0, 0), (0.5 * wide, 0, 0.006), (wide, 0, 0.003)], deep, thick=0.15)
              .turn(1, -0.4).turn(0, 2.4 * k).move((0.32 - 0.06 * k) * length)
              for k in range(2)]  # fmt: skip
    pieces: Pieces = [*bloom, (stalk, textures.plain(stem)),
                      (join(blades), textures.plain(tint_color(stem, 0.85)))]  # fmt: skip
    low = min(float(s.bounds[0, 2]) for s, _ in pieces)
    pieces = [(s.move(z=-low), t) for s, t in pieces]
    crown = np.concatenate([s.vertices for s, _ in pieces[: len(bloom)]])
    solids = [pieces[len(bloom)][0], *(s.move(z=-low) for s in blades)]
    return shape(pieces, [whole_hull(crown), *(whole_hull(s.vertices) for s in solids)])


def _row(
    key: str, made: Callable[[Look], Shape], size: tuple[float, float, float], mass: float,
    aliases: tuple[str, ...], colors: tuple[str, ...],
) -> Category:  # fmt: skip
    return Category(key, made, size, mass, aliases, ("living",), (), colors, state="lying flat")


CATEGORIES = (
    _row(
        "rose",
        on_stem(_rose, ("red", "pink", "white", "yellow", "crimson"), 0.23),
        (0.227, 0.0504, 0.0509),
        0.02,
        ("red rose", "cut rose", "single rose", "rose stem"),
        ("red", "pink"),
    ),
    _row(
        "tulip",
        on_stem(
            _tulip, ("red", "yellow", "pink", "purple", "orange", "white"), 0.22, leaf=(0.12, 0.02)
        ),
        (0.222, 0.062, 0.0459),
        0.02,
        ("tulip flower", "tulip stem"),
        ("red", "yellow"),
    ),
    _row(
        "daisy",
        on_stem(_daisy, ("white", "white", "pink", "yellow"), 0.18, nod=0.8, leaf=(0.04, 0.012)),
        (0.169, 0.0532, 0.038),
        0.006,
        (
            "daisy flower",
            "marguerite",
            "chamomile",
            "daisies",
            "aster",
            "artificial flower",
            "fake flower",
            "plastic flower",
            "single flower",
            "cut flower",
            "wildflower",
        ),
        ("white",),
    ),
    _row(
        "sunflower",
        on_stem(_sunflower, ("yellow", "gold", "amber"), 0.27, nod=0.9, leaf=(0.08, 0.04)),
        (0.268, 0.105, 0.0692),
        0.06,
        ("sun flower",),
        ("yellow",),
    ),
    _row(
        "lily",
        on_stem(_lily, ("white", "pink", "orange", "yellow"), 0.24, nod=0.4),
        (0.253, 0.112, 0.119),
        0.02,
        ("lily flower", "lilies", "amaryllis"),
        ("white", "pink"),
    ),
    _row(
        "carnation",
        on_stem(
            _carnation,
            ("pink", "red", "white", "crimson"),
            0.22,
            nod=0.3,
            leaf=(0.07, 0.006),
            stem=(110, 146, 110),
        ),
        (0.205, 0.0559, 0.0506),
        0.012,
        ("carnation flower",),
        ("pink", "red"),
    ),
    _row(
        "lavender",
        on_stem(
            _lavender,
            ("purple", "violet", "lavender", "indigo"),
            0.19,
            nod=0.04,
            leaf=(0.04, 0.004),
            stem=(120, 140, 110),
        ),
        (0.243, 0.032, 0.0229),
        0.004,
        (
            "lavender sprig",
            "sprig of lavender",
            "lavender stem",
            "lavender flower",
            "lavender bunch",
        ),
        ("purple",),
    ),
    _row(
        "orchid",
        on_stem(_orchid, ("pink", "white", "purple", "magenta"), 0.22, leaves=0, nod=0.25),
        (0.205, 0.0587, 0.0615),
        0.02,
        ("orchid stem", "orchid flower"),
        ("pink", "white"),
    ),
    _row(
        "dried_flower",
        on_stem(
            _wheat,
            ("tan", "gold", "beige", "amber", "coral"),
            0.2,
            leaves=1,
            nod=0.04,
            leaf=(0.06, 0.006),
            stem=(190, 160, 100),
        ),
        (0.246, 0.0405, 0.0276),
        0.004,
        (
            "ear of wheat",
            "wheat",
            "dried grass",
            "wheat stalk",
            "wheat ear",
            "dried flower bundle",
            "raffia bundle",
        ),
        ("tan",),
    ),
)
"""The module's categories."""
