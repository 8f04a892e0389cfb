"""The plan of a sentence contains what it requests, and nothing else."""

from __future__ import annotations

import pytest
from plans import all_related, counts, found, plan, related


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a pizza but no plates", {"pizza": 1}),
        ("three mugs in different colours", {"mug": 3}),
        ("a glass of blue liquid", {"glass": 1}),
        (
            "a chopping board and two food containers for meal prep",
            {"cutting_board": 1, "food_container": 2},
        ),
        ("a plate with nothing on it", {"plate": 1}),
        ("a table without any chairs, with a vase", {"vase": 1}),
        ("a yellow and white mug and a white mug", {"mug": 2}),
        ("a photo of a vase", {"picture_frame": 1}),
        ("a mug with a picture of a cat", {"mug": 1}),
        ("a cake stand with cupcakes", {"cake_stand": 1, "cupcake": 2}),
        ("three pancakes on a plate", {"pancakes": 1, "plate": 1}),
        ("a candle and five marbles, but not the lighter", {"candle": 1, "marbles": 5}),
        ("four spoons of various sizes", {"spoon": 4}),
        ("three bowls, each with two apples", {"bowl": 3, "apple": 6}),
    ],
)
def test_counts(text: str, expected: dict[str, int]) -> None:
    assert counts(text) == expected


def test_what_is_full_holds_several() -> None:
    assert counts("a basket full of lemons for the market")["lemon"] in (4, 5)


def test_different_colours_and_sizes() -> None:
    mugs = plan("three mugs in different colours").objects
    assert len({o.attributes["color"] for o in mugs}) == 3
    assert {o.attributes["color"] for o in plan("three mugs in red").objects} == {"red"}
    sizes = [o.attributes["size"] for o in plan("three bowls of different sizes").objects]
    assert sizes == ["small", "medium", "large"]


def test_a_table_for_two_by_candlelight() -> None:
    assert counts("dinner for two by candlelight") == {
        "plate": 2, "fork": 2, "knife": 2, "glass": 2, "candle": 1,
    }  # fmt: skip


def test_one_thing_on_several_books_makes_a_stack_of_them() -> None:
    planned = plan("a monitor on two books")
    assert related(planned, "book_2") == {("on", "book_1")}
    assert related(planned, "monitor_1") == {("on", "book_2")}


@pytest.mark.parametrize(
    ("text", "phrase"),
    [
        ("a desk with a mug, love and happiness", "love"),
        ("a desk with a mug, love and happiness", "happiness"),
        ("a bowl of apples and a sense of order", "sense"),
        ("a mug and a church on a desk", "church"),
    ],
)
def test_what_is_no_thing_is_not_understood(text: str, phrase: str) -> None:
    planned = plan(text)
    assert f"Not understood: {phrase!r}." in planned.warnings
    assert all(o.category != "generic" for o in planned.objects)


@pytest.mark.parametrize(
    ("text", "family"),
    [
        ("a bicycle", "vehicle"),
        ("a dishwasher", "appliance"), ("a clavichord", "keyed"), ("a medlar", "fruit"),
        ("a tunic", "cloth"), ("an autogyro", "vehicle"),
    ],
)  # fmt: skip
def test_a_strange_thing_has_the_family_of_its_kind(text: str, family: str) -> None:
    (thing,) = plan(f"{text} on a table").objects
    assert (thing.category, thing.family) == ("generic", family)


@pytest.mark.parametrize(
    ("text", "warning"),
    [
        ("a mandarin", "The catalogue has no 'mandarin'; it is shown as 'orange'."),
        (
            "a clavichord on a desk",
            "The catalogue has no 'clavichord'; it is shown as a plain shape",
        ),
        ("2 moniters and a keybord", "Read 'moniters' as 'monitors'."),
    ],
)
def test_changed_words_are_warned_of(text: str, warning: str) -> None:
    assert any(w.startswith(warning) for w in plan(text).warnings)


