"""Conversion of a foreign body to an object or a table: its model, collision shape and mass.

Bodies that cannot be repaired are still imported: a torn surface is drawn unchanged, and a surface
that cannot be decomposed collides as its convex hull.
"""

from __future__ import annotations

import hashlib
from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from tabletop_objects import find_category
from tabletop_objects.values import parts_to_unit_box, to_unit_box

from ..errors import BackendError, InputError, SceneError
from ..geometry import quaternion_yaw
from ..meshes.canonical import Normal, foreign_physics, repair_surface
from ..meshes.reading.surface import ColoredSurface
from ..meshes.repair import thicken
from ..meshes.texture import best_size, own_texture, painted_faces
from ..method.assembly import table_body
from ..physics.decomposition import CutBudget
from ..physics.inertia import MassProperties, body_mass
from ..physics.parts import body_parts, model_parts
from ..physics.spec import compile_spec, scene_spec
from ..scene import (
    TABLE,
    ConvexPart,
    Mesh,
    Model,
    Object,
    Physics,
    Placement,
    Pose,
    Provenance,
    Scene,
    Table,
)
from ..scene.triangles import areas
from .foreign import DENSITY, LARGEST, ForeignBody, ImportOutcome
from .shapes import few_corners

_MOST_FACES = 24_000  # number of triangles up to which a body is not simplified
_TEXTURE = 1024  # side of a regenerated texture, texels
_MOST_SIDE, _LEAST_SIDE, _MOST_TABLE = 5.0, 5e-4, 20.0  # metres, of an object's longest side
_MASSES = (1e-9, 1e3)  # kilograms, of an object
_USUAL_SIDE = (3e-3, 1.5)  # metres, of objects on a table: target range of a suggested scale


def build_table(
    body: ForeignBody, drawn: SurfaceCache, budget: CutBudget
) -> tuple[Table, Float[np.ndarray, "3"], ImportOutcome]:
    """Return the table, the translation of the world that centres it, and its import outcome.

    Raises:
        InputError: the table is too large.
        BackendError: its surface cannot be drawn.
    """
    _check_side(body, "The table", 0.0, _MOST_TABLE)
    rotation = body.rotation
    surface = replace(body.surface, vertices=body.surface.vertices @ rotation.T + body.position)
    mesh, repairs = drawn.draw(surface, body)
    unit, center, extent = to_unit_box(mesh)
    moved = tuple(_move(part, rotation, body.position) for part in body.parts)
    friction = 0.6 if body.friction is None else body.friction
    model = Model(
        TABLE, TABLE, unit, extent, Physics(600.0, _slide(friction)),
        parts_to_unit_box(moved, center, extent), TABLE,
    )  # fmt: skip
    model, reason = _solid(model, extent, budget)
    shift = -np.array([center[0], center[1], center[2] - extent[2] / 2])
    return table_body(model, extent, budget), shift, _outcome(TABLE, repairs, reason)


def build_object(
    body: ForeignBody, name: str, table: Table, drawn: SurfaceCache, budget: CutBudget
) -> tuple[Object, ImportOutcome]:
    """Return an object whose +z is the body axis nearest to pointing up, and its import outcome.

    Raises:
        InputError: the size or mass is out of range.
        BackendError: the surface cannot be drawn.
        SceneError: MuJoCo rejects the shape or inertia.
    """
    _check_side(body, repr(name), _LEAST_SIDE, _MOST_SIDE)
    turn = _upright(body.rotation)
    surface = replace(body.surface, vertices=body.surface.vertices @ turn.T)
    mesh, repairs = drawn.draw(surface, body)
    unit, center, extent = to_unit_box(mesh)
    rotation = body.rotation @ turn.T
    quaternion = Rotation.from_matrix(rotation).as_quat(canonical=True, scalar_first=True)
    position = body.position + rotation @ center
    label = _label(body.category or name)
    kind = find_category(label)
    moved = tuple(_move(part, turn, -center) for part in body.parts)
    physics = foreign_physics(mesh, extent, kind)
    if body.friction is not None:
        physics = replace(physics, friction=_slide(body.friction))
    model = Model(
        label, label, unit, extent, physics, parts_to_unit_box(moved, np.zeros(3), extent),
        kind.key if kind else "generic", bool(kind and kind.container),
    )  # fmt: skip
    model, reason = _solid(model, extent, budget)
    parts = (model_parts if moved else body_parts)(model, extent, budget)
    weighed = _weigh(body, model, parts, turn, center)
    _check_mass(name, weighed.mass, extent)
    reckoned = body_mass(unit, extent, physics, parts).mass
    density = float(np.clip(physics.density * weighed.mass / reckoned, *DENSITY))
    model = replace(model, physics=replace(physics, density=density))
    placement = Placement(name, quaternion_yaw(quaternion), position, extent)
    thing = Object(
        name, model, placement, parts, weighed.mass, weighed.com, weighed.inertia,
        physics.friction, Pose(position, quaternion),
    )  # fmt: skip
    alone = Scene("import", table, (thing,), Provenance("manual", 0))
    compile_spec(scene_spec(alone, visuals=False), f"import of {name}")
    return thing, _outcome(name, repairs, reason)


