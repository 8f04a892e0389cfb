"""Candidate grasps: antipodal grasps of an object from all sides, found by the expert's planner."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from itertools import zip_longest

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from generator.scene import Object

from ..expert.planning.grasps import Grasp, grasps_alone, is_like

_TURNS = 12
_NEAR, _ALIKE = 0.01, np.deg2rad(20.0)  # metres and radians within which two grasps are equal
_GOLDEN = np.pi * (1 + 5**0.5)


@dataclass(frozen=True, eq=False)
class GraspCandidate:
    """A candidate grasp: the tool's position (m) and the hand's rotation in the object's frame.

    Column 1 of ``rotation`` is the opening direction, column 2 the approach direction. ``opening``
    and ``width`` are as in ``Grasp``, metres.
    """

    position: Float[np.ndarray, "3"]
    rotation: Float[np.ndarray, "3 3"]
    opening: float
    width: float


def find_candidates(
    thing: Object, count: int, directions: int, rng: np.random.Generator
) -> list[GraspCandidate]:
    """Return up to ``count`` distinct grasps of an object.

    The best grasp of each approach comes first, then the second-best of each, and so on. The
    approach directions are the six along the axes and ``directions`` others, spread evenly and
    rotated at random by ``rng``.
    """
    by_direction = [[*_from_above(thing, turn, count)] for turn in approaches(directions, rng)]
    found: list[GraspCandidate] = []
    for rank in zip_longest(*by_direction):
        for candidate in rank:
            if candidate is None or any(_are_alike(candidate, other) for other in found):
                continue
            found.append(candidate)
            if len(found) == count:
                return found
    return found


def approaches(directions: int, rng: np.random.Generator) -> list[Float[np.ndarray, "3 3"]]:
    """Return rotations, each of which turns one approach direction straight down."""
    k = np.arange(directions) + 0.5
    polar, turn = np.arccos(1 - 2 * k / max(directions, 1)), _GOLDEN * k
    spread = np.column_stack(
        [np.cos(turn) * np.sin(polar), np.sin(turn) * np.sin(polar), np.cos(polar)]
    )
    ways = np.concatenate([-np.eye(3)[::-1], np.eye(3), spread @ _draw_rotation(rng).T])
    return [_turn_down(way) for way in ways]


def _draw_rotation(rng: np.random.Generator) -> Float[np.ndarray, "3 3"]:
    quaternion = rng.normal(size=4)
    return Rotation.from_quat(quaternion / np.linalg.norm(quaternion)).as_matrix()


def _turn_down(way: Float[np.ndarray, "3"]) -> Float[np.ndarray, "3 3"]:
    """Return a rotation that maps ``way`` to -z.

    For a coordinate axis it is a signed permutation.
    """
    side = np.eye(3)[int(np.abs(way).argmin())]
    side = side - way * (way @ side)
    side = side / np.linalg.norm(side)
    return np.stack([side, np.cross(-way, side), -way])


def _from_above(
    thing: Object, turn: Float[np.ndarray, "3 3"], most: int
) -> Iterator[GraspCandidate]:
    """Yield distinct grasps of the rotated object from above, best first."""
    angles = (np.arange(_TURNS) * np.pi / _TURNS).tolist()
    rated = sorted(grasps_alone(thing, turn, angles), key=lambda grasp: -grasp.score)
    kept: list[Grasp] = []
    for grasp in rated:
        if any(is_like(grasp, other) for other in kept):
            continue
        kept.append(grasp)
        c, s = np.cos(grasp.angle), np.sin(grasp.angle)
        hand = np.array([[-s, c, 0.0], [c, s, 0.0], [0.0, 0.0, -1.0]])
        yield GraspCandidate(
            turn.T @ grasp.point, turn.T @ hand, float(grasp.opening), float(grasp.width)
        )
        if len(kept) == most:
            return


def _are_alike(one: GraspCandidate, other: GraspCandidate) -> bool:
    """Return whether two grasps nearly coincide, possibly after half a turn of the hand."""
    if np.linalg.norm(one.position - other.position) > _NEAR:
        return False
    cosine = np.cos(_ALIKE)
    approach = one.rotation[:, 2] @ other.rotation[:, 2]
    opening = abs(one.rotation[:, 1] @ other.rotation[:, 1])
    return bool(approach > cosine and opening > cosine)