@pytest.mark.parametrize("words", ["far from", "away from", "far away from"])
def test_what_is_far_from_another_is_not_planned_and_told(words: str) -> None:
    read = plan(f"a mug and a plate, a candle {words} the mug")
    assert read.warnings == (f"Not understood: '{words} the mug'.",)
    assert {o.name for o in read.objects} == {"mug_1", "plate_1", "candle_1"}


@pytest.mark.parametrize(
    "text",
    ["a towel", "two drinking glasses", "a breadboard", "a nail file", "a moka pot",
     "a standing mirror", "poker chips", "mugs of various sizes", "a chessboard",
     "a cat figurine riding a toy truck", "a barista's counter with an espresso machine",
     "an espresso, a mojito and a hot chocolate"],
)  # fmt: skip
def test_known_words_need_no_warning(text: str) -> None:
    assert plan(text).warnings == ()


def test_who_rides_a_thing_is_on_it() -> None:
    for words in ("riding", "astride", "seated on"):
        assert all_related(f"a cat figurine {words} a toy truck") == {
            ("figurine_1", "on", "toy_truck_1")
        }


def test_the_red_one_is_the_thing_of_that_colour() -> None:
    text = "Put the red cube to the left of the blue cube and the green cube on the red one."
    planned = plan(text)
    colors = {o.attributes["color"]: o.name for o in planned.objects}
    assert len(planned.objects) == 3
    assert ("on", colors["red"]) in related(planned, colors["green"])


def test_one_red_and_one_blue_of_several() -> None:
    colors = [o.attributes.get("color") for o in plan("two mugs, a red one and a blue one").objects]
    assert colors == ["red", "blue"]


def test_colours_listed_after_a_colon_are_of_single_ones() -> None:
    planned = plan("Five blocks: red, green, blue, yellow and purple, from left to right")
    colors = [o.attributes["color"] for o in planned.objects]
    assert colors == ["red", "green", "blue", "yellow", "purple"]
    assert [g.kind for g in planned.groups] == ["row"]


def test_single_things_in_a_row() -> None:
    (group,) = plan("an apple, a pear and a peach in a row").groups
    assert (group.kind, len(group.members)) == ("row", 3)


def test_a_relation_that_is_denied_is_not_planned() -> None:
    planned = plan("a book and a lamp that is not on the book")
    assert counts("a book and a lamp that is not on the book") == {"book": 1, "desk_lamp": 1}
    assert ("on", "book_1") not in related(planned, "desk_lamp_1")


def test_cutlery_at_each_plate() -> None:
    text = "four plates on a round table, a knife and a fork at each plate"
    planned = plan(text)
    assert counts(text) == {"plate": 4, "knife": 4, "fork": 4}
    assert related(planned, "fork_3") == {("left_of", "plate_3")}
    assert related(planned, "knife_4") == {("right_of", "plate_4")}


def test_a_breakfast_is_laid_for_each() -> None:
    text = "breakfast for three: a bowl of cereal, a glass of orange juice and a banana"
    assert counts(text) == {"bowl_of_cereal": 3, "glass": 3, "banana": 3}


def test_the_top_bowl_is_the_upper_one() -> None:
    planned = plan("two bowls, one on the other, and a spoon in the top bowl")
    assert related(planned, "bowl_1") | related(planned, "bowl_2") in (
        {("on", "bowl_1")}, {("on", "bowl_2")},
    )  # fmt: skip
    upper = next(o.name for o in planned.objects if o.category == "bowl" and o.relations)
    assert related(planned, "spoon_1") == {("in", upper)}
    assert len({o.size for o in planned.objects if o.category == "bowl"}) == 1


def test_a_bag_of_coffee_beans_is_one_bag() -> None:
    assert counts("an espresso machine and a bag of coffee beans") == {
        "espresso_machine": 1, "coffee_bag": 1,
    }  # fmt: skip


