"""Pieces in place with few words: bars, discs, plates cut out, vessels and turned forms."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, Literal

import numpy as np

from ...scene import ConvexPart
from ..surfaces import textures
from ..surfaces.colors import RGB
from ..surfaces.look import Look
from ..surfaces.textures import Tile
from .collision import hull_part
from .forms import above
from .hollow import Profile, open_vessel
from .recipes import Pieces, Point
from .shape import Shape, shape
from .solids import Solid, box, cylinder, lathe, prism

GLASS: RGB = (206, 224, 228)
BRASS: RGB = (196, 160, 84)
STEEL: RGB = (184, 188, 194)
DARK: RGB = (40, 42, 46)


def bar(x: float, y: float, z: float, at: Point = (0, 0, 0)) -> Solid:
    """Return a box whose bottom's middle is ``at``."""
    return box(x, y, z).move(*at)


def disc(
    radius: float,
    long: float,
    at: Point = (0, 0, 0),
    axis: Literal[0, 1, 2] = 2,
    *,
    top: float | None = None,
    fine: int = 24,
    bevel: float = 0.0,
) -> Solid:
    """Return a cylinder, or a cone, from ``at`` on along an axis."""
    made = cylinder(radius, long, fine, top=top, bevel=bevel)
    if axis == 0:
        made = made.turn(1, np.pi / 2)
    elif axis == 1:
        made = made.turn(0, -np.pi / 2)
    return made.move(*at)


def cut(outline: Any, thick: float, at: Point = (0, 0, 0), bevel: float = 0.0) -> Solid:
    """Return a plate with this outline (x, y; either way round), its underside at ``at``."""
    rim = np.asarray(outline, float)
    after = np.roll(rim, -1, 0)
    if (rim[:, 0] * after[:, 1] - rim[:, 1] * after[:, 0]).sum() < 0:
        rim = rim[::-1]
    return prism(rim, 0.0, thick, bevel).move(*at)


def turned(profile: Profile, at: Point = (0, 0, 0), fine: int = 24) -> Solid:
    """Return a solid of revolution through (radius, z) points, closed on the axis."""
    points = [(0.0, profile[0][1]), *profile, (0.0, profile[-1][1])]
    return lathe(points, fine).move(*at)


def lies(solid: Solid, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> Solid:
    """Return a solid along z laid down along +x, its foot at ``x``."""
    return solid.turn(1, np.pi / 2).move(x, y, z)


def steel(look: Look, color: RGB = STEEL) -> Tile:
    """Return brushed metal."""
    return textures.brushed_metal(look.rng, color)


def plain(color: RGB) -> Tile:
    """Return one flat colour."""
    return textures.plain(color)


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
