"""Many tables at once in one process: a Gymnasium vector environment on a few threads.

MuJoCo simulates without Python's lock, so threads are enough: nothing is copied between processes,
and every scene is compiled once, however many slots meet it::

    gymnasium.make_vec("tabletopgen_env:TabletopGen/PickPlace-v0", num_envs=16, threads=4)

Slots are environments of their own: each draws its scenes and goals with its own seed, and what it
does is bit for bit what a single environment with that seed does, whatever the number of threads.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable, Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, TypeVar, Unpack

import gymnasium as gym
import numpy as np
from gymnasium import spaces
from gymnasium.vector import AutoresetMode, SyncVectorEnv
from gymnasium.vector.utils import concatenate, create_empty_array, iterate
from gymnasium.wrappers import TimeLimit
from jaxtyping import Bool, Float

from generator.errors import InputError, require_known, require_number, require_seed
from generator.threads import cores

from .actions import check_action
from .env import as_options, make_env, played_at
from .scenes import SceneChoice, SharedScenes, resolve
from .settings import EnvConfig, Settings, check_settings, read_settings
from .tasks.task import Task
from .world.worlds import Masters

T = TypeVar("T")


@dataclass(frozen=True, eq=False)
class _Turn:
    """What one slot's step or reset gave; ``last`` is what was seen before a reset within it."""

    observation: Any
    info: dict[str, Any]
    reward: float = 0.0
    terminated: bool = False
    truncated: bool = False
    last: tuple[Any, dict[str, Any]] | None = None


