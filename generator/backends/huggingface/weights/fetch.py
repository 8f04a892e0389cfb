"""Fetching pinned models from Hugging Face: their named files only, checked."""

from __future__ import annotations

import hashlib
from collections.abc import Callable
from pathlib import Path

import safetensors

from ....errors import BackendError, StorageError
from ...requirements import module
from .download import HOW, download_apart
from .pins import PICKLES, WEIGHTS, Pin, missing, snapshot


def pull(pin: Pin, folder: Path, fetch: Callable[[Pin, Path], None] = download_apart) -> Path:
    """Fetch what is missing of a model at its commit; return the folder it lies in.

    An interrupted download goes on where it stopped; one that stands still is ended.
    ``HF_ENDPOINT`` names a mirror, ``HF_TOKEN`` is sent if it is set, as huggingface_hub does.

    Raises:
        BackendError: huggingface_hub is not installed, the server refuses, cannot be reached
            or stands still, or what it sent is not the pinned model.
        StorageError: the folder cannot be written.
    """
    what = f"huggingface, pull of {pin.name}:"
    module("huggingface_hub", "huggingface", HOW)
    if any(Path(name).suffix in PICKLES for name in pin.files):
        raise BackendError(f"{what} its files name a pickle; only safetensors are fetched.")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(
            f"{folder} cannot be made: {error.strerror or error}. Choose another --folder."
        ) from error
    fetch(pin, folder)
    home = snapshot(pin, folder)
    if absent := missing(pin, folder):
        raise BackendError(f"{what} the server has no {', '.join(absent)} at {pin.revision}.")
    _check(pin, home, what)
    return home


def _check(pin: Pin, home: Path, what: str) -> None:
    """Hold the weights against the table; what is not the pinned file is removed."""
    file = home / WEIGHTS
    if pin.sha256:
        with file.open("rb") as opened:
            got = hashlib.file_digest(opened, "sha256").hexdigest()
        if got != pin.sha256:
            file.resolve().unlink()
            file.unlink(missing_ok=True)  # where it was a link to what has just been removed
            raise BackendError(
                f"{what} {WEIGHTS} has SHA-256 {got}, not {pin.sha256}; it was removed. Run it "
                "again, without a mirror if one is set (HF_ENDPOINT)."
            )
    try:
        with safetensors.safe_open(file, framework="numpy"):
            pass
    except (OSError, safetensors.SafetensorError) as error:
        raise BackendError(f"{what} {WEIGHTS} is no safetensors file ({error}).") from error
