"""Output of the commands (progress, scenes, JSON) and look-up of bundles in arguments."""

from __future__ import annotations

import dataclasses
import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from ..errors import escape

if TYPE_CHECKING:
    from ..calls import Session
    from ..comparison.doubts import PictureMatch
    from ..imports.foreign import ImportOutcome
    from ..method.stopwatch import Seconds
    from ..scene import Scene


from ..errors import InputError
from ..io.files import check_folder


@contextmanager
def progress(*, quiet: bool) -> Iterator[Callable[[str, int, int], None] | None]:
    """Show the running stage on standard error if it is a terminal."""
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
    """Return the content of a bundle as JSON values."""
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
                **({"stand_in": True} if o.model.stand_in else {}),
            }
            for o in scene.objects
        ],
        "passed": None if report is None else report.passed,
        "report": None if report is None else report.as_json(),
        "warnings": list(scene.provenance.warnings),
    }


def print_scene(
    path: Path,
    scene: Scene,
    as_json: bool,
    seconds: Mapping[str, Seconds] | None = None,
    session: Session | None = None,
    likeness: PictureMatch | None = None,
    outcomes: Sequence[ImportOutcome] = (),
) -> int:
    """Print a bundle, its likeness to its picture, times and calls; return exit code 0.

    ``outcomes`` are the results of an import, whose details repeat warnings of the scene.
    """
    facts = describe(path, scene)
    if outcomes:
        facts["outcomes"] = [dataclasses.asdict(outcome) for outcome in outcomes]
    if likeness is not None and likeness.mean_iou is not None:
        facts["mean_iou"] = round(likeness.mean_iou, 3)
    if session is not None and session.account.entries:
        facts["ledger"] = session.account.facts(session.prices)
    if seconds is not None:
        facts["seconds"] = {
            stage: {"wall": round(s.wall, 3), "cpu": round(s.cpu, 3)}
            for stage, s in seconds.items()
        }

    def lines() -> list[str]:
        rows = [
            f"  {o['name']:<22} {o['label']:<18} "
            + "x".join(f"{100 * v:.1f}" for v in o["size_m"])
            + f" cm  {o['mass_kg']:.3f} kg  on {o['on']}"
            + ("  (stand-in)" if o.get("stand_in") else "")
            for o in facts["objects"]
        ]
        gate = "no report"
        if report := scene.report:
            gate = "passed" if report.passed else f"FAILED: {report.failure_text}"
        like = [(
            f"  likeness: {facts['mean_iou']:.2f} (mean overlap with the detected objects, from "
            "the picture's camera)"
        )] if "mean_iou" in facts else []  # fmt: skip
        listed = {str(outcome) for outcome in outcomes}
        notes = [f"  note: {w}" for w in facts["warnings"] if w not in listed]
        spent = "" if session is None else session.account.text(session.prices.currency)
        calls = ["  calls:", *(f"    {line}" for line in spent.splitlines())] if spent else []
        return [
            str(path),
            *rows,
            *outcome_lines(outcomes),
            f"  gate: {gate}",
            *like,
            *notes,
            *_timings(seconds or {}),
            *calls,
        ]

    emit(facts, as_json, lines)
    return 0


def outcome_lines(outcomes: Sequence[ImportOutcome]) -> list[str]:
    """Return a table of an import's result for each object."""
    rows = (f"    {o.name:<20} {o.kind:<9} {o.detail}".rstrip() for o in outcomes)
    return ["  import:", *rows] if outcomes else []


def _timings(seconds: Mapping[str, Seconds]) -> list[str]:
    """Return one line per stage, and one for the total."""
    if not seconds:
        return []
    rows = [(stage, s.wall, s.cpu) for stage, s in seconds.items()]
    rows.append(("total", sum(r[1] for r in rows), sum(r[2] for r in rows)))
    return ["  seconds:", *(f"    {n:<16}{wall:8.1f}  (CPU {cpu:.1f})" for n, wall, cpu in rows)]


def emit(value: Any, as_json: bool, lines: Callable[[], list[str]]) -> None:
    """Print ``value`` as JSON or as the lines of text."""
    print(json.dumps(value, indent=2) if as_json else escape("\n".join(lines())))


def store(out: Path | None) -> Path:
    """Return the folder for new bundles after checking it: ``out`` or the user cache."""
    import assets_cache

    if out is None:
        return assets_cache.user_root()
    check_folder(out)
    return out


def find(wanted: str) -> list[Path]:
    """Return the bundles, at least one, that match a name, digest, glob pattern or path."""
    import assets_cache

    return list(assets_cache.find(wanted))


def some(bundles: tuple[str, ...]) -> tuple[str, ...]:
    """Return the given bundle names, or raise InputError if there are none."""
    if not bundles:
        raise InputError("Specify at least one bundle; `tabletopgen cache list` lists them.")
    return bundles


def one(wanted: str) -> Path:
    """Return the only bundle that matches ``wanted``."""
    found = find(wanted)
    if len(found) > 1:
        names = ", ".join(p.name for p in found[:8])
        raise InputError(f"{wanted!r} matches {len(found)} bundles: {names}. Specify one of them.")
    return found[0]
