"""Meshes of servers, of folders and of other methods are parsed only in a child process."""

import json
from pathlib import Path

import numpy as np
import pytest
import trimesh
from foreign import glb, instance, prior, striped_box

from generator.backends.modelers.folder import Folder
from generator.errors import BackendError, InputError
from generator.evaluation.external import load_external, read_glb
from generator.meshes.canonical import normal_mesh
from generator.meshes.reading import loader
from generator.meshes.reading.loader import load_surface
from generator.meshes.reading.surface import read_surface
from generator.sandbox import SandboxLimits
from generator.scene import USUAL_VIEW

GOOD = glb(striped_box(), trimesh.creation.icosphere(1))


@pytest.fixture(autouse=True)
def _apart(monkeypatch: pytest.MonkeyPatch) -> None:
    """Use child processes, and make parsing in this process fail."""

    def refuse(*args: object, **kwargs: object) -> None:
        raise AssertionError("foreign data is parsed in this process")

    monkeypatch.setattr("generator.sandbox.runner.is_inside", lambda: False)
    monkeypatch.setattr(trimesh, "load_scene", refuse)


@pytest.mark.slow
def test_a_surface_comes_back_as_it_was_read(monkeypatch: pytest.MonkeyPatch) -> None:
    found = load_surface(GOOD, "it", "glb")
    monkeypatch.undo()
    here = read_surface(GOOD, "it", "glb")
    for name in ("vertices", "faces", "uv", "colors", "picture"):
        np.testing.assert_array_equal(getattr(found, name), getattr(here, name))
    np.testing.assert_array_equal(found.pictures[0], here.pictures[0])


def test_vertices_that_no_face_uses_are_left_out(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.undo()
    spare = b"v 9 9 9\n" * 500
    triangle = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 501 502 503\n"
    surface = read_surface(spare + triangle, "it", "obj")
    np.testing.assert_array_equal(
        surface.vertices[surface.faces[0]], [[0, 0, 0], [1, 0, 0], [0, 1, 0]]
    )
    assert len(surface.vertices) == len(surface.uv) == len(surface.colors) == 3


def test_spare_vertices_of_a_glb_do_not_enlarge_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.undo()
    box = trimesh.creation.box()
    spare = trimesh.Trimesh(
        np.vstack([box.vertices, np.full((100, 3), 7.0)]), box.faces, process=False
    )
    surface = read_surface(glb(spare), "it", "glb")
    assert len(surface.vertices) == len(box.vertices)
    assert surface.vertices.max() == pytest.approx(0.5)


@pytest.mark.slow
def test_whoever_takes_foreign_meshes_has_a_child_read_them(tmp_path: Path) -> None:
    (tmp_path / "mug_1.glb").write_bytes(GOOD)
    (tmp_path / "cup_1.obj").write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                        "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n")  # fmt: skip
    for name in ("mug_1", "cup_1"):
        model = Folder(str(tmp_path)).model(instance(name), prior(name), USUAL_VIEW)
        assert len(model.mesh.faces)
    assert len(normal_mesh(GOOD, "the answer").faces) == len(read_glb(GOOD, "it").faces)


@pytest.mark.slow
def test_damage_is_the_error_of_the_reader() -> None:
    with pytest.raises(BackendError, match="is truncated"):
        load_surface(GOOD[:-8], "it", "glb")
    with pytest.raises(InputError, match="is truncated"):
        read_glb(GOOD[:-8], "it")


@pytest.mark.slow
def test_a_reader_that_reaches_a_limit_is_an_error_of_the_backend(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    many = glb(trimesh.creation.icosphere(7))
    monkeypatch.setattr(loader, "LIMITS", SandboxLimits(memory=1 << 20))
    with pytest.raises(BackendError, match=r"the answer takes more than .*fewer triangles"):
        normal_mesh(many, "the answer")


@pytest.mark.slow
def test_a_file_that_a_result_names_again_is_read_once(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    calls: list[str] = []
    real = loader.call
    monkeypatch.setattr(loader, "call", lambda f, *a, **k: calls.append(a[1]) or real(f, *a, **k))
    (tmp_path / "mug.glb").write_bytes(GOOD)
    place = [[0.1, 0, 0, 0.1], [0, 0.1, 0, 0], [0, 0, 0.1, 0.8], [0, 0, 0, 1]]
    told = {
        "table": {"size": [1.2, 0.7, 0.74]},
        "objects": [{"name": f"mug_{k}", "glb": "mug.glb", "matrix": place} for k in range(3)],
    }
    (tmp_path / "transforms.json").write_text(json.dumps(told))
    assert len(load_external(tmp_path, decompose=False).objects) == 3
    assert len(calls) == 1
