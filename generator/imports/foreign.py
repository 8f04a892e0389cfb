"""A foreign scene as it was read: bodies with a surface, shapes that collide, mass and pose.

Its files are plain ones inside of its folder, and no others (``read_source``).
"""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

import numpy as np
from jaxtyping import Float

from ..bundle import BOUNDS, read_inside
from ..errors import BundleError, InputError
from ..meshes.reading.surface import ColoredSurface
from ..physics.inertia import MassProperties
from ..scene import ConvexPart

LARGEST = 100.0
"""No body of a foreign scene is larger, or farther from its table, metres."""


@dataclass(frozen=True, eq=False)
class ForeignBody:
    """A rigid body in a frame of its own; metres, kilograms, z up in the world.

    Attributes:
        name: what it is called there.
        position, rotation: of its frame in the world.
        surface: what is drawn of it, in its frame.
        parts: convex shapes that collide, in its frame; without any, the surface is decomposed.
        mass: mass, centre of mass and inertia along the axes of its frame; None: by its category.
        friction: coefficient of sliding friction; None: by its category.
        category: what it is, a word; empty: its name says.
        weight: kilograms, where that is all that is said of its mass.
    """

    name: str
    position: Float[np.ndarray, "3"]
    rotation: Float[np.ndarray, "3 3"]
    surface: ColoredSurface
    parts: tuple[ConvexPart, ...] = ()
    mass: MassProperties | None = None
    friction: float | None = None
    category: str = ""
    weight: float | None = None

    def __post_init__(self) -> None:
        if not len(self.surface.faces):
            raise InputError(f"The body {self.name!r} has no faces; nothing of it can be drawn.")
        far = np.abs(self.surface.vertices).max(), np.abs(self.position).max()
        if not max(far) <= LARGEST:  # NaN is not, either
            raise InputError(
                f"The body {self.name!r} reaches farther than {LARGEST:g} m, or holds a number "
                "that is not finite. Lengths are metres."
            )


@dataclass(frozen=True, eq=False)
class ForeignScene:
    """What was read of a foreign scene: its table, its objects, and what was left out of it."""

    name: str
    table: ForeignBody
    objects: tuple[ForeignBody, ...]
    warnings: tuple[str, ...] = ()


def check_count(objects: int) -> None:
    """Check how many objects a foreign scene has, before they are read.

    Raises:
        InputError: a scene holds fewer.
    """
    if objects > BOUNDS.objects:
        raise InputError(
            f"The scene has {objects} objects; at most {BOUNDS.objects} are imported. Take some "
            "out of it."
        )


def read_source(folder: Path, name: str, limit: int) -> bytes:
    """Read a plain file inside of a folder: no way out of it, no links, no more than ``limit``.

    Raises:
        InputError: the file is missing, too large, or not inside of the folder.
    """
    try:
        return read_inside(folder, name, limit)
    except BundleError as error:
        told = f"{error}".replace("leaves the bundle", "leaves the folder")
        told = told.replace("a bundle has plain files only", "only plain files are read")
        told = told.replace(" Make or copy the bundle again.", "")
        raise InputError(f"The scene cannot be imported: {told}") from error
