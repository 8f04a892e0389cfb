"""Results of the physical gate: measurements, failures, and outcomes of planned relations."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Literal

import numpy as np

from .plan import RelationKind
from .provenance import plain

MAX_LEAN = 45.0
"""Tilt of gravity in the physical gate, in degrees."""

FailureKind = Literal[
    "overlap", "moved", "turned", "floats", "fell", "off-table", "diverged", "recorded"
]
"""Kinds of gate failure; "recorded" means that the bundle describes it without measured values."""


@dataclass(frozen=True)
class Failure:
    """One reason why a scene failed the gate; ``str`` returns a human-readable sentence.

    Code must use these fields and not parse the sentence, since object names are arbitrary.

    Attributes:
        kind: The kind of failure.
        objects: Names of the objects concerned; the first is the subject of the sentence.
        value, limit: The measured value and the largest valid one: metres for an overlap or a
            motion, radians for a turn. None for the other kinds.
        seconds: Simulated time over which the motion was measured.
        leaning: Whether gravity was tilted.
        support: The fixed body that an object overlaps; empty if it overlaps another object.
        sentence: The complete text of a "recorded" failure.
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
        """Whether the failure is that an object moves or turns, or that the simulation diverges."""
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
    """The outcome of a requested relation in the settled scene.

    Attributes:
        name, kind, target: the relation of the object ``name``.
        holds: whether the relation holds.
        margin: by how many metres it holds; 0 or less if it does not.
    """

    name: str
    kind: RelationKind
    target: str
    holds: bool
    margin: float


@dataclass(frozen=True)
class Report:
    """Results of the physical gate for a scene (lengths in metres, angles in radians).

    penetration: deepest overlap of two collision shapes at the start.
    drift, tilt: largest displacement and rotation of any object over ``seconds``.
    floating: objects without contact and with a gap below; fallen: objects that left the table.
    off_table: objects whose centre of mass is outside the outline of the tabletop.
    moved: largest displacement applied to separate overlaps; settling: largest displacement during
        settling.
    leaning: largest displacement with gravity tilted by the gate's angle towards any of four sides.
    seconds: the duration to which drift, tilt and leaning refer.
    simulated: the shortest duration actually simulated, level or tilted; the remainder is
        extrapolated as uniform creep. None if it was not recorded.
    failures: failures of the gate. If one of them is a diverged simulation, drift, tilt and leaning
        are meaningless.
    dropped: objects removed because the scene would not pass with them.
    lean: the tilt of gravity: 0 for none, None for the gate's default.
    reach: distance between the best side of the table and the object farthest from that side.
    misfit: for a scene made from a picture, one minus the overlap of outlines (Eq. 2), averaged
        over the objects, once before the joint refinement and once for the finished scene at rest.
    relations: outcomes of the planned relations.
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
        """Whether the scene passed and may be published."""
        return not self.failures

    @property
    def failure_text(self) -> str:
        """The failures as sentences joined by semicolons, or an empty string if there are none."""
        return "; ".join(map(str, self.failures))

    def as_json(self) -> dict[str, Any]:
        """Return the report as JSON values, with ``failures`` as sentences.

        The failures' fields are in ``failure_values``. That key is omitted if there are no
        failures, and ``lean`` is omitted if it is None.
        """
        values: dict[str, Any] = plain(self)
        failed = values["failures"]
        values["failures"] = [str(failure) for failure in self.failures]
        if self.lean is None:
            del values["lean"]
        return {**values, "failure_values": failed} if failed else values
