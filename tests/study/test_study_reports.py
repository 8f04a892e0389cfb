"""Answers are read with suspicion and counted; the figures are those worked out by hand."""

import csv
import io
import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import tiny_studies as tiny
from command import Shell

from generator.errors import InputError
from tabletopgen_web.studio.library.answers import AnswerBook
from tabletopgen_web.study.agreement import krippendorff
from tabletopgen_web.study.answers import parse_answers, read_all
from tabletopgen_web.study.key import StudyKey, read_key
from tabletopgen_web.study.page import write_study
from tabletopgen_web.study.statistics import measure
from tabletopgen_web.study.tables import table_2, to_csv, to_markdown


@pytest.fixture(scope="module")
def key_file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("study")
    return write_study(tiny.small_study(folder, min_seconds=60), folder / "study.html")[1]


@pytest.fixture
def key(key_file: Path) -> StudyKey:
    return read_key(key_file)


def three(key: StudyKey) -> list[Any]:
    found = [json.dumps(tiny.answers_of(key, rater)).encode() for rater in range(3)]
    return [parse_answers(raw, key) for raw in found]


def test_three_raters_give_the_table_worked_out_by_hand(key: StudyKey) -> None:
    report = measure(three(key), [], key)
    tiny.check_table(json.loads(json.dumps(report.facts())))
    assert (report.read, report.raters, report.mean_seconds) == (3, 3, 180.0)
    assert table_2(report) == (
        "| Method | VF↑ | IA↑ | PP↑ | Avg.↑ | OP (%) |\n"
        "| --- | --- | --- | --- | --- | --- |\n"
        "| ours | **5.50** | **5.00** | **6.00** | **5.50** | **61.11** |\n"
        "| other | 4.00 | 3.28 | 4.00 | 3.76 | 38.89 |\n"
    )
    assert table_2(report) in to_markdown(report)
    rows = list(csv.DictReader(io.StringIO(to_csv(report))))
    assert [row["image_alignment"] for row in rows] == ["5.000000", "3.277778"]
    assert (rows[0]["share_low"][:6], rows[0]["chosen"], rows[0]["choices"]) == (
        "0.3861", "11", "18",
    )  # fmt: skip


def test_what_is_as_good_is_as_bold(key: StudyKey) -> None:
    report = measure(three(key), [], key)
    even = tuple(
        replace(one, share=0.5 + more) for one, more in zip(report.methods, (0, 1e-6), strict=True)
    )
    lines = table_2(replace(report, methods=even)).splitlines()[2:]
    assert [line.count("**50.00**") for line in lines] == [1, 1]


def test_one_rater_has_no_interval(key: StudyKey) -> None:
    report = measure(three(key)[:1], [], key)
    assert report.methods[0].average.interval is None
    assert "| 6.00 |" in to_markdown(report)
    assert all(alpha is None for alpha in report.agreement.values())


def test_the_bootstrap_draws_raters_by_its_seed(key: StudyKey) -> None:
    found = three(key) * 5
    one, two = (measure(found, [], key, seed=seed).methods[0].average for seed in (0, 0))
    other = measure(found, [], key, seed=1).methods[0].average
    assert one == two
    assert one.interval != other.interval and one.interval and other.interval
    # Raters' averages are 6, 16 / 3 and 31 / 6, so the mean of 15 has the standard error
    # sqrt(0.12963 / 15) = 0.09296, and the interval is about 2 * 1.96 of these wide.
    assert abs(one.interval[1] - one.interval[0] - 3.92 * 0.09296) < 0.02


def test_the_fast_and_the_inattentive_do_not_count(key: StudyKey) -> None:
    code = next(iter(key.scenes))
    failed = [{"scene": code, "asked": 3, "given": 4}]
    changed = [
        tiny.answers_of(key, 0, rater="a" * 16, checks=failed),
        tiny.answers_of(key, 0, rater="b" * 16, seconds=59.9),
        tiny.answers_of(key, 0, rater="c" * 16, seconds=1, checks=failed),
    ]
    found = [*three(key), *(parse_answers(json.dumps(facts).encode(), key) for facts in changed)]
    report = measure(found, [], key)
    assert (report.read, report.raters) == (6, 3)
    assert report.excluded.inattentive == ("a" * 16, "c" * 16)
    assert report.excluded.too_fast == ("b" * 16, "c" * 16)
    tiny.check_table(json.loads(json.dumps(report.facts())))
    assert measure(found, [], key, min_seconds=0, allowed_failures=1).raters == 6
    with pytest.raises(InputError, match="No rater remains: of 3 read, 2 failed"):
        measure(found[3:], [], key)


# ------------------------------------------------------------------------------------- agreement
FOUR_OBSERVERS = """
1 2 3 3 2 1 4 1 2 . . .
1 2 3 3 2 2 4 1 2 5 . 3
. 3 3 3 2 3 4 2 2 5 1 .
1 2 3 3 2 4 4 1 2 5 1 .
"""
TWO_OBSERVERS = """
1 1 2 2 4 3 3 3 5 4 4 1
2 1 2 2 2 3 3 3 5 4 4 4
"""
TWO_BINARY = """
0 1 0 0 0 0 0 0 1 0
1 1 1 0 0 1 0 0 0 0
"""


