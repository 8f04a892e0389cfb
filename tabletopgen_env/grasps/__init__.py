"""Grasp labels: the pose and quality of parallel-gripper grasps of each object in a bundle.

A label is the pose of the tool centre point in the object's frame (the canonical frame scaled to
metres, origin at the centre of its box): a position, metres, and a unit quaternion wxyz. The hand's
+z axis is the approach direction, out of the hand, and +y the opening direction; a rotation by half
a turn about z gives the same grasp. Labels consider the object alone: callers check for obstacles
around it and for the reach of the arm.

    from tabletopgen_env.grasps import read_grasps

    labels = read_grasps(bundle)["mug_1"]
    best = labels.quality.argmax()
    labels.position[best], labels.quaternion[best], labels.width[best]
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from generator.io.lazy import lazy_names

if TYPE_CHECKING:
    from .candidates import GraspCandidate as GraspCandidate
    from .labels import GraspLabels as GraspLabels
    from .labels import GraspTerms as GraspTerms
    from .labels import read_grasps as read_grasps
    from .sampling import label_bundle as label_bundle
    from .sampling import rate_grasps as rate_grasps
    from .sampling import sample_grasps as sample_grasps

_HOMES = {
    "GraspCandidate": "candidates",
    "GraspLabels": "labels",
    "GraspTerms": "labels",
    "label_bundle": "sampling",
    "rate_grasps": "sampling",
    "read_grasps": "labels",
    "sample_grasps": "sampling",
}

__all__ = [
    "GraspCandidate",
    "GraspLabels",
    "GraspTerms",
    "label_bundle",
    "rate_grasps",
    "read_grasps",
    "sample_grasps",
]

__getattr__, __dir__ = lazy_names(__name__, _HOMES)
