"""Errors against a true scene: yaw modulo symmetry, place, size, support."""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest
from shapes import sphere_mesh
from toy import cube_mesh, toy_object, toy_scene

from generator.catalogue import build
from generator.evaluation.symmetry import STEPS, symmetry
from generator.evaluation.truth import truth_errors
from generator.geometry import yaw_quaternion
from generator.scene import Object, Pose


def turned(thing: Object, degrees: float, shift=(0.0, 0.0, 0.0)) -> Object:
    """The object turned further and moved, metres."""
    yaw = thing.placement.yaw + np.deg2rad(degrees)
    pose = Pose(thing.pose.position + np.array(shift), yaw_quaternion(yaw))
    return dataclasses.replace(thing, pose=pose)


@pytest.mark.parametrize(
    ("size", "order"), [((0.1, 0.1, 0.1), 4), ((0.1, 0.05, 0.1), 2), ((0.1, 0.1, 0.3), 4)]
)
def test_boxes_have_the_symmetry_of_their_base(size: tuple, order: int) -> None:
    assert symmetry(cube_mesh(), np.array(size)).order == order


def test_round_things_look_the_same_from_everywhere() -> None:
    ball = symmetry(sphere_mesh(), np.full(3, 0.08))
    assert ball.round
    assert ball.order == STEPS
    assert ball.error(1.234) == 0
    assert not symmetry(sphere_mesh(), np.array([0.12, 0.08, 0.08])).round


@pytest.mark.parametrize(("word", "order"), [("mug", 1), ("plate", STEPS), ("book", 2)])
def test_catalogue_things_have_the_symmetry_they_look_like(word: str, order: int) -> None:
    thing = build(word, 0)
    assert symmetry(thing.mesh, thing.size).order == order


@pytest.mark.parametrize(
    ("degrees", "wrong"), [(0, 0), (10, 10), (90, 0), (80, 10), (135, 45), (-170, 10)]
)
def test_a_cubes_yaw_counts_modulo_a_quarter_turn(degrees: float, wrong: float) -> None:
    cube = symmetry(cube_mesh(), np.full(3, 0.1))
    assert np.rad2deg(cube.error(np.deg2rad(degrees))) == pytest.approx(wrong, abs=1e-6)


def test_a_mugs_yaw_counts_in_full() -> None:
    mug = build("mug", 0)
    own = symmetry(mug.mesh, mug.size)
    assert np.rad2deg(own.error(np.pi)) == pytest.approx(180)
    assert np.rad2deg(own.error(-np.deg2rad(7))) == pytest.approx(7)


def test_a_scene_has_no_error_against_itself() -> None:
    found = truth_errors(toy_scene(), toy_scene())
    assert (found.missing, found.extra) == ((), ())
    assert len(found.objects) == 6
    for o in found.objects:
        assert (o.yaw, o.translation, o.scale, o.support) == (0, 0, 1, True)


def test_each_error_is_measured_in_its_unit() -> None:
    bar = toy_object("bar_1", (0.2, 0.04, 0.04), (0, 0))
    cube = toy_object("cube_1", (0.05,) * 3, (0.3, 0))
    small = toy_object("cube_1", (0.025, 0.025, 0.05), (0.3, 0))
    small = dataclasses.replace(small, placement=dataclasses.replace(small.placement, on="bar_1"))
    truth = toy_scene((bar, cube))
    found = truth_errors(toy_scene((turned(bar, 30, (0.03, -0.04, 0)), small)), truth)
    first, second = found.objects
    assert np.rad2deg(first.yaw) == pytest.approx(30)
    assert first.symmetry == 2
    assert first.translation == pytest.approx(0.05)
    assert first.share == pytest.approx(0.05 / 1.2)
    assert (first.scale, first.support) == (1, True)
    assert second.scale == pytest.approx(0.25 ** (1 / 3))
    assert second.worst_axis == pytest.approx(0.5)
    assert not second.support
    facts = found.facts()
    assert facts["mean_translation_error_cm"] == pytest.approx(2.5, abs=0.01)
    assert facts["support_accuracy"] == 0.5


def test_what_is_missing_or_too_many_is_named() -> None:
    a, b, c = (toy_object(f"cube_{k}", (0.05,) * 3, (0.1 * k, 0)) for k in range(3))
    found = truth_errors(toy_scene((a, c)), toy_scene((a, b)))
    assert (found.missing, found.extra) == (("cube_1",), ("cube_2",))
    assert truth_errors(toy_scene((c,)), toy_scene((a,))).facts()["mean_yaw_error_deg"] is None
