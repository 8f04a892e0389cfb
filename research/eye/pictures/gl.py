"""Rendering with MuJoCo's OpenGL renderer: pictures, ids, depth and whole silhouettes."""

from __future__ import annotations

import importlib
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from jaxtyping import Bool, Float, Int, UInt8

from generator.errors import BackendError
from generator.geometry import Camera

from .pool import BACKDROP, Stock

NEAR, FAR = 0.04, 40.0
"""Near and far clipping distances, metres."""

_CAPACITY = 400  # maximum number of objects
_NO_GL = (
    "Training renders need OpenGL, which is not available ({reason}). On Debian or Ubuntu install "
    "'libegl1 libgl1 libgl1-mesa-dri' (EGL) or 'libosmesa6' (MUJOCO_GL=osmesa)."
)


@dataclass(frozen=True, eq=False)
class PlacedMesh:
    """A mesh of the stock with a transform: ``linear @ mesh + position``.

    ``linear`` combines rotation and size, metres. ``texture`` is an index of the stock's textures.
    ``glow`` is the emissive share of its colour.
    """

    mesh: int
    linear: Float[np.ndarray, "3 3"]
    position: Float[np.ndarray, "3"]
    texture: int
    color: tuple[float, float, float, float] = (1.0, 1.0, 1.0, 1.0)
    specular: float = 0.1
    shininess: float = 0.3
    glow: float = 0.0


@dataclass(frozen=True, eq=False)
class Lamp:
    """A directional light along ``direction``, ``spread`` radians wide (soft shadows)."""

    direction: Float[np.ndarray, "3"]
    diffuse: tuple[float, float, float]
    ambient: float = 0.0
    specular: float = 0.3
    shadow: bool = True
    spread: float = 0.0


