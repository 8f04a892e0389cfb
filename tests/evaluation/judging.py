"""A reasoner that judges, too: the embedded one's answers, and marks that are always the same."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from generator.backends.embedded.reasoner import Reasoner


class Judging:
    """Gives 3, 4 and 5, and ranks by name, the last first."""

    def __getattr__(self, name: str) -> Any:
        return getattr(Reasoner(), name)

    def rate(self, reference: Any, pictures: Any, criteria: Mapping[str, str]) -> dict[str, float]:
        return dict(zip(criteria, (3.0, 4.0, 5.0), strict=True))

    def rank(self, reference: Any, methods: Mapping[str, Any]) -> tuple[str, ...]:
        return tuple(sorted(methods, reverse=True))
