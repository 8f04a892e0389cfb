"""Detections in the picture: each instance's visible pixels, as one indexed PNG, and the names."""

from __future__ import annotations

import io
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Bool, UInt8

from tabletop_objects.values import freeze

from ..errors import BundleError, InputError
from ..io.bounded import printable
from ..scene import TABLE, Instance
from .contents import decode_indices
from .encoder import one_line

PATH = "stages/instances.png"
"""Path of the picture in a bundle."""

_MOST = 255  # maximum number of instances that one byte per pixel can distinguish


@dataclass(frozen=True, eq=False)
class Segments:
    """The instances of a reference picture.

    ``index`` has the size of the picture; 0 is background, and ``k`` is the instance ``names[k -
    1]`` with the label ``labels[k - 1]``. The table comes first; it has those of its pixels that no
    object covers.
    """

    names: tuple[str, ...]
    labels: tuple[str, ...]
    index: UInt8[np.ndarray, "h w"]

    def __post_init__(self) -> None:
        freeze(self, index=(np.uint8, (None, None)))
        if len(self.names) != len(self.labels) or len(set(self.names)) < len(self.names):
            raise InputError(
                f"Segments must have one label per name, and unique names, got {self.names}."
            )
        if self.index.size and (top := self.index.max()) > len(self.names):
            raise InputError(
                f"Segments.index contains {top}, but there are only {len(self.names)} names."
            )

    @classmethod
    def of(cls, instances: Sequence[Instance]) -> Segments:
        """Merge the masks of ``instances``; where two overlap, the smaller one is in front.

        Raises:
            InputError: there are no instances, or more than 255.
        """
        if not 0 < len(instances) <= _MOST:
            raise InputError(f"1 to {_MOST} instances can be stored, got {len(instances)}.")
        ordered = sorted(instances, key=lambda i: i.name != TABLE)
        index = np.zeros(ordered[0].mask.shape, np.uint8)
        for instance in sorted(ordered, key=lambda i: (i.name != TABLE, -int(i.mask.sum()))):
            index[instance.mask] = ordered.index(instance) + 1
        return cls(tuple(i.name for i in ordered), tuple(i.label for i in ordered), index)

    def mask(self, name: str) -> Bool[np.ndarray, "h w"]:
        """Return the visible pixels of the instance ``name``, or an empty mask if there is none."""
        if name not in self.names:
            return np.zeros(self.index.shape, bool)
        return self.index == self.names.index(name) + 1


def encode_segments(segments: Segments) -> tuple[list[dict[str, str]], bytes]:
    """Return names and labels as JSON values, and the indexed PNG."""
    from PIL import Image

    picture = Image.fromarray(np.asarray(segments.index), "P")
    picture.putpalette([value for k in range(_MOST + 1) for value in _palette(k)])
    buffer = io.BytesIO()
    picture.save(buffer, "PNG", compress_level=9)
    pairs = zip(segments.names, segments.labels, strict=True)
    words = [{"name": one_line(name), "label": one_line(label)} for name, label in pairs]
    return words, buffer.getvalue()


def decode_segments(entries: Any, raw: bytes) -> Segments:
    """Decode the result of :func:`encode_segments`.

    Raises:
        BundleError: the picture or the names are invalid.
    """
    index = decode_indices(raw, PATH)
    try:
        names, labels = (
            tuple(printable(e[key], f"The {key} of an instance", BundleError) for e in entries)
            for key in ("name", "label")
        )
        return Segments(names, labels, index)
    except (InputError, TypeError, KeyError) as error:
        raise BundleError(f"{PATH} does not match the list of instances ({error}).") from error


def _palette(index: int) -> tuple[int, int, int]:
    """Return colours that are easy to distinguish: black, grey for the table, then a hue circle."""
    import colorsys

    if index < 2:
        return (0, 0, 0) if index == 0 else (150, 150, 150)
    red, green, blue = colorsys.hsv_to_rgb(index * 0.61803 % 1.0, 0.75, 0.95)
    return round(255 * red), round(255 * green), round(255 * blue)
