"""The scripted expert over scenes and tasks: success rates, and failures by phase and category.

    python benchmarks/expert.py --scenes composed --count 40 --workers 2
    python benchmarks/expert.py --scenes composed --held-out --task Push --task Stack
    python benchmarks/expert.py --scenes starter --episodes 24

Episodes start perturbed, like those of certificates (``randomization="starts"``), since scene,
target, goal and start determine everything else. An episode is a success once ``info["success"]``
has held for ``HOLD`` steps within the time limit of the task's id. ``--scenes composed`` composes
scenes from the texts of ``texts.json`` and ``table78.json``: every second text with seeds from 0
for development, the others with seeds from ``HELD_OUT`` for ``--held-out``, or from ``--seed``.
Tidy and the presets of Sequence (``Sequence:kitchen``), which need certain objects, have tables
from texts of their own, ``OWN``, in turn. Scenes without a valid task have a row without a success.
Rows are written to ``expert_<which>.csv`` as they finish (a second run resumes), the summary to the
corresponding ``.md``.
"""

from __future__ import annotations

import argparse
import hashlib
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

import gymnasium as gym
from posing import tables
from posing.tables import Row

import assets_cache
from generator.bundle import load
from generator.composition import compose
from generator.errors import SceneError, TabletopError
from generator.scene import Scene
from tabletopgen_env.env import TabletopEnv
from tabletopgen_env.episodes import HOLD, Held
from tabletopgen_env.expert.run import TaskExpert
from tabletopgen_env.statistics import wilson
from tabletopgen_env.tasks.names import NAMES

HERE = Path(__file__).parent
KEY = ("task", "scene", "seed", "episode")
FIELDS = (
    *KEY, "rows", "start", "success", "steps", "attempts", "phase", "goals", "target", "category",
    "goal", "instruction", "phases", "error",
)  # fmt: skip
INSTANCE = ("scene", "seed", "target", "goals", "goal", "instruction")
"""Columns that identify a task instance; its episodes differ only in their start."""

HELD_OUT = 3000
"""First seed of the scenes that were not used in development."""

PRESETS = ("Sequence:kitchen", "Sequence:coffee_table")

OWN = {
    "Sequence:kitchen": (
        "A wooden kitchen table with a large bowl, a wide cutting board, a small cucumber, a "
        "carrot and a salt shaker",
    ),
    "Sequence:coffee_table": ("A round coffee table with a cup, an apple and a book",),
    "Tidy": (
        "A wooden table with a tray, a die, an egg, a lipstick and a toy block",
        "An office desk with a desk tray, a marker, a glue stick, a die and a mug",
        "A kitchen table with a large tray, two eggs, a lime and a salt shaker",
        "A workbench with a large tray, a tape measure, a glue stick and two toy blocks",
        "A vanity table with a tray, a lipstick, a cream jar and a bottle of nail polish",
        "A round coffee table with a basket, a lime, an egg and a chess piece",
        "A dining table with a tray, a salt shaker, a pepper shaker, an egg and a tumbler",
    ),
}
"""Texts of tables with the objects that a task needs, which other texts rarely have."""

TASKS = (*NAMES, *PRESETS)


class EpisodesJob(NamedTuple):
    """Episodes of one task at one table; ``text`` is a text to compose or a bundle's path."""

    task: str
    text: str
    seed: int
    episodes: int


def work(job: EpisodesJob, composed: bool) -> list[Row]:
    """Run the episodes of a job; failures to run are also rows."""
    base: Row = dict.fromkeys(FIELDS, "")
    base |= {"task": job.task, "scene": _name(job.text), "seed": job.seed}
    rows: list[Row] = []
    try:
        scene = compose(job.text, job.seed) if composed else load(Path(job.text))
        env = make_env(scene, job.task)
        try:
            rows.extend(
                base | {"episode": number} | episode(env, _seed(job, number), scene)
                for number in range(job.episodes)
            )
        finally:
            env.close()
    except TabletopError as error:
        rows = [base | {"episode": 0, "error": tables.failure(error)}]
    return [row | {"rows": len(rows)} for row in rows]


