"""Training data for small networks, extracted from shards of renders and cached on disk."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Self, TypeVar

import numpy as np
import torch
from rich.progress import track

from generator.errors import InputError

from .sample import Sample
from .shards import ShardReader


@dataclass(frozen=True, eq=False)
class Lesson:
    """Arrays with one row per example; subclasses define them."""

    def save(self, path: Path) -> None:
        """Write the lesson to ``path``, completely or not at all."""
        partial_path = path.with_suffix(".partial")
        with partial_path.open("wb") as file:
            np.savez_compressed(file, **vars(self))
        partial_path.replace(path)

    @classmethod
    def load(cls, path: Path) -> Self:
        """Read a lesson written by :meth:`save`."""
        with np.load(path, allow_pickle=False) as file:
            return cls(**{key: file[key] for key in cls.__dataclass_fields__})

    @classmethod
    def join(cls, lessons: Iterable[Self]) -> Self:
        """Return several lessons as one."""
        told = list(lessons)
        parts = {key: [getattr(one, key) for one in told] for key in cls.__dataclass_fields__}
        return cls(**{key: np.concatenate(part) for key, part in parts.items()})


L = TypeVar("L", bound=Lesson)


def gather(
    kind: type[L], teach: Callable[[Sample], L], data: Path, work: Path, workers: int
) -> list[L]:
    """Return the lessons of all shards in ``data``, in order; ``work`` caches finished ones.

    Raises:
        InputError: there are no shards.
    """
    shards = sorted(data.glob("*.shard"))
    if not shards:
        raise InputError(
            f"No shards in {data}. Render some: python -m research.eye.pictures.renders --help"
        )
    work.mkdir(parents=True, exist_ok=True)
    with ProcessPoolExecutor(workers, multiprocessing.get_context("spawn")) as pool:
        paths = pool.map(partial(_write, kind, teach, work), shards)
        return [kind.load(path) for path in track(paths, "looking", total=len(shards))]


def _write(kind: type[L], teach: Callable[[Sample], L], work: Path, path: Path) -> Path:
    """Write the lesson of one shard into ``work``, unless it exists; return its path."""
    target = work / f"{path.stem}.npz"
    if not target.is_file():
        torch.set_num_threads(1)
        reader = ShardReader(path)
        samples = (reader.read(k, depth=False) for k in range(len(reader)))
        kind.join(map(teach, samples)).save(target)
    return target
