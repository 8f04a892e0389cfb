"""GLB files of other programs and of this package, read as bodies."""

import json
import struct
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.errors import BackendError, InputError
from generator.exports import export
from generator.imports import import_scene
from generator.imports.glb import read_glb

POINTS = np.array([[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]], np.float32)
FACES = np.array([[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]], np.uint16)
RED = {"attributes": {"POSITION": 0}, "indices": 1, "material": 0}
BLUE = RED | {"material": 1}
LINES = {"attributes": {"POSITION": 0}, "mode": 1}


def write_glb(path: Path, *primitives: dict[str, Any], **changes: Any) -> Path:
    """A GLB file of a table, and on it a mug that is a mesh of some primitives."""
    data = POINTS.tobytes() + FACES.tobytes()
    colors = ([1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0])
    tree = {
        "asset": {"version": "2.0"},
        "scene": 0,
        "scenes": [{"nodes": [0, 1]}],
        "nodes": [
            {"name": "table", "mesh": 0},
            {"name": "mug", "mesh": 1, "translation": [0, 0.1, 0]},
        ],
        "meshes": [{"primitives": [RED]}, {"primitives": [*primitives]}],
        "materials": [{"pbrMetallicRoughness": {"baseColorFactor": color}} for color in colors],
        "buffers": [{"byteLength": len(data)}],
        "bufferViews": [
            {"buffer": 0, "byteOffset": 0, "byteLength": POINTS.nbytes},
            {"buffer": 0, "byteOffset": POINTS.nbytes, "byteLength": FACES.nbytes},
        ],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": len(POINTS), "type": "VEC3"},
            {"bufferView": 1, "componentType": 5123, "count": FACES.size, "type": "SCALAR"},
        ],
    }
    text = json.dumps(tree | changes).encode()
    text += b" " * (-len(text) % 4)
    size = 28 + len(text) + len(data)
    head = struct.pack("<4sIII4s", b"glTF", 2, size, len(text), b"JSON")
    path.write_bytes(head + text + struct.pack("<I4s", len(data), b"BIN\0") + data)
    return path


def test_a_mesh_of_several_primitives_keeps_the_colour_of_each(tmp_path: Path) -> None:
    (mug,) = read_glb(write_glb(tmp_path / "mug.glb", RED, LINES, BLUE)).objects
    assert len(mug.surface.faces) == 2 * len(FACES)
    assert {*map(tuple, mug.surface.colors.tolist())} == {(255, 0, 0), (0, 0, 255)}
    np.testing.assert_allclose(mug.position, [0, 0, 0.1], atol=1e-9)


@pytest.mark.usefixtures("inline")
def test_a_body_without_triangles_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="'mug' has no triangles"):
        import_scene(write_glb(tmp_path / "lines.glb", LINES))


def test_names_that_an_export_uses_itself_come_back(tmp_path: Path) -> None:
    names = ["mug", "mug_collision", "mug_part_0", "y_up_collision", "collision"]
    size = (0.03, 0.04, 0.05)
    things = [toy_object(n, size, (k / 10 - 0.3, 0.0)) for k, n in enumerate(names)]
    scene = toy_scene(tuple(things)).replace(name="collision")
    found = read_glb(export(scene, "glb", tmp_path))
    assert [body.name for body in found.objects] == names
    assert [len(body.parts) for body in found.objects] == [1] * len(names)


def test_bodies_of_a_file_share_their_pictures(tmp_path: Path) -> None:
    scene = toy_scene(tuple(toy_object(n, (0.03, 0.04, 0.05), (0.0, 0.0)) for n in "ab"))
    (first,), (second,) = (
        body.surface.pictures for body in read_glb(export(scene, "glb", tmp_path)).objects
    )
    assert first is second


def test_too_many_nodes_are_told_before_any_is_read(tmp_path: Path) -> None:
    nodes = [{"mesh": 0} for _ in range(202)]
    path = write_glb(tmp_path / "many.glb", RED, nodes=nodes, scenes=[{"nodes": [*range(202)]}])
    with pytest.raises(InputError, match="201 objects; at most 200"):
        read_glb(path)