def test_a_jar_stands_open_for_what_is_put_into_it() -> None:
    planned = plan("nails in a jar")
    assert {r.kind for o in planned.objects for r in o.relations} == {"in"}
    assert found(planned, "jar_1").noun == "jar"
    assert counts("a jar next to a nail") == {"jar": 1, "nail": 1}


def test_things_scattered_around_another_are_near_it() -> None:
    planned = plan("three pens scattered around an open notebook")
    assert related(planned, "pen_2") == {("next_to", "open_book_1")}


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("a big red apple next to a small green one", {"apple": 2}),
        ("a vase of tulips", {"empty_vase": 1, "tulip": 2}),
        ("a first aid kit", {"first_aid_kit": 1}),
        ("I don't want any plates, just a cup", {"mug": 1}),
        ("a cup of tea with milk", {"mug": 1}),
        ("a bottle of red wine and two glasses", {"wine_bottle": 1, "glass": 2}),
        ("cups and saucers for four people", {"mug": 4, "saucer": 4}),
        ("<html><body>a mug</body></html>", {"mug": 1}),
        ("two of the three mugs are red", {"mug": 3}),
        (
            "a plate with a sandwich, a banana and a cookie",
            {"plate": 1, "sandwich": 1, "banana": 1, "cookie": 1},
        ),
    ],
)
def test_more_counts(text: str, expected: dict[str, int]) -> None:
    assert counts(text) == expected


def test_a_list_on_a_plate_is_on_it() -> None:
    planned = plan("a plate with a sandwich, a banana and a cookie")
    assert all(o.relations[0].target == "plate_1" for o in planned.objects if o.name != "plate_1")


def test_a_cup_laid_with_its_saucer_is_on_it() -> None:
    planned = plan("cups and saucers for four people")
    assert related(planned, "mug_3") == {("on", "saucer_3")}


def test_linen_is_cloth() -> None:
    assert {o.family for o in plan("a lace doily and a tablecloth").objects} <= {"cloth", ""}


def test_what_does_not_fit_in_is_warned_of() -> None:
    assert any("does not fit" in w for w in plan("a mug with a hammer inside").warnings)


def test_what_is_between_two_things_has_one_on_each_side() -> None:
    planned = plan("a chess board between two mugs")
    assert related(planned, "mug_1") == {("left_of", "chess_board_1")}
    assert related(planned, "mug_2") == {("right_of", "chess_board_1")}


def test_a_colour_in_a_name_is_kept() -> None:
    apple, onion = plan("a green apple and a red onion").objects
    assert (apple.attributes["color"], onion.attributes["color"]) == ("green", "red")


def test_an_occasion_is_no_thing() -> None:
    assert counts("an afternoon tea: a teapot and two scones")["teapot"] == 1
    assert all(o.noun.split()[-1] != "tea" for o in plan("an afternoon tea: a teapot").objects)


def test_a_desk_is_set_as_people_have_it() -> None:
    planned = plan("a desk with two monitors, a keyboard and a mouse")
    assert related(planned, "keyboard_1") == {("in_front_of", "monitor_1")}
    assert related(planned, "computer_mouse_1") == {("right_of", "keyboard_1")}
    assert [g.members for g in planned.groups] == [("monitor_1", "monitor_2")]


@pytest.mark.parametrize(
    ("text", "warning"),
    [
        ("a 3 m long plank on a desk", "does not belong on a table"),
        ("a hammer leaning against a toolbox", "cannot lean against"),
    ],
)
def test_what_cannot_be_done_is_warned_of(text: str, warning: str) -> None:
    assert any(warning in w for w in plan(text).warnings)


@pytest.mark.parametrize("text", ["a 20 cm tall vase", "a vase 20 cm tall", "a vase of 20 cm"])
def test_a_length_is_kept_before_and_after_the_noun(text: str) -> None:
    (vase,) = plan(text).objects
    assert vase.size is not None and max(vase.size) == pytest.approx(0.2)
