"""What our environments alone are timed at: resets, renewing, pictures, many at once, memory."""

from __future__ import annotations

import ctypes
import gc
import os
import statistics
import time
from collections.abc import Callable, Mapping, Sequence
from contextlib import closing, suppress
from itertools import product
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
from jaxtyping import Float

from generator.composition import compose
from generator.scene import Scene
from generator.threads import cores
from tabletopgen_env.env import TabletopEnv, make_env
from tabletopgen_env.parallel.vector import TabletopVectorEnv
from tabletopgen_env.scenes import STARTER, FixedScenes, FreshScenes, RefreshingScenes, SceneChoice
from tabletopgen_env.scenes.refresh import PER_MINUTE
from tabletopgen_env.scenes.source import HeldRef

Found = list[tuple[str, str, float, str]]
"""What was measured: name, setting, value, unit."""

Rates = Mapping[str, float]
"""Steps a second, by what counts: "steps, clock", "with resets, CPU" ..."""

TABLES = 8
"""Tables of the part refreshing."""

EPISODE = 200
"""Steps of an episode, the registered limit."""

ROUNDS = 5
"""Rounds at fixed and at renewed tables each."""

SHARE = 8
"""Slots of each process of the part vector."""

WARM = 200
"""Resets after which memory is watched: every starter has been met."""

ROUND, PAUSE = 20.0, 5.0
"""Length of a round, and of the pause before each, seconds."""


def resets(scene: Scene, count: int) -> Found:
    """Time resets onto the same scene, onto cached ones, onto ones composed anew."""
    kinds = {
        "same scene": (make_env(scene), 60, 60),
        "cached scene": (make_env(STARTER), 120, 60),
        "scene composed anew": (make_env(FreshScenes(("six things on a desk",))), 1, 8),
    }
    found: Found = []
    for name, (env, warm, timed) in kinds.items():
        for seed in range(warm):
            env.reset(seed=seed)
        spent = [1e3 * _seconds(lambda e=env, s=seed: e.reset(seed=s)) for seed in range(timed)]
        found.append(("reset", f"{name}, median", statistics.median(spent), "ms"))
        found.append(("reset", f"{name}, longest", max(spent), "ms"))
        env.close()
    return found


def refreshing(scene: Scene, count: int) -> Found:
    """Time steps at fixed tables against those of a pool that one process keeps renewing.

    The tables of both are of the scene's text, and the pool begins with the fixed ones. Rounds of
    ``ROUND`` seconds alternate, the first ones to warm up; the process ends what it has begun in
    the pauses. What becomes due outside the pool's rounds is ordered as its next one begins: its
    rate is such that ``PER_MINUTE`` are renewed in a minute of its rounds.
    """
    text = scene.provenance.prompt or ""
    fixed = FixedScenes(tuple(HeldRef(compose(text, seed)) for seed in range(TABLES)))
    rate = PER_MINUTE * ROUND / (2 * (ROUND + PAUSE))
    pool = RefreshingScenes(text, TABLES, per_minute=rate, workers=1, initial=fixed, seed=0)
    envs = {"fixed": make_env(fixed), "renewed": make_env(pool)}
    rounds: dict[str, list[Rates]] = {name: [] for name in envs}
    renewals = []
    for _ in range(ROUNDS + 1):
        for name, env in envs.items():
            time.sleep(PAUSE)
            rounds[name].append(play(env, ROUND))
        renewals.append(pool.renewals)
    for env in envs.values():
        env.close()
    pool.close()
    renewed = 60 * (renewals[-1] - renewals[0]) / (ROUNDS * ROUND)
    timed = {name: of[1:] for name, of in rounds.items()}
    return [*compare(timed), ("tables renewed", "in its rounds", renewed, "per minute")]


