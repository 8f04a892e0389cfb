import numpy as np
import pytest
import trimesh

from generator.errors import SceneError
from generator.geometry import Camera
from generator.render.raster import BACKGROUND, Item, render
from generator.render.scanlines import MOST_LAYERS, rasterise
from generator.render.shading import Light, corner_normals, sample_texture
from generator.render.sheet import framing_camera
from generator.scene import View

VIEW = View(0.3, 0.9, 0.6)


def item(mesh: trimesh.Trimesh, id: int, color=(200, 40, 40), opacity: float = 1.0) -> Item:
    uv = np.zeros((len(mesh.vertices), 2))
    texture = np.array([[color]], np.uint8)
    return Item(mesh.vertices.copy(), mesh.faces.copy(), uv, texture, id, opacity)


def camera(size: int = 120) -> Camera:
    return Camera.looking_at([0, 0, 0], VIEW, 2.0, size, size)


def test_depth_of_a_sphere_is_exact_at_its_centre() -> None:
    result = render([item(trimesh.creation.icosphere(4, 0.3), 5)], camera(121), supersample=1)
    assert result.ids[60, 60] == 5
    assert result.depth[60, 60] == pytest.approx(2.0 - 0.3, abs=1e-3)
    assert result.ids[0, 0] == BACKGROUND
    assert np.isinf(result.depth[0, 0])


def test_silhouette_area_matches_the_projected_disc() -> None:
    cam = camera(400)
    result = render([item(trimesh.creation.icosphere(4, 0.3), 0)], cam, supersample=1)
    radius = np.tan(np.arcsin(0.3 / 2.0)) * cam.focal
    assert (result.ids == 0).sum() == pytest.approx(np.pi * radius**2, rel=0.01)


def test_nearer_things_hide_farther_ones() -> None:
    near = trimesh.creation.box((0.2, 0.2, 0.2))
    near.apply_translation(0.5 * (camera().position / 2.0))
    far = trimesh.creation.box((0.9, 0.9, 0.9))
    for order in ([item(far, 1), item(near, 2)], [item(near, 2), item(far, 1)]):
        assert render(order, camera()).ids[60, 60] == 2


def test_glass_shows_what_is_behind_it() -> None:
    ball = item(trimesh.creation.icosphere(2, 0.1), 1, (255, 0, 0))
    pane = item(trimesh.creation.icosphere(2, 0.4), 2, (0, 0, 255), opacity=0.3)
    through = render([ball, pane], camera()).image[60, 60].astype(int)
    assert through[0] > through[2] > 0


def test_a_shadow_falls_away_from_the_sun() -> None:
    floor = trimesh.creation.box((2, 2, 0.02))
    ball = trimesh.creation.icosphere(2, 0.15)
    ball.apply_translation([0, 0, 0.16])
    things = [item(floor, 0, (255, 255, 255)), item(ball, 1)]
    cam = Camera.looking_at([0, 0, 0], View(0.0, 1.5, 0.8), 3.0, 200, 200)
    image = render(things, cam, light=Light(np.array([-1.0, 0.0, 1.0]))).image.astype(int)
    right, left = cam.project(np.array([[0.25, 0, 0.01], [-0.25, 0, 0.01]])).astype(int)
    assert image[right[1], right[0]].sum() < image[left[1], left[0]].sum() - 60


def test_same_input_gives_the_same_bytes() -> None:
    things = [item(trimesh.creation.capsule(0.3, 0.1), 3)]
    first, second = render(things, camera()), render(things, camera())
    assert first.image.tobytes() == second.image.tobytes()
    assert first.depth.tobytes() == second.depth.tobytes()


def test_nothing_to_draw_is_background() -> None:
    assert (render([], camera()).image == 255).all()


def test_texture_is_upright() -> None:
    texture = np.array([[[255, 0, 0], [0, 255, 0]], [[0, 0, 255], [0, 0, 0]]], np.uint8)
    corners = np.array([[0.0, 1.0], [1.0, 1.0], [0.0, 0.0], [1.0, 0.0]])
    assert np.allclose(sample_texture(texture, corners) * 255, texture.reshape(4, 3))


