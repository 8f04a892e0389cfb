"""Inputs of a real robot: pictures with calibration, proprioception, instructions, marks."""

import gymnasium as gym
import numpy as np
import pytest
from gymnasium import spaces
from gymnasium.utils.env_checker import check_env
from toy import toy_scene

from generator.errors import InputError
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.observations.instructions import (
    CHARACTERS,
    MOST_CHARACTERS,
    MOST_TOKENS,
    embed,
    show_instruction,
    tokens,
)
from tabletopgen_env.parallel.vector import TabletopVectorEnv
from tabletopgen_env.rendering.config import PRESETS, ObservationConfig
from tabletopgen_env.rendering.point_cloud import unproject

SMALL = {"image_size": 24, "renderer": "software"}
GOAL = {"target": "can_1", "goal": "bowl_1"}


def started(**settings) -> tuple[TabletopEnv, dict, dict]:
    env = make_env(toy_scene(), **{"observation": "pixels+proprio", **SMALL, **settings})
    seen, info = env.reset(seed=0, options=GOAL)
    return env, seen, info


def test_nothing_in_it_is_privileged() -> None:
    env, seen, info = started()
    state = make_env(toy_scene())
    flat, _ = state.reset(seed=0, options=GOAL)
    assert set(seen) == {"front", "wrist", "proprio", "instruction"}
    assert seen["instruction"] == info["instruction"] == "put the can into the bowl"
    assert np.array_equal(seen["proprio"][:32], flat[:32])
    for k in range(3):
        action = np.array([0.3, -0.2, -0.4, 0.1, (-1.0) ** k])
        seen, flat = env.step(action)[0], state.step(action)[0]
        assert np.array_equal(seen["proprio"][:32], flat[:32])
    env.world.teleport("can_1", np.array([0.2, 0.2, 0.8]))  # where an object is changes no entry
    again = env._observe(np.zeros(8), np.zeros(8))["proprio"]
    assert np.allclose(again, seen["proprio"], atol=2e-3)  # positions are a physics step newer
    assert env.observation_space.contains(seen)


def test_gymnasiums_checker_takes_texts() -> None:
    env, _, _ = started(cameras=("front",), image_size=8)
    check_env(env, skip_render_check=True)


def test_joints_that_are_misread_are_misread_alike() -> None:
    noisy = {"randomization": "strong"}
    env, seen, _ = started(**noisy)
    other = make_env(toy_scene(), **noisy)
    assert np.array_equal(seen["proprio"][:32], other.reset(seed=0, options=GOAL)[0][:32])
    assert not np.array_equal(seen["proprio"][:7], env.world.state.joints.astype(np.float32))


def test_calibrations_take_pixels_to_where_things_are() -> None:
    cameras = ("front", "wrist", "top", "side")
    env, seen, info = started(cameras=cameras, kinds=("depth",), image_size={
        "front": (60, 90), "wrist": 40, "top": 64, "side": (48, 64),
    })  # fmt: skip
    assert seen["front_depth"].shape == (60, 90) and seen["side_depth"].shape == (48, 64)
    for name in cameras:
        lens, pose = info["cameras"][name]["intrinsics"], info["cameras"][name]["extrinsics"]
        depth = seen[f"{name}_depth"].astype(float)
        rows, columns = np.indices(depth.shape)
        rays = np.stack([columns, rows, np.ones_like(rows)], -1) @ np.linalg.inv(lens).T
        points = (depth[..., None] * rays).reshape(-1, 3) @ pose[:3, :3].T + pose[:3, 3]
        height = env.world.scene.table.height - env.world.base_position[2]
        flat = np.abs(points[:, 2] - height) < 2e-3
        assert flat.mean() > 0.05, name  # the table top is where it is
        camera = env.world.model.camera({"wrist": "panda/wrist", "top": "overhead"}.get(name, name))
        at = env.world.to_base(env.world.data.cam_xpos[camera.id])
        assert np.allclose(pose[:3, 3], at) and np.isclose(np.linalg.det(pose[:3, :3]), 1)
    before = info["cameras"]["wrist"]["extrinsics"]
    info = env.step(np.array([0.0, 0, -1, 0, 1]))[4]
    assert info["cameras"]["wrist"]["extrinsics"][2, 3] < before[2, 3]


