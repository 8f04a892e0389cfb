"""Agreement of raters: Krippendorff's alpha.

K. Krippendorff, "Computing Krippendorff's Alpha-Reliability", University of Pennsylvania, 2011. It
supports any number of raters and missing values.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Literal

import numpy as np
from jaxtyping import Float

Metric = Literal["nominal", "ordinal"]


def krippendorff(units: Iterable[Sequence[int]], metric: Metric) -> float | None:
    """Return Krippendorff's alpha: 1 for agreement, 0 for chance level, negative below chance.

    ``units`` holds the values of each unit, in any order; units with fewer than two values are
    ignored. Let o_ck count the pairs of values c and k within units, each pair with the weight 1 /
    (its unit's number of values - 1), and let n be the sums of o. Then::

        alpha = 1 - (n - 1) sum_ck o_ck d_ck / sum_ck n_c n_k d_ck

    For nominal values, d is 1 if they differ; for ordinal ones, which are sorted, it is the square
    of the sum of n from c to k, less half of n_c and half of n_k. The result is None if alpha is
    undefined, because there are too few units or all values are equal.
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
    middle = np.cumsum(sums) - sums / 2  # mean rank of each value
    return (middle[:, None] - middle[None, :]) ** 2
