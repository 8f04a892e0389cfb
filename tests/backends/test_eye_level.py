"""Views from slightly above the top, detected by the visible share of the top."""

from __future__ import annotations

import itertools

import numpy as np
import pytest
from extent import part_of

from generator.backends.embedded.eye.judge import EyeDetection
from generator.backends.embedded.eye.network import REGIONS
from generator.backends.embedded.eye.sight import EyeReading
from generator.backends.embedded.plane.tabletop import is_from_eye_level, plane_from_eye_level

SIDE = 200
EYE = float(np.deg2rad(24))


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
    assert is_from_eye_level(sight, sight.top > 0.5, EYE)


@pytest.mark.parametrize(
    ("sight", "elevation"),
    [
        (reading(band=65), EYE),  # the top shows well
        (reading(band=25, things=1), EYE),  # one thing says little
        (reading(band=25, sure=0.3), EYE),
        (reading(band=25), float(np.deg2rad(40))),  # surely from above
    ],
)
def test_other_views_are_left_to_the_eye(sight: EyeReading, elevation: float) -> None:
    assert not is_from_eye_level(sight, sight.top > 0.5, elevation)


@pytest.mark.parametrize(
    ("fov", "margin"), part_of(itertools.product([25, 40], [0, 30]), (25, 30), (40, 0))
)
def test_the_view_is_that_of_a_table_of_usual_depth(fov: float, margin: int) -> None:
    top = reading(band=14).top > 0.5
    top[:, :margin] = top[:, SIDE - margin :] = False
    plane = plane_from_eye_level(top, float(np.deg2rad(fov)), np.zeros_like(top))
    assert plane is not None
    assert np.deg2rad(1.9) < plane.view.elevation < np.deg2rad(12)
    assert 0.3 < plane.size[1] / plane.size[0] < 1.1


def test_what_no_low_view_shows_is_none() -> None:
    speck = np.zeros((SIDE, SIDE), bool)
    speck[:4, :4] = True
    assert plane_from_eye_level(speck, 0.5, np.zeros_like(speck)) is None
