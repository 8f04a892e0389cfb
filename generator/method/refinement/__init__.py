"""Joint refinement (not in the paper): all objects and the camera are fitted to all masks.

DRO rotates one object at a time, and TSA places the objects from another picture. This stage
optimises the yaws, positions and sizes of all objects together by gradient descent until their
outlines, as seen from the reference picture's camera, agree with the instances' masks. Objects stay
on their supports and clear of each other.
"""

from .joint import Refinement as Refinement
from .joint import outline_misfit as outline_misfit
from .joint import refine_scene as refine_scene
from .problem import RefinementConfig as RefinementConfig
