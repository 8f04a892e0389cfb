"""Height maps around the target and its goal, as part of the observation."""

import pickle

import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.utils.env_checker import check_env
from toy import toy_scene

from generator.errors import InputError
from generator.geometry import rotation_yaw
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.observations.bounds import Noise
from tabletopgen_env.observations.height_map import CELL, CELLS, STEP, HeightLook, height_map_space
from tabletopgen_env.parallel.vector import TabletopVectorEnv

CUBE = {"target": "cube_1"}


def started(
    task: str = "Lift", options: dict | None = None, **settings
) -> tuple[TabletopEnv, dict]:
    env = make_env(toy_scene(), task=task, geometry="height_map", **settings)
    return env, env.reset(seed=0, options=CUBE if options is None else options)[0]


def test_the_state_stays_as_it_was_and_the_maps_come_beside_it() -> None:
    env, seen = started()
    assert set(seen) == {"state", "height_map"}
    assert env.observation_space == spaces.Dict({
        "state": make_env(toy_scene(), task="Lift").observation_space,
        "height_map": height_map_space(),
    })  # fmt: skip
    plain = make_env(toy_scene(), task="Lift").reset(seed=0, options=CUBE)[0]
    assert np.array_equal(seen["state"], plain)
    check_env(env, skip_render_check=True)


def test_the_first_map_has_the_target_at_its_size_and_height() -> None:
    env, seen = started()
    own, world = seen["height_map"][0], env.world
    half = world.half_extent[world.index("cube_1")]
    top = world.position("cube_1")[2] + half[2] - world.scene.table.height
    assert own.max() * STEP == pytest.approx(top, abs=STEP)
    for axis in (0, 1):
        cells = (own > 0).any(1 - axis).sum()
        assert cells * CELL == pytest.approx(2 * half[axis], abs=2 * CELL)
    rows = np.flatnonzero(own.any(1))
    assert abs(rows.mean() - (CELLS - 1) / 2) < 1  # in the middle


def test_the_maps_agree_with_rays_from_above() -> None:
    import mujoco

    env, seen = started()
    world, own = env.world, seen["height_map"]
    world.place_arm(np.array([2.5, -1.5, 0, -2.8, 0, 1.5, 0]))  # out of the way
    c, s = np.cos(yaw := rotation_yaw(world.rotation("cube_1"))), np.sin(yaw)
    compared = 0
    for i, j in np.ndindex(CELLS, CELLS):
        if (i % 3, j % 3) != (0, 0):
            continue
        x, y = (np.array([i, j]) - (CELLS - 1) / 2) * CELL
        middle = world.position("cube_1")[:2] + np.array([c * x - s * y, s * x + c * y])
        geom = np.zeros(1, np.int32)
        start = np.array([*middle, world.scene.table.height + 0.5])
        group = np.array([1] * 6, np.uint8)
        far = mujoco.mj_ray(
            world.model, world.data, start, np.array([0, 0, -1.0]), group, 1, -1, geom
        )
        hit = max(0.5 - far, 0.0) if far >= 0 else 0.0
        around = own[:2, max(i - 1, 0) : i + 2, max(j - 1, 0) : j + 2].max(0) * STEP
        assert around.min() - 0.004 <= hit <= around.max() + 0.004
        compared += hit > 0.01
    assert compared > 5


def test_the_maps_turn_and_move_with_the_target() -> None:
    env, seen = started()
    world, look = env.world, HeightLook()
    own = seen["height_map"][0]
    turned = np.array([np.cos(0.3), 0, 0, np.sin(0.3)])
    world.teleport("cube_1", world.position("cube_1") + np.array([0.013, 0.02, 0.03]), turned)
    after = look.maps(world, env.goal)
    assert np.array_equal(after[0] > 0, own > 0)
    assert after[0].max() - own.max() == pytest.approx(0.03 / STEP, abs=1)
    assert not after[1].any()
    beside = world.position("cube_1") + np.array([0.07, 0, 0])
    world.teleport("can_1", beside)
    rest = look.maps(world, env.goal)[1]
    i, j = np.argwhere(rest > 0).mean(0)
    heading = rotation_yaw(world.rotation("cube_1"))
    expected = 0.07 / CELL * np.array([np.cos(heading), -np.sin(heading)]) + (CELLS - 1) / 2
    assert np.allclose([i, j], expected, atol=1)


def test_the_third_map_is_around_the_goal_without_the_target() -> None:
    env, seen = started("PickPlace", {**CUBE, "goal": "bowl_1"})
    world, there = env.world, seen["height_map"][2]
    half = world.half_extent[world.index("bowl_1")]
    rim = world.position("bowl_1")[2] + half[2] - world.scene.table.height
    assert there.max() * STEP == pytest.approx(rim, abs=0.005)
    middle = there[CELLS // 2, CELLS // 2]
    assert 0 < middle < there.max()  # the hollow is lower than the rim


def test_looks_do_not_depend_on_what_was_seen_before() -> None:
    env, _ = started()
    old = HeightLook()
    for step in range(30):
        seen = env.step(np.array([0.5, 0.2, -0.5 if step < 20 else 0.5, 0.3, -1.0]))[0]
        fresh = HeightLook().maps(env.world, env.goal)
        assert np.array_equal(fresh, seen["height_map"])
        assert np.array_equal(old.maps(env.world, env.goal), fresh)
    seen["height_map"][:] = 7  # a policy's own
    assert np.array_equal(old.maps(env.world, env.goal), fresh)


def test_reach_sees_empty_maps() -> None:
    env = make_env(toy_scene(), task="Reach", geometry="height_map")
    assert not env.reset(seed=0)[0]["height_map"].any()


def test_noise_shifts_the_frame_and_not_the_shapes() -> None:
    env, _ = started()
    shift = np.zeros((12, 3))
    shift[0, 0] = 2 * CELL
    off = Noise(np.zeros(7), shift, np.zeros((12, 3)))
    world = env.world
    world.teleport("cube_1", world.position("cube_1"), np.array([1.0, 0, 0, 0]))
    true, noisy = (HeightLook().maps(world, env.goal, n)[0] for n in (None, off))
    assert np.array_equal(noisy[:-2], true[2:])


def test_pixels_and_vectors_and_copies_have_them_too() -> None:
    env, seen = started(observation="pixels+state", image_size=16, cameras=["front"])
    assert set(seen) == {"front", "state", "height_map"}
    slots = TabletopVectorEnv(2, scenes=toy_scene(), task="Lift", geometry="height_map")
    assert slots.reset(seed=0)[0]["height_map"].shape == (2, 3, CELLS, CELLS)
    slots.close()
    copied = pickle.loads(pickle.dumps(env))
    assert np.array_equal(copied.reset(seed=0, options=CUBE)[0]["height_map"], seen["height_map"])


@pytest.mark.parametrize(
    ("settings", "told"),
    [
        ({"geometry": "mesh"}, "Unknown geometry 'mesh'"),
        ({"geometry": "height_map", "observation": "goal"}, "hindsight"),
    ],
)
def test_what_there_is_not_is_refused(settings: dict, told: str) -> None:
    with pytest.raises(InputError, match=told):
        make_env(toy_scene(), task="Lift", **settings)
