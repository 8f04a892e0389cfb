"""Measurements of our environments alone: resets, refreshing, pictures, vectors, memory."""

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
"""One measurement: name, setting, value, unit."""

Rates = Mapping[str, float]
"""Steps per second, by clock: "steps, clock", "with resets, CPU" ..."""

TABLES = 8
"""Number of tables in the part refreshing."""

EPISODE = 200
"""Steps of an episode, the registered limit."""

ROUNDS = 5
"""Number of rounds each at fixed and at refreshed tables."""

SHARE = 8
"""Slots per process in the part vector."""

WARM = 200
"""Number of resets before memory is measured, which covers all starter scenes."""

ROUND, PAUSE = 20.0, 5.0
"""Length of a round, and of the pause before each, seconds."""


def resets(scene: Scene, count: int) -> Found:
    """Time resets to the same scene, to cached scenes, and to newly composed ones."""
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
    """Time steps at fixed tables and at those of a pool that one process keeps refreshing.

    The tables of both have the scene's text, and the pool starts with the fixed ones. Rounds of
    ``ROUND`` seconds alternate, the first ones for warm-up; the process finishes its work in the
    pauses. Refreshes that become due outside the pool's rounds are requested when its next one
    begins: the rate is such that ``PER_MINUTE`` tables are refreshed per minute of its rounds.
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
    """Act at random for some seconds, in episodes; return steps per second, by clock."""
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
    """Return the median rates at fixed and at refreshed tables, and the cost of refreshing."""
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
    """Return the wall-clock time and this process's CPU time, seconds."""
    return np.array([time.perf_counter(), time.process_time()])


def pixels(scene: Scene, count: int) -> Found:
    """Time pictures alone, and steps that observe the front and the wrist camera."""
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

    As many as there are cores. Processes have ``SHARE`` slots each; rounds of all variants
    alternate, and the fastest of each counts, since other programs on the machine only slow them.
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
    """Time processes with ``SHARE`` slots each, and as many slots on one thread in this process."""
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
    """Step ``count`` times at random; return the slots' steps per second and per CPU second."""
    shape = envs.action_space.shape or ()
    actions = np.random.default_rng(0).uniform(-1, 1, (count, *shape))
    before = _cpu_time(envs)
    spent = _seconds(lambda: [envs.step(action) for action in actions])
    return count * envs.num_envs / spent, count * envs.num_envs / (_cpu_time(envs) - before)


def _cpu_time(envs: TabletopVectorEnv) -> float:
    """Return the CPU time of this process and of the slots' processes, seconds."""
    others = dict(envs.visit(_process_time)) if envs.pids else {}
    return time.process_time() + sum(others.values())


def _process_time(env: object) -> tuple[int, float]:
    return os.getpid(), time.process_time()


def memory(scene: Scene, count: int) -> Found:
    """Measure the memory of resets once caches are full.

    At the starter scenes; with scenes that exceed the cache; randomised; at continuously refreshed
    tables: the last three with a tenth of the resets.
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
        Numbers of resets with the memory at that point, MB: after warm-up and after each fifth.
    """
    sizes = []
    for k in range(WARM + count + 1):
        if k >= WARM and (k - WARM) % max(count // 5, 1) == 0:
            sizes.append((k, _resident()))
        env.reset(seed=k)
    return sizes


def _resident() -> float:
    """Return this process's resident memory, MB, after releasing free memory.

    Scenes differ in size by tens of MB, which glibc's allocator keeps for the next one.
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
"""All parts by name; each takes the scene and the number of resets for memory."""

DEFAULT = ("resets", "refreshing", "pixels", "vector")
"""The parts measured by default."""
