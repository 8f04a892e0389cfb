"""Your own assets: a folder of GLB and OBJ files, one per instance name or category."""

from __future__ import annotations

import logging
import os
from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType
from typing import Literal, get_args

import numpy as np
from jaxtyping import Float

from ...errors import BackendError, choices, require_known
from ...geometry import proportion_gap
from ...io.bounded import read_regular
from ...language.names import known_category
from ...meshes.canonical import Normal, foreign_model, normal_surface
from ...meshes.reading.bounds import MOST_BYTES
from ...meshes.reading.companions import companions
from ...meshes.reading.loader import load_surface
from ...meshes.reading.surface import Axis, ColoredSurface
from ...scene import Instance, Model, SizePrior, View
from ..protocols import Modeler
from .assets import find_assets, plain

_LOG = logging.getLogger(__name__)

ASSETS = "TABLETOPGEN_ASSETS"
"""Environment variable that sets the folder, used if ``Folder.path`` is empty."""

Units = Literal["usual", "m", "cm", "mm", "in"]
"""Unit of a file's coordinates; "usual" means unknown: the object is scaled to its usual size."""

_METRES: Mapping[str, float] = MappingProxyType({"m": 1.0, "cm": 0.01, "mm": 0.001, "in": 0.0254})
_CLEAR = 0.15  # minimum advantage of one up axis over the other, as mean log ratio of proportions
# ratio to the usual size above which (or below its inverse) a file's size is warned about
_ODD = 4.0


@dataclass(frozen=True)
class Folder:
    """A modeler that uses your files, found by name ("mug_1.glb"), label or category ("mug.obj").

    Files may be in their own folders ("025_mug/textured.obj", see ``assets``). A texture shared by
    all parts of a file is kept, unless it repeats or the triangles are changed (see
    ``normalising``); several textures are baked into one. The file's proportions are kept.

    Attributes:
        path: the folder; if empty, the environment variable ``TABLETOPGEN_ASSETS`` sets it.
        up: up axis of the files; "auto": y for GLB, as its format specifies, and for OBJ whichever
            of y and z better matches the usual proportions, or y in case of doubt.
        units: unit of the files' coordinates. "usual" means that they have none, so the size is
            estimated; otherwise the file's own size is used.
        faces: maximum number of triangles of a mesh, see ``Normal``.
        texture: side of rebuilt textures in texels.
        fallback: modeler for objects without a file; None raises an error instead. If the backend
            is selected by name, it is the embedded modeler.

    Raises:
        InputError: an unknown axis or unit.
    """

    path: str = ""
    up: Axis | Literal["auto"] = "auto"
    units: Units = "usual"
    faces: int = Normal.faces
    texture: int = Normal.texture
    fallback: Modeler | None = None

    def __post_init__(self) -> None:
        require_known(self.up, ("auto", *get_args(Axis)), "Folder.up: unknown axis")
        require_known(self.units, get_args(Units), "Folder.units: unknown unit")

    def check(self) -> None:
        """Raise BackendError if the folder does not exist or contains no mesh."""
        if not self.files():
            raise BackendError(
                f"folder, model: {self.home()} contains no GLB or OBJ file, not even in subfolders."
            )

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Return the file for one instance as a model; see ``protocols.Modeler``.

        Raises:
            BackendError: there is no folder or no file for it, or the file is unusable.
        """
        files = self.files()
        category = known_category(instance, size)
        words = (instance.name, instance.label, category.key if category else instance.label)
        file = next((files[plain(word)] for word in words if plain(word) in files), None)
        if file is None:
            tried = " or ".join(dict.fromkeys(f"{plain(word)}.glb" for word in words))
            missing = f"folder, model of {instance.name!r}: {self.home()} has no {tried}."
            if self.fallback is not None:
                _LOG.warning("%s %s models it instead.", missing, type(self.fallback).__name__)
                return self.fallback.model(instance, size, view)
            raise BackendError(missing + choices(plain(instance.name), files))
        what = f"folder, model of {instance.name!r}: {file.name}"
        raw = read_regular(file, f"{what}:", BackendError, max_bytes=MOST_BYTES)
        kind = "obj" if file.suffix.lower() == ".obj" else "glb"
        beside = companions(raw, what, file.parent) if kind == "obj" else {}
        surface = load_surface(raw, what, kind, beside)
        up = self._up(surface, kind, size, what)
        mesh = normal_surface(surface, what, up=up, to=Normal(self.faces, self.texture))
        model = foreign_model(mesh, instance, size)
        return model if self.units == "usual" else self._own_size(model, mesh.vertices, what)

    def _up(self, surface: ColoredSurface, kind: str, size: SizePrior, what: str) -> Axis:
        """Return the up axis of a file."""
        if self.up != "auto":
            return self.up
        if kind == "glb":
            return "y"
        sides = {axis: np.ptp(surface.upright(axis).vertices, axis=0) for axis in get_args(Axis)}
        gaps = {a: proportion_gap(np.maximum(s, 1e-9), size.extent) for a, s in sides.items()}
        if gaps["z"] + _CLEAR < gaps["y"]:
            _LOG.warning(
                "%s is assumed to be z-up, based on its proportions. Set Folder.up to override "
                "this.",
                what,
            )
            return "z"
        return "y"

    def _own_size(self, model: Model, vertices: Float[np.ndarray, "n 3"], what: str) -> Model:
        """Return the model at the file's own size."""
        own = np.ptp(vertices, axis=0) * _METRES[self.units]
        times = float(own.max() / np.asarray(model.size).max())
        if not 1 / _ODD < times < _ODD:
            _LOG.warning(
                "%s, read with the unit %s, is %.3g times its usual size. Check Folder.units.",
                what,
                self.units,
                times,
            )
        return replace(model, size=own)

    def home(self) -> Path:
        """Return the folder.

        Raises:
            BackendError: no folder is set, or the path is not a folder.
        """
        named = self.path or os.environ.get(ASSETS, "")
        if not named:
            raise BackendError(
                f"folder, model: no folder is set. Set {ASSETS} to a folder of GLB or OBJ "
                "files, or pass Folder(path)."
            )
        home = Path(named).expanduser()
        if not home.is_dir():
            raise BackendError(f"folder, model: {home} is not a folder. Set {ASSETS} to a folder.")
        return home

    def files(self) -> Mapping[str, Path]:
        """Return the folder's files by object; see ``assets.find_assets``."""
        return find_assets(self.home())
