"""The policy with pictures: its features, its training, and its file."""

from dataclasses import replace

import numpy as np
import pytest
import torch
from toy import toy_object, toy_scene

from generator.errors import InputError
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.expert.run import TaskExpert
from tabletopgen_env.learning.demonstrations.teacher import Teacher
from tabletopgen_env.learning.evaluation import EpisodePlayer
from tabletopgen_env.learning.networks.look_extractor import heading_of, is_held, lowest_of
from tabletopgen_env.learning.networks.perception import (
    STATE,
    box_of,
    cameras_of,
    find_ball,
    height_grid,
    is_robot,
    perceive,
    recall_goal,
    table_height,
)
from tabletopgen_env.learning.networks.sight_extractor import MEMORY, SightExtractor
from tabletopgen_env.learning.policies import load_policy
from tabletopgen_env.learning.progress import TrainingPlan
from tabletopgen_env.learning.recipes import Network, Recipe, recipe
from tabletopgen_env.learning.runs import LATEST
from tabletopgen_env.learning.training import train
from tabletopgen_env.observations.height_map import CELL

SEEING = {
    "observation": "pixels+proprio", "cameras": ("top", "front", "wrist"), "kinds": ("depth",),
    "image_size": {"top": 192, "front": 128, "wrist": 64}, "target_mark": "mask",
    "calibration": True, "instruction": "none",
}  # fmt: skip
CLONING = {"rounds": 2, "episodes": 1, "steps": 5, "last_steps": 5, "batch": 16, "tables": 1,
           "head_steps": 0, "head_start": "detector"}  # fmt: skip


def batch(seen: dict) -> dict[str, torch.Tensor]:
    return {name: torch.from_numpy(part)[None] for name, part in seen.items()}


def seeing(target: str, task: str = "Lift", **more) -> tuple[TabletopEnv, dict]:
    env = make_env(toy_scene(), task=task, **{**SEEING, **more})
    return env, env.reset(seed=0, options={"target": target} if target else None)[0]


@pytest.mark.parametrize("target", ["cube_1", "mug_1", "can_1"])
def test_the_estimate_is_near_what_is(target: str) -> None:
    env, seen = seeing(target)
    states, maps, shown = perceive(batch(seen))
    state, world = states[0].numpy(), env.world
    assert states.shape == (1, STATE) and maps.shape == (1, 3, 48, 48) and shown == 0
    height = world.scene.table.height - world.base_position[2]
    assert state[37] == pytest.approx(height, abs=0.002)
    center = world.to_base(world.position(target))
    assert np.allclose(state[40:43], center, atol=0.012)
    assert np.allclose(state[34:37], state[40:43] - state[15:18])
    assert float(lowest_of(states)[0]) == pytest.approx(height, abs=0.002)
    assert float(heading_of(states)[0]) == 0.0
    top = 0.002 * float(maps[0, 0].max()) + state[37]
    half = world.half_extent[world.index(target)]
    assert top == pytest.approx(center[2] + half[2], abs=0.008)
    middle = torch.nonzero(maps[0, 0] > 0).float().mean(0).numpy()
    assert np.abs(middle - 23.5).max() < 3  # in the middle of its map
    region = state[268:279]
    goal = world.to_base(env.goal.region(world).center)
    assert np.allclose(region[1:4], goal, atol=0.015)


def test_neighbours_are_in_the_second_map_and_the_arm_is_not() -> None:
    things = {o.name: o for o in toy_scene().objects}
    cube = things["cube_1"]
    x, y = cube.pose.position[:2]
    can = toy_object("can_1", (0.05, 0.05, 0.09), (x + 0.08, y))
    highest = []
    for others in ((can,), ()):
        env = make_env(toy_scene((cube, *others)), task="Lift", **SEEING)
        seen = env.reset(seed=0, options={"target": "cube_1"})[0]
        highest.append(float(perceive(batch(seen))[1][0, 1].max()))
    assert highest[0] == pytest.approx(0.09 / 0.002, abs=5) and highest[1] == 0


def test_a_target_that_is_not_seen_gives_a_finite_state() -> None:
    _, seen = seeing("cube_1")
    for camera in ("top", "front", "wrist"):
        seen[f"{camera}_target"][:] = 0
    state, maps, _ = perceive(batch(seen))
    assert torch.isfinite(state).all() and not maps.any() and state[0, 58] == 0


