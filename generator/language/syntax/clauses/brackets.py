"""Appositions that follow a noun phrase: brackets, numbers, kinds and orders."""

from __future__ import annotations

from collections.abc import Mapping

from ...vocabulary import COLORS
from ..phrases.nouns import read_noun
from ..phrases.tree import Counted, Description, Noun, Post
from ..phrases.zones import read_zone
from ..text import function_words as fw
from .cursor import ENDS
from .places import PlaceReader

_THERE_ARE = frozenset({"there", "are", "is", "with", "about", "say", "all"})
_LEADING = frozenset(["so", "that", "with", "the", "and", ","])
_THEM = frozenset(
    {"of", "them", "these", "those", "in", "total", "or", "so", "each", "altogether", "please",
     "pieces", "pcs", "all"}
)  # fmt: skip


class BracketReader(PlaceReader):
    """Parses appositions that brackets, dashes or commas set off."""

    def _bracket(self, noun: Noun, out: list[Post]) -> bool:
        """Parse a number or a length in an apposition: "candles (4)", "plates - four to six -"."""
        opening = self._tag()
        if opening not in ("open", "dash", "comma", "colon"):
            return False
        before = self.i
        self.i += 1
        many = noun.plural or noun.arrangement is not None or (noun.count or 1) > 1
        if (
            opening == "open"
            and many
            and (self._colors_listed(noun, out) or self._kinds_listed(noun))
        ):
            return True
        while self._text() in _THERE_ARE:
            self.i += 1
        found, end = read_noun(self.tokens, self.i)
        if self._distance() is not None:
            self.i = before
            return False  # "a mug, 5 cm from the edge"
        sized = found is not None and bool(found.lengths) and not found.words
        listed = opening in ("comma", "colon") and not (sized and opening == "comma")
        recounted = found is not None and noun.count is None and self._counts_them(found, end)
        if found is None or (listed and not recounted):
            self.i = before
            return False
        self.i = end
        if not found.words and found.lengths:
            out.append(Description(({},), found.lengths, found.upright))
        elif found.kind == "member" and not found.words and (found.count or found.amount):
            single = noun.kind == "thing" and not (noun.determined or noun.post)
            if many or (single and opening == "open"):
                noun.count, noun.amount = found.count, found.amount
            elif found.count and self._tag() == "close":
                out.append(Counted(found.count))
            else:
                self.i = before
                return False
        elif opening == "open" and self._tag() == "close" and _explains(found, noun):
            noun.category = found.category  # "sufganiyot (jelly doughnuts)"
        elif opening == "open" and self._tag() == "close" and _describes(found):
            out.append(Description((found.attributes,)))  # "a toolbox (open)"
        elif not many or not self._parcels(found, noun, out):
            self.i = before
            return False
        while self._tag() in ("of", "word") and self._text() in _THEM:
            self.i += 1
        if self._tag() in ("close", "dash") or (opening in ("dash", "comma") and self._ended()):
            self.i += self._tag() in ("close", "dash")
            return True
        if opening in ("comma", "colon"):
            return True
        self.i = before
        return False

    def _colors_listed(self, noun: Noun, out: list[Post]) -> bool:
        """Parse "three cans (red, green, orange)"."""
        k, colors = 0, []
        while self._text(k) in COLORS and self._tag(k + 1) in ("comma", "and", "close"):
            colors.append(self._text(k))
            k += 2
            if self._tag(k - 1) == "close":
                break
            k += self._tag(k) == "and"
        fits = noun.count is None or int(noun.count) == len(colors)
        if len(colors) < 2 or self._tag(k - 1) != "close" or not fits:
            return False
        noun.count = noun.count or float(len(colors))
        out.append(Description(tuple({"color": color} for color in colors)))
        self.i += k
        return True

    def _kinds_listed(self, noun: Noun) -> bool:
        """Parse "cookie cutters (star, heart, moon)" as kinds, which also give the count."""
        k, kinds = self.i, 0
        while k < len(self.tokens):
            one, end = read_noun(self.tokens, k)
            if one is None or one.determined or one.kind == "adjective" or one.lengths:
                return False
            k, kinds = end, kinds + 1
            tag = self.tokens[k].tag if k < len(self.tokens) else ""
            if tag == "close":
                break
            if tag not in ("comma", "and"):
                return False
            k += 1 + (self.tokens[k + 1].tag == "and" if k + 1 < len(self.tokens) else 0)
        if kinds < 2:
            return False
        noun.count = float(kinds) if noun.count is None and noun.amount is None else noun.count
        self.i = k + 1
        return True

    def _of_each(self, noun: Noun, out: list[Post]) -> bool:
        """Parse ", two of each colour" as a count for each kind or list item."""
        k = int(self._tag() in ("comma", "open", "dash"))
        number = fw.NUMBERS.get(self._text(k), 0.0)
        if k and self._tag(k) == "number":
            number = float(self.tokens[self.i + k].value)
        packed = int(
            self._tag(k + 1) == "word" and self._tag(k + 2) == "of"
        )  # "one bottle of each"
        if not k or not number or self._tag(k + 1 + packed) != "of":
            return False
        if self._tag(k + 2 + packed) != "each":
            return False
        self.i += k + 3 + packed
        if self._tag() == "word" and self._text() in fw.KINDS:
            self.i += 1
        self.i += self._tag() in ("close", "dash")
        each = [a for post in out if isinstance(post, Description) for a in post.each]
        kinds = noun.variants or tuple(each)
        if len(kinds) > 1:
            noun.count, noun.amount = number * len(kinds), None
            repeated = tuple(a for a in kinds for _ in range(int(number)))
            noun.variants = ()
            out[:] = [post for post in out if not isinstance(post, Description)]
            out.append(Description(repeated))
        else:
            self._each_count = number
        return True

    def _order_by_ends(self) -> str | None:
        """Parse "from the largest on the left to the smallest on the right"."""
        if order := self._order_from_bottom():
            return order
        apart = self._tag() == "comma" and self._text(1) in fw.SUPERLATIVES
        one = read_zone(self.tokens, self.i + 1 + apart)
        ends = one is None or self._tag(one.end - self.i) in (*ENDS, "", "close")
        if (apart or self._text() in fw.SUPERLATIVES) and one is not None and ends and one.zone.x:
            small = fw.SUPERLATIVES[self._text(int(apart))] == "small"
            self.i = one.end  # "in a row, shortest on the left"
            return "size" if small == (one.zone.x == -1) else "size down"
        if self._text() in fw.SUPERLATIVES and (zone := read_zone(self.tokens, self.i + 1)):
            k = zone.end - self.i  # "shortest at the left, longest at the right"
            k += self._tag(k) == "comma"
            k += self._tag(k) == "and"
            other = read_zone(self.tokens, self.i + k + 1)
            if self._text(k) in fw.SUPERLATIVES and other is not None:
                small = fw.SUPERLATIVES[self._text()] == "small"
                self.i = other.end
                return "size" if small == (zone.zone.x == -1) else "size down"
        if self._text() != "from":
            return None
        named = [k for k in range(1, 12) if self._text(k) in fw.SUPERLATIVES]
        between = [k for k in range(1, 12) if self._text(k) == "to"]
        stops = [k for k in range(1, 12) if self._tag(k) in ("stop", "line", "comma", "")]
        if len(named) < 2 or not any(named[0] < k < named[1] for k in between):
            return None
        if stops and stops[0] < named[1]:
            return None
        first = fw.SUPERLATIVES[self._text(named[0])]
        self.i += named[1] + 1
        zone = read_zone(self.tokens, self.i)
        self.i = zone.end if zone is not None and not zone.of else self.i
        return "size" if first == "small" else "size down"

    def _order_from_bottom(self) -> str | None:
        """Parse "so that the largest is at the bottom and the smallest on top"."""
        k, small = 0, None
        while True:
            start = k
            while self._text(k) in _LEADING:
                k += 1
            size = fw.SUPERLATIVES.get(self._text(k))
            k += 1 + (self._text(k + 1) in ("one", "ones"))
            k += self._text(k) in fw.BE
            ended = [t.text for t in self.tokens[self.i + k : self.i + k + 3]]
            low = ended[:3] in (["at", "the", "bottom"], ["on", "the", "bottom"])
            top = ended[:1] in (["on top"], ["at the top of"]) or ended[:3] == ["on", "the", "top"]
            if size is None or not (low or top):
                break
            small = (size == "small") == low if small is None else small
            k += 3 if low or ended[:1] != ["on top"] else 1
            start = k
        if small is None:
            return None
        self.i += start
        return "size" if small else "size down"

    def _aside(self) -> bool:
        """Skip a bracket whose content is not understood."""
        if self._tag() != "open":
            return False
        end = next((k for k in range(1, 12) if self._tag(k) in ("close", *ENDS)), 0)
        if self._tag(end) != "close":
            return False
        inside = self.tokens[self.i + 1 : self.i + end]
        for start in range(len(inside)):
            noun, _ = read_noun(inside, start)
            if noun is not None and (noun.category or noun.family or noun.kind == "table"):
                return False
        if any(token.tag in ("relation", "here", "carry", "arranged") for token in inside):
            return False
        self.skipped += inside
        self.i += end + 1
        return True

    def _counts_them(self, found: Noun, end: int) -> bool:
        """Return whether ", three of them" states the count of the previous noun."""
        following = [token.text for token in self.tokens[end - 2 : end + 2]]
        bare = not found.words and (found.count is not None or found.amount is not None)
        return bare and "them" in following

    def _parcels(self, found: Noun, noun: Noun, out: list[Post]) -> bool:
        """Parse "5 blue, 2 red" as a count for each attribute."""
        each: list[Mapping[str, str]] = []
        one: Noun | None = found
        while one is not None and one.kind == "adjective" and one.count:
            each += [one.attributes] * int(one.count)
            more = self._tag() in ("comma", "and")
            one, end = read_noun(self.tokens, self.i + 1) if more else (None, self.i)
            self.i = end if one is not None else self.i
        if len(each) < 2 or len(each) > 40 or one is not None:
            return False
        noun.count, noun.amount = float(len(each)), None
        out.append(Description(tuple(each)))
        return True

    def _listed_attributes(self, noun: Noun | None, out: list[Post]) -> bool:
        """Parse ", small, medium and large" and ", one red and one blue" after a plural noun."""
        if noun is None or not (noun.plural or (noun.count or 1) > 1):
            return False
        before, each = self.i, []
        while self._tag() in ("comma", "and", "open", "close", "colon", "dash"):
            self.i += 1
            if self._tag() in ("comma", "and"):
                continue
            one, end = read_noun(self.tokens, self.i)
            if one is None or one.kind != "adjective" or not one.words:
                break
            each += list(one.variants) or [one.attributes] * int(one.count or 1)
            self.i = end
        if len(each) < 2 or (noun.count is not None and len(each) != int(noun.count)):
            self.i = before
            return False
        out.append(Description(tuple(each)))
        return True


def _describes(noun: Noun) -> bool:
    return noun.kind == "adjective" and not noun.determined and bool(noun.attributes)


def _explains(found: Noun, noun: Noun) -> bool:
    """Return whether a known word in brackets explains the unknown one before them."""
    strange = noun.kind == "thing" and noun.category is None
    return strange and found.category is not None and not found.determined
