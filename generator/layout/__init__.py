"""Where planned objects go: relations into free, natural places on the tabletop."""

from .arranging import Layout, arrange, arrange_more, unmet_relations
from .facing import natural_yaw
from .fitting import lay_out
from .furnishing import build_models, build_top, table_size

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
