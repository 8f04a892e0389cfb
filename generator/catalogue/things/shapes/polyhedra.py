"""Polyhedra and other geometric bodies, painted or of wood."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import numpy as np
from jaxtyping import Float

from ...build.category import Category
from ...build.making import PAINTS, Drawing, hull_solid, of, on_a_face, standing
from ...build.outlines import ellipse
from ...build.recipes import Pieces, straight
from ...build.solids import Solid, box, ellipsoid, prism, tube
from ...build.variants import at_rest
from ...surfaces.look import Look

Points = Float[np.ndarray, "n 3"]
GOLDEN = (1 + 5**0.5) / 2


def _with_signs(*corners: tuple[float, float, float]) -> Points:
    """Return corners with every choice of signs."""
    signs = np.array(list(itertools.product((-1, 1), repeat=3)), float)
    return np.concatenate([np.array(c) * signs for c in corners])


def _turns(*corners: tuple[float, float, float]) -> Points:
    """Return corners with every choice of signs, their coordinates exchanged in a circle."""
    return np.concatenate([_with_signs(tuple(np.roll(c, n))) for c in corners for n in range(3)])


_TETRAHEDRON = np.array([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], float)
_OCTAHEDRON = _turns((1, 0, 0))
_ICOSAHEDRON = _turns((0, 1, GOLDEN))
_DODECAHEDRON = np.concatenate([_with_signs((1, 1, 1)), _turns((0, 1 / GOLDEN, GOLDEN))])
_CUBOCTAHEDRON = np.concatenate([_with_signs(c) for c in ((1, 1, 0), (1, 0, 1), (0, 1, 1))])
_RHOMBIC = np.concatenate([_with_signs((1, 1, 1)), _turns((2, 0, 0))])
_FOOTBALL = _turns((0, 1, 3 * GOLDEN), (1, 2 + GOLDEN, 2 * GOLDEN), (GOLDEN, 2, 2 * GOLDEN + 1))


def _skin(look: Look) -> np.ndarray:
    return look.surface(look.color(*PAINTS, "wooden"), look.pick(["plastic", "wood"]))


def _poly(points: Points, size: float) -> Drawing:
    """A polyhedron of a width, lying on a face."""
    body = on_a_face(hull_solid(points))
    body = body.scale(*(3 * [size / float(np.ptp(body.vertices, axis=0).max())]))

    def draw(look: Look) -> Pieces:
        return [(body, _skin(look))]

    return draw


def _body(make: Callable[[], list[Solid]]) -> Drawing:
    """A body of one colour."""

    def draw(look: Look) -> Pieces:
        tile = _skin(look)
        return [(solid, tile) for solid in make()]

    return draw


def _antiprism() -> list[Solid]:
    low, high = ellipse(0.056, 0.056, 6), ellipse(0.056, 0.056, 6, np.pi / 6)
    rings = [np.column_stack([o, np.full(6, z)]) for o, z in ((low, 0.0), (high, 0.038))]
    return [hull_solid(np.concatenate(rings))]


def _slanted_box() -> list[Solid]:
    return [box(0.055, 0.04, 0.04).bend(lambda p: p + np.outer(p[:, 2], (0.5, 0.2, 0)))]


def _frustum() -> list[Solid]:
    return [standing((0.03, 0), (0.016, 0.045), sides=40)]


def _hemisphere() -> list[Solid]:
    a = np.linspace(0, np.pi / 2, 12)
    return [standing(*zip(0.03 * np.cos(a[:-1]), 0.03 * np.sin(a[:-1]), strict=True),
                     (0.0006, 0.03), sides=36)]  # fmt: skip


def _paraboloid() -> list[Solid]:
    r = np.linspace(0.026, 0.0006, 12)
    return [standing(*zip(r, 0.06 * (1 - (r / 0.026) ** 2), strict=True), sides=36)]


def _egg() -> list[Solid]:
    def taper(p: Points) -> Points:
        return p * np.column_stack([np.ones(len(p)), *(2 * [1 - 4.5 * p[:, 0]])])

    return [ellipsoid(0.06, 0.042, 0.042, 32, 18).bend(taper).move(z=0.0205)]


def _stellated_solid() -> list[Solid]:
    made = [hull_solid(0.024 * s * _TETRAHEDRON) for s in (1, -1)]
    a = float(np.arctan2(1, 1))
    made = [m.turn(2, a).turn(1, float(np.arctan(2**0.5))) for m in made]
    low = min(float(m.bounds[0, 2]) for m in made)
    return [m.move(z=-low) for m in made]


def _spiral() -> list[Solid]:
    t = np.linspace(0, 1, 90)
    a = 2 * np.pi * 4 * t
    path = np.column_stack([0.07 * (t - 0.5), 0.016 * np.cos(a), 0.0185 + 0.016 * np.sin(a)])
    return [tube(path, 0.0026, 8)]


def _moebius() -> list[Solid]:
    t = 2 * np.pi * np.arange(72) / 72
    path = np.column_stack([0.04 * np.cos(t), 0.03 * np.sin(t), np.full(72, 0.0125)])
    rings = []
    for angle, (x, y, z) in zip(t, path, strict=True):
        half, out = angle / 2, np.array([np.cos(angle), np.sin(angle), 0])
        wide = np.cos(half) * out + np.sin(half) * np.array([0, 0, 1])
        thick = -np.sin(half) * out + np.cos(half) * np.array([0, 0, 1])
        rings.append([np.array([x, y, z]) + 0.012 * a * wide + 0.0008 * b * thick
                      for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))])  # fmt: skip
    stack = np.array([*rings, rings[0][2:] + rings[0][:2]])
    return [_cell(stack[k], stack[k + 1]) for k in range(72)]


def _cell(a: np.ndarray, b: np.ndarray) -> Solid:
    return hull_solid(np.concatenate([a, b]))


def _frame() -> list[Solid]:
    s, w = 0.026, 0.006
    ends = [(a, b) for a in (-1, 1) for b in (-1, 1)]
    up = [box(w, w, 2 * s).move(a * (s - w / 2), b * (s - w / 2)) for a, b in ends]
    along = [box(2 * s, w, w).move(0, a * (s - w / 2), (b + 1) * (s - w / 2)) for a, b in ends]
    across = [box(w, 2 * s, w).move(a * (s - w / 2), 0, (b + 1) * (s - w / 2)) for a, b in ends]
    return [*up, *along, *across]


def _sponge() -> list[Solid]:
    s = 0.054 / 9
    rods = []
    solid = [k for k in range(9) if k % 3 != 1 and k // 3 != 1]
    for i, j in itertools.product(solid, repeat=2):
        x, y = (i - 4) * s, (j - 4) * s
        rods += [box(s, s, 9 * s).move(x, y), box(9 * s, s, s).move(0, x, (j + 0) * s),
                 box(s, 9 * s, s).move(x, 0, j * s)]  # fmt: skip
    return [s for k, s in enumerate(rods)]


def _letter(*cells: tuple[int, int]) -> list[Solid]:
    s = 0.022
    return [box(s, s, s).move((x - 1) * s, (y - 0.5) * s) for x, y in cells]


def _hexagram() -> list[Solid]:
    a = np.pi / 2 + np.arange(3) * 2 * np.pi / 3
    made = []
    for turn in (0, np.pi):
        corners = 0.034 * np.column_stack([np.cos(a + turn), np.sin(a + turn)])
        for k in range(3):
            p, q = corners[k], corners[(k + 1) % 3]
            made.append(straight((*p, 0.004), (*q, 0.004), 0.004, 8))
    return made


def _round(x: float, y: float, z: float) -> Callable[[], list[Solid]]:
    return lambda: [ellipsoid(x, y, z, 32, 20).move(z=z / 2)]


def _flat(sides: int, r: float, h: float) -> Callable[[], list[Solid]]:
    return lambda: [prism(ellipse(2 * r, 2 * r, sides, np.pi / 2 - np.pi / sides * (sides == 4)),
                          0, h, 0.0008)]  # fmt: skip


CATEGORIES = (
    Category("tetrahedron", of(_poly(_TETRAHEDRON, 0.05)), (0.0438, 0.0506, 0.0413), 0.02,
             ("triangular pyramid",), ("toys",), (), ("red", "blue")),
    Category("octahedron", of(_poly(_OCTAHEDRON, 0.05)), (0.0493, 0.0427, 0.0348), 0.03,
             (), ("toys",), (), ("green", "blue")),
    Category("dodecahedron", of(_poly(_DODECAHEDRON, 0.05)), (0.0486, 0.0462, 0.0393), 0.05,
             (), ("toys",), (), ("purple", "blue")),
    Category("icosahedron", of(_poly(_ICOSAHEDRON, 0.05)), (0.0477, 0.0413, 0.0386), 0.05,
             (), ("toys",), (), ("red", "teal")),
    Category("cuboctahedron", of(_poly(_CUBOCTAHEDRON, 0.05)), (0.0513, 0.0513, 0.0513), 0.05, (),
             ("toys",), (), ("orange", "blue")),
    Category("rhombic_dodecahedron", of(_poly(_RHOMBIC, 0.05)), (0.0344, 0.0486, 0.0344), 0.05, (),
             ("toys",), (), ("yellow", "green")),
    Category("truncated_icosahedron", of(_poly(_FOOTBALL, 0.05)), (0.05, 0.05, 0.048), 0.06,
             ("buckyball", "geodesic ball"), ("toys",), (), ("white", "blue")),
    Category("stellated_octahedron", of(_body(_stellated_solid)), (0.0791, 0.0685, 0.0839), 0.03,
             ("stella octangula", "star polyhedron", "stellated polyhedron",
              "stellated dodecahedron"), ("toys",), (), ("gold", "red")),
    Category("antiprism", of(_body(_antiprism)), (0.056, 0.056, 0.038), 0.05, ("polyhedron",
             "hexagonal antiprism"), ("toys",), (), ("teal", "red")),
    Category("parallelepiped", of(_body(_slanted_box)), (0.075, 0.048, 0.04), 0.06,
             ("rhomboid", "slanted block", "parallelogram block", "rhombohedron"), ("toys",), (),
             ("blue", "green")),
    Category("frustum", of(_body(_frustum)), (0.06, 0.06, 0.045), 0.05, ("truncated cone",
             "cone frustum", "truncated pyramid"), ("toys",), ("support",), ("orange", "blue")),
    Category("hemisphere", of(_body(_hemisphere)), (0.06, 0.06, 0.03), 0.04, ("dome",
             "half sphere", "half ball", "dome block"), ("toys",), (), ("red", "blue")),
    Category("paraboloid", of(_body(_paraboloid)), (0.049, 0.049, 0.0565), 0.04, (), ("toys",), (),
             ("green", "blue")),
    Category("ellipsoid", of(_body(_round(0.07, 0.045, 0.045)), 0.06), (0.07, 0.045, 0.045), 0.05,
             ("spheroid", "oval ball", "prolate spheroid"), ("toys",), (), ("blue", "red")),
    Category("ovoid", of(_body(_egg), 0.06), (0.06, 0.044, 0.041), 0.04, ("egg shape", "gomboc",
             "wooden ovoid"), ("toys",), (), ("wooden", "teal")),
    Category("helix", of(_body(_spiral), 0.1), (0.075, 0.037, 0.037), 0.02, ("spiral",
             "wire spiral", "coil"), ("toys",), (), ("silver", "red")),
    at_rest(Category("moebius_strip", of(_body(_moebius), bodies=range(0, 72, 3)), (0.0944, 0.0794,
             0.0243),
             0.015, ("mobius strip", "mobius band", "mobius loop", "klein bottle"), ("toys",), (),
             ("blue", "gold"))),
    Category("hollow_cube", of(_body(_frame)), (0.052, 0.052, 0.052), 0.03, ("cube frame",
             "open cube", "wire cube", "soma cube frame"), ("toys",), (), ("wooden", "red")),
    Category("menger_sponge", of(_body(_sponge), bodies=range(0, 48, 3)), (0.054, 0.054,
             0.054),
             0.05, ("fractal cube",), ("toys",), (), ("white", "blue")),
    Category("u_block", of(_body(lambda: _letter((0, 0), (1, 0), (2, 0), (0, 1), (2, 1)))),
             (0.066, 0.044, 0.022), 0.05, ("u shaped block", "u piece", "u-block", "c block"),
             ("toys",), (), ("blue", "red")),
    Category("s_block", of(_body(lambda: _letter((0, 0), (1, 0), (1, 1), (2, 1)))),
             (0.066, 0.044, 0.022), 0.04, ("s shaped block", "s piece", "s-block"), ("toys",), (),
             ("green", "red")),
    Category("z_block", of(_body(lambda: _letter((0, 1), (1, 1), (1, 0), (2, 0)))),
             (0.066, 0.044, 0.022), 0.04, ("z shaped block", "z piece", "z-block"), ("toys",), (),
             ("red", "blue")),
    Category("hexagram", of(_body(_hexagram), 0.1), (0.0649, 0.071, 0.00789), 0.03,
             ("star of david", "six pointed star"), ("living",), ("flat",), ("gold", "blue")),
    Category("bar_block", of(_body(lambda: [box(0.12, 0.02, 0.02)])), (0.12, 0.02, 0.02), 0.05,
             ("bar", "square bar", "long bar", "rectangular bar"), ("toys",), (),
             ("wooden", "silver")),
    Category("disc", of(_body(_flat(40, 0.032, 0.01))), (0.064, 0.064, 0.01), 0.03, ("disk",
             "flat disc", "flat disk", "round disc", "wooden disc", "plastic disc", "metal disc"),
             ("toys",), ("flat", "round"), ("red", "blue")),
)  # fmt: skip
"""The module's categories."""
