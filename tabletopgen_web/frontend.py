"""The built front end in the package's ``static/``: HTML, JavaScript and MuJoCo's WebAssembly.

Wheels include it. A source checkout builds it on first use, since it is not in git.
"""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

from filelock import FileLock

from generator.errors import BackendError

STATIC = Path(__file__).with_name("static")
"""Folder of the built files."""

SOURCE = Path(__file__).parents[1] / "web"
"""Folder of the TypeScript sources in a source checkout."""

PAGES = ("page.html", "studio.html", "study.html")

_SECONDS = 600  # time limit of a build


def static_folder() -> Path:
    """Return the folder of the built front end; in a source checkout, build it if it is missing.

    Raises:
        BackendError: the front end is missing and cannot be built; the message gives the cause.
    """
    if not _complete(STATIC):
        build()
    return STATIC


def build() -> None:
    """Build the front end of a source checkout with npm, according to its lock file.

    Raises:
        BackendError: this is not a source checkout, npm is missing, or the build failed.
    """
    if not (SOURCE / "package-lock.json").is_file():
        raise BackendError(
            f"The web pages are missing from {STATIC} and can only be built in a source checkout. "
            f"Reinstall tabletopgen."
        )
    npm = shutil.which("npm")
    if npm is None:
        raise BackendError(
            "A source checkout builds the web pages with npm, which is not installed. "
            "Install Node.js 20 or newer, or install tabletopgen from a wheel."
        )
    with FileLock(SOURCE / "node_modules.lock"):  # two processes may build at once
        if _complete(STATIC):
            return
        for step in (["ci", "--no-audit", "--no-fund"], ["run", "build"]):
            _run([npm, *step])
    if not _complete(STATIC):
        raise BackendError(f"npm built no pages in {STATIC}. Run `make web` to see the cause.")


def _run(command: list[str]) -> None:
    try:
        done = subprocess.run(
            command, cwd=SOURCE, capture_output=True, text=True, timeout=_SECONDS, check=False
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise BackendError(
            f"The web pages cannot be built: {error}. Run `make web` to see the cause."
        ) from error
    if done.returncode:
        output = (done.stderr or done.stdout).strip().splitlines() or ["no output"]
        raise BackendError(
            f"The web pages cannot be built: npm {command[1]} failed with {output[0]!r}. Run "
            f"`make web` for the full output."
        )


def _complete(folder: Path) -> bool:
    return all((folder / page).is_file() for page in PAGES)
