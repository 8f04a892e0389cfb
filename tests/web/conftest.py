"""A site of all shipped bundles, built once per process."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from browsing.chromium import serve
from pages import SHIPPED

from assets_cache.store import find
from tabletopgen_web.page.options import FolderOptions
from tabletopgen_web.page.site import write_site


@pytest.fixture(scope="session")
def shipped() -> list[Path]:
    """Every bundle that the package ships."""
    return [path for name in SHIPPED for path in find(name)]


@pytest.fixture(scope="session")
def site(shipped: list[Path], tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a site of all of them, with one episode each and without exports."""
    folder = tmp_path_factory.mktemp("web") / "site"
    write_site(shipped, folder, options=FolderOptions(formats=(), episodes=1))
    with serve(folder) as address:
        yield address
