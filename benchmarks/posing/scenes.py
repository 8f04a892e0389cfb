"""Whole scenes from their picture alone: the run, matching of objects to the truth, the summary."""

from __future__ import annotations

import math
import os
import time
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from jaxtyping import Bool, Float, UInt8
from scipy.optimize import linear_sum_assignment

from generator.errors import SceneError
from generator.evaluation.surfaces.symmetry import cloud, order, yaw_error
from generator.generation import Generation
from generator.meshes.pixels import mask_iou
from generator.pipeline import generate
from generator.scene import TABLE, Object

from . import tables
from .distinct import DISTINCT
from .figures import column, cumulative, error_cells, median, share
from .tables import Row
from .truth import Truth, apart, azimuth_error, draw_truth, see, table_width
from .turning import best_turn, turn_cloud

KEY = ("scene",)
FIELDS = (
    "scene", "of", "text", "object", "category", "on", "visible_pixels", "found", "iou",
    "found_label", "found_category", "order", "apart", "yaw_state", "yaw_error_deg", "place_cm",
    "place_percent", "size_percent", "size_relative_percent", "support_right",
    "table_width_percent", "azimuth_off_deg", "elevation_off_deg", "extra", "cpu_seconds", "error",
)  # fmt: skip

GENERIC = "generic"
"""Category of an object that is rebuilt from its outline instead of a catalogue shape."""

MATCH = 0.5
"""Minimum overlap (IoU) of two masks of the same object."""

_SHOWS = 1e-4  # minimum share of the picture of a detectable object


@dataclass(frozen=True)
class ScenesResult:
    """The rows of a run, its summary and its plot."""

    rows: list[Row]
    text: str
    plot: UInt8[np.ndarray, "h w 3"]


def match(
    true: Sequence[Bool[np.ndarray, "h w"]], found: Sequence[Bool[np.ndarray, "h w"]]
) -> dict[int, tuple[int, float]]:
    """Return the detected mask for each true mask, with their overlap; none below ``MATCH``.

    Every mask is used at most once, so that the sum of the overlaps is maximal.
    """
    if not true or not found:
        return {}
    overlap = np.array([[mask_iou(a, b) for b in found] for a in true])
    rows, columns = linear_sum_assignment(-overlap)
    pairs = zip(rows, columns, strict=True)
    return {int(i): (int(j), float(overlap[i, j])) for i, j in pairs if overlap[i, j] >= MATCH}


def compare(truth: Truth, made: Generation, seconds: float) -> list[Row]:
    """Return one row for each object in the picture."""
    true = truth.scene.objects
    shown = [k for k in range(len(true)) if (truth.ids == k + 1).mean() >= _SHOWS]
    if not shown:
        raise SceneError("The picture shows nothing on the table.")
    masks = {i.name: np.asarray(i.mask) for i in made.instances}
    found = [o for o in made.scene.objects if o.name in masks]
    pairs = match([truth.ids == k + 1 for k in shown], [masks[o.name] for o in found])
    names = {found[j].name: true[shown[i]].name for i, (j, _) in pairs.items()} | {TABLE: TABLE}
    view = made.scene.view
    turned = azimuth_error(truth, view.azimuth)
    widths = table_width(truth.scene, truth.view.azimuth), table_width(made.scene, view.azimuth)
    shared = {
        "of": len(shown),
        "text": truth.text,
        "table_width_percent": _percent(widths[1], widths[0]),
        "azimuth_off_deg": "" if turned is None else round(turned, 2),
        "elevation_off_deg": round(float(np.rad2deg(view.elevation - truth.view.elevation)), 2),
        "extra": len(found) - len(pairs),
        "cpu_seconds": round(seconds, 1),
    }
    rows = []
    for i, k in enumerate(shown):
        thing = true[k]
        row = dict.fromkeys(FIELDS, "") | shared | {
            "object": thing.name, "category": thing.model.category, "on": thing.placement.on,
            "visible_pixels": int((truth.ids == k + 1).sum()), "found": int(i in pairs),
        }  # fmt: skip
        if i in pairs:
            j, iou = pairs[i]
            row |= {"iou": round(iou, 3)} | _compare(truth, k, made, found[j], widths)
            row["support_right"] = int(names.get(found[j].placement.on) == thing.placement.on)
        rows.append(row)
    return rows


