import pytest
import torch

from generator.backends.embedded.encoder import EmbeddedEncoder
from generator.backends.protocols import Encoder as EncoderProtocol


def picture(b: int = 2, side: int = 48, dtype: torch.dtype = torch.float32) -> torch.Tensor:
    generator = torch.Generator().manual_seed(0)
    coarse = torch.rand(b, 3, 6, 6, generator=generator, dtype=dtype)
    return torch.nn.functional.interpolate(coarse, (side, side), mode="bilinear")


def distance(a: torch.Tensor, b: torch.Tensor) -> float:
    pairs = zip(EmbeddedEncoder().features(a), EmbeddedEncoder().features(b), strict=True)
    return float(sum((x - y).square().sum(1).mean() for x, y in pairs))


def test_maps_are_spatial_bounded_and_of_stride_at_most_8():
    encoder = EmbeddedEncoder()
    assert isinstance(encoder, EncoderProtocol)
    maps = encoder.features(picture())
    assert [tuple(m.shape) for m in maps] == [(2, 6, s, s) for s in (24, 12, 6)]
    assert all(float(m.square().sum(1).max()) < 1 for m in maps)
    assert all(float(m.abs().max()) > 0.3 for m in maps)


def test_grey_has_no_features():
    assert all(
        float(m.abs().max()) < 1e-6
        for m in EmbeddedEncoder().features(torch.full((1, 3, 32, 32), 0.6))
    )


def test_brightness_counts_far_less_than_place():
    image = picture()
    dimmed, moved = 0.75 * image, image.roll(8, dims=-1)
    assert distance(image, dimmed) < 0.1 * distance(image, moved)


def test_colour_and_edge_direction_both_count():
    image = picture(1)
    assert distance(image, image[:, [2, 1, 0]]) > 0.1
    step = torch.zeros(1, 3, 32, 32)
    step[..., 16:] = 1
    assert distance(step, step.mT) > 0.02


def test_gradients_agree_with_finite_differences():
    image = picture(1, 16, torch.float64).requires_grad_()

    def total(x: torch.Tensor) -> torch.Tensor:
        maps = EmbeddedEncoder().features(x)
        return torch.stack(
            [(m * torch.linspace(0, 1, m.shape[-1], dtype=m.dtype)).sum() for m in maps]
        ).sum()

    (gradient,) = torch.autograd.grad(total(image), image)
    offset = torch.zeros_like(image)
    offset[0, 1, 5, 9] = 1e-6
    with torch.no_grad():
        slope = (total(image + offset) - total(image - offset)) / 2e-6
    assert float(gradient[0, 1, 5, 9]) == pytest.approx(float(slope), rel=1e-4)
    assert abs(float(slope)) > 1e-4
