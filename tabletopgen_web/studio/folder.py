"""The folder in which a studio keeps everything, and the lock that it is one studio's.

::

    jobs.sqlite3       jobs and events
    reserve            room in which endings are written on a full disk
    scenes/            the workspace: bundles made here
    pictures/<id>      uploaded pictures, as they came; <id>.png as they are shown
    figures/<job>/     what the stages of a job found
    files/<job>/       exports and episodes
    views/<scene>/     scenes as the viewer loads them; made again where they are missing
    answers/<study>/   answers of studies
    studies.secret     what raters' tokens are made from
    studio.lock, studio.json   who uses the folder
"""

from __future__ import annotations

import contextlib
import hmac
import json
import os
import secrets
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from filelock import FileLock, Timeout

from generator.errors import StorageError, TabletopError
from generator.io.bounded import parse_object, read_regular
from generator.io.files import check_folder, make_private, write_whole

_MOST_BYTES = 4096  # of studio.json
_WHO, _SECRET = "studio.json", "studies.secret"


@dataclass(frozen=True)
class StudioFolder:
    """Where a studio keeps what it has."""

    root: Path

    @classmethod
    def usual(cls) -> StudioFolder:
        """Return this user's."""
        import platformdirs

        return cls(Path(platformdirs.user_state_dir("tabletopgen")) / "studio")

    @property
    def database(self) -> Path:
        """Jobs and events."""
        return self.root / "jobs.sqlite3"

    @property
    def scenes(self) -> Path:
        """The workspace."""
        return self.root / "scenes"

    @property
    def pictures(self) -> Path:
        """Uploaded pictures."""
        return self.root / "pictures"

    @property
    def figures(self) -> Path:
        """Pictures of what stages found, a folder a job."""
        return self.root / "figures"

    @property
    def files(self) -> Path:
        """What jobs made that is no scene, a folder a job."""
        return self.root / "files"

    @property
    def views(self) -> Path:
        """Scenes as the viewer loads them."""
        return self.root / "views"

    @property
    def answers(self) -> Path:
        """Answers of studies, a folder a study."""
        return self.root / "answers"

    def make(self) -> None:
        """Make what is missing of it, for its owner alone.

        Raises:
            StorageError: it cannot be written.
        """
        check_folder(self.root, "--folder")
        try:
            for folder in (self.scenes, self.pictures, self.figures, self.files, self.views,
                           self.answers):  # fmt: skip
                make_private(folder)
        except OSError as error:
            raise StorageError(
                f"--folder {str(self.root)!r} cannot be written: {error.strerror or error}. Choose "
                "another folder."
            ) from error

    @contextlib.contextmanager
    def locking(self) -> Iterator[None]:
        """Make the folder and hold it as this process's own meanwhile.

        Raises:
            StorageError: another studio uses it, or it cannot be written.
        """
        self.make()
        lock = FileLock(self.root / "studio.lock", timeout=0, thread_local=False)
        try:
            lock.acquire()
        except Timeout:
            raise StorageError(
                f"Another studio{self._who()} uses {self.root}. Open the address that it printed, "
                "with its token, or choose another --folder."
            ) from None
        except OSError as error:
            raise StorageError(
                f"{self.root} cannot be locked: {error.strerror or error}. Choose another --folder."
            ) from error
        try:
            yield
        finally:
            lock.release()

    def announce(self, address: str) -> None:
        """Write down where this studio is, without its token, for a second one to tell."""
        facts = json.dumps({"process": os.getpid(), "address": address})
        write_whole(self.root / _WHO, facts, "Where the studio is", "Free space there.")

    def make_token(self, study: str) -> str:
        """Return the token of a study's raters, the same one as long as the folder is there.

        It outlives the studio, so that an address that was sent to raters stays good.

        Raises:
            StorageError: what it is made from cannot be written, or is damaged.
        """
        path = self.root / _SECRET
        if not path.exists():
            new = secrets.token_hex(32)
            write_whole(path, new, "The studies' secret", "Free space there.", mode=0o600)
        secret = read_regular(path, "The studies' secret", StorageError, max_bytes=_MOST_BYTES)
        if len(secret) != 64:
            raise StorageError(f"{path} is damaged. Remove it; raters then need new addresses.")
        return hmac.new(secret, study.encode(), "sha256").hexdigest()[:48]

    def _who(self) -> str:
        try:
            raw = read_regular(self.root / _WHO, "Where it is", StorageError, max_bytes=_MOST_BYTES)
            facts = parse_object(raw, "Where it is", StorageError)
            return f" (process {facts['process']}, at {facts['address']})"
        except (TabletopError, KeyError):
            return ""
