"""Statistics of what was recorded, against NumPy's of all rows."""

import json

import numpy as np
import pytest

from tabletopgen_env.recording.summaries import (
    QUANTILES,
    RowSummary,
    Summaries,
    merge,
    summarize,
    summarize_colors,
    summarize_depth,
)

RNG = np.random.default_rng(0)
PARTS = [RNG.normal(size=(n, 3)) for n in (5, 1, 40)]
ROWS = np.concatenate(PARTS)


def check(found: RowSummary, rows: np.ndarray, count: int) -> None:
    expected = {"min": rows.min(0), "max": rows.max(0), "mean": rows.mean(0), "std": rows.std(0)}
    figures = found.figures()
    assert figures["count"] == [count]
    for name, value in expected.items():
        np.testing.assert_allclose(figures[name], value, rtol=1e-12, atol=1e-12, err_msg=name)


def test_it_is_numpys() -> None:
    found = summarize(ROWS)
    check(found, ROWS, 46)
    np.testing.assert_array_equal(found.quantiles, np.quantile(ROWS, [*QUANTILES.values()], axis=0))
    truths = summarize(np.array([True, False, True, True]))
    assert truths.figures()["mean"] == [0.75] and truths.figures()["q50"] == [1.0]


def test_parts_give_what_all_rows_give() -> None:
    parts = [summarize(part) for part in PARTS]
    check(merge(parts), ROWS, 46)
    running = Summaries()
    for part in parts:
        running.add({"x": part})
    np.testing.assert_allclose(running.figures()["x"]["std"], ROWS.std(0))
    low, high = np.min([p.quantiles for p in parts], 0), np.max([p.quantiles for p in parts], 0)
    within = merge(parts).quantiles
    assert (low <= within).all() and (within <= high).all()


def test_colors_are_summed_up_by_channel() -> None:
    pictures = RNG.integers(0, 256, (4, 5, 6, 3), np.uint8)
    pictures[..., 1] = 7
    found = summarize_colors(pictures)
    pixels = pictures.reshape(-1, 3) / 255
    check(found, pixels, 4)
    nearest = np.quantile(pixels, [*QUANTILES.values()], axis=0, method="inverted_cdf")
    np.testing.assert_allclose(found.quantiles, nearest)


def test_depth_is_summed_up_in_metres(monkeypatch: pytest.MonkeyPatch) -> None:
    depth = RNG.random((4, 5, 6)).astype(np.float32)
    check(summarize_depth(depth), depth.astype(np.float64).reshape(-1, 1), 4)
    monkeypatch.setattr("tabletopgen_env.recording.summaries._MOST_NUMBERS", 50)
    check(summarize_depth(depth), depth.astype(np.float64).reshape(-1, 1)[::3], 4)


def test_figures_are_json_that_gives_the_summary_again() -> None:
    found = summarize(ROWS)
    again = RowSummary.of_figures(json.loads(json.dumps(found.figures())))
    assert again.figures() == found.figures()
    with pytest.raises(KeyError):
        RowSummary.of_figures({"min": [0.0]})
