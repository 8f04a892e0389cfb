"""Which models there are, each at one commit: the table ``models.toml``."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from ....errors import BackendError, choices

WEIGHTS = "model.safetensors"


@dataclass(frozen=True)
class Pin:
    """One model at one commit.

    Attributes:
        name: what the project calls it.
        repository: its id at Hugging Face.
        revision: the commit, 40 hexadecimal digits.
        kind: class of transformers that reads it.
        licence: of the weights.
        files: what is fetched, ``WEIGHTS`` among it.
        bytes: size of the weights; 0 if not known.
        sha256: of the weights; empty if not known.
        gated: the licence has to be accepted at Hugging Face before it can be fetched.
    """

    name: str
    repository: str
    revision: str
    kind: str
    licence: str
    files: tuple[str, ...]
    bytes: int = 0
    sha256: str = ""
    gated: bool = False

    @property
    def stamp(self) -> str:
        """Name and commit as provenance records them."""
        return f"{self.name}@{self.revision[:12]}"


def pins() -> Mapping[str, Pin]:
    """Return all models by name."""
    table = tomllib.loads(Path(__file__).with_name("models.toml").read_text(encoding="utf-8"))
    return {n: Pin(**(e | {"name": n, "files": tuple(e["files"])})) for n, e in table.items()}


def pin(name: str, *kinds: str) -> Pin:
    """Return a model by its name, of one of ``kinds`` if given (BackendError: there is none)."""
    known = {n: p for n, p in pins().items() if not kinds or p.kind in kinds}
    if name not in known:
        fitting = f" of kind {' or '.join(kinds)}" if kinds else ""
        raise BackendError(f"huggingface has no model {name!r}{fitting}.{choices(name, known)}")
    return known[name]
