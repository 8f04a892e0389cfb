"""The Segmenter with open models: Grounding DINO and SAM 2, or SAM 3 alone (Sec. 3.1)."""

from __future__ import annotations

import os
from collections.abc import Sequence
from dataclasses import dataclass, field

import numpy as np
from jaxtyping import Bool, Float, UInt8

from tabletop_objects import CATEGORIES

from ...errors import SceneError, require
from ...geometry import mask_box
from ...meshes.pixels import mask_iou
from ...scene import TABLE, Detection, Intrinsics
from ..requirements import Once, models_folder, working
from .detection.detections import (
    ALIKE,
    BoxDetection,
    Finder,
    Masker,
    clean,
    distinct,
    name_generic,
    on_table,
    separate,
)
from .detection.grounding_dino import GroundingDino
from .detection.sam2 import Sam2
from .detection.sam3 import Sam3
from .detection.tiles import Tile, tiles_of
from .weights.loader import device_for, load_model, load_tokenizer
from .weights.pins import pin

DETECTOR = "TABLETOPGEN_DETECTOR"
"""Environment variable that selects the detector when the segmenter is selected by name."""

GENERIC = "object"
"""The label that requests any object on the table."""

_WHAT = "huggingface, segment:"
_KINDS = ("GroundingDinoForObjectDetection", "Sam3Model")
_SMALLEST = 1e-4  # minimum area of an object, as a fraction of the picture


def usual_detector() -> str:
    """Return the detector set in the environment, or else the larger Grounding DINO."""
    return os.environ.get(DETECTOR) or "grounding-dino-base"


@dataclass(frozen=True)
class HuggingFaceSegmenter:
    """A segmenter that detects objects described by words, and segments them.

    The picture is processed as a whole and in tiles. Of several detections of one object, the one
    with the highest score is kept. Objects beside the table are removed.

    Attributes:
        detector: "grounding-dino-base", "grounding-dino-tiny", or "sam3", which needs no masker;
            defaults to the environment's ``TABLETOPGEN_DETECTOR``.
        masker: "sam2".
        threshold: minimum score of a detection.
        tiles: number of tiles along each side; 1 uses the whole picture only.
        overlap: fraction of a tile's side shared with its neighbours.
        side: shorter side of a tile for Grounding DINO in pixels.
        words: maximum number of words in a prompt for Grounding DINO.
        device: "cuda", "cpu" …; if empty, "cuda" is used if available.
        folder: folder of the models, see ``installing.models_folder``.
        revisions: the models and their commits.

    Raises:
        BackendError: a model does not exist.
        InputError: a number is out of range.
    """

    detector: str = field(default_factory=usual_detector)
    masker: str = "sam2"
    threshold: float = 0.25
    tiles: int = 2
    overlap: float = 0.25
    side: int = 800
    words: int = 24
    device: str = ""
    folder: str = field(default="", repr=False, compare=False)
    revisions: str = field(init=False)
    _finder: Once[Finder] = field(init=False, repr=False, compare=False)
    _masker: Once[Masker] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        require(self, "threshold", above=0, maximum=1)
        require(self, "tiles", minimum=1, maximum=8, integer=True)
        require(self, "overlap", minimum=0, maximum=0.5)
        require(self, "side", minimum=32, maximum=4096, integer=True)
        require(self, "words", minimum=1, integer=True)
        used = [pin(self.detector, *_KINDS)]
        if not self._alone:
            used.append(pin(self.masker, "Sam2Model"))
        set_field = object.__setattr__
        set_field(self, "revisions", ", ".join(p.stamp for p in used))
        set_field(self, "_finder", Once(self._load_finder))
        set_field(self, "_masker", self._finder if self._alone else Once(self._load_masker))

    def segment(
        self,
        image: UInt8[np.ndarray, "h w 3"],
        labels: tuple[str, ...],
        depth: Float[np.ndarray, "h w"] | None = None,
        intrinsics: Intrinsics | None = None,
    ) -> tuple[Detection, ...]:
        """Return the table first, then the objects; the closest to the viewer comes last.

        All instances of a label are returned, regardless of how often the label was given. An
        "object" gets the name of the most similar catalogue category, if any. Depth is not used.

        Raises:
            BackendError: a model is missing, damaged or fails.
            SceneError: the picture contains no table.
        """
        image = np.ascontiguousarray(image)
        words = tuple(dict.fromkeys((TABLE, *labels)))
        with working(_WHAT):
            parts = tiles_of(image.shape[1], image.shape[0], self.tiles, self.overlap)
            found = self._find(image, words, parts)
            masked = self._masker().mask(image, found, parts)
        table, things = _table_and_things([clean(f) for f in masked])
        things = separate(things, _SMALLEST * table.size)
        for thing in things:
            table &= ~thing.mask
        if not table.any():
            raise SceneError(
                "The detected objects hide the whole table. Show more of the tabletop."
            )
        detections = [Detection(f.label, f.box, f.mask, min(f.score, 1.0)) for f in things]
        detections.sort(key=lambda d: (d.box[3], d.box[0]))
        return (Detection(TABLE, mask_box(table), table), *detections)

    def _find(
        self, image: UInt8[np.ndarray, "h w 3"], words: tuple[str, ...], parts: Sequence[Tile]
    ) -> list[BoxDetection]:
        """Return one detection per box; generic ones are named in a second pass.

        A table's box may also be an object's box; another word for it does not remove the table.
        """
        finder = self._finder()
        found = finder.find(image, words, parts)
        tables = distinct([f for f in found if f.label == TABLE])
        things = distinct([f for f in found if f.label != TABLE])
        if any(f.label == GENERIC for f in things):
            nouns = dict.fromkeys(c.noun for c in CATEGORIES.values())
            things = name_generic(things, GENERIC, finder.find(image, tuple(nouns), parts[:1]))
        return [*tables, *things]

    @property
    def _alone(self) -> bool:
        return pin(self.detector, *_KINDS).kind == "Sam3Model"

    def _load_finder(self) -> Finder:
        model, folder = pin(self.detector, *_KINDS), models_folder(self.folder)
        tokenizer = load_tokenizer(model, folder, _WHAT)
        network = load_model(model, folder, _WHAT, device=device_for(self.device))
        if self._alone:
            return Sam3(network, tokenizer, self.threshold)
        return GroundingDino(network, tokenizer, self.threshold, self.side, self.words)

    def _load_masker(self) -> Masker:
        model, folder = pin(self.masker, "Sam2Model"), models_folder(self.folder)
        return Sam2(load_model(model, folder, _WHAT, device=device_for(self.device)))


def _table_and_things(
    detections: Sequence[BoxDetection],
) -> tuple[Bool[np.ndarray, "h w"], list[BoxDetection]]:
    """Return the table's mask and the detections on it.

    Raises:
        SceneError: the picture contains no table.
    """
    tables = [f for f in detections if f.label == TABLE]
    if not tables:
        raise SceneError(
            "No table found in the picture. Show the whole tabletop, or lower the segmenter's "
            "threshold."
        )
    table = max(tables, key=lambda f: f.score).mask
    things = [f for f in detections if f.label != TABLE and mask_iou(f.mask, table) <= ALIKE]
    return table.copy(), on_table(things, table)
