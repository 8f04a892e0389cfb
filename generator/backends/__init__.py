"""Backends: the models behind the stages. See ``protocols``, ``select`` and ``mix``."""

from .select import Backends, Mix

__all__ = ["Backends", "Mix"]
