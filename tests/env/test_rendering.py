"""Pictures with GL if available, and in software; both agree."""

import sys

import numpy as np
import pytest
from toy import toy_objects, toy_scene

from generator.errors import BackendError, InputError
from tabletopgen_env.env import make_env
from tabletopgen_env.rendering import drawer as rendering
from tabletopgen_env.rendering.drawer import GlDrawer, drawer
from tabletopgen_env.rendering.software import SoftwareDrawer, visible_shapes
from tabletopgen_env.rendering.views import model_camera
from tabletopgen_env.world.composition import FRONT_CAMERA, WRIST_CAMERA


def has_gl() -> bool:
    try:
        drawer("gl", 8, 8).close()
    except BackendError:
        return False
    return True


needs_gl = pytest.mark.skipif(not has_gl(), reason="no OpenGL here")


@pytest.fixture(scope="module")
def world():
    env = make_env(toy_scene())
    env.reset(seed=0, options={"goal": (0.1, -0.15), "target": "cube_1"})
    return env.world


@pytest.mark.slow
@pytest.mark.parametrize("renderer", [pytest.param("gl", marks=needs_gl), "software", "auto"])
def test_render_modes(renderer) -> None:
    for mode, shape, dtype in (
        ("rgb_array", (60, 80, 3), np.uint8),
        ("depth_array", (60, 80), np.float32),
    ):
        env = make_env(toy_scene(), render_mode=mode, renderer=renderer, render_size=(60, 80))
        env.reset(seed=0)
        picture = env.render()
        assert picture.shape == shape and picture.dtype == dtype
        assert picture[np.isfinite(picture)].std() > 0.05
        env.close()


@pytest.mark.slow
@needs_gl
@pytest.mark.parametrize("camera", [FRONT_CAMERA, WRIST_CAMERA])
def test_gl_and_software_see_the_same(world, camera) -> None:
    gl, soft = drawer("gl", 96, 128), drawer("software", 96, 128)
    a, b = gl.depth(world, camera), soft.depth(world, camera)
    near = (a < 2.0) & (b < 2.0)
    assert near.mean() > 0.05
    assert np.quantile(np.abs(a[near] - b[near]), 0.95) < 0.005
    assert ((a < 2.0) == (b < 2.0)).mean() > 0.98
    colors = gl.rgb(world, camera)[near].astype(float), soft.rgb(world, camera)[near].astype(float)
    assert np.abs(colors[0] - colors[1]).mean() < 30
    gl.close()


@pytest.mark.slow
@pytest.mark.parametrize("renderer", [pytest.param("gl", marks=needs_gl), "software"])
def test_worlds_drawn_in_turn_keep_their_own_pictures(world, renderer) -> None:
    other = make_env(toy_scene())
    other.reset(seed=4, options={"target": "cube_1", "goal": (-0.2, -0.15)})
    eyes = drawer(renderer, 48, 64)
    first = [eyes.rgb(world, c) for c in (FRONT_CAMERA, WRIST_CAMERA)]
    second = [eyes.rgb(other.world, c) for c in (FRONT_CAMERA, WRIST_CAMERA)]
    again = [eyes.rgb(world, c) for c in (FRONT_CAMERA, WRIST_CAMERA)]
    assert (first[0] != second[0]).any()
    for before, after in zip(first, again, strict=True):
        np.testing.assert_array_equal(before, after)
    eyes.close()


def test_depth_is_the_distance_along_the_optical_axis(world) -> None:
    depth = drawer("software", 120, 160).depth(world, "top")
    camera = world.data.cam_xpos[world.model.camera("top").id]
    on_table = np.abs(depth - (camera[2] - 0.74)) < 1e-3
    assert on_table.mean() > 0.2


def test_the_marker_shows_the_spot_and_only_then(world) -> None:
    soft = drawer("software", 120, 160)
    world.show_marker(np.array([0.1, -0.15, 0.74]), 0.04)
    shown = soft.rgb(world, "top").astype(int)
    world.show_marker(None, 0.04)
    hidden = soft.rgb(world, "top").astype(int)
    changed = (shown != hidden).any(2)
    assert 5 < changed.sum() < 400
    greener = shown[changed] - hidden[changed]
    assert (greener[:, 1] > greener[:, 0]).all()


