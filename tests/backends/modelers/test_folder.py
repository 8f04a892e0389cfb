"""User files as models: selection, conversion and rejection."""

import io
import os
from pathlib import Path

import numpy as np
import pytest
import trimesh
from backends.modelers.foreign import glb, instance, plain, prior, striped_box
from PIL import Image

from generator.backends import Backends
from generator.backends.modelers.folder import Folder
from generator.errors import BackendError, InputError
from generator.meshes.reading import companions as beside
from generator.pipeline import generate
from generator.sandbox.serialization import pack, unpack
from generator.scene import USUAL_VIEW, SizePrior

RED, GREEN = (200, 0, 0, 255), (0, 200, 0, 255)


def box(color: tuple[int, int, int, int]) -> bytes:
    return glb(plain(trimesh.creation.box(extents=(1, 2, 3)), color))


def ask(folder, label: str = "mug", **settings):
    return Folder(str(folder), **settings).model(instance(label), prior(label), USUAL_VIEW)


def test_the_name_goes_before_the_category(tmp_path):
    (tmp_path / "mug.glb").write_bytes(box(RED))
    assert ask(tmp_path).mesh.texture[0, 0, 0] == 200
    (tmp_path / "Mug-1.GLB").write_bytes(box(GREEN))
    assert ask(tmp_path).mesh.texture[0, 0, 1] == 200


def test_other_words_for_a_category_find_its_file(tmp_path):
    (tmp_path / "mug.glb").write_bytes(box(RED))
    made = ask(tmp_path, "coffee mug")
    assert (made.name, made.label, made.category) == ("coffee mug_1", "coffee mug", "mug")


def test_texture_and_proportions_are_its_own_and_the_size_is_the_prior_s(tmp_path):
    (tmp_path / "gizmo.glb").write_bytes(glb(striped_box((2.0, 4.0, 1.0))))
    made = ask(tmp_path, "gizmo")
    assert made.mesh.texture.shape == (64, 64, 3)
    np.testing.assert_allclose(made.size / made.size[0], [1, 0.5, 2], rtol=1e-5)
    want = np.sort(prior("gizmo").extent)[1:]
    np.testing.assert_allclose(np.prod(np.sort(made.size)[1:]), np.prod(want), rtol=1e-5)


@pytest.mark.parametrize(
    ("line", "opacity"),
    [("d 0.5", 0.5), ("d 1", 1), ("d 0", 1), ("d nan", 1), ("d -halo 0.5", 1), ("d", 1), ("", 1)],
)
def test_the_opacity_of_an_obj_is_its_material_s(line: str, opacity: float, tmp_path):
    (tmp_path / "mug.mtl").write_text(f"newmtl glass\nKd 0.5 0.5 0.5\n{line}\n")
    plain_box = trimesh.creation.box(extents=(1, 2, 3)).export(file_type="obj")
    assert isinstance(plain_box, str)
    body = "\n".join(row for row in plain_box.splitlines() if row[:2] in ("v ", "f "))
    (tmp_path / "mug.obj").write_text(f"mtllib mug.mtl\nusemtl glass\n{body}\n")
    assert ask(tmp_path).mesh.opacity == opacity


def test_an_obj_comes_with_its_material_and_picture(tmp_path):
    picture = io.BytesIO()
    Image.fromarray(np.full((8, 8, 3), (10, 20, 200), np.uint8)).save(picture, "PNG")
    (tmp_path / "maps").mkdir()
    (tmp_path / "maps/blue paint.png").write_bytes(picture.getvalue())
    (tmp_path / "mug.mtl").write_text("newmtl paint\nKd 0.5 0.5 0.5\nmap_Kd maps/blue paint.png\n")
    corners = "\n".join(f"v {x} {y} {z}" for x in (0, 1) for y in (0, 1) for z in (0, 1))
    sides = "1 2 4 3|5 7 8 6|1 5 6 2|3 4 8 7|1 3 7 5|2 6 8 4"
    faces = "\n".join("f " + " ".join(f"{c}/1" for c in s.split()) for s in sides.split("|"))
    text = f"mtllib mug.mtl\n{corners}\nvt 0.5 0.5\nusemtl paint\n{faces}\n"
    (tmp_path / "mug.obj").write_text(text)
    made = ask(tmp_path)
    assert made.mesh.texture.reshape(-1, 3).tolist() == [[10, 20, 200]] * 64
    (tmp_path / "maps/blue paint.png").write_bytes(b"<html>")
    with pytest.raises(BackendError, match=r"mug\.obj has a texture that cannot be read"):
        ask(tmp_path)
    (tmp_path / "maps/blue paint.png").unlink()
    with pytest.raises(BackendError, match=r"refers to 'maps/blue paint\.png', which is not in"):
        ask(tmp_path)


