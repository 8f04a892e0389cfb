"""Objects of the ``living`` theme: plants."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...kit import materials, prints, surfaces
from ...kit.materials import dye
from ...kit.outlines import smooth
from ...kit.parts import box_part, cylinder_part, hull_of, hull_part
from ...kit.primitives import ball, blade, limb, planter, rod, standing
from ...kit.shapes import Category, Pieces, Shape, category, from_pieces, put_down, shape
from ...kit.solids import Solid, box, cylinder, ellipsoid, join, lathe, loft, prism, torus, tube
from ...kit.surfaces import RGB, Look, rgb, tint_color
from ...values import ConvexPart

Point = tuple[float, float, float]


@dataclass(frozen=True)
class PlantForm:
    """The form of a potted plant; lengths are in metres.

    ``form`` names how it grows: "rosette" from the soil, "stems" with a leaf on each, "cane" with
    tufts on trunks, "tree" with a crown, "frond" with feathered leaves, or "trap" with jaws.
    ``leaf`` is the length and width of a leaf, ``count`` the number of leaves, ``rise`` the height
    of stems or trunks, ``green`` its colours, and ``mark`` a second colour in the pattern ``skin``.
    ``bloom`` names flowers or fruit in the colours ``hues``.
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


def _skin(look: Look, kind: PlantForm, green: RGB) -> surfaces.Tile:
    mark = np.array(rgb(kind.mark))
    if kind.skin in ("leaf", "split"):
        return surfaces.leaf(look.rng, green).transpose(1, 0, 2)
    if kind.skin == "spots":
        return surfaces.spots(look.rng, green, tuple(mark), 0.3)
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
    """Return a monstera leaf along +x: a heart shape with slits."""
    right = [(0.0, 0.06), (-0.08, 0.3), (0.1, 0.5), (0.3, 0.5), (0.22, 0.2), (0.42, 0.47),
             (0.56, 0.4), (0.42, 0.15),
             (0.64, 0.34), (0.76, 0.26), (0.6, 0.1), (0.84, 0.18), (1.0, 0.0)]  # fmt: skip
    outline = np.array([(x, -y) for x, y in right] + right[-2::-1]) * [length, 1.2 * width]
    leaf = prism(outline, 0, 0.0012)
    return leaf.bend(lambda p: np.column_stack([p[:, :2], p[:, 2] + 0.35 * p[:, 0] - 0.75
                                                * p[:, 0] ** 2 / length]))  # fmt: skip


def _stem(top: Point, base: float, start: float) -> Solid:
    """Return a thin stem from near the centre of the soil to ``top``."""
    x, y, z = top
    bend = 0.5 + 0.5 * start
    return tube([(start * x, start * y, base), (bend * x, bend * y, base + 0.65 * (z - base)), top],
                [0.002, 0.0016, 0.0012], 4)  # fmt: skip


def _foliage(
    look: Look, kind: PlantForm, base: float, r: float
) -> tuple[list[Solid], list[Solid], list[Point]]:
    """Return the leaves and stems of a plant, and the positions where flowers can grow."""
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
            leaf(size * (1.1 - 0.4 * share), a, kind.steep + 0.7 * share,
                 (0, 0, base + 0.006 * share))  # fmt: skip
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
                    leaflet = tube([at, (at + tip) / 2 + (0, 0, 0.004), tip],
                                   [0.001, 0.07 * wide, 0.0004], 4, squash=0.15)  # fmt: skip
                    leaves.append(leaflet.turn(2, a))
        elif kind.form == "trap":
            lift = 0.5 + 0.6 * share
            reach = long * size
            top = np.array([reach * np.cos(lift), 0, base + reach * np.sin(lift)])
            stems.append(blade([(0, 0, base), tuple(0.5 * np.add(top, (0, 0, base))
                                                    + np.array([0, 0, 0.006])), tuple(top)], 0.014,
                               thick=0.2, sides=5).turn(2, a))  # fmt: skip
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
                    at = (rad * np.sin(up) * np.cos(b), rad * np.sin(up) * np.sin(b), top + 0.02
                          + rad * np.cos(up))  # fmt: skip
                    leaf(look.between(0.85, 1.1), b, 0.9 - 0.5 * share, at)
                    tips.append(at)
                elif kind.form == "bamboo":
                    at = (*foot, top - 0.035 * share)
                    leaf(look.between(0.8, 1.05), b, 0.6, at)
                else:
                    leaf(look.between(0.85, 1.1), b, kind.steep + 0.8 * share,
                         (*foot, top - 0.012 + 0.014 * share))  # fmt: skip
    return leaves, stems, tips


