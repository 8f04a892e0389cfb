"""Effects of each randomisation switch: lights to table height, delay and noise."""

from typing import Any

import numpy as np
import pytest
from randomized import OPTIONS, STRONG, only, started
from toy import toy_object, toy_objects, toy_scene

from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.randomization import Randomization
from tabletopgen_env.robot.kinematics import forward
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.world.world import World


def test_lights_turn_and_take_color() -> None:
    env, _, drawn = started(only("lights"))
    usual = World(toy_scene(), Panda()).model
    model, lights = env.world.model, drawn["lights"]
    cosine = float(model.light_dir[0] @ usual.light_dir[0])
    assert np.isclose(np.linalg.norm(model.light_dir[0]), 1) and 0.3 < cosine < 0.9999
    assert np.allclose(model.light_diffuse[0], usual.light_diffuse[0] * lights["color"])
    ambient = usual.vis.headlight.ambient * lights["ambient"]
    assert np.allclose(model.vis.headlight.ambient, ambient)
    assert STRONG.ambient[0] <= lights["ambient"] <= STRONG.ambient[1]


def test_cameras_move_turn_and_zoom_within_their_limits() -> None:
    env, _, drawn = started(only("cameras"))
    usual = World(toy_scene(), Panda()).model
    for key, name in (("front", "front"), ("wrist", "panda/wrist"), ("top", "overhead")):
        now, then, change = env.world.model.camera(name), usual.camera(name), drawn["cameras"][key]
        assert np.allclose(now.pos - then.pos, change["move"])
        assert 0 < np.abs(change["move"]).max() <= STRONG.camera_move
        turn = 2 * np.arccos(min(1.0, abs(float(now.quat @ then.quat))))
        assert np.isclose(turn, np.linalg.norm(change["turn"]), atol=1e-6) and turn > 0
        assert np.isclose(now.fovy[0], then.fovy[0] * change["fov"])
        assert abs(change["fov"] - 1) <= STRONG.camera_fov
    for name in ("reference", "top"):  # the scene's own stay
        assert np.array_equal(env.world.model.camera(name).pos, usual.camera(name).pos)


def test_colors_tint_objects_and_table_and_nothing_else() -> None:
    env, _, drawn = started(only("colors"))
    model, usual = env.world.model, World(toy_scene(), Panda()).model
    tints = {**drawn["colors"]["objects"], "table": drawn["colors"]["table"]}
    tinted = set()
    for name, tint in tints.items():
        assert all(1 - STRONG.tint <= share <= 1 for share in tint)
        materials = model.geom_matid[model.geom_bodyid == model.body(name).id]
        for k in materials[materials >= 0]:
            assert np.allclose(model.mat_rgba[k, :3], usual.mat_rgba[k, :3] * tint)
            tinted.add(int(k))
    rest = [k for k in range(model.nmat) if k not in tinted]
    assert rest and np.array_equal(model.mat_rgba[rest], usual.mat_rgba[rest])
    assert np.array_equal(model.mat_rgba[:, 3], usual.mat_rgba[:, 3])


def test_things_of_one_material_keep_one_color() -> None:
    twins = [toy_object(f"cube_{k}", (0.045,) * 3, (0.1 * k, -0.1)) for k in range(2)]
    env = make_env(toy_scene(tuple(twins)), randomization=only("colors"))
    for seed in range(3):
        drawn = env.reset(seed=seed)[1]["randomization"]["colors"]["objects"]
        assert drawn["cube_0"] == drawn["cube_1"]


def test_mass_scales_inertia_and_what_follows_from_it() -> None:
    env, _, drawn = started(only("mass"))
    model, usual = env.world.model, World(toy_scene(), Panda()).model
    for name, body in zip(env.world.names, env.world.bodies, strict=True):
        factor = drawn["mass"][name]
        assert STRONG.mass[0] <= factor <= STRONG.mass[1]
        assert np.isclose(model.body_mass[body], factor * usual.body_mass[body])
        assert np.allclose(model.body_inertia[body], factor * usual.body_inertia[body])
        weight = model.body_invweight0[body] * factor
        assert np.allclose(weight, usual.body_invweight0[body])


def test_mass_never_makes_a_thing_too_heavy_to_carry() -> None:
    jug = toy_object("jug_1", (0.06, 0.06, 0.1), (0.0, 0.0), mass=1.4)
    env = make_env(toy_scene((jug, *toy_objects())), randomization=Randomization(mass=(1.5, 2.0)))
    drawn = env.reset(seed=0)[1]["randomization"]["mass"]
    assert env.world.model.body_mass[env.world.bodies[0]] == pytest.approx(1.5)
    assert drawn["jug_1"] == pytest.approx(1.5 / 1.4)
    assert drawn["box_1"] >= 1.5  # 2.5 kg: nobody carries it anyhow


