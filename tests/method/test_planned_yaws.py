"""Yaws from the drawing are applied to shapes from the plan."""

import numpy as np
import pytest
from test_planned import TEXT, Found, by_name

from generator.geometry import wrap
from generator.layout import build_models, lay_out
from generator.method.planned import SceneDraft, Turn, draft_scene, lay_out_draft
from generator.method.planned.draft import ALIKE
from generator.pipeline import generate
from generator.scene import Model, Rotation

YAW = 0.6
NAME = "seen_laptop_1"
UNTOLD = "which the drawing does not show"


def drafted(turn: Turn | None = None, margin: float = 1.0) -> SceneDraft:
    """Return a laptop with yaw ``YAW`` and a shape four times too high."""
    found = Found(TEXT)
    tall = by_name(found.placements)[NAME].scale * [1, 1, 4]
    found.change(NAME, scale=tall, yaw=YAW)
    known = {NAME: Rotation(NAME, YAW, 0.1, margin=margin)}
    return draft_scene(
        found.plan, found.instances, found.models, found.placements, found.table_scale, 0, ALIKE,
        known, turn,
    )  # fmt: skip


def looked(yaw: float, margin: float, order: int = 1) -> Turn:
    def turn(name: str, model: Model) -> Rotation:
        assert name == NAME and model.orientation is not None
        np.testing.assert_allclose(model.orientation[0, 0], np.cos(YAW))
        return Rotation(name, yaw, 0.1, margin=margin, order=order)

    return turn


def test_fronts_are_the_same_for_all_shapes() -> None:
    draft = drafted()
    assert draft.models[NAME] is draft.planned[NAME]
    assert draft.shown[NAME].yaw == YAW == draft.yaws[NAME]
    (said,) = (w for w in draft.warnings if NAME in w)
    assert "built from the plan: the object's outline" in said and UNTOLD not in said


@pytest.mark.parametrize(
    ("turn", "margin", "yaw"),
    [
        (looked(YAW + 0.1, 0.0), 1.0, YAW),  # the plan's shape says the same
        (looked(YAW + np.pi, 0.3, order=2), 0.0, YAW),  # and from behind
        (looked(YAW + 3.0, 1.0), 1.0, YAW + 3.0),  # the shapes have other fronts
        (looked(YAW + 0.1, 0.05), 0.05, None),  # neither is sure
        (looked(YAW + 1.0, 0.3), 1.0, None),  # they contradict one another
    ],
)
def test_a_yaw_counts_if_the_plans_shape_shows_it(
    turn: Turn, margin: float, yaw: float | None
) -> None:
    draft = drafted(turn, margin)
    said = " ".join(w for w in draft.warnings if NAME in w)
    if yaw is None:
        assert NAME not in draft.yaws and UNTOLD in said
        assert abs(draft.shown[NAME].yaw) < 0.3  # as laptops usually stand
    else:
        assert draft.shown[NAME].yaw == pytest.approx(yaw) == draft.yaws[NAME]
        assert UNTOLD not in said


def test_what_is_doubted_keeps_its_yaw_at_another_place() -> None:
    found = Found(TEXT)
    found.change("seen_stapler_1", yaw=YAW)
    draft = found.draft().doubt({"seen_stapler_1"}, "it does not stand")
    laid = lay_out_draft(draft, 0)
    assert by_name(laid.placements)["seen_stapler_1"].yaw == YAW
    assert "seen_stapler_1 is built from the plan: it does not stand." in laid.draft.warnings
    assert any("instead of as drawn: seen_stapler_1" in w for w in laid.warnings)
    everything = lay_out_draft(draft.doubt({*draft.models}, "so"), 0)
    assert by_name(everything.placements)["seen_stapler_1"].yaw == YAW
    assert any("The planned table is used" in w for w in everything.warnings)


def test_members_of_groups_are_arranged_as_a_whole() -> None:
    found = Found("A table set for two: a plate, a fork on the left and a knife on the right")
    asked: list[str] = []

    def turn(name: str, model: Model) -> Rotation:
        asked.append(name)
        return Rotation(name, 0.0, 0.1)

    forks = [found.names[o.name] for o in found.plan.objects if o.noun == "fork"]
    found.change(forks[0], scale=by_name(found.placements)[forks[0]].scale * [1, 6, 1])
    facts = found.plan, found.instances, found.models, found.placements, found.table_scale
    draft = draft_scene(*facts, 0, ALIKE, {}, turn)
    assert asked == [] and not {*forks} & {*draft.yaws}
    reasons = [w for w in draft.warnings if w.split()[0] in forks]
    assert ["planned proportions" in w for w in sorted(reasons)].count(True) == 1
    assert sum("match the other place settings" in w for w in reasons) == 1


def test_another_table_is_told() -> None:
    found = Found(TEXT)
    found.table_scale = found.table_scale * [2, 2, 1]
    assert any("table has the planned size" in w for w in found.draft().warnings)


@pytest.mark.slow
def test_a_tool_lies_in_the_scene_as_in_the_drawing() -> None:
    """The paper's example (Fig. 8): the hammer's shape is the plan's, its yaw the drawing's."""
    text, seed = "A hobby desk with some model cars and tools.", 0
    made = generate(text, seed=seed)
    plan = made.reference.plan
    assert plan is not None
    drawn = {p.name: p.yaw for p in lay_out(plan, build_models(plan, seed), seed + 1)[0].placements}
    hammer = made.scene.object("hammer_1")
    assert abs(wrap(hammer.placement.yaw - drawn["hammer_1"])) < np.deg2rad(10)
    assert any("hammer_1 is built from the plan" in w for w in made.scene.provenance.warnings)
