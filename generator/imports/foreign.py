"""A foreign scene as it was read: bodies with a surface, shapes that collide, mass and pose.

Its files are plain ones inside of its folder, and no others (``read_source``). An object that
cannot be used is refused by itself, with an ``ImportOutcome``; the others stay.
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
"""Densities of materials, kg/m³."""

LARGEST = 100.0
"""No body of a foreign scene is larger, or farther from its table, metres."""

OutcomeKind = Literal["taken", "repaired", "hull", "refused", "left out"]
"""What an import does with an object: "hull" means that it collides as its convex hull, "left out"
that the physical gate failed because of it."""


@dataclass(frozen=True)
class ImportOutcome:
    """What an import did with one object.

    Attributes:
        name: The object.
        kind: What was done.
        detail: How it was repaired, or why it was refused; empty if there is nothing to say.
    """

    name: str
    kind: OutcomeKind = "taken"
    detail: str = ""

    def __str__(self) -> str:
        return f"{self.name}: {self.kind}" + (f" ({self.detail})" if self.detail else "")


@dataclass
class Refusals:
    """Collects the objects of a scene that cannot be used, so that the others can.

    Attributes:
        outcomes: An outcome for each refused object.
        first: The error of the first one.
    """

    outcomes: list[ImportOutcome] = field(default_factory=list[ImportOutcome])
    first: TabletopError | None = None

    def add(self, name: str, error: TabletopError) -> None:
        """Refuse an object because of an error."""
        self.outcomes.append(ImportOutcome(name, "refused", str(error)))
        self.first = self.first or error

    @contextmanager
    def catching(self, name: str) -> Iterator[None]:
        """Refuse an object if the block raises an error of this project."""
        try:
            yield
        except (InputError, BackendError, SceneError) as error:
            self.add(name, error)

    def check_left(self, left: Sized) -> None:
        """Check that objects are left.

        Raises:
            InputError: All are refused; with the reasons. Of a single one its own error is raised.
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
        points = sum(len(part.vertices) for part in self.parts)
        if len(self.parts) > BOUNDS.parts or points > BOUNDS.all_part_vertices:
            raise InputError(
                f"The body {self.name!r} has {len(self.parts)} collision shapes with {points} "
                f"points; at most {BOUNDS.parts} with {BOUNDS.all_part_vertices} are read. Use "
                "fewer, or a mesh that is its own collision shape."
            )
        far = np.abs(self.surface.vertices).max(), np.abs(self.position).max()
        if not np.isfinite(far).all():
            raise InputError(f"The body {self.name!r} holds a number that is not finite.")

    def scale(self, factor: float) -> ForeignBody:
        """Return the body with all lengths multiplied.

        A mass that fits the body's own lengths, 1 to 29,000 kg/m³ of its box, was computed from
        them and scales with the volume; any other mass is kilograms and stays.
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
    """What was read of a foreign scene: its table, its objects, and what was left out of it.

    ``table`` is None if the source holds a single object and no table. ``refused`` are the objects
    that could not be read.
    """

    name: str
    table: ForeignBody | None
    objects: tuple[ForeignBody, ...]
    warnings: tuple[str, ...] = ()
    refused: tuple[ImportOutcome, ...] = ()

    def scale(self, factor: float) -> ForeignScene:
        """Return the scene with all lengths multiplied."""
        if factor == 1:
            return self
        objects = tuple(body.scale(factor) for body in self.objects)
        table = None if self.table is None else self.table.scale(factor)
        return replace(self, table=table, objects=objects)


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
    return read_inside(folder, name, limit, InputError, "folder")
