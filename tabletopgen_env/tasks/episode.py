"""What to move where: draws a target that can be grasped and a goal that can be reached."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from generator.errors import InputError, SceneError, choices
from generator.geometry import inside_margin
from generator.scene import Object

from ..affordance import Opening, is_upright, resting_height
from ..language import refer
from ..robot.mount import obstacle, reachable
from ..workspace import free_spot

if TYPE_CHECKING:
    from ..world import World

SPOT = "spot"
"""Name of the goal that is a marked free spot."""

ROOM = 0.008
"""What the hollow of a container must be wider than what is put into it, however that is turned."""


@dataclass(frozen=True, eq=False)
class Episode:
    """What one episode asks for.

    target: the object to move. container: the object to put it into, or None. spot: the marked
    point on the table in the world frame, or None. opening: the container's hollow. rest: height
    of the target's centre over what it stands on. start: the centre's height at the start (world).
    height: the target's height as it stands, metres.
    """

    target: str
    container: str | None
    spot: Float[np.ndarray, "3"] | None
    opening: Opening | None
    rest: float
    start: float
    height: float
    instruction: str

    @property
    def goal(self) -> str:
        """The container's name, or "spot"."""
        return self.container or SPOT


def draw_episode(
    world: World,
    rng: np.random.Generator,
    target: str | None = None,
    goal: str | tuple[float, float] | None = None,
) -> Episode:
    """Draw a target and a goal, or take those given.

    Args:
        world: the world, at its start.
        rng: draws.
        target: an object's name.
        goal: a container's name, "spot" for a drawn free spot, or a point (x, y) of the table
            in the world frame.

    Raises:
        SceneError: nothing can be grasped and put anywhere; says why for each object.
        InputError: what was asked for does not exist.
    """
    reasons = {o.name: _unfit(world, o) for o in world.scene.objects}
    fit = [name for name, reason in reasons.items() if reason is None]
    if target is not None:
        if target not in reasons:
            raise InputError(f"No object {target!r} to move." + choices(str(target), reasons))
        fit = [target]
    elif isinstance(goal, str) and goal != SPOT:
        container = world.scene.object(goal)
        fit = [n for n in fit if _fits(world, world.scene.object(n), container)]
    for k in rng.permutation(len(fit)):
        if target is None and not world.has_grasp(fit[k]):
            reasons[fit[k]] = "its neighbours leave no room for the hand"
            continue
        episode = _draw_goal(world, rng, world.scene.object(fit[k]), goal)
        if episode is not None:
            return episode
        reasons[fit[k]] = "no container that it fits and no free spot in reach"
    listed = "; ".join(f"{name}: {why}" for name, why in reasons.items() if why)
    raise SceneError(
        f"Scene {world.scene.name!r} offers nothing to move ({listed or 'no objects'}). "
        "Use other scenes, or choose with reset(options={'target': ..., 'goal': ...})."
    )


def _unfit(world: World, obj: Object) -> str | None:
    """Return why ``obj`` cannot be a target, or None."""
    if reason := world.ungraspable[obj.name]:
        return reason
    if not reachable(world.mount, obj.pose.position):
        return "out of the robot's reach"
    if (between := obstacle(world.scene, world.mount, obj.name)) is not None:
        return f"{between} stands in the arm's way"
    if obj.placement.inside:
        return f"it lies inside {obj.placement.on}, where fingers do not reach"
    loaded = [o.name for o in world.scene.objects if o.placement.on == obj.name]
    return f"{loaded[0]} stands on it" if loaded else None


def _draw_goal(
    world: World, rng: np.random.Generator, obj: Object, goal: str | tuple[float, float] | None
) -> Episode | None:
    """Return an episode that moves ``obj``, or None if there is nowhere to put it."""
    if isinstance(goal, str) and goal != SPOT:
        return _into(world, obj, world.scene.object(goal))
    if goal is not None and goal != SPOT:
        return _onto(world, obj, np.asarray(goal, float))
    fitting = [o for o in world.scene.objects if goal is None and _fits(world, obj, o)]
    if fitting and rng.random() < 0.5:
        return _into(world, obj, fitting[int(rng.integers(len(fitting)))])
    spot = free_spot(world, obj.name, rng)
    if spot is not None:
        return _onto(world, obj, spot)
    return _into(world, obj, fitting[0]) if fitting else None


def _fits(world: World, obj: Object, container: Object) -> bool:
    """Return whether ``obj`` goes into ``container``, which stands free, upright and in reach."""
    if container.name == obj.name or obj.placement.on == container.name:
        return False
    if not (container.model.container and is_upright(container)):
        return False
    if not reachable(world.mount, container.pose.position):
        return False
    hollow = world.openings[container.name]
    if hollow is None:
        return False
    outline = world.footprints[obj.name]  # however the hand turns it, it goes in lying as it does
    across = np.linalg.norm(outline[:, None] - outline[None], axis=-1).max()
    return bool(across + ROOM <= 2 * hollow.semi.min())


def _into(world: World, obj: Object, container: Object) -> Episode:
    hollow = world.openings[container.name]
    if hollow is None or container.name == obj.name:
        raise InputError(f"{container.name!r} is no container to put {obj.name!r} into.")
    text = f"put {refer(world.scene, obj)} into {refer(world.scene, container)}"
    return _episode(world, obj, text, container=container.name, hollow=hollow)


def _onto(world: World, obj: Object, xy: Float[np.ndarray, "2"]) -> Episode:
    table = world.scene.table
    if xy.shape != (2,) or not np.isfinite(xy).all():
        raise InputError(f"A goal spot is two finite numbers (x, y), got {xy.tolist()}.")
    if inside_margin(xy, table.outline)[0] < 0:
        raise InputError(f"The goal spot {xy.tolist()} is not on the table.")
    text = f"move {refer(world.scene, obj)} to the marked spot"
    return _episode(world, obj, text, spot=np.array([*xy, table.height]))


def _episode(
    world: World,
    obj: Object,
    instruction: str,
    container: str | None = None,
    spot: Float[np.ndarray, "3"] | None = None,
    hollow: Opening | None = None,
) -> Episode:
    start = float(world.position(obj.name)[2])
    rest = start - world.lowest(obj.name)
    height = resting_height(obj)
    return Episode(obj.name, container, spot, hollow, rest, start, height, instruction)