def _flowers(look: Look, kind: PlantForm, base: float, r: float, tips: list[Point]) -> Pieces:
    if not kind.bloom:
        return []
    hue = look.own_color(*kind.hues)
    petal, gold = surfaces.speckles(look.rng, hue, 8), surfaces.plain((240, 196, 60))
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
                blooms.append(ellipsoid(0.012, 0.012, 0.006, 5, 4).move(top[0] + 1.2 * s
                                                                        * np.cos(b), top[1] + 1.2
                                                                        * s * np.sin(b), top[2]
                                                                        + 0.004 - 0.4
                                                                        * s))  # fmt: skip
        else:
            blooms += [ellipsoid(0.017, 0.012, 0.005, 7, 4).move(x=0.008).turn(2, b).move(*top)
                       for b in 2 * np.pi * np.arange(5) / 5]  # fmt: skip
            hearts.append(ellipsoid(0.006, 0.006, 0.006, 7, 5).move(*top))
    pieces: Pieces = [(join(blooms), petal)]
    if hearts:
        pieces.append((join(hearts), gold))
    if stems:
        pieces.append((join(stems), surfaces.plain((110, 140, 70))))
    return pieces


def plant(kind: PlantForm) -> Callable[[Look], Shape]:
    """Return the shape function of the potted plant that ``kind`` describes."""

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
            bark_tile = surfaces.stripes(
                [(126, 168, 74), (126, 168, 74), (126, 168, 74), (196, 206, 130)], 7
            )
        else:
            bark_tile = surfaces.plain(bark)
        if stems:
            pieces.append((join(stems), bark_tile))
        pieces += _flowers(look, kind, base, r, tips)
        points = np.concatenate([s.vertices for s, _ in pieces[2:]])
        near = points[np.hypot(points[:, 0], points[:, 1]) < 1.3 * r]
        return shape(pieces, [hull_of(pot[0][0]), hull_part(near)])

    return make


@category("cactus", size=(0.0991, 0.0952, 0.159), mass=0.4, material="ceramic", assembled=True,
          aliases=("cacti", "potted cactus", "small cactus", "cactus plant", "cactus pot"),
          themes=("living", "office"), roles=("tall",), colors=("green",))  # fmt: skip
def cactus(look: Look) -> Shape:
    """A potted cactus: a spiny column with arms, a ball or paddles, sometimes with a bloom."""
    r, h = look.between(0.04, 0.055), look.between(0.055, 0.08)
    pieces = planter(look, r, h)
    green = look.color("green", "green", "olive", "sage", "teal", spread=16)
    plant, hulls = cactus_plant(look, green, h, r)
    return shape([*pieces, *plant], [hull_of(pieces[0][0]), *hulls])


@category("succulent", size=(0.0949, 0.0914, 0.0843), mass=0.25, material="ceramic", assembled=True,
          aliases=("potted succulent", "succulent plant", "echeveria", "aloe", "aloe vera",
          "small succulent"), themes=("living", "office"), roles=("round",),
          colors=("sage", "green"))  # fmt: skip
def succulent(look: Look) -> Shape:
    """A rosette of thick leaves in a small pot."""
    r, h = look.between(0.036, 0.05), look.between(0.045, 0.065)
    pieces: Pieces = planter(look, r, h)
    green = look.color("sage", "green", "mint", "teal", "olive", "lavender", "pink", spread=14)
    tip = look.pick([tint_color(green, 1.2), (206, 120, 130), tint_color(green, 0.7)])
    tile = surfaces.gradient(green, tip, look.rng, 4)
    leaves: list[Solid] = []
    count = 26
    for n in range(count):
        share = n / count
        long = 1.15 * r * (1.05 - 0.72 * share)
        lift = 0.25 + 1.15 * share
        leaf = ellipsoid(long, 0.5 * long, 0.2 * long, 10, 6).move(x=0.5 * long).turn(1, -lift)
        leaves.append(leaf.turn(2, 2.4 * n).move(z=0.92 * h + 0.014 * share))
    rosette = join(leaves)
    pieces.append((rosette, tile))
    return shape(pieces, [hull_of(pieces[0][0]), hull_of(rosette)])


def leaf_blade(length: float, width: float, angle: float, lift: float) -> Solid:
    """Return a thin, curved leaf that starts at the origin; ``angle`` is its azimuth."""
    t = np.linspace(0, 1, 7)
    half = width / 2 * np.sin(np.pi * np.clip(t * 0.94 + 0.03, 0, 1)) ** 0.75
    rise = length * (np.sin(lift) * t - 0.35 * np.cos(lift) * t**2)
    along = length * np.cos(lift) * t
    section = np.array([(-1.0, 0.0), (0.0, -0.3), (1.0, 0.0), (0.0, -0.05)])
    thick = np.array([0, 0, 0, 0.0008])
    rings = np.stack([np.column_stack([np.full(4, x), section[:, 0] * w, section[:, 1] * w + z
                                       + thick]) for x, w, z in zip(along, half, rise,
                                                                    strict=True)])  # fmt: skip
    return loft(rings, section, profile=np.column_stack([along, rise])).turn(2, angle)


