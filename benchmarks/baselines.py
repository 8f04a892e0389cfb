"""Baselines: train the recipes with several seeds, and play at held-out tables never met before.

    python benchmarks/baselines.py                                    # all of RECIPES, three seeds
    python benchmarks/baselines.py --recipe lift-clone --seeds 0 1 2 --workers 2

A seed is trained as ``python -m tabletopgen_env train RECIPE --seed SEED`` does, and its *last*
policy, not the best by validation, plays ``--episodes`` episodes as ``enjoy --scenes fresh --seed
2000`` does: each at a table made again on the held-out side of the split. A row a seed goes to
``baselines.csv`` as it ends (a second run resumes; a run that was trained already is only played),
the summary to ``baselines.md`` and the curves of validation to ``baselines.png``.

Lift and PickPlace see a grasp hint, but for ``-look``, whose policies see height maps and learn by
themselves where to grasp; what the expert shows them at tables is kept in the folder of the runs,
for all seeds. What the hint alone is worth is told by the recipes of ``RULES``, which train nothing
and go where it points (``pace/rule.py``), what it is worth to learn without by
``lift-clone-plain``.
"""

from __future__ import annotations

import argparse
import json
import shutil
import tempfile
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import Any

from pace.rule import HintRule
from posing import tables
from posing.tables import Row

from generator.errors import InputError, TabletopError
from generator.io.pictures import write_picture
from tabletopgen_env.detection.detector import shipped_digest
from tabletopgen_env.learning.evaluation import EpisodeResult, Predicts, play, seeds, summarize
from tabletopgen_env.learning.plots import bands, draw
from tabletopgen_env.learning.policies import load_policy
from tabletopgen_env.learning.progress import TrainingPlan
from tabletopgen_env.learning.recipes import recipe as recipe_named
from tabletopgen_env.learning.runs import LATEST, open_run
from tabletopgen_env.learning.setup import single_env, source_of
from tabletopgen_env.learning.training import train
from tabletopgen_env.scenes.source import close
from tabletopgen_env.statistics import wilson

HERE = Path(__file__).parent
RECIPES = (
    "reach-clone", "lift-clone", "pickplace-clone", "lift-look", "pickplace-look", "reach-sac",
    "reach-ppo",
)  # fmt: skip
RULES = {
    "rule-lift": ("Lift", "detected"),
    "rule-lift-planned": ("Lift", "planned"),
    "rule-pickplace": ("PickPlace", "detected"),
    "rule-pickplace-planned": ("PickPlace", "planned"),
}
SHOWINGS = "showings"
"""Where, beside the runs, what the expert shows to policies that look is kept."""

SEED = 2000
"""Of the episodes played, the same ones for every policy of a task."""

KEY = ("recipe", "seed", "episodes", "hint")
FIELDS = (*KEY, "steps", "minutes", "solved", "tables", "length", "failed")


def work(job: tuple[str, int], runs: Path, episodes: int, validation: int) -> list[Row]:
    """Train one seed, unless that is done, and play."""
    name, seed = job
    steps, minutes = 0, 0.0
    if name in RULES:
        task, hint = RULES[name]
        settings = {"grasp_hint": hint}
        played = playing(task, settings, lambda: HintRule(task != "Lift"), episodes)
    else:
        folder = train_baseline(name, seed, runs, validation)
        last, policy = open_run(folder).rows()[-1], load_policy(folder / LATEST)
        steps, minutes = last.steps, last.seconds / 60
        played = playing(policy.card.task, policy.card.env, lambda: policy, episodes)
    seen = summarize(played)
    failed = sorted(p.instruction for p in played if not p.solved)
    return [{
        "recipe": name, "seed": seed, "steps": steps, "minutes": f"{minutes:.1f}",
        "episodes": seen.episodes, "hint": hint_of(name), "solved": seen.solved,
        "tables": seen.tables, "length": f"{seen.steps:.0f}", "failed": json.dumps(failed),
    }]  # fmt: skip


def train_baseline(name: str, seed: int, runs: Path, validation: int) -> Path:
    """Return the folder of a whole run of a recipe.

    Of a run that was cut off, cloning resumes and all else is begun anew.

    Raises:
        KeyboardInterrupt: Ctrl-C has ended the training.
    """
    folder = folder_of(runs, name, seed)
    if not folder.exists():
        part = folder.with_name(folder.name + ".part")
        goes_on = recipe_named(name).algorithm == "clone" and (part / "recipe.json").exists()
        if not goes_on:
            shutil.rmtree(part, ignore_errors=True)
        plan = TrainingPlan(seed, episodes=validation, showings=runs / SHOWINGS)
        if train(recipe_named(name), part, plan, goes_on).interrupted:
            raise KeyboardInterrupt
        part.rename(folder)
    if open_run(folder).recipe != recipe_named(name):
        raise InputError(f"{folder} is a run of another recipe {name}; move it away.")
    return folder


def hint_of(name: str) -> str:
    """Return what the grasp hint of a recipe is: its kind, and the detector's weights.

    Of a policy that looks these are what its head starts from.
    """
    if name not in RULES and (recipe_named(name).cloning or {}).get("head_start") == "detector":
        return f"head {shipped_digest()}"
    kind = RULES[name][1] if name in RULES else str(recipe_named(name).env.get("grasp_hint", ""))
    return f"{kind} {shipped_digest()}" if kind == "detected" else kind


