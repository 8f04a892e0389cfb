"""Quantifiers: everything, all, half, the rest, at least."""

from __future__ import annotations

import pytest
from plans import all_related, counts, plan


def colors(text: str) -> list[str | None]:
    return [o.attributes.get("color") for o in plan(text).objects]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Everything except the fork is on the tray: a plate, a cup, a fork and a knife.",
         {("plate_1", "on", "tray_1"), ("mug_1", "on", "tray_1"), ("knife_1", "on", "tray_1")}),
        ("A plate, a cup and a fork. Everything except the fork is on the tray.",
         {("plate_1", "on", "tray_1"), ("mug_1", "on", "tray_1")}),
        ("All the things but the spoon are in the box: a pen, a coin and a spoon.",
         {("pen_1", "in", "box_1"), ("coin_1", "in", "box_1")}),
        ("A pen and a coin. All of them are in a bowl.",
         {("pen_1", "in", "bowl_1"), ("coin_1", "in", "bowl_1")}),
        ("Five books. Two of them lie on a box.",
         {("book_1", "on", "box_1"), ("book_2", "on", "box_1")}),
        ("I keep three pens: two are in the mug, and the third lies on the notebook.",
         {("pen_1", "in", "mug_1"), ("pen_2", "in", "mug_1"), ("pen_3", "on", "notebook_1")}),
    ],
)  # fmt: skip
def test_all_but_some_have_a_place(text: str, expected: set[tuple[str, str, str]]) -> None:
    assert all_related(text) == expected


def test_a_place_without_a_subject_is_that_of_the_last_one() -> None:
    text = "A skull rests on two books, a candle stands behind it, and to its left an hourglass."
    expected = {("candle_1", "behind", "skull_1"), ("hourglass_1", "left_of", "skull_1")}
    assert expected <= all_related(text)
    assert ("skull_1", "behind", "candle_1") not in all_related(text)


def test_what_is_excepted_is_there() -> None:
    text = "Everything except the fork is on the tray: a plate, a cup, a fork and a knife."
    assert counts(text) == {"plate": 1, "mug": 1, "fork": 1, "knife": 1, "tray": 1}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("All mugs are red. There are three mugs.", ["red"] * 3),
        ("All the cups are blue. Four cups and a teapot.", ["blue"] * 4 + [None]),
        ("Plates are always white. A plate and a bowl stand there.", ["white", None]),
        ("Half of the apples are red. There are four apples.", ["red", "red", None, None]),
        ("There are four apples. Half of them are red.", ["red", "red", None, None]),
        ("Four mugs. Half of the mugs are white, the other half are black.",
         ["white", "white", "black", "black"]),
        ("Six cubes. Two of them are red, the rest are blue.", ["red"] * 2 + ["blue"] * 4),
        ("Three mugs: one is red, the others are white.", ["red", "white", "white"]),
    ],
)  # fmt: skip
def test_some_of_them_have_a_colour(text: str, expected: list[str | None]) -> None:
    assert colors(text) == expected


def test_new_things_beside_those_that_have_their_place_are_new() -> None:
    there = counts("The mugs are on the tray. Then a mug is next to the tray.")
    assert there == {"mug": 2, "tray": 1}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("No more than three books and at least two pens.", {"book": 3, "pen": 2}),
        ("A cup with at least three pencils.", {"mug": 1, "pencil": 3}),
        ("Up to four spoons next to a bowl.", {"spoon": 4, "bowl": 1}),
    ],
)
def test_bounds_are_numbers(text: str, expected: dict[str, int]) -> None:
    assert counts(text) == expected


def test_at_least_is_no_place() -> None:
    assert all_related("No more than three books and at least two pens.") == set()


def test_the_others_are_not_the_one_that_was_told_of() -> None:
    planned = plan("Three jars. The middle one holds cotton buds, the others are open.")
    states = [o.attributes.get("state") for o in planned.objects if o.category.endswith("jar")]
    assert states == ["open", None, "open"]


def test_the_middle_one_of_three() -> None:
    assert all_related("Three trays. Behind the middle tray stands a jar.") == {
        ("jar_1", "behind", "tray_2"),
    }  # fmt: skip
