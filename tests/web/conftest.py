"""The browser and a site of all shipped bundles, one of each for a process."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from browser import chromium, served
from playwright.sync_api import Browser

from assets_cache.store import find
from tabletopgen_web.page.options import FolderOptions
from tabletopgen_web.page.site import write_site


@pytest.fixture(scope="session")
def browser() -> Iterator[Browser]:
    with chromium() as found:
        yield found


@pytest.fixture(scope="session")
def shipped() -> list[Path]:
    """Every bundle that the package ships."""
    names = ("starter", "kitchen-task-*", "coffee-table-task-*", "tidy-task-*")
    return [path for name in names for path in find(name)]


@pytest.fixture(scope="session")
def site(shipped: list[Path], tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a site of all of them, with one episode each and without exports."""
    folder = tmp_path_factory.mktemp("web") / "site"
    write_site(shipped, folder, options=FolderOptions(formats=(), episodes=1))
    with served(folder) as address:
        yield address
