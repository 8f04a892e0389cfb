"""Scenes and objects in the formats of other programs: MJCF, URDF, SDF, glTF and USD."""

from .exporting import ALONE as ALONE
from .exporting import WRITERS as WRITERS
from .exporting import export as export
from .exporting import export_object as export_object
