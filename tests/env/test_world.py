"""Robot and scene as one compiled world: names, frames, sleeping, contacts."""

import numpy as np
import pytest
from toy import toy_object, toy_objects, toy_scene

from generator.errors import SceneError
from tabletopgen_env.robot.mount import Mount
from tabletopgen_env.robot.panda import HOME_QPOS, Panda
from tabletopgen_env.world.world import World


@pytest.fixture
def world() -> World:
    made = World(toy_scene(), Panda())
    made.reset()
    return made


def asleep(world: World) -> set[str]:
    """Return the objects whose tree sleeps."""
    trees = world.model.body_treeid[world.bodies]
    return {n for n, t in zip(world.names, trees, strict=True) if world.data.tree_asleep[t] >= 0}


def test_reset_is_home_and_the_settled_poses(world) -> None:
    joints = np.concatenate([world.arm_qpos, world.finger_qpos])
    assert np.allclose(world.data.qpos[joints], HOME_QPOS)
    for obj in world.scene.objects:
        assert np.allclose(world.position(obj.name), obj.pose.position)
    assert not any(world.touches(name)[2] for name in world.names)


def test_the_state_is_live_views_of_a_world_and_a_twin_has_its_own(world) -> None:
    twin = world.twin()
    state, data = world.state, world.data
    world.data.ctrl[world.actuators] = [*HOME_QPOS[:6], 1.0, 0.0]
    world.teleport("cube_1", world.position("cube_1") + np.array([0.0, 0.0, 0.1]))
    world.step(50)
    bodies, k = world.bodies, world.index("cube_1")
    assert np.array_equal(state.joints, data.qpos[world.arm_qpos])
    assert np.array_equal(state.joint_velocities, data.qvel[world.arm_dof])
    assert np.array_equal(state.fingers, data.qpos[world.finger_qpos])
    assert np.array_equal([*state.servos, *state.gripper], data.ctrl[world.actuators])
    assert np.array_equal(state.tool, data.site("panda/tcp").xpos)
    assert np.array_equal(state.hand.ravel(), data.site("panda/tcp").xmat)
    assert np.array_equal(state.positions, data.xpos[bodies])
    assert np.array_equal(state.rotations.reshape(-1, 9), data.xmat[bodies])
    joint = world.model.body_jntadr[bodies[k]]
    first = world.model.jnt_dofadr[joint]
    assert np.array_equal(state.velocities[k], data.qvel[first : first + 6])
    assert np.abs(twin.state.joints - HOME_QPOS[:7]).max() == 0.0
    assert np.abs(state.joints - HOME_QPOS[:7]).max() > 0.01


def test_the_base_stands_at_the_mount(world) -> None:
    base = world.model.body("panda/link0").id
    assert np.allclose(world.data.xpos[base], world.mount.position)
    ahead = world.to_world(np.array([1.0, 0.0, 0.0])) - world.mount.position
    assert np.allclose(world.data.xmat[base].reshape(3, 3)[:, 0], ahead)


def test_the_mount_can_be_chosen() -> None:
    mount = Mount(np.array([0.9, 0.0, 0.75]), np.pi)
    world = World(toy_scene(), Panda(), mount)
    world.reset()
    assert np.allclose(world.to_base(np.array([0.4, 0.1, 0.75])), [0.5, -0.1, 0.0])


def test_resting_things_sleep_and_wake_when_touched(world) -> None:
    world.step(1000)
    assert asleep(world) == set(world.names)
    cube = world.position("cube_1")
    world.teleport("can_1", cube + np.array([0.0, 0.0, 0.15]))
    assert "can_1" not in asleep(world)
    world.step(150)
    assert {"can_1", "cube_1"}.isdisjoint(asleep(world))
    assert "bowl_1" in asleep(world)


def test_what_lies_in_a_sleeping_bowl_goes_with_it() -> None:
    world = World(toy_scene(), Panda())
    world.reset()
    world.teleport("cube_1", world.position("bowl_1") + np.array([0.0, 0.0, 0.01]))
    world.step(1500)
    assert {"cube_1", "bowl_1"} <= asleep(world)
    bowl = world.position("bowl_1")
    for k in range(40):
        world.teleport("bowl_1", bowl + np.array([0.0, 0.0, 0.002 * (k + 1)]))
        world.step(5)
    assert world.position("cube_1")[2] > bowl[2] + 0.04


def test_the_lowest_point_is_that_of_the_turned_shape(world) -> None:
    side = np.array([np.sqrt(0.5), np.sqrt(0.5), 0.0, 0.0])
    world.teleport("bottle_1", np.array([0.0, -0.2, 1.2]), side)
    assert world.lowest("bottle_1") == pytest.approx(1.17)
    assert world.lowest("cube_1") == pytest.approx(0.74)


def test_unknown_objects_are_named(world) -> None:
    with pytest.raises(SceneError, match=r"no object 'mug_2'.*Did you mean 'mug_1'"):
        world.position("mug_2")


def test_objects_keep_their_masses(world) -> None:
    masses = world.model.body_mass[world.bodies]
    assert np.allclose(masses, [obj.mass for obj in toy_objects()])


def test_objects_may_be_called_like_what_the_environment_adds() -> None:
    names = ("goal", "front", "floor", "panda")
    objects = tuple(
        toy_object(name, (0.05,) * 3, (0.2 * k - 0.3, 0.0)) for k, name in enumerate(names)
    )
    assert World(toy_scene(objects), Panda()).names == names
