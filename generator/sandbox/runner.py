"""The parent's side of a sandbox: starts a child, enforces its limits and decodes its result."""

from __future__ import annotations

import contextlib
import math
import os
import selectors
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, Literal

from .. import errors
from ..errors import InputError, TabletopError, require
from .serialization import class_name, pack, unpack

Breach = Literal["time", "memory", "output", "hung", "killed", "crash", "cancelled", "parser"]
"""The reason why a child returned nothing: it reached a limit, was killed from outside (such as by
a kernel that runs out of memory), died, was cancelled, or a parser raised its own exception. The
reason is never derived from an error message.
"""

NO_MEMORY = 77
"""Exit code of a child that ran out of memory outside of its function."""

_CHILD = f"{__package__}.child"  # the child's module
_THREADS = ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS", "NUMEXPR_NUM_THREADS")
_HUNG = 60.0, 20.0  # seconds until a child counts as hung, plus a factor on its CPU time limit
_ENDING = 30.0  # seconds that a child has to exit after closing its pipes
_LEAST_SECONDS = 0.05  # CPU time of a call after its budget is used up
_POLL = 0.2  # seconds between checks of ``cancelled``
_CHUNK = 1 << 20
_LAST_WORDS = 4096  # bytes of standard error that are kept


@dataclass(frozen=True)
class SandboxLimits:
    """Limits of one child process; smaller limits inherited from the parent take precedence.

    Attributes:
        cpu_seconds: CPU time of the call, excluding imports.
        memory: bytes that the call may allocate in addition to the imported modules.
        output: bytes of the packed result.
        threads: threads of the numeric libraries; None leaves them to the environment.

    Raises:
        InputError: a limit is not a positive number.
    """

    cpu_seconds: float = 20.0
    memory: int = 3 * 2**29
    output: int = 2**29
    threads: int | None = 1

    def __post_init__(self) -> None:
        require(self, "cpu_seconds", above=0)
        require(self, "memory", "output", minimum=1, integer=True)


class SandboxError(InputError):
    """Raised if a sandboxed child process returns no result; ``breach`` is the reason.

    The message continues a sentence about the input: "takes more than 20 s of CPU time". Callers
    raise their own kind of error from it.
    """

    def __init__(self, breach: Breach, message: str) -> None:
        super().__init__(message)
        self.breach: Breach = breach


def call(
    function: Callable[..., Any],
    *args: object,
    limits: SandboxLimits | None = None,
    returns: Iterable[type] = (),
    cancelled: threading.Event | None = None,
    budget: CpuBudget | None = None,
) -> Any:
    """Return ``function(*args)``, computed in a child process with limits.

    ``function`` is a module-level function; its arguments and its result are values that
    ``serialization`` supports, and ``returns`` lists the dataclasses and enums that the result may
    contain. Arrays of the result are read-only. This project's errors are raised again in this
    process. Setting ``cancelled`` from another thread kills the child. The call may use the CPU
    time left in ``budget``, which is charged. Within a child the function is called directly.

    Raises:
        SandboxError: a limit is reached, the child dies, or the function raises another exception.
    """
    budget = budget or CpuBudget(math.inf)
    if is_inside():
        start = time.process_time()
        try:
            return function(*args)
        finally:
            budget.charge(time.process_time() - start)
    limits = limits or SandboxLimits()
    seconds = max(min(limits.cpu_seconds, budget.left), _LEAST_SECONDS)
    limits = replace(limits, cpu_seconds=seconds)
    request = pack({
        "module": function.__module__, "name": function.__qualname__, "args": args,
        "cpu_seconds": limits.cpu_seconds, "memory": limits.memory, "parent": os.getpid(),
    })  # fmt: skip
    with _child(limits) as process:
        raw, words, breach = _exchange(process, request, limits, cancelled)
        breach = breach or _await_end(process)
        code = process.wait(0) if breach is None else _kill(process)
    if breach is not None or code or not raw:
        budget.charge(seconds)
        raise _explain(breach, code, words, limits)
    return _result(raw, returns, budget)