def test_normals_are_smooth_on_a_ball_and_sharp_on_a_box() -> None:
    ball = trimesh.creation.icosphere(3)
    normals = corner_normals(ball.vertices, ball.faces)
    assert np.allclose(normals, ball.vertices[ball.faces], atol=0.02)
    box = trimesh.creation.box((1, 1, 1))
    normals = corner_normals(box.vertices, box.faces)
    assert np.allclose(normals, box.face_normals[:, None], atol=1e-6)


def test_interpolation_is_linear_over_a_triangle() -> None:
    corners = np.array([[[0, 0, 1.0], [20, 0, 2.0], [0, 20, 3.0]]])
    owner, weights, near = rasterise(corners, 20, 20)
    pixel = 4 * 20 + 6
    assert owner[pixel] == 0
    assert weights[pixel].sum() == pytest.approx(1)
    assert near[pixel] == pytest.approx(1 + 6.5 / 20 + 2 * 4.5 / 20)


def test_framing_shows_everything_with_its_margin() -> None:
    points = np.random.default_rng(0).uniform(-1, 1, (50, 3)) * [0.8, 0.4, 0.3]
    pixels = framing_camera(points, VIEW, 320, 240, margin=0.1).project(points)
    low, high = pixels.min(0), pixels.max(0)
    assert (low >= [31, 23]).all()
    assert (high <= [289, 217]).all()
    assert ((high - low) / [256, 192]).max() == pytest.approx(1, abs=0.02)


@pytest.mark.slow
@pytest.mark.parametrize("piece", [37, 1 << 30])
def test_the_same_bytes_however_pixels_are_cut_up(monkeypatch, piece):
    from generator.render import raster

    things = [
        item(trimesh.creation.box((0.9, 0.9, 0.1)), 1),
        item(trimesh.creation.icosphere(3, 0.3), 2, (20, 90, 200)),
        item(trimesh.creation.icosphere(2, 0.4), 3, (0, 0, 255), opacity=0.3),
    ]
    usual = render(things, camera()).image
    monkeypatch.setattr(raster, "_PIECE", piece)
    np.testing.assert_array_equal(render(things, camera()).image, usual)


def test_triangles_are_drawn_alike_in_portions_of_any_size(monkeypatch) -> None:
    mesh = trimesh.creation.icosphere(3, 0.3)
    whole = render([item(mesh, 0)], camera(60))
    monkeypatch.setattr("generator.render.scanlines._CHUNK", 500)
    monkeypatch.setattr("generator.render.shading._PIECE", 500)
    portions = render([item(mesh, 0)], camera(60))
    assert (portions.image == whole.image).all()
    assert (portions.depth == whole.depth).all()


@pytest.mark.parametrize("corner", [(64.0, 0.0), (0.01, 64.0)], ids=["wide", "thin"])
def test_what_lies_in_too_many_layers_is_not_drawn(corner: tuple[float, float]) -> None:
    one = np.array([[0.0, 0.0, 1.0], [*corner, 1.0], [0.0, 64.0, 1.0]])
    sheet = np.array([[0.0, 0.0, 1.0], [64.0, 0.0, 1.0], [0.0, 64.0, 1.0]])
    few = np.concatenate([np.repeat(sheet[None], 2 * MOST_LAYERS - 2, 0), one[None]])
    assert (rasterise(few, 64, 64)[0] >= 0).any()
    many = np.repeat(one[None], 70 * MOST_LAYERS, 0)
    with pytest.raises(SceneError, match="layers"):
        rasterise(many, 64, 64)


def test_a_fan_of_very_many_faces_is_shaded_flat() -> None:
    """A comparison of all of its corners would need 4e8 pairs."""
    angles = np.linspace(0, 2 * np.pi, 20_000)
    rim = np.column_stack([np.cos(angles), np.sin(angles), 0.1 * np.sin(9 * angles)])
    k = np.arange(len(rim) - 1)
    faces = np.column_stack([np.full(len(k), len(rim)), k, k + 1])
    normals = corner_normals(np.vstack([rim, [[0, 0, 1]]]), faces)
    assert (normals[:, 0] == normals[:, 1]).all()
    assert np.linalg.norm(normals, axis=-1) == pytest.approx(np.ones((len(k), 3)))
