"""Sentences to plans: objects, counts, attributes, relations, tables, themes, refusals."""

import json
from collections import Counter
from pathlib import Path
from typing import get_args

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from generator.errors import InputError
from generator.language import relations, themes
from generator.language.lexicon import category_of, singular, tokens
from generator.language.planner import plan_scene
from generator.language.reader import MAX_CHARACTERS
from generator.language.vocabulary import COLLECTIVES, SYNONYMS
from generator.scene import OutlineKind, PlannedObject, Relation, ScenePlan
from tabletop_objects import CATEGORIES


def counted(plan: ScenePlan) -> Counter[str]:
    return Counter(o.category for o in plan.objects)


def related(plan: ScenePlan, name: str) -> set[tuple[str, str]]:
    (found,) = [o for o in plan.objects if o.name == name]
    return {(r.kind, r.target) for r in found.relations}


OBJECTS = [
    ("two red mugs on a desk", {"mug": 2}),
    ("3 pencils and an apple", {"pencil": 3, "apple": 1}),
    ("a table with a mug, a book and a plate", {"mug": 1, "book": 1, "plate": 1}),
    ("half a dozen eggs in a bowl", {"egg": 6, "bowl": 1}),
    ("a pair of mugs beside a plate", {"mug": 2, "plate": 1}),
    ("a pair of pliers and a hammer", {"pliers": 1, "hammer": 1}),
    ("a stack of three books", {"book": 3}),
    ("a coffee mug next to a dinner plate", {"mug": 1, "plate": 1}),
    ("a desk without a laptop, with a mug", {"mug": 1}),
    ("a red and a blue mug", {"mug": 2}),
    ("two plates each with a fork to the left", {"plate": 2, "fork": 2}),
    ("Can you put a mug on a table?", {"mug": 1}),
    ("There is a mug. The mug is blue.", {"mug": 1}),
    ("a plate between the fork and the knife", {"plate": 1, "fork": 1, "knife": 1}),
    ("an orange orange and an apple", {"orange": 1, "apple": 1}),
    ("a loaf of bread", {"bread_loaf": 1}),
]


@pytest.mark.parametrize(("text", "expected"), OBJECTS)
def test_explicit_objects_are_counted_exactly(text: str, expected: dict[str, int]) -> None:
    assert counted(plan_scene(text, 0)) == expected


@pytest.mark.parametrize(
    ("text", "low", "high"),
    [("a few apples on a table", 3, 3), ("several books", 3, 4), ("many eggs in a tray", 5, 6),
     ("a dozen eggs", 12, 12), ("some pencils on a desk", 2, 3)],
)  # fmt: skip
def test_vague_amounts_stay_in_their_range(text: str, low: int, high: int) -> None:
    for seed in range(5):
        (category, _), *_ = counted(plan_scene(text, seed)).items()
        assert low <= counted(plan_scene(text, seed))[category] <= high


RELATIONS = [
    ("a book to the left of the laptop", "book_1", {("left_of", "laptop_1")}),
    ("a mug behind the notebook and next to a pen", "mug_1",
     {("behind", "notebook_1"), ("next_to", "pen_1")}),
    ("a plate with an apple on it", "apple_1", {("on", "plate_1")}),
    ("a mug with a pencil in it", "pencil_1", {("in", "mug_1")}),
    ("a bowl of apples", "apple_1", {("in", "bowl_1")}),
    ("an apple and a pear on a plate", "apple_1", {("on", "plate_1")}),
    ("an apple and a pear on a plate", "pear_1", {("on", "plate_1")}),
    ("a mug on the book and a pen on the notebook", "mug_1", {("on", "book_1")}),
    ("a mug on the book and a pen on the notebook", "pen_1", {("on", "notebook_1")}),
    ("To the right of the plate is a knife", "knife_1", {("right_of", "plate_1")}),
    ("A laptop. A mug is in front of it.", "mug_1", {("in_front_of", "laptop_1")}),
    ("a plate with an apple on it and a fork to its left", "fork_1", {("left_of", "plate_1")}),
    ("a knife between two plates", "knife_1", {("next_to", "plate_1"), ("next_to", "plate_2")}),
    ("a cake in the middle of the table", "cake_1", {("center", "table")}),
    ("a mug at the edge of the desk", "mug_1", {("edge", "table")}),
    ("a mug on the left and a book on the right of the table", "mug_1", {("left_of", "table")}),
    ("a stack of two books", "book_2", {("on", "book_1")}),
    ("a book under a mug", "mug_1", {("on", "book_1")}),
    ("a pencil in a mug behind the notebook", "mug_1", {("behind", "notebook_1")}),
    ("a fork on each of the three plates", "fork_3", {("on", "plate_3")}),
    ("a mug and a pen are left of the laptop", "mug_1", {("left_of", "laptop_1")}),
    ("a pen inside the cup, a book atop the box", "book_1", {("on", "box_1")}),
]  # fmt: skip


