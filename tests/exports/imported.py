"""The content of an export as other readers see it: mass, pose, extent and collision parts.

None of the exports' own code is used: MuJoCo reads MJCF and URDF, pxr USD, trimesh GLB, and SDF,
which no package reads, is read from its XML.
"""

from __future__ import annotations

import io
import json
import struct
import xml.etree.ElementTree as ET
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import trimesh
from scipy.spatial.transform import Rotation

EXTENT = tuple[tuple[float, ...], tuple[float, ...]]


@dataclass
class Found:
    """A body as read: numbers in its own frame, its pose in the world (z up, wxyz).

    The mass of what is fixed is 0.
    """

    position: np.ndarray
    quaternion: np.ndarray
    mass: float = 0.0
    com: np.ndarray = field(default_factory=lambda: np.zeros(3))
    inertia: np.ndarray = field(default_factory=lambda: np.zeros((3, 3)))
    friction: float | None = None
    drawn: np.ndarray | None = None  # lowest and highest corner of the visual geometry
    parts: list[np.ndarray] = field(default_factory=list)  # corners of each piece's surface


def bounds(points: np.ndarray) -> np.ndarray:
    return np.stack([points.min(0), points.max(0)])


def from_model(path: Path) -> dict[str, Found]:
    """Read the model that MuJoCo compiles from MJCF or URDF."""
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    found = {}
    for b in range(1, model.nbody):
        frame = Rotation.from_quat(model.body_iquat[b], scalar_first=True).as_matrix()
        body = Found(
            data.xpos[b].copy(), data.xquat[b].copy(),
            float(model.body_mass[b]) if model.body_dofnum[b] else 0.0,
            model.body_ipos[b].copy(), frame @ np.diag(model.body_inertia[b]) @ frame.T,
        )  # fmt: skip
        for g in np.flatnonzero(model.geom_bodyid == b):
            points = geom_points(model, int(g))
            if model.geom_contype[g]:
                body.parts.append(points)
                body.friction = float(model.geom_friction[g, 0])
            elif model.geom_type[g] == mujoco.mjtGeom.mjGEOM_MESH:
                body.drawn = bounds(points)
        found[model.body(b).name] = body
    return found


def geom_points(model: Any, g: int) -> np.ndarray:
    """Return corners of a geom in its body's frame; for primitives those of their box."""
    frame = Rotation.from_quat(model.geom_quat[g], scalar_first=True)
    kind, size = model.geom_type[g], model.geom_size[g]
    if kind == mujoco.mjtGeom.mjGEOM_MESH:
        mesh = model.geom_dataid[g]
        first, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
        points = model.mesh_vert[first : first + count]
    else:
        round_ = {int(mujoco.mjtGeom.mjGEOM_SPHERE): 0, int(mujoco.mjtGeom.mjGEOM_CYLINDER): 1}
        half = size[[0, 0, round_[int(kind)]]] if int(kind) in round_ else size
        points = box_corners(half)
    return frame.apply(points) + model.geom_pos[g]


def box_corners(half: np.ndarray) -> np.ndarray:
    return np.stack(np.meshgrid(*[(-1.0, 1.0)] * 3), -1).reshape(-1, 3) * half


def from_sdf(path: Path) -> dict[str, Found]:
    """Read SDF from its XML."""
    found = {}
    for model in ET.parse(path).getroot().iter("model"):
        pose = numbers(model.find("pose"), 6)
        turn = Rotation.from_euler("xyz", pose[3:])
        body = Found(pose[:3], turn.as_quat(scalar_first=True))
        link = model.find("link")
        assert link is not None
        if (inertial := link.find("inertial")) is not None:
            fixed = model.findtext("static") == "true"
            body.mass = 0.0 if fixed else float(inertial.findtext("mass", ""))
            body.com = numbers(inertial.find("pose"), 6)[:3]
            i = {e.tag: float(e.text or "") for e in inertial.iterfind("inertia/*")}
            body.inertia = np.array(
                [
                    [i["ixx"], i["ixy"], i["ixz"]], [i["ixy"], i["iyy"], i["iyz"]],
                    [i["ixz"], i["iyz"], i["izz"]],
                ]
            )  # fmt: skip
        for uri in link.iterfind("visual/geometry/mesh/uri"):
            body.drawn = bounds(surface(path.parent / str(uri.text)))
        for part in link.iterfind("collision"):
            shape = part.find("geometry")
            assert shape is not None
            at = numbers(part.find("pose"), 6)
            frame = Rotation.from_euler("xyz", at[3:])
            body.parts.append(frame.apply(sdf_points(shape, path.parent)) + at[:3])
            body.friction = float(part.findtext("surface/friction/ode/mu", ""))
        found[model.attrib["name"]] = body
    del found["floor"]
    return found


