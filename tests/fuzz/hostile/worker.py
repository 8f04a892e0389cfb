"""The process in which cases run: reads requests as JSON lines, and writes an outcome for each.

Started by ``harness.Worker``; ``python -m hostile.worker ROOM``.
"""

import contextlib
import faulthandler
import json
import os
import random
import resource
import signal
import sys
import traceback
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from .guard import Guard
from .room import LEFTOVERS, remove
from .targets import KINDS, target

MOST_ADDRESSES = 16 * 2**30
"""Bytes of address space a worker may have: what asks for more meets a MemoryError."""


def main() -> None:
    room = Path(sys.argv[1])
    answers = os.fdopen(os.dup(1), "w", buffering=1)
    os.dup2(2, 1)
    faulthandler.enable()
    faulthandler.register(signal.SIGUSR1)
    resource.setrlimit(resource.RLIMIT_AS, (MOST_ADDRESSES, MOST_ADDRESSES))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    guard = Guard(room, room / "tmp")
    for line in sys.stdin:
        asked = json.loads(line)
        told: dict[str, Any] = {"end": "ready"}
        try:
            if asked.get("warm"):
                warm(asked["kind"], room / "inside" / "case")
            else:
                told = answer(asked["kind"], asked["seed"], asked["number"], room, guard)
        except Exception:
            told = {"end": "broken", "detail": traceback.format_exc()}
        print(json.dumps(told), file=answers)


def warm(kind: str, folder: Path) -> None:
    """Run one case of a listed kind, since one-time initialisation is not part of a case's time."""
    _emptied(folder)
    craft = target(kind)
    if kind in KINDS:
        run = craft(random.Random("warm"), folder)
        with contextlib.suppress(BaseException):  # its outcome counts only for an actual case
            run()


def answer(kind: str, seed: int, number: int, room: Path, guard: Guard) -> dict[str, Any]:
    """Run one case; return its outcome, its duration, and its memory growth."""
    folder = room / "inside" / "case"
    _emptied(folder)
    rng = random.Random(f"{seed}/{kind}/{number}")
    run = target(kind)(rng, folder)
    before, rss = _names(folder), _reset_peak()
    guard.arm(folder)
    began = _used()
    end, detail = _ended(run)
    seconds = _used() - began
    touched = guard.disarm()
    grown = (_status("VmHWM") - rss) / 1024
    left = [
        name
        for name in _names(folder) - before
        if Path(name).name.startswith(LEFTOVERS) or name.endswith(LEFTOVERS)
    ]
    if touched or left:
        end, detail = "outside", f"touched {touched[:5]}, left behind {left[:5]}\n{detail}"
    return {"end": end, "detail": detail, "seconds": seconds, "mib": max(0.0, grown)}


def _used() -> float:
    """Return the processor time of this process and of its ended children, seconds."""
    kinds = (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)
    return sum(used.ru_utime + used.ru_stime for used in map(resource.getrusage, kinds))


def _names(folder: Path) -> set[str]:
    return {
        os.path.join(here, name)
        for here, folders, files in os.walk(folder)
        for name in (*folders, *files)
    }


def _ended(run: Any) -> tuple[str, str]:
    from generator.errors import TabletopError

    try:
        return ("accepted" if run() else "refused"), ""
    except TabletopError as error:
        return "refused", f"{type(error).__name__}: {error}"[:2000]
    except BaseException as error:
        heavy = any(isinstance(e, MemoryError) for e in _chain(error))
        return ("heavy" if heavy else "foreign"), traceback.format_exc(limit=-25)[-6000:]


def _chain(error: BaseException | None) -> Iterator[BaseException]:
    while error is not None:
        yield error
        error = error.__cause__ or error.__context__


def _emptied(folder: Path) -> None:
    os.chdir(folder.parent)
    if os.path.lexists(folder):
        _writable(folder)
        remove(folder)
    folder.mkdir(parents=True)
    os.chdir(folder)
    os.environ["XDG_CACHE_HOME"] = str(folder / ".cache")


def _writable(folder: Path) -> None:
    for here, folders, _ in os.walk(folder):
        for name in folders:
            place = os.path.join(here, name)
            if not os.path.islink(place):
                os.chmod(place, 0o700)


def _reset_peak() -> int:
    """Reset the peak memory; return the current memory, KiB.

    Where the system does not let it be forgotten, what counts is what is more than ever before.
    """
    try:
        Path("/proc/self/clear_refs").write_text("5")
    except OSError:
        return _status("VmHWM")
    return _status("VmRSS")


def _status(name: str) -> int:
    for line in Path("/proc/self/status").read_text().splitlines():
        if line.startswith(name + ":"):
            return int(line.split()[1])
    return 0


if __name__ == "__main__":
    main()
