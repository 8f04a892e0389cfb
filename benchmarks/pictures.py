"""A folder of pictures to scenes: detections, run time, and a sheet for each.

    python benchmarks/pictures.py FOLDER --out out/pictures
    python benchmarks/pictures.py FOLDER --intrinsics 612.9 613.2 322.5 248.2

Every picture of the folder becomes a bundle, a sheet (``NAME.png``, as drawn by ``tabletopgen
compare``) and one row of ``pictures.csv`` (a second run resumes); the table is ``pictures.md``.
``NAME_depth.png`` next to ``NAME.png`` or ``NAME_color.png`` (16 bit, millimetres) is the picture's
depth map and is used if the intrinsics are given: in pixels, the same for all pictures, as
``--intrinsics FX FY CX CY`` or in the folder's ``intrinsics.json`` (an object with those keys). The
true number of objects in a picture must be counted manually.

With depth, the published scene is compared with the depth map: both are seen from the camera that
the depth map gives, and for each object the median of its visible points in the scene (the object's
own pixels) is compared with the median of the points of its mask in the depth map. Both medians are
of visible surfaces and exclude the hidden back, which separates a visible surface from the centre
of an object. ``places`` are along the table, ``tops`` the heights of the highest points, ``plane``
the distance within which 95 % of the tabletop's points are from the scene's tabletop.
"""

from __future__ import annotations

import argparse
import csv
import dataclasses
import datetime
import json
import os
import platform
import sys
import time
from pathlib import Path
from typing import Any

import numpy as np

FIELDS = (
    "picture", "depth", "objects", "names", "gate", "mean_iou", "table_iou", "color_difference",
    "elevation_deg", "places_cm", "places_in_2cm", "worst_place", "tops_cm", "plane_cm", "seconds",
    "warnings", "error",
)  # fmt: skip
GROUND = 0.008  # height in metres above the tabletop below which points belong to the tabletop
FEW = 12  # points
ENDINGS = {".png", ".jpg", ".jpeg", ".webp", ".bmp", ".tif", ".tiff", ".gif"}
KEYS = ("fx", "fy", "cx", "cy")


def pictures(folder: Path) -> list[tuple[str, Path, Path | None]]:
    """Return name, picture and depth map of every picture of a folder, sorted by name."""
    files = sorted(p for p in folder.iterdir() if p.suffix.lower() in ENDINGS)
    found = []
    for path in files:
        if path.stem.endswith("_depth"):
            continue
        name = path.stem.removesuffix("_color")
        depth = folder / f"{name}_depth.png"
        found.append((name, path, depth if depth.is_file() else None))
    return found


def intrinsics_of(folder: Path, given: list[float] | None) -> dict[str, float] | None:
    """Return the given intrinsics in pixels, or else those of the folder, if any."""
    if given is not None:
        return dict(zip(KEYS, given, strict=True))
    kept = folder / "intrinsics.json"
    if not kept.is_file():
        return None
    values = json.loads(kept.read_text())
    return {key: float(values[key]) for key in KEYS}


def run(
    name: str, picture: Path, depth: Path | None, focal: dict[str, float] | None, out: Path
) -> dict[str, Any]:
    """Rebuild one picture, save its bundle and sheet, and return its row."""
    from generator.bundle import Segments
    from generator.comparison import compare, comparison_sheet
    from generator.io.pictures import write_picture
    from generator.pipeline import generate
    from generator.scene import Intrinsics
    from generator.scene.provenance import scene_name

    metric: dict[str, Any] = {}
    if depth is not None and focal is not None:
        metric = {"depth": depth, "intrinsics": Intrinsics(**focal)}
    row: dict[str, Any] = {"picture": name, "depth": int(bool(metric)), "error": ""}
    start = time.perf_counter()
    try:
        made = generate(picture, name=scene_name(name), **metric)
        row["seconds"] = round(time.perf_counter() - start, 1)
        made.save(out / "bundles", allow_failed=True)
        seen = compare(made.scene, Segments.of(made.instances), np.asarray(made.reference.image))
        write_picture(comparison_sheet(seen), out / f"{name}.png")
        row |= _facts(seen.facts(), made.scene)
        if made.reference.depth is not None:
            row |= depth_facts(made)
    except Exception as error:  # recorded as a failure; one picture must not abort the run
        row["seconds"] = round(time.perf_counter() - start, 1)
        row["error"] = f"{type(error).__name__}: {error}"[:300]
    return row


def _facts(facts: dict[str, Any], scene: Any) -> dict[str, Any]:
    report = scene.report
    return {
        "objects": len(scene.objects),
        "names": ", ".join(thing.label for thing in scene.objects),
        "gate": "passed" if report is not None and report.passed else "failed",
        "mean_iou": round(facts["mean_iou"], 3),
        "table_iou": round(facts["table"]["iou"], 3),
        "color_difference": facts["mean_color_difference"],
        "elevation_deg": facts["camera"]["elevation_deg"],
        "warnings": "; ".join(
            [
                *scene.provenance.warnings,
                *map(str, report.failures if report else ()),
            ]
        ),
    }


