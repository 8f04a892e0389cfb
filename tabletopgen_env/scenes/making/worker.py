"""A process that makes scenes: ``python -m tabletopgen_env.scenes.making.worker FOLDER``.

It reads jobs from its standard input, one JSON object a line: a ``recipe`` and the ``folder`` to
work in, a name inside FOLDER. A scene is left there as a bundle, and last of all an ``answer``,
which names the bundle and the scene's difficulty, or says what went wrong. When the input ends the
process that gave the jobs is gone: then FOLDER is removed, whatever was going on.
"""

from __future__ import annotations

import contextlib
import json
import os
import queue
import shutil
import signal
import sys
import threading
from pathlib import Path
from typing import Any, BinaryIO

from . import answer

NICENESS = 10
"""How far the process steps back for others."""


def main() -> None:
    """Work until the input ends."""
    if hasattr(os, "nice"):
        os.nice(NICENESS)
    root = Path(sys.argv[1])
    jobs: queue.SimpleQueue[bytes] = queue.SimpleQueue()
    threading.Thread(target=_read, args=(sys.stdin.buffer, jobs, root), daemon=True).start()
    while True:
        job = json.loads(jobs.get())
        folder = root / job["folder"]
        answer.give(folder, _work(job["recipe"], folder))


def _read(given: BinaryIO, jobs: queue.SimpleQueue[bytes], root: Path) -> None:
    for line in given:
        jobs.put(line)
    while root.is_dir():  # the main thread may be writing into it
        shutil.rmtree(root, ignore_errors=True)
    if hasattr(os, "killpg"):
        with contextlib.suppress(OSError):  # what a stage has started goes, too
            os.killpg(os.getpid(), signal.SIGKILL)
    os._exit(0)


def _work(recipe: dict[str, Any], folder: Path) -> dict[str, Any]:
    """Make one scene; whatever goes wrong is an answer, too."""
    try:
        from generator.bundle import save

        from ..difficulty import difficulty
        from .recipe import Recipe

        scene = Recipe.from_json(recipe).make()
        path = save(scene, folder, allow_failed=True)  # recipes judge what needs judging
        return {"bundle": path.name, "difficulty": difficulty(scene)}
    except Exception as error:  # one scene must not end the process
        return {"error": f"{type(error).__name__}: {error}"}


if __name__ == "__main__":
    main()
