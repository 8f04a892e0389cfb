"""Square crops of a picture around one object, and the mapping between crop and picture."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8


@dataclass(frozen=True)
class Frame:
    """A square crop: its corner in picture pixels, and its scale in crop pixels per picture pixel.

    ``side`` is the crop's width and height in pixels.
    """

    corner: tuple[float, float]
    scale: float
    side: int

    @classmethod
    def around(
        cls,
        low: Float[np.ndarray, "2"],
        high: Float[np.ndarray, "2"],
        side: int,
        room: float,
        minimum: float = 0.0,
    ) -> Frame:
        """Return the frame around a box, ``room`` times as wide as the box's longer side.

        ``low`` and ``high`` are the box's corners (x, y) and ``minimum`` is the minimum width of
        the frame, in picture pixels. ``side`` is in pixels of the crop.
        """
        wide = max(room * float((high - low).max()), minimum)
        x, y = (low + high) / 2 - wide / 2
        return cls((float(x), float(y)), side / wide, side)

    def _warp(self, shrunk: tuple[float, float] = (1.0, 1.0)) -> Float[np.ndarray, "2 3"]:
        """Return the affine map from a picture scaled down by factors (x, y) to the crop."""
        zoom = self.scale / np.array(shrunk)
        shift = -np.array(self.corner) * self.scale + 0.5 * zoom - 0.5
        return np.array([[zoom[0], 0, shift[0]], [0, zoom[1], shift[1]]])

    def cut(self, image: UInt8[np.ndarray, "h w 3"]) -> UInt8[np.ndarray, "s s 3"]:
        """Return the crop; outside the picture, the border pixels are repeated."""
        (x0, x1), (y0, y1) = (
            self._reach(corner, length)
            for corner, length in zip(self.corner, image.shape[1::-1], strict=True)
        )
        near = Frame((self.corner[0] - x0, self.corner[1] - y0), self.scale, self.side)
        return near._draw(image[y0:y1, x0:x1])

    def _reach(self, corner: float, length: int) -> tuple[int, int]:
        """Return the range of picture columns or rows that the frame can show (end exclusive)."""
        pad = 2 + 1 / self.scale
        first = int(np.clip(corner - pad, 0, length - 2))
        return first, int(np.clip(corner + self.side / self.scale + pad, first + 2, length))

    def _draw(self, image: UInt8[np.ndarray, "h w 3"]) -> UInt8[np.ndarray, "s s 3"]:
        warp = self._warp()
        if self.scale < 0.7:  # averaging first prevents aliasing of fine detail
            width, height = image.shape[1::-1]
            size = max(1, round(width * self.scale)), max(1, round(height * self.scale))
            image = cv2.resize(image, size, interpolation=cv2.INTER_AREA)
            warp = self._warp((size[0] / width, size[1] / height))
        return cv2.warpAffine(image, warp, (self.side, self.side), borderMode=cv2.BORDER_REPLICATE)

    def carry(
        self, mask: Float[np.ndarray, "h w"], factor: float, stride: int, cell: int
    ) -> Float[np.ndarray, "c c"]:
        """Resample a map to this crop's grid of cells, each ``cell`` pixels wide.

        ``mask`` belongs to a picture scaled by ``factor`` relative to this one, in cells of
        ``stride``.
        """
        zoom = self.scale / factor * stride / cell
        shift = -np.array(self.corner) * self.scale / cell + 0.5 * zoom - 0.5
        warp = np.array([[zoom, 0, shift[0]], [0, zoom, shift[1]]])
        count = self.side // cell
        if zoom >= 0.7:
            return cv2.warpAffine(mask, warp, (count, count))
        times = int(np.ceil(1 / zoom))  # supersampling preserves thin structures
        finer = warp * times
        finer[:, 2] += (times - 1) / 2
        fine = cv2.warpAffine(mask, finer, (count * times, count * times))
        return cv2.resize(fine, (count, count), interpolation=cv2.INTER_AREA)

    def inside(self, size: tuple[int, ...]) -> Bool[np.ndarray, "s s"]:
        """Return which pixels of the crop lie inside a picture of ``size`` (h, w)."""
        middles = (np.arange(self.side) + 0.5) / self.scale
        x, y = middles + self.corner[0], middles + self.corner[1]
        return ((y > 0) & (y < size[0]))[:, None] & ((x > 0) & (x < size[1]))

    def spread(
        self, masks: Float[np.ndarray, "k s s"], size: tuple[int, ...], level: float = 0.5
    ) -> list[Bool[np.ndarray, "h w"]]:
        """Map the crop's pixels with values above ``level`` to a picture of ``size`` (h, w)."""
        back = cv2.invertAffineTransform(self._warp())
        return [cv2.warpAffine(m, back, (size[1], size[0])) > level for m in masks]