def _compare(
    truth: Truth, index: int, made: Generation, found: Object, widths: tuple[float, float]
) -> dict[str, Any]:
    """Return the differences of a detected object from the true one, ``index`` of the scene's."""
    true = truth.scene.objects[index]
    a, b = see(true, truth.view.azimuth), see(found, made.scene.view.azimuth)
    state, error, other = "judged", "", math.nan
    symmetry = order(true.model.mesh, np.asarray(true.scale))
    if math.isinf(symmetry):
        state = "round"
    elif not a.upright or not b.upright:
        state = "tilted"
    elif (other := apart(truth, index, symmetry)) < DISTINCT:
        state = "alike"
    else:
        clouds = [
            turn_cloud(cloud(o.model.mesh, np.asarray(o.scale)), s.yaw)
            for o, s in ((found, b), (true, a))
        ]
        turn = best_turn(clouds[0], clouds[1])
        state = "unclear" if turn is None else "judged"
        error = "" if turn is None else round(yaw_error(turn, 0.0, symmetry), 2)
    return {
        "found_label": found.label,
        "found_category": found.model.category,
        "order": f"{symmetry:g}",
        "apart": "" if math.isnan(other) else round(other, 3),
        "yaw_state": state,
        "yaw_error_deg": error,
        "place_cm": round(100 * float(np.linalg.norm(b.place - a.place)), 2),
        "place_percent": round(
            100 * float(np.linalg.norm(b.place / widths[1] - a.place / widths[0])), 2
        ),
        "size_percent": _percent(b.reach, a.reach),
        "size_relative_percent": _percent(b.reach / widths[1], a.reach / widths[0]),
    }


def _percent(found: float, true: float) -> float:
    """Return by how many percent an estimated length is too large (positive) or too small."""
    return round(100 * (found / true - 1), 2)


def work(number: int, split: str, seed: int, sheets: Path | None) -> list[Row]:
    """Draw one scene, rebuild it from its picture, and compare; a failure is also a row."""
    begin = time.process_time()
    try:
        truth = draw_truth(split, seed, number)
        begin = time.process_time()
        made = generate(np.asarray(truth.picture), seed=number)
        rows = compare(truth, made, time.process_time() - begin)
        if sheets is not None:
            _save_sheet(made, sheets / f"{number:03d}.png")
    except Exception as error:  # one scene must not abort the run
        rows = [dict.fromkeys(FIELDS, "") | {"of": 1, "error": tables.failure(error),
                "cpu_seconds": round(time.process_time() - begin, 1)}]  # fmt: skip
    return [r | {"scene": number} for r in rows]


def _save_sheet(made: Generation, path: Path) -> None:
    from PIL import Image

    from generator.bundle import Segments
    from generator.comparison import compare as compared
    from generator.comparison import comparison_sheet

    path.parent.mkdir(parents=True, exist_ok=True)
    held = compared(made.scene, Segments.of(made.instances), np.asarray(made.reference.image))
    part = path.with_suffix(f".{os.getpid()}.png")
    Image.fromarray(comparison_sheet(held)).save(part)
    part.replace(path)


def run(
    split: str, seed: int, cases: int, workers: int, table: Path, command: str, sheets: Path | None
) -> ScenesResult:
    """Run the scenes that are missing in ``table``, and summarise all of them."""
    asked = {(str(k),): k for k in range(cases)}
    job = partial(work, split=split, seed=seed, sheets=sheets)
    rows = tables.complete(table, FIELDS, KEY, asked, job, workers, say, of="of")
    plot = cumulative(
        "Objects of scenes rebuilt from their picture",
        {
            "yaw, degrees": yaw_errors(rows),
            "position, % of the table's width": column(rows, "place_percent"),
            "size relative to the table, %": np.abs(column(rows, "size_relative_percent")),
        },
        "error: degrees, or percent",
    )
    return ScenesResult(rows, summary(rows, command), plot)


def yaw_errors(rows: Sequence[Row]) -> Float[np.ndarray, "n"]:
    """Return yaw errors (degrees) of the objects with a front; 180 if the model has none."""
    blank = sum(r["yaw_state"] == "unclear" for r in rows)
    return np.concatenate([column(rows, "yaw_error_deg"), np.full(blank, 180.0)])


