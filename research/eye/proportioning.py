"""Train the network that estimates objects' proportions (``eye.proportions``) on renders.

    python -m research.eye.pictures.renders --out DIR/shapes --count 2100 --split hard --seed 32
    python -m research.eye.proportioning --data DIR/shapes --work DIR/shaped

The eye first processes every object, a shard at a time; its features are kept in ``--work``, from
where an interrupted run resumes. The network is small and then trains in a minute. A quarter of the
shards is held out of a first training, to measure the errors; the second uses all of them.
"""

from __future__ import annotations

import argparse
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import torch
from jaxtyping import Float
from rich.progress import track

from generator.backends.embedded.eye.proportions import ProportionNetwork, proportion_clues
from generator.backends.embedded.eye.weights import PROPORTIONS_PATH, load_weights, save_weights
from generator.geometry import mask_box

from .lessons import Lesson, gather
from .sample import Sample, worth_finding

_EDGE = 3  # pixels: closer to the border, an object may be cut off
_STEPS, _BATCH, _RATE, _DECAY = 3000, 256, 2e-3, 0.05


@dataclass(frozen=True, eq=False)
class ProportionLesson(Lesson):
    """Features of objects, and the true logarithms of width and height over length."""

    clues: Float[np.ndarray, "n c"]
    logs: Float[np.ndarray, "n 2"]


def teach(sample: Sample) -> ProportionLesson:
    """Return the lesson of one render: its clearly and fully visible objects that lie or stand."""
    count, (high, wide) = len(sample.full), sample.visible.shape
    area = np.bincount(sample.visible.ravel(), minlength=count + 1)[1:]
    masks, feet, logs = [], [], []
    for k in np.flatnonzero(worth_finding(area, sample.full.sum((1, 2)))):
        mask = sample.visible == k + 1
        x0, y0, x1, y1 = mask_box(mask).astype(int)
        if min(x0, y0, wide - x1, high - y1) < _EDGE:
            continue
        masks.append(mask)
        feet.append(float(sample.latitude[min(high - 1, y1 - 1), (x0 + x1) // 2]))
        sides = sample.size[k] if sample.upright[k] else sample.size[k][[0, 2, 1]]
        logs.append(np.log([sides[:2].min(), sides[2]]) - np.log(sides[:2].max()))
    image = np.ascontiguousarray(sample.image)
    clues = proportion_clues(load_weights().eye, image, masks, feet, float(sample.top.sum()))
    return ProportionLesson(clues, np.array(logs, np.float32).reshape(-1, 2))


def train_proportions(
    lesson: ProportionLesson, seed: int, steps: int = _STEPS
) -> ProportionNetwork:
    """Train a network on a lesson; its error scales are estimated from the same lesson."""
    torch.manual_seed(seed)
    network = ProportionNetwork()
    x, wished = torch.from_numpy(lesson.clues), torch.from_numpy(lesson.logs)
    network.mean.copy_(x.mean(0))
    network.scale.copy_(x.std(0) + 1e-2)
    optimizer = torch.optim.AdamW(network.parameters(), lr=_RATE, weight_decay=_DECAY)
    schedule = torch.optim.lr_scheduler.CosineAnnealingLR(optimizer, steps)
    for _ in track(range(steps), "learning"):
        batch = torch.randint(len(x), (_BATCH,))
        logs, spread = network(x[batch])
        # The negative log-likelihood of a Laplace distribution.
        cost = ((logs - wished[batch]).abs() / spread.exp() + spread).mean()
        optimizer.zero_grad()
        cost.backward()
        optimizer.step()
        schedule.step()
    return network.eval()


def errors(
    network: ProportionNetwork, lesson: ProportionLesson
) -> tuple[Float[np.ndarray, "n 2"], Float[np.ndarray, "n 2"]]:
    """Return the network's errors (absolute logarithms), and the spreads that it estimates."""
    told = network.tell(lesson.clues)
    off = np.abs(np.stack([one.logs for one in told]) - lesson.logs)
    return off, np.stack([one.spread for one in told])


def main() -> None:
    """Parse the command line and train."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "--data", type=Path, required=True, help="folder of shards that the eye was not trained on"
    )
    parser.add_argument("--work", type=Path, required=True, help="folder of the eye's features")
    parser.add_argument("--workers", type=int, default=2)
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, default=PROPORTIONS_PATH)
    args = parser.parse_args()
    lessons = gather(ProportionLesson, teach, args.data, args.work, args.workers)
    aside = max(1, len(lessons) // 4)
    held = ProportionLesson.join(lessons[:aside])
    first = train_proportions(ProportionLesson.join(lessons[aside:] or lessons), args.seed)
    off, spread = errors(first, held)
    network = train_proportions(ProportionLesson.join(lessons), args.seed)
    network.unsure.copy_(torch.from_numpy((off / spread).mean(0)))
    things = sum(len(lesson.logs) for lesson in lessons)
    notes = {"pictures": args.data.name, "things": str(things), "seed": str(args.seed)}
    save_weights(args.out, network.state_dict(), notes)
    width, height = np.median(off, 0)
    print(
        f"{args.out.name}: {things} objects; median error of the logarithm on the {len(held.logs)} "
        f"held-out ones: width/length {width:.2f}, height/length {height:.2f}"
    )


if __name__ == "__main__":
    main()
