"""The models, each pinned to one commit (``models.toml``), and their local folder."""

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
        name: name in this project.
        repository: id on Hugging Face.
        revision: the commit, 40 hexadecimal digits.
        kind: the class in ``transformers`` that loads it.
        licence: licence of the weights.
        files: files to download, including ``WEIGHTS``.
        bytes: size of the weights; 0 if unknown.
        sha256: hash of the weights; empty if unknown.
        gated: whether the licence must be accepted on Hugging Face before the download.
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
        """The name and commit, as recorded in provenance."""
        return f"{self.name}@{self.revision[:12]}"


def pins() -> Mapping[str, Pin]:
    """Return all models by name."""
    table = tomllib.loads(Path(__file__).with_name("models.toml").read_text(encoding="utf-8"))
    return {n: Pin(**(e | {"name": n, "files": tuple(e["files"])})) for n, e in table.items()}


def pin(name: str, *kinds: str) -> Pin:
    """Return a model by name, optionally restricted to the given ``kinds``.

    Raises:
        BackendError: there is no such model.
    """
    known = {n: p for n, p in pins().items() if not kinds or p.kind in kinds}
    if name not in known:
        fitting = f" of kind {' or '.join(kinds)}" if kinds else ""
        raise BackendError(f"huggingface has no model {name!r}{fitting}.{choices(name, known)}")
    return known[name]


PICKLES = (".bin", ".pt", ".pth", ".ckpt", ".pkl", ".pickle")
"""Suffixes of files that may run code when loaded; such files are never opened."""


def snapshot(pin: Pin, folder: Path) -> Path:
    """Return the folder of a model at its commit; the returned folder need not exist."""
    name = f"models--{pin.repository.replace('/', '--')}"
    return folder / name / "snapshots" / pin.revision


def missing(pin: Pin, folder: Path) -> tuple[str, ...]:
    """Return the model's missing files."""
    home = snapshot(pin, folder)
    return tuple(name for name in pin.files if not (home / name).is_file())


def find_model(pin: Pin, folder: Path, what: str) -> Path:
    """Return the folder of a complete model within the models' folder.

    ``what`` names the backend and the question in error messages.

    Raises:
        BackendError: files are missing, or the weights exist only as a pickle.
    """
    home = snapshot(pin, folder)
    absent = missing(pin, folder)
    if not absent:
        return home
    get = f"Run: tabletopgen models pull {pin.name} --folder {folder}"
    pickles = sorted(p.name for p in home.glob("*") if p.suffix in PICKLES)
    if WEIGHTS in absent and pickles:
        raise BackendError(
            f"{what} {home} contains weights as a pickle ({', '.join(pickles)}), which may run "
            f"code and is never loaded; {WEIGHTS} is needed. {get}"
        )
    raise BackendError(
        f"{what} model {pin.name} ({pin.repository} at {pin.revision[:12]}) is not in {folder}: "
        f"missing {', '.join(absent)}. Models are not downloaded automatically. {get}, or set "
        f"{MODELS} to another folder."
    )
