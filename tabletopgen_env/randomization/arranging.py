"""Where things stand, and which of them are there at all."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import replace
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from generator.geometry import inside_margin, rotation_z
from generator.scene import TABLE, Object, Pose, Scene

from ..affordance import footprint

if TYPE_CHECKING:
    from ..world import World
    from .settings import Randomization

OVERLAP = 5e-4
"""Deepest overlap of two things, metres, as for the scenes themselves."""

SETTLING = 100
"""Simulation steps for which a new arrangement has to rest."""

DRIFT, TILT = 2e-3, np.deg2rad(2.0)
"""Largest move (metres) and turn (radians) of a thing that rests."""

_DEPTH = 10.0  # how far below the floor things are parked, metres


# ------------------------------------------------------------------------------------------ poses


def draw_poses(settings: Randomization, world: World, rng: np.random.Generator) -> dict[str, Any]:
    """Draw the move (x, y, metres) and the turn (radians) of each object that stands on the table.

    What is on or in it goes along.
    """
    most = np.array([settings.move, settings.move, settings.turn])
    drawn = (most * rng.uniform(-1, 1, (len(world.names), 3))).tolist()
    roots = set(supports(world.scene).values())
    return {name: row for name, row in zip(world.names, drawn, strict=True) if name in roots}


def apply_poses(world: World, drawn: dict[str, Any]) -> list[str]:
    """Rearrange the world's scene; return the names of those that had to stay where they were.

    The world is left at its start.
    """
    before, root = world.scene, supports(world.scene)
    moves: dict[str, Any] = dict(drawn)
    while moves:
        world.rearrange(moved(before, root, moves))
        bad = _misplaced(world, before, root, set(moves))
        if not bad:
            break
        moves = {name: move for name, move in moves.items() if name not in bad}
    else:
        world.rearrange(before)
    world.reset()
    return [name for name in drawn if name not in moves]


def supports(scene: Scene) -> dict[str, str]:
    """Return, for each object, the one on the table that carries it in the end, or itself."""
    on = {thing.name: thing.placement.on for thing in scene.objects}
    found = {}
    for name in on:
        root = name
        for _ in on:  # at most as many steps as there are objects
            if on[root] == TABLE or on[root] not in on:
                break
            root = on[root]
        found[name] = root
    return found


def moved(scene: Scene, root: Mapping[str, str], moves: Mapping[str, Any]) -> Scene:
    """Return the scene with things moved (x, y) and turned about those that carry them."""
    objects = []
    for thing in scene.objects:
        carrier = root[thing.name]
        if carrier in moves:
            x, y, turn = moves[carrier]
            centre = scene.object(carrier).pose.position
            thing = _moved(thing, centre, np.array([x, y, 0.0]), turn)
        objects.append(thing)
    return scene.replace(objects=tuple(objects))


def _moved(
    thing: Object, centre: Float[np.ndarray, "3"], move: Float[np.ndarray, "3"], turn: float
) -> Object:
    """Return a thing moved, and turned about the vertical through ``centre``."""
    rotation, half = rotation_z(turn), turn / 2
    position = centre + rotation @ (thing.pose.position - centre) + move
    w, x, y, z = thing.pose.quaternion
    c, s = np.cos(half), np.sin(half)
    turned = np.array([c * w - s * z, c * x - s * y, c * y + s * x, c * z + s * w])
    return replace(thing, pose=Pose(position, turned))


def _misplaced(world: World, before: Scene, root: Mapping[str, str], movers: set[str]) -> set[str]:
    """Return which of the ``movers`` have to stay: over the edge, overlapping, not at rest."""
    import mujoco

    bad = {name for name in movers if _over_the_edge(world.scene, before, name)}
    if bad:
        return bad
    world.reset()
    bad = _overlapping(world, root, movers)
    if bad:
        return bad
    start = _poses(world)
    for _ in range(SETTLING):
        mujoco.mj_step(world.model, world.data)
    mujoco.mj_kinematics(world.model, world.data)
    bad = {root[name] for name in _restless(world, start)}
    return bad & movers or (movers if bad else set())  # a neighbour that leaned on one of them


def _over_the_edge(scene: Scene, before: Scene, name: str) -> bool:
    """Return whether a thing reaches farther over the table's edge than it did, if at all."""
    outline = scene.table.outline
    now, then = (inside_margin(footprint(s.object(name)), outline).min() for s in (scene, before))
    return bool(now < min(then, 0.0))


def _overlapping(world: World, root: Mapping[str, str], movers: set[str]) -> set[str]:
    """Return the movers that touch the robot or reach into what does not go with them."""
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
    turned = world.data.xmat[world.bodies].reshape(-1, 3, 3)
    return world.data.xpos[world.bodies].copy(), turned.copy()


def _restless(
    world: World, start: tuple[Float[np.ndarray, "k 3"], Float[np.ndarray, "k 3 3"]]
) -> list[str]:
    """Return the objects that have left the poses they had at the ``start``."""
    position, rotation = _poses(world)
    drift = np.linalg.norm(position - start[0], axis=1)
    cosine = (np.einsum("kij,kij->k", rotation, start[1]) - 1) / 2
    away = (drift > DRIFT) | (cosine < np.cos(TILT))
    return [name for name, gone in zip(world.names, away, strict=True) if gone]


# ------------------------------------------------------------------------------------ distractors


def draw_distractors(
    settings: Randomization, world: World, rng: np.random.Generator
) -> dict[str, Any]:
    """Draw how many objects may stay beside those of the task, and in which order others go."""
    low, high = settings.distractors or (0, 0)
    order = [world.names[k] for k in rng.permutation(len(world.names))]
    return {"most": int(rng.integers(low, high + 1)), "order": order}


def leaving(
    scene: Scene, keep: Collection[str], most: int, order: Collection[str]
) -> tuple[str, ...]:
    """Return which objects go, so that at most ``most`` stay beside those in ``keep``.

    What carries something that stays does not go, and what is on or in something that goes does.
    """
    on = {thing.name: thing.placement.on for thing in scene.objects}
    kept = set(keep)
    for name in keep:
        while (name := on.get(name, TABLE)) in on and name not in kept:
            kept.add(name)
    gone: set[str] = set()
    for name in order:
        if len(on) - len(kept) - len(gone) <= most:
            break
        load = _load(on, name)
        if not load & kept:
            gone |= load
    return tuple(name for name in on if name in gone)


def _load(on: Mapping[str, str], name: str) -> set[str]:
    """Return an object and all that is on or in it."""
    load = {name}
    while more := {k for k, support in on.items() if support in load and k not in load}:
        load |= more
    return load


def take_away(world: World, names: Collection[str]) -> None:
    """Park objects under the floor, where they touch nothing, weigh nothing and have no slot."""
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
