"""Where the models lie on this machine: a folder as Hugging Face's cache is laid out."""

from __future__ import annotations

import os
from pathlib import Path

import platformdirs

from ....errors import BackendError
from .pins import WEIGHTS, Pin

MODELS = "TABLETOPGEN_MODELS"
"""The environment's name for the folder; a cache of Hugging Face (``hub``) can be one."""

PICKLES = (".bin", ".pt", ".pth", ".ckpt", ".pkl", ".pickle")
"""How files end that may run code when they are read; none is ever opened."""


def models_folder(given: str | Path | None = None) -> Path:
    """Return ``given``, else the environment's folder, else the one in this user's cache."""
    usual = Path(platformdirs.user_cache_dir("tabletopgen")) / "models"
    return Path(given or os.environ.get(MODELS) or usual).expanduser()


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
