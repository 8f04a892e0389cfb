"""Run the scripted expert on the starter tables; write a film strip of one episode.

python examples/expert.py --episodes 5 --out out/expert.png
"""

from __future__ import annotations

import argparse
from pathlib import Path
from typing import Any

import gymnasium as gym
import numpy as np
from PIL import Image

from generator.render.sheet import grid
from tabletopgen_env.episodes import Held
from tabletopgen_env.expert.run import TaskExpert


def play(env: gym.Env, seed: int, **options: Any) -> tuple[bool, str, list[Any]]:
    """Run one episode of the expert; return success, the instruction and the frames."""
    _, info = env.reset(seed=seed, options=options or None)
    expert = TaskExpert(env)
    expert.reset()
    frames, held = [env.render()], Held()
    solved = over = False
    while not (solved or over):
        _, _, terminated, truncated, info = env.step(expert.act())
        frames.append(env.render())
        solved, over = held.after(info), terminated or truncated
    return solved, info["instruction"], frames


def play_until_solved(
    scenes: str, tries: int, size: tuple[int, int] = (240, 320)
) -> tuple[bool, str, list[Any]]:
    """Run up to ``tries`` episodes until the expert solves one; return the last, like ``play``."""
    env = gym.make(
        "tabletopgen_env:TabletopGen/PickPlace-v0",
        scenes=scenes,
        render_mode="rgb_array",
        render_size=size,
    )
    try:
        for seed in range(tries):
            success, instruction, frames = play(env, seed)
            if success:
                break
        return success, instruction, frames
    finally:
        env.close()


def film_strip(frames: list[np.ndarray], count: int = 6) -> np.ndarray:
    """Lay ``count`` evenly spaced frames side by side."""
    picks = np.linspace(0, len(frames) - 1, count).round().astype(int)
    return grid([frames[k] for k in picks], columns=count, cell=320)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--episodes", type=int, default=5)
    parser.add_argument("--scenes", default="starter")
    parser.add_argument("--out", type=Path, default=Path("out/expert.png"))
    args = parser.parse_args()

    env = gym.make(
        "tabletopgen_env:TabletopGen/PickPlace-v0",
        scenes=args.scenes,
        render_mode="rgb_array",
        render_size=(240, 320),
    )
    solved = 0
    for seed in range(args.episodes):
        success, instruction, frames = play(env, seed)
        solved += success
        print(f"{'solved' if success else 'failed'} in {len(frames) - 1:3d} steps: {instruction}")
        if seed == 0:
            args.out.parent.mkdir(parents=True, exist_ok=True)
            Image.fromarray(film_strip(frames)).save(args.out)
    print(f"{solved} of {args.episodes}; film strip in {args.out}")
    env.close()


if __name__ == "__main__":
    main()
