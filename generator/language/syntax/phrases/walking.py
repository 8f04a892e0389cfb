"""All noun phrases of a tree of sentences: those that were not read, denied or only shown."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

from .tree import Carry, Lack, Location, Noun, Post, Sentence, Span


def list_unread(sentences: Sequence[Sentence], read: Collection[Span]) -> list[str]:
    """Return the things of the sentences, in the text's words, whose place was never read."""
    return [
        " ".join(noun.words)
        for noun in _nouns(sentences)
        if noun.kind == "thing" and noun.span not in read and noun.span != (0, 0)
    ]


def find_spans(noun: Noun) -> list[Span]:
    """Return where a noun phrase and all those in it stand."""
    return [inner.span for inner in _nouns_of(noun)]


def find_things(sentences: Sequence[Sentence]) -> list[Span]:
    """Return where the names of things stand: of a lab coat, no lab."""
    return [noun.span for noun in _nouns(sentences) if noun.kind == "thing"]


def find_denied(sentences: Sequence[Sentence], pictures: Collection[str]) -> list[Span]:
    """Return where stands what is not there, and what ``pictures`` only show."""
    shown = [
        item.span
        for noun in _nouns(sentences)
        if {noun.category, *noun.head.split()[-1:]} & {*pictures}
        for post in noun.post
        if isinstance(post, Carry) and post.how == "of"
        for carried in post.items
        for item in _nouns_of(carried)
    ]
    return [*shown, *(item.span for post in _posts(sentences) for item in _lacking(post))]


def _lacking(post: Post) -> Sequence[Noun]:
    return post.items if isinstance(post, Lack) else ()


def _posts(sentences: Sequence[Sentence]) -> Iterator[Post]:
    for noun in _nouns(sentences):
        yield from noun.post
    for sentence in sentences:
        for clause in sentence.clauses:
            yield from clause.predicate


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
