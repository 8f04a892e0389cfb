"""The gate detects every kind of invalid scene."""

import dataclasses

import numpy as np
import pytest
from toy import toy_object, toy_scene, toy_table

from generator.errors import InputError
from generator.physics.gate import GateLimits, find_toppling, judge, reach, watch
from generator.physics.simulation import Simulation
from generator.scene import ConvexPart, Failure, Object, Pose, Scene


def cube(name: str, x: float, y: float = 0.0, z: float = 0.0, **options) -> Object:
    return toy_object(name, (0.05, 0.05, 0.05), (x, y), top=0.74 + z, **options)


def failures(*objects: Object, limits: GateLimits | None = None) -> str:
    return judge(toy_scene(objects), limits).failure_text


def test_a_sound_scene_passes() -> None:
    report = judge(toy_scene())
    assert report.passed
    assert report.penetration < 1e-4
    assert report.drift < 1e-3
    assert report.seconds == 5.0


def test_an_empty_table_passes() -> None:
    assert judge(toy_scene(())).passed


def test_two_things_in_one_place_fail() -> None:
    said = failures(cube("a_1", 0), cube("b_1", 0.047))
    assert "b_1 overlaps a_1 by 3.0 mm" in said


def test_less_than_half_a_millimetre_is_let_pass_and_more_is_not() -> None:
    assert "overlaps" not in failures(cube("a_1", 0), cube("b_1", 0.0496))
    assert "overlaps" in failures(cube("a_1", 0), cube("b_1", 0.0492))


def test_sunk_into_the_table_fails() -> None:
    assert "a_1 overlaps the table by 4.0 mm" in failures(cube("a_1", 0, z=-0.004))


def test_floating_fails_from_one_millimetre_on() -> None:
    assert "floats" not in failures(cube("a_1", 0, z=0.0008))
    assert "floats" in failures(cube("a_1", 0, z=0.0012))
    said = failures(cube("a_1", 0, z=0.03))
    assert "a_1 floats" in said
    assert "a_1 moved 30" in said


def test_a_pair_that_holds_only_each_other_floats() -> None:
    said = failures(cube("a_1", 0, z=0.03), cube("b_1", 0, z=0.08))
    assert "a_1 floats" in said
    assert "b_1 floats" in said


def test_toppling_fails() -> None:
    tall = toy_object("tall_1", (0.03, 0.03, 0.3), (0, 0))
    lean = np.deg2rad(12)
    tilted = Pose(
        tall.pose.position + np.array([0, 0, 0.015 * np.sin(lean)]),
        np.array([np.cos(lean / 2), np.sin(lean / 2), 0, 0]),
    )
    said = failures(dataclasses.replace(tall, pose=tilted))
    assert "tall_1 turned" in said
    assert "tall_1 moved" in said


def test_beyond_the_edge_falls() -> None:
    report = judge(toy_scene((cube("a_1", 0.61),)))
    assert report.off_table == ("a_1",)
    assert report.fallen == ("a_1",)
    assert not report.passed


def test_off_a_round_table_counts_its_own_outline() -> None:
    angles = np.linspace(0, 2 * np.pi, 32, endpoint=False)
    disc = 0.5 * np.column_stack([np.cos(angles), np.sin(angles)])
    scene = Scene(
        "x", toy_table(disc, (1, 1, 0.74)), (cube("a_1", 0.4, 0.4),), toy_scene().provenance
    )
    assert judge(scene).off_table == ("a_1",)


def marble(flat: float) -> Object:
    """Return a ball that stands on a flat spot of this radius."""
    radius, around = 0.02, np.linspace(0, 2 * np.pi, 24, endpoint=False)
    low = -np.sqrt(radius**2 - flat**2)
    rings = [(flat, low), *((radius * np.cos(a), radius * np.sin(a)) for a in (-0.6, -0.2, 0.2, 1))]
    points = [(r * np.cos(a), r * np.sin(a), z) for r, z in rings for a in around]
    thing = toy_object("ball_1", (2 * radius,) * 3, (0, 0), top=0.74 - radius - low)
    return dataclasses.replace(thing, parts=(ConvexPart(np.array(points)),), com=np.zeros(3))


def test_what_rolls_off_a_leaning_table_fails_and_passes_on_a_level_one() -> None:
    tiny, wide = 4e-4, 3e-3
    said = failures(marble(tiny))
    assert "ball_1 moved" in said
    assert "leaning" in said
    assert failures(marble(tiny), limits=GateLimits(lean=0.0)) == ""
    assert failures(marble(wide)) == ""


def test_a_thing_that_slides_evenly_is_seen_though_not_watched_to_the_end() -> None:
    """The limits apply to the extrapolation of a steady creep."""
    slope = np.deg2rad(0.5)
    scene = toy_scene((dataclasses.replace(cube("a_1", 0), friction=1e-4),))
    scene = scene.replace(table=dataclasses.replace(scene.table, friction=1e-4))
    simulation = Simulation(scene)
    simulation.place([o.pose for o in scene.objects])
    with simulation.conditions(slope, 0.0, 2e-3):
        drift, _ = watch(simulation, GateLimits())
    assert drift[0] > 0.1


