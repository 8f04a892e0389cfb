"""Render training shards.

python -m research.eye.pictures.renders --out DIR --count N --seed S
"""

from __future__ import annotations

import argparse
import multiprocessing
import os
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import get_args

import numpy as np
from PIL import Image

from generator.errors import InputError

from ..shards import ShardReader, ShardWriter
from ..sheet import contact_sheet
from .supply import KEYS, SEEDS, Split, supply

SIDE = 768
"""Pixels per side of all pictures."""

PER_SHARD = 100
"""Samples per shard; each shard has its own supply."""


@dataclass(frozen=True)
class ShardJob:
    """A shard to render."""

    out: Path
    seed: int
    split: Split
    number: int
    samples: int


def shard_path(out: Path, split: Split, seed: int, number: int) -> Path:
    """Return the file of a shard."""
    return out / f"{split}-{seed}-{number:05d}.shard"


def plan(out: Path, count: int, seed: int, split: Split) -> tuple[ShardJob, ...]:
    """Return the missing jobs for ``count`` samples; finished shards are skipped."""
    jobs = (
        ShardJob(out, seed, split, k, min(PER_SHARD, count - k * PER_SHARD))
        for k in range(-(-count // PER_SHARD))
    )
    return tuple(
        j for j in jobs if _count_samples(shard_path(out, split, seed, j.number)) < j.samples
    )


def _count_samples(path: Path) -> int:
    """Return the number of samples in a shard; 0 if it does not exist."""
    if not path.exists():
        return 0
    reader = ShardReader(path)
    reader.close()
    return len(reader)


def render(job: ShardJob) -> int:
    """Render a shard and return its number of samples.

    Every sample depends only on seed, split, shard and index.
    """
    from .gl import GlPainter
    from .rendering import render_sample

    origin = SEEDS[job.split][0]
    kept = supply(job.seed * 100_003 + job.number, job.split)
    painter = GlPainter(kept.stock, SIDE)
    path = shard_path(job.out, job.split, job.seed, job.number)
    try:
        with ShardWriter(path, KEYS) as writer:
            for k in range(job.samples):
                rng = np.random.default_rng([origin, job.seed, job.number, k])
                writer.add(render_sample(rng, kept, painter))
    finally:
        painter.close()
    return job.samples


def render_all(jobs: tuple[ShardJob, ...], workers: int) -> Iterator[int]:
    """Run jobs in ``workers`` processes (1: in this process); yields results as they finish."""
    os.environ.setdefault("LP_NUM_THREADS", "1")  # Mesa's software GL: one thread each
    if workers <= 1:
        yield from map(render, jobs)
        return
    context = multiprocessing.get_context("spawn")
    with context.Pool(workers, maxtasksperchild=8) as pool:
        yield from pool.imap_unordered(render, jobs)


def main() -> None:
    """Render shards, or a contact sheet of existing ones."""
    parser = argparse.ArgumentParser(description="Render tabletops for training, as shards.")
    parser.add_argument("--out", type=Path, required=True, help="folder of the shards")
    parser.add_argument("--count", type=int, default=400, help="samples")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--split", choices=get_args(Split), default="train")
    parser.add_argument("--workers", type=int, default=2, help="processes")
    parser.add_argument("--sheet", type=Path, help="PNG: draw the first samples with their masks")
    chosen = parser.parse_args()
    if chosen.count < 1 or chosen.workers < 1 or not 0 <= chosen.seed < 10_000:
        raise InputError("--count and --workers must be at least 1, --seed in 0 to 9999.")
    jobs = plan(chosen.out, chosen.count, chosen.seed, chosen.split)
    _run(jobs, chosen.workers, chosen.count)
    if chosen.sheet:
        with_masks = ShardReader(shard_path(chosen.out, chosen.split, chosen.seed, 0))
        samples = [with_masks[k] for k in range(min(len(with_masks), 30))]
        Image.fromarray(contact_sheet(samples)).save(chosen.sheet)


def _run(jobs: tuple[ShardJob, ...], workers: int, count: int) -> None:
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TimeRemainingColumn

    left = sum(job.samples for job in jobs)
    with Progress(
        "rendering", BarColumn(), MofNCompleteColumn(), TimeRemainingColumn()
    ) as progress:
        bar = progress.add_task("rendering", total=count, completed=count - left)
        for done in render_all(jobs, workers):
            progress.advance(bar, done)


if __name__ == "__main__":
    main()
