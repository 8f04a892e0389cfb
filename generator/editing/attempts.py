"""Settling of an edited scene at successive positions until it passes the gate."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterable, Sequence
from dataclasses import replace

import numpy as np

from ..errors import SceneError
from ..generation import Config
from ..method.assembly import AssemblyConfig, Rested, finish, keep_unmoved, rest, with_lean_of
from ..physics.simulation import Simulation
from ..physics.standing_height import overlapping
from ..scene import TABLE, Object, Scene
from .placement import check_held, loads, set_down


def settle_again(
    before: Scene,
    wanted: Scene,
    arranged: Scene,
    fresh: Collection[str],
    config: Config,
    loose: Collection[str] = (),
) -> Scene:
    """Settle an edited scene, run the gate, and check that edited objects stay on their supports.

    ``before`` is the scene at rest before the edit. ``wanted`` is the scene with all objects at
    their requested poses; ``arranged`` has them on or just above their supports, without overlaps.
    Objects that the edit does not disturb keep bitwise identical poses.
    """
    done = _settle(before, wanted, arranged, fresh, config.assembly)
    touched = [*fresh, *loose]
    check_held(done, [*touched, *(n for name in touched for n in loads(done, name))])
    return done


def _settle(
    before: Scene, wanted: Scene, arranged: Scene, fresh: Collection[str], config: AssemblyConfig
) -> Scene:
    """Settle new and displaced objects, those touching them, and those they disturb in turn.

    All other objects are fixed during this. The gate then checks the scene with all objects free;
    if it fails, objects in indirect contact with edited ones may settle further. Gravity has the
    tilt recorded for ``before``.
    """
    config = with_lean_of(before, config)
    gap = config.limits.gap
    loose = find_disturbed(before, arranged, gap)
    while True:
        rested, unstable = rest(arranged, config, fresh, loose)
        rested = keep_unmoved(arranged, rested, fresh)
        more = loose | find_disturbed(before, rested, gap)
        if more == loose:
            break
        loose = more
    loose = find_connected(before, rested, loose, gap)
    settled = Rested(wanted, arranged, rested, unstable=unstable, loose=loose)
    done = finish(settled, config, fresh)
    if done.report is None or before.report is None:
        return done
    return done.replace(report=replace(done.report, dropped=before.report.dropped))


def try_places(
    before: Scene,
    placed: Callable[[int], Scene],
    name: str,
    fresh: Sequence[str],
    config: Config,
    loose: Sequence[str] = (),
    attempts: int = 1,
) -> Scene:
    """Try positions for ``name`` and return the first scene that passes the gate.

    ``before`` is the scene before the edit. ``placed`` takes the number of an attempt and returns
    the scene with the object at that attempt's position. ``fresh`` are the names of new objects,
    ``loose`` those of displaced ones.

    Raises:
        SceneError: No position is free, or the object does not stay on its support. If only the
            gate fails, the last scene is returned instead.
    """
    error: SceneError | None = None
    done = None
    for attempt in range(attempts):
        try:
            wanted = placed(attempt)
            stacked = [n for n in (name,) if wanted.object(n).placement.on != TABLE]
            arranged = set_down(wanted, stacked)
            _check_free(arranged, (name, *loose))
            done = settle_again(before, wanted, arranged, fresh, config, loose)
        except SceneError as failed:
            error = failed
            continue
        if done.report is not None and done.report.passed:
            return done
    if done is None:
        raise error or SceneError(f"No position was tried for {name}.")
    return done


def _check_free(scene: Scene, names: Sequence[str]) -> None:
    for name in names:
        if overlapping(scene, name):
            raise SceneError(
                f"{name} would overlap another object. Choose another position, or move that "
                "object first."
            )


Pairs = frozenset[tuple[str, str]]


def find_disturbed(before: Scene, now: Scene, gap: float) -> frozenset[str]:
    """Return the names of new or displaced objects and of those in contact with them.

    ``before`` is the scene at rest before the edit. Removed objects count as displaced. Two objects
    are in contact if, before or after the edit, they are within ``gap`` metres of each other or one
    stands on or in the other.
    """
    old, new = ({o.name: o for o in scene.objects} for scene in (before, now))
    changed = {n for n in {*old, *new} if not _unchanged(old.get(n), new.get(n))}
    pairs = _touching(before, gap) | _touching(now, gap)
    return frozenset((changed | {n for pair in pairs if changed & {*pair} for n in pair}) & {*new})


def find_connected(before: Scene, now: Scene, names: Collection[str], gap: float) -> frozenset[str]:
    """Return the names of objects linked to ``names`` by chains of contacts in either scene."""
    pairs, reached = _touching(before, gap) | _touching(now, gap), {*names}
    while more := {n for pair in pairs if reached & {*pair} for n in pair} - reached:
        reached |= more
    return frozenset(reached & {o.name for o in now.objects})


def _unchanged(old: Object | None, new: Object | None) -> bool:
    """Return whether an object has the same model, size and pose, bit for bit."""
    if old is None or new is None:
        return False
    pairs: Iterable[tuple[np.ndarray, np.ndarray]] = (
        (old.pose.position, new.pose.position),
        (old.pose.quaternion, new.pose.quaternion),
        (old.scale, new.scale),
    )
    return old.model is new.model and all(np.array_equal(a, b) for a, b in pairs)


def _touching(scene: Scene, gap: float) -> Pairs:
    """Return the pairs of objects that touch or stand on or in each other."""
    names = [o.name for o in scene.objects]
    near = Simulation(scene).contacts(margin=gap).pairs.tolist()
    touching = {(names[a], names[b]) for a, b in near if min(a, b) >= 0}
    stacked = {(o.name, o.placement.on) for o in scene.objects if o.placement.on in names}
    return frozenset(touching | stacked)
