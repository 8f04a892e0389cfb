"""Runs of the pose benchmark: tables that go on, summaries, names."""

from pathlib import Path

import numpy as np
import pytest
from posing import singles, solving, tables
from posing.cases import Draw, TurnCase
from test_benchmarks import script

from generator.errors import InputError


def test_a_table_that_was_cut_off_goes_on(tmp_path: Path) -> None:
    path, fields, key = tmp_path / "t.csv", ("scene", "of", "value"), ("scene",)
    path.write_text("scene,of,value\n0,2,a\n0,2,b\n1,2,c\n2,1")  # 1 lacks a row, 2 half of it
    rows = tables.resume(path, fields, key, of="of")
    assert [(r["scene"], r["value"]) for r in rows] == [("0", "a"), ("0", "b")]
    assert path.read_text().split() == ["scene,of,value", "0,2,a", "0,2,b"]
    asked: list[int] = []

    def work(scene: int) -> list[tables.Row]:
        asked.append(scene)
        return [{"scene": scene, "of": 1, "value": "new"}]

    done = tables.run(path, fields, key, rows, [2, 1], work, 1, lambda new: "")
    assert asked == [2, 1]
    assert [str(r["scene"]) for r in done] == ["0", "0", "1", "2"]
    assert len(tables.resume(path, fields, key, of="of")) == 4


def test_another_benchmarks_table_is_left_alone(tmp_path: Path) -> None:
    path = tmp_path / "t.csv"
    path.write_text("a,b\n1,2\n")
    with pytest.raises(InputError, match="other columns"):
        tables.resume(path, ("scene",), ("scene",))
    assert path.read_text() == "a,b\n1,2\n"


@pytest.mark.slow
def test_singles_resume_and_sum_up(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    calls: list[tuple[int, str]] = []

    def pretend(case: TurnCase, config: str) -> solving.SolvedPose:
        calls.append((0, config))
        return solving.SolvedPose(case.yaw + np.deg2rad(3.0 if config == "default" else 179.0), 0.1)

    monkeypatch.setattr(solving, "solve", pretend)
    draw = Draw(only=("toy_train",))
    table = tmp_path / "single.csv"
    singles.run(draw, 1, 0, 1, table, "bench")
    done = singles.run(draw, 2, 1, 1, table, "bench")
    assert [config for _, config in calls] == ["default", "default", "paper"]
    assert [r["config"] for r in done.rows] == ["default", "paper", "default"]
    assert "| default | 2 | 3.00° | 0 % | 100 % | 100 % | 0 |" in done.text
    assert "| paper | 1 | 179.00° | 0 % | 0 % | 0 % | 1 |" in done.text
    assert "case 1 default toy_train" in capsys.readouterr().out
    sheet = singles.sheet(done.rows, draw)
    assert sheet.shape[1] == 6 * singles._CELL


def test_the_summary_tells_whether_sure_answers_are_better() -> None:
    rows = [
        singles.start_of_row(k, "default")
        | {"object": "mug:1", "error_deg": error, "margin": sure, "width_deg": 1.5, "apart": 0.2,
           "hidden": 0.0, "pixels": 100, "flip": 0, "scale_error_percent": 1, "cpu_seconds": 1,
           "dropped_symmetric": 0, "dropped_alike": 0, "dropped_other": 0}
        for k, (error, sure) in enumerate([(1, 0.5), (90, 0.01), (2, 0.4), (1, 0.9), (1, 0.3)])
    ]  # fmt: skip
    text = singles.summary(rows, "bench")
    assert "| 80 % surest | 4 | 0.30 to 0.90 | 1.00° | 100 % | 100 % | 100 % |" in text
    assert "| others | 1 | 0.01 to 0.01 | 90.00° | 0 % | 0 % | 0 % |" in text
    assert "Of the errors up to 10°, 75 % are within the width" in text


@pytest.mark.slow
def test_a_case_that_fails_is_a_row(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def fails(case: TurnCase, config: str) -> solving.SolvedPose:
        raise InputError("no such thing")

    monkeypatch.setattr(solving, "solve", fails)
    done = singles.run(Draw(only=("toy_train",)), 1, 0, 1, tmp_path / "t.csv", "bench")
    assert "case 0 (default) failed: no such thing" in done.text


def test_the_name_of_a_run_says_what_its_cases_depend_on(tmp_path: Path) -> None:
    bench = script("pose")
    flags = bench.parser().parse_args

    def name(*words: str) -> str:
        return bench.stem(flags(list(words)))

    assert name("single") == "pose_single_dev"
    assert name("single", "--cases", "3", "--workers", "2") == "pose_single_dev"
    assert name("scenes", "--split", "test", "--seed", "4") == "pose_scenes_test_seed4"
    spoiled = name("single", "--elevation", "5", "--size-error", "0.2", "--only", "cup")
    assert spoiled == "pose_single_dev_mug_elevation5_size_error0.2"
    folder = tmp_path / "scans"
    folder.mkdir()
    assert name("single", "--meshes", str(folder)) == "pose_single_dev_scans"
