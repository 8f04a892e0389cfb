"""Files of this package: JSON that is read value by value, and files that are written whole."""

from __future__ import annotations

import tempfile
from pathlib import Path
from typing import Any, NoReturn

from generator.errors import StorageError


def typed(value: Any, kind: type) -> Any:
    """Return a value that is of exactly this type.

    Raises:
        TypeError: it is of another.
    """
    if type(value) is not kind:
        raise TypeError(f"{value!r} should be of type {kind.__name__}")
    return value


def no_constant(constant: str) -> NoReturn:
    """Refuse NaN and infinities; the ``parse_constant`` of ``json.loads``.

    Raises:
        ValueError: always.
    """
    raise ValueError(f"{constant} is not a finite number")


def write_whole(path: Path, content: str | bytes, what: str, advice: str) -> None:
    """Write a file that all may read, whole or not at all.

    Args:
        path: where; the folder must be there.
        content: bytes, or a text for UTF-8.
        what: what it is, for the message of an error: "The policy".
        advice: what to do then: "Choose another folder."

    Raises:
        StorageError: it cannot be written.
    """
    part = None
    try:
        with tempfile.NamedTemporaryFile(dir=path.parent, suffix=".part", delete=False) as file:
            part = Path(file.name)
            file.write(content.encode() if isinstance(content, str) else content)
        part.chmod(0o644)
        part.replace(path)
    except OSError as error:
        if part is not None:
            part.unlink(missing_ok=True)
        raise StorageError(
            f"{what} cannot be written to {path}: {error.strerror or error}. {advice}"
        ) from error
