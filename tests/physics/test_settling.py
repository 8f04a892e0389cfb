"""The criterion for toppled objects."""

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


def test_what_settles_has_the_friction_of_its_scene_in_the_end() -> None:
    scene = toy_scene((toy_object("box_1", (0.05,) * 3, (0.0, 0.0), top=0.745),))
    simulation = Simulation(scene)
    option = simulation.model.opt
    before = option.impratio, option.timestep, option.gravity.copy()
    settle(scene, 1.0, shake=0.05, simulation=simulation)
    assert (option.impratio, option.timestep) == before[:2]
    np.testing.assert_array_equal(option.gravity, before[2])
    assert simulation.time < 3.5  # shaken for 2 s, and no longer than it takes


def test_a_thing_at_rest_is_not_waited_for_and_one_that_falls_is() -> None:
    times = []
    for top in (0.74, 0.9):
        scene = toy_scene((toy_object("box_1", (0.05,) * 3, (0.0, 0.0), top=top),))
        simulation = Simulation(scene)
        (pose,) = settle(scene, 4.0, simulation=simulation)
        assert pose.position[2] == pytest.approx(0.765, abs=1e-3)
        times.append(simulation.time)
    assert times[0] < 0.8 < times[0] + 0.2 < times[1] + 0.2
