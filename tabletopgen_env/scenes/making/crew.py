"""Processes that make scenes in the background.

Each is a Python of its own that is given recipes through its standard input (``worker``). It is no
``multiprocessing`` process: those start the user's script anew in every child, and must not be
started inside the daemonic processes in which vector environments run. It ends with the process
that started it, however that ends, and takes the folder of unfinished and finished scenes along.
"""

from __future__ import annotations

import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import weakref
from collections import deque
from dataclasses import dataclass, field
from pathlib import Path

from generator.errors import StorageError

from . import answer
from .recipe import Recipe

PATIENCE = 1800.0
"""Seconds after which a scene that is not done is given up."""

LONGEST_REST = 300.0
"""Longest pause after failures in a row, seconds."""

_ALONE = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")


@dataclass(frozen=True)
class Made:
    """A scene that is done: its bundle, alone in a folder of the crew's, and how hard it is."""

    recipe: Recipe
    bundle: Path
    difficulty: float


@dataclass(frozen=True)
class Failed:
    """A scene that is not to be had, and why."""

    recipe: Recipe
    reason: str


@dataclass(eq=False)
class _Seat:
    """A place for one process, and the job it has."""

    number: int
    process: subprocess.Popen[bytes] | None = None
    recipe: Recipe | None = None
    folder: Path = Path()
    since: float = 0.0


@dataclass(eq=False)
class _Held:
    """What must not outlive the crew."""

    folder: Path
    owner: int = field(default_factory=os.getpid)
    processes: set[subprocess.Popen[bytes]] = field(default_factory=set)


class Crew:
    """``count`` processes that make scenes; nothing here ever waits for them.

    Args:
        count: how many scenes are made at a time.
        rest: pause after a failure, seconds; it doubles with each further one in a row.
        patience: seconds after which a scene that is not done is given up.

    Raises:
        StorageError: there is no place for temporary files.
    """

    def __init__(self, count: int, *, rest: float = 0.5, patience: float = PATIENCE) -> None:
        try:
            self._held = _Held(Path(tempfile.mkdtemp(prefix="tabletopgen-")))
        except OSError as error:
            raise StorageError(
                f"No temporary folder for new scenes: {error.strerror or error}. Set TMPDIR."
            ) from error
        self._seats = [_Seat(k) for k in range(count)]
        self._waiting: deque[Recipe] = deque()
        self._jobs = 0
        self._rest, self._patience = rest, patience
        self._in_a_row = 0
        self._resting_until = 0.0
        self._finalizer = weakref.finalize(self, _end, self._held)

    @property
    def folder(self) -> Path:
        """Where scenes are made."""
        return self._held.folder

    @property
    def pids(self) -> tuple[int, ...]:
        """The process ids that are at work or waiting for it."""
        return tuple(p.pid for p in self._held.processes if p.poll() is None)

    @property
    def open(self) -> int:
        """How many recipes are waiting or being made."""
        return len(self._waiting) + sum(seat.recipe is not None for seat in self._seats)

    def order(self, recipe: Recipe) -> None:
        """Have a scene made, in its turn."""
        self._waiting.append(recipe)

    def collect(self) -> list[Made | Failed]:
        """Return what has ended since the last call, and give out what waits."""
        ended = [end for seat in self._seats if (end := self._look(seat)) is not None]
        self._count(ended)
        if time.monotonic() >= self._resting_until:
            for seat in self._seats:
                if seat.recipe is None and self._waiting:
                    self._give(seat, self._waiting.popleft())
        return ended

    def _count(self, ended: list[Made | Failed]) -> None:
        """Count failures in a row, and rest after one."""
        for end in ended:
            self._in_a_row = self._in_a_row + 1 if isinstance(end, Failed) else 0
        if ended and self._in_a_row:
            rest = min(self._rest * 2.0 ** (self._in_a_row - 1), LONGEST_REST)
            self._resting_until = time.monotonic() + rest

    def close(self) -> None:
        """End the processes and remove what they have made. May be called twice."""
        self._waiting.clear()
        self._finalizer()

    # -------------------------------------------------------------------------------- one process

    def _give(self, seat: _Seat, recipe: Recipe) -> None:
        """Give a process its next job, starting it if it is not running."""
        seat.recipe, seat.since = recipe, time.monotonic()
        seat.folder = self.folder / f"{self._jobs:06d}"
        self._jobs += 1
        job = json.dumps({"recipe": recipe.to_json(), "folder": seat.folder.name})
        if seat.process is not None and seat.process.poll() is not None:
            self._dismiss(seat, seat.process)  # it died while it had nothing to do
        with contextlib.suppress(OSError):  # it cannot start, or has just died: see ``_look``
            if seat.process is None:
                seat.process = _start(self.folder, self._log(seat))
                self._held.processes.add(seat.process)
            assert seat.process.stdin is not None
            seat.process.stdin.write(f"{job}\n".encode())

    def _look(self, seat: _Seat) -> Made | Failed | None:
        """Return how a process's job ended, None while it has not."""
        process, recipe = seat.process, seat.recipe
        if recipe is None:
            return None
        if process is None:
            seat.recipe = None
            return Failed(recipe, "no process could be started to make it")
        code = process.poll()
        end = _answered(recipe, seat.folder)
        late = time.monotonic() - seat.since > self._patience
        if end is None and code is None and not late:
            return None
        if code is not None or (end is None and late):
            self._dismiss(seat, process)
        if end is None:
            what = f"was given up after {self._patience:g} s" if code is None else _died(code)
            end = Failed(recipe, f"the process that made it {what}{_last_words(self._log(seat))}")
        if isinstance(end, Failed):
            shutil.rmtree(seat.folder, ignore_errors=True)
        seat.recipe = None
        return end

    def _dismiss(self, seat: _Seat, process: subprocess.Popen[bytes]) -> None:
        """Part with a process; the next job gets a new one."""
        _kill(process)
        self._held.processes.discard(process)
        seat.process = None

    def _log(self, seat: _Seat) -> Path:
        return self.folder / f"{seat.number}.log"


