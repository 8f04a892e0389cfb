"""Puts this folder on the path, so that tests can share modules such as ``toy.py``."""

import os
import signal
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

# One thread per worker and child process for torch and NumPy, since more threads than cores would
# wait for each other. ``generator.threads`` uses the original OMP_NUM_THREADS, so the product's own
# threads are not affected.
for name in ("MKL_NUM_THREADS", "OPENBLAS_NUM_THREADS"):
    os.environ.setdefault(name, "1")

# Tests of batches and blocks of the docs share compiled kernels: to compile them takes a minute.
os.environ.setdefault("WARP_CACHE_PATH", str(Path(__file__).parents[1] / "build" / "warp"))

# Tests must not use the files and settings of the user who runs them.
os.environ["TABLETOPGEN_CACHE"] = str(Path(tempfile.gettempdir()) / f"no-store-{os.getpid()}")

pytest_plugins = ("quick",)

if os.environ.get("TABLETOPGEN_CHECK_ARRAYS"):
    import typechecking

    typechecking.install()


def pytest_configure() -> None:
    """Handle interrupts, which processes started in the background by a shell ignore."""
    if signal.getsignal(signal.SIGINT) is signal.SIG_IGN:
        signal.signal(signal.SIGINT, signal.default_int_handler)


@pytest.fixture(scope="module")
def running_browser() -> Iterator[object]:
    """Debian's Chromium for one module, since Playwright blocks other event loops."""
    from browser import chromium

    with chromium() as found:
        yield found


@pytest.fixture
def browser(running_browser: Any) -> Iterator[object]:
    """The module's browser; it closes the test's pages, whose scenes would go on being drawn."""
    yield running_browser
    for context in running_browser.contexts:
        context.unroute_all(behavior="ignoreErrors")
        context.close()


@pytest.fixture(scope="session")
def tiny_models(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a tiny model for every pinned one; read-only."""
    import tiny_models

    return tiny_models.save_all(tmp_path_factory.mktemp("models"))


@pytest.fixture
def store(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """An empty store for one test."""
    monkeypatch.setenv("TABLETOPGEN_CACHE", str(tmp_path / "store"))
    return tmp_path / "store"


@pytest.fixture
def inline(monkeypatch: pytest.MonkeyPatch) -> None:
    """Read foreign files in this process: a child would take most of the time of a small test."""
    monkeypatch.setattr("generator.sandbox.runner.is_inside", lambda: True)


@pytest.fixture
def shell(capsys: pytest.CaptureFixture[str]):
    """Runs commands and returns their output: a ``command.Shell``."""
    from command import Shell  # import only after the packages may be imported

    return Shell(capsys)
