"""The cloud reasoner's plans have the type and quality of the embedded planner's."""

import json
from collections import Counter

import pytest
from expected_plans import EXPECTED, Expected, group, thing
from extent import part_of
from openai_server import Running

from generator.backends.cloud.questions.plan_text import in_words
from generator.backends.cloud.reasoner import CloudReasoner
from generator.composition import compose
from generator.errors import InputError
from generator.language.planner import plan_scene
from generator.scene import ScenePlan

ENGLISH = [e for e in EXPECTED if e.english]
LIGHT = [e for e in EXPECTED if len(e.things) < 13]
"""Without the dozen eggs, which are simulated for 10 s: they settle in test_settled.py."""


def name(expected: Expected) -> str:
    return expected.text[:40]


def check(plan: ScenePlan, expected: Expected) -> None:
    """Check the requirements on a plan from any planner."""
    kinds = {o.name: o.category for o in plan.objects} | {"table": "table"}
    assert Counter(o.category for o in plan.objects) == expected.counts
    found = Counter(
        (o.category, r.kind, kinds[r.target]) for o in plan.objects for r in o.relations
    )
    if not expected.order:  # said in several ways
        assert found == expected.relations
    groups = [(g.kind, len(g.members), g.seat, kinds.get(str(g.around))) for g in plan.groups]
    assert groups == expected.groups
    for planned in plan.objects:
        wanted = expected.looks.get(planned.category, {})
        assert wanted.items() <= planned.attributes.items()
    stand_ins = [o for o in plan.objects if o.category == "generic"]
    assert all(o.family and o.size for o in stand_ins)
    assert bool(stand_ins) == any("plain shape" in warning for warning in plan.warnings)
    assert plan.table.outline == expected.table.get("outline", "rectangle")


def check_settled(plan: ScenePlan, expected: Expected) -> None:
    """Check that every object exists and that the requested relations hold."""
    scene = compose(plan, 0)
    assert scene.report is not None and scene.report.passed
    assert Counter(o.model.category for o in scene.objects) == expected.counts
    assert [o for o in scene.report.relations if not o.holds] == []
    across = {o.model.category: float(o.pose.position[0]) for o in scene.objects}
    assert [across[c] for c in expected.order] == sorted(across[c] for c in expected.order)


def answer(server: Running, expected: Expected) -> None:
    server.script.chat = lambda request: json.dumps(expected.answer())


@pytest.mark.parametrize("expected", ENGLISH, ids=name)
def test_the_embedded_planner_gives_it(expected: Expected) -> None:
    check(plan_scene(expected.text, 0), expected)


@pytest.mark.parametrize("expected", EXPECTED, ids=name)
def test_the_cloud_reasoner_gives_it(
    server: Running, reasoner: CloudReasoner, expected: Expected
) -> None:
    answer(server, expected)
    check(reasoner.plan_scene(expected.text, 0), expected)
    (request,) = server.script.requests
    assert expected.text in request.text and "in English" in request.text


@pytest.mark.slow
@pytest.mark.parametrize("expected", part_of(ENGLISH, *(e for e in LIGHT if e.english)), ids=name)
def test_the_embedded_plan_settles_as_asked(expected: Expected) -> None:
    check_settled(plan_scene(expected.text, 0), expected)


@pytest.mark.slow
@pytest.mark.parametrize("expected", part_of(EXPECTED, *LIGHT), ids=name)
def test_the_cloud_plan_settles_as_asked(
    server: Running, reasoner: CloudReasoner, expected: Expected
) -> None:
    answer(server, expected)
    check_settled(reasoner.plan_scene(expected.text, 0), expected)


def test_a_foreign_text_is_for_the_cloud_alone() -> None:
    (foreign,) = [e for e in EXPECTED if not e.english]
    with pytest.raises(InputError, match="--reasoner cloud"):
        plan_scene(foreign.text, 0)


# ---------------------------------------------------------------------------------------- hostile
MUGS = [thing(n, "mug") for n in (1, 2, 3)]


