"""A scene's identity, from ``scene.json`` alone: its digest and its objects' categories."""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ..errors import BundleError
from ..scene import Scene
from .encoder import dumps, encode_scene
from .folder import read_truth
from .publication import steady

_CONTENT = ("table", "objects", "models")


def digest(scene: Scene) -> str:
    """Return 12 hexadecimal digits that identify a scene by its table and objects alone.

    Name, provenance, report and pictures do not count, so this differs from the digest in a
    bundle's name, which depends on all of its bytes. A scene and its bundle have the same digest
    (``load_digest``).
    """
    return _digest(encode_scene(scene)[0])


@steady
def load_digest(path: str | Path) -> str:
    """Read the ``digest`` of a bundle's scene without reading its meshes.

    Raises:
        BundleError: there is no bundle, or its ``scene.json`` is damaged.
    """
    try:
        return _digest(read_truth(Path(path)))
    except KeyError as error:
        raise BundleError(f"{path}: scene.json has no {error}. Create the bundle again.") from error


@steady
def load_fingerprint(path: str | Path) -> str:
    """Return the sha256 of a bundle's ``scene.json``, whose first 12 digits end the bundle's name.

    Raises:
        BundleError: there is no bundle, or its ``scene.json`` is damaged.
    """
    return hashlib.sha256(dumps(read_truth(Path(path)))).hexdigest()


@steady
def load_kinds(path: str | Path) -> list[tuple[str, str]]:
    """Read the category and label of each object in a bundle without reading its meshes.

    Raises:
        BundleError: there is no bundle, or its ``scene.json`` is damaged.
    """
    payload = read_truth(Path(path))
    try:
        models = [payload["models"][entry["model"]] for entry in payload["objects"]]
        return [(str(model["category"]), str(model["label"])) for model in models]
    except (TypeError, LookupError) as error:
        raise BundleError(
            f"{path}: scene.json does not list its objects ({type(error).__name__}: {error}). "
            "Create the bundle again."
        ) from error


@steady
def load_report(path: str | Path) -> dict[str, Any]:
    """Read a bundle's gate report as a dictionary, with the number of objects as "objects".

    Raises:
        BundleError: there is no bundle, or its ``scene.json`` is damaged or has no report.
    """
    payload = read_truth(Path(path))
    try:
        return {**payload["report"], "objects": len(payload["objects"])}
    except (TypeError, LookupError) as error:
        raise BundleError(f"{path}: scene.json has no report. Create the bundle again.") from error


def _digest(payload: Mapping[str, Any]) -> str:
    content = dumps({key: payload[key] for key in _CONTENT})
    return hashlib.sha256(content).hexdigest()[:12]
