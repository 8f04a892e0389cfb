"""The process of one job: the order that it receives, its messages, and its end.

The process receives one line of JSON and sends lines of JSON. It ends when its standard input is
closed, which also happens if the server is killed. It runs in a new session, so its children end
with it.
"""

from __future__ import annotations

import asyncio
import contextlib
import json
import os
import signal
import sys
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from generator.calls.http.redaction import redact
from generator.errors import BackendError, TabletopError, escape
from generator.io.bounded import parse_object

MODULE = "tabletopgen_web.studio.worker"
"""Module that the process runs."""

GRACE = 10.0
"""Seconds between the cancellation of a job and the kill of its process."""

_MAX_LINE = 2**20  # maximum size of a message, bytes
_MAX_CHARACTERS = 500  # maximum length of a log line, characters
_MAX_LINES = 400  # maximum number of log lines of one run
_PIECE = 8192
_AFTER = 5.0  # seconds that pipes may stay open after the process has ended


@dataclass(frozen=True)
class JobEnding:
    """A process's return ``code`` (see ``subprocess``), and whether it timed out (``late``)."""

    code: int
    late: bool = False

    def describe(self) -> str:
        """Return a description of a process that ended without a result."""
        if self.late:
            return "The job took too long and was stopped."
        if self.code == -signal.SIGKILL:
            return "The job's process was killed; the machine may be short of memory."
        if self.code < 0:
            return f"The job's process crashed with signal {-self.code}."
        return f"The job's process ended with code {self.code} and without a result; see its log."


class JobProcess:
    """A process that runs one job and forwards the job's messages.

    Args:
        order: the order for the process.
        heard: called with each message of the process.
        logged: called with each other line of output, with secrets removed.
    """

    def __init__(
        self,
        order: Mapping[str, Any],
        heard: Callable[[dict[str, Any]], None],
        logged: Callable[[str], None] = lambda text: None,
    ) -> None:
        self._order, self._heard, self._logged = order, heard, logged
        self._process: asyncio.subprocess.Process | None = None
        self._failure: TabletopError | None = None
        self._ending: asyncio.Task[None] | None = None
        self.cancelled = False

    async def run(self, seconds: float | None = None) -> JobEnding:
        """Run the job until it ends, or until ``seconds`` have passed.

        Raises:
            BackendError: the process cannot be started, or sends an invalid message.
            TabletopError: raised by ``heard`` or ``logged``; the process was stopped.
        """
        process = await self._start()
        late = False
        reading = asyncio.gather(self._listen(process), self._read_log(process))
        try:
            async with asyncio.timeout(seconds):
                await process.wait()
        except TimeoutError:
            late = True
        finally:
            _kill(process)  # remaining processes of its session, if any
            await process.wait()
            with contextlib.suppress(TimeoutError):
                await asyncio.wait_for(reading, _AFTER)
            if process.stdin is not None:
                process.stdin.close()
            if self._ending is not None:
                self._ending.cancel()
        if self._failure is not None:
            raise self._failure
        assert process.returncode is not None
        return JobEnding(process.returncode, late)

    def cancel(self) -> None:
        """Request the end of the process, and kill it after the grace period."""
        self.cancelled = True
        if self._process is not None and self._ending is None:
            self._ending = asyncio.create_task(self._end(self._process))

    async def _start(self) -> asyncio.subprocess.Process:
        path = os.pathsep.join(entry or str(Path.cwd()) for entry in sys.path)
        try:
            self._process = await asyncio.create_subprocess_exec(
                sys.executable, "-P", "-m", MODULE,
                stdin=asyncio.subprocess.PIPE, stdout=asyncio.subprocess.PIPE,
                stderr=asyncio.subprocess.PIPE, start_new_session=True, limit=_MAX_LINE,
                env={**os.environ, "PYTHONPATH": path},
            )  # fmt: skip
        except OSError as error:
            raise BackendError(
                f"No process can be started for the job: {error.strerror or error}. Try again "
                f"when the machine is less busy."
            ) from error
        assert self._process.stdin is not None
        with contextlib.suppress(ConnectionError):  # it has already ended
            self._process.stdin.write(json.dumps(self._order).encode() + b"\n")
            await self._process.stdin.drain()
        if self.cancelled:
            self.cancel()
        return self._process

    async def _end(self, process: asyncio.subprocess.Process) -> None:
        with contextlib.suppress(ProcessLookupError):
            process.send_signal(signal.SIGINT)
        await asyncio.sleep(GRACE)
        _kill(process)

    async def _listen(self, process: asyncio.subprocess.Process) -> None:
        assert process.stdout is not None
        try:
            while line := await process.stdout.readline():
                self._heard(parse_object(line, "The message of the job's process", BackendError))
        except TabletopError as error:
            self._give_up(process, error)
        except (ValueError, TypeError, KeyError):  # too long, or not a known message
            self._give_up(process, BackendError("The job's process sent an invalid message."))

    async def _read_log(self, process: asyncio.subprocess.Process) -> None:
        assert process.stderr is not None
        rest, count = b"", 0
        while piece := await process.stderr.read(_PIECE):
            *lines, rest = (rest + piece).replace(b"\r", b"\n").split(b"\n")
            rest = rest[-_PIECE:]
            for line in lines:
                count += self._log(process, line, count)
        self._log(process, rest, count)

    def _log(self, process: asyncio.subprocess.Process, line: bytes, count: int) -> bool:
        text = escape(redact(line.decode("utf-8", "replace"), _secrets())).strip()[:_MAX_CHARACTERS]
        if not text or count > _MAX_LINES:
            return False
        if count == _MAX_LINES:
            text = "(further lines are omitted)"
        try:
            self._logged(text + "\n")
        except TabletopError as error:
            self._give_up(process, error)
        return True

    def _give_up(self, process: asyncio.subprocess.Process, error: TabletopError) -> None:
        if self._failure is None:
            self._failure = error
        _kill(process)


def _secrets() -> list[str]:
    """Return the values of environment variables whose names suggest that they are secret."""
    marks = ("KEY", "SECRET", "TOKEN", "PASSWORD")
    return [v for k, v in os.environ.items() if any(m in k.upper() for m in marks) and len(v) > 7]


def _kill(process: asyncio.subprocess.Process) -> None:
    """Kill a process and the other processes in its session."""
    with contextlib.suppress(ProcessLookupError, PermissionError):
        os.killpg(process.pid, signal.SIGKILL)
