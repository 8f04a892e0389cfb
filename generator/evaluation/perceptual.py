"""Perceptual similarity of pictures (Sec. 4.1): LPIPS, DINOv2, CLIP, and embedded metrics.

The published metrics need packages (the extras ``huggingface`` and ``lpips``) and weights that are
already on this machine: nothing is downloaded. A missing metric is reported with the reason. The
embedded metrics need neither. They are different quantities with different names, and their values
must not be compared with those of the published metrics.
"""

from __future__ import annotations

import importlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from importlib.util import find_spec
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import cv2
import numpy as np
from jaxtyping import Float, UInt8

from ..backends.huggingface.detection.detections import IMAGENET, Norm, normalise
from ..errors import BackendError, choices
from .surfaces.sweep import Metric

if TYPE_CHECKING:
    from torch import Tensor

Picture = UInt8[np.ndarray, "_ _ 3"]

_PIP = "Run: pip install 'tabletopgen[lpips]'"
_BATCH = 16
_SIDE = 224
"""Side, in pixels, to which pictures are resized before features are computed."""


class Missing(BackendError):
    """A metric's package or weights are not on this machine."""


@dataclass(frozen=True)
class MapSimilarity:
    """Cosine similarity of an encoder's feature maps, averaged over positions; 1 for equal maps.

    ``load`` returns the encoder, which maps images (n, 3, h, w) in [0, 1] to feature maps.
    """

    name: str
    load: Callable[[], Callable[[Tensor], tuple[Tensor, ...]]]
    higher_is_better: bool = True

    def score(self, pictures: Sequence[Picture], reference: Picture) -> Float[np.ndarray, "n"]:
        """Return the similarity of each picture to the reference, in [-1, 1].

        Raises:
            BackendError: The encoder's weights are missing or damaged.
        """
        import torch
        from torch.nn import functional

        maps = self.load()

        def compare(images: Tensor, goal: Tensor) -> Tensor:
            cosines = [
                functional.cosine_similarity(a.flatten(1), b.flatten(1), 1)
                for a, b in zip(maps(images), maps(goal), strict=True)
            ]
            return torch.stack(cosines).mean(0)

        return _compare(compare, pictures, reference)


def _load_filters() -> Callable[[Tensor], tuple[Tensor, ...]]:
    """Return the embedded encoder, which encodes colours and edges: layout rather than meaning."""
    from ..backends.embedded.encoder import EmbeddedEncoder

    return EmbeddedEncoder().features


def _load_lite() -> Callable[[Tensor], tuple[Tensor, ...]]:
    """Return the detector's EfficientNet-Lite0, tuned on renders, with maps of stride 16 and 32."""
    from ..backends.embedded.eye.weights import load_weights

    encoder = load_weights().eye.encoder
    return lambda images: encoder(images)[-2:]


@dataclass(frozen=True)
class Lpips:
    """LPIPS (R. Zhang et al., CVPR 2018) with AlexNet: 0 for equal pictures; lower is better."""

    name: str = "lpips"
    higher_is_better: bool = False
    backbone: str = "alexnet-owt-7be5be79.pth"

    @cached_property
    def _network(self) -> Any:
        import torch

        module = _package("lpips", self.name)
        _package("torchvision", self.name)
        weights = Path(torch.hub.get_dir()) / "checkpoints" / self.backbone
        if not weights.is_file():
            raise Missing(
                f"{self.name}: AlexNet's weights are not in torch's cache. Put {self.backbone} "
                "into the folder `checkpoints` of torch.hub.get_dir(); it is not downloaded "
                "automatically."
            )
        return module.LPIPS(net="alex", verbose=False).eval()

    def score(self, pictures: Sequence[Picture], reference: Picture) -> Float[np.ndarray, "n"]:
        """Return the distance of each picture from the reference, at 224 x 224 pixels.

        Raises:
            Missing: The package or the weights are not on this machine.
        """
        network = self._network

        def distance(images: Tensor, goal: Tensor) -> Tensor:
            return network(2 * images - 1, (2 * goal - 1).expand_as(images)).flatten()

        return _compare(distance, pictures, reference)


