"""Collision parts cover the visual mesh, keep hollows open, and stand on one foot."""

import numpy as np
import pytest
from toy import CUBE_FACES, corners

from generator.physics.cover import TOLERANCE, covering, outside
from generator.physics.parts import body_parts, on_base
from generator.scene import ConvexPart
from tabletop_objects import build

SHARE = 0.02  # of the drawn surface, at most, that may stick out by up to a millimetre


def sticking_out(parts, points: np.ndarray) -> np.ndarray:
    return np.min([outside(part, points) for part in parts], axis=0)


def block(low, high) -> ConvexPart:
    return ConvexPart(corners(low, high))


@pytest.mark.slow
@pytest.mark.parametrize(
    "key", ["mug", "apple", "egg", "bottle", "plate", "bowl", "teapot", "book"]
)
def test_what_is_drawn_lies_within_the_parts(key: str) -> None:
    for seed in range(3):
        model = build(key, seed)
        vertices = model.mesh.vertices.astype(float) * model.size
        out = sticking_out(body_parts(model, model.size), vertices)
        assert np.mean(out > TOLERANCE + 1e-5) <= SHARE
        assert out.max() < 1e-3


def test_things_that_look_alike_share_their_parts() -> None:
    one, same, other = build("egg", 0), build("egg", 0), build("lemon", 0)
    assert one.mesh is not same.mesh
    parts = body_parts(one, one.size)
    assert body_parts(same, same.size) is parts
    assert body_parts(same, 1.1 * same.size) is not parts
    assert body_parts(other, other.size) is not parts


def test_an_exact_part_stays_as_it_is() -> None:
    vertices = corners([-0.05] * 3, [0.05] * 3)
    part = ConvexPart(vertices, "box")
    assert covering((part,), vertices, CUBE_FACES) == (part,)


def test_a_part_grows_by_what_lacks() -> None:
    vertices = corners([-0.05] * 3, [0.05] * 3)
    (grown,) = covering((block([-0.05] * 3, [0.05, 0.05, 0.047]),), vertices, CUBE_FACES)
    np.testing.assert_allclose(grown.bounds, [[-0.05] * 3, [0.05] * 3], atol=1e-6)


def test_a_piece_without_a_part_gets_one() -> None:
    there = corners([-0.05] * 3, [0.05] * 3)
    lid = corners([-0.01, -0.01, 0.08], [0.01, 0.01, 0.12])
    vertices = np.concatenate([there, lid])
    faces = np.concatenate([CUBE_FACES, CUBE_FACES + 8])
    parts = covering((ConvexPart(there, "box"),), vertices, faces)
    assert len(parts) == 2
    assert sticking_out(parts, vertices).max() <= TOLERANCE


@pytest.mark.slow
@pytest.mark.parametrize("size", ["small", "medium", "large"])
@pytest.mark.parametrize("key", ["bowl", "basket", "tray", "desk_tray"])
def test_a_hollow_stays_open(key: str, size: str) -> None:
    for seed in range(3):
        model = build(key, seed, attributes={"size": size})
        ways = np.linspace(0, 2 * np.pi, 12, endpoint=False)
        ring = 0.15 * np.column_stack([np.cos(ways), np.sin(ways)])
        inside = np.array([[*xy, z] for xy in ring for z in (-0.2, 0.0, 0.2, 0.4)]) * model.size
        assert (sticking_out(body_parts(model, model.size), inside) > 0).all()


def test_walls_beside_a_wide_bottom_do_not_touch_the_table() -> None:
    bottom = block([-0.04, -0.04, 0], [0.04, 0.04, 0.005])
    wall = block([0.03, -0.04, 0], [0.04, 0.04, 0.08])
    legs = [block([x, -0.01, 0], [x + 0.01, 0.01, 0.05]) for x in (-0.05, 0.05)]
    first, raised = on_base((bottom, wall))
    assert first is bottom
    assert 0 < raised.bounds[0, 2] < 5e-4
    assert [part.bounds[0, 2] for part in on_base(legs)] == [0.0, 0.0]


@pytest.mark.parametrize("key", ["open_jar", "pitcher", "empty_vase"])
@pytest.mark.parametrize("seed", [0, 1])
def test_no_hull_closes_what_is_hollow(key: str, seed: int) -> None:
    model = build(key, seed)
    axis = np.zeros((20, 3))
    axis[:, 2] = np.linspace(-0.3, 0.49, 20) * model.size[2]
    for part in body_parts(model, model.size):
        assert (outside(part, axis) > 0).all()
