"""Backends: the models behind the stages. See ``protocols``, ``select`` and ``mix``."""

from .mix import Mix
from .select import Backends

__all__ = ["Backends", "Mix"]
