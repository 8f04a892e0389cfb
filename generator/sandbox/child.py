"""The child process of a sandbox, run as ``python -m generator.sandbox.child``; see ``runner``.

It reads one request from standard input, applies its limits, and writes the packed result to its
original standard output.
"""

from __future__ import annotations

import ctypes
import errno
import importlib
import math
import os
import signal
import sys
import tempfile
import time
from pathlib import Path
from typing import Any

from ..errors import TabletopError
from .runner import NO_MEMORY, failure_text, memory_text
from .serialization import packed_parts, unpack

_DIES_WITH_PARENT = 1  # PR_SET_PDEATHSIG


def main() -> None:
    """Process one request."""
    try:
        _serve()
    except MemoryError:
        os._exit(NO_MEMORY)
    os._exit(0)  # skips the exit handlers of libraries that have parsed untrusted data


def _serve() -> None:
    given, answers = os.fdopen(os.dup(0), "rb"), os.fdopen(os.dup(1), "wb")
    with Path(os.devnull).open("rb") as nothing:
        os.dup2(nothing.fileno(), 0)
    os.dup2(2, 1)  # output printed by libraries must not mix with the result
    request = unpack(given.read(), _find)
    _leave_with(int(request["parent"]))
    function = _find(f"{request['module']}:{request['name']}")
    _work_nowhere()
    memory = int(request["memory"])
    # mentions the inherited limit, so it is computed before ours is set
    too_large = memory_text(memory)
    _limit(float(request["cpu_seconds"]), memory)
    for part in _answer(function, request["args"], too_large):
        answers.write(part)
    answers.flush()


def _answer(function: Any, args: tuple[Any, ...], too_large: str) -> list[bytes | memoryview]:
    """Return the function's result or exception, packed in chunks of bytes.

    ``too_large`` is the message for insufficient memory.
    """
    start = time.process_time()
    try:
        result = function(*args)
        return packed_parts({"result": result, "cpu": time.process_time() - start})
    except TabletopError as error:
        name, message = type(error).__name__, str(error.args[0]) if error.args else ""
        breach = ""
    except Exception as error:  # any exception of a parser on an untrusted file
        name, words = type(error).__name__, " ".join(str(error).split())[:300]
        breach = "memory" if _lacks_memory(error) else "parser"
        text = failure_text(f"{name}: {words}", "is damaged", too_large)
        message = too_large if breach == "memory" else text
    return packed_parts({
        "error": name, "message": message, "breach": breach, "cpu": time.process_time() - start,
    })  # fmt: skip


def _lacks_memory(error: BaseException | None) -> bool:
    """Return whether an error, or one of its causes, is due to insufficient memory."""
    seen: set[int] = set()
    while error is not None and id(error) not in seen:
        seen.add(id(error))
        no_room = isinstance(error, OSError) and error.errno == errno.ENOMEM
        if isinstance(error, MemoryError) or no_room:
            return True
        error = error.__cause__ or error.__context__
    return False


def _find(name: str) -> Any:
    """Return the class or function ``name`` ("module:name") that the parent process requests."""
    module, _, path = name.partition(":")
    found: Any = importlib.import_module(module)
    for part in path.split("."):
        found = getattr(found, part)
    return found


def _leave_with(parent: int) -> None:
    """Have the kernel kill this process when its parent dies (only on Linux)."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(_DIES_WITH_PARENT, int(signal.SIGKILL))
        if os.getppid() != parent:
            os._exit(1)


def _work_nowhere() -> None:
    """Change to a deleted working directory, in which no files can be created."""
    folder = tempfile.mkdtemp()
    os.chdir(folder)
    Path(folder).rmdir()


def _limit(cpu_seconds: float, memory: int) -> None:
    """Apply the limits, unless smaller inherited limits are in place."""
    import resource

    used = resource.getrusage(resource.RUSAGE_SELF)
    _limit_time(math.ceil(used.ru_utime + used.ru_stime + cpu_seconds))
    _lower(resource.RLIMIT_CORE, 0)
    _lower(resource.RLIMIT_FSIZE, 0)
    statm = Path("/proc/self/statm")
    if statm.is_file():
        pages = int(statm.read_text().split()[0])
        _lower(resource.RLIMIT_AS, pages * resource.getpagesize() + memory)


def _limit_time(seconds: int) -> None:
    """Limit the CPU time.

    The hard limit is higher than the soft one, because its SIGKILL is ambiguous, while the soft
    limit's SIGXCPU is not.
    """
    import resource

    soft, hard = resource.getrlimit(resource.RLIMIT_CPU)
    signal.signal(signal.SIGXCPU, signal.SIG_DFL)
    top = _least(seconds + 1, hard)
    resource.setrlimit(resource.RLIMIT_CPU, (max(1, min(_least(seconds, soft), top - 1)), top))


def _lower(kind: int, limit: int) -> None:
    import resource

    least = _least(limit, *resource.getrlimit(kind))
    resource.setrlimit(kind, (least, least))


def _least(limit: int, *inherited: int) -> int:
    import resource

    return min([limit, *(value for value in inherited if value != resource.RLIM_INFINITY)])


if __name__ == "__main__":
    main()
