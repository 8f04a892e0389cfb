"""Worlds of shipped tables, and batches of them compared with MuJoCo."""

from functools import cache

import mujoco
import numpy as np
import pytest
from jaxtyping import Float
from shipped_bundles import BUNDLES

from generator.bundle import load
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.world.world import World

COMPILING = 900  # seconds that the kernels may take, on a busy machine
REASON = "MuJoCo Warp is not installed: pip install 'tabletopgen[gpu]'"


def need_warp() -> None:
    """Skip the module if the extra is missing."""
    pytest.importorskip("mujoco_warp", reason=REASON)


@cache
def shipped(*names: str) -> tuple[World, ...]:
    """Return the worlds of shipped tables with these names, or of all; read-only."""
    return tuple(World(load(BUNDLES[name]), Panda()) for name in names or BUNDLES)


def awake(world: World) -> World:
    """Return a copy of a world at its start, without sleeping bodies."""
    twin = world.twin()
    twin.model.opt.enableflags &= ~int(mujoco.mjtEnableBit.mjENBL_SLEEP)
    return twin


def turn(one: Float[np.ndarray, "3 3"], other: Float[np.ndarray, "3 3"]) -> float:
    """Return the angle between two rotations, degrees, accurate for small angles."""
    between = one.astype(float).T @ other
    axis = [
        between[2, 1] - between[1, 2],
        between[0, 2] - between[2, 0],
        between[1, 0] - between[0, 1],
    ]
    return float(np.degrees(np.arctan2(np.linalg.norm(axis), np.trace(between) - 1)))
