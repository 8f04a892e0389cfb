"""The command that measures scenes: ``evaluate``."""

from __future__ import annotations

import dataclasses
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tyro.conf import Positional

from .paying import answering, open_session, scene_key
from .printing import emit
from .store import find, one, some

if TYPE_CHECKING:
    from ..evaluation import Evaluation
    from ..running import Session


def evaluate(
    bundles: Positional[tuple[str, ...]],
    /,
    *,
    picture: Path | None = None,
    truth: str | None = None,
    sweep: bool = False,
    judge: str | None = None,
    budget: float | None = None,
    calls: Path | None = None,
    prices: Path | None = None,
    json: bool = False,
) -> int:
    """Measure scenes: collisions, what floats or drifts, sizes, likeness to picture and truth.

    The exit code is 1 if any defect is found.

    Args:
        bundles: Names, digests, globs or paths of bundles; or folders of another method's result
            with a transforms.json (see the README).
        picture: The picture to compare with; the one each bundle keeps if left out.
        truth: A bundle taken as the true scene, objects matched by name.
        sweep: Also look from 160 views for the one nearest to the picture (about 20 s a scene).
        judge: Backend whose reasoner marks each scene from 1 to 7 (VF, IA, PP), and ranks them if
            --picture and several bundles are given. The embedded one cannot.
        budget: What the judge may cost; as for generate.
        calls: Folder where the judge's answers are kept; as for generate.
        prices: Table of what calls cost (TOML); as for generate.
        json: Print one JSON object instead of tables.
    """
    from ..bundle import load
    from ..evaluation import rates, report
    from ..evaluation.perceptual import available
    from ..stages.reference import read_image

    session = open_session(calls, prices, budget, dry=False)
    asked = None if judge is None else _judge(judge, session)
    given = None if picture is None else read_image(picture)
    true = None if truth is None else load(one(truth))
    metrics = available() if sweep else None
    paths = _paths(bundles)
    found: list[tuple[str, Evaluation]] = []
    order: tuple[str, ...] = ()
    with answering(session, scene_key("evaluate", judge, *map(str, paths), picture)):
        for path in paths:
            evaluation = report.evaluate_bundle(
                path, picture=given, truth=true, metrics=metrics, judge=asked
            )
            found.append((str(path), evaluation))
        if asked is not None and given is not None and len(found) > 1:
            order = report.ranking(dict(found), given, asked)
    summary = rates(e.collisions for _, e in found)
    if json:
        scenes = [{"bundle": path, **e.facts()} for path, e in found]
        told = {"scenes": scenes, "rates": dataclasses.asdict(summary)}
        emit(told | ({"ranking": list(order)} if order else {}), True, list)
    else:
        _print(found)
        print(
            f"{summary.scenes} scenes, {sum(e.flawless for _, e in found)} without a defect; "
            f"Col_O {100 * summary.col_o:.2f} % of {summary.pairs} pairs, "
            f"Col_S {100 * summary.col_s:.1f} %"
        )
        if order:
            print(f"ranked by {judge}, the best first: {', '.join(order)}")
        if spent := session.account.text(session.prices.currency):
            print(spent)
    return 0 if all(e.flawless for _, e in found) else 1


def _judge(backend: str, session: Session) -> object:
    """Return a backend's reasoner as a judge, before anything is measured."""
    from ..backends import Backends
    from ..evaluation.judged import as_judge

    return as_judge(Backends.select(reasoner=backend, session=session).reasoner)


def _paths(bundles: tuple[str, ...]) -> list[Path]:
    from ..evaluation.external import TRANSFORMS

    paths: list[Path] = []
    for wanted in some(bundles):
        folder = Path(wanted)
        paths += [folder] if (folder / TRANSFORMS).is_file() else find(wanted)
    return paths


def _print(found: list[tuple[str, Evaluation]]) -> None:
    from rich.console import Console
    from rich.table import Table

    console = Console(file=sys.stdout, highlight=False, markup=False, emoji=False)
    for path, evaluation in found:
        console.print(path, soft_wrap=True)
        for line in _lines(evaluation.facts()):
            console.print(f"  {line}", soft_wrap=True)
        if evaluation.flawless:
            console.print("  no defect found")
            continue
        table = Table("object", "defect", "what", "measured", "limit", "by")
        for f in evaluation.findings:
            value = "" if f.value is None else f"{f.value:.3g} {f.unit}"
            limit = "" if f.limit is None else f"{f.limit:.3g} {f.unit}"
            table.add_row(f.name, f.kind, f.text, value, limit, f.evidence)
        console.print(table)


def _lines(facts: dict[str, Any]) -> list[str]:
    """Return the figures that are no defects by themselves."""
    lines = [f"{facts['objects']} objects, {facts['collisions']['pairs']} pairs"]
    if held := facts["soundness"]:
        lines.append(
            f"after {held['seconds']:g} s: largest drift {held['most_drift_mm']} mm, largest turn "
            f"{held['most_turn_deg']} deg"
        )
    if seen := facts["picture"]:
        lines.append(f"silhouettes: mean IoU {seen['mean_iou']:.2f}")
    lines += [
        f"{name}: {best['value']:.4f} from elevation {best['elevation_deg']:g} deg, "
        f"{best['distance_radii']:g} radii"
        for name, best in facts["perceptual"].items()
    ]
    lines += [f"no {reason}" for reason in facts["perceptual_missing"].values()]
    if true := facts["truth"]:
        names = {
            "mean_yaw_error_deg": "yaw error {:.2f} deg",
            "mean_translation_error_cm": "translation error {:.2f} cm",
            "mean_translation_error_percent_of_table": "{:.2f} % of the table's width",
            "support_accuracy": "support accuracy {:.2f}",
        }
        shown = [text.format(true[k]) for k, text in names.items() if true[k] is not None]
        lines.append(f"against the truth, {true['matched']} matched: " + ", ".join(shown))
    marks = [f"{k} {facts['marks'][k]}" for k in ("VF", "IA", "PP") if facts["marks"][k]]
    lines.append(f"marks ({facts['marks']['judge']}): " + ", ".join(marks))
    return lines + [f"note: {note}" for note in facts["notes"]]
