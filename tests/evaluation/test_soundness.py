"""Floating, drifting and overhanging objects, found individually under several rules."""

import dataclasses

import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.errors import InputError
from generator.evaluation.soundness import PLAIN, VARIANTS, StillnessRule, soundness
from generator.physics.mjcf import FLAT_SPOT
from generator.scene import Object

SHORT = dataclasses.replace(PLAIN, seconds=0.5)


def cube(name: str = "cube_1", x: float = 0.0, z: float = 0.0) -> Object:
    return toy_object(name, (0.05,) * 3, (x, 0.0), top=0.74 + z)


def fruit(radius: float) -> Object:
    """A solid ball a little lighter than water."""
    mass = 900 * 4 / 3 * np.pi * radius**3
    ball = toy_object("orange_1", (2 * radius,) * 3, (0, 0), kind="ellipsoid", mass=mass)
    return dataclasses.replace(ball, inertia=0.4 * mass * radius**2 * np.eye(3))


@pytest.mark.slow
def test_a_sound_scene_stands_still_under_every_rule() -> None:
    for name, rule in VARIANTS.items():
        found = soundness(toy_scene(), dataclasses.replace(rule, seconds=1.0))
        assert (found.unstable, found.floating, found.off_table) == ((), (), ()), name
    assert len(VARIANTS) == 9


def test_the_plain_rule_is_five_seconds_five_millimetres_two_degrees() -> None:
    assert (PLAIN.seconds, PLAIN.drift, np.rad2deg(PLAIN.tilt), PLAIN.gap) == (5, 5e-3, 2, 1e-3)


def test_floating_counts_from_one_millimetre_on() -> None:
    assert soundness(toy_scene((cube(z=0.0008),)), SHORT).floating == ()
    found = soundness(toy_scene((cube(z=0.0012), cube("cube_2", 0.3))), SHORT)
    assert found.floating == ("cube_1",)
    assert found.stable


def test_what_falls_far_is_unstable_and_the_other_is_not() -> None:
    found = soundness(toy_scene((cube(z=0.03), cube("cube_2", 0.3))), SHORT)
    assert found.unstable == ("cube_1",)
    first = found.objects[0]
    assert first.drift == pytest.approx(0.03, abs=2e-3)
    assert (first.floats, first.falls) == (True, False)
    assert found.facts()["most_drift_mm"] == pytest.approx(30, abs=2)


def test_beyond_the_edge_is_off_the_table_and_falls() -> None:
    found = soundness(toy_scene((cube(x=0.62),)))
    assert found.off_table == ("cube_1",)
    assert found.objects[0].falls
    assert not found.stable


def test_a_leaning_gravity_moves_what_barely_stands_and_not_what_stands() -> None:
    pole = toy_object("pole_1", (0.012, 0.012, 0.5), (0, 0))
    scene = toy_scene((pole, cube("cube_1", 0.3)))
    assert soundness(scene, dataclasses.replace(PLAIN, seconds=2.0)).stable
    for name in ("leaning to +x", "leaning to -y"):
        rule = dataclasses.replace(VARIANTS[name], seconds=2.0)
        assert soundness(scene, rule).unstable == ("pole_1",)


@pytest.mark.parametrize("radius", [0.006, 0.015, 0.021, 0.037, 0.11])
@pytest.mark.parametrize("timestep", [1e-3, 4e-3])
def test_round_things_lie_still_on_a_leaning_table(radius: float, timestep: float) -> None:
    rule = dataclasses.replace(VARIANTS["leaning to +x"], timestep=timestep)
    assert soundness(toy_scene((fruit(radius),)), rule).stable


def test_round_things_roll_away_from_about_six_degrees_on() -> None:
    angle = float(np.arctan(FLAT_SPOT))
    for factor, stable in ((0.7, True), (1.4, False)):
        rule = StillnessRule(seconds=3.0, tilt=0.1, lean=factor * angle)
        assert soundness(toy_scene((fruit(0.037),)), rule).stable is stable
    assert 5 < np.rad2deg(angle) < 7


@pytest.mark.parametrize(("toward", "falls"), [(90, True), (-90, False), (0, False)])
def test_gravity_leans_the_way_it_says(toward: float, falls: bool) -> None:
    pole = toy_object("pole_1", (0.02, 0.02, 0.4), (0, 0.33))
    rule = StillnessRule(seconds=3.0, lean=0.1, toward=float(np.deg2rad(toward)))
    assert soundness(toy_scene((pole,)), rule).objects[0].falls is falls


def test_the_rules_own_time_step_is_used() -> None:
    scene = toy_scene((cube(z=0.03),))
    own, same, coarse = (
        soundness(scene, StillnessRule(seconds=0.06, timestep=t)).objects[0].drift
        for t in (None, 2e-3, 4e-3)
    )
    assert own == same
    assert own != coarse


def test_a_simulation_that_breaks_down_is_no_standing_still(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    import mujoco

    from generator.physics.simulation import Simulation

    def run(self: Simulation, seconds: float, damping: float = 0.0) -> None:
        self.data.qvel[0] = np.nan
        mujoco.mj_step(self.model, self.data, 2)

    monkeypatch.setattr(Simulation, "run", run)
    found = soundness(toy_scene((cube(),)))
    assert found.diverged
    assert found.unstable == ("cube_1",)


@pytest.mark.parametrize(
    "wrong",
    [
        {"seconds": 0.0},
        {"drift": -1.0},
        {"tilt": float("nan")},
        {"timestep": 0.5},
        {"timestep": 0.0},
        {"lean": 1.0},
        {"lean": -0.1},
    ],
)
def test_rules_that_make_no_sense_are_refused(wrong: dict[str, float]) -> None:
    with pytest.raises(InputError):
        StillnessRule(**wrong)
