"""Batches: every valid scene is generated exactly once, despite interruptions."""

import json
import os
import signal
import subprocess
import sys
import threading
import time
from concurrent.futures import Future
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import toy_maker
from bounded import LONG, join, until
from calls.paid_server import Says, serving
from toy_maker import ToyMaker, made

from generator import bundle
from generator import jobs as batch
from generator.backends import Mix
from generator.errors import InputError, StorageError
from generator.generation import Config
from generator.jobs.records import PLACE, key_of
from generator.jobs.workers import WorkerPool
from generator.scene.provenance import plain

HERE = Path(__file__).parent
TEXTS = ("a cube", "bad words", "another cube", "broken code", "a third cube")


@pytest.fixture
def log(tmp_path: Path) -> Path:
    return tmp_path / "log"


def bundles(folder: Path) -> set[str]:
    return {p.name for p in folder.iterdir() if p.is_dir() and p.name != PLACE}


@pytest.mark.slow
def test_one_bad_prompt_stops_nothing_and_nothing_is_made_twice(tmp_path: Path, log: Path) -> None:
    out, told = tmp_path / "out", []
    summary = batch.run(
        TEXTS, out, ToyMaker(str(log)), workers=2, progress=lambda *t: told.append(t)
    )
    assert [o.state for o in summary.outcomes] == ["made", "failed", "made", "failed", "made"]
    assert [o.kind for o in summary.failures] == ["InputError", "RuntimeError"]
    assert summary.failures[0].error == "'bad words' cannot be read."
    assert made(log) == sorted(f"{text} 0" for text in TEXTS)
    assert bundles(out) == {o.bundle for o in summary.outcomes if o.bundle}
    assert all(bundle.verify(out / name) == [] for name in bundles(out))
    assert [(done, total) for _, done, total in told] == [(k, 5) for k in range(1, 6)]
    assert summary.gate()["penetration_mm"] == {"mean": 0.1, "most": 0.1}
    facts = json.loads((out / "summary.json").read_text())
    assert (facts["made"], facts["failed"]) == (3, 2)
    assert facts["failures"] == {"InputError": 1, "RuntimeError": 1}

    again = batch.run(TEXTS, out, ToyMaker(str(log)), workers=2)
    assert [o.state for o in again.outcomes] == ["there", "failed", "there", "failed", "there"]
    assert again.gate() == summary.gate()
    assert made(log).count("broken code 0") == 2  # a fault of the code may be gone
    assert len(made(log)) == 6
    batch.run(TEXTS, out, ToyMaker(str(log)), retry=True)
    assert made(log).count("bad words 0") == 2


@pytest.mark.slow
def test_the_number_of_workers_changes_no_byte(tmp_path: Path, log: Path) -> None:
    jobs = batch.jobs_of(["a cube", "a can"], seed=3, variants=2)
    assert [j.seed for j in jobs] == [3, 4, 3, 4]
    for workers in (1, 2):
        batch.run(jobs, tmp_path / str(workers), ToyMaker(str(log)), workers=workers)
    names = bundles(tmp_path / "1")
    assert len(names) == 4
    assert bundles(tmp_path / "2") == names


@pytest.mark.slow
def test_a_process_that_dies_takes_its_own_scene_alone(tmp_path: Path, log: Path) -> None:
    texts = ["deadly one", "a cube", "another cube"]
    summary = batch.run(texts, tmp_path / "out", ToyMaker(str(log)), workers=2)
    assert [o.state for o in summary.outcomes] == ["failed", "made", "made"]
    assert summary.failures[0].kind == "Crash"
    assert len(bundles(tmp_path / "out")) == 2


@pytest.mark.slow
@pytest.mark.parametrize("busy", [False, True])
def test_a_process_that_dies_between_two_scenes_ends_no_batch(
    tmp_path: Path, log: Path, monkeypatch: pytest.MonkeyPatch, busy: bool
) -> None:
    """Killed while the next scene is handed out, with or without other workers."""
    given, killed = [], []

    class Killed(WorkerPool):
        def submit(self, *task: Any) -> Future[Any]:
            given.append(task)
            if len(given) == 2:
                for pid in self.pids:
                    os.kill(pid, signal.SIGKILL)
                    killed.append(pid)
                until(lambda: not self.pids)
            return super().submit(*task)

    monkeypatch.setattr("generator.jobs.pools.WorkerPool", Killed)
    texts = ["a cube", "another cube", "third cube"]
    summary = batch.run(texts, tmp_path / "out", ToyMaker(str(log)), workers=1 + busy)
    assert [o.state for o in summary.outcomes] == ["made"] * 3
    assert len(bundles(tmp_path / "out")) == 3 and killed


