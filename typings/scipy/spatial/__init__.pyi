"""What the strictly checked parts use of SciPy's spatial, which has no types of its own."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

class QhullError(RuntimeError): ...

class ConvexHull:
    vertices: NDArray[np.int32]
    simplices: NDArray[np.int32]
    neighbors: NDArray[np.int32]
    equations: NDArray[np.float64]
    volume: float
    area: float
    def __init__(
        self, points: ArrayLike, incremental: bool = False, qhull_options: str | None = None
    ) -> None: ...

def __getattr__(name: str) -> Any: ...
