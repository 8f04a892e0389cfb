"""Convex decomposition, by CoACD, of meshes without convex parts (Sec. 3.4).

X. Wei et al., "Approximate convex decomposition for 3D meshes with collision-aware concavity and
tree search", SIGGRAPH 2022. CoACD is a blocking C call, so it runs in a sandbox, on a mesh
simplified to about a thousand faces. Since results are cached by content, it runs only once per
mesh.

CoACD first cuts a mesh into pieces and then merges them. Merging takes most of the time, since a
rough mesh yields hundreds of pieces. Cuts are therefore tried at decreasing thresholds, and the
finest cut with a moderate number of pieces is merged. The result depends on the number of pieces,
never on a clock.

An import of many meshes has one ``CutBudget``, which limits the total number of pieces in all first
cuts. Meshes beyond the budget are rejected, and callers use their convex hulls instead.
"""

from __future__ import annotations

import contextlib
import hashlib
import tempfile
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import numpy as np
import platformdirs
from jaxtyping import Float

from ..errors import SceneError
from ..io.bounded import read_arrays
from ..sandbox import CpuBudget, SandboxError, SandboxLimits, call
from ..scene import ConvexPart, Mesh
from ..scene.triangles import Faces, Vertices, closed, pieces
from .inertia import weld

_MOST_FACES = 1200  # size to which meshes are simplified, since CoACD's time grows with it
_FULL = 1.001  # maximum ratio of a mesh's estimated volume to that of its hull
_MAX_KEPT = 16 * 2**20  # bytes of the hulls of a single mesh
_MOST_PIECES = 200  # number of pieces above which their boxes are not compared

Hulls = list[Float[np.ndarray, "_k 3"]]

_LIMITS = SandboxLimits(cpu_seconds=90.0, threads=1)  # enough for several rough meshes
_SETTINGS = {
    "max_convex_hull": 24, "preprocess_resolution": 30, "resolution": 300, "mcts_nodes": 5,
    "mcts_iterations": 20, "mcts_max_depth": 1, "decimate": True, "max_ch_vertex": 48, "seed": 0,
}  # fmt: skip
_THRESHOLDS = 0.15, 0.06  # thresholds of concavity, from coarse to fine
_MOST_CUTS = 48  # maximum number of pieces for which the next finer cut is tried


class CutBudget:
    """Limit on the total number of unmerged pieces in the convex decompositions of several meshes.

    A piece takes 0.05 to 0.15 s of CPU time. Solid objects yield 1 to 16 pieces, rough meshes about
    70. Meshes are decomposed as long as pieces are left, and a repeated mesh costs nothing, so the
    count is the same on all machines, with or without cached results. A mesh that fails counts as a
    rough one. All meshes together have the CPU time limit of a single mesh, which is several times
    what the pieces need. Meshes that reach it are rejected.
    """

    def __init__(self, pieces: int = 200) -> None:
        self.left = pieces
        self.cpu = CpuBudget(_LIMITS.cpu_seconds)
        self._hulls: dict[str, Hulls | SceneError] = {}

    def decompose(self, key: str, run: Callable[[], tuple[Hulls, int]]) -> Hulls:
        """Return the hulls of the mesh ``key``; ``run`` computes them and the number of pieces.

        Raises:
            SceneError: no pieces are left, or ``run`` failed.
        """
        if key not in self._hulls:
            if self.left <= 0 or not self.cpu.left:
                raise SceneError(
                    "The convex decomposition of earlier meshes used all convex parts that one "
                    "import allows. Add convex parts to the models, or import fewer models at a "
                    "time."
                )
            try:
                self._hulls[key], pieces = run()
                self.left -= pieces
            except SceneError as error:
                self._hulls[key] = error
                self.left -= _MOST_CUTS
        found = self._hulls[key]
        if isinstance(found, SceneError):
            raise found
        return found


def decompose(
    mesh: Mesh,
    scale: Float[np.ndarray, "3"],
    *,
    limits: SandboxLimits = _LIMITS,
    cache: Path | None = None,
    budget: CutBudget | None = None,
) -> tuple[ConvexPart, ...]:
    """Return convex parts, in the canonical frame, of a canonical mesh decomposed at ``scale``.

    Results are stored in ``cache`` (by default a folder in the user's cache) if it is writable.
    ``budget`` is shared by all meshes of an import.

    Raises:
        SceneError: CoACD failed or reached one of the ``limits``, or the budget is used up.
    """
    proportions = np.round(np.asarray(scale, float) / np.max(scale), 3).clip(1e-3)
    vertices, faces = weld(mesh)
    if not len(faces):
        raise SceneError("The mesh has only zero-area triangles. Add convex parts to the model.")
    digest = hashlib.sha256(repr((_SETTINGS, _THRESHOLDS, _MOST_CUTS)).encode())
    for array in (vertices, faces, proportions):
        digest.update(array.tobytes())
    cpu = None if budget is None else budget.cpu
    key = digest.hexdigest()[:24]
    kept = (cache or hulls_folder()) / f"{key}.npz"

    def run() -> tuple[Hulls, int]:
        known = _read(kept) if kept.is_file() else None
        if known is None:
            known = _coacd(vertices * proportions, faces, limits, cpu)
            _keep(kept, *known)
        return known

    hulls = run()[0] if budget is None else budget.decompose(key, run)
    return tuple(ConvexPart((hull / proportions).clip(-0.5, 0.5)) for hull in hulls)


