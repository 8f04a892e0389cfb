"""Evaluation of a case on a bundle: counts, relations, and objects that were not requested."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import linear_sum_assignment

from wording.cases import MANY, Case, ExpectedRelation, ExpectedThing, Names, matches, plain
from wording.relations import Things, holds
from wording.seen import Seen, Thing

COLOURED = 0.15
"""Share of an object's surface from which it has a colour."""
PACKS = (
    "bag|ball|bar|block|bottle|box|bunch|can|carton|case|jar|loaf|pack|packet|roll|slice|stack|tin"
)


@dataclass(frozen=True)
class Verdict:
    """Agreement of a table with its text.

    ``counts`` describes the unsatisfied clauses; ``silent`` those of them that no warning and no
    stand-in mentions. ``other`` are objects with the requested name but of another kind, judging by
    their names; ``changed`` are those of them that no warning mentions, and the silent ones for
    which an unrequested object is present. ``excused`` is the number of unsatisfied clauses
    mentioned in a warning that a text's ``terms_may_warn`` allow.
    """

    asked: int
    relations_asked: int
    counts: tuple[str, ...] = ()
    relations: tuple[str, ...] = ()
    phantoms: tuple[str, ...] = ()
    stand_ins: tuple[str, ...] = ()
    silent: tuple[str, ...] = ()
    other: tuple[str, ...] = ()
    changed: tuple[str, ...] = ()
    forbidden: tuple[str, ...] = ()
    excused: int = 0

    @property
    def right(self) -> bool:
        """Everything requested is present, as requested, and nothing else."""
        wrong = (self.counts, self.relations, self.phantoms, self.forbidden)
        return not any(wrong)

    @property
    def strict(self) -> bool:
        """Right, without plain shapes, and each object is of the kind that its name states."""
        return self.right and not self.other and not self.stand_ins


def judge(case: Case, seen: Seen, warnings: Sequence[str] = ()) -> Verdict:
    """Evaluate a case on its bundle and the warnings of its command."""
    real = [t for t in seen.things if not t.stand_in]
    given = assign(case.objects, real)
    left = [t for t in real if not any(t is x for group in given for x in group)]
    stray = [t for t in left if not _named(case.also, t)]
    surplus = {k: [t for t in stray if fits(c, t)] for k, c in enumerate(case.objects)}
    alien = [t for t in stray if not any(fits(c, t) for c in case.objects)]
    text = plain(case.text)
    stand_ins = [t for t in seen.things if t.stand_in]
    alien += [t for t in stand_ins if not _of_text(t, text)]
    missing: list[str] = []
    silent: list[str] = []
    excused = 0
    held = {c.any for k, c in enumerate(case.objects) if not given[k] and _held(c, real)}
    for k, clause in enumerate(case.objects):
        fault = _fault(clause, given[k], surplus[k])
        if not fault or clause.any in held:
            continue
        warned = told(clause, case.text, [*warnings, *(t.label for t in stand_ins)])
        if warned and any(matches(clause.any, w) for w in case.terms_may_warn):
            excused += 1
            continue
        missing.append(fault)
        if not warned and len(given[k]) < clause.least:
            silent.append(clause.word)
    masked = [t for c, ts in zip(case.objects, given, strict=True) for t in ts if not _kind(c, t)]
    hidden = [t for t in masked if not any(plain(t.label) in plain(w) for w in warnings)]
    group = _Groups(case, given, real, stand_ins)
    excusable = {c.any for k, c in enumerate(case.objects) if not given[k] and _may(case, c)}
    broken, spared = [], 0
    for relation in case.relations:
        if excused and excusable & {*_each(relation.a), *_each(relation.b or ())}:
            spared += 1
        elif not (relation.kind in ("in", "on") and relation.a in held) and not holds(
            relation.kind, group.of(relation.a), group.of(relation.b), relation.how, seen
        ):
            broken.append(_read(case, relation))
    forbidden = [
        t.name for t in seen.things if any(matches(p, w) for p in case.absent for w in _words(t))
    ]
    return Verdict(
        asked=len(case.objects) - excused,
        relations_asked=len(case.relations) - spared,
        counts=tuple(missing),
        relations=tuple(broken),
        phantoms=tuple(f"{t.label} ({t.name})" for t in alien),
        stand_ins=tuple(t.label for t in stand_ins),
        silent=tuple(silent),
        other=tuple(_as(t) for t in masked),
        changed=(*(_as(t) for t in hidden), *(silent if alien else ())),
        forbidden=tuple(forbidden),
        excused=excused,
    )


def assign(clauses: Sequence[ExpectedThing], things: Sequence[Thing]) -> list[list[Thing]]:
    """Assign objects to clauses such that as many counts as possible are satisfied."""
    slots = [
        (k, n < c.least) for k, c in enumerate(clauses) for n in range(min(c.most, len(things)))
    ]
    given: list[list[Thing]] = [[] for _ in clauses]
    if not slots:
        return given
    cost = np.full((len(things), len(slots) + len(things)), 0.0)  # the last ones: unassigned
    for i, thing in enumerate(things):
        for j, (k, needed) in enumerate(slots):
            cost[i, j] = _cost(clauses[k], thing, needed)
    for i, j in zip(*linear_sum_assignment(cost), strict=True):
        if j < len(slots) and cost[i, j] < 0:
            given[slots[j][0]].append(things[i])
    return given


