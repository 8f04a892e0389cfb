"""Heaps and pyramids: supports, and stability."""

import numpy as np
import pytest

from generator.composition import compose
from generator.layout.footprint import Footprint, footprint
from generator.layout.furniture import build_models
from generator.layout.heaps import pile_heap, pile_pyramid
from generator.scene import TABLE, PlannedObject, PlannedTable, Scene, ScenePlan


def shapes(category: str, count: int) -> list[Footprint]:
    thing = PlannedObject("a_1", category, category)
    model = build_models(ScenePlan("", PlannedTable(), (thing,)), 0)["a_1"]
    return [footprint(model, 0.0)] * count


@pytest.mark.parametrize(("count", "above"), [(3, 0), (4, 1), (7, 1), (8, 1), (12, 3)])
def test_up_to_a_fourth_of_a_heap_lies_on_three_others(count: int, above: int) -> None:
    pile = pile_heap(shapes("apple", count))
    assert pile is not None and len(pile.offsets) == count
    assert [len(under) for under in pile.below] == [0] * (count - above) + [3] * above
    for place, under in zip(pile.offsets, pile.below, strict=True):
        if under:
            np.testing.assert_allclose(place, np.mean([pile.offsets[k] for k in under], axis=0))


def test_a_layer_does_not_overlap() -> None:
    apple = shapes("apple", 9)
    pile = pile_heap(apple)
    assert pile is not None
    places = [p for p, under in zip(pile.offsets, pile.below, strict=True) if not under]
    gaps = [np.hypot(*(a - b)) for k, a in enumerate(places) for b in places[:k]]
    assert min(gaps) >= 2 * apple[0].half.max()


@pytest.mark.parametrize(
    ("balls", "count", "lowest"), [(False, 6, 3), (False, 3, 2), (False, 8, 5), (True, 10, 6)]
)
def test_the_lowest_layer_of_a_pyramid(balls: bool, count: int, lowest: int) -> None:
    pile = pile_pyramid(shapes("orange", count), balls=balls)
    assert pile is not None and len(pile.offsets) == len(pile.below) == count
    assert sum(not under for under in pile.below) == lowest
    assert {len(under) for under in pile.below} == {0, 3 if balls else 2}


def test_long_things_are_no_pile() -> None:
    assert pile_heap(shapes("banana", 5)) is None
    assert pile_pyramid(shapes("banana", 6), balls=False) is None


def carried(scene: Scene, category: str) -> int:
    things = [o for o in scene.objects if o.model.category == category]
    return sum(o.placement.on != TABLE for o in things)


@pytest.mark.parametrize(
    ("text", "category", "count", "above"),
    [
        ("a pyramid of oranges", "orange", 4, 1),
        ("a pyramid of cans", "can", 6, 3),
        ("a heap of apples", "apple", 5, 1),
        ("a pile of books", "book", 5, 4),
        ("a pile of plates", "plate", 5, 4),
    ],
)
def test_piles_stand(text: str, category: str, count: int, above: int) -> None:
    scene = compose(text, 1)
    assert scene.report is not None and scene.report.passed
    things = [o for o in scene.objects if o.model.category == category]
    assert len(things) == count
    assert carried(scene, category) == above
