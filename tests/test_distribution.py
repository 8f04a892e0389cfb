"""Tables drawn without a text."""

from __future__ import annotations

import numpy as np
import pytest

from generator.compose import compose
from generator.distribution import SceneDistribution, categories_known, themes_known
from generator.errors import InputError
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
    from generator.backends.embedded.themes import THEMES

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
        ({"themes": ("ofice",)}, "no 'ofice'. Did you mean 'office'"),
        ({"themes": "office"}, "a tuple, got the text"),
        ({"tables": ("circle",)}, "no 'circle'.*round"),
        ({"styles": ("comic",)}, "no 'comic'.*cartoon"),
        ({"styles": ()}, "needs a style"),
        ({"objects": (5, 3)}, "the least first"),
        ({"objects": (0, 3)}, "from 1 to 24"),
        ({"objects": 5}, "the least and the most"),
        ({"objects": (2.5, 3)}, "the least and the most"),
    ],
)
def test_wrong_settings_are_explained(settings, message) -> None:
    with pytest.raises(InputError, match=message):
        SceneDistribution(**settings)


def test_a_drawn_plan_composes_to_what_it_says() -> None:
    plan = SceneDistribution(("tea",), (3, 3), ("oval",), ("low-poly",)).plan(
        np.random.default_rng(0)
    )
    scene = compose(plan, 0)
    assert scene.report is not None and scene.report.passed
    assert [o.model.category for o in scene.objects] == [o.category for o in plan.objects]
    assert scene.plan is not None and scene.plan.table.outline == "oval"
