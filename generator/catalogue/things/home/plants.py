"""Plants in pots."""

from __future__ import annotations

import numpy as np

from ....scene import ConvexPart
from ...build.category import Category
from ...build.collision import hull_of, hull_part
from ...build.outlines import smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, cylinder, ellipsoid, join, lathe, loft, tube
from ...surfaces import textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.glazes import glaze_tile
from ...surfaces.look import Look

KINDS = ("leafy", "leafy", "broad", "succulent", "cactus", "blades", "bonsai", "flowering")

Pieces = list[tuple[Solid, textures.Tile]]


def leaf_blade(length: float, width: float, angle: float, lift: float) -> Solid:
    """Return a thin curved leaf that starts at the origin and points along ``angle``."""
    t = np.linspace(0, 1, 7)
    half = width / 2 * np.sin(np.pi * np.clip(t * 0.94 + 0.03, 0, 1)) ** 0.75
    rise = length * (np.sin(lift) * t - 0.35 * np.cos(lift) * t**2)
    along = length * np.cos(lift) * t
    section = np.array([(-1.0, 0.0), (0.0, -0.3), (1.0, 0.0), (0.0, -0.05)])
    thick = np.array([0, 0, 0, 0.0008])
    rings = np.stack(
        [
            np.column_stack([np.full(4, x), section[:, 0] * w, section[:, 1] * w + z + thick])
            for x, w, z in zip(along, half, rise, strict=True)
        ]
    )
    return loft(rings, section, profile=np.column_stack([along, rise])).turn(2, angle)


def planter(look: Look, r: float, h: float) -> Pieces:
    """Return a pot of clay, glaze or basketwork, tapered, straight or bellied, and its soil."""
    color = look.color(
        *("terracotta", "terracotta", "white", "gray", "teal", "cream", "black", "mustard"),
        *("pink", "sky", "brown"),
    )
    kind = look.pick(["rimmed", "straight", "belly", "faceted"])
    low = 0.75 * r
    side = {
        "rimmed": [(low, 0), (0.96 * r, 0.8 * h), (r, 0.8 * h), (r, h)],
        "straight": [(0.97 * r, 0), (r, 0.05 * h), (r, 0.6 * h), (r, h)],
        "belly": [(0.6 * r, 0), (1.02 * r, 0.4 * h), (r, 0.75 * h), (0.86 * r, h)],
        "faceted": [(0.8 * r, 0), (1.1 * r, 0.5 * h), (1.1 * r, 0.8 * h), (1.1 * r, h)],
    }[kind]
    top = side[-1][0]
    profile = [(0, 0), *side, (top - 0.005, h), (top - 0.005, 0.88 * h), (0, 0.88 * h)]
    v = [0, 0.02, 0.35, 0.55, 0.95, 0.96, 0.98, 1]
    pot = lathe(profile, 8 if kind == "faceted" else 28, v=v)
    soil = cylinder((top - 0.006) * (0.92 if kind == "faceted" else 1), 0.004, 24)
    tile = textures.basketwork(look.rng, color) if look.chance(0.12) else glaze_tile(look, color)
    earth = look.pick([(74, 54, 40), (58, 44, 36), (150, 144, 134)])
    return [(pot, tile), (soil.move(z=0.88 * h), textures.speckles(look.rng, earth, 14))]


def potted_plant(look: Look) -> Shape:
    """A pot with a plant: leafy, broad-leaved, bladed, flowering, a succulent, cactus or bonsai."""
    r, h = look.between(0.042, 0.062), look.between(0.065, 0.095)
    pieces = planter(look, r, h)
    green = look.own_color("green", "green", "green", "olive", "sage", spread=16)
    if look.chance(0.12):
        green = look.own_color("maroon", "crimson", "lime")
    kind = look.pick(KINDS)
    grow = {"cactus": cactus_plant, "blades": _blades, "bonsai": _bonsai}.get(kind)
    plant, hulls = grow(look, green, h, r) if grow else _leaves(look, green, h, r, kind)
    return shape([*pieces, *plant], [hull_of(pieces[0][0]), *hulls])


