"""Objects not affected by an edit remain identical: pose, model, parts and mass."""

import zlib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from changed import kept
from toy import toy_object, toy_scene

import assets_cache
from generator import bundle, editing
from generator.composition import compose
from generator.editing.attempts import find_connected, find_disturbed
from generator.method.assembly import AssemblyConfig, rest
from generator.physics.gate import judge
from generator.physics.simulation import ON_TABLE, Simulation
from generator.scene import TABLE, Pose, Scene

STARTERS = ("coffee-oval", "dining-fruit", "office-desk", "workbench-toys")
FRUIT = "a metronome, a ukulele, a wooden bowl of apples and a cup with three pencils"
"""Apples in a bowl and pencils in a cup creep: settled again, they move by millimetres."""

EDITS: dict[str, Callable[[Path, str], editing.Edited]] = {
    "swap": lambda path, name: editing.swap(path, name, "a mug", 1),
    "turn": lambda path, name: editing.move(path, name, None, 0.3),
    "add": lambda path, name: editing.add(path, "an apple", 1),
    "remove": lambda path, name: editing.remove(path, name),
}


def linked(scene: Scene, names: set[str]) -> set[str]:
    """Return the objects connected with some others by contact within 1 mm, or by support."""
    called = dict(enumerate(o.name for o in scene.objects))
    near = Simulation(scene).contacts(margin=1e-3).pairs.tolist()
    pairs = [{called[a], called[b]} for a, b in near if min(a, b) >= 0]
    pairs += [{o.name, o.placement.on} for o in scene.objects if o.placement.on != TABLE]
    found = set(names)
    while more := {n for pair in pairs if pair & found for n in pair} - found:
        found |= more
    return found


def check_undisturbed(before: Path, done: editing.Edited, folder: Path) -> None:
    """Check an edit: objects not connected with its targets are identical."""
    assert done.scene.report is not None and done.scene.report.passed
    assert judge(done.scene).failures == ()
    changed = {*done.scene.provenance.edits[-1].names}
    old = bundle.load(before)
    touched = linked(old, changed) | linked(done.scene, changed)
    apart = {o.name for o in old.objects} - touched
    assert apart and apart <= kept(before, done.save(folder))


@pytest.mark.slow
@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("edit", EDITS)
@pytest.mark.parametrize("starter", STARTERS)
def test_an_edit_of_a_starter_leaves_what_it_does_not_touch(
    starter: str, edit: str, tmp_path: Path
) -> None:
    (path,) = assets_cache.find(starter)
    roots = [o.name for o in bundle.load(path).objects if o.placement.on == TABLE]
    name = roots[zlib.crc32(f"{starter} {edit}".encode()) % len(roots)]
    check_undisturbed(path, EDITS[edit](path, name), tmp_path)


@pytest.fixture(scope="module")
def fruit(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return bundle.save(compose(FRUIT, 1), tmp_path_factory.mktemp("fruit"))


@pytest.mark.slow
@pytest.mark.usefixtures("small")
@pytest.mark.parametrize("edit", EDITS)
def test_fruit_in_a_bowl_stays_as_something_else_is_edited(
    fruit: Path, edit: str, tmp_path: Path
) -> None:
    done = EDITS[edit](fruit, "metronome_1")
    check_undisturbed(fruit, done, tmp_path)
    creeping = {o.name for o in done.scene.objects if o.placement.inside}
    assert {"apple_1", "apple_2", "pencil_1", "pencil_2"} <= creeping


@pytest.mark.slow
def test_a_taken_apple_disturbs_only_what_it_touched(fruit: Path) -> None:
    before = bundle.load(fruit)
    after = editing.remove(fruit, "apple_1").scene
    cup = before.object("pencil_1").placement.on
    for name in ("metronome_1", "ukulele_1", cup, "pencil_1", "pencil_2", "pencil_3"):
        poses = [scene.object(name).pose for scene in (before, after)]
        np.testing.assert_array_equal(poses[0].position, poses[1].position)
        np.testing.assert_array_equal(poses[0].quaternion, poses[1].quaternion)


def boxes(*places: tuple[float, float]) -> Scene:
    """Boxes of 10 cm at x on the table, by their height above it, metres."""
    return toy_scene(tuple(
        toy_object(f"box_{k}", (0.1, 0.1, 0.1), (x, 0.0), top=0.74 + z)
        for k, (x, z) in enumerate(places)
    ))  # fmt: skip


def test_what_touches_a_changed_thing_is_disturbed_and_what_touches_that_is_connected() -> None:
    before = boxes((-0.1, 0), (0.0, 0), (0.1, 0), (0.3, 0))
    first = before.objects[0]
    away = Pose(first.pose.position + np.array([-0.2, 0, 0]), first.pose.quaternion)
    now = before.replace(objects=(replace(first, pose=away), *before.objects[1:]))
    assert find_disturbed(before, now, 1e-3) == {"box_0", "box_1"}
    assert find_connected(before, now, {"box_0"}, 1e-3) == {"box_0", "box_1", "box_2"}
    gone = before.replace(objects=before.objects[1:])
    assert find_disturbed(before, gone, 1e-3) == {"box_1"}
    assert find_disturbed(gone, before, 1e-3) == {"box_0", "box_1"}
    assert find_disturbed(before, before, 1e-3) == set()


def test_what_may_not_move_carries_what_falls_on_it() -> None:
    """Of two floating boxes one is fixed: the one above lands on it."""
    scene = boxes((0.0, 0.05), (0.0, 0.17))
    low = scene.objects[0]
    rested, unstable = rest(scene, AssemblyConfig(), None, {"box_1"})
    assert unstable == () and rested.object("box_0") is low
    assert rested.object("box_1").pose.position[2] == pytest.approx(0.74 + 0.2, abs=1e-3)
    fixed = Simulation(scene.replace(objects=(rested.object("box_1"),)), (low,))
    assert {*fixed.contacts(margin=1e-3).deepest()} == {(ON_TABLE, 0)}


def test_nothing_moves_where_nothing_may() -> None:
    scene = boxes((0.0, 0.05))
    assert rest(scene, AssemblyConfig(), None, ())[0] is scene