class GlPainter:
    """A GL context with one stock. Free it with ``close``.

    Raises:
        BackendError: there is no OpenGL; the message says what to install.
    """

    def __init__(self, stock: Stock, side: int) -> None:
        import mujoco

        self.stock, self.side = stock, side
        self._gl = _context(side)
        model = stock.model
        model.vis.global_.offheight = model.vis.global_.offwidth = side
        model.vis.quality.offsamples = 0
        model.vis.quality.shadowsize = 1024
        model.stat.extent, model.vis.map.shadowclip = 1.0, 1.8
        self._context = mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100.value)
        self._context.readDepthMap = mujoco.mjtDepthMap.mjDEPTH_ZEROFAR.value
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN.value, self._context)
        self._scene = mujoco.MjvScene(model, maxgeom=_CAPACITY)
        self._scene.enabletransform = 0
        self._rect = mujoco.MjrRect(0, 0, side, side)

    def close(self) -> None:
        """Free meshes, textures and the context."""
        if self._gl is not None:
            self._gl.make_current()
            self._context.free()
            self._gl.free()
            self._gl = None

    def hang(self, picture: UInt8[np.ndarray, "s s 3"]) -> None:
        """Replace the backdrop's texture; ``picture`` has ``BACKDROP`` pixels per side."""
        import mujoco

        model, number = self.stock.model, self.stock.backdrop
        start = int(model.tex_adr[number])
        model.tex_data[start : start + 3 * BACKDROP**2] = picture.reshape(-1)
        mujoco.mjr_uploadTexture(model, self._context, number)

    def picture(
        self,
        things: Sequence[PlacedMesh],
        camera: Camera,
        lamps: Sequence[Lamp],
        rng: np.random.Generator,
        passes: int = 3,
    ) -> Float[np.ndarray, "h w 3"]:
        """Return a picture in [0, 255]: the mean of ``passes`` with shifted pixels and lamps."""
        import mujoco

        self._load(things)
        self._flags(shadow=True)
        total = np.zeros((self.side, self.side, 3), np.float32)
        buffer = np.empty((self.side, self.side, 3), np.uint8)
        for k in range(passes):
            shift = (np.array([k + 0.5, (k * 0.6180339 + 0.25) % 1 * passes]) / passes) - 0.5
            self._aim(camera, shift)
            self._light(lamps, k, rng if passes > 1 else None)
            mujoco.mjr_render(self._rect, self._scene, self._context)
            mujoco.mjr_readPixels(buffer, None, self._rect, self._context)
            total += buffer
        return total[::-1] / passes

    def ids(
        self, things: Sequence[PlacedMesh], camera: Camera
    ) -> tuple[Int[np.ndarray, "h w"], Float[np.ndarray, "h w"]]:
        """Return the index of the object in each pixel (-1 none) and its depth, metres."""
        self._load(things)
        return self._segment(camera)

    def silhouettes(
        self,
        things: Sequence[PlacedMesh],
        boxes: Float[np.ndarray, "n 4"],
        camera: Camera,
    ) -> Bool[np.ndarray, "n h w"]:
        """Return each object's whole mask, including hidden parts.

        ``boxes`` are pixel boxes that contain the objects; objects with disjoint boxes are drawn
        together.
        """
        full = np.zeros((len(things), self.side, self.side), bool)
        left = list(range(len(things)))
        while left:
            group: list[int] = []
            for k in left:
                if all(_apart(boxes[k], boxes[j]) for j in group):
                    group.append(k)
            left = [k for k in left if k not in group]
            self._load([things[k] for k in group])
            seen, _ = self._segment(camera)
            for place, k in enumerate(group):
                full[k] = seen == place
        return full

    def _segment(self, camera: Camera) -> tuple[Int[np.ndarray, "h w"], Float[np.ndarray, "h w"]]:
        import mujoco

        self._flags(segment=True)
        self._aim(camera, np.zeros(2))
        self._scene.nlight = 0
        color = np.empty((self.side, self.side, 3), np.uint8)
        near = np.empty((self.side, self.side), np.float32)
        mujoco.mjr_render(self._rect, self._scene, self._context)
        mujoco.mjr_readPixels(color, near, self._rect, self._context)
        code = color[::-1].astype(np.int32)
        z = near[::-1].astype(np.float64)
        depth = NEAR * FAR / (NEAR + z * (FAR - NEAR))
        ids = code[..., 0] + 256 * code[..., 1] - 1
        return ids, np.where(z <= 0, np.inf, depth).astype(np.float32)

    def _flags(self, shadow: bool = False, segment: bool = False) -> None:
        import mujoco

        flag = mujoco.mjtRndFlag
        self._scene.flags[:] = 0
        self._scene.flags[flag.mjRND_SHADOW] = shadow
        self._scene.flags[flag.mjRND_SEGMENT] = segment
        self._scene.flags[flag.mjRND_IDCOLOR] = segment

    def _load(self, things: Sequence[PlacedMesh]) -> None:
        import mujoco

        nothing, one = np.zeros(9), np.ones(4, np.float32)
        mesh, owner = mujoco.mjtGeom.mjGEOM_MESH.value, mujoco.mjtObj.mjOBJ_GEOM.value
        for k, thing in enumerate(things):
            geom = self._scene.geoms[k]
            mujoco.mjv_initGeom(geom, mesh, np.ones(3), np.zeros(3), nothing, one)
            rotation, shift = self.stock.frames[thing.mesh]
            geom.mat = thing.linear @ rotation
            geom.pos = thing.position + thing.linear @ shift
            geom.dataid, geom.matid, geom.texid = 2 * thing.mesh, thing.texture, thing.texture
            geom.texcoord, geom.segid, geom.objtype = 1, k, owner
            geom.rgba = thing.color
            geom.transparent = int(thing.color[3] < 1)
            geom.specular, geom.shininess = thing.specular, thing.shininess
            geom.emission = thing.glow
        self._scene.ngeom = len(things)

    def _aim(self, camera: Camera, shift: Float[np.ndarray, "2"]) -> None:
        pixel = NEAR / camera.focal
        half = NEAR * np.tan(camera.fov / 2)
        for eye in self._scene.camera:
            eye.pos, eye.forward, eye.up = (
                camera.position,
                camera.rotation[2],
                -camera.rotation[1],
            )
            eye.frustum_near, eye.frustum_far = NEAR, FAR
            eye.frustum_width, eye.orthographic = half, 0
            eye.frustum_center = shift[0] * pixel
            eye.frustum_bottom = -half + shift[1] * pixel
            eye.frustum_top = half + shift[1] * pixel

    def _light(self, lamps: Sequence[Lamp], turn: int, rng: np.random.Generator | None) -> None:
        """Set the lamps; those with shadows cast them in turn, one per pass."""
        import mujoco

        able = [k for k, lamp in enumerate(lamps) if lamp.shadow]
        casting = able[turn % len(able)] if able else -1
        for k, lamp in enumerate(lamps):
            light = self._scene.lights[k]
            way = lamp.direction / np.linalg.norm(lamp.direction)
            if rng is not None and lamp.spread > 0:
                way = way + rng.normal(0, lamp.spread, 3)
                way /= np.linalg.norm(way)
            light.type = mujoco.mjtLightType.mjLIGHT_DIRECTIONAL.value
            light.pos, light.dir = -4.0 * way + [0, 0, 0.6], way
            light.diffuse, light.ambient = lamp.diffuse, [lamp.ambient] * 3
            light.specular = [lamp.specular] * 3
            light.castshadow, light.headlight, light.texid = int(k == casting), 0, -1
            light.attenuation, light.cutoff, light.exponent = [1, 0, 0], 60, 1
        self._scene.nlight = len(lamps)


def _apart(a: Float[np.ndarray, "4"], b: Float[np.ndarray, "4"]) -> bool:
    return bool(a[2] < b[0] or b[2] < a[0] or a[3] < b[1] or b[3] < a[1])


def _context(side: int) -> Any:
    """Return a current GL context: of the kind in ``MUJOCO_GL``, else EGL, else OSMesa."""
    import os

    named = os.environ.get("MUJOCO_GL")
    kinds = ("mujoco.gl_context",) if named else ("mujoco.egl", "mujoco.osmesa")
    failures = []
    for kind in kinds:
        try:
            context = importlib.import_module(kind).GLContext(side, side)
            context.make_current()
            return context
        except Exception as error:  # each GL binding raises different errors
            failures.append(f"{kind}: {type(error).__name__}: {error}")
    raise BackendError(_NO_GL.format(reason="; ".join(failures)))
