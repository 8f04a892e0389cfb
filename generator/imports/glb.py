"""Conversion of GLB files with whole scenes to bodies.

A body is a node with a mesh, including all nodes below it. The data that ``tabletopgen export --to
glb`` adds to glTF (``extras``, and the second scene "collision") is read back; nodes without it get
convex parts by decomposition, and the mass of the category that their name suggests.
"""

from __future__ import annotations

import io
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, cast

import numpy as np
import trimesh
from jaxtyping import Float

from ..errors import BackendError, InputError, choices
from ..io.bounded import is_number, printable, read_regular
from ..meshes.reading.bounds import MOST_BYTES, MOST_FACES
from ..meshes.reading.flat_glb import Crooked, Header, flatten, local_matrix, roots_of
from ..meshes.reading.inspection import open_glb
from ..meshes.reading.surface import surface_of
from ..meshes.reading.textures import Pictures
from ..physics.inertia import MassProperties
from ..scene import ConvexPart
from .foreign import ForeignBody, ForeignScene, Refusals, check_count
from .mjcf import TABLE_WORDS
from .shapes import part_of

_Z_UP = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]])  # from y up
_RIGID = 1e-3  # tolerance of a node's axes
_COLLISION = "collision"


def read_glb(path: Path, table: str | None = None) -> ForeignScene:
    """Read a GLB file that contains a whole scene, with y up and lengths in metres as in glTF.

    ``table`` is the name of the table's node; None chooses a node marked as fixed, or one whose
    name suggests a table.

    Raises:
        InputError: there are no bodies, no table, or a node without a rigid transform.
        BackendError: the file cannot be read; see ``meshes.reading``.
    """
    what = f"The scene {path.name!r}"
    raw = read_regular(path, f"{what}:", InputError, max_bytes=MOST_BYTES)
    raw, header = open_glb(raw, what)
    if not header.get("nodes"):
        header = {**header, "nodes": [{"mesh": k} for k in range(len(header["meshes"]))]}
    shown = header.get("scene", 0)
    places = _places(header, shown, what)
    shells, damaged = _collision_of(raw, header, shown, what)
    owners: dict[int, list[int]] = {}
    for k, place in enumerate(places):
        owners.setdefault(place.owner, []).append(k)
    free = [k for k in owners if _extras(header["nodes"][k]).get("fixed") is not True]
    check_count(len(free) - 1)  # one may be the table
    bodies: list[ForeignBody] = []
    fixed: dict[str, ForeignBody] = {}
    meshes, pictures = _load_each(raw, header, places, what), Pictures(what)
    refusals = Refusals()
    for owner, mine in owners.items():
        with refusals.catching(_name(header, owner)):
            body, is_fixed = _read_body(
                header, owner, [places[k] for k in mine], [meshes[k] for k in mine], shells, what,
                pictures,
            )  # fmt: skip
            if is_fixed or body.name == table:
                fixed[body.name] = body
            else:
                bodies.append(body)
    refusals.check_left([*bodies, *fixed])
    try:
        found = _arrange(path.stem, bodies, fixed, table, whole=not refusals.outcomes)
    except InputError as error:
        if refusals.first is None:
            raise
        raise InputError(
            f"{error} Refused: {'; '.join(map(str, refusals.outcomes[:5]))}"
        ) from error
    return replace(found, warnings=(*found.warnings, *damaged), refused=tuple(refusals.outcomes))


def _arrange(
    name: str,
    bodies: list[ForeignBody],
    fixed: dict[str, ForeignBody],
    table: str | None,
    whole: bool,
) -> ForeignScene:
    """Return a scene with one of its bodies as the table.

    ``whole`` means that no body was refused: a single body is then a scene without a table.
    """
    if table is not None and table not in fixed:
        raise InputError(
            f"There is no node named {table!r}." + choices(table, (b.name for b in bodies))
        )
    if whole and not fixed and len(bodies) == 1 and not TABLE_WORDS.search(bodies[0].name):
        return ForeignScene(name, None, (replace(bodies[0], name=name),))
    if not fixed:
        called = [body for body in bodies if TABLE_WORDS.search(body.name)]
        if len(called) != 1:
            raise InputError(
                f"The names of {len(called)} nodes suggest a table. Choose the table (--table)."
                + choices("table", (b.name for b in bodies))
            )
        bodies.remove(called[0])
        fixed[called[0].name] = called[0]
    chosen = table or next((n for n in fixed if TABLE_WORDS.search(n)), next(iter(fixed)))
    if not bodies:
        raise InputError("The scene has a table, but no free body that could stand on it.")
    others = sorted(fixed.keys() - {chosen})
    told = (f"fixed objects are ignored: {', '.join(others[:8])}",) if others else ()
    return ForeignScene(name, fixed[chosen], tuple(bodies), told)


