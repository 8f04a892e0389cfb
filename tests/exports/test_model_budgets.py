"""One budget for all scenes, nodes and copies of a foreign model, checked before parsing."""

import json
import struct
import xml.etree.ElementTree as ET
import zlib
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from foreign_models import CUBE, TABLE, write

from generator.errors import BackendError, InputError
from generator.imports import folder as folders
from generator.imports import mjcf
from generator.imports.folder import read_folder
from generator.imports.glb import read_glb
from generator.imports.mjcf_files import gather
from generator.meshes.reading.inspection import inspect_glb


def packed(changes: dict[str, Any], faces: int = 80_000) -> bytes:
    """A GLB with one mesh of so many triangles, all on the same three points, and such nodes."""
    data = np.eye(3, dtype="<f4").tobytes() + np.tile(np.arange(3, dtype="<u2"), faces).tobytes()
    tree = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1}]}],
        "buffers": [{"byteLength": len(data)}],
        "bufferViews": [
            {"buffer": 0, "byteLength": 36},
            {"buffer": 0, "byteOffset": 36, "byteLength": len(data) - 36},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": 3 * faces, "type": "SCALAR"},
        ],
        **changes,
    }
    text = json.dumps(tree).encode()
    text += b" " * (-len(text) % 4)
    data += bytes(-len(data) % 4)
    head = struct.pack("<4sIII4s", b"glTF", 2, 28 + len(text) + len(data), len(text), b"JSON")
    return head + text + struct.pack("<I4s", len(data), b"BIN\0") + data


def stand(count: int, **extras: object) -> list[dict[str, Any]]:
    return [{"name": f"n{k}", "mesh": 0, "extras": extras} for k in range(count)]


TABLE_NODE = {"name": "table", "mesh": 0, "extras": {"fixed": True}}
MUG_NODE = {"name": "a", "mesh": 0, "extras": {"body": "a"}}


def test_shapes_of_the_collision_scene_count(tmp_path: Path) -> None:
    nodes = [TABLE_NODE, MUG_NODE, *stand(40, body="a", kind="hull")]
    scenes = [{"nodes": [0, 1]}, {"name": "collision", "nodes": [*range(2, 42)]}]
    path = tmp_path / "it.glb"
    path.write_bytes(packed({"nodes": nodes, "scenes": scenes}))
    with pytest.raises(BackendError, match="has 3360000 triangles"):
        read_glb(path)


def test_scenes_that_share_nodes_count_each() -> None:
    changes = {"nodes": stand(10), "scenes": [{"nodes": [*range(10)]}] * 3}
    with pytest.raises(BackendError, match="has 2400000 triangles"):
        inspect_glb(packed(changes), "it")
    inspect_glb(packed(changes, 10), "it")


def test_nodes_of_all_scenes_count_together() -> None:
    chain = [{"children": [k + 1]} for k in range(9_999)] + [{"mesh": 0}]
    changes = {"nodes": chain, "scenes": [{"nodes": [0]}] * 3}
    with pytest.raises(BackendError, match="more than 20000 nodes in its scenes"):
        inspect_glb(packed(changes, 10), "it")
    changes = {"nodes": chain, "scenes": [{"nodes": [0]}] * 2}
    inspect_glb(packed(changes, 10), "it")


def test_another_scene_than_the_first_may_be_the_one_shown(tmp_path: Path) -> None:
    nodes = [TABLE_NODE, MUG_NODE, *stand(40)]
    scenes = [{"nodes": [0, 1, *range(2, 42)]}, {"nodes": [0, 1]}]
    path = tmp_path / "it.glb"
    path.write_bytes(packed({"nodes": nodes, "scenes": scenes, "scene": 1}))
    with pytest.raises(BackendError, match="triangles"):
        read_glb(path)


# -------------------------------------------------------------------------------------------- MJCF


def nested(depth: int, inner: str, count: int = 200) -> str:
    return f'<replicate count="{count}" offset="0 0 .1">' * depth + inner + "</replicate>" * depth


@pytest.mark.parametrize(
    ("inner", "depth"),
    [('<geom size=".01"/>', 2), ('<geom size=".01"/>', 3), ("<site/>", 3), ("<body/>", 12)],
)
def test_nested_replicates_multiply(inner: str, depth: int, tmp_path: Path) -> None:
    path = write(tmp_path, TABLE + CUBE + nested(depth, inner))
    with pytest.raises(InputError, match="including replicated ones"):
        gather(path)


def test_a_replicate_within_bounds_is_expanded(tmp_path: Path, read) -> None:
    many = nested(2, '<geom type="box" size=".01 .01 .01" pos="1 2 -5"/>', 5)
    found = read(write(tmp_path, TABLE + CUBE + many))
    assert len(found.objects) == 1


@pytest.mark.parametrize("count", ["-5", "nan", "inf", "1e300", "many", "", "201"])
def test_odd_counts_of_copies_are_refused(count: str, tmp_path: Path, read) -> None:
    many = f'<replicate count="{count}"><geom size=".01"/></replicate>'
    with pytest.raises(InputError):
        read(write(tmp_path, TABLE + CUBE + many))


def png_head(width: int, height: int) -> bytes:
    body = b"IHDR" + struct.pack(">IIBBBBB", width, height, 8, 0, 0, 0, 0)
    return b"\x89PNG\r\n\x1a\n" + struct.pack(">I", 13) + body + struct.pack(">I", zlib.crc32(body))


BUILTIN = '<texture name="t{0}" type="{1}" builtin="flat" width="{2}" height="{3}" {4}/>'


