"""Train Lift at tables that are renewed while training goes on: python examples/train_lift.py."""

import sys

import gymnasium as gym
from stable_baselines3 import SAC


def main(steps: int = 200_000) -> None:
    env = gym.make("tabletopgen_env:TabletopGen/Lift-v0", scenes="refreshing")
    model = SAC("MlpPolicy", env, seed=0, buffer_size=steps, verbose=1)
    model.learn(steps)
    model.save("out/lift.zip")
    env.close()


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
