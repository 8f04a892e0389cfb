"""A whole scene of six things by ``cloud``, ``huggingface`` and ``hunyuan3d``, killed and resumed.

The servers live in this process, the scene is made by another, which ends by SIGKILL at random
points of its calls: as one comes in, or shortly after one was answered. What is promised:

- an answer that is kept is never asked for again, however often the process is killed;
- an answer is kept before anything that builds on it is asked;
- so what is asked twice was under way at a kill, or had just been answered: Hunyuan3D's
  ``/generate``, and the questions of OpenAI's protocol, are no jobs that could be looked after;
- the scene is the same to the byte.
"""

import base64
import json
import os
import queue
import random
import signal
import subprocess
import sys
import threading
from collections import Counter
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any
from urllib.parse import quote

import fitted_models
import laid_table
import mix_driver
import mix_servers
import pytest
from extent import count
from laid_table import THINGS
from mix_servers import KEY, Asked, Servers, Watch

from generator import bundle
from generator.calls.money.ledger import LEDGER
from generator.calls.store import CallStore

SEED = 7
KILLS = count(5, 2)
TIMES = {
    "plan_scene": 1, "draw": 1, "list_objects": 1, "complete": 7, "estimate_view": 1,
    "estimate_sizes": 1, "model": 7, "review_orientation": 7, "top_view": 1, "check_top_view": 1,
    "stacking_order": 1,
}  # fmt: skip
"""How often each question is asked for one table and six things; all of one before the next."""

EACH = ("complete", "model", "review_orientation")
TESTS = Path(__file__).parents[1]

LONG = 600.0
"""Seconds after which a run is taken to hang; it takes some 20 of CPU."""

Process = subprocess.Popen[bytes]


@dataclass(frozen=True)
class Run:
    """One process: its exit, its output, and its requests to the servers."""

    code: int
    told: str
    asked: tuple[Asked, ...]


@dataclass(frozen=True)
class Point:
    """A time to kill: at the ``number``-th call, or ``after`` seconds from its response."""

    number: int
    after: float | None


@dataclass(frozen=True)
class Place:
    """Output folders of a run: the bundles, and the response cache."""

    folder: Path
    servers: Servers
    models: Path

    @property
    def out(self) -> Path:
        return self.folder / "scenes"

    @property
    def calls(self) -> Path:
        return self.folder / "calls"

    def run(self, key: str = KEY, started: Callable[[Process], None] = lambda process: None) -> Run:
        """Run the driver to its end; ``started`` receives its process."""
        self.folder.mkdir(parents=True, exist_ok=True)
        before = threading.enumerate()
        log = self.folder / f"told_{len(list(self.folder.glob('told_*')))}.txt"
        first = len(self.servers.watch.asked)
        path = [str(TESTS.parent), *(str(TESTS / p) for p in ("", "mixing"))]
        known = {k: v for k, v in os.environ.items() if not k.endswith("_API_KEY")}
        given = {**self.servers.environment(self.models, key), "PYTHONPATH": os.pathsep.join(path)}
        with log.open("w") as told:
            process = subprocess.Popen(
                [sys.executable, mix_driver.__file__, self.out, self.calls, "8"],
                env={**known, "OMP_NUM_THREADS": "1", **given}, stdout=told, stderr=told,
            )  # fmt: skip
            started(process)
            try:
                code = process.wait(LONG)
            finally:
                process.kill()
        mix_servers.drain(before)
        return Run(code, log.read_text(), tuple(self.servers.watch.asked[first:]))

    def killed(self, point: Point, before: int) -> Run:
        """Run until a point among the calls after the ``before``-th, and kill the process there."""
        watch, processes = self.servers.watch, queue.Queue[Process]()

        def kill() -> None:
            process = processes.get(timeout=60)
            process.kill()
            processes.put(process)  # another call may come in while it dies

        def reached(calls: list[Asked]) -> bool:
            return len({a.key for a in calls}) >= point.number

        def came(asked: Asked) -> None:
            if point.after is None and reached(watch.asked[before:]):
                kill()

        def gone(asked: Asked) -> None:
            answered = [a for a in watch.asked[before:] if a.ended is not None]
            if point.after is not None and reached(answered):
                threading.Timer(point.after, kill).start()

        watch.came, watch.gone = came, gone
        try:
            return self.run(started=processes.put)
        finally:
            watch.came = watch.gone = lambda asked: None

    def kept(self) -> set[bytes]:
        """Return the cached responses, all of them complete."""
        store = CallStore(self.calls)
        answers = [store.get(p.name) for p in self.answers() if not p.name.startswith(".")]
        assert all(answers)
        return {a.body for a in answers if a is not None}

    def answers(self) -> list[Path]:
        return [p for p in (self.calls / "answers").glob("*/*") if p.is_file()]


@pytest.fixture(scope="module")
def servers(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Servers]:
    with mix_servers.running(Watch()) as made:
        yield made


