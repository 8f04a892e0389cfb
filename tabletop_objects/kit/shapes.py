"""Shapes, categories, and the decorators that make a category from a drawing function.

A drawing function takes a ``Look`` and returns a ``Shape`` in metres that stands on z = 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import KW_ONLY, dataclass, replace
from functools import wraps
from types import MappingProxyType
from typing import Concatenate, ParamSpec

import numpy as np
from jaxtyping import Float, Int, UInt8

from ..errors import InputError, choices
from ..values import ConvexPart, Extent, Holder, Mesh, Slot
from .parts import above, box_part, hull_above, hull_part, open_vessel
from .solids import Profile, Solid
from .surfaces import Look, Tile, plain

ShapeFunction = Callable[[Look], "Shape"]
"""A function that draws one variant of a category."""

P = ParamSpec("P")

FRICTION: Mapping[str, float] = MappingProxyType(
    {
        "ceramic": 0.5, "glass": 0.45, "metal": 0.45, "wood": 0.5, "stone": 0.5, "plastic": 0.45,
        "paper": 0.5, "wax": 0.5, "food": 0.55, "leather": 0.6, "device": 0.65, "fabric": 0.7,
        "rubber": 0.85,
    }
)  # fmt: skip
"""Sliding friction by material on a plain wooden tabletop; "device" is a case on rubber feet.

Handbook ranges are wood on wood 0.25-0.5, metal on wood 0.2-0.6, leather on wood 0.3-0.6; the
values here are from the upper ends of these ranges. MuJoCo takes the larger coefficient of the two
in contact.
"""


MARGIN = 2
"""Width in pixels of the margin that repeats each tile's rim in the atlas, to prevent bleeding."""


@dataclass(frozen=True, eq=False)
class Piece:
    """A solid and the texture tile that its texture coordinates refer to."""

    solid: Solid
    tile: Tile


@dataclass(frozen=True, eq=False)
class Shape:
    """An object drawn by its category's function, in metres and standing on z = 0.

    ``slots`` are the slots of a holder, in metres.
    """

    pieces: tuple[Piece, ...]
    parts: tuple[ConvexPart, ...]
    opacity: float = 1.0
    slots: tuple[Slot, ...] = ()

    def scale(self, factor: float) -> Shape:
        """Return the shape scaled by ``factor``."""
        return replace(
            self,
            pieces=tuple(Piece(p.solid.scale(factor, factor, factor), p.tile) for p in self.pieces),
            parts=tuple(ConvexPart(p.vertices * factor, p.kind, p.axis) for p in self.parts),
            slots=tuple(replace(slot, at=slot.at * factor) for slot in self.slots),
        )


def shape(
    pieces: Iterable[tuple[Solid, Tile]],
    parts: Sequence[ConvexPart],
    opacity: float = 1.0,
    slots: Sequence[Slot] = (),
) -> Shape:
    """Return a shape from (solid, tile) pairs, convex parts and slots for other objects.

    Points of the solids below z = 0 are flattened onto it.
    """
    flat = tuple(Piece(_press(s), t) for s, t in pieces)
    return Shape(flat, tuple(parts), opacity, tuple(slots))


def _press(solid: Solid) -> Solid:
    if solid.vertices[:, 2].min() >= 0:
        return solid
    return solid.bend(lambda p: np.column_stack([p[:, :2], np.maximum(p[:, 2], 0)]))


def mesh_of(made: Shape) -> Mesh:
    """Merge a shape's pieces into one mesh, in metres, with one texture atlas."""
    tiles: list[Tile] = []
    numbers: dict[tuple[tuple[int, ...], bytes], int] = {}
    which = []
    for piece in made.pieces:
        tile = piece.tile
        if (tile == tile[:1, :1]).all():
            tile = plain(tuple(tile[0, 0]))
        key = (tile.shape, tile.tobytes())
        if key not in numbers:
            numbers[key] = len(tiles)
            tiles.append(tile)
        which.append(numbers[key])
    atlas, corners = pack(tiles)
    size = np.array([atlas.shape[1], atlas.shape[0]], float)
    vertices, faces, uv, count = [], [], [], 0
    for piece, k in zip(made.pieces, which, strict=True):
        span = np.array([tiles[k].shape[1], tiles[k].shape[0]], float)
        at = piece.solid.uv * (span - 1) + 0.5  # map to the centres of the outermost pixels
        low = np.array([corners[k, 0], size[1] - corners[k, 1] - span[1]])
        vertices.append(piece.solid.vertices)
        faces.append(piece.solid.faces + count)
        uv.append((low + at) / size)
        count += len(piece.solid.vertices)
    return Mesh(
        np.concatenate(vertices), np.concatenate(faces), np.concatenate(uv), atlas, made.opacity
    )


