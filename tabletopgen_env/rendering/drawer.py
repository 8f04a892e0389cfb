"""Pictures of a world, rendered with OpenGL if available, and otherwise in software.

MuJoCo draws through OpenGL, which needs a display, EGL or OSMesa. Without any of them,
``renderer="auto"`` uses this project's software renderer (slower and plainer, with the same
cameras), and ``renderer="gl"`` raises an error that names the packages to install. A process forked
after GL was used cannot use GL itself, because a fork does not copy the driver's threads: there,
"auto" draws in software with a warning, and "gl" raises an error.

There are two profiles: "fast", for learning, omits shadows, reflections and antialiasing; "full" is
for people.
"""

from __future__ import annotations

import atexit
import importlib
import os
import threading
import warnings
import weakref
from collections.abc import Collection, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any

import numpy as np
from jaxtyping import Float, Int, Shaped, UInt8

from generator.errors import BackendError, InputError, choices

from .kinds import RENDERERS, Drawer, Kind, Profile
from .window import has_display

if TYPE_CHECKING:
    import mujoco

    from ..world.world import World


@dataclass
class _GlUse:
    """The process that first used OpenGL, and a lock held while OpenGL is initialised."""

    # GL bindings initialise themselves on first use; allow one thread at a time.
    lock: threading.Lock = field(default_factory=threading.Lock)
    process: int | None = None  # process that used GL first: this one, or one it was forked from

    def is_forked(self) -> bool:
        """Return whether this process was forked after GL was used."""
        return self.process not in (None, os.getpid())


_GL_USE = _GlUse()
_KEPT = 4  # worlds whose meshes and textures stay in graphics memory
_STACKS = 6  # face rings of round shapes; MuJoCo's 16 take a sixth of a small picture's time
_NO_GL = (
    "OpenGL is not available for rendering ({reason}). On Debian or Ubuntu install "
    "'libegl1 libgl1 libgl1-mesa-dri' (EGL) or 'libosmesa6' (MUJOCO_GL=osmesa), "
    "or pass renderer='software'."
)
_FORKED = (
    "OpenGL cannot be used in this process: it was forked from a process that used it. Use the "
    "multiprocessing start method 'spawn' or 'forkserver' (vector_kwargs={'context': 'spawn'} of "
    "gymnasium.make_vec), or pass renderer='software'."
)


def drawer(choice: str, height: int, width: int, profile: Profile = "fast") -> Drawer:
    """Return a renderer for pictures of ``height`` x ``width`` pixels.

    "auto" means GL if available, else software, with a warning if GL is unavailable because of a
    fork. The software renderer draws shadows in the profile "full".

    Raises:
        InputError: the choice is unknown.
        BackendError: "gl" is required, but OpenGL is not available, or not after a fork.
    """
    if choice not in RENDERERS:
        raise InputError(f"Unknown renderer {choice!r}." + choices(str(choice), RENDERERS))
    if choice == "auto" and _GL_USE.is_forked():
        warnings.warn(f"{_FORKED} Pictures are drawn in software.", RuntimeWarning, stacklevel=2)
    elif choice != "software":
        try:
            return GlDrawer(height, width, profile)
        except BackendError:
            if choice == "gl":
                raise
    from .software import SoftwareDrawer

    return SoftwareDrawer(height, width, profile)


