"""Camera images: keys, sizes, depth, segmentation by slots, and point clouds."""

import numpy as np
import pytest
from test_rendering import needs_gl
from toy import toy_object, toy_scene, toy_table

from generator.errors import InputError
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.observations.modes import slot_order
from tabletopgen_env.rendering.config import ObservationConfig
from tabletopgen_env.rendering.drawer import drawer
from tabletopgen_env.rendering.point_cloud import ABOVE, point_cloud, unproject
from tabletopgen_env.rendering.views import (
    DEPTH_FAR,
    SLOTS,
    TABLETOP,
    geom_labels,
    model_camera,
    pictures,
)
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.tasks.candidates import into
from tabletopgen_env.world.composition import FRONT_CAMERA, MARKER, TOP_CAMERA
from tabletopgen_env.world.world import World

RENDERERS = [pytest.param("gl", marks=needs_gl), "software"]
KINDS = ("rgb", "depth", "segmentation")
ORDER = ["cube_1", "bowl_1"]


@pytest.fixture(scope="module")
def world() -> World:
    env = make_env(toy_scene())
    env.reset(seed=0, options={"goal": "bowl_1", "target": "cube_1"})
    return env.world


def order_of(world: World) -> list[str]:
    goal = into(world, world.scene.object("cube_1"), world.scene.object("bowl_1"))
    return slot_order(world, goal)


@pytest.mark.slow
@pytest.mark.parametrize("renderer", RENDERERS)
def test_every_camera_gives_every_kind(renderer) -> None:
    env = make_env(
        toy_scene(), observation="pixels+state", cameras=("front", "wrist", "top"),
        kinds=KINDS, image_size=(24, 32), renderer=renderer,
    )  # fmt: skip
    seen, _ = env.reset(seed=0)
    assert set(seen) == {"state"} | {
        camera + end for camera in ("front", "wrist", "top")
        for end in ("", "_depth", "_segmentation")
    }  # fmt: skip
    for camera in ("front", "wrist", "top"):
        assert seen[camera].shape == (24, 32, 3) and seen[camera].dtype == np.uint8
        depth, labels = seen[f"{camera}_depth"], seen[f"{camera}_segmentation"]
        assert depth.shape == (24, 32) and depth.dtype == np.float32
        assert labels.shape == (24, 32) and labels.dtype == np.uint8
        assert seen[camera].std() > 10 and 0 < depth.min() < depth.max() <= DEPTH_FAR
        assert len(np.unique(labels)) > 2
    assert env.observation_space.contains(seen)
    env.close()


@pytest.mark.parametrize("renderer", RENDERERS)
def test_a_segmentation_shows_each_object_where_it_is(world, renderer) -> None:
    order = order_of(world)
    config = ObservationConfig("pixels", ("front",), ("segmentation",), (200, 240))
    eyes = drawer(renderer, 200, 240)
    labels = pictures(config, world, lambda _: eyes, order, None)["front_segmentation"]
    eyes.close()
    camera = model_camera(world, FRONT_CAMERA, 200, 240)
    for slot, name in enumerate(order):
        rows, columns = np.nonzero(labels == 3 + slot)
        assert len(rows) > 10, name
        u, v = camera.project(world.position(name)[None])[0]
        low, high = [columns.min(), rows.min()], [columns.max() + 1, rows.max() + 1]
        assert (np.array(low) - 3 < [u, v]).all() and ([u, v] < np.array(high) + 3).all(), name
    shoulder = world.mount.position + np.array([0, 0, 0.33])
    for label, point in ((1, shoulder), (2, np.array([0.1, -0.3, 0.74]))):
        u, v = camera.project(point[None])[0]
        assert labels[int(v), int(u)] == label
    assert labels[0, 0] == 0


def test_labels_follow_the_slots_and_leave_out_what_has_none(world) -> None:
    labels, owner = geom_labels(world, ORDER), world.model.geom_bodyid
    for name, label in (("cube_1", 3), ("bowl_1", 4), ("can_1", 0)):
        assert (labels[:-1][owner == world.model.body(name).id] == label).all()
    assert labels[-1] == 0 and set(labels) == {0, 1, 2, 3, 4}
    assert labels[world.model.geom("floor").id] == 0
    assert labels[world.model.geom("pedestal_column").id] == 1


