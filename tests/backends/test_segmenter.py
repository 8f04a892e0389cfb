"""Masks, counts and names on painted pictures whose truth is known."""

from __future__ import annotations

import numpy as np
import pytest
from painted import iou, paint

from generator.backends.embedded.segmenter import Segmenter
from generator.backends.embedded.stacking import stack, support_share
from generator.errors import SceneError
from generator.geometry import mask_box
from generator.scene import Instance

THINGS = [("mug", -0.3, 0.1, 0.0), ("bowl", 0.0, -0.12, 0.0), ("apple", 0.3, 0.12, 0.0),
          ("book", -0.28, -0.15, 0.0)]  # fmt: skip


@pytest.mark.parametrize(
    ("outline", "material"),
    [("rectangle", "oak"), ("square", "walnut"), ("round", "marble")],
)
def test_every_thing_is_found_tightly(outline, material):
    picture = paint(outline, material, THINGS)
    table, *things = Segmenter().segment(picture.image, ("table", "object"))
    assert len(things) == len(THINGS)
    for index in range(1, len(THINGS) + 1):
        assert max(iou(t.mask, picture.ids == index) for t in things) > 0.85
    assert table.label == "table" and iou(table.mask, picture.ids == 0) > 0.9
    assert not any((table.mask & t.mask).any() for t in things)


@pytest.mark.parametrize("outline", ["rectangle", "slatted"])
def test_expected_words_go_to_the_right_things(outline):
    picture = paint(outline, "oak", THINGS)
    found = Segmenter().segment(picture.image, ("table", "apple", "book", "bowl", "mug"))
    for index, (key, *_) in enumerate(THINGS, start=1):
        best = max(found, key=lambda d: iou(d.mask, picture.ids == index))
        assert best.label == key


def test_a_thing_in_another_is_told_apart_when_expected():
    things = [("bowl", 0.0, 0.0, 0.0), ("apple", 0.0, 0.0, 0.02), ("mug", 0.3, 0.1, 0.0)]
    picture = paint("rectangle", "walnut", things)
    found = Segmenter().segment(picture.image, ("table", "bowl", "apple", "mug"))
    assert sorted(d.label for d in found) == ["apple", "bowl", "mug", "table"]
    apple = next(d for d in found if d.label == "apple")
    assert iou(apple.mask, picture.ids == 2) > 0.6


def test_masks_agree_with_boxes_and_repeat_exactly():
    picture = paint("rectangle", "white", THINGS)
    first = Segmenter().segment(picture.image, ("table", "object"))
    again = Segmenter().segment(picture.image, ("table", "object"))
    for a, b in zip(first, again, strict=True):
        np.testing.assert_array_equal(a.mask, b.mask)
        np.testing.assert_array_equal(a.box, mask_box(np.asarray(a.mask)))


def test_noise_is_not_a_table():
    noise = np.random.default_rng(0).integers(0, 255, (240, 320, 3)).astype(np.uint8)
    with pytest.raises(SceneError):
        Segmenter().segment(noise, ("table", "object"))


def _box_mask(x0: int, y0: int, x1: int, y1: int) -> np.ndarray:
    mask = np.zeros((100, 100), bool)
    mask[y0:y1, x0:x1] = True
    return mask


def _instance(name: str, mask: np.ndarray) -> Instance:
    crop = np.zeros((4, 4, 4), np.uint8)
    box = mask_box(mask)
    return Instance(name, name.split("_")[0], box, mask, crop, box)


def test_on_something_differs_from_behind_it():
    book = _box_mask(20, 40, 80, 80)
    on_top, behind = _box_mask(40, 30, 60, 65), _box_mask(40, 10, 60, 40)
    assert support_share(on_top, book & ~on_top) > 0.9
    assert support_share(behind, book) < 0.2
    instances = (_instance("table", _box_mask(0, 0, 100, 100)),
                 _instance("cup_1", on_top), _instance("tray_1", book & ~on_top),
                 _instance("vase_1", behind & ~on_top))  # fmt: skip
    found = stack(instances, lambda label: label == "tray")
    assert (found["cup_1"].on, found["cup_1"].inside) == ("tray_1", True)
    assert found["vase_1"].on == "table" and not found["vase_1"].inside
    assert found["cup_1"].order > found["tray_1"].order > found["table"].order