def _outcome(name: str, repairs: Sequence[str], reason: str) -> ImportOutcome:
    if reason:
        return ImportOutcome(name, "hull", "; ".join((reason, *repairs)))
    return ImportOutcome(name, "repaired", "; ".join(repairs)) if repairs else ImportOutcome(name)


# ------------------------------------------------------------------------------------------- sizes


@dataclass(frozen=True)
class _Side:
    """The length of a body's longest side, in metres, and the word for it: "tall" or "long"."""

    length: float
    word: str

    def hint(self) -> str:
        """Return advice to use a scale at which the size is plausible, or "" if there is none."""
        low, high = _USUAL_SIDE
        factors = (1e-3, 1e-2, 10.0, 100.0, 1000.0)
        fitting = (f for f in factors if low <= f * self.length <= high)
        factor = next(fitting, None)
        return "" if factor is None else f", try --scale {factor:g}"

    def __str__(self) -> str:
        return f"{self.length:.3g} m {self.word}"


def _longest(extent: Float[np.ndarray, "3"]) -> _Side:
    axis = int(extent.argmax())
    return _Side(float(extent[axis]), "tall" if axis == 2 else "long")


def _check_side(body: ForeignBody, what: str, least: float, most: float) -> None:
    """Check the size and position of a body.

    Raises:
        InputError: the longest side is out of range, or the body is too far away.
    """
    side = _longest(np.ptp(body.surface.vertices @ body.rotation.T, axis=0))
    if not least <= side.length <= most:
        raise InputError(
            f"{what} is {side}{side.hint()}; the longest side must be in [{least:g}, {most:g}] m."
        )
    far = float(np.abs(body.position).max() + np.abs(body.surface.vertices).max())
    if far > LARGEST:
        raise InputError(
            f"{what} extends beyond {LARGEST:g} m from the origin; lengths must be in metres."
        )


def _check_mass(name: str, mass: float, extent: Float[np.ndarray, "3"]) -> None:
    if not _MASSES[0] <= mass < _MASSES[1]:
        side = _longest(extent)
        raise InputError(
            f"{name!r} is {side}, and has a mass of {mass:.3g} kg{side.hint()}; the mass must be "
            f"in [{_MASSES[0]:g}, {_MASSES[1]:g}) kg."
        )


# ------------------------------------------------------------------------------------------ shapes


class SurfaceCache:
    """Caches textured meshes by the content of their surfaces, so that bodies can share a mesh."""

    def __init__(self) -> None:
        self._meshes: dict[bytes, tuple[Mesh, tuple[str, ...]]] = {}

    def draw(self, surface: ColoredSurface, body: ForeignBody) -> tuple[Mesh, tuple[str, ...]]:
        """Return a body's surface as one textured mesh, and the repairs made to it.

        Raises:
            InputError: all its triangles have zero area.
            BackendError: it can neither be repaired nor drawn unchanged.
        """
        key = _digest(surface, bool(body.parts))
        if key not in self._meshes:
            self._meshes[key] = _draw(surface, body)
        return self._meshes[key]


