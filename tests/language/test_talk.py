"""Colloquial texts: corrections, asides, answers, tasks for robots, step-by-step descriptions."""

from __future__ import annotations

from collections import Counter

import pytest
from plans import all_related, counts

from generator.language.planner import plan_scene
from generator.language.words.dictionary import is_adjective, is_finite, is_verb


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Two cups and a plate - no wait, make that three cups.", {"mug": 3, "plate": 1}),
        ("Six candles on a tray, sorry, eight.", {"candle": 8, "tray": 1}),
        ("a bowl of apples, actually make it pears, next to a jug",
         {"bowl": 1, "pear": 2, "pitcher": 1}),
        ("a pile of five records, no wait, make it four", {"vinyl_record": 4}),
        ("grapes in a bowl, and some mugs - kidding, no mugs", {"grapes": 1, "bowl": 1}),
        ("no plates, just a pizza", {"pizza": 1}),
        ("Two cups and a plate. No cups please.", {"plate": 1}),
        ("I work from the spare room. A laptop, I hate mess.", {"laptop": 1}),
        ("The iron? Leave it in the cupboard. A mug.", {"mug": 1}),
        ("A mug. The sugar bowl that usually comes along should be left out.", {"mug": 1}),
        ("Can you show a mug?", {"mug": 1}),
        ("Four pints of lager, a beer mat under every one of them",
         {"pint_glass": 4, "beer_mat": 4}),
        ("glue sticks and safety scissors, three of each", {"glue_stick": 3, "scissors": 3}),
        ("a candle in every corner of the table", {"candle": 4}),
        ("cookie cutters (star, heart, moon) and a mug", {"cookie_cutter": 3, "mug": 1}),
        ("forks x4, a 3x3 grid of cupcakes", {"fork": 4, "cupcake": 9}),
        ("half a dozen eggs and a baker's dozen of cookies", {"egg": 6, "cookie": 13}),
        ("two tomatoes, radish slices", {"tomato": 2, "radish": 2}),
        ("Two places laid side by side: a plate each, a fork to the left", {"plate": 2, "fork": 2}),
        ("Books in one stack on the tray (there are 5)", {"book": 5, "tray": 1}),
        ("four bottles, one at each corner; next to each bottle a notepad with a pen on it",
         {"bottle": 4, "notebook": 4, "pen": 4}),
        ("two forks, one on either side of a plate", {"fork": 2, "plate": 1}),
    ],
)  # fmt: skip
def test_counts(text: str, expected: dict[str, int]) -> None:
    assert counts(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A laptop with a mouse on the left, or rather on the right.",
         ("computer_mouse_1", "right_of", "laptop_1")),
        ("Put a vase in the middle. No wait, put it in the back left corner. A mug.",
         ("vase_1", "left_of", "table")),
        ("a cup in the middle. To the left, a book.", ("book_1", "left_of", "mug_1")),
        ("A red cube. Left of it: a green cube. Right of it: a blue cube.",
         ("cube_3", "right_of", "cube_1")),
        ("The milk bottle stands behind the bowl", ("milk_bottle_1", "behind", "bowl_1")),
        ("A gnome watches a mug. The books are piled on a tray", ("book_1", "on", "tray_1")),
        ("crate front left, a mug", ("crate_1", "in_front_of", "table")),
        ("a chessboard dead centre", ("chess_board_1", "center", "table")),
        ("Left to right: a mug, a bowl and a vase", ("mug_1", "left_of", "bowl_1")),
        ("Behind a board, from left to right, are a mug and a vase",
         ("mug_1", "left_of", "vase_1")),
        ("a dish, on which are two eggs", ("egg_2", "on", "bowl_1")),
        ("a laptop, chopsticks lie to the laptop's right",
         ("chopsticks_1", "right_of", "laptop_1")),
        ("Three plates in a row. The first has a muffin on it, the third two cookies",
         ("cookie_2", "on", "plate_3")),
        ("Two plates, the left one with a muffin. A fork in front of the empty one",
         ("fork_1", "in_front_of", "plate_2")),
        ("Pick the corn from the plate and place it into the bowl", ("corn_1", "on", "plate_1")),
        ("BACK ROW\n- toaster\nFRONT ROW\n- mug", ("toaster_1", "behind", "table")),
        ("a laptop and a lamp; a mug between the two", ("mug_1", "next_to", "desk_lamp_1")),
        ("six cups round a teapot", ("mug_1", "next_to", "teapot_1")),
        ("a teapot, the sugar bowl left of the teapot, the milk jug on its other side",
         ("pitcher_1", "right_of", "teapot_1")),
        ("everything on a tray: a mug, a vase", ("vase_1", "on", "tray_1")),
        ("the comb should not lie on the table but on a towel", ("comb_1", "on", "folded_towel_1")),
    ],
)  # fmt: skip
def test_relations(text: str, expected: tuple[str, str, str]) -> None:
    assert expected in all_related(text)


@pytest.mark.parametrize(
    ("text", "absent"),
    [
        ("Pick up the cream cheese box and put it in the basket", "in"),
        ("Push the toy car towards the cone", "next_to"),
        ("The robot has to put the mug on the rack", "on"),
    ],
)
def test_a_robot_is_told_where_things_go_and_they_are_not_there_yet(text: str, absent: str) -> None:
    assert absent not in {kind for _, kind, _ in all_related(text)}


def test_bottles_of_several_kinds_are_one_of_each() -> None:
    nouns = [
        o.noun for o in plan_scene("bottles of gin, rum and vermouth, all in one row", 0).objects
    ]
    assert nouns == ["bottle of gin", "bottle of rum", "bottle of vermouth"]


def test_colours_are_dealt_out_one_by_one() -> None:
    plan = plan_scene("a cake stand with macarons in pink, green and yellow, two of each colour", 0)
    colors = Counter(o.attributes.get("color") for o in plan.objects if o.category == "macaron")
    assert colors == {"pink": 2, "green": 2, "yellow": 2}


def test_what_is_only_told_is_named_as_not_understood() -> None:
    plan = plan_scene("A mug. My daughter hates onions.", 0)
    assert [o.category for o in plan.objects] == ["mug"]
    assert any("my daughter hates onions" in warning for warning in plan.warnings)


def test_texts_full_of_slips_are_read_and_told() -> None:
    text = "one candel on ether side of a vaze, fruit boll infront of it wiht 3 pears in"
    plan = plan_scene(text, 0)
    kinds = Counter(o.category for o in plan.objects)
    assert kinds["candle"] == 2 and kinds["pear"] == 3
    assert any("fruit bowl" in o.noun for o in plan.objects)
    assert any("'boll' as 'bowl'" in warning for warning in plan.warnings)


def test_parts_of_speech() -> None:
    assert is_verb("watches") and is_finite("watches") and not is_finite("glass")
    assert is_adjective("shallow") and not is_adjective("mug")
