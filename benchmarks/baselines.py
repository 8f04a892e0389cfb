"""Baselines: train the recipes with several seeds and evaluate them at held-out tables.

    python benchmarks/baselines.py                                    # all of RECIPES, three seeds
    python benchmarks/baselines.py --recipe lift-clone --seeds 0 1 2 --workers 2

A seed is trained as by ``python -m tabletopgen_env train RECIPE --seed SEED``, and its *last*
policy, not the best in validation, plays ``--episodes`` episodes as with ``enjoy --scenes fresh
--seed 2000``: each at a newly generated table from the held-out side of the split. One row per seed
is written to ``baselines.csv`` when it finishes (a second run resumes; a completed training is only
evaluated), the summary to ``baselines.md`` and the validation curves to ``baselines.png``.

Lift and PickPlace observe a grasp hint, except in ``-look`` recipes, whose policies observe height
maps and learn where to grasp; the expert's demonstrations for them are stored in the folder of the
runs, for all seeds. The recipes of ``RULES`` show the value of the hint alone: they train nothing
and go where it points (``pace/rule.py``). ``lift-clone-plain`` learns without it.
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
"""Folder next to the runs with the expert's demonstrations for policies that observe height
maps."""

SEED = 2000
"""Seed of the evaluation episodes, which are the same for all policies of a task."""

KEY = ("recipe", "seed", "episodes", "hint")
FIELDS = (*KEY, "steps", "minutes", "solved", "tables", "length", "failed")


def work(job: tuple[str, int], runs: Path, episodes: int, validation: int) -> list[Row]:
    """Train one seed, unless it is already trained, and evaluate it."""
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
    """Return the folder of a completed run of a recipe.

    After an interruption, cloning resumes and other algorithms restart.

    Raises:
        KeyboardInterrupt: Ctrl-C ended the training.
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
    """Return the grasp hint of a recipe: its kind, and the detector's weights.

    Policies that observe height maps start from these weights.
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
    """Return the folder of a recipe's run; the recipe is given by name or file."""
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
        "Seeds are trained independently; the last policy of each plays one episode at each of "
        "the tables, which are used neither in training nor in validation. State observations; "
        "`-sac` and `-ppo` learn from the reward alone, `-clone` is fitted to the scripted "
        "expert's advice (DAgger). Lift and PickPlace observe the grasp hint: by default from a "
        "network trained on height maps of training tables; with `-planned` from the expert's "
        "planners, which know the collision shapes; with `-plain` none; with `-look` none "
        "either, but height maps around target and goal, in which the policy learned to find "
        "grasps; with `-sight` neither state nor hint, but pictures with depth, masks of the "
        "target (for Lift), calibrations and proprioception. The `rule-` rows are a few lines of "
        "code that go where the hint points and learn nothing. Steps are environment steps, or "
        "for cloning the states with advice. Minutes are those of the whole training, including "
        "generation of tables and validation. Interval: Wilson, 95 %, for a policy at similar "
        "tables; all seeds play at the same tables.",
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
    lines += ["", "| recipe | seeds | mean share | per seed |", "|---|---|---|---|"]
    for name in dict.fromkeys(str(r["recipe"]) for r in rows):
        shares = [100 * int(r["solved"]) / int(r["episodes"]) for r in rows if r["recipe"] == name]
        lines.append(
            f"| `{name}` | {len(shares)} | {sum(shares) / len(shares):.1f} % "
            f"| {min(shares):.1f} to {max(shares):.1f} % |"
        )
    lines += ["", "![Validation during training](baselines.png)"]
    return "\n".join([*lines, ""])


def main() -> None:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument("--recipe", action="append", help="one recipe; may be repeated")
    p.add_argument("--seeds", type=int, nargs="+", default=[0, 1, 2])
    p.add_argument("--episodes", type=int, default=200, help="evaluation episodes per policy")
    p.add_argument("--validation", type=int, default=20, help="validation episodes")
    p.add_argument("--workers", type=int, default=1)
    p.add_argument(
        "--runs", type=Path, default=Path(tempfile.gettempdir()) / "tabletopgen-baselines",
        help="folder of the runs",
    )  # fmt: skip
    p.add_argument("--note", default="", help="a remark about the machine")
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
