"""GLB files compressed by Draco or meshopt, quantised, or with WebP textures."""

import io
import json
import struct
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from foreign_meshes import box, textured

from generator.errors import BackendError
from generator.imports.glb import read_glb
from generator.meshes.reading.codecs import plain_glb
from generator.meshes.reading.surface import ColoredSurface, read_surface

POINTS = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], np.float64)
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], np.uint16)
UV = np.array([[0, 0], [1, 0], [0, 1], [1, 1]], np.float64)


def glb(header: dict[str, Any], data: bytes) -> bytes:
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 4)
    size = 28 + len(text) + len(data)
    head = struct.pack("<4sIII4s", b"glTF", 2, size, len(text), b"JSON")
    return head + text + struct.pack("<I4s", len(data), b"BIN\0") + data


def parts(raw: bytes) -> tuple[dict[str, Any], bytes]:
    size = struct.unpack_from("<I", raw, 12)[0]
    return json.loads(raw[20 : 20 + size]), raw[28 + size :]


def quantized() -> tuple[dict[str, Any], list[bytes]]:
    """A tetrahedron of side 0.1 in 16-bit numbers, its node's scale giving the size."""
    points = np.zeros((4, 4), np.int16)  # rows of 8 bytes
    points[:, :3] = np.round(32767 * POINTS)
    uv = np.round(65535 * UV / 2).astype(np.uint16)
    columns = [points.tobytes(), FACES.tobytes(), uv.tobytes()]
    starts = np.cumsum([0, *map(len, columns)])
    header = {
        "asset": {"version": "2.0"},
        "extensionsUsed": ["KHR_mesh_quantization"],
        "extensionsRequired": ["KHR_mesh_quantization"],
        "scene": 0,
        "scenes": [{"nodes": [0]}],
        "nodes": [{"mesh": 0, "name": "thing", "scale": [0.1, 0.1, 0.1]}],
        "meshes": [{"primitives": [
            {"attributes": {"POSITION": 0, "TEXCOORD_0": 2}, "indices": 1, "material": 0}]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": [1, 0, 0, 1]}}],
        "buffers": [{"byteLength": int(starts[-1])}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": int(start), "byteLength": len(column)}
            for start, column in zip(starts[:-1], columns, strict=True)
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5122, "count": 4, "type": "VEC3",
             "normalized": True},
            {"bufferView": 1, "componentType": 5123, "count": 12, "type": "SCALAR"},
            {"bufferView": 2, "componentType": 5123, "count": 4, "type": "VEC2",
             "normalized": True},
        ],
    }  # fmt: skip
    header["bufferViews"][0]["byteStride"] = 8
    return header, columns


def meshopt() -> bytes:
    """Return the same tetrahedron with columns compressed as by gltfpack."""
    import meshoptimizer

    header, columns = quantized()
    points = np.frombuffer(columns[0], np.uint8).reshape(4, 8)
    uv = np.frombuffer(columns[2], np.uint8).reshape(4, 4)
    indices = FACES.ravel().astype(np.uint32)
    packed = [
        meshoptimizer.encode_vertex_buffer(points, 4, 8),
        meshoptimizer.encode_index_buffer(indices, 12, 4),
        meshoptimizer.encode_vertex_buffer(uv, 4, 4),
    ]
    data = b""
    for view, content, count, stride, mode in zip(
        header["bufferViews"], packed, (4, 12, 4), (8, 2, 4),
        ("ATTRIBUTES", "TRIANGLES", "ATTRIBUTES"), strict=True,
    ):  # fmt: skip
        view["extensions"] = {"EXT_meshopt_compression": {
            "buffer": 0, "byteOffset": len(data), "byteLength": len(content), "count": count,
            "byteStride": stride, "mode": mode}}  # fmt: skip
        view["buffer"] = 1
        data += content + b"\0" * (-len(content) % 4)
    header["buffers"] = [
        {"byteLength": len(data)},
        {"byteLength": 64, "extensions": {"EXT_meshopt_compression": {"fallback": True}}},
    ]
    for key in ("extensionsUsed", "extensionsRequired"):
        header[key] = [*header[key], "EXT_meshopt_compression"]
    return glb(header, data)


def check_tetrahedron(surface: ColoredSurface) -> None:
    corners = surface.vertices[surface.faces]
    wanted = 0.1 * POINTS[FACES]
    order = [c.tobytes() for c in np.sort(np.round(corners, 4), axis=1)]
    assert sorted(order) == sorted(c.tobytes() for c in np.sort(np.round(wanted, 4), axis=1))
    assert (surface.colors == [255, 0, 0]).all()


@pytest.mark.usefixtures("inline")
def test_a_quantized_mesh_is_read() -> None:
    header, columns = quantized()
    surface = read_surface(glb(header, b"".join(columns)), "The mesh", "glb")
    check_tetrahedron(surface)
    np.testing.assert_allclose(np.sort(surface.uv, axis=0)[-1], [0.5, 1.0], atol=1e-4)


@pytest.mark.usefixtures("inline")
def test_a_mesh_compressed_by_meshopt_is_read() -> None:
    check_tetrahedron(read_surface(meshopt(), "The mesh", "glb"))


@pytest.mark.usefixtures("inline")
def test_quantized_texture_coordinates_are_moved_as_their_material_says() -> None:
    header, columns = quantized()
    move = {"KHR_texture_transform": {"scale": [2, 2], "offset": [0.25, 0]}}
    header["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"] = {
        "index": 0, "extensions": move}  # fmt: skip
    header["textures"], header["images"] = [{"source": 0}], [{"uri": "data:"}]
    plain, data = parts(plain_glb(glb(header, b"".join(columns)), "The mesh"))
    color = plain["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]
    assert "KHR_texture_transform" not in color["extensions"]
    accessor = plain["accessors"][plain["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"]]
    view = plain["bufferViews"][accessor["bufferView"]]
    uv = np.frombuffer(data, np.float32, 8, view["byteOffset"]).reshape(4, 2)
    np.testing.assert_allclose(uv - UV, np.tile([0.25, 0], (4, 1)), atol=1e-4)
    move["KHR_texture_transform"]["rotation"] = 1.0
    with pytest.raises(BackendError, match="uses KHR_texture_transform"):
        read_surface(glb(header, b"".join(columns)), "The mesh", "glb")


@pytest.mark.usefixtures("inline")
@pytest.mark.parametrize("extension", ["extension_draco", "extension_webp"])
def test_a_textured_mesh_by_draco_or_with_webp_is_read(extension: str) -> None:
    plain = read_surface(textured().export(file_type="glb"), "The mesh", "glb")
    file = textured().export(file_type="glb", **{extension: True})
    assert "KHR_draco" in str(file) or "EXT_texture_webp" in str(file)
    found = read_surface(file, "The mesh", "glb")
    assert len(found.faces) == len(plain.faces)
    np.testing.assert_allclose(found.vertices.min(0), plain.vertices.min(0), atol=1e-4)
    np.testing.assert_allclose(found.vertices.max(0), plain.vertices.max(0), atol=1e-4)
    centers = np.full((len(found.faces), 3), 1 / 3)
    colors = [s.colors_at(np.arange(len(s.faces)), centers) for s in (found, plain)]
    np.testing.assert_allclose(np.sort(colors[0], axis=0), np.sort(colors[1], axis=0), atol=8)


@pytest.mark.usefixtures("inline")
def test_a_compressed_scene_is_imported_by_its_nodes(tmp_path: Path) -> None:
    scene = trimesh.Scene()
    scene.add_geometry(box(1.0, 0.5, 0.6), node_name="table", geom_name="table")
    lifted = trimesh.transformations.translation_matrix((0, 0.3, 0))
    scene.add_geometry(box(), node_name="cube", geom_name="cube", transform=lifted)
    path = tmp_path / "scene.glb"
    path.write_bytes(trimesh.exchange.gltf.export_glb(scene, extension_draco=True))
    found = read_glb(path)
    assert found.table is not None and found.table.name == "table"
    (cube,) = found.objects
    np.testing.assert_allclose(np.ptp(cube.surface.vertices, axis=0), (0.06, 0.05, 0.04), atol=1e-4)


@pytest.mark.parametrize(
    ("package", "file"),
    [("DracoPy", lambda: box().export(file_type="glb", extension_draco=True)),
     ("meshoptimizer", meshopt)],
)  # fmt: skip
def test_a_missing_decoder_is_named(package: str, file, monkeypatch: pytest.MonkeyPatch) -> None:
    raw = file()
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(BackendError, match=rf"{package}.*Install tabletopgen\[gltf\]"):
        plain_glb(raw, "The mesh")


def broken(**changes: Any) -> bytes:
    header, columns = quantized()
    header["accessors"][0] |= changes
    return glb(header, b"".join(columns))


@pytest.mark.parametrize(
    "raw",
    [
        broken(count=10**9), broken(componentType=7), broken(bufferView=9), broken(byteOffset=-8),
        broken(sparse={}), glb(parts(meshopt())[0], bytes(200)),
    ],
)  # fmt: skip
def test_damaged_files_are_refused(raw: bytes) -> None:
    with pytest.raises(BackendError):
        read_surface(raw, "The mesh", "glb")


def test_other_files_stay_as_they_are() -> None:
    file = box().export(file_type="glb")
    assert plain_glb(file, "The mesh") is file
    assert plain_glb(b"nonsense", "The mesh") == b"nonsense"
    assert isinstance(trimesh.load(io.BytesIO(file), file_type="glb"), trimesh.Scene)