def sdf_points(shape: ET.Element, folder: Path) -> np.ndarray:
    if (uri := shape.findtext("mesh/uri")) is not None:
        return surface(folder / uri)
    if (size := shape.find("box/size")) is not None:
        return box_corners(numbers(size, 3) / 2)
    if (radii := shape.find("ellipsoid/radii")) is not None:
        return box_corners(numbers(radii, 3))
    radius = float(shape.findtext("*/radius", ""))
    length = shape.findtext("cylinder/length")
    return box_corners(np.array([radius, radius, float(length) / 2 if length else radius]))


def numbers(element: ET.Element | None, count: int) -> np.ndarray:
    if element is None:
        return np.zeros(count)
    return np.array((element.text or "").split(), float)


def surface(path: Path) -> np.ndarray:
    mesh = trimesh.load_mesh(path, process=False)
    return np.asarray(mesh.vertices)


def from_glb(path: Path) -> dict[str, Found]:
    """Read GLB with trimesh, a scene at a time."""
    tree, rest = glb_tree(path.read_bytes())
    nodes = {node["name"]: node for node in tree["nodes"]}
    drawn, solid = (glb_scene(dict(tree, scene=k), rest) for k in (0, 1))
    up = Rotation.from_euler("x", 90, degrees=True).as_matrix()  # of y up to z up
    found: dict[str, Found] = {}
    for name in drawn.graph.nodes_geometry:
        more = nodes[name]["extras"]
        matrix, key = drawn.graph[name]
        turn = Rotation.from_matrix(up @ matrix[:3, :3])
        found[name] = Found(
            up @ matrix[:3, 3], turn.as_quat(scalar_first=True),
            0.0 if more["fixed"] else more["mass"],
            np.array(more["center_of_mass"]), np.array(more["inertia"]), more["friction"],
            bounds(np.asarray(drawn.geometry[key].vertices)),
        )  # fmt: skip
    above = solid.graph.transforms.parents
    for name in sorted(solid.graph.nodes_geometry, key=list(nodes).index):
        body = found[nodes[above[name]]["extras"]["body"]]
        matrix, key = solid.graph[name]
        at = up @ matrix[:3, 3]
        np.testing.assert_allclose(at, body.position, atol=1e-6)
        body.parts.append(np.asarray(solid.geometry[key].vertices))
    return found


def glb_tree(raw: bytes) -> tuple[dict[str, Any], bytes]:
    """Return the JSON of a GLB, and the chunks that follow it."""
    length = struct.unpack("<I", raw[12:16])[0]
    return json.loads(raw[20 : 20 + length]), raw[20 + length :]


def glb_scene(tree: dict[str, Any], rest: bytes) -> Any:
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    head = struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text) + len(rest), len(text), b"JSON")
    return trimesh.load_scene(io.BytesIO(head + text + rest), file_type="glb", process=False)


