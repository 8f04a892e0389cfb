"""The things of a tree of sentences, to find those that no draft was made of."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from ..syntax.phrases.tree import Carry, Lack, Location, Noun, Post, Sentence, Span


def list_unread(sentences: Sequence[Sentence], read: Collection[Span]) -> list[str]:
    """Return the things of the sentences, in the text's words, whose place was never read."""
    return [
        " ".join(noun.words)
        for noun in _nouns(sentences)
        if noun.kind == "thing" and noun.span not in read and noun.span != (0, 0)
    ]


def _nouns(sentences: Sequence[Sentence]) -> Iterator[Noun]:
    for sentence in sentences:
        for clause in sentence.clauses:
            for noun in clause.subjects:
                yield from _nouns_of(noun)
            lead = [clause.lead] if clause.lead is not None else []
            for post in (*lead, *clause.predicate):
                yield from _nouns_in(post)


def _nouns_of(noun: Noun) -> Iterator[Noun]:
    yield noun
    for post in noun.post:
        yield from _nouns_in(post)


def _nouns_in(post: Post) -> Iterator[Noun]:
    if isinstance(post, Location) and isinstance(post.target, Noun):
        yield from _nouns_of(post.target)
    elif isinstance(post, Carry):
        for item in post.items:
            yield from _nouns_of(item)
    elif isinstance(post, Lack) and post.place is not None:
        yield from _nouns_in(post.place)
