"""A foreign scene before conversion: bodies with surfaces, collision shapes, masses and poses.

Its files must be regular files inside its folder (``read_source``). Objects that cannot be imported
are refused individually, with an ``ImportOutcome``, and the others are kept.
"""

from __future__ import annotations

from collections.abc import Iterator, Sized
from contextlib import contextmanager
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Literal

import numpy as np
from jaxtyping import Float

from ..bundle import BOUNDS, read_inside
from ..errors import BackendError, InputError, SceneError, TabletopError
from ..meshes.reading.surface import ColoredSurface
from ..physics.inertia import MassProperties
from ..scene import ConvexPart

DENSITY = (1.0, 29_000.0)
"""Minimum and maximum density of materials, in kg/m³."""

LARGEST = 100.0
"""Maximum size of a body of a foreign scene, and maximum distance from its table, in metres."""

OutcomeKind = Literal["taken", "repaired", "hull", "refused", "left out"]
"""Outcomes of an object's import: "hull" means that it collides as its convex hull, "left out" that
it made the physical gate fail."""


@dataclass(frozen=True)
class ImportOutcome:
    """The outcome of one object's import.

    Attributes:
        name: The object.
        kind: The kind of outcome.
        detail: The repairs, or the reason for the refusal; may be empty.
    """

    name: str
    kind: OutcomeKind = "taken"
    detail: str = ""

    def __str__(self) -> str:
        return f"{self.name}: {self.kind}" + (f" ({self.detail})" if self.detail else "")


@dataclass
class Refusals:
    """Collects the objects that cannot be imported, so that they do not stop the import of others.

    Attributes:
        outcomes: An outcome for each refused object.
        first: The error of the first one.
    """

    outcomes: list[ImportOutcome] = field(default_factory=list[ImportOutcome])
    first: TabletopError | None = None

    def add(self, name: str, error: TabletopError) -> None:
        """Record that an object is refused because of an error."""
        self.outcomes.append(ImportOutcome(name, "refused", str(error)))
        self.first = self.first or error

    @contextmanager
    def catching(self, name: str) -> Iterator[None]:
        """Record an object as refused if the ``with`` block raises an error of this project."""
        try:
            yield
        except (InputError, BackendError, SceneError) as error:
            self.add(name, error)

    def check_left(self, left: Sized) -> None:
        """Check that at least one object remains to be imported.

        Raises:
            InputError: all objects are refused; the message gives the reasons. A single object's
                own error is raised unchanged.
        """
        if len(left) or self.first is None:
            return
        if len(self.outcomes) == 1:
            raise self.first
        reasons = "; ".join(f"{o.name}: {o.detail}" for o in self.outcomes[:5])
        raise InputError(
            f"None of the {len(self.outcomes)} objects can be imported. {reasons}"
        ) from self.first


@dataclass(frozen=True, eq=False)
class ForeignBody:
    """A rigid body of a foreign scene, in metres and kilograms; z points up in the world frame.

    Attributes:
        name: its name in the foreign scene.
        position, rotation: pose of its frame in the world.
        surface: the visible surface, in its frame.
        parts: convex collision shapes, in its frame; if empty, the surface is decomposed.
        mass: mass, centre of mass and inertia along the axes of its frame; None uses its
            category's.
        friction: coefficient of sliding friction; None uses its category's.
        category: its category, as a word; if empty, derived from its name.
        weight: mass in kilograms, if no other mass properties are given.
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
            raise InputError(f"The body {self.name!r} has no faces, so it cannot be drawn.")
        points = sum(len(part.vertices) for part in self.parts)
        if len(self.parts) > BOUNDS.parts or points > BOUNDS.all_part_vertices:
            raise InputError(
                f"The body {self.name!r} has {len(self.parts)} collision shapes with {points} "
                f"points; at most {BOUNDS.parts} shapes with {BOUNDS.all_part_vertices} points are "
                "allowed. Use fewer shapes, or a mesh that is its own collision shape."
            )
        far = np.abs(self.surface.vertices).max(), np.abs(self.position).max()
        if not np.isfinite(far).all():
            raise InputError(f"The body {self.name!r} contains a number that is not finite.")

    def scale(self, factor: float) -> ForeignBody:
        """Return the body with lengths scaled by ``factor``.

        A mass that is plausible for the body's unscaled lengths, 1 to 29,000 kg/m³ of its box, was
        computed from them and scales with the volume; any other mass is taken to be in kilograms
        and is kept.
        """
        mass = self.mass
        if mass is not None:
            density = mass.mass / max(float(np.prod(np.ptp(self.surface.vertices, axis=0))), 1e-300)
            heavier = factor**3 if DENSITY[0] <= density <= DENSITY[1] else 1.0
            mass = MassProperties(
                mass.mass * heavier, mass.com * factor, mass.inertia * heavier * factor**2
            )
        return replace(
            self, position=self.position * factor, mass=mass,
            surface=replace(self.surface, vertices=self.surface.vertices * factor),
            parts=tuple(ConvexPart(p.vertices * factor, p.kind, p.axis) for p in self.parts),
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class ForeignScene:
    """The content of a foreign scene: its table, its objects, and warnings about what is ignored.

    ``table`` is None if the source has a single object and no table. ``refused`` lists the objects
    that could not be read.
    """

    name: str
    table: ForeignBody | None
    objects: tuple[ForeignBody, ...]
    warnings: tuple[str, ...] = ()
    refused: tuple[ImportOutcome, ...] = ()

    def scale(self, factor: float) -> ForeignScene:
        """Return the scene with lengths scaled by ``factor``."""
        if factor == 1:
            return self
        objects = tuple(body.scale(factor) for body in self.objects)
        table = None if self.table is None else self.table.scale(factor)
        return replace(self, table=table, objects=objects)


def check_count(objects: int) -> None:
    """Check the number of objects of a foreign scene before they are read.

    Raises:
        InputError: there are more than a scene can hold.
    """
    if objects > BOUNDS.objects:
        raise InputError(
            f"The scene has {objects} objects; at most {BOUNDS.objects} are allowed. Remove some "
            "of them."
        )


def read_source(folder: Path, name: str, limit: int) -> bytes:
    """Read a regular file of at most ``limit`` bytes in a folder; reject links and ``..``.

    Raises:
        InputError: the file is missing, too large, or not inside the folder.
    """
    return read_inside(folder, name, limit, InputError, "folder")
