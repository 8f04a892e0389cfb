"""Objects of the ``living`` theme: instruments."""

from __future__ import annotations

import itertools
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from ...kit import surfaces
from ...kit.materials import dye, metal, plastic, shine, wood
from ...kit.outlines import arc, rectangle, smooth
from ...kit.parts import hull_of, hull_part
from ...kit.primitives import (
    at_block,
    at_box,
    ball,
    disc,
    facing,
    limb,
    plate,
    rod,
    spindle,
    standing,
    straight,
)
from ...kit.shapes import (
    Category,
    Drawing,
    Pieces,
    Shape,
    at_rest,
    category,
    from_pieces,
    settle,
    shape,
)
from ...kit.solids import (
    Solid,
    block,
    box,
    cylinder,
    ellipsoid,
    join,
    lathe,
    loft,
    prism,
    torus,
    tube,
)
from ...kit.surfaces import RGB, Look, tint_color
from ...values import ConvexPart


@category("kazoo", size=(0.119, 0.0285, 0.0256), mass=0.015, material="metal",
          aliases=("kazoo toy", "toy kazoo", "metal kazoo"), themes=("living",),
          colors=("red", "blue"), state="lying flat")  # fmt: skip
def kazoo(look: Look) -> Shape:
    """A kazoo lying flat: a flattened tube with a round turret."""
    k = look.between(0.94, 1.08)
    color = look.color("red", "blue", "yellow", "silver", "green", "gold")
    body = limb([(-0.06, 0, 0), (-0.02, 0, 0), (0.03, 0, 0), (0.06, 0, 0)],
                [0.013, 0.0145, 0.013, 0.008], 16, squash=0.75)  # fmt: skip
    turret = cylinder(0.011, 0.012, 22, bevel=0.001).move(0.0, 0, 0.006)
    cap = cylinder(0.0075, 0.001, 18).move(0.0, 0, 0.0178)
    end = cylinder(0.0085, 0.001, 16).turn(1, np.pi / 2).scale(1, 1, 0.75).move(x=-0.0608)
    return settle([(join([body, turret]), look.surface(color, "plastic")),
                   (join([cap, end]), surfaces.plain(tint_color(color, 0.45)))],
                  0.12).scale(k)  # fmt: skip


DARK: RGB = (38, 36, 38)
STRING = (206, 208, 212)


def _waist_outline(half: list[tuple[float, float]], k: float) -> np.ndarray:
    """Return a closed outline along x; ``half`` lists the points (x, half width) of one side."""
    curve = smooth(half, 4)
    lower = curve * [1, -1]
    upper = curve[::-1]
    return np.concatenate([lower, upper[1:-1]]) * k


def _slabs(outline: np.ndarray, low: float, high: float, cuts: list[float]) -> list[ConvexPart]:
    """Return the convex parts of a plate with the given outline, cut at the x values ``cuts``."""
    found = []
    for a, b in itertools.pairwise(cuts):
        inside = outline[(outline[:, 0] >= a - 1e-9) & (outline[:, 0] <= b + 1e-9)]
        points = [np.column_stack([inside, np.full(len(inside), z)]) for z in (low, high)]
        found.append(hull_part(np.concatenate(points)))
    return found


def _wood_face(look: Look, color: RGB) -> surfaces.Tile:
    """Return a texture of varnished wood that is darker towards its edges."""
    image = surfaces.fit(surfaces.wood(look.rng, color), 128, 128).astype(float)
    v, u = np.mgrid[0:128, 0:128] / 63.5 - 1
    shade = 1 - 0.35 * np.clip(np.abs(v) ** 3 + np.abs(u) ** 6, 0, 1)
    return np.clip(image * shade[..., None], 0, 255).astype(np.uint8)


@category("violin", size=(0.53, 0.195, 0.07), mass=0.42, material="wood", hollow=True,
          aliases=("fiddle", "viola"), themes=("living",), roles=("big",), colors=("bronze",),
          state="lying flat")  # fmt: skip
def violin(look: Look) -> Shape:
    """A violin lying on its back with its neck on the right, sometimes with a bow beside it."""
    k = look.between(0.86, 1.0)
    color = look.color("bronze", "copper", "terracotta", "brown", "maroon")
    varnish, side = _wood_face(look, color), surfaces.wood(look.rng, tint_color(color, 0.8))
    half = [(-0.178, 0.0), (-0.172, 0.05), (-0.12, 0.104), (-0.05, 0.088), (-0.012, 0.058),
            (0.03, 0.056), (0.062, 0.08), (0.12, 0.084), (0.168, 0.04), (0.176, 0.0)]  # fmt: skip
    outline = _waist_outline(half, k)
    ribs = prism(outline * 0.97, 0.0, 0.036 * k)
    belly = prism(outline, 0.035 * k, 0.041 * k)
    arch = loft(np.stack([np.column_stack([outline * s, np.full(len(outline), z * k)]) for s,
                          z in ((0.86, 0.0405), (0.7, 0.047), (0.4, 0.051))]), outline)  # fmt: skip
    dark = surfaces.speckles(look.rng, DARK, 4)
    board = loft(np.stack([np.column_stack([np.full(4, x * k), rectangle(w * k, 0.006 * k)[:, 0],
                                            z * k + rectangle(w * k, 0.006 * k)[:, 1]])
                           for x, w, z in ((0.0, 0.04, 0.066), (0.29, 0.025, 0.05))]),
                 rectangle(1, 1))  # fmt: skip
    neck = tube([(0.165 * k, 0, 0.035 * k), (0.3 * k, 0, 0.042 * k)], 0.011 * k, 10)
    scroll = [
        block(0.075 * k, 0.024 * k, 0.022 * k, 0.006).move(0.325 * k, 0, 0.028 * k),
        facing(cylinder(0.0165 * k, 0.03 * k, 18)).move(0.372 * k, 0.015 * k, 0.035 * k),
    ]
    pegs = [cylinder(0.0035 * k, 0.066 * k, 8, top=0.006 * k).turn(0, s * np.pi / 2)
            .move((0.31 + 0.016 * n) * k, 0.02 * k * s, 0.04 * k)
            for n, s in enumerate((-1, 1, -1, 1))]  # fmt: skip
    tail = loft(np.stack([np.column_stack([np.full(4, x * k), rectangle(w * k, 0.006 * k)[:, 0],
                                           z * k + rectangle(w * k, 0.006 * k)[:, 1]])
                          for x, w, z in ((-0.165, 0.02, 0.05), (-0.06, 0.042, 0.062))]),
                rectangle(1, 1))  # fmt: skip
    rest = ellipsoid(0.07 * k, 0.1 * k, 0.022 * k, 18, 8).move(-0.135 * k, 0.055 * k, 0.048 * k)
    bridge = box(0.004 * k, 0.044 * k, 0.028 * k).move(-0.025 * k, 0, 0.046 * k)
    strings = [tube([(-0.06 * k, y * k, 0.066 * k), (-0.025 * k, 1.1 * y * k, 0.075 * k),
                     (0.29 * k, 0.6 * y * k, 0.055 * k)], 0.0006, 4)
               for y in (-0.015, -0.005, 0.005, 0.015)]  # fmt: skip
    curve = [(-0.055, -0.049), (-0.035, -0.044), (-0.01, -0.051), (0.008, -0.043),
             (0.008, -0.039), (-0.01, -0.047), (-0.035, -0.04), (-0.055, -0.045)]  # fmt: skip
    slot = prism(np.array(curve) * k, 0.04 * k, 0.0458 * k)
    mirrored = Solid(slot.vertices * [1, -1, 1], slot.faces[:, ::-1], slot.uv)
    pieces = [(ribs, side), (join([belly]), varnish), (arch, varnish),
              (join([board, *pegs, tail, rest]), dark),
              (join([neck, *scroll]), side), (bridge, surfaces.plain((222, 190, 130))),
              (join(strings), surfaces.plain(STRING)),
              (join([slot, mirrored]), surfaces.plain((40, 24, 18)))]  # fmt: skip
    cuts = [-0.18 * k, -0.05 * k, 0.0, 0.05 * k, 0.18 * k]
    parts = [*_slabs(outline, 0.0, 0.041 * k, cuts), hull_of(arch), hull_of(board), hull_of(neck),
             hull_of(*scroll), hull_of(tail), hull_of(rest)]  # fmt: skip
    return shape(pieces, parts)


