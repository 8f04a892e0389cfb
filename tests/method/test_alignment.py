"""TSA: Eqs. 5 and 6 on hand-computed numbers, scales, and contact of real meshes."""

from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from shapes import sphere_mesh
from toy import cube_mesh

from generator.errors import InputError
from generator.geometry import rotated_extent
from generator.language.planner import plan_scene
from generator.method.alignment import (
    AlignmentConfig,
    align,
    metres_per_pixel,
    own_extent,
    pixel_area_and_ratio_error,
    rectangle_box,
    rma_score,
    select_anchor,
)
from generator.render.contact import Body, resting_height
from generator.scene import (
    Detection,
    Instance,
    Mesh,
    Model,
    Reference,
    Rotation,
    ScenePlan,
    SizePrior,
    Stacking,
    TopView,
    View,
)


def test_equation_5_by_hand():
    # 100 x 50 px against 20 x 20 cm: A = 5000, |log 1 - log 2| = log 2.
    area, error = pixel_area_and_ratio_error(
        np.array([10, 20, 110, 70.0]), np.array([0.2, 0.2, 0.1]), 0
    )
    assert area == 5000
    assert error == pytest.approx(np.log(2))
    # A quarter turn swaps length and width: 0.2 x 0.1 becomes 0.1 x 0.2.
    _, turned = pixel_area_and_ratio_error(
        np.array([0, 0, 50, 100.0]), np.array([0.2, 0.1, 0.1]), np.pi / 2
    )
    assert turned == pytest.approx(0)


def test_equation_6_by_hand():
    assert rma_score(5000, 0.0) == 5000
    assert rma_score(5000, 0.25) == 2500  # error = tau halves the score
    assert rma_score(5000, 0.5, tau=0.25) == 1000
    assert select_anchor({"a": 10.0, "b": 30.0, "c": 30.0}) == "b"


def test_metres_per_pixel_from_the_anchor():
    alpha = metres_per_pixel(np.array([0, 0, 100, 50.0]), np.array([0.2, 0.1, 0.3]), 0.0)
    assert alpha == pytest.approx(0.002)


@pytest.mark.parametrize("degrees", [0, 10, 25, 65, 90, 170, 200])
def test_own_extent_undoes_the_rotation(degrees):
    size, yaw = np.array([0.2, 0.12, 0.05]), np.deg2rad(degrees)
    truth = np.array([0.22, 0.12, 0.05])
    found = own_extent(rotated_extent(truth, yaw), yaw, size)
    np.testing.assert_allclose(found[:2], truth[:2], rtol=0.06)


def test_near_45_degrees_the_proportions_are_kept():
    size = np.array([0.2, 0.1, 0.05])
    found = own_extent(np.array([0.3, 0.28]), np.pi / 4, size)
    assert found[0] / found[1] == pytest.approx(2.0)
    assert found[2] / size[2] == pytest.approx(found[0] / size[0])


def test_a_turned_disc_keeps_its_size():
    """The outline of a disc does not grow at 45 degrees, unlike its bounding square."""
    mesh, size = sphere_mesh(), np.array([0.1, 0.1, 0.1])
    box = np.array([100, 200, 150, 250.0])
    for yaw in (0.0, np.pi / 5, np.pi / 4):
        own = rectangle_box(box, mesh, size, yaw)
        np.testing.assert_allclose((own[:2] + own[2:]) / 2, [125, 225], atol=0.5)
        np.testing.assert_allclose(
            own_extent(own[2:] - own[:2], yaw, size)[:2], [50, 50], rtol=0.03
        )


def test_an_outline_off_its_rectangles_centre_is_put_back():
    """A triangle fills its box at yaw 0, and is off its centre at yaw 45 degrees."""
    corners = np.array([[-0.5, -0.5], [0.5, -0.5], [-0.5, 0.5]])
    vertices = np.array([[x, y, z] for x, y in corners for z in (-0.5, 0.5)])
    mesh = Mesh(vertices, np.array([[0, 2, 4], [1, 3, 5]]), np.zeros((6, 2)),
                np.zeros((1, 1, 3), np.uint8))  # fmt: skip
    size, yaw, scale = np.array([0.2, 0.2, 0.1]), np.pi / 4, 500.0
    turned = (
        vertices[:, :2] * 0.2 @ np.array([[np.cos(yaw), np.sin(yaw)], [-np.sin(yaw), np.cos(yaw)]])
    )
    low, high = turned.min(0), turned.max(0)
    box = np.array([low[0], -high[1], high[0], -low[1]]) * scale
    own = rectangle_box(box, mesh, size, yaw)
    np.testing.assert_allclose((own[:2] + own[2:]) / 2, 0, atol=1e-3)
    np.testing.assert_allclose(own[2:] - own[:2], 0.2 * np.sqrt(2) * scale, rtol=1e-4)


