"""The eye's estimates of objects' proportions, and their training."""

import numpy as np
import pytest
import torch
from painted import paint

from generator.backends.embedded.eye.network import IMPRESSION
from generator.backends.embedded.eye.proportions import MASK, ProportionNetwork, proportion_clues
from generator.backends.embedded.eye.weights import load_proportions, load_weights
from generator.backends.embedded.plane.measure import sized_extent
from generator.backends.embedded.plane.tabletop import find_tabletop
from generator.geometry import mask_box
from research.eye.proportioning import ProportionLesson, errors, train_proportions

CLUES = IMPRESSION + MASK**2 + 2


def test_spreads_count_for_how_much_they_are_underrated() -> None:
    network = ProportionNetwork().eval()
    clues = np.zeros((2, CLUES), np.float32)
    one = network.tell(clues)[0]
    network.unsure.fill_(3.0)
    other = network.tell(clues)[0]
    np.testing.assert_array_equal(one.logs, other.logs)
    np.testing.assert_allclose(other.spread, 3 * one.spread, rtol=1e-6)
    assert one.extent[0] == 1.0 and (one.extent > 0).all()


def test_no_thing_has_no_clues() -> None:
    nothing = proportion_clues(load_weights().eye, np.zeros((40, 60, 3), np.uint8), [], [], 0.0)
    assert nothing.shape == (0, CLUES)
    assert load_proportions().tell(nothing) == []


@pytest.mark.slow
def test_what_lies_is_told_from_what_stands() -> None:
    things = [("spoon", -0.3, 0.0, 0.4), ("wine_bottle", 0.1, 0.1, 0.0), ("plate", 0.35, -0.1, 0.0)]
    picture = paint("rectangle", "oak", things)
    plane = find_tabletop(picture.image, picture.plan)
    masks = [picture.ids == k + 1 for k in range(len(things))]
    elevations = [plane.elevation_at(mask_box(mask)) for mask in masks]
    tabletop = float((picture.ids >= 0).sum())
    clues = proportion_clues(load_weights().eye, picture.image, masks, elevations, tabletop)
    spoon, bottle, plate = load_proportions().tell(clues)
    assert spoon.logs[1] < np.log(0.4) and spoon.logs[0] < np.log(0.5)
    assert bottle.logs[1] > np.log(1.5)
    assert plate.logs[1] < np.log(0.5) and plate.logs[0] > np.log(0.7)
    for told, mask in zip((spoon, bottle, plate), masks, strict=True):
        extent = sized_extent(mask_box(mask), told.extent, plane)
        np.testing.assert_allclose(extent / extent[0], told.extent)
        assert 0.05 < extent.max() < 0.5


@pytest.mark.slow
def test_proportions_are_learned_with_their_errors() -> None:
    rng = np.random.default_rng(0)
    clues = np.zeros((1500, CLUES), np.float32)
    clues[:, :8] = rng.normal(size=(1500, 8))
    noise = rng.laplace(scale=np.where(clues[:, 2] > 0, 0.4, 0.05)[:, None], size=(1500, 2))
    lesson = ProportionLesson(clues, (clues[:, :2] + noise).astype(np.float32))
    taught, asked = (
        ProportionLesson(*(part[half] for part in vars(lesson).values()))
        for half in (slice(0, 1200), slice(1200, None))
    )
    network = train_proportions(taught, 0, steps=300)
    off, spread = errors(network, asked)
    guess = np.abs(asked.logs - taught.logs.mean(0)).mean()
    assert off.mean() < 0.6 * guess
    noisy = asked.clues[:, 2] > 0
    assert spread[noisy].mean() > spread[~noisy].mean()
    assert torch.isfinite(network.unsure).all()
