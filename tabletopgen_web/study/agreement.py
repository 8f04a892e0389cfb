"""How far raters agree: Krippendorff's alpha.

K. Krippendorff, "Computing Krippendorff's Alpha-Reliability", University of Pennsylvania, 2011; any
number of raters, any of whom may have left any unit out.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Literal

import numpy as np
from jaxtyping import Float

Metric = Literal["nominal", "ordinal"]


def krippendorff(units: Iterable[Sequence[int]], metric: Metric) -> float | None:
    """Return alpha of what raters said of units: 1 if they agree, 0 as if by chance, below if less.

    ``units`` holds the values that one unit was given, in any order; units with fewer than two are
    left out. With o the coincidences of values c and k within units, each unit's pairs weighed by
    1 / (its values - 1), and n their sums::

        alpha = 1 - (n - 1) sum_ck o_ck d_ck / sum_ck n_c n_k d_ck

    d is 1 for values that differ (nominal), or the square of the sum of n from c to k, less half of
    n_c and n_k (ordinal; values in their order). None if fewer than two units' values, or none that
    differ, leave it undefined.
    """
    paired = [list(unit) for unit in units if len(unit) > 1]
    values = sorted({value for unit in paired for value in unit})
    if len(values) < 2:
        return None
    at = {value: k for k, value in enumerate(values)}
    seen = np.zeros((len(values), len(values)))
    for unit in paired:
        counts = np.bincount([at[value] for value in unit], minlength=len(values)).astype(float)
        seen += (np.outer(counts, counts) - np.diag(counts)) / (len(unit) - 1)
    sums = seen.sum(0)
    apart = _distances(sums, metric)
    expected = float((np.outer(sums, sums) * apart).sum())
    return 1.0 - float(sums.sum() - 1) * float((seen * apart).sum()) / expected


def _distances(sums: Float[np.ndarray, "v"], metric: Metric) -> Float[np.ndarray, "v v"]:
    if metric == "nominal":
        return 1.0 - np.eye(len(sums))
    middle = np.cumsum(sums) - sums / 2  # of each value's ranks
    return (middle[:, None] - middle[None, :]) ** 2
