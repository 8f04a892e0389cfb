"""Modifiers that follow a noun phrase."""

from __future__ import annotations

from dataclasses import replace

from tabletop_objects import CATEGORIES

from ...vocabulary import COLORS
from ...words.dictionary import is_verb
from ..phrases.introductions import is_describing
from ..phrases.nouns import read_noun
from ..phrases.tree import (
    Arranged,
    Carry,
    Description,
    Location,
    Noun,
    Post,
    Zone,
)
from ..phrases.zones import read_zone
from ..text import function_words as fw
from .contents import HoldingReader
from .cursor import ENDS, SUPPORTING


class PostReader(HoldingReader):
    """Parses modifiers that follow a noun phrase."""

    def _posts(self, noun: Noun | None, out: list[Post], *, nested: bool = False) -> None:
        """Parse all modifiers of a noun phrase, or of a verb.

        ``nested`` means that the noun is the target of a relation, so its modifiers end at a comma.
        """
        while not self._ended() and not (nested and self._tag() in ("comma", "open", "and")):
            before = self.i
            if not self._post(noun, out):
                self.i = before
                return

    def _post(self, noun: Noun | None, out: list[Post]) -> bool:
        if (noun is not None and self._bracket(noun, out)) or self._aside():
            return True
        if self._text() == "instead":
            self.i += 1
            return True
        if self._side_apart(out) or (noun is not None and self._one_at_each(noun, out)):
            return True
        if noun is not None and (self._of_each(noun, out) or self._compared(out)):
            return True
        comma = self._tag() in ("comma", "open")
        joined = self._tag() == "and"
        if comma or joined:
            if (not out and joined) or not self._goes_on():
                return self._listed_attributes(noun, out) if comma else False
            self.i += 1
        if self._tag() == "dash" and noun is not None and self._places_on(1):
            self.i += 1  # "Drill - to the right of the toolbox"
        if self._tag() == "dash" and noun is not None and self._holds_aside(noun):
            self.i += 1  # "a big plate - two eggs and two sausages - with ..."
            out.append(Carry("hold", tuple(self._items(noun, "hold"))))
            self.i += self._tag() == "dash"
            return True
        if self._tag() in ("colon", "dash"):
            return self._listed_attributes(noun, out)
        if self._in_which(noun, out) or self._one_each(noun):
            return True
        word = self._text()
        each = self._distributes()
        self._skip(fw.PARTICIPLES - {"left", "right", "far"})
        if self._is_participle():
            self.i += 1
        if self._tag() == "carry":
            return self._carried(noun, out, each)
        if self._tag() == "no":
            said = (self._text(), self._text(1))
            away = self._text(1) == "on" and self._is_table(2)  # "is not on the desk today"
            return said not in fw.LEFT_OUT and not away and self._lacks(out)
        if any(read(noun, out) for read in (self._told, self._ordered_so, self._seated_so)):
            return True
        if self._text() == "for" and noun is not None:
            return self._purpose()
        if self._aspect(noun, out):
            return True
        if self._tag() == "of" and noun is not None:
            return self._contents(noun, out)
        if not (comma or joined) and self._ellipsis(noun, out):
            return True
        place = self._place()
        if place is not None:
            whole = word == "all" and comma and noun is not None
            out.append(replace(place, each=place.each or (each and not whole), whole=whole))
            return True
        if self._apart():
            return True
        if noun is not None and self._tag() in ("word", "number") and not comma:
            return self._described(out)
        return False

    def _holds_aside(self, noun: Noun) -> bool:
        """Return whether dashes enclose the contents of a plate or a bowl."""
        roles = CATEGORIES[noun.category].roles if noun.category else ()
        ahead = self.tokens[self.i + 1 :]
        end = next((k for k, token in enumerate(ahead) if token.tag in (*ENDS, "dash")), 0)
        closed = bool(ahead) and ahead[end].tag == "dash"
        carries = {"container", "support"} & {*roles} and not noun.plural
        return bool(carries) and closed and self._starts_noun(1, determined=True)

    def _places_on(self, ahead: int) -> bool:
        """Return whether contents, or a place that extends to the closing dash, come next."""
        if self._tag(ahead) == "carry" and self._value_at(ahead) == "hold":
            return True
        before = self.i
        self.i += ahead
        arranged = self._tag() == "arranged"
        self.i += arranged
        place = None if arranged else self._place()
        ends = self._tag() in (*ENDS, "", "comma", "and", "dash", "close")
        self.i = before
        return (arranged or place is not None) and ends

    def _compared(self, out: list[Post]) -> bool:
        """Parse "half as tall as the mug" or "bigger than the plate" as small or large."""
        k = int(self._tag() == "comma")
        k += self._text(k) in ("slightly", "much", "somewhat", "far")
        k += 2 * ((self._text(k), self._text(k + 1)) == ("a", "bit"))
        less = self._text(k) == "half"
        k += self._text(k) in ("half", "twice")
        word = self._text(k + 1) if self._text(k) == "as" else self._text(k)
        joined = self._text(k + 2) == "as" if self._text(k) == "as" else self._text(k + 1) == "than"
        if not joined or (not is_describing(word.removesuffix("er")) and word not in fw.COMPARED):
            return False
        start = self.i + k + (3 if self._text(k) == "as" else 2)
        noun, end = read_noun(self.tokens, start)
        pronoun = self._text(start - self.i) in fw.PRONOUNS
        if noun is None and not pronoun:
            return False
        self.i = start + 1 if pronoun else end
        same = self._text(k - 1) not in ("half", "twice") and word not in fw.COMPARED
        low = word in ("small", "short", "thin", "narrow", "low")
        size = "small" if less or low or fw.COMPARED.get(word) == "small" else "large"
        out.append(Description(({} if same else {"size": size},)))
        return True

    def _side_apart(self, out: list[Post]) -> bool:
        """Parse ", centre" when it follows "at the back"."""
        side = fw.SIDES.get(self._text(1)) if self._tag() == "comma" else None
        placed = any(isinstance(p, Location) and isinstance(p.target, Zone) for p in out)
        if side is None or not placed or self._tag(2) not in (*ENDS, "", "comma"):
            return False
        self.i += 2
        if side != (0, 0):  # "at the back, centre" is the middle of the back
            out.append(Location("at", Zone(*side)))
        return True

    def _one_at_each(self, noun: Noun, out: list[Post]) -> bool:
        """Parse "price tags - one in front of each of them"."""
        bare = noun.plural and noun.count is None and noun.amount is None
        if not bare or self._tag() not in ("dash", "comma", "open", "colon"):
            return False
        if self._text(1) not in ("one", "1") or self._tag(2) != "relation":
            return False
        before = self.i
        self.i += 2
        place = self._place()
        each = place is not None and isinstance(place.target, Noun) and place.target.each
        if place is None or not (each or place.each):
            self.i = before
            return False
        noun.count, noun.plural = 1.0, False
        out.append(replace(place, each=True))
        self.i += self._tag() in ("dash", "close")
        return True

    def _in_which(self, noun: Noun | None, out: list[Post]) -> bool:
        """Parse "on which are two eggs"."""
        if not (
            self._tag() == "relation" and self._tag(1) == "relative" and self._value() in SUPPORTING
        ):
            return False
        back = str(self._value())
        self.i += 2
        self._skip(fw.BE | fw.STARTERS)
        items = self._items(noun, "hold")
        self._skip(fw.BE | fw.PARTICIPLES)
        out.append(Carry("hold", tuple(items), back=back))
        return bool(items)

    def _one_each(self, noun: Noun | None) -> bool:
        """Parse "a dinner plate each" if the number of people is known."""
        ends = self._tag(1) in (*ENDS, "", "comma", "and")
        if noun is None or not self._seats or self._tag() != "each" or not ends:
            return False
        self.i += 1
        noun.seated = True
        return True

    def _distributes(self) -> bool:
        """Parse "each", "all" and "every one of them" before a distributive modifier."""
        each = self._tag() == "each" or self._text() in ("all", "both")
        if self._tag() == "each" and self._text(1) == "one" and self._tag(2) == "of":
            self.i += 3
        if self._tag() == "each" or (each and self._tag(1) in ("relation", "carry", "arranged")):
            self.i += 1
            self._skip(fw.BE)
        return each

    def _told(self, noun: Noun | None, out: list[Post]) -> bool:
        """Skip phrases that do not matter: "that is", "sorted by the robot", "like soldiers"."""
        if self._text() in fw.HANDLED and self._text(1) == "by" and self._starts_noun(2):
            self.i = read_noun(self.tokens, self.i + 2)[1]
            return True
        if self._text() == "to" and self._text(1) in fw.BE:
            self.i += 2  # "I would like the can to stand in front of it"
            return True
        if self._text() == "like" and self._starts_noun(1):
            self.i = read_noun(self.tokens, self.i + 1)[1]
            return True
        if self._tag() != "relative" and not (self._text() == "that" and noun is not None):
            return False
        self.i += 1
        self.i += self._text() in ("itself", "themselves")
        self._skip(fw.BE | fw.PARTICIPLES)
        has = self._text() in ("has", "have", "had")
        if has and (self._text(1) == "been" or is_verb(self._text(1))):
            self.i += 1 + (self._text(1) == "been")
        if self._tag() == "word" and is_verb(self._text()) and self._text() not in fw.BE:
            self.i += 1  # "that usually comes along", "that has gone out"
            along = self._text() in ("along", "out", "up", "off", "away", "down")
            self.i += along and not self._starts_noun(1)
        return True

    def _ordered_so(self, noun: Noun | None, out: list[Post]) -> bool:
        """Parse an order, an arrangement or a posture."""
        if order := self._order_by_ends():
            out.append(Arranged("row", order))
        elif self._tag() == "order":
            out.append(Arranged("row", str(self._take().value)))
        elif self._tag() == "posture":
            out.append(Description(({"posture": str(self._take().value)},)))
        else:
            return self._tag() == "arranged" and self._arranged(out)
        return True

    def _seated_so(self, noun: Noun | None, out: list[Post]) -> bool:
        """Parse "per person" and "for each guest"."""
        each = 1 if self._text() == "per" else 2 if self._text() == "for" else 0
        if noun is None or not each or self._text(each) not in fw.SEATED:
            return False
        if each == 2 and self._tag(1) != "each":
            return False
        self.i += each + 1
        noun.seated = True
        return True

    def _ellipsis(self, noun: Noun | None, out: list[Post]) -> bool:
        """Parse a verbless clause about one of several objects: "the third two doughnuts"."""
        told = noun is not None and noun.kind == "member" and (noun.ordinal or noun.other)
        if not told or out or not self._starts_noun(0, determined=True):
            return False
        out.append(Carry("hold", tuple(self._items(noun, "hold"))))
        return True

    def _is_participle(self) -> bool:
        """Return whether a participle that does not matter comes next: "parked in front"."""
        word = self._text()
        placed = self._tag(1) in ("relation", "here", "arranged") or (
            read_zone(self.tokens, self.i + 1) is not None
        )
        verbal = self._tag() == "word" and word.endswith(("ed", "ing", "en", "t")) and word != "but"
        return placed and verbal and is_verb(word) and not self._starts_category()

    def _goes_on(self) -> bool:
        """Return whether another modifier of the same object follows a comma or "and"."""
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

    def _described(self, out: list[Post]) -> bool:
        """Parse describing words that follow the noun: "a book open", "three mugs upside down"."""
        word = self._text()
        colored = word.endswith("ed") and is_verb(word) and self._text(1) in COLORS
        noun, end = read_noun(self.tokens, self.i + colored)  # "a towel dyed blue"
        if noun is None:
            return False
        measured = noun.kind == "member" and bool(noun.lengths) and not noun.words
        if not measured and (noun.kind != "adjective" or noun.determined):
            return False
        self.i = end
        out.append(Description((noun.attributes,), noun.lengths, noun.upright))
        return True
