"""What an object is: its mesh, collision parts, physics and size (Secs. 3.2 and 3.4)."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np
from jaxtyping import Float, Int, UInt8

from ..errors import InputError
from .arrays import FARTHEST, OUTLINE, PICTURE, POINTS, SMALLEST, VECTOR, freeze

PartKind = Literal["hull", "box", "cylinder", "ellipsoid"]


@dataclass(frozen=True, eq=False)
class Mesh:
    """A textured triangle mesh. ``uv`` is per vertex (vertices repeat along seams).

    Faces turn counter-clockwise seen from outside. ``opacity`` below 1 draws it as glass.
    """

    vertices: Float[np.ndarray, "n 3"]
    faces: Int[np.ndarray, "m 3"]
    uv: Float[np.ndarray, "n 2"]
    texture: UInt8[np.ndarray, "th tw 3"]
    opacity: float = 1.0

    def __post_init__(self) -> None:
        freeze(self, vertices=(np.float32, (None, 3)), faces=(np.int32, (None, 3)))
        freeze(self, uv=(np.float32, (len(self.vertices), 2)), texture=PICTURE)
        if not 0 <= self.opacity <= 1:
            raise InputError(f"Mesh.opacity must be in [0, 1], got {self.opacity}.")
        if not self.texture.size:
            raise InputError("Mesh.texture needs at least one texel.")
        if not len(self.vertices) or not len(self.faces):
            raise InputError("A mesh needs at least one vertex and one face.")
        if self.faces.min() < 0 or self.faces.max() >= len(self.vertices):
            raise InputError(f"Mesh.faces must index its {len(self.vertices)} vertices.")

    @cached_property
    def bounds(self) -> Float[np.ndarray, "2 3"]:
        """Lowest and highest corner."""
        return np.stack([self.vertices.min(0), self.vertices.max(0)]).astype(np.float64)

    @property
    def extent(self) -> Float[np.ndarray, "3"]:
        """Size along each axis."""
        return self.bounds[1] - self.bounds[0]


@dataclass(frozen=True, eq=False)
class ConvexPart:
    """One convex piece of a collision shape: the convex hull of ``vertices``.

    ``kind`` "box", "cylinder" or "ellipsoid" says that the piece is that primitive, filling the
    axis-aligned bounds of ``vertices`` (a cylinder runs along ``axis``: 0, 1 or 2). Collision then
    uses the primitive wherever the object's scale keeps it one.
    """

    vertices: Float[np.ndarray, "n 3"]
    kind: PartKind = "hull"
    axis: Literal[0, 1, 2] = 2

    def __post_init__(self) -> None:
        freeze(self, FARTHEST, vertices=POINTS)
        if len(self.vertices) < 4:
            raise InputError(f"A convex part needs at least 4 points, got {len(self.vertices)}.")

    @cached_property
    def bounds(self) -> Float[np.ndarray, "2 3"]:
        """Lowest and highest corner, read-only."""
        corners = np.stack([self.vertices.min(0), self.vertices.max(0)])
        corners.setflags(write=False)
        return corners

    def __getstate__(self) -> dict[str, Any]:
        """Return what a copy keeps: no bounds, which follow."""
        return {"vertices": self.vertices, "kind": self.kind, "axis": self.axis}


@dataclass(frozen=True, eq=False)
class Slot:
    """A place that a holder has for one thing.

    ``at`` is where the middle of the thing's underside goes, in the holder's canonical frame;
    ``yaw`` is the thing's turn to the holder's, radians; ``name`` is the thing, if that is decided.
    """

    at: Float[np.ndarray, "3"]
    yaw: float = 0.0
    name: str = ""

    def __post_init__(self) -> None:
        freeze(self, FARTHEST, at=(np.float64, (3,)))


@dataclass(frozen=True)
class Physics:
    """What an object is made of. ``density`` in kg/m^3, ``friction`` the sliding coefficient.

    ``shell`` None: mass is density times the mesh's volume. Otherwise the object is hollow with
    walls ``shell`` metres thick: mass is density times surface area times ``shell``.
    """

    density: float = 600.0
    friction: float = 0.6
    shell: float | None = None

    def __post_init__(self) -> None:
        if not (0 < self.density < 3e4 and 0 < self.friction < 5):
            raise InputError(f"Physics needs density in (0, 30000) and friction in (0, 5): {self}.")
        if self.shell is not None and not 0 < self.shell < 1:
            raise InputError(f"Physics.shell is a wall thickness in (0, 1) m, got {self.shell}.")


@dataclass(frozen=True, eq=False)
class Model:
    """A canonical 3D model m_i (Sec. 3.2): +z up, unit box.

    ``size`` is the commonsense extent in metres along the canonical axes. ``parts`` are convex
    pieces in the canonical frame; without any, assembly decomposes the mesh. Things can be put into
    a ``container``. ``orientation``, a rotation matrix whose columns are the model's axes in the
    world, is how the modeler saw the thing in the picture, if it says: a hint that no bundle keeps.
    Neither keeps it the ``slots``, which are the places for things in a holder. ``stand_in`` marks
    a plain thing that only stands for what it is called.
    """

    name: str
    label: str
    mesh: Mesh
    size: Float[np.ndarray, "3"]
    physics: Physics = Physics()
    parts: tuple[ConvexPart, ...] = ()
    category: str = "generic"
    container: bool = False
    orientation: Float[np.ndarray, "3 3"] | None = None
    stand_in: bool = False
    slots: tuple[Slot, ...] = ()

    def __post_init__(self) -> None:
        freeze(self, FARTHEST, size=VECTOR)
        if (self.size < SMALLEST).any():
            raise InputError(f"Model.size must be metres, {SMALLEST:g} or more, got {self.size}.")
        if not np.allclose(self.mesh.bounds, [[-0.5] * 3, [0.5] * 3], atol=1e-3):
            raise InputError(
                f"Model {self.name!r}: mesh must fill the unit box [-0.5, 0.5]^3, "
                f"its bounds are {self.mesh.bounds.tolist()}. Use geometry.to_unit_box."
            )
        if self.orientation is not None:
            freeze(self, orientation=(np.float64, (3, 3)))
            seen = self.orientation
            if not (np.allclose(seen @ seen.T, np.eye(3), atol=1e-6) and np.linalg.det(seen) > 0):
                raise InputError(f"Model.orientation must be a rotation matrix, got {seen}.")


@dataclass(frozen=True, eq=False)
class Proportions:
    """The shape of a thing's upright box, as its look suggests, and how sure that is.

    ``logs`` are the natural logarithms of width over length and of height over length, the length
    being the longer horizontal side; ``spread`` is the mean absolute error to expect of each.
    """

    logs: Float[np.ndarray, "2"]
    spread: Float[np.ndarray, "2"]

    def __post_init__(self) -> None:
        freeze(self, logs=(np.float64, (2,)), spread=(np.float64, (2,)))
        if not (np.isfinite(self.logs).all() and (self.spread > 0).all()):
            raise InputError(f"Proportions must be finite and spread, got {self}.")

    @property
    def extent(self) -> Float[np.ndarray, "3"]:
        """The box (length, width, height) with a length of 1."""
        return np.array([1.0, *np.exp(self.logs)])

    def gap(self, extent: Float[np.ndarray, "3"]) -> float:
        """Return how far an extent's proportions are off, in expected errors, the mean of both."""
        length, width = max(extent[:2]), min(extent[:2])
        off = np.abs(np.log(np.array([width, extent[2]]) / length) - self.logs)
        return float((off / self.spread).mean())


@dataclass(frozen=True, eq=False)
class SizePrior:
    """A commonsense size (Fig. 22): extent (length, width, height) in metres, and its state.

    ``placement`` is e.g. "lying flat"; ``axes`` says what x, y and z are, e.g. "thickness".
    ``outline`` is a table's top seen from above, in metres about the middle of its extent, convex
    and counter-clockwise; None leaves its shape open.
    ``measured`` says that the extent is this very thing's, read from a depth map, not its kind's.
    ``seen`` are the proportions that this very thing looks to have; None where nobody looked.
    """

    name: str
    extent: Float[np.ndarray, "3"]
    placement: str = "as shown"
    axes: tuple[str, str, str] = ("length", "width", "height")
    outline: Float[np.ndarray, "k 2"] | None = None
    measured: bool = False
    seen: Proportions | None = None

    def __post_init__(self) -> None:
        freeze(self, extent=VECTOR)
        if (self.extent <= 0).any():
            raise InputError(f"SizePrior.extent must be positive metres, got {self.extent}.")
        if self.outline is not None:
            freeze(self, outline=OUTLINE)
