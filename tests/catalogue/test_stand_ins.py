"""Stand-ins: each family has a distinct shape and size, marked as a stand-in."""

from __future__ import annotations

from importlib.resources import files

import numpy as np
import pytest

from generator.physics.parts import body_parts
from generator.stand_ins import FAMILIES, GENERIC, build_stand_in, stand_in_size


@pytest.mark.parametrize("family", FAMILIES)
def test_a_stand_in_is_of_its_familys_size(family: str) -> None:
    model = build_stand_in(family, "thing", 0)
    assert model.stand_in and model.category == GENERIC and model.label == "thing"
    assert np.abs(np.log(model.size / stand_in_size(family))).max() < 0.5
    assert body_parts(model, model.size)


def test_a_size_is_kept() -> None:
    for family in ("appliance", "bottle", ""):
        assert build_stand_in(family, "thing", 0, size=(0.1, 0.1, 0.3)).size.max() == pytest.approx(
            0.3
        )


def test_a_small_one_is_smaller() -> None:
    assert max(stand_in_size("bag", {"size": "small"})) < max(stand_in_size("bag"))


def test_every_family_of_the_dictionary_has_a_shape() -> None:
    table = files("generator.language") / "words" / "nouns.tsv"
    found = {line.split("\t")[1] for line in table.read_text().splitlines()}
    assert found - {"", "place", "person"} <= set(FAMILIES)
