"""Solids shared by many objects: rods, balls, plates, pads, blades, vessels and pots."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

import numpy as np
from jaxtyping import Float

from ..values import ConvexPart
from . import prints, surfaces
from .materials import glaze_tile
from .outlines import lift, rectangle, smooth
from .parts import cylinder_part, hull_part
from .shapes import Pieces
from .solids import Point, Solid, block, box, cylinder, ellipsoid, join, lathe, loft, prism, tube
from .surfaces import RGB, Look


def side_view(outline: Any, width: float, bevel: float = 0.0) -> Solid:
    """Return the counter-clockwise outline (x, z) of a side view, extruded to ``width`` along y."""
    return prism(outline, -width / 2, width / 2, bevel).turn(0, np.pi / 2)


def facing(solid: Solid) -> Solid:
    """Return a solid rotated so that its top (+z) faces the front (-y)."""
    return solid.turn(0, np.pi / 2)


def lay_down(solid: Solid, x: float = 0.0, z: float = 0.0) -> Solid:
    """Return an upright solid laid down along +x, with its base at ``x`` and its axis at ``z``."""
    return solid.turn(1, np.pi / 2).move(x=x, z=z)


def lobe(solid: Solid, count: int, depth: float) -> Solid:
    """Return a solid with ``count`` lobes around z; ``depth`` is the relative change in radius."""

    def warp(p: Float[np.ndarray, "n 3"]) -> Float[np.ndarray, "n 3"]:
        around = np.arctan2(p[:, 1], p[:, 0])
        factor = 1 + depth * (np.abs(np.cos(count * around / 2)) - 0.64)
        return p * np.column_stack([factor, factor, np.ones(len(p))])

    return solid.bend(warp)


def blade(path: Any, width: float, *, thick: float = 0.35, sides: int = 6) -> Solid:
    """Return a pointed leaf or sprout along ``path``, widest at a third of its length."""
    points = smooth(path, 3)
    t = np.linspace(0, 1, len(points))
    radii = width / 2 * np.maximum((1 - t) ** 0.8 * (0.55 + 1.6 * t), 0.04)
    return tube(points, radii, sides, squash=thick)


def packet(outline: np.ndarray, levels: list[tuple[float, float, float]]) -> Solid:
    """Return a packet: ``outline`` scaled in x and y for each level (z, x factor, y factor)."""
    rings = [lift(outline * [fx, fy], z) for z, fx, fy in levels]
    heights = np.array([z for z, _, _ in levels])
    curve = np.column_stack([[fy * 0.05 for _, _, fy in levels], heights])
    span = heights - heights.min()
    return loft(np.stack(rings), outline, v=span / span.max(), profile=curve)


def pillow(x: np.ndarray, y: np.ndarray, lift: np.ndarray) -> Solid:
    """Return a closed cushion that is built over a grid and bulges by ``lift`` above and below."""
    n = len(x)
    index = np.arange(n * n).reshape(n, n)
    a, b, c, d = index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]
    top = np.concatenate([np.stack(t, -1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
    rim = np.concatenate([index[0, :-1], index[:-1, -1], index[-1, :0:-1], index[:0:-1, 0]])
    after = np.roll(rim, -1)
    wall = np.concatenate([np.stack([rim + n * n, after + n * n, after], 1),
                           np.stack([rim + n * n, after, rim], 1)])  # fmt: skip
    flat = [np.stack([x, y, s * lift], -1).reshape(-1, 3) for s in (1, -1)]
    uv = np.stack(np.meshgrid(np.linspace(0, 1, n), np.linspace(0, 1, n)), -1).reshape(-1, 2)
    faces = np.concatenate([top, top[:, ::-1] + n * n, wall])
    return Solid(np.concatenate(flat), faces, np.concatenate([uv, uv * [-1, 1] + [1, 0]]))


def spread(points: Float[np.ndarray, "n m 3"], thick: float) -> Solid:
    """Return a sheet ``thick`` high over a grid of points, with its texture upright from above.

    ``points`` form the underside: rows run from front to back, columns from left to right.
    """
    n, m = points.shape[:2]
    index = np.arange(n * m).reshape(n, m)
    a, b, c, d = index[:-1, :-1], index[:-1, 1:], index[1:, 1:], index[1:, :-1]
    top = np.concatenate([np.stack(t, -1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
    rim = np.concatenate([index[0, :-1], index[:-1, -1], index[-1, :0:-1], index[:0:-1, 0]])
    after, up = np.roll(rim, -1), n * m
    wall = np.concatenate([np.stack([rim, after, after + up], 1),
                           np.stack([rim, after + up, rim + up], 1)])  # fmt: skip
    low = points.reshape(-1, 3)
    uv = (low[:, :2] - low[:, :2].min(0)) / np.ptp(low[:, :2], axis=0)
    faces = np.concatenate([top + up, top[:, ::-1], wall])
    return Solid(np.concatenate([low, low + np.array([0, 0, thick])]), faces, np.tile(uv, (2, 1)))


def ball(x: float, y: float, z: float, at: Point = (0, 0, 0), fine: int = 16) -> Solid:
    """Return an ellipsoid with diameters x, y and z, centred at ``at``."""
    return ellipsoid(x, y, z, fine, max(fine // 2, 5)).move(*at)


def rod(points: Any, radius: Any, sides: int = 8, steps: int = 4) -> Solid:
    """Return a round rod along a smooth curve, with one radius or a sequence of radii."""
    path = smooth(points, steps)
    if np.ndim(radius):
        radius = np.interp(
            np.linspace(0, 1, len(path)), np.linspace(0, 1, len(radius)), np.asarray(radius)
        )
    return tube(path, radius, sides)


def straight(a: Point, b: Point, radius: Any, sides: int = 8) -> Solid:
    """Return a straight round rod from ``a`` to ``b``."""
    return tube([a, b], radius, sides)


def standing_plate(outline: Any, thick: float, y: float = 0.0, bevel: float = 0.0) -> Solid:
    """Return an upright plate that faces the front, with a counter-clockwise outline (x, z)."""
    return facing(prism(outline, -thick / 2, thick / 2, bevel)).move(y=y)


def pad(x: float, y: float, h: float, radius: float, *, soft: float = 0.3, steps: int = 5) -> Solid:
    """Return a slab with rounded edges on z = 0, for folded cloth, cushions, pouches and soap."""
    outline = rectangle(x, y, radius, steps)
    edge = soft * h
    levels = [(edge, 0.0), (0.3 * edge, 0.15 * h), (0, 0.5 * h), (0.3 * edge, 0.85 * h), (edge, h)]
    rings = [np.column_stack([outline * [1 - 2 * inward / x, 1 - 2 * inward / y],
                              np.full(len(outline), z)]) for inward, z in levels]  # fmt: skip
    return loft(np.stack(rings), outline)


def limb(path: Any, radii: Sequence[float], sides: int = 10, squash: float = 1.0) -> Solid:
    """Return a smooth rod along ``path`` with one radius per point."""
    wide = smooth(np.array(radii, float)[:, None], 4)[:, 0]
    return tube(smooth(path, 4), np.maximum(wide, 0.0003), sides, squash=squash)


def bent_rod(
    length: float,
    r: float,
    *,
    bend: float = 0.0,
    blunt: float = 6.0,
    taper: float = 0.0,
    sides: int = 14,
    squash: float = 1.0,
) -> Solid:
    """Return a rod along x with rounded ends, bent towards +y; ``taper`` narrows the left end.

    ``blunt`` is 2 for an ellipsoid; larger values give blunter ends.
    """
    u = np.sin(np.linspace(-np.pi / 2, np.pi / 2, 15))
    radii = r * np.maximum(1 - np.abs(u) ** blunt, 0.0025) ** 0.5 * (1 + taper * u)
    path = np.column_stack([0.5 * length * u, bend * (u**2 - 0.5), 0 * u])
    return tube(path, radii, sides, squash=squash)


def scatter(
    look: Look,
    radius: float,
    count: int,
    d: tuple[float, float],
    height: float,
    *,
    dome: float = 0.0,
    stretch: tuple[float, float, float] = (1.0, 1.0, 1.0),
) -> Solid:
    """Return ``count`` small ellipsoids on a disc at ``height``, in a heap of height ``dome``."""
    made = []
    for k in range(count):
        away, turn = radius * np.sqrt((k + 0.5) / count), 2.4 * k
        size = look.between(*d)
        up = dome * (1 - (away / radius) ** 2)
        x, y, z = (size * s for s in stretch)
        one = ellipsoid(x, y, z, 8, 5)
        made.append(one.turn(2, look.between(0, 6.3)).move(away * np.cos(turn),
                    away * np.sin(turn), height + up))  # fmt: skip
    return join(made)


def crockery(r: float, h: float, *, deep: bool = True) -> Solid:
    """Return a round dish on z = 0: a deep bowl, or a shallow plate with a rim."""
    if deep:
        side = [(0.45 * r, 0), (0.48 * r, 0.06 * h), (0.76 * r, 0.34 * h), (0.93 * r, 0.7 * h),
                (r, h), (0.96 * r, h), (0.88 * r, 0.68 * h), (0.7 * r, 0.4 * h)]  # fmt: skip
        floor = 0.3 * h
    else:
        side = [(0.58 * r, 0), (0.6 * r, 0.12 * h), (0.72 * r, 0.3 * h), (r, h - 0.003),
                (r, h), (0.7 * r, 0.5 * h)]  # fmt: skip
        floor = 0.4 * h
    return lathe([(0, 0), *side, (0, floor)], 32)


def spindle(*profile: tuple[float, float], sides: int = 16, z: float | None = None) -> Solid:
    """Return a solid of revolution about the x axis, from (x, radius) points, left to right."""
    points = [(r, x) for x, r in profile]
    points = [(0.0, points[0][1]), *points, (0.0, points[-1][1])]
    body = lathe(points, sides, v=None).turn(1, np.pi / 2)
    return body.move(z=max(r for _, r in profile) if z is None else z)


def standing(*profile: tuple[float, float], sides: int = 24, at: Point = (0, 0, 0)) -> Solid:
    """Return a solid of revolution about the z axis, from (radius, z) points, bottom to top."""
    points = [(0.0, profile[0][1]), *profile, (0.0, profile[-1][1])]
    return lathe(points, sides).move(*at)


def lies(solid: Solid, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Solid:
    """Return a solid along z, laid down along +x with its bottom at ``x``."""
    return solid.turn(1, np.pi / 2).move(x, y, z)


def at_box(x: float, y: float, z: float, at: Sequence[float] = (0, 0, 0)) -> Solid:
    """Return a box; ``at`` is the centre of its bottom face."""
    return box(x, y, z).move(*at)


def at_block(x: float, y: float, z: float, r: float, at: Sequence[float] = (0, 0, 0)) -> Solid:
    """Return a box with rounded vertical edges and chamfered rims; ``at`` is its bottom centre."""
    return block(x, y, z, r, min(0.3 * r, 0.2 * z)).move(*at)


def disc(
    r: float,
    h: float,
    at: Sequence[float] = (0, 0, 0),
    *,
    top: float | None = None,
    sides: int = 24,
) -> Solid:
    """Return an upright cylinder, or a cone of upper radius ``top``, with its base at ``at``."""
    bevel = 0.0 if top is not None else min(0.1 * h, 0.1 * r)
    return cylinder(r, h, sides, top=top, bevel=bevel).move(*at)


def drum(
    radius: float,
    long: float,
    at: Point = (0, 0, 0),
    axis: Literal[0, 1, 2] = 2,
    *,
    top: float | None = None,
    sides: int = 24,
    bevel: float = 0.0,
) -> Solid:
    """Return a cylinder from ``at`` along ``axis``, or a cone with the end radius ``top``."""
    made = cylinder(radius, long, sides, top=top, bevel=bevel)
    if axis == 0:
        made = made.turn(1, np.pi / 2)
    elif axis == 1:
        made = made.turn(0, -np.pi / 2)
    return made.move(*at)


def hull_solid(points: Any) -> Solid:
    """Return the convex hull of ``points`` as a solid with flat faces."""
    from scipy.spatial import ConvexHull

    p = np.unique(np.asarray(points, float).round(7), axis=0)
    hull = ConvexHull(p)
    corners = p[hull.simplices]
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    inward = np.einsum("ij,ij->i", normal, hull.equations[:, :3]) < 0
    corners[inward] = corners[inward][:, ::-1]
    uv = np.tile([[0.1, 0.1], [0.9, 0.1], [0.5, 0.9]], (len(corners), 1))
    return Solid(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3), uv)


def on_a_face(solid: Solid) -> Solid:
    """Return a convex solid resting on its largest face, preferring faces that point down."""
    v, f = solid.vertices, solid.faces
    cross = np.cross(v[f[:, 1]] - v[f[:, 0]], v[f[:, 2]] - v[f[:, 0]])
    size = np.linalg.norm(cross, axis=1)
    normal = cross / size[:, None]
    same = normal.round(3) @ normal.round(3).T > 0.999
    area = (same * size).sum(1) * (1 + 0.2 * -normal[:, 2])
    n = normal[int(np.argmax(area))]
    turn = float(np.arctan2(n[1], n[0]))
    made = solid.turn(2, -turn).turn(1, float(np.arctan2(np.hypot(n[0], n[1]), -n[2])))
    return made.move(z=-float(made.bounds[0, 2]))


def plate(
    outline: Any, h: float, z: float = 0.0, *, at: Point = (0, 0, 0), bevel: float = 0.0
) -> Solid:
    """Return a plate with an outline (x, y) of either orientation; ``at`` is on its underside."""
    points = np.asarray(outline, float)
    x, y = points.T
    area = float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))
    return prism(points if area >= 0 else points[::-1], 0, h, bevel).move(at[0], at[1], at[2] + z)


def press_flat(solid: Solid, depth: float) -> Solid:
    """Return a solid flattened below z = -``depth`` and raised so that it stands on z = 0."""
    flat = solid.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], -depth)]))
    return flat.move(z=depth)


def planter(look: Look, r: float, h: float) -> Pieces:
    """Return a glazed or wicker plant pot (tapered, straight, bellied or faceted) with soil."""
    color = look.color(*("terracotta", "terracotta", "white", "gray", "teal", "cream", "black",
                         "mustard"), *("pink", "sky", "brown"))  # fmt: skip
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
    tile = surfaces.basketwork(look.rng, color) if look.chance(0.12) else glaze_tile(look, color)
    earth = look.pick([(74, 54, 40), (58, 44, 36), (150, 144, 134)])
    return [(pot, tile), (soil.move(z=0.88 * h), surfaces.speckles(look.rng, earth, 14))]


PRINTS = ("red", "navy", "teal", "green", "mustard", "crimson", "orange", "purple", "blue")


def label_skin(
    look: Look, base: RGB, word: str, low: float, high: float, ground: RGB = (244, 242, 234)
) -> surfaces.Tile:
    """Return a plain bottle surface with a label between the heights v = ``low`` and ``high``."""
    print_ = prints.label(look.rng, word, look.own_color(*PRINTS), ground)
    skin = surfaces.speckles(look.rng, base, 3, 32)
    return surfaces.stack((skin, low), (print_, high - low), (skin, 1 - high), side=192)


def vessel(
    r: float,
    h: float,
    neck: float,
    shoulder: float,
    rise: float,
    *,
    waist: bool = False,
    sides: int = 32,
) -> Solid:
    """Return a bottle's body up to its mouth at height ``h``; ``waist`` adds a grip in the middle.

    The wall is straight below z = ``shoulder``; above z = ``rise``, its radius is ``neck``.
    Texture coordinate v is proportional to z on the outside, so that labels have known heights.
    """
    t = np.linspace(0, 1, 6)[1:-1]
    bow = [(neck + (r - neck) * (0.5 + 0.5 * np.cos(np.pi * k)), shoulder + (rise - shoulder) * k)
           for k in t]  # fmt: skip
    grip = [(0.88 * r, k * shoulder) for k in (0.5, 0.6)] if waist else []
    ends = [(r, k * shoulder) for k in (0.4, 0.7)] if waist else []
    profile = [(0, 0), (0.92 * r, 0), (r, 0.005), *ends[:1], *grip, *ends[1:], (r, shoulder), *bow,
               (neck, rise), (neck, h), (0, h)]  # fmt: skip
    return lathe(profile, sides, v=[0, *(z / h for _, z in profile[1:-1]), 1])


def vessel_parts(
    body: Solid, r: float, shoulder: float, neck: float, h: float, rise: float
) -> list[ConvexPart]:
    """Return the collision parts of a vessel: body, shoulder and neck."""
    upper = body.vertices[(body.vertices[:, 2] >= shoulder) & (body.vertices[:, 2] <= rise + 1e-6)]
    return [
        cylinder_part(0.99 * r, shoulder),
        hull_part(upper),
        cylinder_part(neck, h - rise, (0, 0, rise)),
    ]
