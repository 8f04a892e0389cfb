"""Tables of a study: Markdown with the paper's Table 2, CSV, and lines for a terminal."""

from __future__ import annotations

import csv
import io
from collections.abc import Callable, Sequence

from .design import CRITERIA, SHORT
from .statistics import CountedMean, Interval, MethodFigures, StudyReport

Cell = Callable[[MethodFigures], float]

_HEADS = ("VF↑", "IA↑", "PP↑", "Avg.↑", "OP (%)")
_CELLS: tuple[Cell, ...] = (
    *((lambda m, c=c: m.means[c].mean) for c in CRITERIA[:3]),
    lambda m: m.average.mean,
    lambda m: 100 * m.share,
)


def to_markdown(report: StudyReport) -> str:
    """Return the report in Markdown: Table 2, then intervals, pairs, agreement, and raters."""
    parts = [
        f"# {_cell(report.title) or 'User study'}\n",
        table_2(report),
        "## With 95 % intervals\n",
        _table(("Method", *SHORT, "Avg.", "Chosen", "Share (%)"), [
            (m.method, *(_interval(m.means[c]) for c in CRITERIA), _interval(m.average),
             str(m.chosen), _percent(m.share, m.share_interval)) for m in report.methods
        ]),
        "## In pairs\n",
        _table(("Method", "Other", "Wins", "Ties", "Losses", "Win rate (%)", "Preferred (%)"), [
            (p.method, p.other, str(p.wins), str(p.ties), str(p.losses),
             _percent(p.rate.mean, p.rate.interval),
             "–" if p.chosen_share is None else
             f"{_percent(p.chosen_share, p.chosen_interval)} of {p.chosen + p.other_chosen}")
            for p in report.pairs
        ]),
        "## Agreement of raters\n",
        _table(("", *SHORT, "Choice"), [
            ("Krippendorff's alpha", *("–" if a is None else f"{a:.3f}"
                                       for a in report.agreement.values())),
        ]),
        "## Raters\n",
        "\n".join(f"- {_cell(line)}" for line in count_lines(report)) + "\n",
    ]  # fmt: skip
    return "\n".join(parts)


def table_2(report: StudyReport) -> str:
    """Return the paper's Table 2 in Markdown, with the best value of each column in bold."""
    rows = []
    best = [max(cell(m) for m in report.methods) for cell in _CELLS]
    for m in report.methods:
        texts = [f"{cell(m):.2f}" for cell in _CELLS]
        rows.append((m.method, *(f"**{text}**" if text == f"{top:.2f}" else text
                                 for text, top in zip(texts, best, strict=True))))  # fmt: skip
    return _table(("Method", *_HEADS), rows)


def to_csv(report: StudyReport) -> str:
    """Return a CSV row per method: the values of Table 2, each with its interval."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    names = [n for c in (*CRITERIA, "average", "share") for n in (c, f"{c}_low", f"{c}_high")]
    writer.writerow(["method", *names, "chosen", "choices"])
    for m in report.methods:
        means = [*(m.means[c] for c in CRITERIA), m.average,
                 CountedMean(m.share, m.share_interval)]  # fmt: skip
        values = [v for one in means for v in (one.mean, *(one.interval or (None, None)))]
        cells = ["" if v is None else f"{v:.6f}" for v in values]
        writer.writerow([m.method, *cells, m.chosen, sum(o.chosen for o in report.methods)])
    return text.getvalue()


def lines(report: StudyReport) -> list[str]:
    """Return the lines for a terminal: the table with 95 % intervals, and the raters."""
    wide = max(len(m.method) for m in report.methods)
    rows = [f"{'':<{wide}}" + "".join(f"  {h:<17}" for h in (*SHORT, "Avg.")) + "  chosen (share)"]
    for m in report.methods:
        cells = [_interval(mean) for mean in (*(m.means[c] for c in CRITERIA), m.average)]
        share = _percent(m.share, m.share_interval)
        row = f"{m.method:<{wide}}" + "".join(f"  {c:<17}" for c in cells)
        rows.append(f"{row}  {m.chosen}, {share} %")
    return [*rows, *count_lines(report)]


def count_lines(report: StudyReport) -> list[str]:
    """Return the lines about counted and excluded raters, and the average time they took."""
    out, left = report.excluded, len(report.left_out)
    raters = "rater" if report.raters == 1 else "raters"
    few = ["intervals and agreement need two raters or more"] if report.raters < 2 else []
    checks = {0: "an attention check", 1: "more than 1 attention check"}.get(
        out.allowed_failures, f"more than {out.allowed_failures} attention checks"
    )
    return [
        f"{report.raters} {raters} of {report.read} counted, {report.ratings_each} results rated "
        f"by each; they took {report.mean_seconds:.0f} s on average",
        *few,
        f"{len(out.inattentive)} failed {checks}",
        f"{len(out.too_fast)} took less than {out.min_seconds:g} s",
        f"{left} {'file was' if left == 1 else 'files were'} excluded",
    ]


def _interval(mean: CountedMean) -> str:
    if mean.interval is None:
        return f"{mean.mean:.2f}"
    return f"{mean.mean:.2f} ({mean.interval[0]:.2f}–{mean.interval[1]:.2f})"


def _percent(share: float, interval: Interval | None) -> str:
    if interval is None:
        return f"{100 * share:.2f}"
    return f"{100 * share:.2f} ({100 * interval[0]:.1f}–{100 * interval[1]:.1f})"


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    cells = [head, ["---"] * len(head), *rows]
    return "".join(f"| {' | '.join(map(_cell, row))} |\n" for row in cells)


def _cell(text: str) -> str:
    return text.replace("|", "\\|").replace("<", "&lt;")
