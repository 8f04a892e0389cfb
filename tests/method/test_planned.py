"""A text's plan corrects missing, duplicate and deviating objects of a reconstruction."""

from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from generator.language.planner import plan_scene
from generator.layout import Layout, arrange_more, build_models, lay_out
from generator.layout.footprint import footprint, gaps
from generator.layout.relation_check import check_relations, foresee
from generator.method.planned import ALIKE, REAL, Laid, SceneDraft, draft_scene, lay_out_draft
from generator.method.planned.draft import compare_sizes
from generator.method.planned.matches import match_planned
from generator.scene import TABLE, Instance, Model, Placement, ScenePlan

TEXT = (
    "A desk with a mug with two pencils in it, a laptop, a stapler and a book with an apple on it"
)


def instance(name: str, label: str, color: tuple[int, int, int] = (255, 255, 255)) -> Instance:
    """Return an instance of which only name, word and colour matter."""
    box, crop = np.array([0.0, 0.0, 8.0, 8.0]), np.full((8, 8, 4), (*color, 255), np.uint8)
    return Instance(name, label, box, np.ones((8, 8), bool), crop, box)


@cache
def planned(text: str) -> tuple[ScenePlan, dict[str, Model], Layout, Model]:
    """Return a text's plan, models, layout and table; read-only."""
    plan = plan_scene(text, 0)
    built = build_models(plan, 1)
    return plan, built, *lay_out(plan, built, 1)


class Found:
    """A planned table with some detected objects, under the names of instances."""

    def __init__(self, text: str, *hidden: str) -> None:
        self.plan, built, layout, table = planned(text)
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
        self.table_scale = np.array(table.size)

    def change(self, name: str, **changes: object) -> None:
        """Change the detection of one object."""
        self.placements = tuple(
            replace(p, **changes) if p.name == name else p
            for p in self.placements  # type: ignore[arg-type]
        )

    def add(self, name: str, like: str, offset: tuple[float, float]) -> None:
        """Add another detected instance, next to a similar one."""
        there = by_name(self.placements)[like]
        label = next(i.label for i in self.instances if i.name == like)
        self.instances = (*self.instances, instance(name, label))
        self.models[name] = self.models[like]
        moved = replace(there, name=name, translation=there.translation + np.array([*offset, 0.0]))
        self.placements = (*self.placements, moved)

    def draft(self, seed: int = 0) -> SceneDraft:
        return draft_scene(
            self.plan, self.instances, self.models, self.placements, self.table_scale, seed, ALIKE
        )

    def lay(self, seed: int = 0) -> Laid:
        return lay_out_draft(self.draft(seed), seed)


def by_name(placements: tuple[Placement, ...]) -> dict[str, Placement]:
    return {p.name: p for p in placements}


def unmet(laid: Laid) -> list[str]:
    rest = foresee(laid.placements, laid.draft.models, laid.table)
    return [o.name for o in check_relations(laid.draft.plan, rest) if not o.holds]


def test_what_was_found_as_planned_stays_where_it_is():
    found = Found(TEXT)
    draft = found.draft()
    assert not draft.warnings
    laid = by_name(lay_out_draft(draft, 0).placements)
    assert set(laid) == {p.name for p in found.placements}
    for there in found.placements:
        np.testing.assert_allclose(laid[there.name].translation, there.translation)
        assert laid[there.name].yaw == there.yaw and laid[there.name].on == there.on
        assert draft.models[there.name].mesh is found.models[there.name].mesh


def test_contents_go_into_their_container_and_things_onto_their_support():
    found = Found(TEXT, "pencil_1", "pencil_2", "apple_1")
    laid = found.lay()
    new = by_name(laid.placements)
    assert len(new) == len(found.plan.objects)
    mug = by_name(found.placements)["seen_mug_1"]
    for name in ("pencil_1", "pencil_2"):
        assert new[name].on == "seen_mug_1" and new[name].inside
        off = np.abs(new[name].translation[:2] - mug.translation[:2])
        assert (off < mug.scale[:2] / 2).all()
        rim = mug.translation[2] + mug.scale[2] / 2
        assert new[name].translation[2] - new[name].scale[2] / 2 < rim - 0.01
    assert new["apple_1"].on == "seen_book_1" and not new["apple_1"].inside
    assert sum("not visible" in warning for warning in laid.draft.warnings) == 3


