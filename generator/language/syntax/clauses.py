"""Tokens to clauses: lists of things, what follows each, what is said of all."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from ...catalogue import CATEGORIES
from ..relations import fits
from . import function_words as fw
from .nouns import read_noun
from .tokens import Token
from .tree import (
    VARIED,
    Arranged,
    Carry,
    Clause,
    Description,
    How,
    Lack,
    Location,
    Noun,
    Post,
    Sentence,
)
from .zones import read_zone

_ENDS = ("stop", "line")
_SUPPORTING = ("on", "in")
_SIDES = {(-1, None): "left_of", (1, None): "right_of", (None, -1): "in_front_of",
          (None, 1): "behind"}  # fmt: skip


class Parser:
    """Reads sentences by recursive descent; what it skips is kept in ``skipped``."""

    def __init__(self, tokens: Sequence[Token]) -> None:
        self.tokens = list(tokens)
        self.i = 0
        self.skipped: list[Token] = []
        self._heading: Location | None = None

    def sentences(self) -> list[Sentence]:
        """Return all sentences."""
        found = []
        while self.i < len(self.tokens):
            if self._tag() in _ENDS:
                self.i += 1
                continue
            found.append(self._sentence())
        return [sentence for sentence in found if sentence.clauses]

    # ------------------------------------------------------------------------------ sentences

    def _sentence(self) -> Sentence:
        clauses: list[Clause] = []
        while not self._ended():
            before = self.i
            clause = self._clause()
            if clause is not None:
                clauses.append(clause)
            while self._tag() in ("comma", "and", "dash", "close", "open", "colon"):
                self.i += 1
            if self.i == before:
                self.skipped.append(self.tokens[self.i])
                self.i += 1
        return Sentence(clauses)

    def _clause(self) -> Clause | None:
        arrangement = self._opening()
        people = self._people()
        lead = self._lead()
        if lead is None and people == 0:
            people = self._people()
        self._skip(fw.BE | fw.STARTERS)
        subjects = self._items(None, "with")
        if arrangement is not None and subjects:
            subjects[0].post.append(arrangement)
        predicate: list[Post] = []
        people = people or self._people()
        if people and not subjects and self._tag() in ("colon", "dash"):
            self.i += 1
            subjects = self._items(None, "with")
        if self._text() in fw.BE or self._tag() == "relative":
            self._skip(fw.BE | fw.PARTICIPLES | {"being"})
            self._posts(None, predicate)
            if not predicate and not self._ended() and self._tag() not in ("comma", "and"):
                predicate += self._complement()
        elif not subjects:
            self._posts(None, predicate)
        if self._tag() in ("colon", "dash") and lead is None:
            self._read_headed(subjects, predicate)
        if lead is None and self._heading is not None and subjects:
            lead = self._heading
        if not subjects and not predicate and lead is None and not people:
            return None
        return Clause(subjects, predicate, lead, people)

    def _read_headed(self, subjects: list[Noun], predicate: list[Post]) -> None:
        """Read "an office desk: a laptop, a mug": what follows belongs to the first."""
        if len(subjects) == 1 and not predicate and subjects[0].kind in ("table", "setting"):
            self.i += 1
            items = self._items(subjects[0], "with")
            if items:
                subjects[0].post.append(Carry("with", tuple(items)))

    def _complement(self) -> list[Post]:
        """Read "is a red one", "is red": describing words after a verb."""
        noun, end = read_noun(self.tokens, self.i)
        if noun is None or noun.kind != "adjective":
            return []
        self.i = end
        return [Description((noun.attributes,))]

    def _opening(self) -> Arranged | None:
        """Skip politeness and verbs at the start; return how a verb arranges what follows."""
        while not self._ended():
            word = self._text()
            two = f"{word} {self._text(1)}"
            if two in fw.ARRANGING_VERBS and self._starts_noun(2):
                self.i += 2
                return Arranged(fw.ARRANGING_VERBS[two])  # type: ignore[arg-type]
            if word in fw.ARRANGING_VERBS and self._starts_noun(1, determined=True):
                self.i += 1
                return Arranged(fw.ARRANGING_VERBS[word])  # type: ignore[arg-type]
            asks = word in fw.BE and self._text(1) in ("you", "we", "i", "someone", "anyone")
            opens = self._tag() == "word" and word in fw.STARTERS | fw.BE
            if (
                asks
                or (opens and self._is_opening())
                or (self._tag() in ("carry", "relative") and word != "with")
            ):
                self.i += 1
            else:
                return None
        return None

    def _is_opening(self) -> bool:
        """Tell whether a word opens the sentence and is no noun ("can", "set", "place")."""
        noun, end = read_noun(self.tokens, self.i)
        if noun is None or (noun.category is None and noun.kind == "thing"):
            return True
        if noun.kind == "collective" or noun.category is not None:
            return len(noun.words) > 0 and self._text() not in noun.head.split()[:1]
        return self._text(1) != "of" and end > self.i

    def _people(self) -> int:
        """Read "for four people", "for two"; return how many, 0 for none."""
        k = self.i
        while self._text(k - self.i) in ("set", "laid", "the", "table", "ready"):
            k += 1
        if self._text(k - self.i) != "for":
            return 0
        number = fw.NUMBERS.get(self._text(k + 1 - self.i))
        if number is None and self._tag(k + 1 - self.i) == "number":
            number = float(self.tokens[k + 1].value)
        if self._text(k + 1 - self.i) == "a" and self._text(k + 2 - self.i) in ("couple", "family"):
            number, k = (2.0 if self._text(k + 2 - self.i) == "couple" else 4.0), k + 1
        if number is None or not 1 <= number <= 24:
            return 0
        end = k + 2
        if self._text(end - self.i) in fw.PEOPLE_WORDS:
            end += 1
        elif self._starts_noun(end - self.i):
            return 0
        self.i = end
        return int(number)

    def _lead(self) -> Location | None:
        """Read a place before its things: "On the tray are ...", "to its left a book"."""
        before = self.i
        place = self._place(leading=True)
        if place is None:
            self.i = before
            return None
        heading = self._tag() in ("colon", "dash")
        if heading and self._tag(1) in _ENDS:
            self.i += 1
            self._heading = place
            return place
        spoken = self._text() in fw.BE | fw.STARTERS | fw.PARTICIPLES or self._tag() == "carry"
        comma = self._tag() == "comma"
        self.i += comma or heading
        skipped = self._skip(fw.BE | fw.STARTERS | fw.PARTICIPLES)
        if self._tag() == "carry":
            self.i += 1
        determined = not (spoken or skipped or heading)
        if self._starts_noun(0, determined=determined and not comma):
            return place
        self.i = before
        return None

    # ---------------------------------------------------------------------------------- lists

    def _items(self, owner: Noun | None, how: How) -> list[Noun]:
        """Read a list of noun phrases, each with what belongs to it."""
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
            if not more:
                self.i = before
                break
            more[0].joint = joint
            out += more
        for noun in out:  # "a red and a blue mug": the first borrows the noun
            if noun.kind == "adjective" and (noun.determined or noun.attributes):
                bare.append(noun)
            elif bare and noun.kind == "thing":
                for other in bare:
                    other.kind, other.head, other.category = "thing", noun.head, noun.category
                    other.count = other.count or 1.0
                bare = []
        return [noun for noun in out if noun not in bare or noun.post]

    def _entry(self) -> list[Noun]:
        """Read one noun phrase with its posts, or a part of the table with what is there."""
        headed = self._zone_heading()
        if headed:
            return headed
        noun, end = read_noun(self.tokens, self.i)
        if noun is None:
            return []
        self.i = end
        self._posts(noun, noun.post)
        return [noun]

    def _zone_heading(self) -> list[Noun]:
        """Read "left side decorated with plants and bottles"."""
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
        before = self.i
        found = bool(self._zone_heading())
        self.i = before
        return found

    def _connector(self) -> str:
        """Read a comma, "and" or both; return "and", "comma" or "comma and"."""
        said = []
        while self._tag() in ("comma", "and", "close", "open"):
            said.append("and" if self._tag() == "and" else "comma")
            self.i += 1
        return "comma and" if len(set(said)) == 2 else said[0] if said else ""

    def _leads(self) -> bool:
        """Tell whether a place before its things comes next."""
        before, heading = self.i, self._heading
        found = self._lead() is not None
        self.i, self._heading = before, heading
        return found

    def _closes(self, owner: Noun | None, how: How, items: list[Noun], joint: str) -> bool:
        """Tell whether the list of what ``owner`` brings along ends here."""
        if owner is None or owner.kind in ("table", "setting", "vague"):
            return False
        noun, end = read_noun(self.tokens, self.i)
        if noun is None:
            return True
        if end < len(self.tokens) and self.tokens[end].text in fw.BE:
            return True
        ended = any("and" in item.joint for item in items)
        if how == "of":
            return noun.determined or joint == "comma" or ended
        if self._returns() is not None:
            return False
        if ended:
            return True
        if how == "hold":
            return not _may_hold(owner, noun)
        if joint == "and":
            return False
        return not (_carries(owner) and _may_hold(owner, noun))

    def _returns(self) -> str | None:
        """Return "on" or "in" where the rest of a list puts all of it "on it" or "in it"."""
        k = 0
        while self._tag(k) not in (*_ENDS, "", "carry", "colon", "dash", "relative"):
            if self._text(k) in fw.BE:
                return None
            kind = self.tokens[self.i + k].value
            if self._tag(k) == "relation" and kind in _SUPPORTING:
                pronoun = self._text(k + 1) in fw.PRONOUNS and self._text(k + 1) != "one"
                return str(kind) if pronoun else None
            if self._tag(k) == "here" and kind in _SUPPORTING:
                return str(kind)
            if self._tag(k) in ("relation", "here"):
                return None
            k += 1
        return None

    # ---------------------------------------------------------------------------------- posts

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
        comma = self._tag() in ("comma", "open")
        joined = self._tag() == "and"
        if comma or joined:
            if (not out and joined) or not self._goes_on():
                return self._listed_attributes(noun, out) if comma else False
            self.i += 1
        each = self._tag() == "each" or self._text() in ("all", "both")
        if self._tag() == "each" or (each and self._tag(1) in ("relation", "carry", "arranged")):
            self.i += 1
            self._skip(fw.BE)
        self._skip(fw.PARTICIPLES - {"left", "right", "far"})
        if self._tag() == "relative" or (self._text() == "that" and noun is not None):
            self.i += 1
            self._skip(fw.BE | fw.PARTICIPLES)
            return True
        if self._tag() == "order":
            out.append(Arranged("row", str(self._take().value)))
            return True
        if self._tag() == "arranged":
            return self._arranged(out)
        if self._tag() == "no":
            return self._lacks(out)
        if self._tag() == "carry":
            return self._carried(noun, out, each)
        if self._text() == "for" and noun is not None:
            return self._purpose()
        if self._aspect(out):
            return True
        if self._tag() == "of" and noun is not None:
            return self._contents(noun, out)
        place = self._place()
        if place is not None:
            out.append(replace(place, each=place.each or (each and not comma) or each))
            return True
        if noun is not None and self._tag() == "word" and not comma:
            return self._described(out)
        return False

    def _goes_on(self) -> bool:
        """Tell whether more about the same thing follows a comma or "and"."""
        if self._tag(1) in ("each", "arranged", "order", "relative", "no"):
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
        if self._tag() == "order":
            order = str(self._take().value)
        out.append(Arranged(kind, order))
        return True

    def _lacks(self, out: list[Post]) -> bool:
        self.i += 1
        items = []
        while True:
            noun, end = read_noun(self.tokens, self.i)
            if noun is None:
                break
            self.i = end
            items.append(noun)
            if self._tag() in ("relation", "here") and self._value() in _SUPPORTING:
                step = 1 if self._tag() == "here" else 2
                if step == 1 or self._text(1) in fw.PRONOUNS:
                    self.i += step
            more = self._tag() in ("and", "comma") and self._tag(1) != "relation"
            following, _ = read_noun(self.tokens, self.i + 1) if more else (None, 0)
            if following is None or following.determined:
                break
            self.i += 1
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
        items = [inner]
        while self._tag() in ("and", "comma"):
            before = self.i
            joint = self._connector()
            more, end = read_noun(self.tokens, self.i)
            if more is None or more.determined or joint != "and" or self._is_clause(end):
                self.i = before
                break
            self.i = end
            items.append(more)
        out.append(Carry("of", tuple(items)))
        return True

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
        if noun is None or noun.kind != "adjective" or noun.determined:
            return False
        self.i = end
        out.append(Description((noun.attributes,)))
        return True

    def _listed_attributes(self, noun: Noun | None, out: list[Post]) -> bool:
        """Read ", small, medium and large" and ", one red and one blue" after several things."""
        if noun is None or not (noun.plural or (noun.count or 1) > 1):
            return False
        before, each = self.i, []
        while self._tag() in ("comma", "and", "open", "close"):
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

    # --------------------------------------------------------------------------------- places

    def _place(self, *, leading: bool = False) -> Location | None:
        """Read where something is; None where no place starts here."""
        before = self.i
        found = read_zone(self.tokens, self.i)
        if found is not None:
            self.i = found.end
            if not found.of:
                table = None if found.table is None else read_noun(self.tokens, found.table[0])[0]
                return Location("beside" if found.loose else "at", found.zone, table=table)
            self.i += 1
            target = self._target(nested=False)
            if target is not None:
                zone = found.zone
                kind = _SIDES.get((zone.x, zone.y))
                if kind is None or zone.edge:
                    kind = "center" if (zone.x, zone.y) == (0, 0) and not zone.edge else "edge"
                return Location(kind, target)
            self.i = before
        if self._tag() == "here":
            kind = str(self._take().value)
            return Location(kind, Noun("pronoun", ("it",), self.tokens[self.i - 1].span, "it"))
        if self._tag() == "relation":
            kind = str(self._take().value)
            target = self._target(nested=kind in _SUPPORTING and not leading)
            if target is not None:
                if kind == "between":
                    self._between(target)
                return Location(kind, target, target.each)
        self.i = before
        return None

    def _target(self, *, nested: bool) -> Noun | None:
        """Read what a relation goes to; ``nested``: what follows is said of that."""
        self._skip(fw.PARTICIPLES & {"both", "all"})
        if self._text() in fw.PRONOUNS and not self._starts_longer():
            token = self._take()
            return Noun("pronoun", (token.text,), token.span, token.text,
                        plural=token.text in fw.PLURAL_PRONOUNS, definite=True)  # fmt: skip
        noun, end = read_noun(self.tokens, self.i)
        if noun is None:
            return None
        self.i = end
        if self._tag() == "of" and noun.kind != "part":
            self._contents(noun, noun.post)
        if noun.kind == "table":
            return noun
        if nested:
            self._posts(noun, noun.post, nested=True)
        elif self._tag() == "carry" and self._text() not in ("plus", "as well as", "along with"):
            self._carried(noun, noun.post, False)
        return noun

    def _starts_longer(self) -> bool:
        """Tell whether a pronoun's word opens a noun phrase: "these two cups", "one plate"."""
        return self._text() in ("these", "those", "one") and self._starts_noun(1)

    def _between(self, target: Noun) -> None:
        """Read the second of "between the plate and the cup"."""
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

    # --------------------------------------------------------------------------------- tokens

    def _starts_noun(self, ahead: int, *, determined: bool = False) -> bool:
        if self._tag(ahead) not in ("word", "name", "number", "each"):
            return False
        noun, _ = read_noun(self.tokens, self.i + ahead)
        if noun is None:
            return False
        return noun.determined or noun.plural if determined else noun.kind != "member"

    def _ended(self) -> bool:
        return self.i >= len(self.tokens) or self._tag() in _ENDS

    def _take(self) -> Token:
        self.i += 1
        return self.tokens[self.i - 1]

    def _tag(self, ahead: int = 0) -> str:
        k = self.i + ahead
        return self.tokens[k].tag if k < len(self.tokens) else ""

    def _text(self, ahead: int = 0) -> str:
        k = self.i + ahead
        return self.tokens[k].text if k < len(self.tokens) else ""

    def _value(self) -> object:
        return self.tokens[self.i].value if self.i < len(self.tokens) else None

    def _skip(self, words: frozenset[str] | set[str]) -> bool:
        """Skip words of a set that are no noun's; return whether there were any."""
        before = self.i
        while self._tag() == "word" and self._text() in words:
            noun, _ = read_noun(self.tokens, self.i)
            if noun is not None and noun.category is not None and self._text() in noun.head:
                break
            self.i += 1
        return self.i > before


def _may_hold(owner: Noun, item: Noun) -> bool:
    """Tell whether an item may be in or on its owner by the sizes of their kinds."""
    if owner.category is None:
        return True
    outer = CATEGORIES[owner.category]
    if item.category is None:
        return outer.container or "support" in outer.roles
    inner = CATEGORIES[item.category].size
    return fits("in", inner, outer.size, outer.container) or (
        ("support" in outer.roles or "flat" in outer.roles)
        and fits("on", inner, outer.size, outer.container)
        and min(inner[:2]) < 0.8 * min(outer.size[:2])
    )


def _carries(owner: Noun) -> bool:
    """Tell whether a thing is there to carry others: a tray, a basket, a board."""
    if owner.category is None or owner.head.split()[-1:] == ["plate"]:
        return False
    outer = CATEGORIES[owner.category]
    return "support" in outer.roles or (outer.container and min(outer.size[:2]) > 0.18)
