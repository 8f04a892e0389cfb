"""Renders of exports from the triangles and colours that other readers see."""

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import mujoco
import numpy as np
import trimesh
from imported import glb_scene, glb_tree
from PIL import Image

from generator.render.raster import Item

UP = np.array([[1.0, 0, 0], [0, 0, -1], [0, 1, 0]])  # of y up to z up


def from_urdf(path: Path) -> Iterator[Item]:
    """Yield MuJoCo's geoms of a URDF in plain colours, since it reads no textures."""
    model = mujoco.MjModel.from_xml_path(str(path / "scene.urdf"))
    data = mujoco.MjData(model)
    mujoco.mj_kinematics(model, data)
    for k in np.flatnonzero(model.geom_contype == 0).tolist():
        mesh = int(model.geom_dataid[k])
        at, count = model.mesh_vertadr[mesh], model.mesh_vertnum[mesh]
        first, many = model.mesh_faceadr[mesh], model.mesh_facenum[mesh]
        points = model.mesh_vert[at : at + count] @ data.geom_xmat[k].reshape(3, 3).T
        color = np.round(255 * model.geom_rgba[k, :3]).astype(np.uint8)
        faces = model.mesh_face[first : first + many].astype(np.int64)
        yield item(points + data.geom_xpos[k], faces, None, color[None, None], k)


def from_glb(path: Path) -> Iterator[Item]:
    """Yield trimesh's geometry of the first scene of a GLB."""
    tree, rest = glb_tree(path.read_bytes())
    drawn = glb_scene(dict(tree, scene=0), rest)
    for k, name in enumerate(sorted(drawn.graph.nodes_geometry)):
        matrix, key = drawn.graph[name]
        mesh: Any = drawn.geometry[key]
        points = trimesh.transform_points(mesh.vertices, matrix) @ UP.T
        picture = np.asarray(mesh.visual.material.baseColorTexture.convert("RGB"))
        yield item(points, mesh.faces, mesh.visual.uv, picture, k)


def from_usd(path: Path) -> Iterator[Item]:
    """Yield pxr's geometry of a USD stage."""
    from pxr import Usd, UsdGeom, UsdShade

    stage = Usd.Stage.Open(str(path / "scene.usdc"))
    for k, prim in enumerate(stage.GetPrimAtPath("/World").GetChildren()):
        visual = prim.GetChild("Visual")
        if not visual:
            continue
        mesh = UsdGeom.Mesh(visual)
        matrix = np.array(mesh.ComputeLocalToWorldTransform(0))
        points = np.array(mesh.GetPointsAttr().Get()) @ matrix[:3, :3] + matrix[3, :3]
        assert set(mesh.GetFaceVertexCountsAttr().Get()) == {3}
        faces = np.array(mesh.GetFaceVertexIndicesAttr().Get()).reshape(-1, 3)
        uv = np.array(UsdGeom.PrimvarsAPI(visual).GetPrimvar("st").ComputeFlattened())
        material, _ = UsdShade.MaterialBindingAPI(visual).ComputeBoundMaterial()
        shaders = [UsdShade.Shader(p) for p in Usd.PrimRange(material.GetPrim())]
        files = [f.Get() for s in shaders if s and (f := s.GetInput("file"))]
        picture = np.asarray(Image.open(path / files[0].path).convert("RGB"))
        if len(uv) == 3 * len(faces):  # a place for each corner
            points, faces = points[faces.ravel()], np.arange(len(uv)).reshape(-1, 3)
        yield item(points, faces, uv, picture, k)


def item(points: Any, faces: Any, uv: Any, picture: Any, k: int) -> Item:
    points = np.asarray(points, np.float64)
    places = np.zeros((len(points), 2)) if uv is None else np.asarray(uv, np.float64)
    return Item(points, np.asarray(faces, np.int64), places, np.asarray(picture, np.uint8), k)


DRAWERS = {"urdf": from_urdf, "usd": from_usd, "glb": from_glb}
