"""Similarity scores: embedded ones work; published ones work or are reported missing."""

import dataclasses
import sys
from importlib.machinery import ModuleSpec
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest
import torch

from generator.errors import BackendError
from generator.evaluation.perceptual import (
    CLIP,
    DINOV2,
    EMBEDDED,
    PUBLISHED,
    HubSimilarity,
    Lpips,
    Missing,
    available,
)


def picture(seed: int) -> np.ndarray:
    """Blocks of colour."""
    rng = np.random.default_rng(seed)
    return rng.integers(0, 255, (6, 8, 3)).repeat(20, 0).repeat(20, 1).astype(np.uint8)


def module(name: str, monkeypatch: pytest.MonkeyPatch, **members: Any) -> None:
    made = ModuleType(name)
    made.__spec__ = ModuleSpec(name, None)
    for key, value in members.items():
        setattr(made, key, value)
    monkeypatch.setitem(sys.modules, name, made)


def absent(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("generator.evaluation.perceptual.find_spec", lambda name: None)
    monkeypatch.setitem(sys.modules, "transformers", None)


@pytest.mark.slow
@pytest.mark.parametrize("name", sorted(EMBEDDED))
def test_an_embedded_score_is_highest_for_the_same_picture(name: str) -> None:
    same, near, other = picture(0), picture(0), picture(1)
    near[:20] = 255
    scores = EMBEDDED[name].score([other, near, same], picture(0))
    assert scores[2] == pytest.approx(1, abs=1e-4)
    assert scores[0] < scores[1] < scores[2]


def test_embedded_and_published_scores_share_no_name() -> None:
    assert not EMBEDDED.keys() & PUBLISHED.keys()
    assert all(name.startswith("embedded_") for name in EMBEDDED)
    assert set(PUBLISHED) == {"lpips", "dinov2", "clip"}


@pytest.mark.slow
def test_what_is_not_installed_is_told_with_the_reason(monkeypatch: pytest.MonkeyPatch) -> None:
    absent(monkeypatch)
    found = available()
    assert {m.name for m in found.metrics} == set(EMBEDDED)
    assert set(found.missing) == set(PUBLISHED)
    assert all("pip install" in reason for reason in found.missing.values())
    assert "transformers, which cannot be imported" in found.missing["clip"]


def test_an_unknown_metric_lists_the_choices() -> None:
    with pytest.raises(BackendError, match="Did you mean 'lpips'"):
        available(["lpip"])


@pytest.mark.slow
@pytest.mark.parametrize("metric", [DINOV2, CLIP], ids=lambda m: m.name)
def test_published_models_are_the_pinned_ones_on_this_machine(
    metric: HubSimilarity, tiny_models: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with pytest.raises(Missing, match=f"tabletopgen models pull {metric.name}"):
        dataclasses.replace(metric, folder=str(tmp_path)).score([picture(0)], picture(0))
    monkeypatch.setenv("TABLETOPGEN_MODELS", str(tiny_models))
    same, other = dataclasses.replace(metric).score([picture(0), picture(1)], picture(0))
    assert same == pytest.approx(1)
    assert other < 0.99999


@pytest.mark.slow
def test_published_models_see_what_the_reference_implementation_sees(tiny_models: Path) -> None:
    """A black picture: the model's input has only mean and deviation."""
    transformers = pytest.importorskip("transformers")
    black = np.zeros((9, 9, 3), np.uint8)
    for metric, norm in ((DINOV2, transformers.image_utils.IMAGENET_DEFAULT_MEAN),
                         (CLIP, transformers.image_utils.OPENAI_CLIP_MEAN)):  # fmt: skip
        made = dataclasses.replace(metric, folder=str(tiny_models))
        seen: list[torch.Tensor] = []

        def note(_module: Any, _args: Any, given: dict[str, torch.Tensor], seen=seen) -> None:
            seen.append(given["pixel_values"])

        network = made._network
        vision = network.vision_model if metric is CLIP else network
        vision.register_forward_pre_hook(note, with_kwargs=True)
        made.score([black], black)
        color = seen[0][0, :, 0, 0] * torch.tensor(metric.norm[1])
        torch.testing.assert_close(color, -torch.tensor(norm))


def test_lpips_wants_its_weights_on_this_machine_and_compares_in_its_range(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    class Distance:
        def __init__(self, **options: Any) -> None:
            assert options["net"] == "alex"

        def eval(self) -> Any:
            return self

        def __call__(self, a: torch.Tensor, b: torch.Tensor) -> torch.Tensor:
            assert a.shape == b.shape
            assert a.min() >= -1
            assert a.max() <= 1
            return (a - b).abs().mean((1, 2, 3), keepdim=True)

    module("lpips", monkeypatch, LPIPS=Distance)
    module("torchvision", monkeypatch)
    monkeypatch.setattr(torch.hub, "get_dir", lambda: str(tmp_path))
    with pytest.raises(Missing, match="AlexNet"):
        Lpips().score([picture(0)], picture(0))
    weights = tmp_path / "checkpoints" / Lpips().backbone
    weights.parent.mkdir()
    weights.write_bytes(b"")
    same, other = Lpips().score([picture(0), picture(1)], picture(0))
    assert same == 0
    assert other > 0.1
    assert not Lpips().higher_is_better