def playing(
    task: str, settings: Mapping[str, Any], new: Callable[[], Predicts], episodes: int
) -> list[EpisodeResult]:
    """Play at held-out fresh tables, each episode with a ``new`` policy."""
    source = source_of("fresh", "held_out")
    env = single_env(task, settings, source)
    try:
        return [play(env, new(), own) for own in seeds(SEED, episodes)]
    finally:
        env.close()
        close(source)


def folder_of(runs: Path, name: str, seed: int) -> Path:
    """Return where a run of a recipe, by name or file, lies."""
    return runs / f"{Path(name).stem}-{seed}"


def say(rows: list[Row]) -> str:
    row = rows[0]
    return f"{row['recipe']}, seed {row['seed']}: {row['solved']} of {row['episodes']}"


def summary(rows: Sequence[Row], command: str, note: str) -> str:
    """Return the tables as Markdown."""
    lines = [
        "# Baselines at held-out fresh tables",
        f"`{command}`, {tables.where()}{'; ' + note if note else ''}",
        "",
        "Each seed trained by itself; its last policy plays one episode at each of the tables, "
        "which neither training nor validation has met. State observations; `-sac` and `-ppo` "
        "learn from the reward alone, `-clone` is fitted to the scripted expert's advice "
        "(DAgger). Lift and PickPlace see the grasp hint: that of a network, which has learned "
        "from height maps of training tables where to grasp; with `-planned` that of the "
        "expert's planners, which know the collision shapes; with `-plain` none, with `-look` "
        "none either, but height maps around target and goal, in which the policy learned to "
        "find grasps; with `-sight` neither state nor hint, but pictures with depth, masks of the "
        "target (of Lift), calibrations and proprioception. The `rule-` rows are of a few lines "
        "that go where the hint points and learn nothing. Steps are of the environment, or of "
        "cloning the states with advice. "
        "Minutes are of the whole training, tables made and validation included. Interval: "
        "Wilson, 95 %, of a policy at tables like these; the seeds play at the same tables.",
        "",
        "| recipe | seed | steps | minutes | solved | share | interval |",
        "|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        solved, count = int(row["solved"]), int(row["episodes"])
        low, high = (100 * x for x in wilson(solved, count))
        lines.append(
            f"| `{row['recipe']}` | {row['seed']} | {int(row['steps']):,} | {row['minutes']} "
            f"| {solved} of {count} | {100 * solved / count:.1f} % | {low:.0f} to {high:.0f} % |"
        )
    lines += ["", "| recipe | seeds | mean share | of the seeds |", "|---|---|---|---|"]
    for name in dict.fromkeys(str(r["recipe"]) for r in rows):
        shares = [100 * int(r["solved"]) / int(r["episodes"]) for r in rows if r["recipe"] == name]
        lines.append(
            f"| `{name}` | {len(shares)} | {sum(shares) / len(shares):.1f} % "
            f"| {min(shares):.1f} to {max(shares):.1f} % |"
        )
    lines += ["", "![Validation while training](baselines.png)"]
    return "\n".join([*lines, ""])


def main() -> None:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument("--recipe", action="append", help="one recipe; may be repeated")
    p.add_argument("--seeds", type=int, nargs="+", default=[0, 1, 2])
    p.add_argument("--episodes", type=int, default=200, help="played by each policy")
    p.add_argument("--validation", type=int, default=20, help="episodes of a validation")
    p.add_argument("--workers", type=int, default=1)
    p.add_argument(
        "--runs", type=Path, default=Path(tempfile.gettempdir()) / "tabletopgen-baselines",
        help="where the runs' folders go",
    )  # fmt: skip
    p.add_argument("--note", default="", help="what to know about the machine")
    p.add_argument("--out", type=Path, default=HERE / "results")
    args = p.parse_args()
    names = args.recipe or (*RECIPES, *RULES)
    asked = [(n, seed) for n in names for seed in (args.seeds if n not in RULES else [0])]
    try:
        args.out.mkdir(parents=True, exist_ok=True)
        table = args.out / "baselines.csv"
        rows = tables.resume(table, FIELDS, KEY)
        done = {(r["recipe"], int(r["seed"]), int(r["episodes"]), r["hint"]) for r in rows}
        job = partial(
            work, runs=args.runs, episodes=args.episodes, validation=args.validation
        )  # fmt: skip
        left = [a for a in asked if (*a, args.episodes, hint_of(a[0])) not in done]
        rows = tables.run(table, FIELDS, KEY, rows, left, job, args.workers, say)
        found = [folder_of(args.runs, str(r["recipe"]), int(r["seed"])) for r in rows]
        kept = [open_run(path) for path in found if (path / LATEST).exists()]
        if kept:
            write_picture(draw(bands(kept, "steps")), args.out / "baselines.png")
    except TabletopError as error:
        raise SystemExit(str(error)) from error
    text = summary(rows, tables.command_line("--note", "--runs", "--out"), args.note)
    (args.out / "baselines.md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
