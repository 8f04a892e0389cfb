"""Conversion of foreign meshes to models: upright, closed, light, with one texture."""

import tracemalloc

import numpy as np
import pytest
import trimesh
from backends.modelers.foreign import edited, glb, instance, plain, striped_box, textured

from generator.errors import BackendError, InputError
from generator.meshes import decimation, texture
from generator.meshes.canonical import Normal, foreign_model, normal_mesh
from generator.meshes.reading.surface import surface_of
from generator.physics.inertia import body_mass, is_watertight
from generator.render.shading import sample_texture
from generator.scene import Mesh, SizePrior
from tabletop_objects import get_category


def read(*meshes: trimesh.Trimesh, **settings) -> Mesh:
    return normal_mesh(glb(*meshes), "the file", **settings)


def colors(mesh: Mesh) -> np.ndarray:
    """The colour in the middle of each face, 0 to 255."""
    return 255 * sample_texture(mesh.texture, mesh.uv[mesh.faces].mean(1))


def middles(mesh: Mesh) -> np.ndarray:
    return mesh.vertices[mesh.faces].mean(1)


def test_a_y_up_file_stands_up():
    mesh = read(striped_box((2.0, 3.0, 1.0)))
    np.testing.assert_allclose(mesh.extent, [2, 1, 3], atol=1e-6)
    red = colors(mesh)[middles(mesh)[:, 2] > 1.4]
    assert len(red) and (red[:, 0] > 200).all()


def test_a_z_up_file_is_not_turned():
    np.testing.assert_allclose(read(striped_box((2, 3, 1)), up="z").extent, [2, 3, 1], atol=1e-6)


def test_its_own_texture_stays_as_it_is():
    mesh = read(striped_box())
    assert mesh.texture.shape == (64, 64, 3)
    assert len(mesh.faces) == 12


def test_turning_up_keeps_faces_outwards_and_is_no_mirror():
    tall = trimesh.creation.box(extents=(1, 1, 1))
    tall.vertices[tall.vertices[:, 0] > 0, 1] *= 2  # higher on the +x side, in front and behind
    tall.vertices[tall.vertices[:, 2] > 0, 0] += 0.5  # what was near (+z) leans to +x
    mesh = read(plain(tall, (9, 9, 9, 255)))
    assert is_watertight(mesh)
    near = mesh.vertices[mesh.vertices[:, 1] < mesh.vertices[:, 1].mean()]
    far = mesh.vertices[mesh.vertices[:, 1] > mesh.vertices[:, 1].mean()]
    assert near[:, 0].mean() > far[:, 0].mean() + 0.4


def test_plain_materials_and_vertex_colors_become_one_texture():
    red = plain(trimesh.creation.box(extents=(1, 1, 1)), (200, 10, 10, 255))
    green = trimesh.creation.icosphere(2, 0.5)
    green.apply_translation([2, 0, 0])
    green.visual = trimesh.visual.ColorVisuals(green, vertex_colors=[10, 180, 10, 255])
    mesh = read(red, green, striped_box().apply_translation([-3, 0, 0]))
    x, seen = middles(mesh)[:, 0], colors(mesh)
    np.testing.assert_allclose(np.median(seen[(x > -1) & (x < 1)], 0), [200, 10, 10], atol=4)
    np.testing.assert_allclose(np.median(seen[x > 1], 0), [10, 180, 10], atol=4)
    assert max(mesh.texture.shape) <= 1024
    left = x < -1
    assert {tuple(c > 100) for c in seen[left]} == {(True, False, False), (False, False, True)}


def test_one_plain_color_needs_no_large_texture():
    mesh = read(plain(trimesh.creation.icosphere(2), (50, 60, 70, 255)))
    np.testing.assert_allclose(mesh.texture.reshape(-1, 3), [[50, 60, 70]] * 16, atol=1)


def test_linear_colors_of_other_programs_look_as_they_do_there():
    def blender(header: dict) -> None:
        header["asset"]["generator"] = "Khronos glTF Blender I/O v4"

    raw = edited(glb(plain(trimesh.creation.box(), (128, 128, 128, 255))), blender)
    assert abs(int(normal_mesh(raw, "the file").texture[0, 0, 0]) - 188) <= 1  # IEC 61966-2-1