def test_a_marked_point_is_found_by_its_colour() -> None:
    env, seen = seeing("", "Reach", kinds=("rgb", "depth"), cameras=("top", "front"),
                       image_size=128)  # fmt: skip
    states, _, shown = perceive(batch(seen))
    state = states[0].numpy()
    point = env.world.to_base(env.goal.region(env.world).center)
    assert np.allclose(state[269:272], point, atol=0.002)
    assert np.allclose(state[276:279], point - state[15:18], atol=0.002)
    nothing = {"top": torch.zeros(1, 128, 128, 3), "front": torch.zeros(1, 128, 128, 3)}
    unseen, _, hidden = perceive({**batch(seen), **nothing})
    assert unseen[0, 272] == 0 == hidden and shown > 8
    _, kept = recall_goal(states, shown, torch.zeros(1, 4))
    again, still = recall_goal(unseen, hidden, kept)
    assert np.allclose(again[0].numpy(), state, atol=1e-6) and torch.equal(still, kept)
    assert torch.equal(recall_goal(unseen, hidden, torch.zeros(1, 4))[0], unseen)
    worse = states.clone()
    worse[0, 269:272] += 0.03
    assert np.allclose(recall_goal(worse, shown / 2, kept)[0][0].numpy(), state, atol=1e-6)
    assert torch.equal(recall_goal(worse, shown, kept)[0], worse), "seen as well as before"
    moved = {**seen, "top": np.moveaxis(seen["top"], -1, 0).copy()}  # as SB3 turns pictures
    assert np.allclose(perceive(batch(moved))[0][0].numpy(), state)


def test_the_marker_is_the_ball_among_what_has_its_colour() -> None:
    turn = torch.linspace(0, 6, 40)
    side = torch.stack([turn.cos(), turn.sin(), 1 + 0 * turn], 1) / 2**0.5
    middle = torch.tensor([0.4, -0.1, 0.3])
    ball = middle + 0.02 * side
    flat = torch.cat([0.3 * torch.rand(300, 2), torch.full((300, 1), 0.1)], 1)
    for points in (ball, ball[:20], torch.cat([flat, ball])):
        found, count = find_ball(points)
        assert count >= 20 and torch.allclose(found, middle, atol=1e-3)
    assert find_ball(points[:0])[1] == 0 == find_ball(flat[:2])[1]


@pytest.mark.slow
def test_what_is_held_is_felt() -> None:
    env, seen = seeing("cube_1")
    expert, felt = TaskExpert(env), []
    expert.reset()
    for _ in range(60):
        state = perceive(batch(seen))[0]
        left, right, _ = env.world.touches("cube_1")
        felt.append((bool(is_held(state)[0]), left and right))
        seen = env.step(expert.act())[0]
    guessed, true = np.array(felt).T
    assert true.sum() > 10 and (guessed == true).mean() > 0.9 and guessed[-1]


def test_the_teachers_way_leads_to_its_grasp_whatever_is_seen() -> None:
    env, seen = seeing("cube_1")
    teacher = Teacher(env)
    kept = teacher.see(seen)
    plan = teacher.hint.plan(env.world, "cube_1")
    assert plan is not None and kept.shape == (STATE + 8,)
    point = env.world.to_base(plan.grasp.point)
    assert np.allclose(kept[STATE : STATE + 3] + kept[15:18], point, atol=1e-4)
    assert kept[-1] == 1


def test_without_a_target_the_way_is_the_teachers() -> None:
    env, seen = seeing("", "Reach", kinds=("rgb", "depth"), cameras=("top", "front"),
                       image_size=128)  # fmt: skip
    extractor = SightExtractor(env.observation_space)  # type: ignore[arg-type]
    shown = torch.from_numpy(Teacher(env).see(seen))[None]
    assert torch.equal(extractor(batch(seen)), extractor.table(shown))


def test_parts_do_what_they_say() -> None:
    felt = torch.zeros(33)
    felt[15:18] = torch.tensor([0.5, 0.0, 0.3])
    felt[18], felt[22] = 1.0, -1.0  # the hand looks down
    points = torch.tensor([[0.5, 0.1, 0.4], [0.5, 0.0, 0.2], [0.9, 0.9, 0.45], [0.7, 0.0, 0.1]])
    assert is_robot(points, felt).tolist() == [True, False, True, False]
    flat = torch.rand(200, 3) * torch.tensor([1.0, 1.0, 0.001]) + torch.tensor([0, 0, 0.1195])
    assert float(table_height(torch.cat([flat, points]))) == pytest.approx(0.12, abs=0.002)
    assert float(table_height(points[:0])) == 0
    middle, half = box_of(points[1:2].repeat(9, 1), torch.tensor(0.19))
    assert float(middle[2] - half[2]) == pytest.approx(0.19, abs=1e-6) and (half >= 0.003).all()
    grid = height_grid(torch.tensor([[0.5 + 3.5 * CELL, 0.0, 0.1]]), points[1], torch.tensor(0.0))
    assert torch.nonzero(grid).tolist() == [[27, 24]] and grid.max() == 50


