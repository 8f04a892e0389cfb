"""Wilson's interval against published values, and at its ends."""

import pytest

from tabletopgen_env.statistics import newcombe, wilson


def test_wilsons_interval() -> None:
    assert wilson(95, 100) == pytest.approx((0.8882, 0.9785), abs=1e-3)
    assert wilson(0, 0) == (0.0, 1.0)


@pytest.mark.parametrize("count", [1, 7, 20, 1000])
def test_it_stays_a_share_and_is_symmetric(count: int) -> None:
    low, high = wilson(0, count)
    assert low == 0.0 and 0.0 < high < 1.0
    assert wilson(count, count) == pytest.approx((1 - high, 1.0))


def test_newcombes_interval_of_a_difference() -> None:
    """The paper's examples a, b, e, g (table II, method 10)."""
    for given, wanted in (
        ((56, 70, 48, 80), (0.0524, 0.3339)),
        ((9, 10, 3, 10), (0.1705, 0.8090)),
        ((0, 10, 0, 20), (-0.1611, 0.2775)),
        ((10, 10, 0, 20), (0.6791, 1.0000)),
    ):
        assert newcombe(*given) == pytest.approx(wanted, abs=1e-3)
    assert newcombe(0, 0, 3, 4) == (-1.0, 1.0)
