"""Worlds whose objects have few enough convex parts for a batch."""

from __future__ import annotations

from generator.errors import SceneError
from generator.physics.gate import judge

from ...robot.panda import Panda
from ...world.world import World
from .merging import cap_parts

MOST_PARTS = 12
"""Convex parts that an object has unless said otherwise; catalogue objects have up to 46."""


def cap_world(world: World, most: int, robot: Panda) -> World:
    """Return a world whose objects have at most ``most`` convex parts, with the same mount.

    Where any has more, parts are merged (``merging``), and the scene is gated and
    compiled anew.

    Raises:
        SceneError: the scene does not pass its physical gate with merged parts.
    """
    capped = cap_parts(world.scene, most)
    if capped is world.scene:
        return world
    if failures := judge(capped).failures:
        some = "; ".join(map(str, failures[:2]))
        raise SceneError(f"with {most} parts an object it fails its physical gate ({some})")
    return World(capped, robot, world.mount)
