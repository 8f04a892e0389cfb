"""Openings of clauses, numbers of people, and predicates."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise

from ...lexicon import singular
from ...vocabulary import COLORS
from ...words.dictionary import is_verb
from ..phrases.nouns import read_noun
from ..phrases.tree import EVERYONE, Arranged, Clause, Description, Noun, Post, Zone
from ..phrases.zones import read_zone
from ..text import function_words as fw
from .cursor import ENDS
from .lists import ListReader


class OpeningReader(ListReader):
    """Parses openings, numbers of people, and verbs."""

    def _opening(self) -> Arranged | None:
        """Skip polite words and verbs at the start; return the arrangement that a verb implies."""
        while not self._ended():
            if self._tag() == "task":
                self._task = "robot"
                self.i += 1
                continue
            word = self._text()
            if word == "to" and read_zone(self.tokens, self.i) is not None:
                return None  # "to the left, a book"
            two = f"{word} {self._text(1)}"
            if two in fw.ARRANGING_VERBS and self._starts_noun(2):
                self.i += 2
                return Arranged(fw.ARRANGING_VERBS[two])  # type: ignore[arg-type]
            if word in fw.ARRANGING_VERBS and self._starts_noun(1, determined=True):
                self.i += 1
                return Arranged(fw.ARRANGING_VERBS[word])  # type: ignore[arg-type]
            asks = word in fw.BE and self._text(1) in ("you", "we", "i", "someone", "anyone")
            opens = self._tag() == "word" and word in fw.STARTERS | fw.BE
            moved = word in fw.MOVING and (
                self._text(1) in ("up", "down", *fw.DEFINITE)
                or self._starts_noun(1, determined=True)
            )
            if moved:
                ahead = [self._text(k) for k in range(1, 14)]
                later = any(a in ("put", "place") and b in fw.PRONOUNS for a, b in pairwise(ahead))
                told = word in fw.TASKS or (
                    word in ("take", "bring") and (later or "from" in ahead)
                )
                self._task = word if told else self._task
                self.i += 1 + (self._text(1) in ("up", "down", "for"))
                continue
            if (
                asks
                or (opens and self._is_opening())
                or (self._tag() in ("carry", "relative") and (word != "with" or self.i == 0))
            ):
                self.i += 1
            else:
                return None
        return None

    def _heading_line(self) -> Zone | None:
        """Parse a line that names a zone of the table: "BACK ROW", "Left side"."""
        opens = self.i == 0 or self._tag(-1) in ENDS
        found = read_zone(self.tokens, self.i, heading=True) if opens else None
        if found is None or found.of:
            return None
        ahead = found.end - self.i
        if self._tag(ahead) != "line" and not (
            self._tag(ahead) == "colon" and self._tag(ahead + 1) == "line"
        ):
            return None
        self.i = found.end + 1
        return found.zone

    def _listing(self) -> Arranged | None:
        """Parse "from left to right:" before a list, and "stacked on the left are ..."."""
        if self._tag() != "arranged":
            return None
        if "left to right" not in self._text():
            found = read_zone(self.tokens, self.i + 1)
            if found is None or self._text(found.end - self.i) not in fw.BE:
                return None
            return Arranged(self._take().value)  # type: ignore[arg-type]
        k = 1
        while self._tag(k) in ("colon", "comma", "dash", "order"):
            k += 1  # "from left to right by size, smallest first: ..."
        k += self._text(k) in fw.BE
        if not self._starts_noun(k):
            return None
        self.i += k
        return Arranged("row", "listed")

    def _is_opening(self) -> bool:
        """Return whether a word opens the sentence and is not a noun ("can", "set", "place")."""
        noun, end = read_noun(self.tokens, self.i)
        if noun is None or (noun.category is None and noun.kind == "thing"):
            return True
        if noun.kind == "collective" or noun.category is not None:
            return len(noun.words) > 0 and self._text() not in noun.head.split()[:1]
        return self._text(1) != "of" and end > self.i

    def _everyone(self) -> int:
        """Parse "everyone gets", "each guest has", "for each person" and "at every place"."""
        k = int(self._text() in ("for", "at", "in"))
        if self._text(k) in ("everyone", "everybody"):
            k += 1
        elif self._seats and self._text() in fw.AT_SEATS:
            k = 1
        elif self._tag(k) == "each" and self._text(k + 1) in fw.SEATED:
            k += 2
        elif self._seats and self._tag(k) == "each" and self._text(k + 1) in fw.GETS:
            k += 1
        elif self._seats and self._tag(k) == "each" and self._tag(k + 1) == "of":
            k += 2 + (self._text(k + 2) in fw.PRONOUNS | {"us", "you"})
        else:
            return 0
        verbs = 0
        while self._text(k) in fw.GETS or self._tag(k) == "carry":
            k, verbs = k + 1, verbs + 1
        marked = self._tag(k) in ("comma", "colon", "dash")
        led = self._text() in ("for", "at", "in") or self._text() in fw.AT_SEATS
        if not (marked or (self._starts_noun(k) and (verbs or led))):
            return 0
        self.i += k + marked
        return self._guests or EVERYONE

    def _people(self) -> int:
        """Parse "for four people" or "for two"; return the number, or 0 if there is none."""
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
        if number is not None and number > 24 and self._text(k + 2 - self.i) in fw.PEOPLE_WORDS:
            self.lost.append(" ".join(token.text for token in self.tokens[k : k + 3]))
        if number is None or not 1 <= number <= 24:
            return 0
        self._seats = True
        end = k + 2
        if self._text(end - self.i) in fw.PEOPLE_WORDS:
            end += 1
        elif self._starts_noun(end - self.i):
            return 0
        self.i = end
        return int(number)

    def _seats_named(self, subjects: list[Noun]) -> int:
        """Return the number of seats in "two places side by side: ...", or 0 for other phrases."""
        count = int(subjects[0].count or 0)
        if not is_seat(subjects[0]) or not 1 < count <= 24 or not self._starts_noun(1):
            return 0
        self._seats = True
        return count

    def _is_fragment(self, noun: Noun) -> bool:
        """Return whether a phrase on its own requests nothing: "Tonight's buffet.", "Hiya"."""
        if noun.kind != "thing" or noun.category is not None or noun.post or noun.plural:
            return False
        counted = noun.count is not None or noun.amount is not None or noun.each
        return not counted and self._tag() in (*ENDS, "colon", "dash", "comma", "")

    def _is_left_out(self) -> bool:
        """Parse "should be left out", "stays in the attic" and "are not wanted"."""
        k = 2 if self._text() in ("has", "have") and self._text(1) == "to" else 0
        while (self._text(k), self._text(k + 1)) not in fw.LEFT_OUT and (
            self._text(k) in fw.BE or self._text(k) in ("that", "usually", "not", "always")
        ):
            k += 1
        if (k or self._tag() == "no") and (self._text(k), self._text(k + 1)) in fw.LEFT_OUT:
            self.i += k + 2
            return True
        if k and self._text(k) in ("gone", "absent", "missing"):
            self.i += k + 1
            return True
        if k and self._text(k - 1) == "not" and self._text(k) == "on" and self._is_table(k + 1):
            self.i = read_noun(self.tokens, self.i + k + 1)[1]  # "is not on the desk today"
            return True
        away = self._text() in ("stays", "stay", "remains", "remain", "stayed")
        elsewhere = self._text(1) in ("in", "at") and self._text(2) in fw.DEFINITE
        if away and elsewhere and self._text(3) in fw.ELSEWHERE:
            self.i += 4
            return True
        return False

    def _is_predicate(self, subjects: list[Noun]) -> bool:
        """Return whether the next verb only locates its subject, like "sleeps" or "comes"."""
        if not subjects or self._tag() != "word" or self._text() in fw.BE:
            return False
        if self._text().endswith("s") and self._text(1) in ("it", "them"):
            return True  # "guards it from the left"
        return is_verb(self._text()) and not self._starts_category()

    def _pronoun_clause(self) -> Clause | None:
        """Parse "It is red.", "They stand on a book." and "It contains three apples."."""
        whole = self._text() in ("all", "both") and self._tag(1) == "of"
        k = 2 * whole  # "all of them are red"
        verbal = self._text(k + 1) in fw.BE or self._tag(k + 1) == "carry"
        known = fw.PLURAL_PRONOUNS if whole else fw.SUBJECT_PRONOUNS
        if self._text(k) not in known or not verbal:
            return None
        before, said = self.i, self._text(k)
        self.i += k
        noun = Noun("pronoun", (said,), self.tokens[self.i].span, said, definite=True,
                    plural=said in fw.PLURAL_PRONOUNS)  # fmt: skip
        self.i += 1
        if self._tag() != "carry":
            self.i += 1
            self._skip(fw.BE | fw.PARTICIPLES | {"being"})
        predicate: list[Post] = []
        self._posts(None, predicate)
        if not predicate and not self._ended():
            predicate += self._complement()
            self._posts(None, predicate)
        if not predicate:
            self.i = before
            return None
        return Clause([noun], predicate)

    def _complement(self) -> list[Post]:
        """Parse "is a red one" or "is red and shiny", that is, describing words after a verb."""
        each: list[Mapping[str, str]] = []
        while True:
            k = self.i
            if each:
                while k < len(self.tokens) and self.tokens[k].tag in ("comma", "and"):
                    k += 1
                if k == self.i:
                    break
            noun, end = read_noun(self.tokens, k)
            color = self.tokens[k].text if k < len(self.tokens) else ""
            if noun is not None and noun.lengths and not (noun.words or each):
                self.i = end  # "the table is 1.8 m long"
                return [Description(({},), noun.lengths, noun.upright)]
            if color in COLORS and end == k + 1:
                each.append({"color": color})  # "the top cube is orange"
            elif noun is None or noun.kind != "adjective" or (each and noun.determined):
                break
            else:
                each += noun.variants or (noun.attributes,)
            self.i = end
        return [Description(describe_each(each))] if each else []


def describe_each(said: Sequence[Mapping[str, str]]) -> tuple[Mapping[str, str], ...]:
    """Return "red and blue" as one attribute per object, but "red and shiny" as shared by all."""
    if len(said) > 1 and all(words and words.keys() == said[0].keys() for words in said):
        return tuple(said)
    merged: dict[str, str] = {}
    for words in said:
        merged = {**words, **merged}
    return (merged,)


def is_seat(noun: Noun) -> bool:
    """Return whether a phrase means the places at a table: "places", "settings"."""
    return noun.kind in ("setting", "collective") and bool(
        {singular(word) for word in noun.words[-1:]} & fw.SEATED
    )


def people_of(noun: Noun) -> int:
    """Return the number of people in "five guests", or 0 for other phrases."""
    people = noun.kind == "setting" and noun.words[-1] in fw.PEOPLE_WORDS
    return int(noun.count) if people and noun.count and 1 < noun.count <= 24 else 0
