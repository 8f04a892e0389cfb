"""Foreign scenes as bundles: MJCF, GLB and folders, rejections, and imports of exports."""

import dataclasses
import json
from pathlib import Path

import numpy as np
import pytest
import trimesh
from command import Shell
from foreign_models import CUBE, TABLE, write
from toy import toy_object, toy_scene

import assets_cache
from generator.bundle import load, verify
from generator.errors import InputError
from generator.exports import export
from generator.geometry import quaternion_matrix
from generator.imports import ImportOptions, import_scene
from generator.imports.shapes import part_of, solid_part
from generator.meshes.texture import own_texture
from generator.scene import Object, Scene

# -------------------------------------------------------------------------------------------- MJCF


def test_bodies_are_read_as_mujoco_has_them(tmp_path: Path, read) -> None:
    hammer = """
    <body name="hammer" pos="1.2 2 .77" euler="0 0 90"><freejoint/>
      <geom type="capsule" size=".01 .1" euler="0 90 0" mass=".2" rgba="1 0 0 1"/>
      <body pos=".1 0 0"><geom type="cylinder" size=".02 .05" mass=".4" friction=".9"/></body>
    </body>"""
    found = read(write(tmp_path, '<geom type="plane" size="1 1 1"/>' + TABLE + CUBE + hammer))
    assert found.table.name == "table" and [b.name for b in found.objects] == ["cube", "hammer"]
    cube, made = found.objects
    assert cube.parts[0].kind == "box" and cube.mass is not None
    assert cube.mass.mass == pytest.approx(1000 * 0.06**3)
    np.testing.assert_allclose(cube.position, [1, 2, 0.77])
    assert made.mass is not None and made.mass.mass == pytest.approx(0.6)
    np.testing.assert_allclose(made.mass.com, [0.4 * 0.1 / 0.6, 0, 0], atol=1e-6)
    assert [part.kind for part in made.parts] == ["hull", "cylinder"]
    assert made.friction == 1.0  # of its geoms the largest
    red = (made.surface.colors == [255, 0, 0]).all(1)
    assert red.any() and not red.all()


def test_the_table_is_found_by_its_name_or_by_what_stands_on_it(tmp_path: Path, read) -> None:
    stand = TABLE.replace('"table"', '"stand"')
    wall = '<body name="wall"><geom type="box" size="1 .1 2"/></body>'
    found = read(write(tmp_path, wall + stand + CUBE))
    assert found.table.name == "stand" and found.warnings == ("fixed objects are ignored: wall",)
    with pytest.raises(InputError, match=r"'desk'.*stand, wall"):
        read(tmp_path / "scene.xml", None, "desk")
    with pytest.raises(InputError, match="no table: nothing fixed is below"):
        read(write(tmp_path, wall + CUBE))
    with pytest.raises(InputError, match="no table"):
        read(write(tmp_path, '<geom type="plane" size="1 1 1"/>' + CUBE))


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (TABLE, "no free body"),
        (
            TABLE + CUBE.replace("<freejoint/>", '<joint type="hinge"/>'),
            "1 joints other than free.*cube",
        ),
        (
            TABLE
            + CUBE.replace("</body>", "<body name='lid'><joint/><geom size='.1'/></body></body>"),
            "lid",
        ),
    ],
)
def test_what_is_no_set_of_free_bodies_is_refused(body: str, said: str, tmp_path, read) -> None:
    with pytest.raises(InputError, match=said):
        read(write(tmp_path, body))


def test_too_many_objects_are_told_before_any_is_read(tmp_path: Path, read) -> None:
    many = "<body><freejoint/><geom size='.01'/></body>" * 201
    with pytest.raises(InputError, match="201 objects; at most 200"):
        read(write(tmp_path, TABLE + many))


def test_bodies_of_one_material_share_its_picture(tmp_path: Path, read) -> None:
    head = """<asset><texture name="t" type="2d" builtin="checker" width="8" height="8"/>
      <material name="a" texture="t"/><material name="b" texture="t" rgba="1 0 0 1"/>
      <mesh name="m" vertex="0 0 0 .1 0 0 0 .1 0 0 0 .1" texcoord="0 0 1 0 0 1 1 1"
      face="0 2 1 0 1 3 0 3 2 1 2 3"/></asset>"""
    thing = '<body pos="1 2 .8"><freejoint/><geom type="mesh" mesh="m" material="{}"/></body>'
    things = "".join(map(thing.format, "aab"))
    found = read(write(tmp_path, TABLE + things, head)).objects
    (first,), (second,), (red,) = (body.surface.pictures for body in found)
    assert first is second and first.shape == (8, 8, 3)
    assert not red[..., 1:].any() and first[..., 1].any()
    assert own_texture(found[0].surface).texture is first  # type: ignore[union-attr]