class GlDrawer(Drawer):
    """MuJoCo's OpenGL renderer, with one GL context and the meshes of a few worlds.

    A copy in a forked process neither draws nor frees resources.
    """

    def __init__(self, height: int, width: int, profile: Profile) -> None:
        self._size, self._profile = (height, width), profile
        self._gl = _gl_context(width, height)
        self._process = os.getpid()
        self._at_exit = partial(_close, weakref.ref(self))
        atexit.register(self._at_exit)  # GL contexts must be freed before interpreter shutdown
        # By world id; the most recently used is last.
        self._held: dict[int, tuple[World, mujoco.MjrContext, mujoco.MjvScene]] = {}

    def draw(
        self, world: World, camera: str, kinds: Collection[Kind]
    ) -> dict[Kind, Shaped[np.ndarray, "h w *_c"]]:
        """Return the requested pictures: colours in one pass, depth and segmentation in another."""
        import mujoco

        context, scene, rect = self._prepare(world, camera)
        drawn: dict[Kind, Shaped[np.ndarray, "h w *_c"]] = {}
        picture = np.empty((*self._size, 3), np.uint8)
        if "rgb" in kinds:
            mujoco.mjr_render(rect, scene, context)
            mujoco.mjr_readPixels(picture, None, rect, context)
            drawn["rgb"] = np.flipud(picture).copy()
        if "depth" in kinds or "segmentation" in kinds:
            depth = np.empty(self._size, np.float32)
            with _ids_for_colors(scene):
                mujoco.mjr_render(rect, scene, context)
            mujoco.mjr_readPixels(picture, depth, rect, context)
            drawn["depth"] = np.flipud(_metres(world.model, depth))
            drawn["segmentation"] = np.flipud(_geoms(scene, picture))
        return {kind: drawn[kind] for kind in kinds}

    def forget(self, world: World) -> None:
        """Free the meshes and textures of ``world``."""
        if self._process != os.getpid():
            return
        held = self._held.pop(id(world), None)
        if held is not None and self._gl is not None:
            self._gl.make_current()
            held[1].free()

    def close(self) -> None:
        """Free meshes, textures and the GL context."""
        if self._process != os.getpid():
            return
        try:
            for world, _, _ in list(self._held.values()):
                self.forget(world)
        finally:
            if self._gl is not None:
                self._gl.free()
                self._gl = None
                atexit.unregister(self._at_exit)

    def _prepare(
        self, world: World, camera: str
    ) -> tuple[mujoco.MjrContext, mujoco.MjvScene, mujoco.MjrRect]:
        """Make the world's context current and update its scene."""
        import mujoco

        if self._gl is None:
            raise InputError("This environment is closed; create a new one to render.")
        if self._process != os.getpid():
            raise BackendError(_FORKED)
        self._gl.make_current()
        context, scene = self._hold(world)
        mujoco.mjr_setBuffer(mujoco.mjtFramebuffer.mjFB_OFFSCREEN.value, context)
        view, option = mujoco.MjvCamera(), mujoco.MjvOption()
        view.type = mujoco.mjtCamera.mjCAMERA_FIXED
        view.fixedcamid = world.model.camera(camera).id
        everything = mujoco.mjtCatBit.mjCAT_ALL.value
        mujoco.mjv_updateScene(world.model, world.data, option, None, view, everything, scene)
        return context, scene, mujoco.MjrRect(0, 0, self._size[1], self._size[0])

    def _hold(self, world: World) -> tuple[mujoco.MjrContext, mujoco.MjvScene]:
        """Return the context and scene of ``world``, creating them on first use."""
        import mujoco

        if id(world) not in self._held:
            while len(self._held) >= _KEPT:
                self.forget(next(iter(self._held.values()))[0])
            model, fast = world.model, self._profile == "fast"
            model.vis.global_.offheight, model.vis.global_.offwidth = self._size
            model.vis.quality.offsamples = 0 if fast else 4
            model.vis.quality.numstacks = _STACKS
            context = mujoco.MjrContext(model, mujoco.mjtFontScale.mjFONTSCALE_100.value)
            context.readDepthMap = mujoco.mjtDepthMap.mjDEPTH_ZEROFAR.value
            scene = mujoco.MjvScene(model, maxgeom=2000)
            for flag in ("SHADOW", "REFLECTION", "HAZE"):
                if fast:
                    scene.flags[getattr(mujoco.mjtRndFlag, f"mjRND_{flag}")] = 0
            scene.flags[int(mujoco.mjtRndFlag.mjRND_FOG)] = 1  # the floor fades into haze
            self._held[id(world)] = (world, context, scene)
        held = self._held.pop(id(world))
        self._held[id(world)] = held  # the most recently used is last
        return held[1:]


@contextmanager
def _ids_for_colors(scene: mujoco.MjvScene) -> Iterator[None]:
    """Draw geoms unshaded, in colours that encode their numbers in the scene."""
    import mujoco

    rnd = mujoco.mjtRndFlag
    flags = [int(rnd.mjRND_SEGMENT), int(rnd.mjRND_IDCOLOR)]
    scene.flags[flags] = 1
    try:
        yield
    finally:
        scene.flags[flags] = 0


def _metres(model: mujoco.MjModel, buffer: Float[np.ndarray, "h w"]) -> Float[np.ndarray, "h w"]:
    """Return a depth buffer in metres, with inf for the background."""
    extent, planes = model.stat.extent, model.vis.map
    near, far = planes.znear * extent, planes.zfar * extent
    z = buffer.astype(np.float64)
    distance = near * far / (near + z * (far - near))  # reversed depth: 1 is near, 0 is far
    return np.where(z <= 0, np.inf, distance).astype(np.float32)


def _geoms(scene: mujoco.MjvScene, picture: UInt8[np.ndarray, "h w 3"]) -> Int[np.ndarray, "h w"]:
    """Return the geom encoded in each pixel's colour, or -1 for the background."""
    import mujoco

    geom = np.full(scene.ngeom + 1, -1, np.int32)
    for shown in scene.geoms[: scene.ngeom]:
        if shown.segid >= 0 and shown.objtype == mujoco.mjtObj.mjOBJ_GEOM:
            geom[shown.segid + 1] = shown.objid
    return geom[picture.astype(np.int32) @ (1, 1 << 8, 1 << 16)]


def _close(reference: weakref.ref[GlDrawer]) -> None:
    if (held := reference()) is not None:
        with suppress(Exception):  # its thread has ended; the process frees it on exit
            held.close()


def _gl_context(width: int, height: int) -> Any:
    """Return a GL context: the one named by ``MUJOCO_GL``, else the display's, EGL or OSMesa."""
    if _GL_USE.is_forked():
        raise BackendError(_FORKED)
    failures = []
    for module in _gl_modules():
        try:
            with _GL_USE.lock:
                context = importlib.import_module(module).GLContext(width, height)
                _GL_USE.process = os.getpid()
                return context
        except Exception as error:  # each GL binding raises different errors
            failures.append(f"{module}: {type(error).__name__}: {error}")
    raise BackendError(_NO_GL.format(reason="; ".join(failures)))


def _gl_modules() -> tuple[str, ...]:
    """Return the modules to try for a ``GLContext``, the best one first."""
    if os.environ.get("MUJOCO_GL") or has_display():
        return ("mujoco.gl_context",)
    return ("mujoco.egl", "mujoco.osmesa")
