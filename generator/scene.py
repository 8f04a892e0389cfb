"""The nouns of the pipeline: frozen values that flow from a text or an image to a scene.

Frames and units, stated once for the whole project
---------------------------------------------------
SI metres, kilograms, radians, seconds; quaternions are ``wxyz`` as in MuJoCo.

*World (table) frame*: right-handed, origin on the floor under the table's centre, +x right and
+y away *as seen in the reference image*, +z up. Yaw turns about +z, counter-clockwise seen from
above.

*Canonical object frame*: +z up, the mesh normalised to the unit box ``[-0.5, 0.5]^3``. ``scale``
is the object's *extent* along its own axes in metres; ``translation`` is the *centre of its box*.

*Images* are ``uint8`` RGB, row 0 at the top. *Pixel boxes* are ``(x0, y0, x1, y1)``, right and
bottom exclusive. *Texture coordinates* have u to the right and v upwards (Wavefront OBJ), so
texture row 0 is v = 1.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Literal, get_args

import numpy as np
from jaxtyping import Bool, Float, Int, UInt8

from .errors import InputError, choices

TABLE = "table"
"""Name of the table, as an instance and as a support."""

RelationKind = Literal[
    "left_of", "right_of", "in_front_of", "behind", "on", "in", "next_to", "center", "edge"
]
OutlineKind = Literal["rectangle", "square", "round", "oval", "triangle", "slatted"]
PartKind = Literal["hull", "box", "cylinder", "ellipsoid"]


def frozen_array(
    value: Any, dtype: type[np.generic], shape: tuple[int | None, ...], what: str
) -> np.ndarray:
    """Return a read-only copy of ``value`` with ``dtype``, checked for shape and finiteness.

    ``None`` in ``shape`` accepts any length along that axis.

    Raises:
        InputError: wrong number of axes or length, or a NaN or infinity.
    """
    array = np.array(value, dtype=dtype)
    fits = array.ndim == len(shape) and all(
        want is None or want == have for want, have in zip(shape, array.shape, strict=True)
    )
    if not fits:
        wanted = "×".join("n" if n is None else str(n) for n in shape)
        raise InputError(f"{what} must have shape {wanted}, got {array.shape}.")
    if np.issubdtype(array.dtype, np.floating) and not np.isfinite(array).all():
        raise InputError(f"{what} holds NaN or infinity; every number must be finite.")
    array.setflags(write=False)
    return array


def _freeze(instance: object, **arrays: np.ndarray) -> None:
    for name, array in arrays.items():
        object.__setattr__(instance, name, array)


# ----------------------------------------------------------------------------- what a text asks


@dataclass(frozen=True)
class Relation:
    """Where a planned object goes: ``kind`` relative to ``target`` (an object name or "table")."""

    kind: RelationKind
    target: str = TABLE


@dataclass(frozen=True)
class PlannedObject:
    """One object a text asks for.

    ``name`` is unique ("mug_1"); ``noun`` is the word used; ``category`` is a catalogue key, or
    "generic" when no category fits. ``attributes`` maps "color", "material", "size" ("small",
    "large") and "state" to words. ``size`` is the extent in metres if the text fixed one.
    """

    name: str
    noun: str
    category: str
    attributes: Mapping[str, str] = field(default_factory=dict)
    relations: tuple[Relation, ...] = ()
    size: tuple[float, float, float] | None = None

    def __post_init__(self) -> None:
        if self.size is not None:
            _check_extent(self.size, f"PlannedObject {self.name!r}")
        for relation in self.relations:
            if relation.kind not in get_args(RelationKind):
                raise InputError(
                    f"{self.name!r} has an unknown relation {relation.kind!r}."
                    + choices(str(relation.kind), get_args(RelationKind))
                )


@dataclass(frozen=True)
class PlannedTable:
    """The table a text asks for. ``size`` is (length x, width y, height z) in metres."""

    outline: OutlineKind = "rectangle"
    material: str = "oak"
    legs: str = "straight"
    size: tuple[float, float, float] = (1.2, 0.7, 0.74)
    color: str | None = None

    def __post_init__(self) -> None:
        _check_extent(self.size, "PlannedTable")
        if self.outline not in get_args(OutlineKind):
            raise InputError(
                f"Unknown table outline {self.outline!r}."
                + choices(str(self.outline), get_args(OutlineKind))
            )


@dataclass(frozen=True)
class ScenePlan:
    """What a text asks for (Sec. 3, Fig. 8): the table, its objects, a style; no coordinates."""

    prompt: str
    table: PlannedTable
    objects: tuple[PlannedObject, ...]
    style: str = "plain"
    warnings: tuple[str, ...] = ()

    def __post_init__(self) -> None:
        names = [planned.name for planned in self.objects]
        if len(set(names)) < len(names) or TABLE in names:
            raise InputError(f"Planned names must be unique and not {TABLE!r}: {names}.")
        on = {p.name: [r.target for r in p.relations if r.kind in ("on", "in")]
              for p in self.objects}  # fmt: skip
        for planned in self.objects:
            for target in (relation.target for relation in planned.relations):
                if target == planned.name or target not in (*names, TABLE):
                    raise InputError(
                        f"{planned.name!r} is related to {target!r}." + choices(target, names)
                    )
            below = set(on[planned.name])
            while (deeper := below.union(*(on.get(name, ()) for name in below))) != below:
                below = deeper
            if planned.name in below:
                raise InputError(f"{planned.name!r} stands on itself, by way of {sorted(below)}.")


def _check_extent(size: tuple[float, float, float], what: str) -> None:
    extent = frozen_array(size, np.float64, (3,), f"{what}.size")
    if (extent <= 0).any():
        raise InputError(f"{what}: size must be positive metres, got {tuple(size)}.")


# ------------------------------------------------------------------------ what a picture holds


@dataclass(frozen=True)
class Intrinsics:
    """Focal lengths and principal point of one picture's camera, in its pixels.

    As calibrations state them (OpenCV, ROS): x right, y down, and the *centre* of the top-left
    pixel at (0, 0), so that a centred principal point is ((width - 1) / 2, (height - 1) / 2).
    """

    fx: float
    fy: float
    cx: float
    cy: float

    def __post_init__(self) -> None:
        numbers = (self.fx, self.fy, self.cx, self.cy)
        if not np.isfinite(numbers).all() or min(self.fx, self.fy) <= 0:
            raise InputError(f"Intrinsics need finite numbers, fx and fy positive: {numbers}.")

    def scaled(self, across: float, down: float) -> Intrinsics:
        """Return the intrinsics of the picture resized by these factors."""
        cx, cy = (self.cx + 0.5) * across - 0.5, (self.cy + 0.5) * down - 0.5
        return Intrinsics(self.fx * across, self.fy * down, cx, cy)


@dataclass(frozen=True, eq=False)
class Reference:
    """The reference image I_ref (Sec. 3). ``plan`` and ``prompt`` are there if a text was.

    Of an RGB-D picture ``depth`` is the distance along the optical axis in metres, 0 where it is
    unknown, and ``intrinsics`` are the camera's; both are there or neither.
    """

    image: UInt8[np.ndarray, "h w 3"]
    prompt: str | None = None
    plan: ScenePlan | None = None
    depth: Float[np.ndarray, "h w"] | None = None
    intrinsics: Intrinsics | None = None

    def __post_init__(self) -> None:
        _freeze(self, image=frozen_array(self.image, np.uint8, (None, None, 3), "Reference.image"))
        if (self.depth is None) != (self.intrinsics is None):
            raise InputError("A Reference needs depth and intrinsics together, or neither.")
        if self.depth is not None:
            depth = frozen_array(self.depth, np.float32, self.image.shape[:2], "Reference.depth")
            if depth.min() < 0:
                raise InputError("Reference.depth is in metres; 0 means unknown, none is below 0.")
            _freeze(self, depth=depth)


@dataclass(frozen=True, eq=False)
class Detection:
    """One segmented region of an image: label, tight pixel box, mask, score in [0, 1].

    ``full`` is the whole object's mask, what other things hide of it included, if the segmenter
    can tell; None leaves that to the completion.
    """

    label: str
    box: Float[np.ndarray, "4"]
    mask: Bool[np.ndarray, "h w"]
    score: float = 1.0
    full: Bool[np.ndarray, "h w"] | None = None

    def __post_init__(self) -> None:
        mask = frozen_array(self.mask, np.bool_, (None, None), "Detection.mask")
        _freeze(self, box=frozen_array(self.box, np.float64, (4,), "Detection.box"), mask=mask)
        if self.full is not None:
            _freeze(self, full=frozen_array(self.full, np.bool_, mask.shape, "Detection.full"))


@dataclass(frozen=True, eq=False)
class Instance:
    """One object of the reference image (Sec. 3.1).

    ``mask`` (visible pixels, holes filled) and ``box`` are in reference pixels; ``crop`` is the
    completed, clean RGBA picture of the object alone, and ``crop_box`` the square or rectangle of
    reference pixels that the crop shows (it may leave the image); ``occluded`` tells whether
    something was completed.
    """

    name: str
    label: str
    box: Float[np.ndarray, "4"]
    mask: Bool[np.ndarray, "h w"]
    crop: UInt8[np.ndarray, "ch cw 4"]
    crop_box: Float[np.ndarray, "4"]
    occluded: bool = False
    score: float = 1.0

    def __post_init__(self) -> None:
        _freeze(
            self,
            box=frozen_array(self.box, np.float64, (4,), "Instance.box"),
            mask=frozen_array(self.mask, np.bool_, (None, None), "Instance.mask"),
            crop=frozen_array(self.crop, np.uint8, (None, None, 4), "Instance.crop"),
            crop_box=frozen_array(self.crop_box, np.float64, (4,), "Instance.crop_box"),
        )


@dataclass(frozen=True)
class View:
    """The camera of the reference image (Sec. 3.3), in radians.

    ``azimuth`` 0 looks along +y (from the front); positive moves the camera towards +x.
    ``elevation`` is above the horizon, in (0, pi/2]. ``fov`` is the vertical field of view.
    ``roll`` turns the camera about its sight: positive dips its right side, and what it shows
    turns counter-clockwise.
    """

    azimuth: float
    elevation: float
    fov: float
    roll: float = 0.0

    def __post_init__(self) -> None:
        if not np.isfinite([self.azimuth, self.elevation, self.fov, self.roll]).all():
            raise InputError("View holds NaN or infinity; angles are finite radians.")
        if not 0 < self.elevation <= np.pi / 2 + 1e-9 or not 0 < self.fov < np.pi:
            raise InputError(
                f"View needs elevation in (0, pi/2] and fov in (0, pi) radians, got {self}."
            )


@dataclass(frozen=True, eq=False)
class TopView:
    """The table seen from straight above, I_top (Sec. 3.3, TSA).

    Orthographic: +u is world +x, +v (down) is world -y. ``table_box`` and ``boxes`` (by instance
    name) are pixel boxes in it. ``repaired`` names the instances whose box came from geometry
    instead of the drawn picture. ``metres_per_pixel`` is there if the scale was measured.
    """

    image: UInt8[np.ndarray, "h w 3"]
    table_box: Float[np.ndarray, "4"]
    boxes: Mapping[str, Float[np.ndarray, "4"]]
    repaired: tuple[str, ...] = ()
    metres_per_pixel: float | None = None

    def __post_init__(self) -> None:
        boxes = {
            name: frozen_array(box, np.float64, (4,), f"TopView.boxes[{name!r}]")
            for name, box in self.boxes.items()
        }
        object.__setattr__(self, "boxes", boxes)
        _freeze(
            self,
            image=frozen_array(self.image, np.uint8, (None, None, 3), "TopView.image"),
            table_box=frozen_array(self.table_box, np.float64, (4,), "TopView.table_box"),
        )


# --------------------------------------------------------------------------- what an object is


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
        vertices = frozen_array(self.vertices, np.float32, (None, 3), "Mesh.vertices")
        faces = frozen_array(self.faces, np.int32, (None, 3), "Mesh.faces")
        uv = frozen_array(self.uv, np.float32, (len(vertices), 2), "Mesh.uv")
        texture = frozen_array(self.texture, np.uint8, (None, None, 3), "Mesh.texture")
        if not len(vertices) or not len(faces):
            raise InputError("A mesh needs at least one vertex and one face.")
        if faces.min() < 0 or faces.max() >= len(vertices):
            raise InputError(f"Mesh.faces must index its {len(vertices)} vertices.")
        _freeze(self, vertices=vertices, faces=faces, uv=uv, texture=texture)

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
        vertices = frozen_array(self.vertices, np.float64, (None, 3), "ConvexPart.vertices")
        if len(vertices) < 4:
            raise InputError(f"A convex part needs at least 4 points, got {len(vertices)}.")
        _freeze(self, vertices=vertices)

    @property
    def bounds(self) -> Float[np.ndarray, "2 3"]:
        """Lowest and highest corner."""
        return np.stack([self.vertices.min(0), self.vertices.max(0)])


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
    pieces in the canonical frame; empty means "not known", and assembly decomposes the mesh.
    ``container`` says that things can be put into it.
    """

    name: str
    label: str
    mesh: Mesh
    size: Float[np.ndarray, "3"]
    physics: Physics = Physics()
    parts: tuple[ConvexPart, ...] = ()
    category: str = "generic"
    container: bool = False

    def __post_init__(self) -> None:
        size = frozen_array(self.size, np.float64, (3,), "Model.size")
        if (size <= 0).any():
            raise InputError(f"Model.size must be positive metres, got {size}.")
        if not np.allclose(self.mesh.bounds, [[-0.5] * 3, [0.5] * 3], atol=1e-3):
            raise InputError(
                f"Model {self.name!r}: mesh must fill the unit box [-0.5, 0.5]^3, "
                f"its bounds are {self.mesh.bounds.tolist()}. Use geometry.to_unit_box."
            )
        _freeze(self, size=size)