@dataclass(frozen=True)
class HubSimilarity:
    """Cosine similarity of a published vision model's image features; 1 for equal pictures.

    ``name`` is the model's name in the table of the ``huggingface`` backend, which pins its commit;
    the model is read only from ``folder`` (see ``backends.installing.models_folder``). ``method``
    is the source of the features: "pooled" (of ``Dinov2Model``) or "image" (of ``CLIPModel``).
    ``norm`` is the mean and standard deviation of RGB in [0, 1].
    """

    name: str
    method: str
    norm: Norm
    folder: str = ""
    higher_is_better: bool = True

    @cached_property
    def _network(self) -> Any:
        from ..backends.huggingface.weights.loader import load_model
        from ..backends.huggingface.weights.pins import pin
        from ..backends.requirements import models_folder

        try:
            return load_model(pin(self.name), models_folder(self.folder), f"{self.name}:")
        except BackendError as error:
            raise Missing(str(error)) from error

    def score(self, pictures: Sequence[Picture], reference: Picture) -> Float[np.ndarray, "n"]:
        """Return the similarity of each picture to the reference, in [-1, 1].

        Raises:
            Missing: The package or the weights are not on this machine.
        """
        import torch
        from torch.nn import functional

        network = self._network

        def vectors(images: Tensor) -> Tensor:
            values = normalise(images, self.norm)
            if self.method == "image":
                found = network.get_image_features(pixel_values=values)
                return found if isinstance(found, torch.Tensor) else found.pooler_output
            return network(pixel_values=values).pooler_output

        def compare(images: Tensor, goal: Tensor) -> Tensor:
            return functional.cosine_similarity(vectors(images), vectors(goal), 1)

        return _compare(compare, pictures, reference)


DINOV2 = HubSimilarity("dinov2", "pooled", IMAGENET)
"""The DINOv2 model (M. Oquab et al., 2023)."""

CLIP = HubSimilarity(
    "clip", "image", ((0.48145466, 0.4578275, 0.40821073), (0.26862954, 0.26130258, 0.27577711))
)
"""The CLIP model (A. Radford et al., ICML 2021)."""

EMBEDDED: Mapping[str, Metric] = MappingProxyType(
    {
        name: MapSimilarity(name, load)
        for name, load in (
            ("embedded_feature_similarity", _load_filters),
            ("embedded_lite0_similarity", _load_lite),
        )
    }
)
"""Metrics that are available in every installation."""

PUBLISHED: Mapping[str, Metric] = MappingProxyType({m.name: m for m in (Lpips(), DINOV2, CLIP)})
"""The paper's metrics."""


@dataclass(frozen=True)
class Available:
    """The metrics available on this machine, and the reasons why others are missing, by name."""

    metrics: tuple[Metric, ...]
    missing: Mapping[str, str]


def available(names: Sequence[str] = (*PUBLISHED, *EMBEDDED)) -> Available:
    """Return which of the named metrics work on this machine, by loading each of them.

    Raises:
        BackendError: A metric does not exist.
    """
    known = {**PUBLISHED, **EMBEDDED}
    blank = np.zeros((32, 32, 3), np.uint8)
    metrics, missing = [], {}
    for name in names:
        if name not in known:
            raise BackendError(f"Unknown metric {name!r}.{choices(name, known)}")
        try:
            known[name].score([blank], blank)
            metrics.append(known[name])
        except BackendError as error:
            missing[name] = str(error)
    return Available(tuple(metrics), MappingProxyType(missing))


def _package(name: str, metric: str) -> Any:
    if find_spec(name) is None:
        raise Missing(f"{metric}: the package {name} is not installed. {_PIP}")
    try:
        return importlib.import_module(name)
    except (ImportError, RuntimeError, OSError) as error:
        raise Missing(f"{metric}: the package {name} cannot be loaded ({error}). {_PIP}") from error


def _tensor(pictures: Sequence[Picture]) -> Tensor:
    """Return pictures as an array (n, 3, side, side) in [0, 1]."""
    import torch

    side = _SIDE, _SIDE
    small = [cv2.resize(np.asarray(p), side, interpolation=cv2.INTER_AREA) for p in pictures]
    return torch.from_numpy(np.stack(small)).permute(0, 3, 1, 2).float() / 255


def _compare(
    compare: Callable[[Tensor, Tensor], Tensor], pictures: Sequence[Picture], reference: Picture
) -> Float[np.ndarray, "n"]:
    """Apply ``compare`` to each picture and the reference, in batches."""
    import torch

    with torch.no_grad():
        goal = _tensor([reference])
        batches = (pictures[k : k + _BATCH] for k in range(0, len(pictures), _BATCH))
        parts = [compare(_tensor(batch), goal) for batch in batches]
    return np.concatenate([p.double().numpy() for p in parts]) if parts else np.zeros(0)
