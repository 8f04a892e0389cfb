"""Table tops cut by the frame: outlines from a region and a known camera."""

import cv2
import numpy as np
import pytest

from generator.backends.embedded.plane.cut_plane import (
    VISIBLE_LENGTH,
    frame_share,
    is_cut,
    plane_from_view,
    scaled_plane,
)
from generator.backends.embedded.plane.plane import OutlineShape, outline_distance, outline_points
from generator.errors import SceneError
from generator.geometry import Camera
from generator.scene import View

VIEW = View(np.deg2rad(20), np.deg2rad(40), np.deg2rad(45))


def region(
    size=(1.2, 0.7), shape: OutlineShape = "rectangle", aim=(0.0, 0.0), distance=1.9, view=VIEW
):
    """Return the mask of a tabletop around the origin, and the camera that sees it."""
    camera = Camera.looking_at(np.array([*aim, 0.0]), view, distance, 320, 240)
    outline = outline_points(shape, False, size, 0.0)
    pixels = camera.project(np.column_stack([outline, np.zeros(len(outline))]))
    canvas = np.zeros((240, 320), np.uint8)
    cv2.fillPoly(canvas, [np.round(pixels - 0.5).astype(np.int32)], 1)
    return canvas > 0, camera


@pytest.mark.slow
@pytest.mark.parametrize("shape", ["rectangle", "ellipse"])
def test_a_whole_top_keeps_its_shape_and_turn(shape):
    mask, _ = region(shape=shape)
    assert not is_cut(mask)
    plane = plane_from_view(mask, VIEW)
    assert plane.shape == shape
    assert max(plane.size) == pytest.approx(1.2)
    assert plane.size[1] / plane.size[0] == pytest.approx(0.7 / 1.2, abs=0.02)
    assert np.rad2deg(plane.view.azimuth) == pytest.approx(20, abs=2)
    assert plane.view.elevation == pytest.approx(VIEW.elevation, abs=1e-6)


def test_a_cut_top_is_true_where_its_edge_shows_and_holds_all_that_is_seen():
    """The far right corner is visible; the left and near sides continue outside the frame."""
    mask, camera = region(aim=(0.5, 0.3), distance=0.9)
    assert is_cut(mask) and frame_share(mask) > 0.4
    plane = scaled_plane(plane_from_view(mask, VIEW), 1.0)
    metres = camera.position[2] / plane.camera.position[2]
    plane = scaled_plane(plane, metres)
    corner = camera.project(np.array([[0.6, 0.35, 0.0]]))
    np.testing.assert_allclose(
        plane.to_table(corner)[0], [plane.size[0] / 2, plane.size[1] / 2], atol=0.02
    )
    ys, xs = np.nonzero(mask)
    seen = plane.to_table(np.column_stack([xs, ys]) + 0.5)
    off = outline_distance(seen, plane.shape, plane.flipped, plane.size, plane.radius)
    assert off.max() < 0.02


def test_a_close_up_without_any_edge_is_a_table_straight_ahead():
    plane = plane_from_view(np.ones((240, 320), bool), VIEW)
    assert plane.view.azimuth == pytest.approx(0, abs=0.02)
    assert max(plane.size) == pytest.approx(VISIBLE_LENGTH)
    assert plane.mask(0.01).mean() > 0.98


@pytest.mark.slow
def test_an_edge_beside_something_hidden_is_no_edge():
    mask, _ = region()
    hidden = np.zeros_like(mask)
    hidden[:, 210:] = True
    shown = plane_from_view(mask & ~hidden, VIEW, hidden=hidden, length=1.0)
    bare = plane_from_view(mask & ~hidden, VIEW, length=1.0)
    assert shown.view.azimuth == pytest.approx(VIEW.azimuth, abs=0.05)
    assert shown.error < bare.error


def test_specks_and_sky_are_refused():
    speck = np.zeros((240, 320), bool)
    speck[100:105, 100:105] = True
    with pytest.raises(SceneError, match="closer picture"):
        plane_from_view(speck, VIEW)
    sky = np.zeros((240, 320), bool)
    sky[:60] = True
    with pytest.raises(SceneError, match="closer picture"):
        plane_from_view(sky, View(0.0, np.deg2rad(5), np.deg2rad(45)))
