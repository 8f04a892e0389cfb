"""The benchmark scripts' own logic: names compared, interrupted tables resumed, pictures paired."""

from __future__ import annotations

import importlib.util
from pathlib import Path
from types import ModuleType

import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.scene import PlannedObject, PlannedTable, Scene, ScenePlan


def script(name: str) -> ModuleType:
    path = Path(__file__).parents[1] / "benchmarks" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(f"benchmark_{name}", path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def built(*labels: str) -> Scene:
    size = (0.05, 0.05, 0.05)
    things = [toy_object(f"{w}_{k}", size, (0.1 * k, 0)) for k, w in enumerate(labels)]
    asked = ("mug", "mug", "smartphone", "generic")
    nouns = ("mug", "cup", "phone", "zorb")
    plan = ScenePlan(
        "four things",
        PlannedTable(),
        tuple(
            PlannedObject(f"{c}_{k}", n, c)
            for k, (c, n) in enumerate(zip(asked, nouns, strict=True))
        ),
    )
    return toy_scene(tuple(things)).replace(plan=plan)


@pytest.mark.parametrize(
    ("labels", "expected"),
    [
        (("mug", "coffee mug", "phone", "zorb"), 4),
        (("mug", "phone", "phone", "object"), 2),
        (("zorb", "mug", "mug", "mug"), 3),
        (("object",), 0),
    ],
)
def test_names_are_compared_by_what_they_mean(labels: tuple[str, ...], expected: int) -> None:
    assert script("end_to_end").named(built(*labels)) == expected


def test_a_table_of_an_older_version_gets_the_new_columns(tmp_path: Path) -> None:
    bench = script("end_to_end")
    table = tmp_path / "compose.csv"
    table.write_text("text,seed,published,planned,built\na mug,0,1,1,1\n")
    rows = bench.resume(table)
    assert [(r["text"], r["built"]) for r in rows] == [("a mug", "1")]
    again = bench.resume(table)
    assert list(again[0]) == list(bench.FIELDS)
    assert again[0]["named"] == ""
    assert bench.resume(tmp_path / "none.csv") == []


def test_the_summary_reports_names_of_the_rows_that_have_them() -> None:
    bench = script("end_to_end")
    row = {"published": 1, "planned": 4, "built": 4, "penetration_mm": 0, "drift_mm": 0,
           "tilt_deg": 0, "floating": 0, "fallen": 0, "seconds": 1}  # fmt: skip
    text = bench.summary([row | {"named": 4}, row | {"named": 3}, row], "compose", "bench")
    assert "| planned names = built names | 50.0 % of scenes, 87.5 % of objects |" in text
    assert "| planned names = built names | - |" in bench.summary([row], "compose", "bench")


def test_pictures_find_their_depth_and_intrinsics(tmp_path: Path) -> None:
    bench = script("pictures")
    for name in ("desk_color.png", "desk_depth.png", "table.jpg", "notes.txt"):
        (tmp_path / name).write_bytes(b"")
    found = bench.pictures(tmp_path)
    assert [(name, depth is not None) for name, _, depth in found] == [
        ("desk", True),
        ("table", False),
    ]
    assert bench.intrinsics_of(tmp_path, None) is None
    (tmp_path / "intrinsics.json").write_text('{"fx": 600, "fy": 601, "cx": 320, "cy": 240}')
    assert bench.intrinsics_of(tmp_path, None) == {"fx": 600, "fy": 601, "cx": 320, "cy": 240}
    assert bench.intrinsics_of(tmp_path, [1, 2, 3, 4])["cy"] == 4


def test_rotation_speed_shows_wall_and_cpu_seconds() -> None:
    text = script("rotation_speed").table(np.array([[1.0, 0.5], [3.0, 0.7], [2.0, 0.6]]), "head")
    assert "| wall | 3 | 2.00 | 2.00 | 2.80 | 3.00 |" in text
    assert "| CPU | 3 | 0.60 | 0.60 | 0.68 | 0.70 |" in text