# -------------------------------------------------------------------------------------------- parts


def test_primitives_stay_primitives_where_they_lie_along_the_axes() -> None:
    half, center = np.array([0.02, 0.02, 0.05]), np.array([0.1, 0.0, 0.0])
    lying = np.array([[0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]])
    part = solid_part("cylinder", half, center, lying)
    assert (part.kind, part.axis) == ("cylinder", 0)
    np.testing.assert_allclose(part.bounds, center + np.outer([-1, 1], [0.05, 0.02, 0.02]))
    c, s = np.cos(0.4), np.sin(0.4)
    aslant = np.array([[c, 0, s], [0, 1, 0], [-s, 0, c]])
    assert solid_part("box", half, center, aslant).kind == "hull"
    assert solid_part("ellipsoid", np.full(3, 0.02), center, aslant).kind == "ellipsoid"
    assert part_of(part.vertices, "cylinder").axis == 0


# ------------------------------------------------------------------------------------------ folder


def write_folder(folder: Path, **changes: object) -> Path:
    """Write a folder with one box, 10 x 6 x 4 cm, y up as in GLB, and its position."""
    trimesh.creation.box((0.1, 0.04, 0.06)).export(folder / "box.glb")
    thing = {"name": "box_1", "file": "box.glb", "position": [0.1, 0.0, 0.76], "mass": 0.5}
    poses = {"table": {"size": [1.0, 0.6, 0.74]}, "objects": [thing | changes]}
    (folder / "poses.json").write_text(json.dumps(poses))
    return folder


@pytest.mark.usefixtures("inline")
@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"position": [0, 0, float("nan")]}, "NaN|JSON"),
        ({"position": [0, 0]}, "list of 3 numbers"),
        ({"position": [0, 0, 5000]}, "extends beyond"),
        ({"quaternion": [1, 1, 0, 0]}, "length 1"),
        ({"file": "../box.glb"}, "leaves the folder"),
        ({"file": "box.fbx"}, "GLB and OBJ"),
        ({"mass": -1}, "number in"),
        ({"mass": 10**400}, "number in"),
        ({"position": [0, 0, 10**400]}, "must be a number"),
        ({"scale": [1, 0, 1]}, "positive"),
        ({"colour": "red"}, "unknown key 'colour'"),
        ({"up": "x"}, "must be"),
    ],
)
def test_poses_that_cannot_be_are_refused(changes: dict, said: str, tmp_path: Path) -> None:
    with pytest.raises(InputError, match=said):
        import_scene(write_folder(tmp_path, **changes))


@pytest.mark.usefixtures("inline")
def test_sources_that_are_none_are_refused(tmp_path: Path) -> None:
    for source in (tmp_path, tmp_path / "no.xml", tmp_path / "scene.blend"):
        with pytest.raises(InputError, match=str(source)):
            import_scene(source)
    (tmp_path / "poses.json").write_text('{"objects": []}')
    with pytest.raises(InputError, match="no table"):
        import_scene(tmp_path)


@pytest.mark.usefixtures("inline")
def test_the_folder_of_a_urdf_export_is_refused_as_such(tmp_path: Path) -> None:
    scene = toy_scene((toy_object("box_1", (0.05, 0.03, 0.04), (0.0, 0.0)),))
    with pytest.raises(InputError, match=r"to a URDF export.*GLB or MJCF"):
        import_scene(export(scene, "urdf", tmp_path, "toy"))


@pytest.mark.slow
def test_a_folder_of_files_becomes_a_scene(tmp_path: Path) -> None:
    scene = import_scene(write_folder(tmp_path, category="book", friction=0.5, scale=1.0))
    assert scene.report is not None and scene.report.passed
    (box,) = scene.objects
    np.testing.assert_allclose(box.scale, [0.1, 0.06, 0.04], atol=1e-5)
    assert (box.mass, box.friction, box.model.category) == (0.5, 0.5, "book")
    np.testing.assert_allclose(box.pose.position, [0.1, 0, 0.76], atol=1e-3)


# ------------------------------------------------------------------------------------------ whole


