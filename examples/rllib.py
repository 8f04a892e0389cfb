"""Train Reach with PPO of Ray's RLlib, on this machine or on a cluster.

    pip install 'tabletopgen[ray]' 'ray[rllib]'
    python examples/rllib.py
    python examples/rllib.py --runners 16 --address auto

Prints the mean return of the episodes of each iteration, and saves the algorithm to ``--out``. The
24 iterations, 49,152 steps, increased it from 9.6 to 15.2 (one seed, one runner, 9 minutes on two
busy cores): it improves, but does not solve the task by then. The script uses RLlib's new API stack
and was tested with Ray 2.60, which needs Gymnasium 1.2.2. All machines need the same versions of
all packages.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import gymnasium as gym

NAME = "tabletop-reach"


def make_env(config: Mapping[str, Any]) -> gym.Env[Any, Any]:
    """Return the environment of an env runner; ``config`` has its keyword arguments."""
    return gym.make("tabletopgen_env:TabletopGen/Reach-v0", **config)


def configure(args: argparse.Namespace) -> Any:
    """Return PPO's settings: those of the recipe reach-ppo where RLlib has an equivalent."""
    from ray.rllib.algorithms.ppo import PPOConfig  # pyright: ignore[reportMissingImports]
    from ray.rllib.core.rl_module.default_model_config import (  # pyright: ignore[reportMissingImports]
        DefaultModelConfig,
    )

    keywords = {"scenes": args.scenes, "randomization": "starts"}
    return (
        PPOConfig()
        .environment(NAME, env_config=keywords, disable_env_checking=True)
        .env_runners(num_env_runners=args.runners, num_envs_per_env_runner=args.envs)
        .training(
            train_batch_size_per_learner=args.steps, minibatch_size=min(256, args.steps),
            num_epochs=8, lr=5e-4, gamma=0.95, lambda_=0.95, clip_param=0.2, vf_clip_param=100.0,
        )
        .rl_module(
            model_config=DefaultModelConfig(
                fcnet_hiddens=[128, 128], fcnet_activation="tanh", vf_share_layers=False,
                free_log_std=True,
            )
        )
        .debugging(seed=args.seed, log_level="ERROR")
    )  # fmt: skip


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--iterations", type=int, default=24)
    parser.add_argument("--steps", type=int, default=2048, help="environment steps per iteration")
    parser.add_argument("--runners", type=int, default=1, help="processes that run environments")
    parser.add_argument("--envs", type=int, default=4, help="environments per process")
    parser.add_argument("--scenes", default="starter:train")
    parser.add_argument(
        "--address",
        default="local",
        help="address of a Ray cluster; Ray is started locally by default",
    )
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, help="folder for the trained algorithm")
    args = parser.parse_args()
    try:
        import ray  # pyright: ignore[reportMissingImports]
        from ray.tune.registry import register_env  # pyright: ignore[reportMissingImports]
    except ImportError:
        print("RLlib is not installed. Run: pip install 'tabletopgen[ray]' 'ray[rllib]'")
        return 1
    ray.init(address=args.address, log_to_driver=False)
    register_env(NAME, make_env)
    algorithm = configure(args).build_algo()
    try:
        for number in range(1, args.iterations + 1):
            seen = algorithm.train()["env_runners"]
            print(
                f"iteration {number}: return {seen['episode_return_mean']:.2f} in "
                f"{seen['num_episodes_lifetime']:.0f} episodes, "
                f"{seen['num_env_steps_sampled_lifetime']:.0f} steps",
                flush=True,
            )
        if args.out is not None:
            algorithm.save_to_path(str(args.out.absolute()))
    finally:
        algorithm.stop()
        ray.shutdown()
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
