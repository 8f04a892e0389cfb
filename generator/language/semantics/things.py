"""Noun phrases for things: those there are, or new ones."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass, field, replace

from tabletop_objects import CATEGORIES

from ...scene import TABLE
from ..drafts import Draft, Group
from ..parsing.lexicon import singular
from ..parsing.vocabulary import MEANT_WITH
from ..syntax.phrases.tree import (
    VARIED,
    Arranged,
    Carry,
    Description,
    Location,
    Noun,
    Post,
    Zone,
)
from ..syntax.text import function_words as fw
from ..vessel_sizes import LOOSE
from .counts import CountReader
from .links import link
from .orders import size_rank
from .references import find_referred, may_carry, pick

_ONE_PIECE = frozenset(("pancakes", "paper_stack", "napkins", "playing_cards", "sticky_notes"))
"""Categories that are a stack or a heap already."""

_HEAPED = frozenset(("pancakes", "paper_stack"))
"""Those of which several are one heap without a word for it: "three pancakes"."""

_SEATS = frozenset(
    {"chair", "stool", "armchair", "sofa", "couch", "bench", "seat", "bed", "barstool"}
)
"""Furniture at a table."""

_FOOD = frozenset({"food", "fruit", "vegetable", "snack"})

_TOPS = ("top", "upper", "topmost", "uppermost", "bottom")

_SIDE_OF = {"left": "left_of", "right": "right_of"}

_COLORFUL = ("colored", "coloured", "colorful", "colourful")


@dataclass(eq=False)
class ThingReader(CountReader, ABC):
    """Reads which things a noun phrase means."""

    _fresh: Group = field(default_factory=list)  # the last things that came in
    _started: int = 0  # how many things the sentences before this one have named

    def _thing(self, noun: Noun) -> Group:
        """Return the objects a noun phrase means: those there are, or new ones."""
        if noun.kind == "collective":
            return self._collective(noun)
        known = any(d.category == noun.category for d in self.reading.objects if noun.category)
        arranged = noun.definite and not known and noun.head in fw.GROUPS
        if arranged and (found := self._arranged_as(fw.GROUPS[noun.head])):
            return found
        if noun.definite or noun.other or noun.each:
            known = self.reading.objects[self._seated or 0 :]
            found = find_referred(noun, known, self._context.subject)
            if noun.each and not found:
                found = [d for d in known if d.noun == noun.head]
            if found and not (noun.other and not noun.definite):
                return found
        bare = not noun.determined and noun.kind == "thing" and not noun.variants
        placed = any(isinstance(post, Location | Arranged) for post in noun.post)
        if bare and placed and self._started:
            known = [d for d in self.reading.objects[: self._started] if d.counted]
            if found := find_referred(replace(noun, definite=True), known):
                return found
        return self._introduce(noun)

    def _collective(self, noun: Noun) -> Group:
        if noun.definite and noun.count == 2:
            return []  # "both tools"
        if noun.definite and (known := self._find_collected(noun)):
            return known
        members = [m for m in noun.members if m not in self.reading.excluded]
        if noun.head.endswith(("setting", "settings")) and (noun.count or 1) > 1:
            self.reading.people = self.reading.people or int(noun.count or 1)
            return []
        self.reading.vague = self.reading.vague or not noun.head.startswith("salt")
        return [
            self.reading.add(category.replace("_", " "), category, noun.attributes)
            for category in members
        ]

    def _find_collected(self, noun: Noun) -> Group:
        """Return what "the cutlery" or "all the fruit" means of the things there are."""
        food = singular(noun.head.split()[-1]) in _FOOD
        return [
            d for d in self.reading.objects
            if d.category in noun.members
            or (food and d.category is not None and "edible" in CATEGORIES[d.category].roles)
        ]  # fmt: skip

    def _introduce(self, noun: Noun) -> Group:
        if noun.category is None and noun.head.split()[-1] in _SEATS:
            self.reading.warnings.append(
                f"The {noun.head} stands at the table, not on it; it is left out."
            )
            return []
        claimed = [d for d in self.reading.objects if d.implied and _claims(d, noun)]
        if claimed and noun.count and not (noun.definite or noun.variants or noun.each):
            counted = self._count_claimed(claimed, int(noun.count))
            if counted is not None:
                for draft in counted:
                    draft.attributes.update(noun.attributes)
                return counted
        if claimed and not noun.definite and (noun.count or 1) == 1 and not noun.plural:
            claimed[0].implied = False
            claimed[0].attributes.update(noun.attributes)
            return claimed[:1]
        there = {draft.category for draft in self.reading.objects}
        loose = noun.category in LOOSE.values()  # crisps in a bowl, whatever else is there
        meant = () if loose else MEANT_WITH.get(singular(noun.head), ())
        category = next((key for other, key in meant if other in there), noun.category)
        head = noun.head if category == noun.category else str(category).replace("_", " ")
        if category == "playing_cards" and singular(noun.head) == "card" and (noun.count or 1) > 1:
            category = "playing_card"  # "five cards" are no deck
            noun = replace(noun, category=category)
        single = noun.category in _ONE_PIECE and (
            noun.arrangement is not None or noun.category in _HEAPED
        )
        count = 1 if single else len(noun.variants) or self.reading.number(noun, self.rng)
        if claimed and not noun.definite and count > 1 and not noun.variants:
            claimed[0].implied = False  # "weigh the red pepper: three peppers ..."
            count -= 1
        else:
            claimed = []
        first = noun.each and count == 1 and noun.count is None  # "each plate" of a table for six
        if (noun.seated or first) and self._seated is None:
            count *= max(self.reading.people, self._guests, 1)
        group = [
            self.reading.add(
                head, category,
                {**noun.attributes, **(noun.variants[k] if noun.variants else {})},
                lengths=noun.lengths, family=noun.family, implied=noun.definite,
                position=noun.position,
            )
            for k in range(count)
        ]  # fmt: skip
        side = _SIDE_OF.get(noun.position or "") if noun.definite else None
        for draft in group if side else ():  # "the left plate", of which nothing was said
            draft.relate(str(side), TABLE)
        group = [*claimed, *group]
        self._fresh = group
        for draft in group:
            draft.counted = noun.determined
        if noun.count is None and noun.amount is None and len(group) > 1 and not noun.variants:
            self._uncounted = group
        if noun.arrangement is not None:
            self._arrange(Arranged(noun.arrangement), group)
        if noun.attributes.get("state") in _COLORFUL and "color" not in noun.attributes:
            self._post(Description(VARIED["color"]), group, noun)
        return group

    def _member(self, noun: Noun) -> Group | None:
        """Read "one on the plate", "the other behind it": single ones of the last group."""
        if noun.half or (noun.definite and noun.other and noun.plural and not noun.words):
            several = [g for g in self._context.mentioned if len(g) > 1][-1:]
            half = self._halve(several[0], self._said) if noun.half and several else []
            chosen = half or self._rest()
            if chosen and not noun.count:
                for draft in chosen:
                    draft.told = True
                self._posts(noun, chosen)
                return chosen
        if noun.definite and noun.other and noun.attributes and (noun.count or noun.plural):
            rest = [g for g in self._context.mentioned if len(g) > 1][-1:]
            free = [d for group in rest for d in group if not d.told][: int(noun.count or 99)]
            for draft in free:  # "the left one is red, the other four blue"
                draft.told = True
                draft.attributes.update(noun.attributes)
            return free or None
        if noun.definite and (best := self._ordinal(noun) or self._superlative(noun)):
            for draft in best:
                draft.told = True
            self._posts(noun, best)
            return best
        listed = any(isinstance(post, Carry) for post in noun.post)
        if noun.other and not noun.definite and listed:  # "another the four patties"
            like = next(
                (g[0] for g in reversed(self._context.mentioned) if may_carry(g[0], "on")), None
            )
            if like is not None:
                made = [self.reading.add(like.noun, like.category, {}, family=like.family)]
                self._context.mentioned.append(made)
                self._posts(noun, made)
                return made
        if noun.other and not noun.definite and not noun.words and (like := self._like_of(noun)):
            made = [self.reading.add(like.noun, like.category, like.attributes, family=like.family)]
            self._context.mentioned.append(made)
            self._posts(noun, made)
            return made
        if noun.definite and noun.attributes:  # "the red one"
            wanted = noun.attributes.items()
            known = [d for d in self.reading.objects if wanted <= d.attributes.items()][-1:]
            several = [g for g in self._context.mentioned if len(g) > 1][-1:]
            if not known and several:  # "two mugs: the blue one left of the board, ..."
                free = [
                    d for d in several[0] if not (d.told or noun.attributes.keys() & d.attributes)
                ]
                for draft in (known := free[:1]):
                    draft.told = True
                    draft.attributes.update(noun.attributes)
            if known:
                self._posts(noun, known)
            return known or None
        heaps = [{*g.members} for g in self.reading.groupings if g.kind == "pyramid"]
        if (
            self._context.mentioned
            and {*self._context.mentioned[-1]} in heaps
            and not noun.definite
        ):
            return []  # "a pyramid of six blocks: three at the bottom, two on those, one on top"
        groups = [g for g in self._context.mentioned if len(g) > 1]
        latest = self._context.mentioned[-1:]
        fresh = latest and latest[0] is not self._uncounted and len(latest[0]) == 1
        if fresh and "ones" in noun.words and not noun.definite:  # "and two short ones"
            like = latest[0][0]
            made = [
                self.reading.add(like.noun, like.category, noun.attributes, family=like.family,
                                 lengths=noun.lengths)
                for _ in range(self.reading.number(noun, self.rng))
            ]  # fmt: skip
            self._context.mentioned.append(made)
            self._posts(noun, made)
            return made
        if noun.arrangement and "ones" in noun.words and self._fresh:
            like = self._fresh[0]
            made = [
                self.reading.add(like.noun, like.category, noun.attributes, family=like.family)
                for _ in range(self.reading.number(noun, self.rng))
            ]  # fmt: skip
            self._arrange(Arranged(noun.arrangement), made)
            self._context.mentioned.append(made)
            self._posts(noun, made)
            return made
        if noun.attributes and not groups and self._context.mentioned:  # "a small green one"
            like = self._context.mentioned[-1][0]
            bare = like.noun.split()[-1]
            made = self.reading.add(bare, like.category, noun.attributes, family=like.family)
            self._posts(noun, [made])
            return [made]
        if (
            groups
            and groups[-1] is self._uncounted
            and noun.count
            and not (noun.post or noun.words)
        ):
            self._recount(int(noun.count))  # "there are four of them"
            return groups[-1]
        if not groups or not (noun.post or noun.attributes or (noun.count and self._said)):
            return None
        free = [d for d in groups[-1] if not d.told]
        count = len(free) if noun.other and noun.plural else int(noun.count or 1)
        if groups[-1] is self._uncounted and not noun.definite and not noun.other:
            like = groups[-1][0]
            while len(free) < min(count, 20):  # "pumpkins: a big one and two little ones"
                more = self.reading.add(like.noun, like.category, {}, family=like.family)
                groups[-1].append(more)
                free.append(more)
        spread = any(isinstance(p, Location) and (
            p.kind == "flank" or (isinstance(p.target, Zone) and p.target.spread))
                     for p in noun.post)  # fmt: skip
        chosen = free if spread else free[:count]  # "four bottles, one at each corner"
        for draft in chosen:
            draft.told = True
            draft.attributes.update(noun.attributes)
        if chosen:
            self._posts(noun, chosen)
        return chosen or None

    def _like_of(self, noun: Noun) -> Draft | None:
        """Return what "another in front of the rabbit" is another of: the last thing so placed."""
        kinds = {post.kind for post in noun.post if isinstance(post, Location)}
        placed = (
            d for d in reversed(self.reading.objects) if kinds & {kind for kind, _ in d.relations}
        )
        several = any(len(group) > 1 for group in self._context.mentioned)
        return None if several else next(placed, None)

    def _arranged_as(self, kind: str) -> Group:
        """Return the things of the last arrangement of a kind: "the pyramid", "this circle"."""
        for grouping in reversed(self.reading.groupings):
            members = list(grouping.members)
            if grouping.kind == kind and all(d not in self._context.subject for d in members):
                return members
        stacked = [d for d in self.reading.objects if d.stacked_under is not None]
        above = {id(d.stacked_under) for d in stacked}
        bottoms = [d for d in stacked if id(d) not in above and d not in self._context.subject]
        return bottoms[-1:] if kind in ("stack", "heap") else []

    def _ordinal(self, noun: Noun) -> Group:
        """Return what "the second", "the left one" or "the empty one" means of the last several."""
        groups = [group for group in self._context.mentioned if len(group) > 1]
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
        """Return the one that "the smallest" or "the middle one" means of the last several."""
        groups = [group for group in self._context.mentioned if len(group) > 1]
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

    @abstractmethod
    def _posts(self, noun: Noun, group: Group) -> None:
        """Read all that follows a noun phrase."""

    @abstractmethod
    def _post(self, post: Post, group: Group, noun: Noun | None) -> None:
        """Read one thing that is said of a group."""


def _claims(draft: Draft, noun: Noun) -> bool:
    alike = draft.category == noun.category and (noun.category or draft.noun == noun.head)
    color = draft.attributes.get("color")
    clash = color is not None and noun.attributes.get("color", color) != color
    return bool(alike) and not clash