@dataclass(frozen=True, eq=False)
class _Place:
    """A use of a mesh in a scene: its node, its body's node, and the world transforms of both."""

    node: int
    owner: int
    mesh: int
    matrix: Float[np.ndarray, "4 4"]
    owner_matrix: Float[np.ndarray, "4 4"]


def _places(header: Header, scene: int, what: str) -> Sequence[_Place]:
    """Return a scene's mesh nodes; bodies are marked nodes or, if none is marked, top mesh nodes.

    Raises:
        InputError: the nodes do not form a tree, or one of them is invalid.
    """
    try:
        return [*_walk(header, scene)]
    except (KeyError, IndexError, TypeError, ValueError, OverflowError) as error:
        raise InputError(f"{what} is damaged ({type(error).__name__}: {error}).") from error


def _walk(header: Header, scene: int) -> Iterator[_Place]:
    nodes: Sequence[Any] = header.get("nodes", ())
    roots = roots_of(header, scene)
    said = any("fixed" in _extras(node) or "body" in _extras(node) for node in nodes)
    waiting = [(int(k), np.eye(4), -1, np.eye(4)) for k in reversed(roots)]
    seen: set[int] = set()
    while waiting:
        k, above, owner, at = waiting.pop()
        if k in seen or not 0 <= k < len(nodes):
            raise Crooked(f"node {k} is missing or occurs more than once")
        seen.add(k)
        node = nodes[k]
        matrix = above @ local_matrix(node)
        starts = ("fixed" in _extras(node) or "body" in _extras(node)) if said else "mesh" in node
        if owner < 0 and starts:
            owner, at = k, matrix
        if "mesh" in node and owner >= 0:
            mesh = int(node["mesh"])
            if not 0 <= mesh < len(header.get("meshes", ())):
                raise Crooked(f"node {k} refers to a missing mesh")
            yield _Place(k, owner, mesh, matrix, at)
        waiting += [(int(c), matrix, owner, at) for c in reversed(node.get("children", ()))]


def _extras(node: object) -> Mapping[str, Any]:
    found = node.get("extras") if isinstance(node, Mapping) else None
    return found if isinstance(found, Mapping) else {}


def _load_each(
    raw: bytes, header: Header, places: Sequence[_Place], what: str
) -> list[list[trimesh.Trimesh] | BackendError]:
    """Return the meshes at each place, or an error for each place that cannot be read."""
    try:
        return [*_load(raw, header, places, what)]
    except BackendError as error:
        if len(places) == 1:
            return [error]
    found: list[list[trimesh.Trimesh] | BackendError] = []
    for place in places:
        try:
            found += _load(raw, header, [place], what)
        except BackendError as error:
            found.append(error)
    return found


def _load(
    raw: bytes, header: Header, places: Sequence[_Place], what: str
) -> list[list[trimesh.Trimesh]]:
    """Return the meshes at each place, in the frame of its node."""
    nodes = [{"mesh": place.mesh, "matrix": np.eye(4).ravel().tolist()} for place in places]
    scenes = [{"nodes": [*reversed(range(len(nodes)))]}]  # ``flatten`` takes the last first
    flat = {**header, "nodes": nodes, "scenes": scenes, "scene": 0}
    try:
        loaded = trimesh.load_scene(io.BytesIO(flatten(raw, flat)), file_type="glb", process=False)
    except MemoryError:  # handled by the sandbox
        raise
    except Exception as error:  # parsers raise many types of errors for malformed files
        raise BackendError(
            f"{what} cannot be read ({type(error).__name__}: {error}). Export it again."
        ) from error
    parents = loaded.graph.transforms.parents
    found: list[list[trimesh.Trimesh]] = [[] for _ in places]
    for name in loaded.graph.nodes_geometry:
        geometry = loaded.geometry[loaded.graph[name][1]]
        at = name
        while not (at.isdecimal() and int(at) < len(found)) and at in parents:
            at = parents[at]
        if at.isdecimal() and isinstance(geometry, trimesh.Trimesh) and len(geometry.faces):
            found[int(at)].append(geometry)
    return found


def _name(header: Header, owner: int) -> str:
    return str(header["nodes"][owner].get("name") or f"thing_{owner}")[:100]


def _read_body(
    header: Header,
    owner: int,
    places: Sequence[_Place],
    meshes: Sequence[Sequence[trimesh.Trimesh] | BackendError],
    shells: Mapping[str, tuple[ConvexPart, ...]],
    what: str,
    pictures: Pictures,
) -> tuple[ForeignBody, bool]:
    """Return the body of a node, and whether it is fixed."""
    node = header["nodes"][owner]
    name = printable(_name(header, owner), "A node's name", InputError)
    rotation, scale, position = _split(places[0].owner_matrix, name)
    placed = []
    for place, pieces in zip(places, meshes, strict=True):
        if isinstance(pieces, BackendError):
            raise pieces
        own = np.linalg.inv(places[0].owner_matrix) @ place.matrix
        for piece in pieces:
            moved = piece.copy(include_visual=False)
            moved.apply_transform(np.diag([*scale, 1.0]) @ own)
            moved.visual = piece.visual
            placed.append(moved)
    asset = header.get("asset")
    maker = str(asset.get("generator", "")) if isinstance(asset, Mapping) else ""
    called = f"{what}, {name!r}"
    surface = surface_of(placed, called, "trimesh" not in maker, MOST_FACES, pictures)
    extras = _extras(node)
    fixed = extras.get("fixed") is True
    body = ForeignBody(
        name, _Z_UP @ position, _Z_UP @ rotation, surface, shells.get(name, ()),
        None if fixed else _mass(extras, name), _number(extras.get("friction"), name, "friction"),
        str(extras.get("label", ""))[:80] if isinstance(extras.get("label"), str) else "",
    )  # fmt: skip
    return body, fixed


