"""Planted faults for the harness's tests: each must be detected."""

import os
import random
import sys
import time
from pathlib import Path

from hostile.targets import Run

from generator.errors import InputError


def sound(rng: random.Random, folder: Path) -> Run:
    """Refuse every other input with an error of the package."""
    odd = rng.random() < 0.5

    def run() -> bool:
        if odd:
            raise InputError("no")
        return True

    return run


def raises(rng: random.Random, folder: Path) -> Run:
    """Raise a foreign exception."""
    return lambda: bool({}["missing"])


def sleeps(rng: random.Random, folder: Path) -> Run:
    """Hang."""
    return lambda: time.sleep(60) is None


def eats(rng: random.Random, folder: Path) -> Run:
    """Exceed the memory limit, and hold the memory."""

    def run() -> bool:
        held = bytearray(600 * 2**20)
        held[::4096] = b"x" * len(held[::4096])
        return time.sleep(30) is None and bool(held)

    return run


def gulps(rng: random.Random, folder: Path) -> Run:
    """Exceed the memory limit for a moment only."""

    def run() -> bool:
        return len(b"x" * (600 * 2**20)) > 1

    return run


def feeds(rng: random.Random, folder: Path) -> Run:
    """Make a child process exceed the memory limit."""
    code = "import time; held = bytearray(600 * 2**20); held[::4096] = b'x' * len(held[::4096])"
    return lambda: os.system(f'{sys.executable} -c "{code}; time.sleep(30)"') == 0


def delegates(rng: random.Random, folder: Path) -> Run:
    """Make a child process exceed the time limit."""
    return lambda: os.system(f"{sys.executable} -c 'while True: pass'") == 0


def idles(rng: random.Random, folder: Path) -> Run:
    """Wait, without using the processor, for longer than a case may work."""
    return lambda: time.sleep(3) is None


def dies(rng: random.Random, folder: Path) -> Run:
    return lambda: os._exit(7)


def removes(rng: random.Random, folder: Path) -> Run:
    """Remove a file beside the folder."""
    return lambda: (folder.parent / "beside.txt").unlink() is None


def appends(rng: random.Random, folder: Path) -> Run:
    """Change a file above the folder with another program, invisible to Python's hooks."""
    return lambda: os.system(f"echo x >> {folder.parents[1]}/precious/file.txt") == 0


def escapes(rng: random.Random, folder: Path) -> Run:
    """Write far outside the folder; the guard prevents it."""
    place = folder.parents[2] / "far.txt"
    return lambda: bool(place.write_text("x"))


def leaves(rng: random.Random, folder: Path) -> Run:
    """Leave a staging folder behind."""
    return lambda: (folder / ".staging-x").mkdir() is None


def broken(rng: random.Random, folder: Path) -> Run:
    """Fail to craft any input."""
    raise ValueError("a fault of the target")
