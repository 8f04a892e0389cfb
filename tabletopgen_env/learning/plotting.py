"""Success in validation over training, runs of one recipe as one band (Pillow alone)."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from jaxtyping import Float, UInt8
from PIL import Image, ImageDraw, ImageFont

from generator.errors import InputError

from .recipes import Recipe
from .runs import Run

By = Literal["steps", "hours"]
ACROSS: Mapping[By, str] = {
    "steps": "steps of the training environments",
    "hours": "hours, evaluations included",
}
"""What is across."""

_COLORS = ((31, 119, 180), (214, 69, 65), (44, 140, 60), (148, 90, 180), (220, 130, 20))
_INK, _PALE = (40, 44, 52), (214, 218, 224)
_WIDTH, _HEIGHT, _LEFT, _TOP, _RIGHT, _BOTTOM = 760, 440, 64, 40, 24, 58
_POINTS = 200


@dataclass(frozen=True, eq=False)
class Band:
    """The share solved by runs of one recipe: mean, least and most, where all of them have been."""

    runs: int
    at: Float[np.ndarray, "n"]
    mean: Float[np.ndarray, "n"]
    least: Float[np.ndarray, "n"]
    most: Float[np.ndarray, "n"]


def bands(runs: Sequence[Run], by: By = "steps") -> dict[str, Band]:
    """Return a band a recipe, by its name, interpolated between evaluations.

    Runs make one band if their recipes say the same but for the number of steps. If recipes of one
    name do not, what differs stands beside the name.

    Args:
        runs: the runs; one that is given twice counts once.
        by: "steps" of the training environments (of cloning, the states in which the expert gave
            advice), or "hours" of a run, evaluations included.

    Raises:
        InputError: a run has no evaluation, or runs of one recipe have nothing in common.
    """
    own = list({run.path.resolve(): run for run in runs}.values())
    names = labels([run.recipe for run in own])
    curves: dict[str, list[tuple[list[float], list[float]]]] = {}
    for name, run in zip(names, own, strict=True):
        rows = run.rows()
        if not rows:
            raise InputError(f"{run.path} has no evaluation yet.")
        at = [float(r.steps) if by == "steps" else r.seconds / 3600 for r in rows]
        curve = (at, [r.solved / r.episodes for r in rows])
        curves.setdefault(name, []).append(curve)
    return {name: _band(name, several) for name, several in curves.items()}


def labels(recipes: Sequence[Recipe]) -> list[str]:
    """Return a name for each recipe, the same for those that say the same but for their steps."""
    said = [_flat({k: v for k, v in r.facts().items() if k != "steps"}) for r in recipes]
    found = []
    for recipe, own in zip(recipes, said, strict=True):
        others = [s for r, s in zip(recipes, said, strict=True) if r.name == recipe.name]
        keys = sorted({key for s in others for key in s})
        odd = [key for key in keys if any(s.get(key) != own.get(key) for s in others)]
        told = ", ".join(f"{key}={own.get(key, 'none')}" for key in odd)
        found.append(f"{recipe.name} ({told})" if told else recipe.name)
    return found


def _flat(facts: Mapping[str, Any], before: str = "") -> dict[str, Any]:
    """Return nested settings by their dotted names."""
    found: dict[str, Any] = {}
    for key, value in facts.items():
        inner = isinstance(value, Mapping)
        found |= _flat(value, f"{before}{key}.") if inner else {before + key: value}
    return found


def _band(name: str, curves: list[tuple[list[float], list[float]]]) -> Band:
    low, high = max(at[0] for at, _ in curves), min(at[-1] for at, _ in curves)
    if low > high:
        raise InputError(f"The runs of {name} have no stretch in common; train them on.")
    at = np.linspace(low, high, _POINTS)
    shares = np.stack([np.interp(at, own, share) for own, share in curves])
    return Band(len(curves), at, shares.mean(0), shares.min(0), shares.max(0))


def draw(found: Mapping[str, Band], by: By = "steps") -> UInt8[np.ndarray, "h w 3"]:
    """Draw the bands: a line for the mean, a shade from the least to the most."""
    end = max(float(band.at[-1]) for band in found.values()) or 1.0
    picture = Image.new("RGB", (_WIDTH, _HEIGHT), "white")
    pen = ImageDraw.Draw(picture, "RGBA")
    small, large = ImageFont.load_default(13), ImageFont.load_default(17)
    wide, tall = _WIDTH - _LEFT - _RIGHT, _HEIGHT - _TOP - _BOTTOM

    def point(value: float, share: float) -> tuple[float, float]:
        return _LEFT + wide * value / end, _TOP + tall * (1 - share)

    pen.text((_LEFT, 10), "Success in validation", _INK, large)
    for level in np.linspace(0, 1, 6):
        pen.line((*point(0, level), *point(end, level)), _PALE)
        pen.text((_LEFT - 8, point(0, level)[1]), f"{100 * level:.0f} %", _INK, small, anchor="rm")
    for value in ticks(end):
        x = point(value, 0)[0]
        pen.line((x, _TOP, x, _TOP + tall), _PALE)
        pen.text((x, _TOP + tall + 6), number(value), _INK, small, anchor="mt")
    pen.text((_LEFT + wide / 2, _HEIGHT - 24), ACROSS[by], _INK, small, anchor="mt")
    for k, (name, band) in enumerate(found.items()):
        color = _COLORS[k % len(_COLORS)]
        upper = [point(a, m) for a, m in zip(band.at, band.most, strict=True)]
        lower = [point(a, m) for a, m in zip(band.at, band.least, strict=True)]
        if band.runs > 1:
            pen.polygon([*upper, *reversed(lower)], (*color, 50))
        pen.line([point(a, m) for a, m in zip(band.at, band.mean, strict=True)], color, 2)
        if band.at[0] == band.at[-1]:
            x, y = point(band.at[0], band.mean[0])
            pen.ellipse((x - 3, y - 3, x + 3, y + 3), color)
        told = f"{name} ({band.runs} {'run' if band.runs == 1 else 'runs'})"
        corner = (_LEFT + wide - 10, _TOP + tall - 8 - 18 * (len(found) - 1 - k))
        pen.text(corner, told, color, small, anchor="rb")
    return np.asarray(picture, np.uint8)


def ticks(end: float) -> list[float]:
    """Return four to ten round numbers from 0 to ``end``."""
    ten = 10.0 ** np.floor(np.log10(end))
    step = next(ten * s for s in (0.1, 0.2, 0.5, 1.0, 2.0) if end / (ten * s) <= 10)
    return [float(step * k) for k in range(int(end / step + 1e-9) + 1)]


def number(value: float) -> str:
    """Return a number as text, thousands apart."""
    return f"{value:,.0f}" if value >= 100 else f"{value:.3g}"
