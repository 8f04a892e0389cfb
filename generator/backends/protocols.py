"""The typed questions that stages ask. A backend is any object that answers some of them.

A backend sees what these signatures pass, and nothing else. Each backend is a frozen dataclass
whose fields are its identity (model id, revision, seed); keys come from the environment and are
never stored, logged or put into an exception.
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
"""What was found in a picture; the table is among it."""

Sizes = Mapping[str, SizePrior]
"""Sizes by instance name, metres."""


class Each(Protocol):
    """How one question is asked about many things."""

    def __call__(self, work: Callable[[T], R], items: Sequence[T]) -> list[R]:
        """Return ``work`` of every item, in their order."""
        ...


def in_turn(work: Callable[[T], R], items: Sequence[T]) -> list[R]:
    """Ask one after another: what computes here gains nothing by threads."""
    return [work(item) for item in items]


@runtime_checkable
class Reasoner(Protocol):
    """The multimodal language model of the paper: six questions."""

    def plan_scene(self, prompt: str, seed: int) -> ScenePlan:
        """Expand a text into a scene plan (Sec. 3, Fig. 20)."""
        ...

    def list_objects(self, reference: Reference) -> tuple[str, ...]:
        """Name the categories to look for in the image, "table" among them (Sec. 3.1)."""
        ...

    def estimate_view(self, reference: Reference, table: Instance) -> View:
        """Estimate azimuth, elevation and field of view from the image (Sec. 3.3)."""
        ...

    def estimate_sizes(self, reference: Reference, instances: Instances, view: View) -> Sizes:
        """Give each instance's commonsense size and axes, the table's too (Fig. 22)."""
        ...

    def review_orientation(
        self, mesh: Mesh, instance: Instance, size: SizePrior
    ) -> tuple[tuple[str, int], ...]:
        """Say how to turn a mesh upright: ("x"|"y"|"z", multiple of 90 degrees) steps (Fig. 23).

        ``mesh`` is in metres, as its modeler sized it, about the middle of its box.
        """
        ...

    def stacking_order(
        self, reference: Reference, instances: Instances, view: View
    ) -> Mapping[str, Stacking]:
        """Say what each instance stands on or in (Fig. 25)."""
        ...


@runtime_checkable
class Judge(Protocol):
    """Marks for finished scenes (Sec. 4.1): two questions that a reasoner may answer, too."""

    def rate(
        self,
        reference: UInt8[np.ndarray, "h w 3"],
        pictures: tuple[UInt8[np.ndarray, "_a _b 3"], ...],
        criteria: Mapping[str, str],
    ) -> Mapping[str, float]:
        """Mark the scene that ``pictures`` show, for each criterion, from 1 (poor) to 7.

        ``criteria`` tells what each key means; 4 is average.
        """
        ...

    def rank(
        self,
        reference: UInt8[np.ndarray, "h w 3"],
        methods: Mapping[str, tuple[UInt8[np.ndarray, "_a _b 3"], ...]],
    ) -> tuple[str, ...]:
        """Order several methods' scenes of one reference by overall preference, best first."""
        ...


@runtime_checkable
class PoseGuesser(Protocol):
    """Poses read off the picture (Sec. 4.3) where an ablation leaves out DRO and TSA.

    Two questions that a reasoner may answer, too.
    """

    def guess_rotations(
        self, reference: Reference, instances: Instances, sizes: Sizes, view: View
    ) -> Mapping[str, float]:
        """Say each instance's yaw in radians, world frame; the table, whose yaw is 0, is left out.

        Yaw 0 has the length (of ``sizes``) along +x.
        """
        ...

    def guess_layout(
        self, reference: Reference, instances: Instances, sizes: Sizes, view: View
    ) -> Mapping[str, LayoutBox]:
        """Say where on the table each instance is and how large, in metres; the table is left out.

        The top is as large as ``sizes`` has it.
        """
        ...


@runtime_checkable
class Imager(Protocol):
    """The image model of the paper: draws, completes, and shows the table from above."""

    def draw(self, plan: ScenePlan, seed: int) -> UInt8[np.ndarray, "h w 3"]:
        """Draw the reference image of a plan: whole table on white, 50-60 degrees elevation."""
        ...

    def complete(
        self, reference: Reference, detection: Detection, others: tuple[Detection, ...]
    ) -> Instance:
        """Redraw one object clean and whole (Sec. 3.1, Fig. 21). ``others`` may hide it.

        The returned instance keeps the detection's label, box and mask; its name is its label
        (the stage makes names unique).
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
        """Show the table from straight above (Sec. 3.3, TSA, Fig. 24).

        ``instances`` includes the table. A backend that only draws may leave ``boxes`` empty, for
        the segmenter to find, and ignore ``models`` and ``rotations``: what is known so far.
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
        """Find every instance of ``labels``; exactly one detection has the label "table".

        ``depth`` (metres, 0 where unknown) and ``intrinsics`` come with an RGB-D picture only. The
        label "object" asks for anything on the table; a backend may answer with a better word.
        """
        ...


@runtime_checkable
class Modeler(Protocol):
    """Image to 3D (Sec. 3.2)."""

    def model(self, instance: Instance, size: SizePrior, view: View) -> Model:
        """Make a textured model of one instance (the table too), in any orientation by 90 degrees.

        ``view`` is along the instance's own ray, ``size`` the prior.
        """
        ...


@runtime_checkable
class Encoder(Protocol):
    """Differentiable appearance features Phi of Eq. 4."""

    def features(self, images: torch.Tensor) -> tuple[torch.Tensor, ...]:
        """Map (b, 3, h, w) images in [0, 1], differentiably, to feature maps (b, c, h', w')."""
        ...