def test_what_stands_on_the_table_finds_room_beside_the_rest():
    found = Found(TEXT, "stapler_1")
    laid = found.lay()
    new = by_name(laid.placements)["stapler_1"]
    table = found.models[TABLE].size
    assert new.on == TABLE and (np.abs(new.translation[:2]) < table[:2] / 2).all()
    assert new.translation[2] == pytest.approx(table[2] + new.scale[2] / 2)
    own = footprint(laid.draft.models["stapler_1"], new.yaw)
    for other in found.placements:
        if other.on == TABLE:
            shape = footprint(found.models[other.name], other.yaw)
            assert gaps(own, new.translation[None, :2], shape, other.translation[:2])[0] > 0


def test_what_rests_on_something_hidden_comes_with_it():
    new = by_name(Found(TEXT, "book_1", "apple_1").lay().placements)
    assert new["apple_1"].on == "book_1" and new["book_1"].on == TABLE


def test_things_of_one_word_are_told_apart_by_their_support():
    found = Found("A desk with an apple, a book and an apple on the book", "apple_1")
    on = {o.name: {r.kind for r in o.relations} for o in found.plan.objects}
    free = next(n for n, kinds in on.items() if n.startswith("apple") and "on" not in kinds)
    assert free == "apple_1", "the first apple stands on the table"
    built = build_models(found.plan, 0)
    pairs = match_planned(found.plan, found.instances, by_name(found.placements), built)
    assert "apple_1" not in pairs and pairs["apple_2"] == "seen_apple_2"


def test_things_of_one_word_are_told_apart_by_their_color():
    found = Found("A desk with a red mug to the left of a blue mug")
    red, blue = (o.name for o in found.plan.objects)
    colors = {found.names[red]: (30, 40, 180), found.names[blue]: (200, 30, 20)}
    seen = [instance(name, "mug", color) for name, color in colors.items()]
    built = build_models(found.plan, 0)
    pairs = match_planned(found.plan, seen, by_name(found.placements), built)
    assert pairs == {red: found.names[blue], blue: found.names[red]}


def test_things_that_are_alike_are_told_apart_by_where_they_stand():
    text = "A desk with a laptop, a mug to the left of the laptop and a mug to the right of it"
    found = Found(text)
    one, other = (o.name for o in found.plan.objects if o.noun == "mug")
    swap = {found.names[one]: found.names[other], found.names[other]: found.names[one]}
    found.placements = tuple(replace(p, name=swap.get(p.name, p.name)) for p in found.placements)
    built = build_models(found.plan, 0)
    pairs = match_planned(found.plan, found.instances, by_name(found.placements), built)
    assert pairs[one] == found.names[other] and pairs[other] == found.names[one]


@pytest.mark.parametrize(
    ("label", "matches"),
    [("mug", True), ("coffee mug", True), ("striped ceramic mug", True), ("laptop", False)],
)
def test_other_words_for_a_thing_mean_it_too(label, matches):
    found = Found("A desk with a mug")
    built = build_models(found.plan, 0)
    shown = (instance("seen_mug_1", label),)
    pairs = match_planned(found.plan, shown, by_name(found.placements), built)
    assert pairs == ({"mug_1": "seen_mug_1"} if matches else {})


@pytest.mark.parametrize(
    ("have", "factor"),
    [
        ((0.3, 0.2, 0.1), 1.0),
        ((0.2, 0.3, 0.1), 1.0),  # turned by a quarter
        ((0.39, 0.2, 0.1), 1.0),  # near enough
        ((0.15, 0.1, 0.05), 2.0),
        ((0.3, 0.2, 0.3), None),  # three times as high
        ((0.15, 0.15, 0.1), None),  # a pan that lost its handle
    ],
)
def test_a_size_agrees_or_is_scaled_or_means_another_shape(have, factor):
    got = compare_sizes(np.array(have), np.array([0.3, 0.2, 0.1]), 1.35)
    assert got == (None if factor is None else pytest.approx(factor))


