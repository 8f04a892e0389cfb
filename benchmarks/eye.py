"""Accuracy of the eye on rendered tables of categories, parameters and seeds never trained on.

    python -m research.eye.pictures.renders --out out/eye-eval --count 200 --seed 7 --split eval
    python benchmarks/eye.py --data out/eye-eval --out benchmarks/results
    python -m research.eye.pictures.renders --out out/eye-hard --count 200 --seed 17 --split hard
    python benchmarks/eye.py --data out/eye-hard --out benchmarks/results

The split "hard" has objects without a category, unusual colours, white on white and black on black,
objects behind the table's far edge, loaded boards and bowls, hard shadows and eye-level views. Its
table is ``eye_hard.md``.

An object counts if at least 100 pixels (of a picture 512 pixels wide; in proportion for others) and
15 % of it are visible; detections of other objects are ignored. A detection is correct at an
overlap (IoU) of at least 0.5 with the visible mask, strictly at 0.75. Names are evaluated on
detected objects of categories that the eye was trained on: the network's own; the most likely ones
given sizes and shapes on the detected tabletop; and the labels of the segmenter, which may be
absent. Elevation and proportions of the table are those of the tabletop detected by the pipeline,
the proportions only if the frame shows all of it.
"""

from __future__ import annotations

import argparse
import contextlib
import dataclasses
import datetime
import os
import platform
import sys
import time
from pathlib import Path

import numpy as np
import shapely
from rich.progress import track
from scipy.optimize import linear_sum_assignment

from generator.backends.embedded.eye.network import REGIONS
from generator.backends.embedded.eye.sight import EyeReading, see
from generator.backends.embedded.eye.weights import load_weights
from generator.backends.embedded.plane.plane import TablePlane
from generator.backends.embedded.plane.tabletop import find_tabletop, fit_view
from generator.backends.embedded.segmenter import SURE, looks_of, table_of
from generator.errors import SceneError
from generator.geometry import Camera, view_rotation
from generator.language.names import free_labels, weigh
from research.eye.sample import Sample, worth_finding
from research.eye.shards import ShardReader
from tabletop_objects import CATEGORIES

RIGHT, STRICT = 0.5, 0.75


def overlaps(a: np.ndarray, b: np.ndarray) -> np.ndarray:
    """Return the IoU of every mask of (n, h, w) with every one of (m, h, w)."""
    pixels = a.shape[1] * a.shape[2]
    x, y = (m.reshape(len(m), pixels).astype(np.float32) for m in (a, b))
    both = x @ y.T
    return both / np.maximum(x.sum(1)[:, None] + y.sum(1)[None] - both, 1)


def mark(
    sample: Sample,
    sight: EyeReading,
    shown: np.ndarray,
    keys: tuple[str, ...],
    own: tuple[str, ...],
) -> dict:
    """Return counts and errors of one picture.

    ``shown`` is the table's visible mask in the picture; ``keys`` are the shard's categories,
    ``own`` the eye's.
    """
    h, w = sample.visible.shape
    truth = np.array([sample.visible == k + 1 for k in range(len(sample.full))]).reshape(-1, h, w)
    area = truth.sum((1, 2))
    zoom = (512 / w) ** 2
    counts = worth_finding(area * zoom, sample.full.sum((1, 2)) * zoom)
    seen = np.array([t.visible for t in sight.things]).reshape(-1, h, w)
    iou = overlaps(seen, truth)
    pairs = [
        (i, j) for i, j in zip(*linear_sum_assignment(-iou), strict=True) if iou[i, j] >= RIGHT
    ]
    excused = sum(not counts[j] for _, j in pairs)
    matched = [(i, j) for i, j in pairs if counts[j]]
    taught = [0 <= c < len(keys) and keys[c] in own for c in sample.category]
    named = [(i, j) for i, j in matched if taught[j] and sample.upright[j]]
    plane = find_plane(sample.image)
    placed, labels = names_on_the_table(sight, plane, own)
    said = [own[k] if (k := int(t.names.argmax())) < len(own) else "unknown" for t in sight.things]
    table = np.isin(sample.region, [REGIONS.index("top"), REGIONS.index("legs")])
    elevation, fov = fit_view(sight.latitude)
    wholes = np.array([t.whole for t in sight.things]).reshape(-1, h, w)
    whole = overlaps(wholes, sample.full.reshape(-1, h, w))
    nouns = [CATEGORIES[keys[sample.category[j]]].noun for _, j in named]
    labelled = [labels[i] for i, _ in named]
    return {
        "strict": sum(iou[i, j] >= STRICT for i, j in matched),
        "labelled": sum(a == b for a, b in zip(labelled, nouns, strict=True)),
        "mislabelled": sum(a not in (None, b) for a, b in zip(labelled, nouns, strict=True)),
        "plane": None
        if plane is None
        else abs(np.rad2deg(plane.view.elevation - sample.view.elevation)),
        "aspect": aspect_error(sample, plane),
        "things": int(counts.sum()),
        "finds": len(seen) - excused,
        "right": len(matched),
        "iou": [iou[i, j] for i, j in matched],
        "whole": [whole[i, j] for i, j in matched],
        "named": len(named),
        "name": sum(said[i] == keys[sample.category[j]] for i, j in named),
        "weighed": sum(placed[i] == keys[sample.category[j]] for i, j in named),
        "table": overlaps(shown[None], table[None])[0, 0] if table.any() else None,
        "top": overlaps((sight.top > 0.5)[None], sample.top[None])[0, 0],
        "elevation": abs(np.rad2deg(elevation - sample.view.elevation)),
        "fov": abs(np.rad2deg(fov - sample.view.fov)),
    }


