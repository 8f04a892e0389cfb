"""How hard a scene is to work at, from its geometry alone."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np
from jaxtyping import Float

from generator.scene import TABLE, Object, Scene, hold_supports

from ..affordance import (
    FINGER_CLEARANCE,
    GRIPPER_OPENING,
    MIN_HEIGHT,
    footprint,
    grasp_width,
    opening,
    resting_height,
    why_not_graspable,
)
from ..robot.mount import Mount

TERMS = ("objects", "clutter", "clearance", "distance", "stacking", "size")
"""What difficulty is made of; see ``difficulty_terms``."""

MANY = 20
"""Number of objects from which on it gets no harder."""

DEEP = 2
"""So many things below a thing, or more, are the worst."""

FULL = 0.35
"""Share of a tabletop that is covered where clutter is at its worst."""

FREE = 0.12
"""Gap to the nearest neighbour, metres, from which on the hand has all the room it needs."""

NEAR, FAR = 0.45, 0.77
"""Distances from the robot's base, metres: up to the first is easy, at the second is the end of
what the hand reaches."""

SMALL, TINY = 0.03, 0.01
"""Widths, metres: things narrower than the first are hard to hit, those below the second most."""

WIDE = 0.05
"""Width, metres, from which on the fingers must come down with care; they open 8 cm."""

LOW = 0.04
"""Height, metres, below which the fingers work close to the table."""

RIM = 0.5
"""How hard it is to take a vessel by its wall."""


def difficulty(scene: Scene, target: str | None = None) -> float:
    """Return how hard a scene is to work at, in [0, 1]: the mean of ``difficulty_terms``.

    Of a ``target`` (an object's name) it is how hard that object is to work with. Else it knows the
    scene alone: the same scene has the same difficulty for every robot of the Panda's size that
    stands where ``Mount.beside`` puts it, whatever the task. A bare table has 0.

    Raises:
        InputError: there is no such object.
    """
    return float(np.mean(list(difficulty_terms(scene, target).values())))


def difficulty_terms(scene: Scene, target: str | None = None) -> Mapping[str, float]:
    """Return what makes a scene hard, each in [0, 1] and 0 for a bare table.

    Where there is a mean over things, it is of ``target`` alone if one is given.

    ==========  ==============================================================================
    objects     how many there are, over ``MANY``
    clutter     share of the tabletop that is covered by what stands on it, over ``FULL``
    clearance   how little room there is: 1 for things that touch, 0 from a gap of ``FREE`` to
                the nearest neighbour on the table; the mean over things that stand on the table.
                Of a target on another thing the neighbours are all but what it stands on
    distance    how far from the robot's base: 0 up to ``NEAR``, 1 at ``FAR`` and wherever the
                hand does not reach; the mean over all things
    stacking    how many things lie between a thing and the table, over ``DEEP``; the mean over
                all things
    size        how badly a thing's size suits the hand, as it rests: narrower than ``SMALL`` (1 at
                ``TINY``), wider than ``WIDE`` (1 where the fingers no longer open), lower than
                ``LOW`` (1 at the lowest the fingers take), the worst of these; ``RIM`` for what is
                only taken by its wall; the mean over what can be grasped at all, 1 if nothing can
    ==========  ==============================================================================

    Raises:
        InputError: there is no such object.
    """
    if not scene.objects and target is None:
        return dict.fromkeys(TERMS, 0.0)
    held = hold_supports(scene)
    asked = held.objects if target is None else (held.object(target),)
    misfits = [misfit for o in asked if (misfit := _misfit(o)) is not None]
    crowding = _crowding(held)
    if target is not None:
        crowding["clearance"] = _tightness(held, asked[0])
    return {
        "objects": min(len(held.objects) / MANY, 1.0),
        **crowding,
        "distance": float(_distances(scene, asked).mean()),
        "stacking": float(np.mean([min(len(_below(held, o)) / DEEP, 1.0) for o in asked])),
        "size": float(np.mean(misfits or [1.0])),
    }


def _below(scene: Scene, thing: Object) -> list[str]:
    """Return what lies between an object and the table, the nearest first."""
    found: list[str] = []
    while (support := thing.placement.on) != TABLE and support not in found:
        found.append(support)
        thing = scene.object(support)
    return found


def _tightness(scene: Scene, target: Object) -> float:
    """Return the clearance term of one object, from the outlines of all but what carries it."""
    import shapely

    carrying = {target.name, *_below(scene, target)}
    others = [o for o in scene.objects if o.name not in carrying]
    outlines = np.array([shapely.Polygon(footprint(o)) for o in (target, *others)])
    gaps = np.asarray(shapely.distance(outlines[1:], outlines[0]))
    return float(1 - np.clip(gaps.min(initial=np.inf) / FREE, 0, 1))


def _crowding(scene: Scene) -> dict[str, float]:
    """Return clutter and clearance, from the outlines of what stands on the table."""
    import shapely

    standing = [o for o in scene.objects if o.placement.on == TABLE]
    if not standing:
        return {"clutter": 0.0, "clearance": 0.0}
    outlines = np.array([shapely.Polygon(footprint(o)) for o in standing])
    top = shapely.Polygon(scene.table.outline)
    covered = shapely.area(shapely.intersection(shapely.union_all(outlines), top)) / top.area
    gaps = np.asarray(shapely.distance(outlines[:, None], outlines[None]))
    nearest = (gaps + np.diag(np.full(len(standing), np.inf))).min(1)
    return {
        "clutter": float(np.clip(covered / FULL, 0, 1)),
        "clearance": float((1 - np.clip(nearest / FREE, 0, 1)).mean()),
    }


def _distances(scene: Scene, things: Sequence[Object]) -> Float[np.ndarray, "k"]:
    mount, places = Mount.beside(scene), np.array([o.pose.position for o in things])
    away = np.hypot(*(places - mount.position)[:, :2].T)
    far = np.clip((away - NEAR) / (FAR - NEAR), 0, 1)
    return np.where(mount.reaches(places), far, 1.0)


def _misfit(obj: Object) -> float | None:
    """Return how badly an object's size suits the hand, in [0, 1]; None if it cannot be grasped."""
    if why_not_graspable(obj, None) is not None:
        walled = obj.model.container and why_not_graspable(obj, opening(obj)) is None
        return RIM if walled else None
    width, height = grasp_width(obj), resting_height(obj)
    widest = GRIPPER_OPENING - FINGER_CLEARANCE
    misfit = max(
        (SMALL - width) / (SMALL - TINY),
        (width - WIDE) / (widest - WIDE),
        (LOW - height) / (LOW - MIN_HEIGHT),
    )
    return float(np.clip(misfit, 0, 1))