def test_thin_things_may_differ_by_millimetres():
    assert compare_sizes(np.array([0.2, 0.2, 0.006]), np.array([0.2, 0.2, 0.012]), 1.5) == 1.0


def test_a_thing_of_another_size_gets_the_plans():
    found = Found(TEXT)
    big = by_name(found.placements)["seen_stapler_1"].scale * 2.5
    found.change("seen_stapler_1", scale=big)
    draft = found.draft()
    model = draft.models["seen_stapler_1"]
    np.testing.assert_allclose(
        np.prod(model.size), np.prod(draft.planned["seen_stapler_1"].size), rtol=1e-6
    )
    assert model.mesh is found.models["seen_stapler_1"].mesh
    assert any("seen_stapler_1 has the planned size" in w for w in draft.warnings)


def test_a_thing_of_another_shape_is_built_from_the_plan():
    found = Found(TEXT)
    tall = by_name(found.placements)["seen_laptop_1"].scale * [1, 1, 4]
    found.change("seen_laptop_1", scale=tall)
    draft = found.draft()
    assert draft.models["seen_laptop_1"] is draft.planned["seen_laptop_1"]
    assert any("seen_laptop_1 is built from the plan" in w for w in draft.warnings)


def test_a_size_that_the_text_tells_is_kept():
    found = Found("Three colored blocks, small, medium and large, ordered from left to right")
    for there in found.placements:
        found.change(there.name, scale=np.full(3, 0.045))
    draft = found.draft()
    sizes = [draft.models[o.name].size.max() for o in draft.plan.objects]
    assert sizes == sorted(sizes) and sizes[2] > 1.3 * sizes[0]


def test_what_is_laid_at_all_seats_looks_alike():
    found = Found("A table set for two: a plate, a fork on the left and a knife on the right")
    forks = [found.names[o.name] for o in found.plan.objects if o.noun == "fork"]
    long = by_name(found.placements)[forks[0]].scale * [1, 6, 1]
    found.change(forks[0], scale=long)
    draft = found.draft()
    assert len(forks) == 2 and all(draft.models[n] is draft.planned[n] for n in forks)
    assert any(draft.models[n] is not draft.planned[n] for n in draft.shown)


def test_real_things_may_differ_more_from_the_catalogues():
    found = Found("A desk with a teapot")
    slim = by_name(found.placements)["seen_teapot_1"].scale * [1.15, 0.7, 0.95]
    found.change("seen_teapot_1", scale=slim)
    facts = found.plan, found.instances, found.models, found.placements, found.table_scale, 0
    real, drawn = draft_scene(*facts, REAL), draft_scene(*facts, ALIKE)
    assert real.models["seen_teapot_1"].mesh is found.models["seen_teapot_1"].mesh
    assert drawn.models["seen_teapot_1"] is drawn.planned["seen_teapot_1"]


def test_a_stand_in_takes_no_found_things_place():
    found = Found("A desk with a clavichord")
    name = next(iter(found.names.values()))
    found.change(name, scale=by_name(found.placements)[name].scale * [1, 1, 4])
    draft = found.draft()
    assert draft.models[name].mesh is found.models[name].mesh


def test_a_double_is_left_out():
    found = Found(TEXT)
    found.add("seen_mug_9", "seen_mug_1", (0.15, 0.1))
    found.change("seen_mug_9", scale=by_name(found.placements)["seen_mug_1"].scale * 0.6)
    laid = found.lay()
    assert len(laid.placements) == len(found.plan.objects)
    assert "seen_mug_9" not in by_name(laid.placements)
    assert any("seen_mug_9 is left out" in w for w in laid.draft.warnings)


