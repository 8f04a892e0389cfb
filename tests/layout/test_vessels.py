"""Objects in vessels, racks and boxes: separate places without overlap."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from generator.composition import compose
from generator.language.planner import plan_scene
from generator.language.vessel_sizes import cut_category, grow_carriers, open_category
from generator.layout import build_models, lay_out
from generator.layout.bunches import arrange_bunch, measure_stem
from generator.layout.cavities import find_cavity
from generator.layout.holders import file_away, head_up, stand_in_holder
from generator.layout.orientation import stand_up
from generator.method.assembly import bring_to_rest
from generator.physics.simulation import Simulation
from generator.scene import PlannedObject, Provenance, Relation
from tabletop_objects import CATEGORIES, build

HOLDERS = [key for key, found in CATEGORIES.items() if found.holder is not None]


@pytest.mark.parametrize("key", ["empty_vase", "open_jar", "mug", "open_ice_bucket", "crate"])
@pytest.mark.parametrize("seed", [0, 1, 2])
def test_a_vessel_is_hollow_down_to_its_bottom(key: str, seed: int) -> None:
    model = build(key, seed)
    cavity = find_cavity(model)
    assert cavity is not None
    assert cavity.depth > 0.8 * model.size[2]
    assert 0.3 * model.size[:2].min() < cavity.mouth < model.size[:2].min()


def test_what_is_solid_has_no_cavity() -> None:
    assert find_cavity(build("apple", 0)) is None
    assert find_cavity(build("book", 0)) is None


@pytest.mark.parametrize("key", HOLDERS)
def test_a_holder_has_the_places_asked_for(key: str) -> None:
    model = build(key, 3, attributes={"places": "5"})
    assert len(model.slots) == 5
    assert len({tuple(slot.at.round(6)) for slot in model.slots}) == 5
    assert all((np.abs(slot.at) <= 0.5).all() for slot in model.slots)


@pytest.mark.parametrize(
    ("holder", "thing"),
    [("empty_toast_rack", "toast"), ("empty_dish_rack", "plate"), ("letter_rack", "envelope"),
     ("empty_tube_rack", "test_tube"), ("empty_wine_rack", "wine_bottle")],
)  # fmt: skip
def test_things_stand_in_a_holder_as_it_says(holder: str, thing: str) -> None:
    kind, model = CATEGORIES[holder].holder, build(thing, 0)
    assert kind is not None
    x, y, z = (float(v) for v in model.size)
    assert kind.takes((x, y, z))
    np.testing.assert_allclose(stand_in_holder(model, kind).size, kind.stand((x, y, z)))


def test_a_holder_takes_nothing_that_is_too_large() -> None:
    kind = CATEGORIES["empty_toast_rack"].holder
    assert kind is not None and not kind.takes((0.25, 0.25, 0.023))


@pytest.mark.parametrize("count", [1, 3, 6, 12])
def test_stems_keep_clear_of_each_other_and_of_the_wall(count: int) -> None:
    flower = build("lavender", 0, attributes={"stands": "in a vessel"})
    stem = measure_stem(head_up(stand_up(flower, 1.7)))
    vessel = build("empty_vase", 0)
    cavity = find_cavity(replace(vessel, size=vessel.size * [1.4, 1.4, 1.0]))
    assert cavity is not None
    stances = arrange_bunch([stem] * count, cavity, [False] * count, strict=False)
    lines = [(s.foot, s.turn[:, 2]) for s in stances if s is not None]
    assert len(lines) == count
    for k, (foot, axis) in enumerate(lines):
        assert axis[2] > 0.5  # none lies
        rim = foot + axis * (cavity.rim - foot[2]) / axis[2]
        assert np.hypot(*(rim[:2] - cavity.middle)) < cavity.mouth / 2
        for there, way in lines[:k]:
            normal = np.cross(axis, way)
            if np.linalg.norm(normal) > 1e-3:
                gap = abs(float((there - foot) @ normal)) / np.linalg.norm(normal)
                assert gap >= 2 * stem.core - 1e-3


def test_heads_are_up() -> None:
    for key in ("whisk", "spatula", "rose"):
        stem = measure_stem(head_up(stand_up(build(key, 0), 1.7)))
        wide = np.hypot(*stem.spheres[:, :2].T) + stem.spheres[:, 3]
        assert wide[stem.spheres[:, 2] > 0.6 * stem.length].max() == pytest.approx(wide.max())


def test_flat_things_are_filed_in_a_box_and_not_in_a_bowl() -> None:
    books = {f"book_{k}": build("book", 0) for k in range(3)}
    box, bowl = find_cavity(build("open_box", 0)), find_cavity(build("bowl", 0))
    assert box is not None and bowl is not None
    filed = file_away(books, box)
    assert filed is not None and file_away(books, bowl) is None
    middles = np.array([middle for _, middle in filed.values()])
    steps = np.linalg.norm(np.diff(middles, axis=0), axis=1)
    assert (steps >= float(books["book_0"].size.min())).all()
    assert all(turn[2] @ [0, 0, 1] < 0.3 for turn, _ in filed.values())  # none lies


@pytest.mark.parametrize("text", ["a vase with five tulips", "five test tubes in a rack",
                                  "four plates in a dish rack", "three pens in a mug"])  # fmt: skip
def test_nothing_overlaps_where_it_is_put(text: str) -> None:
    plan = plan_scene(text, 0)
    models = build_models(plan, 0)
    layout, table = lay_out(plan, models, 0)
    rested = bring_to_rest(
        models, layout.placements, table, table.size, name="scene", plan=plan,
        provenance=Provenance("compose", 0, text),
    )  # fmt: skip
    simulation = Simulation(rested.arranged)
    assert max(simulation.contacts().deepest().values(), default=0.0) < 5e-4
    assert not layout.warnings


def test_both_planners_open_what_is_filled() -> None:
    inside = (Relation("in", "it"),)
    for closed, opened, thing in (("vase", "empty_vase", "rose"), ("jar", "open_jar", "cookie"),
                                  ("toast_rack", "empty_toast_rack", "toast")):  # fmt: skip
        planned = [PlannedObject("it", closed, closed),
                   PlannedObject("thing", thing, thing, relations=inside)]  # fmt: skip
        assert grow_carriers(planned)[0].category == opened
    assert grow_carriers([PlannedObject("it", "vase", "vase")])[0].category == "vase"


def test_a_rack_is_the_one_for_what_it_holds() -> None:
    assert open_category("dish_rack", "rack", "test_tube") == "empty_tube_rack"
    assert open_category("dish_rack", "rack", "plate") == "empty_dish_rack"
    assert open_category("dish_rack", "dish rack", "toast") == "empty_dish_rack"
    assert [cut_category("vase", "vase", k) for k in range(2)] == ["rose", "tulip"]
    assert cut_category("bouquet", "vase", 0) == "posy"
    assert cut_category("bouquet", "basket", 0) == "bouquet"


@pytest.mark.slow
@pytest.mark.parametrize(
    "text",
    ["a vase with three sunflowers", "a toast rack with four slices of toast",
     "four plates in a dish rack", "three knives in a knife block", "a bouquet in a vase",
     "two wine bottles in a wine rack", "four books in a box", "two baguettes in a basket",
     "a wine bottle in an ice bucket", "a seedling in a pot", "dumplings in a steamer",
     "a glass rod in a beaker", "cotton swabs in a jar", "six beer bottles in a bucket"],
)  # fmt: skip
def test_what_is_put_in_stays_in(text: str) -> None:
    scene = compose(text, 0)
    assert scene.report is not None and scene.report.passed
    kinds = [o.kind for o in scene.report.relations]
    assert kinds.count("in") == len(scene.objects) - 1
    assert all(o.holds for o in scene.report.relations)
