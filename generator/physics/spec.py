"""Conversion of a scene to an ``MjSpec`` in memory, without files, and its compilation."""

from __future__ import annotations

import hashlib
import threading
from collections.abc import Collection, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from jaxtyping import Float, Int, UInt8

from ..errors import SceneError
from ..scene import Mesh, Object, Scene
from .mjcf import UV_DIGITS, VERTEX_DIGITS, Document, document

if TYPE_CHECKING:
    import mujoco


_LOG = "MUJOCO_LOG.TXT"  # MuJoCo's default log file, in the working directory
_LOG_LOCK = threading.Lock()
_LOG_WAIT = 5.0  # seconds; limits the wait in a process forked while a thread held the lock


def write_no_log() -> None:
    """Permanently stop this process from writing MuJoCo's log file to the working directory.

    Warnings still go to standard error and to the caller's handler. If the caller has named a log
    file, it stays in use. Unlike a warning handler, this function does not affect threads that
    simulate.
    """
    import mujoco

    if mujoco.MjLogConfig.get().logto_file:  # otherwise already done
        with _changing_log():
            config = mujoco.MjLogConfig.get()
            if config.logfile == _LOG:
                config.logto_file = False
                config.set()


@contextmanager
def no_console() -> Iterator[None]:
    """Temporarily stop MuJoCo from printing warnings; ``list_warnings`` returns relevant ones.

    Warnings of other threads are suppressed at the same time, too.
    """
    import mujoco

    with _changing_log():
        config = mujoco.MjLogConfig.get()
        printed, config.logto_console = config.logto_console, False
        config.set()
        try:
            yield
        finally:
            config.logto_console = printed
            config.set()


@contextmanager
def _changing_log() -> Iterator[None]:
    """Allow only one thread at a time to change MuJoCo's log, which the whole process shares."""
    held = _LOG_LOCK.acquire(timeout=_LOG_WAIT)
    try:
        yield
    finally:
        if held:
            _LOG_LOCK.release()


def new_data(model: mujoco.MjModel) -> mujoco.MjData:
    """Return new simulation data for a model, without a log file (see ``write_no_log``)."""
    import mujoco

    write_no_log()
    return mujoco.MjData(model)


def list_warnings(data: mujoco.MjData) -> tuple[str, ...]:
    """Return MuJoCo's warnings since ``data`` was made or reset, one message for each kind."""
    import mujoco

    raised = [(kind, data.warning[kind]) for kind in range(len(data.warning))]
    return tuple(mujoco.mju_warningText(k, w.lastinfo) for k, w in raised if w.number)


def unsimulatable(name: str, reason: str, when: str = "") -> SceneError:
    """Return the error to raise if MuJoCo cannot simulate a scene."""
    said = " ".join(reason.split())[:200]
    return SceneError(
        f"MuJoCo cannot simulate the scene {name!r}{when}: {said!r}. The bodies may overlap; make "
        "the scene again."
    )


def scene_spec(
    scene: Scene, *, visuals: bool = True, fixed: Sequence[Object] = ()
) -> mujoco.MjSpec:
    """Return the scene as an ``MjSpec`` that can be compiled or to which a robot can be attached.

    It compiles to the same model as the document with its files, except for the names of meshes and
    textures. These are passed directly, since encoding and decoding them would take most of the
    time. ``fixed`` objects are added before the scene's own, without joints.

    Raises:
        SceneError: MuJoCo cannot read it.
    """
    things = (*fixed, *scene.objects)
    meshes = [scene.table.model.mesh, *(o.model.mesh for o in things)] if visuals else []
    drawn = {mesh: _Drawn.of(mesh) for mesh in dict.fromkeys(meshes)}
    paths = {mesh: (held.shape, held.picture) for mesh, held in drawn.items()}
    spec = spec_of(document(scene, visuals=visuals, paths=paths, fixed=fixed), scene.name)
    _hand_over(spec, drawn.values())
    return spec


def spec_of(made: Document, name: str) -> mujoco.MjSpec:
    """Return the document of the scene ``name`` as an ``MjSpec``.

    Raises:
        SceneError: MuJoCo cannot read it.
    """
    import mujoco

    write_no_log()
    try:
        return mujoco.MjSpec.from_string(made.xml, assets=dict(made.files))
    except ValueError as error:
        raise _unbuildable(name, error) from error


def compile_spec(spec: mujoco.MjSpec, name: str) -> mujoco.MjModel:
    """Compile the specification of the scene ``name``.

    Raises:
        SceneError: MuJoCo rejects a body: a flat hull, or an impossible inertia.
    """
    write_no_log()
    try:
        return spec.compile()
    except ValueError as error:
        raise _unbuildable(name, error) from error


def _unbuildable(name: str, error: ValueError) -> SceneError:
    said = " ".join(str(error).split())
    return SceneError(
        f"MuJoCo cannot build the scene {name!r}: {said!r}. Create the scene again, or give the "
        "named body a valid shape and inertia."
    )


@dataclass(frozen=True, eq=False)
class _Drawn:
    """A mesh rounded to its stored precision, with file names for its shape and texture."""

    shape: str
    picture: str
    vertices: Float[np.ndarray, "n 3"]
    uv: Float[np.ndarray, "n 2"]
    faces: Int[np.ndarray, "m 3"]
    texture: UInt8[np.ndarray, "h w 3"]

    @classmethod
    def of(cls, mesh: Mesh) -> _Drawn:
        vertices, uv = _store(mesh.vertices, VERTEX_DIGITS), _store(mesh.uv, UV_DIGITS)
        shape, picture = _name(vertices, uv, mesh.faces), _name(mesh.texture)
        return cls(f"{shape}.obj", f"{picture}.png", vertices, uv, mesh.faces, mesh.texture)


def _store(numbers: Float[np.ndarray, "n d"], digits: int) -> Float[np.ndarray, "n d"]:
    return np.round(numbers.astype(np.float64), digits).astype(np.float32)


def _name(*arrays: np.ndarray) -> str:
    """Return a name derived from the content of arrays, so that equal content has equal names."""
    digest = hashlib.sha256()
    for array in arrays:
        digest.update(str(array.shape).encode() + array.tobytes())
    return digest.hexdigest()[:16]


def _hand_over(spec: mujoco.MjSpec, meshes: Collection[_Drawn]) -> None:
    """Embed the meshes and textures in a specification that refers to them by file name."""
    import mujoco

    shapes, pictures = {m.shape: m for m in meshes}, {m.picture: m for m in meshes}
    for named in (each for each in spec.meshes if each.file in shapes):
        mesh, named.file = shapes[named.file], ""
        named.uservert = mesh.vertices.ravel()
        uv = np.stack([mesh.uv[:, 0], 1 - mesh.uv[:, 1]], 1)  # as MuJoCo reads OBJ files
        named.usertexcoord = uv.ravel()
        named.userface = named.userfacetexcoord = mesh.faces.ravel()
    for named in (each for each in spec.textures if each.file in pictures):
        texture, named.file = pictures[named.file].texture, ""
        named.height, named.width, named.nchannel = texture.shape
        named.data = texture.tobytes()
        named.colorspace = mujoco.mjtColorSpace.mjCOLORSPACE_LINEAR  # as MuJoCo reads PNG files
