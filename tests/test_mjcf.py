import dataclasses
import io
import xml.etree.ElementTree as ET
from pathlib import Path

import mujoco
import numpy as np
import pytest
from PIL import Image
from shapes import UNIT
from toy import cube_mesh, toy_object, toy_scene

from generator.geometry import Camera
from generator.io.pictures import encode_png
from generator.physics.mjcf import document, encode_obj
from generator.physics.spec import scene_spec
from generator.scene import ConvexPart, Mesh, Scene


def one(part: ConvexPart) -> Scene:
    thing = toy_object("thing_1", (0.1, 0.1, 0.1), (0, 0))
    return toy_scene((dataclasses.replace(thing, parts=(part,)),))


def collision_type(part: ConvexPart) -> str:
    root = ET.fromstring(document(one(part)).xml)
    return root.findall(".//body[@name='thing_1']/geom[@class='collision']")[0].attrib["type"]


@pytest.mark.parametrize(
    ("kind", "size", "expected"),
    [
        ("hull", (1, 1, 1), "mesh"), ("box", (1, 2, 3), "box"),
        ("cylinder", (1, 1, 3), "cylinder"), ("cylinder", (1, 1.01, 3), "cylinder"),
        ("cylinder", (1, 1.1, 3), "mesh"), ("ellipsoid", (1, 1, 1), "sphere"),
        ("ellipsoid", (1, 1.2, 1), "ellipsoid"),
    ],
)  # fmt: skip
def test_parts_are_primitives_only_where_scale_keeps_them_so(kind, size, expected) -> None:
    assert collision_type(ConvexPart(UNIT * 0.05 * np.array(size), kind)) == expected


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_a_cylinder_lies_along_its_axis(axis) -> None:
    size = np.full(3, 0.02)
    size[axis] = 0.2
    scene = one(ConvexPart(UNIT * size, "cylinder", axis))
    model = scene_spec(scene, visuals=False).compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    body = model.body("thing_1").id
    geom = model.body_geomadr[body]
    along = data.geom_xmat[geom].reshape(3, 3)[:, 2]
    assert abs(along[axis]) == pytest.approx(1)
    np.testing.assert_allclose(model.geom_size[geom][:2], [0.01, 0.1], atol=1e-6)


def test_names_poses_masses_and_the_keyframe_are_the_scenes() -> None:
    scene = toy_scene()
    model = scene_spec(scene).compile()
    data = mujoco.MjData(model)
    mujoco.mj_resetDataKeyframe(model, data, model.key("settled").id)
    mujoco.mj_forward(model, data)
    for thing in scene.objects:
        body = model.body(thing.name)
        np.testing.assert_allclose(data.xpos[body.id], thing.pose.position, atol=1e-6)
        np.testing.assert_allclose(body.mass, thing.mass, rtol=1e-6)
        np.testing.assert_allclose(
            np.sort(body.inertia), np.sort(np.linalg.eigvalsh(thing.inertia)), rtol=1e-5
        )
        assert model.joint(thing.name).type == mujoco.mjtJoint.mjJNT_FREE
    assert model.opt.timestep == 0.002
    assert model.opt.enableflags & mujoco.mjtEnableBit.mjENBL_SLEEP
    drawn = model.geom_group == 2
    assert drawn.sum() == len(scene.objects) + 1
    assert not model.geom_contype[drawn].any()


def test_loads_in_plain_mujoco_from_any_folder(tmp_path: Path, monkeypatch) -> None:
    made = document(toy_scene())
    for name, content in made.files.items():
        (tmp_path / name).parent.mkdir(exist_ok=True)
        (tmp_path / name).write_bytes(content)
    (tmp_path / "scene.xml").write_text(made.xml)
    moved = tmp_path.rename(tmp_path.parent / "elsewhere")
    monkeypatch.chdir(moved.parent)
    model = mujoco.MjModel.from_xml_path(str(moved / "scene.xml"))
    assert model.nbody == 8
    assert {model.camera(k).name for k in range(model.ncam)} == {"reference", "top"}


def test_the_scene_stays_put_in_plain_mujoco() -> None:
    model = scene_spec(toy_scene()).compile()
    data = mujoco.MjData(model)
    start = data.qpos.copy()
    mujoco.mj_step(model, data, 1000)
    assert np.abs(data.qpos - start).max() < 1e-3


def test_equal_models_share_their_files() -> None:
    twins = (
        toy_object("cube_1", (0.05,) * 3, (0, 0)),
        toy_object("cube_2", (0.05,) * 3, (0.2, 0)),
        toy_object("cube_3", (0.08,) * 3, (-0.2, 0)),
    )
    made = document(toy_scene(twins))
    assert len([f for f in made.files if f.endswith(".obj")]) == 1
    root = ET.fromstring(made.xml)
    assert len(root.findall("asset/mesh[@file]")) == 3  # cube, larger cube, table


def test_the_same_scene_gives_the_same_document() -> None:
    assert document(toy_scene()) == document(toy_scene())


def test_the_reference_camera_of_the_document_shows_the_whole_table() -> None:
    scene = toy_scene()
    made = scene_spec(scene).compile().camera("reference")
    right, up, back = made.mat0.reshape(3, 3).T
    rotation = np.array([right, -up, -back])
    camera = Camera(made.pos, rotation, float(np.deg2rad(made.fovy[0])), 960, 720)
    rim = np.column_stack([scene.table.outline, np.full(len(scene.table.outline), 0.74)])
    pixels = camera.project(rim)
    assert (pixels > 0).all() and (pixels < [960, 720]).all()


def test_glass_is_drawn_through() -> None:
    thing = toy_object("glass_1", (0.1,) * 3, (0, 0))
    clear = dataclasses.replace(
        thing.model, mesh=dataclasses.replace(thing.model.mesh, opacity=0.3)
    )
    model = scene_spec(toy_scene((dataclasses.replace(thing, model=clear),))).compile()
    assert 0.3 in model.mat_rgba[:, 3].round(6)


def test_texture_row_zero_is_v_one() -> None:
    """The convention of scene.py, as MuJoCo sees it: OBJ v upwards, PNG row 0 on top."""
    texture = np.zeros((2, 2, 3), np.uint8)
    texture[0] = 255
    mesh = Mesh(UNIT, cube_mesh().faces, UNIT[:, [0, 2]] + 0.5, texture)
    top = np.flatnonzero(UNIT[:, 2] > 0)
    lines = encode_obj(mesh).decode().splitlines()
    vs = [float(line.split()[2]) for line in lines if line.startswith("vt")]
    assert all(vs[k] == 1.0 for k in top)
    assert np.asarray(Image.open(io.BytesIO(encode_png(texture))))[0].min() == 255
