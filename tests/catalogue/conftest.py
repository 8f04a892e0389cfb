"""The models of each category, built once for all that is asked of them."""

import pytest
from built import SOME, Models

from tabletop_objects import CATEGORIES


@pytest.fixture(scope="session", params=sorted(CATEGORIES))
def models(request: pytest.FixtureRequest) -> Models:
    """The models of one category."""
    return Models(request.param)


@pytest.fixture(scope="session", params=SOME)
def variants(request: pytest.FixtureRequest) -> Models:
    """The models of one of some categories; tests of the same one follow each other."""
    return Models(request.param)