@pytest.mark.slow
@needs_gl
@pytest.mark.parametrize("renderer", RENDERERS)
def test_one_spot_is_marked_at_a_time_and_is_the_table_s(renderer) -> None:
    env = make_env(toy_scene(), task="Swap")
    env.reset(seed=0, options={"target": "cube_1", "goal": "can_1"})
    world, eyes = env.world, drawer(renderer, 200, 240)
    camera = model_camera(world, TOP_CAMERA, 200, 240)
    marker = world.model.geom(MARKER).id
    for number in range(3):
        spot = env.goal.spot
        assert env.goal is env.episode.goals[number] and spot is not None
        seen = eyes.draw(world, TOP_CAMERA, ("segmentation",))["segmentation"]
        rows, columns = np.nonzero(seen == marker)
        middle, edge = camera.project(
            np.array([spot, spot + np.array([env.task.marker_radius, 0, 0])])
        )
        away = np.hypot(columns + 0.5 - middle[0], rows + 0.5 - middle[1])
        assert len(rows) > 8 and away.max() < np.linalg.norm(edge - middle) + 2, number
        assert geom_labels(world, ["cube_1"])[marker] == TABLETOP
        world.teleport(str(env.goal.target), env.goal.region(world).center)
        for _ in range(20):
            env.step(np.array([0.0, 0, 0, 0, 1]))
    world.show_marker(None, 0.04)
    assert marker not in eyes.draw(world, TOP_CAMERA, ("segmentation",))["segmentation"]
    eyes.close()


def seen_by(renderer: str, config: ObservationConfig, world: World, order: list[str]) -> dict:
    return pictures(config, world, lambda size: drawer(renderer, *size), order, None)


def test_gl_and_software_agree_on_depth_and_segmentation(world) -> None:
    config = ObservationConfig("pixels", ("front", "wrist", "top"), KINDS[1:], (60, 80))
    order = order_of(world)
    a, b = (seen_by(r, config, world, order) for r in ("gl", "software"))
    for camera in config.cameras:
        labels = a[f"{camera}_segmentation"], b[f"{camera}_segmentation"]
        same = labels[0] == labels[1]
        assert same.mean() > 0.98
        on = same & (labels[0] > 0)
        gap = np.abs(a[f"{camera}_depth"] - b[f"{camera}_depth"])[on]
        assert on.mean() > 0.1 and np.quantile(gap, 0.95) < 2e-3


@pytest.mark.slow
@needs_gl
def test_the_full_profile_has_the_same_ids_as_the_fast_one() -> None:
    worlds = [World(toy_scene(), Panda()) for _ in range(2)]
    drawn = []
    for made, profile in zip(worlds, ("fast", "full"), strict=True):
        made.reset()
        drawn.append(drawer("gl", 60, 80, profile).draw(made, "front", ("segmentation",)))
    assert np.array_equal(drawn[0]["segmentation"], drawn[1]["segmentation"])


@pytest.mark.parametrize("size", [(1.2, 0.7, 0.74), (0.7, 1.4, 0.74)])
@pytest.mark.parametrize("picture", [(40, 40), (30, 60)])
def test_the_top_camera_shows_the_whole_table_the_robot_below(size, picture) -> None:
    table = toy_table(size=size)
    scene = toy_scene((toy_object("cube_1", (0.04, 0.04, 0.04), (0.05, 0.1)),), table)
    env = make_env(scene)
    env.reset(seed=0)
    camera = model_camera(env.world, TOP_CAMERA, *picture)
    corners = np.column_stack([table.outline, np.full(len(table.outline), table.height)])
    pixels = camera.project(corners)
    assert (pixels > 0).all() and (pixels < [picture[1], picture[0]]).all()
    assert np.ptp(pixels[:, 1]).max() > 0.4 * picture[0] / max(size[:2]) * min(size[:2])
    v = camera.project(env.world.mount.position[None])[0, 1]
    assert v > picture[0] / 2
    assert np.allclose(camera.rotation[2], [0, 0, -1], atol=1e-6)


