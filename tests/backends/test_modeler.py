"""Analysis by synthesis: the modeler on rendered shapes without further information."""

from functools import cache

import cv2
import numpy as np
import pytest
import shapely
import trimesh

from generator.backends.embedded.completion import complete
from generator.backends.embedded.modeler import EmbeddedModeler
from generator.backends.embedded.shapes import generic as choosing
from generator.backends.embedded.shapes import solids
from generator.backends.embedded.shapes.frames import frame_to_mask, small_mask
from generator.errors import InputError
from generator.geometry import Camera, mask_box, ray_view, rotation_z, view_rotation, yaw_quaternion
from generator.meshes.pixels import mask_iou
from generator.meshes.projection import Projection, camera_view
from generator.meshes.texture_bake import sample
from generator.render.raster import Item, place, render
from generator.scene import (
    Detection,
    Instance,
    Model,
    Proportions,
    Reference,
    SizePrior,
    View,
)
from tabletop_objects import CATEGORIES, build

VIEW = View(0.0, np.deg2rad(48), np.deg2rad(36))
SIZE = 480, 640
BOTTLE = np.array([[0, 0.03], [0.12, 0.035], [0.16, 0.013], [0.22, 0.012]])
L_SHAPE = shapely.Polygon([(0, 0), (0.2, 0), (0.2, 0.05), (0.06, 0.05), (0.06, 0.16), (0, 0.16)])
FRAME = shapely.Polygon([(-0.08, 0), (0.08, 0), (0.08, 0.22), (-0.08, 0.22)])


def revolution(profile: np.ndarray) -> solids.ConvexSolid:
    heights, radii = profile.T
    return solids.stack_of_ellipses(heights, radii, np.zeros_like(radii), 1.0)


SHAPES = {
    "box": (solids.box(0.18, 0.1, 0.12), (0.18, 0.1, 0.12)),
    "cylinder": (revolution(np.array([[0, 0.05], [0.12, 0.05]])), (0.1, 0.1, 0.12)),
    "bottle": (revolution(BOTTLE), (0.07, 0.07, 0.22)),
    "prism": (solids.prism(L_SHAPE, 0.015), (0.2, 0.16, 0.015)),
    "upright": (solids.upright(FRAME, 0.02), (0.16, 0.02, 0.22)),
}
YAWS = {"box": 0.6, "prism": 0.4, "upright": 0.25}


def shot(item: Item, label: str) -> tuple[Instance, View]:
    """Render one item off the picture's centre and complete its crop, as the stages would."""
    camera = Camera.looking_at(np.array([0.1, -0.05, 0]), VIEW, 1.6, SIZE[1], SIZE[0])
    drawn = render([item], camera, background=(235, 230, 222))
    mask = drawn.ids == item.id
    detection = Detection(label, mask_box(mask), mask)
    instance = complete(Reference(drawn.image), detection, ())
    middle = (instance.box[:2] + instance.box[2:]) / 2
    return instance, ray_view(VIEW, middle, SIZE[1], SIZE[0])


@cache
def generic(kind: str) -> tuple[Instance, View, Model]:
    solid, size = SHAPES[kind]
    world = solid.vertices @ rotation_z(YAWS.get(kind, 0.0)).T + [-0.15, 0.1, 0]
    uv = np.column_stack([np.full(len(world), 0.5), np.full(len(world), 0.5)])
    texture = np.full((2, 2, 3), (60, 140, 90), np.uint8)
    instance, view = shot(Item(world, solid.faces, uv, texture, 1), "object")
    return (
        instance,
        view,
        EmbeddedModeler().model(instance, SizePrior("object", np.array(size)), view),
    )


def overlap(model: Model, instance: Instance, view: View) -> float:
    """Return the best silhouette overlap of a model over yaw, from the instance's own view."""
    small = Projection.of_instance(instance, view).resize(120)
    mask = small_mask(instance, small)

    def at(yaw: float) -> float:
        shape = model.mesh.vertices * model.size @ rotation_z(yaw).T
        scale, shift = frame_to_mask(shape, small, mask)
        return mask_iou(small.silhouette(shape * scale + shift, model.mesh.faces), mask)

    best = max(np.arange(0, 2 * np.pi, np.pi / 24), key=at)
    return max(at(yaw) for yaw in best + np.deg2rad([-5, -2.5, 0, 2.5, 5]))


def welded(model: Model) -> trimesh.Trimesh:
    mesh = trimesh.Trimesh(model.mesh.vertices, model.mesh.faces, process=False)
    mesh.merge_vertices(merge_tex=True, merge_norm=True)
    return mesh


