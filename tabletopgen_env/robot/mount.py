"""Placement of the robot's base on a pedestal beside the table, facing the table's centre.

The base is level with the table top, so the reach of a downward-pointing hand is a ring of 0.30 to
0.77 m about the base: from just behind the edge almost to the far side of a typical table.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from jaxtyping import Bool, Float

from generator.errors import InputError
from generator.geometry import quaternion_matrix, wrap
from generator.scene import Object, Scene, frozen_array

from . import franka

if TYPE_CHECKING:
    import mujoco

PEDESTAL = "pedestal"
"""Name of the pedestal's body."""

PEDESTAL_RADIUS = 0.09
"""Radius of the round pedestal, in metres."""

GAP = 0.012
"""Gap between pedestal and table edge, in metres."""

LIFT = 0.01
"""Height of the base above the table top, in metres, since its foot projects over the edge."""

NEAREST = 0.30
"""Minimum horizontal distance from the base at which the hand can point straight down (metres)."""

STRETCH = 0.70
"""Maximum distance from the shoulder to the wrist joint, in metres; at 0.72 m, the arm is
straight."""

CLEARANCE = 0.13
"""Radius about the base's axis that must be free of objects, in metres."""

TALL = 0.28
"""Height above the table at which an object obstructs the arm, in metres."""

ARM_BREADTH = 0.07
"""Half the width of the forearm plus a margin, in metres."""

SWING = np.deg2rad(110.0)
"""Maximum bearing of a target from straight ahead, in radians."""

_WRIST = franka.FLANGE + franka.TCP
_WRIST_OFFSET = franka.JOINTS[6].a
_SHOULDER = franka.JOINTS[0].d
_PERIMETER_STEP = 0.05


@dataclass(frozen=True, eq=False)
class Mount:
    """Pose of a robot's base: ``position`` (m, world) and ``yaw`` of its x axis (rad)."""

    position: Float[np.ndarray, "3"]
    yaw: float

    def __post_init__(self) -> None:
        position = frozen_array(self.position, np.float64, (3,), "Mount.position")
        object.__setattr__(self, "position", position)
        if not np.isfinite(self.yaw):
            raise InputError("Mount.yaw must be a finite angle in radians.")

    @classmethod
    def beside(cls, scene: Scene) -> Mount:
        """Return the best mount at the table of ``scene``.

        Candidates all around the outline are scored by the share of objects (and of the free table
        top) within reach, with a penalty near objects. Ties are resolved in favour of the candidate
        nearest the middle of the viewer's side (-y).
        """
        spots, boxes = _spots(scene), _boxes(scene)
        tall = _rising(scene, boxes)
        return max(_candidates(scene), key=lambda mount: _score(mount, spots, boxes, tall))

    def reaches(self, points: Float[np.ndarray, "n 3"]) -> Bool[np.ndarray, "n"]:
        """Return which world points a downward-pointing hand can reach.

        The estimate ignores obstacles: the wrist must be within ``STRETCH`` of the shoulder, at
        least ``NEAREST`` from the base's axis and within ``SWING`` of straight ahead.
        """
        offset = np.atleast_2d(np.asarray(points, float)) - self.position
        radius = np.hypot(offset[:, 0], offset[:, 1])
        bearing = np.arctan2(offset[:, 1], offset[:, 0]) - self.yaw
        bearing = np.abs((bearing + np.pi) % (2 * np.pi) - np.pi)
        stretch = np.hypot(radius - _WRIST_OFFSET, offset[:, 2] + _WRIST - _SHOULDER)
        return (radius >= NEAREST) & (stretch <= STRETCH) & (bearing <= SWING)


def reachable(mount: Mount, point: Float[np.ndarray, "3"]) -> bool:
    """Return whether a downward-pointing hand can reach one world point; see ``Mount.reaches``."""
    return bool(mount.reaches(np.asarray(point, float)[None])[0])


def obstacle(scene: Scene, mount: Mount, name: str) -> str | None:
    """Return the tall object between the base and the object ``name``, or None.

    Objects taller than ``TALL`` within ``ARM_BREADTH`` of the line obstruct the forearm.
    """
    thing = scene.object(name)
    return _obstacle(mount, thing.pose.position, name, _rising(scene, _boxes(scene)))


def clear_of_tall(
    scene: Scene, mount: Mount, name: str, points: Float[np.ndarray, "n 2"]
) -> Bool[np.ndarray, "n"]:
    """Return which points have no tall object except ``name`` between them and the base.

    Tall objects and obstruction are defined as in ``obstacle``.
    """
    rising = _rising(scene, _boxes(scene))
    ways = [_obstacle(mount, point, name, rising) is None for point in points]
    return np.array(ways, bool)


