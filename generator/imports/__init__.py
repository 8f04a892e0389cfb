"""Import of scenes from other programs: MJCF and GLB files.

    from generator.imports import import_scene

    scene = import_scene("foreign/scene.xml")

A foreign scene is a set of rigid bodies at rest on a table. Its poses, masses, friction
coefficients, collision shapes and appearance are preserved. The scene is then settled and passed
through the gate. Objects that cannot be imported are refused without affecting the others;
``list_outcomes`` gives the outcome of each object.
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
    """Return an imported foreign scene at rest with its report; see ``importer.import_scene``."""
    from .importer import import_scene as run

    return run(source, options or ImportOptions(), config)


def list_outcomes(scene: Scene) -> tuple[ImportOutcome, ...]:
    """Return the import outcome of each object of a scene; see ``scene.list_outcomes``.

    Raises:
        BundleError: the entry in the scene's provenance has another format.
    """
    from ..imports.scene import list_outcomes as run  # `.scene` would bind the parameter

    return run(scene)
