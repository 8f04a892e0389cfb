"""Possible errors at a table while an arm moves."""

from __future__ import annotations

from collections.abc import Mapping

import gymnasium as gym
import numpy as np

from generator.geometry import inside_margin
from tabletopgen_env.env import TabletopEnv
from tabletopgen_env.goals.goal import at_rest
from tabletopgen_env.world.world import World

ROOM = 20.0
"""Distance from the table's centre in metres beyond which an object has escaped."""


def look(env: gym.Env) -> dict[str, int]:
    """Count an environment's errors at the end of an episode, and the objects off its table."""
    inner = env.unwrapped
    assert isinstance(inner, TabletopEnv)
    world = inner.world
    state = np.concatenate([world.data.qpos, world.data.qvel])
    fell = world.off_table()
    return {
        "not_finite": int(not np.isfinite(state).all()),
        "warnings": int(sum(w.number for w in world.data.warning)),
        "unnoticed": len(beside(world) - {*fell}),
        "escaped": len(find_escaped(world)),
        "fell": len(fell),
    }


def count_rows(whole: Mapping[str, int]) -> list[str]:
    """Return the head of a table of counts, and a row for each kind of error."""
    return [
        "| what | count |",
        "|---|---|",
        f"| states, observations or rewards that are not finite | {whole['not_finite']} |",
        f"| MuJoCo warnings | {whole['warnings']} |",
        f"| observations outside their space | {whole['outside']} |",
        f"| objects off the table that `off_table` does not list | {whole['unnoticed']} |",
        f"| objects below the floor or outside the room | {whole['escaped']} |",
    ]


def beside(world: World) -> set[str]:
    """Return released objects at rest whose footprint is entirely off the table."""
    found = set()
    for obj in world.scene.objects:
        off = -inside_margin(world.position(obj.name)[:2], world.scene.table.outline)[0]
        clear = off > float(np.linalg.norm(obj.scale)) / 2
        if clear and at_rest(world, obj.name) and not world.touches(obj.name)[2]:
            found.add(obj.name)
    return found


def find_escaped(world: World) -> list[str]:
    """Return the objects that are below the floor or outside the room."""
    found = []
    for name in world.names:
        x, y, z = world.position(name)
        if not (abs(x) < ROOM and abs(y) < ROOM and -0.05 < z < ROOM):
            found.append(name)
    return found