@pytest.fixture(scope="module")
def models(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return fitted_models.save(tmp_path_factory.mktemp("models"), laid_table.examples())


def points(seed: int) -> list[Point]:
    """Draw the points of kills: from all calls, at least one of each kind."""
    rng = random.Random(seed)
    numbers = sorted(rng.sample(range(1, sum(TIMES.values()) + 1), KILLS))
    kinds = [None, rng.uniform(0, 0.3), *(rng.choice([None, 0.2]) for _ in range(KILLS - 2))]
    rng.shuffle(kinds)
    return [Point(n, kind) for n, kind in zip(numbers, kinds, strict=True)]


def together() -> Callable[[Asked], None]:
    """Return a callback that holds all responses until all requests of one kind have arrived."""
    gates = {question: threading.Barrier(TIMES[question]) for question in EACH}

    def wait(asked: Asked) -> None:
        if asked.question in gates:
            gates[asked.question].wait(LONG)

    return wait


def files(bundle_path: Path) -> dict[str, bytes]:
    """Return the content of a bundle; its ledger covers one run."""
    return {
        str(p.relative_to(bundle_path)): p.read_bytes()
        for p in bundle_path.rglob("*")
        if p.is_file() and p.name != LEDGER
    }


def holding(key: str, folder: Path) -> list[Path]:
    """Return the files in a folder that contain a key, plain or in a common encoding."""
    forms = {key, quote(key, safe=""), base64.b64encode(key.encode()).decode()}
    found = [p for p in folder.rglob("*") if p.is_file()]
    return [p for p in found if any(f.encode() in p.read_bytes() for f in forms)]


@pytest.mark.slow
@pytest.mark.timeout(2 * LONG)
def test_a_scene_killed_at_random_is_the_scene_never_killed(
    servers: Servers, models: Path, tmp_path: Path
) -> None:
    watch, calm = servers.watch, Place(tmp_path / "calm", servers, models)
    watch.came = together()
    whole = calm.run()
    watch.came = lambda asked: None
    path = check_whole(calm, whole, watch)

    shaken, first = Place(tmp_path / "shaken", servers, models), len(watch.asked)
    settled: set[str] = set()
    for point in points(SEED):
        run = shaken.killed(point, first)
        assert run.code == -signal.SIGKILL, run.told[-4000:]
        settled = check_killed(shaken, settled, run, watch.asked[first:])
    last = shaken.run()
    assert last.code == 0, last.told[-4000:]
    assert not settled & {a.key for a in last.asked}
    everything = watch.asked[first:]
    assert {a.key for a in everything} == {a.key for a in whole.asked}
    assert len(everything) - len(whole.asked) <= KILLS * max(TIMES.values()), "one pool a kill"

    (again,) = shaken.out.iterdir()
    assert again.name == path.name
    assert files(again) == files(path)
    check_ledgers(path, again, len(settled), last)
    assert len(shaken.kept()) == sum(TIMES.values()) == len(shaken.answers()), "half-written"
    assert "chat/completions" in whole.told, "what is searched for the key has the calls"
    assert holding(KEY, tmp_path) == []


def check_whole(place: Place, run: Run, watch: Watch) -> Path:
    """Check the result of an uninterrupted run; return its bundle."""
    assert run.code == 0, run.told[-4000:]
    assert Counter(a.question for a in run.asked) == TIMES
    assert {question: watch.peak(question) for question in EACH} == dict.fromkeys(EACH, 7)
    (path,) = place.out.iterdir()
    assert bundle.verify(path) == []
    scene = bundle.load(path)
    assert sorted(o.label for o in scene.objects) == sorted(THINGS)
    assert scene.report is not None and scene.report.passed
    assert all("plan" in warning for warning in scene.provenance.warnings)
    return path


def check_killed(place: Place, settled: set[str], run: Run, everything: list[Asked]) -> set[str]:
    """Check the guarantees for a killed run; return the questions with cached answers.

    ``settled`` are those that were kept before it, ``everything`` is what was asked until now.
    """
    assert not place.out.exists() or list(place.out.iterdir()) == []
    assert not settled & {a.key for a in run.asked}, "asked again, though it was kept"
    kept = place.kept()
    now = {a.key for a in everything if a.answer in kept}
    assert len(now) == len(kept) and settled <= now
    order = list(TIMES)
    latest = max((order.index(a.question) for a in run.asked), default=0)
    earlier = {a.key for a in everything if order.index(a.question) < latest}
    assert earlier <= now, "lost, though more was asked that builds on it"
    return now


def check_ledgers(calm: Path, shaken: Path, cached: int, last: Run) -> None:
    """Compare the ledger of the last run with that of an uninterrupted run."""
    usual, resumed = (json.loads((p / LEDGER).read_text()) for p in (calm, shaken))

    def asked(ledger: dict[str, Any], *outcomes: str) -> Counter[tuple[str, str]]:
        told = [c for c in ledger["calls"] if c["outcome"] in outcomes]
        return Counter((c["question"], c["model"]) for c in told)

    assert asked(usual, "answered") == asked(resumed, "answered", "cached")
    assert asked(usual, "answered").total() == len(usual["calls"]) == sum(TIMES.values())
    assert asked(resumed, "cached").total() == cached
    assert asked(resumed, "answered").total() == len(last.asked)
    spent = {"draw": 0.5, "complete": 0.5, "top_view": 0.5, "model": 0.0}
    for ledger, questions in (
        (usual, [*Counter(TIMES).elements()]),
        (resumed, [a.question for a in last.asked]),
    ):
        assert ledger["money"] == pytest.approx(sum(spent.get(q, 0.0003) for q in questions))


@pytest.mark.slow
def test_a_wrong_key_is_told_without_it(servers: Servers, models: Path, tmp_path: Path) -> None:
    wrong = "another-key-0badc0de99"
    place = Place(tmp_path, servers, models)
    run = place.run(key=wrong)
    assert run.code == 1
    assert "BackendError" in run.told and "Check the key in TABLETOPGEN_CLOUD_KEY" in run.told
    assert holding(wrong, tmp_path) == []


@pytest.mark.parametrize("form", [str, lambda key: base64.b64encode(key.encode()).decode()])
def test_the_search_can_fail(tmp_path: Path, form: Callable[[str], str]) -> None:
    (tmp_path / "calls").mkdir()
    (tmp_path / "calls/answer").write_bytes(b"\x89PNG\0" + form(KEY).encode() + b"\0")
    (tmp_path / "other").write_text("sound")
    assert holding(KEY, tmp_path) == [tmp_path / "calls/answer"]