def test_glass_stays_see_through():
    assert read(plain(trimesh.creation.box(), (200, 200, 255, 102))).opacity == pytest.approx(0.4)
    both = plain(trimesh.creation.box(), (9, 9, 9, 255))
    both.apply_translation([3, 0, 0])
    assert read(plain(trimesh.creation.box(), (200, 200, 255, 102)), both).opacity == 1


def test_repeating_textures_are_laid_out():
    box = striped_box()
    box.visual.uv = box.visual.uv * [1, 2]
    mesh = read(box)
    assert mesh.uv.min() >= 0 and mesh.uv.max() <= 1
    assert mesh.texture.shape[0] == 512
    assert is_watertight(mesh)


def test_large_textures_are_made_smaller():
    box = striped_box()
    picture = np.zeros((3000, 100, 3), np.uint8)
    mesh = read(textured(box, picture, box.visual.uv))
    assert max(mesh.texture.shape) == 2048


def ball(level: int = 5) -> trimesh.Trimesh:
    """20,480 triangles; red above, blue below (y up)."""
    made = trimesh.creation.icosphere(level, 0.5)
    high = made.vertices[:, 1:2] > 0
    shade = np.where(high, [[220, 20, 20, 255]], [[20, 20, 220, 255]]).astype(np.uint8)
    made.visual = trimesh.visual.ColorVisuals(made, vertex_colors=shade)
    return made


def test_heavy_meshes_are_reduced_with_shape_and_colors_kept():
    mesh = read(ball(), to=Normal(faces=1500, texture=256))
    assert len(mesh.faces) <= 1500
    assert is_watertight(mesh)
    radius = np.linalg.norm(mesh.vertices, axis=1)
    np.testing.assert_allclose(radius, 0.5, atol=0.01)
    z, seen = middles(mesh)[:, 2], colors(mesh)
    assert (seen[z > 0.06, 0] > 180).mean() > 0.97
    assert (seen[z < -0.06, 2] > 180).mean() > 0.97


@pytest.mark.slow
def test_meshes_of_many_faces_are_worked_on_in_parts(monkeypatch):
    """Processing in parts changes no outline, and fewer samples also find the colours."""
    made = ball()
    whole = list(decimation.silhouettes(made.vertices, made.faces, made.vertices))
    monkeypatch.setattr(decimation, "_AT_ONCE", 999)
    parts = list(decimation.silhouettes(made.vertices, made.faces, made.vertices))
    assert np.array_equal(whole, parts)
    monkeypatch.setattr(texture, "_AT_ONCE", 5000)
    monkeypatch.setattr(texture, "_MOST_SAMPLES", 4000)
    surface = surface_of([made], "it")
    nearby = texture.Nearby.of(surface)
    assert len(nearby.owner) == 4000
    assert np.ptp(nearby.samples, axis=0) == pytest.approx([1, 1, 1], abs=0.02)
    mesh = read(made, to=Normal(faces=1500, texture=256))
    z, seen = middles(mesh)[:, 2], colors(mesh)
    assert (seen[z > 0.06, 0] > 180).mean() > 0.97
    assert (seen[z < -0.06, 2] > 180).mean() > 0.97


@pytest.mark.slow
def test_what_is_worked_out_for_texels_is_held_for_few_at_once(monkeypatch):
    monkeypatch.setattr(texture, "_AT_ONCE", 2000)
    surface = surface_of([trimesh.creation.icosphere(1)], "it")
    tracemalloc.start()
    try:
        texture.painted_shape(surface.vertices, surface.faces, surface, 512)
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < 150 * 512**2  # 215 where all are worked on together


@pytest.mark.slow
def test_the_same_file_gives_the_same_bytes():
    one, two = (read(ball(4), to=Normal(faces=1000, texture=128)) for _ in range(2))
    assert one.texture.tobytes() == two.texture.tobytes()
    assert one.vertices.tobytes() == two.vertices.tobytes()


