"""What counts as toppled."""

import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.physics.settling import has_toppled, settle
from generator.physics.simulation import Simulation
from generator.scene import Pose

LIMIT = float(np.deg2rad(30.0))


def tipped(degrees: float) -> Pose:
    half = np.deg2rad(degrees) / 2
    return Pose(np.zeros(3), np.array([np.cos(half), np.sin(half), 0.0, 0.0]))


@pytest.mark.parametrize(
    ("size", "degrees", "toppled"),
    [
        ((0.06, 0.06, 0.2), 20, False), ((0.06, 0.06, 0.2), 90, True),
        ((0.06, 0.06, 0.2), 180, True), ((0.05, 0.05, 0.05), 90, False),
        ((0.05, 0.05, 0.05), 180, False), ((0.2, 0.01, 0.01), 180, False),
    ],
)  # fmt: skip
def test_bottles_topple_dice_and_pencils_roll(size, degrees, toppled) -> None:
    assert has_toppled(toy_object("thing_1", size, (0.0, 0.0)), tipped(degrees), LIMIT) == toppled


def test_settling_that_breaks_down_gives_the_poses_it_began_with(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    thing = toy_object("box_1", (0.05,) * 3, (0.0, 0.0), top=0.75)
    (rested,) = settle(toy_scene((thing,)), 0.2)
    assert rested.position[2] < thing.pose.position[2] - 5e-3
    monkeypatch.setattr(Simulation, "diverged", property(lambda self: (0,)))
    assert settle(toy_scene((thing,)), 0.2) == (thing.pose,)
