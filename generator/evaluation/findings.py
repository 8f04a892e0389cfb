"""Defects of a scene, object by object: findings with values, limits and evidence."""

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
    """Limits above which a deviation is a defect.

    Attributes:
        overlap: depth in metres.
        rule: the criteria for standing still.
        usual_size: ratio of an object's size to the usual one.
        gain: improvement (IoU) of the fit to an object's mask with another yaw or size.
        yaw: error of the yaw compared with the true scene, radians.
        scale: ratio of the size to that in the true scene.
        place: error of the position compared with the true scene, as a fraction of the table's
            width.
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
            raise InputError(f"Limits must be positive, and factors must be above 1, got {self}.")


@dataclass(frozen=True)
class Finding:
    """One defect of an object; ``value`` and ``limit`` are in ``unit``, or None if inapplicable.

    ``other`` is the second object involved, or "table".
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
    """Yield a finding for each overlap; it names both objects."""
    pairs = [(o.b, o.a, o.depth) for o in found.overlaps]
    pairs += [(o.a, o.b, o.depth) for o in found.sunk]
    for name, other, depth in pairs:
        text = f"overlaps {'the table' if other == TABLE else other}"
        limit = 1e3 * limits.overlap
        yield Finding("overlap", name, text, "meshes", 1e3 * depth, limit, "mm", other)


def of_soundness(found: Soundness) -> Iterator[Finding]:
    """Yield a finding for each object that floats, hangs over the edge or does not stand still."""
    rule = found.rule
    for thing in found.objects:
        if thing.floats:
            text = "floats: nothing supports it"
            yield Finding("floats", thing.name, text, "simulation", None, 1e3 * rule.gap, "mm")
        if thing.off_table:
            text = "has its centre of mass beyond the table's edge"
            yield Finding("off_table", thing.name, text, "simulation")
        if not found.moves(thing):
            continue
        after = f"in {rule.seconds:g} s"
        text, value, limit, unit = "the simulation diverged", None, None, ""
        if not found.diverged and (thing.drift > rule.drift or thing.falls):
            text = f"{'falls from the table' if thing.falls else 'moves'} {after}"
            value, limit, unit = 1e3 * thing.drift, 1e3 * rule.drift, "mm"
        elif not found.diverged:
            value, limit = float(np.rad2deg(thing.turn)), float(np.rad2deg(rule.tilt))
            text, unit = f"turns {after}", "deg"
        yield Finding("unstable", thing.name, text, "simulation", value, limit, unit)


def of_sizes(found: Sequence[UsualSize], limits: DefectLimits) -> Iterator[Finding]:
    """Yield a finding for each object that is much larger or smaller than usual."""
    for s in (s for s in found if _beyond(s.ratio, limits.usual_size)):
        text = f"is {s.ratio:.2f} times its usual size ({s.source})"
        yield Finding("wrong_size", s.name, text, "usual size", s.ratio, limits.usual_size, "x")


def of_fits(found: Sequence[SilhouetteFit], limits: DefectLimits) -> Iterator[Finding]:
    """Yield a finding for each object that would fit its mask much better if turned or scaled."""
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
    """Yield a finding for each object in the picture that the scene lacks."""
    for score in (s for s in compared.scores if not s.built):
        yield Finding("missing", score.name, "is in the picture, but not in the scene", "picture")


def of_truth(found: TruthErrors, limits: DefectLimits) -> Iterator[Finding]:
    """Yield a finding for each deviation from the true scene."""
    for name in found.missing:
        yield Finding(
            "missing", name, "is in the true scene, but not in the evaluated scene", "truth"
        )
    for name in found.extra:
        yield Finding("extra", name, "is not in the true scene", "truth")
    for o in found.objects:
        if o.yaw > limits.yaw:
            yaw, limit = float(np.rad2deg(o.yaw)), float(np.rad2deg(limits.yaw))
            yield Finding("wrong_yaw", o.name, "is turned", "truth", yaw, limit, "deg")
        if _beyond(o.scale, limits.scale):
            text = f"is {o.scale:.2f} times its true size"
            yield Finding("wrong_size", o.name, text, "truth", o.scale, limits.scale, "x")
        if o.share > limits.place:
            text = f"is {100 * o.translation:.1f} cm from its true position"
            far, limit = 100 * o.share, 100 * limits.place
            yield Finding("wrong_place", o.name, text, "truth", far, limit, "% of table")
        if not o.support:
            text = "stands on, or in, another object than in the true scene"
            yield Finding("wrong_support", o.name, text, "truth")


def _beyond(ratio: float, factor: float) -> bool:
    return abs(np.log(ratio)) > np.log(factor)
