"""Shared fixtures of the modelers' tests."""

import pytest


@pytest.fixture(autouse=True)
def _inline(inline: None) -> None:
    """Read foreign meshes in this process; ``test_foreign_sandbox`` tests the child process."""
