"""Train the grasp detector; on a CPU.

    python -m research.grasps.training --lessons DIR --out grasps.safetensors

Lessons are generated once, ``CHUNK`` scenes per file of ``--lessons``, and reused. They are from
the training side of the split of fresh scenes; one more file is from the held-out side: the
network's scores on it are printed, and stored in the card of the output file.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from io import BytesIO
from pathlib import Path

import numpy as np
import torch
from jaxtyping import Bool, Float, Int, UInt8
from rich.progress import track
from torch import Tensor, nn

from generator.errors import BundleError, InputError
from generator.geometry import rotation_z
from generator.io.bounded import read_arrays
from generator.io.files import write_file
from generator.io.pictures import write_picture
from tabletopgen_env.detection.detector import GraspDetector, save_weights
from tabletopgen_env.detection.look import CELLS
from tabletopgen_env.detection.model import SHARPNESS, GraspBatch, GraspNetwork, loss_of
from tabletopgen_env.detection.network import PLACE, PLACES, TURNS, turn_views
from tabletopgen_env.expert.planning.grasps import Grasp
from tabletopgen_env.scenes import FreshScenes, split
from tabletopgen_env.scenes.splits import Side

from .labels import COLUMNS, GraspLesson, lessons
from .sheet import sheet

CHUNK = 100
"""Number of scenes whose lessons are in one file."""

_DRAWN = 96  # objects on the sheet
_MAX_LESSONS = 512 * 2**20  # bytes per file of lessons
_NEAR = (0.004, 0.008, 0.008)  # metres along, across and up within which grasps are equal


@dataclass(frozen=True)
class DetectorScores:
    """A detector's scores on lessons.

    ``found`` is the share of objects for which its best grasp is one of the planner's, ``worse``
    the mean difference between the planner's rating of that grasp and of its own best.
    """

    objects: int
    found: float
    worse: float


def batch_of(taught: Sequence[GraspLesson], mirrored: Int[np.ndarray, "b 2"]) -> GraspBatch:
    """Return lessons as a batch; ``mirrored`` is -1 for axes of the hand to be mirrored.

    The mirror image of a grasp is a grasp of the mirrored object.
    """
    seen = torch.from_numpy(np.stack([turn_views(one.heights, one.facing) for one in taught]))
    share = torch.zeros(len(taught), TURNS * PLACES**2)
    grasp = torch.zeros(*share.shape, 5)
    for row, (lesson, signs) in enumerate(zip(taught, mirrored, strict=True)):
        for axis in np.flatnonzero(signs < 0).tolist():
            seen[row] = seen[row].flip(axis + 2)
        places, best, scores = _best(lesson, signs)
        if len(places):
            share[row, places] = torch.softmax(scores / SHARPNESS, 0)
            grasp[row, places] = best
    return GraspBatch(seen, share, (share > 0).float(), grasp)


def _best(
    lesson: GraspLesson, signs: Int[np.ndarray, "2"]
) -> tuple[Int[Tensor, "k"], Float[Tensor, "k 5"], Float[Tensor, "k"]]:
    """Return the cells with a grasp, their best grasps, and the ratings of these."""
    turn, x, y, z, opening, width, score = lesson.grasps.T
    turn, angle = turn.astype(int), lesson.facing + turn * np.pi / TURNS
    along = (x * np.cos(angle) + y * np.sin(angle)) * signs[0]
    across = (y * np.cos(angle) - x * np.sin(angle)) * signs[1]
    i, j = (np.floor(at / PLACE + PLACES / 2).astype(int) for at in (along, across))
    inside = (np.minimum(i, j) >= 0) & (np.maximum(i, j) < PLACES)
    grasps = np.column_stack([along, across, z, width, opening - width, score])[inside]
    places = ((turn * PLACES + i) * PLACES + j)[inside]
    order = np.argsort(-grasps[:, -1], kind="stable")
    places, first = np.unique(places[order], return_index=True)
    kept = torch.from_numpy(grasps[order][first]).float()
    return torch.from_numpy(places), kept[:, :5], kept[:, 5]


def train(taught: Sequence[GraspLesson], steps: int, seed: int, size: int = 16) -> GraspNetwork:
    """Return a network trained for ``steps`` batches of ``size`` objects."""
    torch.manual_seed(seed)
    rng = np.random.default_rng(seed)
    network = GraspNetwork()
    optimiser = torch.optim.AdamW(network.parameters(), 3e-3, weight_decay=1e-4)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, 3e-3, total_steps=steps)
    for _ in track(range(steps), "training"):
        rows = rng.integers(len(taught), size=size)
        batch = batch_of([taught[row] for row in rows], rng.choice([-1, 1], (size, 2)))
        loss = loss_of(network(batch.seen), batch)
        optimiser.zero_grad()
        loss.backward()
        nn.utils.clip_grad_norm_(network.parameters(), 1.0)
        optimiser.step()
        schedule.step()
    return network


def evaluate(detector: GraspDetector, taught: Sequence[GraspLesson]) -> DetectorScores:
    """Return a detector's scores on lessons."""
    worse = []
    for lesson in taught:
        found = detector.detect(lesson.look)
        near = lesson.grasps[_same(lesson, found[0])] if found else lesson.grasps[:0]
        if len(near):
            worse.append(float(lesson.grasps[0, -1] - near[:, -1].max()))
    return DetectorScores(len(taught), len(worse) / len(taught), float(np.mean(worse or [np.nan])))


