"""What follows a noun phrase and belongs to it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from ...words.speech import is_verb
from ..phrases.nouns import read_noun
from ..phrases.tree import (
    VARIED,
    Arranged,
    Carry,
    Counted,
    Description,
    How,
    Lack,
    Location,
    Noun,
    Post,
)
from ..phrases.zones import read_zone
from ..text import function_words as fw
from .cursor import ENDS, SUPPORTING
from .places import PlaceReader

_THERE_ARE = frozenset({"there", "are", "is", "with", "about", "say", "all"})
_THEM = frozenset(
    {"of", "them", "these", "those", "in", "total", "or", "so", "each", "altogether", "please",
     "pieces", "pcs", "all"}
)  # fmt: skip


class PostReader(PlaceReader):
    """Reads what is said of a noun phrase after it."""

    def _posts(self, noun: Noun | None, out: list[Post], *, nested: bool = False) -> None:
        """Read all that follows a noun phrase, or a verb, and belongs to it.

        ``nested``: of the target of a relation, to which nothing after a comma belongs.
        """
        while not self._ended() and not (nested and self._tag() in ("comma", "open", "and")):
            before = self.i
            if not self._post(noun, out):
                self.i = before
                return

    def _post(self, noun: Noun | None, out: list[Post]) -> bool:
        if (noun is not None and self._bracket(noun, out)) or self._aside():
            return True
        if noun is not None and self._of_each(noun, out):
            return True
        comma = self._tag() in ("comma", "open")
        joined = self._tag() == "and"
        if comma or joined:
            if (not out and joined) or not self._goes_on():
                return self._listed_attributes(noun, out) if comma else False
            self.i += 1
        if self._tag() in ("colon", "dash"):
            return self._listed_attributes(noun, out)
        if self._tag() == "relation" and self._tag(1) == "relative" and self._value() in SUPPORTING:
            back = str(self._value())  # "on which are two eggs"
            self.i += 2
            self._skip(fw.BE | fw.STARTERS)
            items = self._items(noun, "hold")
            self._skip(fw.BE | fw.PARTICIPLES)
            out.append(Carry("hold", tuple(items), back=back))
            return bool(items)
        word = self._text()
        if noun is not None and self._seats and self._tag() == "each" and (
            self._tag(1) in (*ENDS, "", "comma", "and")
        ):  # "a dinner plate each"
            self.i += 1
            noun.seated = True
            return True
        each = self._tag() == "each" or self._text() in ("all", "both")
        if self._tag() == "each" and self._text(1) == "one" and self._tag(2) == "of":
            self.i += 3  # "every one of them with a cupcake"
        if self._tag() == "each" or (each and self._tag(1) in ("relation", "carry", "arranged")):
            self.i += 1
            self._skip(fw.BE)
        self._skip(fw.PARTICIPLES - {"left", "right", "far"})
        if self._is_participle():
            self.i += 1
        if self._text() in fw.HANDLED and self._text(1) == "by" and self._starts_noun(2):
            self.i = read_noun(self.tokens, self.i + 2)[1]  # "to be sorted by the robot"
            return True
        if self._tag() == "relative" or (self._text() == "that" and noun is not None):
            self.i += 1
            self._skip(fw.BE | fw.PARTICIPLES)
            gone = self._text() in ("has", "have", "had") and is_verb(self._text(1))
            self.i += gone  # "that has gone out"
            if self._tag() == "word" and is_verb(self._text()) and self._text() not in fw.BE:
                self.i += 1  # "that usually comes along"
                along = self._text() in ("along", "out", "up", "off", "away", "down")
                self.i += along and not self._starts_noun(1)
            return True
        if order := self._order_by_ends():
            out.append(Arranged("row", order))
            return True
        if self._tag() == "order":
            out.append(Arranged("row", str(self._take().value)))
            return True
        if self._tag() == "posture":
            out.append(Description(({"posture": str(self._take().value)},)))
            return True
        if self._tag() == "arranged":
            return self._arranged(out)
        if self._tag() == "no":
            said = (self._text(), self._text(1))
            return said not in fw.LEFT_OUT and self._lacks(out)
        if self._tag() == "carry":
            return self._carried(noun, out, each)
        if self._text() == "per" and self._text(1) in fw.SEATED and noun is not None:
            self.i += 2
            noun.seated = True
            return True
        if self._text() == "for" and noun is not None:
            if self._tag(1) == "each" and self._text(2) in fw.SEATED:
                self.i += 3
                noun.seated = True
                return True
            return self._purpose()
        if self._text() == "to" and self._text(1) in fw.BE:
            self.i += 2  # "I would like the can to stand in front of it"
            return True
        if self._text() == "like" and self._starts_noun(1):  # "like soldiers"
            self.i = read_noun(self.tokens, self.i + 1)[1]
            return True
        if self._aspect(out):
            return True
        if self._tag() == "of" and noun is not None:
            return self._contents(noun, out)
        told = noun is not None and noun.kind == "member" and (noun.ordinal or noun.other)
        if told and not comma and not joined and not out:
            if self._starts_noun(0, determined=True):  # "the third two doughnuts"
                out.append(Carry("hold", tuple(self._items(noun, "hold"))))
                return True
        place = self._place()
        if place is not None:
            whole = word == "all" and comma and noun is not None
            out.append(replace(place, each=place.each or (each and not whole), whole=whole))
            return True
        if noun is not None and self._tag() in ("word", "number") and not comma:
            return self._described(out)
        return False

    def _of_each(self, noun: Noun, out: list[Post]) -> bool:
        """Read ", two of each colour": so many of each kind or each item of the list."""
        k = int(self._tag() in ("comma", "open", "dash"))
        number = fw.NUMBERS.get(self._text(k), 0.0)
        if k and self._tag(k) == "number":
            number = float(self.tokens[self.i + k].value)
        packed = int(self._tag(k + 1) == "word" and self._tag(k + 2) == "of")  # "one bottle of each"
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

    def _is_participle(self) -> bool:
        """Tell whether a verb's form comes next that adds nothing to a place: "parked in front"."""
        word = self._text()
        placed = self._tag(1) in ("relation", "here", "arranged") or (
            read_zone(self.tokens, self.i + 1) is not None
        )
        verbal = self._tag() == "word" and word.endswith(("ed", "ing", "en", "t"))
        return placed and verbal and is_verb(word) and not self._starts_category()

    def _bracket(self, noun: Noun, out: list[Post]) -> bool:
        """Read a number or a length set apart: "candles (4)", "plates - four to six -"."""
        opening = self._tag()
        if opening not in ("open", "dash", "comma", "colon"):
            return False
        before = self.i
        self.i += 1
        many = noun.plural or noun.arrangement is not None
        if opening == "open" and many and self._kinds_listed(noun):
            return True
        while self._text() in _THERE_ARE:
            self.i += 1
        found, end = read_noun(self.tokens, self.i)
        sized = found is not None and bool(found.lengths) and not found.words
        listed = opening in ("comma", "colon") and not (sized and opening == "comma")
        recounted = found is not None and noun.count is None and self._counts_them(found, end)
        if found is None or (listed and not recounted):
            self.i = before
            return False
        self.i = end
        if not found.words and found.lengths:
            out.append(Description(({},), found.lengths))
        elif found.kind == "member" and not found.words and (found.count or found.amount):
            single = noun.kind == "thing" and not (noun.determined or noun.post)
            if many or (single and opening == "open"):
                noun.count, noun.amount = found.count, found.amount
            elif found.count and self._tag() == "close":
                out.append(Counted(found.count))
            else:
                self.i = before
                return False
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

    def _kinds_listed(self, noun: Noun) -> bool:
        """Read "cookie cutters (star, heart, moon)": which they are, and so how many."""
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

    def _order_by_ends(self) -> str | None:
        """Read "from the largest on the left to the smallest on the right"."""
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

    def _aside(self) -> bool:
        """Skip a bracket in which nothing is understood."""
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
        """Tell whether ", three of them" counts what was just named."""
        following = [token.text for token in self.tokens[end - 2 : end + 2]]
        bare = not found.words and (found.count is not None or found.amount is not None)
        return bare and "them" in following

    def _parcels(self, found: Noun, noun: Noun, out: list[Post]) -> bool:
        """Read "5 blue, 2 red": how many there are of each."""
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

    def _goes_on(self) -> bool:
        """Tell whether more about the same thing follows a comma or "and"."""
        if self._tag(1) in ("each", "arranged", "order", "posture", "relative", "no"):
            return True
        if self._text(1) in fw.SUPERLATIVES and read_zone(self.tokens, self.i + 2) is not None:
            return True
        if self._tag(1) == "relation" and self._tag(2) == "relative":
            return True
        if self._text(1) in ("all", "both") and self._tag(2) in ("relation", "arranged", "carry"):
            return True
        k = 1
        while self._text(k) in fw.PARTICIPLES and self._tag(k) == "word":
            k += 1
        if self._tag(k) == "carry" and (self._tag() == "comma" or k > 1):
            return self.tokens[self.i + k].text not in ("plus", "as well as", "along with")
        before = self.i
        self.i += k
        place = self._place()
        follows = place is not None and not self._starts_noun(0) and self._text() not in fw.BE
        self.i = before
        return follows and not self._leads_after()

    def _leads_after(self) -> bool:
        before = self.i
        self.i += 1
        found = self._leads()
        self.i = before
        return found

    def _arranged(self, out: list[Post]) -> bool:
        kind = self._take().value
        order = None
        if self.tokens[self.i - 1].words[-1].text == "around" and self._starts_noun(0):
            target = self._target(nested=False)  # "scattered around the book"
            if target is not None:
                out.append(Location("next_to", target))
                return True
        if self._tag() == "order":
            order = str(self._take().value)
        elif "left to right" in self.tokens[self.i - 1].text:
            order = "listed"
        out.append(Arranged(kind, order))
        return True

    def _lacks(self, out: list[Post]) -> bool:
        self.i += 1
        if self._place() is not None:
            return True  # "that is not on the book"
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
            self.i += 1  # elsewhere there may be some
            return True
        out.append(Lack(tuple(items)))
        return bool(items)

    def _carried(self, noun: Noun | None, out: list[Post], each: bool) -> bool:
        how: How = "hold" if self._value() in ("hold", "top") else "with"
        self.i += 1
        if self._tag() == "no" or self._text() == "not":
            return self._lacks(out)
        back = self._returns()
        full = self.tokens[self.i - 1].text.split()[0] in fw.FULL
        items = self._items(noun, how)
        if not items:
            return False
        for item in items if full else ():
            if item.plural and not item.determined:
                item.amount = (4, 5)
        out.append(Carry(how, tuple(items), each, back))
        return True

    def _contents(self, noun: Noun, out: list[Post]) -> bool:
        self.i += 1
        inner, end = read_noun(self.tokens, self.i)
        if inner is None:
            return False
        self.i = end
        if inner.lengths and not inner.words:
            out.append(Description(({},), inner.lengths))
            return True
        if noun.kind == "table" and inner.family == "person":
            return True  # "the desk of a pupil"
        if (kinds := self._kinds(noun, inner)):
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
        """Read "bottles of gin, rum and vermouth": one of each."""
        several = noun.plural and noun.amount is None
        if not several or inner.determined or inner.plural or inner.kind not in ("thing", "abstract"):
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
        """Skip what something is for ("for meal prep"), unless it is for so many people."""
        before = self.i
        if self._people():
            self.i = before
            return False
        noun, end = read_noun(self.tokens, self.i + 1)
        if noun is None:
            return False
        self.i = end
        return True

    def _aspect(self, out: list[Post]) -> bool:
        """Read "in different colours", "of various sizes", "in red"."""
        if self._text() not in ("in", "of"):
            return False
        noun, end = read_noun(self.tokens, self.i + 1)
        if noun is None or noun.definite:
            return False
        last = noun.head.split()[-1:]
        aspect = "color" if last == ["colour"] else "".join(last)
        if noun.kind == "adjective" and set(noun.attributes) == {"color"}:
            out.append(Description(noun.variants or (noun.attributes,)))
        elif noun.kind in ("part", "abstract", "thing") and aspect in VARIED and noun.plural:
            out.append(Description(VARIED[aspect]))
        else:
            return False
        self.i = end
        return True

    def _is_clause(self, end: int) -> bool:
        return end < len(self.tokens) and self.tokens[end].text in fw.BE

    def _described(self, out: list[Post]) -> bool:
        """Read describing words after the noun: "a book open", "three mugs upside down"."""
        noun, end = read_noun(self.tokens, self.i)
        if noun is None:
            return False
        measured = noun.kind == "member" and bool(noun.lengths) and not noun.words
        if not measured and (noun.kind != "adjective" or noun.determined):
            return False
        self.i = end
        out.append(Description((noun.attributes,), noun.lengths))
        return True

    def _listed_attributes(self, noun: Noun | None, out: list[Post]) -> bool:
        """Read ", small, medium and large" and ", one red and one blue" after several things."""
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
