"""Train with Stable-Baselines3: SAC with hindsight replay on goals, or PPO on the flat state.

python examples/train_sb3.py --algorithm sac --steps 5000

A few thousand steps show that everything runs; they do not make a policy that solves the task.
Needs ``pip install 'tabletopgen[train]'``.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import gymnasium as gym
import torch
from stable_baselines3 import PPO, SAC, HerReplayBuffer
from stable_baselines3.common.base_class import BaseAlgorithm
from stable_baselines3.common.env_util import make_vec_env

ENV = "tabletopgen_env:TabletopGen/PickPlace-v0"


def make_model(algorithm: str, seed: int, scenes: str) -> BaseAlgorithm:
    """Return an untrained agent with its environment."""
    if algorithm == "sac":
        env = gym.make(ENV, scenes=scenes, observation="goal", reward="dense")
        return SAC(
            "MultiInputPolicy",
            env,
            replay_buffer_class=HerReplayBuffer,
            replay_buffer_kwargs={"n_sampled_goal": 4, "goal_selection_strategy": "future"},
            learning_starts=1000,
            seed=seed,
            verbose=1,
        )
    envs = make_vec_env(ENV, n_envs=2, seed=seed, env_kwargs={"scenes": scenes})
    return PPO("MlpPolicy", envs, n_steps=512, batch_size=256, seed=seed, verbose=1)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--algorithm", choices=("sac", "ppo"), default="sac")
    parser.add_argument("--steps", type=int, default=5000)
    parser.add_argument("--scenes", default="starter")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=Path("out/policy.zip"))
    args = parser.parse_args()

    torch.set_num_threads(1)  # small networks are faster on one thread
    model = make_model(args.algorithm, args.seed, args.scenes)
    model.learn(args.steps, progress_bar=False)
    args.out.parent.mkdir(parents=True, exist_ok=True)
    model.save(args.out)
    print(f"{args.steps} steps of {args.algorithm}; policy in {args.out}")


if __name__ == "__main__":
    main()