@category("ukulele", size=(0.448, 0.175, 0.0718), mass=0.45, material="wood", hollow=True,
          aliases=("uke",), themes=("living",), roles=("big",), colors=("wooden",),
          state="lying flat")  # fmt: skip
def ukulele(look: Look) -> Shape:
    """A ukulele or small guitar lying on its back with its neck on the right."""
    k = look.between(0.82, 1.1)
    color = look.color("wooden", "tan", "bronze", "teal", "red", "sky", "brown", "yellow", "pink")
    wood = surfaces.wood(look.rng, color)
    face = _wood_face(look, color)
    half = [(-0.13, 0.0), (-0.126, 0.042), (-0.08, 0.088), (-0.025, 0.074), (0.015, 0.052),
            (0.055, 0.064), (0.09, 0.054), (0.112, 0.024), (0.114, 0.0)]  # fmt: skip
    outline = _waist_outline(half, k)
    body = prism(outline, 0, 0.055 * k)
    top = prism(outline * 0.985, 0.054 * k, 0.057 * k)
    hole = cylinder(0.027 * k, 0.001, 28).move(x=0.018 * k, z=0.0568 * k)
    ring = torus(0.03 * k, 0.0016, 28, 6).move(x=0.018 * k, z=0.0568 * k)
    dark = surfaces.wood(look.rng, (74, 50, 38))
    board = box(0.21 * k, 0.034 * k, 0.006 * k).move(x=0.15 * k, z=0.057 * k)
    neck = tube([(0.1 * k, 0, 0.05 * k), (0.255 * k, 0, 0.05 * k)], 0.016 * k, 10, squash=0.6)
    frets = [box(0.0014, 0.034 * k, 0.0012).move(x=(0.06 + 0.021 * n) * k, z=0.0628 * k)
             for n in range(9)]  # fmt: skip
    head = prism(np.array([(0.25, -0.018), (0.31, -0.026), (0.325, 0.0), (0.31, 0.026),
                           (0.25, 0.018)]) * k, 0.048 * k, 0.06 * k)  # fmt: skip
    pegs = [cylinder(0.004 * k, 0.014 * k, 10).move((0.272 + 0.024 * n) * k, s * 0.014 * k, 0.059
                                                    * k) for n in (0, 1)
            for s in (-1, 1)]  # fmt: skip
    keys = [ellipsoid(0.012 * k, 0.014 * k, 0.006 * k, 8, 5).move((0.272 + 0.024 * n) * k,
                                                                   s * 0.031 * k, 0.054 * k)
            for n in (0, 1) for s in (-1, 1)]  # fmt: skip
    bridge = box(0.018 * k, 0.06 * k, 0.008 * k).move(x=-0.062 * k, z=0.057 * k)
    strings = [tube([(-0.062 * k, y * k, 0.066 * k), (0.26 * k, 0.8 * y * k, 0.066 * k)], 0.0007, 4)
               for y in (-0.012, -0.004, 0.004, 0.012)]  # fmt: skip
    cuts = [-0.14 * k, -0.06 * k, 0.015 * k, 0.115 * k]
    return shape(
        [(join([body, neck, head]), wood), (top, face), (hole, surfaces.plain((30, 24, 22))),
         (join([ring, board, bridge]), dark),
         (join([*frets, *pegs, *keys]), surfaces.plain((206, 206, 204))),
         (join(strings), surfaces.plain((240, 240, 236)))],
        [*_slabs(outline, 0.0, 0.057 * k, cuts), hull_of(board, neck), hull_of(head)],
    )  # fmt: skip


@category("cowbell", size=(0.075, 0.044, 0.135), mass=0.3, material="metal",
          aliases=("cow bell", "agogo bell"), themes=("living",), colors=("black",))  # fmt: skip
@from_pieces()
def cowbell(look: Look) -> Pieces:
    """A four-sided metal cowbell standing on its mouth, with a loop on top."""
    tile = metal(look, "black", "silver", "copper", "brass")
    body = at_box(0.06, 0.035, 0.11).bend(
        lambda p: p * np.column_stack([1.25 - 4.5 * p[:, 2], 1.25 - 4.5 * p[:, 2],
             np.ones(len(p))]))  # fmt: skip
    loop = torus(0.014, 0.003, 20, 6).turn(0, np.pi / 2).move(z=0.118)
    return [(body, tile), (loop, tile)]


@category("castanets", size=(0.0621, 0.0908, 0.0402), mass=0.05, material="wood",
          aliases=("castanet", "pair of castanets"), themes=("living",), colors=("black",),
          state="lying")  # fmt: skip