def test_a_shape_that_reduction_would_destroy_is_refused():
    pins = [trimesh.creation.cylinder(0.01, 1, 12) for _ in range(24)]
    for k, pin in enumerate(pins):
        pin.apply_translation([k % 8 * 0.1, k // 8 * 0.1, 0])
    with pytest.raises(BackendError, match="triangles and cannot be simplified to 200"):
        read(trimesh.util.concatenate(pins), to=Normal(faces=50))


def test_faces_the_wrong_way_are_turned():
    ball = trimesh.creation.icosphere(2)
    ball.faces[::3] = ball.faces[::3, ::-1]
    assert is_watertight(read(plain(ball, (9, 9, 9, 255))))
    ball = trimesh.creation.icosphere(2)
    ball.invert()
    assert is_watertight(read(plain(ball, (9, 9, 9, 255))))


def test_small_holes_are_closed_and_mouths_stay_open():
    ball = trimesh.creation.icosphere(3)
    ball.update_faces(np.arange(len(ball.faces)) != 7)
    closed = read(plain(ball, (9, 9, 9, 255)), to=Normal(texture=64))
    assert is_watertight(closed)
    np.testing.assert_allclose(colors(closed), 9, atol=1)
    cup = trimesh.creation.icosphere(2)
    cup.update_faces(cup.triangles_center[:, 1] < 0.3)
    assert not is_watertight(read(plain(cup, (9, 9, 9, 255))))


def test_doubled_faces_inner_walls_and_crumbs_go():
    two = [trimesh.creation.box(), trimesh.creation.box().apply_transform(np.diag([-1, 1, 1, 1]))]
    two[1].apply_translation([1, 0, 0])
    crumb = trimesh.creation.icosphere(0, 1e-3).apply_translation([9, 9, 9])
    doubled = trimesh.util.concatenate([*two, two[0], crumb])
    mesh = read(plain(doubled, (9, 9, 9, 255)))
    assert is_watertight(mesh)
    np.testing.assert_allclose(mesh.extent, [2, 1, 1], atol=1e-6)
    assert len(mesh.faces) == 20


def test_what_is_no_solid_thing_is_refused():
    flat = trimesh.Trimesh([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], [[0, 1, 2], [0, 2, 3]])
    with pytest.raises(BackendError, match="flat"):
        read(flat)


def test_models_have_the_prior_s_size_and_weigh_as_their_kind_does():
    mesh = read(striped_box((2.0, 1.0, 1.0)))
    made = foreign_model(mesh, instance("book"), SizePrior("book", np.array([0.1, 0.2, 0.05])))
    np.testing.assert_allclose(made.size, np.sort(made.size)[[2, 0, 1]])
    np.testing.assert_allclose(made.size[0] * made.size[1], 0.1 * 0.2, rtol=1e-6)
    assert (made.name, made.label, made.category) == ("book_1", "book", "book")
    usual = np.array(get_category("book").size)
    weighed = body_mass(made.mesh, usual, made.physics, ())
    assert weighed.mass == pytest.approx(get_category("book").mass, rel=0.01)
    odd = foreign_model(mesh, instance("gizmo"), SizePrior("gizmo", np.ones(3)))
    assert odd.category == "generic" and not odd.container


def test_vessels_are_containers():
    prior = SizePrior("mug", np.array([0.12, 0.09, 0.1]))
    assert foreign_model(read(striped_box()), instance("mug"), prior).container


def test_a_texture_too_small_for_all_faces_grows():
    """Faces with different directions are islands, and islands need gutters."""
    rng = np.random.default_rng(0)
    rough = trimesh.creation.icosphere(3)
    rough.vertices *= rng.uniform(0.6, 1.4, (len(rough.vertices), 1))
    shade = rng.integers(0, 255, (len(rough.vertices), 3))
    rough.visual = trimesh.visual.ColorVisuals(rough, vertex_colors=shade)
    assert read(rough, to=Normal(texture=16)).texture.shape[0] == 256


def test_settings_out_of_range_are_refused():
    with pytest.raises(InputError, match=r"Normal\.texture must"):
        Normal(texture=4096)


def test_what_is_evenly_subdivided_is_reduced_too():
    """Quadric error decimation rejects the collapses of a flat lattice as flips."""
    top = trimesh.creation.box((1.2, 0.03, 0.7))
    legs = [trimesh.creation.cylinder(0.03, 0.7, sections=64) for _ in range(2)]
    parts = [top, *(leg.apply_translation((0.4 * k - 0.2, 0, 0)) for k, leg in enumerate(legs))]
    for _ in range(4):
        parts = [part.subdivide() for part in parts]
    made = trimesh.util.concatenate(parts)
    vertices, faces = decimation.reduce(
        np.asarray(made.vertices), np.asarray(made.faces), 3000, "a table"
    )
    assert len(made.faces) > 100_000 and len(faces) <= 12_000
    np.testing.assert_allclose(np.ptp(vertices, axis=0), made.extents, atol=2e-3)
