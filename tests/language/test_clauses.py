"""Clauses without a subject, pronouns as subjects, and negated places."""

from __future__ import annotations

import pytest
from plans import all_related, counts, found, plan, related


@pytest.mark.parametrize(
    ("text", "named"),
    [
        ("Picnic for four with sandwiches, apples and a thermos.",
         {"sandwich", "apple", "thermos"}),
        ("Dinner for two with a steak, a salad and a bottle of red wine.",
         {"steak", "salad", "wine_bottle"}),
        ("A table for two with a vase.", {"vase"}),
        ("Tea for two with a cake.", {"cake"}),
        ("Lunch for three with a pizza and a jug of lemonade.", {"pizza", "pitcher"}),
    ],
)  # fmt: skip
def test_what_a_meal_for_people_has_is_there(text: str, named: set[str]) -> None:
    assert named <= counts(text).keys()


def test_it_is_what_the_sentence_before_spoke_of() -> None:
    planned = plan("There is a mug. It is red. It stands on a book.")
    assert found(planned, "mug_1").attributes == {"color": "red"}
    assert related(planned, "mug_1") == {("on", "book_1")}


@pytest.mark.parametrize(
    ("text", "relation"),
    [
        ("A laptop stands on the desk. It is next to a lamp.",
         ("laptop_1", "next_to", "desk_lamp_1")),
        ("There is a basket. It contains three apples.", ("apple_3", "in", "basket_1")),
        ("A tray is in the middle and a bell is left of it; it is behind a cup.",
         ("desk_bell_1", "behind", "mug_1")),
        ("A book lies on a desk. Next to a lamp.", ("book_1", "next_to", "desk_lamp_1")),
    ],
)  # fmt: skip
def test_a_pronoun_has_a_place(text: str, relation: tuple[str, str, str]) -> None:
    assert relation in all_related(text)


def test_they_are_all_of_them() -> None:
    for text in ("There are two mugs. They are blue.", "A mug and a plate. They are blue."):
        assert [o.attributes["color"] for o in plan(text).objects] == ["blue", "blue"]
    apart = plan("There are two mugs. They are red and blue.").objects
    assert [o.attributes["color"] for o in apart] == ["red", "blue"]


def test_it_is_the_table_where_nothing_else_was_named() -> None:
    planned = plan("A round table. It is white. It has a vase in the middle and two mugs.")
    assert (planned.table.outline, planned.table.color) == ("round", "white")
    assert related(planned, "vase_1") == {("center", "table")}
    assert len(planned.objects) == 3


def test_colours_listed_after_a_verb_say_how_many_there_are() -> None:
    objects = plan("The cups are red, green and blue.").objects
    assert [o.attributes["color"] for o in objects] == ["red", "green", "blue"]


@pytest.mark.parametrize(
    ("text", "relations"),
    [
        ("The spoon is not in the bowl but next to it.", {("spoon_1", "next_to", "bowl_1")}),
        ("A plate stands there. The spoon is not in the bowl but behind it.",
         {("spoon_1", "behind", "bowl_1")}),
        ("A pencil that is not in the pencil case, but beside the ruler.",
         {("pencil_1", "next_to", "ruler_1")}),
        ("There is a knife, not on the board but to its left.",
         {("knife_1", "left_of", "cutting_board_1")}),
        ("A vase and a book, neither of which is on the tray.", set()),
    ],
)  # fmt: skip
def test_a_thing_is_where_it_is_instead(text: str, relations: set[tuple[str, str, str]]) -> None:
    assert all_related(text) == relations


def test_what_a_thing_is_not_on_is_there() -> None:
    assert counts("The mug is not on the tray.") == {"mug": 1, "tray": 1}
    assert counts("A net that is not in the water.") == {"landing_net": 1}


def test_a_place_that_cannot_be_told_does_not_take_its_things_along() -> None:
    assert counts("In front of the middle one is a mustard bottle.") == {"mustard_bottle": 1}
