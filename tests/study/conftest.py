"""The study's page and axe-core; tests are skipped with a visible message without them."""

import shutil
import warnings

import pytest
from browser import AXE


def _skip(missing: str) -> None:
    warnings.warn(f"The study's page is not tried in a browser: {missing}.", stacklevel=2)
    pytest.skip(missing)


@pytest.fixture(autouse=True)
def _inline(inline: None) -> None:
    """Decode pictures in this process: a child per picture takes most of a test's time."""


@pytest.fixture(scope="session")
def template() -> str:
    """The built page."""
    from tabletopgen_web.frontend import STATIC
    from tabletopgen_web.study.page_data import read_template

    if not (STATIC / "study.html").is_file() and shutil.which("npm") is None:
        _skip("the page is not built and npm is missing")
    return read_template()


@pytest.fixture(scope="session")
def axe() -> str:
    """The source of axe-core, which finds accessibility violations."""
    if not AXE.is_file():
        _skip(f"{AXE} is missing; `make web` installs it")
    return AXE.read_text(encoding="utf-8")
