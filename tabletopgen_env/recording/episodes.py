"""Expert episodes to be recorded, played in this process or in several others."""

from __future__ import annotations

import atexit
from collections import deque
from collections.abc import Generator, Mapping, Sequence
from concurrent.futures import Future
from contextlib import closing
from dataclasses import dataclass
from functools import partial
from itertools import count
from typing import Any

import cloudpickle
import gymnasium as gym
import numpy as np
from jaxtyping import Float, Shaped

from generator.errors import SceneError
from generator.jobs.pools import pool_of
from generator.jobs.task_pool import call_once

from ..learning.demonstrations.recorded import Demonstration, demonstrate
from ..observations.proprioception import SHARED, feel
from .config import RecordConfig
from .summaries import RowSummary, summarize, summarize_colors, summarize_depth

CHUNK = 4
"""Maximum number of episodes that a process plays before it returns them."""

Column = Shaped[np.ndarray, "t1 ..."] | list[str]
Columns = dict[str, Column | dict[str, Column | dict[str, Column]]]
"""Arrays or lists of strings with one row per step, by name, nested at most twice."""


@dataclass(frozen=True, eq=False)
class RecordedEpisode:
    """The ``number``-th played episode, with ``t`` steps; see the package docstring."""

    number: int
    observations: Shaped[np.ndarray, "t1 ..."] | dict[str, Shaped[np.ndarray, "t1 ..."] | list[str]]
    actions: Float[np.ndarray, "t a"]
    rewards: Float[np.ndarray, "t"]
    proprio: Float[np.ndarray, "t1 p"]
    infos: Columns
    facts: Mapping[str, str | int | bool]

    @property
    def state(self) -> Float[np.ndarray, "t1 s"] | None:
        """The flat state before each step and after the last one, or None if it is unknown."""
        seen = self.observations
        return seen.get("state") if isinstance(seen, dict) else seen  # type: ignore[return-value]

    @property
    def pictures(self) -> dict[str, Shaped[np.ndarray, "t1 h w *c"]]:
        """The pictures, keyed by observation key."""
        seen = self.observations if isinstance(self.observations, dict) else {}
        return {n: rows for n, rows in seen.items() if not isinstance(rows, list) and rows.ndim > 2}

    @property
    def cameras(self) -> dict[str, dict[str, Float[np.ndarray, "t1 _ _"]]]:
        """The ``intrinsics`` and ``extrinsics`` of each camera."""
        return self.infos.get("cameras", {})  # type: ignore[return-value]

    @property
    def arrays(self) -> dict[str, Any]:
        """All arrays that have one row per step, keyed by name."""
        steps = len(self.rewards)
        return {
            "observations": self.observations,
            "actions": self.actions,
            "rewards": self.rewards,
            "terminations": np.zeros(steps, bool),
            "truncations": np.arange(1, steps + 1) == steps,
            "infos": {**self.infos, "proprio": self.proprio},
        }

    def summaries(self) -> dict[str, RowSummary]:
        """Return summaries of actions, rewards, proprioception and observations, keyed by name.

        Colours are in [0, 1], depth is in metres, and labels have no summary.
        """
        rows = {"actions": self.actions, "rewards": self.rewards, "proprio": self.proprio}
        found = {name: summarize(values) for name, values in rows.items()}
        if self.state is not None:
            nested = isinstance(self.observations, dict)
            found["observations/state" if nested else "observations"] = summarize(self.state)
        for name, pictures in self.pictures.items():
            if pictures.ndim == 4:
                found[f"observations/{name}"] = summarize_colors(pictures)
            elif pictures.dtype == np.float32:
                found[f"observations/{name}"] = summarize_depth(pictures)
        return found


