"""Files of arrays (npz) that are not trusted: no pickles, and no more than may be read.

An array's header can claim any size, and a small file can hold a large array: both are checked
before an array is made.
"""

from __future__ import annotations

import io
import math
import zipfile
import zlib
from pathlib import Path

import numpy as np

from ..errors import TabletopError
from .reading import read_regular

_MAX_ARRAYS = 4096  # of a file
_COMPRESSIONS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}


def read_arrays(
    path: str | Path, what: str, error: type[TabletopError], *, max_bytes: int
) -> dict[str, np.ndarray]:
    """Read every array of a file, as ``numpy.savez`` writes it, compressed or not.

    ``what`` begins the message of an error: "The replay buffer". ``max_bytes`` is the most that the
    file, and all its arrays together, may have.

    Raises:
        TabletopError: ``error``, if it cannot be read, is damaged or too large, or holds pickles.
    """
    raw = read_regular(path, what, error, max_bytes=max_bytes)
    try:
        with zipfile.ZipFile(io.BytesIO(raw)) as packed:
            members = [m for m in packed.infolist() if m.filename.endswith(".npy")]
            if not {m.compress_type for m in members} <= _COMPRESSIONS:
                raise error(f"{what} {str(path)!r} is compressed in a way that NumPy never does.")
            if len(members) > _MAX_ARRAYS or sum(m.file_size for m in members) > max_bytes:
                raise error(f"{what} {str(path)!r} holds more than {max_bytes} bytes of arrays.")
            return {m.filename.removesuffix(".npy"): _array(packed.read(m)) for m in members}
    except (
        ValueError, KeyError, TypeError, EOFError, OverflowError, SyntaxError, RuntimeError,
        NotImplementedError, zipfile.BadZipFile, zlib.error,
    ) as failure:  # fmt: skip
        if isinstance(failure, TabletopError):
            raise
        reason = str(failure)[:200] or type(failure).__name__
        raise error(f"{what} {str(path)!r} holds no sound arrays ({reason!r}).") from failure


def _array(raw: bytes) -> np.ndarray:
    """Return the array of an npy file.

    Raises:
        ValueError: it is damaged, holds pickles, or has another size than its header claims.
    """
    file = io.BytesIO(raw)
    version = np.lib.format.read_magic(file)
    if version not in ((1, 0), (2, 0)):
        raise ValueError(f"format {version} is not known")
    read = np.lib.format.read_array_header_1_0
    shape, _, kind = (read if version == (1, 0) else np.lib.format.read_array_header_2_0)(file)
    if min(shape, default=0) < 0 or kind.hasobject:
        raise ValueError("an array of pickles, or of a negative size")
    if math.prod(shape) * kind.itemsize != len(raw) - file.tell():
        raise ValueError(f"an array of shape {shape} in {len(raw)} bytes")
    file.seek(0)
    return np.lib.format.read_array(file, allow_pickle=False)
