"""One policy in two environments: ``TabletopEnv`` and ``TabletopBatchEnv``, the same episodes.

    python benchmarks/two_environments.py --policy reach-clone --episodes 500
    python benchmarks/two_environments.py --policy expert --task Lift --episodes 100

A batch draws its episodes through ``TabletopEnv``, so table, target, goal and start are equal;
simulation differs (single precision, no sleeping, objects of at most 12 convex parts). A trained
policy acts on each environment's own observations. The expert, which batches do not support, acts
in ``TabletopEnv``, and its actions are replayed open-loop in the batch. An episode is solved when
success has held for ten steps, within the task's time limit. Results of other policies in ``--out``
are kept.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Callable, Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
import torch
from jaxtyping import Bool, Int
from posing import tables
from posing.tables import Row
from scipy.stats import binomtest

from generator.scene import Scene
from tabletopgen_env.env import make_env
from tabletopgen_env.episodes import Held
from tabletopgen_env.expert.run import TaskExpert
from tabletopgen_env.learning.policies import TrainedPolicy, load_policy
from tabletopgen_env.parallel.batch.decks import DeckConfig
from tabletopgen_env.parallel.batch.env import TabletopBatchEnv, time_limit
from tabletopgen_env.scenes import FixedScenes, resolve
from tabletopgen_env.statistics import newcombe, wilson

HERE = Path(__file__).parent
EXPERT = "expert"
FIELDS = (
    "policy", "task", "scenes", "tables", "episodes", "single", "batch", "single_alone",
    "batch_alone", "failed", "minutes", "where", "options",
)  # fmt: skip
KEY = ("policy", "task", "scenes")

Act = Callable[[Any, Int[np.ndarray, "n"], Int[np.ndarray, "n"]], np.ndarray]
"""Returns actions for the worlds' observations, their episodes, and their step counts."""


@dataclass(frozen=True)
class Played:
    """Solved episodes, the actions of each if kept, and the number of failed worlds."""

    solved: Bool[np.ndarray, "e"]
    actions: Sequence[np.ndarray] = ()
    failed: int = 0


def parser() -> argparse.ArgumentParser:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument("--policy", default="reach-clone", help=f"a shipped policy, or '{EXPERT}'")
    p.add_argument("--task", default="Reach")
    p.add_argument("--scenes", default="starter", help="a fixed scene source of TabletopEnv")
    p.add_argument("--objects", type=int, default=8, help="maximum number of objects per scene")
    p.add_argument("--episodes", type=int, default=500)
    p.add_argument("--worlds", type=int, default=16)
    p.add_argument("--device", default="cpu")
    p.add_argument("--seed", type=int, default=0)
    p.add_argument("--note", default="", help="a remark about the run")
    p.add_argument("--out", type=Path, default=HERE / "results")
    return p


def scenes_within(scenes: str, most: int) -> list[Scene]:
    """Return fixed scenes with at most the given number of objects."""
    source = resolve(scenes)
    refs = source.refs if isinstance(source, FixedScenes) else ()
    return [scene for scene in (ref.load() for ref in refs) if len(scene.objects) <= most]


def play_single(
    env: TabletopBatchEnv,
    chosen: Sequence[int],
    scenes: Sequence[Scene],
    policy: TrainedPolicy | None,
) -> Played:
    """Play episodes of a batch one by one in ``TabletopEnv``; None is the expert."""
    single = make_env(list(scenes), task=env.task, randomization="starts")
    by_name = {scene.name: scene for scene in scenes}
    solved, played = [], []
    for row in chosen:
        name = env.bank.scenes[int(env.episodes.scene[row])]
        seen, _ = single.reset(seed=env.episodes.seeds[row], options={"scene": by_name[name]})
        expert = TaskExpert(single)
        if policy is None:
            expert.reset()
        held, over, actions = Held(), False, []
        while not over and len(actions) < time_limit(env.task):
            action = expert.act() if policy is None else policy.predict(seen)[0]
            actions.append(np.asarray(action, np.float32))
            seen, _, _, _, info = single.step(action)
            over = held.after(info)
        solved.append(over)
        played.append(np.array(actions))
    single.close()
    return Played(np.array(solved), played)


def play_batch(env: TabletopBatchEnv, chosen: Sequence[int], act: Act) -> Played:
    """Play the same episodes in the batch; finished worlds take the next ones."""
    rows, count = np.asarray(chosen), env.num_envs
    solved, failures = np.zeros(len(rows), bool), 0
    place, coming = np.arange(count) % len(rows), min(count, len(rows))
    busy = np.arange(count) < coming
    steps, held = np.zeros(count, int), [Held() for _ in range(count)]
    seen, _ = env.reset(options={"episodes": rows[place]})
    while busy.any():
        seen, _, _, _, infos = env.step(torch.from_numpy(act(seen, place, steps)))
        steps += 1
        success, failed = (infos[name].cpu().numpy() for name in ("success", "failed"))
        for k in np.flatnonzero(busy):
            over = not failed[k] and held[k].after({"success": success[k]})
            solved[place[k]] |= over
            failures += int(failed[k])
            busy[k] = not (over or failed[k] or steps[k] >= time_limit(env.task))
        free = np.flatnonzero(~busy)[: len(rows) - coming]
        if len(free):
            place[free] = np.arange(coming, coming + len(free))
            coming += len(free)
            busy[free], steps[free] = True, 0
            for k in free:
                held[k] = Held()
            mask = np.isin(np.arange(count), free)
            seen, _ = env.reset(options={"reset_mask": mask, "episodes": rows[place]})
    return Played(solved, failed=failures)


