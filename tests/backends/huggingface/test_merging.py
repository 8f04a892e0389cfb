"""Merging of detections into one per object."""

import numpy as np
import pytest

from generator.backends.huggingface.detection.detections import (
    BoxDetection,
    clean,
    distinct,
    name_generic,
    overlap,
    separate,
)
from generator.geometry import mask_box

SHAPE = (60, 80)


def box(label: str, score: float, *sides: float) -> BoxDetection:
    return BoxDetection(label, score, np.array(sides, float))


def masked(label: str, score: float, *rectangles: tuple[int, int, int, int]) -> BoxDetection:
    mask = np.zeros(SHAPE, bool)
    for x0, y0, x1, y1 in rectangles:
        mask[y0:y1, x0:x1] = True
    return BoxDetection(label, score, mask_box(mask), mask)


def test_overlap_is_the_intersection_over_the_union() -> None:
    others = [box("a", 1, 0, 0, 10, 10), box("a", 1, 5, 0, 15, 10), box("a", 1, 30, 30, 40, 40)]
    np.testing.assert_allclose(overlap(np.array([0.0, 0, 10, 10]), others), [1, 1 / 3, 0])
    assert overlap(np.array([0.0, 0, 10, 10]), []).shape == (0,)


def test_of_one_thing_found_twice_the_surest_stays() -> None:
    finds = [
        box("mug", 0.4, 0, 0, 10, 10),
        box("mug", 0.8, 0, 0, 10, 9),
        box("mug", 0.3, 40, 0, 50, 10),
    ]
    assert distinct(finds) == [finds[1], finds[2]]


def test_two_words_for_one_box_are_one_thing_a_plate_under_a_bowl_is_another() -> None:
    cup, mug = box("cup", 0.5, 0, 0, 10, 10), box("mug", 0.6, 0, 0, 10, 9.5)
    bowl, plate = box("bowl", 0.5, 30, 0, 40, 10), box("plate", 0.4, 28, 2, 42, 11)
    assert distinct([cup, mug, bowl, plate]) == [mug, bowl, plate]
    near = box("mug", 0.3, 0, 0, 10, 6.9)
    assert distinct([mug, near]) == [mug]  # the same word: less overlap is enough
    assert len(distinct([mug, box("cup", 0.3, 0, 0, 10, 6.9)])) == 2


def test_what_was_asked_for_as_anything_is_called_by_the_surest_word_there() -> None:
    finds = [
        box("object", 0.5, 0, 0, 10, 10),
        box("object", 0.5, 40, 0, 50, 10),
        box("cup", 0.6, 20, 0, 30, 10),
    ]
    better = [
        box("bowl", 0.3, 0, 0, 10, 9),
        box("mug", 0.7, 0, 0, 9, 9),
        box("jar", 0.9, 20, 0, 30, 10),
    ]
    assert [f.label for f in name_generic(finds, "object", better)] == ["mug", "object", "cup"]
    assert name_generic(finds, "object", better)[0].score == 0.5


def test_small_holes_are_filled_handles_stay_and_specks_go() -> None:
    find = masked("mug", 1, (10, 10, 50, 50))
    find.mask[20, 20] = False
    find.mask[30:45, 30:45] = False
    find.mask[2, 2] = True
    made = clean(find)
    assert made.mask[20, 20]
    assert not made.mask[35, 35]
    assert not made.mask[2, 2]
    np.testing.assert_array_equal(made.box, [10, 10, 50, 50])


def test_a_mask_found_under_two_words_is_the_surest_one() -> None:
    a, b = masked("cup", 0.5, (0, 0, 20, 20)), masked("mug", 0.7, (0, 0, 20, 19))
    assert [f.label for f in separate([a, b], 1)] == ["mug"]


def test_a_mask_of_several_books_together_goes_the_books_stay() -> None:
    pile = masked("book", 0.9, (0, 0, 40, 20))
    books = [masked("book", 0.5, (0, 0, 20, 20)), masked("book", 0.4, (20, 0, 40, 20))]
    made = separate([pile, *books], 1)
    assert [f.score for f in made] == [0.5, 0.4]
    lid = masked("book", 0.3, (0, 0, 4, 4))
    assert [f.score for f in separate([pile, lid], 1)] == [0.9]  # one part is no group


def test_a_part_goes_if_it_has_the_word_of_the_whole_and_stays_if_it_has_its_own() -> None:
    bottle = masked("bottle", 0.5, (0, 0, 10, 40))
    neck = masked("bottle", 0.8, (2, 0, 8, 10))
    assert [f.score for f in separate([bottle, neck], 1)] == [0.5]
    apple = masked("apple", 0.8, (2, 0, 8, 10))
    assert {f.label for f in separate([bottle, apple], 1)} == {"bottle", "apple"}


def test_a_pixel_is_the_smaller_thing_s_and_boxes_follow() -> None:
    bowl, apple = masked("bowl", 0.9, (0, 0, 40, 30)), masked("apple", 0.4, (0, 0, 10, 30))
    made = {f.label: f for f in separate([bowl, apple], 1)}
    assert not (made["bowl"].mask & made["apple"].mask).any()
    np.testing.assert_array_equal(made["apple"].mask, apple.mask)
    np.testing.assert_array_equal(made["bowl"].box, [10, 0, 40, 30])


@pytest.mark.parametrize(("least", "left"), [(1, 1), (50, 0)])
def test_what_is_too_small_is_nothing(least: float, left: int) -> None:
    assert len(separate([masked("crumb", 0.9, (0, 0, 5, 5))], least)) == left


def test_what_smaller_things_cover_almost_wholly_is_nothing() -> None:
    tray = masked("tray", 0.9, (0, 0, 40, 20))
    things = [masked("a", 0.5, (0, 0, 20, 20)), masked("b", 0.5, (20, 0, 35, 20))]
    assert {f.label for f in separate([tray, *things], 1)} == {"a", "b"}


def test_nothing_is_nothing() -> None:
    assert separate([], 1) == distinct([]) == []
