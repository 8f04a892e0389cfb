"""What a text's plan puts right in a reconstruction, beyond the paper.

Image models forget, hide, double and misplace things, and image-to-3D models guess the sides that
no picture shows. The plan knows what was asked for: which things, about how large, on what, and
where to each other. What the reconstruction shows like that stays as it is; the rest is put right,
and the scene's provenance names it.
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
