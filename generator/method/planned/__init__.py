"""Correction of a reconstruction using the plan of its text; this step is not in the paper.

Image models omit, hide, duplicate and misplace objects. Image-to-3D models guess the sides that no
picture shows. The plan lists the requested objects, their approximate sizes, supports and
relations. Whatever agrees with the plan is kept; the rest is corrected, and the scene's provenance
lists the corrections.
"""

from .draft import ALIKE as ALIKE
from .draft import REAL as REAL
from .draft import FoundYaws as FoundYaws
from .draft import SceneDraft as SceneDraft
from .draft import Turn as Turn
from .draft import draft_scene as draft_scene
from .layout import Laid as Laid
from .layout import lay_out_draft as lay_out_draft
from .matches import fresh_names as fresh_names
from .matches import retarget as retarget
