"""Top-view Spatial Alignment, TSA (Sec. 3.3): translations and scales from a view from above."""

from .checking import check_top_view as check_top_view
from .direct import ask_layout as ask_layout
from .equations import metres_per_pixel as metres_per_pixel
from .equations import own_extent as own_extent
from .equations import pixel_area_and_ratio_error as pixel_area_and_ratio_error
from .equations import rectangle_box as rectangle_box
from .equations import rma_score as rma_score
from .equations import select_anchor as select_anchor
from .placing import Alignment as Alignment
from .placing import AlignmentConfig as AlignmentConfig
from .placing import align as align
