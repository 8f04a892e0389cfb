"""Scene banks: placement of scenes' parts, and exclusion of scenes."""

import itertools
import re
from dataclasses import replace

import mujoco
import numpy as np
import pytest
from tables import shipped
from toy import toy_objects
from worlds import world_of

from generator.errors import InputError
from generator.physics.gate import judge
from generator.scene import Failure
from tabletopgen_env.parallel.batch.bank import SceneBank
from tabletopgen_env.parallel.batch.union import simplification
from tabletopgen_env.parallel.batch.union.content import GEOM_FIELDS, SceneContent
from tabletopgen_env.parallel.batch.union.shape import UnionShape
from tabletopgen_env.parallel.batch.union.simplification import cap_world
from tabletopgen_env.parallel.batch.union.template import PARKED
from tabletopgen_env.robot.panda import HOME_QPOS, Panda

NAMES = ("vanity", "coffee-square", "tidy-task-2")


@pytest.fixture(scope="module")
def bank() -> SceneBank:
    return SceneBank(shipped(*NAMES), max_parts=None)


def test_every_object_has_a_slot_of_its_own(bank: SceneBank) -> None:
    assert bank.scenes == NAMES and len(bank) == 3 and bank.slots == 5
    for k, world in enumerate(shipped(*NAMES)):
        there = [name for name in bank.objects[k] if name]
        assert sorted(there) == sorted(world.names)
        assert bank.filled[k].tolist() == [name is not None for name in bank.objects[k]]
        for name in there:
            slot = bank.slot(k, name)
            assert np.allclose(bank.half_extent[k, slot], world.half_extent[world.index(name)])
    with pytest.raises(
        InputError, match=r"Scene 'vanity' has no object 'mug'.*Available: cream_jar"
    ):
        bank.slot(0, "mug")


def test_rows_hold_the_numbers_of_the_scenes_own_models(bank: SceneBank) -> None:
    union, at = bank.union, bank.union.addresses
    for k, world in enumerate(shipped(*NAMES)):
        for row, name in enumerate(world.names):
            slot, body = bank.slot(k, name), world.bodies[row]
            here = at.slot_bodies.start + slot
            assert bank.rows["body_mass"][k, here] == np.float32(world.model.body_mass[body])
            assert bank.rows["body_gravcomp"][k, here] == 0
            geoms = np.flatnonzero(world.model.geom_bodyid == body)
            geoms = geoms[world.model.geom_contype[geoms] > 0]
            filled = np.flatnonzero(
                (union.slot_of == slot) & (bank.rows["geom_size"][k, :, 0] > 1e-5)
            )
            assert len(filled) == len(geoms)
            for field in GEOM_FIELDS:
                want = getattr(world.model, field)[geoms].astype(np.float32).reshape(len(geoms), -1)
                got = bank.rows[field][k, filled].reshape(len(geoms), -1)
                assert sorted(map(tuple, got.tolist())) == sorted(map(tuple, want.tolist())), field


def test_meshes_are_the_scenes_own_hulls(bank: SceneBank) -> None:
    model = bank.union.model
    world = shipped("coffee-square")[0]
    slot = bank.slot(1, "mug_1")
    ids = bank.rows["geom_dataid"][1][bank.union.slot_of == slot]
    own = world.model.geom_dataid[world.model.geom_bodyid == world.bodies[world.index("mug_1")]]
    names = {world.model.mesh(i).name for i in own if i >= 0}
    own = {name for name in names if name.startswith("hull_")}
    assert {model.mesh(i).name for i in ids if i >= 0} == own and len(own) > 2


def test_scenes_start_as_they_are_seen_from_the_robot(bank: SceneBank) -> None:
    at = bank.union.addresses
    for k, world in enumerate(shipped(*NAMES)):
        qpos = bank.rows["qpos"][k]
        assert np.array_equal(qpos[at.arm_qpos], np.float32(HOME_QPOS[:7]))
        poses = qpos[at.slot_qpos].reshape(-1, 7)
        for name in world.names:
            here = world.to_base(world.scene.object(name).pose.position)
            assert np.allclose(poses[bank.slot(k, name), :3], here, atol=1e-6)
        assert (poses[~bank.filled[k], 0] == PARKED).all()
        assert bank.table[k, 0] == pytest.approx(-0.01) and bank.yaw[k] == world.mount.yaw