def _split(
    matrix: Float[np.ndarray, "4 4"], name: str
) -> tuple[Float[np.ndarray, "3 3"], Float[np.ndarray, "3"], Float[np.ndarray, "3"]]:
    """Return the rotation, scale and translation of a node's transformation matrix."""
    with np.errstate(all="ignore"):
        scale = np.linalg.norm(matrix[:3, :3], axis=0)
        turn = matrix[:3, :3] / scale
    if not np.isfinite(matrix).all() or not np.abs(turn.T @ turn - np.eye(3)).max() < _RIGID:
        raise InputError(
            f"The transform of node {name!r} must consist of a rotation, a scale and a translation."
        )
    if np.linalg.det(turn) < 0:
        raise InputError(f"Node {name!r} is mirrored. Apply its transform to the mesh.")
    u, _, v = np.linalg.svd(turn)
    return u @ v, scale, matrix[:3, 3].copy()


def _mass(extras: Mapping[str, Any], name: str) -> MassProperties | None:
    """Return a node's mass properties, or None if its mass or its inertia is not given."""
    mass = _number(extras.get("mass"), name, "mass")
    if mass is None or "inertia" not in extras:
        return None
    try:
        com = np.array(extras.get("center_of_mass"), np.float64).reshape(3)
        inertia = np.array(extras.get("inertia"), np.float64).reshape(3, 3)
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError(f"Node {name!r} has no valid centre of mass and inertia.") from error
    least = np.linalg.eigvalsh((inertia + inertia.T) / 2).min() if np.isfinite(inertia).all() else 0
    if not (mass > 0 and np.isfinite(com).all() and least > 0):
        raise InputError(f"Node {name!r} has no valid mass, centre of mass and inertia.")
    return MassProperties(mass, com, (inertia + inertia.T) / 2)


def _number(value: object, name: str, what: str) -> float | None:
    if value is None:
        return None
    if not is_number(value, minimum=-1e12):
        raise InputError(f"The {what} of node {name!r} must be a number.")
    return float(cast("float", value))


def _collision_of(
    raw: bytes, header: Header, shown: int, what: str
) -> tuple[Mapping[str, tuple[ConvexPart, ...]], Sequence[str]]:
    """Return each body's convex parts, read from the glTF scene "collision", and warnings.

    If one part of a body is damaged, all are ignored: its collision shape is made from its surface.
    """
    scenes = header.get("scenes", ())
    number = next(
        (k for k, s in enumerate(scenes) if k != shown and s.get("name") == _COLLISION), None
    )
    if number is None:
        return {}, ()
    try:
        places = _places(header, number, what)
    except InputError as error:
        return {}, (f"the collision shapes cannot be read: {error}",)
    parts: dict[str, list[ConvexPart]] = {}
    damaged: dict[str, str] = {}
    for place, meshes in zip(places, _load_each(raw, header, places, what), strict=True):
        body = str(_extras(header["nodes"][place.owner]).get("body"))[:100]
        try:
            parts.setdefault(body, []).extend(_shells(header, place, meshes, what))
        except (InputError, BackendError) as error:
            damaged.setdefault(body, f"the collision shapes of {body!r} cannot be read: {error}")
    sound = {name: tuple(found) for name, found in parts.items() if name not in damaged}
    return sound, tuple(damaged.values())


def _shells(
    header: Header, place: _Place, meshes: Sequence[trimesh.Trimesh] | BackendError, what: str
) -> Iterator[ConvexPart]:
    """Yield the convex parts of a node of the scene "collision", in the frame of its body."""
    if isinstance(meshes, BackendError):
        raise meshes
    kind = str(_extras(header["nodes"][place.node]).get("kind"))
    _split(place.owner_matrix, _name(header, place.owner))  # fails without an inverse
    own = np.linalg.inv(place.owner_matrix) @ place.matrix
    for mesh in meshes:
        points = np.asarray(mesh.vertices, np.float64) @ own[:3, :3].T + own[:3, 3]
        if not np.isfinite(points).all():
            raise InputError(f"{what} contains NaN or infinity; all vertices must be finite.")
        yield part_of(points, kind)
