"""The protocols of backends: typed questions from the stages. A backend answers some of them.

A backend receives the arguments of these methods and nothing else. Each backend is a frozen
dataclass whose fields are its identity (model id, revision, seed). Keys come from the environment
and are never stored, logged or included in exceptions.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Protocol, TypeVar, runtime_checkable

import numpy as np
from jaxtyping import Float, UInt8

from ..scene import (
    Detection,
    Instance,
    Intrinsics,
    LayoutBox,
    Mesh,
    Model,
    Reference,
    Rotation,
    ScenePlan,
    SizePrior,
    Stacking,
    TopView,
    View,
)

if TYPE_CHECKING:
    import torch

T = TypeVar("T")
R = TypeVar("R")
Instances = tuple[Instance, ...]
"""The detections in a picture, including the table."""

Sizes = Mapping[str, SizePrior]
"""Sizes in metres by instance name."""


class Each(Protocol):
    """A function that asks one question about each of many items."""

    def __call__(self, work: Callable[[T], R], items: Sequence[T]) -> list[R]:
        """Return the result of ``work`` for every item, in order."""
        ...


def in_turn(work: Callable[[T], R], items: Sequence[T]) -> list[R]:
    """Process items sequentially; local computation does not benefit from threads here."""
    return [work(item) for item in items]


@runtime_checkable
class Reasoner(Protocol):
    """The paper's multimodal language model, which answers six questions."""

    def plan_scene(self, prompt: str, seed: int) -> ScenePlan:
        """Expand a prompt into a scene plan (Sec. 3, Fig. 20)."""
        ...

    def list_objects(self, reference: Reference) -> tuple[str, ...]:
        """Return the categories to detect in the image, including "table" (Sec. 3.1)."""
        ...

    def estimate_view(self, reference: Reference, table: Instance) -> View:
        """Estimate azimuth, elevation and field of view from the image (Sec. 3.3)."""
        ...

    def estimate_sizes(self, reference: Reference, instances: Instances, view: View) -> Sizes:
        """Estimate each instance's commonsense size and axes, including the table's (Fig. 22)."""
        ...

    def review_orientation(
        self, mesh: Mesh, instance: Instance, size: SizePrior
    ) -> tuple[tuple[str, int], ...]:
        """Return the rotations that turn a mesh upright (Fig. 23).

        Each is a step ("x"|"y"|"z", multiple of 90 degrees). ``mesh`` is in metres at its modeler's
        size, centred on its bounding box.
        """
        ...

    def stacking_order(
        self, reference: Reference, instances: Instances, view: View
    ) -> Mapping[str, Stacking]:
        """Return each instance's support, and whether the instance is on or in it (Fig. 25)."""
        ...


@runtime_checkable
class Judge(Protocol):
    """Ratings of finished scenes (Sec. 4.1): two questions that a reasoner may also answer."""

    def rate(
        self,
        reference: UInt8[np.ndarray, "h w 3"],
        pictures: tuple[UInt8[np.ndarray, "_a _b 3"], ...],
        criteria: Mapping[str, str],
    ) -> Mapping[str, float]:
        """Rate the scene in ``pictures`` for each criterion, from 1 (poor) to 7.

        ``criteria`` describes each key; 4 is average.
        """
        ...

    def rank(
        self,
        reference: UInt8[np.ndarray, "h w 3"],
        methods: Mapping[str, tuple[UInt8[np.ndarray, "_a _b 3"], ...]],
    ) -> tuple[str, ...]:
        """Rank several methods' scenes of one reference from best to worst."""
        ...


@runtime_checkable
class PoseGuesser(Protocol):
    """Poses estimated from the picture (Sec. 4.3), for ablations without DRO and TSA.

    These are two questions that a reasoner may also answer.
    """

    def guess_rotations(
        self, reference: Reference, instances: Instances, sizes: Sizes, view: View
    ) -> Mapping[str, float]:
        """Return each instance's world yaw in radians, except the table's, which is 0.

        At yaw 0, the length (of ``sizes``) is along +x.
        """
        ...

    def guess_layout(
        self, reference: Reference, instances: Instances, sizes: Sizes, view: View
    ) -> Mapping[str, LayoutBox]:
        """Return each instance's position on the table and its size, in metres, except the table's.

        The tabletop has the size in ``sizes``.
        """
        ...


@runtime_checkable
class Imager(Protocol):
    """The paper's image model, which draws pictures and top views, and completes objects."""

    def draw(self, plan: ScenePlan, seed: int) -> UInt8[np.ndarray, "h w 3"]:
        """Draw the reference image: the whole table on white, at an elevation of 50-60 degrees."""
        ...

    def complete(
        self, reference: Reference, detection: Detection, others: tuple[Detection, ...]
    ) -> Instance:
        """Redraw one object completely and cleanly (Sec. 3.1, Fig. 21). ``others`` may hide it.

        The returned instance keeps the detection's label, box and mask; its name is its label (the
        stage makes names unique).
        """
        ...

    def top_view(
        self,
        reference: Reference,
        instances: Instances,
        models: Mapping[str, Model],
        rotations: Mapping[str, Rotation],
        view: View,
    ) -> TopView:
        """Draw the table from straight above (Sec. 3.3, TSA, Fig. 24).

        ``instances`` includes the table. A backend that only draws may leave ``boxes`` empty, so
        that the segmenter detects them, and may ignore ``models`` and ``rotations``, the results so
        far.
        """
        ...


@runtime_checkable
class Segmenter(Protocol):
    """Open-vocabulary detection and segmentation (Sec. 3.1)."""

    def segment(
        self,
        image: UInt8[np.ndarray, "h w 3"],
        labels: tuple[str, ...],
        depth: Float[np.ndarray, "h w"] | None = None,
        intrinsics: Intrinsics | None = None,
    ) -> tuple[Detection, ...]:
        """Detect every instance of ``labels``; exactly one detection has the label "table".

        ``depth`` (metres, 0 where unknown) and ``intrinsics`` are given for RGB-D pictures only.
        The label "object" requests any object on the table; a backend may return a more specific
        word.
        """
        ...


@runtime_checkable
class Modeler(Protocol):
    """Conversion of images to 3D models (Sec. 3.2)."""

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Make a textured model of one instance or the table, possibly rotated by quarter turns.

        ``view`` is along the instance's own ray; ``size`` is the prior.
        """
        ...


@runtime_checkable
class Encoder(Protocol):
    """Differentiable appearance features Phi of Eq. 4."""

    def features(self, images: torch.Tensor) -> tuple[torch.Tensor, ...]:
        """Map (b, 3, h, w) images in [0, 1], differentiably, to feature maps (b, c, h', w')."""
        ...