@pytest.mark.parametrize(
    ("things", "groups", "told"),
    [
        (MUGS, [group("row", 1, 9)], "contains 9, which is not the number of an object"),
        (MUGS, [group("row", 1, 1)], "contains an object twice"),
        (MUGS, [group("row", 1, 2), group("heap", 2, 3)], "or one of another group"),
        (MUGS, [group("circle", 1, 2, around=2)], "contains an object twice"),
        (MUGS, [group("row", 1, 2, around=3)], "only a circle can"),
        (MUGS, [group("row", 1, 2, seat=(1, 2))], "a setting must have a seat"),
        (MUGS, [group("setting", 1, 2)], "a setting must have a seat"),
        (MUGS, [group("setting", 1, 2, seat=(3, 2))], "seats must be numbered"),
        (
            MUGS,
            [group("setting", 1, seat=(1, 2)), group("setting", 2, seat=(1, 2))],
            "each number once",
        ),
        (
            MUGS,
            [group("setting", 1, seat=(1, 2)), group("setting", 2, seat=(2, 3))],
            "the same count",
        ),
        (MUGS, [group("setting", 1, 2, seat=(1, 10**9))], "groups.0.seat.count"),
        (MUGS, [group("spiral", 1, 2)], "groups.0.kind"),
        (MUGS, [group("row")], "groups.0.things"),
        (MUGS, [group("row", *range(1, 60))], "groups.0.things"),
        (MUGS, [group("row", 1, 2)] * 50, "groups:"),
        ([thing(n, "egg") for n in range(1, 60)], [], "things:"),
        ([thing(1, "杯子")], [], "must be in English"),
        ([thing(1, "mug", contents="x" * 100)], [], "things.0.contents"),
        ([thing(1, "mug", accent="\u202ered")], [], "things.0.accent"),
        ([thing(1, "book", ("left_of", 2)), thing(2, "mug", ("left_of", 1))], [], "contradict"),
    ],
)
def test_a_hostile_answer_is_asked_again(
    server: Running, reasoner: CloudReasoner, things: list, groups: list, told: str
) -> None:
    bad = Expected("", {}, things, groups_answered=groups).answer()
    good = Expected("", {}, MUGS).answer()

    def chat(request: object) -> str:
        return json.dumps(bad if len(server.script.requests) == 1 else good)

    server.script.chat = chat
    assert len(reasoner.plan_scene("mugs", 0).objects) == 3
    assert told in server.script.requests[1].text


def test_too_long_a_thing_is_shortened_and_said(server: Running, reasoner: CloudReasoner) -> None:
    answer(server, Expected("", {}, [thing(1, "ruler", size_cm=[600, 30, 3])]))
    plan = reasoner.plan_scene("a ruler of 6 m", 0)
    assert plan.objects[0].size == pytest.approx((0.6, 0.03, 0.003))
    assert "A ruler of 6 m is too long for a table; it was scaled to 0.6 m." in plan.warnings


def test_old_answers_without_groups_are_read(server: Running, reasoner: CloudReasoner) -> None:
    told = Expected("", {}, [{k: v for k, v in thing(1, "mug").items() if k != "accent"}]).answer()
    server.script.chat = lambda request: json.dumps(
        {k: v for k, v in told.items() if k != "groups"}
    )
    assert reasoner.plan_scene("a mug", 0).groups == ()


def test_an_image_model_is_told_the_groups() -> None:
    laid = next(e for e in EXPECTED if e.text == "a table set for two")
    _, told = in_words(plan_scene(laid.text, 0))
    assert "1. the plate (number 1 of 2)\n" in told
    assert "Things 5, 6, 7, 8 are laid for a person at the back edge" in told
    _, told = in_words(plan_scene("four candles in a circle around a vase", 0))
    assert told.endswith("Things 1, 2, 3, 4 stand in a circle around thing 5.")


def test_an_image_model_is_told_contents_once() -> None:
    _, told = in_words(plan_scene("a glass of orange juice and a mug with a picture of a cat", 0))
    assert told == "1. the glass of orange juice\n2. the mug with picture"