def replay(actions: Sequence[np.ndarray]) -> Act:
    """Return a policy that replays each episode's actions, and holds still after the last."""

    def act(seen: Any, place: np.ndarray, steps: np.ndarray) -> np.ndarray:
        del seen
        own = [actions[p] for p in place]
        now = np.array([a[min(k, len(a) - 1)] for a, k in zip(own, steps, strict=True)])
        now[[k >= len(a) for a, k in zip(own, steps, strict=True)], :-1] = 0.0
        return now

    return act


def measure(args: argparse.Namespace) -> Row:
    """Play one policy in both environments; return the row of the table."""
    begin = time.perf_counter()
    policy = None
    if args.policy != EXPERT:
        policy = load_policy(args.policy)
    scenes = scenes_within(args.scenes, args.objects)
    with closing(TabletopBatchEnv(
        args.worlds, scenes, args.task, args.device, max_objects=args.objects,
        deck=DeckConfig(episodes=-(-args.episodes // len(scenes)), seed=args.seed),
        max_episode_steps=10_000, randomization="starts",
    )) as env:  # fmt: skip
        table = env.episodes.scene.cpu().numpy()
        first = np.searchsorted(table, table)  # group rows by scene
        chosen = np.argsort(np.arange(len(table)) - first, kind="stable")[: args.episodes]
        single = play_single(env, chosen.tolist(), scenes, policy)
        act = replay(single.actions) if policy is None else acting(policy)
        batch = play_batch(env, chosen.tolist(), act)
        count = len({*table[chosen].tolist()})
    return {
        "policy": args.policy, "task": args.task, "scenes": args.scenes, "tables": count,
        "episodes": len(chosen), "single": int(single.solved.sum()),
        "batch": int(batch.solved.sum()),
        "single_alone": int((single.solved & ~batch.solved).sum()),
        "batch_alone": int((batch.solved & ~single.solved).sum()), "failed": batch.failed,
        "minutes": f"{(time.perf_counter() - begin) / 60:.1f}",
        "where": f"{args.device}, {tables.where()}" + (f"; {args.note}" if args.note else ""),
        "options": f"--policy {args.policy} --task {args.task} --scenes {args.scenes} "
        f"--episodes {args.episodes} --worlds {args.worlds} --device {args.device}",
    }  # fmt: skip


def acting(policy: TrainedPolicy) -> Act:
    """Return a policy's actions for the worlds' observations."""
    return lambda seen, place, steps: policy.predict(seen.cpu().numpy())[0]


def summary(rows: Sequence[Row]) -> str:
    """Return the table as Markdown."""
    lines = [
        "# One policy in two environments", "",
        "The same episodes in `TabletopEnv` and in `TabletopBatchEnv` (MuJoCo Warp): tables, "
        "targets, goals and starts are equal, simulation differs. The expert's actions are "
        "replayed open-loop in the batch, so its row reflects only physics. Interval of a share: "
        "Wilson, 95 %; of the difference: Newcombe (1998, method 10), 95 %, which treats the "
        "episodes as unpaired and is therefore too wide; p: McNemar's exact test of the episodes "
        "that only one environment solves.", "",
        "| policy | task | episodes | tables | `TabletopEnv` | batch | batch - single | solved "
        "in only one (single, batch) | p | failed worlds | minutes |",
        "|---|---|---|---|---|---|---|---|---|---|---|",
    ]  # fmt: skip
    for row in rows:
        count, single, batch = (int(row[name]) for name in ("episodes", "single", "batch"))
        alone = int(row["single_alone"]), int(row["batch_alone"])
        low, high = newcombe(batch, count, single, count)
        p = binomtest(alone[0], sum(alone)).pvalue if sum(alone) else 1.0
        lines.append(
            f"| {row['policy']} | {row['task']} | {count} | {row['tables']} | "
            f"{share(single, count)} | {share(batch, count)} | "
            f"{100 * (batch - single) / count:+.1f} points ({100 * low:+.1f} to {100 * high:+.1f}) "
            f"| {alone[0]}, {alone[1]} | {p:.2f} | {row['failed']} | {row['minutes']} |"
        )
    lines += ["", *(
        f"- `python benchmarks/two_environments.py {row['options']}`, {row['where']}"
        for row in rows
    )]  # fmt: skip
    return "\n".join([*lines, ""])


def share(solved: int, count: int) -> str:
    """Return a share with its interval."""
    low, high = wilson(solved, count)
    return f"{solved}, {100 * solved / count:.1f} % ({100 * low:.1f} to {100 * high:.1f} %)"


def main() -> None:
    args = parser().parse_args()
    args.out.mkdir(parents=True, exist_ok=True)
    path = args.out / "two_environments.csv"
    new = measure(args)
    kept = [
        row for row in tables.resume(path, FIELDS, KEY)
        if any(str(row[name]) != str(new[name]) for name in KEY)
    ]  # fmt: skip
    rows = [*kept, new]
    tables.write(path, FIELDS, rows)
    text = summary(rows)
    (args.out / "two_environments.md").write_text(text, encoding="utf-8")
    print(text)


if __name__ == "__main__":
    main()