@pytest.mark.parametrize(
    "textures",
    [
        BUILTIN.format("", "2d", 26_000, 26_000, ""),
        BUILTIN.format("", "cube", 4_000, 1, ""),
        BUILTIN.format("", "2d", 4_000, 4_000, 'nchannel="1000"'),
        BUILTIN.format("", "2d", "1e5", "inf", ""),
        "".join(BUILTIN.format(k, "2d", 8_000, 8_000 - k, "") for k in range(3)),
        '<texture name="t" type="2d" file="large.png"/>',
        "".join(f'<texture name="t{k}" type="2d" file="{k}.png"/>' for k in range(3)),
        '<texture name="t" type="cube" gridsize="1 2" gridlayout=".U" file="tall.png"/>',
    ],
)
def test_texels_count_before_any_is_made(textures: str, tmp_path: Path) -> None:
    (tmp_path / "large.png").write_bytes(png_head(24_000, 24_000))
    (tmp_path / "tall.png").write_bytes(png_head(5_000, 10_000))
    for k in range(3):
        (tmp_path / f"{k}.png").write_bytes(png_head(8_000, 8_000 - k))
    with pytest.raises(InputError, match="texels"):
        gather(write(tmp_path, head=f"<asset>{textures}</asset>"))


def test_equal_textures_are_one(tmp_path: Path) -> None:
    (tmp_path / "some.png").write_bytes(png_head(8_000, 8_000))
    names = ("a", "b", "c")
    assets = "".join(f'<texture name="{n}" type="2d" file="some.png"/>' for n in names)
    assets += "".join(f'<material name="m{n}" texture="{n}"/>' for n in names)
    found = ET.fromstring(gather(write(tmp_path, head=f"<asset>{assets}</asset>")).xml)
    assert [texture.get("name") for texture in found.iter("texture")] == ["a"]
    assert [material.get("texture") for material in found.iter("material")] == ["a"] * 3


@pytest.mark.parametrize("count", ["x", "-1", "1e9", "300"])
def test_a_count_of_copies_is_quoted(count: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=f"replicates a body '{count}' times; only whole numbers"):
        gather(write(tmp_path, TABLE + CUBE + f'<replicate count="{count}"><site/></replicate>'))


@pytest.mark.parametrize(
    "sizes",
    [
        '<size nuser_body="200000000"/>',
        '<size nuserdata="290000000" nkey="100000000"/>',
        '<size memory="100G"/>',
        '<sensor><user name="u" dim="500000000"/></sensor>',
        '<custom><numeric name="n" size="500000000" data="0"/></custom>',
        '<keyframe><key name="k"/></keyframe>',
        '<actuator><general body="cube" dyntype="user" actdim="1000000000"/></actuator>',
        '<compiler><lengthrange mode="all" inttotal="1e9" timestep="1e-9"/></compiler>'
        '<actuator><general body="cube"/></actuator>',
    ],
)
def test_what_only_takes_memory_or_time_is_left_out(sizes: str, tmp_path: Path, read) -> None:
    found = gather(write(tmp_path, head=sizes))
    assert "00000" not in found.xml and "<key" not in found.xml and "range" not in found.xml
    assert len(read(tmp_path / "scene.xml").objects) == 1


def test_user_data_of_bodies_is_left_out(tmp_path: Path) -> None:
    path = write(tmp_path, TABLE + CUBE.replace("<body", f'<body user="{"1 " * 9999}"'))
    assert len(gather(path).xml) < 2000


def test_a_mesh_counts_once_for_each_geom_that_shows_it(
    tmp_path: Path, read, monkeypatch: pytest.MonkeyPatch
) -> None:
    trimesh.creation.icosphere(2, 0.03).export(tmp_path / "ball.obj")  # 320 faces
    monkeypatch.setattr(mjcf, "MOST_FACES", 1000)
    head = '<asset><mesh name="m" file="ball.obj"/></asset>'
    thing = '<body pos="1 2 .8"><freejoint/><geom type="mesh" mesh="m"/></body>'
    assert len(read(write(tmp_path, TABLE + 3 * thing, head)).objects) == 3
    with pytest.raises(InputError, match="1280 triangles"):
        read(write(tmp_path, TABLE + 4 * thing, head))
    with pytest.raises(InputError, match="triangles"):  # of round shapes, which have many
        read(write(tmp_path, TABLE + thing.replace('type="mesh" mesh="m"', 'size=".03"')))


def test_meshes_count_before_they_are_parsed(tmp_path: Path) -> None:
    (tmp_path / "many.obj").write_bytes(b"v 0 0 0\n" + b"f 1 1 1\n" * 300_000)
    meshes = "".join(f'<mesh name="m{k}" file="many.obj"/>' for k in range(7))
    with pytest.raises(InputError, match="more than 2000000 faces"):
        gather(write(tmp_path, head=f"<asset>{meshes}</asset>"))


# ------------------------------------------------------------------------------------------ folder


def test_a_file_counts_once_for_each_object_of_a_folder(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    trimesh.creation.box((0.1, 0.04, 0.06)).export(tmp_path / "box.glb")
    trimesh.Trimesh(np.eye(3), [[0, 1, 2]]).export(tmp_path / "one.glb")
    thing = {"name": "box", "file": "box.glb", "position": [0.1, 0.0, 0.76]}
    monkeypatch.setattr(folders, "MOST_FACES", 30)
    small = thing | {"name": "small", "file": "one.glb"}
    poses = {"table": {"size": [1.0, 0.6, 0.74]}, "objects": [thing, thing, thing, small]}
    (tmp_path / "poses.json").write_text(json.dumps(poses))
    found = read_folder(tmp_path)
    assert [body.name for body in found.objects] == ["box", "box", "small"]
    (refused,) = found.refused
    assert "30 triangles in total" in refused.detail
