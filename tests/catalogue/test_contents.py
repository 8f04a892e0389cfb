"""Vessels show their stated contents."""

from __future__ import annotations

import numpy as np
import pytest

from tabletop_objects import build
from tabletop_objects.kit.materials import drink_color
from tabletop_objects.kit.surfaces import Look


def look(state: str) -> Look:
    return Look(np.random.default_rng(0), {"state": state})


def test_a_drink_has_its_colour_or_the_one_asked_for() -> None:
    assert drink_color(look("with orange juice")) is not None
    assert drink_color(look("with blue liquid")) != drink_color(look("with green liquid"))
    assert drink_color(look("open")) is None


@pytest.mark.parametrize(
    ("key", "state"), [("mug", "with tea"), ("bowl", "with crisps"), ("glass", "with milk")]
)
def test_contents_show(key: str, state: str) -> None:
    full, empty = (build(key, 0, attributes={"state": s}) for s in (state, "empty"))
    same = full.mesh.texture.shape == empty.mesh.texture.shape
    assert not same or not np.array_equal(full.mesh.texture, empty.mesh.texture)
    assert np.allclose(full.size, empty.size)
