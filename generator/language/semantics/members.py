"""References to members of the last group, such as "the red one", "the other two" and "another"."""

from __future__ import annotations

from abc import ABC
from collections.abc import Callable
from dataclasses import dataclass
from enum import Enum, auto

from ..drafts import Draft, Group
from ..syntax.phrases.tree import Arranged, Carry, Location, Noun, Zone
from ..syntax.text import function_words as fw
from .links import link
from .references import may_carry, pick, size_rank
from .things import ThingReader

_TOPS = ("top", "upper", "topmost", "uppermost", "bottom")

_MAX_MEMBERS = 20  # maximum size to which a count of its members enlarges a group without a count


class Skip(Enum):
    """The result of a rule that does not apply, so that the next rule is tried."""

    SKIP = auto()


SKIP = Skip.SKIP

Members = Group | None | Skip
"""The drafts to which a phrase refers, None if it refers to nothing, or ``SKIP``."""


@dataclass(frozen=True)
class Rule:
    """One way in which a phrase without a noun refers to objects.

    Attributes:
        example: a text in which this rule resolves a phrase.
        resolve: function that returns the members, or ``SKIP`` if the rule does not apply.
    """

    example: str
    resolve: Callable[[MemberReader, Noun], Members]


@dataclass(eq=False)
class MemberReader(ThingReader, ABC):
    """Resolves phrases such as "one" or "the other two" to members of the last groups."""

    def _member(self, noun: Noun) -> Group | None:
        """Return the drafts to which a phrase without a noun refers, by the first matching rule.

        Returns None if the phrase refers to nothing that has been mentioned.
        """
        for rule in RULES:
            members = rule.resolve(self, noun)
            if not isinstance(members, Skip):
                return members
        return None

    def _refer(self, noun: Noun, group: Group) -> Group:
        """Mark drafts as described, and apply the rest of the phrase to them."""
        for draft in group:
            draft.told = True
        self._posts(noun, group)
        return group

    def _mention(self, noun: Noun, group: Group) -> Group:
        """Record that new drafts are mentioned here, and apply the rest of the phrase to them."""
        self._context.mentioned.append(group)
        self._posts(noun, group)
        return group

    def _groups(self) -> list[Group]:
        """Return the mentioned groups that have several drafts, with the most recent one last."""
        return [group for group in self._context.mentioned if len(group) > 1]

    def _half_or_rest(self, noun: Noun) -> Members:
        if noun.half or (noun.definite and noun.other and noun.plural and not noun.words):
            several = self._groups()[-1:]
            half = self._halve(several[0], self._said) if noun.half and several else []
            chosen = half or self._rest()
            if chosen and not noun.count:
                return self._refer(noun, chosen)
        return SKIP

    def _described_rest(self, noun: Noun) -> Members:
        if not (noun.definite and noun.other and noun.attributes and (noun.count or noun.plural)):
            return SKIP
        last = self._groups()[-1:]
        free = [d for group in last for d in group if not d.told][: int(noun.count or 99)]
        for draft in free:
            draft.told = True
            draft.attributes.update(noun.attributes)
        return free or None

    def _by_rank(self, noun: Noun) -> Members:
        if noun.definite and (best := self._ordinal(noun) or self._superlative(noun)):
            return self._refer(noun, best)
        return SKIP

    def _another_carrier(self, noun: Noun) -> Members:
        carries = any(isinstance(post, Carry) for post in noun.post)
        if noun.definite or not (noun.other and carries):
            return SKIP
        groups = reversed(self._context.mentioned)
        like = next((g[0] for g in groups if may_carry(g[0], "on")), None)
        if like is None:
            return SKIP
        return self._mention(
            noun, [self.reading.add(like.noun, like.category, {}, family=like.family)]
        )

    def _another(self, noun: Noun) -> Members:
        if noun.other and not noun.definite and not noun.words and (like := self._like_of(noun)):
            copy = self.reading.add(like.noun, like.category, like.attributes, family=like.family)
            return self._mention(noun, [copy])
        return SKIP

    def _described_one(self, noun: Noun) -> Members:
        if not (noun.definite and noun.attributes):
            return SKIP
        wanted = noun.attributes.items()
        known = [d for d in self.reading.objects if wanted <= d.attributes.items()][-1:]
        several = self._groups()[-1:]
        if not known and several:
            free = [d for d in several[0] if not (d.told or noun.attributes.keys() & d.attributes)]
            for draft in (known := free[:1]):
                draft.told = True
                draft.attributes.update(noun.attributes)
        if known:
            self._posts(noun, known)
        return known or None

    def _pyramid_layer(self, noun: Noun) -> Members:
        heaps = [{*g.members} for g in self.reading.groupings if g.kind == "pyramid"]
        latest = self._context.mentioned[-1:]
        return [] if latest and {*latest[0]} in heaps and not noun.definite else SKIP

    def _more_ones(self, noun: Noun) -> Members:
        latest = self._context.mentioned[-1:]
        single = latest and latest[0] is not self._uncounted and len(latest[0]) == 1
        if single and "ones" in noun.words and not noun.definite:
            return self._mention(noun, self._copies(noun, latest[0][0]))
        return SKIP

    def _arranged_ones(self, noun: Noun) -> Members:
        if not (noun.arrangement and "ones" in noun.words and self._fresh):
            return SKIP
        copies = self._copies(noun, self._fresh[0])
        self._arrange(Arranged(noun.arrangement), copies)
        return self._mention(noun, copies)

    def _copies(self, noun: Noun, like: Draft) -> Group:
        """Return as many new drafts of a kind as the phrase states."""
        return [
            self.reading.add(like.noun, like.category, noun.attributes, family=like.family,
                             lengths=noun.lengths)
            for _ in range(self.reading.number(noun, self.rng))
        ]  # fmt: skip

    def _different_one(self, noun: Noun) -> Members:
        if not noun.attributes or self._groups() or not self._context.mentioned:
            return SKIP
        like = self._context.mentioned[-1][0]
        bare = like.noun.split()[-1]
        made = [self.reading.add(bare, like.category, noun.attributes, family=like.family)]
        self._posts(noun, made)
        return made

    def _count_after_all(self, noun: Noun) -> Members:
        latest = self._groups()[-1:]
        if not latest or latest[0] is not self._uncounted or not noun.count:
            return SKIP
        if noun.post or noun.words:
            return SKIP
        self._recount(int(noun.count))
        return latest[0]

    def _some_of_group(self, noun: Noun) -> Members:
        groups = self._groups()
        if not groups or not (noun.post or noun.attributes or (noun.count and self._said)):
            return None
        free = [d for d in groups[-1] if not d.told]
        count = len(free) if noun.other and noun.plural else int(noun.count or 1)
        if groups[-1] is self._uncounted and not noun.definite and not noun.other:
            like = groups[-1][0]
            while len(free) < min(count, _MAX_MEMBERS):
                more = self.reading.add(like.noun, like.category, {}, family=like.family)
                groups[-1].append(more)
                free.append(more)
        chosen = free if any(map(_is_spread, noun.post)) else free[:count]
        for draft in chosen:
            draft.attributes.update(noun.attributes)
        return self._refer(noun, chosen) if chosen else None

    def _like_of(self, noun: Noun) -> Draft | None:
        """Return the last object with the kind of relation in "another in front of the box"."""
        kinds = {post.kind for post in noun.post if isinstance(post, Location)}
        placed = (
            d for d in reversed(self.reading.objects) if kinds & {kind for kind, _ in d.relations}
        )
        several = any(len(group) > 1 for group in self._context.mentioned)
        return None if several else next(placed, None)

    def _ordinal(self, noun: Noun) -> Group:
        """Return what "the second", "the left one" or "the empty one" means in the last group."""
        groups = self._groups()
        if not groups:
            return []
        group = groups[-1]
        if noun.ordinal:
            arranged = [list(g.members) for g in self.reading.groupings]
            return pick(next((g for g in reversed(groups) if g in arranged), group), noun.ordinal)
        if "empty" in noun.words:
            group = next((g for g in reversed(groups) if may_carry(g[0], "on")), group)
            carriers = [to for d in self.reading.objects for _, to in d.relations]
            return [d for d in group if all(d is not to for to in carriers)][:1]
        if noun.position in _TOPS and group[0].stacked_under is not None:
            tops = [d for d in group if d.stacked_under is None]
            return tops[-1:] if noun.position != "bottom" else group[:1]
        in_row = any(g.kind == "row" and [*g.members] == group for g in self.reading.groupings)
        if noun.position in ("left", "right") and in_row:
            return group[:1] if noun.position == "left" else group[-1:]
        if noun.position in ("left", "right") and len(group) < 4:
            link("left_of", group[:1], group[-1:], self.reading.warnings)
            return group[:1] if noun.position == "left" else group[-1:]
        return []

    def _superlative(self, noun: Noun) -> Group:
        """Return the object that "the smallest" or "the middle one" means in the last group."""
        groups = self._groups()
        if not groups:
            return []
        group = groups[-1]
        sizes = [size_rank(draft) for draft in group]
        for word in noun.words:
            if word in fw.SUPERLATIVES and len(set(sizes)) > 1:
                best = max(sizes) if fw.SUPERLATIVES[word] == "large" else min(sizes)
                return [group[sizes.index(best)]]
            if word == "middle":
                return [group[len(group) // 2]]
        return []


def _is_spread(post: object) -> bool:
    """Return whether a location puts one object at each of several places ("at each corner")."""
    if not isinstance(post, Location):
        return False
    return post.kind == "flank" or (isinstance(post.target, Zone) and post.target.spread)


RULES: tuple[Rule, ...] = (
    Rule("six cups, half of them red", MemberReader._half_or_rest),
    Rule("five mugs: the left one is red, the other four blue", MemberReader._described_rest),
    Rule("three mugs in a row, the left one on a plate", MemberReader._by_rank),
    Rule("a plate with two steaks and another with four patties", MemberReader._another_carrier),
    Rule("a carrot in front of the rabbit and another in front of the plate",
         MemberReader._another),
    Rule("two mugs: the blue one left of the board", MemberReader._described_one),
    Rule("a pyramid of six blocks: three at the bottom, two on those, one on top",
         MemberReader._pyramid_layer),
    Rule("a long candle and two short ones", MemberReader._more_ones),
    Rule("six cans and a row of green ones", MemberReader._arranged_ones),
    Rule("a large mug and a small green one", MemberReader._different_one),
    Rule("mugs on a table. there are four of them", MemberReader._count_after_all),
    Rule("two mugs, one on a plate", MemberReader._some_of_group),
)  # fmt: skip
"""All rules, in the order in which they are tried."""
