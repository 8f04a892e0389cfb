"""The arm's reach with the hand pointing down, and the rotation of the hand during a motion.

With the hand pointing straight down, its yaw *relative to the bearing of the tool* depends only on
the last joint's angle. The range of that joint determines in which direction the hand can turn,
which is not always the shorter one.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from jaxtyping import Bool, Float

from generator.geometry import rotation_yaw, wrap

from ..robot.kinematics import (
    HIGHEST,
    HOME,
    LOWER,
    LOWEST,
    UPPER,
    is_beyond_reach,
    pointing_down,
    solve_ik,
)
from ..world.world import World
from .planning.heights import HeightMap

INSIDE = 0.05
"""Margin between planned joint angles and the joint limits, in radians."""

NARROW = 0.38
"""Minimum distance of the hand from the base's axis, in metres; closer to the axis, the arm must
fold."""

# minimum distance from the base's axis, metres: closer, the arm would have to fold differently
_NEAREST = 0.28
# link 6: towards the base, sideways, metres
_WRIST = ((0.088, 0.01), (0.088, -0.03), (0.088, -0.07))
_WRIST_RADIUS, _WRIST_Z = 0.055, 0.16
_KNUCKLE, _KNUCKLE_RADIUS, _KNUCKLE_Z = 0.0425, 0.036, 0.102  # of link 7, along both hand axes
_ITERATIONS = 40
_AT_LIMIT, _SWUNG = 0.02, 1.0  # distance to a joint limit, and elbow swing, in a dead end, radians
_DISC = np.array([
    (r * np.cos(a), r * np.sin(a))
    for r, n in ((0.0, 1), (1 / 3, 6), (2 / 3, 12), (1.0, 18))
    for a in np.arange(n) * 2 * np.pi / n
])  # fmt: skip
"""Points of the unit disc, dense enough to hit the thin screen of a laptop."""

ROLL = np.pi / 2
"""The hand's yaw in the home pose, where the tool is straight ahead."""

MIDDLE = ROLL + float(HOME[6])
"""The hand's yaw relative to the tool's bearing with the last joint at zero."""

ROLL_RANGE = float(UPPER[6]) - 0.1
"""Maximum planned deviation from ``MIDDLE``, in radians."""


def stretch(world: World, points: Iterable[Float[np.ndarray, "3"]], yaw: float) -> float | None:
    """Return the largest joint motion from home to ``points``, or None if a point is out of reach.

    Points are positions of the tool centre point, world frame; ``yaw`` is the hand's, base frame,
    radians.
    """
    tools = [world.to_base(point) for point in points]
    if any(np.linalg.norm(at[:2]) < _NEAREST or is_beyond_reach(at) for at in tools):
        return None
    most, down = 0.0, pointing_down(yaw)
    for at in tools:
        found = solve_ik(at, down, iterations=_ITERATIONS)
        inside = np.minimum(found.joints - LOWER, UPPER - found.joints).min()
        if not found.solved or inside < INSIDE:
            return None
        most = max(most, float(np.abs(found.joints - HOME).max()))
    return most


def easiest(world: World, points: tuple[Float[np.ndarray, "3"], ...], angle: float) -> float | None:
    """Return ``angle`` or its opposite, whichever yaw reaches all points with less joint motion.

    The result is None if neither yaw reaches all points.
    """
    yaws = (wrap(angle), wrap(angle + np.pi))
    found = [(far, yaw) for yaw in yaws if (far := stretch(world, points, yaw)) is not None]
    return min(found)[1] if found else None


def turn_left(world: World, yaw: float, at: Float[np.ndarray, "3"]) -> float:
    """Return how far the last joint must turn, within its range, to bring the hand to ``yaw``.

    Angles are in radians, base frame; ``at`` is the tool's position after the turn, world frame.
    """
    now = _roll(world)
    asked = MIDDLE + wrap(yaw - _bearing(world, at) - MIDDLE)
    ways = [asked + 2 * np.pi * k for k in (-1, 0, 1)]
    allowed = [w for w in ways if abs(w - MIDDLE) <= ROLL_RANGE]
    return min((w - now for w in allowed or [asked]), key=abs)


def least_turn(world: World, at: Float[np.ndarray, "3"]) -> float:
    """Return the minimum turn of the hand that keeps the last joint in range at the point ``at``.

    The turn is in radians, base frame, 0 if the hand can keep its yaw; ``at`` is the tool's
    position after the turn.
    """
    turned = _bearing(world, world.data.site_xpos[world.tcp]) - _bearing(world, at)
    asked = _roll(world) + wrap(turned)
    return float(np.clip(asked, MIDDLE - ROLL_RANGE, MIDDLE + ROLL_RANGE)) - asked


