"""Joint refinement, beyond the paper: fits all objects and the camera to all masks at once.

DRO rotates one object at a time and TSA places the objects from another picture. This stage
optimises yaw, position and size of all objects together by gradient descent until their outlines,
seen from the reference picture's camera, agree with the instances' masks. Objects stay on their
supports and clear of each other.
"""

from .joint import Refinement as Refinement
from .joint import outline_misfit as outline_misfit
from .joint import refine_scene as refine_scene
from .problem import RefinementConfig as RefinementConfig
