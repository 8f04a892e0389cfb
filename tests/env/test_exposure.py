"""Exposure and framing of pictures: no overexposure, the whole robot, tables on their floor.

With MUJOCO_GL=osmesa (or egl) in the environment these tests look at that kind of OpenGL.
"""

import functools

import numpy as np
import pytest
from jaxtyping import Bool, Float, UInt8
from scipy.ndimage import binary_dilation, binary_erosion, median_filter
from test_rendering import needs_gl
from toy import toy_scene

import assets_cache
from generator.bundle import load
from generator.geometry import rotation_z
from generator.physics.mjcf import FLOOR
from generator.scene import TABLE, Scene
from tabletopgen_env.randomization import PRESETS
from tabletopgen_env.randomization.looks import apply_lights, draw_lights
from tabletopgen_env.rendering.drawer import drawer
from tabletopgen_env.rendering.kinds import Profile
from tabletopgen_env.rendering.software import visible_shapes
from tabletopgen_env.rendering.views import model_camera
from tabletopgen_env.robot.mount import Mount
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.robot.shells import arm_points
from tabletopgen_env.world.composition import FRONT_CAMERA, TOP_CAMERA, WRIST_CAMERA, front_camera
from tabletopgen_env.world.room import AMBIENT, BRIGHTEST, HEADLIGHT, SUN, exposure
from tabletopgen_env.world.world import World

pytestmark = pytest.mark.slow

BUNDLES = {folder.name.rsplit("-", 1)[0]: folder for folder in assets_cache.entries()}
SHOWN = ("lab", "coffee-square", "workbench", "vanity")  # white, dark, wood, white and round
RENDERERS = [pytest.param("gl", marks=needs_gl), "software"]
CAMERAS = (FRONT_CAMERA, WRIST_CAMERA, TOP_CAMERA)


@functools.cache
def scene_of(name: str) -> Scene:
    return load(BUNDLES[name])


@functools.cache
def world_of(name: str) -> World:
    world = World(scene_of(name), Panda())
    world.reset()
    return world


def luminance(picture: UInt8[np.ndarray, "h w 3"]) -> Float[np.ndarray, "h w"]:
    return picture @ np.array([0.2126, 0.7152, 0.0722])


def check_exposure(picture: UInt8[np.ndarray, "h w 3"], mean: tuple[float, float]) -> None:
    assert (picture.min(2) > 250).mean() < 0.002, "blown out"
    assert (picture.max(2) < 5).mean() < 0.01, "black"
    low, high = mean
    assert low < luminance(picture).mean() < high


def specks(
    picture: UInt8[np.ndarray, "h w 3"], where: Bool[np.ndarray, "h w"]
) -> Bool[np.ndarray, "h w"]:
    """Return which pixels well inside ``where`` are darker than those around them."""
    bright = luminance(picture)
    return (median_filter(bright, 3) - bright > 10) & binary_erosion(where, iterations=3)


@pytest.mark.parametrize("name", BUNDLES)
def test_the_front_camera_shows_the_whole_robot_and_the_whole_top(name) -> None:
    scene = scene_of(name)
    mount = Mount.beside(scene)
    arm = arm_points() @ rotation_z(mount.yaw).T + mount.position
    outline = np.asarray(scene.table.outline)
    top = np.column_stack([outline, np.full(len(outline), scene.table.height)])
    for width, height in ((640, 480), (128, 128), (64, 64)):
        camera = front_camera(scene, mount, width, height)
        for points in (arm, top):
            seen = camera.project(points) / [width, height]
            assert (seen > 0.02).all() and (seen < 0.98).all()
        assert np.ptp(camera.project(np.vstack([arm, top]))[:, 1]) > 0.6 * height


@pytest.mark.parametrize("name", SHOWN[:2])
def test_what_the_model_draws_of_the_robot_is_where_the_front_camera_looks(name) -> None:
    world = world_of(name)
    camera = model_camera(world, FRONT_CAMERA, 480, 640)
    data, owner = world.data, world.model.geom_bodyid
    drawn = [s for s in visible_shapes(world.model) if owner[s.geom] in world.robot_bodies]
    assert len(drawn) > 20
    for shape in drawn:
        turn = data.geom_xmat[shape.geom].reshape(3, 3)
        seen = camera.project(shape.vertices @ turn.T + data.geom_xpos[shape.geom])
        assert (seen > 10).all() and (seen < [630, 470]).all()


@pytest.mark.parametrize("renderer", RENDERERS)
@pytest.mark.parametrize("name", SHOWN)
def test_what_render_returns_is_exposed_and_has_no_specks(name, renderer) -> None:
    world = world_of(name).twin()
    size = (480, 640) if renderer == "gl" else (240, 320)
    eyes = drawer(renderer, *size, "full")
    drawn = eyes.draw(world, FRONT_CAMERA, ("rgb", "segmentation"))
    eyes.close()
    picture, geoms = drawn["rgb"], drawn["segmentation"]
    check_exposure(picture, (100, 190))
    assert not specks(picture, geoms < 0).any()
    floor = geoms == world.model.geom(FLOOR).id
    assert 0.1 < floor.mean() < 0.9 and specks(picture, floor).sum() < 2e-3 * floor.sum()