def test_the_pictures_of_an_obj_are_bounded_together(tmp_path):
    for k in range(9):  # blank pictures take few bytes
        Image.new("1", (4096, 4096 - k)).save(tmp_path / f"{k}.png")
    library = "".join(f"newmtl m{k}\nmap_Kd {k}.png\n" for k in range(9))
    (tmp_path / "mug.mtl").write_text(library)
    (tmp_path / "mug.obj").write_text("mtllib mug.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n")
    with pytest.raises(BackendError, match=r"textures with more than 134217728 pixels in total"):
        ask(tmp_path)


def obj_with(folder: Path, *pictures: str) -> bytes:
    """Return an OBJ whose materials use these pictures."""
    library = "".join(f"newmtl m{k}\nmap_Kd {name}\n" for k, name in enumerate(pictures))
    (folder / "m.mtl").write_text(library)
    (folder / "x").mkdir(exist_ok=True)
    Image.new("RGB", (4, 4)).save(folder / "a.png")
    return b"mtllib m.mtl\nmtllib ./m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n"


def test_a_file_of_several_names_is_read_once(tmp_path, monkeypatch):
    names = ("a.png", "./a.png", "x/../a.png")
    opened, read = [], beside.read_regular
    monkeypatch.setattr(
        beside, "read_regular", lambda path, *a, **k: (opened.append(path), read(path, *a, **k))[1]
    )
    found = beside.companions(obj_with(tmp_path, *names), "it", tmp_path)
    assert sorted(path.name for path in opened) == ["a.png", "m.mtl"]
    assert len({id(found[name]) for name in names}) == 1
    sizes = [(tmp_path / name).stat().st_size for name in ("a.png", "m.mtl")]
    assert beside.total_bytes(found) == sum(sizes)
    assert (
        len({id(content) for content in unpack(pack(dict(found)), lambda name: object).values()})
        == 2
    )


def test_the_files_of_an_obj_are_bounded_together(tmp_path):
    raw = obj_with(tmp_path, "a.png", "b.png")
    (tmp_path / "b.png").write_bytes((tmp_path / "a.png").read_bytes())
    most = sum((tmp_path / n).stat().st_size for n in ("a.png", "b.png", "m.mtl"))
    assert beside.companions(raw, "it", tmp_path, most)
    with pytest.raises(BackendError, match=r"it: .*bytes"):
        beside.companions(raw, "it", tmp_path, most - 1)


def test_pictures_of_an_obj_are_decoded_in_a_child_alone(tmp_path, monkeypatch):
    monkeypatch.setattr(Image, "open", None)
    assert len(beside.companions(obj_with(tmp_path, "a.png"), "it", tmp_path)) == 3


@pytest.mark.parametrize("name", ["../secret.mtl", "/etc/passwd", "http://example.org/a.mtl"])
def test_an_obj_names_no_file_outside_its_folder(tmp_path, name):
    (tmp_path / "secret.mtl").write_text("newmtl a\n")
    (tmp_path / "in").mkdir()
    (tmp_path / "in/mug.obj").write_text(f"mtllib {name}\nv 0 0 0\nv 1 0 0\nv 0 1 1\nf 1 2 3\n")
    with pytest.raises(BackendError, match="refers to a file outside its folder"):
        ask(tmp_path / "in")


@pytest.mark.parametrize("kind", ["loop", "device", "pipe", "long", "nul"])
@pytest.mark.parametrize("which", ["material", "picture"])
def test_what_an_obj_names_has_to_be_a_regular_file(tmp_path, kind, which):
    name = {"long": "a" * 5000, "nul": "a\0b"}.get(kind, "it")
    if kind == "loop":
        (tmp_path / "it").symlink_to("it")
    elif kind == "device":
        (tmp_path / "it").symlink_to("/dev/zero")
    elif kind == "pipe":
        os.mkfifo(tmp_path / "it")
    library = name if which == "material" else "m.mtl"
    (tmp_path / "m.mtl").write_text(f"newmtl a\nmap_Kd {name}\n")
    text = f"#{'-' * 5000}\nmtllib {library}\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\n"
    (tmp_path / "mug.obj").write_text(text)
    with pytest.raises(BackendError, match=r"mug.obj"):
        ask(tmp_path)


