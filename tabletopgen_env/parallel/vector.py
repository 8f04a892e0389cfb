"""A Gymnasium vector environment whose slots run on threads or in several processes.

MuJoCo simulates without holding the GIL, so threads give some speed-up without copying data, and
each scene is compiled only once for all slots. The Python part of a step still runs on one core.
Processes use all cores, but each compiles the scenes of its own slots::

    gymnasium.make_vec("tabletopgen_env:TabletopGen/PickPlace-v0", num_envs=16, threads=4)
    gymnasium.make_vec("tabletopgen_env:TabletopGen/PickPlace-v0", num_envs=16, processes=4)

Slots are independent environments: each draws its scenes and goals with its own seed and behaves
bit for bit like a single environment with that seed, for any number of threads or processes. Only
the scenes may differ: those of "refreshing" depend on timing, those of a curriculum on the order in
which slots draw them.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass, replace
from functools import partial
from typing import Any, Unpack

import gymnasium as gym
import numpy as np
from gymnasium import spaces
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from gymnasium.wrappers import TimeLimit
from jaxtyping import Bool, Float

from generator.errors import InputError, require_number
from generator.threads import cores

from ..env import as_options, make_env, played_at
from ..scenes import SceneChoice, SharedScenes, resolve
from ..scenes.source import close
from ..settings import EnvConfig, Settings, check_settings, read_settings
from ..tasks.task import Task
from ..world.worlds import Masters
from .workers import pickling
from .workers.checks import check_actions, read_mask, read_mode, read_seeds
from .workers.joint import check_joint
from .workers.scene_server import AskedScenes, is_lent, shared_scene
from .workers.shards import ShardSlots, split_slots
from .workers.slots import Job, SlotRunner
from .workers.threads import ThreadSlots


@dataclass(frozen=True)
class Processes:
    """The number of processes, and whether each one steps its environments together."""

    count: int
    together: bool = False

    def __post_init__(self) -> None:
        require_number("processes", self.count, minimum=1, integer=True)


class TabletopVectorEnv(VectorEnv[Any, Any, Any]):
    """A ``gymnasium.vector.VectorEnv`` of ``num_envs`` environments that are stepped together.

    Arrays have one row per slot; infos have Gymnasium's vector format. ``reset`` takes one seed
    (slot k gets seed + k) or a list, the options of ``TabletopEnv.reset`` for all slots, and the
    option "reset_mask", an array of bools, to reset only some slots.

    A copy (``pickle``, ``copy.deepcopy``) has copies of the slots, as for ``TabletopEnv``; reset
    all of them before stepping. A forked process has neither the threads nor the processes and
    cannot step the environment; send it a pickled copy.

    With ``processes``, the scenes, the task, the settings, and arguments and results of ``call``
    and similar methods are sent between processes and must be picklable; ``envs`` is not available.
    An error in a slot is raised here unchanged. If a process is killed, the other processes and the
    vector environment are closed. The processes end with this one, however it ends.

    Args:
        num_envs: number of slots.
        scenes: source of the tables, as in ``env.make_env``: one source for all slots, with a
            common pool and a common curriculum. The caller keeps ownership of a ``SceneSource``; no
            other thread may draw from it meanwhile. With ``processes``, fixed and fresh scenes are
            drawn in each process; any other source stays in this process, which serves each draw.
        task, preset: the task; see ``env.make_env``.
        threads: number of threads; None for one per core. Each slot stays on one thread, as OpenGL
            contexts require.
        processes: number of worker processes with one thread each, among which the slots are split
            evenly; None for this process with ``threads``. See ``Processes``.
        autoreset_mode: behaviour at the end of an episode: "NextStep" (the next step resets the
            slot and ignores its action), "SameStep" (the slot is reset at once; its last
            observation is in ``info["final_obs"]`` and ``info["final_info"]``) or "Disabled" (the
            caller resets the slot). Members of Gymnasium's ``AutoresetMode`` and their names are
            accepted, too.
        max_episode_steps: the time limit; None for no limit (registered ids have a limit).
        settings: settings of ``TabletopEnv``; ``cache`` is the number of compiled worlds that each
            slot caches, and the number of scenes shared by all slots of a process.

    Raises:
        InputError: a setting is invalid, or cannot be sent to a process.
        BundleError: no bundle matches ``scenes``.
        WorkerDied: a process could not be started.
    """

    def __init__(
        self,
        num_envs: int = 1,
        *,
        scenes: SceneChoice | None = None,
        task: Task | str = "PickPlace",
        preset: str | None = None,
        threads: int | None = None,
        processes: int | Processes | None = None,
        autoreset_mode: str | AutoresetMode = AutoresetMode.NEXT_STEP,
        max_episode_steps: int | None = None,
        **settings: Unpack[Settings],
    ) -> None:
        shards = processes
        if not isinstance(shards, Processes | None):
            shards = Processes(shards)
        counts = {
            "num_envs": num_envs, "threads": threads, "max_episode_steps": max_episode_steps,
        }  # fmt: skip
        for name, count in counts.items():
            if count is not None or name == "num_envs":
                require_number(name, count, minimum=1, integer=True)
        if None not in (threads, shards):
            raise InputError(
                "A vector environment uses either threads or processes; set only one of "
                f"threads={threads} and processes={processes!r}."
            )
        check_settings(settings, *counts, "processes", "autoreset_mode")
        config = _share_worlds(read_settings(settings))
        if shards is not None and shards.together:
            check_joint(config)
        scenes, task = played_at(scenes, task, preset)
        self._source = source = resolve(scenes, task.needs, task.scenes)
        self._shared_scene = partial(
            shared_scene, needs=task.needs, start=task.scenes, processes=shards is not None
        )
        self._closes_source = source is not scenes
        self.autoreset_mode = read_mode(autoreset_mode)
        slot = partial(_slot, max_episode_steps, task, config)
        if shards is None:
            shared = SharedScenes(source)
            envs = [slot(shared) for _ in range(num_envs)]
            many = min(num_envs, threads or cores())
            self._runner: SlotRunner = ThreadSlots(envs, self.autoreset_mode, many)
        else:
            asked = AskedScenes() if is_lent(source) else None
            if shards.together:
                slot = partial(_slot, None, task, config)
            envs = [slot(asked or source) for _ in range(num_envs)]
            many = min(num_envs, shards.count)
            self._runner = ShardSlots(
                split_slots(
                    envs,
                    self.autoreset_mode,
                    many,
                    asked,
                    source,
                    shards.together,
                    max_episode_steps,
                )
            )
        self._process = os.getpid()
        self._describe(num_envs, envs[0])

    # ---------------------------------------------------------------------------------- gymnasium

    def reset(
        self,
        *,
        seed: int | Sequence[int | None] | None = None,
        options: dict[str, Any] | None = None,
    ) -> tuple[Any, dict[str, Any]]:
        """Reset all slots, or those selected by the option "reset_mask".

        If one of them fails, none of them has an episode, and ``step`` requires another reset.

        Raises:
            InputError: as for ``TabletopEnv.reset``, or the number of seeds or the mask is wrong.
        """
        options = as_options(options)
        mask = read_mask(options.pop("reset_mask", None), self.num_envs)
        seeds = read_seeds(seed, self.num_envs)
        if "scene" in options:
            options["scene"] = self._shared_scene(options["scene"])
        with self._running() as runner:
            playing = runner.arrays.playing
            try:
                infos = runner.reset({int(k): seeds[k] for k in np.flatnonzero(mask)}, options)
            except BaseException:
                playing[mask] = False
                raise
            if not playing.all():
                raise InputError("Reset all slots once before using reset_mask.")
            return runner.arrays.observe(), infos

    def step(
        self, actions: Any
    ) -> tuple[
        Any, Float[np.ndarray, "n"], Bool[np.ndarray, "n"], Bool[np.ndarray, "n"], dict[str, Any]
    ]:
        """Step every slot, or reset it, according to ``metadata["autoreset_mode"]``.

        Raises:
            InputError: an action has the wrong shape or contains NaN, ``reset`` was not called or
                failed, or an episode is over while autoreset is disabled.
            WorkerDied: a process of the slots has ended.
        """
        with self._running() as runner:
            self._check_playing()
            rows = runner.arrays
            rows.actions[:] = check_actions(actions, self.num_envs, self._actions)
            infos = runner.step()
            ends = rows.rewards.copy(), rows.terminated.copy(), rows.truncated.copy()
            return rows.observe(), *ends, infos

    def render(self) -> tuple[Any, ...]:
        """Return the result of each slot's ``render``."""
        return tuple(self.visit(pickling.render))

    def call(self, name: str, *args: Any, **kwargs: Any) -> tuple[Any, ...]:
        """Call a method of each slot's environment, or get an attribute; return the results."""
        return tuple(self.visit(partial(pickling.call, name=name, args=args, kwargs=kwargs)))

    def get_attr(self, name: str) -> tuple[Any, ...]:
        """Return an attribute of each slot's environment; if it is a method, call it."""
        return self.call(name)

    def set_attr(self, name: str, values: Any) -> None:
        """Set an attribute of each slot's environment; a list or tuple holds one value per slot.

        Raises:
            InputError: the number of values differs from the number of slots.
        """
        if not isinstance(values, list | tuple):
            values = [values] * self.num_envs
        if len(values) != self.num_envs:
            raise InputError(
                f"set_attr requires one value for each of the {self.num_envs} slots, got "
                f"{len(values)}."
            )
        with self._running() as runner:
            runner.visit(
                {k: partial(pickling.put, name=name, value=v) for k, v in enumerate(values)}
            )

    def visit(self, work: Job, slots: Iterable[int] | None = None) -> list[Any]:
        """Call a function on the environments of all or some slots; return the results.

        The function runs in the slot's thread or process.

        Raises:
            InputError: a slot does not exist, or the function or its result cannot be sent.
        """
        chosen = list(range(self.num_envs) if slots is None else slots)
        if wrong := [k for k in chosen if k not in range(self.num_envs)]:
            raise InputError(f"Slots must be from 0 to {self.num_envs - 1}, got {wrong}.")
        with self._running() as runner:
            return runner.visit(dict.fromkeys(chosen, work))

    def close_extras(self, **kwargs: Any) -> None:
        """Close the environments, end their threads or processes, and close ``scenes``."""
        if not hasattr(self, "_runner") or self._process != os.getpid():
            return
        try:
            self._runner.close()
        finally:
            if self._closes_source:
                close(self._source)

    @property
    def np_random(self) -> Any:
        """The slots' random generators, or copies of them if the slots run in processes."""
        return self.get_attr("np_random")

    @property
    def np_random_seed(self) -> Any:
        """The seeds of the slots' random generators."""
        return self.get_attr("np_random_seed")

    # -------------------------------------------------------------------------------------- slots

    @property
    def envs(self) -> list[gym.Env]:
        """The slots' environments; raises InputError if they are in other processes."""
        if isinstance(self._runner, ThreadSlots):
            return self._runner.slots.envs
        raise InputError(
            "The environments of this vector environment are in other processes; use call, "
            "get_attr, set_attr or visit."
        )

    @property
    def pids(self) -> tuple[int, ...]:
        """The ids of the slots' processes, in the order of slots; empty for threads."""
        return self._runner.pids if isinstance(self._runner, ShardSlots) else ()

    def __getstate__(self) -> dict[str, Any]:
        """Return the state to be pickled or copied; the slots of a copy have no episodes."""
        if self.pids:
            self._check_process()
        state = {k: v for k, v in self.__dict__.items() if k != "_process"}
        return state | ({"_runner": None} if self.closed else {})

    def __setstate__(self, state: dict[str, Any]) -> None:
        self.__dict__.update(state)
        self._process = os.getpid()

    # -------------------------------------------------------------------------------------- parts

    def _describe(self, count: int, slot: gym.Env) -> None:
        """Set the spaces and the metadata from a slot's environment."""
        assert isinstance(slot.action_space, spaces.Box)
        self.num_envs = count
        self.metadata = {**slot.metadata, "autoreset_mode": self.autoreset_mode}
        self.render_mode = slot.render_mode
        self._actions = self.single_action_space = slot.action_space
        self.action_space = batch_space(self.single_action_space, count)
        self.single_observation_space = slot.observation_space
        self.observation_space = batch_space(self.single_observation_space, count)

    @contextmanager
    def _running(self) -> Iterator[SlotRunner]:
        """Yield the runner of the slots; if it fails during use, close the environment.

        Raises:
            InputError: the vector environment is closed, or belongs to another process.
        """
        if self.closed or not self._runner.live:
            raise InputError("This vector environment is closed; create a new one.")
        self._check_process()
        try:
            yield self._runner
        except BaseException:
            if not self._runner.live:
                self.close()
            raise

    def _check_process(self) -> None:
        if self._process != os.getpid():
            raise InputError(
                "This vector environment was created before the process was forked, and its "
                "threads and processes do not exist in this process. Create a new vector "
                "environment in this process, or send a pickled copy."
            )

    def _check_playing(self) -> None:
        """Raise InputError if a slot has no episode, or has a finished one and must be reset."""
        rows = self._runner.arrays
        if not rows.playing.all():
            idle = np.flatnonzero(~rows.playing).tolist()
            raise InputError(f"Call reset() before stepping: the slots {idle} have no episode.")
        if self.autoreset_mode == AutoresetMode.DISABLED and rows.over.any():
            over = np.flatnonzero(rows.over).tolist()
            raise InputError(
                f"The episodes of the slots {over} are over and autoreset is disabled: call "
                "reset(options={'reset_mask': ...}) first."
            )


def _slot(limit: int | None, task: Task, config: EnvConfig, scenes: SceneChoice) -> gym.Env:
    env = make_env(scenes, task=task, **vars(config))
    return env if limit is None else TimeLimit(env, limit)


def _share_worlds(config: EnvConfig) -> EnvConfig:
    """Return a config whose environments share compiled worlds."""
    worlds = config.worlds
    masters = worlds.masters or Masters(worlds.arm, worlds.cache)
    return replace(config, worlds=replace(worlds, masters=masters))
