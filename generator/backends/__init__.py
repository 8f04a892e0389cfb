"""Backends: the models that the stages use. See ``protocols``, ``select`` and ``mix``."""

from .select import Backends, Mix

__all__ = ["Backends", "Mix"]
