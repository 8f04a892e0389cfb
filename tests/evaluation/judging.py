"""A reasoner that also judges: the embedded one's answers with constant scores."""

import os
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from calls.paid_server import ask

from generator.backends.embedded.reasoner import EmbeddedReasoner
from generator.calls import Session

SERVER = "JUDGE_OF_THE_TESTS"
"""Environment variable naming the server that ``PaidJudging`` asks."""


class Judging:
    """Gives the scores 3, 4 and 5, and ranks by name, the last first."""

    def __getattr__(self, name: str) -> Any:
        return getattr(EmbeddedReasoner(), name)

    def rate(self, reference: Any, pictures: Any, criteria: Mapping[str, str]) -> dict[str, float]:
        return dict(zip(criteria, (3.0, 4.0, 5.0), strict=True))

    def rank(self, reference: Any, methods: Mapping[str, Any]) -> tuple[str, ...]:
        return tuple(sorted(methods, reverse=True))


@dataclass(frozen=True)
class PaidJudging:
    """Sends a request per scene and per ranking, and gives constant scores."""

    session: Session = field(default_factory=Session, repr=False, compare=False)
    model: str = field(default_factory=lambda: os.environ.get("JUDGE_MODEL", "m"))

    def __getattr__(self, name: str) -> Any:
        return getattr(EmbeddedReasoner(), name)

    def rate(self, reference: Any, pictures: Any, criteria: Mapping[str, str]) -> dict[str, float]:
        ask(self.session, os.environ[SERVER], f"{pictures[0].sum()}", question="rate")
        return Judging().rate(reference, pictures, criteria)

    def rank(self, reference: Any, methods: Mapping[str, Any]) -> tuple[str, ...]:
        ask(self.session, os.environ[SERVER], f"{sorted(methods)}", question="rank")
        return Judging().rank(reference, methods)
