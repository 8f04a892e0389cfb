"""The room around the table: floor, sky and lights, adjusted for a well-exposed picture.

A white table top in the sun is at four fifths of full brightness and the floor at about two fifths,
so that tables of any colour stand out. The sun shines from behind the front camera towards the
robot, so that the visible sides are lit and the arm's shadow falls away from the table. Behind
table and robot the floor fades into haze.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float

from generator.geometry import Camera, rotation_z
from generator.physics.mjcf import FLOOR
from generator.render.backdrop import Backdrop, Color
from generator.scene import Scene

from ..robot.mount import Mount

if TYPE_CHECKING:
    import mujoco

TILES: tuple[Color, Color] = ((0.47, 0.475, 0.485), (0.43, 0.435, 0.445))
"""Colours of the floor's tiles."""

TILE = 0.5
"""Side of a tile, in metres."""

HAZE: Color = (0.76, 0.78, 0.81)
"""Colour of the background, and of the floor far away."""

ZENITH: Color = (0.58, 0.65, 0.74)
"""Colour of the sky overhead where no haze is drawn, as in MuJoCo's viewer."""

FLOOR_HALF = 3.0
"""Half the side of the floor, in metres. In the front camera's view the floor ends in the haze; an
endless floor would take a third of the drawing time of a small picture."""

AMBIENT, HEADLIGHT, SUN = 0.38, 0.20, 0.46
"""Ambient light, headlight, and sunlight. A surface that faces the sun and the camera receives the
sum of all three, which slightly exceeds full brightness for white."""

BRIGHTEST = AMBIENT + HEADLIGHT + SUN
"""The maximum light that the exposure compensates; see ``exposure``."""

_SUNBEAM = (-0.40, -0.45, -1.0)  # direction of the sun, in the base frame
_SUN_AWAY = 1.6  # position of the sun: above the arm, metres
_FADE = (0.7, 2.2)  # distances behind the table's centre at which the haze begins and ends, metres
# Half the side of the area with shadows, metres. MuJoCo's shadow map is slightly skewed: surfaces
# beyond six tenths of this towards the sun are speckled if they cross the map's axes.
_SHADOWS_TO = 4.2
_SHADOW_PIXELS = 3072


def furnish(spec: mujoco.MjSpec, scene: Scene, mount: Mount, front: Camera) -> None:
    """Tile the floor of a specification, and add sky, haze and lights.

    ``front`` is the camera that views table and robot: the haze begins behind them.
    """
    middle = np.array([0.0, 0.0, scene.table.height])
    _paint(spec)
    _shine(spec, middle, rotation_z(mount.yaw) @ _SUNBEAM)
    spec.stat.center, spec.stat.extent = middle, 1.0  # units are extents: 1 metre
    sight, distance = spec.visual.map, float(front.to_camera(middle[None])[0, 2])
    sight.fogstart, sight.fogend = (distance + behind for behind in _FADE)
    sight.shadowclip, spec.visual.quality.shadowsize = _SHADOWS_TO, _SHADOW_PIXELS
    spec.visual.rgba.fog = spec.visual.rgba.haze = [*HAZE, 1.0]


def exposure(
    suns: Float[np.ndarray, "n 3"], ambient: Float[np.ndarray, "3"], head: Float[np.ndarray, "3"]
) -> float:
    """Return the factor, at most 1, that keeps white from being overexposed under these lights."""
    brightest = float((suns.sum(0) + ambient + head).max())
    return min(1.0, BRIGHTEST / max(brightest, 1e-9))


def backdrop(model: mujoco.MjModel) -> Backdrop:
    """Return the floor and haze of a furnished model for the software renderer."""
    sight, extent = model.vis.map, model.stat.extent
    fade = sight.fogstart * extent, sight.fogend * extent
    return Backdrop(TILES, TILE, FLOOR_HALF, HAZE, fade, model.geom(FLOOR).id)


def _paint(spec: mujoco.MjSpec) -> None:
    """Tile the floor, and add the sky."""
    import mujoco

    spec.add_texture(
        name=FLOOR,
        type=mujoco.mjtTexture.mjTEXTURE_2D,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_CHECKER,
        rgb1=TILES[1],
        rgb2=TILES[0],
        width=64,
        height=64,
    )
    repeat = 1 / TILE  # MuJoCo counts repeats on planes by half sides; two tiles each
    tiles = spec.add_material(
        name=FLOOR, texrepeat=[repeat, repeat], texuniform=True, specular=0, shininess=0
    )
    tiles.textures[mujoco.mjtTextureRole.mjTEXROLE_RGB] = FLOOR
    floor = spec.geom(FLOOR)
    floor.size = [FLOOR_HALF, FLOOR_HALF, 0.05]
    floor.material, floor.rgba = FLOOR, [1, 1, 1, 1]
    # MuJoCo's gradient continues below the horizon, which has the colour halfway.
    spec.add_texture(
        name="sky",
        type=mujoco.mjtTexture.mjTEXTURE_SKYBOX,
        builtin=mujoco.mjtBuiltin.mjBUILTIN_GRADIENT,
        rgb1=ZENITH,
        rgb2=2 * np.array(HAZE) - ZENITH,
        width=64,
        height=384,
    )


def _shine(
    spec: mujoco.MjSpec, middle: Float[np.ndarray, "3"], beam: Float[np.ndarray, "3"]
) -> None:
    """Set the ambient light, and aim the scene's sun."""
    head = spec.visual.headlight
    head.ambient, head.diffuse, head.specular = [AMBIENT] * 3, [HEADLIGHT] * 3, [0.0] * 3
    (sun,) = spec.lights
    beam = beam / np.linalg.norm(beam)
    sun.dir, sun.pos = beam, middle - _SUN_AWAY * beam
    sun.diffuse, sun.ambient, sun.specular = [SUN] * 3, [0.0] * 3, [0.12] * 3
