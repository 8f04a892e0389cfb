"""The ``evaluate`` command, which measures scenes."""

from __future__ import annotations

import contextlib
import dataclasses
import sys
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from tyro.conf import Positional, arg

from ..backends import Backends
from ..backends.paid_run import scene_key
from ..errors import DryRunError, InputError, escape
from .output import emit, find, one, some
from .paid_options import NO_CALLS, Calls, answering, print_dry_run

if TYPE_CHECKING:
    from ..evaluation import Evaluation
    from ..evaluation.judged import Picture
    from ..evaluation.surfaces.collisions import Rates


def evaluate(
    bundles: Annotated[Positional[tuple[str, ...]], arg(metavar="BUNDLE [BUNDLE ...]")],
    /,
    *,
    picture: Path | None = None,
    truth: str | None = None,
    sweep: bool = False,
    judge: str | None = None,
    calls: Calls = NO_CALLS,
    json: bool = False,
) -> int:
    """Measure scenes: collisions, support, stability, sizes, and similarity to a picture.

    The exit code is 1 if any defect is found.

    Args:
        bundles: Names, digests, glob patterns or paths of bundles, or result folders of other
            methods with a transforms.json (see the guide "Measure a scene").
        picture: The picture to compare with; defaults to the one in each bundle.
        truth: A bundle with the true scene; objects are matched by name.
        sweep: Also search 160 views for the one closest to the picture (about 20 s per scene).
        judge: Backend whose reasoner rates each scene from 1 to 7 (VF, IA, PP), and ranks the
            scenes if --picture and several bundles are given. The embedded backend cannot judge.
        calls: With --judge: cost limit of server requests, and the cache of their responses.
        json: Print a JSON object instead of tables.
    """
    from ..bundle import load
    from ..evaluation import evaluate_bundle, rates
    from ..evaluation.external import TRANSFORMS
    from ..evaluation.judged import as_judge
    from ..evaluation.perceptual import available
    from ..method.reference import read_image

    session, asked, who = None, None, None
    if judge is not None:
        session = calls.session()
        backends = Backends.select(reasoner=judge, session=session)
        as_judge(backends.reasoner)  # fail before anything is measured
        asked, who = backends.reasoner, backends.identity()["reasoner"]
    elif calls != NO_CALLS:
        raise InputError(
            "--budget, --dry-run, --calls and --prices apply to a judge; select one with --judge."
        )
    given = None if picture is None else read_image(picture)
    true = None if truth is None else load(one(truth))
    metrics = available() if sweep else None
    paths: list[Path] = []
    for wanted in some(bundles):
        folder = Path(wanted)
        paths += [folder] if (folder / TRANSFORMS).is_file() else find(wanted)
    scene = scene_key("evaluate", who, [str(path.resolve()) for path in paths], picture)
    with answering(session, scene) if session is not None else contextlib.nullcontext():
        measure = partial(evaluate_bundle, picture=given, truth=true, metrics=metrics, judge=asked)
        found, order, would = _measure(paths, measure, given, asked)
    if calls.dry_run:
        return print_dry_run(DryRunError("\n".join(would)), json)
    summary = rates(e.collisions for _, e in found)
    if json:
        scenes = [{"bundle": path, **e.facts()} for path, e in found]
        facts = {"scenes": scenes, "rates": dataclasses.asdict(summary)}
        if order:
            facts["ranking"] = list(order)
        if session is not None and session.account.entries:
            facts["ledger"] = session.account.facts(session.prices)
        emit(facts, True, list)
    else:
        _print(found, summary)
        if order:
            print(f"ranking by {judge}, best first: {', '.join(map(escape, order))}")
        if session is not None and (spent := session.account.text(session.prices.currency)):
            print(escape(spent))
    return 0 if all(e.flawless for _, e in found) else 1


def _measure(
    paths: Sequence[Path],
    measure: Callable[[Path], Evaluation],
    picture: Picture | None,
    judge: object | None,
) -> tuple[list[tuple[str, Evaluation]], tuple[str, ...], list[str]]:
    """Return the scenes' measurements, their ranking, and the judge's calls in a dry run."""
    from ..evaluation import ranking

    found: list[tuple[str, Evaluation]] = []
    order: tuple[str, ...] = ()
    would: list[str] = []
    for path in paths:
        try:
            found.append((str(path), measure(path)))
        except DryRunError as error:  # the other scenes still list their calls
            would.append(str(error))
    if judge is not None and picture is not None and 1 < len(found) == len(paths):
        try:
            order = ranking(dict(found), picture, judge)
        except DryRunError as error:
            would.append(str(error))
    return found, order, would


def _print(found: list[tuple[str, Evaluation]], summary: Rates) -> None:
    from rich.console import Console
    from rich.table import Table

    console = Console(file=sys.stdout, highlight=False, markup=False, emoji=False)
    for path, evaluation in found:
        console.print(escape(path), soft_wrap=True)
        for line in _lines(evaluation.facts()):
            console.print(escape(f"  {line}"), soft_wrap=True)
        if evaluation.flawless:
            console.print("  no defects found")
            continue
        table = Table("object", "defect", "what", "measured", "limit", "by")
        for f in evaluation.findings:
            value = "" if f.value is None else f"{f.value:.3g} {f.unit}"
            limit = "" if f.limit is None else f"{f.limit:.3g} {f.unit}"
            table.add_row(escape(f.name), f.kind, escape(f.text), value, limit, f.evidence)
        console.print(table)
    print(
        f"{summary.scenes} scenes, {sum((e.flawless for _, e in found))} without defects; Col_O "
        f"{100 * summary.col_o:.2f} % of {summary.pairs} pairs, Col_S {100 * summary.col_s:.1f} "
        "%"
    )


def _lines(facts: dict[str, Any]) -> list[str]:
    """Return the measurements that are not defects by themselves."""
    lines = [f"{facts['objects']} objects, {facts['collisions']['pairs']} pairs"]
    if held := facts["soundness"]:
        lines.append(
            f"after {held['seconds']:g} s: maximum drift {held['most_drift_mm']} mm, maximum "
            f"rotation {held['most_turn_deg']} deg"
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
        lines.append(f"compared with the truth, {true['matched']} matched: " + ", ".join(shown))
    marks = [f"{k} {facts['marks'][k]}" for k in ("VF", "IA", "PP") if facts["marks"][k]]
    lines.append(f"ratings ({facts['marks']['judge']}): " + ", ".join(marks))
    return lines + [f"note: {note}" for note in facts["notes"]]
