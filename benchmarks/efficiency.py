"""Seconds per stage (Sec. 6.2): texts of 6 to 9 objects through ``generator.pipeline.generate``.

    python benchmarks/efficiency.py --cases 20
    python benchmarks/efficiency.py --cases 20 --device cuda

Uses the first texts of ``benchmarks/table78.json`` whose plan has 6 to 9 objects, in the file's
order. Writes one row per scene to ``efficiency_<device>.csv`` (a second run resumes), then the
table to ``efficiency_<device>.md`` and one bar per scene to ``efficiency_<device>.png``. Seconds
are the pipeline's own (``Generation.seconds``): wall-clock, and CPU time of this process without
that of convex decomposition, which has its own process. ``--device`` is the device of the rotation
stage. The first scene includes loading. Run it alone on the machine; ``--note`` is added to the
table's head, for instance if it was not alone.
"""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from functools import partial
from pathlib import Path
from types import MappingProxyType

import numpy as np
from jaxtyping import UInt8
from PIL import Image, ImageDraw, ImageFont
from posing import tables
from posing.figures import column
from posing.tables import Row

from generator.errors import TabletopError
from generator.generation import STAGES, Config
from generator.io.pictures import write_picture
from generator.language.planner import plan_scene
from generator.method.rotation import RotationConfig
from generator.pipeline import generate

HERE = Path(__file__).parent
FEWEST, MOST = 6, 9
KEY = ("text", "seed")
FIELDS = (
    "text", "seed", "planned", "built", "wall_total", "cpu_total",
    *(f"wall_{s.replace(' ', '_')}" for s in STAGES),
    *(f"cpu_{s.replace(' ', '_')}" for s in STAGES), "error",
)  # fmt: skip
PAPER: Mapping[str, float] = MappingProxyType(
    {"extraction": 240.0, "modeling": 830.0, "rotation": 810.0, "alignment": 50.0}
)
"""Seconds in Sec. 6.2 for a scene of 9 objects (RTX 4090, models behind an API)."""

_COLORS = ((148, 148, 148), (31, 119, 180), (148, 90, 180), (220, 130, 20), (214, 69, 65),
           (44, 140, 60), (120, 180, 210), (90, 90, 90))  # fmt: skip
_INK, _PALE = (40, 44, 52), (222, 226, 232)


def texts_of(path: Path, cases: int, seed: int) -> list[tuple[str, int]]:
    """Return the first texts of a file whose plan has 6 to 9 objects, with that number."""
    found = []
    for text in tables.texts_in(path):
        count = len(plan_scene(text, seed).objects)
        if FEWEST <= count <= MOST:
            found.append((text, count))
    return found[:cases]


def work(job: tuple[str, int], seed: int, device: str) -> list[Row]:
    """Make one scene and return its seconds; a failure is also a row."""
    text, planned = job
    row: Row = dict.fromkeys(FIELDS, "") | {"text": text, "seed": seed, "planned": planned}
    try:
        made = generate(text, config=Config(rotation=RotationConfig(device=device)), seed=seed)
    except Exception as error:  # one text must not abort the run
        return [row | {"error": tables.failure(error)}]
    for stage, spent in made.seconds.items():
        row[f"wall_{stage.replace(' ', '_')}"] = round(spent.wall, 3)
        row[f"cpu_{stage.replace(' ', '_')}"] = round(spent.cpu, 3)
    row["wall_total"] = round(sum(s.wall for s in made.seconds.values()), 2)
    row["cpu_total"] = round(sum(s.cpu for s in made.seconds.values()), 2)
    return [row | {"built": len(made.scene.objects)}]


def say(rows: list[Row]) -> str:
    (row,) = rows
    label = row["error"] or f"{row['built']} objects, {row['wall_total']} s"
    return f"{row['text'][:50]!r}: {label}"