def elbow_swing(world: World) -> float:
    """Return the absolute angle between the first joint and the tool's bearing, in radians.

    For a given hand pose the elbow can swing about the line from shoulder to wrist, by up to about
    a radian away from joint limits. If the last joint reaches its limit, the elbow compensates
    until the first joint is at its limit, too. The arm is then in a dead end: the hand cannot
    follow its command, although another posture of the arm could.
    """
    bearing = _bearing(world, world.data.site_xpos[world.tcp])
    return abs(wrap(float(world.data.qpos[world.arm_qpos[0]]) - bearing))


def is_wound(world: World) -> bool:
    """Return whether the elbow has swung so far that the first joint is at its limit."""
    first = float(world.data.qpos[world.arm_qpos[0]])
    room = min(first - float(LOWEST[0]), float(HIGHEST[0]) - first)
    return room < _AT_LIMIT and elbow_swing(world) > _SWUNG


def turn_to_middle(world: World) -> float:
    """Return the turn of the hand, in radians, that brings the last joint to zero."""
    return MIDDLE - _roll(world)


def _roll(world: World) -> float:
    """Return the hand's yaw relative to the tool's bearing, within the last joint's range."""
    relative = rotation_yaw(world.hand) - _bearing(world, world.data.site_xpos[world.tcp])
    by_joint = MIDDLE - float(world.data.qpos[world.arm_qpos[6]])
    return by_joint + wrap(relative - by_joint)


def around(
    world: World, start: Float[np.ndarray, "3"], end: Float[np.ndarray, "3"]
) -> Float[np.ndarray, "2"]:
    """Return the next waypoint (x, y, world) from ``start`` to ``end`` around the robot's base."""
    a, b = (world.to_base(point)[:2] for point in (start, end))
    way = b - a
    along = float(np.clip(-(a @ way) / max(float(way @ way), 1e-9), 0.0, 1.0))
    nearest = float(np.linalg.norm(a + along * way))
    turn = wrap(float(np.arctan2(b[1], b[0]) - np.arctan2(a[1], a[0])))
    if along in (0.0, 1.0) or nearest >= NARROW or abs(turn) < 0.3:
        return end[:2].copy()
    bearing = float(np.arctan2(a[1], a[0])) + float(np.clip(turn, -0.4, 0.4))
    radius = max(NARROW + 0.04, float(np.linalg.norm(a)))
    aim = np.array([radius * np.cos(bearing), radius * np.sin(bearing), 0.0])
    return world.to_world(aim)[:2]


def wrist_is_free(
    world: World, others: HeightMap, points: Float[np.ndarray, "k 2"], tip: float
) -> bool:
    """Return whether the wrist clears ``others`` at all ``points``, with fingertips at ``tip``."""
    return bool(wrists_are_free(world, others, points, np.full(len(points), tip)).all())


def wrists_are_free(
    world: World,
    others: HeightMap,
    points: Float[np.ndarray, "k 2"],
    tips: Float[np.ndarray, "k"],
) -> Bool[np.ndarray, "k"]:
    """Return a mask of the tool positions at which the wrist clears all obstacles.

    The wrist is above the hand, towards the base. ``points`` (world) are the tools' positions,
    ``tips`` the heights of the fingertips.
    """
    back = world.base_position[:2] - points
    back /= np.maximum(np.linalg.norm(back, axis=1, keepdims=True), 1e-9)
    aside = np.column_stack([-back[:, 1], back[:, 0]])
    centers = np.stack([points + b * back + a * aside for b, a in _WRIST], axis=1)
    under = others.at(centers[:, :, None] + _WRIST_RADIUS * _DISC)
    return under.max((1, 2)) <= tips + _WRIST_Z


def knuckle_is_free(
    world: World, others: HeightMap, point: Float[np.ndarray, "2"], tip: float, yaw: float
) -> bool:
    """Return whether the part of the last link that protrudes beside the hand clears all obstacles.

    Arguments are as for `wrist_is_free`; ``yaw`` is the hand's, in the base frame, radians.
    """
    c, s = np.cos(yaw + world.mount.yaw), np.sin(yaw + world.mount.yaw)
    center = point + _KNUCKLE * np.array([c + s, s - c])
    return bool(others.at(center + _KNUCKLE_RADIUS * _DISC).max() <= tip + _KNUCKLE_Z)


def _bearing(world: World, point: Float[np.ndarray, "3"]) -> float:
    x, y, _ = world.to_base(point)
    return float(np.arctan2(y, x))


def up(height: float) -> Float[np.ndarray, "3"]:
    """Return an upward vector of length ``height`` (metres)."""
    return np.array([0.0, 0.0, height])
