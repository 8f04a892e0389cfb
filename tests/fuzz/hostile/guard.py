"""Records every file change by Python outside a case's folder, and rejects distant ones.

An audit hook sees the change before it happens. What lies in the room, where the canaries are, may
be changed: the harness looks at it afterwards. What lies outside the room is never touched.
"""

import os
import sys
from pathlib import Path
from typing import Any

_WRITES = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
# What each event does to which of its arguments: (path, its folder's descriptor).
_OF_NAMES = {
    "os.remove": ((0, 1),),
    "os.rmdir": ((0, 1),),
    "os.mkdir": ((0, 2),),
    "os.rename": ((0, 2), (1, 3)),
    "os.link": ((1, 3),),
    "os.symlink": ((1, 2),),
    "shutil.rmtree": ((0, 1),),
}
_OF_FILES = {
    "os.chmod": ((0, 2),),
    "os.chown": ((0, 3),),
    "os.truncate": ((0, None),),
    "os.utime": ((0, 3),),
}
_DEVICES = "/dev/"


class Guard:
    """Monitors the file changes of this process while it is armed."""

    def __init__(self, room: Path, temporary: Path) -> None:
        """Watch from now on; see ``arm``. A hook stays as long as its process.

        What is done in ``temporary`` is of no account: what stays there is seen in the room.
        """
        self._room, self._temporary = os.path.realpath(room), os.path.realpath(temporary)
        self._folder = ""
        self.touched: list[str] = []
        sys.addaudithook(self._heard)

    def arm(self, folder: Path) -> None:
        """Record changes outside ``folder`` from now on."""
        self.touched = []
        self._folder = os.path.realpath(folder)

    def disarm(self) -> list[str]:
        """Stop, and return the attempted changes."""
        self._folder = ""
        return self.touched

    def _heard(self, event: str, args: tuple[Any, ...]) -> None:
        if not self._folder:
            return
        if event == "open":
            path, _, flags = args
            if isinstance(flags, int) and flags & _WRITES:
                self._check(event, path, None, follow=not flags & os.O_NOFOLLOW)
            return
        for table, follow in ((_OF_NAMES, False), (_OF_FILES, True)):
            for place, descriptor in table.get(event, ()):
                if event == "os.mkdir" and os.path.isdir(args[0]):  # it fails without any change
                    continue
                known = descriptor is not None and descriptor < len(args)
                self._check(event, args[place], args[descriptor] if known else None, follow)

    def _check(self, event: str, path: Any, descriptor: Any, follow: bool) -> None:
        place = _resolved(path, descriptor, follow)
        if place is None or place.startswith(_DEVICES):
            return
        if _within(place, self._folder) or place.startswith(self._temporary + os.sep):
            return
        self.touched.append(f"{event} {place}")
        if not _within(place, self._room):
            raise PermissionError(f"{event} {place!r} outside the room of a hostile case")


def _resolved(path: Any, descriptor: Any, follow: bool) -> str | None:
    """Return the resolved path; None for an open file or an invalid path."""
    if isinstance(path, int):
        return None
    try:
        text = os.fsdecode(path)
        if not os.path.isabs(text) and isinstance(descriptor, int) and descriptor >= 0:
            text = os.path.join(os.readlink(f"/proc/self/fd/{descriptor}"), text)
        if follow:
            return os.path.realpath(text)
        parent, name = os.path.split(os.path.abspath(text))
        return os.path.join(os.path.realpath(parent), name)
    except (ValueError, TypeError, OSError):
        return None


def _within(place: str, folder: str) -> bool:
    return place == folder or place.startswith(folder + os.sep)
