"""The files of a foreign MJCF: collected within a folder, bounded, and compiled."""

from pathlib import Path

import mujoco
import numpy as np
import pytest
import trimesh
from foreign_models import CUBE, TABLE, write

from generator.errors import InputError
from generator.imports import mjcf_files
from generator.imports.mjcf import compile_foreign
from generator.imports.mjcf_files import gather


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
    with pytest.raises(InputError, match="outside its folder"):
        read(deep)
    assert len(read(deep, tmp_path).objects) == 1
    with pytest.raises(InputError, match="is not inside"):
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
        ('<asset><mesh file="../x.obj"/></asset>', "outside its folder"),
        ('<asset><mesh file="link.obj"/></asset>', "link"),
        ('<asset><mesh file="missing.obj"/></asset>', "missing"),
        ('<asset><mesh file="x.dae"/></asset>', r"\.obj, \.stl"),
        ('<asset><texture type="2d" file="../x.png"/></asset>', "outside"),
        ('<include file="../x.xml"/>', "outside"),
        ('<include file="scene.xml"/>', "twice, or within itself"),
        ("<include/>", "refers to the file ''"),
        ('<extension><plugin plugin="x"/></extension>', "plugins run code"),
        ('<asset><hfield file="x.png"/></asset>', "height fields"),
        ('<asset><model file="x.xml"/></asset>', "attached models are not"),
        ('<custom><text name="a" data="b" file="/x"/></custom>', "refers to a file"),
    ],
)
def test_files_outside_and_code_are_refused(head: str, said: str, tmp_path: Path) -> None:
    (tmp_path / "link.obj").symlink_to("/etc/hostname")
    with pytest.raises(InputError, match=said):
        gather(write(tmp_path, head=head))


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ('<!DOCTYPE m [<!ENTITY a "b">]><mujoco>&a;</mujoco>', "document type or entity"),
        ("<mujoco>", "not valid XML"),
        ("<robot/>", "not an MJCF"),
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
    with pytest.raises(InputError, match=r"three\.xml is nested too deeply, or the model has too"):
        gather(write(tmp_path, '<include file="one.xml"/>'))


def test_what_mujoco_cannot_compile_is_told(tmp_path: Path) -> None:
    path = write(tmp_path, TABLE + CUBE.replace('"box"', '"box" material="none"'))
    with pytest.raises(InputError, match=r"MuJoCo rejects the model.*none"):
        compile_foreign(gather(path), "the model")
