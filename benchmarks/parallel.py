"""What asking about all things at once is worth: one scene of six things, a pool of one against 8.

    python benchmarks/parallel.py --delay 1

Makes the scene of ``tests/mixing`` by ``cloud``, ``huggingface`` and ``hunyuan3d``: the servers are
the tests' own, in a process of their own, and take ``--delay`` seconds for each answer; the models
on this machine are tiny. Takes the time, by the clock, of the three things that are asked about
each of the six and the table (completing, modelling, reviewing the orientation), what is computed
here between the answers included, and of the whole. Writes ``results/parallel.md``. ``--note`` is
added to the table's head, for instance that the machine was not idle.
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from multiprocessing.connection import Connection
from pathlib import Path
from typing import Any, NamedTuple, TypeVar

from posing import tables

from generator.running import Session

HERE = Path(__file__).parent
TESTS = HERE.parent / "tests"
sys.path[:0] = [str(TESTS), str(TESTS / "mixing")]

STEPS = ("completing", "modelling", "reviewing")
"""In the order in which the pipeline asks for them."""

REST = (
    "The rest goes on one after another, as each step needs the one before: the plan, the drawing, "
    "the list of things, segmenting (here), the view, the sizes, rotations (here), the top view "
    "and its check, what stands on what, and refinement and assembly (here)."
)

T = TypeVar("T")
R = TypeVar("R")


class Timed(Session):
    """A session that takes the time of each question asked about many things."""

    def __init__(self, workers: int) -> None:
        super().__init__(workers=workers)
        self.seconds: list[float] = []

    def each(self, work: Callable[[T], R], items: Sequence[T]) -> list[R]:
        """Ask as any session does; see ``Session.each``."""
        begin = time.perf_counter()
        done = super().each(work, items)
        self.seconds.append(time.perf_counter() - begin)
        return done


class Row(NamedTuple):
    """One scene: the pool, the seconds of each step of ``STEPS``, and of the whole."""

    workers: int
    steps: tuple[float, ...]
    whole: float

    @property
    def asked(self) -> float:
        """Seconds of completing and modelling."""
        return self.steps[0] + self.steps[1]


def serve(delay: float, models: Path, told: Connection) -> None:
    """Run the servers until the other end is closed; tell the environment that leads to them."""
    import mix_servers  # pyright: ignore[reportMissingImports]

    with mix_servers.running(mix_servers.Watch(delay)) as servers:
        told.send(servers.environment(models))
        told.poll(None)


@contextmanager
def served(delay: float, models: Path) -> Iterator[dict[str, str]]:
    """Serve in another process."""
    spawn = multiprocessing.get_context("spawn")
    here, there = spawn.Pipe()
    process = spawn.Process(target=serve, args=(delay, models, there), daemon=True)
    process.start()
    try:
        yield here.recv()
    finally:
        here.send(None)
        process.join()


def made(workers: int) -> Row:
    """Make the scene with a pool of some size, keeping no answers."""
    import mix_driver  # pyright: ignore[reportMissingImports]

    session = Timed(workers)
    begin = time.perf_counter()
    scene: Any = mix_driver.scene(session).scene
    whole = time.perf_counter() - begin
    assert len(scene.objects) == 6 and len(session.seconds) == len(STEPS)
    return Row(workers, tuple(session.seconds), whole)


def table(rows: Sequence[Row], head: str) -> str:
    """Return the rows as Markdown, and the last one's share of the first."""
    titles = ("pool", *STEPS, "completing + modelling", "whole scene")
    lines = [(str(r.workers), *(f"{s:.1f}" for s in (*r.steps, r.asked, r.whole))) for r in rows]
    one, many = rows[0], rows[-1]
    pairs = zip((*many.steps, many.asked, many.whole), (*one.steps, one.asked, one.whole),
                strict=True)  # fmt: skip
    lines.append(("share", *(f"{a / b:.2f}" for a, b in pairs)))
    body = [f"| {' | '.join(line)} |" for line in (titles, ["---"] * len(titles), *lines)]
    return "\n".join([head, "", *body, "", REST, ""])


def main() -> int:
    """Make the scene with each pool, print and write the table; 1 if the share is above 1/3."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--delay", type=float, default=1.0, help="seconds of each answer")
    parser.add_argument("--workers", type=int, default=8)
    parser.add_argument("--out", type=Path, default=HERE / "results")
    parser.add_argument("--note", default="")
    args = parser.parse_args()

    tables.alone()
    import fitted_models  # pyright: ignore[reportMissingImports]
    import laid_table  # pyright: ignore[reportMissingImports]

    with tempfile.TemporaryDirectory(prefix="tabletopgen-parallel-") as folder:
        models = fitted_models.save(Path(folder), laid_table.examples())
        with served(args.delay, models) as environment:
            os.environ.update(environment)
            made(args.workers)  # so that what is read once is read
            rows = [made(1), made(args.workers)]
    head = (
        f"Seconds for one scene of six things and a table, {args.delay:g} s an answer.\n"
        f"`{tables.command_line('--out', '--note')}`, {tables.where()}. {args.note}"
    ).rstrip()
    text = table(rows, head)
    args.out.mkdir(parents=True, exist_ok=True)
    (args.out / "parallel.md").write_text(text, encoding="utf-8")
    print(text)
    return 0 if rows[1].asked <= rows[0].asked / 3 else 1


if __name__ == "__main__":
    raise SystemExit(main())