@from_pieces(foot=0.04, bodies=2)
def castanets(look: Look) -> Pieces:
    """Two slightly open wooden shells, one on top of the other, with a red cord."""
    tile = wood(look, "black", "brown", "maroon", "wooden")
    shells = [ball(0.062, 0.07, 0.026, (0, 0, 0.01), 20),
              ball(0.062, 0.07, 0.02, (0, 0, 0), 20).turn(0, 0.22).move(z=0.028)]  # fmt: skip
    cord = rod([(-0.012, 0.036, 0.016), (0, 0.05, 0.012), (0.014, 0.036, 0.02),
                (0.03, 0.055, 0.003)], 0.0018, 6)  # fmt: skip
    return [(shells[0], tile), (shells[1], tile), (cord, dye(look, "red"))]


@category("gong", size=(0.25, 0.09, 0.222), mass=0.9, material="metal", hollow=True,
          aliases=("table gong", "desk gong", "tam tam", "dinner gong"), themes=("living",),
          roles=("tall",), colors=("bronze",))  # fmt: skip
@from_pieces()
def gong(look: Look) -> Pieces:
    """A bronze gong in a wooden frame, with its beater leaning on it."""
    bronze = metal(look, "bronze", "brass", "gold")
    tile = wood(look, "brown", "black", "maroon")
    feet = [at_block(0.02, 0.09, 0.014, 0.004, (s * 0.1, 0, 0)) for s in (-1, 1)]
    posts = [at_box(0.014, 0.014, 0.2, (s * 0.1, 0, 0.012)) for s in (-1, 1)]
    beam = at_box(0.25, 0.016, 0.014, (0, 0, 0.208))
    low = at_box(0.19, 0.012, 0.012, (0, 0, 0.016))
    plate = standing(
        (0.07, 0), (0.075, 0.004), (0.078, 0.012), (0.02, 0.014), (0.018, 0.02), sides=36
    )
    plate = plate.turn(0, np.pi / 2).move(0, 0.006, 0.12)
    cords = [straight((s * 0.03, 0, 0.185), (s * 0.03, 0, 0.21), 0.0018, 6) for s in (-1, 1)]
    return [*((s, tile) for s in (*feet, *posts, beam, low)), (plate, bronze),
            (join(cords), dye(look, "red", "cream"))]  # fmt: skip


@category("kalimba", size=(0.13, 0.175, 0.047), mass=0.35, material="wood",
          aliases=("thumb piano", "mbira"), themes=("living",), roles=("flat",),
          colors=("wooden",))  # fmt: skip
@from_pieces(bodies=1)
def kalimba(look: Look) -> Pieces:
    """A thumb piano: a wooden box with metal tongues over a hole."""
    tile = wood(look, "wooden", "brown", "tan", "maroon")
    body = at_block(0.13, 0.175, 0.034, 0.02)
    hole = disc(0.014, 0.001, (0, -0.03, 0.0336))
    tines = []
    for k in range(17):
        x = 0.0066 * (k - 8)
        long = 0.095 - 0.0048 * abs(k - 8)
        tines.append(at_box(0.0048, long, 0.0014, (x, 0.07 - long / 2, 0.04)))
    bars = [straight((-0.06, y, z), (0.06, y, z), 0.0035, 8) for y,
            z in ((0.052, 0.0375), (0.04, 0.0425), (0.03, 0.0375))]  # fmt: skip
    return [(body, tile), (join(tines), shine(look)), (join(bars), shine(look, "gold", "silver")),
            (hole, surfaces.plain((30, 24, 20)))]  # fmt: skip


def _bellows(sides: int | None, wide: float) -> Drawing:
    """Return the drawing function of an accordion, or of a concertina with polygonal ends."""

    def draw(look: Look) -> Pieces:
        shell = plastic(look, "red", "black", "maroon", "navy", "white")
        pieces: Pieces = []
        if sides is None:
            ends = [at_block(0.055, 0.13, wide, 0.012, (s * 0.1, 0, 0)) for s in (-1, 1)]
            folds = [at_box(0.007, 0.115 + 0.012 * (k % 2), wide - 0.02 + 0.012 * (k % 2),
                            (0.0075 * (k - 9), 0, 0.004)) for k in range(19)]  # fmt: skip
            pieces = [(e, shell) for e in ends]
            board = at_box(0.04, 0.022, 0.24 if wide > 0.2 else 0.9 * wide, (0.095, -0.072, 0.005))
            keys = [at_box(0.026, 0.004, 0.0105, (0.1, -0.0845, 0.012 + 0.0125 * k))
                    for k in range(int(0.86 * wide / 0.0125))]  # fmt: skip
            dots = [ball(0.007, 0.007, 0.007, (-0.128, -0.04 + 0.016 * n, 0.03 + 0.02 * k), 8)
                    for k in range(int(wide / 0.024)) for n in range(5)]  # fmt: skip
            pieces += [(board, shell), (join(keys), surfaces.plain((244, 242, 236))),
                       (join(dots), surfaces.plain((236, 234, 228)))]  # fmt: skip
        else:
            ends = [lathe([(0, 0), (wide, 0), (wide, 0.03), (0, 0.03)], sides).turn(1, np.pi / 2)
                    .move(x=x) for x in (-0.095, 0.065)]  # fmt: skip
            folds = [lathe([(0, 0), (r, 0), (r, 0.007), (0, 0.007)], sides).turn(1, np.pi / 2)
                     .move(x=-0.066 + 0.0073 * k) for k in range(18)
                     for r in ((0.92 - 0.09 * (k % 2)) * wide,)]  # fmt: skip
            dots = [ball(0.006, 0.006, 0.006, (s * 0.096, y, z), 8) for s in (-1, 1)
                    for y in (-0.018, 0, 0.018) for z in (-0.018, 0, 0.018)]  # fmt: skip
            straps = [torus(0.03, 0.004, 18, 6).turn(0, np.pi / 2).scale(0.6, 1, 1).move(s * 0.1,
             0, 0)
                      for s in (-1, 1)]  # fmt: skip
            low = min(float(e.bounds[0, 2]) for e in ends)
            ends, folds, dots, straps = (
                [s.move(z=-low) for s in g] for g in (ends, folds, dots, straps)
            )
            pieces = [(e, wood(look, "brown", "maroon", "black")) for e in ends]
            pieces += [(join(dots), surfaces.plain((236, 234, 228)))]
            del straps
        mid = len(folds) // 2
        return ([*pieces[:2], (join(folds), dye(look, "black", "red", "charcoal")), *pieces[2:]]
                if mid else pieces)  # fmt: skip

    return draw