def cactus_plant(look: Look, green: RGB, h: float, r: float) -> tuple[Pieces, list[ConvexPart]]:
    """Return a column-shaped, round or paddle-shaped cactus and its collision parts."""
    ribs = surfaces.stripes([green, tint_color(green, 0.7)], 9, upright=True, side=128).copy()
    for row in range(4, 128, 12):
        ribs[row : row + 2, 3::14] = (240, 236, 210)
    kind = look.pick(["column", "ball", "paddles"])
    bloom = surfaces.plain(look.own_color("pink", "yellow", "red", "white"))
    tall = look.between(0.12, 0.16)
    if kind == "ball":
        wide = 1.5 * r
        ball = ellipsoid(wide, wide, 0.85 * wide, 24, 12).move(z=0.86 * h + 0.4 * wide)
        top = ellipsoid(0.024, 0.024, 0.018, 12, 6).move(z=0.86 * h + 0.83 * wide)
        return [(ball, ribs), (top, bloom)], [hull_of(ball)]
    if kind == "column":
        trunk = ellipsoid(0.05, 0.05, tall, 20, 12).move(z=0.8 * h + tall / 2)
        z = 0.8 * h + 0.45 * tall
        arms = []
        for s in look.pick([(1,), (-1, 1)]):
            path = [(s * 0.01, 0, z), (s * 0.042, 0, z + 0.005), (s * 0.045, 0, z + 0.05)]
            arms.append(tube(smooth(path, 4), 0.011, 10))
        top = ellipsoid(0.02, 0.02, 0.016, 12, 6).move(z=0.8 * h + tall - 0.002)
        pieces: Pieces = [(trunk, ribs), (top, bloom), *((arm, ribs) for arm in arms)]
        return pieces, [hull_of(trunk), *[hull_of(arm) for arm in arms]]
    pads = [
        ellipsoid(0.055, 0.016, 0.08, 18, 10).move(z=0.84 * h + 0.036),
        ellipsoid(0.044, 0.014, 0.06, 18, 10).turn(1, 0.5).move(0.026, 0, 0.84 * h + 0.092),
        ellipsoid(0.04, 0.014, 0.054, 18, 10).turn(1, -0.6).move(-0.028, 0, 0.84 * h + 0.084),
    ]
    spines = surfaces.spots(look.rng, green, (236, 232, 200), 0.03)
    return [(pad, spines) for pad in pads], [hull_of(pad) for pad in pads]


@category("seedling", size=(0.065, 0.058, 0.105), mass=0.04, material="food",
          aliases=("plant seedling", "plug plant", "young plant"), themes=("living",),
          colors=("green",), common=True)  # fmt: skip
