"""Checks of results: consistency of the figures, and replays of some episodes."""

import dataclasses
import json
from pathlib import Path

import pytest
from command import Shell

from generator.errors import InputError
from generator.scene.provenance import versions
from tabletopgen_env.bench import leaderboard, results
from tabletopgen_env.bench.audit.figures import doubts
from tabletopgen_env.bench.audit.marks import ReplayMark, mark_path, read_mark, write_mark
from tabletopgen_env.bench.episode import SuiteOutcome
from tabletopgen_env.bench.instances import Suite
from tabletopgen_env.bench.players import PlayerFacts
from tabletopgen_env.bench.run import PACKAGES, BenchRun, run_suite
from tabletopgen_env.bench.suites import canonical_digest, find_suite, tasks

ROOT = Path(__file__).parents[2]


@pytest.fixture
def toy(suite_file: Path) -> Suite:
    return find_suite(f"{suite_file}:test")


@pytest.fixture
def zero(toy: Suite, store: Path, tmp_path: Path) -> Path:
    """The result of a run at the toy tables."""
    return run_suite(toy, "zero", BenchRun(tmp_path, tables=store))


def forged(suite: Suite, path: Path, outcome: SuiteOutcome, kind: str = "policy") -> Path:
    """Write a fabricated result with equal episodes and a matching digest."""
    rows = [results.row_of(episode, outcome) for episode in suite.episodes()]
    facts = PlayerFacts("SuperNet", kind, "ab" * 32 if kind == "policy" else "")
    results.write_result(path, results.head_of(suite, facts, versions(PACKAGES)), rows)
    return path


def edited(path: Path, **change: object) -> None:
    """Change the first episode of a result, and update its sums and digest."""
    payload = json.loads(path.read_text())
    payload.pop("digest")
    payload["episodes"][0].update(change)
    payload["solved"] = sum(row["solved"] for row in payload["episodes"])
    path.write_text(json.dumps({**payload, "digest": canonical_digest(payload)}))


@pytest.mark.parametrize(("outcome", "kind", "wrong"), [
    (SuiteOutcome(True, 1, 1.0), "policy", {"too fast", "reward too high"}),
    (SuiteOutcome(True, 101, 0.5), "policy", {"too long"}),
    (SuiteOutcome(True, 40, 0.2), "policy", {"reward too low"}),
    (SuiteOutcome(True, 40, 1.0), "policy", {"reward too high"}),
    (SuiteOutcome(False, 60, 0.2), "policy", {"cut short"}),
    (SuiteOutcome(False, 60, 0.2), "expert", set()),
    (SuiteOutcome(False, 100, 1.0), "policy", {"reward too high"}),
    (SuiteOutcome(True, 10, 1.0), "policy", set()),
    (SuiteOutcome(True, 40, 0.6), "policy", set()),
    (SuiteOutcome(False, 100, 0.3), "policy", set()),
])  # fmt: skip
def test_figures_that_no_run_gives_are_named(
    tmp_path: Path, outcome: SuiteOutcome, kind: str, wrong: set[str]
) -> None:
    suite = find_suite("lift-test-random")
    read = results.read_result(forged(suite, tmp_path / "a.json", outcome, kind))
    found = doubts(read, suite)
    assert {doubt.kind for doubt in found} == wrong
    assert all(doubt.count == len(read.episodes) for doubt in found)


def test_a_forged_result_is_neither_marked_nor_shown(tmp_path: Path, shell: Shell) -> None:
    suite = find_suite("lift-test-random")
    path = forged(suite, tmp_path / "forged.json", SuiteOutcome(True, 1, 1.0))
    said = shell("bench", "check", str(path), code=1).err
    assert "126 episodes solved in 1 steps, but success must hold for 10" in said
    assert not mark_path(path).exists()
    shown = shell("bench", "leaderboard", str(tmp_path), code=2).err
    assert "SuperNet on lift-test-random has impossible values" in shown


