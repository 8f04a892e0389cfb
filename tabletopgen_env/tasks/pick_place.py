"""PickPlace: take one object and put it into a container or onto a marked free spot.

Success, exactly: the target's centre is inside the goal region, nothing of the robot touches it,
it is at rest (below 2 cm/s and 0.3 rad/s), and for a container it is in it: its lowest point lies
5 mm or more below the rim and not below the container's floor, and the container stands upright
(within 30 degrees).

The goal region is an upright elliptic cylinder: radius 4 cm and height ±3 cm around where the
target would stand on the marked spot; for a container its clear opening, from the hollow's floor
to a target's height above the rim.

Dense reward: the weighted sum of five terms in [0, 1]; the weights sum to 1.

=========  ======  =================================================================================
reach      0.10    tool centre point near the target's centre: 1 / (1 + distance / 0.1 m)
grasp      0.15    half for each finger that touches the target
lift       0.15    target's height above where it started over what the way still to go asks for
                   (at most 8 cm)
place      0.30    target near the goal region: 1 / (1 + distance / 0.15 m)
success    0.30    the predicate above
=========  ======  =================================================================================

While the target is inside the region, reach, grasp and lift count in full, so letting go and
leaving costs nothing; the sum is 1 if and only if the task has succeeded. Sparse reward: 0 on
success, -1 otherwise. With goal-dict observations the reward must follow from the two goals
alone: sparse as above, dense 0.5 place + 0.5 success.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from .episode import Episode, draw_episode

if TYPE_CHECKING:
    from ..world import World

WEIGHTS: Mapping[str, float] = MappingProxyType(
    {"reach": 0.10, "grasp": 0.15, "lift": 0.15, "place": 0.30, "success": 0.30}
)
"""Weights of the dense reward's terms; they sum to 1."""

GOAL_WEIGHTS: Mapping[str, float] = MappingProxyType({"place": 0.5, "success": 0.5})
"""Weights when only the achieved and the desired goal are known."""

_FAR = 3.0  # metres; positions in goal vectors are clipped to it
SPOT_RADIUS, SPOT_HEIGHT = 0.04, 0.03
"""How far from the marked spot the target may stand, along the table and in height, metres."""

REST_SPEED, REST_SPIN = 0.02, 0.3
"""Below these speeds (m/s, rad/s) the target is at rest."""

LIFT = 0.08
"""Height to carry things at, metres."""

INSIDE = 0.005
"""How far below the rim the lowest point of what is in a container lies at least, metres."""

_UPRIGHT = np.cos(np.deg2rad(30.0))


@dataclass(frozen=True, eq=False)
class Region:
    """The goal region in the world frame: an upright elliptic cylinder.

    ``semi`` are the semi-axes along x', y' (turned by ``yaw``) and z, metres.
    """

    center: Float[np.ndarray, "3"]
    semi: Float[np.ndarray, "3"]
    yaw: float


