"""The paper's printed JSON (Figs. 12 and 14) through the frame conversion and back."""

import numpy as np
import pytest

from generator.errors import InputError
from generator.scene.paper_json import from_paper, to_paper

FIG_12 = {
    "table_0": 0.00, "toy car_1": 29.72, "bottle_2": 295.00, "magnifying glass_3": 145.00,
    "bottle_4": 0.00, "toy car_5": 159.99, "bottle_6": 180.00, "toy car_7": 155.00,
    "screwdriver_8": 35.04, "box_9": 85.08,
}  # fmt: skip
FIG_14 = {
    "anchor_object": "box_9",
    "objects": {
        "table_0": {"scale": [104.55, 58.44, 64], "translation": [0.0, 0.0, 32.0]},
        "toy_car_1": {"scale": [18.00, 8.00, 6.00], "translation": [13.23, 14.45, 67.00]},
        "box_9": {"scale": [25.00, 20.00, 20.00], "translation": [39.94, -9.58, 74.0]},
    },
}


def test_printed_numbers_become_metres_in_our_frame() -> None:
    placements, anchor = from_paper(FIG_12, FIG_14)
    assert anchor == "box_9"
    table, car, box = placements
    assert np.allclose(table.scale, [1.0455, 0.5844, 0.64])
    assert np.allclose(car.translation, [-0.1323, -0.1445, 0.67])  # +x left becomes -x
    assert np.allclose(box.translation, [-0.3994, 0.0958, 0.74])
    assert np.rad2deg(car.yaw) == pytest.approx(29.72)


def test_round_trip_reproduces_the_printed_json() -> None:
    placements, anchor = from_paper(FIG_12, FIG_14)
    rotations, alignment = to_paper(placements, anchor)
    assert alignment == FIG_14
    assert rotations == {"table_0": 0.0, "toy_car_1": 29.72, "box_9": 85.08}
    again, _ = from_paper(rotations, alignment)
    for before, after in zip(placements, again, strict=True):
        assert np.allclose(before.translation, after.translation)
        assert before.yaw == pytest.approx(after.yaw)


def test_the_box_stands_left_and_behind_in_the_picture() -> None:
    """Fig. 14's box_9 is the tool case at the far left of the worked example."""
    placements, _ = from_paper(FIG_12, FIG_14)
    box = placements[2]
    assert box.translation[0] < 0 < box.translation[1]


@pytest.mark.parametrize(
    "broken",
    [
        {"objects": {"mug_1": {"scale": [1, 1, 1], "translation": [0, 0, 0]}}},
        {"objects": {"box_9": {"scale": [1, 1, 1]}}},
        {"objects": {"box_9": {"scale": [1, "x", 1], "translation": [0, 0, 0]}}},
        {"objects": {"box_9": {"scale": [1, 1, np.nan], "translation": [0, 0, 0]}}},
        {"objects": {"box_9": {"scale": [1, 1, 10**400], "translation": [0, 0, 0]}}},
        {"objects": {"box_9": 5}},
        {"objects": [1]},
        [1],
    ],
)
def test_malformed_json_is_refused(broken: dict) -> None:
    with pytest.raises(InputError):
        from_paper(FIG_12, broken)


@pytest.mark.parametrize("degrees", ["x", None, True, float("nan"), 10**400, [1]])
def test_rotations_are_numbers(degrees: object) -> None:
    with pytest.raises(InputError, match="The rotation of"):
        from_paper({**FIG_12, "box_9": degrees}, FIG_14)  # type: ignore[dict-item]
    with pytest.raises(InputError, match="Rotations must be"):
        from_paper([degrees], FIG_14)  # type: ignore[arg-type]
