"""Soak test: random steps at many composed tables; checks for errors and unreported falls.

    python benchmarks/soak.py --steps 50000 --scenes 10
    python benchmarks/soak.py --steps 1000000 --scenes 50
    python benchmarks/soak.py --steps 1000000 --processes 2 --slots 16

Each scene gets its share of the steps, in episodes of ``EPISODE``, with new random actions every
``HELD`` steps so that the arm covers a wide range. Counted are numbers that are not finite
(observation, reward, state), MuJoCo's warnings, observations outside their space, objects off the
table at an episode's end that ``info["off_table"]`` does not list, objects below the floor or
outside the room, and listed objects. Scenes without a valid PickPlace task use Reach. One row per
scene is written to ``soak.csv`` when it finishes (a second run resumes), the summary to
``soak.md``.

With ``--processes`` all tables are stepped at once, by a ``TabletopVectorEnv`` in that many
processes (``pace/sharded.py``). The same errors are counted, and the memory of this process and of
the shards is measured; a row for each tenth of the steps is written to ``soak_shards.csv``, the
summary to ``soak_shards.md``.
"""

from __future__ import annotations

import argparse
import csv
import tempfile
import time
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from pace import sharded
from pace.watching import beside, count_rows, find_escaped
from posing import tables
from posing.tables import Row

from generator.bundle import save
from generator.composition import compose
from generator.errors import SceneError, TabletopError
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.tasks.pick_place import PickPlace

if TYPE_CHECKING:
    from generator.scene import Scene

HERE = Path(__file__).parent
EPISODE, HELD = 200, 8
TEXTS = (
    "a kitchen table with six things",
    "a messy office desk with eight things",
    "a breakfast table for two",
    "a workbench with tools",
    "a coffee table with cups and fruit",
)
KEY = ("scene", "seed", "steps")
COUNTS = ("not_finite", "warnings", "outside", "unnoticed", "escaped")
FIELDS = (*KEY, "done", *COUNTS, "fell", "longest_ms", "seconds", "error")


def work(number: int, seed: int, steps: int) -> list[Row]:
    """Run one scene and return its row; a failure is also a row."""
    row: Row = dict.fromkeys(FIELDS, 0) | {
        "scene": number, "seed": seed, "steps": steps, "error": "",
    }  # fmt: skip
    begin = time.perf_counter()
    try:
        scene = compose(TEXTS[number % len(TEXTS)], seed=seed + number)
        soak(usable(scene), np.random.default_rng([seed, number]), steps, row)
    except Exception as error:  # one scene must not abort the run
        row["error"] = tables.failure(error)
    row["seconds"] = round(time.perf_counter() - begin, 1)
    return [row]


def usable(scene: Scene) -> TabletopEnv:
    """Return an environment of PickPlace at a table, or of Reach without a valid PickPlace task."""
    env = make_env(scene)
    try:
        env.reset(seed=0)
    except SceneError:
        return make_env(scene, task="Reach")
    return env


def soak(env: TabletopEnv, rng: np.random.Generator, steps: int, row: Row) -> None:
    """Take ``steps`` random steps and count errors in ``row``."""
    shape = env.action_space.shape
    action = np.zeros(shape or ())
    fell: set[str] = set()
    for k in range(steps):
        if k % EPISODE == 0:
            row["fell"] += len(fell)
            fell = set()
            env.reset(seed=int(rng.integers(2**31)))
        if k % HELD == 0:
            action = rng.uniform(-1, 1, shape)
        clock = time.perf_counter()
        seen, reward, _, _, info = env.step(action)
        row["longest_ms"] = max(row["longest_ms"], round(1e3 * (time.perf_counter() - clock), 1))
        world, reported = env.world, set(info["off_table"])
        state = np.concatenate([world.data.qpos, world.data.qvel])
        row["not_finite"] += not (np.isfinite(state).all() and np.isfinite([*seen, reward]).all())
        row["outside"] += not env.observation_space.contains(seen)
        row["escaped"] += len(find_escaped(world))
        fell |= reported
        row["done"] = k + 1
        if k % EPISODE == EPISODE - 1 or k == steps - 1:
            row["unnoticed"] += len(beside(world) - reported)
            row["warnings"] += int(sum(w.number for w in world.data.warning))
    row["fell"] += len(fell)


