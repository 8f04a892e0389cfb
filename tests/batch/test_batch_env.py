"""The batch as a Gymnasium vector environment, with the single environment's episodes."""

import re
from typing import Any

import numpy as np
import pytest
import torch
from extent import count
from gymnasium.vector import AutoresetMode
from gymnasium.wrappers.vector import RecordEpisodeStatistics
from gymnasium.wrappers.vector.array_conversion import ArrayConversion
from tables import COMPILING, need_warp

from generator.errors import InputError, SceneError
from tabletopgen_env import STEPS
from tabletopgen_env.env import make_env
from tabletopgen_env.expert.run import TaskExpert
from tabletopgen_env.tasks.reach import Reach
from tabletopgen_env.tasks.task import Task
from tabletopgen_env.tasks.tidy import Tidy

need_warp()
pytestmark = [pytest.mark.usefixtures("kernels"), pytest.mark.timeout(COMPILING)]

from tabletopgen_env.parallel.batch.decks import DeckConfig  # noqa: E402
from tabletopgen_env.parallel.batch.env import TabletopBatchEnv, time_limit  # noqa: E402

SCENES = ["vanity", "coffee-square"]
EACH = 2


@pytest.fixture(scope="module")
def lift() -> TabletopBatchEnv:
    """A world for each episode of two tables."""
    return batch(EACH * len(SCENES))


def batch(worlds: int, **more: Any) -> TabletopBatchEnv:
    given: dict[str, Any] = {"task": "Lift", "randomization": "starts", "max_episode_steps": 100}
    return TabletopBatchEnv(
        worlds, SCENES, device="cpu", deck=DeckConfig(episodes=EACH), **{**given, **more}
    )


def in_turn(env: TabletopBatchEnv) -> tuple[Any, dict[str, Any]]:
    """Start world k with episode k."""
    return env.reset(seed=0, options={"episodes": range(env.num_envs)})


def play(env: TabletopBatchEnv, rows: list[int], steps: int) -> list[dict[str, Any]]:
    """Play episodes of a batch alone with the expert; return observations and actions."""
    played = []
    single = make_env(SCENES, task=env.task, randomization="starts")
    for row in rows:
        name = env.bank.scenes[int(env.episodes.scene[row])]
        seen, info = single.reset(seed=env.episodes.seeds[row], options={"scene": name})
        assert single.world.scene.name == name
        kept: dict[str, list[Any]] = {"seen": [seen], "actions": [], "rewards": [], "success": []}
        expert = TaskExpert(single)
        expert.reset()
        for _ in range(steps):
            action = expert.act()
            seen, reward, _, _, info = single.step(action)
            for key, value in (("seen", seen), ("actions", action), ("rewards", reward),
                               ("success", info["success"])):  # fmt: skip
                kept[key].append(value)
        target = single.goal.target
        assert target is not None and env.episodes.instructions[row] == info["instruction"]
        played.append({k: np.array(v) for k, v in kept.items()})
        played[-1]["target"] = single.world.to_base(single.world.position(target))
    return played


def test_the_experts_episodes_go_as_in_the_single_environment(lift: TabletopBatchEnv) -> None:
    """One episode at each table; in the other worlds the robot stands still."""
    steps = 75
    rows = list(range(lift.num_envs))[:: count(1, EACH)]
    assert len({int(lift.episodes.scene[row]) for row in rows}) == len(SCENES)
    played = play(lift, rows, steps)
    seen, _ = in_turn(lift)
    first = np.array([p["seen"][0] for p in played])
    np.testing.assert_allclose(seen.numpy()[rows], first, atol=2e-3)
    found: dict[str, list[np.ndarray]] = {"seen": [], "rewards": [], "success": []}
    for k in range(steps):
        actions = torch.zeros(lift.num_envs, 5)
        actions[rows] = torch.tensor(np.array([p["actions"][k] for p in played]))
        seen, rewards, terminated, truncated, infos = lift.step(actions)
        assert not (terminated.any() or truncated.any() or infos["failed"].any())
        for key, value in (("seen", seen), ("rewards", rewards), ("success", infos["success"])):
            found[key].append(value.numpy()[rows])
    wanted = {key: np.array([p[key] for p in played]) for key in found}
    got = {key: np.array(values).swapaxes(0, 1) for key, values in found.items()}
    assert wanted["success"].any(1).all(), "the expert lifts all of them"
    assert (got["success"].any(1) == wanted["success"].any(1)).all()
    assert np.median(np.abs(got["rewards"] - wanted["rewards"])) < 1e-4
    robot = np.abs(got["seen"][:, :, :31] - wanted["seen"][:, 1:, :31])
    assert np.median(robot) < 1e-5 and np.quantile(robot, 0.99) < 0.02
    slots = lift.episodes.goals.target[rows, 0]
    ends = lift.world.state.slot_pos[rows, slots].numpy()
    off = np.linalg.norm(ends - np.array([p["target"] for p in played]), axis=1)
    assert np.median(off) < 1e-4, f"{1000 * off} mm"


