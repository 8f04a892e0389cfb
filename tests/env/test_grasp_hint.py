"""The grasp of the target in the state."""

import pickle
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from toy import toy_scene

from generator.errors import InputError, SceneError
from generator.geometry import rotation_z, wrap
from tabletopgen_env.detection.detector import read_detector
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.expert.planning.choice import choose, first_plan
from tabletopgen_env.expert.run import TaskExpert
from tabletopgen_env.observations.grasp_hint import HINT_BOUNDS, GraspHint
from tabletopgen_env.parallel.vector import TabletopVectorEnv
from tabletopgen_env.randomization import Randomization

CUBE = {"target": "cube_1"}


def lift(**settings) -> TabletopEnv:
    return make_env(toy_scene(), **{"task": "Lift", "grasp_hint": True, **settings})


def started(options: dict = CUBE, **settings) -> tuple[TabletopEnv, np.ndarray, TaskExpert]:
    """Return an environment, its first observation, and the expert that starts there."""
    env = lift(**settings)
    seen = env.reset(seed=0, options=options)[0]
    expert = TaskExpert(env)
    expert.reset()
    return env, seen, expert


def assert_shown(seen: np.ndarray, env: TabletopEnv, plan) -> None:
    """The state's hint leads from the tool to the grasp of ``plan``, in the base frame."""
    assert plan is not None
    away = plan.grasp.point - env.world.data.site_xpos[env.world.tcp]
    assert np.allclose(seen[279:282], env.world.base_rotation.T @ away, atol=1e-5)
    assert np.allclose(seen[283:285], [plan.grasp.opening, plan.grasp.width], atol=1e-5)


def test_the_state_ends_with_the_planned_grasp() -> None:
    env = lift()
    seen = env.reset(seed=0, options=CUBE)[0]
    assert seen.shape == env.observation_space.shape == (279 + len(HINT_BOUNDS),)
    assert_shown(seen, env, choose(env.world, "cube_1"))
    assert seen[286] == 1.0
    plain = make_env(toy_scene(), task="Lift").reset(seed=0, options=CUBE)[0]
    assert np.array_equal(seen[:279], plain)


def test_the_hint_leads_to_the_grasp() -> None:
    env, seen, expert = started()
    while expert.phase != "close":
        seen = env.step(expert.act())[0]
    assert np.linalg.norm(seen[279:282]) < 0.01 and abs(seen[282]) < 0.06
    while expert.phase != "lift":
        seen = env.step(expert.act())[0]
    assert seen[14] == pytest.approx(seen[284], abs=0.004)  # the fingers are as far apart as said


def test_the_hint_moves_with_the_object_and_is_planned_anew_where_it_comes_to_rest() -> None:
    env = lift()
    env.reset(seed=0, options=CUBE)
    hint, world = env.hint, env.world
    assert hint is not None
    before = hint.plan(world, "cube_1")
    start = world.position("cube_1")
    turn = np.array([np.cos(0.2), 0, 0, np.sin(0.2)])  # 0.4 rad about the vertical
    world.teleport("cube_1", start + np.array([0.01, 0, 0]), turn)
    carried = hint.plan(world, "cube_1")
    assert before is not None and carried is not None
    assert np.allclose(carried.seen - before.seen, [0.01, 0, 0], atol=1e-9)
    own = [p.grasp.point - p.seen for p in (before, carried)]
    assert np.hypot(*own[0][:2]) == pytest.approx(np.hypot(*own[1][:2]))
    world.teleport("cube_1", start + np.array([-0.03, 0.02, 0]))
    env.step(np.zeros(5))
    there = choose(world, "cube_1")
    anew = hint.plan(world, "cube_1")
    assert there is not None and anew is not None
    assert np.allclose(anew.grasp.point, there.grasp.point, atol=1e-3)


