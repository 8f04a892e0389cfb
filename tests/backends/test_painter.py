"""Painted reference images: white ground, whole centred table, everything in view."""

import numpy as np
import pytest

from generator.backends.embedded import painter
from generator.language.planner import plan_scene

TEXT = "a laptop, a red mug to the right of it and two books on a walnut desk"


@pytest.fixture(scope="module")
def picture() -> np.ndarray:
    return painter.draw(plan_scene(TEXT, 0), 0)


def inked(picture: np.ndarray) -> np.ndarray:
    """Return the mask of the pixels that are not white."""
    return picture.min(axis=2) < 250


@pytest.mark.slow
def test_the_table_is_whole_and_centred_on_white(picture: np.ndarray) -> None:
    assert picture.shape == (painter.HEIGHT, painter.WIDTH, 3)
    assert picture.dtype == np.uint8
    ink = inked(picture)
    ys, xs = np.flatnonzero(ink.any(1)), np.flatnonzero(ink.any(0))
    assert not ink[[0, -1]].any() and not ink[:, [0, -1]].any()
    assert abs((xs[0] + xs[-1]) / 2 - painter.WIDTH / 2) < 0.02 * painter.WIDTH
    assert abs((ys[0] + ys[-1]) / 2 - painter.HEIGHT / 2) < 0.03 * painter.HEIGHT
    assert max(np.ptp(xs) / painter.WIDTH, np.ptp(ys) / painter.HEIGHT) > 0.85
    assert (picture[~ink] > 249).all()


@pytest.mark.slow
def test_the_longer_side_is_level(picture: np.ndarray) -> None:
    ink = inked(picture)
    lowest = np.array([np.flatnonzero(column)[-1] for column in ink.T[ink.any(0)]])
    left, right = lowest[: len(lowest) // 2], lowest[len(lowest) // 2 :]
    assert abs(float(np.median(left)) - float(np.median(right))) < 6


@pytest.mark.slow
def test_asked_colours_are_in_the_picture(picture: np.ndarray) -> None:
    r, g, b = (picture[..., k].astype(int) for k in range(3))
    red = (r > 1.8 * g) & (r > 1.8 * b) & (r > 90)
    assert red.sum() > 300, "the red mug"


@pytest.mark.slow
def test_same_seed_same_bytes_other_seed_another_picture(picture: np.ndarray) -> None:
    again = painter.draw(plan_scene(TEXT, 0), 0)
    assert np.array_equal(picture, again)
    assert not np.array_equal(picture, painter.draw(plan_scene(TEXT, 0), 1))
