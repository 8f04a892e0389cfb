"""Musical instruments, and instruments to look and find one's way with."""

from __future__ import annotations

import itertools

import numpy as np

from ....scene import ConvexPart
from ...build.category import Category
from ...build.collision import box_part, hull_of, hull_part
from ...build.forms import facing
from ...build.outlines import rectangle, smooth
from ...build.shape import Shape, shape
from ...build.solids import Solid, block, box, cylinder, ellipsoid, join, loft, prism, torus, tube
from ...surfaces import prints, textures
from ...surfaces.colors import RGB, tint_color
from ...surfaces.look import Look

DARK: RGB = (38, 36, 38)
STRING = (206, 208, 212)


def _waist_outline(half: list[tuple[float, float]], k: float) -> np.ndarray:
    """Return a closed outline along x from its side ``half`` (x, half width), left to right."""
    curve = smooth(half, 4)
    lower = curve * [1, -1]
    upper = curve[::-1]
    return np.concatenate([lower, upper[1:-1]]) * k


def _slabs(outline: np.ndarray, low: float, high: float, cuts: list[float]) -> list[ConvexPart]:
    """Return convex parts of a plate of an outline, cut across at the given x."""
    found = []
    for a, b in itertools.pairwise(cuts):
        inside = outline[(outline[:, 0] >= a - 1e-9) & (outline[:, 0] <= b + 1e-9)]
        points = [np.column_stack([inside, np.full(len(inside), z)]) for z in (low, high)]
        found.append(hull_part(np.concatenate(points)))
    return found


def _wood_face(look: Look, color: RGB) -> textures.Tile:
    """Return varnished wood that darkens towards its rim."""
    image = textures.fit(textures.wood(look.rng, color), 128, 128).astype(float)
    v, u = np.mgrid[0:128, 0:128] / 63.5 - 1
    shade = 1 - 0.35 * np.clip(np.abs(v) ** 3 + np.abs(u) ** 6, 0, 1)
    return np.clip(image * shade[..., None], 0, 255).astype(np.uint8)


def violin(look: Look) -> Shape:
    """A violin lying on its back, its neck to the right; some with a bow beside it."""
    k = look.between(0.86, 1.0)
    color = look.color("bronze", "copper", "terracotta", "brown", "maroon")
    varnish, side = _wood_face(look, color), textures.wood(look.rng, tint_color(color, 0.8))
    half = [(-0.178, 0.0), (-0.172, 0.05), (-0.12, 0.104), (-0.05, 0.088), (-0.012, 0.058),
            (0.03, 0.056), (0.062, 0.08), (0.12, 0.084), (0.168, 0.04), (0.176, 0.0)]  # fmt: skip
    outline = _waist_outline(half, k)
    ribs = prism(outline * 0.97, 0.0, 0.036 * k)
    belly = prism(outline, 0.035 * k, 0.041 * k)
    arch = loft(
        np.stack(
            [
                np.column_stack([outline * s, np.full(len(outline), z * k)])
                for s, z in ((0.86, 0.0405), (0.7, 0.047), (0.4, 0.051))
            ]
        ),
        outline,
    )
    dark = textures.speckles(look.rng, DARK, 4)
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
              (join([neck, *scroll]), side), (bridge, textures.plain((222, 190, 130))),
              (join(strings), textures.plain(STRING)),
              (join([slot, mirrored]), textures.plain((40, 24, 18)))]  # fmt: skip
    cuts = [-0.18 * k, -0.05 * k, 0.0, 0.05 * k, 0.18 * k]
    parts = [*_slabs(outline, 0.0, 0.041 * k, cuts), hull_of(arch), hull_of(board), hull_of(neck),
             hull_of(*scroll), hull_of(tail), hull_of(rest)]  # fmt: skip
    return shape(pieces, parts)


