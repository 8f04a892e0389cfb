"""A site of shipped bundles, built once per process."""

from collections.abc import Iterator
from pathlib import Path

import pytest
from browsing.chromium import serve
from extent import part_of
from shipped_bundles import BUNDLES

from tabletopgen_web.page.options import FolderOptions
from tabletopgen_web.page.site import write_site


@pytest.fixture(scope="session")
def shipped() -> list[Path]:
    """Every bundle that the package ships, or a part.

    The part has round, oval and rectangular tables, fruit, glassware, tools, and the tables that
    the tests drive, search for and show beside each other.
    """
    chosen = part_of(
        BUNDLES, "coffee-oval", "office-desk", "office-round", "tidy-task-2", "kitchen-cutting",
        "dining-fruit", "lab", "workbench",
    )  # fmt: skip
    return [BUNDLES[name] for name in chosen]


@pytest.fixture(scope="session")
def site(shipped: list[Path], tmp_path_factory: pytest.TempPathFactory) -> Iterator[str]:
    """The address of a site of them, with one episode each and without exports."""
    folder = tmp_path_factory.mktemp("web") / "site"
    write_site(shipped, folder, options=FolderOptions(formats=(), episodes=1))
    with serve(folder) as address:
        yield address
