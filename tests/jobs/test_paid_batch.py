"""Batches with paid calls: one budget for all scenes, workers and runs."""

import json
import pickle
import shutil
from collections.abc import Callable, Iterator
from concurrent.futures import Future
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from calls.paid_server import Says, Served, ask, remote_backend, serving
from command import Shell
from toy import toy_object, toy_scene
from toy_maker import ToyMaker, made

from generator import bundle
from generator import jobs as batch
from generator.backends import Mix, select
from generator.errors import BackendError, InputError, StorageError
from generator.scene import Provenance, Report


@pytest.mark.slow
def test_processes_spend_one_sum_and_go_on_with_a_larger_one(tmp_path: Path) -> None:
    log, out = tmp_path / "log", tmp_path / "out"
    texts = ["paid one", "paid two", "paid three", "a cube", "bad words"]
    with serving([Says(delay=0.1)]) as server:

        def run(budget: float) -> batch.Summary:
            make = ToyMaker(str(log), server.url, batch.shared_budget(out), budget)
            return batch.run(texts, out, make, workers=2)

        first = run(0.07)  # 0.021 and 0.021, then 0.04 might be too much
        assert sorted(o.state for o in first.outcomes[:3]) == ["made", "made", "unpaid"]
        assert [o.state for o in first.outcomes[3:]] == ["made", "failed"]
        (left,) = first.unpaid
        assert (
            left.kind == "BudgetError"
            and "0.0420 of the budget of 0.07 for all scenes is spent" in str(left.error)
        )
        assert first.counts() == {"made": 3, "there": 0, "failed": 1, "unpaid": 1}
        assert len(server.asked) == 2

        more = run(0.1)
        assert [o.state for o in more.outcomes].count("made") == 1 and more.unpaid == ()
    assert len(server.asked) == 3
    assert batch.shared_budget(out).total().money == pytest.approx(0.063)
    assert made(log).count("a cube 0") == 1


@pytest.mark.slow
def test_a_folder_that_the_workers_do_not_share_ends_the_batch(tmp_path: Path) -> None:
    """Each of them would spend the whole sum."""
    budget = batch.shared_budget(tmp_path / "theirs")
    shutil.rmtree(tmp_path / "theirs")
    make = ToyMaker(str(tmp_path / "log"), "http://127.0.0.1:9", budget, 1.0)
    with pytest.raises(StorageError, match="is not the folder in which the batch was started"):
        batch.run(["paid one"], tmp_path / "out", make)


def test_a_budget_needs_a_sum_on_disk(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="shared_budget"):
        batch.Generating(budget=1.0)
    with pytest.raises(InputError, match="budget"):
        batch.Generating(budget=-1.0, shared_budget=batch.shared_budget(tmp_path))
    rich = batch.Generating(budget=1.0, shared_budget=batch.shared_budget(tmp_path), dry=True)
    assert rich.identity() == batch.Generating().identity()  # money decides no byte


