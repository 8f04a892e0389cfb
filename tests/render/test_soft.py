import numpy as np
import pytest
import torch

from generator.errors import InputError
from generator.geometry import Camera, mask_box, rotation_z, view_rotation, yaw_quaternion
from generator.render import raster, soft
from generator.render.crop import MARGIN, tight_crop
from generator.scene import Mesh, View

SIZE = np.array([0.2, 0.12, 0.08])
VIEW = View(azimuth=0.2, elevation=np.deg2rad(50.0), fov=np.deg2rad(40.0))


def l_shape() -> Mesh:
    """An L seen from above, red at the foot and blue at the top, in the unit box."""
    outline = np.array([[0, 0], [1, 0], [1, 0.4], [0.4, 0.4], [0.4, 1], [0, 1]]) - 0.5
    n = len(outline)
    low = np.column_stack([outline, np.full(n, -0.5)])
    vertices = np.concatenate([low, low + np.array([0, 0, 1])])
    caps = np.array([[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]])
    i, j = np.arange(n), (np.arange(n) + 1) % n
    sides = np.concatenate([np.stack([i, j, j + n], 1), np.stack([i, j + n, i + n], 1)])
    faces = np.concatenate([caps[:, ::-1], caps + n, sides])
    uv = np.column_stack([np.full(2 * n, 0.5), np.repeat([0.0, 1.0], n)])
    texture = np.zeros((2, 1, 3), np.uint8)
    texture[0, 0], texture[1, 0] = (20, 20, 230), (230, 20, 20)
    return Mesh(vertices, faces, uv, texture)


def pose(yaw: torch.Tensor, tilt: torch.Tensor | None = None) -> torch.Tensor:
    world = torch.as_tensor(view_rotation(VIEW), dtype=yaw.dtype)
    return soft.object_to_camera(yaw, torch.zeros_like(yaw) if tilt is None else tilt, world)


def center(b: int, dtype: torch.dtype = torch.float32) -> torch.Tensor:
    return torch.tensor([[0.1, -0.05, 1.0]], dtype=dtype).expand(b, 3)


def test_points_cover_the_surface_evenly():
    surface = soft.sample_surface(l_shape(), SIZE, 4000, seed=0)
    x, y, z = SIZE
    caps, wall = 2 * 0.64 * x * y, 2 * (x + y) * z
    assert float(surface.area) * 4000 == pytest.approx(caps + wall, rel=1e-5)
    on_top = (surface.normal[0, :, 2] > 0.99).float().mean()
    assert float(on_top) == pytest.approx(caps / 2 / (caps + wall), abs=0.003)
    assert bool((surface.position.abs() <= torch.as_tensor(SIZE / 2 + 1e-6)).all())
    assert surface.corners.shape[1] == 10  # the inner corner of the L is not on the hull


def test_a_body_under_its_label_does_not_show_through():
    body = l_shape()
    label = np.array([[-0.4, -0.4, 0.51], [0.4, -0.4, 0.51], [0.4, -0.2, 0.51], [-0.4, -0.2, 0.51]])
    vertices = np.concatenate([body.vertices, label])
    faces = np.concatenate([body.faces, [[12, 13, 14], [12, 14, 15]]])
    uv = np.concatenate([body.uv, np.full((4, 2), 0.0)])  # blue, over the red top
    surface = soft.sample_surface(Mesh(vertices, faces, uv, body.texture), SIZE, 8000, 0)
    assert not bool(soft.sample_surface(body, SIZE, 8000, 0).covered.any())
    position, covered = surface.position[0], surface.covered[0]
    on_top = (surface.normal[0, :, 2] > 0.99) & (position[:, 2] < SIZE[2] / 2 + 1e-5)
    assert not bool(covered[~on_top].any())
    low, high = torch.as_tensor(label[[0, 2], :2] * SIZE[:2])
    inside = ((position[:, :2] > low) & (position[:, :2] < high)).all(1) & on_top
    assert float(covered[inside].float().mean()) > 0.95


def test_same_seed_same_points_and_other_seed_others():
    first, again, other = (soft.sample_surface(l_shape(), SIZE, 500, s) for s in (1, 1, 2))
    assert torch.equal(first.position, again.position)
    assert not torch.equal(first.position, other.position)


