"""Cases of the understanding benchmark, tested with hand-made tables."""

from typing import Any

import numpy as np
import pytest
from made_things import seen, thing
from wording.cases import Case, case_of, cases_of, matches, plain
from wording.judging import assign, judge, told
from wording.relations import ALONE, TOGETHER, TOWARDS, ZONES
from wording.seen import Thing, is_colour


def case(text: str, objects: list[dict[str, Any]], **more: Any) -> Case:
    head = {"id": "c", "theme": "t", "level": "easy", "text": text, "objects": objects}
    return case_of(head | more)


def wants(any: str, count: int | list[int] = 1, **more: Any) -> dict[str, Any]:
    return {"word": any.split("|")[0], "any": any, "count": count} | more


def test_names_match_as_whole_words_of_any_number() -> None:
    assert matches("mug|cup", "mug_2")
    assert matches("egg", "fried-eggs")
    assert matches("box", "boxes")
    assert not matches("pen", "pencil_1")
    assert plain("Fried-Egg_12") == "fried egg"


def test_a_table_that_shows_what_is_asked_is_right() -> None:
    asked = case(
        "two mugs left of a plate", [wants("mug|cup", 2), wants("plate")],
        relations=[["mug|cup", "left", "plate"]],
    )  # fmt: skip
    mugs = [thing("mug_1", -0.2), thing("cup_1", -0.3, 0.05)]
    found = judge(asked, seen(*mugs, thing("plate_1")))
    assert found.right
    assert found.strict
    assert (found.asked, found.relations_asked) == (2, 1)
    turned = judge(asked, seen(*mugs, thing("plate_1", -0.45)))
    assert len(turned.relations) == 1
    assert not turned.right


def test_counts_are_exact_within_their_range() -> None:
    asked = case("two or three mugs", [wants("mug", [2, 3])])
    table = [thing(f"mug_{k}", 0.1 * k) for k in range(4)]
    assert judge(asked, seen(*table[:1])).counts == ("mug: 1, expected 2-3",)
    assert judge(asked, seen(*table[:2])).right
    assert judge(asked, seen(*table[:3])).right
    assert judge(asked, seen(*table)).counts == ("mug: 4, expected 2-3",)


def test_things_go_to_the_clause_that_needs_them() -> None:
    asked = case("", [wants("dish|bowl|plate"), wants("plate|dish"), wants("bowl", [0, 1])])
    given = assign(asked.objects, [thing("plate_1"), thing("dish_1")])
    assert [[t.name for t in group] for group in given] == [["dish_1"], ["plate_1"], []]


def test_what_nobody_asked_for_is_a_phantom() -> None:
    asked = case("a mug", [wants("mug")], also=["saucer"])
    assert judge(asked, seen(thing("mug_1"), thing("saucer_1", 0.2))).right
    assert judge(asked, seen(thing("mug_1"), thing("lamp_1", 0.2))).phantoms == ("lamp (lamp_1)",)


def test_a_plain_shape_never_counts_but_is_no_phantom_of_a_word_of_the_text() -> None:
    asked = case("a mug and a zorb", [wants("mug"), wants("zorb")])
    shape = thing("zorb_1", 0.2, stand_in=True)
    found = judge(asked, seen(thing("mug_1"), shape))
    assert found.counts == ("zorb: 0, expected 1",)
    assert found.phantoms == ()
    assert found.silent == ()
    other = judge(asked, seen(thing("mug_1"), thing("blib_1", 0.2, stand_in=True)))
    assert other.phantoms == ("blib (blib_1)",)


def test_a_plain_shape_has_a_place() -> None:
    asked = case(
        "a zorb left of a mug", [wants("mug"), wants("zorb")], relations=[["zorb", "left", "mug"]]
    )
    found = judge(asked, seen(thing("mug_1"), thing("zorb_1", -0.2, stand_in=True)))
    assert found.counts
    assert not found.relations
    turned = judge(asked, seen(thing("mug_1"), thing("zorb_1", 0.2, stand_in=True)))
    assert len(turned.relations) == 1


def test_a_change_without_a_word_is_told_from_one_that_is_warned_of() -> None:
    asked = case("a bat", [wants("bat|paddle")])
    table = seen(thing("vampire_1", label="vampire"))
    assert judge(asked, table).changed == ("bat",)
    assert judge(asked, table, ["The catalogue has no 'bat'."]).changed == ()
    called = seen(thing("vampire_1", label="bat"))
    hidden, warned = judge(asked, called), judge(asked, called, ["'bat' is shown as 'vampire'."])
    assert hidden.right
    assert not hidden.strict
    assert hidden.changed == ("bat is vampire_1",)
    assert warned.other == ("bat is vampire_1",)
    assert warned.changed == ()


