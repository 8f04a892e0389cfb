"""Folders of foreign meshes: what is read of them, and what is refused."""

from pathlib import Path

import numpy as np
import pytest
import trimesh
from PIL import Image
from posing.cases import Draw, draw_case
from posing.meshes import load_model, mesh_files

from generator.errors import InputError
from generator.evaluation.surfaces.symmetry import order
from generator.scene import Model


def textured(size: tuple[float, float, float]) -> trimesh.Trimesh:
    """A box whose sides are red at +z, green at -z, blue elsewhere, by one texture."""
    made = trimesh.creation.box(extents=size)
    points = made.vertices[made.faces].reshape(-1, 3)
    facing = made.face_normals[:, 2].repeat(3)
    u = np.where(facing > 0.5, 1, np.where(facing < -0.5, 3, 5)) / 6
    uv = np.column_stack([u, np.full(len(u), 0.75)])
    picture = np.zeros((8, 24, 3), np.uint8)  # the upper half has the colours
    picture[:4, :8], picture[:4, 8:16], picture[:4, 16:] = (
        (220, 10, 10),
        (10, 220, 10),
        (10, 10, 220),
    )
    look = trimesh.visual.material.PBRMaterial(baseColorTexture=Image.fromarray(picture))
    visual = trimesh.visual.TextureVisuals(uv=uv, material=look)
    faces = np.arange(len(points)).reshape(-1, 3)
    return trimesh.Trimesh(points, faces, process=False, visual=visual)


def color_of(model: Model, axis: int, sign: float) -> np.ndarray:
    """The colour of the side that faces along an axis."""
    from generator.render.shading import sample_texture

    mesh = model.mesh
    side = (sign * mesh.vertices[mesh.faces][..., axis] > 0.49).all(1)
    return sample_texture(mesh.texture, mesh.uv[mesh.faces[side]].mean(1)).mean(0) * 255


@pytest.mark.slow
@pytest.mark.parametrize("ending", ["obj", "glb"])
def test_a_mesh_folder_loads(tmp_path: Path, ending: str) -> None:
    made = textured((0.2, 0.1, 0.05))
    if ending == "glb":
        made.apply_transform(trimesh.transformations.rotation_matrix(-np.pi / 2, [1, 0, 0]))
    made.export(tmp_path / f"thing.{ending}")
    (tmp_path / "notes.txt").write_text("nothing")
    (path,) = mesh_files(tmp_path)
    model = load_model(path)
    np.testing.assert_allclose(model.size, [0.2, 0.1, 0.05], atol=1e-6)
    np.testing.assert_allclose(color_of(model, 2, 1), [220, 10, 10], atol=12)
    np.testing.assert_allclose(color_of(model, 2, -1), [10, 220, 10], atol=12)
    np.testing.assert_allclose(color_of(model, 0, 1), [10, 10, 220], atol=12)
    assert order(model.mesh, model.size) == 2
    assert draw_case(Draw(models=(model,), symmetric=True), 0).order == 2


def test_colours_of_faces_and_several_parts_are_kept(tmp_path: Path) -> None:
    made = trimesh.creation.box(extents=(0.1, 0.1, 0.1))
    made.visual.face_colors = np.where(made.face_normals[:, 2:] > 0.5, [[200, 0, 0, 255]],
                                       [[0, 0, 200, 255]]).astype(np.uint8)  # fmt: skip
    made.export(tmp_path / "painted.ply")
    model = load_model(tmp_path / "painted.ply")
    assert color_of(model, 2, 1)[0] > 150 > color_of(model, 2, 1)[2]
    assert color_of(model, 0, 1)[2] > 150 > color_of(model, 0, 1)[0]
    ball = trimesh.creation.icosphere(radius=0.03).apply_translation([0, 0, 0.2])
    trimesh.Scene([textured((0.1, 0.1, 0.1)), ball]).export(tmp_path / "two.glb")
    both = load_model(tmp_path / "two.glb", "z")
    np.testing.assert_allclose(both.size, [0.1, 0.1, 0.28], atol=1e-3)
    np.testing.assert_allclose(color_of(both, 2, -1), [10, 220, 10], atol=12)


def bad_mesh(folder: Path, what: str) -> Path:
    path = folder / ("bad.glb" if what == "damaged" else "bad.obj")
    triangle = "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0.1\nf 1 2 3\n"
    if what == "damaged":
        path.write_bytes(b"glTF\x02\x00\x00\x00 nothing")
    elif what == "empty":
        path.write_text("")
    elif what == "pointless":
        path.write_text("v 0 0 0\nv 1 0 0\nv 0 1 0\n")
    elif what == "millimetres":
        path.write_text(triangle.replace("0.1", "100"))
    elif what == "not finite":
        path.write_text(triangle.replace("v 0.1", "v nan"))
    else:
        (folder.parent / "secret.mtl").write_text("newmtl a\nKd 1 0 0\n")
        path.write_text("mtllib ../secret.mtl\nusemtl a\n" + triangle)
    return path


@pytest.mark.parametrize(
    ("what", "says"),
    [
        ("damaged", "cannot be read"), ("empty", "0 bytes"),
        ("pointless", "no triangle|cannot be read"), ("millimetres", "Scale it to metres"),
        ("not finite", "NaN"), ("outside", "outside its folder"),
    ],
)  # fmt: skip
def test_a_bad_mesh_is_refused(tmp_path: Path, what: str, says: str) -> None:
    (tmp_path / "in").mkdir()
    with pytest.raises(InputError, match=says):
        load_model(bad_mesh(tmp_path / "in", what))


def test_a_folder_without_meshes_is_refused(tmp_path: Path) -> None:
    with pytest.raises(InputError, match="contains no mesh"):
        mesh_files(tmp_path)
    with pytest.raises(InputError, match="No folder"):
        mesh_files(tmp_path / "none")
    outside = tmp_path / "thing.obj"
    outside.write_text("v 0 0 0\n")
    (tmp_path / "in").mkdir()
    (tmp_path / "in" / "link.obj").symlink_to(outside)
    with pytest.raises(InputError, match="contains no mesh"):
        mesh_files(tmp_path / "in")
