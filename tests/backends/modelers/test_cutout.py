import dataclasses

import numpy as np
import pytest
from backends.modelers.foreign import instance

from generator.backends.modelers.cutout import cutout, on_grey
from generator.errors import BackendError
from generator.geometry import mask_box


def test_the_thing_fills_the_middle_of_a_transparent_square():
    made = cutout(instance("mug"), "it")
    assert made.shape == (256, 256, 4)
    x0, y0, x1, y1 = mask_box(made[..., 3] > 127)
    assert abs(x0 + x1 - 256) <= 8 and abs(y0 + y1 - 256) <= 8
    assert 0.8 < (x1 - x0) / 256 < 0.88
    assert made[0, 0].tolist() == [0, 0, 0, 0]


def test_large_crops_are_made_smaller():
    crop = np.full((1500, 700, 4), 255, np.uint8)
    assert cutout(dataclasses.replace(instance("mug"), crop=crop), "it").shape == (1024, 1024, 4)


def test_grey_shows_where_nothing_is():
    grey = on_grey(cutout(instance("mug"), "it"))
    assert abs(int(grey[0, 0, 0]) - 127) <= 1
    assert grey[128, 128].tolist() == [200, 30, 30]


def test_an_empty_crop_is_refused():
    crop = np.zeros((9, 9, 4), np.uint8)
    with pytest.raises(BackendError, match="it, model of 'mug_1': the crop is fully transparent"):
        cutout(dataclasses.replace(instance("mug"), crop=crop), "it")
