"""Scores by a judge (Sec. 4.1; supplement, Sec. 8.2): VF, IA and PP from 1 to 7, and a ranking.

The paper uses GPT-4o; this module accepts any backend with the ``Judge`` protocol, and has its own
wording of the criteria. Without a judge, ``marks_from_figures`` derives marks from measured values.
There is no mark for realism, which cannot be measured from geometry.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np
from jaxtyping import UInt8

from ..backends.protocols import Judge
from ..errors import BackendError, InputError

Picture = UInt8[np.ndarray, "_ _ 3"]

CRITERIA: Mapping[str, str] = MappingProxyType(
    {
        "VF": (
            "Visual fidelity: how good and how real the scene looks by itself. Judge the surfaces "
            "of the table and the things on it, how much detail they have, and whether every "
            "model is whole."
        ),
        "IA": (
            "Image alignment: how far the scene shows what the reference picture shows. Judge the "
            "style, which things there are and how many, where they lie, and how much the table "
            "and each thing resemble theirs."
        ),
        "PP": (
            "Physical plausibility: whether the scene could stand in a room as it is. Judge "
            "whether the table stands firmly, whether all things rest wholly on it or on one "
            "another, and whether any float or run into each other."
        ),
    }
)
"""Criteria by key; a mark of 1 is very poor, 4 is average and 7 is excellent."""

LEAST, MOST = 1.0, 7.0
"""The lowest and the highest mark."""

MEASURED = "measured values without a judge"
"""Value of ``Marks.judge`` for ``marks_from_figures``."""


@dataclass(frozen=True)
class Marks:
    """Marks from 1 to 7 by criterion, or None if they are missing; ``judge`` is their source.

    ``notes`` explains each mark that was derived from measured values, and each missing mark.
    """

    judge: str
    marks: Mapping[str, float | None]
    notes: Mapping[str, str]

    @property
    def average(self) -> float | None:
        """The mean over all criteria, or None if a mark is missing."""
        given = [m for m in self.marks.values() if m is not None]
        return float(np.mean(given)) if given and len(given) == len(self.marks) else None

    def facts(self) -> dict[str, Any]:
        """Return the marks as JSON values."""
        average = self.average
        return {
            "judge": self.judge,
            **{k: None if m is None else round(m, 2) for k, m in self.marks.items()},
            "average": None if average is None else round(average, 2),
            "notes": dict(self.notes),
        }


def judge_scene(judge: object, reference: Picture, pictures: Sequence[Picture]) -> Marks:
    """Ask a judge, such as a reasoner, to mark the scene shown in ``pictures``.

    ``reference`` is the picture from which the scene was made.

    Raises:
        BackendError: ``judge`` is not a judge, or a mark is missing or out of range.
        InputError: There is no picture of the scene.
    """
    asked = as_judge(judge)
    if not pictures:
        raise InputError("A judge needs at least one picture of the scene.")
    answer = asked.rate(reference, tuple(pictures), CRITERIA)
    marks: dict[str, float | None] = {}
    for key in CRITERIA:
        mark = answer.get(key)
        if not isinstance(mark, int | float) or mark is True or not LEAST <= mark <= MOST:
            raise BackendError(
                f"{type(judge).__name__} gave {mark!r} for {key}; marks range from {LEAST:g} to "
                f"{MOST:g}. Retry, or use another judge."
            )
        marks[key] = float(mark)
    return Marks(type(judge).__name__, marks, {})


def rank_methods(
    judge: object, reference: Picture, methods: Mapping[str, Sequence[Picture]]
) -> tuple[str, ...]:
    """Ask a judge to rank several methods' scenes overall, from best to worst.

    Raises:
        BackendError: ``judge`` is not a judge, or does not name each method exactly once.
    """
    shown = {name: tuple(pictures) for name, pictures in methods.items()}
    order = tuple(as_judge(judge).rank(reference, shown))
    if sorted(order) != sorted(methods):
        raise BackendError(
            f"{type(judge).__name__} ranked {list(order)}; each of {sorted(methods)} must appear "
            "exactly once."
        )
    return order


def marks_from_figures(
    *,
    iou: float | None,
    built: float | None,
    pair_collisions: float,
    unsound: float,
    simulated: bool = True,
) -> Marks:
    """Derive marks from measured values, all in [0, 1], by fixed rules; there is no mark for VF.

    IA is 1 + 6 x (mean of ``iou`` and ``built``), where ``iou`` is the mean overlap of silhouettes
    with their masks, and ``built`` is the fraction of the picture's objects that the scene
    contains. It is None without a picture. PP is 1 + 6 x (1 - ``unsound``) x (1 -
    ``pair_collisions``)^10, since a scene in which one pair in ten collides (Col_O) is already
    poor; ``unsound`` is the fraction of objects that overlap or, if ``simulated``, float, hang over
    the edge or do not stand still.
    """
    notes = {"VF": "not marked: no measured value indicates how realistic a scene looks"}
    marks: dict[str, float | None] = {"VF": None, "IA": None}
    if iou is None or built is None:
        notes["IA"] = "not marked: there is no picture with instances for comparison"
    else:
        marks["IA"] = LEAST + (MOST - LEAST) * (iou + built) / 2
        notes["IA"] = f"from a silhouette overlap of {iou:.2f} and {built:.0%} of objects built"
    sound = (1 - unsound) * (1 - pair_collisions) ** 10
    marks["PP"] = LEAST + (MOST - LEAST) * sound
    notes["PP"] = (
        f"from {pair_collisions:.1%} of pairs in collision and {unsound:.0%} of objects unsound"
    )
    notes["PP"] += (
        "" if simulated else "; the scene was not simulated, so the mark is based on overlaps only"
    )
    return Marks(MEASURED, marks, notes)


def as_judge(judge: object) -> Judge:
    """Return ``judge`` if it has all methods of the ``Judge`` protocol.

    Raises:
        BackendError: It lacks one of them.
    """
    if not isinstance(judge, Judge):
        kind = type(judge)
        raise BackendError(
            f"{kind.__module__}.{kind.__qualname__} cannot judge scenes: it lacks rate or rank "
            "(generator.backends.protocols.Judge). Use another judge, or none to derive marks "
            "from measured values."
        )
    return judge
