"""Benchmark runs: identical results after interruptions and with any workers; valid policies."""

import hashlib
import json
import re
import sys
from pathlib import Path
from types import MappingProxyType

import numpy as np
import pytest
from command import Shell

from generator.errors import InputError
from generator.jobs.pools import PoolOptions
from tabletopgen_env.bench import run as running
from tabletopgen_env.bench.episode import FailurePictures, Stage
from tabletopgen_env.bench.instances import Suite
from tabletopgen_env.bench.players import find_player
from tabletopgen_env.bench.results import read_result
from tabletopgen_env.bench.run import BenchRun, run_suite
from tabletopgen_env.bench.suites import find_suite

POLICY = """
import numpy as np


class Still:
    env = {"observation": "goal", "image_size": (16, 16)}
    resets = 0

    def reset(self):
        self.resets += 1

    def predict(self, observation, deterministic):
        assert deterministic and set(observation) >= {"observation", "desired_goal"}
        return np.zeros(5), None


class Deaf(Still):
    env = {"control_hz": 10}


class Greedy(Still):
    env = {"randomization": "light", "robot": None}


class Odd(Still):
    env = {"observation": print}


class Narrow(Still):
    env = {}
    action_space = "three"


class Short(Still):
    env = {}

    def predict(self, observation, deterministic):
        return np.zeros(3), None


class Told(Still):
    digest = "weights 1"


class Loud(Still):
    digest = b"weights"


def number():
    return 3
"""


@pytest.fixture
def suite(suite_file: Path) -> Suite:
    return find_suite(f"{suite_file}:test")


