"""A scene as the JSON of ``scene.json``, and back. Strict: finite numbers, known fields only."""

from __future__ import annotations

import io
import json
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np
from jaxtyping import UInt8

from ..errors import BundleError
from ..mjcf import encode_obj, mesh_path, texture_path
from ..png import encode_png
from ..provenance import plain
from ..scene import (
    ConvexPart,
    Edit,
    Mesh,
    Model,
    Object,
    Physics,
    Placement,
    PlannedObject,
    PlannedTable,
    Pose,
    Provenance,
    Relation,
    Report,
    Scene,
    ScenePlan,
    Table,
    View,
)

MOST_PIXELS = 4096 * 4096
"""No texture of a bundle may have more."""

_LENGTH, _UNIT, _MASS = 7, 6, 12  # decimals of metres, of canonical coordinates, of mass


def dumps(payload: Mapping[str, Any]) -> bytes:
    """Return the one way to write ``payload``: sorted keys, one line per key, arrays compact."""
    lines = []
    for key in sorted(payload):
        value = payload[key]
        if isinstance(value, list) and value and isinstance(value[0], dict):
            inner = ",\n  ".join(_compact(item) for item in value)
            lines.append(f" {_compact(key)}: [\n  {inner}\n ]")
        else:
            lines.append(f" {_compact(key)}: {_compact(value)}")
    return ("{\n" + ",\n".join(lines) + "\n}\n").encode()


def loads(raw: bytes, where: str) -> dict[str, Any]:
    """Parse ``scene.json``.

    Raises:
        BundleError: it is not a JSON object, repeats a key, or holds NaN or infinity.
    """

    def refuse(constant: str) -> float:
        raise BundleError(f"{where}: scene.json holds {constant}; every number must be finite.")

    def number(text: str) -> float:
        value = float(text)
        return value if np.isfinite(value) else refuse(text)

    try:
        payload = json.loads(raw, parse_constant=refuse, parse_float=number)
        json.dumps(payload, ensure_ascii=False).encode()  # half a surrogate pair is no text
    except (ValueError, RecursionError) as error:
        raise BundleError(f"{where}: scene.json is not JSON ({error}).") from error
    if not isinstance(payload, dict):
        raise BundleError(f"{where}: scene.json must be one JSON object.")
    return payload


# ----------------------------------------------------------------------------------------- writing


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
        key = f"{len(models)}-{model.category}"
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
            "placement": _encode_placement(o.placement),
            "parts": [_encode_part(p, _LENGTH) for p in o.parts],
            "mass": round(float(o.mass), _MASS),
            "com": _numbers(o.com, 9),
            "inertia": _numbers(o.inertia, _MASS + 3),
            "friction": float(o.friction),
            "pose": _encode_pose(o.pose),
        }
        for o in scene.objects
    ]
    payload = {
        "name": scene.name,
        "table": table,
        "objects": objects,
        "models": models,
        "provenance": _encode_provenance(scene.provenance),
        "view": plain(scene.view),
        "report": plain(scene.report),
        "plan": plain(scene.plan),
    }
    return payload, files


def _encode_provenance(provenance: Provenance) -> dict[str, Any]:
    """Return it without ``edits`` where there are none."""
    encoded = plain(provenance)
    return encoded if provenance.edits else {k: v for k, v in encoded.items() if k != "edits"}


def _encode_model(model: Model, files: dict[str, bytes]) -> dict[str, Any]:
    obj, png = encode_obj(model.mesh), encode_png(model.mesh.texture)
    shape, picture = mesh_path(obj), texture_path(png)
    files[shape], files[picture] = obj, png
    return {
        "name": model.name,
        "label": model.label,
        "mesh": shape,
        "texture": picture,
        "opacity": float(model.mesh.opacity),
        "size": _numbers(model.size, _LENGTH),
        "physics": plain(model.physics),
        "parts": [_encode_part(p, _UNIT) for p in model.parts],
        "category": model.category,
        "container": bool(model.container),
    }


def _encode_part(part: ConvexPart, decimals: int) -> dict[str, Any]:
    return {"kind": part.kind, "axis": part.axis, "vertices": _numbers(part.vertices, decimals)}


def _encode_placement(placement: Placement) -> dict[str, Any]:
    return {
        "name": placement.name,
        "yaw": float(placement.yaw),
        "translation": _numbers(placement.translation, _LENGTH),
        "scale": _numbers(placement.scale, _LENGTH),
        "on": placement.on,
        "inside": bool(placement.inside),
    }


def _encode_pose(pose: Pose) -> dict[str, Any]:
    return {"position": _numbers(pose.position, 8), "quaternion": _numbers(pose.quaternion, 9)}


def _numbers(array: np.ndarray, decimals: int) -> Any:
    return (np.round(np.asarray(array, np.float64), decimals) + 0.0).tolist()


def _compact(value: Any) -> str:
    return json.dumps(
        value, sort_keys=True, separators=(",", ":"), ensure_ascii=False, allow_nan=False
    )


# ----------------------------------------------------------------------------------------- reading


