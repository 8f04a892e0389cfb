"""Puts this folder on the path, so that tests can share the scenes of ``toy.py``."""

import os
import signal
import tempfile
from collections.abc import Iterator
from pathlib import Path

import pytest

# One thread a worker, and in each process it starts, for torch and NumPy: with more of them than
# cores, each waits for the others. ``generator.threads`` goes by OMP_NUM_THREADS, which is as it
# was, so that what the product spreads over threads of its own stays spread.
for name in ("MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(name, "1")

# What whoever runs the tests has made and saved is none of theirs.
os.environ["TABLETOPGEN_CACHE"] = str(Path(tempfile.gettempdir()) / f"no-store-{os.getpid()}")

if os.environ.get("TABLETOPGEN_CHECK_ARRAYS"):
    import typechecking

    typechecking.install()


def pytest_configure() -> None:
    """Heed interrupts, which a process that a shell starts in the background ignores."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="module")
def browser() -> Iterator[object]:
    """Debian's Chromium, for one module: Playwright keeps other event loops from running."""
    from browser import chromium

    with chromium() as found:
        yield found


@pytest.fixture(scope="session")
def tiny_models(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a tiny model in place of every pinned one; not to be changed."""
    import tiny_models

    return tiny_models.save_all(tmp_path_factory.mktemp("models"))


@pytest.fixture
def store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty store of its own for a test."""
    monkeypatch.setenv("TABLETOPGEN_CACHE", str(tmp_path / "store"))
    return tmp_path / "store"


@pytest.fixture
def inline(monkeypatch: pytest.MonkeyPatch) -> None:
    """Read foreign files in this process: a child takes most of the time of a small test."""
    monkeypatch.setattr("generator.sandbox.runner.is_inside", lambda: True)


@pytest.fixture
def shell(capsys: pytest.CaptureFixture[str]):
    """Runs commands and tells what they print: a ``command.Shell``."""
    from command import Shell  # not before the packages may be imported

    return Shell(capsys)