def play(env: TabletopEnv, seconds: float) -> Rates:
    """Act at random for some seconds, in episodes; return the steps a second, by what counts."""
    env.action_space.seed(0)
    count, spent, begin = 0, np.zeros(2), _clocks()
    while (total := _clocks() - begin)[0] < seconds:
        if count % EPISODE == 0:
            env.reset()
        action, before = env.action_space.sample(), _clocks()
        env.step(action)
        spent += _clocks() - before
        count += 1
    kinds = [f"{what}, {clock}" for what in ("steps", "with resets") for clock in ("clock", "CPU")]
    return dict(zip(kinds, (count / np.array([*spent, *total])).tolist(), strict=True))


def compare(rounds: Mapping[str, Sequence[Rates]]) -> Found:
    """Return the median rates at fixed and at renewed tables, and what renewing costs of them."""
    found: Found = []
    for kind in rounds["fixed"][0]:
        fixed, renewed = (
            statistics.median(rates[kind] for rates in rounds[name])
            for name in ("fixed", "renewed")
        )
        found += [
            ("fixed tables", kind, fixed, "steps per s"),
            ("renewed tables", kind, renewed, "steps per s"),
            ("cost of renewing", kind, 100 * (1 - renewed / fixed), "%"),
        ]
    return found


def _clocks() -> Float[np.ndarray, "2"]:
    """Return the time and this process's CPU time, seconds."""
    return np.array([time.perf_counter(), time.process_time()])


def pixels(scene: Scene, count: int) -> Found:
    """Time pictures alone and steps that see the front and the wrist camera."""
    found: Found = []
    for size, renderer in product((84, 128, 256), ("auto", "software")):
        env = make_env(scene, observation="pixels", image_size=size, renderer=renderer)
        env.reset(seed=0)
        drawer, times = env._drawer((size, size)), 40 if renderer == "auto" else 6
        setting = f"{size}x{size}, {type(drawer).__name__}"
        spent = [_seconds(lambda d=drawer, e=env: d.rgb(e.world, "front")) for _ in range(times)]
        found.append(("pictures", setting, 1 / statistics.median(spent), "per s"))
        action = np.zeros(env.controller.space.shape or ())
        spent = [_seconds(lambda e=env, a=action: e.step(a)) for _ in range(times)]
        found.append(("steps with two pictures", setting, 1 / statistics.median(spent), "per s"))
        env.close()
    return found


