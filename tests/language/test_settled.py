"""The requests of a text hold in the settled scene, or give a warning."""

from __future__ import annotations

import numpy as np
import pytest

from generator.composition import compose


@pytest.mark.slow
@pytest.mark.parametrize(
    ("text", "name", "support"),
    [
        ("a bun on a basket", "bread_roll_1", "basket_1"),
        ("a bowl with a banana and two apples", "banana_1", "bowl_1"),
        ("a fruit bowl with three apples, a banana and grapes", "banana_1", "serving_bowl_1"),
        ("a whisk inside a mixing bowl", "whisk_1", "mixing_bowl_1"),
        ("a mug of pens", "pen_2", "mug_1"),
        ("a tray holding a teapot, a jug and 2 cups", "mug_2", "tray_1"),
        ("a monitor on two books", "monitor_1", "book_2"),
        ("a bowl with two apples", "apple_2", "bowl_1"),
        ("a bowl with three oranges", "orange_3", "bowl_1"),
    ],
)
def test_things_rest_where_the_text_puts_them(text: str, name: str, support: str) -> None:
    scene = compose(text, 0)
    assert scene.object(name).placement.on == support
    assert scene.report is not None and all(o.holds for o in scene.report.relations)


@pytest.mark.slow
def test_each_egg_is_in_its_place() -> None:
    scene = compose("a dozen eggs in an egg carton", 0)
    eggs = [o for o in scene.objects if o.model.category == "egg"]
    assert len(eggs) == 12 and {o.placement.on for o in eggs} == {"egg_carton_1"}
    assert scene.report is not None and scene.report.passed
    assert all(o.holds for o in scene.report.relations)


@pytest.mark.slow
@pytest.mark.parametrize("table", ["a desk", "a round table"])
def test_a_corner_is_a_corner_and_an_edge_an_edge(table: str) -> None:
    scene = compose(
        f"{table} with a candle in the far right corner and a soap dish at the left edge", 0
    )
    corner = np.array(scene.table.scale[:2]) / 2
    candle, dish = (
        np.asarray(scene.object(n).pose.position[:2]) for n in ("candle_1", "soap_dish_1")
    )
    reach = float(np.hypot(*corner)) if table == "a desk" else float(corner.min())
    assert float(np.hypot(*candle)) > 0.75 * reach and (candle > 0.15).all()
    assert dish[0] < -0.7 * corner[0]
    assert scene.report is not None and all(o.holds for o in scene.report.relations)