def units(table: str) -> list[list[int]]:
    rows = [line.split() for line in table.strip().splitlines()]
    return [[int(v) for v in unit if v != "."] for unit in zip(*rows, strict=True)]


@pytest.mark.parametrize(
    ("table", "metric", "alpha"),
    [
        (TWO_BINARY, "nominal", 0.095),
        (TWO_OBSERVERS, "nominal", 0.692),
        (FOUR_OBSERVERS, "nominal", 0.743),
        (FOUR_OBSERVERS, "ordinal", 0.815),
    ],
)
def test_alpha_is_that_of_krippendorff_s_examples(table: str, metric: Any, alpha: float) -> None:
    """Examples A, B and C of "Computing Krippendorff's Alpha-Reliability" (2011)."""
    assert krippendorff(units(table), metric) == pytest.approx(alpha, abs=5e-4)


def test_alpha_without_pairs_or_variety_is_undefined() -> None:
    assert krippendorff([[1], [2], [3]], "ordinal") is None
    assert krippendorff([[4, 4], [4, 4]], "nominal") is None
    assert krippendorff([[1, 1], [2, 2]], "ordinal") == 1.0


# ----------------------------------------------------------------------------- hostile answers
Change = Callable[[dict[str, Any]], object]


def _first(facts: dict[str, Any]) -> dict[str, Any]:
    return facts["scenes"][0]


def _marks(facts: dict[str, Any]) -> dict[str, Any]:
    return next(iter(_first(facts)["ratings"].values()))


HOSTILE: dict[str, tuple[Change, str]] = {
    "schema": (lambda f: f.update(schema=2), "schema 2"),
    "study": (lambda f: f.update(study="0" * 12), "belongs to study"),
    "name": (lambda f: f.update(name="Ann"), "entries"),
    "no rater": (lambda f: f.pop("rater"), "entries"),
    "rater's path": (lambda f: f.update(rater="../../etc"), "16 hexadecimal"),
    "language": (lambda f: f.update(language="<script>"), "language"),
    "negative time": (lambda f: f.update(seconds=-1), "duration"),
    "no time": (lambda f: f.update(seconds=True), "duration"),
    "scenes": (lambda f: f.update(scenes={}), "must be a list"),
    "too few": (lambda f: f["scenes"].pop(), "5 of 6 scenes"),
    "twice": (lambda f: f["scenes"].__setitem__(1, _first(f)), "twice"),
    "no object": (lambda f: f["scenes"].__setitem__(0, 3), "not an object"),
    "unknown scene": (lambda f: _first(f).update(scene="s0000000000"), "unknown scene"),
    "no code": (lambda f: _first(f).update(scene=["x"]), "unknown scene"),
    "too high": (lambda f: _marks(f).update(overall=8), "not from 1 to 7"),
    "half a mark": (lambda f: _marks(f).update(overall=4.5), "not from 1 to 7"),
    "true": (lambda f: _marks(f).update(overall=True), "not from 1 to 7"),
    "no mark": (lambda f: _marks(f).pop("overall"), "questions"),
    "another result": (lambda f: _first(f)["ratings"].update(r0={}), "rated results"),
    "another choice": (lambda f: _first(f).update(choice="r0000000000"), "preferred"),
    "no choice": (lambda f: _first(f).update(choice=None), "preferred"),
    "order": (lambda f: _first(f).update(order=["x", "y"]), "displayed results"),
    "order of numbers": (lambda f: _first(f).update(order=[1, "y"]), "order"),
    "no check": (lambda f: f.update(checks=[]), "0 of 1 attention checks"),
    "check": (lambda f: f["checks"][0].update(given=0), "check"),
    "check's scene": (lambda f: f["checks"][0].update(scene={}), "check"),
}


@pytest.mark.parametrize("name", HOSTILE)
def test_answers_that_do_not_fit_are_left_out_and_told(
    name: str, key: StudyKey, tmp_path: Path
) -> None:
    change, said = HOSTILE[name]
    facts = tiny.answers_of(key, 0)
    change(facts)
    (tmp_path / "answers-x.json").write_text(json.dumps(facts))
    found, left = read_all([tmp_path], key)
    assert found == []
    assert [Path(one.file).name for one in left] == ["answers-x.json"]
    assert said in left[0].reason


def test_broken_files_are_left_out(key: StudyKey, tmp_path: Path) -> None:
    good = tiny.write_answers(tmp_path, tiny.answers_of(key, 0))
    (tmp_path / "a-cut.json").write_bytes(good.read_bytes()[:-20])
    (tmp_path / "b-deep.json").write_text("[" * 10000)
    (tmp_path / "c-large.json").write_bytes(b" " * (2**20 + 1))
    (tmp_path / "d-list.json").write_text("[]")
    (tmp_path / "e-nan.json").write_text(good.read_text().replace("30.0", "NaN"))
    (tmp_path / "f-folder.json").mkdir()
    found, left = read_all([tmp_path, tmp_path / "missing.json"], key)
    assert [answers.rater for answers in found] == ["0" * 16]
    assert sorted(Path(one.file).name[0] for one in left) == [*"abcdef", "m"]


