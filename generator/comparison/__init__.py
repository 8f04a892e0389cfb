"""A scene held against its picture: the camera that took it, figures, and a sheet to judge by."""

from .camera import picture_camera as picture_camera
from .scores import Comparison as Comparison
from .scores import Score as Score
from .scores import compare as compare
from .sheet import comparison_sheet as comparison_sheet
