"""Numbers of a text that the plan does not use end as warnings; those that it uses do not."""

import contextlib

import pytest

from generator.errors import InputError
from generator.language.planner import plan_scene
from generator.language.syntax.repairs.numbers import written_numbers


def unused(text: str) -> list[str]:
    begin, end = "The number ", " was not used."
    warnings = plan_scene(text, 0).warnings
    return [w[len(begin) + 1 : -len(end) - 1] for w in warnings if w.startswith(begin)]


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("a 50 kg mug", "50 kg"),
        ("a mug weighing 2 kg on a table", "2 kg"),
        ("a 2,5 kg weight plate", "2,5 kg"),
        ("a desk with sugar, 1 kg, and a bowl", "1 kg"),
        ("500 g of flour on a kitchen table", "500 g"),
        ("a bottle (500 ml) and 2 cups", "500 ml"),
        ("a 0.5 l bottle", "0.5 l"),
        ("a mug at 90°C", "90°C"),
        ("a mug rotated by 45 degrees", "45 degrees"),
        ("a ten kilogram dumbbell", "ten kilogram"),
        ("a bottle 8% full", "8%"),
        ("a $5 mug", "$5"),
        ("2 × 10^1 mugs", "2 × 10^1"),
        ("2^3 mugs", "2^3"),
        ("a 3-tier cake stand with cupcakes", "3-tier"),
        ("a 3-legged stool and a mug", "3-legged"),
        ('a 13" laptop', '13"'),
        ("a 30 x 20 cm tray", "20 cm"),
        ("pencils in 120 colours, a mug", "120"),
        ("4 stacks of five poker chips", "4"),
        ("a cup 2/3 full", "2/3"),
        ("4 mugs, each scaled by 0.5", "0.5"),
        ("6 mugs at scale 1.5", "1.5"),
    ],
)
def test_a_number_that_is_not_used_is_named(text: str, number: str) -> None:
    assert unused(text) == [number]


@pytest.mark.parametrize(
    "text",
    [
        "3 mugs and 2 plates",
        "25 eggs",
        "2-3 apples",
        "a dozen eggs and one mug",
        "1.5e1 mugs",
        "1.5 dozen eggs",
        "2 pairs of chopsticks",
        "a 3 x 3 grid of blocks",
        "forks x4",
        "mugs (there are 4)",
        "six plates, 2 of them blue",
        "5 coloured eggs (2 blue, 2 yellow, 1 pink)",
        "pens (5 blue, 2 red)",
        "four pints of lager",
        "a dining table for 4 people",
        "a 120 x 60 cm desk with a 20 cm tall vase",
        "a 75cm high desk with a mug",
        "a 27-inch monitor",
        "a ruler 12 1/2 inches long",
        "a 3½ inch floppy disk",
        "a half-full glass",
        "1. a mug\n2. a plate\n3. two forks",
        "1) a mug 2) a plate",
        "an iPhone 15 and a mug on a desk",
        "a can of WD-40 and a 7UP",
        "a 4K monitor",
        "an A4 sheet and a mug",
        "a desk in 1990 with a laptop",
        "at 8:30 a breakfast table with toast",
        "breakfast at 9 am: toast and a mug",
        "the 2nd of two mugs is blue",
        "a birthday table for a 5-year-old",
        "a table with 2 mugs, no, 3 mugs",
        "(on red_block_1 blue_block_2), (on blue_block_2 table)",
    ],
)
def test_a_number_that_is_used_or_says_nothing_is_not_named(text: str) -> None:
    assert unused(text) == []


@pytest.mark.parametrize(
    "text", ["The mug is 5 cm to the left of the plate.", "Two candles 10 cm apart."]
)
def test_a_number_is_named_once(text: str) -> None:
    (warning,) = plan_scene(text, 0).warnings
    assert warning.startswith("Not understood: ") and "cm" in warning


@pytest.mark.parametrize(
    ("text", "number"),
    [("10^9 mugs on a desk", "10^9"), ("a bottle 80% full and a mug", "80%")],
)
def test_a_number_that_spoils_the_text_is_named_in_the_error(text: str, number: str) -> None:
    with pytest.raises(InputError) as refused:
        plan_scene(text, 0)
    assert repr(number) in str(refused.value)


@pytest.mark.parametrize("text", ["9" * 1500, "1/" * 500 + "2", "7^" * 600 + "2", "1 " * 900])
def test_hostile_numbers_are_read_in_bounds(text: str) -> None:
    assert list(written_numbers(text))
    with contextlib.suppress(InputError):
        plan_scene(f"a mug and {text} plates", 0)


def test_the_warning_changes_nothing_else() -> None:
    plain, heavy = plan_scene("a mug and a plate", 0), plan_scene("a 50 kg mug and a plate", 0)
    assert plain.objects == heavy.objects and plain.table == heavy.table
