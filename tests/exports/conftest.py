"""What tests of imports share."""

from collections.abc import Callable

import pytest

from generator.imports.foreign import ForeignScene
from generator.imports.mjcf import read_mjcf
from generator.sandbox.running import INSIDE


@pytest.fixture
def read() -> Callable[..., ForeignScene]:
    """Read MJCF without the child process, which takes most of the time."""
    return read_mjcf


@pytest.fixture
def inline(monkeypatch: pytest.MonkeyPatch) -> None:
    """Read foreign files in this process: a child takes most of the time of a small test."""
    monkeypatch.setenv(INSIDE, "1")
