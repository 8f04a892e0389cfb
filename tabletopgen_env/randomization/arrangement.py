"""Positions of objects, and removal of distractors.

Objects that carry or touch each other, such as a bowl and its fruit, or a book and an object that
leans on it, form a *bundle*: they are moved and removed together, so that no object loses its
support.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from generator.geometry import inside_margin, rotation_z, turned_quaternion
from generator.scene import Pose, Scene

from ..affordance import footprint

if TYPE_CHECKING:
    from ..world.world import World
    from .settings import Randomization

OVERLAP = 5e-4
"""Maximum overlap of two objects, in metres, as in generated scenes."""

DRIFT, TILT = 2e-3, np.deg2rad(2.0)
"""Maximum motion of an object at rest, in metres and radians."""

_SETTLING = 100  # simulation steps for which a new arrangement must stay at rest
_DEPTH = 10.0  # depth below the floor of removed objects, metres


def bundles(world: World) -> dict[str, str]:
    """Map each object to the root of its bundle of touching objects: the first one on the table.

    The world must be at its start; the contacts there define the bundles.
    """
    first = {name: name for name in world.names}
    stands = [o.name for o in world.scene.objects if o.placement.on not in first]
    pairs = [(o.name, o.placement.on) for o in world.scene.objects if o.placement.on in first]
    for one, other in (*pairs, *_touching(world)):
        a, b = first[one], first[other]
        kept = min(a, b, key=lambda name: (name not in stands, world.names.index(name)))
        first = {name: kept if root in (a, b) else root for name, root in first.items()}
    return first


def _touching(world: World) -> list[tuple[str, str]]:
    """Return the pairs of objects in contact."""
    owner = {int(body): name for body, name in zip(world.bodies, world.names, strict=True)}
    bodies = world.model.geom_bodyid[world.data.contact.geom].tolist()
    return [(owner[a], owner[b]) for a, b in bodies if a in owner and b in owner]


# ------------------------------------------------------------------------------------------ poses


def draw_poses(
    settings: Randomization, world: World, rng: np.random.Generator
) -> dict[str, list[float]]:
    """Draw a displacement (x, y in metres) and a turn (radians) for each bundle at the start."""
    most = np.array([settings.move, settings.move, settings.turn])
    drawn = (most * rng.uniform(-1, 1, (len(world.names), 3))).tolist()
    roots = set(bundles(world).values())
    return {name: row for name, row in zip(world.names, drawn, strict=True) if name in roots}


def apply_poses(world: World, drawn: Mapping[str, list[float]]) -> list[str]:
    """Apply the moves in ``drawn`` to a world's bundles; return the names of those that stayed.

    The world must be at its start, and is at its new start afterwards.
    """
    before, root = world.scene, bundles(world)
    moves = dict(drawn)
    while moves:
        world.rearrange(move(before, root, moves))
        bad = _find_misplaced(world, before, root, set(moves))
        if not bad:
            break
        moves = {name: move for name, move in moves.items() if name not in bad}
    else:
        world.rearrange(before)
    world.reset()
    return [name for name in drawn if name not in moves]


def move(scene: Scene, root: Mapping[str, str], moves: Mapping[str, list[float]]) -> Scene:
    """Return the scene with bundles moved (x, y) and turned about their first object."""
    objects = []
    for thing in scene.objects:
        first = root[thing.name]
        if first in moves:
            x, y, turn = moves[first]
            centre = scene.object(first).pose.position
            place = centre + rotation_z(turn) @ (thing.pose.position - centre) + [x, y, 0.0]
            pose = Pose(place, turned_quaternion(thing.pose.quaternion, turn))
            thing = replace(thing, pose=pose)
        objects.append(thing)
    return scene.replace(objects=tuple(objects))


def _find_misplaced(
    world: World, before: Scene, root: Mapping[str, str], movers: set[str]
) -> set[str]:
    """Return the ``movers`` that must stay because they overhang, overlap, or are not at rest."""
    import mujoco

    if over := {root[n] for n in world.names if _over_the_edge(world.scene, before, n)}:
        return over
    world.reset()
    if bad := _overlapping(world, root, movers):
        return bad
    start = _poses(world)
    mujoco.mj_step(world.model, world.data, _SETTLING)
    mujoco.mj_kinematics(world.model, world.data)
    restless = {root[name] for name in _restless(world, start)}
    return restless & movers or (movers if restless else set())


def _over_the_edge(scene: Scene, before: Scene, name: str) -> bool:
    """Return whether an object projects over the table's edge farther than before."""
    outline = scene.table.outline
    now, then = (inside_margin(footprint(s.object(name)), outline).min() for s in (scene, before))
    return bool(now < min(then, 0.0))


