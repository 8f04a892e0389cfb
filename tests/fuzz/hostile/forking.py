"""Children of the sandbox forked from the worker, which has imported what they need.

A child that starts anew imports for a second of processor time what it uses for a few milliseconds.
A forked one runs the same code behind the same pipes and under the same limits.
"""

import contextlib
import importlib
import os
import signal
import sys
import traceback
from collections.abc import Callable, Iterator, Mapping
from typing import IO, Any

from generator.sandbox import SandboxLimits, child, running

PRELOADED = (
    "mujoco", "trimesh", "scipy.spatial", "generator.imports.folder", "generator.imports.glb",
    "generator.imports.mjcf", "generator.imports.reading", "generator.meshes.reading.codecs",
    "generator.pictures.decoding",
)  # fmt: skip


@contextlib.contextmanager
def forked_children() -> Iterator[None]:
    """Have the sandbox fork its children from this process in the meantime."""
    for name in PRELOADED:
        importlib.import_module(name)
    started = running._child

    @contextlib.contextmanager
    def fork_child(limits: SandboxLimits) -> Iterator[Any]:
        threads = dict.fromkeys(running._THREADS, str(limits.threads)) if limits.threads else {}
        process = Forked(child.main, {**threads, running.INSIDE: "1"})
        try:
            yield process
        finally:
            running._kill(process)  # type: ignore[arg-type]

    running._child = fork_child
    try:
        yield
    finally:
        running._child = started


class Forked:
    """A forked process with pipes for its standard streams; the part of ``Popen`` that is used."""

    def __init__(self, main: Callable[[], object], environment: Mapping[str, str]) -> None:
        """Fork, and call ``main`` in the child, with these environment variables more."""
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
            except BaseException:  # nothing of the parent may run on in the child
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
        """Return the exit code as ``Popen`` has it, None while the process runs."""
        return self._reap(os.WNOHANG)

    def wait(self) -> int:
        """Wait for the end; return the exit code as ``Popen`` has it."""
        code = self._reap(0)
        assert code is not None
        return code

    def communicate(self) -> tuple[int, bytes, bytes]:
        """Return the exit code and all that is written; errors are to fit into a pipe."""
        self.stdin.close()
        with self.stdout, self.stderr:
            out, err = self.stdout.read(), self.stderr.read()
        return self.wait(), out, err

    def _reap(self, options: int) -> int | None:
        if self.returncode is None:
            pid, status = os.waitpid(self.pid, options)
            if pid:
                self.returncode = os.waitstatus_to_exitcode(status)
        return self.returncode
