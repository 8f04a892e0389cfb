"""How sure a share of successes is."""

from __future__ import annotations


def wilson(solved: int, count: int) -> tuple[float, float]:
    """Return Wilson's 95 % interval of a share; (0, 1) of nothing."""
    from scipy.stats import binomtest

    if not count:
        return 0.0, 1.0
    low, high = binomtest(solved, count).proportion_ci(method="wilson")
    return float(low), float(high)
