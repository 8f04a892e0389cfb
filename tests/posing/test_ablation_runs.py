"""The benchmark of what DRO and TSA are worth: poses as placed, the table, cut-off runs."""

import dataclasses
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from posing import ablations, tables
from posing.ablations import FIELDS, VARIANTS, AblationRun
from posing.tables import Row
from toy import toy_scene

from generator.errors import SceneError
from generator.geometry import yaw_quaternion
from generator.scene import Pose


def row(variant: str, scene: int = 0, **changes: Any) -> Row:
    usual = {
        "scene": scene, "variant": variant, "of": 5, "found": 1, "yaw_error_deg": 2.0,
        "place_percent": 1.0, "size_percent": -3.0, "size_relative_percent": 4.0,
        "support_right": 1, "pairs": 10, "placed_overlaps": 0, "placed_sunk": 0,
        "made_overlaps": 0, "made_sunk": 0, "moved_mm": 0.5, "farthest_mm": 2.0, "published": 1,
        "mean_iou": 0.9,
    }  # fmt: skip
    scores = {f: 0.5 for f in FIELDS if f.startswith("embedded")}
    return dict.fromkeys(FIELDS, "") | usual | scores | changes


def test_as_placed_undoes_what_came_after_the_picture() -> None:
    scene = toy_scene()
    thing = scene.objects[0]
    away = Pose(thing.pose.position + np.array([0.1, 0, 0.2]), yaw_quaternion(1.0))
    moved = scene.replace(objects=(dataclasses.replace(thing, pose=away), *scene.objects[1:]))
    for before, after in zip(scene.objects, ablations.as_placed(moved).objects, strict=True):
        np.testing.assert_allclose(after.pose.position, before.pose.position)
        np.testing.assert_allclose(after.pose.quaternion, before.pose.quaternion)


def test_the_table_has_a_row_for_each_variant() -> None:
    rows = [row(v, s) for s in (0, 1) for v in VARIANTS]
    rows[4] = row("w/o both", placed_overlaps=2, placed_sunk=1, yaw_error_deg=140.0)
    text = ablations.summary(rows, "bench", "as seen")
    assert "\nas seen\n" in text
    lines = {line.split(" | ")[0]: line.split(" | ") for line in text.splitlines()}
    assert lines["| full"][1:6] == [
        "2.0°, 100 %, 2.0°", "1.0 %", "3.0 %, 4.0 %", "100 %", "0.00, 0 %",
    ]  # fmt: skip
    assert lines["| w/o both"][1] == "71.0°, 50 %, 21.0°"
    assert lines["| w/o both"][5] == "10.00, 50 %"
    assert all(f"| {variant}" in lines for variant in VARIANTS)


def test_a_variant_that_fails_is_told_and_left_out() -> None:
    rows = [row(v) for v in VARIANTS]
    rows[2] |= {"error": "no room"}
    text = ablations.summary(rows, "bench")
    assert "- scene 0, w/o DRO: no room" in text
    assert "| w/o DRO | -, -, - |" in text


def test_a_failure_does_not_end_a_run(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def none(*_: Any) -> None:
        raise SceneError("nothing composed")

    monkeypatch.setattr(ablations, "draw_truth", none)
    table = tmp_path / "ablation.csv"
    how = AblationRun("dev", 1, tmp_path / "strips")
    text = ablations.run(how, 2, 1, table, "bench")
    assert "- scene 1, all: nothing composed" in text
    before = table.read_bytes()
    monkeypatch.setattr(ablations, "work", none)
    assert ablations.run(how, 2, 1, table, "bench") == text
    assert table.read_bytes() == before
    assert ablations.sheet((0, 1), how.strips) is None


def test_strips_of_different_width_make_one_sheet(tmp_path: Path) -> None:
    picture = np.full((30, 40, 3), 90, np.uint8)
    ablations.write_strip({"picture": picture, "full": picture}, 0, tmp_path)
    ablations.write_strip({"picture": picture}, 1, tmp_path)
    alone, both = ablations.sheet((0,), tmp_path), ablations.sheet((0, 1, 7), tmp_path)
    assert alone is not None
    assert both is not None
    assert both.shape == (2 * alone.shape[0], alone.shape[1], 3)
    np.testing.assert_array_equal(both[: alone.shape[0]], alone)


def test_the_command_is_told_without_notes_and_folders(monkeypatch: pytest.MonkeyPatch) -> None:
    words = ["/x/y/ablation.py", "--cases", "3", "--note", "two words", "--out", "/x/results"]
    monkeypatch.setattr("sys.argv", words)
    assert tables.command_line("--note") == "python benchmarks/ablation.py --cases 3 --out results"
    assert "--note 'two words'" in tables.command_line()
