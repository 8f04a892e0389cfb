"""Runs cases in a monitored worker process, and counts their outcomes."""

from __future__ import annotations

import contextlib
import json
import os
import select
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from pathlib import Path
from types import TracebackType
from typing import IO, Literal

from .room import Room

SECONDS = 20.0
"""Processor time that a case takes at most, its child processes counted."""

MOST_MIB = 2048.0
"""The memory of a case and its child processes together grows by no more."""

HANGS = 6.0
"""A case hangs after so many times ``SECONDS`` of waiting: others may have the processor."""

WARM_SECONDS = 240.0
"""What is done once for a kind takes no longer."""

End = Literal["accepted", "refused", "foreign", "late", "heavy", "outside"]
GOOD: tuple[End, ...] = ("accepted", "refused")

_LOOK = 0.02  # seconds between two looks at a worker
_HERE = Path(__file__).resolve().parent
_ROOT = _HERE.parents[2]
_PATHS = (_HERE.parent, _HERE.parents[1], _ROOT)


class BrokenTarget(Exception):
    """A target cannot craft its input: a fault of the target, not of the product."""


@dataclass(frozen=True)
class Outcome:
    """Outcome of one case.

    Attributes:
        kind: the target's name.
        seed: of all cases.
        number: which of them.
        end: "accepted" or "refused", which is well; "foreign": an exception that is none of ours,
            or a crash; "late", "heavy": over time or memory; "outside": it changed what is not its
            own, or left something unfinished behind.
        detail: the error, the traceback, what was changed.
        seconds: processor time, child processes counted.
        mib: by how much the memory of it and its child processes grew at most, MiB.
    """

    kind: str
    seed: int
    number: int
    end: End
    detail: str = ""
    seconds: float = 0.0
    mib: float = 0.0

    @property
    def good(self) -> bool:
        return self.end in GOOD

    @property
    def cause(self) -> str:
        """The error's line, or the innermost frame when it was stopped; equal for like faults."""
        lines = [line.strip() for line in self.detail.splitlines() if line.strip()]
        if self.end in ("late", "heavy") and lines:
            return next((line for line in lines if "/generator/" in line or "_env/" in line), "")
        places = [line for line in lines if line.startswith("File ")]
        last = lines[-1].split(":")[0] if lines else ""
        return f"{last} {places[-1] if places else ''}"

    def told(self) -> str:
        """Return a description, with instructions to reproduce a failure."""
        case = f"--kind {self.kind} --case {self.number} --seed {self.seed}"
        again = "" if self.good else f"  again: python benchmarks/fuzz.py {case}\n"
        return (
            f"{self.kind} case {self.number} of seed {self.seed}: {self.end} after "
            f"{self.seconds:.2f} s and {self.mib:.0f} MiB\n{again}{self.detail}"
        )


@dataclass
class Tally:
    kind: str
    seed: int
    outcomes: list[Outcome] = field(default_factory=list)

    def count(self, end: End) -> int:
        return sum(o.end == end for o in self.outcomes)

    @property
    def bad(self) -> list[Outcome]:
        return [o for o in self.outcomes if not o.good]

    @property
    def slowest(self) -> float:
        return max((o.seconds for o in self.outcomes), default=0.0)

    @property
    def heaviest(self) -> float:
        return max((o.mib for o in self.outcomes), default=0.0)


