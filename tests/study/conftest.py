"""A browser for the study's page; its tests are skipped, loudly, where there is none."""

import shutil
import warnings
from collections.abc import Iterator
from pathlib import Path

import pytest

ARGUMENTS = (
    "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
    "--disable-background-networking", "--disable-component-update", "--disable-sync",
    "--no-first-run", "--disable-quic",
)  # fmt: skip

AXE = Path(__file__).parents[2] / "web" / "node_modules" / "axe-core" / "axe.min.js"


def _skip(missing: str) -> None:
    warnings.warn(f"The study's page is not tried in a browser: {missing}.", stacklevel=2)
    pytest.skip(missing)


@pytest.fixture(scope="session")
def template() -> str:
    """The built page."""
    from tabletopgen_web.frontend import STATIC
    from tabletopgen_web.study.page import read_template

    if not (STATIC / "study.html").is_file() and shutil.which("npm") is None:
        _skip("the page is not built and npm is missing")
    return read_template()


@pytest.fixture(scope="session")
def axe() -> str:
    """The source of axe-core, which finds faults of accessibility."""
    if not AXE.is_file():
        _skip(f"{AXE} is missing; `make web` installs it")
    return AXE.read_text(encoding="utf-8")


@pytest.fixture(scope="session")
def browser() -> Iterator[object]:
    """Debian's Chromium."""
    chromium = shutil.which("chromium")
    if chromium is None:
        _skip("chromium is not installed")
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        _skip("playwright is not installed")
    with sync_playwright() as play:
        opened = play.chromium.launch(executable_path=chromium, args=[*ARGUMENTS])
        yield opened
        opened.close()
