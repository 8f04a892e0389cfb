"""Where the models lie on this machine: a folder as Hugging Face's cache is laid out."""

from __future__ import annotations

from pathlib import Path

from ....errors import BackendError
from ...installing import MODELS
from .pins import WEIGHTS, Pin

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