def test_friction_scales_sliding_alone() -> None:
    env, _, drawn = started(only("friction"))
    model, usual = env.world.model, World(toy_scene(), Panda()).model
    factors = {**drawn["friction"]["objects"], "table": drawn["friction"]["table"]}
    factors["panda/left_finger"] = factors["panda/right_finger"] = drawn["friction"]["fingers"]
    for name, factor in factors.items():
        own = model.geom_bodyid == model.body(name).id
        assert np.allclose(model.geom_friction[own, 0], factor * usual.geom_friction[own, 0])
    assert np.array_equal(model.geom_friction[:, 1:], usual.geom_friction[:, 1:])
    floor = model.geom("floor").id
    assert np.array_equal(model.geom_friction[floor], usual.geom_friction[floor])


def test_gains_scale_the_arms_servos() -> None:
    env, _, drawn = started(only("gains"))
    model, usual, arm = env.world.model, World(toy_scene(), Panda()).model, env.world.actuators
    stiffness, damping = (np.array(drawn["gains"][k]) for k in ("stiffness", "damping"))
    assert np.allclose(model.actuator_gainprm[arm[:7], 0],
                       usual.actuator_gainprm[arm[:7], 0] * stiffness)  # fmt: skip
    assert np.allclose(
        model.actuator_biasprm[arm[:7], 1:3],
        usual.actuator_biasprm[arm[:7], 1:3] * np.stack([stiffness, damping], 1),
    )
    assert np.array_equal(model.actuator_gainprm[arm[7]], usual.actuator_gainprm[arm[7]])
    env.step(np.zeros(5))
    held = env.world.data.qpos[env.world.arm_qpos] - env.world.data.ctrl[arm[:7]]
    assert np.abs(held).max() < 1e-3  # stiffness acts on the error, not on the angle


def test_a_higher_table_is_higher_in_the_base_frame_with_all_that_is_on_it() -> None:
    env, seen, drawn = started(only("table"))
    plain, usual, _ = started(None)
    rise = drawn["table"]["height"]
    assert 0.001 < abs(rise) <= STRONG.table_height
    slots, before = (s[40:268].reshape(12, 19) for s in (seen, usual))
    filled = before[:, 18] == 1
    assert np.allclose(slots[filled, 2] - before[filled, 2], rise, atol=1e-5)
    assert np.allclose(slots[filled, :2], before[filled, :2], atol=1e-5)
    assert seen[37] - usual[37] == pytest.approx(rise, abs=1e-5)
    assert seen[271] - usual[271] == pytest.approx(rise, abs=1e-5)  # the goal with it
    assert np.allclose(seen[15:18], usual[15:18], atol=1e-5)  # not the tool
    data, then = env.world.data, plain.world.data
    for name in ("front", "overhead", "panda/wrist"):
        k = env.world.model.camera(name).id
        assert np.allclose(data.cam_xpos[k] - then.cam_xpos[k], [0, 0, -rise], atol=1e-6)
    column, plate = (env.world.model.geom(f"pedestal_{n}") for n in ("column", "plate"))
    assert column.pos[2] - column.size[1] == pytest.approx(0.02)
    assert plate.pos[2] - plate.size[1] == pytest.approx(column.pos[2] + column.size[1])
    base = env.world.model.body("panda/link0").id
    assert data.xpos[base, 2] == pytest.approx(plate.pos[2] + plate.size[1])


@pytest.mark.slow
def test_delayed_actions_act_late_and_the_robot_holds_still_until_then() -> None:
    delays = set()
    for seed in range(6):
        env, _, drawn = started(Randomization(delay=2), seed=seed)
        plain = started(None, seed=seed)[0]
        delay = drawn["delay"]["steps"]
        delays.add(delay)
        held = env.world.data.ctrl.copy()
        moves = np.sin(np.arange(30.0)).reshape(6, 5)
        for k, move in enumerate(moves):
            env.step(move)
            if k < delay:
                assert np.array_equal(env.world.data.ctrl, held)
        for move in moves[: len(moves) - delay]:
            plain.step(move)
        assert np.allclose(env.world.data.ctrl, plain.world.data.ctrl, atol=1e-3)
    assert delays == {0, 1, 2}


def test_a_delay_does_not_reach_into_the_next_episode() -> None:
    for seed in range(9):
        env, _, drawn = started(Randomization(delay=3), seed=seed)
        if drawn["delay"]["steps"]:
            break
    for _ in range(3):
        env.step(np.ones(5))
    env.reset(seed=2, options=OPTIONS)
    fresh = started(Randomization(delay=3), seed=2)[0]
    for k in range(5):
        move = np.full(5, 0.1 * k)
        assert np.array_equal(env.step(move)[0], fresh.step(move)[0])


