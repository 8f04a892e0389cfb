"""Share of fresh tables with a valid task instance, drawn for the task and for no task.

    python benchmarks/fresh_tables.py --count 60 --workers 2

For each task ``count`` tables of every theme are drawn with the objects it needs (``Task.needs``),
like those of ``scenes="fresh"``, and as many for no particular task, at which all tasks are tried.
A table is valid for a task if the task's ``sample`` finds an instance that the expert's planners
can grasp, place and push. Rows are written to ``fresh_tables.csv`` as they finish (a second run
resumes), the summary to the corresponding ``.md``.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

import numpy as np
from posing import tables
from posing.tables import Row

from generator.errors import SceneError
from generator.language.distribution import SceneDistribution
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.scenes import FreshScenes
from tabletopgen_env.statistics import wilson
from tabletopgen_env.tasks.names import NAMES
from tabletopgen_env.tasks.registry import task_named
from tabletopgen_env.tasks.sequence import PRESETS
from tabletopgen_env.tasks.task import Task
from tabletopgen_env.world.world import World

HERE = Path(__file__).parent
TASKS = (*NAMES, *(f"Sequence:{preset}" for preset in PRESETS))
ANY = "any"
"""Value for a table that was drawn for no task."""

KEY = ("drawn_for", "seed", "task")
FIELDS = (*KEY, "rows", "offers", "things", "categories", "why")


class TableJob(NamedTuple):
    """One table: the task it is drawn for, its seed, and the tasks that are tried at it."""

    drawn_for: str
    seed: int
    tasks: tuple[str, ...]


def task_of(name: str) -> Task:
    """Return a task by its name, with its preset after a colon."""
    return task_named(*name.split(":"))


def work(job: TableJob) -> list[Row]:
    """Draw the table of a job and try its tasks."""
    needs = () if job.drawn_for == ANY else task_of(job.drawn_for).needs
    recipe = FreshScenes(SceneDistribution(needs=needs)).recipe(np.random.default_rng(job.seed))
    base = {"drawn_for": job.drawn_for, "seed": job.seed, "rows": len(job.tasks)}
    try:
        scene = recipe.make()
    except SceneError as error:
        lost = {"offers": 0, "things": 0, "categories": "", "why": tables.failure(error)}
        return [base | {"task": name} | lost for name in job.tasks]
    base |= {
        "things": len(scene.objects),
        "categories": " ".join(sorted({o.model.category for o in scene.objects})),
    }
    world = World(scene, Panda())
    return [base | {"task": name} | try_table(world, name, job.seed) for name in job.tasks]


def try_table(world: World, name: str, seed: int) -> Row:
    """Return whether a table is valid for a task, and the reason if not."""
    world.reset()
    try:
        task_of(name).sample(world, np.random.default_rng(seed))
    except SceneError as error:
        return {"offers": 0, "why": tables.failure(error)}
    return {"offers": 1, "why": ""}


def jobs(names: Sequence[str], count: int) -> list[TableJob]:
    """Return the tables for no task, then those for each task with needs."""
    drawn = [TableJob(ANY, seed, tuple(names)) for seed in range(count)]
    return drawn + [
        TableJob(name, seed, (name,))
        for name in names
        if task_of(name).needs
        for seed in range(count)
    ]


def summary(rows: Sequence[Row], names: Sequence[str], command: str) -> str:
    """Return the table as Markdown."""
    lines = [
        "# Tables drawn for a task",
        f"`{command}`, {tables.where()}",
        "",
        "Share of drawn tables with a valid task instance: those drawn for no particular task, "
        'and those that `scenes="fresh"` draws for the task. Tasks without needs have only the '
        "former. Interval: Wilson, 95 %. Categories: distinct ones among the latter.",
        "",
        "| task | for no task | for the task | interval | objects | categories |",
        "|---|---|---|---|---|---|",
        *(_line(name, rows) for name in names),
        "",
    ]
    return "\n".join(lines)


def _line(name: str, rows: Sequence[Row]) -> str:
    before = [r for r in rows if r["task"] == name and r["drawn_for"] == ANY]
    after = [r for r in rows if r["task"] == name and r["drawn_for"] == name] or before
    low, high = wilson(_offering(after), len(after))
    kinds = {word for r in after for word in str(r["categories"]).split()}
    things = np.mean([int(r["things"]) for r in after])
    return (
        f"| {name} | {_offering(before)} of {len(before)} | {_offering(after)} of {len(after)} "
        f"| {100 * low:.0f} to {100 * high:.0f} % | {things:.1f} | {len(kinds)} |"
    )


def _offering(rows: Sequence[Row]) -> int:
    return sum(int(r["offers"]) for r in rows)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--task", action="append", choices=TASKS, help="one task; may be repeated")
    parser.add_argument("--count", type=int, default=60, help="number of tables of each kind")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--out", type=Path, default=HERE / "results")
    args = parser.parse_args()
    names = tuple(args.task or TASKS)
    args.out.mkdir(parents=True, exist_ok=True)
    path = args.out / "fresh_tables.csv"
    asked = {(job.drawn_for, str(job.seed)): job for job in jobs(names, args.count)}
    rows = tables.complete(path, FIELDS, KEY, asked, work, args.workers, say, of="rows")
    text = summary(rows, names, tables.command_line("--workers", "--out"))
    path.with_suffix(".md").write_text(text, encoding="utf-8")
    print(text)


def say(rows: list[Row]) -> str:
    """Return the progress line of a table."""
    return f"for {rows[0]['drawn_for']}, seed {rows[0]['seed']}: {_offering(rows)} of {len(rows)}"


if __name__ == "__main__":
    main()