def test_a_result_without_the_versions_of_a_run_is_named(tmp_path: Path) -> None:
    suite = find_suite("lift-test")
    read = results.read_result(forged(suite, tmp_path / "a.json", SuiteOutcome(True, 40, 0.6)))
    [doubt] = doubts(dataclasses.replace(read, versions={"mujoco": "3"}), suite)
    assert (doubt.kind, doubt.count) == ("no versions", len(PACKAGES) - 1)


def test_no_committed_result_has_such_figures() -> None:
    for path in sorted((ROOT / "benchmarks" / "results" / "bench").glob("*.json")):
        read = results.read_result(path)
        assert doubts(read, find_suite(read.suite)) == (), path.name


def test_what_was_played_is_marked(zero: Path, suite_file: Path, store: Path, shell: Shell) -> None:
    own = ("--suite", f"{suite_file}:test", "--tables", str(store))
    said = shell("bench", "check", str(zero), *own, "--episodes", "3", "--seed", "1").out
    assert "3 of 4 episodes replayed (seed 1), all as listed" in said
    mark = read_mark(zero, results.read_result(zero).digest)
    assert mark is not None and (mark.seed, len(mark.episodes)) == (1, 3)
    assert mark.versions == versions(PACKAGES)
    before = mark_path(zero).read_bytes()
    shell("bench", "check", str(zero), *own, "--episodes", "3", "--seed", "1")
    assert mark_path(zero).read_bytes() == before
    assert "4 of 4" in shell("bench", "check", str(zero), *own, "--episodes", "9").out


def test_a_check_of_fewer_episodes_keeps_the_mark(
    zero: Path, suite_file: Path, store: Path, shell: Shell
) -> None:
    check = shell.of(
        "bench", "check", str(zero), "--suite", f"{suite_file}:test", "--tables", str(store),
    )  # fmt: skip
    check("--episodes", "3", "--seed", "1")
    before = mark_path(zero).read_bytes()
    assert "kept the existing mark for 3 episodes" in check("--episodes", "1").out
    assert mark_path(zero).read_bytes() == before
    mark_path(zero).write_bytes(before[:-20])  # damaged, and no longer a mark
    check("--episodes", "1")
    mark = read_mark(zero, results.read_result(zero).digest)
    assert mark is not None and len(mark.episodes) == 1
    edited(zero, reward=0.123456)
    write_mark(zero, ReplayMark(results.read_result(zero).digest, 0, (1, 2, 3), versions(PACKAGES)))
    check("--episodes", "4", code=1)
    assert not mark_path(zero).exists()


def test_a_player_without_a_policy_is_shown_as_what_it_is(tmp_path: Path) -> None:
    suite = find_suite("lift-test")
    forged(suite, tmp_path / "a.json", SuiteOutcome(False, 60, 0.2), "expert")
    page = leaderboard.page(leaderboard.read_results(tmp_path))
    assert "| SuperNet (expert) | the world |" in page


@pytest.mark.parametrize(("player", "wrong"), [
    ({"kind": "oracle"}, "got 'oracle'"),
    ({"kind": "expert", "digest": "ab" * 32}, "cannot have a digest"),
    ({"kind": "zero", "settings": {"observation": "pixels"}}, "or settings"),
    ({"kind": "policy", "name": "Expert", "digest": "ab" * 32}, "called 'Expert'"),
])  # fmt: skip
def test_no_result_is_of_a_player_that_there_cannot_be(
    tmp_path: Path, player: dict, wrong: str
) -> None:
    path = forged(find_suite("lift-test"), tmp_path / "a.json", SuiteOutcome(False, 100, 0.2))
    payload = json.loads(path.read_text())
    payload.pop("digest")
    payload["player"] |= {"digest": "", **player}
    path.write_text(json.dumps({**payload, "digest": canonical_digest(payload)}))
    with pytest.raises(InputError, match=wrong):
        results.read_result(path)


