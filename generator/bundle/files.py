"""Copying of bundles, and reading of all their files, for archives and web servers."""

from __future__ import annotations

import os
from pathlib import Path

from ..errors import StorageError
from .encoder import dumps
from .folder import BESIDE, read_inside, read_listed, read_truth
from .publication import publish, steady

_MOST_BESIDE = 64 * 2**20


@steady
def read_files(path: str | Path) -> dict[str, bytes]:
    """Return the content of every file in a bundle, by its path in the bundle.

    The files are ``scene.json``, the files that it lists (each is compared with its entry), and
    accompanying files such as a certificate. Only ``load`` checks that they form a valid scene.

    Raises:
        BundleError: there is no bundle, or a file is missing or has been changed.
    """
    folder = Path(path)
    payload = read_truth(folder)
    files = {"scene.json": dumps(payload)}
    files |= {n: read_listed(folder, n, entry) for n, entry in payload["files"].items()}
    for name in sorted(BESIDE):
        if os.path.lexists(folder / name):
            files[name] = read_inside(folder, name, _MOST_BESIDE)
    return files


def copy(path: str | Path, folder: str | Path) -> Path:
    """Publish a copy of a bundle in ``folder``, which is created if missing; return the new path.

    Raises:
        BundleError: there is no bundle, or a file is missing or has been changed.
        StorageError: the folder cannot be written, or the disk is full.
    """
    source = Path(path)
    files = read_files(source)
    try:
        return publish(Path(folder), source.resolve().name, files, beside=BESIDE)
    except OSError as error:
        raise StorageError(
            f"{source.name} cannot be copied to {folder}: {error.strerror or error}. Free disk "
            "space, or choose another folder."
        ) from error
