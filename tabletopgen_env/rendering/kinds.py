"""What is drawn of a world, by what, and how well."""

from __future__ import annotations

from collections.abc import Callable, Collection
from typing import TYPE_CHECKING, Literal, Protocol, get_args

import numpy as np
from jaxtyping import Float, Shaped, UInt8

if TYPE_CHECKING:
    from ..world.world import World

RendererChoice = Literal["auto", "gl", "software"]
RENDERERS: tuple[RendererChoice, ...] = get_args(RendererChoice)
Profile = Literal["fast", "full"]
Kind = Literal["rgb", "depth", "segmentation"]


class Drawer(Protocol):
    """Draws worlds at one picture size."""

    def draw(
        self, world: World, camera: str, kinds: Collection[Kind]
    ) -> dict[Kind, Shaped[np.ndarray, "h w *_c"]]:
        """Return the pictures of some kinds, drawn together: as ``rgb`` and ``depth`` return them.

        "segmentation" holds the id of the geom that each pixel shows, -1 where nothing is.
        """
        ...

    def rgb(self, world: World, camera: str) -> UInt8[np.ndarray, "h w 3"]:
        """Return what ``camera`` sees."""
        return self.draw(world, camera, ("rgb",))["rgb"]

    def depth(self, world: World, camera: str) -> Float[np.ndarray, "h w"]:
        """Return the distance along the optical axis in metres (inf where nothing is)."""
        return self.draw(world, camera, ("depth",))["depth"]

    def forget(self, world: World) -> None:
        """Free what is held for ``world``."""
        ...

    def close(self) -> None:
        """Free everything."""
        ...


DrawerOf = Callable[[tuple[int, int]], Drawer]
"""Returns what draws pictures of a height and width, pixels."""
