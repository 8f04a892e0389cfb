"""Modifiers that state what an object contains, carries or lacks, and what it is for."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from ..phrases.nouns import read_noun
from ..phrases.tree import VARIED, Carry, Description, How, Lack, Location, Noun, Post
from ..text import function_words as fw
from .brackets import BracketReader
from .cursor import SUPPORTING


class HoldingReader(BracketReader):
    """Parses "with", "holding", "of" and "without"."""

    def _lacks(self, out: list[Post]) -> bool:
        self.i += 1
        if self._tag() == "of" and (self._tag(1) == "relative" or self._text(1) in fw.PRONOUNS):
            self.i += 2  # "neither of which lies on the book"
            self._skip(fw.BE | fw.PARTICIPLES)
        if (place := self._place()) is not None:
            self._denial(place, out)
            return True
        self._skip(fw.STARTERS)  # "do not want any plates"
        items: list[Noun] = []
        while True:
            noun, end = read_noun(self.tokens, self.i)
            if noun is None:
                break
            self.i = end
            items.append(noun)
            if self._tag() in ("relation", "here") and self._value() in SUPPORTING:
                step = 1 if self._tag() == "here" else 2
                if step == 1 or self._text(1) in fw.PRONOUNS:
                    self.i += step
            more = self._tag() in ("and", "comma") and self._tag(1) != "relation"
            following, _ = read_noun(self.tokens, self.i + 1) if more else (None, 0)
            if following is None or following.determined:
                break
            self.i += 1
        if self._text() in ("there", "here"):
            self.i += 1  # the object may be somewhere else
            return True
        out.append(Lack(tuple(items)))
        return bool(items)

    def _denial(self, place: Location, out: list[Post]) -> None:
        """Parse "not on the book", and the alternative that follows: "but next to it"."""
        out.append(Lack((), place))
        target = place.target
        if self._tag() == "comma" and self._text(1) == "which" and isinstance(target, Noun):
            self.i += 1
            self._posts(target, target.post)  # "not in the cup, which lies on its side"
        k = int(self._tag() == "comma")
        if self._text(k) not in ("but", "rather"):
            return
        before, self.i = self.i, self.i + k + 1
        self._skip(fw.PARTICIPLES)
        instead = self._place()
        if instead is None:
            self.i = before
            return
        there = instead.target
        if isinstance(there, Noun) and there.kind == "pronoun" and isinstance(target, Noun):
            instead = replace(instead, target=replace(target, definite=True, count=None))
        out.append(instead)

    def _carried(self, noun: Noun | None, out: list[Post], each: bool) -> bool:
        how: How = "hold" if self._value() in ("hold", "top") else "with"
        self.i += 1
        if self._tag() == "no" or self._text() == "not":
            return self._lacks(out)
        said = self.tokens[self.i - 1].text.split()
        full = bool(fw.FULL & {*said})
        self.i += self._tag() == "colon" and self._starts_noun(1)  # "contains: pliers, a wrench"
        back = self._returns()
        items = self._items(noun, how)
        if full:
            items = self._until_named_apart(items)
        if not items:
            return False
        for item in items if full and "half" not in said else ():
            if item.plural and not item.determined:
                item.amount = (4, 5)
        out.append(Carry(how, tuple(items), each, back))
        return True

    def _until_named_apart(self, items: list[Noun]) -> list[Noun]:
        """Return the contents in "full of berries, an empty jar", up to an item with an article."""
        named = (k for k, item in enumerate(items) if k and item.determined and _is_apart(item))
        apart = next(named, 0)
        if not apart or items[0].determined:
            return items
        start = items[apart].span[0]
        self.i = next(k for k, token in enumerate(self.tokens) if token.span[0] == start)
        while self._tag(-1) in ("comma", "and"):
            self.i -= 1
        return items[:apart]

    def _contents(self, noun: Noun, out: list[Post]) -> bool:
        self.i += 1
        inner, end = read_noun(self.tokens, self.i)
        if inner is None:
            return False
        self.i = end
        if self._tag() == "open" and inner.category is None:
            self._bracket(inner, inner.post)  # "six sufganiyot (jelly doughnuts)"
        if inner.lengths and not inner.words:
            out.append(Description(({},), inner.lengths, inner.upright))
            return True
        if noun.kind == "table" and inner.family == "person":
            return True  # "the desk of a pupil"
        if kinds := self._kinds(noun, inner):
            noun.count = float(len(kinds))
            out.append(Carry("of", kinds, each=True))
            return True
        items = [inner]
        while self._tag() in ("and", "comma"):
            before = self.i
            joint = self._connector()
            more, end = read_noun(self.tokens, self.i)
            mixed = more is not None and more.plural and not inner.plural  # "flour and two cups"
            if more is None or more.determined or mixed or joint != "and" or self._is_clause(end):
                self.i = before
                break
            self.i = end
            items.append(more)
        out.append(Carry("of", tuple(items)))
        return True

    def _kinds(self, noun: Noun, inner: Noun) -> tuple[Noun, ...]:
        """Parse "bottles of gin, rum and vermouth" as one of each."""
        several = noun.plural and noun.amount is None
        if (
            not several
            or inner.determined
            or inner.plural
            or inner.kind not in ("thing", "abstract")
        ):
            return ()
        before, items = self.i, [inner]
        while self._tag() in ("and", "comma"):
            ends = self._tag() == "and" or self._tag(1) == "and"
            self._connector()
            more, end = read_noun(self.tokens, self.i)
            if more is None or more.determined or more.plural:
                break
            self.i = end
            items.append(more)
            if ends:
                if noun.count in (None, float(len(items))):
                    return tuple(items)
                break
        self.i = before
        return ()

    def _purpose(self) -> bool:
        """Skip a purpose ("for meal prep") unless it states the number of people."""
        before = self.i
        if self._people():
            self.i = before
            return False
        noun, end = read_noun(self.tokens, self.i + 1)
        if noun is None:
            return False
        self.i = end
        return True

    def _more_colors(self, end: int, colors: list[Mapping[str, str]]) -> int:
        """Add "and purple" after "in pink" to the colours; return where they end."""
        while end < len(self.tokens) and self.tokens[end].tag in ("and", "comma"):
            more, beyond = read_noun(self.tokens, end + 1)
            alone = more is not None and more.kind == "adjective" and not more.determined
            if more is None or not alone or set(more.attributes) != {"color"}:
                break
            colors += more.variants or (more.attributes,)
            end = beyond
        return end

    def _aspect(self, owner: Noun | None, out: list[Post]) -> bool:
        """Parse "in different colours", "of various sizes" and "in red"."""
        if self._text() not in ("in", "of"):
            return False
        noun, end = read_noun(self.tokens, self.i + 1)
        if noun is None or noun.definite:
            return False
        last = noun.head.split()[-1:]
        if self._text() == "in" and noun.words in fw.ASPECTS and self._tag(-1) == "word":
            self.i = end  # "blue in colour"
            return True
        aspect = "color" if last == ["colour"] else "".join(last)
        if noun.kind == "adjective" and set(noun.attributes) == {"color"}:
            colors = [*(noun.variants or (noun.attributes,))]
            end = self._more_colors(end, colors)
            if owner is not None and len(colors) > 1 and not (owner.determined or owner.plural):
                owner.count = float(len(colors))  # "nail polish in pink and purple"
            out.append(Description(tuple(colors)))
        elif noun.kind in ("part", "abstract", "thing") and aspect in VARIED and noun.plural:
            each = VARIED[aspect][: int(noun.count)] if noun.count else VARIED[aspect]
            some = noun.count is not None and int(noun.count) == noun.count <= len(VARIED[aspect])
            if owner is not None and some and owner.plural and not owner.determined:
                owner.count = noun.count  # "thread spools in three colours"
            out.append(Description(each))
        else:
            return False
        self.i = end
        return True

    def _is_clause(self, end: int) -> bool:
        return end < len(self.tokens) and self.tokens[end].text in fw.BE


def _is_apart(item: Noun) -> bool:
    """Return whether an item after contents is separate, as in "and a glass full of ice"."""
    holds = any(isinstance(post, Carry) and post.how == "hold" for post in item.post)
    return item.joint != "and" or item.count == 1 or holds
