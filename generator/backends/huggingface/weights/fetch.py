"""Downloads of pinned models from Hugging Face: listed files only, with verified hashes."""

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
    """Download the missing files of a model at its commit; return their folder.

    An interrupted download resumes where it stopped; a stalled one is ended. ``HF_ENDPOINT`` sets a
    mirror, and ``HF_TOKEN`` is sent if set, as in huggingface_hub.

    Raises:
        BackendError: huggingface_hub is not installed; the server refuses, is unreachable or
            stalls; or the downloaded files are not the pinned ones.
        StorageError: the folder cannot be written.
    """
    what = f"huggingface, pull of {pin.name}:"
    module("huggingface_hub", "huggingface", HOW)
    if any(Path(name).suffix in PICKLES for name in pin.files):
        raise BackendError(
            f"{what} the model's files include a pickle; only safetensors are supported."
        )
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise StorageError(
            f"{folder} cannot be created: {error.strerror or error}. Choose another --folder."
        ) from error
    fetch(pin, folder)
    home = snapshot(pin, folder)
    if absent := missing(pin, folder):
        raise BackendError(
            f"{what} the server has no {', '.join(absent)} at revision {pin.revision}."
        )
    _check(pin, home, what)
    return home


def _check(pin: Pin, home: Path, what: str) -> None:
    """Verify the downloaded weights; remove files that differ from the pinned ones."""
    file = home / WEIGHTS
    if pin.sha256:
        with file.open("rb") as opened:
            got = hashlib.file_digest(opened, "sha256").hexdigest()
        if got != pin.sha256:
            file.resolve().unlink()
            file.unlink(missing_ok=True)  # it may be a link to the file that was just removed
            raise BackendError(
                f"{what} {WEIGHTS} has SHA-256 {got}, not {pin.sha256}; the file was removed. Run "
                "the command again, without a mirror if one is set (HF_ENDPOINT)."
            )
    try:
        with safetensors.safe_open(file, framework="numpy"):
            pass
    except (OSError, safetensors.SafetensorError) as error:
        raise BackendError(f"{what} {WEIGHTS} is not a safetensors file ({error}).") from error