@pytest.mark.slow
def test_two_batches_share_a_folder(tmp_path: Path, log: Path) -> None:
    texts = [f"cube number {k}" for k in range(4)] + ["half a cube"]
    out, states = tmp_path / "out", []

    def run() -> None:
        summary = batch.run(texts, out, ToyMaker(str(log)))
        states.extend(o.state for o in summary.outcomes)

    threads = [threading.Thread(target=run) for _ in range(2)]
    for thread in threads:
        thread.start()
    until(lambda: len(made(log)) == 5)
    time.sleep(0.2)  # so that the other one finds it being made
    Path(f"{log}.go").touch()
    join(*threads)
    assert made(log) == sorted(f"{text} 0" for text in texts)
    assert sorted(states) == ["made"] * 5 + ["there"] * 5


@pytest.mark.slow
@pytest.mark.skipif(os.name == "nt", reason="kills by signal")
def test_killed_and_run_again_nothing_is_made_twice(tmp_path: Path, log: Path) -> None:
    out, texts = tmp_path / "out", ["a cube", "half a cube", "another cube"]
    path = os.pathsep.join([str(HERE), str(HERE.parent), *sys.path])
    process = subprocess.Popen(
        [sys.executable, str(HERE / "toy_maker.py"), str(out), str(log), *texts],
        env={**os.environ, "PYTHONPATH": path},
    )
    until(lambda: len(made(log)) == 3 and len(list((out / PLACE).glob("*.json"))) == 2)
    process.send_signal(signal.SIGKILL)
    process.wait(LONG)
    half = key_of(batch.Job("half a cube"), ToyMaker(str(log)))
    assert (out / PLACE / half / "toy-half").is_dir()
    assert len(bundles(out)) == 2
    Path(f"{log}.go").touch()
    summary = batch.run(texts, out, ToyMaker(str(log)))
    assert all(o.bundle in bundles(out) for o in summary.outcomes)
    assert [made(log).count(f"{text} 0") for text in texts] == [1, 2, 1]
    assert not (out / PLACE / half).exists()


@pytest.mark.slow
def test_an_interrupt_does_not_wait_for_what_is_being_made(tmp_path: Path, log: Path) -> None:
    def interrupt(*told: object) -> None:
        raise KeyboardInterrupt

    texts = ["half a cube", "a cube"]
    with pytest.raises(KeyboardInterrupt):
        batch.run(texts, tmp_path / "out", ToyMaker(str(log)), workers=2, progress=interrupt)
    Path(f"{log}.go").touch()
    states = [o.state for o in batch.run(texts, tmp_path / "out", ToyMaker(str(log))).outcomes]
    assert states == ["made", "there"]


@pytest.mark.slow
def test_a_whole_scene_that_is_not_in_its_place_is_put_there(tmp_path: Path, log: Path) -> None:
    out, make = tmp_path / "out", ToyMaker(str(log))
    (first,) = batch.run(["a cube"], out, make).outcomes
    own = out / PLACE / key_of(first.job, make)
    own.mkdir()
    (out / str(first.bundle)).rename(own / str(first.bundle))
    (again,) = batch.run(["a cube"], out, make).outcomes
    assert (again.state, again.bundle) == ("there", first.bundle)
    assert bundles(out) == {first.bundle}
    assert made(log) == ["a cube 0"]

    (out / str(first.bundle) / "scene.json").unlink()  # a bundle that is gone is made again
    (third,) = batch.run(["a cube"], out, make).outcomes
    assert third.state == "made"
    assert bundle.verify(out / str(third.bundle)) == []


def test_what_is_asked_for_is_told_apart(tmp_path: Path, log: Path) -> None:
    make = ToyMaker(str(log))
    picture = tmp_path / "desk.png"
    picture.write_bytes(b"one")
    keys = {key_of(j, make) for j in (batch.Job("a"), batch.Job("b"), batch.Job("a", 1))}
    keys |= {key_of(batch.Job("a"), batch.Composing()), key_of(batch.Job(str(picture)), make)}
    picture.write_bytes(b"two")
    keys |= {key_of(batch.Job(str(picture)), make)}
    assert len(keys) == 6
    first = {"route": "generate", "backend": "embedded", "config": plain(Config())}
    assert batch.Generating().identity() == first  # what folders of batches were made with
    mixed = batch.Generating(Mix(modeler="folder"))
    assert key_of(batch.Job("a"), mixed) != key_of(batch.Job("a"), batch.Generating())
    cheap = batch.Generating(calls="here")
    assert key_of(batch.Job("a"), cheap) == key_of(batch.Job("a"), batch.Generating(calls="there"))


def test_prompts_are_read_from_lines_and_json(tmp_path: Path) -> None:
    lines, listed = tmp_path / "prompts.txt", tmp_path / "prompts.json"
    lines.write_text("# desks\na desk\n\n  a round desk  \n")
    assert batch.read_prompts(lines, 2) == [batch.Job("a desk", 2), batch.Job("a round desk", 2)]
    listed.write_text('["a desk", {"text": "a bench", "seed": 7, "theme": "workshop"}]')
    assert batch.read_prompts(listed) == [batch.Job("a desk"), batch.Job("a bench", 7)]