def test_an_episode_that_ends_is_followed_by_another_within_the_step() -> None:
    env = batch(3, max_episode_steps=2)
    assert env.metadata["autoreset_mode"] == AutoresetMode.SAME_STEP
    env.reset(seed=1)
    still = torch.zeros(3, 5)
    _, _, _, truncated, infos = env.step(still)
    assert not truncated.any() and "final_obs" not in infos
    seen, _, terminated, truncated, infos = env.step(still)
    assert truncated.all() and not terminated.any()
    assert infos["_final_obs"].all() and infos["final_obs"].shape == seen.shape
    assert not torch.equal(infos["final_obs"], seen)
    assert infos["_final_info"].all()
    assert not torch.equal(infos["final_info"]["episode_row"], infos["episode_row"])
    begun = env._row.clone()
    again, _ = env.reset(options={"episodes": begun})
    assert torch.equal(seen, again), "what follows is that episode's start"


def test_episodes_are_drawn_by_the_seed(lift: TabletopBatchEnv) -> None:
    def rows(seed: int) -> list[int]:
        return lift.reset(seed=seed)[1]["episode_row"].tolist()

    assert rows(3) == rows(3) and len({tuple(rows(k)) for k in range(5)}) > 1


def test_some_worlds_are_reset_and_the_others_go_on(lift: TabletopBatchEnv) -> None:
    in_turn(lift)
    for _ in range(3):
        seen = lift.step(torch.ones(4, 5))[0]
    mask = torch.tensor([False, True, False, True])
    again = lift.reset(options={"reset_mask": mask})[0]
    assert torch.equal(again[~mask], seen[~mask])
    assert not torch.equal(again[mask], seen[mask])


def test_a_world_that_fails_is_told_counted_and_begun_anew(lift: TabletopBatchEnv) -> None:
    in_turn(lift)
    still = torch.zeros(4, 5)
    calm = [lift.step(still)[0].clone() for _ in range(2)]
    in_turn(lift)
    before = lift.failures
    lift.step(still)
    lift.world.state.qvel[1] = torch.nan
    seen, rewards, _, truncated, infos = lift.step(still)
    assert infos["final_info"]["failed"].tolist() == truncated.tolist()
    assert truncated.tolist() == [False, True, False, False] and not infos["failed"].any()
    assert lift.failures == before + 1 and rewards[1] == 0
    assert torch.isfinite(seen).all() and torch.equal(infos["final_obs"][1], calm[0][1])
    others = [0, 2, 3]
    assert torch.equal(infos["final_obs"][others], seen[others])
    assert torch.equal(seen[others], calm[1][others]), "the others go on to the bit"
    assert not lift.step(still)[4]["failed"].any()


def test_failing_is_not_rewarded_like_success() -> None:
    env = batch(2, reward="sparse", observation="goal")
    env.reset(seed=0)
    env.world.state.qvel[0] = torch.nan
    _, rewards, _, _, infos = env.step(torch.zeros(2, 5))
    assert rewards.tolist() == [-1.0, -1.0] and infos["_final_info"].tolist() == [True, False]
    assert not infos["final_info"]["success"].any()


@pytest.mark.parametrize(
    "options",
    [
        {"episodes": [-1, 0, 0, 0]},
        {"episodes": [0.0, 1.0, 0.0, 0.0]},
        {"episodes": [0, 0]},
        {"episodes": [0, 0, 0, 99]},
        {"episodes": "all"},
        {"steps": 5},
        {"steps": [-5, 0, 0, 0]},
        {"steps": [0, 0, 0, 10**6]},
        {"steps": [True, False, True, False]},
        {"reset_mask": "all"},
    ],
)
def test_options_out_of_range_are_refused_before_anything_moves(
    lift: TabletopBatchEnv, options: dict
) -> None:
    rows = lift.reset(seed=1)[1]["episode_row"]
    with pytest.raises(InputError, match=next(iter(options))):
        lift.reset(seed=2, options=options)
    assert torch.equal(lift.step(torch.zeros(4, 5))[4]["episode_row"], rows)


def test_all_worlds_are_reset_before_some() -> None:
    with pytest.raises(InputError, match="Reset all worlds"):
        batch(2).reset(options={"reset_mask": [True, False]})


