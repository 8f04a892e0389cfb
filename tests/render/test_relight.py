import numpy as np
import pytest
import torch

from generator.errors import InputError
from generator.render import soft
from generator.render.relight import relit


def ball(side: int = 48) -> tuple[torch.Tensor, torch.Tensor]:
    """Return the normals of a ball that faces the camera, and its mask."""
    y, x = torch.meshgrid(*[torch.linspace(-1.2, 1.2, side)] * 2, indexing="ij")
    flat = x**2 + y**2
    cover = (flat < 1).float()
    normal = torch.stack([x, y, -(1 - flat).clamp_min(0).sqrt()]) * cover
    return normal[None], cover[None]


def lit(
    light: tuple[float, ...], tint: tuple[float, float, float], albedo: torch.Tensor
) -> tuple[soft.SoftImages, torch.Tensor, torch.Tensor]:
    """Return a ball's render in uniform light, its picture in another light, and its mask."""
    normal, cover = ball(albedo.shape[-1])
    shade = light[0] + (normal * torch.tensor(light[1:])[None, :, None, None]).sum(1)
    picture = albedo * shade[:, None] * torch.tensor(tint)[None, :, None, None]
    ground = 0.5 * (1 - cover[:, None])
    render = soft.SoftImages(albedo * cover[:, None] + ground, cover, normal)
    return render, picture * cover[:, None] + ground, cover


def stripes(side: int = 48) -> torch.Tensor:
    albedo = torch.full((1, 3, side, side), 0.6)
    albedo[:, 0, :, ::8] = 0.3
    return albedo


def test_the_light_of_a_picture_is_found():
    render, picture, cover = lit((0.7, 0.2, -0.15, -0.1), (1.0, 0.95, 0.85), stripes())
    before = (render.image - picture).abs()[cover[:, None].expand(-1, 3, -1, -1) > 0].mean()
    found = relit(render, picture, cover)
    after = (found - picture).abs()[cover[:, None].expand(-1, 3, -1, -1) > 0].mean()
    assert float(after) < 0.15 * float(before)
    assert torch.equal(found[0, :, 0, 0], torch.full((3,), 0.5)), "the ground stays grey"


def test_the_light_draws_no_pattern():
    """A ball without stripes stays without them, whatever its reference."""
    _, picture, cover = lit((0.7, 0.2, -0.15, -0.1), (1.0, 1.0, 1.0), stripes())
    plain, _, _ = lit((1.0, 0, 0, 0), (1.0, 1.0, 1.0), torch.full((1, 3, 48, 48), 0.6))
    found = relit(plain, picture, cover)[0, 0, 24, 16:32]
    assert float((found[2:] - 2 * found[1:-1] + found[:-2]).abs().max()) < 0.01
    assert float((picture[0, 0, 24, 16:32].diff()).abs().max()) > 0.1


def test_what_does_not_count_does_not_change_the_light():
    render, picture, cover = lit((0.8, 0.1, 0.0, -0.1), (1.0, 1.0, 1.0), stripes())
    spoilt = picture.clone()
    spoilt[..., 30:, :] = torch.tensor([1.0, 0.0, 1.0])[None, :, None, None]
    weight = cover.clone()
    weight[:, 30:] = 0
    assert torch.allclose(relit(render, picture, weight), relit(render, spoilt, weight))


def test_gradients_are_those_of_the_light_found():
    render, picture, cover = lit((0.7, 0.2, -0.15, -0.1), (1.0, 0.95, 0.85), stripes())
    image = render.image.clone().requires_grad_()
    relit(soft.SoftImages(image, cover, render.normal), picture, cover).sum().backward()
    assert image.grad is not None
    inside = image.grad[0, :, 24, 24]
    assert bool((inside > 0.3).all()) and bool((inside < 1.5).all())


def test_renders_without_normals_are_refused():
    render, picture, cover = lit((1.0, 0, 0, 0), (1.0, 1.0, 1.0), stripes())
    with pytest.raises(InputError, match="normals=True"):
        relit(soft.SoftImages(render.image, render.silhouette), picture, cover)


def test_normals_are_drawn_in_camera_axes():
    from test_soft import SIZE, center, l_shape, pose

    surface = soft.sample_surface(l_shape(), SIZE, 8000, 0)
    rotation = pose(torch.tensor([0.3]))
    drawn = soft.render(surface, rotation, center(1), 64, normals=True)
    assert drawn.normal is not None
    up = rotation[0, :, 2]
    shown = drawn.normal[0].permute(1, 2, 0)[drawn.silhouette[0] > 0.99]
    on_top = np.asarray((shown @ up) > 0.95)
    assert 0.3 < on_top.mean() < 0.95
    assert soft.render(surface, rotation, center(1), 64).normal is None
