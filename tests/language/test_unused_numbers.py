"""Numbers that the plan does not use give warnings; the others do not."""

import contextlib

import pytest
from plans import counts

from generator.errors import InputError
from generator.language.planner import plan_scene
from generator.language.syntax.text.figures import settle_numbers, written_numbers


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
        ("a bottle 80% full and a mug", "80%"),
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
    [("10^9 mugs on a desk", "10^9"), ("a 60 cm wide desk with 8^7 cups", "8^7")],
)
def test_a_number_that_spoils_the_text_is_named_in_the_error(text: str, number: str) -> None:
    with pytest.raises(InputError) as refused:
        plan_scene(text, 0)
    assert repr(number) in str(refused.value)


@pytest.mark.parametrize(
    "text", ["a 60 cm board and 1000 mugs", "a 20 cm tall vase, a 3 m desk and 2.5 mugs"]
)
def test_an_error_blames_no_number_that_was_read(text: str) -> None:
    with pytest.raises(InputError) as refused:
        plan_scene(text, 0)
    assert "cm" not in str(refused.value) and "without" not in str(refused.value)


@pytest.mark.parametrize(
    ("text", "number", "expected"),
    [
        ("a 5° tilted plate", "5°", {"plate": 1}),
        ("a 24/7 sign", "24/7", {"shop_sign": 1}),
        ("a $5 bill and a mug", "$5", {"invoice": 1, "mug": 1}),
        ("a 20 euro note", "20 euro", {"bank_note": 1}),
        ("a 50% full glass", "50%", {"glass": 1}),
        ("3/4 of a cake", "3/4", {"cake": 1}),
        ("a 45 rpm record and a 16MP camera", "45 rpm", {"vinyl_record": 1, "camera": 1}),
        ("a 300 page book", "300 page", {"book": 1}),
        ("12 piece puzzle and 2 mugs", "12 piece", {"jigsaw_puzzle": 1, "mug": 2}),
        ("a 52-card deck", "52-card", {"playing_cards": 1}),
        ("a 4x4 coaster", "4", {"coaster": 1}),
        ("a 7 jersey", "7", {"shirt": 1}),
        ("a three prong fork", "three", {"fork": 1}),
        ("a ten euro note", "ten euro", {"bank_note": 1}),
        ("a score sheet of 3:1 and a mug", "3:1", {"scorecard": 1, "mug": 1}),
        ("a note with 555-12-34 and a mug", "555-12-34", {"sticky_notes": 1, "mug": 1}),
        ("a pot with 2 handles and 2 mugs", "2", {"pot": 1, "mug": 2}),
        ("a cup with three handles", "three", {"mug": 1}),
        ("a mug with a 5 cm handle", "5 cm", {"mug": 1}),
        ("a mug (2)", "2", {"mug": 1}),
        ("the 7th mug", "7th", {"mug": 1}),
        ("2 of 3 mugs are blue", "2", {"mug": 3}),
        ("1 of the 3 mugs is blue", "1", {"mug": 3}),
        ("1:43 scale model car and a mug", "1:43", {"toy_car": 1, "mug": 1}),
        ("a 2 by 4 block", "4", {"toy_block": 1}),
        ("size M shirt, 2 of them", "2", {"shirt": 1}),
        ("a stack of 3 pancakes and a plate", "3", {"pancakes": 1, "plate": 1}),
        ("a room with 2 windows and a mug", "2", {"mug": 1}),
    ],
)
def test_a_number_that_counts_nothing_is_named_and_not_counted(
    text: str, number: str, expected: dict[str, int]
) -> None:
    assert number in unused(text)
    assert counts(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a Windows 11 laptop", {"laptop": 1}),
        ("two Windows 11 laptops", {"laptop": 2}),
        ("my PlayStation 5 controller", {"game_controller": 1}),
        ("a HP 12C calculator", {"calculator": 1}),
        ("#2 pencil", {"pencil": 1}),
        ("a No. 2 pencil", {"pencil": 1}),
        ("a size 10 shoe", {"shoe": 1}),
        ("a 1950s radio", {"radio": 1}),
        ("a 1967 radio", {"radio": 1}),
        ("a 4K monitor at 5 pm", {"monitor": 1}),
        ("a mug at 7:30", {"mug": 1}),
        ("a 2nd mug", {"mug": 1}),
        ("two mugs; the 2nd mug is red", {"mug": 2}),
        ("room 101 sign", {"shop_sign": 1}),
        ("a spirit level 40 cm long", {"spirit_level": 1}),
        ("a seven mug set", {"mug": 7}),
        ("a 2 by 2 arrangement of cubes", {"cube": 4}),
        ("twelve (12) eggs and one (1) bowl", {"egg": 12, "bowl": 1}),
        ("five-pointed star and 2 candles", {"star": 1, "candle": 2}),
        ("two-way radio", {"radio": 1}),
        ("2+2 mugs", {"mug": 4}),
        ("mugs (2)", {"mug": 2}),
        ("5 dollars and a mug", {"banknotes": 5, "mug": 1}),
        ("A Table With 3 Mugs And 2 Plates", {"mug": 3, "plate": 2}),
    ],
)
def test_names_and_counts_are_told_apart(text: str, expected: dict[str, int]) -> None:
    assert counts(text) == expected
    assert unused(text) == []


