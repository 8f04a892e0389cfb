"""Results of other methods: read as specified, scored like ours, rejected if invalid."""

import json
import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from command import Shell, command
from PIL import Image

from generator.errors import InputError
from generator.evaluation import collisions, load_external, soundness
from generator.evaluation.external import TRANSFORMS
from generator.scene import Scene

pytestmark = pytest.mark.usefixtures("inline")

Y_UP = np.array([[1.0, 0, 0, 0], [0, 0, 1, 0], [0, -1, 0, 0], [0, 0, 0, 1]])  # z up to y up


def matrix(position=(0.0, 0.0, 0.0), yaw: float = 0.0, scale=(1.0, 1.0, 1.0)) -> list[list[float]]:
    c, s = np.cos(yaw), np.sin(yaw)
    made = np.eye(4)
    made[:3, :3] = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) * scale
    made[:3, 3] = position
    return made.tolist()


def glb(path: Path, extents=(0.1, 0.1, 0.1), color=(200, 40, 40, 255), up: str = "y") -> None:
    box = trimesh.creation.box(extents=extents)
    box.visual = trimesh.visual.ColorVisuals(box, face_colors=color)
    if up == "y":
        box.apply_transform(Y_UP)
    path.write_bytes(trimesh.Scene([box]).export(file_type="glb"))


def write(folder: Path, payload: Any) -> Path:
    (folder / TRANSFORMS).write_text(json.dumps(payload))
    return folder


def payload(*objects: dict[str, Any], **changes: Any) -> dict[str, Any]:
    table = {"glb": "table.glb", "matrix": matrix((0, 0, 0.37))}
    return {
        "name": "other-1",
        "method": "other",
        "table": table,
        "objects": list(objects),
    } | changes


def thing(name: str, position, **more: Any) -> dict[str, Any]:
    return {"name": name, "glb": "box.glb", "matrix": matrix(position)} | more


def loaded(folder: Path, *objects: dict[str, Any], **changes: Any) -> Scene:
    return load_external(write(folder, payload(*objects) | changes), decompose=False)


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    glb(tmp_path / "table.glb", (1.2, 0.7, 0.74), (180, 150, 120, 255))
    glb(tmp_path / "box.glb", (0.2, 0.1, 0.06))
    return tmp_path


def test_poses_sizes_and_names_are_what_the_file_states(folder: Path) -> None:
    scene = loaded(
        folder,
        thing("book_1", (0.1, 0.05, 0.77), label="red book"),
        thing("book_2", (0, 0, 0), matrix=matrix((-0.3, 0.1, 0.8), 0.5, (0.5, 1, 2))),
    )
    first, second = scene.objects
    assert scene.name == "other-1"
    assert np.allclose(scene.table.scale, [1.2, 0.7, 0.74])
    assert np.allclose(np.sort(np.abs(scene.table.outline), 0)[-1], [0.6, 0.35])
    assert (first.label, second.label) == ("red book", "book")
    assert np.allclose(first.scale, [0.2, 0.1, 0.06])
    assert np.allclose(first.pose.position, [0.1, 0.05, 0.77])
    assert np.allclose(second.scale, [0.1, 0.1, 0.12])
    assert second.placement.yaw == pytest.approx(0.5)
    assert np.allclose(second.pose.position, [-0.3, 0.1, 0.8])
    assert tuple(first.model.mesh.texture[0, 0]) == (200, 40, 40)
    assert "unsuitable for simulation" in scene.provenance.warnings[0]


def test_the_world_is_shifted_so_that_the_table_stands_under_the_origin(folder: Path) -> None:
    table = {"glb": "table.glb", "matrix": matrix((5, 5, 5.37))}
    scene = loaded(folder, thing("book_1", (5.1, 5, 5.77)), table=table)
    assert np.allclose(scene.objects[0].pose.position, [0.1, 0, 0.77])
    assert np.allclose(scene.table.height, 0.74)


def join(path: Path, *solids: trimesh.Trimesh) -> None:
    """Write solids as one mesh, z up."""
    whole = trimesh.util.concatenate(list(solids))
    whole.visual = trimesh.visual.ColorVisuals(whole, face_colors=(180, 150, 120, 255))
    path.write_bytes(trimesh.Scene([whole]).export(file_type="glb"))


def block(extents: tuple[float, float, float], middle: tuple[float, float, float]) -> Any:
    made = trimesh.creation.box(extents=extents)
    made.apply_translation(middle)
    return made


TOP = block((1.2, 0.7, 0.03), (0, 0, 0.725))
LEGS = [block((0.05, 0.05, 0.71), (x, y, 0.355)) for x in (-0.5, 0.5) for y in (-0.3, 0.3)]
SHELF = block((1.1, 0.6, 0.02), (0, 0, 0.2))


