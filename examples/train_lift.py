"""Clone the expert's Lift into an SB3 policy on fresh tables: python examples/train_lift.py."""

import sys

import gymnasium as gym
from stable_baselines3 import SAC

from tabletopgen_env.learning.demonstrations.cloning import CloningConfig, clone
from tabletopgen_env.learning.networks.network import TableExtractor


def main(rounds: int = 8, episodes: int = 100, steps: int = 2000) -> None:
    lift = "tabletopgen_env:TabletopGen/Lift-v0"
    env = gym.make(lift, scenes="refreshing", grasp_hint="detected")
    network = {"features_extractor_class": TableExtractor, "net_arch": [256, 256, 256]}
    model = SAC("MlpPolicy", env, policy_kwargs=network, seed=0, buffer_size=1)
    clone(model, env, CloningConfig(rounds, episodes, steps=steps, last_steps=4 * steps), 0, print)
    model.save("out/lift.zip")
    env.close()


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
