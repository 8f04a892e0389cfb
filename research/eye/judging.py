"""Train the judge of the eye's detections (``eye.judge``) on renders not used to train the eye.

    python -m research.eye.pictures.renders --out DIR/judging --count 800 --split hard --seed 21
    python -m research.eye.judging --data DIR/judging --work DIR/judged

The eye first processes every picture, a shard at a time; its detections are kept in ``--work``,
from where an interrupted run resumes. The networks are small and then train in a minute.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch
from jaxtyping import Bool, Float, UInt8
from rich.progress import track
from torch.nn import functional

from generator.backends.embedded.eye.judge import DetectionJudge, Panel, clues_of
from generator.backends.embedded.eye.sight import glance_at
from generator.backends.embedded.eye.weights import JUDGE_PATH, load_weights, save_weights

from .lessons import Lesson, gather
from .sample import Sample, worth_finding

_RIGHT = 0.5  # minimum overlap (IoU) of a detection with an object that it shows
_STEPS, _BATCH, _RATE, _DECAY = 3000, 512, 2e-3, 1e-2


@dataclass(frozen=True, eq=False)
class JudgeLesson(Lesson):
    """Features and labels: detections that show an object, and pairs that show two.

    ``counts`` is False for detections of objects that are hardly visible, which are ignored.
    """

    alone: Float[np.ndarray, "n a"]
    right: Bool[np.ndarray, "n"]
    counts: Bool[np.ndarray, "n"]
    both: Float[np.ndarray, "m b"]
    apart: Bool[np.ndarray, "m"]


def lesson(
    image: UInt8[np.ndarray, "h w 3"],
    visible: UInt8[np.ndarray, "h w"],
    full: Bool[np.ndarray, "n h w"],
) -> JudgeLesson:
    """Return the lesson of one sRGB picture: the eye's detections, labelled by the ``Sample``.

    ``visible`` is the object in each pixel, from 1; 0 is none. ``full`` is each object's whole
    mask.
    """
    glance = glance_at(load_weights(), np.ascontiguousarray(image))
    clues = clues_of(glance.things, glance.region)
    count = len(full)
    area = np.bincount(visible.ravel(), minlength=count + 1)[1:]
    shows = worth_finding(area, full.sum((1, 2)))
    overlap = np.zeros((len(glance.things), count + 1))  # the first column means no object
    for row, detection in zip(overlap, glance.things, strict=True):
        shared = np.bincount(visible[detection.visible], minlength=count + 1)[1:]
        row[1:] = shared / (area + detection.visible.sum() - shared)
    thing, right = overlap.argmax(1), overlap.max(1) >= _RIGHT
    counts = ~right | np.append(True, shows)[thing]
    i, j = clues.pairs.T
    apart = right[i] & right[j] & (thing[i] != thing[j])
    return JudgeLesson(clues.alone, right, counts, clues.both, apart)


def teach(sample: Sample) -> JudgeLesson:
    """Return the lesson of one render."""
    return lesson(sample.image, sample.visible, sample.full)


def train_judge(lesson: JudgeLesson, seed: int, steps: int = _STEPS) -> DetectionJudge:
    """Return a judge trained on a lesson."""
    torch.manual_seed(seed)
    judge = DetectionJudge()
    _fit(judge.alone, lesson.alone[lesson.counts], lesson.right[lesson.counts], steps)
    _fit(judge.both, lesson.both, lesson.apart, steps)
    return judge.eval()


def _fit(
    panel: Panel, clues: Float[np.ndarray, "n c"], truth: Bool[np.ndarray, "n"], steps: int
) -> None:
    x, wished = torch.from_numpy(clues), torch.from_numpy(truth).float()
    panel.mean.copy_(x.mean(0))
    panel.spread.copy_(x.std(0) + 1e-3)
    optimizer = torch.optim.AdamW(panel.parameters(), lr=_RATE, weight_decay=_DECAY)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, steps)
    for _ in track(range(steps), "learning"):
        batch = torch.randint(len(x), (_BATCH,))
        logits = panel(x[batch])
        cost = functional.binary_cross_entropy_with_logits(logits, wished[batch].expand_as(logits))
        optimizer.zero_grad()
        cost.backward()
        optimizer.step()
        schedule.step()


def main() -> None:
    """Parse the command line and train."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--data", type=Path, required=True, help="folder of shards that the eye was not trained on"
    )
    parser.add_argument("--work", type=Path, required=True, help="folder of the eye's detections")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=JUDGE_PATH)
    args = parser.parse_args()
    lessons = gather(JudgeLesson, teach, args.data, args.work, args.workers)
    lesson = JudgeLesson.join(lessons)
    judge = train_judge(lesson, args.seed)
    notes = {
        "pictures": args.data.name,
        "detections": str(len(lesson.right)),
        "seed": str(args.seed),
    }
    save_weights(args.out, judge.state_dict(), notes)
    print(f"{args.out.name}: {len(lesson.right)} detections, {len(lesson.apart)} overlapping pairs")


if __name__ == "__main__":
    main()