def test_a_task_of_your_own_has_the_limit_of_what_it_is_made_from() -> None:
    class NearReach(Reach):
        pass

    class Sorting(Tidy):
        pass

    Alone = type("Alone", (Task,), dict.fromkeys(Task.__abstractmethods__))
    assert time_limit(NearReach()) == STEPS["Reach"] and time_limit(Sorting()) == STEPS["Tidy"]
    with pytest.raises(InputError, match="max_episode_steps"):
        time_limit(Alone())


def test_statistics_of_gymnasium_count_episodes() -> None:
    env = RecordEpisodeStatistics(
        ArrayConversion(batch(2, max_episode_steps=2), env_xp=torch, target_xp=np)
    )
    env.reset(seed=0)
    still = np.zeros((2, 5), np.float32)
    env.step(still)
    infos = env.step(still)[4]
    assert infos["episode"]["l"].tolist() == [2, 2] and env.episode_count == 2


def test_goal_observations_follow_the_task() -> None:
    env = batch(2, observation="goal", reward="sparse", task="PickPlace")
    seen, _ = env.reset(seed=0)
    assert {k: tuple(v.shape) for k, v in seen.items()} == {
        "observation": (2, 268), "achieved_goal": (2, 8), "desired_goal": (2, 8),
    }  # fmt: skip
    seen, reward, *_ = env.step(torch.zeros(2, 5))
    assert reward.tolist() == [-1.0, -1.0]
    for key, value in seen.items():
        assert env.observation_space[key].contains(value.numpy()), key


def test_a_wrapper_of_gymnasium_turns_it_into_numpy(lift: TabletopBatchEnv) -> None:
    env = ArrayConversion(lift, env_xp=torch, target_xp=np)
    seen, _ = env.reset(seed=0)
    assert isinstance(seen, np.ndarray) and env.observation_space.contains(seen)
    _, reward, *_ = env.step(env.action_space.sample())
    assert isinstance(reward, np.ndarray) and reward.shape == (4,)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"num_envs": 0}, "num_envs"),
        ({"device": "cuda"}, "CUDA"),
        ({"observation": "point_cloud"}, "observation='state' or 'goal' or 'pixels'"),
        ({"observation": "pixels", "kinds": ["rgb", "depth"]}, "RGB only"),
        ({"grasp_hint": True}, "grasp hint"),
        ({"randomization": "strong"}, "supports only"),
        ({"render_mode": "rgb_array"}, "render"),
        ({"max_objects": 1}, "max_objects"),
    ],
)
def test_what_a_batch_cannot_is_refused_in_one_line(change, message) -> None:
    if change.get("device") == "cuda" and torch.cuda.is_available():
        pytest.skip("there is a CUDA device")
    given = {"num_envs": 1, "scenes": SCENES, "task": "Lift", "device": "cpu", **change}
    with pytest.raises((InputError, SceneError), match=re.escape(message)) as caught:
        TabletopBatchEnv(given.pop("num_envs"), given.pop("scenes"), **given)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("name", ["scenes", "episodes", "max_parts", "workers"])
def test_a_deck_needs_whole_numbers_above_zero(name: str) -> None:
    with pytest.raises(InputError, match=name):
        DeckConfig(**{name: 0})


def test_actions_are_checked_before_anything_moves(lift: TabletopBatchEnv) -> None:
    in_turn(lift)
    before = lift.world.state.qpos.clone()
    wrong = torch.zeros(4, 5)
    wrong[2, 1] = torch.nan
    with pytest.raises(InputError, match=r"those of the worlds \[2\]"):
        lift.step(wrong)
    with pytest.raises(InputError, match=r"shape \(4, 5\)"):
        lift.step(torch.zeros(3, 5))
    with pytest.raises(InputError, match="reset_mask"):
        lift.reset(options={"reset_mask": torch.zeros(4, dtype=torch.bool)})
    with pytest.raises(InputError, match="'colour'"):
        lift.reset(options={"colour": 1})
    assert torch.equal(before, lift.world.state.qpos)


def test_other_scenes_are_made_in_a_process_and_swapped_in() -> None:
    env = batch(2, max_episode_steps=50)
    shape, before = env.bank.union.shape, env.episodes
    with pytest.raises(InputError, match="prepare"):
        env.swap()
    env.prepare(seed=5)
    assert env.swap(wait=True) and env.bank.union.shape == shape
    assert env.bank.scenes and env.episodes.seeds != before.seeds
    with pytest.raises(InputError, match="reset"):
        env.step(torch.zeros(2, 5))
    env.reset(seed=0)
    seen, *_, infos = env.step(torch.zeros(2, 5))
    assert torch.isfinite(seen).all() and not infos["failed"].any()
    env.prepare(seed=6)
    env.close()
    env.close()


def test_scenes_without_anything_to_do_are_named() -> None:
    with pytest.raises(InputError, match="had no valid task, for example 'vanity'"):
        TabletopBatchEnv(1, "vanity", task="Tidy", device="cpu")
