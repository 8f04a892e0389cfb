"""How house plants grow in their pots: leaves, stems, trunks, fronds, blossoms."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...build.collision import hull_of, hull_part
from ...build.forms import blade
from ...build.settled import limb
from ...build.shape import Shape, shape
from ...build.solids import Solid, ellipsoid, join, prism, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, rgb, tint_color
from ...surfaces.look import Look
from ..home.plants import Pieces, leaf_blade, planter

Point = tuple[float, float, float]


@dataclass(frozen=True)
class PlantForm:
    """A potted plant, in metres.

    ``form`` names how it grows: "rosette" from the soil, "stems" with a leaf on each, "cane" with
    tufts on trunks, "tree" with a crown, "frond" with feathered leaves, "trap" with jaws.
    ``leaf`` is a leaf's length and width, ``count`` how many there are, ``rise`` the height of
    stems or trunks, ``green`` its colours and ``mark`` a second colour in the pattern ``skin``.
    ``bloom`` names flowers or fruit in ``hues``.
    """

    form: str
    leaf: tuple[float, float]
    count: int
    rise: float = 0.06
    green: tuple[str, ...] = ("green", "green", "olive")
    skin: str = "leaf"
    mark: str = "lime"
    bloom: str = ""
    hues: tuple[str, ...] = ("pink", "white", "red")
    steep: float = 0.7


def _skin(look: Look, kind: PlantForm, green: RGB) -> textures.Tile:
    mark = np.array(rgb(kind.mark))
    if kind.skin in ("leaf", "split"):
        return textures.leaf(look.rng, green).transpose(1, 0, 2)
    if kind.skin == "spots":
        return textures.spots(look.rng, green, tuple(mark), 0.3)
    y, x = np.mgrid[0:64, 0:64] / 63
    side = np.abs(x - 0.5) * 2
    if kind.skin == "bars":
        on = np.sin(14 * (y + 0.4 * side)) > 0.35
    elif kind.skin == "edge":
        on = (side > 0.55) & (side < 1.0)
    else:
        on = (side < 0.14) | (np.sin(30 * (y - 0.5 * side)) > 0.75)
    image = np.where(on[..., None], mark, np.array(green))
    return np.clip(image, 0, 255).astype(np.uint8).transpose(1, 0, 2)


def _split(length: float, width: float) -> Solid:
    """Return a monstera's leaf along +x: a heart with slits."""
    right = [(0.0, 0.06), (-0.08, 0.3), (0.1, 0.5), (0.3, 0.5), (0.22, 0.2), (0.42, 0.47),
             (0.56, 0.4), (0.42, 0.15),
             (0.64, 0.34), (0.76, 0.26), (0.6, 0.1), (0.84, 0.18), (1.0, 0.0)]  # fmt: skip
    outline = np.array([(x, -y) for x, y in right] + right[-2::-1]) * [length, 1.2 * width]
    leaf = prism(outline, 0, 0.0012)
    return leaf.bend(
        lambda p: np.column_stack(
            [p[:, :2], p[:, 2] + 0.35 * p[:, 0] - 0.75 * p[:, 0] ** 2 / length]
        )
    )


def _stem(top: Point, base: float, start: float) -> Solid:
    """Return a thin stem from near the middle of the soil to ``top``."""
    x, y, z = top
    bend = 0.5 + 0.5 * start
    return tube(
        [(start * x, start * y, base), (bend * x, bend * y, base + 0.65 * (z - base)), top],
        [0.002, 0.0016, 0.0012],
        4,
    )


