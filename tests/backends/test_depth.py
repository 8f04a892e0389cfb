"""Plane, sizes, positions and stacking from rendered depth maps with ground truth."""

from dataclasses import replace

import numpy as np
import pytest
from painted import SIZES
from shots import FRAME, THINGS, scene_of, shoot

from generator.backends.embedded.depth.measure import measure_solid, table_points
from generator.backends.embedded.depth.plane import find_depth_plane
from generator.backends.embedded.imager import EmbeddedImager
from generator.backends.embedded.reasoner import EmbeddedReasoner
from generator.errors import SceneError
from generator.geometry import Camera, view_rotation
from generator.scene import TABLE, Intrinsics, Rotation
from tabletop_objects import build


@pytest.mark.slow
@pytest.mark.parametrize(
    ("outline", "azimuth", "elevation"),
    [("rectangle", 20, 40), ("square", -30, 25), ("round", 0, 55), ("triangle", 10, 60)],
)
def test_the_tabletop_is_found_in_metres(outline, azimuth, elevation):
    shot = shoot(outline, azimuth=azimuth, elevation=elevation)
    plane = find_depth_plane(shot.depth, shot.intrinsics)
    truth = shot.picture.camera
    length, width, height = SIZES[outline]
    assert plane.size == pytest.approx((length, width), abs=0.04)
    assert plane.camera.position[2] == pytest.approx(truth.position[2] - height, abs=0.005)
    assert np.rad2deg(plane.view.elevation) == pytest.approx(elevation, abs=0.5)
    assert plane.view.fov == pytest.approx(truth.fov, abs=1e-4)
    kind = {"round": "ellipse", "triangle": "triangle"}.get(outline, "rectangle")
    assert plane.shape == kind
    if kind != "ellipse":
        assert np.rad2deg(plane.view.azimuth) == pytest.approx(azimuth, abs=1.5)
    np.testing.assert_allclose(plane.camera.rotation, view_rotation(plane.view), atol=1e-6)


@pytest.mark.slow
def test_places_and_sizes_are_those_of_the_things():
    shot = shoot()
    plane = find_depth_plane(shot.depth, shot.intrinsics)
    for number, (key, x, y, _) in enumerate(THINGS, start=1):
        solid = measure_solid(shot.picture.ids == number, shot.depth, plane)
        assert solid is not None
        size = build(key, 1).size
        np.testing.assert_allclose(solid.center, [x, y], atol=0.015)
        assert solid.top == pytest.approx(size[2], abs=0.012)
        assert solid.extent[0] == pytest.approx(max(size[:2]), abs=0.025)


@pytest.mark.slow
def test_hardly_anything_known_measures_nothing():
    shot = shoot()
    plane = find_depth_plane(shot.depth, shot.intrinsics)
    mug = shot.picture.ids == 2
    assert measure_solid(mug, np.where(mug, 0, shot.depth), plane) is None


@pytest.mark.slow
def test_a_picture_cut_off_centre_keeps_its_metres():
    """Cropping moves the principal point, and nothing in the world."""
    shot = shoot(azimuth=15)
    whole = find_depth_plane(shot.depth, shot.intrinsics)
    i = shot.intrinsics
    part = find_depth_plane(shot.depth[:, 30:], replace(i, cx=i.cx - 30))
    assert part.camera.offset[0] == pytest.approx(whole.camera.offset[0] - 15)
    points = np.array([[0.2, 0.1], [-0.3, 0.0], [0.0, 0.0]])
    moved = whole.to_pixels(points) - [30, 0]
    apart = np.linalg.norm(np.diff(part.to_table(moved), axis=0), axis=1)
    np.testing.assert_allclose(apart, np.linalg.norm(np.diff(points, axis=0), axis=1), atol=3e-3)


