"""Doubts about a scene generated from a picture, and their exit code."""

import dataclasses
from pathlib import Path

import numpy as np
import pytest
from toy import toy_scene

from generator import cli, pipeline
from generator.comparison.doubts import PictureMatch, match_picture, warn_of_eye_level
from generator.generation import Config
from generator.geometry import Camera, mask_box
from generator.method.rotation import RotationConfig
from generator.render.sheet import render_scene
from generator.scene import TABLE, Instance, Reference, Scene, View

VIEW = View(azimuth=0.2, elevation=0.8, fov=0.6)


@pytest.fixture(scope="module")
def scene() -> Scene:
    return toy_scene().replace(view=VIEW)


@pytest.fixture(scope="module")
def found(scene: Scene) -> tuple[tuple[Instance, ...], Reference]:
    camera = Camera.looking_at(np.array([0.15, -0.05, 0.7]), VIEW, 1.7, 320, 240)
    shot = render_scene(scene, camera=camera, supersample=1)
    ids, crop = np.asarray(shot.ids), np.full((4, 4, 4), 255, np.uint8)
    instances = []
    for number, name in enumerate((TABLE, *(thing.name for thing in scene.objects))):
        mask = ids == number
        instances.append(Instance(name, name, mask_box(mask), mask, crop, mask_box(mask)))
    return tuple(instances), Reference(np.asarray(shot.image))


def moved(scene: Scene, far: float) -> Scene:
    objects = []
    for k, thing in enumerate(scene.objects):
        step = np.array([far * (-1) ** k, far, 0.0])
        pose = dataclasses.replace(thing.pose, position=thing.pose.position + step)
        objects.append(dataclasses.replace(thing, pose=pose))
    return scene.replace(objects=tuple(objects))


def test_a_scene_that_shows_its_picture_is_not_doubted(
    scene: Scene, found: tuple[tuple[Instance, ...], Reference]
) -> None:
    match = match_picture(scene, *found)
    assert not match.doubts and not match.notes
    assert match.mean_iou is not None and match.mean_iou > 0.9


def test_things_that_are_elsewhere_are_told(
    scene: Scene, found: tuple[tuple[Instance, ...], Reference]
) -> None:
    match = match_picture(moved(scene, 0.25), *found)
    doubts = " ".join(match.doubts)
    assert "The simulated objects overlap" in doubts
    assert "not where the picture shows them: " in doubts
    assert len(match.notes) == len(scene.objects)


def test_one_thing_that_is_elsewhere_is_named(
    scene: Scene, found: tuple[tuple[Instance, ...], Reference]
) -> None:
    far = moved(scene, 0.25).objects[-1]
    match = match_picture(scene.replace(objects=(*scene.objects[:-1], far)), *found)
    (note,) = match.notes
    assert note.startswith(f"{far.name} differs from the picture")


def test_eye_level_is_warned_of(scene: Scene) -> None:
    low = scene.replace(view=dataclasses.replace(VIEW, elevation=np.deg2rad(7.0)))
    assert "eye level (7°)" in " ".join(warn_of_eye_level(low))
    assert warn_of_eye_level(scene) == ()


@pytest.mark.slow
def test_the_command_ends_with_6_where_the_view_shows_something_else(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    blank = PictureMatch(0.0, ("The simulated view is blank.",))
    monkeypatch.setattr(pipeline, "match_picture", lambda *_: blank)
    quick = Config(rotation=RotationConfig.quick())  # which the comparison does not see
    monkeypatch.setattr("generator.generation.Config", lambda **_: quick)
    picture = Path(__file__).parents[2] / "examples/pictures/coffee_table.png"
    assert cli.run(["generate", str(picture), "--out", str(tmp_path)]) == 6
    shown = capsys.readouterr()
    assert "does not match the picture: The simulated view is blank." in shown.err
    assert "note: The simulated view is blank." in shown.out
    assert len(list(tmp_path.iterdir())) == 1  # the bundle is there all the same