def test_the_calibration_is_the_renderers() -> None:
    env, _, info = started(cameras=("side",), kinds=("depth",))
    from tabletopgen_env.rendering.views import model_camera

    camera = model_camera(env.world, "side", 24, 24)
    depth = np.full((24, 24), 0.7)
    lens, pose = (info["cameras"]["side"][k] for k in ("intrinsics", "extrinsics"))
    ray = np.linalg.inv(lens) @ [23, 5, 1]
    mine = pose[:3, :3] @ (0.7 * ray) + pose[:3, 3]
    theirs = env.world.to_base(unproject(camera, depth)[5 * 24 + 23])
    assert np.allclose(mine, theirs)


def test_flat_observations_have_no_cameras() -> None:
    assert "cameras" not in make_env(toy_scene()).reset(seed=0)[1]


def test_a_gripper_that_closes_is_felt() -> None:
    env, seen, _ = started()
    assert seen["proprio"][32] == 0
    moving = env.step(np.array([0.0, 0, 0, 0, -1]))[0]["proprio"]
    for _ in range(20):
        seen = env.step(np.array([0.0, 0, 0, 0, -1]))[0]
    assert moving[32] < -0.05 and abs(seen["proprio"][32]) < 1e-3


def test_calibrations_can_be_entries() -> None:
    env, seen, info = started(calibration=True, image_size=(24, 36))
    for name, told in info["cameras"].items():
        entries = seen[f"{name}_calibration"]
        assert np.allclose(entries[:12].reshape(3, 4), told["extrinsics"][:3], atol=1e-6)
        lens = told["intrinsics"]
        assert np.allclose(24 * entries[12:], [lens[0, 0], lens[1, 1], *lens[:2, 2]], atol=1e-4)
    assert env.observation_space.contains(seen)


@pytest.mark.parametrize("mark", ["mask", "overlay"])
def test_the_target_is_marked_where_it_is_seen(mark) -> None:
    env, seen, _ = started(target_mark=mark, cameras=("top", "front"), image_size=64)
    _, usual, _ = started(cameras=("top", "front"), image_size=64, kinds=("rgb", "segmentation"))
    for camera in ("top", "front"):
        target = usual[f"{camera}_segmentation"] == 3
        assert 4 < target.sum() < 1000
        if mark == "mask":
            assert np.array_equal(seen[f"{camera}_target"], target)
            assert np.array_equal(seen[camera], usual[camera])
        else:
            changed = (seen[camera] != usual[camera]).any(-1)
            assert not (changed & ~target).any() and changed[target].mean() > 0.9
    assert env.observation_space.contains(seen)


def test_a_task_of_the_tool_marks_nothing() -> None:
    env = make_env(toy_scene(), task="Reach", observation="pixels", target_mark="mask", **SMALL)
    assert not env.reset(seed=0)[0]["front_target"].any()


@pytest.mark.parametrize(
    ("kind", "length", "dtype"), [("tokens", 32, np.int32), ("embedding", 64, np.float32)]
)
def test_an_instruction_can_be_numbers(kind, length, dtype) -> None:
    env, seen, _ = started(instruction=kind)
    assert seen["instruction"].shape == (length,) and seen["instruction"].dtype == dtype
    assert env.observation_space.contains(seen)


def test_tokens_are_the_words() -> None:
    row = tokens("Put the cube, then the cube!")
    assert row[2] == row[5] and row[1] == row[4] and (row[:6] > 0).all() and not row[6:].any()
    assert tokens("a " * 100).all() and len(tokens("")) == MOST_TOKENS and not tokens("").any()


