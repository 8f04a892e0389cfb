"""Appearance of the geoms of a compiled MJCF: colours, and textures, shared where equal."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, UInt8

from tabletop_objects.values import PICTURE, frozen_array

from ..meshes.reading.textures import MOST_TEXTURE

if TYPE_CHECKING:
    import mujoco


class GeomLooks:
    """Appearance of a model's geoms, by index."""

    def __init__(self, model: mujoco.MjModel) -> None:
        self._model = model
        self._pictures: dict[tuple[int, bytes], UInt8[np.ndarray, "h w 3"]] = {}

    def color(self, geom: int) -> Float[np.ndarray, "4"]:
        """Return the rgba of a geom, or of its material if it has one, as in MuJoCo."""
        model = self._model
        material, own = int(model.geom_matid[geom]), model.geom_rgba[geom]
        if material < 0 or not np.allclose(own, [0.5, 0.5, 0.5, 1.0]):
            return own.astype(np.float64)
        return model.mat_rgba[material].astype(np.float64)

    def repeat(self, geom: int) -> Float[np.ndarray, "2"]:
        """Return the number of repetitions of a geom's texture along each of its sides."""
        material = int(self._model.geom_matid[geom])
        if material < 0:
            return np.ones(2)
        return self._model.mat_texrepeat[material].astype(np.float64)

    def picture(self, geom: int) -> UInt8[np.ndarray, "h w 3"] | None:
        """Return a geom's texture in its colour; None without one. Of a cube, the first side.

        Geoms with the same texture and colour get the same read-only array, so that meshes share
        it. Its longest side is at most ``MOST_TEXTURE``.
        """
        texture = self._texture(geom)
        if texture < 0:
            return None
        tint = self.color(geom)[:3].clip(0, 1)
        key = texture, tint.tobytes()
        if key not in self._pictures:
            self._pictures[key] = self._tint(texture, tint)
        return self._pictures[key]

    def _texture(self, geom: int) -> int:
        """Return the index of a geom's texture, or -1."""
        import mujoco

        material = int(self._model.geom_matid[geom])
        if material < 0:
            return -1
        roles = (mujoco.mjtTextureRole.mjTEXROLE_RGB, mujoco.mjtTextureRole.mjTEXROLE_RGBA)
        return max(int(self._model.mat_texid[material, int(role)]) for role in roles)

    def _tint(self, texture: int, tint: Float[np.ndarray, "3"]) -> UInt8[np.ndarray, "h w 3"]:
        import cv2

        model = self._model
        height, width = int(model.tex_height[texture]), int(model.tex_width[texture])
        channels, at = int(model.tex_nchannel[texture]), int(model.tex_adr[texture])
        data = model.tex_data[at : at + height * width * channels]
        data = data.reshape(height, width, channels)
        pixels = np.repeat(data[..., :1], 3, axis=2) if channels < 3 else data[..., :3]
        if height == 6 * width:
            pixels = pixels[:width]
        longest = max(pixels.shape[:2])
        if longest > MOST_TEXTURE:
            size = [max(1, side * MOST_TEXTURE // longest) for side in pixels.shape[1::-1]]
            pixels = cv2.resize(pixels, size, interpolation=cv2.INTER_AREA)
        return frozen_array(np.round(pixels * tint), *PICTURE, "A texture")
