"""Masks, counts and names on painted pictures with ground truth."""

import numpy as np
import pytest
from extent import part_of
from painted import paint

from generator.backends.embedded.segmenter import EmbeddedSegmenter
from generator.errors import SceneError
from generator.geometry import mask_box
from generator.meshes.pixels import mask_iou

THINGS = [("mug", -0.3, 0.1, 0.0), ("bowl", 0.0, -0.12, 0.0), ("apple", 0.3, 0.12, 0.0),
          ("book", -0.28, -0.15, 0.0)]  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize(
    ("outline", "material"),
    part_of(
        [("rectangle", "oak"), ("square", "walnut"), ("round", "marble")],
        ("rectangle", "oak"),
        ("round", "marble"),
    ),
)
def test_every_thing_is_found_tightly(outline, material):
    picture = paint(outline, material, THINGS)
    table, *things = EmbeddedSegmenter().segment(picture.image, ("table", "object"))
    assert len(things) == len(THINGS)
    for index in range(1, len(THINGS) + 1):
        assert max(mask_iou(t.mask, picture.ids == index) for t in things) > 0.85
    assert table.label == "table" and mask_iou(table.mask, picture.ids == 0) > 0.9
    assert not any((table.mask & t.mask).any() for t in things)


@pytest.mark.slow
@pytest.mark.parametrize("outline", ["rectangle", "slatted"])
def test_expected_words_go_to_the_right_things(outline):
    picture = paint(outline, "oak", THINGS)
    found = EmbeddedSegmenter().segment(picture.image, ("table", "apple", "book", "bowl", "mug"))
    for index, (key, *_) in enumerate(THINGS, start=1):
        best = max(found, key=lambda d: mask_iou(d.mask, picture.ids == index))
        assert best.label == key


@pytest.mark.slow
def test_a_thing_in_another_is_told_apart_when_expected():
    things = [("bowl", 0.0, 0.0, 0.0), ("apple", 0.0, 0.0, 0.02), ("mug", 0.3, 0.1, 0.0)]
    picture = paint("rectangle", "walnut", things)
    found = EmbeddedSegmenter().segment(picture.image, ("table", "bowl", "apple", "mug"))
    assert sorted(d.label for d in found) == ["apple", "bowl", "mug", "table"]
    apple = next(d for d in found if d.label == "apple")
    assert mask_iou(apple.mask, picture.ids == 2) > 0.6


@pytest.mark.slow
def test_masks_agree_with_boxes_and_repeat_exactly():
    picture = paint("rectangle", "white", THINGS)
    first = EmbeddedSegmenter().segment(picture.image, ("table", "object"))
    again = EmbeddedSegmenter().segment(picture.image, ("table", "object"))
    for a, b in zip(first, again, strict=True):
        np.testing.assert_array_equal(a.mask, b.mask)
        np.testing.assert_array_equal(a.box, mask_box(np.asarray(a.mask)))


def test_noise_is_not_a_table():
    noise = np.random.default_rng(0).integers(0, 255, (240, 320, 3)).astype(np.uint8)
    with pytest.raises(SceneError):
        EmbeddedSegmenter().segment(noise, ("table", "object"))
