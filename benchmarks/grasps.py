"""Do grasp labels say what happens: two seeds of trials, and the expert that takes the grasp.

    python benchmarks/grasps.py --workers 2

Of every object that stands on the table of a bundle, grasps from above are rated by trials with two
seeds (``tabletopgen_env.grasps``), and of the worst and the best ``--each`` are then taken by the
Panda: the object alone on its table, the task Lift, the expert's motion with that grasp and no
other. Rows go to ``grasps.csv`` as they come (a second run resumes), the summary to the ``.md``
beside it.
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
"""Cosine of the most that a hand from above leans."""

ABOVE = 0.002
"""Metres that fingertips keep over the table."""


class GraspJob(NamedTuple):
    """An object of a bundle; ``each`` of its worst and best grasps from above are taken."""

    bundle: Path
    name: str
    each: int
    terms: GraspTerms


@dataclass(frozen=True, eq=False)
class OneGrasp:
    """A ``Chooser`` that knows one grasp, in the object's frame."""

    labels: GraspLabels

    def __call__(
        self, world: World, target: str, failed: tuple[Grasp, ...] = ()
    ) -> GraspPlan | None:
        """Return the grasp where the object is now, if the arm reaches it and has not failed."""
        if failed:
            return None
        turn = world.rotation(target)
        hand = turn @ quaternion_matrix(self.labels.quaternion[0])
        point = turn @ self.labels.position[0] + world.position(target)
        angle = float(np.arctan2(hand[1, 1], hand[0, 1]))
        opening, width = float(self.labels.opening[0]), float(self.labels.width[0])
        return first_reachable(world, target, [Grasp(point, angle, opening, width, 0.0)])


def work(job: GraspJob) -> list[Row]:
    """Rate the grasps of an object twice, have the Panda take some; return a row for each."""
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
    """Return the grasps of an object that a hand from above can take where it stands."""
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
    """Return whether the arm reaches the grasp, and whether it lifts the object by it."""
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
    """Return the chance that a success is rated above a failure, ties counted half."""
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
        f"most {np.abs(first - again).max(initial=0):.2f}. The arm reaches {len(reached)}; taken "
        f"by the expert's motion, each object alone on its table, {len(success) - sum(success)} "
        "do not lift it. The chance that a grasp that lifted is rated above one that did not is "
        f"{curves['quality']:.2f} by quality and {curves['lifted']:.2f} by the share lifted. "
        "Trials ask for more than Lift does (errors of the hand, less friction, turning, "
        "shaking), so that many grasps of low quality still lift.",
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
    parser.add_argument("--each", type=int, default=2, help="worst and best grasps that are taken")
    parser.add_argument("--count", type=int, default=60, help="grasps of an object, from all sides")
    parser.add_argument("--trials", type=int, default=GraspTerms().trials)
    parser.add_argument("--most", type=int, default=1000, help="objects at most")
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
