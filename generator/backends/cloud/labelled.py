"""Things by number: boxes drawn on the picture, a list of them in words, answers matched to them.

Numbers, not names, are what a model is asked about and answers with: names that sound like several
things, or alike, cannot be mixed up. 0 is the table, 1 and up the things in their order.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol, TypeVar

import numpy as np
from jaxtyping import Float, UInt8

from ...render.sheet import draw_boxes
from ...scene import TABLE, Instance
from .reading import Wrong

GRID = 1000
"""Boxes are told and answered on a grid of this many steps in both directions."""


class Numbered(Protocol):
    """An answer about one thing."""

    @property
    def id(self) -> int:
        """Its number."""
        ...


N = TypeVar("N", bound=Numbered)


@dataclass(frozen=True, eq=False)
class Labelled:
    """The instances of a picture by number."""

    image: UInt8[np.ndarray, "h w 3"]
    by_number: Mapping[int, Instance]

    @classmethod
    def of(
        cls,
        image: UInt8[np.ndarray, "h w 3"],
        instances: Sequence[Instance],
        *,
        table: bool = True,
    ) -> Labelled:
        """Number instances; ``table`` False leaves the table out."""
        tables = [i for i in instances if i.name == TABLE and table]
        things = [i for i in instances if i.name != TABLE]
        numbered = {0: tables[0]} if tables else {}
        return cls(np.asarray(image), {**numbered, **dict(enumerate(things, start=1))})

    @property
    def numbers(self) -> Mapping[str, int]:
        """Number of each name."""
        return {i.name: number for number, i in self.by_number.items()}

    def picture(self) -> UInt8[np.ndarray, "h w 3"]:
        """Return the picture with boxes and numbers drawn on it, none cut off above."""
        line = max(12, self.image.shape[1] // 70) + 2
        boxes = {}
        for number, instance in self.by_number.items():
            x0, y0, x1, y1 = instance.box
            boxes[str(number)] = np.array([x0, min(max(y0, line), y1 - 1), x1, y1])
        return draw_boxes(self.image, boxes)

    def listing(self, facts: Callable[[Instance], str] | None = None) -> str:
        """Return a line for each thing: number, label, ``facts`` if any, box on the grid."""
        lines = []
        for number, instance in self.by_number.items():
            told = f"; {facts(instance)}" if facts else ""
            box = " ".join(str(v) for v in self.on_grid(instance.box))
            lines.append(f"{number}: {instance.label}{told}; box {box}")
        return "\n".join(lines)

    def names(self) -> str:
        """Return a line for each thing: number and label."""
        return "\n".join(f"{n}: {i.label}" for n, i in self.by_number.items())

    def on_grid(self, box: Float[np.ndarray, "4"]) -> tuple[int, ...]:
        """Return a pixel box on the grid."""
        height, width = self.image.shape[:2]
        shares = np.asarray(box) / [width, height, width, height]
        return tuple(int(v) for v in np.clip(np.round(shares * GRID), 0, GRID))

    def matched(self, answers: Sequence[N], without: Sequence[int] = ()) -> dict[str, N]:
        """Return the answers by instance name, one for each number but ``without``.

        Raises:
            Wrong: a number is missing, unknown, or there twice.
        """
        wanted = [n for n in self.by_number if n not in without]
        given = [a.id for a in answers if a.id not in without]
        unknown = sorted(set(given) - set(wanted))
        missing = sorted(set(wanted) - set(given))
        twice = sorted({n for n in given if given.count(n) > 1})
        faults = [
            f"{what} {', '.join(map(str, numbers))}"
            for what, numbers in (
                ("the list has no number", unknown),
                ("there is no answer for number", missing),
                ("more than one answer for number", twice),
            )
            if numbers
        ]
        if faults:
            raise Wrong("; ".join(faults) + ". Answer for each number of the list once.")
        return {self.by_number[a.id].name: a for a in answers if a.id not in without}
