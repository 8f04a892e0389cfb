"""What the physical gate records of a scene: figures, failures, relations of the plan."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from .plan import RelationKind
from .provenance import plain

MAX_LEAN = 45.0
"""Degrees by which gravity may lean in the physical gate."""

FailureKind = Literal[
    "overlap", "moved", "turned", "floats", "fell", "off-table", "diverged", "recorded"
]
"""How a scene fails its gate; "recorded" is a sentence of a bundle that keeps no values."""


@dataclass(frozen=True)
class Failure:
    """One way in which a scene fails its gate; ``str`` gives the sentence for readers.

    Decisions use these fields, never the sentence: objects may have any name.

    Attributes:
        kind: What is wrong.
        objects: Names of the objects concerned; the first is the subject of the sentence.
        value, limit: The measured figure and the largest that passes: metres of an overlap and of a
            motion, radians of a turn. None for the other kinds.
        seconds: Simulated time after which the motion was measured.
        leaning: Whether gravity leaned.
        support: The fixed body that an object overlaps; empty if it overlaps another object.
        sentence: The whole text of a "recorded" failure.
    """

    kind: FailureKind
    objects: tuple[str, ...] = ()
    value: float | None = None
    limit: float | None = None
    seconds: float = 0.0
    leaning: bool = False
    support: Literal["", "table", "floor"] = ""
    sentence: str = ""

    @property
    def restless(self) -> bool:
        """Whether an object does not rest: it moves, turns, or breaks the simulation."""
        return self.kind in ("moved", "turned", "diverged")

    def __str__(self) -> str:
        if self.kind == "recorded":
            return self.sentence
        subject = self.objects[0] if self.objects else "Something"
        where = " on a leaning table" if self.leaning else ""
        value = self.value or 0.0
        if self.kind == "overlap":
            other = f"the {self.support}" if self.support else " ".join(self.objects[1:])
            return f"{subject} overlaps {other} by {1e3 * value:.1f} mm"
        return (
            subject
            + {
                "moved": f" moved {1e3 * value:.1f} mm in {self.seconds:.3g} s{where}",
                "turned": f" turned {np.rad2deg(value):.1f}° in {self.seconds:.3g} s{where}",
                "diverged": f" moved beyond all bounds{where}: the simulation broke down",
                "floats": " floats",
                "fell": " fell from the table",
                "off-table": " has its centre of mass beyond the table's edge",
            }[self.kind]
        )


@dataclass(frozen=True)
class RelationOutcome:
    """Whether a relation that a text asks for holds in the settled scene.

    Attributes:
        name, kind, target: the relation of the object ``name``.
        holds: whether it does.
        margin: by how many metres; 0 or less where it does not hold.
    """

    name: str
    kind: RelationKind
    target: str
    holds: bool
    margin: float


@dataclass(frozen=True)
class Report:
    """The recorded physical gate of a scene (lengths in metres, angles in radians).

    penetration: deepest overlap of two collision shapes at the start.
    drift, tilt: largest move and turn of any object over ``seconds``.
    floating: objects with no contact and a gap below them; fallen: objects that left the table.
    off_table: objects whose centre of mass is outside the top's outline.
    moved: the largest correction that separating overlaps needed; settling: by settling.
    leaning: largest move with gravity leaning by the gate's angle to any of four sides.
    seconds: the time that drift, tilt and leaning stand for.
    simulated: the least of it that was simulated, level or leaning; the rest is the forecast of an
        even creep. None where that was not recorded.
    failures: what the gate found. Where one says that the simulation diverged, drift, tilt and
        leaning say nothing.
    dropped: objects that were left out, since the scene would not have passed with them.
    lean: the angle by which gravity leaned, 0 for none; None: the gate's usual one.
    reach: from the best side of the table, the farthest object's distance to that side.
    misfit: of a scene made from a picture, one minus the overlap of outlines (Eq. 2), the mean
        over the objects: before the joint refinement, and of the finished scene, as it rests.
    relations: what the plan asks for, held or not.
    """

    penetration: float
    drift: float
    tilt: float
    floating: tuple[str, ...] = ()
    fallen: tuple[str, ...] = ()
    off_table: tuple[str, ...] = ()
    moved: float = 0.0
    settling: float = 0.0
    leaning: float = 0.0
    reach: float = 0.0
    seconds: float = 2.0
    dropped: tuple[str, ...] = ()
    failures: tuple[Failure, ...] = ()
    misfit: tuple[float, float] | None = None
    simulated: float | None = None
    relations: tuple[RelationOutcome, ...] = ()
    lean: float | None = None

    @property
    def passed(self) -> bool:
        """Whether the scene may be published."""
        return not self.failures

    @property
    def failure_text(self) -> str:
        """The failures as sentences, for a message; empty if there are none."""
        return "; ".join(map(str, self.failures))

    def as_json(self) -> dict[str, Any]:
        """Return the report as JSON values, ``failures`` as sentences.

        Their values follow in ``failure_values``, which is absent if there are none, as is an
        unset ``lean``.
        """
        values: dict[str, Any] = plain(self)
        failed = values["failures"]
        values["failures"] = [str(failure) for failure in self.failures]
        if self.lean is None:
            del values["lean"]
        return {**values, "failure_values": failed} if failed else values