def say(rows: list[Row]) -> str:
    r = rows[0]
    if r["error"]:
        return f"scene {r['scene']}: {r['error']}"
    found = sum(int(row["found"]) for row in rows)
    yaw = median(column(rows, "yaw_error_deg"), "°")
    message = f"{found} of {len(rows)} detected, yaw {yaw}, {r['cpu_seconds']} s"
    return f"scene {r['scene']} {r['text']}: {message}"


def summary(rows: Sequence[Row], command: str) -> str:
    """Return the results as Markdown."""
    shown = [r for r in rows if not r["error"]]
    found = [r for r in shown if int(r["found"])]
    firsts = list({str(r["scene"]): r for r in shown}.values())
    scenes = {str(r["scene"]) for r in rows}
    states = {s: sum(r["yaw_state"] == s for r in found)
              for s in ("judged", "round", "alike", "tilted", "unclear")}  # fmt: skip
    errors = column(found, "yaw_error_deg")
    generic = [r for r in found if r["found_category"] == GENERIC]
    figures = [
        ("scenes rebuilt", f"{len(firsts)} of {len(scenes)}"),
        ("visible objects; detected (mask IoU ≥ 0.5)",
         f"{len(shown)}; {share([bool(int(r['found'])) for r in shown])}"),
        ("objects without a counterpart in the truth", str(int(column(firsts, "extra").sum()))),
        ("yaw error modulo symmetry, median of the evaluated ones", median(errors, "°", 2)),
        ("yaw within 2°, 5°, 10°; a round model of an object with a front is wrong",
         ", ".join(error_cells(yaw_errors(found))[1:])),
        ("built as a generic object: number; their yaw error, median",
         f"{len(generic)}; {median(column(generic, 'yaw_error_deg'), '°')}"),
        ("yaw evaluated; round; similar from another side; tilted; model round, object not",
         "; ".join(str(n) for n in states.values())),
        ("more than 170° off", str(int((errors > 170).sum()))),
        ("position, median: cm; % of the table's width",
         f"{median(column(found, 'place_cm'))}; {median(column(found, 'place_percent'))}"),
        ("size error, median: metric; relative to the table's width",
         f"{median(np.abs(column(found, 'size_percent')), ' %')}; "
         f"{median(np.abs(column(found, 'size_relative_percent')), ' %')}"),
        ("correct support", share(column(found, "support_right") > 0)),
        ("table's width, median error",
         median(np.abs(column(firsts, "table_width_percent")), " %")),
        ("camera: azimuth (of tables that are not round), elevation, median error",
         f"{median(column(firsts, 'azimuth_off_deg'), '°')}, "
         f"{median(np.abs(column(firsts, 'elevation_off_deg')), '°')}"),
        ("CPU seconds per scene, median", median(column(firsts, "cpu_seconds"))),
    ]  # fmt: skip
    lines = [
        "# Scenes rebuilt from their picture alone, compared with the truth",
        f"`{command}`, {tables.where()}",
        "",
        "Both scenes are rotated to the camera's frame and aligned at the centres of their tables.",
        "",
        "| figure | value |",
        "|---|---|",
        *(f"| {name} | {value} |" for name, value in figures),
        "",
    ]
    worst = sorted(
        (r for r in found if str(r["yaw_error_deg"]) and float(r["yaw_error_deg"]) > 10),
        key=lambda r: -float(r["yaw_error_deg"]),
    )
    lines += ["More than 10° off:"] if worst else []
    for r in worst:
        taken = f"detected as {r['found_label']}, {r['found_category']}"
        off = f"{float(r['yaw_error_deg']):.0f}°"
        lines.append(f"- scene {r['scene']} {r['object']} ({taken}): {off}")
    blank = [f"scene {r['scene']} {r['object']} ({r['found_category']})"
             for r in found if r["yaw_state"] == "unclear"]  # fmt: skip
    lines += ["", f"Round models of objects with a front: {', '.join(blank)}."] if blank else []
    missed = [f"scene {r['scene']} {r['object']}" for r in shown if not int(r["found"])]
    lines += ["", f"Not found: {', '.join(missed)}."] if missed else []
    failed = {str(r["scene"]): r["error"] for r in rows if r["error"]}
    lines += [f"- scene {scene} failed: {error}" for scene, error in failed.items()]
    return "\n".join([*lines, ""])
