"""A position in a list of tokens, with lookahead."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence

from ...vocabulary import TABLE_NOUNS
from ..phrases.nouns import read_noun
from ..phrases.tree import (
    Clause,
    How,
    Location,
    Noun,
    Post,
)
from ..text import function_words as fw
from ..text.tokens import Token

ENDS = ("stop", "line")
"""Tags of tokens that end a sentence."""

SUPPORTING = ("on", "in")
"""Relations to an object that supports another."""


class Cursor(ABC):
    """A position in tokens; base class of the parsers of places, modifiers, lists and clauses.

    The parsers are mutually recursive, since lists contain modifiers and modifiers contain lists.
    """

    def __init__(self, tokens: Sequence[Token]) -> None:
        self.tokens = list(tokens)
        self.i = 0
        self.skipped: list[Token] = []
        self.lost: list[str] = []  # phrases that were parsed but do not affect the plan
        self._heading: Location | None = None
        self._pending: list[Clause] = []  # clauses that were parsed together with the previous one
        self._task = ""  # verb of a robot's task in this sentence
        self._guests = 0  # number of people unless something else is stated
        self._ordered = False  # whether a list goes from left to right
        self._each_count = 0.0  # count that applies to each item of a list
        self._seats = False  # whether the number of people is known

    def _starts_noun(self, ahead: int, *, determined: bool = False) -> bool:
        if self._tag(ahead) not in ("word", "name", "number", "each"):
            return False
        noun, _ = read_noun(self.tokens, self.i + ahead)
        if noun is None:
            return False
        if noun.kind == "member" and noun.arrangement is not None:
            return True  # "a stack of four red ones"
        return noun.determined or noun.plural if determined else noun.kind != "member"

    def _starts_category(self) -> bool:
        """Return whether the next tokens name something in the catalogue."""
        noun, _ = read_noun(self.tokens, self.i)
        return noun is not None and noun.category is not None

    def _is_table(self, ahead: int) -> bool:
        noun, _ = read_noun(self.tokens, self.i + ahead)
        return noun is not None and bool(TABLE_NOUNS & {*noun.words})  # "the desk today"

    def _ended(self) -> bool:
        return self.i >= len(self.tokens) or self._tag() in ENDS

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
        return self._value_at(0)

    def _value_at(self, ahead: int) -> object:
        k = self.i + ahead
        return self.tokens[k].value if k < len(self.tokens) else None

    def _skip(self, words: frozenset[str] | set[str]) -> bool:
        """Skip words in a set unless they belong to a noun; return whether any were skipped."""
        before = self.i
        while self._tag() == "word" and self._text() in words:
            noun, _ = read_noun(self.tokens, self.i)
            verbal = self._text(1) in (*fw.INDEFINITE, *fw.DEFINITE, *fw.NUMBERS) or (
                self._tag(1) in ("relation", "posture", "number", "each", "arranged")
            )  # "behind them stand two cups"
            if (
                noun is not None
                and noun.category
                and self._text() in noun.head
                and not (verbal and self._text() in fw.BE)
            ):
                break
            self.i += 1
        return self.i > before

    def _connector(self) -> str:
        """Parse a comma, "and" or both; return "and", "comma" or "comma and"."""
        said = []
        while self._tag() in ("comma", "and", "close", "open"):
            said.append("and" if self._tag() == "and" else "comma")
            self.i += 1
        return "comma and" if len(set(said)) == 2 else said[0] if said else ""

    @abstractmethod
    def _items(self, owner: Noun | None, how: How) -> list[Noun]:
        """Parse a list of noun phrases, each with its modifiers."""

    @abstractmethod
    def _leads(self) -> bool:
        """Return whether a place comes before its objects here, as in "on the tray are ..."."""

    @abstractmethod
    def _people(self) -> int:
        """Parse "for four people"; return the number, or 0 if there is none."""

    @abstractmethod
    def _returns(self) -> str | None:
        """Return "on" or "in" if the rest of a list puts all of its items "on it" or "in it"."""

    @abstractmethod
    def _posts(self, noun: Noun | None, out: list[Post], *, nested: bool = False) -> None:
        """Parse all modifiers of a noun phrase."""

    @abstractmethod
    def _carried(self, noun: Noun | None, out: list[Post], each: bool) -> bool:
        """Parse the objects attached to an object."""

    @abstractmethod
    def _contents(self, noun: Noun, out: list[Post]) -> bool:
        """Parse the contents that follow "of"."""