@pytest.mark.parametrize("turned", [False, True])
def test_things_rest_on_a_tables_top_and_not_on_its_rim(folder: Path, turned: bool) -> None:
    """A rim 8 mm high with a shelf below; surfaces of a file may face inwards."""
    rim = [block((1.2, 0.02, 0.038), (0, y, 0.729)) for y in (-0.34, 0.34)]
    rim += [block((0.02, 0.7, 0.038), (x, 0, 0.729)) for x in (-0.59, 0.59)]
    parts = [p.copy() for p in (TOP, *LEGS, SHELF, *rim)]
    if turned:
        for part in parts:
            part.invert()
    join(folder / "table.glb", *parts)
    glb(folder / "box.glb", (0.2, 0.1, 0.06), up="z")
    table = {"glb": "table.glb", "matrix": matrix()}
    scene = load_external(
        write(folder, payload(thing("book_1", (0, 0, 0.77)), table=table, up="z"))
    )
    assert scene.table.height == pytest.approx(0.748)
    assert np.allclose(np.abs(scene.table.outline), [0.6, 0.35])
    found = soundness(scene)
    assert (found.stable, found.floating, found.off_table) == (True, (), ())
    assert found.objects[0].drift < 1e-3


@pytest.mark.parametrize(
    ("parts", "words"),
    [
        ([trimesh.creation.cone(radius=0.5, height=0.7)], "extends 70 cm"),
        ([trimesh.creation.icosphere(radius=0.4)], "no level surface"),
        ([TOP, *LEGS, block((1.2, 0.02, 0.3), (0, 0.34, 0.89))], "extends 30 cm"),
    ],
)
def test_a_table_without_a_plain_top_is_refused(folder: Path, parts: list[Any], words: str) -> None:
    join(folder / "table.glb", *parts)
    table = {"glb": "table.glb", "matrix": matrix()}
    with pytest.raises(InputError, match=words):
        load_external(write(folder, payload(table=table, up="z")))


def test_a_method_without_a_table_gets_a_block(folder: Path) -> None:
    table = {"size": [1.0, 0.8, 0.7], "top": [0, 0, 0]}
    scene = loaded(folder, thing("book_1", (0, 0, 0.03)), table=table)
    assert np.allclose(scene.table.scale, [1, 0.8, 0.7])
    assert np.allclose(scene.objects[0].pose.position, [0, 0, 0.73])


def test_files_that_are_z_up_are_taken_as_they_are(folder: Path) -> None:
    glb(folder / "box.glb", (0.2, 0.1, 0.06), up="z")
    glb(folder / "table.glb", (1.2, 0.7, 0.74), up="z")
    scene = loaded(folder, thing("book_1", (0, 0, 0.77)), up="z")
    assert np.allclose(scene.objects[0].scale, [0.2, 0.1, 0.06])


def test_a_foreign_scene_is_scored_as_ours(folder: Path) -> None:
    entries = (thing("book_1", (0, 0, 0.77)), thing("book_2", (0.19, 0, 0.77)),
               thing("book_3", (-0.3, 0, 0.87)))  # fmt: skip
    scene = load_external(write(folder, payload(*entries)))
    found = collisions(scene)
    assert [(o.a, o.b) for o in found.overlaps] == [("book_1", "book_2")]
    assert found.overlaps[0].depth == pytest.approx(0.01, abs=3e-4)
    assert "book_3" in soundness(scene).floating


def test_the_command_takes_a_foreign_folder(folder: Path, shell: Shell) -> None:
    write(folder, payload(thing("book_1", (0, 0, 0.77))))
    assert command("evaluate", str(folder)) == 0
    write(folder, payload(thing("book_1", (0, 0, 0.9))))
    (scene,) = shell("evaluate", str(folder), "--json", code=1).facts["scenes"]
    assert {f["kind"] for f in scene["findings"]} == {"floats", "unstable"}


