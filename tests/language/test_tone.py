"""Statements about the whole table: theme, style, density and people."""

from __future__ import annotations

import pytest
from plans import counts, plan

from generator.errors import InputError


@pytest.mark.parametrize(
    "text",
    ["A desk that is not messy: a laptop and a pen.",
     "A desk, anything but cluttered, with a laptop.",
     "It shouldn't be too messy: a mug on a desk.",
     "A poster of a modern city on a desk."],
)  # fmt: skip
def test_what_is_denied_or_only_shown_is_no_style(text: str) -> None:
    planned = plan(text)
    assert (planned.style, planned.density) == ("plain", "normal")


def test_what_is_said_is_the_style() -> None:
    assert (plan("A messy desk with a mug").style, plan("A cartoon mug").style) == (
        "messy", "cartoon",
    )  # fmt: skip
    planned = plan("A minimalist desk, not cluttered, with a lamp.")
    assert (planned.style, planned.density) == ("minimalist", "sparse")
    assert plan("A mug, not in cartoon style").style == "plain"


_TOOLS = {"hammer": 1, "screwdriver": 1, "wrench": 1, "pliers": 1}


@pytest.mark.parametrize(
    ("text", "more"),
    [
        ("Some tools next to a picture of a kitchen.", {"picture_frame": 1}),
        ("A lab coat and some tools.", {"lab coat": 1}),
        ("This is not an office. A mug and some tools.", {"mug": 1}),
    ],
)
def test_a_theme_is_what_the_text_says_of_its_table(text: str, more: dict[str, int]) -> None:
    assert counts(text) == _TOOLS | more


def test_a_dinner_for_four_with_food_is_laid_for_four() -> None:
    there = counts("Dinner for four with bread, cheese and wine")
    assert there == {
        "bread_loaf": 1, "cheese": 1, "wine_bottle": 1,
        "plate": 4, "fork": 4, "knife": 4, "glass": 4,
    }  # fmt: skip


def test_what_the_text_lays_is_not_laid_again() -> None:
    there = counts("Dinner for two with a plate of cookies, a knife and four glasses.")
    assert (there["plate"], there["glass"]) == (3, 4)
    assert counts("A table for two with two plates and two forks.") == {"plate": 2, "fork": 2}


def test_a_table_laid_for_people_is_as_it_is_said_to_be() -> None:
    table = plan("A round white table set for four, a vase in the middle.").table
    assert (table.outline, table.color) == ("round", "white")


def test_a_game_for_two_is_no_meal() -> None:
    planned = plan("poker for two: a deck of cards in the middle, a mug, two dice, a lamp")
    assert len(planned.objects) == 5
    assert (
        "No places are laid for 2 people because the prompt does not describe a meal."
        in planned.warnings
    )


def test_too_many_people_are_told() -> None:
    assert "Not understood: 'for thirty people'." in plan("Dinner for thirty people.").warnings


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A table set for two: a plate, a wine glass, and a candle in the middle.",
         {"plate": 2, "wine_glass": 2, "candle": 1}),
        ("A table for three with a plate, a fork and a knife each.",
         {"plate": 3, "fork": 3, "knife": 3}),
        ("Dinner for three with a plate, a spoon and bread.",
         {"plate": 3, "spoon": 3, "bread_loaf": 1}),
        ("A meeting for five with notebooks and pens.", {"notebook": 3, "pen": 3}),
    ],
)  # fmt: skip
def test_each_gets_what_the_text_lays(text: str, expected: dict[str, int]) -> None:
    there = counts(text)
    assert there.keys() == expected.keys()
    if "plate" in expected:
        assert there == expected


def test_a_table_set_for_two_is_a_dining_table() -> None:
    assert plan("a table set for two").table.size[2] > 0.7
    assert counts("a dinner à la carte for two")["plate"] == 2


def test_what_no_thing_is_said_to_be_is_no_table() -> None:
    with pytest.raises(InputError, match="no known object"):
        plan("lying on its side")
