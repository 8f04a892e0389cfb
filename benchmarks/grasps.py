"""Validity of grasp labels: trials with two seeds, and the expert's success with each grasp.

    python benchmarks/grasps.py --workers 2

For every object that stands on the table of a bundle, grasps from above are rated by trials with
two seeds (``tabletopgen_env.grasps``). The ``--each`` worst and best ones are then executed by the
Panda: the object alone on its table, the task Lift, and the expert's motion with only that grasp.
Rows are written to ``grasps.csv`` as they finish (a second run resumes), the summary to the
corresponding ``.md``.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

import gymnasium
import numpy as np
from posing import tables
from posing.tables import Row
from scipy.stats import rankdata

import assets_cache
from generator.bundle import load
from generator.errors import SceneError
from generator.geometry import quaternion_matrix
from generator.scene import TABLE, Object, Scene
from tabletopgen_env.env import make_env
from tabletopgen_env.episodes import Held
from tabletopgen_env.expert.planning.choice import GraspPlan, first_reachable
from tabletopgen_env.expert.planning.grasps import TIP, Grasp
from tabletopgen_env.expert.run import TaskExpert
from tabletopgen_env.grasps import GraspCandidate, GraspLabels, GraspTerms, rate_grasps
from tabletopgen_env.grasps.candidates import find_candidates
from tabletopgen_env.statistics import wilson
from tabletopgen_env.world.world import World

HERE = Path(__file__).parent
KEY = ("bundle", "object", "number")
FIELDS = (*KEY, "rows", "quality", "again", "lifted", "width", "reached", "success")
DOWN = np.cos(np.deg2rad(12.0))
"""Cosine of the maximum lean of a hand from above."""

ABOVE = 0.002
"""Minimum height of fingertips above the table, metres."""


class GraspJob(NamedTuple):
    """An object of a bundle; ``each`` of its worst and best grasps from above are executed."""

    bundle: Path
    name: str
    each: int
    terms: GraspTerms


@dataclass(frozen=True, eq=False)
class OneGrasp:
    """A ``Chooser`` with a single grasp, in the object's frame."""

    labels: GraspLabels

    def __call__(
        self, world: World, target: str, failed: tuple[Grasp, ...] = ()
    ) -> GraspPlan | None:
        """Return the grasp at the object's pose, if the arm reaches it and it has not failed."""
        if failed:
            return None
        turn = world.rotation(target)
        hand = turn @ quaternion_matrix(self.labels.quaternion[0])
        point = turn @ self.labels.position[0] + world.position(target)
        angle = float(np.arctan2(hand[1, 1], hand[0, 1]))
        opening, width = float(self.labels.opening[0]), float(self.labels.width[0])
        return first_reachable(world, target, [Grasp(point, angle, opening, width, 0.0)])


def work(job: GraspJob) -> list[Row]:
    """Rate the grasps of an object twice and execute some with the Panda; return a row for each."""
    scene = load(job.bundle)
    thing = scene.object(job.name)
    alone = scene.replace(objects=(thing,), plan=None, report=None)
    grasps = from_above(scene, thing, job.terms)
    if not grasps:
        return []
    first = rate_grasps(thing, grasps, job.terms)
    terms = GraspTerms(job.terms.count, job.terms.trials, job.terms.directions, job.terms.seed + 1)
    again = rate_grasps(thing, grasps, terms)
    order = np.argsort(first.quality, kind="stable")
    chosen = sorted({*order[: job.each].tolist(), *order[len(order) - job.each :].tolist()})
    rows: list[Row] = []
    for k in chosen:
        reached, success = take(alone, job.name, first.pick(np.array([k])))
        rows.append({
            "bundle": job.bundle.name, "object": job.name, "number": k, "rows": len(chosen),
            "quality": f"{first.quality[k]:.4f}", "again": f"{again.quality[k]:.4f}",
            "lifted": f"{first.lifted[k]:.4f}", "width": f"{first.width[k]:.4f}",
            "reached": int(reached), "success": int(success),
        })  # fmt: skip
    return rows


def from_above(scene: Scene, thing: Object, terms: GraspTerms) -> list[GraspCandidate]:
    """Return the grasps that a hand from above can execute at the object's pose."""
    turn, place = quaternion_matrix(thing.pose.quaternion), thing.pose.position
    rng = np.random.default_rng((terms.seed, 0))
    found = find_candidates(thing, terms.count, terms.directions, rng)
    low = scene.table.height + ABOVE
    return [
        grasp
        for grasp in found
        if (turn @ grasp.rotation)[2, 2] < -DOWN and (turn @ grasp.position + place)[2] - TIP > low
    ]