@pytest.mark.parametrize("renderer", [pytest.param("gl", marks=needs_gl), "software"])
def test_a_point_in_the_air_is_marked_by_a_ball(world, renderer) -> None:
    eyes, spot = drawer(renderer, 240, 320), np.array([0.1, -0.15, 0.95])
    camera = model_camera(world, FRONT_CAMERA, 240, 320)
    world.show_marker(None, 0.03)
    free = eyes.depth(world, FRONT_CAMERA)
    heights = []
    for shape in ("ball", "disc"):
        world.show_marker(spot, 0.03, shape)
        depth = eyes.depth(world, FRONT_CAMERA)
        rows, columns = np.nonzero(depth < free - 0.001)
        rays = camera.rays(np.column_stack([columns, rows]) + 0.5)
        along = depth[rows, columns] / (rays @ camera.rotation[2])
        points = camera.position + rays * along[:, None]
        heights.append(points[:, 2].max() - points[:, 2].min())
        assert np.abs(points - spot).max() < 0.031
    assert heights[0] > 0.03 > 0.002 > heights[1]
    world.show_marker(None, 0.04)
    eyes.close()


def test_every_visible_geom_but_the_floor_becomes_triangles_that_face_outwards(world) -> None:
    shapes = visible_shapes(world.model)
    drawn = {shape.geom for shape in shapes}
    visible = set(np.flatnonzero(world.model.geom_group < 3))
    assert drawn == visible - {world.model.geom("floor").id}
    pedestal = next(s for s in shapes if world.model.geom(s.geom).name == "pedestal_column")
    a, b, c = (pedestal.vertices[pedestal.faces[:, k]] for k in range(3))
    assert (np.einsum("fi,fi->f", np.cross(b - a, c - a), a + b + c) > 0).all()


def test_without_gl_auto_falls_back_and_gl_names_the_packages(monkeypatch) -> None:
    monkeypatch.setattr(rendering, "_gl_modules", lambda: ("mujoco.no_such_gl",))
    assert isinstance(drawer("auto", 8, 8), SoftwareDrawer)
    with pytest.raises(BackendError, match=r"libegl1 libgl1 libgl1-mesa-dri.*libosmesa6"):
        drawer("gl", 8, 8)


def test_egl_is_chosen_only_without_display_and_wish(monkeypatch) -> None:
    monkeypatch.setattr(sys, "platform", "linux")
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "MUJOCO_GL"):
        monkeypatch.delenv(name, raising=False)
    assert rendering._gl_modules() == ("mujoco.egl", "mujoco.osmesa")
    monkeypatch.setenv("MUJOCO_GL", "osmesa")
    assert rendering._gl_modules() == ("mujoco.gl_context",)
    monkeypatch.delenv("MUJOCO_GL")
    monkeypatch.setenv("DISPLAY", ":0")
    assert rendering._gl_modules() == ("mujoco.gl_context",)


@needs_gl
def test_closing_frees_and_refuses_to_go_on(world) -> None:
    gl = drawer("gl", 16, 16)
    assert isinstance(gl, GlDrawer)
    gl.rgb(world, FRONT_CAMERA)
    gl.close()
    gl.close()
    with pytest.raises(InputError, match="closed"):
        gl.rgb(world, FRONT_CAMERA)


@pytest.mark.slow
@needs_gl
def test_many_scenes_share_one_drawer() -> None:
    scenes = [toy_scene(name=f"toy_{k}") for k in range(6)]
    env = make_env(scenes, render_mode="rgb_array", render_size=(32, 32), renderer="gl", cache=2)
    pictures = []
    for seed in range(8):
        env.reset(seed=seed)
        pictures.append(env.render())
    assert all(picture.std() > 10 for picture in pictures)
    env.close()


def test_human_mode_without_a_display_says_so_once(monkeypatch) -> None:
    for name in ("DISPLAY", "WAYLAND_DISPLAY"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(sys, "platform", "linux")
    env = make_env(toy_scene(), render_mode="human")
    with pytest.warns(UserWarning, match="needs a display") as caught:
        env.reset(seed=0)
        env.step(env.action_space.sample())
    assert len(caught) == 1
    env.close()


@pytest.mark.slow
def test_what_leaves_the_cache_is_freed_on_the_graphics_side() -> None:
    scenes = [toy_scene(toy_objects()[: k + 1], name=str(k)) for k in range(3)]
    env = make_env(scenes, observation="pixels", image_size=16, cache=1)
    for seed in range(8):
        env.reset(seed=seed)
        drawer = env._drawer((16, 16))
        held = getattr(drawer, "_held", None) or getattr(drawer, "_shapes", {})
        assert len(held) == 1
    env.close()
