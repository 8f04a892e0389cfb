"""A foreign scene as one of this project: canonical models, mass, settled and judged."""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from dataclasses import replace

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from ..errors import InputError, SceneError
from ..geometry import (
    convex_outline,
    inside_margin,
    parts_to_unit_box,
    quaternion_matrix,
    quaternion_yaw,
    to_unit_box,
)
from ..language.naming import find_category
from ..layout.checking import correct_supports, observe
from ..meshes.coloring import best_size, own_texture, painted_faces
from ..meshes.normalising import Normal, foreign_physics, normal_surface
from ..meshes.reading.surface import ColoredSurface
from ..method.assembly import AssemblyConfig, reassemble, table_body
from ..physics.inertia import MassProperties, body_mass
from ..physics.parts import body_parts, model_parts
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
from .foreign import ForeignBody, ForeignScene, check_count

_MOST_FACES = 24_000  # triangles of a body that stay as they are
_TEXTURE = 1024  # side of a texture made again, texels
_RIM = 0.01  # metres below a container's rim from which a thing is in it
_ROUNDS = 20  # objects left out, one after the other
_DENSITY = (1.0, 29_000.0)  # kg/m³, of what its mass says


def build_scene(
    foreign: ForeignScene,
    provenance: Provenance,
    name: str,
    config: AssemblyConfig | None = None,
    leave_out: bool = False,
) -> Scene:
    """Return a foreign scene settled and judged; its report may have failed.

    The world moves so that the table stands on the floor z = 0 in the middle. Objects keep their
    places to the bit unless settling moves them. ``leave_out`` leaves out, one after the other, the
    objects that a failed gate names.

    Raises:
        InputError: too many objects, or numbers that no scene holds.
        SceneError: a shape cannot be decomposed, or no object is left.
    """
    check_count(len(foreign.objects))
    table, shift = _build_table(foreign.table)
    names = _free_names([body.name for body in foreign.objects])
    objects = [
        _build_object(replace(body, position=body.position + shift), name)
        for body, name in zip(foreign.objects, names, strict=True)
    ]
    provenance = replace(provenance, warnings=(*provenance.warnings, *foreign.warnings))
    scene = Scene(name, table, tuple(objects), provenance)
    done = reassemble(scene, scene, (), config)
    dropped: list[str] = []
    while leave_out and len(dropped) < _ROUNDS and (worst := _find_failing(done)):
        dropped.append(worst)
        left = tuple(o for o in scene.objects if o.name not in dropped)
        if not left:
            raise SceneError("No object of the scene comes to rest on its table.")
        scene = scene.replace(objects=left)
        done = reassemble(scene, scene, (), config)
    if dropped and done.report is not None:
        told = tuple(f"{name} was left out: the gate failed" for name in dropped)
        provenance = replace(done.provenance, warnings=(*done.provenance.warnings, *told))
        report = replace(done.report, dropped=tuple(sorted(dropped)))
        done = done.replace(provenance=provenance, report=report)
    return _mark_inside(correct_supports(done, observe(done)))


def _find_failing(scene: Scene) -> str | None:
    """Return the object that the report's failures name most."""
    failures = scene.report.failures if scene.report else ()
    counts = Counter(name for failure in failures for name in failure.objects)
    named = (o.name for o in scene.objects if counts[o.name])
    return max(named, key=lambda name: counts[name], default=None)


# ------------------------------------------------------------------------------------------ bodies


def _build_table(body: ForeignBody) -> tuple[Table, Float[np.ndarray, "3"]]:
    """Return the table, and by how much the world moves so that it stands in the middle."""
    rotation = body.rotation
    surface = replace(body.surface, vertices=body.surface.vertices @ rotation.T + body.position)
    mesh = _draw(surface, body)
    unit, center, extent = to_unit_box(mesh)
    moved = tuple(_move(part, rotation, body.position) for part in body.parts)
    friction = 0.6 if body.friction is None else body.friction
    model = Model(
        TABLE, TABLE, unit, extent, Physics(600.0, _slide(friction)),
        parts_to_unit_box(moved, center, extent), TABLE,
    )  # fmt: skip
    return table_body(model, extent), -np.array([center[0], center[1], center[2] - extent[2] / 2])


