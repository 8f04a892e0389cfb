"""Chart of a study: mean ratings per criterion, and proportions of the forced choice."""

from __future__ import annotations

import io
from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from generator.errors import InputError

from .design import CRITERIA, SHORT
from .statistics import Interval, StudyReport

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

_HATCHES = ("", "//", "..", "xx", "--", "\\\\", "++", "oo")
"""Hatches that distinguish methods without colour."""


def draw_chart(report: StudyReport) -> bytes:
    """Return the chart as PNG.

    Raises:
        InputError: Matplotlib is not installed.
    """
    try:
        from matplotlib.backends.backend_agg import FigureCanvasAgg
    except ImportError as error:
        raise InputError("Charts need Matplotlib: pip install 'tabletopgen[plot]'.") from error
    buffer = io.BytesIO()
    FigureCanvasAgg(figure(report)).print_png(buffer, metadata={"Software": None})
    return buffer.getvalue()


def figure(report: StudyReport) -> Figure:
    """Return the chart as a figure: bars with 95 % intervals."""
    from matplotlib.figure import Figure

    chart = Figure(figsize=(9.0, 4.2), dpi=120, layout="constrained")
    marks, shares = chart.subplots(1, 2, width_ratios=(5, 2))
    _draw_marks(marks, report)
    _draw_shares(shares, report)
    handles, labels = marks.get_legend_handles_labels()
    chart.legend(handles, labels, loc="outside lower center", ncols=min(len(labels), 4),
                 frameon=False)  # fmt: skip
    return chart


def _draw_marks(axes: Axes, report: StudyReport) -> None:
    wide = 0.8 / len(report.methods)
    for k, m in enumerate(report.methods):
        found = [m.means[c] for c in CRITERIA]
        at = np.arange(len(CRITERIA)) + (k - (len(report.methods) - 1) / 2) * wide
        means = [one.mean for one in found]
        axes.bar(
            at, means, wide * 0.92, label=_plain(m.method), color=f"C{k}", hatch=_HATCHES[k],
            edgecolor="white", yerr=_errors(means, [one.interval for one in found]),
            error_kw={"capsize": 2},
        )  # fmt: skip
    axes.set_title("Ratings (1 = very poor, 7 = excellent)", loc="left", fontsize=10)
    axes.set_xticks(range(len(CRITERIA)), SHORT)
    axes.set_ylim(1, 7)
    axes.grid(axis="y", alpha=0.4)
    axes.set_axisbelow(True)


def _draw_shares(axes: Axes, report: StudyReport) -> None:
    for k, m in enumerate(report.methods):
        low, high = m.share_interval
        axes.bar(
            k, 100 * m.share, 0.7, color=f"C{k}", hatch=_HATCHES[k], edgecolor="white",
            yerr=_errors([100 * m.share], [(100 * low, 100 * high)]), error_kw={"capsize": 2},
        )  # fmt: skip
    axes.set_title("Preferred overall (%)", loc="left", fontsize=10)
    axes.set_xticks([])
    axes.set_ylim(0, 100)
    axes.grid(axis="y", alpha=0.4)
    axes.set_axisbelow(True)


def _errors(means: Sequence[float], intervals: Sequence[Interval | None]) -> np.ndarray | None:
    """Return two rows, the intervals' extents below and above the means; None if any is missing."""
    if any(one is None for one in intervals):
        return None
    bounds = np.array([one for one in intervals if one is not None]).T
    return np.maximum([np.array(means) - bounds[0], bounds[1] - np.array(means)], 0.0)


def _plain(name: str) -> str:
    """Escape markup, and remove a leading "_" that would hide the name in the legend."""
    return name.replace("$", r"\$").removeprefix("_")