def _digest(surface: ColoredSurface, solid: bool) -> bytes:
    """Return the sha256 of the inputs of ``_draw``."""
    digest = hashlib.sha256(repr((solid, surface.opacity)).encode())
    columns = (surface.vertices, surface.faces, surface.uv, surface.colors, surface.picture)
    for array in (*columns, *surface.pictures):
        digest.update(repr((array.shape, array.dtype.str)).encode())
        digest.update(np.ascontiguousarray(array).data)
    return digest.digest()


def _draw(surface: ColoredSurface, body: ForeignBody) -> tuple[Mesh, tuple[str, ...]]:
    """Return a surface as one textured mesh, and the repairs made.

    It is repaired and simplified only if necessary. If that fails, it is drawn unchanged.
    """
    if body.parts and len(surface.faces) <= _MOST_FACES:
        return _as_it_is(surface, body), ()
    surface, thickness = thicken(surface)
    repairs = (f"thin sheet thickened to {1e3 * thickness:.2g} mm",) if thickness else ()
    try:
        mesh, more = repair_surface(surface, "The surface", Normal(texture=_TEXTURE))
    except BackendError as error:
        if len(surface.faces) > _MOST_FACES:
            raise
        return _as_it_is(surface, body), (*repairs, f"drawn unrepaired: {error}")
    return mesh, (*repairs, *more)


def _as_it_is(surface: ColoredSurface, body: ForeignBody) -> Mesh:
    sound = areas(surface.vertices, surface.faces) > 0
    surface = surface.keep(sound)
    if not len(surface.faces):
        raise InputError(f"The mesh of {body.name!r} has only zero-area triangles.")
    size = best_size(surface, _TEXTURE, len(surface.faces))
    return own_texture(surface) or painted_faces(surface, size)


def _solid(model: Model, extent: Float[np.ndarray, "3"], budget: CutBudget) -> tuple[Model, str]:
    """Return the model, with its hull as a part if decomposition fails, and the reason or ""."""
    if model.parts:
        return model, ""
    try:
        body_parts(model, extent, budget)
    except SceneError as error:
        hull = ConvexPart(few_corners(model.mesh.vertices.astype(np.float64)))
        return replace(model, parts=(hull,)), str(error)
    return model, ""


def _weigh(
    body: ForeignBody,
    model: Model,
    parts: Sequence[ConvexPart],
    turn: Float[np.ndarray, "3 3"],
    center: Float[np.ndarray, "3"],
) -> MassProperties:
    """Return the mass properties in the object's frame, as given or derived from the category."""
    if body.mass is not None:
        given = body.mass
        return MassProperties(given.mass, turn @ given.com - center, turn @ given.inertia @ turn.T)
    made = body_mass(model.mesh, model.size, model.physics, parts)
    if body.weight is None:
        return made
    return MassProperties(body.weight, made.com, made.inertia * (body.weight / made.mass))


def _upright(rotation: Float[np.ndarray, "3 3"]) -> Float[np.ndarray, "3 3"]:
    """Return the rotation that maps the body axis nearest to pointing up onto +z."""
    up = rotation[2]
    axis = int(np.abs(up).argmax())
    if axis == 2 and up[2] > 0:
        return np.eye(3)
    z = np.eye(3)[axis] * np.sign(up[axis])
    x = np.eye(3)[(axis + 1) % 3]
    return np.stack([x, np.cross(z, x), z])


def _move(
    part: ConvexPart, turn: Float[np.ndarray, "3 3"], shift: Float[np.ndarray, "3"]
) -> ConvexPart:
    """Return a rotated and translated part, as a hull unless the rotation maps axes to axes."""
    vertices = part.vertices @ turn.T + shift
    if part.kind == "hull" or np.abs(np.abs(turn) - np.abs(turn).round()).max() > 1e-6:
        return ConvexPart(vertices)
    return ConvexPart(vertices, part.kind, (0, 1, 2)[int(np.abs(turn[:, part.axis]).argmax())])


def _slide(friction: float) -> float:
    return float(np.clip(friction, 0.01, 4.9))


def _label(name: str) -> str:
    """Return the words of a name: "coffee_mug_2" becomes "coffee mug"."""
    words = "".join(c if c.isalpha() else " " for c in name).split()
    return " ".join(words).lower()[:80] or "thing"
