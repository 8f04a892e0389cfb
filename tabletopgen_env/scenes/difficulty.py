"""How hard a scene is to work at, from its geometry alone."""

from __future__ import annotations

from collections.abc import Mapping

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


def difficulty(scene: Scene) -> float:
    """Return how hard a scene is to work at, in [0, 1]: the mean of ``difficulty_terms``.

    It knows the scene alone, no task: the same scene has the same difficulty for every robot of
    the Panda's size that stands where ``Mount.beside`` puts it. A bare table has 0.
    """
    return float(np.mean(list(difficulty_terms(scene).values())))


def difficulty_terms(scene: Scene) -> Mapping[str, float]:
    """Return what makes a scene hard, each in [0, 1] and 0 for a bare table.

    ==========  ==============================================================================
    clutter     share of the tabletop that is covered by what stands on it, over ``FULL``
    clearance   how little room there is: 1 for things that touch, 0 from a gap of ``FREE`` to
                the nearest neighbour on the table; the mean over things that stand on the table
    distance    how far from the robot's base: 0 up to ``NEAR``, 1 at ``FAR`` and wherever the
                hand does not reach; the mean over all things
    size        how badly a thing's size suits the hand, as it rests: narrower than ``SMALL`` (1 at
                ``TINY``), wider than ``WIDE`` (1 where the fingers no longer open), lower than
                ``LOW`` (1 at the lowest the fingers take), the worst of these; ``RIM`` for what is
                only taken by its wall; the mean over what can be grasped at all, 1 if nothing can
    ==========  ==============================================================================
    """
    if not scene.objects:
        return dict.fromkeys(("clutter", "clearance", "distance", "size"), 0.0)
    misfits = [misfit for o in scene.objects if (misfit := _misfit(o)) is not None]
    return {
        **_crowding(scene),
        "distance": float(_distances(scene).mean()),
        "size": float(np.mean(misfits or [1.0])),
    }


def _crowding(scene: Scene) -> dict[str, float]:
    """Return clutter and clearance, from the outlines of what stands on the table."""
    import shapely

    standing = [o for o in hold_supports(scene).objects if o.placement.on == TABLE]
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


def _distances(scene: Scene) -> Float[np.ndarray, "k"]:
    mount, places = Mount.beside(scene), np.array([o.pose.position for o in scene.objects])
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
