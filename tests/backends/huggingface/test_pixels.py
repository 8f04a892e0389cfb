"""Model input pictures compared with the processors of transformers."""

import numpy as np
import pytest
import torch
import transformers

from generator.backends.huggingface.detection.detections import (
    HALVES,
    IMAGENET,
    bound_size,
    normalise,
    to_batch,
)


@pytest.mark.parametrize("size", [(64, 48), (48, 64), (300, 40), (40, 300), (50, 50)])
def test_a_picture_is_resized_and_normalised_as_grounding_dino_s_processor_does(
    size: tuple[int, int],
) -> None:
    width, height = size
    image = np.random.default_rng(0).integers(0, 256, (height, width, 3)).astype(np.uint8)
    processor = transformers.GroundingDinoImageProcessorPil(
        size={"shortest_edge": 60, "longest_edge": 100}
    )
    right = torch.as_tensor(processor(image, return_tensors="pt")["pixel_values"])
    made = to_batch(image, *bound_size(width, height, 60, 100), IMAGENET)
    torch.testing.assert_close(made, right, atol=1e-5, rtol=0)


def test_a_model_with_halves_sees_values_from_minus_one_to_one() -> None:
    image = np.array([[[0, 255, 0]]], np.uint8)
    np.testing.assert_allclose(to_batch(image, 1, 1, HALVES).flatten(), [-1, 1, -1])


def test_normalising_keeps_gradients() -> None:
    image = torch.full((1, 3, 2, 2), 0.5, requires_grad=True)
    normalise(image, IMAGENET).sum().backward()
    assert image.grad is not None
    np.testing.assert_allclose(image.grad[0, :, 0, 0], 1 / np.array(IMAGENET[1]), rtol=1e-6)
