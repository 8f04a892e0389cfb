"""TripoSR (VAST, Stability AI) in this process: the smallest supported model, usable on CPUs."""

from __future__ import annotations

import inspect
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from PIL import Image

from ...errors import require
from ...meshes.canonical import Normal
from ...scene import Instance, Model, SizePrior, View
from ..requirements import module, working
from .cutout import cutout, on_grey
from .installed import Installed, as_model, call

_HOW = "Install github.com/VAST-AI-Research/TripoSR and add it to the Python path."
_CHUNK = 8192  # points per batch of its renderer


@dataclass(frozen=True)
class TripoSR(Installed):
    """A modeler that runs a local installation of TripoSR on one instance at a time.

    Attributes:
        weights: name or folder of the weights.
        device: "cuda", "cpu" …; if empty, "cuda" is used if available.
        resolution: cells along a side of its surface grid.
        faces: maximum number of triangles kept, see ``Normal``.
        texture: side in texels of the texture into which its vertex colours are baked.
    """

    weights: str = "stabilityai/TripoSR"
    device: str = ""
    resolution: int = 256
    faces: int = Normal.faces
    texture: int = Normal.texture

    def __post_init__(self) -> None:
        require(self, "resolution", minimum=32, maximum=512, integer=True)

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Return the model's mesh of one instance; see ``protocols.Modeler``.

        Raises:
            BackendError: the model is not installed, or fails.
        """
        what = f"triposr, model of {instance.name!r}:"
        to = Normal(self.faces, self.texture)
        picture = Image.fromarray(on_grey(cutout(instance, "triposr")))
        with self._turn, working(what):
            made = self._run(picture)
        return as_model(made, what, instance, size, up="z", to=to)

    @cached_property
    def _network(self) -> Any:
        kind = module("tsr.system", "triposr", _HOW).TSR
        made = call(
            kind.from_pretrained, "triposr", self.weights, config_name="config.yaml",
            weight_name="model.ckpt",
        )  # fmt: skip
        made.renderer.set_chunk_size(_CHUNK)
        made.to(self._device)
        return made

    @cached_property
    def _device(self) -> str:
        torch = module("torch", "triposr", _HOW)
        return self.device or ("cuda" if torch.cuda.is_available() else "cpu")

    def _run(self, picture: Image.Image) -> Any:
        network = self._network
        with module("torch", "triposr", _HOW).inference_mode():
            codes = network([picture], device=self._device)
            extract = network.extract_mesh
            colored = "has_vertex_color" in inspect.signature(extract).parameters
            named = {"has_vertex_color": True} if colored else {}  # newer versions require it
            return call(extract, "triposr", codes, resolution=self.resolution, **named)[0]
