"""The grasp detector: what it answers, what it is given, and what of it is kept."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
import torch
from toy import toy_object, toy_scene

from generator.errors import StorageError
from tabletopgen_env.detection.detector import PATH, save_detector, shipped_detector
from tabletopgen_env.detection.look import Look, look
from tabletopgen_env.detection.network import PLACES, TURNS, GraspNetwork, turned
from tabletopgen_env.expert.grasps import Grasp, is_like
from tabletopgen_env.robot.panda import Panda
from tabletopgen_env.world import World


def world_of(*objects) -> World:
    world = World(toy_scene(objects), Panda())
    world.reset()
    return world


def best_of(*objects) -> Grasp:
    return shipped_detector().detect(look(world_of(*objects), objects[0].name))[0]


def apart(angle: float, other: float) -> float:
    """How far two directions of opening are apart, radians."""
    return abs((angle - other + np.pi / 2) % np.pi - np.pi / 2)


@pytest.mark.parametrize("yaw", [0.0, 0.5, 2.2])
def test_a_box_is_taken_by_its_middle_across_its_narrow_side(yaw: float) -> None:
    best = best_of(toy_object("box", (0.12, 0.04, 0.06), (0.1, 0.05), yaw=yaw))
    np.testing.assert_allclose(best.point[:2], [0.1, 0.05], atol=0.02)
    assert apart(best.angle, yaw + np.pi / 2) < np.deg2rad(20)
    assert best.width == pytest.approx(0.04, abs=0.01) and best.opening > best.width
    assert 0.74 < best.point[2] < 0.8


def test_a_wide_cup_is_taken_by_its_wall() -> None:
    best = best_of(toy_object("bowl", (0.16, 0.16, 0.07), (0.0, 0.0), wall=0.008))
    assert best.width < 0.025
    assert 0.055 < np.linalg.norm(best.point[:2]) < 0.09
    assert apart(best.angle, np.arctan2(best.point[1], best.point[0])) < np.deg2rad(25)


def test_neighbours_forbid_the_sides_they_stand_at() -> None:
    cube = toy_object("cube", (0.04, 0.04, 0.04), (0.0, 0.0))
    walls = (toy_object(f"wall_{x}", (0.02, 0.1, 0.04), (x, 0.0)) for x in (-0.042, 0.042))
    assert apart(best_of(cube, *walls).angle, np.pi / 2) < np.deg2rad(40)


def test_it_sees_height_maps_alone() -> None:
    """What the maps do not show changes nothing: the mass, the name, the parts' number."""
    cube = toy_object("cube", (0.04, 0.05, 0.04), (0.0, 0.0))
    other = toy_object("thing", (0.04, 0.05, 0.04), (0.0, 0.0), mass=2.0, friction=0.1)
    one, two = best_of(cube), best_of(other)
    assert np.array_equal(one.point, two.point) and one.angle == two.angle


def test_it_turns_with_what_it_sees() -> None:
    heights = look(world_of(toy_object("box", (0.12, 0.04, 0.06), (0.1, 0.05))), "box").heights
    straight = turned(torch.from_numpy(heights)[None], torch.zeros(1))
    quarter = turned(
        torch.from_numpy(np.rot90(heights, axes=(1, 2)).copy())[None], torch.full((1,), np.pi / 2)
    )
    assert torch.allclose(straight[0, 0], quarter[0, 0], atol=1e-4)


def test_the_network_rates_every_turn_and_place() -> None:
    rated = GraspNetwork()(turned(torch.zeros(2, 2, 64, 64, dtype=torch.uint8), torch.zeros(2)))
    assert rated.best.shape == rated.possible.shape == (2, TURNS, PLACES, PLACES)
    assert rated.at.shape == (2, TURNS, PLACES, PLACES, 3)
    along = rated.at[0, 0, :, 0, 0].detach()
    assert along[-1] - along[0] == pytest.approx(0.23, abs=0.05)


def test_where_there_is_nothing_there_is_no_grasp() -> None:
    empty = Look(np.zeros((2, 64, 64), np.uint8), np.zeros(2), 0.0, 0.74)
    assert shipped_detector().detect(empty) == []


def test_a_plan_is_one_that_the_arm_reaches_and_that_has_not_failed() -> None:
    world = world_of(toy_object("box", (0.12, 0.04, 0.06), (0.1, 0.05), yaw=0.5))
    detector = shipped_detector()
    plan = detector(world, "box")
    assert plan is not None
    again = detector(world, "box", (plan.grasp,))
    assert again is not None and not is_like(again.grasp, plan.grasp)
    far = world_of(toy_object("box", (0.12, 0.04, 0.06), (0.1, 0.05)))
    far.teleport("box", far.position("box") + np.array([3.0, 0.0, 0.0]))
    assert detector(far, "box") is None


def test_weights_are_written_and_read(tmp_path: Path) -> None:
    network = shipped_detector().network
    save_detector(network, tmp_path / "own.safetensors", {"scenes": 0})
    read = shipped_detector(tmp_path / "own.safetensors").network
    for key, value in network.state_dict().items():
        assert torch.allclose(value, read.state_dict()[key], atol=1e-3)


def test_weights_that_cannot_be_used_say_what_to_do(tmp_path: Path) -> None:
    path = tmp_path / "broken.safetensors"
    with pytest.raises(StorageError, match=r"detection\.training"):
        shipped_detector(path)
    path.write_bytes(PATH.read_bytes()[:1000])
    with pytest.raises(StorageError, match="cannot be used"):
        shipped_detector(path)
    save_detector(GraspNetwork(8), path, {})
    with pytest.raises(StorageError, match="cannot be used"):
        shipped_detector(path)
