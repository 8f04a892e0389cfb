"""Repair of top views with moved, missing or wrongly sized objects, from the reference picture."""

from dataclasses import replace

import numpy as np
import pytest
from toy import cube_mesh

from generator.geometry import Camera, mask_box, yaw_quaternion
from generator.method.alignment import check_top_view
from generator.render.raster import place, render
from generator.scene import TABLE, Instance, Model, Rotation, Stacking, TopView, View

SIZE = (640, 480)
VIEW = View(azimuth=0.15, elevation=np.deg2rad(50.0), fov=np.deg2rad(45.0))
TABLE_SIDE, PIXELS = 1.0, 500.0  # metres, and pixels a metre in the top view
PLACES = {
    "a": (-0.3, 0.2, 0.0), "b": (0.25, 0.25, 0.0), "c": (-0.2, -0.25, 0.0), "d": (0.3, -0.1, 0.0),
    "e": (0.0, 0.05, 0.0), "f": (0.0, -0.35, 0.0),
}  # fmt: skip
EXTENT = np.array([0.1, 0.08, 0.06])
MODELS = {name: Model(name, name, cube_mesh(), EXTENT) for name in (*PLACES, "g")}
MODELS[TABLE] = Model(TABLE, TABLE, cube_mesh(), np.array([TABLE_SIDE, TABLE_SIDE, 0.74]))
ROTATIONS = {name: Rotation(name, 0.0, 0.0) for name in MODELS}


def box_of(place: tuple[float, ...]) -> np.ndarray:
    middle = (np.array(place[:2]) * [1, -1] + TABLE_SIDE / 2) * PIXELS
    half = EXTENT[:2] * PIXELS / 2
    return np.concatenate([middle - half, middle + half])


def seen(places: dict[str, tuple[float, float, float]]) -> tuple[Instance, ...]:
    """Draw each object alone and cut it out."""
    camera = Camera.looking_at(np.zeros(3), VIEW, 1.6, *SIZE)
    heights = {TABLE: -0.37, **{name: z + EXTENT[2] / 2 for name, (_, _, z) in places.items()}}
    instances = []
    for name, z in heights.items():
        x, y, _ = places.get(name, (0.0, 0.0, 0.0))
        extent = np.asarray(MODELS[name].size)
        item = place(cube_mesh(), extent, np.array([x, y, z]), yaw_quaternion(0.0))
        drawn = render([item], camera, supersample=1, shadows=False)
        instances.append(_instance(name, drawn.ids >= 0))
    return tuple(instances)


def _instance(name: str, mask: np.ndarray) -> Instance:
    box = mask_box(mask)
    x0, y0, x1, y1 = box.astype(int)
    crop = np.repeat((mask * np.uint8(255))[y0:y1, x0:x1, None], 4, axis=2)
    return Instance(name, name, box, mask, crop, box)


@pytest.fixture(scope="module")
def pictured() -> tuple[Instance, ...]:
    return seen(PLACES)


def cut_by_the_frame(instances: tuple[Instance, ...]) -> tuple[Instance, ...]:
    return (_instance(TABLE, np.ones(SIZE[::-1], bool)), *instances[1:])


def few(instances: tuple[Instance, ...], names: str) -> tuple[Instance, ...]:
    return tuple(i for i in instances if i.name in (TABLE, *names))


def checked(boxes: dict[str, np.ndarray], instances, stacking=None, **flags):
    side = TABLE_SIDE * PIXELS
    top = TopView(np.zeros((500, 500, 3), np.uint8), np.array([0, 0, side, side]), boxes)
    return check_top_view(top, instances, MODELS, ROTATIONS, stacking or {}, VIEW, SIZE, **flags)


def true_boxes() -> dict[str, np.ndarray]:
    return {name: box_of(place) for name, place in PLACES.items()}


def off(found: np.ndarray, name: str) -> float:
    """Return the distance of a box's centre from its true one, in table widths."""
    apart = (found - box_of(PLACES[name])).reshape(2, 2).mean(0)
    return float(np.linalg.norm(apart)) / (TABLE_SIDE * PIXELS)