@pytest.mark.slow
@pytest.mark.parametrize("kind", SHAPES)
def test_silhouettes_are_met_again_from_the_same_view(kind):
    instance, view, model = generic(kind)
    assert overlap(model, instance, view) >= 0.85


@pytest.mark.slow
@pytest.mark.parametrize("kind", SHAPES)
def test_meshes_are_closed_and_parts_cover_them(kind):
    model = generic(kind)[2]
    mesh = welded(model)
    assert mesh.is_watertight and mesh.volume > 0
    points = np.concatenate([p.vertices for p in model.parts])
    np.testing.assert_allclose(points.min(0), -0.5, atol=0.03)
    np.testing.assert_allclose(points.max(0), 0.5, atol=0.03)
    hulls = [trimesh.convex.convex_hull(p.vertices) for p in model.parts]
    assert sum(h.volume for h in hulls) >= 0.9 * mesh.volume


@pytest.mark.slow
@pytest.mark.parametrize("kind", SHAPES)
def test_bottoms_are_flat_under_the_centre_of_mass(kind):
    mesh = welded(generic(kind)[2])
    low = mesh.vertices[mesh.vertices[:, 2] < -0.5 + 1e-3, :2]
    foot = shapely.MultiPoint(low).convex_hull
    assert foot.contains(shapely.Point(mesh.center_mass[:2]))


@pytest.mark.slow
@pytest.mark.parametrize("kind", SHAPES)
def test_colors_come_from_the_picture(kind):
    instance, _, model = generic(kind)
    opaque = instance.crop[instance.crop[..., 3] > 250][:, :3]
    uv = model.mesh.uv[model.mesh.faces].mean(1)
    side = np.array(model.mesh.texture.shape[1::-1])
    texels = sample(model.mesh.texture, np.column_stack([uv[:, 0], 1 - uv[:, 1]]) * side)
    assert np.abs(np.median(texels, 0) - np.median(opaque, 0)).max() < 45


def test_a_box_keeps_its_measures_and_its_primitive():
    model = generic("box")[2]
    assert [p.kind for p in model.parts] == ["box"]
    np.testing.assert_allclose(model.size, [0.18, 0.1, 0.12], rtol=0.15)


def test_round_things_become_revolutions():
    for kind, height in (("cylinder", 0.12), ("bottle", 0.22)):
        model = generic(kind)[2]
        assert model.size[0] == pytest.approx(model.size[1], rel=0.02)
        assert model.size[2] / model.size[0] == pytest.approx(height / SHAPES[kind][1][0], rel=0.15)
        assert len(model.parts) <= 8


@pytest.mark.slow
def test_same_input_same_bytes():
    instance, view, model = generic("box")
    again = EmbeddedModeler().model(
        instance, SizePrior("object", np.array([0.18, 0.1, 0.12])), view
    )
    np.testing.assert_array_equal(model.mesh.vertices, again.mesh.vertices)
    np.testing.assert_array_equal(model.mesh.texture, again.mesh.texture)


@pytest.mark.slow
@pytest.mark.parametrize("key, yaw", [("mug", 0.7), ("screwdriver", -2.0)])
def test_catalogue_things_are_recognised_in_shape_and_color(key, yaw):
    truth = build(key, 77)
    item = place(
        truth.mesh, truth.size, np.array([0.0, 0.05, truth.size[2] / 2]), yaw_quaternion(yaw), 1
    )
    instance, view = shot(item, key)
    model = EmbeddedModeler().model(instance, SizePrior(key, truth.size), view)
    assert model.category == key and model.container == truth.container
    assert overlap(model, instance, view) >= 0.85
    np.testing.assert_allclose(model.size, truth.size, rtol=0.2)


@pytest.mark.slow
def test_a_wrong_label_gives_way_to_the_silhouette():
    instance, view, _ = generic("prism")
    wrong = Instance("mug_1", "mug", instance.box, instance.mask, instance.crop, instance.crop_box)
    model = EmbeddedModeler().model(wrong, SizePrior("mug_1", np.array([0.2, 0.16, 0.015])), view)
    assert model.category == "generic"


