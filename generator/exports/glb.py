"""glTF 2.0 binary: one file with two scenes, the visual meshes and the collision shapes.

The first scene, which viewers show, has a node for each body with its textured mesh. The scene
"collision" has the same nodes with a mesh for each convex piece. glTF is y up, so both have a root
node that rotates z up to y up. A node's ``extras`` hold the values for which glTF has no fields:
``mass`` (kg), ``center_of_mass`` (metres), ``inertia`` (kg m², rows, about the centre of mass),
``friction``, ``fixed``, in the body's frame. The extras of a piece are its ``kind`` and
``half_extents``, and the node above the pieces has the name of their ``body``.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from PIL import Image

from ..geometry import quaternion_matrix
from .bodies import RESERVED, ExportBody, ExportPiece, ExportWorld, free_name

_VERTICES, _INDICES = 34962, 34963  # ARRAY_BUFFER and ELEMENT_ARRAY_BUFFER


def glb_files(world: ExportWorld) -> Mapping[str, bytes]:
    """Return all bodies as one GLB file."""
    import trimesh

    bodies = world.bodies
    whole = trimesh.Scene()
    details: dict[str, dict[str, Any]] = {}
    taken = {*RESERVED, *(body.name for body in bodies)}
    for body in bodies:
        pose = np.eye(4)
        pose[:3, :3], pose[:3, 3] = quaternion_matrix(body.quaternion), body.position
        whole.add_geometry(_draw(body), body.name, body.name, transform=pose)
        details[body.name] = _details(body)
        shell = free_name(f"{body.name}_collision", taken)
        whole.graph.update(shell, matrix=pose)
        details[shell] = {"body": body.name}
        for k, piece in enumerate(body.pieces):
            name = free_name(f"{body.name}_part_{k}", taken)
            solid = trimesh.Trimesh(piece.vertices, piece.faces, process=False)
            whole.add_geometry(solid, name, name, parent_node_name=shell)
            details[name] = _piece_details(piece)

    roots = [free_name(root, taken) for root in ("y_up", "y_up_collision")]

    def arrange(tree: dict[str, Any]) -> None:
        _arrange(tree, world.name, details, roots)
        _mark_buffers(tree)

    packed = whole.export(file_type="glb", tree_postprocessor=arrange, unitize_normals=True)
    assert isinstance(packed, bytes)
    return {"scene.glb": packed}


def _draw(body: ExportBody) -> Any:
    import trimesh
    from trimesh.visual import TextureVisuals
    from trimesh.visual.material import PBRMaterial

    mesh = body.mesh
    material = PBRMaterial(
        name=f"{body.name}_material",
        baseColorTexture=Image.fromarray(mesh.texture),
        baseColorFactor=[255, 255, 255, round(255 * mesh.opacity)],
        alphaMode="BLEND" if mesh.opacity < 1 else "OPAQUE",
        metallicFactor=0.0, roughnessFactor=0.7,
    )  # fmt: skip
    visual = TextureVisuals(uv=np.asarray(mesh.uv, np.float64), material=material)
    return trimesh.Trimesh(body.vertices, mesh.faces, visual=visual, process=False)


def _details(body: ExportBody) -> dict[str, Any]:
    return {
        "label": body.label,
        "fixed": body.fixed,
        "mass": body.mass,
        "center_of_mass": body.com.tolist(),
        "inertia": body.inertia.tolist(),
        "friction": body.friction,
    }


def _piece_details(piece: ExportPiece) -> dict[str, Any]:
    return {"kind": piece.kind, "half_extents": piece.half.tolist()}


def _arrange(
    tree: dict[str, Any], name: str, details: Mapping[str, dict[str, Any]], roots: Sequence[str]
) -> None:
    """Set the nodes' extras, attach bodies to rotated roots, and put pieces into a separate scene.

    ``roots`` are the names of the root nodes of the visual scene and the collision scene.
    """
    nodes, (scene,) = tree["nodes"], tree["scenes"]
    for node in nodes:
        if node["name"] in details:
            node["extras"] = details[node["name"]]
    shells = [k for k in scene["nodes"] if "body" in details[nodes[k]["name"]]]
    drawn = [k for k in scene["nodes"] if k not in shells]
    half = float(np.sqrt(0.5))
    for root, children in zip(roots, (drawn, shells), strict=True):
        nodes.append({"name": root, "children": children, "rotation": [-half, 0.0, 0.0, half]})
    first = len(nodes) - len(roots)
    tree["scenes"] = [
        {"name": name, "nodes": [first]},
        {"name": "collision", "nodes": [first + 1]},
    ]
    tree["scene"] = 0


def _mark_buffers(tree: dict[str, Any]) -> None:
    """Mark which buffer views hold vertices, and which hold indices."""
    views = [tree["bufferViews"][accessor["bufferView"]] for accessor in tree["accessors"]]
    for mesh in tree["meshes"]:
        for primitive in mesh["primitives"]:
            views[primitive["indices"]]["target"] = _INDICES
            for number in primitive["attributes"].values():
                views[number]["target"] = _VERTICES