def seedling(look: Look) -> Shape:
    """A seedling without a pot, with soil around its roots."""
    r, h, tall = look.between(0.019, 0.024), look.between(0.03, 0.036), look.between(0.085, 0.105)
    soil = cylinder(r, h, 14, top=1.15 * r, bevel=0.002)
    stem = tube([(0, 0, h - 0.004), (0.002, 0, 0.6 * tall), (0, 0, 0.9 * tall)], 0.0022, 7)
    leaves = [leaf_blade(0.036 + 0.006 * (k % 2), 0.018, 2.4 * k, 0.75 - 0.15 * (k // 2))
              .move(z=(0.9 - 0.12 * (k // 2)) * tall) for k in range(6)]  # fmt: skip
    green = look.own_color("green", "lime", "olive")
    earth = surfaces.spots(look.rng, (84, 60, 44), (52, 38, 28), 0.3)
    return shape([(soil, earth), (stem, surfaces.plain(tint_color(green, 0.8))),
                  (join(leaves), surfaces.speckles(look.rng, green, 8))],
                 [hull_of(soil), hull_of(stem)])  # fmt: skip


@category("bare_cactus", size=(0.045, 0.045, 0.12), mass=0.08, material="food", themes=("living",),
          colors=("green",), common=True)  # fmt: skip
def bare_cactus(look: Look) -> Shape:
    """A ribbed cactus without a pot, with soil around its roots."""
    r, h, tall = look.between(0.02, 0.024), look.between(0.03, 0.036), look.between(0.07, 0.1)
    soil = cylinder(r, h, 14, top=1.1 * r, bevel=0.002)
    turn = np.linspace(0, 2 * np.pi, 33)[:-1]
    rib = 0.9 * r * (1 + 0.09 * np.cos(8 * turn))
    rings = [np.column_stack([rib * s * np.cos(turn), rib * s * np.sin(turn),
                              np.full(32, h - 0.002 + tall * t)])
             for s, t in ((0.8, 0.0), (1.0, 0.25), (1.0, 0.65), (0.8, 0.9),
                          (0.35, 1.0))]  # fmt: skip
    body = loft(np.array(rings), rings[0][:, :2])
    green = look.own_color("green", "olive", "sage")
    earth = surfaces.spots(look.rng, (84, 60, 44), (52, 38, 28), 0.3)
    return shape([(soil, earth), (body, surfaces.speckles(look.rng, green, 8))],
                 [hull_of(soil), hull_of(body)])  # fmt: skip


@category("flower_bulb", size=(0.046, 0.046, 0.06), mass=0.03, material="food",
          aliases=("tulip bulb", "daffodil bulb", "plant bulb"), themes=("living",),
          colors=("brown",))  # fmt: skip
def flower_bulb(look: Look) -> Shape:
    """A flower bulb with papery skin, roots and a green tip."""
    color = look.color("brown", "tan", "terracotta", "bronze", "amber", "beige")
    body = lathe([(0, 0), (0.01, 0), (0.021, 0.01), (0.023, 0.02), (0.013, 0.036), (0.004, 0.048),
                  (0, 0.05)], 20)  # fmt: skip
    tip = cylinder(0.005, 0.016, 10, top=0.0012).move(z=0.042)
    roots = [rod([(0.006, 0, 0.004), (0.014, 0, 0.002), (0.021, 0.003, 0.001)], 0.0009, 5)
             .turn(2, 0.7 * k) for k in range(9)]  # fmt: skip
    skin = surfaces.stripes([color, tint_color(color, 0.82), color], 9, upright=True, side=96)
    return put_down([(body, skin), (tip, surfaces.plain((110, 160, 80))),
                    (join(roots), surfaces.plain((226, 208, 176)))], body,
                   factor=look.between(0.85, 1.2))  # fmt: skip


def in_pot(look: Look, plant: Pieces, r: float, h: float) -> Shape:
    """Return a plant in a pot of radius ``r`` and height ``h``; the soil is at z = 0.88 h."""
    pieces = planter(look, r, h)
    crown = join([solid for solid, _ in plant])
    near = crown.vertices[np.hypot(*crown.vertices[:, :2].T) < 1.3 * r]
    return shape([*pieces, *plant], [hull_of(pieces[0][0]), hull_part(near)])


@category("fern", size=(0.203, 0.195, 0.175), mass=0.5, material="ceramic", assembled=True,
          aliases=("potted fern", "fern plant", "boston fern"), themes=("living",), roles=("tall",),
          colors=("green",))  # fmt: skip
def fern(look: Look) -> Shape:
    """A potted fern: arching fronds with leaflets on both sides."""
    r, h = look.between(0.042, 0.055), look.between(0.06, 0.085)
    green = look.own_color("green", "lime", "sage", spread=14)
    leaves: list[Solid] = []
    for k in range(10):
        out, up = look.between(0.075, 0.115), look.between(0.06, 0.12)
        t = np.linspace(0, 1, 9)[:, None]
        path = np.column_stack([out * t, 0 * t, h * 0.9 + up * np.sin(1.9 * t)])
        turn = 2.4 * k
        leaves.append(tube(path, 0.0013, 4).turn(2, turn))
        for n in range(2, 8):
            wide = 0.026 * (1.1 - n / 9)
            for s in (-1, 1):
                leaf = ellipsoid(wide, 0.009, 0.0015, 4, 4).turn(2, s * 1.1)
                leaves.append(leaf.move(path[n, 0] + 0.2 * wide, s * 0.42 * wide, path[n, 2])
                              .turn(2, turn))  # fmt: skip
    return in_pot(look, [(join(leaves), surfaces.plain(green))], r, h)


@category("ivy", size=(0.16, 0.16, 0.12), mass=0.6, material="ceramic", assembled=True,
          aliases=("potted ivy", "ivy plant", "trailing plant", "hanging plant", "string of hearts",
          "pothos", "philodendron"), themes=("living",), colors=("green",))  # fmt: skip
def ivy(look: Look) -> Shape:
    """A potted ivy with vines that hang over the rim."""
    r, h = look.between(0.045, 0.055), look.between(0.085, 0.11)
    green = look.own_color("green", "olive", "sage", spread=14)
    vines: list[Solid] = []
    leaves: list[Solid] = []
    for k in range(9):
        a = 2.4 * k
        low = look.between(0.015, 0.6 * h)
        path = [(0.3 * r, 0, 0.9 * h), (0.9 * r, 0, 1.22 * h), (1.3 * r, 0.006, 0.95 * h),
                (1.4 * r, -0.006, 0.5 * (h + low)), (1.38 * r, 0.004, low)]  # fmt: skip
        vine = rod(path, 0.0016, 5, 3).turn(2, a)
        vines.append(vine)
        for n in range(1, 7):
            p = vine.vertices[int(n / 7 * len(vine.vertices))]
            leaf = ellipsoid(0.026, 0.022, 0.0028, 5, 4).turn(1, 0.7 if n > 2 else -0.2)
            leaves.append(leaf.turn(2, a + look.between(-0.7, 0.7)).move(*p))
    tile = surfaces.spots(look.rng, green, tint_color(green, 1.5), 0.2)
    return in_pot(look, [(join(leaves), tile), (join(vines), surfaces.plain((110, 96, 60)))], r, h)


@category("bonsai", size=(0.185, 0.105, 0.175), mass=0.8, material="ceramic", assembled=True,
          aliases=("bonsai tree", "bonsai plant"), themes=("living", "office"),
          colors=("terracotta",))  # fmt: skip
def bonsai(look: Look) -> Shape:
    """A bonsai in a shallow dish: a bent trunk with clouds of leaves."""
    color = look.color("terracotta", "navy", "charcoal", "green", "brown", "gray")
    dish = box(0.15, 0.1, 0.03).bend(lambda p: p * np.column_stack(
        [0.88 + 4 * p[:, 2], 0.88 + 4 * p[:, 2], np.ones(len(p))]))  # fmt: skip
    feet = [box(0.016, 0.016, 0.008).move(sx * 0.05, sy * 0.03) for sx in (-1, 1) for sy in (-1, 1)]
    moss = ellipsoid(0.135, 0.088, 0.022, 18, 8).move(z=0.037)
    trunk = rod([(-0.02, 0, 0.036), (0.012, 0.004, 0.07), (-0.016, 0, 0.105), (0.004, 0, 0.14)],
                [0.013, 0.009, 0.007, 0.004], 10)  # fmt: skip
    arms = [rod([(0.004, 0, 0.075), (0.03, 0, 0.085), (0.055, 0, 0.096)], [0.006, 0.003], 7),
            rod([(-0.012, 0, 0.1), (-0.04, 0.004, 0.108), (-0.055, 0.004, 0.122)],
                [0.005, 0.003], 7)]  # fmt: skip
    green = look.own_color("green", "olive", "lime", "green", "red", spread=14)

    def knobbly(p: np.ndarray) -> np.ndarray:
        return p * (1 + 0.1 * np.sin(150 * p[:, :1]) * np.cos(170 * p[:, 1:2]))

    clouds = [ellipsoid(w, 0.8 * w, 0.42 * w, 14, 8).bend(knobbly).move(x, y, z)
              for x, y, z, w in ((0.006, 0, 0.152, 0.085), (0.058, 0, 0.106, 0.066),
                                 (-0.058, 0.004, 0.132, 0.066), (-0.01, 0.014, 0.132, 0.06),
                                 (0.03, -0.012, 0.134, 0.05))]  # fmt: skip
    pieces: Pieces = [
        (join([dish.move(z=0.006), *feet]), look.surface(color, "ceramic")),
        (moss, surfaces.spots(look.rng, (92, 122, 60), (120, 150, 80), 0.2)),
        (join([trunk, *arms]), surfaces.scratches(look.rng, (110, 80, 56), (70, 50, 36), 70)),
        (join(clouds), surfaces.spots(look.rng, green, tint_color(green, 1.3), 0.3)),
    ]
    return put_down(pieces, join([dish.move(z=0.006), *feet]), trunk, join(clouds),
                   factor=look.between(0.9, 1.15))  # fmt: skip


@category("terrarium", size=(0.135, 0.135, 0.165), mass=0.8, material="wood", assembled=True,
          aliases=("plant terrarium", "glass terrarium", "glass dome"), themes=("living",),
          roles=("tall", "round"), colors=("wooden",))  # fmt: skip
def terrarium(look: Look) -> Shape:
    """A terrarium: plants, moss and stones on a wooden base, under a dome modelled as a frame."""
    color = look.color("wooden", "brown", "black", "white", "tan")
    r, h = look.between(0.06, 0.075), look.between(0.13, 0.17)
    foot = cylinder(r, 0.018, 30, bevel=0.003)
    soil = lathe([(0, 0.018), (0.9 * r, 0.018), (0.9 * r, 0.035), (0.5 * r, 0.045), (0, 0.048)], 28)
    moss = [ball(0.036, 0.03, 0.022, (0.5 * r * np.cos(a), 0.5 * r * np.sin(a), 0.044), 10)
            for a in (0.5, 2.6, 4.4)]  # fmt: skip
    leaves = [blade([(0, 0, 0.045), (0.25 * r, 0, 0.045 + 0.3 * h),
                     (0.55 * r, 0, 0.045 + 0.42 * h)], 0.016).turn(2, 1.05 * k)
              for k in range(6)]  # fmt: skip
    stones = [ball(0.018, 0.015, 0.012, (0.66 * r * np.cos(a), 0.66 * r * np.sin(a), 0.04), 8)
              for a in (1.6, 3.5, 5.5)]  # fmt: skip
    rods = [rod([(0.9 * r, 0, 0.018), (0.92 * r, 0, 0.6 * h), (0.6 * r, 0, 0.92 * h), (0, 0, h)],
                0.0018, 6).turn(2, np.pi / 3 * k) for k in range(6)]  # fmt: skip
    bands = [torus(0.91 * r, 0.0018, 30, 6).move(z=z) for z in (0.022, 0.6 * h)]
    knob = ball(0.014, 0.014, 0.014, (0, 0, h + 0.004), 10)
    metal = surfaces.plain(look.pick([(206, 168, 96), (70, 72, 78), (236, 236, 234)]))
    dome = lathe(
        [(0, 0.018), (0.91 * r, 0.018), (0.92 * r, 0.6 * h), (0.6 * r, 0.92 * h), (0, h)], 20
    )
    green = look.own_color("green", "lime", "sage")
    pieces: Pieces = [(foot, look.surface(color, "wood")),
                      (soil, surfaces.speckles(look.rng, (84, 62, 46), 24)),
                      (join(moss), surfaces.spots(look.rng, (96, 130, 64), (130, 160, 84), 0.2)),
                      (join(leaves), surfaces.plain(green)),
                      (join(stones), surfaces.plain((200, 196, 188))),
                      (join([*rods, *bands, knob]), metal)]  # fmt: skip
    return shape(pieces, [cylinder_part(r, 0.02), hull_of(dome)])


@category("seed_packet", size=(0.086, 0.122, 0.0042), mass=0.012, material="paper",
          aliases=("packet of seeds", "seeds", "pack of seeds", "flower seeds", "bag of seeds",
          "seed bag"), themes=("living",), roles=("flat",), colors=("green",),
          state="lying flat")  # fmt: skip
def seed_packet(look: Look) -> Shape:
    """A paper packet of seeds lying flat, with a flower or vegetable on its front."""
    x, y = look.between(0.078, 0.095), look.between(0.11, 0.135)
    color = look.color("green", "yellow", "red", "orange", "violet", "sky", "pink")
    image = prints.canvas(96, 144, (248, 244, 230))
    prints.fill(image, 0, 0, 1, 0.28, color)
    word = look.pick(["SEEDS", "TOMATO", "BASIL", "POPPY", "CARROT", "SUNFLOWER"])
    prints.write(image, word, 0.5, 0.2, 0.09, (250, 250, 246), bold=True)
    prints.stroke(image, [(0.5, 0.94), (0.5, 0.55)], 0.02, (80, 130, 60))
    prints.polygon(image, [(0.5, 0.82), (0.75, 0.7), (0.7, 0.84)], (96, 150, 70))
    prints.polygon(image, [(0.5, 0.76), (0.25, 0.64), (0.3, 0.78)], (96, 150, 70))
    for n in range(9):
        a = 2 * np.pi * n / 9
        prints.disc(image, 0.5 + 0.2 * np.cos(a), 0.52 + 0.133 * np.sin(a), 0.065, color)
    prints.disc(image, 0.5, 0.52, 0.09, (110, 70, 40) if look.chance(0.5) else (246, 206, 80))
    body = box(x, y, 0.0035)
    flap = box(x, 0.014, 0.0008).move(y=y / 2 - 0.008, z=0.0034)
    top = box(0.98 * x, 0.98 * y, 0.0004).move(z=0.0033)
    side = surfaces.speckles(look.rng, (244, 240, 226), 4, 32)
    return shape([(body, side), (top, image), (flap, surfaces.plain(tint_color(color, 0.85)))],
                 [box_part(x, y, 0.0037)])  # fmt: skip


@category("pampas_grass", size=(0.167, 0.146, 0.37), mass=0.5, material="ceramic", assembled=True,
          aliases=("dried pampas grass", "vase of pampas grass", "dried grass bouquet",
          "pampas grass in a vase"), themes=("living",), roles=("tall", "big"),
          colors=("cream",))  # fmt: skip
@from_pieces(bodies=2)
def pampas_grass(look: Look) -> Pieces:
    """A vase with feathery grass."""
    color = look.color("cream", "beige", "pink", "tan")
    pot = standing((0.03, 0), (0.045, 0.03), (0.04, 0.08), (0.02, 0.115), (0.024, 0.13))
    stems, plumes = [], []
    for k in range(6):
        a = 1.05 * k
        tip = np.array([0.055 * np.cos(a), 0.055 * np.sin(a), 0.27 + 0.02 * (k % 3)])
        stems.append(rod([(0, 0, 0.12), (0.5 * tip[0], 0.5 * tip[1], 0.2), tuple(tip)], 0.0016, 5))
        plumes.append(rod([tuple(tip - [0.3 * tip[0], 0.3 * tip[1], 0.05]), tuple(tip),
                           tuple(np.add(tip, (0.45 * tip[0], 0.45 * tip[1], 0.055)))],
                          [0.009, 0.016, 0.003], 8))  # fmt: skip
    fluff = surfaces.scratches(look.rng, color, tint_color(color, 0.8), 200)
    return [(pot, materials.glaze_tile(look, look.own_color("white", "gray", "terracotta",
                                                            "charcoal"))), (join(plumes), fluff),
            (join(stems), dye(look, "tan"))]  # fmt: skip


CATEGORIES = (
    Category("monstera", plant(PlantForm("stems", (0.1, 0.085), 9, 0.13, skin="split", steep=0.8)),
             size=(0.289, 0.271, 0.218), mass=0.8, material="ceramic", assembled=True,
             aliases=("swiss cheese plant", "monstera plant", "cheese plant", "monstera deliciosa",
             "potted monstera"), themes=("living", "office"), roles=("tall",),
             colors=("terracotta", "white")),
    Category("african_violet", plant(PlantForm("rosette", (0.06, 0.044), 16, 0.045, ("green",
             "olive"), bloom="violets", hues=("violet", "purple", "pink", "indigo"), steep=0.35)),
             size=(0.119, 0.112, 0.131), mass=0.5, material="ceramic", assembled=True,
             aliases=("saintpaulia", "african violet plant", "potted violet",
             "potted african violet"), themes=("living", "office"), roles=("tall",),
             colors=("terracotta", "white")),
    Category("venus_flytrap", plant(PlantForm("trap", (0.06, 0.02), 11, green=("crimson", "red",
             "coral"), skin="spots", mark="lime")), size=(0.14, 0.133, 0.144), mass=0.4,
             material="ceramic", assembled=True, aliases=("venus fly trap", "flytrap", "fly trap",
             "carnivorous plant", "potted venus flytrap"), themes=("living", "office"),
             roles=("tall",), colors=("terracotta", "white")),
    Category("lucky_bamboo", plant(PlantForm("bamboo", (0.075, 0.017), 7, 0.17, ("green", "lime"),
             "plain", "green")), size=(0.144, 0.141, 0.254), mass=0.5, material="ceramic",
             assembled=True, aliases=("bamboo plant", "lucky bamboo plant", "bamboo stalk",
             "bamboo", "potted lucky bamboo"), themes=("living", "office"), roles=("tall",),
             colors=("terracotta", "white")),
    Category("yucca", plant(PlantForm("cane", (0.13, 0.014), 20, 0.13, ("green", "sage", "olive"),
             "plain", "sage", steep=0.3)), size=(0.264, 0.242, 0.296), mass=1.0, material="ceramic",
             assembled=True, aliases=("yucca plant", "yucca palm", "potted yucca"),
             themes=("living", "office"), roles=("tall",), colors=("terracotta", "white")),
    Category("dracaena", plant(PlantForm("cane", (0.12, 0.02), 18, 0.15, ("green", "olive"), "edge",
             "crimson", steep=0.25)), size=(0.253, 0.223, 0.299), mass=1.0, material="ceramic",
             assembled=True,
             aliases=("dragon tree", "corn plant", "dracaena plant", "potted dracaena"),
             themes=("living", "office"), roles=("tall",), colors=("terracotta", "white")),
    Category("ficus", plant(PlantForm("tree", (0.045, 0.022), 44, 0.12)), size=(0.182, 0.18, 0.286),
             mass=0.9, material="ceramic", assembled=True, aliases=("weeping fig", "ficus tree",
             "ficus plant", "olive tree", "mini tree", "small tree", "potted ficus"),
             themes=("living", "office"), roles=("tall",), colors=("terracotta", "white")),
    Category("rubber_plant", plant(PlantForm("stems", (0.1, 0.05), 13, 0.16, ("green", "maroon",
             "green"), "leaf", steep=1.1)), size=(0.27, 0.26, 0.275), mass=0.9, material="ceramic",
             assembled=True,
             aliases=("fiddle leaf fig", "rubber tree", "rubber fig", "potted rubber plant"),
             themes=("living", "office"), roles=("tall",), colors=("terracotta", "white")),
    Category("calathea", plant(PlantForm("stems", (0.09, 0.05), 14, 0.1, ("green", "teal"), "bars",
             "sage", steep=1.0)), size=(0.261, 0.243, 0.198), mass=0.7, material="ceramic",
             assembled=True, aliases=("prayer plant", "maranta", "zebra plant", "calathea plant",
             "potted calathea"), themes=("living", "office"), roles=("tall",),
             colors=("terracotta", "white")),
    Category("aspidistra",
             plant(PlantForm("rosette", (0.19, 0.042), 11, green=("green",), steep=0.95)),
             size=(0.188, 0.154, 0.231), mass=0.8, material="ceramic", assembled=True,
             aliases=("cast iron plant", "peace lily plant", "potted aspidistra"),
             themes=("living", "office"), roles=("tall",), colors=("terracotta", "white")),
    Category("snake_plant", plant(PlantForm("rosette", (0.19, 0.03), 9, green=("green", "sage"),
             skin="edge", mark="yellow", steep=1.25)), size=(0.111, 0.106, 0.262), mass=0.7,
             material="ceramic", assembled=True, aliases=("sansevieria", "mother in law's tongue",
             "mother-in-law's tongue", "potted snake plant"), themes=("living", "office"),
             roles=("tall",), colors=("terracotta", "white")),
    Category("spider_plant", plant(PlantForm("rosette", (0.16, 0.012), 26, green=("lime", "green"),
             skin="edge", mark="white", steep=0.55)), size=(0.277, 0.256, 0.177), mass=0.5,
             material="ceramic", assembled=True, aliases=("chlorophytum", "potted spider plant"),
             themes=("living", "office"), roles=("tall",), colors=("terracotta", "white")),
    Category("croton", plant(PlantForm("stems", (0.085, 0.035), 16, 0.12, ("green", "olive"),
             "veins", "orange", steep=1.0)), size=(0.263, 0.245, 0.218), mass=0.8,
             material="ceramic", assembled=True, aliases=("croton plant", "joseph's coat", "coleus",
             "aluminium plant", "potted croton"), themes=("living", "office"), roles=("tall",),
             colors=("terracotta", "white")),
    Category("hoya", plant(PlantForm("stems", (0.05, 0.024), 20, 0.07, ("green", "sage"), "edge",
             "cream", "cluster", ("pink", "white"), 0.7)), size=(0.211, 0.198, 0.164), mass=0.6,
             material="ceramic", assembled=True,
             aliases=("wax plant", "hoya plant", "peperomia", "potted hoya"),
             themes=("living", "office"), roles=("tall",), colors=("terracotta", "white")),
    Category("poinsettia", plant(PlantForm("stems", (0.07, 0.034), 14, 0.1, bloom="bracts",
             hues=("red", "crimson", "red", "white", "pink"), steep=0.7)),
             size=(0.244, 0.234, 0.205), mass=0.6, material="ceramic", assembled=True,
             aliases=("christmas star plant", "poinsettia plant", "christmas flower",
             "potted poinsettia"), themes=("living", "office"), roles=("tall",),
             colors=("terracotta", "white")),
    Category("cyclamen", plant(PlantForm("stems", (0.045, 0.044), 15, 0.055, ("green", "teal"),
             "veins", "sage", "cyclamen", ("magenta", "pink", "white", "red"), 0.6)),
             size=(0.19, 0.181, 0.178), mass=0.5, material="ceramic", assembled=True,
             aliases=("cyclamen plant", "potted cyclamen"), themes=("living", "office"),
             roles=("tall",), colors=("terracotta", "white")),
    Category("kalanchoe", plant(PlantForm("stems", (0.04, 0.028), 20, 0.06, ("green",),
             bloom="cluster", hues=("red", "orange", "yellow", "pink"), steep=0.7)),
             size=(0.188, 0.179, 0.151), mass=0.5, material="ceramic", assembled=True,
             aliases=("flaming katy", "kalanchoe plant", "potted geranium", "busy lizzie",
             "potted kalanchoe"), themes=("living", "office"), roles=("tall",),
             colors=("terracotta", "white")),
    Category("lemon_tree", plant(PlantForm("tree", (0.045, 0.022), 40, 0.12, bloom="fruit",
             hues=("yellow", "gold", "orange", "lime"))), size=(0.179, 0.177, 0.285), mass=1.0,
             material="ceramic", assembled=True, aliases=("orange tree", "citrus tree",
             "kumquat tree", "mini lemon tree", "calamondin", "potted lemon tree"),
             themes=("living", "office"), roles=("tall",), colors=("terracotta", "white")),
    Category("palm", plant(PlantForm("frond", (0.2, 0.07), 9, green=("green", "lime", "olive"),
             steep=0.75)), size=(0.313, 0.291, 0.237), mass=0.8, material="ceramic", assembled=True,
             aliases=("parlour palm", "areca palm", "palm plant", "palm tree", "kentia palm",
             "parlor palm", "indoor palm", "bamboo palm", "potted palm"),
             themes=("living", "office"), roles=("tall",), colors=("terracotta", "white")),
)  # fmt: skip
"""Objects that share their drawing functions."""
