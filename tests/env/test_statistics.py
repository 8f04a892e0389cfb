"""Wilson's interval against published values, and at its ends."""

import pytest

from tabletopgen_env.statistics import wilson


def test_wilsons_interval() -> None:
    assert wilson(95, 100) == pytest.approx((0.8882, 0.9785), abs=1e-3)
    assert wilson(0, 0) == (0.0, 1.0)


@pytest.mark.parametrize("count", [1, 7, 20, 1000])
def test_it_stays_a_share_and_is_symmetric(count: int) -> None:
    low, high = wilson(0, count)
    assert low == 0.0 and 0.0 < high < 1.0
    assert wilson(count, count) == pytest.approx((1 - high, 1.0))
