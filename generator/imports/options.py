"""How a foreign scene is read."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path


@dataclass(frozen=True)
class ImportOptions:
    """How a foreign scene is read.

    Attributes:
        name: Name of the scene; its own if left out.
        table: Name of the fixed body, geom or node that is the table; found if left out.
        root: Folder that a MJCF and all its files are inside of; the file's own if left out.
        drop_failing: Leave out objects that the physical gate names, instead of failing.
    """

    name: str | None = None
    table: str | None = None
    root: Path | None = None
    drop_failing: bool = False
