"""Interpretation of "of", as in a bowl of apples, a glass of orange juice, or a photo of a vase."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from tabletop_objects import CATEGORIES

from ..drafts import Draft, Group
from ..lexicon import category_of, singular
from ..relations import fits
from ..syntax.phrases.tree import Noun
from ..vessel_sizes import LOOSE, holds_things
from ..vocabulary import PACKAGES, SUBSTANCES
from .references import Target

DEPICTIONS = frozenset({
    "photo", "photograph", "picture", "painting", "drawing", "poster", "portrait", "sketch",
    "print", "postcard", "image", "map", "statue", "bust", "figurine", "sculpture", "model",
})  # fmt: skip
"""Objects that merely depict whatever follows "of"."""


DECORATIONS = frozenset({
    "picture", "photo", "print", "drawing", "image", "design", "motif", "logo", "sticker",
    "inscription", "engraving", "writing", "text", "slogan",
    "lid", "cap", "label", "wheel", "wax", "seal", "lids", "caps", "labels", "wheels",
})  # fmt: skip
"""Nouns after "with" that describe an object's appearance."""


def labels(owner: Noun, inner: Noun) -> bool:
    """Return whether "of" only introduces contents or a motif and does not add an object."""
    head = owner.head.split()[-1] if owner.head else ""
    if head in DEPICTIONS or (owner.category or "") in ("picture_frame", "photo_print"):
        return True
    said = " ".join(inner.words)
    if inner.head and category_of((*owner.head.split(), "of", *inner.head.split()[-1:])):
        return True  # "a ball of blue yarn"
    if inner.head in SUBSTANCES or said in SUBSTANCES or set(inner.words) & SUBSTANCES:
        return True
    if inner.kind == "setting":
        return True
    if inner.kind == "abstract":
        return False
    if inner.kind == "collective" or inner.determined:
        return False
    package = head in PACKAGES
    if inner.category == owner.category is not None:
        return True  # "a vase of tulips"
    if inner.category is None:
        return package or not inner.plural or owner.category is not None
    vessel = CATEGORIES[owner.category] if owner.category else None
    size = CATEGORIES[inner.category].size
    if vessel is not None and fits("in", size, vessel.size, vessel.container):
        return False
    return package


_VESSELS = frozenset({"mug", "teacup", "glass", "wine_glass", "paper_cup", "beer_mug", "carafe"})
"""Vessels for drinks only."""


def fills(owner: Noun, items: Sequence[Noun]) -> bool:
    """Return whether "with tea" only names what a vessel contains."""
    if len(items) != 1 or owner.category is None:
        return False
    (item,) = items
    if item.kind == "collective" and not item.determined and holds_things(owner.category):
        return item.head.split()[-1] in ("food", "foods", "snacks")
    if item.category in LOOSE and owner.category not in _VESSELS:
        return False  # crisps in a bowl are separate objects
    packed = bool(PACKAGES & set(owner.head.split()[-1:]))
    holds = owner.category in _VESSELS or packed or holds_things(owner.category)
    vessel = item.category is None or holds
    plain = not item.determined and not item.plural and vessel
    return plain and (item.head in SUBSTANCES or " ".join(item.words) in SUBSTANCES)


_PILE = (5, 6)
"""Number of pieces of loose food in a vessel."""


def loosen(item: Noun, owner: Target) -> Noun:
    """Replace packaged food in a vessel by loose food, such as crisps in a bowl."""
    piece = LOOSE.get(item.category or "")
    vessel = isinstance(owner, list) and owner[0].category
    packed = bool(PACKAGES & {*item.words}) or item.determined
    if piece is None or not vessel or packed or not holds_things(vessel):
        return item
    return replace(item, category=piece, amount=_PILE, plural=True, head=singular(item.head))


def repeats(owner: Noun, items: Sequence[Noun]) -> bool:
    """Return whether "a vase with flowers" names only the vessel's default contents."""
    if len(items) != 1 or items[0].category is None or items[0].determined:
        return False
    return items[0].category == owner.category


def decorates(item: Noun, owners: Group) -> bool:
    """Return whether "with a picture of a cat" only describes a decoration; if so, record it."""
    if item.head not in DECORATIONS or owners[0].category in ("picture_frame", "photo_print"):
        return False
    for draft in owners:
        draft.attributes.setdefault("state", f"with {' '.join(item.words)}")
    return True


def label(owner: Noun, inner: Noun, drafts: Group) -> None:
    """Rename objects after their contents; a package of a known object becomes that object."""
    said = " ".join(inner.words)
    known = inner.category is not None and bool(PACKAGES & set(owner.head.split()[-1:]))
    itself = known and (not inner.plural or bool(PACKAGES & set(str(inner.category).split("_"))))
    whole = category_of((*owner.head.split(), "of", *inner.head.split()[-1:]))
    for draft in drafts:
        draft.also = owner.head
        if whole:
            draft.category = whole
            draft.attributes.update(inner.attributes)
        if itself and inner.head not in SUBSTANCES:
            draft.category, draft.noun = inner.category, inner.head
        else:
            draft.attributes.setdefault("state", f"with {said}")
            draft.contents = said


def full_name(draft: Draft) -> str:
    """Return an object's name including its contents, such as "glass of orange juice"."""
    return f"{draft.noun} of {draft.contents}" if draft.contents else draft.noun
