"""Differentiable Rotation Optimizer (DRO, Sec. 3.3), which finds each yaw r_i by Eqs. 1 to 4.

The object is rendered at every candidate yaw with a soft rasteriser, cropped tightly and compared
with the tight crop of the completed instance. After a coarse search over the full circle, Adam
refines the best candidates, all in one tensor.
"""

from .certainty import margin as margin
from .certainty import widths as widths
from .config import RotationConfig as RotationConfig
from .equations import appearance_loss as appearance_loss
from .equations import contour_distance as contour_distance
from .equations import edge_loss as edge_loss
from .equations import rotation_loss as rotation_loss
from .equations import silhouette_loss as silhouette_loss
from .estimate import estimate_rotation as estimate_rotation
from .estimate import estimate_rotations as estimate_rotations
from .estimate import optimise_rotation as optimise_rotation
from .objective import Candidates as Candidates
from .objective import Levels as Levels
from .objective import Objective as Objective
from .objective import Target as Target
from .objective import cut_sides as cut_sides
from .objective import make_objectives as make_objectives
from .prior import prefer as prefer
from .prior import prior_yaw as prior_yaw
from .prior import same_side as same_side
from .results import RotationAnswer as RotationAnswer
from .results import RotationCandidate as RotationCandidate
from .search import coarse_losses as coarse_losses
from .search import coarse_search as coarse_search
from .search import losses_at as losses_at
from .search import refine as refine
from .search import search as search
from .search import select as select
from .symmetry import looks_round as looks_round
from .symmetry import turning_changes as turning_changes
