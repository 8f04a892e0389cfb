"""Completion of one object: clean outline, redrawn hidden parts."""

import cv2
import numpy as np
import pytest

from generator.backends.embedded.completion import complete
from generator.errors import InputError
from generator.geometry import mask_box
from generator.meshes.pixels import mask_iou
from generator.scene import Detection, Reference

H, W = 200, 240
RED, GREEN, BLUE, GROUND = (200, 40, 40), (30, 160, 60), (30, 60, 190), (240, 240, 240)


def disc(x: float, y: float, r: float) -> np.ndarray:
    rows, columns = np.mgrid[:H, :W]
    return (columns + 0.5 - x) ** 2 + (rows + 0.5 - y) ** 2 <= r * r


def detect(mask: np.ndarray, label: str = "thing") -> Detection:
    return Detection(label, mask_box(mask), mask)


def picture(*layers: tuple[np.ndarray, tuple[int, int, int]]) -> Reference:
    image = np.full((H, W, 3), GROUND, np.uint8)
    for mask, color in layers:
        image[mask] = color
    return Reference(image)


def alpha_in_picture(instance) -> np.ndarray:
    """Return the crop's opaque pixels laid back over the reference picture."""
    x0, y0, x1, y1 = instance.crop_box
    ch, cw = instance.crop.shape[:2]
    rows, columns = np.mgrid[:H, :W] + 0.5
    i = np.floor((rows - y0) / (y1 - y0) * ch).astype(int)
    j = np.floor((columns - x0) / (x1 - x0) * cw).astype(int)
    on = (i >= 0) & (j >= 0) & (i < ch) & (j < cw)
    out = np.zeros((H, W), bool)
    out[on] = instance.crop[i[on], j[on], 3] > 127
    return out


def test_a_visible_object_is_cut_out_clean():
    mask = disc(100, 90, 40)
    found = complete(picture((mask, RED)), detect(mask), ())
    assert not found.occluded
    assert max(found.crop.shape[:2]) >= 256
    np.testing.assert_array_equal(found.mask, mask)
    np.testing.assert_array_equal(found.box, mask_box(mask))
    assert mask_iou(alpha_in_picture(found), mask) > 0.97
    alpha = found.crop[..., 3]
    assert alpha[0].max() == 0 and alpha[:, 0].max() == 0, "the margin is clear"
    assert ((alpha > 0) & (alpha < 255)).any(), "the edge is soft"
    # No ground colour bleeds through the soft edge.
    assert np.abs(found.crop[alpha > 0][:, :3].astype(int) - RED).max() < 25


@pytest.mark.parametrize("side", [-1, 1])
def test_the_hidden_half_of_a_round_object_comes_back(side):
    whole = disc(120, 100, 45)
    hider = np.zeros((H, W), bool)
    hider[60:150, slice(130, 200) if side > 0 else slice(40, 110)] = True
    seen = whole & ~hider
    found = complete(picture((whole, RED), (hider, BLUE)), detect(seen), (detect(hider),))
    assert found.occluded
    assert mask_iou(alpha_in_picture(found), seen) < 0.9
    assert mask_iou(alpha_in_picture(found), whole) > 0.95
    opaque = found.crop[found.crop[..., 3] > 250][:, :3].astype(int)
    assert np.abs(opaque - RED).mean() < 12, "the hider's colour is gone"
    np.testing.assert_array_equal(found.mask, seen)


def test_a_neighbour_that_hides_nothing_changes_nothing():
    mask, other = disc(80, 100, 35), disc(180, 100, 35)
    reference = picture((mask, RED), (other, BLUE))
    alone = complete(reference, detect(mask), ())
    beside = complete(reference, detect(mask), (detect(other),))
    np.testing.assert_array_equal(alone.crop, beside.crop)
    assert not beside.occluded