def names_on_the_table(
    sight: EyeReading, plane: TablePlane | None, own: tuple[str, ...]
) -> tuple[list[str], list[str | None]]:
    """Return each object's most likely category, given sizes and shapes, and its label."""
    if not sight.things:
        return [], []
    names = np.stack([t.names for t in sight.things]).astype(float)
    if plane is not None:  # otherwise the network's category
        names = weigh(names, looks_of(sight.things, plane, own))
    return [(*own, "unknown")[int(p.argmax())] for p in names], free_labels(names, own)


def find_plane(image: np.ndarray) -> TablePlane | None:
    """Return the tabletop detected by the pipeline, or None."""
    with contextlib.suppress(SceneError):
        return find_tabletop(image)
    return None


def aspect_error(sample: Sample, plane: TablePlane | None) -> float | None:
    """Return the relative error of the table's length over width."""
    h, w = sample.visible.shape
    inside = sample.outline.size and (sample.outline >= 0).all()
    if plane is None or not inside or (sample.outline > [w, h]).any():
        return None
    view = dataclasses.replace(sample.view, azimuth=0.0)
    camera = Camera(np.array([0.0, 0.0, 1.0]), view_rotation(view), view.fov, w, h)
    outline = camera.on_plane(sample.outline, 0.0)[:, :2]
    if not np.isfinite(outline).all():
        return None  # seen edge-on
    true = np.ptp(turn_level(outline), axis=0)
    found = np.ptp(turn_level(plane.top()), axis=0)
    return abs(float(true[0] / true[1] / (found[0] / found[1])) - 1)


def turn_level(outline: np.ndarray) -> np.ndarray:
    """Return an outline rotated so that its smallest rectangle is level, the long side along x."""
    corners = shapely.get_coordinates(shapely.minimum_rotated_rectangle(shapely.Polygon(outline)))
    sides = np.diff(corners, axis=0)
    long = sides[int(np.linalg.norm(sides, axis=1).argmax())]
    axes = np.array([long, [-long[1], long[0]]]) / np.linalg.norm(long)
    return outline @ axes.T


def summary(marks: list[dict], seconds: float) -> list[tuple[str, str]]:
    """Return the table's rows."""

    def total(key: str) -> float:
        return float(sum(m[key] for m in marks))

    def every(key: str) -> np.ndarray:
        known = [np.atleast_1d(m[key]) for m in marks if m[key] is not None]
        return np.concatenate(known) if known else np.full(1, np.nan)

    return [
        ("pictures, things", f"{len(marks)}, {total('things'):.0f}"),
        ("recall at IoU 0.5", f"{total('right') / total('things'):.1%}"),
        ("precision", f"{total('right') / max(total('finds'), 1):.1%}"),
        ("strict recall, at IoU 0.75", f"{total('strict') / total('things'):.1%}"),
        ("strict precision", f"{total('strict') / max(total('finds'), 1):.1%}"),
        ("mask IoU, mean over detections", f"{every('iou').mean():.3f}"),
        ("whole-mask IoU, mean over detections", f"{every('whole').mean():.3f}"),
        ("table IoU (visible)", f"{every('table').mean():.3f}"),
        ("tabletop IoU (whole)", f"{every('top').mean():.3f}"),
        ("elevation error, median / 90 %", _spread(every("elevation"))),
        ("field of view error, median / 90 %", _spread(every("fov"))),
        ("category top-1 of the network", f"{total('name') / max(total('named'), 1):.1%}"),
        ("category top-1", f"{total('weighed') / max(total('named'), 1):.1%}"),
        ("labels right", f"{total('labelled') / max(total('named'), 1):.1%}"),
        ("labels wrong", f"{total('mislabelled') / max(total('named'), 1):.1%}"),
        ("elevation error of the detected tabletop, median / 90 %", _spread(every("plane"))),
        ("error of its proportions, median", f"{np.median(every('aspect')):.1%}"),
        ("seconds per picture", f"{seconds:.2f}"),
    ]


def _spread(errors: np.ndarray) -> str:
    return f"{np.median(errors):.1f} / {np.quantile(errors, 0.9):.1f} degrees"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--data", type=Path, required=True)
    parser.add_argument("--limit", type=int, default=0, help="maximum number of pictures")
    parser.add_argument("--out", type=Path, help="folder for eye.md")
    args = parser.parse_args()
    own, marks, spent = load_weights().categories, [], 0.0
    readers = [ShardReader(path) for path in sorted(args.data.glob("*.shard"))]
    places = [(r, k) for r in readers for k in range(len(r))][: args.limit or None]
    for reader, k in track(places, "looking"):
        sample = reader.read(k, depth=False)
        start = time.perf_counter()
        sight = see(sample.image)
        spent += time.perf_counter() - start
        sure = tuple(t for t in sight.things if t.score >= SURE)
        sight = dataclasses.replace(sight, things=sure)
        shown = table_of(sample.image, sight)
        marks.append(mark(sample, sight, shown, reader.keys, own))
    rows = summary(marks, spent / len(places))
    text = "# The eye on rendered tables outside its training data\n"
    text += f"`python benchmarks/eye.py {' '.join(sys.argv[1:])}`, {platform.machine()}, "
    text += f"{os.cpu_count()} cores, {datetime.date.today()}\n\n| figure | value |\n|---|---|\n"
    text += "".join(f"| {name} | {value} |\n" for name, value in rows)
    print(text)
    if args.out:
        args.out.mkdir(parents=True, exist_ok=True)
        hard = any(reader.path.name.startswith("hard") for reader in readers)
        (args.out / ("eye_hard.md" if hard else "eye.md")).write_text(text)


if __name__ == "__main__":
    main()
