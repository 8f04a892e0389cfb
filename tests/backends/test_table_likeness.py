"""A table reconstructed from its picture: outline, legs, height and colours."""

from dataclasses import replace

import cv2
import numpy as np
import pytest
import shapely

from generator.backends.embedded.completion import complete
from generator.backends.embedded.plane.free_outline import as_seen
from generator.backends.embedded.plane.outline import Outline, walk
from generator.backends.embedded.plane.plane import TablePlane, fit_plane
from generator.backends.embedded.table_form import TableForm, corners_of
from generator.backends.embedded.table_likeness import find_strange, model_table, top_colors
from generator.geometry import Camera, mask_box, ray_view, yaw_quaternion
from generator.meshes.pixels import hull_corners, mask_iou
from generator.render.raster import Rendered, place, render
from generator.scene import Detection, Mesh, Model, Reference, SizePrior, View
from tabletop_objects.kit.outlines import ellipse, rectangle, rounded_polygon

VIEW = View(0.0, float(np.deg2rad(38.0)), float(np.deg2rad(36.0)))
WIDTH, HEIGHT = 480, 360


def bowed(length: float, depth: float) -> np.ndarray:
    """A triangle with bowed sides: none of the shapes that are fitted."""
    corners = np.array([[-0.5, -0.4], [0.5, -0.4], [0.0, 0.6]]) * [length, depth]
    swollen = shapely.Polygon(rounded_polygon(corners, 0.12 * depth, 6))
    disc = shapely.Point(0, 0.05).buffer(0.62 * length).intersection(swollen.buffer(0.04))
    points = shapely.get_coordinates(shapely.orient_polygons(disc).exterior)[:-1]
    points = points - (points.min(0) + points.max(0)) / 2
    return points / np.ptp(points, axis=0) * [length, depth]


HEXAGON = np.array(
    [[0.6, 0.0], [0.3, 0.36], [-0.3, 0.36], [-0.6, 0.0], [-0.3, -0.36], [0.3, -0.36]]
)
TOPS = {
    "rectangle": rectangle(1.2, 0.7, 0.02, 3),
    "rounded": rectangle(1.2, 0.7, 0.12, 6),
    "round": ellipse(1.2, 1.2, 64),
    "oval": ellipse(1.2, 0.75, 64),
    "triangle": np.array([[-0.6, -0.5], [0.6, -0.5], [0.0, 0.5]]),
    "bowed triangle": bowed(1.2, 0.95),
    "hexagon": HEXAGON,
}


def overlap(a: np.ndarray, b: np.ndarray) -> float:
    """Intersection over union of two outlines."""
    one, other = shapely.Polygon(a), shapely.Polygon(b)
    return one.intersection(other).area / one.union(other).area


NOTHING = np.zeros((HEIGHT, WIDTH), bool)


def found_plane(
    top: np.ndarray, view: View, told: View, hidden: np.ndarray = NOTHING
) -> TablePlane:
    """Find the plane of a top (metres) from its picture."""
    camera = Camera.looking_at(np.zeros(3), view, 3.0, WIDTH, HEIGHT)
    pixels = camera.project(np.column_stack([top, np.zeros(len(top))]))
    mask = np.zeros((HEIGHT, WIDTH), np.uint8)
    cv2.fillPoly(mask, [np.round((pixels - 0.5) * 16).astype(np.int32)], 1, cv2.LINE_8, 4)
    seen = (mask > 0) & ~hidden
    hull = hull_corners(seen)
    outline = Outline(hull, walk(hull, 240)[0], hidden, seen)
    return as_seen(fit_plane(outline, 1.0, (WIDTH, HEIGHT), told), outline, 1.0)


@pytest.mark.slow
@pytest.mark.parametrize("name", [*TOPS])
def test_the_outline_of_a_top_is_found_in_metres(name):
    told = replace(VIEW, elevation=VIEW.elevation + 0.03)
    plane = found_plane(TOPS[name], VIEW, told)
    assert overlap(plane.top(), TOPS[name]) > 0.92
    np.testing.assert_allclose(np.ptp(plane.top(), axis=0), plane.size, rtol=0.01)


