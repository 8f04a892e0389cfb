"""A folder of hand-made foreign meshes, with a distinct fault each or none."""

import json
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np
import trimesh
from PIL import Image

Maker = Callable[[], trimesh.Trimesh]


def box(x: float = 0.06, y: float = 0.05, z: float = 0.04) -> trimesh.Trimesh:
    return trimesh.creation.box((x, y, z))


def torn() -> trimesh.Trimesh:
    """Return a ball without every seventh triangle."""
    mesh = trimesh.creation.icosphere(3, 0.04)
    mesh.update_faces(np.arange(len(mesh.faces)) % 7 != 0)
    return mesh


def inside_out() -> trimesh.Trimesh:
    mesh = box()
    mesh.faces = mesh.faces[:, ::-1]
    return mesh


def pinched() -> trimesh.Trimesh:
    """Return two boxes that share an edge, at which four faces meet."""
    one, other = box(), box()
    other.apply_translation((0.06, 0.0, 0.04))
    mesh = trimesh.util.concatenate([one, other])
    mesh.merge_vertices()
    return mesh


def two_pieces() -> trimesh.Trimesh:
    other = box(0.03, 0.03, 0.04)
    other.apply_translation((0.07, 0.0, 0.0))
    return trimesh.util.concatenate([box(), other])


def textured() -> trimesh.Trimesh:
    mesh = box()
    uv = np.clip(mesh.vertices[:, :2] / 0.06 + 0.5, 0, 1)
    picture = Image.fromarray(np.tile(np.arange(0, 256, 4, np.uint8)[:, None, None], (1, 64, 3)))
    material = trimesh.visual.material.PBRMaterial(baseColorTexture=picture)
    mesh.visual = trimesh.visual.TextureVisuals(uv=uv, material=material)
    return mesh


def in_millimetres() -> trimesh.Trimesh:
    mesh = trimesh.creation.cylinder(40.0, 90.0)
    mesh.apply_transform(trimesh.transformations.rotation_matrix(-np.pi / 2, (1, 0, 0)))  # y up
    return mesh


def sheet(thickness: float = 2e-4) -> trimesh.Trimesh:
    return box(0.2, thickness, 0.15)


def layer() -> trimesh.Trimesh:
    """Return a rectangle of two triangles without thickness."""
    corners = np.array([[0, 0, 0], [0.2, 0, 0], [0.2, 0, 0.15], [0, 0, 0.15]])
    return trimesh.Trimesh(corners, [[0, 2, 1], [0, 3, 2]], process=False)


def ball() -> trimesh.Trimesh:
    return trimesh.creation.icosphere(3, 0.04)


def heavy() -> trimesh.Trimesh:
    """Return a bumpy ball of 1.3 million triangles."""
    mesh = trimesh.creation.icosphere(8, 0.04)
    mesh.vertices *= 1 + 0.05 * np.sin(60 * mesh.vertices[:, :1])
    return mesh


MAKERS: Mapping[str, Maker] = {
    "plain": box, "torn": torn, "upright": lambda: box(0.05, 0.12, 0.05), "round": ball,
    "thin": sheet, "flat": layer, "two words and more": box, "pinched": pinched,
    "inside out": inside_out, "two pieces": two_pieces, "textured": textured,
    "tiny": lambda: box(0.003, 0.003, 0.003),
}  # fmt: skip
"""Meshes of which none may be lost."""


def write_meshes(
    folder: Path, makers: Mapping[str, Maker] = MAKERS, files: Mapping[str, bytes] | None = None
) -> Path:
    """Write meshes as GLB, other files unchanged, and the position of each on a table."""
    folder.mkdir(parents=True, exist_ok=True)
    heights: dict[str, float] = {}
    for name, make in makers.items():
        mesh = make()
        heights[name] = float(-mesh.bounds[0, 1])
        mesh.export(folder / f"{name}.glb")
    for name, content in (files or {}).items():
        (folder / f"{name}.glb").write_bytes(content)
    names = [*makers, *(files or {})]
    objects: list[dict[str, Any]] = [
        {"name": name, "file": f"{name}.glb", "position": [
            0.3 * (k % 6) - 0.75, 0.3 * (k // 6) - 0.45, 0.74 + heights.get(name, 0.0)]}
        for k, name in enumerate(names)
    ]  # fmt: skip
    poses = {"table": {"size": [2.0, 1.4, 0.74]}, "objects": objects}
    (folder / "poses.json").write_text(json.dumps(poses))
    return folder