def test_a_hint_has_all_its_attributes_from_the_start() -> None:
    env = lift()
    fresh = set(vars(GraspHint()))
    env.reset(seed=0, options=CUBE)
    assert set(vars(env.hint)) == fresh


def test_plans_of_the_start_are_kept_where_the_base_stands_as_given(monkeypatch) -> None:
    env = lift()
    env.reset(seed=0, options=CUBE)
    kept = first_plan(env.world, "cube_1", choose)
    with monkeypatch.context() as idle:
        idle.setattr("tabletopgen_env.expert.planning.choice.plan_grasps", lambda *_: 1 / 0)
        env.reset(seed=1, options=CUBE)
        assert first_plan(env.world, "cube_1", choose) is kept


@pytest.mark.parametrize(
    "randomization", [Randomization(table_height=0.03), Randomization(distractors=(0, 3))]
)
def test_resets_with_other_heights_and_distractors_pile_up_no_plans(randomization) -> None:
    env = lift(randomization=randomization)
    shown = {tuple(env.reset(seed=k, options=CUBE)[0][279:]) for k in range(4)}
    assert len({*env.world._known} - {"footprints"}) <= 1
    if randomization.table_height:
        assert len(shown) == 4, "each is planned for its own height"


def test_without_a_target_the_hint_is_empty() -> None:
    env = make_env(toy_scene(), task="Reach", grasp_hint=True)
    assert not env.reset(seed=0)[0][279:].any()
    assert not env.step(env.action_space.sample())[0][279:].any()


def test_noise_moves_the_hint_with_what_is_read_of_tool_and_object() -> None:
    noisy = lift(
        randomization=Randomization(joint_noise=0.03, position_noise=0.02, rotation_noise=0.1)
    )
    read = noisy.reset(seed=1, options=CUBE)[0]
    true = lift().reset(seed=1, options=CUBE)[0]
    tool, target = read[15:18] - true[15:18], read[40:43] - true[40:43]
    assert np.abs(tool).max() > 0.002 and np.abs(target).max() > 0.002
    assert np.allclose(read[279:282] - true[279:282], target - tool, atol=1e-5)
    yaws = [np.arctan2(state[19], state[18]) for state in (read, true)]
    assert read[282] - true[282] == pytest.approx(yaws[1] - yaws[0], abs=1e-5)
    assert np.array_equal(read[283:285], true[283:285])


@pytest.mark.slow
def test_a_table_of_another_height_has_a_hint_of_its_own() -> None:
    strong = Randomization(table_height=0.08)
    used = lift(randomization=strong)
    for seed in range(4):
        used.reset(seed=seed, options=CUBE)
    again = used.reset(seed=4, options=CUBE)[0]
    assert np.array_equal(again, lift(randomization=strong).reset(seed=4, options=CUBE)[0])


def test_the_hint_is_of_the_active_target_alone() -> None:
    env = lift()
    env.reset(seed=0, options=CUBE)
    assert env.hint is not None
    assert env.hint.plan(env.world, "cube_1") is not None
    assert env.hint.plan(env.world, "bowl_1") is None


def test_what_shows_no_state_has_no_hint() -> None:
    with pytest.raises(InputError, match="'pixels\\+state'"):
        lift(observation="pixels")


@pytest.mark.slow
@pytest.mark.parametrize("mode", ["state", "goal", "pixels+state", "point_cloud+state"])
def test_every_mode_has_room_for_it(mode) -> None:
    env = lift(observation=mode, image_size=16, points=16)
    seen = env.reset(seed=0)[0]
    assert env.observation_space.contains(seen)
    assert env.observation_space.contains(env.step(env.action_space.sample())[0])
    env.close()


def placing(**settings) -> tuple[TabletopEnv, TaskExpert]:
    """Return a PickPlace environment and its expert, just before carrying."""
    env, _, expert = started({**CUBE, "goal": (0.2, -0.15)}, task="PickPlace", **settings)
    for _ in range(100):
        env.step(expert.act())
        assert env.hint is not None
        if env.hint.drop is not None:
            return env, expert
    pytest.fail(f"never raised, {expert.phase}")


