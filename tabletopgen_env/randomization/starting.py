"""Starts that are a little off: the arm's joints, and the things that stand free."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from generator.geometry import inside_margin, quaternion_matrix, yaw_quaternion

if TYPE_CHECKING:
    from ..world import World
    from .settings import Randomization


def draw_start(
    settings: Randomization, names: Iterable[str], rng: np.random.Generator
) -> dict[str, Any]:
    """Draw by how much each joint is off, and the move (x, y) and turn of each of ``names``."""
    joints = rng.uniform(-settings.start_joints, settings.start_joints, 7).tolist()
    moved = {}
    for name in names:
        shift = rng.uniform(-settings.start_move, settings.start_move, 2).tolist()
        moved[name] = [*shift, float(rng.uniform(-settings.start_turn, settings.start_turn))]
    return {"joints": joints, "moved": moved}


def apply_start(world: World, drawn: Mapping[str, Any]) -> None:
    """Put the arm and the things at an episode's start off by what was drawn."""
    world.place_arm(world.data.qpos[world.arm_qpos] + np.asarray(drawn["joints"]))
    shift_things(world, drawn["moved"])


def shift_things(world: World, moved: Mapping[str, tuple[float, float, float]]) -> None:
    """Put things off by a move (x, y, metres) and a turn (radians) from where the scene has them.

    Marked spots stay where they are.
    """
    import mujoco

    for name, (x, y, turn) in moved.items():
        pose = world.scene.object(name).pose
        turned = np.empty(4)
        mujoco.mju_mulQuat(turned, yaw_quaternion(turn), np.asarray(pose.quaternion, float))
        world.teleport(name, pose.position + np.array([x, y, 0.0]), turned)
    mujoco.mj_forward(world.model, world.data)


def standing_free(world: World, settings: Randomization) -> Iterator[str]:
    """Yield the things on the table itself with nothing on them and room on all sides."""
    loaded = {o.placement.on for o in world.scene.objects}
    for obj in world.scene.objects:
        level = quaternion_matrix(obj.pose.quaternion)[2]
        if obj.placement.on != "table" or obj.name in loaded or np.abs(level).max() < 0.999:
            continue
        own = world.footprints[obj.name]
        radius = float(np.linalg.norm(own - obj.pose.position[:2], axis=1).max())
        room = 2 * (settings.start_move + settings.start_turn * radius)
        edge = inside_margin(own, world.scene.table.outline).min() > room
        others = (world.footprints[o] for o in world.names if o != obj.name)
        if edge and all(
            inside_margin(own, other).max() < -room
            and inside_margin(np.asarray(other), own).max() < -room
            for other in others
        ):
            yield obj.name