def test_answers_that_a_studio_kept_are_read(key: StudyKey, tmp_path: Path) -> None:
    book = AnswerBook(tmp_path)
    for rater in (0, 1, 1):  # one sends his again
        facts = tiny.answers_of(key, rater)
        book.add(key.study, facts["rater"], facts)
    found, left = read_all([tmp_path / key.study], key)
    assert found == [
        parse_answers(json.dumps(tiny.answers_of(key, k)).encode(), key) for k in (0, 1)
    ]
    assert left == []
    chinese = tiny.answers_of(key, 1, language="zh")  # and again, once the language is changed
    assert book.add(key.study, chinese["rater"], chinese) == 2
    found, left = read_all([tmp_path / key.study], key)
    assert [answers.rater for answers in found] == ["0" * 16, "0" * 15 + "1"]
    assert ["the same answers in" in one.reason for one in left] == [True]


def test_a_rater_counts_once(key: StudyKey, tmp_path: Path) -> None:
    for name in ("one.json", "two.json"):
        tiny.write_answers(tmp_path, tiny.answers_of(key, 0), name)
    tiny.write_answers(tmp_path, tiny.answers_of(key, 1), "three.json")
    other = tiny.answers_of(key, 1)
    _marks(other)["overall"] = 1
    tiny.write_answers(tmp_path, other, "four.json")
    found, left = read_all([tmp_path, tmp_path], key)
    assert [answers.rater for answers in found] == ["0" * 16]
    reasons = {Path(one.file).name: one.reason for one in left}
    assert "the same answers in" in reasons.pop("two.json")
    assert {*reasons} == {"three.json", "four.json"}


def test_keys_that_are_none_are_refused(key_file: Path, tmp_path: Path) -> None:
    facts = json.loads(key_file.read_text())
    scene = next(iter(facts["scenes"].values()))
    for change in (
        {"schema": 2}, {"study": "x"}, {"methods": ["a"]}, {"scenes_each": 99}, {"scenes": []},
        {"min_seconds": "no"}, {"title": 3}, {"scenes": {"s": scene}}, {"methods": "ab"},
        {"scenes": {"s0123456789": {**scene, "results": {"r0123456789": "ours"}}}},
    ):  # fmt: skip
        path = tmp_path / "wrong.key.json"
        path.write_text(json.dumps(facts | change))
        with pytest.raises(InputError):
            read_key(path)


# ------------------------------------------------------------------------------------- commands
def test_the_command_writes_the_report(
    key_file: Path, key: StudyKey, tmp_path: Path, shell: Shell
) -> None:
    for rater in range(3):
        tiny.write_answers(tmp_path / "answers", tiny.answers_of(key, rater))
    (tmp_path / "answers" / "bad.json").write_text("{}")
    report = shell.of("study", "report", str(tmp_path / "answers"), "--key", str(key_file))
    shown = report("--json", "--out", str(tmp_path / "out"))
    tiny.check_table(shown.facts)
    assert "bad.json" in shown.err
    assert [one["file"][-8:] for one in shown.facts["left_out"]] == ["bad.json"]
    made = {p.name: p.read_bytes() for p in (tmp_path / "out").iterdir()}
    assert {*made} == {"chart.png", "report.json", "table.csv", "table.md"}
    assert json.loads(made["report.json"]) == shown.facts
    report("--json", "--out", str(tmp_path / "out"))
    assert {p.name: p.read_bytes() for p in (tmp_path / "out").iterdir()} == made
    lines = report().out
    assert "5.50 (5.00–6.00)" in lines and "3 raters of 3 counted" in lines


def test_without_matplotlib_there_is_no_picture(
    key_file: Path, key: StudyKey, tmp_path: Path, shell: Shell, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setitem(__import__("sys").modules, "matplotlib.backends.backend_agg", None)
    file = tiny.write_answers(tmp_path / "answers", tiny.answers_of(key, 0))
    out = tmp_path / "out"
    shown = shell("study", "report", str(file), "--key", str(key_file), "--out", str(out))
    assert "tabletopgen[plot]" in shown.err
    assert sorted(p.name for p in out.iterdir()) == ["report.json", "table.csv", "table.md"]


def test_wrong_usage_is_told(key_file: Path, tmp_path: Path, shell: Shell) -> None:
    new = shell.of("study", "new")
    assert "METHOD=FOLDER" in new("ours", "b=c", "--out", str(tmp_path / "a.html"), code=2).err
    assert ".html" in new("a=b", "c=d", "--out", str(tmp_path / "a.txt"), code=2).err
    assert (
        "two methods have the same name"
        in new("a=b", "a=d", "--out", str(tmp_path / "a.html"), code=2).err.lower()
    )
    missing = str(tmp_path / "none.key.json")
    assert "The key" in shell("study", "report", "x.json", "--key", missing, code=2).err
    empty = tmp_path / "empty"
    empty.mkdir()
    shown = shell("study", "report", str(empty), "--key", str(key_file), code=2)
    assert "No answers were found" in shown.err
