"""Recording, evaluation and scene banks in one process, several processes, and a Ray cluster.

    python benchmarks/cluster.py --nodes 2

Records the expert's Reach at fresh tables, evaluates a shipped policy at others, and makes a scene
bank of fresh tables with their episodes: with one process, with ``--workers`` processes, and with
``--nodes`` on a Ray cluster of that many one-CPU nodes, which is started on this machine. Digests
of all outputs (the recording's files, the episodes' results, the bank's arrays) must be equal,
otherwise the exit code is 1. Times are wall-clock seconds, including startup of processes but not
of the cluster. Writes ``cluster.md``. ``--note`` is added to the table's head.
"""

from __future__ import annotations

import argparse
import contextlib
import hashlib
import logging
import os
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import fields
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from posing import tables

from generator.jobs.pools import PoolOptions

HERE = Path(__file__).parent
ROOT = HERE.parent

Work = Callable[[PoolOptions], str]


class ClusterRun(NamedTuple):
    """One measured task: its executor, duration, tasks per node, and the digest of its results."""

    work: str
    by: str
    seconds: float
    tasks: Sequence[int]
    digest: str


class _Tally(logging.Handler):
    """Counts the tasks of each node of a cluster, as reported by the pool."""

    def __init__(self) -> None:
        super().__init__(logging.INFO)
        self.counts: dict[str, int] = {}

    def emit(self, record: logging.LogRecord) -> None:
        count, node = record.args or (0, "")
        self.counts[str(node)] = self.counts.get(str(node), 0) + int(count)  # pyright: ignore


def record(episodes: int, pool: PoolOptions) -> str:
    """Record demonstrations and return the digest of the files."""
    from tabletopgen_env.recording import RecordConfig
    from tabletopgen_env.recording import record as run

    config = RecordConfig("Reach", scenes=("fresh",), episodes=episodes)
    with tempfile.TemporaryDirectory(prefix="tabletopgen-cluster-") as folder:
        path = run(config, Path(folder) / "reach", "npz", pool.workers, ray=pool.ray)
        return digest(part for p in sorted(path.iterdir()) for part in (p.name, p.read_bytes()))


def evaluate(episodes: int, pool: PoolOptions) -> str:
    """Evaluate a policy and return the digest of the results."""
    from tabletopgen_env.learning.evaluation import SEED, seeds
    from tabletopgen_env.learning.policies import load_policy
    from tabletopgen_env.learning.trial import PolicyTrial
    from tabletopgen_env.scenes.source import close

    policy = load_policy("reach-clone")
    trial = PolicyTrial(policy.card.task, policy.card.env, "fresh", policy)
    if pool != PoolOptions():
        return digest(map(repr, trial.play_apart(seeds(SEED, episodes), pool)))
    source = trial.source()
    try:
        return digest(map(repr, trial.play_here(seeds(SEED, episodes), source)))
    finally:
        close(source)


def make_bank(scenes: int, pool: PoolOptions) -> str:
    """Make a deck of fresh tables and return the digest of its bank and episodes."""
    from tabletopgen_env.parallel.batch.decks import DeckConfig, DeckPlan
    from tabletopgen_env.tasks.registry import task_named

    config = DeckConfig(scenes=scenes, episodes=2, workers=pool.workers, ray=pool.ray)
    made = DeckPlan("fresh", task_named("Lift"), {"randomization": "starts"}, 8, config).make(0)
    arrays = [array for _, array in sorted(made.bank.rows.items())]
    for one in (one for episodes in made.episodes for one in episodes):
        arrays += [one.arm, one.ctrl, one.poses, one.spot]
        arrays += [getattr(one.goals, field.name) for field in fields(one.goals)]
    told = (made.bank.scenes, made.bank.objects, made.bank.left_out, made.idle)
    return digest([repr(told), *(array.tobytes() for array in arrays)])