def _build_object(body: ForeignBody, name: str) -> Object:
    """Return an object whose +z is the axis of its body that points up most."""
    turn = _upright(body.rotation)
    surface = replace(body.surface, vertices=body.surface.vertices @ turn.T)
    mesh = _draw(surface, body)
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
    parts = model_parts(model, extent) if moved else body_parts(model, extent)
    weighed = _weigh(body, model, parts, turn, center)
    reckoned = body_mass(unit, extent, physics, parts).mass
    density = float(np.clip(physics.density * weighed.mass / reckoned, *_DENSITY))
    model = replace(model, physics=replace(physics, density=density))
    placement = Placement(name, quaternion_yaw(quaternion), position, extent)
    return Object(
        name, model, placement, parts, weighed.mass, weighed.com, weighed.inertia,
        physics.friction, Pose(position, quaternion),
    )  # fmt: skip


def _weigh(
    body: ForeignBody,
    model: Model,
    parts: Sequence[ConvexPart],
    turn: Float[np.ndarray, "3 3"],
    center: Float[np.ndarray, "3"],
) -> MassProperties:
    """Return the mass that is said, else the category's, in the object's frame."""
    if body.mass is not None:
        given = body.mass
        return MassProperties(given.mass, turn @ given.com - center, turn @ given.inertia @ turn.T)
    made = body_mass(model.mesh, model.size, model.physics, parts)
    if body.weight is None:
        return made
    return MassProperties(body.weight, made.com, made.inertia * (body.weight / made.mass))


def _draw(surface: ColoredSurface, body: ForeignBody) -> Mesh:
    """Return a surface as one textured mesh; repaired and reduced only where it has to be."""
    if not body.parts or len(surface.faces) > _MOST_FACES:
        return normal_surface(
            surface, f"The mesh of {body.name!r}", up="z", to=Normal(texture=_TEXTURE)
        )
    sound = areas(surface.vertices, surface.faces) > 0
    surface = surface.keep(sound)
    if not len(surface.faces):
        raise InputError(f"The mesh of {body.name!r} has only triangles without area.")
    size = best_size(surface, _TEXTURE, len(surface.faces))
    return own_texture(surface) or painted_faces(surface, size)


def _upright(rotation: Float[np.ndarray, "3 3"]) -> Float[np.ndarray, "3 3"]:
    """Return the turn of a body's axes that makes +z the one that points up most."""
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
    """Return a part turned and shifted: a hull unless the turn takes axes to axes."""
    vertices = part.vertices @ turn.T + shift
    if part.kind == "hull" or np.abs(np.abs(turn) - np.abs(turn).round()).max() > 1e-6:
        return ConvexPart(vertices)
    return ConvexPart(vertices, part.kind, (0, 1, 2)[int(np.abs(turn[:, part.axis]).argmax())])


def _slide(friction: float) -> float:
    return float(np.clip(friction, 0.01, 4.9))


# ------------------------------------------------------------------------------------------- names


def _label(name: str) -> str:
    """Return the words of a name: "coffee_mug_2" is a coffee mug."""
    words = "".join(c if c.isalpha() else " " for c in name).split()
    return " ".join(words).lower()[:80] or "thing"


def _free_names(names: Sequence[str]) -> list[str]:
    """Return names that objects of a scene may have, each once; those that may be so stay."""
    taken = {TABLE, "world"}
    found = []
    for given in names:
        plain = "".join(c if c.isprintable() and c != "/" else "_" for c in given)[:100]
        word, number = plain or "thing", 1
        name = word if plain and plain not in taken else f"{word}_{number}"
        while name in taken:
            number += 1
            name = f"{word}_{number}"
        taken.add(name)
        found.append(name)
    return found


def _mark_inside(scene: Scene) -> Scene:
    """Return the scene with what lies in a container, below its rim, marked so."""
    things = {o.name: o for o in scene.objects}
    marked = []
    for thing in scene.objects:
        holder = things.get(thing.placement.on)
        if holder is not None and holder.model.container and _is_inside(thing, holder):
            thing = replace(thing, placement=replace(thing.placement, inside=True))
        marked.append(thing)
    return scene.replace(objects=tuple(marked))


def _is_inside(thing: Object, holder: Object) -> bool:
    own, about = _points(thing), _points(holder)
    middle = (own.min(0) + own.max(0))[None, :2] / 2
    within = float(inside_margin(middle, convex_outline(about[:, :2]))[0]) > 0
    return within and own[:, 2].min() < about[:, 2].max() - _RIM


def _points(thing: Object) -> Float[np.ndarray, "n 3"]:
    points = np.concatenate([part.vertices for part in thing.parts])
    return points @ quaternion_matrix(thing.pose.quaternion).T + thing.pose.position
