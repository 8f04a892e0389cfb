"""The grasp detector: its detections, its inputs, and its file."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import torch
from toy import toy_object
from worlds import world_of

from generator.errors import StorageError
from generator.scene import ConvexPart
from tabletopgen_env.detection.detector import PATH, read_detector, save_weights
from tabletopgen_env.detection.look import HeightView, look
from tabletopgen_env.detection.model import GraspNetwork
from tabletopgen_env.detection.network import MIDDLES, PLACES, SEEN, TURNS, rate, turn_views
from tabletopgen_env.expert.arm import wrist_is_free, wrists_are_free
from tabletopgen_env.expert.planning.grasps import TIP, Grasp, is_like
from tabletopgen_env.expert.planning.heights import surroundings


def best_of(*objects) -> Grasp:
    return read_detector().detect(look(world_of(*objects), objects[0].name))[0]


def apart(angle: float, other: float) -> float:
    """Return the angle between two opening directions, radians."""
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
    """Properties outside the maps have no effect: the mass, the name, the friction."""
    cube = toy_object("cube", (0.04, 0.05, 0.04), (0.0, 0.0))
    other = toy_object("thing", (0.04, 0.05, 0.04), (0.0, 0.0), mass=2.0, friction=0.1)
    one, two = best_of(cube), best_of(other)
    assert np.array_equal(one.point, two.point) and one.angle == two.angle


def test_it_sees_the_same_whatever_parts_a_thing_is_made_of() -> None:
    whole = toy_object("box", (0.12, 0.04, 0.06), (0.1, 0.05))
    halves = tuple(
        ConvexPart(whole.parts[0].vertices * [0.5, 1, 1] + [side * 0.03, 0, 0]) for side in (-1, 1)
    )
    one, two = best_of(whole), best_of(replace(whole, parts=halves))
    np.testing.assert_allclose(one.point, two.point, atol=1e-6)


def test_it_turns_with_what_it_sees() -> None:
    heights = look(world_of(toy_object("box", (0.12, 0.04, 0.06), (0.1, 0.05))), "box").heights
    straight = turn_views(heights, 0.0)
    quarter = turn_views(np.rot90(heights, axes=(1, 2)), np.pi / 2)
    np.testing.assert_allclose(straight[0], quarter[0], atol=1e-4)


def test_maps_are_seen_where_they_are() -> None:
    """A cell's height appears only at the cell's position."""
    heights = np.zeros((2, 64, 64), np.uint8)
    heights[1, 40, 20] = 100  # 3.4 cm along, -4.6 cm across
    seen = turn_views(heights, 0.0)[0, 1]
    axis = (np.arange(SEEN) - (SEEN - 1) / 2) * 0.005
    weights = seen / seen.sum()
    assert axis @ weights.sum(1) == pytest.approx(0.034, abs=0.0015)
    assert axis @ weights.sum(0) == pytest.approx(-0.046, abs=0.0015)
    assert np.count_nonzero(seen) <= 4


def test_the_network_is_the_one_that_is_trained() -> None:
    torch.manual_seed(0)
    network = GraspNetwork()
    weights = {key: value.float().numpy() for key, value in network.weights().items()}
    network.layers.load_state_dict({key: torch.from_numpy(v) for key, v in weights.items()})
    heights = np.random.default_rng(0).integers(0, 60, (2, 64, 64), dtype=np.uint8)
    seen = turn_views(heights, 0.3)
    trained = network(torch.from_numpy(seen)[None])
    for one, other in zip(rate(weights, seen), trained, strict=True):
        assert one.shape == (TURNS, PLACES, PLACES)
        np.testing.assert_allclose(one, other[0].detach(), atol=1e-4)


def test_a_place_is_rated_about_its_middle() -> None:
    """For a symmetric network, half a turn of the input is half a turn of the output."""
    torch.manual_seed(0)
    weights = {key: value.float().numpy() for key, value in GraspNetwork().weights().items()}
    both = {key: (v + v[..., ::-1, ::-1]) if v.ndim == 4 else v for key, v in weights.items()}
    heights = np.random.default_rng(0).integers(0, 60, (2, 64, 64), dtype=np.uint8)
    seen = turn_views(heights, 0.0)
    one = rate(both, seen).best
    other = rate(both, np.ascontiguousarray(seen[:, :, ::-1, ::-1])).best
    np.testing.assert_allclose(one, other[:, ::-1, ::-1], rtol=1e-3, atol=1e-4)
    assert pytest.approx(-MIDDLES[0]) == MIDDLES[-1]


def test_where_there_is_nothing_there_is_no_grasp() -> None:
    empty = HeightView(np.zeros((2, 64, 64), np.uint8), np.zeros(2), 0.0, 0.74)
    assert read_detector().detect(empty) == []


@pytest.mark.slow
def test_a_plan_is_one_that_the_arm_reaches_and_that_has_not_failed() -> None:
    world = world_of(toy_object("box", (0.12, 0.04, 0.06), (0.1, 0.05), yaw=0.5))
    detector = read_detector()
    plan = detector(world, "box")
    assert plan is not None
    again = detector(world, "box", (plan.grasp,))
    assert again is not None and not is_like(again.grasp, plan.grasp)
    far = world_of(toy_object("box", (0.12, 0.04, 0.06), (0.1, 0.05)))
    far.teleport("box", far.position("box") + np.array([3.0, 0.0, 0.0]))
    assert detector(far, "box") is None


def test_the_wrist_is_kept_off_what_stands_farther_off_than_the_maps_reach() -> None:
    box = toy_object("box", (0.2, 0.05, 0.06), (0.0, -0.1))
    open_world = world_of(box)
    back = (open_world.base_position - open_world.position("box"))[:2]
    back /= np.linalg.norm(back)
    at = open_world.position("box")[:2] + 0.17 * back + 0.05 * np.array([back[1], -back[0]])
    tower = toy_object("tower", (0.04, 0.04, 0.45), tuple(at))
    world = world_of(box, tower)
    found = read_detector().detect(look(world, "box"))
    points = np.array([grasp.point for grasp in found])
    middle = world.position("box")[:2]
    around = surroundings(world, "box", middle - 0.35, middle + 0.35, 0.01)
    clear = wrists_are_free(world, around, points[:, :2], points[:, 2] - TIP)
    assert clear.any() and not clear[0], "the best is not free"
    plan = read_detector()(world, "box")
    assert plan is not None
    assert wrist_is_free(world, around, plan.grasp.point[None, :2], plan.grasp.point[2] - TIP)


def test_no_finger_is_sent_into_the_table() -> None:
    flat = world_of(toy_object("card", (0.1, 0.03, 0.004), (0.1, 0.05)))
    for grasp in read_detector().detect(look(flat, "card")):
        assert grasp.point[2] >= 0.74 + TIP - 1e-9 and grasp.opening >= grasp.width


def test_weights_are_written_and_read(tmp_path: Path) -> None:
    weights = read_detector().weights
    save_weights(weights, tmp_path / "own.safetensors", {"scenes": 0})
    read = read_detector(tmp_path / "own.safetensors").weights
    assert weights.keys() == read.keys()
    assert all(np.array_equal(weights[key], read[key]) for key in weights)


def test_weights_that_cannot_be_used_say_what_to_do(tmp_path: Path) -> None:
    path = tmp_path / "broken.safetensors"

    def refused(content: bytes | None, words: str) -> None:
        read_detector.cache_clear()
        if content is not None:
            path.write_bytes(content)
        with pytest.raises(StorageError, match=words):
            read_detector(path)

    sound = dict(read_detector().weights)
    refused(None, r"grasps\.training")
    refused(PATH.read_bytes()[:1000], "cannot be used")
    refused(b"x" * 2**23, "more than 4194304 bytes")
    save_weights({**sound, "0.bias": np.zeros(3)}, path, {})
    refused(None, "belongs to another network")
    save_weights({**sound, "0.bias": np.full(16, np.nan, np.float32)}, path, {})
    refused(None, "not finite")
    read_detector.cache_clear()
