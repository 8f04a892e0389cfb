"""What can be asked of a scene: which things can be moved, and where they can go."""

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
"""What the hollow of a container must be wider than what is put into it, however that is turned."""

NO_GRASP = "the arm reaches no grasp of it, or its neighbours leave no room for the hand"
"""Why what ``has_grasp`` denies cannot be moved."""

_TURNS = tuple(k * math.pi / 6 for k in range(-6, 6))

Reasons = dict[str, str | None]
"""Reasons why objects cannot be used; None for usable ones."""


def liftable(world: World) -> Reasons:
    """Return why each object cannot be picked up, None where it can; grasps are not planned."""
    return {
        o.name: world.ungraspable[o.name] or blocking_reason(world, o) for o in world.scene.objects
    }


def blocking_reason(world: World, obj: Object) -> str | None:
    """Return why the hand cannot come at an object, or move it alone; None if it can."""
    if not reachable(world.mount, obj.pose.position):
        return "out of the robot's reach"
    if (between := obstacle(world.scene, world.mount, obj.name)) is not None:
        return f"{between} stands in the arm's way"
    if obj.placement.inside:
        return f"it lies inside {obj.placement.on}, where fingers do not reach"
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
    """Return the episode that ``make`` gives for a drawn target, or for the one given.

    Args:
        world: the world, at its start.
        rng: draws the order in which targets are tried.
        target: the one asked for, which is tried whatever ``reasons`` says; None draws.
        reasons: why objects cannot be targets; what is found on the way is added.
        make: returns an object's episode, or None if there is none.
        lacks: the reason to report if there is none.
        held: whether the arm must reach a grasp of the target.

    Raises:
        SceneError: no object will do; says why for each.
        InputError: no such target.
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
    """Return ``name`` if the scene has such an object.

    Raises:
        InputError: there is no such object.
    """
    if name not in world.names:
        raise InputError(f"No object {name!r} {what}." + choices(str(name), world.names))
    return name


def nothing(world: World, reasons: Mapping[str, str | None]) -> SceneError:
    """Return the error of a scene that offers nothing to do."""
    listed = "; ".join(f"{name}: {why}" for name, why in reasons.items() if why)
    return SceneError(
        f"Scene {world.scene.name!r} offers nothing to move ({listed or 'no objects'}). "
        "Use other scenes, or choose with reset(options={'target': ..., 'goal': ...})."
    )


def rest_height(world: World, name: str) -> float:
    """Return how high an object's centre is above what it stands on, metres."""
    return float(world.position(name)[2]) - world.lowest(name)


def spot_of(
    world: World, obj: Object, goal: Choice, rng: np.random.Generator
) -> Float[np.ndarray, "3"] | None:
    """Return the spot on the table that ``goal`` gives, or a drawn free one, world frame.

    A drawn one is where the arm can put the object, held by its planned grasp.
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
    """Return whether the arm can put ``obj``, held by ``plan``, on a point, turned in some way."""
    center = np.array([*point, world.scene.table.height + rest_height(world, obj.name)])
    held = plan.grasp.point - world.position(obj.name)
    return any(
        stretch(world, (tool, tool + up(HOVER)), wrap(plan.yaw + turn)) is not None
        for turn in _TURNS
        for tool in (center + rotation_z(turn) @ held,)
    )


def coordinates(goal: object, count: int, wanted: str) -> Float[np.ndarray, "c"]:
    """Return ``count`` finite numbers that a user gave; ``wanted`` says what they are.

    Raises:
        InputError: the value is something else.
    """
    try:
        point = np.asarray(goal, float)
    except (TypeError, ValueError):
        point = np.empty(0)
    if point.shape != (count,) or not np.isfinite(point).all():
        raise InputError(f"{wanted}, got {goal!r}.")
    return point


def given_point(world: World, goal: Iterable[float]) -> Float[np.ndarray, "2"]:
    """Return a point of the table that a user gave.

    Raises:
        InputError: it is no pair of finite numbers, or not on the table.
    """
    xy = coordinates(goal, 2, "A goal spot is two finite numbers (x, y)")
    if inside_margin(xy, world.scene.table.outline)[0] < 0:
        raise InputError(f"The goal spot {xy.tolist()} is not on the table.")
    return xy


def containers(world: World, obj: Object) -> Iterator[Object]:
    """Yield what an object goes into: containers that stand free, upright and in reach."""
    outline = world.footprints[obj.name]  # however the hand turns it, it goes in lying as it does
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
    """Return the goal of ``obj`` in ``container``.

    Raises:
        InputError: it has no hollow, or is the object itself.
    """
    hollow = world.openings[container.name]
    if hollow is None or container.name == obj.name:
        raise InputError(f"{container.name!r} is no container to put {obj.name!r} into.")
    return Into(obj.name, container.name, hollow, resting_height(obj))


def on_spot(world: World, obj: Object, spot: Float[np.ndarray, "3"]) -> OnSpot:
    """Return the goal of ``obj`` standing on a spot."""
    return OnSpot(obj.name, spot, rest_height(world, obj.name))


def in_stead(world: World, obj: Object, other: Object) -> OnSpot:
    """Return the goal of ``obj`` standing where ``other`` stands now."""
    spot = np.array([*other.pose.position[:2], world.scene.table.height])
    return OnSpot(obj.name, spot, rest_height(world, obj.name), other.name)


def given_object(world: World, goal: Choice, use: str, wanted: str) -> str | None:
    """Return the object that a goal option names, None without one.

    ``use`` says what the object is for ("to put things on"), ``wanted`` names the task and what its
    option has to be ("Stack is an object's name").

    Raises:
        InputError: the option is a spot or a point, or the scene has no such object.
    """
    if goal is not None and target_of(goal) is None:
        raise InputError(f"The goal of {wanted}, got {goal!r}.")
    return None if goal is None else check_known(world, str(goal), use)


def target_of(goal: Choice) -> str | None:
    """Return the object that a goal option names, None for a spot, a point or nothing."""
    return goal if isinstance(goal, str) and goal != SPOT else None


def on_table(obj: Object) -> bool:
    """Return whether an object stands on the table itself."""
    return obj.placement.on == TABLE
