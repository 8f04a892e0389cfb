"""Every deliberate defect of a scene is reported, and a valid scene has none."""

import dataclasses
import functools
import itertools
import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from calls.paid_server import Says, Served, serving
from command import Shell, command
from judging import SERVER
from PIL import Image
from spoiling import Shot, shot, sound, spoiled, spoiled_four_ways

from generator import bundle
from generator.backends.select import TABLE
from generator.errors import InputError
from generator.evaluation import DefectLimits, Evaluation, evaluate
from generator.evaluation.perceptual import EMBEDDED, PUBLISHED
from generator.evaluation.soundness import PLAIN
from generator.evaluation.surfaces.sweep import Station
from generator.render.sheet import render_scene
from generator.scene import PlannedObject, PlannedTable, Scene, ScenePlan

QUICK = DefectLimits(rule=dataclasses.replace(PLAIN, seconds=1.0))


@pytest.fixture(scope="module")
def taken() -> Shot:
    return shot(sound())


def kinds(found: Evaluation) -> set[tuple[str, str, str]]:
    return {(f.kind, f.name, f.evidence) for f in found.findings}


@pytest.mark.slow
def test_a_sound_scene_has_no_finding(taken: Shot) -> None:
    found = evaluate(
        taken.scene, picture=taken.picture, segments=taken.segments, truth=taken.scene, limits=QUICK
    )
    assert found.findings == ()
    assert found.flawless
    assert found.notes == ()
    assert len(found.fits) == 5
    assert min(f.iou for f in found.fits) > 0.85
    assert found.marks.marks["PP"] == 7
    assert (found.marks.marks["IA"] or 0) > 6.5
    assert json.loads(json.dumps(found.facts()))["flawless"] is True


@pytest.mark.parametrize(
    ("name", "change", "expected"),
    [
        ("can_1", "overlap", {("overlap", "box_1", "meshes")}),
        (
            "can_1",
            "float",
            {("floats", "can_1", "simulation"), ("unstable", "can_1", "simulation")},
        ),
        ("can_1", "hang", {("off_table", "can_1", "simulation")}),
        ("can_1", "sink", {("overlap", "can_1", "meshes")}),
        ("can_1", "shrink", {("wrong_size", "can_1", "usual size")}),
    ],
)
def test_defects_are_reported_without_picture_or_truth(
    name: str, change: str, expected: set[tuple[str, str, str]]
) -> None:
    found = evaluate(spoiled(sound(), name, change), limits=QUICK)
    assert expected <= kinds(found)
    assert {f.name for f in found.findings} <= {name, "box_1"}
    assert not found.flawless


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "change", "kind"),
    [
        ("strut_1", "turn", "wrong_yaw"),
        ("box_1", "shrink", "wrong_size"),
        ("can_1", "lose", "missing"),
    ],
)
def test_the_picture_tells_turns_sizes_and_losses(
    taken: Shot, name: str, change: str, kind: str
) -> None:
    scene = spoiled(taken.scene, name, change)
    found = evaluate(scene, picture=taken.picture, segments=taken.segments, limits=QUICK)
    assert (kind, name, "picture") in kinds(found)
    assert {f.name for f in found.findings} == {name}


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "change", "kind"),
    [
        ("strut_1", "turn", "wrong_yaw"),
        ("box_1", "shrink", "wrong_size"),
        ("can_1", "overlap", "wrong_place"),
        ("can_1", "lose", "missing"),
    ],
)
def test_the_truth_tells_what_differs(name: str, change: str, kind: str) -> None:
    found = evaluate(spoiled(sound(), name, change), truth=sound(), limits=QUICK, simulate=False)
    assert (kind, name, "truth") in kinds(found)
    assert "not simulated" in found.notes


def test_what_the_truth_does_not_hold_or_holds_elsewhere_is_told() -> None:
    scene = sound()
    on_box = dataclasses.replace(scene.objects[1].placement, on="box_1")
    other = scene.replace(
        objects=(scene.objects[0], dataclasses.replace(scene.objects[1], placement=on_box))
    )
    told = kinds(evaluate(other, truth=scene.replace(objects=scene.objects[1:2]), simulate=False))
    assert ("extra", "mug_1", "truth") in told
    assert ("wrong_support", "can_1", "truth") in told


