"""The models of each category, built once for all that is asked of them."""

import pytest
from built import Models

from generator.catalogue import CATEGORIES


@pytest.fixture(scope="session", params=sorted(CATEGORIES))
def models(request: pytest.FixtureRequest) -> Models:
    """The models of one category; tests of the same one follow each other, so that few are held."""
    return Models(request.param)