def say(rows: list[Row]) -> str:
    (row,) = rows
    wrong = {k: row[k] for k in COUNTS if row[k]}
    reported = row["error"] or f"{row['done']} steps, {row['fell']} things fell, {row['seconds']} s"
    return f"scene {row['scene']}: {reported}" + (f", WRONG: {wrong}" if wrong else "")


def summary(rows: Sequence[Row], command: str, note: str = "") -> str:
    """Return the counts as Markdown."""
    whole = {f: sum(int(r[f]) for r in rows) for f in ("done", "fell", *COUNTS)}
    failed = [r for r in rows if r["error"]]
    lines = [
        f"# Soak: {whole['done']} random steps at {len(rows)} tables",
        f"`{command}`, {tables.where()}{'; ' + note if note else ''}",
        "",
        *count_rows(whole),
        f"| scenes that failed | {len(failed)} |",
        f"| objects that fell off the table, and were reported | {whole['fell']} |",
        "",
        f"Longest step: {max((float(r['longest_ms']) for r in rows), default=0.0):.0f} ms.",
    ]
    lines += [f"- scene {r['scene']}: {r['error']}" for r in failed]
    return "\n".join([*lines, ""])


def soak_shards(args: argparse.Namespace) -> None:
    """Soak-test a vector environment in processes at composed tables with goals for PickPlace."""
    with tempfile.TemporaryDirectory() as folder:
        made = (compose(TEXTS[n % len(TEXTS)], seed=args.seed + n) for n in range(args.scenes))
        places = [save(s, Path(folder)) for s in made if isinstance(usable(s).task, PickPlace)]
        plan = sharded.ShardSoak(places, args.processes, args.slots, args.steps, args.seed)
        rows = sharded.soak(plan)
    with (args.out / "soak_shards.csv").open("w", newline="", encoding="utf-8") as file:
        writer: csv.DictWriter[str] = csv.DictWriter(file, sharded.FIELDS)
        writer.writeheader()
        writer.writerows(rows)
    text = sharded.summary(plan, rows, tables.command_line("--note", "--out"), args.note)
    (args.out / "soak_shards.md").write_text(text, encoding="utf-8")
    print(text)


def main() -> None:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument("--steps", type=int, default=50_000, help="total over all scenes")
    p.add_argument("--scenes", type=int, default=10)
    p.add_argument("--seed", type=int, default=0)
    p.add_argument("--workers", type=int, default=1)
    p.add_argument(
        "--processes", type=int, help="processes of one vector environment at all tables"
    )
    p.add_argument("--slots", type=int, default=16, help="slots of that vector environment")
    p.add_argument("--note", default="", help="a remark about the machine")
    p.add_argument("--out", type=Path, default=HERE / "results")
    args = p.parse_args()
    if args.scenes < 1 or args.steps < args.scenes:
        raise SystemExit("--scenes must be at least 1, and --steps at least as many.")
    share = args.steps // args.scenes
    try:
        args.out.mkdir(parents=True, exist_ok=True)
        if args.processes is not None:
            soak_shards(args)
            return
        table = args.out / "soak.csv"
        asked = {(str(n), str(args.seed), str(share)): n for n in range(args.scenes)}
        job = partial(work, seed=args.seed, steps=share)
        rows = tables.complete(table, FIELDS, KEY, asked, job, args.workers, say)
    except TabletopError as error:
        raise SystemExit(str(error)) from error
    text = summary(rows, tables.command_line("--note"), args.note)
    (args.out / "soak.md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