def make_env(scene: Scene, task: str) -> gym.Env:
    """Return the environment of a task's id at one table."""
    name, _, preset = task.partition(":")
    more: dict[str, Any] = {"preset": preset} if preset else {}
    more["randomization"] = "starts"
    return gym.make(f"tabletopgen_env:TabletopGen/{name}-v0", scenes=scene, **more)


def episode(env: gym.Env, seed: int, scene: Scene) -> Row:
    """Run one episode and return its results."""
    _, info = env.reset(seed=seed)
    table = env.unwrapped
    assert isinstance(table, TabletopEnv)
    start = hashlib.sha256(table.world.data.qpos.tobytes()).hexdigest()[:12]
    expert = TaskExpert(env)
    held, steps = Held(), 0
    solved = truncated = False
    phases: list[list[str | int]] = []
    error = ""
    try:
        expert.reset()
    except SceneError as failed:
        truncated, error = True, tables.failure(failed)
    while not (solved or truncated):
        action = expert.act()
        if not phases or phases[-1][0] != expert.phase:
            phases.append([expert.phase, 0])
        phases[-1][1] = int(phases[-1][1]) + 1
        _, _, _, truncated, info = env.step(action)
        solved = held.after(info)
        steps += 1
    target = info["target"]
    return {
        "start": start,
        "success": int(solved),
        "steps": steps,
        "attempts": expert.attempts if not error else "",
        "phase": expert.phase,
        "goals": "/".join(map(str, info["goals"])),
        "target": target or "",
        "category": scene.object(target).model.category if target else "",
        "goal": info["goal"],
        "instruction": info["instruction"],
        "phases": " ".join(f"{name}{count}" for name, count in phases)[-400:],
        "error": error,
    }


def _seed(job: EpisodesJob, number: int) -> int:
    return 1000 * job.seed + number


def _name(text: str) -> str:
    return Path(text).name if Path(text).is_absolute() else text


def jobs(args: argparse.Namespace) -> Iterator[EpisodesJob]:
    """Yield the requested jobs."""
    tasks = args.task or TASKS
    if args.scenes != "composed":
        for path in assets_cache.find(args.scenes):
            for task in tasks:
                if task not in PRESETS or args.task:
                    yield EpisodesJob(task, str(path.resolve()), 0, args.episodes)
        return
    for task in tasks:
        for text, seed in composed_scenes(task, args.count, args.held_out, args.seed):
            yield EpisodesJob(task, text, seed, args.episodes)


