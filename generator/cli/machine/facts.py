"""Facts about this machine: packages, extras, models, keys, caches."""

from __future__ import annotations

import contextlib
import os
import platform
import re
from dataclasses import asdict
from importlib import metadata
from pathlib import Path
from typing import Any

from ...backends.embedded import eye
from ...backends.embedded.minisam import weights as minisam
from ...backends.huggingface.weights.pins import missing, pins
from ...backends.paid_run import calls_folder
from ...backends.requirements import models_folder
from ...physics.decomposition import hulls_folder
from ...threads import cores
from ..plugins import project
from . import probes

KEYS = (
    "TABLETOPGEN_CLOUD_KEY", "TABLETOPGEN_CLOUD_IMAGE_KEY", "OPENAI_API_KEY", "OPENROUTER_API_KEY",
    "ARK_API_KEY", "TENCENTCLOUD_SECRET_ID", "TENCENTCLOUD_SECRET_KEY", "HF_TOKEN",
)  # fmt: skip
"""Environment variables with secrets; only their presence is ever reported."""

EYE = ("eye.safetensors", "judge.safetensors")

_NAME = re.compile(r"[A-Za-z0-9._-]+")
_EXTRA = re.compile(r"extra\s*==\s*['\"]([A-Za-z0-9._-]+)['\"]")


def facts() -> dict[str, Any]:
    """Return the capabilities of this machine as JSON values."""
    needs = requirements()
    return {
        "python": {
            "version": platform.python_version(), "platform": platform.platform(),
            "cores": cores(),
        },
        "packages": {name: version(name) for name in ("tabletopgen", *needs.get("", ()))},
        "rendering": {name: asdict(probes.draw(name)) for name in probes.GL_BACKENDS},
        "cuda": asdict(probes.cuda()),
        "extras": {name: _extra(name, needs[name]) for name in sorted(needs) if name},
        "models": models(),
        "keys": {name: bool(os.environ.get(name, "").strip()) for name in KEYS},
        "caches": caches(),
    }  # fmt: skip


def requirements() -> dict[str, tuple[str, ...]]:
    """Return the packages of each extra except ``dev``; "" lists the required packages.

    In a source checkout they come from its pyproject.toml, because the installed metadata may be
    older.
    """
    found: dict[str, tuple[str, ...]] = {}
    for extra, entry in _entries():
        if extra != "dev" and (name := _NAME.match(entry)):
            found[extra] = (*found.get(extra, ()), name[0])
    return found


def version(package: str) -> str | None:
    """Return the installed version of a package, or None if it is not installed."""
    try:
        return metadata.version(package)
    except metadata.PackageNotFoundError:
        return None


def models() -> dict[str, Any]:
    """Return the availability of the weights of the embedded eye and of the open models."""
    folder, shipped = models_folder(), Path(eye.__file__).parent
    return {
        "embedded": {name: (shipped / name).is_file() for name in EYE},
        "huggingface": {
            "folder": str(folder),
            "models": {name: not missing(pin, folder) for name, pin in pins().items()},
        },
        "minisam": not minisam.list_missing(folder),
    }


def caches() -> dict[str, Any]:
    """Return the locations of the caches and their sizes in bytes."""
    import assets_cache

    folders = {"scenes": assets_cache.user_root(), "calls": calls_folder(),
               "models": models_folder(), "hulls": hulls_folder()}  # fmt: skip
    return {name: {"folder": str(p), "bytes": size(p)} for name, p in folders.items()}


def size(folder: Path) -> int:
    """Return the size of all files in a folder in bytes, without following links; 0 if missing."""
    total = 0
    for place, _, names in os.walk(folder):
        for name in names:
            with contextlib.suppress(OSError):
                total += os.lstat(Path(place, name)).st_size
    return total


def _extra(name: str, packages: tuple[str, ...]) -> dict[str, Any]:
    absent = [package for package in packages if version(package) is None]
    return {"missing": absent, "install": f"pip install 'tabletopgen[{name}]'" if absent else None}


def _entries() -> list[tuple[str, str]]:
    """Return all requirements as (extra, package) pairs."""
    if table := project():
        groups = {"": table.get("dependencies", ()), **table.get("optional-dependencies", {})}
        return [(extra, entry) for extra, entries in groups.items() for entry in entries]
    try:
        entries = metadata.requires("tabletopgen") or []
    except metadata.PackageNotFoundError:
        return []
    return [(m[1] if (m := _EXTRA.search(entry)) else "", entry) for entry in entries]
