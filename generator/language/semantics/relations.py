"""Application of relations, zones and arrangements to drafts."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, field, replace
from itertools import pairwise

import numpy as np

from ...errors import InputError
from ...scene import TABLE
from ..drafts import Draft, Group, Grouping, Reading, assumed_relation
from ..syntax.phrases.tree import (
    Arranged,
    Lack,
    Location,
    Noun,
    Span,
    Zone,
)
from ..vocabulary import SUBSTANCES
from .links import flank, lies_flat, link, stack, unstack
from .references import Context, Target, put_in_order

_ZONES = {-1: ("left_of", "in_front_of"), 1: ("right_of", "behind")}

_CORNERS = (("left_of", "behind"), ("right_of", "in_front_of"), ("right_of", "behind"),
            ("left_of", "in_front_of"))  # fmt: skip

CUTLERY = frozenset({"fork", "knife", "spoon", "chopsticks"})
"""Objects laid beside a plate; a glass "above" them is behind them."""


_OTHER_SIDE = {"left_of": "right_of", "right_of": "left_of", "behind": "in_front_of",
               "in_front_of": "behind"}  # fmt: skip
_SIDES = {"fork": "left_of", "knife": "right_of", "spoon": "right_of", "chopsticks": "right_of"}


@dataclass(eq=False)
class Relater(ABC):
    """Relates drafts to each other and to the table; vague numbers are drawn from ``rng``."""

    rng: np.random.Generator
    reading: Reading = field(default_factory=Reading)
    _context: Context = field(default_factory=Context)
    _side: tuple[str, Target] | None = None  # the last "left of X" in this sentence
    _local: bool = False  # whether a previous clause of this sentence was interpreted
    _earlier_side: tuple[str, Target] | None = None  # ``_side`` of the previous sentence
    _guests: int = 0  # number of people for whom the table is laid, or 0 if not stated
    _read: set[Span] = field(default_factory=set)  # spans of the interpreted noun phrases
    _seated: int | None = None  # first object of the current place setting

    def _attach(self, place: Location, target: Target, group: Group) -> None:
        """Relate a group to the target of a place."""
        context, kind = self._context, place.kind
        if kind == "otherside" and self._side:
            kind = _OTHER_SIDE.get(self._side[0], "next_to")
        if self._seated is not None and kind == "on" and isinstance(target, list):
            flat = [d.category in CUTLERY for d in target]
            kind = "behind" if all(flat) else kind  # "the glass above the knife"
        if isinstance(place.target, Zone):
            if kind != "aside" or not self._put_aside(place.target, group):
                self._zone(place.target, group, loose=kind in ("beside", "aside"))
            return
        if target == TABLE:
            if kind == "aim":
                return
            if kind == "under":
                self.reading.warnings.append(
                    f"The {group[0].noun} cannot be under the table; it is placed on the table."
                )
            elif kind not in ("on", "in", "next_to", "at", "against", "around", "opposite", "laid"):
                for draft in group:
                    draft.relate(kind, TABLE)
            return
        assert isinstance(target, list)
        if kind == "aim":
            return  # "push it towards the cone"
        if kind == "from":
            held = [assumed_relation(group[0], to, held=True) for to in target[:1]]
            kind = held[0] if held else "on"
        apart = [draft for draft in group if all(draft is not other for other in target)]
        if apart and len(apart) < len(group):
            group = apart  # "everything on the tray", which includes the tray
        if any(draft is other for draft in group for other in target):
            named = isinstance(place.target, Noun) and place.target.kind == "thing"
            if named and len(group) == len(self.reading.objects):
                raise InputError(
                    f"The prompt places the {group[0].noun} relative to itself; name two different "
                    "objects."
                )
            self.reading.warnings.append(
                f"The prompt places the {group[0].noun} relative to itself; this is ignored."
            )
            return
        if place.each or (isinstance(place.target, Noun) and place.target.each):
            self._one_each(group, target)
        self._drop_assumed(group, target)
        if kind in ("left_of", "right_of", "in_front_of", "behind"):
            self._side = kind, target
        if kind == "against":
            self.reading.warnings.append(
                f"The {group[0].noun} cannot lean against the {target[0].noun}; it is placed next "
                "to it."
            )
        if kind == "laid" and group[0].category in _SIDES:  # cutlery beside a plate
            kind = _SIDES[group[0].category]
        if kind == "flank":
            flank(group, target, self.reading)
        elif kind in ("around", "surrounded"):
            inner, ring = (target, group) if kind == "around" else (group, target)
            laid = self.reading.groupings
            laid[:] = [g for g in laid if g.kind != "circle" or not {*g.members} <= {*ring}]
            laid.append(Grouping("circle", tuple(ring), around=inner[0]))
            link("next_to", ring, inner[:1], self.reading.warnings)
        elif kind == "between" and (faced := self._column_of(target)) is not None:
            members = (faced.members[0], *group, *faced.members[1:])
            self.reading.groupings.remove(faced)
            self.reading.groupings.append(replace(faced, members=members))
            for end in target:
                link("next_to", group, [end], self.reading.warnings)
        elif kind == "between" and len(group) > 1 and (ends := _ends_of(target)):
            row = (ends[0], *group, ends[1])
            laid = self.reading.groupings
            laid[:] = [g for g in laid if not {*g.members} <= {*row}]
            laid.append(Grouping("row", row))
            link("next_to", group[:1], ends[:1], self.reading.warnings)
            link("next_to", group[-1:], ends[1:], self.reading.warnings)
        else:
            link(kind, group, target, self.reading.warnings)
        context.parallel = target

    def _column_of(self, targets: Group) -> Grouping | None:
        """Return the arrangement of two objects that face each other, with room between them."""
        columns = (g for g in self.reading.groupings if g.kind == "column")
        return next((g for g in columns if len(targets) == 2 and [*g.members] == targets), None)

    def _drop_assumed(self, group: Group, target: Group) -> None:
        """Drop assumed relations of objects that the text relates to another object."""
        for draft in group:
            if draft.provisional and not any(draft.relations[0][1] is to for to in target):
                keep = draft.relations[0][0] in ("on", "in")
                if not keep:
                    draft.relations.clear()
                draft.provisional = False

    def _one_each(self, group: Group, targets: Group) -> None:
        """Multiply the subject so that each target gets its own, as in "on each plate"."""
        one, share = group[0], len(group)
        carried = [d for d in self.reading.objects
                   if any(kind in ("on", "in") and to is one for kind,
                   to in d.relations)]  # fmt: skip
        for _ in range(len(targets) * share - len(group) if share < len(targets) else 0):
            copy = self.reading.add(one.noun, one.category, one.attributes)
            group.append(copy)
            for draft in carried:
                kind = next(kind for kind, to in draft.relations if to is one)
                self.reading.add(draft.noun, draft.category, draft.attributes).relate(kind, copy)

    def _put_aside(self, zone: Zone, group: Group) -> bool:
        """Put objects "to the left" of the object in the middle, or of the sentence's topic.

        Returns whether there is such an object or topic.
        """
        if self._seated is not None or not zone.x or zone.y:
            return False
        context = self._context
        side = self._side or self._earlier_side
        if side is not None and side[0] in ("left_of", "right_of") and isinstance(side[1], list):
            base = side[1]
            if all(d is not b for d in group for b in base):
                link("left_of" if zone.x < 0 else "right_of", group, base, self.reading.warnings)
                return True
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
        """Put a group into a zone of the table, or beside the object mentioned last."""
        if self._seated is not None and zone.x and not zone.edge:
            plate = self.reading.objects[self._seated]
            for draft in group:
                if draft is not plate:
                    draft.relate("left_of" if zone.x < 0 else "right_of", plate)
            return
        group = [_bottom(draft) for draft in group]
        group = [draft for k, draft in enumerate(group) if draft not in group[:k]]
        owner = self._context.owner
        if loose and isinstance(owner, list) and len(owner) == 1 and zone.x and zone.y is None:
            inside = assumed_relation(group[0], owner[0], held=False) in ("on", "in")
            if group[0].category in CUTLERY or not inside:  # "a laptop with a mouse on the left"
                kind = "left_of" if zone.x < 0 else "right_of"
                link(kind, group, owner, self.reading.warnings)
            return
        if loose and self._side is not None and zone.y is None and zone.x:
            kind, target = self._side
            if kind in ("left_of", "right_of") and isinstance(target, list):
                link("left_of" if zone.x < 0 else "right_of", group, target, self.reading.warnings)
                return
        if zone.spread and zone.x == 0:  # "at the left and right ends"
            for k, draft in enumerate(group):
                draft.relate("left_of" if k < len(group) // 2 else "right_of", TABLE)
            return
        if zone.spread and (zone.x, zone.y) not in ((None, None), (0, None)):
            self._put_in_two_corners(zone, group)
            return
        if zone.spread and zone.edge and len(group) == 1:  # "a candle in every corner"
            one = group[0]
            while len(group) < len(_CORNERS):
                group.append(self.reading.add(one.noun, one.category, one.attributes))
        if zone.spread and 1 < len(group) <= len(_CORNERS):
            for draft, kinds in zip(group, _CORNERS, strict=False):
                for kind in (*kinds, "edge"):
                    draft.relate(kind, TABLE)
            return
        for draft in group:
            if (zone.x, zone.y) == (0, 0):
                draft.relate("center", TABLE)
            for value, axis in ((zone.x, 0), (zone.y, 1)):
                if value:
                    draft.relate(_ZONES[value][axis], TABLE)
            if zone.edge:  # "left edge"; two sides form a corner
                draft.relate("edge", TABLE)

    def _put_in_two_corners(self, zone: Zone, group: Group) -> None:
        """Put objects "in both front corners" or "in each left corner"; duplicate a single one."""
        one = group[0]
        if len(group) == 1:
            group.append(self.reading.add(one.noun, one.category, one.attributes))
        side, along = (zone.x, 0) if zone.x else (zone.y, 1)
        for k, draft in enumerate(group):
            draft.relate(_ZONES[side or 1][along], TABLE)
            draft.relate(_ZONES[1 if k % 2 else -1][1 - along], TABLE)
            draft.relate("edge", TABLE)

    def _arrange(self, post: Arranged, group: Group) -> None:
        if len(group) < 2:
            return
        if post.order == "listed" and len({(d.noun, d.category) for d in group}) > 1:
            for one, other in pairwise(group):
                link("left_of", [one], [other], self.reading.warnings)
        stacked = any(draft.stacked_under is not None for draft in group)
        if stacked or post.kind == "stack":  # largest at the bottom
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
        self._read.update(item.span for item in post.items)
        target = post.place.target if post.place is not None else None
        if isinstance(target, Noun):
            self._read.add(target.span)
        named = isinstance(target, Noun) and target.kind == "thing" and target.definite
        if isinstance(target, Noun) and named and target.head not in SUBSTANCES:
            self._name_denied(target, group)  # "not in the bowl, but next to it"
        for item in post.items:
            names = {item.category or item.head, *item.members} - {""}
            own = any((d.category or d.noun) in names for d in group)
            there = [d for d in self.reading.objects if (d.category or d.noun) in names]
            if self._local and any(not d.implied for d in there):
                continue  # "a spoon is on the tray, but no plates": they may be elsewhere
            self.reading.excluded |= names
            if not group or own:
                self.reading.banned |= names

    @abstractmethod
    def _name_denied(self, noun: Noun, group: Group) -> None:
        """Add the object named by a negated place ("not on the book"), since it still exists."""


def _bottom(draft: Draft) -> Draft:
    """Return the lowest known support of an object.

    For "nuts in a bowl", this is the bowl.
    """
    for kind, to in draft.relations:
        if kind in ("on", "in") and isinstance(to, Draft) and to is not draft and not to.placed:
            return to
    return draft


def _ends_of(targets: Group) -> Group:
    """Return the two objects that others are said to be between, if both can still be moved."""
    free = [draft for draft in targets if not draft.relations]
    return free if len(free) == 2 else []
