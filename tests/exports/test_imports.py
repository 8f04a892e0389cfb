"""Foreign scenes as bundles: MJCF, GLB and folders, what is refused, and exports read again."""

import dataclasses
import json
from collections.abc import Callable
from pathlib import Path

import mujoco
import numpy as np
import pytest
import trimesh
from command import Shell
from toy import toy_object, toy_scene

import assets_cache
from generator.bundle import load, verify
from generator.errors import InputError
from generator.exports import export
from generator.geometry import quaternion_matrix
from generator.imports import ImportOptions, compiling, import_scene, mjcf_files
from generator.imports import mjcf as reading
from generator.imports.compiling import compile_foreign
from generator.imports.foreign import ForeignScene
from generator.imports.mjcf import read_mjcf
from generator.imports.mjcf_files import GatheredModel, gather
from generator.imports.shapes import part_of, solid_part
from generator.meshes.coloring import own_texture
from generator.scene import Object, Scene

TABLE = '<body name="table" pos="1 2 0"><geom type="box" size=".6 .4 .37" pos="0 0 .37"/></body>'
CUBE = '<body name="cube" pos="1 2 .77"><freejoint/><geom type="box" size=".03 .03 .03"/></body>'

LID = '<body name="lid"><joint/><geom size=".1"/></body>'


def write(folder: Path, body: str = TABLE + CUBE, head: str = "", name: str = "scene.xml") -> Path:
    path = folder / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(f"<mujoco>{head}<worldbody>{body}</worldbody></mujoco>")
    return path


@pytest.fixture
def read(monkeypatch: pytest.MonkeyPatch) -> Callable[..., ForeignScene]:
    """Read MJCF without the child process, which takes most of the time."""

    def compile_here(gathered: GatheredModel, what: str) -> mujoco.MjModel:
        return mujoco.MjModel.from_xml_string(gathered.xml, gathered.files)

    monkeypatch.setattr(reading, "compile_foreign", compile_here)
    return read_mjcf


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
    assert found.table.name == "stand" and found.warnings == ("fixed things are left out: wall",)
    with pytest.raises(InputError, match=r"'desk'.*stand, wall"):
        read(tmp_path / "scene.xml", None, "desk")
    with pytest.raises(InputError, match="no table: nothing that is fixed is under"):
        read(write(tmp_path, wall + CUBE))
    with pytest.raises(InputError, match="no table"):
        read(write(tmp_path, '<geom type="plane" size="1 1 1"/>' + CUBE))


@pytest.mark.parametrize(
    ("body", "said"),
    [
        (TABLE, "no free body"),
        (TABLE + CUBE.replace("<freejoint/>", '<joint type="hinge"/>'), "1 joints.*not free.*cube"),
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


def test_includes_and_assets_are_found_inside_the_folder(tmp_path: Path, read) -> None:
    (tmp_path / "assets").mkdir()
    trimesh.creation.box((1, 1, 1)).export(tmp_path / "assets" / "cube.obj")
    thing = '<body name="it" pos="1 2 .79"><freejoint/><geom type="mesh" mesh="cube"/></body>'
    (tmp_path / "parts").mkdir()
    (tmp_path / "parts/thing.xml").write_text(f"<mujocoinclude>{thing}</mujocoinclude>")
    head = '<compiler meshdir="assets"/><asset><mesh file="cube.obj" scale=".1 .1 .1"/></asset>'
    path = write(tmp_path, TABLE + '<include file="parts/thing.xml"/>', head)
    (it,) = read(path).objects
    np.testing.assert_allclose(np.ptp(it.surface.vertices, axis=0), 0.1)
    assert gather(path).files.keys() == {"file_0.obj"}
    # A model in a folder of its own, its assets beside that.
    head = head.replace('"assets"', '"../assets"')
    deep = write(tmp_path, TABLE + '<include file="../parts/thing.xml"/>', head, "models/deep.xml")
    with pytest.raises(InputError, match="outside of its folder"):
        read(deep)
    assert len(read(deep, tmp_path).objects) == 1
    with pytest.raises(InputError, match="is not inside of"):
        read(deep, tmp_path / "assets")


@pytest.mark.parametrize("there", ["a/b/it.xml", "it.xml a/b/it.xml", "it.xml a/it.xml"])
def test_an_include_is_found_where_mujoco_finds_it(there: str, tmp_path: Path) -> None:
    path = write(tmp_path, '<include file="a/one.xml"/>')
    (tmp_path / "a/b").mkdir(parents=True)
    (tmp_path / "a/one.xml").write_text('<m><include file="b/two.xml"/></m>')
    (tmp_path / "a/b/two.xml").write_text('<m><include file="it.xml"/></m>')
    for name in there.split():
        (tmp_path / name).write_text(f'<m><body name="{name}"/></m>')
    found = gather(path)
    models = (
        mujoco.MjModel.from_xml_path(str(path)),
        mujoco.MjModel.from_xml_string(found.xml, found.files),
    )
    first, ours = (model.body(1).name for model in models)
    assert first == ours == there.split()[0]


@pytest.mark.parametrize(
    ("head", "said"),
    [
        ('<asset><mesh file="/etc/passwd"/></asset>', "relative"),
        ('<asset><mesh file="../x.obj"/></asset>', "outside of its folder"),
        ('<asset><mesh file="link.obj"/></asset>', "link"),
        ('<asset><mesh file="missing.obj"/></asset>', "missing"),
        ('<asset><mesh file="x.dae"/></asset>', r"\.obj, \.stl"),
        ('<asset><texture type="2d" file="../x.png"/></asset>', "outside"),
        ('<include file="../x.xml"/>', "outside"),
        ('<include file="scene.xml"/>', "twice, or within itself"),
        ("<include/>", "names the file ''"),
        ('<extension><plugin plugin="x"/></extension>', "plugins run code"),
        ('<asset><hfield file="x.png"/></asset>', "height fields"),
        ('<asset><model file="x.xml"/></asset>', "attaches another"),
        ('<custom><text name="a" data="b" file="/x"/></custom>', "names a file"),
    ],
)
def test_files_outside_and_code_are_refused(head: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "link.obj").symlink_to("/etc/hostname")
    with pytest.raises(InputError, match=said):
        gather(write(tmp_path, head=head))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('<!DOCTYPE m [<!ENTITY a "b">]><mujoco>&a;</mujoco>', "document type or entities"),
        ("<mujoco>", "no XML"),
        ("<robot/>", "no MJCF"),
        ("<mujoco>" + "<body>" * 150 + "</body>" * 150 + "</mujoco>", "too deep"),
        ("<mujoco>" + "<a/>" * 2001 + "</mujoco>", "too many elements"),
        ('<mujoco><replicate count="100000"/></mujoco>', "replicates"),
        ('<mujoco><replicate count="0000000009999"/></mujoco>', "replicates"),
        ('<mujoco><replicate count="          9999"/></mujoco>', "replicates"),
        ('<?xml version="1.0" encoding="utf-7"?><mujoco/>', "UTF-8"),
    ],
)
def test_hostile_xml_is_refused(
    text: str, said: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mjcf_files, "MOST_ELEMENTS", 2000)
    path = tmp_path / "scene.xml"
    path.write_text(text)
    with pytest.raises(InputError, match=said):
        gather(path)


