"""Meta's SAM 3D Objects in this process. Its weights are gated, under the SAM License."""

from __future__ import annotations

import importlib.util
import logging
import os
from dataclasses import dataclass, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Float

from ...errors import BackendError
from ...geometry import quaternion_matrix, view_rotation
from ...meshes.canonical import Normal
from ...scene import Instance, Model, SizePrior, View
from ..requirements import working
from .installed import Installed, as_model, call

HOME = "TABLETOPGEN_SAM3D"
"""Environment variable that sets the checkout, used if ``Sam3D.home`` is empty."""

_UNIT = 1e-2  # tolerance of a unit quaternion's norm


@dataclass(frozen=True)
class Sam3D(Installed):
    """A modeler that runs a local installation of SAM 3D Objects; it needs 32 GB of CUDA memory.

    Its mesh is used, and its rotation serves as a hint to the rotation stage
    (``Model.orientation``); translation and scale are ignored. This class was tested only with a
    simulated model, never with the real weights; the function ``orientation`` documents the source
    of its convention.

    Attributes:
        home: the checkout of github.com/facebookresearch/sam-3d-objects; if empty, the environment
            variable ``TABLETOPGEN_SAM3D`` sets it.
        config: path of its configuration within the checkout.
        seed: seed of its noise.
        faces: maximum number of triangles kept, see ``Normal``.
        texture: side in texels of the texture into which its vertex colours are baked.
    """

    home: str = ""
    config: str = "checkpoints/hf/pipeline.yaml"
    seed: int = 42
    faces: int = Normal.faces
    texture: int = Normal.texture

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Return the model's mesh of one instance; see ``protocols.Modeler``.

        Raises:
            BackendError: the model is not installed, or fails.
        """
        what = f"sam3d, model of {instance.name!r}:"
        to = Normal(self.faces, self.texture)
        mask = instance.crop[..., 3] > 127
        if not mask.any():
            raise BackendError(f"{what} the crop is fully transparent.")
        with self._turn, working(what):
            image = np.ascontiguousarray(instance.crop[..., :3])
            output = call(self._inference, "sam3d", image, mask, seed=self.seed)
            made = output["glb"]
        model = as_model(made, what, instance, size, up="y", to=to)
        return replace(model, orientation=orientation(output.get("rotation"), view, what))

    @cached_property
    def _inference(self) -> Any:
        home = Path(self.home or os.environ.get(HOME, "")).expanduser()
        script, config = home / "notebook" / "inference.py", home / self.config
        for needed in (script, config):
            if not needed.is_file():
                raise BackendError(
                    f"sam3d needs {needed}, which is missing. Check out "
                    "github.com/facebookresearch/sam-3d-objects, download its weights, and set "
                    f"{HOME} to its folder."
                )
        spec = importlib.util.spec_from_file_location("sam3d_inference", script)
        assert spec is not None and spec.loader is not None
        loaded = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(loaded)
        return call(loaded.Inference, "sam3d", str(config))


def orientation(rotation: Any, view: View, what: str) -> Float[np.ndarray, "3 3"] | None:
    """Return the rotation from a model's axes to the world's, based on SAM 3D's own pose.

    According to the model's maintainers (issues 56, 100 and 103 of its repository), ``rotation`` is
    a wxyz quaternion from the Gaussians' frame, which is z-up like an upright GLB, to the frame of
    PyTorch3D's cameras: x left, y up, z forward. PyTorch3D rotates points as rows, so the
    transposed matrix applies to columns. This was not tested with real weights.

    Args:
        rotation: four numbers in any kind of array, or None if the output has none.
        view: view of the instance in the input picture of SAM 3D, along its own ray.
        what: start of the warning about an invalid rotation, which is ignored.
    """
    if rotation is None:
        return None
    try:
        for step in ("detach", "cpu"):  # if it is a tensor
            rotation = getattr(rotation, step, lambda kept=rotation: kept)()
        quaternion = np.asarray(rotation, np.float64).reshape(4)
    except (TypeError, ValueError):
        quaternion = np.full(4, np.nan)
    if not abs(float(np.linalg.norm(quaternion)) - 1) <= _UNIT:
        output = " ".join(str(rotation).split())[:80]
        logging.getLogger(__name__).warning(
            "%s the rotation is not a unit quaternion (%s) and is ignored.", what, output
        )
        return None
    to_camera = np.diag([-1.0, -1.0, 1.0]) @ quaternion_matrix(quaternion).T
    return view_rotation(view).T @ to_camera
