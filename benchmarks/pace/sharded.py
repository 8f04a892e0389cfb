"""Soak test of a vector environment in processes: errors and memory growth."""

from __future__ import annotations

import time
from collections import Counter
from collections.abc import Sequence
from contextlib import closing
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from posing import tables
from posing.tables import Row

from tabletopgen_env.parallel.vector import TabletopVectorEnv

from .watching import count_rows, look

EPISODE, HELD, PARTS = 200, 8, 10
COUNTS = ("not_finite", "warnings", "outside", "unnoticed", "escaped", "fell")
FIELDS = ("steps", "episodes", *COUNTS, "longest_ms", "seconds", "here_mb", "shards_mb")


@dataclass(frozen=True)
class ShardSoak:
    """Tables, processes, slots, total steps of all slots, and the seed of the actions."""

    places: Sequence[Path]
    processes: int
    slots: int
    steps: int
    seed: int

    @property
    def episode(self) -> int:
        """Steps of an episode."""
        return max(1, min(EPISODE, self.steps // self.slots))

    @property
    def episodes(self) -> int:
        """Episodes per slot."""
        return max(1, self.steps // (self.slots * self.episode))


def soak(soak: ShardSoak) -> list[Row]:
    """Play all episodes; return a row for each tenth of them.

    First each slot is reset to each table, so that all are compiled before memory is measured.
    """
    rng, rows = np.random.default_rng(soak.seed), []
    scenes = list(map(str, soak.places))
    envs = TabletopVectorEnv(
        soak.slots, scenes=scenes, processes=soak.processes, autoreset_mode="Disabled"
    )
    with closing(envs):
        for scene in scenes:
            envs.reset(options={"scene": scene})
        for share in np.array_split(np.arange(soak.episodes), min(PARTS, soak.episodes)):
            rows.append(_play(envs, soak.episode, len(share), rng))
            print(rows[-1], flush=True)
    return rows


def _play(envs: TabletopVectorEnv, steps: int, episodes: int, rng: np.random.Generator) -> Row:
    """Play some episodes with each slot; return the counts."""
    counts, longest, begin = Counter(dict.fromkeys(COUNTS, 0)), 0.0, time.perf_counter()
    action = np.zeros(envs.action_space.shape or ())
    for _ in range(episodes):
        envs.reset(seed=int(rng.integers(2**31)))
        for k in range(steps):
            if k % HELD == 0:
                action = rng.uniform(-1, 1, action.shape)
            clock = time.perf_counter()
            seen, rewards, *_ = envs.step(action)
            longest = max(longest, time.perf_counter() - clock)
            counts["not_finite"] += int(
                not (np.isfinite(seen).all() and np.isfinite(rewards).all())
            )
            counts["outside"] += int(not envs.observation_space.contains(seen))
        for told in envs.visit(look):
            counts.update(told)
    here, *shards = (resident(pid) for pid in ("self", *envs.pids))
    return {
        "steps": steps * episodes * envs.num_envs, "episodes": episodes * envs.num_envs, **counts,
        "longest_ms": round(1e3 * longest, 1), "seconds": round(time.perf_counter() - begin, 1),
        "here_mb": round(here, 1), "shards_mb": round(sum(shards), 1),
    }  # fmt: skip


def resident(pid: int | str) -> float:
    """Return the resident memory of a process, MB."""
    pages = int(Path(f"/proc/{pid}/statm").read_text(encoding="ascii").split()[1])
    return pages * 4096 / 1e6


def summary(soak: ShardSoak, rows: Sequence[Row], command: str, note: str) -> str:
    """Return the counts as Markdown."""
    whole = {f: sum(int(r[f]) for r in rows) for f in ("steps", "episodes", *COUNTS)}
    first, last = rows[0], rows[-1]
    lines = [
        f"# Soak: {whole['steps']} random steps in {soak.processes} processes",
        f"`{command}`, {tables.where()}{'; ' + note if note else ''}",
        "",
        f"{soak.slots} slots at {len(soak.places)} tables, {whole['episodes']} episodes of "
        f"{soak.episode} steps.",
        "",
        *count_rows(whole),
        f"| objects off the table at an episode's end, and reported | {whole['fell']} |",
        "",
        "| memory, MB | after a tenth | at the end |",
        "|---|---|---|",
        f"| this process | {first['here_mb']} | {last['here_mb']} |",
        f"| all shards together | {first['shards_mb']} | {last['shards_mb']} |",
        "",
        f"Longest step of all slots: {max(float(r['longest_ms']) for r in rows):.0f} ms.",
    ]
    return "\n".join([*lines, ""])