@category("melodica", size=(0.39, 0.075, 0.043), mass=0.6, material="plastic",
          aliases=("key harmonica", "pianica", "blow organ"), themes=("living",),
          roles=("flat", "big"), colors=("sky", "red"))  # fmt: skip
@from_pieces(bodies=2)
def melodica(look: Look) -> Pieces:
    """A rounded melodica with white and black keys on top and a mouthpiece on the left."""
    tile = plastic(look, "sky", "red", "pink", "black", "green")
    body = at_block(0.34, 0.075, 0.035, 0.015)
    keys = [at_box(0.0135, 0.05, 0.006, (-0.14 + 0.0148 * k, -0.012, 0.034)) for k in range(19)]
    dark = [at_box(0.008, 0.03, 0.004, (-0.1326 + 0.0148 * k, -0.002, 0.039)) for k in range(18)
            if k % 7 not in (2, 6)]  # fmt: skip
    mouth = rod(
        [(-0.165, 0.01, 0.02), (-0.19, 0.01, 0.02), (-0.21, 0.01, 0.022)], [0.009, 0.006, 0.008]
    )
    return [(body, tile), (mouth, tile), (join(keys), surfaces.plain((246, 244, 238))),
            (join(dark), surfaces.plain((30, 30, 32)))]  # fmt: skip


@category("bagpipes", size=(0.42, 0.44, 0.095), mass=1.2, material="fabric", assembled=True,
          aliases=("bagpipe", "set of bagpipes", "highland pipes"), themes=("living",),
          roles=("big",), colors=("red", "green"), state="lying")  # fmt: skip
@from_pieces(foot=0.05)
def bagpipes(look: Look) -> Pieces:
    """A tartan bag with three drones and a chanter, lying flat."""
    bag = ball(0.26, 0.14, 0.1, (0, 0, 0.045), 24)
    a, b = look.color("red", "green", "navy", "maroon"), look.own_color("navy", "green", "black")
    plaid = surfaces.fabric(look.rng, a, b)
    tile = wood(look, "black", "brown")
    white = surfaces.plain((238, 234, 224))
    drones = [rod([(0.02 + 0.03 * k, 0.05, 0.06), (0.05 + 0.05 * k, 0.15, 0.03), (0.08 + 0.07 * k,
             0.28 - 0.05 * k, 0.012)],
                  [0.008, 0.0085, 0.01], 10) for k in range(3)]  # fmt: skip
    tips = [
        ball(0.026, 0.026, 0.022, (0.08 + 0.07 * k, 0.28 - 0.05 * k, 0.013), 12) for k in range(3)
    ]
    pipe = rod(
        [(-0.11, 0, 0.05), (-0.16, -0.06, 0.02), (-0.2, -0.15, 0.01)], [0.008, 0.007, 0.011], 10
    )
    blow = rod(
        [(-0.04, 0.05, 0.07), (-0.09, 0.12, 0.04), (-0.12, 0.17, 0.012)], [0.008, 0.007, 0.006], 10
    )
    return [(bag, plaid), (join([pipe]), tile), (join([blow]), tile), *((d, tile) for d in drones),
            (join(tips), white)]  # fmt: skip


@category("didgeridoo", size=(0.6, 0.066, 0.064), mass=1.2, material="wood", aliases=("didjeridu",),
          themes=("living",), roles=("big",), colors=("brown",), state="lying")  # fmt: skip
@at_rest
@from_pieces(foot=0.08, bodies=1)
def didgeridoo(look: Look) -> Pieces:
    """A didgeridoo lying flat: a long tube with painted bands, flared at its right end."""
    color = look.color("brown", "terracotta", "wooden")
    bands = surfaces.stripes(
        [color, (226, 206, 160), color, color, (70, 36, 26), color, (196, 120, 60)], 3
    )
    body = spindle((-0.3, 0.014), (-0.29, 0.017), (0.0, 0.019), (0.2, 0.024), (0.3, 0.033), z=0.031)
    return [(body, bands), (spindle((0.2995, 0.026), (0.3006, 0.026), z=0.031),
                            surfaces.plain((30, 22, 18)))]  # fmt: skip


@category("vuvuzela", size=(0.53, 0.104, 0.102), mass=0.12, material="plastic",
          aliases=("stadium horn", "fan horn", "bugle toy"), themes=("living",), roles=("big",),
          colors=("red", "yellow"), state="lying")  # fmt: skip
@at_rest
@from_pieces(foot=0.06, bodies=1)
def vuvuzela(look: Look) -> Pieces:
    """A long plastic horn lying flat with its mouthpiece on the left and its bell on the right."""
    tile = plastic(look, "red", "yellow", "green", "blue", "orange")
    horn = spindle((-0.26, 0.012), (-0.25, 0.008), (-0.1, 0.011), (0.12, 0.02), (0.22, 0.034),
                  (0.27, 0.052), z=0.05)  # fmt: skip
    return [(horn, tile), (spindle((0.2695, 0.046), (0.2705, 0.046), z=0.05),
                           surfaces.plain((40, 36, 36)))]  # fmt: skip


@category("jaw_harp", size=(0.128, 0.0487, 0.0188), mass=0.03, material="metal",
          aliases=("jew harp", "mouth harp harp", "khomus"), themes=("living",), colors=("silver",),
          state="lying")  # fmt: skip
@from_pieces(foot=0.1)
def jaw_harp(look: Look) -> Pieces:
    """A jaw harp lying flat: a frame with two long arms, and a thin tongue with a bent tip."""
    tile = metal(look, "silver", "brass", "charcoal")
    way = [(0.06, 0.006), (0.0, 0.009), (-0.03, 0.02), (-0.05, 0.0), (-0.03, -0.02), (0.0, -0.009),
           (0.06, -0.006)]  # fmt: skip
    frame = tube([(*p, 0.004) for p in smooth(way, 6)], 0.004, 8)
    tongue = rod([(-0.048, 0, 0.004), (0.062, 0, 0.004), (0.066, 0, 0.018)], 0.0014, 6)
    return [(frame, tile), (tongue, tile)]


@category("theremin", size=(0.302, 0.124, 0.283), mass=1.5, material="device", assembled=True,
          themes=("living",), roles=("tall", "big"), colors=("brown",))  # fmt: skip
