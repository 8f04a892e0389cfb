"""Placement of objects on or in their supports, and at free positions on the table."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np
from jaxtyping import Float

from ..geometry import inside_margin
from ..scene import TABLE, Object, Pose, Scene
from .parts import base, highest, lowest
from .separation import TOLERANCE, ancestry, off_table, with_poses
from .simulation import ON_TABLE, Simulation

_GOLDEN = np.pi * (3 - np.sqrt(5))
_AWAY = np.array([20.0, 0.0, 20.0])  # metres; where objects wait that are not placed yet
_GAP = 2e-4  # initial gap between an object and its support, metres


def seat_on_table(thing: Object, height: float) -> Object:
    """Return the upright object with its lowest point just above ``height``."""
    x, y, _ = thing.pose.position
    z = height + _GAP - lowest(thing)
    return replace(thing, pose=Pose(np.array([x, y, z]), thing.pose.quaternion))


def seat_stacked(scene: Scene, names: Collection[str] | None = None) -> Scene:
    """Lower each stacked object onto or into its support, starting with the lowest supports.

    ``names`` selects the objects; None means all. An object is lowered from above at its own
    position. If that is occupied, or if an object that belongs *in* a container would stay on its
    rim, the object is lowered at the nearest better position on the support.
    """
    chains = ancestry(scene.objects)
    order = sorted(range(len(chains)), key=lambda i: (len(chains[i]), i))
    loads = {
        i for i in order
        if len(chains[i]) > 1 and (names is None or scene.objects[i].name in names)
    }  # fmt: skip
    if not loads:
        return scene
    simulation = Simulation(scene)
    simulation.positions[:] = _AWAY * (1 + np.arange(len(order)))[:, None]
    present: set[int] = {ON_TABLE}
    for i in order:
        if i in loads:
            scene = _seat(scene, i, chains[i][1], simulation, present)
        simulation.positions[i] = scene.objects[i].pose.position
        present.add(i)
    return scene


def relocate(
    scene: Scene, stuck: Sequence[str], wanted: Mapping[str, Pose]
) -> tuple[Scene, tuple[str, ...]]:
    """Move the ``stuck`` objects to the free positions nearest to those requested.

    The largest object is moved first, and the others are ignored meanwhile. Objects on top of a
    moved object move with it. Returns the scene and the names of objects without a free position (a
    stacked object can only be at its own).
    """
    waiting = sorted(stuck, key=lambda n: -float(np.prod(scene.object(n).scale[:2])))
    homeless = []
    while waiting:
        name = waiting.pop(0)
        if scene.object(name).placement.on != TABLE:
            homeless.append(name)
            continue
        if place := nearest_free(scene, name, wanted[name], {*waiting, *homeless}):
            scene = carry(scene, {name: place})
        else:
            homeless.append(name)
    return scene, tuple(
        name
        for name in homeless
        if off_table(scene, scene.object(name)) or overlapping(scene, name, set(homeless) - {name})
    )


def nearest_free(
    scene: Scene, name: str, wanted: Pose, absent: Collection[str] = ()
) -> Pose | None:
    """Return the free pose of ``name`` on the table nearest to ``wanted``, or None if none is free.

    The objects in ``absent`` are ignored.
    """
    index, others = _others(scene, name, absent)
    thing = scene.objects[index]
    simulation = Simulation(scene)
    z = scene.table.height + _GAP - lowest(thing)
    size = float(np.linalg.norm(np.ptp(scene.table.outline, axis=0)))
    for offset in spiral(size, size / 40):
        pose = Pose(np.append(wanted.position[:2] + offset, z), thing.pose.quaternion)
        if inside_margin(base(thing, pose), scene.table.outline).min() < 0:
            continue
        simulation.positions[index] = pose.position
        if _depth(simulation, index, others) <= TOLERANCE:
            return pose
    return None


def overlapping(scene: Scene, name: str, absent: Collection[str] = ()) -> bool:
    """Return whether ``name`` overlaps, not just touches, an object that is not in ``absent``."""
    return _depth(Simulation(scene), *_others(scene, name, absent)) > TOLERANCE


def carry(scene: Scene, places: Mapping[str, Pose]) -> Scene:
    """Move objects, together with the objects on them, to new positions."""
    poses = []
    for chain, thing in zip(ancestry(scene.objects), scene.objects, strict=True):
        movers = [scene.objects[k] for k in chain if scene.objects[k].name in places]
        shift = places[movers[0].name].position - movers[0].pose.position if movers else 0.0
        poses.append(Pose(thing.pose.position + shift, thing.pose.quaternion))
    return scene.replace(objects=with_poses(scene.objects, poses))


def spiral(radius: float, spacing: float) -> Iterator[Float[np.ndarray, "2"]]:
    """Yield evenly distributed offsets from zero outwards to ``radius`` (a sunflower spiral)."""
    for k in range(int((radius / spacing) ** 2) + 1):
        yield spacing * np.sqrt(k) * np.array([np.cos(k * _GOLDEN), np.sin(k * _GOLDEN)])


def _seat(
    scene: Scene, index: int, below: int, simulation: Simulation, present: Collection[int]
) -> Scene:
    """Return the scene with an object lowered onto ``below``, avoiding the objects ``present``."""
    thing, support = scene.objects[index], scene.objects[below]
    rim = support.pose.position[2] + highest(support)
    reach = float(np.min(support.scale[:2])) / 2
    deep = min(highest(support) - lowest(support), 0.1)  # the maximum depth inside the container
    wanted = rim + _GAP if not thing.placement.inside else rim - 0.3 * deep
    best: tuple[float, np.ndarray] | None = None
    for offset in spiral(reach, reach / 5):
        xy = thing.pose.position[:2] + offset
        top, fall = rim - lowest(thing) + 0.002, highest(support) - lowest(support)
        if thing.placement.inside and not offset.any():
            simulation.positions[index] = thing.pose.position
            if _depth(simulation, index, present) <= TOLERANCE:  # in contact with its support
                top = min(top, float(thing.pose.position[2]) + TOLERANCE + 1e-5)
        z = _lower(simulation, index, present, xy, top, fall)
        if z is None:
            continue
        bottom = z + lowest(thing)
        if best is None or bottom < best[0] - 1e-3:
            best = (bottom, np.array([*xy, z]))
        if bottom <= wanted:
            break
    if best is None:
        return scene
    poses = [o.pose for o in scene.objects]
    poses[index] = Pose(best[1], thing.pose.quaternion)
    return scene.replace(objects=with_poses(scene.objects, poses))


def _lower(
    simulation: Simulation,
    index: int,
    present: Collection[int],
    xy: np.ndarray,
    top: float,
    fall: float,
) -> float | None:
    """Lower an object at ``xy`` until contact; return its height, or None if ``top`` is blocked."""

    def free(z: float) -> bool:
        simulation.positions[index] = [*xy, z]
        return _depth(simulation, index, present) <= 1e-6

    if not free(top):
        return None
    z, step = top, 4e-3
    while z > top - fall and free(z - step):
        z -= step
    low, high = z - step, z
    while high - low > 1e-4:
        middle = (low + high) / 2
        low, high = (low, middle) if free(middle) else (middle, high)
    return high + _GAP


def _others(scene: Scene, name: str, absent: Collection[str]) -> tuple[int, set[int]]:
    """Return the index of ``name``, and those of present objects that are not stacked with it."""
    chains = ancestry(scene.objects)
    names = [o.name for o in scene.objects]
    index = names.index(name)
    return index, {
        k for k, chain in enumerate(chains)
        if k not in chains[index] and index not in chain
        and not any(names[m] in absent for m in chain)
    }  # fmt: skip


def _depth(simulation: Simulation, index: int, others: Collection[int]) -> float:
    """Return the greatest depth to which object ``index`` overlaps one of ``others``."""
    deep = simulation.contacts().deepest().items()
    return max((d for (a, b), d in deep if index in (a, b) and a + b - index in others), default=0)
