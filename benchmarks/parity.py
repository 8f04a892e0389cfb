"""Every shipped bundle in the engines of its exports: at rest, and on a leaning table.

    python benchmarks/parity.py --workers 2

Each bundle is exported and loaded by the export's script: MJCF into MuJoCo, URDF into PyBullet and
Drake, SDF into Drake. It is simulated for two seconds; then its flattest object is alone on the
table, which leans by 3 degrees more per second until the object has slid by 2 mm. Engines that are
not installed are listed in the summary (pip install 'tabletopgen[engines]'). Writes ``parity.csv``
and ``parity.md``; the exit code is 1 if an object moves by more than 2 mm at rest, or slides at an
angle more than 2 degrees from MuJoCo's. Everything is measured again unless ``--resume`` continues
an interrupted run.
"""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import numpy as np
from engines.simulations import ENGINES
from engines.trials import expected_friction, flattest, rest_drift, slide_angle
from posing import tables

import assets_cache
from generator.bundle import load
from generator.exports import export
from generator.exports.bodies import legal_names

HERE = Path(__file__).parent
SHIPPED = [str(HERE.parent / "assets_cache" / store) for store in ("starter", "tasks")]
"""Folders of the shipped bundles."""
FIELDS = ("bundle", "engine", "objects", "drift_mm", "moves", "slides", "angle", "error")
KEY = ("bundle", "engine")
REFERENCE = "MuJoCo"
MOST_DRIFT, MOST_ANGLE = 2.0, 2.0
"""Maximum displacement at rest, millimetres, and maximum difference from MuJoCo's angle,
degrees."""


def work(job: tuple[Path, str]) -> list[tables.Row]:
    """Run both trials of a bundle in an engine."""
    path, name = job
    row: tables.Row = dict.fromkeys(FIELDS, "") | {"bundle": bundle_name(path), "engine": name}
    try:
        row |= measure(path, name)
    except Exception as error:  # also an engine's own errors, which are recorded in the row
        row["error"] = tables.failure(error)
    return [row]


def measure(path: Path, name: str) -> dict[str, Any]:
    """Return the figures of a bundle in an engine."""
    scene, engine = load(path), ENGINES[name]
    thing = flattest(scene)
    names = [o.name for o in scene.objects]
    called = names if engine.to == "mjcf" else legal_names(names)
    with tempfile.TemporaryDirectory() as folder:
        written = export(scene, engine.to, folder)
        simulation = engine.open(written)
        try:
            drift, whose = rest_drift(simulation)
        finally:
            simulation.close()
        simulation = engine.open(written)
        try:
            angle = slide_angle(
                simulation, called[names.index(thing.name)], expected_friction(scene, thing)
            )
        finally:
            simulation.close()
    return {
        "objects": len(scene.objects), "drift_mm": f"{1000 * drift:.3f}", "moves": whose,
        "slides": thing.name, "angle": f"{angle:.2f}",
    }  # fmt: skip


def bundle_name(path: Path) -> str:
    """Return a bundle's name without its digest."""
    return path.name.rpartition("-")[0]


def say(rows: list[tables.Row]) -> str:
    (row,) = rows
    figures = f"{row['drift_mm']} mm at rest ({row['moves']}), slides at {row['angle']}°"
    return f"{row['bundle']} in {row['engine']}: {row['error'] or figures}"


def reference_angles(rows: Sequence[tables.Row]) -> dict[str, float]:
    """Return the angles of the reference engine, by bundle."""
    return {
        row["bundle"]: float(row["angle"])
        for row in rows
        if row["engine"] == REFERENCE and row["angle"]
    }


def faults(rows: Sequence[tables.Row]) -> list[str]:
    """Return the violations, one line each."""
    angles = reference_angles(rows)
    found = []
    for row in rows:
        off = abs(float(row["angle"] or "nan") - angles.get(row["bundle"], np.nan))
        if row["error"] or not float(row["drift_mm"]) <= MOST_DRIFT or not off <= MOST_ANGLE:
            found.append(say([row]))
    return found


def summary(rows: Sequence[tables.Row], command: str) -> str:
    """Return drifts and angles as Markdown."""
    engines = [e for e in ENGINES if any(r["engine"] == e for r in rows)]
    cells = {(r["bundle"], r["engine"]): r for r in rows}
    bundles = list(dict.fromkeys(r["bundle"] for r in rows))
    lines = [
        f"`{command}`, {tables.where()}.",
        "",
        "Maximum displacement of any object in 2 s at rest, mm, and the angle at which the "
        "flattest object slides, degrees.",
        "",
        "| bundle | objects | slides | " + " | ".join(engines) + " |",
        "|---" * (3 + len(engines)) + "|",
    ]
    for bundle in bundles:
        of = [cells[bundle, engine] for engine in engines]
        figures = " | ".join(r["error"] or f"{r['drift_mm']} mm, {r['angle']}°" for r in of)
        lines.append(f"| {bundle} | {of[0]['objects']} | {of[0]['slides']} | {figures} |")
    lines += ["", *(_totals(rows, engine, len(bundles)) for engine in engines)]
    lines += [f"- {name} is not installed: NOT CHECKED." for name in ENGINES if name not in engines]
    wrong = faults(rows)
    lines += ["", f"Out of bounds: {len(wrong)}.", *(f"- {line}" for line in wrong), ""]
    return "\n".join(lines)


def _totals(rows: Sequence[tables.Row], engine: str, bundles: int) -> str:
    """Return a line with an engine's extremes."""
    angles = reference_angles(rows)
    of = [r for r in rows if r["engine"] == engine and not r["error"]]
    still = sum(float(r["drift_mm"]) <= MOST_DRIFT for r in of)
    most = max((float(r["drift_mm"]) for r in of), default=np.nan)
    off = [abs(float(r["angle"]) - angles.get(r["bundle"], np.nan)) for r in of]
    return (
        f"- {engine}: {still} of {bundles} at rest within {MOST_DRIFT:g} mm, at most {most:.3f} "
        f"mm; slides within {max(off, default=np.nan):.1f}° of {REFERENCE}'s angle."
    )


def main() -> None:
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("--bundles", nargs="+", default=SHIPPED, help="names, globs or paths")
    parser.add_argument("--engines", nargs="+", choices=[*ENGINES], default=[*ENGINES])
    parser.add_argument("--workers", type=int, default=1)
    parser.add_argument(
        "--resume", action="store_true", help="keep the rows of an existing parity.csv"
    )
    parser.add_argument("--out", type=Path, default=HERE / "results")
    args = parser.parse_args()
    tables.alone()
    paths = [path for wanted in args.bundles for path in assets_cache.find(wanted)]
    here = [name for name in args.engines if ENGINES[name].installed]
    asked = {(bundle_name(p), name): (p, name) for p in paths for name in here}
    args.out.mkdir(parents=True, exist_ok=True)
    path = args.out / "parity.csv"
    rows = tables.complete(path, FIELDS, KEY, asked, work, args.workers, say, again=not args.resume)
    tables.write(path, FIELDS, rows)
    text = summary(rows, tables.command_line("--workers", "--out"))
    path.with_suffix(".md").write_text(text, encoding="utf-8")
    print(text)
    sys.exit(bool(faults(rows)))


if __name__ == "__main__":
    main()
