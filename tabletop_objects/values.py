"""Value types for meshes, convex parts, physical properties and sizes, in SI units, with z up.

*Canonical frame* of a model: its mesh fills the unit box ``[-0.5, 0.5]^3``; ``Model.size`` is its
extent in metres. *Texture coordinates* have u to the right and v upwards, so row 0 of a texture is
at v = 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from typing import Any, Literal

import numpy as np
from jaxtyping import Float, Int, UInt8

from .errors import InputError

FARTHEST = 1000.0
"""Maximum of all positions, sizes and distances in a scene, in metres."""

SMALLEST = 1e-6
"""Minimum extent of an object, in metres."""

ArrayKind = tuple[type[np.generic], tuple[int | None, ...]]
"""The type and shape of an array; None stands for any length."""

VECTOR: ArrayKind = (np.float64, (3,))
POINTS: ArrayKind = (np.float64, (None, 3))
OUTLINE: ArrayKind = (np.float64, (None, 2))
BOX: ArrayKind = (np.float64, (4,))
MASK: ArrayKind = (np.bool_, (None, None))
PICTURE: ArrayKind = (np.uint8, (None, None, 3))


def frozen_array(
    value: Any,
    dtype: type[np.generic],
    shape: tuple[int | None, ...],
    what: str,
    *,
    maximum: float | None = None,
) -> np.ndarray:
    """Convert ``value`` to a read-only ``dtype`` array; check its shape and that it is finite.

    A read-only array of this type that is not a view is returned as it is. ``None`` in
    ``shape`` accepts any length along that axis; ``maximum`` bounds the absolute values.

    Raises:
        InputError: the shape is wrong, or a number is NaN, infinite or out of bounds.
    """
    array = value if _is_frozen(value, dtype) else np.array(value, dtype=dtype)
    if array.shape != shape and not _fits(array.shape, shape):
        wanted = "×".join("n" if n is None else str(n) for n in shape)
        raise InputError(f"{what} must have shape {wanted}, got {array.shape}.")
    if array.dtype.kind == "f" and not np.isfinite(array).all():
        raise InputError(f"{what} contains NaN or infinity; all numbers must be finite.")
    if maximum is not None and array.size and np.abs(array).max() > maximum:
        raise InputError(f"{what} must not contain numbers above {maximum:g} in magnitude.")
    array.setflags(write=False)
    return array


def _is_frozen(value: Any, dtype: type[np.generic]) -> bool:
    return (
        type(value) is np.ndarray
        and value.dtype == dtype
        and value.base is None
        and not value.flags.writeable
    )


def _fits(have: tuple[int, ...], wanted: tuple[int | None, ...]) -> bool:
    return len(have) == len(wanted) and all(
        want is None or want == size for want, size in zip(wanted, have, strict=True)
    )


def freeze(instance: object, maximum: float | None = None, /, **kinds: ArrayKind) -> None:
    """Convert fields of a frozen dataclass to read-only arrays; see ``frozen_array``."""
    for name, (dtype, shape) in kinds.items():
        what = f"{type(instance).__name__}.{name}"
        array = frozen_array(getattr(instance, name), dtype, shape, what, maximum=maximum)
        object.__setattr__(instance, name, array)


PartKind = Literal["hull", "box", "cylinder", "ellipsoid"]


@dataclass(frozen=True, eq=False)
class Mesh:
    """A textured triangle mesh with texture coordinates ``uv`` per vertex.

    Vertices along texture seams are duplicated. Faces are counter-clockwise seen from outside.
    ``opacity`` below 1 renders it as glass.
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
        """The minimum and maximum corners of the bounding box."""
        return np.stack([self.vertices.min(0), self.vertices.max(0)]).astype(np.float64)

    @property
    def extent(self) -> Float[np.ndarray, "3"]:
        """The size along each axis."""
        return self.bounds[1] - self.bounds[0]

    @property
    def area(self) -> float:
        """The surface area."""
        a, b, c = self.vertices.astype(float)[self.faces].transpose(1, 0, 2)
        return float(np.linalg.norm(np.cross(b - a, c - a), axis=1).sum()) / 2


