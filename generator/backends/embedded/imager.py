"""The embedded image model: paints a plan, completes crops, rectifies the table from above."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from jaxtyping import UInt8

from ...scene import Detection, Instance, Model, Reference, Rotation, ScenePlan, TopView, View
from .drawing import completion, painter, topview


@dataclass(frozen=True)
class EmbeddedImager:
    """Answers the three picture questions without any model: see each module for its method."""

    def draw(self, plan: ScenePlan, seed: int) -> UInt8[np.ndarray, "h w 3"]:
        """Draw the plan's reference image (``painter``)."""
        return painter.draw(plan, seed)

    def complete(
        self, reference: Reference, detection: Detection, others: tuple[Detection, ...]
    ) -> Instance:
        """Cut one object out, whole and clean (``completion``)."""
        return completion.complete(reference, detection, others)

    def top_view(
        self,
        reference: Reference,
        instances: tuple[Instance, ...],
        models: Mapping[str, Model],
        rotations: Mapping[str, Rotation],
        view: View,
    ) -> TopView:
        """Show the table from above by homography and geometry (``topview``)."""
        return topview.top_view(reference, instances, models, rotations, view)