def test_a_textured_file_keeps_its_texture(folder: Path) -> None:
    box = trimesh.creation.box(extents=(0.1, 0.1, 0.1))
    image = Image.fromarray(np.full((4, 4, 3), (10, 200, 30), np.uint8))
    box.visual = trimesh.visual.TextureVisuals(
        uv=np.random.default_rng(0).random((len(box.vertices), 2)),
        material=trimesh.visual.material.PBRMaterial(baseColorTexture=image),
    )
    (folder / "box.glb").write_bytes(trimesh.Scene([box]).export(file_type="glb"))
    scene = loaded(folder, thing("box_1", (0, 0, 0.79)))
    texture = scene.objects[0].model.mesh.texture
    assert texture.shape == (4, 4, 3)
    assert (texture == (10, 200, 30)).all()


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"up": "x"}, "'up' must be"),
        ({"objects": {}}, "list of at most"),
        ({"objects": [{"name": "a", "matrix": matrix()}]}, "the name of a file"),
        ({"objects": [{"glb": "box.glb"}]}, "needs a 'name'"),
        ({"objects": [thing("a", (0, 0, 0), glb="../box.glb")]}, "leaves the bundle"),
        ({"objects": [thing("a", (0, 0, 0), glb="/etc/passwd")]}, "leaves the bundle"),
        ({"objects": [thing("a", (0, 0, 0), glb="none.glb")]}, "missing"),
        ({"objects": [thing("a", (0, 0, 0), glb=TRANSFORMS)]}, "not a GLB"),
        ({"objects": [thing("a", (0, 0, 0), matrix=[[1, 2], [3, 4]])]}, "4 x 4 finite"),
        ({"objects": [thing("a", (0, 0, 0), matrix="up")]}, "numbers"),
        ({"objects": [thing("a", (0, 0, 0), matrix=matrix(scale=(-1, 1, 1)))]}, "mirrors"),
        ({"objects": [thing("a", (0, 0, 0), matrix=matrix(scale=(0, 1, 1)))]}, "not singular"),
        ({"objects": [thing("a", (0, 0, 0), matrix=matrix(scale=(1e3,) * 3))]}, "in metres"),
        ({"objects": [thing("a", (9e9, 0, 0))]}, "must be in metres"),
        ({"objects": [thing("a", (0, 0, 0), on="nothing")]}, "Available: table"),
        ({"objects": [thing("a", (0, 0, 0)), thing("a", (1, 0, 0))]}, "unique"),
        ({"table": None}, "'table' must"),
        ({"table": {"size": [1, 1, 0]}}, "must be positive"),
        *(  # of other types, or not to be printed
            (changes, "")
            for changes in (
                {"up": {}}, {"up": []}, {"name": "a\x1b[2J"}, {"name": 5}, {"method": "\x07"},
                {"objects": [{"name": "a\nb", "glb": "box.glb", "matrix": matrix()}]},
                {"objects": [thing("a", (0, 0, 1), label="\x1b[31m")]},
                {"objects": [thing("a", (0, 0, 1), on=["table"])]},
                {"objects": [thing("a", (0, 0, 1), inside="no")]},
            )
        ),
    ],
)  # fmt: skip
def test_what_is_wrong_is_said(folder: Path, changes: dict[str, Any], words: str) -> None:
    with pytest.raises(InputError) as told:
        loaded(folder, **changes)
    assert re.search(words, str(told.value)) and str(told.value).isprintable()


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("{", "not valid JSON"),
        ("[]", "a JSON object"),
        ('{"name": NaN}', "NaN"),
        ("[" * 100_000, "json nests lists or objects deeper"),
    ],
)
def test_a_damaged_list_of_transforms_is_refused(folder: Path, text: str, words: str) -> None:
    (folder / TRANSFORMS).write_text(text)
    with pytest.raises(InputError, match=words):
        load_external(folder)


def test_faces_of_vertices_that_are_not_there_and_chains_of_nodes_are_refused(folder: Path) -> None:
    box = trimesh.Trimesh(np.eye(3), [[0, 1, 2]], process=False)
    raw = trimesh.Scene([box]).export(file_type="glb")
    index = np.array([0, 1, 2], "<u4").tobytes()
    assert raw.count(index) == 1
    (folder / "box.glb").write_bytes(raw.replace(index, np.array([0, 1, 9], "<u4").tobytes()))
    with pytest.raises(InputError, match=r"damaged|cannot be read"):
        loaded(folder, thing("a", (0, 0, 1)))
    links = [{"children": [k + 1]} for k in range(20_000)] + [{"mesh": 0}]
    size = int.from_bytes(raw[12:16], "little")
    header = json.dumps(json.loads(raw[20 : 20 + size]) | {"nodes": links}).encode()
    header += b" " * (-len(header) % 4)
    rest = raw[20 + size :]
    words = (2, 20 + len(header) + len(rest), len(header), 0x4E4F534A)
    start = b"glTF" + b"".join(word.to_bytes(4, "little") for word in words)
    (folder / "box.glb").write_bytes(start + header + rest)
    with pytest.raises(InputError, match="20001 nodes"):
        loaded(folder, thing("a", (0, 0, 1)))


def test_a_damaged_or_empty_glb_is_refused(folder: Path) -> None:
    write(folder, payload(thing("box_1", (0, 0, 0.77))))
    whole = (folder / "box.glb").read_bytes()
    for content in (whole[:60], b"glTF" + b"\xff" * 200, whole[:-40], b""):
        (folder / "box.glb").write_bytes(content)
        with pytest.raises(InputError, match=r"box\.glb"):
            load_external(folder, decompose=False)


def test_a_glb_with_nan_is_refused(folder: Path) -> None:
    box = trimesh.creation.box(extents=(0.1, 0.1, 0.1))
    raw = bytearray(trimesh.Scene([box]).export(file_type="glb"))
    place = raw.find(np.float32(0.05).tobytes(), raw.find(b"BIN\x00"))
    raw[place : place + 4] = np.float32("nan").tobytes()
    (folder / "box.glb").write_bytes(bytes(raw))
    with pytest.raises(InputError, match="NaN"):
        loaded(folder, thing("box_1", (0, 0, 0.77)))


def test_a_link_out_of_the_folder_is_not_followed(folder: Path, tmp_path: Path) -> None:
    outside = tmp_path / "outside"
    outside.mkdir()
    (folder / "box.glb").rename(outside / "box.glb")
    (folder / "box.glb").symlink_to(outside / "box.glb")
    with pytest.raises(InputError, match="link"):
        loaded(folder, thing("box_1", (0, 0, 0.77)))
