"""The difficulty of a scene for manipulation, from its geometry alone."""

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
"""Names of the terms of a difficulty; see ``difficulty_terms``."""

MANY = 20
"""Number of objects at which the objects term reaches 1."""

DEEP = 2
"""Number of objects below an object at which the stacking term reaches 1."""

FULL = 0.35
"""Covered fraction of the tabletop at which the clutter term reaches 1."""

FREE = 0.12
"""Gap to the nearest neighbour, in metres, above which the hand is unobstructed."""

NEAR, FAR = 0.45, 0.77
"""Distances from the robot's base, in metres: the distance term is 0 up to the first distance and 1
beyond the second distance, which is the limit of the robot's reach."""

SMALL, TINY = 0.03, 0.01
"""Widths, in metres: the size term grows below the first and reaches 1 at the second."""

WIDE = 0.05
"""Width, in metres, above which the fingers, which open 8 cm, have little clearance."""

LOW = 0.04
"""Height, in metres, below which the fingers work close to the table."""

RIM = 0.5
"""Size term of a vessel that can only be grasped by its rim."""


def difficulty(scene: Scene, target: str | None = None) -> float:
    """Compute the difficulty of a scene in [0, 1], the mean of ``difficulty_terms``.

    With ``target`` (an object's name) it is the difficulty of manipulating that object. Otherwise
    it depends on the scene only: the same scene has the same difficulty for every robot of the
    Panda's size mounted by ``Mount.beside``, and for every task. An empty table has difficulty 0.

    Raises:
        InputError: the object does not exist.
    """
    return float(np.mean(list(difficulty_terms(scene, target).values())))


def difficulty_terms(scene: Scene, target: str | None = None) -> Mapping[str, float]:
    """Compute the terms of a scene's difficulty, each in [0, 1] and 0 for an empty table.

    With ``target``, means over objects are replaced by the value of the target.

    ==========  ==============================================================================
    objects     number of objects, divided by ``MANY``
    clutter     share of the tabletop covered by objects that stand on it, divided by ``FULL``
    clearance   lack of space: 1 for touching objects, 0 from a gap of ``FREE`` to the nearest
                neighbour on the table; the mean over objects that stand on the table. For a
                target on another object, its neighbours are all objects but its carriers
    distance    distance from the robot's base: 0 up to ``NEAR``, 1 at ``FAR`` and wherever the
                hand does not reach; the mean over all objects
    stacking    number of objects between an object and the table, divided by ``DEEP``; the mean
                over all objects
    size        mismatch between an object's size at rest and the fingers: narrower than ``SMALL``
                (1 at ``TINY``), wider than ``WIDE`` (1 at the maximum opening), lower than ``LOW``
                (1 at the minimum height), the maximum of these; ``RIM`` for objects that can only
                be grasped by a wall; the mean over graspable objects, 1 if there are none
    ==========  ==============================================================================

    Raises:
        InputError: the object does not exist.
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
    """Return the objects between an object and the table, nearest first."""
    found: list[str] = []
    while (support := thing.placement.on) != TABLE and support not in found:
        found.append(support)
        thing = scene.object(support)
    return found


def _tightness(scene: Scene, target: Object) -> float:
    """Return the clearance term of one object, ignoring the objects that carry it."""
    import shapely

    carrying = {target.name, *_below(scene, target)}
    others = [o for o in scene.objects if o.name not in carrying]
    outlines = np.array([shapely.Polygon(footprint(o)) for o in (target, *others)])
    gaps = np.asarray(shapely.distance(outlines[1:], outlines[0]))
    return float(1 - np.clip(gaps.min(initial=np.inf) / FREE, 0, 1))


def _crowding(scene: Scene) -> dict[str, float]:
    """Return clutter and clearance terms, from the outlines of objects standing on the table."""
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
    """Return the size term of an object, in [0, 1], or None if it cannot be grasped."""
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
