"""The pinned models, if ``TABLETOPGEN_MODELS`` names a folder with them."""

import os

import numpy as np
import pytest
import torch
from painted import paint

from generator.backends.huggingface.encoder import HuggingFaceEncoder
from generator.backends.huggingface.segmenter import HuggingFaceSegmenter
from generator.backends.huggingface.weights.pins import missing, pins
from generator.backends.requirements import MODELS, models_folder
from generator.evaluation.perceptual import CLIP, DINOV2, HubSimilarity
from generator.scene import TABLE

pytestmark = pytest.mark.real

PLACES = [("mug", -0.3, -0.1, 0.0), ("book", 0.1, 0.0, 0.0), ("apple", 0.35, -0.15, 0.0)]
WORDS = ("mug", "book", "apple")


def needs(*names: str) -> None:
    absent = [n for n in names if missing(pins()[n], models_folder())]
    if not os.environ.get(MODELS) or absent:
        pytest.skip(f"{MODELS} names no folder with {', '.join(absent or names)}")


@pytest.mark.parametrize(
    ("detector", "models"),
    [
        ("grounding-dino-tiny", ("grounding-dino-tiny", "sam2")),
        ("grounding-dino-base", ("grounding-dino-base", "sam2")),
        ("sam3", ("sam3",)),
    ],
)
def test_things_on_a_painted_table_are_found(detector: str, models: tuple[str, ...]) -> None:
    needs(*models)
    picture = paint("rectangle", "oak", PLACES)
    found = HuggingFaceSegmenter(detector).segment(picture.image, (TABLE, *WORDS))
    truth = {name: picture.ids == k for k, name in enumerate((TABLE, *WORDS))}
    for name, mask in truth.items():
        shared = [(d.mask & mask).sum() / (d.mask | mask).sum() for d in found if d.label == name]
        assert max(shared, default=0) > 0.7, (name, shared)


def test_dinov2_tells_a_turned_thing_from_a_moved_light() -> None:
    needs("dinov2")
    image, turned = (
        torch.from_numpy(paint("rectangle", "oak", PLACES, azimuth=a).image.copy())
        .permute(2, 0, 1)[None] / 255 for a in (0.0, 40.0)
    )  # fmt: skip
    encoder = HuggingFaceEncoder()
    first, dim, other = (encoder.features(i) for i in (image, 0.9 * image, turned))

    def apart(a: tuple[torch.Tensor, ...], b: tuple[torch.Tensor, ...]) -> float:
        return float((a[0] - b[0]).square().sum(1).mean())

    assert apart(first, dim) < 0.5 * apart(first, other)


@pytest.mark.parametrize("metric", [DINOV2, CLIP], ids=lambda m: m.name)
def test_published_scores_tell_a_table_from_noise(metric: HubSimilarity) -> None:
    needs(metric.name)
    image = paint("rectangle", "oak", PLACES).image
    near = paint("rectangle", "oak", PLACES, azimuth=10.0).image
    noise = np.random.default_rng(0).integers(0, 256, image.shape).astype(np.uint8)
    scores = metric.score([image, near, noise], image)
    assert scores[0] == pytest.approx(1, abs=1e-3)
    assert scores[0] > scores[1] > scores[2] + 0.1