def test_projection_agrees_with_the_camera_that_took_the_picture():
    instance, view, _ = generic("box")
    assert camera_view(
        view, (instance.box[:2] + instance.box[2:]) / 2, SIZE[1], SIZE[0]
    ).elevation == pytest.approx(VIEW.elevation, abs=1e-6)
    projection = Projection.of_instance(instance, view)
    x0, y0, x1, _ = instance.crop_box
    zoom = projection.width / (x1 - x0)
    middle = ((instance.box[:2] + instance.box[2:]) / 2 - [x0, y0]) * zoom
    np.testing.assert_allclose(projection.project(np.zeros((1, 3)))[0], middle, atol=1.0)
    up = projection.project(np.array([[0, 0, 10.0]]))[0]
    assert up[1] < middle[1]


def test_accidental_views_cost():
    instance, view, _ = generic("box")
    small = Projection.of_instance(instance, view).resize(60)
    long = solids.box(3.0, 1.0, 0.5)
    away = float(np.arctan2(small.away[1], small.away[0]))
    pointing = solids.PosedSolid("box", long, away, np.zeros(3))
    across = solids.PosedSolid("box", long, away + np.pi / 2, np.zeros(3))
    assert choosing.accident(pointing, small) > 0 == choosing.accident(across, small)


def test_convex_pieces_tile_the_outline():
    pieces = solids.convex_pieces(L_SHAPE)
    assert 2 <= len(pieces) <= 8
    assert shapely.union_all(pieces).symmetric_difference(L_SHAPE).area < 1e-9
    assert all(p.convex_hull.area - p.area < 0.05 * L_SHAPE.area for p in pieces)


@pytest.mark.parametrize("elevation", [3.0, 20.0, 60.0, 80.0, 88.0])
def test_no_outline_is_drawn_out_beyond_all_bounds(elevation: float) -> None:
    """A standing profile seen from above, or a slab seen from its edge, is not a candidate."""
    camera = camera_view(View(0.0, np.deg2rad(elevation), 0.7), np.array([60.0, 60.0]), 120, 120)
    rotation, focal = view_rotation(camera), 150.0
    small = Projection(rotation, -focal * rotation[2], focal, np.array([60.0, 60.0]), 120, 120)
    mask = cv2.line(np.zeros((120, 120), np.uint8), (20, 100), (95, 15), 1, 9) > 0
    found = choosing.candidates(mask, small, np.array([0.1, 0.1, 0.1]))
    assert found and all(np.ptp(p.solid.vertices, axis=0).max() < 1200 for p in found)


@pytest.mark.slow
@pytest.mark.parametrize(("tall", "stands"), [(1.4, True), (0.06, False)])
def test_what_it_looks_like_decides_whether_an_outline_lies_or_stands(tall: float, stands: bool):
    instance, view, _ = generic("upright")
    seen = Proportions(np.log([0.7 if not stands else 0.15, tall]), np.array([0.3, 0.2]))
    size = SizePrior("object", 0.2 * seen.extent, seen=seen)
    model = EmbeddedModeler().model(instance, size, view)
    assert (model.size[2] > 0.8 * max(model.size[:2])) == stands


@pytest.mark.slow
@pytest.mark.parametrize("label", ["book", "mug"])
def test_a_name_whose_shape_the_look_belies_does_not_decide_the_solid(label: str):
    key, extent = ("cereal_box", (0.19, 0.07, 0.28)) if label == "book" else ("mug", None)
    made = build(key, 0)
    size = np.array(made.size if extent is None else extent)
    item = place(made.mesh, size, np.array([0, 0, size[2] / 2]), yaw_quaternion(0.5), 1)
    instance, view = shot(item, label)
    width, length = np.sort(size[:2])
    seen = Proportions(np.log([width / length, size[2] / length]), np.array([0.2, 0.2]))
    prior = SizePrior(label, np.array(CATEGORIES[label].size), seen=seen)
    model = EmbeddedModeler().model(instance, prior, view)
    assert seen.gap(model.size) < 2.0  # a lying book's is far above
    assert seen.gap(prior.extent) > 5.0 or model.category == "mug"


def test_a_gap_is_counted_in_expected_errors():
    seen = Proportions(np.log([0.5, 2.0]), np.array([0.1, 0.4]))
    assert seen.gap(np.array([0.1, 0.2, 0.4])) == pytest.approx(0.0)
    assert seen.gap(np.array([0.2, 0.1, 0.4 * np.exp(0.4)])) == pytest.approx(0.5)
    np.testing.assert_allclose(seen.extent, [1.0, 0.5, 2.0])
    with pytest.raises(InputError, match="finite"):
        Proportions(np.array([np.nan, 0.0]), np.ones(2))
    with pytest.raises(InputError, match="spread"):
        Proportions(np.zeros(2), np.array([0.0, 1.0]))
