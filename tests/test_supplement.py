"""What a plan asks for and no instance shows comes where the plan has it."""

from dataclasses import replace

import numpy as np
import pytest

from generator.language.planner import plan_scene
from generator.layout import build_models, lay_out
from generator.layout.footprint import footprint, gaps
from generator.method.supplement import NOTHING, Supplement, match_planned, supplement
from generator.scene import TABLE, Instance, Model, Placement, ScenePlan

TEXT = (
    "A desk with a mug with two pencils in it, a laptop, a stapler and a book with an apple on it"
)


def instance(name: str, label: str) -> Instance:
    """Return an instance of which only name and word matter."""
    box = np.array([0.0, 0.0, 8.0, 8.0])
    return Instance(name, label, box, np.ones((8, 8), bool), np.full((8, 8, 4), 255, np.uint8), box)


class Found:
    """A planned table of which some things were found, under the names of instances."""

    def __init__(self, text: str, *hidden: str) -> None:
        self.plan: ScenePlan = plan_scene(text, 0)
        built = build_models(self.plan, 1)
        layout, table = lay_out(self.plan, built, 1)
        shown = [o for o in self.plan.objects if o.name not in hidden]
        self.names = {o.name: f"seen_{o.name}" for o in shown}
        self.instances = (
            instance(TABLE, TABLE),
            *(instance(self.names[o.name], o.noun) for o in shown),
        )
        self.models: dict[str, Model] = {TABLE: table}
        self.models |= {self.names[o.name]: built[o.name] for o in shown}
        self.placements = tuple(
            replace(p, name=self.names[p.name], on=self.names.get(p.on, p.on))
            for p in layout.placements
            if p.name in self.names
        )

    def add(self, seed: int = 0) -> Supplement:
        return supplement(
            self.plan, self.instances, self.models, self.placements, self.models[TABLE].size, seed
        )


def by_name(placements: tuple[Placement, ...]) -> dict[str, Placement]:
    return {p.name: p for p in placements}


def test_a_picture_without_a_text_asks_for_nothing():
    found = Found(TEXT)
    size = found.models[TABLE].size
    assert supplement(None, found.instances, found.models, found.placements, size, 0) is NOTHING


def test_nothing_is_added_where_everything_was_found():
    assert Found(TEXT).add() is NOTHING


def test_contents_go_into_their_container_and_things_onto_their_support():
    found = Found(TEXT, "pencil_1", "pencil_2", "apple_1")
    extra = found.add()
    new = by_name(extra.placements)
    assert set(new) == set(extra.models) == {"pencil_1", "pencil_2", "apple_1"}
    mug = by_name(found.placements)["seen_mug_1"]
    for name in ("pencil_1", "pencil_2"):
        assert new[name].on == "seen_mug_1" and new[name].inside
        off = np.abs(new[name].translation[:2] - mug.translation[:2])
        assert (off < mug.scale[:2] / 2).all()
        rim = mug.translation[2] + mug.scale[2] / 2
        assert new[name].translation[2] - new[name].scale[2] / 2 < rim - 0.01
    assert new["apple_1"].on == "seen_book_1" and not new["apple_1"].inside
    assert len(extra.warnings) == 3
    assert all("not to be seen" in warning for warning in extra.warnings)


def test_what_stands_on_the_table_finds_room_beside_the_rest():
    found = Found(TEXT, "stapler_1")
    (new,) = found.add().placements
    table = found.models[TABLE].size
    assert new.on == TABLE and (np.abs(new.translation[:2]) < table[:2] / 2).all()
    assert new.translation[2] == pytest.approx(table[2] + new.scale[2] / 2)
    own = footprint(found.add().models["stapler_1"], new.yaw)
    for other in found.placements:
        if other.on == TABLE:
            shape = footprint(found.models[other.name], other.yaw)
            assert gaps(own, new.translation[None, :2], shape, other.translation[:2])[0] > 0


def test_what_a_row_lacks_is_added_whatever_the_rest_is_called():
    found = Found("A desk with a mug, a can and a stapler in a row", "can_1")
    assert set(by_name(found.add().placements)) == {"can_1"}


def test_what_rests_on_something_hidden_comes_with_it():
    new = by_name(Found(TEXT, "book_1", "apple_1").add().placements)
    assert new["apple_1"].on == "book_1" and new["book_1"].on == TABLE


def test_things_of_one_word_are_told_apart_by_their_support():
    found = Found("A desk with an apple, a book and an apple on the book", "apple_1")
    on = {o.name: {r.kind for r in o.relations} for o in found.plan.objects}
    free = next(n for n, kinds in on.items() if n.startswith("apple") and "on" not in kinds)
    assert free == "apple_1", "the first apple stands on the table"
    labels = {i.name: i.label for i in found.instances if i.name != TABLE}
    pairs = match_planned(found.plan, labels, by_name(found.placements))
    assert "apple_1" not in pairs and pairs["apple_2"] == "seen_apple_2"


def test_without_room_it_is_left_out_and_said():
    found = Found("A desk with a laptop and a monitor", "monitor_1")
    laptop = by_name(found.placements)["seen_laptop_1"]
    found.placements = (replace(laptop, translation=np.array([0.0, 0.0, 1.0])),)
    found.models[TABLE] = replace(found.models[TABLE], size=laptop.scale[[0, 1, 0]] + 0.05)
    extra = found.add()
    assert not extra.placements and not extra.models
    assert any("no room" in warning for warning in extra.warnings)


def test_what_spoils_the_gate_is_left_out_again():
    extra = Found(TEXT, "book_1", "apple_1", "pencil_1").add()
    less = extra.without(("book_1 overlaps seen_laptop_1 by 2.0 mm",))
    assert {p.name for p in less.placements} == set(less.models) == {"pencil_1"}
    assert sum("left out" in warning for warning in less.warnings) == 2
    assert not extra.without(("seen_laptop_1 floats",)).placements


def test_same_seed_same_places():
    found = Found(TEXT, "stapler_1", "pencil_1")
    one, two = found.add(3), found.add(3)
    for a, b in zip(one.placements, two.placements, strict=True):
        np.testing.assert_array_equal(a.translation, b.translation)
        assert a.yaw == b.yaw
