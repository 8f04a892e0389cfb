"""A random agent: a minimal loop over the environment."""

from __future__ import annotations

import gymnasium as gym


def main() -> None:
    env = gym.make("tabletopgen_env:TabletopGen/PickPlace-v0", scenes="starter")
    env.action_space.seed(0)
    _, info = env.reset(seed=0)
    print(info["instruction"])
    total = 0.0
    for _ in range(200):
        _, reward, terminated, truncated, info = env.step(env.action_space.sample())
        total += float(reward)
        if terminated or truncated:
            break
    print(f"return {total:.2f}, success {info['success']}")
    print({name: round(float(value), 3) for name, value in info["reward_terms"].items()})
    env.close()


if __name__ == "__main__":
    main()