def test_no_policy_runs_under_the_name_of_the_expert(
    toy: Suite, store: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "my_still_policy.py").write_text(
        "class Still:\n    def predict(self, observation, deterministic):\n        return None\n"
    )
    monkeypatch.syspath_prepend(str(tmp_path))
    run = BenchRun(tmp_path / "out", "expert", tables=store)
    with pytest.raises(InputError, match="cannot be named 'expert'"):
        run_suite(toy, "my_still_policy:Still", run)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("change", [
    {"solved": True, "steps": 12, "reward": 0.9}, {"reward": 0.123456},
])  # fmt: skip
def test_what_was_not_played_so_loses_its_mark(
    zero: Path, suite_file: Path, store: Path, shell: Shell, change: dict
) -> None:
    check = shell.of(
        "bench", "check", str(zero), "--suite", f"{suite_file}:test", "--tables", str(store),
        "--episodes", "4",
    )  # fmt: skip
    check()
    edited(zero, **change)
    assert read_mark(zero, results.read_result(zero).digest) is None  # the mark is another's
    said = check(code=1).err
    assert "episode 0 (table" in said and "listed as" in said and "1 of 4 episodes differ" in said
    assert not mark_path(zero).exists()


def test_the_last_digits_of_a_reward_are_a_processors_own(
    zero: Path, suite_file: Path, store: Path, shell: Shell
) -> None:
    reward = results.read_result(zero).episodes[0].reward
    edited(zero, reward=round(reward + 2e-6, 6))
    own = ("--suite", f"{suite_file}:test", "--tables", str(store), "--episodes", "4")
    assert "all as listed" in shell("bench", "check", str(zero), *own).out


def test_another_policy_is_not_the_one_of_the_result(
    zero: Path, suite_file: Path, store: Path, shell: Shell
) -> None:
    own = ("--suite", f"{suite_file}:test", "--tables", str(store))
    said = shell("bench", "check", str(zero), *own, "--policy", "random", code=2).err
    assert "random is not the policy of the result of zero (different kind)" in said
    assert "--episodes" in shell("bench", "check", str(zero), *own, "--episodes", "0", code=2).err
    payload = json.loads(zero.read_text())
    payload.pop("digest")
    payload["player"] |= {"kind": "policy", "name": "mine.safetensors", "digest": "ab" * 32}
    zero.write_text(json.dumps({**payload, "digest": canonical_digest(payload)}))
    said = shell("bench", "check", str(zero), *own, code=2).err
    assert "policy 'mine.safetensors' was not found" in said


def test_the_leaderboard_shows_marks(tmp_path: Path) -> None:
    suite = find_suite(f"{tasks()[0].lower()}-test")
    outcome = SuiteOutcome(False, suite.of.time_limit, 0.25)
    path = forged(suite, tmp_path / "a.json", outcome, "random")
    total = len(suite.episodes())
    write_mark(path, ReplayMark(results.read_result(path).digest, 0, (1, 4), versions(PACKAGES)))
    page = leaderboard.page(leaderboard.read_results(tmp_path))
    assert "| replayed |" in page and f"| 2 of {total} |" in page
    edited(path, reward=0.26)
    assert f"| 2 of {total} |" not in leaderboard.page(leaderboard.read_results(tmp_path))


@pytest.mark.parametrize("spoil", [
    lambda text: text[:-20],
    lambda text: text.replace('"seed": 0', '"seed": 1'),
    lambda text: "[]",
])  # fmt: skip
def test_a_mark_that_was_edited_is_refused(zero: Path, spoil) -> None:
    digest = results.read_result(zero).digest
    write_mark(zero, ReplayMark(digest, 0, (1,), versions(PACKAGES)))
    mark_path(zero).write_text(spoil(mark_path(zero).read_text()))
    with pytest.raises(InputError):
        read_mark(zero, digest)