def test_what_is_held_is_to_be_raised_before_it_goes_anywhere() -> None:
    env, seen, expert = started()
    kinds, ways = [seen[286]], [seen[279:282]]
    for _ in range(60):
        seen, _, _, _, info = env.step(expert.act())
        assert (seen[286] < 0) == bool(seen[32] and seen[33])
        kinds.append(seen[286])
        ways.append(seen[279:282])
    first = kinds.index(-1.0)
    assert ways[first][2] > 0.14 and not ways[first][:2].any()
    assert abs(ways[-1][2]) < 0.025 and info["success"]


def test_a_grasp_that_lost_the_object_is_not_shown_again() -> None:
    env, _ = placing()
    assert env.hint is not None and env.hint.planned is not None
    before = env.hint.planned.grasp
    for _ in range(25):
        env.step(np.array([0, 0, 0, 0, 1]))
    after = env.hint.planned.grasp
    turn = abs(wrap(2 * (after.angle - before.angle))) / 2
    assert turn > np.deg2rad(20.0) or np.linalg.norm(after.point - before.point) > 0.015
    assert env.hint.drop is None


def test_what_is_raised_is_shown_its_place_until_it_stands_there() -> None:
    env, expert = placing()
    ways, done, info = [], False, {}
    while not done and len(ways) < 100:
        seen, _, _, _, info = env.step(expert.act())
        assert seen[286] == -1.0
        ways.append(seen[279:282].copy())
        done = expert.phase == "retreat"
    assert done
    assert np.linalg.norm(ways[-1]) < 0.01, "let go where it was said"
    assert np.abs(seen[282]) < 0.06 and 0.04 < seen[284] < 0.08
    for _ in range(30):
        seen, _, _, _, info = env.step(expert.act())
    assert info["success"] and seen[286] == -1.0
    assert seen[281] < -0.1, "the place lies below a hand that has risen"


def test_what_is_let_go_elsewhere_is_to_be_grasped_again() -> None:
    env, _ = placing()
    for _ in range(25):
        seen = env.step(np.array([0, 0, 0, 0, 1]))[0]
    assert seen[286] == 1.0
    assert seen[281] < -0.02, "it lies below"


def test_what_another_put_in_place_is_left_there() -> None:
    env, expert = placing()
    world = env.world
    spot = env.goal.region(world).center
    env.step(np.array([0, 0, 1, 0, 1]))
    world.teleport("cube_1", spot)
    for _ in range(20):
        action = expert.act()
        env.step(action)
    assert expert.phase == "retreat" and expert.attempts == 1


def test_noise_moves_a_place_with_what_is_read_of_the_thing_in_the_hand() -> None:
    noise = Randomization(joint_noise=0.01, position_noise=0.01)
    env, _ = placing(randomization=noise)
    still = np.zeros(5)
    still[4] = -1
    reads = [env.step(still)[0] for _ in range(8)]
    turn = rotation_z(float(np.mean([r[282] for r in reads])))
    sums = [r[279:282] + turn @ r[34:37] + r[15:18] for r in reads]  # where the object comes to
    assert np.ptp([r[279:282] for r in reads], 0).max() > 0.005
    assert np.ptp(sums, 0).max() < 0.006


@pytest.mark.parametrize(
    "randomization",
    [None, Randomization(table_height=0.05), Randomization(distractors=(0, 3))],
    ids=["as it is", "height", "distractors"],
)
def test_a_detected_hint_is_the_detectors_grasp(randomization) -> None:
    settings = {} if randomization is None else {"randomization": randomization}
    env = lift(grasp_hint="detected", **settings)
    for seed in range(1 if randomization is None else 3):
        seen = env.reset(seed=seed, options=CUBE)[0]
        assert_shown(seen, env, read_detector()(env.world, "cube_1"))