class TabletopVectorEnv(SyncVectorEnv):
    """``num_envs`` environments stepped together, as ``gymnasium.vector.VectorEnv`` says.

    Arrays have one row a slot; infos have Gymnasium's vector format. ``reset`` takes one seed (slot
    k gets seed + k) or a list, the options of ``TabletopEnv.reset`` for all slots alike, and the
    option "reset_mask", an array of bools, to reset some slots only.

    A copy (``pickle``, ``copy.deepcopy``) has copies of the slots, as ``TabletopEnv`` says: all are
    to be reset first. A fork has no threads, and cannot step it; send it a pickled copy.

    Args:
        num_envs: how many slots.
        scenes: where tables come from, as for ``env.make_env``: one source for all slots, renewed
            and made harder for all together. A ``SceneSource`` is left to who made it; no other
            thread may draw from it meanwhile.
        task, preset: what to do; see ``env.make_env``.
        threads: how many threads step them; None for one a core. Each slot keeps to one thread,
            as OpenGL contexts have to.
        autoreset_mode: what follows an episode's end: "NextStep" (the next step resets the slot and
            its action is ignored), "SameStep" (the slot is reset at once; what it saw last is in
            ``info["final_obs"]`` and ``info["final_info"]``) or "Disabled" (reset it yourself).
        max_episode_steps: the time limit; None for none (the registered ids have theirs).
        settings: those of ``TabletopEnv``; ``cache`` is how many compiled worlds each slot keeps,
            and how many scenes all of them share.

    Raises:
        InputError: a setting is wrong.
        BundleError: no bundle fits ``scenes``.
    """

    def __init__(
        self,
        num_envs: int = 1,
        *,
        scenes: SceneChoice | None = None,
        task: Task | str = "PickPlace",
        preset: str | None = None,
        threads: int | None = None,
        autoreset_mode: str | AutoresetMode = AutoresetMode.NEXT_STEP,
        max_episode_steps: int | None = None,
        **settings: Unpack[Settings],
    ) -> None:
        counts = {"num_envs": num_envs, "threads": threads, "max_episode_steps": max_episode_steps}
        for name, count in counts.items():
            if count is not None or name == "num_envs":
                needs = f"A vector environment needs {name}"
                require_number(needs, count, minimum=1, integer=True)
        check_settings(settings, *counts, "autoreset_mode")
        config = read_settings(settings)
        worlds = config.worlds
        masters = worlds.masters or Masters(worlds.arm, worlds.cache)
        config = replace(config, worlds=replace(worlds, masters=masters))
        scenes, task = played_at(scenes, task, preset)
        source = resolve(scenes, task.needs, task.scenes)
        self._source = SharedScenes(source)
        self._closes_source = source is not scenes
        slot = partial(_slot, max_episode_steps, self._source, task, config)
        super().__init__([slot] * num_envs, autoreset_mode=_mode(autoreset_mode))
        self._hire(min(num_envs, threads or cores()))
        assert isinstance(self.single_action_space, spaces.Box)
        self._actions = self.single_action_space
        self._over = np.zeros(num_envs, bool)
        self._seen: list[Any] = [None] * num_envs

    # ---------------------------------------------------------------------------------- gymnasium

    def reset(
        self,
        *,
        seed: int | Sequence[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Any, dict[str, Any]]:
        """Reset all slots, or those of the option "reset_mask".

        If one of them fails, none of them has an episode: ``step`` asks for another reset.

        Raises:
            InputError: as ``TabletopEnv.reset``, or a wrong number of seeds, or a wrong mask.
        """
        options = as_options(options)
        mask = _mask(options.pop("reset_mask", None), self.num_envs)
        seeds = _seeds(seed, self.num_envs)

        def start(k: int) -> _Turn:
            return _Turn(*self._restart(k, seed=seeds[k], options=options or None))

        slots = np.flatnonzero(mask).tolist()
        turns = self._each(start, slots)
        self._over[mask] = False
        infos: dict[str, Any] = {}
        for k, turn in zip(slots, turns, strict=True):
            self._seen[k] = turn.observation
            infos = self._add_info(infos, turn.info, k)
        return self._batch(), infos

    def step(
        self, actions: Any
    ) -> tuple[
        Any, Float[np.ndarray, "n"], Bool[np.ndarray, "n"], Bool[np.ndarray, "n"], dict[str, Any]
    ]:
        """Step every slot, or reset it, as ``metadata["autoreset_mode"]`` says.

        Raises:
            InputError: an action of wrong shape or with NaN; no ``reset`` before, or one that
                failed; a slot whose episode is over, if autoreset is disabled.
        """
        if (given := _length(actions)) != self.num_envs:
            raise InputError(f"{self.num_envs} slots need as many actions, got {given}.")
        idle = [k for k, seen in enumerate(self._seen) if seen is None]
        if idle and not self.closed:
            raise InputError(f"Call reset() before stepping: the slots {idle} have no episode.")
        over = np.flatnonzero(self._over).tolist()
        if over and self.autoreset_mode == AutoresetMode.DISABLED and not self.closed:
            raise InputError(
                f"The episodes of the slots {over} are over and autoreset is disabled: call "
                "reset(options={'reset_mask': ...}) first."
            )
        chosen = [self._check(k, a) for k, a in enumerate(iterate(self.action_space, actions))]
        turns = self._each(lambda k: self._turn(k, chosen[k]), range(self.num_envs))
        infos: dict[str, Any] = {}
        for k, turn in enumerate(turns):
            self._seen[k] = turn.observation
            if turn.last is not None:
                final = {"final_obs": turn.last[0], "final_info": turn.last[1]}
                infos = self._add_info(infos, final, k)
            infos = self._add_info(infos, turn.info, k)
        terminated = np.array([turn.terminated for turn in turns])
        truncated = np.array([turn.truncated for turn in turns])
        if self.autoreset_mode != AutoresetMode.SAME_STEP:
            self._over = terminated | truncated
        rewards = np.array([turn.reward for turn in turns], np.float64)
        return self._batch(), rewards, terminated, truncated, infos

    def render(self) -> tuple[Any, ...]:
        """Return what each slot's ``render`` returns."""
        return tuple(self._each(lambda k: self.envs[k].render(), range(self.num_envs)))

    def call(self, name: str, *args: Any, **kwargs: Any) -> tuple[Any, ...]:
        """Call a method of each slot's environment, or get an attribute; return the results."""

        def work(k: int) -> Any:
            found = self.envs[k].get_wrapper_attr(name)
            return found(*args, **kwargs) if callable(found) else found

        return tuple(self._each(work, range(self.num_envs)))

    def close_extras(self, **kwargs: Any) -> None:
        """Close the slots, end the threads, and what ``scenes`` has running."""
        workers = getattr(self, "_workers", [])
        if workers and self._process == os.getpid():
            self._each(lambda k: self.envs[k].close(), range(self.num_envs))
            if self._closes_source:
                self._source.close()
        self._workers = []
        for worker in workers:
            worker.shutdown()

    def __getstate__(self) -> dict[str, Any]:
        """Return what a copy keeps: the slots as theirs do, and how many threads step them."""
        kept = {k: v for k, v in self.__dict__.items() if k != "_process"}
        fresh = {"_over": np.zeros_like(self._over), "_seen": [None] * self.num_envs}
        return {**kept, **fresh, "_workers": len(self._workers)}

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._hire(state["_workers"])

    # -------------------------------------------------------------------------------------- parts

    def _hire(self, count: int) -> None:
        """Set up the threads; they begin with their first work."""
        self._workers = [ThreadPoolExecutor(1, f"tabletop-{k}") for k in range(count)]
        self._process = os.getpid()

    def _check(self, k: int, action: Any) -> Float[np.ndarray, "a"]:
        """Return a sound action; all are looked at before any slot moves."""
        try:
            return check_action(action, self._actions)
        except InputError as error:
            raise _note(error, k) from None

    def _turn(self, k: int, action: Any) -> _Turn:
        """Step slot ``k``, or reset it if its episode is over."""
        env = self.envs[k]
        if self._over[k]:
            return _Turn(*self._restart(k))
        observation, reward, terminated, truncated, info = env.step(action)
        last = None
        if (terminated or truncated) and self.autoreset_mode == AutoresetMode.SAME_STEP:
            last = observation, info
            observation, info = self._restart(k)
        return _Turn(observation, info, float(reward), bool(terminated), bool(truncated), last)

    def _restart(self, k: int, **given: Any) -> tuple[Any, dict[str, Any]]:
        """Reset slot ``k``, which has nothing to show until that is done."""
        self._seen[k] = None
        return self.envs[k].reset(**given)

    def _each(self, work: Callable[[int], T], slots: Iterable[int]) -> list[T]:
        """Do each slot's work in its thread; raise the first slot's error once all are done."""
        if not self._workers:
            raise InputError("This vector environment is closed; make a new one.")
        if self._process != os.getpid():
            raise InputError(
                "This vector environment was made before the process was forked, and its threads "
                "are not here; make one here, or send a pickled copy."
            )
        slots = list(slots)
        count = len(self._workers)

        def work_off(mine: list[int]) -> dict[int, T | Exception]:
            return {k: _catch(work, k) for k in mine}

        shares = [[k for k in slots if k % count == w] for w in range(count)]
        jobs = [w.submit(work_off, s) for w, s in zip(self._workers, shares, strict=True) if s]
        done: dict[int, Any] = {}
        for job in jobs:
            done |= job.result()
        for k in slots:
            if isinstance(done[k], Exception):
                raise done[k]
        return [done[k] for k in slots]

    def _batch(self) -> Any:
        """Return the slots' observations as new arrays, one row a slot."""
        space = self.single_observation_space
        if any(seen is None for seen in self._seen):
            raise InputError("Reset all slots before some of them.")
        return concatenate(space, self._seen, create_empty_array(space, self.num_envs))


def _slot(limit: int | None, scenes: SceneChoice, task: Task, config: EnvConfig) -> gym.Env:
    env = make_env(scenes, task=task, **vars(config))
    return env if limit is None else TimeLimit(env, limit)


def _catch(work: Callable[[int], T], k: int) -> T | Exception:
    try:
        return work(k)
    except Exception as error:  # raised again by the caller's thread
        return _note(error, k)


def _note(error: Exception, k: int) -> Exception:
    error.add_note(f"(in slot {k} of the vector environment)")
    return error


def _mode(mode: str | AutoresetMode) -> AutoresetMode:
    if not isinstance(mode, AutoresetMode):
        require_known(mode, [m.value for m in AutoresetMode], "Unknown autoreset mode")
    return AutoresetMode(mode)


def _seeds(seed: int | Sequence[int | None] | None, count: int) -> list[int | None]:
    if seed is None:
        return [None] * count
    if isinstance(seed, int | np.integer):
        require_seed(seed)
        return [int(seed) + k for k in range(count)]
    if (given := _length(seed)) != count:
        raise InputError(f"{count} slots need one seed or {count}, got {given}.")
    return list(seed)


def _length(given: Any) -> int | str:
    """Return how many were given, or, of what has no length, how it reads."""
    try:
        return len(given)
    except TypeError:
        return repr(given)


def _mask(mask: Any, count: int) -> Bool[np.ndarray, "n"]:
    if mask is None:
        return np.ones(count, bool)
    mask = np.asarray(mask)
    if mask.shape != (count,) or mask.dtype != bool or not mask.any():
        raise InputError(
            f"reset_mask must be an array of {count} bools, one of them True, got {mask.tolist()}."
        )
    return mask
