"""Top-view spatial alignment, TSA (Sec. 3.3): positions and scales taken from a top view."""

from .equations import metres_per_pixel as metres_per_pixel
from .equations import own_extent as own_extent
from .equations import pixel_area_and_ratio_error as pixel_area_and_ratio_error
from .equations import rectangle_box as rectangle_box
from .equations import rma_score as rma_score
from .equations import select_anchor as select_anchor
from .placement import Alignment as Alignment
from .placement import AlignmentConfig as AlignmentConfig
from .placement import align as align
from .placement import ask_layout as ask_layout
from .top_view_check import check_top_view as check_top_view
