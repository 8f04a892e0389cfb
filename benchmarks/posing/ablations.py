"""Whole scenes rebuilt without some stages (Sec. 4.3): the runs, their metrics, the table."""

from __future__ import annotations

import dataclasses
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from types import MappingProxyType

import numpy as np
from jaxtyping import UInt8

from generator.backends import Backends
from generator.bundle import Segments
from generator.comparison import compare as compared
from generator.errors import TabletopError
from generator.evaluation import best_views, collisions
from generator.evaluation.perceptual import EMBEDDED
from generator.evaluation.surfaces.sweep import SweepConfig
from generator.generation import Config, Generation
from generator.geometry import yaw_quaternion
from generator.method.refinement import RefinementConfig
from generator.pipeline import generate
from generator.render.sheet import grid
from generator.scene import Pose, Scene

from . import scenes, tables
from .figures import column, median, share
from .remembering import remembering
from .tables import Row
from .truth import Truth, draw_truth

FULL = "full, refined"
VARIANTS: Mapping[str, Config] = MappingProxyType({
    FULL: Config(leave_out=0),
    "full": Config(leave_out=0, refinement=RefinementConfig(steps=0)),
    "w/o DRO": Config(leave_out=0, without=("dro",)),
    "w/o TSA": Config(leave_out=0, without=("tsa",)),
    "w/o both": Config(leave_out=0, without=("dro", "tsa")),
})  # fmt: skip
"""The rows of the table. The paper has no refinement: its "Ours (full)" corresponds to "full"."""

KEY = ("scene",)
OBJECT = ("object", "category", "on", "found", "yaw_state", "yaw_error_deg", "place_percent",
          "size_percent", "size_relative_percent", "support_right")  # fmt: skip
SCENE = ("pairs", "placed_overlaps", "placed_sunk", "made_overlaps", "made_sunk", "moved_mm",
         "farthest_mm", "published", "mean_iou", *EMBEDDED,
         *(f"{m}_sweep" for m in EMBEDDED))  # fmt: skip
FIELDS = ("scene", "variant", "of", "text", *OBJECT, *SCENE, "cpu_seconds", "error")

_SWEEP = SweepConfig(
    elevations=tuple(float(e) for e in range(70, 19, -10)),
    distances=tuple(round(1 + 0.2 * k, 1) for k in range(8)),
)
_TILE = 300
_FAR = 10.0  # millimetres


@dataclass(frozen=True)
class AblationRun:
    """Settings of the rows besides the scene; ``strips`` is the folder of its pictures.

    ``text`` is the text of every scene; without it, each scene has a theme.
    """

    split: str
    seed: int
    strips: Path
    text: str = ""


def as_placed(scene: Scene) -> Scene:
    """Return the scene with every object as placed by the picture's stages, before separation."""
    objects = [
        dataclasses.replace(
            o, pose=Pose(o.placement.translation, yaw_quaternion(o.placement.yaw))
        )
        for o in scene.objects
    ]  # fmt: skip
    return scene.replace(objects=tuple(objects))


def rows_of(truth: Truth, made: Generation, seconds: float) -> list[Row]:
    """Return one row for each object in the picture; poses are those as placed."""
    scene, placed = made.scene, as_placed(made.scene)
    before, after = collisions(placed), collisions(scene)
    moved = [
        1e3 * float(np.linalg.norm((b.pose.position - a.pose.position)[:2]))
        for a, b in zip(placed.objects, scene.objects, strict=True)
    ]
    picture = np.asarray(truth.picture)
    sweep = dataclasses.replace(_SWEEP, azimuth=scene.view.azimuth)
    metrics = tuple(EMBEDDED.values())
    swept = best_views(scene, picture, metrics, sweep)
    held = compared(scene, Segments.of(made.instances), picture)
    shared = {
        "text": truth.text,
        "pairs": before.pairs,
        "placed_overlaps": len(before.overlaps),
        "placed_sunk": len(before.sunk),
        "made_overlaps": len(after.overlaps),
        "made_sunk": len(after.sunk),
        "moved_mm": round(float(np.median(moved)), 2),
        "farthest_mm": round(max(moved), 2),
        "published": int(scene.report is not None and scene.report.passed),
        "mean_iou": round(held.mean_iou, 4),
        "cpu_seconds": round(seconds, 1),
        **{m.name: round(float(m.score([held.rendered.image], picture)[0]), 4) for m in metrics},
        **{f"{b.metric}_sweep": round(b.value, 4) for b in swept},
    }
    errors = scenes.compare(truth, dataclasses.replace(made, scene=placed), seconds)
    blank = dict.fromkeys(FIELDS, "")
    return [blank | {f: row[f] for f in OBJECT} | shared for row in errors]