def test_embeddings_of_similar_texts_are_similar() -> None:
    lift, more, other = (embed(t) for t in ("lift the red mug", "lift the red mugs", "push a fork"))
    assert lift @ more > 0.7 > lift @ other
    assert np.isclose(lift @ lift, 1) and not embed("…").any()


def test_foreign_characters_and_long_texts_fit_the_space() -> None:
    shown = show_instruction("text", "lift the café " + "x" * 1000)
    assert isinstance(shown, str) and shown.startswith("lift the caf? ")
    assert len(shown) == MOST_CHARACTERS and set(shown) <= set(CHARACTERS)


@pytest.mark.parametrize("preset", PRESETS)
def test_presets_name_cameras_and_sizes(preset) -> None:
    config = ObservationConfig("pixels", preset)
    assert config.sizes == dict(PRESETS[preset])
    assert ObservationConfig("pixels", preset, image_size=16).sizes.keys() == config.sizes.keys()


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"cameras": "droit"}, "Unknown camera 'droit'"),
        ({"image_size": {"front": 32}}, "each of the cameras front, wrist, got front"),
        ({"image_size": {"front": 32, "wirst": 32}}, "Unknown camera 'wirst'.*wrist"),
        ({"image_size": {"front": 32, "wrist": 4}}, "between 8 and 2048"),
        ({"mode": "state", "instruction": "text"}, "requires a mode with pictures or points"),
        ({"mode": "pixels", "instruction": "speech"}, "Unknown instruction 'speech'.*tokens"),
        ({"mode": "point_cloud", "target_mark": "mask"}, "requires pictures"),
        ({"target_mark": "arrow"}, "Unknown target_mark 'arrow'.*overlay"),
        ({"target_mark": "overlay", "kinds": ("depth",)}, "add 'rgb' to kinds"),
        ({"mode": "point_cloud", "calibration": True}, "requires pictures"),
        ({"calibration": 1}, "must be True or False"),
        ({"geometry": "height_map"}, "the inputs of a real robot"),
        ({"grasp_hint": "planned"}, r"use 'pixels\+state'"),
    ],
)
def test_wrong_settings_are_explained(settings, message) -> None:
    with pytest.raises(InputError, match=message):
        ObservationConfig(**{"mode": "pixels+proprio", **settings})


@pytest.mark.parametrize("how", [{"threads": 1}, {"processes": 1}])
def test_slots_show_texts_and_calibrations(how) -> None:
    settings = {"observation": "pixels+proprio", "cameras": ("front",), **SMALL}
    _, seen, info = started(**settings)
    vector = TabletopVectorEnv(2, scenes=toy_scene(), **how, **settings)
    try:
        many, infos = vector.reset(seed=[0, 1], options=GOAL)
        assert isinstance(vector.observation_space, spaces.Dict)
        assert vector.observation_space.contains(many)
        assert many["instruction"] == (seen["instruction"],) * 2
        assert np.array_equal(many["proprio"][0], seen["proprio"])
        assert np.array_equal(many["front"][0], seen["front"])
        there = infos["cameras"]["front"]["extrinsics"][0]
        assert np.array_equal(there, info["cameras"]["front"]["extrinsics"])
        many = vector.step(vector.action_space.sample())[0]
        assert many["instruction"] == (seen["instruction"],) * 2
    finally:
        vector.close()


def test_settings_survive_in_the_spec() -> None:
    made = gym.make(
        "tabletopgen_env:TabletopGen/Lift-v0", observation="pixels+proprio", cameras="maniskill",
        instruction="tokens", target_mark="mask",
    )  # fmt: skip
    assert made.spec is not None
    again = gym.make(gym.envs.registration.EnvSpec.from_json(made.spec.to_json()))
    assert again.observation_space == made.observation_space
    assert again.observation_space["front"].shape == (128, 128, 3)
