"""The summary of a batch: numbers of scenes, failures by kind, and gate statistics."""

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
"""File name of the summary in a batch's folder."""


@dataclass(frozen=True)
class Summary:
    """The outcomes of a batch's jobs, in the order of the jobs."""

    outcomes: tuple[Outcome, ...]

    @property
    def failures(self) -> tuple[Outcome, ...]:
        """The failed jobs."""
        return tuple(o for o in self.outcomes if o.state == "failed")

    @property
    def unpaid(self) -> tuple[Outcome, ...]:
        """The jobs that have no scene because a call was not sent; the next run retries them."""
        return tuple(o for o in self.outcomes if o.state == "unpaid")

    def counts(self) -> dict[str, int]:
        """Return how many jobs made a scene, already had one, failed or exceeded the budget."""
        states = Counter(o.state for o in self.outcomes)
        return {state: states[state] for state in ("made", "there", "failed", "unpaid")}

    def kinds(self) -> dict[str, int]:
        """Return the number of failures for each kind of error, the most frequent first."""
        return dict(Counter(o.kind or "" for o in self.failures).most_common())

    def gate(self) -> dict[str, dict[str, float]]:
        """Return the mean and the maximum of each gate measurement over the scenes.

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
        """Return all statistics as JSON values."""
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
        StorageError: the file cannot be written.
    """
    text = json.dumps(summary.facts(), indent=1) + "\n"
    advice = "Free disk space, or choose another folder."
    write_whole(folder / FILE, text, "The batch's summary", advice)
