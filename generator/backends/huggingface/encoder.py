"""The paper's Encoder, DINOv2 (M. Oquab et al., 2023), which computes the features Phi of Eq. 4."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from jaxtyping import Float

from ...errors import BackendError, require
from ..requirements import Once, models_folder, working
from .detection.detections import IMAGENET, normalise
from .weights.loader import device_for, load_model
from .weights.pins import pin

if TYPE_CHECKING:
    from torch import Tensor

_WHAT = "huggingface, features:"
_KIND = "Dinov2Model"


@dataclass(frozen=True)
class HuggingFaceEncoder:
    """An encoder that uses DINOv2's patch map and global feature as the features Phi of Eq. 4.

    Each position's vector has length 1, so squared distances are in [0, 4] as with the embedded
    encoder, and lambda_a has the same meaning.

    Attributes:
        weights: name of the model.
        side: shorter side of resized images in pixels; a patch is 14 pixels wide.
        batch: maximum number of images per forward pass.
        exact: use float32 on CUDA too, instead of bfloat16.
        device: "cuda", "cpu" …; if empty, "cuda" is used if available.
        folder: folder of the models, see ``installing.models_folder``.
        revision: the model and its commit.

    Raises:
        BackendError: the model does not exist.
        InputError: a number is out of range.
    """

    weights: str = "dinov2"
    side: int = 224
    batch: int = 64
    exact: bool = False
    device: str = ""
    folder: str = field(default="", repr=False, compare=False)
    revision: str = field(init=False)
    _network: Once[Any] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        require(self, "side", minimum=14, maximum=2048, integer=True)
        require(self, "batch", minimum=1, integer=True)
        object.__setattr__(self, "revision", pin(self.weights, _KIND).stamp)
        object.__setattr__(self, "_network", Once(self._load))

    def features(self, images: Tensor) -> tuple[Tensor, ...]:
        """Map (b, 3, h, w) images in [0, 1] to (b, c, h', w') and global (b, c, 1, 1) features.

        The maps are differentiable in ``images`` and have their type and device.

        Raises:
            BackendError: the images have another shape, or the model is missing, damaged or fails.
        """
        import torch

        if images.ndim != 4 or images.shape[1] != 3:
            raise BackendError(
                f"{_WHAT} images must be (b, 3, h, w) in [0, 1], got {tuple(images.shape)}."
            )
        with working(_WHAT):
            network = self._network()
            parts = [self._tokens(network, part) for part in images.split(self.batch)]
            patches, wholes = (torch.cat(maps).to(images) for maps in zip(*parts, strict=True))
        return patches, wholes

    def _tokens(
        self, network: Any, images: Float[Tensor, "b 3 h w"]
    ) -> tuple[Float[Tensor, "b c i j"], Float[Tensor, "b c 1 1"]]:
        """Return the maps of images, computed on the network's device."""
        import torch
        from torch.nn import functional

        step = int(network.config.patch_size)
        scale = self.side / min(images.shape[-2:])
        rows, columns = (max(1, round(scale * n / step)) for n in images.shape[-2:])
        here = images.to(network.device, torch.float32)
        sized = functional.interpolate(
            here, (step * rows, step * columns), mode="bilinear", antialias=True
        )
        fast = network.device.type == "cuda" and not self.exact
        with torch.autocast(network.device.type, torch.bfloat16, enabled=fast):
            tokens = network(pixel_values=normalise(sized, IMAGENET)).last_hidden_state
        unit = functional.normalize(tokens.float(), dim=-1).mT
        return unit[..., 1:].unflatten(-1, (rows, columns)), unit[..., :1, None]

    def _load(self) -> Any:
        folder = models_folder(self.folder)
        return load_model(pin(self.weights, _KIND), folder, _WHAT, device=device_for(self.device))
