"""Scenes and objects in the formats of other programs: MJCF, URDF, SDF, glTF and USD."""

from .writer import ALONE as ALONE
from .writer import WRITERS as WRITERS
from .writer import export as export
from .writer import export_object as export_object