def test_attributes() -> None:
    plan = plan_scene("a small dark blue ceramic mug, a large wooden bowl and an old book", 0)
    mug, bowl, book = (dict(o.attributes) for o in plan.objects)
    assert mug == {"size": "small", "color": "dark blue", "material": "ceramic"}
    assert bowl == {"size": "large", "material": "wooden"}
    assert book == {"state": "old"}


def test_a_length_fixes_the_size() -> None:
    (vase,) = plan_scene("a 30 cm tall teddy bear on a table", 0).objects
    assert vase.size is not None
    assert max(vase.size) == pytest.approx(0.30)


TABLES = [
    ("a mug on a round wooden table", {"outline": "round", "material": "oak"}),
    ("a mug on a white desk", {"color": "white", "outline": "rectangle"}),
    ("a mug on a triangular walnut table", {"outline": "triangle", "material": "walnut"}),
    ("a slatted pine table with a mug", {"outline": "slatted", "material": "pine"}),
    (
        "a marble coffee table with hairpin legs and a mug",
        {"material": "marble", "legs": "hairpin"},
    ),
    ("a mug on an oval glass table", {"outline": "oval", "material": "glass"}),
    ("a mug on a square pedestal table", {"outline": "square", "legs": "pedestal"}),
    ("a mug on a 150 x 80 cm desk", {"size": (1.5, 0.8, 0.74)}),
    ("a mug on a low table", {}),
    ("a table with a marble top, and a mug", {"material": "marble"}),
]


@pytest.mark.parametrize(("text", "expected"), TABLES)
def test_tables(text: str, expected: dict[str, object]) -> None:
    table = plan_scene(text, 3).table
    assert {key: getattr(table, key) for key in expected} == expected
    assert ("low" not in text) or table.size[2] < 0.5


THEMES = {
    "an office desk": "laptop", "a dining table": "plate", "a kitchen table": "knife",
    "a coffee table": "mug", "a workbench": "hammer", "a craft table": "scissors",
    "a vanity": "perfume_bottle", "a lab bench": "microscope", "a gaming desk": "keyboard",
    "a breakfast table": "plate", "a kids' toy table": "toy_block",
    "a dining table for two": "fork",
}  # fmt: skip


@pytest.mark.parametrize("text", THEMES)
def test_a_theme_alone_is_filled_with_what_belongs_there(text: str) -> None:
    for seed in range(4):
        plan = plan_scene(text, seed)
        assert 3 <= len(plan.objects) <= 10
        assert not plan.warnings
        if THEMES[text] in CATEGORIES:
            assert THEMES[text] in counted(plan), counted(plan)
        names = {o.name for o in plan.objects} | {"table"}
        assert all(r.target in names for o in plan.objects for r in o.relations)


def test_functional_relations_of_themes() -> None:
    desk, dinner = plan_scene("an office desk", 0), plan_scene("a dining table for two", 0)
    assert ("right_of", "laptop_1") in related(desk, "computer_mouse_1")
    assert related(dinner, "fork_1") == {("left_of", "plate_1")}
    assert related(dinner, "fork_2") == {("left_of", "plate_2")}  # as who sits there sees it