def _foliage(
    look: Look, kind: PlantForm, base: float, r: float
) -> tuple[list[Solid], list[Solid], list[Point]]:
    """Return leaves, stems, and places where flowers may sit."""
    leaves: list[Solid] = []
    stems: list[Solid] = []
    tips: list[Point] = []
    long, wide = kind.leaf

    def leaf(size: float, angle: float, lift: float, at: Point) -> None:
        solid = _split(long * size, wide * size).turn(2, angle) if kind.skin == "split" else (
            leaf_blade(long * size, wide * size, angle, lift))  # fmt: skip
        leaves.append(solid.move(*at))

    for k in range(kind.count):
        a, share = 2.4 * k, (k + 0.5) / kind.count
        size = look.between(0.85, 1.12)
        if kind.form == "rosette":
            leaf(
                size * (1.1 - 0.4 * share),
                a,
                kind.steep + 0.7 * share,
                (0, 0, base + 0.006 * share),
            )
        elif kind.form == "stems":
            out = r * (0.3 + 0.9 * (1 - share))
            top = (out * np.cos(a), out * np.sin(a), base + kind.rise * (0.45 + 0.7 * share))
            stems.append(_stem(top, base, 0.2))
            leaf(size, a, kind.steep - 0.5, top)
            tips.append(top)
        elif kind.form == "frond":
            reach = long * size
            lift = kind.steep + 0.5 * share
            path = np.array([(0, 0, base), (0.3 * reach * np.cos(lift), 0,
                                            base + 0.5 * reach * np.sin(lift)),
                             (0.7 * reach * np.cos(lift), 0, base + 0.85 * reach * np.sin(lift)),
                             (reach * np.cos(lift) + 0.1 * reach, 0,
                              base + 0.75 * reach * np.sin(lift))])  # fmt: skip
            stems.append(tube(path, [0.0022, 0.0018, 0.0014, 0.0008], 4).turn(2, a))
            for n in range(8):
                t = 0.34 + 0.08 * n
                i = min(int(3 * t), 2)
                at = path[i] + (path[i + 1] - path[i]) * (3 * t - i)
                for s in (-1, 1):
                    tip = at + np.array([0.3 * wide, s * wide * (1 - 0.5 * t), -0.012])
                    leaflet = tube(
                        [at, (at + tip) / 2 + (0, 0, 0.004), tip],
                        [0.001, 0.07 * wide, 0.0004],
                        4,
                        squash=0.15,
                    )
                    leaves.append(leaflet.turn(2, a))
        elif kind.form == "trap":
            lift = 0.5 + 0.6 * share
            reach = long * size
            top = np.array([reach * np.cos(lift), 0, base + reach * np.sin(lift)])
            stems.append(
                blade(
                    [
                        (0, 0, base),
                        tuple(0.5 * np.add(top, (0, 0, base)) + np.array([0, 0, 0.006])),
                        tuple(top),
                    ],
                    0.014,
                    thick=0.2,
                    sides=5,
                ).turn(2, a)
            )
            for s in (-1, 1):
                jaw = (
                    ellipsoid(0.026, 0.019, 0.004, 8, 5)
                    .turn(0, s * 0.75)
                    .move(top[0] + 0.01, s * 0.006, top[2] + 0.006)
                )
                leaves.append(jaw.turn(2, a))
                stems += [tube([(top[0] + x, s * 0.011, top[2] + 0.011),
                                (top[0] + x, s * 0.011, top[2] + 0.022)],
                               [0.0009, 0.0004], 3).turn(2, a) for x in (0.003, 0.01,
                                   0.017)]  # fmt: skip
    if kind.form in ("cane", "tree", "bamboo"):
        trunks = 1 if kind.form == "tree" else look.pick([2, 3] if kind.form == "cane" else [3, 4])
        for n in range(trunks):
            a = 2 * np.pi * n / trunks + 0.5
            out = 0.0 if trunks == 1 else 0.34 * r
            high = kind.rise * (1 - 0.24 * n) * look.between(0.92, 1.08)
            foot, top = (out * np.cos(a), out * np.sin(a)), base + high
            lean = 0.012
            stems.append(limb([(*foot, base - 0.006), (foot[0] + lean * np.cos(a),
                                                       foot[1] + lean * np.sin(a),
                                                       base + 0.5 * high),
                               (*foot, top)], [0.0075, 0.0065,
                                               0.0055] if kind.form != "bamboo" else [0.0058,
                                                   0.0058, 0.0055], 8))  # fmt: skip
            for k in range(kind.count):
                b = 2.4 * k + n
                share = (k + 0.5) / kind.count
                if kind.form == "tree":
                    up = np.arccos(1 - 1.75 * share)
                    rad = 0.055 * look.between(0.8, 1.1)
                    at = (
                        rad * np.sin(up) * np.cos(b),
                        rad * np.sin(up) * np.sin(b),
                        top + 0.02 + rad * np.cos(up),
                    )
                    leaf(look.between(0.85, 1.1), b, 0.9 - 0.5 * share, at)
                    tips.append(at)
                elif kind.form == "bamboo":
                    at = (*foot, top - 0.035 * share)
                    leaf(look.between(0.8, 1.05), b, 0.6, at)
                else:
                    leaf(
                        look.between(0.85, 1.1),
                        b,
                        kind.steep + 0.8 * share,
                        (*foot, top - 0.012 + 0.014 * share),
                    )
    return leaves, stems, tips


