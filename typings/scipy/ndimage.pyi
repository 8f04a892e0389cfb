"""What the strictly checked parts use of SciPy's ndimage, which has no types of its own."""

from collections.abc import Sequence
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

def distance_transform_edt(
    input: ArrayLike,
    sampling: float | Sequence[float] | None = None,
    return_distances: bool = True,
    return_indices: bool = False,
) -> NDArray[np.float64]: ...
def __getattr__(name: str) -> Any: ...
