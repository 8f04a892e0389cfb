"""Exports checked by other programs, and pictures of their results."""

import dataclasses
from pathlib import Path

import cv2
import numpy as np
import pytest
from imported import READERS
from oracle import CONVERT, LOAD_URDF, ask, check_sdf
from pictured import DRAWERS
from toy import toy_object, toy_scene

import assets_cache
from generator.bundle import load
from generator.exports import WRITERS, export
from generator.exports.bodies import bodies_of
from generator.geometry import framing_camera, quaternion_matrix
from generator.render.raster import render
from generator.render.sheet import scene_items
from generator.scene import Scene

pytestmark = pytest.mark.slow

ODD = ("con", "..", "x" * 200, "1 <&> \"'", "mug.1", "mug_1", "MUG-1", "日本", "-", "Käse 2")
"""What some format does not allow as it is, or what would collide."""


@pytest.fixture(scope="module")
def scene() -> Scene:
    (path,) = assets_cache.find("office-desk")
    return load(path)


@pytest.fixture(scope="module")
def crowd() -> Scene:
    """Sixty cubes, the first ones with names that no format allows."""
    things = []
    for k in range(60):
        at = (0.1 * (k % 10 - 5), 0.1 * (k // 10) - 0.25)
        cube = toy_object(f"cube_{k}", (0.03, 0.03, 0.03), at, color=(4 * k, 90, 240 - 4 * k))
        if k < len(ODD):
            placement = dataclasses.replace(cube.placement, name=ODD[k])
            cube = dataclasses.replace(cube, name=ODD[k], placement=placement)
        things.append(cube)
    return toy_scene(tuple(things), name="a scene & <more>")


def test_the_usd_converter_finds_the_same_bodies(scene: Scene, tmp_path: Path) -> None:
    source = export(scene, "mjcf", tmp_path) / "scene.xml"
    theirs = ask(CONVERT, source, tmp_path / "usd", needs="mujoco_usd_converter")
    pytest.importorskip("pxr")
    ours = READERS["usd"](export(scene, "usd", tmp_path))
    assert {*theirs} == {*ours}
    for name, body in ours.items():
        read = theirs[name]
        assert read["parts"] == len(body.parts), name
        assert {*read["hulls"]} <= {"convexHull"}
        np.testing.assert_allclose(read["position"], body.position, atol=1e-5, err_msg=name)
        turn = np.array(read["rotation"]).T
        np.testing.assert_allclose(turn, quaternion_matrix(body.quaternion), atol=1e-5)
        if body.mass:
            assert read["mass"] == pytest.approx(body.mass, rel=1e-5)


def test_yourdfpy_finds_the_same_links(scene: Scene, tmp_path: Path) -> None:
    folder = export(scene, "urdf", tmp_path)
    found = ask(LOAD_URDF, folder / "scene.urdf", needs="yourdfpy")
    low, high = np.array(found.pop("bounds"))
    bodies = {body.name: body for body in bodies_of(scene)}
    assert {*found} == {*bodies, "world"}
    for name, body in bodies.items():
        read, turn = found[name], quaternion_matrix(body.quaternion)
        assert read["mass"] == pytest.approx(body.mass, rel=1e-5)
        assert read["parts"] == len(body.pieces)
        np.testing.assert_allclose(np.array(read["matrix"])[:3, :3], turn, atol=1e-5)
        np.testing.assert_allclose(np.array(read["matrix"])[:3, 3], body.position, atol=1e-5)
    placed = [b.vertices @ quaternion_matrix(b.quaternion).T + b.position for b in bodies.values()]
    points = np.concatenate(placed)
    np.testing.assert_allclose([low, high], [points.min(0), points.max(0)], atol=1e-4)


@pytest.mark.parametrize("which", ["scene", "crowd"])
def test_libsdformat_says_valid(which: str, tmp_path: Path, request) -> None:
    folder = export(request.getfixturevalue(which), "sdf", tmp_path, "checked")
    assert check_sdf(folder / "scene.sdf") == "Valid."


def off(one: np.ndarray, other: np.ndarray) -> float:
    """Return the mean difference of two pictures, grey levels."""
    return float(np.abs(one.astype(int) - other.astype(int)).mean())


@pytest.mark.parametrize("to", DRAWERS)
def test_what_is_read_again_looks_the_same(to: str, scene: Scene, tmp_path: Path) -> None:
    """Silhouettes agree, and colours where the reader has textures; nothing is blank."""
    if to == "usd":
        pytest.importorskip("pxr")
    ours = scene_items(scene)
    points = np.concatenate([item.vertices for item in ours])
    camera = framing_camera(points, scene.view, 320, 240)
    theirs = [*DRAWERS[to](export(scene, to, tmp_path))]
    assert len(theirs) == len(ours)
    drawn, wanted = render(theirs, camera), render(ours, camera)
    shown, expected = drawn.ids >= 0, wanted.ids >= 0
    assert (shown & expected).sum() / (shown | expected).sum() > 0.995
    np.testing.assert_allclose(drawn.depth[shown & expected], wanted.depth[shown & expected],
                               atol=2e-3)  # fmt: skip
    if to != "urdf":
        assert off(drawn.image, wanted.image) < 1.0, "textures and their places"
    else:  # MuJoCo reads no textures; without colours, white things stood on a white table
        assert off(cv2.blur(drawn.image, (9, 9)), cv2.blur(wanted.image, (9, 9))) < 25


@pytest.mark.parametrize("to", WRITERS)
def test_sixty_objects_of_any_name_are_exported(to: str, crowd: Scene, tmp_path: Path) -> None:
    if to.startswith("usd"):
        pytest.importorskip("pxr")
    found = READERS[to](export(crowd, to, tmp_path, "crowd"))
    bodies = bodies_of(crowd)
    assert len(bodies) == len({body.name for body in bodies}) == 61
    if to == "mjcf":  # which keeps names
        assert {*found} == {"table", *(thing.name for thing in crowd.objects)}
        return
    assert {*found} == {body.name for body in bodies}
    for body in bodies:
        np.testing.assert_allclose(found[body.name].position, body.position, atol=1e-4)