def test_vague_items_are_kept_and_joined_by_theme_things() -> None:
    plan = plan_scene("A hobby desk with some model cars and tools.", 1)
    nouns = [o.noun for o in plan.objects]
    assert nouns.count("model car") in (2, 3)
    assert {"hammer", "screwdriver", "wrench", "pliers"} <= set(counted(plan))
    assert len(plan.objects) <= 7


def test_exact_items_are_not_joined_by_anything() -> None:
    assert len(plan_scene("an office desk with a laptop and a red mug", 0).objects) == 2


def test_every_theme_word_and_synonym_leads_somewhere() -> None:
    for theme in themes.THEMES.values():
        plan = plan_scene(f"a {theme.words[0]}", 0)
        assert len(plan.objects) >= 3, theme.words[0]
    reached = [word for word, _ in SYNONYMS if category_of(tuple(tokens(word)))]
    assert len(reached) > 0.5 * len(SYNONYMS)
    assert len(COLLECTIVES) > 20


def test_unknown_words_become_generic_with_a_warning() -> None:
    plan = plan_scene("a zorbulator and two small flurbs on a table", 0)
    assert counted(plan) == {"generic": 3}
    assert [o.noun for o in plan.objects] == ["zorbulator", "flurb", "flurb"]
    assert len(plan.warnings) == 2 and "zorbulator" in plan.warnings[0]
    big, small, _ = plan.objects
    assert big.size and small.size and max(small.size) < max(big.size)


def test_a_head_noun_decides_not_its_modifier() -> None:
    plan = plan_scene("a mouse trap and a coffee mug on a table", 0)
    assert [o.category for o in plan.objects] == ["mouse_trap", "mug"]