def extent(thing: Object) -> np.ndarray:
    """Return corners of collision and visual geometry, and the centre of mass, in the world."""
    turn = quaternion_matrix(thing.pose.quaternion)
    solid = np.concatenate([part.vertices for part in thing.parts])
    drawn = thing.model.mesh.vertices * thing.scale
    rows: list[np.ndarray] = []
    for points in (solid, drawn):
        placed = points @ turn.T + thing.pose.position
        rows += [placed.min(0), placed.max(0)]
    return np.stack([*rows, turn @ thing.com + thing.pose.position])


def check_same(again: Scene, scene: Scene) -> None:
    """Check that a reimported export has the same objects, moved by less than 1 mm."""
    assert again.report is not None and again.report.passed
    assert again.report.settling < 1e-3
    assert [o.name for o in again.objects] == [o.name for o in scene.objects]
    for before, after in zip(scene.objects, again.objects, strict=True):
        np.testing.assert_allclose(extent(after), extent(before), atol=1e-3, err_msg=before.name)
        assert after.mass == pytest.approx(before.mass, rel=1e-4)
        assert after.friction == pytest.approx(before.friction, rel=1e-4)
        assert len(after.parts) == len(before.parts)
        assert after.placement.on == before.placement.on
        colors = [o.model.mesh.texture.reshape(-1, 3).mean(0) for o in (before, after)]
        np.testing.assert_allclose(*colors, atol=2)
    np.testing.assert_allclose(again.table.scale, scene.table.scale, atol=1e-4)


@pytest.mark.slow
@pytest.mark.usefixtures("inline")
@pytest.mark.parametrize("to", ["mjcf", "glb"])
@pytest.mark.parametrize("name", ["office-desk", "kitchen-cutting"])
def test_an_export_is_imported_again(name: str, to: str, tmp_path: Path) -> None:
    (path,) = assets_cache.find(name)
    scene = load(path)
    check_same(import_scene(export(scene, to, tmp_path)), scene)


@pytest.mark.slow
@pytest.mark.usefixtures("inline")
def test_sixty_objects_go_out_and_come_back(tmp_path: Path) -> None:
    things = [
        toy_object(
            f"cube_{k}", (0.03, 0.03, 0.03), (-0.5 + 0.1 * (k % 10), -0.25 + 0.1 * (k // 10))
        )
        for k in range(60)
    ]
    scene = toy_scene(tuple(things))
    for to in ("mjcf", "glb"):
        again = import_scene(export(scene, to, tmp_path))
        assert len(again.objects) == 60
        check_same(again, scene)


@pytest.mark.slow
def test_the_command_publishes_a_sound_bundle_or_nothing(tmp_path: Path, shell: Shell) -> None:
    source, out = write(tmp_path / "in"), tmp_path / "out"
    said = shell("import", str(source), "--out", str(out), "--name", "cubes").out
    (made,) = out.iterdir()
    assert str(made) in said and made.name.startswith("cubes-") and verify(made) == []
    shell("import", str(source), "--out", str(out), "--name", "cubes")
    assert [*out.iterdir()] == [made], "the same source gives the same bytes"
    beside = CUBE.replace('pos="1 2 .77"', 'pos="1 2.42 .77"').replace("cube", "falls")
    source = write(tmp_path / "in", TABLE + CUBE + beside)
    words = ("import", str(source), "--out", str(out), "--name", "other")
    assert "falls" in shell(*words, code=6).err
    assert [*out.iterdir()] == [made]
    told = [line.split() for line in shell(*words, "--drop-failing").out.splitlines()]
    assert ["falls", "left", "out", "falls", "fell"] in [row[:5] for row in told]


@pytest.mark.slow
@pytest.mark.usefixtures("inline")
def test_names_and_frames_of_foreign_bodies(tmp_path: Path) -> None:
    odd = CUBE.replace('"cube"', '"a/b"').replace("1 2 .77", "1.1 2 .77")
    lying = """<body name="can 2" pos="1 2.2 .78" euler="90 0 0"><freejoint/>
      <geom type="cylinder" size=".03 .04" euler="90 0 0"/></body>"""
    source = write(tmp_path, TABLE + CUBE + odd + lying)
    scene = import_scene(source, ImportOptions("named"))
    assert scene.name == "named"
    assert [o.name for o in scene.objects] == ["cube", "a_b", "can 2"]
    can = scene.object("can 2")
    assert quaternion_matrix(can.pose.quaternion)[2, 2] > 0.999, "its +z points up"
    np.testing.assert_allclose(can.scale, [0.06, 0.06, 0.08], atol=1e-4)
    assert can.model.category == "can" or can.model.category == "generic"
    assert scene.table.outline.mean(0) == pytest.approx([0, 0], abs=1e-6)
    assert dataclasses.asdict(scene.provenance)["kind"] == "manual"
