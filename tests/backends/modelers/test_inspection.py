"""Harmful or unreadable files are rejected before decoding."""

import base64
import io
import re
import struct
import time
from collections.abc import Callable

import numpy as np
import pytest
import trimesh
from backends.modelers.foreign import (
    claiming,
    data_uri,
    edited,
    glb,
    painted_with,
    png,
    striped_box,
)
from PIL import Image, ImageFile

from generator.errors import BackendError
from generator.meshes.canonical import Normal, normal_mesh
from generator.meshes.reading import inspection
from generator.meshes.reading.inspection import inspect_glb, inspect_obj
from generator.meshes.reading.surface import read_surface

GOOD = glb(striped_box())


def refusal(raw: bytes) -> str:
    with pytest.raises(BackendError) as caught:
        inspect_glb(raw, "hunyuan3d, model of 'mug_1':")
    assert str(caught.value).startswith("hunyuan3d, model of 'mug_1': ")
    return str(caught.value)


def test_a_good_file_passes():
    assert inspect_glb(GOOD, "it")["asset"]["version"] == "2.0"


@pytest.mark.parametrize(
    ("raw", "said"),
    [
        (b"", "not a GLB file: its 0 bytes"),
        (b"<!DOCTYPE html><html>busy</html>", "begin with b'<!DOCTYPE ht'"),
        (GOOD[: len(GOOD) // 2], "truncated"),
        (GOOD[:18], "not a GLB file"),
        (GOOD[:4] + struct.pack("<I", 1) + GOOD[8:], "version 1"),
        (GOOD[:24] + b"\xff\xff" + GOOD[26:], "damaged header"),
    ],
)
def test_what_is_no_whole_glb_is_refused(raw, said):
    assert said in refusal(raw)


def test_deep_json_is_refused():
    text = b"[" * 40_000
    raw = struct.pack("<4sIIII", b"glTF", 2, 20 + len(text), len(text), 0x4E4F534A) + text
    assert "damaged header" in refusal(raw)


@pytest.mark.parametrize("where", ["buffers", "images"])
@pytest.mark.parametrize("uri", ["http://example.org/a.png", "../../etc/passwd", "file:///a.bin"])
def test_files_outside_are_refused(where, uri):
    raw = edited(GOOD, lambda header: header[where][0].update(uri=uri))
    assert f"refers to an external file, {uri!r}" in refusal(raw)


def moved_texture(header: dict) -> None:
    texture = header["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]
    texture["extensions"] = {"KHR_texture_transform": {"scale": [2, 2]}}


def two_parents(header: dict) -> None:
    header["nodes"][-1]["children"] = [header["scenes"][0]["nodes"][0]]


def points_alone(header: dict) -> None:
    header["meshes"][0]["primitives"][0]["mode"] = 0


def large_count(header: dict) -> None:
    header["accessors"][0]["count"] = 2**30


def empty_accessor(header: dict) -> None:
    del header["accessors"][0]["bufferView"]


def large_views(header: dict) -> None:
    header["bufferViews"] += [{"buffer": 0, "byteLength": len(GOOD)}] * 9


def picture_elsewhere(header: dict) -> None:
    """Add a second buffer, which could hold another picture than the checked one."""
    header["buffers"].append({"byteLength": 10**4, "uri": "data:;base64,AAAA"})
    header["bufferViews"][header["images"][0]["bufferView"]]["buffer"] = 1


def many_pieces(header: dict) -> None:
    """Add many pieces of hidden meshes."""
    header["meshes"].append({"primitives": header["meshes"][0]["primitives"] * 20_001})


@pytest.mark.parametrize(
    ("change", "said"),
    [
        *((lambda h, n=name: h.update(extensionsUsed=[n]), f"compressed with {name}") for name in
          ("KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_texture_basisu")),
        (lambda h: h.update(extensionsRequired=["KHR_mesh_quantization"]),
         "requires KHR_mesh_quantization"),
        (moved_texture, "KHR_texture_transform"),
        (two_parents, "two parents"),
        (points_alone, "has 0 triangles"),
        (lambda h: h.update(meshes=[]), "refers to a missing mesh"),
        (large_count, "accessors claim"),
        (empty_accessor, "empty accessors"),
        (large_views, "its views claim"),
        (lambda h: h.update(accessors=[7]), "accessors are not a list of objects"),
        (picture_elsewhere, "outside its binary chunk"),
        (many_pieces, "more than 20000 primitives"),
    ],
)  # fmt: skip
def test_headers_that_would_do_harm_are_refused(change, said):
    assert said in refusal(edited(GOOD, change))


def test_too_many_faces_are_refused():
    with pytest.raises(BackendError, match="has 12 triangles; 1 to 11"):
        inspect_glb(GOOD, "it", most_faces=11)


@pytest.mark.parametrize("faces", [1_500_000, 2_000_001, 10_000_000])
def test_a_claim_of_too_many_faces_is_refused_before_they_are_read(faces):
    raw = claiming(GOOD, faces)
    assert len(raw) < 8 * 2**20
    if faces > 2_000_000:
        assert f"has {faces} triangles; 1 to 2000000 are allowed" in refusal(raw)
    else:
        assert inspect_glb(raw, "it")["meshes"]


def many(header: dict) -> None:
    """Add 50 more nodes with the mesh."""
    node = next(k for k, n in enumerate(header["nodes"]) if "mesh" in n)
    first = len(header["nodes"])
    header["nodes"] += [dict(header["nodes"][node]) for _ in range(50)]
    header["scenes"][0]["nodes"] += list(range(first, first + 50))


def test_repeated_meshes_count_each_time(monkeypatch):
    with pytest.raises(BackendError, match=f"has {51 * 12} triangles"):
        inspect_glb(edited(GOOD, many), "it", most_faces=600)
    raw = glb(trimesh.Trimesh(np.random.default_rng(0).random((90, 3)), [[0, 1, 2]], process=False))
    with pytest.raises(BackendError, match=f"has {51 * 90} vertices; at most 600 are allowed"):
        inspect_glb(edited(raw, many), "it", most_faces=200)
    monkeypatch.setattr(inspection.bounds, "MOST_PARTS", 50)
    assert "has 51 primitives; at most 50" in refusal(edited(GOOD, many))


@pytest.mark.parametrize(
    ("picture", "said"),
    [
        (png(9000, 9000), "9000 x 9000 pixels"),
        (png(60_000, 60_000), "60000 x 60000 pixels"),
        (b"<html>", "texture that cannot be read"),
    ],
)
@pytest.mark.filterwarnings("ignore::PIL.Image.DecompressionBombWarning")
def test_bombs_and_broken_pictures_are_refused(picture, said):
    assert said in refusal(painted_with(GOOD, picture))


def shows(*pictures: bytes) -> Callable[[dict], None]:
    """Return a function that adds a material for each picture to a file."""

    def change(header: dict) -> None:
        header["images"] = [{"uri": data_uri(p)} for p in pictures]
        header["textures"] = [{"source": k} for k in range(len(pictures))]
        header["materials"] = [
            {"pbrMetallicRoughness": {"baseColorTexture": {"index": k}}}
            for k in range(len(pictures))
        ]

    return change


def test_pictures_are_bounded_together_and_equal_ones_count_once():
    different = edited(GOOD, shows(*(png(5000, 5000 + k) for k in range(6))))
    assert "has textures with more than 134217728 pixels in total" in refusal(different)
    inspect_glb(edited(GOOD, shows(*[png(5000, 5000)] * 40)), "it")
    two = edited(GOOD, shows(png(10, 10), png(10, 11)))
    inspect_glb(two, "it", most_texels=210)
    with pytest.raises(BackendError, match="more than 209 pixels in total"):
        inspect_glb(two, "it", most_texels=209)


def test_pictures_that_are_never_looked_at_are_never_decoded(monkeypatch):
    """Only a material's base colour is decoded; a bomb as a normal map has no effect."""

    def bump(header: dict) -> None:
        bomb = "data:image/png;base64," + base64.b64encode(png(9000, 9000)).decode()
        header["images"].append({"uri": bomb})
        header["textures"].append({"source": 1})
        look = header["materials"][0]
        look["normalTexture"] = {"index": 1}
        gloss = {"diffuseTexture": {"index": 1}, "specularGlossinessTexture": {"index": 1}}
        look["extensions"] = {"KHR_materials_pbrSpecularGlossiness": gloss}

    monkeypatch.setattr("generator.sandbox.runner.is_inside", lambda: True)
    opened = []
    load = ImageFile.ImageFile.load
    monkeypatch.setattr(
        ImageFile.ImageFile, "load", lambda image: (opened.append(image.size), load(image))[1]
    )
    mesh = normal_mesh(edited(GOOD, bump), "it")
    assert mesh.texture.shape == (64, 64, 3)
    assert {*opened} == {(64, 64)}


def test_the_old_form_of_materials_has_its_diffuse_picture_checked_and_shown():
    def gloss(header: dict) -> None:
        look = header["materials"][0]
        old = {"diffuseTexture": look.pop("pbrMetallicRoughness")["baseColorTexture"]}
        look["extensions"] = {"KHR_materials_pbrSpecularGlossiness": old}

    raw = edited(GOOD, gloss)
    assert np.array_equal(normal_mesh(raw, "it").texture, normal_mesh(GOOD, "it").texture)
    with pytest.raises(BackendError, match="more than 4095 pixels"):
        inspect_glb(raw, "it", most_texels=4095)


def test_large_files_are_refused(monkeypatch):
    monkeypatch.setattr(inspection.bounds, "MOST_BYTES", len(GOOD) - 1)
    assert "MiB; at most" in refusal(GOOD)


@pytest.mark.parametrize("bad", [np.nan, np.inf, -np.inf, 1e39])
def test_vertices_must_be_finite(bad):
    mesh = trimesh.creation.box()
    stream = io.BytesIO()
    mesh.export(stream, file_type="obj")
    text = stream.getvalue().replace(b"v -0.5", f"v {bad}".encode(), 1)
    assert f"v {bad}".encode() in text
    with pytest.raises(BackendError, match=r"the file: (contains NaN or infinity|cannot be read)"):
        read_surface(text, "the file:", "obj")


def test_obj_files_are_text_with_faces():
    inspect_obj(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "it")
    with pytest.raises(BackendError, match="has 0 faces"):
        inspect_obj(b"v 0 0 0\n", "it")
    with pytest.raises(BackendError, match="has 2 faces; 1 to 1"):
        inspect_obj(b"f 1 2 3\nf 1 2 3\n", "it", most_faces=1)
    with pytest.raises(BackendError, match="has 4 vertices; at most 3"):
        inspect_obj(b"f 1 2 3" + b"\nv 0 0 0" * 4, "it", most_faces=1)
    corners = b"".join(b"v %d %d 0\n" % (k, k * k) for k in range(9))
    fan = corners + b"f " + b" ".join(b"%d" % (k + 1) for k in range(9)) + b"\n"
    assert len(read_surface(fan, "it", "obj", most_faces=7).faces) == 7
    folded = fan.replace(b"f 1 2 ", b"f 1 \\\n2 ")
    assert len(read_surface(folded, "it", "obj", most_faces=7).faces) == 7
    with pytest.raises(BackendError, match="has 7 triangles; 1 to 6 are allowed"):
        read_surface(fan, "it", "obj", most_faces=6)
    with pytest.raises(BackendError, match="not text"):
        inspect_obj(b"v\0\0", "it")
    with pytest.raises(BackendError, match="cannot be read"):
        read_surface(b"v 0 0 0\nf 1 2 99\n", "it", "obj")
    with pytest.raises(BackendError, match="not 3D points"):
        read_surface(b"v 0 0\nv 1 0\nv 0 1\nf 1 2 3\n", "it", "obj")


def chained(links: int) -> bytes:
    """Return a GLB whose mesh hangs on a chain of nodes, each a millimetre above the other."""

    def hang(header: dict) -> None:
        lift = {"translation": [0, 0, 0.001]}
        header["nodes"] = [{**lift, "children": [k + 1]} for k in range(links - 1)]
        header["nodes"].append({**lift, "mesh": 0})
        header["scenes"] = [{"nodes": [0]}]

    return edited(GOOD, hang)


@pytest.mark.slow
def test_a_chain_of_nodes_takes_time_in_proportion_to_its_length():
    began = time.process_time()
    surface = read_surface(chained(10_000), "it", "glb")
    assert time.process_time() - began < 10
    plain = read_surface(GOOD, "it", "glb")
    np.testing.assert_allclose(surface.vertices, plain.vertices + np.array([0, 0, 10]), atol=1e-6)
    assert "has 100000 nodes; at most 20000" in refusal(chained(100_000))


def test_nodes_put_meshes_where_they_always_did():
    """The result equals trimesh's positions for rotated, scaled and nested meshes."""
    rng = np.random.default_rng(3)

    def nest(header: dict) -> None:
        turn = rng.normal(size=(3, 4))
        header["nodes"] = [
            {"translation": [1, 2, 3], "rotation": turn[0].tolist(), "children": [1, 2]},
            {"matrix": np.diag([2.0, 3.0, -1.0, 1.0]).ravel().tolist(), "children": [3]},
            {"scale": [1, 2, 0.5], "rotation": turn[1].tolist(), "mesh": 0},
            {"rotation": turn[2].tolist(), "translation": [0, 1, 0], "mesh": 0},
            {"mesh": 0},
        ]
        header["scenes"] = [{"nodes": [0]}, {"nodes": [4]}]

    raw = edited(GOOD, nest)
    scene = trimesh.load_scene(io.BytesIO(raw), file_type="glb", process=False)
    wanted = np.concatenate([part.vertices for part in scene.dump()])
    found = read_surface(raw, "it", "glb").vertices
    assert len(found) == len(wanted) == 2 * 36
    order = [np.lexsort(np.round(points, 5).T) for points in (found, wanted)]
    np.testing.assert_allclose(found[order[0]], wanted[order[1]], atol=1e-5)


@pytest.mark.parametrize(
    ("name", "entries"),
    [("materials", 5001), ("images", 5001), ("textures", 5001), ("accessors", 100_001),
     ("bufferViews", 100_001), ("meshes", 20_001), ("buffers", 101), ("scenes", 5001)],
)  # fmt: skip
def test_lists_of_a_header_are_bounded(name, entries):
    raw = edited(GOOD, lambda header: header.update({name: [{}] * entries}))
    assert f"has {entries} {name}; at most" in refusal(raw)


def test_lines_points_and_what_is_not_shown_are_never_parsed():
    def more(header: dict) -> None:
        piece = header["meshes"][0]["primitives"][0]
        header["meshes"][0]["primitives"] += [{**piece, "mode": 1}, {**piece, "mode": 0}]
        header["meshes"].append({"primitives": [{**piece, "material": 10**9}]})
        nowhere = {"bufferView": 0, "byteOffset": 10**9, "componentType": 5126}
        header["accessors"].append({**nowhere, "count": 1, "type": "MAT4"})
        header["images"].append({"uri": "data:image/x-eps;base64,JSFQUw=="})
        header["cameras"] = header["animations"] = header["skins"] = [7]
        header["extras"] = {"a": [[]]}

    assert len(read_surface(edited(GOOD, more), "it", "glb").faces) == 12


def test_a_texture_in_a_rare_format_is_refused():
    assert "cannot be read" in refusal(painted_with(GOOD, b"%!PS-Adobe-3.0 EPSF-3.0\n"))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        (b"v 0 0 0\n" * 3 + b"usemtl a\nf 1 2 3\nusemtl b\nf 1 2 3\n" * 10_000, "20000 times"),
        (b"v 0 0 0\n" * 3 + b"use\\\nmtl a\nf 1 2 3\n" * 3000, "3000 times"),
        (b"v 0 0 0\n" * 3 + b"o a\ng b\nf 1 2 3\n" * 1500, "3000 times"),
        (b"v 0 0 0\nf 1 1 1\n#" + b"x" * 70_000, "a line that exceeds the limit of 65536 bytes"),
        (b"v 0 0 0\nf 1 1 1\n" + b"vn 0 0 1\n" * 301, "301 lines 'vn'; at most 300"),
        (b"v 0 0 0\nf" + b" 1" * 103, "has 101 triangles; 1 to 100"),
    ],
    ids=["materials", "folded", "objects", "line", "normals", "corners"],
)
def test_an_obj_is_bounded_before_it_is_parsed(text, said):
    with pytest.raises(BackendError, match=re.escape(said)):
        inspect_obj(text, "it", most_faces=100 if said[:3] in ("301", "has") else 2_000_000)


@pytest.mark.filterwarnings("ignore")
@pytest.mark.parametrize("seed", range(3))
def test_whatever_is_damaged_is_read_or_refused(seed):
    """Changes of bytes, header digits or single bits raise nothing but BackendError."""
    rng = np.random.default_rng(seed)
    header = 20 + struct.unpack("<I", GOOD[12:16])[0]
    digits = [k for k in range(20, header) if chr(GOOD[k]).isdigit()]
    outcomes = set()
    for _ in range(12):
        for place, value in (
            (rng.integers(20, header), rng.integers(32, 127)),
            (rng.integers(header, len(GOOD)), rng.integers(0, 256)),
            (rng.choice(digits), rng.integers(48, 58)),
            (rng.integers(0, 20), rng.integers(0, 256)),
        ):
            raw = bytearray(GOOD)
            raw[place] = value
            try:
                normal_mesh(bytes(raw), "it", to=Normal(texture=64))
                outcomes.add("read")
            except BackendError:
                outcomes.add("refused")
    assert outcomes == {"read", "refused"}


def test_faces_without_vertices_are_refused():
    raw = GOOD.replace(np.arange(12, dtype="<u4").tobytes(), np.full(12, 99, "<u4").tobytes())
    assert raw != GOOD
    with pytest.raises(BackendError, match="faces refer to missing vertices"):
        read_surface(raw, "it", "glb")


@pytest.mark.parametrize("accessor", [[0], "0", 10**30, 99, -(10**9), None])
@pytest.mark.parametrize("name", ["COLOR_0", "TEXCOORD_0", "indices"])
def test_columns_that_are_not_there_are_refused(name: str, accessor: object) -> None:
    def point(header: dict) -> None:
        piece = header["meshes"][0]["primitives"][0]
        (piece if name == "indices" else piece["attributes"])[name] = accessor

    with pytest.raises(BackendError):
        normal_mesh(edited(GOOD, point), "the answer:")


def test_texture_coordinates_of_one_number_count_as_none() -> None:
    lines = ["mtllib m.mtl", *(f"v {x} {y} {z}" for x in (0, 1) for y in (0, 1) for z in (0, 1))]
    lines += [f"vt 0.{k}" for k in range(1, 9)] + ["usemtl m", "f 1/1 2/2 3/3", "f 5/5 6/6 7/7"]
    stream = io.BytesIO()
    Image.new("RGB", (4, 4)).save(stream, "PNG")
    beside = {"m.mtl": b"newmtl m\nmap_Kd t.png\n", "t.png": stream.getvalue()}
    surface = read_surface("\n".join(lines).encode(), "it", "obj", beside)
    assert surface.uv.shape == (len(surface.vertices), 2) and not surface.uv.any()
