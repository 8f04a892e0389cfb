"""Sandbox children forked from the worker, which has already imported their modules.

A child that starts anew imports for a second of processor time what it uses for a few milliseconds.
A forked one runs the same code behind the same pipes and under the same limits.
"""

import contextlib
import importlib
import os
import signal
import subprocess
import sys
import time
import traceback
from collections.abc import Callable, Iterator, Mapping
from typing import IO, Any

from generator.sandbox import SandboxLimits, child, runner

PRELOADED = (
    "mujoco", "trimesh", "scipy.spatial", "generator.imports.folder", "generator.imports.glb",
    "generator.imports.mjcf", "generator.imports.reader", "generator.meshes.reading.codecs",
    "generator.pictures.decoder",
)  # fmt: skip


def preload() -> None:
    """Import the modules of the sandbox's children."""
    for name in PRELOADED:
        importlib.import_module(name)


@contextlib.contextmanager
def forked_children() -> Iterator[None]:
    """Make the sandbox fork its children from this process within the context."""
    preload()
    started = runner._child

    @contextlib.contextmanager
    def fork_child(limits: SandboxLimits) -> Iterator[Any]:
        threads = {str(name): str(limits.threads) for name in runner._THREADS if limits.threads}
        process = Forked(_answer_request, threads)
        try:
            yield process
        finally:
            runner._kill(process)  # type: ignore[arg-type]

    runner._child = fork_child
    try:
        yield
    finally:
        runner._child = started


def _answer_request() -> None:
    """Answer one request as the child of a sandbox."""
    runner.is_inside = lambda: True
    child.main()


class Forked:
    """A forked process with pipes for its standard streams; the part of ``Popen`` that is used."""

    def __init__(self, main: Callable[[], object], environment: Mapping[str, str]) -> None:
        """Fork, and call ``main`` in the child with additional environment variables."""
        pipes = [os.pipe() for _ in range(3)]
        sys.stdout.flush()
        sys.stderr.flush()
        self.pid = os.fork()
        if self.pid == 0:
            code = 1
            try:
                os.setsid()
                for number, pipe in enumerate(pipes):
                    os.dup2(pipe[min(number, 1)], number)
                os.closerange(3, max(map(max, pipes)) + 1)
                signal.signal(signal.SIGINT, signal.SIG_DFL)
                os.environ.update(environment)
                main()
                code = 0
            except BaseException:  # no code of the parent may continue in the child
                os.write(2, traceback.format_exc().encode(errors="replace"))
            finally:
                os._exit(code)
        (given, send), (answers, answer), (words, word) = pipes
        for end in (given, answer, word):
            os.close(end)
        self.stdin: IO[bytes] = os.fdopen(send, "wb", buffering=0)
        self.stdout: IO[bytes] = os.fdopen(answers, "rb", buffering=0)
        self.stderr: IO[bytes] = os.fdopen(words, "rb", buffering=0)
        self.returncode: int | None = None

    def poll(self) -> int | None:
        """Return the exit code as ``Popen`` does, None while the process runs."""
        if self.returncode is None:
            pid, status = os.waitpid(self.pid, os.WNOHANG)
            if pid:
                self.returncode = os.waitstatus_to_exitcode(status)
        return self.returncode

    def wait(self, timeout: float = 100.0) -> int:
        """Wait for the end; return the exit code as ``Popen`` has it.

        Raises:
            subprocess.TimeoutExpired: the process has not ended after ``timeout`` seconds.
        """
        end = time.monotonic() + timeout
        while (code := self.poll()) is None:
            if time.monotonic() > end:
                raise subprocess.TimeoutExpired("a forked process", timeout)
            time.sleep(0.001)
        return code

    def communicate(self, timeout: float) -> tuple[int, bytes, bytes]:
        """Return the exit code and all output; errors must fit into a pipe."""
        self.stdin.close()
        with self.stdout, self.stderr:
            out, err = self.stdout.read(), self.stderr.read()
        return self.wait(timeout), out, err