def _coacd(
    vertices: Vertices, faces: Faces, limits: SandboxLimits, cpu: CpuBudget | None
) -> tuple[Hulls, int]:
    """Decompose a mesh by CoACD in a sandbox; return its hulls and its unmerged piece count."""
    if len(faces) > _MOST_FACES:
        import fast_simplification

        fewer = fast_simplification.simplify(
            vertices, faces.astype(np.int32), target_count=_MOST_FACES
        )
        vertices, faces = fewer[0].astype(np.float64), fewer[1].astype(np.int64)
    remesh = not closed(faces) or _overlaps(vertices, faces)
    try:
        hulls, pieces = call(run_coacd, vertices, faces, remesh, limits=limits, budget=cpu)
    except SandboxError as error:
        raise SceneError(
            f"Convex decomposition of {len(faces)} faces failed: it {error}. Add convex parts to "
            "the model, or use a simpler mesh."
        ) from error
    if not hulls:
        raise SceneError("Convex decomposition found no solid part. Add convex parts to the model.")
    return hulls, pieces


def run_coacd(vertices: Vertices, faces: Faces, remesh: bool) -> tuple[Hulls, int]:
    """Decompose a mesh in this process; return its hulls and the number of unmerged pieces.

    ``remesh`` rebuilds the surface first, which open and self-overlapping meshes need.
    """
    import coacd

    coacd.set_log_level("error")
    settings = {**_SETTINGS, "preprocess_mode": "on" if remesh else "off"}

    def run(threshold: float, merge: bool) -> Hulls:
        mesh = coacd.Mesh(vertices, faces)
        return [h for h, _ in coacd.run_coacd(mesh, threshold=threshold, merge=merge, **settings)]

    chosen, counts = _THRESHOLDS[0], list[int]()
    for threshold, finer in pairwise(_THRESHOLDS):
        counts.append(len(run(threshold, merge=False)))
        if counts[-1] > _MOST_CUTS:
            break
        chosen = finer
    return run(chosen, merge=True), counts[0]


def _overlaps(vertices: Vertices, faces: Faces) -> bool:
    """Return whether a closed mesh may overlap itself, judged by its volume and its pieces."""
    # CoACD does not terminate on such a mesh unless its surface is rebuilt first.
    from scipy.spatial import ConvexHull, QhullError

    if _pieces_meet(vertices, faces):
        return True
    a, b, c = vertices[faces].transpose(1, 0, 2)
    volume = abs(float(np.vecdot(a, np.cross(b, c)).sum())) / 6
    try:
        return volume > _FULL * ConvexHull(vertices).volume
    except QhullError:  # flat
        return False


def _pieces_meet(vertices: Vertices, faces: Faces) -> bool:
    """Return whether any two components' bounding boxes meet, or True if there are too many."""
    piece = pieces(faces, len(vertices))[faces[:, 0]]
    names, piece = np.unique(piece, return_inverse=True)
    if len(names) > _MOST_PIECES:
        return True
    corners = vertices[faces]
    low, high = np.full((2, len(names), 3), [[[np.inf]], [[-np.inf]]])
    np.minimum.at(low, piece, corners.min(1))
    np.maximum.at(high, piece, corners.max(1))
    meet = ((low[:, None] < high[None]) & (low[None] < high[:, None])).all(-1)
    return bool(meet.sum() > len(names))


def _read(path: Path) -> tuple[Hulls, int] | None:
    """Return the hulls and piece count in the file ``path``, or None if it is absent or invalid."""
    try:
        arrays = read_arrays(path, "The cached hulls", SceneError, max_bytes=_MAX_KEPT)
        pieces = int(arrays.pop("pieces"))
        hulls = [np.asarray(array, np.float64) for array in arrays.values()]
    except (SceneError, KeyError, ValueError, TypeError):
        return None
    sound = all(h.ndim == 2 and h.shape[1] == 3 and np.isfinite(h).all() for h in hulls)
    return (hulls, pieces) if hulls and sound and pieces > 0 else None


def _keep(path: Path, hulls: Hulls, pieces: int) -> None:
    """Store hulls for later use, if the cache is writable."""
    with contextlib.suppress(OSError):
        path.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.NamedTemporaryFile(dir=path.parent, suffix=".part", delete=False) as part:
            np.savez(part, *hulls, pieces=np.array(pieces))
        Path(part.name).replace(path)


def hulls_folder() -> Path:
    """Return the folder of cached decompositions on this machine."""
    return Path(platformdirs.user_cache_dir("tabletopgen")) / "hulls"
