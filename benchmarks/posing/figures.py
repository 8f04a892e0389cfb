"""Numbers in a table's columns, and plots of their distributions."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from jaxtyping import Float, UInt8
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import PercentFormatter

from .tables import Row


def column(rows: Sequence[Row], field: str) -> Float[np.ndarray, "n"]:
    """Return the numbers of a column, without empty cells."""
    return np.array([float(r[field]) for r in rows if str(r.get(field, "")) not in ("", "None")])


def median(values: Float[np.ndarray, "n"], unit: str = "", digits: int = 1) -> str:
    """Return a median as text; "-" if there are no values."""
    return f"{np.median(values):.{digits}f}{unit}" if len(values) else "-"


def share(hits: Float[np.ndarray, "n"] | Sequence[bool]) -> str:
    """Return the share of true values as text."""
    return f"{100 * float(np.mean(hits)):.0f} %" if len(hits) else "-"


def error_cells(errors: Float[np.ndarray, "n"]) -> list[str]:
    """Return median and the shares within 2, 5 and 10 degrees."""
    return [median(errors, "°", 2), *(share(errors <= limit) for limit in (2, 5, 10))]


def cumulative(
    title: str,
    curves: Mapping[str, Float[np.ndarray, "n"]],
    unit: str,
    low: float = 0.1,
    high: float = 180.0,
) -> UInt8[np.ndarray, "h w 3"]:
    """Draw the share of cases up to each error, errors on a logarithmic axis."""
    chart = Figure(figsize=(7.2, 4.2), dpi=100, layout="constrained")
    axes = chart.add_subplot(title=title, xlabel=unit, xscale="log", xlim=(low, high), ylim=(0, 1))
    axes.yaxis.set_major_formatter(PercentFormatter(1.0))
    axes.grid(alpha=0.4)
    for name, values in curves.items():
        at = np.concatenate([[low], np.sort(values.clip(low, high)), [high]])
        steps = np.concatenate([np.arange(len(values) + 1), [len(values)]]) / max(len(values), 1)
        axes.step(at, steps, where="post", label=f"{name} ({len(values)})")
    axes.legend(loc="lower right")
    canvas = FigureCanvasAgg(chart)
    canvas.draw()
    return np.array(canvas.buffer_rgba())[..., :3]
