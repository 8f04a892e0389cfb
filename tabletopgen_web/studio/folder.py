"""The data folder of a studio, and the lock that reserves it for one process.

::

    jobs.sqlite3       jobs and events
    reserve            reserved space to record job results on a full disk
    scenes/            the workspace: bundles made here
    pictures/<id>      uploaded pictures in original form; <id>.png for display
    figures/<job>/     pictures of a job's stages
    files/<job>/       exports and episodes
    views/<scene>/     scenes prepared for the viewer, regenerated if missing
    answers/<study>/   answers of studies
    studies.secret     the secret from which raters' tokens are derived
    studio.lock, studio.json   the process that uses the folder
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

_MAX_BYTES = 4096  # of studio.json
_ADDRESS = "The studio's address"
_WHO, _SECRET = "studio.json", "studies.secret"


@dataclass(frozen=True)
class StudioFolder:
    """The data folder of a studio."""

    root: Path

    @classmethod
    def usual(cls) -> StudioFolder:
        """Return the default folder of this user."""
        import platformdirs

        return cls(Path(platformdirs.user_state_dir("tabletopgen")) / "studio")

    @property
    def database(self) -> Path:
        """Path of the database of jobs and events."""
        return self.root / "jobs.sqlite3"

    @property
    def scenes(self) -> Path:
        """Path of the workspace."""
        return self.root / "scenes"

    @property
    def pictures(self) -> Path:
        """Path of the uploaded pictures."""
        return self.root / "pictures"

    @property
    def figures(self) -> Path:
        """Path of the stages' pictures, with a folder per job."""
        return self.root / "figures"

    @property
    def files(self) -> Path:
        """Path of the jobs' other files, with a folder per job."""
        return self.root / "files"

    @property
    def views(self) -> Path:
        """Path of the scenes prepared for the viewer."""
        return self.root / "views"

    @property
    def answers(self) -> Path:
        """Path of the answers to studies, with a folder per study."""
        return self.root / "answers"

    def make(self) -> None:
        """Create missing folders, accessible only to their owner.

        Raises:
            StorageError: the folder is not writable.
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
        """Create the folder, and hold its lock within the context.

        Raises:
            StorageError: another studio uses the folder, or it is not writable.
        """
        self.make()
        lock = FileLock(self.root / "studio.lock", timeout=0, thread_local=False)
        try:
            lock.acquire()
        except Timeout:
            raise StorageError(
                f"Another studio{self._who()} uses {self.root}. Open the address that it printed, "
                f"including the token, or choose another --folder."
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
        """Record the studio's address, without its token, for a second studio's error message."""
        facts = json.dumps({"process": os.getpid(), "address": address})
        write_whole(self.root / _WHO, facts, _ADDRESS, "Free disk space.")

    def make_token(self, study: str) -> str:
        """Return the token for a study's raters; it stays the same as long as the folder exists.

        It persists when the studio stops, so addresses sent to raters remain valid.

        Raises:
            StorageError: the secret is not writable, or is damaged.
        """
        path = self.root / _SECRET
        if not path.exists():
            new = secrets.token_hex(32)
            write_whole(path, new, "The studies' secret", "Free disk space.", mode=0o600)
        secret = read_regular(path, "The studies' secret", StorageError, max_bytes=_MAX_BYTES)
        if len(secret) != 64:
            raise StorageError(f"{path} is damaged. Remove it; raters then need new addresses.")
        return hmac.new(secret, study.encode(), "sha256").hexdigest()[:48]

    def _who(self) -> str:
        try:
            raw = read_regular(self.root / _WHO, _ADDRESS, StorageError, max_bytes=_MAX_BYTES)
            facts = parse_object(raw, _ADDRESS, StorageError)
            return f" (process {facts['process']}, at {facts['address']})"
        except (TabletopError, KeyError):
            return ""