def test_depth_says_ten_metres_where_nothing_is() -> None:
    env = make_env(toy_scene(), observation="pixels", kinds=("depth",), cameras=("front",),
                   image_size=16, renderer="software")  # fmt: skip
    env.reset(seed=0)
    env.world.data.cam_xpos[:] += [0, 0, 30]  # above everything
    seen = pictures(env._views, env.world, env._drawer, [], None)
    assert (seen["front_depth"] == DEPTH_FAR).all()


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"cameras": ("frond",)}, "Unknown camera 'frond'.*Did you mean 'front'.*top, wrist"),
        ({"cameras": ()}, "at least one camera"),
        ({"cameras": ("top", "top")}, "no duplicates"),
        ({"cameras": None}, "Unknown camera None"),
        ({"kinds": ("flow",)}, "Unknown kind 'flow'.*depth, rgb, segmentation"),
        ({"kinds": ()}, "at least one kind"),
        ({"image_size": (64, 4)}, "between 8 and 2048"),
        ({"image_size": (64, 64, 3)}, "between 8 and 2048"),
        ({"image_size": 64.5}, "between 8 and 2048"),
        ({"image_size": True}, "between 8 and 2048"),
        ({"points": 0}, "between 1 and 65536"),
        ({"points": 10.0}, "between 1 and 65536"),
    ],
)
def test_wrong_configurations_are_explained(settings, message) -> None:
    with pytest.raises(InputError, match=message):
        ObservationConfig(**settings)


def test_lists_and_single_names_are_taken_too() -> None:
    config = ObservationConfig("pixels", ["top", "front"], "depth", [32, 48])  # type: ignore[arg-type]
    assert config == ObservationConfig("pixels", ("top", "front"), ("depth",), (32, 48))
    assert config.sizes == {"top": (32, 48), "front": (32, 48)}
    assert ObservationConfig(image_size=64).sizes == {"front": (64, 64), "wrist": (64, 64)}


# ------------------------------------------------------------------------------ point clouds
def clouded(renderer: str = "software", **settings) -> TabletopEnv:
    env = make_env(
        toy_scene(), observation="point_cloud", renderer=renderer,
        **{"image_size": 64, "points": 400, "cameras": ("front", "top"), **settings},
    )  # fmt: skip
    env.reset(seed=0, options={"target": "cube_1", "goal": "bowl_1"})
    return env


@pytest.mark.slow
@pytest.mark.parametrize("renderer", RENDERERS)
def test_points_lie_on_what_their_id_says(renderer) -> None:
    env = clouded(renderer, points=2000)
    seen, world = env.step(np.zeros(5))[0], env.world
    filled = seen["point_mask"] == 1
    assert filled.sum() > 300 and (~filled).any()
    ids, points = seen["point_ids"][filled], world.to_world(seen["points"][filled].astype(float))
    order = order_of(world)
    assert set(ids) >= {1, 3, 4}
    for slot, name in enumerate(order):
        own = points[ids == 3 + slot]
        local = (own - world.position(name)) @ world.rotation(name)
        assert (np.abs(local) <= world.half_extent[world.index(name)] + 0.004).all(), name
    assert (points[:, 2] >= world.scene.table.height + ABOVE - 1e-5).all()
    for key in ("points", "point_ids"):
        assert not seen[key][~filled].any()
    env.close()


@pytest.mark.slow
def test_a_crowded_cloud_is_thinned_evenly_and_always_alike() -> None:
    few = clouded(points=100)
    first, world = few.step(np.zeros(5))[0], few.world
    assert first["point_mask"].all()
    config = ObservationConfig("pixels", ("front", "top"), image_size=64, points=1 << 14)
    every = point_cloud(config, world, lambda size: drawer("software", *size), order_of(world))
    count = int(every["point_mask"].sum())
    kept = np.arange(100) * count // 100
    assert np.array_equal(first["points"], every["points"][kept])
    assert np.array_equal(first["point_ids"], every["point_ids"][kept])
    again = clouded(points=100)
    assert np.array_equal(again.step(np.zeros(5))[0]["points"], first["points"])


def test_a_cloud_of_nothing_is_all_padding() -> None:
    env = clouded(cameras=("wrist",))
    env.world.data.cam_xpos[:] += [0, 0, 30]
    cloud = point_cloud(env._views, env.world, env._drawer, ORDER)
    assert not any(part.any() for part in cloud.values())
    assert env.observation_space.contains(cloud)


def test_pixels_and_points_are_inverse(world) -> None:
    camera = model_camera(world, "front", 12, 20)
    depth = np.linspace(0.5, 3.0, 240).reshape(12, 20)
    points = unproject(camera, depth)
    rows, columns = np.indices(depth.shape) + 0.5
    assert np.allclose(camera.project(points), np.stack([columns, rows], -1).reshape(-1, 2))
    assert np.allclose(camera.to_camera(points)[:, 2], depth.ravel())
    depth[3, 4] = np.inf
    assert np.isnan(unproject(camera, depth)[3 * 20 + 4]).all()


def test_there_is_room_for_the_slots_that_the_state_has() -> None:
    space = clouded().observation_space["point_ids"]
    assert space.high.max() == 3 + SLOTS - 1