def fits(clause: ExpectedThing, thing: Thing) -> bool:
    """Return whether an object's label or name is one that a clause requests."""
    return any(matches(clause.any, w) for w in _words(thing))


def told(clause: ExpectedThing, text: str, warnings: Sequence[str]) -> bool:
    """Return whether a warning mentions the object of a clause, by any of its words."""
    said = [plain(w) for w in warnings]
    terms = re.findall(rf"\b((?:{clause.any})(?:s|es)?)\b", plain(text))
    words = {(t if isinstance(t, str) else t[0]).strip() for t in terms} | {clause.word}
    named = any(w and re.search(rf"\b{re.escape(w)}", line) for w in words for line in said)
    return named or any(matches(clause.any, line) for line in said)


def _cost(clause: ExpectedThing, thing: Thing, needed: bool) -> float:
    if not fits(clause, thing):
        return 1e3
    own = plain(thing.label).replace(" ", "") == clause.word or matches(clause.word, thing.label)
    wrong = bool(_looks(clause, thing))
    return (-100.0 if needed else -20.0) + 2.0 * (not own) + 5.0 * wrong


def _looks(clause: ExpectedThing, thing: Thing) -> str:
    """Return what is wrong with an object's size and colour; empty if correct."""
    longest = 100 * float(max(thing.extents))
    if clause.cm and not clause.cm[0] <= longest <= clause.cm[1]:
        return f"{thing.name} is {longest:.0f} cm long"
    if clause.colour and thing.share(clause.colour) < COLOURED:
        return f"{thing.name} is not {clause.colour}"
    return ""


def _fault(clause: ExpectedThing, given: Sequence[Thing], surplus: Sequence[Thing]) -> str:
    many = len(given) + (len(surplus) if len(given) >= clause.most else 0)
    if not clause.least <= many <= clause.most:
        most = "" if clause.most == clause.least else "+" if clause.most > 90 else f"-{clause.most}"
        return f"{clause.word}: {many}, expected {clause.least}{most}"
    wrong = [w for t in given if (w := _looks(clause, t))]
    return f"{clause.word}: {', '.join(wrong)}" if wrong else ""


class _Groups:
    """The objects of a relation's patterns: those assigned to a clause, or else all matches.

    If a clause lacks objects, plain stand-in shapes have positions too: errors in counts are not
    counted again as errors in relations.
    """

    def __init__(
        self, case: Case, given: Sequence[Sequence[Thing]], real: Things, stand_ins: Things
    ) -> None:
        self.case, self.given, self.real, self.stand_ins = case, given, real, stand_ins

    def of(self, names: Names | None) -> list[list[Thing]]:
        return [self._of(pattern) for pattern in _each(names or ())]

    def _of(self, pattern: str) -> list[Thing]:
        clauses = [k for k, c in enumerate(self.case.objects) if c.any == pattern]
        if not clauses:
            return [t for t in self.real if _named((pattern,), t)]
        found = [t for k in clauses for t in self.given[k]]
        if len(found) < sum(self.case.objects[k].least for k in clauses):
            found += [t for t in self.stand_ins if _named((pattern,), t)]
        return found


def _read(case: Case, relation: ExpectedRelation) -> str:
    """Return a relation in the words of the case's clauses."""
    words = {c.any: c.word for c in case.objects}

    def read(names: Names | None) -> str:
        return "+".join(words.get(n, n) for n in _each(names or ()))

    how = f"({relation.how})" if relation.how else ""
    return " ".join(w for w in (read(relation.a), relation.kind, read(relation.b), how) if w)


def _each(names: Names) -> tuple[str, ...]:
    return (names,) if isinstance(names, str) else names


def _may(case: Case, clause: ExpectedThing) -> bool:
    return any(matches(clause.any, w) for w in case.terms_may_warn)


def _held(clause: ExpectedThing, real: Sequence[Thing]) -> bool:
    """Return whether a vessel is named after its contents, a "bowl of sweets", and contains them.

    That is sufficient if no number was requested.
    """
    return clause.most >= MANY and any(matches(rf"of (?:{clause.any})", t.label) for t in real)


def _kind(clause: ExpectedThing, thing: Thing) -> bool:
    """Return whether an object's name, which states its kind, ends with what a clause requests.

    A word of ``PACKS`` may follow: a stack of paper is paper, but a rack of test tubes is not a
    test tube.
    """
    pattern = rf"\b(?:{clause.any})(?:s|es)?(?: (?:{PACKS}))?$"
    return re.search(pattern, plain(thing.name)) is not None


def _as(thing: Thing) -> str:
    return f"{thing.label} is {thing.name}"


def _words(thing: Thing) -> tuple[str, str]:
    return thing.label, thing.name


def _named(patterns: Sequence[str], thing: Thing) -> bool:
    return any(matches(p, w) for p in patterns for w in _words(thing))


def _of_text(thing: Thing, text: str) -> bool:
    words = [w for w in plain(thing.label).split() if len(w) > 2]
    return any(w[: max(3, len(w) - 2)] in text for w in words)  # daisy, daisies
