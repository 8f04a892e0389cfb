"""The content of a page for each scene; the fields are also options of the ``page`` command."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

PageFormat = Literal["glb", "mjcf", "sdf", "urdf", "usd", "usdz"]
"""The keys of ``generator.exports.WRITERS``, repeated here because that import is slow."""


@dataclass(frozen=True)
class FolderOptions:
    """The content of a page for each scene.

    Attributes:
        formats: Exports to download in addition to the bundle; usd and usdz need the extra "usd".
        episodes: Maximum number of recorded episodes of the scripted expert, one per task.
        robot: Add the arm to each table; required for episodes.
    """

    formats: tuple[PageFormat, ...] = ("glb", "urdf", "sdf")
    episodes: int = 4
    robot: bool = True