def is_inside() -> bool:
    """Return whether this process is a sandbox child, judged by its main module."""
    spec = getattr(sys.modules.get("__main__"), "__spec__", None)
    return spec is not None and spec.name == _CHILD


def _result(raw: bytes | memoryview, returns: Iterable[type], budget: CpuBudget) -> Any:
    expected = {class_name(kind): kind for kind in returns}

    def find_class(name: str) -> type:
        if name not in expected:
            raise ValueError(f"the class {name!r} is not one of the expected classes")
        return expected[name]

    try:
        answer = unpack(raw, find_class)
        budget.charge(float(answer["cpu"]))
        if "result" in answer:
            return answer["result"]
        kind, message, breach = answer["error"], str(answer["message"]), answer["breach"]
    except (ValueError, KeyError, TypeError) as error:
        # a value that the constructor of the result's class rejects
        if isinstance(error, TabletopError):
            raise
        raise SandboxError("crash", f"crashes its parser ({error})") from error
    if breach:
        raise SandboxError("memory" if breach == "memory" else "parser", message)
    raised = getattr(errors, kind, None)
    if not (isinstance(raised, type) and issubclass(raised, TabletopError)):
        raise SandboxError("crash", f"crashes its parser ({kind}: {message})")
    raise raised(message)


@contextlib.contextmanager
def _child(limits: SandboxLimits) -> Any:
    """Run a child process with this process's module search path, and kill it on exit."""
    path = os.pathsep.join(entry or str(Path.cwd()) for entry in sys.path)
    alone = dict.fromkeys(_THREADS, str(limits.threads)) if limits.threads else {}
    try:
        process = subprocess.Popen(
            [sys.executable, "-P", "-m", _CHILD],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, bufsize=0,
            env={**os.environ, **alone, "PYTHONPATH": path},
            start_new_session=True,  # an interrupt ends the parent, which ends the child
        )  # fmt: skip
    except OSError as error:
        reason = error.strerror or error
        raise SandboxError(
            "crash", f"cannot be read, because no process could be started ({reason})"
        ) from error
    try:
        yield process
    finally:
        _kill(process)


def _await_end(process: subprocess.Popen[bytes]) -> Breach | None:
    """Wait until a child that has closed its pipes exits; return "hung" if it does not."""
    try:
        process.wait(_ENDING)
    except subprocess.TimeoutExpired:
        return "hung"
    return None


def _kill(process: subprocess.Popen[bytes]) -> int:
    if process.poll() is None:
        with contextlib.suppress(OSError):
            os.killpg(process.pid, signal.SIGKILL)
    code = process.wait()
    for pipe in (process.stdin, process.stdout, process.stderr):
        if pipe is not None:
            with contextlib.suppress(OSError):
                pipe.close()
    return code


def _exchange(
    process: subprocess.Popen[bytes],
    request: bytes,
    limits: SandboxLimits,
    cancelled: threading.Event | None,
) -> tuple[bytes | memoryview, bytes, Breach | None]:
    """Send the request; return the result, the end of standard error, and a reason for failure."""
    assert process.stdin and process.stdout and process.stderr
    end = time.monotonic() + _HUNG[0] + _HUNG[1] * limits.cpu_seconds
    left, answer, words = memoryview(request), bytearray(), b""
    for pipe in (process.stdin, process.stdout, process.stderr):
        os.set_blocking(pipe.fileno(), False)
    with selectors.DefaultSelector() as selector:
        selector.register(process.stdin, selectors.EVENT_WRITE)
        selector.register(process.stdout, selectors.EVENT_READ)
        selector.register(process.stderr, selectors.EVENT_READ)
        while selector.get_map():
            if cancelled is not None and cancelled.is_set():
                return b"", words, "cancelled"
            if time.monotonic() > end:
                return b"", words, "hung"
            for key, _ in selector.select(_POLL):
                pipe = key.fileobj
                if pipe is process.stdin:
                    left = _write(process, left)
                    if not left:
                        selector.unregister(pipe)
                        process.stdin.close()
                    continue
                chunk = os.read(key.fd, _CHUNK)
                if not chunk:
                    selector.unregister(pipe)
                elif pipe is process.stderr:
                    words = (words + chunk)[-_LAST_WORDS:]
                else:
                    answer += chunk
                    if len(answer) > limits.output:
                        return b"", words, "output"
    return memoryview(answer).toreadonly(), words, None


