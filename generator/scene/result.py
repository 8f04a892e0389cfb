"""Poses and placements, and the scene that they form (Secs. 3.3 and 3.4)."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any, Literal

import numpy as np
from jaxtyping import Float

from tabletop_objects.values import FARTHEST, OUTLINE, SMALLEST, VECTOR, ConvexPart, Model, freeze

from ..errors import InputError, choices
from ..io.bounded import printable
from .picture import USUAL_VIEW, View
from .plan import TABLE, ScenePlan
from .report import Report

_MIN_MASS = 1e-9  # kg; MuJoCo's own limit is one millionth of this
_MIN_TOP = 1e-6  # area of a tabletop, square metres
_MAX_TURN = 1e4  # radians


@dataclass(frozen=True)
class Rotation:
    """An estimated yaw r_i in radians (Sec. 3.3, DRO), and its certainty.

    Attributes:
        yaw, loss: the best estimate; ``candidates`` are the final (yaw, loss) pairs compared.
        margin: how much worse the best clearly different yaw (20 degrees or more away) fits, as a
            fraction of the loss, >= 0; both losses are at the highest resolution evaluated. If it
            is near 0, the picture hardly distinguishes the two yaws.
        width: change of yaw, radians in (0, pi], that raises the loss by 2 %, computed from the
            loss curvature at the minimum. If the model is right and the yaw faces the right way,
            about two thirds of the errors are smaller.
        symmetric: whether the object looks the same from all sides; then yaw and ``margin`` are 0
            and ``width`` is pi.
        order: the object looks the same after a turn by 2 pi / ``order`` (a plain box after a half
            turn). Such yaws count as one answer, and ``margin`` compares it with the others. The
            order is determined only if another side fits about as well; otherwise it is 1.
    """

    name: str
    yaw: float
    loss: float
    candidates: tuple[tuple[float, float], ...] = ()
    margin: float = 0.0
    width: float = float(np.pi)
    symmetric: bool = False
    order: int = 1

    def __post_init__(self) -> None:
        if self.order < 1:
            raise InputError(f"Rotation {self.name!r}: order must be >= 1, got {self.order}.")
        if not (np.isfinite(self.yaw) and 0 <= self.margin < np.inf and 0 < self.width <= np.pi):
            raise InputError(
                f"Rotation {self.name!r} must have a finite yaw, a finite margin >= 0 and a "
                f"width in (0, pi], got yaw {self.yaw}, margin {self.margin}, width {self.width}."
            )


@dataclass(frozen=True)
class Stacking:
    """Support of an instance (Fig. 25): ``on`` is a name or "table"; ``inside`` means not on top.

    An ``order`` of 1 means on the table; a supported object has a higher order than its support.
    """

    order: int
    on: str = TABLE
    inside: bool = False


@dataclass(frozen=True, eq=False)
class Placement:
    """The pose and scale of one object, (r_i, t_i, s_i) of Sec. 3, in the world frame."""

    name: str
    yaw: float
    translation: Float[np.ndarray, "3"]
    scale: Float[np.ndarray, "3"]
    on: str = TABLE
    inside: bool = False

    def __post_init__(self) -> None:
        freeze(self, FARTHEST, scale=VECTOR)
        if (self.scale < SMALLEST).any() or not abs(self.yaw) < _MAX_TURN:
            raise InputError(
                f"Placement {self.name!r}: scale must be {SMALLEST:g} m or more, and yaw below "
                f"{_MAX_TURN:g} rad in magnitude, got {self.scale} and {self.yaw}."
            )
        freeze(self, FARTHEST, translation=VECTOR)


@dataclass(frozen=True, eq=False)
class LayoutBox:
    """Requested position and size of an object in metres, as a box on the tabletop.

    ``center`` is relative to the middle of the tabletop, +x right and +y away in the world frame;
    ``size`` is the extent (length, width, height) along the object's own axes, as in ``SizePrior``.
    """

    center: Float[np.ndarray, "2"]
    size: Float[np.ndarray, "3"]

    def __post_init__(self) -> None:
        freeze(self, size=VECTOR)
        if (self.size <= 0).any():
            raise InputError(f"LayoutBox.size must be positive, in metres, got {self.size}.")
        freeze(self, center=(np.float64, (2,)))


@dataclass(frozen=True, eq=False)
class Pose:
    """A rigid pose in the world frame; ``quaternion`` is a unit quaternion in wxyz order."""

    position: Float[np.ndarray, "3"]
    quaternion: Float[np.ndarray, "4"]

    def __post_init__(self) -> None:
        freeze(self, quaternion=(np.float64, (4,)))
        if abs(np.linalg.norm(self.quaternion) - 1) > 1e-4:
            raise InputError(f"Pose.quaternion must have length 1, got {self.quaternion}.")
        freeze(self, FARTHEST, position=VECTOR)


@dataclass(frozen=True, eq=False)
class Object:
    """One rigid body of a scene.

    Its body frame is the canonical frame scaled to metres (origin at the centre of the box).
    ``parts`` are in that frame, in metres, as are ``com`` and ``inertia`` (about ``com``, kg m^2).
    ``placement`` is the estimate from the image; ``pose`` is the pose at rest after settling.
    """

    name: str
    model: Model
    placement: Placement
    parts: tuple[ConvexPart, ...]
    mass: float
    com: Float[np.ndarray, "3"]
    inertia: Float[np.ndarray, "3 3"]
    friction: float
    pose: Pose

    def __post_init__(self) -> None:
        if not _MIN_MASS <= self.mass < 1e3:
            raise InputError(
                f"Object {self.name!r}: mass must be in [{_MIN_MASS:g}, 1000) kg, got {self.mass}."
            )
        if not 0 < self.friction < 5:
            raise InputError(
                f"Object {self.name!r}: friction must be in (0, 5), got {self.friction}."
            )
        if not self.parts:
            raise InputError(f"Object {self.name!r}: at least one convex part is required.")
        freeze(self, FARTHEST, com=VECTOR)
        freeze(self, 1e9, inertia=(np.float64, (3, 3)))

    @property
    def label(self) -> str:
        """The object's noun."""
        return self.model.label

    @property
    def scale(self) -> Float[np.ndarray, "3"]:
        """The extent along the object's own axes, in metres."""
        return self.placement.scale