def test_a_turned_rectangle_is_a_rectangle():
    plane = found_plane(TOPS["rectangle"], replace(VIEW, azimuth=0.5), VIEW)
    assert plane.edge is None and plane.shape == "rectangle"
    assert overlap(plane.top(), TOPS["rectangle"]) > 0.94
    assert plane.view.azimuth == pytest.approx(0.5, abs=0.06)


@pytest.mark.parametrize(("name", "free"), [("oval", False), ("hexagon", True)])
def test_only_what_no_shape_explains_is_drawn_freely(name, free):
    plane = found_plane(TOPS[name], VIEW, VIEW)
    assert (plane.edge is not None) == free
    assert plane.mask(0.05).sum() > plane.mask().sum() > plane.mask(-0.05).sum()


@pytest.mark.slow
def test_a_corner_behind_a_thing_is_still_a_corner():
    whole = found_plane(TOPS["rectangle"], VIEW, VIEW)
    outline = whole.to_pixels(whole.top())
    corner = outline[np.lexsort((outline[:, 0], outline[:, 1] // 4))[0]]
    y, x = np.mgrid[:HEIGHT, :WIDTH] + 0.5
    thing = (np.abs(x - corner[0]) < WIDTH / 12) & (np.abs(y - corner[1]) < HEIGHT / 12)
    seen = found_plane(TOPS["rectangle"], VIEW, VIEW, thing)
    assert seen.edge is None and overlap(seen.top(), TOPS["rectangle"]) > 0.9


def test_what_things_add_to_the_outline_says_nothing_of_its_shape():
    """An object at the far edge, partly taken for the top, bends the hull on both of its sides."""
    plane = found_plane(TOPS["rectangle"], VIEW, VIEW)
    y, x = np.mgrid[:HEIGHT, :WIDTH] + 0.5
    far = plane.to_pixels(plane.top())[:, 1].min()
    thing = (np.abs(x - WIDTH / 2) < WIDTH / 20) & (np.abs(y - far) < 30)
    top = plane.mask() | thing
    hull = hull_corners(top)
    bent = Outline(hull, walk(hull, 240)[0], thing, top)
    assert as_seen(plane, bent, 1.0).edge is None
    grown = Outline(hull, walk(hull, 240)[0], NOTHING, top)
    assert as_seen(plane, grown, 1.0).edge is not None


# ------------------------------------------------------------------------------ the whole table
def drawn(model: Model, view: View = VIEW) -> Rendered:
    camera = Camera.looking_at(np.array([0, 0, 0.5]), view, 3.2, WIDTH, HEIGHT)
    middle = np.array([0, 0, model.size[2] / 2])
    return render([place(model.mesh, model.size, middle, yaw_quaternion(0), 1)], camera)


def rebuilt(truth: Model, outline: np.ndarray | None) -> tuple[Rendered, Rendered, Model]:
    """Draw a table, model it from its crop, and draw the model from the same place."""
    shown = drawn(truth)
    mask = shown.ids == 1
    instance = complete(Reference(shown.image), Detection("table", mask_box(mask), mask), ())
    view = ray_view(VIEW, (instance.box[:2] + instance.box[2:]) / 2, WIDTH, HEIGHT)
    size = SizePrior("table", np.array([*truth.size[:2], 0.74]), outline=outline)
    model = model_table(instance, size, view, 0, 256)
    return shown, drawn(model), model


def form(name: str, height: float, **words: object) -> TableForm:
    return TableForm(TOPS[name], corners_of(TOPS[name]), height, **words)  # type: ignore[arg-type]


FORMS = {
    "coffee table": form("rectangle", 0.42),
    "tapered": form("bowed triangle", 0.7, inset=(0.15, 0.0), high=0.07, low=0.03),
    "pedestal": form("round", 0.8, legs="pedestal", high=0.12, low=0.6),
    "sled": form("rectangle", 0.5, legs="sled"),
    "splayed": form("rounded", 0.72, inset=(0.2, 0.15), lean=0.1, high=0.05, low=0.03),
}


@pytest.mark.slow
@pytest.mark.parametrize("name", [*FORMS])
def test_legs_and_height_are_those_of_the_picture(name):
    truth = FORMS[name]
    shown, again, model = rebuilt(truth.build(), truth.outline)
    assert model.size[2] == pytest.approx(truth.height, rel=0.07)
    assert mask_iou(shown.ids == 1, again.ids == 1) > 0.93
    np.testing.assert_allclose(model.size[:2], truth.size[:2])


@pytest.mark.slow
def test_a_shape_that_nobody_told_is_tried_out():
    shown, again, model = rebuilt(form("oval", 0.7).build(), None)
    assert mask_iou(shown.ids == 1, again.ids == 1) > 0.93
    rim = np.abs(model.mesh.vertices[:, :2]).sum(1)[model.mesh.vertices[:, 2] > 0.49]
    assert rim.max() < 0.9, "an oval has no corners"


def test_legs_that_lean_beyond_the_top_keep_their_thickness():
    leaning = form("rectangle", 0.7, inset=(0.03, 0.03), lean=0.3, high=0.04, low=0.008)
    for ring in leaning.pieces():
        np.testing.assert_allclose(np.ptp(ring[:, :, :2], axis=1), [[0.008] * 2, [0.04] * 2])
    assert leaning.build().size == pytest.approx(leaning.size)


def test_three_legs_for_a_triangle_four_for_the_rest():
    counts = {name: len(corners_of(top)) for name, top in TOPS.items()}
    assert counts == {name: 3 if "triangle" in name else 4 for name in TOPS}


def painted(model: Model, texture: np.ndarray) -> Model:
    """Lay a texture flat over a table, seen from above."""
    m = model.mesh
    return replace(model, mesh=Mesh(m.vertices, m.faces, m.vertices[:, :2] + 0.5, texture))


STRIPES = np.repeat(np.array([[90, 60, 40], [190, 140, 90]] * 4, np.uint8)[:, None], 8, 1)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("texture", "least", "most", "off"),
    [
        (np.full((8, 8, 3), 236, np.uint8), 0, 3, 8),
        (np.kron(STRIPES, np.ones((16, 16, 1), np.uint8)).astype(np.uint8), 40, 255, 14),
    ],
    ids=["white", "striped"],
)
def test_a_white_top_stays_plain_and_a_striped_one_keeps_its_stripes(texture, least, most, off):
    truth = form("rectangle", 0.7)
    shown, again, _ = rebuilt(painted(truth.build(), texture), truth.outline)
    upper = (shown.ids == 1) & (again.ids == 1) & (np.arange(HEIGHT)[:, None] < HEIGHT // 2)
    low, high = np.quantile(again.image[upper].mean(1), [0.1, 0.9])
    assert least <= high - low <= most
    assert np.abs(again.image[upper].astype(float) - shown.image[upper]).mean() < off


def test_what_stood_on_a_top_leaves_no_mark():
    x, y = (v.ravel() for v in np.meshgrid(np.linspace(0, 1.2, 120), np.linspace(0, 0.7, 70)))
    points = np.column_stack([x, y, np.zeros(len(x))])
    grain = 120 + 40 * np.sin(60 * y)
    colors = np.column_stack([grain, 0.7 * grain, 0.4 * grain])
    hidden = np.hypot(x - 0.6, y - 0.35) < 0.12
    filled = top_colors(points, np.where(hidden[:, None], 255.0, colors), ~hidden)
    assert np.abs(filled[hidden] - colors[hidden]).mean() < 25
    np.testing.assert_array_equal(filled[~hidden], colors[~hidden])


def test_what_lies_on_a_top_unfound_is_no_part_of_it() -> None:
    rng = np.random.default_rng(0)
    board = np.indices((120, 180)).sum(0) // 15 % 2
    known = np.ones(board.shape, bool)
    for top in (
        np.array([200.0, 160, 110]) + rng.normal(0, 9, (*board.shape, 3)),
        np.where(board[..., None] > 0, [230.0, 225, 215], [70.0, 45, 30]),
    ):
        assert not find_strange(top, known).any()
        top[40:48, 60:100] = (90, 40, 150)
        strange = find_strange(top, known)
        assert strange[40:48, 60:100].mean() > 0.9 and strange.mean() < 0.04
