"""The network's parts, and its behaviour without weights."""

import numpy as np
import pytest
import torch

from generator.backends.embedded.eye import weights
from generator.backends.embedded.eye.frames import Frame
from generator.backends.embedded.eye.lite0 import CHANNELS, Lite0, fold
from generator.backends.embedded.eye.network import HINTS, STRIDE, Eye
from generator.backends.embedded.plane.tabletop import fit_view
from generator.errors import BackendError
from generator.geometry import Camera, view_rotation
from generator.scene import View


@pytest.mark.slow
def test_the_encoders_maps_have_their_strides():
    taps = Lite0()(torch.rand(1, 3, 64, 96))
    sizes = [(c, 64 // s, 96 // s) for c, s in zip(CHANNELS, (4, 8, 16, 32), strict=True)]
    assert [tuple(t.shape[1:]) for t in taps] == sizes


def test_folding_a_norm_changes_nothing():
    conv = torch.nn.Conv2d(3, 32, 3, 2, 1, bias=False)
    norm = torch.nn.BatchNorm2d(32, eps=1e-3).eval()
    for value in (norm.weight, norm.bias, norm.running_mean):
        torch.nn.init.normal_(value)
    published = {f"_bn0.{k}": v for k, v in norm.state_dict().items()}
    published["_conv_stem.weight"] = conv.weight
    with pytest.raises(KeyError):
        fold(published)  # the blocks are missing
    from generator.backends.embedded.eye.lite0 import _fold

    state = _fold(published, "_conv_stem", "_bn0", "stem")
    stem = torch.nn.Conv2d(3, 32, 3, 2, 1)
    stem.load_state_dict({k.removeprefix("stem."): v for k, v in state.items()})
    x = torch.randn(2, 3, 16, 16)
    torch.testing.assert_close(stem(x), norm(conv(x)), rtol=1e-4, atol=1e-4)


@pytest.mark.slow
def test_masks_belong_to_their_cells():
    torch.manual_seed(0)
    eye = Eye(4).eval()
    maps = eye(torch.rand(2, 3, 64, 64))
    owner, cells = torch.tensor([0, 1, 1]), torch.tensor([[3, 4], [3, 4], [9, 2]])
    masks = eye.masks(maps, owner, cells, torch.full((3,), 5.0))
    assert masks.shape == (3, 2, 64 // STRIDE, 64 // STRIDE)
    assert not torch.allclose(masks[0], masks[1]) and not torch.allclose(masks[1], masks[2])


@pytest.mark.slow
def test_a_name_is_read_from_its_own_closeup():
    torch.manual_seed(0)
    eye = Eye(4).eval()
    looks, visible, told = torch.rand(3, 3, 64, 64), torch.zeros(3, 16, 16), torch.zeros(3, HINTS)
    visible[:, 4:12, 4:12] = 1
    names = eye.names(looks, visible, told)
    assert names.shape == (3, 4)
    torch.testing.assert_close(names[2:], eye.names(looks[2:], visible[2:], told[2:]))
    visible[0, 4:12, 4:12], visible[0, :3] = 0, 1
    assert not torch.allclose(eye.names(looks, visible, told)[0], names[0])


def test_a_frame_shows_what_lies_around_a_box_and_carries_masks_back():
    image = np.zeros((120, 160, 3), np.uint8)
    mask = np.zeros((120, 160), bool)
    mask[40:80, 100:110] = True
    image[mask] = 255
    for side in (32, 128):
        frame = Frame.around(np.array([100.0, 40.0]), np.array([110.0, 80.0]), side, 1.25)
        seen = frame.cut(image)[..., 0] / 255
        carried = frame.carry(mask.astype(np.float32), 1.0, 1, 1)
        np.testing.assert_allclose(seen, carried, atol=0.35)
        assert seen.mean() == pytest.approx(0.8 * 0.2, rel=0.1)
        (back,) = frame.spread(carried[None].astype(np.float32), mask.shape)
        assert (back & mask).sum() > 0.9 * (back | mask).sum()


@pytest.mark.parametrize(("elevation", "fov"), [(20, 60), (45, 40), (80, 30)])
def test_the_view_is_read_from_the_angles(elevation, fov):
    view = View(0.0, *np.deg2rad([elevation, fov]))
    camera = Camera(np.zeros(3), view_rotation(view), view.fov, 80, 60)
    y, x = np.mgrid[0:60, 0:80] + 0.5
    rays = camera.rays(np.column_stack([x.ravel(), y.ravel()]))
    noise = np.random.default_rng(0).normal(0, 0.02, (60, 80))
    found = fit_view(np.arcsin(-rays[:, 2]).reshape(60, 80) + noise)
    np.testing.assert_allclose(np.rad2deg(found), [elevation, fov], atol=2.0)


@pytest.mark.slow
def test_weights_go_to_disk_and_back(tmp_path):
    torch.manual_seed(0)
    eye = Eye(3)
    path = tmp_path / "eye.safetensors"
    notes = {"categories": '["mug", "bowl"]', "temperature": "1.5"}
    weights.save_weights(path, eye.state_dict(), notes)
    found = weights.load_weights(path)
    assert found.categories == ("mug", "bowl") and found.temperature == 1.5
    torch.testing.assert_close(found.eye.box.weight, eye.box.weight, rtol=1e-3, atol=1e-4)
    assert not (tmp_path / "eye.partial").exists()


@pytest.mark.parametrize(
    ("categories", "temperature", "why"),
    [
        ("[" * 9000, "1", "deeper"), ("[1]", "1", "a string"),
        ('{"mug": 1}', "1", "must be a list"),
        (r'["mug\u001b[2J"]', "1", "cannot be printed"), ('["mug"]', "nan", "temperature"),
        (f'["{"x" * 70_000}"]', "1", "bytes of JSON"), ('["mug"]', "-1", "temperature"),
    ],
)  # fmt: skip
def test_notes_beside_weights_are_checked(tmp_path, categories, temperature, why):
    path = tmp_path / "eye.safetensors"
    notes = {"categories": categories, "temperature": temperature}
    weights.save_weights(path, {"heat": torch.zeros(2)}, notes)
    with pytest.raises(BackendError, match=f"cannot be used .*{why}"):
        weights.load_weights(path)


def test_missing_and_damaged_weights_say_how_to_restore_them(tmp_path):
    with pytest.raises(BackendError, match=r"research\.eye\.train"):
        weights.load_weights(tmp_path / "gone.safetensors")
    damaged = tmp_path / "damaged.safetensors"
    damaged.write_bytes(b"\x10\0\0\0\0\0\0\0garbage")
    for load in (weights.load_weights, weights.load_judge):
        with pytest.raises(BackendError, match="cannot be used"):
            load(damaged)
    with pytest.raises(BackendError, match=r"research\.eye\.judging"):
        weights.load_judge(tmp_path / "gone.safetensors")
    other = tmp_path / "other.safetensors"
    weights.save_weights(other, {"heat": torch.zeros(2)}, {})
    for load in (weights.load_weights, weights.load_judge):
        with pytest.raises(BackendError, match="cannot be used"):
            load(other)
