"""Views from hardly above the top: told by how little of it shows beside what stands on it."""

from __future__ import annotations

import numpy as np
import pytest

from generator.backends.embedded.eye.judge import EyeDetection
from generator.backends.embedded.eye.network import REGIONS
from generator.backends.embedded.eye.sight import EyeReading
from generator.backends.embedded.plane.eye_level import view_from_eye_level
from generator.scene import View

SIDE = 200
EXPECTED = View(0.0, float(np.deg2rad(24)), float(np.deg2rad(30)))


def reading(band: int, things: int = 2, sure: float = 0.9) -> EyeReading:
    """Return a picture with a band of tabletop, and things 60 pixels tall that stand on it."""
    region = np.zeros((len(REGIONS), SIDE, SIDE))
    region[REGIONS.index("background")] = 0.5
    region[REGIONS.index("top"), 100 : 100 + band] = 1.0
    found = []
    for k in range(things):
        mask = np.zeros((SIDE, SIDE), bool)
        mask[45:105, 20 + 60 * k : 50 + 60 * k] = True
        region[REGIONS.index("thing")][mask] = 2.0
        found.append(EyeDetection(sure, sure, mask, mask, np.zeros(1)))
    top = np.zeros((SIDE, SIDE))
    top[100 : 100 + band] = 1.0
    return EyeReading(tuple(found), region, top, np.zeros((SIDE, SIDE)))


def test_a_narrow_band_under_tall_things_is_seen_from_eye_level() -> None:
    sight = reading(band=25)
    view = view_from_eye_level(sight, sight.top > 0.5, EXPECTED)
    assert view is not None
    assert np.deg2rad(2) <= view.elevation <= np.deg2rad(11)
    assert view.fov == EXPECTED.fov


@pytest.mark.parametrize(
    ("sight", "expected"),
    [
        (reading(band=65), EXPECTED),  # the top shows well
        (reading(band=25, things=1), EXPECTED),  # one thing says little
        (reading(band=25, sure=0.3), EXPECTED),
        (reading(band=25), View(0.0, float(np.deg2rad(40)), EXPECTED.fov)),  # surely from above
    ],
)
def test_other_views_are_left_to_the_eye(sight: EyeReading, expected: View) -> None:
    assert view_from_eye_level(sight, sight.top > 0.5, expected) is None


def test_a_wider_band_is_seen_from_higher() -> None:
    low, high = (view_from_eye_level(s, s.top > 0.5, EXPECTED) for s in (reading(8), reading(55)))
    assert low is not None and high is not None and low.elevation < high.elevation
