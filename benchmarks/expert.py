"""The scripted expert over scenes: success by scene, steps, and what failed.

python benchmarks/expert.py --episodes 100 --scenes starter
"""

from __future__ import annotations

import argparse
import datetime
import os
import platform
import sys
from collections import defaultdict
from pathlib import Path

import gymnasium as gym
import numpy as np

from generator.errors import SceneError
from tabletopgen_env.expert.run import TaskExpert

HERE = Path(__file__).parent


def episode(env: gym.Env, seed: int, hold: int = 10) -> tuple[bool, int, str, str]:
    """Run one episode; return success (held for ``hold`` steps), steps, scene and instruction."""
    _, info = env.reset(seed=seed)
    scene, instruction = info["scene"], info["instruction"]
    expert = TaskExpert(env)
    try:
        expert.reset()
    except SceneError:
        return False, 0, scene, instruction
    held = steps = 0
    truncated = False
    while held < hold and not truncated:
        _, _, _, truncated, info = env.step(expert.act())
        held = held + 1 if info["success"] else 0
        steps += 1
    return held >= hold, steps, scene, instruction


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--episodes", type=int, default=100)
    parser.add_argument("--scenes", default="starter")
    parser.add_argument("--first-seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=HERE / "results" / "expert.md")
    args = parser.parse_args()

    env = gym.make("tabletopgen_env:TabletopGen/PickPlace-v0", scenes=args.scenes)
    by_scene: dict[str, list[bool]] = defaultdict(list)
    lengths, failed = [], []
    for seed in range(args.first_seed, args.first_seed + args.episodes):
        success, steps, scene, instruction = episode(env, seed)
        by_scene[scene].append(success)
        if success:
            lengths.append(steps)
        else:
            failed.append(f"seed {seed}, {scene}: {instruction}")
    env.close()
    solved = sum(map(sum, by_scene.values()))
    command = "python benchmarks/" + " ".join([Path(sys.argv[0]).name, *sys.argv[1:]])
    lines = [
        f"# Expert: {solved} of {args.episodes} episodes",
        f"`{command}`, {platform.machine()}, {os.cpu_count()} cores, {datetime.date.today()}",
        "",
        f"Median length of a solved episode: {np.median(lengths):.0f} steps of 50 ms.",
        "",
        "| scene | solved | episodes |",
        "|---|---|---|",
        *(f"| {name} | {sum(runs)} | {len(runs)} |" for name, runs in sorted(by_scene.items())),
        "",
        *(["Not solved:", *(f"- {line}" for line in failed), ""] if failed else []),
    ]
    args.out.parent.mkdir(parents=True, exist_ok=True)
    args.out.write_text("\n".join(lines))
    print("\n".join(lines))


if __name__ == "__main__":
    main()
