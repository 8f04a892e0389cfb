"""Single objects: the run, its summary and the sheet of the worst cases."""

from __future__ import annotations

import itertools
from collections import defaultdict
from collections.abc import Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from jaxtyping import UInt8

from generator.render.sheet import grid

from . import tables
from .cases import Draw, draw_case
from .distinct import close_up
from .figures import column, cumulative, error_cells, median, share
from .solving import FIELDS, row_of, start_of_row
from .tables import Row

KEY = ("case", "config")
SURE = 0.8  # share of the cases in the group of highest certainty
BAD = 10.0  # error in degrees from which a case is listed
_CELL = 240


@dataclass(frozen=True)
class SinglesResult:
    """The rows of a run, its summary and its plot."""

    rows: list[Row]
    text: str
    plot: UInt8[np.ndarray, "h w 3"]


def work(job: tuple[int, str], draw: Draw) -> list[Row]:
    """Draw and solve one case; a failure is also a row."""
    number, config = job
    try:
        return [row_of(draw_case(draw, number), number, config)]
    except Exception as error:  # one case must not abort the run
        return [start_of_row(number, config) | {"error": tables.failure(error)}]


def run(
    draw: Draw, cases: int, paper: int, workers: int, table: Path, command: str
) -> SinglesResult:
    """Run the cases that are missing in ``table``, and summarise all of them."""
    jobs = [(k, "default") for k in range(cases)] + [(k, "paper") for k in range(min(paper, cases))]
    asked = {(str(k), config): (k, config) for k, config in jobs}
    job = partial(work, draw=draw)
    rows = tables.complete(table, FIELDS, KEY, asked, job, workers, say)
    good = {c: [r for r in rows if r["config"] == c and not r["error"]] for c in configs(rows)}
    curves = {c: column(own, "error_deg") for c, own in good.items()}
    plot = cumulative("Yaw error of single objects", curves, "yaw error, degrees")
    return SinglesResult(rows, summary(rows, command), plot)


def say(rows: list[Row]) -> str:
    r = rows[0]
    if r["error"]:
        return f"case {r['case']} {r['config']}: {r['error']}"
    return f"case {r['case']} {r['config']} {r['object']}: {r['error_deg']}°, {r['cpu_seconds']} s"


def configs(rows: Sequence[Row]) -> list[str]:
    """Return the settings that rows are of, the default first."""
    return sorted({r["config"] for r in rows})


def summary(rows: Sequence[Row], command: str) -> str:
    """Return the results as Markdown."""
    lines = [
        "# Yaw of single objects of known pose",
        f"`{command}`, {tables.where()}",
        "",
        "| settings | cases | median | within 2° | within 5° | within 10° | flips "
        "| scale error, median | CPU seconds, median |",
        "|---|---|---|---|---|---|---|---|---|",
    ]
    for config in configs(rows):
        own = [r for r in rows if r["config"] == config and not r["error"]]
        cells = [config, str(len(own)), *error_cells(column(own, "error_deg")),
                 str(int(column(own, "flip").sum())),
                 median(column(own, "scale_error_percent"), " %"),
                 median(column(own, "cpu_seconds"))]  # fmt: skip
        lines.append(f"| {' | '.join(cells)} |")
    first = [r for r in rows if r["config"] == "default" and not r["error"]]
    counts = [int(column(first, f"dropped_{why}").sum()) for why in ("symmetric", "alike", "other")]
    lines += [
        "",
        f"Rejected objects: {counts[0]} are rotationally symmetric, {counts[1]} look nearly the "
        f"same from another side in their picture, {counts[2]} do not fit into it.",
        "",
    ]
    lines += [*_certainty(first), *_groups(first)]
    for r in (r for r in rows if r["error"]):
        lines.append(f"- case {r['case']} ({r['config']}) failed: {r['error']}")
    return "\n".join([*lines, ""])