@dataclass(frozen=True, eq=False)
class SizePrior:
    """A commonsense size (Fig. 22): extent (length, width, height) in metres, and its state.

    ``placement`` is e.g. "lying flat"; ``axes`` says what x, y and z are, e.g. "thickness".
    ``outline`` is a table's top seen from above, in metres about the middle of its extent, convex
    and counter-clockwise; None leaves its shape open.
    ``measured`` says that the extent is this very thing's, read from a depth map, not its kind's.
    """

    name: str
    extent: Float[np.ndarray, "3"]
    placement: str = "as shown"
    axes: tuple[str, str, str] = ("length", "width", "height")
    outline: Float[np.ndarray, "k 2"] | None = None
    measured: bool = False

    def __post_init__(self) -> None:
        extent = frozen_array(self.extent, np.float64, (3,), "SizePrior.extent")
        if (extent <= 0).any():
            raise InputError(f"SizePrior.extent must be positive metres, got {extent}.")
        _freeze(self, extent=extent)
        if self.outline is not None:
            outline = frozen_array(self.outline, np.float64, (None, 2), "SizePrior.outline")
            _freeze(self, outline=outline)


# ----------------------------------------------------------------------------- where things are


@dataclass(frozen=True)
class Rotation:
    """An estimated yaw r_i (Sec. 3.3, DRO) with its loss, and all (yaw, loss) candidates tried."""

    name: str
    yaw: float
    loss: float
    candidates: tuple[tuple[float, float], ...] = ()


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
        scale = frozen_array(self.scale, np.float64, (3,), "Placement.scale")
        if (scale <= 0).any() or not np.isfinite(self.yaw):
            raise InputError(f"Placement {self.name!r}: scale must be positive and yaw finite.")
        _freeze(
            self,
            translation=frozen_array(self.translation, np.float64, (3,), "Placement.translation"),
            scale=scale,
        )


