"""The numbers of bodies and geoms in a union model, and the assignment of objects to slots."""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from types import MappingProxyType
from typing import Any

import numpy as np

from .content import GeomKind, SceneContent

Room = Mapping[GeomKind, int]
"""Number of geoms of each kind that a body has."""


@dataclass(frozen=True)
class UnionShape:
    """The numbers of geoms in the slots (free bodies for objects) and in the static body ``fixed``.

    Models of equal shape use the same compiled kernels.
    """

    slots: tuple[Room, ...]
    fixed: Room

    def __reduce__(self) -> tuple[Any, ...]:
        """Support pickling, since read-only mappings cannot be pickled."""
        return _shape_of, ([dict(room) for room in self.slots], dict(self.fixed))

    @classmethod
    def around(cls, contents: Sequence[SceneContent]) -> UnionShape:
        """Return a shape that fits the contents of all scenes and has few geoms.

        Scenes are added in order of decreasing geom count; each assigns its objects to slots so
        that the fewest geoms have to be added.
        """
        slots = [Counter[GeomKind]() for _ in range(max(len(c.objects) for c in contents))]
        fixed = Counter[GeomKind]()
        for content in sorted(contents, key=_geom_count, reverse=True):
            fixed |= content.fixed.need
            for thing, slot in enumerate(_cheapest(content, slots)):
                slots[slot] |= content.objects[thing].geoms.need
        return cls(tuple(map(_freeze, slots)), _freeze(fixed))

    def assign(self, content: SceneContent) -> tuple[int, ...] | None:
        """Return the slot of each object of a scene, or None if the scene does not fit."""
        if len(content.objects) > len(self.slots) or _lack(content.fixed.need, self.fixed):
            return None
        slots = _cheapest(content, self.slots)
        pairs = zip(content.objects, slots, strict=True)
        lacking = any(_lack(thing.geoms.need, self.slots[slot]) for thing, slot in pairs)
        return None if lacking else slots


def _shape_of(slots: list[dict[GeomKind, int]], fixed: dict[GeomKind, int]) -> UnionShape:
    return UnionShape(tuple(_freeze(Counter(room)) for room in slots), _freeze(Counter(fixed)))


def _freeze(room: Counter[GeomKind]) -> Room:
    return MappingProxyType(dict(sorted(room.items())))


def _geom_count(content: SceneContent) -> int:
    return sum(len(thing.geoms.kinds) for thing in content.objects)


def _lack(need: Counter[GeomKind], room: Room) -> int:
    """Return the number of needed geoms for which a body has no room."""
    return sum(max(0, count - room.get(kind, 0)) for kind, count in need.items())


def _cheapest(content: SceneContent, slots: Sequence[Room]) -> tuple[int, ...]:
    """Assign objects to distinct slots so that as few geoms as possible must be added."""
    from scipy.optimize import linear_sum_assignment

    lack = [[_lack(thing.geoms.need, room) for room in slots] for thing in content.objects]
    _, chosen = linear_sum_assignment(np.reshape(lack, (len(lack), len(slots))))
    return tuple(chosen.tolist())