def _flowers(look: Look, kind: PlantForm, base: float, r: float, tips: list[Point]) -> Pieces:
    if not kind.bloom:
        return []
    hue = look.own_color(*kind.hues)
    petal, gold = textures.speckles(look.rng, hue, 8), textures.plain((240, 196, 60))
    blooms: list[Solid] = []
    hearts: list[Solid] = []
    stems: list[Solid] = []
    for k in range({"bracts": 5, "cyclamen": 7}.get(kind.bloom, 8)):
        a = 2.4 * k + 0.6
        out = r * (0.25 + 0.6 * (k % 3) / 2)
        if kind.bloom == "fruit":
            at = tips[(3 * k + 2) % len(tips)]
            blooms.append(
                ellipsoid(0.024, 0.02, 0.02, 12, 8).move(1.15 * at[0], 1.15 * at[1], at[2] - 0.014)
            )
            continue
        top = (out * np.cos(a), out * np.sin(a), base + kind.rise * (1.05 + 0.12 * (k % 3)))
        stems.append(_stem(top, base, 0.3))
        if kind.bloom == "bracts":
            for n in range(8):
                b = 2 * np.pi * n / 8
                blooms.append(
                    leaf_blade(0.055 - 0.012 * (n % 2), 0.026, b, 0.25 + 0.2 * (n % 2)).move(*top)
                )
            hearts += [ellipsoid(0.005, 0.005, 0.006, 5, 3).move(top[0] + 0.005 * np.cos(b),
                top[1] + 0.005 * np.sin(b), top[2] + 0.005)
                       for b in np.arange(3) * 2.1]  # fmt: skip
        elif kind.bloom == "cyclamen":
            blooms += [blade([(0, 0, 0), (0.008 * np.cos(b), 0.008 * np.sin(b), 0.016),
                              (0.014 * np.cos(b + 0.5), 0.014 * np.sin(b + 0.5), 0.036)],
                             0.02, thick=0.2,
                             sides=4).move(*top) for b in 2 * np.pi * np.arange(5) / 5]  # fmt: skip
        elif kind.bloom == "cluster":
            for n in range(5):
                b, s = 2.4 * n, 0.006 * np.sqrt(n)
                blooms.append(
                    ellipsoid(0.012, 0.012, 0.006, 5, 4).move(
                        top[0] + 1.2 * s * np.cos(b),
                        top[1] + 1.2 * s * np.sin(b),
                        top[2] + 0.004 - 0.4 * s,
                    )
                )
        else:
            blooms += [
                ellipsoid(0.017, 0.012, 0.005, 7, 4).move(x=0.008).turn(2, b).move(*top)
                for b in 2 * np.pi * np.arange(5) / 5
            ]
            hearts.append(ellipsoid(0.006, 0.006, 0.006, 7, 5).move(*top))
    pieces: Pieces = [(join(blooms), petal)]
    if hearts:
        pieces.append((join(hearts), gold))
    if stems:
        pieces.append((join(stems), textures.plain((110, 140, 70))))
    return pieces


def plant(kind: PlantForm) -> Callable[[Look], Shape]:
    """Return the shape function of one kind of potted plant."""

    def make(look: Look) -> Shape:
        r, h = look.between(0.045, 0.058), look.between(0.065, 0.085)
        pot = planter(look, r, h)
        base = 0.9 * h
        green = look.own_color(*kind.green, spread=12)
        leaves, stems, tips = _foliage(look, kind, base, r)
        crown = join(leaves)
        pieces: Pieces = [*pot, (crown, _skin(look, kind, green))]
        bark: RGB = (118, 92, 62) if kind.form in ("cane", "tree") else tint_color(green, 0.9)
        if kind.form == "trap":
            bark = (112, 152, 70)
        if kind.form == "bamboo":
            bark_tile = textures.stripes(
                [(126, 168, 74), (126, 168, 74), (126, 168, 74), (196, 206, 130)], 7
            )
        else:
            bark_tile = textures.plain(bark)
        if stems:
            pieces.append((join(stems), bark_tile))
        pieces += _flowers(look, kind, base, r, tips)
        points = np.concatenate([s.vertices for s, _ in pieces[2:]])
        near = points[np.hypot(points[:, 0], points[:, 1]) < 1.3 * r]
        return shape(pieces, [hull_of(pot[0][0]), hull_part(near)])

    return make
