"""Where things are, and the scene they make (Secs. 3.3 and 3.4)."""

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

_LEAST_MASS = 1e-9  # of an object, kg; MuJoCo's own limit is a millionth of it
_LEAST_TOP = 1e-6  # of a tabletop, square metres
_MOST_TURN = 1e4  # radians


@dataclass(frozen=True)
class Rotation:
    """An estimated yaw r_i (Sec. 3.3, DRO), radians, and how sure it is.

    Attributes:
        yaw, loss: what was found; ``candidates`` are the (yaw, loss) compared at the end.
        margin: by how much the best clearly different yaw (20 degrees or more away) fits worse, as
            a share of the loss, >= 0, each at the closest look it was given. Near 0 the picture
            hardly tells the two apart.
        width: change of yaw, radians in (0, pi], that raises the loss by a fiftieth, by the loss's
            curvature at its least. With the right side and model, about two thirds of the errors
            are smaller.
        symmetric: the object looks the same from all sides: yaw 0, ``margin`` 0, ``width`` pi.
        order: turned by 2 pi / ``order`` the object looks the same (a plain box by a half turn):
            such yaws are one answer, and ``margin`` is against others. Asked only where another
            side fits about as well; else 1.
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
            raise InputError(f"Rotation {self.name!r} needs an order >= 1, got {self.order}.")
        if not (np.isfinite(self.yaw) and 0 <= self.margin < np.inf and 0 < self.width <= np.pi):
            raise InputError(
                f"Rotation {self.name!r} needs a finite yaw, a finite margin >= 0 and a "
                f"width in (0, pi], got yaw {self.yaw}, margin {self.margin}, width {self.width}."
            )


@dataclass(frozen=True)
class Stacking:
    """What an instance stands on (Fig. 25): ``on`` is a name or "table"; ``inside`` a container.

    ``order`` 1 is the table; a supported thing has a higher order than its support.
    """

    order: int
    on: str = TABLE
    inside: bool = False


@dataclass(frozen=True, eq=False)
class Placement:
    """Pose and scale of one object: (r_i, t_i, s_i) of Sec. 3, in the world frame."""

    name: str
    yaw: float
    translation: Float[np.ndarray, "3"]
    scale: Float[np.ndarray, "3"]
    on: str = TABLE
    inside: bool = False

    def __post_init__(self) -> None:
        freeze(self, FARTHEST, scale=VECTOR)
        if (self.scale < SMALLEST).any() or not abs(self.yaw) < _MOST_TURN:
            raise InputError(
                f"Placement {self.name!r}: scale must be {SMALLEST:g} m or more, and yaw finite, "
                f"got {self.scale} and {self.yaw}."
            )
        freeze(self, FARTHEST, translation=VECTOR)


@dataclass(frozen=True, eq=False)
class LayoutBox:
    """Where and how large someone says that a thing is: a box on the tabletop, metres.

    ``center`` is from the middle of the tabletop, +x right and +y away in the world frame;
    ``size`` is the extent (length, width, height) along the thing's own axes, as in ``SizePrior``.
    """

    center: Float[np.ndarray, "2"]
    size: Float[np.ndarray, "3"]

    def __post_init__(self) -> None:
        freeze(self, size=VECTOR)
        if (self.size <= 0).any():
            raise InputError(f"LayoutBox.size must be positive metres, got {self.size}.")
        freeze(self, center=(np.float64, (2,)))


@dataclass(frozen=True, eq=False)
class Pose:
    """A rigid pose in the world frame; ``quaternion`` is a unit wxyz."""

    position: Float[np.ndarray, "3"]
    quaternion: Float[np.ndarray, "4"]

    def __post_init__(self) -> None:
        freeze(self, quaternion=(np.float64, (4,)))
        if abs(np.linalg.norm(self.quaternion) - 1) > 1e-4:
            raise InputError(f"Pose.quaternion must have length 1, got {self.quaternion}.")
        freeze(self, FARTHEST, position=VECTOR)


@dataclass(frozen=True, eq=False)
class Object:
    """One separate body of a scene.

    Its body frame is the canonical frame scaled to metres (origin at the centre of the box).
    ``parts`` are in that frame in metres, as are ``com`` and ``inertia`` (about ``com``, kg m^2).
    ``placement`` is what the image said; ``pose`` is where it rests after settling.
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
        if not _LEAST_MASS <= self.mass < 1e3:
            raise InputError(
                f"Object {self.name!r}: mass must be in [{_LEAST_MASS:g}, 1000) kg: {self.mass}."
            )
        if not 0 < self.friction < 5:
            raise InputError(f"Object {self.name!r}: friction must be in (0, 5): {self.friction}.")
        if not self.parts:
            raise InputError(f"Object {self.name!r}: a body needs at least one convex part.")
        freeze(self, FARTHEST, com=VECTOR)
        freeze(self, 1e9, inertia=(np.float64, (3, 3)))

    @property
    def label(self) -> str:
        """The word for it."""
        return self.model.label

    @property
    def scale(self) -> Float[np.ndarray, "3"]:
        """Extent along its own axes in metres."""
        return self.placement.scale


@dataclass(frozen=True, eq=False)
class Table:
    """The table: fixed in the world, standing on the floor z = 0 under the origin.

    ``scale`` is its extent in metres. ``parts`` are convex pieces in the table's body frame (origin
    at the centre of its box, at world (0, 0, height / 2)), in metres. ``outline`` is the top's
    convex outline, world x and y, counter-clockwise.
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
                f"Table needs a positive scale, an outline of 3 points and one convex part, got "
                f"{self.scale}, {len(self.outline)} and {len(self.parts)}."
            )
        x, y = self.outline.T
        if np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) < 2 * _LEAST_TOP:
            raise InputError(
                f"Table.outline must turn counter-clockwise around {_LEAST_TOP:g} m^2 or more."
            )
        if not 0 < self.friction < 5:
            raise InputError(f"Table: friction must be in (0, 5): {self.friction}.")

    @property
    def height(self) -> float:
        """Height of the top surface above the floor, metres."""
        return float(self.scale[2])


EditKind = Literal["swap", "add", "remove", "move", "restyle"]


@dataclass(frozen=True)
class Edit:
    """One change made to a finished scene.

    ``edited`` is the sha256 of the ``scene.json`` that was edited; its first 12 digits end that
    bundle's name. ``names`` are the things made, moved or taken away, ``asked`` is what was asked
    for, ``backends`` who made what is new.
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
    """Where a scene comes from, enough to make it again. Holds no secret, path or clock time.

    ``edits`` are the changes made to it since, the first one first.
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
        for name in names:  # they name MuJoCo's bodies; a slash marks what an environment adds
            printable(name, "What an object is called", InputError)
            if not name or name == "world" or "/" in name:
                raise InputError(
                    f"An object cannot be called {name!r}; use printable characters without '/', "
                    "and not 'world', which MuJoCo keeps for itself."
                )

    def object(self, name: str) -> Object:
        """Return the object called ``name``."""
        for candidate in self.objects:
            if candidate.name == name:
                return candidate
        known = choices(name, (o.name for o in self.objects))
        raise InputError(f"Scene {self.name!r} has no object {name!r}.{known}")

    def replace(self, **changes: Any) -> Scene:
        """Return a copy with some fields replaced."""
        return dataclasses.replace(self, **changes)
