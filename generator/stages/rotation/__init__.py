"""Sec. 3.3, Differentiable Rotation Optimizer (DRO): each object's yaw r_i, Eqs. 1 to 4.

Every candidate yaw is rendered softly, cropped tightly and compared with the tight crop of the
completed instance: a coarse search over the whole turn, then Adam on the best candidates, all of
them in one tensor.
"""

from .config import RotationConfig
from .estimate import estimate_rotations, optimise_rotation
from .losses import (
    appearance_loss,
    contour_distance,
    edge_loss,
    rotation_loss,
    silhouette_loss,
)
from .objective import Candidates, Objective, Target, make_objective, make_target
from .search import coarse_losses, refine, search, select_candidates

__all__ = [
    "Candidates",
    "Objective",
    "RotationConfig",
    "Target",
    "appearance_loss",
    "coarse_losses",
    "contour_distance",
    "edge_loss",
    "estimate_rotations",
    "make_objective",
    "make_target",
    "optimise_rotation",
    "refine",
    "rotation_loss",
    "search",
    "select_candidates",
    "silhouette_loss",
]
