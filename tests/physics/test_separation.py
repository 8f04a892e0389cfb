import dataclasses

import numpy as np
import pytest
from toy import toy_object, toy_scene

from generator.geometry import inside_margin
from generator.physics.parts import base
from generator.physics.separation import ancestry, least_push, separate
from generator.physics.simulation import Simulation
from generator.scene import Object, Scene

CLEARANCE = 1e-3


def cube(name: str, x: float, y: float = 0.0, *, on: str = "table", **options) -> Object:
    thing = toy_object(name, options.pop("size", (0.05, 0.05, 0.05)), (x, y), **options)
    return dataclasses.replace(thing, placement=dataclasses.replace(thing.placement, on=on))


def shifts(before: Scene, after: Scene) -> np.ndarray:
    pairs = zip(before.objects, after.objects, strict=True)
    return np.array([b.pose.position - a.pose.position for a, b in pairs])


def apart(*things: Object) -> tuple[Scene, np.ndarray]:
    """Separate things that can be; return the scene, and how far each was moved."""
    scene = toy_scene(things)
    made, stuck = separate(scene, CLEARANCE)
    assert not stuck
    return made, shifts(scene, made)


def deepest(scene: Scene) -> float:
    simulation = Simulation(scene)
    simulation.place([o.pose for o in scene.objects])
    deep = simulation.contacts().deepest()
    return max((d for pair, d in deep.items() if pair[0] >= 0), default=0.0)


@pytest.mark.parametrize(
    "other", [cube("b_1", 0.06), cube("b_1", 0.01, on="a_1", top=0.785)], ids=["beside it", "on it"]
)
def test_what_does_not_overlap_or_is_carried_is_not_moved(other: Object) -> None:
    np.testing.assert_array_equal(apart(cube("a_1", 0), other)[1], 0)


@pytest.mark.parametrize("turn", [0.0, 0.3, 2.0])
def test_two_cubes_share_the_least_displacement(turn: float) -> None:
    """Overlapping by 1 cm along x, each moves half a centimetre and half the clearance."""
    along = np.array([np.cos(turn), np.sin(turn)])
    scene, moved = apart(cube("a_1", 0, yaw=turn), cube("b_1", *(0.04 * along), yaw=turn))
    assert deepest(scene) == 0
    np.testing.assert_allclose(moved[0, :2], -0.0055 * along, atol=2e-4)
    np.testing.assert_allclose(moved[1, :2], 0.0055 * along, atol=2e-4)
    np.testing.assert_array_equal(moved[:, 2], 0)


def test_the_push_is_along_the_shorter_way() -> None:
    long = cube("long_1", 0, size=(0.3, 0.04, 0.05))
    other = cube("b_1", 0.05, 0.03, size=(0.05, 0.05, 0.05))
    direction, distance = least_push(long, other, toy_scene(), CLEARANCE)
    np.testing.assert_allclose(direction, [0, 1], atol=1e-9)
    assert distance == pytest.approx(0.015 + CLEARANCE, abs=2e-4)


def test_a_row_is_spread_from_its_middle() -> None:
    scene, moved = apart(*(cube(f"c_{k}", 0.04 * k) for k in range(-2, 3)))
    assert deepest(scene) == 0
    np.testing.assert_allclose(moved[:, 0], [-0.022, -0.011, 0, 0.011, 0.022], atol=1e-3)


def test_a_crowd_comes_apart_on_the_table() -> None:
    rng = np.random.default_rng(0)
    scene, moved = apart(*(
        cube(f"c_{k}", *rng.uniform(-0.15, 0.15, 2), yaw=float(rng.uniform(-3, 3)))
        for k in range(14)
    ))  # fmt: skip
    assert deepest(scene) < 3e-4
    assert np.linalg.norm(moved, axis=1).max() < 0.15


def test_overhang_is_pulled_back_onto_the_table() -> None:
    scene, moved = apart(cube("a_1", 0.59, 0.34), cube("b_1", 0, 0))
    thing = scene.objects[0]
    assert inside_margin(base(thing, thing.pose), scene.table.outline).min() > -1e-5
    np.testing.assert_allclose(moved, [[-0.015, -0.015, 0], [0, 0, 0]], atol=1e-4)
    np.testing.assert_array_equal(moved[1], 0)


def test_pushes_at_the_edge_go_inwards() -> None:
    scene, moved = apart(cube("a_1", 0.575), cube("b_1", 0.54))
    assert deepest(scene) == 0
    assert moved[0, 0] == pytest.approx(0, abs=2e-4)
    assert moved[1, 0] == pytest.approx(-0.016, abs=3e-4)


def test_what_stands_on_a_thing_moves_with_it() -> None:
    rider = cube("rider_1", 0.04, on="low_1", size=(0.02, 0.02, 0.02), top=0.79)
    _, moved = apart(cube("a_1", 0), cube("low_1", 0.04), rider)
    assert moved[1, 0] > 0.004
    np.testing.assert_allclose(moved[2], moved[1], atol=1e-9)


@pytest.mark.slow
def test_where_there_is_no_room_the_names_are_told() -> None:
    big = [cube(f"big_{k}", 0.05 * k, size=(0.7, 0.6, 0.05)) for k in range(5)]
    _, stuck = separate(toy_scene(tuple(big)), CLEARANCE)
    assert len(stuck) >= 2


def test_ancestry_goes_down_to_the_table() -> None:
    things = (cube("c_1", 0, on="b_1"), cube("b_1", 0, on="a_1"), cube("a_1", 0))
    assert ancestry(things) == [(0, 1, 2), (1, 2), (2,)]