@pytest.mark.slow
def test_a_turn_that_changes_nothing_is_no_defect(taken: Shot) -> None:
    """A can may have any yaw, according to the truth and to the picture."""
    scene = spoiled(taken.scene, "can_1", "turn")
    found = evaluate(
        scene, picture=taken.picture, segments=taken.segments, truth=taken.scene, simulate=False
    )
    assert found.findings == ()


def test_a_size_that_the_plan_fixed_is_the_usual_one() -> None:
    scene = sound()
    planned = PlannedObject("can_1", "can", "can", size=(0.03, 0.03, 0.05))
    plan = ScenePlan("a can", PlannedTable(), (planned,))
    (found,) = evaluate(scene.replace(plan=plan), simulate=False).findings
    assert (found.kind, found.name, found.evidence) == ("wrong_size", "can_1", "usual size")
    assert "plan" in found.text
    assert evaluate(scene, simulate=False).flawless


def test_findings_carry_figures_and_limits() -> None:
    (found,) = evaluate(
        spoiled(sound(), "can_1", "overlap"), limits=DefectLimits(overlap=1e-3), simulate=False
    ).findings
    assert found.value == pytest.approx(3, abs=0.1)
    assert (found.limit, found.unit) == (1.0, "mm")
    assert (found.facts()["object"], found.facts()["other"]) == ("box_1", "can_1")


def test_an_overlap_is_found_by_either_name() -> None:
    found = evaluate(spoiled(sound(), "can_1", "overlap"), simulate=False)
    assert found.of("can_1") == found.of("box_1") == found.findings
    assert found.of("strut_1") == ()


@pytest.mark.slow
def test_marks_fall_with_every_defect(taken: Shot) -> None:
    whole, less = (
        evaluate(s, picture=taken.picture, segments=taken.segments, limits=QUICK).marks.marks
        for s in (taken.scene, spoiled(spoiled(taken.scene, "can_1", "overlap"), "mug_1", "float"))
    )
    assert (less["PP"] or 0) < (whole["PP"] or 0) - 2
    assert (less["IA"] or 0) < (whole["IA"] or 0)
    assert whole["VF"] is less["VF"] is None


def test_what_needs_a_picture_says_so() -> None:
    with pytest.raises(InputError, match="reference picture"):
        evaluate(sound(), judge=object())


@pytest.mark.parametrize("wrong", [{"overlap": 0.0}, {"usual_size": 1.0}, {"yaw": float("nan")}])
def test_limits_that_make_no_sense_are_refused(wrong: dict[str, float]) -> None:
    with pytest.raises(InputError, match="positive"):
        DefectLimits(**wrong)


# ------------------------------------------------------------------------------------ the command
@pytest.fixture
def store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("TABLETOPGEN_CACHE", str(tmp_path / "store"))
    return tmp_path


def saved(scene: Scene, folder: Path, taken: Shot | None = None) -> str:
    images = {} if taken is None else {"reference": taken.picture}
    segments = None if taken is None else taken.segments
    return str(bundle.save(scene, folder, images=images, segments=segments, allow_failed=True))


@pytest.mark.slow
def test_the_command_finds_nothing_in_a_sound_bundle(
    store: Path, taken: Shot, shell: Shell
) -> None:
    path = saved(taken.scene, store, taken)
    shown = shell("evaluate", path, "--truth", path).out
    assert "no defects found" in shown
    assert "yaw error 0.00 deg" in shown


@pytest.mark.slow
def test_the_command_fails_where_there_are_defects_and_adds_up_scenes(
    store: Path, taken: Shot, shell: Shell
) -> None:
    good = saved(taken.scene, store, taken)
    bad = saved(spoiled(taken.scene, "can_1", "overlap").replace(name="bad"), store)
    shown = shell("evaluate", good, bad, "--json", code=1).facts
    assert [s["flawless"] for s in shown["scenes"]] == [True, False]
    assert shown["rates"]["col_s"] == 0.5
    assert shown["rates"]["pairs"] == 20
    assert "overlap" in shell("evaluate", bad, code=1).out


