"""A scene from the JSON of ``scene.json``: bounded, strictly typed, known fields only."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Float

from ..errors import BundleError
from ..io.reading import parse_object, printable
from ..physics.mjcf import mesh_path, texture_path
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
    Report,
    Scene,
    ScenePlan,
    Table,
    View,
)
from .bounds import BOUNDS, check_counts, check_drawn
from .contents import decode_obj, decode_png, mesh_counts, picture_size
from .encoding import HIDDEN
from .fields import make

_ESCAPE = re.compile(rb"(?<!\\)(?:\\\\)*\\(?:u00[01]|[bfr])")
"""Controls as ``dumps`` writes them."""

_BESIDE_THE_SCENE = ("schema", "files", "instances")


@dataclass(frozen=True)
class _Model:
    name: str
    label: str
    mesh: str
    texture: str
    opacity: float
    size: Float[np.ndarray, "3"]
    physics: Physics
    parts: tuple[ConvexPart, ...]
    category: str
    container: bool
    stand_in: bool = False


@dataclass(frozen=True)
class _Table:
    model: str
    scale: Float[np.ndarray, "3"]
    parts: tuple[ConvexPart, ...]
    outline: Float[np.ndarray, "k 2"]
    friction: float


@dataclass(frozen=True)
class _Object:
    name: str
    model: str
    placement: Placement
    parts: tuple[ConvexPart, ...]
    mass: float
    com: Float[np.ndarray, "3"]
    inertia: Float[np.ndarray, "3 3"]
    friction: float
    pose: Pose


@dataclass(frozen=True)
class _Scene:
    name: str
    table: _Table
    objects: tuple[_Object, ...]
    models: Mapping[str, _Model]
    provenance: Provenance
    view: View
    report: Report | None
    plan: ScenePlan | None


@dataclass(frozen=True, eq=False)
class Decoded:
    """A scene, and the paths of mesh and texture of everything that it draws."""

    scene: Scene
    paths: Mapping[Mesh, tuple[str, str]]


def loads(raw: bytes, where: str) -> dict[str, Any]:
    """Parse ``scene.json``.

    Raises:
        BundleError: it is not a JSON object, holds a number that is not finite, or a text that
            would change a terminal that shows it.
    """
    what = f"{where}: scene.json"
    payload = parse_object(raw, what, BundleError, max_bytes=BOUNDS.truth_bytes)
    if (b"\\" in raw and _ESCAPE.search(raw)) or (
        (b"\x7f" in raw or not raw.isascii()) and HIDDEN.search(raw.decode())
    ):
        raise BundleError(f"{what} holds texts with characters that cannot be printed.")
    return payload


def decode_scene(payload: Mapping[str, Any], file: Callable[[str], bytes]) -> Decoded:
    """Return the scene of ``encode_scene``; ``file`` gives the content of a file by path.

    Raises:
        BundleError: it is out of bounds, or a field, a mesh or a texture is not as written.
        InputError: the values' own checks refuse it.
    """
    check_counts(dict(payload))
    entry = make(
        _Scene, {k: v for k, v in payload.items() if k not in _BESIDE_THE_SCENE}, "scene.json"
    )
    bodies = [entry.table.model, *(thing.model for thing in entry.objects)]
    for key in bodies:
        if key not in entry.models:
            raise BundleError(f"scene.json uses the model {key[:80]!r}, which it does not have.")
    if unused := sorted(entry.models.keys() - set(bodies)):
        raise BundleError(f"scene.json has a model that nothing is: {unused[0][:80]!r}.")
    for thing in entry.objects:
        if thing.placement.name != thing.name:
            raise BundleError(f"The object {thing.name[:80]!r} has the placement of another.")
    meshes = _meshes(entry, bodies, file)
    models = {key: _model(model, meshes[_looks(model)]) for key, model in entry.models.items()}
    table = {k: v for k, v in vars(entry.table).items() if k != "model"}
    scene = Scene(
        name=entry.name,
        table=Table(model=models[entry.table.model], **table),
        objects=tuple(
            Object(**dict[str, Any](vars(o), model=models[o.model])) for o in entry.objects
        ),
        provenance=entry.provenance,
        view=entry.view,
        report=entry.report,
        plan=entry.plan,
    )
    _check_supports(scene)
    return Decoded(scene, {mesh: looks[:2] for looks, mesh in meshes.items()})


def _looks(model: _Model) -> tuple[str, str, float]:
    return model.mesh, model.texture, model.opacity


def _meshes(
    entry: _Scene, bodies: list[str], file: Callable[[str], bytes]
) -> dict[tuple[str, str, float], Mesh]:
    """Return the textured meshes that the models share, each file decoded once."""
    looks = {key: _looks(model) for key, model in entry.models.items()}
    shapes = {shape: file(shape) for shape, _, _ in looks.values()}
    pictures = {picture: file(picture) for _, picture, _ in looks.values()}
    counts = {name: mesh_counts(raw) for name, raw in shapes.items()}
    sizes = {name: picture_size(raw, name) for name, raw in pictures.items()}
    different = set(looks.values())
    check_drawn(
        [counts[shape] for shape, _, _ in different],
        [counts[looks[key][0]] for key in bodies],
        [sizes[picture][0] * sizes[picture][1] for _, picture, _ in different],
    )
    for path_of, contents in ((mesh_path, shapes), (texture_path, pictures)):
        for name, raw in contents.items():
            if path_of(raw) != name:
                raise BundleError(f"{name[:200]!r} is not named by its content.")
    surfaces = {name: decode_obj(raw, name) for name, raw in shapes.items()}
    meshes: dict[tuple[str, str, float], Mesh] = {}
    for name, raw in pictures.items():
        texture = decode_png(raw, name)
        for shape, picture, opacity in sorted(different):
            if picture == name:
                meshes[shape, picture, opacity] = Mesh(*surfaces[shape], texture, opacity)
    return meshes


def _model(entry: _Model, mesh: Mesh) -> Model:
    for word in (entry.name, entry.label, entry.category):
        printable(word, "A name in scene.json", BundleError)
    return Model(
        name=entry.name, label=entry.label, mesh=mesh, size=entry.size, physics=entry.physics,
        parts=entry.parts, category=entry.category, container=entry.container,
    )  # fmt: skip


def _check_supports(scene: Scene) -> None:
    """Check that nothing stands on itself, by however many others."""
    on = {thing.name: thing.placement.on for thing in scene.objects}
    for name in on:
        below, seen = on[name], {name}
        while below in on:
            if below in seen:
                raise BundleError(f"{name!r} stands on itself.")
            seen.add(below)
            below = on[below]
        if below != TABLE:
            printable(below, f"What {name!r} stands on", BundleError)