def work(number: int, run: AblationRun) -> list[Row]:
    """Draw one scene, rebuild it in each variant, and compare; a failure is also a row."""
    rows: list[Row] = []
    tiles: dict[str, UInt8[np.ndarray, "h w 3"]] = {}
    try:
        truth = draw_truth(run.split, run.seed, number, run.text)
        tiles["picture"] = np.asarray(truth.picture)
        backends = remembering(Backends.select("embedded"))
    except TabletopError as error:
        return [
            dict.fromkeys(FIELDS, "") | {"scene": number, "of": 1, "error": tables.failure(error)}
        ]
    for variant, config in VARIANTS.items():
        begin = time.process_time()
        try:
            made = generate(np.asarray(truth.picture), backends, config, seed=number)
            new = rows_of(truth, made, time.process_time() - begin)
            tiles[variant] = _tile(made)
        except Exception as error:  # one variant must not abort the run
            new = [dict.fromkeys(FIELDS, "") | {"error": tables.failure(error)}]
        rows += [r | {"variant": variant} for r in new]
    write_strip(tiles, number, run.strips)
    return [r | {"scene": number, "of": len(rows)} for r in rows]


def _tile(made: Generation) -> UInt8[np.ndarray, "h w 3"]:
    """Draw the scene as placed, from the picture's camera."""
    picture = np.asarray(made.reference.image)
    return compared(as_placed(made.scene), Segments.of(made.instances), picture).rendered.image