def test_things_on_the_table_are_painted_over():
    table = np.zeros((H, W), bool)
    table[40:160, 20:220] = True
    thing = disc(120, 100, 25)
    seen = table & ~thing
    found = complete(picture((table, RED), (thing, BLUE)), detect(seen, "table"), (detect(thing),))
    assert found.occluded
    assert mask_iou(alpha_in_picture(found), table) > 0.97
    opaque = found.crop[found.crop[..., 3] > 250][:, :3].astype(int)
    assert np.abs(opaque - RED).max(1).mean() < 8


def test_an_object_at_the_picture_edge_keeps_its_place():
    mask = disc(4, 100, 30)
    found = complete(picture((mask, RED)), detect(mask), ())
    assert found.crop_box[0] < 0
    assert mask_iou(alpha_in_picture(found), mask) > 0.95


def test_same_input_same_bytes():
    mask = disc(100, 90, 30)
    reference = picture((mask, RED))
    first, second = (complete(reference, detect(mask), ()) for _ in range(2))
    np.testing.assert_array_equal(first.crop, second.crop)


def completed(axis: int, hider: tuple[slice, slice], aside: tuple[float, float, float] | None):
    """Complete a partly hidden disc, red, its upper (0) or left (1) half green; also the disc.

    What ``aside`` adds to its full mask is neither seen nor hidden.
    """
    whole, half, hiding = disc(120, 100, 45), np.zeros((H, W), bool), np.zeros((H, W), bool)
    half[:100] = axis == 0
    half[:, :120] |= axis == 1
    hiding[hider] = True
    reference = picture((whole, RED), (whole & half, GREEN), (hiding, BLUE))
    seen, full = whole & ~hiding, whole if aside is None else whole | disc(*aside)
    detection = Detection("thing", mask_box(seen), seen, 1.0, full)
    return complete(reference, detection, (detect(hiding),)), whole


def test_a_full_mask_is_believed_where_something_hides():
    found, whole = completed(0, np.s_[50:110, 120:200], aside=(40, 100, 20))
    assert found.occluded
    assert mask_iou(alpha_in_picture(found), whole) > 0.96


def test_hidden_places_look_like_their_mirror_images():
    found, _ = completed(0, np.s_[40:160, 140:200], aside=None)
    height, width = found.crop.shape[:2]
    right = found.crop[:, int(0.8 * width) : int(0.9 * width)]
    upper, lower = right[int(0.3 * height), :, :3], right[int(0.7 * height), :, :3]
    assert np.abs(upper.astype(int) - GREEN).max() < 20
    assert np.abs(lower.astype(int) - RED).max() < 20


def test_a_thing_of_two_colours_side_by_side_is_not_mirrored():
    found, _ = completed(1, np.s_[90:110, 150:200], aside=None)
    height, width = found.crop.shape[:2]
    hidden = found.crop[int(0.5 * height), int(0.82 * width), :3]
    assert np.abs(hidden.astype(int) - RED).max() < 25


def test_a_full_mask_of_another_size_is_refused():
    mask = disc(100, 90, 30)
    with pytest.raises(InputError, match=r"Detection\.full"):
        Detection("thing", mask_box(mask), mask, 1.0, mask[:50])


def test_a_thing_found_in_pieces_is_one():
    shade, base = disc(120, 50, 30), disc(110, 150, 25)
    stem = np.zeros((H, W), bool)
    stem[100:135, 112:118] = True
    found = complete(picture((shade | stem | base, RED)), detect(shade | stem | base), ())
    outline = alpha_in_picture(found)
    assert cv2.connectedComponents(outline.astype(np.uint8))[0] == 2, "ground and one thing"
    assert mask_iou(outline, shade | stem | base) > 0.95, "the bridges are as thin as the stem"
    opaque = found.crop[found.crop[..., 3] > 250][:, :3].astype(int)
    assert np.abs(opaque - RED).max() < 30, "and have its colour"


def test_specks_beside_a_thing_are_left_alone():
    whole = disc(120, 100, 40)
    mask = whole.copy()
    mask[20:22, 20:22] = True
    outline = alpha_in_picture(complete(picture((mask, RED)), detect(mask), ()))
    assert mask_iou(outline[24:], whole[24:]) > 0.97, "no bridge leads to it"
