"""Objects that stand on or in an edited object."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from changed import kept
from toy import toy_object, toy_scene

from generator import bundle, editing
from generator.errors import SceneError
from generator.physics.gate import judge
from generator.scene import Object

pytestmark = pytest.mark.usefixtures("small")

TOP = 0.74


def on(thing: Object, below: str, *, inside: bool = False) -> Object:
    return replace(thing, placement=replace(thing.placement, on=below, inside=inside))


@pytest.fixture(scope="module")
def loaded(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A cup with a die in it, a block on a box, and a can."""
    scene = toy_scene(
        (
            toy_object("mug_1", (0.1, 0.1, 0.09), (-0.2, 0.0), wall=0.006, mass=0.3),
            on(toy_object("die_1", (0.03, 0.03, 0.03), (-0.2, 0.0), top=TOP + 0.006),
               "mug_1", inside=True),
            toy_object("box_1", (0.16, 0.12, 0.08), (0.1, 0.05), mass=1.0),
            on(toy_object("block_1", (0.05, 0.05, 0.05), (0.12, 0.06), top=TOP + 0.08), "box_1"),
            toy_object("can_1", (0.06, 0.06, 0.1), (0.4, -0.1), kind="cylinder"),
        )
    )  # fmt: skip
    return bundle.save(scene.replace(report=judge(scene)), tmp_path_factory.mktemp("loaded"))


def test_what_is_in_a_removed_thing_goes_along(loaded: Path) -> None:
    done = editing.remove(loaded, "mug_1")
    assert [o.name for o in done.scene.objects] == ["box_1", "block_1", "can_1"]
    assert done.scene.provenance.edits[-1].names == ("mug_1", "die_1")
    assert "die_1 was removed with mug_1." in done.scene.provenance.warnings


@pytest.mark.slow
def test_what_stood_on_a_removed_thing_is_set_down(loaded: Path, tmp_path: Path) -> None:
    done = editing.remove(loaded, "box_1")
    block = done.scene.object("block_1")
    assert block.placement.on == "table"
    assert block.pose.position[2] == pytest.approx(TOP + 0.025, abs=1e-3)
    assert np.allclose(block.pose.position[:2], [0.12, 0.06], atol=5e-3)
    assert any("block_1 was set down" in w for w in done.scene.provenance.warnings)
    assert kept(loaded, done.save(tmp_path)) == {"mug_1", "die_1", "can_1"}


@pytest.mark.parametrize(("name", "load"), [("mug_1", "die_1"), ("box_1", "block_1")])
def test_a_moved_thing_takes_its_load_along(loaded: Path, name: str, load: str) -> None:
    before = bundle.load(loaded)
    done = editing.move(loaded, name, (0.25, -0.2), np.pi / 2)
    after = done.scene
    was = before.object(load).pose.position - before.object(name).pose.position
    now = after.object(load).pose.position - after.object(name).pose.position
    assert np.allclose(now, [-was[1], was[0], was[2]], atol=2e-3)
    assert np.allclose(after.object(name).pose.position[:2], [0.25, -0.2], atol=2e-3)
    assert after.provenance.edits[-1].names == (name, load)


@pytest.mark.slow
def test_a_vessel_in_place_of_a_vessel_takes_what_was_in_it(loaded: Path) -> None:
    done = editing.swap(loaded, "mug_1", "a bowl")
    die, bowl = done.scene.object("die_1"), done.scene.object("bowl_1")
    assert (die.placement.on, die.placement.inside) == ("bowl_1", True)
    assert die.pose.position[2] < bowl.pose.position[2] + bowl.scale[2] / 2
    assert np.linalg.norm((die.pose.position - bowl.pose.position)[:2]) < bowl.scale[0] / 2


@pytest.mark.slow
def test_the_same_edit_gives_the_same_scene(loaded: Path) -> None:
    edits = [editing.swap(loaded, "mug_1", "a bowl", seed) for seed in (3, 3, 4)]
    first, again, other = (bundle.digest(done.scene) for done in edits)
    assert first == again != other
    assert edits[0].scene.provenance == edits[1].scene.provenance


def test_what_holds_nothing_does_not_replace_a_vessel(loaded: Path) -> None:
    with pytest.raises(SceneError, match="mug_1 contains die_1, but book cannot hold objects"):
        editing.swap(loaded, "mug_1", "a book")


def test_nothing_moves_relative_to_its_own_load(loaded: Path) -> None:
    with pytest.raises(ValueError, match="moves with it"):
        editing.move(loaded, "box_1", "left of block_1")


@pytest.mark.slow
def test_what_carries_nothing_does_not_replace_a_support(loaded: Path) -> None:
    with pytest.raises(SceneError, match="block_1"):
        editing.swap(loaded, "box_1", "a tennis ball")


def test_what_stands_on_a_swapped_thing_stands_on_the_other(loaded: Path) -> None:
    done = editing.swap(loaded, "box_1", "a large book")
    block, book = done.scene.object("block_1"), done.scene.object("book_1")
    assert block.placement.on == "book_1"
    top = book.pose.position[2] + book.scale[2] / 2
    assert block.pose.position[2] == pytest.approx(top + 0.025, abs=3e-3)


@pytest.mark.slow
def test_a_thing_goes_into_a_vessel_and_onto_another(loaded: Path) -> None:
    inside = editing.add(loaded, "a die in mug_1").scene.objects[-1]
    assert (inside.placement.on, inside.placement.inside) == ("mug_1", True)
    on_top = editing.move(loaded, "can_1", "on the box").scene.object("can_1")
    assert on_top.placement.on == "box_1"
    assert on_top.pose.position[2] > TOP + 0.08


def test_the_last_thing_stays(tmp_path: Path) -> None:
    scene = toy_scene((toy_object("can_1", (0.06, 0.06, 0.1), (0, 0), kind="cylinder"),))
    path = bundle.save(scene.replace(report=judge(scene)), tmp_path)
    with pytest.raises(SceneError, match="last object"):
        editing.remove(path, "can_1")


def test_a_full_table_has_no_room(tmp_path: Path) -> None:
    size = (0.56, 0.3, 0.1)
    things = [
        toy_object(f"box_{k}", size, (x, y), mass=2.0)
        for k, (x, y) in enumerate([(-0.3, -0.17), (0.3, -0.17), (-0.3, 0.17), (0.3, 0.17)])
    ]
    scene = toy_scene(tuple(things))
    path = bundle.save(scene.replace(report=judge(scene)), tmp_path)
    with pytest.raises(SceneError, match="no free place on the table"):
        editing.add(path, "a large plate")
    assert [p.name for p in tmp_path.iterdir()] == [path.name]