def take(alone: Scene, name: str, labels: GraspLabels) -> tuple[bool, bool]:
    """Return whether the arm reaches the grasp, and whether it lifts the object with it."""
    limit = gymnasium.spec("TabletopGen/Lift-v0").max_episode_steps
    assert limit is not None
    with closing(
        make_env(alone, task="Lift", certified=False, grasp_hint="planned", randomization=None)
    ) as env:
        assert env.hint is not None
        try:
            env.reset(seed=0, options={"target": name})
            env.hint.choose = OneGrasp(labels)
            env.hint.begin(env.world, env.goal)
            if env.hint.planned is None:
                return False, False
            expert = TaskExpert(env)
            expert.reset()
        except SceneError:
            return False, False
        held = Held()
        for _ in range(limit):
            success = held.after(env.step(expert.act())[4])
            if success or expert.attempts > 1 or expert.phase == "stuck":
                return True, success and expert.attempts == 1
    return True, False


# ------------------------------------------------------------------------------------- reporting


def area_under_curve(scores: Sequence[float], labels: Sequence[int]) -> float:
    """Return the probability that a success is rated above a failure; ties count half."""
    truth = np.array(labels, bool)
    if truth.all() or not truth.any():
        return float("nan")
    ranks = rankdata(scores)
    positive = int(truth.sum())
    above = ranks[truth].sum() - positive * (positive + 1) / 2
    return float(above / (positive * (len(truth) - positive)))


def summary(rows: Sequence[Row], command: str) -> str:
    """Return the table as Markdown."""
    first, again = (np.array([float(r[k]) for r in rows]) for k in ("quality", "again"))
    reached = [r for r in rows if int(r["reached"])]
    success = [int(r["success"]) for r in reached]
    curves = {k: area_under_curve([float(r[k]) for r in reached], success)
              for k in ("quality", "lifted")}  # fmt: skip
    same = float(np.corrcoef(first, again)[0, 1]) if len(rows) > 1 and np.ptp(first) else np.nan
    lines = [
        "# Grasp labels against a second seed and against the expert",
        f"`{command}`, {tables.where()}",
        "",
        f"{len(rows)} grasps from above of {len({(r['bundle'], r['object']) for r in rows})} "
        "objects, the worst and the best of each by the first seed. Quality by two seeds of "
        f"trials: correlation {same:.2f}, mean difference {np.abs(first - again).mean():.3f}, at "
        f"most {np.abs(first - again).max(initial=0):.2f}. The arm reaches {len(reached)}; "
        "executed by the expert's motion, each object alone on its table, "
        f"{len(success) - sum(success)} do not lift it. The probability that a successful grasp "
        f"is rated above a failed one is {curves['quality']:.2f} by quality and "
        f"{curves['lifted']:.2f} by the share lifted. Trials are more demanding than Lift (errors "
        "of the hand, less friction, turning, shaking), so that many grasps of low quality still "
        "lift.",
        "",
        "| quality | grasps | lifted by the expert | 95 % |",
        "|---|---|---|---|",
    ]
    for low, high in ((0.0, 0.25), (0.25, 0.75), (0.75, 1.0), (1.0, 1.1)):
        part = [int(r["success"]) for r in reached if low <= float(r["quality"]) < high]
        if part:
            a, b = wilson(sum(part), len(part))
            name = f"{low:g} to {high:g}" if high <= 1 else "1"
            lines.append(f"| {name} | {len(part)} | {np.mean(part):.0%} | {a:.0%} to {b:.0%} |")
    return "\n".join([*lines, ""])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("--bundles", nargs="+", default=["starter"])
    parser.add_argument(
        "--each", type=int, default=2, help="number of worst and of best grasps to execute"
    )
    parser.add_argument("--count", type=int, default=60, help="grasps per object, from all sides")
    parser.add_argument("--trials", type=int, default=GraspTerms().trials)
    parser.add_argument("--most", type=int, default=1000, help="maximum number of objects")
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument("--out", type=Path, default=HERE / "results")
    args = parser.parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    terms = GraspTerms(args.count, args.trials, 0)
    paths = sorted({p.resolve() for name in args.bundles for p in assets_cache.find(name)})
    asked = {
        (path.name, thing.name): GraspJob(path, thing.name, args.each, terms)
        for path in paths
        for thing in load(path).objects
        if thing.placement.on == TABLE
    }
    asked = dict([*asked.items()][: args.most])
    path = args.out / "grasps.csv"
    rows = tables.complete(
        path, FIELDS, KEY, asked, work, args.workers,
        lambda new: f"{new[0]['bundle']}, {new[0]['object']}: "
        f"{sum(int(r['success']) for r in new)} of {len(new)}" if new else "no grasp from above",
        of="rows",
    )  # fmt: skip
    tables.write(path, FIELDS, rows)
    text = summary(rows, tables.command_line("--workers", "--out"))
    path.with_suffix(".md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
