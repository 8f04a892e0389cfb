"""Microsoft's TRELLIS and TRELLIS.2 in this process."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np
from PIL import Image

from ...errors import BackendError, choices, require
from ...meshes.canonical import Normal
from ...scene import Instance, Model, SizePrior, View
from ..requirements import module, working
from .cutout import cutout
from .installed import Installed, as_model, call

_HOW = "Install github.com/microsoft/TRELLIS (16 GB of GPU memory) or TRELLIS.2 (24 GB)."
_WEIGHTS: Mapping[str, str] = {
    "1": "microsoft/TRELLIS-image-large",
    "2": "microsoft/TRELLIS.2-4B",
}
_MOST_FACES = 16_777_216  # the maximum that TRELLIS.2 can bake

Version = Literal["1", "2"]


@dataclass(frozen=True)
class Trellis(Installed):
    """A modeler that runs a local installation of TRELLIS on one instance at a time, with CUDA.

    Attributes:
        version: "1" is TRELLIS, "2" is TRELLIS.2.
        weights: name or folder of the weights; if empty, the version's default.
        seed: seed of its noise.
        steps: steps of each sampler of TRELLIS.
        faces: maximum number of triangles kept, see ``Normal``.
        texture: side of its texture in texels.
    """

    version: Version = "1"
    weights: str = ""
    seed: int = 1
    steps: int = 12
    faces: int = Normal.faces
    texture: int = Normal.texture

    def __post_init__(self) -> None:
        if self.version not in _WEIGHTS:
            raise BackendError(
                f"Trellis.version {self.version!r} is unknown." + choices(self.version, _WEIGHTS)
            )
        require(self, "steps", minimum=1, integer=True)

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Return the model's mesh of one instance; see ``protocols.Modeler``.

        Raises:
            BackendError: the model is not installed, or fails.
        """
        what = f"trellis, model of {instance.name!r}:"
        to = Normal(self.faces, self.texture)
        picture = Image.fromarray(cutout(instance, "trellis"))
        with self._turn, working(what):
            made = self._first(picture) if self.version == "1" else self._second(picture)
        return as_model(made, what, instance, size, up="y", to=to)

    @cached_property
    def _pipeline(self) -> Any:
        if self.version == "1":
            kind = module("trellis.pipelines", "trellis", _HOW).TrellisImageTo3DPipeline
        else:
            kind = module("trellis2.pipelines", "trellis", _HOW).Trellis2ImageTo3DPipeline
        made = call(kind.from_pretrained, "trellis", self.weights or _WEIGHTS[self.version])
        made.cuda()
        return made

    def _first(self, picture: Image.Image) -> Any:
        bake = module("trellis.utils.postprocessing_utils", "trellis", _HOW).to_glb
        made = call(
            self._pipeline.run, "trellis", picture, seed=self.seed, formats=["gaussian", "mesh"],
            sparse_structure_sampler_params={"steps": self.steps, "cfg_strength": 7.5},
            slat_sampler_params={"steps": self.steps, "cfg_strength": 3.0},
        )  # fmt: skip
        return call(
            bake, "trellis", made["gaussian"][0], made["mesh"][0], simplify=0.95,
            texture_size=self.texture, verbose=False,
        )  # fmt: skip

    def _second(self, picture: Image.Image) -> Any:
        bake = module("o_voxel.postprocess", "trellis", _HOW).to_glb
        made = call(self._pipeline.run, "trellis", picture, seed=self.seed)[0]
        made.simplify(_MOST_FACES)
        return call(
            bake, "trellis", vertices=made.vertices, faces=made.faces, attr_volume=made.attrs,
            coords=made.coords, attr_layout=made.layout, voxel_size=made.voxel_size,
            aabb=np.array([[-0.5] * 3, [0.5] * 3]), decimation_target=8 * self.faces,
            texture_size=self.texture, remesh=True,
        )  # fmt: skip
