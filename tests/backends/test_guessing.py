"""Naive poses from masks and boxes: the replacement of DRO and TSA in ablations."""

import cv2
import numpy as np
import pytest

from generator.backends.embedded.poses import guess_layout, guess_rotations
from generator.backends.embedded.reasoner import EmbeddedReasoner
from generator.backends.protocols import PoseGuesser
from generator.errors import InputError
from generator.geometry import mask_box
from generator.scene import Instance, SizePrior, View

FRONT = View(0.0, np.deg2rad(90.0), 0.6)
SHAPE = (400, 600)
TABLE = (1.2, 0.8, 0.74)  # 500 pixels per metre in the picture below


def thing(name: str, mask: np.ndarray) -> Instance:
    return Instance(name, name, mask_box(mask), mask, np.zeros((4, 4, 4), np.uint8), mask_box(mask))


def bar(degrees: float, center: tuple[int, int] = (300, 200)) -> Instance:
    """Return a long thin object, rotated counter-clockwise in the picture."""
    along = 60 * np.array([np.cos(np.deg2rad(degrees)), -np.sin(np.deg2rad(degrees))])
    ends = [tuple(int(v) for v in np.round(np.array(center) + s * along)) for s in (-1, 1)]
    mask = np.zeros(SHAPE, np.uint8)
    cv2.line(mask, ends[0], ends[1], 1, 9)
    return thing("bar_1", mask > 0)


def table() -> Instance:
    return thing("table", np.ones(SHAPE, bool))


def yaw_of(instance: Instance, size: tuple[float, float, float], view: View = FRONT) -> float:
    sizes = {instance.name: SizePrior(instance.name, np.array(size)), "table": table_size()}
    told = guess_rotations((table(), instance), sizes, view)
    assert set(told) == {instance.name}
    return float(np.rad2deg(told[instance.name]))


def table_size() -> SizePrior:
    return SizePrior("table", np.array(TABLE))


@pytest.mark.parametrize(("degrees", "told"), [(0, 0), (31, 30), (50, 45), (88, 90), (-40, -45)])
def test_a_lying_things_yaw_is_its_masks_axis_in_steps(degrees: float, told: float) -> None:
    assert yaw_of(bar(degrees), (0.2, 0.02, 0.02)) == pytest.approx(told)


def test_the_long_side_is_along_the_axis_whichever_it_is() -> None:
    assert yaw_of(bar(30), (0.02, 0.2, 0.02)) == pytest.approx(-60)


def test_what_stands_or_shows_no_direction_faces_the_camera() -> None:
    turned = View(np.deg2rad(20.0), np.deg2rad(50.0), 0.6)
    assert yaw_of(bar(90), (0.06, 0.06, 0.2), turned) == pytest.approx(20)
    disc = np.zeros(SHAPE, np.uint8)
    cv2.circle(disc, (300, 200), 40, 1, -1)
    assert yaw_of(thing("disc_1", disc > 0), (0.2, 0.2, 0.02), turned) == pytest.approx(20)


def test_places_are_linear_in_the_tables_box() -> None:
    mask = np.zeros(SHAPE, bool)
    mask[250:300, 400:450] = True  # 0.1 m wide and deep, its near edge 0.2 m before the middle
    sizes = {"box_1": SizePrior("box_1", np.array([0.1, 0.1, 0.05])), "table": table_size()}
    told = guess_layout((table(), thing("box_1", mask)), sizes, FRONT)["box_1"]
    np.testing.assert_allclose(told.center, [0.25, -0.15], atol=1e-9)
    np.testing.assert_allclose(told.size, [0.1, 0.1, 0.05])


def test_nothing_is_put_beyond_the_tabletop() -> None:
    mask = np.zeros(SHAPE, bool)
    mask[0:3, 595:600] = True
    sizes = {"box_1": SizePrior("box_1", np.array([0.3, 0.3, 0.05])), "table": table_size()}
    told = guess_layout((table(), thing("box_1", mask)), sizes, FRONT)["box_1"]
    assert told.center[1] == pytest.approx(0.4)
    assert told.center[0] <= 0.6


def test_a_layout_needs_a_table() -> None:
    with pytest.raises(InputError, match="table"):
        guess_layout((bar(0),), {"bar_1": SizePrior("bar_1", np.ones(3))}, FRONT)


def test_the_embedded_reasoner_can_be_asked_for_poses() -> None:
    assert isinstance(EmbeddedReasoner(), PoseGuesser)


def test_a_turned_tables_edge_is_kept_too() -> None:
    mask = np.zeros(SHAPE, bool)
    mask[2:12, 2:12] = True
    turned = View(np.deg2rad(30.0), np.deg2rad(60.0), 0.6)
    sizes = {"cup_1": SizePrior("cup_1", np.full(3, 0.1)), "table": table_size()}
    center = guess_layout((table(), thing("cup_1", mask)), sizes, turned)["cup_1"].center
    assert (np.abs(center) <= np.array(TABLE[:2]) / 2 + 1e-9).all()
