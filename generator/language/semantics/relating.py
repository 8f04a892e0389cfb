"""Relations, zones and arrangements put into drafts."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from ...errors import InputError
from ...scene import TABLE
from ..drafts import Group, Grouping, Reading
from ..syntax.tree import (
    Arranged,
    Lack,
    Location,
    Noun,
    Zone,
)
from .linking import flank, lies_flat, link, stack, unstack
from .ordering import put_in_order
from .references import Context, Target

_ZONES = {-1: ("left_of", "in_front_of"), 1: ("right_of", "behind")}

_CORNERS = (("left_of", "behind"), ("right_of", "in_front_of"), ("right_of", "behind"),
            ("left_of", "in_front_of"))  # fmt: skip

CUTLERY = frozenset({"fork", "knife", "spoon", "chopsticks"})
"""What lies beside a plate; a glass "above" it stands behind it."""


_SIDES = {"fork": "left_of", "knife": "right_of", "spoon": "right_of", "chopsticks": "right_of"}


@dataclass(eq=False)
class Relater:
    """Relates drafts to one another and to the table; vague numbers are drawn by ``rng``."""

    rng: np.random.Generator
    reading: Reading = field(default_factory=Reading)
    _context: Context = field(default_factory=Context)
    _side: tuple[str, Target] | None = None  # the last "left of X" of this sentence
    _guests: int = 0  # for how many a table is laid; 0 where that is not said
    _seated: int | None = None  # the first object of the place setting that is being read

    def _attach(self, place: Location, target: Target, group: Group) -> None:
        """Relate a group to what a place refers to."""
        context, kind = self._context, place.kind
        if self._seated is not None and kind == "on" and isinstance(target, list):
            flat = [d.category in CUTLERY for d in target]
            kind = "behind" if all(flat) else kind  # "the glass above the knife"
        if isinstance(place.target, Zone):
            if kind != "aside" or not self._put_aside(place.target, group):
                self._zone(place.target, group, loose=kind in ("beside", "aside"))
            return
        if target == TABLE:
            if kind == "under":
                self.reading.warnings.append(
                    f"The {group[0].noun} cannot go under the table; it stands on it."
                )
            elif kind not in ("on", "in", "next_to", "at", "against", "around", "opposite", "laid"):
                for draft in group:
                    draft.relate(kind, TABLE)
            return
        assert isinstance(target, list)
        if any(draft is other for draft in group for other in target):
            raise InputError(
                f"The text relates the {group[0].noun} to itself; name two different objects."
            )
        if place.each or (isinstance(place.target, Noun) and place.target.each):
            self._one_each(group, target)
        self._drop_assumed(group, target)
        if kind in ("left_of", "right_of", "in_front_of", "behind"):
            self._side = kind, target
        if kind == "against":
            self.reading.warnings.append(
                f"The {group[0].noun} does not lean against the {target[0].noun}; it stands next "
                "to it."
            )
        if kind == "laid" and group[0].category in _SIDES:  # cutlery at a plate
            kind = _SIDES[group[0].category]
        if kind == "flank":
            flank(group, target, self.reading)
        elif kind in ("around", "surrounded"):
            inner, ring = (target, group) if kind == "around" else (group, target)
            laid = self.reading.groupings
            laid[:] = [g for g in laid if g.kind != "circle" or not {*g.members} <= {*ring}]
            laid.append(Grouping("circle", tuple(ring), around=inner[0]))
            link("next_to", ring, inner[:1], self.reading.warnings)
        else:
            link(kind, group, target, self.reading.warnings)
            ends = [draft for draft in target if not draft.relations]
            if kind == "between" and len(ends) == 2 and len(group) > 1:
                row = (ends[0], *group, ends[1])
                self.reading.groupings.append(Grouping("row", row))
        context.parallel = target

    def _drop_assumed(self, group: Group, target: Group) -> None:
        """Drop what was assumed of things that the text relates to something else."""
        for draft in group:
            if draft.provisional and not any(draft.relations[0][1] is to for to in target):
                keep = draft.relations[0][0] in ("on", "in")
                if not keep:
                    draft.relations.clear()
                draft.provisional = False

    def _one_each(self, group: Group, targets: Group) -> None:
        """Multiply the subject so that each target gets its own ("on each plate")."""
        one, share = group[0], len(group)
        for _ in range(len(targets) * share - len(group) if share < len(targets) else 0):
            group.append(self.reading.add(one.noun, one.category, one.attributes))

    def _put_aside(self, zone: Zone, group: Group) -> bool:
        """Put things "to the left" of what stands in the middle, or of what the sentence is about.

        Return whether there is such a thing.
        """
        if self._seated is not None or not zone.x or zone.y:
            return False
        context = self._context
        middle = [d for d in self.reading.objects if ("center", TABLE) in d.relations]
        for base in (middle[:1], context.topic, context.earlier):
            if not isinstance(base, list) or len(base) != 1 or base[0] in group:
                continue
            kind = "left_of" if zone.x < 0 else "right_of"
            if any(to in group for _, to in base[0].relations):
                continue
            link(kind, group, base, self.reading.warnings)
            self._side = kind, base
            return True
        return False

    def _zone(self, zone: Zone, group: Group, *, loose: bool) -> None:
        """Put a group into a part of the table, or beside what was just spoken of."""
        if self._seated is not None and zone.x and not zone.edge:
            plate = self.reading.objects[self._seated]
            for draft in group:
                if draft is not plate:
                    draft.relate("left_of" if zone.x < 0 else "right_of", plate)
            return
        if loose and self._side is not None and zone.y is None and zone.x:
            kind, target = self._side
            if kind in ("left_of", "right_of") and isinstance(target, list):
                link("left_of" if zone.x < 0 else "right_of", group, target, self.reading.warnings)
                return
        if zone.spread and 1 < len(group) <= len(_CORNERS):
            for draft, kinds in zip(group, _CORNERS, strict=False):
                for kind in kinds:
                    draft.relate(kind, TABLE)
            return
        for draft in group:
            if (zone.x, zone.y) == (0, 0):
                draft.relate("center", TABLE)
            for value, axis in ((zone.x, 0), (zone.y, 1)):
                if value:
                    draft.relate(_ZONES[value][axis], TABLE)
            if zone.edge and zone.x is None and zone.y is None:
                draft.relate("edge", TABLE)

    def _arrange(self, post: Arranged, group: Group) -> None:
        if len(group) < 2:
            return
        stacked = any(draft.stacked_under is not None for draft in group)
        if stacked or post.kind == "stack":  # the largest at the bottom
            group = put_in_order(group, "size down" if post.order else "ranks down")
        else:
            group = put_in_order(group, post.order)
        if stacked and post.kind == "row":
            unstack(group)
            stack(group)
            return
        flat = post.kind == "heap" and all(lies_flat(draft) for draft in group)
        if post.kind == "stack" or flat:  # a pile of books
            stack(group)
        else:
            laid = self.reading.groupings
            laid[:] = [g for g in laid if g.around or {*map(id, g.members)} != {*map(id, group)}]
            laid.append(Grouping(post.kind, tuple(group)))

    def _lack(self, post: Lack, group: Group) -> None:
        for item in post.items:
            names = {item.category or item.head, *item.members} - {""}
            own = any((d.category or d.noun) in names for d in group)
            self.reading.excluded |= names
            if not group or own:
                self.reading.banned |= names
