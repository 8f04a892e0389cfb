"""What came of a batch, in figures: scenes made, failures by kind, the gates' means and worst."""

from __future__ import annotations

import dataclasses
import json
from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from ..io.files import write_whole
from .records import Outcome

FILE = "summary.json"
"""Where a batch's folder keeps it."""


@dataclass(frozen=True)
class Summary:
    """What came of each job of a batch, in the order in which they were asked for."""

    outcomes: tuple[Outcome, ...]

    @property
    def failures(self) -> tuple[Outcome, ...]:
        """The jobs that have no scene."""
        return tuple(o for o in self.outcomes if o.state == "failed")

    @property
    def unpaid(self) -> tuple[Outcome, ...]:
        """The jobs that have no scene since a call was not sent; run again, they are tried."""
        return tuple(o for o in self.outcomes if o.state == "unpaid")

    def counts(self) -> dict[str, int]:
        """Return how many scenes were made, were there, failed, and could not be paid for."""
        states = Counter(o.state for o in self.outcomes)
        return {state: states[state] for state in ("made", "there", "failed", "unpaid")}

    def kinds(self) -> dict[str, int]:
        """Return how many failed by kind of error, most frequent first."""
        return dict(Counter(o.kind or "" for o in self.failures).most_common())

    def gate(self) -> dict[str, dict[str, float]]:
        """Return mean and largest value of each figure of the scenes' gates.

        Lengths are in millimetres, angles in degrees; ``objects`` and ``left_out`` are counts.
        """
        rows = [o.gate for o in self.outcomes if o.gate]
        names = dict.fromkeys(name for row in rows for name in row)
        columns = {name: [row[name] for row in rows if name in row] for name in names}
        return {
            name: {"mean": round(float(np.mean(column)), 4), "most": float(max(column))}
            for name, column in columns.items()
        }

    def facts(self) -> dict[str, Any]:
        """Return everything as JSON values."""
        rows = map(dataclasses.asdict, self.outcomes)
        return {
            **self.counts(),
            "failures": self.kinds(),
            "gate": self.gate(),
            "seconds": round(sum(o.seconds for o in self.outcomes if o.state == "made"), 2),
            "scenes": [{**row.pop("job"), **row} for row in rows],
        }


def write_summary(summary: Summary, folder: Path) -> None:
    """Write a summary into a batch's folder.

    Raises:
        StorageError: it cannot be written.
    """
    text = json.dumps(summary.facts(), indent=1) + "\n"
    advice = "Free space there, or choose another folder."
    write_whole(folder / FILE, text, "The batch's summary", advice)