@pytest.mark.slow
def test_the_command_takes_another_picture_and_refuses_a_foreign_one(
    store: Path, taken: Shot, shell: Shell
) -> None:
    path = saved(taken.scene, store, taken)
    again, other = store / "again.png", store / "other.png"
    Image.fromarray(taken.picture).save(again)
    Image.fromarray(np.zeros((100, 300, 3), np.uint8)).save(other)
    assert command("evaluate", path, "--picture", str(again)) == 0
    assert "480x360" in shell("evaluate", path, "--picture", str(other), code=2).err


@pytest.mark.slow
def test_the_command_sweeps_for_the_view_nearest_to_the_picture(
    store: Path, taken: Shot, shell: Shell, monkeypatch: pytest.MonkeyPatch
) -> None:
    few = (Station(50, 1.3), Station(0, 2.5))
    monkeypatch.setattr("generator.evaluation.surfaces.sweep.stations", lambda config: few)
    (scene,) = shell("evaluate", saved(taken.scene, store, taken), "--sweep", "--json").facts[
        "scenes"
    ]
    told = {**scene["perceptual"], **scene["perceptual_missing"]}
    assert set(told) == {*EMBEDDED, *PUBLISHED}
    assert {scene["perceptual"][name]["elevation_deg"] for name in EMBEDDED} == {50}
    bare = saved(taken.scene.replace(name="bare"), store)
    assert "has no picture" in shell("evaluate", bare, "--sweep").out


@pytest.mark.slow
def test_the_command_reports_all_four_defects_of_one_bundle(
    store: Path, taken: Shot, shell: Shell
) -> None:
    """Overlapped, floated, shrunk and turned by 90 degrees: each object with its own defect."""
    good = saved(taken.scene, store)
    bad = saved(spoiled_four_ways(), store)
    (scene,) = shell("evaluate", bad, "--truth", good, "--json", code=1).facts["scenes"]
    told = {(f["kind"], f["object"], f["evidence"]): f["value"] for f in scene["findings"]}
    assert told["overlap", "box_1", "meshes"] == pytest.approx(3, abs=0.2)  # millimetres
    assert ("floats", "bottle_1", "simulation") in told
    assert told["wrong_size", "mug_1", "truth"] == pytest.approx(0.45, abs=1e-3)
    assert told["wrong_yaw", "strut_1", "truth"] == pytest.approx(90, abs=0.1)
    assert {name for kind, name, _ in told if kind == "wrong_yaw"} == {"strut_1"}
    assert {name for kind, name, _ in told if kind == "wrong_size"} == {"mug_1"}
    assert {name for kind, name, _ in told if kind == "floats"} == {"bottle_1"}


