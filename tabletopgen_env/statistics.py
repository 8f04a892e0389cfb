"""Confidence intervals of success rates."""

from __future__ import annotations

import math


def wilson(solved: int, count: int) -> tuple[float, float]:
    """Return Wilson's 95 % interval of a success rate, or (0, 1) for no trials."""
    from scipy.stats import binomtest

    if not count:
        return 0.0, 1.0
    low, high = binomtest(solved, count).proportion_ci(method="wilson")
    return float(low), float(high)


def newcombe(solved: int, count: int, other: int, other_count: int) -> tuple[float, float]:
    """Return the 95 % interval of the difference between two rates from independent episodes.

    R. G. Newcombe, "Interval estimation for the difference between independent proportions",
    Statistics in Medicine 17 (1998), method 10: Wilson's intervals, combined. (-1, 1) for no
    trials.
    """
    if not (count and other_count):
        return -1.0, 1.0
    one, two = solved / count, other / other_count
    (low, high), (other_low, other_high) = wilson(solved, count), wilson(other, other_count)
    below = math.hypot(one - low, other_high - two)
    above = math.hypot(high - one, two - other_low)
    return one - two - below, one - two + above


def newcombe_paired(both: int, one: int, other: int, neither: int) -> tuple[float, float]:
    """Return the 95 % interval of the difference between two rates on the same episodes.

    ``both`` episodes were solved by both, ``one`` only by the first, ``other`` only by the second.
    R. G. Newcombe, "Improved confidence intervals for the difference between binomial proportions
    based on paired data", Statistics in Medicine 17 (1998), method 10: Wilson's intervals, combined
    with the correlation of the pairs. (-1, 1) for no trials.
    """
    count = both + one + other + neither
    if not count:
        return -1.0, 1.0
    first, second = (both + one) / count, (both + other) / count
    (low, high), (other_low, other_high) = (
        wilson(both + one, count), wilson(both + other, count)
    )  # fmt: skip
    product = both * neither - one * other
    if product > 0:
        product = max(product - count / 2, 0.0)
    sides = (both + one) * (other + neither) * (both + other) * (one + neither)
    phi = product / math.sqrt(sides) if sides else 0.0

    def distance(a: float, b: float) -> float:
        return math.sqrt(max(a * a - 2 * phi * a * b + b * b, 0.0))

    below = distance(first - low, other_high - second)
    above = distance(high - first, second - other_low)
    return first - second - below, first - second + above
