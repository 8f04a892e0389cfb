"""What a page holds of each scene; the command ``page`` makes its options of it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

PageFormat = Literal["glb", "mjcf", "sdf", "urdf", "usd", "usdz"]
"""The keys of ``generator.exports.WRITERS``, which takes a while to import."""


@dataclass(frozen=True)
class FolderOptions:
    """What a page holds of each scene.

    Attributes:
        formats: Exports to download beside the bundle; usd and usdz need the extra "usd".
        episodes: The most episodes of the scripted expert to play back, one for each task.
        robot: Also put the arm at each table, which episodes need.
    """

    formats: tuple[PageFormat, ...] = ("glb", "urdf", "sdf")
    episodes: int = 4
    robot: bool = True
