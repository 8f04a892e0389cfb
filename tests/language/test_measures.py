"""Lengths, distances and numbers of a text."""

from __future__ import annotations

import pytest
from plans import all_related, plan


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
