"""Chunks of English to a draft of the scene: which objects, which table, what relates to what."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ...errors import InputError
from ...scene import TABLE
from ..drafts import Draft, Group, Reading, assumed_relation, phrase_text, same, shares
from .clauses import closes, is_fronted, returns
from .grammar import Chunk, NounPhrase
from .linking import amount, find_by_head, link, packed, stack
from .vocabulary import SEVERAL, SUBSTANCES

_SIDES = ("left_of", "right_of", "in_front_of", "behind")


class Reader:
    """Reads chunks from left to right and keeps what pronouns and conjunctions refer to."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.reading = Reading()
        self._rng = rng
        self._mentioned: Group | str | None = None  # the last thing named
        self._topic: Group | None = None  # the first subject of this sentence
        self._earlier: Group | None = None  # the first subject of the one before
        self._begin()

    def read(self, chunks: Sequence[Chunk]) -> Reading:
        """Read all chunks.

        Raises:
            InputError: impossible counts, a second table, the table on an object.
        """
        for i, chunk in enumerate(chunks):
            following = chunks[i + 1] if i + 1 < len(chunks) else None
            if chunk.kind == "stop":
                self._end_relation()
                self._begin()
            elif chunk.kind == "noun" and chunk.noun is not None:
                self._noun(chunk.noun, following)
            elif chunk.kind == "relation":
                self._relation(chunk.text, fronted=is_fronted(chunks, i))
            elif chunk.kind == "carry":
                self._carry(chunk.text)
            elif chunk.kind in ("and", "comma"):
                rest = chunks[i + 1 :]
                inner = self._carried == "hold" and closes(rest)
                self._conjunction(chunk.kind, inner or returns(rest))
            elif chunk.kind == "are":
                self._each = self._each or chunk.text == "each"
                self._joined = chunk.text != "is" or len(self._group) < 2
            elif chunk.kind == "of" and self._last is not None:
                self._of = self._last
        self._end_relation()
        return self.reading

    def _begin(self) -> None:
        """Start a sentence; what the last one was about stays known to pronouns."""
        self._earlier = self._topic or self._earlier
        self._it: Group | str | None = None
        self._topic = None
        self._finished: list[Group] = []  # subjects before the last "and", done with
        self._moved: list[Group] = []  # what the last relation was said of
        self._related = False  # the current subjects have got a relation
        self._subject_is_table = False
        self._named: list[Group] = []  # every group named in this sentence
        self._group: list[Group] = []  # coordinated subjects, each some equal objects
        self._pending: str | None = None  # a relation without its target so far
        self._lead: tuple[str, list[Draft | str]] | None = None  # one told before its subject
        self._between: list[Draft | str] = []
        self._owner: Group | str | None = None  # what the current group was brought along by
        self._carried: str | None = None
        self._joined = False
        self._each = False
        self._comma = False
        self._commas = False  # whether commas part the current subjects
        self._listing = False
        self._of: NounPhrase | None = None
        self._last: NounPhrase | None = None
        self._bare: NounPhrase | None = None

    # -------------------------------------------------------------------------- connectors

    def _relation(self, text: str, *, fronted: bool) -> None:
        self._end_relation()
        self._last = None
        if fronted:
            self._group, self._owner, self._carried = [], None, None
        text, *more = text.split("&")
        if (
            self._listing and not self._group and not fronted
        ):  # "left of the cup and behind the pen"
            self._group, self._listing = self._finished, False
        kind, _, target = text.partition(" ")
        if kind == "stacked":
            several = self._group[-1:] if self._group and len(self._group[-1]) > 1 else self._group
            stack([d for group in several for d in group])
        elif target == "table":
            beside = self._owner if kind in _SIDES and self._group else None
            self._attach(kind, self._one(beside) or [TABLE])
            for other in more:
                for group in self._moved:
                    link(other.split()[0], group, [TABLE], self.reading.warnings)
        elif target == "it":
            self._attach(kind, self._one(self._antecedent(kind)))
        elif target == "each":  # on either side
            self._flank()
        else:
            self._pending = kind

    def _carry(self, text: str) -> None:
        self._end_relation()
        self._owner = self._mentioned
        self._carried = text
        self._group = [] if text != "without" else self._group
        self._last = None
        self._joined = self._comma = self._commas = False

    def _conjunction(self, kind: str, returns: bool) -> None:
        """Continue a list; ``returns``: its last words come back to the owner ("on it")."""
        if self._pending == "between" and self._between:
            return
        self._end_relation()
        self._listing = True
        self._last = None
        self._comma = kind == "comma" or self._comma
        if self._related:
            self._finished, self._group, self._related = self._group, [], False
        ends = self._carried == "of" or (kind == "comma" and not returns)
        if ends and self._owner not in (None, TABLE) and self._carried != "without":
            self._owner, self._carried, self._group = None, None, []

    def _end_relation(self) -> None:
        """Give a relation whose target never came the thing it can only mean."""
        kind, self._pending = self._pending, None
        if self._between:
            self._attach("next_to", self._between)
            self._between = []
        elif kind in ("on", "in", "next_to", "under"):
            target = self._owner if self._owner is not None else None
            if isinstance(target, list):
                self._attach(kind, self._one(target))

    # ------------------------------------------------------------------------------- nouns

    def _noun(self, noun: NounPhrase, following: Chunk | None) -> None:
        of, self._of = self._of, None
        if of is not None:
            noun = self._merge(of, noun)
        joining = following is not None and following.kind == "of"
        if joining and noun.kind in ("group", "amount", "place", "part", "vague", "unknown"):
            self._last = noun
            return
        if self._carried == "without":
            self.reading.excluded |= {str(n) for n in {noun.category, *noun.members} - {None}}
            return
        if self._special(noun, following):
            return
        if self._fills(noun):
            return
        group = self._refer(noun) or self._introduce(noun)
        if not group:
            return
        if self._each and self._pending is not None and len(group) > 1:
            self._one_each(group)
        self._last = noun if joining else None
        if self._pending is not None:
            self._target(list(group))
        else:
            self._subject(group)
        self._mentioned = group
        self._named.append(group)

    def _fills(self, noun: NounPhrase) -> bool:
        """Tell whether "with tea" only says what a vessel holds, and note it if so."""
        owner = self._owner
        if self._carried is None or not isinstance(owner, list) or self._pending is not None:
            return False
        if noun.determined or noun.plural or noun.noun not in SUBSTANCES:
            return False
        if any(not draft.category for draft in owner) or noun.category:
            return False
        for draft in owner:
            draft.attributes.setdefault("state", f"with {noun.noun}")
        self._group, self._owner, self._carried = [owner], None, None
        return True

    def _merge(self, of: NounPhrase, noun: NounPhrase) -> NounPhrase:
        """Read "a stack of three books", "a dozen of eggs", "a bowl of apples", "a cup of tea"."""
        if of.kind == "object":
            if noun.noun in SUBSTANCES or " ".join(noun.words) in SUBSTANCES:
                for draft in self._group[-1] if self._group else []:
                    draft.attributes.setdefault("state", f"with {noun.noun or noun.words[-1]}")
                return NounPhrase("place", noun.words)
            if packed(of, noun, self._group[-1] if self._group else []):
                return NounPhrase("place", noun.words)
            self._carry("of")
            return noun
        if of.kind == "unknown" and noun.noun in SUBSTANCES:
            return replace(of, attributes={**of.attributes, "state": f"with {noun.noun}"})
        if of.kind in ("group", "amount", "vague"):
            return amount(of, noun)
        return noun

    def _special(self, noun: NounPhrase, following: Chunk | None) -> bool:
        """Deal with nouns that are no objects; tell whether this was one."""
        if noun.kind == "table":
            self._table(noun)
        elif noun.kind == "pronoun":
            target = self._antecedent(self._pending, several=noun.words[0] in SEVERAL)
            if self._pending is not None:
                self._target(TABLE if target is None else target)
            elif isinstance(target, list):
                self._group = [target]
        elif noun.kind in ("part", "adjective", "amount"):
            self._describe(noun, following)
        elif noun.kind == "vague":
            self.reading.vague = True
            self._pending = None
        elif noun.kind in ("place", "group"):
            self._pending = None
        else:
            return False
        return True

    def _describe(self, noun: NounPhrase, following: Chunk | None) -> None:
        """Give describing words to what they describe ("the mug is red", "with metal legs")."""
        if self._pending is not None and noun.kind == "part":
            self._pending = None
        elif noun.kind == "part":
            if self._owner == TABLE or (not self._group and self._mentioned == TABLE):
                self.reading.table_parts.append(noun)
        elif noun.kind == "adjective" and following is not None and following.kind == "and":
            self._bare = noun if noun.determined else None
        elif noun.kind == "adjective" and self._joined:
            if self._mentioned == TABLE:
                self.reading.table.append(noun)
            elif isinstance(self._mentioned, list):
                for draft in self._mentioned:
                    draft.attributes.update(noun.attributes)

    def _table(self, noun: NounPhrase) -> None:
        if (noun.count or 1) > 1 or noun.vague or noun.plural:
            raise InputError(
                f"A scene has exactly one table, the text asks for several "
                f"({phrase_text(noun)!r}). Describe one table."
            )
        pending = self._pending
        self.reading.table.append(noun)
        if pending is not None:
            self._target(TABLE)
        elif self._lead is not None and self._lead[0] in ("on", "in"):
            raise InputError(
                "The text puts the table on an object; objects stand on the table. Turn it round, "
                "for example 'a mug on the table'."
            )
        else:
            self._group, self._lead, self._owner = [], None, None
        self._mentioned = TABLE
        self._subject_is_table = pending is None

    # ---------------------------------------------------------------------------- relating

    def _subject(self, group: Group) -> None:
        if self._carried is not None and self._owner is not None:
            self._assume(group)
        elif self._lead is not None:
            kind, targets = self._lead
            link(kind, group, targets, self.reading.warnings)
        if self._topic is None:
            self._topic = group
        if not self._listing and self._group and not self._joined:
            self._group = []
        self._commas = self._listing and bool(self._group) and (self._commas or self._comma)
        self._group = [*self._group, group] if self._listing else [group]
        self._listing = self._comma = self._joined = False

    def _assume(self, group: Group) -> None:
        """Put what "with" or "containing" brings along where it fits, until the text says more."""
        owners = self._owner
        if not isinstance(owners, list):
            return
        for i, draft in enumerate(group):
            if draft.relations:
                continue
            owner = owners[i % len(owners)]
            kind = assumed_relation(draft, owner, held=self._carried != "with")
            draft.relations.append((kind, owner))
            draft.provisional = True

    def _target(self, target: Group | str) -> None:
        kind, self._pending = str(self._pending), None
        targets: list[Draft | str] = [TABLE] if isinstance(target, str) else list(target)
        if kind == "between" and len(targets) == 1 and not self._between:
            self._pending, self._between = "between", targets
            self._mentioned = target
            return
        if kind == "between":
            targets = [*self._between, *targets]
            kind, self._between = "next_to", []
        self._attach(kind, targets)

    def _attach(self, kind: str, targets: Sequence[Draft | str]) -> None:
        """Relate the current subjects to ``targets``; without one, keep it for the next."""
        if kind == "between":
            kind = "next_to"
        if not targets:
            return
        if not self._group:
            if self._mentioned == TABLE and TABLE not in targets and self._subject_is_table:
                if kind in ("on", "in"):
                    raise InputError(
                        "The text puts the table on an object; objects stand on the table. Turn "
                        "it round, for example 'a mug on the table'."
                    )
                return
            self._lead, self._moved = (kind, list(targets)), []
            return
        back = isinstance(self._owner, list) and targets == self._owner
        if not back and self._held():  # "a bowl with two eggs behind the pot"
            self._group = [list(self._owner)] if isinstance(self._owner, list) else self._group
        held = kind in ("on", "in") and back
        subjects = self._group if self._joined or held or not self._commas else self._group[-1:]
        if len(subjects) > 1:  # "a book and a cup on the book"
            subjects = [g for g in subjects if not any(t in g for t in targets)] or subjects
        self._moved = [
            group for group in subjects
            if self._joined or held or group is self._group[-1] or shares(kind, group, targets)
        ]  # fmt: skip
        for group in self._moved:
            link(kind, group, targets, self.reading.warnings)
        self._owner, self._carried, self._related = None, None, True
        support = [target for target in targets if isinstance(target, Draft)]
        if kind in ("on", "in", "center") and support:
            self._group = [support]

    def _held(self) -> bool:
        """Tell whether the current subjects are on or in their owner, so that it is what moves."""
        owner = self._owner
        drafts = self._group[-1] if self._group else []
        return (
            isinstance(owner, list)
            and len(self._group) == 1
            and all(
                d.provisional and any(k in ("on", "in") and to in owner for k, to in d.relations)
                for d in drafts
            )
        )

    def _flank(self) -> None:
        """Note that what comes next has the current subject on its left and on its right."""
        if self._group and len(self._group[-1]) == 1:
            one = self._group[-1][0]
            self._group[-1].append(self.reading.add(one.noun, one.category, one.attributes))
        self._pending = "flank"

    def _antecedent(self, kind: str | None, *, several: bool = False) -> Group | str | None:
        """Return what "it" or "them" means, and remember it for the rest of the sentence.

        ``kind`` is the relation to it: nothing is beside the table that it is on.
        """
        self._it = self._guess_it(kind in (None, "on", "in", "center", "edge"))
        subjects = self._group[-1:]
        if isinstance(self._it, list) and (len(self._it) > 1) != several:
            before = [g for g in self._named if g not in subjects and (len(g) > 1) == several]
            self._it = before[-1] if before else self._it
        return self._it

    def _guess_it(self, table: bool) -> Group | str | None:
        """Guess "it": the owner of the current group, what "it" meant, else the thing before."""
        if self._owner is not None and self._group and (table or self._owner != TABLE):
            return self._owner
        if self._topic is not None and self._it is not None and self._it not in self._group:
            return self._it
        if not self._group and self._topic is None and self._earlier:
            return self._earlier
        subjects = self._group if self._joined else self._group[-1:]
        if self._topic is not None and self._topic not in subjects:
            return self._topic
        earlier = [d for d in self.reading.objects if all(d not in g for g in subjects)]
        if isinstance(self._mentioned, list) and self._mentioned not in subjects:
            return self._mentioned
        return [earlier[-1]] if earlier else self._mentioned

    @staticmethod
    def _one(target: Group | str | None) -> list[Draft | str]:
        if target is None:
            return []
        return [target] if isinstance(target, str) else list(target)

    # -------------------------------------------------------------------------- new objects

    def _refer(self, noun: NounPhrase) -> Group | None:
        """Return the objects that "the red mug" means, if they were mentioned."""
        if noun.kind not in ("object", "unknown"):
            return None
        alike = [d for d in self.reading.objects if same(d, noun)]
        if self._each and self._pending is not None and len(alike) > 1:
            return alike
        if not (noun.definite or noun.other):
            return None
        alike = alike or find_by_head(self.reading.objects, noun)
        if noun.other and len(alike) > 1:
            return [alike[1]]
        if noun.plural and (noun.count or 2) > 1:
            return alike or None
        return alike[:1] or None

    def _one_each(self, owners: Group) -> None:
        """Multiply the current subject so that each owner gets its own ("on each plate")."""
        if self._group:
            group = self._group[-1]
            for _ in range(len(owners) - len(group)):
                one = group[0]
                group.append(self.reading.add(one.noun, one.category, one.attributes))
        self._each = False

    def _introduce(self, noun: NounPhrase) -> Group:
        if self._bare is not None:
            bare, self._bare = replace(noun, attributes=self._bare.attributes, count=1.0), None
            self._group = [*self._group, self._introduce(bare)]
            noun = replace(noun, count=noun.count or 1.0)
            self._listing = True
        if noun.kind == "mixed":
            self.reading.vague = True
            members = [m for m in noun.members if m not in self.reading.excluded]
            return [
                self.reading.add(category.replace("_", " "), category, noun.attributes)
                for category in members
            ]
        introduced = noun.determined or noun.plural or noun.category is not None
        if noun.kind == "unknown" and not (introduced or self._listing or self._carried):
            self.reading.warnings.append(f"Not understood and left out: {' '.join(noun.words)!r}.")
            return []
        claimed = [d for d in self.reading.objects if d.implied and same(d, noun)]
        if claimed and not noun.definite and (noun.count or 1) == 1 and not noun.plural:
            claimed[0].implied = False
            claimed[0].attributes.update(noun.attributes)
            return claimed[:1]
        owners = len(self._owner) if self._each and isinstance(self._owner, list) else 1
        group = [
            self.reading.add(
                noun.noun, noun.category, noun.attributes,
                lengths=noun.lengths, implied=noun.definite,
            )
            for _ in range(self.reading.number(noun, self._rng) * owners)
        ]  # fmt: skip
        if noun.attributes.get("stack"):
            stack(group)
        return group
