"""SAM 3D Objects of Meta in this process. Its weights are gated, under the SAM License."""

from __future__ import annotations

import importlib.util
import os
import threading
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np

from ...errors import BackendError
from ...scene import Instance, Model, SizePrior, View
from ..installing import working
from .installed import call, only_mesh
from .normalising import Normal, foreign_model, normal_trimesh

HOME = "TABLETOPGEN_SAM3D"
"""The environment's name for the checkout, where ``Sam3D.home`` is empty."""


@dataclass(frozen=True)
class Sam3D:
    """Runs SAM 3D Objects where it is installed, one instance at a time; needs 32 GB of CUDA.

    Of its answer the mesh is used; the pose in it (rotation, translation, scale) has no place in
    ``Model``.

    Attributes:
        home: the checkout of github.com/facebookresearch/sam-3d-objects; empty: the one that the
            environment's ``TABLETOPGEN_SAM3D`` names.
        config: its configuration, below the checkout.
        seed: of its noise.
        faces: most triangles kept, see ``Normal``.
        texture: side of the texture that its vertex colours are painted into, texels.
    """

    home: str = ""
    config: str = "checkpoints/hf/pipeline.yaml"
    seed: int = 42
    faces: int = Normal.faces
    texture: int = Normal.texture
    _turn: threading.Lock = field(
        default_factory=threading.Lock, init=False, repr=False, compare=False
    )

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Return its mesh of one instance; see ``protocols.Modeler``.

        Raises:
            BackendError: it is not installed, or fails.
        """
        what = f"sam3d, model of {instance.name!r}:"
        to = Normal(self.faces, self.texture)
        mask = instance.crop[..., 3] > 127
        if not mask.any():
            raise BackendError(f"{what} its crop shows nothing.")
        with self._turn, working(what):
            image = np.ascontiguousarray(instance.crop[..., :3])
            told = call(self._inference, "sam3d", image, mask, seed=self.seed)
            made = told["glb"]
        mesh = normal_trimesh(only_mesh(made, what), what, up="y", to=to)
        return foreign_model(mesh, instance, size)

    @cached_property
    def _inference(self) -> Any:
        home = Path(self.home or os.environ.get(HOME, "")).expanduser()
        script, config = home / "notebook" / "inference.py", home / self.config
        for needed in (script, config):
            if not needed.is_file():
                raise BackendError(
                    f"sam3d needs {needed}, which is not there. Check out "
                    "github.com/facebookresearch/sam-3d-objects, get its weights, and set "
                    f"{HOME} to its folder."
                )
        spec = importlib.util.spec_from_file_location("sam3d_inference", script)
        assert spec is not None and spec.loader is not None
        loaded = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(loaded)
        return call(loaded.Inference, "sam3d", str(config))
