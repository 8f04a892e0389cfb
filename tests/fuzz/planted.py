"""Faults planted for the harness's own tests: each must be found."""

import os
import random
import sys
import time
from pathlib import Path

from hostile.targets import Run

from generator.errors import InputError


def sound(rng: random.Random, folder: Path) -> Run:
    """Refuse every other input by an error of ours."""
    odd = rng.random() < 0.5

    def run() -> bool:
        if odd:
            raise InputError("no")
        return True

    return run


def raises(rng: random.Random, folder: Path) -> Run:
    """Raise an exception that is none of ours."""
    return lambda: bool({}["missing"])


def sleeps(rng: random.Random, folder: Path) -> Run:
    """Hang."""
    return lambda: time.sleep(60) is None


def eats(rng: random.Random, folder: Path) -> Run:
    """Take more memory than may be, and hold it."""

    def run() -> bool:
        held = bytearray(600 * 2**20)
        held[::4096] = b"x" * len(held[::4096])
        return time.sleep(30) is None and bool(held)

    return run


def gulps(rng: random.Random, folder: Path) -> Run:
    """Take more memory than may be for a moment only."""

    def run() -> bool:
        return len(b"x" * (600 * 2**20)) > 1

    return run


def feeds(rng: random.Random, folder: Path) -> Run:
    """Have a child process take more memory than may be."""
    code = "import time; held = bytearray(600 * 2**20); held[::4096] = b'x' * len(held[::4096])"
    return lambda: os.system(f'{sys.executable} -c "{code}; time.sleep(30)"') == 0


def delegates(rng: random.Random, folder: Path) -> Run:
    """Have a child process take more time than may be."""
    return lambda: os.system(f"{sys.executable} -c 'while True: pass'") == 0


def idles(rng: random.Random, folder: Path) -> Run:
    """Wait, without need of the processor, for longer than a case may work."""
    return lambda: time.sleep(3) is None


def dies(rng: random.Random, folder: Path) -> Run:
    return lambda: os._exit(7)


def removes(rng: random.Random, folder: Path) -> Run:
    """Remove a file beside the folder."""
    return lambda: (folder.parent / "beside.txt").unlink() is None


def appends(rng: random.Random, folder: Path) -> Run:
    """Change a file above the folder by another program, which no hook in Python sees."""
    return lambda: os.system(f"echo x >> {folder.parents[1]}/precious/file.txt") == 0


def escapes(rng: random.Random, folder: Path) -> Run:
    """Write far outside; the guard keeps it from happening."""
    place = folder.parents[2] / "far.txt"
    return lambda: bool(place.write_text("x"))


def leaves(rng: random.Random, folder: Path) -> Run:
    """Leave a staging folder behind."""
    return lambda: (folder / ".staging-x").mkdir() is None


def broken(rng: random.Random, folder: Path) -> Run:
    """Cannot craft anything."""
    raise ValueError("a fault of the target")
