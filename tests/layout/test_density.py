"""Density of a table, from words of the text or from the settings."""

import pytest

from generator.composition import compose
from generator.errors import InputError
from generator.language.planner import plan_scene
from generator.layout import build_models, lay_out
from generator.layout.footprint import footprint, gaps
from generator.scene import Density, PlannedTable, ScenePlan


@pytest.mark.parametrize(
    ("text", "density"),
    [("a cluttered desk", "dense"), ("a minimalist desk", "sparse"), ("a desk", "normal"),
     ("a desk with a mug", "normal")],
)  # fmt: skip
def test_words(text: str, density: Density) -> None:
    assert plan_scene(text, 0).density == density


def test_a_theme_alone_puts_more_on_a_dense_table() -> None:
    wanted: tuple[Density, ...] = ("sparse", "normal", "dense")
    counts = {d: len(plan_scene("an office desk", 1, d).objects) for d in wanted}
    assert counts["sparse"] < counts["normal"] < counts["dense"]
    assert counts["dense"] >= 10


def test_what_a_text_names_is_all_that_a_dense_table_has() -> None:
    assert len(plan_scene("a crowded table with a plate and two mugs", 0).objects) == 3


def test_things_of_a_dense_table_are_nearer_to_each_other() -> None:
    text = "a plate, a mug, a bowl, a vase, a candle, a spoon and an apple on a table"
    nearest: dict[str, float] = {}
    for density in ("sparse", "dense"):
        plan = plan_scene(text, 3, density)
        models = build_models(plan, 3)
        rooms = []
        for seed in range(4):
            places = lay_out(plan, models, seed)[0].placements
            shapes = {p.name: footprint(models[p.name], p.yaw) for p in places}
            for one in places:
                rooms += [min(
                    float(gaps(shapes[one.name], one.translation[None, :2], shapes[other.name],
                               other.translation[:2])[0])
                    for other in places if other is not one
                )]  # fmt: skip
        nearest[density] = sum(rooms) / len(rooms)
    assert nearest["dense"] < 0.7 * nearest["sparse"]


def test_it_is_kept_with_the_plan() -> None:
    scene = compose("a mug and a plate on a desk", 0, density="dense")
    assert scene.plan is not None and scene.plan.density == "dense"


def test_other_words_are_refused() -> None:
    with pytest.raises(InputError, match="density"):
        ScenePlan("", PlannedTable(), (), density="full")  # type: ignore[arg-type]
