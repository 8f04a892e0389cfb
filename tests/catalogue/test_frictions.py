"""Friction of objects compared with published pairs of materials."""

import json
from pathlib import Path

import mujoco
import pytest
from toy import toy_object, toy_scene

from generator.physics.spec import scene_spec
from generator.scene import PlannedTable
from generator.tables import build_table
from tabletop_objects import CATEGORIES, build

KNOWN = json.loads((Path(__file__).parent / "known_frictions.json").read_text())["pairs"]
FACTOR = 1.5


def slide(what: str) -> float:
    """Return the friction of a category's object, or of a table of this material."""
    if what in CATEGORIES:
        return build(what, 0).physics.friction
    return build_table(PlannedTable(material=what), 0).physics.friction


def test_the_table_is_sound() -> None:
    assert len({(pair["thing"], pair["on"]) for pair in KNOWN}) == len(KNOWN) >= 12
    for pair in KNOWN:
        assert pair["source"]
        assert pair["thing"] in CATEGORIES
        assert 0 < pair["low"] <= pair["high"]


@pytest.mark.parametrize("pair", KNOWN, ids=lambda pair: f"{pair['thing']} on {pair['on']}")
def test_pairs_slide_as_published(pair) -> None:
    both = max(slide(pair["thing"]), slide(pair["on"]))
    assert pair["low"] / FACTOR <= both <= pair["high"] * FACTOR, pair["source"]


def test_a_contact_has_the_larger_friction_of_the_two() -> None:
    things = [
        toy_object(f"box_{k}", (0.05,) * 3, (0.2 * k, 0), top=0.7399, friction=friction)
        for k, friction in enumerate((0.3, 0.9))
    ]
    scene = toy_scene(tuple(things))
    model = scene_spec(scene).compile()
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    assert set(data.contact.friction[:, 0]) == {scene.table.friction, 0.9}
