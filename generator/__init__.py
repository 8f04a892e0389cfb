"""Turn a text prompt or a picture of a tabletop into a simulated table (TabletopGen).

The package contains no robot code.

    from generator import compose, generate, load, save

    scene = compose("a desk with a laptop and a red mug", seed=0)
    save(scene, "tables")

The names below are imported lazily, on first use.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from .io.lazy import lazy_names

if TYPE_CHECKING:
    from .backends import Backends as Backends
    from .bundle import load as load
    from .bundle import save as save
    from .composition import compose as compose
    from .generation import Config as Config
    from .generation import Generation as Generation
    from .pipeline import generate as generate

_HOMES = {
    "Backends": "backends",
    "Config": "generation",
    "Generation": "generation",
    "compose": "composition",
    "generate": "pipeline",
    "load": "bundle",
    "save": "bundle",
}

__all__ = ["Backends", "Config", "Generation", "compose", "generate", "load", "save"]

__getattr__, __dir__ = lazy_names(__name__, _HOMES)
