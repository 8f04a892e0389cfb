"""Backend names per role, as a command line gives them and other processes receive them."""

from __future__ import annotations

from dataclasses import dataclass, fields
from typing import Any

from ..calls import Session
from .select import PROTOCOLS, Backends


@dataclass(frozen=True)
class Mix:
    """Backends per role. docs/guides/backends.md lists their requirements.

    Attributes:
        backend: Backend of all roles that are not set below.
        reasoner: Backend that plans scenes and estimates names, sizes and supports.
        imager: Backend that draws, completes and renders pictures.
        segmenter: Backend that detects and segments objects.
        modeler: Backend that turns the picture of an object into a mesh.
        encoder: Backend whose features compare a render with the picture.
    """

    backend: str | None = "embedded"
    reasoner: str | None = None
    imager: str | None = None
    segmenter: str | None = None
    modeler: str | None = None
    encoder: str | None = None

    @property
    def given(self) -> bool:
        """Whether any backend is given."""
        return any(getattr(self, field.name) is not None for field in fields(self))

    @property
    def default(self) -> str:
        """The backend of roles that are not set."""
        return self.backend or "embedded"

    def roles(self) -> dict[str, str]:
        """Return the backend name of each of the five roles."""
        return {role: getattr(self, role) or self.default for role in PROTOCOLS}

    def identity(self) -> dict[str, Any]:
        """Return the settings that determine the backends, as JSON values; only differing roles."""
        others = {role: name for role, name in self.roles().items() if name != self.default}
        return {"backend": self.default, **({"roles": others} if others else {})}

    def select(self, session: Session | None = None) -> Backends:
        """Return the backends (BackendError: a name is unknown, or a role has no backend)."""
        return Backends.select(self.default, session=session, **self.roles())
