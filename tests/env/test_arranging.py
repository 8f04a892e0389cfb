"""Displaced objects, and removed objects."""

from dataclasses import replace

import numpy as np
import pytest
from randomized import STRONG, only, started
from toy import toy_object, toy_objects, toy_scene, toy_table

from generator.scene import ConvexPart, Object, Pose, Scene
from tabletopgen_env.env import make_env
from tabletopgen_env.randomization import Randomization
from tabletopgen_env.randomization.arrangement import apply_poses, bundles, leaving
from tabletopgen_env.rendering.drawer import drawer
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.world.world import World


def on(thing: Object, support: str, inside: bool = False) -> Object:
    return replace(thing, placement=replace(thing.placement, on=support, inside=inside))


def tray_scene() -> Scene:
    """A tray with a cube on it, a bowl, another cube."""
    tray = toy_object("tray_1", (0.2, 0.15, 0.03), (0.15, 0.05), mass=0.4)
    die = on(toy_object("die_1", (0.04, 0.04, 0.04), (0.2, 0.07), top=0.77), "tray_1")
    objects = {o.name: o for o in toy_objects()}
    return toy_scene((tray, die, objects["cube_1"], objects["bowl_1"]))


# ------------------------------------------------------------------------------------------ poses
@pytest.mark.slow
def test_poses_change_a_little_and_rest() -> None:
    env = make_env(toy_scene(), randomization=only("poses"))
    start = {o.name: o.pose for o in toy_scene().objects}
    for seed in range(4):
        drawn = env.reset(seed=seed)[1]["randomization"]["poses"]
        world, moved = env.world, drawn["moved"]
        assert set(moved) | set(drawn["stayed"]) == set(world.names) and moved
        for name, (x, y, turn) in moved.items():
            assert max(abs(x), abs(y)) <= STRONG.move and abs(turn) <= STRONG.turn
            shift = world.position(name) - start[name].position
            assert np.allclose(shift, [x, y, 0])
            assert np.allclose(world.scene.object(name).pose.position, world.position(name))
        assert world.data.contact.dist.min(initial=0) > -5e-4
        before = world.data.xpos[world.bodies].copy()
        world.step(100)
        assert np.abs(world.data.xpos[world.bodies] - before).max() < 2e-3


def test_what_is_turned_turns_about_its_own_middle() -> None:
    env, _, drawn = started(Randomization(turn=1.0), seed=3)
    world = env.world
    for name, (_, _, turn) in drawn["poses"]["moved"].items():
        old = toy_scene().object(name).pose.quaternion
        yaw = np.arctan2(world.rotation(name)[1, 0], world.rotation(name)[0, 0])
        wanted = 2 * np.arctan2(old[3], old[0]) + turn
        assert np.isclose(np.cos(yaw - wanted), 1)


def test_what_stands_on_something_goes_with_it() -> None:
    env, _, drawn = started(only("poses"), seed=1, scene=tray_scene())
    assert set(drawn["poses"]["moved"]) == {"tray_1", "cube_1", "bowl_1"}
    world, before = env.world, World(tray_scene(), Panda())
    before.reset()
    beside = [
        made.rotation("tray_1").T @ (made.position("die_1") - made.position("tray_1"))
        for made in (world, before)
    ]
    assert np.allclose(*beside)


def test_what_would_overlap_or_leave_the_table_stays() -> None:
    crowd = tuple(toy_object(f"cube_{k}", (0.045,) * 3, (0.046 * k - 0.1, -0.1)) for k in range(5))
    edge = toy_object("can_1", (0.06, 0.06, 0.11), (0.0, 0.318), kind="cylinder")
    env = make_env(toy_scene((*crowd, edge)), randomization=Randomization(move=0.03))
    stayed = set()
    for seed in range(4):
        stayed |= set(env.reset(seed=seed)[1]["randomization"]["poses"]["stayed"])
        world = env.world
        assert world.data.contact.dist.min(initial=0) > -5e-4
        assert (world.footprints["can_1"][:, 1] <= 0.35).all()
    assert "can_1" in stayed and stayed & {f"cube_{k}" for k in range(5)}


def leaning_world() -> World:
    """A plank that leans on a block, at rest, and a cube beside."""
    angle = np.deg2rad(20.0)
    c, s = np.cos(angle), np.sin(angle)
    middle = np.array([-0.06 + 0.1 * s, 0.0, 0.74 + 0.1 * c + 0.005 * s])
    plank = toy_object("plank_1", (0.01, 0.06, 0.2), (0.0, 0.0), mass=0.05)
    turned = np.array([np.cos(angle / 2), 0.0, np.sin(angle / 2), 0.0])
    block = toy_object("block_1", (0.05, 0.05, 0.1), (0.0, 0.0), mass=0.4)
    cube = toy_object("cube_1", (0.04, 0.04, 0.04), (0.3, 0.1))
    world = World(toy_scene((replace(plank, pose=Pose(middle, turned)), block, cube)), Panda())
    world.reset()
    world.step(300)
    poses = world.data.qpos[:21].reshape(3, 7)
    rested = [
        replace(thing, pose=Pose(pose[:3], pose[3:]))
        for thing, pose in zip(world.scene.objects, poses, strict=True)
    ]
    world.rearrange(toy_scene(tuple(rested)))
    world.reset()
    assert 0.9 < world.rotation("plank_1")[2, 2] < 0.97
    return world


