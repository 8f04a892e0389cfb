"""The gate must catch every kind of unsound scene: one that cannot fail is a defect."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from toy import toy_object, toy_scene, toy_table

from generator.physics.gate import Limits, judge, reach
from generator.scene import Object, Pose, Scene


def cube(name: str, x: float, y: float = 0.0, z: float = 0.0, **options) -> Object:
    return toy_object(name, (0.05, 0.05, 0.05), (x, y), top=0.74 + z, **options)


def failures(*objects: Object, limits: Limits | None = None) -> str:
    return "; ".join(judge(toy_scene(objects), limits).failures)


def test_a_sound_scene_passes() -> None:
    report = judge(toy_scene())
    assert report.passed
    assert report.penetration < 1e-4
    assert report.drift < 1e-3
    assert report.seconds == 2.0


def test_an_empty_table_passes() -> None:
    assert judge(toy_scene(())).passed


def test_two_things_in_one_place_fail() -> None:
    said = failures(cube("a_1", 0), cube("b_1", 0.047))
    assert "b_1 overlaps a_1 by 3.0 mm" in said


def test_half_a_millimetre_is_let_pass_and_two_are_not() -> None:
    assert "overlaps" not in failures(cube("a_1", 0), cube("b_1", 0.0495))
    assert "overlaps" in failures(cube("a_1", 0), cube("b_1", 0.048))


def test_sunk_into_the_table_fails() -> None:
    assert "a_1 overlaps the table by 4.0 mm" in failures(cube("a_1", 0, z=-0.004))


def test_floating_fails_from_two_millimetres_on() -> None:
    assert "floats" not in failures(cube("a_1", 0, z=0.0015))
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


def test_limits_are_the_callers() -> None:
    assert failures(cube("a_1", 0, z=0.005), limits=Limits(gap=0.006)) == ""
    assert judge(toy_scene((cube("a_1", 0),)), Limits(seconds=0.1)).seconds == 0.1


@pytest.mark.parametrize(
    ("xy", "expected"), [((0.0, 0.0), 0.35), ((0.5, 0.0), 0.1), ((0, 0.3), 0.05)]
)
def test_reach_is_from_the_best_side(xy, expected) -> None:
    assert reach(toy_scene((cube("a_1", *xy),))) == pytest.approx(expected)


def test_earlier_corrections_stay_in_the_report() -> None:
    first = dataclasses.replace(judge(toy_scene()), moved=0.03, settling=0.002, dropped=("x_1",))
    again = judge(toy_scene().replace(report=first))
    assert (again.moved, again.settling, again.dropped) == (0.03, 0.002, ("x_1",))