@pytest.mark.slow
def test_a_rolled_camera_sees_the_same_table():
    """A rotation of the depth map by a quarter is too much; a few degrees follow from the plane."""
    shot = shoot(noise=0.0)
    plane = find_depth_plane(shot.depth, shot.intrinsics)
    camera = shot.picture.camera
    roll = np.deg2rad(12)
    turned = view_rotation(replace(plane.view, roll=roll))
    tilted = Camera(camera.position, turned, camera.fov, camera.width, camera.height)
    y, x = np.mgrid[0:240, 0:320] + 0.5
    pixels = np.column_stack([x.ravel(), y.ravel()])
    back = camera.project(camera.position + tilted.rays(pixels)).round(6)
    inside = (back >= 0).all(1) & (back < FRAME).all(1)
    at = back[inside].astype(int)
    seen = np.zeros(len(pixels), np.float32)
    seen[inside] = shot.depth[at[:, 1], at[:, 0]]  # roll keeps the depth along the optical axis
    found = find_depth_plane(seen.reshape(240, 320), shot.intrinsics)
    assert found.view.roll == pytest.approx(roll, abs=np.deg2rad(0.5))
    assert found.size == pytest.approx(plane.size, abs=0.03)


@pytest.mark.slow
def test_the_table_mask_decides_between_planes():
    """A big box on the floor is not a table, unless the mask marks it."""
    shot = shoot()
    floor = ~np.isfinite(shot.picture.depth)
    plane = find_depth_plane(shot.depth, shot.intrinsics, floor)
    assert plane.camera.position[2] == pytest.approx(shot.picture.camera.position[2], abs=0.02)


def test_without_a_level_plane_there_is_no_table():
    depth = 2.0 + 0.8 * np.mgrid[-1:1:240j, -1:1:320j][0]  # a wall that leans over the viewer
    with pytest.raises(SceneError, match="No table plane"):
        find_depth_plane(depth.astype(np.float32), Intrinsics(300, 300, 160, 120))


# ------------------------------------------------------------------------- through the backend
@pytest.mark.slow
def test_the_reasoner_measures_what_it_does_not_know():
    shot = shoot()
    reference, instances = scene_of(shot, ("thing_1", "thing_2", "thing_3"))
    reasoner = EmbeddedReasoner()
    view = reasoner.estimate_view(reference, instances[0])
    sizes = reasoner.estimate_sizes(reference, instances, view)
    assert np.rad2deg(view.elevation) == pytest.approx(52, abs=0.5)
    np.testing.assert_allclose(sizes[TABLE].extent[:2], [1.2, 0.7], atol=0.04)
    bowl = build("bowl", 1).size
    np.testing.assert_allclose(sizes["thing_1"].extent, bowl, atol=0.02)


@pytest.mark.slow
def test_what_lies_in_a_bowl_and_on_a_box_is_found_there():
    box = build("book", 1).size
    things = [("bowl", 0.25, 0.1, 0.0), ("book", -0.2, 0.0, 0.0), ("apple", -0.2, 0.0, box[2])]
    shot = shoot(things=things)
    reference, instances = scene_of(shot, ("bowl", "book", "apple"))
    order = EmbeddedReasoner().stacking_order(reference, instances, None)  # type: ignore[arg-type]
    assert order["apple"].on == "book" and order["apple"].order == 3
    assert not order["apple"].inside
    assert order["bowl"].on == order["book"].on == TABLE


@pytest.mark.slow
def test_the_top_view_keeps_measured_places_and_scale():
    shot = shoot()
    names = ("bowl", "mug", "apple")
    reference, instances = scene_of(shot, names)
    view = EmbeddedReasoner().estimate_view(reference, instances[0])
    models = {name: replace(build(name, 1), name=name) for name in names}
    rotations = {name: Rotation(name, 0.4, 0.0) for name in names}
    top = EmbeddedImager().top_view(reference, instances, models, rotations, view)
    assert top.metres_per_pixel is not None
    table = np.asarray(top.table_box)
    assert (table[2] - table[0]) * top.metres_per_pixel == pytest.approx(1.2, abs=0.02)
    middle = (table[:2] + table[2:]) / 2
    for name, x, y, _ in THINGS:
        box = np.asarray(top.boxes[name])
        off = ((box[:2] + box[2:]) / 2 - middle) * [1, -1] * top.metres_per_pixel
        reach = 0.03 if name == "mug" else 0.015  # the box's middle counts the handle
        np.testing.assert_allclose(off, [x, y], atol=reach)


@pytest.mark.slow
def test_points_of_the_tabletop_lie_on_it():
    shot = shoot(noise=0.0)
    plane = find_depth_plane(shot.depth, shot.intrinsics)
    heights = table_points(shot.depth, plane.camera)[..., 2]
    top = plane.mask(-0.03) & (shot.picture.ids == 0)
    assert np.abs(heights[top]).max() < 0.003
