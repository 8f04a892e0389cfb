"""Lists of objects, and where lists of attached objects end."""

from __future__ import annotations

from tabletop_objects import CATEGORIES

from ...relations import fits
from ...vessel_sizes import open_category
from ...vocabulary import STYLES
from ...words.dictionary import is_finite
from ..phrases.nouns import read_noun
from ..phrases.tree import (
    How,
    Location,
    Noun,
)
from ..phrases.zones import read_zone
from ..text import function_words as fw
from .cursor import ENDS, SUPPORTING
from .posts import PostReader


class ListReader(PostReader):
    """Parses lists of noun phrases."""

    def _lead(self) -> Location | None:
        """Parse a place that precedes its objects: "On the tray are ...", "to its left a book"."""
        before = self.i
        place = self._place(leading=True)
        if place is None:
            self.i = before
            return None
        heading = self._tag() in ("colon", "dash")
        if heading and self._tag(1) in ENDS:
            self.i += 1
            self._heading = place
            return place
        opens = before == 0 or self.tokens[before - 1].tag in (*ENDS, "colon")
        if self._tag() == "carry" and not opens:  # "a tree, in the middle, with three gifts"
            self.i = before
            return None
        spoken = self._text() in fw.BE | fw.STARTERS | fw.PARTICIPLES or self._tag() == "carry"
        if self._tag() == "word" and is_finite(self._text()) and self._starts_noun(1):
            spoken, self.i = True, self.i + 1  # "to the right comes the grinder"
        comma = self._tag() == "comma"
        self.i += comma or heading
        while comma and self._tag() == "arranged":  # ", in a row from left to right: ..."
            self._ordered = self._ordered or "left to right" in self._text()
            self.i += 1 + (self._tag(1) in ("comma", "colon", "dash"))
        skipped = self._skip(fw.BE | fw.STARTERS | fw.PARTICIPLES)
        if self._tag() == "carry":
            self.i += 1
        determined = not (spoken or skipped or heading)
        if self._starts_noun(0, determined=determined and not comma):
            return place
        self.i = before
        return None

    def _items(self, owner: Noun | None, how: How) -> list[Noun]:
        """Parse a list of noun phrases, each with its modifiers."""
        out = self._entry()
        bare: list[Noun] = []
        while out:
            before = self.i
            joint = self._connector()
            headed = owner is not None and owner.kind == "setting" and self._is_zone_heading()
            if not joint or headed or self._closes(owner, how, out, joint) or self._leads():
                self.i = before
                break
            more = self._entry()
            if not more or (owner is not None and joint == "comma" and _is_elsewhere(more[0], how)):
                self.i = before
                break
            more[0].joint = joint
            out += more
        for noun in out if self._each_count else ():  # "glue sticks and scissors, three of each"
            if noun.kind == "thing" and noun.count is None:
                noun.count, noun.amount = self._each_count, None
        self._each_count = 0.0
        out = _describe_before(out)
        for noun in out:  # "a red and a blue mug": the first one shares the noun
            if noun.kind == "adjective" and noun.definite and noun.other:
                noun.kind = "member"  # "the other four blue"
            elif noun.kind == "adjective" and (noun.determined or noun.attributes):
                bare.append(noun)
            elif bare and noun.kind == "member":  # "a small, a medium and a large one"
                for other in bare:
                    other.kind = "member"
                bare = []
            elif bare and noun.kind == "thing":
                for other in bare:
                    other.kind, other.head, other.category = "thing", noun.head, noun.category
                    other.count = other.count or 1.0
                bare = []
        bare = [noun for noun in bare if not noun.post]
        for noun in bare:  # "a mug and a red"
            start, end = noun.span
            said = [t for t in self.tokens if start <= t.span[0] and t.span[1] <= end]
            self.skipped += [token for token in said if token.text not in STYLES]
        return [noun for noun in out if noun not in bare]

    def _entry(self) -> list[Noun]:
        """Parse a noun phrase with its modifiers, or a zone of the table with its objects."""
        headed = self._zone_heading()
        if headed:
            return headed
        noun, end = read_noun(self.tokens, self.i)
        if noun is None:
            return []
        self.i = end
        if noun.kind == "part" and self._tag() == "of":  # "the top drawer of the cabinet"
            whole, beyond = read_noun(self.tokens, end + 1)
            if whole is not None and whole.kind == "thing":
                noun, self.i = whole, beyond
        self._posts(noun, noun.post)
        return [noun]

    def _zone_heading(self) -> list[Noun]:
        """Parse "left side decorated with plants and bottles"."""
        found = read_zone(self.tokens, self.i, heading=True)
        if found is None or found.of:
            return []
        before = self.i
        self.i = found.end
        self._skip(fw.BE | fw.PARTICIPLES)
        if self._tag() not in ("carry", "colon", "dash"):
            self.i = before
            return []
        self.i += 1
        items = self._items(Noun("setting", (), (0, 0)), "with")
        for item in items:
            item.post.append(Location("at", found.zone))
        return items

    def _is_zone_heading(self) -> bool:
        before, skipped = self.i, len(self.skipped)
        found = bool(self._zone_heading())
        self.i = before
        del self.skipped[skipped:]
        return found

    def _leads(self) -> bool:
        """Return whether a place comes before its objects here, as in "on the tray are ..."."""
        before, heading, ordered = self.i, self._heading, self._ordered
        found = self._lead() is not None
        self.i, self._heading, self._ordered = before, heading, ordered
        return found

    def _closes(self, owner: Noun | None, how: How, items: list[Noun], joint: str) -> bool:
        """Return whether the list of objects attached to ``owner`` ends here."""
        if owner is None or owner.kind in ("table", "setting", "vague", "title"):
            return False
        noun, end = read_noun(self.tokens, self.i)
        if noun is None:
            return True
        if end < len(self.tokens) and self.tokens[end].text in fw.BE:
            return True
        ended = any("and" in item.joint for item in items)
        placed = [post for post in items[-1].post if isinstance(post, Location)]
        back = [p for p in placed if isinstance(p.target, Noun) and p.target.kind == "pronoun"]
        if back and back[-1].kind in SUPPORTING and self._returns() is None:
            return True  # "a pot with a cactus in it and a ruler"
        if how == "with" and "comma" in joint and placed and noun.determined:
            return True  # "a bowl with crisps behind it, and a tray"
        if how == "of":
            return noun.determined or joint == "comma" or ended
        if self._returns() is not None:
            return False
        if ended:
            return True
        if how == "hold":
            return not (_may_hold(owner, noun) or self._ends_with_and())
        served = owner.category in ("plate", "bowl") and _is_food(noun)
        if joint == "and" or served:
            return False
        return not (_carries(owner) and _may_hold(owner, noun))

    def _ends_with_and(self) -> bool:
        """Return whether a list continues up to an "and": "a syringe, a thermometer and a swab"."""
        k = self.i
        while k < len(self.tokens):
            noun, end = read_noun(self.tokens, k)
            if noun is None or end >= len(self.tokens):
                return False
            if self.tokens[end].tag == "and":
                return True
            if self.tokens[end].tag != "comma":
                return False
            k = end + 1 + (self.tokens[end + 1].tag == "and" if end + 1 < len(self.tokens) else 0)
            if self.tokens[k - 1].tag == "and":
                return True
        return False

    def _returns(self) -> str | None:
        """Return "on" or "in" if the rest of a list puts all of its items "on it" or "in it"."""
        k = 0
        while self._tag(k) not in (*ENDS, "", "carry", "colon", "dash", "relative"):
            if self._text(k) in fw.BE:
                return None
            kind = self.tokens[self.i + k].value
            if self._tag(k) == "relation" and kind in SUPPORTING:
                pronoun = self._text(k + 1) in fw.PRONOUNS and self._text(k + 1) != "one"
                if self._tag(k + 1) == "each":
                    return None
                ended = self._tag(k + 1) in (*ENDS, "", "comma")  # "with a spoon inside"
                return str(kind) if pronoun or ended else None
            if self._tag(k) == "here" and kind in SUPPORTING:
                return str(kind)
            if self._tag(k) in ("relation", "here"):
                return None
            k += 1
        return None


