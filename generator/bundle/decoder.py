"""Decoding of a scene from ``scene.json``: bounded, strictly typed, and with known fields only."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from ..errors import BundleError
from ..io.bounded import parse_object, printable
from ..physics.mjcf import mesh_path, texture_path
from ..scene import MAX_LEAN, TABLE, Failure, Mesh, Model, Object, Report, Scene, Table
from .bounds import BOUNDS, check_counts, check_drawn
from .contents import decode_obj, decode_png, mesh_counts, picture_size
from .encoder import HIDDEN
from .fields import arguments, default_fields

_ESCAPE = re.compile(rb"(?<!\\)(?:\\\\)*\\(?:u00[01]|[bfr])")  # as ``dumps`` writes control codes
_BESIDE_THE_SCENE = ("schema", "files", "instances")
_Looks = tuple[str, str, float]  # paths of mesh and texture, and opacity


@dataclass(frozen=True, eq=False)
class Decoded:
    """A scene, and the mesh and texture paths of its bodies."""

    scene: Scene
    paths: Mapping[Mesh, tuple[str, str]]


def loads(raw: bytes, where: str) -> dict[str, Any]:
    """Parse ``scene.json``.

    Raises:
        BundleError: it is not a JSON object, or it contains a number that is not finite, or a text
            with terminal control characters.
    """
    what = f"{where}: scene.json"
    payload = parse_object(raw, what, BundleError, max_bytes=BOUNDS.truth_bytes)
    if (b"\\" in raw and _ESCAPE.search(raw)) or (
        (b"\x7f" in raw or not raw.isascii()) and HIDDEN.search(raw.decode())
    ):
        raise BundleError(f"{what} contains strings with unprintable characters.")
    return payload


def decode_scene(payload: Mapping[str, Any], file: Callable[[str], bytes]) -> Decoded:
    """Decode the result of ``encode_scene``; ``file`` returns a file's content for its path.

    Raises:
        BundleError: the scene is out of bounds, or a field, a mesh or a texture is not as it was
            encoded.
        InputError: a value violates its own constraints.
    """
    check_counts(dict(payload))
    entry = arguments(
        Scene, {k: v for k, v in payload.items() if k not in _BESIDE_THE_SCENE}, "scene.json",
        table=Any, objects=tuple[Any, ...], models=Mapping[str, Any], report=Any,
    )  # fmt: skip
    models = {
        key: arguments(
            Model, model, f"scene.json.models[{key[:40]!r}]",
            frozenset({"stand_in"}), mesh=str, texture=str, opacity=float, orientation=None,
            slots=None,
        )
        for key, model in entry.pop("models").items()
    }  # fmt: skip
    table = arguments(Table, entry["table"], "scene.json.table", model=str)
    objects = [
        arguments(Object, thing, f"scene.json.objects[{k}]", model=str)
        for k, thing in enumerate(entry["objects"])
    ]
    bodies: list[str] = [body["model"] for body in (table, *objects)]
    _check_models(models, bodies)
    for thing in objects:
        if thing["placement"].name != thing["name"]:
            raise BundleError(
                f"The placement of {thing['name'][:80]!r} has the name of another object."
            )
    looks = {
        key: (model["mesh"], model.pop("texture"), model.pop("opacity"))
        for key, model in models.items()
    }
    meshes = _meshes(looks, bodies, file)
    made: dict[str, Model] = {}
    for key, model in models.items():
        for word in (model["name"], model["label"], model["category"]):
            printable(word, "A name in scene.json", BundleError)
        model["mesh"] = meshes[looks[key]]
        made[key] = Model(**model)
    for body in (table, *objects):
        body["model"] = made[body["model"]]
    entry |= {"table": Table(**table), "objects": tuple(Object(**thing) for thing in objects)}
    entry["report"] = _decode_report(entry["report"])
    scene = Scene(**entry)
    _check_supports(scene)
    return Decoded(scene, {mesh: looks[:2] for looks, mesh in meshes.items()})


def _decode_report(entry: object) -> Report | None:
    """Return a report; failures without values, from an earlier version, are kept as text."""
    if entry is None:
        return None
    what = "scene.json.report"
    hints = {"failures": tuple[str, ...], "failure_values": tuple[Failure, ...]}
    fields = arguments(Report, entry, what, default_fields(Report) | {"failure_values"}, **hints)
    failures: tuple[Failure, ...] | None = fields.pop("failure_values", None)
    if failures is None:
        failures = tuple(Failure("recorded", sentence=text) for text in fields.get("failures", ()))
    if len(failures) != len(fields.get("failures", ())):
        raise BundleError(f"{what}.failure_values must have as many entries as its failures.")
    fields["failures"] = failures
    lean: float | None = fields.get("lean")
    if lean is not None and not 0 <= lean <= np.deg2rad(MAX_LEAN):
        raise BundleError(f"{what}.lean must be an angle in [0, {np.deg2rad(MAX_LEAN):.6g}] rad.")
    return Report(**fields)


def _check_models(models: Mapping[str, Any], used: Sequence[str]) -> None:
    """Check that the models listed are exactly those used."""
    for key in used:
        if key not in models:
            raise BundleError(
                f"scene.json refers to the model {key[:80]!r}, which it does not contain."
            )
    if unused := sorted(models.keys() - set(used)):
        raise BundleError(f"scene.json has an unused model: {unused[0][:80]!r}.")


def _meshes(
    looks: Mapping[str, _Looks], bodies: list[str], file: Callable[[str], bytes]
) -> dict[_Looks, Mesh]:
    """Return the textured meshes of the models; each file is decoded only once."""
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
                raise BundleError(
                    f"The file name {name[:200]!r} does not match the digest of the file's content."
                )
    surfaces = {name: decode_obj(raw, name) for name, raw in shapes.items()}
    meshes: dict[_Looks, Mesh] = {}
    for name, raw in pictures.items():
        texture = decode_png(raw, name)
        for shape, picture, opacity in sorted(different):
            if picture == name:
                meshes[shape, picture, opacity] = Mesh(*surfaces[shape], texture, opacity)
    return meshes


def _check_supports(scene: Scene) -> None:
    """Check that no object supports itself, directly or indirectly."""
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