@dataclass(frozen=True, eq=False)
class ConvexPart:
    """A convex part of a collision shape: the convex hull of ``vertices``.

    If ``kind`` is "box", "cylinder" or "ellipsoid", the piece is that primitive and fills the
    axis-aligned bounds of ``vertices`` (a cylinder runs along ``axis``: 0, 1 or 2). Collision then
    uses the primitive if the object's scale preserves it.
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
        """The minimum and maximum corners of the bounding box, read-only."""
        corners = np.stack([self.vertices.min(0), self.vertices.max(0)])
        corners.setflags(write=False)
        return corners

    def __getstate__(self) -> dict[str, Any]:
        """Return the state for copying or pickling, without the cached bounds."""
        return {"vertices": self.vertices, "kind": self.kind, "axis": self.axis}


@dataclass(frozen=True, eq=False)
class Slot:
    """A slot for one object in a holder such as a toast rack.

    ``at`` is where the centre of the object's underside goes, in the holder's canonical frame;
    ``yaw`` is the object's rotation relative to the holder, in radians; and ``name`` is the
    object's name, if it is known.
    """

    at: Float[np.ndarray, "3"]
    yaw: float = 0.0
    name: str = ""

    def __post_init__(self) -> None:
        freeze(self, FARTHEST, at=(np.float64, (3,)))


@dataclass(frozen=True)
class Physics:
    """The physical properties of an object: the ``density`` in kg/m^3 and the sliding ``friction``.

    Without a ``shell``, the mass is density times the mesh's volume. Otherwise the object is hollow
    with walls ``shell`` metres thick: the mass is density times surface area times ``shell``.
    """

    density: float = 600.0
    friction: float = 0.6
    shell: float | None = None

    def __post_init__(self) -> None:
        if not (0 < self.density < 3e4 and 0 < self.friction < 5):
            raise InputError(
                f"Physics must have density in (0, 30000) and friction in (0, 5), got {self}."
            )
        if self.shell is not None and not 0 < self.shell < 1:
            raise InputError(
                f"Physics.shell must be a wall thickness in (0, 1) m, got {self.shell}."
            )


@dataclass(frozen=True, eq=False)
class Model:
    """A canonical 3D model m_i (Sec. 3.2 of the paper) that fills the unit box, with +z up.

    ``size`` is the commonsense extent in metres along the canonical axes. ``parts`` are convex
    pieces in the canonical frame; without any, assembly decomposes the mesh. A ``container`` can
    hold objects. ``orientation`` is the modeler's optional estimate of the object's rotation in the
    picture, as a matrix whose columns are the model's axes in the world. ``slots`` are the slots of
    a holder. Bundles store neither ``orientation`` nor ``slots``. ``stand_in`` marks a plain
    placeholder for the named object.
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
                f"Model {self.name!r}: mesh must fill the unit box [-0.5, 0.5]^3, but the bounds "
                f"are {self.mesh.bounds.tolist()}. Use values.to_unit_box."
            )
        if self.orientation is not None:
            freeze(self, orientation=(np.float64, (3, 3)))
            seen = self.orientation
            if not (np.allclose(seen @ seen.T, np.eye(3), atol=1e-6) and np.linalg.det(seen) > 0):
                raise InputError(f"Model.orientation must be a rotation matrix, got {seen}.")


def to_unit_box(mesh: Mesh) -> tuple[Mesh, Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
    """Scale and centre ``mesh`` so that it fills the canonical unit box.

    Returns the mesh and its original ``center`` and ``extent``: ``v_unit = (v - center) / extent``.
    A flat mesh gets an extent of at least 1e-4 along its flat axis before the division.
    """
    low, high = mesh.bounds
    center, extent = (low + high) / 2, np.maximum(high - low, 1e-4)
    vertices = np.clip((mesh.vertices - center) / extent, -0.5, 0.5)
    return Mesh(vertices, mesh.faces, mesh.uv, mesh.texture, mesh.opacity), center, extent


def parts_to_unit_box(
    parts: tuple[ConvexPart, ...], center: Float[np.ndarray, "3"], extent: Float[np.ndarray, "3"]
) -> tuple[ConvexPart, ...]:
    """Transform convex parts into the canonical frame of ``to_unit_box``."""
    return tuple(ConvexPart((p.vertices - center) / extent, p.kind, p.axis) for p in parts)


Extent = tuple[float, float, float]

Stance = Literal["edge", "end", "side"]
"""How a holder holds an object: on edge like toast, on end like a test tube, or on its side."""


@dataclass(frozen=True)
class Holder:
    """The slots of a holder, in which objects stand side by side along the holder's x axis.

    Attributes:
        stance: how objects stand in their slots.
        room: extent of the largest object that fits, in metres along the holder's x, y and z.
    """

    stance: Stance
    room: Extent

    def stand(self, extent: Extent) -> Extent:
        """Return an object's extent in its slot, in metres along the holder's x, y and z axes."""
        narrow, middle, longest = sorted(extent)
        if self.stance == "edge":
            return narrow, longest, middle
        return (narrow, middle, longest) if self.stance == "end" else (middle, longest, narrow)

    def takes(self, extent: Extent) -> bool:
        """Return whether an object of this extent (in metres) fits into a slot."""
        return all(a <= b for a, b in zip(self.stand(extent), self.room, strict=True))


def write_room(extent: Extent) -> str:
    """Format an extent as the value of a holder's "room" attribute."""
    return " ".join(f"{side:.4f}" for side in extent)


def read_room(text: str | None, usual: Extent) -> Extent:
    """Parse the extent in a "room" attribute; return ``usual`` if ``text`` is None."""
    if text is None:
        return usual
    across, along, up = (float(word) for word in text.split())
    return across, along, up