def _certainty(rows: Sequence[Row]) -> list[str]:
    """Return tables of the errors by the stage's certainty."""
    if len(rows) < 5:
        return []
    ordered = sorted(rows, key=lambda r: -float(r["margin"]))
    cut = round(SURE * len(ordered))
    lines = [
        "| by margin to the best other side | number | margin | median | within 2° | within 5° "
        "| within 10° |", "|---|---|---|---|---|---|---|",
    ]  # fmt: skip
    for name, own in ((f"{100 * SURE:.0f} % surest", ordered[:cut]), ("others", ordered[cut:])):
        span = f"{float(own[-1]['margin']):.2f} to {float(own[0]['margin']):.2f}"
        cells = [name, str(len(own)), span, *error_cells(column(own, "error_deg"))]
        lines.append(f"| {' | '.join(cells)} |")
    near = [r for r in rows if float(r["error_deg"]) <= BAD]
    inside = [float(r["error_deg"]) <= float(r["width_deg"]) for r in near]
    remark = (
        f"Of the errors up to {BAD:g}°, {share(inside)} are within the width derived from the "
        "loss's curvature."
    )
    return [*lines, "", remark, ""]


def _groups(rows: Sequence[Row]) -> list[str]:
    """Return tables of the errors by how distinctive the picture is, and the worst cases."""
    head = ["| cases with | number | median | within 2° | within 5° | within 10° |",
            "|---|---|---|---|---|---|"]  # fmt: skip
    lines: list[str] = []
    for name, field, edges in (
        ("difference to the most similar other side", "apart", (0.0, 0.08, 0.16, np.inf)),
        ("share hidden", "hidden", (0.0, 0.05, 0.1, np.inf)),
        ("pixels across", "pixels", (0.0, 60, 120, np.inf)),
    ):
        for low, high in itertools.pairwise(edges):
            own = [r for r in rows if low <= float(r[field]) < high]
            if own and len(own) < len(rows):
                span = f"under {high:g}" if low == 0 else f"{low:g} to {high:g}"
                span = span if np.isfinite(high) else f"{low:g} and more"
                cells = [f"{name}: {span}", str(len(own)),
                         *error_cells(column(own, "error_deg"))]  # fmt: skip
                lines.append(f"| {' | '.join(cells)} |")
    lines = [*head, *lines] if lines else []
    worst = sorted(
        (r for r in rows if float(r["error_deg"]) > BAD), key=lambda r: -float(r["error_deg"])
    )
    by_kind: dict[str, list[Row]] = defaultdict(list)
    for r in worst:
        by_kind[str(r["object"]).partition(":")[0]].append(r)
    lines += ["", f"More than {BAD:g}° off: {share([r in worst for r in rows])} of the cases."]
    for kind, own in by_kind.items():
        shown = ", ".join(f"{float(r['error_deg']):.0f}° (case {r['case']})" for r in own)
        lines.append(f"- {kind}: {shown}")
    return [*lines, ""]


def sheet(rows: Sequence[Row], draw: Draw, count: int = 12) -> UInt8[np.ndarray, "h w 3"]:
    """Draw the worst cases: the stage's input, the true yaw and the estimated one."""
    shown = [r for r in rows if not r["error"]]
    worst = sorted(shown, key=lambda r: -float(r["error_deg"]))[:count]
    pictures, captions = [], []
    for r in worst:
        case = draw_case(draw, int(r["case"]))
        crop = np.asarray(case.instance.crop).copy()
        crop[crop[..., 3] == 0] = (255, 255, 255, 255)
        turn = np.deg2rad(float(r["found_deg"]) - float(r["azimuth_off_deg"]))
        for yaw in (case.yaw, float(turn)):
            drawn, _ = close_up(case.true, yaw, case.position, case.camera, case.light, side=_CELL)
            image = np.where(drawn[..., 3:] > 0, drawn[..., :3], 1.0)
            pictures.append((255 * image).astype(np.uint8))
        pictures.insert(-2, crop)
        captions += [
            f"{r['case']} {r['config']} {case.variant}", f"true {r['yaw_deg']}°",
            f"found {r['found_deg']}°, off {float(r['error_deg']):.1f}°",
        ]  # fmt: skip
    return grid(pictures, captions, columns=6, cell=_CELL)
