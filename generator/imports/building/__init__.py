"""Conversion of a foreign scene: its bodies, and the scene of all usable objects."""

from __future__ import annotations

from ..scene import build_scene as build_scene
from ..scene import list_outcomes as list_outcomes
