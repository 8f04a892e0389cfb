"""Cross-sections cut into runs: their ends, and surfaces from which fingers would slip."""

import numpy as np
import pytest

from tabletopgen_env.expert.planning.heights import VoxelSolid
from tabletopgen_env.expert.planning.runs import PAD_HEIGHT, RISE, STEP_U, Runs, find_runs, slabs

FLOOR = 0.74
LEVELS = FLOOR + RISE * (np.arange(12) + 0.5)


def runs_of(filled: np.ndarray, floor: float = FLOOR) -> Runs:
    """Return the runs of voxels [line, cell, level] in storage order."""
    shape = VoxelSolid(np.zeros(2), STEP_U, LEVELS[: filled.shape[2]], filled)
    columns = np.arange(filled[..., 0].size).reshape(filled.shape[:2])
    return find_runs(slabs(shape, floor), columns)


def block(first: int = 40, end: int = 60) -> np.ndarray:
    """Return a block from one cell to another, on lines 8 to 31 of 40."""
    filled = np.zeros((40, 100, 12), bool)
    filled[8:32, first:end] = True
    return filled


def test_a_block_is_one_run_on_every_second_line_and_at_each_height() -> None:
    found = runs_of(block())
    assert set(found.left) == {40} and set(found.right) == {59}
    assert set(found.row) <= set(range(8, 32, 2)) and {12, 20, 28} <= set(found.row)
    inside = found.row == 20
    np.testing.assert_allclose(found.tip[inside], [0.743, 0.746, 0.75, 0.754, 0.7575, 0.761, 0.765])
    held = [((tip <= LEVELS) & (tip + PAD_HEIGHT >= LEVELS)).sum() for tip in found.tip[inside]]
    assert {*held} == {4, 5, 6, 7}, "seven levels at most are as high as the pad"
    np.testing.assert_allclose(found.quality[inside], 1.0 + np.array(held) * RISE / PAD_HEIGHT)


def test_runs_are_ordered_by_row_height_and_place() -> None:
    both = block(20, 24) | block(60, 64)
    found = runs_of(both)
    key = list(zip(found.row, found.tip, found.left, strict=True))
    assert key == sorted(key)
    assert set(zip(found.left, found.right, strict=True)) == {(20, 23), (60, 63)}


@pytest.mark.parametrize(("cells", "straddled"), [(49, True), (50, False)])
def test_what_is_wider_than_the_opening_is_no_run(cells: int, straddled: bool) -> None:
    assert bool(len(runs_of(block(20, 20 + cells)).row)) == straddled


def test_a_run_begins_where_any_line_of_its_strip_does() -> None:
    filled = block()
    filled[20, 39] = True
    found = runs_of(filled)
    touched = np.abs(found.row - 20) <= 3
    assert set(found.left[touched]) == {39} and set(found.left[~touched]) == {40}


@pytest.mark.parametrize(("per_line", "holds"), [(0, True), (1, False)])
def test_sides_that_slope_along_the_fingers_do_not_hold(per_line: int, holds: bool) -> None:
    filled = np.zeros((40, 140, 12), bool)
    for line in range(8, 32):  # half a metre a metre where it slopes
        filled[line, 40 + per_line * line : 60 + per_line * line] = True
    assert bool(len(runs_of(filled).row)) == holds


@pytest.mark.parametrize(("per_level", "holds"), [(0, True), (1, False)])
def test_sides_that_come_together_upwards_do_not_hold(per_level: int, holds: bool) -> None:
    filled = np.zeros((40, 100, 12), bool)
    for level in range(12):
        filled[8:32, 30 + per_level * level : 70 - per_level * level, level] = True
    assert bool(len(runs_of(filled).row)) == holds


def test_what_leans_holds_less_and_what_leans_much_not() -> None:
    def leaning(levels_a_cell: float) -> np.ndarray:
        filled = np.zeros((40, 100, 12), bool)
        for level in range(12):
            first = 40 + int(level / levels_a_cell)
            filled[8:32, first : first + 20, level] = True
        return filled

    assert runs_of(leaning(3)).quality.max() < runs_of(block()).quality.max()
    assert len(runs_of(leaning(3)).row) and not len(runs_of(leaning(0.7)).row)


def test_a_flat_thing_is_too_low_to_hold() -> None:
    assert not len(runs_of(block()[:, :, :2]).row)
    assert not len(runs_of(np.zeros((40, 100, 12), bool)).row)


def test_fingertips_keep_above_the_table() -> None:
    low, high = runs_of(block()), runs_of(block(), floor=FLOOR + 0.012)
    assert low.tip.min() == pytest.approx(FLOOR + 0.003)
    assert high.tip.min() == pytest.approx(FLOOR + 0.015)
