import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from generator import geometry as g
from generator.errors import InputError
from generator.scene import ConvexPart, Mesh, View
from tabletop_objects.values import parts_to_unit_box, to_unit_box

ANGLE = st.floats(-10, 10)
VIEW = st.builds(
    View, azimuth=st.floats(-3, 3), elevation=st.floats(0.2, 1.5), fov=st.floats(0.3, 1.2)
)


@given(ANGLE, ANGLE)
def test_rotation_z_adds(a: float, b: float) -> None:
    assert np.allclose(g.rotation_z(a) @ g.rotation_z(b), g.rotation_z(a + b))


@given(ANGLE)
def test_yaw_quaternion_agrees_with_matrix(yaw: float) -> None:
    q = g.yaw_quaternion(yaw)
    assert np.allclose(g.quaternion_matrix(q), g.rotation_z(yaw))
    assert abs(g.wrap(g.quaternion_yaw(q) - yaw)) < 1e-9


@given(VIEW)
def test_view_rotation_is_a_rotation_with_a_level_horizon(view: View) -> None:
    r = g.view_rotation(view)
    assert np.allclose(r @ r.T, np.eye(3))
    assert np.linalg.det(r) == pytest.approx(1)
    assert r[0, 2] == pytest.approx(0)


@given(VIEW)
def test_projection_and_plane_are_inverse(view: View) -> None:
    camera = g.Camera.looking_at([0.1, -0.2, 0.7], view, 2.0, 640, 480)
    points = np.array([[0.1, -0.2, 0.7], [0.2, -0.1, 0.7], [-0.1, -0.3, 0.7]])
    pixels = camera.project(points)
    assert np.allclose(pixels[0], [320, 240])
    assert np.allclose(camera.on_plane(pixels, 0.7), points)


def test_frames_as_seen_in_the_picture() -> None:
    camera = g.Camera.looking_at([0, 0, 0], View(0.0, 0.9, 0.6), 2.0, 640, 480)
    right, away, up = camera.project(np.eye(3) * 0.1)
    assert right[0] > 320
    assert away[1] < 240
    assert up[1] < 240


def test_positive_azimuth_moves_the_camera_to_plus_x() -> None:
    assert g.view_direction(View(0.5, 0.5, 0.5))[0] > 0


def test_ray_view_at_the_centre_is_the_view() -> None:
    view = View(0.4, 0.8, 0.7)
    ray = g.ray_view(view, np.array([320, 240]), 640, 480)
    assert (ray.azimuth, ray.elevation) == pytest.approx((0.4, 0.8))


def test_ray_view_matches_the_direction_to_the_camera() -> None:
    view = View(0.2, 0.8, 0.7)
    camera = g.Camera.looking_at([0, 0, 0], view, 2.0, 640, 480)
    point = np.array([0.3, -0.2, 0.0])
    seen = g.ray_view(view, camera.project(point[None])[0], 640, 480)
    back = (camera.position - point) / np.linalg.norm(camera.position - point)
    assert np.allclose(g.view_direction(seen), back)


def test_rays_above_the_horizon_give_nan() -> None:
    camera = g.Camera.looking_at([0, 0, 0], View(0.0, 0.1, 1.0), 2.0, 640, 480)
    assert np.isnan(camera.on_plane(np.array([[320, 1.0]]), 0.0)).all()


@given(ANGLE)
def test_rotated_extent_bounds_the_turned_corners(yaw: float) -> None:
    extent = np.array([0.3, 0.1, 0.2])
    corners = np.array([[x, y, 0] for x in (-0.15, 0.15) for y in (-0.05, 0.05)])
    turned = corners @ g.rotation_z(yaw).T
    assert np.allclose(np.ptp(turned, axis=0)[:2], g.rotated_extent(extent, yaw))


def test_to_unit_box_is_undone_by_centre_and_extent() -> None:
    vertices = np.array([[1, 2, 3], [2, 2, 3], [1, 4, 3], [1, 2, 7]], float)
    mesh = Mesh(vertices, [[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], np.zeros((4, 2)),
                np.zeros((1, 1, 3)))  # fmt: skip
    unit, center, extent = to_unit_box(mesh)
    assert np.allclose(unit.vertices * extent + center, vertices, atol=1e-6)
    (part,) = parts_to_unit_box((ConvexPart(vertices, "box"),), center, extent)
    assert np.allclose(part.bounds, [[-0.5] * 3, [0.5] * 3])


def test_masks_and_boxes() -> None:
    mask = np.zeros((10, 20), bool)
    mask[2:5, 3:9] = True
    box = g.mask_box(mask)
    assert box.tolist() == [3, 2, 9, 5]
    with pytest.raises(InputError, match="empty mask"):
        g.mask_box(np.zeros((3, 3), bool))


def test_convex_outline_and_margin() -> None:
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1], [0.5, 0.5], [0.5, 0]])
    outline = g.convex_outline(square)
    assert len(outline) == 4
    margins = g.inside_margin(np.array([[0.5, 0.5], [0.9, 0.5], [1.2, 0.5]]), outline)
    assert np.allclose(margins, [0.5, 0.1, -0.2])
    with pytest.raises(InputError):
        g.convex_outline(np.array([[0, 0], [1, 1]]))


def test_inner_points_change_no_outline() -> None:
    rng = np.random.default_rng(0)
    points = rng.normal(size=(400, 2))
    outline = g.convex_outline(points)
    assert (g.inside_margin(points, outline) > -1e-8).all()
    np.testing.assert_array_equal(g.convex_outline(outline), outline)
    square = np.array(np.meshgrid(np.arange(9.0), np.arange(9.0))).reshape(2, -1).T
    assert g.convex_outline(square).tolist() == [[0, 0], [8, 0], [8, 8], [0, 8]]
    assert len(g.convex_outline(np.column_stack([np.arange(50.0), np.zeros(50)]))) == 2