def _start(folder: Path, log: Path) -> subprocess.Popen[bytes]:
    """Start a process that works in ``folder``, finds the same modules, and minds no Ctrl-C."""
    path = os.pathsep.join(entry or str(Path.cwd()) for entry in sys.path)
    folder.mkdir(exist_ok=True)  # who cleans temporary folders may have taken it
    lone = {name: os.environ.get(name, "1") for name in _ALONE}
    with log.open("wb") as errors:
        return subprocess.Popen(
            [sys.executable, "-P", "-m", "tabletopgen_env.scenes.making.worker", str(folder)],
            stdin=subprocess.PIPE, stdout=subprocess.DEVNULL, stderr=errors, bufsize=0,
            env={**os.environ, **lone, "PYTHONPATH": path}, start_new_session=True,
        )  # fmt: skip


def _answered(recipe: Recipe, folder: Path) -> Made | Failed | None:
    """Read the answer to a job, None if there is none yet."""
    try:
        said = answer.given(folder)
    except FileNotFoundError:
        return None
    except (OSError, ValueError) as error:
        return Failed(recipe, f"its answer cannot be read: {error}")
    if "error" in said:
        return Failed(recipe, str(said["error"]))
    name, hard = str(said["bundle"]), float(said["difficulty"])
    return Made(recipe, folder / name, hard)


def _died(code: int) -> str:
    if code >= 0:
        return f"ended with code {code}"
    with contextlib.suppress(ValueError):
        return f"was killed ({signal.Signals(-code).name})"
    return f"was killed (signal {-code})"


def _last_words(log: Path) -> str:
    """Return the last line that a process wrote to its standard error."""
    with contextlib.suppress(OSError):
        lines = log.read_text(errors="replace").split("\n")
        said = [line.strip() for line in lines if line.strip()]
        return f": {said[-1][:300]}" if said else ""
    return ""


def _kill(process: subprocess.Popen[bytes]) -> None:
    """Kill a process and what it has started, which are a session of their own."""
    if process.poll() is None:
        if hasattr(os, "killpg"):
            with contextlib.suppress(OSError):
                os.killpg(process.pid, signal.SIGKILL)
        process.kill()
    if process.stdin is not None:
        with contextlib.suppress(OSError):
            process.stdin.close()
    process.wait()


def _end(held: _Held) -> None:
    """End a crew; a forked copy of it only lets go of its ends of the pipes."""
    if os.getpid() != held.owner:
        for process in held.processes:
            if process.stdin is not None:
                process.stdin.close()
            process.returncode = 0  # another process's child: nothing to wait for
        return
    for process in held.processes:
        _kill(process)
    held.processes.clear()
    shutil.rmtree(held.folder, ignore_errors=True)
