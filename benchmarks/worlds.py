"""Steps per second and memory of ``TabletopBatchEnv``, with a generated table in each world.

    python benchmarks/worlds.py --device cpu --worlds 4 64 --steps 20
    python benchmarks/worlds.py --device cuda --worlds 1024 4096 8192

Each row is a batch of worlds at the scenes, with random actions, episodes that end and restart at
other tables (a twentieth of them in each step), and one exchange of the bank in the middle. Only
steps are timed, after a warm-up; a GPU is synchronised before each reading. Memory is the device's
increase, or on a CPU this process's, since before the batch was made. "failed" are episodes that
overflowed or diverged. The table is written to ``results/worlds_DEVICE.md``.
"""

from __future__ import annotations

import argparse
import time
from dataclasses import dataclass
from pathlib import Path

import torch
from pace.sharded import resident
from posing.tables import where

from tabletopgen_env.parallel.batch.decks import DeckConfig
from tabletopgen_env.parallel.batch.engine import free_bytes
from tabletopgen_env.parallel.batch.env import TabletopBatchEnv

HERE = Path(__file__).parent
EPISODE = 20
"""Steps of an episode: worlds end at different times, a twentieth of them in each step."""


@dataclass(frozen=True)
class WorldsRow:
    """One batch: number of worlds, scenes of the bank, slots per world, measurements."""

    worlds: int
    scenes: int
    slots: int
    steps_per_second: float
    kib_per_world: float
    failed: int
    begun: int


def parser() -> argparse.ArgumentParser:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument("--device", default="cuda")
    p.add_argument("--worlds", type=int, nargs="+", default=[1024, 4096, 8192])
    p.add_argument("--scenes", default="starter")
    p.add_argument("--task", default="Lift")
    p.add_argument("--objects", type=int, default=8, help="maximum number of objects per scene")
    p.add_argument("--steps", type=int, default=200)
    p.add_argument("--seed", type=int, default=0)
    p.add_argument("--out", type=Path, default=HERE / "results")
    return p


def measure(args: argparse.Namespace, worlds: int) -> WorldsRow:
    """Step one batch."""
    device = torch.device(args.device)
    before = _memory_of(device)
    env = TabletopBatchEnv(
        worlds, args.scenes, task=args.task, device=device, max_objects=args.objects,
        randomization="starts", max_episode_steps=EPISODE,
        deck=DeckConfig(seed=args.seed),
    )  # fmt: skip
    generator = torch.Generator(device).manual_seed(args.seed)
    ages = {"steps": torch.arange(worlds, device=device) % EPISODE}
    env.reset(seed=args.seed, options=ages)

    def steps(count: int) -> int:
        begun = 0
        for _ in range(count):
            shape = env.num_envs, *(env.single_action_space.shape or ())
            actions = 2 * torch.rand(shape, generator=generator, device=device) - 1
            begun += int(env.step(actions)[3].sum())
        return begun

    steps(3)
    memory = _memory_of(device) - before
    begin, begun = _now(device), 0
    begun += steps(args.steps // 2)
    env.world.swap(env.bank)
    env.reset(seed=args.seed + 1, options=ages)
    begun += steps(args.steps - args.steps // 2)
    seconds = _now(device) - begin
    row = WorldsRow(
        worlds, len(env.bank), env.bank.slots, worlds * args.steps / seconds,
        memory / worlds / 1024, env.failures, begun,
    )  # fmt: skip
    env.close()
    return row


def _memory_of(device: torch.device) -> float:
    """Return the used memory of a GPU, or of this process on a CPU, bytes."""
    if device.type == "cuda":
        return -free_bytes(device)
    return 2**20 * resident("self")


def _now(device: torch.device) -> float:
    if device.type == "cuda":
        torch.cuda.synchronize()
    return time.perf_counter()


def table(rows: list[WorldsRow], head: str) -> str:
    """Return the measurements as Markdown."""
    lines = [
        "# Batched worlds", head, "",
        "| worlds | scenes | slots | env steps/s | KiB per world | episodes begun | failed |",
        "|---|---|---|---|---|---|---|",
    ]  # fmt: skip
    lines += [
        f"| {r.worlds:,} | {r.scenes} | {r.slots} | {r.steps_per_second:,.0f} "
        f"| {r.kib_per_world:,.0f} | {r.begun:,} | {r.failed} |"
        for r in rows
    ]
    return "\n".join([*lines, ""])


def main() -> None:
    args = parser().parse_args()
    rows = [measure(args, worlds) for worlds in args.worlds]
    named = torch.cuda.get_device_name() if args.device.startswith("cuda") else "CPU device"
    head = (
        f"`python benchmarks/worlds.py --device {args.device} --worlds "
        f"{' '.join(map(str, args.worlds))} --task {args.task} --steps {args.steps}`, {named}, "
        f"{where()}"
    )
    text = table(rows, head)
    args.out.mkdir(parents=True, exist_ok=True)
    (args.out / f"worlds_{torch.device(args.device).type}.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