class Worker:
    """A process that runs cases in sequence; it is replaced when it dies."""

    def __init__(self, seconds: float = SECONDS, most_mib: float = MOST_MIB) -> None:
        """Set the limits of a case, ``seconds`` and ``most_mib``, without starting a process."""
        self._seconds, self._most = seconds, most_mib
        self._place = tempfile.TemporaryDirectory(prefix="tabletopgen-fuzz-")
        root = Path(self._place.name, "room")
        root.mkdir()
        self._room = Room(root)
        self._log = Path(self._place.name, "log")
        self._process: subprocess.Popen[str] | None = None
        self._warm: set[str] = set()

    def __enter__(self) -> Worker:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:  # fmt: skip
        self.close()

    def close(self) -> None:
        self._kill()
        self._place.cleanup()

    def run(self, kind: str, seed: int, number: int) -> Outcome:
        if self._process is None or kind not in self._warm:
            self._warm_up(kind)
        asked = {"kind": kind, "seed": seed, "number": number}
        outcome = self._watched(asked, self._seconds)
        if outcome.end in GOOD and (outcome.mib > self._most or outcome.seconds > self._seconds):
            end: End = "heavy" if outcome.mib > self._most else "late"
            outcome = Outcome(kind, seed, number, end, "", outcome.seconds, outcome.mib)
        changed = self._room.changes()
        if changed:
            detail = f"changed outside its folder: {', '.join(changed[:8])}\n{outcome.detail}"
            outcome = Outcome(kind, seed, number, "outside", detail, outcome.seconds, outcome.mib)
        return outcome

    def _warm_up(self, kind: str) -> None:
        if self._process is None:
            self._start()
        self._watched({"kind": kind, "warm": True, "seed": 0, "number": -1}, WARM_SECONDS)
        if self._process is None:  # it did not survive, as the next cases will show
            self._start()
        self._room.renew()
        self._warm.add(kind)

    def _start(self) -> None:
        """Start a process with home, temporary files and caches in the room."""
        room = self._room.root
        environment = {
            **{k: v for k, v in os.environ.items() if not k.startswith("TABLETOPGEN")},
            "PYTHONPATH": os.pathsep.join(map(str, _PATHS)),
            "PYTHONDONTWRITEBYTECODE": "1",
            "PYTHONHASHSEED": "0",
            "PYTHONIOENCODING": "utf-8:strict",
            "OMP_NUM_THREADS": "1",
            "HOME": str(room / "home"),
            "TMPDIR": str(self._room.temporary),
            "TERM": "dumb",
        }
        with self._log.open("w") as log:
            self._process = subprocess.Popen(
                [sys.executable, "-m", "hostile.worker", str(room)],
                stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=log, text=True,
                env=environment, cwd=self._room.case, start_new_session=True,
            )  # fmt: skip
        self._warm = set()

    def _watched(self, asked: dict[str, object], seconds: float) -> Outcome:
        """Send one request, and end the process if it exceeds a limit."""
        process = self._process
        assert process is not None and process.stdin is not None and process.stdout is not None
        kind, seed, number = str(asked["kind"]), int(str(asked["seed"])), int(str(asked["number"]))
        began, base, used = time.monotonic(), _resident(process.pid), _used(process.pid)
        try:
            process.stdin.write(json.dumps(asked) + "\n")
            process.stdin.flush()
        except OSError:
            return self._ended(kind, seed, number, "foreign", 0.0, 0.0)
        most = 0.0
        while not _readable(process.stdout):
            spent, most = _used(process.pid) - used, max(most, _resident(process.pid) - base)
            if spent > seconds or time.monotonic() - began > HANGS * seconds:
                return self._ended(kind, seed, number, "late", spent, most)
            if most > self._most and not asked.get("warm"):
                return self._ended(kind, seed, number, "heavy", spent, most)
        line = process.stdout.readline()
        if not line:
            return self._ended(kind, seed, number, "foreign", time.monotonic() - began, most)
        told = json.loads(line)
        if told["end"] == "broken":
            raise BrokenTarget(f"{kind} case {number} of seed {seed}:\n{told['detail']}")
        return Outcome(
            kind, seed, number, told["end"], told.get("detail", ""), told.get("seconds", 0.0),
            max(told.get("mib", 0.0), most),
        )  # fmt: skip

    def _ended(
        self, kind: str, seed: int, number: int, end: End, seconds: float, mib: float
    ) -> Outcome:
        """End the process; return the outcome with its stack."""
        process = self._process
        assert process is not None
        if process.poll() is None:
            process.send_signal(signal.SIGUSR1)  # write its stack to the log
            time.sleep(0.3)
        self._kill()
        code = "" if end != "foreign" else f"the process ended with {process.returncode}\n"
        detail = code + _brief(self._log.read_text(errors="replace"))
        return Outcome(kind, seed, number, end, detail, seconds, mib)

    def _kill(self) -> None:
        process, self._process = self._process, None
        if process is None:
            return
        for stream in (process.stdin, process.stdout):
            _close(stream)
        with contextlib.suppress(ProcessLookupError):
            os.killpg(process.pid, signal.SIGKILL)
        process.wait(30)


