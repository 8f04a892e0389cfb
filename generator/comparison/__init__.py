"""Comparison of a scene with its picture: the camera's position, scores, and a sheet."""

from .camera import picture_camera as picture_camera
from .scores import Comparison as Comparison
from .scores import Score as Score
from .scores import compare as compare
from .sheet import comparison_sheet as comparison_sheet