def test_who_answers_is_decided_where_the_batch_is_made(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Processes elsewhere have other environments; the record of a scene is the same."""

    def made(model: str) -> batch.Generating:
        monkeypatch.setenv("TABLETOPGEN_CLOUD_CHAT_MODEL", model)
        return batch.Generating(Mix(reasoner="cloud"))

    monkeypatch.setenv("TABLETOPGEN_CLOUD_KEY", "no-real-key-123456")
    one = made("gpt-one")
    sent, other = pickle.dumps(one), made("gpt-two")
    assert one.identity() != other.identity()
    there = pickle.loads(sent)
    assert there.identity() == one.identity()
    assert "no-real-key" not in repr(one) + str(sent)
    with pytest.raises(BackendError, match=r"reasoner .*gpt-two.* instead of .*gpt-one"):
        there(batch.Job("a desk"), tmp_path / "out")
    assert not (tmp_path / "out").exists()


# ------------------------------------------------------------------------------------- the command
class Here:
    """A pool that runs tasks in this process, in order."""

    def __init__(self, width: int) -> None:
        self.width = width

    def submit(self, function: Callable[..., batch.Outcome], *args: Any) -> Future[batch.Outcome]:
        done: Future[batch.Outcome] = Future()
        done.set_result(function(*args))
        return done

    def close(self, grace: float = 0.0) -> None: ...


@pytest.fixture
def run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, shell: Shell
) -> Iterator[tuple[Served, Shell]]:
    """A server, and the command with two requests per scene: 0.02 each, at most 0.04."""
    table = remote_backend(monkeypatch, tmp_path)
    monkeypatch.setattr("generator.jobs.pools.WorkerPool", Here)
    prompts = tmp_path / "prompts.txt"
    prompts.write_text("one\ntwo\n")

    with serving([Says()]) as served:

        def generate(text: str, backends: Any, config: Any, seed: int) -> Any:
            for k in range(2):
                ask(backends.modeler.session, served.url, f"{text} {k}")
            cube = toy_object("cube_1", (0.05, 0.05, 0.05), (0.01 * len(text), 0.0))
            told = Provenance("text", seed, text)
            scene = toy_scene((cube,)).replace(provenance=told, report=Report(1e-4, 0.0, 0.0))
            return SimpleNamespace(save=lambda folder: bundle.save(scene, folder))

        monkeypatch.setattr("generator.pipeline.generate", generate)
        monkeypatch.setattr("generator.jobs.work._share", lambda: None)
        given = ("batch", str(prompts), "--out", str(tmp_path / "out"), "--backend", "remote",
                 "--prices", str(table), "--calls", str(tmp_path / "calls"))  # fmt: skip
        yield served, shell.of(*given)


def test_the_command_keeps_its_budget_and_says_what_was_spent(
    run: tuple[Served, Shell], tmp_path: Path
) -> None:
    server, batching = run
    shown = batching("--budget", "0.09", code=3).out  # 0.02, 0.02, 0.02, and then 0.04 is too much
    assert "1 made, 0 already done, 0 failed, 1 beyond the budget" in shown
    assert "spent in all runs: 0.0600 of 0.09 EUR" in shown
    assert "not made: 'two'" in shown and "raise the budget" in shown
    assert len(server.asked) == 3
    summary = json.loads((tmp_path / "out" / "summary.json").read_text())
    assert (summary["unpaid"], summary["failures"]) == (1, {})

    told = batching("--budget", "0.1", "--json").facts
    assert (told["made"], told["there"], told["unpaid"]) == (1, 1, 0)
    assert told["spent"] == {"money": 0.08, "currency": "EUR", "unpriced": 0, "budget": 0.1}
    assert len(server.asked) == 4  # what was answered was kept
    ledgers = [json.loads(p.read_text())["money"] for p in tmp_path.glob("out/*/ledger.json")]
    assert ledgers == [0.04, 0.04]  # that of "two" knows of the run in which it was left


def test_what_was_spent_without_a_budget_counts_later(
    run: tuple[Served, Shell], tmp_path: Path
) -> None:
    server, batching = run
    assert "spent in all runs: 0.0800 EUR" in batching().out
    (tmp_path / "prompts.txt").write_text("three\n")
    batching("--budget", "0.11", code=3)
    assert len(server.asked) == 4


@pytest.mark.slow
def test_a_dry_run_says_what_each_scene_would_ask_and_makes_nothing(
    run: tuple[Served, Shell], tmp_path: Path
) -> None:
    server, batching = run
    roles = batching("--dry-run", "--budget", "0").out.splitlines()[:5]
    assert [line.split() for line in roles] == [[role, "remote"] for role in select.PROTOCOLS]
    rows = batching("--dry-run", "--json").facts["dry_run"]
    assert [(r["text"], r["state"]) for r in rows] == [("one", "to ask"), ("two", "to ask")]
    first = rows[0]["calls"][0]
    assert first.startswith("Would call cloud, plan_scene (m), for at most 0.0400 EUR")
    assert server.asked == [] and not (tmp_path / "out").exists()

    batching("--budget", "0.09", code=3)
    rows = batching("--dry-run", "--json").facts["dry_run"]
    assert [r["state"] for r in rows] == ["there", "to ask"]
    assert len(server.asked) == 3


def test_what_asks_no_server_needs_no_sum(run: tuple[Served, Shell], tmp_path: Path) -> None:
    _, batching = run
    shown = batching("--backend", "embedded", "--dry-run").out
    assert "No server is called." in shown and "reasoner   embedded" in shown
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize(
    ("more", "words"),
    [
        (("--budget", "-1"), "--budget"),
        (("--route", "compose", "--backend", "embedded", "--budget", "1"), "uses no backends"),
        (("--prices", "no-such.toml"), "cannot be read"),
    ],
)
def test_wrong_settings_of_money_are_one_line(
    run: tuple[Served, Shell],
    tmp_path: Path, more: tuple[str, ...], words: str
) -> None:  # fmt: skip
    server, batching = run
    assert words in batching(*more, code=2).err
    assert server.asked == [] and not (tmp_path / "out").exists()