def _overlapping(world: World, root: Mapping[str, str], movers: set[str]) -> set[str]:
    """Return the movers that touch the robot or overlap another bundle."""
    owner = {int(body): name for body, name in zip(world.bodies, world.names, strict=True)}
    robot, contact = set(world.robot_bodies.tolist()), world.data.contact
    bad: set[str] = set()
    for geoms, gap in zip(contact.geom, contact.dist, strict=True):
        first, second = (int(k) for k in world.model.geom_bodyid[geoms])
        roots = [root[owner[k]] for k in (first, second) if k in owner]
        if {first, second} & robot:
            bad |= set(roots) & movers
        elif len(set(roots)) == 2 and gap < -OVERLAP:
            bad.add(max(set(roots) & movers, default=roots[0]))
    return bad & movers


def _poses(world: World) -> tuple[Float[np.ndarray, "k 3"], Float[np.ndarray, "k 3 3"]]:
    """Return the objects' positions and rotations."""
    data, bodies = world.data, world.bodies
    return data.xpos[bodies].copy(), data.xmat[bodies].reshape(-1, 3, 3).copy()


def _restless(
    world: World, start: tuple[Float[np.ndarray, "k 3"], Float[np.ndarray, "k 3 3"]]
) -> list[str]:
    """Return the objects that have moved from their poses at ``start``."""
    position, rotation = _poses(world)
    drift = np.linalg.norm(position - start[0], axis=1)
    cosine = (np.einsum("kij,kij->k", rotation, start[1]) - 1) / 2
    away = (drift > DRIFT) | (cosine < np.cos(TILT))
    return [name for name, gone in zip(world.names, away, strict=True) if gone]


# ------------------------------------------------------------------------------------ distractors


def draw_distractors(
    settings: Randomization, world: World, rng: np.random.Generator
) -> dict[str, Any]:
    """Draw the maximum number of distractors and the order in which objects are removed."""
    low, high = settings.distractors or (0, 0)
    order = [world.names[k] for k in rng.permutation(len(world.names))]
    return {"most": int(rng.integers(low, high + 1)), "order": order}


def leaving(
    root: Mapping[str, str], keep: Collection[str], most: int, order: Iterable[str]
) -> tuple[str, ...]:
    """Return the objects to remove, chosen in ``order``, so that at most ``most`` distractors stay.

    The objects in ``keep`` stay with their bundles (``root``). Others are removed as whole bundles.
    """
    needed = {root[name] for name in keep}
    loose = [name for name in root if root[name] not in needed]
    gone: set[str] = set()
    for name in order:
        if len(loose) - len(gone) <= most:
            break
        if name in loose:
            gone |= {other for other in loose if root[other] == root[name]}
    return tuple(name for name in loose if name in gone)


def take_away(world: World, names: Collection[str]) -> None:
    """Move objects below the floor; remove their collisions, weight and observation slots."""
    import mujoco

    model, data = world.model, world.data
    for name in names:
        body = world.bodies[world.index(name)]
        own = model.geom_bodyid == body
        model.geom_contype[own] = model.geom_conaffinity[own] = 0
        model.body_gravcomp[body] = 1.0
        data.qpos[model.jnt_qposadr[model.body_jntadr[body]] + 2] -= _DEPTH
    world.absent = frozenset(names)
    mujoco.mj_forward(model, data)
