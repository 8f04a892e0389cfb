"""Sleep and grasps: touched objects wake, held ones stay awake, contacts are reported."""

import mujoco
import numpy as np
import pytest
from toy import toy_object, toy_scene

from tabletopgen_env.robot.kinematics import solve_ik
from tabletopgen_env.robot.mount import Mount
from tabletopgen_env.robot.panda import HOME_CTRL, Panda
from tabletopgen_env.world.world import World

DOWN = np.diag([1.0, -1.0, -1.0])
ASIDE, UP = np.array([1.0, 0.0, 0.0]), np.array([0.0, 0.0, 1.0])
OPEN, CLOSED = HOME_CTRL[7], 0.0


@pytest.fixture
def world() -> World:
    cube = toy_object("cube_1", (0.045, 0.045, 0.045), (0.0, 0.0))
    can = toy_object("can_1", (0.06, 0.06, 0.11), (0.3, 0.1), kind="cylinder")
    made = World(toy_scene((cube, can)), Panda())
    made.reset()
    return made


def asleep(world: World, name: str) -> bool:
    tree = world.model.body_treeid[world.bodies[world.index(name)]]
    return bool(world.data.tree_asleep[tree] >= 0)


def joints(world: World, point: np.ndarray) -> np.ndarray:
    """Return joints that move the tool to a world point, fingers opening along the base's y."""
    found = solve_ik(world.to_base(point), DOWN)
    assert found.solved
    return found.joints


def stand(world: World, point: np.ndarray, gripper: float = OPEN) -> None:
    """Place the arm at rest with its tool at a world point."""
    found = joints(world, point)
    world.data.qpos[world.arm_qpos] = found
    world.data.ctrl[world.actuators] = [*found, gripper]
    mujoco.mj_forward(world.model, world.data)
    world.step(1)


def send(world: World, point: np.ndarray, steps: int) -> None:
    """Move the tool to a world point linearly in ``steps`` simulation steps."""
    world.data.ctrl[world.actuators[:7]] = joints(world, point)
    world.step(steps)


def test_a_sleeping_thing_wakes_in_the_closing_hand_and_stays_awake_in_the_air(world) -> None:
    cube = world.position("cube_1")
    stand(world, cube)
    world.step(800)
    assert asleep(world, "cube_1") and world.touches("cube_1") == (False, False, False)
    world.data.ctrl[world.actuators[7]] = CLOSED
    world.step(200)
    assert not asleep(world, "cube_1") and world.touches("cube_1") == (True, True, True)
    send(world, cube + 0.15 * UP, 500)
    for _ in range(20):
        world.step(100)
        assert not asleep(world, "cube_1") and world.touches("cube_1") == (True, True, True)
    assert world.position("cube_1")[2] > cube[2] + 0.1
    assert asleep(world, "can_1")
    world.data.ctrl[world.actuators[7]] = OPEN
    world.step(1500)
    assert asleep(world, "cube_1") and world.lowest("cube_1") == pytest.approx(0.74, abs=1e-3)
    assert world.touches("cube_1") == (False, False, False)


def test_a_thing_at_rest_against_a_finger_is_touched_for_as_long_as_it_is(world) -> None:
    cube = world.position("cube_1")
    along = world.to_world(np.array([0.0, 1.0, 0.0])) - world.to_world(np.zeros(3))
    stand(world, cube + 0.2 * UP, CLOSED)
    send(world, cube - 0.08 * along, 600)
    world.step(800)
    assert asleep(world, "cube_1") and not world.touches("cube_1")[2]
    send(world, cube - 0.02 * along, 600)
    for _ in range(30):
        world.step(100)
        left, right, robot = world.touches("cube_1")
        assert robot and left != right and not asleep(world, "cube_1")
    assert np.linalg.norm(world.state.velocities[0]) < 0.01, "it is at rest all the same"


def test_a_thing_asleep_against_the_base_is_touched() -> None:
    board = toy_object("board_1", (0.02, 0.08, 0.1), (-0.3, 0.0))
    world = World(toy_scene((board,)), Panda(), Mount(np.array([0.0, 0.0, 0.74]), 0.0))
    world.reset()
    lean = 0.2
    turned = np.array([np.cos(lean / 2), 0.0, np.sin(lean / 2), 0.0])
    world.teleport("board_1", np.array([-0.19, 0.0, 0.792]), turned)
    while not world.touches("board_1")[2]:
        world.step(10)
    assert not asleep(world, "board_1")
    world.step(1000)
    assert asleep(world, "board_1") and world.data.ncon == 0, "its contacts are not listed"
    assert world.touches("board_1") == (False, False, True)
    world.teleport("board_1", np.array([0.35, 0.2, 0.8]), np.array([1.0, 0, 0, 0]))
    world.step(1500)
    assert asleep(world, "board_1") and world.touches("board_1") == (False, False, False)


def test_touch_is_looked_up_afresh_after_everything_that_moves(world) -> None:
    cube = world.position("cube_1")
    stand(world, cube)
    world.data.ctrl[world.actuators[7]] = CLOSED
    world.step(300)
    assert world.touches("cube_1")[2]
    world.teleport("cube_1", cube + 0.2 * ASIDE)
    assert not world.touches("cube_1")[2]
    world.teleport("cube_1", cube)
    assert world.touches("cube_1")[2]
    world.reset()
    assert not world.touches("cube_1")[2]