def vector(scene: Scene, count: int) -> Found:
    """Time many slots on threads and in processes, on one and on two, four ... of each.

    As far as there are cores. Processes have ``SHARE`` slots each; rounds of all of them alternate,
    and the fastest of each counts: what they share a machine with only slows them.
    """
    numbers = [n for n in (1, 2, 4, 8, 16, 32) if n <= max(2, cores())]
    found: Found = []
    for slots, many in product((1, 8, 32), numbers):
        if many > slots:
            continue
        with closing(TabletopVectorEnv(slots, scenes=scene, threads=many)) as envs:
            envs.reset(seed=0)
            step_all(envs, 5)
            wall, used = step_all(envs, max(10, 800 // slots))
        name = f"{slots} slots, {many} threads"
        found += [("steps", name, wall, "per s"), ("steps", name, used, "per CPU s")]
    return found + _processes(scene, numbers)


def _processes(scene: Scene, numbers: Sequence[int]) -> Found:
    """Time processes with ``SHARE`` slots each, and those slots on one thread here."""
    hows = {f"{SHARE} slots, 1 thread": TabletopVectorEnv(SHARE, scenes=scene, threads=1)}
    for many in numbers:
        name = f"{many} processes of {SHARE} slots"
        hows[name] = TabletopVectorEnv(SHARE * many, scenes=scene, processes=many)
    best = dict.fromkeys(hows, (0.0, 0.0))
    for envs in hows.values():
        envs.reset(seed=0)
    for name in [*hows] * (2 * ROUNDS):
        seen = step_all(hows[name], 20)
        best[name] = max(best[name][0], seen[0]), max(best[name][1], seen[1])
    for envs in hows.values():
        envs.close()
    thread, one = (best[name][0] for name in list(hows)[:2])
    found: Found = []
    for name, (wall, used) in best.items():
        found += [
            ("steps, fastest", name, wall, "per s"),
            ("steps, fastest", name, used, "per CPU s"),
        ]
    found += [("speed-up", f"{name} over one", best[name][0] / one, "") for name in list(hows)[2:]]
    return [*found, ("cost of a process", "1 over 1 thread", 100 * (1 - one / thread), "%")]


def step_all(envs: TabletopVectorEnv, count: int) -> tuple[float, float]:
    """Step ``count`` times at random; return the slots' steps a second and a second of CPU."""
    shape = envs.action_space.shape or ()
    actions = np.random.default_rng(0).uniform(-1, 1, (count, *shape))
    before = _cpu_time(envs)
    spent = _seconds(lambda: [envs.step(action) for action in actions])
    return count * envs.num_envs / spent, count * envs.num_envs / (_cpu_time(envs) - before)


def _cpu_time(envs: TabletopVectorEnv) -> float:
    """Return the CPU time of this process and those of the slots, seconds."""
    others = dict(envs.visit(_process_time)) if envs.pids else {}
    return time.process_time() + sum(others.values())


def _process_time(env: object) -> tuple[int, float]:
    return os.getpid(), time.process_time()


def memory(scene: Scene, count: int) -> Found:
    """Watch the memory of resets once caches are full.

    Of the starters; with scenes that leave the cache; randomised; at tables that are ever renewed:
    these three with a tenth of the resets.
    """
    text = scene.provenance.prompt or ""
    pool = RefreshingScenes(text, TABLES, every_resets=4, workers=1, initial=STARTER, seed=0)
    leaving: dict[str, Any] = {"observation": "pixels", "image_size": 32, "cache": 2}
    few = count // 10
    kinds: dict[str, tuple[SceneChoice, dict[str, Any], int]] = {
        "cached scenes": (STARTER, {}, count),
        "scenes that leave the cache, pixels": (STARTER, leaving, few),
        "cached scenes, randomised": (STARTER, {"randomization": "strong"}, few),
        "tables renewed every 4 resets": (pool, {"cache": TABLES}, few),
    }
    found: Found = []
    for name, (scenes, settings, most) in kinds.items():
        with closing(make_env(scenes, **settings)) as env:
            sizes = _watch(env, most)
        found += [(name, f"after {resets} resets", size, "MB") for resets, size in sizes]
        growth = 100 * (sizes[-1][1] / sizes[0][1] - 1)
        found.append((name, f"growth from {sizes[0][0]} resets on", growth, "%"))
    found.append(("tables renewed every 4 resets", "tables renewed", float(pool.renewals), ""))
    pool.close()
    return found


def _watch(env: TabletopEnv, count: int) -> list[tuple[int, float]]:
    """Reset ``WARM`` times to warm up and then ``count`` times.

    Returns:
        How many resets there were, and the memory then, MB: after warming up and after each fifth.
    """
    sizes = []
    for k in range(WARM + count + 1):
        if k >= WARM and (k - WARM) % max(count // 5, 1) == 0:
            sizes.append((k, _resident()))
        env.reset(seed=k)
    return sizes


def _resident() -> float:
    """Return this process's resident memory, MB, once it has given back what is free.

    Scenes differ in size by tens of MB, which the allocator of glibc keeps for the next one.
    """
    gc.collect()
    with suppress(OSError, AttributeError):  # another C library
        ctypes.CDLL("libc.so.6").malloc_trim(0)
    pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
    return pages * 4096 / 1e6


def _seconds(work: Callable[[], object]) -> float:
    begin = time.perf_counter()
    work()
    return time.perf_counter() - begin


PARTS: Mapping[str, Callable[[Scene, int], Found]] = MappingProxyType(
    {
        "resets": resets,
        "refreshing": refreshing,
        "pixels": pixels,
        "vector": vector,
        "memory": memory,
    }
)
"""Every part by name; each takes the scene and how many resets to watch."""

DEFAULT = ("resets", "refreshing", "pixels", "vector")
"""The parts measured unless others are asked for."""
