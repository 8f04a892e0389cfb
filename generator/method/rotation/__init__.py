"""Sec. 3.3, Differentiable Rotation Optimizer (DRO): each object's yaw r_i, Eqs. 1 to 4.

Every candidate yaw is rendered softly, cropped tightly and compared with the tight crop of the
completed instance: a coarse search over the whole turn, then Adam on the best candidates, all of
them in one tensor.
"""

from .certainty import margin, widths
from .config import RotationConfig
from .estimate import estimate_rotations, optimise_rotation
from .found import RotationAnswer, RotationCandidate
from .losses import appearance_loss, contour_distance, edge_loss, rotation_loss, silhouette_loss
from .objective import (
    Candidates,
    Levels,
    Objective,
    Target,
    cut_sides,
    make_objectives,
    make_target,
)
from .prior import prefer, prior_yaw, same_side
from .search import coarse_losses, coarse_search, losses_at, refine, search, select
from .symmetry import looks_order, looks_round, turning_changes

__all__ = [
    "Candidates",
    "Levels",
    "Objective",
    "RotationAnswer",
    "RotationCandidate",
    "RotationConfig",
    "Target",
    "appearance_loss",
    "coarse_losses",
    "coarse_search",
    "contour_distance",
    "cut_sides",
    "edge_loss",
    "estimate_rotations",
    "looks_order",
    "looks_round",
    "losses_at",
    "make_objectives",
    "make_target",
    "margin",
    "optimise_rotation",
    "prefer",
    "prior_yaw",
    "refine",
    "rotation_loss",
    "same_side",
    "search",
    "select",
    "silhouette_loss",
    "turning_changes",
    "widths",
]
