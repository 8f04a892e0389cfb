"""Separation of overlapping objects by the least horizontal displacement (Sec. 3.4).

Each overlapping pair results in a *cut*: along the direction u in which the pair separates soonest,
object b must move at least t metres relative to object a. Together with the table's edges, the cuts
form a small quadratic program, ``min Σ |d_i|²`` subject to ``u · (D_b - D_a) >= t``, where d_i is
an object's own displacement, and D_i also includes the displacements of its supports. New overlaps
add new cuts until none is left.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from jaxtyping import Float
from scipy.optimize import nnls

from ..geometry import inside_margin, quaternion_yaw
from ..scene import TABLE, Object, Pose, Scene
from .parts import base
from .simulation import Simulation

TOLERANCE = 2e-4
"""Maximum depth of an overlap, in metres, that counts as contact."""

_PATIENCE = 6  # number of rounds without progress before giving up
_STIFFNESS = 1e4  # cost of a square metre of violated cuts, in square metres of displacement


@dataclass(frozen=True, eq=False)
class Cut:
    """Displacement constraint ``direction · (D_b - D_a) >= distance``; without ``a``, D_a is 0."""

    a: int | None
    b: int
    direction: Float[np.ndarray, "2"]
    distance: float


def separate(scene: Scene, clearance: float) -> tuple[Scene, tuple[str, ...]]:
    """Move overlapping objects apart on the table, together with the objects on them.

    Objects that support one another, directly or through others, are not pushed apart.
    ``clearance`` is the gap between objects that overlapped, metres. Returns the scene and the
    names of objects that still overlap another, or extend beyond the table's edge.
    """
    chains = ancestry(scene.objects)
    poses = start = [o.pose for o in scene.objects]
    simulation = Simulation(scene)
    cuts = _edge_cuts(scene)
    pairs: list[tuple[int, int]] = []
    fewest, stalled = len(start) ** 2, 0
    while stalled < _PATIENCE:
        shifts = _least_squares(cuts, chains)
        poses = [
            Pose(p.position + np.append(shift, 0.0), p.quaternion)
            for p, shift in zip(start, shifts, strict=True)
        ]
        simulation.place(poses)
        pairs = [
            (a, b)
            for (a, b), depth in sorted(simulation.contacts().deepest().items())
            if a >= 0 and depth > TOLERANCE and a not in chains[b] and b not in chains[a]
        ]
        if not pairs:
            break
        stalled = 0 if len(pairs) < fewest else stalled + 1
        fewest = min(fewest, len(pairs))
        now = scene.replace(objects=with_poses(scene.objects, poses))
        for a, b in pairs:
            direction, distance = least_push(now.objects[a], now.objects[b], now, clearance)
            already = (poses[b].position - start[b].position) - (
                poses[a].position - start[a].position
            )
            cuts.append(Cut(a, b, direction, distance + float(direction @ already[:2])))
    moved = scene.replace(objects=with_poses(scene.objects, poses))
    stuck = {moved.objects[i].name for pair in pairs for i in pair}
    return moved, tuple(sorted(stuck | {o.name for o in moved.objects if off_table(moved, o)}))


def off_table(scene: Scene, thing: Object) -> bool:
    """Return whether the centre of mass of an upright object is beyond the table's outline."""
    return bool(inside_margin(base(thing, thing.pose)[-1:], scene.table.outline)[0] < 0)


def ancestry(objects: Sequence[Object]) -> list[tuple[int, ...]]:
    """Return each object's index followed by those of its supports, down to the table."""
    index = {o.name: i for i, o in enumerate(objects)}
    chains = []
    for i, _ in enumerate(objects):
        chain = [i]
        while (below := objects[chain[-1]].placement.on) != TABLE:
            chain.append(index[below])
        chains.append(tuple(chain))
    return chains


def with_poses(objects: Sequence[Object], poses: Sequence[Pose]) -> tuple[Object, ...]:
    """Return the objects at the given poses."""
    return tuple(replace(o, pose=p) for o, p in zip(objects, poses, strict=True))


