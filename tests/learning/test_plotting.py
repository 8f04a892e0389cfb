"""Bands over seeds: the numbers, and the plots."""

import sys
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from generator.errors import InputError, StorageError
from tabletopgen_env.learning.evaluation import PolicyEvaluation
from tabletopgen_env.learning.plots import Band, bands, draw, figure, number
from tabletopgen_env.learning.runs import Run, begin, open_run


def made(path: Path, recipe, seed: int, shares: dict[int, int]) -> Run:
    """Return an evaluated run: solved episodes of 10, by steps."""
    run = begin(path, recipe, seed)
    for steps, solved in shares.items():
        run.add(steps, steps * 3.6, PolicyEvaluation(10, solved, 0.5, 40.0, 3))
    return run


def test_runs_of_a_recipe_make_a_band_where_all_have_been(small, tmp_path: Path) -> None:
    runs = [
        made(tmp_path / "a", small(), 0, {100: 0, 200: 10}),
        made(tmp_path / "b", small(), 1, {0: 0, 150: 0, 300: 10}),
        made(tmp_path / "c", small("ppo"), 0, {100: 3}),
    ]
    found = bands(runs)
    assert list(found) == ["small-sac", "small-ppo"]
    band = found["small-sac"]
    assert (band.runs, band.at[0], band.at[-1]) == (2, 100, 200)
    assert band.most[-1] == pytest.approx(1.0) and band.least[-1] == pytest.approx(1 / 3)
    assert band.mean[-1] == pytest.approx(2 / 3)
    assert bands(runs, "hours")["small-sac"].at[-1] == pytest.approx(0.2)
    assert found["small-ppo"].mean.tolist() == pytest.approx([0.3] * len(found["small-ppo"].at))


def test_runs_of_other_settings_are_told_apart(small, tmp_path: Path) -> None:
    one = made(tmp_path / "a", small(), 0, {0: 1, 100: 1})
    longer = made(tmp_path / "b", small(steps=999), 1, {0: 1, 100: 3})
    gamma = {"learning_starts": 20, "buffer_size": 2000, "batch_size": 16, "gamma": 0.5}
    other = made(tmp_path / "c", small(options=gamma), 0, {0: 1, 100: 9})
    again = open_run(tmp_path / "a" / ".." / "a")
    found = bands([one, longer, again])
    assert {name: band.runs for name, band in found.items()} == {"small-sac": 2}
    assert found["small-sac"].mean[-1] == pytest.approx(0.2)
    found = bands([one, other, longer])
    assert {name: band.runs for name, band in found.items()} == {
        "small-sac (options.gamma=none)": 2,
        "small-sac (options.gamma=0.5)": 1,
    }


def test_runs_without_a_common_stretch_are_refused(small, tmp_path: Path) -> None:
    early = made(tmp_path / "a", small(), 0, {100: 1, 200: 2})
    late = made(tmp_path / "b", small(), 1, {300: 1, 400: 2})
    with pytest.raises(InputError, match="no common range"):
        bands([early, late])
    with pytest.raises(InputError, match="no evaluations yet"):
        bands([made(tmp_path / "c", small(), 2, {})])


def test_more_success_is_drawn_higher(small, tmp_path: Path) -> None:
    def height(name: str, solved: int) -> float:
        picture = draw(bands([made(tmp_path / name, small(), 0, {0: solved, 100: solved})]))
        blue = (picture == (31, 119, 180)).all(2)
        return float(np.median(np.nonzero(blue[:, 400:])[0]))

    assert height("low", 2) > height("high", 8) + 100


def test_it_says_that_it_is_validation(small, tmp_path: Path) -> None:
    (axes,) = figure(bands([made(tmp_path / "a", small(), 0, {0: 1, 100: 2})]), "steps").axes
    assert "validation" in axes.get_title("left")


def test_names_of_recipes_are_no_markup() -> None:
    band = Band(1, *(np.array([0.0, 1.0]),) * 4)
    for name in (r"$\frac{$", "_hidden", "a\x1b[2Jb", "\ud800", "x" * 300):
        picture = draw({name: band})
        assert (picture == (31, 119, 180)).all(2).any()


@pytest.mark.parametrize(
    ("end", "wanted"),
    [
        (190_000, ["0", "20,000", "40,000", "60,000"]),
        (1.0, ["0", "0.1", "0.2", "0.3"]),
        (0.24, ["0", "0.05", "0.1", "0.15"]),
        (9.9e6, ["0", "1,000,000", "2,000,000", "3,000,000"]),
    ],
)
def test_axes_have_round_numbers(end: float, wanted: list[str]) -> None:
    band = Band(1, *(np.array([0.0, end]),) * 4)
    (axes,) = figure({"one": band}, "steps").axes
    shown = axes.xaxis.get_major_formatter()
    made = [v for v in axes.get_xticks() if v <= end * (1 + 1e-9)]
    assert [shown(v) for v in made[:4]] == wanted == [number(v) for v in made[:4]]
    assert 4 < len(made) <= 11


def test_matplotlib_missing_is_said_with_the_pip_line(monkeypatch) -> None:
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(InputError, match=r"pip install 'tabletopgen\[plot\]'"):
        draw({"one": Band(1, *(np.zeros(1),) * 4)})


def test_the_command_draws_a_picture(small, tmp_path: Path, shell) -> None:
    for seed, last in enumerate((4, 8)):
        made(tmp_path / str(seed), small(), seed, {0: 0, 100: last})
    out = tmp_path / "new" / "success.png"
    told = shell("plot", str(tmp_path / "0"), str(tmp_path / "1"), "--out", str(out)).out
    assert "60 % after 100 steps, 40 to 80 % over 2 runs" in told
    with Image.open(out) as picture:
        assert picture.format == "PNG"
    (tmp_path / "0" / "evaluations.csv").write_text("steps\nx\n")
    assert "not a valid table of evaluations" in shell("plot", str(tmp_path / "0"), code=2).err


def test_a_run_that_cannot_be_begun_leaves_nothing(small, tmp_path, monkeypatch) -> None:
    def full(*args) -> None:
        raise StorageError("No space left.")

    monkeypatch.setattr("tabletopgen_env.learning.runs.write_whole", full)
    with pytest.raises(StorageError):
        begin(tmp_path / "run", small(), 0)
    assert not (tmp_path / "run").exists()
    (tmp_path / "own").mkdir()
    with pytest.raises(StorageError):
        begin(tmp_path / "own", small(), 0)
    assert not list((tmp_path / "own").iterdir())