def ukulele(look: Look) -> Shape:
    """A ukulele or small guitar lying on its back, its neck to the right."""
    k = look.between(0.82, 1.1)
    color = look.color("wooden", "tan", "bronze", "teal", "red", "sky", "brown", "yellow", "pink")
    wood = textures.wood(look.rng, color)
    face = _wood_face(look, color)
    half = [(-0.13, 0.0), (-0.126, 0.042), (-0.08, 0.088), (-0.025, 0.074), (0.015, 0.052),
            (0.055, 0.064), (0.09, 0.054), (0.112, 0.024), (0.114, 0.0)]  # fmt: skip
    outline = _waist_outline(half, k)
    body = prism(outline, 0, 0.055 * k)
    top = prism(outline * 0.985, 0.054 * k, 0.057 * k)
    hole = cylinder(0.027 * k, 0.001, 28).move(x=0.018 * k, z=0.0568 * k)
    ring = torus(0.03 * k, 0.0016, 28, 6).move(x=0.018 * k, z=0.0568 * k)
    dark = textures.wood(look.rng, (74, 50, 38))
    board = box(0.21 * k, 0.034 * k, 0.006 * k).move(x=0.15 * k, z=0.057 * k)
    neck = tube([(0.1 * k, 0, 0.05 * k), (0.255 * k, 0, 0.05 * k)], 0.016 * k, 10, squash=0.6)
    frets = [box(0.0014, 0.034 * k, 0.0012).move(x=(0.06 + 0.021 * n) * k, z=0.0628 * k)
             for n in range(9)]  # fmt: skip
    head = prism(np.array([(0.25, -0.018), (0.31, -0.026), (0.325, 0.0), (0.31, 0.026),
                           (0.25, 0.018)]) * k, 0.048 * k, 0.06 * k)  # fmt: skip
    pegs = [
        cylinder(0.004 * k, 0.014 * k, 10).move((0.272 + 0.024 * n) * k, s * 0.014 * k, 0.059 * k)
        for n in (0, 1)
        for s in (-1, 1)
    ]
    keys = [ellipsoid(0.012 * k, 0.014 * k, 0.006 * k, 8, 5).move((0.272 + 0.024 * n) * k,
                                                                   s * 0.031 * k, 0.054 * k)
            for n in (0, 1) for s in (-1, 1)]  # fmt: skip
    bridge = box(0.018 * k, 0.06 * k, 0.008 * k).move(x=-0.062 * k, z=0.057 * k)
    strings = [tube([(-0.062 * k, y * k, 0.066 * k), (0.26 * k, 0.8 * y * k, 0.066 * k)], 0.0007, 4)
               for y in (-0.012, -0.004, 0.004, 0.012)]  # fmt: skip
    cuts = [-0.14 * k, -0.06 * k, 0.015 * k, 0.115 * k]
    return shape(
        [(join([body, neck, head]), wood), (top, face), (hole, textures.plain((30, 24, 22))),
         (join([ring, board, bridge]), dark),
         (join([*frets, *pegs, *keys]), textures.plain((206, 206, 204))),
         (join(strings), textures.plain((240, 240, 236)))],
        [*_slabs(outline, 0.0, 0.057 * k, cuts), hull_of(board, neck), hull_of(head)],
    )  # fmt: skip


def metronome(look: Look) -> Shape:
    """A pyramid metronome with a scale, its pendulum swung to one side."""
    k = look.between(0.9, 1.1)
    color = look.color("wooden", "brown", "black", "maroon", "red", "ivory", "teal")
    wood = look.surface(color, "wood")
    square = rectangle(1, 1)
    rings = [
        (0.115, 0, 0),
        (0.115, 0.014, 0),
        (0.105, 0.016, 0),
        (0.045, 0.2, 0.0),
        (0.04, 0.21, 0),
    ]
    body = loft(
        np.stack([np.column_stack([square * s * k, np.full(4, z * k)]) for s, z, _ in rings]),
        square,
    )
    lean = np.arctan2(0.03, 0.184)
    plate = prism(
        np.array([(-0.036, 0.0), (0.036, 0.0), (0.014, 0.145), (-0.014, 0.145)]) * k, 0, 0.002
    )
    plate = facing(plate).turn(0, -lean).move(y=-0.0475 * k, z=0.045 * k)
    scale = prints.canvas(96, 192, (238, 226, 190))
    for n in range(14):
        prints.fill(scale, 0.44 - 0.16 * (n % 2), 0.08 + 0.065 * n, 0.12 + 0.32 * (n % 2), 0.012,
                    (60, 44, 30))  # fmt: skip
        if n % 2 == 0:
            prints.write(scale, str(40 + 12 * n), 0.7, 0.09 + 0.065 * n, 0.035, (60, 44, 30))
    swing = look.pick([-1, 1]) * look.between(0.15, 0.4)
    rod = box(0.0025, 0.0016, 0.165 * k)
    weight = prism(
        np.array([(-0.009, 0), (0.009, 0), (0.006, 0.016), (-0.006, 0.016)]) * k, 0, 0.006
    )
    weight = facing(weight).move(y=0.003, z=look.between(0.07, 0.12) * k)
    arm = [s.turn(1, swing).turn(0, -lean).move(y=-0.053 * k, z=0.04 * k) for s in (rod, weight)]
    feet = [ellipsoid(0.014, 0.014, 0.01, 12, 6).move(sx * 0.045 * k, sy * 0.045 * k, 0.002)
            for sx in (-1, 1) for sy in (-1, 1)]  # fmt: skip
    key = [cylinder(0.003, 0.02, 8).turn(1, np.pi / 2).move(x=0.05 * k, z=0.05 * k),
           box(0.003, 0.022, 0.014).move(0.05 * k + 0.021, 0, 0.043 * k)]  # fmt: skip
    brass = textures.brushed_metal(look.rng, (200, 164, 84))
    up = 0.003
    pieces = [(body, wood), (plate, scale), (join([*arm, *key]), brass), (join(feet), wood)]
    raised = [(s.move(z=up), t) for s, t in pieces]
    return shape(raised, [box_part(0.09 * k, 0.09 * k, 0.006), hull_of(raised[0][0]),
                          hull_of(*(a.move(z=up) for a in arm))])  # fmt: skip


CATEGORIES = (
    Category("violin", violin, (0.53, 0.195, 0.07), 0.42, ("fiddle", "viola"), ("living",),
             ("big",), ("bronze",), state="lying flat"),
    Category("ukulele", ukulele, (0.448, 0.175, 0.0718), 0.45, ("uke",), ("living",), ("big",),
        ("wooden",),
             state="lying flat"),
    Category("metronome", metronome, (0.133, 0.118, 0.218), 0.45, ("wooden metronome",),
             ("living",), ("tall",), ("wooden", "black")),
)  # fmt: skip
"""The module's categories."""
