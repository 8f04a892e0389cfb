"""Plots of validation success during training, with one band per recipe."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Literal

import numpy as np
from jaxtyping import Float, UInt8

from generator.errors import InputError, escape

from .extra import need
from .recipes import Recipe
from .runs import Run

if TYPE_CHECKING:
    from matplotlib.figure import Figure

By = Literal["steps", "hours"]
ACROSS: Mapping[By, str] = {
    "steps": "steps of the training environments",
    "hours": "hours, evaluations included",
}
"""The label of the horizontal axis for each quantity."""

_POINTS = 200


@dataclass(frozen=True, eq=False)
class Band:
    """The mean, minimum and maximum success rates of a recipe's runs where all runs have data."""

    runs: int
    at: Float[np.ndarray, "n"]
    mean: Float[np.ndarray, "n"]
    least: Float[np.ndarray, "n"]
    most: Float[np.ndarray, "n"]


def bands(runs: Sequence[Run], by: By = "steps") -> dict[str, Band]:
    """Return the success-rate band of each recipe name, interpolated between evaluations.

    Runs belong to one band if their recipes are equal except for the number of steps. If recipes
    with the same name differ otherwise, the differing settings are added to the name. A run given
    twice counts once.

    Args:
        runs: the runs.
        by: "steps" of the training environments (for cloning, the number of states with expert
            advice), or "hours" of a run, including evaluations.

    Raises:
        InputError: a run has no evaluation, or the runs of a recipe have no common range.
    """
    own = list({run.path.resolve(): run for run in runs}.values())
    names = labels([run.recipe for run in own])
    curves: dict[str, list[tuple[list[float], list[float]]]] = {}
    for name, run in zip(names, own, strict=True):
        rows = run.rows()
        if not rows:
            raise InputError(f"{run.path} has no evaluations yet.")
        at = [float(r.steps) if by == "steps" else r.seconds / 3600 for r in rows]
        curve = (at, [r.solved / r.episodes for r in rows])
        curves.setdefault(name, []).append(curve)
    return {name: _band(name, several) for name, several in curves.items()}


def labels(recipes: Sequence[Recipe]) -> list[str]:
    """Return a label for each recipe; recipes that differ only in their steps share a label."""
    said = [_flat({k: v for k, v in r.facts().items() if k != "steps"}) for r in recipes]
    found = []
    for recipe, own in zip(recipes, said, strict=True):
        others = [s for r, s in zip(recipes, said, strict=True) if r.name == recipe.name]
        keys = sorted({key for s in others for key in s})
        odd = [key for key in keys if any(s.get(key) != own.get(key) for s in others)]
        label = ", ".join(f"{key}={own.get(key, 'none')}" for key in odd)
        found.append(f"{recipe.name} ({label})" if label else recipe.name)
    return found


def _flat(facts: Mapping[str, Any], before: str = "") -> dict[str, Any]:
    """Flatten nested settings into a dict with dotted keys."""
    found: dict[str, Any] = {}
    for key, value in facts.items():
        inner = isinstance(value, Mapping)
        found |= _flat(value, f"{before}{key}.") if inner else {before + key: value}
    return found


def _band(name: str, curves: list[tuple[list[float], list[float]]]) -> Band:
    low, high = max(at[0] for at, _ in curves), min(at[-1] for at, _ in curves)
    if low > high:
        raise InputError(
            f"The runs of {name} have no common range of evaluations; train them further."
        )
    at = np.linspace(low, high, _POINTS)
    shares = np.stack([np.interp(at, own, share) for own, share in curves])
    return Band(len(curves), at, shares.mean(0), shares.min(0), shares.max(0))


def draw(found: Mapping[str, Band], by: By = "steps") -> UInt8[np.ndarray, "h w 3"]:
    """Draw the bands, each with a line for the mean and an area from minimum to maximum.

    Raises:
        InputError: Matplotlib is not installed.
    """
    need("matplotlib", "Charts need Matplotlib", "plot")
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    canvas = FigureCanvasAgg(figure(found, by))
    canvas.draw()
    return np.array(canvas.buffer_rgba())[..., :3]


def figure(found: Mapping[str, Band], by: By) -> Figure:
    """Return the chart that ``draw`` renders; recipe names are shown literally, without markup."""
    from matplotlib.figure import Figure
    from matplotlib.ticker import FuncFormatter, MaxNLocator, PercentFormatter

    chart = Figure(figsize=(7.6, 4.4), dpi=100, layout="constrained")
    axes = chart.add_subplot()
    axes.set_title("Success in validation", loc="left")
    axes.set_xlabel(ACROSS[by])
    axes.set_xlim(0, max(float(band.at[-1]) for band in found.values()) or 1.0)
    axes.set_ylim(0, 1)
    axes.xaxis.set_major_locator(MaxNLocator(10, steps=[1, 2, 5, 10]))
    axes.xaxis.set_major_formatter(FuncFormatter(lambda value, _: number(value)))
    axes.yaxis.set_major_formatter(PercentFormatter(1.0))
    axes.grid(alpha=0.4)
    for k, (name, band) in enumerate(found.items()):
        color = f"C{k}"
        marker = "o" if band.at[0] == band.at[-1] else ""
        axes.plot(band.at, band.mean, color=color, linewidth=2, marker=marker, clip_on=False)
        if band.runs > 1:
            axes.fill_between(band.at, band.least, band.most, color=color, alpha=0.2, linewidth=0)
        label = escape(f"{name} ({band.runs} {'run' if band.runs == 1 else 'runs'})")
        axes.text(
            0.98, 0.03 + 0.05 * (len(found) - 1 - k), label, color=color, ha="right",
            transform=axes.transAxes, parse_math=False, in_layout=False,
        )  # fmt: skip
    return chart


def number(value: float) -> str:
    """Format a number with thousands separators."""
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"
