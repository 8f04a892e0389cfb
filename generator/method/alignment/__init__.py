"""Top-view Spatial Alignment, TSA (Sec. 3.3): translations and scales from a view from above."""

from .checking import check_top_view
from .direct import ask_layout
from .equations import (
    metres_per_pixel,
    own_extent,
    pixel_area_and_ratio_error,
    rectangle_box,
    rma_score,
    select_anchor,
)
from .matching import complete_boxes
from .placing import Alignment, AlignmentConfig, align

__all__ = [
    "Alignment",
    "AlignmentConfig",
    "align",
    "ask_layout",
    "check_top_view",
    "complete_boxes",
    "metres_per_pixel",
    "own_extent",
    "pixel_area_and_ratio_error",
    "rectangle_box",
    "rma_score",
    "select_anchor",
]