@pytest.mark.parametrize(
    ("node", "said"),
    [
        ({"extras": {"fixed": False, "mass": 10**400}}, "must be a number"),
        ({"extras": {"mass": 1, "inertia": [10**400] * 9, "fixed": False}}, "centre of mass and"),
        ({"translation": [10**400, 0, 0]}, "damaged"),
        ({"scale": [0, 0, 0]}, "must consist of a rotation, a scale and"),
        ({"mesh": 99}, "missing mesh"),
    ],
)
def test_damaged_nodes_are_refused(node: dict[str, Any], said: str, tmp_path: Path) -> None:
    table = {"name": "table", "mesh": 0, "extras": {"fixed": True}}
    mug = {"name": "mug", "mesh": 1, "extras": {"fixed": False}} | node
    with pytest.raises((InputError, BackendError), match=said):
        read_glb(write_glb(tmp_path / "it.glb", RED, nodes=[table, mug]))


def with_shapes(folder: Path, *shapes: dict[str, Any], **changes: Any) -> Path:
    """A file of a table, a mug and a cup, with these nodes in its scene "collision"."""
    nodes = [
        {"name": "table", "mesh": 0, "extras": {"fixed": True}},
        {"name": "mug", "mesh": 0, "extras": {"fixed": False}},
        {"name": "cup", "mesh": 0, "extras": {"fixed": False}, "translation": [0.2, 0, 0]},
        *shapes,
    ]
    scenes = [
        {"nodes": [0, 1, 2]}, {"nodes": [*range(3, 3 + len(shapes))], "name": "collision"},
    ]  # fmt: skip
    odd = RED | {"attributes": {"POSITION": 0, "COLOR_0": 2}}
    return write_glb(folder / "it.glb", odd, nodes=nodes, scenes=scenes, **changes)


@pytest.mark.parametrize(
    "damage",
    [{"mesh": 1}, {"mesh": 0, "scale": [0, 0, 0]}, {"mesh": 0, "matrix": [1e300] * 16}],
)
def test_damaged_collision_shapes_cost_their_body_alone(
    damage: dict[str, Any], tmp_path: Path
) -> None:
    sound = {"mesh": 0, "extras": {"body": "cup"}}
    path = with_shapes(tmp_path, {"extras": {"body": "mug"}} | damage, sound)
    found = read_glb(path)
    assert {body.name: len(body.parts) for body in found.objects} == {"mug": 0, "cup": 1}
    assert ["'mug'" in warning for warning in found.warnings] == [True]


def test_a_collision_scene_that_is_no_tree_is_left_out(tmp_path: Path) -> None:
    path = with_shapes(tmp_path, {"mesh": 0, "matrix": ["x"] * 16})
    found = read_glb(path)
    assert [len(body.parts) for body in found.objects] == [0, 0]
    assert "collision shapes cannot be read" in found.warnings[0]


def test_a_shape_of_a_mesh_that_is_not_there_is_refused(tmp_path: Path) -> None:
    with pytest.raises(BackendError, match="missing mesh"):
        read_glb(with_shapes(tmp_path, {"mesh": 99, "extras": {"body": "mug"}}))


def test_the_scene_that_a_file_shows_by_default_is_read(tmp_path: Path) -> None:
    shape = {"mesh": 0, "extras": {"body": "mug"}}
    nodes = [
        {"name": "table", "mesh": 0, "extras": {"fixed": True}},
        {"name": "mug", "mesh": 0, "extras": {"fixed": False}},
        {"name": "old mug", "mesh": 0, "extras": {"fixed": False}},
        shape,
    ]
    scenes = [{"nodes": [3], "name": "collision"}, {"nodes": [0, 2]}, {"nodes": [0, 1]}]
    found = read_glb(write_glb(tmp_path / "it.glb", RED, nodes=nodes, scenes=scenes, scene=2))
    assert [(body.name, len(body.parts)) for body in found.objects] == [("mug", 1)]


@pytest.mark.parametrize("changes", [{"scenes": []}, {"scenes": [{}]}, {"nodes": [], "scenes": []}])
def test_a_file_without_scenes_shows_all_its_trees(changes: dict[str, Any], tmp_path: Path) -> None:
    path = write_glb(tmp_path / "it.glb", RED, **changes)
    if changes.get("nodes") == []:
        with pytest.raises(InputError, match="The names of 0 nodes suggest a table"):
            read_glb(path)
        return
    assert [body.name for body in read_glb(path).objects] == ["mug"]


def test_a_header_of_another_kind_is_no_harm(tmp_path: Path) -> None:
    assert len(read_glb(write_glb(tmp_path / "it.glb", RED, asset=["2.0"])).objects) == 1
