"""How a foreign scene is read."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from ..errors import require
from ..scene import MAX_LEAN


@dataclass(frozen=True)
class ImportOptions:
    """How a foreign scene is read.

    Attributes:
        name: Name of the scene; its own if left out.
        table: Name of the fixed body, geom or node that is the table; found if left out.
        root: Folder that a MJCF and all its files are inside of; the file's own if left out.
        drop_failing: Leave out objects that the physical gate names, instead of failing.
        scale: Factor of all lengths: 0.001 for a file in millimetres. In a folder it applies to the
            files of objects that have no scale of their own, not to positions.
        lean: Degrees by which gravity leans in the physical gate; 0 judges the scene on a level
            table, where round objects stay, and generated scenes pass at 2.

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
