"""A foreign scene as one of this project: its bodies, and the scene of all that can be used."""

from __future__ import annotations

from ..scene import build_scene as build_scene
from ..scene import list_outcomes as list_outcomes