# ----------------------------------------------------------------------------------------- noise
def test_noise_is_on_the_readings_and_never_on_the_goal() -> None:
    env, seen, drawn = started(Randomization(joint_noise=0.01, position_noise=0.02,
                                             rotation_noise=0.05))  # fmt: skip
    usual = started(None)[1]
    assert drawn == {"noise": {"joint_noise": 0.01, "position_noise": 0.02, "rotation_noise": 0.05}}
    slots, true = (s[40:268].reshape(12, 19) for s in (seen, usual))
    filled = true[:, 18] == 1
    for same in (slice(7, 15), slice(31, 34), slice(37, 40), slice(268, 276)):
        assert np.array_equal(seen[same], usual[same])
    assert (seen[:7] != usual[:7]).all() and (slots[filled, :9] != true[filled, :9]).all()
    assert np.array_equal(slots[:, 9:], true[:, 9:]) and not slots[~filled].any()
    assert np.abs(seen[:7] - usual[:7]).max() < 0.05
    assert np.abs(slots[:, :3] - true[:, :3]).max() < 0.1
    assert env.observation_space.contains(seen)


def test_noisy_readings_agree_with_one_another() -> None:
    env, seen, _ = started(STRONG)
    point, hand = forward(seen[:7].astype(float))
    assert np.allclose(seen[15:18], point, atol=1e-4)
    assert np.allclose(seen[18:24], hand[:, :2].T.ravel(), atol=1e-4)
    command = env.world.data.ctrl[env.world.actuators[:7]]
    assert np.allclose(seen[24:31], command - seen[:7], atol=1e-6)
    assert np.allclose(seen[34:37], seen[40:43] - seen[15:18], atol=1e-6)
    assert np.allclose(seen[276:279], seen[269:272] - seen[40:43], atol=1e-6)
    x, y = seen[43:46], seen[46:49]
    assert np.isclose(x @ x, 1, atol=1e-5) and np.isclose(x @ y, 0, atol=1e-5)


def test_noise_is_drawn_anew_with_the_stated_deviation() -> None:
    env, first, _ = started(Randomization(position_noise=0.02))
    seen = np.array([env.step(np.zeros(5))[0] for _ in range(60)])
    cube = seen[:, 40:43]
    assert len(np.unique(cube[:, 0])) == 60 and not np.array_equal(first[40:43], cube[0])
    assert 0.015 < (cube - cube.mean(0)).std() < 0.025
    assert np.ptp(seen[:, :7], axis=0).max() < 1e-3


def test_noise_leaves_goals_and_rewards_alone() -> None:
    noisy = started(only("noise"), observation="goal")[0]
    plain = started(None, observation="goal")[0]
    for _ in range(5):
        a, b = (env.step(np.full(5, 0.3)) for env in (noisy, plain))
        for key in ("achieved_goal", "desired_goal"):
            assert np.array_equal(a[0][key], b[0][key])
        assert not np.array_equal(a[0]["observation"], b[0]["observation"])
        assert a[1] == b[1]


# ----------------------------------------------------------------------------------------- start
def test_the_arm_and_what_stands_free_start_a_little_off() -> None:
    env, seen, drawn = started(only("start"))
    plain, usual, _ = started(None)
    world, then = env.world, plain.world
    off = world.data.qpos[world.arm_qpos] - then.data.qpos[then.arm_qpos]
    assert np.allclose(off, drawn["start"]["joints"])
    assert 0.01 < np.abs(off).max() <= STRONG.start_joints
    free = drawn["start"]["moved"]
    assert "cube_1" in free and set(free) <= set(world.names)
    for name in world.names:
        x, y, turn = free.get(name, (0.0, 0.0, 0.0))
        moved = world.position(name) - then.position(name)
        assert np.allclose(moved, [x, y, 0.0], atol=1e-9)
        assert max(abs(x), abs(y)) <= STRONG.start_move and abs(turn) <= STRONG.start_turn
        cosine = (np.trace(world.rotation(name) @ then.rotation(name).T) - 1) / 2
        assert np.isclose(cosine, np.cos(turn), atol=1e-9)
    assert not np.array_equal(seen, usual)


def test_the_servos_keep_the_arm_where_it_starts() -> None:
    env = started(only("start"), action="joint_delta")[0]
    start = env.world.data.qpos[env.world.arm_qpos].copy()
    env.step(np.zeros(8))
    assert np.abs(env.world.data.qpos[env.world.arm_qpos] - start).max() < 2e-3


@pytest.mark.slow
def test_a_hint_at_a_start_that_is_off_is_that_starts_own() -> None:
    """Neither episode may use the other's grasp."""

    def seen(env: TabletopEnv, seed: int) -> np.ndarray:
        return env.reset(seed=seed, options={"target": "cube_1"})[0]

    settings: dict[str, Any] = {"task": "Lift", "grasp_hint": "planned", "randomization": "starts"}
    fresh = [seen(make_env(toy_scene(), **settings), seed) for seed in range(3)]
    env = make_env(toy_scene(), **settings)
    again = [seen(env, seed) for seed in (2, 1, 0)][::-1]
    assert all(np.array_equal(a, b) for a, b in zip(fresh, again, strict=True))
    assert len({a[-8:].tobytes() for a in fresh}) == 3
