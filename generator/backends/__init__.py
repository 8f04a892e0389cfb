"""Backends: classes that answer the stages' questions. See ``protocols`` and ``select``."""

from .select import Backends

__all__ = ["Backends"]