def test_a_mesh_without_area_is_refused():
    line = Mesh(np.eye(3) * 0, np.array([[0, 1, 2]]), np.zeros((3, 2)), np.zeros((1, 1, 3)))
    with pytest.raises(InputError, match="no surface area"):
        soft.sample_surface(line, SIZE, 10, 0)


def test_pose_agrees_with_the_geometry_module():
    yaw, tilt = 0.7, 0.05
    ours = pose(torch.tensor([yaw]), torch.tensor([tilt]))[0].numpy()
    raised = View(VIEW.azimuth, VIEW.elevation + tilt, VIEW.fov)
    np.testing.assert_allclose(ours, view_rotation(raised) @ rotation_z(yaw), atol=1e-6)


def test_fit_center_fills_the_box():
    surface = soft.sample_surface(l_shape(), SIZE, 100, 0)
    rotation = pose(torch.tensor([0.0, 0.9, 2.1]))
    middle, span = torch.tensor([[0.3, -0.2]] * 3), torch.tensor([[0.12, 0.1]] * 3)
    corners = surface.corners.expand(3, -1, 3)
    low, high = soft.bounds(corners, rotation, soft.fit_center(corners, rotation, middle, span))
    assert torch.allclose((low + high) / 2, middle, atol=2e-3)
    assert torch.allclose((high - low).prod(1), span.prod(1), rtol=0.02)


@pytest.mark.parametrize("keep_aspect", [True, False])
def test_silhouette_and_colour_agree_with_the_hard_renderer(keep_aspect):
    yaws = np.array([0.3, 1.9, 4.0])
    surface = soft.sample_surface(l_shape(), SIZE, 8000, 0)
    images = soft.render(surface, pose(torch.tensor(yaws).float()), center(3), 96, keep_aspect)
    camera = Camera(np.zeros(3), view_rotation(VIEW), 0.5, 500, 500)
    position = center(1)[0].numpy() @ view_rotation(VIEW)
    for k, yaw in enumerate(yaws):
        item = raster.place(l_shape(), SIZE, position, yaw_quaternion(yaw))
        hard = raster.render([item], camera, shadows=False, supersample=1)
        mask = hard.ids >= 0
        rgba = np.dstack([hard.image, mask.astype(np.uint8) * 255])
        crop = tight_crop(rgba, mask_box(mask), 96, keep_aspect)
        target, found = crop[..., 3], images.silhouette[k].numpy()
        iou = np.minimum(target, found).sum() / np.maximum(target, found).sum()
        assert iou > 0.96
        inside = target > 0.99
        difference = np.abs(crop[..., :3] - images.image[k].permute(1, 2, 0).numpy())
        assert difference[inside].mean() < 0.12  # the lights differ
        hue_found = (images.image[k, 0] - images.image[k, 2]).numpy()[inside]
        hue_hard = (crop[..., 0] - crop[..., 2])[inside]
        assert np.corrcoef(hue_found, hue_hard)[0, 1] > 0.95


def test_silhouette_area_is_the_projected_area():
    surface = soft.sample_surface(l_shape(), SIZE, 8000, 0)
    straight_down = torch.diag(torch.tensor([1.0, -1.0, -1.0]))[None]
    images = soft.render(surface, straight_down, torch.tensor([[0.0, 0.0, 50.0]]), 128)
    side = 128 * (1 - 2 * MARGIN)
    assert float(images.silhouette.sum()) == pytest.approx(0.64 * side**2 * 0.6, rel=0.03)


def test_candidates_do_not_influence_each_other():
    surface = soft.sample_surface(l_shape(), SIZE, 1000, 0)
    yaws = torch.tensor([0.1, 2.0, 4.4])
    together = soft.render(surface, pose(yaws), center(3), 48)
    alone = soft.render(surface, pose(yaws[1:2]), center(1), 48)
    assert torch.allclose(together.image[1:2], alone.image, atol=1e-5)
    assert torch.allclose(together.silhouette[1:2], alone.silhouette, atol=1e-5)


