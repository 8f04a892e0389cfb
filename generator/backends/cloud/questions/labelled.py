"""Numbered objects: boxes on the picture, lists for prompts, and answers by number.

Questions and answers use numbers instead of names, because names may be ambiguous or similar. The
table is 0; objects are numbered from 1 in their order.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Protocol, TypeVar

import numpy as np
from jaxtyping import Float, UInt8
from PIL import Image, ImageDraw, ImageFont

from ....render.sheet import draw_boxes
from ....scene import TABLE, Instance
from ..server.json_text import Wrong

GRID = 1000
"""Boxes in prompts and answers use a grid of this many steps in both directions."""


class Numbered(Protocol):
    """An answer about one object, identified by its number."""

    @property
    def id(self) -> int:
        """The object's number."""
        ...


N = TypeVar("N", bound=Numbered)


@dataclass(frozen=True, eq=False)
class Labelled:
    """The instances in a picture, numbered for questions to a chat model."""

    image: UInt8[np.ndarray, "h w 3"]
    by_number: Mapping[int, Instance]

    @classmethod
    def of(
        cls, image: UInt8[np.ndarray, "h w 3"], instances: Sequence[Instance], *, table: bool = True
    ) -> Labelled:
        """Number the objects from 1 and the table 0; ``table=False`` omits the table."""
        tables = [i for i in instances if i.name == TABLE and table]
        things = [i for i in instances if i.name != TABLE]
        numbered = {0: tables[0]} if tables else {}
        return cls(np.asarray(image), {**numbered, **dict(enumerate(things, start=1))})

    @property
    def numbers(self) -> Mapping[str, int]:
        """The number of each instance, by name."""
        return {i.name: number for number, i in self.by_number.items()}

    def picture(self) -> UInt8[np.ndarray, "h w 3"]:
        """Return the picture with a box around each object and, if space permits, its number."""
        boxes = {str(k): np.asarray(i.box, float) for k, i in self.by_number.items()}
        picture = Image.fromarray(draw_boxes(self.image, boxes))
        draw, size = ImageDraw.Draw(picture), max(14, self.image.shape[1] // 50)
        font = ImageFont.load_default(size)
        for number, (x0, y0, _, _) in boxes.items():
            left, top, right, bottom = draw.textbbox((0, 0), number, font)
            width, height = right - left + 6, bottom - top + 6
            x = min(max(x0, 0), picture.width - width)
            y = y0 - height if y0 >= height else max(y0, 0)
            draw.rectangle((x, y, x + width, y + height), fill=(0, 0, 0))
            draw.text((x + 3 - left, y + 3 - top), number, (255, 255, 255), font)
        return np.asarray(picture, np.uint8)

    def pair(self) -> tuple[UInt8[np.ndarray, "h w 3"], UInt8[np.ndarray, "h w 3"]]:
        """Return the original picture and the picture with boxes."""
        return self.image, self.picture()

    def listing(self, facts: Callable[[Instance], str] | None = None) -> str:
        """Return one line per object, with its number, label, ``facts`` if given, and grid box."""
        lines = []
        for number, instance in self.by_number.items():
            note = f"; {facts(instance)}" if facts else ""
            box = " ".join(str(v) for v in self.on_grid(instance.box))
            lines.append(f"{number}: {instance.label}{note}; box {box}")
        return "\n".join(lines)

    def names(self) -> str:
        """Return one line per object except the table, with its number and label."""
        return "\n".join(f"{n}: {i.label}" for n, i in self.by_number.items() if n)

    @property
    def count(self) -> int:
        """The number of objects, not counting the table."""
        return sum(number > 0 for number in self.by_number)

    def on_grid(self, box: Float[np.ndarray, "4"]) -> tuple[int, ...]:
        """Return a pixel box in the integer grid coordinates that prompts use."""
        height, width = self.image.shape[:2]
        shares = np.asarray(box) / [width, height, width, height]
        return tuple(int(v) for v in np.clip(np.round(shares * GRID), 0, GRID))

    def match(self, answers: Sequence[N], without: Sequence[int] = ()) -> dict[str, N]:
        """Return a chat model's answers by object name, after checking their numbers.

        Raises:
            Wrong: a number that is not in ``without`` does not have exactly one answer.
        """
        wanted = [n for n in self.by_number if n not in without]
        given = [a.id for a in answers if a.id not in without]
        wrong = {
            "the list does not contain number": set(given) - set(wanted),
            "there is no answer for number": set(wanted) - set(given),
            "more than one answer for number": {n for n in given if given.count(n) > 1},
        }
        faults = [f"{k} {', '.join(map(str, sorted(v)))}" for k, v in wrong.items() if v]
        if faults:
            raise Wrong(
                "; ".join(faults) + ". Give exactly one answer for each number in the list."
            )
        return {self.by_number[a.id].name: a for a in answers if a.id not in without}
