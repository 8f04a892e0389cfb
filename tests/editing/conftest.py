"""What all tests of edits share."""

import numpy as np
import pytest

from generator.editing import edited


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Previews of a few pixels."""
    monkeypatch.setattr(edited, "preview", lambda scene: np.zeros((4, 4, 3), np.uint8))