def test_objects_of_a_stack_are_drawn_as_if_alone():
    body = l_shape()
    other = Mesh(body.vertices * [1, 1, 0.5], body.faces, body.uv, body.texture)
    surfaces = [soft.sample_surface(m, SIZE, 1000, 0) for m in (l_shape(), other)]
    yaws = torch.tensor([0.1, 2.0, 4.4])
    owner = torch.tensor([1, 0, 1])
    together = soft.render(soft.stack(surfaces), pose(yaws), center(3), 48, owner=owner)
    for k, number in enumerate(owner.tolist()):
        alone = soft.render(surfaces[number], pose(yaws[k : k + 1]), center(1), 48)
        assert torch.allclose(together.image[k], alone.image[0], atol=1e-5)


def test_thinned_surfaces_look_alike():
    surface = soft.sample_surface(l_shape(), SIZE, 9000, 0)
    few = surface.thin(3)
    assert few.position.shape[1] == 3000
    assert float(few.area) == pytest.approx(3 * float(surface.area))
    yaws = torch.tensor([0.3])
    whole, thin = (soft.render(s, pose(yaws), center(1), 48).silhouette for s in (surface, few))
    assert float((whole - thin).abs().mean()) < 0.01


def test_a_fit_moves_the_object_in_its_crop():
    surface = soft.sample_surface(l_shape(), SIZE, 4000, 0)
    tight = soft.render(surface, pose(torch.tensor([0.3])), center(1), 64).silhouette[0]
    fit = soft.CropFit(torch.tensor([[0.125, -0.0625]]), torch.zeros(1))
    moved = soft.render(surface, pose(torch.tensor([0.3])), center(1), 64, fit=fit).silhouette[0]
    rolled = torch.roll(tight, (-4, 8), (0, 1))
    assert float((rolled - moved).abs()[8:-8, 12:-12].max()) < 0.02
    smaller = soft.CropFit(torch.zeros(1, 2), torch.tensor([-0.2]))
    shrunk = soft.render(surface, pose(torch.tensor([0.3])), center(1), 64, fit=smaller).silhouette
    assert float(shrunk.sum() / tight.sum()) == pytest.approx(np.exp(-0.4), rel=0.05)


@pytest.mark.parametrize("keep_aspect", [True, False])
@pytest.mark.parametrize("what", ["silhouette", "edges", "image"])
def test_gradients_agree_with_finite_differences(what, keep_aspect):
    surface = soft.sample_surface(l_shape(), SIZE, 3000, 0, torch.float64)
    ramp = torch.linspace(-1, 1, 32, dtype=torch.float64)
    weights = torch.outer(ramp, ramp.flip(0) ** 2) + ramp

    def measure(angles: torch.Tensor) -> torch.Tensor:
        rotation = pose(angles[:1], angles[1:])
        images = soft.render(surface, rotation, center(1, torch.float64), 32, keep_aspect)
        shown = {
            "silhouette": images.silhouette,
            "edges": soft.sobel_edges(images.silhouette),
            "image": images.image,
        }[what]
        return (shown * weights).sum()

    angles = torch.tensor([0.5, 0.02], dtype=torch.float64, requires_grad=True)
    (gradient,) = torch.autograd.grad(measure(angles), angles)
    step = 1e-6
    for k in range(2):
        offset = step * torch.eye(2, dtype=torch.float64)[k]
        with torch.no_grad():
            slope = (measure(angles + offset) - measure(angles - offset)) / (2 * step)
        assert float(gradient[k]) == pytest.approx(float(slope), rel=1e-3, abs=1e-3)
        assert abs(float(slope)) > 0.1


def test_sobel_edges_follow_the_contour():
    square = torch.zeros(1, 12, 12)
    square[:, 3:9, 3:9] = 1
    edges = soft.sobel_edges(square)[0]
    assert float(edges[6, 3]) == pytest.approx(0.5, abs=2e-3)  # half of the step on either side
    assert float(edges[6, 2]) == pytest.approx(0.5, abs=2e-3)
    assert float(edges[6, 6]) == 0 and float(edges[0, 0]) == 0


def test_tight_crop_fits_the_longer_side_or_both():
    rgba = np.zeros((40, 60, 4), np.uint8)
    rgba[10:20, 10:50] = 255
    box = np.array([10.0, 10, 50, 20])
    kept, stretched = (tight_crop(rgba, box, 100, keep)[..., 3] > 0.5 for keep in (True, False))
    np.testing.assert_allclose(mask_box(kept), [5, 50 - 11.25, 95, 50 + 11.25], atol=1)
    np.testing.assert_allclose(mask_box(stretched), [5, 5, 95, 95], atol=1)
