"""Short ways to things made of a few pieces: turned rods, plates, prints and their tiles."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, Literal

import numpy as np

from ...scene import ConvexPart
from ..surfaces import prints, textures
from ..surfaces.colors import RGB
from ..surfaces.look import Look
from ..surfaces.textures import Tile
from .collision import hull_part
from .forms import above
from .recipes import Pieces, Point, Profile, open_vessel, put_down
from .shape import Shape, shape
from .solids import Solid, block, box, cylinder, lathe, prism

Drawing = Callable[[Look], Pieces]
"""What draws the pieces of one variant."""

Bodies = int | Sequence[int] | None
"""How many of the first pieces collide, or which ones; None stands for all."""

STEEL = ("silver", "silver", "gray", "charcoal")
BRASS = ("brass", "gold", "bronze")
GOLD = ("gold", "gold", "silver")
WOODEN = ("wooden", "tan", "brown", "wooden", "beige")
DARK: RGB = (40, 42, 46)
STEEL_TONE: RGB = (184, 188, 194)
BRASS_TONE: RGB = (196, 160, 84)
GLASS_TONE: RGB = (206, 224, 228)
PAINTS = ("red", "blue", "green", "yellow", "orange", "purple", "teal", "pink")


def of(
    draw: Drawing,
    foot: float = 0.0,
    *,
    bodies: Bodies = None,
    spread: float = 0.1,
    opacity: float = 1.0,
) -> Callable[[Look], Shape]:
    """Return a shape function of what ``draw`` draws, larger and smaller by up to ``spread``.

    ``foot`` is the lowest share of each body that is pressed flat.
    """

    def make(look: Look) -> Shape:
        factor = look.between(1 - spread, 1 + spread)
        pieces = draw(look)
        chosen = range(len(pieces) if bodies is None else bodies) if (
            bodies is None or isinstance(bodies, int)) else bodies  # fmt: skip
        solids = [pieces[k][0] for k in chosen]
        return put_down(pieces, *solids, factor=factor, foot=foot, opacity=opacity)

    return make


def metal(look: Look, *palette: str) -> Tile:
    """Return the metal of a thing in its colour."""
    return look.surface(look.color(*(palette or STEEL)), "metal")


def wood(look: Look, *palette: str) -> Tile:
    """Return the wood of a thing in its colour."""
    return look.surface(look.color(*(palette or WOODEN)), "wood")


def plastic(look: Look, *palette: str) -> Tile:
    """Return the plastic or paint of a thing in its colour."""
    return look.surface(look.color(*(palette or PAINTS)))


def cloth(look: Look, *palette: str) -> Tile:
    """Return the cloth of a thing in its colour."""
    return look.surface(look.color(*palette), "fabric")


def dye(look: Look, *palette: str) -> Tile:
    """Return the paint of a detail, whatever colour was asked for."""
    return textures.speckles(look.rng, look.own_color(*palette), 4, 32)


def steel(look: Look, color: RGB = STEEL_TONE) -> Tile:
    """Return brushed metal."""
    return textures.brushed_metal(look.rng, color)


def shine(look: Look, *palette: str) -> Tile:
    """Return the metal of a detail, whatever was asked for."""
    return textures.brushed_metal(look.rng, look.own_color(*(palette or ("silver",))))


def spindle(*profile: tuple[float, float], sides: int = 16, z: float | None = None) -> Solid:
    """Return a body turned about the x axis: (x, radius) points from left to right, lying."""
    points = [(r, x) for x, r in profile]
    points = [(0.0, points[0][1]), *points, (0.0, points[-1][1])]
    body = lathe(points, sides, v=None).turn(1, np.pi / 2)
    return body.move(z=max(r for _, r in profile) if z is None else z)


def standing(*profile: tuple[float, float], sides: int = 24, at: Point = (0, 0, 0)) -> Solid:
    """Return a body turned about the z axis: (radius, z) points from the bottom up."""
    points = [(0.0, profile[0][1]), *profile, (0.0, profile[-1][1])]
    return lathe(points, sides).move(*at)


def lies(solid: Solid, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Solid:
    """Return a solid along z laid down along +x, its foot at ``x``."""
    return solid.turn(1, np.pi / 2).move(x, y, z)


def at_box(x: float, y: float, z: float, at: Sequence[float] = (0, 0, 0)) -> Solid:
    """Return a box whose bottom's middle is ``at``."""
    return box(x, y, z).move(*at)


def at_block(x: float, y: float, z: float, r: float, at: Sequence[float] = (0, 0, 0)) -> Solid:
    """Return a box with rounded upright edges and soft rims whose bottom's middle is ``at``."""
    return block(x, y, z, r, min(0.3 * r, 0.2 * z)).move(*at)


def disc(
    r: float,
    h: float,
    at: Sequence[float] = (0, 0, 0),
    *,
    top: float | None = None,
    sides: int = 24,
) -> Solid:
    """Return an upright cylinder, or cone to the radius ``top``; ``at`` is its bottom's middle."""
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
    """Return a cylinder, or a cone to the radius ``top``, from ``at`` on along an axis."""
    made = cylinder(radius, long, sides, top=top, bevel=bevel)
    if axis == 0:
        made = made.turn(1, np.pi / 2)
    elif axis == 1:
        made = made.turn(0, -np.pi / 2)
    return made.move(*at)


def hull_solid(points: Any) -> Solid:
    """Return the convex hull of ``points`` with flat faces."""
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
    """Return a convex body laid on its largest face, near one looking downwards already."""
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
    """Return a flat plate of an outline (x, y), whichever way it turns; its underside at ``at``."""
    points = np.asarray(outline, float)
    x, y = points.T
    area = float(np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))
    return prism(points if area >= 0 else points[::-1], 0, h, bevel).move(at[0], at[1], at[2] + z)


def vessel(
    profile: Profile,
    wall: float,
    bottom: float,
    tile: Tile,
    *,
    extra: Pieces = (),  # type: ignore[assignment]
    bodies: Sequence[Solid] = (),
    factor: float = 1.0,
    opacity: float = 1.0,
    fine: int = 28,
) -> Shape:
    """Return an open vessel with further pieces, and with parts of their own for ``bodies``."""
    made, parts = open_vessel(profile, wall, bottom, fine)
    more: tuple[ConvexPart, ...] = tuple(hull_part(above(b.vertices)) for b in bodies)
    return shape([(made, tile), *extra], (*parts, *more), opacity).scale(factor)


def words(text: str, ground: RGB, ink: RGB, size: float = 0.3, wide: int = 128, tall: int = 64
          ) -> Tile:  # fmt: skip
    """Return a plate with one word on it."""
    image = prints.canvas(wide, tall, ground)
    prints.write(image, text, 0.5, 0.5, size, ink, bold=True)
    return image