def test_a_grasp_is_remembered_until_the_target_moves() -> None:
    env, seen = seeing("mug_1")
    extractor = SightExtractor(env.observation_space)  # type: ignore[arg-type]
    parts, nothing = batch(seen), torch.zeros(1, MEMORY)
    first, memory = extractor.recall(parts, nothing)
    assert torch.equal(extractor(parts), first) and memory[0, 0] == 1 and memory[0, 1] == 0
    over = parts["proprio"].clone()
    over[0, 15:17] = memory[0, 5:7]  # the hand over the grasp
    here = {**parts, "proprio": over}
    _, kept = extractor.recall(here, memory)
    assert kept[0, 1] == 1 and torch.equal(kept[0, 2:], memory[0, 2:])
    forgotten = [("moved", 2, 0.1), ("old", 1, 60.0), ("far", 5, 0.2)]
    for why, entry, by in forgotten:
        other = memory.clone()
        other[0, entry] += by
        assert extractor.recall(here, other)[1][0, 1] == 0, why


@pytest.mark.slow
@pytest.mark.usefixtures("brief")
def test_policies_hand_on_what_they_remember(tmp_path) -> None:
    own = replace(recipe("lift-sight"), scenes="coffee-square", held_out="office-desk",
                  cloning={**CLONING, "rounds": 1},
                  network=Network("sight", (16,), 8))  # fmt: skip
    out = train(own, tmp_path / "run", TrainingPlan(episodes=1), say=lambda _: None).run
    policy = load_policy(out.path / LATEST)
    env = make_env("office-desk", task="Lift", **own.env)
    seen, _ = env.reset(seed=3)
    _, memory = policy.predict(seen)
    assert memory.shape == (1, MEMORY) and memory[0, 0] == 1
    both = {name: np.stack([part, part]) for name, part in seen.items()}
    kept = np.repeat(memory, 2, 0)
    kept[:, 1] = 9
    actions, after = policy.predict(both, kept, np.array([True, False]))
    assert actions.shape == (2, 5) and after[0, 1] == 0
    player = EpisodePlayer(policy)
    for _ in range(3):
        seen = env.step(player.act(seen))[0]
    with pytest.raises(InputError, match="must be finite numbers"):
        policy.predict(seen, np.zeros((2, 3)))


def test_what_it_needs_is_said() -> None:
    env = make_env(toy_scene(), task="Lift", observation="pixels+proprio", image_size=16,
                   instruction="none")  # fmt: skip
    with pytest.raises(InputError, match="target_mark='mask', calibration=True"):
        SightExtractor(env.observation_space)  # type: ignore[arg-type]
    assert cameras_of(["top", "top_depth", "top_target", "top_calibration", "front"]) == ("top",)
    with pytest.raises(InputError, match=r"'sight' needs observation='pixels\+proprio'"):
        Recipe("x", "Lift", "sac", network=Network("sight"))


@pytest.mark.slow
@pytest.mark.usefixtures("brief")
@pytest.mark.parametrize("name", ["lift-sight", "reach-sight"])
def test_the_recipes_train_and_their_files_act(name: str, tmp_path) -> None:
    own = recipe(name)
    own = replace(own, scenes="coffee-square", held_out="office-desk", cloning=CLONING,
                  network=replace(own.network, layers=(16,), width=8))  # fmt: skip
    out = train(own, tmp_path / "run", TrainingPlan(episodes=1), say=lambda _: None).run
    policy = load_policy(out.path / LATEST)
    env = make_env("office-desk", task=own.task, **own.env)
    seen, _ = env.reset(seed=3)
    action = policy.predict(seen)[0]
    assert action.shape == (5,) and np.isfinite(action).all()
    assert np.array_equal(action, load_policy(out.path / LATEST).predict(seen)[0])
    assert env.action_space.contains(action)
