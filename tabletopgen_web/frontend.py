"""The built front end: HTML, JavaScript and MuJoCo's WebAssembly, in the package's ``static/``.

A wheel brings it. A source checkout does not hold it in git and builds it at first use.
"""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

from filelock import FileLock

from generator.errors import BackendError

STATIC = Path(__file__).with_name("static")
"""Where the built files are."""

SOURCE = Path(__file__).parents[1] / "web"
"""Where a source checkout has the TypeScript."""

PAGES = ("page.html", "studio.html", "study.html")

_SECONDS = 600  # that a build may take


def static_folder() -> Path:
    """Return the folder of the built front end; a source checkout builds it if it is not there.

    Raises:
        BackendError: it is not there and cannot be built; the message says what is missing.
    """
    if not _complete(STATIC):
        build()
    return STATIC


def build() -> None:
    """Build the front end of a source checkout with npm, by its lock file.

    Raises:
        BackendError: this is no checkout, npm is missing, or the build failed.
    """
    if not (SOURCE / "package-lock.json").is_file():
        raise BackendError(
            f"The web pages are missing from {STATIC}, and this is no source checkout that could "
            "build them. Install tabletopgen again."
        )
    npm = shutil.which("npm")
    if npm is None:
        raise BackendError(
            "The web pages of a source checkout are built once, by npm, which is not installed. "
            "Install Node.js 20 or newer, or install tabletopgen from a wheel."
        )
    with FileLock(SOURCE / "node_modules.lock"):  # two processes may need it at once
        if _complete(STATIC):
            return
        for step in (["ci", "--no-audit", "--no-fund"], ["run", "build"]):
            _run([npm, *step])
    if not _complete(STATIC):
        raise BackendError(f"npm built no pages in {STATIC}. Run `make web` to see why.")


def _run(command: list[str]) -> None:
    try:
        done = subprocess.run(
            command, cwd=SOURCE, capture_output=True, text=True, timeout=_SECONDS, check=False
        )
    except (OSError, subprocess.TimeoutExpired) as error:
        raise BackendError(
            f"The web pages cannot be built: {error}. Run `make web` to see why."
        ) from error
    if done.returncode:
        said = (done.stderr or done.stdout).strip().splitlines() or ["no output"]
        raise BackendError(
            f"The web pages cannot be built: npm {command[1]} says {said[0]!r}. Run `make web` to "
            "see all of it."
        )


def _complete(folder: Path) -> bool:
    return all((folder / page).is_file() for page in PAGES)