@pytest.mark.parametrize("renderer", RENDERERS)
@pytest.mark.parametrize("name", SHOWN)
def test_small_pictures_are_exposed_and_tables_stand_out_from_the_floor(name, renderer) -> None:
    world = world_of(name)
    for size in (64, 128):
        eyes = drawer(renderer, size, size)
        for camera in CAMERAS:
            check_exposure(eyes.rgb(world, camera), (60, 215))
        drawn = eyes.draw(world, FRONT_CAMERA, ("rgb", "segmentation"))
        eyes.close()
        model, geoms = world.model, drawn["segmentation"]
        table = np.isin(geoms, np.flatnonzero(model.geom_bodyid == model.body(TABLE).id))
        beside = binary_dilation(table, iterations=size // 12) & (geoms == model.geom(FLOOR).id)
        bright = luminance(drawn["rgb"])
        assert abs(bright[table].mean() - bright[beside].mean()) > 18
        colors = drawn["rgb"][table].mean(0) - drawn["rgb"][beside].mean(0)
        assert np.abs(colors).max() > 40 and 80 < bright[beside].mean() < 140


@needs_gl
@pytest.mark.parametrize("profile", ["fast", "full"])
def test_both_renderers_show_the_same_floor_and_haze(profile: Profile) -> None:
    world = world_of("workbench").twin()
    for camera in CAMERAS:
        gl, soft = (
            drawer(renderer, 120, 160, profile).draw(world, camera, ("rgb", "segmentation"))
            for renderer in ("gl", "software")
        )
        assert (gl["segmentation"] == soft["segmentation"]).mean() > 0.97
        behind = gl["segmentation"] <= world.model.geom(FLOOR).id
        apart = np.abs(luminance(gl["rgb"]) - luminance(soft["rgb"]))
        assert apart[behind].mean() < 8 and apart.mean() < 14


@pytest.mark.parametrize("renderer", RENDERERS)
@pytest.mark.parametrize("preset", ["light", "strong"])
def test_randomized_lights_blow_nothing_out(preset, renderer) -> None:
    rng = np.random.default_rng(0)
    eyes = drawer(renderer, 64, 64)
    for _ in range(8):
        world = world_of("lab").twin()
        apply_lights(world, draw_lights(PRESETS[preset], world, rng))
        world.reset()
        for camera in CAMERAS:
            check_exposure(eyes.rgb(world, camera), (60, 215))
        eyes.forget(world)
    eyes.close()


@needs_gl
def test_shadows_of_a_turned_sun_have_no_specks() -> None:
    world, rng = world_of("lab").twin(), np.random.default_rng(5)
    eyes, usual = drawer("gl", 240, 320, "full"), world.model.light_dir.copy()
    for _ in range(4):
        world.model.light_dir[:] = usual
        turn = PRESETS["strong"].light_turn * rng.uniform(-1, 1, 3)
        apply_lights(world, {"turn": turn, "color": [1, 1, 1], "ambient": 1.0})
        world.reset()
        drawn = eyes.draw(world, FRONT_CAMERA, ("rgb", "segmentation"))
        floor = drawn["segmentation"] == world.model.geom(FLOOR).id
        assert specks(drawn["rgb"], floor).sum() < 3e-3 * floor.sum()
    eyes.close()


def test_exposure_dims_what_is_too_bright_and_leaves_the_rest() -> None:
    def of(sun: float, ambient: float, head: float) -> float:
        return exposure(np.full((1, 3), sun), np.full(3, ambient), np.full(3, head))

    assert of(SUN, AMBIENT, HEADLIGHT) == 1.0 and of(0.0, 0.0, 0.0) == 1.0
    assert of(2 * SUN, 2 * AMBIENT, 2 * HEADLIGHT) == pytest.approx(0.5)
    colored = exposure(np.array([[2 * BRIGHTEST, 0, 0]]), np.zeros(3), np.zeros(3))
    assert colored == pytest.approx(0.5), "no colour is blown out"


def test_any_randomized_light_keeps_within_the_exposure() -> None:
    world = World(toy_scene(), Panda())
    apply_lights(world, {"turn": [0, 0, 0], "color": [2.0, 1.0, 1.0], "ambient": 3.0})
    head = world.model.vis.headlight
    total = world.model.light_diffuse.sum(0) + head.ambient + head.diffuse
    assert total.max() == pytest.approx(BRIGHTEST)
    assert head.ambient[0] / world.model.light_diffuse[0, 1] == pytest.approx(3 * AMBIENT / SUN)
