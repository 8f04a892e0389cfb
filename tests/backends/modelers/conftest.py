"""What tests of modelers share."""

import pytest


@pytest.fixture(autouse=True)
def _inline(inline: None) -> None:
    """Read foreign meshes in this process; ``test_foreign_sandbox`` has those of the child."""
