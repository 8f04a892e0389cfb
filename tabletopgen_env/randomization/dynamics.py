"""Masses, friction, servo gains and table height: ``draw_…`` samples and ``apply_…`` sets them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float

from generator.scene import TABLE

from ..affordance import MAX_MASS
from ..robot.mount import PEDESTAL, Mount
from ..world.composition import FRONT_CAMERA, PREFIX, TOP_CAMERA

if TYPE_CHECKING:
    from ..world.world import World
    from .settings import Randomization, Range

_FINGERS = (PREFIX + "left_finger", PREFIX + "right_finger")
_BASE = PREFIX + "link0"


def _factors(span: Range, count: int, rng: np.random.Generator) -> Float[np.ndarray, "k"]:
    low, high = span
    return low + (high - low) * rng.random(count)


def draw_mass(settings: Randomization, world: World, rng: np.random.Generator) -> dict[str, Any]:
    """Draw a factor for each object's mass; carriable objects remain light enough to carry."""
    factors = _factors(settings.mass, len(world.names), rng)
    mass = world.model.body_mass[world.bodies]
    factors = np.where(mass <= MAX_MASS, np.minimum(factors, MAX_MASS / mass), factors)
    return dict(zip(world.names, factors.tolist(), strict=True))


def apply_mass(world: World, drawn: dict[str, Any]) -> None:
    """Scale masses and inertias; the caller updates MuJoCo's derived constants."""
    factors = np.array([drawn[name] for name in world.names])
    world.model.body_mass[world.bodies] *= factors
    world.model.body_inertia[world.bodies] *= factors[:, None]


def draw_friction(
    settings: Randomization, world: World, rng: np.random.Generator
) -> dict[str, Any]:
    """Draw factors for the friction of each object, the table and the fingers."""
    table, fingers, *objects = _factors(settings.friction, len(world.names) + 2, rng).tolist()
    objects = dict(zip(world.names, objects, strict=True))
    return {"objects": objects, "table": table, "fingers": fingers}


def apply_friction(world: World, drawn: dict[str, Any]) -> None:
    """Scale sliding friction."""
    model = world.model
    factors = {**drawn["objects"], TABLE: drawn["table"]}
    factors |= dict.fromkeys(_FINGERS, drawn["fingers"])
    for name, factor in factors.items():
        model.geom_friction[model.geom_bodyid == model.body(name).id, 0] *= factor


def draw_gains(settings: Randomization, world: World, rng: np.random.Generator) -> dict[str, Any]:
    """Draw factors for the stiffness and the damping of the arm's servos."""
    del world
    return {
        "stiffness": _factors(settings.stiffness, 7, rng).tolist(),
        "damping": _factors(settings.damping, 7, rng).tolist(),
    }


def apply_gains(world: World, drawn: dict[str, Any]) -> None:
    """Scale the servos' gains."""
    model, arm = world.model, world.actuators[:7]
    model.actuator_gainprm[arm, 0] *= drawn["stiffness"]
    model.actuator_biasprm[arm, 1] *= drawn["stiffness"]
    model.actuator_biasprm[arm, 2] *= drawn["damping"]


def draw_table(settings: Randomization, world: World, rng: np.random.Generator) -> dict[str, Any]:
    """Draw the change of the table's height in metres."""
    del world
    return {"height": settings.table_height * float(rng.uniform(-1, 1))}


def apply_table(world: World, drawn: dict[str, Any]) -> None:
    """Apply a change in table height by moving the robot, its pedestal and the fixed cameras."""
    model, down = world.model, np.array([0.0, 0.0, -drawn["height"]])
    model.body_pos[model.body(_BASE).id] += down
    for name in (FRONT_CAMERA, TOP_CAMERA):
        model.camera(name).pos[:] += down
    model.geom(f"{PEDESTAL}_plate").pos[:] += down
    column = model.geom(f"{PEDESTAL}_column")
    column.pos[:] += down / 2
    column.size[1] += down[2] / 2
    world.seat(Mount(world.mount.position + down, world.mount.yaw))
