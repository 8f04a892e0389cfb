"""Recording, evaluating, certifying and scene banks: one process, several, or a cluster."""

import json
import os
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from bounded import LONG, running, until
from ray_cluster import two_nodes

from assets_cache import find
from generator.errors import SceneError
from generator.jobs.pools import PoolOptions
from tabletopgen_env.certificates.certificate import FILE, Terms
from tabletopgen_env.certificates.certify import certify
from tabletopgen_env.learning.evaluation import seeds
from tabletopgen_env.learning.policies import load_policy
from tabletopgen_env.learning.trial import PolicyTrial
from tabletopgen_env.parallel.batch.decks import Deck, DeckConfig, DeckPlan
from tabletopgen_env.parallel.core.goal_rows import GoalRows
from tabletopgen_env.recording import RecordConfig, record
from tabletopgen_env.tasks.registry import task_named

pytestmark = pytest.mark.slow

HERE = Path(__file__).parent
RECORDED = RecordConfig("Reach", scenes=("fresh",), episodes=4, seed=4)


@pytest.fixture(scope="module")
def cluster() -> Iterator[str]:
    with two_nodes(HERE) as address:
        yield address


@pytest.fixture(params=["processes", "Ray"])
def others(request: pytest.FixtureRequest) -> PoolOptions:
    """Two workers outside this process."""
    return PoolOptions(2, request.getfixturevalue("cluster") if request.param == "Ray" else None)


def files(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.fixture(scope="module")
def recorded(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    return arrays(record(RECORDED, tmp_path_factory.mktemp("one") / "reach", "npz"))


def arrays(folder: Path) -> dict[str, Any]:
    """Return every array and fact of a recording, by file and name."""
    found: dict[str, Any] = {"facts": json.loads((folder / "dataset.json").read_text())["episodes"]}
    for path in folder.glob("*.npz"):
        episode = np.load(path)
        found |= {f"{path.name}/{name}": episode[name].tobytes() for name in episode}
    return found


def test_a_recording_is_the_same(
    others: PoolOptions, recorded: dict[str, Any], tmp_path: Path
) -> None:
    path = record(RECORDED, tmp_path / "reach", "npz", others.workers, ray=others.ray)
    assert arrays(path) == recorded
    assert len({facts["digest"] for facts in recorded["facts"]}) == 4, "each at its own table"


def test_an_evaluation_is_the_same(others: PoolOptions) -> None:
    policy = load_policy("reach-clone")
    trial = PolicyTrial(policy.card.task, policy.card.env, "fresh", policy)
    alone = list(trial.play_here(seeds(5, 4), trial.source()))
    assert list(trial.play_apart(seeds(5, 4), others)) == alone
    assert len({result.table for result in alone}) == 4


def test_the_commands_say_the_same(others: PoolOptions, shell: Any) -> None:
    given = ("enjoy", "reach-clone", "--scenes", "starter:held_out", "--episodes", "3")
    spread = ["--workers", "2", *(["--ray", others.ray] if others.ray else [])]
    assert shell(*given, *spread).out == shell(*given).out


def test_a_certificate_is_the_same(others: PoolOptions, tmp_path: Path) -> None:
    terms = Terms(("Reach", "Lift"), 2, 1, 0)
    made = []
    for name, pool in (("one", PoolOptions()), ("more", others)):
        bundle = Path(shutil.copytree(find("coffee-square")[0], tmp_path / name))
        certify(bundle, terms, pool.workers, pool.ray)
        made.append((bundle / FILE).read_bytes())
    assert made[0] == made[1]


def deck(pool: PoolOptions) -> Deck:
    config = DeckConfig(scenes=3, episodes=2, seed=3, workers=pool.workers, ray=pool.ray)
    plan = DeckPlan("fresh", task_named("Lift"), {"randomization": "starts"}, 8, config)
    return plan.make(config.seed)


@pytest.fixture(scope="module")
def drawn() -> Deck:
    return deck(PoolOptions())


def test_a_scene_bank_is_the_same(others: PoolOptions, drawn: Deck) -> None:
    made = deck(others)
    assert made.bank.scenes == drawn.bank.scenes and made.bank.objects == drawn.bank.objects
    assert made.bank.left_out == drawn.bank.left_out and made.idle == drawn.idle
    for name, rows in drawn.bank.rows.items():
        assert made.bank.rows[name].tobytes() == rows.tobytes(), name
    assert [facts(one) for one in made.episodes] == [facts(one) for one in drawn.episodes]


def facts(episodes: list[Any]) -> list[Any]:
    """Return the facts that identify drawn episodes, bit for bit."""
    return [
        (e.seed, e.instruction, e.names, e.arm.tobytes(), e.ctrl.tobytes(), e.poses.tobytes(),
         e.spot.tobytes(), *(getattr(e.goals, f.name).tobytes() for f in fields(GoalRows)))
        for e in episodes
    ]  # fmt: skip


@dataclass(frozen=True)
class DeadlyElsewhere(RecordConfig):
    """Kills any process except the one for which it was created."""

    owner: int = 0

    def environment(self) -> Any:
        if os.getpid() != self.owner:
            os._exit(9)
        return super().environment()


def test_a_worker_that_dies_leaves_nothing_behind(others: PoolOptions, tmp_path: Path) -> None:
    config = DeadlyElsewhere("Reach", scenes=("vanity",), owner=os.getpid())
    with pytest.raises(SceneError, match="ended abruptly"):
        record(config, tmp_path / "reach", "npz", others.workers, ray=others.ray)
    assert list(tmp_path.iterdir()) == []


def test_an_interrupt_leaves_nothing_behind(others: PoolOptions, tmp_path: Path) -> None:
    words = ["--task", "Reach", "--episodes", "10000", "--format", "npz", "--workers", "2"]
    if others.ray:
        words += ["--ray", others.ray]
    command = [sys.executable, "-m", "generator", "record", *words, "--out", tmp_path / "reach"]
    with running(*command, stderr=subprocess.PIPE, cwd=HERE.parent.parent) as process:
        until(lambda: list(tmp_path.glob(".*/reach/*.npz")))
        process.send_signal(signal.SIGINT)
        assert process.wait(LONG) == 130
    assert list(tmp_path.iterdir()) == []


def test_the_cluster_is_free_again_afterwards(cluster: str, tmp_path: Path) -> None:
    start = time.monotonic()
    config = RecordConfig("Reach", scenes=("vanity",), episodes=2)
    record(config, tmp_path / "reach", "npz", 2, ray=cluster)
    assert time.monotonic() - start < LONG