@pytest.mark.parametrize("part", ["<a/>" * 90, "<b>" * 40 + "%s" + "</b>" * 40])
def test_files_that_are_included_count_together(
    part: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(mjcf_files, "MOST_ELEMENTS", 250)
    more = ["<include file='two.xml'/>", "<include file='three.xml'/>", ""]
    for name, include in zip(("one", "two", "three"), more, strict=True):
        text = part % include if "%s" in part else part + include
        (tmp_path / f"{name}.xml").write_text(f"<m>{text}</m>")
    with pytest.raises(InputError, match=r"three\.xml nests too deep, or the model has too many"):
        gather(write(tmp_path, '<include file="one.xml"/>'))


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


@pytest.mark.slow
def test_what_mujoco_cannot_compile_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write(tmp_path, TABLE + CUBE.replace('"box"', '"box" material="none"'))
    with pytest.raises(InputError, match=r"MuJoCo refuses the model.*none"):
        compile_foreign(gather(path), "the model")
    monkeypatch.setattr(compiling, "_SECONDS", 3)
    many = "<replicate count='200'>" * 4 + "<body><freejoint/><geom size='1'/></body>"
    path = write(tmp_path, TABLE + many + "</replicate>" * 4)
    with pytest.raises(InputError, match=r"breaks down|takes MuJoCo longer"):
        compile_foreign(gather(path), "the model")


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
    """A folder with one box, 10 x 6 x 4 cm, y up as GLB is, and where it stands."""
    trimesh.creation.box((0.1, 0.04, 0.06)).export(folder / "box.glb")
    thing = {"name": "box_1", "file": "box.glb", "position": [0.1, 0.0, 0.76], "mass": 0.5}
    poses = {"table": {"size": [1.0, 0.6, 0.74]}, "objects": [thing | changes]}
    (folder / "poses.json").write_text(json.dumps(poses))
    return folder


@pytest.mark.parametrize(
    ("changes", "said"),
    [
        ({"position": [0, 0, float("nan")]}, "NaN|JSON"),
        ({"position": [0, 0]}, "list of 3 numbers"),
        ({"position": [0, 0, 5000]}, "farther than"),
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


def test_sources_that_are_none_are_refused(tmp_path: Path) -> None:
    for source in (tmp_path, tmp_path / "no.xml", tmp_path / "scene.blend"):
        with pytest.raises(InputError, match=str(source)):
            import_scene(source)
    (tmp_path / "poses.json").write_text('{"objects": []}')
    with pytest.raises(InputError, match="no table"):
        import_scene(tmp_path)


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
    """Corners of what collides and of what is drawn, and the centre of mass, in the world."""
    turn = quaternion_matrix(thing.pose.quaternion)
    solid = np.concatenate([part.vertices for part in thing.parts])
    drawn = thing.model.mesh.vertices * thing.scale
    rows: list[np.ndarray] = []
    for points in (solid, drawn):
        placed = points @ turn.T + thing.pose.position
        rows += [placed.min(0), placed.max(0)]
    return np.stack([*rows, turn @ thing.com + thing.pose.position])


def check_same(again: Scene, scene: Scene) -> None:
    """Check that an export read again holds the same objects, and nothing has moved by 1 mm."""
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
@pytest.mark.parametrize("to", ["mjcf", "glb"])
@pytest.mark.parametrize("name", ["office-desk", "kitchen-cutting"])
def test_an_export_is_imported_again(name: str, to: str, tmp_path: Path) -> None:
    (path,) = assets_cache.find(name)
    scene = load(path)
    check_same(import_scene(export(scene, to, tmp_path)), scene)


@pytest.mark.slow
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
    assert "falls was left out" in shell(*words, "--drop-failing").out


@pytest.mark.slow
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
