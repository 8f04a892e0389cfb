"""Comparison of a scene with its picture: known camera and silhouettes, figures and sheet."""

import dataclasses

import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.bundle import Segments
from generator.comparison import compare, comparison_sheet, picture_camera
from generator.errors import InputError
from generator.geometry import Camera
from generator.render.raster import Rendered
from generator.render.sheet import render_scene
from generator.scene import TABLE, Scene, View

VIEW = View(azimuth=0.2, elevation=0.8, fov=0.6)


@pytest.fixture(scope="module")
def scene() -> Scene:
    return toy_scene().replace(view=VIEW)


@pytest.fixture(scope="module")
def camera() -> Camera:
    """Off-centre, and close enough that the frame cuts the table."""
    return Camera.looking_at(np.array([0.15, -0.05, 0.7]), VIEW, 1.7, 320, 240)


@pytest.fixture(scope="module")
def shot(scene: Scene, camera: Camera) -> Rendered:
    return render_scene(scene, camera=camera, supersample=1)


@pytest.fixture(scope="module")
def segments(scene: Scene, shot: Rendered) -> Segments:
    names = (TABLE, *(thing.name for thing in scene.objects))
    return Segments(names, names, (np.asarray(shot.ids) + 1).astype(np.uint8))


def test_the_cameras_place_is_found_again(scene: Scene, camera: Camera, segments: Segments) -> None:
    found = picture_camera(scene, segments)
    assert np.linalg.norm(found.position - camera.position) < 0.02
    assert np.allclose(found.rotation, camera.rotation)
    assert (found.width, found.height, found.fov) == (320, 240, VIEW.fov)


def test_a_camera_so_near_that_little_shows_is_not_lost(scene: Scene) -> None:
    view = View(azimuth=0.08, elevation=0.39, fov=0.55)
    near = Camera.looking_at(np.array([0.1, -0.1, 0.7]), view, 0.35, 240, 320)
    close = scene.replace(view=view)
    shot = render_scene(close, camera=near, supersample=1)
    names = (TABLE, *(thing.name for thing in scene.objects))
    segments = Segments(names, names, (np.asarray(shot.ids) + 1).astype(np.uint8))
    assert np.linalg.norm(picture_camera(close, segments).position - near.position) < 0.05


def test_one_wrong_object_moves_the_camera_little(
    scene: Scene, camera: Camera, segments: Segments
) -> None:
    (first, *rest) = scene.objects
    pose = dataclasses.replace(first.pose, position=first.pose.position + np.array([0.3, 0.1, 0]))
    moved = scene.replace(objects=(dataclasses.replace(first, pose=pose), *rest))
    found = picture_camera(moved, segments)
    assert np.linalg.norm(found.position - camera.position) < 0.03


def test_a_scene_agrees_with_its_own_picture(
    scene: Scene, shot: Rendered, segments: Segments
) -> None:
    compared = compare(scene, segments, np.asarray(shot.image))
    assert compared.mean_iou > 0.9
    assert compared.table.iou > 0.95
    assert compared.mean_color_difference is not None
    assert compared.mean_color_difference < 2
    assert [score.name for score in compared.scores] == [o.name for o in scene.objects]


def test_figures_tell_what_is_moved_missing_and_recoloured(
    scene: Scene, shot: Rendered, segments: Segments
) -> None:
    cube, can, *rest = scene.objects
    far = dataclasses.replace(cube.pose, position=cube.pose.position + np.array([0, 0.25, 0]))
    purple = toy_object("box_1", (0.2, 0.14, 0.1), (0.4, 0.15), mass=2.5, color=(160, 20, 200))
    extra = toy_object("extra_1", (0.05, 0.05, 0.05), (-0.05, -0.15))
    changed = scene.replace(
        objects=(dataclasses.replace(cube, pose=far), *rest[:-1], purple, extra)
    )
    scores = {s.name: s for s in compare(changed, segments, np.asarray(shot.image)).scores}
    assert scores["cube_1"].iou == 0
    assert not scores[can.name].built
    assert scores[can.name].color_difference is None
    assert scores["box_1"].iou > 0.9
    assert (scores["box_1"].color_difference or 0) > 30
    assert not scores["extra_1"].found
    assert scores["extra_1"].iou == 0


@pytest.mark.slow
def test_the_picture_may_have_another_resolution_but_not_other_proportions(
    scene: Scene, shot: Rendered, segments: Segments
) -> None:
    image = np.asarray(shot.image)
    doubled = image.repeat(2, 0).repeat(2, 1)
    assert compare(scene, segments, doubled).facts() == compare(scene, segments, image).facts()
    with pytest.raises(InputError, match="320x240"):
        compare(scene, segments, image[:200])


def test_nothing_in_common_is_an_input_error(scene: Scene) -> None:
    segments = Segments(("ghost_1",), ("ghost",), np.ones((24, 32), np.uint8))
    with pytest.raises(InputError, match="cannot be compared"):
        picture_camera(scene, segments)


@pytest.mark.slow
def test_the_sheet_shows_the_picture_and_every_objects_colour(
    scene: Scene, shot: Rendered, segments: Segments
) -> None:
    compared = compare(scene, segments, np.asarray(shot.image))
    sheet = comparison_sheet(compared)
    other = comparison_sheet(dataclasses.replace(compared, picture=np.zeros_like(shot.image)))
    assert sheet.ndim == 3
    third = sheet.shape[1] // 3
    changed = (sheet != other).any(-1)
    assert changed[:, : 2 * third].any()
    assert not changed[:, 2 * third + 20 :].any()  # render and figures do not show the picture
    assert np.array_equal(sheet, comparison_sheet(compared))
