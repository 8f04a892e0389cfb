"""References such as "it", "them", "the red mug" and "the other"."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from tabletop_objects import CATEGORIES

from ...scene import TABLE
from ..drafts import Draft, Group
from ..lexicon import singular
from ..syntax.phrases.tree import Noun
from ..syntax.text.function_words import GROUPS

Target = Group | str


@dataclass(eq=False)
class Context:
    """The possible antecedents at a position in the text.

    Attributes:
        owner: owner of the list that is being interpreted.
        subject: subject of the current relation.
        parallel: target of the previous item in the same list.
        topic: first subject of this sentence.
        earlier: first subject of the previous sentence.
        recent: subjects of the last clause that has any.
        listed: all objects of the last sentence that listed several kinds.
        mentioned: all groups in order of mention.
    """

    owner: Target | None = None
    subject: Group = field(default_factory=list)
    parallel: Target | None = None
    topic: Target | None = None
    earlier: Target | None = None
    recent: list[Group] = field(default_factory=list)
    listed: Group = field(default_factory=list)
    mentioned: list[Group] = field(default_factory=list)


def antecedent(pronoun: Noun, kind: str, context: Context) -> Target | None:
    """Return the antecedent of a pronoun as a relation's target, or None if there is none."""
    several = pronoun.plural
    if pronoun.head == "that":  # the last object named
        latest = [g for g in reversed(context.mentioned) if not _overlaps(g, context.subject)]
        return next((g for g in latest if may_carry(g[0], kind)), latest[0] if latest else None)
    if context.owner == TABLE and kind in ("on", "in", "at", "center", "edge") and not several:
        before = [g for g in context.mentioned if not _overlaps(g, context.subject)][-1:]
        if kind == "on" and before and before[0][0].placed and may_carry(before[0][0], kind):
            return before[0]  # "a book in the middle and a pen on it"
        return TABLE
    candidates: list[Target | None] = [
        context.owner, context.parallel, context.topic, context.earlier,
        *reversed(context.mentioned),
    ]  # fmt: skip
    fit = [c for c in candidates if isinstance(c, list) and c and not _overlaps(c, context.subject)]
    if kind in ("on", "in") and not several:  # "on it" prefers supports
        fit.sort(key=lambda group: group is not context.owner and not may_carry(group[0], kind))
    for group in fit:
        if (len(group) > 1) == several:
            return group
    if several and context.listed and not any(d in context.subject for d in context.listed):
        return context.listed
    if several:
        latest = [g for g in context.mentioned if not _overlaps(g, context.subject)][-2:]
        if latest:
            return [draft for group in latest for draft in group]
    if fit:
        return fit[0]
    return TABLE if TABLE in candidates else None


_WIDE = 0.12  # minimum width of a flat object that can be a support, metres


def may_carry(draft: Draft, kind: str) -> bool:
    """Return whether other objects may be on or in an object."""
    if draft.category is None:
        return True
    known = CATEGORIES[draft.category]
    wide = "flat" in known.roles and min(known.size[:2]) > _WIDE
    return known.container or (kind == "on" and ("support" in known.roles or wide))


def _overlaps(one: Group, other: Sequence[Draft]) -> bool:
    return any(draft is another for draft in one for another in other)


def same(draft: Draft, noun: Noun) -> bool:
    """Return whether a noun phrase may mean this object, given its kind and attributes."""
    alike = draft.category == noun.category and (noun.category or draft.noun == noun.head)
    return bool(alike) and _agrees(draft, noun)


def _agrees(draft: Draft, noun: Noun) -> bool:
    return all(
        draft.attributes.get(key, value) == value
        for key, value in noun.attributes.items()
        if key != "state"
    )


