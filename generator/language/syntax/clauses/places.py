"""Places of objects: relations to noun phrases, and zones of the table."""

from __future__ import annotations

from ..phrases.nouns import read_noun
from ..phrases.tree import (
    Carry,
    Description,
    Location,
    Noun,
    Post,
    Zone,
)
from ..phrases.zones import read_zone
from ..text import function_words as fw
from .cursor import ENDS, SUPPORTING, Cursor

_SIDES = {(-1, None): "left_of", (1, None): "right_of", (None, -1): "in_front_of",
          (None, 1): "behind"}  # fmt: skip


_DEGREES = frozenset({"right", "just", "directly", "immediately", "slightly", "far", "close"})


_DIRECTED = frozenset({"left_of", "right_of", "in_front_of", "behind", "next_to", "under"})
"""Relations that a distance may precede."""

_BESIDE = 0.15  # maximum distance that counts as "next to", metres


class PlaceReader(Cursor):
    """Parses places of objects."""

    def _place(self, *, leading: bool = False) -> Location | None:
        """Parse a place, or return None if no place starts here."""
        before = self.i
        if (distance := self._distance()) is not None:
            return self._place_apart(distance, leading=leading)
        if far := self._far_from():
            return far
        if self._text() in _DEGREES and self._tag(1) in ("relation", "here"):
            self.i += 1  # "right next to it"
        found = read_zone(self.tokens, self.i)
        if found is not None:
            self.i = found.end
            if not found.of:
                table = None if found.table is None else read_noun(self.tokens, found.table[0])[0]
                kind = "aside" if found.aside else "beside" if found.loose else "at"
                return Location(kind, found.zone, table=table)
            self.i += 1
            target = self._target(nested=False)
            if target is not None:
                zone = found.zone
                kind = _SIDES.get((zone.x, zone.y))
                if kind is None or zone.edge:
                    kind = "center" if (zone.x, zone.y) == (0, 0) and not zone.edge else "edge"
                return Location(kind, target)
            self.i = before
        if owned := self._owned_side():
            return owned
        if self._tag() == "here":
            kind = str(self._take().value)
            return Location(kind, Noun("pronoun", ("it",), self.tokens[self.i - 1].span, "it"))
        if self._task and self._text() in ("from", "to") and self._tag() == "word":
            kind = "from" if self._text() == "from" else "aim"
            self.i += 1
            target = self._target(nested=True)
            if target is not None:
                return Location(kind, target)
            self.i = before
        around = self._text() == "round" and self._text(1) in (
            fw.DEFINITE | fw.INDEFINITE | fw.PRONOUNS
        )
        if self._tag() == "relation" or around:
            said = self._text()
            kind = str(self._take().value) if not around else "around"
            self.i += around
            if self._task and (said in ("into", "onto", "on to", "in to") or (
                self._task in (*fw.CARRYING, "robot") and not leading)):  # fmt: skip
                kind = "aim"
            ended = self._tag() in (*ENDS, "", "comma", "and", "close", "colon")
            if ended and kind in ("behind", "next_to"):  # "with a canvas behind"
                span = self.tokens[self.i - 1].span
                return Location(kind, Noun("pronoun", ("it",), span, "it"))
            target = self._target(nested=kind in SUPPORTING and not leading)
            if target is not None:
                parts = ("setting", "collective", "part")
                halves = target.kind in parts or target.words[-1:] in (("halves",), ("sides",))
                if kind == "between" and halves and (target.plural or target.count == 2):
                    return Location("at", Zone(0, 0))  # "between both halves"
                if kind == "between":
                    self._between(target)
                return Location(kind, target, target.each)
        self.i = before
        return None

    def _distance(self) -> tuple[int, float] | None:
        """Return where "5 cm" ends in "5 cm behind the banana", and the distance in metres."""
        noun, end = read_noun(self.tokens, self.i)
        if noun is None:
            return None
        words = tuple(word for word in noun.words if word not in fw.AWAY)
        unit = words[0] if len(words) == 1 else ""
        if unit in fw.MEASURES and (noun.count or noun.amount):  # "a few centimetres", "an inch"
            meters = (noun.count or float((noun.amount or (1, 1))[1])) * fw.MEASURES[unit]
        elif len(noun.lengths) == 1 and not words:
            meters = noun.lengths[0]
        else:
            return None
        while self.tokens[end - 1].text in fw.AWAY:
            end -= 1
        k = end - self.i
        away = self._text(k) in fw.AWAY
        if self._text(k - 1) not in fw.MEASURES:
            return None  # "a mug 10 cm tall next to a plate"
        k += away
        directed = self._tag(k) in ("relation", "here") and self._value_at(k) in _DIRECTED
        directed = directed and self._text(k) not in ("by", "along", "at")
        sided = self._text(k) == "to" and self._text(k + 1) in fw.DEFINITE  # not "4 cm to a side"
        led = sided or self._text(k) in ("from", "left", "right")
        return (self.i + k, meters) if directed or led or away else None

    def _read_size(self, out: list[Post]) -> None:
        """Parse "3 m long and 1 m wide" or "that is 3 m long" after a table."""
        k = self.i
        if self._text() in ("that", "which") and self._text(1) in fw.BE:
            k += 2
        lengths: list[float] = []
        while k < len(self.tokens):
            noun, end = read_noun(self.tokens, k)
            if noun is None or noun.words or not noun.lengths:
                break
            if noun.upright:
                out.append(Description(({},), noun.lengths, upright=True))
            else:
                lengths += noun.lengths
            self.i = end
            k = end + (self._tag() in ("and", "comma"))
        if lengths:
            out.append(Description(({},), tuple(lengths)))

    def _place_apart(self, distance: tuple[int, float], *, leading: bool) -> Location | None:
        """Parse a place after a distance; plans omit distances, but long ones exclude "next to"."""
        before, (self.i, meters) = self.i, distance
        said = " ".join(token.text for token in self.tokens[before : self.i])
        place = self._place(leading=leading)
        if place is None and self._text() == "from":
            self.i += 1
            target = self._target(nested=False)
            place = None if target is None else Location("next_to", target)
            if place is not None and meters > _BESIDE:
                place = Location("aim", place.target)
        if place is None:
            self.i = before
            return None
        self.lost.append(said)
        return place

    def _far_from(self) -> Location | None:
        """Parse "far from the candle" and "away from it", which have no equivalent in plans."""
        before = self.i
        k = 1 + (self._text() == "far" and self._text(1) == "away")
        if self._text() not in ("far", "away") or self._text(k) != "from":
            return None
        self.i += k + 1
        target = self._target(nested=False)
        if target is None:
            self.i = before
            return None
        said = " ".join(token.text for token in self.tokens[before : self.i])
        self.lost.append(said)
        return Location("aim", target)

    def _apart(self) -> bool:
        """Skip "10 cm apart"."""
        distance = self._distance()
        if distance is None:
            return False
        self.lost.append(" ".join(token.text for token in self.tokens[self.i : distance[0]]))
        self.i = distance[0]
        return True

    def _owned_side(self) -> Location | None:
        """Parse "to the bowl's right" and "along the tray's left side"."""
        if self._text() not in ("to", "on", "at", "along", "by"):
            return None
        first = self.i + 1
        owned = next(
            (k for k in range(first + 1, first + 6) if self._tag(k - self.i) == "possessive"), 0
        )
        side = fw.SIDES.get(self._text(owned + 1 - self.i), (None, None)) if owned else (None, None)
        kind = _SIDES.get(side)
        whose, end = read_noun(self.tokens[:owned], first) if kind else (None, 0)
        if kind is None or whose is None or end != owned or whose.kind == "table":
            return None
        end = owned + 2 + (self._text(owned + 2 - self.i) == "side")
        self.i = end
        return Location(kind, whose)

    def _target(self, *, nested: bool) -> Noun | None:
        """Parse a relation's target; if ``nested``, the modifiers that follow belong to it."""
        if self._text() in ("both", "all") and not self._starts_noun(1) and self._tag(1) != "word":
            token = self._take()
            return Noun("pronoun", ("them",), token.span, "them", plural=True, definite=True)
        self._skip(fw.PARTICIPLES & {"both", "all"})
        if self._text() in ("that", "this", "which") and (
            self._text(1) in fw.BE | fw.INDEFINITE or self._tag(1) in (*ENDS, "", "comma")
        ):
            token = self._take()
            return Noun("pronoun", ("that",), token.span, "that", definite=True)
        if self._text() in fw.PRONOUNS and not self._starts_longer():
            token = self._take()
            self.i += self._text() in ("all", "both")
            return Noun("pronoun", (token.text,), token.span, token.text,
                        plural=token.text in fw.PLURAL_PRONOUNS, definite=True)  # fmt: skip
        if each := self._each_of_them():
            return each
        noun, end = read_noun(self.tokens, self.i)
        if noun is None:
            return None
        if noun.kind == "member" and noun.definite and noun.count == 2 and not noun.words:
            self.i = end  # "between the two"
            self.i += 2 * (self._tag() == "of" and self._text(1) in fw.PRONOUNS)
            return Noun("pronoun", ("them",), noun.span, "them", plural=True, definite=True)
        self.i = end
        if noun.kind == "part" and self.tokens[end - 1 - len(noun.words)].text in ("its", "their"):
            return Noun("pronoun", ("it",), noun.span, "it", definite=True)  # "around its base"
        owned = [k for k in range(end - len(noun.words) - 2, end)
                 if k >= 0 and self.tokens[k].tag == "possessive"]  # fmt: skip
        if noun.kind == "part" and owned:  # "against the caddy's back"
            starts = [k for k in range(owned[0]) if self.tokens[k].text in fw.DEFINITE]
            whose, _ = read_noun(self.tokens[: owned[0]], max(starts, default=0))
            noun = whose or noun
        if noun.kind == "part" and self._tag() == "of":  # "the rim of the bowl"
            self.i += 1
            return self._target(nested=nested)
        if self._tag() == "of" and noun.kind != "part":
            self._contents(noun, noun.post)
        if noun.kind == "table":
            self._read_size(noun.post)
            return noun
        if nested:
            self._posts(noun, noun.post, nested=True)
        elif (
            self._tag() == "carry"
            and self._text() not in ("plus", "as well as", "along with")
            and not (noun.definite and self._brings_back())
        ):
            self._carried(noun, noun.post, False)
        return noun

    def _brings_back(self) -> bool:
        """Return whether "with tongs in it" comes next, where "it" is the topic of the sentence."""
        self.i += 1
        back = self._returns()
        self.i -= 1
        return back is not None

    def _each_of_them(self) -> Noun | None:
        """Parse "each", "each one", "every one of them" and "each of these"."""
        if self._tag() != "each":
            return None
        k = 1
        k += self._text(k) in ("one", "single")
        if self._tag(k) == "of" and self._text(k + 1) in fw.PRONOUNS:
            k += 2
        elif self._tag(k) == "of" or (
            self._tag(k) in ("word", "name", "number") and self._starts_noun(k)
        ):
            return None
        span = self.tokens[self.i].span
        self.i += k
        return Noun("pronoun", ("them",), span, "them", plural=True, definite=True, each=True)

    def _starts_longer(self) -> bool:
        """Return whether a pronoun begins a longer noun phrase: "these two cups", "one plate"."""
        return self._text() in ("these", "those", "one") and self._starts_noun(1)

    def _between(self, target: Noun) -> None:
        """Parse the second target of "between the plate and the cup"."""
        if target.plural or (target.count or 1) > 1 or self._tag() != "and":
            return
        before = self.i
        self.i += 1
        other, end = read_noun(self.tokens, self.i)
        if other is None:
            self.i = before
            return
        self.i = end
        other.joint = "and"
        target.post.append(Carry("with", (other,), back="between"))