@dataclass(frozen=True, eq=False)
class Table:
    """The table: a fixed body that stands on the floor z = 0, centred over the origin.

    ``scale`` is its extent in metres. ``parts`` are convex pieces in the table's body frame (origin
    at the centre of its box, at world (0, 0, height / 2)), in metres. ``outline`` is the convex
    outline of the top, world x and y, counter-clockwise.
    """

    model: Model
    scale: Float[np.ndarray, "3"]
    parts: tuple[ConvexPart, ...]
    outline: Float[np.ndarray, "k 2"]
    friction: float = 0.6

    def __post_init__(self) -> None:
        freeze(self, FARTHEST, scale=VECTOR, outline=OUTLINE)
        if (self.scale < SMALLEST).any() or len(self.outline) < 3 or not self.parts:
            raise InputError(
                "Table must have a positive scale, at least 3 outline points and at least one "
                f"convex part, got scale {self.scale}, {len(self.outline)} points and "
                f"{len(self.parts)} parts."
            )
        x, y = self.outline.T
        if np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) < 2 * _MIN_TOP:
            raise InputError(
                f"Table.outline must run counter-clockwise and enclose at least {_MIN_TOP:g} m^2."
            )
        if not 0 < self.friction < 5:
            raise InputError(f"Table: friction must be in (0, 5), got {self.friction}.")

    @property
    def height(self) -> float:
        """The height of the top surface above the floor, in metres."""
        return float(self.scale[2])


EditKind = Literal["swap", "add", "remove", "move", "restyle"]


@dataclass(frozen=True)
class Edit:
    """One change made to a finished scene.

    ``edited`` is the sha256 of the edited ``scene.json``; its first 12 digits end that bundle's
    name. ``names`` are the objects created, moved or removed, ``asked`` is the request, and
    ``backends`` are the backends that created new objects.
    """

    edited: str
    kind: EditKind
    names: tuple[str, ...]
    asked: str
    seed: int = 0
    backends: Mapping[str, Any] = field(default_factory=dict[str, Any])
    config: Mapping[str, Any] = field(default_factory=dict[str, Any])
    versions: Mapping[str, str] = field(default_factory=dict[str, str])


@dataclass(frozen=True)
class Provenance:
    """A record that suffices to reproduce a scene, without secrets, paths or clock times.

    ``edits`` are the subsequent changes, oldest first.
    """

    kind: Literal["text", "image", "compose", "manual"]
    seed: int
    prompt: str | None = None
    source_sha256: str | None = None
    backends: Mapping[str, Any] = field(default_factory=dict[str, Any])
    config: Mapping[str, Any] = field(default_factory=dict[str, Any])
    versions: Mapping[str, str] = field(default_factory=dict[str, str])
    warnings: tuple[str, ...] = ()
    edits: tuple[Edit, ...] = ()


@dataclass(frozen=True, eq=False)
class Scene:
    """A complete tabletop scene S = {o_i} (Sec. 3)."""

    name: str
    table: Table
    objects: tuple[Object, ...]
    provenance: Provenance
    view: View = USUAL_VIEW
    report: Report | None = None
    plan: ScenePlan | None = None

    def __post_init__(self) -> None:
        names = [o.name for o in self.objects]
        doubles = sorted({n for n in names if names.count(n) > 1})
        if doubles or TABLE in names:
            raise InputError(f"Object names must be unique and not {TABLE!r}; repeated: {doubles}.")
        for name in names:  # names are also MuJoCo body names, where slashes separate prefixes
            printable(name, "An object name", InputError)
            if not name or name == "world" or "/" in name:
                raise InputError(
                    f"{name!r} is not a valid object name; use printable characters without '/', "
                    "and not 'world', which MuJoCo reserves."
                )

    def object(self, name: str) -> Object:
        """Return the object with the given name."""
        for candidate in self.objects:
            if candidate.name == name:
                return candidate
        known = choices(name, (o.name for o in self.objects))
        raise InputError(f"Scene {self.name!r} has no object {name!r}.{known}")

    def replace(self, **changes: Any) -> Scene:
        """Return a copy with some fields replaced."""
        return dataclasses.replace(self, **changes)