def depth_facts(made: Any) -> dict[str, Any]:
    """Compare a scene with its depth map (see above); lengths in centimetres."""
    from generator.backends.embedded.depth.measure import steady, table_points
    from generator.backends.embedded.depth.plane import find_depth_plane
    from generator.render.raster import render
    from generator.render.sheet import scene_items

    depth, height = np.asarray(made.reference.depth), made.scene.table.height
    masks = {i.name: np.asarray(i.mask) for i in made.instances}
    plane = find_depth_plane(depth, made.reference.intrinsics, masks["table"])
    camera = plane.camera
    drawn = render(scene_items(made.scene), camera_above(camera, height), supersample=1)
    shown = table_points(np.where(np.isfinite(drawn.depth), drawn.depth, 0.0), camera)
    known = table_points(np.where(steady(depth), depth, 0.0), camera)
    top = known[masks["table"] & (drawn.ids == 0), 2]
    off = {}
    for number, thing in enumerate(made.scene.objects, start=1):
        pair = above_tabletop(shown[drawn.ids == number]), above_tabletop(known[masks[thing.name]])
        if min(map(len, pair)) >= FEW:
            place = np.median(pair[0][:, :2], axis=0) - np.median(pair[1][:, :2], axis=0)
            tall = [float(np.percentile(points[:, 2], 98)) for points in pair]
            off[thing.name] = float(np.hypot(*place)), abs(tall[0] - tall[1])
    if not off:
        return {}
    places, tops = np.array(list(off.values())).T * 100
    worst = list(off)[int(places.argmax())]
    return {
        "places_cm": round(float(np.median(places)), 2),
        "places_in_2cm": f"{int((places <= 2).sum())} of {len(made.scene.objects)}",
        "worst_place": f"{worst} {places.max():.1f}",
        "tops_cm": round(float(np.median(tops)), 2),
        "plane_cm": round(100 * float(np.nanpercentile(np.abs(top), 95)), 2),
    }


def camera_above(camera: Any, height: float) -> Any:
    """Return a camera of the tabletop's frame in the world's, with a floor ``height`` lower."""
    return dataclasses.replace(camera, position=camera.position + np.array([0.0, 0.0, height]))


def above_tabletop(points: np.ndarray) -> np.ndarray:
    """Return the known points above the tabletop; all known points of a flat object."""
    known = points[np.isfinite(points).all(1)]
    high = known[known[:, 2] > GROUND]
    return high if len(high) > 0.3 * len(known) else known


def summary(rows: list[dict[str, Any]], command: str) -> str:
    """Return the table of all pictures."""
    passed = sum(r["gate"] == "passed" for r in rows)
    seconds = [float(r["seconds"]) for r in rows if not r["error"]]
    speed = f", median {np.median(seconds):.0f} s, worst {max(seconds):.0f} s" if seconds else ""
    shown = ("picture", "depth", "objects", "names", "gate", "mean_iou", "table_iou",
             "color_difference", "elevation_deg", "places_cm", "places_in_2cm", "worst_place",
             "tops_cm", "plane_cm", "seconds")  # fmt: skip
    lines = [
        f"# pictures: {passed} of {len(rows)} passed their gate{speed}",
        f"`{command}`, {platform.machine()}, {os.cpu_count()} cores, "
        f"{datetime.date.today().isoformat()}",
        "",
        "| " + " | ".join([*(name.replace("_", " ") for name in shown), "remarks"]) + " |",
        "|---" * (len(shown) + 1) + "|",
    ]
    for r in rows:
        remarks = str(r["error"] or r["warnings"] or "").replace("|", "/").replace("\n", " ")
        lines.append("| " + " | ".join([*(str(r.get(k) or "-") for k in shown), remarks]) + " |")
    return "\n".join([*lines, ""])


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    parser.add_argument("folder", type=Path)
    parser.add_argument("--out", type=Path, default=Path("out/pictures"))
    parser.add_argument("--intrinsics", type=float, nargs=4, metavar=("FX", "FY", "CX", "CY"))
    parser.add_argument("--only", nargs="*", help="names of the pictures to use")
    parser.add_argument("--threads", type=int, default=None, help="number of torch threads")
    args = parser.parse_args()
    if args.threads is not None:
        import torch

        torch.set_num_threads(args.threads)
    focal = intrinsics_of(args.folder, args.intrinsics)
    args.out.mkdir(parents=True, exist_ok=True)
    table = args.out / "pictures.csv"
    rows: list[dict[str, Any]] = []
    if table.exists():
        with table.open(newline="") as file:
            rows = list(csv.DictReader(file))
    done = {r["picture"] for r in rows}
    jobs = [job for job in pictures(args.folder) if job[0] not in done]
    jobs = [job for job in jobs if not args.only or job[0] in args.only]
    with table.open("a", newline="") as file:
        writer: csv.DictWriter[str] = csv.DictWriter(file, FIELDS, restval="")
        if not rows:
            writer.writeheader()
        for number, (name, picture, depth) in enumerate(jobs, start=1):
            row = dict.fromkeys(FIELDS, "") | run(name, picture, depth, focal, args.out)
            rows.append(row)
            writer.writerow(row)
            file.flush()
            state = row["error"] or f"{row['objects']} objects, gate {row['gate']}"
            print(f"[{number}/{len(jobs)}] {name}: {state}, {row['seconds']} s", flush=True)
    given = (Path(word).name if Path(word).is_absolute() else word for word in sys.argv[1:])
    command = " ".join(["python benchmarks/pictures.py", *given])
    text = summary(rows, command)
    (args.out / "pictures.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