@pytest.mark.parametrize(
    ("content", "words"),
    [(None, "No such file"), ("{", "not valid JSON"), ("{}", "array"), ("[1]", "neither a string"),
     ('[{"text": 1}]', "must be a string"), ('[{"text": "a", "seed": -1}]', "A seed must")],
)  # fmt: skip
def test_prompts_that_are_none_are_refused(tmp_path: Path, content: str | None, words: str) -> None:
    path = tmp_path / "prompts.json"
    if content is not None:
        path.write_text(content)
    with pytest.raises(InputError, match=words):
        batch.read_prompts(path)


def test_bad_numbers_and_folders_are_refused(tmp_path: Path, log: Path) -> None:
    make = ToyMaker(str(log))
    with pytest.raises(InputError, match="workers"):
        batch.run(["a cube"], tmp_path, make, workers=0)
    with pytest.raises(InputError, match="1 to 100,000 scenes, got 0"):
        batch.run([], tmp_path, make)
    (tmp_path / "file").touch()
    with pytest.raises(StorageError, match="another folder"):
        batch.run(["a cube"], tmp_path / "file", make)
    assert made(log) == []


@pytest.mark.slow
def test_a_worker_computes_on_one_thread(
    tmp_path: Path, log: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Other workers run in parallel; users can override this as for BLAS and torch."""
    threads = log.with_name(f"{log.name}.threads")
    monkeypatch.delenv("OMP_NUM_THREADS", raising=False)
    batch.run(["wide cube"], tmp_path / "one", ToyMaker(str(log)), workers=2)
    assert threads.read_text() == "1"
    monkeypatch.setenv("OMP_NUM_THREADS", "3")
    batch.run(["wide cube"], tmp_path / "three", ToyMaker(str(log)), workers=2)
    assert threads.read_text() == "3"


def test_ray_makes_the_same_bytes(
    tmp_path: Path, log: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    pytest.importorskip("ray")
    path = os.pathsep.join([str(HERE), str(HERE.parent), *sys.path])
    monkeypatch.setenv("PYTHONPATH", path)  # what Ray's processes import from
    monkeypatch.delenv("RAY_USAGE_STATS_ENABLED", raising=False)
    monkeypatch.delenv("OMP_NUM_THREADS", raising=False)
    texts, out = ["wide cube", "bad words", "deadly one", "another cube"], tmp_path / "ray"
    with serving([Says()]) as server:
        make = ToyMaker(str(log), server.url, batch.shared_budget(out), 0.05)
        paid = ["paid one", "paid two"]
        summary = batch.run([*texts, *paid], out, make, workers=2, ray="local")
    assert [o.state for o in summary.outcomes[:4]] == ["made", "failed", "failed", "made"]
    assert [o.kind for o in summary.failures] == ["InputError", "Crash"]
    assert sorted(o.state for o in summary.outcomes[4:]) == ["made", "unpaid"]
    assert len(server.asked) == 1
    assert "RAY_USAGE_STATS_ENABLED" not in os.environ
    assert Path(f"{log}.threads").read_text() == "1"  # a processor each, as Ray gives it
    batch.run(["wide cube", "another cube"], tmp_path / "here", ToyMaker(str(log)))
    others = {o.bundle for o in summary.outcomes[4:]}
    assert bundles(out) - others == bundles(tmp_path / "here")


def test_the_maker_of_the_tests_is_found_by_processes() -> None:
    assert toy_maker.__name__ == ToyMaker.__module__ == "toy_maker"


def test_what_is_asked_for_twice_is_laid_out_once() -> None:
    again = [batch.Job("a mug", 3)] * 10_000
    assert len(batch.jobs_of(again, variants=10_000)) == 10_000
    assert len(batch.jobs_of([batch.Job("a", 0), batch.Job("a", 1)], variants=3)) == 4
    apart = [batch.Job("a", k) for k in (7, 0, 2)] + [batch.Job("b", 1)]
    asked = {("a", 0), ("a", 1), ("a", 2), ("a", 3), ("a", 7), ("a", 8), ("b", 1), ("b", 2)}
    assert {(job.text, job.seed) for job in batch.jobs_of(apart, variants=2)} == asked
    next_to_each_other = [batch.Job("a", k) for k in range(60_000)]
    assert len(batch.jobs_of(next_to_each_other, variants=40_000)) == 99_999
    with pytest.raises(InputError, match="got 100,001"):
        batch.jobs_of(next_to_each_other, variants=40_002)
    assert type(batch.jobs_of(["a"], seed=np.int64(3))[0].seed) is int


def test_huge_batches_are_refused_before_they_are_laid_out() -> None:
    texts = [f"{k} {'x' * 10_000}" for k in range(300)]
    with pytest.raises(InputError, match="1 to 100,000 scenes, got 30,000,000"):
        batch.jobs_of(texts, variants=100_000)
    for text in ("x" * 30_000, "\ud800"):
        with pytest.raises(InputError, match="A prompt"):
            batch.Job(text)
