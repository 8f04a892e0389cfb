"""Descriptions after a noun, and vessels with their contents."""

from __future__ import annotations

import pytest
from plans import all_related, counts, found, plan


@pytest.mark.parametrize(
    ("text", "name", "attributes", "expected"),
    [
        ("A vase, tall and slim, and a candle.", "vase_1", {"size": "large"},
         {"vase": 1, "candle": 1}),
        ("A lamp, black and modern, next to a laptop.", "desk_lamp_1",
         {"color": "black", "state": "modern"}, {"desk_lamp": 1, "laptop": 1}),
        ("A plate, white and round, and a mug.", "plate_1", {"color": "white", "state": "round"},
         {"plate": 1, "mug": 1}),
        ("A mug, blue in colour, and a plate.", "mug_1", {"color": "blue"}, {"mug": 1, "plate": 1}),
        ("A pencil, yellow, an eraser, white, and a ruler.", "eraser_1", {"color": "white"},
         {"pencil": 1, "eraser": 1, "ruler": 1}),
        ("A table with a bowl, empty and clean, and two spoons.", "bowl_1", {"state": "empty"},
         {"bowl": 1, "spoon": 2}),
        ("A glass, empty, and a plate.", "glass_1", {"state": "empty"}, {"glass": 1, "plate": 1}),
        ("A cloth, folded, beside a mug.", "cloth_1", {"state": "folded"}, {"cloth": 1, "mug": 1}),
        ("A paper, white, and a pencil.", "paper_stack_1", {"color": "white"},
         {"paper_stack": 1, "pencil": 1}),
        ("A towel dyed blue and a mug.", "folded_towel_1", {"color": "blue"},
         {"folded_towel": 1, "mug": 1}),
        ("A glass stained red and a mug.", "glass_1", {"color": "red"}, {"glass": 1, "mug": 1}),
    ],
)  # fmt: skip
def test_describing_words_after_a_noun_are_its(
    text: str, name: str, attributes: dict[str, str], expected: dict[str, int]
) -> None:
    assert found(plan(text), name).attributes == attributes
    assert counts(text) == expected


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("A cloth folded in the corner.", {"cloth": 1}),
        ("Cloth folded at the back of the desk and a mug.", {"cloth": 1, "mug": 1}),
        ("Paper crumpled beside a mug.", {"paper_stack": 1, "mug": 1}),
        ("A glass broken beside a plate.", {"glass": 1, "plate": 1}),
        ("A paper wrapped sandwich and a glass sealed jar.", {"sandwich": 1, "jar": 1}),
    ],
)
def test_what_a_material_names_may_be_described_after_it(
    text: str, expected: dict[str, int]
) -> None:
    assert counts(text) == expected


def test_a_thing_described_after_its_noun_has_its_place() -> None:
    text = "A lamp, black and modern, next to a laptop."
    assert all_related(text) == {("desk_lamp_1", "next_to", "laptop_1")}


def test_single_ones_of_a_colour_are_things() -> None:
    for text in ("a red and a blue mug", "a red mug, a green and a white one"):
        colors = [o.attributes["color"] for o in plan(text).objects]
        assert len(set(colors)) == len(colors) > 1


def test_a_colour_of_nothing_is_told() -> None:
    assert plan("A mug and a red.").warnings == ("Not understood: 'red'.",)
    assert plan("A mug, rustic.").warnings == ()


@pytest.mark.parametrize(
    ("text", "names"),
    [
        ("A glass half full of water stands beside a plate.", ["glass of water", "plate"]),
        ("A jug full of water.", ["jug of water"]),
        ("A bucket full of water.", ["bucket of water"]),
        ("Two glasses half filled with milk.", ["glass of milk", "glass of milk"]),
        ("There is a bottle. It is full of milk.", ["bottle of milk"]),
        ("A jug full of water and a glass full of ice.", ["jug of water", "glass", "ice"]),
    ],
)
def test_a_substance_fills_its_vessel(text: str, names: list[str]) -> None:
    assert [o.noun for o in plan(text).objects] == names


def test_what_a_vessel_is_full_of_ends_at_an_article() -> None:
    text = "A bowl half full of cherries and a spoon."
    assert all_related(text) == {("cherries_1", "in", "bowl_1")}
    held = all_related("a jug full of water and a glass full of ice")
    assert held == {("ice_cube_1", "in", "glass_1")}


@pytest.mark.parametrize(
    ("text", "mugs"), [("mugs of various sizes", 2), ("The mugs are red, blue and white.", 3)]
)
def test_what_a_verb_lists_says_how_many_there_are(text: str, mugs: int) -> None:
    assert counts(text) == {"mug": mugs}


def test_what_is_drawn_on_a_thing_is_understood() -> None:
    assert plan("a mug with a picture of a cat").warnings == ()