@from_pieces()
def theremin(look: Look) -> Pieces:
    """A theremin: a wooden case, four knobs, a loop on the left and an upright rod on the right."""
    tile = wood(look, "brown", "wooden", "black")
    body = at_block(0.22, 0.11, 0.06, 0.012)
    rodded = straight((0.095, 0, 0.055), (0.095, 0, 0.28), 0.0035, 8)
    path = [(-0.1, -0.03, 0.045), (-0.15, -0.03, 0.045), (-0.185, 0.0, 0.045), (-0.15, 0.03, 0.045),
            (-0.1, 0.03, 0.045)]  # fmt: skip
    loop = rod(path, 0.0035, 8, 5)
    knobs = [disc(0.009, 0.012).turn(0, np.pi / 2).move(x, -0.056, 0.03)
             for x in (-0.06, -0.02, 0.02, 0.06)]  # fmt: skip
    return [(body, tile), (rodded, shine(look)), (loop, shine(look)),
            (join(knobs), dye(look, "black"))]  # fmt: skip


CREAM = surfaces.plain((236, 226, 200))


@dataclass(frozen=True)
class Lute:
    """The dimensions of a plucked string instrument, in metres.

    Attributes:
        body: points (x, half width) of the body's outline from the tail to the neck.
        neck: length of the neck.
        wide: width of the neck.
        head: length of the head.
        strings: number of strings.
        deep: depth of the body.
        face: colours of the face; if empty, the face has the colour of the back.
        hole: radius of the sound hole; 0 for none.
        round_back: whether the back bulges like half a pear.
    """

    body: tuple[tuple[float, float], ...]
    neck: float
    wide: float
    head: float
    strings: int
    deep: float = 0.04
    face: tuple[str, ...] = ("tan", "beige")
    hole: float = 0.02
    round_back: bool = False


def _outline(points: tuple[tuple[float, float], ...]) -> np.ndarray:
    upper = smooth(points, 6)
    upper[:, 1] = np.maximum(upper[:, 1], 0.004)
    return np.concatenate([upper * [1, -1], upper[::-1]])


def _strings(lute: Lute, z: float, start: float, end: float) -> Solid:
    n = lute.strings
    rows = (np.arange(n) / max(n - 1, 1) - 0.5) * 0.75 * lute.wide
    return join([tube([(start, 1.3 * y, z), (end, y, z)], 0.0007, 4) for y in rows])


