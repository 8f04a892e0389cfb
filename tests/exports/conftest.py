"""What tests of imports share."""

from collections.abc import Callable

import mujoco
import pytest

from generator.imports import mjcf as reading
from generator.imports.foreign import ForeignScene
from generator.imports.mjcf import read_mjcf
from generator.imports.mjcf_files import GatheredModel
from generator.sandbox.running import INSIDE


@pytest.fixture
def read(monkeypatch: pytest.MonkeyPatch) -> Callable[..., ForeignScene]:
    """Read MJCF without the child process, which takes most of the time."""

    def compile_here(gathered: GatheredModel, what: str) -> mujoco.MjModel:
        return mujoco.MjModel.from_xml_string(gathered.xml, gathered.files)

    monkeypatch.setattr(reading, "compile_foreign", compile_here)
    return read_mjcf


@pytest.fixture
def in_process(monkeypatch: pytest.MonkeyPatch) -> None:
    """Read foreign files in this process: a child takes most of the time."""
    monkeypatch.setenv(INSIDE, "1")