@dataclass(frozen=True, eq=False)
class Pose:
    """A rigid pose in the world frame; ``quaternion`` is a unit wxyz."""

    position: Float[np.ndarray, "3"]
    quaternion: Float[np.ndarray, "4"]

    def __post_init__(self) -> None:
        quaternion = frozen_array(self.quaternion, np.float64, (4,), "Pose.quaternion")
        if abs(np.linalg.norm(quaternion) - 1) > 1e-4:
            raise InputError(f"Pose.quaternion must have length 1, got {quaternion}.")
        _freeze(
            self,
            position=frozen_array(self.position, np.float64, (3,), "Pose.position"),
            quaternion=quaternion,
        )


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
        if not 0 < self.mass < 1e3:
            raise InputError(f"Object {self.name!r}: mass must be in (0, 1000) kg: {self.mass}.")
        if not 0 < self.friction < 5:
            raise InputError(f"Object {self.name!r}: friction must be in (0, 5): {self.friction}.")
        if not self.parts:
            raise InputError(f"Object {self.name!r}: a body needs at least one convex part.")
        _freeze(
            self,
            com=frozen_array(self.com, np.float64, (3,), "Object.com"),
            inertia=frozen_array(self.inertia, np.float64, (3, 3), "Object.inertia"),
        )

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

    ``scale`` is its extent in metres, so ``height`` (of the top surface) is ``scale[2]``.
    ``parts`` are convex pieces in the table's body frame (origin at the centre of its box, at
    world (0, 0, height / 2)), in metres. ``outline`` is the top's convex outline, world x and y,
    counter-clockwise.
    """

    model: Model
    scale: Float[np.ndarray, "3"]
    parts: tuple[ConvexPart, ...]
    outline: Float[np.ndarray, "k 2"]
    friction: float = 0.6

    def __post_init__(self) -> None:
        _freeze(
            self,
            scale=frozen_array(self.scale, np.float64, (3,), "Table.scale"),
            outline=frozen_array(self.outline, np.float64, (None, 2), "Table.outline"),
        )
        if (self.scale <= 0).any() or len(self.outline) < 3 or not self.parts:
            raise InputError(
                f"Table needs a positive scale, an outline of 3 points and one convex part, got "
                f"{self.scale}, {len(self.outline)} and {len(self.parts)}."
            )

    @property
    def height(self) -> float:
        """Height of the top surface above the floor, metres."""
        return float(self.scale[2])


@dataclass(frozen=True)
class Report:
    """The recorded physical gate of a scene (lengths in metres, angles in radians).

    penetration: deepest overlap of two collision shapes at the start.
    drift, tilt: largest move and turn of any object over ``seconds`` of simulation.
    floating: objects with no contact and a gap below them; fallen: objects that left the table.
    off_table: objects whose centre of mass is outside the top's outline.
    moved: the largest correction that separating overlaps needed; settling: by settling.
    reach: from the best side of the table, the farthest object's distance to that side.
    """

    penetration: float
    drift: float
    tilt: float
    floating: tuple[str, ...] = ()
    fallen: tuple[str, ...] = ()
    off_table: tuple[str, ...] = ()
    moved: float = 0.0
    settling: float = 0.0
    reach: float = 0.0
    seconds: float = 2.0
    dropped: tuple[str, ...] = ()
    failures: tuple[str, ...] = ()

    @property
    def passed(self) -> bool:
        """Whether the scene may be published."""
        return not self.failures


@dataclass(frozen=True)
class Provenance:
    """Where a scene comes from, enough to make it again. Holds no secret, path or clock time."""

    kind: Literal["text", "image", "compose", "manual"]
    seed: int
    prompt: str | None = None
    source_sha256: str | None = None
    backends: Mapping[str, Any] = field(default_factory=dict)
    config: Mapping[str, Any] = field(default_factory=dict)
    versions: Mapping[str, str] = field(default_factory=dict)
    warnings: tuple[str, ...] = ()


@dataclass(frozen=True, eq=False)
class Scene:
    """A complete tabletop scene S = {o_i} (Sec. 3)."""

    name: str
    table: Table
    objects: tuple[Object, ...]
    provenance: Provenance
    view: View = View(azimuth=0.0, elevation=np.deg2rad(55.0), fov=np.deg2rad(35.0))
    report: Report | None = None
    plan: ScenePlan | None = None

    def __post_init__(self) -> None:
        names = [o.name for o in self.objects]
        doubles = sorted({n for n in names if names.count(n) > 1})
        if doubles or TABLE in names:
            raise InputError(f"Object names must be unique and not {TABLE!r}; repeated: {doubles}.")
        for name in names:  # they name MuJoCo's bodies; a slash marks what an environment adds
            if not name or name == "world" or "/" in name or not name.isprintable():
                raise InputError(
                    f"An object cannot be called {name!r}; use printable characters without '/', "
                    "and not 'world', which MuJoCo keeps for itself."
                )

    def object(self, name: str) -> Object:
        """Return the object called ``name``."""
        for candidate in self.objects:
            if candidate.name == name:
                return candidate
        raise InputError(
            f"Scene {self.name!r} has no object {name!r}."
            + choices(name, (o.name for o in self.objects))
        )

    def replace(self, **changes: Any) -> Scene:
        """Return a copy with some fields replaced."""
        return dataclasses.replace(self, **changes)
