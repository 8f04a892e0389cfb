"""Evaluation of scenes (Secs. 4.1 to 4.3): collisions, stability, similarity, and ground truth."""

from .external import load_external as load_external
from .findings import DefectLimits as DefectLimits
from .findings import Finding as Finding
from .judged import Marks as Marks
from .judged import judge_scene as judge_scene
from .judged import rank_methods as rank_methods
from .report import Evaluation as Evaluation
from .report import evaluate as evaluate
from .report import evaluate_bundle as evaluate_bundle
from .report import ranking as ranking
from .soundness import Soundness as Soundness
from .soundness import StillnessRule as StillnessRule
from .soundness import soundness as soundness
from .surfaces.collisions import Collisions as Collisions
from .surfaces.collisions import collisions as collisions
from .surfaces.collisions import rates as rates
from .surfaces.sweep import best_views as best_views
