"""What a rack or the like has a place each for, and how things stand there."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

Extent = tuple[float, float, float]

Stance = Literal["edge", "end", "side"]
"""On the edge as toast in its rack, on the end as a test tube, on the side as a bottle of wine."""


@dataclass(frozen=True)
class Holder:
    """Places for things that stand side by side along a holder's x axis.

    Attributes:
        stance: how things stand in their places.
        room: the largest thing it may be made for: across the row, along y, and up, metres.
    """

    stance: Stance
    room: Extent

    def stand(self, extent: Extent) -> Extent:
        """Return the extent of a thing as it stands in its place: across, along and up, metres."""
        narrow, middle, longest = sorted(extent)
        if self.stance == "edge":
            return narrow, longest, middle
        return (narrow, middle, longest) if self.stance == "end" else (middle, longest, narrow)

    def takes(self, extent: Extent) -> bool:
        """Tell whether it may have a place for a thing of this extent (metres)."""
        return all(a <= b for a, b in zip(self.stand(extent), self.room, strict=True))


def write_room(extent: Extent) -> str:
    """Return a room as the attribute "room" of what is built around it."""
    return " ".join(f"{side:.4f}" for side in extent)


def read_room(text: str | None, usual: Extent) -> Extent:
    """Return the room that an attribute asks for, ``usual`` where there is none."""
    if text is None:
        return usual
    across, along, up = (float(word) for word in text.split())
    return across, along, up
