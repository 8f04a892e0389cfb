"""Tables drawn without a text."""

import numpy as np
import pytest

from generator.composition import compose
from generator.errors import InputError
from generator.language.distribution import SceneDistribution, categories_known, themes_known
from generator.scene import ScenePlan


def plans(distribution: SceneDistribution, count: int = 40) -> list[ScenePlan]:
    return [distribution.plan(np.random.default_rng(seed)) for seed in range(count)]


def test_a_plan_follows_from_the_generator_alone() -> None:
    distribution = SceneDistribution()
    assert plans(distribution, 5) == plans(SceneDistribution(), 5)
    assert len(set(map(repr, plans(distribution)))) == 40


def test_all_themes_come_and_each_keeps_to_its_own_things() -> None:
    drawn = plans(SceneDistribution(), 200)
    assert {theme for theme in themes_known() if any(f" {theme} " in p.prompt for p in drawn)} == {
        *themes_known()
    }
    labs = plans(SceneDistribution(themes=("lab",)))
    assert all(any(o.category == "microscope" for o in p.objects) for p in labs)
    assert {o.category for p in labs for o in p.objects} <= {*categories_known()}


def test_counts_shapes_and_styles_are_those_asked_for() -> None:
    distribution = SceneDistribution(
        objects=(2, 5), tables=("round", "oval"), styles=("cartoon", "low-poly")
    )
    drawn = plans(distribution)
    assert {len(p.objects) for p in drawn} == {2, 3, 4, 5}
    assert {p.table.outline for p in drawn} == {"round", "oval"}
    assert {p.style for p in drawn} == {"cartoon", "low-poly"}
    assert "5 objects, cartoon style" in " ".join(p.prompt for p in drawn)


def test_more_than_the_themes_own_list_comes_from_the_catalogue() -> None:
    from generator.language.themes import THEMES

    many = plans(SceneDistribution(themes=("office",), objects=(14, 14)), 5)
    assert all(len(p.objects) == 14 for p in many)
    assert len({o.category for p in many for o in p.objects}) > len(THEMES["office"].things)


def test_what_is_listed_twice_comes_twice_as_often() -> None:
    drawn = plans(SceneDistribution(themes=("lab", "lab", "tea")), 300)
    labs = sum(" lab " in p.prompt for p in drawn)
    assert 170 < labs < 230


@pytest.mark.parametrize(
    ("settings", "message"),
    [
        ({"themes": ("ofice",)}, "unknown value 'ofice'. Did you mean 'office'"),
        ({"themes": "office"}, "a tuple, got the string"),
        ({"tables": ("circle",)}, "unknown value 'circle'.*round"),
        ({"styles": ("comic",)}, "unknown value 'comic'.*cartoon"),
        ({"styles": ()}, "needs a style"),
        ({"objects": (5, 3)}, "minimum first"),
        ({"objects": (0, 3)}, "from 1 to 24"),
        ({"objects": 5}, "the minimum and maximum"),
        ({"objects": (2.5, 3)}, "the minimum and maximum"),
        ({"needs": ("tray",)}, "the possible objects of each need"),
        ({"needs": ((),)}, "the possible objects of each need"),
        ({"needs": (("tray", "trsy"),)}, "unknown object 'trsy'"),
        ({"needs": (("small",),)}, "unknown object 'small'"),
    ],
)
def test_wrong_settings_are_explained(settings, message) -> None:
    with pytest.raises(InputError, match=message):
        SceneDistribution(**settings)


def test_needs_are_on_each_table_whatever_its_theme() -> None:
    trays, things = ("tray", "large basket"), ("egg", "die", "apple", "pear")
    drawn = plans(SceneDistribution(needs=(trays, things, things)), 60)
    plain = plans(SceneDistribution(), 60)
    for plan in drawn:
        kinds = [o.category for o in plan.objects]
        assert set(kinds) & {"tray", "basket"} and len(set(kinds) & {*things}) >= 2
        assert 4 <= len(kinds) <= 8
        sizes = [dict(o.attributes) for o in plan.objects if o.category in ("tray", "basket")]
        assert {} in sizes or {"size": "large"} in sizes
    last = [p.objects[-1].category for p in drawn]
    assert len(set(last)) == len(things)
    assert len({o.category for p in drawn for o in p.objects}) > 60
    assert [p.table for p in drawn] != [p.table for p in plain]


def test_of_a_need_the_themes_own_things_come_first() -> None:
    needs = (("beaker", "rubber duck"),)
    labs = plans(SceneDistribution(themes=("lab",), objects=(2, 2), needs=needs), 10)
    assert all("rubber duck" not in {o.noun for o in p.objects} for p in labs)
    tables = plans(SceneDistribution(themes=("dining",), objects=(2, 2), needs=needs), 20)
    assert {p.objects[-1].noun for p in tables} == {"beaker", "rubber duck"}


def test_a_need_that_is_there_already_is_met_by_another_of_its_things() -> None:
    drawn = plans(SceneDistribution(("lab",), (6, 6), needs=(("microscope",), ("beaker",) * 2)), 5)
    for plan in drawn:
        names = [o.name for o in plan.objects]
        assert len(set(names)) == len(names)
        assert sum(o.category == "microscope" for o in plan.objects) == 1


@pytest.mark.slow
def test_a_drawn_plan_composes_to_what_it_says() -> None:
    plan = SceneDistribution(("tea",), (3, 3), ("oval",), ("low-poly",)).plan(
        np.random.default_rng(0)
    )
    scene = compose(plan, 0)
    assert scene.report is not None and scene.report.passed
    assert [o.model.category for o in scene.objects] == [o.category for o in plan.objects]
    assert scene.plan is not None and scene.plan.table.outline == "oval"
