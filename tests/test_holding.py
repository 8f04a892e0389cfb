"""Relations and supports that a settled scene's report denies are used nowhere."""

from dataclasses import replace

import pytest
from toy import toy_object, toy_scene

from generator.editing.plans import move_in_plan, remove_from_plan, swap_in_plan
from generator.layout.relation_check import record_relations
from generator.scene import (
    TABLE,
    PlannedGroup,
    PlannedObject,
    PlannedTable,
    Relation,
    RelationOutcome,
    Report,
    Scene,
    ScenePlan,
    held_relations,
    hold_supports,
)

ON, LEFT = Relation("on", "book_1"), Relation("left_of", "can_1")


def scene_with(*outcomes: RelationOutcome, on: str = "book_1") -> Scene:
    """Return a cube requested on a book and left of a can, but placed beside the book."""
    cube = toy_object("cube_1", (0.05, 0.05, 0.05), (-0.1, 0.0))
    book = toy_object("book_1", (0.2, 0.14, 0.03), (0.1, 0.0))
    can = toy_object("can_1", (0.06, 0.06, 0.1), (0.4, 0.0), kind="cylinder")
    cube = replace(cube, placement=replace(cube.placement, on=on))
    planned = (
        PlannedObject("cube_1", "cube", "generic", relations=(ON, LEFT)),
        PlannedObject("book_1", "book", "book"),
        PlannedObject("can_1", "can", "can"),
    )
    groups = (PlannedGroup("row", ("cube_1", "can_1"), around=None),)
    plan = ScenePlan("a cube on a book", PlannedTable(), planned, groups=groups)
    report = Report(0.0, 0.0, 0.0, relations=outcomes)
    return toy_scene((cube, book, can)).replace(plan=plan, report=report)


DENIED = RelationOutcome("cube_1", "on", "book_1", False, -0.1)
HELD = RelationOutcome("cube_1", "left_of", "can_1", True, 0.2)


def test_relations_hold_as_the_report_says() -> None:
    assert held_relations(scene_with(DENIED, HELD), "cube_1") == (LEFT,)
    assert held_relations(scene_with(DENIED, HELD), "book_1") == ()


def test_without_outcomes_the_plan_is_believed() -> None:
    assert held_relations(scene_with(), "cube_1") == (ON, LEFT)
    assert held_relations(scene_with().replace(report=None), "cube_1") == (ON, LEFT)
    assert held_relations(toy_scene(), "cube_1") == ()


def test_denied_supports_are_left_out() -> None:
    assert hold_supports(scene_with(DENIED)).object("cube_1").placement.on == TABLE
    for scene in (scene_with(), scene_with(HELD), toy_scene()):
        assert hold_supports(scene) is scene


def test_outcomes_are_recorded_with_the_true_supports() -> None:
    scene = record_relations(scene_with())
    assert scene.report is not None
    found = {o.kind: o.holds for o in scene.report.relations}
    assert found == {"on": False, "left_of": True}
    assert scene.object("cube_1").placement.on == TABLE


@pytest.mark.parametrize(("height", "support"), [(0.74, TABLE), (0.77, "book_1")])
def test_a_thing_rests_on_what_it_touches(height: float, support: str) -> None:
    cube = toy_object("cube_1", (0.05, 0.05, 0.05), (0.1, 0.0), top=height)
    book = toy_object("book_1", (0.2, 0.14, 0.03), (0.1 if height > 0.74 else 0.4, 0.0))
    scene = toy_scene((cube, book)).replace(report=Report(0.0, 0.0, 0.0))
    assert record_relations(scene).object("cube_1").placement.on == support


def test_edits_of_the_plan_keep_its_groups_in_order() -> None:
    scene = scene_with(HELD)
    new = PlannedObject("die_1", "die", "die", relations=held_relations(scene, "cube_1"))
    swapped = swap_in_plan(scene, "cube_1", new).plan
    assert swapped is not None and swapped.groups[0].members == ("die_1", "can_1")
    assert swapped.objects[0].relations == (LEFT,)
    for edited in (remove_from_plan(scene, ["can_1"]), move_in_plan(scene, "can_1", ())):
        assert edited.plan is not None and edited.plan.groups == ()
