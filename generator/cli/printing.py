"""What commands print: progress, scenes, JSON."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ..scene import Scene


@contextmanager
def progress(*, quiet: bool) -> Iterator[Callable[[str, int, int], None] | None]:
    """Show the running stage on standard error, if that is a terminal."""
    if quiet:
        yield None
        return
    from rich.console import Console

    console = Console(stderr=True)
    with console.status("starting") as status:

        def show(stage: str, number: int, total: int) -> None:
            status.update(f"[{number}/{total}] {stage}")
            if not console.is_terminal:
                console.print(f"[{number}/{total}] {stage}", highlight=False, markup=False)

        yield show


def describe(path: Path, scene: Scene) -> dict[str, Any]:
    """Return what a bundle holds, as JSON values."""
    report = scene.report
    return {
        "bundle": str(path),
        "name": scene.name,
        "table_m": [round(float(v), 3) for v in scene.table.scale],
        "objects": [
            {
                "name": o.name,
                "label": o.label,
                "size_m": [round(float(v), 3) for v in o.scale],
                "mass_kg": round(o.mass, 3),
                "position_m": [round(float(v), 3) for v in o.pose.position],
                "on": o.placement.on,
            }
            for o in scene.objects
        ],
        "passed": None if report is None else report.passed,
        "report": None if report is None else dataclasses.asdict(report),
        "warnings": list(scene.provenance.warnings),
    }


def print_scene(path: Path, scene: Scene, as_json: bool) -> int:
    """Print what a bundle holds; return the exit code of success."""
    facts = describe(path, scene)

    def lines() -> list[str]:
        rows = [
            f"  {o['name']:<22} {o['label']:<18} "
            + "x".join(f"{100 * v:.1f}" for v in o["size_m"])
            + f" cm  {o['mass_kg']:.3f} kg  on {o['on']}"
            for o in facts["objects"]
        ]
        report = scene.report
        gate = (
            "no report"
            if report is None
            else ("passed" if report.passed else "FAILED: " + "; ".join(report.failures))
        )
        notes = [f"  note: {w}" for w in facts["warnings"]]
        return [str(path), *rows, f"  gate: {gate}", *notes]

    emit(facts, as_json, lines)
    return 0


def emit(value: Any, as_json: bool, lines: Callable[[], list[str]]) -> None:
    """Print ``value`` as JSON, or the lines for people."""
    print(json.dumps(value, indent=2) if as_json else "\n".join(lines()))
