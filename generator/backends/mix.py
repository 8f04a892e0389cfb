"""Who answers which questions, by names alone: what a command line says and a process is sent."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

from ..calls import Session
from .select import PROTOCOLS, Backends


@dataclass(frozen=True)
class Mix:
    """Who answers the stages' questions. docs/guides/backends.md says what each needs.

    Attributes:
        backend: Who answers whatever the roles below leave open.
        reasoner: Who plans, names, sizes and orders things.
        imager: Who draws, completes and looks from above.
        segmenter: Who finds and masks things.
        modeler: Who turns the picture of an object into a mesh.
        encoder: Whose features compare a render with the picture.
    """

    backend: str | None = "embedded"
    reasoner: str | None = None
    imager: str | None = None
    segmenter: str | None = None
    modeler: str | None = None
    encoder: str | None = None

    @property
    def given(self) -> bool:
        """Whether any name is given."""
        return any(getattr(self, field.name) is not None for field in fields(self))

    @property
    def default(self) -> str:
        """Who answers what no role names another for."""
        return self.backend or "embedded"

    def roles(self) -> dict[str, str]:
        """Return the name that each of the five roles has."""
        return {role: getattr(self, role) or self.default for role in PROTOCOLS}

    def identity(self) -> dict[str, Any]:
        """Return what decides who answers, as JSON values; the roles only that differ."""
        others = {role: name for role, name in self.roles().items() if name != self.default}
        return {"backend": self.default, **({"roles": others} if others else {})}

    def select(self, session: Session | None = None) -> Backends:
        """Return the backends (BackendError: a name is unknown, or a question has no answer)."""
        return Backends.select(self.default, session=session, **self.roles())
