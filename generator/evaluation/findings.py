"""What is wrong with a scene, object by object: findings with figure, limit and evidence."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from ..comparison import Comparison
from ..errors import InputError
from ..scene import TABLE
from .soundness import PLAIN, Soundness, StillnessRule
from .surfaces.collisions import THRESHOLD, Collisions
from .surfaces.silhouettes import SilhouetteFit
from .truth import TruthErrors, UsualSize

Kind = Literal[
    "overlap", "floats", "off_table", "unstable", "wrong_size", "wrong_yaw", "wrong_place",
    "wrong_support", "missing", "extra",
]  # fmt: skip
Evidence = Literal["meshes", "simulation", "usual size", "picture", "truth"]


@dataclass(frozen=True)
class DefectLimits:
    """What counts as a defect.

    overlap: depth in metres. ``rule``: of standing still.
    usual_size: factor between an object's size and the usual one.
    gain: by how much another turn or size must fit the object's mask better (IoU).
    yaw: radians, against a truth. ``scale``: factor, against a truth.
    place: share of the table's width, against a truth.
    """

    overlap: float = THRESHOLD
    rule: StillnessRule = PLAIN
    usual_size: float = 1.7
    gain: float = 0.15
    yaw: float = float(np.deg2rad(15.0))
    scale: float = 1.25
    place: float = 0.05

    def __post_init__(self) -> None:
        factors = (self.usual_size - 1, self.scale - 1)
        numbers = (self.overlap, self.gain, self.yaw, self.place, *factors)
        if not np.isfinite(numbers).all() or min(numbers) <= 0:
            raise InputError(f"Limits are positive, and factors above 1: {self}.")


@dataclass(frozen=True)
class Finding:
    """One defect of one object. ``value`` and ``limit`` are in ``unit``; None where none is.

    ``other`` is the second thing that takes part in it: an object, or "table".
    """

    kind: Kind
    name: str
    text: str
    evidence: Evidence
    value: float | None = None
    limit: float | None = None
    unit: str = ""
    other: str | None = None

    def facts(self) -> dict[str, Any]:
        """Return the finding as JSON values."""
        return {
            "kind": self.kind,
            "object": self.name,
            "other": self.other,
            "text": self.text,
            "evidence": self.evidence,
            "value": None if self.value is None else round(self.value, 4),
            "limit": None if self.limit is None else round(self.limit, 4),
            "unit": self.unit,
        }


def of_collisions(found: Collisions, limits: DefectLimits) -> Iterator[Finding]:
    """Yield one finding an overlap, with both things that take part in it."""
    pairs = [(o.b, o.a, o.depth) for o in found.overlaps]
    pairs += [(o.a, o.b, o.depth) for o in found.sunk]
    for name, other, depth in pairs:
        text = f"overlaps {'the table' if other == TABLE else other}"
        limit = 1e3 * limits.overlap
        yield Finding("overlap", name, text, "meshes", 1e3 * depth, limit, "mm", other)


def of_soundness(found: Soundness) -> Iterator[Finding]:
    """Yield what floats, hangs over the edge, or does not stand still."""
    rule = found.rule
    for thing in found.objects:
        if thing.floats:
            text = "floats: nothing holds it"
            yield Finding("floats", thing.name, text, "simulation", None, 1e3 * rule.gap, "mm")
        if thing.off_table:
            text = "its centre of mass is beyond the table's edge"
            yield Finding("off_table", thing.name, text, "simulation")
        if not found.moves(thing):
            continue
        after = f"in {rule.seconds:g} s"
        text, value, limit, unit = "the simulation broke down", None, None, ""
        if not found.diverged and (thing.drift > rule.drift or thing.falls):
            text = f"{'falls from the table' if thing.falls else 'moves'} {after}"
            value, limit, unit = 1e3 * thing.drift, 1e3 * rule.drift, "mm"
        elif not found.diverged:
            value, limit = float(np.rad2deg(thing.turn)), float(np.rad2deg(rule.tilt))
            text, unit = f"turns {after}", "deg"
        yield Finding("unstable", thing.name, text, "simulation", value, limit, unit)


def of_sizes(found: Sequence[UsualSize], limits: DefectLimits) -> Iterator[Finding]:
    """Yield what is much larger or smaller than such things usually are."""
    for s in (s for s in found if _beyond(s.ratio, limits.usual_size)):
        text = f"{_than(s.ratio)} than the {s.source} knows such things"
        yield Finding("wrong_size", s.name, text, "usual size", s.ratio, limits.usual_size, "x")


def of_fits(found: Sequence[SilhouetteFit], limits: DefectLimits) -> Iterator[Finding]:
    """Yield what would fit its mask in the picture much better if it were turned or scaled."""
    for fit in found:
        turned, scaled = fit.turned_iou - fit.iou, fit.scaled_iou - fit.iou
        kind: Kind = "wrong_yaw" if turned >= scaled else "wrong_size"
        how, best = f"at {fit.factor:g} times its size", fit.scaled_iou
        if kind == "wrong_yaw":
            how, best = f"turned by {np.rad2deg(fit.turn):.0f} deg", fit.turned_iou
        if max(turned, scaled) >= limits.gain:
            text = f"would fit its mask {how}: IoU {best:.2f} instead of {fit.iou:.2f}"
            yield Finding(kind, fit.name, text, "picture", best - fit.iou, limits.gain, "IoU")


def of_comparison(compared: Comparison) -> Iterator[Finding]:
    """Yield what the picture shows and the scene does not hold."""
    for score in (s for s in compared.scores if not s.built):
        yield Finding("missing", score.name, "is in the picture, not in the scene", "picture")


def of_truth(found: TruthErrors, limits: DefectLimits) -> Iterator[Finding]:
    """Yield what differs from the scene it should be."""
    for name in found.missing:
        yield Finding("missing", name, "is in the true scene, not in this one", "truth")
    for name in found.extra:
        yield Finding("extra", name, "is not in the true scene", "truth")
    for o in found.objects:
        if o.yaw > limits.yaw:
            yaw, limit = float(np.rad2deg(o.yaw)), float(np.rad2deg(limits.yaw))
            yield Finding("wrong_yaw", o.name, "is turned", "truth", yaw, limit, "deg")
        if _beyond(o.scale, limits.scale):
            text = f"{_than(o.scale)} than it should be"
            yield Finding("wrong_size", o.name, text, "truth", o.scale, limits.scale, "x")
        if o.share > limits.place:
            text = f"is {100 * o.translation:.1f} cm from its place"
            far, limit = 100 * o.share, 100 * limits.place
            yield Finding("wrong_place", o.name, text, "truth", far, limit, "% of table")
        if not o.support:
            text = "stands on, or in, another thing than it should"
            yield Finding("wrong_support", o.name, text, "truth")


def _beyond(ratio: float, factor: float) -> bool:
    return abs(np.log(ratio)) > np.log(factor)


def _than(ratio: float) -> str:
    return f"{ratio:.2f} times as large" if ratio >= 1 else f"{1 / ratio:.2f} times smaller"