def write_strip(tiles: Mapping[str, UInt8[np.ndarray, "h w 3"]], number: int, folder: Path) -> None:
    """Write one scene's pictures side by side for ``sheet``, with their names as captions."""
    from PIL import Image

    folder.mkdir(parents=True, exist_ok=True)
    shown = {name: tile for name, tile in tiles.items() if name != FULL}
    strip = grid(list(shown.values()), list(shown), columns=len(shown), cell=_TILE)
    margin = (_TILE - 3 * _TILE // 4) // 2  # of the square cells, above 4:3 pictures
    Image.fromarray(strip[margin:]).save(folder / f"{number:03d}.png")


def sheet(numbers: Sequence[int], folder: Path) -> UInt8[np.ndarray, "h w 3"] | None:
    """Return the strips of some scenes below one another, or None if there are none."""
    from PIL import Image

    paths = [p for n in numbers if (p := folder / f"{n:03d}.png").is_file()]
    strips = [np.asarray(Image.open(p).convert("RGB")) for p in paths]
    width = max((s.shape[1] for s in strips), default=0)
    even = [np.pad(s, ((0, 0), (0, width - s.shape[1]), (0, 0)), constant_values=255)
            for s in strips]  # fmt: skip
    return np.concatenate(even) if even else None


def run(
    how: AblationRun, cases: int, workers: int, table: Path, command: str, note: str = ""
) -> str:
    """Run the scenes that are missing in ``table``; return the table of all as Markdown.

    ``note`` holds a person's observations, which are printed below the table.
    """
    asked = {(str(k),): k for k in range(cases)}
    job = partial(work, run=how)
    rows = tables.complete(table, FIELDS, KEY, asked, job, workers, _say, of="of")
    return summary(rows, command, note)


def _say(rows: list[Row]) -> str:
    cells = [f"{v} {median(column(_of(rows, v), 'place_percent'))}" for v in VARIANTS]
    return f"scene {rows[0]['scene']} {rows[0]['text']}: place error, %: {', '.join(cells)}"


def _of(rows: Sequence[Row], variant: str) -> list[Row]:
    return [r for r in rows if r["variant"] == variant and not r["error"]]


def cells(rows: Sequence[Row]) -> list[str]:
    """Return one variant's cells of the table, in the order of ``HEAD``."""
    found = [r for r in rows if int(r["found"])]
    firsts = list({str(r["scene"]): r for r in rows}.values())
    pairs = max(float(column(firsts, "pairs").sum()), 1.0)
    yaw, farthest = column(found, "yaw_error_deg"), column(firsts, "farthest_mm")
    right = share(scenes.yaw_errors(found) <= 15)

    def rates(when: str) -> str:
        hits, sunk = column(firsts, f"{when}_overlaps"), column(firsts, f"{when}_sunk")
        return f"{100 * hits.sum() / pairs:.2f}, {share(hits + sunk > 0)}"

    return [
        f"{median(yaw, '°')}, {right}, {median(np.minimum(yaw, 180 - yaw), '°')}",
        median(column(found, "place_percent"), " %"),
        f"{median(np.abs(column(found, 'size_percent')), ' %')}, "
        f"{median(np.abs(column(found, 'size_relative_percent')), ' %')}",
        share(column(found, "support_right") > 0),
        rates("placed"),
        rates("made"),
        f"{share(farthest > _FAR)}, {median(farthest)}",
        share(column(firsts, "published") > 0),
        *(_mean(firsts, m) for m in ("mean_iou", *EMBEDDED)),
        ", ".join(_mean(firsts, f"{m}_sweep") for m in EMBEDDED),
    ]


def _mean(rows: Sequence[Row], field: str) -> str:
    values = column(rows, field)
    return f"{values.mean():.3f}" if len(values) else "-"


HEAD = (
    "yaw error of the evaluated objects, median; ≤ 15° (excluding round models); of the axis "
    "alone, median",
    "position error, of the table's width",
    "size error; relative to the table",
    "support right",
    "Col_O %, Col_S as placed",
    "Col_O %, Col_S after separation",
    "scenes in which an object was moved > 10 mm; largest displacement, mm, median",
    "gate passed",
    "outline overlap",
    *EMBEDDED,
    "the same two, best of a sweep",
)


def summary(rows: Sequence[Row], command: str, note: str = "") -> str:
    """Return the results as Markdown."""
    scenes_run = {str(r["scene"]) for r in rows}
    lines = [
        f"# Ablations: {len(scenes_run)} scenes rebuilt from their picture without some stages",
        f"`{command}`, {tables.where()}",
        "",
        "The rows are those of the paper's Table 3, with the joint refinement on top. Disabled "
        "stages are replaced by guesses of the embedded reasoner, a naive reading of the picture "
        "without a language model: the rows compare stages of this project with one another, not "
        "with the paper's. Errors, and the first Col_O and Col_S, are those of the objects as "
        "placed, before separation; the other values are those of the finished scene. Supports "
        "are the same in all rows.",
        "",
        "| | " + " | ".join(HEAD) + " |",
        "|---" * (len(HEAD) + 1) + "|",
        *("| " + " | ".join([v, *cells(_of(rows, v))]) + " |" for v in VARIANTS),
        "",
        "Col_O is over all pairs of objects, overlaps from 0.5 mm. Outline overlap (mean mask "
        "IoU) and the two embedded scores, which are not LPIPS, DINOv2 or CLIP, are from the "
        "picture's camera; the last column has the two scores as in the paper, each in the best "
        f"of {len(_SWEEP.elevations) * len(_SWEEP.distances)} views of a sweep that does not know "
        "the camera.",
    ]
    lines += ["", note] if note else []
    failed = {(str(r["scene"]), r["variant"] or "all", r["error"]) for r in rows if r["error"]}
    lines += [f"- scene {s}, {v}: {error}" for s, v, error in sorted(failed)]
    return "\n".join([*lines, ""])
