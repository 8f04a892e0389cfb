"""Download of a pinned model in a separate process, which is ended if it stalls."""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Sequence
from pathlib import Path

from ....errors import BackendError, StorageError, TabletopError, escape
from ....io.bounded import parse_object
from ...requirements import module
from .pins import Pin

HOW = "Run: pip install 'tabletopgen[huggingface]'"

_STILL_SECONDS, _STILL_BYTES = 120.0, 2**16
"""A download counts as stalled if it receives fewer bytes than this in this many seconds."""

_POLL = 0.2  # seconds between checks of the process
_MOST_SAID = 2**14  # maximum size of the process's final message in bytes
_CHILD = "from generator.backends.huggingface.weights.download import main; main()"


def download(model: Pin, folder: Path) -> None:
    """Download the missing files of a model in this process, without a time limit.

    Raises:
        BackendError: huggingface_hub is not installed, or the server refuses or is unreachable.
        StorageError: the folder cannot be written.
    """
    what = f"huggingface, pull of {model.name}:"
    hub = module("huggingface_hub", "huggingface", HOW)
    try:
        hub.snapshot_download(
            model.repository, revision=model.revision, cache_dir=folder,
            allow_patterns=list(model.files), endpoint=os.environ.get("HF_ENDPOINT") or None,
        )  # fmt: skip
    except hub.errors.GatedRepoError as error:
        raise BackendError(
            f"{what} the model's licence ({model.licence}) must first be accepted at "
            f"https://huggingface.co/{model.repository}; then set HF_TOKEN to a token of the "
            "account that accepted the licence."
        ) from error
    except Exception as error:  # errors of huggingface_hub, its HTTP client, or the disk
        if _of_the_disk(error):
            raise StorageError(
                f"{what} {folder} cannot be written: {error}. Partial downloads are kept; free "
                "disk space, or choose another --folder."
            ) from error
        said = escape(" ".join(str(error).split())[:300])
        raise BackendError(
            f"{what} {model.repository} could not be downloaded ({type(error).__name__}: "
            f"{said}). Partial downloads are kept; run the command again."
        ) from error


def download_apart(model: Pin, folder: Path) -> None:
    """Run ``download`` in a separate process, over plain HTTP, and watch it.

    Hugging Face's own transport (hf_xet) has no timeouts and is disabled. Raises the errors of
    ``download``, and BackendError for a download that stalls.
    """
    command = [sys.executable, "-c", _CHILD, json.dumps(vars(model)), str(folder)]
    watch(command, folder / f"models--{model.repository.replace('/', '--')}", model.name)


def watch(
    command: Sequence[str],
    folder: Path,
    name: str,
    *,
    seconds: float = _STILL_SECONDS,
    minimum: int = _STILL_BYTES,
) -> None:
    """Run a download until it ends, or until its folder has not grown for too long.

    If ``command`` fails, the last line of its output describes the error: {"kind", "message"}.
    ``folder`` may be missing at first; it must grow by ``minimum`` bytes within ``seconds``.
    ``name`` is the name of the model.

    Raises:
        BackendError: the download stalled, or the command reported it.
        StorageError: the command reported it.
    """
    environment = os.environ | {
        "HF_HUB_DISABLE_XET": "1", "HF_HUB_DISABLE_TELEMETRY": "1",
        "PYTHONPATH": os.pathsep.join(filter(None, sys.path)),
    }  # fmt: skip
    with subprocess.Popen(command, stdout=subprocess.PIPE, env=environment) as process:
        try:
            moved, size = time.monotonic(), _size(folder)
            while not _ended(process):
                if (now := _size(folder)) >= size + minimum:
                    moved, size = time.monotonic(), now
                if time.monotonic() - moved > seconds:
                    raise BackendError(
                        f"huggingface, pull of {name}: less than {minimum} bytes received in "
                        f"{seconds:g} s. Partial downloads are kept; check the network (or "
                        "HF_ENDPOINT, if it is set), and run the command again."
                    )
            if process.returncode:
                raise _error_of(process, name)
        finally:
            process.kill()


def main() -> None:
    """Download the model described by the command-line arguments; report errors and exit."""
    described, folder = sys.argv[1:]
    try:
        values = json.loads(described)
        download(Pin(**values | {"files": tuple(values["files"])}), Path(folder))
    except TabletopError as error:
        kind = "storage" if isinstance(error, StorageError) else "backend"
        print(json.dumps({"kind": kind, "message": str(error)[:2000]}))
        sys.exit(1)
    except KeyboardInterrupt:
        sys.exit(128 + signal.SIGINT)


def _ended(process: subprocess.Popen[bytes]) -> bool:
    with contextlib.suppress(subprocess.TimeoutExpired):
        process.wait(_POLL)
    return process.returncode is not None


def _error_of(process: subprocess.Popen[bytes], name: str) -> TabletopError:
    """Return the error that the process reported."""
    what = f"huggingface, pull of {name}:"
    assert process.stdout is not None
    try:
        lines = process.stdout.read(_MOST_SAID).strip().splitlines()
        said = parse_object(lines[-1] if lines else b"", what, BackendError)
        kind = StorageError if said["kind"] == "storage" else BackendError
        return kind(str(said["message"]))
    except (BackendError, KeyError):
        return BackendError(
            f"{what} the download process exited with code {process.returncode}. Partial downloads "
            "are kept; run the command again."
        )


def _size(folder: Path) -> int:
    """Return the total size of a folder's files in bytes, excluding links."""
    found = 0
    for here, _, names in os.walk(folder):
        for name in names:
            with contextlib.suppress(OSError):  # it was moved meanwhile
                status = Path(here, name).lstat()
                found += status.st_blocks * 512
    return found


def _of_the_disk(error: Exception) -> bool:
    """Return whether an error is a disk error; some network errors are OSErrors too."""
    network = isinstance(error, ConnectionError | TimeoutError)
    return isinstance(error, OSError) and (error.errno or 0) > 0 and not network