def _leaves(
    look: Look, green: RGB, h: float, r: float, kind: str
) -> tuple[Pieces, list[ConvexPart]]:
    """Return a crown of leaves round a short trunk, or a rosette."""
    rosette = kind == "succulent"
    count = {"succulent": 24, "broad": 12}.get(kind, 22)
    tile = textures.leaf(look.rng, green).transpose(1, 0, 2)
    solids: list[Solid] = []
    for k in range(count):
        share = k / count
        long = 0.066 * (1.2 - 0.7 * share) if rosette else look.between(0.07, 0.115)
        wide = {"succulent": 0.55, "broad": 0.8}.get(kind, look.between(0.35, 0.5)) * long
        base = h * 0.9 + (0.012 * share if rosette else look.between(0.0, 0.06))
        steep = 0.75 + 0.9 * share if rosette else 0.5 + look.between(-0.3, 0.75)
        solids.append(leaf_blade(long, wide, 2.4 * k, steep).move(z=base))
    crown = join(solids)
    pieces: Pieces = [(crown, tile)]
    if not rosette:
        trunk = cylinder(0.0045, 0.075, 8).move(z=0.86 * h)
        pieces.append((trunk, textures.plain((96, 84, 52))))
    if kind == "flowering":
        pieces += _blossoms(look, green, h)
    near = crown.vertices[np.hypot(*crown.vertices[:, :2].T) < 1.15 * r]
    return pieces, [hull_part(near)]


def _blossoms(look: Look, green: RGB, h: float) -> Pieces:
    """Return six blossoms on stems above a pot of height ``h``."""
    hue = look.own_color("red", "pink", "yellow", "violet", "white")
    petal, heart = textures.speckles(look.rng, hue, 8), textures.plain((226, 180, 60))
    pieces: Pieces = []
    for k in range(6):
        angle, out = 2.1 * k, look.between(0.012, 0.05)
        at = (out * np.cos(angle), out * np.sin(angle), h + look.between(0.075, 0.11))
        one = ellipsoid(0.02, 0.013, 0.006, 6, 4).move(x=0.01)
        bloom = join([one.turn(2, np.pi / 3 * m) for m in range(6)])
        stem = tube(np.array([(0.3 * at[0], 0.3 * at[1], 0.88 * h), at]), 0.0015, 5)
        middle = ellipsoid(0.01, 0.01, 0.008, 8, 4)
        pieces += [(bloom.move(*at), petal), (stem, textures.plain(green)),
                   (middle.move(*at), heart)]  # fmt: skip
    return pieces


def cactus_plant(look: Look, green: RGB, h: float, r: float) -> tuple[Pieces, list[ConvexPart]]:
    """Return a column, a ball, or paddles, with ribs, spines and a bloom."""
    ribs = textures.stripes([green, tint_color(green, 0.7)], 9, upright=True, side=128).copy()
    for row in range(4, 128, 12):
        ribs[row : row + 2, 3::14] = (240, 236, 210)
    kind = look.pick(["column", "ball", "paddles"])
    bloom = textures.plain(look.own_color("pink", "yellow", "red", "white"))
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
    spines = textures.spots(look.rng, green, (236, 232, 200), 0.03)
    return [(pad, spines) for pad in pads], [hull_of(pad) for pad in pads]


def _blades(look: Look, green: RGB, h: float, r: float) -> tuple[Pieces, list[ConvexPart]]:
    """Return upright blades with pale edges, or fine grass."""
    fine = look.chance(0.35)
    edge = tint_color(green, 1.4) if fine else look.pick([(222, 206, 110), tint_color(green, 1.5)])
    image = textures.stripes([edge, green, tint_color(green, 0.75), green, edge], 1, upright=True)
    section = np.array([(-1.0, 0.0), (0.0, -0.18), (1.0, 0.0), (0.0, 0.1)])
    blades: list[Solid] = []
    for k in range(34 if fine else 10):
        tall = look.between(0.07, 0.15) if fine else look.between(0.1, 0.18)
        wide = 0.003 if fine else look.between(0.009, 0.014)
        t = np.linspace(0, 1, 6)
        width = wide * np.clip(1.15 - t**2, 0.05, 1)
        out = (0.35 if fine else 0.12) * tall * t**2 + 0.25 * r
        rings = np.stack(
            [
                np.column_stack([x + section[:, 1] * w, section[:, 0] * w, np.full(4, z)])
                for x, w, z in zip(out, width, 0.86 * h + tall * t, strict=True)
            ]
        )
        blade = loft(rings, section, profile=np.column_stack([out, tall * t]))
        blades.append(blade.turn(2, 2.4 * k + look.between(-0.3, 0.3)))
    tuft = join(blades)
    return [(tuft, image)], [hull_of(tuft)]