def least_push(
    a: Object, b: Object, scene: Scene, clearance: float
) -> tuple[Float[np.ndarray, "2"], float]:
    """Return the horizontal direction and the least distance that separate ``b`` from ``a``.

    Candidate directions are the normals of both boxes' sides and sixteen around the circle; the
    distance along each is measured on the collision shapes, to 0.1 mm.
    """
    alone = tuple(replace(o, placement=replace(o.placement, on=TABLE)) for o in (a, b))
    pair = Simulation(scene.replace(objects=alone))
    origin = pair.positions[1].copy()

    def clear(direction: np.ndarray, distance: float) -> bool:
        pair.positions[1] = origin + np.append(distance * direction, 0.0)
        return pair.contacts().deepest().get((0, 1), 0.0) <= 1e-6

    angles = [quaternion_yaw(o.pose.quaternion) + k * np.pi / 2 for o in (a, b) for k in range(4)]
    apart = b.pose.position[:2] - a.pose.position[:2]
    angles += [*(np.arange(16) * np.pi / 8), float(np.arctan2(apart[1], apart[0]))]
    ways = np.column_stack([np.cos(angles), np.sin(angles)])
    far = 2e-3
    while not (free := [u for u in ways if clear(u, far)]):
        far *= 1.5
    best, reached = free[0], far
    for direction in free:
        if not clear(direction, reached - 1e-4):
            continue
        low, high = 0.0, reached
        while high - low > 1e-4:
            middle = (low + high) / 2
            low, high = (low, middle) if clear(direction, middle) else (middle, high)
        best, reached = direction, high
    return best, reached + clearance


# ------------------------------------------------------------------------------------- the program


def _least_squares(
    cuts: Sequence[Cut], chains: Sequence[tuple[int, ...]]
) -> Float[np.ndarray, "n 2"]:
    """Return each object's total displacement D, which satisfies the cuts as far as possible.

    A cut may be violated by s_k at the cost ``_STIFFNESS * s_k²``. There is therefore always a
    solution, and it is a compromise if the cuts contradict one another. In (d, s) this is a least
    distance program, which is solved as a nonnegative least squares problem (C. Lawson and R.
    Hanson, "Solving Least Squares Problems", 1974, ch. 23, algorithm LDP).
    """
    count = len(chains)
    member = np.zeros((count, count))
    for i, chain in enumerate(chains):
        member[i, list(chain)] = 1.0
    if not cuts:
        return np.zeros((count, 2))
    rows = [
        np.outer(member[c.b] - (0.0 if c.a is None else member[c.a]), c.direction).ravel()
        for c in cuts
    ]
    slack = np.eye(len(cuts)) / np.sqrt(_STIFFNESS)
    bounds = np.array([cut.distance for cut in cuts])
    system = np.vstack([np.array(rows).T, slack, bounds])
    goal = np.append(np.zeros(len(system) - 1), 1.0)
    weights, _ = nnls(system, goal, maxiter=50 * len(cuts))
    rest = system @ weights - goal
    return member @ (-rest[: 2 * count] / rest[-1]).reshape(count, 2)


def _edge_cuts(scene: Scene) -> list[Cut]:
    """Return the constraints (cuts) that keep objects' footprints inside the table's outline.

    For an object wider than the table, its centre of mass is used instead.
    """
    outline = scene.table.outline
    edges = np.roll(outline, -1, axis=0) - outline
    inward = np.column_stack([-edges[:, 1], edges[:, 0]])
    inward /= np.linalg.norm(inward, axis=1, keepdims=True)
    level = np.einsum("kj,kj->k", inward, outline)
    cuts = []
    for i, thing in enumerate(scene.objects):
        if thing.placement.on != TABLE:
            continue
        stands = base(thing, thing.pose)
        width = np.ptp(outline @ inward.T, axis=0) - np.ptp(stands @ inward.T, axis=0)
        points = np.where(width > 0, (stands @ inward.T).min(0), stands[-1] @ inward.T)
        short = level - points
        cuts += [Cut(None, i, inward[k], float(short[k])) for k in range(len(level))]
    return cuts
