"""Foreign meshes created by the tests: valid and invalid files as bytes."""

import base64
import json
import struct
from collections.abc import Callable

import forging
import numpy as np
import trimesh
from PIL import Image
from trimesh.visual.material import PBRMaterial

from generator.scene import Instance, SizePrior


def glb(*meshes: trimesh.Trimesh) -> bytes:
    return trimesh.Scene(list(meshes)).export(file_type="glb")


def textured(mesh: trimesh.Trimesh, picture: np.ndarray, uv: np.ndarray) -> trimesh.Trimesh:
    look = PBRMaterial(baseColorTexture=Image.fromarray(picture))
    mesh.visual = trimesh.visual.TextureVisuals(uv=uv, material=look)
    return mesh


def striped_box(size: tuple[float, float, float] = (2.0, 1.0, 1.0)) -> trimesh.Trimesh:
    """Return a box (x, y, z) with a texture that is red at high y and blue at low y."""
    made = trimesh.creation.box(extents=size)
    corners = made.vertices[made.faces].reshape(-1, 3)
    picture = np.zeros((64, 64, 3), np.uint8)
    picture[:32], picture[32:] = (220, 20, 20), (20, 20, 220)
    uv = np.column_stack([corners[:, 0] / size[0], corners[:, 1] / size[1]]) * 0.9 + 0.5
    faces = np.arange(len(corners)).reshape(-1, 3)
    return textured(trimesh.Trimesh(corners, faces, process=False), picture, uv)


def plain(mesh: trimesh.Trimesh, color: tuple[int, int, int, int]) -> trimesh.Trimesh:
    mode = "BLEND" if color[3] < 255 else None
    look = PBRMaterial(baseColorFactor=np.array(color, np.uint8), alphaMode=mode)
    mesh.visual = trimesh.visual.TextureVisuals(material=look)
    return mesh


def edited(raw: bytes, change: Callable[[dict], None]) -> bytes:
    size = struct.unpack("<I", raw[12:16])[0]
    header = json.loads(raw[20 : 20 + size])
    change(header)
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 4)
    rest = raw[20 + size :]
    head = struct.pack("<4sIIII", b"glTF", 2, 20 + len(text) + len(rest), len(text), 0x4E4F534A)
    return head + text + rest


def claiming(raw: bytes, faces: int) -> bytes:
    """Return a GLB whose header claims so many faces, with fewer zero bytes than a mesh needs."""

    def claim(header: dict) -> None:
        count = {"count": 3 * faces, "componentType": 5121, "type": "SCALAR", "bufferView": 0}
        header["accessors"].append(count)
        header["meshes"][0]["primitives"][0]["indices"] = len(header["accessors"]) - 1

    return edited(raw, claim) + bytes(3 * faces // 4 + 4096)


def painted_with(raw: bytes, picture: bytes) -> bytes:
    """Return a GLB with another file as its first picture."""
    return edited(raw, lambda header: header["images"].__setitem__(0, {"uri": data_uri(picture)}))


def data_uri(picture: bytes) -> str:
    return "data:image/png;base64," + base64.b64encode(picture).decode()


def png(width: int, height: int) -> bytes:
    """Return a picture with a size header and no content."""
    return forging.png(width, height, mode=2)


def instance(label: str) -> Instance:
    """Return an instance with a red disc as its crop, in a frame that is not square."""
    rows, columns = np.mgrid[:60, :80]
    crop = np.zeros((60, 80, 4), np.uint8)
    crop[(rows - 30) ** 2 + (columns - 40) ** 2 < 400] = (200, 30, 30, 255)
    box = np.array([20.0, 10, 60, 50])
    mask = crop[..., 3] > 0
    return Instance(f"{label}_1", label, box, mask, crop, np.array([0.0, 0, 80, 60]))


def prior(label: str) -> SizePrior:
    return SizePrior(label, np.array([0.12, 0.09, 0.1]))
