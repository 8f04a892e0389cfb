"""The understanding benchmark: MuJoCo measurements of a bundle, rows, and summaries."""

import dataclasses
import json
from pathlib import Path

import pytest
from PIL import Image
from test_benchmarks import script
from toy import toy_object, toy_scene
from wording import making
from wording.cases import cases_of
from wording.making import Made, make
from wording.seen import look
from wording.sheet import SheetEntry, contact_sheet

from generator.bundle import save

BOWL = "".join(
    f'<geom type="box" size="{s}" pos="{p}"/>'
    for s, p in (
        (".1 .1 .005", "0 0 .005"), (".1 .005 .04", "0 .095 .05"), (".1 .005 .04", "0 -.095 .05"),
        (".005 .1 .04", ".095 0 .05"), (".005 .1 .04", "-.095 0 .05"),
    )
)  # fmt: skip
WORLD = f"""<mujoco><option timestep="0.002"/><worldbody>
<body name="table" pos="0 0 .7"><geom type="box" size=".5 .3 .05"/></body>
<body name="bowl_1" pos="0 0 .75"><freejoint/>{BOWL}</body>
<body name="ball_1" pos=".03 0 .79"><freejoint/><geom type="sphere" size=".03"/></body>
<body name="ball_2" pos=".3 0 .78"><freejoint/><geom type="sphere" size=".03"/></body>
</worldbody></mujoco>"""


def test_contacts_say_what_carries_what(tmp_path: Path) -> None:
    (tmp_path / "scene.xml").write_text(WORLD)
    shown = look(tmp_path, [{"name": "ball_2", "label": "marble", "stand_in": True}])
    assert shown.below("ball_1") == {"bowl_1", "table"}
    assert shown.below("bowl_1") == {"table"}
    assert shown.below("ball_2") == {"table"}
    marble = next(t for t in shown.things if t.name == "ball_2")
    assert (marble.label, marble.stand_in) == ("marble", True)


def test_a_saved_bundle_is_seen_where_it_is(tmp_path: Path) -> None:
    things = (toy_object("mug_1", (0.08, 0.06, 0.1), (-0.2, 0.1)),)
    shown = look(save(toy_scene(things), tmp_path, allow_failed=True))
    (mug,) = shown.things
    assert mug.centre[:2] == pytest.approx([-0.2, 0.1], abs=0.01)
    assert sorted(mug.size) == pytest.approx([0.06, 0.08, 0.1], abs=0.01)
    assert shown.below("mug_1") == {"table"}


TRACE = 'Traceback (most recent call last):\n  File "a.py", line 3, in f\nValueError: b\n'


def made(code: int = 0, errors: str = "") -> Made:
    return Made(
        code, {"warnings": ["Not understood: 'zorb'."]} if not code else {}, errors, 1.5, ""
    )


def test_rows_of_the_test_half_have_no_words(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    bench = script("understanding")
    monkeypatch.setattr(bench, "make", lambda *given: made(1, TRACE))
    case = cases_of("test")[0]
    (row,) = bench.work(case, "compose", 0, tmp_path, shown=False)
    assert set(row) == set(bench.FIELDS)
    assert not any(row[word] for word in bench.WORDS)
    assert (row["made"], row["foreign"], row["right"]) == (0, 1, 0)
    text = bench.summary([row], "compose", "test", "bench")
    assert "| no scene; of these by a foreign exception | 1; 1 |" in text
    assert case.text not in text
    assert case.id not in text
    (open_row,) = bench.work(case, "compose", 0, None, shown=True)
    assert "- " + case.id in bench.summary([open_row], "compose", "dev", "bench")


def test_an_error_of_the_package_is_not_foreign() -> None:
    assert made(1, TRACE).foreign
    assert not made(2, "error: The prompt is empty.").foreign


def test_a_scene_made_before_is_not_made_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    kept = {"code": 0, "said": {}, "errors": "", "seconds": 2.0, "bundle": "b"}
    (tmp_path / "x-0.json").write_text(json.dumps(kept))
    monkeypatch.setattr(making.subprocess, "run", None)
    assert make("a mug", "x", "compose", 0, tmp_path) == Made(**kept)


def test_the_sheet_numbers_its_scenes(tmp_path: Path) -> None:
    Image.new("RGB", (100, 50), "red").save(tmp_path / "preview.png")
    entries = [SheetEntry("a mug\non a plate", tmp_path), SheetEntry("two pens", None)]
    sheet = contact_sheet(entries)
    assert sheet.getpixel((30, 30)) == (255, 0, 0)
    assert sheet.height > 250


def test_supports_are_held_against_contacts(tmp_path: Path) -> None:
    bench = script("supports")
    scene = toy_scene((toy_object("mug_1", (0.08, 0.06, 0.1), (-0.2, 0.1)),))
    shown = look(save(scene, tmp_path, allow_failed=True))
    row = bench.check(scene, shown)
    assert (row["table"], row["table_true"], row["violations"]) == (1, 1, "")
    lost = bench.check(scene, dataclasses.replace(shown, carriers={}))
    assert lost["violations"] == "mug_1 on table"
    whole = dict.fromkeys(bench.FIELDS, 0) | row | {"text": "a mug", "seed": 0}
    assert "| stands on the table | 100.00 % (1 of 1) |" in bench.summary([whole], "bench")
