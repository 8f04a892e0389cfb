"""The policy with height maps: its attention, its paths, and its training."""

import math
import os
import signal
from pathlib import Path

import gymnasium as gym
import mujoco
import numpy as np
import pytest
import torch
from gymnasium import spaces
from toy import toy_scene

from generator.errors import BundleError, InputError
from generator.geometry import rotation_z
from tabletopgen_env.actions import EE_TURN
from tabletopgen_env.detection.model import loss_of
from tabletopgen_env.detection.network import PLACES, TURNS
from tabletopgen_env.env import make_env
from tabletopgen_env.expert.arm import least_turn
from tabletopgen_env.expert.planning.placement import unturned_place
from tabletopgen_env.expert.run import TaskExpert
from tabletopgen_env.learning.demonstrations.demos import read_showings, showing, write_showings
from tabletopgen_env.learning.demonstrations.grasp_lessons import (
    SEEN_TURNS,
    batch_of,
    found_share,
    some_turns,
    teach_head,
)
from tabletopgen_env.learning.demonstrations.recorded import PATIENCE, demonstrate
from tabletopgen_env.learning.demonstrations.teacher import Teacher, plan_in_heading
from tabletopgen_env.learning.networks.grasp_head import GraspHead, turn_easily, turn_maps
from tabletopgen_env.learning.networks.look_extractor import (
    LookExtractor,
    at_goal,
    base_from_target,
    is_held,
    ways,
)
from tabletopgen_env.learning.policies import load_policy
from tabletopgen_env.learning.progress import TrainingPlan
from tabletopgen_env.learning.recipes import Recipe
from tabletopgen_env.learning.runs import BEST, LATEST, open_run
from tabletopgen_env.learning.training import train
from tabletopgen_env.observations.grasp_hint import GraspHint
from tabletopgen_env.observations.height_map import CELL, CELLS, STEP, HeightLook

LOOK = {"network": {"extractor": "look", "layers": [16], "width": 8},
        "env": {"geometry": "height_map"}, "task": "Lift"}  # fmt: skip
CLONING = {"rounds": 2, "episodes": 2, "steps": 10, "last_steps": 10, "batch": 32,
           "tables": 1, "head_steps": 2}  # fmt: skip
QUICK = TrainingPlan(episodes=1)


def blob(x: float, y: float, height: float = 0.06) -> torch.Tensor:
    """Return maps with a small block at a position in the heading frame, metres."""
    maps = torch.zeros(1, 3, CELLS, CELLS)
    i, j = (round(at / CELL + (CELLS - 1) / 2) for at in (x, y))
    maps[0, 0, i - 1 : i + 2, j - 1 : j + 2] = height / STEP
    return maps


@pytest.mark.parametrize("turn", [0, 3, 6, 11])
def test_the_head_sees_maps_turned_to_the_fingers(turn: int) -> None:
    x, y = 0.05, -0.03
    views, _ = turn_maps(blob(x, y), torch.tensor([[-0.5, 0.0, 0.0, 0.0]]))
    angle = turn * math.pi / TURNS
    along, across = (
        x * math.cos(angle) + y * math.sin(angle),
        y * math.cos(angle) - x * math.sin(angle),
    )
    where = torch.nonzero(views[0, turn, 0] > 0.5).float().mean(0)
    expected = torch.tensor([along, across]) / CELL + (CELLS - 1) / 2
    assert torch.allclose(where, expected, atol=1.0)
    assert views[0, turn, 2].max() < 1e-5 and views[0, turn, 2].min() < 0  # below the top


