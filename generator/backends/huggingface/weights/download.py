"""The download of a pinned model: in a process of its own, which is ended where it stands still."""

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
"""A download that does not bring so much in so long stands still."""

_POLL = 0.2  # seconds between two looks at the process
_MOST_SAID = 2**14  # bytes of the process's last word
_CHILD = "from generator.backends.huggingface.weights.download import main; main()"


def download(model: Pin, folder: Path) -> None:
    """Fetch what is missing of a model in this process, for as long as it takes.

    Raises:
        BackendError: huggingface_hub is not installed, or the server refuses or cannot be reached.
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
            f"{what} its licence ({model.licence}) has to be accepted at "
            f"https://huggingface.co/{model.repository} first; then set HF_TOKEN to a token of "
            "that account."
        ) from error
    except Exception as error:  # of huggingface_hub, its client, or the disk
        if _of_the_disk(error):
            raise StorageError(
                f"{what} {folder} cannot be written: {error}. What was fetched is kept; make room, "
                "or choose another --folder."
            ) from error
        said = escape(" ".join(str(error).split())[:300])
        raise BackendError(
            f"{what} {model.repository} could not be fetched ({type(error).__name__}: {said}). "
            "What was fetched is kept; run it again."
        ) from error


def download_apart(model: Pin, folder: Path) -> None:
    """Do what ``download`` does in a process of its own, by plain HTTP, and watch it.

    Hugging Face's own transport (hf_xet) has no limits of time; it is left aside. Raises as
    ``download``, and a BackendError where nothing comes any more.
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

    The last word of ``command`` on its output is {"kind", "message"} of what went wrong. ``folder``
    may be missing at first; it has to grow by ``minimum`` bytes within ``seconds``. ``name`` is the
    model's.

    Raises:
        BackendError: it stood still, or what the command said.
        StorageError: what the command said.
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
                        f"huggingface, pull of {name}: less than {minimum} bytes came in "
                        f"{seconds:g} s. What was fetched is kept; look after the network (or "
                        "HF_ENDPOINT, if it is set), and run it again."
                    )
            if process.returncode:
                raise _error_of(process, name)
        finally:
            process.kill()


def main() -> None:
    """Download the model that the arguments describe; say what went wrong, and exit."""
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
    """Return the error that the process ended with."""
    what = f"huggingface, pull of {name}:"
    assert process.stdout is not None
    try:
        lines = process.stdout.read(_MOST_SAID).strip().splitlines()
        said = parse_object(lines[-1] if lines else b"", what, BackendError)
        kind = StorageError if said["kind"] == "storage" else BackendError
        return kind(str(said["message"]))
    except (BackendError, KeyError):
        return BackendError(
            f"{what} its process ended (exit code {process.returncode}). What was fetched is kept; "
            "run it again."
        )


def _size(folder: Path) -> int:
    """Return how many bytes lie in a folder; links count nothing."""
    found = 0
    for here, _, names in os.walk(folder):
        for name in names:
            with contextlib.suppress(OSError):  # it was moved meanwhile
                status = Path(here, name).lstat()
                found += status.st_blocks * 512
    return found


def _of_the_disk(error: Exception) -> bool:
    """Tell the disk's errors from the network's, some of which are OSErrors, too."""
    network = isinstance(error, ConnectionError | TimeoutError)
    return isinstance(error, OSError) and (error.errno or 0) > 0 and not network