def _write(process: subprocess.Popen[bytes], left: memoryview) -> memoryview:
    """Write as much as the pipe accepts; return the rest, which is empty if the child closed it."""
    assert process.stdin is not None
    try:
        return left[os.write(process.stdin.fileno(), left[:_CHUNK]) :]
    except BlockingIOError:
        return left
    except BrokenPipeError:
        return left[:0]


def _explain(breach: Breach | None, code: int, words: bytes, limits: SandboxLimits) -> SandboxError:
    seconds = f"{limits.cpu_seconds:g} s of CPU time"
    if breach == "output":
        return SandboxError("output", f"contains more than {limits.output >> 20} MiB of data")
    if breach == "hung":
        return SandboxError("hung", f"blocks its parser without using {seconds}")
    if breach == "cancelled":
        return SandboxError("cancelled", "was cancelled")
    if code == -signal.SIGXCPU:  # the soft limit, which is lower than the hard limit
        return SandboxError("time", _time_text(seconds))
    if code == -signal.SIGKILL:
        reason = "the system killed its parser, as happens when memory runs out"
        return SandboxError("killed", f"cannot be read here: {reason}")
    if code == NO_MEMORY:
        return SandboxError("memory", memory_text(limits.memory))
    last = words.decode(errors="replace").strip().splitlines()[-1:]
    text = last[0][:300] if last else _name_of(code)
    return SandboxError(
        "crash", failure_text(text, "crashes its parser", memory_text(limits.memory))
    )


def failure_text(words: str, what: str, too_large: str) -> str:
    """Return the error message ``what`` or ``too_large``, depending on the parser's ``words``.

    C++ libraries report insufficient memory only in words ("std::bad_alloc"). The words affect only
    this message; the breach stays "parser" or "crash".
    """
    signs = ("MemoryError", "bad_alloc", "llocat", "failed to map")
    return too_large if any(sign in words for sign in signs) else f"{what} ({words})"


def memory_text(memory: int) -> str:
    """Return the message for inputs that exceed ``memory`` bytes or an inherited memory limit."""
    import resource

    return _excess(
        f"{memory / 2**30:.3g} GiB of memory", resource.RLIMIT_AS,
        lambda limit: f"is left of the {limit / 2**30:.3g} GiB that 'ulimit -v' allows",
    )  # fmt: skip


def _time_text(seconds: str) -> str:
    import resource

    return _excess(
        seconds, resource.RLIMIT_CPU, lambda limit: f"the {limit} s that 'ulimit -t' allows"
    )


def _excess(limit: str, kind: int, inherited: Callable[[int], str]) -> str:
    """Return the message for an input that exceeds a limit; it also names any inherited limit."""
    import resource

    soft = resource.getrlimit(kind)[0]
    text = f"takes more than {limit}"
    return text if soft == resource.RLIM_INFINITY else f"{text}, or than {inherited(soft)}"


def _name_of(code: int) -> str:
    try:
        return signal.Signals(-code).name if code < 0 else f"exit code {code}"
    except ValueError:
        return f"exit code {code}"


@dataclass
class CpuBudget:
    """CPU time in seconds left for all calls that process one input, such as a folder's files.

    A call that ends at a limit, or in a crash, is charged its whole limit. The budget decides
    whether another call is made, never what a call returns.
    """

    left: float

    def charge(self, seconds: float) -> None:
        """Subtract the time of a call from the remaining budget."""
        self.left = max(0.0, self.left - seconds)