def test_what_is_missing_is_told_with_what_is_there(tmp_path):
    (tmp_path / "mugs.glb").write_bytes(box(RED))
    (tmp_path / "readme.txt").write_text("mine")
    with pytest.raises(BackendError) as caught:
        ask(tmp_path)
    said = str(caught.value)
    assert said.startswith(f"folder, model of 'mug_1': {tmp_path} has no mug_1.glb or mug.glb.")
    assert said.endswith("Did you mean 'mugs'? Available: mugs.")


def test_somebody_else_may_model_the_rest(tmp_path):
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine/mug.glb").write_bytes(box(RED))
    (tmp_path / "others").mkdir()
    (tmp_path / "others/book.glb").write_bytes(box(GREEN))
    rest = Folder(str(tmp_path / "others"))
    assert ask(tmp_path / "mine", fallback=rest).mesh.texture[0, 0, 0] == 200
    assert ask(tmp_path / "mine", "book", fallback=rest).mesh.texture[0, 0, 1] == 200


def test_a_folder_for_each_thing_as_ycb_has_it(tmp_path):
    paths = (
        "025_mug/google_16k/textured.obj",
        "025_mug/google_16k/nontextured.obj",
        "025_mug/tsdf/textured.obj",
        "lamps/desk_lamp.glb",
        "003_box/model.glb",
    )
    for path in paths:
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_bytes(b"")
    (tmp_path / "away").symlink_to(tmp_path.parent)
    found = {name: file.relative_to(tmp_path).as_posix() for name, file in
             Folder(str(tmp_path)).files().items()}  # fmt: skip
    assert found == {
        "mug": "025_mug/google_16k/textured.obj",
        "desk_lamp": "lamps/desk_lamp.glb",
        "box": "003_box/model.glb",
    }


def obj(extents: tuple[float, float, float]) -> str:
    made = trimesh.creation.box(extents=extents)
    lines = [f"v {x} {y} {z}" for x, y, z in made.vertices]
    return "\n".join([*lines, *(f"f {a + 1} {b + 1} {c + 1}" for a, b, c in made.faces)])


def test_the_upward_axis_of_an_obj_is_told_by_its_proportions(tmp_path, caplog):
    usual = SizePrior("bottle", np.array([0.075, 0.075, 0.3]))

    def height(extents: tuple[float, float, float], **settings: str) -> float:
        (tmp_path / "bottle.obj").write_text(obj(extents))
        made = Folder(str(tmp_path), **settings).model(instance("bottle"), usual, USUAL_VIEW)
        return float(made.size[2] / made.size[0])

    assert height((0.08, 0.08, 0.3)) > 3 and "z-up" in caplog.text
    caplog.clear()
    assert height((0.08, 0.3, 0.08)) > 3 and not caplog.text
    assert height((0.08, 0.3, 0.08), up="z") < 2


def test_a_unit_makes_the_size_the_file_s_own(tmp_path, caplog):
    (tmp_path / "mug.obj").write_text(obj((9.0, 10.0, 8.0)))
    np.testing.assert_allclose(ask(tmp_path, units="cm").size, [0.09, 0.08, 0.1], rtol=1e-3)
    assert not caplog.text
    ask(tmp_path, units="m")
    assert "times its usual size" in caplog.text
    with pytest.raises(InputError, match=r"Folder\.units: unknown unit 'ft'"):
        Folder(str(tmp_path), units="ft")


def test_an_empty_folder_is_refused_before_any_work(tmp_path):
    backends = Backends.select(modeler=Folder(str(tmp_path)))
    with pytest.raises(BackendError, match="contains no GLB or OBJ file"):
        generate("a desk with a mug", backends)


def test_by_name_the_embedded_modeler_makes_what_has_no_file(tmp_path, monkeypatch, caplog):
    monkeypatch.setenv("TABLETOPGEN_ASSETS", str(tmp_path))
    (tmp_path / "book.glb").write_bytes(box(RED))
    assert type(Backends.select(modeler="folder").modeler.fallback).__name__ == "EmbeddedModeler"


def test_the_environment_names_the_folder(tmp_path, monkeypatch):
    (tmp_path / "mug.glb").write_bytes(box(RED))
    monkeypatch.setenv("TABLETOPGEN_ASSETS", str(tmp_path))
    assert ask("").label == "mug"
    monkeypatch.delenv("TABLETOPGEN_ASSETS")
    with pytest.raises(BackendError, match="Set TABLETOPGEN_ASSETS"):
        ask("")
    with pytest.raises(BackendError, match="is not a folder"):
        ask(tmp_path / "nowhere")


def test_a_broken_file_names_backend_thing_and_file(tmp_path):
    (tmp_path / "mug.glb").write_bytes(b"")
    with pytest.raises(BackendError, match=r"^folder, model of 'mug_1': mug.glb is not a GLB file"):
        ask(tmp_path)