def find_referred(noun: Noun, objects: Sequence[Draft], subject: Sequence[Draft] = ()) -> Group:
    """Return the existing objects that "the red mug" means, or none if the object is new.

    Objects of ``subject`` are avoided: with two mugs, "a mug on the mug" refers to the other one.
    """
    alike = [d for d in objects if same(d, noun)] or _find_by_head(objects, noun)
    alike = [d for d in alike if d.also == noun.head] or alike
    if not alike and noun.head in GROUPS:  # "behind the stack"
        return _last_arranged(objects)
    if noun.each and alike:
        return alike
    if noun.ordinal and (len(alike) > 1 or noun.ordinal > 1):
        return pick(alike, noun.ordinal)
    if noun.position is not None:
        placed = [d for d in alike if d.position == noun.position]
        if placed or any(d.position for d in alike) or len(alike) < 2:
            return placed
        stacked = [d for d in alike if d.stacked_under is not None or any(
            kind == "on" and to in alike for kind, to in d.relations)]  # fmt: skip
        if noun.position in ("top", "upper") and stacked:
            return [d for d in stacked if d.stacked_under is None][-1:] or stacked[-1:]
        if noun.position in ("middle", "center", "centre"):
            return [alike[len(alike) // 2]]
        return [alike[0] if noun.position in ("left", "front", "bottom", "lower") else alike[-1]]
    if noun.other and len(alike) > 1:
        return [alike[1]]
    if noun.plural and (noun.count or 2) > 1:
        return alike[: int(noun.count)] if noun.count and noun.count <= len(alike) else alike
    free = [d for d in alike if all(d is not s for s in subject)]
    return (free or alike)[:1]


def pick(group: Sequence[Draft], ordinal: int) -> Group:
    """Return the first, second, ... or last (-1) member, or none if the group is too small."""
    at = ordinal - 1 if ordinal > 0 else ordinal
    return [group[at]] if -len(group) <= at < len(group) else []


def _last_arranged(objects: Sequence[Draft]) -> Group:
    """Return the last group of several objects of one kind; for a stack, only its lowest object."""
    for draft in reversed(objects):
        alike = [d for d in objects if d.noun == draft.noun and d.category == draft.category]
        stacked = [d for d in alike if d.stacked_under is not None]
        if len(alike) > 1:
            return stacked[:1] or alike
    return []


def _find_by_head(objects: Sequence[Draft], noun: Noun) -> Group:
    """Return the objects whose names end with the noun: "the tin" may mean the tea tin."""
    head = noun.head.split()[-1:]
    if len(noun.head.split()) > 1 or not head:
        return []
    found = []
    for draft in objects:
        words = [singular(word) for word in draft.noun.split(" of ")[0].split()]
        if head in (words[-1:], draft.noun.split()[-1:], draft.also.split()[-1:]) and _agrees(
            draft, noun
        ):
            found.append(draft)
    if found or len(head[0]) < 3:
        return found
    return [d for d in objects if d.noun.split()[-1].endswith(head[0]) and _agrees(d, noun)]


_RANKS: Mapping[str, float] = {"tiny": -1.0, "small": 0.0, "medium": 1.0, "large": 2.0}
_RAINBOW = ("red", "orange", "yellow", "green", "cyan", "blue", "indigo", "purple", "violet",
            "pink")  # fmt: skip
_SPREAD = 0.65, 1.45  # relative sizes of objects that are put in order


def size_rank(draft: Draft) -> float:
    """Return a number that increases with the size that the text states."""
    if draft.lengths:
        return 10.0 * draft.lengths[0]
    return _RANKS.get(draft.attributes.get("size", ""), 1.0)


def put_in_order(group: Group, order: str | None) -> Group:
    """Return objects ordered by "size", "size down" or "color", or unchanged if ``order`` is None.

    "ranks down" orders them by the sizes stated in the text, if any, largest first.

    Objects of one kind that are to be ordered by size, but have no stated sizes, get different
    sizes.
    """
    if order == "color":
        return sorted(group, key=lambda d: _hue(d.attributes.get("color", "")))
    if order not in ("size", "size down", "ranks down"):
        return group
    if order != "ranks down" and len({size_rank(draft) for draft in group}) == 1:
        factors = np.linspace(*_SPREAD, len(group))
        for draft, factor in zip(group, factors, strict=True):
            usual = max(CATEGORIES[draft.category].size) if draft.category else 0.1
            draft.lengths = (float(usual * factor),)
    return sorted(group, key=size_rank, reverse=order != "size")


def _hue(color: str) -> int:
    word = color.split()[-1:]
    return _RAINBOW.index(word[0]) if word and word[0] in _RAINBOW else len(_RAINBOW)
