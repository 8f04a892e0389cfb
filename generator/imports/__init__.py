"""Scenes of other programs turned into scenes of this one: MJCF, and GLB files.

    from generator.imports import import_scene

    scene = import_scene("foreign/scene.xml")

A foreign scene is a set of rigid bodies at rest on a table. What it says of them is kept: where
they are, what they weigh, how they slide, the shapes that collide, and how they look. Then the
scene is settled and judged. An object that cannot be used is refused, and the others stay:
``list_outcomes`` says what was done with each.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from .options import ImportOptions as ImportOptions

if TYPE_CHECKING:
    from ..method.assembly import AssemblyConfig
    from ..scene import Scene
    from .foreign import ImportOutcome


def import_scene(
    source: str | Path, options: ImportOptions | None = None, config: AssemblyConfig | None = None
) -> Scene:
    """Return a foreign scene, settled and judged; see ``importer.import_scene``."""
    from .importer import import_scene as run

    return run(source, options or ImportOptions(), config)


def list_outcomes(scene: Scene) -> tuple[ImportOutcome, ...]:
    """Return what the import of a scene did with each object; see ``building.list_outcomes``.

    Raises:
        BundleError: the scene's provenance lists something else there.
    """
    from .building import list_outcomes as run

    return run(scene)
