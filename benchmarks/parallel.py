"""Speedup from parallel queries: one scene of six objects, with a pool of one and a pool of 8.

    python benchmarks/parallel.py --delay 1

Makes the scene of ``tests/mixing`` with ``cloud``, ``huggingface`` and ``hunyuan3d``: the servers
are the tests' own, in a separate process, and take ``--delay`` seconds for each answer; the local
models are tiny. Measures the wall-clock time of the three queries that are made for each of the six
objects and the table (completion, modelling, review of the orientation), including local
computation, and of the whole scene. Exits with 1 if completion and modelling take more than a third
of the sequential time. Writes ``results/parallel.md``. ``--note`` is added to the table's head, for
instance if the machine was not idle.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from posing import tables

from generator.calls import Session

HERE = Path(__file__).parent
LONG = 600.0
"""Seconds after which the servers' process counts as hanging."""
TESTS = HERE.parent / "tests"
sys.path[:0] = [str(TESTS), str(TESTS / "mixing")]

STEPS = {
    "completing": "complete",
    "modelling": "model",
    "reviewing the orientation": "review_orientation",
}
"""The queries made for each object, in the pipeline's order."""

REST = (
    "Objects are the six and the table. The other steps are sequential, since each needs the one "
    "before: the plan, the drawing, the list of objects, segmentation (local), the view, the "
    "sizes, rotations (local), the top view and its check, the stacking, and refinement and "
    "assembly (local)."
)

T = TypeVar("T")
R = TypeVar("R")


class Timed(Session):
    """A session that measures the time of each query about many objects."""

    def __init__(self, workers: int) -> None:
        super().__init__(workers=workers)
        self.seconds: list[float] = []

    def each(self, work: Callable[[T], R], items: Sequence[T]) -> list[R]:
        """Query like any session; see ``Session.each``."""
        begin = time.perf_counter()
        done = super().each(work, items)
        self.seconds.append(time.perf_counter() - begin)
        return done


class ParallelRow(NamedTuple):
    """One scene: seconds of each step of ``STEPS``, those with an active server, and the total."""

    steps: tuple[float, ...]
    served: tuple[float, ...]
    whole: float

    def lines(self) -> dict[str, float]:
        """Return the seconds by their names in the table."""
        found = dict(zip(STEPS, self.steps, strict=True))
        return {
            **found,
            "completing and modelling": sum(self.steps[:2]),
            "the same, while a server was at work": sum(self.served[:2]),
            "whole scene": self.whole,
        }


def at_work(calls: Sequence[tuple[str, float, float]], question: str) -> float:
    """Return the seconds in which at least one call of a kind was active."""
    total, until = 0.0, float("-inf")
    for began, ended in sorted((b, e) for name, b, e in calls if name == question):
        total += max(0.0, ended - max(began, until))
        until = max(until, ended)
    return total


def serve(delay: float, models: Path, sender: Connection) -> None:
    """Run the servers; send their environment variables, and on request the queries received."""
    import mix_servers  # pyright: ignore[reportMissingImports]

    watch = mix_servers.Watch(delay)
    with mix_servers.running(watch) as servers:
        sender.send(servers.environment(models))
        while sender.recv():
            sender.send([(a.question, a.began, a.ended) for a in watch.asked])
            watch.asked.clear()


@contextmanager
def start_servers(delay: float, models: Path) -> Iterator[Connection]:
    """Serve in another process; set the environment variables for it."""
    spawn = multiprocessing.get_context("spawn")
    here, there = spawn.Pipe()
    process = spawn.Process(target=serve, args=(delay, models, there), daemon=True)
    process.start()
    there.close()  # so that its exit is noticed here
    try:
        os.environ.update(receive(here))
        yield here
    finally:
        with suppress(OSError):  # it has exited
            here.send(False)
        process.join(LONG)
        process.kill()


def receive(servers: Connection) -> Any:
    """Return the next message of the servers' process.

    Raises:
        SystemExit: the process has exited, or hangs.
    """
    try:
        if servers.poll(LONG):
            return servers.recv()
    except EOFError:
        raise SystemExit("The servers' process has exited.") from None
    raise SystemExit(f"The servers' process sent nothing for {LONG:g} s.")


def make_scene(workers: int, servers: Connection) -> ParallelRow:
    """Make the scene with a pool of a given size, without caching answers."""
    import mix_driver  # pyright: ignore[reportMissingImports]

    session = Timed(workers)
    begin = time.perf_counter()
    scene: Any = mix_driver.scene(session).scene
    whole = time.perf_counter() - begin
    assert len(scene.objects) == 6 and len(session.seconds) == len(STEPS)
    servers.send(True)
    calls = receive(servers)
    return ParallelRow(
        tuple(session.seconds), tuple(at_work(calls, q) for q in STEPS.values()), whole
    )


def table(one: ParallelRow, many: ParallelRow, workers: int, head: str) -> str:
    """Return both runs as Markdown, and the second as a share of the first."""
    pairs = [(name, a, many.lines()[name]) for name, a in one.lines().items()]
    lines = [f"| {name} | {a:.1f} | {b:.1f} | {b / a:.2f} |" for name, a, b in pairs]
    titles = [f"| seconds | pool of 1 | pool of {workers} | share |", "|---|---|---|---|"]
    return "\n".join([head, "", *titles, *lines, "", REST, ""])


def main() -> int:
    """Make the scene with each pool and write the table; return 1 if the share is above 1/3."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--delay", type=float, default=1.0, help="seconds per answer")
    parser.add_argument("--workers", type=int, default=8)
    parser.add_argument("--out", type=Path, default=HERE / "results")
    parser.add_argument("--note", default="")
    args = parser.parse_args()

    tables.alone()
    import fitted_models  # pyright: ignore[reportMissingImports]
    import laid_table  # pyright: ignore[reportMissingImports]

    with tempfile.TemporaryDirectory(prefix="tabletopgen-parallel-") as folder:
        models = fitted_models.save(Path(folder), laid_table.examples())
        with start_servers(args.delay, models) as servers:
            make_scene(args.workers, servers)  # warm-up
            one, many = make_scene(1, servers), make_scene(args.workers, servers)
    head = (
        f"Seconds for one scene of six things and a table, {args.delay:g} s an answer.\n"
        f"`{tables.command_line('--out', '--note')}`, {tables.where()}. {args.note}"
    ).rstrip()
    text = table(one, many, args.workers, head)
    args.out.mkdir(parents=True, exist_ok=True)
    (args.out / "parallel.md").write_text(text, encoding="utf-8")
    print(text)
    return 0 if sum(many.steps[:2]) <= sum(one.steps[:2]) / 3 else 1


if __name__ == "__main__":
    raise SystemExit(main())