def half_turned(boxes: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    return {name: TABLE_SIDE * PIXELS - box[[2, 3, 0, 1]] for name, box in boxes.items()}


def test_a_true_top_view_stays_as_it_is(pictured):
    for instances in (pictured, few(pictured, "abc"), cut_by_the_frame(pictured)):
        boxes = {i.name: box_of(PLACES[i.name]) for i in instances[1:]}
        top, warnings = checked(boxes, instances)
        assert top.repaired == () and warnings == ()


@pytest.mark.parametrize("names", ["abcdef", "abd"])
@pytest.mark.parametrize("move", [(50.0, 0.0), (0.0, 45.0), (-120.0, 90.0)])
def test_what_was_moved_is_put_back(pictured, move, names):
    boxes = {name: box_of(PLACES[name]) for name in names}
    boxes["d"] = boxes["d"] + np.tile(move, 2)
    top, warnings = checked(boxes, few(pictured, names))
    assert top.repaired == ("d",) and "different position" in warnings[0]
    assert off(np.asarray(top.boxes["d"]), "d") < 0.03
    np.testing.assert_allclose(top.boxes["a"], boxes["a"])


@pytest.mark.parametrize("factor", [0.5, 2.0])
def test_what_was_drawn_far_too_large_or_small_is_resized(pictured, factor):
    boxes = true_boxes()
    middle, half = boxes["d"].reshape(2, 2).mean(0), EXTENT[:2] * PIXELS / 2
    boxes["d"] = np.concatenate([middle - factor * half, middle + factor * half])
    top, (warning,) = checked(boxes, pictured)
    assert top.repaired == ("d",) and warning.startswith("d: ") and f"{factor:.1g}" in warning
    found = np.asarray(top.boxes["d"])
    np.testing.assert_allclose(found[2:] - found[:2], 2 * half, rtol=0.06)


@pytest.mark.parametrize("names", ["abcdef", "abc", "c"])
def test_what_was_dropped_is_put_in_with_its_size(pictured, names):
    boxes = {name: box_of(PLACES[name]) for name in names if name != "c"}
    for only_missing in (False, True):
        top, warnings = checked(boxes, few(pictured, names), only_missing=only_missing)
        assert top.repaired == ("c",) and "missing" in warnings[0]
        found = np.asarray(top.boxes["c"])
        assert off(found, "c") < 0.03
        np.testing.assert_allclose(found[2:] - found[:2], EXTENT[:2] * PIXELS, rtol=0.06)


def test_what_the_picture_cannot_place_is_guessed_rather_than_lost(pictured):
    hollow = [replace(i, crop=0 * i.crop) if i.name == "c" else i for i in pictured]
    boxes = {name: box for name, box in true_boxes().items() if name != "c"}
    top, (warning,) = checked(boxes, tuple(hollow))
    assert top.repaired == ("c",) and "missing" in warning
    assert off(np.asarray(top.boxes["c"]), "c") < 0.3


def test_a_whole_picture_scaled_and_shifted_is_still_true(pictured):
    boxes = {name: 0.8 * box + 30.0 for name, box in true_boxes().items()}
    assert checked(boxes, pictured)[0].repaired == ()


def scattered(boxes: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    rng = np.random.default_rng(0)
    return {name: box + np.tile(rng.uniform(-200, 200, 2), 2) for name, box in boxes.items()}


def mirrored(boxes: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    side = TABLE_SIDE * PIXELS
    return {
        name: np.array([side - x1, y0, side - x0, y1]) for name, (x0, y0, x1, y1) in boxes.items()
    }


@pytest.mark.parametrize("wrong", [half_turned, mirrored, scattered])
@pytest.mark.parametrize("cut", [False, True])
def test_where_most_disagree_geometry_places_all(pictured, wrong, cut):
    instances = cut_by_the_frame(pictured) if cut else pictured
    top, warnings = checked(wrong(true_boxes()), instances)
    assert set(top.repaired) == set(PLACES)
    assert len(warnings) == 1 and "geometry placed all" in warnings[0]
    boxes = {name: np.asarray(top.boxes[name]) for name in PLACES}
    if cut:  # the table's place is then a guess; things' places against one another are not
        apart = np.mean([boxes[n] - box_of(PLACES[n]) for n in PLACES], axis=0)
        boxes = {name: box - apart for name, box in boxes.items()}
    assert max(off(boxes[name], name) for name in PLACES) < 0.05


def test_taken_as_it_comes_a_wrong_top_view_stays(pictured):
    boxes = half_turned(true_boxes())
    top, warnings = checked(boxes, pictured, only_missing=True)
    assert top.repaired == () and warnings == ()
    np.testing.assert_allclose(top.boxes["a"], boxes["a"])


def test_what_stands_on_something_is_put_over_it():
    places = {**PLACES, "g": (*PLACES["a"][:2], EXTENT[2])}
    stacking = {"g": Stacking(3, "a")}
    instances = seen(places)
    boxes = {**true_boxes(), "g": box_of(PLACES["b"])}
    top, warnings = checked(boxes, instances, stacking)
    assert top.repaired == ("g",) and "on a" in warnings[0]
    assert off(np.asarray(top.boxes["g"]), "a") < 0.02
    boxes["g"] = box_of(PLACES["a"])
    assert checked(boxes, instances, stacking)[0].repaired == ()
    del boxes["g"]
    top, warnings = checked(boxes, instances, stacking)
    assert top.repaired == ("g",) and "does not show the object" in warnings[0]
    assert off(np.asarray(top.boxes["g"]), "a") < 0.02
