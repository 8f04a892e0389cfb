"""Objects of the ``toys`` theme: shapes."""

from __future__ import annotations

import itertools
from collections.abc import Callable

import numpy as np
from jaxtyping import Float

from ...kit.materials import PAINTS
from ...kit.outlines import arc, ellipse
from ...kit.parts import hull_of, resting_ball, ring_parts
from ...kit.primitives import hull_solid, on_a_face, side_view, standing
from ...kit.shapes import Category, Drawing, Pieces, Shape, at_rest, category, from_pieces, shape
from ...kit.solids import Solid, block, box, cylinder, ellipsoid, lathe, prism, tube
from ...kit.surfaces import Look

CUBE_PAINTS = ("red", "blue", "green", "yellow", "orange", "purple", "wooden", "teal", "pink")
Made = tuple[list[Solid], list[Solid]]
"""The visible solids, and the solids whose hulls are the collision parts."""


def paint(
    make: Callable[[float], Made],
    palette: tuple[str, ...] = CUBE_PAINTS,
    default: tuple[str, ...] = ("plastic", "wood"),
) -> Callable[[Look], Shape]:
    """Return a shape function for a block whose solids ``make`` builds at a random scale."""

    def make_block(look: Look) -> Shape:
        k = look.between(0.9, 1.12)
        drawn, hulls = make(k)
        tile = look.surface(look.color(*palette), look.pick(default))
        return shape([(s, tile) for s in drawn], [hull_of(s) for s in hulls])

    return make_block


def same(*solids: Solid) -> Made:
    """Return two lists of the given solids: one for drawing and one for collisions."""
    return list(solids), list(solids)


def _polygon(sides: int, radius: float, height: float, start: float = 0.0) -> Made:
    outline = ellipse(2 * radius, 2 * radius, sides, start)
    return same(prism(outline, 0, height, 0.001))


def _slope(k: float) -> Made:
    return same(side_view(np.array([(-0.03, 0), (0.03, 0), (-0.03, 0.04)]) * k, 0.04 * k))


def _roof(k: float) -> Made:
    return same(side_view(np.array([(-0.025, 0), (0.025, 0), (0, 0.0433)]) * k, 0.06 * k))


def _pyramid(k: float) -> Made:
    return same(cylinder(0.04 * k, 0.05 * k, 4, top=0.0004).turn(2, np.pi / 4))


def _cone(k: float) -> Made:
    return same(cylinder(0.026 * k, 0.06 * k, 32, top=0.0006))


def _half_round(k: float) -> Made:
    curve = arc((0, 0), 0.03, 0, np.pi, 14)
    return same(side_view(curve * k, 0.04 * k))


def _ring(outer: float, inner: float, height: float) -> Callable[[Look], Shape]:
    """A ring or a piece of round tube."""

    def make_shape(look: Look) -> Shape:
        k = look.between(0.9, 1.12)
        a, b, h = outer * k, inner * k, height * k
        c = min(0.3 * h, 0.3 * (a - b))
        profile = [(b, c), (b + c, 0), (a - c, 0), (a, c), (a, h - c), (a - c, h), (b + c, h),
                   (b, h - c)]  # fmt: skip
        tile = look.surface(look.color(*CUBE_PAINTS), look.pick(["plastic", "wood"]))
        return shape(
            [(lathe(profile, 36, loop=True), tile)],
            ring_parts([(a - c, 0), (a, c), (a, h - c), (a - c, h)], [(b, h), (b, 0)], 10),
        )

    return make_shape


@category("sphere", size=(0.05, 0.05, 0.05), mass=0.06, material="wood",
          aliases=("orb", "plain ball"), themes=("toys",), roles=("round",),
          colors=("red", "blue"))  # fmt: skip
def sphere(look: Look) -> Shape:
    """A smooth ball of one colour."""
    d = look.between(0.045, 0.055)
    tile = look.surface(look.color(*CUBE_PAINTS), look.pick(["plastic", "wood"]))
    return shape([(ellipsoid(d, d, d, 32, 20).move(z=d / 2), tile)], [resting_ball(d, d, d)])


Points = Float[np.ndarray, "n 3"]
GOLDEN = (1 + 5**0.5) / 2


def _with_signs(*corners: tuple[float, float, float]) -> Points:
    """Return the given points (x, y, z) with every combination of signs of their coordinates."""
    signs = np.array(list(itertools.product((-1, 1), repeat=3)), float)
    return np.concatenate([np.array(c) * signs for c in corners])


def _turns(*corners: tuple[float, float, float]) -> Points:
    """Return all sign changes and cyclic permutations of the coordinates of the given points."""
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
    """A polyhedron of the given width, lying on a face."""
    body = on_a_face(hull_solid(points))
    body = body.scale(*(3 * [size / float(np.ptp(body.vertices, axis=0).max())]))

    def draw(look: Look) -> Pieces:
        return [(body, _skin(look))]

    return draw