@pytest.fixture
def module(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """The name of a module with policies, in the working directory."""
    name = f"policies_{abs(hash(tmp_path))}"
    (tmp_path / f"{name}.py").write_text(POLICY)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(sys, "path", [*sys.path])
    return name


def played(suite: Suite, player: str, out: Path, tables: Path, workers: int = 1) -> bytes:
    path = run_suite(suite, player, BenchRun(out, tables=tables, pool=PoolOptions(workers)))
    return path.read_bytes()


def test_two_runs_write_the_same_bytes(suite: Suite, store: Path, tmp_path: Path) -> None:
    one, two = (played(suite, "random", tmp_path / k, store) for k in "ab")
    assert one == two
    assert [p.name for p in (tmp_path / "a").iterdir()] == ["reach-test_random.json"]
    result = read_result(tmp_path / "a" / "reach-test_random.json")
    assert (result.player.name, result.task, len(result.episodes)) == ("random", "Reach", 4)
    assert all(row.steps == 12 or row.solved for row in result.episodes)
    assert len({row.reward for row in result.episodes}) == 4
    assert played(suite, "random", tmp_path / "a", store) == one  # nothing is played again


def test_a_run_that_was_killed_resumes(
    suite: Suite, store: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    whole = played(suite, "zero", tmp_path / "whole", store)
    out, calls = tmp_path / "cut", []
    play = Stage.play

    def interrupted(self: Stage, episode):
        calls.append(episode.number)
        if len(calls) == 3:
            raise KeyboardInterrupt
        return play(self, episode)

    monkeypatch.setattr(Stage, "play", interrupted)
    with pytest.raises(KeyboardInterrupt):
        played(suite, "zero", out, store)
    assert not (out / "reach-test_zero.json").exists()
    journal = out / "reach-test_zero.json.part"
    assert len(journal.read_text().splitlines()) == 3
    with journal.open("a") as file:
        file.write('{"goal": nu')  # what a killed process may leave
    assert played(suite, "zero", out, store) == whole
    assert len(calls) == 3 + 2 and [p.name for p in out.iterdir()] == ["reach-test_zero.json"]


@pytest.mark.parametrize("spoil", [
    lambda text: text.replace('"zero"', '"nero"'),
    lambda text: re.sub(r'"number": \d+', '"number": 7', text),
    lambda text: text + "[]\n",
    lambda text: text.replace('"solved": ', '"solved": 1'),
])  # fmt: skip
def test_another_journal_is_refused(
    suite: Suite, store: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, spoil
) -> None:
    monkeypatch.setattr(running, "remove_file", lambda *_: None)
    played(suite, "zero", tmp_path, store)
    monkeypatch.undo()
    (tmp_path / "reach-test_zero.json").unlink()
    journal = tmp_path / "reach-test_zero.json.part"
    journal.write_text(spoil(journal.read_text()))
    with pytest.raises(InputError, match="Remove it"):
        played(suite, "zero", tmp_path, store)


def test_a_journal_without_episodes_is_begun_again(
    suite: Suite, store: Path, tmp_path: Path, module: str
) -> None:
    run = BenchRun(tmp_path / "out", "mine", store)
    with pytest.raises(InputError, match="The policy's action_space"):
        run_suite(suite, f"{module}:Narrow", run)
    assert [p.name for p in run.out.iterdir()] == ["reach-test_mine.json.part"]
    assert run_suite(suite, "zero", run).name == "reach-test_mine.json"


def test_a_result_of_something_else_is_kept(
    suite: Suite, suite_file: Path, store: Path, tmp_path: Path
) -> None:
    played(suite, "zero", tmp_path, store)
    (tmp_path / "reach-test_zero.json").rename(tmp_path / "reach-test_random.json")
    with pytest.raises(InputError, match="contains a different result"):
        played(suite, "random", tmp_path, store)


@pytest.mark.slow
def test_processes_play_what_one_does(
    suite_file: Path, store: Path, tmp_path: Path, module: str
) -> None:
    suite = find_suite(f"{suite_file}:test-random")
    for player in ("reach-clone", f"{module}:Still"):
        one, two = (played(suite, player, tmp_path / f"{n}", store, n) for n in (1, 2))
        assert one == two, player


def test_a_function_of_ones_own_plays(
    suite: Suite, store: Path, tmp_path: Path, module: str
) -> None:
    name = f"{module}:Still"
    run = BenchRun(tmp_path / "out", "My policy", store)
    result = read_result(run_suite(suite, name, run))
    assert (result.player.name, result.player.kind) == ("My policy", "function")
    assert result.player.settings == {"observation": "goal", "image_size": [16, 16]}


def test_a_function_whose_module_changed_is_another_policy(
    suite: Suite, store: Path, tmp_path: Path, module: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    file, name, run = tmp_path / f"{module}.py", f"{module}:Still", BenchRun(tmp_path, None, store)
    path = run_suite(suite, name, run)
    digest = read_result(path).player.digest
    assert digest == hashlib.sha256(file.read_bytes()).hexdigest()
    assert find_player(name, suite)[0].digest == digest
    own = find_player(f"{module}:Told", suite)[0].digest
    assert len(own) == 64 and own != digest
    monkeypatch.setattr(sys.modules[module].Told, "digest", "weights 2")
    assert find_player(f"{module}:Told", suite)[0].digest not in (own, digest)
    file.write_text(POLICY + "\n\nSTEP = 2\n")
    monkeypatch.delitem(sys.modules, module)
    with pytest.raises(InputError, match="different result \\(different player\\)"):
        run_suite(suite, name, run)


@pytest.mark.parametrize(("policy", "why"), [
    ("Loud", "the policy's digest must be a string"),
    ("Nobody", "does not create a policy"),
    ("number", "without predict"),
    ("Deaf", "acts at 10 Hz"),
    ("Greedy", "'robot', which is set by the suite"),
    ("Odd", "strings, numbers, and lists"),
    ("Narrow", "The policy's action_space is three"),
    ("Short", "shape"),
])  # fmt: skip
def test_a_policy_that_does_not_fit_is_refused(
    suite: Suite, store: Path, tmp_path: Path, module: str, policy: str, why: str
) -> None:
    with pytest.raises(InputError, match=why):
        run_suite(suite, f"{module}:{policy}", BenchRun(tmp_path / "out", tables=store))
    assert not list((tmp_path / "out").glob("*.json"))


def test_shipped_policies_play_their_task(suite: Suite, store: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="lift-clone was trained for Lift"):
        played(suite, "lift-clone", tmp_path, store)
    with pytest.raises(InputError, match=r"Unknown policy 'reach-clown'.*reach-clone"):
        played(suite, "reach-clown", tmp_path, store)
    with pytest.raises(InputError, match="contains no policy yet"):
        played(suite, str(tmp_path), tmp_path, store)


def test_a_policy_file_of_other_spaces_is_refused(suite: Suite, store: Path) -> None:
    import dataclasses

    from tabletopgen_env.bench.episode import Playing
    from tabletopgen_env.bench.players import PolicyPlayer

    facts, player = find_player("reach-clone", suite)
    assert facts.kind == "policy" and len(facts.digest) == 64
    assert isinstance(player, PolicyPlayer)
    card = dataclasses.replace(player.policy.card, inputs=MappingProxyType({"": 7}))
    other = PolicyPlayer(dataclasses.replace(player.policy, card=card))
    stage = Stage(Playing(suite, "zero", {"any": next(store.glob("bench-*"))}))
    with pytest.raises(InputError, match="Train it again"):
        other.begin(stage.env, 0)
    stage.env.close()


def test_no_worker_is_refused(suite: Suite, store: Path, tmp_path: Path) -> None:
    with pytest.raises(InputError, match="--workers"):
        played(suite, "zero", tmp_path / "out", store, 0)
    assert not (tmp_path / "out").exists()


def test_a_run_in_progress_is_left_alone(suite: Suite, store: Path, tmp_path: Path) -> None:
    from filelock import FileLock

    from generator.errors import StorageError

    with (
        FileLock(tmp_path / "reach-test_zero.json.lock"),
        pytest.raises(StorageError, match="Another process"),
    ):
        played(suite, "zero", tmp_path, store)


@pytest.mark.slow
def test_failures_are_shown(suite: Suite, store: Path, tmp_path: Path) -> None:
    from PIL import Image

    pictures = FailurePictures(tmp_path / "strips", tmp_path / "films")
    shown = played_with(suite, pictures, tmp_path / "a", store)
    assert shown == played(suite, "zero", tmp_path / "b", store)
    failed = [row for row in json.loads(shown)["episodes"] if not row["solved"]]
    strips, films = (
        sorted(folder.iterdir()) for folder in (tmp_path / "strips", tmp_path / "films")
    )
    assert len(strips) == len(films) == len(failed) > 0
    assert np.asarray(Image.open(strips[0])).std() > 10
    assert Image.open(films[0]).n_frames >= 2  # pyright: ignore[reportAttributeAccessIssue]


def played_with(suite: Suite, pictures: FailurePictures, out: Path, tables: Path) -> bytes:
    return run_suite(suite, "zero", BenchRun(out, tables=tables, pictures=pictures)).read_bytes()


def test_the_command_runs_suites(
    shell: Shell, suite_file: Path, store: Path, tmp_path: Path
) -> None:
    run = shell.of("bench", "run", "zero", "--tables", str(store), "--out", str(tmp_path))
    shown = run("--suite", f"{suite_file}:test", f"{suite_file}:test-random")
    assert "zero solved 0 of 4 on reach-test," in shown.out
    assert "of 6 on reach-test-random," in shown.out
    made = shell("bench", "make", f"{suite_file}:test", "--out", str(store)).out.split()
    assert sorted(made) == sorted(map(str, store.iterdir()))
    listed = shell("bench", "list").out
    assert "lift-test-random" in listed and "Version v1" in listed and "lift-train" in listed
    assert "Unknown suite 'lift-tset'" in run("--suite", "lift-tset", code=2).err
    assert "--workers" in run("--suite", f"{suite_file}:test", "--workers", "0", code=2).err


def test_a_result_is_called_by_a_plain_name(suite: Suite) -> None:
    from tabletopgen_env.bench.players import PlayerFacts

    path = running.result_path(Path("x"), suite, PlayerFacts("../my/a b:c", "function"))
    assert path == Path("x/reach-test_my-a-b-c.json")