def digest(parts: Any) -> str:
    """Return the first 12 digits of the SHA-256 of texts and bytes."""
    found = hashlib.sha256()
    for part in parts:
        found.update(part.encode() if isinstance(part, str) else part)
    return found.hexdigest()[:12]


@contextlib.contextmanager
def start_cluster(nodes: int) -> Iterator[str]:
    """Start a Ray cluster of one-CPU nodes on this machine, and return its address."""
    from ray.cluster_utils import Cluster  # pyright: ignore[reportMissingImports]

    os.environ["RAY_USAGE_STATS_ENABLED"] = "0"
    os.environ["RAY_worker_niceness"] = "0"  # noqa: SIM112  # as of the processes compared with
    before = os.environ.get("PYTHONPATH")
    os.environ["PYTHONPATH"] = os.pathsep.join([str(ROOT), *([before] if before else [])])
    head = {"num_cpus": 1, "include_dashboard": False}
    cluster = Cluster(initialize_head=True, head_node_args=head)
    try:
        for _ in range(nodes - 1):
            cluster.add_node(num_cpus=1)
        cluster.wait_for_nodes(timeout=120)
        yield cluster.address
    finally:
        cluster.shutdown()


def measure(name: str, work: Work, by: str, pool: PoolOptions) -> ClusterRun:
    """Run a task and return its measurements."""
    tally, log = _Tally(), logging.getLogger("generator.jobs")
    log.addHandler(tally)
    log.setLevel(logging.INFO)
    start = time.perf_counter()
    try:
        made = work(pool)
    finally:
        log.removeHandler(tally)
    seconds = time.perf_counter() - start
    run = ClusterRun(name, by, seconds, sorted(tally.counts.values(), reverse=True), made)
    print(run, flush=True)
    return run


def table(runs: Sequence[ClusterRun], head: str) -> str:
    """Return the runs as Markdown, each compared with the first of its task."""
    first = {r.work: r for r in reversed(runs)}
    rows = [
        f"| {r.work} | {r.by} | {r.seconds:.1f} | {' + '.join(map(str, r.tasks)) or '–'} | "
        f"`{r.digest}` | {'yes' if r.digest == first[r.work].digest else 'NO'} |"
        for r in runs
    ]
    titles = "| task | by | seconds | tasks per node | digest | same |"
    return "\n".join([head, "", titles, "|---|---|---|---|---|---|", *rows, ""])


def main() -> int:
    """Run all tasks with all executors, print and write the table; return 1 if results differ."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--episodes", type=int, default=24)
    parser.add_argument("--scenes", type=int, default=12)
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--nodes", type=int, default=0, help="nodes of a Ray cluster; 0 for none")
    parser.add_argument("--out", type=Path, default=HERE / "results")
    parser.add_argument("--note", default="")
    args = parser.parse_args()
    tables.alone()

    works: dict[str, Work] = {
        f"record Reach, {args.episodes} episodes": partial(record, args.episodes),
        f"evaluate reach-clone, {args.episodes} episodes": partial(evaluate, args.episodes),
        f"scene bank, {args.scenes} fresh tables": partial(make_bank, args.scenes),
    }
    several = (f"{args.workers} processes", PoolOptions(args.workers))
    runs: list[ClusterRun] = []
    with contextlib.ExitStack() as running:
        pools = [("one process", PoolOptions()), several]
        if args.nodes:
            address = running.enter_context(start_cluster(args.nodes))
            pools.append((f"Ray, {args.nodes} nodes", PoolOptions(args.nodes, address)))
        for name, work in works.items():
            runs += [measure(name, work, by, pool) for by, pool in pools]
    head = f"`{tables.command_line('--out', '--note')}`, {tables.where()}. {args.note}".rstrip()
    text = table(runs, head)
    args.out.mkdir(parents=True, exist_ok=True)
    (args.out / "cluster.md").write_text(text, encoding="utf-8")
    print(text)
    return 0 if all(" | NO |" not in line for line in text.splitlines()) else 1


if __name__ == "__main__":
    raise SystemExit(main())
