"""Candidates for targets and goals in a scene: movable objects and their destinations."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping
from functools import partial

import numpy as np
from jaxtyping import Float

from generator.errors import InputError, SceneError, choices
from generator.geometry import inside_margin, rotation_z, wrap
from generator.scene import TABLE, Object

from ..affordance import is_upright, resting_height
from ..expert.arm import stretch, up
from ..expert.planning.choice import HOVER, GraspPlan, first_plan, has_grasp
from ..goals.goal import SPOT, Into, OnSpot
from ..robot.mount import obstacle, reachable
from ..world.workspace import free_spot
from ..world.world import World
from .task import Choice, Episode

ROOM = 0.008
"""Minimum clearance between a container's hollow and an object in it at any yaw, in metres."""

NO_GRASP = (
    "no grasp of the object is in the arm's reach, or its neighbours leave no room for the hand"
)
"""Reason for objects without a reachable grasp according to ``has_grasp``."""

_TURNS = tuple(k * math.pi / 6 for k in range(-6, 6))

Reasons = dict[str, str | None]
"""The reason why each object cannot be used, or None for a usable object."""


def liftable(world: World) -> Reasons:
    """Return why each object cannot be picked up (None if it can), without planning grasps."""
    return {
        o.name: world.ungraspable[o.name] or blocking_reason(world, o) for o in world.scene.objects
    }


def blocking_reason(world: World, obj: Object) -> str | None:
    """Return why the hand cannot reach an object or move it separately, or None if it can."""
    if not reachable(world.mount, obj.pose.position):
        return "out of the robot's reach"
    if (between := obstacle(world.scene, world.mount, obj.name)) is not None:
        return f"{between} obstructs the arm"
    if obj.placement.inside:
        return f"the object lies inside {obj.placement.on}, out of the fingers' reach"
    loaded = [o.name for o in world.scene.objects if o.placement.on == obj.name]
    return f"{loaded[0]} stands on it" if loaded else None


def draw_episode(
    world: World,
    rng: np.random.Generator,
    target: str | None,
    reasons: Reasons,
    make: Callable[[Object], Episode | None],
    lacks: str,
    held: bool = True,
) -> Episode:
    """Return the episode that ``make`` creates for the given target, or for a drawn one.

    Args:
        world: the world, at its start.
        rng: source of the random order in which targets are tried.
        target: the name of the target, tried regardless of ``reasons``; None draws one.
        reasons: reasons why objects cannot be targets; new ones are added.
        make: returns an object's episode, or None if it has none.
        lacks: the reason to report if ``make`` returns None.
        held: whether the arm must reach a grasp of the target.

    Raises:
        SceneError: no object is a valid target; the message gives the reason for each.
        InputError: the target does not exist.
    """
    if target is None:
        names = [name for name, reason in reasons.items() if reason is None]
        names = [names[k] for k in map(int, rng.permutation(len(names)))]
    else:
        names = [check_known(world, target, "to move")]
    for name in names:
        if target is None and held and not has_grasp(world, name):
            reasons[name] = NO_GRASP
            continue
        found = make(world.scene.object(name))
        if found is not None:
            return found
        reasons[name] = lacks
    raise nothing(world, reasons)


def check_known(world: World, name: str, what: str) -> str:
    """Return ``name`` if the scene has an object with this name.

    Raises:
        InputError: the object does not exist.
    """
    if name not in world.names:
        raise InputError(f"No object {name!r} {what}." + choices(str(name), world.names))
    return name


def nothing(world: World, reasons: Mapping[str, str | None]) -> SceneError:
    """Return the error for a scene without a valid task."""
    listed = "; ".join(f"{name}: {why}" for name, why in reasons.items() if why)
    return SceneError(
        f"Scene {world.scene.name!r} has no valid target ({listed or 'no objects'}). "
        "Use other scenes, or set reset(options={'target': ..., 'goal': ...})."
    )


def rest_height(world: World, name: str) -> float:
    """Return the height of an object's centre above its support, in metres."""
    return float(world.position(name)[2]) - world.lowest(name)


def spot_of(
    world: World, obj: Object, goal: Choice, rng: np.random.Generator
) -> Float[np.ndarray, "3"] | None:
    """Return the spot that ``goal`` specifies, or a random free spot on the table (world frame).

    At a random spot the arm can place the object with its planned grasp.
    """
    if goal is None or isinstance(goal, str):
        plan = first_plan(world, obj.name)
        fits = None if plan is None else partial(_is_brought_to, world, obj, plan)
        xy = free_spot(world, obj.name, rng, fits)
    else:
        xy = given_point(world, goal)
    return None if xy is None else np.array([*xy, world.scene.table.height])