def test_the_table_has_the_plans_size_and_its_things_their_share_of_it():
    found = Found("A desk with a mug to the left of a laptop")
    before = by_name(found.placements)
    found.table_scale = found.table_scale * [2, 2, 1]
    for name, there in before.items():
        found.change(name, translation=there.translation * [2, 2, 1])
    draft = found.draft()
    np.testing.assert_allclose(draft.table.size, found.models[TABLE].size, rtol=0.02)
    for name, there in before.items():
        np.testing.assert_allclose(draft.shown[name].translation, there.translation, atol=0.01)


def test_a_thing_on_the_wrong_support_comes_where_the_plan_has_it():
    found = Found(TEXT)
    place = by_name(found.placements)["seen_apple_1"].translation + np.array([0, 0.2, 0])
    found.change("seen_apple_1", on=TABLE, translation=place)
    laid = found.lay()
    assert by_name(laid.placements)["seen_apple_1"].on == "seen_book_1"
    assert any("seen_apple_1" in w for w in laid.warnings)
    before, after = (by_name(p)["seen_book_1"] for p in (found.placements, laid.placements))
    np.testing.assert_allclose(after.translation, before.translation)


def test_what_is_on_the_wrong_side_moves_and_the_rest_stays():
    found = Found("A desk with a laptop, a mug to the left of the laptop and a stapler")
    before = by_name(found.placements)
    laptop, mug = before["seen_laptop_1"], before["seen_mug_1"]
    mirrored = mug.translation + 2 * (laptop.translation - mug.translation) * [1, 0, 0]
    found.change("seen_mug_1", translation=mirrored)
    laid = found.lay()
    after = by_name(laid.placements)
    assert not unmet(laid)
    assert after["seen_mug_1"].translation[0] < after["seen_laptop_1"].translation[0]
    np.testing.assert_allclose(after["seen_laptop_1"].translation, laptop.translation)


def test_rows_are_the_plans():
    found = Found("Three mugs in a row on a table")
    middle = by_name(found.placements)["seen_mug_2"].translation
    found.change("seen_mug_2", translation=middle + np.array([0, 0.2, 0]))
    at = np.array([p.translation[:2] for p in found.lay().placements])
    assert np.ptp(at[:, 1]) < 0.03 < np.ptp(at[:, 0])


def test_a_row_without_room_leaves_its_members_out_one_by_one():
    found = Found("Three mugs in a row on a table", "mug_1", "mug_2", "mug_3")
    table = replace(found.models[TABLE], size=np.array([0.16, 0.16, 0.7]))
    draft = found.draft()
    more = arrange_more(draft.plan, {}, draft.models, table, 0)
    assert len(more.placements) < 3 and any("no free place" in w for w in more.warnings)


def test_of_two_in_one_place_one_moves():
    found = Found("A desk with a laptop and a book")
    laptop = by_name(found.placements)["seen_laptop_1"]
    found.change("seen_book_1", translation=laptop.translation)
    laid = found.lay()
    after = by_name(laid.placements)
    np.testing.assert_allclose(after["seen_laptop_1"].translation, laptop.translation)
    own, other = (footprint(laid.draft.models[n], after[n].yaw) for n in after)
    places = [p.translation[:2] for p in after.values()]
    assert gaps(own, places[0][None], other, places[1])[0] > 0


def test_a_doubted_thing_is_the_plans():
    draft = Found(TEXT).draft().doubt(("seen_mug_1",), "it does not stand")
    assert draft.models["seen_mug_1"] is draft.planned["seen_mug_1"]
    assert "seen_mug_1" not in draft.shown and "seen_laptop_1" in draft.shown
    assert "seen_mug_1 is built from the plan: it does not stand." in draft.warnings
    after = lay_out_draft(draft, 0)
    inside = [p for p in after.placements if p.on == "seen_mug_1" and p.inside]
    assert len(inside) == 2


def test_same_seed_same_places():
    found = Found(TEXT, "stapler_1", "pencil_1")
    one, two = found.lay(3), found.lay(3)
    for a, b in zip(one.placements, two.placements, strict=True):
        np.testing.assert_array_equal(a.translation, b.translation)
        assert a.yaw == b.yaw