def test_what_leans_goes_with_what_it_leans_on() -> None:
    world = leaning_world()
    before = {name: world.position(name) for name in world.names}
    assert bundles(world) == {"plank_1": "plank_1", "block_1": "plank_1", "cube_1": "cube_1"}
    assert apply_poses(world, {"plank_1": [0.03, 0.02, 0.5]}) == []
    c, s = np.cos(0.5), np.sin(0.5)
    wanted = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ (before["block_1"] - before["plank_1"])
    assert np.allclose(world.position("block_1") - world.position("plank_1"), wanted)
    assert np.allclose(world.position("cube_1"), before["cube_1"])
    assert leaving(bundles(world), ["block_1"], 0, world.names) == ("cube_1",)


def test_what_would_fall_stays() -> None:
    """Half of this table top is missing, contrary to its outline."""
    table = toy_table()
    corners = [[x, y, z] for x in (-0.6, 0.6) for y in (-0.35, 0.0) for z in (0.34, 0.37)]
    half = replace(table, parts=(ConvexPart(np.array(corners)),))
    near, far = (
        toy_object(name, (0.04, 0.04, 0.04), (x, -0.03))
        for name, x in (("a_1", -0.1), ("b_1", 0.1))
    )
    world = World(toy_scene((near, far), half), Panda())
    world.reset()
    scene = world.scene
    assert apply_poses(world, {"a_1": [0.0, 0.06, 0.0], "b_1": [0.02, 0.0, 0.0]}) == ["a_1"]
    assert world.scene.object("a_1") is scene.object("a_1")
    assert np.allclose(world.position("b_1"), far.pose.position + np.array([0.02, 0, 0]))


# ------------------------------------------------------------------------------------ distractors
@pytest.mark.slow
def test_distractors_leave_the_table_and_their_slots() -> None:
    counts = set()
    for seed in range(4):
        env, seen, drawn = started(Randomization(distractors=(0, 3)), seed=seed)
        gone, world = drawn["distractors"]["absent"], env.world
        assert not {"cube_1", "bowl_1"} & set(gone)
        assert len(world.names) - 2 - len(gone) == drawn["distractors"]["most"]
        slots = seen[40:268].reshape(12, 19)
        assert slots[:, 18].sum() == len(world.names) - len(gone)
        assert (slots[slots[:, 18] == 1][:, 2] > -0.1).all()
        for name in gone:
            assert world.position(name)[2] < -5
        counts.add(len(gone))
    assert len(counts) > 1 and counts <= {1, 2, 3, 4}


def test_what_is_away_stays_away_and_sleeps() -> None:
    env, _, drawn = started(Randomization(distractors=(0, 0)))
    world, gone = env.world, drawn["distractors"]["absent"]
    before = {name: world.position(name) for name in world.names}
    world.step(600)
    for name in world.names:
        assert np.allclose(world.position(name), before[name], atol=2e-3)
    trees = world.model.body_treeid[[world.model.body(name).id for name in gone]]
    assert len(gone) == 4 and (world.data.tree_asleep[trees] >= 0).all()


def test_what_is_away_is_in_no_picture() -> None:
    env, _, drawn = started(Randomization(distractors=(0, 0)))
    bodies = [env.world.model.body(name).id for name in drawn["distractors"]["absent"]]
    eyes = drawer("software", 48, 64)
    for camera in ("front", "panda/wrist", "overhead"):
        geoms = eyes.draw(env.world, camera, ("segmentation",))["segmentation"]
        assert not np.isin(env.world.model.geom_bodyid[geoms[geoms >= 0]], bodies).any()


def test_bundles_stay_or_go_as_a_whole() -> None:
    world = World(tray_scene(), Panda())
    world.reset()
    root, names = bundles(world), list(world.names)
    assert root == {"tray_1": "tray_1", "die_1": "tray_1", "cube_1": "cube_1", "bowl_1": "bowl_1"}
    assert leaving(root, ["die_1"], 0, names) == ("cube_1", "bowl_1")
    assert leaving(root, ["cube_1"], 0, names) == ("tray_1", "die_1", "bowl_1")
    assert leaving(root, ["cube_1"], 2, names) == ("tray_1", "die_1")
    assert leaving(root, ["cube_1"], 2, names[::-1]) == ("bowl_1",)
    assert leaving(root, ["cube_1"], 3, names) == ()
    assert leaving(root, ["cube_1"], 9, names) == ()


def test_a_bundle_is_named_for_what_stands_on_the_table() -> None:
    world = World(toy_scene(tray_scene().objects[1::-1]), Panda())
    world.reset()
    assert world.names == ("die_1", "tray_1")
    assert bundles(world) == {"die_1": "tray_1", "tray_1": "tray_1"}