def composed_scenes(
    task: str, count: int, held_out: bool, first: int | None = None
) -> list[tuple[str, int]]:
    """Return texts and seeds of ``count`` scenes of a task, for development or held out.

    ``first`` is the seed of the first round of texts; other rounds follow it.
    """
    if first is None:
        first = HELD_OUT if held_out else 0
    if own := OWN.get(task):
        return [(own[k % len(own)], first + k // len(own)) for k in range(count)]
    texts = [t for name in ("texts.json", "table78.json") for t in tables.texts_in(HERE / name)]
    shown = texts[::2]
    texts = list(dict.fromkeys(t for t in texts[1::2] if t not in shown) if held_out
                 else dict.fromkeys(shown))  # fmt: skip
    # A stride coprime to the number of texts visits the themes in turn.
    stride = next(s for s in (19, 17, 13, 1) if len(texts) % s)
    return [(texts[k * stride % len(texts)], first + k // len(texts)) for k in range(count)]


# ------------------------------------------------------------------------------------- reporting


def say(rows: list[Row]) -> str:
    run = [r for r in rows if r["success"] != ""]
    solved = sum(int(r["success"]) for r in run)
    text = f"{solved} of {len(run)}" if run else "nothing to do"
    return f"{rows[0]['task']} at {rows[0]['scene'][:40]!r} seed {rows[0]['seed']}: {text}"


def summary(rows: Sequence[Row], command: str) -> str:
    """Return the table as Markdown."""
    run = [r for r in rows if str(r["success"]) != ""]
    solved = sum(int(r["success"]) for r in run)
    lines = [
        f"# Expert: {solved} of {len(run)} episodes",
        f"`{command}`, {tables.where()}",
        "",
        f"Solved: success held for {HOLD} steps within the task's time limit. Feasible: scenes "
        "with a valid task instance. Instances: different scenes, targets and goals among the "
        "episodes; each start is perturbed. Interval: Wilson, 95 %, as if episodes of one "
        "instance were independent.",
        "",
        "| task | solved | share | interval | instances | median steps | feasible scenes |",
        "|---|---|---|---|---|---|---|",
        *(_line(task, [r for r in rows if r["task"] == task]) for task in TASKS
          if any(r["task"] == task for r in rows)),
        "",
    ]  # fmt: skip
    failed = [r for r in run if not int(r["success"])]
    for field in ("phase", "category"):
        lines += [f"| task | failed in {field} |", "|---|---|"] if failed else []
        for task in TASKS:
            counts = Counter(r[field] or "-" for r in failed if r["task"] == task)
            of = Counter(r[field] or "-" for r in run if r["task"] == task)
            text = (f"{n} {k}" + (f" of {of[n]}" if field == "category" else "")
                    for n, k in counts.most_common())  # fmt: skip
            if counts:
                lines.append(f"| {task} | {', '.join(text)} |")
        lines.append("")
    lines += [f"- {_failure(r)}" for r in failed]
    return "\n".join([*lines, ""])


def _line(task: str, rows: Sequence[Row]) -> str:
    run = [r for r in rows if str(r["success"]) != ""]
    solved = [r for r in run if int(r["success"])]
    low, high = wilson(len(solved), len(run))
    steps = sorted(int(r["steps"]) for r in solved)
    tables_, feasible = ({(r["scene"], r["seed"]) for r in some} for some in (rows, run))
    share = f"{100 * len(solved) / max(len(run), 1):.1f} %"
    middle = steps[len(steps) // 2] if steps else "-"
    instances = {tuple(str(r[k]) for k in INSTANCE) for r in run}
    return (
        f"| {task} | {len(solved)} of {len(run)} | {share} | {100 * low:.0f} to {100 * high:.0f} % "
        f"| {len(instances)} | {middle} | {len(feasible)} of {len(tables_)} |"
    )


def _failure(row: Row) -> str:
    where = f"{row['task']}, {row['scene'][:60]!r} seed {row['seed']}, episode {row['episode']}"
    return f"{where}: {row['instruction']}: {row['error'] or row['phases'][-100:]}"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--task", action="append", choices=TASKS, help="one task; may be repeated")
    parser.add_argument("--scenes", default="composed", help="'composed', or bundles as a glob")
    parser.add_argument("--count", type=int, default=30, help="number of composed scenes")
    parser.add_argument(
        "--held-out", action="store_true", help="use scenes not used in development"
    )
    parser.add_argument("--seed", type=int, help="first seed of the tables, for fresh ones")
    parser.add_argument("--episodes", type=int, default=7, help="episodes per task and table")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--name", help="name of the table; by default derived from the scenes")
    parser.add_argument("--out", type=Path, default=HERE / "results")
    args = parser.parse_args()
    composed = args.scenes == "composed"
    which = "held_out" if args.held_out else "composed" if composed else Path(args.scenes).name
    args.out.mkdir(parents=True, exist_ok=True)
    path = args.out / f"expert_{args.name or which.replace('*', '').strip('-_') or 'scenes'}.csv"
    asked = {(j.task, _name(j.text), str(j.seed)): j for j in jobs(args)}
    job = partial(work, composed=composed)
    rows = tables.complete(path, FIELDS, KEY, asked, job, args.workers, say, of="rows")
    text = summary(rows, tables.command_line("--workers", "--out", "--name"))
    path.with_suffix(".md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