# ---------------------------------------------------------------------------------------- contact
def bowl_mesh(segments: int = 48) -> Mesh:
    """A hemispherical shell, open at the top, of inner radius 0.45 (unit box, flat rim)."""
    profile = [(0.5 * np.cos(t), 0.5 - 1.0 * np.sin(t)) for t in np.linspace(0, np.pi / 2, 16)]
    profile += [(0.45 * np.cos(t), 0.5 - 0.9 * np.sin(t)) for t in np.linspace(np.pi / 2, 0, 16)]
    turns = np.linspace(0, 2 * np.pi, segments, endpoint=False)
    points = np.array([[r * np.cos(a), r * np.sin(a), z] for r, z in profile for a in turns])
    faces = []
    for i in range(len(profile)):
        for j in range(segments):
            a, b = i * segments + j, i * segments + (j + 1) % segments
            c = (i + 1) % len(profile) * segments + j
            d = (i + 1) % len(profile) * segments + (j + 1) % segments
            faces += [[a, b, d], [a, d, c]]
    return Mesh(points, faces, np.zeros((len(points), 2)), np.full((2, 2, 3), 200, np.uint8))


def test_a_ball_rests_on_the_inner_wall_of_a_bowl():
    # Inner wall: a half sphere of radius 0.09 about (0, 0, rim); a ball of radius 0.03 in its
    # middle rests with its centre 0.06 below the rim, i.e. 0.04 above the foot of the bowl.
    bowl = Body(bowl_mesh(), np.array([0.2, 0.2, 0.1]), 0.0, np.array([0.3, 0.1, 0.79]))
    ball = Body(sphere_mesh(), np.full(3, 0.06), 0.0, np.array([0.3, 0.1, 0.0]))
    assert resting_height(ball, bowl, 0.74) == pytest.approx(0.74 + 0.04, abs=0.002)
    # Off the middle the wall rises: 0.03 aside, the centre is at sqrt(0.06^2 - 0.03^2) below.
    aside = Body(sphere_mesh(), np.full(3, 0.06), 0.0, np.array([0.33, 0.1, 0.0]))
    expected = 0.84 - np.sqrt(0.06**2 - 0.03**2)
    assert resting_height(aside, bowl, 0.74) == pytest.approx(expected, abs=0.002)


def test_a_cup_stands_on_a_book_and_things_never_sink_into_the_table():
    book = Body(cube_mesh(), np.array([0.2, 0.15, 0.03]), 0.5, np.array([0.0, 0.0, 0.755]))
    cup = Body(cube_mesh(), np.array([0.08, 0.08, 0.1]), 0.0, np.array([0.03, 0.0, 9.0]))
    assert resting_height(cup, book, 0.74) == pytest.approx(0.74 + 0.03 + 0.05, abs=1e-6)
    beside = Body(cube_mesh(), np.array([0.08, 0.08, 0.1]), 0.0, np.array([0.5, 0.0, 0.0]))
    assert resting_height(beside, book, 0.74) == pytest.approx(0.79)
    assert resting_height(cup, None, 0.74) == pytest.approx(0.79)


# ------------------------------------------------------------------------------------------ stage
class Answers:
    """An imager with a given top view, a reasoner with a given stacking, a segmenter."""

    def __init__(self, top: TopView, on: dict[str, Stacking], found: tuple[Detection, ...] = ()):
        self.top, self.on, self.found = top, on, found

    def top_view(self, *_: Any) -> TopView:
        return self.top

    def stacking_order(self, *_: Any) -> dict[str, Stacking]:
        return self.on

    def segment(self, image: np.ndarray, labels: tuple[str, ...]) -> tuple[Detection, ...]:
        return self.found


IMAGE = np.zeros((400, 700, 3), np.uint8)
VIEW = View(0.0, np.deg2rad(55), 0.6)


def instance(name: str, x0: float = 0, y0: float = 0, x1: float = 10, y1: float = 10) -> Instance:
    mask = np.zeros(IMAGE.shape[:2], bool)
    mask[int(y0) : int(y1), int(x0) : int(x1)] = True
    crop = np.zeros((4, 4, 4), np.uint8)
    box = np.array([x0, y0, x1, y1], float)
    return Instance(name, name.rsplit("_", 1)[0], box, mask, crop, box)


def run(
    answers: Answers,
    sizes: dict[str, tuple[float, float, float]],
    plan: ScenePlan | None = None,
    usual: dict[str, tuple[float, float, float]] | None = None,
    config: AlignmentConfig | None = None,
):
    backend: Any = answers
    instances = tuple(instance(n) for n in sizes)
    models = {n: Model(n, n, cube_mesh(), np.array(s)) for n, s in sizes.items()}
    priors = {n: SizePrior(n, np.array(s)) for n, s in (usual or sizes).items()}
    rotations = {n: Rotation(n, 0.0, 0.0) for n in sizes}
    return align(Reference(IMAGE, plan=plan), instances, models, priors, rotations, VIEW,
                 backend, backend, backend, config)  # fmt: skip


SIZES = {"table": (1.5, 0.7, 0.74), "box_1": (0.25, 0.2, 0.2), "pen_1": (0.14, 0.01, 0.01),
         "cup_1": (0.08, 0.08, 0.1)}  # fmt: skip