def pack(tiles: Sequence[Tile]) -> tuple[UInt8[np.ndarray, "h w 3"], Int[np.ndarray, "n 2"]]:
    """Pack tiles into rows of one picture whose sides are multiples of 8.

    Returns the picture and the upper left pixel (column, row) of each tile. The border pixels of
    each tile are repeated in a margin of ``MARGIN`` pixels. Free space has the mean colour of the
    tiles.
    """
    sizes = np.array([[t.shape[1], t.shape[0]] for t in tiles]) + 2 * MARGIN
    width = int(max(sizes[:, 0].max(), np.sqrt(np.prod(sizes, axis=1).sum())))
    width = (width + 7) // 8 * 8
    order = sorted(range(len(tiles)), key=lambda k: (-sizes[k, 1], -sizes[k, 0], k))
    corners = np.zeros((len(tiles), 2), int)
    x = y = tall = 0
    for k in order:
        if x + sizes[k, 0] > width:
            x, y, tall = 0, y + tall, 0
        corners[k] = x, y
        x, tall = x + sizes[k, 0], max(tall, sizes[k, 1])
    height = (y + tall + 7) // 8 * 8
    atlas = np.empty((height, width, 3), np.uint8)
    atlas[:] = np.mean([tile.mean((0, 1)) for tile in tiles], axis=0).round()
    for k, tile in enumerate(tiles):
        column, row = corners[k]
        rim = np.pad(tile, ((MARGIN, MARGIN), (MARGIN, MARGIN), (0, 0)), mode="edge")
        atlas[row : row + rim.shape[0], column : column + rim.shape[1]] = rim
    return atlas, corners + MARGIN


Pieces = list[tuple[Solid, Tile]]
"""Solids, each with its tile."""


def put_down(
    pieces: Pieces, *bodies: Solid, factor: float = 1.0, opacity: float = 1.0, foot: float = 0.0
) -> Shape:
    """Return a shape made of pieces, with the hulls of ``bodies`` (by default, all) as parts.

    Points below z = 0 are flattened onto it, which gives round objects a flat base. ``foot`` is
    the lowest fraction of each part that is also flattened, so that round objects do not roll.
    """
    solids = bodies or tuple(solid for solid, _ in pieces)
    low = max(min(float(solid.bounds[0, 2]) for solid, _ in pieces), 0.0)
    parts = [hull_part(_set_down(above(solid.vertices), low, foot)) for solid in solids]
    return shape(pieces, parts, opacity).scale(factor)


def _set_down(points: Float[np.ndarray, "n 3"], low: float, share: float) -> np.ndarray:
    """Lower points to z = ``low`` if they are in the lowest fraction ``share`` of the height."""
    made = points.copy()
    made[made[:, 2] < low + share * (made[:, 2].max() - low), 2] = low
    return made


def settle(
    pieces: Pieces, flat: float = 0.06, *, hulls: Sequence[Sequence[int]] | None = None
) -> Shape:
    """Return pieces standing on z = 0, with the lowest fraction ``flat`` of the height flattened.

    ``hulls`` lists the pieces in each collision part; by default one part contains all.
    """
    low = min(float(s.bounds[0, 2]) for s, _ in pieces)
    high = max(float(s.bounds[1, 2]) for s, _ in pieces)
    down = low + flat * (high - low)
    moved = [(s.move(z=-down), tile) for s, tile in pieces]
    groups = [range(len(pieces))] if hulls is None else hulls
    return shape(moved, [hull_above(*(moved[k][0] for k in group)) for group in groups])


def serve(
    look: Look,
    dish: Solid,
    glaze: Tile,
    food: Iterable[tuple[Solid, Tile]],
) -> Shape:
    """Return food on a dish, with one collision part for the dish and one for the food."""
    food = list(food)
    return shape([(dish, glaze), *food], [hull_above(dish), hull_above(*(s for s, _ in food))])


Drawing = Callable[[Look], Pieces]
"""A function that draws the pieces of one variant of a category."""

Bodies = int | Sequence[int] | None
"""The number of leading pieces that collide, or their indices; None stands for all."""


