"""How sure a share of successes is."""

from __future__ import annotations


def wilson(solved: int, count: int, z: float = 1.96) -> tuple[float, float]:
    """Return Wilson's interval of a share, 95 % unless ``z`` says otherwise; (0, 1) of nothing."""
    if not count:
        return 0.0, 1.0
    share, weight = solved / count, z * z / count
    middle = (share + weight / 2) / (1 + weight)
    half = z * (share * (1 - share) / count + weight / (4 * count)) ** 0.5 / (1 + weight)
    return max(middle - half, 0.0), min(middle + half, 1.0)