def add_pedestal(spec: mujoco.MjSpec, mount: Mount) -> None:
    """Add the pedestal, a column from the floor to the base with a foot and a top plate."""
    import mujoco

    x, y, height = mount.position
    body = spec.worldbody.add_body(name=PEDESTAL, pos=[x, y, 0])
    pieces = (
        ("foot", PEDESTAL_RADIUS * 1.7, 0.0, 0.02),
        ("column", PEDESTAL_RADIUS * 0.72, 0.02, height - 0.02),
        ("plate", PEDESTAL_RADIUS, height - 0.02, height),
    )
    for name, radius, low, high in pieces:
        body.add_geom(
            name=f"{PEDESTAL}_{name}",
            type=mujoco.mjtGeom.mjGEOM_CYLINDER,
            size=[radius, (high - low) / 2, 0],
            pos=[0, 0, (low + high) / 2],
            rgba=[0.28, 0.29, 0.31, 1.0],
        )


# ------------------------------------------------------------------------------------- choosing


def _candidates(scene: Scene) -> list[Mount]:
    """Return mounts all around the outline, each facing the centre of the table."""
    outline = np.asarray(scene.table.outline, float)
    center = (outline.min(0) + outline.max(0)) / 2
    ends = np.roll(outline, -1, axis=0)
    mounts = []
    for a, b in zip(outline, ends, strict=True):
        edge = b - a
        length = float(np.linalg.norm(edge))
        if length < 1e-6:
            continue
        outward = np.array([edge[1], -edge[0]]) / length
        steps = max(1, round(length / _PERIMETER_STEP))
        for t in (np.arange(steps) + 0.5) / steps:
            base = a + t * edge + outward * (PEDESTAL_RADIUS + GAP)
            ahead = center - base
            position = np.array([*base, scene.table.height + LIFT])
            mounts.append(Mount(position, wrap(np.arctan2(ahead[1], ahead[0]))))
    return mounts


class _Box(NamedTuple):
    """The oriented bounding box of an object: its centre, half extents, and axes as columns."""

    thing: Object
    middle: Float[np.ndarray, "3"]
    half: Float[np.ndarray, "3"]
    axes: Float[np.ndarray, "3 3"]


def _boxes(scene: Scene) -> list[_Box]:
    return [
        _Box(o, o.pose.position, o.scale / 2, quaternion_matrix(o.pose.quaternion))
        for o in scene.objects
    ]


def _rising(scene: Scene, boxes: Sequence[_Box]) -> list[_Box]:
    """Return the boxes taller than ``TALL``."""
    limit = scene.table.height + TALL
    tops = [box.middle[2] + (np.abs(box.axes) @ box.thing.scale / 2)[2] for box in boxes]
    return [box for box, top in zip(boxes, tops, strict=True) if top >= limit]


def _obstacle(
    mount: Mount, point: Float[np.ndarray, "d"], but: str, rising: Sequence[_Box]
) -> str | None:
    """Return the tall object, other than ``but``, between the base and a point, or None."""
    start = mount.position[:2]
    way = point[:2] - start
    for other in rising:
        if other.thing.name == but:
            continue
        offset = other.middle[:2] - start
        along = float(np.clip(offset @ way / max(float(way @ way), 1e-9), 0.0, 1.0))
        turned = (along * way - offset) @ other.axes[:2, :2]
        aside = np.maximum(np.abs(turned) - other.half[:2], 0.0)
        if float(np.linalg.norm(aside)) < ARM_BREADTH:
            return other.thing.name
    return None


def _score(
    mount: Mount, spots: Float[np.ndarray, "n 3"], boxes: Sequence[_Box], rising: Sequence[_Box]
) -> float:
    """Return a mount's score from objects and table area in reach, clearance and table side."""
    covered = float(mount.reaches(spots).mean())
    reached = crowded = 0.0
    if boxes:
        near = mount.reaches(np.array([box.middle for box in boxes]))
        pairs = zip(boxes, near.tolist(), strict=True)
        within = [
            ok and _obstacle(mount, box.middle, box.thing.name, rising) is None for box, ok in pairs
        ]
        reached = float(np.mean(within))
        crowded = sum(_gap(mount, box) < CLEARANCE for box in boxes)
    aside = abs(float(mount.position[0]))
    front = 0.25 * (float(mount.position[1]) < 0) - 0.1 * aside
    return 2.0 * reached + covered + front - crowded


def _spots(scene: Scene) -> Float[np.ndarray, "n 3"]:
    """Return a grid of points 5 cm above the tabletop, spaced 6 cm apart."""
    outline = np.asarray(scene.table.outline, float)
    low, high = outline.min(0), outline.max(0)
    axes = [np.arange(low[k] + 0.03, high[k], 0.06) for k in (0, 1)]
    grid = np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 2)
    ends = np.roll(outline, -1, axis=0) - outline
    normals = np.column_stack([-ends[:, 1], ends[:, 0]])
    inside = (((grid[:, None] - outline) * normals).sum(-1) >= 0).all(1)
    return np.column_stack([grid[inside], np.full(inside.sum(), scene.table.height + 0.05)])


def _gap(mount: Mount, box: _Box) -> float:
    """Return the horizontal distance in metres from the base's axis to an oriented bounding box."""
    offset = (mount.position - box.middle) @ box.axes
    offset[2] = 0.0
    return float(np.linalg.norm(np.maximum(np.abs(offset) - box.half, 0)[:2]))