def body(make: Callable[[], list[Solid]]) -> Drawing:
    """A solid of one colour."""

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


def _round(x: float, y: float, z: float) -> Callable[[], list[Solid]]:
    return lambda: [ellipsoid(x, y, z, 32, 20).move(z=z / 2)]


def _flat(sides: int, r: float, h: float) -> Callable[[], list[Solid]]:
    return lambda: [prism(ellipse(2 * r, 2 * r, sides, np.pi / 2 - np.pi / sides * (sides == 4)),
                          0, h, 0.0008)]  # fmt: skip


CATEGORIES = (
    Category("cube", paint(lambda k: same(block(0.05 * k, 0.05 * k, 0.05 * k, 0.0015, 0.001))),
             size=(0.05, 0.05, 0.05), mass=0.09, material="wood",
             aliases=("plain cube", "colored cube", "coloured cube", "cube block", "cubic block"),
             themes=("toys",), colors=("red", "blue", "green", "yellow")),
    Category("cuboid", paint(lambda k: same(block(0.08 * k, 0.04 * k, 0.03 * k, 0.0015, 0.001))),
             size=(0.08, 0.04, 0.03), mass=0.07, material="wood", aliases=("rectangular block",
             "rectangular prism", "block brick", "cuboid block", "long block", "cuisenaire rod",
             "blade bank", "match striker"), themes=("toys",), colors=("red", "blue")),
    Category("cylinder", paint(lambda k: same(cylinder(0.022 * k, 0.055 * k, 32, bevel=0.001))),
             size=(0.044, 0.044, 0.055), mass=0.06, material="wood",
             aliases=("cylinder block", "cylindrical block", "round block"), themes=("toys",),
             roles=("round",), colors=("red", "blue")),
    Category("cone", paint(_cone), size=(0.052, 0.052, 0.06), mass=0.035, material="wood",
             aliases=("cone block",), themes=("toys",), roles=("round",), colors=("orange", "red")),
    Category("pyramid", paint(_pyramid), size=(0.0566, 0.0566, 0.05), mass=0.04, material="wood",
             aliases=("pyramid block", "square pyramid"), themes=("toys",),
             colors=("yellow", "red")),
    Category("wedge", paint(_slope), size=(0.06, 0.04, 0.04), mass=0.035, material="wood",
             aliases=("wedge block", "ramp block", "ramp", "door stop", "doorstop", "door wedge"),
             themes=("toys",), colors=("green", "blue")),
    Category("triangular_prism", paint(_roof), size=(0.05, 0.06, 0.0433), mass=0.045,
             material="wood",
             aliases=("triangle block", "triangular block", "roof block", "triangle prism"),
             themes=("toys",), colors=("red", "green")),
    Category("hexagonal_prism", paint(lambda k: _polygon(6, 0.027 * k, 0.04 * k)),
             size=(0.054, 0.0468, 0.04), mass=0.05, material="wood",
             aliases=("hexagon block", "hexagonal block", "hex block", "hexagon prism", "hexagon"),
             themes=("toys",), colors=("purple", "yellow")),
    Category("half_cylinder", paint(_half_round), size=(0.06, 0.04, 0.03), mass=0.04,
             material="wood",
             aliases=("semicircle block", "half round block", "half circle block", "semi cylinder"),
             themes=("toys",), colors=("blue", "red")),
    Category("torus", _ring(0.036, 0.018, 0.018), size=(0.072, 0.072, 0.018), mass=0.035,
             material="wood", aliases=("ring block", "toroid", "toy ring", "wooden ring",
             "plastic ring", "rubber ring", "ring toss ring", "quoit", "stacking ring",
             "rope quoit", "wooden quoit", "ring shaped block"), themes=("toys",),
             roles=("round", "flat"), colors=("red", "blue")),
    Category("hollow_cylinder", _ring(0.022, 0.016, 0.07), size=(0.044, 0.044, 0.07), mass=0.035,
             material="plastic", hollow=True, aliases=("tube", "hollow tube", "plastic tube"),
             themes=("toys",), roles=("round",), colors=("blue", "red")),
    Category("tetrahedron", from_pieces()(_poly(_TETRAHEDRON, 0.05)), size=(0.0438, 0.0506, 0.0413),
             mass=0.02, material="wood", aliases=("triangular pyramid",), themes=("toys",),
             colors=("red", "blue")),
    Category("octahedron", from_pieces()(_poly(_OCTAHEDRON, 0.05)), size=(0.0493, 0.0427, 0.0348),
             mass=0.03, material="wood", themes=("toys",), colors=("green", "blue")),
    Category("dodecahedron", from_pieces()(_poly(_DODECAHEDRON, 0.05)),
             size=(0.0486, 0.0462, 0.0393), mass=0.05, material="wood", themes=("toys",),
             colors=("purple", "blue")),
    Category("icosahedron", from_pieces()(_poly(_ICOSAHEDRON, 0.05)), size=(0.0477, 0.0413, 0.0386),
             mass=0.05, material="wood", themes=("toys",), colors=("red", "teal")),
    Category("cuboctahedron", from_pieces()(_poly(_CUBOCTAHEDRON, 0.05)),
             size=(0.0513, 0.0513, 0.0513), mass=0.05, material="wood", themes=("toys",),
             colors=("orange", "blue")),
    Category("rhombic_dodecahedron", from_pieces()(_poly(_RHOMBIC, 0.05)),
             size=(0.0344, 0.0486, 0.0344), mass=0.05, material="wood", themes=("toys",),
             colors=("yellow", "green")),
    Category("truncated_icosahedron", from_pieces()(_poly(_FOOTBALL, 0.05)),
             size=(0.05, 0.05, 0.048), mass=0.06, material="wood",
             aliases=("buckyball", "geodesic ball"), themes=("toys",), colors=("white", "blue")),
    Category("stellated_octahedron", from_pieces()(body(_stellated_solid)),
             size=(0.0791, 0.0685, 0.0839), mass=0.03, material="wood", aliases=("stella octangula",
             "star polyhedron", "stellated polyhedron", "stellated dodecahedron"), themes=("toys",),
             colors=("gold", "red")),
    Category("antiprism", from_pieces()(body(_antiprism)), size=(0.056, 0.056, 0.038), mass=0.05,
             material="wood", aliases=("polyhedron", "hexagonal antiprism"), themes=("toys",),
             colors=("teal", "red")),
    Category("parallelepiped", from_pieces()(body(_slanted_box)), size=(0.075, 0.048, 0.04),
             mass=0.06, material="wood",
             aliases=("rhomboid", "slanted block", "parallelogram block", "rhombohedron"),
             themes=("toys",), colors=("blue", "green")),
    Category("frustum", from_pieces()(body(_frustum)), size=(0.06, 0.06, 0.045), mass=0.05,
             material="wood", aliases=("truncated cone", "cone frustum", "truncated pyramid"),
             themes=("toys",), roles=("support",), colors=("orange", "blue")),
    Category("hemisphere", from_pieces()(body(_hemisphere)), size=(0.06, 0.06, 0.03), mass=0.04,
             material="wood", aliases=("dome", "half sphere", "half ball", "dome block"),
             themes=("toys",), colors=("red", "blue")),
    Category("paraboloid", from_pieces()(body(_paraboloid)), size=(0.049, 0.049, 0.0565), mass=0.04,
             material="wood", themes=("toys",), colors=("green", "blue")),
    Category("ellipsoid", from_pieces(foot=0.06)(body(_round(0.07, 0.045, 0.045))),
             size=(0.07, 0.045, 0.045), mass=0.05, material="wood",
             aliases=("spheroid", "oval ball", "prolate spheroid"), themes=("toys",),
             colors=("blue", "red")),
    Category("ovoid", from_pieces(foot=0.06)(body(_egg)), size=(0.06, 0.044, 0.041), mass=0.04,
             material="wood", aliases=("egg shape", "gomboc", "wooden ovoid"), themes=("toys",),
             colors=("wooden", "teal")),
    Category("helix", from_pieces(foot=0.1)(body(_spiral)), size=(0.075, 0.037, 0.037), mass=0.02,
             material="wood", aliases=("spiral", "wire spiral", "coil"), themes=("toys",),
             colors=("silver", "red")),
    Category("moebius_strip", at_rest(from_pieces(bodies=range(0, 72, 3))(body(_moebius))),
             size=(0.0944, 0.0794, 0.0243), mass=0.015, material="wood",
             aliases=("mobius strip", "mobius band", "mobius loop", "klein bottle"),
             themes=("toys",), colors=("blue", "gold")),
    Category("hollow_cube", from_pieces()(body(_frame)), size=(0.052, 0.052, 0.052), mass=0.03,
             material="wood", aliases=("cube frame", "open cube", "wire cube", "soma cube frame"),
             themes=("toys",), colors=("wooden", "red")),
    Category("menger_sponge", from_pieces(bodies=range(0, 48, 3))(body(_sponge)),
             size=(0.054, 0.054, 0.054), mass=0.05, material="wood", aliases=("fractal cube",),
             themes=("toys",), colors=("white", "blue")),
    Category("disc", from_pieces()(body(_flat(40, 0.032, 0.01))), size=(0.064, 0.064, 0.01),
             mass=0.03, material="wood", aliases=("disk", "flat disc", "flat disk", "round disc",
             "wooden disc", "plastic disc", "metal disc"), themes=("toys",),
             roles=("flat", "round"), colors=("red", "blue")),
)  # fmt: skip
"""Objects that share their drawing functions."""