@pytest.mark.parametrize(
    ("text", "said", "expected"),
    [
        ("5-6 pens", "5-6", {"pen": 5}),
        ("2-3 apples and a mug", "2-3", {"apple": 2, "mug": 1}),
        ("5 to 6 pens", "5 to 6", {"pen": 5}),
        ("5–6 pens", "5–6", {"pen": 5}),
        ("two or three apples", "two or three", {"apple": 2}),
        ("between 2 and 3 apples", "between 2 and 3", {"apple": 2}),
        ("some (3-5) mugs", "3-5", {"mug": 3}),
        ("a 20-30 cm vase", "20-30 cm", {"vase": 1}),
        ("0-4 mugs", "0-4", {"mug": 4}),
        ("3~4 apples", "3~4", {"apple": 3}),
        ("5+ apples", "5+", {"apple": 5}),
    ],
)
def test_a_range_is_its_lower_bound(text: str, said: str, expected: dict[str, int]) -> None:
    (warning,) = plan_scene(text, 0).warnings
    assert warning.startswith(f"The range {said!r} is read as ")
    assert counts(text) == expected


@pytest.mark.parametrize("text", ["twenty-five eggs", "a plate - 3 mugs", "mugs x2 - 3 plates"])
def test_other_numbers_beside_dashes_are_no_ranges(text: str) -> None:
    assert plan_scene(text, 0).warnings == ()


@pytest.mark.parametrize("text", ["2,5 mugs", "1.000 beads"])
def test_a_number_as_other_countries_write_it_is_no_smaller_one(text: str) -> None:
    with pytest.raises(InputError, match=r"2\.5 mugs|1000 beads"):
        plan_scene(text, 0)


@pytest.mark.parametrize(
    "text", ["a 24/7 sign", "5-6 pens or 2+2 mugs", "½ a pie, 2,5 kg, ⅔ of it", "7th, 4K, #2, $5"]
)
def test_settled_numbers_keep_the_length_of_a_text(text: str) -> None:
    assert len(settle_numbers(text)) == len(text)


@pytest.mark.parametrize(
    "text",
    [
        "9" * 1500,
        "1/" * 500 + "2",
        "7^" * 600 + "2",
        "1 " * 900,
        "2-" * 900,
        "1+" * 900 + "1",
        "a A" * 600 + " 3",
        "1." + "000." * 400,
    ],
)
def test_hostile_numbers_are_read_in_bounds(text: str) -> None:
    assert list(written_numbers(text))
    with contextlib.suppress(InputError):
        plan_scene(f"a mug and {text} plates", 0)


def test_the_warning_changes_nothing_else() -> None:
    plain, heavy = plan_scene("a mug and a plate", 0), plan_scene("a 50 kg mug and a plate", 0)
    assert plain.objects == heavy.objects and plain.table == heavy.table
