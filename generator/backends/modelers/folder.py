"""Your own assets: a folder of GLB and OBJ files, one for each instance name or category."""

from __future__ import annotations

import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from ...errors import BackendError, choices
from ...io.reading import read_regular
from ...language.naming import known_category
from ...meshes.normalising import Normal, foreign_model, normal_mesh
from ...meshes.reading.bounds import MOST_BYTES
from ...meshes.reading.companions import companions
from ...meshes.reading.surface import Axis
from ...scene import Instance, Model, SizePrior, View
from ..protocols import Modeler

ASSETS = "TABLETOPGEN_ASSETS"
"""The environment's name for the folder, where ``Folder.path`` is empty."""

_FORMATS = (".glb", ".obj")  # the first is taken where there are both


@dataclass(frozen=True)
class Folder:
    """Answers with your own files, by name ("mug_1.glb"), then by label or category ("mug.obj").

    A texture that all of a file's parts share stays, unless it repeats or the triangles are changed
    (see ``normalising``); several are painted into one. The size is the prior's, the proportions
    are the file's own.

    Attributes:
        path: the folder; empty: the one that the environment's ``TABLETOPGEN_ASSETS`` names.
        up: which axis of the files is up.
        faces: most triangles of a mesh, see ``Normal``.
        texture: side of a texture made again, texels.
        rest: who models what the folder has no file for; None: that is an error.
    """

    path: str = ""
    up: Axis = "y"
    faces: int = Normal.faces
    texture: int = Normal.texture
    rest: Modeler | None = None

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Return the file for one instance as a model; see ``protocols.Modeler``.

        Raises:
            BackendError: no folder, no file for it, or one that cannot be used.
        """
        files = self.files()
        category = known_category(instance, size)
        words = (instance.name, instance.label, category.key if category else instance.label)
        file = next((files[_plain(word)] for word in words if _plain(word) in files), None)
        if file is None:
            if self.rest is not None:
                return self.rest.model(instance, size, view)
            tried = " or ".join(dict.fromkeys(f"{_plain(word)}.glb" for word in words))
            raise BackendError(
                f"folder, model of {instance.name!r}: {self.home()} has no {tried}."
                + choices(_plain(instance.name), files)
            )
        what = f"folder, model of {instance.name!r}: {file.name}"
        raw = read_regular(file, f"{what}:", BackendError, max_bytes=MOST_BYTES)
        kind = "obj" if file.suffix.lower() == ".obj" else "glb"
        beside = companions(raw, what, file.parent) if kind == "obj" else {}
        to = Normal(self.faces, self.texture)
        mesh = normal_mesh(raw, what, kind=kind, up=self.up, to=to, beside=beside)
        return foreign_model(mesh, instance, size)

    def home(self) -> Path:
        """Return the folder.

        Raises:
            BackendError: no folder is named, or what is named is not a folder.
        """
        named = self.path or os.environ.get(ASSETS, "")
        if not named:
            raise BackendError(
                f"folder, model: no folder is named. Set {ASSETS} to a folder of GLB or OBJ "
                "files, or pass Folder(path)."
            )
        home = Path(named).expanduser()
        if not home.is_dir():
            raise BackendError(f"folder, model: {home} is no folder. Set {ASSETS} to one.")
        return home

    def files(self) -> Mapping[str, Path]:
        """Return the folder's files by what they model."""
        found: dict[str, Path] = {}
        for kind in _FORMATS:
            for file in sorted(self.home().iterdir()):
                if file.suffix.lower() == kind and file.is_file():
                    found.setdefault(_plain(file.stem), file)
        return found


def _plain(word: str) -> str:
    """Return a word as files are called: lower case, underscores."""
    return "_".join(word.lower().replace("-", " ").replace("_", " ").split())