def test_a_vessel_called_after_what_it_holds_shows_it() -> None:
    asked = case(
        "a bowl of sweets", [wants("bowl"), wants("sweets", [1, 99])],
        relations=[["sweets", "in", "bowl"]],
    )  # fmt: skip
    assert judge(asked, seen(thing("bowl_1", label="bowl of sweets"))).right
    assert not judge(asked, seen(thing("bowl_1"))).right
    two = case("a bowl with two sweets", [wants("bowl"), wants("sweets", 2)])
    assert not judge(two, seen(thing("bowl_1", label="bowl of sweets"))).right


@pytest.mark.parametrize(
    ("name", "strict"), [("test_tube_1", True), ("test_tube_rack_1", False), ("tube_box_1", True)]
)
def test_a_thing_is_of_the_kind_that_its_name_ends_with(name: str, strict: bool) -> None:
    asked = case("a test tube", [wants("test tube|tube")])
    assert judge(asked, seen(thing(name, label="test tube"))).strict is strict


def test_nothing_there_and_nothing_said_is_silent() -> None:
    asked = case("a mug and a pen", [wants("mug"), wants("pen")])
    found = judge(asked, seen(thing("mug_1")))
    assert found.silent == ("pen",)
    assert found.changed == ()


def test_rare_words_may_be_warned_of() -> None:
    asked = case(
        "a spork in a mug", [wants("spork"), wants("mug")],
        relations=[["spork", "in", "mug"]], terms_may_warn=["spork"],
    )  # fmt: skip
    assert not judge(asked, seen(thing("mug_1"))).right
    told_so = judge(asked, seen(thing("mug_1")), ["Not understood: 'spork'."])
    assert told_so.right
    assert (told_so.asked, told_so.relations_asked, told_so.excused) == (1, 0, 1)


def test_what_must_not_be_there() -> None:
    asked = case("a mug, no spoon, thanks", [wants("mug")], absent=["spoon"], also=["spoon"])
    assert judge(asked, seen(thing("mug_1"))).right
    assert judge(asked, seen(thing("mug_1"), thing("spoon_1", 0.2))).forbidden == ("spoon_1",)
    shape = thing("spoon_1", 0.2, stand_in=True)
    assert judge(asked, seen(thing("mug_1"), shape)).forbidden == ("spoon_1",)
    other = judge(asked, seen(thing("mug_1"), thing("thanks_1", 0.2, stand_in=True)))
    assert other.right
    assert not other.strict


def painted(name: str, colour: tuple[float, float, float], x: float) -> Thing:
    plain_one = thing(name, x)
    return Thing(name, "block", plain_one.points, False, np.array([colour]), np.ones(1))


def test_sizes_and_colours_belong_to_counts() -> None:
    asked = case("", [wants("block", colour="red"), wants("block", colour="blue")])
    red, blue = painted("block_1", (0.8, 0.1, 0.1), 0), painted("block_2", (0.1, 0.2, 0.8), 0.2)
    assert judge(asked, seen(blue, red)).right
    assert not judge(asked, seen(red, painted("block_3", (0.8, 0.1, 0.1), 0.2))).right
    long = case("", [wants("ruler", cm=[25, 35])])
    assert judge(long, seen(thing("ruler_1", size=(0.3, 0.03, 0.01)))).right
    short = judge(long, seen(thing("ruler_1", size=(0.1, 0.03, 0.01))))
    assert short.counts == ("ruler: ruler_1 is 10 cm long",)


@pytest.mark.parametrize(
    ("rgb", "name"),
    [((0.9, 0.9, 0.88), "white"), ((0.1, 0.1, 0.1), "black"), ((0.9, 0.8, 0.1), "yellow"),
     ((0.1, 0.6, 0.2), "green"), ((0.5, 0.5, 0.52), "grey")],
)  # fmt: skip
def test_colours_have_names(rgb: tuple[float, float, float], name: str) -> None:
    assert is_colour(np.array(rgb), name)
    assert not is_colour(np.array(rgb), "red")


def test_warnings_name_a_clause_by_the_words_of_the_text() -> None:
    (clause,) = case("", [wants("cushion|pillow")]).objects
    assert told(clause, "two pillows", ["Not understood: 'two pillows'."])
    assert not told(clause, "two pillows", ["Not understood: 'hurry'."])


def test_both_halves_are_sound() -> None:
    halves = {half: cases_of(half) for half in ("dev", "test")}
    everything = cases_of("both")
    assert len({c.id for c in everything}) == len({c.text for c in everything}) == 264
    assert len(halves["dev"]) == len(halves["test"])
    assert len({c.theme for c in everything}) >= 28
    known = {*ALONE, *TOGETHER, *TOWARDS, *ZONES, "centre", "on", "in", "near", "between", "stack"}
    known |= {"oneach", "noton", "around", "eachside"}
    for one in (*everything, *cases_of("more")):
        assert one.objects
        assert {r.kind for r in one.relations} <= known, one.id
        for pattern in (*(c.any for c in one.objects), *one.absent, *one.also):
            matches(pattern, "word")
        if one in everything:
            of = [sum(c.theme == one.theme for c in half) for half in halves.values()]
            assert abs(of[0] - of[1]) <= 1