def test_the_union_simulates_as_a_world_does(bank: SceneBank) -> None:
    ours, theirs = bank.union.model.opt, shipped("vanity")[0].model.opt
    for name in ("timestep", "integrator", "cone", "impratio", "solver", "disableflags", "gravity"):
        assert np.array_equal(getattr(ours, name), getattr(theirs, name)), name
    assert ours.enableflags | mujoco.mjtEnableBit.mjENBL_SLEEP == theirs.enableflags


def test_worlds_are_left_as_they_are() -> None:
    world = world_of(*toy_objects())
    before = world.data.qpos.copy(), world.model.geom_pos.copy()
    SceneBank([world])
    assert np.array_equal(before[0], world.data.qpos)
    assert np.array_equal(before[1], world.model.geom_pos)


def test_scenes_share_room() -> None:
    contents = [SceneContent.of(world) for world in shipped(*NAMES)]
    shape = UnionShape.around(contents)
    room = sum(sum(slot.values()) for slot in shape.slots)
    alone = [sum(len(thing.geoms.kinds) for thing in content.objects) for content in contents]
    assert max(alone) <= room < sum(alone)
    assert shape == UnionShape.around(contents)
    for content in contents:
        slots = shape.assign(content)
        assert slots is not None and len({*slots}) == len(content.objects)


def test_scenes_with_too_many_objects_are_named_and_left_out() -> None:
    bank = SceneBank(shipped("vanity", "coffee-square"), max_objects=4)
    assert bank.scenes == ("vanity",) and bank.sources == (0,)
    (left,) = bank.left_out
    assert (left.source, left.name) == (1, "coffee-square")
    assert left.reason == "the scene has 5 objects, but max_objects is 4"
    with pytest.raises(
        InputError,
        match=r"None of the .* scenes fits.*'vanity': the scene has 4 objects.*raise max",
    ):
        SceneBank(shipped("vanity", "coffee-square"), max_objects=3)
    with pytest.raises(InputError, match="at least one world"):
        SceneBank([])
    with pytest.raises(InputError, match="max_objects"):
        SceneBank(shipped("vanity"), max_objects=0)
    with pytest.raises(InputError, match="max_parts"):
        SceneBank(shipped("vanity"), max_parts=0)


def test_a_bank_of_a_given_shape_takes_what_fits(bank: SceneBank) -> None:
    tables = shipped("dining-fruit", "coffee-square", "vanity")
    second = SceneBank(tables, shape=bank.union.shape, max_parts=None)
    assert second.scenes == ("coffee-square", "vanity")
    assert [(s.name, "room" in s.reason) for s in second.left_out] == [("dining-fruit", True)]
    models = bank.union.model, second.union.model
    assert np.array_equal(*(m.geom_type for m in models))
    assert np.array_equal(*(m.geom_condim for m in models))
    assert np.array_equal(*(m.body_geomadr for m in models))


def test_a_scene_without_objects_has_room_for_none() -> None:
    bank = SceneBank([world_of()])
    assert bank.slots == 0 and bank.objects == ((),)


def test_another_robot_is_refused() -> None:
    world = world_of(*toy_objects())
    world.model.actuator_gainprm[0, 0] *= 2
    with pytest.raises(InputError, match="has a different robot than the bank"):
        SceneBank([world], max_parts=None)


def test_two_rows_differ_in_nothing_but_the_scene(bank: SceneBank) -> None:
    robot = np.flatnonzero(bank.union.sides)
    for field in ("body_mass", "body_inertia", "body_gravcomp", "body_invweight0"):
        for one, other in itertools.pairwise(bank.rows[field][:, robot]):
            assert np.array_equal(one, other), field


def test_objects_of_many_parts_are_merged_and_gated_anew(monkeypatch: pytest.MonkeyPatch) -> None:
    world = world_of(*toy_objects())
    many = SceneBank([world], max_parts=None).union.shape
    few = SceneBank([world], max_parts=5).union.shape
    assert max(sum(slot.values()) for slot in many.slots) == 13
    assert max(sum(slot.values()) for slot in few.slots) == 5
    capped = cap_world(world, 5, Panda())
    assert capped is not world and capped.mount is world.mount
    assert cap_world(world, 13, Panda()) is world
    floating = tuple(Failure("floats", (name,)) for name in ("mug_1", "bowl_1", "more"))
    failed = replace(judge(world.scene), failures=floating)
    monkeypatch.setattr(simplification, "judge", lambda scene: failed)
    said = (
        "with at most 5 parts per object it fails its physical gate (mug_1 floats; bowl_1 floats)"
    )
    with pytest.raises(InputError, match=re.escape(said)):
        SceneBank([world], max_parts=5)
