"""The models, each pinned to one commit (``models.toml``), and their folder on this machine."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from ....errors import BackendError, choices
from ...requirements import MODELS

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


PICKLES = (".bin", ".pt", ".pth", ".ckpt", ".pkl", ".pickle")
"""How files end that may run code when they are read; none is ever opened."""


def snapshot(pin: Pin, folder: Path) -> Path:
    """Return where a model at its commit lies or would lie."""
    name = f"models--{pin.repository.replace('/', '--')}"
    return folder / name / "snapshots" / pin.revision


def missing(pin: Pin, folder: Path) -> tuple[str, ...]:
    """Return the model's files that are not there."""
    home = snapshot(pin, folder)
    return tuple(name for name in pin.files if not (home / name).is_file())


def find_model(pin: Pin, folder: Path, what: str) -> Path:
    """Return the folder of a model all of whose files are there, within ``models_folder``'s.

    ``what`` names backend and question, for the message of an error.

    Raises:
        BackendError: files are missing, or the weights are there as a pickle only.
    """
    home = snapshot(pin, folder)
    absent = missing(pin, folder)
    if not absent:
        return home
    get = f"Run: tabletopgen models pull {pin.name} --folder {folder}"
    pickles = sorted(p.name for p in home.glob("*") if p.suffix in PICKLES)
    if WEIGHTS in absent and pickles:
        raise BackendError(
            f"{what} {home} holds weights as a pickle ({', '.join(pickles)}), which may run code "
            f"and is never read; {WEIGHTS} is needed. {get}"
        )
    raise BackendError(
        f"{what} model {pin.name} ({pin.repository} at {pin.revision[:12]}) is not in {folder}: "
        f"no {', '.join(absent)}. Nothing is fetched while answering. {get}, or name another "
        f"folder with {MODELS}."
    )
