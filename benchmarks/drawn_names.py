"""Detection and naming of the objects in a text's drawing.

    python benchmarks/drawn_names.py --out benchmarks/results
    python benchmarks/drawn_names.py --texts benchmarks/wording/dev.json --every 3 --out out

Each text is planned and drawn; the embedded segmenter gets the picture and the plan's nouns, as in
the pipeline from text to scene, and nothing else. An object with enough visible pixels (``LEAST``)
is detected if a mask overlaps it with an IoU of at least 0.5, and named correctly if that mask has
the planned noun. By default every third text of ``wording/test.json``, starting with the second, is
used: none of them was used in the development of the naming.
"""

from __future__ import annotations

import argparse
import datetime
import os
import platform
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from posing.tables import texts_in

HERE = Path(__file__).parent
LEAST = 150


@dataclass(frozen=True)
class Count:
    """Objects of one text: visible ones, detected ones, and correctly named ones."""

    shown: int
    found: int
    named: int


def count(text: str, seed: int) -> Count:
    """Draw a text and count its detections; raises SceneError or InputError on failure."""
    from generator.backends.embedded.painter import paint
    from generator.backends.embedded.segmenter import EmbeddedSegmenter
    from generator.language.planner import plan_scene
    from generator.meshes.pixels import mask_iou
    from generator.scene import TABLE

    plan = plan_scene(text, seed)
    painted, order = paint(plan, seed)
    nouns = {planned.name: planned.noun for planned in plan.objects}
    labels = (TABLE, *(planned.noun for planned in plan.objects))
    detections = EmbeddedSegmenter().segment(painted.image, labels)[1:]
    shown = found = named = 0
    for k, name in enumerate(order, start=1):
        own = painted.ids == k
        if own.sum() < LEAST:
            continue
        shown += 1
        overlaps = [mask_iou(own, np.asarray(d.mask)) for d in detections]
        if overlaps and max(overlaps) >= 0.5:
            found += 1
            named += detections[int(np.argmax(overlaps))].label == nouns[name]
    return Count(shown, found, named)


def main() -> None:
    """Run the benchmark and write ``drawn_names.md``."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--texts", type=Path, default=HERE / "wording" / "test.json")
    parser.add_argument("--every", type=int, default=3, help="use one text out of this many")
    parser.add_argument("--first", type=int, default=1, help="index of the first text")
    parser.add_argument("--most", type=int, default=40, help="maximum number of texts")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--out", type=Path, required=True)
    args = parser.parse_args()
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    import torch

    torch.set_num_threads(1)
    from generator.errors import TabletopError

    texts = texts_in(args.texts)[args.first :: args.every][: args.most]
    counts: list[Count] = []
    start = time.perf_counter()
    for text in texts:
        try:
            counts.append(count(text, args.seed))
        except TabletopError as error:
            print(f"left out: {text[:60]}: {error}", flush=True)
            continue
        print(f"{len(counts)}/{len(texts)} {counts[-1]}", flush=True)
    shown, found, named = (sum(getattr(c, n) for c in counts) for n in ("shown", "found", "named"))
    share = {"found": found / max(shown, 1), "named": named / max(found, 1)}
    took = (time.perf_counter() - start) / max(len(counts), 1)
    lines = [
        "# Names of things in the drawings of texts",
        f"`python benchmarks/drawn_names.py --texts {args.texts.name} --every {args.every} "
        f"--first {args.first} --most {args.most} --seed {args.seed}`, {platform.machine()}, "
        f"{os.cpu_count()} cores, {datetime.date.today()}",
        "",
        "| figure | value |",
        "|---|---|",
        f"| texts, visible objects | {len(counts)}, {shown} |",
        f"| detected (a mask with an IoU of at least 0.5) | {found}, {share['found']:.1%} |",
        f"| of these, named correctly | {named}, {share['named']:.1%} |",
        f"| seconds per text for plan, drawing and detection | {took:.1f} |",
    ]
    args.out.mkdir(parents=True, exist_ok=True)
    (args.out / "drawn_names.md").write_text("\n".join(lines) + "\n", encoding="utf-8")
    print("\n".join(lines))


if __name__ == "__main__":
    main()
