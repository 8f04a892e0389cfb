"""DINOv2 as the encoder: the real class, tiny and with random weights."""

from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

import pytest
import tiny_models as tiny
import torch
from torch.nn import functional

from generator.backends.huggingface import encoder as module
from generator.backends.huggingface.detection.detections import IMAGENET
from generator.backends.huggingface.encoder import HuggingFaceEncoder
from generator.backends.huggingface.weights.loader import load_model
from generator.backends.huggingface.weights.pins import pins, snapshot
from generator.backends.protocols import Encoder as Protocol
from generator.errors import BackendError


@pytest.fixture
def encoder(tiny_models: Path) -> HuggingFaceEncoder:
    return HuggingFaceEncoder(side=56, folder=str(tiny_models), device="cpu")


def pictures(count: int = 2, height: int = 40, width: int = 40) -> torch.Tensor:
    generator = torch.Generator().manual_seed(0)
    coarse = torch.rand(count, 3, 5, 5, generator=generator)
    return functional.interpolate(coarse, (height, width), mode="bilinear")


def test_there_is_a_map_of_the_patches_and_one_of_the_whole(encoder: HuggingFaceEncoder) -> None:
    assert isinstance(encoder, Protocol)
    patches, whole = encoder.features(pictures(3))
    assert patches.shape == (3, 32, 4, 4)
    assert whole.shape == (3, 32, 1, 1)
    for level in (patches, whole):
        torch.testing.assert_close(level.norm(dim=1), torch.ones_like(level[:, 0]))


@pytest.mark.parametrize(
    ("height", "width", "rows", "columns"),
    [(40, 40, 4, 4), (56, 56, 4, 4), (30, 60, 4, 8), (200, 100, 8, 4), (40, 43, 4, 4)],
)
def test_the_shorter_side_is_as_long_as_set_in_whole_patches(
    encoder: HuggingFaceEncoder, height: int, width: int, rows: int, columns: int
) -> None:
    patches, _ = encoder.features(pictures(1, height, width))
    assert patches.shape[-2:] == (rows, columns)


def test_the_maps_are_dinov2_s_tokens_where_they_are(
    encoder: HuggingFaceEncoder, tiny_models: Path
) -> None:
    images = pictures(1, 56, 84)
    network = load_model(pins()["dinov2"], tiny_models, "who:")
    mean, deviation = (torch.tensor(v).view(1, 3, 1, 1) for v in IMAGENET)
    with torch.no_grad():
        tokens = network(pixel_values=(images - mean) / deviation).last_hidden_state[0]
    patches, whole = encoder.features(images)
    unit = functional.normalize(tokens, dim=-1)
    torch.testing.assert_close(whole[0, :, 0, 0], unit[0])
    torch.testing.assert_close(patches[0, :, 0, 5], unit[1 + 5])
    torch.testing.assert_close(patches[0, :, 2, 1], unit[1 + 2 * 6 + 1])


@pytest.mark.slow
def test_a_batch_is_its_pictures_one_by_one(tiny_models: Path) -> None:
    images = pictures(5)
    whole = HuggingFaceEncoder(side=56, folder=str(tiny_models)).features(images)
    parts = HuggingFaceEncoder(side=56, batch=2, folder=str(tiny_models)).features(images)
    singles = [
        HuggingFaceEncoder(side=56, folder=str(tiny_models)).features(i[None]) for i in images
    ]
    for k, (one, other) in enumerate(zip(whole, parts, strict=True)):
        torch.testing.assert_close(one, other, atol=1e-5, rtol=1e-4)
        torch.testing.assert_close(one, torch.cat([s[k] for s in singles]), atol=1e-5, rtol=1e-4)


@pytest.mark.slow
@pytest.mark.parametrize("side", [40, 90])
def test_gradients_agree_with_finite_differences(encoder: HuggingFaceEncoder, side: int) -> None:
    """Along one direction over all pixels, enlarged to the network's size and reduced to it."""
    images = pictures(2, side, side).requires_grad_()
    generator = torch.Generator().manual_seed(1)
    weights = [torch.randn(m.shape, generator=generator) for m in encoder.features(images)]

    def total(x: torch.Tensor) -> torch.Tensor:
        maps = encoder.features(x)
        return sum(((m * w).sum() for m, w in zip(maps, weights, strict=True)), torch.tensor(0.0))

    (gradient,) = torch.autograd.grad(total(images), images)
    direction = pictures(2, side, side).flip(0) - 0.5
    with torch.no_grad():
        step = 5e-3 * direction
        slope = float(total(images + step) - total(images - step)) / 1e-2
    assert float((gradient * direction).sum()) == pytest.approx(slope, rel=0.02)
    assert abs(slope) > 0.05
    assert (gradient.abs().sum((1, 2, 3)) > 0).all()


