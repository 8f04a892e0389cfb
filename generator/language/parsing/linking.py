"""What a sentence says about drafts already known: relations, stacks, amounts, packages."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise

from ...catalogue import CATEGORIES
from ...errors import InputError
from ...scene import TABLE
from ..drafts import Draft, Group
from ..relations import fits
from .grammar import NounPhrase
from .lexicon import singular
from .vocabulary import PACKAGES, STACKED


def topmost(target: Draft | str) -> Draft | str:
    """Return the top of a stack that ``target`` is in, else itself."""
    while isinstance(target, Draft) and target.stacked_under is not None:
        target = target.stacked_under
    return target


def stack(group: Group) -> None:
    """Put the drafts on one another, the first at the bottom."""
    for below, above in pairwise(group):
        above.relate("on", below)
        below.stacked_under = above


def link(kind: str, group: Group, targets: Sequence[Draft | str], warnings: list[str]) -> None:
    """Relate the drafts of ``group`` to ``targets``: one each, or all to the first.

    Raises:
        InputError: a draft related to itself.
    """
    if kind == "flank":
        for side, half in (("left_of", group[::2]), ("right_of", group[1::2])):
            link(side, half, targets, warnings)
        return
    paired = len(group) == len(targets) and len(targets) > 1 and kind != "next_to"
    for i, draft in enumerate(group):
        if kind == "on":
            targets = [topmost(target) for target in targets]
        chosen = [targets[i]] if paired else list(targets if kind == "next_to" else targets[:1])
        stacked = any(to in group for _, to in draft.relations)
        for target in [] if stacked else chosen:
            if target is draft:
                raise InputError(
                    f"The text relates the {draft.noun} to itself; name two different objects."
                )
            if kind == "under" and isinstance(target, Draft):
                target.relate("on", draft)
            elif kind == "under":
                warnings.append(f"The {draft.noun} cannot go under the table; it stands on it.")
            elif (kind, target) not in (("on", TABLE), ("in", TABLE), ("next_to", TABLE)):
                draft.relate(kind, target)


def amount(of: NounPhrase, noun: NounPhrase) -> NounPhrase:
    """Read "a stack of three books", "a dozen of eggs", "two pairs of pliers"."""
    several = of.kind == "group" and of.words[-1] not in ("piece", "slice", "type", "kind")
    vague = of.vague or ((3, 3) if several and noun.plural else None)
    count = noun.count if noun.count is not None else of.count
    if of.kind == "group" and noun.count is None and (of.count or 0) <= 1:
        count = None if noun.plural else 1.0
    stacked = bool(STACKED & set(of.words)) and (noun.plural or (noun.count or 0) > 1)
    attributes = {**noun.attributes, **({"stack": "yes"} if stacked else {})}
    return replace(
        noun, count=count, vague=None if count is not None else vague,
        attributes=attributes,
    )  # fmt: skip


def packed(of: NounPhrase, noun: NounPhrase, drafts: Group) -> bool:
    """Read "three bottles of nail polish" or "a box of gloves": one thing, not two."""
    if of.noun not in PACKAGES or noun.determined or not drafts:
        return False
    vessel = CATEGORIES[of.category] if of.category else None
    if noun.category is None:
        if noun.kind != "unknown":
            return False
        for draft in drafts:
            draft.attributes.setdefault("state", f"with {' '.join(noun.words)}")
        return True
    inner = CATEGORIES[noun.category].size
    if vessel is not None and fits("in", inner, vessel.size, vessel.container):
        return False
    itself = not noun.plural or bool(PACKAGES & set(noun.category.split("_")))
    for draft in drafts:
        if itself:
            draft.category, draft.noun = noun.category, noun.noun
        else:
            draft.attributes.setdefault("state", f"with {' '.join(noun.words)}")
    return True


def find_by_head(objects: Sequence[Draft], noun: NounPhrase) -> Group:
    """Return the objects that "the tin" may mean by their last word: the tea tin."""
    head = noun.noun.split()[-1:]
    lasts = [d.noun.split()[-1:] for d in objects]
    return [
        draft
        for draft, last in zip(objects, lasts, strict=True)
        if head and head in (last, [singular(word) for word in last])
    ]