# The box is 125 x 100 px for 25 x 20 cm: 2 mm per pixel, so the table is 1.2 x 0.7 m.
TOP = TopView(IMAGE, np.array([50, 25, 650, 375.0]), {
    "box_1": np.array([400, 100, 525, 200.0]),
    "pen_1": np.array([100, 300, 170, 305.0]),
    "cup_1": np.array([440, 130, 480, 170.0]),
})  # fmt: skip
ON = {
    "table": Stacking(1),
    "box_1": Stacking(2),
    "pen_1": Stacking(2),
    "cup_1": Stacking(3, "box_1"),
}


def test_the_anchor_gives_scale_table_and_places():
    result = run(Answers(TOP, ON), SIZES)
    assert result.anchor == "box_1"
    assert result.metres_per_pixel == pytest.approx(0.002)
    # Modelled from the picture at 1.5 m, the table keeps its proportions.
    np.testing.assert_allclose(result.table_scale, [1.2, 0.7, 0.74 * np.sqrt(0.8)])
    box, pen, cup = result.placements
    np.testing.assert_allclose(box.translation[:2], [0.225, 0.1])
    np.testing.assert_allclose(pen.translation[:2], [-0.43, -0.205])
    assert cup.on == "box_1"
    height = result.table_scale[2]
    assert box.translation[2] == pytest.approx(height + 0.1, abs=1e-3)
    assert cup.translation[2] == pytest.approx(height + 0.2 + 0.05, abs=1e-3)


@pytest.mark.parametrize(
    ("text", "limit"), [("a desk with a box, a pen and a cup", 1.6), (None, 4)]
)
def test_a_size_far_from_the_usual_is_limited_and_told(text, limit):
    boxes = {**TOP.boxes, "cup_1": np.array([400, 100, 620, 320.0])}
    plan = None if text is None else plan_scene(text, 0)
    result = run(Answers(TopView(IMAGE, TOP.table_box, boxes), ON), SIZES, plan)
    cup = result.placements[2]
    assert np.cbrt(np.prod(cup.scale) / np.prod(SIZES["cup_1"])) == pytest.approx(limit)
    assert any("cup_1" in w for w in result.warnings)


def test_a_thing_as_thin_as_a_picture_shows_it_is_not_blown_up():
    # The pen's model is 14 cm long and a hundredth of its usual height.
    models = {**SIZES, "pen_1": (0.14, 0.01, 0.0001)}
    result = run(Answers(TOP, ON), models, plan_scene("a desk with a pen", 0), usual=SIZES)
    np.testing.assert_allclose(result.placements[1].scale[0], 0.14, rtol=1e-3)
    assert not result.warnings


def test_an_anchor_that_makes_the_table_absurd_is_passed_over():
    sizes = {**SIZES, "box_1": (2.5, 2.0, 2.0)}
    result = run(Answers(TOP, ON), sizes)
    assert result.anchor != "box_1"
    assert result.table_scale[0] < 3.0
    assert any("box_1" in w and "table" in w for w in result.warnings)


@pytest.mark.parametrize("check", [True, False])
def test_what_a_top_view_drops_is_placed_and_told(check):
    boxes = {name: box for name, box in TOP.boxes.items() if name != "pen_1"}
    dropped = Answers(TopView(IMAGE, TOP.table_box, boxes), ON)
    result = run(dropped, SIZES, config=AlignmentConfig(check=check))
    assert {p.name for p in result.placements} == {"box_1", "pen_1", "cup_1"}
    assert result.top_view is not None and result.top_view.repaired == ("pen_1",)
    assert any("pen_1" in w and "missing" in w for w in result.warnings)


@pytest.mark.parametrize(
    "wrong",
    [{"tau": 0.0}, {"tau": float("nan")}, {"size_limit": 0.5}, {"guess_limit": 0.9},
     {"table_limit": float("nan")}],
)  # fmt: skip
def test_settings_out_of_range_are_refused(wrong):
    with pytest.raises(InputError, match=r"^AlignmentConfig\.\w+ must be"):
        AlignmentConfig(**wrong)


def test_what_a_top_view_warns_of_is_told():
    top = replace(TOP, warnings=("it was drawn badly",))
    told = run(Answers(top, ON), SIZES).warnings
    assert "it was drawn badly" in told


def test_a_top_view_without_boxes_is_searched():
    found = tuple(
        Detection(n, np.asarray(b), instance(n, *b).mask)
        for n, b in [("table", TOP.table_box), ("box", TOP.boxes["box_1"]),
                     ("pen", TOP.boxes["pen_1"]), ("cup", TOP.boxes["cup_1"])]
    )  # fmt: skip
    drawn = TopView(IMAGE, np.array([0, 0, 700, 400.0]), {})
    result = run(Answers(drawn, ON, found), SIZES)
    np.testing.assert_array_equal(result.top_view.table_box, TOP.table_box)
    np.testing.assert_array_equal(result.top_view.boxes["pen_1"], TOP.boxes["pen_1"])
