"""Scenes from a curriculum against uniformly drawn scenes: the same learner, the same steps.

    python benchmarks/curriculum.py --recipe reach-clone --set cloning.rounds=2   # minutes
    python benchmarks/curriculum.py --recipe reach-sac --seeds 0 1 2 --episodes 200   # hours

Each seed of a recipe is trained twice, at uniformly drawn scenes ("fresh") and with
``CurriculumScenes`` over the same scenes ("curriculum"), and both policies play the same episodes
at held-out tables. One row per training is written to ``curriculum.csv`` when it finishes (a second
run resumes), the difference with its interval to ``curriculum.md``.
"""

from __future__ import annotations

import argparse
import dataclasses
import json
import tempfile
import time
from collections.abc import Sequence
from functools import partial
from pathlib import Path

import numpy as np
from jaxtyping import Float
from posing import tables
from posing.tables import Row

from generator.errors import TabletopError
from tabletopgen_env.learning.evaluation import play, seeds
from tabletopgen_env.learning.policies import load_policy
from tabletopgen_env.learning.progress import TrainingPlan
from tabletopgen_env.learning.recipes import Recipe
from tabletopgen_env.learning.recipes import recipe as recipe_named
from tabletopgen_env.learning.runs import LATEST
from tabletopgen_env.learning.setup import single_env, source_of
from tabletopgen_env.learning.training import train
from tabletopgen_env.statistics import wilson

HERE = Path(__file__).parent
MODES = {"uniform": "fresh", "curriculum": "curriculum:fresh"}
SEED = 2000
"""Seed of the evaluation episodes, which are the same for all policies."""

KEY = ("recipe", "changes", "variants", "episodes", "mode", "seed")
FIELDS = (*KEY, "minutes", "solved", "each")


def work(job: tuple[str, int], recipe: Recipe, changes: str, episodes: int) -> list[Row]:
    """Train one seed in one mode, and evaluate it."""
    mode, seed = job
    chosen = dataclasses.replace(recipe, scenes=MODES[mode])
    begin = time.perf_counter()
    with tempfile.TemporaryDirectory() as folder:
        run = Path(folder) / "run"
        plan = TrainingPlan(seed, evaluate_every=recipe.steps, episodes=1, keep_replay=False)
        if train(chosen, run, plan, say=lambda _: None).interrupted:
            raise KeyboardInterrupt
        policy = load_policy(run / LATEST)
    minutes = (time.perf_counter() - begin) / 60
    held_out = source_of("fresh", "held_out", recipe.variants)
    env = single_env(recipe.task, policy.card.env, held_out)
    solved = [int(play(env, policy, own).solved) for own in seeds(SEED, episodes)]
    env.close()
    return [{
        "recipe": recipe.name, "changes": changes, "variants": recipe.variants,
        "episodes": episodes, "mode": mode, "seed": seed, "minutes": f"{minutes:.1f}",
        "solved": sum(solved), "each": json.dumps(solved),
    }]  # fmt: skip


def differences(rows: Sequence[Row]) -> Float[np.ndarray, "s e"]:
    """Return, for each seed trained in both modes, curriculum - uniform in each episode."""
    each = {(r["mode"], int(r["seed"])): np.array(json.loads(str(r["each"]))) for r in rows}
    both = sorted(seed for mode, seed in each if mode == "uniform" and ("curriculum", seed) in each)
    return np.array([each["curriculum", s] - each["uniform", s] for s in both], float)


def interval(found: Float[np.ndarray, "s e"], draws: int = 4000) -> tuple[float, float]:
    """Return a 95 % interval of the mean difference, for similar seeds and tables.

    Percentile bootstrap: seeds and episodes are resampled, each with all of its values.
    """
    rng = np.random.default_rng(0)
    count, episodes = found.shape
    means = [
        found[rng.integers(count, size=count)][:, rng.integers(episodes, size=episodes)].mean()
        for _ in range(draws)
    ]
    low, high = np.quantile(means, [0.025, 0.975])
    return float(low), float(high)


def say(rows: list[Row]) -> str:
    row = rows[0]
    return f"{row['mode']}, seed {row['seed']}: {row['solved']} of {row['episodes']}"


def summary(rows: Sequence[Row], command: str, note: str) -> str:
    """Return the tables as Markdown."""
    lines = [
        "# Scenes by curriculum and drawn uniformly",
        f"`{command}`, {tables.where()}{'; ' + note if note else ''}",
        "",
        "Each seed is trained twice with equal steps: at uniformly drawn fresh tables, and with "
        "`CurriculumScenes` over the same tables. Both policies play the same episodes at "
        "held-out tables. Interval of a share: Wilson, 95 %; of a difference: bootstrap over "
        "seeds and episodes, 95 %, which is too narrow with so few seeds.",
        "",
        "| recipe | with | scenes | seed | minutes | solved | share | interval |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for row in rows:
        solved, count = int(row["solved"]), int(row["episodes"])
        low, high = (100 * x for x in wilson(solved, count))
        lines.append(
            f"| `{row['recipe']}` | {row['changes']} | {row['mode']} | {row['seed']} "
            f"| {row['minutes']} | {solved} of {count} | {100 * solved / count:.1f} % "
            f"| {low:.0f} to {high:.0f} % |"
        )
    lines += ["", "| recipe | with | seeds | curriculum - uniform | interval |",
              "|---|---|---|---|---|"]  # fmt: skip
    for kind in dict.fromkeys(tuple(str(r[k]) for k in KEY[:4]) for r in rows):
        found = differences([r for r in rows if tuple(str(r[k]) for k in KEY[:4]) == kind])
        if len(found):
            low, high = (100 * x for x in interval(found))
            lines.append(
                f"| `{kind[0]}` | {kind[1]} | {len(found)} | {100 * found.mean():+.1f} "
                f"points | {low:+.1f} to {high:+.1f} |"
            )
    return "\n".join([*lines, ""])


def main() -> None:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument("--recipe", default="reach-sac")
    p.add_argument("--set", nargs="*", default=[], help="settings that replace the recipe's")
    p.add_argument(
        "--variants", type=int, default=150, help="number of tables, a fifth of them held out"
    )
    p.add_argument("--seeds", type=int, nargs="+", default=[0, 1])
    p.add_argument("--episodes", type=int, default=60, help="evaluation episodes per policy")
    p.add_argument("--workers", type=int, default=1)
    p.add_argument("--note", default="", help="a remark about the machine")
    p.add_argument("--out", type=Path, default=HERE / "results")
    args = p.parse_args()
    try:
        changes = " ".join(args.set)
        recipe = dataclasses.replace(
            recipe_named(args.recipe, tuple(args.set)), variants=args.variants
        )
        args.out.mkdir(parents=True, exist_ok=True)
        table = args.out / "curriculum.csv"
        rows = tables.resume(table, FIELDS, KEY)
        done = {tuple(str(row[k]) for k in KEY) for row in rows}
        kind = (recipe.name, changes, str(args.variants), str(args.episodes))
        asked = [(mode, seed) for seed in args.seeds for mode in MODES]
        left = [job for job in asked if (*kind, job[0], str(job[1])) not in done]
        job = partial(work, recipe=recipe, changes=changes, episodes=args.episodes)
        rows = tables.run(table, FIELDS, KEY, rows, left, job, args.workers, say)
    except TabletopError as error:
        raise SystemExit(str(error)) from error
    text = summary(rows, tables.command_line("--note", "--out"), args.note)
    (args.out / "curriculum.md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
