"""Scenes in the formats of other programs: MJCF, URDF, SDF, glTF and USD."""

from .writer import ALONE as ALONE
from .writer import WRITERS as WRITERS
from .writer import export as export