def _is_brought_to(
    world: World, obj: Object, plan: GraspPlan, point: Float[np.ndarray, "2"]
) -> bool:
    """Return whether the arm can place ``obj``, grasped as in ``plan``, on a point at some yaw."""
    center = np.array([*point, world.scene.table.height + rest_height(world, obj.name)])
    held = plan.grasp.point - world.position(obj.name)
    return any(
        stretch(world, (tool, tool + up(HOVER)), wrap(plan.yaw + turn)) is not None
        for turn in _TURNS
        for tool in (center + rotation_z(turn) @ held,)
    )


def coordinates(goal: object, count: int, wanted: str) -> Float[np.ndarray, "c"]:
    """Convert a user's value to ``count`` finite numbers; ``wanted`` describes them in the error.

    Raises:
        InputError: the value is anything else.
    """
    try:
        point = np.asarray(goal, float)
    except (TypeError, ValueError):
        point = np.empty(0)
    if point.shape != (count,) or not np.isfinite(point).all():
        raise InputError(f"{wanted}, got {goal!r}.")
    return point


def given_point(world: World, goal: Iterable[float]) -> Float[np.ndarray, "2"]:
    """Convert a user's value to a point (x, y), which must be on the table.

    Raises:
        InputError: the value is not a pair of finite numbers, or not on the table.
    """
    xy = coordinates(goal, 2, "A goal spot must be two finite numbers (x, y)")
    if inside_margin(xy, world.scene.table.outline)[0] < 0:
        raise InputError(f"The goal spot {xy.tolist()} is not on the table.")
    return xy


def containers(world: World, obj: Object) -> Iterator[Object]:
    """Yield the upright, reachable containers with enough room for an object."""
    outline = world.footprints[obj.name]  # for any yaw of the hand
    across = float(np.linalg.norm(outline[:, None] - outline[None], axis=-1).max())
    for other in world.scene.objects:
        if other.name == obj.name or obj.placement.on == other.name:
            continue
        upright = other.model.container and is_upright(other)
        if not upright or not reachable(world.mount, other.pose.position):
            continue
        hollow = world.openings[other.name]
        if hollow is not None and across + ROOM <= 2 * float(hollow.semi.min()):
            yield other


def into(world: World, obj: Object, container: Object) -> Into:
    """Return the goal of placing ``obj`` into ``container``.

    Raises:
        InputError: the container has no hollow, or is the object itself.
    """
    hollow = world.openings[container.name]
    if hollow is None or container.name == obj.name:
        raise InputError(
            f"{obj.name!r} cannot be put into {container.name!r}, which is not a container for it."
        )
    return Into(obj.name, container.name, hollow, resting_height(obj))


def on_spot(world: World, obj: Object, spot: Float[np.ndarray, "3"]) -> OnSpot:
    """Return the goal of placing ``obj`` on a spot."""
    return OnSpot(obj.name, spot, rest_height(world, obj.name))


def in_stead(world: World, obj: Object, other: Object) -> OnSpot:
    """Return the goal of placing ``obj`` at the current position of ``other``."""
    spot = np.array([*other.pose.position[:2], world.scene.table.height])
    return OnSpot(obj.name, spot, rest_height(world, obj.name), other.name)


def given_object(world: World, goal: Choice, use: str, wanted: str) -> str | None:
    """Return the object that a goal option names, or None if the option is not set.

    ``use`` completes the error for unknown objects ("to put objects on"), ``wanted`` the one for
    other values ("The goal of Stack must be the name of an object").

    Raises:
        InputError: the option is a spot or a point, or the object does not exist.
    """
    if goal is not None and target_of(goal) is None:
        raise InputError(f"{wanted}, got {goal!r}.")
    return None if goal is None else check_known(world, str(goal), use)


def target_of(goal: Choice) -> str | None:
    """Return the object that a goal option names, or None for a spot, a point or no option."""
    return goal if isinstance(goal, str) and goal != SPOT else None


def on_table(obj: Object) -> bool:
    """Return whether an object stands directly on the table."""
    return obj.placement.on == TABLE
