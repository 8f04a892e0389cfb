"""The process of one job: ``python -m tabletopgen_web.studio.worker``, started by the server.

It reads its order, a line of JSON, from standard input, and writes lines of JSON to standard
output: stages, figures, then a result or an error. All other output goes to standard error. It ends
as soon as its input is closed, so it never outlives the server.
"""

from __future__ import annotations

import os
import signal
import sys
import threading
import traceback
from collections.abc import Mapping
from pathlib import Path
from typing import Any, BinaryIO

from generator.errors import PlaceError, TabletopError
from generator.io.bounded import parse_object

from .specs import ComposeSpec, EditSpec, EpisodeSpec, ExportSpec, GenerateSpec, read_spec
from .work.estimate import estimate
from .work.files import export_scene, record
from .work.order import JobOrder, Telling
from .work.scenes import compose_scene, edit_scene, generate_scene

_MAX_BYTES = 2**20  # maximum size of an order


def do(order: JobOrder, telling: Telling) -> Mapping[str, Any]:
    """Run a job; return its result.

    Raises:
        TabletopError: the job failed.
    """
    if order.kind == "estimate":
        return estimate(order, telling)
    spec = read_spec(order.request)
    match spec:
        case GenerateSpec():
            return generate_scene(spec, order, telling)
        case ComposeSpec():
            return compose_scene(spec, order, telling)
        case EditSpec():
            return edit_scene(spec, order, telling)
        case EpisodeSpec():
            return record(spec, order, telling)
        case ExportSpec():
            return export_scene(spec, order, telling)


def main() -> int:
    """Run the job from standard input; return the process's exit code."""
    signal.signal(signal.SIGINT, signal.default_int_handler)  # a background process ignores Ctrl-C
    speech = _take_over_output()
    line = sys.stdin.buffer.readline(_MAX_BYTES)
    threading.Thread(target=_end_with_parent, daemon=True).start()
    telling = Telling(speech, Path())
    try:
        order = JobOrder.parse(parse_object(line, "An order", TabletopError))
        telling = Telling(speech, order.figures)
        telling.say(type="result", **do(order, telling))
        return 0
    except KeyboardInterrupt:
        return 130
    except PlaceError as error:
        telling.say(
            type="error",
            message=str(error),
            facts={"place": error.reason, "free_position": error.free},
        )
    except TabletopError as error:
        telling.say(type="error", message=str(error))
    except MemoryError:
        telling.say(type="error", message="The machine has too little memory for this job.")
    except OSError as error:
        where = f" ({error.filename})" if error.filename else ""
        telling.say(type="error", message=f"Disk error{where}: {error.strerror or error}.")
    except Exception as error:
        traceback.print_exc()
        message = f"{type(error).__name__}: {error}"
        telling.say(type="error", message=f"Internal error: {message}. See the log.")
    return 1


def _take_over_output() -> BinaryIO:
    """Return the stream for messages to the server; redirect other output to standard error."""
    speech = os.fdopen(os.dup(sys.stdout.fileno()), "wb")
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    return speech


def _end_with_parent() -> None:
    """Wait until the input is closed, then end this process and its children."""
    while os.read(sys.stdin.fileno(), 4096):
        pass
    if os.getpgrp() == os.getpid():
        os.killpg(0, signal.SIGKILL)
    os._exit(1)


if __name__ == "__main__":
    sys.exit(main())