def decode_scene(payload: Mapping[str, Any], file: Callable[[str], bytes]) -> Scene:
    """Return the scene of :func:`encode_scene`; ``file`` gives the content of a file by path.

    Raises:
        BundleError: a mesh or texture cannot be read.
        Exception: any of Python's, or of the values' own checks, where fields are not as written.
    """
    models = {key: _decode_model(entry, file) for key, entry in payload["models"].items()}
    table = payload["table"]
    return Scene(
        name=str(payload["name"]),
        table=Table(
            model=models[table["model"]],
            scale=np.array(table["scale"]),
            parts=tuple(_decode_part(p) for p in table["parts"]),
            outline=np.array(table["outline"]),
            friction=float(table["friction"]),
        ),
        objects=tuple(_decode_object(entry, models) for entry in payload["objects"]),
        provenance=_decode_provenance(payload["provenance"]),
        view=View(**payload["view"]),
        report=_decode_report(payload["report"]),
        plan=_decode_plan(payload["plan"]),
    )


def _decode_provenance(entry: Mapping[str, Any]) -> Provenance:
    edits = tuple(Edit(**_tuples(edit)) for edit in entry.get("edits", ()))
    return Provenance(**{**_tuples(entry), "edits": edits})


def _decode_object(entry: Mapping[str, Any], models: Mapping[str, Model]) -> Object:
    return Object(
        name=str(entry["name"]),
        model=models[entry["model"]],
        placement=Placement(**entry["placement"]),
        parts=tuple(_decode_part(p) for p in entry["parts"]),
        mass=float(entry["mass"]),
        com=np.array(entry["com"]),
        inertia=np.array(entry["inertia"]),
        friction=float(entry["friction"]),
        pose=Pose(**entry["pose"]),
    )


def _decode_model(entry: Mapping[str, Any], file: Callable[[str], bytes]) -> Model:
    texture = decode_png(file(entry["texture"]), entry["texture"])
    vertices, faces, uv = _decode_obj(file(entry["mesh"]), entry["mesh"])
    return Model(
        name=str(entry["name"]),
        label=str(entry["label"]),
        mesh=Mesh(vertices, faces, uv, texture, float(entry["opacity"])),
        size=np.array(entry["size"]),
        physics=Physics(**entry["physics"]),
        parts=tuple(_decode_part(p) for p in entry["parts"]),
        category=str(entry["category"]),
        container=bool(entry["container"]),
    )


def _decode_part(entry: Mapping[str, Any]) -> ConvexPart:
    if entry["kind"] not in ("hull", "box", "cylinder", "ellipsoid") or entry["axis"] not in (
        0,
        1,
        2,
    ):
        raise BundleError(f"Unknown convex part {entry['kind']!r} along {entry['axis']!r}.")
    return ConvexPart(np.array(entry["vertices"]), entry["kind"], entry["axis"])


def _decode_report(entry: Mapping[str, Any] | None) -> Report | None:
    return None if entry is None else Report(**_tuples(entry))


def _decode_plan(entry: Mapping[str, Any] | None) -> ScenePlan | None:
    if entry is None:
        return None
    objects = tuple(
        PlannedObject(
            **{
                **o,
                "relations": tuple(Relation(**r) for r in o["relations"]),
                "size": None if o["size"] is None else tuple(o["size"]),
            }
        )
        for o in entry["objects"]
    )
    table = PlannedTable(**_tuples(entry["table"]))
    return ScenePlan(**{**_tuples(entry), "table": table, "objects": objects})


def _tuples(entry: Mapping[str, Any]) -> dict[str, Any]:
    return {k: tuple(v) if isinstance(v, list) else v for k, v in entry.items()}


def _decode_obj(raw: bytes, name: str) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Read what ``mjcf.encode_obj`` writes, and nothing else."""
    rows: dict[str, list[list[float]]] = {"v": [], "vt": [], "f": []}
    try:
        for line in raw.decode("ascii").splitlines():
            kind, *fields = line.split()
            values = [f.split("/", 1)[0] for f in fields] if kind == "f" else fields
            rows[kind].append([float(value) for value in values])
        shaped = [np.array(rows["v"]).reshape(-1, 3), np.array(rows["f"]).reshape(-1, 3)]
        return shaped[0], shaped[1].astype(np.int64) - 1, np.array(rows["vt"]).reshape(-1, 2)
    except (ValueError, KeyError) as error:
        raise BundleError(f"{name} is not a mesh as bundles hold them ({error}).") from error


def decode_png(raw: bytes, name: str) -> UInt8[np.ndarray, "h w 3"]:
    """Return the pixels of a PNG called ``name``.

    Raises:
        BundleError: it is none, or has more than ``MOST_PIXELS``.
    """
    from PIL import Image, UnidentifiedImageError

    try:
        with Image.open(io.BytesIO(raw), formats=("PNG",)) as image:
            if image.width * image.height > MOST_PIXELS:
                raise BundleError(
                    f"{name} has {image.size} pixels; at most {MOST_PIXELS} are read."
                )
            return np.asarray(image.convert("RGB"))
    except (UnidentifiedImageError, OSError, SyntaxError, ValueError) as error:
        raise BundleError(f"{name} is not a PNG picture ({error}).") from error
