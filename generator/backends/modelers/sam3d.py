"""SAM 3D Objects of Meta in this process. Its weights are gated, under the SAM License."""

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
"""The environment's name for the checkout, where ``Sam3D.home`` is empty."""

_UNIT = 1e-2  # by how much a quaternion's length may miss 1


@dataclass(frozen=True)
class Sam3D(Installed):
    """Runs SAM 3D Objects where it is installed, one instance at a time; needs 32 GB of CUDA.

    Of its answer the mesh is used, and the rotation as a hint to the rotation stage
    (``Model.orientation``); translation and scale are not. Tried on a played model only, never on
    the real weights: see ``orientation`` for where its convention comes from.

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
                    f"sam3d needs {needed}, which is not there. Check out "
                    "github.com/facebookresearch/sam-3d-objects, get its weights, and set "
                    f"{HOME} to its folder."
                )
        spec = importlib.util.spec_from_file_location("sam3d_inference", script)
        assert spec is not None and spec.loader is not None
        loaded = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(loaded)
        return call(loaded.Inference, "sam3d", str(config))


def orientation(rotation: Any, view: View, what: str) -> Float[np.ndarray, "3 3"] | None:
    """Return the rotation that turns a model's axes into the world's, by SAM 3D's own pose.

    The model's maintainers say (issues 56, 100 and 103 of its repository): ``rotation`` is a wxyz
    quaternion that takes the Gaussians' frame, which is z-up as a GLB turned upright is, to the
    frame of PyTorch3D's cameras: x left, y up, z forward. PyTorch3D turns points as rows, so on
    columns the transposed matrix acts. None of it was tried on real weights.

    Args:
        rotation: four numbers, of whatever kind of array; None where the answer has none.
        view: under which the picture that SAM 3D was shown sees the instance, along its own ray.
        what: begins the warning about a rotation that is none; that is not used.
    """
    if rotation is None:
        return None
    try:
        for step in ("detach", "cpu"):  # of a tensor
            rotation = getattr(rotation, step, lambda kept=rotation: kept)()
        quaternion = np.asarray(rotation, np.float64).reshape(4)
    except (TypeError, ValueError):
        quaternion = np.full(4, np.nan)
    if not abs(float(np.linalg.norm(quaternion)) - 1) <= _UNIT:
        output = " ".join(str(rotation).split())[:80]
        logging.getLogger(__name__).warning(
            "%s its rotation is no unit quaternion (%s); it is not used.", what, output
        )
        return None
    to_camera = np.diag([-1.0, -1.0, 1.0]) @ quaternion_matrix(quaternion).T
    return view_rotation(view).T @ to_camera
