"""Layout of planned objects: relations become natural, collision-free tabletop placements."""

from .arrangement import Layout, arrange, arrange_more, lay_out, unmet_relations
from .furniture import build_models, build_top, table_size
from .orientation import natural_yaw

__all__ = [
    "Layout",
    "arrange",
    "arrange_more",
    "build_models",
    "build_top",
    "lay_out",
    "natural_yaw",
    "table_size",
    "unmet_relations",
]