class PickPlace:
    """Put one object into a container or onto a marked spot; see the module's page."""

    marker_radius = SPOT_RADIUS

    def sample(
        self,
        world: World,
        rng: np.random.Generator,
        target: str | None = None,
        goal: str | tuple[float, float] | None = None,
    ) -> Episode:
        """Draw a target and a goal, or take those given; see ``draw_episode``."""
        return draw_episode(world, rng, target, goal)

    # ------------------------------------------------------------------------------------- goals

    def region(self, world: World, episode: Episode) -> Region:
        """Return where the target's centre has to be now; a container's region moves with it."""
        if episode.spot is not None:
            center = episode.spot + np.array([0.0, 0.0, episode.rest])
            return Region(center, np.array([SPOT_RADIUS, SPOT_RADIUS, SPOT_HEIGHT]), 0.0)
        hollow, name = episode.opening, episode.container
        assert hollow is not None and name is not None
        rotation, top = world.rotation(name), hollow.rim + episode.height
        local = np.array([*hollow.center, (hollow.floor + top) / 2])
        semi = np.array([*hollow.semi, (top - hollow.floor) / 2])
        yaw = float(np.arctan2(rotation[1, 0], rotation[0, 0]))
        return Region(world.position(name) + rotation @ local, semi, yaw)

    def settled(self, world: World, episode: Episode) -> bool:
        """Return whether the target rests, untouched, and for a container inside its hollow."""
        speed = world.velocities()[world.index(episode.target)]
        if np.linalg.norm(speed[:3]) > REST_SPEED or np.linalg.norm(speed[3:]) > REST_SPIN:
            return False
        if world.touched(episode.target)[2]:
            return False
        if episode.container is None or episode.opening is None:
            return True
        hollow, up = episode.opening, world.rotation(episode.container)[:, 2]
        base = world.position(episode.container)[2]
        below = world.lowest(episode.target)
        floor = base + up[2] * (hollow.floor - hollow.thickness / 2)
        return bool(up[2] >= _UPRIGHT and floor <= below <= base + up[2] * hollow.rim - INSIDE)

    def desired(self, world: World, episode: Episode) -> Float[np.ndarray, "8"]:
        """Return the goal vector, base frame: x, y, z, semi-axes x', y', yaw, semi-axis z, 1."""
        region = self.region(world, episode)
        center = np.clip(world.to_base(region.center), -_FAR, _FAR)
        shape = [*region.semi[:2], region.yaw - world.mount.yaw, region.semi[2]]
        return np.array([*center, *shape, 1.0], dtype=np.float32)

    def achieved(
        self, world: World, episode: Episode, desired: Float[np.ndarray, "8"]
    ) -> Float[np.ndarray, "8"]:
        """Return what is achieved in the same form: the target's centre, and whether it settled.

        The region's shape is copied from ``desired``, so that an achieved goal can stand in for
        the desired one (hindsight).
        """
        center = np.clip(world.to_base(world.position(episode.target)), -_FAR, _FAR)
        settled = float(self.settled(world, episode))
        return np.array([*center, *desired[3:7], settled], dtype=np.float32)

    @staticmethod
    def distance(
        achieved: Float[np.ndarray, "*n 8"], desired: Float[np.ndarray, "*n 8"]
    ) -> tuple[Float[np.ndarray, "*n"], Float[np.ndarray, "*n"]]:
        """Return how far outside the region the target's centre is, horizontally and vertically."""
        a, d = np.asarray(achieved, np.float64), np.asarray(desired, np.float64)
        x, y, z = np.moveaxis((a - d)[..., :3], -1, 0)
        c, s = np.cos(d[..., 5]), np.sin(d[..., 5])
        u, v = (c * x + s * y) / d[..., 3], (c * y - s * x) / d[..., 4]
        ratio = np.sqrt(u * u + v * v)
        outside = np.sqrt(x * x + y * y) * (1 - 1 / np.maximum(ratio, 1.0))
        return outside, np.maximum(np.abs(z) - d[..., 6], 0.0)

    def goal_terms(
        self, achieved: Float[np.ndarray, "*n 8"], desired: Float[np.ndarray, "*n 8"]
    ) -> dict[str, Float[np.ndarray, "*n"]]:
        """Return the terms that follow from the goals alone: place and success, vectorised."""
        across, up = self.distance(achieved, desired)
        far = np.sqrt(across * across + up * up)
        asked = np.asarray(achieved)[..., 7] >= np.asarray(desired)[..., 7]
        success = np.asarray((far <= 0.0) & asked, dtype=np.float64)
        return {"place": 1 / (1 + far / 0.15), "success": success}

    def terms(
        self,
        world: World,
        episode: Episode,
        achieved: Float[np.ndarray, "8"],
        desired: Float[np.ndarray, "8"],
    ) -> dict[str, float]:
        """Return every reward term by name, each in [0, 1]."""
        place, success = (float(v) for v in self.goal_terms(achieved, desired).values())
        if place >= 1.0:
            return {"reach": 1.0, "grasp": 1.0, "lift": 1.0, "place": place, "success": success}
        center = world.position(episode.target)
        left, right, _ = world.touched(episode.target)
        reach = float(np.linalg.norm(world.data.site_xpos[world.tcp] - center))
        way = float(self.distance(achieved, desired)[0])
        asked = LIFT * min(way / LIFT, 1.0)
        lift = float(np.clip((center[2] - episode.start) / asked, 0, 1)) if asked > 0 else 1.0
        return {
            "reach": 1 / (1 + reach / 0.1),
            "grasp": (left + right) / 2,
            "lift": lift,
            "place": place,
            "success": success,
        }