def test_features_for_no_gradient_keep_none(encoder: HuggingFaceEncoder) -> None:
    with torch.no_grad():
        assert not any(m.requires_grad for m in encoder.features(pictures().requires_grad_()))
    assert all(p.grad is None for p in encoder._network().parameters())


def test_maps_have_the_type_of_the_images(encoder: HuggingFaceEncoder) -> None:
    assert {m.dtype for m in encoder.features(pictures().double())} == {torch.float64}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("device", "exact", "fast"),
    [("cpu", False, False), ("cuda", False, True), ("cuda", True, False)],
)
def test_bfloat16_is_for_cuda_only(
    tiny_models: Path, monkeypatch: pytest.MonkeyPatch, device: str, exact: bool, fast: bool
) -> None:
    """The network pretends to be on CUDA, and works here."""
    entered: list[tuple[str, Any, bool]] = []

    class Autocast(torch.autocast):
        def __init__(self, kind: str, dtype: torch.dtype, enabled: bool) -> None:
            entered.append((kind, dtype, enabled))
            super().__init__("cpu", dtype, enabled)

    network = load_model(pins()["dinov2"], tiny_models, "who:")
    real, asked = torch.Tensor.to, torch.device(device)
    monkeypatch.setattr(type(network), "device", property(lambda _: asked))
    monkeypatch.setattr(
        torch.Tensor, "to",
        lambda x, *to, **o: real(x, *[torch.device("cpu") if t == asked else t for t in to], **o),
    )  # fmt: skip
    monkeypatch.setattr(torch, "autocast", Autocast)
    monkeypatch.setattr(module, "load_model", lambda *_, **__: network)
    patches, _ = HuggingFaceEncoder(side=56, exact=exact).features(pictures(1))
    assert (device, torch.bfloat16, fast) in entered
    assert patches.dtype == torch.float32
    exactly, _ = HuggingFaceEncoder(side=56, exact=True).features(pictures(1))
    error = float((patches - exactly).norm())
    assert (1e-4 < error < 0.2) if fast else error == 0


def test_threads_share_one_network(tiny_models: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """As in the rotation stage: one thread per object."""
    loads: list[int] = []
    real = module.load_model

    def load(*given: Any, **named: Any) -> Any:
        loads.append(1)
        return real(*given, **named)

    monkeypatch.setattr(module, "load_model", load)
    encoder, images = HuggingFaceEncoder(side=56, folder=str(tiny_models)), pictures(4)
    with ThreadPoolExecutor(4) as pool:
        made = list(pool.map(lambda image: encoder.features(image[None])[0], images))
    assert len(loads) == 1
    torch.testing.assert_close(torch.cat(made), encoder.features(images)[0], atol=1e-5, rtol=1e-4)


def test_another_patch_size_is_the_model_s(tmp_path: Path) -> None:
    tiny.dinov2(step=8).save_pretrained(snapshot(pins()["dinov2"], tmp_path))
    patches, _ = HuggingFaceEncoder(side=56, folder=str(tmp_path)).features(pictures(1))
    assert patches.shape[-2:] == (7, 7)


@pytest.mark.parametrize("shape", [(3, 28, 28), (1, 4, 28, 28), (1, 1, 28, 28)])
def test_what_is_no_batch_of_images_is_told(
    encoder: HuggingFaceEncoder, shape: tuple[int, ...]
) -> None:
    with pytest.raises(BackendError, match=r"huggingface, features: images must be \(b, 3, h, w\)"):
        encoder.features(torch.zeros(shape))


def test_a_network_that_fails_is_told(
    encoder: HuggingFaceEncoder, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: Any, **__: Any) -> None:
        raise RuntimeError("out of memory")

    monkeypatch.setattr(type(encoder._network()), "forward", fail)
    with pytest.raises(
        BackendError, match=r"huggingface, features: the model failed \(RuntimeError"
    ):
        encoder.features(pictures(1))
