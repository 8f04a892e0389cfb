"""What tests of imports share."""

from collections.abc import Callable

import mujoco
import pytest

from generator.imports import mjcf as reading
from generator.imports.foreign import ForeignScene
from generator.imports.mjcf import read_mjcf
from generator.imports.mjcf_files import GatheredModel


@pytest.fixture
def read(monkeypatch: pytest.MonkeyPatch) -> Callable[..., ForeignScene]:
    """Read MJCF without the child process, which takes most of the time."""

    def compile_here(gathered: GatheredModel, what: str) -> mujoco.MjModel:
        return mujoco.MjModel.from_xml_string(gathered.xml, gathered.files)

    monkeypatch.setattr(reading, "compile_foreign", compile_here)
    return read_mjcf
