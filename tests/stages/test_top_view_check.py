"""A top view that moved, dropped or invented things is repaired from the reference picture."""

from __future__ import annotations

import numpy as np
import pytest
from toy import cube_mesh

from generator.geometry import Camera, mask_box, yaw_quaternion
from generator.render.raster import place, render
from generator.scene import TABLE, Instance, Model, Rotation, Stacking, TopView, View
from generator.stages.alignment import check_top_view

SIZE = (640, 480)
VIEW = View(azimuth=0.15, elevation=np.deg2rad(50.0), fov=np.deg2rad(45.0))
TABLE_SIDE, PIXELS = 1.0, 500.0  # metres, and pixels a metre in the top view
PLACES = {
    "a": (-0.3, 0.2, 0.0), "b": (0.25, 0.25, 0.0), "c": (-0.2, -0.25, 0.0), "d": (0.3, -0.1, 0.0),
    "e": (0.0, 0.05, 0.0), "f": (0.0, -0.35, 0.0),
}  # fmt: skip
EXTENT = np.array([0.1, 0.08, 0.06])
MODELS = {name: Model(name, name, cube_mesh(), EXTENT) for name in (*PLACES, "g")}
ROTATIONS = {name: Rotation(name, 0.0, 0.0) for name in MODELS}


def box_of(place: tuple[float, ...]) -> np.ndarray:
    middle = (np.array(place[:2]) * [1, -1] + TABLE_SIDE / 2) * PIXELS
    half = EXTENT[:2] * PIXELS / 2
    return np.concatenate([middle - half, middle + half])


def seen(places: dict[str, tuple[float, float, float]]) -> tuple[Instance, ...]:
    """Draw each thing alone and cut it out."""
    camera = Camera.looking_at(np.zeros(3), VIEW, 1.6, *SIZE)
    instances = [_instance(TABLE, np.ones(SIZE[::-1], bool))]
    for name, (x, y, z) in places.items():
        position = np.array([x, y, z + EXTENT[2] / 2])
        item = place(cube_mesh(), EXTENT, position, yaw_quaternion(0.0))
        instances.append(_instance(name, render([item], camera).ids >= 0))
    return tuple(instances)


def _instance(name: str, mask: np.ndarray) -> Instance:
    box = mask_box(mask)
    x0, y0, x1, y1 = box.astype(int)
    crop = np.repeat((mask * np.uint8(255))[y0:y1, x0:x1, None], 4, axis=2)
    return Instance(name, name, box, mask, crop, box)


def checked(boxes: dict[str, np.ndarray], instances=None, stacking=None):
    side = TABLE_SIDE * PIXELS
    top = TopView(np.zeros((500, 500, 3), np.uint8), np.array([0, 0, side, side]), boxes)
    return check_top_view(
        top, instances or seen(PLACES), MODELS, ROTATIONS, stacking or {}, VIEW, SIZE
    )


def true_boxes() -> dict[str, np.ndarray]:
    return {name: box_of(place) for name, place in PLACES.items()}


def off(found: np.ndarray, name: str) -> float:
    """Return how far a box's middle is from its true one, in table widths."""
    apart = (found - box_of(PLACES[name])).reshape(2, 2).mean(0)
    return float(np.linalg.norm(apart)) / (TABLE_SIDE * PIXELS)


def test_a_true_top_view_stays_as_it_is():
    top, warnings = checked(true_boxes())
    assert top.repaired == () and warnings == ()


@pytest.mark.parametrize("move", [(120.0, 0.0), (0.0, 110.0), (-90.0, 90.0)])
def test_what_was_moved_is_put_back(move):
    boxes = true_boxes()
    boxes["d"] = boxes["d"] + np.tile(move, 2)
    top, warnings = checked(boxes)
    assert top.repaired == ("d",) and "elsewhere" in warnings[0]
    assert off(np.asarray(top.boxes["d"]), "d") < 0.03
    np.testing.assert_allclose(top.boxes["a"], boxes["a"])


def test_what_was_dropped_is_put_in_with_its_size():
    boxes = true_boxes()
    del boxes["c"]
    top, warnings = checked(boxes)
    assert top.repaired == ("c",) and "lacks" in warnings[0]
    found = np.asarray(top.boxes["c"])
    assert off(found, "c") < 0.03
    np.testing.assert_allclose(found[2:] - found[:2], EXTENT[:2] * PIXELS, rtol=0.02)


def test_a_whole_picture_scaled_and_shifted_is_still_true():
    boxes = {name: 0.8 * box + 30.0 for name, box in true_boxes().items()}
    assert checked(boxes)[0].repaired == ()


def test_where_most_disagree_nothing_is_touched():
    rng = np.random.default_rng(0)
    boxes = {n: b + np.tile(rng.uniform(-200, 200, 2), 2) for n, b in true_boxes().items()}
    top, warnings = checked(boxes)
    assert top.repaired == () and warnings == ()


def test_what_stands_on_something_is_put_over_it():
    places = {**PLACES, "g": (*PLACES["a"][:2], EXTENT[2])}
    stacking = {"g": Stacking(3, "a")}
    boxes = {**true_boxes(), "g": box_of(PLACES["b"])}
    top, warnings = checked(boxes, seen(places), stacking)
    assert top.repaired == ("g",) and "on a" in warnings[0]
    assert off(np.asarray(top.boxes["g"]), "a") < 0.02
    boxes["g"] = box_of(PLACES["a"])
    assert checked(boxes, seen(places), stacking)[0].repaired == ()
