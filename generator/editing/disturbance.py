"""Which objects of a scene an edit disturbs: all others keep their poses to the bit."""

from __future__ import annotations

from collections.abc import Collection, Iterable

import numpy as np

from ..physics.simulation import Simulation
from ..scene import Object, Scene

Pairs = frozenset[tuple[str, str]]


def find_disturbed(before: Scene, now: Scene, gap: float) -> frozenset[str]:
    """Return the names of objects that are new or elsewhere, or touch or touched one that is.

    ``before`` is the scene at rest before the edit. What was removed counts as elsewhere. Objects
    touch within ``gap`` metres, or where one stands on or in the other.
    """
    old, new = ({o.name: o for o in scene.objects} for scene in (before, now))
    changed = {n for n in {*old, *new} if not _unchanged(old.get(n), new.get(n))}
    pairs = _touching(before, gap) | _touching(now, gap)
    return frozenset((changed | {n for pair in pairs if changed & {*pair} for n in pair}) & {*new})


def find_connected(before: Scene, now: Scene, names: Collection[str], gap: float) -> frozenset[str]:
    """Return the names of objects that are connected with some by touching, before or now."""
    pairs, found = _touching(before, gap) | _touching(now, gap), {*names}
    while more := {n for pair in pairs if found & {*pair} for n in pair} - found:
        found |= more
    return frozenset(found & {o.name for o in now.objects})


def _unchanged(old: Object | None, new: Object | None) -> bool:
    """Whether an object has the same body at the same pose, to the bit."""
    if old is None or new is None:
        return False
    pairs: Iterable[tuple[np.ndarray, np.ndarray]] = (
        (old.pose.position, new.pose.position),
        (old.pose.quaternion, new.pose.quaternion),
        (old.scale, new.scale),
    )
    return old.model is new.model and all(np.array_equal(a, b) for a, b in pairs)


def _touching(scene: Scene, gap: float) -> Pairs:
    """Return the pairs of objects that touch, or of which one stands on or in the other."""
    names = [o.name for o in scene.objects]
    near = Simulation(scene).contacts(margin=gap).pairs.tolist()
    touching = {(names[a], names[b]) for a, b in near if min(a, b) >= 0}
    stacked = {(o.name, o.placement.on) for o in scene.objects if o.placement.on in names}
    return frozenset(touching | stacked)