def test_the_head_sees_where_the_arm_comes_from() -> None:
    _, sides = turn_maps(blob(0, 0), torch.tensor([[0.0, 0.6, 0.05, 0.1]]))
    assert torch.allclose(sides[0, 0, :2], torch.tensor([0.0, 1.0]), atol=1e-6)
    quarter = sides[0, TURNS // 2, :2]  # the fingers open towards the base
    assert torch.allclose(quarter, torch.tensor([1.0, 0.0]), atol=1e-6)
    assert sides[0, :, 4].tolist() == pytest.approx([1.0] * TURNS)


def test_heights_are_above_the_targets_lowest_point() -> None:
    low = 0.04
    raised = blob(0.0, 0.0, 0.06 + low)
    raised[0, 1] = low / STEP  # the tray below
    one = turn_maps(raised, torch.tensor([[-0.5, 0.0, low, 0.0]]))[0]
    two = turn_maps(blob(0.0, 0.0), torch.tensor([[-0.5, 0.0, 0.0, 0.0]]))[0]
    assert torch.allclose(one, two, atol=1e-5)


def taught(task: str, options: dict, steps: int):
    """Yield state, path of the hint's grasp and the hint's entries, while the expert works."""
    env = make_env(toy_scene(), task=task, grasp_hint="planned")
    env.hint = GraspHint("planned", unturned_place)
    seen, _ = env.reset(seed=0, options=options)
    expert, look = TaskExpert(env), HeightLook()
    expert.reset()
    for _ in range(steps):
        world, name = env.world, options["target"]
        plan = env.hint.plan(world, name)
        assert plan is not None
        maps = torch.from_numpy(look.maps(world, env.goal))[None]
        state = torch.from_numpy(seen[None, :279])
        given = torch.from_numpy(plan_in_heading(world, state[0], plan))[None].float()
        yield expert.phase, state, ways(state, maps, given)[0].numpy(), seen[279:]
        seen = env.step(expert.act())[0]


@pytest.mark.parametrize(
    ("task", "options"),
    [("Lift", {"target": "mug_1"}), ("PickPlace", {"target": "cube_1", "goal": "bowl_1"})],
)
def test_the_way_of_a_grasp_is_what_a_hint_of_it_says(task: str, options: dict) -> None:
    compared = set()
    for phase, state, way, hint in taught(task, options, 70):
        if phase in ("approach", "descend"):
            assert np.allclose(way, hint, atol=0.004)
        elif phase in ("lift", "carry", "lower") and is_held(state)[0] and hint[7] < 0:
            if phase == "lift" and task == "PickPlace":
                continue  # the hint has no place yet, and leads up
            assert np.allclose(way[:2], hint[:2], atol=0.004) and way[7] == -1
            assert way[2] == pytest.approx(hint[2], abs=0.012)
            assert way[6] == pytest.approx(hint[6], abs=0.006)
        else:
            continue
        compared.add(phase)
    assert {"approach", "descend", "lift" if task == "Lift" else "carry"} <= compared


def test_however_a_learner_turns_the_hand_the_teacher_has_it_let_go() -> None:
    """The teacher's action follows from the observation: it has no yaw to return to."""
    env = make_env(toy_scene(), task="PickPlace", geometry="height_map")
    seen, _ = env.reset(seed=0, options={"target": "cube_1", "goal": "bowl_1"})
    teacher = Teacher(env)
    teacher.see(seen)
    expert = TaskExpert(teacher, PATIENCE)
    expert.reset()
    turned, solved = 0.0, False
    for _ in range(200):
        action = expert.act()
        if expert.phase in ("carry", "lower") and turned < 0.4:
            assert abs(action[3]) < 1e-3
            action[3] = 0.4
            turned += 0.4 * EE_TURN
        seen, *_, info = env.step(action)
        way = teacher.see(seen)[-8:]
        if teacher.hint.drop is not None and is_held(torch.from_numpy(seen["state"])[None])[0]:
            assert way[3] == pytest.approx(teacher.hint.drop.turn(env.world), abs=1e-3)
        solved = solved or info["success"]
    assert solved and turned >= 0.4


@pytest.mark.parametrize(("bearing", "turn"), [(0.0, 0.0), (-0.3, 0.0), (0.3, 0.2 + 0.1 - 0.0973)])
def test_the_hand_turns_with_what_it_holds_only_for_the_last_joint(
    bearing: float, turn: float
) -> None:
    """The last joint, at 2.7 of 2.8973 rad, may move by 0.0973: a tenth of the range is
    reserved."""
    env = make_env(toy_scene(), task="Lift")
    env.reset(seed=0, options={"target": "cube_1"})
    world = env.world
    world.data.qpos[world.arm_qpos[6]] = 2.7
    mujoco.mj_kinematics(world.model, world.data)
    tool = world.to_base(world.data.site_xpos[world.tcp])
    there = world.to_world(rotation_z(bearing) @ tool)
    assert least_turn(world, there) == pytest.approx(turn, abs=1e-3)


def test_where_the_target_lies_let_go_in_its_goal_there_is_no_way() -> None:
    env = make_env(toy_scene(), task="PickPlace", geometry="height_map")
    seen, _ = env.reset(seed=0, options={"target": "cube_1", "goal": "bowl_1"})
    state = torch.from_numpy(seen["state"])[None]
    assert not at_goal(state)[0]
    bowl = env.world.position("bowl_1")
    env.world.teleport("cube_1", bowl)
    seen = env.step(np.zeros(5))[0]
    state, maps = (torch.from_numpy(seen[k])[None] for k in ("state", "height_map"))
    assert at_goal(state)[0] and not ways(state, maps, torch.ones(1, 6)).any()


def extractor(env: gym.Env) -> LookExtractor:
    torch.manual_seed(0)
    assert isinstance(env.observation_space, spaces.Dict)
    return LookExtractor(env.observation_space, 8)


def test_a_look_does_not_depend_on_the_one_before_or_on_its_batch() -> None:
    env = make_env(toy_scene(), task="Lift", geometry="height_map")
    seen = [env.reset(seed=0, options={"target": name})[0] for name in ("cube_1", "mug_1", "can_1")]
    batch = {k: torch.from_numpy(np.stack([one[k] for one in seen])).float() for k in seen[0]}
    network = extractor(env)
    together = network(batch)
    for row in (0, 0, 2, 1):
        one = network({k: part[row : row + 1] for k, part in batch.items()})
        assert torch.allclose(one[0], together[row], atol=2e-2)
    assert not torch.allclose(together[0], together[1])
    before = network({k: part[:1] for k, part in batch.items()})
    network.load_state_dict(network.state_dict())
    with torch.no_grad():
        network.state_dict()["head.layers.5.bias"][4] += 0.5  # other heights
    network.double().float()  # weights have changed: nothing is remembered
    assert not torch.allclose(before, network({k: part[:1] for k, part in batch.items()}))


def test_half_turns_are_those_that_the_arm_makes_easily() -> None:
    stands = torch.tensor([[-0.5, 0.0, 0.0, 0.0]]).repeat(24, 1)
    angle = torch.arange(24) * math.pi / 12 + 0.01
    zeros = torch.zeros(24)
    turned = turn_easily(zeros, zeros, angle, stands)
    assert torch.allclose((turned - angle).remainder(math.pi).minimum(
        math.pi - (turned - angle).remainder(math.pi)), zeros, atol=1e-5)  # fmt: skip
    assert torch.allclose(turned[:12].sin(), turned[12:].sin(), atol=1e-5)


def test_other_observations_are_refused() -> None:
    with pytest.raises(InputError, match="geometry='height_map'"):
        LookExtractor(spaces.Dict({"state": spaces.Box(-1, 1, (7,))}))


def shown(names=("cube_1", "can_1", "mug_1")) -> list:
    world = make_env(toy_scene(), task="Lift")
    world.reset(seed=0)
    found = [showing(world.world, name, HeightLook()) for name in names]
    assert all(one is not None for one in found)
    return found


def test_showings_come_back_from_their_file(tmp_path: Path) -> None:
    made, path = shown(), tmp_path / "showings-000.npz"
    write_showings(made, path)
    for one, other in zip(made, read_showings(path), strict=True):
        assert np.array_equal(one.maps, other.maps) and np.array_equal(one.grasps, other.grasps)
        assert np.array_equal(one.stands, other.stands)
    path.write_bytes(path.read_bytes()[:-200])
    with pytest.raises(BundleError, match="showings"):
        read_showings(path)


def test_what_is_shown_is_what_the_policy_sees() -> None:
    env = make_env(toy_scene(), task="Lift", geometry="height_map")
    seen, _ = env.reset(seed=0, options={"target": "mug_1"})
    one = shown(["mug_1"])[0]
    assert np.array_equal(one.maps, seen["height_map"][:2])
    stands = base_from_target(torch.from_numpy(seen["state"])[None])[0]
    assert torch.allclose(stands, torch.from_numpy(one.stands), atol=1e-3)
    best = one.grasps[0]
    chosen = GraspHint("planned").choose(env.world, "mug_1")
    assert chosen is not None
    plan = plan_in_heading(env.world, torch.from_numpy(seen["state"]), chosen)
    assert np.allclose(best[1:4], plan[:3], atol=1e-4)
    assert (best[0] - plan[3]) % np.pi == pytest.approx(0, abs=1e-3) or (
        best[0] - plan[3]
    ) % np.pi == pytest.approx(np.pi, abs=1e-3)


def test_a_perfect_head_loses_least_and_mirrors_are_consistent() -> None:
    one = shown(["mug_1"])[0]
    for signs in ([1, 1], [-1, 1], [1, -1], [-1, -1]):
        batch, sides = batch_of([one], torch.tensor([signs]))
        best = int(batch.share[0].argmax())
        turn, place = divmod(best, PLACES**2)
        i, j = divmod(place, PLACES)
        along, across, *_ = batch.grasp[0, best].tolist()
        assert abs(along - (i - (PLACES - 1) / 2) * 0.01) <= 0.0051
        assert abs(across - (j - (PLACES - 1) / 2) * 0.01) <= 0.0051
        low, high = max(2 * i - 2, 0), 2 * i + 4
        assert batch.seen[0, turn, 0, low:high, 2 * j - 2 : 2 * j + 4].max() > 0, "on the mug"
        plain = batch_of([one], torch.tensor([[1, 1]]))[1]
        assert torch.allclose(sides[0, :, 0], plain[0, :, 0] * signs[0])
        assert torch.allclose(sides[0, :, 1], plain[0, :, 1] * signs[1])
        assert torch.allclose(sides[0, :, 3], plain[0, :, 3] * signs[0] * signs[1])
        few, some = some_turns(batch, sides, torch.Generator().manual_seed(0))
        assert few.seen.shape[1] == some.shape[1] == SEEN_TURNS
        assert few.share.sum() == pytest.approx(1.0) and few.share.max() >= batch.share.max()
        assert torch.isfinite(loss_of(GraspHead()(few.seen, some), few))


@pytest.mark.slow
def test_a_head_learns_where_the_expert_grasps() -> None:
    made = shown()
    heads = []
    for _ in range(2):
        torch.manual_seed(0)
        head = GraspHead()
        before = found_share(head, made)
        teach_head(head, made, 10, torch.Generator().manual_seed(0), size=4)
        heads.append(head)
    assert all(
        torch.equal(a, b) for a, b in zip(heads[0].parameters(), heads[1].parameters(), strict=True)
    )
    teach_head(head, made, 140, torch.Generator().manual_seed(0), size=4)
    assert before < 0.5 and found_share(head, made) == 1.0


@pytest.mark.slow
def test_the_teacher_shows_the_way_and_the_environment_does_not() -> None:
    bare = make_env(toy_scene(), task="Lift", geometry="height_map")
    seen = demonstrate(gym.wrappers.TimeLimit(bare, 80), seed=3, taught=True)
    assert seen is not None and seen.solved
    assert seen.observations.shape[1] == 279 + 8 and bare.hint is None
    assert seen.observations[0, -1] == 1 and seen.observations[-1, -1] == -1


def look(small, **changes) -> Recipe:
    return small("clone", **{**LOOK, "cloning": CLONING, **changes})


@pytest.mark.slow
@pytest.mark.usefixtures("brief")
def test_a_policy_that_looks_is_trained_saved_and_played(small, folder: Path) -> None:
    told: list[str] = []
    done = train(look(small), folder, QUICK, say=told.append)
    assert not done.interrupted and len(open_run(folder).rows()) == 2
    assert any("grasp demonstrations for" in line for line in told)
    assert any("head: 2" in line for line in told)
    assert not (folder / "cloning").exists()
    policy = load_policy(folder / LATEST)
    assert policy.card.inputs == {"height_map": (3, CELLS, CELLS), "state": 279}
    env = make_env(toy_scene(), task=policy.card.task, **policy.card.env)
    seen, _ = env.reset(seed=0)
    action, _ = policy.predict(seen)
    assert env.action_space.contains(action)
    twice = {k: np.stack([part, part]) for k, part in seen.items()}
    assert np.allclose(policy.predict(twice)[0], action, atol=0.02)
    with pytest.raises(InputError, match="shape"):
        policy.predict({**seen, "height_map": seen["height_map"][:2]})
    assert load_policy(folder / BEST).card.inputs == policy.card.inputs


@pytest.mark.slow
@pytest.mark.usefixtures("brief")
@pytest.mark.parametrize("recipe", ["look", "plain"])
def test_cloning_that_was_cut_off_ends_in_the_same_weights(
    small, tmp_path: Path, recipe: str
) -> None:
    def interrupt(line: str) -> None:
        if "held-out" in line:
            os.kill(os.getpid(), signal.SIGINT)

    wanted = look(small) if recipe == "look" else small("clone", cloning={**CLONING})
    whole, cut = tmp_path / "whole", tmp_path / "cut"
    train(wanted, whole, QUICK, say=lambda _: None)
    assert train(wanted, cut, QUICK, say=interrupt).interrupted
    assert len(open_run(cut).rows()) == 1 and (cut / "cloning").is_dir()
    done = train(wanted, cut, QUICK, True, lambda _: None)
    assert not done.interrupted
    assert (cut / LATEST).read_bytes() == (whole / LATEST).read_bytes()
    assert [r.steps for r in open_run(cut).rows()] == [r.steps for r in open_run(whole).rows()]
    told: list[str] = []
    train(wanted, cut, QUICK, True, told.append)
    assert any("already complete" in line for line in told)


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({"env": {}}, "require each other"),
        ({"network": {"layers": [8]}}, "require each other"),
        ({"env": {"geometry": "height_map", "grasp_hint": "planned"}}, "without a grasp hint"),
        ({"env": {"geometry": "height_map", "observation": "pixels+state"}}, "state"),
    ],
)
def test_recipes_that_do_not_go_together_are_refused(small, changes: dict, why: str) -> None:
    with pytest.raises(InputError, match=why):
        look(small, **changes)
