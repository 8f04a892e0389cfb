"""Lights, cameras and colours: ``draw_…`` samples and ``apply_…`` sets them in the model."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float
from scipy.spatial.transform import Rotation

from generator.scene import TABLE

from ..rendering.views import CAMERAS
from ..world.room import exposure

if TYPE_CHECKING:
    from ..world.world import World
    from .settings import Randomization


def draw_lights(settings: Randomization, world: World, rng: np.random.Generator) -> dict[str, Any]:
    """Draw the suns' rotation, and factors for their colour and for the ambient light."""
    del world
    turn, color, share = rng.uniform(-1, 1, 3), rng.uniform(-1, 1, 3), rng.random()
    low, high = settings.ambient
    return {
        "turn": (settings.light_turn * turn).tolist(),
        "color": (1 + settings.light_color * color).tolist(),
        "ambient": low + (high - low) * share,
    }


def apply_lights(world: World, drawn: dict[str, Any]) -> None:
    """Rotate and tint the suns, scale the ambient light, and then adapt the exposure."""
    model, head = world.model, world.model.vis.headlight
    model.light_dir[:] = Rotation.from_rotvec(drawn["turn"]).apply(model.light_dir)
    model.light_diffuse[:] *= drawn["color"]
    head.ambient[:] *= drawn["ambient"]
    head.diffuse[:] *= drawn["ambient"]
    factor = exposure(model.light_diffuse, head.ambient, head.diffuse)
    for light in (model.light_diffuse, head.ambient, head.diffuse):
        light[:] *= factor


def draw_cameras(settings: Randomization, world: World, rng: np.random.Generator) -> dict[str, Any]:
    """Draw a displacement, a rotation and a field-of-view factor for each camera."""
    del world
    drawn = {}
    for name in CAMERAS:
        move, turn, view = np.split(rng.uniform(-1, 1, 7), [3, 6])
        drawn[name] = {
            "move": (settings.camera_move * move).tolist(),
            "turn": (settings.camera_turn * turn).tolist(),
            "fov": 1 + settings.camera_fov * float(view[0]),
        }
    return drawn


def apply_cameras(world: World, drawn: dict[str, Any]) -> None:
    """Move cameras in their parent body's frame, and rotate them in their own frames."""
    for name, change in drawn.items():
        camera = world.model.camera(CAMERAS[name])
        camera.pos[:] += change["move"]
        camera.quat[:] = _turn(camera.quat, np.array(change["turn"]))
        camera.fovy[:] *= change["fov"]


def _turn(
    quaternion: Float[np.ndarray, "4"], turn: Float[np.ndarray, "3"]
) -> Float[np.ndarray, "4"]:
    """Rotate a wxyz quaternion in its local frame by a rotation vector."""
    old = Rotation.from_quat(np.roll(quaternion, -1))
    return np.roll((old * Rotation.from_rotvec(turn)).as_quat(), 1)


def draw_colors(settings: Randomization, world: World, rng: np.random.Generator) -> dict[str, Any]:
    """Draw the red, green and blue factors of each object and of the table.

    Objects with a common material share the factors of the first one.
    """
    tints = (1 - settings.tint * rng.random((len(world.names) + 1, 3))).tolist()
    seen: dict[int, Any] = {}
    for name, tint in zip((*world.names, TABLE), tints, strict=True):
        for material in _materials(world, name):
            seen.setdefault(material, tint)
    given = {name: [seen[k] for k in _materials(world, name)][:1] for name in world.names}
    return {
        "objects": {name: tints[0] for name, tints in given.items() if tints},
        "table": next((seen[k] for k in _materials(world, TABLE)), [1.0, 1.0, 1.0]),
    }


def apply_colors(world: World, drawn: dict[str, Any]) -> None:
    """Tint the materials of objects and the table."""
    tints = {**drawn["objects"], TABLE: drawn["table"]}
    by_material = {k: tint for name, tint in tints.items() for k in _materials(world, name)}
    for material, tint in by_material.items():
        world.model.mat_rgba[material, :3] *= tint


def _materials(world: World, body: str) -> list[int]:
    """Return the materials of a body's geoms."""
    model = world.model
    of_body = model.geom_matid[model.geom_bodyid == model.body(body).id]
    return np.unique(of_body[of_body >= 0]).tolist()
