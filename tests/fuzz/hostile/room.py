"""The place where cases run: a folder for the case, and canaries beside and above it."""

import hashlib
import os
import shutil
from pathlib import Path

CANARIES = {
    "poetry.lock": "above\n",
    "outside.xml": '<mujoco><worldbody><body name="from_outside"/></worldbody></mujoco>\n',
    "precious/file.txt": "of value\n",
    "precious/poetry.lock": "of value\n",
    "inside/beside.txt": "beside\n",
    "inside/beside.lock": "beside\n",
    "inside/precious/file.txt": "of value\n",
}
"""Files that no case may change, by their place in the room."""

LEFTOVERS = (".staging-", ".partial-", ".removing-", ".part")
"""How unfinished files begin or end; none may be left by a case."""


class Room:
    """The folders of one worker: only ``case`` may change."""

    def __init__(self, root: Path) -> None:
        """Create the room in ``root``, an existing empty folder."""
        self.root = root
        self.case = root / "inside" / "case"
        self.temporary = root / "tmp"
        self._before = self.renew()

    def renew(self) -> dict[str, str]:
        """Recreate all files; return their listing."""
        for path in self.root.iterdir():
            remove(path)
        for name, text in CANARIES.items():
            place = self.root / name
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(text)
        for folder in (self.case, self.temporary, self.root / "home"):
            folder.mkdir(parents=True)
        self._before = self._listing()
        return self._before

    def changes(self) -> list[str]:
        """Return the changes outside the case's folder since the last check; then repair them."""
        now, before = self._listing(), self._before
        names = sorted(now.keys() | before.keys())
        changed = [name for name in names if now.get(name) != before.get(name)]
        if changed:
            self.renew()
        return changed

    def _listing(self) -> dict[str, str]:
        if not self.root.is_dir():
            self.root.mkdir(parents=True)
        skipped = os.path.relpath(self.case, self.root)
        return {
            name: told
            for name, told in listing(self.root, skipped).items()
            if not name.startswith(skipped + os.sep)
        }


def listing(folder: Path, skipped: str = "") -> dict[str, str]:
    """Return kind, mode and hash of a folder's entries by relative path; links unfollowed."""
    found: dict[str, str] = {}
    for here, folders, files in os.walk(folder):
        place = os.path.relpath(here, folder)
        if skipped and place == skipped:
            folders.clear()
            continue
        for name in (*folders, *files):
            path = Path(here, name)
            found[os.path.normpath(os.path.join(place, name))] = _told(path)
    return found


def remove(path: Path) -> None:
    if path.is_dir() and not path.is_symlink():
        shutil.rmtree(path)
    else:
        path.unlink(missing_ok=True)


def _told(path: Path) -> str:
    status = path.lstat()
    if path.is_symlink():
        return f"link to {os.readlink(path)}"
    if path.is_file():
        return f"{status.st_mode:o} {hashlib.sha256(path.read_bytes()).hexdigest()}"
    return f"{status.st_mode:o}"
