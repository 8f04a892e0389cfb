"""The background of a room: a checkered floor that fades into haze."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float, Int

from ..geometry import Camera
from .shading import Light, shade

Color = tuple[float, float, float]
"""Red, green and blue in [0, 1]."""

Lit = Callable[[Float[np.ndarray, "p 3"], Float[np.ndarray, "p 3"]], Float[np.ndarray, "p"]]
"""A function that returns the visible fraction of the sun at points with normals."""


@dataclass(frozen=True)
class Backdrop:
    """A square, two-coloured checkered floor at z = 0 around the origin, with haze.

    Args:
        tiles: colours of alternating tiles; the tile between +x and +y at the origin has the first.
        tile: side of a tile, metres.
        half: half the side of the floor, metres.
        haze: colour of the background outside the floor, and of the distant floor.
        fade: distances along the optical axis at which fading begins and ends, metres.
        id: instance id of the floor's pixels.
    """

    tiles: tuple[Color, Color]
    tile: float
    half: float
    haze: Color
    fade: tuple[float, float]
    id: int

    def sample(
        self, camera: Camera, pixels: Float[np.ndarray, "p 2"], light: Light, lit: Lit | None
    ) -> tuple[Float[np.ndarray, "p 3"], Float[np.ndarray, "p"]]:
        """Return the colours in [0, 1] and depths (metres, inf outside the floor) of pixels."""
        points = camera.on_plane(pixels, 0.0)
        on_floor = (np.abs(points[:, :2]) <= self.half).all(1)
        color, depth = np.tile(self.haze, (len(pixels), 1)), np.full(len(pixels), np.inf)
        floor = points[on_floor]
        depth[on_floor] = camera.to_camera(floor)[:, 2]
        up = np.broadcast_to([0.0, 0.0, 1.0], floor.shape)
        share = np.ones(len(floor)) if lit is None else lit(floor, up)
        matt = replace(light, gloss=0.0)
        albedo = self._sample_tiles(floor, depth[on_floor] / camera.focal)
        near, far = self.fade
        faded = np.clip((depth[on_floor] - near) / (far - near), 0, 1)[:, None]
        shaded = shade(albedo, up, camera.position - floor, share, matt)
        color[on_floor] = (1 - faded) * shaded + faded * np.asarray(self.haze)
        return color, depth

    def _sample_tiles(
        self, points: Float[np.ndarray, "p 3"], pixel: Float[np.ndarray, "p"]
    ) -> Float[np.ndarray, "p 3"]:
        """Return the tile colours at points, blended where a pixel's size (metres) is large."""
        odd: Int[np.ndarray, "p"] = np.floor(points[:, :2] / self.tile).astype(np.int64).sum(1) % 2
        blended = np.clip(pixel / self.tile * 4, 0, 1)
        share = (odd * (1 - blended) + 0.5 * blended)[:, None]
        first, second = np.array(self.tiles)
        return (1 - share) * first + share * second
