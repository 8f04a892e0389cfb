"""Recorded episodes, played by the expert or by a policy, with the expert's actions as labels."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import gymnasium as gym
import numpy as np
from jaxtyping import Float

from generator.errors import SceneError

from ...episodes import Held
from ...expert.run import TaskExpert

if TYPE_CHECKING:
    from .teacher import Teacher

PATIENCE = 4.0
"""Factor on the expert's time limits (``patience``) in episodes in which a learner acts."""

Policy = Callable[[Any], Float[np.ndarray, "a"]]
"""A function from an observation to an action."""


@dataclass(frozen=True, eq=False)
class Demonstration:
    """One episode, with observations, the expert's advice, actions and rewards.

    ``observations`` is an array (t + 1, o), one row longer than the other arrays, or a dict of such
    arrays for dict observations. ``solved`` is true if the episode ended in success.
    """

    observations: Any
    advice: Float[np.ndarray, "t a"]
    actions: Float[np.ndarray, "t a"]
    rewards: Float[np.ndarray, "t"]
    solved: bool
    instruction: str

    def observation(self, step: int) -> Any:
        """Return the observation before step ``step``, or the final one if ``step`` is t."""
        if isinstance(self.observations, dict):
            return {name: part[step] for name, part in self.observations.items()}
        return self.observations[step]


def _teacher(env: gym.Env[Any, np.ndarray]) -> Teacher:
    from .teacher import Teacher  # imports torch

    return Teacher(env)


def demonstrate(
    env: gym.Env[Any, np.ndarray],
    seed: int,
    policy: Policy | None = None,
    noise: float = 0.0,
    report: Callable[[dict[str, Any]], None] | None = None,
    to_the_limit: bool = False,
    taught: bool = False,
) -> Demonstration | None:
    """Play an "ee_delta" episode with the expert's advice; return None if the expert has no plan.

    The episode ends when success has held (``episodes.Held``) or at the time limit; with
    ``to_the_limit`` only at the time limit. ``policy`` acts, or the expert if ``policy`` is None.
    ``noise`` is the standard deviation of the noise added to the expert's motion (not to the
    gripper), so that the data covers recovery. ``report`` receives the info of ``reset`` and of
    each step. With ``taught``, observations are converted by a ``teacher.Teacher``, including those
    passed to the policy.
    """
    rng = np.random.default_rng((seed, 1))
    seen, info = env.reset(seed=seed)
    if report:
        report(info)
    teacher = _teacher(env) if taught else None
    see = teacher.see if teacher else (lambda seen: seen)
    seen = see(seen)
    expert = TaskExpert(teacher or env, 1.0 if policy is None else PATIENCE)
    try:
        expert.reset()
    except SceneError:
        return None
    shown, advised, done, earned = [seen], [], [], []
    held, over, solved = Held(), False, False
    while not over and (to_the_limit or not solved):
        advice = expert.act()
        action = advice if policy is None else policy(seen)
        if policy is None and noise:
            shaken = advice[:-1] + rng.normal(0.0, noise, len(advice) - 1)
            action = np.append(np.clip(shaken, -1, 1), advice[-1]).astype(np.float32)
        seen, reward, ended, cut, info = env.step(action)
        seen = see(seen)
        over, solved = ended or cut, held.after(info)
        if report:
            report(info)
        shown.append(seen)
        advised.append(advice)
        done.append(action)
        earned.append(reward)
    return Demonstration(
        stack(shown), np.asarray(advised, np.float32), np.asarray(done, np.float32),
        np.asarray(earned, np.float32), solved, info["instruction"],
    )  # fmt: skip


def stack(seen: Sequence[Any]) -> Any:
    """Stack observations along a new first axis; dict observations give a dict of arrays."""
    if isinstance(seen[0], Mapping):
        return {name: stack([each[name] for each in seen]) for name in seen[0]}
    return np.stack(seen)


def demonstrations(
    env: gym.Env[Any, np.ndarray],
    seeds: Iterator[int],
    count: int,
    policy: Policy | None = None,
    noise: float = 0.0,
    taught: bool = False,
) -> Iterator[Demonstration]:
    """Yield ``count`` demonstrations with seeds from ``seeds``; skip episodes without a plan.

    Raises:
        SceneError: the expert has no plan for a hundred seeds in a row.
    """
    missed = 0
    while count:
        found = demonstrate(env, next(seeds), policy, noise, taught=taught)
        if found is None:
            missed += 1
            if missed == 100:
                raise SceneError(
                    "The expert found no plan in 100 consecutive episodes; use other scenes."
                )
            continue
        missed = 0
        count -= 1
        yield found