def _bonsai(look: Look, green: RGB, h: float, r: float) -> tuple[Pieces, list[ConvexPart]]:
    """Return a bent trunk with clouds of leaves."""
    z, lean = 0.86 * h, look.between(-0.02, 0.02)
    path = smooth(
        [(0, 0, z), (0.016 + lean, 0.004, z + 0.035), (lean - 0.012, 0, z + 0.07),
         (lean, 0, z + 0.1)], 4,
    )  # fmt: skip
    trunk = tube(path, np.linspace(0.009, 0.004, len(path)), 10)
    bark = textures.scratches(look.rng, (110, 80, 56), (70, 50, 36), 70)
    needles = textures.spots(look.rng, green, tint_color(green, 1.35), 0.3)

    def knobbly(p: np.ndarray) -> np.ndarray:
        return p * (1 + 0.09 * np.sin(160 * p[:, :1]) * np.cos(190 * p[:, 1:2]))

    clouds = []
    for k in range(5):
        wide = look.between(0.045, 0.075)
        puff = ellipsoid(wide, 0.9 * wide, 0.5 * wide, 12, 7).bend(knobbly)
        out = 0.0 if k == 0 else look.between(0.02, 0.04)
        at = (lean + out * np.cos(2.4 * k), out * np.sin(2.4 * k), z + 0.1 - 0.009 * k)
        clouds.append(puff.move(*at))
    crown = join(clouds)
    return [(trunk, bark), (crown, needles)], [hull_of(trunk), hull_of(crown)]


def seedling(look: Look) -> Shape:
    """A seedling with the soil around its roots, out of its pot."""
    r, h, tall = look.between(0.019, 0.024), look.between(0.03, 0.036), look.between(0.085, 0.105)
    soil = cylinder(r, h, 14, top=1.15 * r, bevel=0.002)
    stem = tube([(0, 0, h - 0.004), (0.002, 0, 0.6 * tall), (0, 0, 0.9 * tall)], 0.0022, 7)
    leaves = [leaf_blade(0.036 + 0.006 * (k % 2), 0.018, 2.4 * k, 0.75 - 0.15 * (k // 2))
              .move(z=(0.9 - 0.12 * (k // 2)) * tall) for k in range(6)]  # fmt: skip
    green = look.own_color("green", "lime", "olive")
    earth = textures.spots(look.rng, (84, 60, 44), (52, 38, 28), 0.3)
    return shape([(soil, earth), (stem, textures.plain(tint_color(green, 0.8))),
                  (join(leaves), textures.speckles(look.rng, green, 8))],
                 [hull_of(soil), hull_of(stem)])  # fmt: skip


def bare_cactus(look: Look) -> Shape:
    """A ribbed cactus with the soil around its roots, out of its pot."""
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
    earth = textures.spots(look.rng, (84, 60, 44), (52, 38, 28), 0.3)
    return shape([(soil, earth), (body, textures.speckles(look.rng, green, 8))],
                 [hull_of(soil), hull_of(body)])  # fmt: skip


CATEGORIES = (
    Category(
        "bare_cactus", bare_cactus, (0.045, 0.045, 0.12), 0.08, (), ("living",), (), ("green",)
    ),
    Category(
        "seedling",
        seedling,
        (0.065, 0.058, 0.105),
        0.04,
        ("plant seedling", "plug plant", "young plant"),
        ("living",),
        (),
        ("green",),
    ),
    Category(
        "potted_plant",
        potted_plant,
        (0.17, 0.17, 0.185),
        0.6,
        ("plant", "houseplant", "flower pot", "pot plant"),
        ("office", "living", "coffee"),
        ("tall",),
        ("terracotta", "white"),
    ),
)