def test_a_detected_hint_asks_no_planner(monkeypatch) -> None:
    """It uses neither the grasps nor the places of the expert's planners."""
    spot = {**CUBE, "goal": "spot"}
    env, _, expert = started(spot, task="PickPlace", grasp_hint="detected")  # plans for the spot
    for planner in ("choice.plan_grasps", "placement._held_underside"):
        monkeypatch.setattr(f"tabletopgen_env.expert.planning.{planner}", lambda *_: 1 / 0)
    seen = env.reset(seed=0, options=spot)[0]
    expert.reset()
    hint = env.hint
    assert hint is not None
    while hint.drop is None and env.world.data.time < 4.0:
        seen = env.step(expert.act())[0]
    assert hint.drop is not None, "it was never raised"
    middle = env.goal.region(env.world).center
    held = env.world.position("cube_1") - env.world.data.site_xpos[env.world.tcp]
    np.testing.assert_allclose((hint.drop.tool + held)[:2], middle[:2], atol=0.01)
    assert seen[286] == -1.0


def test_an_unknown_hint_names_those_there_are() -> None:
    with pytest.raises(InputError, match=r"'planned' or 'detected', got 'detect'.*detected"):
        lift(grasp_hint="detect")


def test_planned_is_what_true_means() -> None:
    one, two = (lift(grasp_hint=kind).reset(seed=0, options=CUBE)[0] for kind in (True, "planned"))
    assert np.array_equal(one, two)


def test_a_copy_carries_no_weights() -> None:
    """It loads the shipped weights where it is unpickled."""
    planned, detected = (len(pickle.dumps(lift(grasp_hint=k))) for k in ("planned", "detected"))
    assert detected < planned + 200
    env = lift(grasp_hint="detected")
    copy = pickle.loads(pickle.dumps(env))
    assert copy.hint.choose is env.hint.choose


def test_where_nothing_is_detected_the_hint_is_empty(monkeypatch) -> None:
    monkeypatch.setattr("tabletopgen_env.detection.detector._POSSIBLE", np.inf)
    env = lift(grasp_hint="detected")
    assert not env.reset(seed=0, options=CUBE)[0][279:].any()
    with pytest.raises(SceneError, match="no grasp"):
        TaskExpert(env).reset()


@pytest.mark.slow
def test_threads_see_what_one_does() -> None:
    settings = {"task": "Lift", "grasp_hint": "detected", "max_episode_steps": 5}
    several = TabletopVectorEnv(3, scenes=toy_scene(), **settings)
    seen = several.reset(seed=[0, 1, 2])[0]
    alone = [lift(grasp_hint="detected").reset(seed=k)[0] for k in range(3)]
    assert np.array_equal(seen, alone)
    several.close()


@pytest.mark.slow
def test_a_detected_hint_needs_no_torch() -> None:
    code = (
        "import sys; sys.path.insert(0, 'tests'); from toy import toy_scene; "
        "from tabletopgen_env.env import make_env; "
        "make_env(toy_scene(), task='Lift', grasp_hint='detected').reset(seed=0); "
        "assert 'torch' not in sys.modules"
    )
    root = Path(__file__).parents[2]
    subprocess.run([sys.executable, "-c", code], check=True, cwd=root, timeout=300)


def test_the_experts_advice_follows_the_hint_at_once() -> None:
    """The expert does not pause while the hint already shows the way up, or to the place."""
    env, seen, expert = started({**CUBE, "goal": "spot"}, task="PickPlace")
    moved = {}
    while expert.phase != "release":
        before = expert.phase
        advice = expert.act()
        if expert.phase != before:
            moved[expert.phase] = float(np.abs(advice[:3]).max())
        seen = env.step(advice)[0]
    assert moved["lift"] > 0.3 and moved["carry"] > 0.3
    assert seen[286] == -1.0