def run_cases(
    worker: Worker,
    kind: str,
    seed: int,
    numbers: Iterable[int],
    seen: Callable[[Outcome], None] = lambda outcome: None,
) -> Tally:
    """Run cases of a kind; ``seen`` is called with each outcome."""
    tally = Tally(kind, seed)
    for number in numbers:
        outcome = worker.run(kind, seed, number)
        tally.outcomes.append(outcome)
        seen(outcome)
    return tally


def report(tally: Tally, most: int = 12) -> str:
    """Return the failures in a tally: counts, and the first case of each cause in full."""
    bad = tally.bad
    if not bad:
        return ""
    ends: tuple[End, ...] = ("foreign", "late", "heavy", "outside")
    counts = ", ".join(f"{tally.count(end)} {end}" for end in ends if tally.count(end))
    firsts: dict[tuple[str, str], list[Outcome]] = {}
    for outcome in bad:
        firsts.setdefault((outcome.end, outcome.cause), []).append(outcome)
    shown = [
        f"{same[0].told()}\n  like cases: {', '.join(str(o.number) for o in same[1:20]) or 'none'}"
        for same in list(firsts.values())[:most]
    ]
    head = f"{tally.kind}: {counts} of {len(tally.outcomes)}, by {len(firsts)} causes"
    return "\n\n".join([head, *shown]) + "\n"


def _brief(log: str) -> str:
    """Return the position of each thread: its innermost frames, and those of the product."""
    kept, depth = [], 0
    for line in log.splitlines()[-400:]:
        depth = depth + 1 if line.startswith("  File") else 0
        if depth <= 3 or "/generator/" in line or "/tabletopgen_env/" in line:
            kept.append(line)
    return "\n".join(kept)


def _readable(stream: IO[str]) -> bool:
    return bool(select.select([stream], [], [], _LOOK)[0])


def _resident(pid: int) -> float:
    """Return the current memory of a process and its descendants, MiB."""
    pages = 0
    for one in _family(pid):
        try:
            pages += int(Path(f"/proc/{one}/statm").read_text().split()[1])
        except (OSError, IndexError, ValueError):
            continue
    return pages * os.sysconf("SC_PAGE_SIZE") / 2**20


def _used(pid: int) -> float:
    """Return the processor time of a process, its descendants and ended children, seconds."""
    ticks = 0
    for one in _family(pid):
        try:
            fields = Path(f"/proc/{one}/stat").read_text().rpartition(")")[2].split()
            ticks += sum(map(int, fields[11:15]))
        except (OSError, IndexError, ValueError):
            continue
    return ticks / os.sysconf("SC_CLK_TCK")


def _family(pid: int) -> list[int]:
    """Return a process and all of its descendants, started from any thread."""
    found, waiting = [], [pid]
    while waiting:
        one = waiting.pop()
        found.append(one)
        with contextlib.suppress(OSError, ValueError):  # it may have ended in the meantime
            for listed in Path(f"/proc/{one}/task").glob("*/children"):
                waiting += map(int, listed.read_text().split())
    return found


def _close(stream: IO[str] | None) -> None:
    if stream is not None:
        with contextlib.suppress(OSError):
            stream.close()