def _plucked_strings(lute: Lute, back: tuple[str, ...]) -> Drawing:
    def draw(look: Look) -> Pieces:
        skin = wood(look, *back)
        front = dye(look, *lute.face) if lute.face else skin
        outline = _outline(lute.body)
        tail, top = lute.body[0][0], lute.body[-1][0]
        if lute.round_back:
            wide = max(w for _, w in lute.body)
            flat = plate(outline, 0.006, lute.deep - 0.006)
            bowl = ball(0.94 * (top - tail), 1.9 * wide, 2 * lute.deep - 0.012,
                        ((top + tail) / 2, 0, lute.deep - 0.006), 20)  # fmt: skip
            bowl = bowl.bend(lambda p: np.column_stack(
                [p[:, :2], np.minimum(p[:, 2], lute.deep - 0.004)]))  # fmt: skip
            pieces: Pieces = [(bowl, skin), (flat, front)]
        else:
            pieces = [(plate(outline, lute.deep), skin),
                      (plate(0.97 * outline + [0.015 * (top + tail), 0], 0.0012,
             lute.deep - 0.0004),
                       front)]  # fmt: skip
        z = lute.deep
        end = top + lute.neck
        neck = at_box(
            lute.neck + 0.03, lute.wide, 0.014, (top + lute.neck / 2 - 0.015, 0, z - 0.01)
        )
        board = at_box(lute.neck + 0.05, lute.wide, 0.004,
                       (top + lute.neck / 2 - 0.025, 0, z + 0.002))  # fmt: skip
        frets = [at_box(0.0014, lute.wide, 0.0012, (top + lute.neck * f, 0, z + 0.0055))
                 for f in np.linspace(0.05, 0.95, 9)]  # fmt: skip
        head = plate([(end - 0.002, -0.5 * lute.wide), (end + lute.head, -0.8 * lute.wide),
                      (end + lute.head, 0.8 * lute.wide), (end - 0.002, 0.5 * lute.wide)],
                     0.011, z - 0.009)  # fmt: skip
        pegs = [straight((end + lute.head * f, 0.5 * s * lute.wide, z - 0.003),
                         (end + lute.head * f, 1.25 * s * lute.wide, z - 0.003), 0.0032, 6)
                for f in np.linspace(0.25, 0.85, max(lute.strings // 2, 2)) for s in (-1,
             1)]  # fmt: skip
        middle = tail + 0.24 * (top - tail)
        bridge = at_box(0.01, 1.6 * lute.wide, 0.006, (middle, 0, z))
        dark = dye(look, "black", "brown")
        pieces += [(neck, skin), (head, skin), (board, dark), (bridge, dark),
                   (join(frets), shine(look)), (join(pegs), CREAM),
                   (_strings(lute, z + 0.0075, middle, end + 0.2 * lute.head),
                    surfaces.plain((226, 226, 222)))]  # fmt: skip
        if lute.hole:
            at = tail + 0.66 * (top - tail)
            pieces.append((disc(lute.hole, 0.0012, (at, 0, z)), surfaces.plain((30, 24, 20))))
        return pieces

    return draw


_PEAR = ((-0.13, 0.0), (-0.12, 0.05), (-0.06, 0.085), (0.0, 0.075), (0.06, 0.04), (0.1, 0.014))
_LUTE = ((-0.16, 0.0), (-0.145, 0.07), (-0.07, 0.115), (0.02, 0.1), (0.1, 0.05), (0.14, 0.018))
_GOURD = ((-0.1, 0.0), (-0.09, 0.05), (-0.04, 0.08), (0.02, 0.07), (0.07, 0.03), (0.1, 0.022))
_DOUBLE = ((-0.13, 0.0), (-0.125, 0.045), (-0.09, 0.085), (-0.03, 0.06), (0.03, 0.055),
           (0.08, 0.075), (0.115, 0.06), (0.08, 0.018))  # fmt: skip


@category("electric_guitar", size=(0.547, 0.171, 0.0343), mass=0.9, material="wood", assembled=True,
          aliases=("toy electric guitar", "mini electric guitar", "bass guitar", "electric bass",
          "stratocaster"), themes=("living",), roles=("big",), colors=("red", "black"),
          state="lying flat")  # fmt: skip
@from_pieces(bodies=4)
def electric_guitar(look: Look) -> Pieces:
    """A solid-body electric guitar with horns, pickups and knobs."""
    body = _DOUBLE
    lute = Lute(body, 0.26, 0.032, 0.075, 6, 0.026, (), 0.0)
    pieces = _plucked_strings(lute, ("red", "black", "sky", "white", "mustard", "teal"))(look)
    color = look.surface(look.color("red", "black", "sky", "white", "mustard", "teal"))
    pieces = [(s, color if k < 2 else t) for k, (s, t) in enumerate(pieces)]
    neck = dye(look, "wooden", "tan")
    pieces[2:4] = [(pieces[2][0], neck), (pieces[3][0], neck)]
    guard = plate(_outline(((-0.1, 0.0), (-0.08, 0.05), (-0.02, 0.036), (0.05, 0.035), (0.06,
             0.0))),
                  0.0012, 0.0262)  # fmt: skip
    pickups = [at_box(0.012, 0.045, 0.004, (x, 0, 0.0272)) for x in (-0.045, 0.0, 0.04)]
    knobs = [disc(0.006, 0.008, (x, -0.052, 0.026)) for x in (-0.075, -0.05)]
    return [*pieces, (guard, dye(look, "white", "black")), (join(pickups), dye(look, "black")),
            (join(knobs), dye(look, "silver", "black"))]  # fmt: skip


@category("banjo", size=(0.47, 0.192, 0.06), mass=0.9, material="wood", assembled=True,
          aliases=("small banjo",), themes=("living",), roles=("big",), colors=("brown",),
          state="lying flat")  # fmt: skip
@from_pieces(bodies=3)
def banjo(look: Look) -> Pieces:
    """A banjo: a drum with a skin and brackets, and a long neck."""
    lute = Lute(((-0.13, 0.0), (-0.12, 0.05), (-0.03, 0.05), (0.0, 0.0)), 0.26, 0.032, 0.07, 5,
                0.05, (), 0.0)  # fmt: skip
    parts = _plucked_strings(lute, ("brown", "wooden"))(look)
    skin = wood(look, "brown", "wooden", "maroon")
    rim = disc(0.092, 0.052, (-0.065, 0, 0), sides=36)
    head = disc(0.085, 0.0012, (-0.065, 0, 0.0516), sides=36)
    nuts = [disc(0.0035, 0.04, (-0.065 + 0.0945 * np.cos(a), 0.0945 * np.sin(a), 0.008), sides=8)
            for a in np.arange(16) * np.pi / 8]  # fmt: skip
    bridge = at_box(0.005, 0.045, 0.008, (-0.1, 0, 0.0525))
    return [(rim, skin), *parts[2:4], *parts[4:5], *parts[6:], (head, CREAM), (join(nuts),
             shine(look)),
            (bridge, dye(look, "tan"))]  # fmt: skip


@category("harp", size=(0.18, 0.07, 0.305), mass=0.8, material="wood", assembled=True,
          aliases=("lever harp", "mini harp", "celtic harp", "small harp", "toy harp"),
          themes=("living",), roles=("tall",), colors=("brown", "gold"))  # fmt: skip
@from_pieces()
def harp(look: Look) -> Pieces:
    """A small, upright harp with a sound box, a curved neck, a pillar and strings."""
    tile = wood(look, "brown", "wooden", "gold", "tan")
    base = at_box(0.12, 0.07, 0.016, (0.0, 0, 0))
    box = straight((-0.045, 0, 0.014), (0.085, 0, 0.22), (0.03, 0.014), 4)
    pillar = rod([(-0.05, 0, 0.012), (-0.075, 0, 0.14), (-0.07, 0, 0.285)], 0.009, 10)
    neck = rod([(-0.07, 0, 0.28), (-0.02, 0, 0.3), (0.03, 0, 0.25), (0.09, 0, 0.225)], 0.009, 10, 6)
    lines = []
    for k in range(12):
        t = (k + 0.5) / 12
        x = -0.06 + 0.13 * t
        low = 0.014 + 0.206 * (x + 0.045 + 0.02) / 0.13
        high = float(np.interp(x, [-0.07, -0.02, 0.03, 0.09], [0.285, 0.3, 0.25, 0.222]))
        if high > low + 0.01:
            lines.append(straight((x, 0, max(low, 0.016)), (x, 0, high), 0.0008, 4))
    return [(base, tile), (box, tile), (pillar, tile), (neck, tile),
            (join(lines), dye(look, "gold", "cream"))]  # fmt: skip


@category("lyre", size=(0.217, 0.169, 0.0354), mass=0.4, material="wood", assembled=True,
          aliases=("lyra", "kithara"), themes=("living",), roles=("big",), colors=("brown",),
          state="lying flat")  # fmt: skip
@from_pieces(foot=0.06)
def lyre(look: Look) -> Pieces:
    """A lyre lying flat: a bowl, two curved arms, a yoke and strings."""
    tile = wood(look, "brown", "wooden", "tan", "gold")
    bowl = plate(_outline(((-0.1, 0.0), (-0.095, 0.045), (-0.05, 0.065), (-0.02, 0.06), (0.0,
             0.0))),
                 0.03)  # fmt: skip
    arms = [rod([(-0.02, s * 0.05, 0.015), (0.03, s * 0.075, 0.015), (0.08, s * 0.06, 0.015),
                 (0.115, s * 0.07, 0.015)], 0.008, 10) for s in (-1, 1)]  # fmt: skip
    yoke = straight((0.105, -0.085, 0.022), (0.105, 0.085, 0.022), 0.006)
    lines = [tube([(-0.07, y, 0.034), (0.105, 1.6 * y, 0.029)], 0.0009, 4)
             for y in np.linspace(-0.02, 0.02, 7)]  # fmt: skip
    hole = disc(0.016, 0.001, (-0.035, 0, 0.0296))
    return [(bowl, tile), *((a, tile) for a in arms), (yoke, tile), (join(lines), CREAM),
            (hole, dye(look, "black")), (at_box(0.006, 0.05, 0.006, (-0.07, 0, 0.0295)), dye(look,
             "black"))]  # fmt: skip


@category("dulcimer", size=(0.34, 0.18, 0.042), mass=1.2, material="wood", aliases=("zither",
          "autoharp", "hammered dulcimer", "psaltery", "santoor", "guzheng", "koto"),
          themes=("living",), roles=("big",), colors=("wooden",), state="lying flat")  # fmt: skip
@from_pieces(bodies=1)
def dulcimer(look: Look) -> Pieces:
    """A dulcimer: a flat box with slanted ends and many strings."""
    tile = wood(look, "wooden", "brown", "tan")
    body = plate([(-0.17, -0.09), (0.17, -0.09), (0.11, 0.09), (-0.11, 0.09)], 0.035)
    lines = [tube([(-0.16 + 0.0033 * k, -0.08 + 0.0095 * k, 0.041),
                   (0.16 - 0.0033 * k, -0.08 + 0.0095 * k, 0.041)], 0.0008,
             4) for k in range(17)]  # fmt: skip
    rails = [
        straight((s * 0.15, -0.085, 0.037), (s * 0.1, 0.085, 0.037), 0.0045, 6) for s in (-1, 1)
    ]
    holes = [disc(0.02, 0.001, (x, 0.0, 0.0346)) for x in (-0.06, 0.06)]
    return [(body, tile), (join(lines), surfaces.plain((222, 222, 218))),
            (join(rails), dye(look, "brown", "black")), (join(holes), dye(look,
             "black"))]  # fmt: skip


def _lute(lute: Lute, *back: str) -> Callable[[Look], Shape]:
    draw = _plucked_strings(lute, back or ("brown", "wooden", "maroon"))
    return from_pieces(foot=0.06, bodies=4)(draw)


BRASSY = ("gold", "gold", "brass", "silver")


def _bell(x: float, y: float, z: float, r: float, long: float) -> Solid:
    """Return the flared bell of a brass instrument, starting at ``x`` and opening towards +x."""
    outer = [(0.0065, 0), (0.009, 0.5 * long), (0.4 * r, 0.8 * long), (r, long)]
    inner = [(0.96 * r, long), (0.36 * r, 0.8 * long), (0.006, 0.4 * long)]
    return lathe([*outer, *inner], 24, loop=True).turn(1, np.pi / 2).move(x, y, z)


@category("trombone", size=(0.561, 0.186, 0.107), mass=1.2, material="metal", assembled=True,
          aliases=("toy trombone",), themes=("living",), roles=("big",), colors=("gold",),
          state="lying flat")  # fmt: skip
@at_rest
@from_pieces(foot=0.0)
def trombone(look: Look) -> Pieces:
    """A trombone lying flat: a long slide, a curved tube and a wide bell."""
    tile = metal(look, *BRASSY)
    z, r = 0.055, 0.0055
    slide = [straight((-0.1, y, z), (0.34, y, z), r) for y in (-0.075, -0.03)]
    end = tube([(*p, z) for p in arc((0.34, -0.0525), 0.0225, -np.pi / 2, np.pi / 2, 10)], r, 8)
    bow = tube([(*p, z) for p in arc((-0.16, 0.01), 0.04, np.pi / 2, 1.5 * np.pi, 14)], 0.0075, 8)
    upper = straight((-0.16, 0.05, z), (0.03, 0.05, z), 0.0075)
    lower = straight((-0.16, -0.03, z), (-0.1, -0.03, z), 0.0075)
    bell = _bell(0.02, 0.05, z, 0.055, 0.14)
    braces = [straight((x, -0.075, z), (x, -0.03, z), 0.003) for x in (-0.06, 0.0)]
    more = [straight((-0.06, -0.03, z), (-0.06, 0.05, z), 0.003)]
    cup = spindle((-0.13, 0.011), (-0.122, 0.009), (-0.11, 0.005), (-0.095, 0.005), z=z).move(
        y=-0.075
    )
    return [(bell, tile), (join(slide), tile), (end, tile), (bow, tile), (join([upper, lower]),
             tile),
            (join([*braces, *more]), tile), (cup, shine(look))]  # fmt: skip


@category("french_horn", size=(0.303, 0.216, 0.139), mass=1.5, material="metal", assembled=True,
          aliases=("horn instrument", "orchestral horn", "post horn"), themes=("living",),
          roles=("big",), colors=("gold",), state="lying flat")  # fmt: skip
@at_rest
@from_pieces(foot=0.0)
def french_horn(look: Look) -> Pieces:
    """A French horn lying flat: tubes coiled into a ring with a broad bell."""
    tile = metal(look, *BRASSY)
    rings = [torus(r, 0.0065, 36, 8).move(0, 0, z) for r, z in ((0.085, 0.03), (0.072, 0.034),
                                                                (0.058, 0.03))]  # fmt: skip
    path = smooth([(-0.07, -0.05, 0.03), (0.0, -0.088, 0.034), (0.08, -0.07, 0.05),
                   (0.125, -0.03, 0.062)], 6)  # fmt: skip
    throat = tube(path, np.linspace(0.0075, 0.024, len(path)), 14)
    flare = lathe([(0.02, 0), (0.032, 0.035), (0.075, 0.06), (0.072, 0.06), (0.028, 0.034),
                   (0.016, 0.002)], 26, loop=True)  # fmt: skip
    flare = flare.turn(1, 1.25).turn(2, 0.65).move(0.108, -0.045, 0.062)
    keys = [disc(0.009, 0.04, (0.022 * k - 0.02, 0.02, 0.012)) for k in range(3)]
    levers = [at_box(0.01, 0.05, 0.003, (0.022 * k - 0.02, 0.045, 0.05)) for k in range(3)]
    pipe = rod(
        [(-0.08, 0.03, 0.034), (-0.1, 0.07, 0.036), (-0.085, 0.115, 0.036)], [0.006, 0.005, 0.004]
    )
    return [(join(rings), tile), (throat, tile), (flare, tile), (join(keys), tile),
            (join(levers), tile), (pipe, tile)]  # fmt: skip


@category("tuba", size=(0.205, 0.18, 0.287), mass=1.8, material="metal", assembled=True,
          aliases=("euphonium", "sousaphone", "baritone horn"), themes=("living",),
          roles=("tall", "big"), colors=("gold",))  # fmt: skip
@from_pieces(foot=0.0)
def tuba(look: Look) -> Pieces:
    """A tuba standing on its bell with its tubes wound around it."""
    tile = metal(look, *BRASSY)
    bell = lathe([(0.0, 0), (0.085, 0), (0.05, 0.03), (0.03, 0.08), (0.024, 0.2), (0, 0.2)], 28)
    loop = tube([(0.05 * np.cos(a) + 0.045, 0.0, 0.14 + 0.1 * np.sin(a))
                 for a in np.arange(36) * np.pi / 18], 0.014, 10, loop=True)  # fmt: skip
    small = tube([(0.03 * np.cos(a) + 0.045, 0.014, 0.14 + 0.07 * np.sin(a))
                  for a in np.arange(30) * np.pi / 15], 0.008, 8, loop=True)  # fmt: skip
    keys = [disc(0.009, 0.08, (0.03 + 0.022 * k, -0.018, 0.1)) for k in range(3)]
    cup = rod([(0.04, 0, 0.235), (0.02, -0.04, 0.26), (0.0, -0.07, 0.26)], [0.007, 0.006, 0.011])
    return [(bell, tile), (loop, tile), (small, tile), (join(keys), shine(look)), (cup, tile)]


@category("bassoon", size=(0.496, 0.105, 0.0397), mass=1.0, material="wood",
          aliases=("contrabassoon",), themes=("living",), roles=("big",), colors=("maroon",),
          state="lying flat")  # fmt: skip
@from_pieces(foot=0.08)
def bassoon(look: Look) -> Pieces:
    """A bassoon lying flat: a long double pipe with a thin, bent crook."""
    tile = wood(look, "maroon", "brown", "black")
    body = spindle((-0.27, 0.016), (-0.26, 0.02), (-0.1, 0.02), (-0.09, 0.014), (0.2, 0.0125),
                  (0.205, 0.017), (0.23, 0.017), z=0.02)  # fmt: skip
    second = spindle((-0.1, 0.011), (0.06, 0.01), z=0.02).move(y=0.025)
    crook = rod([(0.055, 0.025, 0.02), (0.09, 0.035, 0.025), (0.11, 0.06, 0.024), (0.1, 0.085,
             0.012)],
                [0.004, 0.0035, 0.003, 0.002], 8)  # fmt: skip
    keys = [disc(0.0075, 0.004, (x, y, 0.034)) for x, y in (
        (-0.2, 0), (-0.16, 0.004), (-0.12, 0), (-0.04, 0), (0.0, 0.003), (0.05, 0), (0.1, 0.002),
        (0.15, 0))]  # fmt: skip
    rods = [straight((-0.22, 0.014, 0.034), (-0.09, 0.014, 0.034), 0.002),
            straight((-0.06, 0.01, 0.031), (0.17, 0.01, 0.031), 0.002)]  # fmt: skip
    return [(body, tile), (second, tile), (crook, shine(look)), (join([*keys, *rods]), shine(look))]


@category("pan_pipes", size=(0.145, 0.17, 0.018), mass=0.12, material="wood",
          aliases=("panpipe", "pan flute", "panflute", "pan pipe", "syrinx"), themes=("living",),
          roles=("flat",), colors=("wooden",), state="lying")  # fmt: skip
@from_pieces(foot=0.08)
def pan_pipes(look: Look) -> Pieces:
    """Pan pipes lying flat: bound reeds of increasing length."""
    tile = wood(look, "wooden", "tan", "beige")
    pipes = []
    for k in range(9):
        long = 0.16 - 0.011 * k
        pipes.append(straight((0.0155 * (k - 4), 0.07 - long, 0.0078), (0.0155 * (k - 4), 0.07,
             0.0078),
                              0.0078, 10))  # fmt: skip
    bands = [at_box(0.145, 0.012, 0.018, (0, y, 0)) for y in (0.045, 0.012)]
    holes = [straight((0.0155 * (k - 4), 0.0698, 0.0078), (0.0155 * (k - 4), 0.0706, 0.0078),
             0.006, 10)
             for k in range(9)]  # fmt: skip
    return [(join(pipes), tile), (bands[0], dye(look, "brown", "red")),
            (bands[1], dye(look, "brown", "red")), (join(holes), surfaces.plain((40, 30,
             24)))]  # fmt: skip


@category("ocarina", size=(0.106, 0.0957, 0.0443), mass=0.2, material="ceramic",
          aliases=("clay ocarina",), themes=("living",), colors=("blue",),
          state="lying")  # fmt: skip
@from_pieces(foot=0.05, bodies=2)
def ocarina(look: Look) -> Pieces:
    """A glazed, egg-shaped ocarina lying flat: seven holes on top and a mouthpiece at the back."""
    color = look.color("blue", "teal", "terracotta", "brown", "green")
    tile = surfaces.gradient(tuple(0.75 * c for c in color), color, look.rng)  # type: ignore[arg-type]
    body = ball(0.11, 0.065, 0.045, (0, 0, 0.021), 22).bend(
        lambda p: p * np.column_stack([np.ones(len(p)), *(2 * [1 - 4 * p[:, 0]])]))  # fmt: skip
    mouth = at_block(0.028, 0.04, 0.016, 0.006, (-0.018, 0.045, 0.012))
    holes = [disc(0.0038, 0.002, (x, y, 0.0385 - abs(x) * 0.12)) for x, y in (
        (-0.03, -0.012), (-0.014, -0.016), (0.002, -0.013), (0.016, -0.009), (-0.03, 0.012),
        (-0.012, 0.013), (0.006, 0.008))]  # fmt: skip
    return [(body, tile), (mouth, tile), (join(holes), surfaces.plain((34, 26, 22)))]


CATEGORIES = (
    Category("accordion", from_pieces(bodies=4)(_bellows(None, 0.24)), size=(0.248, 0.145, 0.235),
             mass=2.5, material="plastic", assembled=True,
             aliases=("piano accordion", "squeezebox", "toy accordion", "button accordion"),
             themes=("living",), roles=("big",), colors=("red", "black")),
    Category("concertina", from_pieces(bodies=3)(_bellows(6, 0.07)), size=(0.198, 0.14, 0.122),
             mass=0.9, material="wood", assembled=True, aliases=("small accordion", "bandoneon"),
             themes=("living",), colors=("brown",)),
    Category("mandolin", _lute(Lute(_PEAR, 0.16, 0.03, 0.07, 8, 0.045)), size=(0.46, 0.17, 0.054),
             mass=0.6, material="wood", assembled=True, aliases=("bouzouki", "balalaika"),
             themes=("living",), roles=("big",), colors=("brown",), state="lying flat"),
    Category("lute", _lute(Lute(_LUTE, 0.15, 0.045, 0.08, 10, 0.08, round_back=True, hole=0.03)),
             size=(0.53, 0.23, 0.09), mass=0.8, material="wood", assembled=True,
             aliases=("oud", "theorbo", "medieval lute"), themes=("living",), roles=("big",),
             colors=("brown",), state="lying flat"),
    Category("sitar",
             at_rest(_lute(Lute(_GOURD, 0.34, 0.05, 0.09, 9, 0.08, ("tan", "brown"), 0.0, True))),
             size=(0.63, 0.16, 0.09), mass=0.9, material="wood", assembled=True,
             aliases=("tanpura", "shamisen", "erhu", "pipa"), themes=("living",), roles=("big",),
             colors=("brown",), state="lying flat"),
)  # fmt: skip
"""Objects that share their drawing functions."""
