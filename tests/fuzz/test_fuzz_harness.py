"""The fuzzing harness detects planted faults, and reports how to reproduce them."""

import importlib.util
import json
import random
from collections.abc import Iterator
from pathlib import Path

import pytest
from hostile import values
from hostile.harness import BrokenTarget, Outcome, Tally, Worker, report, run_cases
from hostile.room import CANARIES, Room, listing
from hostile.streams import hostile_png, png, spoiled
from hostile.targets import KINDS, target


@pytest.fixture(scope="module")
def worker() -> Iterator[Worker]:
    with Worker(seconds=2.0, most_mib=256.0) as started:
        yield started


def test_what_ends_in_our_errors_is_well(worker: Worker) -> None:
    tally = run_cases(worker, "planted:sound", 0, range(20))
    assert tally.bad == [] and report(tally) == ""
    assert 0 < tally.count("refused") < 20 == len(tally.outcomes)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("fault", "end", "says"),
    [
        ("raises", "foreign", "KeyError: 'missing'"),
        ("dies", "foreign", "ended with 7"),
        ("sleeps", "late", "planted.py"),
        ("eats", "heavy", ""),
        ("gulps", "heavy", ""),
        ("feeds", "heavy", ""),
        ("delegates", "late", ""),
        ("removes", "outside", "inside/beside.txt"),
        ("appends", "outside", "precious/file.txt"),
        ("escapes", "outside", "far.txt"),
        ("leaves", "outside", ".staging-x"),
    ],
)
def test_a_planted_fault_is_found(worker: Worker, fault: str, end: str, says: str) -> None:
    outcome = worker.run(f"planted:{fault}", 3, 5)
    assert (outcome.end, outcome.good) == (end, False)
    assert says in outcome.detail
    assert "--kind planted:" + fault + " --case 5 --seed 3" in outcome.told()
    assert worker.run("planted:sound", 0, 0).good  # and the harness goes on


@pytest.mark.slow
def test_a_case_that_waits_takes_no_time(worker: Worker) -> None:
    outcome = worker.run("planted:idles", 0, 0)
    assert outcome.good and outcome.seconds < 1


def test_a_broken_target_is_no_fault_of_the_product(worker: Worker) -> None:
    with pytest.raises(BrokenTarget, match="a fault of the target"):
        worker.run("planted:broken", 0, 0)


def test_like_faults_are_reported_once() -> None:
    trace = 'File "a.py", line 3, in f\nKeyError: {}'
    outcomes = [Outcome("x", 0, k, "foreign", trace.format(k)) for k in range(5)]
    outcomes.append(Outcome("x", 0, 9, "late", '  File "/generator/b.py", line 1 in g'))
    said = report(Tally("x", 0, outcomes))
    assert "5 foreign, 1 late of 6, by 2 causes" in said
    assert said.count("KeyError") == 1 and "like cases: 1, 2, 3, 4" in said


def test_a_room_tells_and_mends_what_changed(tmp_path: Path) -> None:
    room = Room(tmp_path)
    (room.case / "own.txt").write_text("x")
    assert room.changes() == []
    (tmp_path / "precious" / "file.txt").unlink()
    (tmp_path / "inside" / "new").mkdir()
    assert room.changes() == ["inside/new", "precious/file.txt"]
    assert room.changes() == []
    assert set(listing(tmp_path)) >= set(CANARIES)


def test_cases_depend_on_their_seed_and_number_alone(tmp_path: Path) -> None:
    def crafted(place: str, seed: str) -> dict[str, str]:
        folder = tmp_path / place / "case"
        folder.mkdir(parents=True)
        target("recipe")(random.Random(seed), folder)
        return listing(folder)

    assert crafted("a", "1") == crafted("b", "1") != crafted("c", "2")


def test_every_kind_has_a_target() -> None:
    assert len(KINDS) >= 20
    for kind in KINDS:
        assert callable(target(kind)), kind


def test_mutations_reach_every_field_and_leave_the_given_alone() -> None:
    given = {"a": 1, "b": {"c": [1, 2, "x"]}, "d": None, "e": True}
    before = json.dumps(given)
    rng = random.Random(0)
    changed = [values.mutate(given, rng) for _ in range(2000)]
    assert json.dumps(given) == before
    for key in ("a", "b", "d", "e"):
        assert any(isinstance(c, dict) and c.get(key) != given[key] for c in changed), key
    inner = [c["b"]["c"] for c in changed if isinstance(c, dict) and isinstance(c.get("b"), dict)
             and "c" in c["b"]]  # fmt: skip
    assert any(isinstance(i, list) and len(i) > 3 for i in inner)
    raw = {values.written(values.mutate(given, rng, raw=True), rng) for _ in range(2000)}
    assert any(b"NaN" in r for r in raw) and any(b"[" * 1000 in r for r in raw)


def test_pictures_are_spoiled_in_many_ways() -> None:
    rng, good = random.Random(0), png(8, 8)
    assert len({hostile_png(rng, good) for _ in range(200)}) > 100
    assert len({spoiled(good, rng) for _ in range(200)}) > 100


def test_the_command_writes_a_table_and_runs_one_case_again(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    path = Path(__file__).parents[2] / "benchmarks" / "fuzz.py"
    spec = importlib.util.spec_from_file_location("benchmark_fuzz", path)
    assert spec is not None and spec.loader is not None
    command = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(command)
    rows = {}
    for kind in ("glb", "paper-json"):
        outcomes = [Outcome(kind, 0, 1, "refused"), Outcome(kind, 0, 2, "foreign")]
        rows[kind] = command.row(Tally(kind, 0, outcomes), 3.0)
        command.write(rows, tmp_path, "a machine", "python benchmarks/fuzz.py")
    assert command.read(tmp_path / "fuzz.csv") == rows
    assert "| **all** | 4 | 0 | 2 | 2 |" in (tmp_path / "fuzz.md").read_text()
    assert command.main(["--kind", "planted:raises", "--case", "4", "--seed", "7"]) == 1
    assert "planted:raises case 4 of seed 7: foreign" in capsys.readouterr().out
