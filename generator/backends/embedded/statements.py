"""Chunks of English to a draft of the scene: which objects, which table, what relates to what."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from ...catalogue import CATEGORIES
from ...errors import InputError
from ...scene import TABLE
from .grammar import Chunk, NounPhrase
from .relations import fits
from .vocabulary import STACKED, SUBSTANCES

_SIDES = ("left_of", "right_of", "in_front_of", "behind")

MAX_OBJECTS = 24
"""More objects than this no table of the catalogue holds."""


@dataclass(eq=False)
class Draft:
    """An object while the text is being read; ``relations`` are (kind, Draft or "table")."""

    noun: str
    category: str | None
    attributes: dict[str, str]
    lengths: tuple[float, ...] = ()
    relations: list[tuple[str, Draft | str]] = field(default_factory=list)
    provisional: bool = False
    implied: bool = False
    listed: bool = True

    def relate(self, kind: str, target: Draft | str) -> None:
        """Add a relation; it replaces one that was only assumed."""
        if self.provisional:
            self.relations.clear()
            self.provisional = False
        if (kind, target) not in self.relations:
            self.relations.append((kind, target))


Group = list[Draft]


@dataclass(eq=False)
class Reading:
    """What the text said, read so far."""

    objects: list[Draft] = field(default_factory=list)
    table: list[NounPhrase] = field(default_factory=list)
    table_parts: list[NounPhrase] = field(default_factory=list)
    excluded: set[str] = field(default_factory=set)
    warnings: list[str] = field(default_factory=list)
    vague: bool = False


class Reader:
    """Reads chunks from left to right and keeps what pronouns and conjunctions refer to."""

    def __init__(self, rng: np.random.Generator) -> None:
        self.reading = Reading()
        self._rng = rng
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
                self._relation(chunk.text)
            elif chunk.kind == "carry":
                self._carry(chunk.text)
            elif chunk.kind in ("and", "comma"):
                self._conjunction(chunk.kind)
            elif chunk.kind == "are":
                self._each = self._each or chunk.text == "each"
                self._joined = True
            elif chunk.kind == "of" and self._last is not None:
                self._of = self._last
        self._end_relation()
        return self.reading

    def _begin(self) -> None:
        """Start a sentence; what the last one was about stays known to pronouns."""
        self._earlier: Group | None = getattr(self, "_topic", None) or getattr(
            self, "_earlier", None
        )
        self._topic: Group | None = None  # the first subject of this sentence
        self._related = False  # the current subjects have got a relation
        self._subject_is_table = False
        self._group: list[Group] = []  # coordinated subjects, each some equal objects
        self._pending: str | None = None  # a relation without its target so far
        self._lead: tuple[str, list[Draft | str]] | None = None  # one told before its subject
        self._between: list[Draft | str] = []
        self._owner: Group | str | None = None  # what the current group was brought along by
        self._carried: str | None = None
        self._joined = False
        self._each = False
        self._comma = False
        self._listing = False
        self._of: NounPhrase | None = None
        self._last: NounPhrase | None = None
        self._bare: NounPhrase | None = None
        self._mentioned: Group | str | None = getattr(self, "_mentioned", None)

    # -------------------------------------------------------------------------- connectors

    def _relation(self, text: str) -> None:
        self._end_relation()
        self._last = None
        kind, _, target = text.partition(" ")
        if target == "table":
            beside = self._owner if kind in _SIDES and self._group else None
            self._attach(kind, self._one(beside) or [TABLE])
        elif target == "it":
            self._attach(kind, self._one(self._antecedent()))
        else:
            self._pending = kind

    def _carry(self, text: str) -> None:
        self._end_relation()
        self._owner = self._mentioned
        self._carried = text
        self._group = [] if text != "without" else self._group
        self._last = None
        self._joined = self._comma = False

    def _conjunction(self, kind: str) -> None:
        if self._pending == "between" and self._between:
            return
        self._end_relation()
        self._listing = True
        self._last = None
        self._comma = kind == "comma" or self._comma
        if self._related:
            self._group, self._related = [], False
        if kind == "comma" and self._owner not in (None, TABLE) and self._carried != "without":
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
            noun = self._merged(of, noun)
        joining = following is not None and following.kind == "of"
        if joining and noun.kind in ("group", "amount", "place", "part", "vague", "unknown"):
            self._last = noun
            return
        if self._carried == "without":
            self._exclude(noun)
            return
        if self._special(noun, following):
            return
        group = self._refer(noun) or self._introduce(noun)
        if not group:
            return
        self._last = noun if joining else None
        if self._pending is not None:
            self._target(list(group))
        else:
            self._subject(group)
        self._mentioned = group

    def _merged(self, of: NounPhrase, noun: NounPhrase) -> NounPhrase:
        """Read "a stack of three books", "a dozen of eggs", "a bowl of apples", "a cup of tea"."""
        if of.kind == "object":
            if noun.noun in SUBSTANCES or " ".join(noun.words) in SUBSTANCES:
                for draft in self._group[-1] if self._group else []:
                    draft.attributes.setdefault("state", f"with {noun.noun or noun.words[-1]}")
                return NounPhrase("place", noun.words)
            self._carry("hold")
            return noun
        if of.kind in ("group", "amount", "vague"):
            several = of.kind == "group" and of.words[-1] not in ("piece", "slice", "type", "kind")
            vague = of.vague or ((3, 3) if several and noun.plural else None)
            count = noun.count if noun.count is not None else of.count
            if of.kind == "group" and noun.count is None and (of.count or 0) <= 1:
                count = None if noun.plural else 1.0
            stacked = bool(STACKED & set(of.words)) and (noun.plural or (count or 0) > 1)
            attributes = {**noun.attributes, **({"stack": "yes"} if stacked else {})}
            return replace(
                noun, count=count, vague=None if count is not None else vague,
                attributes=attributes,
            )  # fmt: skip
        return noun

    def _exclude(self, noun: NounPhrase) -> None:
        names = {noun.category, *noun.members} - {None}
        self.reading.excluded |= {str(name) for name in names}

    def _special(self, noun: NounPhrase, following: Chunk | None) -> bool:
        """Deal with nouns that are no objects; tell whether this was one."""
        if noun.kind == "table":
            self._table(noun)
        elif noun.kind == "pronoun":
            target = self._antecedent()
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
                f"A scene has exactly one table, the text asks for several ({_said(noun)!r}). "
                "Describe one table."
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
            self._apply(kind, group, targets)
        if self._topic is None:
            self._topic = group
        if not self._listing and self._group and not self._joined:
            self._group = []
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
            kind = assumed_relation(draft, owner, held=self._carried == "hold")
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
            self._lead = (kind, list(targets))
            return
        spread = self._joined or (kind in ("on", "in") and not self._comma)
        for group in self._group if spread else self._group[-1:]:
            if self._joined or group is self._group[-1] or _shares(kind, group, targets):
                self._apply(kind, group, targets)
        self._owner, self._carried, self._related = None, None, True
        support = [target for target in targets if isinstance(target, Draft)]
        if kind in ("on", "in") and support:
            self._group = [support]

    def _apply(self, kind: str, group: Group, targets: Sequence[Draft | str]) -> None:
        paired = len(group) == len(targets) and len(targets) > 1 and kind != "next_to"
        for i, draft in enumerate(group):
            chosen = [targets[i]] if paired else list(targets if kind == "next_to" else targets[:1])
            stacked = any(to in group for _, to in draft.relations)
            for target in [] if stacked else chosen:
                if target is draft:
                    raise InputError(
                        f"The text relates the {draft.noun} to itself; name two different objects."
                    )
                if kind == "under" and isinstance(target, Draft):
                    target.relate("on", draft)
                elif kind == "under":
                    self.reading.warnings.append(
                        f"The {draft.noun} cannot go under the table; it stands on it."
                    )
                elif (kind, target) not in (("on", TABLE), ("in", TABLE), ("next_to", TABLE)):
                    draft.relate(kind, target)
                elif draft.provisional:
                    draft.relations.clear()
                    draft.provisional = False

    def _antecedent(self) -> Group | str | None:
        """Return what "it" means: the owner of the current group, else the thing before."""
        if self._owner is not None and self._group:
            return self._owner
        if not self._group and self._earlier:
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
        same = [d for d in self.reading.objects if _same(d, noun)]
        if self._each and self._pending is not None and len(same) > 1:
            return self._one_each(same)
        if not (noun.definite or noun.other):
            return None
        if noun.other and len(same) > 1:
            return [same[1]]
        if noun.plural and (noun.count or 2) > 1:
            return same or None
        return same[:1] or None

    def _one_each(self, owners: Group) -> Group:
        """Multiply the current subject so that each owner gets its own ("on each plate")."""
        if self._group:
            group = self._group[-1]
            for _ in range(len(owners) - len(group)):
                self._check_room()
                copy = Draft(group[0].noun, group[0].category, dict(group[0].attributes))
                self.reading.objects.append(copy)
                group.append(copy)
        return owners

    def _introduce(self, noun: NounPhrase) -> Group:
        if self._bare is not None:
            bare, self._bare = replace(noun, attributes=self._bare.attributes, count=1.0), None
            self._group = [*self._group, self._introduce(bare)]
            noun = replace(noun, count=noun.count or 1.0)
            self._listing = True
        if noun.kind == "mixed":
            self.reading.vague = True
            members = [m for m in noun.members if m not in self.reading.excluded]
            return [self._draft(noun, category, category.replace("_", " ")) for category in members]
        introduced = noun.determined or noun.plural or noun.category is not None
        if noun.kind == "unknown" and not (introduced or self._listing or self._carried):
            self.reading.warnings.append(f"Not understood and left out: {' '.join(noun.words)!r}.")
            return []
        claimed = [d for d in self.reading.objects if d.implied and _same(d, noun)]
        if claimed and not noun.definite and (noun.count or 1) == 1 and not noun.plural:
            claimed[0].implied = False
            claimed[0].attributes.update(noun.attributes)
            return claimed[:1]
        group = [self._draft(noun, noun.category, noun.noun) for _ in range(self._number(noun))]
        if noun.attributes.get("stack"):
            for below, above in zip(group, group[1:], strict=False):
                above.relate("on", below)
        return group

    def _number(self, noun: NounPhrase) -> int:
        if noun.count is not None:
            room = MAX_OBJECTS - len(self.reading.objects)
            if noun.count != int(noun.count) or noun.count < 1:
                raise InputError(f"{_said(noun)!r}: say a whole number of objects, from 1 up.")
            if noun.count > room:
                raise InputError(
                    f"{_said(noun)!r} is too many: a table holds at most {MAX_OBJECTS} objects in "
                    "all. Ask for fewer."
                )
            per_owner = 1
            if self._each and isinstance(self._owner, list):
                per_owner = len(self._owner)
            return int(noun.count) * per_owner
        if noun.vague or noun.plural:
            self.reading.vague = True
            low, high = noun.vague or (2, 3)
            if noun.vague and not noun.plural and noun.vague == (2, 3):
                return 1
            return int(self._rng.integers(low, high + 1))
        return 1

    def _check_room(self) -> None:
        if len(self.reading.objects) >= MAX_OBJECTS:
            raise InputError(
                f"The text asks for more than {MAX_OBJECTS} objects, more than a table holds. "
                "Ask for fewer."
            )

    def _draft(self, noun: NounPhrase, category: str | None, word: str) -> Draft:
        self._check_room()
        attributes = {k: v for k, v in noun.attributes.items() if k != "stack"}
        draft = Draft(word, category, attributes, noun.lengths, implied=noun.definite)
        self.reading.objects.append(draft)
        return draft


def _same(draft: Draft, noun: NounPhrase) -> bool:
    alike = draft.category == noun.category and (noun.category or draft.noun == noun.noun)
    return bool(alike) and all(
        draft.attributes.get(k, v) == v for k, v in noun.attributes.items() if k != "state"
    )


def _said(noun: NounPhrase) -> str:
    amount = f"{noun.count:g} " if noun.count is not None else ""
    return amount + " ".join(noun.words)


def _shares(kind: str, group: Group, targets: Sequence[Draft | str]) -> bool:
    """Tell whether "an apple and a pear on a plate" may mean that the apple is on it too."""
    target = targets[0]
    if isinstance(target, str):
        return True
    if any(not d.category for d in (group[0], target)):
        return False
    outer = CATEGORIES[str(target.category)]
    return all(
        fits(kind, CATEGORIES[str(d.category)].size, outer.size, outer.container)
        and not d.relations
        for d in group
    )


def assumed_relation(draft: Draft, owner: Draft, held: bool) -> str:
    """Return where a thing named with its owner goes: in a vessel, on a plate, else beside it."""
    if owner.category is None or draft.category is None:
        return "in" if held else "next_to"
    outer = CATEGORIES[owner.category]
    inner = CATEGORIES[draft.category].size
    if fits("in", inner, outer.size, outer.container) and (held or min(inner) < 0.06):
        return "in"
    if "support" in outer.roles and (held or max(inner[:2]) < 0.8 * min(outer.size[:2])):
        return "on"
    return "next_to"
