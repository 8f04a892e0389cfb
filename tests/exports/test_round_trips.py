"""Every shipped bundle as GLB: valid, readable, and identical after reimport."""

import json
import shutil
import subprocess
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import trimesh
from backends.modelers.foreign import instance
from imported import READERS
from shipped_bundles import BUNDLES, PART
from test_imports import check_same

from generator.backends.modelers.folder import Folder
from generator.bundle import load
from generator.exports import export
from generator.exports.bodies import bodies_of
from generator.imports import import_scene
from generator.scene import USUAL_VIEW, Object, Scene, SizePrior

MODULES = Path(__file__).parents[2] / "web" / "node_modules"
VALIDATE = Path(__file__).with_name("validate_gltf.cjs")


def validate(*files: Path) -> dict[str, Any]:
    """Return the output of the Khronos validator for files, by name; skip without it."""
    node = shutil.which("node")
    if node is None or not (MODULES / "gltf-validator").is_dir():
        what = "Node.js is missing" if node is None else f"{MODULES} lacks gltf-validator"
        pytest.skip(f"NOT CHECKED by the Khronos validator: {what}; `make web` installs it")
    words = [node, str(VALIDATE), str(MODULES), *map(str, files)]
    done = subprocess.run(words, capture_output=True, text=True, timeout=250)
    assert done.returncode == 0, done.stderr[-3000:]
    return {Path(path).name: found for path, found in json.loads(done.stdout).items()}


@pytest.mark.slow
def test_every_shipped_bundle_is_valid_gltf(tmp_path: Path) -> None:
    chosen = {name: BUNDLES[name] for name in PART}
    files = [export(load(path), "glb", tmp_path, name) for name, path in chosen.items()]
    reports = validate(*files)
    assert {*reports} == {path.name for path in files}
    for name, report in reports.items():
        messages = [m for m in report["messages"] if m["code"] != "IMAGE_NPOT_DIMENSIONS"]
        assert (report["numErrors"], report["numWarnings"]) == (0, 0), (name, messages[:5])
        assert messages == [], name


@pytest.mark.slow
def test_the_validator_finds_faults(tmp_path: Path) -> None:
    path = export(load(BUNDLES["vanity"]), "glb", tmp_path, "odd")
    path.write_bytes(path.read_bytes().replace(b'"rotation":[-0.7', b'"rotation":[-9.7'))
    assert validate(path)["odd.glb"]["numErrors"] > 0


@pytest.mark.slow
@pytest.mark.usefixtures("inline")
@pytest.mark.parametrize("name", PART)
def test_every_shipped_bundle_is_imported_from_glb_as_it_was(name: str, tmp_path: Path) -> None:
    """Names, poses, sizes, parts, mass, friction and colours; trimesh reads it first."""
    scene = load(BUNDLES[name])
    path = export(scene, "glb", tmp_path, name)
    assert {*READERS["glb"](path)} == {body.name for body in bodies_of(scene)}
    check_same(import_scene(path), scene)


@pytest.mark.slow
@pytest.mark.usefixtures("inline")
@pytest.mark.parametrize("name", PART)
def test_exported_meshes_serve_the_folder_modeler(name: str, tmp_path: Path) -> None:
    """The OBJ files of an export as they are, and the meshes of a GLB, one file each."""
    scene = load(BUNDLES[name])
    cut_glb(export(scene, "glb", tmp_path, name), scene, tmp_path / "cut")
    meshes = export(scene, "sdf", tmp_path, name) / "meshes"
    for folder in (meshes, tmp_path / "cut"):
        modeler = Folder(str(folder), up="z", units="m")
        for thing in scene.objects:
            check_model(modeler, thing)


def cut_glb(path: Path, scene: Scene, folder: Path) -> None:
    """Write the visual geometry of each object in a GLB to a file of its name."""
    folder.mkdir()
    drawn = trimesh.load_scene(path, process=False)
    names = [body.name for body in bodies_of(scene) if not body.fixed]
    for thing, name in zip(scene.objects, names, strict=True):
        raw = drawn.geometry[name].export(file_type="glb")
        assert isinstance(raw, bytes)
        (folder / f"{thing.name}.glb").write_bytes(raw)


def check_model(modeler: Folder, thing: Object) -> None:
    """Check that the modeler returns an object's own mesh, size and texture."""
    asked = replace(instance(thing.label), name=thing.name)
    model = modeler.model(asked, SizePrior(thing.label, thing.scale), USUAL_VIEW)
    np.testing.assert_allclose(model.size, thing.scale, atol=1e-5, err_msg=thing.name)
    own = thing.model.mesh
    assert len(model.mesh.faces) == len(own.faces), thing.name
    np.testing.assert_array_equal(model.mesh.texture, own.texture, thing.name)
    assert model.mesh.opacity == pytest.approx(own.opacity, abs=1 / 255)
