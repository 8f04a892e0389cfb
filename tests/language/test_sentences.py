"""What a sentence asks for stands in its plan, and nothing else."""

from __future__ import annotations

from collections import Counter

import pytest

from generator.language.planner import plan_scene
from generator.scene import PlannedObject, ScenePlan


def plan(text: str) -> ScenePlan:
    return plan_scene(text, 0)


def counts(text: str) -> dict[str, int]:
    things = plan(text).objects
    return dict(Counter(o.category if o.category != "generic" else o.noun for o in things))


def related(planned: ScenePlan, name: str) -> set[tuple[str, str]]:
    return {(r.kind, r.target) for r in found(planned, name).relations}


def found(planned: ScenePlan, name: str) -> PlannedObject:
    return next(o for o in planned.objects if o.name == name)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a pizza but no plates", {"pizza": 1}),
        ("three mugs in different colours", {"mug": 3}),
        ("a glass of blue liquid", {"glass": 1}),
        ("a chopping board and two food containers for meal prep",
         {"cutting_board": 1, "food_container": 2}),
        ("a plate with nothing on it", {"plate": 1}),
        ("a table without any chairs, with a vase", {"vase": 1}),
        ("a yellow and white mug and a white mug", {"mug": 2}),
        ("a photo of a vase", {"picture_frame": 1}),
        ("a mug with a picture of a cat", {"mug": 1}),
        ("a cake stand with cupcakes", {"cake_stand": 1, "cupcake": 2}),
        ("three pancakes on a plate", {"pancakes": 1, "plate": 1}),
        ("a candle and five marbles, but not the lighter", {"candle": 1, "marbles": 5}),
        ("four spoons of various sizes", {"spoon": 4}),
        ("three bowls, each with two apples", {"bowl": 3, "apple": 6}),
    ],
)
def test_counts(text: str, expected: dict[str, int]) -> None:
    assert counts(text) == expected


def test_what_is_full_holds_several() -> None:
    assert counts("a basket full of lemons for the market")["lemon"] in (4, 5)


def test_different_colours_and_sizes() -> None:
    mugs = plan("three mugs in different colours").objects
    assert len({o.attributes["color"] for o in mugs}) == 3
    assert {o.attributes["color"] for o in plan("three mugs in red").objects} == {"red"}
    sizes = [o.attributes["size"] for o in plan("three bowls of different sizes").objects]
    assert sizes == ["small", "medium", "large"]


def test_a_table_for_two_by_candlelight() -> None:
    assert counts("dinner for two by candlelight") == {
        "plate": 2, "fork": 2, "knife": 2, "glass": 2, "candle": 1,
    }  # fmt: skip


def test_one_thing_on_several_books_makes_a_stack_of_them() -> None:
    planned = plan("a monitor on two books")
    assert related(planned, "book_2") == {("on", "book_1")}
    assert related(planned, "monitor_1") == {("on", "book_2")}


@pytest.mark.parametrize(
    ("text", "phrase"),
    [
        ("a desk with a mug, love and happiness", "love"),
        ("a desk with a mug, love and happiness", "happiness"),
        ("a bowl of apples and a sense of order", "sense"),
    ],
)
def test_what_is_no_thing_is_not_understood(text: str, phrase: str) -> None:
    planned = plan(text)
    assert f"Not understood: {phrase!r}." in planned.warnings
    assert all(o.category != "generic" for o in planned.objects)


@pytest.mark.parametrize(
    ("text", "family"),
    [
        ("a bicycle", "vehicle"), ("a zither", "stringed"), ("a flugelhorn", "rod"),
        ("a dishwasher", "appliance"), ("a bun", "bread"), ("a pomegranate", "fruit"),
        ("a waistcoat", "cloth"), ("a seismograph", "device"),
    ],
)  # fmt: skip
def test_a_strange_thing_has_the_family_of_its_kind(text: str, family: str) -> None:
    (thing,) = plan(f"{text} on a table").objects
    assert (thing.category, thing.family) == ("generic", family)


@pytest.mark.parametrize(
    ("text", "warning"),
    [
        ("a grapefruit", "The catalogue has no 'grapefruit'; it is shown as 'orange'."),
        ("a zither on a desk", "The catalogue has no 'zither'; a plain shape"),
        ("2 moniters and a keybord", "Read 'moniters' as 'monitors'."),
    ],
)
def test_changed_words_are_warned_of(text: str, warning: str) -> None:
    assert any(w.startswith(warning) for w in plan(text).warnings)


@pytest.mark.parametrize(
    "text",
    ["a towel", "two drinking glasses", "a breadboard", "a nail file", "a moka pot",
     "a standing mirror", "poker chips", "mugs of various sizes"],
)  # fmt: skip
def test_known_words_need_no_warning(text: str) -> None:
    assert plan(text).warnings == ()
