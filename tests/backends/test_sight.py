"""The eye's detections in a painted picture: separate objects, and objects in others."""

import numpy as np
import pytest
import torch
from painted import Picture, paint

from generator.backends.embedded.eye.detections import apart, overlaps
from generator.backends.embedded.eye.sight import EyeReading, glance_at, look
from generator.backends.embedded.eye.weights import load_weights
from generator.meshes.pixels import mask_iou


@pytest.fixture(scope="module")
def picture() -> Picture:
    things = [("bowl", 0.0, 0.0, 0.0), ("apple", 0.0, 0.0, 0.02), ("mug", 0.3, 0.1, 0.0)]
    return paint("rectangle", "walnut", things)


@pytest.fixture(scope="module")
def sight(picture: Picture) -> EyeReading:
    return look(picture.image, minimum=0.15)


@pytest.fixture(scope="module")
def glance(picture: Picture) -> EyeReading:
    return glance_at(load_weights(), picture.image)


@pytest.mark.slow
@pytest.mark.parametrize("threads", [1, 2, 3])
def test_it_sees_the_same_bits_on_any_number_of_threads(
    picture: Picture, sight: EyeReading, glance: EyeReading, threads: int
) -> None:
    before = torch.get_num_threads()
    torch.set_num_threads(threads)
    try:
        again, looked = glance_at(load_weights(), picture.image), look(picture.image, minimum=0.15)
    finally:
        torch.set_num_threads(before)
    for name in ("region", "top", "latitude"):
        assert getattr(again, name).tobytes() == getattr(glance, name).tobytes()
    assert [f.names.tobytes() for f in again.things] == [f.names.tobytes() for f in glance.things]
    assert [t.score for t in looked.things] == [t.score for t in sight.things]


def test_overlap_of_masks():
    masks = torch.zeros(3, 1, 8, dtype=torch.bool)
    masks[0, 0, :4] = masks[1, 0, 2:4] = masks[2, 0, 6:] = True
    overlap = overlaps(masks)
    assert overlap[0, 1] == pytest.approx(0.5) and overlap[0, 2] == 0
    score = torch.tensor([0.2, 0.9, 0.0])
    assert apart(score, overlap > 0.4) == [1]  # the first clashes, the last is nothing
    assert apart(score, overlap > 0.6) == [1, 0]


@pytest.mark.slow
def test_things_share_no_pixel_and_the_surest_come_first(sight: EyeReading):
    assert (np.sum([t.visible for t in sight.things], axis=0) <= 1).all()
    scores = [t.score for t in sight.things]
    assert scores == sorted(scores, reverse=True) and 0.15 <= min(scores) <= max(scores) <= 1
    assert all((t.visible <= t.whole).all() for t in sight.things)


@pytest.mark.slow
def test_what_lies_in_a_bowl_is_a_thing_and_the_bowl_another(picture: Picture, sight: EyeReading):
    for number in (1, 2, 3):
        assert max(mask_iou(t.visible, picture.ids == number) for t in sight.things) > 0.6


@pytest.mark.slow
def test_what_only_shows_from_near_lies_within_something_seen_before(glance: EyeReading):
    first = np.any([f.whole for f in glance.things if f.first > 0], axis=0)
    near = [f.visible for f in glance.things if f.first == 0]
    assert near
    assert all((mask & first).sum() > 0.2 * mask.sum() for mask in near)