def from_usd(path: Path) -> dict[str, Found]:
    """Read USD with pxr."""
    from pxr import Usd, UsdGeom, UsdPhysics, UsdShade

    stage = Usd.Stage.Open(str(path))
    assert UsdGeom.GetStageUpAxis(stage) == "Z"
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1.0
    found = {}
    for prim in stage.GetPrimAtPath("/World").GetChildren():
        if prim.GetName() in ("PhysicsScene", "floor"):
            continue
        matrix = np.array(UsdGeom.Xformable(prim).ComputeLocalToWorldTransform(0)).T
        turn = Rotation.from_matrix(matrix[:3, :3])
        body = Found(matrix[:3, 3], turn.as_quat(scalar_first=True))
        if prim.HasAPI(UsdPhysics.RigidBodyAPI):
            api = UsdPhysics.MassAPI(prim)
            body.mass = api.GetMassAttr().Get()
            body.com = np.array(api.GetCenterOfMassAttr().Get())
            q = api.GetPrincipalAxesAttr().Get()
            axes = Rotation.from_quat([q.GetReal(), *q.GetImaginary()], scalar_first=True)
            r = axes.as_matrix()
            body.inertia = r @ np.diag(api.GetDiagonalInertiaAttr().Get()) @ r.T
        drawn = UsdGeom.Mesh(prim.GetChild("Visual"))
        body.drawn = bounds(np.array(drawn.GetPointsAttr().Get()))
        for piece in prim.GetChild("Collision").GetChildren():
            assert piece.HasAPI(UsdPhysics.CollisionAPI)
            local = np.array(UsdGeom.Xformable(piece).GetLocalTransformation()).T
            points = usd_points(piece)
            body.parts.append(points @ local[:3, :3].T + local[:3, 3])
            binding = UsdShade.MaterialBindingAPI(piece)
            material, _ = binding.ComputeBoundMaterial("physics")
            api = UsdPhysics.MaterialAPI(material.GetPrim())
            body.friction = api.GetDynamicFrictionAttr().Get()
        found[prim.GetName()] = body
    return found


def usd_points(prim: Any) -> np.ndarray:
    from pxr import UsdGeom, UsdPhysics

    if prim.IsA(UsdGeom.Mesh):
        approximation = UsdPhysics.MeshCollisionAPI(prim).GetApproximationAttr().Get()
        assert approximation == "convexHull"
        return np.array(UsdGeom.Mesh(prim).GetPointsAttr().Get())
    low, high = map(
        np.array, UsdGeom.Boundable.ComputeExtentFromPlugins(UsdGeom.Boundable(prim), 0)
    )
    return box_corners((high - low) / 2)


READERS: dict[str, Callable[[Path], dict[str, Found]]] = {
    "mjcf": lambda path: from_model(path / "scene.xml"),
    "urdf": lambda path: from_model(path / "scene.urdf"),
    "sdf": lambda path: from_sdf(path / "scene.sdf"),
    "glb": from_glb,
    "usd": lambda path: from_usd(path / "scene.usdc"),
    "usdz": from_usd,
}


def settle_drift(found: dict[str, Found], seconds: float = 2.0) -> float:
    """Return the maximum motion of a body in MuJoCo with default settings, metres.

    Bodies without a mass do not move; collision parts are hulls of the corners that were read.
    """
    spec = mujoco.MjSpec()
    for name, body in found.items():
        held = spec.worldbody.add_body(name=name, pos=body.position, quat=body.quaternion)
        if body.mass:
            held.add_freejoint()
            held.mass, held.ipos, held.explicitinertial = body.mass, body.com, True
            i = body.inertia
            held.fullinertia = [i[0, 0], i[1, 1], i[2, 2], i[0, 1], i[0, 2], i[1, 2]]
        for k, points in enumerate(body.parts):
            mesh = f"{name}_{k}"
            spec.add_mesh(name=mesh, uservert=np.asarray(points, float).ravel())
            rub = [body.friction or 1.0, 0.005, 0.0001]
            held.add_geom(type=mujoco.mjtGeom.mjGEOM_MESH, meshname=mesh, friction=rub)
    model = spec.compile()
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    start = data.xpos.copy()
    while data.time < seconds:
        mujoco.mj_step(model, data)
    return float(np.linalg.norm(data.xpos - start, axis=1).max())
