"""Tiles of a picture: their positions and contents."""

import itertools

import numpy as np
import pytest

from generator.backends.huggingface.detection.tiles import Tile, closest, tiles_of

WHOLE = Tile(0, 0, 100, 80, 100, 80)
CORNER = Tile(50, 0, 100, 40, 100, 80)


@pytest.mark.parametrize(
    ("width", "height", "count", "overlap"),
    [(640, 480, 2, 0.25), (101, 33, 3, 0.1), (7, 5, 4, 0.5), (9, 9, 2, 0.0)],
)
def test_parts_cover_the_picture_and_share_what_they_should(
    width: int, height: int, count: int, overlap: float
) -> None:
    whole, *parts = tiles_of(width, height, count, overlap)
    assert (whole.x0, whole.y0, *whole.size) == (0, 0, width, height)
    assert len(parts) == count**2
    seen = np.zeros((height, width), int)
    for part in parts:
        seen += part.whole(np.ones(part.size[::-1], bool))
    assert seen.min() >= 1
    assert len({part.size for part in parts}) == 1
    for one, next_one in itertools.pairwise(parts[:count]):
        shared = one.x1 - next_one.x0
        assert shared == pytest.approx(overlap * one.size[0], abs=1.5)


def test_a_count_of_one_looks_at_the_whole_only() -> None:
    assert tiles_of(30, 20, 1, 0.25) == (Tile(0, 0, 30, 20, 30, 20),)


def test_what_is_cut_out_is_what_its_boxes_mean() -> None:
    image = np.arange(80 * 100 * 3, dtype=np.uint8).reshape(80, 100, 3)
    np.testing.assert_array_equal(CORNER.cut(image), image[:40, 50:])
    boxes = CORNER.to_picture(np.array([[0.0, 0.0, 1.0, 1.0], [0.2, 0.25, 0.4, 0.5]]))
    np.testing.assert_allclose(boxes, [[50, 0, 100, 40], [60, 10, 70, 20]])
    np.testing.assert_allclose(CORNER.to_part(boxes)[1], [0.2, 0.25, 0.4, 0.5])


def test_boxes_end_at_the_part() -> None:
    outside = CORNER.to_picture(np.array([[-0.5, -0.1, 1.3, 0.5]]))
    np.testing.assert_allclose(outside, [[50, 0, 100, 20]])


def test_a_mask_of_a_part_lies_where_the_part_does() -> None:
    mask = np.zeros((40, 50), bool)
    mask[3, 7] = True
    whole = CORNER.whole(mask)
    assert whole.shape == (80, 100)
    assert np.argwhere(whole).tolist() == [[3, 57]]


def test_a_box_at_an_inner_border_is_cut_one_at_the_frame_is_not() -> None:
    boxes = np.array([
        [50.2, 5, 60, 15], [60, 5, 99.9, 15], [60, 0, 70, 15], [60, 5, 70, 39.9], [55, 5, 70, 30],
    ])  # fmt: skip
    assert CORNER.cuts(boxes).tolist() == [True, False, False, True, False]
    assert not WHOLE.cuts(np.array([[0.0, 0.0, 100.0, 80.0]])).any()


def test_the_smallest_part_that_shows_a_box_with_what_is_around_it() -> None:
    tiles = (WHOLE, Tile(0, 0, 60, 48, 100, 80), Tile(40, 32, 100, 80, 100, 80))
    assert closest(tiles, np.array([10.0, 10, 20, 20]), 0.25) == tiles[1]
    assert closest(tiles, np.array([0.0, 0, 20, 20]), 0.25) == tiles[1]  # nothing beyond the frame
    assert closest(tiles, np.array([42.0, 40, 90, 70]), 0.25) == WHOLE
    assert closest(tiles, np.array([0.0, 0, 100, 80]), 0.25) == WHOLE
