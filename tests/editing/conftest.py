"""Shared fixtures of the editing tests."""

import numpy as np
import pytest

from generator.editing import edited


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch) -> None:
    """Reduce previews to a few pixels."""
    monkeypatch.setattr(edited, "preview", lambda scene: np.zeros((4, 4, 3), np.uint8))
