"""Requests as people write them: numbers in brackets, "everyone gets", titles, orders, asides."""

from __future__ import annotations

import contextlib

import pytest
from plans import all_related, counts

from generator.errors import TabletopError
from generator.language.planner import plan_scene


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("pens (5 blue, 2 red)", {"pen": 7}),
        ("candles (4) around a vase", {"candle": 4, "vase": 1}),
        ("small plates - four to six - and a bowl", {"plate": 4, "bowl": 1}),
        ("two plates with a fried egg on each", {"plate": 2, "fried_egg": 2}),
        ("four mugs with a spoon in each of them", {"mug": 4, "spoon": 4}),
        ("a pair of tweezers and a pair of shoes", {"tweezers": 1, "shoe": 2}),
        ("lay the table for three. Everyone gets a plate and a cup", {"plate": 3, "mug": 3}),
        ("a tall vase at the back and two short ones in front of it", {"vase": 3}),
        ("pumpkins! a big one and two little ones", {"pumpkin": 3}),
        ("three blocks: a small, a medium and a large one", {"toy_block": 3}),
        ("Shaving kit: a razor and a mug", {"razor": 1, "mug": 1}),
        ("Dominoes: a mug and two dice", {"mug": 1, "die": 2}),
        ("a mug and a plate, but leave out the spoons", {"mug": 1, "plate": 1}),
        ("500 g of flour and a mug", {"flour_bag": 1, "mug": 1}),
        ("a two-tier cake stand", {"cake_stand": 1}),
        ("a table with four chairs and a bowl", {"bowl": 1}),
        ("a mug, otherwise a cup of nothing at all possible", {"mug": 1}),
    ],
)  # fmt: skip
def test_counts(text: str, expected: dict[str, int]) -> None:
    assert counts(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a lamp behind a stack of three books, a mug in front of the stack",
         ("mug_1", "in_front_of", "book_1")),
        ("a mug with a book behind", ("book_1", "behind", "mug_1")),
        ("a candle in the middle, a plate to the left", ("plate_1", "left_of", "candle_1")),
        ("a drill left of a box, and a brick in front of both",
         ("building_brick_1", "in_front_of", "box_1")),
        ("a razor, a mug and a comb, all on a tray", ("razor_1", "on", "tray_1")),
        ("a plank with a ruler across it", ("ruler_1", "on", "plank_1")),
        ("three bowls from the largest to the smallest, with a strawberry in the smallest",
         ("strawberry_1", "in", "bowl_1")),
        ("a hammer in a toolbox", ("hammer_1", "in", "toolbox_1")),
    ],
)  # fmt: skip
def test_relations(text: str, expected: tuple[str, str, str]) -> None:
    assert expected in all_related(text)


def test_things_ordered_by_size_have_different_sizes() -> None:
    plan = plan_scene("three bowls ordered from large to small", 0)
    sizes = {o.name: max(o.size or (0.0,)) for o in plan.objects}
    (row,) = plan.groups
    assert row.kind == "row"
    ordered = [sizes[name] for name in row.members]
    assert ordered == sorted(ordered, reverse=True) and len(set(ordered)) == 3


def test_the_largest_of_a_stack_is_at_the_bottom() -> None:
    plan = plan_scene("a stack of four books ordered by size", 0)
    sizes = {o.name: max(o.size or (0.0,)) for o in plan.objects}
    for planned in plan.objects:
        for relation in planned.relations:
            assert sizes[planned.name] < sizes[relation.target]


@pytest.mark.parametrize(
    "text",
    ["the smallest with a mug", "in the middle one a mug and the biggest", "both (3) of each",
     "one with the other on each", "everyone gets", "a pair of", "per person per person"],
)  # fmt: skip
def test_scraps_are_no_foreign_exception(text: str) -> None:
    with contextlib.suppress(TabletopError):
        plan_scene(text, 0)
