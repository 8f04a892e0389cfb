"""Objects that lie, stand on an edge or are turned over."""

import numpy as np
import pytest

from generator.composition import compose
from generator.geometry import quaternion_matrix
from generator.language.planner import plan_scene
from generator.layout.orientation import pose
from tabletop_objects import build


@pytest.mark.parametrize(
    ("text", "posture"),
    [
        ("an upside-down glass", "upside down"),
        ("a mug turned upside down", "upside down"),
        ("a wine bottle lying on its side next to a vase", "lying"),
        ("a tipped over cup", "lying"),
        ("a cup, knocked over, and a plate", "lying"),
        ("three books standing upright", "upright"),
        ("two mugs that are upside down", "upside down"),
        ("a phone is lying face down", "upside down"),
        ("a wine glass and a plate", None),
    ],
)
def test_reading(text: str, posture: str | None) -> None:
    assert plan_scene(text, 0).objects[0].attributes.get("posture") == posture


@pytest.mark.parametrize(
    ("category", "posture", "axes"),
    [
        ("wine_bottle", "lying", (2, 1, 0)),
        ("picture_frame", "lying", (0, 2, 1)),
        ("picture_frame", "upside down", (0, 2, 1)),
        ("glass", "upside down", (0, 1, 2)),
        ("plate", "lying", (0, 1, 2)),
        ("wine_bottle", "upright", (0, 1, 2)),
        ("wine_bottle", "", (0, 1, 2)),
    ],
)
def test_extents(category: str, posture: str, axes: tuple[int, int, int]) -> None:
    model = build(category, 0)
    np.testing.assert_allclose(pose(model, posture).size, model.size[list(axes)])


def test_a_book_stands_on_an_edge() -> None:
    book = build("book", 0)
    x, _, z = pose(book, "upright").size
    assert x == pytest.approx(book.size[2]) and z == pytest.approx(max(book.size))


def test_a_glass_upside_down_has_its_bottom_on_top() -> None:
    glass = build("glass", 0)
    turned = pose(glass, "upside down")
    np.testing.assert_allclose(turned.mesh.vertices[:, 2], -glass.mesh.vertices[:, 2], atol=1e-6)


@pytest.mark.parametrize(
    ("text", "low"),
    [("a wine bottle lying on its side", True), ("an overturned mug", False)],
)
def test_they_stay_so(text: str, low: bool) -> None:
    scene = compose(text, 0)
    assert scene.report is not None and scene.report.passed
    (thing,) = scene.objects
    assert not any("foot" in warning for warning in scene.provenance.warnings)
    up = quaternion_matrix(thing.pose.quaternion)[2, 2]
    assert up > 0.99  # it rests as the layout has put it
    assert bool(thing.scale[2] < 0.5 * thing.scale[0]) is low
