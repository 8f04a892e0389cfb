"""Encoding of a scene as the JSON of ``scene.json``; ``decoder`` is the inverse."""

from __future__ import annotations

import json
import re
from collections.abc import Mapping
from typing import Any, cast

import numpy as np

from ..io.bounded import MAX_NAME_LENGTH
from ..physics.mjcf import mesh_files
from ..scene import ConvexPart, Model, Report, Scene, ScenePlan
from ..scene.provenance import plain

HIDDEN = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u2028-\u202e\u2066-\u2069]")
"""Characters that strings in a bundle must not contain: control characters, except newlines and
tabs, and characters that change the direction of text."""

_LENGTH, _UNIT, _MASS = 7, 6, 12  # decimals of metres, canonical coordinates and mass


def dumps(payload: Mapping[str, Any]) -> bytes:
    """Return the canonical text of ``payload``: sorted keys, one per line, and compact arrays."""
    lines: list[str] = []
    for key in sorted(payload):
        value = payload[key]
        if isinstance(value, list) and value and isinstance(value[0], dict):
            inner = ",\n  ".join(_compact(item) for item in cast("list[Any]", value))
            lines.append(f" {_compact(key)}: [\n  {inner}\n ]")
        else:
            lines.append(f" {_compact(key)}: {_compact(value)}")
    return ("{\n" + ",\n".join(lines) + "\n}\n").encode()


def encode_scene(scene: Scene) -> tuple[dict[str, Any], dict[str, bytes]]:
    """Return a scene as JSON values, and its meshes and textures as files."""
    files: dict[str, bytes] = {}
    models: dict[str, dict[str, Any]] = {}

    def model_key(model: Model) -> str:
        encoded = _encode_model(model, files)
        text = _compact(encoded)
        for key, known in models.items():
            if _compact(known) == text:
                return key
        key = f"{len(models)}-{encoded['category']}"
        models[key] = encoded
        return key

    table = {
        "model": model_key(scene.table.model),
        "scale": _numbers(scene.table.scale, _LENGTH),
        "parts": [_encode_part(p, _LENGTH) for p in scene.table.parts],
        "outline": _numbers(scene.table.outline, _LENGTH),
        "friction": float(scene.table.friction),
    }
    objects = [
        {
            "name": o.name,
            "model": model_key(o.model),
            "placement": {
                "name": o.placement.name,
                "yaw": float(o.placement.yaw),
                "translation": _numbers(o.placement.translation, _LENGTH),
                "scale": _numbers(o.placement.scale, _LENGTH),
                "on": o.placement.on,
                "inside": bool(o.placement.inside),
            },
            "parts": [_encode_part(p, _LENGTH) for p in o.parts],
            "mass": round(float(o.mass), _MASS),
            "com": _numbers(o.com, 9),
            "inertia": _numbers(o.inertia, _MASS + 3),
            "friction": float(o.friction),
            "pose": {
                "position": _numbers(o.pose.position, 8),
                "quaternion": _numbers(o.pose.quaternion, 9),
            },
        }
        for o in scene.objects
    ]
    provenance = _without_empty(_printable(plain(scene.provenance)), "edits")
    payload = {
        "name": scene.name,
        "table": table,
        "objects": objects,
        "models": models,
        "provenance": provenance,
        "view": plain(scene.view),
        "report": _encode_report(scene.report),
        "plan": _encode_plan(scene.plan),
    }
    return payload, files


def _encode_report(report: Report | None) -> dict[str, Any] | None:
    encoded = None if report is None else _printable(report.as_json())
    return _without_empty(encoded, "relations")


def _encode_plan(plan: ScenePlan | None) -> dict[str, Any] | None:
    """Return a plan as JSON, omitting empty groups, default families and the usual density."""
    encoded = _without_empty(_printable(plain(plan)), "groups")
    if encoded is not None:
        if encoded["density"] == "normal":
            del encoded["density"]
        encoded["objects"] = [_without_empty(thing, "family") for thing in encoded["objects"]]
    return encoded


def _without_empty(encoded: Any, key: str) -> Any:
    if encoded is None or encoded[key]:
        return encoded
    return {k: v for k, v in encoded.items() if k != key}


def _encode_model(model: Model, files: dict[str, bytes]) -> dict[str, Any]:
    made = mesh_files(model.mesh)
    files |= made
    shape, picture = made
    return {
        "name": one_line(model.name),
        "label": one_line(model.label),
        "mesh": shape,
        "texture": picture,
        "opacity": float(model.mesh.opacity),
        "size": _numbers(model.size, _LENGTH),
        "physics": plain(model.physics),
        "parts": [_encode_part(p, _UNIT) for p in model.parts],
        "category": one_line(model.category),
        "container": bool(model.container),
        **({"stand_in": True} if model.stand_in else {}),
    }


def _encode_part(part: ConvexPart, decimals: int) -> dict[str, Any]:
    return {"kind": part.kind, "axis": part.axis, "vertices": _numbers(part.vertices, decimals)}


def _numbers(array: np.ndarray, decimals: int) -> Any:
    return (np.round(np.asarray(array, np.float64), decimals) + 0.0).tolist()


def _compact(value: Any) -> str:
    return json.dumps(
        value, sort_keys=True, separators=(",", ":"), ensure_ascii=False, allow_nan=False
    )


def one_line(text: str) -> str:
    """Return a name or a label on a single line, without unprintable characters."""
    return "".join(c if c.isprintable() else " " for c in text)[:MAX_NAME_LENGTH]


def _printable(value: Any) -> Any:
    """Return JSON values without any text that would affect a terminal."""
    if isinstance(value, str):
        return HIDDEN.sub(" ", value)
    if isinstance(value, dict):
        entries = cast("dict[str, Any]", value).items()
        return {_printable(key): _printable(inner) for key, inner in entries}
    if isinstance(value, list):
        return [_printable(inner) for inner in cast("list[Any]", value)]
    return value