def play_episodes(
    config: RecordConfig,
    env: gym.Env[Any, Any],
    workers: int,
    ray: str | None = None,
    first: int = 0,
) -> Generator[RecordedEpisode | SceneError, None, None]:
    """Yield recorded episodes indefinitely; for each discarded one, yield an error with the reason.

    The first episode has the number ``first``. The episodes do not depend on the number of
    ``workers``, or on whether these run on the Ray cluster at the address ``ray``; a single local
    worker plays in ``env``. Close the generator at the end.

    Raises:
        BackendError: Ray is not available.
        SceneError: a process ended unexpectedly.
    """
    if workers == 1 and ray is None:
        yield from (_attempt(config, env, number) for number in count(first))
    make = cloudpickle.dumps(partial(_environment, config))
    few = min(CHUNK, -(-config.episodes // workers))
    with closing(pool_of(workers, ray)) as pool:
        numbers, begun = count(first, few), count(first, few)
        ahead: deque[Future[list[RecordedEpisode | SceneError]]] = deque()
        for done in numbers:
            # assuming that all of them are kept
            wanted = max(-(-(config.episodes + first - done) // few), 1)
            while len(ahead) < min(2 * workers, wanted):
                ahead.append(pool.submit(_chunk, config, make, next(begun), few))
            yield from ahead.popleft().result()


def _environment(config: RecordConfig) -> gym.Env[Any, Any]:
    """Return the environment of a worker process, open until the process ends."""
    env = config.environment()
    atexit.register(env.close)
    return env


def _chunk(
    config: RecordConfig, make: bytes, first: int, few: int
) -> list[RecordedEpisode | SceneError]:
    """Create the environment with pickled ``make``; play ``few`` episodes from number ``first``."""
    env = call_once(make)
    return [_attempt(config, env, first + k) for k in range(few)]


def _attempt(
    config: RecordConfig, env: gym.Env[Any, Any], number: int
) -> RecordedEpisode | SceneError:
    """Play one episode; return it, or the reason why it is not kept."""
    seed = int(np.random.default_rng((config.seed, number)).integers(2**31))
    infos: list[dict[str, Any]] = []
    felt: list[np.ndarray] = []

    def watch(info: dict[str, Any]) -> None:
        infos.append(info)
        felt.append(feel(env.get_wrapper_attr("world")))

    try:
        shown = demonstrate(env, seed, noise=config.noise, report=watch)
    except SceneError as error:
        return error
    if shown is None:
        return SceneError(f"the expert found no plan for {infos[0]['instruction']!r}")
    if not (shown.solved or config.keep_failures):
        return SceneError(f"the expert did not solve {shown.instruction!r}")
    digest = env.get_wrapper_attr("world").digest
    return recorded_episode(number, seed, shown, infos, felt, digest)


def recorded_episode(
    number: int,
    seed: int,
    shown: Demonstration,
    infos: Sequence[Mapping[str, Any]],
    felt: Sequence[np.ndarray],
    digest: str,
) -> RecordedEpisode:
    """Return an episode in the form that datasets store.

    Args:
        number: number of the episode among those played.
        seed: seed of its reset.
        shown: its observations and actions.
        infos: infos of its reset and of each step.
        felt: proprioception at its reset and after each step (``observations.proprioception``).
        digest: digest of the table and its objects.
    """
    facts = {
        "seed": seed,
        "instruction": shown.instruction,
        "scene": infos[0]["scene"],
        "digest": digest,
        "target": infos[0]["target"] or "",
        "goal": infos[0]["goal"] or "",
        "certified": infos[0]["certified"],
        "success": shown.solved,
        "steps": len(shown.actions),
    }
    seen = _plain(shown.observations)
    proprio = _proprio(seen, np.stack(felt))
    return RecordedEpisode(
        number, seen, shown.actions, shown.rewards, proprio, _columns(infos), facts
    )


def _proprio(seen: Any, felt: Float[np.ndarray, "t1 p"]) -> Float[np.ndarray, "t1 p"]:
    """Return the proprioception, with the same sensor errors as in the observations."""
    if isinstance(seen, dict) and "proprio" in seen:
        return seen["proprio"]
    state = seen["state"] if isinstance(seen, dict) else seen
    return np.hstack([state[:, :SHARED], felt[:, SHARED:]])


def _plain(observations: Any) -> Any:
    """Return observations with arrays of strings converted to lists."""
    if not isinstance(observations, dict):
        return observations
    return {
        n: rows.tolist() if rows.dtype.kind == "U" else rows for n, rows in observations.items()
    }


def _columns(infos: Sequence[Mapping[str, Any]]) -> Columns:
    """Return the stored columns of an episode's infos, without the proprioception."""
    terms = {
        name: np.array([info["reward_terms"][name] for info in infos], np.float32)
        for name in infos[0]["reward_terms"]
    }
    cameras: dict[str, Column | dict[str, Column]] = {
        name: {part: np.stack([info["cameras"][name][part] for info in infos]) for part in parts}
        for name, parts in infos[0].get("cameras", {}).items()
    }
    seen: Columns = {"cameras": cameras} if cameras else {}
    return seen | {
        "success": np.array([info["success"] for info in infos], bool),
        "goal_index": np.array([info["goals"][0] for info in infos], np.int64),
        "target": [info["target"] or "" for info in infos],
        "goal": [info["goal"] or "" for info in infos],
        "instruction": [info["instruction"] for info in infos],
        "reward_terms": {**terms},
    }
