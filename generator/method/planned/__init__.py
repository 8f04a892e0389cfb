"""What a text's plan puts right in a reconstruction, beyond the paper.

Image models forget, hide, double and misplace things, and image-to-3D models guess the sides that
no picture shows. The plan knows what was asked for: which things, about how large, on what, and
where to each other. What the reconstruction shows like that stays as it is; the rest is put right,
and the scene's provenance names it.
"""

from .drafting import ALIKE as ALIKE
from .drafting import REAL as REAL
from .drafting import SceneDraft as SceneDraft
from .drafting import draft_scene as draft_scene
from .laying import Laid as Laid
from .laying import lay_out_draft as lay_out_draft
from .matching import fresh_names as fresh_names
from .matching import retarget as retarget
from .turning import FoundYaws as FoundYaws
from .turning import Turn as Turn