def summary(rows: Sequence[Row], command: str, note: str = "") -> str:
    """Return the table of medians as Markdown."""
    done = [r for r in rows if not r["error"]]
    total = column(done, "wall_total")
    lines = [
        f"# Seconds per stage: {len(done)} texts of {FEWEST} to {MOST} objects",
        f"`{command}`, {tables.where()}{'; ' + note if note else ''}",
        "",
        "| stage | seconds, median | 90 % within | share of all time | CPU seconds, median "
        "| paper, 9 objects |",
        "|---|---|---|---|---|---|",
    ]
    for stage in STAGES:
        wall, cpu = (column(done, f"{kind}_{stage.replace(' ', '_')}") for kind in ("wall", "cpu"))
        whole = 100 * wall.sum() / max(total.sum(), 1e-9)
        cells = [stage, *_middle(wall), f"{whole:.0f} %", _middle(cpu)[0]]
        cells.append(f"≈ {PAPER[stage]:.0f}" if stage in PAPER else "-")
        lines.append("| " + " | ".join(cells) + " |")
    cells = ["**all**", *_middle(total), "100 %", _middle(column(done, "cpu_total"))[0], "≈ 1920"]
    built = column(done, "built")
    each = total / np.maximum(built, 1)
    lines += [
        "| " + " | ".join(cells) + " |",
        "",
        f"{_middle(built)[0]} objects per scene (median), {_middle(each)[0]} s per object. The "
        "paper's seconds (Sec. 6.2) are those of other models, queried over the network, and of "
        "one GPU: they are listed to compare the shares of the stages.",
    ]
    lines += [f"- {r['text']!r} failed: {r['error']}" for r in rows if r["error"]]
    return "\n".join([*lines, ""])


def _middle(values: np.ndarray) -> list[str]:
    """Return the median and the 90th percentile as text."""
    if not len(values):
        return ["-", "-"]
    return [f"{np.median(values):.1f}", f"{np.percentile(values, 90):.1f}"]


def bars(rows: Sequence[Row]) -> UInt8[np.ndarray, "h w 3"]:
    """Draw one bar per scene with the wall-clock seconds of its stages."""
    done = [r for r in rows if not r["error"]]
    most = max((float(r["wall_total"]) for r in done), default=1.0)
    left, top, line, wide = 330, 62, 26, 620
    picture = Image.new("RGB", (left + wide + 70, top + line * len(done) + 16), "white")
    draw = ImageDraw.Draw(picture)
    small, large = ImageFont.load_default(13), ImageFont.load_default(17)
    draw.text((12, 8), "Seconds by stage", _INK, large)
    at = 12.0
    for color, stage in zip(_COLORS, STAGES, strict=True):
        draw.rectangle((at, 38, at + 12, 50), color)
        draw.text((at + 17, 37), stage, _INK, small)
        at += 34 + draw.textlength(stage, small)
    for number, row in enumerate(done):
        y = top + line * number
        label = f"{row['text'][:44]} ({row['built']})"
        draw.text((left - 10, y + line / 2), label, _INK, small, anchor="rm")
        x = float(left)
        for color, stage in zip(_COLORS, STAGES, strict=True):
            reach = wide * float(row[f"wall_{stage.replace(' ', '_')}"]) / most
            draw.rectangle((x, y + 4, x + reach, y + line - 4), color)
            x += reach
        draw.line((left, y, left + wide, y), _PALE)
        draw.text(
            (x + 6, y + line / 2), f"{float(row['wall_total']):.0f}", _INK, small, anchor="lm"
        )
    return np.asarray(picture, np.uint8)


def main() -> None:
    p = argparse.ArgumentParser(description=__doc__.splitlines()[0] if __doc__ else "")
    p.add_argument("--texts", type=Path, default=HERE / "table78.json")
    p.add_argument("--cases", type=int, default=20)
    p.add_argument("--seed", type=int, default=0)
    p.add_argument("--device", choices=("cpu", "cuda"), default="cpu")
    p.add_argument("--note", default="", help="a remark about the machine")
    p.add_argument("--out", type=Path, default=HERE / "results")
    args = p.parse_args()
    if args.cases < 1:
        raise SystemExit("--cases must be at least 1.")
    name = f"efficiency_{args.device}"
    jobs = texts_of(args.texts, args.cases, args.seed)
    try:
        args.out.mkdir(parents=True, exist_ok=True)
        table = args.out / f"{name}.csv"
        asked = {(job[0], str(args.seed)): job for job in jobs}
        job = partial(work, seed=args.seed, device=args.device)
        rows = tables.complete(table, FIELDS, KEY, asked, job, 1, say)
        write_picture(bars(rows), args.out / f"{name}.png")
    except TabletopError as error:
        raise SystemExit(str(error)) from error
    text = summary(rows, tables.command_line("--note"), args.note)
    (args.out / f"{name}.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
