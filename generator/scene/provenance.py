"""Scene names, package versions and JSON-ready values for provenance records."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache
from importlib import metadata
from typing import Any, cast

import numpy as np

_DECISIVE = (
    "tabletopgen", "coacd", "mujoco", "numpy", "opencv-python-headless", "pillow", "scipy",
    "shapely", "torch", "trimesh",
)  # fmt: skip


_MAX_NAME = 40  # characters


def scene_name(prompt: str | None) -> str:
    """Return a short, file-safe name for a prompt: its first words, up to 40 characters."""
    words = "".join(c if c.isascii() and c.isalnum() else " " for c in (prompt or "picture"))
    name = "-".join(words.lower().split())
    if len(name) > _MAX_NAME:
        cut = name[: _MAX_NAME + 1]
        name = cut.rpartition("-")[0] or cut[:-1]
    return name or "scene"


def versions(packages: Iterable[str] = _DECISIVE) -> dict[str, str]:
    """Return the versions of packages; by default, those that affect a scene's bytes."""
    return {package: _version(package) for package in packages}


@lru_cache(maxsize=64)
def _version(package: str) -> str:
    """Return the installed version of a package, cached because a lookup takes a millisecond."""
    return metadata.version(package)


def plain(value: Any) -> Any:
    """Convert dataclasses, tuples, mappings and NumPy scalars to JSON-ready values."""
    if dataclasses.is_dataclass(value) and not isinstance(value, type):
        return {f.name: plain(getattr(value, f.name)) for f in dataclasses.fields(value)}
    if isinstance(value, Mapping):
        return {str(k): plain(v) for k, v in cast("Mapping[Any, Any]", value).items()}
    if isinstance(value, list | tuple):
        return [plain(v) for v in cast("Sequence[Any]", value)]
    return cast("Any", value.item() if isinstance(value, np.generic) else value)
