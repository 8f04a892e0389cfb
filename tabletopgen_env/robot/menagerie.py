"""The Panda of the MuJoCo Menagerie, if it is installed.

Its meshes are not part of this project. They are read from ``$MENAGERIE_ROOT`` (a clone of the
repository) or from the cache of the ``mujoco-menagerie`` package.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from generator.errors import BackendError

from .tool import add_tool

if TYPE_CHECKING:
    import mujoco

_FOLDER = "franka_emika_panda"


def menagerie() -> mujoco.MjSpec:
    """Load the official model, and add this project's site, camera and gravity compensation.

    Raises:
        BackendError: the model is not installed.
    """
    import mujoco

    spec = mujoco.MjSpec.from_file(str(_folder() / "panda.xml"))
    for key in list(spec.keys):
        spec.delete(key)
    for light in list(spec.worldbody.lights):
        spec.delete(light)
    for body in spec.bodies[1:]:
        if body.name != "link0":
            body.gravcomp = 1
    add_tool(spec.body("hand"))
    return spec


def _folder() -> Path:
    """Return the folder of Menagerie's ``panda.xml``, or raise BackendError if there is none."""
    places = []
    if root := os.environ.get("MENAGERIE_ROOT"):
        places.append(Path(root) / _FOLDER)
    models = _cache() / "models"
    if models.is_dir():
        places += sorted(p for p in models.glob(f"{_FOLDER}-*") if (p / ".complete").is_file())
    for place in places:
        if (place / "panda.xml").is_file():
            return place
    raise BackendError(
        "Panda(visuals='menagerie') needs the Menagerie model, which is neither in MENAGERIE_ROOT "
        "nor in the mujoco-menagerie cache. Either clone "
        "https://github.com/google-deepmind/mujoco_menagerie and set MENAGERIE_ROOT to it, or "
        'run: pip install mujoco-menagerie && python -c "import mujoco_menagerie as m; '
        "m.prefetch(['franka_emika_panda'])\". Panda() needs no download."
    )


def _cache() -> Path:
    """Return the folder in which the mujoco-menagerie package stores models on this platform."""
    if folder := os.environ.get("MENAGERIE_CACHE_DIR"):
        return Path(folder)
    if sys.platform == "win32":
        local = os.environ.get("LOCALAPPDATA") or Path.home() / "AppData/Local"
        return Path(local) / "mujoco_menagerie" / "cache"
    if sys.platform == "darwin":
        return Path.home() / "Library/Caches/mujoco_menagerie"
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "mujoco_menagerie"
