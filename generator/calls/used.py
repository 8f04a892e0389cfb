"""The kept answers that one question was answered from, and how they go if they are of no use."""

from __future__ import annotations

import contextlib
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from ..errors import BackendError
from .store import CallStore

KEY = "x-tabletopgen-key"
"""The header of a response that says under which key its answer is kept."""


@dataclass(frozen=True)
class Used:
    """The keys of the answers that a question has had so far; ``store`` is where they are kept.

    A question that goes well leaves them there, for a run that resumes. One that ends in an error
    for what they say must drop them, or it would end so for ever.
    """

    store: CallStore | None
    keys: list[str] = field(default_factory=list)

    def add(self, headers: Mapping[str, str]) -> None:
        """Take note of an answer by the headers of its response."""
        self.keys.append(headers[KEY])

    def drop(self, *, last: bool = False) -> None:
        """Drop the answers, or the last one, but not their cost: the next run asks for new ones."""
        if self.store is not None:
            for key in self.keys[-1:] if last else self.keys:
                self.store.forget(key)

    @contextlib.contextmanager
    def dropped_on(self, error: type[BackendError]) -> Iterator[None]:
        """Drop the answers if the work within ends in ``error``."""
        try:
            yield
        except error:
            self.drop()
            raise