@pytest.mark.slow
def test_the_command_asks_a_judge_for_marks_and_a_ranking(
    store: Path, taken: Shot, shell: Shell, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(TABLE, "strict", {"reasoner": "judging:Judging"})  # type: ignore[arg-type]
    monkeypatch.setattr("generator.evaluation.report._draw", lambda *_: taken.picture)
    few = taken.scene.replace(objects=taken.scene.objects[1:2])
    one, two = saved(few, store), saved(few.replace(name="again"), store)
    picture = store / "picture.png"
    Image.fromarray(taken.picture).save(picture)
    words = ("--judge", "strict", "--picture", str(picture))
    told = shell("evaluate", one, two, *words, "--json").facts
    marks = told["scenes"][0]["marks"]
    assert (marks["judge"], marks["VF"], marks["IA"], marks["PP"]) == ("Judging", 3, 4, 5)
    assert told["ranking"] == sorted([one, two], reverse=True)
    assert "ratings (Judging): VF 3" in (shown := shell("evaluate", one, *words).out)
    assert "ranking" not in shown
    assert "reference picture" in shell("evaluate", one, "--judge", "strict", code=2).err


@pytest.fixture
def paid(
    store: Path, taken: Shot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, shell: Shell
) -> Iterator[tuple[Served, Shell]]:
    """A server, and the command for two scenes, whose judge sends a request per scene and
    ranking."""
    monkeypatch.setitem(TABLE, "paid", {"reasoner": "judging:PaidJudging"})  # type: ignore[arg-type]
    small = functools.partial(render_scene, width=96, height=72)  # what it is shown, drawn quickly
    monkeypatch.setattr("generator.render.sheet.render_scene", small)
    each = (taken.scene.replace(objects=(thing,), name=thing.name) for thing in taken.scene.objects)
    scenes = [saved(scene, store) for scene in itertools.islice(each, 2)]
    picture = store / "picture.png"
    Image.fromarray(taken.picture).save(picture)
    table = tmp_path / "prices.toml"
    table.write_text("[models.m]\ncall = 0.25\n")
    words = ("--judge", "paid", "--picture", str(picture), "--prices", str(table))
    with serving([Says()]) as served:
        monkeypatch.setenv(SERVER, served.url)
        monkeypatch.setenv("TABLETOPGEN_CALLS", str(tmp_path / "calls"))
        yield served, shell.of("evaluate", *scenes, *words)


@pytest.mark.slow
def test_what_a_judge_answered_is_kept_and_counted(paid: tuple[Served, Shell]) -> None:
    server, evaluate = paid
    first = evaluate("--json").facts
    assert len(server.asked) == 3 and first["ledger"]["money"] == 0.75
    again = evaluate("--json", "--budget", "0.75").facts
    assert len(server.asked) == 3
    assert [c["outcome"] for c in again["ledger"]["calls"]] == ["answered"] * 3 + ["cached"] * 3
    assert {**again, "ledger": 0} == {**first, "ledger": 0}
    shown = evaluate().out
    assert "ranking by paid" in shown and shown.splitlines()[-2].split()[0] == "total"


@pytest.mark.slow
def test_a_judge_keeps_a_budget_over_runs_of_the_same_words(
    paid: tuple[Served, Shell], monkeypatch: pytest.MonkeyPatch
) -> None:
    server, evaluate = paid
    assert "budget of 0.1" in evaluate("--budget", "0.1", code=3).err and server.asked == []
    told = evaluate("--budget", "0.6", code=3).err
    assert len(server.asked) == 2 and "0.5000 of the budget" in told and "Received answers" in told
    assert "earlier runs" in evaluate("--budget", "0.75").out and len(server.asked) == 3
    monkeypatch.setenv("JUDGE_MODEL", "another")  # no run of the same words
    assert "earlier runs" not in evaluate("--budget", "0.1").out


@pytest.mark.slow
def test_a_dry_run_asks_no_judge(paid: tuple[Served, Shell]) -> None:
    server, evaluate = paid
    calls = evaluate("--dry-run", "--json").facts["dry_run"]
    assert [line.split(",")[1] for line in calls] == [" rate (m)"] * 2
    assert server.asked == []
    evaluate()
    assert "No server would be called" in evaluate("--dry-run").out


@pytest.mark.parametrize("words", [("--budget", "1"), ("--dry-run",), ("--calls", "x")])
def test_settings_of_money_need_a_judge(
    store: Path, taken: Shot, shell: Shell, words: tuple[str, ...]
) -> None:
    assert "--judge" in shell("evaluate", saved(taken.scene, store, taken), *words, code=2).err


@pytest.mark.parametrize(
    ("name", "words"), [("embedded", "cannot judge scenes"), ("embeded", "Did you mean 'embedded'")]
)
def test_a_backend_that_cannot_judge_is_refused_before_anything_is_measured(
    name: str, words: str, store: Path, taken: Shot, shell: Shell, monkeypatch: pytest.MonkeyPatch
) -> None:
    def measure(*args: object, **kwargs: object) -> None:
        raise AssertionError("measured first")

    monkeypatch.setattr("generator.evaluation.report.collisions", measure)
    path = saved(taken.scene, store, taken)
    assert words in shell("evaluate", path, "--judge", name, code=3).err


@pytest.mark.parametrize(
    ("arguments", "code"),
    [((), 2), (("nowhere-1",), 4), (("starter/lab", "--truth", "nowhere-1"), 4)],
)
def test_the_command_says_what_it_cannot_find(
    store: Path, arguments: tuple[str, ...], code: int
) -> None:
    assert command("evaluate", *arguments) == code
