"""Lengths, distances and numbers of a text."""

from __future__ import annotations

import pytest
from plans import all_related, plan

from generator.errors import InputError


@pytest.mark.parametrize(
    ("text", "relations", "distance"),
    [
        ("A mug exactly 20 cm from the left edge of the table.",
         {("mug_1", "left_of", "table"), ("mug_1", "edge", "table")}, "20 cm"),
        ("Put the apple 5 cm behind the banana.", {("apple_1", "behind", "banana_1")}, "5 cm"),
        ("A vase 30 cm from the mug.", set(), "30 cm"),
        ("An apple, a fork 3 cm from it.", {("fork_1", "next_to", "apple_1")}, "3 cm"),
        ("The mug is 5 cm to the left of the plate.", {("mug_1", "left_of", "plate_1")}, "5 cm"),
        ("A cup, 10 cm away from the saucer, and a spoon.",
         {("mug_1", "next_to", "saucer_1")}, "10 cm away"),
        ("A book a few centimetres behind the plate.",
         {("book_1", "behind", "plate_1")}, "a few centimetres"),
        ("5 cm in front of the bowl is a spoon.", {("spoon_1", "in_front_of", "bowl_1")}, "5 cm"),
        ("Two candles 10 cm apart.", set(), "10 cm apart"),
    ],
)  # fmt: skip
def test_a_distance_is_no_size(
    text: str, relations: set[tuple[str, str, str]], distance: str
) -> None:
    planned = plan(text)
    assert all_related(text) == relations
    assert all(o.size is None for o in planned.objects)
    assert planned.warnings == (f"Not understood: {distance!r}.",)


@pytest.mark.parametrize(
    ("text", "longest"),
    [
        ("A mug 10 cm tall next to a plate.", 0.1),
        ("A plate about 20 cm in diameter, 5 cm from the front edge.", 0.2),
        ("A box 20 x 30 cm.", 0.3),
        ("A wooden cube 4 inches to a side.", 0.1016),
    ],
)
def test_a_size_is_no_distance(text: str, longest: float) -> None:
    size = plan(text).objects[0].size
    assert size is not None
    assert max(size) == pytest.approx(longest)


def test_a_half_more_is_no_tens() -> None:
    with pytest.raises(InputError, match=r"3\.5 oranges"):
        plan("3½ oranges")
    assert [o.noun for o in plan("½ lemon").objects] == ["half lemon"]


@pytest.mark.parametrize(
    ("text", "longest"),
    [
        ("a 3½ inch floppy disk", 0.0889),
        ("a ruler 12 1/2 inches long", 0.3175),
        ("a ¾ inch nut", 0.019),
        ("The mug is 12 cm tall.", 0.12),
    ],
)
def test_fractions_of_a_unit(text: str, longest: float) -> None:
    size = plan(text).objects[0].size
    assert size is not None
    assert max(size) == pytest.approx(longest, rel=0.01)


def test_miles_are_a_length() -> None:
    planned = plan("a 2 km long pencil")
    assert len(planned.objects) == 1
    assert planned.warnings == ("A pencil of 2000 m does not belong on a table; it is 0.6 m long.",)


@pytest.mark.parametrize(
    ("text", "size"),
    [
        ("a mug on a table 1.5 m long and 1 m wide", (1.5, 1.0, 0.74)),
        ("The table is 1.8 m long. A mug.", (1.8, 1.05, 0.74)),
        ("a mug on a table that is 1.4 m long and 95 cm high", (1.4, 0.817, 0.95)),
        ("a mug on a table 90 cm high", (1.2, 0.7, 0.9)),
    ],
)
def test_a_table_is_as_large_as_it_is_said_to_be(
    text: str, size: tuple[float, float, float]
) -> None:
    planned = plan(text)
    assert planned.table.size == size
    assert planned.objects[0].size is None
    assert planned.warnings == ()


@pytest.mark.parametrize(
    ("text", "warnings"),
    [
        ("a 3 m long oak table with a mug", 1),
        ("A 1 x 1 x 9 m table with a mug", 1),
        ("a table of 5 x 3 x 40 metres with a mug", 3),
        ("a mug on a table 3 m long", 1),
    ],
)
def test_a_table_that_is_made_smaller_is_told(text: str, warnings: int) -> None:
    found = plan(text).warnings
    assert len(found) == warnings
    assert all(warning.startswith("A table ") for warning in found)


def test_a_plastic_table_has_its_colour() -> None:
    table = plan("a mug on a purple plastic table").table
    assert (table.material, table.color) == ("plastic", "purple")
