"""Joint refinement, beyond the paper: fits all objects and the camera to all masks at once.

DRO turns one object at a time and TSA places them from another picture. Here yaw, place and size
of every object are moved together, by gradient, until what the reference picture's camera sees of
the scene agrees with the instances' outlines. Objects keep standing on what they stand on, and
apart from one another.
"""

from .joint import Refinement as Refinement
from .joint import outline_misfit as outline_misfit
from .joint import refine_scene as refine_scene
from .problem import RefinementConfig as RefinementConfig
