"""The Parquet tables of a dataset, written with pyarrow."""

from __future__ import annotations

import io
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Shaped

from generator.io.pictures import encode_png

if TYPE_CHECKING:
    import pyarrow as pa


def step_table(
    columns: Mapping[str, Shaped[np.ndarray, "t *d"] | Sequence[bytes]],
    features: Mapping[str, Mapping[str, Any]],
) -> pa.Table:
    """Return the table of an episode's steps; encoded pictures are lists of bytes."""
    import pyarrow as pa

    arrays, fields = [], []
    for name, feature in features.items():
        if feature["dtype"] == "video":
            continue
        array = _column(columns[name])
        arrays.append(array)
        fields.append(pa.field(name, array.type))
    about = {"huggingface": json.dumps({"info": {"features": _for_datasets(features)}})}
    return pa.Table.from_arrays(arrays, schema=pa.schema(fields, metadata=about))


def _column(values: Shaped[np.ndarray, "t *d"] | Sequence[bytes]) -> pa.Array:
    import pyarrow as pa

    if not isinstance(values, np.ndarray):
        kind = pa.struct([("bytes", pa.binary()), ("path", pa.string())])
        return pa.array([{"bytes": raw, "path": None} for raw in values], kind)
    flat = pa.array(np.ascontiguousarray(values).reshape(-1))
    return flat if values.ndim == 1 else pa.FixedSizeListArray.from_arrays(flat, values.shape[1])


def _for_datasets(features: Mapping[str, Mapping[str, Any]]) -> dict[str, Any]:
    """Return features in the notation of the library "datasets"."""
    found: dict[str, Any] = {}
    for name, feature in features.items():
        kind = feature["dtype"]
        if kind == "video":
            continue
        plain: dict[str, Any] = {"_type": "Image"}
        if kind != "image":
            plain = {"dtype": kind, "_type": "Value"}
            (length,) = feature["shape"]
            if length > 1:
                plain = {"feature": plain, "length": length, "_type": "List"}
        found[name] = plain
    return found


def encode_picture(picture: Shaped[np.ndarray, "h w *c"]) -> bytes:
    """Encode a picture as PNG, or depth as TIFF, without loss."""
    if picture.dtype != np.float32:
        return encode_png(picture)
    from PIL import Image

    buffer = io.BytesIO()
    Image.fromarray(picture).save(buffer, "TIFF", compression="tiff_adobe_deflate")
    return buffer.getvalue()


def write_tasks(tasks: Sequence[str], path: Path) -> None:
    """Write the table of tasks, which pandas indexes by the task descriptions.

    Raises:
        OSError: the file cannot be written.
    """
    import pyarrow as pa
    import pyarrow.parquet as pq

    column = {"metadata": None}
    about = {
        "index_columns": ["task"],
        "column_indexes": [
            {"name": None, "field_name": None, "pandas_type": "unicode", "numpy_type": "object",
             "metadata": {"encoding": "UTF-8"}}
        ],
        "columns": [
            {"name": "task_index", "field_name": "task_index", "pandas_type": "int64",
             "numpy_type": "int64", **column},
            {"name": "task", "field_name": "task", "pandas_type": "unicode",
             "numpy_type": "object", **column},
        ],
        "creator": {"library": "pyarrow", "version": pa.__version__},
        "pandas_version": "2.2.0",
    }  # fmt: skip
    schema = pa.schema(
        [("task_index", pa.int64()), ("task", pa.string())], {"pandas": json.dumps(about)}
    )
    pq.write_table(pa.table([range(len(tasks)), list(tasks)], schema=schema), path)
