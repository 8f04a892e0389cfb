"""What the strictly checked parts use of SciPy's optimize, which has no types of its own."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

def linear_sum_assignment(
    cost_matrix: ArrayLike, maximize: bool = False
) -> tuple[NDArray[np.intp], NDArray[np.intp]]: ...
def __getattr__(name: str) -> Any: ...