def vessel_shape(
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
    """Return an open vessel with extra pieces and a collision part for each of ``bodies``."""
    made, parts = open_vessel(profile, wall, bottom, fine)
    more: tuple[ConvexPart, ...] = tuple(hull_part(above(b.vertices)) for b in bodies)
    return shape([(made, tile), *extra], (*parts, *more), opacity).scale(factor)


def keep_still(draw: ShapeFunction) -> ShapeFunction:
    """Add a thin, flat collision part at the bottom of each variant, so that it cannot roll."""

    @wraps(draw)
    def make(look: Look) -> Shape:
        thing = draw(look)
        points = np.concatenate([part.vertices for part in thing.parts])
        low, high = points.min(0), points.max(0)
        x, y = 0.7 * (high - low)[0], 0.9 * (high - low)[1]
        at = float(low[0] + high[0]) / 2, float(low[1] + high[1]) / 2, float(low[2])
        return replace(thing, parts=(*thing.parts, box_part(float(x), float(y), 0.003, at)))

    return make


def settle_shape(thing: Shape) -> Shape:
    """Return a shape rotated onto the stable side closest to its current underside."""
    from scipy.spatial import ConvexHull

    points = np.concatenate([part.vertices for part in thing.parts])
    hull = ConvexHull(points)
    center = _center(thing)
    span = float(np.ptp(points, axis=0).max())
    down = hull.equations[np.argsort(hull.equations[:, 2])]
    for normal, offset in zip(down[:, :3], down[:, 3], strict=True):
        turn = _turn_down(normal)
        touching = points @ normal + offset > -0.002 * span
        if _margin((points[touching] @ turn.T)[:, :2], (turn @ center)[:2]) > 0.01 * span:
            break
    else:
        return thing
    low = float((points @ turn.T)[:, 2].min())
    parts = [ConvexPart(part.vertices @ turn.T - [0, 0, low]) for part in thing.parts]
    moved = [(replace(p.solid, vertices=p.solid.vertices @ turn.T - [0, 0, low]), p.tile)
             for p in thing.pieces]  # fmt: skip
    return shape(moved, parts, thing.opacity)


def _center(thing: Shape) -> np.ndarray:
    """Return the centre of mass of a shape's solids."""
    corners = np.concatenate([p.solid.vertices[p.solid.faces] for p in thing.pieces])
    volume = np.einsum("ij,ij->i", corners[:, 0], np.cross(corners[:, 1], corners[:, 2]))
    return (volume[:, None] * corners.sum(1) / 4).sum(0) / volume.sum()


def _turn_down(normal: np.ndarray) -> np.ndarray:
    """Return the smallest rotation that makes a unit vector point straight down."""
    axis = np.cross(normal, [0, 0, -1])
    sine, cosine = float(np.linalg.norm(axis)), float(-normal[2])
    if sine < 1e-9:
        return np.eye(3) if cosine > 0 else np.diag([1.0, -1.0, -1.0])
    x, y, z = axis / sine
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + sine * cross + (1 - cosine) * cross @ cross


def _margin(ground: np.ndarray, center: np.ndarray) -> float:
    """Return the signed distance from a point to the hull of ``ground``, positive inside it."""
    from scipy.spatial import ConvexHull, QhullError

    try:
        sides = ConvexHull(ground).equations
    except (QhullError, ValueError):
        return -1.0
    return float(-(sides[:, :2] @ center + sides[:, 2]).max())


def from_pieces(
    *, foot: float = 0.0, bodies: Bodies = None, spread: float = 0.1, opacity: float = 1.0
) -> Callable[[Drawing], ShapeFunction]:
    """Make a shape function from a function that returns pieces.

    Args:
        foot: the lowest fraction of each convex part that is flattened.
        bodies: the number of leading pieces that collide, or their indices; None means all.
        spread: the fraction by which the size of variants varies.
        opacity: the opacity of the whole object.
    """

    def decorate(draw: Drawing) -> ShapeFunction:
        @wraps(draw)
        def make(look: Look) -> Shape:
            factor = look.between(1 - spread, 1 + spread)
            pieces = draw(look)
            chosen = range(len(pieces) if bodies is None else bodies) if (
                bodies is None or isinstance(bodies, int)) else bodies  # fmt: skip
            solids = [pieces[k][0] for k in chosen]
            return put_down(pieces, *solids, factor=factor, foot=foot, opacity=opacity)

        return make

    return decorate


def in_sizes(spread: float) -> Callable[[ShapeFunction], ShapeFunction]:
    """Scale each variant by a random factor between 1 - ``spread`` and 1 + ``spread``."""

    def decorate(draw: ShapeFunction) -> ShapeFunction:
        @wraps(draw)
        def make(look: Look) -> Shape:
            made = draw(look)
            return made.scale(look.between(1 - spread, 1 + spread))

        return make

    return decorate


def vary(sizes: float = 0.15, shades: float = 0.12) -> Callable[[ShapeFunction], ShapeFunction]:
    """Vary the size and the shade of variants by up to the given fractions."""

    def decorate(draw: ShapeFunction) -> ShapeFunction:
        @wraps(draw)
        def make(look: Look) -> Shape:
            made = draw(look).scale(look.between(1 - sizes, 1 + sizes))
            light, warm = look.between(1 - shades, 1 + shades), look.between(-0.4, 0.4) * shades
            tint = light * np.array([1 + warm, 1, 1 - warm])
            pieces = tuple(Piece(p.solid, np.clip(p.tile * tint, 0, 255).round().astype(np.uint8))
                           for p in made.pieces)  # fmt: skip
            return replace(made, pieces=pieces)

        return make

    return decorate


def at_rest(draw: ShapeFunction) -> ShapeFunction:
    """Rotate each variant onto the stable side closest to its underside."""

    @wraps(draw)
    def make(look: Look) -> Shape:
        return settle_shape(draw(look))

    return make


# -------------------------------------------------------------------------------- categories


@dataclass(frozen=True, eq=False)
class Category:
    """A kind of object, with its drawing function and properties.

    Attributes:
        key: unique name, which also seeds the variants ("soup_can").
        shape: draws one variant in metres.
        size: nominal extent (length x, depth y, height z) in metres in the usual pose.
        mass: kilograms at the nominal size.
        material: one of ``FRICTION``.
        hollow: its walls have a constant thickness, so mass grows with the surface area.
        assembled: it is made of parts, so all variants have about the same mass.
        friction: sliding friction coefficient; by default the material's.
        aliases: other names, singular.
        themes: themes of scenes with this object; the first one is the folder of its module.
        roles: "container" (holds objects), "support" (carries objects), "flat", "tall", "round" (no
            front), "big" (too wide for a small gripper), "edible", "screen".
        colors: usual colours.
        state: how the object stands or lies.
        noun: name in a sentence; by default the key with spaces for underscores.
        opened: key of the open or empty category to use when something is put inside.
        holder: the row of slots, if it is a rack.
        common: whether it may appear on random tables.
    """

    key: str
    shape: ShapeFunction
    _: KW_ONLY
    size: Extent
    mass: float
    material: str = "wood"
    hollow: bool = False
    assembled: bool = False
    friction: float | None = None
    aliases: tuple[str, ...] = ()
    themes: tuple[str, ...] = ()
    roles: tuple[str, ...] = ()
    colors: tuple[str, ...] = ()
    state: str = "standing upright"
    noun: str = ""
    opened: str = ""
    holder: Holder | None = None
    common: bool = False

    def __post_init__(self) -> None:
        if self.material not in FRICTION:
            raise InputError(f"{self.key}: unknown material {self.material!r}." + choices(
                self.material, FRICTION))  # fmt: skip
        if not self.noun:
            object.__setattr__(self, "noun", self.key.replace("_", " "))

    def __call__(self, look: Look) -> Shape:
        """Draw one variant."""
        return self.shape(look)

    @property
    def sliding_friction(self) -> float:
        """The sliding friction coefficient; by default, that of the material."""
        return FRICTION[self.material] if self.friction is None else self.friction

    @property
    def growth(self) -> float:
        """The power of the bounding box's volume to which a variant's mass is proportional."""
        if self.assembled or self.material == "device":
            return 0.0
        return 2 / 3 if self.hollow else 1.0

    @property
    def container(self) -> bool:
        """Whether other objects can be put into the object."""
        return "container" in self.roles

    @property
    def ball(self) -> bool:
        """Whether the object is round and about as wide as it is high, so that it rolls."""
        full = "round" in self.roles and not self.container
        return full and max(self.size) < 1.3 * min(self.size)

    @property
    def density(self) -> float:
        """The density, in kg/m^3, for generated meshes, assuming that they fill 2/5 of the box."""
        return float(np.clip(self.mass / (0.4 * np.prod(self.size)), 20.0, 8000.0))


def _declaring(
    make: Callable[Concatenate[str, ShapeFunction, P], Category],
) -> Callable[Concatenate[str, P], Callable[[ShapeFunction], Category]]:
    def declare(key: str, *args: P.args, **facts: P.kwargs) -> Callable[[ShapeFunction], Category]:
        return lambda draw: make(key, draw, *args, **facts)

    return declare


category = _declaring(Category)
"""Decorator that turns a drawing function into a category, given its key and other properties."""
