"""The camera and the homography from the outline of a table top."""

import cv2
import numpy as np
import pytest
from painted import paint

from generator.backends.embedded.plane.plane import outline_distance, outline_points
from generator.backends.embedded.plane.tabletop import find_tabletop
from generator.errors import SceneError
from generator.scene import View

THINGS = [("mug", -0.2, 0.1, 0.0), ("bowl", 0.15, 0.2, 0.0), ("apple", 0.1, -0.1, 0.0)]


@pytest.mark.slow
@pytest.mark.parametrize(
    ("outline", "material", "azimuth", "elevation"),
    [
        ("rectangle", "oak", 0, 52),
        ("rectangle", "white", 20, 40),
        ("square", "walnut", 20, 56),
        ("round", "oak", 0, 58),
        ("triangle", "oak", 0, 52),
    ],
)
def test_elevation_and_azimuth_within_three_degrees(outline, material, azimuth, elevation):
    picture = paint(outline, material, THINGS, azimuth=azimuth, elevation=elevation)
    plane = find_tabletop(picture.image)
    assert np.rad2deg(plane.view.elevation) == pytest.approx(elevation, abs=3)
    assert np.rad2deg(plane.view.azimuth) == pytest.approx(azimuth, abs=3)
    kind = {"round": "ellipse", "triangle": "triangle"}.get(outline, "rectangle")
    assert plane.shape == kind


@pytest.mark.slow
def test_points_on_the_table_are_found_again():
    picture = paint("rectangle", "oak", THINGS)
    plane = find_tabletop(picture.image, picture.plan)
    grid = np.array([[x, y] for x in (-0.5, 0.0, 0.5) for y in (-0.3, 0.0, 0.3)])
    top = np.column_stack([grid, np.full(len(grid), picture.plan.size[2])])
    assert np.abs(plane.to_table(picture.camera.project(top)) - grid).max() < 0.02
    pixels = plane.to_pixels(plane.top())
    assert np.abs(plane.to_pixels(plane.to_table(pixels)) - pixels).max() < 1e-6


@pytest.mark.slow
def test_a_white_table_on_a_shaded_white_ground_is_found():
    y, x = np.mgrid[0:480, 0:640]
    ground = 252 - 10 * (((x - 320) / 320) ** 2 + ((y - 240) / 240) ** 2)
    image = np.repeat(ground[..., None], 3, -1).astype(np.uint8)
    corners = np.array([[130, 120], [510, 120], [590, 300], [50, 300]])
    cv2.fillPoly(image, [corners], (228, 227, 226))
    front = np.array([[50, 300], [590, 300], [590, 312], [50, 312]])
    cv2.fillPoly(image, [front], (200, 180, 150))
    cv2.fillPoly(image, [np.array([[80, 312], [110, 312], [110, 460], [80, 460]])], (90, 70, 60))
    image = cv2.GaussianBlur(image, (3, 3), 0.8)
    plane = find_tabletop(image)
    outline = plane.to_pixels(plane.top())
    near = [np.linalg.norm(outline - c, axis=1).min() for c in corners]
    assert plane.shape == "rectangle" and max(near) < 8


@pytest.mark.slow
def test_a_given_view_is_kept_and_the_rest_is_fitted_to_it():
    picture = paint("rectangle", "oak", THINGS)
    free = find_tabletop(picture.image)
    view = View(free.view.azimuth, free.view.elevation - 0.05, free.view.fov)
    kept = find_tabletop(picture.image, view=view)
    np.testing.assert_allclose(
        [kept.view.azimuth, kept.view.elevation, kept.view.fov],
        [view.azimuth, view.elevation, view.fov], atol=1e-5,
    )  # fmt: skip
    assert kept.error < 1.0
    assert kept.size[1] > 1.03 * free.size[1]  # seen lower, the same outline is a deeper table


def test_a_picture_without_a_table_is_refused():
    with pytest.raises(SceneError, match="No table found"):
        find_tabletop(np.full((200, 300, 3), 250, np.uint8))


@pytest.mark.parametrize("shape", ["rectangle", "ellipse", "triangle"])
@pytest.mark.parametrize("flipped", [False, True])
def test_outlines_fill_their_size_exactly(shape, flipped):
    points = outline_points(shape, flipped, (1.2, 0.8), 0.1, count=720)
    np.testing.assert_allclose(np.ptp(points, axis=0), [1.2, 0.8], atol=2e-3)
    off = outline_distance(points, shape, flipped, (1.2, 0.8), 0.1)
    assert np.abs(off).max() < 1e-6


@pytest.mark.slow
def test_same_picture_same_plane():
    picture = paint("round", "walnut", THINGS)
    first, second = find_tabletop(picture.image), find_tabletop(picture.image)
    outlines = [plane.to_pixels(plane.top()) for plane in (first, second)]
    np.testing.assert_array_equal(*outlines)
