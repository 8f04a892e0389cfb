"""What a text asks for holds in the settled scene, or is warned of."""

from __future__ import annotations

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
