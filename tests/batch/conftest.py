"""Compiles Warp's kernels once for all test runs, into ``build/``."""

import os
from pathlib import Path

import pytest
from filelock import FileLock
from tables import COMPILING, shipped


@pytest.fixture(scope="session")
def kernels() -> Path:
    """The folder of the compiled kernels (``tests/conftest.py``).

    One process compiles them; the others wait, and load them.
    """
    from tabletopgen_env.parallel.batch.bank import SceneBank
    from tabletopgen_env.parallel.batch.batch_world import BatchWorld

    folder = Path(os.environ["WARP_CACHE_PATH"])
    folder.mkdir(parents=True, exist_ok=True)
    with FileLock(folder / "compiling.lock", timeout=COMPILING):
        BatchWorld(SceneBank(shipped("vanity"), max_parts=None), 1, device="cpu")
    return folder
