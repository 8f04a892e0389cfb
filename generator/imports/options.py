"""Options of an import."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from ..errors import require
from ..scene import MAX_LEAN


@dataclass(frozen=True)
class ImportOptions:
    """Options of an import.

    Attributes:
        name: Name of the scene; by default its own.
        table: Name of the fixed body, geom or node that is the table; by default it is detected.
        root: Folder that contains an MJCF and all its files; by default the file's own.
        drop_failing: Leave out objects that fail the physical gate, instead of failing.
        scale: Factor of all lengths: 0.001 for a file in millimetres. In a folder it applies to the
            files of objects that have no scale of their own, not to positions.
        lean: Angle in degrees by which gravity leans in the physical gate; 0 tests the scene on a
            level table, where round objects stay. Generated scenes pass at 2.

    Raises:
        InputError: scale or lean is out of range.
    """

    name: str | None = None
    table: str | None = None
    root: Path | None = None
    drop_failing: bool = False
    scale: float = 1.0
    lean: float = 0.0

    def __post_init__(self) -> None:
        require(self, "scale", minimum=1e-6, maximum=1e6)
        require(self, "lean", minimum=0, maximum=MAX_LEAN)
