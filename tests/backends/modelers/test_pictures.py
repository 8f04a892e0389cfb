"""Textures of foreign meshes: each is decoded and stored once, even if shared."""

import io

import numpy as np
import pytest
import trimesh
from backends.modelers.foreign import glb, striped_box, textured
from PIL import Image

from generator.errors import BackendError
from generator.meshes.canonical import normal_mesh
from generator.meshes.reading import textures as pictures
from generator.meshes.reading.surface import read_surface, surface_of
from generator.meshes.reading.textures import Pictures

WHITE = np.ones(3)


def png(color: int, side: int = 8) -> bytes:
    stream = io.BytesIO()
    Image.fromarray(np.full((side, side, 3), color, np.uint8)).save(stream, "PNG")
    return stream.getvalue()


def row(count: int, shared: bool) -> list[trimesh.Trimesh]:
    """Return boxes side by side that look alike, with one material or a copy each."""
    boxes = [striped_box() for _ in range(count)]
    for k, box in enumerate(boxes):
        box.apply_translation([3.0 * k, 0, 0])
        if shared:
            box.visual.material = boxes[0].visual.material
    return boxes


@pytest.fixture
def decoded(monkeypatch: pytest.MonkeyPatch) -> list[tuple[int, int]]:
    sizes = []
    decode = pictures.decode

    def note(*args):
        found = decode(*args)
        sizes.append((found.width, found.height))
        return found

    monkeypatch.setattr(pictures, "decode", note)
    return sizes


@pytest.mark.parametrize("shared", [True, False])
def test_one_texture_for_many_parts_is_decoded_and_kept_once(decoded, shared):
    surface = read_surface(glb(*row(20, shared)), "it", "glb")
    assert decoded == [(64, 64)]
    assert len(surface.pictures) == 1
    assert (surface.picture == 0).all()


@pytest.mark.parametrize("shared", [True, False])
def test_parts_that_share_a_texture_keep_it(shared):
    parts = row(3, shared)
    mesh = normal_mesh(glb(*parts), "it")
    np.testing.assert_array_equal(mesh.texture, normal_mesh(glb(striped_box()), "it").texture)
    uv = np.concatenate([part.visual.uv for part in parts])
    assert len(mesh.faces) == 36
    np.testing.assert_allclose(mesh.uv, uv, atol=1e-6)


def test_pictures_in_memory_are_kept_once_and_stay_as_they_are():
    picture = Image.fromarray(np.full((3000, 10, 3), 7, np.uint8))
    parts = row(3, shared=True)
    parts[0].visual.material.baseColorTexture = picture
    (kept,) = surface_of(parts, "it").pictures
    assert max(kept.shape) == 2048
    assert picture.size == (10, 3000)


def test_an_obj_s_materials_share_a_picture(decoded):
    names = "abcde"
    text = "mtllib it.mtl\nvt 0.5 0.5\n" + "".join(
        f"v {k} 0 0\nv {k} 1 0\nv {k} 0 1\nusemtl {name}\n"
        f"f {3 * k + 1}/1 {3 * k + 2}/1 {3 * k + 3}/1\n"
        for k, name in enumerate(names)
    )
    library = "".join(f"newmtl {name}\nmap_Kd it.png\n" for name in names)
    beside = {"it.mtl": library.encode(), "it.png": png(9)}
    surface = read_surface(text.encode(), "it", "obj", beside)
    assert decoded == [(8, 8)]
    assert len(surface.pictures) == 1 and len(surface.faces) == 5


def test_a_picture_in_several_tints_is_decoded_once_and_kept_for_each(decoded):
    found = Pictures("it")
    image = Image.open(io.BytesIO(png(200)))
    places = [found.place(image, tint) for tint in (WHITE, WHITE / 2, WHITE, WHITE / 2)]
    assert places == [0, 1, 0, 1]
    assert [int(kept[0, 0, 0]) for kept in found.kept] == [200, 146]  # 200 at half the light
    assert decoded == [(8, 8)]


def test_many_tints_of_a_picture_are_refused():
    found = Pictures("the file:", maximum=3 * 64)
    for k in range(3):
        found.place(Image.open(io.BytesIO(png(k))), WHITE)
    with pytest.raises(
        BackendError, match="the file: uses its textures with too many colour factors"
    ):
        found.place(Image.open(io.BytesIO(png(0))), WHITE / 2)


def test_a_mirrored_part_keeps_its_faces_outwards():
    box = striped_box()
    scene = trimesh.Scene([box])
    scene.add_geometry(box, transform=np.diag([-1.0, 1, 1, 1]) + np.eye(4, k=3) * 4)
    surface = read_surface(scene.export(file_type="glb"), "it", "glb")
    assert len(surface.pictures) == 1
    made = trimesh.Trimesh(surface.vertices, surface.faces)
    assert made.is_winding_consistent and made.volume == pytest.approx(4.0)


def test_a_texture_of_another_form_is_shown_in_colour():
    picture = Image.fromarray(np.full((4, 4), 90, np.uint8))  # grey
    box = striped_box()
    textured(box, np.zeros((4, 4, 3), np.uint8), box.visual.uv)
    box.visual.material.baseColorTexture = picture
    (kept,) = read_surface(glb(box), "it", "glb").pictures
    assert kept.tolist() == [[[90] * 3] * 4] * 4
