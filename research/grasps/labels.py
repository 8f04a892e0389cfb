"""Training data of the detector: height maps of objects, and the grasps of the expert's planner."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from jaxtyping import Float, UInt8

from generator.errors import SceneError
from tabletopgen_env.detection.look import HeightView, look
from tabletopgen_env.detection.network import TURNS
from tabletopgen_env.expert.planning.grasps import grasps_along
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.scenes.source import SceneSource
from tabletopgen_env.tasks.candidates import liftable
from tabletopgen_env.world.world import World
from tabletopgen_env.world.worlds import WorldCache

COLUMNS = ("turn", "x", "y", "z", "opening", "width", "score")
"""Columns of a grasp: the index of its rotation, the tool's offset from the object's centre and,
for z, from the table (metres, along the world axes), the others as in ``Grasp``."""


@dataclass(frozen=True, eq=False)
class GraspLesson:
    """A height map of an object, and the planner's grasps of it, best first.

    ``facing`` is the first of the planner's rotations, radians; ``grasps`` has ``COLUMNS``.
    """

    heights: UInt8[np.ndarray, "2 64 64"]
    facing: float
    grasps: Float[np.ndarray, "g 7"]

    @property
    def look(self) -> HeightView:
        """Return the view, with the object's centre above the origin of a table at height 0."""
        return HeightView(self.heights, np.zeros(2), self.facing, 0.0)


def lessons(source: SceneSource, scenes: int, seed: int) -> Iterator[list[GraspLesson]]:
    """Yield the lessons of ``scenes`` generated scenes, scene by scene."""
    rng = np.random.default_rng(seed)
    worlds = WorldCache(Panda(), 1)
    for _ in range(scenes):
        try:
            world = worlds.get(source.draw(rng), lambda _: None)
        except SceneError:
            continue
        names = [name for name, why in liftable(world).items() if why is None]
        found = [lesson(world, name, rng) for name in names]
        yield [each for each in found if each is not None]


def lesson(world: World, name: str, rng: np.random.Generator) -> GraspLesson | None:
    """Return the lesson of one object, or None if it has no grasp.

    Every other object is seen at rotations that are not aligned with its faces.
    """
    seen = look(world, name)
    aside = float(rng.uniform(0.0, np.pi / TURNS)) if rng.random() < 0.5 else 0.0
    facing, middle = seen.facing + aside, np.array([*seen.center, seen.floor])
    angles = (facing + np.arange(TURNS) * np.pi / TURNS).tolist()
    rows = [
        (angles.index(g.angle), *(g.point - middle), g.opening, g.width, g.score)
        for g in grasps_along(world, name, angles)
    ]
    if not rows:
        return None
    rows.sort(key=lambda row: -row[-1])
    return GraspLesson(seen.heights, facing, np.array(rows, np.float32))