def breaking(monkeypatch: pytest.MonkeyPatch, dof: int, leaning: bool) -> None:
    """Make a velocity of every simulation, or of the tilted ones, infinite."""
    import mujoco

    step = mujoco.mj_step

    def run(model: mujoco.MjModel, data: mujoco.MjData, nstep: int = 1) -> None:
        if model.opt.gravity[:2].any() or not leaning:
            data.qvel[dof] = np.inf
        step(model, data, nstep)

    monkeypatch.setattr(mujoco, "mj_step", run)


@pytest.mark.parametrize(("leaning", "where"), [(False, ""), (True, " on a leaning table")])
def test_a_simulation_that_breaks_down_fails_and_says_at_what(
    leaning: bool, where: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """MuJoCo restarts from the scene's poses, so that nothing seems to have moved."""
    breaking(monkeypatch, 8, leaning)
    report = judge(toy_scene((cube("a_1", 0), cube("b_1", 0.2))))
    said = f"b_1 moved beyond all bounds{where}: the simulation broke down"
    assert report.failures == (Failure("diverged", ("b_1",), leaning=leaning),)
    assert report.failure_text == said
    assert report.drift < 1e-3


def test_limits_are_the_callers() -> None:
    assert failures(cube("a_1", 0, z=0.005), limits=GateLimits(gap=0.006, drift=0.01)) == ""
    assert judge(toy_scene((cube("a_1", 0),)), GateLimits(seconds=0.1)).seconds == 0.1


def test_the_report_says_how_much_was_simulated_and_how_much_is_forecast() -> None:
    still = judge(toy_scene((cube("a_1", 0),)))
    assert still.seconds == 5.0
    assert still.simulated is not None
    assert 0.5 < still.simulated < 2.0
    dropped = judge(toy_scene((cube("a_1", 0, z=0.03),)), GateLimits(seconds=1.5))
    assert (dropped.seconds, dropped.simulated) == (1.5, 1.5)


def test_what_trembles_in_place_is_not_watched_to_the_end(monkeypatch: pytest.MonkeyPatch) -> None:
    place, tremble = Simulation.run, np.random.default_rng(0)

    def run(self: Simulation, seconds: float, damping: float = 0.0) -> None:
        place(self, seconds, damping)
        self.positions[0, :2] = tremble.uniform(-4e-6, 4e-6, 2)

    monkeypatch.setattr(Simulation, "run", run)
    report = judge(toy_scene((cube("a_1", 0),)))
    assert report.passed
    assert report.simulated is not None
    assert report.simulated < 1.5


def pushing(monkeypatch: pytest.MonkeyPatch, offset) -> None:
    """Displace an object by ``offset(t)`` metres when it is checked at time t."""
    step = Simulation.run

    def run(self: Simulation, seconds: float, damping: float = 0.0) -> None:
        before = self.time
        step(self, seconds, damping)
        self.positions[0, 0] += offset(self.time) - offset(before)

    monkeypatch.setattr(Simulation, "run", run)


def test_an_even_creep_is_watched_until_twice_its_pace_is_within_the_limits(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    pushing(monkeypatch, lambda t: 4e-4 * t)  # 2 mm in 5 s
    report = judge(toy_scene((cube("a_1", 0),)))
    assert report.passed
    assert report.simulated is not None
    assert report.simulated < 1.5
    assert report.drift == pytest.approx(2e-3, rel=0.05)


@pytest.mark.parametrize("offset", [lambda t: 2e-5 * (3.2**t), lambda t: 1.1e-3 * t])
def test_what_speeds_up_or_creeps_too_far_is_watched_to_the_end(
    offset, monkeypatch: pytest.MonkeyPatch
) -> None:
    pushing(monkeypatch, offset)
    report = judge(toy_scene((cube("a_1", 0),)))
    assert report.simulated == 5.0
    assert "a_1 moved" in report.failure_text


def test_toppling_is_looked_for_among_what_is_asked() -> None:
    tall = toy_object("tall_1", (0.008, 0.008, 0.3), (0, 0))
    scene = toy_scene((tall, cube("a_1", 0.2)))
    angle = float(np.deg2rad(30.0))
    assert find_toppling(scene, GateLimits(), angle) == ("tall_1",)
    assert find_toppling(scene, GateLimits(), angle, {"a_1"}) == ()
    assert find_toppling(scene, GateLimits(), angle, ()) == ()


@pytest.mark.parametrize(
    ("xy", "expected"), [((0.0, 0.0), 0.35), ((0.5, 0.0), 0.1), ((0, 0.3), 0.05)]
)
def test_reach_is_from_the_best_side(xy, expected) -> None:
    assert reach(toy_scene((cube("a_1", *xy),))) == pytest.approx(expected)


@pytest.mark.slow
def test_earlier_corrections_stay_in_the_report() -> None:
    first = dataclasses.replace(judge(toy_scene()), moved=0.03, settling=0.002, dropped=("x_1",))
    again = judge(toy_scene().replace(report=first))
    assert (again.moved, again.settling, again.dropped) == (0.03, 0.002, ("x_1",))


@pytest.mark.parametrize(
    "wrong", [{"seconds": 0.0}, {"drift": -1e-3}, {"gap": float("nan")}, {"lean": 90.0}]
)
def test_limits_out_of_range_are_refused(wrong) -> None:
    with pytest.raises(InputError, match=rf"Limits\.{next(iter(wrong))} must"):
        GateLimits(**wrong)
