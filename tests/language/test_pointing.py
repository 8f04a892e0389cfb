"""References in a text: the others, the leftmost, another, each front corner, the previous one."""

from __future__ import annotations

import pytest
from plans import counts, plan, related


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a sponge in each front corner", {"sponge": 2}),
        ("thread spools in three colours", {"thread_spool": 3}),
        ("nail polish in pink and purple", {"nail_polish": 2}),
        ("two stacks of books (one red, one blue)", {"book": 2}),
        ("a colander full of strawberries, an empty jam jar", {"colander": 1, "jam_jar": 1}),
        ("three plates. Every plate gets its own glass behind it", {"plate": 3, "glass": 3}),
        ("a deck of cards and five cards in a row", {"playing_cards": 1, "playing_card": 5}),
        ("a mug. Leave the shoes out", {"mug": 1}),
        ("a monitor. The phone isn't on the desk today", {"monitor": 1}),
        ("a plate of six sufganiyot (jelly doughnuts)", {"plate": 1, "donut": 6}),
        ("a chess board. Actually no, scrap the chess board, make it a vase", {"vase": 1}),
        ("We are hosting a client. A mug, and a red cube as a distractor", {"mug": 1, "cube": 1}),
        ("I'd love a picture for her invite: a vase", {"vase": 1}),
        ("dinner for two: a plate on the left side and a plate on the right side", {"plate": 2}),
        ("poker for two: a deck of cards in the middle, a mug, two dice, a lamp",
         {"playing_cards": 1, "mug": 1, "die": 2, "desk_lamp": 1}),
        ("a bowl of crisps", {"bowl_of_crisps": 1}),
        ("a birthday cake with three candles on it", {"cake": 1, "birthday_candle": 3}),
        ("flat white mug\nSaw - not available", {"mug": 1}),
    ],
)  # fmt: skip
def test_counts(text: str, expected: dict[str, int]) -> None:
    asked = counts(text)
    assert {key: asked.get(key, 0) for key in expected} == expected
    assert not asked.keys() - expected.keys() - {"strawberry"}


@pytest.mark.parametrize(
    ("text", "name", "expected"),
    [
        ("a vase in the middle and a plate, so is a mug", "mug_1", set()),
        ("Goal: (on red_block blue_block)", "toy_block_1", {("on", "toy_block_2")}),
        ("a mug half as tall as the vase to the left of the plate", "mug_1",
         {("left_of", "plate_1")}),
        ("a doll, a rabbit. A teacup in front of the doll and another in front of the rabbit",
         "teacup_2", {("in_front_of", "toy_rabbit_1")}),
        ("an open book in the centre and a pen lying on it", "pen_1", {("on", "open_book_1")}),
        ("a bottle. An egg lies in a bowl, as does a lemon", "lemon_1", {("in", "bowl_1")}),
        ("a bowl. The mug, however, is behind the bowl", "mug_1", {("behind", "bowl_1")}),
        ("White first-aid box. A mug to the right of the first aid box", "mug_1",
         {("right_of", "first_aid_kit_1")}),
        ("a cake stand carrying a chocolate cake with a cherry on top", "cherries_1",
         {("on", "cake_1")}),
        ("an ice bucket right of the tray with tongs in it, a tray", "tongs_1",
         {("in", "ice_bucket_1")}),
        ("a flask on a coaster in front of the microscope", "coaster_1",
         {("in_front_of", "microscope_1")}),
        ("Drill - to the right of the toolbox", "power_drill_1", {("right_of", "toolbox_1")}),
        ("Put the mug on the left plate and the egg on the right plate", "plate_1",
         {("left_of", "table")}),
    ],
)  # fmt: skip
def test_relations(text: str, name: str, expected: set[tuple[str, str]]) -> None:
    assert related(plan(text), name) == expected


@pytest.mark.parametrize(
    ("text", "colors"),
    [
        ("four mugs in a row. The leftmost is red and the other three blue", "red blue blue blue"),
        ("a bowl, not black but white", "white"),
        ("two stacks of books (one red, one blue)", "red blue"),
        ("sticky notes (yellow)", "yellow"),
    ],
)  # fmt: skip
def test_colours(text: str, colors: str) -> None:
    assert [o.attributes.get("color") for o in plan(text).objects] == colors.split()


def test_lengths_in_words() -> None:
    assert max(plan("a mug about ten centimetres tall").objects[0].size or ()) == pytest.approx(0.1)
    assert max(plan("a foot-long ruler").objects[0].size or ()) == pytest.approx(0.3048)


def test_a_stack_named_first_carries_on_its_top() -> None:
    text = "Stacked on the left are three textbooks, with an apple on top of the stack"
    assert related(plan(text), "apple_1") == {("on", "textbook_3")}


def test_a_line_along_a_side_goes_to_the_back() -> None:
    groups = plan("four paint tubes in a row along the left").groups
    assert [group.kind for group in groups] == ["column"]


def test_the_largest_is_at_the_bottom() -> None:
    text = "Stack three bowls so that the largest is at the bottom and the smallest on top"
    planned = plan(text)
    sizes = {o.name: max(o.size or (0.155,)) for o in planned.objects}
    pairs = [(o.name, r.target) for o in planned.objects for r in o.relations if r.kind == "on"]
    assert len(pairs) == 2
    by_word = {"small": 0, "medium": 1, "large": 2}
    rank = {o.name: by_word.get(o.attributes.get("size", ""), 1) for o in planned.objects}
    assert all((rank[a], sizes[a]) <= (rank[b], sizes[b]) for a, b in pairs)
    assert len(set(rank.values()) | set(sizes.values())) > 1


def test_a_blanket_with_several_things_on_it_is_spread() -> None:
    assert counts("a thermos and two sandwiches on a blanket")["cloth"] == 1
    assert counts("a thermos and two sandwiches on a folded blanket")["blanket"] == 1


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a notebook and a mug; leave the notebook out on the desk", {"notebook": 1, "mug": 1}),
        ("my mum's teapot is on the table, and a cup", {"teapot": 1, "mug": 1}),
        ("a laptop, a picture for the wall, and a mug",
         {"laptop": 1, "picture_frame": 1, "mug": 1}),
        ("a cake, and two candles in candlesticks", {"cake": 1, "long_candle": 2,
                                                     "empty_candlestick": 2}),
        ("pencils in 120 colours, a mug", {"pencil": 2, "mug": 1}),
    ],
)  # fmt: skip
def test_what_looks_alike_is_told_apart(text: str, expected: dict[str, int]) -> None:
    assert {key: min(n, 2) for key, n in counts(text).items()} == expected


def test_brackets_and_dashes_name_places() -> None:
    assert related(plan("a mug (on the left) and a plate"), "mug_1") == {("left_of", "table")}
    assert related(plan("mug - on the right a lamp"), "mug_1") == set()


def test_what_carries_things_makes_no_circle() -> None:
    text = (
        "A tray holds a cup and a glass. A board holds a pot and a bottle. The cup is left of the "
        "pot. The bottle is left of the glass."
    )
    assert plan(text).objects
