"""Errors relative to a ground-truth scene: yaw modulo symmetry, position, size, support."""

import dataclasses
import json

import numpy as np
import pytest
from printed import box
from shapes import sphere_mesh
from toy import toy_object, toy_scene

from generator.evaluation.truth import truth_errors
from generator.geometry import yaw_quaternion
from generator.scene import Object, Pose


def turned(thing: Object, degrees: float, shift=(0.0, 0.0, 0.0)) -> Object:
    """Return the object with an additional rotation and displacement, metres."""
    yaw = thing.placement.yaw + np.deg2rad(degrees)
    pose = Pose(thing.pose.position + np.array(shift), yaw_quaternion(yaw))
    return dataclasses.replace(thing, pose=pose)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("degrees", "wrong"), [(0, 0), (10, 10), (90, 0), (80, 10), (135, 45), (-170, 10)]
)
def test_a_cubes_yaw_counts_modulo_a_quarter_turn(degrees: float, wrong: float) -> None:
    cube = toy_object("cube_1", (0.1, 0.1, 0.1), (0, 0))
    (found,) = truth_errors(toy_scene((turned(cube, degrees),)), toy_scene((cube,))).objects
    assert np.rad2deg(found.yaw) == pytest.approx(wrong, abs=1e-6)


@pytest.mark.parametrize("printed", [False, True])
def test_a_flip_of_a_printed_thing_is_an_error(printed: bool) -> None:
    """A box that is symmetric except for its print."""
    plain = toy_object("box_1", (0.2, 0.1, 0.08), (0, 0))
    thing = dataclasses.replace(
        plain, model=dataclasses.replace(plain.model, mesh=box(printed=printed))
    )
    (found,) = truth_errors(toy_scene((turned(thing, 180),)), toy_scene((thing,))).objects
    assert np.rad2deg(found.yaw) == pytest.approx(180 if printed else 0, abs=1e-6)
    assert found.symmetry == (1 if printed else 2)


def test_a_round_thing_has_no_yaw_and_its_facts_are_json() -> None:
    ball = toy_object("ball_1", (0.08, 0.08, 0.08), (0, 0))
    ball = dataclasses.replace(ball, model=dataclasses.replace(ball.model, mesh=sphere_mesh()))
    found = truth_errors(toy_scene((turned(ball, 71),)), toy_scene((ball,)))
    assert found.objects[0].yaw == 0
    assert json.loads(json.dumps(found.facts(), allow_nan=False))["objects"][0]["symmetry"] == (
        "round"
    )


@pytest.mark.slow
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