def _describe_before(items: list[Noun]) -> list[Noun]:
    """Return a list in which "a vase, tall and slim, and a candle" has only two items."""
    out: list[Noun] = []
    open_to = False  # whether the following item describes this one
    for noun in items:
        before = out[-1] if out else None
        open_to = "comma" in noun.joint or open_to
        if before is None or not open_to or not _describes(noun, before):
            out.append(noun)
            open_to = False
            continue
        for attributes in (*noun.variants, noun.attributes):
            before.attributes = {**attributes, **before.attributes}
        before.post += noun.post
    return out


def _describes(noun: Noun, before: Noun) -> bool:
    """Return whether describing words in a list apply to the item before them."""
    bare = noun.kind == "adjective" and noun.words and not (noun.determined or noun.other)
    if not bare or before.kind != "thing" or not before.determined:
        return False
    if noun.variants and (before.plural or (before.count or 1) > 1):
        return False
    again = "color" in noun.attributes and "color" in before.attributes
    return not again  # "a red mug, yellow and a green one"


def _is_elsewhere(item: Noun, how: How) -> bool:
    """Return whether a list item after "with" has its own position, apart from the other items."""
    return how == "with" and any(
        isinstance(post, Location)
        and post.kind in ("left_of", "right_of", "behind", "in_front_of", "next_to")
        and isinstance(post.target, Noun)
        and post.target.definite
        and post.target.kind == "thing"
        for post in item.post
    )


def _may_hold(owner: Noun, item: Noun) -> bool:
    """Return whether an item may be in or on its owner, given the sizes of their categories."""
    if owner.category is None:
        return True
    outer = CATEGORIES[open_category(owner.category)]
    if item.category is None:
        return outer.container or "support" in outer.roles
    inner = CATEGORIES[item.category].size
    return fits("in", inner, outer.size, outer.container) or (
        ("support" in outer.roles or "flat" in outer.roles)
        and fits("on", inner, outer.size, outer.container)
        and min(inner[:2]) < 0.8 * min(outer.size[:2])
    )


_FOOD = frozenset({"bread", "fruit", "slab", "sweet", "meal"})
"""Families of objects that are food."""


def _is_food(item: Noun) -> bool:
    if item.category is None:
        return item.family in _FOOD
    return "edible" in CATEGORIES[item.category].roles


def _carries(owner: Noun) -> bool:
    """Return whether an object is made to carry others, such as a tray, a basket or a board."""
    if owner.category is None or owner.head.split()[-1:] == ["plate"]:
        return False
    outer = CATEGORIES[owner.category]
    return "support" in outer.roles or (outer.container and min(outer.size[:2]) > 0.18)
