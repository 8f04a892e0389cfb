"""Seconds of the rotation stage (DRO, Sec. 3.3) per instance, all three loss terms.

    python benchmarks/rotation_speed.py --cases 50
    python benchmarks/rotation_speed.py --cases 50 --device cuda --batch 10

Instances are those of the pose benchmark: single objects of the catalogue, drawn by the NumPy
renderer, up to 15 % hidden. ``--batch`` is the number of objects searched at once, like those of
one scene; a batch's time is divided evenly. Objects are drawn before the measurement, and one batch
is used for warm-up. A GPU is synchronised before each reading of the clocks: wall-clock seconds,
and CPU seconds, which other programs on the machine hardly affect. The table is written to
``results/rotation_speed_DEVICE.md``.
"""

from __future__ import annotations

import argparse
import dataclasses
import time
from collections.abc import Sequence
from pathlib import Path

import numpy as np
from jaxtyping import Float
from posing.cases import Draw, TurnCase, draw_case
from posing.spoiling import Spoiling
from posing.tables import alone, where

from generator.backends.embedded.encoder import EmbeddedEncoder
from generator.method.rotation import RotationConfig, make_objectives, search

HERE = Path(__file__).parent


def parser() -> argparse.ArgumentParser:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument("--cases", type=int, default=50)
    p.add_argument("--device", choices=("cpu", "cuda"), default="cpu")
    p.add_argument("--batch", type=int, default=1, help="instances searched at once")
    p.add_argument("--seed", type=int, default=1)
    p.add_argument("--out", type=Path, default=HERE / "results")
    return p


def time_search(cases: Sequence[TurnCase], config: RotationConfig) -> Float[np.ndarray, "2"]:
    """Return the wall-clock and CPU seconds of a batch, from masks and meshes to yaws.

    All cases use the view of the first: a scene has one camera, and the amount of work does not
    depend on it.
    """
    import torch

    def now() -> Float[np.ndarray, "2"]:
        if config.device == "cuda":
            torch.cuda.synchronize()
        return np.array([time.perf_counter(), time.process_time()])

    height, width = cases[0].reference.image.shape[:2]
    begin = now()
    search(
        make_objectives(
            [c.model for c in cases], [c.instance for c in cases], cases[0].view, EmbeddedEncoder(),
            config, (width, height), 0, [c.front if c.hidden else None for c in cases],
        )
    )  # fmt: skip
    return now() - begin


def table(seconds: Float[np.ndarray, "n 2"], head: str) -> str:
    """Return the times as Markdown; the columns of ``seconds`` are wall-clock and CPU."""
    lines = [
        "# Seconds of the rotation stage per instance", head, "",
        "| seconds | instances | median | mean | 90 % below | maximum |",
        "|---|---|---|---|---|---|",
    ]  # fmt: skip
    for name, own in zip(("wall", "CPU"), seconds.T, strict=True):
        figures = (np.median(own), own.mean(), np.quantile(own, 0.9), own.max())
        lines.append(f"| {name} | {len(own)} | {' | '.join(f'{f:.2f}' for f in figures)} |")
    return "\n".join([*lines, ""])


def main() -> None:
    args = parser().parse_args()
    if args.cases < 1 or args.batch < 1:
        raise SystemExit("--cases and --batch must be at least 1.")
    alone()
    import torch

    if args.device == "cuda" and not torch.cuda.is_available():
        raise SystemExit("There is no CUDA device. Use --device cpu.")
    config = dataclasses.replace(RotationConfig(), device=args.device)
    draw = Draw("dev", args.seed, Spoiling(elevation=5.0, occlude=0.15))
    cases = [draw_case(draw, k) for k in range(args.cases)]
    groups = [cases[k : k + args.batch] for k in range(0, len(cases), args.batch)]
    time_search(groups[0], config)
    seconds = np.concatenate(
        [np.tile(time_search(g, config) / len(g), (len(g), 1)) for g in groups]
    )
    machine = torch.cuda.get_device_name() if args.device == "cuda" else "one thread"
    head = (
        f"`python benchmarks/rotation_speed.py --cases {args.cases} --device {args.device} "
        f"--batch {args.batch}`, {machine}, {where()}"
    )
    text = table(seconds, head)
    args.out.mkdir(parents=True, exist_ok=True)
    suffix = f"_batch{args.batch}" if args.batch > 1 else ""
    (args.out / f"rotation_speed_{args.device}{suffix}.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
