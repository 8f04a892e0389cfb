"""Shared fixtures of the import tests."""

from collections.abc import Callable

import pytest

from generator.imports.foreign import ForeignScene
from generator.imports.mjcf import read_mjcf


@pytest.fixture
def read() -> Callable[..., ForeignScene]:
    """Read MJCF without the child process, which would take most of the time."""
    return read_mjcf
