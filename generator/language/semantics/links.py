"""Relations between groups of drafts: one draft per target, stacks, or drafts on both sides."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

from tabletop_objects import CATEGORIES

from ...scene import TABLE
from ..drafts import Draft, Group, Reading

SIDES = ("left_of", "right_of", "in_front_of", "behind")
_FEW = 3  # maximum number of targets that one object can be beside

_OF_BOTH = ("between",)
_BESIDE: dict[str, str] = dict.fromkeys(("against", "opposite", "beside", "at", "laid"), "next_to")


def topmost(target: Draft | str) -> Draft | str:
    """Return the top of the stack that contains ``target``, or ``target`` itself."""
    while isinstance(target, Draft) and target.stacked_under is not None:
        target = target.stacked_under
    return target


def stack(group: Group) -> None:
    """Stack the drafts, with the first one at the bottom."""
    for below, above in pairwise(group):
        above.relate("on", below)
        below.stacked_under = above


def unstack(group: Group) -> None:
    """Undo the stacking of a group of drafts."""
    for draft in group:
        draft.stacked_under = None
        others = [(k, to) for k, to in draft.relations if all(to is not d for d in group)]
        draft.relations[:] = others


def lies_flat(draft: Draft) -> bool:
    """Return whether objects of this kind, such as books, can be piled on each other."""
    if draft.category is None:
        return False
    x, y, z = CATEGORIES[draft.category].size
    return z < 0.4 * min(x, y) and min(x, y) > 0.09


_PILED = frozenset({"book", "notebook", "magazine", "box", "pizza", "newspaper", "open_book"})
"""Categories that are stacked if a single object is on several: "a monitor on two books"."""


def _pile(targets: Sequence[Draft | str]) -> bool:
    kinds = {t.category if isinstance(t, Draft) else None for t in targets}
    free = all(isinstance(t, Draft) and t.stacked_under is None for t in targets)
    return len(targets) > 1 and len(kinds) == 1 and kinds <= _PILED and free


def link(kind: str, group: Group, targets: Sequence[Draft | str], warnings: list[str]) -> None:
    """Relate the drafts of ``group`` to ``targets``: one draft to each target, or all to the first.

    Raises:
        InputError: A draft is related to itself.
    """
    kind = _BESIDE.get(kind, kind)
    if kind == "on" and len(group) == 1 and _pile(targets):
        stack([target for target in targets if isinstance(target, Draft)])
    few = len(group) == 1 and 1 < len(targets) <= _FEW and kind in SIDES
    everyone = kind == "next_to" or kind in _OF_BOTH or few  # "in front of both"
    paired = len(targets) > 1 and not everyone and len(group) % len(targets) == 0
    share = len(group) // len(targets) if paired else len(group)
    for i, draft in enumerate(group):
        if kind == "on":
            targets = [topmost(target) for target in targets]
        chosen = [targets[i // share]] if paired else list(targets if everyone else targets[:1])
        if any(to is other for _, to in draft.relations for other in group):
            continue  # already stacked with the others
        if kind == "between" and len(group) == 1 and len(chosen) == 2:
            _put_beside(draft, chosen)
        for target in chosen:
            if target is draft:
                continue
            _link(kind, draft, target, warnings)


def _link(kind: str, draft: Draft, target: Draft | str, warnings: list[str]) -> None:
    if kind == "under" and isinstance(target, Draft):
        target.relate("on", draft)
    elif kind == "under":
        warnings.append(f"The {draft.noun} cannot be under the table; it is placed on the table.")
    elif kind == "between":
        draft.relate("next_to", target)
    elif (kind, target) not in (("on", TABLE), ("in", TABLE), ("next_to", TABLE)):
        draft.relate(kind, target)


def _put_beside(draft: Draft, targets: Sequence[Draft | str]) -> None:
    """Put the targets of "between" to the left and right of a draft if they have no relations."""
    for kind, target in zip(("left_of", "right_of"), targets, strict=True):
        if isinstance(target, Draft) and target is not draft and not target.relations:
            target.relate(kind, draft)


def flank(group: Group, targets: Group, reading: Reading) -> None:
    """Put half of a group on either side of the targets; a single object is duplicated."""
    if len(group) == 1:
        one = group[0]
        group.append(reading.add(one.noun, one.category, one.attributes))
    for kind, half in (("left_of", group[::2]), ("right_of", group[1::2])):
        link(kind, half, targets[:1], reading.warnings)
