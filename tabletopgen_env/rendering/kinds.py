"""Image kinds, renderers and profiles, and the interface that rendering backends implement."""

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
    """A rendering backend that draws worlds at a fixed picture size."""

    def draw(
        self, world: World, camera: str, kinds: Collection[Kind]
    ) -> dict[Kind, Shaped[np.ndarray, "h w *_c"]]:
        """Return the requested pictures, rendered together in the formats of ``rgb`` and ``depth``.

        "segmentation" holds the geom id of each pixel, -1 for the background.
        """
        ...

    def rgb(self, world: World, camera: str) -> UInt8[np.ndarray, "h w 3"]:
        """Return the picture of ``camera``."""
        return self.draw(world, camera, ("rgb",))["rgb"]

    def depth(self, world: World, camera: str) -> Float[np.ndarray, "h w"]:
        """Return the distance along the optical axis in metres (inf for the background)."""
        return self.draw(world, camera, ("depth",))["depth"]

    def forget(self, world: World) -> None:
        """Free the resources of ``world``."""
        ...

    def close(self) -> None:
        """Free all resources."""
        ...


DrawerOf = Callable[[tuple[int, int]], Drawer]
"""A function that returns a rendering backend for a height and width in pixels."""