def draw_sheet(
    detector: GraspDetector, taught: Sequence[GraspLesson]
) -> UInt8[np.ndarray, "h w 3"]:
    """Return a contact sheet of lessons with the detector's best grasps."""
    looks = [lesson.look for lesson in taught]
    found = [detector.detect(seen) for seen in looks]
    return sheet(looks, [grasps[0] if grasps else None for grasps in found])


def gather(folder: Path, side: Side, number: int) -> list[GraspLesson]:
    """Return the lessons of one file, which is created if missing.

    Raises:
        BundleError: the file is damaged.
        StorageError: it cannot be written.
    """
    path = folder / f"{side}-{number:03d}.npz"
    if not path.is_file():
        source = split(FreshScenes(), side)
        made = lessons(source, CHUNK, number)
        taught = [one for scene in track(made, path.stem, CHUNK) for one in scene]
        content = BytesIO()
        np.savez_compressed(
            content,
            heights=np.stack([lesson.heights for lesson in taught]),
            facing=np.array([lesson.facing for lesson in taught]),
            grasps=np.concatenate([lesson.grasps for lesson in taught]),
            counts=np.array([len(lesson.grasps) for lesson in taught]),
        )
        part = write_file(content.getvalue(), path.with_suffix(".part"))
        part.replace(path)
    return read(path)


def read(path: Path) -> list[GraspLesson]:
    """Return the lessons of a file.

    Raises:
        BundleError: it is damaged.
    """
    try:
        kept = read_arrays(path, "The file of lessons", InputError, max_bytes=_MAX_LESSONS)
        arrays = [kept[key] for key in ("heights", "facing", "grasps", "counts")]
        heights, facing, grasps, counts = arrays
        count, total = len(heights), len(grasps)
        kinds = [f"{array.dtype.kind}{array.shape}" for array in arrays]
        if kinds != [
            f"u{(count, 2, CELLS, CELLS)}", f"f{(count,)}", f"f{(total, len(COLUMNS))}",
            f"i{(count,)}",
        ]:  # fmt: skip
            raise ValueError(f"unexpected types of arrays: {', '.join(kinds)}")
        if counts.min(initial=1) < 1 or counts.sum() != total:
            raise ValueError("objects without grasps, or grasps without objects")
        if not (np.isfinite(facing).all() and np.isfinite(grasps).all()):
            raise ValueError("numbers that are not finite")
    except (ValueError, KeyError, TypeError) as error:
        raise BundleError(f"{path} is not a file of lessons ({error}). Remove it.") from error
    ends = np.cumsum(counts)
    parts = np.split(grasps, ends[:-1])
    return [GraspLesson(h, float(f), g) for h, f, g in zip(heights, facing, parts, strict=True)]


def _same(lesson: GraspLesson, grasp: Grasp) -> Bool[np.ndarray, "g"]:
    """Return the lesson's grasps that equal a detected one."""
    turns = lesson.facing + lesson.grasps[:, 0] * np.pi / TURNS
    off = (lesson.grasps[:, 1:4] - grasp.point) @ rotation_z(grasp.angle)
    near = (np.abs(off) < _NEAR).all(1)
    return near & (np.abs(turns - grasp.angle) < np.pi / TURNS / 2)


def main() -> None:
    """Generate missing lessons, train, and write the weights."""
    parser = argparse.ArgumentParser(description="Train the grasp detector.")
    parser.add_argument("--lessons", type=Path, required=True, help="folder of the lessons")
    parser.add_argument("--scenes", type=int, default=1500, help="scenes for training")
    parser.add_argument("--steps", type=int, default=3000, help="batches of 16 objects")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, required=True, help="file of the weights")
    parser.add_argument("--sheet", type=Path, help="PNG of its grasps of held-out objects")
    chosen = parser.parse_args()
    if chosen.scenes < CHUNK or chosen.steps < 1 or chosen.seed < 0:
        raise InputError(
            f"--scenes must be at least {CHUNK}, --steps at least 1 and --seed at least 0."
        )
    files = range(chosen.scenes // CHUNK)
    taught = [lesson for number in files for lesson in gather(chosen.lessons, "train", number)]
    held_out = gather(chosen.lessons, "held_out", 0)
    network = train(taught, chosen.steps, chosen.seed)
    weights = {key: value.numpy() for key, value in network.weights().items()}
    detector = GraspDetector({key: value.astype(np.float32) for key, value in weights.items()})
    card = {
        "scenes": len(files) * CHUNK, "objects": len(taught), "steps": chosen.steps,
        "seed": chosen.seed, "held_out": asdict(evaluate(detector, held_out)),
    }  # fmt: skip
    save_weights(weights, chosen.out, card)
    if chosen.sheet:
        write_picture(draw_sheet(detector, held_out[:_DRAWN]), chosen.sheet)
    print(json.dumps(card, indent=2))


if __name__ == "__main__":
    main()