@pytest.mark.parametrize(
    ("text", "says"),
    [
        ("", "empty"), ("  \n ", "empty"), ("12345 !!!", "no words"),
        ("a mug " * 2000, "characters"),
        ("une table avec une tasse et un livre sur la table", "English"),
        ("ein Tisch mit einer Tasse und einem Buch", "English"),
        ("una mesa con una taza y un libro", "English"),
        ("桌子上有一个杯子", "English"), ("стол с кружкой", "English"),
        ("qwrtz plmk xyzzy", "English"),
        ("200 mugs", "at most 40"), ("two hundred mugs on a desk", "at most 40"),
        ("1e9 mugs", "at most 40"), ("1e999 mugs", "at most 40"), ("-3 mugs", "at least 1"),
        ("30 mugs and 30 plates", "at most 40"), ("0 mugs", "at least 1"), ("2.5 mugs", "whole"),
        ("a table on the mug", "Reverse"), ("two tables with mugs", "exactly one table"),
        ("the mug is on the mug", "itself"), ("the stock market", "an office desk"),
        ("a mug on a book and the book on the mug", "contradict"),
        ("a mug left of the pen, the pen left of the mug", "contradict"),
        ("a mug left of the laptop and right of the laptop", "contradict"),
        ("an empty desk", "nothing on the table"), ("a mug without a mug", "nothing on the table"),
        ("a pen behind the mug. The mug is behind the pen.", "contradict"),
    ],
)  # fmt: skip
def test_what_cannot_be_planned_is_refused_clearly(text: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        plan_scene(text, 0)


@pytest.mark.parametrize(
    ("text", "name", "expected"),
    [
        ("a laptop in a mug", "laptop_1", {("next_to", "mug_1")}),
        ("a laptop on a pen", "laptop_1", {("next_to", "pen_1")}),
        ("an apple in a book", "apple_1", {("on", "book_1")}),
        ("a bowl in a spoon", "bowl_1", {("next_to", "spoon_1")}),
    ],
)
def test_implausible_relations_step_aside_with_a_warning(
    text: str, name: str, expected: set[tuple[str, str]]
) -> None:
    plan = plan_scene(text, 0)
    assert related(plan, name) == expected
    assert any("does not fit" in warning for warning in plan.warnings)


def test_two_supports_contradict() -> None:
    objects = [
        PlannedObject("a", "mug", "mug", {}, (Relation("on", "b"), Relation("on", "c"))),
        PlannedObject("b", "book", "book"),
        PlannedObject("c", "box", "box"),
    ]
    with pytest.raises(InputError, match="two objects at once"):
        relations.check_relations(objects)


def test_same_seed_same_plan_and_seeds_differ() -> None:
    assert plan_scene("an office desk", 5) == plan_scene("an office desk", 5)
    plans = [tuple(o.name for o in plan_scene("an office desk", s).objects) for s in range(6)]
    assert len(set(plans)) > 2


@pytest.mark.parametrize(
    ("plural", "one"),
    [("mugs", "mug"), ("boxes", "box"), ("knives", "knife"), ("dishes", "dish"), ("glass", "glass"),
     ("cherries", "cherry"), ("mice", "mouse"), ("dice", "die"), ("cactus", "cactus")],
)  # fmt: skip
def test_singular(plural: str, one: str) -> None:
    assert singular(plural) == one


def _planned_or_refused(text: str, seed: int) -> None:
    """Any text gives a consistent plan or an input error."""
    try:
        plan = plan_scene(text, seed)
    except InputError as error:
        assert str(error)
        return
    names = [o.name for o in plan.objects]
    assert len(set(names)) == len(names) <= 40
    assert names, "a plan holds at least one object"
    assert all(r.target in {*names, "table"} and r.target != o.name
               for o in plan.objects for r in o.relations)  # fmt: skip
    assert all(o.category == "generic" or o.category in CATEGORIES for o in plan.objects)
    assert all(o.category != "generic" or o.size for o in plan.objects)


VOCABULARY = (
    "a the two 7 dozen several each it them no without mug mugs table desk plate apple pencil zorb "
    "red wooden round small , . and or of with in on behind between left to next under is are "
    "bowl full glass stack pair set legs kitchen 20 cm x top middle corner for people 's"
)
WORDS = st.sampled_from(VOCABULARY.split(" "))


@pytest.mark.slow
@settings(max_examples=600, deadline=None)
@given(st.lists(WORDS, min_size=1, max_size=24), st.integers(0, 5))
def test_any_sentence_gives_a_consistent_plan_or_an_input_error(
    words: list[str], seed: int
) -> None:
    _planned_or_refused(" ".join(words), seed)


@pytest.mark.slow
@settings(max_examples=200, deadline=None)
@given(st.text(max_size=200))
def test_any_text_gives_a_plan_or_an_input_error(text: str) -> None:
    _planned_or_refused(text, 0)


def test_the_limit_is_what_the_message_says() -> None:
    text = "a mug on a table".ljust(MAX_CHARACTERS)
    assert len(plan_scene(text, 0).objects) == 1
    with pytest.raises(InputError, match=str(MAX_CHARACTERS)):
        plan_scene(text + " ", 0)


ENGLISH = [
    # ", to its left a book": the relation comes before what it is said of
    ("A laptop. To its right a mouse on a tray, to its left a book.", "book_1",
     {("left_of", "laptop_1")}),
    ("a book, a pen to its right, and behind it a mug", "mug_1", {("behind", "book_1")}),
    ("a mug, on the left a book", "mug_1", set()),
    # what holds a thing goes where the sentence puts it
    ("a bowl with two eggs behind the pot", "bowl_1", {("behind", "pot_1")}),
    ("a bowl with two eggs behind the pot", "egg_1", {("in", "bowl_1")}),
    ("a monitor with a keyboard in front of it", "keyboard_1", {("in_front_of", "monitor_1")}),
    ("a desk with a basket full of two apples, a pear and a lemon, a mug", "lemon_1",
     {("in", "basket_1")}),
    ("a desk with a basket full of two apples, a pear and a lemon, a mug", "mug_1", set()),
    # "and" shares, commas part
    ("a fork on the left, a knife and a spoon right of the plate", "knife_1",
     {("right_of", "plate_1")}),
    ("a desk with a mug, a donut on a plate and a pen", "mug_1", set()),
    ("a desk with a stapler, a mug and a pair of glasses on a book", "stapler_1", set()),
    ("a toy train, two building bricks on top of each other", "building_brick_1", set()),
    ("two stacks of playing cards", "playing_cards_2", set()),
    # what "it", "them" and "the tin" mean
    ("a desk with a tablet, a mug to the right of it", "mug_1", {("right_of", "tablet_1")}),
    ("two screwdrivers, a wrench between them, a can", "wrench_1",
     {("next_to", "screwdriver_1"), ("next_to", "screwdriver_2")}),
    ("two monitors, a keyboard in front of the monitors, a mug to the left of it", "mug_1",
     {("left_of", "keyboard_1")}),
    ("a tea tin and a kettle to the right of the tin", "kettle_1", {("right_of", "tea_tin_1")}),
    ("a laptop with a speaker on either side of the laptop", "speaker_1",
     {("left_of", "laptop_1")}),
    ("a laptop with a speaker on either side of the laptop", "speaker_2",
     {("right_of", "laptop_1")}),
    ("an alarm clock in the back left corner", "alarm_clock_1",
     {("left_of", "table"), ("behind", "table"), ("edge", "table")}),
]  # fmt: skip


@pytest.mark.parametrize(("text", "name", "expected"), RELATIONS + ENGLISH)
def test_relations(text: str, name: str, expected: set[tuple[str, str]]) -> None:
    assert related(plan_scene(text, 0), name) == expected


@pytest.mark.parametrize(
    ("text", "expected", "state"),
    [
        ("three bottles of nail polish", {"nail_polish": 3}, None),
        ("a box of hats", {"box": 1}, "with hats"),
        ("a bowl of chips", {"bowl_of_crisps": 1}, None),
        ("a bag of chips", {"chips_bag": 1}, None),
        ("two teacups with tea", {"teacup": 2}, "with tea"),
        ("a box of pencils", {"box": 1}, "with pencils"),
        ("a box of wipes", {"wipes_canister": 1}, None),
        ("a watermelon slice", {"watermelon_slice": 1}, None),
    ],
)
def test_what_is_in_a_package(text: str, expected: dict[str, int], state: str | None) -> None:
    for seed in range(4):
        plan = plan_scene(f"{text} on a table", seed)
        assert counted(plan) == expected
        assert plan.objects[0].attributes.get("state") == state


@pytest.mark.parametrize(
    ("text", "style"),
    [("a cartoon-style desk with a mug", "cartoon"), ("a low-poly desk with a mug", "low-poly"),
     ("a rustic table with a mug", "rustic"), ("a mug on a low table", "plain")],
)  # fmt: skip
def test_styles(text: str, style: str) -> None:
    plan = plan_scene(text, 0)
    assert plan.style == style
    assert (plan.table.size[2] < 0.5) == ("low table" in text)
    assert counted(plan) == {"mug": 1}


def test_tea_is_laid_for_everyone() -> None:
    plan = plan_scene("a tea table for three", 0)
    assert counted(plan) == {"saucer": 3, "teacup": 3, "spoon": 3, "teapot": 1}
    assert related(plan, "teacup_2") == {("on", "saucer_2")}


def test_the_texts_of_the_benchmark_are_planned_as_they_say() -> None:
    entries = json.loads((Path(__file__).parents[2] / "benchmarks" / "table78.json").read_text())
    plans = [plan_scene(entry["text"], 0) for entry in entries]
    assert len({entry["text"] for entry in entries}) == len(entries) == 78
    assert min(Counter(entry["theme"] for entry in entries).values()) >= 6
    assert len({entry["theme"] for entry in entries}) == 12
    asked = Counter(plan.table.outline for plan in plans)
    assert min(asked[outline] for outline in get_args(OutlineKind)) >= 10
    assert all(4 <= len(plan.objects) <= 10 for plan in plans)
    things = [thing for plan in plans for thing in plan.objects]
    assert sum(thing.category == "generic" for thing in things) < 0.02 * len(things)
    for entry, plan in zip(entries, plans, strict=True):
        named = {"triangular": "triangle", "rectangular": "rectangle"}
        words = {named.get(w, w) for w in tokens(entry["text"])} & set(get_args(OutlineKind))
        assert not words or plan.table.outline in words, entry["text"]
